struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_15 {
    member: array<u32>,
}

struct type_17 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_20 {
    member: array<type_17>,
}

struct type_26 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(4) 
var<storage> global_4: type_11;
@group(0) @binding(3) 
var<storage> global_5: type_11;
@group(0) @binding(7) 
var<storage, read_write> global_6: type_26;
@group(0) @binding(1) 
var<storage> global_7: type_20;
@group(0) @binding(2) 
var<storage> global_8: type_11;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_10: type_26;

fn function_() {
    var phi_195_: u32;
    var phi_198_: u32;
    var phi_200_: f32;
    var phi_202_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_387_: array<u32, 8>;
    var phi_455_: u32;
    var phi_458_: u32;
    var phi_483_: u32;
    var phi_498_: u32;
    var phi_500_: array<u32, 2>;
    var phi_532_: u32;
    var phi_547_: u32;
    var phi_549_: array<u32, 2>;
    var phi_581_: u32;
    var phi_596_: u32;
    var phi_598_: array<u32, 2>;
    var phi_630_: u32;
    var phi_645_: u32;
    var phi_647_: array<u32, 2>;
    var phi_679_: u32;
    var phi_694_: u32;
    var phi_696_: array<u32, 2>;
    var phi_728_: u32;
    var phi_743_: u32;
    var phi_745_: array<u32, 2>;
    var phi_777_: u32;
    var phi_792_: u32;
    var phi_794_: array<u32, 2>;
    var phi_826_: u32;
    var phi_841_: u32;
    var phi_843_: array<u32, 2>;
    var local_3: u32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = global;
            let _e31 = global_1;
            let _e32 = global_2;
            let _e38 = ((_e31.x + (_e31.y * _e32.x)) * 64u);
            let _e43 = global_3.member.member;
            if ((_e38 + _e30.x) < _e43) {
                let _e47 = global_3.member.member_3;
                let _e51 = global_3.member.member_2;
                let _e56 = global_3.member.member_6;
                let _e59 = global_3.member.member_4;
                let _e60 = (_e59 == 0u);
                if _e60 {
                    break;
                }
                let _e61 = (_e38 / _e59);
                let _e64 = global_3.member.member_1;
                let _e68 = (_e38 - (_e61 * _e59));
                let _e72 = ((((_e61 * (_e56 * _e64)) + _e68) + _e30.x) + ((_e51 + (_e31.z * _e47)) * _e64));
                let _e75 = global_4.member[2u];
                phi_195_ = 0u;
                phi_198_ = _e72;
                phi_200_ = 0f;
                phi_202_ = 0f;
                loop {
                    let _e77 = phi_195_;
                    let _e79 = phi_198_;
                    let _e81 = phi_200_;
                    let _e83 = phi_202_;
                    local = _e81;
                    local_1 = _e83;
                    local_2 = _e81;
                    if (_e77 < _e47) {
                        let _e87 = global_5.member[_e79];
                        let _e88 = -(_e87);
                        let _e90 = select(_e88, _e87, (_e87 > _e88));
                        local_3 = (_e77 + 1u);
                        local_4 = (_e79 + _e64);
                        local_5 = select(1f, _e81, (_e90 <= _e75));
                        local_6 = select(_e90, _e83, (_e83 > _e90));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e736 = local_3;
                        phi_195_ = _e736;
                        let _e739 = local_4;
                        phi_198_ = _e739;
                        let _e742 = local_5;
                        phi_200_ = _e742;
                        let _e745 = local_6;
                        phi_202_ = _e745;
                    }
                }
                let _e98 = local;
                if (0f < _e98) {
                    let _e102 = atomicMax((&global_6.member[0u]), 1u);
                }
                let _e104 = local_1;
                let _e107 = local_2;
                let _e109 = select(false, (_e107 < 1f), (0.000000000000000000000000000000000000011754944f <= _e104));
                if _e109 {
                    let _e112 = global_7.member[_e31.z];
                    let _e115 = global_3.member.member_5;
                    if _e60 {
                        break;
                    }
                    let _e119 = (((_e61 * (_e115 * _e64)) + _e68) + _e30.x);
                    let _e122 = global_8.member[_e119];
                    let _e123 = (3u * _e64);
                    let _e127 = global_8.member[(_e119 + _e123)];
                    let _e128 = (_e64 + _e119);
                    let _e131 = global_8.member[_e128];
                    let _e135 = global_8.member[(_e128 + _e123)];
                    let _e137 = ((2u * _e64) + _e119);
                    let _e140 = global_8.member[_e137];
                    let _e144 = global_8.member[(_e137 + _e123)];
                    let _e145 = (_e122 + _e127);
                    let _e148 = select(false, (_e145 < 1f), (0f < _e145));
                    let _e151 = select(select(0f, 1f, (1f <= _e145)), _e122, _e148);
                    let _e154 = (_e151 * _e112.member);
                    let _e157 = (_e112.member + _e112.member_1);
                    let _e161 = trunc(_e154);
                    let _e163 = ((_e154 - _e161) + (((_e151 * _e112.member_1) + (select(0f, _e127, _e148) * _e157)) + 0.5f));
                    let _e165 = select(0f, _e163, (_e163 > 0f));
                    let _e166 = trunc(_e165);
                    let _e167 = (_e165 - _e166);
                    let _e169 = u32((_e161 + _e166));
                    let _e170 = (_e131 + _e135);
                    let _e173 = select(false, (_e170 < 1f), (0f < _e170));
                    let _e176 = select(select(0f, 1f, (1f <= _e170)), _e131, _e173);
                    let _e178 = (_e176 * _e112.member);
                    let _e183 = trunc(_e178);
                    let _e185 = ((_e178 - _e183) + (((_e176 * _e112.member_1) + (select(0f, _e135, _e173) * _e157)) + 0.5f));
                    let _e187 = select(0f, _e185, (_e185 > 0f));
                    let _e188 = trunc(_e187);
                    let _e189 = (_e187 - _e188);
                    let _e191 = u32((_e183 + _e188));
                    let _e192 = (_e140 + _e144);
                    let _e195 = select(false, (_e192 < 1f), (0f < _e192));
                    let _e198 = select(select(0f, 1f, (1f <= _e192)), _e140, _e195);
                    let _e200 = (_e198 * _e112.member);
                    let _e205 = trunc(_e200);
                    let _e207 = ((_e200 - _e205) + (((_e198 * _e112.member_1) + (select(0f, _e144, _e195) * _e157)) + 0.5f));
                    let _e209 = select(0f, _e207, (_e207 > 0f));
                    let _e210 = trunc(_e209);
                    let _e211 = (_e209 - _e210);
                    let _e213 = u32((_e205 + _e210));
                    let _e214 = (1f - _e167);
                    let _e215 = (1f - _e189);
                    let _e216 = (1f - _e211);
                    let _e217 = (_e214 * _e215);
                    let _e218 = (_e167 * _e215);
                    let _e219 = (_e214 * _e189);
                    let _e220 = (_e167 * _e189);
                    if (_e112.member_5 == 0u) {
                        let _e270 = (_e112.member_2 * _e112.member_2);
                        let _e271 = (_e191 * _e112.member_2);
                        let _e272 = (_e213 * _e270);
                        let _e273 = (_e169 + 1u);
                        let _e274 = (_e271 + _e112.member_2);
                        let _e275 = (_e272 + _e270);
                        let _e276 = (_e169 + _e271);
                        let _e277 = (_e276 + _e272);
                        let _e282 = (_e273 + _e271);
                        let _e283 = (_e282 + _e272);
                        let _e288 = (_e169 + _e274);
                        let _e289 = (_e288 + _e272);
                        let _e294 = (_e273 + _e274);
                        let _e295 = (_e294 + _e272);
                        let _e300 = (_e276 + _e275);
                        let _e305 = (_e282 + _e275);
                        let _e310 = (_e288 + _e275);
                        let _e315 = (_e294 + _e275);
                        phi_387_ = array<u32, 8>((select((_e277 - _e112.member_4), _e277, (_e277 < _e112.member_4)) + _e112.member_3), (select((_e283 - _e112.member_4), _e283, (_e283 < _e112.member_4)) + _e112.member_3), (select((_e289 - _e112.member_4), _e289, (_e289 < _e112.member_4)) + _e112.member_3), (select((_e295 - _e112.member_4), _e295, (_e295 < _e112.member_4)) + _e112.member_3), (select((_e300 - _e112.member_4), _e300, (_e300 < _e112.member_4)) + _e112.member_3), (select((_e305 - _e112.member_4), _e305, (_e305 < _e112.member_4)) + _e112.member_3), (select((_e310 - _e112.member_4), _e310, (_e310 < _e112.member_4)) + _e112.member_3), (select((_e315 - _e112.member_4), _e315, (_e315 < _e112.member_4)) + _e112.member_3));
                    } else {
                        let _e233 = (_e112.member_4 - 1u);
                        let _e234 = (_e191 * 2654435761u);
                        let _e235 = (_e213 * 805459861u);
                        let _e236 = (_e169 + 1u);
                        let _e237 = (_e234 + 2654435761u);
                        let _e238 = (_e235 + 805459861u);
                        let _e239 = (_e169 ^ _e234);
                        let _e243 = (_e236 ^ _e234);
                        let _e247 = (_e169 ^ _e237);
                        let _e251 = (_e236 ^ _e237);
                        phi_387_ = array<u32, 8>((((_e239 ^ _e235) & _e233) + _e112.member_3), (((_e243 ^ _e235) & _e233) + _e112.member_3), (((_e247 ^ _e235) & _e233) + _e112.member_3), (((_e251 ^ _e235) & _e233) + _e112.member_3), (((_e239 ^ _e238) & _e233) + _e112.member_3), (((_e243 ^ _e238) & _e233) + _e112.member_3), (((_e247 ^ _e238) & _e233) + _e112.member_3), (((_e251 ^ _e238) & _e233) + _e112.member_3));
                    }
                    let _e322 = phi_387_;
                    let _e331 = (_e322[0] * _e47);
                    let _e332 = (_e322[1] * _e47);
                    let _e333 = (_e322[2] * _e47);
                    let _e334 = (_e322[3] * _e47);
                    let _e335 = (_e322[4] * _e47);
                    let _e336 = (_e322[5] * _e47);
                    let _e337 = (_e322[6] * _e47);
                    let _e338 = (_e322[7] * _e47);
                    if _e109 {
                        let _e342 = atomicMax((&global_9.member[(_e331 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e346 = atomicMax((&global_9.member[(_e332 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e350 = atomicMax((&global_9.member[(_e333 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e354 = atomicMax((&global_9.member[(_e334 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e358 = atomicMax((&global_9.member[(_e335 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e362 = atomicMax((&global_9.member[(_e336 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e366 = atomicMax((&global_9.member[(_e337 / 64u)]), 1u);
                    }
                    if _e109 {
                        let _e370 = atomicMax((&global_9.member[(_e338 / 64u)]), 1u);
                    }
                    let _e373 = global_4.member[0u];
                    phi_455_ = 0u;
                    phi_458_ = _e72;
                    loop {
                        let _e375 = phi_455_;
                        let _e377 = phi_458_;
                        if (_e375 < _e47) {
                            let _e381 = global_5.member[_e377];
                            let _e382 = -(_e381);
                            let _e387 = select(0f, (_e381 * _e373), (0.000000000000000000000000000000000000011754944f <= select(_e382, _e381, (_e381 > _e382))));
                            let _e388 = (_e387 * (_e217 * _e216));
                            if _e109 {
                                let _e390 = abs(_e388);
                                let _e392 = u32((_e390 * 0.00000000023283064f));
                                let _e395 = (_e390 - (f32(_e392) * 4294967300f));
                                let _e396 = u32(_e395);
                                if ((_e395 - f32(_e396)) >= 0.5f) {
                                    phi_483_ = (_e396 + 1u);
                                } else {
                                    phi_483_ = _e396;
                                }
                                let _e402 = phi_483_;
                                if (_e388 < 0f) {
                                    let _e406 = (~(_e402) + 1u);
                                    if (_e406 == 0u) {
                                        phi_498_ = (~(_e392) + 1u);
                                    } else {
                                        phi_498_ = ~(_e392);
                                    }
                                    let _e412 = phi_498_;
                                    phi_500_ = array<u32, 2>(_e406, _e412);
                                } else {
                                    phi_500_ = array<u32, 2>(_e402, _e392);
                                }
                                let _e415 = phi_500_;
                                let _e418 = (2u * (_e331 + _e375));
                                let _e421 = atomicAdd((&global_10.member[_e418]), _e415[0]);
                                let _e425 = (_e415[1] + select(0u, 1u, ((_e421 + _e415[0]) < _e415[0])));
                                if (_e425 == 0u) {
                                } else {
                                    let _e430 = atomicAdd((&global_10.member[(_e418 + 1u)]), _e425);
                                }
                            }
                            let _e431 = (_e387 * (_e218 * _e216));
                            if _e109 {
                                let _e433 = abs(_e431);
                                let _e435 = u32((_e433 * 0.00000000023283064f));
                                let _e438 = (_e433 - (f32(_e435) * 4294967300f));
                                let _e439 = u32(_e438);
                                if ((_e438 - f32(_e439)) >= 0.5f) {
                                    phi_532_ = (_e439 + 1u);
                                } else {
                                    phi_532_ = _e439;
                                }
                                let _e445 = phi_532_;
                                if (_e431 < 0f) {
                                    let _e449 = (~(_e445) + 1u);
                                    if (_e449 == 0u) {
                                        phi_547_ = (~(_e435) + 1u);
                                    } else {
                                        phi_547_ = ~(_e435);
                                    }
                                    let _e455 = phi_547_;
                                    phi_549_ = array<u32, 2>(_e449, _e455);
                                } else {
                                    phi_549_ = array<u32, 2>(_e445, _e435);
                                }
                                let _e458 = phi_549_;
                                let _e461 = (2u * (_e332 + _e375));
                                let _e464 = atomicAdd((&global_10.member[_e461]), _e458[0]);
                                let _e468 = (_e458[1] + select(0u, 1u, ((_e464 + _e458[0]) < _e458[0])));
                                if (_e468 == 0u) {
                                } else {
                                    let _e473 = atomicAdd((&global_10.member[(_e461 + 1u)]), _e468);
                                }
                            }
                            let _e474 = (_e387 * (_e219 * _e216));
                            if _e109 {
                                let _e476 = abs(_e474);
                                let _e478 = u32((_e476 * 0.00000000023283064f));
                                let _e481 = (_e476 - (f32(_e478) * 4294967300f));
                                let _e482 = u32(_e481);
                                if ((_e481 - f32(_e482)) >= 0.5f) {
                                    phi_581_ = (_e482 + 1u);
                                } else {
                                    phi_581_ = _e482;
                                }
                                let _e488 = phi_581_;
                                if (_e474 < 0f) {
                                    let _e492 = (~(_e488) + 1u);
                                    if (_e492 == 0u) {
                                        phi_596_ = (~(_e478) + 1u);
                                    } else {
                                        phi_596_ = ~(_e478);
                                    }
                                    let _e498 = phi_596_;
                                    phi_598_ = array<u32, 2>(_e492, _e498);
                                } else {
                                    phi_598_ = array<u32, 2>(_e488, _e478);
                                }
                                let _e501 = phi_598_;
                                let _e504 = (2u * (_e333 + _e375));
                                let _e507 = atomicAdd((&global_10.member[_e504]), _e501[0]);
                                let _e511 = (_e501[1] + select(0u, 1u, ((_e507 + _e501[0]) < _e501[0])));
                                if (_e511 == 0u) {
                                } else {
                                    let _e516 = atomicAdd((&global_10.member[(_e504 + 1u)]), _e511);
                                }
                            }
                            let _e517 = (_e387 * (_e220 * _e216));
                            if _e109 {
                                let _e519 = abs(_e517);
                                let _e521 = u32((_e519 * 0.00000000023283064f));
                                let _e524 = (_e519 - (f32(_e521) * 4294967300f));
                                let _e525 = u32(_e524);
                                if ((_e524 - f32(_e525)) >= 0.5f) {
                                    phi_630_ = (_e525 + 1u);
                                } else {
                                    phi_630_ = _e525;
                                }
                                let _e531 = phi_630_;
                                if (_e517 < 0f) {
                                    let _e535 = (~(_e531) + 1u);
                                    if (_e535 == 0u) {
                                        phi_645_ = (~(_e521) + 1u);
                                    } else {
                                        phi_645_ = ~(_e521);
                                    }
                                    let _e541 = phi_645_;
                                    phi_647_ = array<u32, 2>(_e535, _e541);
                                } else {
                                    phi_647_ = array<u32, 2>(_e531, _e521);
                                }
                                let _e544 = phi_647_;
                                let _e547 = (2u * (_e334 + _e375));
                                let _e550 = atomicAdd((&global_10.member[_e547]), _e544[0]);
                                let _e554 = (_e544[1] + select(0u, 1u, ((_e550 + _e544[0]) < _e544[0])));
                                if (_e554 == 0u) {
                                } else {
                                    let _e559 = atomicAdd((&global_10.member[(_e547 + 1u)]), _e554);
                                }
                            }
                            let _e560 = (_e387 * (_e217 * _e211));
                            if _e109 {
                                let _e562 = abs(_e560);
                                let _e564 = u32((_e562 * 0.00000000023283064f));
                                let _e567 = (_e562 - (f32(_e564) * 4294967300f));
                                let _e568 = u32(_e567);
                                if ((_e567 - f32(_e568)) >= 0.5f) {
                                    phi_679_ = (_e568 + 1u);
                                } else {
                                    phi_679_ = _e568;
                                }
                                let _e574 = phi_679_;
                                if (_e560 < 0f) {
                                    let _e578 = (~(_e574) + 1u);
                                    if (_e578 == 0u) {
                                        phi_694_ = (~(_e564) + 1u);
                                    } else {
                                        phi_694_ = ~(_e564);
                                    }
                                    let _e584 = phi_694_;
                                    phi_696_ = array<u32, 2>(_e578, _e584);
                                } else {
                                    phi_696_ = array<u32, 2>(_e574, _e564);
                                }
                                let _e587 = phi_696_;
                                let _e590 = (2u * (_e335 + _e375));
                                let _e593 = atomicAdd((&global_10.member[_e590]), _e587[0]);
                                let _e597 = (_e587[1] + select(0u, 1u, ((_e593 + _e587[0]) < _e587[0])));
                                if (_e597 == 0u) {
                                } else {
                                    let _e602 = atomicAdd((&global_10.member[(_e590 + 1u)]), _e597);
                                }
                            }
                            let _e603 = (_e387 * (_e218 * _e211));
                            if _e109 {
                                let _e605 = abs(_e603);
                                let _e607 = u32((_e605 * 0.00000000023283064f));
                                let _e610 = (_e605 - (f32(_e607) * 4294967300f));
                                let _e611 = u32(_e610);
                                if ((_e610 - f32(_e611)) >= 0.5f) {
                                    phi_728_ = (_e611 + 1u);
                                } else {
                                    phi_728_ = _e611;
                                }
                                let _e617 = phi_728_;
                                if (_e603 < 0f) {
                                    let _e621 = (~(_e617) + 1u);
                                    if (_e621 == 0u) {
                                        phi_743_ = (~(_e607) + 1u);
                                    } else {
                                        phi_743_ = ~(_e607);
                                    }
                                    let _e627 = phi_743_;
                                    phi_745_ = array<u32, 2>(_e621, _e627);
                                } else {
                                    phi_745_ = array<u32, 2>(_e617, _e607);
                                }
                                let _e630 = phi_745_;
                                let _e633 = (2u * (_e336 + _e375));
                                let _e636 = atomicAdd((&global_10.member[_e633]), _e630[0]);
                                let _e640 = (_e630[1] + select(0u, 1u, ((_e636 + _e630[0]) < _e630[0])));
                                if (_e640 == 0u) {
                                } else {
                                    let _e645 = atomicAdd((&global_10.member[(_e633 + 1u)]), _e640);
                                }
                            }
                            let _e646 = (_e387 * (_e219 * _e211));
                            if _e109 {
                                let _e648 = abs(_e646);
                                let _e650 = u32((_e648 * 0.00000000023283064f));
                                let _e653 = (_e648 - (f32(_e650) * 4294967300f));
                                let _e654 = u32(_e653);
                                if ((_e653 - f32(_e654)) >= 0.5f) {
                                    phi_777_ = (_e654 + 1u);
                                } else {
                                    phi_777_ = _e654;
                                }
                                let _e660 = phi_777_;
                                if (_e646 < 0f) {
                                    let _e664 = (~(_e660) + 1u);
                                    if (_e664 == 0u) {
                                        phi_792_ = (~(_e650) + 1u);
                                    } else {
                                        phi_792_ = ~(_e650);
                                    }
                                    let _e670 = phi_792_;
                                    phi_794_ = array<u32, 2>(_e664, _e670);
                                } else {
                                    phi_794_ = array<u32, 2>(_e660, _e650);
                                }
                                let _e673 = phi_794_;
                                let _e676 = (2u * (_e337 + _e375));
                                let _e679 = atomicAdd((&global_10.member[_e676]), _e673[0]);
                                let _e683 = (_e673[1] + select(0u, 1u, ((_e679 + _e673[0]) < _e673[0])));
                                if (_e683 == 0u) {
                                } else {
                                    let _e688 = atomicAdd((&global_10.member[(_e676 + 1u)]), _e683);
                                }
                            }
                            let _e689 = (_e387 * (_e220 * _e211));
                            if _e109 {
                                let _e691 = abs(_e689);
                                let _e693 = u32((_e691 * 0.00000000023283064f));
                                let _e696 = (_e691 - (f32(_e693) * 4294967300f));
                                let _e697 = u32(_e696);
                                if ((_e696 - f32(_e697)) >= 0.5f) {
                                    phi_826_ = (_e697 + 1u);
                                } else {
                                    phi_826_ = _e697;
                                }
                                let _e703 = phi_826_;
                                if (_e689 < 0f) {
                                    let _e707 = (~(_e703) + 1u);
                                    if (_e707 == 0u) {
                                        phi_841_ = (~(_e693) + 1u);
                                    } else {
                                        phi_841_ = ~(_e693);
                                    }
                                    let _e713 = phi_841_;
                                    phi_843_ = array<u32, 2>(_e707, _e713);
                                } else {
                                    phi_843_ = array<u32, 2>(_e703, _e693);
                                }
                                let _e716 = phi_843_;
                                let _e719 = (2u * (_e338 + _e375));
                                let _e722 = atomicAdd((&global_10.member[_e719]), _e716[0]);
                                let _e726 = (_e716[1] + select(0u, 1u, ((_e722 + _e716[0]) < _e716[0])));
                                if (_e726 == 0u) {
                                } else {
                                    let _e731 = atomicAdd((&global_10.member[(_e719 + 1u)]), _e726);
                                }
                            }
                            local_7 = (_e375 + 1u);
                            local_8 = (_e377 + _e64);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e752 = local_7;
                            phi_455_ = _e752;
                            let _e755 = local_8;
                            phi_458_ = _e755;
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
