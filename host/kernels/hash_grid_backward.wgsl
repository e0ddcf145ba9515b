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
    member_7: u32,
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
    var phi_220_: u32;
    var phi_223_: u32;
    var phi_225_: f32;
    var phi_227_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_304_: f32;
    var phi_324_: f32;
    var phi_344_: f32;
    var phi_368_: u32;
    var phi_388_: u32;
    var phi_407_: u32;
    var phi_426_: u32;
    var phi_445_: u32;
    var phi_464_: u32;
    var phi_483_: u32;
    var phi_502_: u32;
    var phi_563_: u32;
    var phi_566_: u32;
    var phi_585_: f32;
    var phi_603_: u32;
    var phi_617_: u32;
    var phi_619_: array<u32, 2>;
    var phi_640_: f32;
    var phi_658_: u32;
    var phi_672_: u32;
    var phi_674_: array<u32, 2>;
    var phi_695_: f32;
    var phi_713_: u32;
    var phi_727_: u32;
    var phi_729_: array<u32, 2>;
    var phi_750_: f32;
    var phi_768_: u32;
    var phi_782_: u32;
    var phi_784_: array<u32, 2>;
    var phi_805_: f32;
    var phi_823_: u32;
    var phi_837_: u32;
    var phi_839_: array<u32, 2>;
    var phi_860_: f32;
    var phi_878_: u32;
    var phi_892_: u32;
    var phi_894_: array<u32, 2>;
    var phi_915_: f32;
    var phi_933_: u32;
    var phi_947_: u32;
    var phi_949_: array<u32, 2>;
    var phi_970_: f32;
    var phi_988_: u32;
    var phi_1002_: u32;
    var phi_1004_: array<u32, 2>;
    var local_3: u32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e37 = global_1;
            let _e38 = global_2;
            let _e46 = (((_e37.x + (_e37.y * _e38.x)) * 64u) + _e36.x);
            let _e49 = global_4.member.member;
            if (_e46 < _e49) {
                let _e53 = global_4.member.member_3;
                let _e57 = global_4.member.member_2;
                let _e62 = global_4.member.member_7;
                let _e65 = global_4.member.member_5;
                let _e66 = (_e65 == 0u);
                if _e66 {
                    break;
                }
                let _e67 = (_e46 / _e65);
                let _e70 = global_4.member.member_1;
                if _e66 {
                    break;
                }
                let _e73 = (_e46 % _e65);
                let _e76 = (((_e67 * (_e62 * _e70)) + _e73) + ((_e57 + (_e37.z * _e53)) * _e70));
                let _e79 = global_7.member[2u];
                phi_220_ = 0u;
                phi_223_ = _e76;
                phi_225_ = 0f;
                phi_227_ = 0f;
                loop {
                    let _e81 = phi_220_;
                    let _e83 = phi_223_;
                    let _e85 = phi_225_;
                    let _e87 = phi_227_;
                    local = _e85;
                    local_1 = _e87;
                    local_2 = _e85;
                    if (_e81 < _e53) {
                        let _e91 = global_6.member[_e83];
                        let _e92 = -(_e91);
                        let _e94 = select(_e92, _e91, (_e91 > _e92));
                        local_3 = (_e81 + 1u);
                        local_4 = (_e83 + _e70);
                        local_5 = select(1f, _e85, (_e94 <= _e79));
                        local_6 = select(_e94, _e87, (_e87 > _e94));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e886 = local_3;
                        phi_220_ = _e886;
                        let _e889 = local_4;
                        phi_223_ = _e889;
                        let _e892 = local_5;
                        phi_225_ = _e892;
                        let _e895 = local_6;
                        phi_227_ = _e895;
                    }
                }
                let _e102 = local;
                if (0f < _e102) {
                    let _e106 = atomicMax((&global_10.member[0u]), 1u);
                }
                let _e108 = local_1;
                let _e111 = local_2;
                let _e113 = select(false, (_e111 < 1f), (0.000000000000000000000000000000000000011754944f <= _e108));
                if _e113 {
                    let _e116 = global_5.member[_e37.z];
                    let _e119 = global_4.member.member_6;
                    if _e66 {
                        break;
                    }
                    if _e66 {
                        break;
                    }
                    let _e122 = ((_e67 * (_e119 * _e70)) + _e73);
                    let _e125 = global_3.member[_e122];
                    let _e126 = (3u * _e70);
                    let _e130 = global_3.member[(_e122 + _e126)];
                    let _e131 = (_e70 + _e122);
                    let _e134 = global_3.member[_e131];
                    let _e138 = global_3.member[(_e131 + _e126)];
                    let _e140 = ((2u * _e70) + _e122);
                    let _e143 = global_3.member[_e140];
                    let _e147 = global_3.member[(_e140 + _e126)];
                    let _e150 = global_4.member.member_4;
                    let _e151 = (_e150 != 0u);
                    let _e152 = (_e125 + _e130);
                    let _e155 = select(false, (_e152 < 1f), (0f < _e152));
                    let _e158 = select(select(0f, 1f, (1f <= _e152)), _e125, _e155);
                    let _e161 = (_e158 * _e116.member);
                    let _e164 = (_e116.member + _e116.member_1);
                    let _e168 = trunc(_e161);
                    let _e170 = ((_e161 - _e168) + (((_e158 * _e116.member_1) + (select(0f, _e130, _e155) * _e164)) + 0.5f));
                    let _e172 = select(0f, _e170, (_e170 > 0f));
                    let _e173 = trunc(_e172);
                    let _e174 = (_e172 - _e173);
                    let _e175 = (_e168 + _e173);
                    let _e180 = select(select(u32(_e175), 0u, (_e175 < 0f)), 4294967295u, (_e175 > 4294967000f));
                    if _e151 {
                        phi_304_ = ((_e174 * _e174) * (3f - (2f * _e174)));
                    } else {
                        phi_304_ = _e174;
                    }
                    let _e186 = phi_304_;
                    let _e187 = (_e134 + _e138);
                    let _e190 = select(false, (_e187 < 1f), (0f < _e187));
                    let _e193 = select(select(0f, 1f, (1f <= _e187)), _e134, _e190);
                    let _e195 = (_e193 * _e116.member);
                    let _e200 = trunc(_e195);
                    let _e202 = ((_e195 - _e200) + (((_e193 * _e116.member_1) + (select(0f, _e138, _e190) * _e164)) + 0.5f));
                    let _e204 = select(0f, _e202, (_e202 > 0f));
                    let _e205 = trunc(_e204);
                    let _e206 = (_e204 - _e205);
                    let _e207 = (_e200 + _e205);
                    let _e212 = select(select(u32(_e207), 0u, (_e207 < 0f)), 4294967295u, (_e207 > 4294967000f));
                    if _e151 {
                        phi_324_ = ((_e206 * _e206) * (3f - (2f * _e206)));
                    } else {
                        phi_324_ = _e206;
                    }
                    let _e218 = phi_324_;
                    let _e219 = (_e143 + _e147);
                    let _e222 = select(false, (_e219 < 1f), (0f < _e219));
                    let _e225 = select(select(0f, 1f, (1f <= _e219)), _e143, _e222);
                    let _e227 = (_e225 * _e116.member);
                    let _e232 = trunc(_e227);
                    let _e234 = ((_e227 - _e232) + (((_e225 * _e116.member_1) + (select(0f, _e147, _e222) * _e164)) + 0.5f));
                    let _e236 = select(0f, _e234, (_e234 > 0f));
                    let _e237 = trunc(_e236);
                    let _e238 = (_e236 - _e237);
                    let _e239 = (_e232 + _e237);
                    let _e244 = select(select(u32(_e239), 0u, (_e239 < 0f)), 4294967295u, (_e239 > 4294967000f));
                    if _e151 {
                        phi_344_ = ((_e238 * _e238) * (3f - (2f * _e238)));
                    } else {
                        phi_344_ = _e238;
                    }
                    let _e250 = phi_344_;
                    let _e251 = (_e180 + 1u);
                    let _e252 = (_e212 + 1u);
                    let _e253 = (_e244 + 1u);
                    let _e256 = (_e116.member_5 == 0u);
                    if _e256 {
                        let _e267 = (_e180 + ((_e212 + (_e244 * _e116.member_2)) * _e116.member_2));
                        phi_368_ = select((_e267 - _e116.member_4), _e267, (_e267 < _e116.member_4));
                    } else {
                        phi_368_ = (((_e180 ^ (_e212 * 2654435761u)) ^ (_e244 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e272 = phi_368_;
                    if _e256 {
                        let _e285 = (_e251 + ((_e212 + (_e244 * _e116.member_2)) * _e116.member_2));
                        phi_388_ = select((_e285 - _e116.member_4), _e285, (_e285 < _e116.member_4));
                    } else {
                        phi_388_ = (((_e251 ^ (_e212 * 2654435761u)) ^ (_e244 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e290 = phi_388_;
                    if _e256 {
                        let _e302 = (_e180 + ((_e252 + (_e244 * _e116.member_2)) * _e116.member_2));
                        phi_407_ = select((_e302 - _e116.member_4), _e302, (_e302 < _e116.member_4));
                    } else {
                        phi_407_ = (((_e180 ^ (_e252 * 2654435761u)) ^ (_e244 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e307 = phi_407_;
                    if _e256 {
                        let _e319 = (_e251 + ((_e252 + (_e244 * _e116.member_2)) * _e116.member_2));
                        phi_426_ = select((_e319 - _e116.member_4), _e319, (_e319 < _e116.member_4));
                    } else {
                        phi_426_ = (((_e251 ^ (_e252 * 2654435761u)) ^ (_e244 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e324 = phi_426_;
                    if _e256 {
                        let _e336 = (_e180 + ((_e212 + (_e253 * _e116.member_2)) * _e116.member_2));
                        phi_445_ = select((_e336 - _e116.member_4), _e336, (_e336 < _e116.member_4));
                    } else {
                        phi_445_ = (((_e180 ^ (_e212 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e341 = phi_445_;
                    if _e256 {
                        let _e353 = (_e251 + ((_e212 + (_e253 * _e116.member_2)) * _e116.member_2));
                        phi_464_ = select((_e353 - _e116.member_4), _e353, (_e353 < _e116.member_4));
                    } else {
                        phi_464_ = (((_e251 ^ (_e212 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e358 = phi_464_;
                    if _e256 {
                        let _e370 = (_e180 + ((_e252 + (_e253 * _e116.member_2)) * _e116.member_2));
                        phi_483_ = select((_e370 - _e116.member_4), _e370, (_e370 < _e116.member_4));
                    } else {
                        phi_483_ = (((_e180 ^ (_e252 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e375 = phi_483_;
                    if _e256 {
                        let _e387 = (_e251 + ((_e252 + (_e253 * _e116.member_2)) * _e116.member_2));
                        phi_502_ = select((_e387 - _e116.member_4), _e387, (_e387 < _e116.member_4));
                    } else {
                        phi_502_ = (((_e251 ^ (_e252 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e116.member_4 - 1u));
                    }
                    let _e392 = phi_502_;
                    let _e394 = (1f - _e186);
                    let _e395 = (1f - _e218);
                    let _e396 = (1f - _e250);
                    let _e397 = (_e394 * _e395);
                    let _e398 = (_e186 * _e395);
                    let _e399 = (_e394 * _e218);
                    let _e400 = (_e186 * _e218);
                    let _e409 = ((_e272 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e413 = atomicMax((&global_9.member[(_e409 / 64u)]), 1u);
                    }
                    let _e414 = ((_e290 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e418 = atomicMax((&global_9.member[(_e414 / 64u)]), 1u);
                    }
                    let _e419 = ((_e307 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e423 = atomicMax((&global_9.member[(_e419 / 64u)]), 1u);
                    }
                    let _e424 = ((_e324 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e428 = atomicMax((&global_9.member[(_e424 / 64u)]), 1u);
                    }
                    let _e429 = ((_e341 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e433 = atomicMax((&global_9.member[(_e429 / 64u)]), 1u);
                    }
                    let _e434 = ((_e358 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e438 = atomicMax((&global_9.member[(_e434 / 64u)]), 1u);
                    }
                    let _e439 = ((_e375 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e443 = atomicMax((&global_9.member[(_e439 / 64u)]), 1u);
                    }
                    let _e444 = ((_e392 + _e116.member_3) * _e53);
                    if _e113 {
                        let _e448 = atomicMax((&global_9.member[(_e444 / 64u)]), 1u);
                    }
                    let _e451 = global_7.member[0u];
                    phi_563_ = 0u;
                    phi_566_ = _e76;
                    loop {
                        let _e453 = phi_563_;
                        let _e455 = phi_566_;
                        if (_e453 < _e53) {
                            let _e459 = global_6.member[_e455];
                            let _e460 = -(_e459);
                            let _e465 = select(0f, (_e459 * _e451), (0.000000000000000000000000000000000000011754944f <= select(_e460, _e459, (_e459 > _e460))));
                            let _e466 = (_e465 * (_e397 * _e396));
                            if _e113 {
                                let _e468 = (_e466 < 0f);
                                if _e468 {
                                    phi_585_ = -(_e466);
                                } else {
                                    phi_585_ = _e466;
                                }
                                let _e471 = phi_585_;
                                let _e472 = (_e471 * 0.00000000023283064f);
                                let _e477 = select(select(u32(_e472), 0u, (_e472 < 0f)), 4294967295u, (_e472 > 4294967000f));
                                let _e480 = (_e471 - (f32(_e477) * 4294967300f));
                                let _e485 = select(select(u32(_e480), 0u, (_e480 < 0f)), 4294967295u, (_e480 > 4294967000f));
                                if ((_e480 - f32(_e485)) >= 0.5f) {
                                    phi_603_ = (_e485 + 1u);
                                } else {
                                    phi_603_ = _e485;
                                }
                                let _e491 = phi_603_;
                                if _e468 {
                                    let _e494 = (~(_e491) + 1u);
                                    if (_e494 == 0u) {
                                        phi_617_ = (~(_e477) + 1u);
                                    } else {
                                        phi_617_ = ~(_e477);
                                    }
                                    let _e500 = phi_617_;
                                    phi_619_ = array<u32, 2>(_e494, _e500);
                                } else {
                                    phi_619_ = array<u32, 2>(_e491, _e477);
                                }
                                let _e503 = phi_619_;
                                let _e506 = (2u * (_e409 + _e453));
                                let _e509 = atomicAdd((&global_8.member[_e506]), _e503[0]);
                                let _e517 = atomicAdd((&global_8.member[(_e506 + 1u)]), (_e503[1] + select(0u, 1u, ((_e509 + _e503[0]) < _e503[0]))));
                            }
                            let _e518 = (_e465 * (_e398 * _e396));
                            if _e113 {
                                let _e520 = (_e518 < 0f);
                                if _e520 {
                                    phi_640_ = -(_e518);
                                } else {
                                    phi_640_ = _e518;
                                }
                                let _e523 = phi_640_;
                                let _e524 = (_e523 * 0.00000000023283064f);
                                let _e529 = select(select(u32(_e524), 0u, (_e524 < 0f)), 4294967295u, (_e524 > 4294967000f));
                                let _e532 = (_e523 - (f32(_e529) * 4294967300f));
                                let _e537 = select(select(u32(_e532), 0u, (_e532 < 0f)), 4294967295u, (_e532 > 4294967000f));
                                if ((_e532 - f32(_e537)) >= 0.5f) {
                                    phi_658_ = (_e537 + 1u);
                                } else {
                                    phi_658_ = _e537;
                                }
                                let _e543 = phi_658_;
                                if _e520 {
                                    let _e546 = (~(_e543) + 1u);
                                    if (_e546 == 0u) {
                                        phi_672_ = (~(_e529) + 1u);
                                    } else {
                                        phi_672_ = ~(_e529);
                                    }
                                    let _e552 = phi_672_;
                                    phi_674_ = array<u32, 2>(_e546, _e552);
                                } else {
                                    phi_674_ = array<u32, 2>(_e543, _e529);
                                }
                                let _e555 = phi_674_;
                                let _e558 = (2u * (_e414 + _e453));
                                let _e561 = atomicAdd((&global_8.member[_e558]), _e555[0]);
                                let _e569 = atomicAdd((&global_8.member[(_e558 + 1u)]), (_e555[1] + select(0u, 1u, ((_e561 + _e555[0]) < _e555[0]))));
                            }
                            let _e570 = (_e465 * (_e399 * _e396));
                            if _e113 {
                                let _e572 = (_e570 < 0f);
                                if _e572 {
                                    phi_695_ = -(_e570);
                                } else {
                                    phi_695_ = _e570;
                                }
                                let _e575 = phi_695_;
                                let _e576 = (_e575 * 0.00000000023283064f);
                                let _e581 = select(select(u32(_e576), 0u, (_e576 < 0f)), 4294967295u, (_e576 > 4294967000f));
                                let _e584 = (_e575 - (f32(_e581) * 4294967300f));
                                let _e589 = select(select(u32(_e584), 0u, (_e584 < 0f)), 4294967295u, (_e584 > 4294967000f));
                                if ((_e584 - f32(_e589)) >= 0.5f) {
                                    phi_713_ = (_e589 + 1u);
                                } else {
                                    phi_713_ = _e589;
                                }
                                let _e595 = phi_713_;
                                if _e572 {
                                    let _e598 = (~(_e595) + 1u);
                                    if (_e598 == 0u) {
                                        phi_727_ = (~(_e581) + 1u);
                                    } else {
                                        phi_727_ = ~(_e581);
                                    }
                                    let _e604 = phi_727_;
                                    phi_729_ = array<u32, 2>(_e598, _e604);
                                } else {
                                    phi_729_ = array<u32, 2>(_e595, _e581);
                                }
                                let _e607 = phi_729_;
                                let _e610 = (2u * (_e419 + _e453));
                                let _e613 = atomicAdd((&global_8.member[_e610]), _e607[0]);
                                let _e621 = atomicAdd((&global_8.member[(_e610 + 1u)]), (_e607[1] + select(0u, 1u, ((_e613 + _e607[0]) < _e607[0]))));
                            }
                            let _e622 = (_e465 * (_e400 * _e396));
                            if _e113 {
                                let _e624 = (_e622 < 0f);
                                if _e624 {
                                    phi_750_ = -(_e622);
                                } else {
                                    phi_750_ = _e622;
                                }
                                let _e627 = phi_750_;
                                let _e628 = (_e627 * 0.00000000023283064f);
                                let _e633 = select(select(u32(_e628), 0u, (_e628 < 0f)), 4294967295u, (_e628 > 4294967000f));
                                let _e636 = (_e627 - (f32(_e633) * 4294967300f));
                                let _e641 = select(select(u32(_e636), 0u, (_e636 < 0f)), 4294967295u, (_e636 > 4294967000f));
                                if ((_e636 - f32(_e641)) >= 0.5f) {
                                    phi_768_ = (_e641 + 1u);
                                } else {
                                    phi_768_ = _e641;
                                }
                                let _e647 = phi_768_;
                                if _e624 {
                                    let _e650 = (~(_e647) + 1u);
                                    if (_e650 == 0u) {
                                        phi_782_ = (~(_e633) + 1u);
                                    } else {
                                        phi_782_ = ~(_e633);
                                    }
                                    let _e656 = phi_782_;
                                    phi_784_ = array<u32, 2>(_e650, _e656);
                                } else {
                                    phi_784_ = array<u32, 2>(_e647, _e633);
                                }
                                let _e659 = phi_784_;
                                let _e662 = (2u * (_e424 + _e453));
                                let _e665 = atomicAdd((&global_8.member[_e662]), _e659[0]);
                                let _e673 = atomicAdd((&global_8.member[(_e662 + 1u)]), (_e659[1] + select(0u, 1u, ((_e665 + _e659[0]) < _e659[0]))));
                            }
                            let _e674 = (_e465 * (_e397 * _e250));
                            if _e113 {
                                let _e676 = (_e674 < 0f);
                                if _e676 {
                                    phi_805_ = -(_e674);
                                } else {
                                    phi_805_ = _e674;
                                }
                                let _e679 = phi_805_;
                                let _e680 = (_e679 * 0.00000000023283064f);
                                let _e685 = select(select(u32(_e680), 0u, (_e680 < 0f)), 4294967295u, (_e680 > 4294967000f));
                                let _e688 = (_e679 - (f32(_e685) * 4294967300f));
                                let _e693 = select(select(u32(_e688), 0u, (_e688 < 0f)), 4294967295u, (_e688 > 4294967000f));
                                if ((_e688 - f32(_e693)) >= 0.5f) {
                                    phi_823_ = (_e693 + 1u);
                                } else {
                                    phi_823_ = _e693;
                                }
                                let _e699 = phi_823_;
                                if _e676 {
                                    let _e702 = (~(_e699) + 1u);
                                    if (_e702 == 0u) {
                                        phi_837_ = (~(_e685) + 1u);
                                    } else {
                                        phi_837_ = ~(_e685);
                                    }
                                    let _e708 = phi_837_;
                                    phi_839_ = array<u32, 2>(_e702, _e708);
                                } else {
                                    phi_839_ = array<u32, 2>(_e699, _e685);
                                }
                                let _e711 = phi_839_;
                                let _e714 = (2u * (_e429 + _e453));
                                let _e717 = atomicAdd((&global_8.member[_e714]), _e711[0]);
                                let _e725 = atomicAdd((&global_8.member[(_e714 + 1u)]), (_e711[1] + select(0u, 1u, ((_e717 + _e711[0]) < _e711[0]))));
                            }
                            let _e726 = (_e465 * (_e398 * _e250));
                            if _e113 {
                                let _e728 = (_e726 < 0f);
                                if _e728 {
                                    phi_860_ = -(_e726);
                                } else {
                                    phi_860_ = _e726;
                                }
                                let _e731 = phi_860_;
                                let _e732 = (_e731 * 0.00000000023283064f);
                                let _e737 = select(select(u32(_e732), 0u, (_e732 < 0f)), 4294967295u, (_e732 > 4294967000f));
                                let _e740 = (_e731 - (f32(_e737) * 4294967300f));
                                let _e745 = select(select(u32(_e740), 0u, (_e740 < 0f)), 4294967295u, (_e740 > 4294967000f));
                                if ((_e740 - f32(_e745)) >= 0.5f) {
                                    phi_878_ = (_e745 + 1u);
                                } else {
                                    phi_878_ = _e745;
                                }
                                let _e751 = phi_878_;
                                if _e728 {
                                    let _e754 = (~(_e751) + 1u);
                                    if (_e754 == 0u) {
                                        phi_892_ = (~(_e737) + 1u);
                                    } else {
                                        phi_892_ = ~(_e737);
                                    }
                                    let _e760 = phi_892_;
                                    phi_894_ = array<u32, 2>(_e754, _e760);
                                } else {
                                    phi_894_ = array<u32, 2>(_e751, _e737);
                                }
                                let _e763 = phi_894_;
                                let _e766 = (2u * (_e434 + _e453));
                                let _e769 = atomicAdd((&global_8.member[_e766]), _e763[0]);
                                let _e777 = atomicAdd((&global_8.member[(_e766 + 1u)]), (_e763[1] + select(0u, 1u, ((_e769 + _e763[0]) < _e763[0]))));
                            }
                            let _e778 = (_e465 * (_e399 * _e250));
                            if _e113 {
                                let _e780 = (_e778 < 0f);
                                if _e780 {
                                    phi_915_ = -(_e778);
                                } else {
                                    phi_915_ = _e778;
                                }
                                let _e783 = phi_915_;
                                let _e784 = (_e783 * 0.00000000023283064f);
                                let _e789 = select(select(u32(_e784), 0u, (_e784 < 0f)), 4294967295u, (_e784 > 4294967000f));
                                let _e792 = (_e783 - (f32(_e789) * 4294967300f));
                                let _e797 = select(select(u32(_e792), 0u, (_e792 < 0f)), 4294967295u, (_e792 > 4294967000f));
                                if ((_e792 - f32(_e797)) >= 0.5f) {
                                    phi_933_ = (_e797 + 1u);
                                } else {
                                    phi_933_ = _e797;
                                }
                                let _e803 = phi_933_;
                                if _e780 {
                                    let _e806 = (~(_e803) + 1u);
                                    if (_e806 == 0u) {
                                        phi_947_ = (~(_e789) + 1u);
                                    } else {
                                        phi_947_ = ~(_e789);
                                    }
                                    let _e812 = phi_947_;
                                    phi_949_ = array<u32, 2>(_e806, _e812);
                                } else {
                                    phi_949_ = array<u32, 2>(_e803, _e789);
                                }
                                let _e815 = phi_949_;
                                let _e818 = (2u * (_e439 + _e453));
                                let _e821 = atomicAdd((&global_8.member[_e818]), _e815[0]);
                                let _e829 = atomicAdd((&global_8.member[(_e818 + 1u)]), (_e815[1] + select(0u, 1u, ((_e821 + _e815[0]) < _e815[0]))));
                            }
                            let _e830 = (_e465 * (_e400 * _e250));
                            if _e113 {
                                let _e832 = (_e830 < 0f);
                                if _e832 {
                                    phi_970_ = -(_e830);
                                } else {
                                    phi_970_ = _e830;
                                }
                                let _e835 = phi_970_;
                                let _e836 = (_e835 * 0.00000000023283064f);
                                let _e841 = select(select(u32(_e836), 0u, (_e836 < 0f)), 4294967295u, (_e836 > 4294967000f));
                                let _e844 = (_e835 - (f32(_e841) * 4294967300f));
                                let _e849 = select(select(u32(_e844), 0u, (_e844 < 0f)), 4294967295u, (_e844 > 4294967000f));
                                if ((_e844 - f32(_e849)) >= 0.5f) {
                                    phi_988_ = (_e849 + 1u);
                                } else {
                                    phi_988_ = _e849;
                                }
                                let _e855 = phi_988_;
                                if _e832 {
                                    let _e858 = (~(_e855) + 1u);
                                    if (_e858 == 0u) {
                                        phi_1002_ = (~(_e841) + 1u);
                                    } else {
                                        phi_1002_ = ~(_e841);
                                    }
                                    let _e864 = phi_1002_;
                                    phi_1004_ = array<u32, 2>(_e858, _e864);
                                } else {
                                    phi_1004_ = array<u32, 2>(_e855, _e841);
                                }
                                let _e867 = phi_1004_;
                                let _e870 = (2u * (_e444 + _e453));
                                let _e873 = atomicAdd((&global_8.member[_e870]), _e867[0]);
                                let _e881 = atomicAdd((&global_8.member[(_e870 + 1u)]), (_e867[1] + select(0u, 1u, ((_e873 + _e867[0]) < _e867[0]))));
                            }
                            local_7 = (_e453 + 1u);
                            local_8 = (_e455 + _e70);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e912 = local_7;
                            phi_563_ = _e912;
                            let _e915 = local_8;
                            phi_566_ = _e915;
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
