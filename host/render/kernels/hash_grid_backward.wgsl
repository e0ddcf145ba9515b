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
    var phi_203_: u32;
    var phi_206_: u32;
    var phi_208_: f32;
    var phi_210_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_395_: array<u32, 8>;
    var phi_463_: u32;
    var phi_466_: u32;
    var phi_485_: f32;
    var phi_495_: u32;
    var phi_509_: u32;
    var phi_511_: array<u32, 2>;
    var phi_537_: f32;
    var phi_547_: u32;
    var phi_561_: u32;
    var phi_563_: array<u32, 2>;
    var phi_589_: f32;
    var phi_599_: u32;
    var phi_613_: u32;
    var phi_615_: array<u32, 2>;
    var phi_641_: f32;
    var phi_651_: u32;
    var phi_665_: u32;
    var phi_667_: array<u32, 2>;
    var phi_693_: f32;
    var phi_703_: u32;
    var phi_717_: u32;
    var phi_719_: array<u32, 2>;
    var phi_745_: f32;
    var phi_755_: u32;
    var phi_769_: u32;
    var phi_771_: array<u32, 2>;
    var phi_797_: f32;
    var phi_807_: u32;
    var phi_821_: u32;
    var phi_823_: array<u32, 2>;
    var phi_849_: f32;
    var phi_859_: u32;
    var phi_873_: u32;
    var phi_875_: array<u32, 2>;
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
                phi_203_ = 0u;
                phi_206_ = _e72;
                phi_208_ = 0f;
                phi_210_ = 0f;
                loop {
                    let _e77 = phi_203_;
                    let _e79 = phi_206_;
                    let _e81 = phi_208_;
                    let _e83 = phi_210_;
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
                        let _e752 = local_3;
                        phi_203_ = _e752;
                        let _e755 = local_4;
                        phi_206_ = _e755;
                        let _e758 = local_5;
                        phi_208_ = _e758;
                        let _e761 = local_6;
                        phi_210_ = _e761;
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
                        phi_395_ = array<u32, 8>((select((_e277 - _e112.member_4), _e277, (_e277 < _e112.member_4)) + _e112.member_3), (select((_e283 - _e112.member_4), _e283, (_e283 < _e112.member_4)) + _e112.member_3), (select((_e289 - _e112.member_4), _e289, (_e289 < _e112.member_4)) + _e112.member_3), (select((_e295 - _e112.member_4), _e295, (_e295 < _e112.member_4)) + _e112.member_3), (select((_e300 - _e112.member_4), _e300, (_e300 < _e112.member_4)) + _e112.member_3), (select((_e305 - _e112.member_4), _e305, (_e305 < _e112.member_4)) + _e112.member_3), (select((_e310 - _e112.member_4), _e310, (_e310 < _e112.member_4)) + _e112.member_3), (select((_e315 - _e112.member_4), _e315, (_e315 < _e112.member_4)) + _e112.member_3));
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
                        phi_395_ = array<u32, 8>((((_e239 ^ _e235) & _e233) + _e112.member_3), (((_e243 ^ _e235) & _e233) + _e112.member_3), (((_e247 ^ _e235) & _e233) + _e112.member_3), (((_e251 ^ _e235) & _e233) + _e112.member_3), (((_e239 ^ _e238) & _e233) + _e112.member_3), (((_e243 ^ _e238) & _e233) + _e112.member_3), (((_e247 ^ _e238) & _e233) + _e112.member_3), (((_e251 ^ _e238) & _e233) + _e112.member_3));
                    }
                    let _e322 = phi_395_;
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
                    phi_463_ = 0u;
                    phi_466_ = _e72;
                    loop {
                        let _e375 = phi_463_;
                        let _e377 = phi_466_;
                        if (_e375 < _e47) {
                            let _e381 = global_5.member[_e377];
                            let _e382 = -(_e381);
                            let _e387 = select(0f, (_e381 * _e373), (0.000000000000000000000000000000000000011754944f <= select(_e382, _e381, (_e381 > _e382))));
                            let _e388 = (_e387 * (_e217 * _e216));
                            if _e109 {
                                let _e390 = (_e388 < 0f);
                                if _e390 {
                                    phi_485_ = -(_e388);
                                } else {
                                    phi_485_ = _e388;
                                }
                                let _e393 = phi_485_;
                                let _e395 = u32((_e393 * 0.00000000023283064f));
                                let _e398 = (_e393 - (f32(_e395) * 4294967300f));
                                let _e399 = u32(_e398);
                                if ((_e398 - f32(_e399)) >= 0.5f) {
                                    phi_495_ = (_e399 + 1u);
                                } else {
                                    phi_495_ = _e399;
                                }
                                let _e405 = phi_495_;
                                if _e390 {
                                    let _e408 = (~(_e405) + 1u);
                                    if (_e408 == 0u) {
                                        phi_509_ = (~(_e395) + 1u);
                                    } else {
                                        phi_509_ = ~(_e395);
                                    }
                                    let _e414 = phi_509_;
                                    phi_511_ = array<u32, 2>(_e408, _e414);
                                } else {
                                    phi_511_ = array<u32, 2>(_e405, _e395);
                                }
                                let _e417 = phi_511_;
                                let _e420 = (2u * (_e331 + _e375));
                                let _e423 = atomicAdd((&global_10.member[_e420]), _e417[0]);
                                let _e427 = (_e417[1] + select(0u, 1u, ((_e423 + _e417[0]) < _e417[0])));
                                if (_e427 == 0u) {
                                } else {
                                    let _e432 = atomicAdd((&global_10.member[(_e420 + 1u)]), _e427);
                                }
                            }
                            let _e433 = (_e387 * (_e218 * _e216));
                            if _e109 {
                                let _e435 = (_e433 < 0f);
                                if _e435 {
                                    phi_537_ = -(_e433);
                                } else {
                                    phi_537_ = _e433;
                                }
                                let _e438 = phi_537_;
                                let _e440 = u32((_e438 * 0.00000000023283064f));
                                let _e443 = (_e438 - (f32(_e440) * 4294967300f));
                                let _e444 = u32(_e443);
                                if ((_e443 - f32(_e444)) >= 0.5f) {
                                    phi_547_ = (_e444 + 1u);
                                } else {
                                    phi_547_ = _e444;
                                }
                                let _e450 = phi_547_;
                                if _e435 {
                                    let _e453 = (~(_e450) + 1u);
                                    if (_e453 == 0u) {
                                        phi_561_ = (~(_e440) + 1u);
                                    } else {
                                        phi_561_ = ~(_e440);
                                    }
                                    let _e459 = phi_561_;
                                    phi_563_ = array<u32, 2>(_e453, _e459);
                                } else {
                                    phi_563_ = array<u32, 2>(_e450, _e440);
                                }
                                let _e462 = phi_563_;
                                let _e465 = (2u * (_e332 + _e375));
                                let _e468 = atomicAdd((&global_10.member[_e465]), _e462[0]);
                                let _e472 = (_e462[1] + select(0u, 1u, ((_e468 + _e462[0]) < _e462[0])));
                                if (_e472 == 0u) {
                                } else {
                                    let _e477 = atomicAdd((&global_10.member[(_e465 + 1u)]), _e472);
                                }
                            }
                            let _e478 = (_e387 * (_e219 * _e216));
                            if _e109 {
                                let _e480 = (_e478 < 0f);
                                if _e480 {
                                    phi_589_ = -(_e478);
                                } else {
                                    phi_589_ = _e478;
                                }
                                let _e483 = phi_589_;
                                let _e485 = u32((_e483 * 0.00000000023283064f));
                                let _e488 = (_e483 - (f32(_e485) * 4294967300f));
                                let _e489 = u32(_e488);
                                if ((_e488 - f32(_e489)) >= 0.5f) {
                                    phi_599_ = (_e489 + 1u);
                                } else {
                                    phi_599_ = _e489;
                                }
                                let _e495 = phi_599_;
                                if _e480 {
                                    let _e498 = (~(_e495) + 1u);
                                    if (_e498 == 0u) {
                                        phi_613_ = (~(_e485) + 1u);
                                    } else {
                                        phi_613_ = ~(_e485);
                                    }
                                    let _e504 = phi_613_;
                                    phi_615_ = array<u32, 2>(_e498, _e504);
                                } else {
                                    phi_615_ = array<u32, 2>(_e495, _e485);
                                }
                                let _e507 = phi_615_;
                                let _e510 = (2u * (_e333 + _e375));
                                let _e513 = atomicAdd((&global_10.member[_e510]), _e507[0]);
                                let _e517 = (_e507[1] + select(0u, 1u, ((_e513 + _e507[0]) < _e507[0])));
                                if (_e517 == 0u) {
                                } else {
                                    let _e522 = atomicAdd((&global_10.member[(_e510 + 1u)]), _e517);
                                }
                            }
                            let _e523 = (_e387 * (_e220 * _e216));
                            if _e109 {
                                let _e525 = (_e523 < 0f);
                                if _e525 {
                                    phi_641_ = -(_e523);
                                } else {
                                    phi_641_ = _e523;
                                }
                                let _e528 = phi_641_;
                                let _e530 = u32((_e528 * 0.00000000023283064f));
                                let _e533 = (_e528 - (f32(_e530) * 4294967300f));
                                let _e534 = u32(_e533);
                                if ((_e533 - f32(_e534)) >= 0.5f) {
                                    phi_651_ = (_e534 + 1u);
                                } else {
                                    phi_651_ = _e534;
                                }
                                let _e540 = phi_651_;
                                if _e525 {
                                    let _e543 = (~(_e540) + 1u);
                                    if (_e543 == 0u) {
                                        phi_665_ = (~(_e530) + 1u);
                                    } else {
                                        phi_665_ = ~(_e530);
                                    }
                                    let _e549 = phi_665_;
                                    phi_667_ = array<u32, 2>(_e543, _e549);
                                } else {
                                    phi_667_ = array<u32, 2>(_e540, _e530);
                                }
                                let _e552 = phi_667_;
                                let _e555 = (2u * (_e334 + _e375));
                                let _e558 = atomicAdd((&global_10.member[_e555]), _e552[0]);
                                let _e562 = (_e552[1] + select(0u, 1u, ((_e558 + _e552[0]) < _e552[0])));
                                if (_e562 == 0u) {
                                } else {
                                    let _e567 = atomicAdd((&global_10.member[(_e555 + 1u)]), _e562);
                                }
                            }
                            let _e568 = (_e387 * (_e217 * _e211));
                            if _e109 {
                                let _e570 = (_e568 < 0f);
                                if _e570 {
                                    phi_693_ = -(_e568);
                                } else {
                                    phi_693_ = _e568;
                                }
                                let _e573 = phi_693_;
                                let _e575 = u32((_e573 * 0.00000000023283064f));
                                let _e578 = (_e573 - (f32(_e575) * 4294967300f));
                                let _e579 = u32(_e578);
                                if ((_e578 - f32(_e579)) >= 0.5f) {
                                    phi_703_ = (_e579 + 1u);
                                } else {
                                    phi_703_ = _e579;
                                }
                                let _e585 = phi_703_;
                                if _e570 {
                                    let _e588 = (~(_e585) + 1u);
                                    if (_e588 == 0u) {
                                        phi_717_ = (~(_e575) + 1u);
                                    } else {
                                        phi_717_ = ~(_e575);
                                    }
                                    let _e594 = phi_717_;
                                    phi_719_ = array<u32, 2>(_e588, _e594);
                                } else {
                                    phi_719_ = array<u32, 2>(_e585, _e575);
                                }
                                let _e597 = phi_719_;
                                let _e600 = (2u * (_e335 + _e375));
                                let _e603 = atomicAdd((&global_10.member[_e600]), _e597[0]);
                                let _e607 = (_e597[1] + select(0u, 1u, ((_e603 + _e597[0]) < _e597[0])));
                                if (_e607 == 0u) {
                                } else {
                                    let _e612 = atomicAdd((&global_10.member[(_e600 + 1u)]), _e607);
                                }
                            }
                            let _e613 = (_e387 * (_e218 * _e211));
                            if _e109 {
                                let _e615 = (_e613 < 0f);
                                if _e615 {
                                    phi_745_ = -(_e613);
                                } else {
                                    phi_745_ = _e613;
                                }
                                let _e618 = phi_745_;
                                let _e620 = u32((_e618 * 0.00000000023283064f));
                                let _e623 = (_e618 - (f32(_e620) * 4294967300f));
                                let _e624 = u32(_e623);
                                if ((_e623 - f32(_e624)) >= 0.5f) {
                                    phi_755_ = (_e624 + 1u);
                                } else {
                                    phi_755_ = _e624;
                                }
                                let _e630 = phi_755_;
                                if _e615 {
                                    let _e633 = (~(_e630) + 1u);
                                    if (_e633 == 0u) {
                                        phi_769_ = (~(_e620) + 1u);
                                    } else {
                                        phi_769_ = ~(_e620);
                                    }
                                    let _e639 = phi_769_;
                                    phi_771_ = array<u32, 2>(_e633, _e639);
                                } else {
                                    phi_771_ = array<u32, 2>(_e630, _e620);
                                }
                                let _e642 = phi_771_;
                                let _e645 = (2u * (_e336 + _e375));
                                let _e648 = atomicAdd((&global_10.member[_e645]), _e642[0]);
                                let _e652 = (_e642[1] + select(0u, 1u, ((_e648 + _e642[0]) < _e642[0])));
                                if (_e652 == 0u) {
                                } else {
                                    let _e657 = atomicAdd((&global_10.member[(_e645 + 1u)]), _e652);
                                }
                            }
                            let _e658 = (_e387 * (_e219 * _e211));
                            if _e109 {
                                let _e660 = (_e658 < 0f);
                                if _e660 {
                                    phi_797_ = -(_e658);
                                } else {
                                    phi_797_ = _e658;
                                }
                                let _e663 = phi_797_;
                                let _e665 = u32((_e663 * 0.00000000023283064f));
                                let _e668 = (_e663 - (f32(_e665) * 4294967300f));
                                let _e669 = u32(_e668);
                                if ((_e668 - f32(_e669)) >= 0.5f) {
                                    phi_807_ = (_e669 + 1u);
                                } else {
                                    phi_807_ = _e669;
                                }
                                let _e675 = phi_807_;
                                if _e660 {
                                    let _e678 = (~(_e675) + 1u);
                                    if (_e678 == 0u) {
                                        phi_821_ = (~(_e665) + 1u);
                                    } else {
                                        phi_821_ = ~(_e665);
                                    }
                                    let _e684 = phi_821_;
                                    phi_823_ = array<u32, 2>(_e678, _e684);
                                } else {
                                    phi_823_ = array<u32, 2>(_e675, _e665);
                                }
                                let _e687 = phi_823_;
                                let _e690 = (2u * (_e337 + _e375));
                                let _e693 = atomicAdd((&global_10.member[_e690]), _e687[0]);
                                let _e697 = (_e687[1] + select(0u, 1u, ((_e693 + _e687[0]) < _e687[0])));
                                if (_e697 == 0u) {
                                } else {
                                    let _e702 = atomicAdd((&global_10.member[(_e690 + 1u)]), _e697);
                                }
                            }
                            let _e703 = (_e387 * (_e220 * _e211));
                            if _e109 {
                                let _e705 = (_e703 < 0f);
                                if _e705 {
                                    phi_849_ = -(_e703);
                                } else {
                                    phi_849_ = _e703;
                                }
                                let _e708 = phi_849_;
                                let _e710 = u32((_e708 * 0.00000000023283064f));
                                let _e713 = (_e708 - (f32(_e710) * 4294967300f));
                                let _e714 = u32(_e713);
                                if ((_e713 - f32(_e714)) >= 0.5f) {
                                    phi_859_ = (_e714 + 1u);
                                } else {
                                    phi_859_ = _e714;
                                }
                                let _e720 = phi_859_;
                                if _e705 {
                                    let _e723 = (~(_e720) + 1u);
                                    if (_e723 == 0u) {
                                        phi_873_ = (~(_e710) + 1u);
                                    } else {
                                        phi_873_ = ~(_e710);
                                    }
                                    let _e729 = phi_873_;
                                    phi_875_ = array<u32, 2>(_e723, _e729);
                                } else {
                                    phi_875_ = array<u32, 2>(_e720, _e710);
                                }
                                let _e732 = phi_875_;
                                let _e735 = (2u * (_e338 + _e375));
                                let _e738 = atomicAdd((&global_10.member[_e735]), _e732[0]);
                                let _e742 = (_e732[1] + select(0u, 1u, ((_e738 + _e732[0]) < _e732[0])));
                                if (_e742 == 0u) {
                                } else {
                                    let _e747 = atomicAdd((&global_10.member[(_e735 + 1u)]), _e742);
                                }
                            }
                            local_7 = (_e375 + 1u);
                            local_8 = (_e377 + _e64);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e768 = local_7;
                            phi_463_ = _e768;
                            let _e771 = local_8;
                            phi_466_ = _e771;
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
