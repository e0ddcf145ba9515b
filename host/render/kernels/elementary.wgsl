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
    let _e42 = global;
    let _e43 = global_1;
    let _e44 = global_2;
    let _e52 = (((_e43.x + (_e43.y * _e44.x)) * 64u) + _e42.x);
    let _e55 = global_3.member.member;
    if (_e52 < _e55) {
        let _e59 = global_4.member[_e52];
        let _e62 = global_5.member[_e52];
        let _e65 = global_6.member[_e52];
        let _e66 = (_e59 * 0.63661975f);
        let _e67 = trunc(_e66);
        let _e68 = (_e66 - _e67);
        let _e72 = -(0.5f);
        let _e75 = select(select(_e67, (_e67 + 1f), (0.5f <= _e68)), (_e67 - 1f), (_e68 <= _e72));
        let _e81 = (((_e59 - (_e75 * 1.5703125f)) - (_e75 * 0.0004837513f)) - (_e75 * 0.0000000754979f));
        let _e83 = (_e81 * _e81);
        let _e90 = (((((((-0.00019515296f * _e83) + 0.008332161f) * _e83) - 0.16666655f) * _e83) * _e81) + _e81);
        let _e99 = ((((((((0.000024433157f * _e83) - 0.0013887316f) * _e83) + 0.041666646f) * _e83) * _e83) - (0.5f * _e83)) + 1f);
        let _e100 = ((_e75 + 0f) * 0.5f);
        let _e101 = trunc(_e100);
        let _e107 = (_e100 * 0.5f);
        let _e108 = trunc(_e107);
        let _e114 = select(_e90, _e99, (0.25f < (_e100 - select(_e101, (_e101 - 1f), (_e100 < _e101)))));
        let _e116 = select(_e114, -(_e114), (0.5f <= (_e107 - select(_e108, (_e108 - 1f), (_e107 < _e108)))));
        global_7.member[_e52] = _e116;
        let _e121 = ((_e75 + 1f) * 0.5f);
        let _e122 = trunc(_e121);
        let _e128 = (_e121 * 0.5f);
        let _e129 = trunc(_e128);
        let _e135 = select(_e90, _e99, (0.25f < (_e121 - select(_e122, (_e122 - 1f), (_e121 < _e122)))));
        let _e137 = select(_e135, -(_e135), (0.5f <= (_e128 - select(_e129, (_e129 - 1f), (_e128 < _e129)))));
        global_7.member[(_e55 + _e52)] = _e137;
        global_7.member[((2u * _e55) + _e52)] = (_e116 / _e137);
        let _e148 = (bitcast<u32>(_e65) - 1060439283u);
        let _e152 = f32((bitcast<i32>(_e148) >> bitcast<u32>(23i)));
        let _e155 = bitcast<f32>(((_e148 & 8388607u) + 1060439283u));
        let _e158 = ((_e155 - 1f) / (_e155 + 1f));
        let _e159 = (_e158 * _e158);
        let _e172 = (2f * _e158);
        let _e177 = ((_e152 * 0.6933594f) + (_e172 + ((_e172 * (_e159 * ((1f / 3f) + (_e159 * ((1f / 5f) + (_e159 * ((1f / 7f) + (_e159 * (1f / 9f))))))))) - (_e152 * 0.00021219444f))));
        global_7.member[((3u * _e55) + _e52)] = _e177;
        global_7.member[((4u * _e55) + _e52)] = exp((_e62 * _e177));
        let _e188 = trunc(_e59);
        let _e190 = (_e188 - 1f);
        global_7.member[((5u * _e55) + _e52)] = select(_e188, _e190, (_e59 < _e188));
        let _e196 = (_e59 - _e188);
        global_7.member[((6u * _e55) + _e52)] = select(select(_e188, (_e188 + 1f), (0.5f <= _e196)), _e190, (_e196 <= _e72));
        global_7.member[((7u * _e55) + _e52)] = abs(_e59);
        let _e212 = select(0f, _e59, (_e59 > 0f));
        global_7.member[((8u * _e55) + _e52)] = select(1f, _e212, (_e212 < 1f));
        global_7.member[((9u * _e55) + _e52)] = (_e59 + (_e65 * (_e62 - _e59)));
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
