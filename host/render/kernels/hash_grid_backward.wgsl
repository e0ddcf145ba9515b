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
    var phi_202_: u32;
    var phi_205_: u32;
    var phi_207_: f32;
    var phi_209_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_394_: array<u32, 8>;
    var phi_462_: u32;
    var phi_465_: u32;
    var phi_490_: u32;
    var phi_505_: u32;
    var phi_507_: array<u32, 2>;
    var phi_539_: u32;
    var phi_554_: u32;
    var phi_556_: array<u32, 2>;
    var phi_588_: u32;
    var phi_603_: u32;
    var phi_605_: array<u32, 2>;
    var phi_637_: u32;
    var phi_652_: u32;
    var phi_654_: array<u32, 2>;
    var phi_686_: u32;
    var phi_701_: u32;
    var phi_703_: array<u32, 2>;
    var phi_735_: u32;
    var phi_750_: u32;
    var phi_752_: array<u32, 2>;
    var phi_784_: u32;
    var phi_799_: u32;
    var phi_801_: array<u32, 2>;
    var phi_833_: u32;
    var phi_848_: u32;
    var phi_850_: array<u32, 2>;
    var local_3: u32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e31 = global_2;
            let _e37 = ((_e30.x + (_e30.y * _e31.x)) * 64u);
            let _e42 = global_3.member.member;
            if ((_e37 + _e29.x) < _e42) {
                let _e46 = global_3.member.member_3;
                let _e50 = global_3.member.member_2;
                let _e55 = global_3.member.member_6;
                let _e58 = global_3.member.member_4;
                let _e59 = (_e58 == 0u);
                if _e59 {
                    break;
                }
                let _e60 = (_e37 / _e58);
                let _e63 = global_3.member.member_1;
                let _e67 = (_e37 - (_e60 * _e58));
                let _e71 = ((((_e60 * (_e55 * _e63)) + _e67) + _e29.x) + ((_e50 + (_e30.z * _e46)) * _e63));
                let _e74 = global_4.member[2u];
                phi_202_ = 0u;
                phi_205_ = _e71;
                phi_207_ = 0f;
                phi_209_ = 0f;
                loop {
                    let _e76 = phi_202_;
                    let _e78 = phi_205_;
                    let _e80 = phi_207_;
                    let _e82 = phi_209_;
                    local = _e80;
                    local_1 = _e82;
                    local_2 = _e80;
                    if (_e76 < _e46) {
                        let _e86 = global_5.member[_e78];
                        let _e87 = -(_e86);
                        let _e89 = select(_e87, _e86, (_e86 > _e87));
                        local_3 = (_e76 + 1u);
                        local_4 = (_e78 + _e63);
                        local_5 = select(1f, _e80, (_e89 <= _e74));
                        local_6 = select(_e89, _e82, (_e82 > _e89));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e743 = local_3;
                        phi_202_ = _e743;
                        let _e746 = local_4;
                        phi_205_ = _e746;
                        let _e749 = local_5;
                        phi_207_ = _e749;
                        let _e752 = local_6;
                        phi_209_ = _e752;
                    }
                }
                let _e97 = local;
                if (0f < _e97) {
                    let _e101 = atomicMax((&global_6.member[0u]), 1u);
                }
                let _e103 = local_1;
                let _e106 = local_2;
                let _e108 = select(false, (_e106 < 1f), (0.000000000000000000000000000000000000011754944f <= _e103));
                if _e108 {
                    let _e111 = global_7.member[_e30.z];
                    let _e114 = global_3.member.member_5;
                    if _e59 {
                        break;
                    }
                    let _e118 = (((_e60 * (_e114 * _e63)) + _e67) + _e29.x);
                    let _e121 = global_8.member[_e118];
                    let _e122 = (3u * _e63);
                    let _e126 = global_8.member[(_e118 + _e122)];
                    let _e127 = (_e63 + _e118);
                    let _e130 = global_8.member[_e127];
                    let _e134 = global_8.member[(_e127 + _e122)];
                    let _e136 = ((2u * _e63) + _e118);
                    let _e139 = global_8.member[_e136];
                    let _e143 = global_8.member[(_e136 + _e122)];
                    let _e144 = (_e121 + _e126);
                    let _e147 = select(false, (_e144 < 1f), (0f < _e144));
                    let _e150 = select(select(0f, 1f, (1f <= _e144)), _e121, _e147);
                    let _e153 = (_e150 * _e111.member);
                    let _e156 = (_e111.member + _e111.member_1);
                    let _e160 = trunc(_e153);
                    let _e162 = ((_e153 - _e160) + (((_e150 * _e111.member_1) + (select(0f, _e126, _e147) * _e156)) + 0.5f));
                    let _e164 = select(0f, _e162, (_e162 > 0f));
                    let _e165 = trunc(_e164);
                    let _e166 = (_e164 - _e165);
                    let _e168 = u32((_e160 + _e165));
                    let _e169 = (_e130 + _e134);
                    let _e172 = select(false, (_e169 < 1f), (0f < _e169));
                    let _e175 = select(select(0f, 1f, (1f <= _e169)), _e130, _e172);
                    let _e177 = (_e175 * _e111.member);
                    let _e182 = trunc(_e177);
                    let _e184 = ((_e177 - _e182) + (((_e175 * _e111.member_1) + (select(0f, _e134, _e172) * _e156)) + 0.5f));
                    let _e186 = select(0f, _e184, (_e184 > 0f));
                    let _e187 = trunc(_e186);
                    let _e188 = (_e186 - _e187);
                    let _e190 = u32((_e182 + _e187));
                    let _e191 = (_e139 + _e143);
                    let _e194 = select(false, (_e191 < 1f), (0f < _e191));
                    let _e197 = select(select(0f, 1f, (1f <= _e191)), _e139, _e194);
                    let _e199 = (_e197 * _e111.member);
                    let _e204 = trunc(_e199);
                    let _e206 = ((_e199 - _e204) + (((_e197 * _e111.member_1) + (select(0f, _e143, _e194) * _e156)) + 0.5f));
                    let _e208 = select(0f, _e206, (_e206 > 0f));
                    let _e209 = trunc(_e208);
                    let _e210 = (_e208 - _e209);
                    let _e212 = u32((_e204 + _e209));
                    let _e213 = (1f - _e166);
                    let _e214 = (1f - _e188);
                    let _e215 = (1f - _e210);
                    let _e216 = (_e213 * _e214);
                    let _e217 = (_e166 * _e214);
                    let _e218 = (_e213 * _e188);
                    let _e219 = (_e166 * _e188);
                    if (_e111.member_5 == 0u) {
                        let _e269 = (_e111.member_2 * _e111.member_2);
                        let _e270 = (_e190 * _e111.member_2);
                        let _e271 = (_e212 * _e269);
                        let _e272 = (_e168 + 1u);
                        let _e273 = (_e270 + _e111.member_2);
                        let _e274 = (_e271 + _e269);
                        let _e275 = (_e168 + _e270);
                        let _e276 = (_e275 + _e271);
                        let _e281 = (_e272 + _e270);
                        let _e282 = (_e281 + _e271);
                        let _e287 = (_e168 + _e273);
                        let _e288 = (_e287 + _e271);
                        let _e293 = (_e272 + _e273);
                        let _e294 = (_e293 + _e271);
                        let _e299 = (_e275 + _e274);
                        let _e304 = (_e281 + _e274);
                        let _e309 = (_e287 + _e274);
                        let _e314 = (_e293 + _e274);
                        phi_394_ = array<u32, 8>((select((_e276 - _e111.member_4), _e276, (_e276 < _e111.member_4)) + _e111.member_3), (select((_e282 - _e111.member_4), _e282, (_e282 < _e111.member_4)) + _e111.member_3), (select((_e288 - _e111.member_4), _e288, (_e288 < _e111.member_4)) + _e111.member_3), (select((_e294 - _e111.member_4), _e294, (_e294 < _e111.member_4)) + _e111.member_3), (select((_e299 - _e111.member_4), _e299, (_e299 < _e111.member_4)) + _e111.member_3), (select((_e304 - _e111.member_4), _e304, (_e304 < _e111.member_4)) + _e111.member_3), (select((_e309 - _e111.member_4), _e309, (_e309 < _e111.member_4)) + _e111.member_3), (select((_e314 - _e111.member_4), _e314, (_e314 < _e111.member_4)) + _e111.member_3));
                    } else {
                        let _e232 = (_e111.member_4 - 1u);
                        let _e233 = (_e190 * 2654435761u);
                        let _e234 = (_e212 * 805459861u);
                        let _e235 = (_e168 + 1u);
                        let _e236 = (_e233 + 2654435761u);
                        let _e237 = (_e234 + 805459861u);
                        let _e238 = (_e168 ^ _e233);
                        let _e242 = (_e235 ^ _e233);
                        let _e246 = (_e168 ^ _e236);
                        let _e250 = (_e235 ^ _e236);
                        phi_394_ = array<u32, 8>((((_e238 ^ _e234) & _e232) + _e111.member_3), (((_e242 ^ _e234) & _e232) + _e111.member_3), (((_e246 ^ _e234) & _e232) + _e111.member_3), (((_e250 ^ _e234) & _e232) + _e111.member_3), (((_e238 ^ _e237) & _e232) + _e111.member_3), (((_e242 ^ _e237) & _e232) + _e111.member_3), (((_e246 ^ _e237) & _e232) + _e111.member_3), (((_e250 ^ _e237) & _e232) + _e111.member_3));
                    }
                    let _e321 = phi_394_;
                    let _e330 = (_e321[0] * _e46);
                    let _e331 = (_e321[1] * _e46);
                    let _e332 = (_e321[2] * _e46);
                    let _e333 = (_e321[3] * _e46);
                    let _e334 = (_e321[4] * _e46);
                    let _e335 = (_e321[5] * _e46);
                    let _e336 = (_e321[6] * _e46);
                    let _e337 = (_e321[7] * _e46);
                    if _e108 {
                        let _e341 = atomicMax((&global_9.member[(_e330 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e345 = atomicMax((&global_9.member[(_e331 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e349 = atomicMax((&global_9.member[(_e332 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e353 = atomicMax((&global_9.member[(_e333 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e357 = atomicMax((&global_9.member[(_e334 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e361 = atomicMax((&global_9.member[(_e335 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e365 = atomicMax((&global_9.member[(_e336 / 64u)]), 1u);
                    }
                    if _e108 {
                        let _e369 = atomicMax((&global_9.member[(_e337 / 64u)]), 1u);
                    }
                    let _e372 = global_4.member[0u];
                    phi_462_ = 0u;
                    phi_465_ = _e71;
                    loop {
                        let _e374 = phi_462_;
                        let _e376 = phi_465_;
                        if (_e374 < _e46) {
                            let _e380 = global_5.member[_e376];
                            let _e381 = -(_e380);
                            let _e386 = select(0f, (_e380 * _e372), (0.000000000000000000000000000000000000011754944f <= select(_e381, _e380, (_e380 > _e381))));
                            let _e387 = (_e386 * (_e216 * _e215));
                            if _e108 {
                                let _e389 = abs(_e387);
                                let _e392 = u32((_e389 * (1f / 4294967300f)));
                                let _e395 = (_e389 - (f32(_e392) * 4294967300f));
                                let _e396 = u32(_e395);
                                if ((_e395 - f32(_e396)) >= 0.5f) {
                                    phi_490_ = (_e396 + 1u);
                                } else {
                                    phi_490_ = _e396;
                                }
                                let _e402 = phi_490_;
                                if (_e387 < 0f) {
                                    let _e406 = (~(_e402) + 1u);
                                    if (_e406 == 0u) {
                                        phi_505_ = (~(_e392) + 1u);
                                    } else {
                                        phi_505_ = ~(_e392);
                                    }
                                    let _e412 = phi_505_;
                                    phi_507_ = array<u32, 2>(_e406, _e412);
                                } else {
                                    phi_507_ = array<u32, 2>(_e402, _e392);
                                }
                                let _e415 = phi_507_;
                                let _e418 = (2u * (_e330 + _e374));
                                let _e421 = atomicAdd((&global_10.member[_e418]), _e415[0]);
                                let _e425 = (_e415[1] + select(0u, 1u, ((_e421 + _e415[0]) < _e415[0])));
                                if (_e425 == 0u) {
                                } else {
                                    let _e430 = atomicAdd((&global_10.member[(_e418 + 1u)]), _e425);
                                }
                            }
                            let _e431 = (_e386 * (_e217 * _e215));
                            if _e108 {
                                let _e433 = abs(_e431);
                                let _e436 = u32((_e433 * (1f / 4294967300f)));
                                let _e439 = (_e433 - (f32(_e436) * 4294967300f));
                                let _e440 = u32(_e439);
                                if ((_e439 - f32(_e440)) >= 0.5f) {
                                    phi_539_ = (_e440 + 1u);
                                } else {
                                    phi_539_ = _e440;
                                }
                                let _e446 = phi_539_;
                                if (_e431 < 0f) {
                                    let _e450 = (~(_e446) + 1u);
                                    if (_e450 == 0u) {
                                        phi_554_ = (~(_e436) + 1u);
                                    } else {
                                        phi_554_ = ~(_e436);
                                    }
                                    let _e456 = phi_554_;
                                    phi_556_ = array<u32, 2>(_e450, _e456);
                                } else {
                                    phi_556_ = array<u32, 2>(_e446, _e436);
                                }
                                let _e459 = phi_556_;
                                let _e462 = (2u * (_e331 + _e374));
                                let _e465 = atomicAdd((&global_10.member[_e462]), _e459[0]);
                                let _e469 = (_e459[1] + select(0u, 1u, ((_e465 + _e459[0]) < _e459[0])));
                                if (_e469 == 0u) {
                                } else {
                                    let _e474 = atomicAdd((&global_10.member[(_e462 + 1u)]), _e469);
                                }
                            }
                            let _e475 = (_e386 * (_e218 * _e215));
                            if _e108 {
                                let _e477 = abs(_e475);
                                let _e480 = u32((_e477 * (1f / 4294967300f)));
                                let _e483 = (_e477 - (f32(_e480) * 4294967300f));
                                let _e484 = u32(_e483);
                                if ((_e483 - f32(_e484)) >= 0.5f) {
                                    phi_588_ = (_e484 + 1u);
                                } else {
                                    phi_588_ = _e484;
                                }
                                let _e490 = phi_588_;
                                if (_e475 < 0f) {
                                    let _e494 = (~(_e490) + 1u);
                                    if (_e494 == 0u) {
                                        phi_603_ = (~(_e480) + 1u);
                                    } else {
                                        phi_603_ = ~(_e480);
                                    }
                                    let _e500 = phi_603_;
                                    phi_605_ = array<u32, 2>(_e494, _e500);
                                } else {
                                    phi_605_ = array<u32, 2>(_e490, _e480);
                                }
                                let _e503 = phi_605_;
                                let _e506 = (2u * (_e332 + _e374));
                                let _e509 = atomicAdd((&global_10.member[_e506]), _e503[0]);
                                let _e513 = (_e503[1] + select(0u, 1u, ((_e509 + _e503[0]) < _e503[0])));
                                if (_e513 == 0u) {
                                } else {
                                    let _e518 = atomicAdd((&global_10.member[(_e506 + 1u)]), _e513);
                                }
                            }
                            let _e519 = (_e386 * (_e219 * _e215));
                            if _e108 {
                                let _e521 = abs(_e519);
                                let _e524 = u32((_e521 * (1f / 4294967300f)));
                                let _e527 = (_e521 - (f32(_e524) * 4294967300f));
                                let _e528 = u32(_e527);
                                if ((_e527 - f32(_e528)) >= 0.5f) {
                                    phi_637_ = (_e528 + 1u);
                                } else {
                                    phi_637_ = _e528;
                                }
                                let _e534 = phi_637_;
                                if (_e519 < 0f) {
                                    let _e538 = (~(_e534) + 1u);
                                    if (_e538 == 0u) {
                                        phi_652_ = (~(_e524) + 1u);
                                    } else {
                                        phi_652_ = ~(_e524);
                                    }
                                    let _e544 = phi_652_;
                                    phi_654_ = array<u32, 2>(_e538, _e544);
                                } else {
                                    phi_654_ = array<u32, 2>(_e534, _e524);
                                }
                                let _e547 = phi_654_;
                                let _e550 = (2u * (_e333 + _e374));
                                let _e553 = atomicAdd((&global_10.member[_e550]), _e547[0]);
                                let _e557 = (_e547[1] + select(0u, 1u, ((_e553 + _e547[0]) < _e547[0])));
                                if (_e557 == 0u) {
                                } else {
                                    let _e562 = atomicAdd((&global_10.member[(_e550 + 1u)]), _e557);
                                }
                            }
                            let _e563 = (_e386 * (_e216 * _e210));
                            if _e108 {
                                let _e565 = abs(_e563);
                                let _e568 = u32((_e565 * (1f / 4294967300f)));
                                let _e571 = (_e565 - (f32(_e568) * 4294967300f));
                                let _e572 = u32(_e571);
                                if ((_e571 - f32(_e572)) >= 0.5f) {
                                    phi_686_ = (_e572 + 1u);
                                } else {
                                    phi_686_ = _e572;
                                }
                                let _e578 = phi_686_;
                                if (_e563 < 0f) {
                                    let _e582 = (~(_e578) + 1u);
                                    if (_e582 == 0u) {
                                        phi_701_ = (~(_e568) + 1u);
                                    } else {
                                        phi_701_ = ~(_e568);
                                    }
                                    let _e588 = phi_701_;
                                    phi_703_ = array<u32, 2>(_e582, _e588);
                                } else {
                                    phi_703_ = array<u32, 2>(_e578, _e568);
                                }
                                let _e591 = phi_703_;
                                let _e594 = (2u * (_e334 + _e374));
                                let _e597 = atomicAdd((&global_10.member[_e594]), _e591[0]);
                                let _e601 = (_e591[1] + select(0u, 1u, ((_e597 + _e591[0]) < _e591[0])));
                                if (_e601 == 0u) {
                                } else {
                                    let _e606 = atomicAdd((&global_10.member[(_e594 + 1u)]), _e601);
                                }
                            }
                            let _e607 = (_e386 * (_e217 * _e210));
                            if _e108 {
                                let _e609 = abs(_e607);
                                let _e612 = u32((_e609 * (1f / 4294967300f)));
                                let _e615 = (_e609 - (f32(_e612) * 4294967300f));
                                let _e616 = u32(_e615);
                                if ((_e615 - f32(_e616)) >= 0.5f) {
                                    phi_735_ = (_e616 + 1u);
                                } else {
                                    phi_735_ = _e616;
                                }
                                let _e622 = phi_735_;
                                if (_e607 < 0f) {
                                    let _e626 = (~(_e622) + 1u);
                                    if (_e626 == 0u) {
                                        phi_750_ = (~(_e612) + 1u);
                                    } else {
                                        phi_750_ = ~(_e612);
                                    }
                                    let _e632 = phi_750_;
                                    phi_752_ = array<u32, 2>(_e626, _e632);
                                } else {
                                    phi_752_ = array<u32, 2>(_e622, _e612);
                                }
                                let _e635 = phi_752_;
                                let _e638 = (2u * (_e335 + _e374));
                                let _e641 = atomicAdd((&global_10.member[_e638]), _e635[0]);
                                let _e645 = (_e635[1] + select(0u, 1u, ((_e641 + _e635[0]) < _e635[0])));
                                if (_e645 == 0u) {
                                } else {
                                    let _e650 = atomicAdd((&global_10.member[(_e638 + 1u)]), _e645);
                                }
                            }
                            let _e651 = (_e386 * (_e218 * _e210));
                            if _e108 {
                                let _e653 = abs(_e651);
                                let _e656 = u32((_e653 * (1f / 4294967300f)));
                                let _e659 = (_e653 - (f32(_e656) * 4294967300f));
                                let _e660 = u32(_e659);
                                if ((_e659 - f32(_e660)) >= 0.5f) {
                                    phi_784_ = (_e660 + 1u);
                                } else {
                                    phi_784_ = _e660;
                                }
                                let _e666 = phi_784_;
                                if (_e651 < 0f) {
                                    let _e670 = (~(_e666) + 1u);
                                    if (_e670 == 0u) {
                                        phi_799_ = (~(_e656) + 1u);
                                    } else {
                                        phi_799_ = ~(_e656);
                                    }
                                    let _e676 = phi_799_;
                                    phi_801_ = array<u32, 2>(_e670, _e676);
                                } else {
                                    phi_801_ = array<u32, 2>(_e666, _e656);
                                }
                                let _e679 = phi_801_;
                                let _e682 = (2u * (_e336 + _e374));
                                let _e685 = atomicAdd((&global_10.member[_e682]), _e679[0]);
                                let _e689 = (_e679[1] + select(0u, 1u, ((_e685 + _e679[0]) < _e679[0])));
                                if (_e689 == 0u) {
                                } else {
                                    let _e694 = atomicAdd((&global_10.member[(_e682 + 1u)]), _e689);
                                }
                            }
                            let _e695 = (_e386 * (_e219 * _e210));
                            if _e108 {
                                let _e697 = abs(_e695);
                                let _e700 = u32((_e697 * (1f / 4294967300f)));
                                let _e703 = (_e697 - (f32(_e700) * 4294967300f));
                                let _e704 = u32(_e703);
                                if ((_e703 - f32(_e704)) >= 0.5f) {
                                    phi_833_ = (_e704 + 1u);
                                } else {
                                    phi_833_ = _e704;
                                }
                                let _e710 = phi_833_;
                                if (_e695 < 0f) {
                                    let _e714 = (~(_e710) + 1u);
                                    if (_e714 == 0u) {
                                        phi_848_ = (~(_e700) + 1u);
                                    } else {
                                        phi_848_ = ~(_e700);
                                    }
                                    let _e720 = phi_848_;
                                    phi_850_ = array<u32, 2>(_e714, _e720);
                                } else {
                                    phi_850_ = array<u32, 2>(_e710, _e700);
                                }
                                let _e723 = phi_850_;
                                let _e726 = (2u * (_e337 + _e374));
                                let _e729 = atomicAdd((&global_10.member[_e726]), _e723[0]);
                                let _e733 = (_e723[1] + select(0u, 1u, ((_e729 + _e723[0]) < _e723[0])));
                                if (_e733 == 0u) {
                                } else {
                                    let _e738 = atomicAdd((&global_10.member[(_e726 + 1u)]), _e733);
                                }
                            }
                            local_7 = (_e374 + 1u);
                            local_8 = (_e376 + _e63);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e759 = local_7;
                            phi_462_ = _e759;
                            let _e762 = local_8;
                            phi_465_ = _e762;
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
