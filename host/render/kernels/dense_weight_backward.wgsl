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

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32>,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_23 {
    member: array<vec4<f32>>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_23;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(3) 
var<storage> global_9: type_23;

fn function_() {
    var phi_122_: array<u32, 2>;
    var phi_155_: u32;
    var phi_158_: u32;
    var phi_179_: u32;
    var local: u32;
    var phi_194_: u32;
    var local_1: u32;
    var phi_203_: u32;
    var phi_221_: u32;
    var phi_222_: u32;
    var phi_223_: bool;
    var phi_228_: u32;
    var phi_230_: u32;
    var phi_233_: u32;
    var phi_235_: u32;
    var phi_255_: u32;
    var phi_307_: vec4<f32>;
    var phi_316_: type_20;
    var phi_319_: type_19;
    var phi_335_: bool;
    var phi_423_: type_20;
    var phi_426_: type_19;
    var phi_493_: type_20;
    var phi_496_: type_19;
    var phi_512_: bool;
    var local_2: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var phi_646_: u32;
    var phi_648_: array<u32, 2>;
    var phi_654_: array<u32, 2>;
    var phi_714_: u32;
    var phi_716_: array<u32, 2>;
    var phi_722_: array<u32, 2>;
    var phi_782_: u32;
    var phi_784_: array<u32, 2>;
    var phi_790_: array<u32, 2>;
    var phi_850_: u32;
    var phi_852_: array<u32, 2>;
    var phi_858_: array<u32, 2>;
    var phi_944_: vec4<f32>;
    var phi_977_: vec4<f32>;
    var phi_1010_: vec4<f32>;
    var phi_1043_: vec4<f32>;
    var phi_1058_: type_19;
    var phi_1061_: type_19;
    var phi_1063_: type_19;
    var phi_1065_: type_19;
    var phi_1067_: type_20;
    var phi_1083_: bool;
    var phi_1337_: type_19;
    var phi_1340_: type_19;
    var phi_1342_: type_19;
    var phi_1344_: type_19;
    var phi_1346_: type_20;
    var phi_1563_: type_19;
    var phi_1566_: type_19;
    var phi_1568_: type_19;
    var phi_1570_: type_19;
    var phi_1572_: type_20;
    var phi_1588_: bool;
    var local_6: type_19;
    var local_7: type_19;
    var local_8: type_19;
    var local_9: type_19;
    var local_10: type_19;
    var local_11: type_19;
    var local_12: type_19;
    var local_13: type_19;
    var local_14: type_19;
    var local_15: type_19;
    var local_16: type_19;
    var local_17: type_19;
    var local_18: type_19;
    var local_19: type_19;
    var local_20: type_19;
    var local_21: type_19;
    var phi_1900_: u32;
    var phi_1902_: array<u32, 2>;
    var phi_1908_: array<u32, 2>;
    var phi_1968_: u32;
    var phi_1970_: array<u32, 2>;
    var phi_1976_: array<u32, 2>;
    var phi_2036_: u32;
    var phi_2038_: array<u32, 2>;
    var phi_2044_: array<u32, 2>;
    var phi_2104_: u32;
    var phi_2106_: array<u32, 2>;
    var phi_2112_: array<u32, 2>;
    var phi_2179_: u32;
    var phi_2181_: array<u32, 2>;
    var phi_2187_: array<u32, 2>;
    var phi_2246_: u32;
    var phi_2248_: array<u32, 2>;
    var phi_2254_: array<u32, 2>;
    var phi_2313_: u32;
    var phi_2315_: array<u32, 2>;
    var phi_2321_: array<u32, 2>;
    var phi_2380_: u32;
    var phi_2382_: array<u32, 2>;
    var phi_2388_: array<u32, 2>;
    var phi_2455_: u32;
    var phi_2457_: array<u32, 2>;
    var phi_2463_: array<u32, 2>;
    var phi_2522_: u32;
    var phi_2524_: array<u32, 2>;
    var phi_2530_: array<u32, 2>;
    var phi_2589_: u32;
    var phi_2591_: array<u32, 2>;
    var phi_2597_: array<u32, 2>;
    var phi_2656_: u32;
    var phi_2658_: array<u32, 2>;
    var phi_2664_: array<u32, 2>;
    var phi_2731_: u32;
    var phi_2733_: array<u32, 2>;
    var phi_2739_: array<u32, 2>;
    var phi_2798_: u32;
    var phi_2800_: array<u32, 2>;
    var phi_2806_: array<u32, 2>;
    var phi_2865_: u32;
    var phi_2867_: array<u32, 2>;
    var phi_2873_: array<u32, 2>;
    var phi_2932_: u32;
    var phi_2934_: array<u32, 2>;
    var phi_2940_: array<u32, 2>;
    var phi_2970_: u32;
    var phi_231_: u32;
    var phi_234_: u32;
    var phi_236_: u32;
    var local_22: u32;
    var local_23: u32;
    var local_24: u32;
    var local_25: u32;
    var local_26: u32;
    var local_27: u32;
    var local_28: type_20;
    var local_29: type_19;
    var local_30: type_20;
    var local_31: type_20;
    var local_32: type_19;
    var local_33: type_19;
    var local_34: type_20;
    var local_35: type_20;
    var local_36: type_19;
    var local_37: type_19;
    var local_38: type_19;
    var local_39: type_19;
    var local_40: type_19;
    var local_41: type_19;
    var local_42: type_20;
    var local_43: type_19;
    var local_44: type_19;
    var local_45: type_19;
    var local_46: type_19;
    var local_47: type_19;
    var local_48: type_19;
    var local_49: type_19;
    var local_50: type_19;
    var local_51: type_20;
    var local_52: type_20;
    var local_53: type_19;
    var local_54: type_19;
    var local_55: type_19;
    var local_56: type_19;
    var local_57: type_19;
    var local_58: type_19;
    var local_59: type_19;
    var local_60: type_19;
    var local_61: type_20;
    var local_62: type_20;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e41 = global_1;
            let _e42 = global_2;
            let _e45 = global_3.member.member_10;
            let _e48 = global_3.member.member_3;
            let _e49 = (_e48 - 1u);
            let _e51 = ((_e49 / 4u) + 1u);
            let _e59 = (((_e41.x + (_e41.y * _e42.x)) * 64u) + _e40.x);
            let _e62 = global_3.member.member_4;
            if ((_e62 % 8u) == 0u) {
                let _e69 = (4u * _e62);
                let _e70 = (_e69 == 0u);
                if _e70 {
                    break;
                }
                if _e70 {
                    break;
                }
                let _e72 = (_e59 % _e69);
                phi_122_ = array<u32, 2>(((4u * (_e59 / _e69)) + ((_e72 / 8u) % 4u)), (((_e72 / 32u) * 8u) + (_e72 % 8u)));
            } else {
                let _e65 = (_e62 == 0u);
                if _e65 {
                    break;
                }
                if _e65 {
                    break;
                }
                phi_122_ = array<u32, 2>((_e59 / _e62), (_e59 % _e62));
            }
            let _e83 = phi_122_;
            let _e85 = ((4u * _e62) - 1u);
            let _e88 = (((_e85 / 32u) + 1u) == 0u);
            if _e88 {
                break;
            }
            if _e88 {
                break;
            }
            let _e93 = global_3.member.member_1;
            let _e96 = global_3.member.member;
            let _e97 = (_e93 + _e96);
            let _e100 = (_e93 + (_e41.z * _e45));
            if (_e83[0] <= _e51) {
                if (_e100 < _e97) {
                    let _e102 = (_e100 + _e45);
                    let _e107 = global_3.member.member_7;
                    phi_155_ = _e107;
                    phi_158_ = 0u;
                    loop {
                        let _e109 = phi_155_;
                        let _e111 = phi_158_;
                        let _e112 = (_e111 + 1u);
                        local = _e111;
                        local_1 = _e112;
                        local_26 = _e111;
                        if (_e112 < _e109) {
                            let _e115 = ((_e111 + _e109) / 2u);
                            let _e118 = global_3.member.member_8;
                            let _e122 = global_4.member[(_e115 * _e118)];
                            let _e125 = global_3.member.member_9;
                            if (_e125 == 0u) {
                                phi_179_ = _e122;
                            } else {
                                let _e129 = global_5.member[_e122];
                                phi_179_ = _e129;
                            }
                            let _e131 = phi_179_;
                            let _e132 = (_e131 <= _e100);
                            local_22 = select(_e115, _e109, _e132);
                            local_23 = select(_e111, _e115, _e132);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2846 = local_22;
                            phi_155_ = _e2846;
                            let _e2849 = local_23;
                            phi_158_ = _e2849;
                        }
                    }
                    let _e137 = global_3.member.member_8;
                    let _e139 = local;
                    let _e143 = global_4.member[(_e139 * _e137)];
                    let _e146 = global_3.member.member_9;
                    let _e147 = (_e146 == 0u);
                    if _e147 {
                        phi_194_ = _e143;
                    } else {
                        let _e150 = global_5.member[_e143];
                        phi_194_ = _e150;
                    }
                    let _e152 = phi_194_;
                    let _e154 = local_1;
                    let _e158 = global_4.member[(_e154 * _e137)];
                    if _e147 {
                        phi_203_ = _e158;
                    } else {
                        let _e161 = global_5.member[_e158];
                        phi_203_ = _e161;
                    }
                    let _e163 = phi_203_;
                    if (_e45 == 0u) {
                        break;
                    }
                    let _e166 = ((_e100 - _e152) % _e45);
                    if (_e41.z == 0u) {
                        phi_222_ = u32();
                        phi_223_ = true;
                    } else {
                        let _e168 = (_e166 == 0u);
                        if _e168 {
                            phi_221_ = u32();
                        } else {
                            let _e170 = ((_e100 - _e166) + _e45);
                            phi_221_ = select(_e163, _e170, (_e170 < _e163));
                        }
                        let _e174 = phi_221_;
                        phi_222_ = _e174;
                        phi_223_ = _e168;
                    }
                    let _e176 = phi_222_;
                    let _e178 = phi_223_;
                    if _e178 {
                        phi_228_ = (_e100 - _e166);
                    } else {
                        phi_228_ = _e176;
                    }
                    let _e181 = phi_228_;
                    phi_230_ = _e163;
                    phi_233_ = _e181;
                    let _e2867 = local_26;
                    phi_235_ = _e2867;
                    loop {
                        let _e183 = phi_230_;
                        let _e185 = phi_233_;
                        let _e187 = phi_235_;
                        if (_e185 < select(_e97, _e102, (_e102 < _e97))) {
                            if (_e185 == _e183) {
                                let _e2831 = global_4.member[((_e187 + 2u) * _e137)];
                                if _e147 {
                                    phi_2970_ = _e2831;
                                } else {
                                    let _e2834 = global_5.member[_e2831];
                                    phi_2970_ = _e2834;
                                }
                                let _e2836 = phi_2970_;
                                phi_231_ = _e2836;
                                phi_234_ = _e185;
                                phi_236_ = (_e187 + 1u);
                            } else {
                                let _e190 = (_e185 + _e45);
                                let _e192 = select(_e183, _e190, (_e190 < _e183));
                                let _e195 = global_3.member.member_11;
                                let _e196 = (4u * _e195);
                                if (_e185 > _e93) {
                                    phi_255_ = (_e185 - _e93);
                                } else {
                                    phi_255_ = 0u;
                                }
                                let _e200 = phi_255_;
                                let _e201 = (_e192 - _e93);
                                let _e203 = select(_e96, _e201, (_e201 < _e96));
                                let _e205 = (_e192 <= _e97);
                                let _e208 = global_3.member.member_12;
                                let _e209 = (_e208 * _e196);
                                let _e211 = ((1u - _e208) * _e196);
                                let _e213 = select(false, true, (_e185 < _e93));
                                let _e216 = global_3.member.member_2;
                                let _e217 = (4u * _e83[1]);
                                let _e218 = (_e217 * _e216);
                                if (_e83[0] < _e51) {
                                    let _e810 = (_e83[0] * 4u);
                                    let _e813 = global_3.member.member_5;
                                    let _e816 = (4u * (_e813 + (_e810 * _e62)));
                                    let _e817 = (_e49 - _e810);
                                    let _e822 = (_e816 + ((4u * select(_e817, 1u, (1u < _e817))) * _e62));
                                    let _e827 = (_e816 + ((4u * select(_e817, 2u, (2u < _e817))) * _e62));
                                    let _e832 = (_e816 + ((4u * select(_e817, 3u, (3u < _e817))) * _e62));
                                    let _e833 = (_e209 + _e816);
                                    let _e834 = (_e209 + _e822);
                                    let _e835 = (_e209 + _e827);
                                    let _e836 = (_e209 + _e832);
                                    let _e838 = (_e810 + 1u);
                                    let _e842 = (_e810 + 2u);
                                    let _e846 = (_e810 + 3u);
                                    if _e213 {
                                        let _e855 = global_6.member[(_e833 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e856 = (_e217 + 1u);
                                        let _e862 = global_6.member[(_e833 + select(_e85, _e856, (_e856 < _e85)))];
                                        let _e863 = (_e217 + 2u);
                                        let _e869 = global_6.member[(_e833 + select(_e85, _e863, (_e863 < _e85)))];
                                        let _e870 = (_e217 + 3u);
                                        let _e876 = global_6.member[(_e833 + select(_e85, _e870, (_e870 < _e85)))];
                                        phi_944_ = vec4<f32>(_e855, _e862, _e869, _e876);
                                    } else {
                                        phi_944_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e879 = phi_944_;
                                    if _e213 {
                                        let _e890 = global_6.member[(_e834 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e891 = (_e217 + 1u);
                                        let _e897 = global_6.member[(_e834 + select(_e85, _e891, (_e891 < _e85)))];
                                        let _e898 = (_e217 + 2u);
                                        let _e904 = global_6.member[(_e834 + select(_e85, _e898, (_e898 < _e85)))];
                                        let _e905 = (_e217 + 3u);
                                        let _e911 = global_6.member[(_e834 + select(_e85, _e905, (_e905 < _e85)))];
                                        phi_977_ = vec4<f32>(_e890, _e897, _e904, _e911);
                                    } else {
                                        phi_977_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e914 = phi_977_;
                                    if _e213 {
                                        let _e925 = global_6.member[(_e835 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e926 = (_e217 + 1u);
                                        let _e932 = global_6.member[(_e835 + select(_e85, _e926, (_e926 < _e85)))];
                                        let _e933 = (_e217 + 2u);
                                        let _e939 = global_6.member[(_e835 + select(_e85, _e933, (_e933 < _e85)))];
                                        let _e940 = (_e217 + 3u);
                                        let _e946 = global_6.member[(_e835 + select(_e85, _e940, (_e940 < _e85)))];
                                        phi_1010_ = vec4<f32>(_e925, _e932, _e939, _e946);
                                    } else {
                                        phi_1010_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e949 = phi_1010_;
                                    if _e213 {
                                        let _e960 = global_6.member[(_e836 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e961 = (_e217 + 1u);
                                        let _e967 = global_6.member[(_e836 + select(_e85, _e961, (_e961 < _e85)))];
                                        let _e968 = (_e217 + 2u);
                                        let _e974 = global_6.member[(_e836 + select(_e85, _e968, (_e968 < _e85)))];
                                        let _e975 = (_e217 + 3u);
                                        let _e981 = global_6.member[(_e836 + select(_e85, _e975, (_e975 < _e85)))];
                                        phi_1043_ = vec4<f32>(_e960, _e967, _e974, _e981);
                                    } else {
                                        phi_1043_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e984 = phi_1043_;
                                    let _e992 = ((_e810 * _e216) / 4u);
                                    let _e993 = ((select(_e49, _e838, (_e838 < _e49)) * _e216) / 4u);
                                    let _e994 = ((select(_e49, _e842, (_e842 < _e49)) * _e216) / 4u);
                                    let _e995 = ((select(_e49, _e846, (_e846 < _e49)) * _e216) / 4u);
                                    let _e996 = (_e218 / 4u);
                                    let _e997 = (_e216 / 4u);
                                    phi_1058_ = type_19(_e984.x, _e984.y, _e984.z, _e984.w);
                                    phi_1061_ = type_19(_e949.x, _e949.y, _e949.z, _e949.w);
                                    phi_1063_ = type_19(_e914.x, _e914.y, _e914.z, _e914.w);
                                    phi_1065_ = type_19(_e879.x, _e879.y, _e879.z, _e879.w);
                                    phi_1067_ = type_20((_e200 / 4u), _e200, _e203);
                                    loop {
                                        let _e999 = phi_1058_;
                                        let _e1001 = phi_1061_;
                                        let _e1003 = phi_1063_;
                                        let _e1005 = phi_1065_;
                                        let _e1007 = phi_1067_;
                                        local_43 = _e999;
                                        local_45 = _e1001;
                                        local_47 = _e1003;
                                        local_49 = _e1005;
                                        local_51 = _e1007;
                                        let _e1009 = (4u * _e1007.member);
                                        if (_e1009 < _e1007.member_2) {
                                            phi_1083_ = select(((_e1009 + 4u) > _e1007.member_2), true, (_e1009 < _e1007.member_1));
                                        } else {
                                            phi_1083_ = false;
                                        }
                                        let _e1018 = phi_1083_;
                                        if _e1018 {
                                            let _e1022 = global_7.member[(_e996 + _e1007.member)];
                                            let _e1029 = (_e1007.member_2 - _e1007.member_1);
                                            let _e1030 = ((_e1009 - _e1007.member_1) < _e1029);
                                            let _e1031 = select(0f, _e1022.x, _e1030);
                                            let _e1034 = (((_e1009 + 1u) - _e1007.member_1) < _e1029);
                                            let _e1035 = select(0f, _e1022.y, _e1034);
                                            let _e1038 = (((_e1009 + 2u) - _e1007.member_1) < _e1029);
                                            let _e1039 = select(0f, _e1022.z, _e1038);
                                            let _e1042 = (((_e1009 + 3u) - _e1007.member_1) < _e1029);
                                            let _e1043 = select(0f, _e1022.w, _e1042);
                                            let _e1048 = global_7.member[((_e996 + _e997) + _e1007.member)];
                                            let _e1053 = select(0f, _e1048.x, _e1030);
                                            let _e1054 = select(0f, _e1048.y, _e1034);
                                            let _e1055 = select(0f, _e1048.z, _e1038);
                                            let _e1056 = select(0f, _e1048.w, _e1042);
                                            let _e1062 = global_7.member[((_e996 + (2u * _e997)) + _e1007.member)];
                                            let _e1067 = select(0f, _e1062.x, _e1030);
                                            let _e1068 = select(0f, _e1062.y, _e1034);
                                            let _e1069 = select(0f, _e1062.z, _e1038);
                                            let _e1070 = select(0f, _e1062.w, _e1042);
                                            let _e1076 = global_7.member[((_e996 + (3u * _e997)) + _e1007.member)];
                                            let _e1081 = select(0f, _e1076.x, _e1030);
                                            let _e1082 = select(0f, _e1076.y, _e1034);
                                            let _e1083 = select(0f, _e1076.z, _e1038);
                                            let _e1084 = select(0f, _e1076.w, _e1042);
                                            let _e1088 = global_9.member[(_e992 + _e1007.member)];
                                            let _e1093 = select(0f, _e1088.x, _e1030);
                                            let _e1094 = select(0f, _e1088.y, _e1034);
                                            let _e1095 = select(0f, _e1088.z, _e1038);
                                            let _e1096 = select(0f, _e1088.w, _e1042);
                                            let _e1100 = global_9.member[(_e993 + _e1007.member)];
                                            let _e1105 = select(0f, _e1100.x, _e1030);
                                            let _e1106 = select(0f, _e1100.y, _e1034);
                                            let _e1107 = select(0f, _e1100.z, _e1038);
                                            let _e1108 = select(0f, _e1100.w, _e1042);
                                            let _e1112 = global_9.member[(_e994 + _e1007.member)];
                                            let _e1117 = select(0f, _e1112.x, _e1030);
                                            let _e1118 = select(0f, _e1112.y, _e1034);
                                            let _e1119 = select(0f, _e1112.z, _e1038);
                                            let _e1120 = select(0f, _e1112.w, _e1042);
                                            let _e1124 = global_9.member[(_e995 + _e1007.member)];
                                            let _e1129 = select(0f, _e1124.x, _e1030);
                                            let _e1130 = select(0f, _e1124.y, _e1034);
                                            let _e1131 = select(0f, _e1124.z, _e1038);
                                            let _e1132 = select(0f, _e1124.w, _e1042);
                                            local_38 = type_19(((_e1132 * _e1043) + ((_e1131 * _e1039) + ((_e1130 * _e1035) + ((_e1129 * _e1031) + _e999.member)))), ((_e1132 * _e1056) + ((_e1131 * _e1055) + ((_e1130 * _e1054) + ((_e1129 * _e1053) + _e999.member_1)))), ((_e1132 * _e1070) + ((_e1131 * _e1069) + ((_e1130 * _e1068) + ((_e1129 * _e1067) + _e999.member_2)))), ((_e1132 * _e1084) + ((_e1131 * _e1083) + ((_e1130 * _e1082) + ((_e1129 * _e1081) + _e999.member_3)))));
                                            local_39 = type_19(((_e1120 * _e1043) + ((_e1119 * _e1039) + ((_e1118 * _e1035) + ((_e1117 * _e1031) + _e1001.member)))), ((_e1120 * _e1056) + ((_e1119 * _e1055) + ((_e1118 * _e1054) + ((_e1117 * _e1053) + _e1001.member_1)))), ((_e1120 * _e1070) + ((_e1119 * _e1069) + ((_e1118 * _e1068) + ((_e1117 * _e1067) + _e1001.member_2)))), ((_e1120 * _e1084) + ((_e1119 * _e1083) + ((_e1118 * _e1082) + ((_e1117 * _e1081) + _e1001.member_3)))));
                                            local_40 = type_19(((_e1108 * _e1043) + ((_e1107 * _e1039) + ((_e1106 * _e1035) + ((_e1105 * _e1031) + _e1003.member)))), ((_e1108 * _e1056) + ((_e1107 * _e1055) + ((_e1106 * _e1054) + ((_e1105 * _e1053) + _e1003.member_1)))), ((_e1108 * _e1070) + ((_e1107 * _e1069) + ((_e1106 * _e1068) + ((_e1105 * _e1067) + _e1003.member_2)))), ((_e1108 * _e1084) + ((_e1107 * _e1083) + ((_e1106 * _e1082) + ((_e1105 * _e1081) + _e1003.member_3)))));
                                            local_41 = type_19(((_e1096 * _e1043) + ((_e1095 * _e1039) + ((_e1094 * _e1035) + ((_e1093 * _e1031) + _e1005.member)))), ((_e1096 * _e1056) + ((_e1095 * _e1055) + ((_e1094 * _e1054) + ((_e1093 * _e1053) + _e1005.member_1)))), ((_e1096 * _e1070) + ((_e1095 * _e1069) + ((_e1094 * _e1068) + ((_e1093 * _e1067) + _e1005.member_2)))), ((_e1096 * _e1084) + ((_e1095 * _e1083) + ((_e1094 * _e1082) + ((_e1093 * _e1081) + _e1005.member_3)))));
                                            local_42 = type_20((_e1007.member + 1u), _e1007.member_1, _e1007.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2922 = local_38;
                                            phi_1058_ = _e2922;
                                            let _e2925 = local_39;
                                            phi_1061_ = _e2925;
                                            let _e2928 = local_40;
                                            phi_1063_ = _e2928;
                                            let _e2931 = local_41;
                                            phi_1065_ = _e2931;
                                            let _e2934 = local_42;
                                            phi_1067_ = _e2934;
                                        }
                                    }
                                    let _e2938 = local_43;
                                    phi_1337_ = _e2938;
                                    let _e2943 = local_45;
                                    phi_1340_ = _e2943;
                                    let _e2948 = local_47;
                                    phi_1342_ = _e2948;
                                    let _e2953 = local_49;
                                    phi_1344_ = _e2953;
                                    let _e2958 = local_51;
                                    phi_1346_ = _e2958;
                                    loop {
                                        let _e1287 = phi_1337_;
                                        let _e1289 = phi_1340_;
                                        let _e1291 = phi_1342_;
                                        let _e1293 = phi_1344_;
                                        let _e1295 = phi_1346_;
                                        local_53 = _e1287;
                                        local_55 = _e1289;
                                        local_57 = _e1291;
                                        local_59 = _e1293;
                                        local_61 = _e1295;
                                        if !((((4u * _e1295.member) + 4u) > _e1295.member_2)) {
                                            let _e1305 = global_7.member[(_e996 + _e1295.member)];
                                            let _e1314 = global_7.member[((_e996 + _e997) + _e1295.member)];
                                            let _e1324 = global_7.member[((_e996 + (2u * _e997)) + _e1295.member)];
                                            let _e1334 = global_7.member[((_e996 + (3u * _e997)) + _e1295.member)];
                                            let _e1342 = global_9.member[(_e992 + _e1295.member)];
                                            let _e1350 = global_9.member[(_e993 + _e1295.member)];
                                            let _e1358 = global_9.member[(_e994 + _e1295.member)];
                                            let _e1366 = global_9.member[(_e995 + _e1295.member)];
                                            local_44 = type_19(((_e1366.w * _e1305.w) + ((_e1366.z * _e1305.z) + ((_e1366.y * _e1305.y) + ((_e1366.x * _e1305.x) + _e1287.member)))), ((_e1366.w * _e1314.w) + ((_e1366.z * _e1314.z) + ((_e1366.y * _e1314.y) + ((_e1366.x * _e1314.x) + _e1287.member_1)))), ((_e1366.w * _e1324.w) + ((_e1366.z * _e1324.z) + ((_e1366.y * _e1324.y) + ((_e1366.x * _e1324.x) + _e1287.member_2)))), ((_e1366.w * _e1334.w) + ((_e1366.z * _e1334.z) + ((_e1366.y * _e1334.y) + ((_e1366.x * _e1334.x) + _e1287.member_3)))));
                                            local_46 = type_19(((_e1358.w * _e1305.w) + ((_e1358.z * _e1305.z) + ((_e1358.y * _e1305.y) + ((_e1358.x * _e1305.x) + _e1289.member)))), ((_e1358.w * _e1314.w) + ((_e1358.z * _e1314.z) + ((_e1358.y * _e1314.y) + ((_e1358.x * _e1314.x) + _e1289.member_1)))), ((_e1358.w * _e1324.w) + ((_e1358.z * _e1324.z) + ((_e1358.y * _e1324.y) + ((_e1358.x * _e1324.x) + _e1289.member_2)))), ((_e1358.w * _e1334.w) + ((_e1358.z * _e1334.z) + ((_e1358.y * _e1334.y) + ((_e1358.x * _e1334.x) + _e1289.member_3)))));
                                            local_48 = type_19(((_e1350.w * _e1305.w) + ((_e1350.z * _e1305.z) + ((_e1350.y * _e1305.y) + ((_e1350.x * _e1305.x) + _e1291.member)))), ((_e1350.w * _e1314.w) + ((_e1350.z * _e1314.z) + ((_e1350.y * _e1314.y) + ((_e1350.x * _e1314.x) + _e1291.member_1)))), ((_e1350.w * _e1324.w) + ((_e1350.z * _e1324.z) + ((_e1350.y * _e1324.y) + ((_e1350.x * _e1324.x) + _e1291.member_2)))), ((_e1350.w * _e1334.w) + ((_e1350.z * _e1334.z) + ((_e1350.y * _e1334.y) + ((_e1350.x * _e1334.x) + _e1291.member_3)))));
                                            local_50 = type_19(((_e1342.w * _e1305.w) + ((_e1342.z * _e1305.z) + ((_e1342.y * _e1305.y) + ((_e1342.x * _e1305.x) + _e1293.member)))), ((_e1342.w * _e1314.w) + ((_e1342.z * _e1314.z) + ((_e1342.y * _e1314.y) + ((_e1342.x * _e1314.x) + _e1293.member_1)))), ((_e1342.w * _e1324.w) + ((_e1342.z * _e1324.z) + ((_e1342.y * _e1324.y) + ((_e1342.x * _e1324.x) + _e1293.member_2)))), ((_e1342.w * _e1334.w) + ((_e1342.z * _e1334.z) + ((_e1342.y * _e1334.y) + ((_e1342.x * _e1334.x) + _e1293.member_3)))));
                                            local_52 = type_20((_e1295.member + 1u), _e1295.member_1, _e1295.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2940 = local_44;
                                            phi_1337_ = _e2940;
                                            let _e2945 = local_46;
                                            phi_1340_ = _e2945;
                                            let _e2950 = local_48;
                                            phi_1342_ = _e2950;
                                            let _e2955 = local_50;
                                            phi_1344_ = _e2955;
                                            let _e2960 = local_52;
                                            phi_1346_ = _e2960;
                                        }
                                    }
                                    let _e2963 = local_53;
                                    phi_1563_ = _e2963;
                                    let _e2968 = local_55;
                                    phi_1566_ = _e2968;
                                    let _e2973 = local_57;
                                    phi_1568_ = _e2973;
                                    let _e2978 = local_59;
                                    phi_1570_ = _e2978;
                                    let _e2983 = local_61;
                                    phi_1572_ = _e2983;
                                    loop {
                                        let _e1525 = phi_1563_;
                                        let _e1527 = phi_1566_;
                                        let _e1529 = phi_1568_;
                                        let _e1531 = phi_1570_;
                                        let _e1533 = phi_1572_;
                                        local_6 = _e1531;
                                        local_7 = _e1531;
                                        local_8 = _e1531;
                                        local_9 = _e1531;
                                        local_10 = _e1529;
                                        local_11 = _e1529;
                                        local_12 = _e1529;
                                        local_13 = _e1529;
                                        local_14 = _e1527;
                                        local_15 = _e1527;
                                        local_16 = _e1527;
                                        local_17 = _e1527;
                                        local_18 = _e1525;
                                        local_19 = _e1525;
                                        local_20 = _e1525;
                                        local_21 = _e1525;
                                        let _e1535 = (4u * _e1533.member);
                                        if (_e1535 < _e1533.member_2) {
                                            phi_1588_ = select(((_e1535 + 4u) > _e1533.member_2), true, (_e1535 < _e1533.member_1));
                                        } else {
                                            phi_1588_ = false;
                                        }
                                        let _e1544 = phi_1588_;
                                        if _e1544 {
                                            let _e1548 = global_7.member[(_e996 + _e1533.member)];
                                            let _e1555 = (_e1533.member_2 - _e1533.member_1);
                                            let _e1556 = ((_e1535 - _e1533.member_1) < _e1555);
                                            let _e1557 = select(0f, _e1548.x, _e1556);
                                            let _e1560 = (((_e1535 + 1u) - _e1533.member_1) < _e1555);
                                            let _e1561 = select(0f, _e1548.y, _e1560);
                                            let _e1564 = (((_e1535 + 2u) - _e1533.member_1) < _e1555);
                                            let _e1565 = select(0f, _e1548.z, _e1564);
                                            let _e1568 = (((_e1535 + 3u) - _e1533.member_1) < _e1555);
                                            let _e1569 = select(0f, _e1548.w, _e1568);
                                            let _e1574 = global_7.member[((_e996 + _e997) + _e1533.member)];
                                            let _e1579 = select(0f, _e1574.x, _e1556);
                                            let _e1580 = select(0f, _e1574.y, _e1560);
                                            let _e1581 = select(0f, _e1574.z, _e1564);
                                            let _e1582 = select(0f, _e1574.w, _e1568);
                                            let _e1588 = global_7.member[((_e996 + (2u * _e997)) + _e1533.member)];
                                            let _e1593 = select(0f, _e1588.x, _e1556);
                                            let _e1594 = select(0f, _e1588.y, _e1560);
                                            let _e1595 = select(0f, _e1588.z, _e1564);
                                            let _e1596 = select(0f, _e1588.w, _e1568);
                                            let _e1602 = global_7.member[((_e996 + (3u * _e997)) + _e1533.member)];
                                            let _e1607 = select(0f, _e1602.x, _e1556);
                                            let _e1608 = select(0f, _e1602.y, _e1560);
                                            let _e1609 = select(0f, _e1602.z, _e1564);
                                            let _e1610 = select(0f, _e1602.w, _e1568);
                                            let _e1614 = global_9.member[(_e992 + _e1533.member)];
                                            let _e1619 = select(0f, _e1614.x, _e1556);
                                            let _e1620 = select(0f, _e1614.y, _e1560);
                                            let _e1621 = select(0f, _e1614.z, _e1564);
                                            let _e1622 = select(0f, _e1614.w, _e1568);
                                            let _e1626 = global_9.member[(_e993 + _e1533.member)];
                                            let _e1631 = select(0f, _e1626.x, _e1556);
                                            let _e1632 = select(0f, _e1626.y, _e1560);
                                            let _e1633 = select(0f, _e1626.z, _e1564);
                                            let _e1634 = select(0f, _e1626.w, _e1568);
                                            let _e1638 = global_9.member[(_e994 + _e1533.member)];
                                            let _e1643 = select(0f, _e1638.x, _e1556);
                                            let _e1644 = select(0f, _e1638.y, _e1560);
                                            let _e1645 = select(0f, _e1638.z, _e1564);
                                            let _e1646 = select(0f, _e1638.w, _e1568);
                                            let _e1650 = global_9.member[(_e995 + _e1533.member)];
                                            let _e1655 = select(0f, _e1650.x, _e1556);
                                            let _e1656 = select(0f, _e1650.y, _e1560);
                                            let _e1657 = select(0f, _e1650.z, _e1564);
                                            let _e1658 = select(0f, _e1650.w, _e1568);
                                            local_54 = type_19(((_e1658 * _e1569) + ((_e1657 * _e1565) + ((_e1656 * _e1561) + ((_e1655 * _e1557) + _e1525.member)))), ((_e1658 * _e1582) + ((_e1657 * _e1581) + ((_e1656 * _e1580) + ((_e1655 * _e1579) + _e1525.member_1)))), ((_e1658 * _e1596) + ((_e1657 * _e1595) + ((_e1656 * _e1594) + ((_e1655 * _e1593) + _e1525.member_2)))), ((_e1658 * _e1610) + ((_e1657 * _e1609) + ((_e1656 * _e1608) + ((_e1655 * _e1607) + _e1525.member_3)))));
                                            local_56 = type_19(((_e1646 * _e1569) + ((_e1645 * _e1565) + ((_e1644 * _e1561) + ((_e1643 * _e1557) + _e1527.member)))), ((_e1646 * _e1582) + ((_e1645 * _e1581) + ((_e1644 * _e1580) + ((_e1643 * _e1579) + _e1527.member_1)))), ((_e1646 * _e1596) + ((_e1645 * _e1595) + ((_e1644 * _e1594) + ((_e1643 * _e1593) + _e1527.member_2)))), ((_e1646 * _e1610) + ((_e1645 * _e1609) + ((_e1644 * _e1608) + ((_e1643 * _e1607) + _e1527.member_3)))));
                                            local_58 = type_19(((_e1634 * _e1569) + ((_e1633 * _e1565) + ((_e1632 * _e1561) + ((_e1631 * _e1557) + _e1529.member)))), ((_e1634 * _e1582) + ((_e1633 * _e1581) + ((_e1632 * _e1580) + ((_e1631 * _e1579) + _e1529.member_1)))), ((_e1634 * _e1596) + ((_e1633 * _e1595) + ((_e1632 * _e1594) + ((_e1631 * _e1593) + _e1529.member_2)))), ((_e1634 * _e1610) + ((_e1633 * _e1609) + ((_e1632 * _e1608) + ((_e1631 * _e1607) + _e1529.member_3)))));
                                            local_60 = type_19(((_e1622 * _e1569) + ((_e1621 * _e1565) + ((_e1620 * _e1561) + ((_e1619 * _e1557) + _e1531.member)))), ((_e1622 * _e1582) + ((_e1621 * _e1581) + ((_e1620 * _e1580) + ((_e1619 * _e1579) + _e1531.member_1)))), ((_e1622 * _e1596) + ((_e1621 * _e1595) + ((_e1620 * _e1594) + ((_e1619 * _e1593) + _e1531.member_2)))), ((_e1622 * _e1610) + ((_e1621 * _e1609) + ((_e1620 * _e1608) + ((_e1619 * _e1607) + _e1531.member_3)))));
                                            local_62 = type_20((_e1533.member + 1u), _e1533.member_1, _e1533.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2965 = local_54;
                                            phi_1563_ = _e2965;
                                            let _e2970 = local_56;
                                            phi_1566_ = _e2970;
                                            let _e2975 = local_58;
                                            phi_1568_ = _e2975;
                                            let _e2980 = local_60;
                                            phi_1570_ = _e2980;
                                            let _e2985 = local_62;
                                            phi_1572_ = _e2985;
                                        }
                                    }
                                    let _e1813 = local_6;
                                    let _e1816 = local_7;
                                    let _e1819 = local_8;
                                    let _e1822 = local_9;
                                    let _e1825 = local_10;
                                    let _e1828 = local_11;
                                    let _e1831 = local_12;
                                    let _e1834 = local_13;
                                    let _e1837 = local_14;
                                    let _e1840 = local_15;
                                    let _e1843 = local_16;
                                    let _e1846 = local_17;
                                    let _e1849 = local_18;
                                    let _e1852 = local_19;
                                    let _e1855 = local_20;
                                    let _e1858 = local_21;
                                    let _e1860 = (_e1813.member + 0f);
                                    let _e1861 = (_e1816.member_1 + 0f);
                                    let _e1862 = (_e1819.member_2 + 0f);
                                    let _e1863 = (_e1822.member_3 + 0f);
                                    if _e205 {
                                        let _e1869 = bitcast<u32>(_e1860);
                                        let _e1872 = ((_e1869 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1872 == 0u) {
                                        } else {
                                            let _e1875 = (_e1872 % 16u);
                                            let _e1877 = ((_e1869 & 8388607u) | 8388608u);
                                            let _e1880 = (_e1877 << bitcast<u32>((_e1875 & 31u)));
                                            let _e1886 = ((_e1877 >> bitcast<u32>(((31u - _e1875) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1869 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1902_ = array<u32, 2>(_e1880, _e1886);
                                            } else {
                                                let _e1892 = (~(_e1880) + 1u);
                                                if (_e1892 == 0u) {
                                                    phi_1900_ = (~(_e1886) + 1u);
                                                } else {
                                                    phi_1900_ = ~(_e1886);
                                                }
                                                let _e1898 = phi_1900_;
                                                phi_1902_ = array<u32, 2>(_e1892, _e1898);
                                            }
                                            let _e1901 = phi_1902_;
                                            let _e1902 = (_e1872 < 255u);
                                            if _e1902 {
                                                phi_1908_ = _e1901;
                                            } else {
                                                phi_1908_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1905 = phi_1908_;
                                            let _e1910 = (2u * ((select(16u, (_e1872 / 16u), _e1902) * _e196) + (_e816 + _e217)));
                                            let _e1913 = atomicAdd((&global_8.member[_e1910]), _e1905[0]);
                                            let _e1917 = (_e1905[1] + select(0u, 1u, ((_e1913 + _e1905[0]) < _e1905[0])));
                                            if (_e1917 == 0u) {
                                            } else {
                                                let _e1922 = atomicAdd((&global_8.member[(_e1910 + 1u)]), _e1917);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e816) + _e217)] = _e1860;
                                    }
                                    let _e1923 = (_e217 + 1u);
                                    if _e205 {
                                        let _e1929 = bitcast<u32>(_e1861);
                                        let _e1932 = ((_e1929 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1932 == 0u) {
                                        } else {
                                            let _e1935 = (_e1932 % 16u);
                                            let _e1937 = ((_e1929 & 8388607u) | 8388608u);
                                            let _e1940 = (_e1937 << bitcast<u32>((_e1935 & 31u)));
                                            let _e1946 = ((_e1937 >> bitcast<u32>(((31u - _e1935) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1929 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1970_ = array<u32, 2>(_e1940, _e1946);
                                            } else {
                                                let _e1952 = (~(_e1940) + 1u);
                                                if (_e1952 == 0u) {
                                                    phi_1968_ = (~(_e1946) + 1u);
                                                } else {
                                                    phi_1968_ = ~(_e1946);
                                                }
                                                let _e1958 = phi_1968_;
                                                phi_1970_ = array<u32, 2>(_e1952, _e1958);
                                            }
                                            let _e1961 = phi_1970_;
                                            let _e1962 = (_e1932 < 255u);
                                            if _e1962 {
                                                phi_1976_ = _e1961;
                                            } else {
                                                phi_1976_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1965 = phi_1976_;
                                            let _e1970 = (2u * ((select(16u, (_e1932 / 16u), _e1962) * _e196) + (_e816 + _e1923)));
                                            let _e1973 = atomicAdd((&global_8.member[_e1970]), _e1965[0]);
                                            let _e1977 = (_e1965[1] + select(0u, 1u, ((_e1973 + _e1965[0]) < _e1965[0])));
                                            if (_e1977 == 0u) {
                                            } else {
                                                let _e1982 = atomicAdd((&global_8.member[(_e1970 + 1u)]), _e1977);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e816) + _e1923)] = _e1861;
                                    }
                                    let _e1983 = (_e217 + 2u);
                                    if _e205 {
                                        let _e1989 = bitcast<u32>(_e1862);
                                        let _e1992 = ((_e1989 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1992 == 0u) {
                                        } else {
                                            let _e1995 = (_e1992 % 16u);
                                            let _e1997 = ((_e1989 & 8388607u) | 8388608u);
                                            let _e2000 = (_e1997 << bitcast<u32>((_e1995 & 31u)));
                                            let _e2006 = ((_e1997 >> bitcast<u32>(((31u - _e1995) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1989 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2038_ = array<u32, 2>(_e2000, _e2006);
                                            } else {
                                                let _e2012 = (~(_e2000) + 1u);
                                                if (_e2012 == 0u) {
                                                    phi_2036_ = (~(_e2006) + 1u);
                                                } else {
                                                    phi_2036_ = ~(_e2006);
                                                }
                                                let _e2018 = phi_2036_;
                                                phi_2038_ = array<u32, 2>(_e2012, _e2018);
                                            }
                                            let _e2021 = phi_2038_;
                                            let _e2022 = (_e1992 < 255u);
                                            if _e2022 {
                                                phi_2044_ = _e2021;
                                            } else {
                                                phi_2044_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2025 = phi_2044_;
                                            let _e2030 = (2u * ((select(16u, (_e1992 / 16u), _e2022) * _e196) + (_e816 + _e1983)));
                                            let _e2033 = atomicAdd((&global_8.member[_e2030]), _e2025[0]);
                                            let _e2037 = (_e2025[1] + select(0u, 1u, ((_e2033 + _e2025[0]) < _e2025[0])));
                                            if (_e2037 == 0u) {
                                            } else {
                                                let _e2042 = atomicAdd((&global_8.member[(_e2030 + 1u)]), _e2037);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e816) + _e1983)] = _e1862;
                                    }
                                    let _e2043 = (_e217 + 3u);
                                    if _e205 {
                                        let _e2049 = bitcast<u32>(_e1863);
                                        let _e2052 = ((_e2049 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2052 == 0u) {
                                        } else {
                                            let _e2055 = (_e2052 % 16u);
                                            let _e2057 = ((_e2049 & 8388607u) | 8388608u);
                                            let _e2060 = (_e2057 << bitcast<u32>((_e2055 & 31u)));
                                            let _e2066 = ((_e2057 >> bitcast<u32>(((31u - _e2055) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2049 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2106_ = array<u32, 2>(_e2060, _e2066);
                                            } else {
                                                let _e2072 = (~(_e2060) + 1u);
                                                if (_e2072 == 0u) {
                                                    phi_2104_ = (~(_e2066) + 1u);
                                                } else {
                                                    phi_2104_ = ~(_e2066);
                                                }
                                                let _e2078 = phi_2104_;
                                                phi_2106_ = array<u32, 2>(_e2072, _e2078);
                                            }
                                            let _e2081 = phi_2106_;
                                            let _e2082 = (_e2052 < 255u);
                                            if _e2082 {
                                                phi_2112_ = _e2081;
                                            } else {
                                                phi_2112_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2085 = phi_2112_;
                                            let _e2090 = (2u * ((select(16u, (_e2052 / 16u), _e2082) * _e196) + (_e816 + _e2043)));
                                            let _e2093 = atomicAdd((&global_8.member[_e2090]), _e2085[0]);
                                            let _e2097 = (_e2085[1] + select(0u, 1u, ((_e2093 + _e2085[0]) < _e2085[0])));
                                            if (_e2097 == 0u) {
                                            } else {
                                                let _e2102 = atomicAdd((&global_8.member[(_e2090 + 1u)]), _e2097);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e816) + _e2043)] = _e1863;
                                    }
                                    if (_e838 < _e48) {
                                        let _e2104 = (_e1825.member + 0f);
                                        let _e2105 = (_e1828.member_1 + 0f);
                                        let _e2106 = (_e1831.member_2 + 0f);
                                        let _e2107 = (_e1834.member_3 + 0f);
                                        if _e205 {
                                            let _e2113 = bitcast<u32>(_e2104);
                                            let _e2116 = ((_e2113 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2116 == 0u) {
                                            } else {
                                                let _e2119 = (_e2116 % 16u);
                                                let _e2121 = ((_e2113 & 8388607u) | 8388608u);
                                                let _e2124 = (_e2121 << bitcast<u32>((_e2119 & 31u)));
                                                let _e2130 = ((_e2121 >> bitcast<u32>(((31u - _e2119) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2113 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2181_ = array<u32, 2>(_e2124, _e2130);
                                                } else {
                                                    let _e2136 = (~(_e2124) + 1u);
                                                    if (_e2136 == 0u) {
                                                        phi_2179_ = (~(_e2130) + 1u);
                                                    } else {
                                                        phi_2179_ = ~(_e2130);
                                                    }
                                                    let _e2142 = phi_2179_;
                                                    phi_2181_ = array<u32, 2>(_e2136, _e2142);
                                                }
                                                let _e2145 = phi_2181_;
                                                let _e2146 = (_e2116 < 255u);
                                                if _e2146 {
                                                    phi_2187_ = _e2145;
                                                } else {
                                                    phi_2187_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2149 = phi_2187_;
                                                let _e2154 = (2u * ((select(16u, (_e2116 / 16u), _e2146) * _e196) + (_e822 + _e217)));
                                                let _e2157 = atomicAdd((&global_8.member[_e2154]), _e2149[0]);
                                                let _e2161 = (_e2149[1] + select(0u, 1u, ((_e2157 + _e2149[0]) < _e2149[0])));
                                                if (_e2161 == 0u) {
                                                } else {
                                                    let _e2166 = atomicAdd((&global_8.member[(_e2154 + 1u)]), _e2161);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e822) + _e217)] = _e2104;
                                        }
                                        if _e205 {
                                            let _e2172 = bitcast<u32>(_e2105);
                                            let _e2175 = ((_e2172 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2175 == 0u) {
                                            } else {
                                                let _e2178 = (_e2175 % 16u);
                                                let _e2180 = ((_e2172 & 8388607u) | 8388608u);
                                                let _e2183 = (_e2180 << bitcast<u32>((_e2178 & 31u)));
                                                let _e2189 = ((_e2180 >> bitcast<u32>(((31u - _e2178) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2172 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2248_ = array<u32, 2>(_e2183, _e2189);
                                                } else {
                                                    let _e2195 = (~(_e2183) + 1u);
                                                    if (_e2195 == 0u) {
                                                        phi_2246_ = (~(_e2189) + 1u);
                                                    } else {
                                                        phi_2246_ = ~(_e2189);
                                                    }
                                                    let _e2201 = phi_2246_;
                                                    phi_2248_ = array<u32, 2>(_e2195, _e2201);
                                                }
                                                let _e2204 = phi_2248_;
                                                let _e2205 = (_e2175 < 255u);
                                                if _e2205 {
                                                    phi_2254_ = _e2204;
                                                } else {
                                                    phi_2254_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2208 = phi_2254_;
                                                let _e2213 = (2u * ((select(16u, (_e2175 / 16u), _e2205) * _e196) + (_e822 + _e1923)));
                                                let _e2216 = atomicAdd((&global_8.member[_e2213]), _e2208[0]);
                                                let _e2220 = (_e2208[1] + select(0u, 1u, ((_e2216 + _e2208[0]) < _e2208[0])));
                                                if (_e2220 == 0u) {
                                                } else {
                                                    let _e2225 = atomicAdd((&global_8.member[(_e2213 + 1u)]), _e2220);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e822) + _e1923)] = _e2105;
                                        }
                                        if _e205 {
                                            let _e2231 = bitcast<u32>(_e2106);
                                            let _e2234 = ((_e2231 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2234 == 0u) {
                                            } else {
                                                let _e2237 = (_e2234 % 16u);
                                                let _e2239 = ((_e2231 & 8388607u) | 8388608u);
                                                let _e2242 = (_e2239 << bitcast<u32>((_e2237 & 31u)));
                                                let _e2248 = ((_e2239 >> bitcast<u32>(((31u - _e2237) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2231 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2315_ = array<u32, 2>(_e2242, _e2248);
                                                } else {
                                                    let _e2254 = (~(_e2242) + 1u);
                                                    if (_e2254 == 0u) {
                                                        phi_2313_ = (~(_e2248) + 1u);
                                                    } else {
                                                        phi_2313_ = ~(_e2248);
                                                    }
                                                    let _e2260 = phi_2313_;
                                                    phi_2315_ = array<u32, 2>(_e2254, _e2260);
                                                }
                                                let _e2263 = phi_2315_;
                                                let _e2264 = (_e2234 < 255u);
                                                if _e2264 {
                                                    phi_2321_ = _e2263;
                                                } else {
                                                    phi_2321_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2267 = phi_2321_;
                                                let _e2272 = (2u * ((select(16u, (_e2234 / 16u), _e2264) * _e196) + (_e822 + _e1983)));
                                                let _e2275 = atomicAdd((&global_8.member[_e2272]), _e2267[0]);
                                                let _e2279 = (_e2267[1] + select(0u, 1u, ((_e2275 + _e2267[0]) < _e2267[0])));
                                                if (_e2279 == 0u) {
                                                } else {
                                                    let _e2284 = atomicAdd((&global_8.member[(_e2272 + 1u)]), _e2279);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e822) + _e1983)] = _e2106;
                                        }
                                        if _e205 {
                                            let _e2290 = bitcast<u32>(_e2107);
                                            let _e2293 = ((_e2290 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2293 == 0u) {
                                            } else {
                                                let _e2296 = (_e2293 % 16u);
                                                let _e2298 = ((_e2290 & 8388607u) | 8388608u);
                                                let _e2301 = (_e2298 << bitcast<u32>((_e2296 & 31u)));
                                                let _e2307 = ((_e2298 >> bitcast<u32>(((31u - _e2296) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2290 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2382_ = array<u32, 2>(_e2301, _e2307);
                                                } else {
                                                    let _e2313 = (~(_e2301) + 1u);
                                                    if (_e2313 == 0u) {
                                                        phi_2380_ = (~(_e2307) + 1u);
                                                    } else {
                                                        phi_2380_ = ~(_e2307);
                                                    }
                                                    let _e2319 = phi_2380_;
                                                    phi_2382_ = array<u32, 2>(_e2313, _e2319);
                                                }
                                                let _e2322 = phi_2382_;
                                                let _e2323 = (_e2293 < 255u);
                                                if _e2323 {
                                                    phi_2388_ = _e2322;
                                                } else {
                                                    phi_2388_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2326 = phi_2388_;
                                                let _e2331 = (2u * ((select(16u, (_e2293 / 16u), _e2323) * _e196) + (_e822 + _e2043)));
                                                let _e2334 = atomicAdd((&global_8.member[_e2331]), _e2326[0]);
                                                let _e2338 = (_e2326[1] + select(0u, 1u, ((_e2334 + _e2326[0]) < _e2326[0])));
                                                if (_e2338 == 0u) {
                                                } else {
                                                    let _e2343 = atomicAdd((&global_8.member[(_e2331 + 1u)]), _e2338);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e822) + _e2043)] = _e2107;
                                        }
                                    }
                                    if (_e842 < _e48) {
                                        let _e2345 = (_e1837.member + 0f);
                                        let _e2346 = (_e1840.member_1 + 0f);
                                        let _e2347 = (_e1843.member_2 + 0f);
                                        let _e2348 = (_e1846.member_3 + 0f);
                                        if _e205 {
                                            let _e2354 = bitcast<u32>(_e2345);
                                            let _e2357 = ((_e2354 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2357 == 0u) {
                                            } else {
                                                let _e2360 = (_e2357 % 16u);
                                                let _e2362 = ((_e2354 & 8388607u) | 8388608u);
                                                let _e2365 = (_e2362 << bitcast<u32>((_e2360 & 31u)));
                                                let _e2371 = ((_e2362 >> bitcast<u32>(((31u - _e2360) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2354 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2457_ = array<u32, 2>(_e2365, _e2371);
                                                } else {
                                                    let _e2377 = (~(_e2365) + 1u);
                                                    if (_e2377 == 0u) {
                                                        phi_2455_ = (~(_e2371) + 1u);
                                                    } else {
                                                        phi_2455_ = ~(_e2371);
                                                    }
                                                    let _e2383 = phi_2455_;
                                                    phi_2457_ = array<u32, 2>(_e2377, _e2383);
                                                }
                                                let _e2386 = phi_2457_;
                                                let _e2387 = (_e2357 < 255u);
                                                if _e2387 {
                                                    phi_2463_ = _e2386;
                                                } else {
                                                    phi_2463_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2390 = phi_2463_;
                                                let _e2395 = (2u * ((select(16u, (_e2357 / 16u), _e2387) * _e196) + (_e827 + _e217)));
                                                let _e2398 = atomicAdd((&global_8.member[_e2395]), _e2390[0]);
                                                let _e2402 = (_e2390[1] + select(0u, 1u, ((_e2398 + _e2390[0]) < _e2390[0])));
                                                if (_e2402 == 0u) {
                                                } else {
                                                    let _e2407 = atomicAdd((&global_8.member[(_e2395 + 1u)]), _e2402);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e827) + _e217)] = _e2345;
                                        }
                                        if _e205 {
                                            let _e2413 = bitcast<u32>(_e2346);
                                            let _e2416 = ((_e2413 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2416 == 0u) {
                                            } else {
                                                let _e2419 = (_e2416 % 16u);
                                                let _e2421 = ((_e2413 & 8388607u) | 8388608u);
                                                let _e2424 = (_e2421 << bitcast<u32>((_e2419 & 31u)));
                                                let _e2430 = ((_e2421 >> bitcast<u32>(((31u - _e2419) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2413 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2524_ = array<u32, 2>(_e2424, _e2430);
                                                } else {
                                                    let _e2436 = (~(_e2424) + 1u);
                                                    if (_e2436 == 0u) {
                                                        phi_2522_ = (~(_e2430) + 1u);
                                                    } else {
                                                        phi_2522_ = ~(_e2430);
                                                    }
                                                    let _e2442 = phi_2522_;
                                                    phi_2524_ = array<u32, 2>(_e2436, _e2442);
                                                }
                                                let _e2445 = phi_2524_;
                                                let _e2446 = (_e2416 < 255u);
                                                if _e2446 {
                                                    phi_2530_ = _e2445;
                                                } else {
                                                    phi_2530_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2449 = phi_2530_;
                                                let _e2454 = (2u * ((select(16u, (_e2416 / 16u), _e2446) * _e196) + (_e827 + _e1923)));
                                                let _e2457 = atomicAdd((&global_8.member[_e2454]), _e2449[0]);
                                                let _e2461 = (_e2449[1] + select(0u, 1u, ((_e2457 + _e2449[0]) < _e2449[0])));
                                                if (_e2461 == 0u) {
                                                } else {
                                                    let _e2466 = atomicAdd((&global_8.member[(_e2454 + 1u)]), _e2461);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e827) + _e1923)] = _e2346;
                                        }
                                        if _e205 {
                                            let _e2472 = bitcast<u32>(_e2347);
                                            let _e2475 = ((_e2472 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2475 == 0u) {
                                            } else {
                                                let _e2478 = (_e2475 % 16u);
                                                let _e2480 = ((_e2472 & 8388607u) | 8388608u);
                                                let _e2483 = (_e2480 << bitcast<u32>((_e2478 & 31u)));
                                                let _e2489 = ((_e2480 >> bitcast<u32>(((31u - _e2478) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2472 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2591_ = array<u32, 2>(_e2483, _e2489);
                                                } else {
                                                    let _e2495 = (~(_e2483) + 1u);
                                                    if (_e2495 == 0u) {
                                                        phi_2589_ = (~(_e2489) + 1u);
                                                    } else {
                                                        phi_2589_ = ~(_e2489);
                                                    }
                                                    let _e2501 = phi_2589_;
                                                    phi_2591_ = array<u32, 2>(_e2495, _e2501);
                                                }
                                                let _e2504 = phi_2591_;
                                                let _e2505 = (_e2475 < 255u);
                                                if _e2505 {
                                                    phi_2597_ = _e2504;
                                                } else {
                                                    phi_2597_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2508 = phi_2597_;
                                                let _e2513 = (2u * ((select(16u, (_e2475 / 16u), _e2505) * _e196) + (_e827 + _e1983)));
                                                let _e2516 = atomicAdd((&global_8.member[_e2513]), _e2508[0]);
                                                let _e2520 = (_e2508[1] + select(0u, 1u, ((_e2516 + _e2508[0]) < _e2508[0])));
                                                if (_e2520 == 0u) {
                                                } else {
                                                    let _e2525 = atomicAdd((&global_8.member[(_e2513 + 1u)]), _e2520);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e827) + _e1983)] = _e2347;
                                        }
                                        if _e205 {
                                            let _e2531 = bitcast<u32>(_e2348);
                                            let _e2534 = ((_e2531 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2534 == 0u) {
                                            } else {
                                                let _e2537 = (_e2534 % 16u);
                                                let _e2539 = ((_e2531 & 8388607u) | 8388608u);
                                                let _e2542 = (_e2539 << bitcast<u32>((_e2537 & 31u)));
                                                let _e2548 = ((_e2539 >> bitcast<u32>(((31u - _e2537) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2531 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2658_ = array<u32, 2>(_e2542, _e2548);
                                                } else {
                                                    let _e2554 = (~(_e2542) + 1u);
                                                    if (_e2554 == 0u) {
                                                        phi_2656_ = (~(_e2548) + 1u);
                                                    } else {
                                                        phi_2656_ = ~(_e2548);
                                                    }
                                                    let _e2560 = phi_2656_;
                                                    phi_2658_ = array<u32, 2>(_e2554, _e2560);
                                                }
                                                let _e2563 = phi_2658_;
                                                let _e2564 = (_e2534 < 255u);
                                                if _e2564 {
                                                    phi_2664_ = _e2563;
                                                } else {
                                                    phi_2664_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2567 = phi_2664_;
                                                let _e2572 = (2u * ((select(16u, (_e2534 / 16u), _e2564) * _e196) + (_e827 + _e2043)));
                                                let _e2575 = atomicAdd((&global_8.member[_e2572]), _e2567[0]);
                                                let _e2579 = (_e2567[1] + select(0u, 1u, ((_e2575 + _e2567[0]) < _e2567[0])));
                                                if (_e2579 == 0u) {
                                                } else {
                                                    let _e2584 = atomicAdd((&global_8.member[(_e2572 + 1u)]), _e2579);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e827) + _e2043)] = _e2348;
                                        }
                                    }
                                    if (_e846 < _e48) {
                                        let _e2586 = (_e1849.member + 0f);
                                        let _e2587 = (_e1852.member_1 + 0f);
                                        let _e2588 = (_e1855.member_2 + 0f);
                                        let _e2589 = (_e1858.member_3 + 0f);
                                        if _e205 {
                                            let _e2595 = bitcast<u32>(_e2586);
                                            let _e2598 = ((_e2595 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2598 == 0u) {
                                            } else {
                                                let _e2601 = (_e2598 % 16u);
                                                let _e2603 = ((_e2595 & 8388607u) | 8388608u);
                                                let _e2606 = (_e2603 << bitcast<u32>((_e2601 & 31u)));
                                                let _e2612 = ((_e2603 >> bitcast<u32>(((31u - _e2601) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2595 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2733_ = array<u32, 2>(_e2606, _e2612);
                                                } else {
                                                    let _e2618 = (~(_e2606) + 1u);
                                                    if (_e2618 == 0u) {
                                                        phi_2731_ = (~(_e2612) + 1u);
                                                    } else {
                                                        phi_2731_ = ~(_e2612);
                                                    }
                                                    let _e2624 = phi_2731_;
                                                    phi_2733_ = array<u32, 2>(_e2618, _e2624);
                                                }
                                                let _e2627 = phi_2733_;
                                                let _e2628 = (_e2598 < 255u);
                                                if _e2628 {
                                                    phi_2739_ = _e2627;
                                                } else {
                                                    phi_2739_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2631 = phi_2739_;
                                                let _e2636 = (2u * ((select(16u, (_e2598 / 16u), _e2628) * _e196) + (_e832 + _e217)));
                                                let _e2639 = atomicAdd((&global_8.member[_e2636]), _e2631[0]);
                                                let _e2643 = (_e2631[1] + select(0u, 1u, ((_e2639 + _e2631[0]) < _e2631[0])));
                                                if (_e2643 == 0u) {
                                                } else {
                                                    let _e2648 = atomicAdd((&global_8.member[(_e2636 + 1u)]), _e2643);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e832) + _e217)] = _e2586;
                                        }
                                        if _e205 {
                                            let _e2654 = bitcast<u32>(_e2587);
                                            let _e2657 = ((_e2654 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2657 == 0u) {
                                            } else {
                                                let _e2660 = (_e2657 % 16u);
                                                let _e2662 = ((_e2654 & 8388607u) | 8388608u);
                                                let _e2665 = (_e2662 << bitcast<u32>((_e2660 & 31u)));
                                                let _e2671 = ((_e2662 >> bitcast<u32>(((31u - _e2660) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2654 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2800_ = array<u32, 2>(_e2665, _e2671);
                                                } else {
                                                    let _e2677 = (~(_e2665) + 1u);
                                                    if (_e2677 == 0u) {
                                                        phi_2798_ = (~(_e2671) + 1u);
                                                    } else {
                                                        phi_2798_ = ~(_e2671);
                                                    }
                                                    let _e2683 = phi_2798_;
                                                    phi_2800_ = array<u32, 2>(_e2677, _e2683);
                                                }
                                                let _e2686 = phi_2800_;
                                                let _e2687 = (_e2657 < 255u);
                                                if _e2687 {
                                                    phi_2806_ = _e2686;
                                                } else {
                                                    phi_2806_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2690 = phi_2806_;
                                                let _e2695 = (2u * ((select(16u, (_e2657 / 16u), _e2687) * _e196) + (_e832 + _e1923)));
                                                let _e2698 = atomicAdd((&global_8.member[_e2695]), _e2690[0]);
                                                let _e2702 = (_e2690[1] + select(0u, 1u, ((_e2698 + _e2690[0]) < _e2690[0])));
                                                if (_e2702 == 0u) {
                                                } else {
                                                    let _e2707 = atomicAdd((&global_8.member[(_e2695 + 1u)]), _e2702);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e832) + _e1923)] = _e2587;
                                        }
                                        if _e205 {
                                            let _e2713 = bitcast<u32>(_e2588);
                                            let _e2716 = ((_e2713 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2716 == 0u) {
                                            } else {
                                                let _e2719 = (_e2716 % 16u);
                                                let _e2721 = ((_e2713 & 8388607u) | 8388608u);
                                                let _e2724 = (_e2721 << bitcast<u32>((_e2719 & 31u)));
                                                let _e2730 = ((_e2721 >> bitcast<u32>(((31u - _e2719) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2713 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2867_ = array<u32, 2>(_e2724, _e2730);
                                                } else {
                                                    let _e2736 = (~(_e2724) + 1u);
                                                    if (_e2736 == 0u) {
                                                        phi_2865_ = (~(_e2730) + 1u);
                                                    } else {
                                                        phi_2865_ = ~(_e2730);
                                                    }
                                                    let _e2742 = phi_2865_;
                                                    phi_2867_ = array<u32, 2>(_e2736, _e2742);
                                                }
                                                let _e2745 = phi_2867_;
                                                let _e2746 = (_e2716 < 255u);
                                                if _e2746 {
                                                    phi_2873_ = _e2745;
                                                } else {
                                                    phi_2873_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2749 = phi_2873_;
                                                let _e2754 = (2u * ((select(16u, (_e2716 / 16u), _e2746) * _e196) + (_e832 + _e1983)));
                                                let _e2757 = atomicAdd((&global_8.member[_e2754]), _e2749[0]);
                                                let _e2761 = (_e2749[1] + select(0u, 1u, ((_e2757 + _e2749[0]) < _e2749[0])));
                                                if (_e2761 == 0u) {
                                                } else {
                                                    let _e2766 = atomicAdd((&global_8.member[(_e2754 + 1u)]), _e2761);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e832) + _e1983)] = _e2588;
                                        }
                                        if _e205 {
                                            let _e2772 = bitcast<u32>(_e2589);
                                            let _e2775 = ((_e2772 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2775 == 0u) {
                                            } else {
                                                let _e2778 = (_e2775 % 16u);
                                                let _e2780 = ((_e2772 & 8388607u) | 8388608u);
                                                let _e2783 = (_e2780 << bitcast<u32>((_e2778 & 31u)));
                                                let _e2789 = ((_e2780 >> bitcast<u32>(((31u - _e2778) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2772 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2934_ = array<u32, 2>(_e2783, _e2789);
                                                } else {
                                                    let _e2795 = (~(_e2783) + 1u);
                                                    if (_e2795 == 0u) {
                                                        phi_2932_ = (~(_e2789) + 1u);
                                                    } else {
                                                        phi_2932_ = ~(_e2789);
                                                    }
                                                    let _e2801 = phi_2932_;
                                                    phi_2934_ = array<u32, 2>(_e2795, _e2801);
                                                }
                                                let _e2804 = phi_2934_;
                                                let _e2805 = (_e2775 < 255u);
                                                if _e2805 {
                                                    phi_2940_ = _e2804;
                                                } else {
                                                    phi_2940_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2808 = phi_2940_;
                                                let _e2813 = (2u * ((select(16u, (_e2775 / 16u), _e2805) * _e196) + (_e832 + _e2043)));
                                                let _e2816 = atomicAdd((&global_8.member[_e2813]), _e2808[0]);
                                                let _e2820 = (_e2808[1] + select(0u, 1u, ((_e2816 + _e2808[0]) < _e2808[0])));
                                                if (_e2820 == 0u) {
                                                } else {
                                                    let _e2825 = atomicAdd((&global_8.member[(_e2813 + 1u)]), _e2820);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e832) + _e2043)] = _e2589;
                                        }
                                    }
                                } else {
                                    let _e222 = global_3.member.member_6;
                                    let _e223 = (4u * _e222);
                                    let _e224 = (_e209 + _e223);
                                    if _e213 {
                                        let _e230 = global_6.member[(_e224 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e231 = (_e217 + 1u);
                                        let _e237 = global_6.member[(_e224 + select(_e85, _e231, (_e231 < _e85)))];
                                        let _e238 = (_e217 + 2u);
                                        let _e244 = global_6.member[(_e224 + select(_e85, _e238, (_e238 < _e85)))];
                                        let _e245 = (_e217 + 3u);
                                        let _e251 = global_6.member[(_e224 + select(_e85, _e245, (_e245 < _e85)))];
                                        phi_307_ = vec4<f32>(_e230, _e237, _e244, _e251);
                                    } else {
                                        phi_307_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e254 = phi_307_;
                                    phi_316_ = type_20((_e200 / 4u), _e200, _e203);
                                    phi_319_ = type_19(_e254.x, _e254.y, _e254.z, _e254.w);
                                    loop {
                                        let _e263 = phi_316_;
                                        let _e265 = phi_319_;
                                        local_30 = _e263;
                                        local_32 = _e265;
                                        let _e267 = (4u * _e263.member);
                                        if (_e267 < _e263.member_2) {
                                            phi_335_ = select(((_e267 + 4u) > _e263.member_2), true, (_e267 < _e263.member_1));
                                        } else {
                                            phi_335_ = false;
                                        }
                                        let _e276 = phi_335_;
                                        if _e276 {
                                            let _e277 = (_e218 / 4u);
                                            let _e278 = (_e216 / 4u);
                                            let _e282 = global_7.member[(_e277 + _e263.member)];
                                            let _e289 = (_e263.member_2 - _e263.member_1);
                                            let _e290 = ((_e267 - _e263.member_1) < _e289);
                                            let _e294 = (((_e267 + 1u) - _e263.member_1) < _e289);
                                            let _e298 = (((_e267 + 2u) - _e263.member_1) < _e289);
                                            let _e302 = (((_e267 + 3u) - _e263.member_1) < _e289);
                                            let _e308 = global_7.member[((_e277 + _e278) + _e263.member)];
                                            let _e322 = global_7.member[((_e277 + (2u * _e278)) + _e263.member)];
                                            let _e336 = global_7.member[((_e277 + (3u * _e278)) + _e263.member)];
                                            local_28 = type_20((_e263.member + 1u), _e263.member_1, _e263.member_2);
                                            local_29 = type_19(((((_e265.member + select(0f, _e282.x, _e290)) + select(0f, _e282.y, _e294)) + select(0f, _e282.z, _e298)) + select(0f, _e282.w, _e302)), ((((_e265.member_1 + select(0f, _e308.x, _e290)) + select(0f, _e308.y, _e294)) + select(0f, _e308.z, _e298)) + select(0f, _e308.w, _e302)), ((((_e265.member_2 + select(0f, _e322.x, _e290)) + select(0f, _e322.y, _e294)) + select(0f, _e322.z, _e298)) + select(0f, _e322.w, _e302)), ((((_e265.member_3 + select(0f, _e336.x, _e290)) + select(0f, _e336.y, _e294)) + select(0f, _e336.z, _e298)) + select(0f, _e336.w, _e302)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2874 = local_28;
                                            phi_316_ = _e2874;
                                            let _e2877 = local_29;
                                            phi_319_ = _e2877;
                                        }
                                    }
                                    let _e2881 = local_30;
                                    phi_423_ = _e2881;
                                    let _e2886 = local_32;
                                    phi_426_ = _e2886;
                                    loop {
                                        let _e372 = phi_423_;
                                        let _e374 = phi_426_;
                                        local_34 = _e372;
                                        local_36 = _e374;
                                        if !((((4u * _e372.member) + 4u) > _e372.member_2)) {
                                            let _e381 = (_e218 / 4u);
                                            let _e382 = (_e216 / 4u);
                                            let _e386 = global_7.member[(_e381 + _e372.member)];
                                            let _e395 = global_7.member[((_e381 + _e382) + _e372.member)];
                                            let _e405 = global_7.member[((_e381 + (2u * _e382)) + _e372.member)];
                                            let _e415 = global_7.member[((_e381 + (3u * _e382)) + _e372.member)];
                                            local_31 = type_20((_e372.member + 1u), _e372.member_1, _e372.member_2);
                                            local_33 = type_19(((((_e374.member + _e386.x) + _e386.y) + _e386.z) + _e386.w), ((((_e374.member_1 + _e395.x) + _e395.y) + _e395.z) + _e395.w), ((((_e374.member_2 + _e405.x) + _e405.y) + _e405.z) + _e405.w), ((((_e374.member_3 + _e415.x) + _e415.y) + _e415.z) + _e415.w));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2883 = local_31;
                                            phi_423_ = _e2883;
                                            let _e2888 = local_33;
                                            phi_426_ = _e2888;
                                        }
                                    }
                                    let _e2891 = local_34;
                                    phi_493_ = _e2891;
                                    let _e2896 = local_36;
                                    phi_496_ = _e2896;
                                    loop {
                                        let _e447 = phi_493_;
                                        let _e449 = phi_496_;
                                        local_2 = _e449;
                                        local_3 = _e449;
                                        local_4 = _e449;
                                        local_5 = _e449;
                                        let _e451 = (4u * _e447.member);
                                        if (_e451 < _e447.member_2) {
                                            phi_512_ = select(((_e451 + 4u) > _e447.member_2), true, (_e451 < _e447.member_1));
                                        } else {
                                            phi_512_ = false;
                                        }
                                        let _e460 = phi_512_;
                                        if _e460 {
                                            let _e461 = (_e218 / 4u);
                                            let _e462 = (_e216 / 4u);
                                            let _e466 = global_7.member[(_e461 + _e447.member)];
                                            let _e473 = (_e447.member_2 - _e447.member_1);
                                            let _e474 = ((_e451 - _e447.member_1) < _e473);
                                            let _e478 = (((_e451 + 1u) - _e447.member_1) < _e473);
                                            let _e482 = (((_e451 + 2u) - _e447.member_1) < _e473);
                                            let _e486 = (((_e451 + 3u) - _e447.member_1) < _e473);
                                            let _e492 = global_7.member[((_e461 + _e462) + _e447.member)];
                                            let _e506 = global_7.member[((_e461 + (2u * _e462)) + _e447.member)];
                                            let _e520 = global_7.member[((_e461 + (3u * _e462)) + _e447.member)];
                                            local_35 = type_20((_e447.member + 1u), _e447.member_1, _e447.member_2);
                                            local_37 = type_19(((((_e449.member + select(0f, _e466.x, _e474)) + select(0f, _e466.y, _e478)) + select(0f, _e466.z, _e482)) + select(0f, _e466.w, _e486)), ((((_e449.member_1 + select(0f, _e492.x, _e474)) + select(0f, _e492.y, _e478)) + select(0f, _e492.z, _e482)) + select(0f, _e492.w, _e486)), ((((_e449.member_2 + select(0f, _e506.x, _e474)) + select(0f, _e506.y, _e478)) + select(0f, _e506.z, _e482)) + select(0f, _e506.w, _e486)), ((((_e449.member_3 + select(0f, _e520.x, _e474)) + select(0f, _e520.y, _e478)) + select(0f, _e520.z, _e482)) + select(0f, _e520.w, _e486)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2893 = local_35;
                                            phi_493_ = _e2893;
                                            let _e2898 = local_37;
                                            phi_496_ = _e2898;
                                        }
                                    }
                                    let _e556 = local_2;
                                    let _e559 = local_3;
                                    let _e562 = local_4;
                                    let _e565 = local_5;
                                    let _e567 = (_e556.member + 0f);
                                    let _e568 = (_e559.member_1 + 0f);
                                    let _e569 = (_e562.member_2 + 0f);
                                    let _e570 = (_e565.member_3 + 0f);
                                    if _e205 {
                                        let _e576 = bitcast<u32>(_e567);
                                        let _e579 = ((_e576 >> bitcast<u32>(23i)) & 255u);
                                        if (_e579 == 0u) {
                                        } else {
                                            let _e582 = (_e579 % 16u);
                                            let _e584 = ((_e576 & 8388607u) | 8388608u);
                                            let _e587 = (_e584 << bitcast<u32>((_e582 & 31u)));
                                            let _e593 = ((_e584 >> bitcast<u32>(((31u - _e582) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e576 >> bitcast<u32>(31i)) == 0u) {
                                                phi_648_ = array<u32, 2>(_e587, _e593);
                                            } else {
                                                let _e599 = (~(_e587) + 1u);
                                                if (_e599 == 0u) {
                                                    phi_646_ = (~(_e593) + 1u);
                                                } else {
                                                    phi_646_ = ~(_e593);
                                                }
                                                let _e605 = phi_646_;
                                                phi_648_ = array<u32, 2>(_e599, _e605);
                                            }
                                            let _e608 = phi_648_;
                                            let _e609 = (_e579 < 255u);
                                            if _e609 {
                                                phi_654_ = _e608;
                                            } else {
                                                phi_654_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e612 = phi_654_;
                                            let _e617 = (2u * ((select(16u, (_e579 / 16u), _e609) * _e196) + (_e223 + _e217)));
                                            let _e620 = atomicAdd((&global_8.member[_e617]), _e612[0]);
                                            let _e624 = (_e612[1] + select(0u, 1u, ((_e620 + _e612[0]) < _e612[0])));
                                            if (_e624 == 0u) {
                                            } else {
                                                let _e629 = atomicAdd((&global_8.member[(_e617 + 1u)]), _e624);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e223) + _e217)] = _e567;
                                    }
                                    let _e630 = (_e217 + 1u);
                                    if _e205 {
                                        let _e636 = bitcast<u32>(_e568);
                                        let _e639 = ((_e636 >> bitcast<u32>(23i)) & 255u);
                                        if (_e639 == 0u) {
                                        } else {
                                            let _e642 = (_e639 % 16u);
                                            let _e644 = ((_e636 & 8388607u) | 8388608u);
                                            let _e647 = (_e644 << bitcast<u32>((_e642 & 31u)));
                                            let _e653 = ((_e644 >> bitcast<u32>(((31u - _e642) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e636 >> bitcast<u32>(31i)) == 0u) {
                                                phi_716_ = array<u32, 2>(_e647, _e653);
                                            } else {
                                                let _e659 = (~(_e647) + 1u);
                                                if (_e659 == 0u) {
                                                    phi_714_ = (~(_e653) + 1u);
                                                } else {
                                                    phi_714_ = ~(_e653);
                                                }
                                                let _e665 = phi_714_;
                                                phi_716_ = array<u32, 2>(_e659, _e665);
                                            }
                                            let _e668 = phi_716_;
                                            let _e669 = (_e639 < 255u);
                                            if _e669 {
                                                phi_722_ = _e668;
                                            } else {
                                                phi_722_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e672 = phi_722_;
                                            let _e677 = (2u * ((select(16u, (_e639 / 16u), _e669) * _e196) + (_e223 + _e630)));
                                            let _e680 = atomicAdd((&global_8.member[_e677]), _e672[0]);
                                            let _e684 = (_e672[1] + select(0u, 1u, ((_e680 + _e672[0]) < _e672[0])));
                                            if (_e684 == 0u) {
                                            } else {
                                                let _e689 = atomicAdd((&global_8.member[(_e677 + 1u)]), _e684);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e223) + _e630)] = _e568;
                                    }
                                    let _e690 = (_e217 + 2u);
                                    if _e205 {
                                        let _e696 = bitcast<u32>(_e569);
                                        let _e699 = ((_e696 >> bitcast<u32>(23i)) & 255u);
                                        if (_e699 == 0u) {
                                        } else {
                                            let _e702 = (_e699 % 16u);
                                            let _e704 = ((_e696 & 8388607u) | 8388608u);
                                            let _e707 = (_e704 << bitcast<u32>((_e702 & 31u)));
                                            let _e713 = ((_e704 >> bitcast<u32>(((31u - _e702) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e696 >> bitcast<u32>(31i)) == 0u) {
                                                phi_784_ = array<u32, 2>(_e707, _e713);
                                            } else {
                                                let _e719 = (~(_e707) + 1u);
                                                if (_e719 == 0u) {
                                                    phi_782_ = (~(_e713) + 1u);
                                                } else {
                                                    phi_782_ = ~(_e713);
                                                }
                                                let _e725 = phi_782_;
                                                phi_784_ = array<u32, 2>(_e719, _e725);
                                            }
                                            let _e728 = phi_784_;
                                            let _e729 = (_e699 < 255u);
                                            if _e729 {
                                                phi_790_ = _e728;
                                            } else {
                                                phi_790_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e732 = phi_790_;
                                            let _e737 = (2u * ((select(16u, (_e699 / 16u), _e729) * _e196) + (_e223 + _e690)));
                                            let _e740 = atomicAdd((&global_8.member[_e737]), _e732[0]);
                                            let _e744 = (_e732[1] + select(0u, 1u, ((_e740 + _e732[0]) < _e732[0])));
                                            if (_e744 == 0u) {
                                            } else {
                                                let _e749 = atomicAdd((&global_8.member[(_e737 + 1u)]), _e744);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e223) + _e690)] = _e569;
                                    }
                                    let _e750 = (_e217 + 3u);
                                    if _e205 {
                                        let _e756 = bitcast<u32>(_e570);
                                        let _e759 = ((_e756 >> bitcast<u32>(23i)) & 255u);
                                        if (_e759 == 0u) {
                                        } else {
                                            let _e762 = (_e759 % 16u);
                                            let _e764 = ((_e756 & 8388607u) | 8388608u);
                                            let _e767 = (_e764 << bitcast<u32>((_e762 & 31u)));
                                            let _e773 = ((_e764 >> bitcast<u32>(((31u - _e762) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e756 >> bitcast<u32>(31i)) == 0u) {
                                                phi_852_ = array<u32, 2>(_e767, _e773);
                                            } else {
                                                let _e779 = (~(_e767) + 1u);
                                                if (_e779 == 0u) {
                                                    phi_850_ = (~(_e773) + 1u);
                                                } else {
                                                    phi_850_ = ~(_e773);
                                                }
                                                let _e785 = phi_850_;
                                                phi_852_ = array<u32, 2>(_e779, _e785);
                                            }
                                            let _e788 = phi_852_;
                                            let _e789 = (_e759 < 255u);
                                            if _e789 {
                                                phi_858_ = _e788;
                                            } else {
                                                phi_858_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e792 = phi_858_;
                                            let _e797 = (2u * ((select(16u, (_e759 / 16u), _e789) * _e196) + (_e223 + _e750)));
                                            let _e800 = atomicAdd((&global_8.member[_e797]), _e792[0]);
                                            let _e804 = (_e792[1] + select(0u, 1u, ((_e800 + _e792[0]) < _e792[0])));
                                            if (_e804 == 0u) {
                                            } else {
                                                let _e809 = atomicAdd((&global_8.member[(_e797 + 1u)]), _e804);
                                            }
                                        }
                                    } else {
                                        global_6.member[((_e211 + _e223) + _e750)] = _e570;
                                    }
                                }
                                phi_231_ = _e183;
                                phi_234_ = _e192;
                                phi_236_ = _e187;
                            }
                            let _e2838 = phi_231_;
                            let _e2840 = phi_234_;
                            let _e2842 = phi_236_;
                            local_24 = _e2838;
                            local_25 = _e2840;
                            local_27 = _e2842;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2861 = local_24;
                            phi_230_ = _e2861;
                            let _e2864 = local_25;
                            phi_233_ = _e2864;
                            let _e2869 = local_27;
                            phi_235_ = _e2869;
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
