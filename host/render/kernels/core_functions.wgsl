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
    var phi_283_: type_26;
    var phi_298_: u32;
    var phi_312_: u32;
    var phi_323_: u32;
    var phi_340_: type_26;
    var phi_354_: type_26;
    var phi_368_: type_26;
    var phi_381_: type_26;
    var phi_395_: type_26;
    var phi_461_: u32;
    var phi_468_: u32;
    var phi_476_: bool;
    var phi_477_: u32;
    var phi_479_: bool;
    var phi_480_: u32;
    var phi_482_: bool;
    var phi_483_: u32;
    var phi_484_: bool;
    var phi_533_: i32;
    var phi_540_: i32;
    var phi_553_: type_27;
    var phi_562_: type_28;
    var phi_578_: u32;
    var phi_592_: i32;
    var phi_604_: i32;
    var phi_624_: i32;
    var phi_632_: i32;
    var phi_652_: type_27;
    var phi_654_: bool;
    var phi_655_: i32;
    var phi_658_: bool;
    var phi_659_: u32;
    var phi_661_: bool;
    var phi_662_: u32;
    var phi_663_: bool;
    var phi_751_: f32;
    var phi_777_: bool;
    var phi_785_: bool;
    var phi_798_: bool;
    var phi_806_: bool;
    var phi_815_: bool;
    var phi_816_: u32;
    var phi_818_: bool;
    var phi_819_: u32;
    var phi_821_: bool;
    var phi_822_: u32;
    var phi_823_: bool;
    var phi_864_: u32;
    var phi_867_: f32;
    var phi_882_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_892_: u32;
    var phi_895_: u32;
    var phi_903_: u32;
    var phi_906_: u32;
    var phi_918_: u32;
    var phi_921_: u32;
    var phi_931_: u32;
    var phi_934_: u32;
    var phi_957_: bool;
    var phi_960_: u32;
    var phi_961_: bool;
    var phi_972_: u32;
    var phi_973_: bool;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_987_: u32;
    var phi_1016_: bool;
    var phi_1018_: u32;
    var phi_1019_: u32;
    var phi_1042_: i32;
    var phi_1065_: type_26;
    var phi_1074_: type_26;
    var phi_1083_: type_26;
    var phi_1099_: type_26;
    var phi_1100_: type_26;
    var phi_1112_: type_26;
    var phi_1121_: u32;
    var phi_1129_: type_26;
    var phi_1140_: type_26;
    var phi_1154_: i32;
    var phi_1163_: i32;
    var phi_1178_: i32;
    var phi_1187_: bool;
    var phi_1188_: u32;
    var phi_1190_: bool;
    var phi_1191_: u32;
    var phi_1193_: bool;
    var phi_1194_: u32;
    var phi_1195_: bool;
    var phi_1228_: i32;
    var phi_1330_: i32;
    var phi_1332_: u32;
    var phi_1334_: u32;
    var phi_1335_: bool;
    var phi_1380_: u32;
    var phi_1383_: u32;
    var phi_1421_: u32;
    var phi_1430_: u32;
    var phi_1441_: i32;
    var phi_1453_: i32;
    var phi_1460_: u32;
    var phi_1466_: u32;
    var phi_1467_: u32;
    var phi_1469_: u32;
    var phi_1470_: bool;
    var phi_1517_: type_28;
    var phi_1532_: type_28;
    var phi_1547_: type_28;
    var phi_1564_: type_28;
    var phi_1580_: type_28;
    var phi_1595_: type_28;
    var phi_1610_: type_28;
    var phi_1627_: type_28;
    var phi_1644_: type_28;
    var phi_1688_: i32;
    var phi_1690_: i32;
    var phi_1694_: type_27;
    var phi_1710_: type_28;
    var phi_1716_: bool;
    var phi_1717_: i32;
    var phi_1720_: u32;
    var phi_1721_: u32;
    var phi_1722_: u32;
    var phi_1723_: u32;
    var phi_1724_: u32;
    var phi_1725_: u32;
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

    let _e126 = local_3;
    let _e127 = bitcast<f32>(_e126);
    let _e128 = local_4;
    let _e129 = bitcast<f32>(_e128);
    let _e130 = local_5;
    switch bitcast<i32>(0u) {
        default: {
            let _e133 = global;
            let _e134 = global_1;
            let _e135 = global_2;
            global_3[_e133.x] = select(0u, 1u, ((_e133.x % 3u) == 0u));
            workgroupBarrier();
            let _e147 = (((_e134.x + (_e134.y * _e135.x)) * 64u) + _e133.x);
            let _e150 = global_4.member.member;
            if (_e147 >= (_e150 * 121u)) {
            } else {
                let _e153 = (_e150 == 0u);
                if _e153 {
                    break;
                }
                let _e154 = (_e147 / _e150);
                if (_e154 == 0u) {
                    let _e1511 = global_3[(_e133.x ^ 1u)];
                    global_9.member[_e147] = select(0u, 1u, (_e1511 != 0u));
                } else {
                    if _e153 {
                        break;
                    }
                    let _e156 = (_e147 % _e150);
                    let _e159 = global_5.member[_e156];
                    let _e162 = global_6.member[_e156];
                    let _e165 = global_7.member[_e156];
                    let _e168 = global_8.member[_e156];
                    if (1u <= _e154) {
                        let _e170 = (_e154 <= 34u);
                        if _e170 {
                            let _e171 = (_e162 % 32u);
                            switch bitcast<i32>(_e154) {
                                case 1: {
                                    phi_476_ = false;
                                    phi_477_ = select(_e159, _e162, (_e162 < _e159));
                                    break;
                                }
                                case 2: {
                                    phi_476_ = false;
                                    phi_477_ = select(_e162, _e159, (_e162 < _e159));
                                    break;
                                }
                                case 3: {
                                    if (_e159 < 5u) {
                                        phi_468_ = 5u;
                                    } else {
                                        phi_468_ = select(_e159, 1000u, (_e159 > 1000u));
                                    }
                                    let _e378 = phi_468_;
                                    phi_476_ = false;
                                    phi_477_ = _e378;
                                    break;
                                }
                                case 4: {
                                    if (_e159 < _e162) {
                                        phi_461_ = (_e162 - _e159);
                                    } else {
                                        phi_461_ = (_e159 - _e162);
                                    }
                                    let _e373 = phi_461_;
                                    phi_476_ = false;
                                    phi_477_ = _e373;
                                    break;
                                }
                                case 5: {
                                    phi_476_ = false;
                                    phi_477_ = (countOneBits(_e159) + (100u * countOneBits(~(_e159))));
                                    break;
                                }
                                case 6: {
                                    let _e358 = (_e159 == 0u);
                                    phi_476_ = false;
                                    phi_477_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, _e358) + (100u * select(firstTrailingBit(_e159), 32u, _e358)));
                                    break;
                                }
                                case 7: {
                                    let _e345 = ~(_e159);
                                    let _e349 = (_e345 == 0u);
                                    phi_476_ = false;
                                    phi_477_ = (select((bitcast<u32>(31i) - firstLeadingBit(_e345)), 32u, _e349) + (100u * select(firstTrailingBit(_e345), 32u, _e349)));
                                    break;
                                }
                                case 8: {
                                    let _e336 = (_e171 & 31u);
                                    phi_476_ = false;
                                    phi_477_ = select(((_e159 << bitcast<u32>(_e336)) | (_e159 >> bitcast<u32>((32u - _e336)))), _e159, (_e336 == 0u));
                                    break;
                                }
                                case 9: {
                                    let _e327 = (_e171 & 31u);
                                    phi_476_ = false;
                                    phi_477_ = select(((_e159 >> bitcast<u32>(_e327)) | (_e159 << bitcast<u32>((32u - _e327)))), _e159, (_e327 == 0u));
                                    break;
                                }
                                case 10: {
                                    phi_476_ = false;
                                    phi_477_ = (((_e159 >> bitcast<u32>(24u)) | ((_e159 >> bitcast<u32>(8u)) & 65280u)) | (((_e159 << bitcast<u32>(8u)) & 16711680u) | (_e159 << bitcast<u32>(24u))));
                                    break;
                                }
                                case 11: {
                                    phi_476_ = false;
                                    phi_477_ = reverseBits(_e159);
                                    break;
                                }
                                case 12: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 + _e162);
                                    break;
                                }
                                case 13: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 - _e162);
                                    break;
                                }
                                case 14: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 * _e162);
                                    break;
                                }
                                case 15: {
                                    phi_476_ = false;
                                    phi_477_ = (0u - _e159);
                                    break;
                                }
                                case 16: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 << bitcast<u32>((_e162 & 31u)));
                                    break;
                                }
                                case 17: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 >> bitcast<u32>((_e162 & 31u)));
                                    break;
                                }
                                case 18: {
                                    let _e289 = (_e159 + _e162);
                                    if select(false, true, (_e289 < _e159)) {
                                        phi_395_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_395_ = type_26(1u, _e289);
                                    }
                                    let _e297 = phi_395_;
                                    phi_476_ = false;
                                    phi_477_ = select(77u, _e297.member_1, (bitcast<i32>(_e297.member) != 0i));
                                    break;
                                }
                                case 19: {
                                    if (_e159 < _e162) {
                                        phi_381_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_381_ = type_26(1u, (_e159 - _e162));
                                    }
                                    let _e283 = phi_381_;
                                    phi_476_ = false;
                                    phi_477_ = select(77u, _e283.member_1, (bitcast<i32>(_e283.member) != 0i));
                                    break;
                                }
                                case 20: {
                                    if select(false, true, (_e162 == 0u)) {
                                        phi_368_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_368_ = type_26(1u, (_e159 / _e162));
                                    }
                                    let _e270 = phi_368_;
                                    phi_476_ = false;
                                    phi_477_ = select(77u, _e270.member_1, (bitcast<i32>(_e270.member) != 0i));
                                    break;
                                }
                                case 21: {
                                    if select(false, true, (_e162 == 0u)) {
                                        phi_354_ = type_26(0u, type_26().member_1);
                                    } else {
                                        phi_354_ = type_26(1u, (_e159 % _e162));
                                    }
                                    let _e256 = phi_354_;
                                    phi_476_ = false;
                                    phi_477_ = select(77u, _e256.member_1, (bitcast<i32>(_e256.member) != 0i));
                                    break;
                                }
                                case 22: {
                                    let _e233 = (_e162 % 64u);
                                    if (_e233 < 32u) {
                                        phi_340_ = type_26(1u, (_e159 << bitcast<u32>(_e233)));
                                    } else {
                                        phi_340_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e242 = phi_340_;
                                    phi_476_ = false;
                                    phi_477_ = select(77u, _e242.member_1, (bitcast<i32>(_e242.member) != 0i));
                                    break;
                                }
                                case 23: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 + _e162);
                                    break;
                                }
                                case 24: {
                                    phi_476_ = false;
                                    phi_477_ = select(0u, 1u, ((_e159 - _e162) > _e159));
                                    break;
                                }
                                case 25: {
                                    phi_476_ = false;
                                    phi_477_ = select(0u, 1u, (countOneBits(_e159) == 1u));
                                    break;
                                }
                                case 26: {
                                    let _e214 = (_e159 % 1000u);
                                    if (_e214 <= 1u) {
                                        phi_323_ = 0u;
                                    } else {
                                        phi_323_ = (4294967295u >> bitcast<u32>(((bitcast<u32>(31i) - firstLeadingBit((_e214 - 1u))) & 31u)));
                                    }
                                    let _e224 = phi_323_;
                                    phi_476_ = false;
                                    phi_477_ = (_e224 + 1u);
                                    break;
                                }
                                case 27: {
                                    let _e206 = (_e162 | 1u);
                                    let _e207 = (_e206 == 0u);
                                    if _e207 {
                                        phi_476_ = true;
                                        phi_477_ = u32();
                                        break;
                                    }
                                    let _e208 = (_e159 / _e206);
                                    if _e207 {
                                        phi_476_ = true;
                                        phi_477_ = u32();
                                        break;
                                    }
                                    if ((_e159 % _e206) > 0u) {
                                        phi_312_ = (_e208 + 1u);
                                    } else {
                                        phi_312_ = _e208;
                                    }
                                    let _e213 = phi_312_;
                                    phi_476_ = false;
                                    phi_477_ = _e213;
                                    break;
                                }
                                case 28: {
                                    let _e199 = (_e159 % 1000u);
                                    let _e200 = (_e199 % 7u);
                                    if (_e200 == 0u) {
                                        phi_298_ = _e199;
                                    } else {
                                        phi_298_ = (_e199 + (7u - _e200));
                                    }
                                    let _e205 = phi_298_;
                                    phi_476_ = false;
                                    phi_477_ = _e205;
                                    break;
                                }
                                case 29: {
                                    let _e184 = (_e159 | 1u);
                                    if (select(1i, 0i, (_e184 == 0u)) != 0i) {
                                        phi_283_ = type_26(1u, firstLeadingBit(_e184));
                                    } else {
                                        phi_283_ = type_26(0u, type_26().member_1);
                                    }
                                    let _e194 = phi_283_;
                                    if (bitcast<i32>(_e194.member) != 0i) {
                                    } else {
                                        phi_476_ = true;
                                        phi_477_ = u32();
                                        break;
                                    }
                                    phi_476_ = false;
                                    phi_477_ = _e194.member_1;
                                    break;
                                }
                                case 30: {
                                    phi_476_ = false;
                                    phi_477_ = bitcast<u32>(bitcast<i32>(_e159));
                                    break;
                                }
                                case 31: {
                                    let _e179 = (_e162 | 1u);
                                    if (_e179 == 0u) {
                                        phi_476_ = true;
                                        phi_477_ = u32();
                                        break;
                                    }
                                    phi_476_ = false;
                                    phi_477_ = (_e159 % _e179);
                                    break;
                                }
                                case 32: {
                                    let _e176 = (_e162 | 1u);
                                    if (_e176 == 0u) {
                                        phi_476_ = true;
                                        phi_477_ = u32();
                                        break;
                                    }
                                    phi_476_ = false;
                                    phi_477_ = (_e159 / _e176);
                                    break;
                                }
                                case 33: {
                                    phi_476_ = false;
                                    phi_477_ = select(0u, 1u, ((_e159 % 3u) == 0u));
                                    break;
                                }
                                default: {
                                    phi_476_ = false;
                                    phi_477_ = (_e159 + bitcast<u32>(bitcast<i32>(_e162)));
                                    break;
                                }
                            }
                            let _e387 = phi_476_;
                            let _e389 = phi_477_;
                            if _e387 {
                                break;
                            }
                            phi_479_ = _e387;
                            phi_480_ = _e389;
                        } else {
                            phi_479_ = false;
                            phi_480_ = u32();
                        }
                        let _e391 = phi_479_;
                        let _e393 = phi_480_;
                        phi_482_ = _e391;
                        phi_483_ = _e393;
                        phi_484_ = select(true, false, _e170);
                    } else {
                        phi_482_ = false;
                        phi_483_ = u32();
                        phi_484_ = true;
                    }
                    let _e396 = phi_482_;
                    let _e398 = phi_483_;
                    let _e400 = phi_484_;
                    if _e400 {
                        if (35u <= _e154) {
                            let _e402 = (_e154 <= 49u);
                            if _e402 {
                                let _e403 = bitcast<i32>(_e159);
                                let _e404 = bitcast<i32>(_e162);
                                switch bitcast<i32>(_e154) {
                                    case 35: {
                                        if (_e403 < 0i) {
                                            phi_632_ = (0i - _e403);
                                        } else {
                                            phi_632_ = _e403;
                                        }
                                        let _e512 = phi_632_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e512;
                                        break;
                                    }
                                    case 36: {
                                        if (_e403 < 0i) {
                                            phi_624_ = (0i - _e403);
                                        } else {
                                            phi_624_ = _e403;
                                        }
                                        let _e506 = phi_624_;
                                        phi_654_ = _e396;
                                        phi_655_ = bitcast<i32>(bitcast<u32>(_e506));
                                        break;
                                    }
                                    case 37: {
                                        phi_654_ = _e396;
                                        phi_655_ = bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e403 != 0i)), 255i, (_e403 < 0i))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                        break;
                                    }
                                    case 38: {
                                        phi_654_ = _e396;
                                        phi_655_ = (select(0i, 1i, (_e403 < 0i)) + (2i * select(0i, 1i, (_e403 > 0i))));
                                        break;
                                    }
                                    case 39: {
                                        let _e479 = (_e403 - (1000i * (_e403 / 1000i)));
                                        let _e482 = (_e479 - (7i * (_e479 / 7i)));
                                        if (_e482 < 0i) {
                                            phi_604_ = (_e482 + 7i);
                                        } else {
                                            phi_604_ = _e482;
                                        }
                                        let _e486 = phi_604_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e486;
                                        break;
                                    }
                                    case 40: {
                                        let _e468 = (_e403 - (1000i * (_e403 / 1000i)));
                                        let _e469 = (_e468 / 7i);
                                        if ((_e468 - (7i * (_e468 / 7i))) < 0i) {
                                            phi_592_ = (_e469 - 1i);
                                        } else {
                                            phi_592_ = _e469;
                                        }
                                        let _e476 = phi_592_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e476;
                                        break;
                                    }
                                    case 41: {
                                        if (_e403 < _e404) {
                                            phi_578_ = (bitcast<u32>(_e404) - bitcast<u32>(_e403));
                                        } else {
                                            phi_578_ = (bitcast<u32>(_e403) - bitcast<u32>(_e404));
                                        }
                                        let _e464 = phi_578_;
                                        phi_654_ = _e396;
                                        phi_655_ = bitcast<i32>(_e464);
                                        break;
                                    }
                                    case 42: {
                                        if select(false, true, (_e403 == i32(-2147483648))) {
                                            phi_553_ = type_27(i32(-2147483648), true);
                                        } else {
                                            phi_553_ = type_27(-(_e403), false);
                                        }
                                        let _e441 = phi_553_;
                                        if select(false, true, _e441.member_1) {
                                            phi_562_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_562_ = type_28(1u, _e441.member);
                                        }
                                        let _e450 = phi_562_;
                                        phi_654_ = _e396;
                                        phi_655_ = select(77i, _e450.member_1, (bitcast<i32>(_e450.member) != 0i));
                                        break;
                                    }
                                    case 43: {
                                        phi_654_ = _e396;
                                        phi_655_ = (0i - _e403);
                                        break;
                                    }
                                    case 44: {
                                        let _e431 = (_e404 < _e403);
                                        phi_654_ = _e396;
                                        phi_655_ = (select(_e403, _e404, _e431) ^ select(_e404, _e403, _e431));
                                        break;
                                    }
                                    case 45: {
                                        if (_e403 < -100i) {
                                            phi_540_ = -100i;
                                        } else {
                                            phi_540_ = select(_e403, 100i, (_e403 > 100i));
                                        }
                                        let _e430 = phi_540_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e430;
                                        break;
                                    }
                                    case 46: {
                                        let _e421 = (_e403 - (1000i * (_e403 / 1000i)));
                                        if (_e421 < 0i) {
                                            phi_533_ = -(_e421);
                                        } else {
                                            phi_533_ = _e421;
                                        }
                                        let _e425 = phi_533_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e425;
                                        break;
                                    }
                                    case 47: {
                                        phi_654_ = _e396;
                                        phi_655_ = (_e403 >> bitcast<u32>(((_e404 & 31i) & 31i)));
                                        break;
                                    }
                                    case 48: {
                                        let _e406 = bitcast<u32>(_e403);
                                        phi_654_ = _e396;
                                        phi_655_ = bitcast<i32>((select((bitcast<u32>(31i) - firstLeadingBit(_e406)), 32u, (_e406 == 0u)) + countOneBits(_e406)));
                                        break;
                                    }
                                    default: {
                                        let _e513 = (_e404 | 1i);
                                        let _e514 = (_e513 == -1i);
                                        if select(false, true, _e514) {
                                            phi_652_ = type_27(0i, (_e403 == i32(-2147483648)));
                                        } else {
                                            if (_e513 == 0i) {
                                                phi_654_ = true;
                                                phi_655_ = i32();
                                                break;
                                            }
                                            if (_e514 && (_e403 == i32(-2147483648))) {
                                                phi_654_ = true;
                                                phi_655_ = i32();
                                                break;
                                            }
                                            phi_652_ = type_27((_e403 - (_e513 * (_e403 / _e513))), false);
                                        }
                                        let _e526 = phi_652_;
                                        phi_654_ = _e396;
                                        phi_655_ = _e526.member;
                                        break;
                                    }
                                }
                                let _e529 = phi_654_;
                                let _e531 = phi_655_;
                                if _e529 {
                                    break;
                                }
                                phi_658_ = _e529;
                                phi_659_ = bitcast<u32>(_e531);
                            } else {
                                phi_658_ = _e396;
                                phi_659_ = u32();
                            }
                            let _e534 = phi_658_;
                            let _e536 = phi_659_;
                            phi_661_ = _e534;
                            phi_662_ = _e536;
                            phi_663_ = select(true, false, _e402);
                        } else {
                            phi_661_ = _e396;
                            phi_662_ = u32();
                            phi_663_ = true;
                        }
                        let _e539 = phi_661_;
                        let _e541 = phi_662_;
                        let _e543 = phi_663_;
                        if _e543 {
                            if (50u <= _e154) {
                                let _e545 = (_e154 <= 62u);
                                if _e545 {
                                    switch bitcast<i32>(_e154) {
                                        case 50: {
                                            let _e655 = ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u);
                                            if _e655 {
                                                phi_798_ = true;
                                            } else {
                                                phi_798_ = (_e168 <= _e165);
                                            }
                                            let _e658 = phi_798_;
                                            if _e655 {
                                                phi_806_ = true;
                                            } else {
                                                phi_806_ = (_e168 <= _e165);
                                            }
                                            let _e664 = phi_806_;
                                            phi_815_ = _e539;
                                            phi_816_ = (bitcast<u32>(abs(select(_e165, _e168, _e658))) | (select(0u, 1u, (select(_e165, _e168, _e664) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 51: {
                                            let _e637 = ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u);
                                            if _e637 {
                                                phi_777_ = true;
                                            } else {
                                                phi_777_ = (_e168 >= _e165);
                                            }
                                            let _e640 = phi_777_;
                                            if _e637 {
                                                phi_785_ = true;
                                            } else {
                                                phi_785_ = (_e168 >= _e165);
                                            }
                                            let _e646 = phi_785_;
                                            phi_815_ = _e539;
                                            phi_816_ = (bitcast<u32>(abs(select(_e165, _e168, _e640))) | (select(0u, 1u, (select(_e165, _e168, _e646) < 0f)) << bitcast<u32>(31i)));
                                            break;
                                        }
                                        case 52: {
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(abs(_e165));
                                            break;
                                        }
                                        case 53: {
                                            if (-1f <= 1f) {
                                            } else {
                                                phi_815_ = true;
                                                phi_816_ = u32();
                                                break;
                                            }
                                            let _e629 = select(_e165, -1f, (_e165 < -1f));
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(select(_e629, 1f, (_e629 > 1f)));
                                            break;
                                        }
                                        case 54: {
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(bitcast<f32>(((bitcast<u32>(_e165) & 2147483647u) | (bitcast<u32>(_e168) & 2147483648u))));
                                            break;
                                        }
                                        case 55: {
                                            if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
                                                phi_751_ = bitcast<f32>(_e130);
                                            } else {
                                                phi_751_ = bitcast<f32>((1065353216u | (bitcast<u32>(_e165) & 2147483648u)));
                                            }
                                            let _e618 = phi_751_;
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(_e618);
                                            break;
                                        }
                                        case 56: {
                                            phi_815_ = _e539;
                                            phi_816_ = (select(0u, 1u, (abs(_e165) < _e127)) + (4u * select(0u, 1u, ((_e165 == _e127) || (_e165 == _e129)))));
                                            break;
                                        }
                                        case 57: {
                                            let _e595 = ((bitcast<u32>(_e165) & 2147483648u) != 0u);
                                            phi_815_ = _e539;
                                            phi_816_ = (select(0u, 1u, _e595) + (2u * select(0u, 1u, !(_e595))));
                                            break;
                                        }
                                        case 58: {
                                            let _e565 = bitcast<i32>(bitcast<u32>(_e165));
                                            let _e567 = bitcast<i32>(bitcast<u32>(_e168));
                                            let _e574 = (_e565 ^ bitcast<i32>((bitcast<u32>((_e565 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            let _e581 = (_e567 ^ bitcast<i32>((bitcast<u32>((_e567 >> bitcast<u32>(31i))) >> bitcast<u32>(1i))));
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(bitcast<i32>(((bitcast<i32>(select(select(0i, 1i, (_e574 != _e581)), 255i, (_e574 < _e581))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))));
                                            break;
                                        }
                                        case 59: {
                                            let _e559 = trunc(_e165);
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(select(_e559, (_e559 - 1f), (_e165 < _e559)));
                                            break;
                                        }
                                        case 60: {
                                            let _e549 = trunc(_e165);
                                            let _e550 = (_e165 - _e549);
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(select(select(_e549, (_e549 + 1f), (0.5f <= _e550)), (_e549 - 1f), (_e550 <= -(0.5f))));
                                            break;
                                        }
                                        case 61: {
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(trunc(_e165));
                                            break;
                                        }
                                        default: {
                                            phi_815_ = _e539;
                                            phi_816_ = bitcast<u32>(select(_e168, _e127, (_e165 > _e168)));
                                            break;
                                        }
                                    }
                                    let _e675 = phi_815_;
                                    let _e677 = phi_816_;
                                    if _e675 {
                                        break;
                                    }
                                    phi_818_ = _e675;
                                    phi_819_ = _e677;
                                } else {
                                    phi_818_ = _e539;
                                    phi_819_ = u32();
                                }
                                let _e679 = phi_818_;
                                let _e681 = phi_819_;
                                phi_821_ = _e679;
                                phi_822_ = _e681;
                                phi_823_ = select(true, false, _e545);
                            } else {
                                phi_821_ = _e539;
                                phi_822_ = u32();
                                phi_823_ = true;
                            }
                            let _e684 = phi_821_;
                            let _e686 = phi_822_;
                            let _e688 = phi_823_;
                            if _e688 {
                                if (63u <= _e154) {
                                    let _e690 = (_e154 <= 83u);
                                    if _e690 {
                                        local[0u] = (_e159 % 100u);
                                        local[1u] = (_e162 % 100u);
                                        local[2u] = 7u;
                                        local[3u] = 3u;
                                        switch bitcast<i32>(_e154) {
                                            case 63: {
                                                if (_e159 > _e162) {
                                                    phi_1140_ = type_26(1u, 5u);
                                                } else {
                                                    phi_1140_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e947 = phi_1140_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = select(6u, _e947.member_1, (bitcast<i32>(_e947.member) != 0i));
                                                break;
                                            }
                                            case 64: {
                                                if (_e159 > _e162) {
                                                    phi_1129_ = type_26(1u, (_e159 - _e162));
                                                } else {
                                                    phi_1129_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e936 = phi_1129_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = select(6u, _e936.member_1, (bitcast<i32>(_e936.member) != 0i));
                                                break;
                                            }
                                            case 65: {
                                                if (_e159 > _e162) {
                                                    phi_1112_ = type_26(1u, _e159);
                                                } else {
                                                    phi_1112_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e921 = phi_1112_;
                                                if (bitcast<i32>(_e921.member) != 0i) {
                                                    phi_1121_ = (_e921.member_1 - _e162);
                                                } else {
                                                    phi_1121_ = 3u;
                                                }
                                                let _e928 = phi_1121_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e928;
                                                break;
                                            }
                                            case 66: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = (_e159 ^ _e162);
                                                break;
                                            }
                                            case 67: {
                                                if (_e159 < _e162) {
                                                    phi_1083_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1083_ = type_26(1u, (_e159 - _e162));
                                                }
                                                let _e892 = phi_1083_;
                                                if (bitcast<i32>(_e892.member) != 0i) {
                                                    if (_e892.member_1 < 10u) {
                                                        phi_1099_ = type_26(0u, type_26().member_1);
                                                    } else {
                                                        phi_1099_ = type_26(1u, (_e892.member_1 - 10u));
                                                    }
                                                    let _e907 = phi_1099_;
                                                    phi_1100_ = _e907;
                                                } else {
                                                    phi_1100_ = type_26(0u, type_26().member_1);
                                                }
                                                let _e909 = phi_1100_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = select(0u, 1u, (bitcast<i32>(_e909.member) == 1i));
                                                break;
                                            }
                                            case 68: {
                                                if (_e159 < _e162) {
                                                    phi_1065_ = type_26(0u, type_26().member_1);
                                                } else {
                                                    phi_1065_ = type_26(1u, (_e159 - _e162));
                                                }
                                                let _e876 = phi_1065_;
                                                if (bitcast<i32>(_e876.member) != 0i) {
                                                    phi_1074_ = type_26(0u, _e876.member_1);
                                                } else {
                                                    phi_1074_ = type_26(1u, 4u);
                                                }
                                                let _e883 = phi_1074_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e883.member_1;
                                                break;
                                            }
                                            case 69: {
                                                let _e845 = select(select(0i, 1i, (_e159 != _e162)), 255i, (_e159 < _e162));
                                                switch _e845 {
                                                    case 255: {
                                                        phi_1042_ = 1i;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_1042_ = 0i;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1042_ = 255i;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1042_ = i32();
                                                        break;
                                                    }
                                                }
                                                let _e847 = phi_1042_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e847) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (5i * select(0i, 1i, (((bitcast<i32>(_e845) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>(0i) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))))));
                                                break;
                                            }
                                            case 70: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = (_e162 - (_e159 * 2u));
                                                break;
                                            }
                                            case 71: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = (_e159 + (_e162 * 3u));
                                                break;
                                            }
                                            case 72: {
                                                let _e832 = local[0u];
                                                let _e833 = local[1u];
                                                let _e834 = local[2u];
                                                phi_1187_ = _e684;
                                                phi_1188_ = ((_e832 + (1000u * _e833)) + _e834);
                                                break;
                                            }
                                            case 73: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = ((_e162 + _e159) * (1u + _e159));
                                                break;
                                            }
                                            case 74: {
                                                if select(true, false, (_e159 <= 9u)) {
                                                    if ((_e159 % 2u) == 0u) {
                                                        phi_1018_ = 2u;
                                                    } else {
                                                        switch bitcast<i32>(_e159) {
                                                            case 11: {
                                                                phi_1016_ = true;
                                                                break;
                                                            }
                                                            case 13: {
                                                                phi_1016_ = true;
                                                                break;
                                                            }
                                                            case 15: {
                                                                phi_1016_ = true;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1016_ = false;
                                                                break;
                                                            }
                                                        }
                                                        let _e823 = phi_1016_;
                                                        phi_1018_ = select(4u, 3u, _e823);
                                                    }
                                                    let _e826 = phi_1018_;
                                                    phi_1019_ = _e826;
                                                } else {
                                                    phi_1019_ = 1u;
                                                }
                                                let _e828 = phi_1019_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e828;
                                                break;
                                            }
                                            case 75: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = select(0u, (_e159 / 3u), ((_e159 % 3u) == 1u));
                                                break;
                                            }
                                            case 76: {
                                                phi_1187_ = _e684;
                                                phi_1188_ = (select(0u, 1u, (_e159 > _e162)) + 1u);
                                                break;
                                            }
                                            case 77: {
                                                let _e806 = (_e162 % 4u);
                                                if (_e806 < 4u) {
                                                } else {
                                                    phi_1187_ = true;
                                                    phi_1188_ = u32();
                                                    break;
                                                }
                                                let _e809 = local[_e806];
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e809;
                                                break;
                                            }
                                            case 78: {
                                                switch select(select(0i, 1i, (_e159 != _e162)), 255i, (_e159 < _e162)) {
                                                    case 255: {
                                                        phi_987_ = 10u;
                                                        break;
                                                    }
                                                    case 0: {
                                                        phi_987_ = 20u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_987_ = 30u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_987_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e805 = phi_987_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e805;
                                                break;
                                            }
                                            case 79: {
                                                if (_e159 < 3u) {
                                                    phi_977_ = 100u;
                                                } else {
                                                    if ((_e159 % 2u) == 0u) {
                                                        let _e776 = ((_e159 % 3u) == 0u);
                                                        if _e776 {
                                                            phi_957_ = true;
                                                        } else {
                                                            phi_957_ = (_e159 > 20u);
                                                        }
                                                        let _e779 = phi_957_;
                                                        phi_960_ = select(2000u, 6u, _e776);
                                                        phi_961_ = select(true, false, _e779);
                                                    } else {
                                                        phi_960_ = u32();
                                                        phi_961_ = true;
                                                    }
                                                    let _e783 = phi_960_;
                                                    let _e785 = phi_961_;
                                                    if _e785 {
                                                        switch bitcast<i32>((_e159 % 7u)) {
                                                            case 0: {
                                                                phi_972_ = 7u;
                                                                phi_973_ = false;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_972_ = 77u;
                                                                phi_973_ = select(true, false, (_e159 > 30u));
                                                                break;
                                                            }
                                                            default: {
                                                                phi_972_ = u32();
                                                                phi_973_ = true;
                                                                break;
                                                            }
                                                        }
                                                        let _e791 = phi_972_;
                                                        let _e793 = phi_973_;
                                                        phi_976_ = select(_e159, _e791, select(true, false, _e793));
                                                    } else {
                                                        phi_976_ = _e783;
                                                    }
                                                    let _e797 = phi_976_;
                                                    phi_977_ = _e797;
                                                }
                                                let _e799 = phi_977_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = _e799;
                                                break;
                                            }
                                            case 80: {
                                                local_1[0u] = 1u;
                                                local_1[1u] = 10u;
                                                local_1[2u] = 100u;
                                                phi_918_ = 0u;
                                                phi_921_ = 0u;
                                                loop {
                                                    let _e751 = phi_918_;
                                                    let _e753 = phi_921_;
                                                    local_19 = _e753;
                                                    if (_e751 < 3u) {
                                                        let _e756 = local_1[_e751];
                                                        let _e758 = local[0u];
                                                        local_16 = (_e751 + 1u);
                                                        local_17 = (_e753 + (_e758 * _e756));
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1589 = local_16;
                                                        phi_918_ = _e1589;
                                                        let _e1592 = local_17;
                                                        phi_921_ = _e1592;
                                                    }
                                                }
                                                let _e761 = local;
                                                local_2 = _e761;
                                                phi_931_ = 0u;
                                                let _e1598 = local_19;
                                                phi_934_ = _e1598;
                                                loop {
                                                    let _e763 = phi_931_;
                                                    let _e765 = phi_934_;
                                                    local_21 = _e765;
                                                    if (_e763 < 4u) {
                                                        let _e768 = local_2[_e763];
                                                        local_18 = (_e763 + 1u);
                                                        local_20 = ((_e765 * 3u) + _e768);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1595 = local_18;
                                                        phi_931_ = _e1595;
                                                        let _e1600 = local_20;
                                                        phi_934_ = _e1600;
                                                    }
                                                }
                                                phi_1187_ = _e684;
                                                let _e1628 = local_21;
                                                phi_1188_ = _e1628;
                                                break;
                                            }
                                            case 81: {
                                                phi_892_ = 0u;
                                                phi_895_ = 0u;
                                                loop {
                                                    let _e729 = phi_892_;
                                                    let _e731 = phi_895_;
                                                    local_13 = _e729;
                                                    if (_e731 < 4u) {
                                                        let _e735 = local[_e731];
                                                        local_11 = (_e729 + _e735);
                                                        local_12 = (_e731 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1575 = local_11;
                                                        phi_892_ = _e1575;
                                                        let _e1578 = local_12;
                                                        phi_895_ = _e1578;
                                                    }
                                                }
                                                let _e1581 = local_13;
                                                phi_903_ = _e1581;
                                                phi_906_ = 0u;
                                                loop {
                                                    let _e738 = phi_903_;
                                                    let _e740 = phi_906_;
                                                    local_22 = _e738;
                                                    if (_e740 < 4u) {
                                                        let _e744 = local[_e740];
                                                        local_14 = (_e738 + (_e744 * _e740));
                                                        local_15 = (_e740 + 1u);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1583 = local_14;
                                                        phi_903_ = _e1583;
                                                        let _e1586 = local_15;
                                                        phi_906_ = _e1586;
                                                    }
                                                }
                                                phi_1187_ = _e684;
                                                let _e1630 = local_22;
                                                phi_1188_ = _e1630;
                                                break;
                                            }
                                            case 82: {
                                                phi_864_ = 0u;
                                                phi_867_ = _e127;
                                                loop {
                                                    let _e699 = phi_864_;
                                                    let _e701 = phi_867_;
                                                    local_6 = _e701;
                                                    local_7 = _e701;
                                                    local_8 = _e701;
                                                    if (_e699 < 4u) {
                                                        let _e705 = local[_e699];
                                                        let _e706 = f32(_e705);
                                                        local_9 = (_e699 + 1u);
                                                        if ((bitcast<u32>(_e701) & 2147483647u) > 2139095040u) {
                                                            phi_882_ = true;
                                                        } else {
                                                            phi_882_ = (_e706 <= _e701);
                                                        }
                                                        let _e712 = phi_882_;
                                                        local_10 = select(_e701, _e706, _e712);
                                                        continue;
                                                    } else {
                                                        break;
                                                    }
                                                    continuing {
                                                        let _e1565 = local_9;
                                                        phi_864_ = _e1565;
                                                        let _e1568 = local_10;
                                                        phi_867_ = _e1568;
                                                    }
                                                }
                                                let _e717 = local_6;
                                                let _e720 = local_7;
                                                let _e724 = local_8;
                                                phi_1187_ = _e684;
                                                phi_1188_ = select(select(u32(_e717), 0u, !((_e720 >= bitcast<f32>(0u)))), 4294967295u, (_e724 > bitcast<f32>(1333788671u)));
                                                break;
                                            }
                                            default: {
                                                let _e953 = bitcast<i32>(_e159);
                                                let _e955 = select(true, false, (_e953 <= -1i));
                                                if _e955 {
                                                    phi_1154_ = select(100i, 0i, (_e953 == 0i));
                                                } else {
                                                    phi_1154_ = 253i;
                                                }
                                                let _e959 = phi_1154_;
                                                let _e960 = bitcast<i32>(_e162);
                                                if select(true, false, (_e960 <= -1i)) {
                                                    phi_1163_ = select(100i, 0i, (_e960 == 0i));
                                                } else {
                                                    phi_1163_ = 253i;
                                                }
                                                let _e966 = phi_1163_;
                                                if _e955 {
                                                    phi_1178_ = select(100i, 0i, (_e953 == 0i));
                                                } else {
                                                    phi_1178_ = 253i;
                                                }
                                                let _e983 = phi_1178_;
                                                phi_1187_ = _e684;
                                                phi_1188_ = bitcast<u32>((bitcast<i32>(((bitcast<i32>(_e983) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + (1000i * select(0i, 1i, (bitcast<i32>(((bitcast<i32>(_e959) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) == bitcast<i32>(((bitcast<i32>(_e966) << bitcast<u32>(24u)) >> bitcast<u32>(24u))))))));
                                                break;
                                            }
                                        }
                                        let _e995 = phi_1187_;
                                        let _e997 = phi_1188_;
                                        if _e995 {
                                            break;
                                        }
                                        phi_1190_ = _e995;
                                        phi_1191_ = _e997;
                                    } else {
                                        phi_1190_ = _e684;
                                        phi_1191_ = u32();
                                    }
                                    let _e999 = phi_1190_;
                                    let _e1001 = phi_1191_;
                                    phi_1193_ = _e999;
                                    phi_1194_ = _e1001;
                                    phi_1195_ = select(true, false, _e690);
                                } else {
                                    phi_1193_ = _e684;
                                    phi_1194_ = u32();
                                    phi_1195_ = true;
                                }
                                let _e1004 = phi_1193_;
                                let _e1006 = phi_1194_;
                                let _e1008 = phi_1195_;
                                if _e1008 {
                                    if (84u <= _e154) {
                                        let _e1010 = (_e154 <= 93u);
                                        if _e1010 {
                                            let _e1011 = bitcast<i32>(_e159);
                                            let _e1012 = bitcast<i32>(_e162);
                                            switch bitcast<i32>(_e154) {
                                                case 84: {
                                                    phi_1330_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1011) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 85: {
                                                    phi_1330_ = bitcast<i32>(((bitcast<i32>((bitcast<i32>(_e1011) & bitcast<i32>(65535u))) << bitcast<u32>(16u)) >> bitcast<u32>(16u)));
                                                    break;
                                                }
                                                case 86: {
                                                    phi_1330_ = (bitcast<i32>((bitcast<u32>(_e1011) & 255u)) + bitcast<i32>((bitcast<u32>(_e1012) & 65535u)));
                                                    break;
                                                }
                                                case 87: {
                                                    phi_1330_ = bitcast<i32>((((bitcast<u32>(_e1011) & 255u) + (bitcast<u32>(_e1012) & 255u)) & 255u));
                                                    break;
                                                }
                                                case 88: {
                                                    phi_1330_ = bitcast<i32>(((bitcast<i32>((((bitcast<i32>(_e1011) & bitcast<i32>(255u)) * (bitcast<i32>(_e1012) & bitcast<i32>(255u))) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)));
                                                    break;
                                                }
                                                case 89: {
                                                    phi_1330_ = (select(0i, 1i, (((bitcast<i32>((bitcast<i32>(_e1011) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) < ((bitcast<i32>((bitcast<i32>(_e1012) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)))) + (2i * select(0i, 1i, ((bitcast<u32>(_e1011) & 255u) < (bitcast<u32>(_e1012) & 255u)))));
                                                    break;
                                                }
                                                case 90: {
                                                    phi_1330_ = (bitcast<i32>(((bitcast<i32>(((((bitcast<i32>((bitcast<i32>(_e1011) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) >> bitcast<u32>(2i)) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) + bitcast<i32>(((bitcast<u32>(_e1011) & 65535u) >> bitcast<u32>(3u))));
                                                    break;
                                                }
                                                case 91: {
                                                    phi_1330_ = (bitcast<i32>((~((bitcast<u32>(_e1011) & 255u)) & 255u)) + bitcast<i32>((((bitcast<u32>(_e1012) & 255u) << bitcast<u32>(3u)) & 255u)));
                                                    break;
                                                }
                                                case 92: {
                                                    switch (bitcast<i32>(_e1011) & bitcast<i32>(255u)) {
                                                        case 0: {
                                                            phi_1228_ = 1i;
                                                            break;
                                                        }
                                                        case 255: {
                                                            phi_1228_ = 2i;
                                                            break;
                                                        }
                                                        case 127: {
                                                            phi_1228_ = 3i;
                                                            break;
                                                        }
                                                        case 128: {
                                                            phi_1228_ = 5i;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1228_ = 4i;
                                                            break;
                                                        }
                                                    }
                                                    let _e1018 = phi_1228_;
                                                    phi_1330_ = _e1018;
                                                    break;
                                                }
                                                default: {
                                                    let _e1137 = (f32(((bitcast<i32>((bitcast<i32>(_e1011) & bitcast<i32>(255u))) << bitcast<u32>(24u)) >> bitcast<u32>(24u))) * 2f);
                                                    phi_1330_ = select(0i, select(select(i32(_e1137), i32(-2147483648), !((_e1137 >= bitcast<f32>(3472883712u)))), 2147483647i, (_e1137 > bitcast<f32>(1325400063u))), ((bitcast<u32>(_e1137) & 2147483647u) <= 2139095040u));
                                                    break;
                                                }
                                            }
                                            let _e1151 = phi_1330_;
                                            phi_1332_ = bitcast<u32>(_e1151);
                                        } else {
                                            phi_1332_ = u32();
                                        }
                                        let _e1154 = phi_1332_;
                                        phi_1334_ = _e1154;
                                        phi_1335_ = select(true, false, _e1010);
                                    } else {
                                        phi_1334_ = u32();
                                        phi_1335_ = true;
                                    }
                                    let _e1157 = phi_1334_;
                                    let _e1159 = phi_1335_;
                                    if _e1159 {
                                        if (94u <= _e154) {
                                            let _e1161 = (_e154 <= 103u);
                                            if _e1161 {
                                                let _e1162 = bitcast<i32>(_e159);
                                                let _e1163 = bitcast<i32>(_e162);
                                                switch bitcast<i32>(_e154) {
                                                    case 94: {
                                                        let _e1260 = (_e159 + _e162);
                                                        phi_1466_ = select(_e1260, 4294967295u, (_e1260 < _e159));
                                                        break;
                                                    }
                                                    case 95: {
                                                        if (_e159 < _e162) {
                                                            phi_1460_ = 0u;
                                                        } else {
                                                            phi_1460_ = (_e159 - _e162);
                                                        }
                                                        let _e1259 = phi_1460_;
                                                        phi_1466_ = _e1259;
                                                        break;
                                                    }
                                                    case 96: {
                                                        let _e1246 = (_e1162 + _e1163);
                                                        if (((_e1162 ^ _e1246) & (_e1163 ^ _e1246)) < 0i) {
                                                            phi_1453_ = select(2147483647i, i32(-2147483648), (_e1162 < 0i));
                                                        } else {
                                                            phi_1453_ = _e1246;
                                                        }
                                                        let _e1254 = phi_1453_;
                                                        phi_1466_ = bitcast<u32>(_e1254);
                                                        break;
                                                    }
                                                    case 97: {
                                                        let _e1236 = (_e1162 - _e1163);
                                                        if (((_e1162 ^ _e1163) & (_e1162 ^ _e1236)) < 0i) {
                                                            phi_1441_ = select(2147483647i, i32(-2147483648), (_e1162 < 0i));
                                                        } else {
                                                            phi_1441_ = _e1236;
                                                        }
                                                        let _e1244 = phi_1441_;
                                                        phi_1466_ = bitcast<u32>(_e1244);
                                                        break;
                                                    }
                                                    case 98: {
                                                        let _e1213 = sqrt(f32(_e159));
                                                        let _e1215 = select(65535f, _e1213, (_e1213 < 65535f));
                                                        let _e1223 = select(select(u32(_e1215), 0u, !((_e1215 >= bitcast<f32>(0u)))), 4294967295u, (_e1215 > bitcast<f32>(1333788671u)));
                                                        if ((_e1223 * _e1223) > _e159) {
                                                            phi_1421_ = (_e1223 - 1u);
                                                        } else {
                                                            phi_1421_ = _e1223;
                                                        }
                                                        let _e1228 = phi_1421_;
                                                        if ((_e159 - (_e1228 * _e1228)) > (2u * _e1228)) {
                                                            phi_1430_ = (_e1228 + 1u);
                                                        } else {
                                                            phi_1430_ = _e1228;
                                                        }
                                                        let _e1235 = phi_1430_;
                                                        phi_1466_ = _e1235;
                                                        break;
                                                    }
                                                    case 99: {
                                                        let _e1192 = (_e159 >> bitcast<u32>(16i));
                                                        let _e1193 = (_e159 & 65535u);
                                                        let _e1195 = (_e162 >> bitcast<u32>(16i));
                                                        let _e1196 = (_e162 & 65535u);
                                                        let _e1201 = ((_e1192 * _e1196) + ((_e1193 * _e1196) >> bitcast<u32>(16i)));
                                                        phi_1466_ = (((_e1192 * _e1195) + (_e1201 >> bitcast<u32>(16i))) + (((_e1193 * _e1195) + (_e1201 & 65535u)) >> bitcast<u32>(16i)));
                                                        break;
                                                    }
                                                    case 100: {
                                                        let _e1170 = (_e159 & 65535u);
                                                        let _e1174 = (_e1170 & 32767u);
                                                        let _e1176 = (_e1174 << bitcast<u32>(13i));
                                                        if (_e1174 < 1024u) {
                                                            phi_1383_ = bitcast<u32>((f32(_e1174) * 0.000000059604645f));
                                                        } else {
                                                            if (_e1174 < 31744u) {
                                                                phi_1380_ = (_e1176 + 939524096u);
                                                            } else {
                                                                phi_1380_ = (_e1176 | 2139095040u);
                                                            }
                                                            let _e1182 = phi_1380_;
                                                            phi_1383_ = _e1182;
                                                        }
                                                        let _e1187 = phi_1383_;
                                                        phi_1466_ = bitcast<u32>(bitcast<f32>((((_e1170 & 32768u) << bitcast<u32>(16i)) | _e1187)));
                                                        break;
                                                    }
                                                    case 101: {
                                                        phi_1466_ = bitcast<u32>(ceil(_e165));
                                                        break;
                                                    }
                                                    case 102: {
                                                        phi_1466_ = select(0u, 1u, (abs(_e165) <= 0x1.fffffep+127f));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1466_ = select(0u, 1u, (_e165 == _e129));
                                                        break;
                                                    }
                                                }
                                                let _e1266 = phi_1466_;
                                                phi_1467_ = _e1266;
                                            } else {
                                                phi_1467_ = u32();
                                            }
                                            let _e1268 = phi_1467_;
                                            phi_1469_ = _e1268;
                                            phi_1470_ = select(true, false, _e1161);
                                        } else {
                                            phi_1469_ = u32();
                                            phi_1470_ = true;
                                        }
                                        let _e1271 = phi_1469_;
                                        let _e1273 = phi_1470_;
                                        if _e1273 {
                                            let _e1274 = bitcast<i32>(_e159);
                                            let _e1275 = bitcast<i32>(_e162);
                                            switch bitcast<i32>(_e154) {
                                                case 104: {
                                                    let _e1447 = (_e1275 | 1i);
                                                    let _e1448 = (_e1447 == -1i);
                                                    if select(false, true, _e1448) {
                                                        phi_1694_ = type_27(0i, (_e1274 == i32(-2147483648)));
                                                    } else {
                                                        if (_e1447 == 0i) {
                                                            phi_1716_ = true;
                                                            phi_1717_ = i32();
                                                            break;
                                                        }
                                                        if (_e1448 && (_e1274 == i32(-2147483648))) {
                                                            phi_1716_ = true;
                                                            phi_1717_ = i32();
                                                            break;
                                                        }
                                                        let _e1455 = (_e1274 - (_e1447 * (_e1274 / _e1447)));
                                                        if (_e1455 < 0i) {
                                                            if (_e1447 < 0i) {
                                                                phi_1688_ = (0i - _e1447);
                                                            } else {
                                                                phi_1688_ = _e1447;
                                                            }
                                                            let _e1460 = phi_1688_;
                                                            phi_1690_ = (_e1455 + _e1460);
                                                        } else {
                                                            phi_1690_ = _e1455;
                                                        }
                                                        let _e1463 = phi_1690_;
                                                        phi_1694_ = type_27(_e1463, false);
                                                    }
                                                    let _e1468 = phi_1694_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = _e1468.member;
                                                    break;
                                                }
                                                case 105: {
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = (_e1274 - (3i * (_e1274 / 3i)));
                                                    break;
                                                }
                                                case 106: {
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = (_e1274 - (-4i * (_e1274 / -4i)));
                                                    break;
                                                }
                                                case 107: {
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = (_e1274 - (768i * (_e1274 / 768i)));
                                                    break;
                                                }
                                                case 108: {
                                                    let _e1434 = (_e1274 >> bitcast<u32>(2i));
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = (_e1434 - (5i * (_e1434 / 5i)));
                                                    break;
                                                }
                                                case 109: {
                                                    let _e1416 = (_e1274 + _e1275);
                                                    if select(false, true, ((_e1275 < 0i) == (_e1416 >= _e1274))) {
                                                        phi_1644_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1644_ = type_28(1u, _e1416);
                                                    }
                                                    let _e1427 = phi_1644_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1427.member_1, (bitcast<i32>(_e1427.member) != 0i));
                                                    break;
                                                }
                                                case 110: {
                                                    let _e1399 = (_e1274 - _e1275);
                                                    if select(false, true, ((_e1275 < 0i) == (_e1399 <= _e1274))) {
                                                        phi_1627_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1627_ = type_28(1u, _e1399);
                                                    }
                                                    let _e1410 = phi_1627_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1410.member_1, (bitcast<i32>(_e1410.member) != 0i));
                                                    break;
                                                }
                                                case 111: {
                                                    if select(false, true, (false == (_e1274 >= _e1274))) {
                                                        phi_1610_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1610_ = type_28(1u, _e1274);
                                                    }
                                                    let _e1393 = phi_1610_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1393.member_1, (bitcast<i32>(_e1393.member) != 0i));
                                                    break;
                                                }
                                                case 112: {
                                                    if select(false, true, (false == (_e1274 <= _e1274))) {
                                                        phi_1595_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1595_ = type_28(1u, _e1274);
                                                    }
                                                    let _e1378 = phi_1595_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1378.member_1, (bitcast<i32>(_e1378.member) != 0i));
                                                    break;
                                                }
                                                case 113: {
                                                    if select(false, true, ((_e1275 < 0i) == (_e1275 >= 0i))) {
                                                        phi_1580_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1580_ = type_28(1u, _e1275);
                                                    }
                                                    let _e1363 = phi_1580_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1363.member_1, (bitcast<i32>(_e1363.member) != 0i));
                                                    break;
                                                }
                                                case 114: {
                                                    let _e1336 = (0i - _e1275);
                                                    if select(false, true, ((_e1275 < 0i) == (_e1336 <= 0i))) {
                                                        phi_1564_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1564_ = type_28(1u, _e1336);
                                                    }
                                                    let _e1347 = phi_1564_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1347.member_1, (bitcast<i32>(_e1347.member) != 0i));
                                                    break;
                                                }
                                                case 115: {
                                                    let _e1321 = (_e1274 + 5i);
                                                    if select(false, true, (false == (_e1321 > _e1274))) {
                                                        phi_1547_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1547_ = type_28(1u, _e1321);
                                                    }
                                                    let _e1330 = phi_1547_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1330.member_1, (bitcast<i32>(_e1330.member) != 0i));
                                                    break;
                                                }
                                                case 116: {
                                                    let _e1306 = (_e1274 - i32(-2147483648));
                                                    if select(false, true, (true == (_e1306 < _e1274))) {
                                                        phi_1532_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1532_ = type_28(1u, _e1306);
                                                    }
                                                    let _e1315 = phi_1532_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1315.member_1, (bitcast<i32>(_e1315.member) != 0i));
                                                    break;
                                                }
                                                case 117: {
                                                    let _e1289 = (_e1274 - _e1275);
                                                    if select(false, true, ((_e1275 < 0i) == (_e1274 >= _e1289))) {
                                                        phi_1517_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1517_ = type_28(1u, _e1274);
                                                    }
                                                    let _e1300 = phi_1517_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(77i, _e1300.member_1, (bitcast<i32>(_e1300.member) != 0i));
                                                    break;
                                                }
                                                case 118: {
                                                    let _e1283 = (_e1274 + _e1275);
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(0i, 1i, ((_e1275 < 0i) == (_e1283 >= _e1274)));
                                                    break;
                                                }
                                                case 119: {
                                                    let _e1277 = (_e1274 - _e1275);
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(0i, 1i, ((_e1275 < 0i) == (_e1277 <= _e1274)));
                                                    break;
                                                }
                                                default: {
                                                    let _e1471 = bitcast<i32>(bitcast<u32>(_e1275));
                                                    let _e1472 = (_e1274 + _e1471);
                                                    let _e1473 = (_e1471 < 0i);
                                                    if select(false, true, ((_e1473 == (_e1472 >= _e1274)) != _e1473)) {
                                                        phi_1710_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_1710_ = type_28(1u, _e1472);
                                                    }
                                                    let _e1484 = phi_1710_;
                                                    phi_1716_ = _e1004;
                                                    phi_1717_ = select(0i, 1i, !((bitcast<i32>(_e1484.member) == 1i)));
                                                    break;
                                                }
                                            }
                                            let _e1491 = phi_1716_;
                                            let _e1493 = phi_1717_;
                                            if _e1491 {
                                                break;
                                            }
                                            phi_1720_ = bitcast<u32>(_e1493);
                                        } else {
                                            phi_1720_ = _e1271;
                                        }
                                        let _e1496 = phi_1720_;
                                        phi_1721_ = _e1496;
                                    } else {
                                        phi_1721_ = _e1157;
                                    }
                                    let _e1498 = phi_1721_;
                                    phi_1722_ = _e1498;
                                } else {
                                    phi_1722_ = _e1006;
                                }
                                let _e1500 = phi_1722_;
                                phi_1723_ = _e1500;
                            } else {
                                phi_1723_ = _e686;
                            }
                            let _e1502 = phi_1723_;
                            phi_1724_ = _e1502;
                        } else {
                            phi_1724_ = _e541;
                        }
                        let _e1504 = phi_1724_;
                        phi_1725_ = _e1504;
                    } else {
                        phi_1725_ = _e398;
                    }
                    let _e1506 = phi_1725_;
                    global_9.member[_e147] = _e1506;
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
