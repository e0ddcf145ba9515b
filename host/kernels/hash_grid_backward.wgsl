struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_15 {
    member: type_14,
}

struct type_17 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_3: type_5;
@group(0) @binding(0) 
var<uniform> global_4: type_15;
@group(0) @binding(1) 
var<storage> global_5: type_19;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_25;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_25;

fn function_() {
    var phi_205_: u32;
    var phi_208_: u32;
    var phi_210_: f32;
    var phi_212_: f32;
    var phi_206_: u32;
    var phi_209_: u32;
    var phi_211_: f32;
    var phi_213_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_345_: u32;
    var phi_365_: u32;
    var phi_384_: u32;
    var phi_403_: u32;
    var phi_422_: u32;
    var phi_441_: u32;
    var phi_460_: u32;
    var phi_479_: u32;
    var phi_540_: u32;
    var phi_543_: u32;
    var phi_565_: f32;
    var phi_583_: u32;
    var phi_597_: u32;
    var phi_599_: array<u32, 2>;
    var phi_620_: f32;
    var phi_638_: u32;
    var phi_652_: u32;
    var phi_654_: array<u32, 2>;
    var phi_675_: f32;
    var phi_693_: u32;
    var phi_707_: u32;
    var phi_709_: array<u32, 2>;
    var phi_730_: f32;
    var phi_748_: u32;
    var phi_762_: u32;
    var phi_764_: array<u32, 2>;
    var phi_785_: f32;
    var phi_803_: u32;
    var phi_817_: u32;
    var phi_819_: array<u32, 2>;
    var phi_840_: f32;
    var phi_858_: u32;
    var phi_872_: u32;
    var phi_874_: array<u32, 2>;
    var phi_895_: f32;
    var phi_913_: u32;
    var phi_927_: u32;
    var phi_929_: array<u32, 2>;
    var phi_950_: f32;
    var phi_968_: u32;
    var phi_982_: u32;
    var phi_984_: array<u32, 2>;
    var phi_541_: u32;
    var phi_544_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e34 = global_1;
            let _e35 = global_2;
            let _e43 = (((_e34.x + (_e34.y * _e35.x)) * 64u) + _e33.x);
            let _e46 = global_4.member.member;
            if (_e43 < _e46) {
                let _e50 = global_4.member.member_3;
                let _e54 = global_4.member.member_2;
                let _e59 = global_4.member.member_6;
                let _e62 = global_4.member.member_4;
                let _e63 = (_e62 == 0u);
                if _e63 {
                    break;
                }
                let _e64 = (_e43 / _e62);
                let _e67 = global_4.member.member_1;
                if _e63 {
                    break;
                }
                let _e70 = (_e43 % _e62);
                let _e73 = (((_e64 * (_e59 * _e67)) + _e70) + ((_e54 + (_e34.z * _e50)) * _e67));
                let _e76 = global_7.member[2u];
                phi_205_ = 0u;
                phi_208_ = _e73;
                phi_210_ = 0f;
                phi_212_ = 0f;
                loop {
                    let _e78 = phi_205_;
                    let _e80 = phi_208_;
                    let _e82 = phi_210_;
                    let _e84 = phi_212_;
                    local = _e82;
                    local_1 = _e84;
                    local_2 = _e82;
                    let _e85 = (_e78 < _e50);
                    if _e85 {
                        let _e88 = global_6.member[_e80];
                        let _e89 = -(_e88);
                        let _e91 = select(_e89, _e88, (_e88 > _e89));
                        phi_206_ = (_e78 + 1u);
                        phi_209_ = (_e80 + _e67);
                        phi_211_ = select(1f, _e82, (_e91 <= _e76));
                        phi_213_ = select(_e91, _e84, (_e84 > _e91));
                    } else {
                        phi_206_ = u32();
                        phi_209_ = u32();
                        phi_211_ = f32();
                        phi_213_ = f32();
                    }
                    let _e99 = phi_206_;
                    let _e101 = phi_209_;
                    let _e103 = phi_211_;
                    let _e105 = phi_213_;
                    continue;
                    continuing {
                        phi_205_ = _e99;
                        phi_208_ = _e101;
                        phi_210_ = _e103;
                        phi_212_ = _e105;
                        break if !(_e85);
                    }
                }
                let _e108 = local;
                if (0f < _e108) {
                    let _e112 = atomicMax((&global_10.member[0u]), 1u);
                }
                let _e114 = local_1;
                let _e117 = local_2;
                let _e119 = select(false, (_e117 < 1f), (0.000000000000000000000000000000000000011754944f <= _e114));
                if _e119 {
                    let _e122 = global_5.member[_e34.z];
                    let _e125 = global_4.member.member_5;
                    if _e63 {
                        break;
                    }
                    if _e63 {
                        break;
                    }
                    let _e128 = ((_e64 * (_e125 * _e67)) + _e70);
                    let _e131 = global_3.member[_e128];
                    let _e132 = (3u * _e67);
                    let _e136 = global_3.member[(_e128 + _e132)];
                    let _e137 = (_e67 + _e128);
                    let _e140 = global_3.member[_e137];
                    let _e144 = global_3.member[(_e137 + _e132)];
                    let _e146 = ((2u * _e67) + _e128);
                    let _e149 = global_3.member[_e146];
                    let _e153 = global_3.member[(_e146 + _e132)];
                    let _e154 = (_e131 + _e136);
                    let _e157 = select(false, (_e154 < 1f), (0f < _e154));
                    let _e160 = select(select(0f, 1f, (1f <= _e154)), _e131, _e157);
                    let _e163 = (_e160 * _e122.member);
                    let _e166 = (_e122.member + _e122.member_1);
                    let _e170 = trunc(_e163);
                    let _e172 = ((_e163 - _e170) + (((_e160 * _e122.member_1) + (select(0f, _e136, _e157) * _e166)) + 0.5f));
                    let _e174 = select(0f, _e172, (_e172 > 0f));
                    let _e175 = trunc(_e174);
                    let _e176 = (_e174 - _e175);
                    let _e177 = (_e170 + _e175);
                    let _e182 = select(select(u32(_e177), 0u, (_e177 < 0f)), 4294967295u, (_e177 > 4294967000f));
                    let _e183 = (_e140 + _e144);
                    let _e186 = select(false, (_e183 < 1f), (0f < _e183));
                    let _e189 = select(select(0f, 1f, (1f <= _e183)), _e140, _e186);
                    let _e191 = (_e189 * _e122.member);
                    let _e196 = trunc(_e191);
                    let _e198 = ((_e191 - _e196) + (((_e189 * _e122.member_1) + (select(0f, _e144, _e186) * _e166)) + 0.5f));
                    let _e200 = select(0f, _e198, (_e198 > 0f));
                    let _e201 = trunc(_e200);
                    let _e202 = (_e200 - _e201);
                    let _e203 = (_e196 + _e201);
                    let _e208 = select(select(u32(_e203), 0u, (_e203 < 0f)), 4294967295u, (_e203 > 4294967000f));
                    let _e209 = (_e149 + _e153);
                    let _e212 = select(false, (_e209 < 1f), (0f < _e209));
                    let _e215 = select(select(0f, 1f, (1f <= _e209)), _e149, _e212);
                    let _e217 = (_e215 * _e122.member);
                    let _e222 = trunc(_e217);
                    let _e224 = ((_e217 - _e222) + (((_e215 * _e122.member_1) + (select(0f, _e153, _e212) * _e166)) + 0.5f));
                    let _e226 = select(0f, _e224, (_e224 > 0f));
                    let _e227 = trunc(_e226);
                    let _e228 = (_e226 - _e227);
                    let _e229 = (_e222 + _e227);
                    let _e234 = select(select(u32(_e229), 0u, (_e229 < 0f)), 4294967295u, (_e229 > 4294967000f));
                    let _e235 = (_e182 + 1u);
                    let _e236 = (_e208 + 1u);
                    let _e237 = (_e234 + 1u);
                    let _e240 = (_e122.member_5 == 0u);
                    if _e240 {
                        let _e251 = (_e182 + ((_e208 + (_e234 * _e122.member_2)) * _e122.member_2));
                        phi_345_ = select((_e251 - _e122.member_4), _e251, (_e251 < _e122.member_4));
                    } else {
                        phi_345_ = (((_e182 ^ (_e208 * 2654435761u)) ^ (_e234 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e256 = phi_345_;
                    if _e240 {
                        let _e269 = (_e235 + ((_e208 + (_e234 * _e122.member_2)) * _e122.member_2));
                        phi_365_ = select((_e269 - _e122.member_4), _e269, (_e269 < _e122.member_4));
                    } else {
                        phi_365_ = (((_e235 ^ (_e208 * 2654435761u)) ^ (_e234 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e274 = phi_365_;
                    if _e240 {
                        let _e286 = (_e182 + ((_e236 + (_e234 * _e122.member_2)) * _e122.member_2));
                        phi_384_ = select((_e286 - _e122.member_4), _e286, (_e286 < _e122.member_4));
                    } else {
                        phi_384_ = (((_e182 ^ (_e236 * 2654435761u)) ^ (_e234 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e291 = phi_384_;
                    if _e240 {
                        let _e303 = (_e235 + ((_e236 + (_e234 * _e122.member_2)) * _e122.member_2));
                        phi_403_ = select((_e303 - _e122.member_4), _e303, (_e303 < _e122.member_4));
                    } else {
                        phi_403_ = (((_e235 ^ (_e236 * 2654435761u)) ^ (_e234 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e308 = phi_403_;
                    if _e240 {
                        let _e320 = (_e182 + ((_e208 + (_e237 * _e122.member_2)) * _e122.member_2));
                        phi_422_ = select((_e320 - _e122.member_4), _e320, (_e320 < _e122.member_4));
                    } else {
                        phi_422_ = (((_e182 ^ (_e208 * 2654435761u)) ^ (_e237 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e325 = phi_422_;
                    if _e240 {
                        let _e337 = (_e235 + ((_e208 + (_e237 * _e122.member_2)) * _e122.member_2));
                        phi_441_ = select((_e337 - _e122.member_4), _e337, (_e337 < _e122.member_4));
                    } else {
                        phi_441_ = (((_e235 ^ (_e208 * 2654435761u)) ^ (_e237 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e342 = phi_441_;
                    if _e240 {
                        let _e354 = (_e182 + ((_e236 + (_e237 * _e122.member_2)) * _e122.member_2));
                        phi_460_ = select((_e354 - _e122.member_4), _e354, (_e354 < _e122.member_4));
                    } else {
                        phi_460_ = (((_e182 ^ (_e236 * 2654435761u)) ^ (_e237 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e359 = phi_460_;
                    if _e240 {
                        let _e371 = (_e235 + ((_e236 + (_e237 * _e122.member_2)) * _e122.member_2));
                        phi_479_ = select((_e371 - _e122.member_4), _e371, (_e371 < _e122.member_4));
                    } else {
                        phi_479_ = (((_e235 ^ (_e236 * 2654435761u)) ^ (_e237 * 805459861u)) & (_e122.member_4 - 1u));
                    }
                    let _e376 = phi_479_;
                    let _e378 = (1f - _e176);
                    let _e379 = (1f - _e202);
                    let _e380 = (1f - _e228);
                    let _e381 = (_e378 * _e379);
                    let _e382 = (_e176 * _e379);
                    let _e383 = (_e378 * _e202);
                    let _e384 = (_e176 * _e202);
                    let _e393 = ((_e256 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e397 = atomicMax((&global_9.member[(_e393 / 64u)]), 1u);
                    }
                    let _e398 = ((_e274 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e402 = atomicMax((&global_9.member[(_e398 / 64u)]), 1u);
                    }
                    let _e403 = ((_e291 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e407 = atomicMax((&global_9.member[(_e403 / 64u)]), 1u);
                    }
                    let _e408 = ((_e308 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e412 = atomicMax((&global_9.member[(_e408 / 64u)]), 1u);
                    }
                    let _e413 = ((_e325 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e417 = atomicMax((&global_9.member[(_e413 / 64u)]), 1u);
                    }
                    let _e418 = ((_e342 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e422 = atomicMax((&global_9.member[(_e418 / 64u)]), 1u);
                    }
                    let _e423 = ((_e359 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e427 = atomicMax((&global_9.member[(_e423 / 64u)]), 1u);
                    }
                    let _e428 = ((_e376 + _e122.member_3) * _e50);
                    if _e119 {
                        let _e432 = atomicMax((&global_9.member[(_e428 / 64u)]), 1u);
                    }
                    let _e435 = global_7.member[0u];
                    phi_540_ = 0u;
                    phi_543_ = _e73;
                    loop {
                        let _e437 = phi_540_;
                        let _e439 = phi_543_;
                        let _e440 = (_e437 < _e50);
                        if _e440 {
                            let _e443 = global_6.member[_e439];
                            let _e444 = -(_e443);
                            let _e449 = select(0f, (_e443 * _e435), (0.000000000000000000000000000000000000011754944f <= select(_e444, _e443, (_e443 > _e444))));
                            let _e450 = (_e449 * (_e381 * _e380));
                            if _e119 {
                                let _e452 = (_e450 < 0f);
                                if _e452 {
                                    phi_565_ = -(_e450);
                                } else {
                                    phi_565_ = _e450;
                                }
                                let _e455 = phi_565_;
                                let _e456 = (_e455 * 0.00000000023283064f);
                                let _e461 = select(select(u32(_e456), 0u, (_e456 < 0f)), 4294967295u, (_e456 > 4294967000f));
                                let _e464 = (_e455 - (f32(_e461) * 4294967300f));
                                let _e469 = select(select(u32(_e464), 0u, (_e464 < 0f)), 4294967295u, (_e464 > 4294967000f));
                                if ((_e464 - f32(_e469)) >= 0.5f) {
                                    phi_583_ = (_e469 + 1u);
                                } else {
                                    phi_583_ = _e469;
                                }
                                let _e475 = phi_583_;
                                if _e452 {
                                    let _e478 = (~(_e475) + 1u);
                                    if (_e478 == 0u) {
                                        phi_597_ = (~(_e461) + 1u);
                                    } else {
                                        phi_597_ = ~(_e461);
                                    }
                                    let _e484 = phi_597_;
                                    phi_599_ = array<u32, 2>(_e478, _e484);
                                } else {
                                    phi_599_ = array<u32, 2>(_e475, _e461);
                                }
                                let _e487 = phi_599_;
                                let _e490 = (2u * (_e393 + _e437));
                                let _e493 = atomicAdd((&global_8.member[_e490]), _e487[0]);
                                let _e501 = atomicAdd((&global_8.member[(_e490 + 1u)]), (_e487[1] + select(0u, 1u, ((_e493 + _e487[0]) < _e487[0]))));
                            }
                            let _e502 = (_e449 * (_e382 * _e380));
                            if _e119 {
                                let _e504 = (_e502 < 0f);
                                if _e504 {
                                    phi_620_ = -(_e502);
                                } else {
                                    phi_620_ = _e502;
                                }
                                let _e507 = phi_620_;
                                let _e508 = (_e507 * 0.00000000023283064f);
                                let _e513 = select(select(u32(_e508), 0u, (_e508 < 0f)), 4294967295u, (_e508 > 4294967000f));
                                let _e516 = (_e507 - (f32(_e513) * 4294967300f));
                                let _e521 = select(select(u32(_e516), 0u, (_e516 < 0f)), 4294967295u, (_e516 > 4294967000f));
                                if ((_e516 - f32(_e521)) >= 0.5f) {
                                    phi_638_ = (_e521 + 1u);
                                } else {
                                    phi_638_ = _e521;
                                }
                                let _e527 = phi_638_;
                                if _e504 {
                                    let _e530 = (~(_e527) + 1u);
                                    if (_e530 == 0u) {
                                        phi_652_ = (~(_e513) + 1u);
                                    } else {
                                        phi_652_ = ~(_e513);
                                    }
                                    let _e536 = phi_652_;
                                    phi_654_ = array<u32, 2>(_e530, _e536);
                                } else {
                                    phi_654_ = array<u32, 2>(_e527, _e513);
                                }
                                let _e539 = phi_654_;
                                let _e542 = (2u * (_e398 + _e437));
                                let _e545 = atomicAdd((&global_8.member[_e542]), _e539[0]);
                                let _e553 = atomicAdd((&global_8.member[(_e542 + 1u)]), (_e539[1] + select(0u, 1u, ((_e545 + _e539[0]) < _e539[0]))));
                            }
                            let _e554 = (_e449 * (_e383 * _e380));
                            if _e119 {
                                let _e556 = (_e554 < 0f);
                                if _e556 {
                                    phi_675_ = -(_e554);
                                } else {
                                    phi_675_ = _e554;
                                }
                                let _e559 = phi_675_;
                                let _e560 = (_e559 * 0.00000000023283064f);
                                let _e565 = select(select(u32(_e560), 0u, (_e560 < 0f)), 4294967295u, (_e560 > 4294967000f));
                                let _e568 = (_e559 - (f32(_e565) * 4294967300f));
                                let _e573 = select(select(u32(_e568), 0u, (_e568 < 0f)), 4294967295u, (_e568 > 4294967000f));
                                if ((_e568 - f32(_e573)) >= 0.5f) {
                                    phi_693_ = (_e573 + 1u);
                                } else {
                                    phi_693_ = _e573;
                                }
                                let _e579 = phi_693_;
                                if _e556 {
                                    let _e582 = (~(_e579) + 1u);
                                    if (_e582 == 0u) {
                                        phi_707_ = (~(_e565) + 1u);
                                    } else {
                                        phi_707_ = ~(_e565);
                                    }
                                    let _e588 = phi_707_;
                                    phi_709_ = array<u32, 2>(_e582, _e588);
                                } else {
                                    phi_709_ = array<u32, 2>(_e579, _e565);
                                }
                                let _e591 = phi_709_;
                                let _e594 = (2u * (_e403 + _e437));
                                let _e597 = atomicAdd((&global_8.member[_e594]), _e591[0]);
                                let _e605 = atomicAdd((&global_8.member[(_e594 + 1u)]), (_e591[1] + select(0u, 1u, ((_e597 + _e591[0]) < _e591[0]))));
                            }
                            let _e606 = (_e449 * (_e384 * _e380));
                            if _e119 {
                                let _e608 = (_e606 < 0f);
                                if _e608 {
                                    phi_730_ = -(_e606);
                                } else {
                                    phi_730_ = _e606;
                                }
                                let _e611 = phi_730_;
                                let _e612 = (_e611 * 0.00000000023283064f);
                                let _e617 = select(select(u32(_e612), 0u, (_e612 < 0f)), 4294967295u, (_e612 > 4294967000f));
                                let _e620 = (_e611 - (f32(_e617) * 4294967300f));
                                let _e625 = select(select(u32(_e620), 0u, (_e620 < 0f)), 4294967295u, (_e620 > 4294967000f));
                                if ((_e620 - f32(_e625)) >= 0.5f) {
                                    phi_748_ = (_e625 + 1u);
                                } else {
                                    phi_748_ = _e625;
                                }
                                let _e631 = phi_748_;
                                if _e608 {
                                    let _e634 = (~(_e631) + 1u);
                                    if (_e634 == 0u) {
                                        phi_762_ = (~(_e617) + 1u);
                                    } else {
                                        phi_762_ = ~(_e617);
                                    }
                                    let _e640 = phi_762_;
                                    phi_764_ = array<u32, 2>(_e634, _e640);
                                } else {
                                    phi_764_ = array<u32, 2>(_e631, _e617);
                                }
                                let _e643 = phi_764_;
                                let _e646 = (2u * (_e408 + _e437));
                                let _e649 = atomicAdd((&global_8.member[_e646]), _e643[0]);
                                let _e657 = atomicAdd((&global_8.member[(_e646 + 1u)]), (_e643[1] + select(0u, 1u, ((_e649 + _e643[0]) < _e643[0]))));
                            }
                            let _e658 = (_e449 * (_e381 * _e228));
                            if _e119 {
                                let _e660 = (_e658 < 0f);
                                if _e660 {
                                    phi_785_ = -(_e658);
                                } else {
                                    phi_785_ = _e658;
                                }
                                let _e663 = phi_785_;
                                let _e664 = (_e663 * 0.00000000023283064f);
                                let _e669 = select(select(u32(_e664), 0u, (_e664 < 0f)), 4294967295u, (_e664 > 4294967000f));
                                let _e672 = (_e663 - (f32(_e669) * 4294967300f));
                                let _e677 = select(select(u32(_e672), 0u, (_e672 < 0f)), 4294967295u, (_e672 > 4294967000f));
                                if ((_e672 - f32(_e677)) >= 0.5f) {
                                    phi_803_ = (_e677 + 1u);
                                } else {
                                    phi_803_ = _e677;
                                }
                                let _e683 = phi_803_;
                                if _e660 {
                                    let _e686 = (~(_e683) + 1u);
                                    if (_e686 == 0u) {
                                        phi_817_ = (~(_e669) + 1u);
                                    } else {
                                        phi_817_ = ~(_e669);
                                    }
                                    let _e692 = phi_817_;
                                    phi_819_ = array<u32, 2>(_e686, _e692);
                                } else {
                                    phi_819_ = array<u32, 2>(_e683, _e669);
                                }
                                let _e695 = phi_819_;
                                let _e698 = (2u * (_e413 + _e437));
                                let _e701 = atomicAdd((&global_8.member[_e698]), _e695[0]);
                                let _e709 = atomicAdd((&global_8.member[(_e698 + 1u)]), (_e695[1] + select(0u, 1u, ((_e701 + _e695[0]) < _e695[0]))));
                            }
                            let _e710 = (_e449 * (_e382 * _e228));
                            if _e119 {
                                let _e712 = (_e710 < 0f);
                                if _e712 {
                                    phi_840_ = -(_e710);
                                } else {
                                    phi_840_ = _e710;
                                }
                                let _e715 = phi_840_;
                                let _e716 = (_e715 * 0.00000000023283064f);
                                let _e721 = select(select(u32(_e716), 0u, (_e716 < 0f)), 4294967295u, (_e716 > 4294967000f));
                                let _e724 = (_e715 - (f32(_e721) * 4294967300f));
                                let _e729 = select(select(u32(_e724), 0u, (_e724 < 0f)), 4294967295u, (_e724 > 4294967000f));
                                if ((_e724 - f32(_e729)) >= 0.5f) {
                                    phi_858_ = (_e729 + 1u);
                                } else {
                                    phi_858_ = _e729;
                                }
                                let _e735 = phi_858_;
                                if _e712 {
                                    let _e738 = (~(_e735) + 1u);
                                    if (_e738 == 0u) {
                                        phi_872_ = (~(_e721) + 1u);
                                    } else {
                                        phi_872_ = ~(_e721);
                                    }
                                    let _e744 = phi_872_;
                                    phi_874_ = array<u32, 2>(_e738, _e744);
                                } else {
                                    phi_874_ = array<u32, 2>(_e735, _e721);
                                }
                                let _e747 = phi_874_;
                                let _e750 = (2u * (_e418 + _e437));
                                let _e753 = atomicAdd((&global_8.member[_e750]), _e747[0]);
                                let _e761 = atomicAdd((&global_8.member[(_e750 + 1u)]), (_e747[1] + select(0u, 1u, ((_e753 + _e747[0]) < _e747[0]))));
                            }
                            let _e762 = (_e449 * (_e383 * _e228));
                            if _e119 {
                                let _e764 = (_e762 < 0f);
                                if _e764 {
                                    phi_895_ = -(_e762);
                                } else {
                                    phi_895_ = _e762;
                                }
                                let _e767 = phi_895_;
                                let _e768 = (_e767 * 0.00000000023283064f);
                                let _e773 = select(select(u32(_e768), 0u, (_e768 < 0f)), 4294967295u, (_e768 > 4294967000f));
                                let _e776 = (_e767 - (f32(_e773) * 4294967300f));
                                let _e781 = select(select(u32(_e776), 0u, (_e776 < 0f)), 4294967295u, (_e776 > 4294967000f));
                                if ((_e776 - f32(_e781)) >= 0.5f) {
                                    phi_913_ = (_e781 + 1u);
                                } else {
                                    phi_913_ = _e781;
                                }
                                let _e787 = phi_913_;
                                if _e764 {
                                    let _e790 = (~(_e787) + 1u);
                                    if (_e790 == 0u) {
                                        phi_927_ = (~(_e773) + 1u);
                                    } else {
                                        phi_927_ = ~(_e773);
                                    }
                                    let _e796 = phi_927_;
                                    phi_929_ = array<u32, 2>(_e790, _e796);
                                } else {
                                    phi_929_ = array<u32, 2>(_e787, _e773);
                                }
                                let _e799 = phi_929_;
                                let _e802 = (2u * (_e423 + _e437));
                                let _e805 = atomicAdd((&global_8.member[_e802]), _e799[0]);
                                let _e813 = atomicAdd((&global_8.member[(_e802 + 1u)]), (_e799[1] + select(0u, 1u, ((_e805 + _e799[0]) < _e799[0]))));
                            }
                            let _e814 = (_e449 * (_e384 * _e228));
                            if _e119 {
                                let _e816 = (_e814 < 0f);
                                if _e816 {
                                    phi_950_ = -(_e814);
                                } else {
                                    phi_950_ = _e814;
                                }
                                let _e819 = phi_950_;
                                let _e820 = (_e819 * 0.00000000023283064f);
                                let _e825 = select(select(u32(_e820), 0u, (_e820 < 0f)), 4294967295u, (_e820 > 4294967000f));
                                let _e828 = (_e819 - (f32(_e825) * 4294967300f));
                                let _e833 = select(select(u32(_e828), 0u, (_e828 < 0f)), 4294967295u, (_e828 > 4294967000f));
                                if ((_e828 - f32(_e833)) >= 0.5f) {
                                    phi_968_ = (_e833 + 1u);
                                } else {
                                    phi_968_ = _e833;
                                }
                                let _e839 = phi_968_;
                                if _e816 {
                                    let _e842 = (~(_e839) + 1u);
                                    if (_e842 == 0u) {
                                        phi_982_ = (~(_e825) + 1u);
                                    } else {
                                        phi_982_ = ~(_e825);
                                    }
                                    let _e848 = phi_982_;
                                    phi_984_ = array<u32, 2>(_e842, _e848);
                                } else {
                                    phi_984_ = array<u32, 2>(_e839, _e825);
                                }
                                let _e851 = phi_984_;
                                let _e854 = (2u * (_e428 + _e437));
                                let _e857 = atomicAdd((&global_8.member[_e854]), _e851[0]);
                                let _e865 = atomicAdd((&global_8.member[(_e854 + 1u)]), (_e851[1] + select(0u, 1u, ((_e857 + _e851[0]) < _e851[0]))));
                            }
                            phi_541_ = (_e437 + 1u);
                            phi_544_ = (_e439 + _e67);
                        } else {
                            phi_541_ = u32();
                            phi_544_ = u32();
                        }
                        let _e869 = phi_541_;
                        let _e871 = phi_544_;
                        continue;
                        continuing {
                            phi_540_ = _e869;
                            phi_543_ = _e871;
                            break if !(_e440);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
