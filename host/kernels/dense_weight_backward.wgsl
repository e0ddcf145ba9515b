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
    var phi_83_: u32;
    var phi_86_: u32;
    var local: u32;
    var phi_117_: u32;
    var phi_120_: u32;
    var phi_118_: u32;
    var phi_121_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_158_: u32;
    var phi_168_: u32;
    var phi_214_: vec4<f32>;
    var phi_221_: u32;
    var phi_224_: type_19;
    var phi_225_: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var local_6: type_19;
    var phi_261_: u32;
    var phi_264_: type_19;
    var phi_265_: type_19;
    var local_7: type_19;
    var local_8: type_19;
    var local_9: type_19;
    var local_10: type_19;
    var phi_330_: vec4<f32>;
    var phi_341_: vec4<f32>;
    var phi_352_: vec4<f32>;
    var phi_363_: vec4<f32>;
    var phi_383_: type_19;
    var phi_386_: type_19;
    var phi_388_: type_19;
    var phi_390_: type_19;
    var phi_392_: u32;
    var phi_384_: type_19;
    var phi_387_: type_19;
    var phi_389_: type_19;
    var phi_391_: type_19;
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
    var phi_496_: type_19;
    var phi_499_: type_19;
    var phi_501_: type_19;
    var phi_503_: type_19;
    var phi_505_: u32;
    var phi_497_: type_19;
    var phi_500_: type_19;
    var phi_502_: type_19;
    var phi_504_: type_19;
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

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = global;
            let _e29 = global_1;
            let _e30 = global_2;
            let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 16u) + _e28.x);
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
                let _e62 = ((_e58 + 1u) < _e60);
                if _e62 {
                    let _e64 = ((_e58 + _e60) / 2u);
                    let _e68 = global_5.member[(2u * _e64)];
                    let _e69 = (_e68 <= _e50);
                    phi_83_ = select(_e58, _e64, _e69);
                    phi_86_ = select(_e64, _e60, _e69);
                } else {
                    phi_83_ = u32();
                    phi_86_ = u32();
                }
                let _e73 = phi_83_;
                let _e75 = phi_86_;
                continue;
                continuing {
                    phi_82_ = _e73;
                    phi_85_ = _e75;
                    break if !(_e62);
                }
            }
            let _e78 = local;
            let _e79 = (2u * _e78);
            let _e83 = global_5.member[(_e79 + 1u)];
            let _e86 = global_5.member[_e79];
            if (_e56 == 0u) {
                break;
            }
            let _e92 = ((_e83 + ((_e50 - _e86) / _e56)) + _e29.z);
            phi_117_ = 0u;
            phi_120_ = _e53;
            loop {
                let _e94 = phi_117_;
                let _e96 = phi_120_;
                local_1 = _e94;
                let _e97 = (_e94 + 1u);
                let _e98 = (_e97 < _e96);
                local_2 = _e97;
                if _e98 {
                    let _e100 = ((_e94 + _e96) / 2u);
                    let _e105 = global_5.member[((2u * _e100) + 1u)];
                    let _e106 = (_e105 <= _e92);
                    phi_118_ = select(_e94, _e100, _e106);
                    phi_121_ = select(_e100, _e96, _e106);
                } else {
                    phi_118_ = u32();
                    phi_121_ = u32();
                }
                let _e110 = phi_118_;
                let _e112 = phi_121_;
                continue;
                continuing {
                    phi_117_ = _e110;
                    phi_120_ = _e112;
                    break if !(_e98);
                }
            }
            let _e115 = local_1;
            let _e116 = (2u * _e115);
            let _e119 = global_5.member[_e116];
            let _e123 = global_5.member[(_e116 + 1u)];
            let _e126 = (_e119 + ((_e92 - _e123) * _e56));
            let _e127 = (_e126 + _e56);
            let _e129 = local_2;
            let _e133 = global_5.member[(2u * _e129)];
            let _e135 = select(_e133, _e127, (_e127 < _e133));
            if (_e126 > _e50) {
                phi_158_ = (_e126 - _e50);
            } else {
                phi_158_ = 0u;
            }
            let _e139 = phi_158_;
            if (_e135 > _e50) {
                let _e141 = (_e135 - _e50);
                let _e144 = global_6.member.member;
                phi_168_ = select(_e144, _e141, (_e141 < _e144));
            } else {
                phi_168_ = 0u;
            }
            let _e148 = phi_168_;
            if (_e38 < ((_e46 + 2u) * _e41)) {
                if (_e139 < _e148) {
                    let _e153 = (_e41 == 0u);
                    if _e153 {
                        break;
                    }
                    let _e154 = (_e38 / _e41);
                    if _e153 {
                        break;
                    }
                    let _e155 = (_e38 % _e41);
                    let _e158 = global_6.member.member_9;
                    if (_e158 == 0u) {
                        break;
                    }
                    let _e163 = global_6.member.member_10;
                    let _e165 = (((_e92 % _e158) * _e163) + _e155);
                    let _e167 = select(false, true, (_e126 < _e50));
                    let _e171 = global_6.member.member_2;
                    let _e172 = ((4u * _e155) * _e171);
                    if (_e154 < (_e46 + 1u)) {
                        let _e293 = (_e154 * 4u);
                        let _e296 = global_6.member.member_5;
                        let _e299 = ((_e165 + _e296) + (_e293 * _e41));
                        let _e300 = (_e45 - _e293);
                        let _e304 = (_e299 + (select(_e300, 1u, (1u < _e300)) * _e41));
                        let _e308 = (_e299 + (select(_e300, 2u, (2u < _e300)) * _e41));
                        let _e312 = (_e299 + (select(_e300, 3u, (3u < _e300)) * _e41));
                        if _e167 {
                            let _e315 = global_7.member[_e299];
                            phi_330_ = _e315;
                        } else {
                            phi_330_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e317 = phi_330_;
                        if _e167 {
                            let _e325 = global_7.member[_e304];
                            phi_341_ = _e325;
                        } else {
                            phi_341_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e327 = phi_341_;
                        if _e167 {
                            let _e335 = global_7.member[_e308];
                            phi_352_ = _e335;
                        } else {
                            phi_352_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e337 = phi_352_;
                        if _e167 {
                            let _e345 = global_7.member[_e312];
                            phi_363_ = _e345;
                        } else {
                            phi_363_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e347 = phi_363_;
                        let _e353 = (_e293 * _e171);
                        let _e354 = (_e293 + 1u);
                        let _e357 = (select(_e45, _e354, (_e354 < _e45)) * _e171);
                        let _e358 = (_e293 + 2u);
                        let _e361 = (select(_e45, _e358, (_e358 < _e45)) * _e171);
                        let _e362 = (_e293 + 3u);
                        let _e365 = (select(_e45, _e362, (_e362 < _e45)) * _e171);
                        phi_383_ = type_19(_e347.x, _e347.y, _e347.z, _e347.w);
                        phi_386_ = type_19(_e337.x, _e337.y, _e337.z, _e337.w);
                        phi_388_ = type_19(_e327.x, _e327.y, _e327.z, _e327.w);
                        phi_390_ = type_19(_e317.x, _e317.y, _e317.z, _e317.w);
                        phi_392_ = _e139;
                        loop {
                            let _e367 = phi_383_;
                            let _e369 = phi_386_;
                            let _e371 = phi_388_;
                            let _e373 = phi_390_;
                            let _e375 = phi_392_;
                            local_11 = _e373;
                            local_12 = _e373;
                            local_13 = _e373;
                            local_14 = _e373;
                            local_15 = _e371;
                            local_16 = _e371;
                            local_17 = _e371;
                            local_18 = _e371;
                            local_19 = _e369;
                            local_20 = _e369;
                            local_21 = _e369;
                            local_22 = _e369;
                            local_23 = _e367;
                            local_24 = _e367;
                            local_25 = _e367;
                            local_26 = _e367;
                            local_44 = _e375;
                            let _e376 = (_e375 + 1u);
                            let _e377 = (_e376 <= _e148);
                            if _e377 {
                                let _e378 = (_e172 + _e375);
                                let _e381 = global_4.member[_e378];
                                let _e385 = global_4.member[(_e378 + _e171)];
                                let _e390 = global_4.member[(_e378 + (2u * _e171))];
                                let _e395 = global_4.member[(_e378 + (3u * _e171))];
                                let _e399 = global_3.member[(_e353 + _e375)];
                                let _e416 = global_3.member[(_e357 + _e375)];
                                let _e433 = global_3.member[(_e361 + _e375)];
                                let _e450 = global_3.member[(_e365 + _e375)];
                                phi_384_ = type_19(((_e450 * _e381) + _e367.member), ((_e450 * _e385) + _e367.member_1), ((_e450 * _e390) + _e367.member_2), ((_e450 * _e395) + _e367.member_3));
                                phi_387_ = type_19(((_e433 * _e381) + _e369.member), ((_e433 * _e385) + _e369.member_1), ((_e433 * _e390) + _e369.member_2), ((_e433 * _e395) + _e369.member_3));
                                phi_389_ = type_19(((_e416 * _e381) + _e371.member), ((_e416 * _e385) + _e371.member_1), ((_e416 * _e390) + _e371.member_2), ((_e416 * _e395) + _e371.member_3));
                                phi_391_ = type_19(((_e399 * _e381) + _e373.member), ((_e399 * _e385) + _e373.member_1), ((_e399 * _e390) + _e373.member_2), ((_e399 * _e395) + _e373.member_3));
                            } else {
                                phi_384_ = type_19();
                                phi_387_ = type_19();
                                phi_389_ = type_19();
                                phi_391_ = type_19();
                            }
                            let _e465 = phi_384_;
                            let _e467 = phi_387_;
                            let _e469 = phi_389_;
                            let _e471 = phi_391_;
                            continue;
                            continuing {
                                phi_383_ = _e465;
                                phi_386_ = _e467;
                                phi_388_ = _e469;
                                phi_390_ = _e471;
                                phi_392_ = select(u32(), _e376, _e377);
                                break if !(_e377);
                            }
                        }
                        let _e475 = local_11;
                        let _e478 = local_12;
                        let _e481 = local_13;
                        let _e484 = local_14;
                        let _e487 = local_15;
                        let _e490 = local_16;
                        let _e493 = local_17;
                        let _e496 = local_18;
                        let _e499 = local_19;
                        let _e502 = local_20;
                        let _e505 = local_21;
                        let _e508 = local_22;
                        let _e511 = local_23;
                        let _e514 = local_24;
                        let _e517 = local_25;
                        let _e520 = local_26;
                        phi_496_ = type_19(0f, 0f, 0f, 0f);
                        phi_499_ = type_19(0f, 0f, 0f, 0f);
                        phi_501_ = type_19(0f, 0f, 0f, 0f);
                        phi_503_ = type_19(0f, 0f, 0f, 0f);
                        let _e774 = local_44;
                        phi_505_ = _e774;
                        loop {
                            let _e523 = phi_496_;
                            let _e525 = phi_499_;
                            let _e527 = phi_501_;
                            let _e529 = phi_503_;
                            let _e531 = phi_505_;
                            local_27 = _e529;
                            local_28 = _e529;
                            local_29 = _e529;
                            local_30 = _e529;
                            local_31 = _e527;
                            local_32 = _e527;
                            local_33 = _e527;
                            local_34 = _e527;
                            local_35 = _e525;
                            local_36 = _e525;
                            local_37 = _e525;
                            local_38 = _e525;
                            local_39 = _e523;
                            local_40 = _e523;
                            local_41 = _e523;
                            local_42 = _e523;
                            let _e532 = (_e531 + 1u);
                            let _e533 = (_e532 <= _e148);
                            if _e533 {
                                let _e534 = (_e172 + _e531);
                                let _e537 = global_4.member[_e534];
                                let _e541 = global_4.member[(_e534 + _e171)];
                                let _e546 = global_4.member[(_e534 + (2u * _e171))];
                                let _e551 = global_4.member[(_e534 + (3u * _e171))];
                                let _e555 = global_3.member[(_e353 + _e531)];
                                let _e572 = global_3.member[(_e357 + _e531)];
                                let _e589 = global_3.member[(_e361 + _e531)];
                                let _e606 = global_3.member[(_e365 + _e531)];
                                phi_497_ = type_19(((_e606 * _e537) + _e523.member), ((_e606 * _e541) + _e523.member_1), ((_e606 * _e546) + _e523.member_2), ((_e606 * _e551) + _e523.member_3));
                                phi_500_ = type_19(((_e589 * _e537) + _e525.member), ((_e589 * _e541) + _e525.member_1), ((_e589 * _e546) + _e525.member_2), ((_e589 * _e551) + _e525.member_3));
                                phi_502_ = type_19(((_e572 * _e537) + _e527.member), ((_e572 * _e541) + _e527.member_1), ((_e572 * _e546) + _e527.member_2), ((_e572 * _e551) + _e527.member_3));
                                phi_504_ = type_19(((_e555 * _e537) + _e529.member), ((_e555 * _e541) + _e529.member_1), ((_e555 * _e546) + _e529.member_2), ((_e555 * _e551) + _e529.member_3));
                            } else {
                                phi_497_ = type_19();
                                phi_500_ = type_19();
                                phi_502_ = type_19();
                                phi_504_ = type_19();
                            }
                            let _e621 = phi_497_;
                            let _e623 = phi_500_;
                            let _e625 = phi_502_;
                            let _e627 = phi_504_;
                            continue;
                            continuing {
                                phi_496_ = _e621;
                                phi_499_ = _e623;
                                phi_501_ = _e625;
                                phi_503_ = _e627;
                                phi_505_ = select(u32(), _e532, _e533);
                                break if !(_e533);
                            }
                        }
                        let _e631 = local_27;
                        let _e635 = local_28;
                        let _e639 = local_29;
                        let _e643 = local_30;
                        global_7.member[_e299] = vec4<f32>((_e475.member + _e631.member), (_e478.member_1 + _e635.member_1), (_e481.member_2 + _e639.member_2), (_e484.member_3 + _e643.member_3));
                        if (_e354 < _e44) {
                            let _e651 = local_31;
                            let _e655 = local_32;
                            let _e659 = local_33;
                            let _e663 = local_34;
                            global_7.member[_e304] = vec4<f32>((_e487.member + _e651.member), (_e490.member_1 + _e655.member_1), (_e493.member_2 + _e659.member_2), (_e496.member_3 + _e663.member_3));
                        }
                        if (_e358 < _e44) {
                            let _e671 = local_35;
                            let _e675 = local_36;
                            let _e679 = local_37;
                            let _e683 = local_38;
                            global_7.member[_e308] = vec4<f32>((_e499.member + _e671.member), (_e502.member_1 + _e675.member_1), (_e505.member_2 + _e679.member_2), (_e508.member_3 + _e683.member_3));
                        }
                        if (_e362 < _e44) {
                            let _e691 = local_39;
                            let _e695 = local_40;
                            let _e699 = local_41;
                            let _e703 = local_42;
                            global_7.member[_e312] = vec4<f32>((_e511.member + _e691.member), (_e514.member_1 + _e695.member_1), (_e517.member_2 + _e699.member_2), (_e520.member_3 + _e703.member_3));
                        }
                    } else {
                        let _e176 = global_6.member.member_6;
                        let _e177 = (_e165 + _e176);
                        if _e167 {
                            let _e180 = global_7.member[_e177];
                            phi_214_ = _e180;
                        } else {
                            phi_214_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e182 = phi_214_;
                        phi_221_ = _e139;
                        phi_224_ = type_19(_e182.x, _e182.y, _e182.z, _e182.w);
                        loop {
                            let _e189 = phi_221_;
                            let _e191 = phi_224_;
                            local_3 = _e191;
                            local_4 = _e191;
                            local_5 = _e191;
                            local_6 = _e191;
                            local_43 = _e189;
                            let _e192 = (_e189 + 1u);
                            let _e193 = (_e192 <= _e148);
                            if _e193 {
                                let _e194 = (_e172 + _e189);
                                let _e197 = global_4.member[_e194];
                                let _e201 = global_4.member[(_e194 + _e171)];
                                let _e206 = global_4.member[(_e194 + (2u * _e171))];
                                let _e211 = global_4.member[(_e194 + (3u * _e171))];
                                phi_225_ = type_19((_e191.member + _e197), (_e191.member_1 + _e201), (_e191.member_2 + _e206), (_e191.member_3 + _e211));
                            } else {
                                phi_225_ = type_19();
                            }
                            let _e222 = phi_225_;
                            continue;
                            continuing {
                                phi_221_ = select(u32(), _e192, _e193);
                                phi_224_ = _e222;
                                break if !(_e193);
                            }
                        }
                        let _e226 = local_3;
                        let _e229 = local_4;
                        let _e232 = local_5;
                        let _e235 = local_6;
                        let _e732 = local_43;
                        phi_261_ = _e732;
                        phi_264_ = type_19(0f, 0f, 0f, 0f);
                        loop {
                            let _e238 = phi_261_;
                            let _e240 = phi_264_;
                            local_7 = _e240;
                            local_8 = _e240;
                            local_9 = _e240;
                            local_10 = _e240;
                            let _e241 = (_e238 + 1u);
                            let _e242 = (_e241 <= _e148);
                            if _e242 {
                                let _e243 = (_e172 + _e238);
                                let _e246 = global_4.member[_e243];
                                let _e250 = global_4.member[(_e243 + _e171)];
                                let _e255 = global_4.member[(_e243 + (2u * _e171))];
                                let _e260 = global_4.member[(_e243 + (3u * _e171))];
                                phi_265_ = type_19((_e240.member + _e246), (_e240.member_1 + _e250), (_e240.member_2 + _e255), (_e240.member_3 + _e260));
                            } else {
                                phi_265_ = type_19();
                            }
                            let _e271 = phi_265_;
                            continue;
                            continuing {
                                phi_261_ = select(u32(), _e241, _e242);
                                phi_264_ = _e271;
                                break if !(_e242);
                            }
                        }
                        let _e275 = local_7;
                        let _e279 = local_8;
                        let _e283 = local_9;
                        let _e287 = local_10;
                        global_7.member[_e177] = vec4<f32>((_e226.member + _e275.member), (_e229.member_1 + _e279.member_1), (_e232.member_2 + _e283.member_2), (_e235.member_3 + _e287.member_3));
                    }
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
