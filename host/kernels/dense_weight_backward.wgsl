struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_5;
@group(0) @binding(1) 
var<storage> global_5: type_11;
@group(0) @binding(0) 
var<uniform> global_6: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_82_: u32;
    var phi_85_: u32;
    var local: u32;
    var phi_112_: u32;
    var phi_115_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_148_: u32;
    var phi_158_: u32;
    var phi_204_: vec4<f32>;
    var phi_211_: u32;
    var phi_214_: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var local_6: type_19;
    var phi_246_: u32;
    var phi_249_: type_19;
    var local_7: type_19;
    var local_8: type_19;
    var local_9: type_19;
    var local_10: type_19;
    var phi_310_: vec4<f32>;
    var phi_321_: vec4<f32>;
    var phi_332_: vec4<f32>;
    var phi_343_: vec4<f32>;
    var phi_363_: type_19;
    var phi_366_: type_19;
    var phi_368_: type_19;
    var phi_370_: type_19;
    var phi_372_: u32;
    var local_11: type_19;
    var local_12: type_19;
    var local_13: type_19;
    var local_14: type_19;
    var local_15: type_19;
    var local_16: type_19;
    var local_17: type_19;
    var local_18: type_19;
    var local_19: type_19;
    var local_20: type_19;
    var local_21: type_19;
    var local_22: type_19;
    var local_23: type_19;
    var local_24: type_19;
    var local_25: type_19;
    var local_26: type_19;
    var phi_468_: type_19;
    var phi_471_: type_19;
    var phi_473_: type_19;
    var phi_475_: type_19;
    var phi_477_: u32;
    var local_27: type_19;
    var local_28: type_19;
    var local_29: type_19;
    var local_30: type_19;
    var local_31: type_19;
    var local_32: type_19;
    var local_33: type_19;
    var local_34: type_19;
    var local_35: type_19;
    var local_36: type_19;
    var local_37: type_19;
    var local_38: type_19;
    var local_39: type_19;
    var local_40: type_19;
    var local_41: type_19;
    var local_42: type_19;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: type_19;
    var local_48: u32;
    var local_49: type_19;
    var local_50: type_19;
    var local_51: type_19;
    var local_52: type_19;
    var local_53: type_19;
    var local_54: type_19;
    var local_55: type_19;
    var local_56: type_19;
    var local_57: type_19;
    var local_58: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = global;
            let _e29 = global_1;
            let _e30 = global_2;
            let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
            let _e41 = global_6.member.member_4;
            let _e44 = global_6.member.member_3;
            let _e45 = (_e44 - 1u);
            let _e46 = (_e45 / 4u);
            let _e50 = global_6.member.member_1;
            let _e53 = global_6.member.member_7;
            let _e56 = global_6.member.member_8;
            phi_82_ = 0u;
            phi_85_ = _e53;
            loop {
                let _e58 = phi_82_;
                let _e60 = phi_85_;
                local = _e58;
                if ((_e58 + 1u) < _e60) {
                    let _e64 = ((_e58 + _e60) / 2u);
                    let _e68 = global_5.member[(2u * _e64)];
                    let _e69 = (_e68 <= _e50);
                    local_43 = select(_e58, _e64, _e69);
                    local_44 = select(_e64, _e60, _e69);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e673 = local_43;
                    phi_82_ = _e673;
                    let _e676 = local_44;
                    phi_85_ = _e676;
                }
            }
            let _e73 = local;
            let _e74 = (2u * _e73);
            let _e78 = global_5.member[(_e74 + 1u)];
            let _e81 = global_5.member[_e74];
            if (_e56 == 0u) {
                break;
            }
            let _e87 = ((_e78 + ((_e50 - _e81) / _e56)) + _e29.z);
            phi_112_ = 0u;
            phi_115_ = _e53;
            loop {
                let _e89 = phi_112_;
                let _e91 = phi_115_;
                let _e92 = (_e89 + 1u);
                local_1 = _e89;
                local_2 = _e92;
                if (_e92 < _e91) {
                    let _e95 = ((_e89 + _e91) / 2u);
                    let _e100 = global_5.member[((2u * _e95) + 1u)];
                    let _e101 = (_e100 <= _e87);
                    local_45 = select(_e89, _e95, _e101);
                    local_46 = select(_e95, _e91, _e101);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e680 = local_45;
                    phi_112_ = _e680;
                    let _e683 = local_46;
                    phi_115_ = _e683;
                }
            }
            let _e105 = local_1;
            let _e106 = (2u * _e105);
            let _e109 = global_5.member[_e106];
            let _e113 = global_5.member[(_e106 + 1u)];
            let _e116 = (_e109 + ((_e87 - _e113) * _e56));
            let _e117 = (_e116 + _e56);
            let _e119 = local_2;
            let _e123 = global_5.member[(2u * _e119)];
            let _e125 = select(_e123, _e117, (_e117 < _e123));
            if (_e116 > _e50) {
                phi_148_ = (_e116 - _e50);
            } else {
                phi_148_ = 0u;
            }
            let _e129 = phi_148_;
            if (_e125 > _e50) {
                let _e131 = (_e125 - _e50);
                let _e134 = global_6.member.member;
                phi_158_ = select(_e134, _e131, (_e131 < _e134));
            } else {
                phi_158_ = 0u;
            }
            let _e138 = phi_158_;
            if (_e38 < ((_e46 + 2u) * _e41)) {
                if (_e129 < _e138) {
                    let _e143 = (_e41 == 0u);
                    if _e143 {
                        break;
                    }
                    let _e144 = (_e38 / _e41);
                    if _e143 {
                        break;
                    }
                    let _e145 = (_e38 % _e41);
                    let _e148 = global_6.member.member_9;
                    if (_e148 == 0u) {
                        break;
                    }
                    let _e153 = global_6.member.member_10;
                    let _e155 = (((_e87 % _e148) * _e153) + _e145);
                    let _e157 = select(false, true, (_e116 < _e50));
                    let _e161 = global_6.member.member_2;
                    let _e162 = ((4u * _e145) * _e161);
                    if (_e144 < (_e46 + 1u)) {
                        let _e275 = (_e144 * 4u);
                        let _e278 = global_6.member.member_5;
                        let _e281 = ((_e155 + _e278) + (_e275 * _e41));
                        let _e282 = (_e45 - _e275);
                        let _e286 = (_e281 + (select(_e282, 1u, (1u < _e282)) * _e41));
                        let _e290 = (_e281 + (select(_e282, 2u, (2u < _e282)) * _e41));
                        let _e294 = (_e281 + (select(_e282, 3u, (3u < _e282)) * _e41));
                        if _e157 {
                            let _e297 = global_7.member[_e281];
                            phi_310_ = _e297;
                        } else {
                            phi_310_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e299 = phi_310_;
                        if _e157 {
                            let _e307 = global_7.member[_e286];
                            phi_321_ = _e307;
                        } else {
                            phi_321_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e309 = phi_321_;
                        if _e157 {
                            let _e317 = global_7.member[_e290];
                            phi_332_ = _e317;
                        } else {
                            phi_332_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e319 = phi_332_;
                        if _e157 {
                            let _e327 = global_7.member[_e294];
                            phi_343_ = _e327;
                        } else {
                            phi_343_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e329 = phi_343_;
                        let _e335 = (_e275 * _e161);
                        let _e336 = (_e275 + 1u);
                        let _e339 = (select(_e45, _e336, (_e336 < _e45)) * _e161);
                        let _e340 = (_e275 + 2u);
                        let _e343 = (select(_e45, _e340, (_e340 < _e45)) * _e161);
                        let _e344 = (_e275 + 3u);
                        let _e347 = (select(_e45, _e344, (_e344 < _e45)) * _e161);
                        phi_363_ = type_19(_e329.x, _e329.y, _e329.z, _e329.w);
                        phi_366_ = type_19(_e319.x, _e319.y, _e319.z, _e319.w);
                        phi_368_ = type_19(_e309.x, _e309.y, _e309.z, _e309.w);
                        phi_370_ = type_19(_e299.x, _e299.y, _e299.z, _e299.w);
                        phi_372_ = _e129;
                        loop {
                            let _e349 = phi_363_;
                            let _e351 = phi_366_;
                            let _e353 = phi_368_;
                            let _e355 = phi_370_;
                            let _e357 = phi_372_;
                            let _e358 = (_e357 + 1u);
                            local_11 = _e355;
                            local_12 = _e355;
                            local_13 = _e355;
                            local_14 = _e355;
                            local_15 = _e353;
                            local_16 = _e353;
                            local_17 = _e353;
                            local_18 = _e353;
                            local_19 = _e351;
                            local_20 = _e351;
                            local_21 = _e351;
                            local_22 = _e351;
                            local_23 = _e349;
                            local_24 = _e349;
                            local_25 = _e349;
                            local_26 = _e349;
                            local_58 = _e357;
                            if (_e358 <= _e138) {
                                let _e360 = (_e162 + _e357);
                                let _e363 = global_4.member[_e360];
                                let _e367 = global_4.member[(_e360 + _e161)];
                                let _e372 = global_4.member[(_e360 + (2u * _e161))];
                                let _e377 = global_4.member[(_e360 + (3u * _e161))];
                                let _e381 = global_3.member[(_e335 + _e357)];
                                let _e398 = global_3.member[(_e339 + _e357)];
                                let _e415 = global_3.member[(_e343 + _e357)];
                                let _e432 = global_3.member[(_e347 + _e357)];
                                local_50 = type_19(((_e432 * _e363) + _e349.member), ((_e432 * _e367) + _e349.member_1), ((_e432 * _e372) + _e349.member_2), ((_e432 * _e377) + _e349.member_3));
                                local_51 = type_19(((_e415 * _e363) + _e351.member), ((_e415 * _e367) + _e351.member_1), ((_e415 * _e372) + _e351.member_2), ((_e415 * _e377) + _e351.member_3));
                                local_52 = type_19(((_e398 * _e363) + _e353.member), ((_e398 * _e367) + _e353.member_1), ((_e398 * _e372) + _e353.member_2), ((_e398 * _e377) + _e353.member_3));
                                local_53 = type_19(((_e381 * _e363) + _e355.member), ((_e381 * _e367) + _e355.member_1), ((_e381 * _e372) + _e355.member_2), ((_e381 * _e377) + _e355.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e713 = local_50;
                                phi_363_ = _e713;
                                let _e716 = local_51;
                                phi_366_ = _e716;
                                let _e719 = local_52;
                                phi_368_ = _e719;
                                let _e722 = local_53;
                                phi_370_ = _e722;
                                phi_372_ = _e358;
                            }
                        }
                        let _e447 = local_11;
                        let _e450 = local_12;
                        let _e453 = local_13;
                        let _e456 = local_14;
                        let _e459 = local_15;
                        let _e462 = local_16;
                        let _e465 = local_17;
                        let _e468 = local_18;
                        let _e471 = local_19;
                        let _e474 = local_20;
                        let _e477 = local_21;
                        let _e480 = local_22;
                        let _e483 = local_23;
                        let _e486 = local_24;
                        let _e489 = local_25;
                        let _e492 = local_26;
                        phi_468_ = type_19(0f, 0f, 0f, 0f);
                        phi_471_ = type_19(0f, 0f, 0f, 0f);
                        phi_473_ = type_19(0f, 0f, 0f, 0f);
                        phi_475_ = type_19(0f, 0f, 0f, 0f);
                        let _e754 = local_58;
                        phi_477_ = _e754;
                        loop {
                            let _e495 = phi_468_;
                            let _e497 = phi_471_;
                            let _e499 = phi_473_;
                            let _e501 = phi_475_;
                            let _e503 = phi_477_;
                            let _e504 = (_e503 + 1u);
                            local_27 = _e501;
                            local_28 = _e501;
                            local_29 = _e501;
                            local_30 = _e501;
                            local_31 = _e499;
                            local_32 = _e499;
                            local_33 = _e499;
                            local_34 = _e499;
                            local_35 = _e497;
                            local_36 = _e497;
                            local_37 = _e497;
                            local_38 = _e497;
                            local_39 = _e495;
                            local_40 = _e495;
                            local_41 = _e495;
                            local_42 = _e495;
                            if (_e504 <= _e138) {
                                let _e506 = (_e162 + _e503);
                                let _e509 = global_4.member[_e506];
                                let _e513 = global_4.member[(_e506 + _e161)];
                                let _e518 = global_4.member[(_e506 + (2u * _e161))];
                                let _e523 = global_4.member[(_e506 + (3u * _e161))];
                                let _e527 = global_3.member[(_e335 + _e503)];
                                let _e544 = global_3.member[(_e339 + _e503)];
                                let _e561 = global_3.member[(_e343 + _e503)];
                                let _e578 = global_3.member[(_e347 + _e503)];
                                local_54 = type_19(((_e578 * _e509) + _e495.member), ((_e578 * _e513) + _e495.member_1), ((_e578 * _e518) + _e495.member_2), ((_e578 * _e523) + _e495.member_3));
                                local_55 = type_19(((_e561 * _e509) + _e497.member), ((_e561 * _e513) + _e497.member_1), ((_e561 * _e518) + _e497.member_2), ((_e561 * _e523) + _e497.member_3));
                                local_56 = type_19(((_e544 * _e509) + _e499.member), ((_e544 * _e513) + _e499.member_1), ((_e544 * _e518) + _e499.member_2), ((_e544 * _e523) + _e499.member_3));
                                local_57 = type_19(((_e527 * _e509) + _e501.member), ((_e527 * _e513) + _e501.member_1), ((_e527 * _e518) + _e501.member_2), ((_e527 * _e523) + _e501.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e742 = local_54;
                                phi_468_ = _e742;
                                let _e745 = local_55;
                                phi_471_ = _e745;
                                let _e748 = local_56;
                                phi_473_ = _e748;
                                let _e751 = local_57;
                                phi_475_ = _e751;
                                phi_477_ = _e504;
                            }
                        }
                        let _e593 = local_27;
                        let _e597 = local_28;
                        let _e601 = local_29;
                        let _e605 = local_30;
                        global_7.member[_e281] = vec4<f32>((_e447.member + _e593.member), (_e450.member_1 + _e597.member_1), (_e453.member_2 + _e601.member_2), (_e456.member_3 + _e605.member_3));
                        if (_e336 < _e44) {
                            let _e613 = local_31;
                            let _e617 = local_32;
                            let _e621 = local_33;
                            let _e625 = local_34;
                            global_7.member[_e286] = vec4<f32>((_e459.member + _e613.member), (_e462.member_1 + _e617.member_1), (_e465.member_2 + _e621.member_2), (_e468.member_3 + _e625.member_3));
                        }
                        if (_e340 < _e44) {
                            let _e633 = local_35;
                            let _e637 = local_36;
                            let _e641 = local_37;
                            let _e645 = local_38;
                            global_7.member[_e290] = vec4<f32>((_e471.member + _e633.member), (_e474.member_1 + _e637.member_1), (_e477.member_2 + _e641.member_2), (_e480.member_3 + _e645.member_3));
                        }
                        if (_e344 < _e44) {
                            let _e653 = local_39;
                            let _e657 = local_40;
                            let _e661 = local_41;
                            let _e665 = local_42;
                            global_7.member[_e294] = vec4<f32>((_e483.member + _e653.member), (_e486.member_1 + _e657.member_1), (_e489.member_2 + _e661.member_2), (_e492.member_3 + _e665.member_3));
                        }
                    } else {
                        let _e166 = global_6.member.member_6;
                        let _e167 = (_e155 + _e166);
                        if _e157 {
                            let _e170 = global_7.member[_e167];
                            phi_204_ = _e170;
                        } else {
                            phi_204_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e172 = phi_204_;
                        phi_211_ = _e129;
                        phi_214_ = type_19(_e172.x, _e172.y, _e172.z, _e172.w);
                        loop {
                            let _e179 = phi_211_;
                            let _e181 = phi_214_;
                            let _e182 = (_e179 + 1u);
                            local_3 = _e181;
                            local_4 = _e181;
                            local_5 = _e181;
                            local_6 = _e181;
                            local_48 = _e179;
                            if (_e182 <= _e138) {
                                let _e184 = (_e162 + _e179);
                                let _e187 = global_4.member[_e184];
                                let _e191 = global_4.member[(_e184 + _e161)];
                                let _e196 = global_4.member[(_e184 + (2u * _e161))];
                                let _e201 = global_4.member[(_e184 + (3u * _e161))];
                                local_47 = type_19((_e181.member + _e187), (_e181.member_1 + _e191), (_e181.member_2 + _e196), (_e181.member_3 + _e201));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_211_ = _e182;
                                let _e692 = local_47;
                                phi_214_ = _e692;
                            }
                        }
                        let _e212 = local_3;
                        let _e215 = local_4;
                        let _e218 = local_5;
                        let _e221 = local_6;
                        let _e699 = local_48;
                        phi_246_ = _e699;
                        phi_249_ = type_19(0f, 0f, 0f, 0f);
                        loop {
                            let _e224 = phi_246_;
                            let _e226 = phi_249_;
                            let _e227 = (_e224 + 1u);
                            local_7 = _e226;
                            local_8 = _e226;
                            local_9 = _e226;
                            local_10 = _e226;
                            if (_e227 <= _e138) {
                                let _e229 = (_e162 + _e224);
                                let _e232 = global_4.member[_e229];
                                let _e236 = global_4.member[(_e229 + _e161)];
                                let _e241 = global_4.member[(_e229 + (2u * _e161))];
                                let _e246 = global_4.member[(_e229 + (3u * _e161))];
                                local_49 = type_19((_e226.member + _e232), (_e226.member_1 + _e236), (_e226.member_2 + _e241), (_e226.member_3 + _e246));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_246_ = _e227;
                                let _e702 = local_49;
                                phi_249_ = _e702;
                            }
                        }
                        let _e257 = local_7;
                        let _e261 = local_8;
                        let _e265 = local_9;
                        let _e269 = local_10;
                        global_7.member[_e167] = vec4<f32>((_e212.member + _e257.member), (_e215.member_1 + _e261.member_1), (_e218.member_2 + _e265.member_2), (_e221.member_3 + _e269.member_3));
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense_weight_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
