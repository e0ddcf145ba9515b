struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_3: type_5;
@group(0) @binding(0) 
var<uniform> global_4: type_16;
@group(0) @binding(1) 
var<storage> global_5: type_20;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_26;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_26;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_26;

fn function_() {
    var phi_205_: u32;
    var phi_208_: u32;
    var phi_210_: f32;
    var phi_212_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_397_: array<u32, 8>;
    var phi_465_: u32;
    var phi_468_: u32;
    var phi_487_: f32;
    var phi_497_: u32;
    var phi_511_: u32;
    var phi_513_: array<u32, 2>;
    var phi_534_: f32;
    var phi_544_: u32;
    var phi_558_: u32;
    var phi_560_: array<u32, 2>;
    var phi_581_: f32;
    var phi_591_: u32;
    var phi_605_: u32;
    var phi_607_: array<u32, 2>;
    var phi_628_: f32;
    var phi_638_: u32;
    var phi_652_: u32;
    var phi_654_: array<u32, 2>;
    var phi_675_: f32;
    var phi_685_: u32;
    var phi_699_: u32;
    var phi_701_: array<u32, 2>;
    var phi_722_: f32;
    var phi_732_: u32;
    var phi_746_: u32;
    var phi_748_: array<u32, 2>;
    var phi_769_: f32;
    var phi_779_: u32;
    var phi_793_: u32;
    var phi_795_: array<u32, 2>;
    var phi_816_: f32;
    var phi_826_: u32;
    var phi_840_: u32;
    var phi_842_: array<u32, 2>;
    var local_3: u32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = global;
            let _e33 = global_1;
            let _e34 = global_2;
            let _e40 = ((_e33.x + (_e33.y * _e34.x)) * 64u);
            let _e45 = global_4.member.member;
            if ((_e40 + _e32.x) < _e45) {
                let _e49 = global_4.member.member_3;
                let _e53 = global_4.member.member_2;
                let _e58 = global_4.member.member_6;
                let _e61 = global_4.member.member_4;
                let _e62 = (_e61 == 0u);
                if _e62 {
                    break;
                }
                let _e63 = (_e40 / _e61);
                let _e66 = global_4.member.member_1;
                let _e70 = (_e40 - (_e63 * _e61));
                let _e74 = ((((_e63 * (_e58 * _e66)) + _e70) + _e32.x) + ((_e53 + (_e33.z * _e49)) * _e66));
                let _e77 = global_7.member[2u];
                phi_205_ = 0u;
                phi_208_ = _e74;
                phi_210_ = 0f;
                phi_212_ = 0f;
                loop {
                    let _e79 = phi_205_;
                    let _e81 = phi_208_;
                    let _e83 = phi_210_;
                    let _e85 = phi_212_;
                    local = _e83;
                    local_1 = _e85;
                    local_2 = _e83;
                    if (_e79 < _e49) {
                        let _e89 = global_6.member[_e81];
                        let _e90 = -(_e89);
                        let _e92 = select(_e90, _e89, (_e89 > _e90));
                        local_3 = (_e79 + 1u);
                        local_4 = (_e81 + _e66);
                        local_5 = select(1f, _e83, (_e92 <= _e77));
                        local_6 = select(_e92, _e85, (_e85 > _e92));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e746 = local_3;
                        phi_205_ = _e746;
                        let _e749 = local_4;
                        phi_208_ = _e749;
                        let _e752 = local_5;
                        phi_210_ = _e752;
                        let _e755 = local_6;
                        phi_212_ = _e755;
                    }
                }
                let _e100 = local;
                if (0f < _e100) {
                    let _e104 = atomicMax((&global_10.member[0u]), 1u);
                }
                let _e106 = local_1;
                let _e109 = local_2;
                let _e111 = select(false, (_e109 < 1f), (0.000000000000000000000000000000000000011754944f <= _e106));
                if _e111 {
                    let _e114 = global_5.member[_e33.z];
                    let _e117 = global_4.member.member_5;
                    if _e62 {
                        break;
                    }
                    let _e121 = (((_e63 * (_e117 * _e66)) + _e70) + _e32.x);
                    let _e124 = global_3.member[_e121];
                    let _e125 = (3u * _e66);
                    let _e129 = global_3.member[(_e121 + _e125)];
                    let _e130 = (_e66 + _e121);
                    let _e133 = global_3.member[_e130];
                    let _e137 = global_3.member[(_e130 + _e125)];
                    let _e139 = ((2u * _e66) + _e121);
                    let _e142 = global_3.member[_e139];
                    let _e146 = global_3.member[(_e139 + _e125)];
                    let _e147 = (_e124 + _e129);
                    let _e150 = select(false, (_e147 < 1f), (0f < _e147));
                    let _e153 = select(select(0f, 1f, (1f <= _e147)), _e124, _e150);
                    let _e156 = (_e153 * _e114.member);
                    let _e159 = (_e114.member + _e114.member_1);
                    let _e163 = trunc(_e156);
                    let _e165 = ((_e156 - _e163) + (((_e153 * _e114.member_1) + (select(0f, _e129, _e150) * _e159)) + 0.5f));
                    let _e167 = select(0f, _e165, (_e165 > 0f));
                    let _e168 = trunc(_e167);
                    let _e169 = (_e167 - _e168);
                    let _e171 = u32((_e163 + _e168));
                    let _e172 = (_e133 + _e137);
                    let _e175 = select(false, (_e172 < 1f), (0f < _e172));
                    let _e178 = select(select(0f, 1f, (1f <= _e172)), _e133, _e175);
                    let _e180 = (_e178 * _e114.member);
                    let _e185 = trunc(_e180);
                    let _e187 = ((_e180 - _e185) + (((_e178 * _e114.member_1) + (select(0f, _e137, _e175) * _e159)) + 0.5f));
                    let _e189 = select(0f, _e187, (_e187 > 0f));
                    let _e190 = trunc(_e189);
                    let _e191 = (_e189 - _e190);
                    let _e193 = u32((_e185 + _e190));
                    let _e194 = (_e142 + _e146);
                    let _e197 = select(false, (_e194 < 1f), (0f < _e194));
                    let _e200 = select(select(0f, 1f, (1f <= _e194)), _e142, _e197);
                    let _e202 = (_e200 * _e114.member);
                    let _e207 = trunc(_e202);
                    let _e209 = ((_e202 - _e207) + (((_e200 * _e114.member_1) + (select(0f, _e146, _e197) * _e159)) + 0.5f));
                    let _e211 = select(0f, _e209, (_e209 > 0f));
                    let _e212 = trunc(_e211);
                    let _e213 = (_e211 - _e212);
                    let _e215 = u32((_e207 + _e212));
                    let _e216 = (1f - _e169);
                    let _e217 = (1f - _e191);
                    let _e218 = (1f - _e213);
                    let _e219 = (_e216 * _e217);
                    let _e220 = (_e169 * _e217);
                    let _e221 = (_e216 * _e191);
                    let _e222 = (_e169 * _e191);
                    if (_e114.member_5 == 0u) {
                        let _e272 = (_e114.member_2 * _e114.member_2);
                        let _e273 = (_e193 * _e114.member_2);
                        let _e274 = (_e215 * _e272);
                        let _e275 = (_e171 + 1u);
                        let _e276 = (_e273 + _e114.member_2);
                        let _e277 = (_e274 + _e272);
                        let _e278 = (_e171 + _e273);
                        let _e279 = (_e278 + _e274);
                        let _e284 = (_e275 + _e273);
                        let _e285 = (_e284 + _e274);
                        let _e290 = (_e171 + _e276);
                        let _e291 = (_e290 + _e274);
                        let _e296 = (_e275 + _e276);
                        let _e297 = (_e296 + _e274);
                        let _e302 = (_e278 + _e277);
                        let _e307 = (_e284 + _e277);
                        let _e312 = (_e290 + _e277);
                        let _e317 = (_e296 + _e277);
                        phi_397_ = array<u32, 8>((select((_e279 - _e114.member_4), _e279, (_e279 < _e114.member_4)) + _e114.member_3), (select((_e285 - _e114.member_4), _e285, (_e285 < _e114.member_4)) + _e114.member_3), (select((_e291 - _e114.member_4), _e291, (_e291 < _e114.member_4)) + _e114.member_3), (select((_e297 - _e114.member_4), _e297, (_e297 < _e114.member_4)) + _e114.member_3), (select((_e302 - _e114.member_4), _e302, (_e302 < _e114.member_4)) + _e114.member_3), (select((_e307 - _e114.member_4), _e307, (_e307 < _e114.member_4)) + _e114.member_3), (select((_e312 - _e114.member_4), _e312, (_e312 < _e114.member_4)) + _e114.member_3), (select((_e317 - _e114.member_4), _e317, (_e317 < _e114.member_4)) + _e114.member_3));
                    } else {
                        let _e235 = (_e114.member_4 - 1u);
                        let _e236 = (_e193 * 2654435761u);
                        let _e237 = (_e215 * 805459861u);
                        let _e238 = (_e171 + 1u);
                        let _e239 = (_e236 + 2654435761u);
                        let _e240 = (_e237 + 805459861u);
                        let _e241 = (_e171 ^ _e236);
                        let _e245 = (_e238 ^ _e236);
                        let _e249 = (_e171 ^ _e239);
                        let _e253 = (_e238 ^ _e239);
                        phi_397_ = array<u32, 8>((((_e241 ^ _e237) & _e235) + _e114.member_3), (((_e245 ^ _e237) & _e235) + _e114.member_3), (((_e249 ^ _e237) & _e235) + _e114.member_3), (((_e253 ^ _e237) & _e235) + _e114.member_3), (((_e241 ^ _e240) & _e235) + _e114.member_3), (((_e245 ^ _e240) & _e235) + _e114.member_3), (((_e249 ^ _e240) & _e235) + _e114.member_3), (((_e253 ^ _e240) & _e235) + _e114.member_3));
                    }
                    let _e324 = phi_397_;
                    let _e333 = (_e324[0] * _e49);
                    let _e334 = (_e324[1] * _e49);
                    let _e335 = (_e324[2] * _e49);
                    let _e336 = (_e324[3] * _e49);
                    let _e337 = (_e324[4] * _e49);
                    let _e338 = (_e324[5] * _e49);
                    let _e339 = (_e324[6] * _e49);
                    let _e340 = (_e324[7] * _e49);
                    if _e111 {
                        let _e344 = atomicMax((&global_9.member[(_e333 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e348 = atomicMax((&global_9.member[(_e334 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e352 = atomicMax((&global_9.member[(_e335 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e356 = atomicMax((&global_9.member[(_e336 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e360 = atomicMax((&global_9.member[(_e337 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e364 = atomicMax((&global_9.member[(_e338 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e368 = atomicMax((&global_9.member[(_e339 / 64u)]), 1u);
                    }
                    if _e111 {
                        let _e372 = atomicMax((&global_9.member[(_e340 / 64u)]), 1u);
                    }
                    let _e375 = global_7.member[0u];
                    phi_465_ = 0u;
                    phi_468_ = _e74;
                    loop {
                        let _e377 = phi_465_;
                        let _e379 = phi_468_;
                        if (_e377 < _e49) {
                            let _e383 = global_6.member[_e379];
                            let _e384 = -(_e383);
                            let _e389 = select(0f, (_e383 * _e375), (0.000000000000000000000000000000000000011754944f <= select(_e384, _e383, (_e383 > _e384))));
                            let _e390 = (_e389 * (_e219 * _e218));
                            if _e111 {
                                let _e392 = (_e390 < 0f);
                                if _e392 {
                                    phi_487_ = -(_e390);
                                } else {
                                    phi_487_ = _e390;
                                }
                                let _e395 = phi_487_;
                                let _e397 = u32((_e395 * 0.00000000023283064f));
                                let _e400 = (_e395 - (f32(_e397) * 4294967300f));
                                let _e401 = u32(_e400);
                                if ((_e400 - f32(_e401)) >= 0.5f) {
                                    phi_497_ = (_e401 + 1u);
                                } else {
                                    phi_497_ = _e401;
                                }
                                let _e407 = phi_497_;
                                if _e392 {
                                    let _e410 = (~(_e407) + 1u);
                                    if (_e410 == 0u) {
                                        phi_511_ = (~(_e397) + 1u);
                                    } else {
                                        phi_511_ = ~(_e397);
                                    }
                                    let _e416 = phi_511_;
                                    phi_513_ = array<u32, 2>(_e410, _e416);
                                } else {
                                    phi_513_ = array<u32, 2>(_e407, _e397);
                                }
                                let _e419 = phi_513_;
                                let _e422 = (2u * (_e333 + _e377));
                                let _e425 = atomicAdd((&global_8.member[_e422]), _e419[0]);
                                let _e433 = atomicAdd((&global_8.member[(_e422 + 1u)]), (_e419[1] + select(0u, 1u, ((_e425 + _e419[0]) < _e419[0]))));
                            }
                            let _e434 = (_e389 * (_e220 * _e218));
                            if _e111 {
                                let _e436 = (_e434 < 0f);
                                if _e436 {
                                    phi_534_ = -(_e434);
                                } else {
                                    phi_534_ = _e434;
                                }
                                let _e439 = phi_534_;
                                let _e441 = u32((_e439 * 0.00000000023283064f));
                                let _e444 = (_e439 - (f32(_e441) * 4294967300f));
                                let _e445 = u32(_e444);
                                if ((_e444 - f32(_e445)) >= 0.5f) {
                                    phi_544_ = (_e445 + 1u);
                                } else {
                                    phi_544_ = _e445;
                                }
                                let _e451 = phi_544_;
                                if _e436 {
                                    let _e454 = (~(_e451) + 1u);
                                    if (_e454 == 0u) {
                                        phi_558_ = (~(_e441) + 1u);
                                    } else {
                                        phi_558_ = ~(_e441);
                                    }
                                    let _e460 = phi_558_;
                                    phi_560_ = array<u32, 2>(_e454, _e460);
                                } else {
                                    phi_560_ = array<u32, 2>(_e451, _e441);
                                }
                                let _e463 = phi_560_;
                                let _e466 = (2u * (_e334 + _e377));
                                let _e469 = atomicAdd((&global_8.member[_e466]), _e463[0]);
                                let _e477 = atomicAdd((&global_8.member[(_e466 + 1u)]), (_e463[1] + select(0u, 1u, ((_e469 + _e463[0]) < _e463[0]))));
                            }
                            let _e478 = (_e389 * (_e221 * _e218));
                            if _e111 {
                                let _e480 = (_e478 < 0f);
                                if _e480 {
                                    phi_581_ = -(_e478);
                                } else {
                                    phi_581_ = _e478;
                                }
                                let _e483 = phi_581_;
                                let _e485 = u32((_e483 * 0.00000000023283064f));
                                let _e488 = (_e483 - (f32(_e485) * 4294967300f));
                                let _e489 = u32(_e488);
                                if ((_e488 - f32(_e489)) >= 0.5f) {
                                    phi_591_ = (_e489 + 1u);
                                } else {
                                    phi_591_ = _e489;
                                }
                                let _e495 = phi_591_;
                                if _e480 {
                                    let _e498 = (~(_e495) + 1u);
                                    if (_e498 == 0u) {
                                        phi_605_ = (~(_e485) + 1u);
                                    } else {
                                        phi_605_ = ~(_e485);
                                    }
                                    let _e504 = phi_605_;
                                    phi_607_ = array<u32, 2>(_e498, _e504);
                                } else {
                                    phi_607_ = array<u32, 2>(_e495, _e485);
                                }
                                let _e507 = phi_607_;
                                let _e510 = (2u * (_e335 + _e377));
                                let _e513 = atomicAdd((&global_8.member[_e510]), _e507[0]);
                                let _e521 = atomicAdd((&global_8.member[(_e510 + 1u)]), (_e507[1] + select(0u, 1u, ((_e513 + _e507[0]) < _e507[0]))));
                            }
                            let _e522 = (_e389 * (_e222 * _e218));
                            if _e111 {
                                let _e524 = (_e522 < 0f);
                                if _e524 {
                                    phi_628_ = -(_e522);
                                } else {
                                    phi_628_ = _e522;
                                }
                                let _e527 = phi_628_;
                                let _e529 = u32((_e527 * 0.00000000023283064f));
                                let _e532 = (_e527 - (f32(_e529) * 4294967300f));
                                let _e533 = u32(_e532);
                                if ((_e532 - f32(_e533)) >= 0.5f) {
                                    phi_638_ = (_e533 + 1u);
                                } else {
                                    phi_638_ = _e533;
                                }
                                let _e539 = phi_638_;
                                if _e524 {
                                    let _e542 = (~(_e539) + 1u);
                                    if (_e542 == 0u) {
                                        phi_652_ = (~(_e529) + 1u);
                                    } else {
                                        phi_652_ = ~(_e529);
                                    }
                                    let _e548 = phi_652_;
                                    phi_654_ = array<u32, 2>(_e542, _e548);
                                } else {
                                    phi_654_ = array<u32, 2>(_e539, _e529);
                                }
                                let _e551 = phi_654_;
                                let _e554 = (2u * (_e336 + _e377));
                                let _e557 = atomicAdd((&global_8.member[_e554]), _e551[0]);
                                let _e565 = atomicAdd((&global_8.member[(_e554 + 1u)]), (_e551[1] + select(0u, 1u, ((_e557 + _e551[0]) < _e551[0]))));
                            }
                            let _e566 = (_e389 * (_e219 * _e213));
                            if _e111 {
                                let _e568 = (_e566 < 0f);
                                if _e568 {
                                    phi_675_ = -(_e566);
                                } else {
                                    phi_675_ = _e566;
                                }
                                let _e571 = phi_675_;
                                let _e573 = u32((_e571 * 0.00000000023283064f));
                                let _e576 = (_e571 - (f32(_e573) * 4294967300f));
                                let _e577 = u32(_e576);
                                if ((_e576 - f32(_e577)) >= 0.5f) {
                                    phi_685_ = (_e577 + 1u);
                                } else {
                                    phi_685_ = _e577;
                                }
                                let _e583 = phi_685_;
                                if _e568 {
                                    let _e586 = (~(_e583) + 1u);
                                    if (_e586 == 0u) {
                                        phi_699_ = (~(_e573) + 1u);
                                    } else {
                                        phi_699_ = ~(_e573);
                                    }
                                    let _e592 = phi_699_;
                                    phi_701_ = array<u32, 2>(_e586, _e592);
                                } else {
                                    phi_701_ = array<u32, 2>(_e583, _e573);
                                }
                                let _e595 = phi_701_;
                                let _e598 = (2u * (_e337 + _e377));
                                let _e601 = atomicAdd((&global_8.member[_e598]), _e595[0]);
                                let _e609 = atomicAdd((&global_8.member[(_e598 + 1u)]), (_e595[1] + select(0u, 1u, ((_e601 + _e595[0]) < _e595[0]))));
                            }
                            let _e610 = (_e389 * (_e220 * _e213));
                            if _e111 {
                                let _e612 = (_e610 < 0f);
                                if _e612 {
                                    phi_722_ = -(_e610);
                                } else {
                                    phi_722_ = _e610;
                                }
                                let _e615 = phi_722_;
                                let _e617 = u32((_e615 * 0.00000000023283064f));
                                let _e620 = (_e615 - (f32(_e617) * 4294967300f));
                                let _e621 = u32(_e620);
                                if ((_e620 - f32(_e621)) >= 0.5f) {
                                    phi_732_ = (_e621 + 1u);
                                } else {
                                    phi_732_ = _e621;
                                }
                                let _e627 = phi_732_;
                                if _e612 {
                                    let _e630 = (~(_e627) + 1u);
                                    if (_e630 == 0u) {
                                        phi_746_ = (~(_e617) + 1u);
                                    } else {
                                        phi_746_ = ~(_e617);
                                    }
                                    let _e636 = phi_746_;
                                    phi_748_ = array<u32, 2>(_e630, _e636);
                                } else {
                                    phi_748_ = array<u32, 2>(_e627, _e617);
                                }
                                let _e639 = phi_748_;
                                let _e642 = (2u * (_e338 + _e377));
                                let _e645 = atomicAdd((&global_8.member[_e642]), _e639[0]);
                                let _e653 = atomicAdd((&global_8.member[(_e642 + 1u)]), (_e639[1] + select(0u, 1u, ((_e645 + _e639[0]) < _e639[0]))));
                            }
                            let _e654 = (_e389 * (_e221 * _e213));
                            if _e111 {
                                let _e656 = (_e654 < 0f);
                                if _e656 {
                                    phi_769_ = -(_e654);
                                } else {
                                    phi_769_ = _e654;
                                }
                                let _e659 = phi_769_;
                                let _e661 = u32((_e659 * 0.00000000023283064f));
                                let _e664 = (_e659 - (f32(_e661) * 4294967300f));
                                let _e665 = u32(_e664);
                                if ((_e664 - f32(_e665)) >= 0.5f) {
                                    phi_779_ = (_e665 + 1u);
                                } else {
                                    phi_779_ = _e665;
                                }
                                let _e671 = phi_779_;
                                if _e656 {
                                    let _e674 = (~(_e671) + 1u);
                                    if (_e674 == 0u) {
                                        phi_793_ = (~(_e661) + 1u);
                                    } else {
                                        phi_793_ = ~(_e661);
                                    }
                                    let _e680 = phi_793_;
                                    phi_795_ = array<u32, 2>(_e674, _e680);
                                } else {
                                    phi_795_ = array<u32, 2>(_e671, _e661);
                                }
                                let _e683 = phi_795_;
                                let _e686 = (2u * (_e339 + _e377));
                                let _e689 = atomicAdd((&global_8.member[_e686]), _e683[0]);
                                let _e697 = atomicAdd((&global_8.member[(_e686 + 1u)]), (_e683[1] + select(0u, 1u, ((_e689 + _e683[0]) < _e683[0]))));
                            }
                            let _e698 = (_e389 * (_e222 * _e213));
                            if _e111 {
                                let _e700 = (_e698 < 0f);
                                if _e700 {
                                    phi_816_ = -(_e698);
                                } else {
                                    phi_816_ = _e698;
                                }
                                let _e703 = phi_816_;
                                let _e705 = u32((_e703 * 0.00000000023283064f));
                                let _e708 = (_e703 - (f32(_e705) * 4294967300f));
                                let _e709 = u32(_e708);
                                if ((_e708 - f32(_e709)) >= 0.5f) {
                                    phi_826_ = (_e709 + 1u);
                                } else {
                                    phi_826_ = _e709;
                                }
                                let _e715 = phi_826_;
                                if _e700 {
                                    let _e718 = (~(_e715) + 1u);
                                    if (_e718 == 0u) {
                                        phi_840_ = (~(_e705) + 1u);
                                    } else {
                                        phi_840_ = ~(_e705);
                                    }
                                    let _e724 = phi_840_;
                                    phi_842_ = array<u32, 2>(_e718, _e724);
                                } else {
                                    phi_842_ = array<u32, 2>(_e715, _e705);
                                }
                                let _e727 = phi_842_;
                                let _e730 = (2u * (_e340 + _e377));
                                let _e733 = atomicAdd((&global_8.member[_e730]), _e727[0]);
                                let _e741 = atomicAdd((&global_8.member[(_e730 + 1u)]), (_e727[1] + select(0u, 1u, ((_e733 + _e727[0]) < _e727[0]))));
                            }
                            local_7 = (_e377 + 1u);
                            local_8 = (_e379 + _e66);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e762 = local_7;
                            phi_465_ = _e762;
                            let _e765 = local_8;
                            phi_468_ = _e765;
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
