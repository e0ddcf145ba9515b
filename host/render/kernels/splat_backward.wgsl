struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_10;
@group(0) @binding(3) 
var<storage> global_6: type_10;
@group(0) @binding(4) 
var<storage> global_7: type_10;
@group(0) @binding(7) 
var<storage> global_8: type_16;
@group(0) @binding(5) 
var<storage> global_9: type_20;
@group(0) @binding(6) 
var<storage> global_10: type_20;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_16;

fn function_() {
    var phi_104_: vec4<f32>;
    var phi_107_: vec4<f32>;
    var phi_109_: vec4<f32>;
    var phi_111_: u32;
    var phi_105_: vec4<f32>;
    var phi_108_: vec4<f32>;
    var phi_110_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = global;
            let _e24 = global_1;
            let _e25 = global_2;
            let _e33 = (((_e24.x + (_e24.y * _e25.x)) * 64u) + _e23.x);
            let _e36 = global_3.member.member;
            if (_e33 < _e36) {
                let _e40 = global_4.member[_e33];
                let _e43 = global_3.member.member_1;
                let _e44 = (_e43 == 0u);
                if _e44 {
                    break;
                }
                let _e45 = (_e40 / _e43);
                if _e44 {
                    break;
                }
                let _e46 = (_e40 % _e43);
                let _e51 = (1u << bitcast<u32>(((_e46 % 32u) & 31u)));
                let _e55 = global_5.member[(_e45 + 1u)];
                let _e58 = global_5.member[_e45];
                phi_104_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_107_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_109_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_111_ = _e58;
                loop {
                    let _e60 = phi_104_;
                    let _e62 = phi_107_;
                    let _e64 = phi_109_;
                    let _e66 = phi_111_;
                    local = _e64;
                    local_1 = _e64;
                    local_2 = _e64;
                    local_3 = _e62;
                    local_4 = _e60;
                    if (_e66 < _e55) {
                        let _e70 = global_3.member.member_2;
                        let _e72 = ((_e66 * _e70) + (_e46 / 32u));
                        let _e75 = global_6.member[_e72];
                        if ((_e75 & _e51) == 0u) {
                            phi_105_ = _e60;
                            phi_108_ = _e62;
                            phi_110_ = _e64;
                        } else {
                            let _e83 = global_7.member[_e72];
                            let _e85 = (3u * (_e83 + countOneBits((_e75 & (_e51 - 1u)))));
                            let _e88 = global_8.member[_e85];
                            let _e93 = global_8.member[(_e85 + 1u)];
                            let _e98 = global_8.member[(_e85 + 2u)];
                            phi_105_ = (_e60 + _e98);
                            phi_108_ = (_e62 + _e93);
                            phi_110_ = (_e64 + _e88);
                        }
                        let _e101 = phi_105_;
                        let _e103 = phi_108_;
                        let _e105 = phi_110_;
                        local_5 = _e101;
                        local_6 = _e103;
                        local_7 = _e105;
                        local_8 = (_e66 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e157 = local_5;
                        phi_104_ = _e157;
                        let _e160 = local_6;
                        phi_107_ = _e160;
                        let _e163 = local_7;
                        phi_109_ = _e163;
                        let _e166 = local_8;
                        phi_111_ = _e166;
                    }
                }
                let _e109 = global_9.member[_e46];
                let _e111 = local;
                let _e113 = (_e109 < 0f);
                let _e114 = -(_e109);
                let _e116 = exp(select(_e114, _e109, _e113));
                let _e118 = (1f / (1f + _e116));
                let _e121 = (_e111.z * select(_e118, (_e116 * _e118), _e113));
                let _e124 = global_10.member[_e33];
                let _e126 = (_e114 < 0f);
                let _e129 = exp(select(-(_e114), _e114, _e126));
                let _e131 = (1f / (1f + _e129));
                let _e135 = (3u * _e33);
                let _e137 = local_1;
                let _e140 = local_2;
                global_11.member[_e135] = vec4<f32>(_e137.x, _e140.y, ((_e121 * _e124) * select(_e131, (_e129 * _e131), _e126)), _e121);
                let _e149 = local_3;
                global_11.member[(_e135 + 1u)] = _e149;
                let _e154 = local_4;
                global_11.member[(_e135 + 2u)] = _e154;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn splat_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
