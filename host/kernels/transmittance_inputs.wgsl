struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_20 {
    member: type_19,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_20;
@group(0) @binding(1) 
var<storage> global_4: type_16;
@group(0) @binding(2) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage> global_6: type_6;
@group(0) @binding(4) 
var<storage> global_7: type_9;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_9;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_9;

fn function_() {
    var phi_123_: u32;
    var phi_126_: u32;
    var phi_124_: u32;
    var phi_127_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_216_: u32;
    var phi_217_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = global;
            let _e29 = global_1;
            let _e30 = global_2;
            let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
            let _e41 = global_3.member.member;
            if (_e38 < _e41) {
                let _e45 = global_3.member.member_1;
                let _e46 = (_e45 + _e38);
                let _e49 = global_3.member.member_3;
                phi_123_ = _e49;
                phi_126_ = 0u;
                loop {
                    let _e51 = phi_123_;
                    let _e53 = phi_126_;
                    local = _e53;
                    local_2 = _e53;
                    local_3 = _e53;
                    let _e54 = (_e53 + 1u);
                    let _e55 = (_e54 < _e51);
                    local_1 = _e54;
                    if _e55 {
                        let _e57 = ((_e53 + _e51) / 2u);
                        let _e60 = global_5.member[_e57];
                        let _e61 = (_e60 <= _e46);
                        phi_124_ = select(_e57, _e51, _e61);
                        phi_127_ = select(_e53, _e57, _e61);
                    } else {
                        phi_124_ = u32();
                        phi_127_ = u32();
                    }
                    let _e65 = phi_124_;
                    let _e67 = phi_127_;
                    continue;
                    continuing {
                        phi_123_ = _e65;
                        phi_126_ = _e67;
                        break if !(_e55);
                    }
                }
                let _e71 = local;
                let _e73 = global_5.member[_e71];
                let _e76 = local_1;
                let _e78 = global_5.member[_e76];
                let _e81 = local_2;
                let _e82 = (_e81 * 4u);
                let _e85 = global_6.member[_e82];
                let _e89 = global_6.member[(_e82 + 1u)];
                let _e93 = global_6.member[(_e82 + 2u)];
                let _e97 = global_6.member[(_e82 + 3u)];
                let _e113 = (f32((_e46 - _e73)) + 0.5f);
                let _e114 = f32((_e78 - _e73));
                let _e115 = (_e113 / _e114);
                let _e117 = select(0f, _e115, (_e115 > 0f));
                let _e119 = select(1f, _e117, (_e117 < 1f));
                let _e122 = (trunc((_e119 * 1024f)) * 0.0009765625f);
                let _e129 = select(0f, ((_e113 - (_e122 * _e114)) / _e114), select(false, (_e119 < 1f), (0f < _e119)));
                let _e134 = (_e93.x + ((_e122 * _e97.x) + (_e129 * (_e89.x + _e97.x))));
                let _e136 = (_e85.x + (_e122 * _e89.x));
                let _e140 = (trunc(((_e136 + _e134) * 4096f)) * 0.00024414063f);
                let _e147 = (_e93.y + ((_e122 * _e97.y) + (_e129 * (_e89.y + _e97.y))));
                let _e149 = (_e85.y + (_e122 * _e89.y));
                let _e153 = (trunc(((_e149 + _e147) * 4096f)) * 0.00024414063f);
                let _e160 = (_e93.z + ((_e122 * _e97.z) + (_e129 * (_e89.z + _e97.z))));
                let _e162 = (_e85.z + (_e122 * _e89.z));
                let _e166 = (trunc(((_e162 + _e160) * 4096f)) * 0.00024414063f);
                let _e171 = global_3.member.member_2;
                global_8.member[_e38] = _e140;
                global_8.member[(_e171 + _e38)] = _e153;
                global_8.member[((2u * _e171) + _e38)] = _e166;
                global_8.member[((3u * _e171) + _e38)] = ((_e136 - _e140) + _e134);
                global_8.member[((4u * _e171) + _e38)] = ((_e149 - _e153) + _e147);
                global_8.member[((5u * _e171) + _e38)] = ((_e162 - _e166) + _e160);
                global_8.member[((6u * _e171) + _e38)] = _e85.w;
                let _e199 = local_3;
                let _e201 = global_4.member[_e199];
                let _e204 = global_3.member.member_4;
                if (_e204 == 0u) {
                    break;
                }
                phi_216_ = 0u;
                loop {
                    let _e208 = phi_216_;
                    let _e211 = global_3.member.member_5;
                    let _e212 = (_e208 < _e211);
                    if _e212 {
                        let _e217 = global_7.member[(((_e201 % _e204) * _e211) + _e208)];
                        let _e220 = global_3.member.member_6;
                        global_9.member[(((_e220 + _e208) * _e171) + _e38)] = _e217;
                        phi_217_ = (_e208 + 1u);
                    } else {
                        phi_217_ = u32();
                    }
                    let _e228 = phi_217_;
                    continue;
                    continuing {
                        phi_216_ = _e228;
                        break if !(_e212);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_inputs(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
