struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_16;
@group(0) @binding(2) 
var<storage> global_6: type_16;
@group(0) @binding(3) 
var<storage> global_7: type_11;

fn function_() {
    var phi_66_: u32;
    var phi_108_: vec4<f32>;
    var phi_116_: vec4<f32>;
    var phi_124_: vec4<f32>;
    var phi_126_: u32;
    var phi_129_: vec4<f32>;
    var phi_131_: u32;
    var phi_168_: vec4<f32>;
    var phi_177_: vec4<f32>;
    var phi_186_: vec4<f32>;
    var phi_130_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: u32;
    var local_5: vec4<f32>;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = global;
            let _e19 = global_1;
            let _e20 = global_2;
            let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
            let _e31 = global_3.member.member_4;
            let _e32 = (_e31 / 4u);
            if ((_e31 % 4u) > 0u) {
                phi_66_ = (_e32 + 1u);
            } else {
                phi_66_ = _e32;
            }
            let _e37 = phi_66_;
            let _e40 = global_3.member.member_3;
            if (_e28 < (_e40 * _e37)) {
                let _e43 = (_e37 == 0u);
                if _e43 {
                    break;
                }
                let _e44 = (_e28 / _e37);
                if _e43 {
                    break;
                }
                let _e46 = ((_e28 % _e37) * 4u);
                let _e48 = ((_e46 + 1u) < _e31);
                let _e50 = ((_e46 + 2u) < _e31);
                let _e52 = ((_e46 + 3u) < _e31);
                let _e56 = global_3.member.member_1;
                let _e59 = global_3.member.member;
                let _e64 = ((_e44 * _e31) + _e46);
                let _e67 = global_4.member[_e64];
                if _e48 {
                    let _e72 = global_4.member[(_e64 + 1u)];
                    phi_108_ = vec4<f32>(_e67, _e72, 0f, 0f);
                } else {
                    phi_108_ = vec4<f32>(_e67, 0f, 0f, 0f);
                }
                let _e75 = phi_108_;
                if _e50 {
                    let _e79 = global_4.member[(_e64 + 2u)];
                    phi_116_ = vec4<f32>(_e75.x, _e75.y, _e79, _e75.w);
                } else {
                    phi_116_ = _e75;
                }
                let _e86 = phi_116_;
                if _e52 {
                    let _e90 = global_4.member[(_e64 + 3u)];
                    phi_124_ = vec4<f32>(_e86.x, _e86.y, _e86.z, _e90);
                } else {
                    phi_124_ = _e86;
                }
                let _e97 = phi_124_;
                phi_126_ = 0u;
                phi_129_ = _e97;
                phi_131_ = ((_e56 * _e59) + (_e44 / 32u));
                loop {
                    let _e99 = phi_126_;
                    let _e101 = phi_129_;
                    let _e103 = phi_131_;
                    let _e106 = global_3.member.member_2;
                    local = _e101;
                    local_1 = _e101;
                    local_2 = _e101;
                    local_3 = _e101;
                    if (_e99 < _e106) {
                        let _e110 = global_5.member[_e103];
                        let _e111 = ((_e44 % 32u) & 31u);
                        if (((_e110 >> bitcast<u32>(_e111)) & 1u) == 0u) {
                            phi_130_ = _e101;
                        } else {
                            let _e118 = global_6.member[_e103];
                            let _e126 = (((_e118 + countOneBits((_e110 & ((1u << bitcast<u32>(_e111)) - 1u)))) * _e31) + _e46);
                            let _e129 = global_7.member[_e126];
                            let _e136 = vec4<f32>((_e101.x + _e129), _e101.y, _e101.z, _e101.w);
                            if _e48 {
                                let _e140 = global_7.member[(_e126 + 1u)];
                                phi_168_ = vec4<f32>(_e136.x, (_e101.y + _e140), _e136.z, _e136.w);
                            } else {
                                phi_168_ = _e136;
                            }
                            let _e149 = phi_168_;
                            if _e50 {
                                let _e153 = global_7.member[(_e126 + 2u)];
                                phi_177_ = vec4<f32>(_e149.x, _e149.y, (_e149.z + _e153), _e149.w);
                            } else {
                                phi_177_ = _e149;
                            }
                            let _e162 = phi_177_;
                            if _e52 {
                                let _e166 = global_7.member[(_e126 + 3u)];
                                phi_186_ = vec4<f32>(_e162.x, _e162.y, _e162.z, (_e162.w + _e166));
                            } else {
                                phi_186_ = _e162;
                            }
                            let _e175 = phi_186_;
                            phi_130_ = _e175;
                        }
                        let _e177 = phi_130_;
                        local_4 = (_e99 + 1u);
                        local_5 = _e177;
                        local_6 = (_e103 + _e59);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e207 = local_4;
                        phi_126_ = _e207;
                        let _e210 = local_5;
                        phi_129_ = _e210;
                        let _e213 = local_6;
                        phi_131_ = _e213;
                    }
                }
                let _e181 = local;
                global_4.member[_e64] = _e181.x;
                if _e48 {
                    let _e185 = local_1;
                    global_4.member[(_e64 + 1u)] = _e185.y;
                }
                if _e50 {
                    let _e191 = local_2;
                    global_4.member[(_e64 + 2u)] = _e191.z;
                }
                if _e52 {
                    let _e197 = local_3;
                    global_4.member[(_e64 + 3u)] = _e197.w;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
