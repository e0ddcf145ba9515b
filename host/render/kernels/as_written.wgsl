struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_15 {
    member: array<u32>,
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
var<storage, read_write> global_6: type_15;

fn function_() {
    var phi_207_: bool;

    let _e29 = global;
    let _e30 = global_1;
    let _e31 = global_2;
    let _e39 = (((_e30.x + (_e30.y * _e31.x)) * 64u) + _e29.x);
    let _e42 = global_3.member.member;
    if (_e39 < _e42) {
        let _e46 = global_4.member[_e39];
        let _e49 = global_5.member[_e39];
        global_6.member[_e39] = bitcast<u32>(((_e46 + 12582912f) - 12582912f));
        let _e55 = (_e39 + _e42);
        let _e56 = (_e46 - _e49);
        global_6.member[_e55] = bitcast<u32>((_e56 + _e49));
        let _e61 = (_e55 + _e42);
        global_6.member[_e61] = bitcast<u32>(((_e46 + _e49) - _e49));
        let _e67 = (_e61 + _e42);
        global_6.member[_e67] = bitcast<u32>((_e46 - _e56));
        let _e72 = (_e67 + _e42);
        global_6.member[_e72] = bitcast<u32>(((_e46 / _e49) * _e49));
        let _e78 = (_e72 + _e42);
        global_6.member[_e78] = bitcast<u32>(((_e46 * 0.000000000000000000000000000001f) * 0.000000000000000000000000000001f));
        let _e84 = (_e78 + _e42);
        global_6.member[_e84] = bitcast<u32>(((_e46 * 0.1f) * 3f));
        let _e90 = (_e84 + _e42);
        global_6.member[_e90] = bitcast<u32>(((_e46 + 0.1f) + 0.2f));
        let _e96 = (_e90 + _e42);
        global_6.member[_e96] = bitcast<u32>(((0.1f - _e46) - 0.2f));
        let _e102 = (_e96 + _e42);
        let _e103 = bitcast<u32>(_e46);
        global_6.member[_e102] = bitcast<u32>(bitcast<f32>(select(2143289344u, (_e103 & 2147483648u), ((_e103 & 2147483647u) < 2139095040u))));
        let _e112 = (_e102 + _e42);
        let _e113 = bitcast<u32>(_e46);
        global_6.member[_e112] = bitcast<u32>(bitcast<f32>(select(2143289344u, (_e113 & 2147483648u), (((_e113 & 2147483647u) - 1u) < 2139095040u))));
        let _e123 = (_e112 + _e42);
        global_6.member[_e123] = bitcast<u32>((_e46 - _e46));
        let _e128 = (_e123 + _e42);
        global_6.member[_e128] = bitcast<u32>((_e46 / _e46));
        let _e133 = (_e128 + _e42);
        global_6.member[_e133] = bitcast<u32>((_e46 + 0f));
        let _e138 = (_e133 + _e42);
        global_6.member[_e138] = bitcast<u32>((0f - _e46));
        let _e143 = (_e138 + _e42);
        global_6.member[_e143] = bitcast<u32>(-(_e56));
        let _e148 = (_e143 + _e42);
        global_6.member[_e148] = bitcast<u32>(((_e46 * 2f) * 0.5f));
        let _e154 = (_e148 + _e42);
        global_6.member[_e154] = bitcast<u32>(((_e46 * _e49) + (_e46 * 0.3f)));
        let _e161 = (_e154 + _e42);
        global_6.member[_e161] = bitcast<u32>(((_e46 / 3f) / 7f));
        let _e167 = (_e161 + _e42);
        global_6.member[_e167] = bitcast<u32>((3f / (7f / _e46)));
        let _e173 = (_e167 + _e42);
        let _e175 = bitcast<u32>((_e49 - _e46));
        global_6.member[_e173] = bitcast<u32>((_e46 + bitcast<f32>(select(2143289344u, (_e175 & 2147483648u), ((_e175 & 2147483647u) < 2139095040u)))));
        let _e185 = (_e173 + _e42);
        global_6.member[_e185] = bitcast<u32>(((_e49 * 0.1f) * 3f));
        let _e191 = (_e185 + _e42);
        global_6.member[_e191] = bitcast<u32>(((_e49 + 0.1f) - 0.1f));
        let _e198 = (_e46 * 0.7f);
        if ((bitcast<u32>(_e198) & 2147483647u) > 2139095040u) {
            phi_207_ = true;
        } else {
            phi_207_ = (1f <= _e198);
        }
        let _e204 = phi_207_;
        global_6.member[(_e191 + _e42)] = bitcast<u32>((select(_e198, 1f, _e204) * (1f / 0.7f)));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn as_written(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
