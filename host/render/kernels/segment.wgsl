struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
}

struct type_19 {
    member: type_18,
    member_1: type_18,
}

struct type_23 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(3) 
var<storage> global_5: type_15;
@group(0) @binding(2) 
var<storage> global_6: type_15;
@group(0) @binding(4) 
var<storage> global_7: type_15;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_23;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_11;

fn function_() {
    var phi_520_: type_18;
    var phi_549_: type_18;
    var phi_551_: type_18;
    var phi_552_: bool;
    var phi_556_: type_18;
    var phi_557_: type_18;
    var phi_568_: type_18;
    var phi_575_: type_18;
    var phi_577_: type_19;
    var phi_588_: type_18;
    var phi_617_: type_18;
    var phi_619_: type_18;
    var phi_620_: bool;
    var phi_624_: type_18;
    var phi_625_: type_18;
    var phi_636_: type_18;
    var phi_643_: type_18;
    var phi_645_: type_19;
    var phi_656_: type_18;
    var phi_685_: type_18;
    var phi_687_: type_18;
    var phi_688_: bool;
    var phi_692_: type_18;
    var phi_693_: type_18;
    var phi_704_: type_18;
    var phi_711_: type_18;
    var phi_713_: type_19;
    var phi_724_: type_18;
    var phi_732_: type_18;
    var phi_741_: type_18;
    var phi_749_: type_18;
    var phi_757_: type_18;
    var phi_785_: u32;
    var phi_789_: f32;
    var phi_846_: f32;
    var phi_847_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_879_: u32;
    var phi_883_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e49 = global;
            let _e50 = global_1;
            let _e51 = global_2;
            let _e59 = (((_e50.x + (_e50.y * _e51.x)) * 64u) + _e49.x);
            let _e62 = global_3.member.member;
            if (_e59 < _e62) {
                let _e66 = global_4.member[_e59];
                let _e69 = global_5.member[0u];
                let _e72 = global_5.member[1u];
                let _e75 = global_5.member[2u];
                let _e78 = global_5.member[3u];
                let _e81 = global_5.member[4u];
                let _e84 = global_5.member[5u];
                let _e87 = global_5.member[6u];
                let _e90 = global_5.member[7u];
                let _e93 = global_5.member[8u];
                let _e96 = global_5.member[9u];
                let _e99 = global_5.member[10u];
                let _e102 = global_5.member[11u];
                let _e105 = global_5.member[12u];
                let _e108 = global_5.member[13u];
                let _e111 = global_5.member[14u];
                let _e114 = global_5.member[15u];
                let _e117 = global_5.member[16u];
                let _e120 = global_5.member[17u];
                let _e123 = global_3.member.member_1;
                let _e124 = (_e123 == 0u);
                if _e124 {
                    break;
                }
                let _e126 = ((_e66 / _e123) * 18u);
                let _e130 = global_6.member[(_e126 + 9u)];
                let _e134 = global_6.member[(_e126 + 10u)];
                let _e138 = global_6.member[(_e126 + 11u)];
                let _e141 = (trunc((_e130 * _e78)) * _e69);
                let _e142 = (_e141 - _e87);
                let _e146 = (_e105 + _e114);
                let _e148 = ((_e142 * _e114) + (((_e130 - _e141) - _e96) * _e146));
                let _e149 = (_e142 * _e105);
                let _e153 = (1f / 4096f);
                let _e154 = (trunc(((_e149 + _e148) * 4096f)) * _e153);
                let _e156 = ((_e149 - _e154) + _e148);
                let _e159 = (trunc((_e134 * _e81)) * _e72);
                let _e160 = (_e159 - _e90);
                let _e164 = (_e108 + _e117);
                let _e166 = ((_e160 * _e117) + (((_e134 - _e159) - _e99) * _e164));
                let _e167 = (_e160 * _e108);
                let _e171 = (trunc(((_e167 + _e166) * 4096f)) * _e153);
                let _e173 = ((_e167 - _e171) + _e166);
                let _e176 = (trunc((_e138 * _e84)) * _e75);
                let _e177 = (_e176 - _e93);
                let _e181 = (_e111 + _e120);
                let _e183 = ((_e177 * _e120) + (((_e138 - _e176) - _e102) * _e181));
                let _e184 = (_e177 * _e111);
                let _e188 = (trunc(((_e184 + _e183) * 4096f)) * _e153);
                let _e190 = ((_e184 - _e188) + _e183);
                if _e124 {
                    break;
                }
                let _e192 = ((_e66 % _e123) * 3u);
                let _e195 = global_7.member[_e192];
                let _e199 = global_7.member[(_e192 + 1u)];
                let _e203 = global_7.member[(_e192 + 2u)];
                let _e206 = (trunc((_e195 * _e78)) * _e69);
                let _e207 = (_e206 - _e87);
                let _e212 = ((_e207 * _e114) + (((_e195 - _e206) - _e96) * _e146));
                let _e213 = (_e207 * _e105);
                let _e217 = (trunc(((_e213 + _e212) * 4096f)) * _e153);
                let _e219 = ((_e213 - _e217) + _e212);
                let _e222 = (trunc((_e199 * _e81)) * _e72);
                let _e223 = (_e222 - _e90);
                let _e228 = ((_e223 * _e117) + (((_e199 - _e222) - _e99) * _e164));
                let _e229 = (_e223 * _e108);
                let _e233 = (trunc(((_e229 + _e228) * 4096f)) * _e153);
                let _e235 = ((_e229 - _e233) + _e228);
                let _e238 = (trunc((_e203 * _e84)) * _e75);
                let _e239 = (_e238 - _e93);
                let _e244 = ((_e239 * _e120) + (((_e203 - _e238) - _e102) * _e181));
                let _e245 = (_e239 * _e111);
                let _e249 = (trunc(((_e245 + _e244) * 4096f)) * _e153);
                let _e251 = ((_e245 - _e249) + _e244);
                let _e252 = (_e59 * 4u);
                let _e255 = global_3.member.member_3;
                if (_e255 == 0u) {
                    let _e257 = (_e154 - _e217);
                    let _e258 = (_e156 - _e219);
                    let _e259 = (_e171 - _e233);
                    let _e260 = (_e173 - _e235);
                    let _e261 = (_e188 - _e249);
                    let _e262 = (_e190 - _e251);
                    let _e265 = global_3.member.member_2;
                    let _e267 = (_e257 + _e258);
                    let _e269 = (abs(_e267) < 0.000000000000000000000000000000000000011754944f);
                    if _e269 {
                        phi_520_ = type_18(1f, 0f);
                    } else {
                        phi_520_ = type_18(_e257, _e258);
                    }
                    let _e271 = phi_520_;
                    let _e272 = (0f - _e217);
                    let _e273 = (0f - _e219);
                    let _e276 = (_e271.member + _e271.member_1);
                    let _e278 = ((_e272 + _e273) / _e276);
                    let _e280 = select(0f, _e278, (_e278 > 0f));
                    let _e282 = select(1f, _e280, (_e280 < 1f));
                    let _e285 = (1f / 1024f);
                    let _e286 = (trunc((_e282 * 1024f)) * _e285);
                    let _e296 = select(0f, (((_e272 - (_e286 * _e271.member)) + (_e273 - (_e286 * _e271.member_1))) / _e276), select(false, (_e282 < 1f), (0f < _e282)));
                    let _e297 = (1f - _e217);
                    let _e299 = ((_e297 + _e273) / _e276);
                    let _e301 = select(0f, _e299, (_e299 > 0f));
                    let _e303 = select(1f, _e301, (_e301 < 1f));
                    let _e306 = (trunc((_e303 * 1024f)) * _e285);
                    let _e316 = select(0f, (((_e297 - (_e306 * _e271.member)) + (_e273 - (_e306 * _e271.member_1))) / _e276), select(false, (_e303 < 1f), (0f < _e303)));
                    let _e317 = (_e217 + _e219);
                    if (_e317 >= 0f) {
                        let _e319 = (_e317 <= 1f);
                        if _e319 {
                            phi_549_ = type_18(0f, 0f);
                        } else {
                            phi_549_ = type_18();
                        }
                        let _e321 = phi_549_;
                        phi_551_ = _e321;
                        phi_552_ = select(true, false, _e319);
                    } else {
                        phi_551_ = type_18();
                        phi_552_ = true;
                    }
                    let _e324 = phi_551_;
                    let _e326 = phi_552_;
                    if _e326 {
                        phi_556_ = type_18(1f, 0f);
                        phi_557_ = type_18(0f, 0f);
                    } else {
                        phi_556_ = _e324;
                        phi_557_ = type_18(1f, 0f);
                    }
                    let _e328 = phi_556_;
                    let _e330 = phi_557_;
                    if _e269 {
                        phi_577_ = type_19(_e328, _e330);
                    } else {
                        let _e332 = (_e286 + _e296);
                        let _e333 = (_e306 + _e316);
                        if (_e332 < _e333) {
                            phi_568_ = type_18(_e286, _e296);
                        } else {
                            phi_568_ = type_18(_e306, _e316);
                        }
                        let _e338 = phi_568_;
                        if (_e332 > _e333) {
                            phi_575_ = type_18(_e286, _e296);
                        } else {
                            phi_575_ = type_18(_e306, _e316);
                        }
                        let _e343 = phi_575_;
                        phi_577_ = type_19(_e338, _e343);
                    }
                    let _e346 = phi_577_;
                    let _e356 = (_e259 + _e260);
                    let _e358 = (abs(_e356) < 0.000000000000000000000000000000000000011754944f);
                    if _e358 {
                        phi_588_ = type_18(1f, 0f);
                    } else {
                        phi_588_ = type_18(_e259, _e260);
                    }
                    let _e360 = phi_588_;
                    let _e361 = (0f - _e233);
                    let _e362 = (0f - _e235);
                    let _e365 = (_e360.member + _e360.member_1);
                    let _e367 = ((_e361 + _e362) / _e365);
                    let _e369 = select(0f, _e367, (_e367 > 0f));
                    let _e371 = select(1f, _e369, (_e369 < 1f));
                    let _e374 = (trunc((_e371 * 1024f)) * _e285);
                    let _e384 = select(0f, (((_e361 - (_e374 * _e360.member)) + (_e362 - (_e374 * _e360.member_1))) / _e365), select(false, (_e371 < 1f), (0f < _e371)));
                    let _e385 = (1f - _e233);
                    let _e387 = ((_e385 + _e362) / _e365);
                    let _e389 = select(0f, _e387, (_e387 > 0f));
                    let _e391 = select(1f, _e389, (_e389 < 1f));
                    let _e394 = (trunc((_e391 * 1024f)) * _e285);
                    let _e404 = select(0f, (((_e385 - (_e394 * _e360.member)) + (_e362 - (_e394 * _e360.member_1))) / _e365), select(false, (_e391 < 1f), (0f < _e391)));
                    let _e405 = (_e233 + _e235);
                    if (_e405 >= 0f) {
                        let _e407 = (_e405 <= 1f);
                        if _e407 {
                            phi_617_ = type_18(0f, 0f);
                        } else {
                            phi_617_ = type_18();
                        }
                        let _e409 = phi_617_;
                        phi_619_ = _e409;
                        phi_620_ = select(true, false, _e407);
                    } else {
                        phi_619_ = type_18();
                        phi_620_ = true;
                    }
                    let _e412 = phi_619_;
                    let _e414 = phi_620_;
                    if _e414 {
                        phi_624_ = type_18(1f, 0f);
                        phi_625_ = type_18(0f, 0f);
                    } else {
                        phi_624_ = _e412;
                        phi_625_ = type_18(1f, 0f);
                    }
                    let _e416 = phi_624_;
                    let _e418 = phi_625_;
                    if _e358 {
                        phi_645_ = type_19(_e416, _e418);
                    } else {
                        let _e420 = (_e374 + _e384);
                        let _e421 = (_e394 + _e404);
                        if (_e420 < _e421) {
                            phi_636_ = type_18(_e374, _e384);
                        } else {
                            phi_636_ = type_18(_e394, _e404);
                        }
                        let _e426 = phi_636_;
                        if (_e420 > _e421) {
                            phi_643_ = type_18(_e374, _e384);
                        } else {
                            phi_643_ = type_18(_e394, _e404);
                        }
                        let _e431 = phi_643_;
                        phi_645_ = type_19(_e426, _e431);
                    }
                    let _e434 = phi_645_;
                    let _e444 = (_e261 + _e262);
                    let _e446 = (abs(_e444) < 0.000000000000000000000000000000000000011754944f);
                    if _e446 {
                        phi_656_ = type_18(1f, 0f);
                    } else {
                        phi_656_ = type_18(_e261, _e262);
                    }
                    let _e448 = phi_656_;
                    let _e449 = (0f - _e249);
                    let _e450 = (0f - _e251);
                    let _e453 = (_e448.member + _e448.member_1);
                    let _e455 = ((_e449 + _e450) / _e453);
                    let _e457 = select(0f, _e455, (_e455 > 0f));
                    let _e459 = select(1f, _e457, (_e457 < 1f));
                    let _e462 = (trunc((_e459 * 1024f)) * _e285);
                    let _e472 = select(0f, (((_e449 - (_e462 * _e448.member)) + (_e450 - (_e462 * _e448.member_1))) / _e453), select(false, (_e459 < 1f), (0f < _e459)));
                    let _e473 = (1f - _e249);
                    let _e475 = ((_e473 + _e450) / _e453);
                    let _e477 = select(0f, _e475, (_e475 > 0f));
                    let _e479 = select(1f, _e477, (_e477 < 1f));
                    let _e482 = (trunc((_e479 * 1024f)) * _e285);
                    let _e492 = select(0f, (((_e473 - (_e482 * _e448.member)) + (_e450 - (_e482 * _e448.member_1))) / _e453), select(false, (_e479 < 1f), (0f < _e479)));
                    let _e493 = (_e249 + _e251);
                    if (_e493 >= 0f) {
                        let _e495 = (_e493 <= 1f);
                        if _e495 {
                            phi_685_ = type_18(0f, 0f);
                        } else {
                            phi_685_ = type_18();
                        }
                        let _e497 = phi_685_;
                        phi_687_ = _e497;
                        phi_688_ = select(true, false, _e495);
                    } else {
                        phi_687_ = type_18();
                        phi_688_ = true;
                    }
                    let _e500 = phi_687_;
                    let _e502 = phi_688_;
                    if _e502 {
                        phi_692_ = type_18(1f, 0f);
                        phi_693_ = type_18(0f, 0f);
                    } else {
                        phi_692_ = _e500;
                        phi_693_ = type_18(1f, 0f);
                    }
                    let _e504 = phi_692_;
                    let _e506 = phi_693_;
                    if _e446 {
                        phi_713_ = type_19(_e504, _e506);
                    } else {
                        let _e508 = (_e462 + _e472);
                        let _e509 = (_e482 + _e492);
                        if (_e508 < _e509) {
                            phi_704_ = type_18(_e462, _e472);
                        } else {
                            phi_704_ = type_18(_e482, _e492);
                        }
                        let _e514 = phi_704_;
                        if (_e508 > _e509) {
                            phi_711_ = type_18(_e462, _e472);
                        } else {
                            phi_711_ = type_18(_e482, _e492);
                        }
                        let _e519 = phi_711_;
                        phi_713_ = type_19(_e514, _e519);
                    }
                    let _e522 = phi_713_;
                    if ((_e346.member.member + _e346.member.member_1) > (_e434.member.member + _e434.member.member_1)) {
                        phi_724_ = _e346.member;
                    } else {
                        phi_724_ = _e434.member;
                    }
                    let _e537 = phi_724_;
                    if ((_e537.member + _e537.member_1) > (_e522.member.member + _e522.member.member_1)) {
                        phi_732_ = _e537;
                    } else {
                        phi_732_ = _e522.member;
                    }
                    let _e545 = phi_732_;
                    if ((_e346.member_1.member + _e346.member_1.member_1) < (_e434.member_1.member + _e434.member_1.member_1)) {
                        phi_741_ = _e346.member_1;
                    } else {
                        phi_741_ = _e434.member_1;
                    }
                    let _e554 = phi_741_;
                    if ((_e554.member + _e554.member_1) < (_e522.member_1.member + _e522.member_1.member_1)) {
                        phi_749_ = _e554;
                    } else {
                        phi_749_ = _e522.member_1;
                    }
                    let _e562 = phi_749_;
                    let _e565 = (_e562.member - _e545.member);
                    let _e566 = (_e562.member_1 - _e545.member_1);
                    if ((_e565 + _e566) > 0f) {
                        phi_757_ = type_18(_e565, _e566);
                    } else {
                        phi_757_ = type_18(0f, 0f);
                    }
                    let _e571 = phi_757_;
                    let _e577 = (0f + ((_e571.member * _e258) + (_e571.member_1 * _e267)));
                    let _e579 = (0f + (_e571.member * _e257));
                    let _e583 = (trunc(((_e579 + _e577) * 4096f)) * _e153);
                    let _e585 = ((_e579 - _e583) + _e577);
                    let _e589 = (0f + ((_e571.member * _e260) + (_e571.member_1 * _e356)));
                    let _e591 = (0f + (_e571.member * _e259));
                    let _e595 = (trunc(((_e591 + _e589) * 4096f)) * _e153);
                    let _e597 = ((_e591 - _e595) + _e589);
                    let _e601 = (0f + ((_e571.member * _e262) + (_e571.member_1 * _e444)));
                    let _e603 = (0f + (_e571.member * _e261));
                    let _e607 = (trunc(((_e603 + _e601) * 4096f)) * _e153);
                    let _e609 = ((_e603 - _e607) + _e601);
                    let _e610 = (_e583 + _e585);
                    let _e611 = (_e595 + _e597);
                    let _e612 = (_e607 + _e609);
                    let _e618 = sqrt((((_e610 * _e610) + (_e611 * _e611)) + (_e612 * _e612)));
                    let _e619 = (_e618 > 0f);
                    let _e621 = ceil((_e618 / _e265));
                    let _e622 = f32(16384u);
                    let _e624 = select(1f, _e621, (_e621 > 1f));
                    let _e626 = select(_e622, _e624, (_e624 < _e622));
                    let _e630 = (_e219 + ((_e545.member * _e258) + (_e545.member_1 * _e267)));
                    let _e632 = (_e217 + (_e545.member * _e257));
                    let _e636 = (trunc(((_e632 + _e630) * 4096f)) * _e153);
                    let _e642 = (_e235 + ((_e545.member * _e260) + (_e545.member_1 * _e356)));
                    let _e644 = (_e233 + (_e545.member * _e259));
                    let _e648 = (trunc(((_e644 + _e642) * 4096f)) * _e153);
                    let _e654 = (_e251 + ((_e545.member * _e262) + (_e545.member_1 * _e444)));
                    let _e656 = (_e249 + (_e545.member * _e261));
                    let _e660 = (trunc(((_e656 + _e654) * 4096f)) * _e153);
                    if _e619 {
                        phi_785_ = select(select(u32(_e626), 0u, !((_e626 >= bitcast<f32>(0u)))), 4294967295u, (_e626 > bitcast<f32>(1333788671u)));
                    } else {
                        phi_785_ = 0u;
                    }
                    let _e672 = phi_785_;
                    if _e619 {
                        phi_789_ = ((_e618 / _e626) / _e265);
                    } else {
                        phi_789_ = 0f;
                    }
                    let _e676 = phi_789_;
                    global_8.member[_e252] = vec4<f32>(_e636, _e648, _e660, _e676);
                    global_8.member[(_e252 + 1u)] = vec4<f32>(_e583, _e595, _e607, 0f);
                    global_8.member[(_e252 + 2u)] = vec4<f32>(((_e632 - _e636) + _e630), ((_e644 - _e648) + _e642), ((_e656 - _e660) + _e654), 0f);
                    global_8.member[(_e252 + 3u)] = vec4<f32>(_e585, _e597, _e609, f32(_e672));
                    global_9.member[_e59] = _e672;
                } else {
                    let _e697 = ((_e217 - 0.5f) + (_e219 - 0f));
                    let _e700 = ((_e233 - 0.5f) + (_e235 - 0f));
                    let _e703 = ((_e249 - 0.5f) + (_e251 - 0f));
                    let _e706 = ((_e154 - 0.5f) + (_e156 - 0f));
                    let _e709 = ((_e171 - 0.5f) + (_e173 - 0f));
                    let _e712 = ((_e188 - 0.5f) + (_e190 - 0f));
                    let _e715 = global_3.member.member_2;
                    let _e716 = -(1000000000000000f);
                    let _e718 = select(_e716, _e697, (_e697 > _e716));
                    let _e722 = select(_e716, _e700, (_e700 > _e716));
                    let _e726 = select(_e716, _e703, (_e703 > _e716));
                    let _e730 = select(_e716, _e706, (_e706 > _e716));
                    let _e732 = select(1000000000000000f, _e730, (_e730 < 1000000000000000f));
                    let _e734 = select(_e716, _e709, (_e709 > _e716));
                    let _e736 = select(1000000000000000f, _e734, (_e734 < 1000000000000000f));
                    let _e738 = select(_e716, _e712, (_e712 > _e716));
                    let _e740 = select(1000000000000000f, _e738, (_e738 < 1000000000000000f));
                    let _e741 = (_e732 - select(1000000000000000f, _e718, (_e718 < 1000000000000000f)));
                    let _e742 = (_e736 - select(1000000000000000f, _e722, (_e722 < 1000000000000000f)));
                    let _e743 = (_e740 - select(1000000000000000f, _e726, (_e726 < 1000000000000000f)));
                    let _e749 = sqrt((((_e741 * _e741) + (_e742 * _e742)) + (_e743 * _e743)));
                    let _e752 = (1f / select(0.00000000000000000010842022f, _e749, (_e749 > 0.00000000000000000010842022f)));
                    let _e753 = (_e741 * _e752);
                    let _e754 = (_e742 * _e752);
                    let _e755 = (_e743 * _e752);
                    let _e760 = (((_e732 * _e753) + (_e736 * _e754)) + (_e740 * _e755));
                    let _e764 = (_e732 - (_e753 * _e760));
                    let _e765 = (_e736 - (_e754 * _e760));
                    let _e766 = (_e740 - (_e755 * _e760));
                    let _e772 = sqrt((((_e764 * _e764) + (_e765 * _e765)) + (_e766 * _e766)));
                    let _e774 = select(0.4330127f, _e772, (_e772 > 0.4330127f));
                    let _e775 = (_e760 - _e749);
                    let _e776 = abs(_e775);
                    let _e781 = (_e774 * (2f - (_e774 / select(_e774, _e776, (_e776 > _e774)))));
                    if (_e776 <= _e774) {
                        phi_847_ = _e775;
                    } else {
                        if (_e775 < 0f) {
                            phi_846_ = -(_e781);
                        } else {
                            phi_846_ = _e781;
                        }
                        let _e786 = phi_846_;
                        phi_847_ = _e786;
                    }
                    let _e788 = phi_847_;
                    let _e789 = abs(_e760);
                    let _e794 = (_e774 * (2f - (_e774 / select(_e774, _e789, (_e789 > _e774)))));
                    if (_e789 <= _e774) {
                        phi_860_ = _e760;
                    } else {
                        if (_e760 < 0f) {
                            phi_859_ = -(_e794);
                        } else {
                            phi_859_ = _e794;
                        }
                        let _e799 = phi_859_;
                        phi_860_ = _e799;
                    }
                    let _e801 = phi_860_;
                    let _e802 = (_e801 - _e788);
                    let _e804 = ((0.4330127f / _e774) * _e802);
                    let _e805 = (_e804 > 0f);
                    let _e807 = ceil((_e804 / _e715));
                    let _e808 = f32(16384u);
                    let _e810 = select(1f, _e807, (_e807 > 1f));
                    let _e812 = select(_e808, _e810, (_e810 < _e808));
                    if _e805 {
                        phi_879_ = select(select(u32(_e812), 0u, !((_e812 >= bitcast<f32>(0u)))), 4294967295u, (_e812 > bitcast<f32>(1333788671u)));
                    } else {
                        phi_879_ = 0u;
                    }
                    let _e822 = phi_879_;
                    if _e805 {
                        phi_883_ = ((_e804 / _e812) / _e715);
                    } else {
                        phi_883_ = 0f;
                    }
                    let _e826 = phi_883_;
                    global_8.member[_e252] = vec4<f32>(_e764, _e765, _e766, _e826);
                    global_8.member[(_e252 + 1u)] = vec4<f32>(_e753, _e754, _e755, _e774);
                    global_8.member[(_e252 + 2u)] = vec4<f32>(_e788, _e802, 0f, 0f);
                    global_8.member[(_e252 + 3u)] = vec4<f32>(0f, 0f, 0f, f32(_e822));
                    global_9.member[_e59] = _e822;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn segment(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
