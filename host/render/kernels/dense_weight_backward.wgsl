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
    var phi_612_: u32;
    var phi_614_: array<u32, 2>;
    var phi_620_: array<u32, 2>;
    var phi_673_: u32;
    var phi_675_: array<u32, 2>;
    var phi_681_: array<u32, 2>;
    var phi_734_: u32;
    var phi_736_: array<u32, 2>;
    var phi_742_: array<u32, 2>;
    var phi_795_: u32;
    var phi_797_: array<u32, 2>;
    var phi_803_: array<u32, 2>;
    var phi_864_: vec4<f32>;
    var phi_875_: vec4<f32>;
    var phi_886_: vec4<f32>;
    var phi_897_: vec4<f32>;
    var phi_912_: type_19;
    var phi_915_: type_19;
    var phi_917_: type_19;
    var phi_919_: type_19;
    var phi_921_: type_20;
    var phi_937_: bool;
    var phi_1191_: type_19;
    var phi_1194_: type_19;
    var phi_1196_: type_19;
    var phi_1198_: type_19;
    var phi_1200_: type_20;
    var phi_1417_: type_19;
    var phi_1420_: type_19;
    var phi_1422_: type_19;
    var phi_1424_: type_19;
    var phi_1426_: type_20;
    var phi_1442_: bool;
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
    var phi_1756_: u32;
    var phi_1758_: array<u32, 2>;
    var phi_1764_: array<u32, 2>;
    var phi_1817_: u32;
    var phi_1819_: array<u32, 2>;
    var phi_1825_: array<u32, 2>;
    var phi_1878_: u32;
    var phi_1880_: array<u32, 2>;
    var phi_1886_: array<u32, 2>;
    var phi_1939_: u32;
    var phi_1941_: array<u32, 2>;
    var phi_1947_: array<u32, 2>;
    var phi_2016_: u32;
    var phi_2018_: array<u32, 2>;
    var phi_2024_: array<u32, 2>;
    var phi_2077_: u32;
    var phi_2079_: array<u32, 2>;
    var phi_2085_: array<u32, 2>;
    var phi_2138_: u32;
    var phi_2140_: array<u32, 2>;
    var phi_2146_: array<u32, 2>;
    var phi_2199_: u32;
    var phi_2201_: array<u32, 2>;
    var phi_2207_: array<u32, 2>;
    var phi_2276_: u32;
    var phi_2278_: array<u32, 2>;
    var phi_2284_: array<u32, 2>;
    var phi_2337_: u32;
    var phi_2339_: array<u32, 2>;
    var phi_2345_: array<u32, 2>;
    var phi_2398_: u32;
    var phi_2400_: array<u32, 2>;
    var phi_2406_: array<u32, 2>;
    var phi_2459_: u32;
    var phi_2461_: array<u32, 2>;
    var phi_2467_: array<u32, 2>;
    var phi_2536_: u32;
    var phi_2538_: array<u32, 2>;
    var phi_2544_: array<u32, 2>;
    var phi_2597_: u32;
    var phi_2599_: array<u32, 2>;
    var phi_2605_: array<u32, 2>;
    var phi_2658_: u32;
    var phi_2660_: array<u32, 2>;
    var phi_2666_: array<u32, 2>;
    var phi_2719_: u32;
    var phi_2721_: array<u32, 2>;
    var phi_2727_: array<u32, 2>;
    var phi_2757_: u32;
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
                            let _e2656 = local_22;
                            phi_142_ = _e2656;
                            let _e2659 = local_23;
                            phi_145_ = _e2659;
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
                    let _e2677 = local_26;
                    phi_222_ = _e2677;
                    loop {
                        let _e178 = phi_217_;
                        let _e180 = phi_220_;
                        let _e182 = phi_222_;
                        if (_e180 < select(_e90, _e97, (_e97 < _e90))) {
                            if (_e180 == _e178) {
                                let _e2641 = global_4.member[((_e182 + 2u) * _e132)];
                                if _e142 {
                                    phi_2757_ = _e2641;
                                } else {
                                    let _e2644 = global_5.member[_e2641];
                                    phi_2757_ = _e2644;
                                }
                                let _e2646 = phi_2757_;
                                phi_218_ = _e2646;
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
                                    let _e766 = (_e83[0] * 4u);
                                    let _e769 = global_3.member.member_5;
                                    let _e772 = ((_e769 + (_e766 * _e53)) + _e83[1]);
                                    let _e773 = (_e60 - _e766);
                                    let _e777 = (_e772 + (select(_e773, 1u, (1u < _e773)) * _e53));
                                    let _e781 = (_e772 + (select(_e773, 2u, (2u < _e773)) * _e53));
                                    let _e785 = (_e772 + (select(_e773, 3u, (3u < _e773)) * _e53));
                                    let _e791 = (_e766 + 1u);
                                    let _e795 = (_e766 + 2u);
                                    let _e799 = (_e766 + 3u);
                                    if _e207 {
                                        let _e805 = global_6.member[(_e202 + _e772)];
                                        phi_864_ = _e805;
                                    } else {
                                        phi_864_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e807 = phi_864_;
                                    if _e207 {
                                        let _e815 = global_6.member[(_e202 + _e777)];
                                        phi_875_ = _e815;
                                    } else {
                                        phi_875_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e817 = phi_875_;
                                    if _e207 {
                                        let _e825 = global_6.member[(_e202 + _e781)];
                                        phi_886_ = _e825;
                                    } else {
                                        phi_886_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e827 = phi_886_;
                                    if _e207 {
                                        let _e835 = global_6.member[(_e202 + _e785)];
                                        phi_897_ = _e835;
                                    } else {
                                        phi_897_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e837 = phi_897_;
                                    let _e845 = ((_e766 * _e210) / 4u);
                                    let _e846 = ((select(_e60, _e791, (_e791 < _e60)) * _e210) / 4u);
                                    let _e847 = ((select(_e60, _e795, (_e795 < _e60)) * _e210) / 4u);
                                    let _e848 = ((select(_e60, _e799, (_e799 < _e60)) * _e210) / 4u);
                                    let _e849 = (_e212 / 4u);
                                    let _e850 = (_e210 / 4u);
                                    phi_912_ = type_19(_e837.x, _e837.y, _e837.z, _e837.w);
                                    phi_915_ = type_19(_e827.x, _e827.y, _e827.z, _e827.w);
                                    phi_917_ = type_19(_e817.x, _e817.y, _e817.z, _e817.w);
                                    phi_919_ = type_19(_e807.x, _e807.y, _e807.z, _e807.w);
                                    phi_921_ = type_20((_e192 / 4u), _e192, _e195);
                                    loop {
                                        let _e852 = phi_912_;
                                        let _e854 = phi_915_;
                                        let _e856 = phi_917_;
                                        let _e858 = phi_919_;
                                        let _e860 = phi_921_;
                                        local_43 = _e852;
                                        local_45 = _e854;
                                        local_47 = _e856;
                                        local_49 = _e858;
                                        local_51 = _e860;
                                        let _e862 = (4u * _e860.member);
                                        if (_e862 < _e860.member_2) {
                                            phi_937_ = select(((_e862 + 4u) > _e860.member_2), true, (_e862 < _e860.member_1));
                                        } else {
                                            phi_937_ = false;
                                        }
                                        let _e871 = phi_937_;
                                        if _e871 {
                                            let _e875 = global_7.member[(_e849 + _e860.member)];
                                            let _e882 = (_e860.member_2 - _e860.member_1);
                                            let _e883 = ((_e862 - _e860.member_1) < _e882);
                                            let _e884 = select(0f, _e875.x, _e883);
                                            let _e887 = (((_e862 + 1u) - _e860.member_1) < _e882);
                                            let _e888 = select(0f, _e875.y, _e887);
                                            let _e891 = (((_e862 + 2u) - _e860.member_1) < _e882);
                                            let _e892 = select(0f, _e875.z, _e891);
                                            let _e895 = (((_e862 + 3u) - _e860.member_1) < _e882);
                                            let _e896 = select(0f, _e875.w, _e895);
                                            let _e901 = global_7.member[((_e849 + _e850) + _e860.member)];
                                            let _e906 = select(0f, _e901.x, _e883);
                                            let _e907 = select(0f, _e901.y, _e887);
                                            let _e908 = select(0f, _e901.z, _e891);
                                            let _e909 = select(0f, _e901.w, _e895);
                                            let _e915 = global_7.member[((_e849 + (2u * _e850)) + _e860.member)];
                                            let _e920 = select(0f, _e915.x, _e883);
                                            let _e921 = select(0f, _e915.y, _e887);
                                            let _e922 = select(0f, _e915.z, _e891);
                                            let _e923 = select(0f, _e915.w, _e895);
                                            let _e929 = global_7.member[((_e849 + (3u * _e850)) + _e860.member)];
                                            let _e934 = select(0f, _e929.x, _e883);
                                            let _e935 = select(0f, _e929.y, _e887);
                                            let _e936 = select(0f, _e929.z, _e891);
                                            let _e937 = select(0f, _e929.w, _e895);
                                            let _e941 = global_9.member[(_e845 + _e860.member)];
                                            let _e946 = select(0f, _e941.x, _e883);
                                            let _e947 = select(0f, _e941.y, _e887);
                                            let _e948 = select(0f, _e941.z, _e891);
                                            let _e949 = select(0f, _e941.w, _e895);
                                            let _e953 = global_9.member[(_e846 + _e860.member)];
                                            let _e958 = select(0f, _e953.x, _e883);
                                            let _e959 = select(0f, _e953.y, _e887);
                                            let _e960 = select(0f, _e953.z, _e891);
                                            let _e961 = select(0f, _e953.w, _e895);
                                            let _e965 = global_9.member[(_e847 + _e860.member)];
                                            let _e970 = select(0f, _e965.x, _e883);
                                            let _e971 = select(0f, _e965.y, _e887);
                                            let _e972 = select(0f, _e965.z, _e891);
                                            let _e973 = select(0f, _e965.w, _e895);
                                            let _e977 = global_9.member[(_e848 + _e860.member)];
                                            let _e982 = select(0f, _e977.x, _e883);
                                            let _e983 = select(0f, _e977.y, _e887);
                                            let _e984 = select(0f, _e977.z, _e891);
                                            let _e985 = select(0f, _e977.w, _e895);
                                            local_38 = type_19(((_e985 * _e896) + ((_e984 * _e892) + ((_e983 * _e888) + ((_e982 * _e884) + _e852.member)))), ((_e985 * _e909) + ((_e984 * _e908) + ((_e983 * _e907) + ((_e982 * _e906) + _e852.member_1)))), ((_e985 * _e923) + ((_e984 * _e922) + ((_e983 * _e921) + ((_e982 * _e920) + _e852.member_2)))), ((_e985 * _e937) + ((_e984 * _e936) + ((_e983 * _e935) + ((_e982 * _e934) + _e852.member_3)))));
                                            local_39 = type_19(((_e973 * _e896) + ((_e972 * _e892) + ((_e971 * _e888) + ((_e970 * _e884) + _e854.member)))), ((_e973 * _e909) + ((_e972 * _e908) + ((_e971 * _e907) + ((_e970 * _e906) + _e854.member_1)))), ((_e973 * _e923) + ((_e972 * _e922) + ((_e971 * _e921) + ((_e970 * _e920) + _e854.member_2)))), ((_e973 * _e937) + ((_e972 * _e936) + ((_e971 * _e935) + ((_e970 * _e934) + _e854.member_3)))));
                                            local_40 = type_19(((_e961 * _e896) + ((_e960 * _e892) + ((_e959 * _e888) + ((_e958 * _e884) + _e856.member)))), ((_e961 * _e909) + ((_e960 * _e908) + ((_e959 * _e907) + ((_e958 * _e906) + _e856.member_1)))), ((_e961 * _e923) + ((_e960 * _e922) + ((_e959 * _e921) + ((_e958 * _e920) + _e856.member_2)))), ((_e961 * _e937) + ((_e960 * _e936) + ((_e959 * _e935) + ((_e958 * _e934) + _e856.member_3)))));
                                            local_41 = type_19(((_e949 * _e896) + ((_e948 * _e892) + ((_e947 * _e888) + ((_e946 * _e884) + _e858.member)))), ((_e949 * _e909) + ((_e948 * _e908) + ((_e947 * _e907) + ((_e946 * _e906) + _e858.member_1)))), ((_e949 * _e923) + ((_e948 * _e922) + ((_e947 * _e921) + ((_e946 * _e920) + _e858.member_2)))), ((_e949 * _e937) + ((_e948 * _e936) + ((_e947 * _e935) + ((_e946 * _e934) + _e858.member_3)))));
                                            local_42 = type_20((_e860.member + 1u), _e860.member_1, _e860.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2732 = local_38;
                                            phi_912_ = _e2732;
                                            let _e2735 = local_39;
                                            phi_915_ = _e2735;
                                            let _e2738 = local_40;
                                            phi_917_ = _e2738;
                                            let _e2741 = local_41;
                                            phi_919_ = _e2741;
                                            let _e2744 = local_42;
                                            phi_921_ = _e2744;
                                        }
                                    }
                                    let _e2748 = local_43;
                                    phi_1191_ = _e2748;
                                    let _e2753 = local_45;
                                    phi_1194_ = _e2753;
                                    let _e2758 = local_47;
                                    phi_1196_ = _e2758;
                                    let _e2763 = local_49;
                                    phi_1198_ = _e2763;
                                    let _e2768 = local_51;
                                    phi_1200_ = _e2768;
                                    loop {
                                        let _e1140 = phi_1191_;
                                        let _e1142 = phi_1194_;
                                        let _e1144 = phi_1196_;
                                        let _e1146 = phi_1198_;
                                        let _e1148 = phi_1200_;
                                        local_53 = _e1140;
                                        local_55 = _e1142;
                                        local_57 = _e1144;
                                        local_59 = _e1146;
                                        local_61 = _e1148;
                                        if !((((4u * _e1148.member) + 4u) > _e1148.member_2)) {
                                            let _e1158 = global_7.member[(_e849 + _e1148.member)];
                                            let _e1167 = global_7.member[((_e849 + _e850) + _e1148.member)];
                                            let _e1177 = global_7.member[((_e849 + (2u * _e850)) + _e1148.member)];
                                            let _e1187 = global_7.member[((_e849 + (3u * _e850)) + _e1148.member)];
                                            let _e1195 = global_9.member[(_e845 + _e1148.member)];
                                            let _e1203 = global_9.member[(_e846 + _e1148.member)];
                                            let _e1211 = global_9.member[(_e847 + _e1148.member)];
                                            let _e1219 = global_9.member[(_e848 + _e1148.member)];
                                            local_44 = type_19(((_e1219.w * _e1158.w) + ((_e1219.z * _e1158.z) + ((_e1219.y * _e1158.y) + ((_e1219.x * _e1158.x) + _e1140.member)))), ((_e1219.w * _e1167.w) + ((_e1219.z * _e1167.z) + ((_e1219.y * _e1167.y) + ((_e1219.x * _e1167.x) + _e1140.member_1)))), ((_e1219.w * _e1177.w) + ((_e1219.z * _e1177.z) + ((_e1219.y * _e1177.y) + ((_e1219.x * _e1177.x) + _e1140.member_2)))), ((_e1219.w * _e1187.w) + ((_e1219.z * _e1187.z) + ((_e1219.y * _e1187.y) + ((_e1219.x * _e1187.x) + _e1140.member_3)))));
                                            local_46 = type_19(((_e1211.w * _e1158.w) + ((_e1211.z * _e1158.z) + ((_e1211.y * _e1158.y) + ((_e1211.x * _e1158.x) + _e1142.member)))), ((_e1211.w * _e1167.w) + ((_e1211.z * _e1167.z) + ((_e1211.y * _e1167.y) + ((_e1211.x * _e1167.x) + _e1142.member_1)))), ((_e1211.w * _e1177.w) + ((_e1211.z * _e1177.z) + ((_e1211.y * _e1177.y) + ((_e1211.x * _e1177.x) + _e1142.member_2)))), ((_e1211.w * _e1187.w) + ((_e1211.z * _e1187.z) + ((_e1211.y * _e1187.y) + ((_e1211.x * _e1187.x) + _e1142.member_3)))));
                                            local_48 = type_19(((_e1203.w * _e1158.w) + ((_e1203.z * _e1158.z) + ((_e1203.y * _e1158.y) + ((_e1203.x * _e1158.x) + _e1144.member)))), ((_e1203.w * _e1167.w) + ((_e1203.z * _e1167.z) + ((_e1203.y * _e1167.y) + ((_e1203.x * _e1167.x) + _e1144.member_1)))), ((_e1203.w * _e1177.w) + ((_e1203.z * _e1177.z) + ((_e1203.y * _e1177.y) + ((_e1203.x * _e1177.x) + _e1144.member_2)))), ((_e1203.w * _e1187.w) + ((_e1203.z * _e1187.z) + ((_e1203.y * _e1187.y) + ((_e1203.x * _e1187.x) + _e1144.member_3)))));
                                            local_50 = type_19(((_e1195.w * _e1158.w) + ((_e1195.z * _e1158.z) + ((_e1195.y * _e1158.y) + ((_e1195.x * _e1158.x) + _e1146.member)))), ((_e1195.w * _e1167.w) + ((_e1195.z * _e1167.z) + ((_e1195.y * _e1167.y) + ((_e1195.x * _e1167.x) + _e1146.member_1)))), ((_e1195.w * _e1177.w) + ((_e1195.z * _e1177.z) + ((_e1195.y * _e1177.y) + ((_e1195.x * _e1177.x) + _e1146.member_2)))), ((_e1195.w * _e1187.w) + ((_e1195.z * _e1187.z) + ((_e1195.y * _e1187.y) + ((_e1195.x * _e1187.x) + _e1146.member_3)))));
                                            local_52 = type_20((_e1148.member + 1u), _e1148.member_1, _e1148.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2750 = local_44;
                                            phi_1191_ = _e2750;
                                            let _e2755 = local_46;
                                            phi_1194_ = _e2755;
                                            let _e2760 = local_48;
                                            phi_1196_ = _e2760;
                                            let _e2765 = local_50;
                                            phi_1198_ = _e2765;
                                            let _e2770 = local_52;
                                            phi_1200_ = _e2770;
                                        }
                                    }
                                    let _e2773 = local_53;
                                    phi_1417_ = _e2773;
                                    let _e2778 = local_55;
                                    phi_1420_ = _e2778;
                                    let _e2783 = local_57;
                                    phi_1422_ = _e2783;
                                    let _e2788 = local_59;
                                    phi_1424_ = _e2788;
                                    let _e2793 = local_61;
                                    phi_1426_ = _e2793;
                                    loop {
                                        let _e1378 = phi_1417_;
                                        let _e1380 = phi_1420_;
                                        let _e1382 = phi_1422_;
                                        let _e1384 = phi_1424_;
                                        let _e1386 = phi_1426_;
                                        local_6 = _e1384;
                                        local_7 = _e1384;
                                        local_8 = _e1384;
                                        local_9 = _e1384;
                                        local_10 = _e1382;
                                        local_11 = _e1382;
                                        local_12 = _e1382;
                                        local_13 = _e1382;
                                        local_14 = _e1380;
                                        local_15 = _e1380;
                                        local_16 = _e1380;
                                        local_17 = _e1380;
                                        local_18 = _e1378;
                                        local_19 = _e1378;
                                        local_20 = _e1378;
                                        local_21 = _e1378;
                                        let _e1388 = (4u * _e1386.member);
                                        if (_e1388 < _e1386.member_2) {
                                            phi_1442_ = select(((_e1388 + 4u) > _e1386.member_2), true, (_e1388 < _e1386.member_1));
                                        } else {
                                            phi_1442_ = false;
                                        }
                                        let _e1397 = phi_1442_;
                                        if _e1397 {
                                            let _e1401 = global_7.member[(_e849 + _e1386.member)];
                                            let _e1408 = (_e1386.member_2 - _e1386.member_1);
                                            let _e1409 = ((_e1388 - _e1386.member_1) < _e1408);
                                            let _e1410 = select(0f, _e1401.x, _e1409);
                                            let _e1413 = (((_e1388 + 1u) - _e1386.member_1) < _e1408);
                                            let _e1414 = select(0f, _e1401.y, _e1413);
                                            let _e1417 = (((_e1388 + 2u) - _e1386.member_1) < _e1408);
                                            let _e1418 = select(0f, _e1401.z, _e1417);
                                            let _e1421 = (((_e1388 + 3u) - _e1386.member_1) < _e1408);
                                            let _e1422 = select(0f, _e1401.w, _e1421);
                                            let _e1427 = global_7.member[((_e849 + _e850) + _e1386.member)];
                                            let _e1432 = select(0f, _e1427.x, _e1409);
                                            let _e1433 = select(0f, _e1427.y, _e1413);
                                            let _e1434 = select(0f, _e1427.z, _e1417);
                                            let _e1435 = select(0f, _e1427.w, _e1421);
                                            let _e1441 = global_7.member[((_e849 + (2u * _e850)) + _e1386.member)];
                                            let _e1446 = select(0f, _e1441.x, _e1409);
                                            let _e1447 = select(0f, _e1441.y, _e1413);
                                            let _e1448 = select(0f, _e1441.z, _e1417);
                                            let _e1449 = select(0f, _e1441.w, _e1421);
                                            let _e1455 = global_7.member[((_e849 + (3u * _e850)) + _e1386.member)];
                                            let _e1460 = select(0f, _e1455.x, _e1409);
                                            let _e1461 = select(0f, _e1455.y, _e1413);
                                            let _e1462 = select(0f, _e1455.z, _e1417);
                                            let _e1463 = select(0f, _e1455.w, _e1421);
                                            let _e1467 = global_9.member[(_e845 + _e1386.member)];
                                            let _e1472 = select(0f, _e1467.x, _e1409);
                                            let _e1473 = select(0f, _e1467.y, _e1413);
                                            let _e1474 = select(0f, _e1467.z, _e1417);
                                            let _e1475 = select(0f, _e1467.w, _e1421);
                                            let _e1479 = global_9.member[(_e846 + _e1386.member)];
                                            let _e1484 = select(0f, _e1479.x, _e1409);
                                            let _e1485 = select(0f, _e1479.y, _e1413);
                                            let _e1486 = select(0f, _e1479.z, _e1417);
                                            let _e1487 = select(0f, _e1479.w, _e1421);
                                            let _e1491 = global_9.member[(_e847 + _e1386.member)];
                                            let _e1496 = select(0f, _e1491.x, _e1409);
                                            let _e1497 = select(0f, _e1491.y, _e1413);
                                            let _e1498 = select(0f, _e1491.z, _e1417);
                                            let _e1499 = select(0f, _e1491.w, _e1421);
                                            let _e1503 = global_9.member[(_e848 + _e1386.member)];
                                            let _e1508 = select(0f, _e1503.x, _e1409);
                                            let _e1509 = select(0f, _e1503.y, _e1413);
                                            let _e1510 = select(0f, _e1503.z, _e1417);
                                            let _e1511 = select(0f, _e1503.w, _e1421);
                                            local_54 = type_19(((_e1511 * _e1422) + ((_e1510 * _e1418) + ((_e1509 * _e1414) + ((_e1508 * _e1410) + _e1378.member)))), ((_e1511 * _e1435) + ((_e1510 * _e1434) + ((_e1509 * _e1433) + ((_e1508 * _e1432) + _e1378.member_1)))), ((_e1511 * _e1449) + ((_e1510 * _e1448) + ((_e1509 * _e1447) + ((_e1508 * _e1446) + _e1378.member_2)))), ((_e1511 * _e1463) + ((_e1510 * _e1462) + ((_e1509 * _e1461) + ((_e1508 * _e1460) + _e1378.member_3)))));
                                            local_56 = type_19(((_e1499 * _e1422) + ((_e1498 * _e1418) + ((_e1497 * _e1414) + ((_e1496 * _e1410) + _e1380.member)))), ((_e1499 * _e1435) + ((_e1498 * _e1434) + ((_e1497 * _e1433) + ((_e1496 * _e1432) + _e1380.member_1)))), ((_e1499 * _e1449) + ((_e1498 * _e1448) + ((_e1497 * _e1447) + ((_e1496 * _e1446) + _e1380.member_2)))), ((_e1499 * _e1463) + ((_e1498 * _e1462) + ((_e1497 * _e1461) + ((_e1496 * _e1460) + _e1380.member_3)))));
                                            local_58 = type_19(((_e1487 * _e1422) + ((_e1486 * _e1418) + ((_e1485 * _e1414) + ((_e1484 * _e1410) + _e1382.member)))), ((_e1487 * _e1435) + ((_e1486 * _e1434) + ((_e1485 * _e1433) + ((_e1484 * _e1432) + _e1382.member_1)))), ((_e1487 * _e1449) + ((_e1486 * _e1448) + ((_e1485 * _e1447) + ((_e1484 * _e1446) + _e1382.member_2)))), ((_e1487 * _e1463) + ((_e1486 * _e1462) + ((_e1485 * _e1461) + ((_e1484 * _e1460) + _e1382.member_3)))));
                                            local_60 = type_19(((_e1475 * _e1422) + ((_e1474 * _e1418) + ((_e1473 * _e1414) + ((_e1472 * _e1410) + _e1384.member)))), ((_e1475 * _e1435) + ((_e1474 * _e1434) + ((_e1473 * _e1433) + ((_e1472 * _e1432) + _e1384.member_1)))), ((_e1475 * _e1449) + ((_e1474 * _e1448) + ((_e1473 * _e1447) + ((_e1472 * _e1446) + _e1384.member_2)))), ((_e1475 * _e1463) + ((_e1474 * _e1462) + ((_e1473 * _e1461) + ((_e1472 * _e1460) + _e1384.member_3)))));
                                            local_62 = type_20((_e1386.member + 1u), _e1386.member_1, _e1386.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2775 = local_54;
                                            phi_1417_ = _e2775;
                                            let _e2780 = local_56;
                                            phi_1420_ = _e2780;
                                            let _e2785 = local_58;
                                            phi_1422_ = _e2785;
                                            let _e2790 = local_60;
                                            phi_1424_ = _e2790;
                                            let _e2795 = local_62;
                                            phi_1426_ = _e2795;
                                        }
                                    }
                                    let _e1666 = local_6;
                                    let _e1669 = local_7;
                                    let _e1672 = local_8;
                                    let _e1675 = local_9;
                                    let _e1678 = local_10;
                                    let _e1681 = local_11;
                                    let _e1684 = local_12;
                                    let _e1687 = local_13;
                                    let _e1690 = local_14;
                                    let _e1693 = local_15;
                                    let _e1696 = local_16;
                                    let _e1699 = local_17;
                                    let _e1702 = local_18;
                                    let _e1705 = local_19;
                                    let _e1708 = local_20;
                                    let _e1711 = local_21;
                                    if _e205 {
                                        let _e1722 = (4u * _e201);
                                        let _e1723 = (4u * _e772);
                                        let _e1724 = bitcast<u32>((_e1666.member + 0f));
                                        let _e1727 = ((_e1724 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1727 == 0u) {
                                        } else {
                                            let _e1730 = (_e1727 % 16u);
                                            let _e1732 = ((_e1724 & 8388607u) | 8388608u);
                                            let _e1735 = (_e1732 << bitcast<u32>((_e1730 & 31u)));
                                            let _e1741 = ((_e1732 >> bitcast<u32>(((31u - _e1730) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1724 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1758_ = array<u32, 2>(_e1735, _e1741);
                                            } else {
                                                let _e1747 = (~(_e1735) + 1u);
                                                if (_e1747 == 0u) {
                                                    phi_1756_ = (~(_e1741) + 1u);
                                                } else {
                                                    phi_1756_ = ~(_e1741);
                                                }
                                                let _e1753 = phi_1756_;
                                                phi_1758_ = array<u32, 2>(_e1747, _e1753);
                                            }
                                            let _e1756 = phi_1758_;
                                            let _e1757 = (_e1727 < 255u);
                                            if _e1757 {
                                                phi_1764_ = _e1756;
                                            } else {
                                                phi_1764_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1760 = phi_1764_;
                                            let _e1765 = (2u * ((select(16u, (_e1727 / 16u), _e1757) * _e1722) + _e1723));
                                            let _e1768 = atomicAdd((&global_8.member[_e1765]), _e1760[0]);
                                            let _e1772 = (_e1760[1] + select(0u, 1u, ((_e1768 + _e1760[0]) < _e1760[0])));
                                            if (_e1772 == 0u) {
                                            } else {
                                                let _e1777 = atomicAdd((&global_8.member[(_e1765 + 1u)]), _e1772);
                                            }
                                        }
                                        let _e1779 = bitcast<u32>((_e1669.member_1 + 0f));
                                        let _e1782 = ((_e1779 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1782 == 0u) {
                                        } else {
                                            let _e1785 = (_e1782 % 16u);
                                            let _e1787 = ((_e1779 & 8388607u) | 8388608u);
                                            let _e1790 = (_e1787 << bitcast<u32>((_e1785 & 31u)));
                                            let _e1796 = ((_e1787 >> bitcast<u32>(((31u - _e1785) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1779 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1819_ = array<u32, 2>(_e1790, _e1796);
                                            } else {
                                                let _e1802 = (~(_e1790) + 1u);
                                                if (_e1802 == 0u) {
                                                    phi_1817_ = (~(_e1796) + 1u);
                                                } else {
                                                    phi_1817_ = ~(_e1796);
                                                }
                                                let _e1808 = phi_1817_;
                                                phi_1819_ = array<u32, 2>(_e1802, _e1808);
                                            }
                                            let _e1811 = phi_1819_;
                                            let _e1812 = (_e1782 < 255u);
                                            if _e1812 {
                                                phi_1825_ = _e1811;
                                            } else {
                                                phi_1825_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1815 = phi_1825_;
                                            let _e1820 = (2u * ((select(16u, (_e1782 / 16u), _e1812) * _e1722) + (_e1723 + 1u)));
                                            let _e1823 = atomicAdd((&global_8.member[_e1820]), _e1815[0]);
                                            let _e1827 = (_e1815[1] + select(0u, 1u, ((_e1823 + _e1815[0]) < _e1815[0])));
                                            if (_e1827 == 0u) {
                                            } else {
                                                let _e1832 = atomicAdd((&global_8.member[(_e1820 + 1u)]), _e1827);
                                            }
                                        }
                                        let _e1834 = bitcast<u32>((_e1672.member_2 + 0f));
                                        let _e1837 = ((_e1834 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1837 == 0u) {
                                        } else {
                                            let _e1840 = (_e1837 % 16u);
                                            let _e1842 = ((_e1834 & 8388607u) | 8388608u);
                                            let _e1845 = (_e1842 << bitcast<u32>((_e1840 & 31u)));
                                            let _e1851 = ((_e1842 >> bitcast<u32>(((31u - _e1840) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1834 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1880_ = array<u32, 2>(_e1845, _e1851);
                                            } else {
                                                let _e1857 = (~(_e1845) + 1u);
                                                if (_e1857 == 0u) {
                                                    phi_1878_ = (~(_e1851) + 1u);
                                                } else {
                                                    phi_1878_ = ~(_e1851);
                                                }
                                                let _e1863 = phi_1878_;
                                                phi_1880_ = array<u32, 2>(_e1857, _e1863);
                                            }
                                            let _e1866 = phi_1880_;
                                            let _e1867 = (_e1837 < 255u);
                                            if _e1867 {
                                                phi_1886_ = _e1866;
                                            } else {
                                                phi_1886_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1870 = phi_1886_;
                                            let _e1875 = (2u * ((select(16u, (_e1837 / 16u), _e1867) * _e1722) + (_e1723 + 2u)));
                                            let _e1878 = atomicAdd((&global_8.member[_e1875]), _e1870[0]);
                                            let _e1882 = (_e1870[1] + select(0u, 1u, ((_e1878 + _e1870[0]) < _e1870[0])));
                                            if (_e1882 == 0u) {
                                            } else {
                                                let _e1887 = atomicAdd((&global_8.member[(_e1875 + 1u)]), _e1882);
                                            }
                                        }
                                        let _e1889 = bitcast<u32>((_e1675.member_3 + 0f));
                                        let _e1892 = ((_e1889 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1892 == 0u) {
                                        } else {
                                            let _e1895 = (_e1892 % 16u);
                                            let _e1897 = ((_e1889 & 8388607u) | 8388608u);
                                            let _e1900 = (_e1897 << bitcast<u32>((_e1895 & 31u)));
                                            let _e1906 = ((_e1897 >> bitcast<u32>(((31u - _e1895) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1889 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1941_ = array<u32, 2>(_e1900, _e1906);
                                            } else {
                                                let _e1912 = (~(_e1900) + 1u);
                                                if (_e1912 == 0u) {
                                                    phi_1939_ = (~(_e1906) + 1u);
                                                } else {
                                                    phi_1939_ = ~(_e1906);
                                                }
                                                let _e1918 = phi_1939_;
                                                phi_1941_ = array<u32, 2>(_e1912, _e1918);
                                            }
                                            let _e1921 = phi_1941_;
                                            let _e1922 = (_e1892 < 255u);
                                            if _e1922 {
                                                phi_1947_ = _e1921;
                                            } else {
                                                phi_1947_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1925 = phi_1947_;
                                            let _e1930 = (2u * ((select(16u, (_e1892 / 16u), _e1922) * _e1722) + (_e1723 + 3u)));
                                            let _e1933 = atomicAdd((&global_8.member[_e1930]), _e1925[0]);
                                            let _e1937 = (_e1925[1] + select(0u, 1u, ((_e1933 + _e1925[0]) < _e1925[0])));
                                            if (_e1937 == 0u) {
                                            } else {
                                                let _e1942 = atomicAdd((&global_8.member[(_e1930 + 1u)]), _e1937);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e204 + _e772)] = (vec4<f32>(_e1666.member, _e1669.member_1, _e1672.member_2, _e1675.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                    }
                                    if (_e791 < _e59) {
                                        if _e205 {
                                            let _e1953 = (4u * _e201);
                                            let _e1954 = (4u * _e777);
                                            let _e1955 = bitcast<u32>((_e1678.member + 0f));
                                            let _e1958 = ((_e1955 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1958 == 0u) {
                                            } else {
                                                let _e1961 = (_e1958 % 16u);
                                                let _e1963 = ((_e1955 & 8388607u) | 8388608u);
                                                let _e1966 = (_e1963 << bitcast<u32>((_e1961 & 31u)));
                                                let _e1972 = ((_e1963 >> bitcast<u32>(((31u - _e1961) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1955 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2018_ = array<u32, 2>(_e1966, _e1972);
                                                } else {
                                                    let _e1978 = (~(_e1966) + 1u);
                                                    if (_e1978 == 0u) {
                                                        phi_2016_ = (~(_e1972) + 1u);
                                                    } else {
                                                        phi_2016_ = ~(_e1972);
                                                    }
                                                    let _e1984 = phi_2016_;
                                                    phi_2018_ = array<u32, 2>(_e1978, _e1984);
                                                }
                                                let _e1987 = phi_2018_;
                                                let _e1988 = (_e1958 < 255u);
                                                if _e1988 {
                                                    phi_2024_ = _e1987;
                                                } else {
                                                    phi_2024_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1991 = phi_2024_;
                                                let _e1996 = (2u * ((select(16u, (_e1958 / 16u), _e1988) * _e1953) + _e1954));
                                                let _e1999 = atomicAdd((&global_8.member[_e1996]), _e1991[0]);
                                                let _e2003 = (_e1991[1] + select(0u, 1u, ((_e1999 + _e1991[0]) < _e1991[0])));
                                                if (_e2003 == 0u) {
                                                } else {
                                                    let _e2008 = atomicAdd((&global_8.member[(_e1996 + 1u)]), _e2003);
                                                }
                                            }
                                            let _e2010 = bitcast<u32>((_e1681.member_1 + 0f));
                                            let _e2013 = ((_e2010 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2013 == 0u) {
                                            } else {
                                                let _e2016 = (_e2013 % 16u);
                                                let _e2018 = ((_e2010 & 8388607u) | 8388608u);
                                                let _e2021 = (_e2018 << bitcast<u32>((_e2016 & 31u)));
                                                let _e2027 = ((_e2018 >> bitcast<u32>(((31u - _e2016) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2010 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2079_ = array<u32, 2>(_e2021, _e2027);
                                                } else {
                                                    let _e2033 = (~(_e2021) + 1u);
                                                    if (_e2033 == 0u) {
                                                        phi_2077_ = (~(_e2027) + 1u);
                                                    } else {
                                                        phi_2077_ = ~(_e2027);
                                                    }
                                                    let _e2039 = phi_2077_;
                                                    phi_2079_ = array<u32, 2>(_e2033, _e2039);
                                                }
                                                let _e2042 = phi_2079_;
                                                let _e2043 = (_e2013 < 255u);
                                                if _e2043 {
                                                    phi_2085_ = _e2042;
                                                } else {
                                                    phi_2085_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2046 = phi_2085_;
                                                let _e2051 = (2u * ((select(16u, (_e2013 / 16u), _e2043) * _e1953) + (_e1954 + 1u)));
                                                let _e2054 = atomicAdd((&global_8.member[_e2051]), _e2046[0]);
                                                let _e2058 = (_e2046[1] + select(0u, 1u, ((_e2054 + _e2046[0]) < _e2046[0])));
                                                if (_e2058 == 0u) {
                                                } else {
                                                    let _e2063 = atomicAdd((&global_8.member[(_e2051 + 1u)]), _e2058);
                                                }
                                            }
                                            let _e2065 = bitcast<u32>((_e1684.member_2 + 0f));
                                            let _e2068 = ((_e2065 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2068 == 0u) {
                                            } else {
                                                let _e2071 = (_e2068 % 16u);
                                                let _e2073 = ((_e2065 & 8388607u) | 8388608u);
                                                let _e2076 = (_e2073 << bitcast<u32>((_e2071 & 31u)));
                                                let _e2082 = ((_e2073 >> bitcast<u32>(((31u - _e2071) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2065 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2140_ = array<u32, 2>(_e2076, _e2082);
                                                } else {
                                                    let _e2088 = (~(_e2076) + 1u);
                                                    if (_e2088 == 0u) {
                                                        phi_2138_ = (~(_e2082) + 1u);
                                                    } else {
                                                        phi_2138_ = ~(_e2082);
                                                    }
                                                    let _e2094 = phi_2138_;
                                                    phi_2140_ = array<u32, 2>(_e2088, _e2094);
                                                }
                                                let _e2097 = phi_2140_;
                                                let _e2098 = (_e2068 < 255u);
                                                if _e2098 {
                                                    phi_2146_ = _e2097;
                                                } else {
                                                    phi_2146_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2101 = phi_2146_;
                                                let _e2106 = (2u * ((select(16u, (_e2068 / 16u), _e2098) * _e1953) + (_e1954 + 2u)));
                                                let _e2109 = atomicAdd((&global_8.member[_e2106]), _e2101[0]);
                                                let _e2113 = (_e2101[1] + select(0u, 1u, ((_e2109 + _e2101[0]) < _e2101[0])));
                                                if (_e2113 == 0u) {
                                                } else {
                                                    let _e2118 = atomicAdd((&global_8.member[(_e2106 + 1u)]), _e2113);
                                                }
                                            }
                                            let _e2120 = bitcast<u32>((_e1687.member_3 + 0f));
                                            let _e2123 = ((_e2120 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2123 == 0u) {
                                            } else {
                                                let _e2126 = (_e2123 % 16u);
                                                let _e2128 = ((_e2120 & 8388607u) | 8388608u);
                                                let _e2131 = (_e2128 << bitcast<u32>((_e2126 & 31u)));
                                                let _e2137 = ((_e2128 >> bitcast<u32>(((31u - _e2126) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2120 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2201_ = array<u32, 2>(_e2131, _e2137);
                                                } else {
                                                    let _e2143 = (~(_e2131) + 1u);
                                                    if (_e2143 == 0u) {
                                                        phi_2199_ = (~(_e2137) + 1u);
                                                    } else {
                                                        phi_2199_ = ~(_e2137);
                                                    }
                                                    let _e2149 = phi_2199_;
                                                    phi_2201_ = array<u32, 2>(_e2143, _e2149);
                                                }
                                                let _e2152 = phi_2201_;
                                                let _e2153 = (_e2123 < 255u);
                                                if _e2153 {
                                                    phi_2207_ = _e2152;
                                                } else {
                                                    phi_2207_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2156 = phi_2207_;
                                                let _e2161 = (2u * ((select(16u, (_e2123 / 16u), _e2153) * _e1953) + (_e1954 + 3u)));
                                                let _e2164 = atomicAdd((&global_8.member[_e2161]), _e2156[0]);
                                                let _e2168 = (_e2156[1] + select(0u, 1u, ((_e2164 + _e2156[0]) < _e2156[0])));
                                                if (_e2168 == 0u) {
                                                } else {
                                                    let _e2173 = atomicAdd((&global_8.member[(_e2161 + 1u)]), _e2168);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e777)] = (vec4<f32>(_e1678.member, _e1681.member_1, _e1684.member_2, _e1687.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                        }
                                    }
                                    if (_e795 < _e59) {
                                        if _e205 {
                                            let _e2184 = (4u * _e201);
                                            let _e2185 = (4u * _e781);
                                            let _e2186 = bitcast<u32>((_e1690.member + 0f));
                                            let _e2189 = ((_e2186 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2189 == 0u) {
                                            } else {
                                                let _e2192 = (_e2189 % 16u);
                                                let _e2194 = ((_e2186 & 8388607u) | 8388608u);
                                                let _e2197 = (_e2194 << bitcast<u32>((_e2192 & 31u)));
                                                let _e2203 = ((_e2194 >> bitcast<u32>(((31u - _e2192) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2186 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2278_ = array<u32, 2>(_e2197, _e2203);
                                                } else {
                                                    let _e2209 = (~(_e2197) + 1u);
                                                    if (_e2209 == 0u) {
                                                        phi_2276_ = (~(_e2203) + 1u);
                                                    } else {
                                                        phi_2276_ = ~(_e2203);
                                                    }
                                                    let _e2215 = phi_2276_;
                                                    phi_2278_ = array<u32, 2>(_e2209, _e2215);
                                                }
                                                let _e2218 = phi_2278_;
                                                let _e2219 = (_e2189 < 255u);
                                                if _e2219 {
                                                    phi_2284_ = _e2218;
                                                } else {
                                                    phi_2284_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2222 = phi_2284_;
                                                let _e2227 = (2u * ((select(16u, (_e2189 / 16u), _e2219) * _e2184) + _e2185));
                                                let _e2230 = atomicAdd((&global_8.member[_e2227]), _e2222[0]);
                                                let _e2234 = (_e2222[1] + select(0u, 1u, ((_e2230 + _e2222[0]) < _e2222[0])));
                                                if (_e2234 == 0u) {
                                                } else {
                                                    let _e2239 = atomicAdd((&global_8.member[(_e2227 + 1u)]), _e2234);
                                                }
                                            }
                                            let _e2241 = bitcast<u32>((_e1693.member_1 + 0f));
                                            let _e2244 = ((_e2241 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2244 == 0u) {
                                            } else {
                                                let _e2247 = (_e2244 % 16u);
                                                let _e2249 = ((_e2241 & 8388607u) | 8388608u);
                                                let _e2252 = (_e2249 << bitcast<u32>((_e2247 & 31u)));
                                                let _e2258 = ((_e2249 >> bitcast<u32>(((31u - _e2247) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2241 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2339_ = array<u32, 2>(_e2252, _e2258);
                                                } else {
                                                    let _e2264 = (~(_e2252) + 1u);
                                                    if (_e2264 == 0u) {
                                                        phi_2337_ = (~(_e2258) + 1u);
                                                    } else {
                                                        phi_2337_ = ~(_e2258);
                                                    }
                                                    let _e2270 = phi_2337_;
                                                    phi_2339_ = array<u32, 2>(_e2264, _e2270);
                                                }
                                                let _e2273 = phi_2339_;
                                                let _e2274 = (_e2244 < 255u);
                                                if _e2274 {
                                                    phi_2345_ = _e2273;
                                                } else {
                                                    phi_2345_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2277 = phi_2345_;
                                                let _e2282 = (2u * ((select(16u, (_e2244 / 16u), _e2274) * _e2184) + (_e2185 + 1u)));
                                                let _e2285 = atomicAdd((&global_8.member[_e2282]), _e2277[0]);
                                                let _e2289 = (_e2277[1] + select(0u, 1u, ((_e2285 + _e2277[0]) < _e2277[0])));
                                                if (_e2289 == 0u) {
                                                } else {
                                                    let _e2294 = atomicAdd((&global_8.member[(_e2282 + 1u)]), _e2289);
                                                }
                                            }
                                            let _e2296 = bitcast<u32>((_e1696.member_2 + 0f));
                                            let _e2299 = ((_e2296 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2299 == 0u) {
                                            } else {
                                                let _e2302 = (_e2299 % 16u);
                                                let _e2304 = ((_e2296 & 8388607u) | 8388608u);
                                                let _e2307 = (_e2304 << bitcast<u32>((_e2302 & 31u)));
                                                let _e2313 = ((_e2304 >> bitcast<u32>(((31u - _e2302) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2296 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2400_ = array<u32, 2>(_e2307, _e2313);
                                                } else {
                                                    let _e2319 = (~(_e2307) + 1u);
                                                    if (_e2319 == 0u) {
                                                        phi_2398_ = (~(_e2313) + 1u);
                                                    } else {
                                                        phi_2398_ = ~(_e2313);
                                                    }
                                                    let _e2325 = phi_2398_;
                                                    phi_2400_ = array<u32, 2>(_e2319, _e2325);
                                                }
                                                let _e2328 = phi_2400_;
                                                let _e2329 = (_e2299 < 255u);
                                                if _e2329 {
                                                    phi_2406_ = _e2328;
                                                } else {
                                                    phi_2406_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2332 = phi_2406_;
                                                let _e2337 = (2u * ((select(16u, (_e2299 / 16u), _e2329) * _e2184) + (_e2185 + 2u)));
                                                let _e2340 = atomicAdd((&global_8.member[_e2337]), _e2332[0]);
                                                let _e2344 = (_e2332[1] + select(0u, 1u, ((_e2340 + _e2332[0]) < _e2332[0])));
                                                if (_e2344 == 0u) {
                                                } else {
                                                    let _e2349 = atomicAdd((&global_8.member[(_e2337 + 1u)]), _e2344);
                                                }
                                            }
                                            let _e2351 = bitcast<u32>((_e1699.member_3 + 0f));
                                            let _e2354 = ((_e2351 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2354 == 0u) {
                                            } else {
                                                let _e2357 = (_e2354 % 16u);
                                                let _e2359 = ((_e2351 & 8388607u) | 8388608u);
                                                let _e2362 = (_e2359 << bitcast<u32>((_e2357 & 31u)));
                                                let _e2368 = ((_e2359 >> bitcast<u32>(((31u - _e2357) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2351 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2461_ = array<u32, 2>(_e2362, _e2368);
                                                } else {
                                                    let _e2374 = (~(_e2362) + 1u);
                                                    if (_e2374 == 0u) {
                                                        phi_2459_ = (~(_e2368) + 1u);
                                                    } else {
                                                        phi_2459_ = ~(_e2368);
                                                    }
                                                    let _e2380 = phi_2459_;
                                                    phi_2461_ = array<u32, 2>(_e2374, _e2380);
                                                }
                                                let _e2383 = phi_2461_;
                                                let _e2384 = (_e2354 < 255u);
                                                if _e2384 {
                                                    phi_2467_ = _e2383;
                                                } else {
                                                    phi_2467_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2387 = phi_2467_;
                                                let _e2392 = (2u * ((select(16u, (_e2354 / 16u), _e2384) * _e2184) + (_e2185 + 3u)));
                                                let _e2395 = atomicAdd((&global_8.member[_e2392]), _e2387[0]);
                                                let _e2399 = (_e2387[1] + select(0u, 1u, ((_e2395 + _e2387[0]) < _e2387[0])));
                                                if (_e2399 == 0u) {
                                                } else {
                                                    let _e2404 = atomicAdd((&global_8.member[(_e2392 + 1u)]), _e2399);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e781)] = (vec4<f32>(_e1690.member, _e1693.member_1, _e1696.member_2, _e1699.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                        }
                                    }
                                    if (_e799 < _e59) {
                                        if _e205 {
                                            let _e2415 = (4u * _e201);
                                            let _e2416 = (4u * _e785);
                                            let _e2417 = bitcast<u32>((_e1702.member + 0f));
                                            let _e2420 = ((_e2417 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2420 == 0u) {
                                            } else {
                                                let _e2423 = (_e2420 % 16u);
                                                let _e2425 = ((_e2417 & 8388607u) | 8388608u);
                                                let _e2428 = (_e2425 << bitcast<u32>((_e2423 & 31u)));
                                                let _e2434 = ((_e2425 >> bitcast<u32>(((31u - _e2423) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2417 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2538_ = array<u32, 2>(_e2428, _e2434);
                                                } else {
                                                    let _e2440 = (~(_e2428) + 1u);
                                                    if (_e2440 == 0u) {
                                                        phi_2536_ = (~(_e2434) + 1u);
                                                    } else {
                                                        phi_2536_ = ~(_e2434);
                                                    }
                                                    let _e2446 = phi_2536_;
                                                    phi_2538_ = array<u32, 2>(_e2440, _e2446);
                                                }
                                                let _e2449 = phi_2538_;
                                                let _e2450 = (_e2420 < 255u);
                                                if _e2450 {
                                                    phi_2544_ = _e2449;
                                                } else {
                                                    phi_2544_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2453 = phi_2544_;
                                                let _e2458 = (2u * ((select(16u, (_e2420 / 16u), _e2450) * _e2415) + _e2416));
                                                let _e2461 = atomicAdd((&global_8.member[_e2458]), _e2453[0]);
                                                let _e2465 = (_e2453[1] + select(0u, 1u, ((_e2461 + _e2453[0]) < _e2453[0])));
                                                if (_e2465 == 0u) {
                                                } else {
                                                    let _e2470 = atomicAdd((&global_8.member[(_e2458 + 1u)]), _e2465);
                                                }
                                            }
                                            let _e2472 = bitcast<u32>((_e1705.member_1 + 0f));
                                            let _e2475 = ((_e2472 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2475 == 0u) {
                                            } else {
                                                let _e2478 = (_e2475 % 16u);
                                                let _e2480 = ((_e2472 & 8388607u) | 8388608u);
                                                let _e2483 = (_e2480 << bitcast<u32>((_e2478 & 31u)));
                                                let _e2489 = ((_e2480 >> bitcast<u32>(((31u - _e2478) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2472 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2599_ = array<u32, 2>(_e2483, _e2489);
                                                } else {
                                                    let _e2495 = (~(_e2483) + 1u);
                                                    if (_e2495 == 0u) {
                                                        phi_2597_ = (~(_e2489) + 1u);
                                                    } else {
                                                        phi_2597_ = ~(_e2489);
                                                    }
                                                    let _e2501 = phi_2597_;
                                                    phi_2599_ = array<u32, 2>(_e2495, _e2501);
                                                }
                                                let _e2504 = phi_2599_;
                                                let _e2505 = (_e2475 < 255u);
                                                if _e2505 {
                                                    phi_2605_ = _e2504;
                                                } else {
                                                    phi_2605_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2508 = phi_2605_;
                                                let _e2513 = (2u * ((select(16u, (_e2475 / 16u), _e2505) * _e2415) + (_e2416 + 1u)));
                                                let _e2516 = atomicAdd((&global_8.member[_e2513]), _e2508[0]);
                                                let _e2520 = (_e2508[1] + select(0u, 1u, ((_e2516 + _e2508[0]) < _e2508[0])));
                                                if (_e2520 == 0u) {
                                                } else {
                                                    let _e2525 = atomicAdd((&global_8.member[(_e2513 + 1u)]), _e2520);
                                                }
                                            }
                                            let _e2527 = bitcast<u32>((_e1708.member_2 + 0f));
                                            let _e2530 = ((_e2527 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2530 == 0u) {
                                            } else {
                                                let _e2533 = (_e2530 % 16u);
                                                let _e2535 = ((_e2527 & 8388607u) | 8388608u);
                                                let _e2538 = (_e2535 << bitcast<u32>((_e2533 & 31u)));
                                                let _e2544 = ((_e2535 >> bitcast<u32>(((31u - _e2533) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2527 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2660_ = array<u32, 2>(_e2538, _e2544);
                                                } else {
                                                    let _e2550 = (~(_e2538) + 1u);
                                                    if (_e2550 == 0u) {
                                                        phi_2658_ = (~(_e2544) + 1u);
                                                    } else {
                                                        phi_2658_ = ~(_e2544);
                                                    }
                                                    let _e2556 = phi_2658_;
                                                    phi_2660_ = array<u32, 2>(_e2550, _e2556);
                                                }
                                                let _e2559 = phi_2660_;
                                                let _e2560 = (_e2530 < 255u);
                                                if _e2560 {
                                                    phi_2666_ = _e2559;
                                                } else {
                                                    phi_2666_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2563 = phi_2666_;
                                                let _e2568 = (2u * ((select(16u, (_e2530 / 16u), _e2560) * _e2415) + (_e2416 + 2u)));
                                                let _e2571 = atomicAdd((&global_8.member[_e2568]), _e2563[0]);
                                                let _e2575 = (_e2563[1] + select(0u, 1u, ((_e2571 + _e2563[0]) < _e2563[0])));
                                                if (_e2575 == 0u) {
                                                } else {
                                                    let _e2580 = atomicAdd((&global_8.member[(_e2568 + 1u)]), _e2575);
                                                }
                                            }
                                            let _e2582 = bitcast<u32>((_e1711.member_3 + 0f));
                                            let _e2585 = ((_e2582 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2585 == 0u) {
                                            } else {
                                                let _e2588 = (_e2585 % 16u);
                                                let _e2590 = ((_e2582 & 8388607u) | 8388608u);
                                                let _e2593 = (_e2590 << bitcast<u32>((_e2588 & 31u)));
                                                let _e2599 = ((_e2590 >> bitcast<u32>(((31u - _e2588) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2582 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2721_ = array<u32, 2>(_e2593, _e2599);
                                                } else {
                                                    let _e2605 = (~(_e2593) + 1u);
                                                    if (_e2605 == 0u) {
                                                        phi_2719_ = (~(_e2599) + 1u);
                                                    } else {
                                                        phi_2719_ = ~(_e2599);
                                                    }
                                                    let _e2611 = phi_2719_;
                                                    phi_2721_ = array<u32, 2>(_e2605, _e2611);
                                                }
                                                let _e2614 = phi_2721_;
                                                let _e2615 = (_e2585 < 255u);
                                                if _e2615 {
                                                    phi_2727_ = _e2614;
                                                } else {
                                                    phi_2727_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2618 = phi_2727_;
                                                let _e2623 = (2u * ((select(16u, (_e2585 / 16u), _e2615) * _e2415) + (_e2416 + 3u)));
                                                let _e2626 = atomicAdd((&global_8.member[_e2623]), _e2618[0]);
                                                let _e2630 = (_e2618[1] + select(0u, 1u, ((_e2626 + _e2618[0]) < _e2618[0])));
                                                if (_e2630 == 0u) {
                                                } else {
                                                    let _e2635 = atomicAdd((&global_8.member[(_e2623 + 1u)]), _e2630);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e204 + _e785)] = (vec4<f32>(_e1702.member, _e1705.member_1, _e1708.member_2, _e1711.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
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
                                            let _e2684 = local_28;
                                            phi_280_ = _e2684;
                                            let _e2687 = local_29;
                                            phi_283_ = _e2687;
                                        }
                                    }
                                    let _e2691 = local_30;
                                    phi_387_ = _e2691;
                                    let _e2696 = local_32;
                                    phi_390_ = _e2696;
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
                                            let _e2693 = local_31;
                                            phi_387_ = _e2693;
                                            let _e2698 = local_33;
                                            phi_390_ = _e2698;
                                        }
                                    }
                                    let _e2701 = local_34;
                                    phi_457_ = _e2701;
                                    let _e2706 = local_36;
                                    phi_460_ = _e2706;
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
                                            let _e2703 = local_35;
                                            phi_457_ = _e2703;
                                            let _e2708 = local_37;
                                            phi_460_ = _e2708;
                                        }
                                    }
                                    let _e525 = local_2;
                                    let _e528 = local_3;
                                    let _e531 = local_4;
                                    let _e534 = local_5;
                                    if _e205 {
                                        let _e545 = (4u * _e201);
                                        let _e546 = (4u * _e217);
                                        let _e547 = bitcast<u32>((_e525.member + 0f));
                                        let _e550 = ((_e547 >> bitcast<u32>(23i)) & 255u);
                                        if (_e550 == 0u) {
                                        } else {
                                            let _e553 = (_e550 % 16u);
                                            let _e555 = ((_e547 & 8388607u) | 8388608u);
                                            let _e558 = (_e555 << bitcast<u32>((_e553 & 31u)));
                                            let _e564 = ((_e555 >> bitcast<u32>(((31u - _e553) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e547 >> bitcast<u32>(31i)) == 0u) {
                                                phi_614_ = array<u32, 2>(_e558, _e564);
                                            } else {
                                                let _e570 = (~(_e558) + 1u);
                                                if (_e570 == 0u) {
                                                    phi_612_ = (~(_e564) + 1u);
                                                } else {
                                                    phi_612_ = ~(_e564);
                                                }
                                                let _e576 = phi_612_;
                                                phi_614_ = array<u32, 2>(_e570, _e576);
                                            }
                                            let _e579 = phi_614_;
                                            let _e580 = (_e550 < 255u);
                                            if _e580 {
                                                phi_620_ = _e579;
                                            } else {
                                                phi_620_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e583 = phi_620_;
                                            let _e588 = (2u * ((select(16u, (_e550 / 16u), _e580) * _e545) + _e546));
                                            let _e591 = atomicAdd((&global_8.member[_e588]), _e583[0]);
                                            let _e595 = (_e583[1] + select(0u, 1u, ((_e591 + _e583[0]) < _e583[0])));
                                            if (_e595 == 0u) {
                                            } else {
                                                let _e600 = atomicAdd((&global_8.member[(_e588 + 1u)]), _e595);
                                            }
                                        }
                                        let _e602 = bitcast<u32>((_e528.member_1 + 0f));
                                        let _e605 = ((_e602 >> bitcast<u32>(23i)) & 255u);
                                        if (_e605 == 0u) {
                                        } else {
                                            let _e608 = (_e605 % 16u);
                                            let _e610 = ((_e602 & 8388607u) | 8388608u);
                                            let _e613 = (_e610 << bitcast<u32>((_e608 & 31u)));
                                            let _e619 = ((_e610 >> bitcast<u32>(((31u - _e608) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e602 >> bitcast<u32>(31i)) == 0u) {
                                                phi_675_ = array<u32, 2>(_e613, _e619);
                                            } else {
                                                let _e625 = (~(_e613) + 1u);
                                                if (_e625 == 0u) {
                                                    phi_673_ = (~(_e619) + 1u);
                                                } else {
                                                    phi_673_ = ~(_e619);
                                                }
                                                let _e631 = phi_673_;
                                                phi_675_ = array<u32, 2>(_e625, _e631);
                                            }
                                            let _e634 = phi_675_;
                                            let _e635 = (_e605 < 255u);
                                            if _e635 {
                                                phi_681_ = _e634;
                                            } else {
                                                phi_681_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e638 = phi_681_;
                                            let _e643 = (2u * ((select(16u, (_e605 / 16u), _e635) * _e545) + (_e546 + 1u)));
                                            let _e646 = atomicAdd((&global_8.member[_e643]), _e638[0]);
                                            let _e650 = (_e638[1] + select(0u, 1u, ((_e646 + _e638[0]) < _e638[0])));
                                            if (_e650 == 0u) {
                                            } else {
                                                let _e655 = atomicAdd((&global_8.member[(_e643 + 1u)]), _e650);
                                            }
                                        }
                                        let _e657 = bitcast<u32>((_e531.member_2 + 0f));
                                        let _e660 = ((_e657 >> bitcast<u32>(23i)) & 255u);
                                        if (_e660 == 0u) {
                                        } else {
                                            let _e663 = (_e660 % 16u);
                                            let _e665 = ((_e657 & 8388607u) | 8388608u);
                                            let _e668 = (_e665 << bitcast<u32>((_e663 & 31u)));
                                            let _e674 = ((_e665 >> bitcast<u32>(((31u - _e663) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e657 >> bitcast<u32>(31i)) == 0u) {
                                                phi_736_ = array<u32, 2>(_e668, _e674);
                                            } else {
                                                let _e680 = (~(_e668) + 1u);
                                                if (_e680 == 0u) {
                                                    phi_734_ = (~(_e674) + 1u);
                                                } else {
                                                    phi_734_ = ~(_e674);
                                                }
                                                let _e686 = phi_734_;
                                                phi_736_ = array<u32, 2>(_e680, _e686);
                                            }
                                            let _e689 = phi_736_;
                                            let _e690 = (_e660 < 255u);
                                            if _e690 {
                                                phi_742_ = _e689;
                                            } else {
                                                phi_742_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e693 = phi_742_;
                                            let _e698 = (2u * ((select(16u, (_e660 / 16u), _e690) * _e545) + (_e546 + 2u)));
                                            let _e701 = atomicAdd((&global_8.member[_e698]), _e693[0]);
                                            let _e705 = (_e693[1] + select(0u, 1u, ((_e701 + _e693[0]) < _e693[0])));
                                            if (_e705 == 0u) {
                                            } else {
                                                let _e710 = atomicAdd((&global_8.member[(_e698 + 1u)]), _e705);
                                            }
                                        }
                                        let _e712 = bitcast<u32>((_e534.member_3 + 0f));
                                        let _e715 = ((_e712 >> bitcast<u32>(23i)) & 255u);
                                        if (_e715 == 0u) {
                                        } else {
                                            let _e718 = (_e715 % 16u);
                                            let _e720 = ((_e712 & 8388607u) | 8388608u);
                                            let _e723 = (_e720 << bitcast<u32>((_e718 & 31u)));
                                            let _e729 = ((_e720 >> bitcast<u32>(((31u - _e718) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e712 >> bitcast<u32>(31i)) == 0u) {
                                                phi_797_ = array<u32, 2>(_e723, _e729);
                                            } else {
                                                let _e735 = (~(_e723) + 1u);
                                                if (_e735 == 0u) {
                                                    phi_795_ = (~(_e729) + 1u);
                                                } else {
                                                    phi_795_ = ~(_e729);
                                                }
                                                let _e741 = phi_795_;
                                                phi_797_ = array<u32, 2>(_e735, _e741);
                                            }
                                            let _e744 = phi_797_;
                                            let _e745 = (_e715 < 255u);
                                            if _e745 {
                                                phi_803_ = _e744;
                                            } else {
                                                phi_803_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e748 = phi_803_;
                                            let _e753 = (2u * ((select(16u, (_e715 / 16u), _e745) * _e545) + (_e546 + 3u)));
                                            let _e756 = atomicAdd((&global_8.member[_e753]), _e748[0]);
                                            let _e760 = (_e748[1] + select(0u, 1u, ((_e756 + _e748[0]) < _e748[0])));
                                            if (_e760 == 0u) {
                                            } else {
                                                let _e765 = atomicAdd((&global_8.member[(_e753 + 1u)]), _e760);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e204 + _e217)] = (vec4<f32>(_e525.member, _e528.member_1, _e531.member_2, _e534.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                    }
                                }
                                phi_218_ = _e178;
                                phi_221_ = _e187;
                                phi_223_ = _e182;
                            }
                            let _e2648 = phi_218_;
                            let _e2650 = phi_221_;
                            let _e2652 = phi_223_;
                            local_24 = _e2648;
                            local_25 = _e2650;
                            local_27 = _e2652;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2671 = local_24;
                            phi_217_ = _e2671;
                            let _e2674 = local_25;
                            phi_220_ = _e2674;
                            let _e2679 = local_27;
                            phi_222_ = _e2679;
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
