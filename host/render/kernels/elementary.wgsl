struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_11;

fn function_() {
    let _e43 = global;
    let _e44 = global_1;
    let _e45 = global_2;
    let _e53 = (((_e44.x + (_e44.y * _e45.x)) * 64u) + _e43.x);
    let _e56 = global_3.member.member;
    if (_e53 < _e56) {
        let _e60 = global_4.member[_e53];
        let _e63 = global_5.member[_e53];
        let _e66 = global_6.member[_e53];
        let _e67 = (_e60 * 0.63661975f);
        let _e68 = trunc(_e67);
        let _e69 = (_e67 - _e68);
        let _e75 = select(select(_e68, (_e68 + 1f), (0.5f <= _e69)), (_e68 - 1f), (_e69 <= -0.5f));
        let _e81 = (((_e60 - (_e75 * 1.5703125f)) - (_e75 * 0.0004837513f)) - (_e75 * 0.0000000754979f));
        let _e82 = (_e81 * _e81);
        let _e89 = (((((((-0.00019515296f * _e82) + 0.008332161f) * _e82) - 0.16666655f) * _e82) * _e81) + _e81);
        let _e98 = ((((((((0.000024433157f * _e82) - 0.0013887316f) * _e82) + 0.041666646f) * _e82) * _e82) - (0.5f * _e82)) + 1f);
        let _e99 = (_e75 * 0.5f);
        let _e100 = trunc(_e99);
        let _e106 = (_e75 * 0.25f);
        let _e107 = trunc(_e106);
        let _e113 = select(_e89, _e98, (0.25f < (_e99 - select(_e100, (_e100 - 1f), (_e99 < _e100)))));
        let _e115 = select(_e113, -(_e113), (0.5f <= (_e106 - select(_e107, (_e107 - 1f), (_e106 < _e107)))));
        global_7.member[_e53] = _e115;
        let _e119 = (_e75 + 1f);
        let _e120 = (_e119 * 0.5f);
        let _e121 = trunc(_e120);
        let _e127 = (_e119 * 0.25f);
        let _e128 = trunc(_e127);
        let _e134 = select(_e89, _e98, (0.25f < (_e120 - select(_e121, (_e121 - 1f), (_e120 < _e121)))));
        let _e136 = select(_e134, -(_e134), (0.5f <= (_e127 - select(_e128, (_e128 - 1f), (_e127 < _e128)))));
        global_7.member[(_e56 + _e53)] = _e136;
        global_7.member[((2u * _e56) + _e53)] = (_e115 / _e136);
        let _e147 = (bitcast<u32>(_e66) - 1060439283u);
        let _e151 = f32((bitcast<i32>(_e147) >> bitcast<u32>(23i)));
        let _e154 = bitcast<f32>(((_e147 & 8388607u) + 1060439283u));
        let _e157 = ((_e154 - 1f) / (_e154 + 1f));
        let _e158 = (_e157 * _e157);
        let _e167 = (2f * _e157);
        let _e172 = ((_e151 * 0.6933594f) + (_e167 + ((_e167 * (_e158 * (0.33333334f + (_e158 * (0.2f + (_e158 * (0.14285715f + (_e158 * 0.11111111f)))))))) - (_e151 * 0.00021219444f))));
        global_7.member[((3u * _e56) + _e53)] = _e172;
        global_7.member[((4u * _e56) + _e53)] = exp((_e63 * _e172));
        let _e183 = trunc(_e60);
        let _e185 = (_e183 - 1f);
        global_7.member[((5u * _e56) + _e53)] = select(_e183, _e185, (_e60 < _e183));
        let _e191 = (_e60 - _e183);
        global_7.member[((6u * _e56) + _e53)] = select(select(_e183, (_e183 + 1f), (0.5f <= _e191)), _e185, (_e191 <= -0.5f));
        global_7.member[((7u * _e56) + _e53)] = abs(_e60);
        let _e207 = select(0f, _e60, (_e60 > 0f));
        global_7.member[((8u * _e56) + _e53)] = select(1f, _e207, (_e207 < 1f));
        global_7.member[((9u * _e56) + _e53)] = (_e60 + (_e66 * (_e63 - _e60)));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn elementary(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
