struct type_7 {
    member: array<u32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_16 {
    member: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_7;
@group(0) @binding(2) 
var<storage> global_5: type_12;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_12;

fn function_() {
    var phi_75_: u32;
    var phi_78_: u32;
    var phi_76_: u32;
    var phi_79_: u32;
    var local: u32;
    var phi_108_: u32;
    var phi_111_: u32;
    var phi_109_: u32;
    var phi_112_: u32;
    var phi_130_: bool;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_169_: u32;
    var phi_175_: vec4<f32>;
    var phi_178_: u32;
    var phi_176_: vec4<f32>;
    var phi_179_: u32;
    var phi_197_: bool;
    var local_1: vec4<f32>;
    var phi_199_: bool;
    var phi_200_: u32;
    var phi_201_: u32;
    var phi_131_: bool;
    var phi_134_: u32;
    var phi_136_: u32;
    var phi_202_: bool;
    var phi_203_: bool;
    var local_2: u32;
    var local_3: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = global;
            let _e20 = global_1;
            let _e21 = global_2;
            let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
            let _e32 = global_3.member.member;
            if (_e29 < _e32) {
                let _e36 = global_3.member.member_2;
                if (_e36 > 0u) {
                    let _e40 = global_3.member.member_1;
                    let _e41 = (_e40 + _e36);
                    let _e44 = global_3.member.member_3;
                    let _e47 = global_3.member.member_4;
                    phi_75_ = 0u;
                    phi_78_ = _e44;
                    loop {
                        let _e49 = phi_75_;
                        let _e51 = phi_78_;
                        local = _e49;
                        let _e53 = ((_e49 + 1u) < _e51);
                        if _e53 {
                            let _e55 = ((_e49 + _e51) / 2u);
                            let _e59 = global_4.member[(2u * _e55)];
                            let _e60 = (_e59 <= _e40);
                            phi_76_ = select(_e49, _e55, _e60);
                            phi_79_ = select(_e55, _e51, _e60);
                        } else {
                            phi_76_ = u32();
                            phi_79_ = u32();
                        }
                        let _e64 = phi_76_;
                        let _e66 = phi_79_;
                        continue;
                        continuing {
                            phi_75_ = _e64;
                            phi_78_ = _e66;
                            break if !(_e53);
                        }
                    }
                    let _e69 = local;
                    let _e70 = (2u * _e69);
                    let _e74 = global_4.member[(_e70 + 1u)];
                    let _e77 = global_4.member[_e70];
                    let _e79 = (_e47 == 0u);
                    if _e79 {
                        break;
                    }
                    let _e81 = (_e74 + ((_e40 - _e77) / _e47));
                    phi_108_ = 0u;
                    phi_111_ = _e44;
                    loop {
                        let _e83 = phi_108_;
                        let _e85 = phi_111_;
                        local_2 = _e83;
                        let _e87 = ((_e83 + 1u) < _e85);
                        if _e87 {
                            let _e89 = ((_e83 + _e85) / 2u);
                            let _e94 = global_4.member[((2u * _e89) + 1u)];
                            let _e95 = (_e94 <= _e81);
                            phi_109_ = select(_e83, _e89, _e95);
                            phi_112_ = select(_e89, _e85, _e95);
                        } else {
                            phi_109_ = u32();
                            phi_112_ = u32();
                        }
                        let _e99 = phi_109_;
                        let _e101 = phi_112_;
                        continue;
                        continuing {
                            phi_108_ = _e99;
                            phi_111_ = _e101;
                            break if !(_e87);
                        }
                    }
                    phi_130_ = false;
                    let _e194 = local_2;
                    phi_133_ = _e194;
                    phi_135_ = _e81;
                    loop {
                        let _e104 = phi_130_;
                        let _e106 = phi_133_;
                        let _e108 = phi_135_;
                        if (_e106 < _e44) {
                            let _e110 = (2u * _e106);
                            let _e113 = global_4.member[_e110];
                            let _e114 = (_e113 < _e41);
                            if _e114 {
                                let _e115 = (_e106 + 1u);
                                let _e116 = (2u * _e115);
                                let _e119 = global_4.member[_e116];
                                let _e124 = global_4.member[(_e110 + 1u)];
                                if _e79 {
                                    phi_203_ = true;
                                    break;
                                }
                                if (_e119 <= _e41) {
                                    let _e131 = global_4.member[(_e116 + 1u)];
                                    phi_169_ = _e131;
                                } else {
                                    phi_169_ = (_e124 + ((_e41 - _e113) / _e47));
                                }
                                let _e133 = phi_169_;
                                let _e138 = global_6.member[((_e106 * _e32) + _e29)];
                                phi_175_ = _e138;
                                phi_178_ = _e108;
                                loop {
                                    let _e140 = phi_175_;
                                    let _e142 = phi_178_;
                                    local_1 = _e140;
                                    local_3 = _e142;
                                    let _e143 = (_e142 < _e133);
                                    if _e143 {
                                        let _e146 = global_3.member.member_5;
                                        if (_e146 == 0u) {
                                            phi_197_ = true;
                                            break;
                                        }
                                        let _e153 = global_5.member[(((_e142 % _e146) * _e32) + _e29)];
                                        phi_176_ = (_e140 + _e153);
                                        phi_179_ = (_e142 + 1u);
                                    } else {
                                        phi_176_ = vec4<f32>();
                                        phi_179_ = u32();
                                    }
                                    let _e157 = phi_176_;
                                    let _e159 = phi_179_;
                                    continue;
                                    continuing {
                                        phi_175_ = _e157;
                                        phi_178_ = _e159;
                                        phi_197_ = _e104;
                                        break if !(_e143);
                                    }
                                }
                                let _e162 = phi_197_;
                                phi_203_ = _e162;
                                if _e162 {
                                    break;
                                }
                                let _e164 = local_1;
                                global_6.member[((_e106 * _e32) + _e29)] = _e164;
                                phi_199_ = _e162;
                                phi_200_ = _e115;
                                let _e207 = local_3;
                                phi_201_ = _e207;
                            } else {
                                phi_199_ = _e104;
                                phi_200_ = u32();
                                phi_201_ = u32();
                            }
                            let _e166 = phi_199_;
                            let _e168 = phi_200_;
                            let _e170 = phi_201_;
                            phi_131_ = _e166;
                            phi_134_ = _e168;
                            phi_136_ = _e170;
                            phi_202_ = _e114;
                        } else {
                            phi_131_ = _e104;
                            phi_134_ = u32();
                            phi_136_ = u32();
                            phi_202_ = false;
                        }
                        let _e172 = phi_131_;
                        let _e174 = phi_134_;
                        let _e176 = phi_136_;
                        let _e178 = phi_202_;
                        continue;
                        continuing {
                            phi_130_ = _e172;
                            phi_133_ = _e174;
                            phi_135_ = _e176;
                            phi_203_ = _e172;
                            break if !(_e178);
                        }
                    }
                    let _e181 = phi_203_;
                    if _e181 {
                        break;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense_weight_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
