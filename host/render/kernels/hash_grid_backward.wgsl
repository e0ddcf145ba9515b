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
    var phi_527_: u32;
    var phi_542_: u32;
    var phi_544_: array<u32, 2>;
    var phi_571_: u32;
    var phi_586_: u32;
    var phi_588_: array<u32, 2>;
    var phi_615_: u32;
    var phi_630_: u32;
    var phi_632_: array<u32, 2>;
    var phi_659_: u32;
    var phi_674_: u32;
    var phi_676_: array<u32, 2>;
    var phi_703_: u32;
    var phi_718_: u32;
    var phi_720_: array<u32, 2>;
    var phi_747_: u32;
    var phi_762_: u32;
    var phi_764_: array<u32, 2>;
    var phi_791_: u32;
    var phi_806_: u32;
    var phi_808_: array<u32, 2>;
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
                        let _e728 = local_3;
                        phi_195_ = _e728;
                        let _e731 = local_4;
                        phi_198_ = _e731;
                        let _e734 = local_5;
                        phi_200_ = _e734;
                        let _e737 = local_6;
                        phi_202_ = _e737;
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
                                let _e429 = atomicAdd((&global_10.member[(_e418 + 1u)]), (_e415[1] + select(0u, 1u, ((_e421 + _e415[0]) < _e415[0]))));
                            }
                            let _e430 = (_e387 * (_e218 * _e216));
                            if _e109 {
                                let _e432 = abs(_e430);
                                let _e434 = u32((_e432 * 0.00000000023283064f));
                                let _e437 = (_e432 - (f32(_e434) * 4294967300f));
                                let _e438 = u32(_e437);
                                if ((_e437 - f32(_e438)) >= 0.5f) {
                                    phi_527_ = (_e438 + 1u);
                                } else {
                                    phi_527_ = _e438;
                                }
                                let _e444 = phi_527_;
                                if (_e430 < 0f) {
                                    let _e448 = (~(_e444) + 1u);
                                    if (_e448 == 0u) {
                                        phi_542_ = (~(_e434) + 1u);
                                    } else {
                                        phi_542_ = ~(_e434);
                                    }
                                    let _e454 = phi_542_;
                                    phi_544_ = array<u32, 2>(_e448, _e454);
                                } else {
                                    phi_544_ = array<u32, 2>(_e444, _e434);
                                }
                                let _e457 = phi_544_;
                                let _e460 = (2u * (_e332 + _e375));
                                let _e463 = atomicAdd((&global_10.member[_e460]), _e457[0]);
                                let _e471 = atomicAdd((&global_10.member[(_e460 + 1u)]), (_e457[1] + select(0u, 1u, ((_e463 + _e457[0]) < _e457[0]))));
                            }
                            let _e472 = (_e387 * (_e219 * _e216));
                            if _e109 {
                                let _e474 = abs(_e472);
                                let _e476 = u32((_e474 * 0.00000000023283064f));
                                let _e479 = (_e474 - (f32(_e476) * 4294967300f));
                                let _e480 = u32(_e479);
                                if ((_e479 - f32(_e480)) >= 0.5f) {
                                    phi_571_ = (_e480 + 1u);
                                } else {
                                    phi_571_ = _e480;
                                }
                                let _e486 = phi_571_;
                                if (_e472 < 0f) {
                                    let _e490 = (~(_e486) + 1u);
                                    if (_e490 == 0u) {
                                        phi_586_ = (~(_e476) + 1u);
                                    } else {
                                        phi_586_ = ~(_e476);
                                    }
                                    let _e496 = phi_586_;
                                    phi_588_ = array<u32, 2>(_e490, _e496);
                                } else {
                                    phi_588_ = array<u32, 2>(_e486, _e476);
                                }
                                let _e499 = phi_588_;
                                let _e502 = (2u * (_e333 + _e375));
                                let _e505 = atomicAdd((&global_10.member[_e502]), _e499[0]);
                                let _e513 = atomicAdd((&global_10.member[(_e502 + 1u)]), (_e499[1] + select(0u, 1u, ((_e505 + _e499[0]) < _e499[0]))));
                            }
                            let _e514 = (_e387 * (_e220 * _e216));
                            if _e109 {
                                let _e516 = abs(_e514);
                                let _e518 = u32((_e516 * 0.00000000023283064f));
                                let _e521 = (_e516 - (f32(_e518) * 4294967300f));
                                let _e522 = u32(_e521);
                                if ((_e521 - f32(_e522)) >= 0.5f) {
                                    phi_615_ = (_e522 + 1u);
                                } else {
                                    phi_615_ = _e522;
                                }
                                let _e528 = phi_615_;
                                if (_e514 < 0f) {
                                    let _e532 = (~(_e528) + 1u);
                                    if (_e532 == 0u) {
                                        phi_630_ = (~(_e518) + 1u);
                                    } else {
                                        phi_630_ = ~(_e518);
                                    }
                                    let _e538 = phi_630_;
                                    phi_632_ = array<u32, 2>(_e532, _e538);
                                } else {
                                    phi_632_ = array<u32, 2>(_e528, _e518);
                                }
                                let _e541 = phi_632_;
                                let _e544 = (2u * (_e334 + _e375));
                                let _e547 = atomicAdd((&global_10.member[_e544]), _e541[0]);
                                let _e555 = atomicAdd((&global_10.member[(_e544 + 1u)]), (_e541[1] + select(0u, 1u, ((_e547 + _e541[0]) < _e541[0]))));
                            }
                            let _e556 = (_e387 * (_e217 * _e211));
                            if _e109 {
                                let _e558 = abs(_e556);
                                let _e560 = u32((_e558 * 0.00000000023283064f));
                                let _e563 = (_e558 - (f32(_e560) * 4294967300f));
                                let _e564 = u32(_e563);
                                if ((_e563 - f32(_e564)) >= 0.5f) {
                                    phi_659_ = (_e564 + 1u);
                                } else {
                                    phi_659_ = _e564;
                                }
                                let _e570 = phi_659_;
                                if (_e556 < 0f) {
                                    let _e574 = (~(_e570) + 1u);
                                    if (_e574 == 0u) {
                                        phi_674_ = (~(_e560) + 1u);
                                    } else {
                                        phi_674_ = ~(_e560);
                                    }
                                    let _e580 = phi_674_;
                                    phi_676_ = array<u32, 2>(_e574, _e580);
                                } else {
                                    phi_676_ = array<u32, 2>(_e570, _e560);
                                }
                                let _e583 = phi_676_;
                                let _e586 = (2u * (_e335 + _e375));
                                let _e589 = atomicAdd((&global_10.member[_e586]), _e583[0]);
                                let _e597 = atomicAdd((&global_10.member[(_e586 + 1u)]), (_e583[1] + select(0u, 1u, ((_e589 + _e583[0]) < _e583[0]))));
                            }
                            let _e598 = (_e387 * (_e218 * _e211));
                            if _e109 {
                                let _e600 = abs(_e598);
                                let _e602 = u32((_e600 * 0.00000000023283064f));
                                let _e605 = (_e600 - (f32(_e602) * 4294967300f));
                                let _e606 = u32(_e605);
                                if ((_e605 - f32(_e606)) >= 0.5f) {
                                    phi_703_ = (_e606 + 1u);
                                } else {
                                    phi_703_ = _e606;
                                }
                                let _e612 = phi_703_;
                                if (_e598 < 0f) {
                                    let _e616 = (~(_e612) + 1u);
                                    if (_e616 == 0u) {
                                        phi_718_ = (~(_e602) + 1u);
                                    } else {
                                        phi_718_ = ~(_e602);
                                    }
                                    let _e622 = phi_718_;
                                    phi_720_ = array<u32, 2>(_e616, _e622);
                                } else {
                                    phi_720_ = array<u32, 2>(_e612, _e602);
                                }
                                let _e625 = phi_720_;
                                let _e628 = (2u * (_e336 + _e375));
                                let _e631 = atomicAdd((&global_10.member[_e628]), _e625[0]);
                                let _e639 = atomicAdd((&global_10.member[(_e628 + 1u)]), (_e625[1] + select(0u, 1u, ((_e631 + _e625[0]) < _e625[0]))));
                            }
                            let _e640 = (_e387 * (_e219 * _e211));
                            if _e109 {
                                let _e642 = abs(_e640);
                                let _e644 = u32((_e642 * 0.00000000023283064f));
                                let _e647 = (_e642 - (f32(_e644) * 4294967300f));
                                let _e648 = u32(_e647);
                                if ((_e647 - f32(_e648)) >= 0.5f) {
                                    phi_747_ = (_e648 + 1u);
                                } else {
                                    phi_747_ = _e648;
                                }
                                let _e654 = phi_747_;
                                if (_e640 < 0f) {
                                    let _e658 = (~(_e654) + 1u);
                                    if (_e658 == 0u) {
                                        phi_762_ = (~(_e644) + 1u);
                                    } else {
                                        phi_762_ = ~(_e644);
                                    }
                                    let _e664 = phi_762_;
                                    phi_764_ = array<u32, 2>(_e658, _e664);
                                } else {
                                    phi_764_ = array<u32, 2>(_e654, _e644);
                                }
                                let _e667 = phi_764_;
                                let _e670 = (2u * (_e337 + _e375));
                                let _e673 = atomicAdd((&global_10.member[_e670]), _e667[0]);
                                let _e681 = atomicAdd((&global_10.member[(_e670 + 1u)]), (_e667[1] + select(0u, 1u, ((_e673 + _e667[0]) < _e667[0]))));
                            }
                            let _e682 = (_e387 * (_e220 * _e211));
                            if _e109 {
                                let _e684 = abs(_e682);
                                let _e686 = u32((_e684 * 0.00000000023283064f));
                                let _e689 = (_e684 - (f32(_e686) * 4294967300f));
                                let _e690 = u32(_e689);
                                if ((_e689 - f32(_e690)) >= 0.5f) {
                                    phi_791_ = (_e690 + 1u);
                                } else {
                                    phi_791_ = _e690;
                                }
                                let _e696 = phi_791_;
                                if (_e682 < 0f) {
                                    let _e700 = (~(_e696) + 1u);
                                    if (_e700 == 0u) {
                                        phi_806_ = (~(_e686) + 1u);
                                    } else {
                                        phi_806_ = ~(_e686);
                                    }
                                    let _e706 = phi_806_;
                                    phi_808_ = array<u32, 2>(_e700, _e706);
                                } else {
                                    phi_808_ = array<u32, 2>(_e696, _e686);
                                }
                                let _e709 = phi_808_;
                                let _e712 = (2u * (_e338 + _e375));
                                let _e715 = atomicAdd((&global_10.member[_e712]), _e709[0]);
                                let _e723 = atomicAdd((&global_10.member[(_e712 + 1u)]), (_e709[1] + select(0u, 1u, ((_e715 + _e709[0]) < _e709[0]))));
                            }
                            local_7 = (_e375 + 1u);
                            local_8 = (_e377 + _e64);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e744 = local_7;
                            phi_455_ = _e744;
                            let _e747 = local_8;
                            phi_458_ = _e747;
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
