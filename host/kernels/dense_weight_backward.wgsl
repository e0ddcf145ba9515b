struct type_6 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
}

struct type_23 {
    member: type_22,
}

struct type_27 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(0) 
var<uniform> global_5: type_23;
@group(0) @binding(1) 
var<storage> global_6: type_12;
@group(0) @binding(4) 
var<storage> global_7: type_6;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_17;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_27;

fn function_() {
    var phi_116_: u32;
    var phi_119_: u32;
    var phi_140_: u32;
    var local: u32;
    var phi_155_: u32;
    var local_1: u32;
    var phi_164_: u32;
    var phi_182_: u32;
    var phi_183_: u32;
    var phi_184_: bool;
    var phi_189_: u32;
    var phi_191_: u32;
    var phi_194_: u32;
    var phi_196_: u32;
    var phi_220_: u32;
    var phi_251_: vec4<f32>;
    var phi_258_: u32;
    var phi_261_: type_21;
    var local_2: type_21;
    var local_3: type_21;
    var local_4: type_21;
    var local_5: type_21;
    var phi_293_: u32;
    var phi_296_: type_21;
    var local_6: type_21;
    var local_7: type_21;
    var local_8: type_21;
    var local_9: type_21;
    var phi_371_: u32;
    var phi_373_: array<u32, 2>;
    var phi_379_: array<u32, 2>;
    var phi_427_: u32;
    var phi_429_: array<u32, 2>;
    var phi_435_: array<u32, 2>;
    var phi_483_: u32;
    var phi_485_: array<u32, 2>;
    var phi_491_: array<u32, 2>;
    var phi_539_: u32;
    var phi_541_: array<u32, 2>;
    var phi_547_: array<u32, 2>;
    var phi_603_: vec4<f32>;
    var phi_614_: vec4<f32>;
    var phi_625_: vec4<f32>;
    var phi_636_: vec4<f32>;
    var phi_643_: type_21;
    var phi_646_: type_21;
    var phi_648_: type_21;
    var phi_650_: type_21;
    var phi_652_: u32;
    var local_10: type_21;
    var local_11: type_21;
    var local_12: type_21;
    var local_13: type_21;
    var local_14: type_21;
    var local_15: type_21;
    var local_16: type_21;
    var local_17: type_21;
    var local_18: type_21;
    var local_19: type_21;
    var local_20: type_21;
    var local_21: type_21;
    var local_22: type_21;
    var local_23: type_21;
    var local_24: type_21;
    var local_25: type_21;
    var phi_748_: type_21;
    var phi_751_: type_21;
    var phi_753_: type_21;
    var phi_755_: type_21;
    var phi_757_: u32;
    var local_26: type_21;
    var local_27: type_21;
    var local_28: type_21;
    var local_29: type_21;
    var phi_884_: u32;
    var phi_886_: array<u32, 2>;
    var phi_892_: array<u32, 2>;
    var phi_940_: u32;
    var phi_942_: array<u32, 2>;
    var phi_948_: array<u32, 2>;
    var phi_996_: u32;
    var phi_998_: array<u32, 2>;
    var phi_1004_: array<u32, 2>;
    var phi_1052_: u32;
    var phi_1054_: array<u32, 2>;
    var phi_1060_: array<u32, 2>;
    var local_30: type_21;
    var local_31: type_21;
    var local_32: type_21;
    var local_33: type_21;
    var phi_1127_: u32;
    var phi_1129_: array<u32, 2>;
    var phi_1135_: array<u32, 2>;
    var phi_1183_: u32;
    var phi_1185_: array<u32, 2>;
    var phi_1191_: array<u32, 2>;
    var phi_1239_: u32;
    var phi_1241_: array<u32, 2>;
    var phi_1247_: array<u32, 2>;
    var phi_1295_: u32;
    var phi_1297_: array<u32, 2>;
    var phi_1303_: array<u32, 2>;
    var local_34: type_21;
    var local_35: type_21;
    var local_36: type_21;
    var local_37: type_21;
    var phi_1370_: u32;
    var phi_1372_: array<u32, 2>;
    var phi_1378_: array<u32, 2>;
    var phi_1426_: u32;
    var phi_1428_: array<u32, 2>;
    var phi_1434_: array<u32, 2>;
    var phi_1482_: u32;
    var phi_1484_: array<u32, 2>;
    var phi_1490_: array<u32, 2>;
    var phi_1538_: u32;
    var phi_1540_: array<u32, 2>;
    var phi_1546_: array<u32, 2>;
    var local_38: type_21;
    var local_39: type_21;
    var local_40: type_21;
    var local_41: type_21;
    var phi_1613_: u32;
    var phi_1615_: array<u32, 2>;
    var phi_1621_: array<u32, 2>;
    var phi_1669_: u32;
    var phi_1671_: array<u32, 2>;
    var phi_1677_: array<u32, 2>;
    var phi_1725_: u32;
    var phi_1727_: array<u32, 2>;
    var phi_1733_: array<u32, 2>;
    var phi_1781_: u32;
    var phi_1783_: array<u32, 2>;
    var phi_1789_: array<u32, 2>;
    var phi_1814_: u32;
    var phi_192_: u32;
    var phi_195_: u32;
    var phi_197_: u32;
    var phi_1815_: bool;
    var local_42: u32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: type_21;
    var local_49: u32;
    var local_50: type_21;
    var local_51: type_21;
    var local_52: type_21;
    var local_53: type_21;
    var local_54: type_21;
    var local_55: type_21;
    var local_56: type_21;
    var local_57: type_21;
    var local_58: type_21;
    var local_59: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = global;
            let _e42 = global_1;
            let _e43 = global_2;
            let _e51 = (((_e42.x + (_e42.y * _e43.x)) * 64u) + _e41.x);
            let _e54 = global_5.member.member_4;
            let _e57 = global_5.member.member_10;
            let _e60 = global_5.member.member_3;
            let _e61 = (_e60 - 1u);
            let _e62 = (_e61 / 4u);
            let _e66 = global_5.member.member_1;
            let _e69 = global_5.member.member;
            let _e70 = (_e66 + _e69);
            let _e73 = (_e66 + (_e42.z * _e57));
            if (_e51 < ((_e62 + 2u) * _e54)) {
                if (_e73 < _e70) {
                    let _e78 = (_e73 + _e57);
                    let _e83 = global_5.member.member_7;
                    phi_116_ = _e83;
                    phi_119_ = 0u;
                    loop {
                        let _e85 = phi_116_;
                        let _e87 = phi_119_;
                        let _e88 = (_e87 + 1u);
                        local = _e87;
                        local_1 = _e88;
                        local_46 = _e87;
                        if (_e88 < _e85) {
                            let _e91 = ((_e87 + _e85) / 2u);
                            let _e94 = global_5.member.member_8;
                            let _e98 = global_6.member[(_e91 * _e94)];
                            let _e101 = global_5.member.member_9;
                            if (_e101 == 0u) {
                                phi_140_ = _e98;
                            } else {
                                let _e105 = global_4.member[_e98];
                                phi_140_ = _e105;
                            }
                            let _e107 = phi_140_;
                            let _e108 = (_e107 <= _e73);
                            local_42 = select(_e91, _e85, _e108);
                            local_43 = select(_e87, _e91, _e108);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1820 = local_42;
                            phi_116_ = _e1820;
                            let _e1823 = local_43;
                            phi_119_ = _e1823;
                        }
                    }
                    let _e113 = global_5.member.member_8;
                    let _e115 = local;
                    let _e119 = global_6.member[(_e115 * _e113)];
                    let _e122 = global_5.member.member_9;
                    let _e123 = (_e122 == 0u);
                    if _e123 {
                        phi_155_ = _e119;
                    } else {
                        let _e126 = global_4.member[_e119];
                        phi_155_ = _e126;
                    }
                    let _e128 = phi_155_;
                    let _e130 = local_1;
                    let _e134 = global_6.member[(_e130 * _e113)];
                    if _e123 {
                        phi_164_ = _e134;
                    } else {
                        let _e137 = global_4.member[_e134];
                        phi_164_ = _e137;
                    }
                    let _e139 = phi_164_;
                    if (_e57 == 0u) {
                        break;
                    }
                    let _e142 = ((_e73 - _e128) % _e57);
                    if (_e42.z == 0u) {
                        phi_183_ = u32();
                        phi_184_ = true;
                    } else {
                        let _e144 = (_e142 == 0u);
                        if _e144 {
                            phi_182_ = u32();
                        } else {
                            let _e146 = ((_e73 - _e142) + _e57);
                            phi_182_ = select(_e139, _e146, (_e146 < _e139));
                        }
                        let _e150 = phi_182_;
                        phi_183_ = _e150;
                        phi_184_ = _e144;
                    }
                    let _e152 = phi_183_;
                    let _e154 = phi_184_;
                    if _e154 {
                        phi_189_ = (_e73 - _e142);
                    } else {
                        phi_189_ = _e152;
                    }
                    let _e157 = phi_189_;
                    phi_191_ = _e139;
                    phi_194_ = _e157;
                    let _e1841 = local_46;
                    phi_196_ = _e1841;
                    loop {
                        let _e159 = phi_191_;
                        let _e161 = phi_194_;
                        let _e163 = phi_196_;
                        phi_1815_ = false;
                        if (_e161 < select(_e70, _e78, (_e78 < _e70))) {
                            if (_e161 == _e159) {
                                let _e1804 = global_6.member[((_e163 + 2u) * _e113)];
                                if _e123 {
                                    phi_1814_ = _e1804;
                                } else {
                                    let _e1807 = global_4.member[_e1804];
                                    phi_1814_ = _e1807;
                                }
                                let _e1809 = phi_1814_;
                                phi_192_ = _e1809;
                                phi_195_ = _e161;
                                phi_197_ = (_e163 + 1u);
                            } else {
                                let _e166 = (_e161 + _e57);
                                let _e168 = select(_e159, _e166, (_e166 < _e159));
                                let _e169 = (_e54 == 0u);
                                if _e169 {
                                    phi_1815_ = true;
                                    break;
                                }
                                let _e170 = (_e51 / _e54);
                                if _e169 {
                                    phi_1815_ = true;
                                    break;
                                }
                                let _e171 = (_e51 % _e54);
                                if (_e161 > _e66) {
                                    phi_220_ = (_e161 - _e66);
                                } else {
                                    phi_220_ = 0u;
                                }
                                let _e175 = phi_220_;
                                let _e176 = (_e168 - _e66);
                                let _e178 = select(_e69, _e176, (_e176 < _e69));
                                let _e181 = global_5.member.member_12;
                                let _e184 = global_5.member.member_11;
                                let _e185 = (_e181 * _e184);
                                let _e187 = ((1u - _e181) * _e184);
                                let _e188 = (_e168 <= _e70);
                                let _e190 = select(false, true, (_e161 < _e66));
                                let _e193 = global_5.member.member_2;
                                let _e195 = ((4u * _e171) * _e193);
                                if (_e170 < (_e62 + 1u)) {
                                    let _e527 = (_e170 * 4u);
                                    let _e530 = global_5.member.member_5;
                                    let _e533 = ((_e530 + (_e527 * _e54)) + _e171);
                                    let _e534 = (_e61 - _e527);
                                    let _e538 = (_e533 + (select(_e534, 1u, (1u < _e534)) * _e54));
                                    let _e542 = (_e533 + (select(_e534, 2u, (2u < _e534)) * _e54));
                                    let _e546 = (_e533 + (select(_e534, 3u, (3u < _e534)) * _e54));
                                    let _e551 = (_e527 * _e193);
                                    let _e552 = (_e527 + 1u);
                                    let _e555 = (select(_e61, _e552, (_e552 < _e61)) * _e193);
                                    let _e556 = (_e527 + 2u);
                                    let _e559 = (select(_e61, _e556, (_e556 < _e61)) * _e193);
                                    let _e560 = (_e527 + 3u);
                                    let _e563 = (select(_e61, _e560, (_e560 < _e61)) * _e193);
                                    if _e190 {
                                        let _e566 = global_8.member[(_e185 + _e533)];
                                        phi_603_ = _e566;
                                    } else {
                                        phi_603_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e568 = phi_603_;
                                    if _e190 {
                                        let _e576 = global_8.member[(_e185 + _e538)];
                                        phi_614_ = _e576;
                                    } else {
                                        phi_614_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e578 = phi_614_;
                                    if _e190 {
                                        let _e586 = global_8.member[(_e185 + _e542)];
                                        phi_625_ = _e586;
                                    } else {
                                        phi_625_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e588 = phi_625_;
                                    if _e190 {
                                        let _e596 = global_8.member[(_e185 + _e546)];
                                        phi_636_ = _e596;
                                    } else {
                                        phi_636_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e598 = phi_636_;
                                    phi_643_ = type_21(_e598.x, _e598.y, _e598.z, _e598.w);
                                    phi_646_ = type_21(_e588.x, _e588.y, _e588.z, _e588.w);
                                    phi_648_ = type_21(_e578.x, _e578.y, _e578.z, _e578.w);
                                    phi_650_ = type_21(_e568.x, _e568.y, _e568.z, _e568.w);
                                    phi_652_ = _e175;
                                    loop {
                                        let _e605 = phi_643_;
                                        let _e607 = phi_646_;
                                        let _e609 = phi_648_;
                                        let _e611 = phi_650_;
                                        let _e613 = phi_652_;
                                        let _e614 = (_e613 + 1u);
                                        local_10 = _e611;
                                        local_11 = _e611;
                                        local_12 = _e611;
                                        local_13 = _e611;
                                        local_14 = _e609;
                                        local_15 = _e609;
                                        local_16 = _e609;
                                        local_17 = _e609;
                                        local_18 = _e607;
                                        local_19 = _e607;
                                        local_20 = _e607;
                                        local_21 = _e607;
                                        local_22 = _e605;
                                        local_23 = _e605;
                                        local_24 = _e605;
                                        local_25 = _e605;
                                        local_59 = _e613;
                                        if (_e614 <= _e178) {
                                            let _e616 = (_e195 + _e613);
                                            let _e619 = global_7.member[_e616];
                                            let _e623 = global_7.member[(_e616 + _e193)];
                                            let _e628 = global_7.member[(_e616 + (2u * _e193))];
                                            let _e633 = global_7.member[(_e616 + (3u * _e193))];
                                            let _e637 = global_3.member[(_e551 + _e613)];
                                            let _e654 = global_3.member[(_e555 + _e613)];
                                            let _e671 = global_3.member[(_e559 + _e613)];
                                            let _e688 = global_3.member[(_e563 + _e613)];
                                            local_51 = type_21(((_e688 * _e619) + _e605.member), ((_e688 * _e623) + _e605.member_1), ((_e688 * _e628) + _e605.member_2), ((_e688 * _e633) + _e605.member_3));
                                            local_52 = type_21(((_e671 * _e619) + _e607.member), ((_e671 * _e623) + _e607.member_1), ((_e671 * _e628) + _e607.member_2), ((_e671 * _e633) + _e607.member_3));
                                            local_53 = type_21(((_e654 * _e619) + _e609.member), ((_e654 * _e623) + _e609.member_1), ((_e654 * _e628) + _e609.member_2), ((_e654 * _e633) + _e609.member_3));
                                            local_54 = type_21(((_e637 * _e619) + _e611.member), ((_e637 * _e623) + _e611.member_1), ((_e637 * _e628) + _e611.member_2), ((_e637 * _e633) + _e611.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1882 = local_51;
                                            phi_643_ = _e1882;
                                            let _e1885 = local_52;
                                            phi_646_ = _e1885;
                                            let _e1888 = local_53;
                                            phi_648_ = _e1888;
                                            let _e1891 = local_54;
                                            phi_650_ = _e1891;
                                            phi_652_ = _e614;
                                        }
                                    }
                                    let _e703 = local_10;
                                    let _e706 = local_11;
                                    let _e709 = local_12;
                                    let _e712 = local_13;
                                    let _e715 = local_14;
                                    let _e718 = local_15;
                                    let _e721 = local_16;
                                    let _e724 = local_17;
                                    let _e727 = local_18;
                                    let _e730 = local_19;
                                    let _e733 = local_20;
                                    let _e736 = local_21;
                                    let _e739 = local_22;
                                    let _e742 = local_23;
                                    let _e745 = local_24;
                                    let _e748 = local_25;
                                    phi_748_ = type_21(0f, 0f, 0f, 0f);
                                    phi_751_ = type_21(0f, 0f, 0f, 0f);
                                    phi_753_ = type_21(0f, 0f, 0f, 0f);
                                    phi_755_ = type_21(0f, 0f, 0f, 0f);
                                    let _e1923 = local_59;
                                    phi_757_ = _e1923;
                                    loop {
                                        let _e751 = phi_748_;
                                        let _e753 = phi_751_;
                                        let _e755 = phi_753_;
                                        let _e757 = phi_755_;
                                        let _e759 = phi_757_;
                                        let _e760 = (_e759 + 1u);
                                        local_26 = _e757;
                                        local_27 = _e757;
                                        local_28 = _e757;
                                        local_29 = _e757;
                                        local_30 = _e755;
                                        local_31 = _e755;
                                        local_32 = _e755;
                                        local_33 = _e755;
                                        local_34 = _e753;
                                        local_35 = _e753;
                                        local_36 = _e753;
                                        local_37 = _e753;
                                        local_38 = _e751;
                                        local_39 = _e751;
                                        local_40 = _e751;
                                        local_41 = _e751;
                                        if (_e760 <= _e178) {
                                            let _e762 = (_e195 + _e759);
                                            let _e765 = global_7.member[_e762];
                                            let _e769 = global_7.member[(_e762 + _e193)];
                                            let _e774 = global_7.member[(_e762 + (2u * _e193))];
                                            let _e779 = global_7.member[(_e762 + (3u * _e193))];
                                            let _e783 = global_3.member[(_e551 + _e759)];
                                            let _e800 = global_3.member[(_e555 + _e759)];
                                            let _e817 = global_3.member[(_e559 + _e759)];
                                            let _e834 = global_3.member[(_e563 + _e759)];
                                            local_55 = type_21(((_e834 * _e765) + _e751.member), ((_e834 * _e769) + _e751.member_1), ((_e834 * _e774) + _e751.member_2), ((_e834 * _e779) + _e751.member_3));
                                            local_56 = type_21(((_e817 * _e765) + _e753.member), ((_e817 * _e769) + _e753.member_1), ((_e817 * _e774) + _e753.member_2), ((_e817 * _e779) + _e753.member_3));
                                            local_57 = type_21(((_e800 * _e765) + _e755.member), ((_e800 * _e769) + _e755.member_1), ((_e800 * _e774) + _e755.member_2), ((_e800 * _e779) + _e755.member_3));
                                            local_58 = type_21(((_e783 * _e765) + _e757.member), ((_e783 * _e769) + _e757.member_1), ((_e783 * _e774) + _e757.member_2), ((_e783 * _e779) + _e757.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1911 = local_55;
                                            phi_748_ = _e1911;
                                            let _e1914 = local_56;
                                            phi_751_ = _e1914;
                                            let _e1917 = local_57;
                                            phi_753_ = _e1917;
                                            let _e1920 = local_58;
                                            phi_755_ = _e1920;
                                            phi_757_ = _e760;
                                        }
                                    }
                                    let _e849 = local_26;
                                    let _e851 = (_e703.member + _e849.member);
                                    let _e853 = local_27;
                                    let _e855 = (_e706.member_1 + _e853.member_1);
                                    let _e857 = local_28;
                                    let _e859 = (_e709.member_2 + _e857.member_2);
                                    let _e861 = local_29;
                                    let _e863 = (_e712.member_3 + _e861.member_3);
                                    if _e188 {
                                        let _e868 = (4u * _e184);
                                        let _e869 = (4u * _e533);
                                        let _e870 = bitcast<u32>(_e851);
                                        let _e873 = ((_e870 >> bitcast<u32>(23i)) & 255u);
                                        if (_e873 == 0u) {
                                        } else {
                                            let _e876 = (_e873 % 16u);
                                            let _e878 = ((_e870 & 8388607u) | 8388608u);
                                            let _e881 = (_e878 << bitcast<u32>((_e876 & 31u)));
                                            let _e887 = ((_e878 >> bitcast<u32>(((31u - _e876) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e870 >> bitcast<u32>(31i)) == 0u) {
                                                phi_886_ = array<u32, 2>(_e881, _e887);
                                            } else {
                                                let _e893 = (~(_e881) + 1u);
                                                if (_e893 == 0u) {
                                                    phi_884_ = (~(_e887) + 1u);
                                                } else {
                                                    phi_884_ = ~(_e887);
                                                }
                                                let _e899 = phi_884_;
                                                phi_886_ = array<u32, 2>(_e893, _e899);
                                            }
                                            let _e902 = phi_886_;
                                            let _e903 = (_e873 < 255u);
                                            if _e903 {
                                                phi_892_ = _e902;
                                            } else {
                                                phi_892_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e906 = phi_892_;
                                            let _e911 = (2u * ((select(16u, (_e873 / 16u), _e903) * _e868) + _e869));
                                            let _e914 = atomicAdd((&global_9.member[_e911]), _e906[0]);
                                            let _e922 = atomicAdd((&global_9.member[(_e911 + 1u)]), (_e906[1] + select(0u, 1u, ((_e914 + _e906[0]) < _e906[0]))));
                                        }
                                        let _e924 = bitcast<u32>(_e855);
                                        let _e927 = ((_e924 >> bitcast<u32>(23i)) & 255u);
                                        if (_e927 == 0u) {
                                        } else {
                                            let _e930 = (_e927 % 16u);
                                            let _e932 = ((_e924 & 8388607u) | 8388608u);
                                            let _e935 = (_e932 << bitcast<u32>((_e930 & 31u)));
                                            let _e941 = ((_e932 >> bitcast<u32>(((31u - _e930) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e924 >> bitcast<u32>(31i)) == 0u) {
                                                phi_942_ = array<u32, 2>(_e935, _e941);
                                            } else {
                                                let _e947 = (~(_e935) + 1u);
                                                if (_e947 == 0u) {
                                                    phi_940_ = (~(_e941) + 1u);
                                                } else {
                                                    phi_940_ = ~(_e941);
                                                }
                                                let _e953 = phi_940_;
                                                phi_942_ = array<u32, 2>(_e947, _e953);
                                            }
                                            let _e956 = phi_942_;
                                            let _e957 = (_e927 < 255u);
                                            if _e957 {
                                                phi_948_ = _e956;
                                            } else {
                                                phi_948_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e960 = phi_948_;
                                            let _e965 = (2u * ((select(16u, (_e927 / 16u), _e957) * _e868) + (_e869 + 1u)));
                                            let _e968 = atomicAdd((&global_9.member[_e965]), _e960[0]);
                                            let _e976 = atomicAdd((&global_9.member[(_e965 + 1u)]), (_e960[1] + select(0u, 1u, ((_e968 + _e960[0]) < _e960[0]))));
                                        }
                                        let _e978 = bitcast<u32>(_e859);
                                        let _e981 = ((_e978 >> bitcast<u32>(23i)) & 255u);
                                        if (_e981 == 0u) {
                                        } else {
                                            let _e984 = (_e981 % 16u);
                                            let _e986 = ((_e978 & 8388607u) | 8388608u);
                                            let _e989 = (_e986 << bitcast<u32>((_e984 & 31u)));
                                            let _e995 = ((_e986 >> bitcast<u32>(((31u - _e984) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e978 >> bitcast<u32>(31i)) == 0u) {
                                                phi_998_ = array<u32, 2>(_e989, _e995);
                                            } else {
                                                let _e1001 = (~(_e989) + 1u);
                                                if (_e1001 == 0u) {
                                                    phi_996_ = (~(_e995) + 1u);
                                                } else {
                                                    phi_996_ = ~(_e995);
                                                }
                                                let _e1007 = phi_996_;
                                                phi_998_ = array<u32, 2>(_e1001, _e1007);
                                            }
                                            let _e1010 = phi_998_;
                                            let _e1011 = (_e981 < 255u);
                                            if _e1011 {
                                                phi_1004_ = _e1010;
                                            } else {
                                                phi_1004_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1014 = phi_1004_;
                                            let _e1019 = (2u * ((select(16u, (_e981 / 16u), _e1011) * _e868) + (_e869 + 2u)));
                                            let _e1022 = atomicAdd((&global_9.member[_e1019]), _e1014[0]);
                                            let _e1030 = atomicAdd((&global_9.member[(_e1019 + 1u)]), (_e1014[1] + select(0u, 1u, ((_e1022 + _e1014[0]) < _e1014[0]))));
                                        }
                                        let _e1032 = bitcast<u32>(_e863);
                                        let _e1035 = ((_e1032 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1035 == 0u) {
                                        } else {
                                            let _e1038 = (_e1035 % 16u);
                                            let _e1040 = ((_e1032 & 8388607u) | 8388608u);
                                            let _e1043 = (_e1040 << bitcast<u32>((_e1038 & 31u)));
                                            let _e1049 = ((_e1040 >> bitcast<u32>(((31u - _e1038) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1032 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1054_ = array<u32, 2>(_e1043, _e1049);
                                            } else {
                                                let _e1055 = (~(_e1043) + 1u);
                                                if (_e1055 == 0u) {
                                                    phi_1052_ = (~(_e1049) + 1u);
                                                } else {
                                                    phi_1052_ = ~(_e1049);
                                                }
                                                let _e1061 = phi_1052_;
                                                phi_1054_ = array<u32, 2>(_e1055, _e1061);
                                            }
                                            let _e1064 = phi_1054_;
                                            let _e1065 = (_e1035 < 255u);
                                            if _e1065 {
                                                phi_1060_ = _e1064;
                                            } else {
                                                phi_1060_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1068 = phi_1060_;
                                            let _e1073 = (2u * ((select(16u, (_e1035 / 16u), _e1065) * _e868) + (_e869 + 3u)));
                                            let _e1076 = atomicAdd((&global_9.member[_e1073]), _e1068[0]);
                                            let _e1084 = atomicAdd((&global_9.member[(_e1073 + 1u)]), (_e1068[1] + select(0u, 1u, ((_e1076 + _e1068[0]) < _e1068[0]))));
                                        }
                                    } else {
                                        global_8.member[(_e187 + _e533)] = vec4<f32>(_e851, _e855, _e859, _e863);
                                    }
                                    if (_e552 < _e60) {
                                        let _e1087 = local_30;
                                        let _e1089 = (_e715.member + _e1087.member);
                                        let _e1091 = local_31;
                                        let _e1093 = (_e718.member_1 + _e1091.member_1);
                                        let _e1095 = local_32;
                                        let _e1097 = (_e721.member_2 + _e1095.member_2);
                                        let _e1099 = local_33;
                                        let _e1101 = (_e724.member_3 + _e1099.member_3);
                                        if _e188 {
                                            let _e1106 = (4u * _e184);
                                            let _e1107 = (4u * _e538);
                                            let _e1108 = bitcast<u32>(_e1089);
                                            let _e1111 = ((_e1108 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1111 == 0u) {
                                            } else {
                                                let _e1114 = (_e1111 % 16u);
                                                let _e1116 = ((_e1108 & 8388607u) | 8388608u);
                                                let _e1119 = (_e1116 << bitcast<u32>((_e1114 & 31u)));
                                                let _e1125 = ((_e1116 >> bitcast<u32>(((31u - _e1114) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1108 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1129_ = array<u32, 2>(_e1119, _e1125);
                                                } else {
                                                    let _e1131 = (~(_e1119) + 1u);
                                                    if (_e1131 == 0u) {
                                                        phi_1127_ = (~(_e1125) + 1u);
                                                    } else {
                                                        phi_1127_ = ~(_e1125);
                                                    }
                                                    let _e1137 = phi_1127_;
                                                    phi_1129_ = array<u32, 2>(_e1131, _e1137);
                                                }
                                                let _e1140 = phi_1129_;
                                                let _e1141 = (_e1111 < 255u);
                                                if _e1141 {
                                                    phi_1135_ = _e1140;
                                                } else {
                                                    phi_1135_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1144 = phi_1135_;
                                                let _e1149 = (2u * ((select(16u, (_e1111 / 16u), _e1141) * _e1106) + _e1107));
                                                let _e1152 = atomicAdd((&global_9.member[_e1149]), _e1144[0]);
                                                let _e1160 = atomicAdd((&global_9.member[(_e1149 + 1u)]), (_e1144[1] + select(0u, 1u, ((_e1152 + _e1144[0]) < _e1144[0]))));
                                            }
                                            let _e1162 = bitcast<u32>(_e1093);
                                            let _e1165 = ((_e1162 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1165 == 0u) {
                                            } else {
                                                let _e1168 = (_e1165 % 16u);
                                                let _e1170 = ((_e1162 & 8388607u) | 8388608u);
                                                let _e1173 = (_e1170 << bitcast<u32>((_e1168 & 31u)));
                                                let _e1179 = ((_e1170 >> bitcast<u32>(((31u - _e1168) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1162 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1185_ = array<u32, 2>(_e1173, _e1179);
                                                } else {
                                                    let _e1185 = (~(_e1173) + 1u);
                                                    if (_e1185 == 0u) {
                                                        phi_1183_ = (~(_e1179) + 1u);
                                                    } else {
                                                        phi_1183_ = ~(_e1179);
                                                    }
                                                    let _e1191 = phi_1183_;
                                                    phi_1185_ = array<u32, 2>(_e1185, _e1191);
                                                }
                                                let _e1194 = phi_1185_;
                                                let _e1195 = (_e1165 < 255u);
                                                if _e1195 {
                                                    phi_1191_ = _e1194;
                                                } else {
                                                    phi_1191_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1198 = phi_1191_;
                                                let _e1203 = (2u * ((select(16u, (_e1165 / 16u), _e1195) * _e1106) + (_e1107 + 1u)));
                                                let _e1206 = atomicAdd((&global_9.member[_e1203]), _e1198[0]);
                                                let _e1214 = atomicAdd((&global_9.member[(_e1203 + 1u)]), (_e1198[1] + select(0u, 1u, ((_e1206 + _e1198[0]) < _e1198[0]))));
                                            }
                                            let _e1216 = bitcast<u32>(_e1097);
                                            let _e1219 = ((_e1216 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1219 == 0u) {
                                            } else {
                                                let _e1222 = (_e1219 % 16u);
                                                let _e1224 = ((_e1216 & 8388607u) | 8388608u);
                                                let _e1227 = (_e1224 << bitcast<u32>((_e1222 & 31u)));
                                                let _e1233 = ((_e1224 >> bitcast<u32>(((31u - _e1222) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1216 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1241_ = array<u32, 2>(_e1227, _e1233);
                                                } else {
                                                    let _e1239 = (~(_e1227) + 1u);
                                                    if (_e1239 == 0u) {
                                                        phi_1239_ = (~(_e1233) + 1u);
                                                    } else {
                                                        phi_1239_ = ~(_e1233);
                                                    }
                                                    let _e1245 = phi_1239_;
                                                    phi_1241_ = array<u32, 2>(_e1239, _e1245);
                                                }
                                                let _e1248 = phi_1241_;
                                                let _e1249 = (_e1219 < 255u);
                                                if _e1249 {
                                                    phi_1247_ = _e1248;
                                                } else {
                                                    phi_1247_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1252 = phi_1247_;
                                                let _e1257 = (2u * ((select(16u, (_e1219 / 16u), _e1249) * _e1106) + (_e1107 + 2u)));
                                                let _e1260 = atomicAdd((&global_9.member[_e1257]), _e1252[0]);
                                                let _e1268 = atomicAdd((&global_9.member[(_e1257 + 1u)]), (_e1252[1] + select(0u, 1u, ((_e1260 + _e1252[0]) < _e1252[0]))));
                                            }
                                            let _e1270 = bitcast<u32>(_e1101);
                                            let _e1273 = ((_e1270 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1273 == 0u) {
                                            } else {
                                                let _e1276 = (_e1273 % 16u);
                                                let _e1278 = ((_e1270 & 8388607u) | 8388608u);
                                                let _e1281 = (_e1278 << bitcast<u32>((_e1276 & 31u)));
                                                let _e1287 = ((_e1278 >> bitcast<u32>(((31u - _e1276) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1270 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1297_ = array<u32, 2>(_e1281, _e1287);
                                                } else {
                                                    let _e1293 = (~(_e1281) + 1u);
                                                    if (_e1293 == 0u) {
                                                        phi_1295_ = (~(_e1287) + 1u);
                                                    } else {
                                                        phi_1295_ = ~(_e1287);
                                                    }
                                                    let _e1299 = phi_1295_;
                                                    phi_1297_ = array<u32, 2>(_e1293, _e1299);
                                                }
                                                let _e1302 = phi_1297_;
                                                let _e1303 = (_e1273 < 255u);
                                                if _e1303 {
                                                    phi_1303_ = _e1302;
                                                } else {
                                                    phi_1303_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1306 = phi_1303_;
                                                let _e1311 = (2u * ((select(16u, (_e1273 / 16u), _e1303) * _e1106) + (_e1107 + 3u)));
                                                let _e1314 = atomicAdd((&global_9.member[_e1311]), _e1306[0]);
                                                let _e1322 = atomicAdd((&global_9.member[(_e1311 + 1u)]), (_e1306[1] + select(0u, 1u, ((_e1314 + _e1306[0]) < _e1306[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e538)] = vec4<f32>(_e1089, _e1093, _e1097, _e1101);
                                        }
                                    }
                                    if (_e556 < _e60) {
                                        let _e1325 = local_34;
                                        let _e1327 = (_e727.member + _e1325.member);
                                        let _e1329 = local_35;
                                        let _e1331 = (_e730.member_1 + _e1329.member_1);
                                        let _e1333 = local_36;
                                        let _e1335 = (_e733.member_2 + _e1333.member_2);
                                        let _e1337 = local_37;
                                        let _e1339 = (_e736.member_3 + _e1337.member_3);
                                        if _e188 {
                                            let _e1344 = (4u * _e184);
                                            let _e1345 = (4u * _e542);
                                            let _e1346 = bitcast<u32>(_e1327);
                                            let _e1349 = ((_e1346 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1349 == 0u) {
                                            } else {
                                                let _e1352 = (_e1349 % 16u);
                                                let _e1354 = ((_e1346 & 8388607u) | 8388608u);
                                                let _e1357 = (_e1354 << bitcast<u32>((_e1352 & 31u)));
                                                let _e1363 = ((_e1354 >> bitcast<u32>(((31u - _e1352) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1346 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1372_ = array<u32, 2>(_e1357, _e1363);
                                                } else {
                                                    let _e1369 = (~(_e1357) + 1u);
                                                    if (_e1369 == 0u) {
                                                        phi_1370_ = (~(_e1363) + 1u);
                                                    } else {
                                                        phi_1370_ = ~(_e1363);
                                                    }
                                                    let _e1375 = phi_1370_;
                                                    phi_1372_ = array<u32, 2>(_e1369, _e1375);
                                                }
                                                let _e1378 = phi_1372_;
                                                let _e1379 = (_e1349 < 255u);
                                                if _e1379 {
                                                    phi_1378_ = _e1378;
                                                } else {
                                                    phi_1378_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1382 = phi_1378_;
                                                let _e1387 = (2u * ((select(16u, (_e1349 / 16u), _e1379) * _e1344) + _e1345));
                                                let _e1390 = atomicAdd((&global_9.member[_e1387]), _e1382[0]);
                                                let _e1398 = atomicAdd((&global_9.member[(_e1387 + 1u)]), (_e1382[1] + select(0u, 1u, ((_e1390 + _e1382[0]) < _e1382[0]))));
                                            }
                                            let _e1400 = bitcast<u32>(_e1331);
                                            let _e1403 = ((_e1400 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1403 == 0u) {
                                            } else {
                                                let _e1406 = (_e1403 % 16u);
                                                let _e1408 = ((_e1400 & 8388607u) | 8388608u);
                                                let _e1411 = (_e1408 << bitcast<u32>((_e1406 & 31u)));
                                                let _e1417 = ((_e1408 >> bitcast<u32>(((31u - _e1406) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1400 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1428_ = array<u32, 2>(_e1411, _e1417);
                                                } else {
                                                    let _e1423 = (~(_e1411) + 1u);
                                                    if (_e1423 == 0u) {
                                                        phi_1426_ = (~(_e1417) + 1u);
                                                    } else {
                                                        phi_1426_ = ~(_e1417);
                                                    }
                                                    let _e1429 = phi_1426_;
                                                    phi_1428_ = array<u32, 2>(_e1423, _e1429);
                                                }
                                                let _e1432 = phi_1428_;
                                                let _e1433 = (_e1403 < 255u);
                                                if _e1433 {
                                                    phi_1434_ = _e1432;
                                                } else {
                                                    phi_1434_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1436 = phi_1434_;
                                                let _e1441 = (2u * ((select(16u, (_e1403 / 16u), _e1433) * _e1344) + (_e1345 + 1u)));
                                                let _e1444 = atomicAdd((&global_9.member[_e1441]), _e1436[0]);
                                                let _e1452 = atomicAdd((&global_9.member[(_e1441 + 1u)]), (_e1436[1] + select(0u, 1u, ((_e1444 + _e1436[0]) < _e1436[0]))));
                                            }
                                            let _e1454 = bitcast<u32>(_e1335);
                                            let _e1457 = ((_e1454 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1457 == 0u) {
                                            } else {
                                                let _e1460 = (_e1457 % 16u);
                                                let _e1462 = ((_e1454 & 8388607u) | 8388608u);
                                                let _e1465 = (_e1462 << bitcast<u32>((_e1460 & 31u)));
                                                let _e1471 = ((_e1462 >> bitcast<u32>(((31u - _e1460) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1454 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1484_ = array<u32, 2>(_e1465, _e1471);
                                                } else {
                                                    let _e1477 = (~(_e1465) + 1u);
                                                    if (_e1477 == 0u) {
                                                        phi_1482_ = (~(_e1471) + 1u);
                                                    } else {
                                                        phi_1482_ = ~(_e1471);
                                                    }
                                                    let _e1483 = phi_1482_;
                                                    phi_1484_ = array<u32, 2>(_e1477, _e1483);
                                                }
                                                let _e1486 = phi_1484_;
                                                let _e1487 = (_e1457 < 255u);
                                                if _e1487 {
                                                    phi_1490_ = _e1486;
                                                } else {
                                                    phi_1490_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1490 = phi_1490_;
                                                let _e1495 = (2u * ((select(16u, (_e1457 / 16u), _e1487) * _e1344) + (_e1345 + 2u)));
                                                let _e1498 = atomicAdd((&global_9.member[_e1495]), _e1490[0]);
                                                let _e1506 = atomicAdd((&global_9.member[(_e1495 + 1u)]), (_e1490[1] + select(0u, 1u, ((_e1498 + _e1490[0]) < _e1490[0]))));
                                            }
                                            let _e1508 = bitcast<u32>(_e1339);
                                            let _e1511 = ((_e1508 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1511 == 0u) {
                                            } else {
                                                let _e1514 = (_e1511 % 16u);
                                                let _e1516 = ((_e1508 & 8388607u) | 8388608u);
                                                let _e1519 = (_e1516 << bitcast<u32>((_e1514 & 31u)));
                                                let _e1525 = ((_e1516 >> bitcast<u32>(((31u - _e1514) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1508 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1540_ = array<u32, 2>(_e1519, _e1525);
                                                } else {
                                                    let _e1531 = (~(_e1519) + 1u);
                                                    if (_e1531 == 0u) {
                                                        phi_1538_ = (~(_e1525) + 1u);
                                                    } else {
                                                        phi_1538_ = ~(_e1525);
                                                    }
                                                    let _e1537 = phi_1538_;
                                                    phi_1540_ = array<u32, 2>(_e1531, _e1537);
                                                }
                                                let _e1540 = phi_1540_;
                                                let _e1541 = (_e1511 < 255u);
                                                if _e1541 {
                                                    phi_1546_ = _e1540;
                                                } else {
                                                    phi_1546_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1544 = phi_1546_;
                                                let _e1549 = (2u * ((select(16u, (_e1511 / 16u), _e1541) * _e1344) + (_e1345 + 3u)));
                                                let _e1552 = atomicAdd((&global_9.member[_e1549]), _e1544[0]);
                                                let _e1560 = atomicAdd((&global_9.member[(_e1549 + 1u)]), (_e1544[1] + select(0u, 1u, ((_e1552 + _e1544[0]) < _e1544[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e542)] = vec4<f32>(_e1327, _e1331, _e1335, _e1339);
                                        }
                                    }
                                    if (_e560 < _e60) {
                                        let _e1563 = local_38;
                                        let _e1565 = (_e739.member + _e1563.member);
                                        let _e1567 = local_39;
                                        let _e1569 = (_e742.member_1 + _e1567.member_1);
                                        let _e1571 = local_40;
                                        let _e1573 = (_e745.member_2 + _e1571.member_2);
                                        let _e1575 = local_41;
                                        let _e1577 = (_e748.member_3 + _e1575.member_3);
                                        if _e188 {
                                            let _e1582 = (4u * _e184);
                                            let _e1583 = (4u * _e546);
                                            let _e1584 = bitcast<u32>(_e1565);
                                            let _e1587 = ((_e1584 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1587 == 0u) {
                                            } else {
                                                let _e1590 = (_e1587 % 16u);
                                                let _e1592 = ((_e1584 & 8388607u) | 8388608u);
                                                let _e1595 = (_e1592 << bitcast<u32>((_e1590 & 31u)));
                                                let _e1601 = ((_e1592 >> bitcast<u32>(((31u - _e1590) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1584 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1615_ = array<u32, 2>(_e1595, _e1601);
                                                } else {
                                                    let _e1607 = (~(_e1595) + 1u);
                                                    if (_e1607 == 0u) {
                                                        phi_1613_ = (~(_e1601) + 1u);
                                                    } else {
                                                        phi_1613_ = ~(_e1601);
                                                    }
                                                    let _e1613 = phi_1613_;
                                                    phi_1615_ = array<u32, 2>(_e1607, _e1613);
                                                }
                                                let _e1616 = phi_1615_;
                                                let _e1617 = (_e1587 < 255u);
                                                if _e1617 {
                                                    phi_1621_ = _e1616;
                                                } else {
                                                    phi_1621_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1620 = phi_1621_;
                                                let _e1625 = (2u * ((select(16u, (_e1587 / 16u), _e1617) * _e1582) + _e1583));
                                                let _e1628 = atomicAdd((&global_9.member[_e1625]), _e1620[0]);
                                                let _e1636 = atomicAdd((&global_9.member[(_e1625 + 1u)]), (_e1620[1] + select(0u, 1u, ((_e1628 + _e1620[0]) < _e1620[0]))));
                                            }
                                            let _e1638 = bitcast<u32>(_e1569);
                                            let _e1641 = ((_e1638 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1641 == 0u) {
                                            } else {
                                                let _e1644 = (_e1641 % 16u);
                                                let _e1646 = ((_e1638 & 8388607u) | 8388608u);
                                                let _e1649 = (_e1646 << bitcast<u32>((_e1644 & 31u)));
                                                let _e1655 = ((_e1646 >> bitcast<u32>(((31u - _e1644) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1638 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1671_ = array<u32, 2>(_e1649, _e1655);
                                                } else {
                                                    let _e1661 = (~(_e1649) + 1u);
                                                    if (_e1661 == 0u) {
                                                        phi_1669_ = (~(_e1655) + 1u);
                                                    } else {
                                                        phi_1669_ = ~(_e1655);
                                                    }
                                                    let _e1667 = phi_1669_;
                                                    phi_1671_ = array<u32, 2>(_e1661, _e1667);
                                                }
                                                let _e1670 = phi_1671_;
                                                let _e1671 = (_e1641 < 255u);
                                                if _e1671 {
                                                    phi_1677_ = _e1670;
                                                } else {
                                                    phi_1677_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1674 = phi_1677_;
                                                let _e1679 = (2u * ((select(16u, (_e1641 / 16u), _e1671) * _e1582) + (_e1583 + 1u)));
                                                let _e1682 = atomicAdd((&global_9.member[_e1679]), _e1674[0]);
                                                let _e1690 = atomicAdd((&global_9.member[(_e1679 + 1u)]), (_e1674[1] + select(0u, 1u, ((_e1682 + _e1674[0]) < _e1674[0]))));
                                            }
                                            let _e1692 = bitcast<u32>(_e1573);
                                            let _e1695 = ((_e1692 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1695 == 0u) {
                                            } else {
                                                let _e1698 = (_e1695 % 16u);
                                                let _e1700 = ((_e1692 & 8388607u) | 8388608u);
                                                let _e1703 = (_e1700 << bitcast<u32>((_e1698 & 31u)));
                                                let _e1709 = ((_e1700 >> bitcast<u32>(((31u - _e1698) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1692 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1727_ = array<u32, 2>(_e1703, _e1709);
                                                } else {
                                                    let _e1715 = (~(_e1703) + 1u);
                                                    if (_e1715 == 0u) {
                                                        phi_1725_ = (~(_e1709) + 1u);
                                                    } else {
                                                        phi_1725_ = ~(_e1709);
                                                    }
                                                    let _e1721 = phi_1725_;
                                                    phi_1727_ = array<u32, 2>(_e1715, _e1721);
                                                }
                                                let _e1724 = phi_1727_;
                                                let _e1725 = (_e1695 < 255u);
                                                if _e1725 {
                                                    phi_1733_ = _e1724;
                                                } else {
                                                    phi_1733_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1728 = phi_1733_;
                                                let _e1733 = (2u * ((select(16u, (_e1695 / 16u), _e1725) * _e1582) + (_e1583 + 2u)));
                                                let _e1736 = atomicAdd((&global_9.member[_e1733]), _e1728[0]);
                                                let _e1744 = atomicAdd((&global_9.member[(_e1733 + 1u)]), (_e1728[1] + select(0u, 1u, ((_e1736 + _e1728[0]) < _e1728[0]))));
                                            }
                                            let _e1746 = bitcast<u32>(_e1577);
                                            let _e1749 = ((_e1746 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1749 == 0u) {
                                            } else {
                                                let _e1752 = (_e1749 % 16u);
                                                let _e1754 = ((_e1746 & 8388607u) | 8388608u);
                                                let _e1757 = (_e1754 << bitcast<u32>((_e1752 & 31u)));
                                                let _e1763 = ((_e1754 >> bitcast<u32>(((31u - _e1752) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1746 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1783_ = array<u32, 2>(_e1757, _e1763);
                                                } else {
                                                    let _e1769 = (~(_e1757) + 1u);
                                                    if (_e1769 == 0u) {
                                                        phi_1781_ = (~(_e1763) + 1u);
                                                    } else {
                                                        phi_1781_ = ~(_e1763);
                                                    }
                                                    let _e1775 = phi_1781_;
                                                    phi_1783_ = array<u32, 2>(_e1769, _e1775);
                                                }
                                                let _e1778 = phi_1783_;
                                                let _e1779 = (_e1749 < 255u);
                                                if _e1779 {
                                                    phi_1789_ = _e1778;
                                                } else {
                                                    phi_1789_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1782 = phi_1789_;
                                                let _e1787 = (2u * ((select(16u, (_e1749 / 16u), _e1779) * _e1582) + (_e1583 + 3u)));
                                                let _e1790 = atomicAdd((&global_9.member[_e1787]), _e1782[0]);
                                                let _e1798 = atomicAdd((&global_9.member[(_e1787 + 1u)]), (_e1782[1] + select(0u, 1u, ((_e1790 + _e1782[0]) < _e1782[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e546)] = vec4<f32>(_e1565, _e1569, _e1573, _e1577);
                                        }
                                    }
                                } else {
                                    let _e199 = global_5.member.member_6;
                                    let _e200 = (_e199 + _e171);
                                    if _e190 {
                                        let _e204 = global_8.member[(_e185 + _e200)];
                                        phi_251_ = _e204;
                                    } else {
                                        phi_251_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e206 = phi_251_;
                                    phi_258_ = _e175;
                                    phi_261_ = type_21(_e206.x, _e206.y, _e206.z, _e206.w);
                                    loop {
                                        let _e213 = phi_258_;
                                        let _e215 = phi_261_;
                                        let _e216 = (_e213 + 1u);
                                        local_2 = _e215;
                                        local_3 = _e215;
                                        local_4 = _e215;
                                        local_5 = _e215;
                                        local_49 = _e213;
                                        if (_e216 <= _e178) {
                                            let _e218 = (_e195 + _e213);
                                            let _e221 = global_7.member[_e218];
                                            let _e225 = global_7.member[(_e218 + _e193)];
                                            let _e230 = global_7.member[(_e218 + (2u * _e193))];
                                            let _e235 = global_7.member[(_e218 + (3u * _e193))];
                                            local_48 = type_21((_e215.member + _e221), (_e215.member_1 + _e225), (_e215.member_2 + _e230), (_e215.member_3 + _e235));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_258_ = _e216;
                                            let _e1849 = local_48;
                                            phi_261_ = _e1849;
                                        }
                                    }
                                    let _e246 = local_2;
                                    let _e249 = local_3;
                                    let _e252 = local_4;
                                    let _e255 = local_5;
                                    let _e1856 = local_49;
                                    phi_293_ = _e1856;
                                    phi_296_ = type_21(0f, 0f, 0f, 0f);
                                    loop {
                                        let _e258 = phi_293_;
                                        let _e260 = phi_296_;
                                        let _e261 = (_e258 + 1u);
                                        local_6 = _e260;
                                        local_7 = _e260;
                                        local_8 = _e260;
                                        local_9 = _e260;
                                        if (_e261 <= _e178) {
                                            let _e263 = (_e195 + _e258);
                                            let _e266 = global_7.member[_e263];
                                            let _e270 = global_7.member[(_e263 + _e193)];
                                            let _e275 = global_7.member[(_e263 + (2u * _e193))];
                                            let _e280 = global_7.member[(_e263 + (3u * _e193))];
                                            local_50 = type_21((_e260.member + _e266), (_e260.member_1 + _e270), (_e260.member_2 + _e275), (_e260.member_3 + _e280));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_293_ = _e261;
                                            let _e1859 = local_50;
                                            phi_296_ = _e1859;
                                        }
                                    }
                                    let _e291 = local_6;
                                    let _e293 = (_e246.member + _e291.member);
                                    let _e295 = local_7;
                                    let _e297 = (_e249.member_1 + _e295.member_1);
                                    let _e299 = local_8;
                                    let _e301 = (_e252.member_2 + _e299.member_2);
                                    let _e303 = local_9;
                                    let _e305 = (_e255.member_3 + _e303.member_3);
                                    if _e188 {
                                        let _e310 = (4u * _e184);
                                        let _e311 = (4u * _e200);
                                        let _e312 = bitcast<u32>(_e293);
                                        let _e315 = ((_e312 >> bitcast<u32>(23i)) & 255u);
                                        if (_e315 == 0u) {
                                        } else {
                                            let _e318 = (_e315 % 16u);
                                            let _e320 = ((_e312 & 8388607u) | 8388608u);
                                            let _e323 = (_e320 << bitcast<u32>((_e318 & 31u)));
                                            let _e329 = ((_e320 >> bitcast<u32>(((31u - _e318) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e312 >> bitcast<u32>(31i)) == 0u) {
                                                phi_373_ = array<u32, 2>(_e323, _e329);
                                            } else {
                                                let _e335 = (~(_e323) + 1u);
                                                if (_e335 == 0u) {
                                                    phi_371_ = (~(_e329) + 1u);
                                                } else {
                                                    phi_371_ = ~(_e329);
                                                }
                                                let _e341 = phi_371_;
                                                phi_373_ = array<u32, 2>(_e335, _e341);
                                            }
                                            let _e344 = phi_373_;
                                            let _e345 = (_e315 < 255u);
                                            if _e345 {
                                                phi_379_ = _e344;
                                            } else {
                                                phi_379_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e348 = phi_379_;
                                            let _e353 = (2u * ((select(16u, (_e315 / 16u), _e345) * _e310) + _e311));
                                            let _e356 = atomicAdd((&global_9.member[_e353]), _e348[0]);
                                            let _e364 = atomicAdd((&global_9.member[(_e353 + 1u)]), (_e348[1] + select(0u, 1u, ((_e356 + _e348[0]) < _e348[0]))));
                                        }
                                        let _e366 = bitcast<u32>(_e297);
                                        let _e369 = ((_e366 >> bitcast<u32>(23i)) & 255u);
                                        if (_e369 == 0u) {
                                        } else {
                                            let _e372 = (_e369 % 16u);
                                            let _e374 = ((_e366 & 8388607u) | 8388608u);
                                            let _e377 = (_e374 << bitcast<u32>((_e372 & 31u)));
                                            let _e383 = ((_e374 >> bitcast<u32>(((31u - _e372) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e366 >> bitcast<u32>(31i)) == 0u) {
                                                phi_429_ = array<u32, 2>(_e377, _e383);
                                            } else {
                                                let _e389 = (~(_e377) + 1u);
                                                if (_e389 == 0u) {
                                                    phi_427_ = (~(_e383) + 1u);
                                                } else {
                                                    phi_427_ = ~(_e383);
                                                }
                                                let _e395 = phi_427_;
                                                phi_429_ = array<u32, 2>(_e389, _e395);
                                            }
                                            let _e398 = phi_429_;
                                            let _e399 = (_e369 < 255u);
                                            if _e399 {
                                                phi_435_ = _e398;
                                            } else {
                                                phi_435_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e402 = phi_435_;
                                            let _e407 = (2u * ((select(16u, (_e369 / 16u), _e399) * _e310) + (_e311 + 1u)));
                                            let _e410 = atomicAdd((&global_9.member[_e407]), _e402[0]);
                                            let _e418 = atomicAdd((&global_9.member[(_e407 + 1u)]), (_e402[1] + select(0u, 1u, ((_e410 + _e402[0]) < _e402[0]))));
                                        }
                                        let _e420 = bitcast<u32>(_e301);
                                        let _e423 = ((_e420 >> bitcast<u32>(23i)) & 255u);
                                        if (_e423 == 0u) {
                                        } else {
                                            let _e426 = (_e423 % 16u);
                                            let _e428 = ((_e420 & 8388607u) | 8388608u);
                                            let _e431 = (_e428 << bitcast<u32>((_e426 & 31u)));
                                            let _e437 = ((_e428 >> bitcast<u32>(((31u - _e426) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e420 >> bitcast<u32>(31i)) == 0u) {
                                                phi_485_ = array<u32, 2>(_e431, _e437);
                                            } else {
                                                let _e443 = (~(_e431) + 1u);
                                                if (_e443 == 0u) {
                                                    phi_483_ = (~(_e437) + 1u);
                                                } else {
                                                    phi_483_ = ~(_e437);
                                                }
                                                let _e449 = phi_483_;
                                                phi_485_ = array<u32, 2>(_e443, _e449);
                                            }
                                            let _e452 = phi_485_;
                                            let _e453 = (_e423 < 255u);
                                            if _e453 {
                                                phi_491_ = _e452;
                                            } else {
                                                phi_491_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e456 = phi_491_;
                                            let _e461 = (2u * ((select(16u, (_e423 / 16u), _e453) * _e310) + (_e311 + 2u)));
                                            let _e464 = atomicAdd((&global_9.member[_e461]), _e456[0]);
                                            let _e472 = atomicAdd((&global_9.member[(_e461 + 1u)]), (_e456[1] + select(0u, 1u, ((_e464 + _e456[0]) < _e456[0]))));
                                        }
                                        let _e474 = bitcast<u32>(_e305);
                                        let _e477 = ((_e474 >> bitcast<u32>(23i)) & 255u);
                                        if (_e477 == 0u) {
                                        } else {
                                            let _e480 = (_e477 % 16u);
                                            let _e482 = ((_e474 & 8388607u) | 8388608u);
                                            let _e485 = (_e482 << bitcast<u32>((_e480 & 31u)));
                                            let _e491 = ((_e482 >> bitcast<u32>(((31u - _e480) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e474 >> bitcast<u32>(31i)) == 0u) {
                                                phi_541_ = array<u32, 2>(_e485, _e491);
                                            } else {
                                                let _e497 = (~(_e485) + 1u);
                                                if (_e497 == 0u) {
                                                    phi_539_ = (~(_e491) + 1u);
                                                } else {
                                                    phi_539_ = ~(_e491);
                                                }
                                                let _e503 = phi_539_;
                                                phi_541_ = array<u32, 2>(_e497, _e503);
                                            }
                                            let _e506 = phi_541_;
                                            let _e507 = (_e477 < 255u);
                                            if _e507 {
                                                phi_547_ = _e506;
                                            } else {
                                                phi_547_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e510 = phi_547_;
                                            let _e515 = (2u * ((select(16u, (_e477 / 16u), _e507) * _e310) + (_e311 + 3u)));
                                            let _e518 = atomicAdd((&global_9.member[_e515]), _e510[0]);
                                            let _e526 = atomicAdd((&global_9.member[(_e515 + 1u)]), (_e510[1] + select(0u, 1u, ((_e518 + _e510[0]) < _e510[0]))));
                                        }
                                    } else {
                                        global_8.member[(_e187 + _e200)] = vec4<f32>(_e293, _e297, _e301, _e305);
                                    }
                                }
                                phi_192_ = _e159;
                                phi_195_ = _e168;
                                phi_197_ = _e163;
                            }
                            let _e1811 = phi_192_;
                            let _e1813 = phi_195_;
                            let _e1815 = phi_197_;
                            local_44 = _e1811;
                            local_45 = _e1813;
                            local_47 = _e1815;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1835 = local_44;
                            phi_191_ = _e1835;
                            let _e1838 = local_45;
                            phi_194_ = _e1838;
                            let _e1843 = local_47;
                            phi_196_ = _e1843;
                        }
                    }
                    let _e1817 = phi_1815_;
                    if _e1817 {
                        break;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense_weight_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
