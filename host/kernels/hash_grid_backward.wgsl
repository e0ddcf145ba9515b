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
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_338_: u32;
    var phi_358_: u32;
    var phi_377_: u32;
    var phi_396_: u32;
    var phi_415_: u32;
    var phi_434_: u32;
    var phi_453_: u32;
    var phi_472_: u32;
    var phi_533_: u32;
    var phi_536_: u32;
    var phi_555_: f32;
    var phi_573_: u32;
    var phi_587_: u32;
    var phi_589_: array<u32, 2>;
    var phi_610_: f32;
    var phi_628_: u32;
    var phi_642_: u32;
    var phi_644_: array<u32, 2>;
    var phi_665_: f32;
    var phi_683_: u32;
    var phi_697_: u32;
    var phi_699_: array<u32, 2>;
    var phi_720_: f32;
    var phi_738_: u32;
    var phi_752_: u32;
    var phi_754_: array<u32, 2>;
    var phi_775_: f32;
    var phi_793_: u32;
    var phi_807_: u32;
    var phi_809_: array<u32, 2>;
    var phi_830_: f32;
    var phi_848_: u32;
    var phi_862_: u32;
    var phi_864_: array<u32, 2>;
    var phi_885_: f32;
    var phi_903_: u32;
    var phi_917_: u32;
    var phi_919_: array<u32, 2>;
    var phi_940_: f32;
    var phi_958_: u32;
    var phi_972_: u32;
    var phi_974_: array<u32, 2>;
    var local_3: u32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: u32;
    var local_8: u32;

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
                    if (_e78 < _e50) {
                        let _e88 = global_6.member[_e80];
                        let _e89 = -(_e88);
                        let _e91 = select(_e89, _e88, (_e88 > _e89));
                        local_3 = (_e78 + 1u);
                        local_4 = (_e80 + _e67);
                        local_5 = select(1f, _e82, (_e91 <= _e76));
                        local_6 = select(_e91, _e84, (_e84 > _e91));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e861 = local_3;
                        phi_205_ = _e861;
                        let _e864 = local_4;
                        phi_208_ = _e864;
                        let _e867 = local_5;
                        phi_210_ = _e867;
                        let _e870 = local_6;
                        phi_212_ = _e870;
                    }
                }
                let _e99 = local;
                if (0f < _e99) {
                    let _e103 = atomicMax((&global_10.member[0u]), 1u);
                }
                let _e105 = local_1;
                let _e108 = local_2;
                let _e110 = select(false, (_e108 < 1f), (0.000000000000000000000000000000000000011754944f <= _e105));
                if _e110 {
                    let _e113 = global_5.member[_e34.z];
                    let _e116 = global_4.member.member_5;
                    if _e63 {
                        break;
                    }
                    if _e63 {
                        break;
                    }
                    let _e119 = ((_e64 * (_e116 * _e67)) + _e70);
                    let _e122 = global_3.member[_e119];
                    let _e123 = (3u * _e67);
                    let _e127 = global_3.member[(_e119 + _e123)];
                    let _e128 = (_e67 + _e119);
                    let _e131 = global_3.member[_e128];
                    let _e135 = global_3.member[(_e128 + _e123)];
                    let _e137 = ((2u * _e67) + _e119);
                    let _e140 = global_3.member[_e137];
                    let _e144 = global_3.member[(_e137 + _e123)];
                    let _e145 = (_e122 + _e127);
                    let _e148 = select(false, (_e145 < 1f), (0f < _e145));
                    let _e151 = select(select(0f, 1f, (1f <= _e145)), _e122, _e148);
                    let _e154 = (_e151 * _e113.member);
                    let _e157 = (_e113.member + _e113.member_1);
                    let _e161 = trunc(_e154);
                    let _e163 = ((_e154 - _e161) + (((_e151 * _e113.member_1) + (select(0f, _e127, _e148) * _e157)) + 0.5f));
                    let _e165 = select(0f, _e163, (_e163 > 0f));
                    let _e166 = trunc(_e165);
                    let _e167 = (_e165 - _e166);
                    let _e168 = (_e161 + _e166);
                    let _e173 = select(select(u32(_e168), 0u, (_e168 < 0f)), 4294967295u, (_e168 > 4294967000f));
                    let _e174 = (_e131 + _e135);
                    let _e177 = select(false, (_e174 < 1f), (0f < _e174));
                    let _e180 = select(select(0f, 1f, (1f <= _e174)), _e131, _e177);
                    let _e182 = (_e180 * _e113.member);
                    let _e187 = trunc(_e182);
                    let _e189 = ((_e182 - _e187) + (((_e180 * _e113.member_1) + (select(0f, _e135, _e177) * _e157)) + 0.5f));
                    let _e191 = select(0f, _e189, (_e189 > 0f));
                    let _e192 = trunc(_e191);
                    let _e193 = (_e191 - _e192);
                    let _e194 = (_e187 + _e192);
                    let _e199 = select(select(u32(_e194), 0u, (_e194 < 0f)), 4294967295u, (_e194 > 4294967000f));
                    let _e200 = (_e140 + _e144);
                    let _e203 = select(false, (_e200 < 1f), (0f < _e200));
                    let _e206 = select(select(0f, 1f, (1f <= _e200)), _e140, _e203);
                    let _e208 = (_e206 * _e113.member);
                    let _e213 = trunc(_e208);
                    let _e215 = ((_e208 - _e213) + (((_e206 * _e113.member_1) + (select(0f, _e144, _e203) * _e157)) + 0.5f));
                    let _e217 = select(0f, _e215, (_e215 > 0f));
                    let _e218 = trunc(_e217);
                    let _e219 = (_e217 - _e218);
                    let _e220 = (_e213 + _e218);
                    let _e225 = select(select(u32(_e220), 0u, (_e220 < 0f)), 4294967295u, (_e220 > 4294967000f));
                    let _e226 = (_e173 + 1u);
                    let _e227 = (_e199 + 1u);
                    let _e228 = (_e225 + 1u);
                    let _e231 = (_e113.member_5 == 0u);
                    if _e231 {
                        let _e242 = (_e173 + ((_e199 + (_e225 * _e113.member_2)) * _e113.member_2));
                        phi_338_ = select((_e242 - _e113.member_4), _e242, (_e242 < _e113.member_4));
                    } else {
                        phi_338_ = (((_e173 ^ (_e199 * 2654435761u)) ^ (_e225 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e247 = phi_338_;
                    if _e231 {
                        let _e260 = (_e226 + ((_e199 + (_e225 * _e113.member_2)) * _e113.member_2));
                        phi_358_ = select((_e260 - _e113.member_4), _e260, (_e260 < _e113.member_4));
                    } else {
                        phi_358_ = (((_e226 ^ (_e199 * 2654435761u)) ^ (_e225 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e265 = phi_358_;
                    if _e231 {
                        let _e277 = (_e173 + ((_e227 + (_e225 * _e113.member_2)) * _e113.member_2));
                        phi_377_ = select((_e277 - _e113.member_4), _e277, (_e277 < _e113.member_4));
                    } else {
                        phi_377_ = (((_e173 ^ (_e227 * 2654435761u)) ^ (_e225 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e282 = phi_377_;
                    if _e231 {
                        let _e294 = (_e226 + ((_e227 + (_e225 * _e113.member_2)) * _e113.member_2));
                        phi_396_ = select((_e294 - _e113.member_4), _e294, (_e294 < _e113.member_4));
                    } else {
                        phi_396_ = (((_e226 ^ (_e227 * 2654435761u)) ^ (_e225 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e299 = phi_396_;
                    if _e231 {
                        let _e311 = (_e173 + ((_e199 + (_e228 * _e113.member_2)) * _e113.member_2));
                        phi_415_ = select((_e311 - _e113.member_4), _e311, (_e311 < _e113.member_4));
                    } else {
                        phi_415_ = (((_e173 ^ (_e199 * 2654435761u)) ^ (_e228 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e316 = phi_415_;
                    if _e231 {
                        let _e328 = (_e226 + ((_e199 + (_e228 * _e113.member_2)) * _e113.member_2));
                        phi_434_ = select((_e328 - _e113.member_4), _e328, (_e328 < _e113.member_4));
                    } else {
                        phi_434_ = (((_e226 ^ (_e199 * 2654435761u)) ^ (_e228 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e333 = phi_434_;
                    if _e231 {
                        let _e345 = (_e173 + ((_e227 + (_e228 * _e113.member_2)) * _e113.member_2));
                        phi_453_ = select((_e345 - _e113.member_4), _e345, (_e345 < _e113.member_4));
                    } else {
                        phi_453_ = (((_e173 ^ (_e227 * 2654435761u)) ^ (_e228 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e350 = phi_453_;
                    if _e231 {
                        let _e362 = (_e226 + ((_e227 + (_e228 * _e113.member_2)) * _e113.member_2));
                        phi_472_ = select((_e362 - _e113.member_4), _e362, (_e362 < _e113.member_4));
                    } else {
                        phi_472_ = (((_e226 ^ (_e227 * 2654435761u)) ^ (_e228 * 805459861u)) & (_e113.member_4 - 1u));
                    }
                    let _e367 = phi_472_;
                    let _e369 = (1f - _e167);
                    let _e370 = (1f - _e193);
                    let _e371 = (1f - _e219);
                    let _e372 = (_e369 * _e370);
                    let _e373 = (_e167 * _e370);
                    let _e374 = (_e369 * _e193);
                    let _e375 = (_e167 * _e193);
                    let _e384 = ((_e247 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e388 = atomicMax((&global_9.member[(_e384 / 64u)]), 1u);
                    }
                    let _e389 = ((_e265 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e393 = atomicMax((&global_9.member[(_e389 / 64u)]), 1u);
                    }
                    let _e394 = ((_e282 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e398 = atomicMax((&global_9.member[(_e394 / 64u)]), 1u);
                    }
                    let _e399 = ((_e299 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e403 = atomicMax((&global_9.member[(_e399 / 64u)]), 1u);
                    }
                    let _e404 = ((_e316 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e408 = atomicMax((&global_9.member[(_e404 / 64u)]), 1u);
                    }
                    let _e409 = ((_e333 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e413 = atomicMax((&global_9.member[(_e409 / 64u)]), 1u);
                    }
                    let _e414 = ((_e350 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e418 = atomicMax((&global_9.member[(_e414 / 64u)]), 1u);
                    }
                    let _e419 = ((_e367 + _e113.member_3) * _e50);
                    if _e110 {
                        let _e423 = atomicMax((&global_9.member[(_e419 / 64u)]), 1u);
                    }
                    let _e426 = global_7.member[0u];
                    phi_533_ = 0u;
                    phi_536_ = _e73;
                    loop {
                        let _e428 = phi_533_;
                        let _e430 = phi_536_;
                        if (_e428 < _e50) {
                            let _e434 = global_6.member[_e430];
                            let _e435 = -(_e434);
                            let _e440 = select(0f, (_e434 * _e426), (0.000000000000000000000000000000000000011754944f <= select(_e435, _e434, (_e434 > _e435))));
                            let _e441 = (_e440 * (_e372 * _e371));
                            if _e110 {
                                let _e443 = (_e441 < 0f);
                                if _e443 {
                                    phi_555_ = -(_e441);
                                } else {
                                    phi_555_ = _e441;
                                }
                                let _e446 = phi_555_;
                                let _e447 = (_e446 * 0.00000000023283064f);
                                let _e452 = select(select(u32(_e447), 0u, (_e447 < 0f)), 4294967295u, (_e447 > 4294967000f));
                                let _e455 = (_e446 - (f32(_e452) * 4294967300f));
                                let _e460 = select(select(u32(_e455), 0u, (_e455 < 0f)), 4294967295u, (_e455 > 4294967000f));
                                if ((_e455 - f32(_e460)) >= 0.5f) {
                                    phi_573_ = (_e460 + 1u);
                                } else {
                                    phi_573_ = _e460;
                                }
                                let _e466 = phi_573_;
                                if _e443 {
                                    let _e469 = (~(_e466) + 1u);
                                    if (_e469 == 0u) {
                                        phi_587_ = (~(_e452) + 1u);
                                    } else {
                                        phi_587_ = ~(_e452);
                                    }
                                    let _e475 = phi_587_;
                                    phi_589_ = array<u32, 2>(_e469, _e475);
                                } else {
                                    phi_589_ = array<u32, 2>(_e466, _e452);
                                }
                                let _e478 = phi_589_;
                                let _e481 = (2u * (_e384 + _e428));
                                let _e484 = atomicAdd((&global_8.member[_e481]), _e478[0]);
                                let _e492 = atomicAdd((&global_8.member[(_e481 + 1u)]), (_e478[1] + select(0u, 1u, ((_e484 + _e478[0]) < _e478[0]))));
                            }
                            let _e493 = (_e440 * (_e373 * _e371));
                            if _e110 {
                                let _e495 = (_e493 < 0f);
                                if _e495 {
                                    phi_610_ = -(_e493);
                                } else {
                                    phi_610_ = _e493;
                                }
                                let _e498 = phi_610_;
                                let _e499 = (_e498 * 0.00000000023283064f);
                                let _e504 = select(select(u32(_e499), 0u, (_e499 < 0f)), 4294967295u, (_e499 > 4294967000f));
                                let _e507 = (_e498 - (f32(_e504) * 4294967300f));
                                let _e512 = select(select(u32(_e507), 0u, (_e507 < 0f)), 4294967295u, (_e507 > 4294967000f));
                                if ((_e507 - f32(_e512)) >= 0.5f) {
                                    phi_628_ = (_e512 + 1u);
                                } else {
                                    phi_628_ = _e512;
                                }
                                let _e518 = phi_628_;
                                if _e495 {
                                    let _e521 = (~(_e518) + 1u);
                                    if (_e521 == 0u) {
                                        phi_642_ = (~(_e504) + 1u);
                                    } else {
                                        phi_642_ = ~(_e504);
                                    }
                                    let _e527 = phi_642_;
                                    phi_644_ = array<u32, 2>(_e521, _e527);
                                } else {
                                    phi_644_ = array<u32, 2>(_e518, _e504);
                                }
                                let _e530 = phi_644_;
                                let _e533 = (2u * (_e389 + _e428));
                                let _e536 = atomicAdd((&global_8.member[_e533]), _e530[0]);
                                let _e544 = atomicAdd((&global_8.member[(_e533 + 1u)]), (_e530[1] + select(0u, 1u, ((_e536 + _e530[0]) < _e530[0]))));
                            }
                            let _e545 = (_e440 * (_e374 * _e371));
                            if _e110 {
                                let _e547 = (_e545 < 0f);
                                if _e547 {
                                    phi_665_ = -(_e545);
                                } else {
                                    phi_665_ = _e545;
                                }
                                let _e550 = phi_665_;
                                let _e551 = (_e550 * 0.00000000023283064f);
                                let _e556 = select(select(u32(_e551), 0u, (_e551 < 0f)), 4294967295u, (_e551 > 4294967000f));
                                let _e559 = (_e550 - (f32(_e556) * 4294967300f));
                                let _e564 = select(select(u32(_e559), 0u, (_e559 < 0f)), 4294967295u, (_e559 > 4294967000f));
                                if ((_e559 - f32(_e564)) >= 0.5f) {
                                    phi_683_ = (_e564 + 1u);
                                } else {
                                    phi_683_ = _e564;
                                }
                                let _e570 = phi_683_;
                                if _e547 {
                                    let _e573 = (~(_e570) + 1u);
                                    if (_e573 == 0u) {
                                        phi_697_ = (~(_e556) + 1u);
                                    } else {
                                        phi_697_ = ~(_e556);
                                    }
                                    let _e579 = phi_697_;
                                    phi_699_ = array<u32, 2>(_e573, _e579);
                                } else {
                                    phi_699_ = array<u32, 2>(_e570, _e556);
                                }
                                let _e582 = phi_699_;
                                let _e585 = (2u * (_e394 + _e428));
                                let _e588 = atomicAdd((&global_8.member[_e585]), _e582[0]);
                                let _e596 = atomicAdd((&global_8.member[(_e585 + 1u)]), (_e582[1] + select(0u, 1u, ((_e588 + _e582[0]) < _e582[0]))));
                            }
                            let _e597 = (_e440 * (_e375 * _e371));
                            if _e110 {
                                let _e599 = (_e597 < 0f);
                                if _e599 {
                                    phi_720_ = -(_e597);
                                } else {
                                    phi_720_ = _e597;
                                }
                                let _e602 = phi_720_;
                                let _e603 = (_e602 * 0.00000000023283064f);
                                let _e608 = select(select(u32(_e603), 0u, (_e603 < 0f)), 4294967295u, (_e603 > 4294967000f));
                                let _e611 = (_e602 - (f32(_e608) * 4294967300f));
                                let _e616 = select(select(u32(_e611), 0u, (_e611 < 0f)), 4294967295u, (_e611 > 4294967000f));
                                if ((_e611 - f32(_e616)) >= 0.5f) {
                                    phi_738_ = (_e616 + 1u);
                                } else {
                                    phi_738_ = _e616;
                                }
                                let _e622 = phi_738_;
                                if _e599 {
                                    let _e625 = (~(_e622) + 1u);
                                    if (_e625 == 0u) {
                                        phi_752_ = (~(_e608) + 1u);
                                    } else {
                                        phi_752_ = ~(_e608);
                                    }
                                    let _e631 = phi_752_;
                                    phi_754_ = array<u32, 2>(_e625, _e631);
                                } else {
                                    phi_754_ = array<u32, 2>(_e622, _e608);
                                }
                                let _e634 = phi_754_;
                                let _e637 = (2u * (_e399 + _e428));
                                let _e640 = atomicAdd((&global_8.member[_e637]), _e634[0]);
                                let _e648 = atomicAdd((&global_8.member[(_e637 + 1u)]), (_e634[1] + select(0u, 1u, ((_e640 + _e634[0]) < _e634[0]))));
                            }
                            let _e649 = (_e440 * (_e372 * _e219));
                            if _e110 {
                                let _e651 = (_e649 < 0f);
                                if _e651 {
                                    phi_775_ = -(_e649);
                                } else {
                                    phi_775_ = _e649;
                                }
                                let _e654 = phi_775_;
                                let _e655 = (_e654 * 0.00000000023283064f);
                                let _e660 = select(select(u32(_e655), 0u, (_e655 < 0f)), 4294967295u, (_e655 > 4294967000f));
                                let _e663 = (_e654 - (f32(_e660) * 4294967300f));
                                let _e668 = select(select(u32(_e663), 0u, (_e663 < 0f)), 4294967295u, (_e663 > 4294967000f));
                                if ((_e663 - f32(_e668)) >= 0.5f) {
                                    phi_793_ = (_e668 + 1u);
                                } else {
                                    phi_793_ = _e668;
                                }
                                let _e674 = phi_793_;
                                if _e651 {
                                    let _e677 = (~(_e674) + 1u);
                                    if (_e677 == 0u) {
                                        phi_807_ = (~(_e660) + 1u);
                                    } else {
                                        phi_807_ = ~(_e660);
                                    }
                                    let _e683 = phi_807_;
                                    phi_809_ = array<u32, 2>(_e677, _e683);
                                } else {
                                    phi_809_ = array<u32, 2>(_e674, _e660);
                                }
                                let _e686 = phi_809_;
                                let _e689 = (2u * (_e404 + _e428));
                                let _e692 = atomicAdd((&global_8.member[_e689]), _e686[0]);
                                let _e700 = atomicAdd((&global_8.member[(_e689 + 1u)]), (_e686[1] + select(0u, 1u, ((_e692 + _e686[0]) < _e686[0]))));
                            }
                            let _e701 = (_e440 * (_e373 * _e219));
                            if _e110 {
                                let _e703 = (_e701 < 0f);
                                if _e703 {
                                    phi_830_ = -(_e701);
                                } else {
                                    phi_830_ = _e701;
                                }
                                let _e706 = phi_830_;
                                let _e707 = (_e706 * 0.00000000023283064f);
                                let _e712 = select(select(u32(_e707), 0u, (_e707 < 0f)), 4294967295u, (_e707 > 4294967000f));
                                let _e715 = (_e706 - (f32(_e712) * 4294967300f));
                                let _e720 = select(select(u32(_e715), 0u, (_e715 < 0f)), 4294967295u, (_e715 > 4294967000f));
                                if ((_e715 - f32(_e720)) >= 0.5f) {
                                    phi_848_ = (_e720 + 1u);
                                } else {
                                    phi_848_ = _e720;
                                }
                                let _e726 = phi_848_;
                                if _e703 {
                                    let _e729 = (~(_e726) + 1u);
                                    if (_e729 == 0u) {
                                        phi_862_ = (~(_e712) + 1u);
                                    } else {
                                        phi_862_ = ~(_e712);
                                    }
                                    let _e735 = phi_862_;
                                    phi_864_ = array<u32, 2>(_e729, _e735);
                                } else {
                                    phi_864_ = array<u32, 2>(_e726, _e712);
                                }
                                let _e738 = phi_864_;
                                let _e741 = (2u * (_e409 + _e428));
                                let _e744 = atomicAdd((&global_8.member[_e741]), _e738[0]);
                                let _e752 = atomicAdd((&global_8.member[(_e741 + 1u)]), (_e738[1] + select(0u, 1u, ((_e744 + _e738[0]) < _e738[0]))));
                            }
                            let _e753 = (_e440 * (_e374 * _e219));
                            if _e110 {
                                let _e755 = (_e753 < 0f);
                                if _e755 {
                                    phi_885_ = -(_e753);
                                } else {
                                    phi_885_ = _e753;
                                }
                                let _e758 = phi_885_;
                                let _e759 = (_e758 * 0.00000000023283064f);
                                let _e764 = select(select(u32(_e759), 0u, (_e759 < 0f)), 4294967295u, (_e759 > 4294967000f));
                                let _e767 = (_e758 - (f32(_e764) * 4294967300f));
                                let _e772 = select(select(u32(_e767), 0u, (_e767 < 0f)), 4294967295u, (_e767 > 4294967000f));
                                if ((_e767 - f32(_e772)) >= 0.5f) {
                                    phi_903_ = (_e772 + 1u);
                                } else {
                                    phi_903_ = _e772;
                                }
                                let _e778 = phi_903_;
                                if _e755 {
                                    let _e781 = (~(_e778) + 1u);
                                    if (_e781 == 0u) {
                                        phi_917_ = (~(_e764) + 1u);
                                    } else {
                                        phi_917_ = ~(_e764);
                                    }
                                    let _e787 = phi_917_;
                                    phi_919_ = array<u32, 2>(_e781, _e787);
                                } else {
                                    phi_919_ = array<u32, 2>(_e778, _e764);
                                }
                                let _e790 = phi_919_;
                                let _e793 = (2u * (_e414 + _e428));
                                let _e796 = atomicAdd((&global_8.member[_e793]), _e790[0]);
                                let _e804 = atomicAdd((&global_8.member[(_e793 + 1u)]), (_e790[1] + select(0u, 1u, ((_e796 + _e790[0]) < _e790[0]))));
                            }
                            let _e805 = (_e440 * (_e375 * _e219));
                            if _e110 {
                                let _e807 = (_e805 < 0f);
                                if _e807 {
                                    phi_940_ = -(_e805);
                                } else {
                                    phi_940_ = _e805;
                                }
                                let _e810 = phi_940_;
                                let _e811 = (_e810 * 0.00000000023283064f);
                                let _e816 = select(select(u32(_e811), 0u, (_e811 < 0f)), 4294967295u, (_e811 > 4294967000f));
                                let _e819 = (_e810 - (f32(_e816) * 4294967300f));
                                let _e824 = select(select(u32(_e819), 0u, (_e819 < 0f)), 4294967295u, (_e819 > 4294967000f));
                                if ((_e819 - f32(_e824)) >= 0.5f) {
                                    phi_958_ = (_e824 + 1u);
                                } else {
                                    phi_958_ = _e824;
                                }
                                let _e830 = phi_958_;
                                if _e807 {
                                    let _e833 = (~(_e830) + 1u);
                                    if (_e833 == 0u) {
                                        phi_972_ = (~(_e816) + 1u);
                                    } else {
                                        phi_972_ = ~(_e816);
                                    }
                                    let _e839 = phi_972_;
                                    phi_974_ = array<u32, 2>(_e833, _e839);
                                } else {
                                    phi_974_ = array<u32, 2>(_e830, _e816);
                                }
                                let _e842 = phi_974_;
                                let _e845 = (2u * (_e419 + _e428));
                                let _e848 = atomicAdd((&global_8.member[_e845]), _e842[0]);
                                let _e856 = atomicAdd((&global_8.member[(_e845 + 1u)]), (_e842[1] + select(0u, 1u, ((_e848 + _e842[0]) < _e842[0]))));
                            }
                            local_7 = (_e428 + 1u);
                            local_8 = (_e430 + _e67);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e884 = local_7;
                            phi_533_ = _e884;
                            let _e887 = local_8;
                            phi_536_ = _e887;
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
