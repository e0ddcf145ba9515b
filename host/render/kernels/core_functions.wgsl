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
    var phi_276_: type_26;
    var phi_291_: u32;
    var phi_305_: u32;
    var phi_316_: u32;
    var phi_333_: type_26;
    var phi_347_: type_26;
    var phi_361_: type_26;
    var phi_374_: type_26;
    var phi_388_: type_26;
    var phi_454_: u32;
    var phi_461_: u32;
    var phi_469_: bool;
    var phi_470_: u32;
    var phi_472_: bool;
    var phi_473_: u32;
    var phi_475_: bool;
    var phi_476_: u32;
    var phi_477_: bool;
    var phi_526_: i32;
    var phi_533_: i32;
    var phi_546_: type_27;
    var phi_555_: type_28;
    var phi_571_: u32;
    var phi_585_: i32;
    var phi_597_: i32;
    var phi_617_: i32;
    var phi_625_: i32;
    var phi_645_: type_27;
    var phi_647_: bool;
    var phi_648_: i32;
    var phi_651_: bool;
    var phi_652_: u32;
    var phi_654_: bool;
    var phi_655_: u32;
    var phi_656_: bool;
    var phi_744_: f32;
    var phi_770_: bool;
    var phi_778_: bool;
    var phi_791_: bool;
    var phi_799_: bool;
    var phi_808_: bool;
    var phi_809_: u32;
    var phi_811_: bool;
    var phi_812_: u32;
    var phi_814_: bool;
    var phi_815_: u32;
    var phi_816_: bool;
    var phi_857_: u32;
    var phi_860_: f32;
    var phi_875_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_885_: u32;
    var phi_888_: u32;
    var phi_896_: u32;
    var phi_899_: u32;
    var phi_911_: u32;
    var phi_914_: u32;
    var phi_924_: u32;
    var phi_927_: u32;
    var phi_950_: bool;
    var phi_953_: u32;
    var phi_954_: bool;
    var phi_965_: u32;
    var phi_966_: bool;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_980_: u32;
    var phi_1009_: bool;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1035_: i32;
    var phi_1058_: type_26;
    var phi_1067_: type_26;
    var phi_1076_: type_26;
    var phi_1092_: type_26;
    var phi_1093_: type_26;
    var phi_1105_: type_26;
    var phi_1114_: u32;
    var phi_1122_: type_26;
    var phi_1133_: type_26;
    var phi_1147_: i32;
    var phi_1156_: i32;
    var phi_1171_: i32;
    var phi_1180_: bool;
    var phi_1181_: u32;
    var phi_1183_: u32;
    var phi_1185_: u32;
    var phi_1186_: bool;
    var phi_1219_: i32;
    var phi_1321_: i32;
    var phi_1323_: u32;
    var phi_1325_: u32;
    var phi_1326_: bool;
    var phi_1363_: u32;
    var phi_1366_: u32;
    var phi_1404_: u32;
    var phi_1413_: u32;
    var phi_1424_: i32;
    var phi_1436_: i32;
    var phi_1443_: u32;
    var phi_1449_: u32;
    var phi_1450_: u32;
    var phi_1451_: u32;
    var phi_1452_: u32;
    var phi_1453_: u32;
    var phi_1454_: u32;
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

    let _e120 = local_3;
    let _e121 = bitcast<f32>(_e120);
    let _e122 = local_4;
    let _e123 = bitcast<f32>(_e122);
    let _e124 = local_5;
    switch bitcast<i32>(0u) {
        default: {
            let _e127 = global;
            let _e128 = global_1;
            let _e129 = global_2;
            global_3[_e127.x] = ((_e127.x % 3u) == 0u);
            workgroupBarrier();
            let _e140 = (((_e128.x + (_e128.y * _e129.x)) * 64u) + _e127.x);
            let _e143 = global_4.member.member;
            if (_e140 >= (_e143 * 104u)) {
            } else {
                let _e146 = (_e143 == 0u);
                if _e146 {
                    break;
                }
                let _e147 = (_e140 / _e143);
                if (_e147 == 0u) {
                    let _e1268 = global_3[(_e127.x ^ 1u)];
                    global_9.member[_e140] = select(0u, 1u, _e1268);
                } else {
                    if _e146 {
                        break;
                    }
                    let _e149 = (_e140 % _e143);
                    let _e152 = global_5.member[_e149];
                    let _e155 = global_6.member[_e149];
                    let _e158 = global_7.member[_e149];
                    let _e161 = global_8.member[_e149];
                    if (1u <= _e147) {
                        let _e163 = (_e147 <= 34u);
                        if _e163 {
                            let _e164 = (_e155 % 32u);
                            switch bitcast<i32>(_e147) {
                                case 1: {
                                    phi_469_ = false;
                                    phi_470_ = select(_e152, _e155, (_e155 < _e152));
                                    break;
                                }
                                case 2: {
                                    phi_469_ = false;
                                    phi_470_ = select(_e155, _e152, (_e155 < _e152));
                                    break;
                                }
                                case 3: {
                                    if (_e152 < 5u) {
                                        phi_461_ = 5u;
                                    } else {
                                        phi_461_ = select(_e152, 1000u, (_e152 > 1000u));
                                    }
                                    let _e371 = phi_461_;
                                    phi_469_ = false;
                                    phi_470_ = _e371;
                                    break;
                                }
                                case 4: {
                                    if (_e152 < _e155) {
                                        phi_454_ = (_e155 - _e152);
                                    } else {
                                        phi_454_ = (_e152 - _e155);
                                    }
                                    let _e366 = phi_454_;
                                    phi_469_ = false;
                                    phi_470_ = _e366;
                                    break;
                                }
                                case 5: {
                                    phi_469_ = false;
                                    phi_470_ = (countOneBits(_e152) + (100u * countOneBits(~(_e152))));
                                    break;
                                }
                                case 6: {
                                    let _e351 = (_e152 == 0u);
                                    phi_469_ = false;
                                    phi_470_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e152)), 32u, _e351) + (100u * select(firstTrailingBit(_e152), 32u, _e351)));
                                    break;
                                }
                                case 7: {
                                    let _e338 = ~(_e152);
                                    let _e342 = (_e338 == 0u);
                                    phi_469_ = false;
                                    phi_470_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, _e342) + (100u * select(firstTrailingBit(_e338), 32u, _e342)));
                                    break;
                                }
                                case 8: {
                                    let _e329 = (_e164 & 31u);
                                    phi_469_ = false;
                                    phi_470_ = select(((_e152 << bitcast<u32>(_e329)) | (_e152 >> bitcast<u32>((32u - _e329)))), _e152, (_e329 == 0u));
                                    break;
                                }
                                case 9: {
                                    let _e320 = (_e164 & 31u);
                                    phi_469_ = false;
                                    phi_470_ = select(((_e152 >> bitcast<u32>(_e320)) | (_e152 << bitcast<u32>((32u - _e320)))), _e152, (_e320 == 0u));
                                    break;
                                }
                                case 10: {
                                    phi_469_ = false;
                                    phi_470_ = (((_e152 >> bitcast<u32>(24u)) | ((_e152 >> bitcast<u32>(8u)) & 65280u)) | (((_e152 << bitcast<u32>(8u)) & 16711680u) | (_e152 << bitcast<u32>(24u))));
                                    break;
                                }
                                case 11: {
                                    phi_469_ = false;
                                    phi_470_ = reverseBits(_e152);
                                    break;
                                }
                                case 12: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 + _e155);
                                    break;
                                }
                                case 13: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 - _e155);
                                    break;
                                }
                                case 14: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 * _e155);
                                    break;
                                }
                                case 15: {
                                    phi_469_ = false;
                                    phi_470_ = (0u - _e152);
                                    break;
                                }
                                case 16: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 << bitcast<u32>((_e155 & 31u)));
                                    break;
                                }
                                case 17: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 >> bitcast<u32>((_e155 & 31u)));
                                    break;
                                }
                                case 18: {
                                    let _e282 = (_e152 + _e155);
                                    if select(false, true, (_e282 < _e152)) {
                                        phi_388_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_388_ = type_26(1u, _e282);
                                    }
                                    let _e290 = phi_388_;
                                    phi_469_ = false;
                                    phi_470_ = select(77u, _e290.member_1, (bitcast<i32>(_e290.member) != 0i));
                                    break;
                                }
                                case 19: {
                                    if (_e152 < _e155) {
                                        phi_374_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_374_ = type_26(1u, (_e152 - _e155));
                                    }
                                    let _e276 = phi_374_;
                                    phi_469_ = false;
                                    phi_470_ = select(77u, _e276.member_1, (bitcast<i32>(_e276.member) != 0i));
                                    break;
                                }
                                case 20: {
                                    if select(false, true, (_e155 == 0u)) {
                                        phi_361_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_361_ = type_26(1u, (_e152 / _e155));
                                    }
                                    let _e263 = phi_361_;
                                    phi_469_ = false;
                                    phi_470_ = select(77u, _e263.member_1, (bitcast<i32>(_e263.member) != 0i));
                                    break;
                                }
                                case 21: {
                                    if select(false, true, (_e155 == 0u)) {
                                        phi_347_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_347_ = type_26(1u, (_e152 % _e155));
                                    }
                                    let _e249 = phi_347_;
                                    phi_469_ = false;
                                    phi_470_ = select(77u, _e249.member_1, (bitcast<i32>(_e249.member) != 0i));
                                    break;
                                }
                                case 22: {
                                    let _e226 = (_e155 % 64u);
                                    if (_e226 < 32u) {
                                        phi_333_ = type_26(1u, (_e152 << bitcast<u32>(_e226)));
                                    } else {
                                        phi_333_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e235 = phi_333_;
                                    phi_469_ = false;
                                    phi_470_ = select(77u, _e235.member_1, (bitcast<i32>(_e235.member) != 0i));
                                    break;
                                }
                                case 23: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 + _e155);
                                    break;
                                }
                                case 24: {
                                    phi_469_ = false;
                                    phi_470_ = select(0u, 1u, ((_e152 - _e155) > _e152));
                                    break;
                                }
                                case 25: {
                                    phi_469_ = false;
                                    phi_470_ = select(0u, 1u, (countOneBits(_e152) == 1u));
                                    break;
                                }
                                case 26: {
                                    let _e207 = (_e152 % 1000u);
                                    if (_e207 <= 1u) {
                                        phi_316_ = 0u;
                                    } else {
                                        phi_316_ = (4294967295u >> bitcast<u32>(((bitcast<u32>(31i) - firstLeadingBit((_e207 - 1u))) & 31u)));
                                    }
                                    let _e217 = phi_316_;
                                    phi_469_ = false;
                                    phi_470_ = (_e217 + 1u);
                                    break;
                                }
                                case 27: {
                                    let _e199 = (_e155 | 1u);
                                    let _e200 = (_e199 == 0u);
                                    if _e200 {
                                        phi_469_ = true;
                                        phi_470_ = u32();
                                        break;
                                    }
                                    let _e201 = (_e152 / _e199);
                                    if _e200 {
                                        phi_469_ = true;
                                        phi_470_ = u32();
                                        break;
                                    }
                                    if ((_e152 % _e199) > 0u) {
                                        phi_305_ = (_e201 + 1u);
                                    } else {
                                        phi_305_ = _e201;
                                    }
                                    let _e206 = phi_305_;
                                    phi_469_ = false;
                                    phi_470_ = _e206;
                                    break;
                                }
                                case 28: {
                                    let _e192 = (_e152 % 1000u);
                                    let _e193 = (_e192 % 7u);
                                    if (_e193 == 0u) {
                                        phi_291_ = _e192;
                                    } else {
                                        phi_291_ = (_e192 + (7u - _e193));
                                    }
                                    let _e198 = phi_291_;
                                    phi_469_ = false;
                                    phi_470_ = _e198;
                                    break;
                                }
                                case 29: {
                                    let _e177 = (_e152 | 1u);
                                    if (select(1i, 0i, (_e177 == 0u)) != 0i) {
                                        phi_276_ = type_26(1u, firstLeadingBit(_e177));
                                    } else {
                                        phi_276_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e187 = phi_276_;
                                    if (bitcast<i32>(_e187.member) != 0i) {
                                    } else {
                                        phi_469_ = true;
                                        phi_470_ = u32();
                                        break;
                                    }
                                    phi_469_ = false;
                                    phi_470_ = _e187.member_1;
                                    break;
                                }
                                case 30: {
                                    phi_469_ = false;
                                    phi_470_ = bitcast<u32>(bitcast<i32>(_e152));
                                    break;
                                }
                                case 31: {
                                    let _e172 = (_e155 | 1u);
                                    if (_e172 == 0u) {
                                        phi_469_ = true;
                                        phi_470_ = u32();
                                        break;
                                    }
                                    phi_469_ = false;
                                    phi_470_ = (_e152 % _e172);
                                    break;
                                }
                                case 32: {
                                    let _e169 = (_e155 | 1u);
                                    if (_e169 == 0u) {
                                        phi_469_ = true;
                                        phi_470_ = u32();
                                        break;
                                    }
                                    phi_469_ = false;
                                    phi_470_ = (_e152 / _e169);
                                    break;
                                }
                                case 33: {
                                    phi_469_ = false;
                                    phi_470_ = select(0u, 1u, ((_e152 % 3u) == 0u));
                                    break;
                                }
                                default: {
                                    phi_469_ = false;
                                    phi_470_ = (_e152 + bitcast<u32>(bitcast<i32>(_e155)));
                                    break;
                                }
                            }
                            let _e380 = phi_469_;
                            let _e382 = phi_470_;
                            if _e380 {
                                break;
                            }
                            phi_472_ = _e380;
                            phi_473_ = _e382;
                        } else {
                            phi_472_ = false;
                            phi_473_ = u32();
                        }
                        let _e384 = phi_472_;
                        let _e386 = phi_473_;
                        phi_475_ = _e384;
                        phi_476_ = _e386;
                        phi_477_ = select(true, false, _e163);
                    } else {
                        phi_475_ = false;
                        phi_476_ = u32();
                        phi_477_ = true;
                    }
                    let _e389 = phi_475_;
                    let _e391 = phi_476_;
                    let _e393 = phi_477_;
                    if _e393 {
                        if (35u <= _e147) {
                            let _e395 = (_e147 <= 49u);
                            if _e395 {
                                let _e396 = bitcast<i32>(_e152);
                                let _e397 = bitcast<i32>(_e155);
                                switch bitcast<i32>(_e147) {
                                    case 35: {
                                        if (_e396 < 0i) {
                                            phi_625_ = (0i - _e396);
                                        } else {
                                            phi_625_ = _e396;
                                        }
                                        let _e505 = phi_625_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e505;
                                        break;
                                    }
                                    case 36: {
                                        if (_e396 < 0i) {
                                            phi_617_ = (0i - _e396);
                                        } else {
                                            phi_617_ = _e396;
                                        }
                                        let _e499 = phi_617_;
                                        phi_647_ = _e389;
                                        phi_648_ = bitcast<i32>(bitcast<u32>(_e499));
                                        break;
                                    }
                                    case 37: {
                                        phi_647_ = _e389;
                                        phi_648_ = bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e396 != 0i)), 255i, (_e396 < 0i))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                        break;
                                    }
                                    case 38: {
                                        phi_647_ = _e389;
                                        phi_648_ = (select(0i, 1i, (_e396 < 0i)) + (2i * select(0i, 1i, (_e396 > 0i))));
                                        break;
                                    }
                                    case 39: {
                                        let _e472 = (_e396 - (1000i * (_e396 / 1000i)));
                                        let _e475 = (_e472 - (7i * (_e472 / 7i)));
                                        if (_e475 < 0i) {
                                            phi_597_ = (_e475 + 7i);
                                        } else {
                                            phi_597_ = _e475;
                                        }
                                        let _e479 = phi_597_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e479;
                                        break;
                                    }
                                    case 40: {
                                        let _e461 = (_e396 - (1000i * (_e396 / 1000i)));
                                        let _e462 = (_e461 / 7i);
                                        if ((_e461 - (7i * (_e461 / 7i))) < 0i) {
                                            phi_585_ = (_e462 - 1i);
                                        } else {
                                            phi_585_ = _e462;
                                        }
                                        let _e469 = phi_585_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e469;
                                        break;
                                    }
                                    case 41: {
                                        if (_e396 < _e397) {
                                            phi_571_ = (bitcast<u32>(_e397) - bitcast<u32>(_e396));
                                        } else {
                                            phi_571_ = (bitcast<u32>(_e396) - bitcast<u32>(_e397));
                                        }
                                        let _e457 = phi_571_;
                                        phi_647_ = _e389;
                                        phi_648_ = bitcast<i32>(_e457);
                                        break;
                                    }
                                    case 42: {
                                        if select(false, true, (_e396 == i32(-2147483648))) {
                                            phi_546_ = type_27(i32(-2147483648), true);
                                        } else {
                                            phi_546_ = type_27(-(_e396), false);
                                        }
                                        let _e434 = phi_546_;
                                        if select(false, true, _e434.member_1) {
                                            phi_555_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_555_ = type_28(1u, _e434.member);
                                        }
                                        let _e443 = phi_555_;
                                        phi_647_ = _e389;
                                        phi_648_ = select(77i, _e443.member_1, (bitcast<i32>(_e443.member) != 0i));
                                        break;
                                    }
                                    case 43: {
                                        phi_647_ = _e389;
                                        phi_648_ = (0i - _e396);
                                        break;
                                    }
                                    case 44: {
                                        let _e424 = (_e397 < _e396);
                                        phi_647_ = _e389;
                                        phi_648_ = (select(_e396, _e397, _e424) ^ select(_e397, _e396, _e424));
                                        break;
                                    }
                                    case 45: {
                                        if (_e396 < -100i) {
                                            phi_533_ = -100i;
                                        } else {
                                            phi_533_ = select(_e396, 100i, (_e396 > 100i));
                                        }
                                        let _e423 = phi_533_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e423;
                                        break;
                                    }
                                    case 46: {
                                        let _e414 = (_e396 - (1000i * (_e396 / 1000i)));
                                        if (_e414 < 0i) {
                                            phi_526_ = -(_e414);
                                        } else {
                                            phi_526_ = _e414;
                                        }
                                        let _e418 = phi_526_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e418;
                                        break;
                                    }
                                    case 47: {
                                        phi_647_ = _e389;
                                        phi_648_ = (_e396 >> bitcast<u32>(((_e397 & 31i) & 31i)));
                                        break;
                                    }
                                    case 48: {
                                        let _e399 = bitcast<u32>(_e396);
                                        phi_647_ = _e389;
                                        phi_648_ = bitcast<i32>((select((bitcast<u32>(31i) - firstLeadingBit(_e399)), 32u, (_e399 == 0u)) + countOneBits(_e399)));
                                        break;
                                    }
                                    default: {
                                        let _e506 = (_e397 | 1i);
                                        let _e507 = (_e506 == -1i);
                                        if select(false, true, _e507) {
                                            phi_645_ = type_27(0i, (_e396 == i32(-2147483648)));
                                        } else {
                                            if (_e506 == 0i) {
                                                phi_647_ = true;
                                                phi_648_ = i32();
                                                break;
                                            }
                                            if (_e507 && (_e396 == i32(-2147483648))) {
                                                phi_647_ = true;
                                                phi_648_ = i32();
                                                break;
                                            }
                                            phi_645_ = type_27((_e396 - (_e506 * (_e396 / _e506))), false);
                                        }
                                        let _e519 = phi_645_;
                                        phi_647_ = _e389;
                                        phi_648_ = _e519.member;
                                        break;
                                    }
                                }
                                let _e522 = phi_647_;
                                let _e524 = phi_648_;
                                if _e522 {
                                    break;
                                }
                                phi_651_ = _e522;
                                phi_652_ = bitcast<u32>(_e524);
                            } else {
                                phi_651_ = _e389;
                                phi_652_ = u32();
                            }
                            let _e527 = phi_651_;
                            let _e529 = phi_652_;
                            phi_654_ = _e527;
                            phi_655_ = _e529;
                            phi_656_ = select(true, false, _e395);
                        } else {
                            phi_654_ = _e389;
                            phi_655_ = u32();
                            phi_656_ = true;
                        }
                        let _e532 = phi_654_;
                        let _e534 = phi_655_;
                        let _e536 = phi_656_;
                        if _e536 {
                            if (50u <= _e147) {
                                let _e538 = (_e147 <= 62u);
                                if _e538 {
                                    switch bitcast<i32>(_e147) {
                                        case 50: {
                                            let _e648 = ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u);
                                            if _e648 {
                                                phi_791_ = true;
                                            } else {
                                                phi_791_ = (_e161 <= _e158);
                                            }
                                            let _e651 = phi_791_;
                                            if _e648 {
                                                phi_799_ = true;
                                            } else {
                                                phi_799_ = (_e161 <= _e158);
                                            }
                                            let _e657 = phi_799_;
                                            phi_808_ = _e532;
                                            phi_809_ = (bitcast<u32>(abs(select(_e158, _e161, _e651))) | (select(0u, 1u, (select(_e158, _e161, _e657) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 51: {
                                            let _e630 = ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u);
                                            if _e630 {
                                                phi_770_ = true;
                                            } else {
                                                phi_770_ = (_e161 >= _e158);
                                            }
                                            let _e633 = phi_770_;
                                            if _e630 {
                                                phi_778_ = true;
                                            } else {
                                                phi_778_ = (_e161 >= _e158);
                                            }
                                            let _e639 = phi_778_;
                                            phi_808_ = _e532;
                                            phi_809_ = (bitcast<u32>(abs(select(_e158, _e161, _e633))) | (select(0u, 1u, (select(_e158, _e161, _e639) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 52: {
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(abs(_e158));
                                            break;
                                        }
                                        case 53: {
                                            if (-1f <= 1f) {
                                            } else {
                                                phi_808_ = true;
                                                phi_809_ = u32();
                                                break;
                                            }
                                            let _e622 = select(_e158, -1f, (_e158 < -1f));
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(select(_e622, 1f, (_e622 > 1f)));
                                            break;
                                        }
                                        case 54: {
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(bitcast<f32>(((bitcast<u32>(_e158) & 2147483647u) | (bitcast<u32>(_e161) & 2147483648u))));
                                            break;
                                        }
                                        case 55: {
                                            if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
                                                phi_744_ = bitcast<f32>(_e124);
                                            } else {
                                                phi_744_ = bitcast<f32>((1065353216u | (bitcast<u32>(_e158) & 2147483648u)));
                                            }
                                            let _e611 = phi_744_;
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(_e611);
                                            break;
                                        }
                                        case 56: {
                                            phi_808_ = _e532;
                                            phi_809_ = (select(0u, 1u, (abs(_e158) < _e121)) + (4u * select(0u, 1u, ((_e158 == _e121) || (_e158 == _e123)))));
                                            break;
                                        }
                                        case 57: {
                                            let _e588 = ((bitcast<u32>(_e158) & 2147483648u) != 0u);
                                            phi_808_ = _e532;
                                            phi_809_ = (select(0u, 1u, _e588) + (2u * select(0u, 1u, !(_e588))));
                                            break;
                                        }
                                        case 58: {
                                            let _e558 = bitcast<i32>(bitcast<u32>(_e158));
                                            let _e560 = bitcast<i32>(bitcast<u32>(_e161));
                                            let _e567 = (_e558 ^ bitcast<i32>((bitcast<u32>((_e558 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            let _e574 = (_e560 ^ bitcast<i32>((bitcast<u32>((_e560 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e567 != _e574)), 255i, (_e567 < _e574))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))));
                                            break;
                                        }
                                        case 59: {
                                            let _e552 = trunc(_e158);
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(select(_e552, (_e552 - 1f), (_e158 < _e552)));
                                            break;
                                        }
                                        case 60: {
                                            let _e542 = trunc(_e158);
                                            let _e543 = (_e158 - _e542);
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(select(select(_e542, (_e542 + 1f), (0.5f <= _e543)), (_e542 - 1f), (_e543 <= -(0.5f))));
                                            break;
                                        }
                                        case 61: {
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(trunc(_e158));
                                            break;
                                        }
                                        default: {
                                            phi_808_ = _e532;
                                            phi_809_ = bitcast<u32>(select(_e161, _e121, (_e158 > _e161)));
                                            break;
                                        }
                                    }
                                    let _e668 = phi_808_;
                                    let _e670 = phi_809_;
                                    if _e668 {
                                        break;
                                    }
                                    phi_811_ = _e668;
                                    phi_812_ = _e670;
                                } else {
                                    phi_811_ = _e532;
                                    phi_812_ = u32();
                                }
                                let _e672 = phi_811_;
                                let _e674 = phi_812_;
                                phi_814_ = _e672;
                                phi_815_ = _e674;
                                phi_816_ = select(true, false, _e538);
                            } else {
                                phi_814_ = _e532;
                                phi_815_ = u32();
                                phi_816_ = true;
                            }
                            let _e677 = phi_814_;
                            let _e679 = phi_815_;
                            let _e681 = phi_816_;
                            if _e681 {
                                if (63u <= _e147) {
                                    let _e683 = (_e147 <= 83u);
                                    if _e683 {
                                        local[0u] = (_e152 % 100u);
                                        local[1u] = (_e155 % 100u);
                                        local[2u] = 7u;
                                        local[3u] = 3u;
                                        switch bitcast<i32>(_e147) {
                                            case 63: {
                                                if (_e152 > _e155) {
                                                    phi_1133_ = type_26(1u, 5u);
                                                } else {
                                                    phi_1133_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e940 = phi_1133_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = select(6u, _e940.member_1, (bitcast<i32>(_e940.member) != 0i));
                                                break;
                                            }
                                            case 64: {
                                                if (_e152 > _e155) {
                                                    phi_1122_ = type_26(1u, (_e152 - _e155));
                                                } else {
                                                    phi_1122_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e929 = phi_1122_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = select(6u, _e929.member_1, (bitcast<i32>(_e929.member) != 0i));
                                                break;
                                            }
                                            case 65: {
                                                if (_e152 > _e155) {
                                                    phi_1105_ = type_26(1u, _e152);
                                                } else {
                                                    phi_1105_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e914 = phi_1105_;
                                                if (bitcast<i32>(_e914.member) != 0i) {
                                                    phi_1114_ = (_e914.member_1 - _e155);
                                                } else {
                                                    phi_1114_ = 3u;
                                                }
                                                let _e921 = phi_1114_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e921;
                                                break;
                                            }
                                            case 66: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = (_e152 ^ _e155);
                                                break;
                                            }
                                            case 67: {
                                                if (_e152 < _e155) {
                                                    phi_1076_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1076_ = type_26(1u, (_e152 - _e155));
                                                }
                                                let _e885 = phi_1076_;
                                                if (bitcast<i32>(_e885.member) != 0i) {
                                                    if (_e885.member_1 < 10u) {
                                                        phi_1092_ = type_26(0u, type_26().member_1);
                                                    } else {
                                                        phi_1092_ = type_26(1u, (_e885.member_1 - 10u));
                                                    }
                                                    let _e900 = phi_1092_;
                                                    phi_1093_ = _e900;
                                                } else {
                                                    phi_1093_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e902 = phi_1093_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = select(0u, 1u, (bitcast<i32>(_e902.member) == 1i));
                                                break;
                                            }
                                            case 68: {
                                                if (_e152 < _e155) {
                                                    phi_1058_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1058_ = type_26(1u, (_e152 - _e155));
                                                }
                                                let _e869 = phi_1058_;
                                                if (bitcast<i32>(_e869.member) != 0i) {
                                                    phi_1067_ = type_26(0u, _e869.member_1);
                                                } else {
                                                    phi_1067_ = type_26(1u, 4u);
                                                }
                                                let _e876 = phi_1067_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e876.member_1;
                                                break;
                                            }
                                            case 69: {
                                                let _e838 = select(select(0i, 1i, (_e152 != _e155)), 255i, (_e152 < _e155));
                                                switch _e838 {
                                                    case 255: {
                                                        phi_1035_ = 1i;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_1035_ = 0i;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1035_ = 255i;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1035_ = i32();
                                                        break;
                                                    }
                                                }
                                                let _e840 = phi_1035_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e840) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (5i * select(0i, 1i, (((bitcast<i32>(_e838) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>(0i) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))))));
                                                break;
                                            }
                                            case 70: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = (_e155 - (_e152 * 2u));
                                                break;
                                            }
                                            case 71: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = (_e152 + (_e155 * 3u));
                                                break;
                                            }
                                            case 72: {
                                                let _e825 = local[0u];
                                                let _e826 = local[1u];
                                                let _e827 = local[2u];
                                                phi_1180_ = _e677;
                                                phi_1181_ = ((_e825 + (1000u * _e826)) + _e827);
                                                break;
                                            }
                                            case 73: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = ((_e155 + _e152) * (1u + _e152));
                                                break;
                                            }
                                            case 74: {
                                                if select(true, false, (_e152 <= 9u)) {
                                                    if ((_e152 % 2u) == 0u) {
                                                        phi_1011_ = 2u;
                                                    } else {
                                                        switch bitcast<i32>(_e152) {
                                                            case 11: {
                                                                phi_1009_ = true;
                                                                break;
                                                            }
                                                            case 13: {
                                                                phi_1009_ = true;
                                                                break;
                                                            }
                                                            case 15: {
                                                                phi_1009_ = true;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1009_ = false;
                                                                break;
                                                            }
                                                        }
                                                        let _e816 = phi_1009_;
                                                        phi_1011_ = select(4u, 3u, _e816);
                                                    }
                                                    let _e819 = phi_1011_;
                                                    phi_1012_ = _e819;
                                                } else {
                                                    phi_1012_ = 1u;
                                                }
                                                let _e821 = phi_1012_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e821;
                                                break;
                                            }
                                            case 75: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = select(0u, (_e152 / 3u), ((_e152 % 3u) == 1u));
                                                break;
                                            }
                                            case 76: {
                                                phi_1180_ = _e677;
                                                phi_1181_ = (select(0u, 1u, (_e152 > _e155)) + 1u);
                                                break;
                                            }
                                            case 77: {
                                                let _e799 = (_e155 % 4u);
                                                if (_e799 < 4u) {
                                                } else {
                                                    phi_1180_ = true;
                                                    phi_1181_ = u32();
                                                    break;
                                                }
                                                let _e802 = local[_e799];
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e802;
                                                break;
                                            }
                                            case 78: {
                                                switch select(select(0i, 1i, (_e152 != _e155)), 255i, (_e152 < _e155)) {
                                                    case 255: {
                                                        phi_980_ = 10u;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_980_ = 20u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_980_ = 30u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_980_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e798 = phi_980_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e798;
                                                break;
                                            }
                                            case 79: {
                                                if (_e152 < 3u) {
                                                    phi_970_ = 100u;
                                                } else {
                                                    if ((_e152 % 2u) == 0u) {
                                                        let _e769 = ((_e152 % 3u) == 0u);
                                                        if _e769 {
                                                            phi_950_ = true;
                                                        } else {
                                                            phi_950_ = (_e152 > 20u);
                                                        }
                                                        let _e772 = phi_950_;
                                                        phi_953_ = select(2000u, 6u, _e769);
                                                        phi_954_ = select(true, false, _e772);
                                                    } else {
                                                        phi_953_ = u32();
                                                        phi_954_ = true;
                                                    }
                                                    let _e776 = phi_953_;
                                                    let _e778 = phi_954_;
                                                    if _e778 {
                                                        switch bitcast<i32>((_e152 % 7u)) {
                                                            case 0: {
                                                                phi_965_ = 7u;
                                                                phi_966_ = false;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_965_ = 77u;
                                                                phi_966_ = select(true, false, (_e152 > 30u));
                                                                break;
                                                            }
                                                            default: {
                                                                phi_965_ = u32();
                                                                phi_966_ = true;
                                                                break;
                                                            }
                                                        }
                                                        let _e784 = phi_965_;
                                                        let _e786 = phi_966_;
                                                        phi_969_ = select(_e152, _e784, select(true, false, _e786));
                                                    } else {
                                                        phi_969_ = _e776;
                                                    }
                                                    let _e790 = phi_969_;
                                                    phi_970_ = _e790;
                                                }
                                                let _e792 = phi_970_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = _e792;
                                                break;
                                            }
                                            case 80: {
                                                local_1[0u] = 1u;
                                                local_1[1u] = 10u;
                                                local_1[2u] = 100u;
                                                phi_911_ = 0u;
                                                phi_914_ = 0u;
                                                loop {
                                                    let _e744 = phi_911_;
                                                    let _e746 = phi_914_;
                                                    local_19 = _e746;
                                                    if (_e744 < 3u) {
                                                        let _e749 = local_1[_e744];
                                                        let _e751 = local[0u];
                                                        local_16 = (_e744 + 1u);
                                                        local_17 = (_e746 + (_e751 * _e749));
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1345 = local_16;
                                                        phi_911_ = _e1345;
                                                        let _e1348 = local_17;
                                                        phi_914_ = _e1348;
                                                    }
                                                }
                                                let _e754 = local;
                                                local_2 = _e754;
                                                phi_924_ = 0u;
                                                let _e1354 = local_19;
                                                phi_927_ = _e1354;
                                                loop {
                                                    let _e756 = phi_924_;
                                                    let _e758 = phi_927_;
                                                    local_21 = _e758;
                                                    if (_e756 < 4u) {
                                                        let _e761 = local_2[_e756];
                                                        local_18 = (_e756 + 1u);
                                                        local_20 = ((_e758 * 3u) + _e761);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1351 = local_18;
                                                        phi_924_ = _e1351;
                                                        let _e1356 = local_20;
                                                        phi_927_ = _e1356;
                                                    }
                                                }
                                                phi_1180_ = _e677;
                                                let _e1384 = local_21;
                                                phi_1181_ = _e1384;
                                                break;
                                            }
                                            case 81: {
                                                phi_885_ = 0u;
                                                phi_888_ = 0u;
                                                loop {
                                                    let _e722 = phi_885_;
                                                    let _e724 = phi_888_;
                                                    local_13 = _e722;
                                                    if (_e724 < 4u) {
                                                        let _e728 = local[_e724];
                                                        local_11 = (_e722 + _e728);
                                                        local_12 = (_e724 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1331 = local_11;
                                                        phi_885_ = _e1331;
                                                        let _e1334 = local_12;
                                                        phi_888_ = _e1334;
                                                    }
                                                }
                                                let _e1337 = local_13;
                                                phi_896_ = _e1337;
                                                phi_899_ = 0u;
                                                loop {
                                                    let _e731 = phi_896_;
                                                    let _e733 = phi_899_;
                                                    local_22 = _e731;
                                                    if (_e733 < 4u) {
                                                        let _e737 = local[_e733];
                                                        local_14 = (_e731 + (_e737 * _e733));
                                                        local_15 = (_e733 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1339 = local_14;
                                                        phi_896_ = _e1339;
                                                        let _e1342 = local_15;
                                                        phi_899_ = _e1342;
                                                    }
                                                }
                                                phi_1180_ = _e677;
                                                let _e1386 = local_22;
                                                phi_1181_ = _e1386;
                                                break;
                                            }
                                            case 82: {
                                                phi_857_ = 0u;
                                                phi_860_ = _e121;
                                                loop {
                                                    let _e692 = phi_857_;
                                                    let _e694 = phi_860_;
                                                    local_6 = _e694;
                                                    local_7 = _e694;
                                                    local_8 = _e694;
                                                    if (_e692 < 4u) {
                                                        let _e698 = local[_e692];
                                                        let _e699 = f32(_e698);
                                                        local_9 = (_e692 + 1u);
                                                        if ((bitcast<u32>(_e694) & 2147483647u) > 2139095040u) {
                                                            phi_875_ = true;
                                                        } else {
                                                            phi_875_ = (_e699 <= _e694);
                                                        }
                                                        let _e705 = phi_875_;
                                                        local_10 = select(_e694, _e699, _e705);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1321 = local_9;
                                                        phi_857_ = _e1321;
                                                        let _e1324 = local_10;
                                                        phi_860_ = _e1324;
                                                    }
                                                }
                                                let _e710 = local_6;
                                                let _e713 = local_7;
                                                let _e717 = local_8;
                                                phi_1180_ = _e677;
                                                phi_1181_ = select(select(u32(_e710), 0u, !((_e713 >= bitcast<f32>(0u)))), 4294967295u, (_e717 > bitcast<f32>(1333788671u)));
                                                break;
                                            }
                                            default: {
                                                let _e946 = bitcast<i32>(_e152);
                                                let _e948 = select(true, false, (_e946 <= -1i));
                                                if _e948 {
                                                    phi_1147_ = select(100i, 0i, (_e946 == 0i));
                                                } else {
                                                    phi_1147_ = 253i;
                                                }
                                                let _e952 = phi_1147_;
                                                let _e953 = bitcast<i32>(_e155);
                                                if select(true, false, (_e953 <= -1i)) {
                                                    phi_1156_ = select(100i, 0i, (_e953 == 0i));
                                                } else {
                                                    phi_1156_ = 253i;
                                                }
                                                let _e959 = phi_1156_;
                                                if _e948 {
                                                    phi_1171_ = select(100i, 0i, (_e946 == 0i));
                                                } else {
                                                    phi_1171_ = 253i;
                                                }
                                                let _e976 = phi_1171_;
                                                phi_1180_ = _e677;
                                                phi_1181_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e976) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (1000i * select(0i, 1i, (bitcast<i32>(((bitcast<i32>(_e952) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) == bitcast<i32>(((bitcast<i32>(_e959) << bitcast<u32>(24u)) >> bitcast<u32>(24u))))))));
                                                break;
                                            }
                                        }
                                        let _e988 = phi_1180_;
                                        let _e990 = phi_1181_;
                                        if _e988 {
                                            break;
                                        }
                                        phi_1183_ = _e990;
                                    } else {
                                        phi_1183_ = u32();
                                    }
                                    let _e992 = phi_1183_;
                                    phi_1185_ = _e992;
                                    phi_1186_ = select(true, false, _e683);
                                } else {
                                    phi_1185_ = u32();
                                    phi_1186_ = true;
                                }
                                let _e995 = phi_1185_;
                                let _e997 = phi_1186_;
                                if _e997 {
                                    if (84u <= _e147) {
                                        let _e999 = (_e147 <= 93u);
                                        if _e999 {
                                            let _e1000 = bitcast<i32>(_e152);
                                            let _e1001 = bitcast<i32>(_e155);
                                            switch bitcast<i32>(_e147) {
                                                case 84: {
                                                    phi_1321_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1000) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 85: {
                                                    phi_1321_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1000) & bitcast<i32>(65535u))) << bitcast<u32>(16u)) >> bitcast<u32>(16u)));
                                                    break;
                                                }
                                                case 86: {
                                                    phi_1321_ = (bitcast<i32>((bitcast<u32>(_e1000) & 255u)) + bitcast<i32>((bitcast<u32>(_e1001) & 65535u)));
                                                    break;
                                                }
                                                case 87: {
                                                    phi_1321_ = bitcast<i32>((((bitcast<u32>(_e1000) & 255u) + (bitcast<u32>(_e1001) & 255u)) & 255u));
                                                    break;
                                                }
                                                case 88: {
                                                    phi_1321_ = bitcast<i32>(((bitcast<i32>((((bitcast<i32>(_e1000) & bitcast<i32>(255u)) * (bitcast<i32>(_e1001) & bitcast<i32>(255u))) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 89: {
                                                    phi_1321_ = (select(0i, 1i, (((bitcast<i32>((bitcast<i32>(_e1000) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>((bitcast<i32>(_e1001) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))) + (2i * select(0i, 1i, ((bitcast<u32>(_e1000) & 255u) < (bitcast<u32>(_e1001) & 255u)))));
                                                    break;
                                                }
                                                case 90: {
                                                    phi_1321_ = (bitcast<i32>(((bitcast<i32>(((((bitcast<i32>((bitcast<i32>(_e1000) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) >> bitcast<u32>(2i)) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + bitcast<i32>(((bitcast<u32>(_e1000) & 65535u) >> bitcast<u32>(3u))));
                                                    break;
                                                }
                                                case 91: {
                                                    phi_1321_ = (bitcast<i32>((~((bitcast<u32>(_e1000) & 255u)) & 255u)) + bitcast<i32>((((bitcast<u32>(_e1001) & 255u) << bitcast<u32>(3u)) & 255u)));
                                                    break;
                                                }
                                                case 92: {
                                                    switch (bitcast<i32>(_e1000) & bitcast<i32>(255u)) {
                                                        case 0: {
                                                            phi_1219_ = 1i;
                                                            break;
                                                        }
                                                        case 255: {
                                                            phi_1219_ = 2i;
                                                            break;
                                                        }
                                                        case 127: {
                                                            phi_1219_ = 3i;
                                                            break;
                                                        }
                                                        case 128: {
                                                            phi_1219_ = 5i;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1219_ = 4i;
                                                            break;
                                                        }
                                                    }
                                                    let _e1007 = phi_1219_;
                                                    phi_1321_ = _e1007;
                                                    break;
                                                }
                                                default: {
                                                    let _e1126 = (f32(((bitcast<i32>((bitcast<i32>(_e1000) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) * 2f);
                                                    phi_1321_ = select(0i, select(select(i32(_e1126), i32(-2147483648), !((_e1126 >= bitcast<f32>(3472883712u)))), 2147483647i, (_e1126 > bitcast<f32>(1325400063u))), ((bitcast<u32>(_e1126) & 2147483647u) <= 2139095040u));
                                                    break;
                                                }
                                            }
                                            let _e1140 = phi_1321_;
                                            phi_1323_ = bitcast<u32>(_e1140);
                                        } else {
                                            phi_1323_ = u32();
                                        }
                                        let _e1143 = phi_1323_;
                                        phi_1325_ = _e1143;
                                        phi_1326_ = select(true, false, _e999);
                                    } else {
                                        phi_1325_ = u32();
                                        phi_1326_ = true;
                                    }
                                    let _e1146 = phi_1325_;
                                    let _e1148 = phi_1326_;
                                    if _e1148 {
                                        let _e1149 = bitcast<i32>(_e152);
                                        let _e1150 = bitcast<i32>(_e155);
                                        switch bitcast<i32>(_e147) {
                                            case 94: {
                                                let _e1247 = (_e152 + _e155);
                                                phi_1449_ = select(_e1247, 4294967295u, (_e1247 < _e152));
                                                break;
                                            }
                                            case 95: {
                                                if (_e152 < _e155) {
                                                    phi_1443_ = 0u;
                                                } else {
                                                    phi_1443_ = (_e152 - _e155);
                                                }
                                                let _e1246 = phi_1443_;
                                                phi_1449_ = _e1246;
                                                break;
                                            }
                                            case 96: {
                                                let _e1233 = (_e1149 + _e1150);
                                                if (((_e1149 ^ _e1233) & (_e1150 ^ _e1233)) < 0i) {
                                                    phi_1436_ = select(2147483647i, i32(-2147483648), (_e1149 < 0i));
                                                } else {
                                                    phi_1436_ = _e1233;
                                                }
                                                let _e1241 = phi_1436_;
                                                phi_1449_ = bitcast<u32>(_e1241);
                                                break;
                                            }
                                            case 97: {
                                                let _e1223 = (_e1149 - _e1150);
                                                if (((_e1149 ^ _e1150) & (_e1149 ^ _e1223)) < 0i) {
                                                    phi_1424_ = select(2147483647i, i32(-2147483648), (_e1149 < 0i));
                                                } else {
                                                    phi_1424_ = _e1223;
                                                }
                                                let _e1231 = phi_1424_;
                                                phi_1449_ = bitcast<u32>(_e1231);
                                                break;
                                            }
                                            case 98: {
                                                let _e1200 = sqrt(f32(_e152));
                                                let _e1202 = select(65535f, _e1200, (_e1200 < 65535f));
                                                let _e1210 = select(select(u32(_e1202), 0u, !((_e1202 >= bitcast<f32>(0u)))), 4294967295u, (_e1202 > bitcast<f32>(1333788671u)));
                                                if ((_e1210 * _e1210) > _e152) {
                                                    phi_1404_ = (_e1210 - 1u);
                                                } else {
                                                    phi_1404_ = _e1210;
                                                }
                                                let _e1215 = phi_1404_;
                                                if ((_e152 - (_e1215 * _e1215)) > (2u * _e1215)) {
                                                    phi_1413_ = (_e1215 + 1u);
                                                } else {
                                                    phi_1413_ = _e1215;
                                                }
                                                let _e1222 = phi_1413_;
                                                phi_1449_ = _e1222;
                                                break;
                                            }
                                            case 99: {
                                                let _e1179 = (_e152 >> bitcast<u32>(16i));
                                                let _e1180 = (_e152 & 65535u);
                                                let _e1182 = (_e155 >> bitcast<u32>(16i));
                                                let _e1183 = (_e155 & 65535u);
                                                let _e1188 = ((_e1179 * _e1183) + ((_e1180 * _e1183) >> bitcast<u32>(16i)));
                                                phi_1449_ = (((_e1179 * _e1182) + (_e1188 >> bitcast<u32>(16i))) + (((_e1180 * _e1182) + (_e1188 & 65535u)) >> bitcast<u32>(16i)));
                                                break;
                                            }
                                            case 100: {
                                                let _e1157 = (_e152 & 65535u);
                                                let _e1161 = (_e1157 & 32767u);
                                                let _e1163 = (_e1161 << bitcast<u32>(13i));
                                                if (_e1161 < 1024u) {
                                                    phi_1366_ = bitcast<u32>((f32(_e1161) * 0.000000059604645f));
                                                } else {
                                                    if (_e1161 < 31744u) {
                                                        phi_1363_ = (_e1163 + 939524096u);
                                                    } else {
                                                        phi_1363_ = (_e1163 | 2139095040u);
                                                    }
                                                    let _e1169 = phi_1363_;
                                                    phi_1366_ = _e1169;
                                                }
                                                let _e1174 = phi_1366_;
                                                phi_1449_ = bitcast<u32>(bitcast<f32>((((_e1157 & 32768u) << bitcast<u32>(16i)) | _e1174)));
                                                break;
                                            }
                                            case 101: {
                                                phi_1449_ = bitcast<u32>(ceil(_e158));
                                                break;
                                            }
                                            case 102: {
                                                phi_1449_ = select(0u, 1u, (abs(_e158) <= 0x1.fffffep+127f));
                                                break;
                                            }
                                            default: {
                                                phi_1449_ = select(0u, 1u, (_e158 == _e123));
                                                break;
                                            }
                                        }
                                        let _e1253 = phi_1449_;
                                        phi_1450_ = _e1253;
                                    } else {
                                        phi_1450_ = _e1146;
                                    }
                                    let _e1255 = phi_1450_;
                                    phi_1451_ = _e1255;
                                } else {
                                    phi_1451_ = _e995;
                                }
                                let _e1257 = phi_1451_;
                                phi_1452_ = _e1257;
                            } else {
                                phi_1452_ = _e679;
                            }
                            let _e1259 = phi_1452_;
                            phi_1453_ = _e1259;
                        } else {
                            phi_1453_ = _e534;
                        }
                        let _e1261 = phi_1453_;
                        phi_1454_ = _e1261;
                    } else {
                        phi_1454_ = _e391;
                    }
                    let _e1263 = phi_1454_;
                    global_9.member[_e140] = _e1263;
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
