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
    var phi_650_: u32;
    var phi_652_: array<u32, 2>;
    var phi_658_: array<u32, 2>;
    var phi_722_: u32;
    var phi_724_: array<u32, 2>;
    var phi_730_: array<u32, 2>;
    var phi_794_: u32;
    var phi_796_: array<u32, 2>;
    var phi_802_: array<u32, 2>;
    var phi_866_: u32;
    var phi_868_: array<u32, 2>;
    var phi_874_: array<u32, 2>;
    var phi_960_: vec4<f32>;
    var phi_993_: vec4<f32>;
    var phi_1026_: vec4<f32>;
    var phi_1059_: vec4<f32>;
    var phi_1074_: type_19;
    var phi_1077_: type_19;
    var phi_1079_: type_19;
    var phi_1081_: type_19;
    var phi_1083_: type_20;
    var phi_1099_: bool;
    var phi_1353_: type_19;
    var phi_1356_: type_19;
    var phi_1358_: type_19;
    var phi_1360_: type_19;
    var phi_1362_: type_20;
    var phi_1579_: type_19;
    var phi_1582_: type_19;
    var phi_1584_: type_19;
    var phi_1586_: type_19;
    var phi_1588_: type_20;
    var phi_1604_: bool;
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
    var phi_1920_: u32;
    var phi_1922_: array<u32, 2>;
    var phi_1928_: array<u32, 2>;
    var phi_1992_: u32;
    var phi_1994_: array<u32, 2>;
    var phi_2000_: array<u32, 2>;
    var phi_2064_: u32;
    var phi_2066_: array<u32, 2>;
    var phi_2072_: array<u32, 2>;
    var phi_2136_: u32;
    var phi_2138_: array<u32, 2>;
    var phi_2144_: array<u32, 2>;
    var phi_2214_: u32;
    var phi_2216_: array<u32, 2>;
    var phi_2222_: array<u32, 2>;
    var phi_2284_: u32;
    var phi_2286_: array<u32, 2>;
    var phi_2292_: array<u32, 2>;
    var phi_2354_: u32;
    var phi_2356_: array<u32, 2>;
    var phi_2362_: array<u32, 2>;
    var phi_2424_: u32;
    var phi_2426_: array<u32, 2>;
    var phi_2432_: array<u32, 2>;
    var phi_2502_: u32;
    var phi_2504_: array<u32, 2>;
    var phi_2510_: array<u32, 2>;
    var phi_2572_: u32;
    var phi_2574_: array<u32, 2>;
    var phi_2580_: array<u32, 2>;
    var phi_2642_: u32;
    var phi_2644_: array<u32, 2>;
    var phi_2650_: array<u32, 2>;
    var phi_2712_: u32;
    var phi_2714_: array<u32, 2>;
    var phi_2720_: array<u32, 2>;
    var phi_2790_: u32;
    var phi_2792_: array<u32, 2>;
    var phi_2798_: array<u32, 2>;
    var phi_2860_: u32;
    var phi_2862_: array<u32, 2>;
    var phi_2868_: array<u32, 2>;
    var phi_2930_: u32;
    var phi_2932_: array<u32, 2>;
    var phi_2938_: array<u32, 2>;
    var phi_3000_: u32;
    var phi_3002_: array<u32, 2>;
    var phi_3008_: array<u32, 2>;
    var phi_3038_: u32;
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
            let _e84 = (4u * _e62);
            let _e85 = (_e84 - 1u);
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
                            let _e2854 = local_22;
                            phi_155_ = _e2854;
                            let _e2857 = local_23;
                            phi_158_ = _e2857;
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
                    let _e2875 = local_26;
                    phi_235_ = _e2875;
                    loop {
                        let _e183 = phi_230_;
                        let _e185 = phi_233_;
                        let _e187 = phi_235_;
                        if (_e185 < select(_e97, _e102, (_e102 < _e97))) {
                            if (_e185 == _e183) {
                                let _e2839 = global_4.member[((_e187 + 2u) * _e137)];
                                if _e147 {
                                    phi_3038_ = _e2839;
                                } else {
                                    let _e2842 = global_5.member[_e2839];
                                    phi_3038_ = _e2842;
                                }
                                let _e2844 = phi_3038_;
                                phi_231_ = _e2844;
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
                                    let _e814 = (_e83[0] * 4u);
                                    let _e817 = global_3.member.member_5;
                                    let _e820 = (4u * (_e817 + (_e814 * _e62)));
                                    let _e821 = (_e49 - _e814);
                                    let _e826 = (_e820 + ((4u * select(_e821, 1u, (1u < _e821))) * _e62));
                                    let _e831 = (_e820 + ((4u * select(_e821, 2u, (2u < _e821))) * _e62));
                                    let _e836 = (_e820 + ((4u * select(_e821, 3u, (3u < _e821))) * _e62));
                                    let _e837 = (_e209 + _e820);
                                    let _e838 = (_e209 + _e826);
                                    let _e839 = (_e209 + _e831);
                                    let _e840 = (_e209 + _e836);
                                    let _e842 = (_e814 + 1u);
                                    let _e846 = (_e814 + 2u);
                                    let _e850 = (_e814 + 3u);
                                    if _e213 {
                                        let _e859 = global_6.member[(_e837 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e860 = (_e217 + 1u);
                                        let _e866 = global_6.member[(_e837 + select(_e85, _e860, (_e860 < _e85)))];
                                        let _e867 = (_e217 + 2u);
                                        let _e873 = global_6.member[(_e837 + select(_e85, _e867, (_e867 < _e85)))];
                                        let _e874 = (_e217 + 3u);
                                        let _e880 = global_6.member[(_e837 + select(_e85, _e874, (_e874 < _e85)))];
                                        phi_960_ = vec4<f32>(_e859, _e866, _e873, _e880);
                                    } else {
                                        phi_960_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e883 = phi_960_;
                                    if _e213 {
                                        let _e894 = global_6.member[(_e838 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e895 = (_e217 + 1u);
                                        let _e901 = global_6.member[(_e838 + select(_e85, _e895, (_e895 < _e85)))];
                                        let _e902 = (_e217 + 2u);
                                        let _e908 = global_6.member[(_e838 + select(_e85, _e902, (_e902 < _e85)))];
                                        let _e909 = (_e217 + 3u);
                                        let _e915 = global_6.member[(_e838 + select(_e85, _e909, (_e909 < _e85)))];
                                        phi_993_ = vec4<f32>(_e894, _e901, _e908, _e915);
                                    } else {
                                        phi_993_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e918 = phi_993_;
                                    if _e213 {
                                        let _e929 = global_6.member[(_e839 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e930 = (_e217 + 1u);
                                        let _e936 = global_6.member[(_e839 + select(_e85, _e930, (_e930 < _e85)))];
                                        let _e937 = (_e217 + 2u);
                                        let _e943 = global_6.member[(_e839 + select(_e85, _e937, (_e937 < _e85)))];
                                        let _e944 = (_e217 + 3u);
                                        let _e950 = global_6.member[(_e839 + select(_e85, _e944, (_e944 < _e85)))];
                                        phi_1026_ = vec4<f32>(_e929, _e936, _e943, _e950);
                                    } else {
                                        phi_1026_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e953 = phi_1026_;
                                    if _e213 {
                                        let _e964 = global_6.member[(_e840 + select(_e85, _e217, (_e217 < _e85)))];
                                        let _e965 = (_e217 + 1u);
                                        let _e971 = global_6.member[(_e840 + select(_e85, _e965, (_e965 < _e85)))];
                                        let _e972 = (_e217 + 2u);
                                        let _e978 = global_6.member[(_e840 + select(_e85, _e972, (_e972 < _e85)))];
                                        let _e979 = (_e217 + 3u);
                                        let _e985 = global_6.member[(_e840 + select(_e85, _e979, (_e979 < _e85)))];
                                        phi_1059_ = vec4<f32>(_e964, _e971, _e978, _e985);
                                    } else {
                                        phi_1059_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e988 = phi_1059_;
                                    let _e996 = ((_e814 * _e216) / 4u);
                                    let _e997 = ((select(_e49, _e842, (_e842 < _e49)) * _e216) / 4u);
                                    let _e998 = ((select(_e49, _e846, (_e846 < _e49)) * _e216) / 4u);
                                    let _e999 = ((select(_e49, _e850, (_e850 < _e49)) * _e216) / 4u);
                                    let _e1000 = (_e218 / 4u);
                                    let _e1001 = (_e216 / 4u);
                                    phi_1074_ = type_19(_e988.x, _e988.y, _e988.z, _e988.w);
                                    phi_1077_ = type_19(_e953.x, _e953.y, _e953.z, _e953.w);
                                    phi_1079_ = type_19(_e918.x, _e918.y, _e918.z, _e918.w);
                                    phi_1081_ = type_19(_e883.x, _e883.y, _e883.z, _e883.w);
                                    phi_1083_ = type_20((_e200 / 4u), _e200, _e203);
                                    loop {
                                        let _e1003 = phi_1074_;
                                        let _e1005 = phi_1077_;
                                        let _e1007 = phi_1079_;
                                        let _e1009 = phi_1081_;
                                        let _e1011 = phi_1083_;
                                        local_43 = _e1003;
                                        local_45 = _e1005;
                                        local_47 = _e1007;
                                        local_49 = _e1009;
                                        local_51 = _e1011;
                                        let _e1013 = (4u * _e1011.member);
                                        if (_e1013 < _e1011.member_2) {
                                            phi_1099_ = select(((_e1013 + 4u) > _e1011.member_2), true, (_e1013 < _e1011.member_1));
                                        } else {
                                            phi_1099_ = false;
                                        }
                                        let _e1022 = phi_1099_;
                                        if _e1022 {
                                            let _e1026 = global_7.member[(_e1000 + _e1011.member)];
                                            let _e1033 = (_e1011.member_2 - _e1011.member_1);
                                            let _e1034 = ((_e1013 - _e1011.member_1) < _e1033);
                                            let _e1035 = select(0f, _e1026.x, _e1034);
                                            let _e1038 = (((_e1013 + 1u) - _e1011.member_1) < _e1033);
                                            let _e1039 = select(0f, _e1026.y, _e1038);
                                            let _e1042 = (((_e1013 + 2u) - _e1011.member_1) < _e1033);
                                            let _e1043 = select(0f, _e1026.z, _e1042);
                                            let _e1046 = (((_e1013 + 3u) - _e1011.member_1) < _e1033);
                                            let _e1047 = select(0f, _e1026.w, _e1046);
                                            let _e1052 = global_7.member[((_e1000 + _e1001) + _e1011.member)];
                                            let _e1057 = select(0f, _e1052.x, _e1034);
                                            let _e1058 = select(0f, _e1052.y, _e1038);
                                            let _e1059 = select(0f, _e1052.z, _e1042);
                                            let _e1060 = select(0f, _e1052.w, _e1046);
                                            let _e1066 = global_7.member[((_e1000 + (2u * _e1001)) + _e1011.member)];
                                            let _e1071 = select(0f, _e1066.x, _e1034);
                                            let _e1072 = select(0f, _e1066.y, _e1038);
                                            let _e1073 = select(0f, _e1066.z, _e1042);
                                            let _e1074 = select(0f, _e1066.w, _e1046);
                                            let _e1080 = global_7.member[((_e1000 + (3u * _e1001)) + _e1011.member)];
                                            let _e1085 = select(0f, _e1080.x, _e1034);
                                            let _e1086 = select(0f, _e1080.y, _e1038);
                                            let _e1087 = select(0f, _e1080.z, _e1042);
                                            let _e1088 = select(0f, _e1080.w, _e1046);
                                            let _e1092 = global_9.member[(_e996 + _e1011.member)];
                                            let _e1097 = select(0f, _e1092.x, _e1034);
                                            let _e1098 = select(0f, _e1092.y, _e1038);
                                            let _e1099 = select(0f, _e1092.z, _e1042);
                                            let _e1100 = select(0f, _e1092.w, _e1046);
                                            let _e1104 = global_9.member[(_e997 + _e1011.member)];
                                            let _e1109 = select(0f, _e1104.x, _e1034);
                                            let _e1110 = select(0f, _e1104.y, _e1038);
                                            let _e1111 = select(0f, _e1104.z, _e1042);
                                            let _e1112 = select(0f, _e1104.w, _e1046);
                                            let _e1116 = global_9.member[(_e998 + _e1011.member)];
                                            let _e1121 = select(0f, _e1116.x, _e1034);
                                            let _e1122 = select(0f, _e1116.y, _e1038);
                                            let _e1123 = select(0f, _e1116.z, _e1042);
                                            let _e1124 = select(0f, _e1116.w, _e1046);
                                            let _e1128 = global_9.member[(_e999 + _e1011.member)];
                                            let _e1133 = select(0f, _e1128.x, _e1034);
                                            let _e1134 = select(0f, _e1128.y, _e1038);
                                            let _e1135 = select(0f, _e1128.z, _e1042);
                                            let _e1136 = select(0f, _e1128.w, _e1046);
                                            local_38 = type_19(((_e1136 * _e1047) + ((_e1135 * _e1043) + ((_e1134 * _e1039) + ((_e1133 * _e1035) + _e1003.member)))), ((_e1136 * _e1060) + ((_e1135 * _e1059) + ((_e1134 * _e1058) + ((_e1133 * _e1057) + _e1003.member_1)))), ((_e1136 * _e1074) + ((_e1135 * _e1073) + ((_e1134 * _e1072) + ((_e1133 * _e1071) + _e1003.member_2)))), ((_e1136 * _e1088) + ((_e1135 * _e1087) + ((_e1134 * _e1086) + ((_e1133 * _e1085) + _e1003.member_3)))));
                                            local_39 = type_19(((_e1124 * _e1047) + ((_e1123 * _e1043) + ((_e1122 * _e1039) + ((_e1121 * _e1035) + _e1005.member)))), ((_e1124 * _e1060) + ((_e1123 * _e1059) + ((_e1122 * _e1058) + ((_e1121 * _e1057) + _e1005.member_1)))), ((_e1124 * _e1074) + ((_e1123 * _e1073) + ((_e1122 * _e1072) + ((_e1121 * _e1071) + _e1005.member_2)))), ((_e1124 * _e1088) + ((_e1123 * _e1087) + ((_e1122 * _e1086) + ((_e1121 * _e1085) + _e1005.member_3)))));
                                            local_40 = type_19(((_e1112 * _e1047) + ((_e1111 * _e1043) + ((_e1110 * _e1039) + ((_e1109 * _e1035) + _e1007.member)))), ((_e1112 * _e1060) + ((_e1111 * _e1059) + ((_e1110 * _e1058) + ((_e1109 * _e1057) + _e1007.member_1)))), ((_e1112 * _e1074) + ((_e1111 * _e1073) + ((_e1110 * _e1072) + ((_e1109 * _e1071) + _e1007.member_2)))), ((_e1112 * _e1088) + ((_e1111 * _e1087) + ((_e1110 * _e1086) + ((_e1109 * _e1085) + _e1007.member_3)))));
                                            local_41 = type_19(((_e1100 * _e1047) + ((_e1099 * _e1043) + ((_e1098 * _e1039) + ((_e1097 * _e1035) + _e1009.member)))), ((_e1100 * _e1060) + ((_e1099 * _e1059) + ((_e1098 * _e1058) + ((_e1097 * _e1057) + _e1009.member_1)))), ((_e1100 * _e1074) + ((_e1099 * _e1073) + ((_e1098 * _e1072) + ((_e1097 * _e1071) + _e1009.member_2)))), ((_e1100 * _e1088) + ((_e1099 * _e1087) + ((_e1098 * _e1086) + ((_e1097 * _e1085) + _e1009.member_3)))));
                                            local_42 = type_20((_e1011.member + 1u), _e1011.member_1, _e1011.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2930 = local_38;
                                            phi_1074_ = _e2930;
                                            let _e2933 = local_39;
                                            phi_1077_ = _e2933;
                                            let _e2936 = local_40;
                                            phi_1079_ = _e2936;
                                            let _e2939 = local_41;
                                            phi_1081_ = _e2939;
                                            let _e2942 = local_42;
                                            phi_1083_ = _e2942;
                                        }
                                    }
                                    let _e2946 = local_43;
                                    phi_1353_ = _e2946;
                                    let _e2951 = local_45;
                                    phi_1356_ = _e2951;
                                    let _e2956 = local_47;
                                    phi_1358_ = _e2956;
                                    let _e2961 = local_49;
                                    phi_1360_ = _e2961;
                                    let _e2966 = local_51;
                                    phi_1362_ = _e2966;
                                    loop {
                                        let _e1291 = phi_1353_;
                                        let _e1293 = phi_1356_;
                                        let _e1295 = phi_1358_;
                                        let _e1297 = phi_1360_;
                                        let _e1299 = phi_1362_;
                                        local_53 = _e1291;
                                        local_55 = _e1293;
                                        local_57 = _e1295;
                                        local_59 = _e1297;
                                        local_61 = _e1299;
                                        if !((((4u * _e1299.member) + 4u) > _e1299.member_2)) {
                                            let _e1309 = global_7.member[(_e1000 + _e1299.member)];
                                            let _e1318 = global_7.member[((_e1000 + _e1001) + _e1299.member)];
                                            let _e1328 = global_7.member[((_e1000 + (2u * _e1001)) + _e1299.member)];
                                            let _e1338 = global_7.member[((_e1000 + (3u * _e1001)) + _e1299.member)];
                                            let _e1346 = global_9.member[(_e996 + _e1299.member)];
                                            let _e1354 = global_9.member[(_e997 + _e1299.member)];
                                            let _e1362 = global_9.member[(_e998 + _e1299.member)];
                                            let _e1370 = global_9.member[(_e999 + _e1299.member)];
                                            local_44 = type_19(((_e1370.w * _e1309.w) + ((_e1370.z * _e1309.z) + ((_e1370.y * _e1309.y) + ((_e1370.x * _e1309.x) + _e1291.member)))), ((_e1370.w * _e1318.w) + ((_e1370.z * _e1318.z) + ((_e1370.y * _e1318.y) + ((_e1370.x * _e1318.x) + _e1291.member_1)))), ((_e1370.w * _e1328.w) + ((_e1370.z * _e1328.z) + ((_e1370.y * _e1328.y) + ((_e1370.x * _e1328.x) + _e1291.member_2)))), ((_e1370.w * _e1338.w) + ((_e1370.z * _e1338.z) + ((_e1370.y * _e1338.y) + ((_e1370.x * _e1338.x) + _e1291.member_3)))));
                                            local_46 = type_19(((_e1362.w * _e1309.w) + ((_e1362.z * _e1309.z) + ((_e1362.y * _e1309.y) + ((_e1362.x * _e1309.x) + _e1293.member)))), ((_e1362.w * _e1318.w) + ((_e1362.z * _e1318.z) + ((_e1362.y * _e1318.y) + ((_e1362.x * _e1318.x) + _e1293.member_1)))), ((_e1362.w * _e1328.w) + ((_e1362.z * _e1328.z) + ((_e1362.y * _e1328.y) + ((_e1362.x * _e1328.x) + _e1293.member_2)))), ((_e1362.w * _e1338.w) + ((_e1362.z * _e1338.z) + ((_e1362.y * _e1338.y) + ((_e1362.x * _e1338.x) + _e1293.member_3)))));
                                            local_48 = type_19(((_e1354.w * _e1309.w) + ((_e1354.z * _e1309.z) + ((_e1354.y * _e1309.y) + ((_e1354.x * _e1309.x) + _e1295.member)))), ((_e1354.w * _e1318.w) + ((_e1354.z * _e1318.z) + ((_e1354.y * _e1318.y) + ((_e1354.x * _e1318.x) + _e1295.member_1)))), ((_e1354.w * _e1328.w) + ((_e1354.z * _e1328.z) + ((_e1354.y * _e1328.y) + ((_e1354.x * _e1328.x) + _e1295.member_2)))), ((_e1354.w * _e1338.w) + ((_e1354.z * _e1338.z) + ((_e1354.y * _e1338.y) + ((_e1354.x * _e1338.x) + _e1295.member_3)))));
                                            local_50 = type_19(((_e1346.w * _e1309.w) + ((_e1346.z * _e1309.z) + ((_e1346.y * _e1309.y) + ((_e1346.x * _e1309.x) + _e1297.member)))), ((_e1346.w * _e1318.w) + ((_e1346.z * _e1318.z) + ((_e1346.y * _e1318.y) + ((_e1346.x * _e1318.x) + _e1297.member_1)))), ((_e1346.w * _e1328.w) + ((_e1346.z * _e1328.z) + ((_e1346.y * _e1328.y) + ((_e1346.x * _e1328.x) + _e1297.member_2)))), ((_e1346.w * _e1338.w) + ((_e1346.z * _e1338.z) + ((_e1346.y * _e1338.y) + ((_e1346.x * _e1338.x) + _e1297.member_3)))));
                                            local_52 = type_20((_e1299.member + 1u), _e1299.member_1, _e1299.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2948 = local_44;
                                            phi_1353_ = _e2948;
                                            let _e2953 = local_46;
                                            phi_1356_ = _e2953;
                                            let _e2958 = local_48;
                                            phi_1358_ = _e2958;
                                            let _e2963 = local_50;
                                            phi_1360_ = _e2963;
                                            let _e2968 = local_52;
                                            phi_1362_ = _e2968;
                                        }
                                    }
                                    let _e2971 = local_53;
                                    phi_1579_ = _e2971;
                                    let _e2976 = local_55;
                                    phi_1582_ = _e2976;
                                    let _e2981 = local_57;
                                    phi_1584_ = _e2981;
                                    let _e2986 = local_59;
                                    phi_1586_ = _e2986;
                                    let _e2991 = local_61;
                                    phi_1588_ = _e2991;
                                    loop {
                                        let _e1529 = phi_1579_;
                                        let _e1531 = phi_1582_;
                                        let _e1533 = phi_1584_;
                                        let _e1535 = phi_1586_;
                                        let _e1537 = phi_1588_;
                                        local_6 = _e1535;
                                        local_7 = _e1535;
                                        local_8 = _e1535;
                                        local_9 = _e1535;
                                        local_10 = _e1533;
                                        local_11 = _e1533;
                                        local_12 = _e1533;
                                        local_13 = _e1533;
                                        local_14 = _e1531;
                                        local_15 = _e1531;
                                        local_16 = _e1531;
                                        local_17 = _e1531;
                                        local_18 = _e1529;
                                        local_19 = _e1529;
                                        local_20 = _e1529;
                                        local_21 = _e1529;
                                        let _e1539 = (4u * _e1537.member);
                                        if (_e1539 < _e1537.member_2) {
                                            phi_1604_ = select(((_e1539 + 4u) > _e1537.member_2), true, (_e1539 < _e1537.member_1));
                                        } else {
                                            phi_1604_ = false;
                                        }
                                        let _e1548 = phi_1604_;
                                        if _e1548 {
                                            let _e1552 = global_7.member[(_e1000 + _e1537.member)];
                                            let _e1559 = (_e1537.member_2 - _e1537.member_1);
                                            let _e1560 = ((_e1539 - _e1537.member_1) < _e1559);
                                            let _e1561 = select(0f, _e1552.x, _e1560);
                                            let _e1564 = (((_e1539 + 1u) - _e1537.member_1) < _e1559);
                                            let _e1565 = select(0f, _e1552.y, _e1564);
                                            let _e1568 = (((_e1539 + 2u) - _e1537.member_1) < _e1559);
                                            let _e1569 = select(0f, _e1552.z, _e1568);
                                            let _e1572 = (((_e1539 + 3u) - _e1537.member_1) < _e1559);
                                            let _e1573 = select(0f, _e1552.w, _e1572);
                                            let _e1578 = global_7.member[((_e1000 + _e1001) + _e1537.member)];
                                            let _e1583 = select(0f, _e1578.x, _e1560);
                                            let _e1584 = select(0f, _e1578.y, _e1564);
                                            let _e1585 = select(0f, _e1578.z, _e1568);
                                            let _e1586 = select(0f, _e1578.w, _e1572);
                                            let _e1592 = global_7.member[((_e1000 + (2u * _e1001)) + _e1537.member)];
                                            let _e1597 = select(0f, _e1592.x, _e1560);
                                            let _e1598 = select(0f, _e1592.y, _e1564);
                                            let _e1599 = select(0f, _e1592.z, _e1568);
                                            let _e1600 = select(0f, _e1592.w, _e1572);
                                            let _e1606 = global_7.member[((_e1000 + (3u * _e1001)) + _e1537.member)];
                                            let _e1611 = select(0f, _e1606.x, _e1560);
                                            let _e1612 = select(0f, _e1606.y, _e1564);
                                            let _e1613 = select(0f, _e1606.z, _e1568);
                                            let _e1614 = select(0f, _e1606.w, _e1572);
                                            let _e1618 = global_9.member[(_e996 + _e1537.member)];
                                            let _e1623 = select(0f, _e1618.x, _e1560);
                                            let _e1624 = select(0f, _e1618.y, _e1564);
                                            let _e1625 = select(0f, _e1618.z, _e1568);
                                            let _e1626 = select(0f, _e1618.w, _e1572);
                                            let _e1630 = global_9.member[(_e997 + _e1537.member)];
                                            let _e1635 = select(0f, _e1630.x, _e1560);
                                            let _e1636 = select(0f, _e1630.y, _e1564);
                                            let _e1637 = select(0f, _e1630.z, _e1568);
                                            let _e1638 = select(0f, _e1630.w, _e1572);
                                            let _e1642 = global_9.member[(_e998 + _e1537.member)];
                                            let _e1647 = select(0f, _e1642.x, _e1560);
                                            let _e1648 = select(0f, _e1642.y, _e1564);
                                            let _e1649 = select(0f, _e1642.z, _e1568);
                                            let _e1650 = select(0f, _e1642.w, _e1572);
                                            let _e1654 = global_9.member[(_e999 + _e1537.member)];
                                            let _e1659 = select(0f, _e1654.x, _e1560);
                                            let _e1660 = select(0f, _e1654.y, _e1564);
                                            let _e1661 = select(0f, _e1654.z, _e1568);
                                            let _e1662 = select(0f, _e1654.w, _e1572);
                                            local_54 = type_19(((_e1662 * _e1573) + ((_e1661 * _e1569) + ((_e1660 * _e1565) + ((_e1659 * _e1561) + _e1529.member)))), ((_e1662 * _e1586) + ((_e1661 * _e1585) + ((_e1660 * _e1584) + ((_e1659 * _e1583) + _e1529.member_1)))), ((_e1662 * _e1600) + ((_e1661 * _e1599) + ((_e1660 * _e1598) + ((_e1659 * _e1597) + _e1529.member_2)))), ((_e1662 * _e1614) + ((_e1661 * _e1613) + ((_e1660 * _e1612) + ((_e1659 * _e1611) + _e1529.member_3)))));
                                            local_56 = type_19(((_e1650 * _e1573) + ((_e1649 * _e1569) + ((_e1648 * _e1565) + ((_e1647 * _e1561) + _e1531.member)))), ((_e1650 * _e1586) + ((_e1649 * _e1585) + ((_e1648 * _e1584) + ((_e1647 * _e1583) + _e1531.member_1)))), ((_e1650 * _e1600) + ((_e1649 * _e1599) + ((_e1648 * _e1598) + ((_e1647 * _e1597) + _e1531.member_2)))), ((_e1650 * _e1614) + ((_e1649 * _e1613) + ((_e1648 * _e1612) + ((_e1647 * _e1611) + _e1531.member_3)))));
                                            local_58 = type_19(((_e1638 * _e1573) + ((_e1637 * _e1569) + ((_e1636 * _e1565) + ((_e1635 * _e1561) + _e1533.member)))), ((_e1638 * _e1586) + ((_e1637 * _e1585) + ((_e1636 * _e1584) + ((_e1635 * _e1583) + _e1533.member_1)))), ((_e1638 * _e1600) + ((_e1637 * _e1599) + ((_e1636 * _e1598) + ((_e1635 * _e1597) + _e1533.member_2)))), ((_e1638 * _e1614) + ((_e1637 * _e1613) + ((_e1636 * _e1612) + ((_e1635 * _e1611) + _e1533.member_3)))));
                                            local_60 = type_19(((_e1626 * _e1573) + ((_e1625 * _e1569) + ((_e1624 * _e1565) + ((_e1623 * _e1561) + _e1535.member)))), ((_e1626 * _e1586) + ((_e1625 * _e1585) + ((_e1624 * _e1584) + ((_e1623 * _e1583) + _e1535.member_1)))), ((_e1626 * _e1600) + ((_e1625 * _e1599) + ((_e1624 * _e1598) + ((_e1623 * _e1597) + _e1535.member_2)))), ((_e1626 * _e1614) + ((_e1625 * _e1613) + ((_e1624 * _e1612) + ((_e1623 * _e1611) + _e1535.member_3)))));
                                            local_62 = type_20((_e1537.member + 1u), _e1537.member_1, _e1537.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2973 = local_54;
                                            phi_1579_ = _e2973;
                                            let _e2978 = local_56;
                                            phi_1582_ = _e2978;
                                            let _e2983 = local_58;
                                            phi_1584_ = _e2983;
                                            let _e2988 = local_60;
                                            phi_1586_ = _e2988;
                                            let _e2993 = local_62;
                                            phi_1588_ = _e2993;
                                        }
                                    }
                                    let _e1817 = local_6;
                                    let _e1820 = local_7;
                                    let _e1823 = local_8;
                                    let _e1826 = local_9;
                                    let _e1829 = local_10;
                                    let _e1832 = local_11;
                                    let _e1835 = local_12;
                                    let _e1838 = local_13;
                                    let _e1841 = local_14;
                                    let _e1844 = local_15;
                                    let _e1847 = local_16;
                                    let _e1850 = local_17;
                                    let _e1853 = local_18;
                                    let _e1856 = local_19;
                                    let _e1859 = local_20;
                                    let _e1862 = local_21;
                                    let _e1864 = (_e1817.member + 0f);
                                    let _e1865 = (_e1820.member_1 + 0f);
                                    let _e1866 = (_e1823.member_2 + 0f);
                                    let _e1867 = (_e1826.member_3 + 0f);
                                    let _e1868 = (_e217 < _e84);
                                    if _e1868 {
                                        if _e205 {
                                            let _e1874 = bitcast<u32>(_e1864);
                                            let _e1877 = ((_e1874 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1877 == 0u) {
                                            } else {
                                                let _e1880 = (_e1877 % 16u);
                                                let _e1882 = ((_e1874 & 8388607u) | 8388608u);
                                                let _e1885 = (_e1882 << bitcast<u32>((_e1880 & 31u)));
                                                let _e1891 = ((_e1882 >> bitcast<u32>(((31u - _e1880) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1874 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1922_ = array<u32, 2>(_e1885, _e1891);
                                                } else {
                                                    let _e1897 = (~(_e1885) + 1u);
                                                    if (_e1897 == 0u) {
                                                        phi_1920_ = (~(_e1891) + 1u);
                                                    } else {
                                                        phi_1920_ = ~(_e1891);
                                                    }
                                                    let _e1903 = phi_1920_;
                                                    phi_1922_ = array<u32, 2>(_e1897, _e1903);
                                                }
                                                let _e1906 = phi_1922_;
                                                let _e1907 = (_e1877 < 255u);
                                                if _e1907 {
                                                    phi_1928_ = _e1906;
                                                } else {
                                                    phi_1928_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1910 = phi_1928_;
                                                let _e1915 = (2u * ((select(16u, (_e1877 / 16u), _e1907) * _e196) + (_e820 + _e217)));
                                                let _e1918 = atomicAdd((&global_8.member[_e1915]), _e1910[0]);
                                                let _e1922 = (_e1910[1] + select(0u, 1u, ((_e1918 + _e1910[0]) < _e1910[0])));
                                                if (_e1922 == 0u) {
                                                } else {
                                                    let _e1927 = atomicAdd((&global_8.member[(_e1915 + 1u)]), _e1922);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e820) + _e217)] = _e1864;
                                        }
                                    }
                                    let _e1928 = (_e217 + 1u);
                                    let _e1929 = (_e1928 < _e84);
                                    if _e1929 {
                                        if _e205 {
                                            let _e1935 = bitcast<u32>(_e1865);
                                            let _e1938 = ((_e1935 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1938 == 0u) {
                                            } else {
                                                let _e1941 = (_e1938 % 16u);
                                                let _e1943 = ((_e1935 & 8388607u) | 8388608u);
                                                let _e1946 = (_e1943 << bitcast<u32>((_e1941 & 31u)));
                                                let _e1952 = ((_e1943 >> bitcast<u32>(((31u - _e1941) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1935 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1994_ = array<u32, 2>(_e1946, _e1952);
                                                } else {
                                                    let _e1958 = (~(_e1946) + 1u);
                                                    if (_e1958 == 0u) {
                                                        phi_1992_ = (~(_e1952) + 1u);
                                                    } else {
                                                        phi_1992_ = ~(_e1952);
                                                    }
                                                    let _e1964 = phi_1992_;
                                                    phi_1994_ = array<u32, 2>(_e1958, _e1964);
                                                }
                                                let _e1967 = phi_1994_;
                                                let _e1968 = (_e1938 < 255u);
                                                if _e1968 {
                                                    phi_2000_ = _e1967;
                                                } else {
                                                    phi_2000_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1971 = phi_2000_;
                                                let _e1976 = (2u * ((select(16u, (_e1938 / 16u), _e1968) * _e196) + (_e820 + _e1928)));
                                                let _e1979 = atomicAdd((&global_8.member[_e1976]), _e1971[0]);
                                                let _e1983 = (_e1971[1] + select(0u, 1u, ((_e1979 + _e1971[0]) < _e1971[0])));
                                                if (_e1983 == 0u) {
                                                } else {
                                                    let _e1988 = atomicAdd((&global_8.member[(_e1976 + 1u)]), _e1983);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e820) + _e1928)] = _e1865;
                                        }
                                    }
                                    let _e1989 = (_e217 + 2u);
                                    let _e1990 = (_e1989 < _e84);
                                    if _e1990 {
                                        if _e205 {
                                            let _e1996 = bitcast<u32>(_e1866);
                                            let _e1999 = ((_e1996 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1999 == 0u) {
                                            } else {
                                                let _e2002 = (_e1999 % 16u);
                                                let _e2004 = ((_e1996 & 8388607u) | 8388608u);
                                                let _e2007 = (_e2004 << bitcast<u32>((_e2002 & 31u)));
                                                let _e2013 = ((_e2004 >> bitcast<u32>(((31u - _e2002) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1996 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2066_ = array<u32, 2>(_e2007, _e2013);
                                                } else {
                                                    let _e2019 = (~(_e2007) + 1u);
                                                    if (_e2019 == 0u) {
                                                        phi_2064_ = (~(_e2013) + 1u);
                                                    } else {
                                                        phi_2064_ = ~(_e2013);
                                                    }
                                                    let _e2025 = phi_2064_;
                                                    phi_2066_ = array<u32, 2>(_e2019, _e2025);
                                                }
                                                let _e2028 = phi_2066_;
                                                let _e2029 = (_e1999 < 255u);
                                                if _e2029 {
                                                    phi_2072_ = _e2028;
                                                } else {
                                                    phi_2072_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2032 = phi_2072_;
                                                let _e2037 = (2u * ((select(16u, (_e1999 / 16u), _e2029) * _e196) + (_e820 + _e1989)));
                                                let _e2040 = atomicAdd((&global_8.member[_e2037]), _e2032[0]);
                                                let _e2044 = (_e2032[1] + select(0u, 1u, ((_e2040 + _e2032[0]) < _e2032[0])));
                                                if (_e2044 == 0u) {
                                                } else {
                                                    let _e2049 = atomicAdd((&global_8.member[(_e2037 + 1u)]), _e2044);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e820) + _e1989)] = _e1866;
                                        }
                                    }
                                    let _e2050 = (_e217 + 3u);
                                    let _e2051 = (_e2050 < _e84);
                                    if _e2051 {
                                        if _e205 {
                                            let _e2057 = bitcast<u32>(_e1867);
                                            let _e2060 = ((_e2057 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2060 == 0u) {
                                            } else {
                                                let _e2063 = (_e2060 % 16u);
                                                let _e2065 = ((_e2057 & 8388607u) | 8388608u);
                                                let _e2068 = (_e2065 << bitcast<u32>((_e2063 & 31u)));
                                                let _e2074 = ((_e2065 >> bitcast<u32>(((31u - _e2063) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2057 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2138_ = array<u32, 2>(_e2068, _e2074);
                                                } else {
                                                    let _e2080 = (~(_e2068) + 1u);
                                                    if (_e2080 == 0u) {
                                                        phi_2136_ = (~(_e2074) + 1u);
                                                    } else {
                                                        phi_2136_ = ~(_e2074);
                                                    }
                                                    let _e2086 = phi_2136_;
                                                    phi_2138_ = array<u32, 2>(_e2080, _e2086);
                                                }
                                                let _e2089 = phi_2138_;
                                                let _e2090 = (_e2060 < 255u);
                                                if _e2090 {
                                                    phi_2144_ = _e2089;
                                                } else {
                                                    phi_2144_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2093 = phi_2144_;
                                                let _e2098 = (2u * ((select(16u, (_e2060 / 16u), _e2090) * _e196) + (_e820 + _e2050)));
                                                let _e2101 = atomicAdd((&global_8.member[_e2098]), _e2093[0]);
                                                let _e2105 = (_e2093[1] + select(0u, 1u, ((_e2101 + _e2093[0]) < _e2093[0])));
                                                if (_e2105 == 0u) {
                                                } else {
                                                    let _e2110 = atomicAdd((&global_8.member[(_e2098 + 1u)]), _e2105);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e820) + _e2050)] = _e1867;
                                        }
                                    }
                                    if (_e842 < _e48) {
                                        let _e2112 = (_e1829.member + 0f);
                                        let _e2113 = (_e1832.member_1 + 0f);
                                        let _e2114 = (_e1835.member_2 + 0f);
                                        let _e2115 = (_e1838.member_3 + 0f);
                                        if _e1868 {
                                            if _e205 {
                                                let _e2121 = bitcast<u32>(_e2112);
                                                let _e2124 = ((_e2121 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2124 == 0u) {
                                                } else {
                                                    let _e2127 = (_e2124 % 16u);
                                                    let _e2129 = ((_e2121 & 8388607u) | 8388608u);
                                                    let _e2132 = (_e2129 << bitcast<u32>((_e2127 & 31u)));
                                                    let _e2138 = ((_e2129 >> bitcast<u32>(((31u - _e2127) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2121 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2216_ = array<u32, 2>(_e2132, _e2138);
                                                    } else {
                                                        let _e2144 = (~(_e2132) + 1u);
                                                        if (_e2144 == 0u) {
                                                            phi_2214_ = (~(_e2138) + 1u);
                                                        } else {
                                                            phi_2214_ = ~(_e2138);
                                                        }
                                                        let _e2150 = phi_2214_;
                                                        phi_2216_ = array<u32, 2>(_e2144, _e2150);
                                                    }
                                                    let _e2153 = phi_2216_;
                                                    let _e2154 = (_e2124 < 255u);
                                                    if _e2154 {
                                                        phi_2222_ = _e2153;
                                                    } else {
                                                        phi_2222_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2157 = phi_2222_;
                                                    let _e2162 = (2u * ((select(16u, (_e2124 / 16u), _e2154) * _e196) + (_e826 + _e217)));
                                                    let _e2165 = atomicAdd((&global_8.member[_e2162]), _e2157[0]);
                                                    let _e2169 = (_e2157[1] + select(0u, 1u, ((_e2165 + _e2157[0]) < _e2157[0])));
                                                    if (_e2169 == 0u) {
                                                    } else {
                                                        let _e2174 = atomicAdd((&global_8.member[(_e2162 + 1u)]), _e2169);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e826) + _e217)] = _e2112;
                                            }
                                        }
                                        if _e1929 {
                                            if _e205 {
                                                let _e2180 = bitcast<u32>(_e2113);
                                                let _e2183 = ((_e2180 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2183 == 0u) {
                                                } else {
                                                    let _e2186 = (_e2183 % 16u);
                                                    let _e2188 = ((_e2180 & 8388607u) | 8388608u);
                                                    let _e2191 = (_e2188 << bitcast<u32>((_e2186 & 31u)));
                                                    let _e2197 = ((_e2188 >> bitcast<u32>(((31u - _e2186) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2180 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2286_ = array<u32, 2>(_e2191, _e2197);
                                                    } else {
                                                        let _e2203 = (~(_e2191) + 1u);
                                                        if (_e2203 == 0u) {
                                                            phi_2284_ = (~(_e2197) + 1u);
                                                        } else {
                                                            phi_2284_ = ~(_e2197);
                                                        }
                                                        let _e2209 = phi_2284_;
                                                        phi_2286_ = array<u32, 2>(_e2203, _e2209);
                                                    }
                                                    let _e2212 = phi_2286_;
                                                    let _e2213 = (_e2183 < 255u);
                                                    if _e2213 {
                                                        phi_2292_ = _e2212;
                                                    } else {
                                                        phi_2292_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2216 = phi_2292_;
                                                    let _e2221 = (2u * ((select(16u, (_e2183 / 16u), _e2213) * _e196) + (_e826 + _e1928)));
                                                    let _e2224 = atomicAdd((&global_8.member[_e2221]), _e2216[0]);
                                                    let _e2228 = (_e2216[1] + select(0u, 1u, ((_e2224 + _e2216[0]) < _e2216[0])));
                                                    if (_e2228 == 0u) {
                                                    } else {
                                                        let _e2233 = atomicAdd((&global_8.member[(_e2221 + 1u)]), _e2228);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e826) + _e1928)] = _e2113;
                                            }
                                        }
                                        if _e1990 {
                                            if _e205 {
                                                let _e2239 = bitcast<u32>(_e2114);
                                                let _e2242 = ((_e2239 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2242 == 0u) {
                                                } else {
                                                    let _e2245 = (_e2242 % 16u);
                                                    let _e2247 = ((_e2239 & 8388607u) | 8388608u);
                                                    let _e2250 = (_e2247 << bitcast<u32>((_e2245 & 31u)));
                                                    let _e2256 = ((_e2247 >> bitcast<u32>(((31u - _e2245) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2239 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2356_ = array<u32, 2>(_e2250, _e2256);
                                                    } else {
                                                        let _e2262 = (~(_e2250) + 1u);
                                                        if (_e2262 == 0u) {
                                                            phi_2354_ = (~(_e2256) + 1u);
                                                        } else {
                                                            phi_2354_ = ~(_e2256);
                                                        }
                                                        let _e2268 = phi_2354_;
                                                        phi_2356_ = array<u32, 2>(_e2262, _e2268);
                                                    }
                                                    let _e2271 = phi_2356_;
                                                    let _e2272 = (_e2242 < 255u);
                                                    if _e2272 {
                                                        phi_2362_ = _e2271;
                                                    } else {
                                                        phi_2362_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2275 = phi_2362_;
                                                    let _e2280 = (2u * ((select(16u, (_e2242 / 16u), _e2272) * _e196) + (_e826 + _e1989)));
                                                    let _e2283 = atomicAdd((&global_8.member[_e2280]), _e2275[0]);
                                                    let _e2287 = (_e2275[1] + select(0u, 1u, ((_e2283 + _e2275[0]) < _e2275[0])));
                                                    if (_e2287 == 0u) {
                                                    } else {
                                                        let _e2292 = atomicAdd((&global_8.member[(_e2280 + 1u)]), _e2287);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e826) + _e1989)] = _e2114;
                                            }
                                        }
                                        if _e2051 {
                                            if _e205 {
                                                let _e2298 = bitcast<u32>(_e2115);
                                                let _e2301 = ((_e2298 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2301 == 0u) {
                                                } else {
                                                    let _e2304 = (_e2301 % 16u);
                                                    let _e2306 = ((_e2298 & 8388607u) | 8388608u);
                                                    let _e2309 = (_e2306 << bitcast<u32>((_e2304 & 31u)));
                                                    let _e2315 = ((_e2306 >> bitcast<u32>(((31u - _e2304) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2298 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2426_ = array<u32, 2>(_e2309, _e2315);
                                                    } else {
                                                        let _e2321 = (~(_e2309) + 1u);
                                                        if (_e2321 == 0u) {
                                                            phi_2424_ = (~(_e2315) + 1u);
                                                        } else {
                                                            phi_2424_ = ~(_e2315);
                                                        }
                                                        let _e2327 = phi_2424_;
                                                        phi_2426_ = array<u32, 2>(_e2321, _e2327);
                                                    }
                                                    let _e2330 = phi_2426_;
                                                    let _e2331 = (_e2301 < 255u);
                                                    if _e2331 {
                                                        phi_2432_ = _e2330;
                                                    } else {
                                                        phi_2432_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2334 = phi_2432_;
                                                    let _e2339 = (2u * ((select(16u, (_e2301 / 16u), _e2331) * _e196) + (_e826 + _e2050)));
                                                    let _e2342 = atomicAdd((&global_8.member[_e2339]), _e2334[0]);
                                                    let _e2346 = (_e2334[1] + select(0u, 1u, ((_e2342 + _e2334[0]) < _e2334[0])));
                                                    if (_e2346 == 0u) {
                                                    } else {
                                                        let _e2351 = atomicAdd((&global_8.member[(_e2339 + 1u)]), _e2346);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e826) + _e2050)] = _e2115;
                                            }
                                        }
                                    }
                                    if (_e846 < _e48) {
                                        let _e2353 = (_e1841.member + 0f);
                                        let _e2354 = (_e1844.member_1 + 0f);
                                        let _e2355 = (_e1847.member_2 + 0f);
                                        let _e2356 = (_e1850.member_3 + 0f);
                                        if _e1868 {
                                            if _e205 {
                                                let _e2362 = bitcast<u32>(_e2353);
                                                let _e2365 = ((_e2362 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2365 == 0u) {
                                                } else {
                                                    let _e2368 = (_e2365 % 16u);
                                                    let _e2370 = ((_e2362 & 8388607u) | 8388608u);
                                                    let _e2373 = (_e2370 << bitcast<u32>((_e2368 & 31u)));
                                                    let _e2379 = ((_e2370 >> bitcast<u32>(((31u - _e2368) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2362 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2504_ = array<u32, 2>(_e2373, _e2379);
                                                    } else {
                                                        let _e2385 = (~(_e2373) + 1u);
                                                        if (_e2385 == 0u) {
                                                            phi_2502_ = (~(_e2379) + 1u);
                                                        } else {
                                                            phi_2502_ = ~(_e2379);
                                                        }
                                                        let _e2391 = phi_2502_;
                                                        phi_2504_ = array<u32, 2>(_e2385, _e2391);
                                                    }
                                                    let _e2394 = phi_2504_;
                                                    let _e2395 = (_e2365 < 255u);
                                                    if _e2395 {
                                                        phi_2510_ = _e2394;
                                                    } else {
                                                        phi_2510_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2398 = phi_2510_;
                                                    let _e2403 = (2u * ((select(16u, (_e2365 / 16u), _e2395) * _e196) + (_e831 + _e217)));
                                                    let _e2406 = atomicAdd((&global_8.member[_e2403]), _e2398[0]);
                                                    let _e2410 = (_e2398[1] + select(0u, 1u, ((_e2406 + _e2398[0]) < _e2398[0])));
                                                    if (_e2410 == 0u) {
                                                    } else {
                                                        let _e2415 = atomicAdd((&global_8.member[(_e2403 + 1u)]), _e2410);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e831) + _e217)] = _e2353;
                                            }
                                        }
                                        if _e1929 {
                                            if _e205 {
                                                let _e2421 = bitcast<u32>(_e2354);
                                                let _e2424 = ((_e2421 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2424 == 0u) {
                                                } else {
                                                    let _e2427 = (_e2424 % 16u);
                                                    let _e2429 = ((_e2421 & 8388607u) | 8388608u);
                                                    let _e2432 = (_e2429 << bitcast<u32>((_e2427 & 31u)));
                                                    let _e2438 = ((_e2429 >> bitcast<u32>(((31u - _e2427) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2421 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2574_ = array<u32, 2>(_e2432, _e2438);
                                                    } else {
                                                        let _e2444 = (~(_e2432) + 1u);
                                                        if (_e2444 == 0u) {
                                                            phi_2572_ = (~(_e2438) + 1u);
                                                        } else {
                                                            phi_2572_ = ~(_e2438);
                                                        }
                                                        let _e2450 = phi_2572_;
                                                        phi_2574_ = array<u32, 2>(_e2444, _e2450);
                                                    }
                                                    let _e2453 = phi_2574_;
                                                    let _e2454 = (_e2424 < 255u);
                                                    if _e2454 {
                                                        phi_2580_ = _e2453;
                                                    } else {
                                                        phi_2580_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2457 = phi_2580_;
                                                    let _e2462 = (2u * ((select(16u, (_e2424 / 16u), _e2454) * _e196) + (_e831 + _e1928)));
                                                    let _e2465 = atomicAdd((&global_8.member[_e2462]), _e2457[0]);
                                                    let _e2469 = (_e2457[1] + select(0u, 1u, ((_e2465 + _e2457[0]) < _e2457[0])));
                                                    if (_e2469 == 0u) {
                                                    } else {
                                                        let _e2474 = atomicAdd((&global_8.member[(_e2462 + 1u)]), _e2469);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e831) + _e1928)] = _e2354;
                                            }
                                        }
                                        if _e1990 {
                                            if _e205 {
                                                let _e2480 = bitcast<u32>(_e2355);
                                                let _e2483 = ((_e2480 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2483 == 0u) {
                                                } else {
                                                    let _e2486 = (_e2483 % 16u);
                                                    let _e2488 = ((_e2480 & 8388607u) | 8388608u);
                                                    let _e2491 = (_e2488 << bitcast<u32>((_e2486 & 31u)));
                                                    let _e2497 = ((_e2488 >> bitcast<u32>(((31u - _e2486) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2480 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2644_ = array<u32, 2>(_e2491, _e2497);
                                                    } else {
                                                        let _e2503 = (~(_e2491) + 1u);
                                                        if (_e2503 == 0u) {
                                                            phi_2642_ = (~(_e2497) + 1u);
                                                        } else {
                                                            phi_2642_ = ~(_e2497);
                                                        }
                                                        let _e2509 = phi_2642_;
                                                        phi_2644_ = array<u32, 2>(_e2503, _e2509);
                                                    }
                                                    let _e2512 = phi_2644_;
                                                    let _e2513 = (_e2483 < 255u);
                                                    if _e2513 {
                                                        phi_2650_ = _e2512;
                                                    } else {
                                                        phi_2650_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2516 = phi_2650_;
                                                    let _e2521 = (2u * ((select(16u, (_e2483 / 16u), _e2513) * _e196) + (_e831 + _e1989)));
                                                    let _e2524 = atomicAdd((&global_8.member[_e2521]), _e2516[0]);
                                                    let _e2528 = (_e2516[1] + select(0u, 1u, ((_e2524 + _e2516[0]) < _e2516[0])));
                                                    if (_e2528 == 0u) {
                                                    } else {
                                                        let _e2533 = atomicAdd((&global_8.member[(_e2521 + 1u)]), _e2528);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e831) + _e1989)] = _e2355;
                                            }
                                        }
                                        if _e2051 {
                                            if _e205 {
                                                let _e2539 = bitcast<u32>(_e2356);
                                                let _e2542 = ((_e2539 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2542 == 0u) {
                                                } else {
                                                    let _e2545 = (_e2542 % 16u);
                                                    let _e2547 = ((_e2539 & 8388607u) | 8388608u);
                                                    let _e2550 = (_e2547 << bitcast<u32>((_e2545 & 31u)));
                                                    let _e2556 = ((_e2547 >> bitcast<u32>(((31u - _e2545) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2539 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2714_ = array<u32, 2>(_e2550, _e2556);
                                                    } else {
                                                        let _e2562 = (~(_e2550) + 1u);
                                                        if (_e2562 == 0u) {
                                                            phi_2712_ = (~(_e2556) + 1u);
                                                        } else {
                                                            phi_2712_ = ~(_e2556);
                                                        }
                                                        let _e2568 = phi_2712_;
                                                        phi_2714_ = array<u32, 2>(_e2562, _e2568);
                                                    }
                                                    let _e2571 = phi_2714_;
                                                    let _e2572 = (_e2542 < 255u);
                                                    if _e2572 {
                                                        phi_2720_ = _e2571;
                                                    } else {
                                                        phi_2720_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2575 = phi_2720_;
                                                    let _e2580 = (2u * ((select(16u, (_e2542 / 16u), _e2572) * _e196) + (_e831 + _e2050)));
                                                    let _e2583 = atomicAdd((&global_8.member[_e2580]), _e2575[0]);
                                                    let _e2587 = (_e2575[1] + select(0u, 1u, ((_e2583 + _e2575[0]) < _e2575[0])));
                                                    if (_e2587 == 0u) {
                                                    } else {
                                                        let _e2592 = atomicAdd((&global_8.member[(_e2580 + 1u)]), _e2587);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e831) + _e2050)] = _e2356;
                                            }
                                        }
                                    }
                                    if (_e850 < _e48) {
                                        let _e2594 = (_e1853.member + 0f);
                                        let _e2595 = (_e1856.member_1 + 0f);
                                        let _e2596 = (_e1859.member_2 + 0f);
                                        let _e2597 = (_e1862.member_3 + 0f);
                                        if _e1868 {
                                            if _e205 {
                                                let _e2603 = bitcast<u32>(_e2594);
                                                let _e2606 = ((_e2603 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2606 == 0u) {
                                                } else {
                                                    let _e2609 = (_e2606 % 16u);
                                                    let _e2611 = ((_e2603 & 8388607u) | 8388608u);
                                                    let _e2614 = (_e2611 << bitcast<u32>((_e2609 & 31u)));
                                                    let _e2620 = ((_e2611 >> bitcast<u32>(((31u - _e2609) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2603 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2792_ = array<u32, 2>(_e2614, _e2620);
                                                    } else {
                                                        let _e2626 = (~(_e2614) + 1u);
                                                        if (_e2626 == 0u) {
                                                            phi_2790_ = (~(_e2620) + 1u);
                                                        } else {
                                                            phi_2790_ = ~(_e2620);
                                                        }
                                                        let _e2632 = phi_2790_;
                                                        phi_2792_ = array<u32, 2>(_e2626, _e2632);
                                                    }
                                                    let _e2635 = phi_2792_;
                                                    let _e2636 = (_e2606 < 255u);
                                                    if _e2636 {
                                                        phi_2798_ = _e2635;
                                                    } else {
                                                        phi_2798_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2639 = phi_2798_;
                                                    let _e2644 = (2u * ((select(16u, (_e2606 / 16u), _e2636) * _e196) + (_e836 + _e217)));
                                                    let _e2647 = atomicAdd((&global_8.member[_e2644]), _e2639[0]);
                                                    let _e2651 = (_e2639[1] + select(0u, 1u, ((_e2647 + _e2639[0]) < _e2639[0])));
                                                    if (_e2651 == 0u) {
                                                    } else {
                                                        let _e2656 = atomicAdd((&global_8.member[(_e2644 + 1u)]), _e2651);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e836) + _e217)] = _e2594;
                                            }
                                        }
                                        if _e1929 {
                                            if _e205 {
                                                let _e2662 = bitcast<u32>(_e2595);
                                                let _e2665 = ((_e2662 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2665 == 0u) {
                                                } else {
                                                    let _e2668 = (_e2665 % 16u);
                                                    let _e2670 = ((_e2662 & 8388607u) | 8388608u);
                                                    let _e2673 = (_e2670 << bitcast<u32>((_e2668 & 31u)));
                                                    let _e2679 = ((_e2670 >> bitcast<u32>(((31u - _e2668) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2662 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2862_ = array<u32, 2>(_e2673, _e2679);
                                                    } else {
                                                        let _e2685 = (~(_e2673) + 1u);
                                                        if (_e2685 == 0u) {
                                                            phi_2860_ = (~(_e2679) + 1u);
                                                        } else {
                                                            phi_2860_ = ~(_e2679);
                                                        }
                                                        let _e2691 = phi_2860_;
                                                        phi_2862_ = array<u32, 2>(_e2685, _e2691);
                                                    }
                                                    let _e2694 = phi_2862_;
                                                    let _e2695 = (_e2665 < 255u);
                                                    if _e2695 {
                                                        phi_2868_ = _e2694;
                                                    } else {
                                                        phi_2868_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2698 = phi_2868_;
                                                    let _e2703 = (2u * ((select(16u, (_e2665 / 16u), _e2695) * _e196) + (_e836 + _e1928)));
                                                    let _e2706 = atomicAdd((&global_8.member[_e2703]), _e2698[0]);
                                                    let _e2710 = (_e2698[1] + select(0u, 1u, ((_e2706 + _e2698[0]) < _e2698[0])));
                                                    if (_e2710 == 0u) {
                                                    } else {
                                                        let _e2715 = atomicAdd((&global_8.member[(_e2703 + 1u)]), _e2710);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e836) + _e1928)] = _e2595;
                                            }
                                        }
                                        if _e1990 {
                                            if _e205 {
                                                let _e2721 = bitcast<u32>(_e2596);
                                                let _e2724 = ((_e2721 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2724 == 0u) {
                                                } else {
                                                    let _e2727 = (_e2724 % 16u);
                                                    let _e2729 = ((_e2721 & 8388607u) | 8388608u);
                                                    let _e2732 = (_e2729 << bitcast<u32>((_e2727 & 31u)));
                                                    let _e2738 = ((_e2729 >> bitcast<u32>(((31u - _e2727) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2721 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_2932_ = array<u32, 2>(_e2732, _e2738);
                                                    } else {
                                                        let _e2744 = (~(_e2732) + 1u);
                                                        if (_e2744 == 0u) {
                                                            phi_2930_ = (~(_e2738) + 1u);
                                                        } else {
                                                            phi_2930_ = ~(_e2738);
                                                        }
                                                        let _e2750 = phi_2930_;
                                                        phi_2932_ = array<u32, 2>(_e2744, _e2750);
                                                    }
                                                    let _e2753 = phi_2932_;
                                                    let _e2754 = (_e2724 < 255u);
                                                    if _e2754 {
                                                        phi_2938_ = _e2753;
                                                    } else {
                                                        phi_2938_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2757 = phi_2938_;
                                                    let _e2762 = (2u * ((select(16u, (_e2724 / 16u), _e2754) * _e196) + (_e836 + _e1989)));
                                                    let _e2765 = atomicAdd((&global_8.member[_e2762]), _e2757[0]);
                                                    let _e2769 = (_e2757[1] + select(0u, 1u, ((_e2765 + _e2757[0]) < _e2757[0])));
                                                    if (_e2769 == 0u) {
                                                    } else {
                                                        let _e2774 = atomicAdd((&global_8.member[(_e2762 + 1u)]), _e2769);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e836) + _e1989)] = _e2596;
                                            }
                                        }
                                        if _e2051 {
                                            if _e205 {
                                                let _e2780 = bitcast<u32>(_e2597);
                                                let _e2783 = ((_e2780 >> bitcast<u32>(23i)) & 255u);
                                                if (_e2783 == 0u) {
                                                } else {
                                                    let _e2786 = (_e2783 % 16u);
                                                    let _e2788 = ((_e2780 & 8388607u) | 8388608u);
                                                    let _e2791 = (_e2788 << bitcast<u32>((_e2786 & 31u)));
                                                    let _e2797 = ((_e2788 >> bitcast<u32>(((31u - _e2786) & 31u))) >> bitcast<u32>(1i));
                                                    if ((_e2780 >> bitcast<u32>(31i)) == 0u) {
                                                        phi_3002_ = array<u32, 2>(_e2791, _e2797);
                                                    } else {
                                                        let _e2803 = (~(_e2791) + 1u);
                                                        if (_e2803 == 0u) {
                                                            phi_3000_ = (~(_e2797) + 1u);
                                                        } else {
                                                            phi_3000_ = ~(_e2797);
                                                        }
                                                        let _e2809 = phi_3000_;
                                                        phi_3002_ = array<u32, 2>(_e2803, _e2809);
                                                    }
                                                    let _e2812 = phi_3002_;
                                                    let _e2813 = (_e2783 < 255u);
                                                    if _e2813 {
                                                        phi_3008_ = _e2812;
                                                    } else {
                                                        phi_3008_ = array<u32, 2>(1u, 0u);
                                                    }
                                                    let _e2816 = phi_3008_;
                                                    let _e2821 = (2u * ((select(16u, (_e2783 / 16u), _e2813) * _e196) + (_e836 + _e2050)));
                                                    let _e2824 = atomicAdd((&global_8.member[_e2821]), _e2816[0]);
                                                    let _e2828 = (_e2816[1] + select(0u, 1u, ((_e2824 + _e2816[0]) < _e2816[0])));
                                                    if (_e2828 == 0u) {
                                                    } else {
                                                        let _e2833 = atomicAdd((&global_8.member[(_e2821 + 1u)]), _e2828);
                                                    }
                                                }
                                            } else {
                                                global_6.member[((_e211 + _e836) + _e2050)] = _e2597;
                                            }
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
                                            let _e2882 = local_28;
                                            phi_316_ = _e2882;
                                            let _e2885 = local_29;
                                            phi_319_ = _e2885;
                                        }
                                    }
                                    let _e2889 = local_30;
                                    phi_423_ = _e2889;
                                    let _e2894 = local_32;
                                    phi_426_ = _e2894;
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
                                            let _e2891 = local_31;
                                            phi_423_ = _e2891;
                                            let _e2896 = local_33;
                                            phi_426_ = _e2896;
                                        }
                                    }
                                    let _e2899 = local_34;
                                    phi_493_ = _e2899;
                                    let _e2904 = local_36;
                                    phi_496_ = _e2904;
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
                                            let _e2901 = local_35;
                                            phi_493_ = _e2901;
                                            let _e2906 = local_37;
                                            phi_496_ = _e2906;
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
                                    if (_e217 < _e84) {
                                        if _e205 {
                                            let _e577 = bitcast<u32>(_e567);
                                            let _e580 = ((_e577 >> bitcast<u32>(23i)) & 255u);
                                            if (_e580 == 0u) {
                                            } else {
                                                let _e583 = (_e580 % 16u);
                                                let _e585 = ((_e577 & 8388607u) | 8388608u);
                                                let _e588 = (_e585 << bitcast<u32>((_e583 & 31u)));
                                                let _e594 = ((_e585 >> bitcast<u32>(((31u - _e583) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e577 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_652_ = array<u32, 2>(_e588, _e594);
                                                } else {
                                                    let _e600 = (~(_e588) + 1u);
                                                    if (_e600 == 0u) {
                                                        phi_650_ = (~(_e594) + 1u);
                                                    } else {
                                                        phi_650_ = ~(_e594);
                                                    }
                                                    let _e606 = phi_650_;
                                                    phi_652_ = array<u32, 2>(_e600, _e606);
                                                }
                                                let _e609 = phi_652_;
                                                let _e610 = (_e580 < 255u);
                                                if _e610 {
                                                    phi_658_ = _e609;
                                                } else {
                                                    phi_658_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e613 = phi_658_;
                                                let _e618 = (2u * ((select(16u, (_e580 / 16u), _e610) * _e196) + (_e223 + _e217)));
                                                let _e621 = atomicAdd((&global_8.member[_e618]), _e613[0]);
                                                let _e625 = (_e613[1] + select(0u, 1u, ((_e621 + _e613[0]) < _e613[0])));
                                                if (_e625 == 0u) {
                                                } else {
                                                    let _e630 = atomicAdd((&global_8.member[(_e618 + 1u)]), _e625);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e223) + _e217)] = _e567;
                                        }
                                    }
                                    let _e631 = (_e217 + 1u);
                                    if (_e631 < _e84) {
                                        if _e205 {
                                            let _e638 = bitcast<u32>(_e568);
                                            let _e641 = ((_e638 >> bitcast<u32>(23i)) & 255u);
                                            if (_e641 == 0u) {
                                            } else {
                                                let _e644 = (_e641 % 16u);
                                                let _e646 = ((_e638 & 8388607u) | 8388608u);
                                                let _e649 = (_e646 << bitcast<u32>((_e644 & 31u)));
                                                let _e655 = ((_e646 >> bitcast<u32>(((31u - _e644) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e638 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_724_ = array<u32, 2>(_e649, _e655);
                                                } else {
                                                    let _e661 = (~(_e649) + 1u);
                                                    if (_e661 == 0u) {
                                                        phi_722_ = (~(_e655) + 1u);
                                                    } else {
                                                        phi_722_ = ~(_e655);
                                                    }
                                                    let _e667 = phi_722_;
                                                    phi_724_ = array<u32, 2>(_e661, _e667);
                                                }
                                                let _e670 = phi_724_;
                                                let _e671 = (_e641 < 255u);
                                                if _e671 {
                                                    phi_730_ = _e670;
                                                } else {
                                                    phi_730_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e674 = phi_730_;
                                                let _e679 = (2u * ((select(16u, (_e641 / 16u), _e671) * _e196) + (_e223 + _e631)));
                                                let _e682 = atomicAdd((&global_8.member[_e679]), _e674[0]);
                                                let _e686 = (_e674[1] + select(0u, 1u, ((_e682 + _e674[0]) < _e674[0])));
                                                if (_e686 == 0u) {
                                                } else {
                                                    let _e691 = atomicAdd((&global_8.member[(_e679 + 1u)]), _e686);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e223) + _e631)] = _e568;
                                        }
                                    }
                                    let _e692 = (_e217 + 2u);
                                    if (_e692 < _e84) {
                                        if _e205 {
                                            let _e699 = bitcast<u32>(_e569);
                                            let _e702 = ((_e699 >> bitcast<u32>(23i)) & 255u);
                                            if (_e702 == 0u) {
                                            } else {
                                                let _e705 = (_e702 % 16u);
                                                let _e707 = ((_e699 & 8388607u) | 8388608u);
                                                let _e710 = (_e707 << bitcast<u32>((_e705 & 31u)));
                                                let _e716 = ((_e707 >> bitcast<u32>(((31u - _e705) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e699 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_796_ = array<u32, 2>(_e710, _e716);
                                                } else {
                                                    let _e722 = (~(_e710) + 1u);
                                                    if (_e722 == 0u) {
                                                        phi_794_ = (~(_e716) + 1u);
                                                    } else {
                                                        phi_794_ = ~(_e716);
                                                    }
                                                    let _e728 = phi_794_;
                                                    phi_796_ = array<u32, 2>(_e722, _e728);
                                                }
                                                let _e731 = phi_796_;
                                                let _e732 = (_e702 < 255u);
                                                if _e732 {
                                                    phi_802_ = _e731;
                                                } else {
                                                    phi_802_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e735 = phi_802_;
                                                let _e740 = (2u * ((select(16u, (_e702 / 16u), _e732) * _e196) + (_e223 + _e692)));
                                                let _e743 = atomicAdd((&global_8.member[_e740]), _e735[0]);
                                                let _e747 = (_e735[1] + select(0u, 1u, ((_e743 + _e735[0]) < _e735[0])));
                                                if (_e747 == 0u) {
                                                } else {
                                                    let _e752 = atomicAdd((&global_8.member[(_e740 + 1u)]), _e747);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e223) + _e692)] = _e569;
                                        }
                                    }
                                    let _e753 = (_e217 + 3u);
                                    if (_e753 < _e84) {
                                        if _e205 {
                                            let _e760 = bitcast<u32>(_e570);
                                            let _e763 = ((_e760 >> bitcast<u32>(23i)) & 255u);
                                            if (_e763 == 0u) {
                                            } else {
                                                let _e766 = (_e763 % 16u);
                                                let _e768 = ((_e760 & 8388607u) | 8388608u);
                                                let _e771 = (_e768 << bitcast<u32>((_e766 & 31u)));
                                                let _e777 = ((_e768 >> bitcast<u32>(((31u - _e766) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e760 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_868_ = array<u32, 2>(_e771, _e777);
                                                } else {
                                                    let _e783 = (~(_e771) + 1u);
                                                    if (_e783 == 0u) {
                                                        phi_866_ = (~(_e777) + 1u);
                                                    } else {
                                                        phi_866_ = ~(_e777);
                                                    }
                                                    let _e789 = phi_866_;
                                                    phi_868_ = array<u32, 2>(_e783, _e789);
                                                }
                                                let _e792 = phi_868_;
                                                let _e793 = (_e763 < 255u);
                                                if _e793 {
                                                    phi_874_ = _e792;
                                                } else {
                                                    phi_874_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e796 = phi_874_;
                                                let _e801 = (2u * ((select(16u, (_e763 / 16u), _e793) * _e196) + (_e223 + _e753)));
                                                let _e804 = atomicAdd((&global_8.member[_e801]), _e796[0]);
                                                let _e808 = (_e796[1] + select(0u, 1u, ((_e804 + _e796[0]) < _e796[0])));
                                                if (_e808 == 0u) {
                                                } else {
                                                    let _e813 = atomicAdd((&global_8.member[(_e801 + 1u)]), _e808);
                                                }
                                            }
                                        } else {
                                            global_6.member[((_e211 + _e223) + _e753)] = _e570;
                                        }
                                    }
                                }
                                phi_231_ = _e183;
                                phi_234_ = _e192;
                                phi_236_ = _e187;
                            }
                            let _e2846 = phi_231_;
                            let _e2848 = phi_234_;
                            let _e2850 = phi_236_;
                            local_24 = _e2846;
                            local_25 = _e2848;
                            local_27 = _e2850;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2869 = local_24;
                            phi_230_ = _e2869;
                            let _e2872 = local_25;
                            phi_233_ = _e2872;
                            let _e2877 = local_27;
                            phi_235_ = _e2877;
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
