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
    var phi_587_: u32;
    var phi_589_: array<u32, 2>;
    var phi_595_: array<u32, 2>;
    var phi_648_: u32;
    var phi_650_: array<u32, 2>;
    var phi_656_: array<u32, 2>;
    var phi_709_: u32;
    var phi_711_: array<u32, 2>;
    var phi_717_: array<u32, 2>;
    var phi_770_: u32;
    var phi_772_: array<u32, 2>;
    var phi_778_: array<u32, 2>;
    var phi_839_: vec4<f32>;
    var phi_850_: vec4<f32>;
    var phi_861_: vec4<f32>;
    var phi_872_: vec4<f32>;
    var phi_887_: type_18;
    var phi_890_: type_18;
    var phi_892_: type_18;
    var phi_894_: type_18;
    var phi_896_: type_19;
    var phi_912_: bool;
    var phi_1166_: type_18;
    var phi_1169_: type_18;
    var phi_1171_: type_18;
    var phi_1173_: type_18;
    var phi_1175_: type_19;
    var phi_1392_: type_18;
    var phi_1395_: type_18;
    var phi_1397_: type_18;
    var phi_1399_: type_18;
    var phi_1401_: type_19;
    var phi_1417_: bool;
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
    var phi_1731_: u32;
    var phi_1733_: array<u32, 2>;
    var phi_1739_: array<u32, 2>;
    var phi_1792_: u32;
    var phi_1794_: array<u32, 2>;
    var phi_1800_: array<u32, 2>;
    var phi_1853_: u32;
    var phi_1855_: array<u32, 2>;
    var phi_1861_: array<u32, 2>;
    var phi_1914_: u32;
    var phi_1916_: array<u32, 2>;
    var phi_1922_: array<u32, 2>;
    var phi_1991_: u32;
    var phi_1993_: array<u32, 2>;
    var phi_1999_: array<u32, 2>;
    var phi_2052_: u32;
    var phi_2054_: array<u32, 2>;
    var phi_2060_: array<u32, 2>;
    var phi_2113_: u32;
    var phi_2115_: array<u32, 2>;
    var phi_2121_: array<u32, 2>;
    var phi_2174_: u32;
    var phi_2176_: array<u32, 2>;
    var phi_2182_: array<u32, 2>;
    var phi_2251_: u32;
    var phi_2253_: array<u32, 2>;
    var phi_2259_: array<u32, 2>;
    var phi_2312_: u32;
    var phi_2314_: array<u32, 2>;
    var phi_2320_: array<u32, 2>;
    var phi_2373_: u32;
    var phi_2375_: array<u32, 2>;
    var phi_2381_: array<u32, 2>;
    var phi_2434_: u32;
    var phi_2436_: array<u32, 2>;
    var phi_2442_: array<u32, 2>;
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
    var phi_187_: u32;
    var phi_190_: u32;
    var phi_192_: u32;
    var phi_2733_: bool;
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
                            let _e2638 = local_22;
                            phi_111_ = _e2638;
                            let _e2641 = local_23;
                            phi_114_ = _e2641;
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
                    let _e2659 = local_26;
                    phi_191_ = _e2659;
                    loop {
                        let _e157 = phi_186_;
                        let _e159 = phi_189_;
                        let _e161 = phi_191_;
                        phi_2733_ = false;
                        if (_e159 < select(_e68, _e76, (_e76 < _e68))) {
                            if (_e159 == _e157) {
                                let _e2622 = global_4.member[((_e161 + 2u) * _e111)];
                                if _e121 {
                                    phi_2732_ = _e2622;
                                } else {
                                    let _e2625 = global_5.member[_e2622];
                                    phi_2732_ = _e2625;
                                }
                                let _e2627 = phi_2732_;
                                phi_187_ = _e2627;
                                phi_190_ = _e159;
                                phi_192_ = (_e161 + 1u);
                            } else {
                                let _e164 = (_e159 + _e55);
                                let _e166 = select(_e157, _e164, (_e164 < _e157));
                                let _e167 = (_e52 == 0u);
                                if _e167 {
                                    phi_2733_ = true;
                                    break;
                                }
                                let _e168 = (_e49 / _e52);
                                if _e167 {
                                    phi_2733_ = true;
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
                                    let _e747 = (_e168 * 4u);
                                    let _e750 = global_3.member.member_5;
                                    let _e753 = ((_e750 + (_e747 * _e52)) + _e169);
                                    let _e754 = (_e59 - _e747);
                                    let _e758 = (_e753 + (select(_e754, 1u, (1u < _e754)) * _e52));
                                    let _e762 = (_e753 + (select(_e754, 2u, (2u < _e754)) * _e52));
                                    let _e766 = (_e753 + (select(_e754, 3u, (3u < _e754)) * _e52));
                                    let _e772 = (_e747 + 1u);
                                    let _e776 = (_e747 + 2u);
                                    let _e780 = (_e747 + 3u);
                                    if _e188 {
                                        let _e786 = global_6.member[(_e183 + _e753)];
                                        phi_839_ = _e786;
                                    } else {
                                        phi_839_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e788 = phi_839_;
                                    if _e188 {
                                        let _e796 = global_6.member[(_e183 + _e758)];
                                        phi_850_ = _e796;
                                    } else {
                                        phi_850_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e798 = phi_850_;
                                    if _e188 {
                                        let _e806 = global_6.member[(_e183 + _e762)];
                                        phi_861_ = _e806;
                                    } else {
                                        phi_861_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e808 = phi_861_;
                                    if _e188 {
                                        let _e816 = global_6.member[(_e183 + _e766)];
                                        phi_872_ = _e816;
                                    } else {
                                        phi_872_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e818 = phi_872_;
                                    let _e826 = ((_e747 * _e191) / 4u);
                                    let _e827 = ((select(_e59, _e772, (_e772 < _e59)) * _e191) / 4u);
                                    let _e828 = ((select(_e59, _e776, (_e776 < _e59)) * _e191) / 4u);
                                    let _e829 = ((select(_e59, _e780, (_e780 < _e59)) * _e191) / 4u);
                                    let _e830 = (_e193 / 4u);
                                    let _e831 = (_e191 / 4u);
                                    phi_887_ = type_18(_e818.x, _e818.y, _e818.z, _e818.w);
                                    phi_890_ = type_18(_e808.x, _e808.y, _e808.z, _e808.w);
                                    phi_892_ = type_18(_e798.x, _e798.y, _e798.z, _e798.w);
                                    phi_894_ = type_18(_e788.x, _e788.y, _e788.z, _e788.w);
                                    phi_896_ = type_19((_e173 / 4u), _e173, _e176);
                                    loop {
                                        let _e833 = phi_887_;
                                        let _e835 = phi_890_;
                                        let _e837 = phi_892_;
                                        let _e839 = phi_894_;
                                        let _e841 = phi_896_;
                                        local_43 = _e833;
                                        local_45 = _e835;
                                        local_47 = _e837;
                                        local_49 = _e839;
                                        local_51 = _e841;
                                        let _e843 = (4u * _e841.member);
                                        if (_e843 < _e841.member_2) {
                                            phi_912_ = select(((_e843 + 4u) > _e841.member_2), true, (_e843 < _e841.member_1));
                                        } else {
                                            phi_912_ = false;
                                        }
                                        let _e852 = phi_912_;
                                        if _e852 {
                                            let _e856 = global_7.member[(_e830 + _e841.member)];
                                            let _e863 = (_e841.member_2 - _e841.member_1);
                                            let _e864 = ((_e843 - _e841.member_1) < _e863);
                                            let _e865 = select(0f, _e856.x, _e864);
                                            let _e868 = (((_e843 + 1u) - _e841.member_1) < _e863);
                                            let _e869 = select(0f, _e856.y, _e868);
                                            let _e872 = (((_e843 + 2u) - _e841.member_1) < _e863);
                                            let _e873 = select(0f, _e856.z, _e872);
                                            let _e876 = (((_e843 + 3u) - _e841.member_1) < _e863);
                                            let _e877 = select(0f, _e856.w, _e876);
                                            let _e882 = global_7.member[((_e830 + _e831) + _e841.member)];
                                            let _e887 = select(0f, _e882.x, _e864);
                                            let _e888 = select(0f, _e882.y, _e868);
                                            let _e889 = select(0f, _e882.z, _e872);
                                            let _e890 = select(0f, _e882.w, _e876);
                                            let _e896 = global_7.member[((_e830 + (2u * _e831)) + _e841.member)];
                                            let _e901 = select(0f, _e896.x, _e864);
                                            let _e902 = select(0f, _e896.y, _e868);
                                            let _e903 = select(0f, _e896.z, _e872);
                                            let _e904 = select(0f, _e896.w, _e876);
                                            let _e910 = global_7.member[((_e830 + (3u * _e831)) + _e841.member)];
                                            let _e915 = select(0f, _e910.x, _e864);
                                            let _e916 = select(0f, _e910.y, _e868);
                                            let _e917 = select(0f, _e910.z, _e872);
                                            let _e918 = select(0f, _e910.w, _e876);
                                            let _e922 = global_9.member[(_e826 + _e841.member)];
                                            let _e927 = select(0f, _e922.x, _e864);
                                            let _e928 = select(0f, _e922.y, _e868);
                                            let _e929 = select(0f, _e922.z, _e872);
                                            let _e930 = select(0f, _e922.w, _e876);
                                            let _e934 = global_9.member[(_e827 + _e841.member)];
                                            let _e939 = select(0f, _e934.x, _e864);
                                            let _e940 = select(0f, _e934.y, _e868);
                                            let _e941 = select(0f, _e934.z, _e872);
                                            let _e942 = select(0f, _e934.w, _e876);
                                            let _e946 = global_9.member[(_e828 + _e841.member)];
                                            let _e951 = select(0f, _e946.x, _e864);
                                            let _e952 = select(0f, _e946.y, _e868);
                                            let _e953 = select(0f, _e946.z, _e872);
                                            let _e954 = select(0f, _e946.w, _e876);
                                            let _e958 = global_9.member[(_e829 + _e841.member)];
                                            let _e963 = select(0f, _e958.x, _e864);
                                            let _e964 = select(0f, _e958.y, _e868);
                                            let _e965 = select(0f, _e958.z, _e872);
                                            let _e966 = select(0f, _e958.w, _e876);
                                            local_38 = type_18(((_e966 * _e877) + ((_e965 * _e873) + ((_e964 * _e869) + ((_e963 * _e865) + _e833.member)))), ((_e966 * _e890) + ((_e965 * _e889) + ((_e964 * _e888) + ((_e963 * _e887) + _e833.member_1)))), ((_e966 * _e904) + ((_e965 * _e903) + ((_e964 * _e902) + ((_e963 * _e901) + _e833.member_2)))), ((_e966 * _e918) + ((_e965 * _e917) + ((_e964 * _e916) + ((_e963 * _e915) + _e833.member_3)))));
                                            local_39 = type_18(((_e954 * _e877) + ((_e953 * _e873) + ((_e952 * _e869) + ((_e951 * _e865) + _e835.member)))), ((_e954 * _e890) + ((_e953 * _e889) + ((_e952 * _e888) + ((_e951 * _e887) + _e835.member_1)))), ((_e954 * _e904) + ((_e953 * _e903) + ((_e952 * _e902) + ((_e951 * _e901) + _e835.member_2)))), ((_e954 * _e918) + ((_e953 * _e917) + ((_e952 * _e916) + ((_e951 * _e915) + _e835.member_3)))));
                                            local_40 = type_18(((_e942 * _e877) + ((_e941 * _e873) + ((_e940 * _e869) + ((_e939 * _e865) + _e837.member)))), ((_e942 * _e890) + ((_e941 * _e889) + ((_e940 * _e888) + ((_e939 * _e887) + _e837.member_1)))), ((_e942 * _e904) + ((_e941 * _e903) + ((_e940 * _e902) + ((_e939 * _e901) + _e837.member_2)))), ((_e942 * _e918) + ((_e941 * _e917) + ((_e940 * _e916) + ((_e939 * _e915) + _e837.member_3)))));
                                            local_41 = type_18(((_e930 * _e877) + ((_e929 * _e873) + ((_e928 * _e869) + ((_e927 * _e865) + _e839.member)))), ((_e930 * _e890) + ((_e929 * _e889) + ((_e928 * _e888) + ((_e927 * _e887) + _e839.member_1)))), ((_e930 * _e904) + ((_e929 * _e903) + ((_e928 * _e902) + ((_e927 * _e901) + _e839.member_2)))), ((_e930 * _e918) + ((_e929 * _e917) + ((_e928 * _e916) + ((_e927 * _e915) + _e839.member_3)))));
                                            local_42 = type_19((_e841.member + 1u), _e841.member_1, _e841.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2714 = local_38;
                                            phi_887_ = _e2714;
                                            let _e2717 = local_39;
                                            phi_890_ = _e2717;
                                            let _e2720 = local_40;
                                            phi_892_ = _e2720;
                                            let _e2723 = local_41;
                                            phi_894_ = _e2723;
                                            let _e2726 = local_42;
                                            phi_896_ = _e2726;
                                        }
                                    }
                                    let _e2730 = local_43;
                                    phi_1166_ = _e2730;
                                    let _e2735 = local_45;
                                    phi_1169_ = _e2735;
                                    let _e2740 = local_47;
                                    phi_1171_ = _e2740;
                                    let _e2745 = local_49;
                                    phi_1173_ = _e2745;
                                    let _e2750 = local_51;
                                    phi_1175_ = _e2750;
                                    loop {
                                        let _e1121 = phi_1166_;
                                        let _e1123 = phi_1169_;
                                        let _e1125 = phi_1171_;
                                        let _e1127 = phi_1173_;
                                        let _e1129 = phi_1175_;
                                        local_53 = _e1121;
                                        local_55 = _e1123;
                                        local_57 = _e1125;
                                        local_59 = _e1127;
                                        local_61 = _e1129;
                                        if !((((4u * _e1129.member) + 4u) > _e1129.member_2)) {
                                            let _e1139 = global_7.member[(_e830 + _e1129.member)];
                                            let _e1148 = global_7.member[((_e830 + _e831) + _e1129.member)];
                                            let _e1158 = global_7.member[((_e830 + (2u * _e831)) + _e1129.member)];
                                            let _e1168 = global_7.member[((_e830 + (3u * _e831)) + _e1129.member)];
                                            let _e1176 = global_9.member[(_e826 + _e1129.member)];
                                            let _e1184 = global_9.member[(_e827 + _e1129.member)];
                                            let _e1192 = global_9.member[(_e828 + _e1129.member)];
                                            let _e1200 = global_9.member[(_e829 + _e1129.member)];
                                            local_44 = type_18(((_e1200.w * _e1139.w) + ((_e1200.z * _e1139.z) + ((_e1200.y * _e1139.y) + ((_e1200.x * _e1139.x) + _e1121.member)))), ((_e1200.w * _e1148.w) + ((_e1200.z * _e1148.z) + ((_e1200.y * _e1148.y) + ((_e1200.x * _e1148.x) + _e1121.member_1)))), ((_e1200.w * _e1158.w) + ((_e1200.z * _e1158.z) + ((_e1200.y * _e1158.y) + ((_e1200.x * _e1158.x) + _e1121.member_2)))), ((_e1200.w * _e1168.w) + ((_e1200.z * _e1168.z) + ((_e1200.y * _e1168.y) + ((_e1200.x * _e1168.x) + _e1121.member_3)))));
                                            local_46 = type_18(((_e1192.w * _e1139.w) + ((_e1192.z * _e1139.z) + ((_e1192.y * _e1139.y) + ((_e1192.x * _e1139.x) + _e1123.member)))), ((_e1192.w * _e1148.w) + ((_e1192.z * _e1148.z) + ((_e1192.y * _e1148.y) + ((_e1192.x * _e1148.x) + _e1123.member_1)))), ((_e1192.w * _e1158.w) + ((_e1192.z * _e1158.z) + ((_e1192.y * _e1158.y) + ((_e1192.x * _e1158.x) + _e1123.member_2)))), ((_e1192.w * _e1168.w) + ((_e1192.z * _e1168.z) + ((_e1192.y * _e1168.y) + ((_e1192.x * _e1168.x) + _e1123.member_3)))));
                                            local_48 = type_18(((_e1184.w * _e1139.w) + ((_e1184.z * _e1139.z) + ((_e1184.y * _e1139.y) + ((_e1184.x * _e1139.x) + _e1125.member)))), ((_e1184.w * _e1148.w) + ((_e1184.z * _e1148.z) + ((_e1184.y * _e1148.y) + ((_e1184.x * _e1148.x) + _e1125.member_1)))), ((_e1184.w * _e1158.w) + ((_e1184.z * _e1158.z) + ((_e1184.y * _e1158.y) + ((_e1184.x * _e1158.x) + _e1125.member_2)))), ((_e1184.w * _e1168.w) + ((_e1184.z * _e1168.z) + ((_e1184.y * _e1168.y) + ((_e1184.x * _e1168.x) + _e1125.member_3)))));
                                            local_50 = type_18(((_e1176.w * _e1139.w) + ((_e1176.z * _e1139.z) + ((_e1176.y * _e1139.y) + ((_e1176.x * _e1139.x) + _e1127.member)))), ((_e1176.w * _e1148.w) + ((_e1176.z * _e1148.z) + ((_e1176.y * _e1148.y) + ((_e1176.x * _e1148.x) + _e1127.member_1)))), ((_e1176.w * _e1158.w) + ((_e1176.z * _e1158.z) + ((_e1176.y * _e1158.y) + ((_e1176.x * _e1158.x) + _e1127.member_2)))), ((_e1176.w * _e1168.w) + ((_e1176.z * _e1168.z) + ((_e1176.y * _e1168.y) + ((_e1176.x * _e1168.x) + _e1127.member_3)))));
                                            local_52 = type_19((_e1129.member + 1u), _e1129.member_1, _e1129.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2732 = local_44;
                                            phi_1166_ = _e2732;
                                            let _e2737 = local_46;
                                            phi_1169_ = _e2737;
                                            let _e2742 = local_48;
                                            phi_1171_ = _e2742;
                                            let _e2747 = local_50;
                                            phi_1173_ = _e2747;
                                            let _e2752 = local_52;
                                            phi_1175_ = _e2752;
                                        }
                                    }
                                    let _e2755 = local_53;
                                    phi_1392_ = _e2755;
                                    let _e2760 = local_55;
                                    phi_1395_ = _e2760;
                                    let _e2765 = local_57;
                                    phi_1397_ = _e2765;
                                    let _e2770 = local_59;
                                    phi_1399_ = _e2770;
                                    let _e2775 = local_61;
                                    phi_1401_ = _e2775;
                                    loop {
                                        let _e1359 = phi_1392_;
                                        let _e1361 = phi_1395_;
                                        let _e1363 = phi_1397_;
                                        let _e1365 = phi_1399_;
                                        let _e1367 = phi_1401_;
                                        local_6 = _e1365;
                                        local_7 = _e1365;
                                        local_8 = _e1365;
                                        local_9 = _e1365;
                                        local_10 = _e1363;
                                        local_11 = _e1363;
                                        local_12 = _e1363;
                                        local_13 = _e1363;
                                        local_14 = _e1361;
                                        local_15 = _e1361;
                                        local_16 = _e1361;
                                        local_17 = _e1361;
                                        local_18 = _e1359;
                                        local_19 = _e1359;
                                        local_20 = _e1359;
                                        local_21 = _e1359;
                                        let _e1369 = (4u * _e1367.member);
                                        if (_e1369 < _e1367.member_2) {
                                            phi_1417_ = select(((_e1369 + 4u) > _e1367.member_2), true, (_e1369 < _e1367.member_1));
                                        } else {
                                            phi_1417_ = false;
                                        }
                                        let _e1378 = phi_1417_;
                                        if _e1378 {
                                            let _e1382 = global_7.member[(_e830 + _e1367.member)];
                                            let _e1389 = (_e1367.member_2 - _e1367.member_1);
                                            let _e1390 = ((_e1369 - _e1367.member_1) < _e1389);
                                            let _e1391 = select(0f, _e1382.x, _e1390);
                                            let _e1394 = (((_e1369 + 1u) - _e1367.member_1) < _e1389);
                                            let _e1395 = select(0f, _e1382.y, _e1394);
                                            let _e1398 = (((_e1369 + 2u) - _e1367.member_1) < _e1389);
                                            let _e1399 = select(0f, _e1382.z, _e1398);
                                            let _e1402 = (((_e1369 + 3u) - _e1367.member_1) < _e1389);
                                            let _e1403 = select(0f, _e1382.w, _e1402);
                                            let _e1408 = global_7.member[((_e830 + _e831) + _e1367.member)];
                                            let _e1413 = select(0f, _e1408.x, _e1390);
                                            let _e1414 = select(0f, _e1408.y, _e1394);
                                            let _e1415 = select(0f, _e1408.z, _e1398);
                                            let _e1416 = select(0f, _e1408.w, _e1402);
                                            let _e1422 = global_7.member[((_e830 + (2u * _e831)) + _e1367.member)];
                                            let _e1427 = select(0f, _e1422.x, _e1390);
                                            let _e1428 = select(0f, _e1422.y, _e1394);
                                            let _e1429 = select(0f, _e1422.z, _e1398);
                                            let _e1430 = select(0f, _e1422.w, _e1402);
                                            let _e1436 = global_7.member[((_e830 + (3u * _e831)) + _e1367.member)];
                                            let _e1441 = select(0f, _e1436.x, _e1390);
                                            let _e1442 = select(0f, _e1436.y, _e1394);
                                            let _e1443 = select(0f, _e1436.z, _e1398);
                                            let _e1444 = select(0f, _e1436.w, _e1402);
                                            let _e1448 = global_9.member[(_e826 + _e1367.member)];
                                            let _e1453 = select(0f, _e1448.x, _e1390);
                                            let _e1454 = select(0f, _e1448.y, _e1394);
                                            let _e1455 = select(0f, _e1448.z, _e1398);
                                            let _e1456 = select(0f, _e1448.w, _e1402);
                                            let _e1460 = global_9.member[(_e827 + _e1367.member)];
                                            let _e1465 = select(0f, _e1460.x, _e1390);
                                            let _e1466 = select(0f, _e1460.y, _e1394);
                                            let _e1467 = select(0f, _e1460.z, _e1398);
                                            let _e1468 = select(0f, _e1460.w, _e1402);
                                            let _e1472 = global_9.member[(_e828 + _e1367.member)];
                                            let _e1477 = select(0f, _e1472.x, _e1390);
                                            let _e1478 = select(0f, _e1472.y, _e1394);
                                            let _e1479 = select(0f, _e1472.z, _e1398);
                                            let _e1480 = select(0f, _e1472.w, _e1402);
                                            let _e1484 = global_9.member[(_e829 + _e1367.member)];
                                            let _e1489 = select(0f, _e1484.x, _e1390);
                                            let _e1490 = select(0f, _e1484.y, _e1394);
                                            let _e1491 = select(0f, _e1484.z, _e1398);
                                            let _e1492 = select(0f, _e1484.w, _e1402);
                                            local_54 = type_18(((_e1492 * _e1403) + ((_e1491 * _e1399) + ((_e1490 * _e1395) + ((_e1489 * _e1391) + _e1359.member)))), ((_e1492 * _e1416) + ((_e1491 * _e1415) + ((_e1490 * _e1414) + ((_e1489 * _e1413) + _e1359.member_1)))), ((_e1492 * _e1430) + ((_e1491 * _e1429) + ((_e1490 * _e1428) + ((_e1489 * _e1427) + _e1359.member_2)))), ((_e1492 * _e1444) + ((_e1491 * _e1443) + ((_e1490 * _e1442) + ((_e1489 * _e1441) + _e1359.member_3)))));
                                            local_56 = type_18(((_e1480 * _e1403) + ((_e1479 * _e1399) + ((_e1478 * _e1395) + ((_e1477 * _e1391) + _e1361.member)))), ((_e1480 * _e1416) + ((_e1479 * _e1415) + ((_e1478 * _e1414) + ((_e1477 * _e1413) + _e1361.member_1)))), ((_e1480 * _e1430) + ((_e1479 * _e1429) + ((_e1478 * _e1428) + ((_e1477 * _e1427) + _e1361.member_2)))), ((_e1480 * _e1444) + ((_e1479 * _e1443) + ((_e1478 * _e1442) + ((_e1477 * _e1441) + _e1361.member_3)))));
                                            local_58 = type_18(((_e1468 * _e1403) + ((_e1467 * _e1399) + ((_e1466 * _e1395) + ((_e1465 * _e1391) + _e1363.member)))), ((_e1468 * _e1416) + ((_e1467 * _e1415) + ((_e1466 * _e1414) + ((_e1465 * _e1413) + _e1363.member_1)))), ((_e1468 * _e1430) + ((_e1467 * _e1429) + ((_e1466 * _e1428) + ((_e1465 * _e1427) + _e1363.member_2)))), ((_e1468 * _e1444) + ((_e1467 * _e1443) + ((_e1466 * _e1442) + ((_e1465 * _e1441) + _e1363.member_3)))));
                                            local_60 = type_18(((_e1456 * _e1403) + ((_e1455 * _e1399) + ((_e1454 * _e1395) + ((_e1453 * _e1391) + _e1365.member)))), ((_e1456 * _e1416) + ((_e1455 * _e1415) + ((_e1454 * _e1414) + ((_e1453 * _e1413) + _e1365.member_1)))), ((_e1456 * _e1430) + ((_e1455 * _e1429) + ((_e1454 * _e1428) + ((_e1453 * _e1427) + _e1365.member_2)))), ((_e1456 * _e1444) + ((_e1455 * _e1443) + ((_e1454 * _e1442) + ((_e1453 * _e1441) + _e1365.member_3)))));
                                            local_62 = type_19((_e1367.member + 1u), _e1367.member_1, _e1367.member_2);
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2757 = local_54;
                                            phi_1392_ = _e2757;
                                            let _e2762 = local_56;
                                            phi_1395_ = _e2762;
                                            let _e2767 = local_58;
                                            phi_1397_ = _e2767;
                                            let _e2772 = local_60;
                                            phi_1399_ = _e2772;
                                            let _e2777 = local_62;
                                            phi_1401_ = _e2777;
                                        }
                                    }
                                    let _e1647 = local_6;
                                    let _e1650 = local_7;
                                    let _e1653 = local_8;
                                    let _e1656 = local_9;
                                    let _e1659 = local_10;
                                    let _e1662 = local_11;
                                    let _e1665 = local_12;
                                    let _e1668 = local_13;
                                    let _e1671 = local_14;
                                    let _e1674 = local_15;
                                    let _e1677 = local_16;
                                    let _e1680 = local_17;
                                    let _e1683 = local_18;
                                    let _e1686 = local_19;
                                    let _e1689 = local_20;
                                    let _e1692 = local_21;
                                    if _e186 {
                                        let _e1703 = (4u * _e182);
                                        let _e1704 = (4u * _e753);
                                        let _e1705 = bitcast<u32>((_e1647.member + 0f));
                                        let _e1708 = ((_e1705 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1708 == 0u) {
                                        } else {
                                            let _e1711 = (_e1708 % 16u);
                                            let _e1713 = ((_e1705 & 8388607u) | 8388608u);
                                            let _e1716 = (_e1713 << bitcast<u32>((_e1711 & 31u)));
                                            let _e1722 = ((_e1713 >> bitcast<u32>(((31u - _e1711) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1705 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1733_ = array<u32, 2>(_e1716, _e1722);
                                            } else {
                                                let _e1728 = (~(_e1716) + 1u);
                                                if (_e1728 == 0u) {
                                                    phi_1731_ = (~(_e1722) + 1u);
                                                } else {
                                                    phi_1731_ = ~(_e1722);
                                                }
                                                let _e1734 = phi_1731_;
                                                phi_1733_ = array<u32, 2>(_e1728, _e1734);
                                            }
                                            let _e1737 = phi_1733_;
                                            let _e1738 = (_e1708 < 255u);
                                            if _e1738 {
                                                phi_1739_ = _e1737;
                                            } else {
                                                phi_1739_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1741 = phi_1739_;
                                            let _e1746 = (2u * ((select(16u, (_e1708 / 16u), _e1738) * _e1703) + _e1704));
                                            let _e1749 = atomicAdd((&global_8.member[_e1746]), _e1741[0]);
                                            let _e1753 = (_e1741[1] + select(0u, 1u, ((_e1749 + _e1741[0]) < _e1741[0])));
                                            if (_e1753 == 0u) {
                                            } else {
                                                let _e1758 = atomicAdd((&global_8.member[(_e1746 + 1u)]), _e1753);
                                            }
                                        }
                                        let _e1760 = bitcast<u32>((_e1650.member_1 + 0f));
                                        let _e1763 = ((_e1760 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1763 == 0u) {
                                        } else {
                                            let _e1766 = (_e1763 % 16u);
                                            let _e1768 = ((_e1760 & 8388607u) | 8388608u);
                                            let _e1771 = (_e1768 << bitcast<u32>((_e1766 & 31u)));
                                            let _e1777 = ((_e1768 >> bitcast<u32>(((31u - _e1766) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1760 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1794_ = array<u32, 2>(_e1771, _e1777);
                                            } else {
                                                let _e1783 = (~(_e1771) + 1u);
                                                if (_e1783 == 0u) {
                                                    phi_1792_ = (~(_e1777) + 1u);
                                                } else {
                                                    phi_1792_ = ~(_e1777);
                                                }
                                                let _e1789 = phi_1792_;
                                                phi_1794_ = array<u32, 2>(_e1783, _e1789);
                                            }
                                            let _e1792 = phi_1794_;
                                            let _e1793 = (_e1763 < 255u);
                                            if _e1793 {
                                                phi_1800_ = _e1792;
                                            } else {
                                                phi_1800_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1796 = phi_1800_;
                                            let _e1801 = (2u * ((select(16u, (_e1763 / 16u), _e1793) * _e1703) + (_e1704 + 1u)));
                                            let _e1804 = atomicAdd((&global_8.member[_e1801]), _e1796[0]);
                                            let _e1808 = (_e1796[1] + select(0u, 1u, ((_e1804 + _e1796[0]) < _e1796[0])));
                                            if (_e1808 == 0u) {
                                            } else {
                                                let _e1813 = atomicAdd((&global_8.member[(_e1801 + 1u)]), _e1808);
                                            }
                                        }
                                        let _e1815 = bitcast<u32>((_e1653.member_2 + 0f));
                                        let _e1818 = ((_e1815 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1818 == 0u) {
                                        } else {
                                            let _e1821 = (_e1818 % 16u);
                                            let _e1823 = ((_e1815 & 8388607u) | 8388608u);
                                            let _e1826 = (_e1823 << bitcast<u32>((_e1821 & 31u)));
                                            let _e1832 = ((_e1823 >> bitcast<u32>(((31u - _e1821) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1815 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1855_ = array<u32, 2>(_e1826, _e1832);
                                            } else {
                                                let _e1838 = (~(_e1826) + 1u);
                                                if (_e1838 == 0u) {
                                                    phi_1853_ = (~(_e1832) + 1u);
                                                } else {
                                                    phi_1853_ = ~(_e1832);
                                                }
                                                let _e1844 = phi_1853_;
                                                phi_1855_ = array<u32, 2>(_e1838, _e1844);
                                            }
                                            let _e1847 = phi_1855_;
                                            let _e1848 = (_e1818 < 255u);
                                            if _e1848 {
                                                phi_1861_ = _e1847;
                                            } else {
                                                phi_1861_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1851 = phi_1861_;
                                            let _e1856 = (2u * ((select(16u, (_e1818 / 16u), _e1848) * _e1703) + (_e1704 + 2u)));
                                            let _e1859 = atomicAdd((&global_8.member[_e1856]), _e1851[0]);
                                            let _e1863 = (_e1851[1] + select(0u, 1u, ((_e1859 + _e1851[0]) < _e1851[0])));
                                            if (_e1863 == 0u) {
                                            } else {
                                                let _e1868 = atomicAdd((&global_8.member[(_e1856 + 1u)]), _e1863);
                                            }
                                        }
                                        let _e1870 = bitcast<u32>((_e1656.member_3 + 0f));
                                        let _e1873 = ((_e1870 >> bitcast<u32>(23i)) & 255u);
                                        if (_e1873 == 0u) {
                                        } else {
                                            let _e1876 = (_e1873 % 16u);
                                            let _e1878 = ((_e1870 & 8388607u) | 8388608u);
                                            let _e1881 = (_e1878 << bitcast<u32>((_e1876 & 31u)));
                                            let _e1887 = ((_e1878 >> bitcast<u32>(((31u - _e1876) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e1870 >> bitcast<u32>(31i)) == 0u) {
                                                phi_1916_ = array<u32, 2>(_e1881, _e1887);
                                            } else {
                                                let _e1893 = (~(_e1881) + 1u);
                                                if (_e1893 == 0u) {
                                                    phi_1914_ = (~(_e1887) + 1u);
                                                } else {
                                                    phi_1914_ = ~(_e1887);
                                                }
                                                let _e1899 = phi_1914_;
                                                phi_1916_ = array<u32, 2>(_e1893, _e1899);
                                            }
                                            let _e1902 = phi_1916_;
                                            let _e1903 = (_e1873 < 255u);
                                            if _e1903 {
                                                phi_1922_ = _e1902;
                                            } else {
                                                phi_1922_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e1906 = phi_1922_;
                                            let _e1911 = (2u * ((select(16u, (_e1873 / 16u), _e1903) * _e1703) + (_e1704 + 3u)));
                                            let _e1914 = atomicAdd((&global_8.member[_e1911]), _e1906[0]);
                                            let _e1918 = (_e1906[1] + select(0u, 1u, ((_e1914 + _e1906[0]) < _e1906[0])));
                                            if (_e1918 == 0u) {
                                            } else {
                                                let _e1923 = atomicAdd((&global_8.member[(_e1911 + 1u)]), _e1918);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e753)] = (vec4<f32>(_e1647.member, _e1650.member_1, _e1653.member_2, _e1656.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                    }
                                    if (_e772 < _e58) {
                                        if _e186 {
                                            let _e1934 = (4u * _e182);
                                            let _e1935 = (4u * _e758);
                                            let _e1936 = bitcast<u32>((_e1659.member + 0f));
                                            let _e1939 = ((_e1936 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1939 == 0u) {
                                            } else {
                                                let _e1942 = (_e1939 % 16u);
                                                let _e1944 = ((_e1936 & 8388607u) | 8388608u);
                                                let _e1947 = (_e1944 << bitcast<u32>((_e1942 & 31u)));
                                                let _e1953 = ((_e1944 >> bitcast<u32>(((31u - _e1942) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1936 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_1993_ = array<u32, 2>(_e1947, _e1953);
                                                } else {
                                                    let _e1959 = (~(_e1947) + 1u);
                                                    if (_e1959 == 0u) {
                                                        phi_1991_ = (~(_e1953) + 1u);
                                                    } else {
                                                        phi_1991_ = ~(_e1953);
                                                    }
                                                    let _e1965 = phi_1991_;
                                                    phi_1993_ = array<u32, 2>(_e1959, _e1965);
                                                }
                                                let _e1968 = phi_1993_;
                                                let _e1969 = (_e1939 < 255u);
                                                if _e1969 {
                                                    phi_1999_ = _e1968;
                                                } else {
                                                    phi_1999_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e1972 = phi_1999_;
                                                let _e1977 = (2u * ((select(16u, (_e1939 / 16u), _e1969) * _e1934) + _e1935));
                                                let _e1980 = atomicAdd((&global_8.member[_e1977]), _e1972[0]);
                                                let _e1984 = (_e1972[1] + select(0u, 1u, ((_e1980 + _e1972[0]) < _e1972[0])));
                                                if (_e1984 == 0u) {
                                                } else {
                                                    let _e1989 = atomicAdd((&global_8.member[(_e1977 + 1u)]), _e1984);
                                                }
                                            }
                                            let _e1991 = bitcast<u32>((_e1662.member_1 + 0f));
                                            let _e1994 = ((_e1991 >> bitcast<u32>(23i)) & 255u);
                                            if (_e1994 == 0u) {
                                            } else {
                                                let _e1997 = (_e1994 % 16u);
                                                let _e1999 = ((_e1991 & 8388607u) | 8388608u);
                                                let _e2002 = (_e1999 << bitcast<u32>((_e1997 & 31u)));
                                                let _e2008 = ((_e1999 >> bitcast<u32>(((31u - _e1997) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e1991 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2054_ = array<u32, 2>(_e2002, _e2008);
                                                } else {
                                                    let _e2014 = (~(_e2002) + 1u);
                                                    if (_e2014 == 0u) {
                                                        phi_2052_ = (~(_e2008) + 1u);
                                                    } else {
                                                        phi_2052_ = ~(_e2008);
                                                    }
                                                    let _e2020 = phi_2052_;
                                                    phi_2054_ = array<u32, 2>(_e2014, _e2020);
                                                }
                                                let _e2023 = phi_2054_;
                                                let _e2024 = (_e1994 < 255u);
                                                if _e2024 {
                                                    phi_2060_ = _e2023;
                                                } else {
                                                    phi_2060_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2027 = phi_2060_;
                                                let _e2032 = (2u * ((select(16u, (_e1994 / 16u), _e2024) * _e1934) + (_e1935 + 1u)));
                                                let _e2035 = atomicAdd((&global_8.member[_e2032]), _e2027[0]);
                                                let _e2039 = (_e2027[1] + select(0u, 1u, ((_e2035 + _e2027[0]) < _e2027[0])));
                                                if (_e2039 == 0u) {
                                                } else {
                                                    let _e2044 = atomicAdd((&global_8.member[(_e2032 + 1u)]), _e2039);
                                                }
                                            }
                                            let _e2046 = bitcast<u32>((_e1665.member_2 + 0f));
                                            let _e2049 = ((_e2046 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2049 == 0u) {
                                            } else {
                                                let _e2052 = (_e2049 % 16u);
                                                let _e2054 = ((_e2046 & 8388607u) | 8388608u);
                                                let _e2057 = (_e2054 << bitcast<u32>((_e2052 & 31u)));
                                                let _e2063 = ((_e2054 >> bitcast<u32>(((31u - _e2052) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2046 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2115_ = array<u32, 2>(_e2057, _e2063);
                                                } else {
                                                    let _e2069 = (~(_e2057) + 1u);
                                                    if (_e2069 == 0u) {
                                                        phi_2113_ = (~(_e2063) + 1u);
                                                    } else {
                                                        phi_2113_ = ~(_e2063);
                                                    }
                                                    let _e2075 = phi_2113_;
                                                    phi_2115_ = array<u32, 2>(_e2069, _e2075);
                                                }
                                                let _e2078 = phi_2115_;
                                                let _e2079 = (_e2049 < 255u);
                                                if _e2079 {
                                                    phi_2121_ = _e2078;
                                                } else {
                                                    phi_2121_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2082 = phi_2121_;
                                                let _e2087 = (2u * ((select(16u, (_e2049 / 16u), _e2079) * _e1934) + (_e1935 + 2u)));
                                                let _e2090 = atomicAdd((&global_8.member[_e2087]), _e2082[0]);
                                                let _e2094 = (_e2082[1] + select(0u, 1u, ((_e2090 + _e2082[0]) < _e2082[0])));
                                                if (_e2094 == 0u) {
                                                } else {
                                                    let _e2099 = atomicAdd((&global_8.member[(_e2087 + 1u)]), _e2094);
                                                }
                                            }
                                            let _e2101 = bitcast<u32>((_e1668.member_3 + 0f));
                                            let _e2104 = ((_e2101 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2104 == 0u) {
                                            } else {
                                                let _e2107 = (_e2104 % 16u);
                                                let _e2109 = ((_e2101 & 8388607u) | 8388608u);
                                                let _e2112 = (_e2109 << bitcast<u32>((_e2107 & 31u)));
                                                let _e2118 = ((_e2109 >> bitcast<u32>(((31u - _e2107) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2101 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2176_ = array<u32, 2>(_e2112, _e2118);
                                                } else {
                                                    let _e2124 = (~(_e2112) + 1u);
                                                    if (_e2124 == 0u) {
                                                        phi_2174_ = (~(_e2118) + 1u);
                                                    } else {
                                                        phi_2174_ = ~(_e2118);
                                                    }
                                                    let _e2130 = phi_2174_;
                                                    phi_2176_ = array<u32, 2>(_e2124, _e2130);
                                                }
                                                let _e2133 = phi_2176_;
                                                let _e2134 = (_e2104 < 255u);
                                                if _e2134 {
                                                    phi_2182_ = _e2133;
                                                } else {
                                                    phi_2182_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2137 = phi_2182_;
                                                let _e2142 = (2u * ((select(16u, (_e2104 / 16u), _e2134) * _e1934) + (_e1935 + 3u)));
                                                let _e2145 = atomicAdd((&global_8.member[_e2142]), _e2137[0]);
                                                let _e2149 = (_e2137[1] + select(0u, 1u, ((_e2145 + _e2137[0]) < _e2137[0])));
                                                if (_e2149 == 0u) {
                                                } else {
                                                    let _e2154 = atomicAdd((&global_8.member[(_e2142 + 1u)]), _e2149);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e758)] = (vec4<f32>(_e1659.member, _e1662.member_1, _e1665.member_2, _e1668.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                        }
                                    }
                                    if (_e776 < _e58) {
                                        if _e186 {
                                            let _e2165 = (4u * _e182);
                                            let _e2166 = (4u * _e762);
                                            let _e2167 = bitcast<u32>((_e1671.member + 0f));
                                            let _e2170 = ((_e2167 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2170 == 0u) {
                                            } else {
                                                let _e2173 = (_e2170 % 16u);
                                                let _e2175 = ((_e2167 & 8388607u) | 8388608u);
                                                let _e2178 = (_e2175 << bitcast<u32>((_e2173 & 31u)));
                                                let _e2184 = ((_e2175 >> bitcast<u32>(((31u - _e2173) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2167 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2253_ = array<u32, 2>(_e2178, _e2184);
                                                } else {
                                                    let _e2190 = (~(_e2178) + 1u);
                                                    if (_e2190 == 0u) {
                                                        phi_2251_ = (~(_e2184) + 1u);
                                                    } else {
                                                        phi_2251_ = ~(_e2184);
                                                    }
                                                    let _e2196 = phi_2251_;
                                                    phi_2253_ = array<u32, 2>(_e2190, _e2196);
                                                }
                                                let _e2199 = phi_2253_;
                                                let _e2200 = (_e2170 < 255u);
                                                if _e2200 {
                                                    phi_2259_ = _e2199;
                                                } else {
                                                    phi_2259_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2203 = phi_2259_;
                                                let _e2208 = (2u * ((select(16u, (_e2170 / 16u), _e2200) * _e2165) + _e2166));
                                                let _e2211 = atomicAdd((&global_8.member[_e2208]), _e2203[0]);
                                                let _e2215 = (_e2203[1] + select(0u, 1u, ((_e2211 + _e2203[0]) < _e2203[0])));
                                                if (_e2215 == 0u) {
                                                } else {
                                                    let _e2220 = atomicAdd((&global_8.member[(_e2208 + 1u)]), _e2215);
                                                }
                                            }
                                            let _e2222 = bitcast<u32>((_e1674.member_1 + 0f));
                                            let _e2225 = ((_e2222 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2225 == 0u) {
                                            } else {
                                                let _e2228 = (_e2225 % 16u);
                                                let _e2230 = ((_e2222 & 8388607u) | 8388608u);
                                                let _e2233 = (_e2230 << bitcast<u32>((_e2228 & 31u)));
                                                let _e2239 = ((_e2230 >> bitcast<u32>(((31u - _e2228) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2222 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2314_ = array<u32, 2>(_e2233, _e2239);
                                                } else {
                                                    let _e2245 = (~(_e2233) + 1u);
                                                    if (_e2245 == 0u) {
                                                        phi_2312_ = (~(_e2239) + 1u);
                                                    } else {
                                                        phi_2312_ = ~(_e2239);
                                                    }
                                                    let _e2251 = phi_2312_;
                                                    phi_2314_ = array<u32, 2>(_e2245, _e2251);
                                                }
                                                let _e2254 = phi_2314_;
                                                let _e2255 = (_e2225 < 255u);
                                                if _e2255 {
                                                    phi_2320_ = _e2254;
                                                } else {
                                                    phi_2320_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2258 = phi_2320_;
                                                let _e2263 = (2u * ((select(16u, (_e2225 / 16u), _e2255) * _e2165) + (_e2166 + 1u)));
                                                let _e2266 = atomicAdd((&global_8.member[_e2263]), _e2258[0]);
                                                let _e2270 = (_e2258[1] + select(0u, 1u, ((_e2266 + _e2258[0]) < _e2258[0])));
                                                if (_e2270 == 0u) {
                                                } else {
                                                    let _e2275 = atomicAdd((&global_8.member[(_e2263 + 1u)]), _e2270);
                                                }
                                            }
                                            let _e2277 = bitcast<u32>((_e1677.member_2 + 0f));
                                            let _e2280 = ((_e2277 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2280 == 0u) {
                                            } else {
                                                let _e2283 = (_e2280 % 16u);
                                                let _e2285 = ((_e2277 & 8388607u) | 8388608u);
                                                let _e2288 = (_e2285 << bitcast<u32>((_e2283 & 31u)));
                                                let _e2294 = ((_e2285 >> bitcast<u32>(((31u - _e2283) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2277 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2375_ = array<u32, 2>(_e2288, _e2294);
                                                } else {
                                                    let _e2300 = (~(_e2288) + 1u);
                                                    if (_e2300 == 0u) {
                                                        phi_2373_ = (~(_e2294) + 1u);
                                                    } else {
                                                        phi_2373_ = ~(_e2294);
                                                    }
                                                    let _e2306 = phi_2373_;
                                                    phi_2375_ = array<u32, 2>(_e2300, _e2306);
                                                }
                                                let _e2309 = phi_2375_;
                                                let _e2310 = (_e2280 < 255u);
                                                if _e2310 {
                                                    phi_2381_ = _e2309;
                                                } else {
                                                    phi_2381_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2313 = phi_2381_;
                                                let _e2318 = (2u * ((select(16u, (_e2280 / 16u), _e2310) * _e2165) + (_e2166 + 2u)));
                                                let _e2321 = atomicAdd((&global_8.member[_e2318]), _e2313[0]);
                                                let _e2325 = (_e2313[1] + select(0u, 1u, ((_e2321 + _e2313[0]) < _e2313[0])));
                                                if (_e2325 == 0u) {
                                                } else {
                                                    let _e2330 = atomicAdd((&global_8.member[(_e2318 + 1u)]), _e2325);
                                                }
                                            }
                                            let _e2332 = bitcast<u32>((_e1680.member_3 + 0f));
                                            let _e2335 = ((_e2332 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2335 == 0u) {
                                            } else {
                                                let _e2338 = (_e2335 % 16u);
                                                let _e2340 = ((_e2332 & 8388607u) | 8388608u);
                                                let _e2343 = (_e2340 << bitcast<u32>((_e2338 & 31u)));
                                                let _e2349 = ((_e2340 >> bitcast<u32>(((31u - _e2338) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2332 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2436_ = array<u32, 2>(_e2343, _e2349);
                                                } else {
                                                    let _e2355 = (~(_e2343) + 1u);
                                                    if (_e2355 == 0u) {
                                                        phi_2434_ = (~(_e2349) + 1u);
                                                    } else {
                                                        phi_2434_ = ~(_e2349);
                                                    }
                                                    let _e2361 = phi_2434_;
                                                    phi_2436_ = array<u32, 2>(_e2355, _e2361);
                                                }
                                                let _e2364 = phi_2436_;
                                                let _e2365 = (_e2335 < 255u);
                                                if _e2365 {
                                                    phi_2442_ = _e2364;
                                                } else {
                                                    phi_2442_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2368 = phi_2442_;
                                                let _e2373 = (2u * ((select(16u, (_e2335 / 16u), _e2365) * _e2165) + (_e2166 + 3u)));
                                                let _e2376 = atomicAdd((&global_8.member[_e2373]), _e2368[0]);
                                                let _e2380 = (_e2368[1] + select(0u, 1u, ((_e2376 + _e2368[0]) < _e2368[0])));
                                                if (_e2380 == 0u) {
                                                } else {
                                                    let _e2385 = atomicAdd((&global_8.member[(_e2373 + 1u)]), _e2380);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e762)] = (vec4<f32>(_e1671.member, _e1674.member_1, _e1677.member_2, _e1680.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                        }
                                    }
                                    if (_e780 < _e58) {
                                        if _e186 {
                                            let _e2396 = (4u * _e182);
                                            let _e2397 = (4u * _e766);
                                            let _e2398 = bitcast<u32>((_e1683.member + 0f));
                                            let _e2401 = ((_e2398 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2401 == 0u) {
                                            } else {
                                                let _e2404 = (_e2401 % 16u);
                                                let _e2406 = ((_e2398 & 8388607u) | 8388608u);
                                                let _e2409 = (_e2406 << bitcast<u32>((_e2404 & 31u)));
                                                let _e2415 = ((_e2406 >> bitcast<u32>(((31u - _e2404) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2398 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2513_ = array<u32, 2>(_e2409, _e2415);
                                                } else {
                                                    let _e2421 = (~(_e2409) + 1u);
                                                    if (_e2421 == 0u) {
                                                        phi_2511_ = (~(_e2415) + 1u);
                                                    } else {
                                                        phi_2511_ = ~(_e2415);
                                                    }
                                                    let _e2427 = phi_2511_;
                                                    phi_2513_ = array<u32, 2>(_e2421, _e2427);
                                                }
                                                let _e2430 = phi_2513_;
                                                let _e2431 = (_e2401 < 255u);
                                                if _e2431 {
                                                    phi_2519_ = _e2430;
                                                } else {
                                                    phi_2519_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2434 = phi_2519_;
                                                let _e2439 = (2u * ((select(16u, (_e2401 / 16u), _e2431) * _e2396) + _e2397));
                                                let _e2442 = atomicAdd((&global_8.member[_e2439]), _e2434[0]);
                                                let _e2446 = (_e2434[1] + select(0u, 1u, ((_e2442 + _e2434[0]) < _e2434[0])));
                                                if (_e2446 == 0u) {
                                                } else {
                                                    let _e2451 = atomicAdd((&global_8.member[(_e2439 + 1u)]), _e2446);
                                                }
                                            }
                                            let _e2453 = bitcast<u32>((_e1686.member_1 + 0f));
                                            let _e2456 = ((_e2453 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2456 == 0u) {
                                            } else {
                                                let _e2459 = (_e2456 % 16u);
                                                let _e2461 = ((_e2453 & 8388607u) | 8388608u);
                                                let _e2464 = (_e2461 << bitcast<u32>((_e2459 & 31u)));
                                                let _e2470 = ((_e2461 >> bitcast<u32>(((31u - _e2459) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2453 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2574_ = array<u32, 2>(_e2464, _e2470);
                                                } else {
                                                    let _e2476 = (~(_e2464) + 1u);
                                                    if (_e2476 == 0u) {
                                                        phi_2572_ = (~(_e2470) + 1u);
                                                    } else {
                                                        phi_2572_ = ~(_e2470);
                                                    }
                                                    let _e2482 = phi_2572_;
                                                    phi_2574_ = array<u32, 2>(_e2476, _e2482);
                                                }
                                                let _e2485 = phi_2574_;
                                                let _e2486 = (_e2456 < 255u);
                                                if _e2486 {
                                                    phi_2580_ = _e2485;
                                                } else {
                                                    phi_2580_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2489 = phi_2580_;
                                                let _e2494 = (2u * ((select(16u, (_e2456 / 16u), _e2486) * _e2396) + (_e2397 + 1u)));
                                                let _e2497 = atomicAdd((&global_8.member[_e2494]), _e2489[0]);
                                                let _e2501 = (_e2489[1] + select(0u, 1u, ((_e2497 + _e2489[0]) < _e2489[0])));
                                                if (_e2501 == 0u) {
                                                } else {
                                                    let _e2506 = atomicAdd((&global_8.member[(_e2494 + 1u)]), _e2501);
                                                }
                                            }
                                            let _e2508 = bitcast<u32>((_e1689.member_2 + 0f));
                                            let _e2511 = ((_e2508 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2511 == 0u) {
                                            } else {
                                                let _e2514 = (_e2511 % 16u);
                                                let _e2516 = ((_e2508 & 8388607u) | 8388608u);
                                                let _e2519 = (_e2516 << bitcast<u32>((_e2514 & 31u)));
                                                let _e2525 = ((_e2516 >> bitcast<u32>(((31u - _e2514) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2508 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2635_ = array<u32, 2>(_e2519, _e2525);
                                                } else {
                                                    let _e2531 = (~(_e2519) + 1u);
                                                    if (_e2531 == 0u) {
                                                        phi_2633_ = (~(_e2525) + 1u);
                                                    } else {
                                                        phi_2633_ = ~(_e2525);
                                                    }
                                                    let _e2537 = phi_2633_;
                                                    phi_2635_ = array<u32, 2>(_e2531, _e2537);
                                                }
                                                let _e2540 = phi_2635_;
                                                let _e2541 = (_e2511 < 255u);
                                                if _e2541 {
                                                    phi_2641_ = _e2540;
                                                } else {
                                                    phi_2641_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2544 = phi_2641_;
                                                let _e2549 = (2u * ((select(16u, (_e2511 / 16u), _e2541) * _e2396) + (_e2397 + 2u)));
                                                let _e2552 = atomicAdd((&global_8.member[_e2549]), _e2544[0]);
                                                let _e2556 = (_e2544[1] + select(0u, 1u, ((_e2552 + _e2544[0]) < _e2544[0])));
                                                if (_e2556 == 0u) {
                                                } else {
                                                    let _e2561 = atomicAdd((&global_8.member[(_e2549 + 1u)]), _e2556);
                                                }
                                            }
                                            let _e2563 = bitcast<u32>((_e1692.member_3 + 0f));
                                            let _e2566 = ((_e2563 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2566 == 0u) {
                                            } else {
                                                let _e2569 = (_e2566 % 16u);
                                                let _e2571 = ((_e2563 & 8388607u) | 8388608u);
                                                let _e2574 = (_e2571 << bitcast<u32>((_e2569 & 31u)));
                                                let _e2580 = ((_e2571 >> bitcast<u32>(((31u - _e2569) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2563 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2696_ = array<u32, 2>(_e2574, _e2580);
                                                } else {
                                                    let _e2586 = (~(_e2574) + 1u);
                                                    if (_e2586 == 0u) {
                                                        phi_2694_ = (~(_e2580) + 1u);
                                                    } else {
                                                        phi_2694_ = ~(_e2580);
                                                    }
                                                    let _e2592 = phi_2694_;
                                                    phi_2696_ = array<u32, 2>(_e2586, _e2592);
                                                }
                                                let _e2595 = phi_2696_;
                                                let _e2596 = (_e2566 < 255u);
                                                if _e2596 {
                                                    phi_2702_ = _e2595;
                                                } else {
                                                    phi_2702_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2599 = phi_2702_;
                                                let _e2604 = (2u * ((select(16u, (_e2566 / 16u), _e2596) * _e2396) + (_e2397 + 3u)));
                                                let _e2607 = atomicAdd((&global_8.member[_e2604]), _e2599[0]);
                                                let _e2611 = (_e2599[1] + select(0u, 1u, ((_e2607 + _e2599[0]) < _e2599[0])));
                                                if (_e2611 == 0u) {
                                                } else {
                                                    let _e2616 = atomicAdd((&global_8.member[(_e2604 + 1u)]), _e2611);
                                                }
                                            }
                                        } else {
                                            global_6.member[(_e185 + _e766)] = (vec4<f32>(_e1683.member, _e1686.member_1, _e1689.member_2, _e1692.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
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
                                            let _e2666 = local_28;
                                            phi_255_ = _e2666;
                                            let _e2669 = local_29;
                                            phi_258_ = _e2669;
                                        }
                                    }
                                    let _e2673 = local_30;
                                    phi_362_ = _e2673;
                                    let _e2678 = local_32;
                                    phi_365_ = _e2678;
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
                                            let _e2675 = local_31;
                                            phi_362_ = _e2675;
                                            let _e2680 = local_33;
                                            phi_365_ = _e2680;
                                        }
                                    }
                                    let _e2683 = local_34;
                                    phi_432_ = _e2683;
                                    let _e2688 = local_36;
                                    phi_435_ = _e2688;
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
                                            let _e2685 = local_35;
                                            phi_432_ = _e2685;
                                            let _e2690 = local_37;
                                            phi_435_ = _e2690;
                                        }
                                    }
                                    let _e506 = local_2;
                                    let _e509 = local_3;
                                    let _e512 = local_4;
                                    let _e515 = local_5;
                                    if _e186 {
                                        let _e526 = (4u * _e182);
                                        let _e527 = (4u * _e198);
                                        let _e528 = bitcast<u32>((_e506.member + 0f));
                                        let _e531 = ((_e528 >> bitcast<u32>(23i)) & 255u);
                                        if (_e531 == 0u) {
                                        } else {
                                            let _e534 = (_e531 % 16u);
                                            let _e536 = ((_e528 & 8388607u) | 8388608u);
                                            let _e539 = (_e536 << bitcast<u32>((_e534 & 31u)));
                                            let _e545 = ((_e536 >> bitcast<u32>(((31u - _e534) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e528 >> bitcast<u32>(31i)) == 0u) {
                                                phi_589_ = array<u32, 2>(_e539, _e545);
                                            } else {
                                                let _e551 = (~(_e539) + 1u);
                                                if (_e551 == 0u) {
                                                    phi_587_ = (~(_e545) + 1u);
                                                } else {
                                                    phi_587_ = ~(_e545);
                                                }
                                                let _e557 = phi_587_;
                                                phi_589_ = array<u32, 2>(_e551, _e557);
                                            }
                                            let _e560 = phi_589_;
                                            let _e561 = (_e531 < 255u);
                                            if _e561 {
                                                phi_595_ = _e560;
                                            } else {
                                                phi_595_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e564 = phi_595_;
                                            let _e569 = (2u * ((select(16u, (_e531 / 16u), _e561) * _e526) + _e527));
                                            let _e572 = atomicAdd((&global_8.member[_e569]), _e564[0]);
                                            let _e576 = (_e564[1] + select(0u, 1u, ((_e572 + _e564[0]) < _e564[0])));
                                            if (_e576 == 0u) {
                                            } else {
                                                let _e581 = atomicAdd((&global_8.member[(_e569 + 1u)]), _e576);
                                            }
                                        }
                                        let _e583 = bitcast<u32>((_e509.member_1 + 0f));
                                        let _e586 = ((_e583 >> bitcast<u32>(23i)) & 255u);
                                        if (_e586 == 0u) {
                                        } else {
                                            let _e589 = (_e586 % 16u);
                                            let _e591 = ((_e583 & 8388607u) | 8388608u);
                                            let _e594 = (_e591 << bitcast<u32>((_e589 & 31u)));
                                            let _e600 = ((_e591 >> bitcast<u32>(((31u - _e589) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e583 >> bitcast<u32>(31i)) == 0u) {
                                                phi_650_ = array<u32, 2>(_e594, _e600);
                                            } else {
                                                let _e606 = (~(_e594) + 1u);
                                                if (_e606 == 0u) {
                                                    phi_648_ = (~(_e600) + 1u);
                                                } else {
                                                    phi_648_ = ~(_e600);
                                                }
                                                let _e612 = phi_648_;
                                                phi_650_ = array<u32, 2>(_e606, _e612);
                                            }
                                            let _e615 = phi_650_;
                                            let _e616 = (_e586 < 255u);
                                            if _e616 {
                                                phi_656_ = _e615;
                                            } else {
                                                phi_656_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e619 = phi_656_;
                                            let _e624 = (2u * ((select(16u, (_e586 / 16u), _e616) * _e526) + (_e527 + 1u)));
                                            let _e627 = atomicAdd((&global_8.member[_e624]), _e619[0]);
                                            let _e631 = (_e619[1] + select(0u, 1u, ((_e627 + _e619[0]) < _e619[0])));
                                            if (_e631 == 0u) {
                                            } else {
                                                let _e636 = atomicAdd((&global_8.member[(_e624 + 1u)]), _e631);
                                            }
                                        }
                                        let _e638 = bitcast<u32>((_e512.member_2 + 0f));
                                        let _e641 = ((_e638 >> bitcast<u32>(23i)) & 255u);
                                        if (_e641 == 0u) {
                                        } else {
                                            let _e644 = (_e641 % 16u);
                                            let _e646 = ((_e638 & 8388607u) | 8388608u);
                                            let _e649 = (_e646 << bitcast<u32>((_e644 & 31u)));
                                            let _e655 = ((_e646 >> bitcast<u32>(((31u - _e644) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e638 >> bitcast<u32>(31i)) == 0u) {
                                                phi_711_ = array<u32, 2>(_e649, _e655);
                                            } else {
                                                let _e661 = (~(_e649) + 1u);
                                                if (_e661 == 0u) {
                                                    phi_709_ = (~(_e655) + 1u);
                                                } else {
                                                    phi_709_ = ~(_e655);
                                                }
                                                let _e667 = phi_709_;
                                                phi_711_ = array<u32, 2>(_e661, _e667);
                                            }
                                            let _e670 = phi_711_;
                                            let _e671 = (_e641 < 255u);
                                            if _e671 {
                                                phi_717_ = _e670;
                                            } else {
                                                phi_717_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e674 = phi_717_;
                                            let _e679 = (2u * ((select(16u, (_e641 / 16u), _e671) * _e526) + (_e527 + 2u)));
                                            let _e682 = atomicAdd((&global_8.member[_e679]), _e674[0]);
                                            let _e686 = (_e674[1] + select(0u, 1u, ((_e682 + _e674[0]) < _e674[0])));
                                            if (_e686 == 0u) {
                                            } else {
                                                let _e691 = atomicAdd((&global_8.member[(_e679 + 1u)]), _e686);
                                            }
                                        }
                                        let _e693 = bitcast<u32>((_e515.member_3 + 0f));
                                        let _e696 = ((_e693 >> bitcast<u32>(23i)) & 255u);
                                        if (_e696 == 0u) {
                                        } else {
                                            let _e699 = (_e696 % 16u);
                                            let _e701 = ((_e693 & 8388607u) | 8388608u);
                                            let _e704 = (_e701 << bitcast<u32>((_e699 & 31u)));
                                            let _e710 = ((_e701 >> bitcast<u32>(((31u - _e699) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e693 >> bitcast<u32>(31i)) == 0u) {
                                                phi_772_ = array<u32, 2>(_e704, _e710);
                                            } else {
                                                let _e716 = (~(_e704) + 1u);
                                                if (_e716 == 0u) {
                                                    phi_770_ = (~(_e710) + 1u);
                                                } else {
                                                    phi_770_ = ~(_e710);
                                                }
                                                let _e722 = phi_770_;
                                                phi_772_ = array<u32, 2>(_e716, _e722);
                                            }
                                            let _e725 = phi_772_;
                                            let _e726 = (_e696 < 255u);
                                            if _e726 {
                                                phi_778_ = _e725;
                                            } else {
                                                phi_778_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e729 = phi_778_;
                                            let _e734 = (2u * ((select(16u, (_e696 / 16u), _e726) * _e526) + (_e527 + 3u)));
                                            let _e737 = atomicAdd((&global_8.member[_e734]), _e729[0]);
                                            let _e741 = (_e729[1] + select(0u, 1u, ((_e737 + _e729[0]) < _e729[0])));
                                            if (_e741 == 0u) {
                                            } else {
                                                let _e746 = atomicAdd((&global_8.member[(_e734 + 1u)]), _e741);
                                            }
                                        }
                                    } else {
                                        global_6.member[(_e185 + _e198)] = (vec4<f32>(_e506.member, _e509.member_1, _e512.member_2, _e515.member_3) + vec4<f32>(0f, 0f, 0f, 0f));
                                    }
                                }
                                phi_187_ = _e157;
                                phi_190_ = _e166;
                                phi_192_ = _e161;
                            }
                            let _e2629 = phi_187_;
                            let _e2631 = phi_190_;
                            let _e2633 = phi_192_;
                            local_24 = _e2629;
                            local_25 = _e2631;
                            local_27 = _e2633;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2653 = local_24;
                            phi_186_ = _e2653;
                            let _e2656 = local_25;
                            phi_189_ = _e2656;
                            let _e2661 = local_27;
                            phi_191_ = _e2661;
                        }
                    }
                    let _e2635 = phi_2733_;
                    if _e2635 {
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
