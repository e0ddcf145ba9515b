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

struct type_17 {
    member: array<vec4<f32>>,
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

struct type_24 {
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
var<storage, read_write> global_6: type_17;
@group(0) @binding(4) 
var<storage> global_7: type_17;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_24;
@group(0) @binding(3) 
var<storage> global_9: type_17;

fn function_() {
    var phi_118_: array<u32, 2>;
    var phi_142_: u32;
    var phi_145_: u32;
    var phi_166_: u32;
    var local: u32;
    var phi_181_: u32;
    var local_1: u32;
    var phi_190_: u32;
    var phi_208_: u32;
    var phi_209_: u32;
    var phi_210_: bool;
    var phi_215_: u32;
    var phi_217_: u32;
    var phi_220_: u32;
    var phi_222_: u32;
    var phi_240_: u32;
    var phi_271_: vec4<f32>;
    var phi_280_: type_20;
    var phi_283_: type_19;
    var phi_299_: bool;
    var phi_387_: type_20;
    var phi_390_: type_19;
    var phi_457_: type_20;
    var phi_460_: type_19;
    var phi_476_: bool;
    var local_2: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var phi_607_: u32;
    var phi_609_: array<u32, 2>;
    var phi_615_: array<u32, 2>;
    var phi_668_: u32;
    var phi_670_: array<u32, 2>;
    var phi_676_: array<u32, 2>;
    var phi_729_: u32;
    var phi_731_: array<u32, 2>;
    var phi_737_: array<u32, 2>;
    var phi_790_: u32;
    var phi_792_: array<u32, 2>;
    var phi_798_: array<u32, 2>;
    var phi_859_: vec4<f32>;
    var phi_870_: vec4<f32>;
    var phi_881_: vec4<f32>;
    var phi_892_: vec4<f32>;
    var phi_907_: type_19;
    var phi_910_: type_19;
    var phi_912_: type_19;
    var phi_914_: type_19;
    var phi_916_: type_20;
    var phi_932_: bool;
    var phi_1186_: type_19;
    var phi_1189_: type_19;
    var phi_1191_: type_19;
    var phi_1193_: type_19;
    var phi_1195_: type_20;
    var phi_1412_: type_19;
    var phi_1415_: type_19;
    var phi_1417_: type_19;
    var phi_1419_: type_19;
    var phi_1421_: type_20;
    var phi_1437_: bool;
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
    var phi_1746_: u32;
    var phi_1748_: array<u32, 2>;
    var phi_1754_: array<u32, 2>;
    var phi_1807_: u32;
    var phi_1809_: array<u32, 2>;
    var phi_1815_: array<u32, 2>;
    var phi_1868_: u32;
    var phi_1870_: array<u32, 2>;
    var phi_1876_: array<u32, 2>;
    var phi_1929_: u32;
    var phi_1931_: array<u32, 2>;
    var phi_1937_: array<u32, 2>;
    var phi_2001_: u32;
    var phi_2003_: array<u32, 2>;
    var phi_2009_: array<u32, 2>;
    var phi_2062_: u32;
    var phi_2064_: array<u32, 2>;
    var phi_2070_: array<u32, 2>;
    var phi_2123_: u32;
    var phi_2125_: array<u32, 2>;
    var phi_2131_: array<u32, 2>;
    var phi_2184_: u32;
    var phi_2186_: array<u32, 2>;
    var phi_2192_: array<u32, 2>;
    var phi_2256_: u32;
    var phi_2258_: array<u32, 2>;
    var phi_2264_: array<u32, 2>;
    var phi_2317_: u32;
    var phi_2319_: array<u32, 2>;
    var phi_2325_: array<u32, 2>;
    var phi_2378_: u32;
    var phi_2380_: array<u32, 2>;
    var phi_2386_: array<u32, 2>;
    var phi_2439_: u32;
    var phi_2441_: array<u32, 2>;
    var phi_2447_: array<u32, 2>;
    var phi_2511_: u32;
    var phi_2513_: array<u32, 2>;
    var phi_2519_: array<u32, 2>;
    var phi_2572_: u32;
    var phi_2574_: array<u32, 2>;
    var phi_2580_: array<u32, 2>;
    var phi_2633_: u32;
    var phi_2635_: array<u32, 2>;
    var phi_2641_: array<u32, 2>;
    var phi_2694_: u32;
    var phi_2696_: array<u32, 2>;
    var phi_2702_: array<u32, 2>;
    var phi_2732_: u32;
    var phi_218_: u32;
    var phi_221_: u32;
    var phi_223_: u32;
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
            let _e50 = (((_e41.x + (_e41.y * _e42.x)) * 64u) + _e40.x);
            let _e53 = global_3.member.member_4;
            let _e56 = global_3.member.member_10;
            let _e59 = global_3.member.member_3;
            let _e60 = (_e59 - 1u);
            let _e62 = ((_e60 / 4u) + 1u);
            if ((_e53 % 8u) == 0u) {
                let _e69 = (4u * _e53);
                let _e70 = (_e69 == 0u);
                if _e70 {
                    break;
                }
                if _e70 {
                    break;
                }
                let _e72 = (_e50 % _e69);
                phi_118_ = array<u32, 2>(((4u * (_e50 / _e69)) + ((_e72 / 8u) % 4u)), (((_e72 / 32u) * 8u) + (_e72 % 8u)));
            } else {
                let _e65 = (_e53 == 0u);
                if _e65 {
                    break;
                }
                if _e65 {
                    break;
                }
                phi_118_ = array<u32, 2>((_e50 / _e53), (_e50 % _e53));
            }
            let _e83 = phi_118_;
            let _e86 = global_3.member.member_1;
            let _e89 = global_3.member.member;
            let _e90 = (_e86 + _e89);
            let _e93 = (_e86 + (_e41.z * _e56));
            if (_e83[0] <= _e62) {
                if (_e93 < _e90) {
                    let _e97 = (_e93 + _e56);
                    let _e102 = global_3.member.member_7;
                    phi_142_ = _e102;
                    phi_145_ = 0u;
                    loop {
                        let _e104 = phi_142_;
                        let _e106 = phi_145_;
                        let _e107 = (_e106 + 1u);
                        local = _e106;
                        local_1 = _e107;
                        local_26 = _e106;
                        if (_e107 < _e104) {
                            let _e110 = ((_e106 + _e104) / 2u);
                            let _e113 = global_3.member.member_8;
                            let _e117 = global_4.member[(_e110 * _e113)];
                            let _e120 = global_3.member.member_9;
                            if (_e120 == 0u) {
                                phi_166_ = _e117;
                            } else {
                                let _e124 = global_5.member[_e117];
                                phi_166_ = _e124;
                            }
                            let _e126 = phi_166_;
                            let _e127 = (_e126 <= _e93);
                            local_22 = select(_e110, _e104, _e127);
                            local_23 = select(_e106, _e110, _e127);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2631 = local_22;
                            phi_142_ = _e2631;
                            let _e2634 = local_23;
                            phi_145_ = _e2634;
                        }
                    }
                    let _e132 = global_3.member.member_8;
                    let _e134 = local;
                    let _e138 = global_4.member[(_e134 * _e132)];
                    let _e141 = global_3.member.member_9;
                    let _e142 = (_e141 == 0u);
                    if _e142 {
                        phi_181_ = _e138;
                    } else {
                        let _e145 = global_5.member[_e138];
                        phi_181_ = _e145;
                    }
                    let _e147 = phi_181_;
                    let _e149 = local_1;
                    let _e153 = global_4.member[(_e149 * _e132)];
                    if _e142 {
                        phi_190_ = _e153;
                    } else {
                        let _e156 = global_5.member[_e153];
                        phi_190_ = _e156;
                    }
                    let _e158 = phi_190_;
                    if (_e56 == 0u) {
                        break;
                    }
                    let _e161 = ((_e93 - _e147) % _e56);
                    if (_e41.z == 0u) {
                        phi_209_ = u32();
                        phi_210_ = true;
                    } else {
                        let _e163 = (_e161 == 0u);
                        if _e163 {
                            phi_208_ = u32();
                        } else {
                            let _e165 = ((_e93 - _e161) + _e56);
                            phi_208_ = select(_e158, _e165, (_e165 < _e158));
                        }
                        let _e169 = phi_208_;
                        phi_209_ = _e169;
                        phi_210_ = _e163;
                    }
                    let _e171 = phi_209_;
                    let _e173 = phi_210_;
                    if _e173 {
                        phi_215_ = (_e93 - _e161);
                    } else {
                        phi_215_ = _e171;
                    }
                    let _e176 = phi_215_;
                    phi_217_ = _e158;
                    phi_220_ = _e176;
                    let _e2652 = local_26;
                    phi_222_ = _e2652;
                    loop {
                        let _e178 = phi_217_;
                        let _e180 = phi_220_;
                        let _e182 = phi_222_;
                        if (_e180 < select(_e90, _e97, (_e97 < _e90))) {
                            if (_e180 == _e178) {
                                let _e2616 = global_4.member[((_e182 + 2u) * _e132)];
                                if _e142 {
                                    phi_2732_ = _e2616;
                                } else {
                                    let _e2619 = global_5.member[_e2616];
                                    phi_2732_ = _e2619;
                                }
                                let _e2621 = phi_2732_;
                                phi_218_ = _e2621;
                                phi_221_ = _e180;
                                phi_223_ = (_e182 + 1u);
                            } else {
                                let _e185 = (_e180 + _e56);
                                let _e187 = select(_e178, _e185, (_e185 < _e178));
                                if (_e180 > _e86) {
                                    phi_240_ = (_e180 - _e86);
                                } else {
                                    phi_240_ = 0u;
                                }
                                let _e192 = phi_240_;
                                let _e193 = (_e187 - _e86);
                                let _e195 = select(_e89, _e193, (_e193 < _e89));
                                let _e198 = global_3.member.member_12;
                                let _e201 = global_3.member.member_11;
                                let _e202 = (_e198 * _e201);
                                let _e204 = ((1u - _e198) * _e201);
                                let _e205 = (_e187 <= _e90);
                                let _e207 = select(false, true, (_e180 < _e86));
                                let _e210 = global_3.member.member_2;
                                let _e212 = ((4u * _e83[1]) * _e210);
                                if (_e83[0] < _e62) {
                                    let _e761 = (_e83[0] * 4u);
                                    let _e764 = global_3.member.member_5;
                                    let _e767 = ((_e764 + (_e761 * _e53)) + _e83[1]);
                                    let _e768 = (_e60 - _e761);
                                    let _e772 = (_e767 + (select(_e768, 1u, (1u < _e768)) * _e53));
                                    let _e776 = (_e767 + (select(_e768, 2u, (2u < _e768)) * _e53));
                                    let _e780 = (_e767 + (select(_e768, 3u, (3u < _e768)) * _e53));
                                    let _e786 = (_e761 + 1u);
                                    let _e790 = (_e761 + 2u);
                                    let _e794 = (_e761 + 3u);
                                    if _e207 {
                                        let _e800 = global_6.member[(_e202 + _e767)];
                                        phi_859_ = _e800;
                                    } else {
                                        phi_859_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e802 = phi_859_;
                                    if _e207 {
                                        let _e810 = global_6.member[(_e202 + _e772)];
                                        phi_870_ = _e810;
                                    } else {
                                        phi_870_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e812 = phi_870_;
                                    if _e207 {
                                        let _e820 = global_6.member[(_e202 + _e776)];
                                        phi_881_ = _e820;
                                    } else {
                                        phi_881_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e822 = phi_881_;
                                    if _e207 {
                                        let _e830 = global_6.member[(_e202 + _e780)];
                                        phi_892_ = _e830;
                                    } else {
                                        phi_892_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e832 = phi_892_;
                                    let _e840 = ((_e761 * _e210) / 4u);
                                    let _e841 = ((select(_e60, _e786, (_e786 < _e60)) * _e210) / 4u);
                                    let _e842 = ((select(_e60, _e790, (_e790 < _e60)) * _e210) / 4u);
                                    let _e843 = ((select(_e60, _e794, (_e794 < _e60)) * _e210) / 4u);
                                    let _e844 = (_e212 / 4u);
                                    let _e845 = (_e210 / 4u);
                                    phi_907_ = type_19(_e832.x, _e832.y, _e832.z, _e832.w);
                                    phi_910_ = type_19(_e822.x, _e822.y, _e822.z, _e822.w);
                                    phi_912_ = type_19(_e812.x, _e812.y, _e812.z, _e812.w);
                                    phi_914_ = type_19(_e802.x, _e802.y, _e802.z, _e802.w);
                                    phi_916_ = type_20((_e192 / 4u), _e192, _e195);
                                    loop {
                                        let _e847 = phi_907_;
                                        let _e849 = phi_910_;
                                        let _e851 = phi_912_;
                                        let _e853 = phi_914_;
                                        let _e855 = phi_916_;
                                        local_43 = _e847;
                                        local_45 = _e849;
                                        local_47 = _e851;
                                        local_49 = _e853;
                                        local_51 = _e855;
                                        let _e857 = (4u * _e855.member);
                                        if (_e857 < _e855.member_2) {
                                            phi_932_ = select(((_e857 + 4u) > _e855.member_2), true, (_e857 < _e855.member_1));
                                        } else {
                                            phi_932_ = false;
                                        }
                                        let _e866 = phi_932_;
                                        if _e866 {
                                            let _e870 = global_7.member[(_e844 + _e855.member)];
                                            let _e877 = (_e855.member_2 - _e855.member_1);
                                            let _e878 = ((_e857 - _e855.member_1) < _e877);
                                            let _e879 = select(0f, _e870.x, _e878);
                                            let _e882 = (((_e857 + 1u) - _e855.member_1) < _e877);
                                            let _e883 = select(0f, _e870.y, _e882);
                                            let _e886 = (((_e857 + 2u) - _e855.member_1) < _e877);
                                            let _e887 = select(0f, _e870.z, _e886);
                                            let _e890 = (((_e857 + 3u) - _e855.member_1) < _e877);
                                            let _e891 = select(0f, _e870.w, _e890);
                                            let _e896 = global_7.member[((_e844 + _e845) + _e855.member)];
                                            let _e901 = select(0f, _e896.x, _e878);
                                            let _e902 = select(0f, _e896.y, _e882);
                                            let _e903 = select(0f, _e896.z, _e886);
                                            let _e904 = select(0f, _e896.w, _e890);
                                            let _e910 = global_7.member[((_e844 + (2u * _e845)) + _e855.member)];
                                            let _e915 = select(0f, _e910.x, _e878);
                                            let _e916 = select(0f, _e910.y, _e882);
                                            let _e917 = select(0f, _e910.z, _e886);
                                            let _e918 = select(0f, _e910.w, _e890);
                                            let _e924 = global_7.member[((_e844 + (3u * _e845)) + _e855.member)];
                                            let _e929 = select(0f, _e924.x, _e878);
                                            let _e930 = select(0f, _e924.y, _e882);
                                            let _e931 = select(0f, _e924.z, _e886);
                                            let _e932 = select(0f, _e924.w, _e890);
                                            let _e936 = global_9.member[(_e840 + _e855.member)];
                                            let _e941 = select(0f, _e936.x, _e878);
                                            let _e942 = select(0f, _e936.y, _e882);
                                            let _e943 = select(0f, _e936.z, _e886);
                                            let _e944 = select(0f, _e936.w, _e890);
                                            let _e948 = global_9.member[(_e841 + _e855.member)];
                                            let _e953 = select(0f, _e948.x, _e878);
                                            let _e954 = select(0f, _e948.y, _e882);
                                            let _e955 = select(0f, _e948.z, _e886);
                                            let _e956 = select(0f, _e948.w, _e890);
                                            let _e960 = global_9.member[(_e842 + _e855.member)];
                                            let _e965 = select(0f, _e960.x, _e878);
                                            let _e966 = select(0f, _e960.y, _e882);
                                            let _e967 = select(0f, _e960.z, _e886);
                                            let _e968 = select(0f, _e960.w, _e890);
                                            let _e972 = global_9.member[(_e843 + _e855.member)];
                                            let _e977 = select(0f, _e972.x, _e878);
                                            let _e978 = select(0f, _e972.y, _e882);
                                            let _e979 = select(0f, _e972.z, _e886);
                                            let _e980 = select(0f, _e972.w, _e890);
                                            local_38 = type_19(((_e980 * _e891) + ((_e979 * _e887) + ((_e978 * _e883) + ((_e977 * _e879) + _e847.member)))), ((_e980 * _e904) + ((_e979 * _e903) + ((_e978 * _e902) + ((_e977 * _e901) + _e847.member_1)))), ((_e980 * _e918) + ((_e979 * _e917) + ((_e978 * _e916) + ((_e977 * _e915) + _e847.member_2)))), ((_e980 * _e932) + ((_e979 * _e931) + ((_e978 * _e930) + ((_e977 * _e929) + _e847.member_3)))));
                                            local_39 = type_19(((_e968 * _e891) + ((_e967 * _e887) + ((_e966 * _e883) + ((_e965 * _e879) + _e849.member)))), ((_e968 * _e904) + ((_e967 * _e903) + ((_e966 * _e902) + ((_e965 * _e901) + _e849.member_1)))), ((_e968 * _e918) + ((_e967 * _e917) + ((_e966 * _e916) + ((_e965 * _e915) + _e849.member_2)))), ((_e968 * _e932) + ((_e967 * _e931) + ((_e966 * _e930) + ((_e965 * _e929) + _e849.member_3)))));
                                            local_40 = type_19(((_e956 * _e891) + ((_e955 * _e887) + ((_e954 * _e883) + ((_e953 * _e879) + _e851.member)))), ((_e956 * _e904) + ((_e955 * _e903) + ((_e954 * _e902) + ((_e953 * _e901) + _e851.member_1)))), ((_e956 * _e918) + ((_e955 * _e917) + ((_e954 * _e916) + ((_e953 * _e915) + _e851.member_2)))), ((_e956 * _e932) + ((_e955 * _e931) + ((_e954 * _e930) + ((_e953 * _e929) + _e851.member_3)))));
                                            local_41 = type_19(((_e944 * _e891) + ((_e943 * _e887) + ((_e942 * _e883) + ((_e941 * _e879) + _e853.member)))), ((_e944 * _e904) + ((_e943 * _e903) + ((_e942 * _e902) + ((_e941 * _e901) + _e853.member_1)))), ((_e944 * _e918) + ((_e943 * _e917) + ((_e942 * _e916) + ((_e941 * _e915) + _e853.member_2)))), ((_e944 * _e932) + ((_e943 * _e931) + ((_e942 * _e930) + ((_e941 * _e929) + _e853.member_3)))));
                                            local_42 = type_20((_e855.member + 1u), _e855.member_1, _e855.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2707 = local_38;
                                            phi_907_ = _e2707;
                                            let _e2710 = local_39;
                                            phi_910_ = _e2710;
                                            let _e2713 = local_40;
                                            phi_912_ = _e2713;
                                            let _e2716 = local_41;
                                            phi_914_ = _e2716;
                                            let _e2719 = local_42;
                                            phi_916_ = _e2719;
                                        }
                                    }
                                    let _e2723 = local_43;
                                    phi_1186_ = _e2723;
                                    let _e2728 = local_45;
                                    phi_1189_ = _e2728;
                                    let _e2733 = local_47;
                                    phi_1191_ = _e2733;
                                    let _e2738 = local_49;
                                    phi_1193_ = _e2738;
                                    let _e2743 = local_51;
                                    phi_1195_ = _e2743;
                                    loop {
                                        let _e1135 = phi_1186_;
                                        let _e1137 = phi_1189_;
                                        let _e1139 = phi_1191_;
                                        let _e1141 = phi_1193_;
                                        let _e1143 = phi_1195_;
                                        local_53 = _e1135;
                                        local_55 = _e1137;
                                        local_57 = _e1139;
                                        local_59 = _e1141;
                                        local_61 = _e1143;
                                        if !((((4u * _e1143.member) + 4u) > _e1143.member_2)) {
                                            let _e1153 = global_7.member[(_e844 + _e1143.member)];
                                            let _e1162 = global_7.member[((_e844 + _e845) + _e1143.member)];
                                            let _e1172 = global_7.member[((_e844 + (2u * _e845)) + _e1143.member)];
                                            let _e1182 = global_7.member[((_e844 + (3u * _e845)) + _e1143.member)];
                                            let _e1190 = global_9.member[(_e840 + _e1143.member)];
                                            let _e1198 = global_9.member[(_e841 + _e1143.member)];
                                            let _e1206 = global_9.member[(_e842 + _e1143.member)];
                                            let _e1214 = global_9.member[(_e843 + _e1143.member)];
                                            local_44 = type_19(((_e1214.w * _e1153.w) + ((_e1214.z * _e1153.z) + ((_e1214.y * _e1153.y) + ((_e1214.x * _e1153.x) + _e1135.member)))), ((_e1214.w * _e1162.w) + ((_e1214.z * _e1162.z) + ((_e1214.y * _e1162.y) + ((_e1214.x * _e1162.x) + _e1135.member_1)))), ((_e1214.w * _e1172.w) + ((_e1214.z * _e1172.z) + ((_e1214.y * _e1172.y) + ((_e1214.x * _e1172.x) + _e1135.member_2)))), ((_e1214.w * _e1182.w) + ((_e1214.z * _e1182.z) + ((_e1214.y * _e1182.y) + ((_e1214.x * _e1182.x) + _e1135.member_3)))));
                                            local_46 = type_19(((_e1206.w * _e1153.w) + ((_e1206.z * _e1153.z) + ((_e1206.y * _e1153.y) + ((_e1206.x * _e1153.x) + _e1137.member)))), ((_e1206.w * _e1162.w) + ((_e1206.z * _e1162.z) + ((_e1206.y * _e1162.y) + ((_e1206.x * _e1162.x) + _e1137.member_1)))), ((_e1206.w * _e1172.w) + ((_e1206.z * _e1172.z) + ((_e1206.y * _e1172.y) + ((_e1206.x * _e1172.x) + _e1137.member_2)))), ((_e1206.w * _e1182.w) + ((_e1206.z * _e1182.z) + ((_e1206.y * _e1182.y) + ((_e1206.x * _e1182.x) + _e1137.member_3)))));
                                            local_48 = type_19(((_e1198.w * _e1153.w) + ((_e1198.z * _e1153.z) + ((_e1198.y * _e1153.y) + ((_e1198.x * _e1153.x) + _e1139.member)))), ((_e1198.w * _e1162.w) + ((_e1198.z * _e1162.z) + ((_e1198.y * _e1162.y) + ((_e1198.x * _e1162.x) + _e1139.member_1)))), ((_e1198.w * _e1172.w) + ((_e1198.z * _e1172.z) + ((_e1198.y * _e1172.y) + ((_e1198.x * _e1172.x) + _e1139.member_2)))), ((_e1198.w * _e1182.w) + ((_e1198.z * _e1182.z) + ((_e1198.y * _e1182.y) + ((_e1198.x * _e1182.x) + _e1139.member_3)))));
                                            local_50 = type_19(((_e1190.w * _e1153.w) + ((_e1190.z * _e1153.z) + ((_e1190.y * _e1153.y) + ((_e1190.x * _e1153.x) + _e1141.member)))), ((_e1190.w * _e1162.w) + ((_e1190.z * _e1162.z) + ((_e1190.y * _e1162.y) + ((_e1190.x * _e1162.x) + _e1141.member_1)))), ((_e1190.w * _e1172.w) + ((_e1190.z * _e1172.z) + ((_e1190.y * _e1172.y) + ((_e1190.x * _e1172.x) + _e1141.member_2)))), ((_e1190.w * _e1182.w) + ((_e1190.z * _e1182.z) + ((_e1190.y * _e1182.y) + ((_e1190.x * _e1182.x) + _e1141.member_3)))));
                                            local_52 = type_20((_e1143.member + 1u), _e1143.member_1, _e1143.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2725 = local_44;
                                            phi_1186_ = _e2725;
                                            let _e2730 = local_46;
                                            phi_1189_ = _e2730;
                                            let _e2735 = local_48;
                                            phi_1191_ = _e2735;
                                            let _e2740 = local_50;
                                            phi_1193_ = _e2740;
                                            let _e2745 = local_52;
                                            phi_1195_ = _e2745;
                                        }
                                    }
                                    let _e2748 = local_53;
                                    phi_1412_ = _e2748;
                                    let _e2753 = local_55;
                                    phi_1415_ = _e2753;
                                    let _e2758 = local_57;
                                    phi_1417_ = _e2758;
                                    let _e2763 = local_59;
                                    phi_1419_ = _e2763;
                                    let _e2768 = local_61;
                                    phi_1421_ = _e2768;
                                    loop {
                                        let _e1373 = phi_1412_;
                                        let _e1375 = phi_1415_;
                                        let _e1377 = phi_1417_;
                                        let _e1379 = phi_1419_;
                                        let _e1381 = phi_1421_;
                                        local_6 = _e1379;
                                        local_7 = _e1379;
                                        local_8 = _e1379;
                                        local_9 = _e1379;
                                        local_10 = _e1377;
                                        local_11 = _e1377;
                                        local_12 = _e1377;
                                        local_13 = _e1377;
                                        local_14 = _e1375;
                                        local_15 = _e1375;
                                        local_16 = _e1375;
                                        local_17 = _e1375;
                                        local_18 = _e1373;
                                        local_19 = _e1373;
                                        local_20 = _e1373;
                                        local_21 = _e1373;
                                        let _e1383 = (4u * _e1381.member);
                                        if (_e1383 < _e1381.member_2) {
                                            phi_1437_ = select(((_e1383 + 4u) > _e1381.member_2), true, (_e1383 < _e1381.member_1));
                                        } else {
                                            phi_1437_ = false;
                                        }
                                        let _e1392 = phi_1437_;
                                        if _e1392 {
                                            let _e1396 = global_7.member[(_e844 + _e1381.member)];
                                            let _e1403 = (_e1381.member_2 - _e1381.member_1);
                                            let _e1404 = ((_e1383 - _e1381.member_1) < _e1403);
                                            let _e1405 = select(0f, _e1396.x, _e1404);
                                            let _e1408 = (((_e1383 + 1u) - _e1381.member_1) < _e1403);
                                            let _e1409 = select(0f, _e1396.y, _e1408);
                                            let _e1412 = (((_e1383 + 2u) - _e1381.member_1) < _e1403);
                                            let _e1413 = select(0f, _e1396.z, _e1412);
                                            let _e1416 = (((_e1383 + 3u) - _e1381.member_1) < _e1403);
                                            let _e1417 = select(0f, _e1396.w, _e1416);
                                            let _e1422 = global_7.member[((_e844 + _e845) + _e1381.member)];
                                            let _e1427 = select(0f, _e1422.x, _e1404);
                                            let _e1428 = select(0f, _e1422.y, _e1408);
                                            let _e1429 = select(0f, _e1422.z, _e1412);
                                            let _e1430 = select(0f, _e1422.w, _e1416);
                                            let _e1436 = global_7.member[((_e844 + (2u * _e845)) + _e1381.member)];
                                            let _e1441 = select(0f, _e1436.x, _e1404);
                                            let _e1442 = select(0f, _e1436.y, _e1408);
                                            let _e1443 = select(0f, _e1436.z, _e1412);
                                            let _e1444 = select(0f, _e1436.w, _e1416);
                                            let _e1450 = global_7.member[((_e844 + (3u * _e845)) + _e1381.member)];
                                            let _e1455 = select(0f, _e1450.x, _e1404);
                                            let _e1456 = select(0f, _e1450.y, _e1408);
                                            let _e1457 = select(0f, _e1450.z, _e1412);
                                            let _e1458 = select(0f, _e1450.w, _e1416);
                                            let _e1462 = global_9.member[(_e840 + _e1381.member)];
                                            let _e1467 = select(0f, _e1462.x, _e1404);
                                            let _e1468 = select(0f, _e1462.y, _e1408);
                                            let _e1469 = select(0f, _e1462.z, _e1412);
                                            let _e1470 = select(0f, _e1462.w, _e1416);
                                            let _e1474 = global_9.member[(_e841 + _e1381.member)];
                                            let _e1479 = select(0f, _e1474.x, _e1404);
                                            let _e1480 = select(0f, _e1474.y, _e1408);
                                            let _e1481 = select(0f, _e1474.z, _e1412);
                                            let _e1482 = select(0f, _e1474.w, _e1416);
                                            let _e1486 = global_9.member[(_e842 + _e1381.member)];
                                            let _e1491 = select(0f, _e1486.x, _e1404);
                                            let _e1492 = select(0f, _e1486.y, _e1408);
                                            let _e1493 = select(0f, _e1486.z, _e1412);
                                            let _e1494 = select(0f, _e1486.w, _e1416);
                                            let _e1498 = global_9.member[(_e843 + _e1381.member)];
                                            let _e1503 = select(0f, _e1498.x, _e1404);
                                            let _e1504 = select(0f, _e1498.y, _e1408);
                                            let _e1505 = select(0f, _e1498.z, _e1412);
                                            let _e1506 = select(0f, _e1498.w, _e1416);
                                            local_54 = type_19(((_e1506 * _e1417) + ((_e1505 * _e1413) + ((_e1504 * _e1409) + ((_e1503 * _e1405) + _e1373.member)))), ((_e1506 * _e1430) + ((_e1505 * _e1429) + ((_e1504 * _e1428) + ((_e1503 * _e1427) + _e1373.member_1)))), ((_e1506 * _e1444) + ((_e1505 * _e1443) + ((_e1504 * _e1442) + ((_e1503 * _e1441) + _e1373.member_2)))), ((_e1506 * _e1458) + ((_e1505 * _e1457) + ((_e1504 * _e1456) + ((_e1503 * _e1455) + _e1373.member_3)))));
                                            local_56 = type_19(((_e1494 * _e1417) + ((_e1493 * _e1413) + ((_e1492 * _e1409) + ((_e1491 * _e1405) + _e1375.member)))), ((_e1494 * _e1430) + ((_e1493 * _e1429) + ((_e1492 * _e1428) + ((_e1491 * _e1427) + _e1375.member_1)))), ((_e1494 * _e1444) + ((_e1493 * _e1443) + ((_e1492 * _e1442) + ((_e1491 * _e1441) + _e1375.member_2)))), ((_e1494 * _e1458) + ((_e1493 * _e1457) + ((_e1492 * _e1456) + ((_e1491 * _e1455) + _e1375.member_3)))));
                                            local_58 = type_19(((_e1482 * _e1417) + ((_e1481 * _e1413) + ((_e1480 * _e1409) + ((_e1479 * _e1405) + _e1377.member)))), ((_e1482 * _e1430) + ((_e1481 * _e1429) + ((_e1480 * _e1428) + ((_e1479 * _e1427) + _e1377.member_1)))), ((_e1482 * _e1444) + ((_e1481 * _e1443) + ((_e1480 * _e1442) + ((_e1479 * _e1441) + _e1377.member_2)))), ((_e1482 * _e1458) + ((_e1481 * _e1457) + ((_e1480 * _e1456) + ((_e1479 * _e1455) + _e1377.member_3)))));
                                            local_60 = type_19(((_e1470 * _e1417) + ((_e1469 * _e1413) + ((_e1468 * _e1409) + ((_e1467 * _e1405) + _e1379.member)))), ((_e1470 * _e1430) + ((_e1469 * _e1429) + ((_e1468 * _e1428) + ((_e1467 * _e1427) + _e1379.member_1)))), ((_e1470 * _e1444) + ((_e1469 * _e1443) + ((_e1468 * _e1442) + ((_e1467 * _e1441) + _e1379.member_2)))), ((_e1470 * _e1458) + ((_e1469 * _e1457) + ((_e1468 * _e1456) + ((_e1467 * _e1455) + _e1379.member_3)))));
                                            local_62 = type_20((_e1381.member + 1u), _e1381.member_1, _e1381.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2750 = local_54;
                                            phi_1412_ = _e2750;
                                            let _e2755 = local_56;
                                            phi_1415_ = _e2755;
                                            let _e2760 = local_58;
                                            phi_1417_ = _e2760;
                                            let _e2765 = local_60;
                                            phi_1419_ = _e2765;
                                            let _e2770 = local_62;
                                            phi_1421_ = _e2770;
                                        }
                                    }
                                    let _e1661 = local_6;
                                    let _e1664 = local_7;
                                    let _e1667 = local_8;
                                    let _e1670 = local_9;
                                    let _e1673 = local_10;
                                    let _e1676 = local_11;
                                    let _e1679 = local_12;
                                    let _e1682 = local_13;
                                    let _e1685 = local_14;
                                    let _e1688 = local_15;
                                    let _e1691 = local_16;
                                    let _e1694 = local_17;
                                    let _e1697 = local_18;
                                    let _e1700 = local_19;
                                    let _e1703 = local_20;
                                    let _e1706 = local_21;
                                    if _e205 {
                                        let _e1712 = (4u * _e201);
                                        let _e1713 = (4u * _e767);
                                        let _e1714 = bitcast<u32>(_e1661.member);
                                        let _e1717 = ((_e1714 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1717 == 0u) {
                                        } else {
                                            let _e1720 = (_e1717 % 16u);
                                            let _e1722 = ((_e1714 & 8388607u) | 8388608u);
                                            let _e1725 = (_e1722 << bitcast<u32>((_e1720 & 31u)));
                                            let _e1731 = ((_e1722 >> bitcast<u32>(((31u - _e1720) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1714 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1748_ = array<u32, 2>(_e1725, _e1731);
                                            } else {
                                                let _e1737 = (~(_e1725) + 1u);
                                                if (_e1737 == 0u) {
                                                    phi_1746_ = (~(_e1731) + 1u);
                                                } else {
                                                    phi_1746_ = ~(_e1731);
                                                }
                                                let _e1743 = phi_1746_;
                                                phi_1748_ = array<u32, 2>(_e1737, _e1743);
                                            }
                                            let _e1746 = phi_1748_;
                                            let _e1747 = (_e1717 < 255u);
                                            if _e1747 {
                                                phi_1754_ = _e1746;
                                            } else {
                                                phi_1754_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1750 = phi_1754_;
                                            let _e1755 = (2u * ((select(16u, (_e1717 / 16u), _e1747) * _e1712) + _e1713));
                                            let _e1758 = atomicAdd((&global_8.member[_e1755]), _e1750[0]);
                                            let _e1762 = (_e1750[1] + select(0u, 1u, ((_e1758 + _e1750[0]) < _e1750[0])));
                                            if (_e1762 == 0u) {
                                            } else {
                                                let _e1767 = atomicAdd((&global_8.member[(_e1755 + 1u)]), _e1762);
                                            }
                                        }
                                        let _e1769 = bitcast<u32>(_e1664.member_1);
                                        let _e1772 = ((_e1769 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1772 == 0u) {
                                        } else {
                                            let _e1775 = (_e1772 % 16u);
                                            let _e1777 = ((_e1769 & 8388607u) | 8388608u);
                                            let _e1780 = (_e1777 << bitcast<u32>((_e1775 & 31u)));
                                            let _e1786 = ((_e1777 >> bitcast<u32>(((31u - _e1775) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1769 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1809_ = array<u32, 2>(_e1780, _e1786);
                                            } else {
                                                let _e1792 = (~(_e1780) + 1u);
                                                if (_e1792 == 0u) {
                                                    phi_1807_ = (~(_e1786) + 1u);
                                                } else {
                                                    phi_1807_ = ~(_e1786);
                                                }
                                                let _e1798 = phi_1807_;
                                                phi_1809_ = array<u32, 2>(_e1792, _e1798);
                                            }
                                            let _e1801 = phi_1809_;
                                            let _e1802 = (_e1772 < 255u);
                                            if _e1802 {
                                                phi_1815_ = _e1801;
                                            } else {
                                                phi_1815_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1805 = phi_1815_;
                                            let _e1810 = (2u * ((select(16u, (_e1772 / 16u), _e1802) * _e1712) + (_e1713 + 1u)));
                                            let _e1813 = atomicAdd((&global_8.member[_e1810]), _e1805[0]);
                                            let _e1817 = (_e1805[1] + select(0u, 1u, ((_e1813 + _e1805[0]) < _e1805[0])));
                                            if (_e1817 == 0u) {
                                            } else {
                                                let _e1822 = atomicAdd((&global_8.member[(_e1810 + 1u)]), _e1817);
                                            }
                                        }
                                        let _e1824 = bitcast<u32>(_e1667.member_2);
                                        let _e1827 = ((_e1824 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1827 == 0u) {
                                        } else {
                                            let _e1830 = (_e1827 % 16u);
                                            let _e1832 = ((_e1824 & 8388607u) | 8388608u);
                                            let _e1835 = (_e1832 << bitcast<u32>((_e1830 & 31u)));
                                            let _e1841 = ((_e1832 >> bitcast<u32>(((31u - _e1830) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1824 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1870_ = array<u32, 2>(_e1835, _e1841);
                                            } else {
                                                let _e1847 = (~(_e1835) + 1u);
                                                if (_e1847 == 0u) {
                                                    phi_1868_ = (~(_e1841) + 1u);
                                                } else {
                                                    phi_1868_ = ~(_e1841);
                                                }
                                                let _e1853 = phi_1868_;
                                                phi_1870_ = array<u32, 2>(_e1847, _e1853);
                                            }
                                            let _e1856 = phi_1870_;
                                            let _e1857 = (_e1827 < 255u);
                                            if _e1857 {
                                                phi_1876_ = _e1856;
                                            } else {
                                                phi_1876_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1860 = phi_1876_;
                                            let _e1865 = (2u * ((select(16u, (_e1827 / 16u), _e1857) * _e1712) + (_e1713 + 2u)));
                                            let _e1868 = atomicAdd((&global_8.member[_e1865]), _e1860[0]);
                                            let _e1872 = (_e1860[1] + select(0u, 1u, ((_e1868 + _e1860[0]) < _e1860[0])));
                                            if (_e1872 == 0u) {
                                            } else {
                                                let _e1877 = atomicAdd((&global_8.member[(_e1865 + 1u)]), _e1872);
                                            }
                                        }
                                        let _e1879 = bitcast<u32>(_e1670.member_3);
                                        let _e1882 = ((_e1879 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1882 == 0u) {
                                        } else {
                                            let _e1885 = (_e1882 % 16u);
                                            let _e1887 = ((_e1879 & 8388607u) | 8388608u);
                                            let _e1890 = (_e1887 << bitcast<u32>((_e1885 & 31u)));
                                            let _e1896 = ((_e1887 >> bitcast<u32>(((31u - _e1885) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1879 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1931_ = array<u32, 2>(_e1890, _e1896);
                                            } else {
                                                let _e1902 = (~(_e1890) + 1u);
                                                if (_e1902 == 0u) {
                                                    phi_1929_ = (~(_e1896) + 1u);
                                                } else {
                                                    phi_1929_ = ~(_e1896);
                                                }
                                                let _e1908 = phi_1929_;
                                                phi_1931_ = array<u32, 2>(_e1902, _e1908);
                                            }
                                            let _e1911 = phi_1931_;
                                            let _e1912 = (_e1882 < 255u);
                                            if _e1912 {
                                                phi_1937_ = _e1911;
                                            } else {
                                                phi_1937_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1915 = phi_1937_;
                                            let _e1920 = (2u * ((select(16u, (_e1882 / 16u), _e1912) * _e1712) + (_e1713 + 3u)));
                                            let _e1923 = atomicAdd((&global_8.member[_e1920]), _e1915[0]);
                                            let _e1927 = (_e1915[1] + select(0u, 1u, ((_e1923 + _e1915[0]) < _e1915[0])));
                                            if (_e1927 == 0u) {
                                            } else {
                                                let _e1932 = atomicAdd((&global_8.member[(_e1920 + 1u)]), _e1927);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e204 + _e767)] = vec4<f32>(_e1661.member, _e1664.member_1, _e1667.member_2, _e1670.member_3);
                                    }
                                    if (_e786 < _e59) {
                                        if _e205 {
                                            let _e1938 = (4u * _e201);
                                            let _e1939 = (4u * _e772);
                                            let _e1940 = bitcast<u32>(_e1673.member);
                                            let _e1943 = ((_e1940 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1943 == 0u) {
                                            } else {
                                                let _e1946 = (_e1943 % 16u);
                                                let _e1948 = ((_e1940 & 8388607u) | 8388608u);
                                                let _e1951 = (_e1948 << bitcast<u32>((_e1946 & 31u)));
                                                let _e1957 = ((_e1948 >> bitcast<u32>(((31u - _e1946) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1940 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2003_ = array<u32, 2>(_e1951, _e1957);
                                                } else {
                                                    let _e1963 = (~(_e1951) + 1u);
                                                    if (_e1963 == 0u) {
                                                        phi_2001_ = (~(_e1957) + 1u);
                                                    } else {
                                                        phi_2001_ = ~(_e1957);
                                                    }
                                                    let _e1969 = phi_2001_;
                                                    phi_2003_ = array<u32, 2>(_e1963, _e1969);
                                                }
                                                let _e1972 = phi_2003_;
                                                let _e1973 = (_e1943 < 255u);
                                                if _e1973 {
                                                    phi_2009_ = _e1972;
                                                } else {
                                                    phi_2009_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1976 = phi_2009_;
                                                let _e1981 = (2u * ((select(16u, (_e1943 / 16u), _e1973) * _e1938) + _e1939));
                                                let _e1984 = atomicAdd((&global_8.member[_e1981]), _e1976[0]);
                                                let _e1988 = (_e1976[1] + select(0u, 1u, ((_e1984 + _e1976[0]) < _e1976[0])));
                                                if (_e1988 == 0u) {
                                                } else {
                                                    let _e1993 = atomicAdd((&global_8.member[(_e1981 + 1u)]), _e1988);
                                                }
                                            }
                                            let _e1995 = bitcast<u32>(_e1676.member_1);
                                            let _e1998 = ((_e1995 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1998 == 0u) {
                                            } else {
                                                let _e2001 = (_e1998 % 16u);
                                                let _e2003 = ((_e1995 & 8388607u) | 8388608u);
                                                let _e2006 = (_e2003 << bitcast<u32>((_e2001 & 31u)));
                                                let _e2012 = ((_e2003 >> bitcast<u32>(((31u - _e2001) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1995 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2064_ = array<u32, 2>(_e2006, _e2012);
                                                } else {
                                                    let _e2018 = (~(_e2006) + 1u);
                                                    if (_e2018 == 0u) {
                                                        phi_2062_ = (~(_e2012) + 1u);
                                                    } else {
                                                        phi_2062_ = ~(_e2012);
                                                    }
                                                    let _e2024 = phi_2062_;
                                                    phi_2064_ = array<u32, 2>(_e2018, _e2024);
                                                }
                                                let _e2027 = phi_2064_;
                                                let _e2028 = (_e1998 < 255u);
                                                if _e2028 {
                                                    phi_2070_ = _e2027;
                                                } else {
                                                    phi_2070_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2031 = phi_2070_;
                                                let _e2036 = (2u * ((select(16u, (_e1998 / 16u), _e2028) * _e1938) + (_e1939 + 1u)));
                                                let _e2039 = atomicAdd((&global_8.member[_e2036]), _e2031[0]);
                                                let _e2043 = (_e2031[1] + select(0u, 1u, ((_e2039 + _e2031[0]) < _e2031[0])));
                                                if (_e2043 == 0u) {
                                                } else {
                                                    let _e2048 = atomicAdd((&global_8.member[(_e2036 + 1u)]), _e2043);
                                                }
                                            }
                                            let _e2050 = bitcast<u32>(_e1679.member_2);
                                            let _e2053 = ((_e2050 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2053 == 0u) {
                                            } else {
                                                let _e2056 = (_e2053 % 16u);
                                                let _e2058 = ((_e2050 & 8388607u) | 8388608u);
                                                let _e2061 = (_e2058 << bitcast<u32>((_e2056 & 31u)));
                                                let _e2067 = ((_e2058 >> bitcast<u32>(((31u - _e2056) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2050 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2125_ = array<u32, 2>(_e2061, _e2067);
                                                } else {
                                                    let _e2073 = (~(_e2061) + 1u);
                                                    if (_e2073 == 0u) {
                                                        phi_2123_ = (~(_e2067) + 1u);
                                                    } else {
                                                        phi_2123_ = ~(_e2067);
                                                    }
                                                    let _e2079 = phi_2123_;
                                                    phi_2125_ = array<u32, 2>(_e2073, _e2079);
                                                }
                                                let _e2082 = phi_2125_;
                                                let _e2083 = (_e2053 < 255u);
                                                if _e2083 {
                                                    phi_2131_ = _e2082;
                                                } else {
                                                    phi_2131_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2086 = phi_2131_;
                                                let _e2091 = (2u * ((select(16u, (_e2053 / 16u), _e2083) * _e1938) + (_e1939 + 2u)));
                                                let _e2094 = atomicAdd((&global_8.member[_e2091]), _e2086[0]);
                                                let _e2098 = (_e2086[1] + select(0u, 1u, ((_e2094 + _e2086[0]) < _e2086[0])));
                                                if (_e2098 == 0u) {
                                                } else {
                                                    let _e2103 = atomicAdd((&global_8.member[(_e2091 + 1u)]), _e2098);
                                                }
                                            }
                                            let _e2105 = bitcast<u32>(_e1682.member_3);
                                            let _e2108 = ((_e2105 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2108 == 0u) {
                                            } else {
                                                let _e2111 = (_e2108 % 16u);
                                                let _e2113 = ((_e2105 & 8388607u) | 8388608u);
                                                let _e2116 = (_e2113 << bitcast<u32>((_e2111 & 31u)));
                                                let _e2122 = ((_e2113 >> bitcast<u32>(((31u - _e2111) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2105 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2186_ = array<u32, 2>(_e2116, _e2122);
                                                } else {
                                                    let _e2128 = (~(_e2116) + 1u);
                                                    if (_e2128 == 0u) {
                                                        phi_2184_ = (~(_e2122) + 1u);
                                                    } else {
                                                        phi_2184_ = ~(_e2122);
                                                    }
                                                    let _e2134 = phi_2184_;
                                                    phi_2186_ = array<u32, 2>(_e2128, _e2134);
                                                }
                                                let _e2137 = phi_2186_;
                                                let _e2138 = (_e2108 < 255u);
                                                if _e2138 {
                                                    phi_2192_ = _e2137;
                                                } else {
                                                    phi_2192_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2141 = phi_2192_;
                                                let _e2146 = (2u * ((select(16u, (_e2108 / 16u), _e2138) * _e1938) + (_e1939 + 3u)));
                                                let _e2149 = atomicAdd((&global_8.member[_e2146]), _e2141[0]);
                                                let _e2153 = (_e2141[1] + select(0u, 1u, ((_e2149 + _e2141[0]) < _e2141[0])));
                                                if (_e2153 == 0u) {
                                                } else {
                                                    let _e2158 = atomicAdd((&global_8.member[(_e2146 + 1u)]), _e2153);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e772)] = vec4<f32>(_e1673.member, _e1676.member_1, _e1679.member_2, _e1682.member_3);
                                        }
                                    }
                                    if (_e790 < _e59) {
                                        if _e205 {
                                            let _e2164 = (4u * _e201);
                                            let _e2165 = (4u * _e776);
                                            let _e2166 = bitcast<u32>(_e1685.member);
                                            let _e2169 = ((_e2166 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2169 == 0u) {
                                            } else {
                                                let _e2172 = (_e2169 % 16u);
                                                let _e2174 = ((_e2166 & 8388607u) | 8388608u);
                                                let _e2177 = (_e2174 << bitcast<u32>((_e2172 & 31u)));
                                                let _e2183 = ((_e2174 >> bitcast<u32>(((31u - _e2172) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2166 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2258_ = array<u32, 2>(_e2177, _e2183);
                                                } else {
                                                    let _e2189 = (~(_e2177) + 1u);
                                                    if (_e2189 == 0u) {
                                                        phi_2256_ = (~(_e2183) + 1u);
                                                    } else {
                                                        phi_2256_ = ~(_e2183);
                                                    }
                                                    let _e2195 = phi_2256_;
                                                    phi_2258_ = array<u32, 2>(_e2189, _e2195);
                                                }
                                                let _e2198 = phi_2258_;
                                                let _e2199 = (_e2169 < 255u);
                                                if _e2199 {
                                                    phi_2264_ = _e2198;
                                                } else {
                                                    phi_2264_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2202 = phi_2264_;
                                                let _e2207 = (2u * ((select(16u, (_e2169 / 16u), _e2199) * _e2164) + _e2165));
                                                let _e2210 = atomicAdd((&global_8.member[_e2207]), _e2202[0]);
                                                let _e2214 = (_e2202[1] + select(0u, 1u, ((_e2210 + _e2202[0]) < _e2202[0])));
                                                if (_e2214 == 0u) {
                                                } else {
                                                    let _e2219 = atomicAdd((&global_8.member[(_e2207 + 1u)]), _e2214);
                                                }
                                            }
                                            let _e2221 = bitcast<u32>(_e1688.member_1);
                                            let _e2224 = ((_e2221 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2224 == 0u) {
                                            } else {
                                                let _e2227 = (_e2224 % 16u);
                                                let _e2229 = ((_e2221 & 8388607u) | 8388608u);
                                                let _e2232 = (_e2229 << bitcast<u32>((_e2227 & 31u)));
                                                let _e2238 = ((_e2229 >> bitcast<u32>(((31u - _e2227) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2221 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2319_ = array<u32, 2>(_e2232, _e2238);
                                                } else {
                                                    let _e2244 = (~(_e2232) + 1u);
                                                    if (_e2244 == 0u) {
                                                        phi_2317_ = (~(_e2238) + 1u);
                                                    } else {
                                                        phi_2317_ = ~(_e2238);
                                                    }
                                                    let _e2250 = phi_2317_;
                                                    phi_2319_ = array<u32, 2>(_e2244, _e2250);
                                                }
                                                let _e2253 = phi_2319_;
                                                let _e2254 = (_e2224 < 255u);
                                                if _e2254 {
                                                    phi_2325_ = _e2253;
                                                } else {
                                                    phi_2325_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2257 = phi_2325_;
                                                let _e2262 = (2u * ((select(16u, (_e2224 / 16u), _e2254) * _e2164) + (_e2165 + 1u)));
                                                let _e2265 = atomicAdd((&global_8.member[_e2262]), _e2257[0]);
                                                let _e2269 = (_e2257[1] + select(0u, 1u, ((_e2265 + _e2257[0]) < _e2257[0])));
                                                if (_e2269 == 0u) {
                                                } else {
                                                    let _e2274 = atomicAdd((&global_8.member[(_e2262 + 1u)]), _e2269);
                                                }
                                            }
                                            let _e2276 = bitcast<u32>(_e1691.member_2);
                                            let _e2279 = ((_e2276 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2279 == 0u) {
                                            } else {
                                                let _e2282 = (_e2279 % 16u);
                                                let _e2284 = ((_e2276 & 8388607u) | 8388608u);
                                                let _e2287 = (_e2284 << bitcast<u32>((_e2282 & 31u)));
                                                let _e2293 = ((_e2284 >> bitcast<u32>(((31u - _e2282) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2276 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2380_ = array<u32, 2>(_e2287, _e2293);
                                                } else {
                                                    let _e2299 = (~(_e2287) + 1u);
                                                    if (_e2299 == 0u) {
                                                        phi_2378_ = (~(_e2293) + 1u);
                                                    } else {
                                                        phi_2378_ = ~(_e2293);
                                                    }
                                                    let _e2305 = phi_2378_;
                                                    phi_2380_ = array<u32, 2>(_e2299, _e2305);
                                                }
                                                let _e2308 = phi_2380_;
                                                let _e2309 = (_e2279 < 255u);
                                                if _e2309 {
                                                    phi_2386_ = _e2308;
                                                } else {
                                                    phi_2386_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2312 = phi_2386_;
                                                let _e2317 = (2u * ((select(16u, (_e2279 / 16u), _e2309) * _e2164) + (_e2165 + 2u)));
                                                let _e2320 = atomicAdd((&global_8.member[_e2317]), _e2312[0]);
                                                let _e2324 = (_e2312[1] + select(0u, 1u, ((_e2320 + _e2312[0]) < _e2312[0])));
                                                if (_e2324 == 0u) {
                                                } else {
                                                    let _e2329 = atomicAdd((&global_8.member[(_e2317 + 1u)]), _e2324);
                                                }
                                            }
                                            let _e2331 = bitcast<u32>(_e1694.member_3);
                                            let _e2334 = ((_e2331 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2334 == 0u) {
                                            } else {
                                                let _e2337 = (_e2334 % 16u);
                                                let _e2339 = ((_e2331 & 8388607u) | 8388608u);
                                                let _e2342 = (_e2339 << bitcast<u32>((_e2337 & 31u)));
                                                let _e2348 = ((_e2339 >> bitcast<u32>(((31u - _e2337) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2331 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2441_ = array<u32, 2>(_e2342, _e2348);
                                                } else {
                                                    let _e2354 = (~(_e2342) + 1u);
                                                    if (_e2354 == 0u) {
                                                        phi_2439_ = (~(_e2348) + 1u);
                                                    } else {
                                                        phi_2439_ = ~(_e2348);
                                                    }
                                                    let _e2360 = phi_2439_;
                                                    phi_2441_ = array<u32, 2>(_e2354, _e2360);
                                                }
                                                let _e2363 = phi_2441_;
                                                let _e2364 = (_e2334 < 255u);
                                                if _e2364 {
                                                    phi_2447_ = _e2363;
                                                } else {
                                                    phi_2447_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2367 = phi_2447_;
                                                let _e2372 = (2u * ((select(16u, (_e2334 / 16u), _e2364) * _e2164) + (_e2165 + 3u)));
                                                let _e2375 = atomicAdd((&global_8.member[_e2372]), _e2367[0]);
                                                let _e2379 = (_e2367[1] + select(0u, 1u, ((_e2375 + _e2367[0]) < _e2367[0])));
                                                if (_e2379 == 0u) {
                                                } else {
                                                    let _e2384 = atomicAdd((&global_8.member[(_e2372 + 1u)]), _e2379);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e776)] = vec4<f32>(_e1685.member, _e1688.member_1, _e1691.member_2, _e1694.member_3);
                                        }
                                    }
                                    if (_e794 < _e59) {
                                        if _e205 {
                                            let _e2390 = (4u * _e201);
                                            let _e2391 = (4u * _e780);
                                            let _e2392 = bitcast<u32>(_e1697.member);
                                            let _e2395 = ((_e2392 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2395 == 0u) {
                                            } else {
                                                let _e2398 = (_e2395 % 16u);
                                                let _e2400 = ((_e2392 & 8388607u) | 8388608u);
                                                let _e2403 = (_e2400 << bitcast<u32>((_e2398 & 31u)));
                                                let _e2409 = ((_e2400 >> bitcast<u32>(((31u - _e2398) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2392 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2513_ = array<u32, 2>(_e2403, _e2409);
                                                } else {
                                                    let _e2415 = (~(_e2403) + 1u);
                                                    if (_e2415 == 0u) {
                                                        phi_2511_ = (~(_e2409) + 1u);
                                                    } else {
                                                        phi_2511_ = ~(_e2409);
                                                    }
                                                    let _e2421 = phi_2511_;
                                                    phi_2513_ = array<u32, 2>(_e2415, _e2421);
                                                }
                                                let _e2424 = phi_2513_;
                                                let _e2425 = (_e2395 < 255u);
                                                if _e2425 {
                                                    phi_2519_ = _e2424;
                                                } else {
                                                    phi_2519_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2428 = phi_2519_;
                                                let _e2433 = (2u * ((select(16u, (_e2395 / 16u), _e2425) * _e2390) + _e2391));
                                                let _e2436 = atomicAdd((&global_8.member[_e2433]), _e2428[0]);
                                                let _e2440 = (_e2428[1] + select(0u, 1u, ((_e2436 + _e2428[0]) < _e2428[0])));
                                                if (_e2440 == 0u) {
                                                } else {
                                                    let _e2445 = atomicAdd((&global_8.member[(_e2433 + 1u)]), _e2440);
                                                }
                                            }
                                            let _e2447 = bitcast<u32>(_e1700.member_1);
                                            let _e2450 = ((_e2447 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2450 == 0u) {
                                            } else {
                                                let _e2453 = (_e2450 % 16u);
                                                let _e2455 = ((_e2447 & 8388607u) | 8388608u);
                                                let _e2458 = (_e2455 << bitcast<u32>((_e2453 & 31u)));
                                                let _e2464 = ((_e2455 >> bitcast<u32>(((31u - _e2453) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2447 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2574_ = array<u32, 2>(_e2458, _e2464);
                                                } else {
                                                    let _e2470 = (~(_e2458) + 1u);
                                                    if (_e2470 == 0u) {
                                                        phi_2572_ = (~(_e2464) + 1u);
                                                    } else {
                                                        phi_2572_ = ~(_e2464);
                                                    }
                                                    let _e2476 = phi_2572_;
                                                    phi_2574_ = array<u32, 2>(_e2470, _e2476);
                                                }
                                                let _e2479 = phi_2574_;
                                                let _e2480 = (_e2450 < 255u);
                                                if _e2480 {
                                                    phi_2580_ = _e2479;
                                                } else {
                                                    phi_2580_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2483 = phi_2580_;
                                                let _e2488 = (2u * ((select(16u, (_e2450 / 16u), _e2480) * _e2390) + (_e2391 + 1u)));
                                                let _e2491 = atomicAdd((&global_8.member[_e2488]), _e2483[0]);
                                                let _e2495 = (_e2483[1] + select(0u, 1u, ((_e2491 + _e2483[0]) < _e2483[0])));
                                                if (_e2495 == 0u) {
                                                } else {
                                                    let _e2500 = atomicAdd((&global_8.member[(_e2488 + 1u)]), _e2495);
                                                }
                                            }
                                            let _e2502 = bitcast<u32>(_e1703.member_2);
                                            let _e2505 = ((_e2502 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2505 == 0u) {
                                            } else {
                                                let _e2508 = (_e2505 % 16u);
                                                let _e2510 = ((_e2502 & 8388607u) | 8388608u);
                                                let _e2513 = (_e2510 << bitcast<u32>((_e2508 & 31u)));
                                                let _e2519 = ((_e2510 >> bitcast<u32>(((31u - _e2508) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2502 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2635_ = array<u32, 2>(_e2513, _e2519);
                                                } else {
                                                    let _e2525 = (~(_e2513) + 1u);
                                                    if (_e2525 == 0u) {
                                                        phi_2633_ = (~(_e2519) + 1u);
                                                    } else {
                                                        phi_2633_ = ~(_e2519);
                                                    }
                                                    let _e2531 = phi_2633_;
                                                    phi_2635_ = array<u32, 2>(_e2525, _e2531);
                                                }
                                                let _e2534 = phi_2635_;
                                                let _e2535 = (_e2505 < 255u);
                                                if _e2535 {
                                                    phi_2641_ = _e2534;
                                                } else {
                                                    phi_2641_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2538 = phi_2641_;
                                                let _e2543 = (2u * ((select(16u, (_e2505 / 16u), _e2535) * _e2390) + (_e2391 + 2u)));
                                                let _e2546 = atomicAdd((&global_8.member[_e2543]), _e2538[0]);
                                                let _e2550 = (_e2538[1] + select(0u, 1u, ((_e2546 + _e2538[0]) < _e2538[0])));
                                                if (_e2550 == 0u) {
                                                } else {
                                                    let _e2555 = atomicAdd((&global_8.member[(_e2543 + 1u)]), _e2550);
                                                }
                                            }
                                            let _e2557 = bitcast<u32>(_e1706.member_3);
                                            let _e2560 = ((_e2557 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2560 == 0u) {
                                            } else {
                                                let _e2563 = (_e2560 % 16u);
                                                let _e2565 = ((_e2557 & 8388607u) | 8388608u);
                                                let _e2568 = (_e2565 << bitcast<u32>((_e2563 & 31u)));
                                                let _e2574 = ((_e2565 >> bitcast<u32>(((31u - _e2563) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2557 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2696_ = array<u32, 2>(_e2568, _e2574);
                                                } else {
                                                    let _e2580 = (~(_e2568) + 1u);
                                                    if (_e2580 == 0u) {
                                                        phi_2694_ = (~(_e2574) + 1u);
                                                    } else {
                                                        phi_2694_ = ~(_e2574);
                                                    }
                                                    let _e2586 = phi_2694_;
                                                    phi_2696_ = array<u32, 2>(_e2580, _e2586);
                                                }
                                                let _e2589 = phi_2696_;
                                                let _e2590 = (_e2560 < 255u);
                                                if _e2590 {
                                                    phi_2702_ = _e2589;
                                                } else {
                                                    phi_2702_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2593 = phi_2702_;
                                                let _e2598 = (2u * ((select(16u, (_e2560 / 16u), _e2590) * _e2390) + (_e2391 + 3u)));
                                                let _e2601 = atomicAdd((&global_8.member[_e2598]), _e2593[0]);
                                                let _e2605 = (_e2593[1] + select(0u, 1u, ((_e2601 + _e2593[0]) < _e2593[0])));
                                                if (_e2605 == 0u) {
                                                } else {
                                                    let _e2610 = atomicAdd((&global_8.member[(_e2598 + 1u)]), _e2605);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e780)] = vec4<f32>(_e1697.member, _e1700.member_1, _e1703.member_2, _e1706.member_3);
                                        }
                                    }
                                } else {
                                    let _e216 = global_3.member.member_6;
                                    let _e217 = (_e216 + _e83[1]);
                                    if _e207 {
                                        let _e221 = global_6.member[(_e202 + _e217)];
                                        phi_271_ = _e221;
                                    } else {
                                        phi_271_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e223 = phi_271_;
                                    phi_280_ = type_20((_e192 / 4u), _e192, _e195);
                                    phi_283_ = type_19(_e223.x, _e223.y, _e223.z, _e223.w);
                                    loop {
                                        let _e232 = phi_280_;
                                        let _e234 = phi_283_;
                                        local_30 = _e232;
                                        local_32 = _e234;
                                        let _e236 = (4u * _e232.member);
                                        if (_e236 < _e232.member_2) {
                                            phi_299_ = select(((_e236 + 4u) > _e232.member_2), true, (_e236 < _e232.member_1));
                                        } else {
                                            phi_299_ = false;
                                        }
                                        let _e245 = phi_299_;
                                        if _e245 {
                                            let _e246 = (_e212 / 4u);
                                            let _e247 = (_e210 / 4u);
                                            let _e251 = global_7.member[(_e246 + _e232.member)];
                                            let _e258 = (_e232.member_2 - _e232.member_1);
                                            let _e259 = ((_e236 - _e232.member_1) < _e258);
                                            let _e263 = (((_e236 + 1u) - _e232.member_1) < _e258);
                                            let _e267 = (((_e236 + 2u) - _e232.member_1) < _e258);
                                            let _e271 = (((_e236 + 3u) - _e232.member_1) < _e258);
                                            let _e277 = global_7.member[((_e246 + _e247) + _e232.member)];
                                            let _e291 = global_7.member[((_e246 + (2u * _e247)) + _e232.member)];
                                            let _e305 = global_7.member[((_e246 + (3u * _e247)) + _e232.member)];
                                            local_28 = type_20((_e232.member + 1u), _e232.member_1, _e232.member_2);
                                            local_29 = type_19(((((_e234.member + select(0f, _e251.x, _e259)) + select(0f, _e251.y, _e263)) + select(0f, _e251.z, _e267)) + select(0f, _e251.w, _e271)), ((((_e234.member_1 + select(0f, _e277.x, _e259)) + select(0f, _e277.y, _e263)) + select(0f, _e277.z, _e267)) + select(0f, _e277.w, _e271)), ((((_e234.member_2 + select(0f, _e291.x, _e259)) + select(0f, _e291.y, _e263)) + select(0f, _e291.z, _e267)) + select(0f, _e291.w, _e271)), ((((_e234.member_3 + select(0f, _e305.x, _e259)) + select(0f, _e305.y, _e263)) + select(0f, _e305.z, _e267)) + select(0f, _e305.w, _e271)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2659 = local_28;
                                            phi_280_ = _e2659;
                                            let _e2662 = local_29;
                                            phi_283_ = _e2662;
                                        }
                                    }
                                    let _e2666 = local_30;
                                    phi_387_ = _e2666;
                                    let _e2671 = local_32;
                                    phi_390_ = _e2671;
                                    loop {
                                        let _e341 = phi_387_;
                                        let _e343 = phi_390_;
                                        local_34 = _e341;
                                        local_36 = _e343;
                                        if !((((4u * _e341.member) + 4u) > _e341.member_2)) {
                                            let _e350 = (_e212 / 4u);
                                            let _e351 = (_e210 / 4u);
                                            let _e355 = global_7.member[(_e350 + _e341.member)];
                                            let _e364 = global_7.member[((_e350 + _e351) + _e341.member)];
                                            let _e374 = global_7.member[((_e350 + (2u * _e351)) + _e341.member)];
                                            let _e384 = global_7.member[((_e350 + (3u * _e351)) + _e341.member)];
                                            local_31 = type_20((_e341.member + 1u), _e341.member_1, _e341.member_2);
                                            local_33 = type_19(((((_e343.member + _e355.x) + _e355.y) + _e355.z) + _e355.w), ((((_e343.member_1 + _e364.x) + _e364.y) + _e364.z) + _e364.w), ((((_e343.member_2 + _e374.x) + _e374.y) + _e374.z) + _e374.w), ((((_e343.member_3 + _e384.x) + _e384.y) + _e384.z) + _e384.w));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2668 = local_31;
                                            phi_387_ = _e2668;
                                            let _e2673 = local_33;
                                            phi_390_ = _e2673;
                                        }
                                    }
                                    let _e2676 = local_34;
                                    phi_457_ = _e2676;
                                    let _e2681 = local_36;
                                    phi_460_ = _e2681;
                                    loop {
                                        let _e416 = phi_457_;
                                        let _e418 = phi_460_;
                                        local_2 = _e418;
                                        local_3 = _e418;
                                        local_4 = _e418;
                                        local_5 = _e418;
                                        let _e420 = (4u * _e416.member);
                                        if (_e420 < _e416.member_2) {
                                            phi_476_ = select(((_e420 + 4u) > _e416.member_2), true, (_e420 < _e416.member_1));
                                        } else {
                                            phi_476_ = false;
                                        }
                                        let _e429 = phi_476_;
                                        if _e429 {
                                            let _e430 = (_e212 / 4u);
                                            let _e431 = (_e210 / 4u);
                                            let _e435 = global_7.member[(_e430 + _e416.member)];
                                            let _e442 = (_e416.member_2 - _e416.member_1);
                                            let _e443 = ((_e420 - _e416.member_1) < _e442);
                                            let _e447 = (((_e420 + 1u) - _e416.member_1) < _e442);
                                            let _e451 = (((_e420 + 2u) - _e416.member_1) < _e442);
                                            let _e455 = (((_e420 + 3u) - _e416.member_1) < _e442);
                                            let _e461 = global_7.member[((_e430 + _e431) + _e416.member)];
                                            let _e475 = global_7.member[((_e430 + (2u * _e431)) + _e416.member)];
                                            let _e489 = global_7.member[((_e430 + (3u * _e431)) + _e416.member)];
                                            local_35 = type_20((_e416.member + 1u), _e416.member_1, _e416.member_2);
                                            local_37 = type_19(((((_e418.member + select(0f, _e435.x, _e443)) + select(0f, _e435.y, _e447)) + select(0f, _e435.z, _e451)) + select(0f, _e435.w, _e455)), ((((_e418.member_1 + select(0f, _e461.x, _e443)) + select(0f, _e461.y, _e447)) + select(0f, _e461.z, _e451)) + select(0f, _e461.w, _e455)), ((((_e418.member_2 + select(0f, _e475.x, _e443)) + select(0f, _e475.y, _e447)) + select(0f, _e475.z, _e451)) + select(0f, _e475.w, _e455)), ((((_e418.member_3 + select(0f, _e489.x, _e443)) + select(0f, _e489.y, _e447)) + select(0f, _e489.z, _e451)) + select(0f, _e489.w, _e455)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2678 = local_35;
                                            phi_457_ = _e2678;
                                            let _e2683 = local_37;
                                            phi_460_ = _e2683;
                                        }
                                    }
                                    let _e525 = local_2;
                                    let _e528 = local_3;
                                    let _e531 = local_4;
                                    let _e534 = local_5;
                                    if _e205 {
                                        let _e540 = (4u * _e201);
                                        let _e541 = (4u * _e217);
                                        let _e542 = bitcast<u32>(_e525.member);
                                        let _e545 = ((_e542 >> bitcast<u32>(23i)) & 255u);
                                        if (_e545 == 0u) {
                                        } else {
                                            let _e548 = (_e545 % 16u);
                                            let _e550 = ((_e542 & 8388607u) | 8388608u);
                                            let _e553 = (_e550 << bitcast<u32>((_e548 & 31u)));
                                            let _e559 = ((_e550 >> bitcast<u32>(((31u - _e548) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e542 >> bitcast<u32>(31i)) == 0u) {
                                                phi_609_ = array<u32, 2>(_e553, _e559);
                                            } else {
                                                let _e565 = (~(_e553) + 1u);
                                                if (_e565 == 0u) {
                                                    phi_607_ = (~(_e559) + 1u);
                                                } else {
                                                    phi_607_ = ~(_e559);
                                                }
                                                let _e571 = phi_607_;
                                                phi_609_ = array<u32, 2>(_e565, _e571);
                                            }
                                            let _e574 = phi_609_;
                                            let _e575 = (_e545 < 255u);
                                            if _e575 {
                                                phi_615_ = _e574;
                                            } else {
                                                phi_615_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e578 = phi_615_;
                                            let _e583 = (2u * ((select(16u, (_e545 / 16u), _e575) * _e540) + _e541));
                                            let _e586 = atomicAdd((&global_8.member[_e583]), _e578[0]);
                                            let _e590 = (_e578[1] + select(0u, 1u, ((_e586 + _e578[0]) < _e578[0])));
                                            if (_e590 == 0u) {
                                            } else {
                                                let _e595 = atomicAdd((&global_8.member[(_e583 + 1u)]), _e590);
                                            }
                                        }
                                        let _e597 = bitcast<u32>(_e528.member_1);
                                        let _e600 = ((_e597 >> bitcast<u32>(23i)) & 255u);
                                        if (_e600 == 0u) {
                                        } else {
                                            let _e603 = (_e600 % 16u);
                                            let _e605 = ((_e597 & 8388607u) | 8388608u);
                                            let _e608 = (_e605 << bitcast<u32>((_e603 & 31u)));
                                            let _e614 = ((_e605 >> bitcast<u32>(((31u - _e603) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e597 >> bitcast<u32>(31i)) == 0u) {
                                                phi_670_ = array<u32, 2>(_e608, _e614);
                                            } else {
                                                let _e620 = (~(_e608) + 1u);
                                                if (_e620 == 0u) {
                                                    phi_668_ = (~(_e614) + 1u);
                                                } else {
                                                    phi_668_ = ~(_e614);
                                                }
                                                let _e626 = phi_668_;
                                                phi_670_ = array<u32, 2>(_e620, _e626);
                                            }
                                            let _e629 = phi_670_;
                                            let _e630 = (_e600 < 255u);
                                            if _e630 {
                                                phi_676_ = _e629;
                                            } else {
                                                phi_676_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e633 = phi_676_;
                                            let _e638 = (2u * ((select(16u, (_e600 / 16u), _e630) * _e540) + (_e541 + 1u)));
                                            let _e641 = atomicAdd((&global_8.member[_e638]), _e633[0]);
                                            let _e645 = (_e633[1] + select(0u, 1u, ((_e641 + _e633[0]) < _e633[0])));
                                            if (_e645 == 0u) {
                                            } else {
                                                let _e650 = atomicAdd((&global_8.member[(_e638 + 1u)]), _e645);
                                            }
                                        }
                                        let _e652 = bitcast<u32>(_e531.member_2);
                                        let _e655 = ((_e652 >> bitcast<u32>(23i)) & 255u);
                                        if (_e655 == 0u) {
                                        } else {
                                            let _e658 = (_e655 % 16u);
                                            let _e660 = ((_e652 & 8388607u) | 8388608u);
                                            let _e663 = (_e660 << bitcast<u32>((_e658 & 31u)));
                                            let _e669 = ((_e660 >> bitcast<u32>(((31u - _e658) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e652 >> bitcast<u32>(31i)) == 0u) {
                                                phi_731_ = array<u32, 2>(_e663, _e669);
                                            } else {
                                                let _e675 = (~(_e663) + 1u);
                                                if (_e675 == 0u) {
                                                    phi_729_ = (~(_e669) + 1u);
                                                } else {
                                                    phi_729_ = ~(_e669);
                                                }
                                                let _e681 = phi_729_;
                                                phi_731_ = array<u32, 2>(_e675, _e681);
                                            }
                                            let _e684 = phi_731_;
                                            let _e685 = (_e655 < 255u);
                                            if _e685 {
                                                phi_737_ = _e684;
                                            } else {
                                                phi_737_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e688 = phi_737_;
                                            let _e693 = (2u * ((select(16u, (_e655 / 16u), _e685) * _e540) + (_e541 + 2u)));
                                            let _e696 = atomicAdd((&global_8.member[_e693]), _e688[0]);
                                            let _e700 = (_e688[1] + select(0u, 1u, ((_e696 + _e688[0]) < _e688[0])));
                                            if (_e700 == 0u) {
                                            } else {
                                                let _e705 = atomicAdd((&global_8.member[(_e693 + 1u)]), _e700);
                                            }
                                        }
                                        let _e707 = bitcast<u32>(_e534.member_3);
                                        let _e710 = ((_e707 >> bitcast<u32>(23i)) & 255u);
                                        if (_e710 == 0u) {
                                        } else {
                                            let _e713 = (_e710 % 16u);
                                            let _e715 = ((_e707 & 8388607u) | 8388608u);
                                            let _e718 = (_e715 << bitcast<u32>((_e713 & 31u)));
                                            let _e724 = ((_e715 >> bitcast<u32>(((31u - _e713) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e707 >> bitcast<u32>(31i)) == 0u) {
                                                phi_792_ = array<u32, 2>(_e718, _e724);
                                            } else {
                                                let _e730 = (~(_e718) + 1u);
                                                if (_e730 == 0u) {
                                                    phi_790_ = (~(_e724) + 1u);
                                                } else {
                                                    phi_790_ = ~(_e724);
                                                }
                                                let _e736 = phi_790_;
                                                phi_792_ = array<u32, 2>(_e730, _e736);
                                            }
                                            let _e739 = phi_792_;
                                            let _e740 = (_e710 < 255u);
                                            if _e740 {
                                                phi_798_ = _e739;
                                            } else {
                                                phi_798_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e743 = phi_798_;
                                            let _e748 = (2u * ((select(16u, (_e710 / 16u), _e740) * _e540) + (_e541 + 3u)));
                                            let _e751 = atomicAdd((&global_8.member[_e748]), _e743[0]);
                                            let _e755 = (_e743[1] + select(0u, 1u, ((_e751 + _e743[0]) < _e743[0])));
                                            if (_e755 == 0u) {
                                            } else {
                                                let _e760 = atomicAdd((&global_8.member[(_e748 + 1u)]), _e755);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e204 + _e217)] = vec4<f32>(_e525.member, _e528.member_1, _e531.member_2, _e534.member_3);
                                    }
                                }
                                phi_218_ = _e178;
                                phi_221_ = _e187;
                                phi_223_ = _e182;
                            }
                            let _e2623 = phi_218_;
                            let _e2625 = phi_221_;
                            let _e2627 = phi_223_;
                            local_24 = _e2623;
                            local_25 = _e2625;
                            local_27 = _e2627;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2646 = local_24;
                            phi_217_ = _e2646;
                            let _e2649 = local_25;
                            phi_220_ = _e2649;
                            let _e2654 = local_27;
                            phi_222_ = _e2654;
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
