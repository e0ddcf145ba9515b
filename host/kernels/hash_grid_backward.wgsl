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
    var phi_308_: u32;
    var phi_314_: u32;
    var phi_401_: array<u32, 8>;
    var phi_469_: u32;
    var phi_472_: u32;
    var phi_491_: f32;
    var phi_501_: u32;
    var phi_515_: u32;
    var phi_517_: array<u32, 2>;
    var phi_538_: f32;
    var phi_548_: u32;
    var phi_562_: u32;
    var phi_564_: array<u32, 2>;
    var phi_585_: f32;
    var phi_595_: u32;
    var phi_609_: u32;
    var phi_611_: array<u32, 2>;
    var phi_632_: f32;
    var phi_642_: u32;
    var phi_656_: u32;
    var phi_658_: array<u32, 2>;
    var phi_679_: f32;
    var phi_689_: u32;
    var phi_703_: u32;
    var phi_705_: array<u32, 2>;
    var phi_726_: f32;
    var phi_736_: u32;
    var phi_750_: u32;
    var phi_752_: array<u32, 2>;
    var phi_773_: f32;
    var phi_783_: u32;
    var phi_797_: u32;
    var phi_799_: array<u32, 2>;
    var phi_820_: f32;
    var phi_830_: u32;
    var phi_844_: u32;
    var phi_846_: array<u32, 2>;
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
                    let _e194 = (_e142 + _e146);
                    let _e197 = select(false, (_e194 < 1f), (0f < _e194));
                    let _e200 = select(select(0f, 1f, (1f <= _e194)), _e142, _e197);
                    let _e202 = (_e200 * _e114.member);
                    let _e207 = trunc(_e202);
                    let _e209 = ((_e202 - _e207) + (((_e200 * _e114.member_1) + (select(0f, _e146, _e197) * _e159)) + 0.5f));
                    let _e211 = select(0f, _e209, (_e209 > 0f));
                    let _e212 = trunc(_e211);
                    let _e213 = (_e211 - _e212);
                    let _e216 = (1f - _e169);
                    let _e217 = (1f - _e191);
                    let _e218 = (1f - _e213);
                    let _e219 = (_e216 * _e217);
                    let _e220 = (_e169 * _e217);
                    let _e221 = (_e216 * _e191);
                    let _e222 = (_e169 * _e191);
                    let _e232 = (_e114.member_5 != 0u);
                    if _e232 {
                        phi_308_ = 2654435761u;
                    } else {
                        phi_308_ = _e114.member_2;
                    }
                    let _e235 = phi_308_;
                    if _e232 {
                        phi_314_ = 805459861u;
                    } else {
                        phi_314_ = (_e114.member_2 * _e114.member_2);
                    }
                    let _e239 = phi_314_;
                    let _e240 = (_e171 + 1u);
                    let _e241 = (u32((_e185 + _e190)) * _e235);
                    let _e242 = (_e241 + _e235);
                    let _e243 = (u32((_e207 + _e212)) * _e239);
                    let _e244 = (_e243 + _e239);
                    if _e232 {
                        let _e293 = (_e114.member_4 - 1u);
                        let _e294 = (_e171 ^ _e241);
                        let _e298 = (_e240 ^ _e241);
                        let _e302 = (_e171 ^ _e242);
                        let _e306 = (_e240 ^ _e242);
                        phi_401_ = array<u32, 8>((((_e294 ^ _e243) & _e293) + _e114.member_3), (((_e298 ^ _e243) & _e293) + _e114.member_3), (((_e302 ^ _e243) & _e293) + _e114.member_3), (((_e306 ^ _e243) & _e293) + _e114.member_3), (((_e294 ^ _e244) & _e293) + _e114.member_3), (((_e298 ^ _e244) & _e293) + _e114.member_3), (((_e302 ^ _e244) & _e293) + _e114.member_3), (((_e306 ^ _e244) & _e293) + _e114.member_3));
                    } else {
                        let _e247 = (_e171 + _e241);
                        let _e248 = (_e247 + _e243);
                        let _e253 = (_e240 + _e241);
                        let _e254 = (_e253 + _e243);
                        let _e259 = (_e171 + _e242);
                        let _e260 = (_e259 + _e243);
                        let _e265 = (_e240 + _e242);
                        let _e266 = (_e265 + _e243);
                        let _e271 = (_e247 + _e244);
                        let _e276 = (_e253 + _e244);
                        let _e281 = (_e259 + _e244);
                        let _e286 = (_e265 + _e244);
                        phi_401_ = array<u32, 8>((select((_e248 - _e114.member_4), _e248, (_e248 < _e114.member_4)) + _e114.member_3), (select((_e254 - _e114.member_4), _e254, (_e254 < _e114.member_4)) + _e114.member_3), (select((_e260 - _e114.member_4), _e260, (_e260 < _e114.member_4)) + _e114.member_3), (select((_e266 - _e114.member_4), _e266, (_e266 < _e114.member_4)) + _e114.member_3), (select((_e271 - _e114.member_4), _e271, (_e271 < _e114.member_4)) + _e114.member_3), (select((_e276 - _e114.member_4), _e276, (_e276 < _e114.member_4)) + _e114.member_3), (select((_e281 - _e114.member_4), _e281, (_e281 < _e114.member_4)) + _e114.member_3), (select((_e286 - _e114.member_4), _e286, (_e286 < _e114.member_4)) + _e114.member_3));
                    }
                    let _e324 = phi_401_;
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
                    phi_469_ = 0u;
                    phi_472_ = _e74;
                    loop {
                        let _e377 = phi_469_;
                        let _e379 = phi_472_;
                        if (_e377 < _e49) {
                            let _e383 = global_6.member[_e379];
                            let _e384 = -(_e383);
                            let _e389 = select(0f, (_e383 * _e375), (0.000000000000000000000000000000000000011754944f <= select(_e384, _e383, (_e383 > _e384))));
                            let _e390 = (_e389 * (_e219 * _e218));
                            if _e111 {
                                let _e392 = (_e390 < 0f);
                                if _e392 {
                                    phi_491_ = -(_e390);
                                } else {
                                    phi_491_ = _e390;
                                }
                                let _e395 = phi_491_;
                                let _e397 = u32((_e395 * 0.00000000023283064f));
                                let _e400 = (_e395 - (f32(_e397) * 4294967300f));
                                let _e401 = u32(_e400);
                                if ((_e400 - f32(_e401)) >= 0.5f) {
                                    phi_501_ = (_e401 + 1u);
                                } else {
                                    phi_501_ = _e401;
                                }
                                let _e407 = phi_501_;
                                if _e392 {
                                    let _e410 = (~(_e407) + 1u);
                                    if (_e410 == 0u) {
                                        phi_515_ = (~(_e397) + 1u);
                                    } else {
                                        phi_515_ = ~(_e397);
                                    }
                                    let _e416 = phi_515_;
                                    phi_517_ = array<u32, 2>(_e410, _e416);
                                } else {
                                    phi_517_ = array<u32, 2>(_e407, _e397);
                                }
                                let _e419 = phi_517_;
                                let _e422 = (2u * (_e333 + _e377));
                                let _e425 = atomicAdd((&global_8.member[_e422]), _e419[0]);
                                let _e433 = atomicAdd((&global_8.member[(_e422 + 1u)]), (_e419[1] + select(0u, 1u, ((_e425 + _e419[0]) < _e419[0]))));
                            }
                            let _e434 = (_e389 * (_e220 * _e218));
                            if _e111 {
                                let _e436 = (_e434 < 0f);
                                if _e436 {
                                    phi_538_ = -(_e434);
                                } else {
                                    phi_538_ = _e434;
                                }
                                let _e439 = phi_538_;
                                let _e441 = u32((_e439 * 0.00000000023283064f));
                                let _e444 = (_e439 - (f32(_e441) * 4294967300f));
                                let _e445 = u32(_e444);
                                if ((_e444 - f32(_e445)) >= 0.5f) {
                                    phi_548_ = (_e445 + 1u);
                                } else {
                                    phi_548_ = _e445;
                                }
                                let _e451 = phi_548_;
                                if _e436 {
                                    let _e454 = (~(_e451) + 1u);
                                    if (_e454 == 0u) {
                                        phi_562_ = (~(_e441) + 1u);
                                    } else {
                                        phi_562_ = ~(_e441);
                                    }
                                    let _e460 = phi_562_;
                                    phi_564_ = array<u32, 2>(_e454, _e460);
                                } else {
                                    phi_564_ = array<u32, 2>(_e451, _e441);
                                }
                                let _e463 = phi_564_;
                                let _e466 = (2u * (_e334 + _e377));
                                let _e469 = atomicAdd((&global_8.member[_e466]), _e463[0]);
                                let _e477 = atomicAdd((&global_8.member[(_e466 + 1u)]), (_e463[1] + select(0u, 1u, ((_e469 + _e463[0]) < _e463[0]))));
                            }
                            let _e478 = (_e389 * (_e221 * _e218));
                            if _e111 {
                                let _e480 = (_e478 < 0f);
                                if _e480 {
                                    phi_585_ = -(_e478);
                                } else {
                                    phi_585_ = _e478;
                                }
                                let _e483 = phi_585_;
                                let _e485 = u32((_e483 * 0.00000000023283064f));
                                let _e488 = (_e483 - (f32(_e485) * 4294967300f));
                                let _e489 = u32(_e488);
                                if ((_e488 - f32(_e489)) >= 0.5f) {
                                    phi_595_ = (_e489 + 1u);
                                } else {
                                    phi_595_ = _e489;
                                }
                                let _e495 = phi_595_;
                                if _e480 {
                                    let _e498 = (~(_e495) + 1u);
                                    if (_e498 == 0u) {
                                        phi_609_ = (~(_e485) + 1u);
                                    } else {
                                        phi_609_ = ~(_e485);
                                    }
                                    let _e504 = phi_609_;
                                    phi_611_ = array<u32, 2>(_e498, _e504);
                                } else {
                                    phi_611_ = array<u32, 2>(_e495, _e485);
                                }
                                let _e507 = phi_611_;
                                let _e510 = (2u * (_e335 + _e377));
                                let _e513 = atomicAdd((&global_8.member[_e510]), _e507[0]);
                                let _e521 = atomicAdd((&global_8.member[(_e510 + 1u)]), (_e507[1] + select(0u, 1u, ((_e513 + _e507[0]) < _e507[0]))));
                            }
                            let _e522 = (_e389 * (_e222 * _e218));
                            if _e111 {
                                let _e524 = (_e522 < 0f);
                                if _e524 {
                                    phi_632_ = -(_e522);
                                } else {
                                    phi_632_ = _e522;
                                }
                                let _e527 = phi_632_;
                                let _e529 = u32((_e527 * 0.00000000023283064f));
                                let _e532 = (_e527 - (f32(_e529) * 4294967300f));
                                let _e533 = u32(_e532);
                                if ((_e532 - f32(_e533)) >= 0.5f) {
                                    phi_642_ = (_e533 + 1u);
                                } else {
                                    phi_642_ = _e533;
                                }
                                let _e539 = phi_642_;
                                if _e524 {
                                    let _e542 = (~(_e539) + 1u);
                                    if (_e542 == 0u) {
                                        phi_656_ = (~(_e529) + 1u);
                                    } else {
                                        phi_656_ = ~(_e529);
                                    }
                                    let _e548 = phi_656_;
                                    phi_658_ = array<u32, 2>(_e542, _e548);
                                } else {
                                    phi_658_ = array<u32, 2>(_e539, _e529);
                                }
                                let _e551 = phi_658_;
                                let _e554 = (2u * (_e336 + _e377));
                                let _e557 = atomicAdd((&global_8.member[_e554]), _e551[0]);
                                let _e565 = atomicAdd((&global_8.member[(_e554 + 1u)]), (_e551[1] + select(0u, 1u, ((_e557 + _e551[0]) < _e551[0]))));
                            }
                            let _e566 = (_e389 * (_e219 * _e213));
                            if _e111 {
                                let _e568 = (_e566 < 0f);
                                if _e568 {
                                    phi_679_ = -(_e566);
                                } else {
                                    phi_679_ = _e566;
                                }
                                let _e571 = phi_679_;
                                let _e573 = u32((_e571 * 0.00000000023283064f));
                                let _e576 = (_e571 - (f32(_e573) * 4294967300f));
                                let _e577 = u32(_e576);
                                if ((_e576 - f32(_e577)) >= 0.5f) {
                                    phi_689_ = (_e577 + 1u);
                                } else {
                                    phi_689_ = _e577;
                                }
                                let _e583 = phi_689_;
                                if _e568 {
                                    let _e586 = (~(_e583) + 1u);
                                    if (_e586 == 0u) {
                                        phi_703_ = (~(_e573) + 1u);
                                    } else {
                                        phi_703_ = ~(_e573);
                                    }
                                    let _e592 = phi_703_;
                                    phi_705_ = array<u32, 2>(_e586, _e592);
                                } else {
                                    phi_705_ = array<u32, 2>(_e583, _e573);
                                }
                                let _e595 = phi_705_;
                                let _e598 = (2u * (_e337 + _e377));
                                let _e601 = atomicAdd((&global_8.member[_e598]), _e595[0]);
                                let _e609 = atomicAdd((&global_8.member[(_e598 + 1u)]), (_e595[1] + select(0u, 1u, ((_e601 + _e595[0]) < _e595[0]))));
                            }
                            let _e610 = (_e389 * (_e220 * _e213));
                            if _e111 {
                                let _e612 = (_e610 < 0f);
                                if _e612 {
                                    phi_726_ = -(_e610);
                                } else {
                                    phi_726_ = _e610;
                                }
                                let _e615 = phi_726_;
                                let _e617 = u32((_e615 * 0.00000000023283064f));
                                let _e620 = (_e615 - (f32(_e617) * 4294967300f));
                                let _e621 = u32(_e620);
                                if ((_e620 - f32(_e621)) >= 0.5f) {
                                    phi_736_ = (_e621 + 1u);
                                } else {
                                    phi_736_ = _e621;
                                }
                                let _e627 = phi_736_;
                                if _e612 {
                                    let _e630 = (~(_e627) + 1u);
                                    if (_e630 == 0u) {
                                        phi_750_ = (~(_e617) + 1u);
                                    } else {
                                        phi_750_ = ~(_e617);
                                    }
                                    let _e636 = phi_750_;
                                    phi_752_ = array<u32, 2>(_e630, _e636);
                                } else {
                                    phi_752_ = array<u32, 2>(_e627, _e617);
                                }
                                let _e639 = phi_752_;
                                let _e642 = (2u * (_e338 + _e377));
                                let _e645 = atomicAdd((&global_8.member[_e642]), _e639[0]);
                                let _e653 = atomicAdd((&global_8.member[(_e642 + 1u)]), (_e639[1] + select(0u, 1u, ((_e645 + _e639[0]) < _e639[0]))));
                            }
                            let _e654 = (_e389 * (_e221 * _e213));
                            if _e111 {
                                let _e656 = (_e654 < 0f);
                                if _e656 {
                                    phi_773_ = -(_e654);
                                } else {
                                    phi_773_ = _e654;
                                }
                                let _e659 = phi_773_;
                                let _e661 = u32((_e659 * 0.00000000023283064f));
                                let _e664 = (_e659 - (f32(_e661) * 4294967300f));
                                let _e665 = u32(_e664);
                                if ((_e664 - f32(_e665)) >= 0.5f) {
                                    phi_783_ = (_e665 + 1u);
                                } else {
                                    phi_783_ = _e665;
                                }
                                let _e671 = phi_783_;
                                if _e656 {
                                    let _e674 = (~(_e671) + 1u);
                                    if (_e674 == 0u) {
                                        phi_797_ = (~(_e661) + 1u);
                                    } else {
                                        phi_797_ = ~(_e661);
                                    }
                                    let _e680 = phi_797_;
                                    phi_799_ = array<u32, 2>(_e674, _e680);
                                } else {
                                    phi_799_ = array<u32, 2>(_e671, _e661);
                                }
                                let _e683 = phi_799_;
                                let _e686 = (2u * (_e339 + _e377));
                                let _e689 = atomicAdd((&global_8.member[_e686]), _e683[0]);
                                let _e697 = atomicAdd((&global_8.member[(_e686 + 1u)]), (_e683[1] + select(0u, 1u, ((_e689 + _e683[0]) < _e683[0]))));
                            }
                            let _e698 = (_e389 * (_e222 * _e213));
                            if _e111 {
                                let _e700 = (_e698 < 0f);
                                if _e700 {
                                    phi_820_ = -(_e698);
                                } else {
                                    phi_820_ = _e698;
                                }
                                let _e703 = phi_820_;
                                let _e705 = u32((_e703 * 0.00000000023283064f));
                                let _e708 = (_e703 - (f32(_e705) * 4294967300f));
                                let _e709 = u32(_e708);
                                if ((_e708 - f32(_e709)) >= 0.5f) {
                                    phi_830_ = (_e709 + 1u);
                                } else {
                                    phi_830_ = _e709;
                                }
                                let _e715 = phi_830_;
                                if _e700 {
                                    let _e718 = (~(_e715) + 1u);
                                    if (_e718 == 0u) {
                                        phi_844_ = (~(_e705) + 1u);
                                    } else {
                                        phi_844_ = ~(_e705);
                                    }
                                    let _e724 = phi_844_;
                                    phi_846_ = array<u32, 2>(_e718, _e724);
                                } else {
                                    phi_846_ = array<u32, 2>(_e715, _e705);
                                }
                                let _e727 = phi_846_;
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
                            let _e764 = local_7;
                            phi_469_ = _e764;
                            let _e767 = local_8;
                            phi_472_ = _e767;
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
