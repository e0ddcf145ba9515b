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
    var phi_638_: u32;
    var phi_640_: array<u32, 2>;
    var phi_646_: array<u32, 2>;
    var phi_694_: u32;
    var phi_696_: array<u32, 2>;
    var phi_702_: array<u32, 2>;
    var phi_750_: u32;
    var phi_752_: array<u32, 2>;
    var phi_758_: array<u32, 2>;
    var phi_814_: vec4<f32>;
    var phi_825_: vec4<f32>;
    var phi_836_: vec4<f32>;
    var phi_847_: vec4<f32>;
    var phi_862_: type_18;
    var phi_865_: type_18;
    var phi_867_: type_18;
    var phi_869_: type_18;
    var phi_871_: type_19;
    var phi_887_: bool;
    var phi_1141_: type_18;
    var phi_1144_: type_18;
    var phi_1146_: type_18;
    var phi_1148_: type_18;
    var phi_1150_: type_19;
    var phi_1367_: type_18;
    var phi_1370_: type_18;
    var phi_1372_: type_18;
    var phi_1374_: type_18;
    var phi_1376_: type_19;
    var phi_1392_: bool;
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
    var phi_1701_: u32;
    var phi_1703_: array<u32, 2>;
    var phi_1709_: array<u32, 2>;
    var phi_1757_: u32;
    var phi_1759_: array<u32, 2>;
    var phi_1765_: array<u32, 2>;
    var phi_1813_: u32;
    var phi_1815_: array<u32, 2>;
    var phi_1821_: array<u32, 2>;
    var phi_1869_: u32;
    var phi_1871_: array<u32, 2>;
    var phi_1877_: array<u32, 2>;
    var phi_1936_: u32;
    var phi_1938_: array<u32, 2>;
    var phi_1944_: array<u32, 2>;
    var phi_1992_: u32;
    var phi_1994_: array<u32, 2>;
    var phi_2000_: array<u32, 2>;
    var phi_2048_: u32;
    var phi_2050_: array<u32, 2>;
    var phi_2056_: array<u32, 2>;
    var phi_2104_: u32;
    var phi_2106_: array<u32, 2>;
    var phi_2112_: array<u32, 2>;
    var phi_2171_: u32;
    var phi_2173_: array<u32, 2>;
    var phi_2179_: array<u32, 2>;
    var phi_2227_: u32;
    var phi_2229_: array<u32, 2>;
    var phi_2235_: array<u32, 2>;
    var phi_2283_: u32;
    var phi_2285_: array<u32, 2>;
    var phi_2291_: array<u32, 2>;
    var phi_2339_: u32;
    var phi_2341_: array<u32, 2>;
    var phi_2347_: array<u32, 2>;
    var phi_2406_: u32;
    var phi_2408_: array<u32, 2>;
    var phi_2414_: array<u32, 2>;
    var phi_2462_: u32;
    var phi_2464_: array<u32, 2>;
    var phi_2470_: array<u32, 2>;
    var phi_2518_: u32;
    var phi_2520_: array<u32, 2>;
    var phi_2526_: array<u32, 2>;
    var phi_2574_: u32;
    var phi_2576_: array<u32, 2>;
    var phi_2582_: array<u32, 2>;
    var phi_2607_: u32;
    var phi_187_: u32;
    var phi_190_: u32;
    var phi_192_: u32;
    var phi_2608_: bool;
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
                            let _e2593 = local_22;
                            phi_111_ = _e2593;
                            let _e2596 = local_23;
                            phi_114_ = _e2596;
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
                    let _e2614 = local_26;
                    phi_191_ = _e2614;
                    loop {
                        let _e157 = phi_186_;
                        let _e159 = phi_189_;
                        let _e161 = phi_191_;
                        phi_2608_ = false;
                        if (_e159 < select(_e68, _e76, (_e76 < _e68))) {
                            if (_e159 == _e157) {
                                let _e2577 = global_4.member[((_e161 + 2u) * _e111)];
                                if _e121 {
                                    phi_2607_ = _e2577;
                                } else {
                                    let _e2580 = global_5.member[_e2577];
                                    phi_2607_ = _e2580;
                                }
                                let _e2582 = phi_2607_;
                                phi_187_ = _e2582;
                                phi_190_ = _e159;
                                phi_192_ = (_e161 + 1u);
                            } else {
                                let _e164 = (_e159 + _e55);
                                let _e166 = select(_e157, _e164, (_e164 < _e157));
                                let _e167 = (_e52 == 0u);
                                if _e167 {
                                    phi_2608_ = true;
                                    break;
                                }
                                let _e168 = (_e49 / _e52);
                                if _e167 {
                                    phi_2608_ = true;
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
                                    let _e738 = (_e168 * 4u);
                                    let _e741 = global_3.member.member_5;
                                    let _e744 = ((_e741 + (_e738 * _e52)) + _e169);
                                    let _e745 = (_e59 - _e738);
                                    let _e749 = (_e744 + (select(_e745, 1u, (1u < _e745)) * _e52));
                                    let _e753 = (_e744 + (select(_e745, 2u, (2u < _e745)) * _e52));
                                    let _e757 = (_e744 + (select(_e745, 3u, (3u < _e745)) * _e52));
                                    let _e763 = (_e738 + 1u);
                                    let _e767 = (_e738 + 2u);
                                    let _e771 = (_e738 + 3u);
                                    if _e188 {
                                        let _e777 = global_6.member[(_e183 + _e744)];
                                        phi_814_ = _e777;
                                    } else {
                                        phi_814_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e779 = phi_814_;
                                    if _e188 {
                                        let _e787 = global_6.member[(_e183 + _e749)];
                                        phi_825_ = _e787;
                                    } else {
                                        phi_825_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e789 = phi_825_;
                                    if _e188 {
                                        let _e797 = global_6.member[(_e183 + _e753)];
                                        phi_836_ = _e797;
                                    } else {
                                        phi_836_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e799 = phi_836_;
                                    if _e188 {
                                        let _e807 = global_6.member[(_e183 + _e757)];
                                        phi_847_ = _e807;
                                    } else {
                                        phi_847_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e809 = phi_847_;
                                    let _e817 = ((_e738 * _e191) / 4u);
                                    let _e818 = ((select(_e59, _e763, (_e763 < _e59)) * _e191) / 4u);
                                    let _e819 = ((select(_e59, _e767, (_e767 < _e59)) * _e191) / 4u);
                                    let _e820 = ((select(_e59, _e771, (_e771 < _e59)) * _e191) / 4u);
                                    let _e821 = (_e193 / 4u);
                                    let _e822 = (_e191 / 4u);
                                    phi_862_ = type_18(_e809.x, _e809.y, _e809.z, _e809.w);
                                    phi_865_ = type_18(_e799.x, _e799.y, _e799.z, _e799.w);
                                    phi_867_ = type_18(_e789.x, _e789.y, _e789.z, _e789.w);
                                    phi_869_ = type_18(_e779.x, _e779.y, _e779.z, _e779.w);
                                    phi_871_ = type_19((_e173 / 4u), _e173, _e176);
                                    loop {
                                        let _e824 = phi_862_;
                                        let _e826 = phi_865_;
                                        let _e828 = phi_867_;
                                        let _e830 = phi_869_;
                                        let _e832 = phi_871_;
                                        local_43 = _e824;
                                        local_45 = _e826;
                                        local_47 = _e828;
                                        local_49 = _e830;
                                        local_51 = _e832;
                                        let _e834 = (4u * _e832.member);
                                        if (_e834 < _e832.member_2) {
                                            phi_887_ = select(((_e834 + 4u) > _e832.member_2), true, (_e834 < _e832.member_1));
                                        } else {
                                            phi_887_ = false;
                                        }
                                        let _e843 = phi_887_;
                                        if _e843 {
                                            let _e847 = global_7.member[(_e821 + _e832.member)];
                                            let _e854 = (_e832.member_2 - _e832.member_1);
                                            let _e855 = ((_e834 - _e832.member_1) < _e854);
                                            let _e856 = select(0f, _e847.x, _e855);
                                            let _e859 = (((_e834 + 1u) - _e832.member_1) < _e854);
                                            let _e860 = select(0f, _e847.y, _e859);
                                            let _e863 = (((_e834 + 2u) - _e832.member_1) < _e854);
                                            let _e864 = select(0f, _e847.z, _e863);
                                            let _e867 = (((_e834 + 3u) - _e832.member_1) < _e854);
                                            let _e868 = select(0f, _e847.w, _e867);
                                            let _e873 = global_7.member[((_e821 + _e822) + _e832.member)];
                                            let _e878 = select(0f, _e873.x, _e855);
                                            let _e879 = select(0f, _e873.y, _e859);
                                            let _e880 = select(0f, _e873.z, _e863);
                                            let _e881 = select(0f, _e873.w, _e867);
                                            let _e887 = global_7.member[((_e821 + (2u * _e822)) + _e832.member)];
                                            let _e892 = select(0f, _e887.x, _e855);
                                            let _e893 = select(0f, _e887.y, _e859);
                                            let _e894 = select(0f, _e887.z, _e863);
                                            let _e895 = select(0f, _e887.w, _e867);
                                            let _e901 = global_7.member[((_e821 + (3u * _e822)) + _e832.member)];
                                            let _e906 = select(0f, _e901.x, _e855);
                                            let _e907 = select(0f, _e901.y, _e859);
                                            let _e908 = select(0f, _e901.z, _e863);
                                            let _e909 = select(0f, _e901.w, _e867);
                                            let _e913 = global_9.member[(_e817 + _e832.member)];
                                            let _e918 = select(0f, _e913.x, _e855);
                                            let _e919 = select(0f, _e913.y, _e859);
                                            let _e920 = select(0f, _e913.z, _e863);
                                            let _e921 = select(0f, _e913.w, _e867);
                                            let _e925 = global_9.member[(_e818 + _e832.member)];
                                            let _e930 = select(0f, _e925.x, _e855);
                                            let _e931 = select(0f, _e925.y, _e859);
                                            let _e932 = select(0f, _e925.z, _e863);
                                            let _e933 = select(0f, _e925.w, _e867);
                                            let _e937 = global_9.member[(_e819 + _e832.member)];
                                            let _e942 = select(0f, _e937.x, _e855);
                                            let _e943 = select(0f, _e937.y, _e859);
                                            let _e944 = select(0f, _e937.z, _e863);
                                            let _e945 = select(0f, _e937.w, _e867);
                                            let _e949 = global_9.member[(_e820 + _e832.member)];
                                            let _e954 = select(0f, _e949.x, _e855);
                                            let _e955 = select(0f, _e949.y, _e859);
                                            let _e956 = select(0f, _e949.z, _e863);
                                            let _e957 = select(0f, _e949.w, _e867);
                                            local_38 = type_18(((_e957 * _e868) + ((_e956 * _e864) + ((_e955 * _e860) + ((_e954 * _e856) + _e824.member)))), ((_e957 * _e881) + ((_e956 * _e880) + ((_e955 * _e879) + ((_e954 * _e878) + _e824.member_1)))), ((_e957 * _e895) + ((_e956 * _e894) + ((_e955 * _e893) + ((_e954 * _e892) + _e824.member_2)))), ((_e957 * _e909) + ((_e956 * _e908) + ((_e955 * _e907) + ((_e954 * _e906) + _e824.member_3)))));
                                            local_39 = type_18(((_e945 * _e868) + ((_e944 * _e864) + ((_e943 * _e860) + ((_e942 * _e856) + _e826.member)))), ((_e945 * _e881) + ((_e944 * _e880) + ((_e943 * _e879) + ((_e942 * _e878) + _e826.member_1)))), ((_e945 * _e895) + ((_e944 * _e894) + ((_e943 * _e893) + ((_e942 * _e892) + _e826.member_2)))), ((_e945 * _e909) + ((_e944 * _e908) + ((_e943 * _e907) + ((_e942 * _e906) + _e826.member_3)))));
                                            local_40 = type_18(((_e933 * _e868) + ((_e932 * _e864) + ((_e931 * _e860) + ((_e930 * _e856) + _e828.member)))), ((_e933 * _e881) + ((_e932 * _e880) + ((_e931 * _e879) + ((_e930 * _e878) + _e828.member_1)))), ((_e933 * _e895) + ((_e932 * _e894) + ((_e931 * _e893) + ((_e930 * _e892) + _e828.member_2)))), ((_e933 * _e909) + ((_e932 * _e908) + ((_e931 * _e907) + ((_e930 * _e906) + _e828.member_3)))));
                                            local_41 = type_18(((_e921 * _e868) + ((_e920 * _e864) + ((_e919 * _e860) + ((_e918 * _e856) + _e830.member)))), ((_e921 * _e881) + ((_e920 * _e880) + ((_e919 * _e879) + ((_e918 * _e878) + _e830.member_1)))), ((_e921 * _e895) + ((_e920 * _e894) + ((_e919 * _e893) + ((_e918 * _e892) + _e830.member_2)))), ((_e921 * _e909) + ((_e920 * _e908) + ((_e919 * _e907) + ((_e918 * _e906) + _e830.member_3)))));
                                            local_42 = type_19((_e832.member + 1u), _e832.member_1, _e832.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2669 = local_38;
                                            phi_862_ = _e2669;
                                            let _e2672 = local_39;
                                            phi_865_ = _e2672;
                                            let _e2675 = local_40;
                                            phi_867_ = _e2675;
                                            let _e2678 = local_41;
                                            phi_869_ = _e2678;
                                            let _e2681 = local_42;
                                            phi_871_ = _e2681;
                                        }
                                    }
                                    let _e2685 = local_43;
                                    phi_1141_ = _e2685;
                                    let _e2690 = local_45;
                                    phi_1144_ = _e2690;
                                    let _e2695 = local_47;
                                    phi_1146_ = _e2695;
                                    let _e2700 = local_49;
                                    phi_1148_ = _e2700;
                                    let _e2705 = local_51;
                                    phi_1150_ = _e2705;
                                    loop {
                                        let _e1112 = phi_1141_;
                                        let _e1114 = phi_1144_;
                                        let _e1116 = phi_1146_;
                                        let _e1118 = phi_1148_;
                                        let _e1120 = phi_1150_;
                                        local_53 = _e1112;
                                        local_55 = _e1114;
                                        local_57 = _e1116;
                                        local_59 = _e1118;
                                        local_61 = _e1120;
                                        if !((((4u * _e1120.member) + 4u) > _e1120.member_2)) {
                                            let _e1130 = global_7.member[(_e821 + _e1120.member)];
                                            let _e1139 = global_7.member[((_e821 + _e822) + _e1120.member)];
                                            let _e1149 = global_7.member[((_e821 + (2u * _e822)) + _e1120.member)];
                                            let _e1159 = global_7.member[((_e821 + (3u * _e822)) + _e1120.member)];
                                            let _e1167 = global_9.member[(_e817 + _e1120.member)];
                                            let _e1175 = global_9.member[(_e818 + _e1120.member)];
                                            let _e1183 = global_9.member[(_e819 + _e1120.member)];
                                            let _e1191 = global_9.member[(_e820 + _e1120.member)];
                                            local_44 = type_18(((_e1191.w * _e1130.w) + ((_e1191.z * _e1130.z) + ((_e1191.y * _e1130.y) + ((_e1191.x * _e1130.x) + _e1112.member)))), ((_e1191.w * _e1139.w) + ((_e1191.z * _e1139.z) + ((_e1191.y * _e1139.y) + ((_e1191.x * _e1139.x) + _e1112.member_1)))), ((_e1191.w * _e1149.w) + ((_e1191.z * _e1149.z) + ((_e1191.y * _e1149.y) + ((_e1191.x * _e1149.x) + _e1112.member_2)))), ((_e1191.w * _e1159.w) + ((_e1191.z * _e1159.z) + ((_e1191.y * _e1159.y) + ((_e1191.x * _e1159.x) + _e1112.member_3)))));
                                            local_46 = type_18(((_e1183.w * _e1130.w) + ((_e1183.z * _e1130.z) + ((_e1183.y * _e1130.y) + ((_e1183.x * _e1130.x) + _e1114.member)))), ((_e1183.w * _e1139.w) + ((_e1183.z * _e1139.z) + ((_e1183.y * _e1139.y) + ((_e1183.x * _e1139.x) + _e1114.member_1)))), ((_e1183.w * _e1149.w) + ((_e1183.z * _e1149.z) + ((_e1183.y * _e1149.y) + ((_e1183.x * _e1149.x) + _e1114.member_2)))), ((_e1183.w * _e1159.w) + ((_e1183.z * _e1159.z) + ((_e1183.y * _e1159.y) + ((_e1183.x * _e1159.x) + _e1114.member_3)))));
                                            local_48 = type_18(((_e1175.w * _e1130.w) + ((_e1175.z * _e1130.z) + ((_e1175.y * _e1130.y) + ((_e1175.x * _e1130.x) + _e1116.member)))), ((_e1175.w * _e1139.w) + ((_e1175.z * _e1139.z) + ((_e1175.y * _e1139.y) + ((_e1175.x * _e1139.x) + _e1116.member_1)))), ((_e1175.w * _e1149.w) + ((_e1175.z * _e1149.z) + ((_e1175.y * _e1149.y) + ((_e1175.x * _e1149.x) + _e1116.member_2)))), ((_e1175.w * _e1159.w) + ((_e1175.z * _e1159.z) + ((_e1175.y * _e1159.y) + ((_e1175.x * _e1159.x) + _e1116.member_3)))));
                                            local_50 = type_18(((_e1167.w * _e1130.w) + ((_e1167.z * _e1130.z) + ((_e1167.y * _e1130.y) + ((_e1167.x * _e1130.x) + _e1118.member)))), ((_e1167.w * _e1139.w) + ((_e1167.z * _e1139.z) + ((_e1167.y * _e1139.y) + ((_e1167.x * _e1139.x) + _e1118.member_1)))), ((_e1167.w * _e1149.w) + ((_e1167.z * _e1149.z) + ((_e1167.y * _e1149.y) + ((_e1167.x * _e1149.x) + _e1118.member_2)))), ((_e1167.w * _e1159.w) + ((_e1167.z * _e1159.z) + ((_e1167.y * _e1159.y) + ((_e1167.x * _e1159.x) + _e1118.member_3)))));
                                            local_52 = type_19((_e1120.member + 1u), _e1120.member_1, _e1120.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2687 = local_44;
                                            phi_1141_ = _e2687;
                                            let _e2692 = local_46;
                                            phi_1144_ = _e2692;
                                            let _e2697 = local_48;
                                            phi_1146_ = _e2697;
                                            let _e2702 = local_50;
                                            phi_1148_ = _e2702;
                                            let _e2707 = local_52;
                                            phi_1150_ = _e2707;
                                        }
                                    }
                                    let _e2710 = local_53;
                                    phi_1367_ = _e2710;
                                    let _e2715 = local_55;
                                    phi_1370_ = _e2715;
                                    let _e2720 = local_57;
                                    phi_1372_ = _e2720;
                                    let _e2725 = local_59;
                                    phi_1374_ = _e2725;
                                    let _e2730 = local_61;
                                    phi_1376_ = _e2730;
                                    loop {
                                        let _e1350 = phi_1367_;
                                        let _e1352 = phi_1370_;
                                        let _e1354 = phi_1372_;
                                        let _e1356 = phi_1374_;
                                        let _e1358 = phi_1376_;
                                        local_6 = _e1356;
                                        local_7 = _e1356;
                                        local_8 = _e1356;
                                        local_9 = _e1356;
                                        local_10 = _e1354;
                                        local_11 = _e1354;
                                        local_12 = _e1354;
                                        local_13 = _e1354;
                                        local_14 = _e1352;
                                        local_15 = _e1352;
                                        local_16 = _e1352;
                                        local_17 = _e1352;
                                        local_18 = _e1350;
                                        local_19 = _e1350;
                                        local_20 = _e1350;
                                        local_21 = _e1350;
                                        let _e1360 = (4u * _e1358.member);
                                        if (_e1360 < _e1358.member_2) {
                                            phi_1392_ = select(((_e1360 + 4u) > _e1358.member_2), true, (_e1360 < _e1358.member_1));
                                        } else {
                                            phi_1392_ = false;
                                        }
                                        let _e1369 = phi_1392_;
                                        if _e1369 {
                                            let _e1373 = global_7.member[(_e821 + _e1358.member)];
                                            let _e1380 = (_e1358.member_2 - _e1358.member_1);
                                            let _e1381 = ((_e1360 - _e1358.member_1) < _e1380);
                                            let _e1382 = select(0f, _e1373.x, _e1381);
                                            let _e1385 = (((_e1360 + 1u) - _e1358.member_1) < _e1380);
                                            let _e1386 = select(0f, _e1373.y, _e1385);
                                            let _e1389 = (((_e1360 + 2u) - _e1358.member_1) < _e1380);
                                            let _e1390 = select(0f, _e1373.z, _e1389);
                                            let _e1393 = (((_e1360 + 3u) - _e1358.member_1) < _e1380);
                                            let _e1394 = select(0f, _e1373.w, _e1393);
                                            let _e1399 = global_7.member[((_e821 + _e822) + _e1358.member)];
                                            let _e1404 = select(0f, _e1399.x, _e1381);
                                            let _e1405 = select(0f, _e1399.y, _e1385);
                                            let _e1406 = select(0f, _e1399.z, _e1389);
                                            let _e1407 = select(0f, _e1399.w, _e1393);
                                            let _e1413 = global_7.member[((_e821 + (2u * _e822)) + _e1358.member)];
                                            let _e1418 = select(0f, _e1413.x, _e1381);
                                            let _e1419 = select(0f, _e1413.y, _e1385);
                                            let _e1420 = select(0f, _e1413.z, _e1389);
                                            let _e1421 = select(0f, _e1413.w, _e1393);
                                            let _e1427 = global_7.member[((_e821 + (3u * _e822)) + _e1358.member)];
                                            let _e1432 = select(0f, _e1427.x, _e1381);
                                            let _e1433 = select(0f, _e1427.y, _e1385);
                                            let _e1434 = select(0f, _e1427.z, _e1389);
                                            let _e1435 = select(0f, _e1427.w, _e1393);
                                            let _e1439 = global_9.member[(_e817 + _e1358.member)];
                                            let _e1444 = select(0f, _e1439.x, _e1381);
                                            let _e1445 = select(0f, _e1439.y, _e1385);
                                            let _e1446 = select(0f, _e1439.z, _e1389);
                                            let _e1447 = select(0f, _e1439.w, _e1393);
                                            let _e1451 = global_9.member[(_e818 + _e1358.member)];
                                            let _e1456 = select(0f, _e1451.x, _e1381);
                                            let _e1457 = select(0f, _e1451.y, _e1385);
                                            let _e1458 = select(0f, _e1451.z, _e1389);
                                            let _e1459 = select(0f, _e1451.w, _e1393);
                                            let _e1463 = global_9.member[(_e819 + _e1358.member)];
                                            let _e1468 = select(0f, _e1463.x, _e1381);
                                            let _e1469 = select(0f, _e1463.y, _e1385);
                                            let _e1470 = select(0f, _e1463.z, _e1389);
                                            let _e1471 = select(0f, _e1463.w, _e1393);
                                            let _e1475 = global_9.member[(_e820 + _e1358.member)];
                                            let _e1480 = select(0f, _e1475.x, _e1381);
                                            let _e1481 = select(0f, _e1475.y, _e1385);
                                            let _e1482 = select(0f, _e1475.z, _e1389);
                                            let _e1483 = select(0f, _e1475.w, _e1393);
                                            local_54 = type_18(((_e1483 * _e1394) + ((_e1482 * _e1390) + ((_e1481 * _e1386) + ((_e1480 * _e1382) + _e1350.member)))), ((_e1483 * _e1407) + ((_e1482 * _e1406) + ((_e1481 * _e1405) + ((_e1480 * _e1404) + _e1350.member_1)))), ((_e1483 * _e1421) + ((_e1482 * _e1420) + ((_e1481 * _e1419) + ((_e1480 * _e1418) + _e1350.member_2)))), ((_e1483 * _e1435) + ((_e1482 * _e1434) + ((_e1481 * _e1433) + ((_e1480 * _e1432) + _e1350.member_3)))));
                                            local_56 = type_18(((_e1471 * _e1394) + ((_e1470 * _e1390) + ((_e1469 * _e1386) + ((_e1468 * _e1382) + _e1352.member)))), ((_e1471 * _e1407) + ((_e1470 * _e1406) + ((_e1469 * _e1405) + ((_e1468 * _e1404) + _e1352.member_1)))), ((_e1471 * _e1421) + ((_e1470 * _e1420) + ((_e1469 * _e1419) + ((_e1468 * _e1418) + _e1352.member_2)))), ((_e1471 * _e1435) + ((_e1470 * _e1434) + ((_e1469 * _e1433) + ((_e1468 * _e1432) + _e1352.member_3)))));
                                            local_58 = type_18(((_e1459 * _e1394) + ((_e1458 * _e1390) + ((_e1457 * _e1386) + ((_e1456 * _e1382) + _e1354.member)))), ((_e1459 * _e1407) + ((_e1458 * _e1406) + ((_e1457 * _e1405) + ((_e1456 * _e1404) + _e1354.member_1)))), ((_e1459 * _e1421) + ((_e1458 * _e1420) + ((_e1457 * _e1419) + ((_e1456 * _e1418) + _e1354.member_2)))), ((_e1459 * _e1435) + ((_e1458 * _e1434) + ((_e1457 * _e1433) + ((_e1456 * _e1432) + _e1354.member_3)))));
                                            local_60 = type_18(((_e1447 * _e1394) + ((_e1446 * _e1390) + ((_e1445 * _e1386) + ((_e1444 * _e1382) + _e1356.member)))), ((_e1447 * _e1407) + ((_e1446 * _e1406) + ((_e1445 * _e1405) + ((_e1444 * _e1404) + _e1356.member_1)))), ((_e1447 * _e1421) + ((_e1446 * _e1420) + ((_e1445 * _e1419) + ((_e1444 * _e1418) + _e1356.member_2)))), ((_e1447 * _e1435) + ((_e1446 * _e1434) + ((_e1445 * _e1433) + ((_e1444 * _e1432) + _e1356.member_3)))));
                                            local_62 = type_19((_e1358.member + 1u), _e1358.member_1, _e1358.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2712 = local_54;
                                            phi_1367_ = _e2712;
                                            let _e2717 = local_56;
                                            phi_1370_ = _e2717;
                                            let _e2722 = local_58;
                                            phi_1372_ = _e2722;
                                            let _e2727 = local_60;
                                            phi_1374_ = _e2727;
                                            let _e2732 = local_62;
                                            phi_1376_ = _e2732;
                                        }
                                    }
                                    let _e1638 = local_6;
                                    let _e1641 = local_7;
                                    let _e1644 = local_8;
                                    let _e1647 = local_9;
                                    let _e1650 = local_10;
                                    let _e1653 = local_11;
                                    let _e1656 = local_12;
                                    let _e1659 = local_13;
                                    let _e1662 = local_14;
                                    let _e1665 = local_15;
                                    let _e1668 = local_16;
                                    let _e1671 = local_17;
                                    let _e1674 = local_18;
                                    let _e1677 = local_19;
                                    let _e1680 = local_20;
                                    let _e1683 = local_21;
                                    if _e186 {
                                        let _e1689 = (4u * _e182);
                                        let _e1690 = (4u * _e744);
                                        let _e1691 = bitcast<u32>(_e1638.member);
                                        let _e1694 = ((_e1691 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1694 == 0u) {
                                        } else {
                                            let _e1697 = (_e1694 % 16u);
                                            let _e1699 = ((_e1691 & 8388607u) | 8388608u);
                                            let _e1702 = (_e1699 << bitcast<u32>((_e1697 & 31u)));
                                            let _e1708 = ((_e1699 >> bitcast<u32>(((31u - _e1697) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1691 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1703_ = array<u32, 2>(_e1702, _e1708);
                                            } else {
                                                let _e1714 = (~(_e1702) + 1u);
                                                if (_e1714 == 0u) {
                                                    phi_1701_ = (~(_e1708) + 1u);
                                                } else {
                                                    phi_1701_ = ~(_e1708);
                                                }
                                                let _e1720 = phi_1701_;
                                                phi_1703_ = array<u32, 2>(_e1714, _e1720);
                                            }
                                            let _e1723 = phi_1703_;
                                            let _e1724 = (_e1694 < 255u);
                                            if _e1724 {
                                                phi_1709_ = _e1723;
                                            } else {
                                                phi_1709_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1727 = phi_1709_;
                                            let _e1732 = (2u * ((select(16u, (_e1694 / 16u), _e1724) * _e1689) + _e1690));
                                            let _e1735 = atomicAdd((&global_8.member[_e1732]), _e1727[0]);
                                            let _e1743 = atomicAdd((&global_8.member[(_e1732 + 1u)]), (_e1727[1] + select(0u, 1u, ((_e1735 + _e1727[0]) < _e1727[0]))));
                                        }
                                        let _e1745 = bitcast<u32>(_e1641.member_1);
                                        let _e1748 = ((_e1745 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1748 == 0u) {
                                        } else {
                                            let _e1751 = (_e1748 % 16u);
                                            let _e1753 = ((_e1745 & 8388607u) | 8388608u);
                                            let _e1756 = (_e1753 << bitcast<u32>((_e1751 & 31u)));
                                            let _e1762 = ((_e1753 >> bitcast<u32>(((31u - _e1751) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1745 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1759_ = array<u32, 2>(_e1756, _e1762);
                                            } else {
                                                let _e1768 = (~(_e1756) + 1u);
                                                if (_e1768 == 0u) {
                                                    phi_1757_ = (~(_e1762) + 1u);
                                                } else {
                                                    phi_1757_ = ~(_e1762);
                                                }
                                                let _e1774 = phi_1757_;
                                                phi_1759_ = array<u32, 2>(_e1768, _e1774);
                                            }
                                            let _e1777 = phi_1759_;
                                            let _e1778 = (_e1748 < 255u);
                                            if _e1778 {
                                                phi_1765_ = _e1777;
                                            } else {
                                                phi_1765_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1781 = phi_1765_;
                                            let _e1786 = (2u * ((select(16u, (_e1748 / 16u), _e1778) * _e1689) + (_e1690 + 1u)));
                                            let _e1789 = atomicAdd((&global_8.member[_e1786]), _e1781[0]);
                                            let _e1797 = atomicAdd((&global_8.member[(_e1786 + 1u)]), (_e1781[1] + select(0u, 1u, ((_e1789 + _e1781[0]) < _e1781[0]))));
                                        }
                                        let _e1799 = bitcast<u32>(_e1644.member_2);
                                        let _e1802 = ((_e1799 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1802 == 0u) {
                                        } else {
                                            let _e1805 = (_e1802 % 16u);
                                            let _e1807 = ((_e1799 & 8388607u) | 8388608u);
                                            let _e1810 = (_e1807 << bitcast<u32>((_e1805 & 31u)));
                                            let _e1816 = ((_e1807 >> bitcast<u32>(((31u - _e1805) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1799 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1815_ = array<u32, 2>(_e1810, _e1816);
                                            } else {
                                                let _e1822 = (~(_e1810) + 1u);
                                                if (_e1822 == 0u) {
                                                    phi_1813_ = (~(_e1816) + 1u);
                                                } else {
                                                    phi_1813_ = ~(_e1816);
                                                }
                                                let _e1828 = phi_1813_;
                                                phi_1815_ = array<u32, 2>(_e1822, _e1828);
                                            }
                                            let _e1831 = phi_1815_;
                                            let _e1832 = (_e1802 < 255u);
                                            if _e1832 {
                                                phi_1821_ = _e1831;
                                            } else {
                                                phi_1821_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1835 = phi_1821_;
                                            let _e1840 = (2u * ((select(16u, (_e1802 / 16u), _e1832) * _e1689) + (_e1690 + 2u)));
                                            let _e1843 = atomicAdd((&global_8.member[_e1840]), _e1835[0]);
                                            let _e1851 = atomicAdd((&global_8.member[(_e1840 + 1u)]), (_e1835[1] + select(0u, 1u, ((_e1843 + _e1835[0]) < _e1835[0]))));
                                        }
                                        let _e1853 = bitcast<u32>(_e1647.member_3);
                                        let _e1856 = ((_e1853 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1856 == 0u) {
                                        } else {
                                            let _e1859 = (_e1856 % 16u);
                                            let _e1861 = ((_e1853 & 8388607u) | 8388608u);
                                            let _e1864 = (_e1861 << bitcast<u32>((_e1859 & 31u)));
                                            let _e1870 = ((_e1861 >> bitcast<u32>(((31u - _e1859) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1853 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1871_ = array<u32, 2>(_e1864, _e1870);
                                            } else {
                                                let _e1876 = (~(_e1864) + 1u);
                                                if (_e1876 == 0u) {
                                                    phi_1869_ = (~(_e1870) + 1u);
                                                } else {
                                                    phi_1869_ = ~(_e1870);
                                                }
                                                let _e1882 = phi_1869_;
                                                phi_1871_ = array<u32, 2>(_e1876, _e1882);
                                            }
                                            let _e1885 = phi_1871_;
                                            let _e1886 = (_e1856 < 255u);
                                            if _e1886 {
                                                phi_1877_ = _e1885;
                                            } else {
                                                phi_1877_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1889 = phi_1877_;
                                            let _e1894 = (2u * ((select(16u, (_e1856 / 16u), _e1886) * _e1689) + (_e1690 + 3u)));
                                            let _e1897 = atomicAdd((&global_8.member[_e1894]), _e1889[0]);
                                            let _e1905 = atomicAdd((&global_8.member[(_e1894 + 1u)]), (_e1889[1] + select(0u, 1u, ((_e1897 + _e1889[0]) < _e1889[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e744)] = vec4<f32>(_e1638.member, _e1641.member_1, _e1644.member_2, _e1647.member_3);
                                    }
                                    if (_e763 < _e58) {
                                        if _e186 {
                                            let _e1911 = (4u * _e182);
                                            let _e1912 = (4u * _e749);
                                            let _e1913 = bitcast<u32>(_e1650.member);
                                            let _e1916 = ((_e1913 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1916 == 0u) {
                                            } else {
                                                let _e1919 = (_e1916 % 16u);
                                                let _e1921 = ((_e1913 & 8388607u) | 8388608u);
                                                let _e1924 = (_e1921 << bitcast<u32>((_e1919 & 31u)));
                                                let _e1930 = ((_e1921 >> bitcast<u32>(((31u - _e1919) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1913 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1938_ = array<u32, 2>(_e1924, _e1930);
                                                } else {
                                                    let _e1936 = (~(_e1924) + 1u);
                                                    if (_e1936 == 0u) {
                                                        phi_1936_ = (~(_e1930) + 1u);
                                                    } else {
                                                        phi_1936_ = ~(_e1930);
                                                    }
                                                    let _e1942 = phi_1936_;
                                                    phi_1938_ = array<u32, 2>(_e1936, _e1942);
                                                }
                                                let _e1945 = phi_1938_;
                                                let _e1946 = (_e1916 < 255u);
                                                if _e1946 {
                                                    phi_1944_ = _e1945;
                                                } else {
                                                    phi_1944_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1949 = phi_1944_;
                                                let _e1954 = (2u * ((select(16u, (_e1916 / 16u), _e1946) * _e1911) + _e1912));
                                                let _e1957 = atomicAdd((&global_8.member[_e1954]), _e1949[0]);
                                                let _e1965 = atomicAdd((&global_8.member[(_e1954 + 1u)]), (_e1949[1] + select(0u, 1u, ((_e1957 + _e1949[0]) < _e1949[0]))));
                                            }
                                            let _e1967 = bitcast<u32>(_e1653.member_1);
                                            let _e1970 = ((_e1967 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1970 == 0u) {
                                            } else {
                                                let _e1973 = (_e1970 % 16u);
                                                let _e1975 = ((_e1967 & 8388607u) | 8388608u);
                                                let _e1978 = (_e1975 << bitcast<u32>((_e1973 & 31u)));
                                                let _e1984 = ((_e1975 >> bitcast<u32>(((31u - _e1973) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1967 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1994_ = array<u32, 2>(_e1978, _e1984);
                                                } else {
                                                    let _e1990 = (~(_e1978) + 1u);
                                                    if (_e1990 == 0u) {
                                                        phi_1992_ = (~(_e1984) + 1u);
                                                    } else {
                                                        phi_1992_ = ~(_e1984);
                                                    }
                                                    let _e1996 = phi_1992_;
                                                    phi_1994_ = array<u32, 2>(_e1990, _e1996);
                                                }
                                                let _e1999 = phi_1994_;
                                                let _e2000 = (_e1970 < 255u);
                                                if _e2000 {
                                                    phi_2000_ = _e1999;
                                                } else {
                                                    phi_2000_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2003 = phi_2000_;
                                                let _e2008 = (2u * ((select(16u, (_e1970 / 16u), _e2000) * _e1911) + (_e1912 + 1u)));
                                                let _e2011 = atomicAdd((&global_8.member[_e2008]), _e2003[0]);
                                                let _e2019 = atomicAdd((&global_8.member[(_e2008 + 1u)]), (_e2003[1] + select(0u, 1u, ((_e2011 + _e2003[0]) < _e2003[0]))));
                                            }
                                            let _e2021 = bitcast<u32>(_e1656.member_2);
                                            let _e2024 = ((_e2021 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2024 == 0u) {
                                            } else {
                                                let _e2027 = (_e2024 % 16u);
                                                let _e2029 = ((_e2021 & 8388607u) | 8388608u);
                                                let _e2032 = (_e2029 << bitcast<u32>((_e2027 & 31u)));
                                                let _e2038 = ((_e2029 >> bitcast<u32>(((31u - _e2027) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2021 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2050_ = array<u32, 2>(_e2032, _e2038);
                                                } else {
                                                    let _e2044 = (~(_e2032) + 1u);
                                                    if (_e2044 == 0u) {
                                                        phi_2048_ = (~(_e2038) + 1u);
                                                    } else {
                                                        phi_2048_ = ~(_e2038);
                                                    }
                                                    let _e2050 = phi_2048_;
                                                    phi_2050_ = array<u32, 2>(_e2044, _e2050);
                                                }
                                                let _e2053 = phi_2050_;
                                                let _e2054 = (_e2024 < 255u);
                                                if _e2054 {
                                                    phi_2056_ = _e2053;
                                                } else {
                                                    phi_2056_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2057 = phi_2056_;
                                                let _e2062 = (2u * ((select(16u, (_e2024 / 16u), _e2054) * _e1911) + (_e1912 + 2u)));
                                                let _e2065 = atomicAdd((&global_8.member[_e2062]), _e2057[0]);
                                                let _e2073 = atomicAdd((&global_8.member[(_e2062 + 1u)]), (_e2057[1] + select(0u, 1u, ((_e2065 + _e2057[0]) < _e2057[0]))));
                                            }
                                            let _e2075 = bitcast<u32>(_e1659.member_3);
                                            let _e2078 = ((_e2075 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2078 == 0u) {
                                            } else {
                                                let _e2081 = (_e2078 % 16u);
                                                let _e2083 = ((_e2075 & 8388607u) | 8388608u);
                                                let _e2086 = (_e2083 << bitcast<u32>((_e2081 & 31u)));
                                                let _e2092 = ((_e2083 >> bitcast<u32>(((31u - _e2081) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2075 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2106_ = array<u32, 2>(_e2086, _e2092);
                                                } else {
                                                    let _e2098 = (~(_e2086) + 1u);
                                                    if (_e2098 == 0u) {
                                                        phi_2104_ = (~(_e2092) + 1u);
                                                    } else {
                                                        phi_2104_ = ~(_e2092);
                                                    }
                                                    let _e2104 = phi_2104_;
                                                    phi_2106_ = array<u32, 2>(_e2098, _e2104);
                                                }
                                                let _e2107 = phi_2106_;
                                                let _e2108 = (_e2078 < 255u);
                                                if _e2108 {
                                                    phi_2112_ = _e2107;
                                                } else {
                                                    phi_2112_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2111 = phi_2112_;
                                                let _e2116 = (2u * ((select(16u, (_e2078 / 16u), _e2108) * _e1911) + (_e1912 + 3u)));
                                                let _e2119 = atomicAdd((&global_8.member[_e2116]), _e2111[0]);
                                                let _e2127 = atomicAdd((&global_8.member[(_e2116 + 1u)]), (_e2111[1] + select(0u, 1u, ((_e2119 + _e2111[0]) < _e2111[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e749)] = vec4<f32>(_e1650.member, _e1653.member_1, _e1656.member_2, _e1659.member_3);
                                        }
                                    }
                                    if (_e767 < _e58) {
                                        if _e186 {
                                            let _e2133 = (4u * _e182);
                                            let _e2134 = (4u * _e753);
                                            let _e2135 = bitcast<u32>(_e1662.member);
                                            let _e2138 = ((_e2135 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2138 == 0u) {
                                            } else {
                                                let _e2141 = (_e2138 % 16u);
                                                let _e2143 = ((_e2135 & 8388607u) | 8388608u);
                                                let _e2146 = (_e2143 << bitcast<u32>((_e2141 & 31u)));
                                                let _e2152 = ((_e2143 >> bitcast<u32>(((31u - _e2141) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2135 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2173_ = array<u32, 2>(_e2146, _e2152);
                                                } else {
                                                    let _e2158 = (~(_e2146) + 1u);
                                                    if (_e2158 == 0u) {
                                                        phi_2171_ = (~(_e2152) + 1u);
                                                    } else {
                                                        phi_2171_ = ~(_e2152);
                                                    }
                                                    let _e2164 = phi_2171_;
                                                    phi_2173_ = array<u32, 2>(_e2158, _e2164);
                                                }
                                                let _e2167 = phi_2173_;
                                                let _e2168 = (_e2138 < 255u);
                                                if _e2168 {
                                                    phi_2179_ = _e2167;
                                                } else {
                                                    phi_2179_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2171 = phi_2179_;
                                                let _e2176 = (2u * ((select(16u, (_e2138 / 16u), _e2168) * _e2133) + _e2134));
                                                let _e2179 = atomicAdd((&global_8.member[_e2176]), _e2171[0]);
                                                let _e2187 = atomicAdd((&global_8.member[(_e2176 + 1u)]), (_e2171[1] + select(0u, 1u, ((_e2179 + _e2171[0]) < _e2171[0]))));
                                            }
                                            let _e2189 = bitcast<u32>(_e1665.member_1);
                                            let _e2192 = ((_e2189 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2192 == 0u) {
                                            } else {
                                                let _e2195 = (_e2192 % 16u);
                                                let _e2197 = ((_e2189 & 8388607u) | 8388608u);
                                                let _e2200 = (_e2197 << bitcast<u32>((_e2195 & 31u)));
                                                let _e2206 = ((_e2197 >> bitcast<u32>(((31u - _e2195) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2189 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2229_ = array<u32, 2>(_e2200, _e2206);
                                                } else {
                                                    let _e2212 = (~(_e2200) + 1u);
                                                    if (_e2212 == 0u) {
                                                        phi_2227_ = (~(_e2206) + 1u);
                                                    } else {
                                                        phi_2227_ = ~(_e2206);
                                                    }
                                                    let _e2218 = phi_2227_;
                                                    phi_2229_ = array<u32, 2>(_e2212, _e2218);
                                                }
                                                let _e2221 = phi_2229_;
                                                let _e2222 = (_e2192 < 255u);
                                                if _e2222 {
                                                    phi_2235_ = _e2221;
                                                } else {
                                                    phi_2235_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2225 = phi_2235_;
                                                let _e2230 = (2u * ((select(16u, (_e2192 / 16u), _e2222) * _e2133) + (_e2134 + 1u)));
                                                let _e2233 = atomicAdd((&global_8.member[_e2230]), _e2225[0]);
                                                let _e2241 = atomicAdd((&global_8.member[(_e2230 + 1u)]), (_e2225[1] + select(0u, 1u, ((_e2233 + _e2225[0]) < _e2225[0]))));
                                            }
                                            let _e2243 = bitcast<u32>(_e1668.member_2);
                                            let _e2246 = ((_e2243 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2246 == 0u) {
                                            } else {
                                                let _e2249 = (_e2246 % 16u);
                                                let _e2251 = ((_e2243 & 8388607u) | 8388608u);
                                                let _e2254 = (_e2251 << bitcast<u32>((_e2249 & 31u)));
                                                let _e2260 = ((_e2251 >> bitcast<u32>(((31u - _e2249) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2243 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2285_ = array<u32, 2>(_e2254, _e2260);
                                                } else {
                                                    let _e2266 = (~(_e2254) + 1u);
                                                    if (_e2266 == 0u) {
                                                        phi_2283_ = (~(_e2260) + 1u);
                                                    } else {
                                                        phi_2283_ = ~(_e2260);
                                                    }
                                                    let _e2272 = phi_2283_;
                                                    phi_2285_ = array<u32, 2>(_e2266, _e2272);
                                                }
                                                let _e2275 = phi_2285_;
                                                let _e2276 = (_e2246 < 255u);
                                                if _e2276 {
                                                    phi_2291_ = _e2275;
                                                } else {
                                                    phi_2291_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2279 = phi_2291_;
                                                let _e2284 = (2u * ((select(16u, (_e2246 / 16u), _e2276) * _e2133) + (_e2134 + 2u)));
                                                let _e2287 = atomicAdd((&global_8.member[_e2284]), _e2279[0]);
                                                let _e2295 = atomicAdd((&global_8.member[(_e2284 + 1u)]), (_e2279[1] + select(0u, 1u, ((_e2287 + _e2279[0]) < _e2279[0]))));
                                            }
                                            let _e2297 = bitcast<u32>(_e1671.member_3);
                                            let _e2300 = ((_e2297 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2300 == 0u) {
                                            } else {
                                                let _e2303 = (_e2300 % 16u);
                                                let _e2305 = ((_e2297 & 8388607u) | 8388608u);
                                                let _e2308 = (_e2305 << bitcast<u32>((_e2303 & 31u)));
                                                let _e2314 = ((_e2305 >> bitcast<u32>(((31u - _e2303) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2297 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2341_ = array<u32, 2>(_e2308, _e2314);
                                                } else {
                                                    let _e2320 = (~(_e2308) + 1u);
                                                    if (_e2320 == 0u) {
                                                        phi_2339_ = (~(_e2314) + 1u);
                                                    } else {
                                                        phi_2339_ = ~(_e2314);
                                                    }
                                                    let _e2326 = phi_2339_;
                                                    phi_2341_ = array<u32, 2>(_e2320, _e2326);
                                                }
                                                let _e2329 = phi_2341_;
                                                let _e2330 = (_e2300 < 255u);
                                                if _e2330 {
                                                    phi_2347_ = _e2329;
                                                } else {
                                                    phi_2347_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2333 = phi_2347_;
                                                let _e2338 = (2u * ((select(16u, (_e2300 / 16u), _e2330) * _e2133) + (_e2134 + 3u)));
                                                let _e2341 = atomicAdd((&global_8.member[_e2338]), _e2333[0]);
                                                let _e2349 = atomicAdd((&global_8.member[(_e2338 + 1u)]), (_e2333[1] + select(0u, 1u, ((_e2341 + _e2333[0]) < _e2333[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e753)] = vec4<f32>(_e1662.member, _e1665.member_1, _e1668.member_2, _e1671.member_3);
                                        }
                                    }
                                    if (_e771 < _e58) {
                                        if _e186 {
                                            let _e2355 = (4u * _e182);
                                            let _e2356 = (4u * _e757);
                                            let _e2357 = bitcast<u32>(_e1674.member);
                                            let _e2360 = ((_e2357 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2360 == 0u) {
                                            } else {
                                                let _e2363 = (_e2360 % 16u);
                                                let _e2365 = ((_e2357 & 8388607u) | 8388608u);
                                                let _e2368 = (_e2365 << bitcast<u32>((_e2363 & 31u)));
                                                let _e2374 = ((_e2365 >> bitcast<u32>(((31u - _e2363) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2357 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2408_ = array<u32, 2>(_e2368, _e2374);
                                                } else {
                                                    let _e2380 = (~(_e2368) + 1u);
                                                    if (_e2380 == 0u) {
                                                        phi_2406_ = (~(_e2374) + 1u);
                                                    } else {
                                                        phi_2406_ = ~(_e2374);
                                                    }
                                                    let _e2386 = phi_2406_;
                                                    phi_2408_ = array<u32, 2>(_e2380, _e2386);
                                                }
                                                let _e2389 = phi_2408_;
                                                let _e2390 = (_e2360 < 255u);
                                                if _e2390 {
                                                    phi_2414_ = _e2389;
                                                } else {
                                                    phi_2414_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2393 = phi_2414_;
                                                let _e2398 = (2u * ((select(16u, (_e2360 / 16u), _e2390) * _e2355) + _e2356));
                                                let _e2401 = atomicAdd((&global_8.member[_e2398]), _e2393[0]);
                                                let _e2409 = atomicAdd((&global_8.member[(_e2398 + 1u)]), (_e2393[1] + select(0u, 1u, ((_e2401 + _e2393[0]) < _e2393[0]))));
                                            }
                                            let _e2411 = bitcast<u32>(_e1677.member_1);
                                            let _e2414 = ((_e2411 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2414 == 0u) {
                                            } else {
                                                let _e2417 = (_e2414 % 16u);
                                                let _e2419 = ((_e2411 & 8388607u) | 8388608u);
                                                let _e2422 = (_e2419 << bitcast<u32>((_e2417 & 31u)));
                                                let _e2428 = ((_e2419 >> bitcast<u32>(((31u - _e2417) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2411 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2464_ = array<u32, 2>(_e2422, _e2428);
                                                } else {
                                                    let _e2434 = (~(_e2422) + 1u);
                                                    if (_e2434 == 0u) {
                                                        phi_2462_ = (~(_e2428) + 1u);
                                                    } else {
                                                        phi_2462_ = ~(_e2428);
                                                    }
                                                    let _e2440 = phi_2462_;
                                                    phi_2464_ = array<u32, 2>(_e2434, _e2440);
                                                }
                                                let _e2443 = phi_2464_;
                                                let _e2444 = (_e2414 < 255u);
                                                if _e2444 {
                                                    phi_2470_ = _e2443;
                                                } else {
                                                    phi_2470_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2447 = phi_2470_;
                                                let _e2452 = (2u * ((select(16u, (_e2414 / 16u), _e2444) * _e2355) + (_e2356 + 1u)));
                                                let _e2455 = atomicAdd((&global_8.member[_e2452]), _e2447[0]);
                                                let _e2463 = atomicAdd((&global_8.member[(_e2452 + 1u)]), (_e2447[1] + select(0u, 1u, ((_e2455 + _e2447[0]) < _e2447[0]))));
                                            }
                                            let _e2465 = bitcast<u32>(_e1680.member_2);
                                            let _e2468 = ((_e2465 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2468 == 0u) {
                                            } else {
                                                let _e2471 = (_e2468 % 16u);
                                                let _e2473 = ((_e2465 & 8388607u) | 8388608u);
                                                let _e2476 = (_e2473 << bitcast<u32>((_e2471 & 31u)));
                                                let _e2482 = ((_e2473 >> bitcast<u32>(((31u - _e2471) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2465 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2520_ = array<u32, 2>(_e2476, _e2482);
                                                } else {
                                                    let _e2488 = (~(_e2476) + 1u);
                                                    if (_e2488 == 0u) {
                                                        phi_2518_ = (~(_e2482) + 1u);
                                                    } else {
                                                        phi_2518_ = ~(_e2482);
                                                    }
                                                    let _e2494 = phi_2518_;
                                                    phi_2520_ = array<u32, 2>(_e2488, _e2494);
                                                }
                                                let _e2497 = phi_2520_;
                                                let _e2498 = (_e2468 < 255u);
                                                if _e2498 {
                                                    phi_2526_ = _e2497;
                                                } else {
                                                    phi_2526_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2501 = phi_2526_;
                                                let _e2506 = (2u * ((select(16u, (_e2468 / 16u), _e2498) * _e2355) + (_e2356 + 2u)));
                                                let _e2509 = atomicAdd((&global_8.member[_e2506]), _e2501[0]);
                                                let _e2517 = atomicAdd((&global_8.member[(_e2506 + 1u)]), (_e2501[1] + select(0u, 1u, ((_e2509 + _e2501[0]) < _e2501[0]))));
                                            }
                                            let _e2519 = bitcast<u32>(_e1683.member_3);
                                            let _e2522 = ((_e2519 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2522 == 0u) {
                                            } else {
                                                let _e2525 = (_e2522 % 16u);
                                                let _e2527 = ((_e2519 & 8388607u) | 8388608u);
                                                let _e2530 = (_e2527 << bitcast<u32>((_e2525 & 31u)));
                                                let _e2536 = ((_e2527 >> bitcast<u32>(((31u - _e2525) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2519 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2576_ = array<u32, 2>(_e2530, _e2536);
                                                } else {
                                                    let _e2542 = (~(_e2530) + 1u);
                                                    if (_e2542 == 0u) {
                                                        phi_2574_ = (~(_e2536) + 1u);
                                                    } else {
                                                        phi_2574_ = ~(_e2536);
                                                    }
                                                    let _e2548 = phi_2574_;
                                                    phi_2576_ = array<u32, 2>(_e2542, _e2548);
                                                }
                                                let _e2551 = phi_2576_;
                                                let _e2552 = (_e2522 < 255u);
                                                if _e2552 {
                                                    phi_2582_ = _e2551;
                                                } else {
                                                    phi_2582_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2555 = phi_2582_;
                                                let _e2560 = (2u * ((select(16u, (_e2522 / 16u), _e2552) * _e2355) + (_e2356 + 3u)));
                                                let _e2563 = atomicAdd((&global_8.member[_e2560]), _e2555[0]);
                                                let _e2571 = atomicAdd((&global_8.member[(_e2560 + 1u)]), (_e2555[1] + select(0u, 1u, ((_e2563 + _e2555[0]) < _e2555[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e757)] = vec4<f32>(_e1674.member, _e1677.member_1, _e1680.member_2, _e1683.member_3);
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
                                            let _e2621 = local_28;
                                            phi_255_ = _e2621;
                                            let _e2624 = local_29;
                                            phi_258_ = _e2624;
                                        }
                                    }
                                    let _e2628 = local_30;
                                    phi_362_ = _e2628;
                                    let _e2633 = local_32;
                                    phi_365_ = _e2633;
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
                                            let _e2630 = local_31;
                                            phi_362_ = _e2630;
                                            let _e2635 = local_33;
                                            phi_365_ = _e2635;
                                        }
                                    }
                                    let _e2638 = local_34;
                                    phi_432_ = _e2638;
                                    let _e2643 = local_36;
                                    phi_435_ = _e2643;
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
                                            let _e2640 = local_35;
                                            phi_432_ = _e2640;
                                            let _e2645 = local_37;
                                            phi_435_ = _e2645;
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
                                            let _e575 = atomicAdd((&global_8.member[(_e564 + 1u)]), (_e559[1] + select(0u, 1u, ((_e567 + _e559[0]) < _e559[0]))));
                                        }
                                        let _e577 = bitcast<u32>(_e509.member_1);
                                        let _e580 = ((_e577 >> bitcast<u32>(23i)) & 255u);
                                        if (_e580 == 0u) {
                                        } else {
                                            let _e583 = (_e580 % 16u);
                                            let _e585 = ((_e577 & 8388607u) | 8388608u);
                                            let _e588 = (_e585 << bitcast<u32>((_e583 & 31u)));
                                            let _e594 = ((_e585 >> bitcast<u32>(((31u - _e583) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e577 >> bitcast<u32>(31i)) == 0u) {
                                                phi_640_ = array<u32, 2>(_e588, _e594);
                                            } else {
                                                let _e600 = (~(_e588) + 1u);
                                                if (_e600 == 0u) {
                                                    phi_638_ = (~(_e594) + 1u);
                                                } else {
                                                    phi_638_ = ~(_e594);
                                                }
                                                let _e606 = phi_638_;
                                                phi_640_ = array<u32, 2>(_e600, _e606);
                                            }
                                            let _e609 = phi_640_;
                                            let _e610 = (_e580 < 255u);
                                            if _e610 {
                                                phi_646_ = _e609;
                                            } else {
                                                phi_646_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e613 = phi_646_;
                                            let _e618 = (2u * ((select(16u, (_e580 / 16u), _e610) * _e521) + (_e522 + 1u)));
                                            let _e621 = atomicAdd((&global_8.member[_e618]), _e613[0]);
                                            let _e629 = atomicAdd((&global_8.member[(_e618 + 1u)]), (_e613[1] + select(0u, 1u, ((_e621 + _e613[0]) < _e613[0]))));
                                        }
                                        let _e631 = bitcast<u32>(_e512.member_2);
                                        let _e634 = ((_e631 >> bitcast<u32>(23i)) & 255u);
                                        if (_e634 == 0u) {
                                        } else {
                                            let _e637 = (_e634 % 16u);
                                            let _e639 = ((_e631 & 8388607u) | 8388608u);
                                            let _e642 = (_e639 << bitcast<u32>((_e637 & 31u)));
                                            let _e648 = ((_e639 >> bitcast<u32>(((31u - _e637) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e631 >> bitcast<u32>(31i)) == 0u) {
                                                phi_696_ = array<u32, 2>(_e642, _e648);
                                            } else {
                                                let _e654 = (~(_e642) + 1u);
                                                if (_e654 == 0u) {
                                                    phi_694_ = (~(_e648) + 1u);
                                                } else {
                                                    phi_694_ = ~(_e648);
                                                }
                                                let _e660 = phi_694_;
                                                phi_696_ = array<u32, 2>(_e654, _e660);
                                            }
                                            let _e663 = phi_696_;
                                            let _e664 = (_e634 < 255u);
                                            if _e664 {
                                                phi_702_ = _e663;
                                            } else {
                                                phi_702_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e667 = phi_702_;
                                            let _e672 = (2u * ((select(16u, (_e634 / 16u), _e664) * _e521) + (_e522 + 2u)));
                                            let _e675 = atomicAdd((&global_8.member[_e672]), _e667[0]);
                                            let _e683 = atomicAdd((&global_8.member[(_e672 + 1u)]), (_e667[1] + select(0u, 1u, ((_e675 + _e667[0]) < _e667[0]))));
                                        }
                                        let _e685 = bitcast<u32>(_e515.member_3);
                                        let _e688 = ((_e685 >> bitcast<u32>(23i)) & 255u);
                                        if (_e688 == 0u) {
                                        } else {
                                            let _e691 = (_e688 % 16u);
                                            let _e693 = ((_e685 & 8388607u) | 8388608u);
                                            let _e696 = (_e693 << bitcast<u32>((_e691 & 31u)));
                                            let _e702 = ((_e693 >> bitcast<u32>(((31u - _e691) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e685 >> bitcast<u32>(31i)) == 0u) {
                                                phi_752_ = array<u32, 2>(_e696, _e702);
                                            } else {
                                                let _e708 = (~(_e696) + 1u);
                                                if (_e708 == 0u) {
                                                    phi_750_ = (~(_e702) + 1u);
                                                } else {
                                                    phi_750_ = ~(_e702);
                                                }
                                                let _e714 = phi_750_;
                                                phi_752_ = array<u32, 2>(_e708, _e714);
                                            }
                                            let _e717 = phi_752_;
                                            let _e718 = (_e688 < 255u);
                                            if _e718 {
                                                phi_758_ = _e717;
                                            } else {
                                                phi_758_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e721 = phi_758_;
                                            let _e726 = (2u * ((select(16u, (_e688 / 16u), _e718) * _e521) + (_e522 + 3u)));
                                            let _e729 = atomicAdd((&global_8.member[_e726]), _e721[0]);
                                            let _e737 = atomicAdd((&global_8.member[(_e726 + 1u)]), (_e721[1] + select(0u, 1u, ((_e729 + _e721[0]) < _e721[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e198)] = vec4<f32>(_e506.member, _e509.member_1, _e512.member_2, _e515.member_3);
                                    }
                                }
                                phi_187_ = _e157;
                                phi_190_ = _e166;
                                phi_192_ = _e161;
                            }
                            let _e2584 = phi_187_;
                            let _e2586 = phi_190_;
                            let _e2588 = phi_192_;
                            local_24 = _e2584;
                            local_25 = _e2586;
                            local_27 = _e2588;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2608 = local_24;
                            phi_186_ = _e2608;
                            let _e2611 = local_25;
                            phi_189_ = _e2611;
                            let _e2616 = local_27;
                            phi_191_ = _e2616;
                        }
                    }
                    let _e2590 = phi_2608_;
                    if _e2590 {
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
