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
    var phi_264_: u32;
    var phi_268_: u32;
    var phi_271_: type_21;
    var phi_300_: u32;
    var phi_303_: type_21;
    var phi_387_: u32;
    var phi_390_: type_21;
    var local_2: type_21;
    var local_3: type_21;
    var local_4: type_21;
    var local_5: type_21;
    var phi_422_: u32;
    var phi_425_: type_21;
    var local_6: type_21;
    var local_7: type_21;
    var local_8: type_21;
    var local_9: type_21;
    var phi_500_: u32;
    var phi_502_: array<u32, 2>;
    var phi_508_: array<u32, 2>;
    var phi_556_: u32;
    var phi_558_: array<u32, 2>;
    var phi_564_: array<u32, 2>;
    var phi_612_: u32;
    var phi_614_: array<u32, 2>;
    var phi_620_: array<u32, 2>;
    var phi_668_: u32;
    var phi_670_: array<u32, 2>;
    var phi_676_: array<u32, 2>;
    var phi_732_: vec4<f32>;
    var phi_743_: vec4<f32>;
    var phi_754_: vec4<f32>;
    var phi_765_: vec4<f32>;
    var phi_778_: u32;
    var phi_782_: type_21;
    var phi_785_: type_21;
    var phi_787_: type_21;
    var phi_789_: type_21;
    var phi_791_: u32;
    var phi_878_: u32;
    var phi_881_: type_21;
    var phi_883_: type_21;
    var phi_885_: type_21;
    var phi_887_: type_21;
    var phi_1145_: type_21;
    var phi_1148_: type_21;
    var phi_1150_: type_21;
    var phi_1152_: type_21;
    var phi_1154_: u32;
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
    var phi_1250_: type_21;
    var phi_1253_: type_21;
    var phi_1255_: type_21;
    var phi_1257_: type_21;
    var phi_1259_: u32;
    var local_26: type_21;
    var local_27: type_21;
    var local_28: type_21;
    var local_29: type_21;
    var phi_1386_: u32;
    var phi_1388_: array<u32, 2>;
    var phi_1394_: array<u32, 2>;
    var phi_1442_: u32;
    var phi_1444_: array<u32, 2>;
    var phi_1450_: array<u32, 2>;
    var phi_1498_: u32;
    var phi_1500_: array<u32, 2>;
    var phi_1506_: array<u32, 2>;
    var phi_1554_: u32;
    var phi_1556_: array<u32, 2>;
    var phi_1562_: array<u32, 2>;
    var local_30: type_21;
    var local_31: type_21;
    var local_32: type_21;
    var local_33: type_21;
    var phi_1629_: u32;
    var phi_1631_: array<u32, 2>;
    var phi_1637_: array<u32, 2>;
    var phi_1685_: u32;
    var phi_1687_: array<u32, 2>;
    var phi_1693_: array<u32, 2>;
    var phi_1741_: u32;
    var phi_1743_: array<u32, 2>;
    var phi_1749_: array<u32, 2>;
    var phi_1797_: u32;
    var phi_1799_: array<u32, 2>;
    var phi_1805_: array<u32, 2>;
    var local_34: type_21;
    var local_35: type_21;
    var local_36: type_21;
    var local_37: type_21;
    var phi_1872_: u32;
    var phi_1874_: array<u32, 2>;
    var phi_1880_: array<u32, 2>;
    var phi_1928_: u32;
    var phi_1930_: array<u32, 2>;
    var phi_1936_: array<u32, 2>;
    var phi_1984_: u32;
    var phi_1986_: array<u32, 2>;
    var phi_1992_: array<u32, 2>;
    var phi_2040_: u32;
    var phi_2042_: array<u32, 2>;
    var phi_2048_: array<u32, 2>;
    var local_38: type_21;
    var local_39: type_21;
    var local_40: type_21;
    var local_41: type_21;
    var phi_2115_: u32;
    var phi_2117_: array<u32, 2>;
    var phi_2123_: array<u32, 2>;
    var phi_2171_: u32;
    var phi_2173_: array<u32, 2>;
    var phi_2179_: array<u32, 2>;
    var phi_2227_: u32;
    var phi_2229_: array<u32, 2>;
    var phi_2235_: array<u32, 2>;
    var phi_2283_: u32;
    var phi_2285_: array<u32, 2>;
    var phi_2291_: array<u32, 2>;
    var phi_2316_: u32;
    var phi_192_: u32;
    var phi_195_: u32;
    var phi_197_: u32;
    var phi_2317_: bool;
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
    var local_52: u32;
    var local_53: type_21;
    var local_54: type_21;
    var local_55: u32;
    var local_56: type_21;
    var local_57: type_21;
    var local_58: type_21;
    var local_59: type_21;
    var local_60: type_21;
    var local_61: u32;
    var local_62: type_21;
    var local_63: type_21;
    var local_64: type_21;
    var local_65: type_21;
    var local_66: type_21;
    var local_67: type_21;
    var local_68: type_21;
    var local_69: type_21;
    var local_70: type_21;
    var local_71: type_21;
    var local_72: type_21;
    var local_73: type_21;
    var local_74: type_21;
    var local_75: type_21;
    var local_76: type_21;
    var local_77: type_21;
    var local_78: u32;
    var local_79: type_21;
    var local_80: type_21;
    var local_81: type_21;
    var local_82: type_21;
    var local_83: u32;

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
                            let _e2376 = local_42;
                            phi_116_ = _e2376;
                            let _e2379 = local_43;
                            phi_119_ = _e2379;
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
                    let _e2397 = local_46;
                    phi_196_ = _e2397;
                    loop {
                        let _e159 = phi_191_;
                        let _e161 = phi_194_;
                        let _e163 = phi_196_;
                        phi_2317_ = false;
                        if (_e161 < select(_e70, _e78, (_e78 < _e70))) {
                            if (_e161 == _e159) {
                                let _e2360 = global_6.member[((_e163 + 2u) * _e113)];
                                if _e123 {
                                    phi_2316_ = _e2360;
                                } else {
                                    let _e2363 = global_4.member[_e2360];
                                    phi_2316_ = _e2363;
                                }
                                let _e2365 = phi_2316_;
                                phi_192_ = _e2365;
                                phi_195_ = _e161;
                                phi_197_ = (_e163 + 1u);
                            } else {
                                let _e166 = (_e161 + _e57);
                                let _e168 = select(_e159, _e166, (_e166 < _e159));
                                let _e169 = (_e54 == 0u);
                                if _e169 {
                                    phi_2317_ = true;
                                    break;
                                }
                                let _e170 = (_e51 / _e54);
                                if _e169 {
                                    phi_2317_ = true;
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
                                    let _e670 = (_e170 * 4u);
                                    let _e673 = global_5.member.member_5;
                                    let _e676 = ((_e673 + (_e670 * _e54)) + _e171);
                                    let _e677 = (_e61 - _e670);
                                    let _e681 = (_e676 + (select(_e677, 1u, (1u < _e677)) * _e54));
                                    let _e685 = (_e676 + (select(_e677, 2u, (2u < _e677)) * _e54));
                                    let _e689 = (_e676 + (select(_e677, 3u, (3u < _e677)) * _e54));
                                    let _e694 = (_e670 * _e193);
                                    let _e695 = (_e670 + 1u);
                                    let _e698 = (select(_e61, _e695, (_e695 < _e61)) * _e193);
                                    let _e699 = (_e670 + 2u);
                                    let _e702 = (select(_e61, _e699, (_e699 < _e61)) * _e193);
                                    let _e703 = (_e670 + 3u);
                                    let _e706 = (select(_e61, _e703, (_e703 < _e61)) * _e193);
                                    if _e190 {
                                        let _e709 = global_8.member[(_e185 + _e676)];
                                        phi_732_ = _e709;
                                    } else {
                                        phi_732_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e711 = phi_732_;
                                    if _e190 {
                                        let _e719 = global_8.member[(_e185 + _e681)];
                                        phi_743_ = _e719;
                                    } else {
                                        phi_743_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e721 = phi_743_;
                                    if _e190 {
                                        let _e729 = global_8.member[(_e185 + _e685)];
                                        phi_754_ = _e729;
                                    } else {
                                        phi_754_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e731 = phi_754_;
                                    if _e190 {
                                        let _e739 = global_8.member[(_e185 + _e689)];
                                        phi_765_ = _e739;
                                    } else {
                                        phi_765_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e741 = phi_765_;
                                    let _e747 = (_e175 % 4u);
                                    if (_e747 == 0u) {
                                        phi_778_ = _e175;
                                    } else {
                                        phi_778_ = (_e175 + (4u - _e747));
                                    }
                                    let _e752 = phi_778_;
                                    phi_782_ = type_21(_e741.x, _e741.y, _e741.z, _e741.w);
                                    phi_785_ = type_21(_e731.x, _e731.y, _e731.z, _e731.w);
                                    phi_787_ = type_21(_e721.x, _e721.y, _e721.z, _e721.w);
                                    phi_789_ = type_21(_e711.x, _e711.y, _e711.z, _e711.w);
                                    phi_791_ = _e175;
                                    loop {
                                        let _e756 = phi_782_;
                                        let _e758 = phi_785_;
                                        let _e760 = phi_787_;
                                        let _e762 = phi_789_;
                                        let _e764 = phi_791_;
                                        let _e765 = (_e764 + 1u);
                                        local_62 = _e756;
                                        local_64 = _e758;
                                        local_66 = _e760;
                                        local_68 = _e762;
                                        if (_e765 <= select(_e178, _e752, (_e752 < _e178))) {
                                            let _e767 = (_e195 + _e764);
                                            let _e770 = global_7.member[_e767];
                                            let _e774 = global_7.member[(_e767 + _e193)];
                                            let _e779 = global_7.member[(_e767 + (2u * _e193))];
                                            let _e784 = global_7.member[(_e767 + (3u * _e193))];
                                            let _e788 = global_3.member[(_e694 + _e764)];
                                            let _e805 = global_3.member[(_e698 + _e764)];
                                            let _e822 = global_3.member[(_e702 + _e764)];
                                            let _e839 = global_3.member[(_e706 + _e764)];
                                            local_57 = type_21(((_e839 * _e770) + _e756.member), ((_e839 * _e774) + _e756.member_1), ((_e839 * _e779) + _e756.member_2), ((_e839 * _e784) + _e756.member_3));
                                            local_58 = type_21(((_e822 * _e770) + _e758.member), ((_e822 * _e774) + _e758.member_1), ((_e822 * _e779) + _e758.member_2), ((_e822 * _e784) + _e758.member_3));
                                            local_59 = type_21(((_e805 * _e770) + _e760.member), ((_e805 * _e774) + _e760.member_1), ((_e805 * _e779) + _e760.member_2), ((_e805 * _e784) + _e760.member_3));
                                            local_60 = type_21(((_e788 * _e770) + _e762.member), ((_e788 * _e774) + _e762.member_1), ((_e788 * _e779) + _e762.member_2), ((_e788 * _e784) + _e762.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2456 = local_57;
                                            phi_782_ = _e2456;
                                            let _e2459 = local_58;
                                            phi_785_ = _e2459;
                                            let _e2462 = local_59;
                                            phi_787_ = _e2462;
                                            let _e2465 = local_60;
                                            phi_789_ = _e2465;
                                            phi_791_ = _e765;
                                        }
                                    }
                                    let _e858 = (_e193 / 4u);
                                    phi_878_ = (_e752 / 4u);
                                    let _e2472 = local_62;
                                    phi_881_ = _e2472;
                                    let _e2477 = local_64;
                                    phi_883_ = _e2477;
                                    let _e2482 = local_66;
                                    phi_885_ = _e2482;
                                    let _e2487 = local_68;
                                    phi_887_ = _e2487;
                                    loop {
                                        let _e861 = phi_878_;
                                        let _e863 = phi_881_;
                                        let _e865 = phi_883_;
                                        let _e867 = phi_885_;
                                        let _e869 = phi_887_;
                                        let _e870 = (4u * _e861);
                                        local_70 = _e863;
                                        local_72 = _e865;
                                        local_74 = _e867;
                                        local_76 = _e869;
                                        local_78 = _e870;
                                        if ((_e870 + 4u) <= _e178) {
                                            let _e873 = ((_e195 / 4u) + _e861);
                                            let _e874 = (4u * _e873);
                                            let _e877 = global_7.member[_e874];
                                            let _e881 = global_7.member[(_e874 + 1u)];
                                            let _e885 = global_7.member[(_e874 + 2u)];
                                            let _e889 = global_7.member[(_e874 + 3u)];
                                            let _e891 = (4u * (_e873 + _e858));
                                            let _e894 = global_7.member[_e891];
                                            let _e898 = global_7.member[(_e891 + 1u)];
                                            let _e902 = global_7.member[(_e891 + 2u)];
                                            let _e906 = global_7.member[(_e891 + 3u)];
                                            let _e909 = (4u * (_e873 + (2u * _e858)));
                                            let _e912 = global_7.member[_e909];
                                            let _e916 = global_7.member[(_e909 + 1u)];
                                            let _e920 = global_7.member[(_e909 + 2u)];
                                            let _e924 = global_7.member[(_e909 + 3u)];
                                            let _e927 = (4u * (_e873 + (3u * _e858)));
                                            let _e930 = global_7.member[_e927];
                                            let _e934 = global_7.member[(_e927 + 1u)];
                                            let _e938 = global_7.member[(_e927 + 2u)];
                                            let _e942 = global_7.member[(_e927 + 3u)];
                                            let _e944 = (4u * ((_e694 / 4u) + _e861));
                                            let _e947 = global_3.member[_e944];
                                            let _e951 = global_3.member[(_e944 + 1u)];
                                            let _e955 = global_3.member[(_e944 + 2u)];
                                            let _e959 = global_3.member[(_e944 + 3u)];
                                            let _e961 = (4u * ((_e698 / 4u) + _e861));
                                            let _e964 = global_3.member[_e961];
                                            let _e968 = global_3.member[(_e961 + 1u)];
                                            let _e972 = global_3.member[(_e961 + 2u)];
                                            let _e976 = global_3.member[(_e961 + 3u)];
                                            let _e978 = (4u * ((_e702 / 4u) + _e861));
                                            let _e981 = global_3.member[_e978];
                                            let _e985 = global_3.member[(_e978 + 1u)];
                                            let _e989 = global_3.member[(_e978 + 2u)];
                                            let _e993 = global_3.member[(_e978 + 3u)];
                                            let _e995 = (4u * ((_e706 / 4u) + _e861));
                                            let _e998 = global_3.member[_e995];
                                            let _e1002 = global_3.member[(_e995 + 1u)];
                                            let _e1006 = global_3.member[(_e995 + 2u)];
                                            let _e1010 = global_3.member[(_e995 + 3u)];
                                            local_61 = (_e861 + 1u);
                                            local_63 = type_21(((_e1010 * _e889) + ((_e1006 * _e885) + ((_e1002 * _e881) + ((_e998 * _e877) + _e863.member)))), ((_e1010 * _e906) + ((_e1006 * _e902) + ((_e1002 * _e898) + ((_e998 * _e894) + _e863.member_1)))), ((_e1010 * _e924) + ((_e1006 * _e920) + ((_e1002 * _e916) + ((_e998 * _e912) + _e863.member_2)))), ((_e1010 * _e942) + ((_e1006 * _e938) + ((_e1002 * _e934) + ((_e998 * _e930) + _e863.member_3)))));
                                            local_65 = type_21(((_e993 * _e889) + ((_e989 * _e885) + ((_e985 * _e881) + ((_e981 * _e877) + _e865.member)))), ((_e993 * _e906) + ((_e989 * _e902) + ((_e985 * _e898) + ((_e981 * _e894) + _e865.member_1)))), ((_e993 * _e924) + ((_e989 * _e920) + ((_e985 * _e916) + ((_e981 * _e912) + _e865.member_2)))), ((_e993 * _e942) + ((_e989 * _e938) + ((_e985 * _e934) + ((_e981 * _e930) + _e865.member_3)))));
                                            local_67 = type_21(((_e976 * _e889) + ((_e972 * _e885) + ((_e968 * _e881) + ((_e964 * _e877) + _e867.member)))), ((_e976 * _e906) + ((_e972 * _e902) + ((_e968 * _e898) + ((_e964 * _e894) + _e867.member_1)))), ((_e976 * _e924) + ((_e972 * _e920) + ((_e968 * _e916) + ((_e964 * _e912) + _e867.member_2)))), ((_e976 * _e942) + ((_e972 * _e938) + ((_e968 * _e934) + ((_e964 * _e930) + _e867.member_3)))));
                                            local_69 = type_21(((_e959 * _e889) + ((_e955 * _e885) + ((_e951 * _e881) + ((_e947 * _e877) + _e869.member)))), ((_e959 * _e906) + ((_e955 * _e902) + ((_e951 * _e898) + ((_e947 * _e894) + _e869.member_1)))), ((_e959 * _e924) + ((_e955 * _e920) + ((_e951 * _e916) + ((_e947 * _e912) + _e869.member_2)))), ((_e959 * _e942) + ((_e955 * _e938) + ((_e951 * _e934) + ((_e947 * _e930) + _e869.member_3)))));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2469 = local_61;
                                            phi_878_ = _e2469;
                                            let _e2474 = local_63;
                                            phi_881_ = _e2474;
                                            let _e2479 = local_65;
                                            phi_883_ = _e2479;
                                            let _e2484 = local_67;
                                            phi_885_ = _e2484;
                                            let _e2489 = local_69;
                                            phi_887_ = _e2489;
                                        }
                                    }
                                    let _e2492 = local_70;
                                    phi_1145_ = _e2492;
                                    let _e2497 = local_72;
                                    phi_1148_ = _e2497;
                                    let _e2502 = local_74;
                                    phi_1150_ = _e2502;
                                    let _e2507 = local_76;
                                    phi_1152_ = _e2507;
                                    let _e2512 = local_78;
                                    phi_1154_ = _e2512;
                                    loop {
                                        let _e1161 = phi_1145_;
                                        let _e1163 = phi_1148_;
                                        let _e1165 = phi_1150_;
                                        let _e1167 = phi_1152_;
                                        let _e1169 = phi_1154_;
                                        let _e1170 = (_e1169 + 1u);
                                        local_10 = _e1167;
                                        local_11 = _e1167;
                                        local_12 = _e1167;
                                        local_13 = _e1167;
                                        local_14 = _e1165;
                                        local_15 = _e1165;
                                        local_16 = _e1165;
                                        local_17 = _e1165;
                                        local_18 = _e1163;
                                        local_19 = _e1163;
                                        local_20 = _e1163;
                                        local_21 = _e1163;
                                        local_22 = _e1161;
                                        local_23 = _e1161;
                                        local_24 = _e1161;
                                        local_25 = _e1161;
                                        local_83 = _e1169;
                                        if (_e1170 <= _e178) {
                                            let _e1172 = (_e195 + _e1169);
                                            let _e1175 = global_7.member[_e1172];
                                            let _e1179 = global_7.member[(_e1172 + _e193)];
                                            let _e1184 = global_7.member[(_e1172 + (2u * _e193))];
                                            let _e1189 = global_7.member[(_e1172 + (3u * _e193))];
                                            let _e1193 = global_3.member[(_e694 + _e1169)];
                                            let _e1210 = global_3.member[(_e698 + _e1169)];
                                            let _e1227 = global_3.member[(_e702 + _e1169)];
                                            let _e1244 = global_3.member[(_e706 + _e1169)];
                                            local_71 = type_21(((_e1244 * _e1175) + _e1161.member), ((_e1244 * _e1179) + _e1161.member_1), ((_e1244 * _e1184) + _e1161.member_2), ((_e1244 * _e1189) + _e1161.member_3));
                                            local_73 = type_21(((_e1227 * _e1175) + _e1163.member), ((_e1227 * _e1179) + _e1163.member_1), ((_e1227 * _e1184) + _e1163.member_2), ((_e1227 * _e1189) + _e1163.member_3));
                                            local_75 = type_21(((_e1210 * _e1175) + _e1165.member), ((_e1210 * _e1179) + _e1165.member_1), ((_e1210 * _e1184) + _e1165.member_2), ((_e1210 * _e1189) + _e1165.member_3));
                                            local_77 = type_21(((_e1193 * _e1175) + _e1167.member), ((_e1193 * _e1179) + _e1167.member_1), ((_e1193 * _e1184) + _e1167.member_2), ((_e1193 * _e1189) + _e1167.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2494 = local_71;
                                            phi_1145_ = _e2494;
                                            let _e2499 = local_73;
                                            phi_1148_ = _e2499;
                                            let _e2504 = local_75;
                                            phi_1150_ = _e2504;
                                            let _e2509 = local_77;
                                            phi_1152_ = _e2509;
                                            phi_1154_ = _e1170;
                                        }
                                    }
                                    let _e1259 = local_10;
                                    let _e1262 = local_11;
                                    let _e1265 = local_12;
                                    let _e1268 = local_13;
                                    let _e1271 = local_14;
                                    let _e1274 = local_15;
                                    let _e1277 = local_16;
                                    let _e1280 = local_17;
                                    let _e1283 = local_18;
                                    let _e1286 = local_19;
                                    let _e1289 = local_20;
                                    let _e1292 = local_21;
                                    let _e1295 = local_22;
                                    let _e1298 = local_23;
                                    let _e1301 = local_24;
                                    let _e1304 = local_25;
                                    phi_1250_ = type_21(0f, 0f, 0f, 0f);
                                    phi_1253_ = type_21(0f, 0f, 0f, 0f);
                                    phi_1255_ = type_21(0f, 0f, 0f, 0f);
                                    phi_1257_ = type_21(0f, 0f, 0f, 0f);
                                    let _e2543 = local_83;
                                    phi_1259_ = _e2543;
                                    loop {
                                        let _e1307 = phi_1250_;
                                        let _e1309 = phi_1253_;
                                        let _e1311 = phi_1255_;
                                        let _e1313 = phi_1257_;
                                        let _e1315 = phi_1259_;
                                        let _e1316 = (_e1315 + 1u);
                                        local_26 = _e1313;
                                        local_27 = _e1313;
                                        local_28 = _e1313;
                                        local_29 = _e1313;
                                        local_30 = _e1311;
                                        local_31 = _e1311;
                                        local_32 = _e1311;
                                        local_33 = _e1311;
                                        local_34 = _e1309;
                                        local_35 = _e1309;
                                        local_36 = _e1309;
                                        local_37 = _e1309;
                                        local_38 = _e1307;
                                        local_39 = _e1307;
                                        local_40 = _e1307;
                                        local_41 = _e1307;
                                        if (_e1316 <= _e178) {
                                            let _e1318 = (_e195 + _e1315);
                                            let _e1321 = global_7.member[_e1318];
                                            let _e1325 = global_7.member[(_e1318 + _e193)];
                                            let _e1330 = global_7.member[(_e1318 + (2u * _e193))];
                                            let _e1335 = global_7.member[(_e1318 + (3u * _e193))];
                                            let _e1339 = global_3.member[(_e694 + _e1315)];
                                            let _e1356 = global_3.member[(_e698 + _e1315)];
                                            let _e1373 = global_3.member[(_e702 + _e1315)];
                                            let _e1390 = global_3.member[(_e706 + _e1315)];
                                            local_79 = type_21(((_e1390 * _e1321) + _e1307.member), ((_e1390 * _e1325) + _e1307.member_1), ((_e1390 * _e1330) + _e1307.member_2), ((_e1390 * _e1335) + _e1307.member_3));
                                            local_80 = type_21(((_e1373 * _e1321) + _e1309.member), ((_e1373 * _e1325) + _e1309.member_1), ((_e1373 * _e1330) + _e1309.member_2), ((_e1373 * _e1335) + _e1309.member_3));
                                            local_81 = type_21(((_e1356 * _e1321) + _e1311.member), ((_e1356 * _e1325) + _e1311.member_1), ((_e1356 * _e1330) + _e1311.member_2), ((_e1356 * _e1335) + _e1311.member_3));
                                            local_82 = type_21(((_e1339 * _e1321) + _e1313.member), ((_e1339 * _e1325) + _e1313.member_1), ((_e1339 * _e1330) + _e1313.member_2), ((_e1339 * _e1335) + _e1313.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2531 = local_79;
                                            phi_1250_ = _e2531;
                                            let _e2534 = local_80;
                                            phi_1253_ = _e2534;
                                            let _e2537 = local_81;
                                            phi_1255_ = _e2537;
                                            let _e2540 = local_82;
                                            phi_1257_ = _e2540;
                                            phi_1259_ = _e1316;
                                        }
                                    }
                                    let _e1405 = local_26;
                                    let _e1407 = (_e1259.member + _e1405.member);
                                    let _e1409 = local_27;
                                    let _e1411 = (_e1262.member_1 + _e1409.member_1);
                                    let _e1413 = local_28;
                                    let _e1415 = (_e1265.member_2 + _e1413.member_2);
                                    let _e1417 = local_29;
                                    let _e1419 = (_e1268.member_3 + _e1417.member_3);
                                    if _e188 {
                                        let _e1424 = (4u * _e184);
                                        let _e1425 = (4u * _e676);
                                        let _e1426 = bitcast<u32>(_e1407);
                                        let _e1429 = ((_e1426 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1429 == 0u) {
                                        } else {
                                            let _e1432 = (_e1429 % 16u);
                                            let _e1434 = ((_e1426 & 8388607u) | 8388608u);
                                            let _e1437 = (_e1434 << bitcast<u32>((_e1432 & 31u)));
                                            let _e1443 = ((_e1434 >> bitcast<u32>(((31u - _e1432) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1426 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1388_ = array<u32, 2>(_e1437, _e1443);
                                            } else {
                                                let _e1449 = (~(_e1437) + 1u);
                                                if (_e1449 == 0u) {
                                                    phi_1386_ = (~(_e1443) + 1u);
                                                } else {
                                                    phi_1386_ = ~(_e1443);
                                                }
                                                let _e1455 = phi_1386_;
                                                phi_1388_ = array<u32, 2>(_e1449, _e1455);
                                            }
                                            let _e1458 = phi_1388_;
                                            let _e1459 = (_e1429 < 255u);
                                            if _e1459 {
                                                phi_1394_ = _e1458;
                                            } else {
                                                phi_1394_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1462 = phi_1394_;
                                            let _e1467 = (2u * ((select(16u, (_e1429 / 16u), _e1459) * _e1424) + _e1425));
                                            let _e1470 = atomicAdd((&global_9.member[_e1467]), _e1462[0]);
                                            let _e1478 = atomicAdd((&global_9.member[(_e1467 + 1u)]), (_e1462[1] + select(0u, 1u, ((_e1470 + _e1462[0]) < _e1462[0]))));
                                        }
                                        let _e1480 = bitcast<u32>(_e1411);
                                        let _e1483 = ((_e1480 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1483 == 0u) {
                                        } else {
                                            let _e1486 = (_e1483 % 16u);
                                            let _e1488 = ((_e1480 & 8388607u) | 8388608u);
                                            let _e1491 = (_e1488 << bitcast<u32>((_e1486 & 31u)));
                                            let _e1497 = ((_e1488 >> bitcast<u32>(((31u - _e1486) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1480 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1444_ = array<u32, 2>(_e1491, _e1497);
                                            } else {
                                                let _e1503 = (~(_e1491) + 1u);
                                                if (_e1503 == 0u) {
                                                    phi_1442_ = (~(_e1497) + 1u);
                                                } else {
                                                    phi_1442_ = ~(_e1497);
                                                }
                                                let _e1509 = phi_1442_;
                                                phi_1444_ = array<u32, 2>(_e1503, _e1509);
                                            }
                                            let _e1512 = phi_1444_;
                                            let _e1513 = (_e1483 < 255u);
                                            if _e1513 {
                                                phi_1450_ = _e1512;
                                            } else {
                                                phi_1450_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1516 = phi_1450_;
                                            let _e1521 = (2u * ((select(16u, (_e1483 / 16u), _e1513) * _e1424) + (_e1425 + 1u)));
                                            let _e1524 = atomicAdd((&global_9.member[_e1521]), _e1516[0]);
                                            let _e1532 = atomicAdd((&global_9.member[(_e1521 + 1u)]), (_e1516[1] + select(0u, 1u, ((_e1524 + _e1516[0]) < _e1516[0]))));
                                        }
                                        let _e1534 = bitcast<u32>(_e1415);
                                        let _e1537 = ((_e1534 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1537 == 0u) {
                                        } else {
                                            let _e1540 = (_e1537 % 16u);
                                            let _e1542 = ((_e1534 & 8388607u) | 8388608u);
                                            let _e1545 = (_e1542 << bitcast<u32>((_e1540 & 31u)));
                                            let _e1551 = ((_e1542 >> bitcast<u32>(((31u - _e1540) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1534 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1500_ = array<u32, 2>(_e1545, _e1551);
                                            } else {
                                                let _e1557 = (~(_e1545) + 1u);
                                                if (_e1557 == 0u) {
                                                    phi_1498_ = (~(_e1551) + 1u);
                                                } else {
                                                    phi_1498_ = ~(_e1551);
                                                }
                                                let _e1563 = phi_1498_;
                                                phi_1500_ = array<u32, 2>(_e1557, _e1563);
                                            }
                                            let _e1566 = phi_1500_;
                                            let _e1567 = (_e1537 < 255u);
                                            if _e1567 {
                                                phi_1506_ = _e1566;
                                            } else {
                                                phi_1506_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1570 = phi_1506_;
                                            let _e1575 = (2u * ((select(16u, (_e1537 / 16u), _e1567) * _e1424) + (_e1425 + 2u)));
                                            let _e1578 = atomicAdd((&global_9.member[_e1575]), _e1570[0]);
                                            let _e1586 = atomicAdd((&global_9.member[(_e1575 + 1u)]), (_e1570[1] + select(0u, 1u, ((_e1578 + _e1570[0]) < _e1570[0]))));
                                        }
                                        let _e1588 = bitcast<u32>(_e1419);
                                        let _e1591 = ((_e1588 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1591 == 0u) {
                                        } else {
                                            let _e1594 = (_e1591 % 16u);
                                            let _e1596 = ((_e1588 & 8388607u) | 8388608u);
                                            let _e1599 = (_e1596 << bitcast<u32>((_e1594 & 31u)));
                                            let _e1605 = ((_e1596 >> bitcast<u32>(((31u - _e1594) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1588 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1556_ = array<u32, 2>(_e1599, _e1605);
                                            } else {
                                                let _e1611 = (~(_e1599) + 1u);
                                                if (_e1611 == 0u) {
                                                    phi_1554_ = (~(_e1605) + 1u);
                                                } else {
                                                    phi_1554_ = ~(_e1605);
                                                }
                                                let _e1617 = phi_1554_;
                                                phi_1556_ = array<u32, 2>(_e1611, _e1617);
                                            }
                                            let _e1620 = phi_1556_;
                                            let _e1621 = (_e1591 < 255u);
                                            if _e1621 {
                                                phi_1562_ = _e1620;
                                            } else {
                                                phi_1562_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1624 = phi_1562_;
                                            let _e1629 = (2u * ((select(16u, (_e1591 / 16u), _e1621) * _e1424) + (_e1425 + 3u)));
                                            let _e1632 = atomicAdd((&global_9.member[_e1629]), _e1624[0]);
                                            let _e1640 = atomicAdd((&global_9.member[(_e1629 + 1u)]), (_e1624[1] + select(0u, 1u, ((_e1632 + _e1624[0]) < _e1624[0]))));
                                        }
                                    } else {
                                        global_8.member[(_e187 + _e676)] = vec4<f32>(_e1407, _e1411, _e1415, _e1419);
                                    }
                                    if (_e695 < _e60) {
                                        let _e1643 = local_30;
                                        let _e1645 = (_e1271.member + _e1643.member);
                                        let _e1647 = local_31;
                                        let _e1649 = (_e1274.member_1 + _e1647.member_1);
                                        let _e1651 = local_32;
                                        let _e1653 = (_e1277.member_2 + _e1651.member_2);
                                        let _e1655 = local_33;
                                        let _e1657 = (_e1280.member_3 + _e1655.member_3);
                                        if _e188 {
                                            let _e1662 = (4u * _e184);
                                            let _e1663 = (4u * _e681);
                                            let _e1664 = bitcast<u32>(_e1645);
                                            let _e1667 = ((_e1664 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1667 == 0u) {
                                            } else {
                                                let _e1670 = (_e1667 % 16u);
                                                let _e1672 = ((_e1664 & 8388607u) | 8388608u);
                                                let _e1675 = (_e1672 << bitcast<u32>((_e1670 & 31u)));
                                                let _e1681 = ((_e1672 >> bitcast<u32>(((31u - _e1670) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1664 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1631_ = array<u32, 2>(_e1675, _e1681);
                                                } else {
                                                    let _e1687 = (~(_e1675) + 1u);
                                                    if (_e1687 == 0u) {
                                                        phi_1629_ = (~(_e1681) + 1u);
                                                    } else {
                                                        phi_1629_ = ~(_e1681);
                                                    }
                                                    let _e1693 = phi_1629_;
                                                    phi_1631_ = array<u32, 2>(_e1687, _e1693);
                                                }
                                                let _e1696 = phi_1631_;
                                                let _e1697 = (_e1667 < 255u);
                                                if _e1697 {
                                                    phi_1637_ = _e1696;
                                                } else {
                                                    phi_1637_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1700 = phi_1637_;
                                                let _e1705 = (2u * ((select(16u, (_e1667 / 16u), _e1697) * _e1662) + _e1663));
                                                let _e1708 = atomicAdd((&global_9.member[_e1705]), _e1700[0]);
                                                let _e1716 = atomicAdd((&global_9.member[(_e1705 + 1u)]), (_e1700[1] + select(0u, 1u, ((_e1708 + _e1700[0]) < _e1700[0]))));
                                            }
                                            let _e1718 = bitcast<u32>(_e1649);
                                            let _e1721 = ((_e1718 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1721 == 0u) {
                                            } else {
                                                let _e1724 = (_e1721 % 16u);
                                                let _e1726 = ((_e1718 & 8388607u) | 8388608u);
                                                let _e1729 = (_e1726 << bitcast<u32>((_e1724 & 31u)));
                                                let _e1735 = ((_e1726 >> bitcast<u32>(((31u - _e1724) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1718 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1687_ = array<u32, 2>(_e1729, _e1735);
                                                } else {
                                                    let _e1741 = (~(_e1729) + 1u);
                                                    if (_e1741 == 0u) {
                                                        phi_1685_ = (~(_e1735) + 1u);
                                                    } else {
                                                        phi_1685_ = ~(_e1735);
                                                    }
                                                    let _e1747 = phi_1685_;
                                                    phi_1687_ = array<u32, 2>(_e1741, _e1747);
                                                }
                                                let _e1750 = phi_1687_;
                                                let _e1751 = (_e1721 < 255u);
                                                if _e1751 {
                                                    phi_1693_ = _e1750;
                                                } else {
                                                    phi_1693_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1754 = phi_1693_;
                                                let _e1759 = (2u * ((select(16u, (_e1721 / 16u), _e1751) * _e1662) + (_e1663 + 1u)));
                                                let _e1762 = atomicAdd((&global_9.member[_e1759]), _e1754[0]);
                                                let _e1770 = atomicAdd((&global_9.member[(_e1759 + 1u)]), (_e1754[1] + select(0u, 1u, ((_e1762 + _e1754[0]) < _e1754[0]))));
                                            }
                                            let _e1772 = bitcast<u32>(_e1653);
                                            let _e1775 = ((_e1772 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1775 == 0u) {
                                            } else {
                                                let _e1778 = (_e1775 % 16u);
                                                let _e1780 = ((_e1772 & 8388607u) | 8388608u);
                                                let _e1783 = (_e1780 << bitcast<u32>((_e1778 & 31u)));
                                                let _e1789 = ((_e1780 >> bitcast<u32>(((31u - _e1778) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1772 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1743_ = array<u32, 2>(_e1783, _e1789);
                                                } else {
                                                    let _e1795 = (~(_e1783) + 1u);
                                                    if (_e1795 == 0u) {
                                                        phi_1741_ = (~(_e1789) + 1u);
                                                    } else {
                                                        phi_1741_ = ~(_e1789);
                                                    }
                                                    let _e1801 = phi_1741_;
                                                    phi_1743_ = array<u32, 2>(_e1795, _e1801);
                                                }
                                                let _e1804 = phi_1743_;
                                                let _e1805 = (_e1775 < 255u);
                                                if _e1805 {
                                                    phi_1749_ = _e1804;
                                                } else {
                                                    phi_1749_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1808 = phi_1749_;
                                                let _e1813 = (2u * ((select(16u, (_e1775 / 16u), _e1805) * _e1662) + (_e1663 + 2u)));
                                                let _e1816 = atomicAdd((&global_9.member[_e1813]), _e1808[0]);
                                                let _e1824 = atomicAdd((&global_9.member[(_e1813 + 1u)]), (_e1808[1] + select(0u, 1u, ((_e1816 + _e1808[0]) < _e1808[0]))));
                                            }
                                            let _e1826 = bitcast<u32>(_e1657);
                                            let _e1829 = ((_e1826 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1829 == 0u) {
                                            } else {
                                                let _e1832 = (_e1829 % 16u);
                                                let _e1834 = ((_e1826 & 8388607u) | 8388608u);
                                                let _e1837 = (_e1834 << bitcast<u32>((_e1832 & 31u)));
                                                let _e1843 = ((_e1834 >> bitcast<u32>(((31u - _e1832) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1826 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1799_ = array<u32, 2>(_e1837, _e1843);
                                                } else {
                                                    let _e1849 = (~(_e1837) + 1u);
                                                    if (_e1849 == 0u) {
                                                        phi_1797_ = (~(_e1843) + 1u);
                                                    } else {
                                                        phi_1797_ = ~(_e1843);
                                                    }
                                                    let _e1855 = phi_1797_;
                                                    phi_1799_ = array<u32, 2>(_e1849, _e1855);
                                                }
                                                let _e1858 = phi_1799_;
                                                let _e1859 = (_e1829 < 255u);
                                                if _e1859 {
                                                    phi_1805_ = _e1858;
                                                } else {
                                                    phi_1805_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1862 = phi_1805_;
                                                let _e1867 = (2u * ((select(16u, (_e1829 / 16u), _e1859) * _e1662) + (_e1663 + 3u)));
                                                let _e1870 = atomicAdd((&global_9.member[_e1867]), _e1862[0]);
                                                let _e1878 = atomicAdd((&global_9.member[(_e1867 + 1u)]), (_e1862[1] + select(0u, 1u, ((_e1870 + _e1862[0]) < _e1862[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e681)] = vec4<f32>(_e1645, _e1649, _e1653, _e1657);
                                        }
                                    }
                                    if (_e699 < _e60) {
                                        let _e1881 = local_34;
                                        let _e1883 = (_e1283.member + _e1881.member);
                                        let _e1885 = local_35;
                                        let _e1887 = (_e1286.member_1 + _e1885.member_1);
                                        let _e1889 = local_36;
                                        let _e1891 = (_e1289.member_2 + _e1889.member_2);
                                        let _e1893 = local_37;
                                        let _e1895 = (_e1292.member_3 + _e1893.member_3);
                                        if _e188 {
                                            let _e1900 = (4u * _e184);
                                            let _e1901 = (4u * _e685);
                                            let _e1902 = bitcast<u32>(_e1883);
                                            let _e1905 = ((_e1902 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1905 == 0u) {
                                            } else {
                                                let _e1908 = (_e1905 % 16u);
                                                let _e1910 = ((_e1902 & 8388607u) | 8388608u);
                                                let _e1913 = (_e1910 << bitcast<u32>((_e1908 & 31u)));
                                                let _e1919 = ((_e1910 >> bitcast<u32>(((31u - _e1908) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1902 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1874_ = array<u32, 2>(_e1913, _e1919);
                                                } else {
                                                    let _e1925 = (~(_e1913) + 1u);
                                                    if (_e1925 == 0u) {
                                                        phi_1872_ = (~(_e1919) + 1u);
                                                    } else {
                                                        phi_1872_ = ~(_e1919);
                                                    }
                                                    let _e1931 = phi_1872_;
                                                    phi_1874_ = array<u32, 2>(_e1925, _e1931);
                                                }
                                                let _e1934 = phi_1874_;
                                                let _e1935 = (_e1905 < 255u);
                                                if _e1935 {
                                                    phi_1880_ = _e1934;
                                                } else {
                                                    phi_1880_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1938 = phi_1880_;
                                                let _e1943 = (2u * ((select(16u, (_e1905 / 16u), _e1935) * _e1900) + _e1901));
                                                let _e1946 = atomicAdd((&global_9.member[_e1943]), _e1938[0]);
                                                let _e1954 = atomicAdd((&global_9.member[(_e1943 + 1u)]), (_e1938[1] + select(0u, 1u, ((_e1946 + _e1938[0]) < _e1938[0]))));
                                            }
                                            let _e1956 = bitcast<u32>(_e1887);
                                            let _e1959 = ((_e1956 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1959 == 0u) {
                                            } else {
                                                let _e1962 = (_e1959 % 16u);
                                                let _e1964 = ((_e1956 & 8388607u) | 8388608u);
                                                let _e1967 = (_e1964 << bitcast<u32>((_e1962 & 31u)));
                                                let _e1973 = ((_e1964 >> bitcast<u32>(((31u - _e1962) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1956 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1930_ = array<u32, 2>(_e1967, _e1973);
                                                } else {
                                                    let _e1979 = (~(_e1967) + 1u);
                                                    if (_e1979 == 0u) {
                                                        phi_1928_ = (~(_e1973) + 1u);
                                                    } else {
                                                        phi_1928_ = ~(_e1973);
                                                    }
                                                    let _e1985 = phi_1928_;
                                                    phi_1930_ = array<u32, 2>(_e1979, _e1985);
                                                }
                                                let _e1988 = phi_1930_;
                                                let _e1989 = (_e1959 < 255u);
                                                if _e1989 {
                                                    phi_1936_ = _e1988;
                                                } else {
                                                    phi_1936_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1992 = phi_1936_;
                                                let _e1997 = (2u * ((select(16u, (_e1959 / 16u), _e1989) * _e1900) + (_e1901 + 1u)));
                                                let _e2000 = atomicAdd((&global_9.member[_e1997]), _e1992[0]);
                                                let _e2008 = atomicAdd((&global_9.member[(_e1997 + 1u)]), (_e1992[1] + select(0u, 1u, ((_e2000 + _e1992[0]) < _e1992[0]))));
                                            }
                                            let _e2010 = bitcast<u32>(_e1891);
                                            let _e2013 = ((_e2010 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2013 == 0u) {
                                            } else {
                                                let _e2016 = (_e2013 % 16u);
                                                let _e2018 = ((_e2010 & 8388607u) | 8388608u);
                                                let _e2021 = (_e2018 << bitcast<u32>((_e2016 & 31u)));
                                                let _e2027 = ((_e2018 >> bitcast<u32>(((31u - _e2016) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2010 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1986_ = array<u32, 2>(_e2021, _e2027);
                                                } else {
                                                    let _e2033 = (~(_e2021) + 1u);
                                                    if (_e2033 == 0u) {
                                                        phi_1984_ = (~(_e2027) + 1u);
                                                    } else {
                                                        phi_1984_ = ~(_e2027);
                                                    }
                                                    let _e2039 = phi_1984_;
                                                    phi_1986_ = array<u32, 2>(_e2033, _e2039);
                                                }
                                                let _e2042 = phi_1986_;
                                                let _e2043 = (_e2013 < 255u);
                                                if _e2043 {
                                                    phi_1992_ = _e2042;
                                                } else {
                                                    phi_1992_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2046 = phi_1992_;
                                                let _e2051 = (2u * ((select(16u, (_e2013 / 16u), _e2043) * _e1900) + (_e1901 + 2u)));
                                                let _e2054 = atomicAdd((&global_9.member[_e2051]), _e2046[0]);
                                                let _e2062 = atomicAdd((&global_9.member[(_e2051 + 1u)]), (_e2046[1] + select(0u, 1u, ((_e2054 + _e2046[0]) < _e2046[0]))));
                                            }
                                            let _e2064 = bitcast<u32>(_e1895);
                                            let _e2067 = ((_e2064 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2067 == 0u) {
                                            } else {
                                                let _e2070 = (_e2067 % 16u);
                                                let _e2072 = ((_e2064 & 8388607u) | 8388608u);
                                                let _e2075 = (_e2072 << bitcast<u32>((_e2070 & 31u)));
                                                let _e2081 = ((_e2072 >> bitcast<u32>(((31u - _e2070) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2064 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2042_ = array<u32, 2>(_e2075, _e2081);
                                                } else {
                                                    let _e2087 = (~(_e2075) + 1u);
                                                    if (_e2087 == 0u) {
                                                        phi_2040_ = (~(_e2081) + 1u);
                                                    } else {
                                                        phi_2040_ = ~(_e2081);
                                                    }
                                                    let _e2093 = phi_2040_;
                                                    phi_2042_ = array<u32, 2>(_e2087, _e2093);
                                                }
                                                let _e2096 = phi_2042_;
                                                let _e2097 = (_e2067 < 255u);
                                                if _e2097 {
                                                    phi_2048_ = _e2096;
                                                } else {
                                                    phi_2048_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2100 = phi_2048_;
                                                let _e2105 = (2u * ((select(16u, (_e2067 / 16u), _e2097) * _e1900) + (_e1901 + 3u)));
                                                let _e2108 = atomicAdd((&global_9.member[_e2105]), _e2100[0]);
                                                let _e2116 = atomicAdd((&global_9.member[(_e2105 + 1u)]), (_e2100[1] + select(0u, 1u, ((_e2108 + _e2100[0]) < _e2100[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e685)] = vec4<f32>(_e1883, _e1887, _e1891, _e1895);
                                        }
                                    }
                                    if (_e703 < _e60) {
                                        let _e2119 = local_38;
                                        let _e2121 = (_e1295.member + _e2119.member);
                                        let _e2123 = local_39;
                                        let _e2125 = (_e1298.member_1 + _e2123.member_1);
                                        let _e2127 = local_40;
                                        let _e2129 = (_e1301.member_2 + _e2127.member_2);
                                        let _e2131 = local_41;
                                        let _e2133 = (_e1304.member_3 + _e2131.member_3);
                                        if _e188 {
                                            let _e2138 = (4u * _e184);
                                            let _e2139 = (4u * _e689);
                                            let _e2140 = bitcast<u32>(_e2121);
                                            let _e2143 = ((_e2140 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2143 == 0u) {
                                            } else {
                                                let _e2146 = (_e2143 % 16u);
                                                let _e2148 = ((_e2140 & 8388607u) | 8388608u);
                                                let _e2151 = (_e2148 << bitcast<u32>((_e2146 & 31u)));
                                                let _e2157 = ((_e2148 >> bitcast<u32>(((31u - _e2146) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2140 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2117_ = array<u32, 2>(_e2151, _e2157);
                                                } else {
                                                    let _e2163 = (~(_e2151) + 1u);
                                                    if (_e2163 == 0u) {
                                                        phi_2115_ = (~(_e2157) + 1u);
                                                    } else {
                                                        phi_2115_ = ~(_e2157);
                                                    }
                                                    let _e2169 = phi_2115_;
                                                    phi_2117_ = array<u32, 2>(_e2163, _e2169);
                                                }
                                                let _e2172 = phi_2117_;
                                                let _e2173 = (_e2143 < 255u);
                                                if _e2173 {
                                                    phi_2123_ = _e2172;
                                                } else {
                                                    phi_2123_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2176 = phi_2123_;
                                                let _e2181 = (2u * ((select(16u, (_e2143 / 16u), _e2173) * _e2138) + _e2139));
                                                let _e2184 = atomicAdd((&global_9.member[_e2181]), _e2176[0]);
                                                let _e2192 = atomicAdd((&global_9.member[(_e2181 + 1u)]), (_e2176[1] + select(0u, 1u, ((_e2184 + _e2176[0]) < _e2176[0]))));
                                            }
                                            let _e2194 = bitcast<u32>(_e2125);
                                            let _e2197 = ((_e2194 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2197 == 0u) {
                                            } else {
                                                let _e2200 = (_e2197 % 16u);
                                                let _e2202 = ((_e2194 & 8388607u) | 8388608u);
                                                let _e2205 = (_e2202 << bitcast<u32>((_e2200 & 31u)));
                                                let _e2211 = ((_e2202 >> bitcast<u32>(((31u - _e2200) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2194 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2173_ = array<u32, 2>(_e2205, _e2211);
                                                } else {
                                                    let _e2217 = (~(_e2205) + 1u);
                                                    if (_e2217 == 0u) {
                                                        phi_2171_ = (~(_e2211) + 1u);
                                                    } else {
                                                        phi_2171_ = ~(_e2211);
                                                    }
                                                    let _e2223 = phi_2171_;
                                                    phi_2173_ = array<u32, 2>(_e2217, _e2223);
                                                }
                                                let _e2226 = phi_2173_;
                                                let _e2227 = (_e2197 < 255u);
                                                if _e2227 {
                                                    phi_2179_ = _e2226;
                                                } else {
                                                    phi_2179_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2230 = phi_2179_;
                                                let _e2235 = (2u * ((select(16u, (_e2197 / 16u), _e2227) * _e2138) + (_e2139 + 1u)));
                                                let _e2238 = atomicAdd((&global_9.member[_e2235]), _e2230[0]);
                                                let _e2246 = atomicAdd((&global_9.member[(_e2235 + 1u)]), (_e2230[1] + select(0u, 1u, ((_e2238 + _e2230[0]) < _e2230[0]))));
                                            }
                                            let _e2248 = bitcast<u32>(_e2129);
                                            let _e2251 = ((_e2248 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2251 == 0u) {
                                            } else {
                                                let _e2254 = (_e2251 % 16u);
                                                let _e2256 = ((_e2248 & 8388607u) | 8388608u);
                                                let _e2259 = (_e2256 << bitcast<u32>((_e2254 & 31u)));
                                                let _e2265 = ((_e2256 >> bitcast<u32>(((31u - _e2254) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2248 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2229_ = array<u32, 2>(_e2259, _e2265);
                                                } else {
                                                    let _e2271 = (~(_e2259) + 1u);
                                                    if (_e2271 == 0u) {
                                                        phi_2227_ = (~(_e2265) + 1u);
                                                    } else {
                                                        phi_2227_ = ~(_e2265);
                                                    }
                                                    let _e2277 = phi_2227_;
                                                    phi_2229_ = array<u32, 2>(_e2271, _e2277);
                                                }
                                                let _e2280 = phi_2229_;
                                                let _e2281 = (_e2251 < 255u);
                                                if _e2281 {
                                                    phi_2235_ = _e2280;
                                                } else {
                                                    phi_2235_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2284 = phi_2235_;
                                                let _e2289 = (2u * ((select(16u, (_e2251 / 16u), _e2281) * _e2138) + (_e2139 + 2u)));
                                                let _e2292 = atomicAdd((&global_9.member[_e2289]), _e2284[0]);
                                                let _e2300 = atomicAdd((&global_9.member[(_e2289 + 1u)]), (_e2284[1] + select(0u, 1u, ((_e2292 + _e2284[0]) < _e2284[0]))));
                                            }
                                            let _e2302 = bitcast<u32>(_e2133);
                                            let _e2305 = ((_e2302 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2305 == 0u) {
                                            } else {
                                                let _e2308 = (_e2305 % 16u);
                                                let _e2310 = ((_e2302 & 8388607u) | 8388608u);
                                                let _e2313 = (_e2310 << bitcast<u32>((_e2308 & 31u)));
                                                let _e2319 = ((_e2310 >> bitcast<u32>(((31u - _e2308) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2302 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2285_ = array<u32, 2>(_e2313, _e2319);
                                                } else {
                                                    let _e2325 = (~(_e2313) + 1u);
                                                    if (_e2325 == 0u) {
                                                        phi_2283_ = (~(_e2319) + 1u);
                                                    } else {
                                                        phi_2283_ = ~(_e2319);
                                                    }
                                                    let _e2331 = phi_2283_;
                                                    phi_2285_ = array<u32, 2>(_e2325, _e2331);
                                                }
                                                let _e2334 = phi_2285_;
                                                let _e2335 = (_e2305 < 255u);
                                                if _e2335 {
                                                    phi_2291_ = _e2334;
                                                } else {
                                                    phi_2291_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2338 = phi_2291_;
                                                let _e2343 = (2u * ((select(16u, (_e2305 / 16u), _e2335) * _e2138) + (_e2139 + 3u)));
                                                let _e2346 = atomicAdd((&global_9.member[_e2343]), _e2338[0]);
                                                let _e2354 = atomicAdd((&global_9.member[(_e2343 + 1u)]), (_e2338[1] + select(0u, 1u, ((_e2346 + _e2338[0]) < _e2338[0]))));
                                            }
                                        } else {
                                            global_8.member[(_e187 + _e689)] = vec4<f32>(_e2121, _e2125, _e2129, _e2133);
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
                                    let _e212 = (_e175 % 4u);
                                    if (_e212 == 0u) {
                                        phi_264_ = _e175;
                                    } else {
                                        phi_264_ = (_e175 + (4u - _e212));
                                    }
                                    let _e217 = phi_264_;
                                    phi_268_ = _e175;
                                    phi_271_ = type_21(_e206.x, _e206.y, _e206.z, _e206.w);
                                    loop {
                                        let _e221 = phi_268_;
                                        let _e223 = phi_271_;
                                        let _e224 = (_e221 + 1u);
                                        local_50 = _e223;
                                        if (_e224 <= select(_e178, _e217, (_e217 < _e178))) {
                                            let _e226 = (_e195 + _e221);
                                            let _e229 = global_7.member[_e226];
                                            let _e233 = global_7.member[(_e226 + _e193)];
                                            let _e238 = global_7.member[(_e226 + (2u * _e193))];
                                            let _e243 = global_7.member[(_e226 + (3u * _e193))];
                                            local_48 = type_21((_e223.member + _e229), (_e223.member_1 + _e233), (_e223.member_2 + _e238), (_e223.member_3 + _e243));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_268_ = _e224;
                                            let _e2406 = local_48;
                                            phi_271_ = _e2406;
                                        }
                                    }
                                    phi_300_ = (_e217 / 4u);
                                    let _e2412 = local_50;
                                    phi_303_ = _e2412;
                                    loop {
                                        let _e255 = phi_300_;
                                        let _e257 = phi_303_;
                                        let _e258 = (4u * _e255);
                                        local_52 = _e258;
                                        local_53 = _e257;
                                        if ((_e258 + 4u) <= _e178) {
                                            let _e262 = ((_e195 / 4u) + _e255);
                                            let _e263 = (_e193 / 4u);
                                            let _e264 = (4u * _e262);
                                            let _e267 = global_7.member[_e264];
                                            let _e271 = global_7.member[(_e264 + 1u)];
                                            let _e275 = global_7.member[(_e264 + 2u)];
                                            let _e279 = global_7.member[(_e264 + 3u)];
                                            let _e281 = (4u * (_e262 + _e263));
                                            let _e284 = global_7.member[_e281];
                                            let _e288 = global_7.member[(_e281 + 1u)];
                                            let _e292 = global_7.member[(_e281 + 2u)];
                                            let _e296 = global_7.member[(_e281 + 3u)];
                                            let _e299 = (4u * (_e262 + (2u * _e263)));
                                            let _e302 = global_7.member[_e299];
                                            let _e306 = global_7.member[(_e299 + 1u)];
                                            let _e310 = global_7.member[(_e299 + 2u)];
                                            let _e314 = global_7.member[(_e299 + 3u)];
                                            let _e317 = (4u * (_e262 + (3u * _e263)));
                                            let _e320 = global_7.member[_e317];
                                            let _e324 = global_7.member[(_e317 + 1u)];
                                            let _e328 = global_7.member[(_e317 + 2u)];
                                            let _e332 = global_7.member[(_e317 + 3u)];
                                            local_49 = (_e255 + 1u);
                                            local_51 = type_21(((((_e257.member + _e267) + _e271) + _e275) + _e279), ((((_e257.member_1 + _e284) + _e288) + _e292) + _e296), ((((_e257.member_2 + _e302) + _e306) + _e310) + _e314), ((((_e257.member_3 + _e320) + _e324) + _e328) + _e332));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2409 = local_49;
                                            phi_300_ = _e2409;
                                            let _e2414 = local_51;
                                            phi_303_ = _e2414;
                                        }
                                    }
                                    let _e2417 = local_52;
                                    phi_387_ = _e2417;
                                    let _e2420 = local_53;
                                    phi_390_ = _e2420;
                                    loop {
                                        let _e356 = phi_387_;
                                        let _e358 = phi_390_;
                                        let _e359 = (_e356 + 1u);
                                        local_2 = _e358;
                                        local_3 = _e358;
                                        local_4 = _e358;
                                        local_5 = _e358;
                                        local_55 = _e356;
                                        if (_e359 <= _e178) {
                                            let _e361 = (_e195 + _e356);
                                            let _e364 = global_7.member[_e361];
                                            let _e368 = global_7.member[(_e361 + _e193)];
                                            let _e373 = global_7.member[(_e361 + (2u * _e193))];
                                            let _e378 = global_7.member[(_e361 + (3u * _e193))];
                                            local_54 = type_21((_e358.member + _e364), (_e358.member_1 + _e368), (_e358.member_2 + _e373), (_e358.member_3 + _e378));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_387_ = _e359;
                                            let _e2422 = local_54;
                                            phi_390_ = _e2422;
                                        }
                                    }
                                    let _e389 = local_2;
                                    let _e392 = local_3;
                                    let _e395 = local_4;
                                    let _e398 = local_5;
                                    let _e2429 = local_55;
                                    phi_422_ = _e2429;
                                    phi_425_ = type_21(0f, 0f, 0f, 0f);
                                    loop {
                                        let _e401 = phi_422_;
                                        let _e403 = phi_425_;
                                        let _e404 = (_e401 + 1u);
                                        local_6 = _e403;
                                        local_7 = _e403;
                                        local_8 = _e403;
                                        local_9 = _e403;
                                        if (_e404 <= _e178) {
                                            let _e406 = (_e195 + _e401);
                                            let _e409 = global_7.member[_e406];
                                            let _e413 = global_7.member[(_e406 + _e193)];
                                            let _e418 = global_7.member[(_e406 + (2u * _e193))];
                                            let _e423 = global_7.member[(_e406 + (3u * _e193))];
                                            local_56 = type_21((_e403.member + _e409), (_e403.member_1 + _e413), (_e403.member_2 + _e418), (_e403.member_3 + _e423));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_422_ = _e404;
                                            let _e2432 = local_56;
                                            phi_425_ = _e2432;
                                        }
                                    }
                                    let _e434 = local_6;
                                    let _e436 = (_e389.member + _e434.member);
                                    let _e438 = local_7;
                                    let _e440 = (_e392.member_1 + _e438.member_1);
                                    let _e442 = local_8;
                                    let _e444 = (_e395.member_2 + _e442.member_2);
                                    let _e446 = local_9;
                                    let _e448 = (_e398.member_3 + _e446.member_3);
                                    if _e188 {
                                        let _e453 = (4u * _e184);
                                        let _e454 = (4u * _e200);
                                        let _e455 = bitcast<u32>(_e436);
                                        let _e458 = ((_e455 >> bitcast<u32>(23i)) & 255u);
                                        if (_e458 == 0u) {
                                        } else {
                                            let _e461 = (_e458 % 16u);
                                            let _e463 = ((_e455 & 8388607u) | 8388608u);
                                            let _e466 = (_e463 << bitcast<u32>((_e461 & 31u)));
                                            let _e472 = ((_e463 >> bitcast<u32>(((31u - _e461) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e455 >> bitcast<u32>(31i)) == 0u) {
                                                phi_502_ = array<u32, 2>(_e466, _e472);
                                            } else {
                                                let _e478 = (~(_e466) + 1u);
                                                if (_e478 == 0u) {
                                                    phi_500_ = (~(_e472) + 1u);
                                                } else {
                                                    phi_500_ = ~(_e472);
                                                }
                                                let _e484 = phi_500_;
                                                phi_502_ = array<u32, 2>(_e478, _e484);
                                            }
                                            let _e487 = phi_502_;
                                            let _e488 = (_e458 < 255u);
                                            if _e488 {
                                                phi_508_ = _e487;
                                            } else {
                                                phi_508_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e491 = phi_508_;
                                            let _e496 = (2u * ((select(16u, (_e458 / 16u), _e488) * _e453) + _e454));
                                            let _e499 = atomicAdd((&global_9.member[_e496]), _e491[0]);
                                            let _e507 = atomicAdd((&global_9.member[(_e496 + 1u)]), (_e491[1] + select(0u, 1u, ((_e499 + _e491[0]) < _e491[0]))));
                                        }
                                        let _e509 = bitcast<u32>(_e440);
                                        let _e512 = ((_e509 >> bitcast<u32>(23i)) & 255u);
                                        if (_e512 == 0u) {
                                        } else {
                                            let _e515 = (_e512 % 16u);
                                            let _e517 = ((_e509 & 8388607u) | 8388608u);
                                            let _e520 = (_e517 << bitcast<u32>((_e515 & 31u)));
                                            let _e526 = ((_e517 >> bitcast<u32>(((31u - _e515) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e509 >> bitcast<u32>(31i)) == 0u) {
                                                phi_558_ = array<u32, 2>(_e520, _e526);
                                            } else {
                                                let _e532 = (~(_e520) + 1u);
                                                if (_e532 == 0u) {
                                                    phi_556_ = (~(_e526) + 1u);
                                                } else {
                                                    phi_556_ = ~(_e526);
                                                }
                                                let _e538 = phi_556_;
                                                phi_558_ = array<u32, 2>(_e532, _e538);
                                            }
                                            let _e541 = phi_558_;
                                            let _e542 = (_e512 < 255u);
                                            if _e542 {
                                                phi_564_ = _e541;
                                            } else {
                                                phi_564_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e545 = phi_564_;
                                            let _e550 = (2u * ((select(16u, (_e512 / 16u), _e542) * _e453) + (_e454 + 1u)));
                                            let _e553 = atomicAdd((&global_9.member[_e550]), _e545[0]);
                                            let _e561 = atomicAdd((&global_9.member[(_e550 + 1u)]), (_e545[1] + select(0u, 1u, ((_e553 + _e545[0]) < _e545[0]))));
                                        }
                                        let _e563 = bitcast<u32>(_e444);
                                        let _e566 = ((_e563 >> bitcast<u32>(23i)) & 255u);
                                        if (_e566 == 0u) {
                                        } else {
                                            let _e569 = (_e566 % 16u);
                                            let _e571 = ((_e563 & 8388607u) | 8388608u);
                                            let _e574 = (_e571 << bitcast<u32>((_e569 & 31u)));
                                            let _e580 = ((_e571 >> bitcast<u32>(((31u - _e569) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e563 >> bitcast<u32>(31i)) == 0u) {
                                                phi_614_ = array<u32, 2>(_e574, _e580);
                                            } else {
                                                let _e586 = (~(_e574) + 1u);
                                                if (_e586 == 0u) {
                                                    phi_612_ = (~(_e580) + 1u);
                                                } else {
                                                    phi_612_ = ~(_e580);
                                                }
                                                let _e592 = phi_612_;
                                                phi_614_ = array<u32, 2>(_e586, _e592);
                                            }
                                            let _e595 = phi_614_;
                                            let _e596 = (_e566 < 255u);
                                            if _e596 {
                                                phi_620_ = _e595;
                                            } else {
                                                phi_620_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e599 = phi_620_;
                                            let _e604 = (2u * ((select(16u, (_e566 / 16u), _e596) * _e453) + (_e454 + 2u)));
                                            let _e607 = atomicAdd((&global_9.member[_e604]), _e599[0]);
                                            let _e615 = atomicAdd((&global_9.member[(_e604 + 1u)]), (_e599[1] + select(0u, 1u, ((_e607 + _e599[0]) < _e599[0]))));
                                        }
                                        let _e617 = bitcast<u32>(_e448);
                                        let _e620 = ((_e617 >> bitcast<u32>(23i)) & 255u);
                                        if (_e620 == 0u) {
                                        } else {
                                            let _e623 = (_e620 % 16u);
                                            let _e625 = ((_e617 & 8388607u) | 8388608u);
                                            let _e628 = (_e625 << bitcast<u32>((_e623 & 31u)));
                                            let _e634 = ((_e625 >> bitcast<u32>(((31u - _e623) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e617 >> bitcast<u32>(31i)) == 0u) {
                                                phi_670_ = array<u32, 2>(_e628, _e634);
                                            } else {
                                                let _e640 = (~(_e628) + 1u);
                                                if (_e640 == 0u) {
                                                    phi_668_ = (~(_e634) + 1u);
                                                } else {
                                                    phi_668_ = ~(_e634);
                                                }
                                                let _e646 = phi_668_;
                                                phi_670_ = array<u32, 2>(_e640, _e646);
                                            }
                                            let _e649 = phi_670_;
                                            let _e650 = (_e620 < 255u);
                                            if _e650 {
                                                phi_676_ = _e649;
                                            } else {
                                                phi_676_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e653 = phi_676_;
                                            let _e658 = (2u * ((select(16u, (_e620 / 16u), _e650) * _e453) + (_e454 + 3u)));
                                            let _e661 = atomicAdd((&global_9.member[_e658]), _e653[0]);
                                            let _e669 = atomicAdd((&global_9.member[(_e658 + 1u)]), (_e653[1] + select(0u, 1u, ((_e661 + _e653[0]) < _e653[0]))));
                                        }
                                    } else {
                                        global_8.member[(_e187 + _e200)] = vec4<f32>(_e436, _e440, _e444, _e448);
                                    }
                                }
                                phi_192_ = _e159;
                                phi_195_ = _e168;
                                phi_197_ = _e163;
                            }
                            let _e2367 = phi_192_;
                            let _e2369 = phi_195_;
                            let _e2371 = phi_197_;
                            local_44 = _e2367;
                            local_45 = _e2369;
                            local_47 = _e2371;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2391 = local_44;
                            phi_191_ = _e2391;
                            let _e2394 = local_45;
                            phi_194_ = _e2394;
                            let _e2399 = local_47;
                            phi_196_ = _e2399;
                        }
                    }
                    let _e2373 = phi_2317_;
                    if _e2373 {
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
