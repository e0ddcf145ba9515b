struct type_4 {
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

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_21 {
    member: array<f32>,
}

struct type_27 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_10;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(3) 
var<storage> global_9: type_21;

fn function_() {
    var phi_115_: u32;
    var phi_118_: u32;
    var phi_139_: u32;
    var local: u32;
    var phi_154_: u32;
    var local_1: u32;
    var phi_163_: u32;
    var phi_181_: u32;
    var phi_182_: u32;
    var phi_183_: bool;
    var phi_188_: u32;
    var phi_190_: u32;
    var phi_193_: u32;
    var phi_195_: u32;
    var phi_219_: u32;
    var phi_250_: vec4<f32>;
    var phi_263_: u32;
    var phi_267_: u32;
    var phi_270_: type_18;
    var phi_299_: u32;
    var phi_302_: type_18;
    var phi_386_: u32;
    var phi_389_: type_18;
    var local_2: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;
    var phi_421_: u32;
    var phi_424_: type_18;
    var local_6: type_18;
    var local_7: type_18;
    var local_8: type_18;
    var local_9: type_18;
    var phi_499_: u32;
    var phi_501_: array<u32, 2>;
    var phi_507_: array<u32, 2>;
    var phi_555_: u32;
    var phi_557_: array<u32, 2>;
    var phi_563_: array<u32, 2>;
    var phi_611_: u32;
    var phi_613_: array<u32, 2>;
    var phi_619_: array<u32, 2>;
    var phi_667_: u32;
    var phi_669_: array<u32, 2>;
    var phi_675_: array<u32, 2>;
    var phi_731_: vec4<f32>;
    var phi_742_: vec4<f32>;
    var phi_753_: vec4<f32>;
    var phi_764_: vec4<f32>;
    var phi_777_: u32;
    var phi_781_: type_18;
    var phi_784_: type_18;
    var phi_786_: type_18;
    var phi_788_: type_18;
    var phi_790_: u32;
    var phi_877_: u32;
    var phi_880_: type_18;
    var phi_882_: type_18;
    var phi_884_: type_18;
    var phi_886_: type_18;
    var phi_1144_: type_18;
    var phi_1147_: type_18;
    var phi_1149_: type_18;
    var phi_1151_: type_18;
    var phi_1153_: u32;
    var local_10: type_18;
    var local_11: type_18;
    var local_12: type_18;
    var local_13: type_18;
    var local_14: type_18;
    var local_15: type_18;
    var local_16: type_18;
    var local_17: type_18;
    var local_18: type_18;
    var local_19: type_18;
    var local_20: type_18;
    var local_21: type_18;
    var local_22: type_18;
    var local_23: type_18;
    var local_24: type_18;
    var local_25: type_18;
    var phi_1249_: type_18;
    var phi_1252_: type_18;
    var phi_1254_: type_18;
    var phi_1256_: type_18;
    var phi_1258_: u32;
    var local_26: type_18;
    var local_27: type_18;
    var local_28: type_18;
    var local_29: type_18;
    var phi_1385_: u32;
    var phi_1387_: array<u32, 2>;
    var phi_1393_: array<u32, 2>;
    var phi_1441_: u32;
    var phi_1443_: array<u32, 2>;
    var phi_1449_: array<u32, 2>;
    var phi_1497_: u32;
    var phi_1499_: array<u32, 2>;
    var phi_1505_: array<u32, 2>;
    var phi_1553_: u32;
    var phi_1555_: array<u32, 2>;
    var phi_1561_: array<u32, 2>;
    var local_30: type_18;
    var local_31: type_18;
    var local_32: type_18;
    var local_33: type_18;
    var phi_1628_: u32;
    var phi_1630_: array<u32, 2>;
    var phi_1636_: array<u32, 2>;
    var phi_1684_: u32;
    var phi_1686_: array<u32, 2>;
    var phi_1692_: array<u32, 2>;
    var phi_1740_: u32;
    var phi_1742_: array<u32, 2>;
    var phi_1748_: array<u32, 2>;
    var phi_1796_: u32;
    var phi_1798_: array<u32, 2>;
    var phi_1804_: array<u32, 2>;
    var local_34: type_18;
    var local_35: type_18;
    var local_36: type_18;
    var local_37: type_18;
    var phi_1871_: u32;
    var phi_1873_: array<u32, 2>;
    var phi_1879_: array<u32, 2>;
    var phi_1927_: u32;
    var phi_1929_: array<u32, 2>;
    var phi_1935_: array<u32, 2>;
    var phi_1983_: u32;
    var phi_1985_: array<u32, 2>;
    var phi_1991_: array<u32, 2>;
    var phi_2039_: u32;
    var phi_2041_: array<u32, 2>;
    var phi_2047_: array<u32, 2>;
    var local_38: type_18;
    var local_39: type_18;
    var local_40: type_18;
    var local_41: type_18;
    var phi_2114_: u32;
    var phi_2116_: array<u32, 2>;
    var phi_2122_: array<u32, 2>;
    var phi_2170_: u32;
    var phi_2172_: array<u32, 2>;
    var phi_2178_: array<u32, 2>;
    var phi_2226_: u32;
    var phi_2228_: array<u32, 2>;
    var phi_2234_: array<u32, 2>;
    var phi_2282_: u32;
    var phi_2284_: array<u32, 2>;
    var phi_2290_: array<u32, 2>;
    var phi_2315_: u32;
    var phi_191_: u32;
    var phi_194_: u32;
    var phi_196_: u32;
    var phi_2316_: bool;
    var local_42: u32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: type_18;
    var local_49: u32;
    var local_50: type_18;
    var local_51: type_18;
    var local_52: u32;
    var local_53: type_18;
    var local_54: type_18;
    var local_55: u32;
    var local_56: type_18;
    var local_57: type_18;
    var local_58: type_18;
    var local_59: type_18;
    var local_60: type_18;
    var local_61: u32;
    var local_62: type_18;
    var local_63: type_18;
    var local_64: type_18;
    var local_65: type_18;
    var local_66: type_18;
    var local_67: type_18;
    var local_68: type_18;
    var local_69: type_18;
    var local_70: type_18;
    var local_71: type_18;
    var local_72: type_18;
    var local_73: type_18;
    var local_74: type_18;
    var local_75: type_18;
    var local_76: type_18;
    var local_77: type_18;
    var local_78: u32;
    var local_79: type_18;
    var local_80: type_18;
    var local_81: type_18;
    var local_82: type_18;
    var local_83: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e41 = global_1;
            let _e42 = global_2;
            let _e50 = (((_e41.x + (_e41.y * _e42.x)) * 64u) + _e40.x);
            let _e53 = global_3.member.member_4;
            let _e56 = global_3.member.member_10;
            let _e59 = global_3.member.member_3;
            let _e60 = (_e59 - 1u);
            let _e61 = (_e60 / 4u);
            let _e65 = global_3.member.member_1;
            let _e68 = global_3.member.member;
            let _e69 = (_e65 + _e68);
            let _e72 = (_e65 + (_e41.z * _e56));
            if (_e50 < ((_e61 + 2u) * _e53)) {
                if (_e72 < _e69) {
                    let _e77 = (_e72 + _e56);
                    let _e82 = global_3.member.member_7;
                    phi_115_ = _e82;
                    phi_118_ = 0u;
                    loop {
                        let _e84 = phi_115_;
                        let _e86 = phi_118_;
                        let _e87 = (_e86 + 1u);
                        local = _e86;
                        local_1 = _e87;
                        local_46 = _e86;
                        if (_e87 < _e84) {
                            let _e90 = ((_e86 + _e84) / 2u);
                            let _e93 = global_3.member.member_8;
                            let _e97 = global_4.member[(_e90 * _e93)];
                            let _e100 = global_3.member.member_9;
                            if (_e100 == 0u) {
                                phi_139_ = _e97;
                            } else {
                                let _e104 = global_5.member[_e97];
                                phi_139_ = _e104;
                            }
                            let _e106 = phi_139_;
                            let _e107 = (_e106 <= _e72);
                            local_42 = select(_e90, _e84, _e107);
                            local_43 = select(_e86, _e90, _e107);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2375 = local_42;
                            phi_115_ = _e2375;
                            let _e2378 = local_43;
                            phi_118_ = _e2378;
                        }
                    }
                    let _e112 = global_3.member.member_8;
                    let _e114 = local;
                    let _e118 = global_4.member[(_e114 * _e112)];
                    let _e121 = global_3.member.member_9;
                    let _e122 = (_e121 == 0u);
                    if _e122 {
                        phi_154_ = _e118;
                    } else {
                        let _e125 = global_5.member[_e118];
                        phi_154_ = _e125;
                    }
                    let _e127 = phi_154_;
                    let _e129 = local_1;
                    let _e133 = global_4.member[(_e129 * _e112)];
                    if _e122 {
                        phi_163_ = _e133;
                    } else {
                        let _e136 = global_5.member[_e133];
                        phi_163_ = _e136;
                    }
                    let _e138 = phi_163_;
                    if (_e56 == 0u) {
                        break;
                    }
                    let _e141 = ((_e72 - _e127) % _e56);
                    if (_e41.z == 0u) {
                        phi_182_ = u32();
                        phi_183_ = true;
                    } else {
                        let _e143 = (_e141 == 0u);
                        if _e143 {
                            phi_181_ = u32();
                        } else {
                            let _e145 = ((_e72 - _e141) + _e56);
                            phi_181_ = select(_e138, _e145, (_e145 < _e138));
                        }
                        let _e149 = phi_181_;
                        phi_182_ = _e149;
                        phi_183_ = _e143;
                    }
                    let _e151 = phi_182_;
                    let _e153 = phi_183_;
                    if _e153 {
                        phi_188_ = (_e72 - _e141);
                    } else {
                        phi_188_ = _e151;
                    }
                    let _e156 = phi_188_;
                    phi_190_ = _e138;
                    phi_193_ = _e156;
                    let _e2396 = local_46;
                    phi_195_ = _e2396;
                    loop {
                        let _e158 = phi_190_;
                        let _e160 = phi_193_;
                        let _e162 = phi_195_;
                        phi_2316_ = false;
                        if (_e160 < select(_e69, _e77, (_e77 < _e69))) {
                            if (_e160 == _e158) {
                                let _e2359 = global_4.member[((_e162 + 2u) * _e112)];
                                if _e122 {
                                    phi_2315_ = _e2359;
                                } else {
                                    let _e2362 = global_5.member[_e2359];
                                    phi_2315_ = _e2362;
                                }
                                let _e2364 = phi_2315_;
                                phi_191_ = _e2364;
                                phi_194_ = _e160;
                                phi_196_ = (_e162 + 1u);
                            } else {
                                let _e165 = (_e160 + _e56);
                                let _e167 = select(_e158, _e165, (_e165 < _e158));
                                let _e168 = (_e53 == 0u);
                                if _e168 {
                                    phi_2316_ = true;
                                    break;
                                }
                                let _e169 = (_e50 / _e53);
                                if _e168 {
                                    phi_2316_ = true;
                                    break;
                                }
                                let _e170 = (_e50 % _e53);
                                if (_e160 > _e65) {
                                    phi_219_ = (_e160 - _e65);
                                } else {
                                    phi_219_ = 0u;
                                }
                                let _e174 = phi_219_;
                                let _e175 = (_e167 - _e65);
                                let _e177 = select(_e68, _e175, (_e175 < _e68));
                                let _e180 = global_3.member.member_12;
                                let _e183 = global_3.member.member_11;
                                let _e184 = (_e180 * _e183);
                                let _e186 = ((1u - _e180) * _e183);
                                let _e187 = (_e167 <= _e69);
                                let _e189 = select(false, true, (_e160 < _e65));
                                let _e192 = global_3.member.member_2;
                                let _e194 = ((4u * _e170) * _e192);
                                if (_e169 < (_e61 + 1u)) {
                                    let _e669 = (_e169 * 4u);
                                    let _e672 = global_3.member.member_5;
                                    let _e675 = ((_e672 + (_e669 * _e53)) + _e170);
                                    let _e676 = (_e60 - _e669);
                                    let _e680 = (_e675 + (select(_e676, 1u, (1u < _e676)) * _e53));
                                    let _e684 = (_e675 + (select(_e676, 2u, (2u < _e676)) * _e53));
                                    let _e688 = (_e675 + (select(_e676, 3u, (3u < _e676)) * _e53));
                                    let _e693 = (_e669 * _e192);
                                    let _e694 = (_e669 + 1u);
                                    let _e697 = (select(_e60, _e694, (_e694 < _e60)) * _e192);
                                    let _e698 = (_e669 + 2u);
                                    let _e701 = (select(_e60, _e698, (_e698 < _e60)) * _e192);
                                    let _e702 = (_e669 + 3u);
                                    let _e705 = (select(_e60, _e702, (_e702 < _e60)) * _e192);
                                    if _e189 {
                                        let _e708 = global_6.member[(_e184 + _e675)];
                                        phi_731_ = _e708;
                                    } else {
                                        phi_731_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e710 = phi_731_;
                                    if _e189 {
                                        let _e718 = global_6.member[(_e184 + _e680)];
                                        phi_742_ = _e718;
                                    } else {
                                        phi_742_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e720 = phi_742_;
                                    if _e189 {
                                        let _e728 = global_6.member[(_e184 + _e684)];
                                        phi_753_ = _e728;
                                    } else {
                                        phi_753_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e730 = phi_753_;
                                    if _e189 {
                                        let _e738 = global_6.member[(_e184 + _e688)];
                                        phi_764_ = _e738;
                                    } else {
                                        phi_764_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e740 = phi_764_;
                                    let _e746 = (_e174 % 4u);
                                    if (_e746 == 0u) {
                                        phi_777_ = _e174;
                                    } else {
                                        phi_777_ = (_e174 + (4u - _e746));
                                    }
                                    let _e751 = phi_777_;
                                    phi_781_ = type_18(_e740.x, _e740.y, _e740.z, _e740.w);
                                    phi_784_ = type_18(_e730.x, _e730.y, _e730.z, _e730.w);
                                    phi_786_ = type_18(_e720.x, _e720.y, _e720.z, _e720.w);
                                    phi_788_ = type_18(_e710.x, _e710.y, _e710.z, _e710.w);
                                    phi_790_ = _e174;
                                    loop {
                                        let _e755 = phi_781_;
                                        let _e757 = phi_784_;
                                        let _e759 = phi_786_;
                                        let _e761 = phi_788_;
                                        let _e763 = phi_790_;
                                        let _e764 = (_e763 + 1u);
                                        local_62 = _e755;
                                        local_64 = _e757;
                                        local_66 = _e759;
                                        local_68 = _e761;
                                        if (_e764 <= select(_e177, _e751, (_e751 < _e177))) {
                                            let _e766 = (_e194 + _e763);
                                            let _e769 = global_7.member[_e766];
                                            let _e773 = global_7.member[(_e766 + _e192)];
                                            let _e778 = global_7.member[(_e766 + (2u * _e192))];
                                            let _e783 = global_7.member[(_e766 + (3u * _e192))];
                                            let _e787 = global_9.member[(_e693 + _e763)];
                                            let _e804 = global_9.member[(_e697 + _e763)];
                                            let _e821 = global_9.member[(_e701 + _e763)];
                                            let _e838 = global_9.member[(_e705 + _e763)];
                                            local_57 = type_18(((_e838 * _e769) + _e755.member), ((_e838 * _e773) + _e755.member_1), ((_e838 * _e778) + _e755.member_2), ((_e838 * _e783) + _e755.member_3));
                                            local_58 = type_18(((_e821 * _e769) + _e757.member), ((_e821 * _e773) + _e757.member_1), ((_e821 * _e778) + _e757.member_2), ((_e821 * _e783) + _e757.member_3));
                                            local_59 = type_18(((_e804 * _e769) + _e759.member), ((_e804 * _e773) + _e759.member_1), ((_e804 * _e778) + _e759.member_2), ((_e804 * _e783) + _e759.member_3));
                                            local_60 = type_18(((_e787 * _e769) + _e761.member), ((_e787 * _e773) + _e761.member_1), ((_e787 * _e778) + _e761.member_2), ((_e787 * _e783) + _e761.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2455 = local_57;
                                            phi_781_ = _e2455;
                                            let _e2458 = local_58;
                                            phi_784_ = _e2458;
                                            let _e2461 = local_59;
                                            phi_786_ = _e2461;
                                            let _e2464 = local_60;
                                            phi_788_ = _e2464;
                                            phi_790_ = _e764;
                                        }
                                    }
                                    let _e857 = (_e192 / 4u);
                                    phi_877_ = (_e751 / 4u);
                                    let _e2471 = local_62;
                                    phi_880_ = _e2471;
                                    let _e2476 = local_64;
                                    phi_882_ = _e2476;
                                    let _e2481 = local_66;
                                    phi_884_ = _e2481;
                                    let _e2486 = local_68;
                                    phi_886_ = _e2486;
                                    loop {
                                        let _e860 = phi_877_;
                                        let _e862 = phi_880_;
                                        let _e864 = phi_882_;
                                        let _e866 = phi_884_;
                                        let _e868 = phi_886_;
                                        let _e869 = (4u * _e860);
                                        local_70 = _e862;
                                        local_72 = _e864;
                                        local_74 = _e866;
                                        local_76 = _e868;
                                        local_78 = _e869;
                                        if ((_e869 + 4u) <= _e177) {
                                            let _e872 = ((_e194 / 4u) + _e860);
                                            let _e873 = (4u * _e872);
                                            let _e876 = global_7.member[_e873];
                                            let _e880 = global_7.member[(_e873 + 1u)];
                                            let _e884 = global_7.member[(_e873 + 2u)];
                                            let _e888 = global_7.member[(_e873 + 3u)];
                                            let _e890 = (4u * (_e872 + _e857));
                                            let _e893 = global_7.member[_e890];
                                            let _e897 = global_7.member[(_e890 + 1u)];
                                            let _e901 = global_7.member[(_e890 + 2u)];
                                            let _e905 = global_7.member[(_e890 + 3u)];
                                            let _e908 = (4u * (_e872 + (2u * _e857)));
                                            let _e911 = global_7.member[_e908];
                                            let _e915 = global_7.member[(_e908 + 1u)];
                                            let _e919 = global_7.member[(_e908 + 2u)];
                                            let _e923 = global_7.member[(_e908 + 3u)];
                                            let _e926 = (4u * (_e872 + (3u * _e857)));
                                            let _e929 = global_7.member[_e926];
                                            let _e933 = global_7.member[(_e926 + 1u)];
                                            let _e937 = global_7.member[(_e926 + 2u)];
                                            let _e941 = global_7.member[(_e926 + 3u)];
                                            let _e943 = (4u * ((_e693 / 4u) + _e860));
                                            let _e946 = global_9.member[_e943];
                                            let _e950 = global_9.member[(_e943 + 1u)];
                                            let _e954 = global_9.member[(_e943 + 2u)];
                                            let _e958 = global_9.member[(_e943 + 3u)];
                                            let _e960 = (4u * ((_e697 / 4u) + _e860));
                                            let _e963 = global_9.member[_e960];
                                            let _e967 = global_9.member[(_e960 + 1u)];
                                            let _e971 = global_9.member[(_e960 + 2u)];
                                            let _e975 = global_9.member[(_e960 + 3u)];
                                            let _e977 = (4u * ((_e701 / 4u) + _e860));
                                            let _e980 = global_9.member[_e977];
                                            let _e984 = global_9.member[(_e977 + 1u)];
                                            let _e988 = global_9.member[(_e977 + 2u)];
                                            let _e992 = global_9.member[(_e977 + 3u)];
                                            let _e994 = (4u * ((_e705 / 4u) + _e860));
                                            let _e997 = global_9.member[_e994];
                                            let _e1001 = global_9.member[(_e994 + 1u)];
                                            let _e1005 = global_9.member[(_e994 + 2u)];
                                            let _e1009 = global_9.member[(_e994 + 3u)];
                                            local_61 = (_e860 + 1u);
                                            local_63 = type_18(((_e1009 * _e888) + ((_e1005 * _e884) + ((_e1001 * _e880) + ((_e997 * _e876) + _e862.member)))), ((_e1009 * _e905) + ((_e1005 * _e901) + ((_e1001 * _e897) + ((_e997 * _e893) + _e862.member_1)))), ((_e1009 * _e923) + ((_e1005 * _e919) + ((_e1001 * _e915) + ((_e997 * _e911) + _e862.member_2)))), ((_e1009 * _e941) + ((_e1005 * _e937) + ((_e1001 * _e933) + ((_e997 * _e929) + _e862.member_3)))));
                                            local_65 = type_18(((_e992 * _e888) + ((_e988 * _e884) + ((_e984 * _e880) + ((_e980 * _e876) + _e864.member)))), ((_e992 * _e905) + ((_e988 * _e901) + ((_e984 * _e897) + ((_e980 * _e893) + _e864.member_1)))), ((_e992 * _e923) + ((_e988 * _e919) + ((_e984 * _e915) + ((_e980 * _e911) + _e864.member_2)))), ((_e992 * _e941) + ((_e988 * _e937) + ((_e984 * _e933) + ((_e980 * _e929) + _e864.member_3)))));
                                            local_67 = type_18(((_e975 * _e888) + ((_e971 * _e884) + ((_e967 * _e880) + ((_e963 * _e876) + _e866.member)))), ((_e975 * _e905) + ((_e971 * _e901) + ((_e967 * _e897) + ((_e963 * _e893) + _e866.member_1)))), ((_e975 * _e923) + ((_e971 * _e919) + ((_e967 * _e915) + ((_e963 * _e911) + _e866.member_2)))), ((_e975 * _e941) + ((_e971 * _e937) + ((_e967 * _e933) + ((_e963 * _e929) + _e866.member_3)))));
                                            local_69 = type_18(((_e958 * _e888) + ((_e954 * _e884) + ((_e950 * _e880) + ((_e946 * _e876) + _e868.member)))), ((_e958 * _e905) + ((_e954 * _e901) + ((_e950 * _e897) + ((_e946 * _e893) + _e868.member_1)))), ((_e958 * _e923) + ((_e954 * _e919) + ((_e950 * _e915) + ((_e946 * _e911) + _e868.member_2)))), ((_e958 * _e941) + ((_e954 * _e937) + ((_e950 * _e933) + ((_e946 * _e929) + _e868.member_3)))));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2468 = local_61;
                                            phi_877_ = _e2468;
                                            let _e2473 = local_63;
                                            phi_880_ = _e2473;
                                            let _e2478 = local_65;
                                            phi_882_ = _e2478;
                                            let _e2483 = local_67;
                                            phi_884_ = _e2483;
                                            let _e2488 = local_69;
                                            phi_886_ = _e2488;
                                        }
                                    }
                                    let _e2491 = local_70;
                                    phi_1144_ = _e2491;
                                    let _e2496 = local_72;
                                    phi_1147_ = _e2496;
                                    let _e2501 = local_74;
                                    phi_1149_ = _e2501;
                                    let _e2506 = local_76;
                                    phi_1151_ = _e2506;
                                    let _e2511 = local_78;
                                    phi_1153_ = _e2511;
                                    loop {
                                        let _e1160 = phi_1144_;
                                        let _e1162 = phi_1147_;
                                        let _e1164 = phi_1149_;
                                        let _e1166 = phi_1151_;
                                        let _e1168 = phi_1153_;
                                        let _e1169 = (_e1168 + 1u);
                                        local_10 = _e1166;
                                        local_11 = _e1166;
                                        local_12 = _e1166;
                                        local_13 = _e1166;
                                        local_14 = _e1164;
                                        local_15 = _e1164;
                                        local_16 = _e1164;
                                        local_17 = _e1164;
                                        local_18 = _e1162;
                                        local_19 = _e1162;
                                        local_20 = _e1162;
                                        local_21 = _e1162;
                                        local_22 = _e1160;
                                        local_23 = _e1160;
                                        local_24 = _e1160;
                                        local_25 = _e1160;
                                        local_83 = _e1168;
                                        if (_e1169 <= _e177) {
                                            let _e1171 = (_e194 + _e1168);
                                            let _e1174 = global_7.member[_e1171];
                                            let _e1178 = global_7.member[(_e1171 + _e192)];
                                            let _e1183 = global_7.member[(_e1171 + (2u * _e192))];
                                            let _e1188 = global_7.member[(_e1171 + (3u * _e192))];
                                            let _e1192 = global_9.member[(_e693 + _e1168)];
                                            let _e1209 = global_9.member[(_e697 + _e1168)];
                                            let _e1226 = global_9.member[(_e701 + _e1168)];
                                            let _e1243 = global_9.member[(_e705 + _e1168)];
                                            local_71 = type_18(((_e1243 * _e1174) + _e1160.member), ((_e1243 * _e1178) + _e1160.member_1), ((_e1243 * _e1183) + _e1160.member_2), ((_e1243 * _e1188) + _e1160.member_3));
                                            local_73 = type_18(((_e1226 * _e1174) + _e1162.member), ((_e1226 * _e1178) + _e1162.member_1), ((_e1226 * _e1183) + _e1162.member_2), ((_e1226 * _e1188) + _e1162.member_3));
                                            local_75 = type_18(((_e1209 * _e1174) + _e1164.member), ((_e1209 * _e1178) + _e1164.member_1), ((_e1209 * _e1183) + _e1164.member_2), ((_e1209 * _e1188) + _e1164.member_3));
                                            local_77 = type_18(((_e1192 * _e1174) + _e1166.member), ((_e1192 * _e1178) + _e1166.member_1), ((_e1192 * _e1183) + _e1166.member_2), ((_e1192 * _e1188) + _e1166.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2493 = local_71;
                                            phi_1144_ = _e2493;
                                            let _e2498 = local_73;
                                            phi_1147_ = _e2498;
                                            let _e2503 = local_75;
                                            phi_1149_ = _e2503;
                                            let _e2508 = local_77;
                                            phi_1151_ = _e2508;
                                            phi_1153_ = _e1169;
                                        }
                                    }
                                    let _e1258 = local_10;
                                    let _e1261 = local_11;
                                    let _e1264 = local_12;
                                    let _e1267 = local_13;
                                    let _e1270 = local_14;
                                    let _e1273 = local_15;
                                    let _e1276 = local_16;
                                    let _e1279 = local_17;
                                    let _e1282 = local_18;
                                    let _e1285 = local_19;
                                    let _e1288 = local_20;
                                    let _e1291 = local_21;
                                    let _e1294 = local_22;
                                    let _e1297 = local_23;
                                    let _e1300 = local_24;
                                    let _e1303 = local_25;
                                    phi_1249_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1252_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1254_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1256_ = type_18(0f, 0f, 0f, 0f);
                                    let _e2542 = local_83;
                                    phi_1258_ = _e2542;
                                    loop {
                                        let _e1306 = phi_1249_;
                                        let _e1308 = phi_1252_;
                                        let _e1310 = phi_1254_;
                                        let _e1312 = phi_1256_;
                                        let _e1314 = phi_1258_;
                                        let _e1315 = (_e1314 + 1u);
                                        local_26 = _e1312;
                                        local_27 = _e1312;
                                        local_28 = _e1312;
                                        local_29 = _e1312;
                                        local_30 = _e1310;
                                        local_31 = _e1310;
                                        local_32 = _e1310;
                                        local_33 = _e1310;
                                        local_34 = _e1308;
                                        local_35 = _e1308;
                                        local_36 = _e1308;
                                        local_37 = _e1308;
                                        local_38 = _e1306;
                                        local_39 = _e1306;
                                        local_40 = _e1306;
                                        local_41 = _e1306;
                                        if (_e1315 <= _e177) {
                                            let _e1317 = (_e194 + _e1314);
                                            let _e1320 = global_7.member[_e1317];
                                            let _e1324 = global_7.member[(_e1317 + _e192)];
                                            let _e1329 = global_7.member[(_e1317 + (2u * _e192))];
                                            let _e1334 = global_7.member[(_e1317 + (3u * _e192))];
                                            let _e1338 = global_9.member[(_e693 + _e1314)];
                                            let _e1355 = global_9.member[(_e697 + _e1314)];
                                            let _e1372 = global_9.member[(_e701 + _e1314)];
                                            let _e1389 = global_9.member[(_e705 + _e1314)];
                                            local_79 = type_18(((_e1389 * _e1320) + _e1306.member), ((_e1389 * _e1324) + _e1306.member_1), ((_e1389 * _e1329) + _e1306.member_2), ((_e1389 * _e1334) + _e1306.member_3));
                                            local_80 = type_18(((_e1372 * _e1320) + _e1308.member), ((_e1372 * _e1324) + _e1308.member_1), ((_e1372 * _e1329) + _e1308.member_2), ((_e1372 * _e1334) + _e1308.member_3));
                                            local_81 = type_18(((_e1355 * _e1320) + _e1310.member), ((_e1355 * _e1324) + _e1310.member_1), ((_e1355 * _e1329) + _e1310.member_2), ((_e1355 * _e1334) + _e1310.member_3));
                                            local_82 = type_18(((_e1338 * _e1320) + _e1312.member), ((_e1338 * _e1324) + _e1312.member_1), ((_e1338 * _e1329) + _e1312.member_2), ((_e1338 * _e1334) + _e1312.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2530 = local_79;
                                            phi_1249_ = _e2530;
                                            let _e2533 = local_80;
                                            phi_1252_ = _e2533;
                                            let _e2536 = local_81;
                                            phi_1254_ = _e2536;
                                            let _e2539 = local_82;
                                            phi_1256_ = _e2539;
                                            phi_1258_ = _e1315;
                                        }
                                    }
                                    let _e1404 = local_26;
                                    let _e1406 = (_e1258.member + _e1404.member);
                                    let _e1408 = local_27;
                                    let _e1410 = (_e1261.member_1 + _e1408.member_1);
                                    let _e1412 = local_28;
                                    let _e1414 = (_e1264.member_2 + _e1412.member_2);
                                    let _e1416 = local_29;
                                    let _e1418 = (_e1267.member_3 + _e1416.member_3);
                                    if _e187 {
                                        let _e1423 = (4u * _e183);
                                        let _e1424 = (4u * _e675);
                                        let _e1425 = bitcast<u32>(_e1406);
                                        let _e1428 = ((_e1425 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1428 == 0u) {
                                        } else {
                                            let _e1431 = (_e1428 % 16u);
                                            let _e1433 = ((_e1425 & 8388607u) | 8388608u);
                                            let _e1436 = (_e1433 << bitcast<u32>((_e1431 & 31u)));
                                            let _e1442 = ((_e1433 >> bitcast<u32>(((31u - _e1431) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1425 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1387_ = array<u32, 2>(_e1436, _e1442);
                                            } else {
                                                let _e1448 = (~(_e1436) + 1u);
                                                if (_e1448 == 0u) {
                                                    phi_1385_ = (~(_e1442) + 1u);
                                                } else {
                                                    phi_1385_ = ~(_e1442);
                                                }
                                                let _e1454 = phi_1385_;
                                                phi_1387_ = array<u32, 2>(_e1448, _e1454);
                                            }
                                            let _e1457 = phi_1387_;
                                            let _e1458 = (_e1428 < 255u);
                                            if _e1458 {
                                                phi_1393_ = _e1457;
                                            } else {
                                                phi_1393_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1461 = phi_1393_;
                                            let _e1466 = (2u * ((select(16u, (_e1428 / 16u), _e1458) * _e1423) + _e1424));
                                            let _e1469 = atomicAdd((&global_8.member[_e1466]), _e1461[0]);
                                            let _e1477 = atomicAdd((&global_8.member[(_e1466 + 1u)]), (_e1461[1] + select(0u, 1u, ((_e1469 + _e1461[0]) < _e1461[0]))));
                                        }
                                        let _e1479 = bitcast<u32>(_e1410);
                                        let _e1482 = ((_e1479 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1482 == 0u) {
                                        } else {
                                            let _e1485 = (_e1482 % 16u);
                                            let _e1487 = ((_e1479 & 8388607u) | 8388608u);
                                            let _e1490 = (_e1487 << bitcast<u32>((_e1485 & 31u)));
                                            let _e1496 = ((_e1487 >> bitcast<u32>(((31u - _e1485) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1479 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1443_ = array<u32, 2>(_e1490, _e1496);
                                            } else {
                                                let _e1502 = (~(_e1490) + 1u);
                                                if (_e1502 == 0u) {
                                                    phi_1441_ = (~(_e1496) + 1u);
                                                } else {
                                                    phi_1441_ = ~(_e1496);
                                                }
                                                let _e1508 = phi_1441_;
                                                phi_1443_ = array<u32, 2>(_e1502, _e1508);
                                            }
                                            let _e1511 = phi_1443_;
                                            let _e1512 = (_e1482 < 255u);
                                            if _e1512 {
                                                phi_1449_ = _e1511;
                                            } else {
                                                phi_1449_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1515 = phi_1449_;
                                            let _e1520 = (2u * ((select(16u, (_e1482 / 16u), _e1512) * _e1423) + (_e1424 + 1u)));
                                            let _e1523 = atomicAdd((&global_8.member[_e1520]), _e1515[0]);
                                            let _e1531 = atomicAdd((&global_8.member[(_e1520 + 1u)]), (_e1515[1] + select(0u, 1u, ((_e1523 + _e1515[0]) < _e1515[0]))));
                                        }
                                        let _e1533 = bitcast<u32>(_e1414);
                                        let _e1536 = ((_e1533 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1536 == 0u) {
                                        } else {
                                            let _e1539 = (_e1536 % 16u);
                                            let _e1541 = ((_e1533 & 8388607u) | 8388608u);
                                            let _e1544 = (_e1541 << bitcast<u32>((_e1539 & 31u)));
                                            let _e1550 = ((_e1541 >> bitcast<u32>(((31u - _e1539) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1533 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1499_ = array<u32, 2>(_e1544, _e1550);
                                            } else {
                                                let _e1556 = (~(_e1544) + 1u);
                                                if (_e1556 == 0u) {
                                                    phi_1497_ = (~(_e1550) + 1u);
                                                } else {
                                                    phi_1497_ = ~(_e1550);
                                                }
                                                let _e1562 = phi_1497_;
                                                phi_1499_ = array<u32, 2>(_e1556, _e1562);
                                            }
                                            let _e1565 = phi_1499_;
                                            let _e1566 = (_e1536 < 255u);
                                            if _e1566 {
                                                phi_1505_ = _e1565;
                                            } else {
                                                phi_1505_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1569 = phi_1505_;
                                            let _e1574 = (2u * ((select(16u, (_e1536 / 16u), _e1566) * _e1423) + (_e1424 + 2u)));
                                            let _e1577 = atomicAdd((&global_8.member[_e1574]), _e1569[0]);
                                            let _e1585 = atomicAdd((&global_8.member[(_e1574 + 1u)]), (_e1569[1] + select(0u, 1u, ((_e1577 + _e1569[0]) < _e1569[0]))));
                                        }
                                        let _e1587 = bitcast<u32>(_e1418);
                                        let _e1590 = ((_e1587 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1590 == 0u) {
                                        } else {
                                            let _e1593 = (_e1590 % 16u);
                                            let _e1595 = ((_e1587 & 8388607u) | 8388608u);
                                            let _e1598 = (_e1595 << bitcast<u32>((_e1593 & 31u)));
                                            let _e1604 = ((_e1595 >> bitcast<u32>(((31u - _e1593) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1587 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1555_ = array<u32, 2>(_e1598, _e1604);
                                            } else {
                                                let _e1610 = (~(_e1598) + 1u);
                                                if (_e1610 == 0u) {
                                                    phi_1553_ = (~(_e1604) + 1u);
                                                } else {
                                                    phi_1553_ = ~(_e1604);
                                                }
                                                let _e1616 = phi_1553_;
                                                phi_1555_ = array<u32, 2>(_e1610, _e1616);
                                            }
                                            let _e1619 = phi_1555_;
                                            let _e1620 = (_e1590 < 255u);
                                            if _e1620 {
                                                phi_1561_ = _e1619;
                                            } else {
                                                phi_1561_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1623 = phi_1561_;
                                            let _e1628 = (2u * ((select(16u, (_e1590 / 16u), _e1620) * _e1423) + (_e1424 + 3u)));
                                            let _e1631 = atomicAdd((&global_8.member[_e1628]), _e1623[0]);
                                            let _e1639 = atomicAdd((&global_8.member[(_e1628 + 1u)]), (_e1623[1] + select(0u, 1u, ((_e1631 + _e1623[0]) < _e1623[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e186 + _e675)] = vec4<f32>(_e1406, _e1410, _e1414, _e1418);
                                    }
                                    if (_e694 < _e59) {
                                        let _e1642 = local_30;
                                        let _e1644 = (_e1270.member + _e1642.member);
                                        let _e1646 = local_31;
                                        let _e1648 = (_e1273.member_1 + _e1646.member_1);
                                        let _e1650 = local_32;
                                        let _e1652 = (_e1276.member_2 + _e1650.member_2);
                                        let _e1654 = local_33;
                                        let _e1656 = (_e1279.member_3 + _e1654.member_3);
                                        if _e187 {
                                            let _e1661 = (4u * _e183);
                                            let _e1662 = (4u * _e680);
                                            let _e1663 = bitcast<u32>(_e1644);
                                            let _e1666 = ((_e1663 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1666 == 0u) {
                                            } else {
                                                let _e1669 = (_e1666 % 16u);
                                                let _e1671 = ((_e1663 & 8388607u) | 8388608u);
                                                let _e1674 = (_e1671 << bitcast<u32>((_e1669 & 31u)));
                                                let _e1680 = ((_e1671 >> bitcast<u32>(((31u - _e1669) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1663 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1630_ = array<u32, 2>(_e1674, _e1680);
                                                } else {
                                                    let _e1686 = (~(_e1674) + 1u);
                                                    if (_e1686 == 0u) {
                                                        phi_1628_ = (~(_e1680) + 1u);
                                                    } else {
                                                        phi_1628_ = ~(_e1680);
                                                    }
                                                    let _e1692 = phi_1628_;
                                                    phi_1630_ = array<u32, 2>(_e1686, _e1692);
                                                }
                                                let _e1695 = phi_1630_;
                                                let _e1696 = (_e1666 < 255u);
                                                if _e1696 {
                                                    phi_1636_ = _e1695;
                                                } else {
                                                    phi_1636_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1699 = phi_1636_;
                                                let _e1704 = (2u * ((select(16u, (_e1666 / 16u), _e1696) * _e1661) + _e1662));
                                                let _e1707 = atomicAdd((&global_8.member[_e1704]), _e1699[0]);
                                                let _e1715 = atomicAdd((&global_8.member[(_e1704 + 1u)]), (_e1699[1] + select(0u, 1u, ((_e1707 + _e1699[0]) < _e1699[0]))));
                                            }
                                            let _e1717 = bitcast<u32>(_e1648);
                                            let _e1720 = ((_e1717 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1720 == 0u) {
                                            } else {
                                                let _e1723 = (_e1720 % 16u);
                                                let _e1725 = ((_e1717 & 8388607u) | 8388608u);
                                                let _e1728 = (_e1725 << bitcast<u32>((_e1723 & 31u)));
                                                let _e1734 = ((_e1725 >> bitcast<u32>(((31u - _e1723) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1717 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1686_ = array<u32, 2>(_e1728, _e1734);
                                                } else {
                                                    let _e1740 = (~(_e1728) + 1u);
                                                    if (_e1740 == 0u) {
                                                        phi_1684_ = (~(_e1734) + 1u);
                                                    } else {
                                                        phi_1684_ = ~(_e1734);
                                                    }
                                                    let _e1746 = phi_1684_;
                                                    phi_1686_ = array<u32, 2>(_e1740, _e1746);
                                                }
                                                let _e1749 = phi_1686_;
                                                let _e1750 = (_e1720 < 255u);
                                                if _e1750 {
                                                    phi_1692_ = _e1749;
                                                } else {
                                                    phi_1692_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1753 = phi_1692_;
                                                let _e1758 = (2u * ((select(16u, (_e1720 / 16u), _e1750) * _e1661) + (_e1662 + 1u)));
                                                let _e1761 = atomicAdd((&global_8.member[_e1758]), _e1753[0]);
                                                let _e1769 = atomicAdd((&global_8.member[(_e1758 + 1u)]), (_e1753[1] + select(0u, 1u, ((_e1761 + _e1753[0]) < _e1753[0]))));
                                            }
                                            let _e1771 = bitcast<u32>(_e1652);
                                            let _e1774 = ((_e1771 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1774 == 0u) {
                                            } else {
                                                let _e1777 = (_e1774 % 16u);
                                                let _e1779 = ((_e1771 & 8388607u) | 8388608u);
                                                let _e1782 = (_e1779 << bitcast<u32>((_e1777 & 31u)));
                                                let _e1788 = ((_e1779 >> bitcast<u32>(((31u - _e1777) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1771 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1742_ = array<u32, 2>(_e1782, _e1788);
                                                } else {
                                                    let _e1794 = (~(_e1782) + 1u);
                                                    if (_e1794 == 0u) {
                                                        phi_1740_ = (~(_e1788) + 1u);
                                                    } else {
                                                        phi_1740_ = ~(_e1788);
                                                    }
                                                    let _e1800 = phi_1740_;
                                                    phi_1742_ = array<u32, 2>(_e1794, _e1800);
                                                }
                                                let _e1803 = phi_1742_;
                                                let _e1804 = (_e1774 < 255u);
                                                if _e1804 {
                                                    phi_1748_ = _e1803;
                                                } else {
                                                    phi_1748_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1807 = phi_1748_;
                                                let _e1812 = (2u * ((select(16u, (_e1774 / 16u), _e1804) * _e1661) + (_e1662 + 2u)));
                                                let _e1815 = atomicAdd((&global_8.member[_e1812]), _e1807[0]);
                                                let _e1823 = atomicAdd((&global_8.member[(_e1812 + 1u)]), (_e1807[1] + select(0u, 1u, ((_e1815 + _e1807[0]) < _e1807[0]))));
                                            }
                                            let _e1825 = bitcast<u32>(_e1656);
                                            let _e1828 = ((_e1825 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1828 == 0u) {
                                            } else {
                                                let _e1831 = (_e1828 % 16u);
                                                let _e1833 = ((_e1825 & 8388607u) | 8388608u);
                                                let _e1836 = (_e1833 << bitcast<u32>((_e1831 & 31u)));
                                                let _e1842 = ((_e1833 >> bitcast<u32>(((31u - _e1831) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1825 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1798_ = array<u32, 2>(_e1836, _e1842);
                                                } else {
                                                    let _e1848 = (~(_e1836) + 1u);
                                                    if (_e1848 == 0u) {
                                                        phi_1796_ = (~(_e1842) + 1u);
                                                    } else {
                                                        phi_1796_ = ~(_e1842);
                                                    }
                                                    let _e1854 = phi_1796_;
                                                    phi_1798_ = array<u32, 2>(_e1848, _e1854);
                                                }
                                                let _e1857 = phi_1798_;
                                                let _e1858 = (_e1828 < 255u);
                                                if _e1858 {
                                                    phi_1804_ = _e1857;
                                                } else {
                                                    phi_1804_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1861 = phi_1804_;
                                                let _e1866 = (2u * ((select(16u, (_e1828 / 16u), _e1858) * _e1661) + (_e1662 + 3u)));
                                                let _e1869 = atomicAdd((&global_8.member[_e1866]), _e1861[0]);
                                                let _e1877 = atomicAdd((&global_8.member[(_e1866 + 1u)]), (_e1861[1] + select(0u, 1u, ((_e1869 + _e1861[0]) < _e1861[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e680)] = vec4<f32>(_e1644, _e1648, _e1652, _e1656);
                                        }
                                    }
                                    if (_e698 < _e59) {
                                        let _e1880 = local_34;
                                        let _e1882 = (_e1282.member + _e1880.member);
                                        let _e1884 = local_35;
                                        let _e1886 = (_e1285.member_1 + _e1884.member_1);
                                        let _e1888 = local_36;
                                        let _e1890 = (_e1288.member_2 + _e1888.member_2);
                                        let _e1892 = local_37;
                                        let _e1894 = (_e1291.member_3 + _e1892.member_3);
                                        if _e187 {
                                            let _e1899 = (4u * _e183);
                                            let _e1900 = (4u * _e684);
                                            let _e1901 = bitcast<u32>(_e1882);
                                            let _e1904 = ((_e1901 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1904 == 0u) {
                                            } else {
                                                let _e1907 = (_e1904 % 16u);
                                                let _e1909 = ((_e1901 & 8388607u) | 8388608u);
                                                let _e1912 = (_e1909 << bitcast<u32>((_e1907 & 31u)));
                                                let _e1918 = ((_e1909 >> bitcast<u32>(((31u - _e1907) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1901 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1873_ = array<u32, 2>(_e1912, _e1918);
                                                } else {
                                                    let _e1924 = (~(_e1912) + 1u);
                                                    if (_e1924 == 0u) {
                                                        phi_1871_ = (~(_e1918) + 1u);
                                                    } else {
                                                        phi_1871_ = ~(_e1918);
                                                    }
                                                    let _e1930 = phi_1871_;
                                                    phi_1873_ = array<u32, 2>(_e1924, _e1930);
                                                }
                                                let _e1933 = phi_1873_;
                                                let _e1934 = (_e1904 < 255u);
                                                if _e1934 {
                                                    phi_1879_ = _e1933;
                                                } else {
                                                    phi_1879_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1937 = phi_1879_;
                                                let _e1942 = (2u * ((select(16u, (_e1904 / 16u), _e1934) * _e1899) + _e1900));
                                                let _e1945 = atomicAdd((&global_8.member[_e1942]), _e1937[0]);
                                                let _e1953 = atomicAdd((&global_8.member[(_e1942 + 1u)]), (_e1937[1] + select(0u, 1u, ((_e1945 + _e1937[0]) < _e1937[0]))));
                                            }
                                            let _e1955 = bitcast<u32>(_e1886);
                                            let _e1958 = ((_e1955 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1958 == 0u) {
                                            } else {
                                                let _e1961 = (_e1958 % 16u);
                                                let _e1963 = ((_e1955 & 8388607u) | 8388608u);
                                                let _e1966 = (_e1963 << bitcast<u32>((_e1961 & 31u)));
                                                let _e1972 = ((_e1963 >> bitcast<u32>(((31u - _e1961) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1955 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1929_ = array<u32, 2>(_e1966, _e1972);
                                                } else {
                                                    let _e1978 = (~(_e1966) + 1u);
                                                    if (_e1978 == 0u) {
                                                        phi_1927_ = (~(_e1972) + 1u);
                                                    } else {
                                                        phi_1927_ = ~(_e1972);
                                                    }
                                                    let _e1984 = phi_1927_;
                                                    phi_1929_ = array<u32, 2>(_e1978, _e1984);
                                                }
                                                let _e1987 = phi_1929_;
                                                let _e1988 = (_e1958 < 255u);
                                                if _e1988 {
                                                    phi_1935_ = _e1987;
                                                } else {
                                                    phi_1935_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1991 = phi_1935_;
                                                let _e1996 = (2u * ((select(16u, (_e1958 / 16u), _e1988) * _e1899) + (_e1900 + 1u)));
                                                let _e1999 = atomicAdd((&global_8.member[_e1996]), _e1991[0]);
                                                let _e2007 = atomicAdd((&global_8.member[(_e1996 + 1u)]), (_e1991[1] + select(0u, 1u, ((_e1999 + _e1991[0]) < _e1991[0]))));
                                            }
                                            let _e2009 = bitcast<u32>(_e1890);
                                            let _e2012 = ((_e2009 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2012 == 0u) {
                                            } else {
                                                let _e2015 = (_e2012 % 16u);
                                                let _e2017 = ((_e2009 & 8388607u) | 8388608u);
                                                let _e2020 = (_e2017 << bitcast<u32>((_e2015 & 31u)));
                                                let _e2026 = ((_e2017 >> bitcast<u32>(((31u - _e2015) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2009 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1985_ = array<u32, 2>(_e2020, _e2026);
                                                } else {
                                                    let _e2032 = (~(_e2020) + 1u);
                                                    if (_e2032 == 0u) {
                                                        phi_1983_ = (~(_e2026) + 1u);
                                                    } else {
                                                        phi_1983_ = ~(_e2026);
                                                    }
                                                    let _e2038 = phi_1983_;
                                                    phi_1985_ = array<u32, 2>(_e2032, _e2038);
                                                }
                                                let _e2041 = phi_1985_;
                                                let _e2042 = (_e2012 < 255u);
                                                if _e2042 {
                                                    phi_1991_ = _e2041;
                                                } else {
                                                    phi_1991_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2045 = phi_1991_;
                                                let _e2050 = (2u * ((select(16u, (_e2012 / 16u), _e2042) * _e1899) + (_e1900 + 2u)));
                                                let _e2053 = atomicAdd((&global_8.member[_e2050]), _e2045[0]);
                                                let _e2061 = atomicAdd((&global_8.member[(_e2050 + 1u)]), (_e2045[1] + select(0u, 1u, ((_e2053 + _e2045[0]) < _e2045[0]))));
                                            }
                                            let _e2063 = bitcast<u32>(_e1894);
                                            let _e2066 = ((_e2063 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2066 == 0u) {
                                            } else {
                                                let _e2069 = (_e2066 % 16u);
                                                let _e2071 = ((_e2063 & 8388607u) | 8388608u);
                                                let _e2074 = (_e2071 << bitcast<u32>((_e2069 & 31u)));
                                                let _e2080 = ((_e2071 >> bitcast<u32>(((31u - _e2069) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2063 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2041_ = array<u32, 2>(_e2074, _e2080);
                                                } else {
                                                    let _e2086 = (~(_e2074) + 1u);
                                                    if (_e2086 == 0u) {
                                                        phi_2039_ = (~(_e2080) + 1u);
                                                    } else {
                                                        phi_2039_ = ~(_e2080);
                                                    }
                                                    let _e2092 = phi_2039_;
                                                    phi_2041_ = array<u32, 2>(_e2086, _e2092);
                                                }
                                                let _e2095 = phi_2041_;
                                                let _e2096 = (_e2066 < 255u);
                                                if _e2096 {
                                                    phi_2047_ = _e2095;
                                                } else {
                                                    phi_2047_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2099 = phi_2047_;
                                                let _e2104 = (2u * ((select(16u, (_e2066 / 16u), _e2096) * _e1899) + (_e1900 + 3u)));
                                                let _e2107 = atomicAdd((&global_8.member[_e2104]), _e2099[0]);
                                                let _e2115 = atomicAdd((&global_8.member[(_e2104 + 1u)]), (_e2099[1] + select(0u, 1u, ((_e2107 + _e2099[0]) < _e2099[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e684)] = vec4<f32>(_e1882, _e1886, _e1890, _e1894);
                                        }
                                    }
                                    if (_e702 < _e59) {
                                        let _e2118 = local_38;
                                        let _e2120 = (_e1294.member + _e2118.member);
                                        let _e2122 = local_39;
                                        let _e2124 = (_e1297.member_1 + _e2122.member_1);
                                        let _e2126 = local_40;
                                        let _e2128 = (_e1300.member_2 + _e2126.member_2);
                                        let _e2130 = local_41;
                                        let _e2132 = (_e1303.member_3 + _e2130.member_3);
                                        if _e187 {
                                            let _e2137 = (4u * _e183);
                                            let _e2138 = (4u * _e688);
                                            let _e2139 = bitcast<u32>(_e2120);
                                            let _e2142 = ((_e2139 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2142 == 0u) {
                                            } else {
                                                let _e2145 = (_e2142 % 16u);
                                                let _e2147 = ((_e2139 & 8388607u) | 8388608u);
                                                let _e2150 = (_e2147 << bitcast<u32>((_e2145 & 31u)));
                                                let _e2156 = ((_e2147 >> bitcast<u32>(((31u - _e2145) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2139 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2116_ = array<u32, 2>(_e2150, _e2156);
                                                } else {
                                                    let _e2162 = (~(_e2150) + 1u);
                                                    if (_e2162 == 0u) {
                                                        phi_2114_ = (~(_e2156) + 1u);
                                                    } else {
                                                        phi_2114_ = ~(_e2156);
                                                    }
                                                    let _e2168 = phi_2114_;
                                                    phi_2116_ = array<u32, 2>(_e2162, _e2168);
                                                }
                                                let _e2171 = phi_2116_;
                                                let _e2172 = (_e2142 < 255u);
                                                if _e2172 {
                                                    phi_2122_ = _e2171;
                                                } else {
                                                    phi_2122_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2175 = phi_2122_;
                                                let _e2180 = (2u * ((select(16u, (_e2142 / 16u), _e2172) * _e2137) + _e2138));
                                                let _e2183 = atomicAdd((&global_8.member[_e2180]), _e2175[0]);
                                                let _e2191 = atomicAdd((&global_8.member[(_e2180 + 1u)]), (_e2175[1] + select(0u, 1u, ((_e2183 + _e2175[0]) < _e2175[0]))));
                                            }
                                            let _e2193 = bitcast<u32>(_e2124);
                                            let _e2196 = ((_e2193 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2196 == 0u) {
                                            } else {
                                                let _e2199 = (_e2196 % 16u);
                                                let _e2201 = ((_e2193 & 8388607u) | 8388608u);
                                                let _e2204 = (_e2201 << bitcast<u32>((_e2199 & 31u)));
                                                let _e2210 = ((_e2201 >> bitcast<u32>(((31u - _e2199) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2193 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2172_ = array<u32, 2>(_e2204, _e2210);
                                                } else {
                                                    let _e2216 = (~(_e2204) + 1u);
                                                    if (_e2216 == 0u) {
                                                        phi_2170_ = (~(_e2210) + 1u);
                                                    } else {
                                                        phi_2170_ = ~(_e2210);
                                                    }
                                                    let _e2222 = phi_2170_;
                                                    phi_2172_ = array<u32, 2>(_e2216, _e2222);
                                                }
                                                let _e2225 = phi_2172_;
                                                let _e2226 = (_e2196 < 255u);
                                                if _e2226 {
                                                    phi_2178_ = _e2225;
                                                } else {
                                                    phi_2178_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2229 = phi_2178_;
                                                let _e2234 = (2u * ((select(16u, (_e2196 / 16u), _e2226) * _e2137) + (_e2138 + 1u)));
                                                let _e2237 = atomicAdd((&global_8.member[_e2234]), _e2229[0]);
                                                let _e2245 = atomicAdd((&global_8.member[(_e2234 + 1u)]), (_e2229[1] + select(0u, 1u, ((_e2237 + _e2229[0]) < _e2229[0]))));
                                            }
                                            let _e2247 = bitcast<u32>(_e2128);
                                            let _e2250 = ((_e2247 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2250 == 0u) {
                                            } else {
                                                let _e2253 = (_e2250 % 16u);
                                                let _e2255 = ((_e2247 & 8388607u) | 8388608u);
                                                let _e2258 = (_e2255 << bitcast<u32>((_e2253 & 31u)));
                                                let _e2264 = ((_e2255 >> bitcast<u32>(((31u - _e2253) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2247 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2228_ = array<u32, 2>(_e2258, _e2264);
                                                } else {
                                                    let _e2270 = (~(_e2258) + 1u);
                                                    if (_e2270 == 0u) {
                                                        phi_2226_ = (~(_e2264) + 1u);
                                                    } else {
                                                        phi_2226_ = ~(_e2264);
                                                    }
                                                    let _e2276 = phi_2226_;
                                                    phi_2228_ = array<u32, 2>(_e2270, _e2276);
                                                }
                                                let _e2279 = phi_2228_;
                                                let _e2280 = (_e2250 < 255u);
                                                if _e2280 {
                                                    phi_2234_ = _e2279;
                                                } else {
                                                    phi_2234_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2283 = phi_2234_;
                                                let _e2288 = (2u * ((select(16u, (_e2250 / 16u), _e2280) * _e2137) + (_e2138 + 2u)));
                                                let _e2291 = atomicAdd((&global_8.member[_e2288]), _e2283[0]);
                                                let _e2299 = atomicAdd((&global_8.member[(_e2288 + 1u)]), (_e2283[1] + select(0u, 1u, ((_e2291 + _e2283[0]) < _e2283[0]))));
                                            }
                                            let _e2301 = bitcast<u32>(_e2132);
                                            let _e2304 = ((_e2301 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2304 == 0u) {
                                            } else {
                                                let _e2307 = (_e2304 % 16u);
                                                let _e2309 = ((_e2301 & 8388607u) | 8388608u);
                                                let _e2312 = (_e2309 << bitcast<u32>((_e2307 & 31u)));
                                                let _e2318 = ((_e2309 >> bitcast<u32>(((31u - _e2307) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2301 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2284_ = array<u32, 2>(_e2312, _e2318);
                                                } else {
                                                    let _e2324 = (~(_e2312) + 1u);
                                                    if (_e2324 == 0u) {
                                                        phi_2282_ = (~(_e2318) + 1u);
                                                    } else {
                                                        phi_2282_ = ~(_e2318);
                                                    }
                                                    let _e2330 = phi_2282_;
                                                    phi_2284_ = array<u32, 2>(_e2324, _e2330);
                                                }
                                                let _e2333 = phi_2284_;
                                                let _e2334 = (_e2304 < 255u);
                                                if _e2334 {
                                                    phi_2290_ = _e2333;
                                                } else {
                                                    phi_2290_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2337 = phi_2290_;
                                                let _e2342 = (2u * ((select(16u, (_e2304 / 16u), _e2334) * _e2137) + (_e2138 + 3u)));
                                                let _e2345 = atomicAdd((&global_8.member[_e2342]), _e2337[0]);
                                                let _e2353 = atomicAdd((&global_8.member[(_e2342 + 1u)]), (_e2337[1] + select(0u, 1u, ((_e2345 + _e2337[0]) < _e2337[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e688)] = vec4<f32>(_e2120, _e2124, _e2128, _e2132);
                                        }
                                    }
                                } else {
                                    let _e198 = global_3.member.member_6;
                                    let _e199 = (_e198 + _e170);
                                    if _e189 {
                                        let _e203 = global_6.member[(_e184 + _e199)];
                                        phi_250_ = _e203;
                                    } else {
                                        phi_250_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e205 = phi_250_;
                                    let _e211 = (_e174 % 4u);
                                    if (_e211 == 0u) {
                                        phi_263_ = _e174;
                                    } else {
                                        phi_263_ = (_e174 + (4u - _e211));
                                    }
                                    let _e216 = phi_263_;
                                    phi_267_ = _e174;
                                    phi_270_ = type_18(_e205.x, _e205.y, _e205.z, _e205.w);
                                    loop {
                                        let _e220 = phi_267_;
                                        let _e222 = phi_270_;
                                        let _e223 = (_e220 + 1u);
                                        local_50 = _e222;
                                        if (_e223 <= select(_e177, _e216, (_e216 < _e177))) {
                                            let _e225 = (_e194 + _e220);
                                            let _e228 = global_7.member[_e225];
                                            let _e232 = global_7.member[(_e225 + _e192)];
                                            let _e237 = global_7.member[(_e225 + (2u * _e192))];
                                            let _e242 = global_7.member[(_e225 + (3u * _e192))];
                                            local_48 = type_18((_e222.member + _e228), (_e222.member_1 + _e232), (_e222.member_2 + _e237), (_e222.member_3 + _e242));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_267_ = _e223;
                                            let _e2405 = local_48;
                                            phi_270_ = _e2405;
                                        }
                                    }
                                    phi_299_ = (_e216 / 4u);
                                    let _e2411 = local_50;
                                    phi_302_ = _e2411;
                                    loop {
                                        let _e254 = phi_299_;
                                        let _e256 = phi_302_;
                                        let _e257 = (4u * _e254);
                                        local_52 = _e257;
                                        local_53 = _e256;
                                        if ((_e257 + 4u) <= _e177) {
                                            let _e261 = ((_e194 / 4u) + _e254);
                                            let _e262 = (_e192 / 4u);
                                            let _e263 = (4u * _e261);
                                            let _e266 = global_7.member[_e263];
                                            let _e270 = global_7.member[(_e263 + 1u)];
                                            let _e274 = global_7.member[(_e263 + 2u)];
                                            let _e278 = global_7.member[(_e263 + 3u)];
                                            let _e280 = (4u * (_e261 + _e262));
                                            let _e283 = global_7.member[_e280];
                                            let _e287 = global_7.member[(_e280 + 1u)];
                                            let _e291 = global_7.member[(_e280 + 2u)];
                                            let _e295 = global_7.member[(_e280 + 3u)];
                                            let _e298 = (4u * (_e261 + (2u * _e262)));
                                            let _e301 = global_7.member[_e298];
                                            let _e305 = global_7.member[(_e298 + 1u)];
                                            let _e309 = global_7.member[(_e298 + 2u)];
                                            let _e313 = global_7.member[(_e298 + 3u)];
                                            let _e316 = (4u * (_e261 + (3u * _e262)));
                                            let _e319 = global_7.member[_e316];
                                            let _e323 = global_7.member[(_e316 + 1u)];
                                            let _e327 = global_7.member[(_e316 + 2u)];
                                            let _e331 = global_7.member[(_e316 + 3u)];
                                            local_49 = (_e254 + 1u);
                                            local_51 = type_18(((((_e256.member + _e266) + _e270) + _e274) + _e278), ((((_e256.member_1 + _e283) + _e287) + _e291) + _e295), ((((_e256.member_2 + _e301) + _e305) + _e309) + _e313), ((((_e256.member_3 + _e319) + _e323) + _e327) + _e331));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2408 = local_49;
                                            phi_299_ = _e2408;
                                            let _e2413 = local_51;
                                            phi_302_ = _e2413;
                                        }
                                    }
                                    let _e2416 = local_52;
                                    phi_386_ = _e2416;
                                    let _e2419 = local_53;
                                    phi_389_ = _e2419;
                                    loop {
                                        let _e355 = phi_386_;
                                        let _e357 = phi_389_;
                                        let _e358 = (_e355 + 1u);
                                        local_2 = _e357;
                                        local_3 = _e357;
                                        local_4 = _e357;
                                        local_5 = _e357;
                                        local_55 = _e355;
                                        if (_e358 <= _e177) {
                                            let _e360 = (_e194 + _e355);
                                            let _e363 = global_7.member[_e360];
                                            let _e367 = global_7.member[(_e360 + _e192)];
                                            let _e372 = global_7.member[(_e360 + (2u * _e192))];
                                            let _e377 = global_7.member[(_e360 + (3u * _e192))];
                                            local_54 = type_18((_e357.member + _e363), (_e357.member_1 + _e367), (_e357.member_2 + _e372), (_e357.member_3 + _e377));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_386_ = _e358;
                                            let _e2421 = local_54;
                                            phi_389_ = _e2421;
                                        }
                                    }
                                    let _e388 = local_2;
                                    let _e391 = local_3;
                                    let _e394 = local_4;
                                    let _e397 = local_5;
                                    let _e2428 = local_55;
                                    phi_421_ = _e2428;
                                    phi_424_ = type_18(0f, 0f, 0f, 0f);
                                    loop {
                                        let _e400 = phi_421_;
                                        let _e402 = phi_424_;
                                        let _e403 = (_e400 + 1u);
                                        local_6 = _e402;
                                        local_7 = _e402;
                                        local_8 = _e402;
                                        local_9 = _e402;
                                        if (_e403 <= _e177) {
                                            let _e405 = (_e194 + _e400);
                                            let _e408 = global_7.member[_e405];
                                            let _e412 = global_7.member[(_e405 + _e192)];
                                            let _e417 = global_7.member[(_e405 + (2u * _e192))];
                                            let _e422 = global_7.member[(_e405 + (3u * _e192))];
                                            local_56 = type_18((_e402.member + _e408), (_e402.member_1 + _e412), (_e402.member_2 + _e417), (_e402.member_3 + _e422));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_421_ = _e403;
                                            let _e2431 = local_56;
                                            phi_424_ = _e2431;
                                        }
                                    }
                                    let _e433 = local_6;
                                    let _e435 = (_e388.member + _e433.member);
                                    let _e437 = local_7;
                                    let _e439 = (_e391.member_1 + _e437.member_1);
                                    let _e441 = local_8;
                                    let _e443 = (_e394.member_2 + _e441.member_2);
                                    let _e445 = local_9;
                                    let _e447 = (_e397.member_3 + _e445.member_3);
                                    if _e187 {
                                        let _e452 = (4u * _e183);
                                        let _e453 = (4u * _e199);
                                        let _e454 = bitcast<u32>(_e435);
                                        let _e457 = ((_e454 >> bitcast<u32>(23i)) & 255u);
                                        if (_e457 == 0u) {
                                        } else {
                                            let _e460 = (_e457 % 16u);
                                            let _e462 = ((_e454 & 8388607u) | 8388608u);
                                            let _e465 = (_e462 << bitcast<u32>((_e460 & 31u)));
                                            let _e471 = ((_e462 >> bitcast<u32>(((31u - _e460) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e454 >> bitcast<u32>(31i)) == 0u) {
                                                phi_501_ = array<u32, 2>(_e465, _e471);
                                            } else {
                                                let _e477 = (~(_e465) + 1u);
                                                if (_e477 == 0u) {
                                                    phi_499_ = (~(_e471) + 1u);
                                                } else {
                                                    phi_499_ = ~(_e471);
                                                }
                                                let _e483 = phi_499_;
                                                phi_501_ = array<u32, 2>(_e477, _e483);
                                            }
                                            let _e486 = phi_501_;
                                            let _e487 = (_e457 < 255u);
                                            if _e487 {
                                                phi_507_ = _e486;
                                            } else {
                                                phi_507_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e490 = phi_507_;
                                            let _e495 = (2u * ((select(16u, (_e457 / 16u), _e487) * _e452) + _e453));
                                            let _e498 = atomicAdd((&global_8.member[_e495]), _e490[0]);
                                            let _e506 = atomicAdd((&global_8.member[(_e495 + 1u)]), (_e490[1] + select(0u, 1u, ((_e498 + _e490[0]) < _e490[0]))));
                                        }
                                        let _e508 = bitcast<u32>(_e439);
                                        let _e511 = ((_e508 >> bitcast<u32>(23i)) & 255u);
                                        if (_e511 == 0u) {
                                        } else {
                                            let _e514 = (_e511 % 16u);
                                            let _e516 = ((_e508 & 8388607u) | 8388608u);
                                            let _e519 = (_e516 << bitcast<u32>((_e514 & 31u)));
                                            let _e525 = ((_e516 >> bitcast<u32>(((31u - _e514) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e508 >> bitcast<u32>(31i)) == 0u) {
                                                phi_557_ = array<u32, 2>(_e519, _e525);
                                            } else {
                                                let _e531 = (~(_e519) + 1u);
                                                if (_e531 == 0u) {
                                                    phi_555_ = (~(_e525) + 1u);
                                                } else {
                                                    phi_555_ = ~(_e525);
                                                }
                                                let _e537 = phi_555_;
                                                phi_557_ = array<u32, 2>(_e531, _e537);
                                            }
                                            let _e540 = phi_557_;
                                            let _e541 = (_e511 < 255u);
                                            if _e541 {
                                                phi_563_ = _e540;
                                            } else {
                                                phi_563_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e544 = phi_563_;
                                            let _e549 = (2u * ((select(16u, (_e511 / 16u), _e541) * _e452) + (_e453 + 1u)));
                                            let _e552 = atomicAdd((&global_8.member[_e549]), _e544[0]);
                                            let _e560 = atomicAdd((&global_8.member[(_e549 + 1u)]), (_e544[1] + select(0u, 1u, ((_e552 + _e544[0]) < _e544[0]))));
                                        }
                                        let _e562 = bitcast<u32>(_e443);
                                        let _e565 = ((_e562 >> bitcast<u32>(23i)) & 255u);
                                        if (_e565 == 0u) {
                                        } else {
                                            let _e568 = (_e565 % 16u);
                                            let _e570 = ((_e562 & 8388607u) | 8388608u);
                                            let _e573 = (_e570 << bitcast<u32>((_e568 & 31u)));
                                            let _e579 = ((_e570 >> bitcast<u32>(((31u - _e568) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e562 >> bitcast<u32>(31i)) == 0u) {
                                                phi_613_ = array<u32, 2>(_e573, _e579);
                                            } else {
                                                let _e585 = (~(_e573) + 1u);
                                                if (_e585 == 0u) {
                                                    phi_611_ = (~(_e579) + 1u);
                                                } else {
                                                    phi_611_ = ~(_e579);
                                                }
                                                let _e591 = phi_611_;
                                                phi_613_ = array<u32, 2>(_e585, _e591);
                                            }
                                            let _e594 = phi_613_;
                                            let _e595 = (_e565 < 255u);
                                            if _e595 {
                                                phi_619_ = _e594;
                                            } else {
                                                phi_619_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e598 = phi_619_;
                                            let _e603 = (2u * ((select(16u, (_e565 / 16u), _e595) * _e452) + (_e453 + 2u)));
                                            let _e606 = atomicAdd((&global_8.member[_e603]), _e598[0]);
                                            let _e614 = atomicAdd((&global_8.member[(_e603 + 1u)]), (_e598[1] + select(0u, 1u, ((_e606 + _e598[0]) < _e598[0]))));
                                        }
                                        let _e616 = bitcast<u32>(_e447);
                                        let _e619 = ((_e616 >> bitcast<u32>(23i)) & 255u);
                                        if (_e619 == 0u) {
                                        } else {
                                            let _e622 = (_e619 % 16u);
                                            let _e624 = ((_e616 & 8388607u) | 8388608u);
                                            let _e627 = (_e624 << bitcast<u32>((_e622 & 31u)));
                                            let _e633 = ((_e624 >> bitcast<u32>(((31u - _e622) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e616 >> bitcast<u32>(31i)) == 0u) {
                                                phi_669_ = array<u32, 2>(_e627, _e633);
                                            } else {
                                                let _e639 = (~(_e627) + 1u);
                                                if (_e639 == 0u) {
                                                    phi_667_ = (~(_e633) + 1u);
                                                } else {
                                                    phi_667_ = ~(_e633);
                                                }
                                                let _e645 = phi_667_;
                                                phi_669_ = array<u32, 2>(_e639, _e645);
                                            }
                                            let _e648 = phi_669_;
                                            let _e649 = (_e619 < 255u);
                                            if _e649 {
                                                phi_675_ = _e648;
                                            } else {
                                                phi_675_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e652 = phi_675_;
                                            let _e657 = (2u * ((select(16u, (_e619 / 16u), _e649) * _e452) + (_e453 + 3u)));
                                            let _e660 = atomicAdd((&global_8.member[_e657]), _e652[0]);
                                            let _e668 = atomicAdd((&global_8.member[(_e657 + 1u)]), (_e652[1] + select(0u, 1u, ((_e660 + _e652[0]) < _e652[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e186 + _e199)] = vec4<f32>(_e435, _e439, _e443, _e447);
                                    }
                                }
                                phi_191_ = _e158;
                                phi_194_ = _e167;
                                phi_196_ = _e162;
                            }
                            let _e2366 = phi_191_;
                            let _e2368 = phi_194_;
                            let _e2370 = phi_196_;
                            local_44 = _e2366;
                            local_45 = _e2368;
                            local_47 = _e2370;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2390 = local_44;
                            phi_190_ = _e2390;
                            let _e2393 = local_45;
                            phi_193_ = _e2393;
                            let _e2398 = local_47;
                            phi_195_ = _e2398;
                        }
                    }
                    let _e2372 = phi_2316_;
                    if _e2372 {
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
