struct type_7 {
    member: array<vec4<f32>>,
}

struct type_10 {
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

struct type_11 {
    member: type_10,
}

struct type_17 {
    member: array<u32>,
}

struct type_21 {
    member: array<f32>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_29 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_3: type_7;
@group(0) @binding(4) 
var<storage> global_4: type_7;
@group(0) @binding(0) 
var<uniform> global_5: type_11;
@group(0) @binding(1) 
var<storage> global_6: type_17;
@group(0) @binding(2) 
var<storage> global_7: type_17;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_21;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_29;

fn function_() {
    var phi_126_: array<u32, 2>;
    var phi_159_: u32;
    var phi_162_: u32;
    var phi_183_: u32;
    var local: u32;
    var phi_198_: u32;
    var local_1: u32;
    var phi_207_: u32;
    var phi_225_: u32;
    var phi_226_: u32;
    var phi_227_: bool;
    var phi_232_: u32;
    var phi_234_: u32;
    var phi_237_: u32;
    var phi_239_: u32;
    var phi_259_: u32;
    var phi_311_: vec4<f32>;
    var phi_322_: type_23;
    var phi_325_: type_24;
    var phi_341_: bool;
    var phi_443_: type_23;
    var phi_446_: type_24;
    var phi_527_: type_23;
    var phi_530_: type_24;
    var phi_546_: bool;
    var local_2: type_23;
    var local_3: type_23;
    var local_4: type_23;
    var local_5: type_23;
    var phi_694_: u32;
    var phi_696_: array<u32, 2>;
    var phi_702_: array<u32, 2>;
    var phi_762_: u32;
    var phi_764_: array<u32, 2>;
    var phi_770_: array<u32, 2>;
    var phi_830_: u32;
    var phi_832_: array<u32, 2>;
    var phi_838_: array<u32, 2>;
    var phi_898_: u32;
    var phi_900_: array<u32, 2>;
    var phi_906_: array<u32, 2>;
    var phi_993_: vec4<f32>;
    var phi_1026_: vec4<f32>;
    var phi_1059_: vec4<f32>;
    var phi_1092_: vec4<f32>;
    var phi_1107_: type_23;
    var phi_1110_: type_23;
    var phi_1112_: type_23;
    var phi_1114_: type_23;
    var phi_1116_: type_24;
    var phi_1132_: bool;
    var phi_1386_: type_23;
    var phi_1389_: type_23;
    var phi_1391_: type_23;
    var phi_1393_: type_23;
    var phi_1395_: type_24;
    var phi_1612_: type_23;
    var phi_1615_: type_23;
    var phi_1617_: type_23;
    var phi_1619_: type_23;
    var phi_1621_: type_24;
    var phi_1637_: bool;
    var local_6: type_23;
    var local_7: type_23;
    var local_8: type_23;
    var local_9: type_23;
    var local_10: type_23;
    var local_11: type_23;
    var local_12: type_23;
    var local_13: type_23;
    var local_14: type_23;
    var local_15: type_23;
    var local_16: type_23;
    var local_17: type_23;
    var local_18: type_23;
    var local_19: type_23;
    var local_20: type_23;
    var local_21: type_23;
    var phi_1961_: u32;
    var phi_1963_: array<u32, 2>;
    var phi_1969_: array<u32, 2>;
    var phi_2029_: u32;
    var phi_2031_: array<u32, 2>;
    var phi_2037_: array<u32, 2>;
    var phi_2097_: u32;
    var phi_2099_: array<u32, 2>;
    var phi_2105_: array<u32, 2>;
    var phi_2165_: u32;
    var phi_2167_: array<u32, 2>;
    var phi_2173_: array<u32, 2>;
    var phi_2236_: u32;
    var phi_2238_: array<u32, 2>;
    var phi_2244_: array<u32, 2>;
    var phi_2303_: u32;
    var phi_2305_: array<u32, 2>;
    var phi_2311_: array<u32, 2>;
    var phi_2370_: u32;
    var phi_2372_: array<u32, 2>;
    var phi_2378_: array<u32, 2>;
    var phi_2437_: u32;
    var phi_2439_: array<u32, 2>;
    var phi_2445_: array<u32, 2>;
    var phi_2508_: u32;
    var phi_2510_: array<u32, 2>;
    var phi_2516_: array<u32, 2>;
    var phi_2575_: u32;
    var phi_2577_: array<u32, 2>;
    var phi_2583_: array<u32, 2>;
    var phi_2642_: u32;
    var phi_2644_: array<u32, 2>;
    var phi_2650_: array<u32, 2>;
    var phi_2709_: u32;
    var phi_2711_: array<u32, 2>;
    var phi_2717_: array<u32, 2>;
    var phi_2780_: u32;
    var phi_2782_: array<u32, 2>;
    var phi_2788_: array<u32, 2>;
    var phi_2847_: u32;
    var phi_2849_: array<u32, 2>;
    var phi_2855_: array<u32, 2>;
    var phi_2914_: u32;
    var phi_2916_: array<u32, 2>;
    var phi_2922_: array<u32, 2>;
    var phi_2981_: u32;
    var phi_2983_: array<u32, 2>;
    var phi_2989_: array<u32, 2>;
    var phi_3019_: u32;
    var phi_235_: u32;
    var phi_238_: u32;
    var phi_240_: u32;
    var local_22: u32;
    var local_23: u32;
    var local_24: u32;
    var local_25: u32;
    var local_26: u32;
    var local_27: u32;
    var local_28: type_23;
    var local_29: type_24;
    var local_30: type_23;
    var local_31: type_23;
    var local_32: type_24;
    var local_33: type_24;
    var local_34: type_23;
    var local_35: type_23;
    var local_36: type_24;
    var local_37: type_24;
    var local_38: type_23;
    var local_39: type_23;
    var local_40: type_23;
    var local_41: type_23;
    var local_42: type_24;
    var local_43: type_23;
    var local_44: type_23;
    var local_45: type_23;
    var local_46: type_23;
    var local_47: type_23;
    var local_48: type_23;
    var local_49: type_23;
    var local_50: type_23;
    var local_51: type_24;
    var local_52: type_24;
    var local_53: type_23;
    var local_54: type_23;
    var local_55: type_23;
    var local_56: type_23;
    var local_57: type_23;
    var local_58: type_23;
    var local_59: type_23;
    var local_60: type_23;
    var local_61: type_24;
    var local_62: type_24;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = global;
            let _e42 = global_1;
            let _e43 = global_2;
            let _e48 = global_5.member.member_10;
            let _e51 = global_5.member.member_3;
            let _e52 = (_e51 - 1u);
            let _e54 = ((_e52 / 4u) + 1u);
            let _e62 = (((_e42.x + (_e42.y * _e43.x)) * 64u) + _e41.x);
            let _e65 = global_5.member.member_4;
            if ((_e65 % 8u) == 0u) {
                let _e72 = (4u * _e65);
                let _e73 = (_e72 == 0u);
                if _e73 {
                    break;
                }
                if _e73 {
                    break;
                }
                let _e75 = (_e62 % _e72);
                phi_126_ = array<u32, 2>(((4u * (_e62 / _e72)) + ((_e75 / 8u) % 4u)), (((_e75 / 32u) * 8u) + (_e75 % 8u)));
            } else {
                let _e68 = (_e65 == 0u);
                if _e68 {
                    break;
                }
                if _e68 {
                    break;
                }
                phi_126_ = array<u32, 2>((_e62 / _e65), (_e62 % _e65));
            }
            let _e86 = phi_126_;
            let _e88 = ((4u * _e65) - 1u);
            let _e91 = (((_e88 / 32u) + 1u) == 0u);
            if _e91 {
                break;
            }
            if _e91 {
                break;
            }
            let _e96 = global_5.member.member_1;
            let _e99 = global_5.member.member;
            let _e100 = (_e96 + _e99);
            let _e103 = (_e96 + (_e42.z * _e48));
            if (_e86[0] <= _e54) {
                if (_e103 < _e100) {
                    let _e105 = (_e103 + _e48);
                    let _e110 = global_5.member.member_7;
                    phi_159_ = _e110;
                    phi_162_ = 0u;
                    loop {
                        let _e112 = phi_159_;
                        let _e114 = phi_162_;
                        let _e115 = (_e114 + 1u);
                        local = _e114;
                        local_1 = _e115;
                        local_26 = _e114;
                        if (_e115 < _e112) {
                            let _e118 = ((_e114 + _e112) / 2u);
                            let _e121 = global_5.member.member_8;
                            let _e125 = global_6.member[(_e118 * _e121)];
                            let _e128 = global_5.member.member_9;
                            if (_e128 == 0u) {
                                phi_183_ = _e125;
                            } else {
                                let _e132 = global_7.member[_e125];
                                phi_183_ = _e132;
                            }
                            let _e134 = phi_183_;
                            let _e135 = (_e134 <= _e103);
                            local_22 = select(_e118, _e112, _e135);
                            local_23 = select(_e114, _e118, _e135);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2858 = local_22;
                            phi_159_ = _e2858;
                            let _e2861 = local_23;
                            phi_162_ = _e2861;
                        }
                    }
                    let _e140 = global_5.member.member_8;
                    let _e142 = local;
                    let _e146 = global_6.member[(_e142 * _e140)];
                    let _e149 = global_5.member.member_9;
                    let _e150 = (_e149 == 0u);
                    if _e150 {
                        phi_198_ = _e146;
                    } else {
                        let _e153 = global_7.member[_e146];
                        phi_198_ = _e153;
                    }
                    let _e155 = phi_198_;
                    let _e157 = local_1;
                    let _e161 = global_6.member[(_e157 * _e140)];
                    if _e150 {
                        phi_207_ = _e161;
                    } else {
                        let _e164 = global_7.member[_e161];
                        phi_207_ = _e164;
                    }
                    let _e166 = phi_207_;
                    if (_e48 == 0u) {
                        break;
                    }
                    let _e169 = ((_e103 - _e155) % _e48);
                    if (_e42.z == 0u) {
                        phi_226_ = u32();
                        phi_227_ = true;
                    } else {
                        let _e171 = (_e169 == 0u);
                        if _e171 {
                            phi_225_ = u32();
                        } else {
                            let _e173 = ((_e103 - _e169) + _e48);
                            phi_225_ = select(_e166, _e173, (_e173 < _e166));
                        }
                        let _e177 = phi_225_;
                        phi_226_ = _e177;
                        phi_227_ = _e171;
                    }
                    let _e179 = phi_226_;
                    let _e181 = phi_227_;
                    if _e181 {
                        phi_232_ = (_e103 - _e169);
                    } else {
                        phi_232_ = _e179;
                    }
                    let _e184 = phi_232_;
                    phi_234_ = _e166;
                    phi_237_ = _e184;
                    let _e2879 = local_26;
                    phi_239_ = _e2879;
                    loop {
                        let _e186 = phi_234_;
                        let _e188 = phi_237_;
                        let _e190 = phi_239_;
                        if (_e188 < select(_e100, _e105, (_e105 < _e100))) {
                            if (_e188 == _e186) {
                                let _e2843 = global_6.member[((_e190 + 2u) * _e140)];
                                if _e150 {
                                    phi_3019_ = _e2843;
                                } else {
                                    let _e2846 = global_7.member[_e2843];
                                    phi_3019_ = _e2846;
                                }
                                let _e2848 = phi_3019_;
                                phi_235_ = _e2848;
                                phi_238_ = _e188;
                                phi_240_ = (_e190 + 1u);
                            } else {
                                let _e193 = (_e188 + _e48);
                                let _e195 = select(_e186, _e193, (_e193 < _e186));
                                let _e198 = global_5.member.member_11;
                                let _e199 = (4u * _e198);
                                if (_e188 > _e96) {
                                    phi_259_ = (_e188 - _e96);
                                } else {
                                    phi_259_ = 0u;
                                }
                                let _e203 = phi_259_;
                                let _e204 = (_e195 - _e96);
                                let _e206 = select(_e99, _e204, (_e204 < _e99));
                                let _e207 = (_e188 < _e96);
                                let _e208 = (_e195 <= _e100);
                                let _e211 = global_5.member.member_12;
                                let _e212 = (_e211 * _e199);
                                let _e214 = ((1u - _e211) * _e199);
                                let _e218 = global_5.member.member_2;
                                let _e219 = (4u * _e86[1]);
                                let _e220 = (_e219 * _e218);
                                if (_e86[0] < _e54) {
                                    let _e845 = (_e86[0] * 4u);
                                    let _e848 = global_5.member.member_5;
                                    let _e851 = (4u * (_e848 + (_e845 * _e65)));
                                    let _e852 = (_e52 - _e845);
                                    let _e857 = (_e851 + ((4u * select(_e852, 1u, (1u < _e852))) * _e65));
                                    let _e862 = (_e851 + ((4u * select(_e852, 2u, (2u < _e852))) * _e65));
                                    let _e867 = (_e851 + ((4u * select(_e852, 3u, (3u < _e852))) * _e65));
                                    let _e868 = (_e212 + _e851);
                                    let _e869 = (_e212 + _e857);
                                    let _e870 = (_e212 + _e862);
                                    let _e871 = (_e212 + _e867);
                                    let _e873 = (_e845 + 1u);
                                    let _e877 = (_e845 + 2u);
                                    let _e881 = (_e845 + 3u);
                                    let _e885 = select(false, true, _e207);
                                    if _e885 {
                                        let _e891 = global_8.member[(_e868 + select(_e88, _e219, (_e219 < _e88)))];
                                        let _e892 = (_e219 + 1u);
                                        let _e898 = global_8.member[(_e868 + select(_e88, _e892, (_e892 < _e88)))];
                                        let _e899 = (_e219 + 2u);
                                        let _e905 = global_8.member[(_e868 + select(_e88, _e899, (_e899 < _e88)))];
                                        let _e906 = (_e219 + 3u);
                                        let _e912 = global_8.member[(_e868 + select(_e88, _e906, (_e906 < _e88)))];
                                        phi_993_ = vec4<f32>(_e891, _e898, _e905, _e912);
                                    } else {
                                        phi_993_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e915 = phi_993_;
                                    if _e885 {
                                        let _e926 = global_8.member[(_e869 + select(_e88, _e219, (_e219 < _e88)))];
                                        let _e927 = (_e219 + 1u);
                                        let _e933 = global_8.member[(_e869 + select(_e88, _e927, (_e927 < _e88)))];
                                        let _e934 = (_e219 + 2u);
                                        let _e940 = global_8.member[(_e869 + select(_e88, _e934, (_e934 < _e88)))];
                                        let _e941 = (_e219 + 3u);
                                        let _e947 = global_8.member[(_e869 + select(_e88, _e941, (_e941 < _e88)))];
                                        phi_1026_ = vec4<f32>(_e926, _e933, _e940, _e947);
                                    } else {
                                        phi_1026_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e950 = phi_1026_;
                                    if _e885 {
                                        let _e961 = global_8.member[(_e870 + select(_e88, _e219, (_e219 < _e88)))];
                                        let _e962 = (_e219 + 1u);
                                        let _e968 = global_8.member[(_e870 + select(_e88, _e962, (_e962 < _e88)))];
                                        let _e969 = (_e219 + 2u);
                                        let _e975 = global_8.member[(_e870 + select(_e88, _e969, (_e969 < _e88)))];
                                        let _e976 = (_e219 + 3u);
                                        let _e982 = global_8.member[(_e870 + select(_e88, _e976, (_e976 < _e88)))];
                                        phi_1059_ = vec4<f32>(_e961, _e968, _e975, _e982);
                                    } else {
                                        phi_1059_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e985 = phi_1059_;
                                    if _e885 {
                                        let _e996 = global_8.member[(_e871 + select(_e88, _e219, (_e219 < _e88)))];
                                        let _e997 = (_e219 + 1u);
                                        let _e1003 = global_8.member[(_e871 + select(_e88, _e997, (_e997 < _e88)))];
                                        let _e1004 = (_e219 + 2u);
                                        let _e1010 = global_8.member[(_e871 + select(_e88, _e1004, (_e1004 < _e88)))];
                                        let _e1011 = (_e219 + 3u);
                                        let _e1017 = global_8.member[(_e871 + select(_e88, _e1011, (_e1011 < _e88)))];
                                        phi_1092_ = vec4<f32>(_e996, _e1003, _e1010, _e1017);
                                    } else {
                                        phi_1092_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e1020 = phi_1092_;
                                    let _e1028 = ((_e845 * _e218) / 4u);
                                    let _e1029 = ((select(_e52, _e873, (_e873 < _e52)) * _e218) / 4u);
                                    let _e1030 = ((select(_e52, _e877, (_e877 < _e52)) * _e218) / 4u);
                                    let _e1031 = ((select(_e52, _e881, (_e881 < _e52)) * _e218) / 4u);
                                    let _e1032 = (_e220 / 4u);
                                    let _e1033 = (_e218 / 4u);
                                    phi_1107_ = type_23(_e1020.x, _e1020.y, _e1020.z, _e1020.w);
                                    phi_1110_ = type_23(_e985.x, _e985.y, _e985.z, _e985.w);
                                    phi_1112_ = type_23(_e950.x, _e950.y, _e950.z, _e950.w);
                                    phi_1114_ = type_23(_e915.x, _e915.y, _e915.z, _e915.w);
                                    phi_1116_ = type_24((_e203 / 4u), _e203, _e206);
                                    loop {
                                        let _e1035 = phi_1107_;
                                        let _e1037 = phi_1110_;
                                        let _e1039 = phi_1112_;
                                        let _e1041 = phi_1114_;
                                        let _e1043 = phi_1116_;
                                        local_43 = _e1035;
                                        local_45 = _e1037;
                                        local_47 = _e1039;
                                        local_49 = _e1041;
                                        local_51 = _e1043;
                                        let _e1045 = (4u * _e1043.member);
                                        if (_e1045 < _e1043.member_2) {
                                            phi_1132_ = select(((_e1045 + 4u) > _e1043.member_2), true, (_e1045 < _e1043.member_1));
                                        } else {
                                            phi_1132_ = false;
                                        }
                                        let _e1054 = phi_1132_;
                                        if _e1054 {
                                            let _e1057 = global_4.member[(_e1032 + _e1043.member)];
                                            let _e1064 = (_e1043.member_2 - _e1043.member_1);
                                            let _e1065 = ((_e1045 - _e1043.member_1) < _e1064);
                                            let _e1066 = select(0f, _e1057.x, _e1065);
                                            let _e1069 = (((_e1045 + 1u) - _e1043.member_1) < _e1064);
                                            let _e1070 = select(0f, _e1057.y, _e1069);
                                            let _e1073 = (((_e1045 + 2u) - _e1043.member_1) < _e1064);
                                            let _e1074 = select(0f, _e1057.z, _e1073);
                                            let _e1077 = (((_e1045 + 3u) - _e1043.member_1) < _e1064);
                                            let _e1078 = select(0f, _e1057.w, _e1077);
                                            let _e1082 = global_4.member[((_e1032 + _e1033) + _e1043.member)];
                                            let _e1087 = select(0f, _e1082.x, _e1065);
                                            let _e1088 = select(0f, _e1082.y, _e1069);
                                            let _e1089 = select(0f, _e1082.z, _e1073);
                                            let _e1090 = select(0f, _e1082.w, _e1077);
                                            let _e1095 = global_4.member[((_e1032 + (2u * _e1033)) + _e1043.member)];
                                            let _e1100 = select(0f, _e1095.x, _e1065);
                                            let _e1101 = select(0f, _e1095.y, _e1069);
                                            let _e1102 = select(0f, _e1095.z, _e1073);
                                            let _e1103 = select(0f, _e1095.w, _e1077);
                                            let _e1108 = global_4.member[((_e1032 + (3u * _e1033)) + _e1043.member)];
                                            let _e1113 = select(0f, _e1108.x, _e1065);
                                            let _e1114 = select(0f, _e1108.y, _e1069);
                                            let _e1115 = select(0f, _e1108.z, _e1073);
                                            let _e1116 = select(0f, _e1108.w, _e1077);
                                            let _e1119 = global_3.member[(_e1028 + _e1043.member)];
                                            let _e1124 = select(0f, _e1119.x, _e1065);
                                            let _e1125 = select(0f, _e1119.y, _e1069);
                                            let _e1126 = select(0f, _e1119.z, _e1073);
                                            let _e1127 = select(0f, _e1119.w, _e1077);
                                            let _e1167 = global_3.member[(_e1029 + _e1043.member)];
                                            let _e1172 = select(0f, _e1167.x, _e1065);
                                            let _e1173 = select(0f, _e1167.y, _e1069);
                                            let _e1174 = select(0f, _e1167.z, _e1073);
                                            let _e1175 = select(0f, _e1167.w, _e1077);
                                            let _e1215 = global_3.member[(_e1030 + _e1043.member)];
                                            let _e1220 = select(0f, _e1215.x, _e1065);
                                            let _e1221 = select(0f, _e1215.y, _e1069);
                                            let _e1222 = select(0f, _e1215.z, _e1073);
                                            let _e1223 = select(0f, _e1215.w, _e1077);
                                            let _e1263 = global_3.member[(_e1031 + _e1043.member)];
                                            let _e1268 = select(0f, _e1263.x, _e1065);
                                            let _e1269 = select(0f, _e1263.y, _e1069);
                                            let _e1270 = select(0f, _e1263.z, _e1073);
                                            let _e1271 = select(0f, _e1263.w, _e1077);
                                            local_38 = type_23(((_e1271 * _e1078) + ((_e1270 * _e1074) + ((_e1269 * _e1070) + ((_e1268 * _e1066) + _e1035.member)))), ((_e1271 * _e1090) + ((_e1270 * _e1089) + ((_e1269 * _e1088) + ((_e1268 * _e1087) + _e1035.member_1)))), ((_e1271 * _e1103) + ((_e1270 * _e1102) + ((_e1269 * _e1101) + ((_e1268 * _e1100) + _e1035.member_2)))), ((_e1271 * _e1116) + ((_e1270 * _e1115) + ((_e1269 * _e1114) + ((_e1268 * _e1113) + _e1035.member_3)))));
                                            local_39 = type_23(((_e1223 * _e1078) + ((_e1222 * _e1074) + ((_e1221 * _e1070) + ((_e1220 * _e1066) + _e1037.member)))), ((_e1223 * _e1090) + ((_e1222 * _e1089) + ((_e1221 * _e1088) + ((_e1220 * _e1087) + _e1037.member_1)))), ((_e1223 * _e1103) + ((_e1222 * _e1102) + ((_e1221 * _e1101) + ((_e1220 * _e1100) + _e1037.member_2)))), ((_e1223 * _e1116) + ((_e1222 * _e1115) + ((_e1221 * _e1114) + ((_e1220 * _e1113) + _e1037.member_3)))));
                                            local_40 = type_23(((_e1175 * _e1078) + ((_e1174 * _e1074) + ((_e1173 * _e1070) + ((_e1172 * _e1066) + _e1039.member)))), ((_e1175 * _e1090) + ((_e1174 * _e1089) + ((_e1173 * _e1088) + ((_e1172 * _e1087) + _e1039.member_1)))), ((_e1175 * _e1103) + ((_e1174 * _e1102) + ((_e1173 * _e1101) + ((_e1172 * _e1100) + _e1039.member_2)))), ((_e1175 * _e1116) + ((_e1174 * _e1115) + ((_e1173 * _e1114) + ((_e1172 * _e1113) + _e1039.member_3)))));
                                            local_41 = type_23(((_e1127 * _e1078) + ((_e1126 * _e1074) + ((_e1125 * _e1070) + ((_e1124 * _e1066) + _e1041.member)))), ((_e1127 * _e1090) + ((_e1126 * _e1089) + ((_e1125 * _e1088) + ((_e1124 * _e1087) + _e1041.member_1)))), ((_e1127 * _e1103) + ((_e1126 * _e1102) + ((_e1125 * _e1101) + ((_e1124 * _e1100) + _e1041.member_2)))), ((_e1127 * _e1116) + ((_e1126 * _e1115) + ((_e1125 * _e1114) + ((_e1124 * _e1113) + _e1041.member_3)))));
                                            local_42 = type_24((_e1043.member + 1u), _e1043.member_1, _e1043.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2934 = local_38;
                                            phi_1107_ = _e2934;
                                            let _e2937 = local_39;
                                            phi_1110_ = _e2937;
                                            let _e2940 = local_40;
                                            phi_1112_ = _e2940;
                                            let _e2943 = local_41;
                                            phi_1114_ = _e2943;
                                            let _e2946 = local_42;
                                            phi_1116_ = _e2946;
                                        }
                                    }
                                    let _e2950 = local_43;
                                    phi_1386_ = _e2950;
                                    let _e2955 = local_45;
                                    phi_1389_ = _e2955;
                                    let _e2960 = local_47;
                                    phi_1391_ = _e2960;
                                    let _e2965 = local_49;
                                    phi_1393_ = _e2965;
                                    let _e2970 = local_51;
                                    phi_1395_ = _e2970;
                                    loop {
                                        let _e1315 = phi_1386_;
                                        let _e1317 = phi_1389_;
                                        let _e1319 = phi_1391_;
                                        let _e1321 = phi_1393_;
                                        let _e1323 = phi_1395_;
                                        local_53 = _e1315;
                                        local_55 = _e1317;
                                        local_57 = _e1319;
                                        local_59 = _e1321;
                                        local_61 = _e1323;
                                        if !((((4u * _e1323.member) + 4u) > _e1323.member_2)) {
                                            let _e1332 = global_4.member[(_e1032 + _e1323.member)];
                                            let _e1340 = global_4.member[((_e1032 + _e1033) + _e1323.member)];
                                            let _e1349 = global_4.member[((_e1032 + (2u * _e1033)) + _e1323.member)];
                                            let _e1358 = global_4.member[((_e1032 + (3u * _e1033)) + _e1323.member)];
                                            let _e1365 = global_3.member[(_e1028 + _e1323.member)];
                                            let _e1409 = global_3.member[(_e1029 + _e1323.member)];
                                            let _e1453 = global_3.member[(_e1030 + _e1323.member)];
                                            let _e1497 = global_3.member[(_e1031 + _e1323.member)];
                                            local_44 = type_23(((_e1497.w * _e1332.w) + ((_e1497.z * _e1332.z) + ((_e1497.y * _e1332.y) + ((_e1497.x * _e1332.x) + _e1315.member)))), ((_e1497.w * _e1340.w) + ((_e1497.z * _e1340.z) + ((_e1497.y * _e1340.y) + ((_e1497.x * _e1340.x) + _e1315.member_1)))), ((_e1497.w * _e1349.w) + ((_e1497.z * _e1349.z) + ((_e1497.y * _e1349.y) + ((_e1497.x * _e1349.x) + _e1315.member_2)))), ((_e1497.w * _e1358.w) + ((_e1497.z * _e1358.z) + ((_e1497.y * _e1358.y) + ((_e1497.x * _e1358.x) + _e1315.member_3)))));
                                            local_46 = type_23(((_e1453.w * _e1332.w) + ((_e1453.z * _e1332.z) + ((_e1453.y * _e1332.y) + ((_e1453.x * _e1332.x) + _e1317.member)))), ((_e1453.w * _e1340.w) + ((_e1453.z * _e1340.z) + ((_e1453.y * _e1340.y) + ((_e1453.x * _e1340.x) + _e1317.member_1)))), ((_e1453.w * _e1349.w) + ((_e1453.z * _e1349.z) + ((_e1453.y * _e1349.y) + ((_e1453.x * _e1349.x) + _e1317.member_2)))), ((_e1453.w * _e1358.w) + ((_e1453.z * _e1358.z) + ((_e1453.y * _e1358.y) + ((_e1453.x * _e1358.x) + _e1317.member_3)))));
                                            local_48 = type_23(((_e1409.w * _e1332.w) + ((_e1409.z * _e1332.z) + ((_e1409.y * _e1332.y) + ((_e1409.x * _e1332.x) + _e1319.member)))), ((_e1409.w * _e1340.w) + ((_e1409.z * _e1340.z) + ((_e1409.y * _e1340.y) + ((_e1409.x * _e1340.x) + _e1319.member_1)))), ((_e1409.w * _e1349.w) + ((_e1409.z * _e1349.z) + ((_e1409.y * _e1349.y) + ((_e1409.x * _e1349.x) + _e1319.member_2)))), ((_e1409.w * _e1358.w) + ((_e1409.z * _e1358.z) + ((_e1409.y * _e1358.y) + ((_e1409.x * _e1358.x) + _e1319.member_3)))));
                                            local_50 = type_23(((_e1365.w * _e1332.w) + ((_e1365.z * _e1332.z) + ((_e1365.y * _e1332.y) + ((_e1365.x * _e1332.x) + _e1321.member)))), ((_e1365.w * _e1340.w) + ((_e1365.z * _e1340.z) + ((_e1365.y * _e1340.y) + ((_e1365.x * _e1340.x) + _e1321.member_1)))), ((_e1365.w * _e1349.w) + ((_e1365.z * _e1349.z) + ((_e1365.y * _e1349.y) + ((_e1365.x * _e1349.x) + _e1321.member_2)))), ((_e1365.w * _e1358.w) + ((_e1365.z * _e1358.z) + ((_e1365.y * _e1358.y) + ((_e1365.x * _e1358.x) + _e1321.member_3)))));
                                            local_52 = type_24((_e1323.member + 1u), _e1323.member_1, _e1323.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2952 = local_44;
                                            phi_1386_ = _e2952;
                                            let _e2957 = local_46;
                                            phi_1389_ = _e2957;
                                            let _e2962 = local_48;
                                            phi_1391_ = _e2962;
                                            let _e2967 = local_50;
                                            phi_1393_ = _e2967;
                                            let _e2972 = local_52;
                                            phi_1395_ = _e2972;
                                        }
                                    }
                                    let _e2975 = local_53;
                                    phi_1612_ = _e2975;
                                    let _e2980 = local_55;
                                    phi_1615_ = _e2980;
                                    let _e2985 = local_57;
                                    phi_1617_ = _e2985;
                                    let _e2990 = local_59;
                                    phi_1619_ = _e2990;
                                    let _e2995 = local_61;
                                    phi_1621_ = _e2995;
                                    loop {
                                        let _e1545 = phi_1612_;
                                        let _e1547 = phi_1615_;
                                        let _e1549 = phi_1617_;
                                        let _e1551 = phi_1619_;
                                        let _e1553 = phi_1621_;
                                        local_6 = _e1551;
                                        local_7 = _e1551;
                                        local_8 = _e1551;
                                        local_9 = _e1551;
                                        local_10 = _e1549;
                                        local_11 = _e1549;
                                        local_12 = _e1549;
                                        local_13 = _e1549;
                                        local_14 = _e1547;
                                        local_15 = _e1547;
                                        local_16 = _e1547;
                                        local_17 = _e1547;
                                        local_18 = _e1545;
                                        local_19 = _e1545;
                                        local_20 = _e1545;
                                        local_21 = _e1545;
                                        let _e1555 = (4u * _e1553.member);
                                        if (_e1555 < _e1553.member_2) {
                                            phi_1637_ = select(((_e1555 + 4u) > _e1553.member_2), true, (_e1555 < _e1553.member_1));
                                        } else {
                                            phi_1637_ = false;
                                        }
                                        let _e1564 = phi_1637_;
                                        if _e1564 {
                                            let _e1567 = global_4.member[(_e1032 + _e1553.member)];
                                            let _e1574 = (_e1553.member_2 - _e1553.member_1);
                                            let _e1575 = ((_e1555 - _e1553.member_1) < _e1574);
                                            let _e1576 = select(0f, _e1567.x, _e1575);
                                            let _e1579 = (((_e1555 + 1u) - _e1553.member_1) < _e1574);
                                            let _e1580 = select(0f, _e1567.y, _e1579);
                                            let _e1583 = (((_e1555 + 2u) - _e1553.member_1) < _e1574);
                                            let _e1584 = select(0f, _e1567.z, _e1583);
                                            let _e1587 = (((_e1555 + 3u) - _e1553.member_1) < _e1574);
                                            let _e1588 = select(0f, _e1567.w, _e1587);
                                            let _e1592 = global_4.member[((_e1032 + _e1033) + _e1553.member)];
                                            let _e1597 = select(0f, _e1592.x, _e1575);
                                            let _e1598 = select(0f, _e1592.y, _e1579);
                                            let _e1599 = select(0f, _e1592.z, _e1583);
                                            let _e1600 = select(0f, _e1592.w, _e1587);
                                            let _e1605 = global_4.member[((_e1032 + (2u * _e1033)) + _e1553.member)];
                                            let _e1610 = select(0f, _e1605.x, _e1575);
                                            let _e1611 = select(0f, _e1605.y, _e1579);
                                            let _e1612 = select(0f, _e1605.z, _e1583);
                                            let _e1613 = select(0f, _e1605.w, _e1587);
                                            let _e1618 = global_4.member[((_e1032 + (3u * _e1033)) + _e1553.member)];
                                            let _e1623 = select(0f, _e1618.x, _e1575);
                                            let _e1624 = select(0f, _e1618.y, _e1579);
                                            let _e1625 = select(0f, _e1618.z, _e1583);
                                            let _e1626 = select(0f, _e1618.w, _e1587);
                                            let _e1629 = global_3.member[(_e1028 + _e1553.member)];
                                            let _e1634 = select(0f, _e1629.x, _e1575);
                                            let _e1635 = select(0f, _e1629.y, _e1579);
                                            let _e1636 = select(0f, _e1629.z, _e1583);
                                            let _e1637 = select(0f, _e1629.w, _e1587);
                                            let _e1677 = global_3.member[(_e1029 + _e1553.member)];
                                            let _e1682 = select(0f, _e1677.x, _e1575);
                                            let _e1683 = select(0f, _e1677.y, _e1579);
                                            let _e1684 = select(0f, _e1677.z, _e1583);
                                            let _e1685 = select(0f, _e1677.w, _e1587);
                                            let _e1725 = global_3.member[(_e1030 + _e1553.member)];
                                            let _e1730 = select(0f, _e1725.x, _e1575);
                                            let _e1731 = select(0f, _e1725.y, _e1579);
                                            let _e1732 = select(0f, _e1725.z, _e1583);
                                            let _e1733 = select(0f, _e1725.w, _e1587);
                                            let _e1773 = global_3.member[(_e1031 + _e1553.member)];
                                            let _e1778 = select(0f, _e1773.x, _e1575);
                                            let _e1779 = select(0f, _e1773.y, _e1579);
                                            let _e1780 = select(0f, _e1773.z, _e1583);
                                            let _e1781 = select(0f, _e1773.w, _e1587);
                                            local_54 = type_23(((_e1781 * _e1588) + ((_e1780 * _e1584) + ((_e1779 * _e1580) + ((_e1778 * _e1576) + _e1545.member)))), ((_e1781 * _e1600) + ((_e1780 * _e1599) + ((_e1779 * _e1598) + ((_e1778 * _e1597) + _e1545.member_1)))), ((_e1781 * _e1613) + ((_e1780 * _e1612) + ((_e1779 * _e1611) + ((_e1778 * _e1610) + _e1545.member_2)))), ((_e1781 * _e1626) + ((_e1780 * _e1625) + ((_e1779 * _e1624) + ((_e1778 * _e1623) + _e1545.member_3)))));
                                            local_56 = type_23(((_e1733 * _e1588) + ((_e1732 * _e1584) + ((_e1731 * _e1580) + ((_e1730 * _e1576) + _e1547.member)))), ((_e1733 * _e1600) + ((_e1732 * _e1599) + ((_e1731 * _e1598) + ((_e1730 * _e1597) + _e1547.member_1)))), ((_e1733 * _e1613) + ((_e1732 * _e1612) + ((_e1731 * _e1611) + ((_e1730 * _e1610) + _e1547.member_2)))), ((_e1733 * _e1626) + ((_e1732 * _e1625) + ((_e1731 * _e1624) + ((_e1730 * _e1623) + _e1547.member_3)))));
                                            local_58 = type_23(((_e1685 * _e1588) + ((_e1684 * _e1584) + ((_e1683 * _e1580) + ((_e1682 * _e1576) + _e1549.member)))), ((_e1685 * _e1600) + ((_e1684 * _e1599) + ((_e1683 * _e1598) + ((_e1682 * _e1597) + _e1549.member_1)))), ((_e1685 * _e1613) + ((_e1684 * _e1612) + ((_e1683 * _e1611) + ((_e1682 * _e1610) + _e1549.member_2)))), ((_e1685 * _e1626) + ((_e1684 * _e1625) + ((_e1683 * _e1624) + ((_e1682 * _e1623) + _e1549.member_3)))));
                                            local_60 = type_23(((_e1637 * _e1588) + ((_e1636 * _e1584) + ((_e1635 * _e1580) + ((_e1634 * _e1576) + _e1551.member)))), ((_e1637 * _e1600) + ((_e1636 * _e1599) + ((_e1635 * _e1598) + ((_e1634 * _e1597) + _e1551.member_1)))), ((_e1637 * _e1613) + ((_e1636 * _e1612) + ((_e1635 * _e1611) + ((_e1634 * _e1610) + _e1551.member_2)))), ((_e1637 * _e1626) + ((_e1636 * _e1625) + ((_e1635 * _e1624) + ((_e1634 * _e1623) + _e1551.member_3)))));
                                            local_62 = type_24((_e1553.member + 1u), _e1553.member_1, _e1553.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2977 = local_54;
                                            phi_1612_ = _e2977;
                                            let _e2982 = local_56;
                                            phi_1615_ = _e2982;
                                            let _e2987 = local_58;
                                            phi_1617_ = _e2987;
                                            let _e2992 = local_60;
                                            phi_1619_ = _e2992;
                                            let _e2997 = local_62;
                                            phi_1621_ = _e2997;
                                        }
                                    }
                                    let _e1825 = local_6;
                                    let _e1828 = local_7;
                                    let _e1831 = local_8;
                                    let _e1834 = local_9;
                                    let _e1837 = local_10;
                                    let _e1840 = local_11;
                                    let _e1843 = local_12;
                                    let _e1846 = local_13;
                                    let _e1849 = local_14;
                                    let _e1852 = local_15;
                                    let _e1855 = local_16;
                                    let _e1858 = local_17;
                                    let _e1861 = local_18;
                                    let _e1864 = local_19;
                                    let _e1867 = local_20;
                                    let _e1870 = local_21;
                                    let _e1872 = (_e1825.member + 0f);
                                    let _e1873 = (_e1828.member_1 + 0f);
                                    let _e1874 = (_e1831.member_2 + 0f);
                                    let _e1875 = (_e1834.member_3 + 0f);
                                    let _e1876 = (_e1837.member + 0f);
                                    let _e1877 = (_e1840.member_1 + 0f);
                                    let _e1878 = (_e1843.member_2 + 0f);
                                    let _e1879 = (_e1846.member_3 + 0f);
                                    let _e1880 = (_e1849.member + 0f);
                                    let _e1881 = (_e1852.member_1 + 0f);
                                    let _e1882 = (_e1855.member_2 + 0f);
                                    let _e1883 = (_e1858.member_3 + 0f);
                                    let _e1884 = (_e1861.member + 0f);
                                    let _e1885 = (_e1864.member_1 + 0f);
                                    let _e1886 = (_e1867.member_2 + 0f);
                                    let _e1887 = (_e1870.member_3 + 0f);
                                    if _e208 {
                                        let _e1893 = bitcast<u32>(_e1872);
                                        let _e1896 = ((_e1893 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1896 == 0u) {
                                        } else {
                                            let _e1899 = (_e1896 % 16u);
                                            let _e1901 = ((_e1893 & 8388607u) | 8388608u);
                                            let _e1904 = (_e1901 << bitcast<u32>((_e1899 & 31u)));
                                            let _e1910 = ((_e1901 >> bitcast<u32>(((31u - _e1899) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1893 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1963_ = array<u32, 2>(_e1904, _e1910);
                                            } else {
                                                let _e1916 = (~(_e1904) + 1u);
                                                if (_e1916 == 0u) {
                                                    phi_1961_ = (~(_e1910) + 1u);
                                                } else {
                                                    phi_1961_ = ~(_e1910);
                                                }
                                                let _e1922 = phi_1961_;
                                                phi_1963_ = array<u32, 2>(_e1916, _e1922);
                                            }
                                            let _e1925 = phi_1963_;
                                            let _e1926 = (_e1896 < 255u);
                                            if _e1926 {
                                                phi_1969_ = _e1925;
                                            } else {
                                                phi_1969_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1929 = phi_1969_;
                                            let _e1934 = (2u * ((select(16u, (_e1896 / 16u), _e1926) * _e199) + (_e851 + _e219)));
                                            let _e1937 = atomicAdd((&global_9.member[_e1934]), _e1929[0]);
                                            let _e1941 = (_e1929[1] + select(0u, 1u, ((_e1937 + _e1929[0]) < _e1929[0])));
                                            if (_e1941 == 0u) {
                                            } else {
                                                let _e1946 = atomicAdd((&global_9.member[(_e1934 + 1u)]), _e1941);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e851) + _e219)] = _e1872;
                                    }
                                    let _e1947 = (_e219 + 1u);
                                    if _e208 {
                                        let _e1953 = bitcast<u32>(_e1873);
                                        let _e1956 = ((_e1953 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1956 == 0u) {
                                        } else {
                                            let _e1959 = (_e1956 % 16u);
                                            let _e1961 = ((_e1953 & 8388607u) | 8388608u);
                                            let _e1964 = (_e1961 << bitcast<u32>((_e1959 & 31u)));
                                            let _e1970 = ((_e1961 >> bitcast<u32>(((31u - _e1959) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1953 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2031_ = array<u32, 2>(_e1964, _e1970);
                                            } else {
                                                let _e1976 = (~(_e1964) + 1u);
                                                if (_e1976 == 0u) {
                                                    phi_2029_ = (~(_e1970) + 1u);
                                                } else {
                                                    phi_2029_ = ~(_e1970);
                                                }
                                                let _e1982 = phi_2029_;
                                                phi_2031_ = array<u32, 2>(_e1976, _e1982);
                                            }
                                            let _e1985 = phi_2031_;
                                            let _e1986 = (_e1956 < 255u);
                                            if _e1986 {
                                                phi_2037_ = _e1985;
                                            } else {
                                                phi_2037_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1989 = phi_2037_;
                                            let _e1994 = (2u * ((select(16u, (_e1956 / 16u), _e1986) * _e199) + (_e851 + _e1947)));
                                            let _e1997 = atomicAdd((&global_9.member[_e1994]), _e1989[0]);
                                            let _e2001 = (_e1989[1] + select(0u, 1u, ((_e1997 + _e1989[0]) < _e1989[0])));
                                            if (_e2001 == 0u) {
                                            } else {
                                                let _e2006 = atomicAdd((&global_9.member[(_e1994 + 1u)]), _e2001);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e851) + _e1947)] = _e1873;
                                    }
                                    let _e2007 = (_e219 + 2u);
                                    if _e208 {
                                        let _e2013 = bitcast<u32>(_e1874);
                                        let _e2016 = ((_e2013 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2016 == 0u) {
                                        } else {
                                            let _e2019 = (_e2016 % 16u);
                                            let _e2021 = ((_e2013 & 8388607u) | 8388608u);
                                            let _e2024 = (_e2021 << bitcast<u32>((_e2019 & 31u)));
                                            let _e2030 = ((_e2021 >> bitcast<u32>(((31u - _e2019) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2013 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2099_ = array<u32, 2>(_e2024, _e2030);
                                            } else {
                                                let _e2036 = (~(_e2024) + 1u);
                                                if (_e2036 == 0u) {
                                                    phi_2097_ = (~(_e2030) + 1u);
                                                } else {
                                                    phi_2097_ = ~(_e2030);
                                                }
                                                let _e2042 = phi_2097_;
                                                phi_2099_ = array<u32, 2>(_e2036, _e2042);
                                            }
                                            let _e2045 = phi_2099_;
                                            let _e2046 = (_e2016 < 255u);
                                            if _e2046 {
                                                phi_2105_ = _e2045;
                                            } else {
                                                phi_2105_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2049 = phi_2105_;
                                            let _e2054 = (2u * ((select(16u, (_e2016 / 16u), _e2046) * _e199) + (_e851 + _e2007)));
                                            let _e2057 = atomicAdd((&global_9.member[_e2054]), _e2049[0]);
                                            let _e2061 = (_e2049[1] + select(0u, 1u, ((_e2057 + _e2049[0]) < _e2049[0])));
                                            if (_e2061 == 0u) {
                                            } else {
                                                let _e2066 = atomicAdd((&global_9.member[(_e2054 + 1u)]), _e2061);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e851) + _e2007)] = _e1874;
                                    }
                                    let _e2067 = (_e219 + 3u);
                                    if _e208 {
                                        let _e2073 = bitcast<u32>(_e1875);
                                        let _e2076 = ((_e2073 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2076 == 0u) {
                                        } else {
                                            let _e2079 = (_e2076 % 16u);
                                            let _e2081 = ((_e2073 & 8388607u) | 8388608u);
                                            let _e2084 = (_e2081 << bitcast<u32>((_e2079 & 31u)));
                                            let _e2090 = ((_e2081 >> bitcast<u32>(((31u - _e2079) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2073 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2167_ = array<u32, 2>(_e2084, _e2090);
                                            } else {
                                                let _e2096 = (~(_e2084) + 1u);
                                                if (_e2096 == 0u) {
                                                    phi_2165_ = (~(_e2090) + 1u);
                                                } else {
                                                    phi_2165_ = ~(_e2090);
                                                }
                                                let _e2102 = phi_2165_;
                                                phi_2167_ = array<u32, 2>(_e2096, _e2102);
                                            }
                                            let _e2105 = phi_2167_;
                                            let _e2106 = (_e2076 < 255u);
                                            if _e2106 {
                                                phi_2173_ = _e2105;
                                            } else {
                                                phi_2173_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2109 = phi_2173_;
                                            let _e2114 = (2u * ((select(16u, (_e2076 / 16u), _e2106) * _e199) + (_e851 + _e2067)));
                                            let _e2117 = atomicAdd((&global_9.member[_e2114]), _e2109[0]);
                                            let _e2121 = (_e2109[1] + select(0u, 1u, ((_e2117 + _e2109[0]) < _e2109[0])));
                                            if (_e2121 == 0u) {
                                            } else {
                                                let _e2126 = atomicAdd((&global_9.member[(_e2114 + 1u)]), _e2121);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e851) + _e2067)] = _e1875;
                                    }
                                    if (_e873 < _e51) {
                                        if _e208 {
                                            let _e2133 = bitcast<u32>(_e1876);
                                            let _e2136 = ((_e2133 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2136 == 0u) {
                                            } else {
                                                let _e2139 = (_e2136 % 16u);
                                                let _e2141 = ((_e2133 & 8388607u) | 8388608u);
                                                let _e2144 = (_e2141 << bitcast<u32>((_e2139 & 31u)));
                                                let _e2150 = ((_e2141 >> bitcast<u32>(((31u - _e2139) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2133 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2238_ = array<u32, 2>(_e2144, _e2150);
                                                } else {
                                                    let _e2156 = (~(_e2144) + 1u);
                                                    if (_e2156 == 0u) {
                                                        phi_2236_ = (~(_e2150) + 1u);
                                                    } else {
                                                        phi_2236_ = ~(_e2150);
                                                    }
                                                    let _e2162 = phi_2236_;
                                                    phi_2238_ = array<u32, 2>(_e2156, _e2162);
                                                }
                                                let _e2165 = phi_2238_;
                                                let _e2166 = (_e2136 < 255u);
                                                if _e2166 {
                                                    phi_2244_ = _e2165;
                                                } else {
                                                    phi_2244_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2169 = phi_2244_;
                                                let _e2174 = (2u * ((select(16u, (_e2136 / 16u), _e2166) * _e199) + (_e857 + _e219)));
                                                let _e2177 = atomicAdd((&global_9.member[_e2174]), _e2169[0]);
                                                let _e2181 = (_e2169[1] + select(0u, 1u, ((_e2177 + _e2169[0]) < _e2169[0])));
                                                if (_e2181 == 0u) {
                                                } else {
                                                    let _e2186 = atomicAdd((&global_9.member[(_e2174 + 1u)]), _e2181);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e857) + _e219)] = _e1876;
                                        }
                                        if _e208 {
                                            let _e2192 = bitcast<u32>(_e1877);
                                            let _e2195 = ((_e2192 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2195 == 0u) {
                                            } else {
                                                let _e2198 = (_e2195 % 16u);
                                                let _e2200 = ((_e2192 & 8388607u) | 8388608u);
                                                let _e2203 = (_e2200 << bitcast<u32>((_e2198 & 31u)));
                                                let _e2209 = ((_e2200 >> bitcast<u32>(((31u - _e2198) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2192 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2305_ = array<u32, 2>(_e2203, _e2209);
                                                } else {
                                                    let _e2215 = (~(_e2203) + 1u);
                                                    if (_e2215 == 0u) {
                                                        phi_2303_ = (~(_e2209) + 1u);
                                                    } else {
                                                        phi_2303_ = ~(_e2209);
                                                    }
                                                    let _e2221 = phi_2303_;
                                                    phi_2305_ = array<u32, 2>(_e2215, _e2221);
                                                }
                                                let _e2224 = phi_2305_;
                                                let _e2225 = (_e2195 < 255u);
                                                if _e2225 {
                                                    phi_2311_ = _e2224;
                                                } else {
                                                    phi_2311_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2228 = phi_2311_;
                                                let _e2233 = (2u * ((select(16u, (_e2195 / 16u), _e2225) * _e199) + (_e857 + _e1947)));
                                                let _e2236 = atomicAdd((&global_9.member[_e2233]), _e2228[0]);
                                                let _e2240 = (_e2228[1] + select(0u, 1u, ((_e2236 + _e2228[0]) < _e2228[0])));
                                                if (_e2240 == 0u) {
                                                } else {
                                                    let _e2245 = atomicAdd((&global_9.member[(_e2233 + 1u)]), _e2240);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e857) + _e1947)] = _e1877;
                                        }
                                        if _e208 {
                                            let _e2251 = bitcast<u32>(_e1878);
                                            let _e2254 = ((_e2251 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2254 == 0u) {
                                            } else {
                                                let _e2257 = (_e2254 % 16u);
                                                let _e2259 = ((_e2251 & 8388607u) | 8388608u);
                                                let _e2262 = (_e2259 << bitcast<u32>((_e2257 & 31u)));
                                                let _e2268 = ((_e2259 >> bitcast<u32>(((31u - _e2257) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2251 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2372_ = array<u32, 2>(_e2262, _e2268);
                                                } else {
                                                    let _e2274 = (~(_e2262) + 1u);
                                                    if (_e2274 == 0u) {
                                                        phi_2370_ = (~(_e2268) + 1u);
                                                    } else {
                                                        phi_2370_ = ~(_e2268);
                                                    }
                                                    let _e2280 = phi_2370_;
                                                    phi_2372_ = array<u32, 2>(_e2274, _e2280);
                                                }
                                                let _e2283 = phi_2372_;
                                                let _e2284 = (_e2254 < 255u);
                                                if _e2284 {
                                                    phi_2378_ = _e2283;
                                                } else {
                                                    phi_2378_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2287 = phi_2378_;
                                                let _e2292 = (2u * ((select(16u, (_e2254 / 16u), _e2284) * _e199) + (_e857 + _e2007)));
                                                let _e2295 = atomicAdd((&global_9.member[_e2292]), _e2287[0]);
                                                let _e2299 = (_e2287[1] + select(0u, 1u, ((_e2295 + _e2287[0]) < _e2287[0])));
                                                if (_e2299 == 0u) {
                                                } else {
                                                    let _e2304 = atomicAdd((&global_9.member[(_e2292 + 1u)]), _e2299);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e857) + _e2007)] = _e1878;
                                        }
                                        if _e208 {
                                            let _e2310 = bitcast<u32>(_e1879);
                                            let _e2313 = ((_e2310 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2313 == 0u) {
                                            } else {
                                                let _e2316 = (_e2313 % 16u);
                                                let _e2318 = ((_e2310 & 8388607u) | 8388608u);
                                                let _e2321 = (_e2318 << bitcast<u32>((_e2316 & 31u)));
                                                let _e2327 = ((_e2318 >> bitcast<u32>(((31u - _e2316) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2310 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2439_ = array<u32, 2>(_e2321, _e2327);
                                                } else {
                                                    let _e2333 = (~(_e2321) + 1u);
                                                    if (_e2333 == 0u) {
                                                        phi_2437_ = (~(_e2327) + 1u);
                                                    } else {
                                                        phi_2437_ = ~(_e2327);
                                                    }
                                                    let _e2339 = phi_2437_;
                                                    phi_2439_ = array<u32, 2>(_e2333, _e2339);
                                                }
                                                let _e2342 = phi_2439_;
                                                let _e2343 = (_e2313 < 255u);
                                                if _e2343 {
                                                    phi_2445_ = _e2342;
                                                } else {
                                                    phi_2445_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2346 = phi_2445_;
                                                let _e2351 = (2u * ((select(16u, (_e2313 / 16u), _e2343) * _e199) + (_e857 + _e2067)));
                                                let _e2354 = atomicAdd((&global_9.member[_e2351]), _e2346[0]);
                                                let _e2358 = (_e2346[1] + select(0u, 1u, ((_e2354 + _e2346[0]) < _e2346[0])));
                                                if (_e2358 == 0u) {
                                                } else {
                                                    let _e2363 = atomicAdd((&global_9.member[(_e2351 + 1u)]), _e2358);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e857) + _e2067)] = _e1879;
                                        }
                                    }
                                    if (_e877 < _e51) {
                                        if _e208 {
                                            let _e2370 = bitcast<u32>(_e1880);
                                            let _e2373 = ((_e2370 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2373 == 0u) {
                                            } else {
                                                let _e2376 = (_e2373 % 16u);
                                                let _e2378 = ((_e2370 & 8388607u) | 8388608u);
                                                let _e2381 = (_e2378 << bitcast<u32>((_e2376 & 31u)));
                                                let _e2387 = ((_e2378 >> bitcast<u32>(((31u - _e2376) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2370 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2510_ = array<u32, 2>(_e2381, _e2387);
                                                } else {
                                                    let _e2393 = (~(_e2381) + 1u);
                                                    if (_e2393 == 0u) {
                                                        phi_2508_ = (~(_e2387) + 1u);
                                                    } else {
                                                        phi_2508_ = ~(_e2387);
                                                    }
                                                    let _e2399 = phi_2508_;
                                                    phi_2510_ = array<u32, 2>(_e2393, _e2399);
                                                }
                                                let _e2402 = phi_2510_;
                                                let _e2403 = (_e2373 < 255u);
                                                if _e2403 {
                                                    phi_2516_ = _e2402;
                                                } else {
                                                    phi_2516_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2406 = phi_2516_;
                                                let _e2411 = (2u * ((select(16u, (_e2373 / 16u), _e2403) * _e199) + (_e862 + _e219)));
                                                let _e2414 = atomicAdd((&global_9.member[_e2411]), _e2406[0]);
                                                let _e2418 = (_e2406[1] + select(0u, 1u, ((_e2414 + _e2406[0]) < _e2406[0])));
                                                if (_e2418 == 0u) {
                                                } else {
                                                    let _e2423 = atomicAdd((&global_9.member[(_e2411 + 1u)]), _e2418);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e862) + _e219)] = _e1880;
                                        }
                                        if _e208 {
                                            let _e2429 = bitcast<u32>(_e1881);
                                            let _e2432 = ((_e2429 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2432 == 0u) {
                                            } else {
                                                let _e2435 = (_e2432 % 16u);
                                                let _e2437 = ((_e2429 & 8388607u) | 8388608u);
                                                let _e2440 = (_e2437 << bitcast<u32>((_e2435 & 31u)));
                                                let _e2446 = ((_e2437 >> bitcast<u32>(((31u - _e2435) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2429 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2577_ = array<u32, 2>(_e2440, _e2446);
                                                } else {
                                                    let _e2452 = (~(_e2440) + 1u);
                                                    if (_e2452 == 0u) {
                                                        phi_2575_ = (~(_e2446) + 1u);
                                                    } else {
                                                        phi_2575_ = ~(_e2446);
                                                    }
                                                    let _e2458 = phi_2575_;
                                                    phi_2577_ = array<u32, 2>(_e2452, _e2458);
                                                }
                                                let _e2461 = phi_2577_;
                                                let _e2462 = (_e2432 < 255u);
                                                if _e2462 {
                                                    phi_2583_ = _e2461;
                                                } else {
                                                    phi_2583_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2465 = phi_2583_;
                                                let _e2470 = (2u * ((select(16u, (_e2432 / 16u), _e2462) * _e199) + (_e862 + _e1947)));
                                                let _e2473 = atomicAdd((&global_9.member[_e2470]), _e2465[0]);
                                                let _e2477 = (_e2465[1] + select(0u, 1u, ((_e2473 + _e2465[0]) < _e2465[0])));
                                                if (_e2477 == 0u) {
                                                } else {
                                                    let _e2482 = atomicAdd((&global_9.member[(_e2470 + 1u)]), _e2477);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e862) + _e1947)] = _e1881;
                                        }
                                        if _e208 {
                                            let _e2488 = bitcast<u32>(_e1882);
                                            let _e2491 = ((_e2488 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2491 == 0u) {
                                            } else {
                                                let _e2494 = (_e2491 % 16u);
                                                let _e2496 = ((_e2488 & 8388607u) | 8388608u);
                                                let _e2499 = (_e2496 << bitcast<u32>((_e2494 & 31u)));
                                                let _e2505 = ((_e2496 >> bitcast<u32>(((31u - _e2494) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2488 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2644_ = array<u32, 2>(_e2499, _e2505);
                                                } else {
                                                    let _e2511 = (~(_e2499) + 1u);
                                                    if (_e2511 == 0u) {
                                                        phi_2642_ = (~(_e2505) + 1u);
                                                    } else {
                                                        phi_2642_ = ~(_e2505);
                                                    }
                                                    let _e2517 = phi_2642_;
                                                    phi_2644_ = array<u32, 2>(_e2511, _e2517);
                                                }
                                                let _e2520 = phi_2644_;
                                                let _e2521 = (_e2491 < 255u);
                                                if _e2521 {
                                                    phi_2650_ = _e2520;
                                                } else {
                                                    phi_2650_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2524 = phi_2650_;
                                                let _e2529 = (2u * ((select(16u, (_e2491 / 16u), _e2521) * _e199) + (_e862 + _e2007)));
                                                let _e2532 = atomicAdd((&global_9.member[_e2529]), _e2524[0]);
                                                let _e2536 = (_e2524[1] + select(0u, 1u, ((_e2532 + _e2524[0]) < _e2524[0])));
                                                if (_e2536 == 0u) {
                                                } else {
                                                    let _e2541 = atomicAdd((&global_9.member[(_e2529 + 1u)]), _e2536);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e862) + _e2007)] = _e1882;
                                        }
                                        if _e208 {
                                            let _e2547 = bitcast<u32>(_e1883);
                                            let _e2550 = ((_e2547 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2550 == 0u) {
                                            } else {
                                                let _e2553 = (_e2550 % 16u);
                                                let _e2555 = ((_e2547 & 8388607u) | 8388608u);
                                                let _e2558 = (_e2555 << bitcast<u32>((_e2553 & 31u)));
                                                let _e2564 = ((_e2555 >> bitcast<u32>(((31u - _e2553) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2547 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2711_ = array<u32, 2>(_e2558, _e2564);
                                                } else {
                                                    let _e2570 = (~(_e2558) + 1u);
                                                    if (_e2570 == 0u) {
                                                        phi_2709_ = (~(_e2564) + 1u);
                                                    } else {
                                                        phi_2709_ = ~(_e2564);
                                                    }
                                                    let _e2576 = phi_2709_;
                                                    phi_2711_ = array<u32, 2>(_e2570, _e2576);
                                                }
                                                let _e2579 = phi_2711_;
                                                let _e2580 = (_e2550 < 255u);
                                                if _e2580 {
                                                    phi_2717_ = _e2579;
                                                } else {
                                                    phi_2717_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2583 = phi_2717_;
                                                let _e2588 = (2u * ((select(16u, (_e2550 / 16u), _e2580) * _e199) + (_e862 + _e2067)));
                                                let _e2591 = atomicAdd((&global_9.member[_e2588]), _e2583[0]);
                                                let _e2595 = (_e2583[1] + select(0u, 1u, ((_e2591 + _e2583[0]) < _e2583[0])));
                                                if (_e2595 == 0u) {
                                                } else {
                                                    let _e2600 = atomicAdd((&global_9.member[(_e2588 + 1u)]), _e2595);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e862) + _e2067)] = _e1883;
                                        }
                                    }
                                    if (_e881 < _e51) {
                                        if _e208 {
                                            let _e2607 = bitcast<u32>(_e1884);
                                            let _e2610 = ((_e2607 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2610 == 0u) {
                                            } else {
                                                let _e2613 = (_e2610 % 16u);
                                                let _e2615 = ((_e2607 & 8388607u) | 8388608u);
                                                let _e2618 = (_e2615 << bitcast<u32>((_e2613 & 31u)));
                                                let _e2624 = ((_e2615 >> bitcast<u32>(((31u - _e2613) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2607 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2782_ = array<u32, 2>(_e2618, _e2624);
                                                } else {
                                                    let _e2630 = (~(_e2618) + 1u);
                                                    if (_e2630 == 0u) {
                                                        phi_2780_ = (~(_e2624) + 1u);
                                                    } else {
                                                        phi_2780_ = ~(_e2624);
                                                    }
                                                    let _e2636 = phi_2780_;
                                                    phi_2782_ = array<u32, 2>(_e2630, _e2636);
                                                }
                                                let _e2639 = phi_2782_;
                                                let _e2640 = (_e2610 < 255u);
                                                if _e2640 {
                                                    phi_2788_ = _e2639;
                                                } else {
                                                    phi_2788_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2643 = phi_2788_;
                                                let _e2648 = (2u * ((select(16u, (_e2610 / 16u), _e2640) * _e199) + (_e867 + _e219)));
                                                let _e2651 = atomicAdd((&global_9.member[_e2648]), _e2643[0]);
                                                let _e2655 = (_e2643[1] + select(0u, 1u, ((_e2651 + _e2643[0]) < _e2643[0])));
                                                if (_e2655 == 0u) {
                                                } else {
                                                    let _e2660 = atomicAdd((&global_9.member[(_e2648 + 1u)]), _e2655);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e867) + _e219)] = _e1884;
                                        }
                                        if _e208 {
                                            let _e2666 = bitcast<u32>(_e1885);
                                            let _e2669 = ((_e2666 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2669 == 0u) {
                                            } else {
                                                let _e2672 = (_e2669 % 16u);
                                                let _e2674 = ((_e2666 & 8388607u) | 8388608u);
                                                let _e2677 = (_e2674 << bitcast<u32>((_e2672 & 31u)));
                                                let _e2683 = ((_e2674 >> bitcast<u32>(((31u - _e2672) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2666 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2849_ = array<u32, 2>(_e2677, _e2683);
                                                } else {
                                                    let _e2689 = (~(_e2677) + 1u);
                                                    if (_e2689 == 0u) {
                                                        phi_2847_ = (~(_e2683) + 1u);
                                                    } else {
                                                        phi_2847_ = ~(_e2683);
                                                    }
                                                    let _e2695 = phi_2847_;
                                                    phi_2849_ = array<u32, 2>(_e2689, _e2695);
                                                }
                                                let _e2698 = phi_2849_;
                                                let _e2699 = (_e2669 < 255u);
                                                if _e2699 {
                                                    phi_2855_ = _e2698;
                                                } else {
                                                    phi_2855_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2702 = phi_2855_;
                                                let _e2707 = (2u * ((select(16u, (_e2669 / 16u), _e2699) * _e199) + (_e867 + _e1947)));
                                                let _e2710 = atomicAdd((&global_9.member[_e2707]), _e2702[0]);
                                                let _e2714 = (_e2702[1] + select(0u, 1u, ((_e2710 + _e2702[0]) < _e2702[0])));
                                                if (_e2714 == 0u) {
                                                } else {
                                                    let _e2719 = atomicAdd((&global_9.member[(_e2707 + 1u)]), _e2714);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e867) + _e1947)] = _e1885;
                                        }
                                        if _e208 {
                                            let _e2725 = bitcast<u32>(_e1886);
                                            let _e2728 = ((_e2725 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2728 == 0u) {
                                            } else {
                                                let _e2731 = (_e2728 % 16u);
                                                let _e2733 = ((_e2725 & 8388607u) | 8388608u);
                                                let _e2736 = (_e2733 << bitcast<u32>((_e2731 & 31u)));
                                                let _e2742 = ((_e2733 >> bitcast<u32>(((31u - _e2731) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2725 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2916_ = array<u32, 2>(_e2736, _e2742);
                                                } else {
                                                    let _e2748 = (~(_e2736) + 1u);
                                                    if (_e2748 == 0u) {
                                                        phi_2914_ = (~(_e2742) + 1u);
                                                    } else {
                                                        phi_2914_ = ~(_e2742);
                                                    }
                                                    let _e2754 = phi_2914_;
                                                    phi_2916_ = array<u32, 2>(_e2748, _e2754);
                                                }
                                                let _e2757 = phi_2916_;
                                                let _e2758 = (_e2728 < 255u);
                                                if _e2758 {
                                                    phi_2922_ = _e2757;
                                                } else {
                                                    phi_2922_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2761 = phi_2922_;
                                                let _e2766 = (2u * ((select(16u, (_e2728 / 16u), _e2758) * _e199) + (_e867 + _e2007)));
                                                let _e2769 = atomicAdd((&global_9.member[_e2766]), _e2761[0]);
                                                let _e2773 = (_e2761[1] + select(0u, 1u, ((_e2769 + _e2761[0]) < _e2761[0])));
                                                if (_e2773 == 0u) {
                                                } else {
                                                    let _e2778 = atomicAdd((&global_9.member[(_e2766 + 1u)]), _e2773);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e867) + _e2007)] = _e1886;
                                        }
                                        if _e208 {
                                            let _e2784 = bitcast<u32>(_e1887);
                                            let _e2787 = ((_e2784 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2787 == 0u) {
                                            } else {
                                                let _e2790 = (_e2787 % 16u);
                                                let _e2792 = ((_e2784 & 8388607u) | 8388608u);
                                                let _e2795 = (_e2792 << bitcast<u32>((_e2790 & 31u)));
                                                let _e2801 = ((_e2792 >> bitcast<u32>(((31u - _e2790) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2784 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2983_ = array<u32, 2>(_e2795, _e2801);
                                                } else {
                                                    let _e2807 = (~(_e2795) + 1u);
                                                    if (_e2807 == 0u) {
                                                        phi_2981_ = (~(_e2801) + 1u);
                                                    } else {
                                                        phi_2981_ = ~(_e2801);
                                                    }
                                                    let _e2813 = phi_2981_;
                                                    phi_2983_ = array<u32, 2>(_e2807, _e2813);
                                                }
                                                let _e2816 = phi_2983_;
                                                let _e2817 = (_e2787 < 255u);
                                                if _e2817 {
                                                    phi_2989_ = _e2816;
                                                } else {
                                                    phi_2989_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2820 = phi_2989_;
                                                let _e2825 = (2u * ((select(16u, (_e2787 / 16u), _e2817) * _e199) + (_e867 + _e2067)));
                                                let _e2828 = atomicAdd((&global_9.member[_e2825]), _e2820[0]);
                                                let _e2832 = (_e2820[1] + select(0u, 1u, ((_e2828 + _e2820[0]) < _e2820[0])));
                                                if (_e2832 == 0u) {
                                                } else {
                                                    let _e2837 = atomicAdd((&global_9.member[(_e2825 + 1u)]), _e2832);
                                                }
                                            }
                                        } else {
                                            global_8.member[((_e214 + _e867) + _e2067)] = _e1887;
                                        }
                                    }
                                } else {
                                    let _e224 = global_5.member.member_6;
                                    let _e225 = (4u * _e224);
                                    let _e226 = (_e212 + _e225);
                                    if select(false, true, _e207) {
                                        let _e233 = global_8.member[(_e226 + select(_e88, _e219, (_e219 < _e88)))];
                                        let _e234 = (_e219 + 1u);
                                        let _e240 = global_8.member[(_e226 + select(_e88, _e234, (_e234 < _e88)))];
                                        let _e241 = (_e219 + 2u);
                                        let _e247 = global_8.member[(_e226 + select(_e88, _e241, (_e241 < _e88)))];
                                        let _e248 = (_e219 + 3u);
                                        let _e254 = global_8.member[(_e226 + select(_e88, _e248, (_e248 < _e88)))];
                                        phi_311_ = vec4<f32>(_e233, _e240, _e247, _e254);
                                    } else {
                                        phi_311_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e257 = phi_311_;
                                    let _e265 = (_e220 / 4u);
                                    let _e266 = (_e218 / 4u);
                                    phi_322_ = type_23(_e257.x, _e257.y, _e257.z, _e257.w);
                                    phi_325_ = type_24((_e203 / 4u), _e203, _e206);
                                    loop {
                                        let _e268 = phi_322_;
                                        let _e270 = phi_325_;
                                        local_30 = _e268;
                                        local_32 = _e270;
                                        let _e272 = (4u * _e270.member);
                                        if (_e272 < _e270.member_2) {
                                            phi_341_ = select(((_e272 + 4u) > _e270.member_2), true, (_e272 < _e270.member_1));
                                        } else {
                                            phi_341_ = false;
                                        }
                                        let _e281 = phi_341_;
                                        if _e281 {
                                            let _e284 = global_4.member[(_e265 + _e270.member)];
                                            let _e291 = (_e270.member_2 - _e270.member_1);
                                            let _e292 = ((_e272 - _e270.member_1) < _e291);
                                            let _e296 = (((_e272 + 1u) - _e270.member_1) < _e291);
                                            let _e300 = (((_e272 + 2u) - _e270.member_1) < _e291);
                                            let _e304 = (((_e272 + 3u) - _e270.member_1) < _e291);
                                            let _e309 = global_4.member[((_e265 + _e266) + _e270.member)];
                                            let _e322 = global_4.member[((_e265 + (2u * _e266)) + _e270.member)];
                                            let _e335 = global_4.member[((_e265 + (3u * _e266)) + _e270.member)];
                                            local_28 = type_23(((1f * select(0f, _e284.w, _e304)) + ((1f * select(0f, _e284.z, _e300)) + ((1f * select(0f, _e284.y, _e296)) + ((1f * select(0f, _e284.x, _e292)) + _e268.member)))), ((1f * select(0f, _e309.w, _e304)) + ((1f * select(0f, _e309.z, _e300)) + ((1f * select(0f, _e309.y, _e296)) + ((1f * select(0f, _e309.x, _e292)) + _e268.member_1)))), ((1f * select(0f, _e322.w, _e304)) + ((1f * select(0f, _e322.z, _e300)) + ((1f * select(0f, _e322.y, _e296)) + ((1f * select(0f, _e322.x, _e292)) + _e268.member_2)))), ((1f * select(0f, _e335.w, _e304)) + ((1f * select(0f, _e335.z, _e300)) + ((1f * select(0f, _e335.y, _e296)) + ((1f * select(0f, _e335.x, _e292)) + _e268.member_3)))));
                                            local_29 = type_24((_e270.member + 1u), _e270.member_1, _e270.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2886 = local_28;
                                            phi_322_ = _e2886;
                                            let _e2889 = local_29;
                                            phi_325_ = _e2889;
                                        }
                                    }
                                    let _e2893 = local_30;
                                    phi_443_ = _e2893;
                                    let _e2898 = local_32;
                                    phi_446_ = _e2898;
                                    loop {
                                        let _e387 = phi_443_;
                                        let _e389 = phi_446_;
                                        local_34 = _e387;
                                        local_36 = _e389;
                                        if !((((4u * _e389.member) + 4u) > _e389.member_2)) {
                                            let _e398 = global_4.member[(_e265 + _e389.member)];
                                            let _e406 = global_4.member[((_e265 + _e266) + _e389.member)];
                                            let _e415 = global_4.member[((_e265 + (2u * _e266)) + _e389.member)];
                                            let _e424 = global_4.member[((_e265 + (3u * _e266)) + _e389.member)];
                                            local_31 = type_23(((1f * _e398.w) + ((1f * _e398.z) + ((1f * _e398.y) + ((1f * _e398.x) + _e387.member)))), ((1f * _e406.w) + ((1f * _e406.z) + ((1f * _e406.y) + ((1f * _e406.x) + _e387.member_1)))), ((1f * _e415.w) + ((1f * _e415.z) + ((1f * _e415.y) + ((1f * _e415.x) + _e387.member_2)))), ((1f * _e424.w) + ((1f * _e424.z) + ((1f * _e424.y) + ((1f * _e424.x) + _e387.member_3)))));
                                            local_33 = type_24((_e389.member + 1u), _e389.member_1, _e389.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2895 = local_31;
                                            phi_443_ = _e2895;
                                            let _e2900 = local_33;
                                            phi_446_ = _e2900;
                                        }
                                    }
                                    let _e2903 = local_34;
                                    phi_527_ = _e2903;
                                    let _e2908 = local_36;
                                    phi_530_ = _e2908;
                                    loop {
                                        let _e472 = phi_527_;
                                        let _e474 = phi_530_;
                                        local_2 = _e472;
                                        local_3 = _e472;
                                        local_4 = _e472;
                                        local_5 = _e472;
                                        let _e476 = (4u * _e474.member);
                                        if (_e476 < _e474.member_2) {
                                            phi_546_ = select(((_e476 + 4u) > _e474.member_2), true, (_e476 < _e474.member_1));
                                        } else {
                                            phi_546_ = false;
                                        }
                                        let _e485 = phi_546_;
                                        if _e485 {
                                            let _e488 = global_4.member[(_e265 + _e474.member)];
                                            let _e495 = (_e474.member_2 - _e474.member_1);
                                            let _e496 = ((_e476 - _e474.member_1) < _e495);
                                            let _e500 = (((_e476 + 1u) - _e474.member_1) < _e495);
                                            let _e504 = (((_e476 + 2u) - _e474.member_1) < _e495);
                                            let _e508 = (((_e476 + 3u) - _e474.member_1) < _e495);
                                            let _e513 = global_4.member[((_e265 + _e266) + _e474.member)];
                                            let _e526 = global_4.member[((_e265 + (2u * _e266)) + _e474.member)];
                                            let _e539 = global_4.member[((_e265 + (3u * _e266)) + _e474.member)];
                                            local_35 = type_23(((1f * select(0f, _e488.w, _e508)) + ((1f * select(0f, _e488.z, _e504)) + ((1f * select(0f, _e488.y, _e500)) + ((1f * select(0f, _e488.x, _e496)) + _e472.member)))), ((1f * select(0f, _e513.w, _e508)) + ((1f * select(0f, _e513.z, _e504)) + ((1f * select(0f, _e513.y, _e500)) + ((1f * select(0f, _e513.x, _e496)) + _e472.member_1)))), ((1f * select(0f, _e526.w, _e508)) + ((1f * select(0f, _e526.z, _e504)) + ((1f * select(0f, _e526.y, _e500)) + ((1f * select(0f, _e526.x, _e496)) + _e472.member_2)))), ((1f * select(0f, _e539.w, _e508)) + ((1f * select(0f, _e539.z, _e504)) + ((1f * select(0f, _e539.y, _e500)) + ((1f * select(0f, _e539.x, _e496)) + _e472.member_3)))));
                                            local_37 = type_24((_e474.member + 1u), _e474.member_1, _e474.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2905 = local_35;
                                            phi_527_ = _e2905;
                                            let _e2910 = local_37;
                                            phi_530_ = _e2910;
                                        }
                                    }
                                    let _e591 = local_2;
                                    let _e594 = local_3;
                                    let _e597 = local_4;
                                    let _e600 = local_5;
                                    let _e602 = (_e591.member + 0f);
                                    let _e603 = (_e594.member_1 + 0f);
                                    let _e604 = (_e597.member_2 + 0f);
                                    let _e605 = (_e600.member_3 + 0f);
                                    if _e208 {
                                        let _e611 = bitcast<u32>(_e602);
                                        let _e614 = ((_e611 >> bitcast<u32>(23i)) & 255u);
                                        if (_e614 == 0u) {
                                        } else {
                                            let _e617 = (_e614 % 16u);
                                            let _e619 = ((_e611 & 8388607u) | 8388608u);
                                            let _e622 = (_e619 << bitcast<u32>((_e617 & 31u)));
                                            let _e628 = ((_e619 >> bitcast<u32>(((31u - _e617) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e611 >> bitcast<u32>(31i)) == 0u) {
                                                phi_696_ = array<u32, 2>(_e622, _e628);
                                            } else {
                                                let _e634 = (~(_e622) + 1u);
                                                if (_e634 == 0u) {
                                                    phi_694_ = (~(_e628) + 1u);
                                                } else {
                                                    phi_694_ = ~(_e628);
                                                }
                                                let _e640 = phi_694_;
                                                phi_696_ = array<u32, 2>(_e634, _e640);
                                            }
                                            let _e643 = phi_696_;
                                            let _e644 = (_e614 < 255u);
                                            if _e644 {
                                                phi_702_ = _e643;
                                            } else {
                                                phi_702_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e647 = phi_702_;
                                            let _e652 = (2u * ((select(16u, (_e614 / 16u), _e644) * _e199) + (_e225 + _e219)));
                                            let _e655 = atomicAdd((&global_9.member[_e652]), _e647[0]);
                                            let _e659 = (_e647[1] + select(0u, 1u, ((_e655 + _e647[0]) < _e647[0])));
                                            if (_e659 == 0u) {
                                            } else {
                                                let _e664 = atomicAdd((&global_9.member[(_e652 + 1u)]), _e659);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e225) + _e219)] = _e602;
                                    }
                                    let _e665 = (_e219 + 1u);
                                    if _e208 {
                                        let _e671 = bitcast<u32>(_e603);
                                        let _e674 = ((_e671 >> bitcast<u32>(23i)) & 255u);
                                        if (_e674 == 0u) {
                                        } else {
                                            let _e677 = (_e674 % 16u);
                                            let _e679 = ((_e671 & 8388607u) | 8388608u);
                                            let _e682 = (_e679 << bitcast<u32>((_e677 & 31u)));
                                            let _e688 = ((_e679 >> bitcast<u32>(((31u - _e677) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e671 >> bitcast<u32>(31i)) == 0u) {
                                                phi_764_ = array<u32, 2>(_e682, _e688);
                                            } else {
                                                let _e694 = (~(_e682) + 1u);
                                                if (_e694 == 0u) {
                                                    phi_762_ = (~(_e688) + 1u);
                                                } else {
                                                    phi_762_ = ~(_e688);
                                                }
                                                let _e700 = phi_762_;
                                                phi_764_ = array<u32, 2>(_e694, _e700);
                                            }
                                            let _e703 = phi_764_;
                                            let _e704 = (_e674 < 255u);
                                            if _e704 {
                                                phi_770_ = _e703;
                                            } else {
                                                phi_770_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e707 = phi_770_;
                                            let _e712 = (2u * ((select(16u, (_e674 / 16u), _e704) * _e199) + (_e225 + _e665)));
                                            let _e715 = atomicAdd((&global_9.member[_e712]), _e707[0]);
                                            let _e719 = (_e707[1] + select(0u, 1u, ((_e715 + _e707[0]) < _e707[0])));
                                            if (_e719 == 0u) {
                                            } else {
                                                let _e724 = atomicAdd((&global_9.member[(_e712 + 1u)]), _e719);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e225) + _e665)] = _e603;
                                    }
                                    let _e725 = (_e219 + 2u);
                                    if _e208 {
                                        let _e731 = bitcast<u32>(_e604);
                                        let _e734 = ((_e731 >> bitcast<u32>(23i)) & 255u);
                                        if (_e734 == 0u) {
                                        } else {
                                            let _e737 = (_e734 % 16u);
                                            let _e739 = ((_e731 & 8388607u) | 8388608u);
                                            let _e742 = (_e739 << bitcast<u32>((_e737 & 31u)));
                                            let _e748 = ((_e739 >> bitcast<u32>(((31u - _e737) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e731 >> bitcast<u32>(31i)) == 0u) {
                                                phi_832_ = array<u32, 2>(_e742, _e748);
                                            } else {
                                                let _e754 = (~(_e742) + 1u);
                                                if (_e754 == 0u) {
                                                    phi_830_ = (~(_e748) + 1u);
                                                } else {
                                                    phi_830_ = ~(_e748);
                                                }
                                                let _e760 = phi_830_;
                                                phi_832_ = array<u32, 2>(_e754, _e760);
                                            }
                                            let _e763 = phi_832_;
                                            let _e764 = (_e734 < 255u);
                                            if _e764 {
                                                phi_838_ = _e763;
                                            } else {
                                                phi_838_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e767 = phi_838_;
                                            let _e772 = (2u * ((select(16u, (_e734 / 16u), _e764) * _e199) + (_e225 + _e725)));
                                            let _e775 = atomicAdd((&global_9.member[_e772]), _e767[0]);
                                            let _e779 = (_e767[1] + select(0u, 1u, ((_e775 + _e767[0]) < _e767[0])));
                                            if (_e779 == 0u) {
                                            } else {
                                                let _e784 = atomicAdd((&global_9.member[(_e772 + 1u)]), _e779);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e225) + _e725)] = _e604;
                                    }
                                    let _e785 = (_e219 + 3u);
                                    if _e208 {
                                        let _e791 = bitcast<u32>(_e605);
                                        let _e794 = ((_e791 >> bitcast<u32>(23i)) & 255u);
                                        if (_e794 == 0u) {
                                        } else {
                                            let _e797 = (_e794 % 16u);
                                            let _e799 = ((_e791 & 8388607u) | 8388608u);
                                            let _e802 = (_e799 << bitcast<u32>((_e797 & 31u)));
                                            let _e808 = ((_e799 >> bitcast<u32>(((31u - _e797) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e791 >> bitcast<u32>(31i)) == 0u) {
                                                phi_900_ = array<u32, 2>(_e802, _e808);
                                            } else {
                                                let _e814 = (~(_e802) + 1u);
                                                if (_e814 == 0u) {
                                                    phi_898_ = (~(_e808) + 1u);
                                                } else {
                                                    phi_898_ = ~(_e808);
                                                }
                                                let _e820 = phi_898_;
                                                phi_900_ = array<u32, 2>(_e814, _e820);
                                            }
                                            let _e823 = phi_900_;
                                            let _e824 = (_e794 < 255u);
                                            if _e824 {
                                                phi_906_ = _e823;
                                            } else {
                                                phi_906_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e827 = phi_906_;
                                            let _e832 = (2u * ((select(16u, (_e794 / 16u), _e824) * _e199) + (_e225 + _e785)));
                                            let _e835 = atomicAdd((&global_9.member[_e832]), _e827[0]);
                                            let _e839 = (_e827[1] + select(0u, 1u, ((_e835 + _e827[0]) < _e827[0])));
                                            if (_e839 == 0u) {
                                            } else {
                                                let _e844 = atomicAdd((&global_9.member[(_e832 + 1u)]), _e839);
                                            }
                                        }
                                    } else {
                                        global_8.member[((_e214 + _e225) + _e785)] = _e605;
                                    }
                                }
                                phi_235_ = _e186;
                                phi_238_ = _e195;
                                phi_240_ = _e190;
                            }
                            let _e2850 = phi_235_;
                            let _e2852 = phi_238_;
                            let _e2854 = phi_240_;
                            local_24 = _e2850;
                            local_25 = _e2852;
                            local_27 = _e2854;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2873 = local_24;
                            phi_234_ = _e2873;
                            let _e2876 = local_25;
                            phi_237_ = _e2876;
                            let _e2881 = local_27;
                            phi_239_ = _e2881;
                        }
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
