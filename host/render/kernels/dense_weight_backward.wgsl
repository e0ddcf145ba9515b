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

struct type_19 {
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
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_10;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_16;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_24;
@group(0) @binding(3) 
var<storage> global_9: type_16;

fn function_() {
    var phi_111_: u32;
    var phi_114_: u32;
    var phi_135_: u32;
    var local: u32;
    var phi_150_: u32;
    var local_1: u32;
    var phi_159_: u32;
    var phi_177_: u32;
    var phi_178_: u32;
    var phi_179_: bool;
    var phi_184_: u32;
    var phi_186_: u32;
    var phi_189_: u32;
    var phi_191_: u32;
    var phi_215_: u32;
    var phi_246_: vec4<f32>;
    var phi_255_: type_19;
    var phi_258_: type_18;
    var phi_274_: bool;
    var phi_362_: type_19;
    var phi_365_: type_18;
    var phi_432_: type_19;
    var phi_435_: type_18;
    var phi_451_: bool;
    var local_2: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;
    var phi_582_: u32;
    var phi_584_: array<u32, 2>;
    var phi_590_: array<u32, 2>;
    var phi_643_: u32;
    var phi_645_: array<u32, 2>;
    var phi_651_: array<u32, 2>;
    var phi_704_: u32;
    var phi_706_: array<u32, 2>;
    var phi_712_: array<u32, 2>;
    var phi_765_: u32;
    var phi_767_: array<u32, 2>;
    var phi_773_: array<u32, 2>;
    var phi_834_: vec4<f32>;
    var phi_845_: vec4<f32>;
    var phi_856_: vec4<f32>;
    var phi_867_: vec4<f32>;
    var phi_882_: type_18;
    var phi_885_: type_18;
    var phi_887_: type_18;
    var phi_889_: type_18;
    var phi_891_: type_19;
    var phi_907_: bool;
    var phi_1161_: type_18;
    var phi_1164_: type_18;
    var phi_1166_: type_18;
    var phi_1168_: type_18;
    var phi_1170_: type_19;
    var phi_1387_: type_18;
    var phi_1390_: type_18;
    var phi_1392_: type_18;
    var phi_1394_: type_18;
    var phi_1396_: type_19;
    var phi_1412_: bool;
    var local_6: type_18;
    var local_7: type_18;
    var local_8: type_18;
    var local_9: type_18;
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
    var phi_1721_: u32;
    var phi_1723_: array<u32, 2>;
    var phi_1729_: array<u32, 2>;
    var phi_1782_: u32;
    var phi_1784_: array<u32, 2>;
    var phi_1790_: array<u32, 2>;
    var phi_1843_: u32;
    var phi_1845_: array<u32, 2>;
    var phi_1851_: array<u32, 2>;
    var phi_1904_: u32;
    var phi_1906_: array<u32, 2>;
    var phi_1912_: array<u32, 2>;
    var phi_1976_: u32;
    var phi_1978_: array<u32, 2>;
    var phi_1984_: array<u32, 2>;
    var phi_2037_: u32;
    var phi_2039_: array<u32, 2>;
    var phi_2045_: array<u32, 2>;
    var phi_2098_: u32;
    var phi_2100_: array<u32, 2>;
    var phi_2106_: array<u32, 2>;
    var phi_2159_: u32;
    var phi_2161_: array<u32, 2>;
    var phi_2167_: array<u32, 2>;
    var phi_2231_: u32;
    var phi_2233_: array<u32, 2>;
    var phi_2239_: array<u32, 2>;
    var phi_2292_: u32;
    var phi_2294_: array<u32, 2>;
    var phi_2300_: array<u32, 2>;
    var phi_2353_: u32;
    var phi_2355_: array<u32, 2>;
    var phi_2361_: array<u32, 2>;
    var phi_2414_: u32;
    var phi_2416_: array<u32, 2>;
    var phi_2422_: array<u32, 2>;
    var phi_2486_: u32;
    var phi_2488_: array<u32, 2>;
    var phi_2494_: array<u32, 2>;
    var phi_2547_: u32;
    var phi_2549_: array<u32, 2>;
    var phi_2555_: array<u32, 2>;
    var phi_2608_: u32;
    var phi_2610_: array<u32, 2>;
    var phi_2616_: array<u32, 2>;
    var phi_2669_: u32;
    var phi_2671_: array<u32, 2>;
    var phi_2677_: array<u32, 2>;
    var phi_2707_: u32;
    var phi_187_: u32;
    var phi_190_: u32;
    var phi_192_: u32;
    var phi_2708_: bool;
    var local_22: u32;
    var local_23: u32;
    var local_24: u32;
    var local_25: u32;
    var local_26: u32;
    var local_27: u32;
    var local_28: type_19;
    var local_29: type_18;
    var local_30: type_19;
    var local_31: type_19;
    var local_32: type_18;
    var local_33: type_18;
    var local_34: type_19;
    var local_35: type_19;
    var local_36: type_18;
    var local_37: type_18;
    var local_38: type_18;
    var local_39: type_18;
    var local_40: type_18;
    var local_41: type_18;
    var local_42: type_19;
    var local_43: type_18;
    var local_44: type_18;
    var local_45: type_18;
    var local_46: type_18;
    var local_47: type_18;
    var local_48: type_18;
    var local_49: type_18;
    var local_50: type_18;
    var local_51: type_19;
    var local_52: type_19;
    var local_53: type_18;
    var local_54: type_18;
    var local_55: type_18;
    var local_56: type_18;
    var local_57: type_18;
    var local_58: type_18;
    var local_59: type_18;
    var local_60: type_18;
    var local_61: type_19;
    var local_62: type_19;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = global;
            let _e40 = global_1;
            let _e41 = global_2;
            let _e49 = (((_e40.x + (_e40.y * _e41.x)) * 64u) + _e39.x);
            let _e52 = global_3.member.member_4;
            let _e55 = global_3.member.member_10;
            let _e58 = global_3.member.member_3;
            let _e59 = (_e58 - 1u);
            let _e60 = (_e59 / 4u);
            let _e64 = global_3.member.member_1;
            let _e67 = global_3.member.member;
            let _e68 = (_e64 + _e67);
            let _e71 = (_e64 + (_e40.z * _e55));
            if (_e49 < ((_e60 + 2u) * _e52)) {
                if (_e71 < _e68) {
                    let _e76 = (_e71 + _e55);
                    let _e81 = global_3.member.member_7;
                    phi_111_ = _e81;
                    phi_114_ = 0u;
                    loop {
                        let _e83 = phi_111_;
                        let _e85 = phi_114_;
                        let _e86 = (_e85 + 1u);
                        local = _e85;
                        local_1 = _e86;
                        local_26 = _e85;
                        if (_e86 < _e83) {
                            let _e89 = ((_e85 + _e83) / 2u);
                            let _e92 = global_3.member.member_8;
                            let _e96 = global_4.member[(_e89 * _e92)];
                            let _e99 = global_3.member.member_9;
                            if (_e99 == 0u) {
                                phi_135_ = _e96;
                            } else {
                                let _e103 = global_5.member[_e96];
                                phi_135_ = _e103;
                            }
                            let _e105 = phi_135_;
                            let _e106 = (_e105 <= _e71);
                            local_22 = select(_e89, _e83, _e106);
                            local_23 = select(_e85, _e89, _e106);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2613 = local_22;
                            phi_111_ = _e2613;
                            let _e2616 = local_23;
                            phi_114_ = _e2616;
                        }
                    }
                    let _e111 = global_3.member.member_8;
                    let _e113 = local;
                    let _e117 = global_4.member[(_e113 * _e111)];
                    let _e120 = global_3.member.member_9;
                    let _e121 = (_e120 == 0u);
                    if _e121 {
                        phi_150_ = _e117;
                    } else {
                        let _e124 = global_5.member[_e117];
                        phi_150_ = _e124;
                    }
                    let _e126 = phi_150_;
                    let _e128 = local_1;
                    let _e132 = global_4.member[(_e128 * _e111)];
                    if _e121 {
                        phi_159_ = _e132;
                    } else {
                        let _e135 = global_5.member[_e132];
                        phi_159_ = _e135;
                    }
                    let _e137 = phi_159_;
                    if (_e55 == 0u) {
                        break;
                    }
                    let _e140 = ((_e71 - _e126) % _e55);
                    if (_e40.z == 0u) {
                        phi_178_ = u32();
                        phi_179_ = true;
                    } else {
                        let _e142 = (_e140 == 0u);
                        if _e142 {
                            phi_177_ = u32();
                        } else {
                            let _e144 = ((_e71 - _e140) + _e55);
                            phi_177_ = select(_e137, _e144, (_e144 < _e137));
                        }
                        let _e148 = phi_177_;
                        phi_178_ = _e148;
                        phi_179_ = _e142;
                    }
                    let _e150 = phi_178_;
                    let _e152 = phi_179_;
                    if _e152 {
                        phi_184_ = (_e71 - _e140);
                    } else {
                        phi_184_ = _e150;
                    }
                    let _e155 = phi_184_;
                    phi_186_ = _e137;
                    phi_189_ = _e155;
                    let _e2634 = local_26;
                    phi_191_ = _e2634;
                    loop {
                        let _e157 = phi_186_;
                        let _e159 = phi_189_;
                        let _e161 = phi_191_;
                        phi_2708_ = false;
                        if (_e159 < select(_e68, _e76, (_e76 < _e68))) {
                            if (_e159 == _e157) {
                                let _e2597 = global_4.member[((_e161 + 2u) * _e111)];
                                if _e121 {
                                    phi_2707_ = _e2597;
                                } else {
                                    let _e2600 = global_5.member[_e2597];
                                    phi_2707_ = _e2600;
                                }
                                let _e2602 = phi_2707_;
                                phi_187_ = _e2602;
                                phi_190_ = _e159;
                                phi_192_ = (_e161 + 1u);
                            } else {
                                let _e164 = (_e159 + _e55);
                                let _e166 = select(_e157, _e164, (_e164 < _e157));
                                let _e167 = (_e52 == 0u);
                                if _e167 {
                                    phi_2708_ = true;
                                    break;
                                }
                                let _e168 = (_e49 / _e52);
                                if _e167 {
                                    phi_2708_ = true;
                                    break;
                                }
                                let _e169 = (_e49 % _e52);
                                if (_e159 > _e64) {
                                    phi_215_ = (_e159 - _e64);
                                } else {
                                    phi_215_ = 0u;
                                }
                                let _e173 = phi_215_;
                                let _e174 = (_e166 - _e64);
                                let _e176 = select(_e67, _e174, (_e174 < _e67));
                                let _e179 = global_3.member.member_12;
                                let _e182 = global_3.member.member_11;
                                let _e183 = (_e179 * _e182);
                                let _e185 = ((1u - _e179) * _e182);
                                let _e186 = (_e166 <= _e68);
                                let _e188 = select(false, true, (_e159 < _e64));
                                let _e191 = global_3.member.member_2;
                                let _e193 = ((4u * _e169) * _e191);
                                if (_e168 < (_e60 + 1u)) {
                                    let _e742 = (_e168 * 4u);
                                    let _e745 = global_3.member.member_5;
                                    let _e748 = ((_e745 + (_e742 * _e52)) + _e169);
                                    let _e749 = (_e59 - _e742);
                                    let _e753 = (_e748 + (select(_e749, 1u, (1u < _e749)) * _e52));
                                    let _e757 = (_e748 + (select(_e749, 2u, (2u < _e749)) * _e52));
                                    let _e761 = (_e748 + (select(_e749, 3u, (3u < _e749)) * _e52));
                                    let _e767 = (_e742 + 1u);
                                    let _e771 = (_e742 + 2u);
                                    let _e775 = (_e742 + 3u);
                                    if _e188 {
                                        let _e781 = global_6.member[(_e183 + _e748)];
                                        phi_834_ = _e781;
                                    } else {
                                        phi_834_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e783 = phi_834_;
                                    if _e188 {
                                        let _e791 = global_6.member[(_e183 + _e753)];
                                        phi_845_ = _e791;
                                    } else {
                                        phi_845_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e793 = phi_845_;
                                    if _e188 {
                                        let _e801 = global_6.member[(_e183 + _e757)];
                                        phi_856_ = _e801;
                                    } else {
                                        phi_856_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e803 = phi_856_;
                                    if _e188 {
                                        let _e811 = global_6.member[(_e183 + _e761)];
                                        phi_867_ = _e811;
                                    } else {
                                        phi_867_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e813 = phi_867_;
                                    let _e821 = ((_e742 * _e191) / 4u);
                                    let _e822 = ((select(_e59, _e767, (_e767 < _e59)) * _e191) / 4u);
                                    let _e823 = ((select(_e59, _e771, (_e771 < _e59)) * _e191) / 4u);
                                    let _e824 = ((select(_e59, _e775, (_e775 < _e59)) * _e191) / 4u);
                                    let _e825 = (_e193 / 4u);
                                    let _e826 = (_e191 / 4u);
                                    phi_882_ = type_18(_e813.x, _e813.y, _e813.z, _e813.w);
                                    phi_885_ = type_18(_e803.x, _e803.y, _e803.z, _e803.w);
                                    phi_887_ = type_18(_e793.x, _e793.y, _e793.z, _e793.w);
                                    phi_889_ = type_18(_e783.x, _e783.y, _e783.z, _e783.w);
                                    phi_891_ = type_19((_e173 / 4u), _e173, _e176);
                                    loop {
                                        let _e828 = phi_882_;
                                        let _e830 = phi_885_;
                                        let _e832 = phi_887_;
                                        let _e834 = phi_889_;
                                        let _e836 = phi_891_;
                                        local_43 = _e828;
                                        local_45 = _e830;
                                        local_47 = _e832;
                                        local_49 = _e834;
                                        local_51 = _e836;
                                        let _e838 = (4u * _e836.member);
                                        if (_e838 < _e836.member_2) {
                                            phi_907_ = select(((_e838 + 4u) > _e836.member_2), true, (_e838 < _e836.member_1));
                                        } else {
                                            phi_907_ = false;
                                        }
                                        let _e847 = phi_907_;
                                        if _e847 {
                                            let _e851 = global_7.member[(_e825 + _e836.member)];
                                            let _e858 = (_e836.member_2 - _e836.member_1);
                                            let _e859 = ((_e838 - _e836.member_1) < _e858);
                                            let _e860 = select(0f, _e851.x, _e859);
                                            let _e863 = (((_e838 + 1u) - _e836.member_1) < _e858);
                                            let _e864 = select(0f, _e851.y, _e863);
                                            let _e867 = (((_e838 + 2u) - _e836.member_1) < _e858);
                                            let _e868 = select(0f, _e851.z, _e867);
                                            let _e871 = (((_e838 + 3u) - _e836.member_1) < _e858);
                                            let _e872 = select(0f, _e851.w, _e871);
                                            let _e877 = global_7.member[((_e825 + _e826) + _e836.member)];
                                            let _e882 = select(0f, _e877.x, _e859);
                                            let _e883 = select(0f, _e877.y, _e863);
                                            let _e884 = select(0f, _e877.z, _e867);
                                            let _e885 = select(0f, _e877.w, _e871);
                                            let _e891 = global_7.member[((_e825 + (2u * _e826)) + _e836.member)];
                                            let _e896 = select(0f, _e891.x, _e859);
                                            let _e897 = select(0f, _e891.y, _e863);
                                            let _e898 = select(0f, _e891.z, _e867);
                                            let _e899 = select(0f, _e891.w, _e871);
                                            let _e905 = global_7.member[((_e825 + (3u * _e826)) + _e836.member)];
                                            let _e910 = select(0f, _e905.x, _e859);
                                            let _e911 = select(0f, _e905.y, _e863);
                                            let _e912 = select(0f, _e905.z, _e867);
                                            let _e913 = select(0f, _e905.w, _e871);
                                            let _e917 = global_9.member[(_e821 + _e836.member)];
                                            let _e922 = select(0f, _e917.x, _e859);
                                            let _e923 = select(0f, _e917.y, _e863);
                                            let _e924 = select(0f, _e917.z, _e867);
                                            let _e925 = select(0f, _e917.w, _e871);
                                            let _e929 = global_9.member[(_e822 + _e836.member)];
                                            let _e934 = select(0f, _e929.x, _e859);
                                            let _e935 = select(0f, _e929.y, _e863);
                                            let _e936 = select(0f, _e929.z, _e867);
                                            let _e937 = select(0f, _e929.w, _e871);
                                            let _e941 = global_9.member[(_e823 + _e836.member)];
                                            let _e946 = select(0f, _e941.x, _e859);
                                            let _e947 = select(0f, _e941.y, _e863);
                                            let _e948 = select(0f, _e941.z, _e867);
                                            let _e949 = select(0f, _e941.w, _e871);
                                            let _e953 = global_9.member[(_e824 + _e836.member)];
                                            let _e958 = select(0f, _e953.x, _e859);
                                            let _e959 = select(0f, _e953.y, _e863);
                                            let _e960 = select(0f, _e953.z, _e867);
                                            let _e961 = select(0f, _e953.w, _e871);
                                            local_38 = type_18(((_e961 * _e872) + ((_e960 * _e868) + ((_e959 * _e864) + ((_e958 * _e860) + _e828.member)))), ((_e961 * _e885) + ((_e960 * _e884) + ((_e959 * _e883) + ((_e958 * _e882) + _e828.member_1)))), ((_e961 * _e899) + ((_e960 * _e898) + ((_e959 * _e897) + ((_e958 * _e896) + _e828.member_2)))), ((_e961 * _e913) + ((_e960 * _e912) + ((_e959 * _e911) + ((_e958 * _e910) + _e828.member_3)))));
                                            local_39 = type_18(((_e949 * _e872) + ((_e948 * _e868) + ((_e947 * _e864) + ((_e946 * _e860) + _e830.member)))), ((_e949 * _e885) + ((_e948 * _e884) + ((_e947 * _e883) + ((_e946 * _e882) + _e830.member_1)))), ((_e949 * _e899) + ((_e948 * _e898) + ((_e947 * _e897) + ((_e946 * _e896) + _e830.member_2)))), ((_e949 * _e913) + ((_e948 * _e912) + ((_e947 * _e911) + ((_e946 * _e910) + _e830.member_3)))));
                                            local_40 = type_18(((_e937 * _e872) + ((_e936 * _e868) + ((_e935 * _e864) + ((_e934 * _e860) + _e832.member)))), ((_e937 * _e885) + ((_e936 * _e884) + ((_e935 * _e883) + ((_e934 * _e882) + _e832.member_1)))), ((_e937 * _e899) + ((_e936 * _e898) + ((_e935 * _e897) + ((_e934 * _e896) + _e832.member_2)))), ((_e937 * _e913) + ((_e936 * _e912) + ((_e935 * _e911) + ((_e934 * _e910) + _e832.member_3)))));
                                            local_41 = type_18(((_e925 * _e872) + ((_e924 * _e868) + ((_e923 * _e864) + ((_e922 * _e860) + _e834.member)))), ((_e925 * _e885) + ((_e924 * _e884) + ((_e923 * _e883) + ((_e922 * _e882) + _e834.member_1)))), ((_e925 * _e899) + ((_e924 * _e898) + ((_e923 * _e897) + ((_e922 * _e896) + _e834.member_2)))), ((_e925 * _e913) + ((_e924 * _e912) + ((_e923 * _e911) + ((_e922 * _e910) + _e834.member_3)))));
                                            local_42 = type_19((_e836.member + 1u), _e836.member_1, _e836.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2689 = local_38;
                                            phi_882_ = _e2689;
                                            let _e2692 = local_39;
                                            phi_885_ = _e2692;
                                            let _e2695 = local_40;
                                            phi_887_ = _e2695;
                                            let _e2698 = local_41;
                                            phi_889_ = _e2698;
                                            let _e2701 = local_42;
                                            phi_891_ = _e2701;
                                        }
                                    }
                                    let _e2705 = local_43;
                                    phi_1161_ = _e2705;
                                    let _e2710 = local_45;
                                    phi_1164_ = _e2710;
                                    let _e2715 = local_47;
                                    phi_1166_ = _e2715;
                                    let _e2720 = local_49;
                                    phi_1168_ = _e2720;
                                    let _e2725 = local_51;
                                    phi_1170_ = _e2725;
                                    loop {
                                        let _e1116 = phi_1161_;
                                        let _e1118 = phi_1164_;
                                        let _e1120 = phi_1166_;
                                        let _e1122 = phi_1168_;
                                        let _e1124 = phi_1170_;
                                        local_53 = _e1116;
                                        local_55 = _e1118;
                                        local_57 = _e1120;
                                        local_59 = _e1122;
                                        local_61 = _e1124;
                                        if !((((4u * _e1124.member) + 4u) > _e1124.member_2)) {
                                            let _e1134 = global_7.member[(_e825 + _e1124.member)];
                                            let _e1143 = global_7.member[((_e825 + _e826) + _e1124.member)];
                                            let _e1153 = global_7.member[((_e825 + (2u * _e826)) + _e1124.member)];
                                            let _e1163 = global_7.member[((_e825 + (3u * _e826)) + _e1124.member)];
                                            let _e1171 = global_9.member[(_e821 + _e1124.member)];
                                            let _e1179 = global_9.member[(_e822 + _e1124.member)];
                                            let _e1187 = global_9.member[(_e823 + _e1124.member)];
                                            let _e1195 = global_9.member[(_e824 + _e1124.member)];
                                            local_44 = type_18(((_e1195.w * _e1134.w) + ((_e1195.z * _e1134.z) + ((_e1195.y * _e1134.y) + ((_e1195.x * _e1134.x) + _e1116.member)))), ((_e1195.w * _e1143.w) + ((_e1195.z * _e1143.z) + ((_e1195.y * _e1143.y) + ((_e1195.x * _e1143.x) + _e1116.member_1)))), ((_e1195.w * _e1153.w) + ((_e1195.z * _e1153.z) + ((_e1195.y * _e1153.y) + ((_e1195.x * _e1153.x) + _e1116.member_2)))), ((_e1195.w * _e1163.w) + ((_e1195.z * _e1163.z) + ((_e1195.y * _e1163.y) + ((_e1195.x * _e1163.x) + _e1116.member_3)))));
                                            local_46 = type_18(((_e1187.w * _e1134.w) + ((_e1187.z * _e1134.z) + ((_e1187.y * _e1134.y) + ((_e1187.x * _e1134.x) + _e1118.member)))), ((_e1187.w * _e1143.w) + ((_e1187.z * _e1143.z) + ((_e1187.y * _e1143.y) + ((_e1187.x * _e1143.x) + _e1118.member_1)))), ((_e1187.w * _e1153.w) + ((_e1187.z * _e1153.z) + ((_e1187.y * _e1153.y) + ((_e1187.x * _e1153.x) + _e1118.member_2)))), ((_e1187.w * _e1163.w) + ((_e1187.z * _e1163.z) + ((_e1187.y * _e1163.y) + ((_e1187.x * _e1163.x) + _e1118.member_3)))));
                                            local_48 = type_18(((_e1179.w * _e1134.w) + ((_e1179.z * _e1134.z) + ((_e1179.y * _e1134.y) + ((_e1179.x * _e1134.x) + _e1120.member)))), ((_e1179.w * _e1143.w) + ((_e1179.z * _e1143.z) + ((_e1179.y * _e1143.y) + ((_e1179.x * _e1143.x) + _e1120.member_1)))), ((_e1179.w * _e1153.w) + ((_e1179.z * _e1153.z) + ((_e1179.y * _e1153.y) + ((_e1179.x * _e1153.x) + _e1120.member_2)))), ((_e1179.w * _e1163.w) + ((_e1179.z * _e1163.z) + ((_e1179.y * _e1163.y) + ((_e1179.x * _e1163.x) + _e1120.member_3)))));
                                            local_50 = type_18(((_e1171.w * _e1134.w) + ((_e1171.z * _e1134.z) + ((_e1171.y * _e1134.y) + ((_e1171.x * _e1134.x) + _e1122.member)))), ((_e1171.w * _e1143.w) + ((_e1171.z * _e1143.z) + ((_e1171.y * _e1143.y) + ((_e1171.x * _e1143.x) + _e1122.member_1)))), ((_e1171.w * _e1153.w) + ((_e1171.z * _e1153.z) + ((_e1171.y * _e1153.y) + ((_e1171.x * _e1153.x) + _e1122.member_2)))), ((_e1171.w * _e1163.w) + ((_e1171.z * _e1163.z) + ((_e1171.y * _e1163.y) + ((_e1171.x * _e1163.x) + _e1122.member_3)))));
                                            local_52 = type_19((_e1124.member + 1u), _e1124.member_1, _e1124.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2707 = local_44;
                                            phi_1161_ = _e2707;
                                            let _e2712 = local_46;
                                            phi_1164_ = _e2712;
                                            let _e2717 = local_48;
                                            phi_1166_ = _e2717;
                                            let _e2722 = local_50;
                                            phi_1168_ = _e2722;
                                            let _e2727 = local_52;
                                            phi_1170_ = _e2727;
                                        }
                                    }
                                    let _e2730 = local_53;
                                    phi_1387_ = _e2730;
                                    let _e2735 = local_55;
                                    phi_1390_ = _e2735;
                                    let _e2740 = local_57;
                                    phi_1392_ = _e2740;
                                    let _e2745 = local_59;
                                    phi_1394_ = _e2745;
                                    let _e2750 = local_61;
                                    phi_1396_ = _e2750;
                                    loop {
                                        let _e1354 = phi_1387_;
                                        let _e1356 = phi_1390_;
                                        let _e1358 = phi_1392_;
                                        let _e1360 = phi_1394_;
                                        let _e1362 = phi_1396_;
                                        local_6 = _e1360;
                                        local_7 = _e1360;
                                        local_8 = _e1360;
                                        local_9 = _e1360;
                                        local_10 = _e1358;
                                        local_11 = _e1358;
                                        local_12 = _e1358;
                                        local_13 = _e1358;
                                        local_14 = _e1356;
                                        local_15 = _e1356;
                                        local_16 = _e1356;
                                        local_17 = _e1356;
                                        local_18 = _e1354;
                                        local_19 = _e1354;
                                        local_20 = _e1354;
                                        local_21 = _e1354;
                                        let _e1364 = (4u * _e1362.member);
                                        if (_e1364 < _e1362.member_2) {
                                            phi_1412_ = select(((_e1364 + 4u) > _e1362.member_2), true, (_e1364 < _e1362.member_1));
                                        } else {
                                            phi_1412_ = false;
                                        }
                                        let _e1373 = phi_1412_;
                                        if _e1373 {
                                            let _e1377 = global_7.member[(_e825 + _e1362.member)];
                                            let _e1384 = (_e1362.member_2 - _e1362.member_1);
                                            let _e1385 = ((_e1364 - _e1362.member_1) < _e1384);
                                            let _e1386 = select(0f, _e1377.x, _e1385);
                                            let _e1389 = (((_e1364 + 1u) - _e1362.member_1) < _e1384);
                                            let _e1390 = select(0f, _e1377.y, _e1389);
                                            let _e1393 = (((_e1364 + 2u) - _e1362.member_1) < _e1384);
                                            let _e1394 = select(0f, _e1377.z, _e1393);
                                            let _e1397 = (((_e1364 + 3u) - _e1362.member_1) < _e1384);
                                            let _e1398 = select(0f, _e1377.w, _e1397);
                                            let _e1403 = global_7.member[((_e825 + _e826) + _e1362.member)];
                                            let _e1408 = select(0f, _e1403.x, _e1385);
                                            let _e1409 = select(0f, _e1403.y, _e1389);
                                            let _e1410 = select(0f, _e1403.z, _e1393);
                                            let _e1411 = select(0f, _e1403.w, _e1397);
                                            let _e1417 = global_7.member[((_e825 + (2u * _e826)) + _e1362.member)];
                                            let _e1422 = select(0f, _e1417.x, _e1385);
                                            let _e1423 = select(0f, _e1417.y, _e1389);
                                            let _e1424 = select(0f, _e1417.z, _e1393);
                                            let _e1425 = select(0f, _e1417.w, _e1397);
                                            let _e1431 = global_7.member[((_e825 + (3u * _e826)) + _e1362.member)];
                                            let _e1436 = select(0f, _e1431.x, _e1385);
                                            let _e1437 = select(0f, _e1431.y, _e1389);
                                            let _e1438 = select(0f, _e1431.z, _e1393);
                                            let _e1439 = select(0f, _e1431.w, _e1397);
                                            let _e1443 = global_9.member[(_e821 + _e1362.member)];
                                            let _e1448 = select(0f, _e1443.x, _e1385);
                                            let _e1449 = select(0f, _e1443.y, _e1389);
                                            let _e1450 = select(0f, _e1443.z, _e1393);
                                            let _e1451 = select(0f, _e1443.w, _e1397);
                                            let _e1455 = global_9.member[(_e822 + _e1362.member)];
                                            let _e1460 = select(0f, _e1455.x, _e1385);
                                            let _e1461 = select(0f, _e1455.y, _e1389);
                                            let _e1462 = select(0f, _e1455.z, _e1393);
                                            let _e1463 = select(0f, _e1455.w, _e1397);
                                            let _e1467 = global_9.member[(_e823 + _e1362.member)];
                                            let _e1472 = select(0f, _e1467.x, _e1385);
                                            let _e1473 = select(0f, _e1467.y, _e1389);
                                            let _e1474 = select(0f, _e1467.z, _e1393);
                                            let _e1475 = select(0f, _e1467.w, _e1397);
                                            let _e1479 = global_9.member[(_e824 + _e1362.member)];
                                            let _e1484 = select(0f, _e1479.x, _e1385);
                                            let _e1485 = select(0f, _e1479.y, _e1389);
                                            let _e1486 = select(0f, _e1479.z, _e1393);
                                            let _e1487 = select(0f, _e1479.w, _e1397);
                                            local_54 = type_18(((_e1487 * _e1398) + ((_e1486 * _e1394) + ((_e1485 * _e1390) + ((_e1484 * _e1386) + _e1354.member)))), ((_e1487 * _e1411) + ((_e1486 * _e1410) + ((_e1485 * _e1409) + ((_e1484 * _e1408) + _e1354.member_1)))), ((_e1487 * _e1425) + ((_e1486 * _e1424) + ((_e1485 * _e1423) + ((_e1484 * _e1422) + _e1354.member_2)))), ((_e1487 * _e1439) + ((_e1486 * _e1438) + ((_e1485 * _e1437) + ((_e1484 * _e1436) + _e1354.member_3)))));
                                            local_56 = type_18(((_e1475 * _e1398) + ((_e1474 * _e1394) + ((_e1473 * _e1390) + ((_e1472 * _e1386) + _e1356.member)))), ((_e1475 * _e1411) + ((_e1474 * _e1410) + ((_e1473 * _e1409) + ((_e1472 * _e1408) + _e1356.member_1)))), ((_e1475 * _e1425) + ((_e1474 * _e1424) + ((_e1473 * _e1423) + ((_e1472 * _e1422) + _e1356.member_2)))), ((_e1475 * _e1439) + ((_e1474 * _e1438) + ((_e1473 * _e1437) + ((_e1472 * _e1436) + _e1356.member_3)))));
                                            local_58 = type_18(((_e1463 * _e1398) + ((_e1462 * _e1394) + ((_e1461 * _e1390) + ((_e1460 * _e1386) + _e1358.member)))), ((_e1463 * _e1411) + ((_e1462 * _e1410) + ((_e1461 * _e1409) + ((_e1460 * _e1408) + _e1358.member_1)))), ((_e1463 * _e1425) + ((_e1462 * _e1424) + ((_e1461 * _e1423) + ((_e1460 * _e1422) + _e1358.member_2)))), ((_e1463 * _e1439) + ((_e1462 * _e1438) + ((_e1461 * _e1437) + ((_e1460 * _e1436) + _e1358.member_3)))));
                                            local_60 = type_18(((_e1451 * _e1398) + ((_e1450 * _e1394) + ((_e1449 * _e1390) + ((_e1448 * _e1386) + _e1360.member)))), ((_e1451 * _e1411) + ((_e1450 * _e1410) + ((_e1449 * _e1409) + ((_e1448 * _e1408) + _e1360.member_1)))), ((_e1451 * _e1425) + ((_e1450 * _e1424) + ((_e1449 * _e1423) + ((_e1448 * _e1422) + _e1360.member_2)))), ((_e1451 * _e1439) + ((_e1450 * _e1438) + ((_e1449 * _e1437) + ((_e1448 * _e1436) + _e1360.member_3)))));
                                            local_62 = type_19((_e1362.member + 1u), _e1362.member_1, _e1362.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2732 = local_54;
                                            phi_1387_ = _e2732;
                                            let _e2737 = local_56;
                                            phi_1390_ = _e2737;
                                            let _e2742 = local_58;
                                            phi_1392_ = _e2742;
                                            let _e2747 = local_60;
                                            phi_1394_ = _e2747;
                                            let _e2752 = local_62;
                                            phi_1396_ = _e2752;
                                        }
                                    }
                                    let _e1642 = local_6;
                                    let _e1645 = local_7;
                                    let _e1648 = local_8;
                                    let _e1651 = local_9;
                                    let _e1654 = local_10;
                                    let _e1657 = local_11;
                                    let _e1660 = local_12;
                                    let _e1663 = local_13;
                                    let _e1666 = local_14;
                                    let _e1669 = local_15;
                                    let _e1672 = local_16;
                                    let _e1675 = local_17;
                                    let _e1678 = local_18;
                                    let _e1681 = local_19;
                                    let _e1684 = local_20;
                                    let _e1687 = local_21;
                                    if _e186 {
                                        let _e1693 = (4u * _e182);
                                        let _e1694 = (4u * _e748);
                                        let _e1695 = bitcast<u32>(_e1642.member);
                                        let _e1698 = ((_e1695 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1698 == 0u) {
                                        } else {
                                            let _e1701 = (_e1698 % 16u);
                                            let _e1703 = ((_e1695 & 8388607u) | 8388608u);
                                            let _e1706 = (_e1703 << bitcast<u32>((_e1701 & 31u)));
                                            let _e1712 = ((_e1703 >> bitcast<u32>(((31u - _e1701) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1695 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1723_ = array<u32, 2>(_e1706, _e1712);
                                            } else {
                                                let _e1718 = (~(_e1706) + 1u);
                                                if (_e1718 == 0u) {
                                                    phi_1721_ = (~(_e1712) + 1u);
                                                } else {
                                                    phi_1721_ = ~(_e1712);
                                                }
                                                let _e1724 = phi_1721_;
                                                phi_1723_ = array<u32, 2>(_e1718, _e1724);
                                            }
                                            let _e1727 = phi_1723_;
                                            let _e1728 = (_e1698 < 255u);
                                            if _e1728 {
                                                phi_1729_ = _e1727;
                                            } else {
                                                phi_1729_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1731 = phi_1729_;
                                            let _e1736 = (2u * ((select(16u, (_e1698 / 16u), _e1728) * _e1693) + _e1694));
                                            let _e1739 = atomicAdd((&global_8.member[_e1736]), _e1731[0]);
                                            let _e1743 = (_e1731[1] + select(0u, 1u, ((_e1739 + _e1731[0]) < _e1731[0])));
                                            if (_e1743 == 0u) {
                                            } else {
                                                let _e1748 = atomicAdd((&global_8.member[(_e1736 + 1u)]), _e1743);
                                            }
                                        }
                                        let _e1750 = bitcast<u32>(_e1645.member_1);
                                        let _e1753 = ((_e1750 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1753 == 0u) {
                                        } else {
                                            let _e1756 = (_e1753 % 16u);
                                            let _e1758 = ((_e1750 & 8388607u) | 8388608u);
                                            let _e1761 = (_e1758 << bitcast<u32>((_e1756 & 31u)));
                                            let _e1767 = ((_e1758 >> bitcast<u32>(((31u - _e1756) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1750 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1784_ = array<u32, 2>(_e1761, _e1767);
                                            } else {
                                                let _e1773 = (~(_e1761) + 1u);
                                                if (_e1773 == 0u) {
                                                    phi_1782_ = (~(_e1767) + 1u);
                                                } else {
                                                    phi_1782_ = ~(_e1767);
                                                }
                                                let _e1779 = phi_1782_;
                                                phi_1784_ = array<u32, 2>(_e1773, _e1779);
                                            }
                                            let _e1782 = phi_1784_;
                                            let _e1783 = (_e1753 < 255u);
                                            if _e1783 {
                                                phi_1790_ = _e1782;
                                            } else {
                                                phi_1790_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1786 = phi_1790_;
                                            let _e1791 = (2u * ((select(16u, (_e1753 / 16u), _e1783) * _e1693) + (_e1694 + 1u)));
                                            let _e1794 = atomicAdd((&global_8.member[_e1791]), _e1786[0]);
                                            let _e1798 = (_e1786[1] + select(0u, 1u, ((_e1794 + _e1786[0]) < _e1786[0])));
                                            if (_e1798 == 0u) {
                                            } else {
                                                let _e1803 = atomicAdd((&global_8.member[(_e1791 + 1u)]), _e1798);
                                            }
                                        }
                                        let _e1805 = bitcast<u32>(_e1648.member_2);
                                        let _e1808 = ((_e1805 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1808 == 0u) {
                                        } else {
                                            let _e1811 = (_e1808 % 16u);
                                            let _e1813 = ((_e1805 & 8388607u) | 8388608u);
                                            let _e1816 = (_e1813 << bitcast<u32>((_e1811 & 31u)));
                                            let _e1822 = ((_e1813 >> bitcast<u32>(((31u - _e1811) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1805 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1845_ = array<u32, 2>(_e1816, _e1822);
                                            } else {
                                                let _e1828 = (~(_e1816) + 1u);
                                                if (_e1828 == 0u) {
                                                    phi_1843_ = (~(_e1822) + 1u);
                                                } else {
                                                    phi_1843_ = ~(_e1822);
                                                }
                                                let _e1834 = phi_1843_;
                                                phi_1845_ = array<u32, 2>(_e1828, _e1834);
                                            }
                                            let _e1837 = phi_1845_;
                                            let _e1838 = (_e1808 < 255u);
                                            if _e1838 {
                                                phi_1851_ = _e1837;
                                            } else {
                                                phi_1851_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1841 = phi_1851_;
                                            let _e1846 = (2u * ((select(16u, (_e1808 / 16u), _e1838) * _e1693) + (_e1694 + 2u)));
                                            let _e1849 = atomicAdd((&global_8.member[_e1846]), _e1841[0]);
                                            let _e1853 = (_e1841[1] + select(0u, 1u, ((_e1849 + _e1841[0]) < _e1841[0])));
                                            if (_e1853 == 0u) {
                                            } else {
                                                let _e1858 = atomicAdd((&global_8.member[(_e1846 + 1u)]), _e1853);
                                            }
                                        }
                                        let _e1860 = bitcast<u32>(_e1651.member_3);
                                        let _e1863 = ((_e1860 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1863 == 0u) {
                                        } else {
                                            let _e1866 = (_e1863 % 16u);
                                            let _e1868 = ((_e1860 & 8388607u) | 8388608u);
                                            let _e1871 = (_e1868 << bitcast<u32>((_e1866 & 31u)));
                                            let _e1877 = ((_e1868 >> bitcast<u32>(((31u - _e1866) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1860 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1906_ = array<u32, 2>(_e1871, _e1877);
                                            } else {
                                                let _e1883 = (~(_e1871) + 1u);
                                                if (_e1883 == 0u) {
                                                    phi_1904_ = (~(_e1877) + 1u);
                                                } else {
                                                    phi_1904_ = ~(_e1877);
                                                }
                                                let _e1889 = phi_1904_;
                                                phi_1906_ = array<u32, 2>(_e1883, _e1889);
                                            }
                                            let _e1892 = phi_1906_;
                                            let _e1893 = (_e1863 < 255u);
                                            if _e1893 {
                                                phi_1912_ = _e1892;
                                            } else {
                                                phi_1912_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1896 = phi_1912_;
                                            let _e1901 = (2u * ((select(16u, (_e1863 / 16u), _e1893) * _e1693) + (_e1694 + 3u)));
                                            let _e1904 = atomicAdd((&global_8.member[_e1901]), _e1896[0]);
                                            let _e1908 = (_e1896[1] + select(0u, 1u, ((_e1904 + _e1896[0]) < _e1896[0])));
                                            if (_e1908 == 0u) {
                                            } else {
                                                let _e1913 = atomicAdd((&global_8.member[(_e1901 + 1u)]), _e1908);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e748)] = vec4<f32>(_e1642.member, _e1645.member_1, _e1648.member_2, _e1651.member_3);
                                    }
                                    if (_e767 < _e58) {
                                        if _e186 {
                                            let _e1919 = (4u * _e182);
                                            let _e1920 = (4u * _e753);
                                            let _e1921 = bitcast<u32>(_e1654.member);
                                            let _e1924 = ((_e1921 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1924 == 0u) {
                                            } else {
                                                let _e1927 = (_e1924 % 16u);
                                                let _e1929 = ((_e1921 & 8388607u) | 8388608u);
                                                let _e1932 = (_e1929 << bitcast<u32>((_e1927 & 31u)));
                                                let _e1938 = ((_e1929 >> bitcast<u32>(((31u - _e1927) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1921 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1978_ = array<u32, 2>(_e1932, _e1938);
                                                } else {
                                                    let _e1944 = (~(_e1932) + 1u);
                                                    if (_e1944 == 0u) {
                                                        phi_1976_ = (~(_e1938) + 1u);
                                                    } else {
                                                        phi_1976_ = ~(_e1938);
                                                    }
                                                    let _e1950 = phi_1976_;
                                                    phi_1978_ = array<u32, 2>(_e1944, _e1950);
                                                }
                                                let _e1953 = phi_1978_;
                                                let _e1954 = (_e1924 < 255u);
                                                if _e1954 {
                                                    phi_1984_ = _e1953;
                                                } else {
                                                    phi_1984_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1957 = phi_1984_;
                                                let _e1962 = (2u * ((select(16u, (_e1924 / 16u), _e1954) * _e1919) + _e1920));
                                                let _e1965 = atomicAdd((&global_8.member[_e1962]), _e1957[0]);
                                                let _e1969 = (_e1957[1] + select(0u, 1u, ((_e1965 + _e1957[0]) < _e1957[0])));
                                                if (_e1969 == 0u) {
                                                } else {
                                                    let _e1974 = atomicAdd((&global_8.member[(_e1962 + 1u)]), _e1969);
                                                }
                                            }
                                            let _e1976 = bitcast<u32>(_e1657.member_1);
                                            let _e1979 = ((_e1976 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1979 == 0u) {
                                            } else {
                                                let _e1982 = (_e1979 % 16u);
                                                let _e1984 = ((_e1976 & 8388607u) | 8388608u);
                                                let _e1987 = (_e1984 << bitcast<u32>((_e1982 & 31u)));
                                                let _e1993 = ((_e1984 >> bitcast<u32>(((31u - _e1982) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1976 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2039_ = array<u32, 2>(_e1987, _e1993);
                                                } else {
                                                    let _e1999 = (~(_e1987) + 1u);
                                                    if (_e1999 == 0u) {
                                                        phi_2037_ = (~(_e1993) + 1u);
                                                    } else {
                                                        phi_2037_ = ~(_e1993);
                                                    }
                                                    let _e2005 = phi_2037_;
                                                    phi_2039_ = array<u32, 2>(_e1999, _e2005);
                                                }
                                                let _e2008 = phi_2039_;
                                                let _e2009 = (_e1979 < 255u);
                                                if _e2009 {
                                                    phi_2045_ = _e2008;
                                                } else {
                                                    phi_2045_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2012 = phi_2045_;
                                                let _e2017 = (2u * ((select(16u, (_e1979 / 16u), _e2009) * _e1919) + (_e1920 + 1u)));
                                                let _e2020 = atomicAdd((&global_8.member[_e2017]), _e2012[0]);
                                                let _e2024 = (_e2012[1] + select(0u, 1u, ((_e2020 + _e2012[0]) < _e2012[0])));
                                                if (_e2024 == 0u) {
                                                } else {
                                                    let _e2029 = atomicAdd((&global_8.member[(_e2017 + 1u)]), _e2024);
                                                }
                                            }
                                            let _e2031 = bitcast<u32>(_e1660.member_2);
                                            let _e2034 = ((_e2031 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2034 == 0u) {
                                            } else {
                                                let _e2037 = (_e2034 % 16u);
                                                let _e2039 = ((_e2031 & 8388607u) | 8388608u);
                                                let _e2042 = (_e2039 << bitcast<u32>((_e2037 & 31u)));
                                                let _e2048 = ((_e2039 >> bitcast<u32>(((31u - _e2037) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2031 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2100_ = array<u32, 2>(_e2042, _e2048);
                                                } else {
                                                    let _e2054 = (~(_e2042) + 1u);
                                                    if (_e2054 == 0u) {
                                                        phi_2098_ = (~(_e2048) + 1u);
                                                    } else {
                                                        phi_2098_ = ~(_e2048);
                                                    }
                                                    let _e2060 = phi_2098_;
                                                    phi_2100_ = array<u32, 2>(_e2054, _e2060);
                                                }
                                                let _e2063 = phi_2100_;
                                                let _e2064 = (_e2034 < 255u);
                                                if _e2064 {
                                                    phi_2106_ = _e2063;
                                                } else {
                                                    phi_2106_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2067 = phi_2106_;
                                                let _e2072 = (2u * ((select(16u, (_e2034 / 16u), _e2064) * _e1919) + (_e1920 + 2u)));
                                                let _e2075 = atomicAdd((&global_8.member[_e2072]), _e2067[0]);
                                                let _e2079 = (_e2067[1] + select(0u, 1u, ((_e2075 + _e2067[0]) < _e2067[0])));
                                                if (_e2079 == 0u) {
                                                } else {
                                                    let _e2084 = atomicAdd((&global_8.member[(_e2072 + 1u)]), _e2079);
                                                }
                                            }
                                            let _e2086 = bitcast<u32>(_e1663.member_3);
                                            let _e2089 = ((_e2086 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2089 == 0u) {
                                            } else {
                                                let _e2092 = (_e2089 % 16u);
                                                let _e2094 = ((_e2086 & 8388607u) | 8388608u);
                                                let _e2097 = (_e2094 << bitcast<u32>((_e2092 & 31u)));
                                                let _e2103 = ((_e2094 >> bitcast<u32>(((31u - _e2092) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2086 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2161_ = array<u32, 2>(_e2097, _e2103);
                                                } else {
                                                    let _e2109 = (~(_e2097) + 1u);
                                                    if (_e2109 == 0u) {
                                                        phi_2159_ = (~(_e2103) + 1u);
                                                    } else {
                                                        phi_2159_ = ~(_e2103);
                                                    }
                                                    let _e2115 = phi_2159_;
                                                    phi_2161_ = array<u32, 2>(_e2109, _e2115);
                                                }
                                                let _e2118 = phi_2161_;
                                                let _e2119 = (_e2089 < 255u);
                                                if _e2119 {
                                                    phi_2167_ = _e2118;
                                                } else {
                                                    phi_2167_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2122 = phi_2167_;
                                                let _e2127 = (2u * ((select(16u, (_e2089 / 16u), _e2119) * _e1919) + (_e1920 + 3u)));
                                                let _e2130 = atomicAdd((&global_8.member[_e2127]), _e2122[0]);
                                                let _e2134 = (_e2122[1] + select(0u, 1u, ((_e2130 + _e2122[0]) < _e2122[0])));
                                                if (_e2134 == 0u) {
                                                } else {
                                                    let _e2139 = atomicAdd((&global_8.member[(_e2127 + 1u)]), _e2134);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e753)] = vec4<f32>(_e1654.member, _e1657.member_1, _e1660.member_2, _e1663.member_3);
                                        }
                                    }
                                    if (_e771 < _e58) {
                                        if _e186 {
                                            let _e2145 = (4u * _e182);
                                            let _e2146 = (4u * _e757);
                                            let _e2147 = bitcast<u32>(_e1666.member);
                                            let _e2150 = ((_e2147 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2150 == 0u) {
                                            } else {
                                                let _e2153 = (_e2150 % 16u);
                                                let _e2155 = ((_e2147 & 8388607u) | 8388608u);
                                                let _e2158 = (_e2155 << bitcast<u32>((_e2153 & 31u)));
                                                let _e2164 = ((_e2155 >> bitcast<u32>(((31u - _e2153) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2147 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2233_ = array<u32, 2>(_e2158, _e2164);
                                                } else {
                                                    let _e2170 = (~(_e2158) + 1u);
                                                    if (_e2170 == 0u) {
                                                        phi_2231_ = (~(_e2164) + 1u);
                                                    } else {
                                                        phi_2231_ = ~(_e2164);
                                                    }
                                                    let _e2176 = phi_2231_;
                                                    phi_2233_ = array<u32, 2>(_e2170, _e2176);
                                                }
                                                let _e2179 = phi_2233_;
                                                let _e2180 = (_e2150 < 255u);
                                                if _e2180 {
                                                    phi_2239_ = _e2179;
                                                } else {
                                                    phi_2239_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2183 = phi_2239_;
                                                let _e2188 = (2u * ((select(16u, (_e2150 / 16u), _e2180) * _e2145) + _e2146));
                                                let _e2191 = atomicAdd((&global_8.member[_e2188]), _e2183[0]);
                                                let _e2195 = (_e2183[1] + select(0u, 1u, ((_e2191 + _e2183[0]) < _e2183[0])));
                                                if (_e2195 == 0u) {
                                                } else {
                                                    let _e2200 = atomicAdd((&global_8.member[(_e2188 + 1u)]), _e2195);
                                                }
                                            }
                                            let _e2202 = bitcast<u32>(_e1669.member_1);
                                            let _e2205 = ((_e2202 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2205 == 0u) {
                                            } else {
                                                let _e2208 = (_e2205 % 16u);
                                                let _e2210 = ((_e2202 & 8388607u) | 8388608u);
                                                let _e2213 = (_e2210 << bitcast<u32>((_e2208 & 31u)));
                                                let _e2219 = ((_e2210 >> bitcast<u32>(((31u - _e2208) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2202 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2294_ = array<u32, 2>(_e2213, _e2219);
                                                } else {
                                                    let _e2225 = (~(_e2213) + 1u);
                                                    if (_e2225 == 0u) {
                                                        phi_2292_ = (~(_e2219) + 1u);
                                                    } else {
                                                        phi_2292_ = ~(_e2219);
                                                    }
                                                    let _e2231 = phi_2292_;
                                                    phi_2294_ = array<u32, 2>(_e2225, _e2231);
                                                }
                                                let _e2234 = phi_2294_;
                                                let _e2235 = (_e2205 < 255u);
                                                if _e2235 {
                                                    phi_2300_ = _e2234;
                                                } else {
                                                    phi_2300_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2238 = phi_2300_;
                                                let _e2243 = (2u * ((select(16u, (_e2205 / 16u), _e2235) * _e2145) + (_e2146 + 1u)));
                                                let _e2246 = atomicAdd((&global_8.member[_e2243]), _e2238[0]);
                                                let _e2250 = (_e2238[1] + select(0u, 1u, ((_e2246 + _e2238[0]) < _e2238[0])));
                                                if (_e2250 == 0u) {
                                                } else {
                                                    let _e2255 = atomicAdd((&global_8.member[(_e2243 + 1u)]), _e2250);
                                                }
                                            }
                                            let _e2257 = bitcast<u32>(_e1672.member_2);
                                            let _e2260 = ((_e2257 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2260 == 0u) {
                                            } else {
                                                let _e2263 = (_e2260 % 16u);
                                                let _e2265 = ((_e2257 & 8388607u) | 8388608u);
                                                let _e2268 = (_e2265 << bitcast<u32>((_e2263 & 31u)));
                                                let _e2274 = ((_e2265 >> bitcast<u32>(((31u - _e2263) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2257 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2355_ = array<u32, 2>(_e2268, _e2274);
                                                } else {
                                                    let _e2280 = (~(_e2268) + 1u);
                                                    if (_e2280 == 0u) {
                                                        phi_2353_ = (~(_e2274) + 1u);
                                                    } else {
                                                        phi_2353_ = ~(_e2274);
                                                    }
                                                    let _e2286 = phi_2353_;
                                                    phi_2355_ = array<u32, 2>(_e2280, _e2286);
                                                }
                                                let _e2289 = phi_2355_;
                                                let _e2290 = (_e2260 < 255u);
                                                if _e2290 {
                                                    phi_2361_ = _e2289;
                                                } else {
                                                    phi_2361_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2293 = phi_2361_;
                                                let _e2298 = (2u * ((select(16u, (_e2260 / 16u), _e2290) * _e2145) + (_e2146 + 2u)));
                                                let _e2301 = atomicAdd((&global_8.member[_e2298]), _e2293[0]);
                                                let _e2305 = (_e2293[1] + select(0u, 1u, ((_e2301 + _e2293[0]) < _e2293[0])));
                                                if (_e2305 == 0u) {
                                                } else {
                                                    let _e2310 = atomicAdd((&global_8.member[(_e2298 + 1u)]), _e2305);
                                                }
                                            }
                                            let _e2312 = bitcast<u32>(_e1675.member_3);
                                            let _e2315 = ((_e2312 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2315 == 0u) {
                                            } else {
                                                let _e2318 = (_e2315 % 16u);
                                                let _e2320 = ((_e2312 & 8388607u) | 8388608u);
                                                let _e2323 = (_e2320 << bitcast<u32>((_e2318 & 31u)));
                                                let _e2329 = ((_e2320 >> bitcast<u32>(((31u - _e2318) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2312 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2416_ = array<u32, 2>(_e2323, _e2329);
                                                } else {
                                                    let _e2335 = (~(_e2323) + 1u);
                                                    if (_e2335 == 0u) {
                                                        phi_2414_ = (~(_e2329) + 1u);
                                                    } else {
                                                        phi_2414_ = ~(_e2329);
                                                    }
                                                    let _e2341 = phi_2414_;
                                                    phi_2416_ = array<u32, 2>(_e2335, _e2341);
                                                }
                                                let _e2344 = phi_2416_;
                                                let _e2345 = (_e2315 < 255u);
                                                if _e2345 {
                                                    phi_2422_ = _e2344;
                                                } else {
                                                    phi_2422_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2348 = phi_2422_;
                                                let _e2353 = (2u * ((select(16u, (_e2315 / 16u), _e2345) * _e2145) + (_e2146 + 3u)));
                                                let _e2356 = atomicAdd((&global_8.member[_e2353]), _e2348[0]);
                                                let _e2360 = (_e2348[1] + select(0u, 1u, ((_e2356 + _e2348[0]) < _e2348[0])));
                                                if (_e2360 == 0u) {
                                                } else {
                                                    let _e2365 = atomicAdd((&global_8.member[(_e2353 + 1u)]), _e2360);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e757)] = vec4<f32>(_e1666.member, _e1669.member_1, _e1672.member_2, _e1675.member_3);
                                        }
                                    }
                                    if (_e775 < _e58) {
                                        if _e186 {
                                            let _e2371 = (4u * _e182);
                                            let _e2372 = (4u * _e761);
                                            let _e2373 = bitcast<u32>(_e1678.member);
                                            let _e2376 = ((_e2373 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2376 == 0u) {
                                            } else {
                                                let _e2379 = (_e2376 % 16u);
                                                let _e2381 = ((_e2373 & 8388607u) | 8388608u);
                                                let _e2384 = (_e2381 << bitcast<u32>((_e2379 & 31u)));
                                                let _e2390 = ((_e2381 >> bitcast<u32>(((31u - _e2379) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2373 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2488_ = array<u32, 2>(_e2384, _e2390);
                                                } else {
                                                    let _e2396 = (~(_e2384) + 1u);
                                                    if (_e2396 == 0u) {
                                                        phi_2486_ = (~(_e2390) + 1u);
                                                    } else {
                                                        phi_2486_ = ~(_e2390);
                                                    }
                                                    let _e2402 = phi_2486_;
                                                    phi_2488_ = array<u32, 2>(_e2396, _e2402);
                                                }
                                                let _e2405 = phi_2488_;
                                                let _e2406 = (_e2376 < 255u);
                                                if _e2406 {
                                                    phi_2494_ = _e2405;
                                                } else {
                                                    phi_2494_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2409 = phi_2494_;
                                                let _e2414 = (2u * ((select(16u, (_e2376 / 16u), _e2406) * _e2371) + _e2372));
                                                let _e2417 = atomicAdd((&global_8.member[_e2414]), _e2409[0]);
                                                let _e2421 = (_e2409[1] + select(0u, 1u, ((_e2417 + _e2409[0]) < _e2409[0])));
                                                if (_e2421 == 0u) {
                                                } else {
                                                    let _e2426 = atomicAdd((&global_8.member[(_e2414 + 1u)]), _e2421);
                                                }
                                            }
                                            let _e2428 = bitcast<u32>(_e1681.member_1);
                                            let _e2431 = ((_e2428 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2431 == 0u) {
                                            } else {
                                                let _e2434 = (_e2431 % 16u);
                                                let _e2436 = ((_e2428 & 8388607u) | 8388608u);
                                                let _e2439 = (_e2436 << bitcast<u32>((_e2434 & 31u)));
                                                let _e2445 = ((_e2436 >> bitcast<u32>(((31u - _e2434) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2428 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2549_ = array<u32, 2>(_e2439, _e2445);
                                                } else {
                                                    let _e2451 = (~(_e2439) + 1u);
                                                    if (_e2451 == 0u) {
                                                        phi_2547_ = (~(_e2445) + 1u);
                                                    } else {
                                                        phi_2547_ = ~(_e2445);
                                                    }
                                                    let _e2457 = phi_2547_;
                                                    phi_2549_ = array<u32, 2>(_e2451, _e2457);
                                                }
                                                let _e2460 = phi_2549_;
                                                let _e2461 = (_e2431 < 255u);
                                                if _e2461 {
                                                    phi_2555_ = _e2460;
                                                } else {
                                                    phi_2555_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2464 = phi_2555_;
                                                let _e2469 = (2u * ((select(16u, (_e2431 / 16u), _e2461) * _e2371) + (_e2372 + 1u)));
                                                let _e2472 = atomicAdd((&global_8.member[_e2469]), _e2464[0]);
                                                let _e2476 = (_e2464[1] + select(0u, 1u, ((_e2472 + _e2464[0]) < _e2464[0])));
                                                if (_e2476 == 0u) {
                                                } else {
                                                    let _e2481 = atomicAdd((&global_8.member[(_e2469 + 1u)]), _e2476);
                                                }
                                            }
                                            let _e2483 = bitcast<u32>(_e1684.member_2);
                                            let _e2486 = ((_e2483 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2486 == 0u) {
                                            } else {
                                                let _e2489 = (_e2486 % 16u);
                                                let _e2491 = ((_e2483 & 8388607u) | 8388608u);
                                                let _e2494 = (_e2491 << bitcast<u32>((_e2489 & 31u)));
                                                let _e2500 = ((_e2491 >> bitcast<u32>(((31u - _e2489) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2483 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2610_ = array<u32, 2>(_e2494, _e2500);
                                                } else {
                                                    let _e2506 = (~(_e2494) + 1u);
                                                    if (_e2506 == 0u) {
                                                        phi_2608_ = (~(_e2500) + 1u);
                                                    } else {
                                                        phi_2608_ = ~(_e2500);
                                                    }
                                                    let _e2512 = phi_2608_;
                                                    phi_2610_ = array<u32, 2>(_e2506, _e2512);
                                                }
                                                let _e2515 = phi_2610_;
                                                let _e2516 = (_e2486 < 255u);
                                                if _e2516 {
                                                    phi_2616_ = _e2515;
                                                } else {
                                                    phi_2616_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2519 = phi_2616_;
                                                let _e2524 = (2u * ((select(16u, (_e2486 / 16u), _e2516) * _e2371) + (_e2372 + 2u)));
                                                let _e2527 = atomicAdd((&global_8.member[_e2524]), _e2519[0]);
                                                let _e2531 = (_e2519[1] + select(0u, 1u, ((_e2527 + _e2519[0]) < _e2519[0])));
                                                if (_e2531 == 0u) {
                                                } else {
                                                    let _e2536 = atomicAdd((&global_8.member[(_e2524 + 1u)]), _e2531);
                                                }
                                            }
                                            let _e2538 = bitcast<u32>(_e1687.member_3);
                                            let _e2541 = ((_e2538 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2541 == 0u) {
                                            } else {
                                                let _e2544 = (_e2541 % 16u);
                                                let _e2546 = ((_e2538 & 8388607u) | 8388608u);
                                                let _e2549 = (_e2546 << bitcast<u32>((_e2544 & 31u)));
                                                let _e2555 = ((_e2546 >> bitcast<u32>(((31u - _e2544) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2538 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2671_ = array<u32, 2>(_e2549, _e2555);
                                                } else {
                                                    let _e2561 = (~(_e2549) + 1u);
                                                    if (_e2561 == 0u) {
                                                        phi_2669_ = (~(_e2555) + 1u);
                                                    } else {
                                                        phi_2669_ = ~(_e2555);
                                                    }
                                                    let _e2567 = phi_2669_;
                                                    phi_2671_ = array<u32, 2>(_e2561, _e2567);
                                                }
                                                let _e2570 = phi_2671_;
                                                let _e2571 = (_e2541 < 255u);
                                                if _e2571 {
                                                    phi_2677_ = _e2570;
                                                } else {
                                                    phi_2677_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2574 = phi_2677_;
                                                let _e2579 = (2u * ((select(16u, (_e2541 / 16u), _e2571) * _e2371) + (_e2372 + 3u)));
                                                let _e2582 = atomicAdd((&global_8.member[_e2579]), _e2574[0]);
                                                let _e2586 = (_e2574[1] + select(0u, 1u, ((_e2582 + _e2574[0]) < _e2574[0])));
                                                if (_e2586 == 0u) {
                                                } else {
                                                    let _e2591 = atomicAdd((&global_8.member[(_e2579 + 1u)]), _e2586);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e761)] = vec4<f32>(_e1678.member, _e1681.member_1, _e1684.member_2, _e1687.member_3);
                                        }
                                    }
                                } else {
                                    let _e197 = global_3.member.member_6;
                                    let _e198 = (_e197 + _e169);
                                    if _e188 {
                                        let _e202 = global_6.member[(_e183 + _e198)];
                                        phi_246_ = _e202;
                                    } else {
                                        phi_246_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e204 = phi_246_;
                                    phi_255_ = type_19((_e173 / 4u), _e173, _e176);
                                    phi_258_ = type_18(_e204.x, _e204.y, _e204.z, _e204.w);
                                    loop {
                                        let _e213 = phi_255_;
                                        let _e215 = phi_258_;
                                        local_30 = _e213;
                                        local_32 = _e215;
                                        let _e217 = (4u * _e213.member);
                                        if (_e217 < _e213.member_2) {
                                            phi_274_ = select(((_e217 + 4u) > _e213.member_2), true, (_e217 < _e213.member_1));
                                        } else {
                                            phi_274_ = false;
                                        }
                                        let _e226 = phi_274_;
                                        if _e226 {
                                            let _e227 = (_e193 / 4u);
                                            let _e228 = (_e191 / 4u);
                                            let _e232 = global_7.member[(_e227 + _e213.member)];
                                            let _e239 = (_e213.member_2 - _e213.member_1);
                                            let _e240 = ((_e217 - _e213.member_1) < _e239);
                                            let _e244 = (((_e217 + 1u) - _e213.member_1) < _e239);
                                            let _e248 = (((_e217 + 2u) - _e213.member_1) < _e239);
                                            let _e252 = (((_e217 + 3u) - _e213.member_1) < _e239);
                                            let _e258 = global_7.member[((_e227 + _e228) + _e213.member)];
                                            let _e272 = global_7.member[((_e227 + (2u * _e228)) + _e213.member)];
                                            let _e286 = global_7.member[((_e227 + (3u * _e228)) + _e213.member)];
                                            local_28 = type_19((_e213.member + 1u), _e213.member_1, _e213.member_2);
                                            local_29 = type_18(((((_e215.member + select(0f, _e232.x, _e240)) + select(0f, _e232.y, _e244)) + select(0f, _e232.z, _e248)) + select(0f, _e232.w, _e252)), ((((_e215.member_1 + select(0f, _e258.x, _e240)) + select(0f, _e258.y, _e244)) + select(0f, _e258.z, _e248)) + select(0f, _e258.w, _e252)), ((((_e215.member_2 + select(0f, _e272.x, _e240)) + select(0f, _e272.y, _e244)) + select(0f, _e272.z, _e248)) + select(0f, _e272.w, _e252)), ((((_e215.member_3 + select(0f, _e286.x, _e240)) + select(0f, _e286.y, _e244)) + select(0f, _e286.z, _e248)) + select(0f, _e286.w, _e252)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2641 = local_28;
                                            phi_255_ = _e2641;
                                            let _e2644 = local_29;
                                            phi_258_ = _e2644;
                                        }
                                    }
                                    let _e2648 = local_30;
                                    phi_362_ = _e2648;
                                    let _e2653 = local_32;
                                    phi_365_ = _e2653;
                                    loop {
                                        let _e322 = phi_362_;
                                        let _e324 = phi_365_;
                                        local_34 = _e322;
                                        local_36 = _e324;
                                        if !((((4u * _e322.member) + 4u) > _e322.member_2)) {
                                            let _e331 = (_e193 / 4u);
                                            let _e332 = (_e191 / 4u);
                                            let _e336 = global_7.member[(_e331 + _e322.member)];
                                            let _e345 = global_7.member[((_e331 + _e332) + _e322.member)];
                                            let _e355 = global_7.member[((_e331 + (2u * _e332)) + _e322.member)];
                                            let _e365 = global_7.member[((_e331 + (3u * _e332)) + _e322.member)];
                                            local_31 = type_19((_e322.member + 1u), _e322.member_1, _e322.member_2);
                                            local_33 = type_18(((((_e324.member + _e336.x) + _e336.y) + _e336.z) + _e336.w), ((((_e324.member_1 + _e345.x) + _e345.y) + _e345.z) + _e345.w), ((((_e324.member_2 + _e355.x) + _e355.y) + _e355.z) + _e355.w), ((((_e324.member_3 + _e365.x) + _e365.y) + _e365.z) + _e365.w));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2650 = local_31;
                                            phi_362_ = _e2650;
                                            let _e2655 = local_33;
                                            phi_365_ = _e2655;
                                        }
                                    }
                                    let _e2658 = local_34;
                                    phi_432_ = _e2658;
                                    let _e2663 = local_36;
                                    phi_435_ = _e2663;
                                    loop {
                                        let _e397 = phi_432_;
                                        let _e399 = phi_435_;
                                        local_2 = _e399;
                                        local_3 = _e399;
                                        local_4 = _e399;
                                        local_5 = _e399;
                                        let _e401 = (4u * _e397.member);
                                        if (_e401 < _e397.member_2) {
                                            phi_451_ = select(((_e401 + 4u) > _e397.member_2), true, (_e401 < _e397.member_1));
                                        } else {
                                            phi_451_ = false;
                                        }
                                        let _e410 = phi_451_;
                                        if _e410 {
                                            let _e411 = (_e193 / 4u);
                                            let _e412 = (_e191 / 4u);
                                            let _e416 = global_7.member[(_e411 + _e397.member)];
                                            let _e423 = (_e397.member_2 - _e397.member_1);
                                            let _e424 = ((_e401 - _e397.member_1) < _e423);
                                            let _e428 = (((_e401 + 1u) - _e397.member_1) < _e423);
                                            let _e432 = (((_e401 + 2u) - _e397.member_1) < _e423);
                                            let _e436 = (((_e401 + 3u) - _e397.member_1) < _e423);
                                            let _e442 = global_7.member[((_e411 + _e412) + _e397.member)];
                                            let _e456 = global_7.member[((_e411 + (2u * _e412)) + _e397.member)];
                                            let _e470 = global_7.member[((_e411 + (3u * _e412)) + _e397.member)];
                                            local_35 = type_19((_e397.member + 1u), _e397.member_1, _e397.member_2);
                                            local_37 = type_18(((((_e399.member + select(0f, _e416.x, _e424)) + select(0f, _e416.y, _e428)) + select(0f, _e416.z, _e432)) + select(0f, _e416.w, _e436)), ((((_e399.member_1 + select(0f, _e442.x, _e424)) + select(0f, _e442.y, _e428)) + select(0f, _e442.z, _e432)) + select(0f, _e442.w, _e436)), ((((_e399.member_2 + select(0f, _e456.x, _e424)) + select(0f, _e456.y, _e428)) + select(0f, _e456.z, _e432)) + select(0f, _e456.w, _e436)), ((((_e399.member_3 + select(0f, _e470.x, _e424)) + select(0f, _e470.y, _e428)) + select(0f, _e470.z, _e432)) + select(0f, _e470.w, _e436)));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2660 = local_35;
                                            phi_432_ = _e2660;
                                            let _e2665 = local_37;
                                            phi_435_ = _e2665;
                                        }
                                    }
                                    let _e506 = local_2;
                                    let _e509 = local_3;
                                    let _e512 = local_4;
                                    let _e515 = local_5;
                                    if _e186 {
                                        let _e521 = (4u * _e182);
                                        let _e522 = (4u * _e198);
                                        let _e523 = bitcast<u32>(_e506.member);
                                        let _e526 = ((_e523 >> bitcast<u32>(23i)) & 255u);
                                        if (_e526 == 0u) {
                                        } else {
                                            let _e529 = (_e526 % 16u);
                                            let _e531 = ((_e523 & 8388607u) | 8388608u);
                                            let _e534 = (_e531 << bitcast<u32>((_e529 & 31u)));
                                            let _e540 = ((_e531 >> bitcast<u32>(((31u - _e529) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e523 >> bitcast<u32>(31i)) == 0u) {
                                                phi_584_ = array<u32, 2>(_e534, _e540);
                                            } else {
                                                let _e546 = (~(_e534) + 1u);
                                                if (_e546 == 0u) {
                                                    phi_582_ = (~(_e540) + 1u);
                                                } else {
                                                    phi_582_ = ~(_e540);
                                                }
                                                let _e552 = phi_582_;
                                                phi_584_ = array<u32, 2>(_e546, _e552);
                                            }
                                            let _e555 = phi_584_;
                                            let _e556 = (_e526 < 255u);
                                            if _e556 {
                                                phi_590_ = _e555;
                                            } else {
                                                phi_590_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e559 = phi_590_;
                                            let _e564 = (2u * ((select(16u, (_e526 / 16u), _e556) * _e521) + _e522));
                                            let _e567 = atomicAdd((&global_8.member[_e564]), _e559[0]);
                                            let _e571 = (_e559[1] + select(0u, 1u, ((_e567 + _e559[0]) < _e559[0])));
                                            if (_e571 == 0u) {
                                            } else {
                                                let _e576 = atomicAdd((&global_8.member[(_e564 + 1u)]), _e571);
                                            }
                                        }
                                        let _e578 = bitcast<u32>(_e509.member_1);
                                        let _e581 = ((_e578 >> bitcast<u32>(23i)) & 255u);
                                        if (_e581 == 0u) {
                                        } else {
                                            let _e584 = (_e581 % 16u);
                                            let _e586 = ((_e578 & 8388607u) | 8388608u);
                                            let _e589 = (_e586 << bitcast<u32>((_e584 & 31u)));
                                            let _e595 = ((_e586 >> bitcast<u32>(((31u - _e584) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e578 >> bitcast<u32>(31i)) == 0u) {
                                                phi_645_ = array<u32, 2>(_e589, _e595);
                                            } else {
                                                let _e601 = (~(_e589) + 1u);
                                                if (_e601 == 0u) {
                                                    phi_643_ = (~(_e595) + 1u);
                                                } else {
                                                    phi_643_ = ~(_e595);
                                                }
                                                let _e607 = phi_643_;
                                                phi_645_ = array<u32, 2>(_e601, _e607);
                                            }
                                            let _e610 = phi_645_;
                                            let _e611 = (_e581 < 255u);
                                            if _e611 {
                                                phi_651_ = _e610;
                                            } else {
                                                phi_651_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e614 = phi_651_;
                                            let _e619 = (2u * ((select(16u, (_e581 / 16u), _e611) * _e521) + (_e522 + 1u)));
                                            let _e622 = atomicAdd((&global_8.member[_e619]), _e614[0]);
                                            let _e626 = (_e614[1] + select(0u, 1u, ((_e622 + _e614[0]) < _e614[0])));
                                            if (_e626 == 0u) {
                                            } else {
                                                let _e631 = atomicAdd((&global_8.member[(_e619 + 1u)]), _e626);
                                            }
                                        }
                                        let _e633 = bitcast<u32>(_e512.member_2);
                                        let _e636 = ((_e633 >> bitcast<u32>(23i)) & 255u);
                                        if (_e636 == 0u) {
                                        } else {
                                            let _e639 = (_e636 % 16u);
                                            let _e641 = ((_e633 & 8388607u) | 8388608u);
                                            let _e644 = (_e641 << bitcast<u32>((_e639 & 31u)));
                                            let _e650 = ((_e641 >> bitcast<u32>(((31u - _e639) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e633 >> bitcast<u32>(31i)) == 0u) {
                                                phi_706_ = array<u32, 2>(_e644, _e650);
                                            } else {
                                                let _e656 = (~(_e644) + 1u);
                                                if (_e656 == 0u) {
                                                    phi_704_ = (~(_e650) + 1u);
                                                } else {
                                                    phi_704_ = ~(_e650);
                                                }
                                                let _e662 = phi_704_;
                                                phi_706_ = array<u32, 2>(_e656, _e662);
                                            }
                                            let _e665 = phi_706_;
                                            let _e666 = (_e636 < 255u);
                                            if _e666 {
                                                phi_712_ = _e665;
                                            } else {
                                                phi_712_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e669 = phi_712_;
                                            let _e674 = (2u * ((select(16u, (_e636 / 16u), _e666) * _e521) + (_e522 + 2u)));
                                            let _e677 = atomicAdd((&global_8.member[_e674]), _e669[0]);
                                            let _e681 = (_e669[1] + select(0u, 1u, ((_e677 + _e669[0]) < _e669[0])));
                                            if (_e681 == 0u) {
                                            } else {
                                                let _e686 = atomicAdd((&global_8.member[(_e674 + 1u)]), _e681);
                                            }
                                        }
                                        let _e688 = bitcast<u32>(_e515.member_3);
                                        let _e691 = ((_e688 >> bitcast<u32>(23i)) & 255u);
                                        if (_e691 == 0u) {
                                        } else {
                                            let _e694 = (_e691 % 16u);
                                            let _e696 = ((_e688 & 8388607u) | 8388608u);
                                            let _e699 = (_e696 << bitcast<u32>((_e694 & 31u)));
                                            let _e705 = ((_e696 >> bitcast<u32>(((31u - _e694) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e688 >> bitcast<u32>(31i)) == 0u) {
                                                phi_767_ = array<u32, 2>(_e699, _e705);
                                            } else {
                                                let _e711 = (~(_e699) + 1u);
                                                if (_e711 == 0u) {
                                                    phi_765_ = (~(_e705) + 1u);
                                                } else {
                                                    phi_765_ = ~(_e705);
                                                }
                                                let _e717 = phi_765_;
                                                phi_767_ = array<u32, 2>(_e711, _e717);
                                            }
                                            let _e720 = phi_767_;
                                            let _e721 = (_e691 < 255u);
                                            if _e721 {
                                                phi_773_ = _e720;
                                            } else {
                                                phi_773_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e724 = phi_773_;
                                            let _e729 = (2u * ((select(16u, (_e691 / 16u), _e721) * _e521) + (_e522 + 3u)));
                                            let _e732 = atomicAdd((&global_8.member[_e729]), _e724[0]);
                                            let _e736 = (_e724[1] + select(0u, 1u, ((_e732 + _e724[0]) < _e724[0])));
                                            if (_e736 == 0u) {
                                            } else {
                                                let _e741 = atomicAdd((&global_8.member[(_e729 + 1u)]), _e736);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e198)] = vec4<f32>(_e506.member, _e509.member_1, _e512.member_2, _e515.member_3);
                                    }
                                }
                                phi_187_ = _e157;
                                phi_190_ = _e166;
                                phi_192_ = _e161;
                            }
                            let _e2604 = phi_187_;
                            let _e2606 = phi_190_;
                            let _e2608 = phi_192_;
                            local_24 = _e2604;
                            local_25 = _e2606;
                            local_27 = _e2608;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2628 = local_24;
                            phi_186_ = _e2628;
                            let _e2631 = local_25;
                            phi_189_ = _e2631;
                            let _e2636 = local_27;
                            phi_191_ = _e2636;
                        }
                    }
                    let _e2610 = phi_2708_;
                    if _e2610 {
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
