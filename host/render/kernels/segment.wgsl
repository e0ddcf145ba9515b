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
    var phi_510_: type_18;
    var phi_539_: type_18;
    var phi_541_: type_18;
    var phi_542_: bool;
    var phi_546_: type_18;
    var phi_547_: type_18;
    var phi_558_: type_18;
    var phi_565_: type_18;
    var phi_567_: type_19;
    var phi_578_: type_18;
    var phi_607_: type_18;
    var phi_609_: type_18;
    var phi_610_: bool;
    var phi_614_: type_18;
    var phi_615_: type_18;
    var phi_626_: type_18;
    var phi_633_: type_18;
    var phi_635_: type_19;
    var phi_646_: type_18;
    var phi_675_: type_18;
    var phi_677_: type_18;
    var phi_678_: bool;
    var phi_682_: type_18;
    var phi_683_: type_18;
    var phi_694_: type_18;
    var phi_701_: type_18;
    var phi_703_: type_19;
    var phi_714_: type_18;
    var phi_722_: type_18;
    var phi_731_: type_18;
    var phi_739_: type_18;
    var phi_747_: type_18;
    var phi_771_: u32;
    var phi_775_: f32;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_860_: u32;
    var phi_864_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = global;
            let _e55 = global_1;
            let _e56 = global_2;
            let _e64 = (((_e55.x + (_e55.y * _e56.x)) * 64u) + _e54.x);
            let _e67 = global_3.member.member;
            if (_e64 < _e67) {
                let _e71 = global_4.member[_e64];
                let _e74 = global_5.member[0u];
                let _e77 = global_5.member[1u];
                let _e80 = global_5.member[2u];
                let _e83 = global_5.member[3u];
                let _e86 = global_5.member[4u];
                let _e89 = global_5.member[5u];
                let _e92 = global_5.member[6u];
                let _e95 = global_5.member[7u];
                let _e98 = global_5.member[8u];
                let _e101 = global_5.member[9u];
                let _e104 = global_5.member[10u];
                let _e107 = global_5.member[11u];
                let _e110 = global_5.member[12u];
                let _e113 = global_5.member[13u];
                let _e116 = global_5.member[14u];
                let _e119 = global_5.member[15u];
                let _e122 = global_5.member[16u];
                let _e125 = global_5.member[17u];
                let _e128 = global_3.member.member_1;
                let _e129 = (_e128 == 0u);
                if _e129 {
                    break;
                }
                let _e131 = ((_e71 / _e128) * 18u);
                let _e135 = global_6.member[(_e131 + 9u)];
                let _e139 = global_6.member[(_e131 + 10u)];
                let _e143 = global_6.member[(_e131 + 11u)];
                let _e150 = (trunc((_e135 * _e83)) * _e74);
                let _e151 = (trunc((_e139 * _e86)) * _e77);
                let _e152 = (trunc((_e143 * _e89)) * _e80);
                let _e153 = (_e150 - _e92);
                let _e154 = (_e151 - _e95);
                let _e155 = (_e152 - _e98);
                let _e162 = (_e153 * _e110);
                let _e163 = (_e154 * _e113);
                let _e164 = (_e155 * _e116);
                let _e168 = (_e110 + _e119);
                let _e169 = (_e113 + _e122);
                let _e170 = (_e116 + _e125);
                let _e174 = ((_e153 * _e119) + (((_e135 - _e150) - _e101) * _e168));
                let _e175 = ((_e154 * _e122) + (((_e139 - _e151) - _e104) * _e169));
                let _e176 = ((_e155 * _e125) + (((_e143 - _e152) - _e107) * _e170));
                let _e180 = (trunc(((_e162 + _e174) * 4096f)) * 0.00024414063f);
                let _e182 = ((_e162 - _e180) + _e174);
                let _e186 = (trunc(((_e163 + _e175) * 4096f)) * 0.00024414063f);
                let _e188 = ((_e163 - _e186) + _e175);
                let _e192 = (trunc(((_e164 + _e176) * 4096f)) * 0.00024414063f);
                let _e194 = ((_e164 - _e192) + _e176);
                if _e129 {
                    break;
                }
                let _e196 = ((_e71 % _e128) * 3u);
                let _e199 = global_7.member[_e196];
                let _e203 = global_7.member[(_e196 + 1u)];
                let _e207 = global_7.member[(_e196 + 2u)];
                let _e214 = (trunc((_e199 * _e83)) * _e74);
                let _e215 = (trunc((_e203 * _e86)) * _e77);
                let _e216 = (trunc((_e207 * _e89)) * _e80);
                let _e217 = (_e214 - _e92);
                let _e218 = (_e215 - _e95);
                let _e219 = (_e216 - _e98);
                let _e226 = (_e217 * _e110);
                let _e227 = (_e218 * _e113);
                let _e228 = (_e219 * _e116);
                let _e235 = ((_e217 * _e119) + (((_e199 - _e214) - _e101) * _e168));
                let _e236 = ((_e218 * _e122) + (((_e203 - _e215) - _e104) * _e169));
                let _e237 = ((_e219 * _e125) + (((_e207 - _e216) - _e107) * _e170));
                let _e240 = trunc(((_e226 + _e235) * 4096f));
                let _e241 = (_e240 * 0.00024414063f);
                let _e243 = ((_e226 - _e241) + _e235);
                let _e246 = trunc(((_e227 + _e236) * 4096f));
                let _e247 = (_e246 * 0.00024414063f);
                let _e249 = ((_e227 - _e247) + _e236);
                let _e252 = trunc(((_e228 + _e237) * 4096f));
                let _e253 = (_e252 * 0.00024414063f);
                let _e255 = ((_e228 - _e253) + _e237);
                let _e256 = (_e64 * 4u);
                let _e259 = global_3.member.member_3;
                if (_e259 == 0u) {
                    let _e261 = (_e180 - _e241);
                    let _e262 = (_e182 - _e243);
                    let _e263 = (_e186 - _e247);
                    let _e264 = (_e188 - _e249);
                    let _e265 = (_e192 - _e253);
                    let _e266 = (_e194 - _e255);
                    let _e269 = global_3.member.member_2;
                    let _e271 = (_e261 + _e262);
                    let _e273 = (abs(_e271) < 0.000000000000000000000000000000000000011754944f);
                    if _e273 {
                        phi_510_ = type_18(1f, 0f);
                    } else {
                        phi_510_ = type_18(_e261, _e262);
                    }
                    let _e275 = phi_510_;
                    let _e276 = (_e240 * -0.00024414063f);
                    let _e277 = -(_e243);
                    let _e280 = (_e275.member + _e275.member_1);
                    let _e282 = ((_e276 + _e277) / _e280);
                    let _e284 = select(0f, _e282, (_e282 > 0f));
                    let _e286 = select(1f, _e284, (_e284 < 1f));
                    let _e289 = (trunc((_e286 * 1024f)) * 0.0009765625f);
                    let _e299 = select(0f, (((_e276 - (_e289 * _e275.member)) + (_e277 - (_e289 * _e275.member_1))) / _e280), select(false, (_e286 < 1f), (0f < _e286)));
                    let _e300 = (1f - _e241);
                    let _e302 = ((_e300 + _e277) / _e280);
                    let _e304 = select(0f, _e302, (_e302 > 0f));
                    let _e306 = select(1f, _e304, (_e304 < 1f));
                    let _e309 = (trunc((_e306 * 1024f)) * 0.0009765625f);
                    let _e319 = select(0f, (((_e300 - (_e309 * _e275.member)) + (_e277 - (_e309 * _e275.member_1))) / _e280), select(false, (_e306 < 1f), (0f < _e306)));
                    let _e320 = (_e241 + _e243);
                    if (_e320 >= 0f) {
                        let _e322 = (_e320 <= 1f);
                        if _e322 {
                            phi_539_ = type_18(0f, 0f);
                        } else {
                            phi_539_ = type_18();
                        }
                        let _e324 = phi_539_;
                        phi_541_ = _e324;
                        phi_542_ = select(true, false, _e322);
                    } else {
                        phi_541_ = type_18();
                        phi_542_ = true;
                    }
                    let _e327 = phi_541_;
                    let _e329 = phi_542_;
                    if _e329 {
                        phi_546_ = type_18(1f, 0f);
                        phi_547_ = type_18(0f, 0f);
                    } else {
                        phi_546_ = _e327;
                        phi_547_ = type_18(1f, 0f);
                    }
                    let _e331 = phi_546_;
                    let _e333 = phi_547_;
                    if _e273 {
                        phi_567_ = type_19(_e331, _e333);
                    } else {
                        let _e335 = (_e289 + _e299);
                        let _e336 = (_e309 + _e319);
                        if (_e335 < _e336) {
                            phi_558_ = type_18(_e289, _e299);
                        } else {
                            phi_558_ = type_18(_e309, _e319);
                        }
                        let _e341 = phi_558_;
                        if (_e335 > _e336) {
                            phi_565_ = type_18(_e289, _e299);
                        } else {
                            phi_565_ = type_18(_e309, _e319);
                        }
                        let _e346 = phi_565_;
                        phi_567_ = type_19(_e341, _e346);
                    }
                    let _e349 = phi_567_;
                    let _e359 = (_e263 + _e264);
                    let _e361 = (abs(_e359) < 0.000000000000000000000000000000000000011754944f);
                    if _e361 {
                        phi_578_ = type_18(1f, 0f);
                    } else {
                        phi_578_ = type_18(_e263, _e264);
                    }
                    let _e363 = phi_578_;
                    let _e364 = (_e246 * -0.00024414063f);
                    let _e365 = -(_e249);
                    let _e368 = (_e363.member + _e363.member_1);
                    let _e370 = ((_e364 + _e365) / _e368);
                    let _e372 = select(0f, _e370, (_e370 > 0f));
                    let _e374 = select(1f, _e372, (_e372 < 1f));
                    let _e377 = (trunc((_e374 * 1024f)) * 0.0009765625f);
                    let _e387 = select(0f, (((_e364 - (_e377 * _e363.member)) + (_e365 - (_e377 * _e363.member_1))) / _e368), select(false, (_e374 < 1f), (0f < _e374)));
                    let _e388 = (1f - _e247);
                    let _e390 = ((_e388 + _e365) / _e368);
                    let _e392 = select(0f, _e390, (_e390 > 0f));
                    let _e394 = select(1f, _e392, (_e392 < 1f));
                    let _e397 = (trunc((_e394 * 1024f)) * 0.0009765625f);
                    let _e407 = select(0f, (((_e388 - (_e397 * _e363.member)) + (_e365 - (_e397 * _e363.member_1))) / _e368), select(false, (_e394 < 1f), (0f < _e394)));
                    let _e408 = (_e247 + _e249);
                    if (_e408 >= 0f) {
                        let _e410 = (_e408 <= 1f);
                        if _e410 {
                            phi_607_ = type_18(0f, 0f);
                        } else {
                            phi_607_ = type_18();
                        }
                        let _e412 = phi_607_;
                        phi_609_ = _e412;
                        phi_610_ = select(true, false, _e410);
                    } else {
                        phi_609_ = type_18();
                        phi_610_ = true;
                    }
                    let _e415 = phi_609_;
                    let _e417 = phi_610_;
                    if _e417 {
                        phi_614_ = type_18(1f, 0f);
                        phi_615_ = type_18(0f, 0f);
                    } else {
                        phi_614_ = _e415;
                        phi_615_ = type_18(1f, 0f);
                    }
                    let _e419 = phi_614_;
                    let _e421 = phi_615_;
                    if _e361 {
                        phi_635_ = type_19(_e419, _e421);
                    } else {
                        let _e423 = (_e377 + _e387);
                        let _e424 = (_e397 + _e407);
                        if (_e423 < _e424) {
                            phi_626_ = type_18(_e377, _e387);
                        } else {
                            phi_626_ = type_18(_e397, _e407);
                        }
                        let _e429 = phi_626_;
                        if (_e423 > _e424) {
                            phi_633_ = type_18(_e377, _e387);
                        } else {
                            phi_633_ = type_18(_e397, _e407);
                        }
                        let _e434 = phi_633_;
                        phi_635_ = type_19(_e429, _e434);
                    }
                    let _e437 = phi_635_;
                    let _e447 = (_e265 + _e266);
                    let _e449 = (abs(_e447) < 0.000000000000000000000000000000000000011754944f);
                    if _e449 {
                        phi_646_ = type_18(1f, 0f);
                    } else {
                        phi_646_ = type_18(_e265, _e266);
                    }
                    let _e451 = phi_646_;
                    let _e452 = (_e252 * -0.00024414063f);
                    let _e453 = -(_e255);
                    let _e456 = (_e451.member + _e451.member_1);
                    let _e458 = ((_e452 + _e453) / _e456);
                    let _e460 = select(0f, _e458, (_e458 > 0f));
                    let _e462 = select(1f, _e460, (_e460 < 1f));
                    let _e465 = (trunc((_e462 * 1024f)) * 0.0009765625f);
                    let _e475 = select(0f, (((_e452 - (_e465 * _e451.member)) + (_e453 - (_e465 * _e451.member_1))) / _e456), select(false, (_e462 < 1f), (0f < _e462)));
                    let _e476 = (1f - _e253);
                    let _e478 = ((_e476 + _e453) / _e456);
                    let _e480 = select(0f, _e478, (_e478 > 0f));
                    let _e482 = select(1f, _e480, (_e480 < 1f));
                    let _e485 = (trunc((_e482 * 1024f)) * 0.0009765625f);
                    let _e495 = select(0f, (((_e476 - (_e485 * _e451.member)) + (_e453 - (_e485 * _e451.member_1))) / _e456), select(false, (_e482 < 1f), (0f < _e482)));
                    let _e496 = (_e253 + _e255);
                    if (_e496 >= 0f) {
                        let _e498 = (_e496 <= 1f);
                        if _e498 {
                            phi_675_ = type_18(0f, 0f);
                        } else {
                            phi_675_ = type_18();
                        }
                        let _e500 = phi_675_;
                        phi_677_ = _e500;
                        phi_678_ = select(true, false, _e498);
                    } else {
                        phi_677_ = type_18();
                        phi_678_ = true;
                    }
                    let _e503 = phi_677_;
                    let _e505 = phi_678_;
                    if _e505 {
                        phi_682_ = type_18(1f, 0f);
                        phi_683_ = type_18(0f, 0f);
                    } else {
                        phi_682_ = _e503;
                        phi_683_ = type_18(1f, 0f);
                    }
                    let _e507 = phi_682_;
                    let _e509 = phi_683_;
                    if _e449 {
                        phi_703_ = type_19(_e507, _e509);
                    } else {
                        let _e511 = (_e465 + _e475);
                        let _e512 = (_e485 + _e495);
                        if (_e511 < _e512) {
                            phi_694_ = type_18(_e465, _e475);
                        } else {
                            phi_694_ = type_18(_e485, _e495);
                        }
                        let _e517 = phi_694_;
                        if (_e511 > _e512) {
                            phi_701_ = type_18(_e465, _e475);
                        } else {
                            phi_701_ = type_18(_e485, _e495);
                        }
                        let _e522 = phi_701_;
                        phi_703_ = type_19(_e517, _e522);
                    }
                    let _e525 = phi_703_;
                    if ((_e349.member.member + _e349.member.member_1) > (_e437.member.member + _e437.member.member_1)) {
                        phi_714_ = _e349.member;
                    } else {
                        phi_714_ = _e437.member;
                    }
                    let _e540 = phi_714_;
                    if ((_e540.member + _e540.member_1) > (_e525.member.member + _e525.member.member_1)) {
                        phi_722_ = _e540;
                    } else {
                        phi_722_ = _e525.member;
                    }
                    let _e548 = phi_722_;
                    if ((_e349.member_1.member + _e349.member_1.member_1) < (_e437.member_1.member + _e437.member_1.member_1)) {
                        phi_731_ = _e349.member_1;
                    } else {
                        phi_731_ = _e437.member_1;
                    }
                    let _e557 = phi_731_;
                    if ((_e557.member + _e557.member_1) < (_e525.member_1.member + _e525.member_1.member_1)) {
                        phi_739_ = _e557;
                    } else {
                        phi_739_ = _e525.member_1;
                    }
                    let _e565 = phi_739_;
                    let _e568 = (_e565.member - _e548.member);
                    let _e569 = (_e565.member_1 - _e548.member_1);
                    if ((_e568 + _e569) > 0f) {
                        phi_747_ = type_18(_e568, _e569);
                    } else {
                        phi_747_ = type_18(0f, 0f);
                    }
                    let _e574 = phi_747_;
                    let _e579 = ((_e574.member * _e262) + (_e574.member_1 * _e271));
                    let _e580 = (_e574.member * _e261);
                    let _e584 = (trunc(((_e580 + _e579) * 4096f)) * 0.00024414063f);
                    let _e586 = ((_e580 - _e584) + _e579);
                    let _e589 = ((_e574.member * _e264) + (_e574.member_1 * _e359));
                    let _e590 = (_e574.member * _e263);
                    let _e594 = (trunc(((_e590 + _e589) * 4096f)) * 0.00024414063f);
                    let _e596 = ((_e590 - _e594) + _e589);
                    let _e599 = ((_e574.member * _e266) + (_e574.member_1 * _e447));
                    let _e600 = (_e574.member * _e265);
                    let _e604 = (trunc(((_e600 + _e599) * 4096f)) * 0.00024414063f);
                    let _e606 = ((_e600 - _e604) + _e599);
                    let _e607 = (_e584 + _e586);
                    let _e608 = (_e594 + _e596);
                    let _e609 = (_e604 + _e606);
                    let _e615 = sqrt((((_e607 * _e607) + (_e608 * _e608)) + (_e609 * _e609)));
                    let _e616 = (_e615 > 0f);
                    let _e618 = ceil((_e615 / _e269));
                    let _e620 = select(1f, _e618, (_e618 > 1f));
                    let _e622 = select(16384f, _e620, (_e620 < 16384f));
                    let _e626 = (_e243 + ((_e548.member * _e262) + (_e548.member_1 * _e271)));
                    let _e628 = (_e241 + (_e548.member * _e261));
                    let _e632 = (trunc(((_e628 + _e626) * 4096f)) * 0.00024414063f);
                    let _e638 = (_e249 + ((_e548.member * _e264) + (_e548.member_1 * _e359)));
                    let _e640 = (_e247 + (_e548.member * _e263));
                    let _e644 = (trunc(((_e640 + _e638) * 4096f)) * 0.00024414063f);
                    let _e650 = (_e255 + ((_e548.member * _e266) + (_e548.member_1 * _e447)));
                    let _e652 = (_e253 + (_e548.member * _e265));
                    let _e656 = (trunc(((_e652 + _e650) * 4096f)) * 0.00024414063f);
                    if _e616 {
                        phi_771_ = select(select(u32(_e622), 0u, (_e622 < 0f)), 4294967295u, (_e622 > 4294967000f));
                    } else {
                        phi_771_ = 0u;
                    }
                    let _e665 = phi_771_;
                    if _e616 {
                        phi_775_ = ((_e615 / _e622) / _e269);
                    } else {
                        phi_775_ = 0f;
                    }
                    let _e669 = phi_775_;
                    global_8.member[_e256] = vec4<f32>(_e632, _e644, _e656, _e669);
                    global_8.member[(_e256 + 1u)] = vec4<f32>(_e584, _e594, _e604, 0f);
                    global_8.member[(_e256 + 2u)] = vec4<f32>(((_e628 - _e632) + _e626), ((_e640 - _e644) + _e638), ((_e652 - _e656) + _e650), 0f);
                    global_8.member[(_e256 + 3u)] = vec4<f32>(_e586, _e596, _e606, 0f);
                    global_9.member[_e64] = _e665;
                } else {
                    let _e688 = ((_e241 - 0.5f) + _e243);
                    let _e690 = ((_e247 - 0.5f) + _e249);
                    let _e692 = ((_e253 - 0.5f) + _e255);
                    let _e694 = ((_e180 - 0.5f) + _e182);
                    let _e696 = ((_e186 - 0.5f) + _e188);
                    let _e698 = ((_e192 - 0.5f) + _e194);
                    let _e701 = global_3.member.member_2;
                    let _e703 = select(-1000000000000000f, _e688, (_e688 > -1000000000000000f));
                    let _e707 = select(-1000000000000000f, _e690, (_e690 > -1000000000000000f));
                    let _e711 = select(-1000000000000000f, _e692, (_e692 > -1000000000000000f));
                    let _e715 = select(-1000000000000000f, _e694, (_e694 > -1000000000000000f));
                    let _e717 = select(1000000000000000f, _e715, (_e715 < 1000000000000000f));
                    let _e719 = select(-1000000000000000f, _e696, (_e696 > -1000000000000000f));
                    let _e721 = select(1000000000000000f, _e719, (_e719 < 1000000000000000f));
                    let _e723 = select(-1000000000000000f, _e698, (_e698 > -1000000000000000f));
                    let _e725 = select(1000000000000000f, _e723, (_e723 < 1000000000000000f));
                    let _e726 = (_e717 - select(1000000000000000f, _e703, (_e703 < 1000000000000000f)));
                    let _e727 = (_e721 - select(1000000000000000f, _e707, (_e707 < 1000000000000000f)));
                    let _e728 = (_e725 - select(1000000000000000f, _e711, (_e711 < 1000000000000000f)));
                    let _e734 = sqrt((((_e726 * _e726) + (_e727 * _e727)) + (_e728 * _e728)));
                    let _e737 = (1f / select(0.00000000000000000010842022f, _e734, (_e734 > 0.00000000000000000010842022f)));
                    let _e738 = (_e726 * _e737);
                    let _e739 = (_e727 * _e737);
                    let _e740 = (_e728 * _e737);
                    let _e745 = (((_e717 * _e738) + (_e721 * _e739)) + (_e725 * _e740));
                    let _e749 = (_e717 - (_e738 * _e745));
                    let _e750 = (_e721 - (_e739 * _e745));
                    let _e751 = (_e725 - (_e740 * _e745));
                    let _e757 = sqrt((((_e749 * _e749) + (_e750 * _e750)) + (_e751 * _e751)));
                    let _e759 = select(0.4330127f, _e757, (_e757 > 0.4330127f));
                    let _e760 = (_e745 - _e734);
                    let _e761 = abs(_e760);
                    let _e766 = (_e759 * (2f - (_e759 / select(_e759, _e761, (_e761 > _e759)))));
                    if (_e761 <= _e759) {
                        phi_832_ = _e760;
                    } else {
                        if (_e760 < 0f) {
                            phi_831_ = -(_e766);
                        } else {
                            phi_831_ = _e766;
                        }
                        let _e771 = phi_831_;
                        phi_832_ = _e771;
                    }
                    let _e773 = phi_832_;
                    let _e774 = abs(_e745);
                    let _e779 = (_e759 * (2f - (_e759 / select(_e759, _e774, (_e774 > _e759)))));
                    if (_e774 <= _e759) {
                        phi_845_ = _e745;
                    } else {
                        if (_e745 < 0f) {
                            phi_844_ = -(_e779);
                        } else {
                            phi_844_ = _e779;
                        }
                        let _e784 = phi_844_;
                        phi_845_ = _e784;
                    }
                    let _e786 = phi_845_;
                    let _e787 = (_e786 - _e773);
                    let _e789 = ((0.4330127f / _e759) * _e787);
                    let _e790 = (_e789 > 0f);
                    let _e792 = ceil((_e789 / _e701));
                    let _e794 = select(1f, _e792, (_e792 > 1f));
                    let _e796 = select(16384f, _e794, (_e794 < 16384f));
                    if _e790 {
                        phi_860_ = select(select(u32(_e796), 0u, (_e796 < 0f)), 4294967295u, (_e796 > 4294967000f));
                    } else {
                        phi_860_ = 0u;
                    }
                    let _e803 = phi_860_;
                    if _e790 {
                        phi_864_ = ((_e789 / _e796) / _e701);
                    } else {
                        phi_864_ = 0f;
                    }
                    let _e807 = phi_864_;
                    global_8.member[_e256] = vec4<f32>(_e749, _e750, _e751, _e807);
                    global_8.member[(_e256 + 1u)] = vec4<f32>(_e738, _e739, _e740, _e759);
                    global_8.member[(_e256 + 2u)] = vec4<f32>(_e773, _e787, 0f, 0f);
                    global_8.member[(_e256 + 3u)] = vec4<f32>(0f, 0f, 0f, 0f);
                    global_9.member[_e64] = _e803;
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
