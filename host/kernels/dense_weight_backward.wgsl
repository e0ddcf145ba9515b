struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_14 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_17 {
    member: type_16,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_17;
@group(0) @binding(1) 
var<storage> global_4: type_9;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_6;

fn function_() {
    var phi_117_: type_14;
    var phi_120_: type_14;
    var phi_122_: type_14;
    var phi_124_: type_14;
    var phi_126_: u32;
    var phi_118_: type_14;
    var phi_121_: type_14;
    var phi_123_: type_14;
    var phi_125_: type_14;
    var local: type_14;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: type_14;
    var local_4: type_14;
    var local_5: type_14;
    var local_6: type_14;
    var local_7: type_14;
    var local_8: type_14;
    var local_9: type_14;
    var local_10: type_14;
    var local_11: type_14;
    var local_12: type_14;
    var local_13: type_14;
    var local_14: type_14;
    var local_15: type_14;
    var phi_230_: type_14;
    var phi_233_: type_14;
    var phi_235_: type_14;
    var phi_237_: type_14;
    var phi_239_: u32;
    var phi_231_: type_14;
    var phi_234_: type_14;
    var phi_236_: type_14;
    var phi_238_: type_14;
    var local_16: type_14;
    var local_17: type_14;
    var local_18: type_14;
    var local_19: type_14;
    var local_20: type_14;
    var local_21: type_14;
    var local_22: type_14;
    var local_23: type_14;
    var local_24: type_14;
    var local_25: type_14;
    var local_26: type_14;
    var local_27: type_14;
    var local_28: type_14;
    var local_29: type_14;
    var local_30: type_14;
    var local_31: type_14;
    var phi_389_: type_14;
    var phi_392_: u32;
    var phi_390_: type_14;
    var local_32: type_14;
    var local_33: type_14;
    var local_34: type_14;
    var local_35: type_14;
    var phi_429_: type_14;
    var phi_432_: u32;
    var phi_430_: type_14;
    var local_36: type_14;
    var local_37: type_14;
    var local_38: type_14;
    var local_39: type_14;
    var local_40: u32;
    var local_41: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global;
            let _e23 = global_1;
            let _e24 = global_2;
            let _e32 = (((_e23.x + (_e23.y * _e24.x)) * 16u) + _e22.x);
            let _e35 = global_3.member.member_3;
            let _e38 = global_3.member.member_2;
            let _e39 = (_e38 - 1u);
            let _e40 = (_e39 / 4u);
            if (_e32 < ((_e40 + 2u) * _e35)) {
                let _e45 = (_e35 == 0u);
                if _e45 {
                    break;
                }
                let _e46 = (_e32 / _e35);
                if _e45 {
                    break;
                }
                let _e47 = (_e32 % _e35);
                let _e51 = global_3.member.member_6;
                let _e52 = (_e23.z * _e51);
                let _e53 = (_e52 + _e51);
                let _e56 = global_3.member.member;
                let _e58 = select(_e56, _e53, (_e53 < _e56));
                let _e61 = global_3.member.member_7;
                let _e65 = global_3.member.member_8;
                let _e67 = (((_e61 + _e23.z) * _e65) + _e47);
                let _e71 = global_3.member.member_1;
                let _e72 = ((4u * _e47) * _e71);
                if (_e46 < (_e40 + 1u)) {
                    let _e74 = (_e46 * 4u);
                    let _e75 = (_e74 * _e71);
                    let _e76 = (_e74 + 1u);
                    let _e79 = (select(_e39, _e76, (_e76 < _e39)) * _e71);
                    let _e80 = (_e74 + 2u);
                    let _e83 = (select(_e39, _e80, (_e80 < _e39)) * _e71);
                    let _e84 = (_e74 + 3u);
                    let _e87 = (select(_e39, _e84, (_e84 < _e39)) * _e71);
                    phi_117_ = type_14(0f, 0f, 0f, 0f);
                    phi_120_ = type_14(0f, 0f, 0f, 0f);
                    phi_122_ = type_14(0f, 0f, 0f, 0f);
                    phi_124_ = type_14(0f, 0f, 0f, 0f);
                    phi_126_ = _e52;
                    loop {
                        let _e89 = phi_117_;
                        let _e91 = phi_120_;
                        let _e93 = phi_122_;
                        let _e95 = phi_124_;
                        let _e97 = phi_126_;
                        local = _e93;
                        local_1 = _e93;
                        local_2 = _e93;
                        local_3 = _e93;
                        local_4 = _e91;
                        local_5 = _e91;
                        local_6 = _e91;
                        local_7 = _e91;
                        local_8 = _e89;
                        local_9 = _e89;
                        local_10 = _e89;
                        local_11 = _e89;
                        local_12 = _e95;
                        local_13 = _e95;
                        local_14 = _e95;
                        local_15 = _e95;
                        local_40 = _e97;
                        let _e98 = (_e97 + 1u);
                        let _e99 = (_e98 <= _e58);
                        if _e99 {
                            let _e100 = (_e72 + _e97);
                            let _e103 = global_5.member[_e100];
                            let _e107 = global_5.member[(_e100 + _e71)];
                            let _e112 = global_5.member[(_e100 + (2u * _e71))];
                            let _e117 = global_5.member[(_e100 + (3u * _e71))];
                            let _e121 = global_4.member[(_e75 + _e97)];
                            let _e138 = global_4.member[(_e79 + _e97)];
                            let _e155 = global_4.member[(_e83 + _e97)];
                            let _e172 = global_4.member[(_e87 + _e97)];
                            phi_118_ = type_14(((_e155 * _e103) + _e89.member), ((_e155 * _e107) + _e89.member_1), ((_e155 * _e112) + _e89.member_2), ((_e155 * _e117) + _e89.member_3));
                            phi_121_ = type_14(((_e138 * _e103) + _e91.member), ((_e138 * _e107) + _e91.member_1), ((_e138 * _e112) + _e91.member_2), ((_e138 * _e117) + _e91.member_3));
                            phi_123_ = type_14(((_e121 * _e103) + _e93.member), ((_e121 * _e107) + _e93.member_1), ((_e121 * _e112) + _e93.member_2), ((_e121 * _e117) + _e93.member_3));
                            phi_125_ = type_14(((_e172 * _e103) + _e95.member), ((_e172 * _e107) + _e95.member_1), ((_e172 * _e112) + _e95.member_2), ((_e172 * _e117) + _e95.member_3));
                        } else {
                            phi_118_ = type_14();
                            phi_121_ = type_14();
                            phi_123_ = type_14();
                            phi_125_ = type_14();
                        }
                        let _e187 = phi_118_;
                        let _e189 = phi_121_;
                        let _e191 = phi_123_;
                        let _e193 = phi_125_;
                        continue;
                        continuing {
                            phi_117_ = _e187;
                            phi_120_ = _e189;
                            phi_122_ = _e191;
                            phi_124_ = _e193;
                            phi_126_ = select(u32(), _e98, _e99);
                            break if !(_e99);
                        }
                    }
                    let _e197 = local;
                    let _e200 = local_1;
                    let _e203 = local_2;
                    let _e206 = local_3;
                    let _e209 = local_4;
                    let _e212 = local_5;
                    let _e215 = local_6;
                    let _e218 = local_7;
                    let _e221 = local_8;
                    let _e224 = local_9;
                    let _e227 = local_10;
                    let _e230 = local_11;
                    let _e233 = local_12;
                    let _e236 = local_13;
                    let _e239 = local_14;
                    let _e242 = local_15;
                    phi_230_ = type_14(0f, 0f, 0f, 0f);
                    phi_233_ = type_14(0f, 0f, 0f, 0f);
                    phi_235_ = type_14(0f, 0f, 0f, 0f);
                    phi_237_ = type_14(0f, 0f, 0f, 0f);
                    let _e582 = local_40;
                    phi_239_ = _e582;
                    loop {
                        let _e245 = phi_230_;
                        let _e247 = phi_233_;
                        let _e249 = phi_235_;
                        let _e251 = phi_237_;
                        let _e253 = phi_239_;
                        local_16 = _e249;
                        local_17 = _e249;
                        local_18 = _e249;
                        local_19 = _e249;
                        local_20 = _e247;
                        local_21 = _e247;
                        local_22 = _e247;
                        local_23 = _e247;
                        local_24 = _e245;
                        local_25 = _e245;
                        local_26 = _e245;
                        local_27 = _e245;
                        local_28 = _e251;
                        local_29 = _e251;
                        local_30 = _e251;
                        local_31 = _e251;
                        let _e254 = (_e253 + 1u);
                        let _e255 = (_e254 <= _e58);
                        if _e255 {
                            let _e256 = (_e72 + _e253);
                            let _e259 = global_5.member[_e256];
                            let _e263 = global_5.member[(_e256 + _e71)];
                            let _e268 = global_5.member[(_e256 + (2u * _e71))];
                            let _e273 = global_5.member[(_e256 + (3u * _e71))];
                            let _e277 = global_4.member[(_e75 + _e253)];
                            let _e294 = global_4.member[(_e79 + _e253)];
                            let _e311 = global_4.member[(_e83 + _e253)];
                            let _e328 = global_4.member[(_e87 + _e253)];
                            phi_231_ = type_14(((_e311 * _e259) + _e245.member), ((_e311 * _e263) + _e245.member_1), ((_e311 * _e268) + _e245.member_2), ((_e311 * _e273) + _e245.member_3));
                            phi_234_ = type_14(((_e294 * _e259) + _e247.member), ((_e294 * _e263) + _e247.member_1), ((_e294 * _e268) + _e247.member_2), ((_e294 * _e273) + _e247.member_3));
                            phi_236_ = type_14(((_e277 * _e259) + _e249.member), ((_e277 * _e263) + _e249.member_1), ((_e277 * _e268) + _e249.member_2), ((_e277 * _e273) + _e249.member_3));
                            phi_238_ = type_14(((_e328 * _e259) + _e251.member), ((_e328 * _e263) + _e251.member_1), ((_e328 * _e268) + _e251.member_2), ((_e328 * _e273) + _e251.member_3));
                        } else {
                            phi_231_ = type_14();
                            phi_234_ = type_14();
                            phi_236_ = type_14();
                            phi_238_ = type_14();
                        }
                        let _e343 = phi_231_;
                        let _e345 = phi_234_;
                        let _e347 = phi_236_;
                        let _e349 = phi_238_;
                        continue;
                        continuing {
                            phi_230_ = _e343;
                            phi_233_ = _e345;
                            phi_235_ = _e347;
                            phi_237_ = _e349;
                            phi_239_ = select(u32(), _e254, _e255);
                            break if !(_e255);
                        }
                    }
                    let _e354 = global_3.member.member_4;
                    let _e357 = ((_e67 + _e354) + (_e74 * _e35));
                    let _e359 = local_16;
                    let _e363 = local_17;
                    let _e367 = local_18;
                    let _e371 = local_19;
                    global_6.member[_e357] = vec4<f32>((_e197.member + _e359.member), (_e200.member_1 + _e363.member_1), (_e203.member_2 + _e367.member_2), (_e206.member_3 + _e371.member_3));
                    if (_e76 < _e38) {
                        let _e380 = local_20;
                        let _e384 = local_21;
                        let _e388 = local_22;
                        let _e392 = local_23;
                        global_6.member[(_e357 + _e35)] = vec4<f32>((_e209.member + _e380.member), (_e212.member_1 + _e384.member_1), (_e215.member_2 + _e388.member_2), (_e218.member_3 + _e392.member_3));
                    }
                    if (_e80 < _e38) {
                        let _e402 = local_24;
                        let _e406 = local_25;
                        let _e410 = local_26;
                        let _e414 = local_27;
                        global_6.member[(_e357 + (2u * _e35))] = vec4<f32>((_e221.member + _e402.member), (_e224.member_1 + _e406.member_1), (_e227.member_2 + _e410.member_2), (_e230.member_3 + _e414.member_3));
                    }
                    if (_e84 < _e38) {
                        let _e424 = local_28;
                        let _e428 = local_29;
                        let _e432 = local_30;
                        let _e436 = local_31;
                        global_6.member[(_e357 + (3u * _e35))] = vec4<f32>((_e233.member + _e424.member), (_e236.member_1 + _e428.member_1), (_e239.member_2 + _e432.member_2), (_e242.member_3 + _e436.member_3));
                    }
                } else {
                    phi_389_ = type_14(0f, 0f, 0f, 0f);
                    phi_392_ = _e52;
                    loop {
                        let _e443 = phi_389_;
                        let _e445 = phi_392_;
                        local_32 = _e443;
                        local_33 = _e443;
                        local_34 = _e443;
                        local_35 = _e443;
                        local_41 = _e445;
                        let _e446 = (_e445 + 1u);
                        let _e447 = (_e446 <= _e58);
                        if _e447 {
                            let _e448 = (_e72 + _e445);
                            let _e451 = global_5.member[_e448];
                            let _e455 = global_5.member[(_e448 + _e71)];
                            let _e460 = global_5.member[(_e448 + (2u * _e71))];
                            let _e465 = global_5.member[(_e448 + (3u * _e71))];
                            phi_390_ = type_14((_e443.member + _e451), (_e443.member_1 + _e455), (_e443.member_2 + _e460), (_e443.member_3 + _e465));
                        } else {
                            phi_390_ = type_14();
                        }
                        let _e476 = phi_390_;
                        continue;
                        continuing {
                            phi_389_ = _e476;
                            phi_392_ = select(u32(), _e446, _e447);
                            break if !(_e447);
                        }
                    }
                    let _e480 = local_32;
                    let _e483 = local_33;
                    let _e486 = local_34;
                    let _e489 = local_35;
                    phi_429_ = type_14(0f, 0f, 0f, 0f);
                    let _e613 = local_41;
                    phi_432_ = _e613;
                    loop {
                        let _e492 = phi_429_;
                        let _e494 = phi_432_;
                        local_36 = _e492;
                        local_37 = _e492;
                        local_38 = _e492;
                        local_39 = _e492;
                        let _e495 = (_e494 + 1u);
                        let _e496 = (_e495 <= _e58);
                        if _e496 {
                            let _e497 = (_e72 + _e494);
                            let _e500 = global_5.member[_e497];
                            let _e504 = global_5.member[(_e497 + _e71)];
                            let _e509 = global_5.member[(_e497 + (2u * _e71))];
                            let _e514 = global_5.member[(_e497 + (3u * _e71))];
                            phi_430_ = type_14((_e492.member + _e500), (_e492.member_1 + _e504), (_e492.member_2 + _e509), (_e492.member_3 + _e514));
                        } else {
                            phi_430_ = type_14();
                        }
                        let _e525 = phi_430_;
                        continue;
                        continuing {
                            phi_429_ = _e525;
                            phi_432_ = select(u32(), _e495, _e496);
                            break if !(_e496);
                        }
                    }
                    let _e529 = local_36;
                    let _e533 = local_37;
                    let _e537 = local_38;
                    let _e541 = local_39;
                    let _e547 = global_3.member.member_5;
                    global_6.member[(_e67 + _e547)] = vec4<f32>((_e480.member + _e529.member), (_e483.member_1 + _e533.member_1), (_e486.member_2 + _e537.member_2), (_e489.member_3 + _e541.member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(16, 1, 1) 
fn dense_weight_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
