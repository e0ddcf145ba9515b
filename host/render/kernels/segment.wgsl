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
    var phi_521_: type_18;
    var phi_550_: type_18;
    var phi_552_: type_18;
    var phi_553_: bool;
    var phi_557_: type_18;
    var phi_558_: type_18;
    var phi_569_: type_18;
    var phi_576_: type_18;
    var phi_578_: type_19;
    var phi_589_: type_18;
    var phi_618_: type_18;
    var phi_620_: type_18;
    var phi_621_: bool;
    var phi_625_: type_18;
    var phi_626_: type_18;
    var phi_637_: type_18;
    var phi_644_: type_18;
    var phi_646_: type_19;
    var phi_657_: type_18;
    var phi_686_: type_18;
    var phi_688_: type_18;
    var phi_689_: bool;
    var phi_693_: type_18;
    var phi_694_: type_18;
    var phi_705_: type_18;
    var phi_712_: type_18;
    var phi_714_: type_19;
    var phi_725_: type_18;
    var phi_733_: type_18;
    var phi_742_: type_18;
    var phi_750_: type_18;
    var phi_758_: type_18;
    var phi_786_: u32;
    var phi_790_: f32;
    var phi_846_: f32;
    var phi_847_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_879_: u32;
    var phi_883_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e50 = global;
            let _e51 = global_1;
            let _e52 = global_2;
            let _e60 = (((_e51.x + (_e51.y * _e52.x)) * 64u) + _e50.x);
            let _e63 = global_3.member.member;
            if (_e60 < _e63) {
                let _e67 = global_4.member[_e60];
                let _e70 = global_5.member[0u];
                let _e73 = global_5.member[1u];
                let _e76 = global_5.member[2u];
                let _e79 = global_5.member[3u];
                let _e82 = global_5.member[4u];
                let _e85 = global_5.member[5u];
                let _e88 = global_5.member[6u];
                let _e91 = global_5.member[7u];
                let _e94 = global_5.member[8u];
                let _e97 = global_5.member[9u];
                let _e100 = global_5.member[10u];
                let _e103 = global_5.member[11u];
                let _e106 = global_5.member[12u];
                let _e109 = global_5.member[13u];
                let _e112 = global_5.member[14u];
                let _e115 = global_5.member[15u];
                let _e118 = global_5.member[16u];
                let _e121 = global_5.member[17u];
                let _e124 = global_3.member.member_1;
                let _e125 = (_e124 == 0u);
                if _e125 {
                    break;
                }
                let _e127 = ((_e67 / _e124) * 18u);
                let _e131 = global_6.member[(_e127 + 9u)];
                let _e135 = global_6.member[(_e127 + 10u)];
                let _e139 = global_6.member[(_e127 + 11u)];
                let _e142 = (trunc((_e131 * _e79)) * _e70);
                let _e143 = (_e142 - _e88);
                let _e147 = (_e106 + _e115);
                let _e149 = ((_e143 * _e115) + (((_e131 - _e142) - _e97) * _e147));
                let _e150 = (_e143 * _e106);
                let _e154 = (1f / 4096f);
                let _e155 = (trunc(((_e150 + _e149) * 4096f)) * _e154);
                let _e157 = ((_e150 - _e155) + _e149);
                let _e160 = (trunc((_e135 * _e82)) * _e73);
                let _e161 = (_e160 - _e91);
                let _e165 = (_e109 + _e118);
                let _e167 = ((_e161 * _e118) + (((_e135 - _e160) - _e100) * _e165));
                let _e168 = (_e161 * _e109);
                let _e172 = (trunc(((_e168 + _e167) * 4096f)) * _e154);
                let _e174 = ((_e168 - _e172) + _e167);
                let _e177 = (trunc((_e139 * _e85)) * _e76);
                let _e178 = (_e177 - _e94);
                let _e182 = (_e112 + _e121);
                let _e184 = ((_e178 * _e121) + (((_e139 - _e177) - _e103) * _e182));
                let _e185 = (_e178 * _e112);
                let _e189 = (trunc(((_e185 + _e184) * 4096f)) * _e154);
                let _e191 = ((_e185 - _e189) + _e184);
                if _e125 {
                    break;
                }
                let _e193 = ((_e67 % _e124) * 3u);
                let _e196 = global_7.member[_e193];
                let _e200 = global_7.member[(_e193 + 1u)];
                let _e204 = global_7.member[(_e193 + 2u)];
                let _e207 = (trunc((_e196 * _e79)) * _e70);
                let _e208 = (_e207 - _e88);
                let _e213 = ((_e208 * _e115) + (((_e196 - _e207) - _e97) * _e147));
                let _e214 = (_e208 * _e106);
                let _e218 = (trunc(((_e214 + _e213) * 4096f)) * _e154);
                let _e220 = ((_e214 - _e218) + _e213);
                let _e223 = (trunc((_e200 * _e82)) * _e73);
                let _e224 = (_e223 - _e91);
                let _e229 = ((_e224 * _e118) + (((_e200 - _e223) - _e100) * _e165));
                let _e230 = (_e224 * _e109);
                let _e234 = (trunc(((_e230 + _e229) * 4096f)) * _e154);
                let _e236 = ((_e230 - _e234) + _e229);
                let _e239 = (trunc((_e204 * _e85)) * _e76);
                let _e240 = (_e239 - _e94);
                let _e245 = ((_e240 * _e121) + (((_e204 - _e239) - _e103) * _e182));
                let _e246 = (_e240 * _e112);
                let _e250 = (trunc(((_e246 + _e245) * 4096f)) * _e154);
                let _e252 = ((_e246 - _e250) + _e245);
                let _e253 = (_e60 * 4u);
                let _e256 = global_3.member.member_3;
                if (_e256 == 0u) {
                    let _e258 = (_e155 - _e218);
                    let _e259 = (_e157 - _e220);
                    let _e260 = (_e172 - _e234);
                    let _e261 = (_e174 - _e236);
                    let _e262 = (_e189 - _e250);
                    let _e263 = (_e191 - _e252);
                    let _e266 = global_3.member.member_2;
                    let _e268 = (_e258 + _e259);
                    let _e270 = (abs(_e268) < 0.000000000000000000000000000000000000011754944f);
                    if _e270 {
                        phi_521_ = type_18(1f, 0f);
                    } else {
                        phi_521_ = type_18(_e258, _e259);
                    }
                    let _e272 = phi_521_;
                    let _e273 = (0f - _e218);
                    let _e274 = (0f - _e220);
                    let _e277 = (_e272.member + _e272.member_1);
                    let _e279 = ((_e273 + _e274) / _e277);
                    let _e281 = select(0f, _e279, (_e279 > 0f));
                    let _e283 = select(1f, _e281, (_e281 < 1f));
                    let _e286 = (1f / 1024f);
                    let _e287 = (trunc((_e283 * 1024f)) * _e286);
                    let _e297 = select(0f, (((_e273 - (_e287 * _e272.member)) + (_e274 - (_e287 * _e272.member_1))) / _e277), select(false, (_e283 < 1f), (0f < _e283)));
                    let _e298 = (1f - _e218);
                    let _e300 = ((_e298 + _e274) / _e277);
                    let _e302 = select(0f, _e300, (_e300 > 0f));
                    let _e304 = select(1f, _e302, (_e302 < 1f));
                    let _e307 = (trunc((_e304 * 1024f)) * _e286);
                    let _e317 = select(0f, (((_e298 - (_e307 * _e272.member)) + (_e274 - (_e307 * _e272.member_1))) / _e277), select(false, (_e304 < 1f), (0f < _e304)));
                    let _e318 = (_e218 + _e220);
                    if (_e318 >= 0f) {
                        let _e320 = (_e318 <= 1f);
                        if _e320 {
                            phi_550_ = type_18(0f, 0f);
                        } else {
                            phi_550_ = type_18();
                        }
                        let _e322 = phi_550_;
                        phi_552_ = _e322;
                        phi_553_ = select(true, false, _e320);
                    } else {
                        phi_552_ = type_18();
                        phi_553_ = true;
                    }
                    let _e325 = phi_552_;
                    let _e327 = phi_553_;
                    if _e327 {
                        phi_557_ = type_18(1f, 0f);
                        phi_558_ = type_18(0f, 0f);
                    } else {
                        phi_557_ = _e325;
                        phi_558_ = type_18(1f, 0f);
                    }
                    let _e329 = phi_557_;
                    let _e331 = phi_558_;
                    if _e270 {
                        phi_578_ = type_19(_e329, _e331);
                    } else {
                        let _e333 = (_e287 + _e297);
                        let _e334 = (_e307 + _e317);
                        if (_e333 < _e334) {
                            phi_569_ = type_18(_e287, _e297);
                        } else {
                            phi_569_ = type_18(_e307, _e317);
                        }
                        let _e339 = phi_569_;
                        if (_e333 > _e334) {
                            phi_576_ = type_18(_e287, _e297);
                        } else {
                            phi_576_ = type_18(_e307, _e317);
                        }
                        let _e344 = phi_576_;
                        phi_578_ = type_19(_e339, _e344);
                    }
                    let _e347 = phi_578_;
                    let _e357 = (_e260 + _e261);
                    let _e359 = (abs(_e357) < 0.000000000000000000000000000000000000011754944f);
                    if _e359 {
                        phi_589_ = type_18(1f, 0f);
                    } else {
                        phi_589_ = type_18(_e260, _e261);
                    }
                    let _e361 = phi_589_;
                    let _e362 = (0f - _e234);
                    let _e363 = (0f - _e236);
                    let _e366 = (_e361.member + _e361.member_1);
                    let _e368 = ((_e362 + _e363) / _e366);
                    let _e370 = select(0f, _e368, (_e368 > 0f));
                    let _e372 = select(1f, _e370, (_e370 < 1f));
                    let _e375 = (trunc((_e372 * 1024f)) * _e286);
                    let _e385 = select(0f, (((_e362 - (_e375 * _e361.member)) + (_e363 - (_e375 * _e361.member_1))) / _e366), select(false, (_e372 < 1f), (0f < _e372)));
                    let _e386 = (1f - _e234);
                    let _e388 = ((_e386 + _e363) / _e366);
                    let _e390 = select(0f, _e388, (_e388 > 0f));
                    let _e392 = select(1f, _e390, (_e390 < 1f));
                    let _e395 = (trunc((_e392 * 1024f)) * _e286);
                    let _e405 = select(0f, (((_e386 - (_e395 * _e361.member)) + (_e363 - (_e395 * _e361.member_1))) / _e366), select(false, (_e392 < 1f), (0f < _e392)));
                    let _e406 = (_e234 + _e236);
                    if (_e406 >= 0f) {
                        let _e408 = (_e406 <= 1f);
                        if _e408 {
                            phi_618_ = type_18(0f, 0f);
                        } else {
                            phi_618_ = type_18();
                        }
                        let _e410 = phi_618_;
                        phi_620_ = _e410;
                        phi_621_ = select(true, false, _e408);
                    } else {
                        phi_620_ = type_18();
                        phi_621_ = true;
                    }
                    let _e413 = phi_620_;
                    let _e415 = phi_621_;
                    if _e415 {
                        phi_625_ = type_18(1f, 0f);
                        phi_626_ = type_18(0f, 0f);
                    } else {
                        phi_625_ = _e413;
                        phi_626_ = type_18(1f, 0f);
                    }
                    let _e417 = phi_625_;
                    let _e419 = phi_626_;
                    if _e359 {
                        phi_646_ = type_19(_e417, _e419);
                    } else {
                        let _e421 = (_e375 + _e385);
                        let _e422 = (_e395 + _e405);
                        if (_e421 < _e422) {
                            phi_637_ = type_18(_e375, _e385);
                        } else {
                            phi_637_ = type_18(_e395, _e405);
                        }
                        let _e427 = phi_637_;
                        if (_e421 > _e422) {
                            phi_644_ = type_18(_e375, _e385);
                        } else {
                            phi_644_ = type_18(_e395, _e405);
                        }
                        let _e432 = phi_644_;
                        phi_646_ = type_19(_e427, _e432);
                    }
                    let _e435 = phi_646_;
                    let _e445 = (_e262 + _e263);
                    let _e447 = (abs(_e445) < 0.000000000000000000000000000000000000011754944f);
                    if _e447 {
                        phi_657_ = type_18(1f, 0f);
                    } else {
                        phi_657_ = type_18(_e262, _e263);
                    }
                    let _e449 = phi_657_;
                    let _e450 = (0f - _e250);
                    let _e451 = (0f - _e252);
                    let _e454 = (_e449.member + _e449.member_1);
                    let _e456 = ((_e450 + _e451) / _e454);
                    let _e458 = select(0f, _e456, (_e456 > 0f));
                    let _e460 = select(1f, _e458, (_e458 < 1f));
                    let _e463 = (trunc((_e460 * 1024f)) * _e286);
                    let _e473 = select(0f, (((_e450 - (_e463 * _e449.member)) + (_e451 - (_e463 * _e449.member_1))) / _e454), select(false, (_e460 < 1f), (0f < _e460)));
                    let _e474 = (1f - _e250);
                    let _e476 = ((_e474 + _e451) / _e454);
                    let _e478 = select(0f, _e476, (_e476 > 0f));
                    let _e480 = select(1f, _e478, (_e478 < 1f));
                    let _e483 = (trunc((_e480 * 1024f)) * _e286);
                    let _e493 = select(0f, (((_e474 - (_e483 * _e449.member)) + (_e451 - (_e483 * _e449.member_1))) / _e454), select(false, (_e480 < 1f), (0f < _e480)));
                    let _e494 = (_e250 + _e252);
                    if (_e494 >= 0f) {
                        let _e496 = (_e494 <= 1f);
                        if _e496 {
                            phi_686_ = type_18(0f, 0f);
                        } else {
                            phi_686_ = type_18();
                        }
                        let _e498 = phi_686_;
                        phi_688_ = _e498;
                        phi_689_ = select(true, false, _e496);
                    } else {
                        phi_688_ = type_18();
                        phi_689_ = true;
                    }
                    let _e501 = phi_688_;
                    let _e503 = phi_689_;
                    if _e503 {
                        phi_693_ = type_18(1f, 0f);
                        phi_694_ = type_18(0f, 0f);
                    } else {
                        phi_693_ = _e501;
                        phi_694_ = type_18(1f, 0f);
                    }
                    let _e505 = phi_693_;
                    let _e507 = phi_694_;
                    if _e447 {
                        phi_714_ = type_19(_e505, _e507);
                    } else {
                        let _e509 = (_e463 + _e473);
                        let _e510 = (_e483 + _e493);
                        if (_e509 < _e510) {
                            phi_705_ = type_18(_e463, _e473);
                        } else {
                            phi_705_ = type_18(_e483, _e493);
                        }
                        let _e515 = phi_705_;
                        if (_e509 > _e510) {
                            phi_712_ = type_18(_e463, _e473);
                        } else {
                            phi_712_ = type_18(_e483, _e493);
                        }
                        let _e520 = phi_712_;
                        phi_714_ = type_19(_e515, _e520);
                    }
                    let _e523 = phi_714_;
                    if ((_e347.member.member + _e347.member.member_1) > (_e435.member.member + _e435.member.member_1)) {
                        phi_725_ = _e347.member;
                    } else {
                        phi_725_ = _e435.member;
                    }
                    let _e538 = phi_725_;
                    if ((_e538.member + _e538.member_1) > (_e523.member.member + _e523.member.member_1)) {
                        phi_733_ = _e538;
                    } else {
                        phi_733_ = _e523.member;
                    }
                    let _e546 = phi_733_;
                    if ((_e347.member_1.member + _e347.member_1.member_1) < (_e435.member_1.member + _e435.member_1.member_1)) {
                        phi_742_ = _e347.member_1;
                    } else {
                        phi_742_ = _e435.member_1;
                    }
                    let _e555 = phi_742_;
                    if ((_e555.member + _e555.member_1) < (_e523.member_1.member + _e523.member_1.member_1)) {
                        phi_750_ = _e555;
                    } else {
                        phi_750_ = _e523.member_1;
                    }
                    let _e563 = phi_750_;
                    let _e566 = (_e563.member - _e546.member);
                    let _e567 = (_e563.member_1 - _e546.member_1);
                    if ((_e566 + _e567) > 0f) {
                        phi_758_ = type_18(_e566, _e567);
                    } else {
                        phi_758_ = type_18(0f, 0f);
                    }
                    let _e572 = phi_758_;
                    let _e578 = (0f + ((_e572.member * _e259) + (_e572.member_1 * _e268)));
                    let _e580 = (0f + (_e572.member * _e258));
                    let _e584 = (trunc(((_e580 + _e578) * 4096f)) * _e154);
                    let _e586 = ((_e580 - _e584) + _e578);
                    let _e590 = (0f + ((_e572.member * _e261) + (_e572.member_1 * _e357)));
                    let _e592 = (0f + (_e572.member * _e260));
                    let _e596 = (trunc(((_e592 + _e590) * 4096f)) * _e154);
                    let _e598 = ((_e592 - _e596) + _e590);
                    let _e602 = (0f + ((_e572.member * _e263) + (_e572.member_1 * _e445)));
                    let _e604 = (0f + (_e572.member * _e262));
                    let _e608 = (trunc(((_e604 + _e602) * 4096f)) * _e154);
                    let _e610 = ((_e604 - _e608) + _e602);
                    let _e611 = (_e584 + _e586);
                    let _e612 = (_e596 + _e598);
                    let _e613 = (_e608 + _e610);
                    let _e619 = sqrt((((_e611 * _e611) + (_e612 * _e612)) + (_e613 * _e613)));
                    let _e620 = (_e619 > 0f);
                    let _e622 = ceil((_e619 / _e266));
                    let _e623 = f32(16384u);
                    let _e625 = select(1f, _e622, (_e622 > 1f));
                    let _e627 = select(_e623, _e625, (_e625 < _e623));
                    let _e631 = (_e220 + ((_e546.member * _e259) + (_e546.member_1 * _e268)));
                    let _e633 = (_e218 + (_e546.member * _e258));
                    let _e637 = (trunc(((_e633 + _e631) * 4096f)) * _e154);
                    let _e643 = (_e236 + ((_e546.member * _e261) + (_e546.member_1 * _e357)));
                    let _e645 = (_e234 + (_e546.member * _e260));
                    let _e649 = (trunc(((_e645 + _e643) * 4096f)) * _e154);
                    let _e655 = (_e252 + ((_e546.member * _e263) + (_e546.member_1 * _e445)));
                    let _e657 = (_e250 + (_e546.member * _e262));
                    let _e661 = (trunc(((_e657 + _e655) * 4096f)) * _e154);
                    if _e620 {
                        phi_786_ = select(select(u32(_e627), 0u, !((_e627 >= bitcast<f32>(0u)))), 4294967295u, (_e627 > bitcast<f32>(1333788671u)));
                    } else {
                        phi_786_ = 0u;
                    }
                    let _e673 = phi_786_;
                    if _e620 {
                        phi_790_ = ((_e619 / _e627) / _e266);
                    } else {
                        phi_790_ = 0f;
                    }
                    let _e677 = phi_790_;
                    global_8.member[_e253] = vec4<f32>(_e637, _e649, _e661, _e677);
                    global_8.member[(_e253 + 1u)] = vec4<f32>(_e584, _e596, _e608, 0f);
                    global_8.member[(_e253 + 2u)] = vec4<f32>(((_e633 - _e637) + _e631), ((_e645 - _e649) + _e643), ((_e657 - _e661) + _e655), 0f);
                    global_8.member[(_e253 + 3u)] = vec4<f32>(_e586, _e598, _e610, 0f);
                    global_9.member[_e60] = _e673;
                } else {
                    let _e697 = ((_e218 - 0.5f) + (_e220 - 0f));
                    let _e700 = ((_e234 - 0.5f) + (_e236 - 0f));
                    let _e703 = ((_e250 - 0.5f) + (_e252 - 0f));
                    let _e706 = ((_e155 - 0.5f) + (_e157 - 0f));
                    let _e709 = ((_e172 - 0.5f) + (_e174 - 0f));
                    let _e712 = ((_e189 - 0.5f) + (_e191 - 0f));
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
                    global_8.member[_e253] = vec4<f32>(_e764, _e765, _e766, _e826);
                    global_8.member[(_e253 + 1u)] = vec4<f32>(_e753, _e754, _e755, _e774);
                    global_8.member[(_e253 + 2u)] = vec4<f32>(_e788, _e802, 0f, 0f);
                    global_8.member[(_e253 + 3u)] = vec4<f32>(0f, 0f, 0f, 0f);
                    global_9.member[_e60] = _e822;
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
