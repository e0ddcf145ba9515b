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
    var phi_532_: f32;
    var phi_542_: u32;
    var phi_556_: u32;
    var phi_558_: array<u32, 2>;
    var phi_579_: f32;
    var phi_589_: u32;
    var phi_603_: u32;
    var phi_605_: array<u32, 2>;
    var phi_626_: f32;
    var phi_636_: u32;
    var phi_650_: u32;
    var phi_652_: array<u32, 2>;
    var phi_673_: f32;
    var phi_683_: u32;
    var phi_697_: u32;
    var phi_699_: array<u32, 2>;
    var phi_720_: f32;
    var phi_730_: u32;
    var phi_744_: u32;
    var phi_746_: array<u32, 2>;
    var phi_767_: f32;
    var phi_777_: u32;
    var phi_791_: u32;
    var phi_793_: array<u32, 2>;
    var phi_814_: f32;
    var phi_824_: u32;
    var phi_838_: u32;
    var phi_840_: array<u32, 2>;
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
                        let _e744 = local_3;
                        phi_203_ = _e744;
                        let _e747 = local_4;
                        phi_206_ = _e747;
                        let _e750 = local_5;
                        phi_208_ = _e750;
                        let _e753 = local_6;
                        phi_210_ = _e753;
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
                                let _e431 = atomicAdd((&global_10.member[(_e420 + 1u)]), (_e417[1] + select(0u, 1u, ((_e423 + _e417[0]) < _e417[0]))));
                            }
                            let _e432 = (_e387 * (_e218 * _e216));
                            if _e109 {
                                let _e434 = (_e432 < 0f);
                                if _e434 {
                                    phi_532_ = -(_e432);
                                } else {
                                    phi_532_ = _e432;
                                }
                                let _e437 = phi_532_;
                                let _e439 = u32((_e437 * 0.00000000023283064f));
                                let _e442 = (_e437 - (f32(_e439) * 4294967300f));
                                let _e443 = u32(_e442);
                                if ((_e442 - f32(_e443)) >= 0.5f) {
                                    phi_542_ = (_e443 + 1u);
                                } else {
                                    phi_542_ = _e443;
                                }
                                let _e449 = phi_542_;
                                if _e434 {
                                    let _e452 = (~(_e449) + 1u);
                                    if (_e452 == 0u) {
                                        phi_556_ = (~(_e439) + 1u);
                                    } else {
                                        phi_556_ = ~(_e439);
                                    }
                                    let _e458 = phi_556_;
                                    phi_558_ = array<u32, 2>(_e452, _e458);
                                } else {
                                    phi_558_ = array<u32, 2>(_e449, _e439);
                                }
                                let _e461 = phi_558_;
                                let _e464 = (2u * (_e332 + _e375));
                                let _e467 = atomicAdd((&global_10.member[_e464]), _e461[0]);
                                let _e475 = atomicAdd((&global_10.member[(_e464 + 1u)]), (_e461[1] + select(0u, 1u, ((_e467 + _e461[0]) < _e461[0]))));
                            }
                            let _e476 = (_e387 * (_e219 * _e216));
                            if _e109 {
                                let _e478 = (_e476 < 0f);
                                if _e478 {
                                    phi_579_ = -(_e476);
                                } else {
                                    phi_579_ = _e476;
                                }
                                let _e481 = phi_579_;
                                let _e483 = u32((_e481 * 0.00000000023283064f));
                                let _e486 = (_e481 - (f32(_e483) * 4294967300f));
                                let _e487 = u32(_e486);
                                if ((_e486 - f32(_e487)) >= 0.5f) {
                                    phi_589_ = (_e487 + 1u);
                                } else {
                                    phi_589_ = _e487;
                                }
                                let _e493 = phi_589_;
                                if _e478 {
                                    let _e496 = (~(_e493) + 1u);
                                    if (_e496 == 0u) {
                                        phi_603_ = (~(_e483) + 1u);
                                    } else {
                                        phi_603_ = ~(_e483);
                                    }
                                    let _e502 = phi_603_;
                                    phi_605_ = array<u32, 2>(_e496, _e502);
                                } else {
                                    phi_605_ = array<u32, 2>(_e493, _e483);
                                }
                                let _e505 = phi_605_;
                                let _e508 = (2u * (_e333 + _e375));
                                let _e511 = atomicAdd((&global_10.member[_e508]), _e505[0]);
                                let _e519 = atomicAdd((&global_10.member[(_e508 + 1u)]), (_e505[1] + select(0u, 1u, ((_e511 + _e505[0]) < _e505[0]))));
                            }
                            let _e520 = (_e387 * (_e220 * _e216));
                            if _e109 {
                                let _e522 = (_e520 < 0f);
                                if _e522 {
                                    phi_626_ = -(_e520);
                                } else {
                                    phi_626_ = _e520;
                                }
                                let _e525 = phi_626_;
                                let _e527 = u32((_e525 * 0.00000000023283064f));
                                let _e530 = (_e525 - (f32(_e527) * 4294967300f));
                                let _e531 = u32(_e530);
                                if ((_e530 - f32(_e531)) >= 0.5f) {
                                    phi_636_ = (_e531 + 1u);
                                } else {
                                    phi_636_ = _e531;
                                }
                                let _e537 = phi_636_;
                                if _e522 {
                                    let _e540 = (~(_e537) + 1u);
                                    if (_e540 == 0u) {
                                        phi_650_ = (~(_e527) + 1u);
                                    } else {
                                        phi_650_ = ~(_e527);
                                    }
                                    let _e546 = phi_650_;
                                    phi_652_ = array<u32, 2>(_e540, _e546);
                                } else {
                                    phi_652_ = array<u32, 2>(_e537, _e527);
                                }
                                let _e549 = phi_652_;
                                let _e552 = (2u * (_e334 + _e375));
                                let _e555 = atomicAdd((&global_10.member[_e552]), _e549[0]);
                                let _e563 = atomicAdd((&global_10.member[(_e552 + 1u)]), (_e549[1] + select(0u, 1u, ((_e555 + _e549[0]) < _e549[0]))));
                            }
                            let _e564 = (_e387 * (_e217 * _e211));
                            if _e109 {
                                let _e566 = (_e564 < 0f);
                                if _e566 {
                                    phi_673_ = -(_e564);
                                } else {
                                    phi_673_ = _e564;
                                }
                                let _e569 = phi_673_;
                                let _e571 = u32((_e569 * 0.00000000023283064f));
                                let _e574 = (_e569 - (f32(_e571) * 4294967300f));
                                let _e575 = u32(_e574);
                                if ((_e574 - f32(_e575)) >= 0.5f) {
                                    phi_683_ = (_e575 + 1u);
                                } else {
                                    phi_683_ = _e575;
                                }
                                let _e581 = phi_683_;
                                if _e566 {
                                    let _e584 = (~(_e581) + 1u);
                                    if (_e584 == 0u) {
                                        phi_697_ = (~(_e571) + 1u);
                                    } else {
                                        phi_697_ = ~(_e571);
                                    }
                                    let _e590 = phi_697_;
                                    phi_699_ = array<u32, 2>(_e584, _e590);
                                } else {
                                    phi_699_ = array<u32, 2>(_e581, _e571);
                                }
                                let _e593 = phi_699_;
                                let _e596 = (2u * (_e335 + _e375));
                                let _e599 = atomicAdd((&global_10.member[_e596]), _e593[0]);
                                let _e607 = atomicAdd((&global_10.member[(_e596 + 1u)]), (_e593[1] + select(0u, 1u, ((_e599 + _e593[0]) < _e593[0]))));
                            }
                            let _e608 = (_e387 * (_e218 * _e211));
                            if _e109 {
                                let _e610 = (_e608 < 0f);
                                if _e610 {
                                    phi_720_ = -(_e608);
                                } else {
                                    phi_720_ = _e608;
                                }
                                let _e613 = phi_720_;
                                let _e615 = u32((_e613 * 0.00000000023283064f));
                                let _e618 = (_e613 - (f32(_e615) * 4294967300f));
                                let _e619 = u32(_e618);
                                if ((_e618 - f32(_e619)) >= 0.5f) {
                                    phi_730_ = (_e619 + 1u);
                                } else {
                                    phi_730_ = _e619;
                                }
                                let _e625 = phi_730_;
                                if _e610 {
                                    let _e628 = (~(_e625) + 1u);
                                    if (_e628 == 0u) {
                                        phi_744_ = (~(_e615) + 1u);
                                    } else {
                                        phi_744_ = ~(_e615);
                                    }
                                    let _e634 = phi_744_;
                                    phi_746_ = array<u32, 2>(_e628, _e634);
                                } else {
                                    phi_746_ = array<u32, 2>(_e625, _e615);
                                }
                                let _e637 = phi_746_;
                                let _e640 = (2u * (_e336 + _e375));
                                let _e643 = atomicAdd((&global_10.member[_e640]), _e637[0]);
                                let _e651 = atomicAdd((&global_10.member[(_e640 + 1u)]), (_e637[1] + select(0u, 1u, ((_e643 + _e637[0]) < _e637[0]))));
                            }
                            let _e652 = (_e387 * (_e219 * _e211));
                            if _e109 {
                                let _e654 = (_e652 < 0f);
                                if _e654 {
                                    phi_767_ = -(_e652);
                                } else {
                                    phi_767_ = _e652;
                                }
                                let _e657 = phi_767_;
                                let _e659 = u32((_e657 * 0.00000000023283064f));
                                let _e662 = (_e657 - (f32(_e659) * 4294967300f));
                                let _e663 = u32(_e662);
                                if ((_e662 - f32(_e663)) >= 0.5f) {
                                    phi_777_ = (_e663 + 1u);
                                } else {
                                    phi_777_ = _e663;
                                }
                                let _e669 = phi_777_;
                                if _e654 {
                                    let _e672 = (~(_e669) + 1u);
                                    if (_e672 == 0u) {
                                        phi_791_ = (~(_e659) + 1u);
                                    } else {
                                        phi_791_ = ~(_e659);
                                    }
                                    let _e678 = phi_791_;
                                    phi_793_ = array<u32, 2>(_e672, _e678);
                                } else {
                                    phi_793_ = array<u32, 2>(_e669, _e659);
                                }
                                let _e681 = phi_793_;
                                let _e684 = (2u * (_e337 + _e375));
                                let _e687 = atomicAdd((&global_10.member[_e684]), _e681[0]);
                                let _e695 = atomicAdd((&global_10.member[(_e684 + 1u)]), (_e681[1] + select(0u, 1u, ((_e687 + _e681[0]) < _e681[0]))));
                            }
                            let _e696 = (_e387 * (_e220 * _e211));
                            if _e109 {
                                let _e698 = (_e696 < 0f);
                                if _e698 {
                                    phi_814_ = -(_e696);
                                } else {
                                    phi_814_ = _e696;
                                }
                                let _e701 = phi_814_;
                                let _e703 = u32((_e701 * 0.00000000023283064f));
                                let _e706 = (_e701 - (f32(_e703) * 4294967300f));
                                let _e707 = u32(_e706);
                                if ((_e706 - f32(_e707)) >= 0.5f) {
                                    phi_824_ = (_e707 + 1u);
                                } else {
                                    phi_824_ = _e707;
                                }
                                let _e713 = phi_824_;
                                if _e698 {
                                    let _e716 = (~(_e713) + 1u);
                                    if (_e716 == 0u) {
                                        phi_838_ = (~(_e703) + 1u);
                                    } else {
                                        phi_838_ = ~(_e703);
                                    }
                                    let _e722 = phi_838_;
                                    phi_840_ = array<u32, 2>(_e716, _e722);
                                } else {
                                    phi_840_ = array<u32, 2>(_e713, _e703);
                                }
                                let _e725 = phi_840_;
                                let _e728 = (2u * (_e338 + _e375));
                                let _e731 = atomicAdd((&global_10.member[_e728]), _e725[0]);
                                let _e739 = atomicAdd((&global_10.member[(_e728 + 1u)]), (_e725[1] + select(0u, 1u, ((_e731 + _e725[0]) < _e725[0]))));
                            }
                            local_7 = (_e375 + 1u);
                            local_8 = (_e377 + _e64);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e760 = local_7;
                            phi_463_ = _e760;
                            let _e763 = local_8;
                            phi_466_ = _e763;
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
