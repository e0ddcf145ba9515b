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
    var phi_515_: f32;
    var phi_520_: type_18;
    var phi_549_: type_18;
    var phi_551_: type_18;
    var phi_552_: bool;
    var phi_556_: type_18;
    var phi_557_: type_18;
    var phi_568_: type_18;
    var phi_575_: type_18;
    var phi_577_: type_19;
    var phi_587_: f32;
    var phi_592_: type_18;
    var phi_621_: type_18;
    var phi_623_: type_18;
    var phi_624_: bool;
    var phi_628_: type_18;
    var phi_629_: type_18;
    var phi_640_: type_18;
    var phi_647_: type_18;
    var phi_649_: type_19;
    var phi_659_: f32;
    var phi_664_: type_18;
    var phi_693_: type_18;
    var phi_695_: type_18;
    var phi_696_: bool;
    var phi_700_: type_18;
    var phi_701_: type_18;
    var phi_712_: type_18;
    var phi_719_: type_18;
    var phi_721_: type_19;
    var phi_732_: type_18;
    var phi_740_: type_18;
    var phi_749_: type_18;
    var phi_757_: type_18;
    var phi_765_: type_18;
    var phi_789_: u32;
    var phi_793_: f32;
    var phi_842_: f32;
    var phi_848_: f32;
    var phi_856_: f32;
    var phi_857_: f32;
    var phi_862_: f32;
    var phi_868_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_892_: u32;
    var phi_896_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e53 = global;
            let _e54 = global_1;
            let _e55 = global_2;
            let _e63 = (((_e54.x + (_e54.y * _e55.x)) * 64u) + _e53.x);
            let _e66 = global_3.member.member;
            if (_e63 < _e66) {
                let _e70 = global_4.member[_e63];
                let _e73 = global_5.member[0u];
                let _e76 = global_5.member[1u];
                let _e79 = global_5.member[2u];
                let _e82 = global_5.member[3u];
                let _e85 = global_5.member[4u];
                let _e88 = global_5.member[5u];
                let _e91 = global_5.member[6u];
                let _e94 = global_5.member[7u];
                let _e97 = global_5.member[8u];
                let _e100 = global_5.member[9u];
                let _e103 = global_5.member[10u];
                let _e106 = global_5.member[11u];
                let _e109 = global_5.member[12u];
                let _e112 = global_5.member[13u];
                let _e115 = global_5.member[14u];
                let _e118 = global_5.member[15u];
                let _e121 = global_5.member[16u];
                let _e124 = global_5.member[17u];
                let _e127 = global_3.member.member_1;
                let _e128 = (_e127 == 0u);
                if _e128 {
                    break;
                }
                let _e130 = ((_e70 / _e127) * 18u);
                let _e134 = global_6.member[(_e130 + 9u)];
                let _e138 = global_6.member[(_e130 + 10u)];
                let _e142 = global_6.member[(_e130 + 11u)];
                let _e149 = (trunc((_e134 * _e82)) * _e73);
                let _e150 = (trunc((_e138 * _e85)) * _e76);
                let _e151 = (trunc((_e142 * _e88)) * _e79);
                let _e152 = (_e149 - _e91);
                let _e153 = (_e150 - _e94);
                let _e154 = (_e151 - _e97);
                let _e161 = (_e152 * _e109);
                let _e162 = (_e153 * _e112);
                let _e163 = (_e154 * _e115);
                let _e167 = (_e109 + _e118);
                let _e168 = (_e112 + _e121);
                let _e169 = (_e115 + _e124);
                let _e173 = ((_e152 * _e118) + (((_e134 - _e149) - _e100) * _e167));
                let _e174 = ((_e153 * _e121) + (((_e138 - _e150) - _e103) * _e168));
                let _e175 = ((_e154 * _e124) + (((_e142 - _e151) - _e106) * _e169));
                let _e179 = (trunc(((_e161 + _e173) * 4096f)) * 0.00024414063f);
                let _e181 = ((_e161 - _e179) + _e173);
                let _e185 = (trunc(((_e162 + _e174) * 4096f)) * 0.00024414063f);
                let _e187 = ((_e162 - _e185) + _e174);
                let _e191 = (trunc(((_e163 + _e175) * 4096f)) * 0.00024414063f);
                let _e193 = ((_e163 - _e191) + _e175);
                if _e128 {
                    break;
                }
                let _e195 = ((_e70 % _e127) * 3u);
                let _e198 = global_7.member[_e195];
                let _e202 = global_7.member[(_e195 + 1u)];
                let _e206 = global_7.member[(_e195 + 2u)];
                let _e213 = (trunc((_e198 * _e82)) * _e73);
                let _e214 = (trunc((_e202 * _e85)) * _e76);
                let _e215 = (trunc((_e206 * _e88)) * _e79);
                let _e216 = (_e213 - _e91);
                let _e217 = (_e214 - _e94);
                let _e218 = (_e215 - _e97);
                let _e225 = (_e216 * _e109);
                let _e226 = (_e217 * _e112);
                let _e227 = (_e218 * _e115);
                let _e234 = ((_e216 * _e118) + (((_e198 - _e213) - _e100) * _e167));
                let _e235 = ((_e217 * _e121) + (((_e202 - _e214) - _e103) * _e168));
                let _e236 = ((_e218 * _e124) + (((_e206 - _e215) - _e106) * _e169));
                let _e239 = trunc(((_e225 + _e234) * 4096f));
                let _e240 = (_e239 * 0.00024414063f);
                let _e242 = ((_e225 - _e240) + _e234);
                let _e245 = trunc(((_e226 + _e235) * 4096f));
                let _e246 = (_e245 * 0.00024414063f);
                let _e248 = ((_e226 - _e246) + _e235);
                let _e251 = trunc(((_e227 + _e236) * 4096f));
                let _e252 = (_e251 * 0.00024414063f);
                let _e254 = ((_e227 - _e252) + _e236);
                let _e255 = (_e63 * 4u);
                let _e258 = global_3.member.member_3;
                if (_e258 == 0u) {
                    let _e260 = (_e179 - _e240);
                    let _e261 = (_e181 - _e242);
                    let _e262 = (_e185 - _e246);
                    let _e263 = (_e187 - _e248);
                    let _e264 = (_e191 - _e252);
                    let _e265 = (_e193 - _e254);
                    let _e268 = global_3.member.member_2;
                    let _e270 = (_e260 + _e261);
                    if (_e270 < 0f) {
                        phi_515_ = -(_e270);
                    } else {
                        phi_515_ = _e270;
                    }
                    let _e274 = phi_515_;
                    let _e275 = (_e274 < 0.000000000000000000000000000000000000011754944f);
                    if _e275 {
                        phi_520_ = type_18(1f, 0f);
                    } else {
                        phi_520_ = type_18(_e260, _e261);
                    }
                    let _e277 = phi_520_;
                    let _e278 = (_e239 * -0.00024414063f);
                    let _e279 = -(_e242);
                    let _e282 = (_e277.member + _e277.member_1);
                    let _e284 = ((_e278 + _e279) / _e282);
                    let _e286 = select(0f, _e284, (_e284 > 0f));
                    let _e288 = select(1f, _e286, (_e286 < 1f));
                    let _e291 = (trunc((_e288 * 1024f)) * 0.0009765625f);
                    let _e301 = select(0f, (((_e278 - (_e291 * _e277.member)) + (_e279 - (_e291 * _e277.member_1))) / _e282), select(false, (_e288 < 1f), (0f < _e288)));
                    let _e302 = (1f - _e240);
                    let _e304 = ((_e302 + _e279) / _e282);
                    let _e306 = select(0f, _e304, (_e304 > 0f));
                    let _e308 = select(1f, _e306, (_e306 < 1f));
                    let _e311 = (trunc((_e308 * 1024f)) * 0.0009765625f);
                    let _e321 = select(0f, (((_e302 - (_e311 * _e277.member)) + (_e279 - (_e311 * _e277.member_1))) / _e282), select(false, (_e308 < 1f), (0f < _e308)));
                    let _e322 = (_e240 + _e242);
                    if (_e322 >= 0f) {
                        let _e324 = (_e322 <= 1f);
                        if _e324 {
                            phi_549_ = type_18(0f, 0f);
                        } else {
                            phi_549_ = type_18();
                        }
                        let _e326 = phi_549_;
                        phi_551_ = _e326;
                        phi_552_ = select(true, false, _e324);
                    } else {
                        phi_551_ = type_18();
                        phi_552_ = true;
                    }
                    let _e329 = phi_551_;
                    let _e331 = phi_552_;
                    if _e331 {
                        phi_556_ = type_18(1f, 0f);
                        phi_557_ = type_18(0f, 0f);
                    } else {
                        phi_556_ = _e329;
                        phi_557_ = type_18(1f, 0f);
                    }
                    let _e333 = phi_556_;
                    let _e335 = phi_557_;
                    if _e275 {
                        phi_577_ = type_19(_e333, _e335);
                    } else {
                        let _e337 = (_e291 + _e301);
                        let _e338 = (_e311 + _e321);
                        if (_e337 < _e338) {
                            phi_568_ = type_18(_e291, _e301);
                        } else {
                            phi_568_ = type_18(_e311, _e321);
                        }
                        let _e343 = phi_568_;
                        if (_e337 > _e338) {
                            phi_575_ = type_18(_e291, _e301);
                        } else {
                            phi_575_ = type_18(_e311, _e321);
                        }
                        let _e348 = phi_575_;
                        phi_577_ = type_19(_e343, _e348);
                    }
                    let _e351 = phi_577_;
                    let _e361 = (_e262 + _e263);
                    if (_e361 < 0f) {
                        phi_587_ = -(_e361);
                    } else {
                        phi_587_ = _e361;
                    }
                    let _e365 = phi_587_;
                    let _e366 = (_e365 < 0.000000000000000000000000000000000000011754944f);
                    if _e366 {
                        phi_592_ = type_18(1f, 0f);
                    } else {
                        phi_592_ = type_18(_e262, _e263);
                    }
                    let _e368 = phi_592_;
                    let _e369 = (_e245 * -0.00024414063f);
                    let _e370 = -(_e248);
                    let _e373 = (_e368.member + _e368.member_1);
                    let _e375 = ((_e369 + _e370) / _e373);
                    let _e377 = select(0f, _e375, (_e375 > 0f));
                    let _e379 = select(1f, _e377, (_e377 < 1f));
                    let _e382 = (trunc((_e379 * 1024f)) * 0.0009765625f);
                    let _e392 = select(0f, (((_e369 - (_e382 * _e368.member)) + (_e370 - (_e382 * _e368.member_1))) / _e373), select(false, (_e379 < 1f), (0f < _e379)));
                    let _e393 = (1f - _e246);
                    let _e395 = ((_e393 + _e370) / _e373);
                    let _e397 = select(0f, _e395, (_e395 > 0f));
                    let _e399 = select(1f, _e397, (_e397 < 1f));
                    let _e402 = (trunc((_e399 * 1024f)) * 0.0009765625f);
                    let _e412 = select(0f, (((_e393 - (_e402 * _e368.member)) + (_e370 - (_e402 * _e368.member_1))) / _e373), select(false, (_e399 < 1f), (0f < _e399)));
                    let _e413 = (_e246 + _e248);
                    if (_e413 >= 0f) {
                        let _e415 = (_e413 <= 1f);
                        if _e415 {
                            phi_621_ = type_18(0f, 0f);
                        } else {
                            phi_621_ = type_18();
                        }
                        let _e417 = phi_621_;
                        phi_623_ = _e417;
                        phi_624_ = select(true, false, _e415);
                    } else {
                        phi_623_ = type_18();
                        phi_624_ = true;
                    }
                    let _e420 = phi_623_;
                    let _e422 = phi_624_;
                    if _e422 {
                        phi_628_ = type_18(1f, 0f);
                        phi_629_ = type_18(0f, 0f);
                    } else {
                        phi_628_ = _e420;
                        phi_629_ = type_18(1f, 0f);
                    }
                    let _e424 = phi_628_;
                    let _e426 = phi_629_;
                    if _e366 {
                        phi_649_ = type_19(_e424, _e426);
                    } else {
                        let _e428 = (_e382 + _e392);
                        let _e429 = (_e402 + _e412);
                        if (_e428 < _e429) {
                            phi_640_ = type_18(_e382, _e392);
                        } else {
                            phi_640_ = type_18(_e402, _e412);
                        }
                        let _e434 = phi_640_;
                        if (_e428 > _e429) {
                            phi_647_ = type_18(_e382, _e392);
                        } else {
                            phi_647_ = type_18(_e402, _e412);
                        }
                        let _e439 = phi_647_;
                        phi_649_ = type_19(_e434, _e439);
                    }
                    let _e442 = phi_649_;
                    let _e452 = (_e264 + _e265);
                    if (_e452 < 0f) {
                        phi_659_ = -(_e452);
                    } else {
                        phi_659_ = _e452;
                    }
                    let _e456 = phi_659_;
                    let _e457 = (_e456 < 0.000000000000000000000000000000000000011754944f);
                    if _e457 {
                        phi_664_ = type_18(1f, 0f);
                    } else {
                        phi_664_ = type_18(_e264, _e265);
                    }
                    let _e459 = phi_664_;
                    let _e460 = (_e251 * -0.00024414063f);
                    let _e461 = -(_e254);
                    let _e464 = (_e459.member + _e459.member_1);
                    let _e466 = ((_e460 + _e461) / _e464);
                    let _e468 = select(0f, _e466, (_e466 > 0f));
                    let _e470 = select(1f, _e468, (_e468 < 1f));
                    let _e473 = (trunc((_e470 * 1024f)) * 0.0009765625f);
                    let _e483 = select(0f, (((_e460 - (_e473 * _e459.member)) + (_e461 - (_e473 * _e459.member_1))) / _e464), select(false, (_e470 < 1f), (0f < _e470)));
                    let _e484 = (1f - _e252);
                    let _e486 = ((_e484 + _e461) / _e464);
                    let _e488 = select(0f, _e486, (_e486 > 0f));
                    let _e490 = select(1f, _e488, (_e488 < 1f));
                    let _e493 = (trunc((_e490 * 1024f)) * 0.0009765625f);
                    let _e503 = select(0f, (((_e484 - (_e493 * _e459.member)) + (_e461 - (_e493 * _e459.member_1))) / _e464), select(false, (_e490 < 1f), (0f < _e490)));
                    let _e504 = (_e252 + _e254);
                    if (_e504 >= 0f) {
                        let _e506 = (_e504 <= 1f);
                        if _e506 {
                            phi_693_ = type_18(0f, 0f);
                        } else {
                            phi_693_ = type_18();
                        }
                        let _e508 = phi_693_;
                        phi_695_ = _e508;
                        phi_696_ = select(true, false, _e506);
                    } else {
                        phi_695_ = type_18();
                        phi_696_ = true;
                    }
                    let _e511 = phi_695_;
                    let _e513 = phi_696_;
                    if _e513 {
                        phi_700_ = type_18(1f, 0f);
                        phi_701_ = type_18(0f, 0f);
                    } else {
                        phi_700_ = _e511;
                        phi_701_ = type_18(1f, 0f);
                    }
                    let _e515 = phi_700_;
                    let _e517 = phi_701_;
                    if _e457 {
                        phi_721_ = type_19(_e515, _e517);
                    } else {
                        let _e519 = (_e473 + _e483);
                        let _e520 = (_e493 + _e503);
                        if (_e519 < _e520) {
                            phi_712_ = type_18(_e473, _e483);
                        } else {
                            phi_712_ = type_18(_e493, _e503);
                        }
                        let _e525 = phi_712_;
                        if (_e519 > _e520) {
                            phi_719_ = type_18(_e473, _e483);
                        } else {
                            phi_719_ = type_18(_e493, _e503);
                        }
                        let _e530 = phi_719_;
                        phi_721_ = type_19(_e525, _e530);
                    }
                    let _e533 = phi_721_;
                    if ((_e351.member.member + _e351.member.member_1) > (_e442.member.member + _e442.member.member_1)) {
                        phi_732_ = _e351.member;
                    } else {
                        phi_732_ = _e442.member;
                    }
                    let _e548 = phi_732_;
                    if ((_e548.member + _e548.member_1) > (_e533.member.member + _e533.member.member_1)) {
                        phi_740_ = _e548;
                    } else {
                        phi_740_ = _e533.member;
                    }
                    let _e556 = phi_740_;
                    if ((_e351.member_1.member + _e351.member_1.member_1) < (_e442.member_1.member + _e442.member_1.member_1)) {
                        phi_749_ = _e351.member_1;
                    } else {
                        phi_749_ = _e442.member_1;
                    }
                    let _e565 = phi_749_;
                    if ((_e565.member + _e565.member_1) < (_e533.member_1.member + _e533.member_1.member_1)) {
                        phi_757_ = _e565;
                    } else {
                        phi_757_ = _e533.member_1;
                    }
                    let _e573 = phi_757_;
                    let _e576 = (_e573.member - _e556.member);
                    let _e577 = (_e573.member_1 - _e556.member_1);
                    if ((_e576 + _e577) > 0f) {
                        phi_765_ = type_18(_e576, _e577);
                    } else {
                        phi_765_ = type_18(0f, 0f);
                    }
                    let _e582 = phi_765_;
                    let _e587 = ((_e582.member * _e261) + (_e582.member_1 * _e270));
                    let _e588 = (_e582.member * _e260);
                    let _e592 = (trunc(((_e588 + _e587) * 4096f)) * 0.00024414063f);
                    let _e594 = ((_e588 - _e592) + _e587);
                    let _e597 = ((_e582.member * _e263) + (_e582.member_1 * _e361));
                    let _e598 = (_e582.member * _e262);
                    let _e602 = (trunc(((_e598 + _e597) * 4096f)) * 0.00024414063f);
                    let _e604 = ((_e598 - _e602) + _e597);
                    let _e607 = ((_e582.member * _e265) + (_e582.member_1 * _e452));
                    let _e608 = (_e582.member * _e264);
                    let _e612 = (trunc(((_e608 + _e607) * 4096f)) * 0.00024414063f);
                    let _e614 = ((_e608 - _e612) + _e607);
                    let _e615 = (_e592 + _e594);
                    let _e616 = (_e602 + _e604);
                    let _e617 = (_e612 + _e614);
                    let _e623 = sqrt((((_e615 * _e615) + (_e616 * _e616)) + (_e617 * _e617)));
                    let _e624 = (_e623 > 0f);
                    let _e626 = ceil((_e623 / _e268));
                    let _e628 = select(1f, _e626, (_e626 > 1f));
                    let _e630 = select(16384f, _e628, (_e628 < 16384f));
                    let _e634 = (_e242 + ((_e556.member * _e261) + (_e556.member_1 * _e270)));
                    let _e636 = (_e240 + (_e556.member * _e260));
                    let _e640 = (trunc(((_e636 + _e634) * 4096f)) * 0.00024414063f);
                    let _e646 = (_e248 + ((_e556.member * _e263) + (_e556.member_1 * _e361)));
                    let _e648 = (_e246 + (_e556.member * _e262));
                    let _e652 = (trunc(((_e648 + _e646) * 4096f)) * 0.00024414063f);
                    let _e658 = (_e254 + ((_e556.member * _e265) + (_e556.member_1 * _e452)));
                    let _e660 = (_e252 + (_e556.member * _e264));
                    let _e664 = (trunc(((_e660 + _e658) * 4096f)) * 0.00024414063f);
                    if _e624 {
                        phi_789_ = select(select(u32(_e630), 0u, (_e630 < 0f)), 4294967295u, (_e630 > 4294967000f));
                    } else {
                        phi_789_ = 0u;
                    }
                    let _e673 = phi_789_;
                    if _e624 {
                        phi_793_ = ((_e623 / _e630) / _e268);
                    } else {
                        phi_793_ = 0f;
                    }
                    let _e677 = phi_793_;
                    global_8.member[_e255] = vec4<f32>(_e640, _e652, _e664, _e677);
                    global_8.member[(_e255 + 1u)] = vec4<f32>(_e592, _e602, _e612, 0f);
                    global_8.member[(_e255 + 2u)] = vec4<f32>(((_e636 - _e640) + _e634), ((_e648 - _e652) + _e646), ((_e660 - _e664) + _e658), 0f);
                    global_8.member[(_e255 + 3u)] = vec4<f32>(_e594, _e604, _e614, 0f);
                    global_9.member[_e63] = _e673;
                } else {
                    let _e696 = ((_e240 - 0.5f) + _e242);
                    let _e698 = ((_e246 - 0.5f) + _e248);
                    let _e700 = ((_e252 - 0.5f) + _e254);
                    let _e702 = ((_e179 - 0.5f) + _e181);
                    let _e704 = ((_e185 - 0.5f) + _e187);
                    let _e706 = ((_e191 - 0.5f) + _e193);
                    let _e709 = global_3.member.member_2;
                    let _e711 = select(-1000000000000000f, _e696, (_e696 > -1000000000000000f));
                    let _e715 = select(-1000000000000000f, _e698, (_e698 > -1000000000000000f));
                    let _e719 = select(-1000000000000000f, _e700, (_e700 > -1000000000000000f));
                    let _e723 = select(-1000000000000000f, _e702, (_e702 > -1000000000000000f));
                    let _e725 = select(1000000000000000f, _e723, (_e723 < 1000000000000000f));
                    let _e727 = select(-1000000000000000f, _e704, (_e704 > -1000000000000000f));
                    let _e729 = select(1000000000000000f, _e727, (_e727 < 1000000000000000f));
                    let _e731 = select(-1000000000000000f, _e706, (_e706 > -1000000000000000f));
                    let _e733 = select(1000000000000000f, _e731, (_e731 < 1000000000000000f));
                    let _e734 = (_e725 - select(1000000000000000f, _e711, (_e711 < 1000000000000000f)));
                    let _e735 = (_e729 - select(1000000000000000f, _e715, (_e715 < 1000000000000000f)));
                    let _e736 = (_e733 - select(1000000000000000f, _e719, (_e719 < 1000000000000000f)));
                    let _e742 = sqrt((((_e734 * _e734) + (_e735 * _e735)) + (_e736 * _e736)));
                    let _e745 = (1f / select(0.000000000000000000000000000000000000011754944f, _e742, (_e742 > 0.000000000000000000000000000000000000011754944f)));
                    let _e746 = (_e734 * _e745);
                    let _e747 = (_e735 * _e745);
                    let _e748 = (_e736 * _e745);
                    let _e753 = (((_e725 * _e746) + (_e729 * _e747)) + (_e733 * _e748));
                    let _e757 = (_e725 - (_e746 * _e753));
                    let _e758 = (_e729 - (_e747 * _e753));
                    let _e759 = (_e733 - (_e748 * _e753));
                    let _e765 = sqrt((((_e757 * _e757) + (_e758 * _e758)) + (_e759 * _e759)));
                    let _e767 = select(0.4330127f, _e765, (_e765 > 0.4330127f));
                    let _e768 = (_e753 - _e742);
                    let _e769 = (_e768 < 0f);
                    if _e769 {
                        phi_842_ = -(_e768);
                    } else {
                        phi_842_ = _e768;
                    }
                    let _e772 = phi_842_;
                    let _e777 = (_e767 * (2f - (_e767 / select(_e767, _e772, (_e772 > _e767)))));
                    if _e769 {
                        phi_848_ = -(_e768);
                    } else {
                        phi_848_ = _e768;
                    }
                    let _e780 = phi_848_;
                    if (_e780 <= _e767) {
                        phi_857_ = _e768;
                    } else {
                        if _e769 {
                            phi_856_ = -(_e777);
                        } else {
                            phi_856_ = _e777;
                        }
                        let _e784 = phi_856_;
                        phi_857_ = _e784;
                    }
                    let _e786 = phi_857_;
                    let _e787 = (_e753 < 0f);
                    if _e787 {
                        phi_862_ = -(_e753);
                    } else {
                        phi_862_ = _e753;
                    }
                    let _e790 = phi_862_;
                    let _e795 = (_e767 * (2f - (_e767 / select(_e767, _e790, (_e790 > _e767)))));
                    if _e787 {
                        phi_868_ = -(_e753);
                    } else {
                        phi_868_ = _e753;
                    }
                    let _e798 = phi_868_;
                    if (_e798 <= _e767) {
                        phi_877_ = _e753;
                    } else {
                        if _e787 {
                            phi_876_ = -(_e795);
                        } else {
                            phi_876_ = _e795;
                        }
                        let _e802 = phi_876_;
                        phi_877_ = _e802;
                    }
                    let _e804 = phi_877_;
                    let _e805 = (_e804 - _e786);
                    let _e807 = ((0.4330127f / _e767) * _e805);
                    let _e808 = (_e807 > 0f);
                    let _e810 = ceil((_e807 / _e709));
                    let _e812 = select(1f, _e810, (_e810 > 1f));
                    let _e814 = select(16384f, _e812, (_e812 < 16384f));
                    if _e808 {
                        phi_892_ = select(select(u32(_e814), 0u, (_e814 < 0f)), 4294967295u, (_e814 > 4294967000f));
                    } else {
                        phi_892_ = 0u;
                    }
                    let _e821 = phi_892_;
                    if _e808 {
                        phi_896_ = ((_e807 / _e814) / _e709);
                    } else {
                        phi_896_ = 0f;
                    }
                    let _e825 = phi_896_;
                    global_8.member[_e255] = vec4<f32>(_e757, _e758, _e759, _e825);
                    global_8.member[(_e255 + 1u)] = vec4<f32>(_e746, _e747, _e748, _e767);
                    global_8.member[(_e255 + 2u)] = vec4<f32>(_e786, _e805, 0f, 0f);
                    global_8.member[(_e255 + 3u)] = vec4<f32>(0f, 0f, 0f, 0f);
                    global_9.member[_e63] = _e821;
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
