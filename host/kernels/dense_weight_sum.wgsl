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
    var local: u32;
    var phi_103_: u32;
    var phi_106_: u32;
    var phi_120_: bool;
    var phi_123_: u32;
    var phi_125_: u32;
    var phi_153_: u32;
    var phi_159_: vec4<f32>;
    var phi_126_: u32;
    var phi_121_: bool;
    var local_1: vec4<f32>;
    var phi_176_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: bool;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: vec4<f32>;
    var local_11: u32;

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
                        if ((_e49 + 1u) < _e51) {
                            let _e55 = ((_e49 + _e51) / 2u);
                            let _e59 = global_4.member[(2u * _e55)];
                            let _e60 = (_e59 <= _e40);
                            local_2 = select(_e49, _e55, _e60);
                            local_3 = select(_e55, _e51, _e60);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e154 = local_2;
                            phi_75_ = _e154;
                            let _e157 = local_3;
                            phi_78_ = _e157;
                        }
                    }
                    let _e64 = local;
                    let _e65 = (2u * _e64);
                    let _e69 = global_4.member[(_e65 + 1u)];
                    let _e72 = global_4.member[_e65];
                    let _e74 = (_e47 == 0u);
                    if _e74 {
                        break;
                    }
                    let _e76 = (_e69 + ((_e40 - _e72) / _e47));
                    phi_103_ = 0u;
                    phi_106_ = _e44;
                    loop {
                        let _e78 = phi_103_;
                        let _e80 = phi_106_;
                        local_7 = _e78;
                        if ((_e78 + 1u) < _e80) {
                            let _e84 = ((_e78 + _e80) / 2u);
                            let _e89 = global_4.member[((2u * _e84) + 1u)];
                            let _e90 = (_e89 <= _e76);
                            local_4 = select(_e78, _e84, _e90);
                            local_5 = select(_e84, _e80, _e90);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e161 = local_4;
                            phi_103_ = _e161;
                            let _e164 = local_5;
                            phi_106_ = _e164;
                        }
                    }
                    phi_120_ = false;
                    let _e170 = local_7;
                    phi_123_ = _e170;
                    phi_125_ = _e76;
                    loop {
                        let _e94 = phi_120_;
                        let _e96 = phi_123_;
                        let _e98 = phi_125_;
                        phi_176_ = _e94;
                        if (_e96 < _e44) {
                            let _e100 = (2u * _e96);
                            let _e103 = global_4.member[_e100];
                            phi_176_ = _e94;
                            if (_e103 < _e41) {
                                let _e105 = (_e96 + 1u);
                                let _e106 = (2u * _e105);
                                let _e109 = global_4.member[_e106];
                                let _e114 = global_4.member[(_e100 + 1u)];
                                local_8 = _e105;
                                if _e74 {
                                    phi_176_ = true;
                                    break;
                                }
                                if (_e109 <= _e41) {
                                    let _e121 = global_4.member[(_e106 + 1u)];
                                    phi_153_ = _e121;
                                } else {
                                    phi_153_ = (_e114 + ((_e41 - _e103) / _e47));
                                }
                                let _e123 = phi_153_;
                                let _e128 = global_6.member[((_e96 * _e32) + _e29)];
                                phi_159_ = _e128;
                                phi_126_ = _e98;
                                loop {
                                    let _e130 = phi_159_;
                                    let _e132 = phi_126_;
                                    local_9 = _e132;
                                    phi_121_ = _e94;
                                    local_1 = _e130;
                                    if (_e132 < _e123) {
                                        let _e136 = global_3.member.member_5;
                                        if (_e136 == 0u) {
                                            phi_121_ = true;
                                            break;
                                        }
                                        let _e143 = global_5.member[(((_e132 % _e136) * _e32) + _e29)];
                                        local_10 = (_e130 + _e143);
                                        local_11 = (_e132 + 1u);
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e179 = local_10;
                                        phi_159_ = _e179;
                                        let _e182 = local_11;
                                        phi_126_ = _e182;
                                    }
                                }
                                let _e147 = phi_121_;
                                local_6 = _e147;
                                phi_176_ = _e147;
                                if _e147 {
                                    break;
                                }
                                let _e149 = local_1;
                                global_6.member[((_e96 * _e32) + _e29)] = _e149;
                                continue;
                            } else {
                                break;
                            }
                        } else {
                            break;
                        }
                        continuing {
                            let _e167 = local_6;
                            phi_120_ = _e167;
                            let _e172 = local_8;
                            phi_123_ = _e172;
                            let _e175 = local_9;
                            phi_125_ = _e175;
                        }
                    }
                    let _e151 = phi_176_;
                    if _e151 {
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
