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
    var phi_488_: u32;
    var phi_491_: u32;
    var phi_516_: u32;
    var phi_531_: u32;
    var phi_533_: array<u32, 2>;
    var phi_565_: u32;
    var phi_580_: u32;
    var phi_582_: array<u32, 2>;
    var phi_614_: u32;
    var phi_629_: u32;
    var phi_631_: array<u32, 2>;
    var phi_663_: u32;
    var phi_678_: u32;
    var phi_680_: array<u32, 2>;
    var phi_712_: u32;
    var phi_727_: u32;
    var phi_729_: array<u32, 2>;
    var phi_761_: u32;
    var phi_776_: u32;
    var phi_778_: array<u32, 2>;
    var phi_810_: u32;
    var phi_825_: u32;
    var phi_827_: array<u32, 2>;
    var phi_859_: u32;
    var phi_874_: u32;
    var phi_876_: array<u32, 2>;
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
                        let _e766 = local_3;
                        phi_202_ = _e766;
                        let _e769 = local_4;
                        phi_205_ = _e769;
                        let _e772 = local_5;
                        phi_207_ = _e772;
                        let _e775 = local_6;
                        phi_209_ = _e775;
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
                    let _e341 = atomicLoad((&global_9.member[(_e330 / 64u)]));
                    let _e346 = atomicLoad((&global_9.member[(_e331 / 64u)]));
                    let _e351 = atomicLoad((&global_9.member[(_e332 / 64u)]));
                    let _e356 = atomicLoad((&global_9.member[(_e333 / 64u)]));
                    let _e361 = atomicLoad((&global_9.member[(_e334 / 64u)]));
                    let _e366 = atomicLoad((&global_9.member[(_e335 / 64u)]));
                    let _e371 = atomicLoad((&global_9.member[(_e336 / 64u)]));
                    let _e376 = atomicLoad((&global_9.member[(_e337 / 64u)]));
                    if ((((((((_e341 != 0u) && (_e346 != 0u)) && (_e351 != 0u)) && (_e356 != 0u)) && (_e361 != 0u)) && (_e366 != 0u)) && (_e371 != 0u)) && (_e376 != 0u)) {
                    } else {
                        if _e108 {
                            let _e385 = atomicMax((&global_9.member[(_e330 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e386 = atomicMax((&global_9.member[(_e331 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e387 = atomicMax((&global_9.member[(_e332 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e388 = atomicMax((&global_9.member[(_e333 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e389 = atomicMax((&global_9.member[(_e334 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e390 = atomicMax((&global_9.member[(_e335 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e391 = atomicMax((&global_9.member[(_e336 / 64u)]), 1u);
                        }
                        if _e108 {
                            let _e392 = atomicMax((&global_9.member[(_e337 / 64u)]), 1u);
                        }
                    }
                    let _e395 = global_4.member[0u];
                    phi_488_ = 0u;
                    phi_491_ = _e71;
                    loop {
                        let _e397 = phi_488_;
                        let _e399 = phi_491_;
                        if (_e397 < _e46) {
                            let _e403 = global_5.member[_e399];
                            let _e404 = -(_e403);
                            let _e409 = select(0f, (_e403 * _e395), (0.000000000000000000000000000000000000011754944f <= select(_e404, _e403, (_e403 > _e404))));
                            let _e410 = (_e409 * (_e216 * _e215));
                            if _e108 {
                                let _e412 = abs(_e410);
                                let _e415 = u32((_e412 * (1f / 4294967300f)));
                                let _e418 = (_e412 - (f32(_e415) * 4294967300f));
                                let _e419 = u32(_e418);
                                if ((_e418 - f32(_e419)) >= 0.5f) {
                                    phi_516_ = (_e419 + 1u);
                                } else {
                                    phi_516_ = _e419;
                                }
                                let _e425 = phi_516_;
                                if (_e410 < 0f) {
                                    let _e429 = (~(_e425) + 1u);
                                    if (_e429 == 0u) {
                                        phi_531_ = (~(_e415) + 1u);
                                    } else {
                                        phi_531_ = ~(_e415);
                                    }
                                    let _e435 = phi_531_;
                                    phi_533_ = array<u32, 2>(_e429, _e435);
                                } else {
                                    phi_533_ = array<u32, 2>(_e425, _e415);
                                }
                                let _e438 = phi_533_;
                                let _e441 = (2u * (_e330 + _e397));
                                let _e444 = atomicAdd((&global_10.member[_e441]), _e438[0]);
                                let _e448 = (_e438[1] + select(0u, 1u, ((_e444 + _e438[0]) < _e438[0])));
                                if (_e448 == 0u) {
                                } else {
                                    let _e453 = atomicAdd((&global_10.member[(_e441 + 1u)]), _e448);
                                }
                            }
                            let _e454 = (_e409 * (_e217 * _e215));
                            if _e108 {
                                let _e456 = abs(_e454);
                                let _e459 = u32((_e456 * (1f / 4294967300f)));
                                let _e462 = (_e456 - (f32(_e459) * 4294967300f));
                                let _e463 = u32(_e462);
                                if ((_e462 - f32(_e463)) >= 0.5f) {
                                    phi_565_ = (_e463 + 1u);
                                } else {
                                    phi_565_ = _e463;
                                }
                                let _e469 = phi_565_;
                                if (_e454 < 0f) {
                                    let _e473 = (~(_e469) + 1u);
                                    if (_e473 == 0u) {
                                        phi_580_ = (~(_e459) + 1u);
                                    } else {
                                        phi_580_ = ~(_e459);
                                    }
                                    let _e479 = phi_580_;
                                    phi_582_ = array<u32, 2>(_e473, _e479);
                                } else {
                                    phi_582_ = array<u32, 2>(_e469, _e459);
                                }
                                let _e482 = phi_582_;
                                let _e485 = (2u * (_e331 + _e397));
                                let _e488 = atomicAdd((&global_10.member[_e485]), _e482[0]);
                                let _e492 = (_e482[1] + select(0u, 1u, ((_e488 + _e482[0]) < _e482[0])));
                                if (_e492 == 0u) {
                                } else {
                                    let _e497 = atomicAdd((&global_10.member[(_e485 + 1u)]), _e492);
                                }
                            }
                            let _e498 = (_e409 * (_e218 * _e215));
                            if _e108 {
                                let _e500 = abs(_e498);
                                let _e503 = u32((_e500 * (1f / 4294967300f)));
                                let _e506 = (_e500 - (f32(_e503) * 4294967300f));
                                let _e507 = u32(_e506);
                                if ((_e506 - f32(_e507)) >= 0.5f) {
                                    phi_614_ = (_e507 + 1u);
                                } else {
                                    phi_614_ = _e507;
                                }
                                let _e513 = phi_614_;
                                if (_e498 < 0f) {
                                    let _e517 = (~(_e513) + 1u);
                                    if (_e517 == 0u) {
                                        phi_629_ = (~(_e503) + 1u);
                                    } else {
                                        phi_629_ = ~(_e503);
                                    }
                                    let _e523 = phi_629_;
                                    phi_631_ = array<u32, 2>(_e517, _e523);
                                } else {
                                    phi_631_ = array<u32, 2>(_e513, _e503);
                                }
                                let _e526 = phi_631_;
                                let _e529 = (2u * (_e332 + _e397));
                                let _e532 = atomicAdd((&global_10.member[_e529]), _e526[0]);
                                let _e536 = (_e526[1] + select(0u, 1u, ((_e532 + _e526[0]) < _e526[0])));
                                if (_e536 == 0u) {
                                } else {
                                    let _e541 = atomicAdd((&global_10.member[(_e529 + 1u)]), _e536);
                                }
                            }
                            let _e542 = (_e409 * (_e219 * _e215));
                            if _e108 {
                                let _e544 = abs(_e542);
                                let _e547 = u32((_e544 * (1f / 4294967300f)));
                                let _e550 = (_e544 - (f32(_e547) * 4294967300f));
                                let _e551 = u32(_e550);
                                if ((_e550 - f32(_e551)) >= 0.5f) {
                                    phi_663_ = (_e551 + 1u);
                                } else {
                                    phi_663_ = _e551;
                                }
                                let _e557 = phi_663_;
                                if (_e542 < 0f) {
                                    let _e561 = (~(_e557) + 1u);
                                    if (_e561 == 0u) {
                                        phi_678_ = (~(_e547) + 1u);
                                    } else {
                                        phi_678_ = ~(_e547);
                                    }
                                    let _e567 = phi_678_;
                                    phi_680_ = array<u32, 2>(_e561, _e567);
                                } else {
                                    phi_680_ = array<u32, 2>(_e557, _e547);
                                }
                                let _e570 = phi_680_;
                                let _e573 = (2u * (_e333 + _e397));
                                let _e576 = atomicAdd((&global_10.member[_e573]), _e570[0]);
                                let _e580 = (_e570[1] + select(0u, 1u, ((_e576 + _e570[0]) < _e570[0])));
                                if (_e580 == 0u) {
                                } else {
                                    let _e585 = atomicAdd((&global_10.member[(_e573 + 1u)]), _e580);
                                }
                            }
                            let _e586 = (_e409 * (_e216 * _e210));
                            if _e108 {
                                let _e588 = abs(_e586);
                                let _e591 = u32((_e588 * (1f / 4294967300f)));
                                let _e594 = (_e588 - (f32(_e591) * 4294967300f));
                                let _e595 = u32(_e594);
                                if ((_e594 - f32(_e595)) >= 0.5f) {
                                    phi_712_ = (_e595 + 1u);
                                } else {
                                    phi_712_ = _e595;
                                }
                                let _e601 = phi_712_;
                                if (_e586 < 0f) {
                                    let _e605 = (~(_e601) + 1u);
                                    if (_e605 == 0u) {
                                        phi_727_ = (~(_e591) + 1u);
                                    } else {
                                        phi_727_ = ~(_e591);
                                    }
                                    let _e611 = phi_727_;
                                    phi_729_ = array<u32, 2>(_e605, _e611);
                                } else {
                                    phi_729_ = array<u32, 2>(_e601, _e591);
                                }
                                let _e614 = phi_729_;
                                let _e617 = (2u * (_e334 + _e397));
                                let _e620 = atomicAdd((&global_10.member[_e617]), _e614[0]);
                                let _e624 = (_e614[1] + select(0u, 1u, ((_e620 + _e614[0]) < _e614[0])));
                                if (_e624 == 0u) {
                                } else {
                                    let _e629 = atomicAdd((&global_10.member[(_e617 + 1u)]), _e624);
                                }
                            }
                            let _e630 = (_e409 * (_e217 * _e210));
                            if _e108 {
                                let _e632 = abs(_e630);
                                let _e635 = u32((_e632 * (1f / 4294967300f)));
                                let _e638 = (_e632 - (f32(_e635) * 4294967300f));
                                let _e639 = u32(_e638);
                                if ((_e638 - f32(_e639)) >= 0.5f) {
                                    phi_761_ = (_e639 + 1u);
                                } else {
                                    phi_761_ = _e639;
                                }
                                let _e645 = phi_761_;
                                if (_e630 < 0f) {
                                    let _e649 = (~(_e645) + 1u);
                                    if (_e649 == 0u) {
                                        phi_776_ = (~(_e635) + 1u);
                                    } else {
                                        phi_776_ = ~(_e635);
                                    }
                                    let _e655 = phi_776_;
                                    phi_778_ = array<u32, 2>(_e649, _e655);
                                } else {
                                    phi_778_ = array<u32, 2>(_e645, _e635);
                                }
                                let _e658 = phi_778_;
                                let _e661 = (2u * (_e335 + _e397));
                                let _e664 = atomicAdd((&global_10.member[_e661]), _e658[0]);
                                let _e668 = (_e658[1] + select(0u, 1u, ((_e664 + _e658[0]) < _e658[0])));
                                if (_e668 == 0u) {
                                } else {
                                    let _e673 = atomicAdd((&global_10.member[(_e661 + 1u)]), _e668);
                                }
                            }
                            let _e674 = (_e409 * (_e218 * _e210));
                            if _e108 {
                                let _e676 = abs(_e674);
                                let _e679 = u32((_e676 * (1f / 4294967300f)));
                                let _e682 = (_e676 - (f32(_e679) * 4294967300f));
                                let _e683 = u32(_e682);
                                if ((_e682 - f32(_e683)) >= 0.5f) {
                                    phi_810_ = (_e683 + 1u);
                                } else {
                                    phi_810_ = _e683;
                                }
                                let _e689 = phi_810_;
                                if (_e674 < 0f) {
                                    let _e693 = (~(_e689) + 1u);
                                    if (_e693 == 0u) {
                                        phi_825_ = (~(_e679) + 1u);
                                    } else {
                                        phi_825_ = ~(_e679);
                                    }
                                    let _e699 = phi_825_;
                                    phi_827_ = array<u32, 2>(_e693, _e699);
                                } else {
                                    phi_827_ = array<u32, 2>(_e689, _e679);
                                }
                                let _e702 = phi_827_;
                                let _e705 = (2u * (_e336 + _e397));
                                let _e708 = atomicAdd((&global_10.member[_e705]), _e702[0]);
                                let _e712 = (_e702[1] + select(0u, 1u, ((_e708 + _e702[0]) < _e702[0])));
                                if (_e712 == 0u) {
                                } else {
                                    let _e717 = atomicAdd((&global_10.member[(_e705 + 1u)]), _e712);
                                }
                            }
                            let _e718 = (_e409 * (_e219 * _e210));
                            if _e108 {
                                let _e720 = abs(_e718);
                                let _e723 = u32((_e720 * (1f / 4294967300f)));
                                let _e726 = (_e720 - (f32(_e723) * 4294967300f));
                                let _e727 = u32(_e726);
                                if ((_e726 - f32(_e727)) >= 0.5f) {
                                    phi_859_ = (_e727 + 1u);
                                } else {
                                    phi_859_ = _e727;
                                }
                                let _e733 = phi_859_;
                                if (_e718 < 0f) {
                                    let _e737 = (~(_e733) + 1u);
                                    if (_e737 == 0u) {
                                        phi_874_ = (~(_e723) + 1u);
                                    } else {
                                        phi_874_ = ~(_e723);
                                    }
                                    let _e743 = phi_874_;
                                    phi_876_ = array<u32, 2>(_e737, _e743);
                                } else {
                                    phi_876_ = array<u32, 2>(_e733, _e723);
                                }
                                let _e746 = phi_876_;
                                let _e749 = (2u * (_e337 + _e397));
                                let _e752 = atomicAdd((&global_10.member[_e749]), _e746[0]);
                                let _e756 = (_e746[1] + select(0u, 1u, ((_e752 + _e746[0]) < _e746[0])));
                                if (_e756 == 0u) {
                                } else {
                                    let _e761 = atomicAdd((&global_10.member[(_e749 + 1u)]), _e756);
                                }
                            }
                            local_7 = (_e397 + 1u);
                            local_8 = (_e399 + _e63);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e782 = local_7;
                            phi_488_ = _e782;
                            let _e785 = local_8;
                            phi_491_ = _e785;
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
