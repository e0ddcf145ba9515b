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
    var phi_186_: bool;

    let _e24 = global;
    let _e25 = global_1;
    let _e26 = global_2;
    let _e34 = (((_e25.x + (_e25.y * _e26.x)) * 64u) + _e24.x);
    let _e37 = global_3.member.member;
    if (_e34 < _e37) {
        let _e41 = global_4.member[_e34];
        let _e44 = global_5.member[_e34];
        global_6.member[_e34] = bitcast<u32>(((_e41 + 12582912f) - 12582912f));
        let _e50 = (_e34 + _e37);
        let _e51 = (_e41 - _e44);
        global_6.member[_e50] = bitcast<u32>((_e51 + _e44));
        let _e56 = (_e50 + _e37);
        global_6.member[_e56] = bitcast<u32>(((_e41 + _e44) - _e44));
        let _e62 = (_e56 + _e37);
        global_6.member[_e62] = bitcast<u32>((_e41 - _e51));
        let _e67 = (_e62 + _e37);
        global_6.member[_e67] = bitcast<u32>(((_e41 / _e44) * _e44));
        let _e73 = (_e67 + _e37);
        global_6.member[_e73] = bitcast<u32>(((_e41 * 0.000000000000000000000000000001f) * 0.000000000000000000000000000001f));
        let _e79 = (_e73 + _e37);
        global_6.member[_e79] = bitcast<u32>(((_e41 * 0.1f) * 3f));
        let _e85 = (_e79 + _e37);
        global_6.member[_e85] = bitcast<u32>(((_e41 + 0.1f) + 0.2f));
        let _e91 = (_e85 + _e37);
        global_6.member[_e91] = bitcast<u32>(((0.1f - _e41) - 0.2f));
        let _e97 = (_e91 + _e37);
        global_6.member[_e97] = bitcast<u32>((_e41 * 0f));
        let _e102 = (_e97 + _e37);
        global_6.member[_e102] = bitcast<u32>((0f / _e41));
        let _e107 = (_e102 + _e37);
        global_6.member[_e107] = bitcast<u32>((_e41 - _e41));
        let _e112 = (_e107 + _e37);
        global_6.member[_e112] = bitcast<u32>((_e41 / _e41));
        let _e117 = (_e112 + _e37);
        global_6.member[_e117] = bitcast<u32>((_e41 + 0f));
        let _e122 = (_e117 + _e37);
        global_6.member[_e122] = bitcast<u32>((0f - _e41));
        let _e127 = (_e122 + _e37);
        global_6.member[_e127] = bitcast<u32>(-(_e51));
        let _e132 = (_e127 + _e37);
        global_6.member[_e132] = bitcast<u32>(((_e41 * 2f) * 0.5f));
        let _e138 = (_e132 + _e37);
        global_6.member[_e138] = bitcast<u32>(((_e41 * _e44) + (_e41 * 0.3f)));
        let _e145 = (_e138 + _e37);
        global_6.member[_e145] = bitcast<u32>(((_e41 / 3f) / 7f));
        let _e151 = (_e145 + _e37);
        global_6.member[_e151] = bitcast<u32>((3f / (7f / _e41)));
        let _e157 = (_e151 + _e37);
        global_6.member[_e157] = bitcast<u32>((_e41 + (0f * (_e44 - _e41))));
        let _e164 = (_e157 + _e37);
        global_6.member[_e164] = bitcast<u32>(((_e44 * 0.1f) * 3f));
        let _e170 = (_e164 + _e37);
        global_6.member[_e170] = bitcast<u32>(((_e44 + 0.1f) - 0.1f));
        let _e177 = (_e41 * 0.7f);
        if ((bitcast<u32>(_e177) & 2147483647u) > 2139095040u) {
            phi_186_ = true;
        } else {
            phi_186_ = (1f <= _e177);
        }
        let _e183 = phi_186_;
        global_6.member[(_e170 + _e37)] = bitcast<u32>((select(_e177, 1f, _e183) * (1f / 0.7f)));
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
