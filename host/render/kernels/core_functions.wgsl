struct type_14 {
    member: u32,
}

struct type_15 {
    member: type_14,
}

struct type_19 {
    member: array<u32>,
}

struct type_23 {
    member: array<f32>,
}

struct type_26 {
    member: u32,
    member_1: u32,
}

struct type_27 {
    member: i32,
    member_1: bool,
}

struct type_28 {
    member: u32,
    member_1: i32,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
var<workgroup> global_3: array<bool, 64>;
@group(0) @binding(0) 
var<uniform> global_4: type_15;
@group(0) @binding(1) 
var<storage> global_5: type_19;
@group(0) @binding(2) 
var<storage> global_6: type_19;
@group(0) @binding(3) 
var<storage> global_7: type_23;
@group(0) @binding(4) 
var<storage> global_8: type_23;
@group(0) @binding(5) 
var<storage, read_write> global_9: type_19;

fn function_() {
    var local: array<u32, 4>;
    var local_1: array<u32, 3>;
    var local_2: array<u32, 4>;
    var local_3: u32 = 2139095040u;
    var local_4: u32 = 4286578688u;
    var local_5: u32 = 2143289344u;
    var phi_274_: type_26;
    var phi_289_: u32;
    var phi_303_: u32;
    var phi_314_: u32;
    var phi_331_: type_26;
    var phi_345_: type_26;
    var phi_359_: type_26;
    var phi_372_: type_26;
    var phi_386_: type_26;
    var phi_452_: u32;
    var phi_459_: u32;
    var phi_467_: bool;
    var phi_468_: u32;
    var phi_470_: bool;
    var phi_471_: u32;
    var phi_473_: bool;
    var phi_474_: u32;
    var phi_475_: bool;
    var phi_522_: i32;
    var phi_529_: i32;
    var phi_542_: type_27;
    var phi_551_: type_28;
    var phi_567_: u32;
    var phi_577_: i32;
    var phi_585_: i32;
    var phi_605_: i32;
    var phi_613_: i32;
    var phi_631_: type_27;
    var phi_633_: bool;
    var phi_634_: i32;
    var phi_637_: bool;
    var phi_638_: u32;
    var phi_640_: bool;
    var phi_641_: u32;
    var phi_642_: bool;
    var phi_728_: f32;
    var phi_749_: bool;
    var phi_757_: bool;
    var phi_768_: bool;
    var phi_776_: bool;
    var phi_785_: u32;
    var phi_787_: u32;
    var phi_789_: u32;
    var phi_790_: bool;
    var phi_831_: u32;
    var phi_834_: f32;
    var phi_847_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_854_: u32;
    var phi_857_: u32;
    var phi_865_: u32;
    var phi_868_: u32;
    var phi_880_: u32;
    var phi_883_: u32;
    var phi_893_: u32;
    var phi_896_: u32;
    var phi_919_: bool;
    var phi_922_: u32;
    var phi_923_: bool;
    var phi_934_: u32;
    var phi_935_: bool;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_949_: u32;
    var phi_978_: bool;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_1004_: i32;
    var phi_1027_: type_26;
    var phi_1036_: type_26;
    var phi_1045_: type_26;
    var phi_1061_: type_26;
    var phi_1062_: type_26;
    var phi_1074_: type_26;
    var phi_1083_: u32;
    var phi_1091_: type_26;
    var phi_1102_: type_26;
    var phi_1116_: i32;
    var phi_1125_: i32;
    var phi_1140_: i32;
    var phi_1149_: bool;
    var phi_1150_: u32;
    var phi_1152_: u32;
    var phi_1154_: u32;
    var phi_1155_: bool;
    var phi_1188_: i32;
    var phi_1285_: i32;
    var phi_1287_: u32;
    var phi_1289_: u32;
    var phi_1290_: bool;
    var phi_1327_: u32;
    var phi_1330_: u32;
    var phi_1365_: u32;
    var phi_1374_: u32;
    var phi_1385_: i32;
    var phi_1397_: i32;
    var phi_1404_: u32;
    var phi_1410_: u32;
    var phi_1411_: u32;
    var phi_1412_: u32;
    var phi_1413_: u32;
    var phi_1414_: u32;
    var phi_1415_: u32;
    var local_9: u32;
    var local_10: f32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: u32;
    var local_20: u32;
    var local_21: u32;
    var local_22: u32;

    let _e119 = local_3;
    let _e120 = bitcast<f32>(_e119);
    let _e121 = local_4;
    let _e122 = bitcast<f32>(_e121);
    let _e123 = local_5;
    switch bitcast<i32>(0u) {
        default: {
            let _e126 = global;
            let _e127 = global_1;
            let _e128 = global_2;
            global_3[_e126.x] = ((_e126.x % 3u) == 0u);
            workgroupBarrier();
            let _e139 = (((_e127.x + (_e127.y * _e128.x)) * 64u) + _e126.x);
            let _e142 = global_4.member.member;
            if (_e139 >= (_e142 * 104u)) {
            } else {
                let _e145 = (_e142 == 0u);
                if _e145 {
                    break;
                }
                let _e146 = (_e139 / _e142);
                if (_e146 == 0u) {
                    let _e1228 = global_3[(_e126.x ^ 1u)];
                    global_9.member[_e139] = select(0u, 1u, _e1228);
                } else {
                    if _e145 {
                        break;
                    }
                    let _e148 = (_e139 % _e142);
                    let _e151 = global_5.member[_e148];
                    let _e154 = global_6.member[_e148];
                    let _e157 = global_7.member[_e148];
                    let _e160 = global_8.member[_e148];
                    if (1u <= _e146) {
                        let _e162 = (_e146 <= 34u);
                        if _e162 {
                            let _e163 = (_e154 % 32u);
                            switch bitcast<i32>(_e146) {
                                case 1: {
                                    phi_467_ = false;
                                    phi_468_ = select(_e151, _e154, (_e154 < _e151));
                                    break;
                                }
                                case 2: {
                                    phi_467_ = false;
                                    phi_468_ = select(_e154, _e151, (_e154 < _e151));
                                    break;
                                }
                                case 3: {
                                    if (_e151 < 5u) {
                                        phi_459_ = 5u;
                                    } else {
                                        phi_459_ = select(_e151, 1000u, (_e151 > 1000u));
                                    }
                                    let _e370 = phi_459_;
                                    phi_467_ = false;
                                    phi_468_ = _e370;
                                    break;
                                }
                                case 4: {
                                    if (_e151 < _e154) {
                                        phi_452_ = (_e154 - _e151);
                                    } else {
                                        phi_452_ = (_e151 - _e154);
                                    }
                                    let _e365 = phi_452_;
                                    phi_467_ = false;
                                    phi_468_ = _e365;
                                    break;
                                }
                                case 5: {
                                    phi_467_ = false;
                                    phi_468_ = (countOneBits(_e151) + (100u * countOneBits(~(_e151))));
                                    break;
                                }
                                case 6: {
                                    let _e350 = (_e151 == 0u);
                                    phi_467_ = false;
                                    phi_468_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e151)), 32u, _e350) + (100u * select(firstTrailingBit(_e151), 32u, _e350)));
                                    break;
                                }
                                case 7: {
                                    let _e337 = ~(_e151);
                                    let _e341 = (_e337 == 0u);
                                    phi_467_ = false;
                                    phi_468_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e337)), 32u, _e341) + (100u * select(firstTrailingBit(_e337), 32u, _e341)));
                                    break;
                                }
                                case 8: {
                                    let _e328 = (_e163 & 31u);
                                    phi_467_ = false;
                                    phi_468_ = select(((_e151 << bitcast<u32>(_e328)) | (_e151 >> bitcast<u32>((32u - _e328)))), _e151, (_e328 == 0u));
                                    break;
                                }
                                case 9: {
                                    let _e319 = (_e163 & 31u);
                                    phi_467_ = false;
                                    phi_468_ = select(((_e151 >> bitcast<u32>(_e319)) | (_e151 << bitcast<u32>((32u - _e319)))), _e151, (_e319 == 0u));
                                    break;
                                }
                                case 10: {
                                    phi_467_ = false;
                                    phi_468_ = (((_e151 >> bitcast<u32>(24u)) | ((_e151 >> bitcast<u32>(8u)) & 65280u)) | (((_e151 << bitcast<u32>(8u)) & 16711680u) | (_e151 << bitcast<u32>(24u))));
                                    break;
                                }
                                case 11: {
                                    phi_467_ = false;
                                    phi_468_ = reverseBits(_e151);
                                    break;
                                }
                                case 12: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 + _e154);
                                    break;
                                }
                                case 13: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 - _e154);
                                    break;
                                }
                                case 14: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 * _e154);
                                    break;
                                }
                                case 15: {
                                    phi_467_ = false;
                                    phi_468_ = (0u - _e151);
                                    break;
                                }
                                case 16: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 << bitcast<u32>((_e154 & 31u)));
                                    break;
                                }
                                case 17: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 >> bitcast<u32>((_e154 & 31u)));
                                    break;
                                }
                                case 18: {
                                    let _e281 = (_e151 + _e154);
                                    if select(false, true, (_e281 < _e151)) {
                                        phi_386_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_386_ = type_26(1u, _e281);
                                    }
                                    let _e289 = phi_386_;
                                    phi_467_ = false;
                                    phi_468_ = select(77u, _e289.member_1, (bitcast<i32>(_e289.member) != 0i));
                                    break;
                                }
                                case 19: {
                                    if (_e151 < _e154) {
                                        phi_372_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_372_ = type_26(1u, (_e151 - _e154));
                                    }
                                    let _e275 = phi_372_;
                                    phi_467_ = false;
                                    phi_468_ = select(77u, _e275.member_1, (bitcast<i32>(_e275.member) != 0i));
                                    break;
                                }
                                case 20: {
                                    if select(false, true, (_e154 == 0u)) {
                                        phi_359_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_359_ = type_26(1u, (_e151 / _e154));
                                    }
                                    let _e262 = phi_359_;
                                    phi_467_ = false;
                                    phi_468_ = select(77u, _e262.member_1, (bitcast<i32>(_e262.member) != 0i));
                                    break;
                                }
                                case 21: {
                                    if select(false, true, (_e154 == 0u)) {
                                        phi_345_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_345_ = type_26(1u, (_e151 % _e154));
                                    }
                                    let _e248 = phi_345_;
                                    phi_467_ = false;
                                    phi_468_ = select(77u, _e248.member_1, (bitcast<i32>(_e248.member) != 0i));
                                    break;
                                }
                                case 22: {
                                    let _e225 = (_e154 % 64u);
                                    if (_e225 < 32u) {
                                        phi_331_ = type_26(1u, (_e151 << bitcast<u32>(_e225)));
                                    } else {
                                        phi_331_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e234 = phi_331_;
                                    phi_467_ = false;
                                    phi_468_ = select(77u, _e234.member_1, (bitcast<i32>(_e234.member) != 0i));
                                    break;
                                }
                                case 23: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 + _e154);
                                    break;
                                }
                                case 24: {
                                    phi_467_ = false;
                                    phi_468_ = select(0u, 1u, ((_e151 - _e154) > _e151));
                                    break;
                                }
                                case 25: {
                                    phi_467_ = false;
                                    phi_468_ = select(0u, 1u, (countOneBits(_e151) == 1u));
                                    break;
                                }
                                case 26: {
                                    let _e206 = (_e151 % 1000u);
                                    if (_e206 <= 1u) {
                                        phi_314_ = 0u;
                                    } else {
                                        phi_314_ = (4294967295u >> bitcast<u32>(((bitcast<u32>(31i) - firstLeadingBit((_e206 - 1u))) & 31u)));
                                    }
                                    let _e216 = phi_314_;
                                    phi_467_ = false;
                                    phi_468_ = (_e216 + 1u);
                                    break;
                                }
                                case 27: {
                                    let _e198 = (_e154 | 1u);
                                    let _e199 = (_e198 == 0u);
                                    if _e199 {
                                        phi_467_ = true;
                                        phi_468_ = u32();
                                        break;
                                    }
                                    let _e200 = (_e151 / _e198);
                                    if _e199 {
                                        phi_467_ = true;
                                        phi_468_ = u32();
                                        break;
                                    }
                                    if ((_e151 % _e198) > 0u) {
                                        phi_303_ = (_e200 + 1u);
                                    } else {
                                        phi_303_ = _e200;
                                    }
                                    let _e205 = phi_303_;
                                    phi_467_ = false;
                                    phi_468_ = _e205;
                                    break;
                                }
                                case 28: {
                                    let _e191 = (_e151 % 1000u);
                                    let _e192 = (_e191 % 7u);
                                    if (_e192 == 0u) {
                                        phi_289_ = _e191;
                                    } else {
                                        phi_289_ = (_e191 + (7u - _e192));
                                    }
                                    let _e197 = phi_289_;
                                    phi_467_ = false;
                                    phi_468_ = _e197;
                                    break;
                                }
                                case 29: {
                                    let _e176 = (_e151 | 1u);
                                    if (select(1i, 0i, (_e176 == 0u)) != 0i) {
                                        phi_274_ = type_26(1u, firstLeadingBit(_e176));
                                    } else {
                                        phi_274_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e186 = phi_274_;
                                    if (bitcast<i32>(_e186.member) != 0i) {
                                    } else {
                                        phi_467_ = true;
                                        phi_468_ = u32();
                                        break;
                                    }
                                    phi_467_ = false;
                                    phi_468_ = _e186.member_1;
                                    break;
                                }
                                case 30: {
                                    phi_467_ = false;
                                    phi_468_ = bitcast<u32>(bitcast<i32>(_e151));
                                    break;
                                }
                                case 31: {
                                    let _e171 = (_e154 | 1u);
                                    if (_e171 == 0u) {
                                        phi_467_ = true;
                                        phi_468_ = u32();
                                        break;
                                    }
                                    phi_467_ = false;
                                    phi_468_ = (_e151 % _e171);
                                    break;
                                }
                                case 32: {
                                    let _e168 = (_e154 | 1u);
                                    if (_e168 == 0u) {
                                        phi_467_ = true;
                                        phi_468_ = u32();
                                        break;
                                    }
                                    phi_467_ = false;
                                    phi_468_ = (_e151 / _e168);
                                    break;
                                }
                                case 33: {
                                    phi_467_ = false;
                                    phi_468_ = select(0u, 1u, ((_e151 % 3u) == 0u));
                                    break;
                                }
                                default: {
                                    phi_467_ = false;
                                    phi_468_ = (_e151 + bitcast<u32>(bitcast<i32>(_e154)));
                                    break;
                                }
                            }
                            let _e379 = phi_467_;
                            let _e381 = phi_468_;
                            if _e379 {
                                break;
                            }
                            phi_470_ = _e379;
                            phi_471_ = _e381;
                        } else {
                            phi_470_ = false;
                            phi_471_ = u32();
                        }
                        let _e383 = phi_470_;
                        let _e385 = phi_471_;
                        phi_473_ = _e383;
                        phi_474_ = _e385;
                        phi_475_ = select(true, false, _e162);
                    } else {
                        phi_473_ = false;
                        phi_474_ = u32();
                        phi_475_ = true;
                    }
                    let _e388 = phi_473_;
                    let _e390 = phi_474_;
                    let _e392 = phi_475_;
                    if _e392 {
                        if (35u <= _e146) {
                            let _e394 = (_e146 <= 49u);
                            if _e394 {
                                let _e395 = bitcast<i32>(_e151);
                                let _e396 = bitcast<i32>(_e154);
                                switch bitcast<i32>(_e146) {
                                    case 35: {
                                        if (_e395 < 0i) {
                                            phi_613_ = (0i - _e395);
                                        } else {
                                            phi_613_ = _e395;
                                        }
                                        let _e494 = phi_613_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e494;
                                        break;
                                    }
                                    case 36: {
                                        if (_e395 < 0i) {
                                            phi_605_ = (0i - _e395);
                                        } else {
                                            phi_605_ = _e395;
                                        }
                                        let _e488 = phi_605_;
                                        phi_633_ = _e388;
                                        phi_634_ = bitcast<i32>(bitcast<u32>(_e488));
                                        break;
                                    }
                                    case 37: {
                                        phi_633_ = _e388;
                                        phi_634_ = bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e395 != 0i)), 255i, (_e395 < 0i))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                        break;
                                    }
                                    case 38: {
                                        phi_633_ = _e388;
                                        phi_634_ = (select(0i, 1i, (_e395 < 0i)) + (2i * select(0i, 1i, (_e395 > 0i))));
                                        break;
                                    }
                                    case 39: {
                                        let _e464 = ((_e395 % 1000i) % 7i);
                                        if (_e464 < 0i) {
                                            phi_585_ = (_e464 + 7i);
                                        } else {
                                            phi_585_ = _e464;
                                        }
                                        let _e468 = phi_585_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e468;
                                        break;
                                    }
                                    case 40: {
                                        let _e456 = (_e395 % 1000i);
                                        let _e457 = (_e456 / 7i);
                                        if ((_e456 % 7i) < 0i) {
                                            phi_577_ = (_e457 - 1i);
                                        } else {
                                            phi_577_ = _e457;
                                        }
                                        let _e462 = phi_577_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e462;
                                        break;
                                    }
                                    case 41: {
                                        if (_e395 < _e396) {
                                            phi_567_ = (bitcast<u32>(_e396) - bitcast<u32>(_e395));
                                        } else {
                                            phi_567_ = (bitcast<u32>(_e395) - bitcast<u32>(_e396));
                                        }
                                        let _e454 = phi_567_;
                                        phi_633_ = _e388;
                                        phi_634_ = bitcast<i32>(_e454);
                                        break;
                                    }
                                    case 42: {
                                        if select(false, true, (_e395 == i32(-2147483648))) {
                                            phi_542_ = type_27(i32(-2147483648), true);
                                        } else {
                                            phi_542_ = type_27(-(_e395), false);
                                        }
                                        let _e431 = phi_542_;
                                        if select(false, true, _e431.member_1) {
                                            phi_551_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_551_ = type_28(1u, _e431.member);
                                        }
                                        let _e440 = phi_551_;
                                        phi_633_ = _e388;
                                        phi_634_ = select(77i, _e440.member_1, (bitcast<i32>(_e440.member) != 0i));
                                        break;
                                    }
                                    case 43: {
                                        phi_633_ = _e388;
                                        phi_634_ = (0i - _e395);
                                        break;
                                    }
                                    case 44: {
                                        let _e421 = (_e396 < _e395);
                                        phi_633_ = _e388;
                                        phi_634_ = (select(_e395, _e396, _e421) ^ select(_e396, _e395, _e421));
                                        break;
                                    }
                                    case 45: {
                                        if (_e395 < -100i) {
                                            phi_529_ = -100i;
                                        } else {
                                            phi_529_ = select(_e395, 100i, (_e395 > 100i));
                                        }
                                        let _e420 = phi_529_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e420;
                                        break;
                                    }
                                    case 46: {
                                        let _e411 = (_e395 % 1000i);
                                        if (_e411 < 0i) {
                                            phi_522_ = -(_e411);
                                        } else {
                                            phi_522_ = _e411;
                                        }
                                        let _e415 = phi_522_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e415;
                                        break;
                                    }
                                    case 47: {
                                        phi_633_ = _e388;
                                        phi_634_ = (_e395 >> bitcast<u32>(((_e396 & 31i) & 31i)));
                                        break;
                                    }
                                    case 48: {
                                        let _e398 = bitcast<u32>(_e395);
                                        phi_633_ = _e388;
                                        phi_634_ = bitcast<i32>((select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u)) + countOneBits(_e398)));
                                        break;
                                    }
                                    default: {
                                        let _e495 = (_e396 | 1i);
                                        let _e496 = (_e495 == -1i);
                                        if select(false, true, _e496) {
                                            phi_631_ = type_27(0i, (_e395 == i32(-2147483648)));
                                        } else {
                                            if (_e495 == 0i) {
                                                phi_633_ = true;
                                                phi_634_ = i32();
                                                break;
                                            }
                                            if (_e496 && (_e395 == i32(-2147483648))) {
                                                phi_633_ = true;
                                                phi_634_ = i32();
                                                break;
                                            }
                                            phi_631_ = type_27((_e395 % _e495), false);
                                        }
                                        let _e506 = phi_631_;
                                        phi_633_ = _e388;
                                        phi_634_ = _e506.member;
                                        break;
                                    }
                                }
                                let _e509 = phi_633_;
                                let _e511 = phi_634_;
                                if _e509 {
                                    break;
                                }
                                phi_637_ = _e509;
                                phi_638_ = bitcast<u32>(_e511);
                            } else {
                                phi_637_ = _e388;
                                phi_638_ = u32();
                            }
                            let _e514 = phi_637_;
                            let _e516 = phi_638_;
                            phi_640_ = _e514;
                            phi_641_ = _e516;
                            phi_642_ = select(true, false, _e394);
                        } else {
                            phi_640_ = _e388;
                            phi_641_ = u32();
                            phi_642_ = true;
                        }
                        let _e519 = phi_640_;
                        let _e521 = phi_641_;
                        let _e523 = phi_642_;
                        if _e523 {
                            if (50u <= _e146) {
                                let _e525 = (_e146 <= 62u);
                                if _e525 {
                                    switch bitcast<i32>(_e146) {
                                        case 50: {
                                            let _e627 = (_e157 != _e157);
                                            if _e627 {
                                                phi_768_ = true;
                                            } else {
                                                phi_768_ = (_e160 <= _e157);
                                            }
                                            let _e630 = phi_768_;
                                            if _e627 {
                                                phi_776_ = true;
                                            } else {
                                                phi_776_ = (_e160 <= _e157);
                                            }
                                            let _e636 = phi_776_;
                                            phi_785_ = (bitcast<u32>(abs(select(_e157, _e160, _e630))) | (select(0u, 1u, (select(_e157, _e160, _e636) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 51: {
                                            let _e611 = (_e157 != _e157);
                                            if _e611 {
                                                phi_749_ = true;
                                            } else {
                                                phi_749_ = (_e160 >= _e157);
                                            }
                                            let _e614 = phi_749_;
                                            if _e611 {
                                                phi_757_ = true;
                                            } else {
                                                phi_757_ = (_e160 >= _e157);
                                            }
                                            let _e620 = phi_757_;
                                            phi_785_ = (bitcast<u32>(abs(select(_e157, _e160, _e614))) | (select(0u, 1u, (select(_e157, _e160, _e620) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 52: {
                                            phi_785_ = bitcast<u32>(abs(_e157));
                                            break;
                                        }
                                        case 53: {
                                            let _e605 = select(_e157, -1f, (_e157 < -1f));
                                            phi_785_ = bitcast<u32>(select(_e605, 1f, (_e605 > 1f)));
                                            break;
                                        }
                                        case 54: {
                                            phi_785_ = bitcast<u32>(bitcast<f32>(((bitcast<u32>(_e157) & 2147483647u) | (bitcast<u32>(_e160) & 2147483648u))));
                                            break;
                                        }
                                        case 55: {
                                            if (_e157 != _e157) {
                                                phi_728_ = bitcast<f32>(_e123);
                                            } else {
                                                phi_728_ = bitcast<f32>((1065353216u | (bitcast<u32>(_e157) & 2147483648u)));
                                            }
                                            let _e595 = phi_728_;
                                            phi_785_ = bitcast<u32>(_e595);
                                            break;
                                        }
                                        case 56: {
                                            phi_785_ = (select(0u, 1u, (abs(_e157) < _e120)) + (4u * select(0u, 1u, ((_e157 == _e120) || (_e157 == _e122)))));
                                            break;
                                        }
                                        case 57: {
                                            let _e574 = ((bitcast<u32>(_e157) & 2147483648u) != 0u);
                                            phi_785_ = (select(0u, 1u, _e574) + (2u * select(0u, 1u, !(_e574))));
                                            break;
                                        }
                                        case 58: {
                                            let _e544 = bitcast<i32>(bitcast<u32>(_e157));
                                            let _e546 = bitcast<i32>(bitcast<u32>(_e160));
                                            let _e553 = (_e544 ^ bitcast<i32>((bitcast<u32>((_e544 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            let _e560 = (_e546 ^ bitcast<i32>((bitcast<u32>((_e546 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            phi_785_ = bitcast<u32>(bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e553 != _e560)), 255i, (_e553 < _e560))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))));
                                            break;
                                        }
                                        case 59: {
                                            let _e538 = trunc(_e157);
                                            phi_785_ = bitcast<u32>(select(_e538, (_e538 - 1f), (_e157 < _e538)));
                                            break;
                                        }
                                        case 60: {
                                            let _e529 = trunc(_e157);
                                            let _e530 = (_e157 - _e529);
                                            phi_785_ = bitcast<u32>(select(select(_e529, (_e529 + 1f), (0.5f <= _e530)), (_e529 - 1f), (_e530 <= -0.5f)));
                                            break;
                                        }
                                        case 61: {
                                            phi_785_ = bitcast<u32>(trunc(_e157));
                                            break;
                                        }
                                        default: {
                                            phi_785_ = bitcast<u32>(select(_e160, _e120, (_e157 > _e160)));
                                            break;
                                        }
                                    }
                                    let _e647 = phi_785_;
                                    if _e519 {
                                        break;
                                    }
                                    phi_787_ = _e647;
                                } else {
                                    phi_787_ = u32();
                                }
                                let _e649 = phi_787_;
                                phi_789_ = _e649;
                                phi_790_ = select(true, false, _e525);
                            } else {
                                phi_789_ = u32();
                                phi_790_ = true;
                            }
                            let _e652 = phi_789_;
                            let _e654 = phi_790_;
                            if _e654 {
                                if (63u <= _e146) {
                                    let _e656 = (_e146 <= 83u);
                                    if _e656 {
                                        local[0u] = (_e151 % 100u);
                                        local[1u] = (_e154 % 100u);
                                        local[2u] = 7u;
                                        local[3u] = 3u;
                                        switch bitcast<i32>(_e146) {
                                            case 63: {
                                                if (_e151 > _e154) {
                                                    phi_1102_ = type_26(1u, 5u);
                                                } else {
                                                    phi_1102_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e908 = phi_1102_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = select(6u, _e908.member_1, (bitcast<i32>(_e908.member) != 0i));
                                                break;
                                            }
                                            case 64: {
                                                if (_e151 > _e154) {
                                                    phi_1091_ = type_26(1u, (_e151 - _e154));
                                                } else {
                                                    phi_1091_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e897 = phi_1091_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = select(6u, _e897.member_1, (bitcast<i32>(_e897.member) != 0i));
                                                break;
                                            }
                                            case 65: {
                                                if (_e151 > _e154) {
                                                    phi_1074_ = type_26(1u, _e151);
                                                } else {
                                                    phi_1074_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e882 = phi_1074_;
                                                if (bitcast<i32>(_e882.member) != 0i) {
                                                    phi_1083_ = (_e882.member_1 - _e154);
                                                } else {
                                                    phi_1083_ = 3u;
                                                }
                                                let _e889 = phi_1083_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e889;
                                                break;
                                            }
                                            case 66: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = (_e151 ^ _e154);
                                                break;
                                            }
                                            case 67: {
                                                if (_e151 < _e154) {
                                                    phi_1045_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1045_ = type_26(1u, (_e151 - _e154));
                                                }
                                                let _e853 = phi_1045_;
                                                if (bitcast<i32>(_e853.member) != 0i) {
                                                    if (_e853.member_1 < 10u) {
                                                        phi_1061_ = type_26(0u, type_26().member_1);
                                                    } else {
                                                        phi_1061_ = type_26(1u, (_e853.member_1 - 10u));
                                                    }
                                                    let _e868 = phi_1061_;
                                                    phi_1062_ = _e868;
                                                } else {
                                                    phi_1062_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e870 = phi_1062_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = select(0u, 1u, (bitcast<i32>(_e870.member) == 1i));
                                                break;
                                            }
                                            case 68: {
                                                if (_e151 < _e154) {
                                                    phi_1027_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1027_ = type_26(1u, (_e151 - _e154));
                                                }
                                                let _e837 = phi_1027_;
                                                if (bitcast<i32>(_e837.member) != 0i) {
                                                    phi_1036_ = type_26(0u, _e837.member_1);
                                                } else {
                                                    phi_1036_ = type_26(1u, 4u);
                                                }
                                                let _e844 = phi_1036_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e844.member_1;
                                                break;
                                            }
                                            case 69: {
                                                let _e806 = select(select(0i, 1i, (_e151 != _e154)), 255i, (_e151 < _e154));
                                                switch _e806 {
                                                    case 255: {
                                                        phi_1004_ = 1i;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_1004_ = 0i;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1004_ = 255i;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1004_ = i32();
                                                        break;
                                                    }
                                                }
                                                let _e808 = phi_1004_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e808) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (5i * select(0i, 1i, (((bitcast<i32>(_e806) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>(0i) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))))));
                                                break;
                                            }
                                            case 70: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = (_e154 - (_e151 * 2u));
                                                break;
                                            }
                                            case 71: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = (_e151 + (_e154 * 3u));
                                                break;
                                            }
                                            case 72: {
                                                let _e793 = local[0u];
                                                let _e794 = local[1u];
                                                let _e795 = local[2u];
                                                phi_1149_ = _e519;
                                                phi_1150_ = ((_e793 + (1000u * _e794)) + _e795);
                                                break;
                                            }
                                            case 73: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = ((_e154 + _e151) * (1u + _e151));
                                                break;
                                            }
                                            case 74: {
                                                if select(true, false, (_e151 <= 9u)) {
                                                    if ((_e151 % 2u) == 0u) {
                                                        phi_980_ = 2u;
                                                    } else {
                                                        switch bitcast<i32>(_e151) {
                                                            case 11: {
                                                                phi_978_ = true;
                                                                break;
                                                            }
                                                            case 13: {
                                                                phi_978_ = true;
                                                                break;
                                                            }
                                                            case 15: {
                                                                phi_978_ = true;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_978_ = false;
                                                                break;
                                                            }
                                                        }
                                                        let _e784 = phi_978_;
                                                        phi_980_ = select(4u, 3u, _e784);
                                                    }
                                                    let _e787 = phi_980_;
                                                    phi_981_ = _e787;
                                                } else {
                                                    phi_981_ = 1u;
                                                }
                                                let _e789 = phi_981_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e789;
                                                break;
                                            }
                                            case 75: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = select(0u, (_e151 / 3u), ((_e151 % 3u) == 1u));
                                                break;
                                            }
                                            case 76: {
                                                phi_1149_ = _e519;
                                                phi_1150_ = (select(0u, 1u, (_e151 > _e154)) + 1u);
                                                break;
                                            }
                                            case 77: {
                                                let _e767 = (_e154 % 4u);
                                                if (_e767 < 4u) {
                                                } else {
                                                    phi_1149_ = true;
                                                    phi_1150_ = u32();
                                                    break;
                                                }
                                                let _e770 = local[_e767];
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e770;
                                                break;
                                            }
                                            case 78: {
                                                switch select(select(0i, 1i, (_e151 != _e154)), 255i, (_e151 < _e154)) {
                                                    case 255: {
                                                        phi_949_ = 10u;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_949_ = 20u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_949_ = 30u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_949_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e766 = phi_949_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e766;
                                                break;
                                            }
                                            case 79: {
                                                if (_e151 < 3u) {
                                                    phi_939_ = 100u;
                                                } else {
                                                    if ((_e151 % 2u) == 0u) {
                                                        let _e737 = ((_e151 % 3u) == 0u);
                                                        if _e737 {
                                                            phi_919_ = true;
                                                        } else {
                                                            phi_919_ = (_e151 > 20u);
                                                        }
                                                        let _e740 = phi_919_;
                                                        phi_922_ = select(2000u, 6u, _e737);
                                                        phi_923_ = select(true, false, _e740);
                                                    } else {
                                                        phi_922_ = u32();
                                                        phi_923_ = true;
                                                    }
                                                    let _e744 = phi_922_;
                                                    let _e746 = phi_923_;
                                                    if _e746 {
                                                        switch bitcast<i32>((_e151 % 7u)) {
                                                            case 0: {
                                                                phi_934_ = 7u;
                                                                phi_935_ = false;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_934_ = 77u;
                                                                phi_935_ = select(true, false, (_e151 > 30u));
                                                                break;
                                                            }
                                                            default: {
                                                                phi_934_ = u32();
                                                                phi_935_ = true;
                                                                break;
                                                            }
                                                        }
                                                        let _e752 = phi_934_;
                                                        let _e754 = phi_935_;
                                                        phi_938_ = select(_e151, _e752, select(true, false, _e754));
                                                    } else {
                                                        phi_938_ = _e744;
                                                    }
                                                    let _e758 = phi_938_;
                                                    phi_939_ = _e758;
                                                }
                                                let _e760 = phi_939_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = _e760;
                                                break;
                                            }
                                            case 80: {
                                                local_1[0u] = 1u;
                                                local_1[1u] = 10u;
                                                local_1[2u] = 100u;
                                                phi_880_ = 0u;
                                                phi_883_ = 0u;
                                                loop {
                                                    let _e712 = phi_880_;
                                                    let _e714 = phi_883_;
                                                    local_19 = _e714;
                                                    if (_e712 < 3u) {
                                                        let _e717 = local_1[_e712];
                                                        let _e719 = local[0u];
                                                        local_16 = (_e712 + 1u);
                                                        local_17 = (_e714 + (_e719 * _e717));
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1302 = local_16;
                                                        phi_880_ = _e1302;
                                                        let _e1305 = local_17;
                                                        phi_883_ = _e1305;
                                                    }
                                                }
                                                let _e722 = local;
                                                local_2 = _e722;
                                                phi_893_ = 0u;
                                                let _e1311 = local_19;
                                                phi_896_ = _e1311;
                                                loop {
                                                    let _e724 = phi_893_;
                                                    let _e726 = phi_896_;
                                                    local_21 = _e726;
                                                    if (_e724 < 4u) {
                                                        let _e729 = local_2[_e724];
                                                        local_18 = (_e724 + 1u);
                                                        local_20 = ((_e726 * 3u) + _e729);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1308 = local_18;
                                                        phi_893_ = _e1308;
                                                        let _e1313 = local_20;
                                                        phi_896_ = _e1313;
                                                    }
                                                }
                                                phi_1149_ = _e519;
                                                let _e1341 = local_21;
                                                phi_1150_ = _e1341;
                                                break;
                                            }
                                            case 81: {
                                                phi_854_ = 0u;
                                                phi_857_ = 0u;
                                                loop {
                                                    let _e690 = phi_854_;
                                                    let _e692 = phi_857_;
                                                    local_13 = _e690;
                                                    if (_e692 < 4u) {
                                                        let _e696 = local[_e692];
                                                        local_11 = (_e690 + _e696);
                                                        local_12 = (_e692 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1288 = local_11;
                                                        phi_854_ = _e1288;
                                                        let _e1291 = local_12;
                                                        phi_857_ = _e1291;
                                                    }
                                                }
                                                let _e1294 = local_13;
                                                phi_865_ = _e1294;
                                                phi_868_ = 0u;
                                                loop {
                                                    let _e699 = phi_865_;
                                                    let _e701 = phi_868_;
                                                    local_22 = _e699;
                                                    if (_e701 < 4u) {
                                                        let _e705 = local[_e701];
                                                        local_14 = (_e699 + (_e705 * _e701));
                                                        local_15 = (_e701 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1296 = local_14;
                                                        phi_865_ = _e1296;
                                                        let _e1299 = local_15;
                                                        phi_868_ = _e1299;
                                                    }
                                                }
                                                phi_1149_ = _e519;
                                                let _e1343 = local_22;
                                                phi_1150_ = _e1343;
                                                break;
                                            }
                                            case 82: {
                                                phi_831_ = 0u;
                                                phi_834_ = _e120;
                                                loop {
                                                    let _e665 = phi_831_;
                                                    let _e667 = phi_834_;
                                                    local_6 = _e667;
                                                    local_7 = _e667;
                                                    local_8 = _e667;
                                                    if (_e665 < 4u) {
                                                        let _e671 = local[_e665];
                                                        let _e672 = f32(_e671);
                                                        local_9 = (_e665 + 1u);
                                                        if (_e667 != _e667) {
                                                            phi_847_ = true;
                                                        } else {
                                                            phi_847_ = (_e672 <= _e667);
                                                        }
                                                        let _e676 = phi_847_;
                                                        local_10 = select(_e667, _e672, _e676);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1278 = local_9;
                                                        phi_831_ = _e1278;
                                                        let _e1281 = local_10;
                                                        phi_834_ = _e1281;
                                                    }
                                                }
                                                let _e679 = local_6;
                                                let _e682 = local_7;
                                                let _e685 = local_8;
                                                phi_1149_ = _e519;
                                                phi_1150_ = select(select(u32(_e679), 0u, (_e682 < 0f)), 4294967295u, (_e685 > 4294967000f));
                                                break;
                                            }
                                            default: {
                                                let _e914 = bitcast<i32>(_e151);
                                                let _e916 = select(true, false, (_e914 <= -1i));
                                                if _e916 {
                                                    phi_1116_ = select(100i, 0i, (_e914 == 0i));
                                                } else {
                                                    phi_1116_ = 253i;
                                                }
                                                let _e920 = phi_1116_;
                                                let _e921 = bitcast<i32>(_e154);
                                                if select(true, false, (_e921 <= -1i)) {
                                                    phi_1125_ = select(100i, 0i, (_e921 == 0i));
                                                } else {
                                                    phi_1125_ = 253i;
                                                }
                                                let _e927 = phi_1125_;
                                                if _e916 {
                                                    phi_1140_ = select(100i, 0i, (_e914 == 0i));
                                                } else {
                                                    phi_1140_ = 253i;
                                                }
                                                let _e944 = phi_1140_;
                                                phi_1149_ = _e519;
                                                phi_1150_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e944) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (1000i * select(0i, 1i, (bitcast<i32>(((bitcast<i32>(_e920) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) == bitcast<i32>(((bitcast<i32>(_e927) << bitcast<u32>(24u)) >> bitcast<u32>(24u))))))));
                                                break;
                                            }
                                        }
                                        let _e956 = phi_1149_;
                                        let _e958 = phi_1150_;
                                        if _e956 {
                                            break;
                                        }
                                        phi_1152_ = _e958;
                                    } else {
                                        phi_1152_ = u32();
                                    }
                                    let _e960 = phi_1152_;
                                    phi_1154_ = _e960;
                                    phi_1155_ = select(true, false, _e656);
                                } else {
                                    phi_1154_ = u32();
                                    phi_1155_ = true;
                                }
                                let _e963 = phi_1154_;
                                let _e965 = phi_1155_;
                                if _e965 {
                                    if (84u <= _e146) {
                                        let _e967 = (_e146 <= 93u);
                                        if _e967 {
                                            let _e968 = bitcast<i32>(_e151);
                                            let _e969 = bitcast<i32>(_e154);
                                            switch bitcast<i32>(_e146) {
                                                case 84: {
                                                    phi_1285_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e968) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 85: {
                                                    phi_1285_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e968) & bitcast<i32>(65535u))) << bitcast<u32>(16u)) >> bitcast<u32>(16u)));
                                                    break;
                                                }
                                                case 86: {
                                                    phi_1285_ = (bitcast<i32>((bitcast<u32>(_e968) & 255u)) + bitcast<i32>((bitcast<u32>(_e969) & 65535u)));
                                                    break;
                                                }
                                                case 87: {
                                                    phi_1285_ = bitcast<i32>((((bitcast<u32>(_e968) & 255u) + (bitcast<u32>(_e969) & 255u)) & 255u));
                                                    break;
                                                }
                                                case 88: {
                                                    phi_1285_ = bitcast<i32>(((bitcast<i32>((((bitcast<i32>(_e968) & bitcast<i32>(255u)) * (bitcast<i32>(_e969) & bitcast<i32>(255u))) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 89: {
                                                    phi_1285_ = (select(0i, 1i, (((bitcast<i32>((bitcast<i32>(_e968) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>((bitcast<i32>(_e969) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))) + (2i * select(0i, 1i, ((bitcast<u32>(_e968) & 255u) < (bitcast<u32>(_e969) & 255u)))));
                                                    break;
                                                }
                                                case 90: {
                                                    phi_1285_ = (bitcast<i32>(((bitcast<i32>(((((bitcast<i32>((bitcast<i32>(_e968) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) >> bitcast<u32>(2i)) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + bitcast<i32>(((bitcast<u32>(_e968) & 65535u) >> bitcast<u32>(3u))));
                                                    break;
                                                }
                                                case 91: {
                                                    phi_1285_ = (bitcast<i32>((~((bitcast<u32>(_e968) & 255u)) & 255u)) + bitcast<i32>((((bitcast<u32>(_e969) & 255u) << bitcast<u32>(3u)) & 255u)));
                                                    break;
                                                }
                                                case 92: {
                                                    switch (bitcast<i32>(_e968) & bitcast<i32>(255u)) {
                                                        case 0: {
                                                            phi_1188_ = 1i;
                                                            break;
                                                        }
                                                        case 255: {
                                                            phi_1188_ = 2i;
                                                            break;
                                                        }
                                                        case 127: {
                                                            phi_1188_ = 3i;
                                                            break;
                                                        }
                                                        case 128: {
                                                            phi_1188_ = 5i;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1188_ = 4i;
                                                            break;
                                                        }
                                                    }
                                                    let _e975 = phi_1188_;
                                                    phi_1285_ = _e975;
                                                    break;
                                                }
                                                default: {
                                                    let _e1094 = (f32(((bitcast<i32>((bitcast<i32>(_e968) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) * 2f);
                                                    phi_1285_ = select(0i, select(select(i32(_e1094), i32(-2147483648), (_e1094 < -2147483600f)), 2147483647i, (_e1094 > 2147483500f)), (_e1094 == _e1094));
                                                    break;
                                                }
                                            }
                                            let _e1103 = phi_1285_;
                                            phi_1287_ = bitcast<u32>(_e1103);
                                        } else {
                                            phi_1287_ = u32();
                                        }
                                        let _e1106 = phi_1287_;
                                        phi_1289_ = _e1106;
                                        phi_1290_ = select(true, false, _e967);
                                    } else {
                                        phi_1289_ = u32();
                                        phi_1290_ = true;
                                    }
                                    let _e1109 = phi_1289_;
                                    let _e1111 = phi_1290_;
                                    if _e1111 {
                                        let _e1112 = bitcast<i32>(_e151);
                                        let _e1113 = bitcast<i32>(_e154);
                                        switch bitcast<i32>(_e146) {
                                            case 94: {
                                                let _e1207 = (_e151 + _e154);
                                                phi_1410_ = select(_e1207, 4294967295u, (_e1207 < _e151));
                                                break;
                                            }
                                            case 95: {
                                                if (_e151 < _e154) {
                                                    phi_1404_ = 0u;
                                                } else {
                                                    phi_1404_ = (_e151 - _e154);
                                                }
                                                let _e1206 = phi_1404_;
                                                phi_1410_ = _e1206;
                                                break;
                                            }
                                            case 96: {
                                                let _e1193 = (_e1112 + _e1113);
                                                if (((_e1112 ^ _e1193) & (_e1113 ^ _e1193)) < 0i) {
                                                    phi_1397_ = select(2147483647i, i32(-2147483648), (_e1112 < 0i));
                                                } else {
                                                    phi_1397_ = _e1193;
                                                }
                                                let _e1201 = phi_1397_;
                                                phi_1410_ = bitcast<u32>(_e1201);
                                                break;
                                            }
                                            case 97: {
                                                let _e1183 = (_e1112 - _e1113);
                                                if (((_e1112 ^ _e1113) & (_e1112 ^ _e1183)) < 0i) {
                                                    phi_1385_ = select(2147483647i, i32(-2147483648), (_e1112 < 0i));
                                                } else {
                                                    phi_1385_ = _e1183;
                                                }
                                                let _e1191 = phi_1385_;
                                                phi_1410_ = bitcast<u32>(_e1191);
                                                break;
                                            }
                                            case 98: {
                                                let _e1163 = sqrt(f32(_e151));
                                                let _e1165 = select(65535f, _e1163, (_e1163 < 65535f));
                                                let _e1170 = select(select(u32(_e1165), 0u, (_e1165 < 0f)), 4294967295u, (_e1165 > 4294967000f));
                                                if ((_e1170 * _e1170) > _e151) {
                                                    phi_1365_ = (_e1170 - 1u);
                                                } else {
                                                    phi_1365_ = _e1170;
                                                }
                                                let _e1175 = phi_1365_;
                                                if ((_e151 - (_e1175 * _e1175)) > (2u * _e1175)) {
                                                    phi_1374_ = (_e1175 + 1u);
                                                } else {
                                                    phi_1374_ = _e1175;
                                                }
                                                let _e1182 = phi_1374_;
                                                phi_1410_ = _e1182;
                                                break;
                                            }
                                            case 99: {
                                                let _e1142 = (_e151 >> bitcast<u32>(16i));
                                                let _e1143 = (_e151 & 65535u);
                                                let _e1145 = (_e154 >> bitcast<u32>(16i));
                                                let _e1146 = (_e154 & 65535u);
                                                let _e1151 = ((_e1142 * _e1146) + ((_e1143 * _e1146) >> bitcast<u32>(16i)));
                                                phi_1410_ = (((_e1142 * _e1145) + (_e1151 >> bitcast<u32>(16i))) + (((_e1143 * _e1145) + (_e1151 & 65535u)) >> bitcast<u32>(16i)));
                                                break;
                                            }
                                            case 100: {
                                                let _e1120 = (_e151 & 65535u);
                                                let _e1124 = (_e1120 & 32767u);
                                                let _e1126 = (_e1124 << bitcast<u32>(13i));
                                                if (_e1124 < 1024u) {
                                                    phi_1330_ = bitcast<u32>((f32(_e1124) * 0.000000059604645f));
                                                } else {
                                                    if (_e1124 < 31744u) {
                                                        phi_1327_ = (_e1126 + 939524096u);
                                                    } else {
                                                        phi_1327_ = (_e1126 | 2139095040u);
                                                    }
                                                    let _e1132 = phi_1327_;
                                                    phi_1330_ = _e1132;
                                                }
                                                let _e1137 = phi_1330_;
                                                phi_1410_ = bitcast<u32>(bitcast<f32>((((_e1120 & 32768u) << bitcast<u32>(16i)) | _e1137)));
                                                break;
                                            }
                                            case 101: {
                                                phi_1410_ = bitcast<u32>(ceil(_e157));
                                                break;
                                            }
                                            case 102: {
                                                phi_1410_ = select(0u, 1u, (abs(_e157) <= 0x1.fffffep+127f));
                                                break;
                                            }
                                            default: {
                                                phi_1410_ = select(0u, 1u, (_e157 == _e122));
                                                break;
                                            }
                                        }
                                        let _e1213 = phi_1410_;
                                        phi_1411_ = _e1213;
                                    } else {
                                        phi_1411_ = _e1109;
                                    }
                                    let _e1215 = phi_1411_;
                                    phi_1412_ = _e1215;
                                } else {
                                    phi_1412_ = _e963;
                                }
                                let _e1217 = phi_1412_;
                                phi_1413_ = _e1217;
                            } else {
                                phi_1413_ = _e652;
                            }
                            let _e1219 = phi_1413_;
                            phi_1414_ = _e1219;
                        } else {
                            phi_1414_ = _e521;
                        }
                        let _e1221 = phi_1414_;
                        phi_1415_ = _e1221;
                    } else {
                        phi_1415_ = _e390;
                    }
                    let _e1223 = phi_1415_;
                    global_9.member[_e139] = _e1223;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn core_functions(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
