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
var<workgroup> global_3: array<u32, 64>;
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
    var phi_279_: type_26;
    var phi_294_: u32;
    var phi_308_: u32;
    var phi_319_: u32;
    var phi_336_: type_26;
    var phi_350_: type_26;
    var phi_364_: type_26;
    var phi_377_: type_26;
    var phi_391_: type_26;
    var phi_457_: u32;
    var phi_464_: u32;
    var phi_472_: bool;
    var phi_473_: u32;
    var phi_475_: bool;
    var phi_476_: u32;
    var phi_478_: bool;
    var phi_479_: u32;
    var phi_480_: bool;
    var phi_529_: i32;
    var phi_536_: i32;
    var phi_549_: type_27;
    var phi_558_: type_28;
    var phi_574_: u32;
    var phi_588_: i32;
    var phi_600_: i32;
    var phi_620_: i32;
    var phi_628_: i32;
    var phi_648_: type_27;
    var phi_650_: bool;
    var phi_651_: i32;
    var phi_654_: bool;
    var phi_655_: u32;
    var phi_657_: bool;
    var phi_658_: u32;
    var phi_659_: bool;
    var phi_747_: f32;
    var phi_773_: bool;
    var phi_781_: bool;
    var phi_794_: bool;
    var phi_802_: bool;
    var phi_811_: bool;
    var phi_812_: u32;
    var phi_814_: bool;
    var phi_815_: u32;
    var phi_817_: bool;
    var phi_818_: u32;
    var phi_819_: bool;
    var phi_860_: u32;
    var phi_863_: f32;
    var phi_878_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_888_: u32;
    var phi_891_: u32;
    var phi_899_: u32;
    var phi_902_: u32;
    var phi_914_: u32;
    var phi_917_: u32;
    var phi_927_: u32;
    var phi_930_: u32;
    var phi_953_: bool;
    var phi_956_: u32;
    var phi_957_: bool;
    var phi_968_: u32;
    var phi_969_: bool;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_983_: u32;
    var phi_1012_: bool;
    var phi_1014_: u32;
    var phi_1015_: u32;
    var phi_1038_: i32;
    var phi_1061_: type_26;
    var phi_1070_: type_26;
    var phi_1079_: type_26;
    var phi_1095_: type_26;
    var phi_1096_: type_26;
    var phi_1108_: type_26;
    var phi_1117_: u32;
    var phi_1125_: type_26;
    var phi_1136_: type_26;
    var phi_1150_: i32;
    var phi_1159_: i32;
    var phi_1174_: i32;
    var phi_1183_: bool;
    var phi_1184_: u32;
    var phi_1186_: u32;
    var phi_1188_: u32;
    var phi_1189_: bool;
    var phi_1222_: i32;
    var phi_1324_: i32;
    var phi_1326_: u32;
    var phi_1328_: u32;
    var phi_1329_: bool;
    var phi_1366_: u32;
    var phi_1369_: u32;
    var phi_1407_: u32;
    var phi_1416_: u32;
    var phi_1427_: i32;
    var phi_1439_: i32;
    var phi_1446_: u32;
    var phi_1452_: u32;
    var phi_1453_: u32;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1457_: u32;
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

    let _e122 = local_3;
    let _e123 = bitcast<f32>(_e122);
    let _e124 = local_4;
    let _e125 = bitcast<f32>(_e124);
    let _e126 = local_5;
    switch bitcast<i32>(0u) {
        default: {
            let _e129 = global;
            let _e130 = global_1;
            let _e131 = global_2;
            global_3[_e129.x] = select(0u, 1u, ((_e129.x % 3u) == 0u));
            workgroupBarrier();
            let _e143 = (((_e130.x + (_e130.y * _e131.x)) * 64u) + _e129.x);
            let _e146 = global_4.member.member;
            if (_e143 >= (_e146 * 104u)) {
            } else {
                let _e149 = (_e146 == 0u);
                if _e149 {
                    break;
                }
                let _e150 = (_e143 / _e146);
                if (_e150 == 0u) {
                    let _e1271 = global_3[(_e129.x ^ 1u)];
                    global_9.member[_e143] = select(0u, 1u, (_e1271 != 0u));
                } else {
                    if _e149 {
                        break;
                    }
                    let _e152 = (_e143 % _e146);
                    let _e155 = global_5.member[_e152];
                    let _e158 = global_6.member[_e152];
                    let _e161 = global_7.member[_e152];
                    let _e164 = global_8.member[_e152];
                    if (1u <= _e150) {
                        let _e166 = (_e150 <= 34u);
                        if _e166 {
                            let _e167 = (_e158 % 32u);
                            switch bitcast<i32>(_e150) {
                                case 1: {
                                    phi_472_ = false;
                                    phi_473_ = select(_e155, _e158, (_e158 < _e155));
                                    break;
                                }
                                case 2: {
                                    phi_472_ = false;
                                    phi_473_ = select(_e158, _e155, (_e158 < _e155));
                                    break;
                                }
                                case 3: {
                                    if (_e155 < 5u) {
                                        phi_464_ = 5u;
                                    } else {
                                        phi_464_ = select(_e155, 1000u, (_e155 > 1000u));
                                    }
                                    let _e374 = phi_464_;
                                    phi_472_ = false;
                                    phi_473_ = _e374;
                                    break;
                                }
                                case 4: {
                                    if (_e155 < _e158) {
                                        phi_457_ = (_e158 - _e155);
                                    } else {
                                        phi_457_ = (_e155 - _e158);
                                    }
                                    let _e369 = phi_457_;
                                    phi_472_ = false;
                                    phi_473_ = _e369;
                                    break;
                                }
                                case 5: {
                                    phi_472_ = false;
                                    phi_473_ = (countOneBits(_e155) + (100u * countOneBits(~(_e155))));
                                    break;
                                }
                                case 6: {
                                    let _e354 = (_e155 == 0u);
                                    phi_472_ = false;
                                    phi_473_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e155)), 32u, _e354) + (100u * select(firstTrailingBit(_e155), 32u, _e354)));
                                    break;
                                }
                                case 7: {
                                    let _e341 = ~(_e155);
                                    let _e345 = (_e341 == 0u);
                                    phi_472_ = false;
                                    phi_473_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e341)), 32u, _e345) + (100u * select(firstTrailingBit(_e341), 32u, _e345)));
                                    break;
                                }
                                case 8: {
                                    let _e332 = (_e167 & 31u);
                                    phi_472_ = false;
                                    phi_473_ = select(((_e155 << bitcast<u32>(_e332)) | (_e155 >> bitcast<u32>((32u - _e332)))), _e155, (_e332 == 0u));
                                    break;
                                }
                                case 9: {
                                    let _e323 = (_e167 & 31u);
                                    phi_472_ = false;
                                    phi_473_ = select(((_e155 >> bitcast<u32>(_e323)) | (_e155 << bitcast<u32>((32u - _e323)))), _e155, (_e323 == 0u));
                                    break;
                                }
                                case 10: {
                                    phi_472_ = false;
                                    phi_473_ = (((_e155 >> bitcast<u32>(24u)) | ((_e155 >> bitcast<u32>(8u)) & 65280u)) | (((_e155 << bitcast<u32>(8u)) & 16711680u) | (_e155 << bitcast<u32>(24u))));
                                    break;
                                }
                                case 11: {
                                    phi_472_ = false;
                                    phi_473_ = reverseBits(_e155);
                                    break;
                                }
                                case 12: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 + _e158);
                                    break;
                                }
                                case 13: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 - _e158);
                                    break;
                                }
                                case 14: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 * _e158);
                                    break;
                                }
                                case 15: {
                                    phi_472_ = false;
                                    phi_473_ = (0u - _e155);
                                    break;
                                }
                                case 16: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 << bitcast<u32>((_e158 & 31u)));
                                    break;
                                }
                                case 17: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 >> bitcast<u32>((_e158 & 31u)));
                                    break;
                                }
                                case 18: {
                                    let _e285 = (_e155 + _e158);
                                    if select(false, true, (_e285 < _e155)) {
                                        phi_391_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_391_ = type_26(1u, _e285);
                                    }
                                    let _e293 = phi_391_;
                                    phi_472_ = false;
                                    phi_473_ = select(77u, _e293.member_1, (bitcast<i32>(_e293.member) != 0i));
                                    break;
                                }
                                case 19: {
                                    if (_e155 < _e158) {
                                        phi_377_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_377_ = type_26(1u, (_e155 - _e158));
                                    }
                                    let _e279 = phi_377_;
                                    phi_472_ = false;
                                    phi_473_ = select(77u, _e279.member_1, (bitcast<i32>(_e279.member) != 0i));
                                    break;
                                }
                                case 20: {
                                    if select(false, true, (_e158 == 0u)) {
                                        phi_364_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_364_ = type_26(1u, (_e155 / _e158));
                                    }
                                    let _e266 = phi_364_;
                                    phi_472_ = false;
                                    phi_473_ = select(77u, _e266.member_1, (bitcast<i32>(_e266.member) != 0i));
                                    break;
                                }
                                case 21: {
                                    if select(false, true, (_e158 == 0u)) {
                                        phi_350_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_350_ = type_26(1u, (_e155 % _e158));
                                    }
                                    let _e252 = phi_350_;
                                    phi_472_ = false;
                                    phi_473_ = select(77u, _e252.member_1, (bitcast<i32>(_e252.member) != 0i));
                                    break;
                                }
                                case 22: {
                                    let _e229 = (_e158 % 64u);
                                    if (_e229 < 32u) {
                                        phi_336_ = type_26(1u, (_e155 << bitcast<u32>(_e229)));
                                    } else {
                                        phi_336_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e238 = phi_336_;
                                    phi_472_ = false;
                                    phi_473_ = select(77u, _e238.member_1, (bitcast<i32>(_e238.member) != 0i));
                                    break;
                                }
                                case 23: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 + _e158);
                                    break;
                                }
                                case 24: {
                                    phi_472_ = false;
                                    phi_473_ = select(0u, 1u, ((_e155 - _e158) > _e155));
                                    break;
                                }
                                case 25: {
                                    phi_472_ = false;
                                    phi_473_ = select(0u, 1u, (countOneBits(_e155) == 1u));
                                    break;
                                }
                                case 26: {
                                    let _e210 = (_e155 % 1000u);
                                    if (_e210 <= 1u) {
                                        phi_319_ = 0u;
                                    } else {
                                        phi_319_ = (4294967295u >> bitcast<u32>(((bitcast<u32>(31i) - firstLeadingBit((_e210 - 1u))) & 31u)));
                                    }
                                    let _e220 = phi_319_;
                                    phi_472_ = false;
                                    phi_473_ = (_e220 + 1u);
                                    break;
                                }
                                case 27: {
                                    let _e202 = (_e158 | 1u);
                                    let _e203 = (_e202 == 0u);
                                    if _e203 {
                                        phi_472_ = true;
                                        phi_473_ = u32();
                                        break;
                                    }
                                    let _e204 = (_e155 / _e202);
                                    if _e203 {
                                        phi_472_ = true;
                                        phi_473_ = u32();
                                        break;
                                    }
                                    if ((_e155 % _e202) > 0u) {
                                        phi_308_ = (_e204 + 1u);
                                    } else {
                                        phi_308_ = _e204;
                                    }
                                    let _e209 = phi_308_;
                                    phi_472_ = false;
                                    phi_473_ = _e209;
                                    break;
                                }
                                case 28: {
                                    let _e195 = (_e155 % 1000u);
                                    let _e196 = (_e195 % 7u);
                                    if (_e196 == 0u) {
                                        phi_294_ = _e195;
                                    } else {
                                        phi_294_ = (_e195 + (7u - _e196));
                                    }
                                    let _e201 = phi_294_;
                                    phi_472_ = false;
                                    phi_473_ = _e201;
                                    break;
                                }
                                case 29: {
                                    let _e180 = (_e155 | 1u);
                                    if (select(1i, 0i, (_e180 == 0u)) != 0i) {
                                        phi_279_ = type_26(1u, firstLeadingBit(_e180));
                                    } else {
                                        phi_279_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e190 = phi_279_;
                                    if (bitcast<i32>(_e190.member) != 0i) {
                                    } else {
                                        phi_472_ = true;
                                        phi_473_ = u32();
                                        break;
                                    }
                                    phi_472_ = false;
                                    phi_473_ = _e190.member_1;
                                    break;
                                }
                                case 30: {
                                    phi_472_ = false;
                                    phi_473_ = bitcast<u32>(bitcast<i32>(_e155));
                                    break;
                                }
                                case 31: {
                                    let _e175 = (_e158 | 1u);
                                    if (_e175 == 0u) {
                                        phi_472_ = true;
                                        phi_473_ = u32();
                                        break;
                                    }
                                    phi_472_ = false;
                                    phi_473_ = (_e155 % _e175);
                                    break;
                                }
                                case 32: {
                                    let _e172 = (_e158 | 1u);
                                    if (_e172 == 0u) {
                                        phi_472_ = true;
                                        phi_473_ = u32();
                                        break;
                                    }
                                    phi_472_ = false;
                                    phi_473_ = (_e155 / _e172);
                                    break;
                                }
                                case 33: {
                                    phi_472_ = false;
                                    phi_473_ = select(0u, 1u, ((_e155 % 3u) == 0u));
                                    break;
                                }
                                default: {
                                    phi_472_ = false;
                                    phi_473_ = (_e155 + bitcast<u32>(bitcast<i32>(_e158)));
                                    break;
                                }
                            }
                            let _e383 = phi_472_;
                            let _e385 = phi_473_;
                            if _e383 {
                                break;
                            }
                            phi_475_ = _e383;
                            phi_476_ = _e385;
                        } else {
                            phi_475_ = false;
                            phi_476_ = u32();
                        }
                        let _e387 = phi_475_;
                        let _e389 = phi_476_;
                        phi_478_ = _e387;
                        phi_479_ = _e389;
                        phi_480_ = select(true, false, _e166);
                    } else {
                        phi_478_ = false;
                        phi_479_ = u32();
                        phi_480_ = true;
                    }
                    let _e392 = phi_478_;
                    let _e394 = phi_479_;
                    let _e396 = phi_480_;
                    if _e396 {
                        if (35u <= _e150) {
                            let _e398 = (_e150 <= 49u);
                            if _e398 {
                                let _e399 = bitcast<i32>(_e155);
                                let _e400 = bitcast<i32>(_e158);
                                switch bitcast<i32>(_e150) {
                                    case 35: {
                                        if (_e399 < 0i) {
                                            phi_628_ = (0i - _e399);
                                        } else {
                                            phi_628_ = _e399;
                                        }
                                        let _e508 = phi_628_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e508;
                                        break;
                                    }
                                    case 36: {
                                        if (_e399 < 0i) {
                                            phi_620_ = (0i - _e399);
                                        } else {
                                            phi_620_ = _e399;
                                        }
                                        let _e502 = phi_620_;
                                        phi_650_ = _e392;
                                        phi_651_ = bitcast<i32>(bitcast<u32>(_e502));
                                        break;
                                    }
                                    case 37: {
                                        phi_650_ = _e392;
                                        phi_651_ = bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e399 != 0i)), 255i, (_e399 < 0i))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                        break;
                                    }
                                    case 38: {
                                        phi_650_ = _e392;
                                        phi_651_ = (select(0i, 1i, (_e399 < 0i)) + (2i * select(0i, 1i, (_e399 > 0i))));
                                        break;
                                    }
                                    case 39: {
                                        let _e475 = (_e399 - (1000i * (_e399 / 1000i)));
                                        let _e478 = (_e475 - (7i * (_e475 / 7i)));
                                        if (_e478 < 0i) {
                                            phi_600_ = (_e478 + 7i);
                                        } else {
                                            phi_600_ = _e478;
                                        }
                                        let _e482 = phi_600_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e482;
                                        break;
                                    }
                                    case 40: {
                                        let _e464 = (_e399 - (1000i * (_e399 / 1000i)));
                                        let _e465 = (_e464 / 7i);
                                        if ((_e464 - (7i * (_e464 / 7i))) < 0i) {
                                            phi_588_ = (_e465 - 1i);
                                        } else {
                                            phi_588_ = _e465;
                                        }
                                        let _e472 = phi_588_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e472;
                                        break;
                                    }
                                    case 41: {
                                        if (_e399 < _e400) {
                                            phi_574_ = (bitcast<u32>(_e400) - bitcast<u32>(_e399));
                                        } else {
                                            phi_574_ = (bitcast<u32>(_e399) - bitcast<u32>(_e400));
                                        }
                                        let _e460 = phi_574_;
                                        phi_650_ = _e392;
                                        phi_651_ = bitcast<i32>(_e460);
                                        break;
                                    }
                                    case 42: {
                                        if select(false, true, (_e399 == i32(-2147483648))) {
                                            phi_549_ = type_27(i32(-2147483648), true);
                                        } else {
                                            phi_549_ = type_27(-(_e399), false);
                                        }
                                        let _e437 = phi_549_;
                                        if select(false, true, _e437.member_1) {
                                            phi_558_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_558_ = type_28(1u, _e437.member);
                                        }
                                        let _e446 = phi_558_;
                                        phi_650_ = _e392;
                                        phi_651_ = select(77i, _e446.member_1, (bitcast<i32>(_e446.member) != 0i));
                                        break;
                                    }
                                    case 43: {
                                        phi_650_ = _e392;
                                        phi_651_ = (0i - _e399);
                                        break;
                                    }
                                    case 44: {
                                        let _e427 = (_e400 < _e399);
                                        phi_650_ = _e392;
                                        phi_651_ = (select(_e399, _e400, _e427) ^ select(_e400, _e399, _e427));
                                        break;
                                    }
                                    case 45: {
                                        if (_e399 < -100i) {
                                            phi_536_ = -100i;
                                        } else {
                                            phi_536_ = select(_e399, 100i, (_e399 > 100i));
                                        }
                                        let _e426 = phi_536_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e426;
                                        break;
                                    }
                                    case 46: {
                                        let _e417 = (_e399 - (1000i * (_e399 / 1000i)));
                                        if (_e417 < 0i) {
                                            phi_529_ = -(_e417);
                                        } else {
                                            phi_529_ = _e417;
                                        }
                                        let _e421 = phi_529_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e421;
                                        break;
                                    }
                                    case 47: {
                                        phi_650_ = _e392;
                                        phi_651_ = (_e399 >> bitcast<u32>(((_e400 & 31i) & 31i)));
                                        break;
                                    }
                                    case 48: {
                                        let _e402 = bitcast<u32>(_e399);
                                        phi_650_ = _e392;
                                        phi_651_ = bitcast<i32>((select((bitcast<u32>(31i) - firstLeadingBit(_e402)), 32u, (_e402 == 0u)) + countOneBits(_e402)));
                                        break;
                                    }
                                    default: {
                                        let _e509 = (_e400 | 1i);
                                        let _e510 = (_e509 == -1i);
                                        if select(false, true, _e510) {
                                            phi_648_ = type_27(0i, (_e399 == i32(-2147483648)));
                                        } else {
                                            if (_e509 == 0i) {
                                                phi_650_ = true;
                                                phi_651_ = i32();
                                                break;
                                            }
                                            if (_e510 && (_e399 == i32(-2147483648))) {
                                                phi_650_ = true;
                                                phi_651_ = i32();
                                                break;
                                            }
                                            phi_648_ = type_27((_e399 - (_e509 * (_e399 / _e509))), false);
                                        }
                                        let _e522 = phi_648_;
                                        phi_650_ = _e392;
                                        phi_651_ = _e522.member;
                                        break;
                                    }
                                }
                                let _e525 = phi_650_;
                                let _e527 = phi_651_;
                                if _e525 {
                                    break;
                                }
                                phi_654_ = _e525;
                                phi_655_ = bitcast<u32>(_e527);
                            } else {
                                phi_654_ = _e392;
                                phi_655_ = u32();
                            }
                            let _e530 = phi_654_;
                            let _e532 = phi_655_;
                            phi_657_ = _e530;
                            phi_658_ = _e532;
                            phi_659_ = select(true, false, _e398);
                        } else {
                            phi_657_ = _e392;
                            phi_658_ = u32();
                            phi_659_ = true;
                        }
                        let _e535 = phi_657_;
                        let _e537 = phi_658_;
                        let _e539 = phi_659_;
                        if _e539 {
                            if (50u <= _e150) {
                                let _e541 = (_e150 <= 62u);
                                if _e541 {
                                    switch bitcast<i32>(_e150) {
                                        case 50: {
                                            let _e651 = ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u);
                                            if _e651 {
                                                phi_794_ = true;
                                            } else {
                                                phi_794_ = (_e164 <= _e161);
                                            }
                                            let _e654 = phi_794_;
                                            if _e651 {
                                                phi_802_ = true;
                                            } else {
                                                phi_802_ = (_e164 <= _e161);
                                            }
                                            let _e660 = phi_802_;
                                            phi_811_ = _e535;
                                            phi_812_ = (bitcast<u32>(abs(select(_e161, _e164, _e654))) | (select(0u, 1u, (select(_e161, _e164, _e660) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 51: {
                                            let _e633 = ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u);
                                            if _e633 {
                                                phi_773_ = true;
                                            } else {
                                                phi_773_ = (_e164 >= _e161);
                                            }
                                            let _e636 = phi_773_;
                                            if _e633 {
                                                phi_781_ = true;
                                            } else {
                                                phi_781_ = (_e164 >= _e161);
                                            }
                                            let _e642 = phi_781_;
                                            phi_811_ = _e535;
                                            phi_812_ = (bitcast<u32>(abs(select(_e161, _e164, _e636))) | (select(0u, 1u, (select(_e161, _e164, _e642) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 52: {
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(abs(_e161));
                                            break;
                                        }
                                        case 53: {
                                            if (-1f <= 1f) {
                                            } else {
                                                phi_811_ = true;
                                                phi_812_ = u32();
                                                break;
                                            }
                                            let _e625 = select(_e161, -1f, (_e161 < -1f));
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(select(_e625, 1f, (_e625 > 1f)));
                                            break;
                                        }
                                        case 54: {
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(bitcast<f32>(((bitcast<u32>(_e161) & 2147483647u) | (bitcast<u32>(_e164) & 2147483648u))));
                                            break;
                                        }
                                        case 55: {
                                            if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
                                                phi_747_ = bitcast<f32>(_e126);
                                            } else {
                                                phi_747_ = bitcast<f32>((1065353216u | (bitcast<u32>(_e161) & 2147483648u)));
                                            }
                                            let _e614 = phi_747_;
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(_e614);
                                            break;
                                        }
                                        case 56: {
                                            phi_811_ = _e535;
                                            phi_812_ = (select(0u, 1u, (abs(_e161) < _e123)) + (4u * select(0u, 1u, ((_e161 == _e123) || (_e161 == _e125)))));
                                            break;
                                        }
                                        case 57: {
                                            let _e591 = ((bitcast<u32>(_e161) & 2147483648u) != 0u);
                                            phi_811_ = _e535;
                                            phi_812_ = (select(0u, 1u, _e591) + (2u * select(0u, 1u, !(_e591))));
                                            break;
                                        }
                                        case 58: {
                                            let _e561 = bitcast<i32>(bitcast<u32>(_e161));
                                            let _e563 = bitcast<i32>(bitcast<u32>(_e164));
                                            let _e570 = (_e561 ^ bitcast<i32>((bitcast<u32>((_e561 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            let _e577 = (_e563 ^ bitcast<i32>((bitcast<u32>((_e563 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e570 != _e577)), 255i, (_e570 < _e577))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))));
                                            break;
                                        }
                                        case 59: {
                                            let _e555 = trunc(_e161);
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(select(_e555, (_e555 - 1f), (_e161 < _e555)));
                                            break;
                                        }
                                        case 60: {
                                            let _e545 = trunc(_e161);
                                            let _e546 = (_e161 - _e545);
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(select(select(_e545, (_e545 + 1f), (0.5f <= _e546)), (_e545 - 1f), (_e546 <= -(0.5f))));
                                            break;
                                        }
                                        case 61: {
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(trunc(_e161));
                                            break;
                                        }
                                        default: {
                                            phi_811_ = _e535;
                                            phi_812_ = bitcast<u32>(select(_e164, _e123, (_e161 > _e164)));
                                            break;
                                        }
                                    }
                                    let _e671 = phi_811_;
                                    let _e673 = phi_812_;
                                    if _e671 {
                                        break;
                                    }
                                    phi_814_ = _e671;
                                    phi_815_ = _e673;
                                } else {
                                    phi_814_ = _e535;
                                    phi_815_ = u32();
                                }
                                let _e675 = phi_814_;
                                let _e677 = phi_815_;
                                phi_817_ = _e675;
                                phi_818_ = _e677;
                                phi_819_ = select(true, false, _e541);
                            } else {
                                phi_817_ = _e535;
                                phi_818_ = u32();
                                phi_819_ = true;
                            }
                            let _e680 = phi_817_;
                            let _e682 = phi_818_;
                            let _e684 = phi_819_;
                            if _e684 {
                                if (63u <= _e150) {
                                    let _e686 = (_e150 <= 83u);
                                    if _e686 {
                                        local[0u] = (_e155 % 100u);
                                        local[1u] = (_e158 % 100u);
                                        local[2u] = 7u;
                                        local[3u] = 3u;
                                        switch bitcast<i32>(_e150) {
                                            case 63: {
                                                if (_e155 > _e158) {
                                                    phi_1136_ = type_26(1u, 5u);
                                                } else {
                                                    phi_1136_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e943 = phi_1136_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = select(6u, _e943.member_1, (bitcast<i32>(_e943.member) != 0i));
                                                break;
                                            }
                                            case 64: {
                                                if (_e155 > _e158) {
                                                    phi_1125_ = type_26(1u, (_e155 - _e158));
                                                } else {
                                                    phi_1125_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e932 = phi_1125_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = select(6u, _e932.member_1, (bitcast<i32>(_e932.member) != 0i));
                                                break;
                                            }
                                            case 65: {
                                                if (_e155 > _e158) {
                                                    phi_1108_ = type_26(1u, _e155);
                                                } else {
                                                    phi_1108_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e917 = phi_1108_;
                                                if (bitcast<i32>(_e917.member) != 0i) {
                                                    phi_1117_ = (_e917.member_1 - _e158);
                                                } else {
                                                    phi_1117_ = 3u;
                                                }
                                                let _e924 = phi_1117_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e924;
                                                break;
                                            }
                                            case 66: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = (_e155 ^ _e158);
                                                break;
                                            }
                                            case 67: {
                                                if (_e155 < _e158) {
                                                    phi_1079_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1079_ = type_26(1u, (_e155 - _e158));
                                                }
                                                let _e888 = phi_1079_;
                                                if (bitcast<i32>(_e888.member) != 0i) {
                                                    if (_e888.member_1 < 10u) {
                                                        phi_1095_ = type_26(0u, type_26().member_1);
                                                    } else {
                                                        phi_1095_ = type_26(1u, (_e888.member_1 - 10u));
                                                    }
                                                    let _e903 = phi_1095_;
                                                    phi_1096_ = _e903;
                                                } else {
                                                    phi_1096_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e905 = phi_1096_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = select(0u, 1u, (bitcast<i32>(_e905.member) == 1i));
                                                break;
                                            }
                                            case 68: {
                                                if (_e155 < _e158) {
                                                    phi_1061_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1061_ = type_26(1u, (_e155 - _e158));
                                                }
                                                let _e872 = phi_1061_;
                                                if (bitcast<i32>(_e872.member) != 0i) {
                                                    phi_1070_ = type_26(0u, _e872.member_1);
                                                } else {
                                                    phi_1070_ = type_26(1u, 4u);
                                                }
                                                let _e879 = phi_1070_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e879.member_1;
                                                break;
                                            }
                                            case 69: {
                                                let _e841 = select(select(0i, 1i, (_e155 != _e158)), 255i, (_e155 < _e158));
                                                switch _e841 {
                                                    case 255: {
                                                        phi_1038_ = 1i;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_1038_ = 0i;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1038_ = 255i;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1038_ = i32();
                                                        break;
                                                    }
                                                }
                                                let _e843 = phi_1038_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e843) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (5i * select(0i, 1i, (((bitcast<i32>(_e841) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>(0i) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))))));
                                                break;
                                            }
                                            case 70: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = (_e158 - (_e155 * 2u));
                                                break;
                                            }
                                            case 71: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = (_e155 + (_e158 * 3u));
                                                break;
                                            }
                                            case 72: {
                                                let _e828 = local[0u];
                                                let _e829 = local[1u];
                                                let _e830 = local[2u];
                                                phi_1183_ = _e680;
                                                phi_1184_ = ((_e828 + (1000u * _e829)) + _e830);
                                                break;
                                            }
                                            case 73: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = ((_e158 + _e155) * (1u + _e155));
                                                break;
                                            }
                                            case 74: {
                                                if select(true, false, (_e155 <= 9u)) {
                                                    if ((_e155 % 2u) == 0u) {
                                                        phi_1014_ = 2u;
                                                    } else {
                                                        switch bitcast<i32>(_e155) {
                                                            case 11: {
                                                                phi_1012_ = true;
                                                                break;
                                                            }
                                                            case 13: {
                                                                phi_1012_ = true;
                                                                break;
                                                            }
                                                            case 15: {
                                                                phi_1012_ = true;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1012_ = false;
                                                                break;
                                                            }
                                                        }
                                                        let _e819 = phi_1012_;
                                                        phi_1014_ = select(4u, 3u, _e819);
                                                    }
                                                    let _e822 = phi_1014_;
                                                    phi_1015_ = _e822;
                                                } else {
                                                    phi_1015_ = 1u;
                                                }
                                                let _e824 = phi_1015_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e824;
                                                break;
                                            }
                                            case 75: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = select(0u, (_e155 / 3u), ((_e155 % 3u) == 1u));
                                                break;
                                            }
                                            case 76: {
                                                phi_1183_ = _e680;
                                                phi_1184_ = (select(0u, 1u, (_e155 > _e158)) + 1u);
                                                break;
                                            }
                                            case 77: {
                                                let _e802 = (_e158 % 4u);
                                                if (_e802 < 4u) {
                                                } else {
                                                    phi_1183_ = true;
                                                    phi_1184_ = u32();
                                                    break;
                                                }
                                                let _e805 = local[_e802];
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e805;
                                                break;
                                            }
                                            case 78: {
                                                switch select(select(0i, 1i, (_e155 != _e158)), 255i, (_e155 < _e158)) {
                                                    case 255: {
                                                        phi_983_ = 10u;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_983_ = 20u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_983_ = 30u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_983_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e801 = phi_983_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e801;
                                                break;
                                            }
                                            case 79: {
                                                if (_e155 < 3u) {
                                                    phi_973_ = 100u;
                                                } else {
                                                    if ((_e155 % 2u) == 0u) {
                                                        let _e772 = ((_e155 % 3u) == 0u);
                                                        if _e772 {
                                                            phi_953_ = true;
                                                        } else {
                                                            phi_953_ = (_e155 > 20u);
                                                        }
                                                        let _e775 = phi_953_;
                                                        phi_956_ = select(2000u, 6u, _e772);
                                                        phi_957_ = select(true, false, _e775);
                                                    } else {
                                                        phi_956_ = u32();
                                                        phi_957_ = true;
                                                    }
                                                    let _e779 = phi_956_;
                                                    let _e781 = phi_957_;
                                                    if _e781 {
                                                        switch bitcast<i32>((_e155 % 7u)) {
                                                            case 0: {
                                                                phi_968_ = 7u;
                                                                phi_969_ = false;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_968_ = 77u;
                                                                phi_969_ = select(true, false, (_e155 > 30u));
                                                                break;
                                                            }
                                                            default: {
                                                                phi_968_ = u32();
                                                                phi_969_ = true;
                                                                break;
                                                            }
                                                        }
                                                        let _e787 = phi_968_;
                                                        let _e789 = phi_969_;
                                                        phi_972_ = select(_e155, _e787, select(true, false, _e789));
                                                    } else {
                                                        phi_972_ = _e779;
                                                    }
                                                    let _e793 = phi_972_;
                                                    phi_973_ = _e793;
                                                }
                                                let _e795 = phi_973_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = _e795;
                                                break;
                                            }
                                            case 80: {
                                                local_1[0u] = 1u;
                                                local_1[1u] = 10u;
                                                local_1[2u] = 100u;
                                                phi_914_ = 0u;
                                                phi_917_ = 0u;
                                                loop {
                                                    let _e747 = phi_914_;
                                                    let _e749 = phi_917_;
                                                    local_19 = _e749;
                                                    if (_e747 < 3u) {
                                                        let _e752 = local_1[_e747];
                                                        let _e754 = local[0u];
                                                        local_16 = (_e747 + 1u);
                                                        local_17 = (_e749 + (_e754 * _e752));
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1349 = local_16;
                                                        phi_914_ = _e1349;
                                                        let _e1352 = local_17;
                                                        phi_917_ = _e1352;
                                                    }
                                                }
                                                let _e757 = local;
                                                local_2 = _e757;
                                                phi_927_ = 0u;
                                                let _e1358 = local_19;
                                                phi_930_ = _e1358;
                                                loop {
                                                    let _e759 = phi_927_;
                                                    let _e761 = phi_930_;
                                                    local_21 = _e761;
                                                    if (_e759 < 4u) {
                                                        let _e764 = local_2[_e759];
                                                        local_18 = (_e759 + 1u);
                                                        local_20 = ((_e761 * 3u) + _e764);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1355 = local_18;
                                                        phi_927_ = _e1355;
                                                        let _e1360 = local_20;
                                                        phi_930_ = _e1360;
                                                    }
                                                }
                                                phi_1183_ = _e680;
                                                let _e1388 = local_21;
                                                phi_1184_ = _e1388;
                                                break;
                                            }
                                            case 81: {
                                                phi_888_ = 0u;
                                                phi_891_ = 0u;
                                                loop {
                                                    let _e725 = phi_888_;
                                                    let _e727 = phi_891_;
                                                    local_13 = _e725;
                                                    if (_e727 < 4u) {
                                                        let _e731 = local[_e727];
                                                        local_11 = (_e725 + _e731);
                                                        local_12 = (_e727 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1335 = local_11;
                                                        phi_888_ = _e1335;
                                                        let _e1338 = local_12;
                                                        phi_891_ = _e1338;
                                                    }
                                                }
                                                let _e1341 = local_13;
                                                phi_899_ = _e1341;
                                                phi_902_ = 0u;
                                                loop {
                                                    let _e734 = phi_899_;
                                                    let _e736 = phi_902_;
                                                    local_22 = _e734;
                                                    if (_e736 < 4u) {
                                                        let _e740 = local[_e736];
                                                        local_14 = (_e734 + (_e740 * _e736));
                                                        local_15 = (_e736 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1343 = local_14;
                                                        phi_899_ = _e1343;
                                                        let _e1346 = local_15;
                                                        phi_902_ = _e1346;
                                                    }
                                                }
                                                phi_1183_ = _e680;
                                                let _e1390 = local_22;
                                                phi_1184_ = _e1390;
                                                break;
                                            }
                                            case 82: {
                                                phi_860_ = 0u;
                                                phi_863_ = _e123;
                                                loop {
                                                    let _e695 = phi_860_;
                                                    let _e697 = phi_863_;
                                                    local_6 = _e697;
                                                    local_7 = _e697;
                                                    local_8 = _e697;
                                                    if (_e695 < 4u) {
                                                        let _e701 = local[_e695];
                                                        let _e702 = f32(_e701);
                                                        local_9 = (_e695 + 1u);
                                                        if ((bitcast<u32>(_e697) & 2147483647u) > 2139095040u) {
                                                            phi_878_ = true;
                                                        } else {
                                                            phi_878_ = (_e702 <= _e697);
                                                        }
                                                        let _e708 = phi_878_;
                                                        local_10 = select(_e697, _e702, _e708);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1325 = local_9;
                                                        phi_860_ = _e1325;
                                                        let _e1328 = local_10;
                                                        phi_863_ = _e1328;
                                                    }
                                                }
                                                let _e713 = local_6;
                                                let _e716 = local_7;
                                                let _e720 = local_8;
                                                phi_1183_ = _e680;
                                                phi_1184_ = select(select(u32(_e713), 0u, !((_e716 >= bitcast<f32>(0u)))), 4294967295u, (_e720 > bitcast<f32>(1333788671u)));
                                                break;
                                            }
                                            default: {
                                                let _e949 = bitcast<i32>(_e155);
                                                let _e951 = select(true, false, (_e949 <= -1i));
                                                if _e951 {
                                                    phi_1150_ = select(100i, 0i, (_e949 == 0i));
                                                } else {
                                                    phi_1150_ = 253i;
                                                }
                                                let _e955 = phi_1150_;
                                                let _e956 = bitcast<i32>(_e158);
                                                if select(true, false, (_e956 <= -1i)) {
                                                    phi_1159_ = select(100i, 0i, (_e956 == 0i));
                                                } else {
                                                    phi_1159_ = 253i;
                                                }
                                                let _e962 = phi_1159_;
                                                if _e951 {
                                                    phi_1174_ = select(100i, 0i, (_e949 == 0i));
                                                } else {
                                                    phi_1174_ = 253i;
                                                }
                                                let _e979 = phi_1174_;
                                                phi_1183_ = _e680;
                                                phi_1184_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e979) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (1000i * select(0i, 1i, (bitcast<i32>(((bitcast<i32>(_e955) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) == bitcast<i32>(((bitcast<i32>(_e962) << bitcast<u32>(24u)) >> bitcast<u32>(24u))))))));
                                                break;
                                            }
                                        }
                                        let _e991 = phi_1183_;
                                        let _e993 = phi_1184_;
                                        if _e991 {
                                            break;
                                        }
                                        phi_1186_ = _e993;
                                    } else {
                                        phi_1186_ = u32();
                                    }
                                    let _e995 = phi_1186_;
                                    phi_1188_ = _e995;
                                    phi_1189_ = select(true, false, _e686);
                                } else {
                                    phi_1188_ = u32();
                                    phi_1189_ = true;
                                }
                                let _e998 = phi_1188_;
                                let _e1000 = phi_1189_;
                                if _e1000 {
                                    if (84u <= _e150) {
                                        let _e1002 = (_e150 <= 93u);
                                        if _e1002 {
                                            let _e1003 = bitcast<i32>(_e155);
                                            let _e1004 = bitcast<i32>(_e158);
                                            switch bitcast<i32>(_e150) {
                                                case 84: {
                                                    phi_1324_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1003) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 85: {
                                                    phi_1324_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1003) & bitcast<i32>(65535u))) << bitcast<u32>(16u)) >> bitcast<u32>(16u)));
                                                    break;
                                                }
                                                case 86: {
                                                    phi_1324_ = (bitcast<i32>((bitcast<u32>(_e1003) & 255u)) + bitcast<i32>((bitcast<u32>(_e1004) & 65535u)));
                                                    break;
                                                }
                                                case 87: {
                                                    phi_1324_ = bitcast<i32>((((bitcast<u32>(_e1003) & 255u) + (bitcast<u32>(_e1004) & 255u)) & 255u));
                                                    break;
                                                }
                                                case 88: {
                                                    phi_1324_ = bitcast<i32>(((bitcast<i32>((((bitcast<i32>(_e1003) & bitcast<i32>(255u)) * (bitcast<i32>(_e1004) & bitcast<i32>(255u))) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 89: {
                                                    phi_1324_ = (select(0i, 1i, (((bitcast<i32>((bitcast<i32>(_e1003) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>((bitcast<i32>(_e1004) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))) + (2i * select(0i, 1i, ((bitcast<u32>(_e1003) & 255u) < (bitcast<u32>(_e1004) & 255u)))));
                                                    break;
                                                }
                                                case 90: {
                                                    phi_1324_ = (bitcast<i32>(((bitcast<i32>(((((bitcast<i32>((bitcast<i32>(_e1003) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) >> bitcast<u32>(2i)) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + bitcast<i32>(((bitcast<u32>(_e1003) & 65535u) >> bitcast<u32>(3u))));
                                                    break;
                                                }
                                                case 91: {
                                                    phi_1324_ = (bitcast<i32>((~((bitcast<u32>(_e1003) & 255u)) & 255u)) + bitcast<i32>((((bitcast<u32>(_e1004) & 255u) << bitcast<u32>(3u)) & 255u)));
                                                    break;
                                                }
                                                case 92: {
                                                    switch (bitcast<i32>(_e1003) & bitcast<i32>(255u)) {
                                                        case 0: {
                                                            phi_1222_ = 1i;
                                                            break;
                                                        }
                                                        case 255: {
                                                            phi_1222_ = 2i;
                                                            break;
                                                        }
                                                        case 127: {
                                                            phi_1222_ = 3i;
                                                            break;
                                                        }
                                                        case 128: {
                                                            phi_1222_ = 5i;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1222_ = 4i;
                                                            break;
                                                        }
                                                    }
                                                    let _e1010 = phi_1222_;
                                                    phi_1324_ = _e1010;
                                                    break;
                                                }
                                                default: {
                                                    let _e1129 = (f32(((bitcast<i32>((bitcast<i32>(_e1003) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) * 2f);
                                                    phi_1324_ = select(0i, select(select(i32(_e1129), i32(-2147483648), !((_e1129 >= bitcast<f32>(3472883712u)))), 2147483647i, (_e1129 > bitcast<f32>(1325400063u))), ((bitcast<u32>(_e1129) & 2147483647u) <= 2139095040u));
                                                    break;
                                                }
                                            }
                                            let _e1143 = phi_1324_;
                                            phi_1326_ = bitcast<u32>(_e1143);
                                        } else {
                                            phi_1326_ = u32();
                                        }
                                        let _e1146 = phi_1326_;
                                        phi_1328_ = _e1146;
                                        phi_1329_ = select(true, false, _e1002);
                                    } else {
                                        phi_1328_ = u32();
                                        phi_1329_ = true;
                                    }
                                    let _e1149 = phi_1328_;
                                    let _e1151 = phi_1329_;
                                    if _e1151 {
                                        let _e1152 = bitcast<i32>(_e155);
                                        let _e1153 = bitcast<i32>(_e158);
                                        switch bitcast<i32>(_e150) {
                                            case 94: {
                                                let _e1250 = (_e155 + _e158);
                                                phi_1452_ = select(_e1250, 4294967295u, (_e1250 < _e155));
                                                break;
                                            }
                                            case 95: {
                                                if (_e155 < _e158) {
                                                    phi_1446_ = 0u;
                                                } else {
                                                    phi_1446_ = (_e155 - _e158);
                                                }
                                                let _e1249 = phi_1446_;
                                                phi_1452_ = _e1249;
                                                break;
                                            }
                                            case 96: {
                                                let _e1236 = (_e1152 + _e1153);
                                                if (((_e1152 ^ _e1236) & (_e1153 ^ _e1236)) < 0i) {
                                                    phi_1439_ = select(2147483647i, i32(-2147483648), (_e1152 < 0i));
                                                } else {
                                                    phi_1439_ = _e1236;
                                                }
                                                let _e1244 = phi_1439_;
                                                phi_1452_ = bitcast<u32>(_e1244);
                                                break;
                                            }
                                            case 97: {
                                                let _e1226 = (_e1152 - _e1153);
                                                if (((_e1152 ^ _e1153) & (_e1152 ^ _e1226)) < 0i) {
                                                    phi_1427_ = select(2147483647i, i32(-2147483648), (_e1152 < 0i));
                                                } else {
                                                    phi_1427_ = _e1226;
                                                }
                                                let _e1234 = phi_1427_;
                                                phi_1452_ = bitcast<u32>(_e1234);
                                                break;
                                            }
                                            case 98: {
                                                let _e1203 = sqrt(f32(_e155));
                                                let _e1205 = select(65535f, _e1203, (_e1203 < 65535f));
                                                let _e1213 = select(select(u32(_e1205), 0u, !((_e1205 >= bitcast<f32>(0u)))), 4294967295u, (_e1205 > bitcast<f32>(1333788671u)));
                                                if ((_e1213 * _e1213) > _e155) {
                                                    phi_1407_ = (_e1213 - 1u);
                                                } else {
                                                    phi_1407_ = _e1213;
                                                }
                                                let _e1218 = phi_1407_;
                                                if ((_e155 - (_e1218 * _e1218)) > (2u * _e1218)) {
                                                    phi_1416_ = (_e1218 + 1u);
                                                } else {
                                                    phi_1416_ = _e1218;
                                                }
                                                let _e1225 = phi_1416_;
                                                phi_1452_ = _e1225;
                                                break;
                                            }
                                            case 99: {
                                                let _e1182 = (_e155 >> bitcast<u32>(16i));
                                                let _e1183 = (_e155 & 65535u);
                                                let _e1185 = (_e158 >> bitcast<u32>(16i));
                                                let _e1186 = (_e158 & 65535u);
                                                let _e1191 = ((_e1182 * _e1186) + ((_e1183 * _e1186) >> bitcast<u32>(16i)));
                                                phi_1452_ = (((_e1182 * _e1185) + (_e1191 >> bitcast<u32>(16i))) + (((_e1183 * _e1185) + (_e1191 & 65535u)) >> bitcast<u32>(16i)));
                                                break;
                                            }
                                            case 100: {
                                                let _e1160 = (_e155 & 65535u);
                                                let _e1164 = (_e1160 & 32767u);
                                                let _e1166 = (_e1164 << bitcast<u32>(13i));
                                                if (_e1164 < 1024u) {
                                                    phi_1369_ = bitcast<u32>((f32(_e1164) * 0.000000059604645f));
                                                } else {
                                                    if (_e1164 < 31744u) {
                                                        phi_1366_ = (_e1166 + 939524096u);
                                                    } else {
                                                        phi_1366_ = (_e1166 | 2139095040u);
                                                    }
                                                    let _e1172 = phi_1366_;
                                                    phi_1369_ = _e1172;
                                                }
                                                let _e1177 = phi_1369_;
                                                phi_1452_ = bitcast<u32>(bitcast<f32>((((_e1160 & 32768u) << bitcast<u32>(16i)) | _e1177)));
                                                break;
                                            }
                                            case 101: {
                                                phi_1452_ = bitcast<u32>(ceil(_e161));
                                                break;
                                            }
                                            case 102: {
                                                phi_1452_ = select(0u, 1u, (abs(_e161) <= 0x1.fffffep+127f));
                                                break;
                                            }
                                            default: {
                                                phi_1452_ = select(0u, 1u, (_e161 == _e125));
                                                break;
                                            }
                                        }
                                        let _e1256 = phi_1452_;
                                        phi_1453_ = _e1256;
                                    } else {
                                        phi_1453_ = _e1149;
                                    }
                                    let _e1258 = phi_1453_;
                                    phi_1454_ = _e1258;
                                } else {
                                    phi_1454_ = _e998;
                                }
                                let _e1260 = phi_1454_;
                                phi_1455_ = _e1260;
                            } else {
                                phi_1455_ = _e682;
                            }
                            let _e1262 = phi_1455_;
                            phi_1456_ = _e1262;
                        } else {
                            phi_1456_ = _e537;
                        }
                        let _e1264 = phi_1456_;
                        phi_1457_ = _e1264;
                    } else {
                        phi_1457_ = _e394;
                    }
                    let _e1266 = phi_1457_;
                    global_9.member[_e143] = _e1266;
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
