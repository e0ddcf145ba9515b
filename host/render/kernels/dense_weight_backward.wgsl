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
    var phi_112_: u32;
    var phi_115_: u32;
    var phi_136_: u32;
    var local: u32;
    var phi_151_: u32;
    var local_1: u32;
    var phi_160_: u32;
    var phi_178_: u32;
    var phi_179_: u32;
    var phi_180_: bool;
    var phi_185_: u32;
    var phi_187_: u32;
    var phi_190_: u32;
    var phi_192_: u32;
    var phi_216_: u32;
    var phi_247_: vec4<f32>;
    var phi_260_: u32;
    var phi_264_: u32;
    var phi_267_: type_18;
    var phi_289_: array<f32, 2>;
    var phi_297_: f32;
    var phi_315_: array<f32, 2>;
    var phi_323_: f32;
    var phi_342_: array<f32, 2>;
    var phi_350_: f32;
    var phi_369_: array<f32, 2>;
    var phi_377_: f32;
    var phi_388_: u32;
    var phi_391_: type_18;
    var phi_451_: u32;
    var phi_454_: type_18;
    var phi_476_: array<f32, 2>;
    var phi_484_: f32;
    var phi_502_: array<f32, 2>;
    var phi_510_: f32;
    var phi_529_: array<f32, 2>;
    var phi_537_: f32;
    var phi_556_: array<f32, 2>;
    var phi_564_: f32;
    var local_2: type_18;
    var local_3: type_18;
    var local_4: type_18;
    var local_5: type_18;
    var phi_578_: u32;
    var phi_581_: type_18;
    var phi_603_: array<f32, 2>;
    var phi_611_: f32;
    var phi_629_: array<f32, 2>;
    var phi_637_: f32;
    var phi_656_: array<f32, 2>;
    var phi_664_: f32;
    var phi_683_: array<f32, 2>;
    var phi_691_: f32;
    var local_6: type_18;
    var local_7: type_18;
    var local_8: type_18;
    var local_9: type_18;
    var phi_748_: u32;
    var phi_750_: array<u32, 2>;
    var phi_756_: array<u32, 2>;
    var phi_804_: u32;
    var phi_806_: array<u32, 2>;
    var phi_812_: array<u32, 2>;
    var phi_860_: u32;
    var phi_862_: array<u32, 2>;
    var phi_868_: array<u32, 2>;
    var phi_916_: u32;
    var phi_918_: array<u32, 2>;
    var phi_924_: array<u32, 2>;
    var phi_980_: vec4<f32>;
    var phi_991_: vec4<f32>;
    var phi_1002_: vec4<f32>;
    var phi_1013_: vec4<f32>;
    var phi_1026_: u32;
    var phi_1030_: type_18;
    var phi_1033_: type_18;
    var phi_1035_: type_18;
    var phi_1037_: type_18;
    var phi_1039_: u32;
    var phi_1061_: array<f32, 2>;
    var phi_1069_: f32;
    var phi_1087_: array<f32, 2>;
    var phi_1095_: f32;
    var phi_1114_: array<f32, 2>;
    var phi_1122_: f32;
    var phi_1141_: array<f32, 2>;
    var phi_1149_: f32;
    var phi_1167_: array<f32, 2>;
    var phi_1175_: f32;
    var phi_1205_: array<f32, 2>;
    var phi_1213_: f32;
    var phi_1243_: array<f32, 2>;
    var phi_1251_: f32;
    var phi_1281_: array<f32, 2>;
    var phi_1289_: f32;
    var phi_1310_: u32;
    var phi_1313_: type_18;
    var phi_1315_: type_18;
    var phi_1317_: type_18;
    var phi_1319_: type_18;
    var phi_1529_: type_18;
    var phi_1532_: type_18;
    var phi_1534_: type_18;
    var phi_1536_: type_18;
    var phi_1538_: u32;
    var phi_1560_: array<f32, 2>;
    var phi_1568_: f32;
    var phi_1586_: array<f32, 2>;
    var phi_1594_: f32;
    var phi_1613_: array<f32, 2>;
    var phi_1621_: f32;
    var phi_1640_: array<f32, 2>;
    var phi_1648_: f32;
    var phi_1666_: array<f32, 2>;
    var phi_1674_: f32;
    var phi_1704_: array<f32, 2>;
    var phi_1712_: f32;
    var phi_1742_: array<f32, 2>;
    var phi_1750_: f32;
    var phi_1780_: array<f32, 2>;
    var phi_1788_: f32;
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
    var phi_1818_: type_18;
    var phi_1821_: type_18;
    var phi_1823_: type_18;
    var phi_1825_: type_18;
    var phi_1827_: u32;
    var phi_1849_: array<f32, 2>;
    var phi_1857_: f32;
    var phi_1875_: array<f32, 2>;
    var phi_1883_: f32;
    var phi_1902_: array<f32, 2>;
    var phi_1910_: f32;
    var phi_1929_: array<f32, 2>;
    var phi_1937_: f32;
    var phi_1955_: array<f32, 2>;
    var phi_1963_: f32;
    var phi_1993_: array<f32, 2>;
    var phi_2001_: f32;
    var phi_2031_: array<f32, 2>;
    var phi_2039_: f32;
    var phi_2069_: array<f32, 2>;
    var phi_2077_: f32;
    var local_26: type_18;
    var local_27: type_18;
    var local_28: type_18;
    var local_29: type_18;
    var phi_2138_: u32;
    var phi_2140_: array<u32, 2>;
    var phi_2146_: array<u32, 2>;
    var phi_2194_: u32;
    var phi_2196_: array<u32, 2>;
    var phi_2202_: array<u32, 2>;
    var phi_2250_: u32;
    var phi_2252_: array<u32, 2>;
    var phi_2258_: array<u32, 2>;
    var phi_2306_: u32;
    var phi_2308_: array<u32, 2>;
    var phi_2314_: array<u32, 2>;
    var local_30: type_18;
    var local_31: type_18;
    var local_32: type_18;
    var local_33: type_18;
    var phi_2381_: u32;
    var phi_2383_: array<u32, 2>;
    var phi_2389_: array<u32, 2>;
    var phi_2437_: u32;
    var phi_2439_: array<u32, 2>;
    var phi_2445_: array<u32, 2>;
    var phi_2493_: u32;
    var phi_2495_: array<u32, 2>;
    var phi_2501_: array<u32, 2>;
    var phi_2549_: u32;
    var phi_2551_: array<u32, 2>;
    var phi_2557_: array<u32, 2>;
    var local_34: type_18;
    var local_35: type_18;
    var local_36: type_18;
    var local_37: type_18;
    var phi_2624_: u32;
    var phi_2626_: array<u32, 2>;
    var phi_2632_: array<u32, 2>;
    var phi_2680_: u32;
    var phi_2682_: array<u32, 2>;
    var phi_2688_: array<u32, 2>;
    var phi_2736_: u32;
    var phi_2738_: array<u32, 2>;
    var phi_2744_: array<u32, 2>;
    var phi_2792_: u32;
    var phi_2794_: array<u32, 2>;
    var phi_2800_: array<u32, 2>;
    var local_38: type_18;
    var local_39: type_18;
    var local_40: type_18;
    var local_41: type_18;
    var phi_2867_: u32;
    var phi_2869_: array<u32, 2>;
    var phi_2875_: array<u32, 2>;
    var phi_2923_: u32;
    var phi_2925_: array<u32, 2>;
    var phi_2931_: array<u32, 2>;
    var phi_2979_: u32;
    var phi_2981_: array<u32, 2>;
    var phi_2987_: array<u32, 2>;
    var phi_3035_: u32;
    var phi_3037_: array<u32, 2>;
    var phi_3043_: array<u32, 2>;
    var phi_3068_: u32;
    var phi_188_: u32;
    var phi_191_: u32;
    var phi_193_: u32;
    var phi_3069_: bool;
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
                    phi_112_ = _e82;
                    phi_115_ = 0u;
                    loop {
                        let _e84 = phi_112_;
                        let _e86 = phi_115_;
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
                                phi_136_ = _e97;
                            } else {
                                let _e104 = global_5.member[_e97];
                                phi_136_ = _e104;
                            }
                            let _e106 = phi_136_;
                            let _e107 = (_e106 <= _e72);
                            local_42 = select(_e90, _e84, _e107);
                            local_43 = select(_e86, _e90, _e107);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2951 = local_42;
                            phi_112_ = _e2951;
                            let _e2954 = local_43;
                            phi_115_ = _e2954;
                        }
                    }
                    let _e112 = global_3.member.member_8;
                    let _e114 = local;
                    let _e118 = global_4.member[(_e114 * _e112)];
                    let _e121 = global_3.member.member_9;
                    let _e122 = (_e121 == 0u);
                    if _e122 {
                        phi_151_ = _e118;
                    } else {
                        let _e125 = global_5.member[_e118];
                        phi_151_ = _e125;
                    }
                    let _e127 = phi_151_;
                    let _e129 = local_1;
                    let _e133 = global_4.member[(_e129 * _e112)];
                    if _e122 {
                        phi_160_ = _e133;
                    } else {
                        let _e136 = global_5.member[_e133];
                        phi_160_ = _e136;
                    }
                    let _e138 = phi_160_;
                    if (_e56 == 0u) {
                        break;
                    }
                    let _e141 = ((_e72 - _e127) % _e56);
                    if (_e41.z == 0u) {
                        phi_179_ = u32();
                        phi_180_ = true;
                    } else {
                        let _e143 = (_e141 == 0u);
                        if _e143 {
                            phi_178_ = u32();
                        } else {
                            let _e145 = ((_e72 - _e141) + _e56);
                            phi_178_ = select(_e138, _e145, (_e145 < _e138));
                        }
                        let _e149 = phi_178_;
                        phi_179_ = _e149;
                        phi_180_ = _e143;
                    }
                    let _e151 = phi_179_;
                    let _e153 = phi_180_;
                    if _e153 {
                        phi_185_ = (_e72 - _e141);
                    } else {
                        phi_185_ = _e151;
                    }
                    let _e156 = phi_185_;
                    phi_187_ = _e138;
                    phi_190_ = _e156;
                    let _e2972 = local_46;
                    phi_192_ = _e2972;
                    loop {
                        let _e158 = phi_187_;
                        let _e160 = phi_190_;
                        let _e162 = phi_192_;
                        phi_3069_ = false;
                        if (_e160 < select(_e69, _e77, (_e77 < _e69))) {
                            if (_e160 == _e158) {
                                let _e2935 = global_4.member[((_e162 + 2u) * _e112)];
                                if _e122 {
                                    phi_3068_ = _e2935;
                                } else {
                                    let _e2938 = global_5.member[_e2935];
                                    phi_3068_ = _e2938;
                                }
                                let _e2940 = phi_3068_;
                                phi_188_ = _e2940;
                                phi_191_ = _e160;
                                phi_193_ = (_e162 + 1u);
                            } else {
                                let _e165 = (_e160 + _e56);
                                let _e167 = select(_e158, _e165, (_e165 < _e158));
                                let _e168 = (_e53 == 0u);
                                if _e168 {
                                    phi_3069_ = true;
                                    break;
                                }
                                let _e169 = (_e50 / _e53);
                                if _e168 {
                                    phi_3069_ = true;
                                    break;
                                }
                                let _e170 = (_e50 % _e53);
                                if (_e160 > _e65) {
                                    phi_216_ = (_e160 - _e65);
                                } else {
                                    phi_216_ = 0u;
                                }
                                let _e174 = phi_216_;
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
                                    let _e861 = (_e169 * 4u);
                                    let _e864 = global_3.member.member_5;
                                    let _e867 = ((_e864 + (_e861 * _e53)) + _e170);
                                    let _e868 = (_e60 - _e861);
                                    let _e872 = (_e867 + (select(_e868, 1u, (1u < _e868)) * _e53));
                                    let _e876 = (_e867 + (select(_e868, 2u, (2u < _e868)) * _e53));
                                    let _e880 = (_e867 + (select(_e868, 3u, (3u < _e868)) * _e53));
                                    let _e885 = (_e861 * _e192);
                                    let _e886 = (_e861 + 1u);
                                    let _e889 = (select(_e60, _e886, (_e886 < _e60)) * _e192);
                                    let _e890 = (_e861 + 2u);
                                    let _e893 = (select(_e60, _e890, (_e890 < _e60)) * _e192);
                                    let _e894 = (_e861 + 3u);
                                    let _e897 = (select(_e60, _e894, (_e894 < _e60)) * _e192);
                                    if _e189 {
                                        let _e900 = global_6.member[(_e184 + _e867)];
                                        phi_980_ = _e900;
                                    } else {
                                        phi_980_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e902 = phi_980_;
                                    if _e189 {
                                        let _e910 = global_6.member[(_e184 + _e872)];
                                        phi_991_ = _e910;
                                    } else {
                                        phi_991_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e912 = phi_991_;
                                    if _e189 {
                                        let _e920 = global_6.member[(_e184 + _e876)];
                                        phi_1002_ = _e920;
                                    } else {
                                        phi_1002_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e922 = phi_1002_;
                                    if _e189 {
                                        let _e930 = global_6.member[(_e184 + _e880)];
                                        phi_1013_ = _e930;
                                    } else {
                                        phi_1013_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e932 = phi_1013_;
                                    let _e938 = (_e174 % 4u);
                                    if (_e938 == 0u) {
                                        phi_1026_ = _e174;
                                    } else {
                                        phi_1026_ = (_e174 + (4u - _e938));
                                    }
                                    let _e943 = phi_1026_;
                                    phi_1030_ = type_18(_e932.x, _e932.y, _e932.z, _e932.w);
                                    phi_1033_ = type_18(_e922.x, _e922.y, _e922.z, _e922.w);
                                    phi_1035_ = type_18(_e912.x, _e912.y, _e912.z, _e912.w);
                                    phi_1037_ = type_18(_e902.x, _e902.y, _e902.z, _e902.w);
                                    phi_1039_ = _e174;
                                    loop {
                                        let _e947 = phi_1030_;
                                        let _e949 = phi_1033_;
                                        let _e951 = phi_1035_;
                                        let _e953 = phi_1037_;
                                        let _e955 = phi_1039_;
                                        let _e956 = (_e955 + 1u);
                                        local_62 = _e947;
                                        local_64 = _e949;
                                        local_66 = _e951;
                                        local_68 = _e953;
                                        if (_e956 <= select(_e177, _e943, (_e943 < _e177))) {
                                            let _e958 = (_e194 + _e955);
                                            let _e964 = global_7.member[(((_e958 / 4u) * 4u) / 4u)];
                                            if ((_e958 % 2u) == 0u) {
                                                phi_1061_ = array<f32, 2>(_e964.x, _e964.z);
                                            } else {
                                                phi_1061_ = array<f32, 2>(_e964.y, _e964.w);
                                            }
                                            let _e974 = phi_1061_;
                                            if ((_e958 % 4u) < 2u) {
                                                phi_1069_ = _e974[0];
                                            } else {
                                                phi_1069_ = _e974[1];
                                            }
                                            let _e980 = phi_1069_;
                                            let _e981 = (_e958 + _e192);
                                            let _e987 = global_7.member[(((_e981 / 4u) * 4u) / 4u)];
                                            if ((_e981 % 2u) == 0u) {
                                                phi_1087_ = array<f32, 2>(_e987.x, _e987.z);
                                            } else {
                                                phi_1087_ = array<f32, 2>(_e987.y, _e987.w);
                                            }
                                            let _e997 = phi_1087_;
                                            if ((_e981 % 4u) < 2u) {
                                                phi_1095_ = _e997[0];
                                            } else {
                                                phi_1095_ = _e997[1];
                                            }
                                            let _e1003 = phi_1095_;
                                            let _e1005 = (_e958 + (2u * _e192));
                                            let _e1011 = global_7.member[(((_e1005 / 4u) * 4u) / 4u)];
                                            if ((_e1005 % 2u) == 0u) {
                                                phi_1114_ = array<f32, 2>(_e1011.x, _e1011.z);
                                            } else {
                                                phi_1114_ = array<f32, 2>(_e1011.y, _e1011.w);
                                            }
                                            let _e1021 = phi_1114_;
                                            if ((_e1005 % 4u) < 2u) {
                                                phi_1122_ = _e1021[0];
                                            } else {
                                                phi_1122_ = _e1021[1];
                                            }
                                            let _e1027 = phi_1122_;
                                            let _e1029 = (_e958 + (3u * _e192));
                                            let _e1035 = global_7.member[(((_e1029 / 4u) * 4u) / 4u)];
                                            if ((_e1029 % 2u) == 0u) {
                                                phi_1141_ = array<f32, 2>(_e1035.x, _e1035.z);
                                            } else {
                                                phi_1141_ = array<f32, 2>(_e1035.y, _e1035.w);
                                            }
                                            let _e1045 = phi_1141_;
                                            if ((_e1029 % 4u) < 2u) {
                                                phi_1149_ = _e1045[0];
                                            } else {
                                                phi_1149_ = _e1045[1];
                                            }
                                            let _e1051 = phi_1149_;
                                            let _e1052 = (_e885 + _e955);
                                            let _e1058 = global_9.member[(((_e1052 / 4u) * 4u) / 4u)];
                                            if ((_e1052 % 2u) == 0u) {
                                                phi_1167_ = array<f32, 2>(_e1058.x, _e1058.z);
                                            } else {
                                                phi_1167_ = array<f32, 2>(_e1058.y, _e1058.w);
                                            }
                                            let _e1068 = phi_1167_;
                                            if ((_e1052 % 4u) < 2u) {
                                                phi_1175_ = _e1068[0];
                                            } else {
                                                phi_1175_ = _e1068[1];
                                            }
                                            let _e1074 = phi_1175_;
                                            let _e1088 = (_e889 + _e955);
                                            let _e1094 = global_9.member[(((_e1088 / 4u) * 4u) / 4u)];
                                            local_60 = type_18(((_e1074 * _e980) + _e953.member), ((_e1074 * _e1003) + _e953.member_1), ((_e1074 * _e1027) + _e953.member_2), ((_e1074 * _e1051) + _e953.member_3));
                                            if ((_e1088 % 2u) == 0u) {
                                                phi_1205_ = array<f32, 2>(_e1094.x, _e1094.z);
                                            } else {
                                                phi_1205_ = array<f32, 2>(_e1094.y, _e1094.w);
                                            }
                                            let _e1104 = phi_1205_;
                                            if ((_e1088 % 4u) < 2u) {
                                                phi_1213_ = _e1104[0];
                                            } else {
                                                phi_1213_ = _e1104[1];
                                            }
                                            let _e1110 = phi_1213_;
                                            let _e1124 = (_e893 + _e955);
                                            let _e1130 = global_9.member[(((_e1124 / 4u) * 4u) / 4u)];
                                            local_59 = type_18(((_e1110 * _e980) + _e951.member), ((_e1110 * _e1003) + _e951.member_1), ((_e1110 * _e1027) + _e951.member_2), ((_e1110 * _e1051) + _e951.member_3));
                                            if ((_e1124 % 2u) == 0u) {
                                                phi_1243_ = array<f32, 2>(_e1130.x, _e1130.z);
                                            } else {
                                                phi_1243_ = array<f32, 2>(_e1130.y, _e1130.w);
                                            }
                                            let _e1140 = phi_1243_;
                                            if ((_e1124 % 4u) < 2u) {
                                                phi_1251_ = _e1140[0];
                                            } else {
                                                phi_1251_ = _e1140[1];
                                            }
                                            let _e1146 = phi_1251_;
                                            let _e1160 = (_e897 + _e955);
                                            let _e1166 = global_9.member[(((_e1160 / 4u) * 4u) / 4u)];
                                            local_58 = type_18(((_e1146 * _e980) + _e949.member), ((_e1146 * _e1003) + _e949.member_1), ((_e1146 * _e1027) + _e949.member_2), ((_e1146 * _e1051) + _e949.member_3));
                                            if ((_e1160 % 2u) == 0u) {
                                                phi_1281_ = array<f32, 2>(_e1166.x, _e1166.z);
                                            } else {
                                                phi_1281_ = array<f32, 2>(_e1166.y, _e1166.w);
                                            }
                                            let _e1176 = phi_1281_;
                                            if ((_e1160 % 4u) < 2u) {
                                                phi_1289_ = _e1176[0];
                                            } else {
                                                phi_1289_ = _e1176[1];
                                            }
                                            let _e1182 = phi_1289_;
                                            local_57 = type_18(((_e1182 * _e980) + _e947.member), ((_e1182 * _e1003) + _e947.member_1), ((_e1182 * _e1027) + _e947.member_2), ((_e1182 * _e1051) + _e947.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e3055 = local_57;
                                            phi_1030_ = _e3055;
                                            let _e3058 = local_58;
                                            phi_1033_ = _e3058;
                                            let _e3061 = local_59;
                                            phi_1035_ = _e3061;
                                            let _e3064 = local_60;
                                            phi_1037_ = _e3064;
                                            phi_1039_ = _e956;
                                        }
                                    }
                                    let _e1201 = (_e192 / 4u);
                                    phi_1310_ = (_e943 / 4u);
                                    let _e3087 = local_62;
                                    phi_1313_ = _e3087;
                                    let _e3092 = local_64;
                                    phi_1315_ = _e3092;
                                    let _e3097 = local_66;
                                    phi_1317_ = _e3097;
                                    let _e3102 = local_68;
                                    phi_1319_ = _e3102;
                                    loop {
                                        let _e1204 = phi_1310_;
                                        let _e1206 = phi_1313_;
                                        let _e1208 = phi_1315_;
                                        let _e1210 = phi_1317_;
                                        let _e1212 = phi_1319_;
                                        let _e1213 = (4u * _e1204);
                                        local_70 = _e1206;
                                        local_72 = _e1208;
                                        local_74 = _e1210;
                                        local_76 = _e1212;
                                        local_78 = _e1213;
                                        if ((_e1213 + 4u) <= _e177) {
                                            let _e1216 = ((_e194 / 4u) + _e1204);
                                            let _e1219 = global_7.member[_e1216];
                                            let _e1227 = global_7.member[(_e1216 + _e1201)];
                                            let _e1236 = global_7.member[(_e1216 + (2u * _e1201))];
                                            let _e1245 = global_7.member[(_e1216 + (3u * _e1201))];
                                            let _e1253 = global_9.member[((_e885 / 4u) + _e1204)];
                                            let _e1261 = global_9.member[((_e889 / 4u) + _e1204)];
                                            let _e1269 = global_9.member[((_e893 / 4u) + _e1204)];
                                            let _e1277 = global_9.member[((_e897 / 4u) + _e1204)];
                                            local_61 = (_e1204 + 1u);
                                            local_63 = type_18(((_e1277.w * _e1219.w) + ((_e1277.z * _e1219.z) + ((_e1277.y * _e1219.y) + ((_e1277.x * _e1219.x) + _e1206.member)))), ((_e1277.w * _e1227.w) + ((_e1277.z * _e1227.z) + ((_e1277.y * _e1227.y) + ((_e1277.x * _e1227.x) + _e1206.member_1)))), ((_e1277.w * _e1236.w) + ((_e1277.z * _e1236.z) + ((_e1277.y * _e1236.y) + ((_e1277.x * _e1236.x) + _e1206.member_2)))), ((_e1277.w * _e1245.w) + ((_e1277.z * _e1245.z) + ((_e1277.y * _e1245.y) + ((_e1277.x * _e1245.x) + _e1206.member_3)))));
                                            local_65 = type_18(((_e1269.w * _e1219.w) + ((_e1269.z * _e1219.z) + ((_e1269.y * _e1219.y) + ((_e1269.x * _e1219.x) + _e1208.member)))), ((_e1269.w * _e1227.w) + ((_e1269.z * _e1227.z) + ((_e1269.y * _e1227.y) + ((_e1269.x * _e1227.x) + _e1208.member_1)))), ((_e1269.w * _e1236.w) + ((_e1269.z * _e1236.z) + ((_e1269.y * _e1236.y) + ((_e1269.x * _e1236.x) + _e1208.member_2)))), ((_e1269.w * _e1245.w) + ((_e1269.z * _e1245.z) + ((_e1269.y * _e1245.y) + ((_e1269.x * _e1245.x) + _e1208.member_3)))));
                                            local_67 = type_18(((_e1261.w * _e1219.w) + ((_e1261.z * _e1219.z) + ((_e1261.y * _e1219.y) + ((_e1261.x * _e1219.x) + _e1210.member)))), ((_e1261.w * _e1227.w) + ((_e1261.z * _e1227.z) + ((_e1261.y * _e1227.y) + ((_e1261.x * _e1227.x) + _e1210.member_1)))), ((_e1261.w * _e1236.w) + ((_e1261.z * _e1236.z) + ((_e1261.y * _e1236.y) + ((_e1261.x * _e1236.x) + _e1210.member_2)))), ((_e1261.w * _e1245.w) + ((_e1261.z * _e1245.z) + ((_e1261.y * _e1245.y) + ((_e1261.x * _e1245.x) + _e1210.member_3)))));
                                            local_69 = type_18(((_e1253.w * _e1219.w) + ((_e1253.z * _e1219.z) + ((_e1253.y * _e1219.y) + ((_e1253.x * _e1219.x) + _e1212.member)))), ((_e1253.w * _e1227.w) + ((_e1253.z * _e1227.z) + ((_e1253.y * _e1227.y) + ((_e1253.x * _e1227.x) + _e1212.member_1)))), ((_e1253.w * _e1236.w) + ((_e1253.z * _e1236.z) + ((_e1253.y * _e1236.y) + ((_e1253.x * _e1236.x) + _e1212.member_2)))), ((_e1253.w * _e1245.w) + ((_e1253.z * _e1245.z) + ((_e1253.y * _e1245.y) + ((_e1253.x * _e1245.x) + _e1212.member_3)))));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e3084 = local_61;
                                            phi_1310_ = _e3084;
                                            let _e3089 = local_63;
                                            phi_1313_ = _e3089;
                                            let _e3094 = local_65;
                                            phi_1315_ = _e3094;
                                            let _e3099 = local_67;
                                            phi_1317_ = _e3099;
                                            let _e3104 = local_69;
                                            phi_1319_ = _e3104;
                                        }
                                    }
                                    let _e3107 = local_70;
                                    phi_1529_ = _e3107;
                                    let _e3112 = local_72;
                                    phi_1532_ = _e3112;
                                    let _e3117 = local_74;
                                    phi_1534_ = _e3117;
                                    let _e3122 = local_76;
                                    phi_1536_ = _e3122;
                                    let _e3127 = local_78;
                                    phi_1538_ = _e3127;
                                    loop {
                                        let _e1432 = phi_1529_;
                                        let _e1434 = phi_1532_;
                                        let _e1436 = phi_1534_;
                                        let _e1438 = phi_1536_;
                                        let _e1440 = phi_1538_;
                                        let _e1441 = (_e1440 + 1u);
                                        local_10 = _e1438;
                                        local_11 = _e1438;
                                        local_12 = _e1438;
                                        local_13 = _e1438;
                                        local_14 = _e1436;
                                        local_15 = _e1436;
                                        local_16 = _e1436;
                                        local_17 = _e1436;
                                        local_18 = _e1434;
                                        local_19 = _e1434;
                                        local_20 = _e1434;
                                        local_21 = _e1434;
                                        local_22 = _e1432;
                                        local_23 = _e1432;
                                        local_24 = _e1432;
                                        local_25 = _e1432;
                                        local_83 = _e1440;
                                        if (_e1441 <= _e177) {
                                            let _e1443 = (_e194 + _e1440);
                                            let _e1449 = global_7.member[(((_e1443 / 4u) * 4u) / 4u)];
                                            if ((_e1443 % 2u) == 0u) {
                                                phi_1560_ = array<f32, 2>(_e1449.x, _e1449.z);
                                            } else {
                                                phi_1560_ = array<f32, 2>(_e1449.y, _e1449.w);
                                            }
                                            let _e1459 = phi_1560_;
                                            if ((_e1443 % 4u) < 2u) {
                                                phi_1568_ = _e1459[0];
                                            } else {
                                                phi_1568_ = _e1459[1];
                                            }
                                            let _e1465 = phi_1568_;
                                            let _e1466 = (_e1443 + _e192);
                                            let _e1472 = global_7.member[(((_e1466 / 4u) * 4u) / 4u)];
                                            if ((_e1466 % 2u) == 0u) {
                                                phi_1586_ = array<f32, 2>(_e1472.x, _e1472.z);
                                            } else {
                                                phi_1586_ = array<f32, 2>(_e1472.y, _e1472.w);
                                            }
                                            let _e1482 = phi_1586_;
                                            if ((_e1466 % 4u) < 2u) {
                                                phi_1594_ = _e1482[0];
                                            } else {
                                                phi_1594_ = _e1482[1];
                                            }
                                            let _e1488 = phi_1594_;
                                            let _e1490 = (_e1443 + (2u * _e192));
                                            let _e1496 = global_7.member[(((_e1490 / 4u) * 4u) / 4u)];
                                            if ((_e1490 % 2u) == 0u) {
                                                phi_1613_ = array<f32, 2>(_e1496.x, _e1496.z);
                                            } else {
                                                phi_1613_ = array<f32, 2>(_e1496.y, _e1496.w);
                                            }
                                            let _e1506 = phi_1613_;
                                            if ((_e1490 % 4u) < 2u) {
                                                phi_1621_ = _e1506[0];
                                            } else {
                                                phi_1621_ = _e1506[1];
                                            }
                                            let _e1512 = phi_1621_;
                                            let _e1514 = (_e1443 + (3u * _e192));
                                            let _e1520 = global_7.member[(((_e1514 / 4u) * 4u) / 4u)];
                                            if ((_e1514 % 2u) == 0u) {
                                                phi_1640_ = array<f32, 2>(_e1520.x, _e1520.z);
                                            } else {
                                                phi_1640_ = array<f32, 2>(_e1520.y, _e1520.w);
                                            }
                                            let _e1530 = phi_1640_;
                                            if ((_e1514 % 4u) < 2u) {
                                                phi_1648_ = _e1530[0];
                                            } else {
                                                phi_1648_ = _e1530[1];
                                            }
                                            let _e1536 = phi_1648_;
                                            let _e1537 = (_e885 + _e1440);
                                            let _e1543 = global_9.member[(((_e1537 / 4u) * 4u) / 4u)];
                                            if ((_e1537 % 2u) == 0u) {
                                                phi_1666_ = array<f32, 2>(_e1543.x, _e1543.z);
                                            } else {
                                                phi_1666_ = array<f32, 2>(_e1543.y, _e1543.w);
                                            }
                                            let _e1553 = phi_1666_;
                                            if ((_e1537 % 4u) < 2u) {
                                                phi_1674_ = _e1553[0];
                                            } else {
                                                phi_1674_ = _e1553[1];
                                            }
                                            let _e1559 = phi_1674_;
                                            let _e1573 = (_e889 + _e1440);
                                            let _e1579 = global_9.member[(((_e1573 / 4u) * 4u) / 4u)];
                                            local_77 = type_18(((_e1559 * _e1465) + _e1438.member), ((_e1559 * _e1488) + _e1438.member_1), ((_e1559 * _e1512) + _e1438.member_2), ((_e1559 * _e1536) + _e1438.member_3));
                                            if ((_e1573 % 2u) == 0u) {
                                                phi_1704_ = array<f32, 2>(_e1579.x, _e1579.z);
                                            } else {
                                                phi_1704_ = array<f32, 2>(_e1579.y, _e1579.w);
                                            }
                                            let _e1589 = phi_1704_;
                                            if ((_e1573 % 4u) < 2u) {
                                                phi_1712_ = _e1589[0];
                                            } else {
                                                phi_1712_ = _e1589[1];
                                            }
                                            let _e1595 = phi_1712_;
                                            let _e1609 = (_e893 + _e1440);
                                            let _e1615 = global_9.member[(((_e1609 / 4u) * 4u) / 4u)];
                                            local_75 = type_18(((_e1595 * _e1465) + _e1436.member), ((_e1595 * _e1488) + _e1436.member_1), ((_e1595 * _e1512) + _e1436.member_2), ((_e1595 * _e1536) + _e1436.member_3));
                                            if ((_e1609 % 2u) == 0u) {
                                                phi_1742_ = array<f32, 2>(_e1615.x, _e1615.z);
                                            } else {
                                                phi_1742_ = array<f32, 2>(_e1615.y, _e1615.w);
                                            }
                                            let _e1625 = phi_1742_;
                                            if ((_e1609 % 4u) < 2u) {
                                                phi_1750_ = _e1625[0];
                                            } else {
                                                phi_1750_ = _e1625[1];
                                            }
                                            let _e1631 = phi_1750_;
                                            let _e1645 = (_e897 + _e1440);
                                            let _e1651 = global_9.member[(((_e1645 / 4u) * 4u) / 4u)];
                                            local_73 = type_18(((_e1631 * _e1465) + _e1434.member), ((_e1631 * _e1488) + _e1434.member_1), ((_e1631 * _e1512) + _e1434.member_2), ((_e1631 * _e1536) + _e1434.member_3));
                                            if ((_e1645 % 2u) == 0u) {
                                                phi_1780_ = array<f32, 2>(_e1651.x, _e1651.z);
                                            } else {
                                                phi_1780_ = array<f32, 2>(_e1651.y, _e1651.w);
                                            }
                                            let _e1661 = phi_1780_;
                                            if ((_e1645 % 4u) < 2u) {
                                                phi_1788_ = _e1661[0];
                                            } else {
                                                phi_1788_ = _e1661[1];
                                            }
                                            let _e1667 = phi_1788_;
                                            local_71 = type_18(((_e1667 * _e1465) + _e1432.member), ((_e1667 * _e1488) + _e1432.member_1), ((_e1667 * _e1512) + _e1432.member_2), ((_e1667 * _e1536) + _e1432.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e3109 = local_71;
                                            phi_1529_ = _e3109;
                                            let _e3114 = local_73;
                                            phi_1532_ = _e3114;
                                            let _e3119 = local_75;
                                            phi_1534_ = _e3119;
                                            let _e3124 = local_77;
                                            phi_1536_ = _e3124;
                                            phi_1538_ = _e1441;
                                        }
                                    }
                                    let _e1682 = local_10;
                                    let _e1685 = local_11;
                                    let _e1688 = local_12;
                                    let _e1691 = local_13;
                                    let _e1694 = local_14;
                                    let _e1697 = local_15;
                                    let _e1700 = local_16;
                                    let _e1703 = local_17;
                                    let _e1706 = local_18;
                                    let _e1709 = local_19;
                                    let _e1712 = local_20;
                                    let _e1715 = local_21;
                                    let _e1718 = local_22;
                                    let _e1721 = local_23;
                                    let _e1724 = local_24;
                                    let _e1727 = local_25;
                                    phi_1818_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1821_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1823_ = type_18(0f, 0f, 0f, 0f);
                                    phi_1825_ = type_18(0f, 0f, 0f, 0f);
                                    let _e3174 = local_83;
                                    phi_1827_ = _e3174;
                                    loop {
                                        let _e1730 = phi_1818_;
                                        let _e1732 = phi_1821_;
                                        let _e1734 = phi_1823_;
                                        let _e1736 = phi_1825_;
                                        let _e1738 = phi_1827_;
                                        let _e1739 = (_e1738 + 1u);
                                        local_26 = _e1736;
                                        local_27 = _e1736;
                                        local_28 = _e1736;
                                        local_29 = _e1736;
                                        local_30 = _e1734;
                                        local_31 = _e1734;
                                        local_32 = _e1734;
                                        local_33 = _e1734;
                                        local_34 = _e1732;
                                        local_35 = _e1732;
                                        local_36 = _e1732;
                                        local_37 = _e1732;
                                        local_38 = _e1730;
                                        local_39 = _e1730;
                                        local_40 = _e1730;
                                        local_41 = _e1730;
                                        if (_e1739 <= _e177) {
                                            let _e1741 = (_e194 + _e1738);
                                            let _e1747 = global_7.member[(((_e1741 / 4u) * 4u) / 4u)];
                                            if ((_e1741 % 2u) == 0u) {
                                                phi_1849_ = array<f32, 2>(_e1747.x, _e1747.z);
                                            } else {
                                                phi_1849_ = array<f32, 2>(_e1747.y, _e1747.w);
                                            }
                                            let _e1757 = phi_1849_;
                                            if ((_e1741 % 4u) < 2u) {
                                                phi_1857_ = _e1757[0];
                                            } else {
                                                phi_1857_ = _e1757[1];
                                            }
                                            let _e1763 = phi_1857_;
                                            let _e1764 = (_e1741 + _e192);
                                            let _e1770 = global_7.member[(((_e1764 / 4u) * 4u) / 4u)];
                                            if ((_e1764 % 2u) == 0u) {
                                                phi_1875_ = array<f32, 2>(_e1770.x, _e1770.z);
                                            } else {
                                                phi_1875_ = array<f32, 2>(_e1770.y, _e1770.w);
                                            }
                                            let _e1780 = phi_1875_;
                                            if ((_e1764 % 4u) < 2u) {
                                                phi_1883_ = _e1780[0];
                                            } else {
                                                phi_1883_ = _e1780[1];
                                            }
                                            let _e1786 = phi_1883_;
                                            let _e1788 = (_e1741 + (2u * _e192));
                                            let _e1794 = global_7.member[(((_e1788 / 4u) * 4u) / 4u)];
                                            if ((_e1788 % 2u) == 0u) {
                                                phi_1902_ = array<f32, 2>(_e1794.x, _e1794.z);
                                            } else {
                                                phi_1902_ = array<f32, 2>(_e1794.y, _e1794.w);
                                            }
                                            let _e1804 = phi_1902_;
                                            if ((_e1788 % 4u) < 2u) {
                                                phi_1910_ = _e1804[0];
                                            } else {
                                                phi_1910_ = _e1804[1];
                                            }
                                            let _e1810 = phi_1910_;
                                            let _e1812 = (_e1741 + (3u * _e192));
                                            let _e1818 = global_7.member[(((_e1812 / 4u) * 4u) / 4u)];
                                            if ((_e1812 % 2u) == 0u) {
                                                phi_1929_ = array<f32, 2>(_e1818.x, _e1818.z);
                                            } else {
                                                phi_1929_ = array<f32, 2>(_e1818.y, _e1818.w);
                                            }
                                            let _e1828 = phi_1929_;
                                            if ((_e1812 % 4u) < 2u) {
                                                phi_1937_ = _e1828[0];
                                            } else {
                                                phi_1937_ = _e1828[1];
                                            }
                                            let _e1834 = phi_1937_;
                                            let _e1835 = (_e885 + _e1738);
                                            let _e1841 = global_9.member[(((_e1835 / 4u) * 4u) / 4u)];
                                            if ((_e1835 % 2u) == 0u) {
                                                phi_1955_ = array<f32, 2>(_e1841.x, _e1841.z);
                                            } else {
                                                phi_1955_ = array<f32, 2>(_e1841.y, _e1841.w);
                                            }
                                            let _e1851 = phi_1955_;
                                            if ((_e1835 % 4u) < 2u) {
                                                phi_1963_ = _e1851[0];
                                            } else {
                                                phi_1963_ = _e1851[1];
                                            }
                                            let _e1857 = phi_1963_;
                                            let _e1871 = (_e889 + _e1738);
                                            let _e1877 = global_9.member[(((_e1871 / 4u) * 4u) / 4u)];
                                            local_82 = type_18(((_e1857 * _e1763) + _e1736.member), ((_e1857 * _e1786) + _e1736.member_1), ((_e1857 * _e1810) + _e1736.member_2), ((_e1857 * _e1834) + _e1736.member_3));
                                            if ((_e1871 % 2u) == 0u) {
                                                phi_1993_ = array<f32, 2>(_e1877.x, _e1877.z);
                                            } else {
                                                phi_1993_ = array<f32, 2>(_e1877.y, _e1877.w);
                                            }
                                            let _e1887 = phi_1993_;
                                            if ((_e1871 % 4u) < 2u) {
                                                phi_2001_ = _e1887[0];
                                            } else {
                                                phi_2001_ = _e1887[1];
                                            }
                                            let _e1893 = phi_2001_;
                                            let _e1907 = (_e893 + _e1738);
                                            let _e1913 = global_9.member[(((_e1907 / 4u) * 4u) / 4u)];
                                            local_81 = type_18(((_e1893 * _e1763) + _e1734.member), ((_e1893 * _e1786) + _e1734.member_1), ((_e1893 * _e1810) + _e1734.member_2), ((_e1893 * _e1834) + _e1734.member_3));
                                            if ((_e1907 % 2u) == 0u) {
                                                phi_2031_ = array<f32, 2>(_e1913.x, _e1913.z);
                                            } else {
                                                phi_2031_ = array<f32, 2>(_e1913.y, _e1913.w);
                                            }
                                            let _e1923 = phi_2031_;
                                            if ((_e1907 % 4u) < 2u) {
                                                phi_2039_ = _e1923[0];
                                            } else {
                                                phi_2039_ = _e1923[1];
                                            }
                                            let _e1929 = phi_2039_;
                                            let _e1943 = (_e897 + _e1738);
                                            let _e1949 = global_9.member[(((_e1943 / 4u) * 4u) / 4u)];
                                            local_80 = type_18(((_e1929 * _e1763) + _e1732.member), ((_e1929 * _e1786) + _e1732.member_1), ((_e1929 * _e1810) + _e1732.member_2), ((_e1929 * _e1834) + _e1732.member_3));
                                            if ((_e1943 % 2u) == 0u) {
                                                phi_2069_ = array<f32, 2>(_e1949.x, _e1949.z);
                                            } else {
                                                phi_2069_ = array<f32, 2>(_e1949.y, _e1949.w);
                                            }
                                            let _e1959 = phi_2069_;
                                            if ((_e1943 % 4u) < 2u) {
                                                phi_2077_ = _e1959[0];
                                            } else {
                                                phi_2077_ = _e1959[1];
                                            }
                                            let _e1965 = phi_2077_;
                                            local_79 = type_18(((_e1965 * _e1763) + _e1730.member), ((_e1965 * _e1786) + _e1730.member_1), ((_e1965 * _e1810) + _e1730.member_2), ((_e1965 * _e1834) + _e1730.member_3));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e3162 = local_79;
                                            phi_1818_ = _e3162;
                                            let _e3165 = local_80;
                                            phi_1821_ = _e3165;
                                            let _e3168 = local_81;
                                            phi_1823_ = _e3168;
                                            let _e3171 = local_82;
                                            phi_1825_ = _e3171;
                                            phi_1827_ = _e1739;
                                        }
                                    }
                                    let _e1980 = local_26;
                                    let _e1982 = (_e1682.member + _e1980.member);
                                    let _e1984 = local_27;
                                    let _e1986 = (_e1685.member_1 + _e1984.member_1);
                                    let _e1988 = local_28;
                                    let _e1990 = (_e1688.member_2 + _e1988.member_2);
                                    let _e1992 = local_29;
                                    let _e1994 = (_e1691.member_3 + _e1992.member_3);
                                    if _e187 {
                                        let _e1999 = (4u * _e183);
                                        let _e2000 = (4u * _e867);
                                        let _e2001 = bitcast<u32>(_e1982);
                                        let _e2004 = ((_e2001 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2004 == 0u) {
                                        } else {
                                            let _e2007 = (_e2004 % 16u);
                                            let _e2009 = ((_e2001 & 8388607u) | 8388608u);
                                            let _e2012 = (_e2009 << bitcast<u32>((_e2007 & 31u)));
                                            let _e2018 = ((_e2009 >> bitcast<u32>(((31u - _e2007) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2001 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2140_ = array<u32, 2>(_e2012, _e2018);
                                            } else {
                                                let _e2024 = (~(_e2012) + 1u);
                                                if (_e2024 == 0u) {
                                                    phi_2138_ = (~(_e2018) + 1u);
                                                } else {
                                                    phi_2138_ = ~(_e2018);
                                                }
                                                let _e2030 = phi_2138_;
                                                phi_2140_ = array<u32, 2>(_e2024, _e2030);
                                            }
                                            let _e2033 = phi_2140_;
                                            let _e2034 = (_e2004 < 255u);
                                            if _e2034 {
                                                phi_2146_ = _e2033;
                                            } else {
                                                phi_2146_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2037 = phi_2146_;
                                            let _e2042 = (2u * ((select(16u, (_e2004 / 16u), _e2034) * _e1999) + _e2000));
                                            let _e2045 = atomicAdd((&global_8.member[_e2042]), _e2037[0]);
                                            let _e2053 = atomicAdd((&global_8.member[(_e2042 + 1u)]), (_e2037[1] + select(0u, 1u, ((_e2045 + _e2037[0]) < _e2037[0]))));
                                        }
                                        let _e2055 = bitcast<u32>(_e1986);
                                        let _e2058 = ((_e2055 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2058 == 0u) {
                                        } else {
                                            let _e2061 = (_e2058 % 16u);
                                            let _e2063 = ((_e2055 & 8388607u) | 8388608u);
                                            let _e2066 = (_e2063 << bitcast<u32>((_e2061 & 31u)));
                                            let _e2072 = ((_e2063 >> bitcast<u32>(((31u - _e2061) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2055 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2196_ = array<u32, 2>(_e2066, _e2072);
                                            } else {
                                                let _e2078 = (~(_e2066) + 1u);
                                                if (_e2078 == 0u) {
                                                    phi_2194_ = (~(_e2072) + 1u);
                                                } else {
                                                    phi_2194_ = ~(_e2072);
                                                }
                                                let _e2084 = phi_2194_;
                                                phi_2196_ = array<u32, 2>(_e2078, _e2084);
                                            }
                                            let _e2087 = phi_2196_;
                                            let _e2088 = (_e2058 < 255u);
                                            if _e2088 {
                                                phi_2202_ = _e2087;
                                            } else {
                                                phi_2202_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2091 = phi_2202_;
                                            let _e2096 = (2u * ((select(16u, (_e2058 / 16u), _e2088) * _e1999) + (_e2000 + 1u)));
                                            let _e2099 = atomicAdd((&global_8.member[_e2096]), _e2091[0]);
                                            let _e2107 = atomicAdd((&global_8.member[(_e2096 + 1u)]), (_e2091[1] + select(0u, 1u, ((_e2099 + _e2091[0]) < _e2091[0]))));
                                        }
                                        let _e2109 = bitcast<u32>(_e1990);
                                        let _e2112 = ((_e2109 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2112 == 0u) {
                                        } else {
                                            let _e2115 = (_e2112 % 16u);
                                            let _e2117 = ((_e2109 & 8388607u) | 8388608u);
                                            let _e2120 = (_e2117 << bitcast<u32>((_e2115 & 31u)));
                                            let _e2126 = ((_e2117 >> bitcast<u32>(((31u - _e2115) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2109 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2252_ = array<u32, 2>(_e2120, _e2126);
                                            } else {
                                                let _e2132 = (~(_e2120) + 1u);
                                                if (_e2132 == 0u) {
                                                    phi_2250_ = (~(_e2126) + 1u);
                                                } else {
                                                    phi_2250_ = ~(_e2126);
                                                }
                                                let _e2138 = phi_2250_;
                                                phi_2252_ = array<u32, 2>(_e2132, _e2138);
                                            }
                                            let _e2141 = phi_2252_;
                                            let _e2142 = (_e2112 < 255u);
                                            if _e2142 {
                                                phi_2258_ = _e2141;
                                            } else {
                                                phi_2258_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2145 = phi_2258_;
                                            let _e2150 = (2u * ((select(16u, (_e2112 / 16u), _e2142) * _e1999) + (_e2000 + 2u)));
                                            let _e2153 = atomicAdd((&global_8.member[_e2150]), _e2145[0]);
                                            let _e2161 = atomicAdd((&global_8.member[(_e2150 + 1u)]), (_e2145[1] + select(0u, 1u, ((_e2153 + _e2145[0]) < _e2145[0]))));
                                        }
                                        let _e2163 = bitcast<u32>(_e1994);
                                        let _e2166 = ((_e2163 >> bitcast<u32>(23i)) & 255u);
                                        if (_e2166 == 0u) {
                                        } else {
                                            let _e2169 = (_e2166 % 16u);
                                            let _e2171 = ((_e2163 & 8388607u) | 8388608u);
                                            let _e2174 = (_e2171 << bitcast<u32>((_e2169 & 31u)));
                                            let _e2180 = ((_e2171 >> bitcast<u32>(((31u - _e2169) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e2163 >> bitcast<u32>(31i)) == 0u) {
                                                phi_2308_ = array<u32, 2>(_e2174, _e2180);
                                            } else {
                                                let _e2186 = (~(_e2174) + 1u);
                                                if (_e2186 == 0u) {
                                                    phi_2306_ = (~(_e2180) + 1u);
                                                } else {
                                                    phi_2306_ = ~(_e2180);
                                                }
                                                let _e2192 = phi_2306_;
                                                phi_2308_ = array<u32, 2>(_e2186, _e2192);
                                            }
                                            let _e2195 = phi_2308_;
                                            let _e2196 = (_e2166 < 255u);
                                            if _e2196 {
                                                phi_2314_ = _e2195;
                                            } else {
                                                phi_2314_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e2199 = phi_2314_;
                                            let _e2204 = (2u * ((select(16u, (_e2166 / 16u), _e2196) * _e1999) + (_e2000 + 3u)));
                                            let _e2207 = atomicAdd((&global_8.member[_e2204]), _e2199[0]);
                                            let _e2215 = atomicAdd((&global_8.member[(_e2204 + 1u)]), (_e2199[1] + select(0u, 1u, ((_e2207 + _e2199[0]) < _e2199[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e186 + _e867)] = vec4<f32>(_e1982, _e1986, _e1990, _e1994);
                                    }
                                    if (_e886 < _e59) {
                                        let _e2218 = local_30;
                                        let _e2220 = (_e1694.member + _e2218.member);
                                        let _e2222 = local_31;
                                        let _e2224 = (_e1697.member_1 + _e2222.member_1);
                                        let _e2226 = local_32;
                                        let _e2228 = (_e1700.member_2 + _e2226.member_2);
                                        let _e2230 = local_33;
                                        let _e2232 = (_e1703.member_3 + _e2230.member_3);
                                        if _e187 {
                                            let _e2237 = (4u * _e183);
                                            let _e2238 = (4u * _e872);
                                            let _e2239 = bitcast<u32>(_e2220);
                                            let _e2242 = ((_e2239 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2242 == 0u) {
                                            } else {
                                                let _e2245 = (_e2242 % 16u);
                                                let _e2247 = ((_e2239 & 8388607u) | 8388608u);
                                                let _e2250 = (_e2247 << bitcast<u32>((_e2245 & 31u)));
                                                let _e2256 = ((_e2247 >> bitcast<u32>(((31u - _e2245) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2239 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2383_ = array<u32, 2>(_e2250, _e2256);
                                                } else {
                                                    let _e2262 = (~(_e2250) + 1u);
                                                    if (_e2262 == 0u) {
                                                        phi_2381_ = (~(_e2256) + 1u);
                                                    } else {
                                                        phi_2381_ = ~(_e2256);
                                                    }
                                                    let _e2268 = phi_2381_;
                                                    phi_2383_ = array<u32, 2>(_e2262, _e2268);
                                                }
                                                let _e2271 = phi_2383_;
                                                let _e2272 = (_e2242 < 255u);
                                                if _e2272 {
                                                    phi_2389_ = _e2271;
                                                } else {
                                                    phi_2389_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2275 = phi_2389_;
                                                let _e2280 = (2u * ((select(16u, (_e2242 / 16u), _e2272) * _e2237) + _e2238));
                                                let _e2283 = atomicAdd((&global_8.member[_e2280]), _e2275[0]);
                                                let _e2291 = atomicAdd((&global_8.member[(_e2280 + 1u)]), (_e2275[1] + select(0u, 1u, ((_e2283 + _e2275[0]) < _e2275[0]))));
                                            }
                                            let _e2293 = bitcast<u32>(_e2224);
                                            let _e2296 = ((_e2293 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2296 == 0u) {
                                            } else {
                                                let _e2299 = (_e2296 % 16u);
                                                let _e2301 = ((_e2293 & 8388607u) | 8388608u);
                                                let _e2304 = (_e2301 << bitcast<u32>((_e2299 & 31u)));
                                                let _e2310 = ((_e2301 >> bitcast<u32>(((31u - _e2299) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2293 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2439_ = array<u32, 2>(_e2304, _e2310);
                                                } else {
                                                    let _e2316 = (~(_e2304) + 1u);
                                                    if (_e2316 == 0u) {
                                                        phi_2437_ = (~(_e2310) + 1u);
                                                    } else {
                                                        phi_2437_ = ~(_e2310);
                                                    }
                                                    let _e2322 = phi_2437_;
                                                    phi_2439_ = array<u32, 2>(_e2316, _e2322);
                                                }
                                                let _e2325 = phi_2439_;
                                                let _e2326 = (_e2296 < 255u);
                                                if _e2326 {
                                                    phi_2445_ = _e2325;
                                                } else {
                                                    phi_2445_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2329 = phi_2445_;
                                                let _e2334 = (2u * ((select(16u, (_e2296 / 16u), _e2326) * _e2237) + (_e2238 + 1u)));
                                                let _e2337 = atomicAdd((&global_8.member[_e2334]), _e2329[0]);
                                                let _e2345 = atomicAdd((&global_8.member[(_e2334 + 1u)]), (_e2329[1] + select(0u, 1u, ((_e2337 + _e2329[0]) < _e2329[0]))));
                                            }
                                            let _e2347 = bitcast<u32>(_e2228);
                                            let _e2350 = ((_e2347 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2350 == 0u) {
                                            } else {
                                                let _e2353 = (_e2350 % 16u);
                                                let _e2355 = ((_e2347 & 8388607u) | 8388608u);
                                                let _e2358 = (_e2355 << bitcast<u32>((_e2353 & 31u)));
                                                let _e2364 = ((_e2355 >> bitcast<u32>(((31u - _e2353) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2347 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2495_ = array<u32, 2>(_e2358, _e2364);
                                                } else {
                                                    let _e2370 = (~(_e2358) + 1u);
                                                    if (_e2370 == 0u) {
                                                        phi_2493_ = (~(_e2364) + 1u);
                                                    } else {
                                                        phi_2493_ = ~(_e2364);
                                                    }
                                                    let _e2376 = phi_2493_;
                                                    phi_2495_ = array<u32, 2>(_e2370, _e2376);
                                                }
                                                let _e2379 = phi_2495_;
                                                let _e2380 = (_e2350 < 255u);
                                                if _e2380 {
                                                    phi_2501_ = _e2379;
                                                } else {
                                                    phi_2501_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2383 = phi_2501_;
                                                let _e2388 = (2u * ((select(16u, (_e2350 / 16u), _e2380) * _e2237) + (_e2238 + 2u)));
                                                let _e2391 = atomicAdd((&global_8.member[_e2388]), _e2383[0]);
                                                let _e2399 = atomicAdd((&global_8.member[(_e2388 + 1u)]), (_e2383[1] + select(0u, 1u, ((_e2391 + _e2383[0]) < _e2383[0]))));
                                            }
                                            let _e2401 = bitcast<u32>(_e2232);
                                            let _e2404 = ((_e2401 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2404 == 0u) {
                                            } else {
                                                let _e2407 = (_e2404 % 16u);
                                                let _e2409 = ((_e2401 & 8388607u) | 8388608u);
                                                let _e2412 = (_e2409 << bitcast<u32>((_e2407 & 31u)));
                                                let _e2418 = ((_e2409 >> bitcast<u32>(((31u - _e2407) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2401 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2551_ = array<u32, 2>(_e2412, _e2418);
                                                } else {
                                                    let _e2424 = (~(_e2412) + 1u);
                                                    if (_e2424 == 0u) {
                                                        phi_2549_ = (~(_e2418) + 1u);
                                                    } else {
                                                        phi_2549_ = ~(_e2418);
                                                    }
                                                    let _e2430 = phi_2549_;
                                                    phi_2551_ = array<u32, 2>(_e2424, _e2430);
                                                }
                                                let _e2433 = phi_2551_;
                                                let _e2434 = (_e2404 < 255u);
                                                if _e2434 {
                                                    phi_2557_ = _e2433;
                                                } else {
                                                    phi_2557_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2437 = phi_2557_;
                                                let _e2442 = (2u * ((select(16u, (_e2404 / 16u), _e2434) * _e2237) + (_e2238 + 3u)));
                                                let _e2445 = atomicAdd((&global_8.member[_e2442]), _e2437[0]);
                                                let _e2453 = atomicAdd((&global_8.member[(_e2442 + 1u)]), (_e2437[1] + select(0u, 1u, ((_e2445 + _e2437[0]) < _e2437[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e872)] = vec4<f32>(_e2220, _e2224, _e2228, _e2232);
                                        }
                                    }
                                    if (_e890 < _e59) {
                                        let _e2456 = local_34;
                                        let _e2458 = (_e1706.member + _e2456.member);
                                        let _e2460 = local_35;
                                        let _e2462 = (_e1709.member_1 + _e2460.member_1);
                                        let _e2464 = local_36;
                                        let _e2466 = (_e1712.member_2 + _e2464.member_2);
                                        let _e2468 = local_37;
                                        let _e2470 = (_e1715.member_3 + _e2468.member_3);
                                        if _e187 {
                                            let _e2475 = (4u * _e183);
                                            let _e2476 = (4u * _e876);
                                            let _e2477 = bitcast<u32>(_e2458);
                                            let _e2480 = ((_e2477 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2480 == 0u) {
                                            } else {
                                                let _e2483 = (_e2480 % 16u);
                                                let _e2485 = ((_e2477 & 8388607u) | 8388608u);
                                                let _e2488 = (_e2485 << bitcast<u32>((_e2483 & 31u)));
                                                let _e2494 = ((_e2485 >> bitcast<u32>(((31u - _e2483) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2477 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2626_ = array<u32, 2>(_e2488, _e2494);
                                                } else {
                                                    let _e2500 = (~(_e2488) + 1u);
                                                    if (_e2500 == 0u) {
                                                        phi_2624_ = (~(_e2494) + 1u);
                                                    } else {
                                                        phi_2624_ = ~(_e2494);
                                                    }
                                                    let _e2506 = phi_2624_;
                                                    phi_2626_ = array<u32, 2>(_e2500, _e2506);
                                                }
                                                let _e2509 = phi_2626_;
                                                let _e2510 = (_e2480 < 255u);
                                                if _e2510 {
                                                    phi_2632_ = _e2509;
                                                } else {
                                                    phi_2632_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2513 = phi_2632_;
                                                let _e2518 = (2u * ((select(16u, (_e2480 / 16u), _e2510) * _e2475) + _e2476));
                                                let _e2521 = atomicAdd((&global_8.member[_e2518]), _e2513[0]);
                                                let _e2529 = atomicAdd((&global_8.member[(_e2518 + 1u)]), (_e2513[1] + select(0u, 1u, ((_e2521 + _e2513[0]) < _e2513[0]))));
                                            }
                                            let _e2531 = bitcast<u32>(_e2462);
                                            let _e2534 = ((_e2531 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2534 == 0u) {
                                            } else {
                                                let _e2537 = (_e2534 % 16u);
                                                let _e2539 = ((_e2531 & 8388607u) | 8388608u);
                                                let _e2542 = (_e2539 << bitcast<u32>((_e2537 & 31u)));
                                                let _e2548 = ((_e2539 >> bitcast<u32>(((31u - _e2537) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2531 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2682_ = array<u32, 2>(_e2542, _e2548);
                                                } else {
                                                    let _e2554 = (~(_e2542) + 1u);
                                                    if (_e2554 == 0u) {
                                                        phi_2680_ = (~(_e2548) + 1u);
                                                    } else {
                                                        phi_2680_ = ~(_e2548);
                                                    }
                                                    let _e2560 = phi_2680_;
                                                    phi_2682_ = array<u32, 2>(_e2554, _e2560);
                                                }
                                                let _e2563 = phi_2682_;
                                                let _e2564 = (_e2534 < 255u);
                                                if _e2564 {
                                                    phi_2688_ = _e2563;
                                                } else {
                                                    phi_2688_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2567 = phi_2688_;
                                                let _e2572 = (2u * ((select(16u, (_e2534 / 16u), _e2564) * _e2475) + (_e2476 + 1u)));
                                                let _e2575 = atomicAdd((&global_8.member[_e2572]), _e2567[0]);
                                                let _e2583 = atomicAdd((&global_8.member[(_e2572 + 1u)]), (_e2567[1] + select(0u, 1u, ((_e2575 + _e2567[0]) < _e2567[0]))));
                                            }
                                            let _e2585 = bitcast<u32>(_e2466);
                                            let _e2588 = ((_e2585 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2588 == 0u) {
                                            } else {
                                                let _e2591 = (_e2588 % 16u);
                                                let _e2593 = ((_e2585 & 8388607u) | 8388608u);
                                                let _e2596 = (_e2593 << bitcast<u32>((_e2591 & 31u)));
                                                let _e2602 = ((_e2593 >> bitcast<u32>(((31u - _e2591) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2585 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2738_ = array<u32, 2>(_e2596, _e2602);
                                                } else {
                                                    let _e2608 = (~(_e2596) + 1u);
                                                    if (_e2608 == 0u) {
                                                        phi_2736_ = (~(_e2602) + 1u);
                                                    } else {
                                                        phi_2736_ = ~(_e2602);
                                                    }
                                                    let _e2614 = phi_2736_;
                                                    phi_2738_ = array<u32, 2>(_e2608, _e2614);
                                                }
                                                let _e2617 = phi_2738_;
                                                let _e2618 = (_e2588 < 255u);
                                                if _e2618 {
                                                    phi_2744_ = _e2617;
                                                } else {
                                                    phi_2744_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2621 = phi_2744_;
                                                let _e2626 = (2u * ((select(16u, (_e2588 / 16u), _e2618) * _e2475) + (_e2476 + 2u)));
                                                let _e2629 = atomicAdd((&global_8.member[_e2626]), _e2621[0]);
                                                let _e2637 = atomicAdd((&global_8.member[(_e2626 + 1u)]), (_e2621[1] + select(0u, 1u, ((_e2629 + _e2621[0]) < _e2621[0]))));
                                            }
                                            let _e2639 = bitcast<u32>(_e2470);
                                            let _e2642 = ((_e2639 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2642 == 0u) {
                                            } else {
                                                let _e2645 = (_e2642 % 16u);
                                                let _e2647 = ((_e2639 & 8388607u) | 8388608u);
                                                let _e2650 = (_e2647 << bitcast<u32>((_e2645 & 31u)));
                                                let _e2656 = ((_e2647 >> bitcast<u32>(((31u - _e2645) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2639 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2794_ = array<u32, 2>(_e2650, _e2656);
                                                } else {
                                                    let _e2662 = (~(_e2650) + 1u);
                                                    if (_e2662 == 0u) {
                                                        phi_2792_ = (~(_e2656) + 1u);
                                                    } else {
                                                        phi_2792_ = ~(_e2656);
                                                    }
                                                    let _e2668 = phi_2792_;
                                                    phi_2794_ = array<u32, 2>(_e2662, _e2668);
                                                }
                                                let _e2671 = phi_2794_;
                                                let _e2672 = (_e2642 < 255u);
                                                if _e2672 {
                                                    phi_2800_ = _e2671;
                                                } else {
                                                    phi_2800_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2675 = phi_2800_;
                                                let _e2680 = (2u * ((select(16u, (_e2642 / 16u), _e2672) * _e2475) + (_e2476 + 3u)));
                                                let _e2683 = atomicAdd((&global_8.member[_e2680]), _e2675[0]);
                                                let _e2691 = atomicAdd((&global_8.member[(_e2680 + 1u)]), (_e2675[1] + select(0u, 1u, ((_e2683 + _e2675[0]) < _e2675[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e876)] = vec4<f32>(_e2458, _e2462, _e2466, _e2470);
                                        }
                                    }
                                    if (_e894 < _e59) {
                                        let _e2694 = local_38;
                                        let _e2696 = (_e1718.member + _e2694.member);
                                        let _e2698 = local_39;
                                        let _e2700 = (_e1721.member_1 + _e2698.member_1);
                                        let _e2702 = local_40;
                                        let _e2704 = (_e1724.member_2 + _e2702.member_2);
                                        let _e2706 = local_41;
                                        let _e2708 = (_e1727.member_3 + _e2706.member_3);
                                        if _e187 {
                                            let _e2713 = (4u * _e183);
                                            let _e2714 = (4u * _e880);
                                            let _e2715 = bitcast<u32>(_e2696);
                                            let _e2718 = ((_e2715 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2718 == 0u) {
                                            } else {
                                                let _e2721 = (_e2718 % 16u);
                                                let _e2723 = ((_e2715 & 8388607u) | 8388608u);
                                                let _e2726 = (_e2723 << bitcast<u32>((_e2721 & 31u)));
                                                let _e2732 = ((_e2723 >> bitcast<u32>(((31u - _e2721) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2715 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2869_ = array<u32, 2>(_e2726, _e2732);
                                                } else {
                                                    let _e2738 = (~(_e2726) + 1u);
                                                    if (_e2738 == 0u) {
                                                        phi_2867_ = (~(_e2732) + 1u);
                                                    } else {
                                                        phi_2867_ = ~(_e2732);
                                                    }
                                                    let _e2744 = phi_2867_;
                                                    phi_2869_ = array<u32, 2>(_e2738, _e2744);
                                                }
                                                let _e2747 = phi_2869_;
                                                let _e2748 = (_e2718 < 255u);
                                                if _e2748 {
                                                    phi_2875_ = _e2747;
                                                } else {
                                                    phi_2875_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2751 = phi_2875_;
                                                let _e2756 = (2u * ((select(16u, (_e2718 / 16u), _e2748) * _e2713) + _e2714));
                                                let _e2759 = atomicAdd((&global_8.member[_e2756]), _e2751[0]);
                                                let _e2767 = atomicAdd((&global_8.member[(_e2756 + 1u)]), (_e2751[1] + select(0u, 1u, ((_e2759 + _e2751[0]) < _e2751[0]))));
                                            }
                                            let _e2769 = bitcast<u32>(_e2700);
                                            let _e2772 = ((_e2769 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2772 == 0u) {
                                            } else {
                                                let _e2775 = (_e2772 % 16u);
                                                let _e2777 = ((_e2769 & 8388607u) | 8388608u);
                                                let _e2780 = (_e2777 << bitcast<u32>((_e2775 & 31u)));
                                                let _e2786 = ((_e2777 >> bitcast<u32>(((31u - _e2775) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2769 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2925_ = array<u32, 2>(_e2780, _e2786);
                                                } else {
                                                    let _e2792 = (~(_e2780) + 1u);
                                                    if (_e2792 == 0u) {
                                                        phi_2923_ = (~(_e2786) + 1u);
                                                    } else {
                                                        phi_2923_ = ~(_e2786);
                                                    }
                                                    let _e2798 = phi_2923_;
                                                    phi_2925_ = array<u32, 2>(_e2792, _e2798);
                                                }
                                                let _e2801 = phi_2925_;
                                                let _e2802 = (_e2772 < 255u);
                                                if _e2802 {
                                                    phi_2931_ = _e2801;
                                                } else {
                                                    phi_2931_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2805 = phi_2931_;
                                                let _e2810 = (2u * ((select(16u, (_e2772 / 16u), _e2802) * _e2713) + (_e2714 + 1u)));
                                                let _e2813 = atomicAdd((&global_8.member[_e2810]), _e2805[0]);
                                                let _e2821 = atomicAdd((&global_8.member[(_e2810 + 1u)]), (_e2805[1] + select(0u, 1u, ((_e2813 + _e2805[0]) < _e2805[0]))));
                                            }
                                            let _e2823 = bitcast<u32>(_e2704);
                                            let _e2826 = ((_e2823 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2826 == 0u) {
                                            } else {
                                                let _e2829 = (_e2826 % 16u);
                                                let _e2831 = ((_e2823 & 8388607u) | 8388608u);
                                                let _e2834 = (_e2831 << bitcast<u32>((_e2829 & 31u)));
                                                let _e2840 = ((_e2831 >> bitcast<u32>(((31u - _e2829) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2823 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_2981_ = array<u32, 2>(_e2834, _e2840);
                                                } else {
                                                    let _e2846 = (~(_e2834) + 1u);
                                                    if (_e2846 == 0u) {
                                                        phi_2979_ = (~(_e2840) + 1u);
                                                    } else {
                                                        phi_2979_ = ~(_e2840);
                                                    }
                                                    let _e2852 = phi_2979_;
                                                    phi_2981_ = array<u32, 2>(_e2846, _e2852);
                                                }
                                                let _e2855 = phi_2981_;
                                                let _e2856 = (_e2826 < 255u);
                                                if _e2856 {
                                                    phi_2987_ = _e2855;
                                                } else {
                                                    phi_2987_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2859 = phi_2987_;
                                                let _e2864 = (2u * ((select(16u, (_e2826 / 16u), _e2856) * _e2713) + (_e2714 + 2u)));
                                                let _e2867 = atomicAdd((&global_8.member[_e2864]), _e2859[0]);
                                                let _e2875 = atomicAdd((&global_8.member[(_e2864 + 1u)]), (_e2859[1] + select(0u, 1u, ((_e2867 + _e2859[0]) < _e2859[0]))));
                                            }
                                            let _e2877 = bitcast<u32>(_e2708);
                                            let _e2880 = ((_e2877 >> bitcast<u32>(23i)) & 255u);
                                            if (_e2880 == 0u) {
                                            } else {
                                                let _e2883 = (_e2880 % 16u);
                                                let _e2885 = ((_e2877 & 8388607u) | 8388608u);
                                                let _e2888 = (_e2885 << bitcast<u32>((_e2883 & 31u)));
                                                let _e2894 = ((_e2885 >> bitcast<u32>(((31u - _e2883) & 31u))) >> bitcast<u32>(1i));
                                                if ((_e2877 >> bitcast<u32>(31i)) == 0u) {
                                                    phi_3037_ = array<u32, 2>(_e2888, _e2894);
                                                } else {
                                                    let _e2900 = (~(_e2888) + 1u);
                                                    if (_e2900 == 0u) {
                                                        phi_3035_ = (~(_e2894) + 1u);
                                                    } else {
                                                        phi_3035_ = ~(_e2894);
                                                    }
                                                    let _e2906 = phi_3035_;
                                                    phi_3037_ = array<u32, 2>(_e2900, _e2906);
                                                }
                                                let _e2909 = phi_3037_;
                                                let _e2910 = (_e2880 < 255u);
                                                if _e2910 {
                                                    phi_3043_ = _e2909;
                                                } else {
                                                    phi_3043_ = array<u32, 2>(1u, 0u);
                                                }
                                                let _e2913 = phi_3043_;
                                                let _e2918 = (2u * ((select(16u, (_e2880 / 16u), _e2910) * _e2713) + (_e2714 + 3u)));
                                                let _e2921 = atomicAdd((&global_8.member[_e2918]), _e2913[0]);
                                                let _e2929 = atomicAdd((&global_8.member[(_e2918 + 1u)]), (_e2913[1] + select(0u, 1u, ((_e2921 + _e2913[0]) < _e2913[0]))));
                                            }
                                        } else {
                                            global_6.member[(_e186 + _e880)] = vec4<f32>(_e2696, _e2700, _e2704, _e2708);
                                        }
                                    }
                                } else {
                                    let _e198 = global_3.member.member_6;
                                    let _e199 = (_e198 + _e170);
                                    if _e189 {
                                        let _e203 = global_6.member[(_e184 + _e199)];
                                        phi_247_ = _e203;
                                    } else {
                                        phi_247_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e205 = phi_247_;
                                    let _e211 = (_e174 % 4u);
                                    if (_e211 == 0u) {
                                        phi_260_ = _e174;
                                    } else {
                                        phi_260_ = (_e174 + (4u - _e211));
                                    }
                                    let _e216 = phi_260_;
                                    phi_264_ = _e174;
                                    phi_267_ = type_18(_e205.x, _e205.y, _e205.z, _e205.w);
                                    loop {
                                        let _e220 = phi_264_;
                                        let _e222 = phi_267_;
                                        let _e223 = (_e220 + 1u);
                                        local_50 = _e222;
                                        if (_e223 <= select(_e177, _e216, (_e216 < _e177))) {
                                            let _e225 = (_e194 + _e220);
                                            let _e231 = global_7.member[(((_e225 / 4u) * 4u) / 4u)];
                                            if ((_e225 % 2u) == 0u) {
                                                phi_289_ = array<f32, 2>(_e231.x, _e231.z);
                                            } else {
                                                phi_289_ = array<f32, 2>(_e231.y, _e231.w);
                                            }
                                            let _e241 = phi_289_;
                                            if ((_e225 % 4u) < 2u) {
                                                phi_297_ = _e241[0];
                                            } else {
                                                phi_297_ = _e241[1];
                                            }
                                            let _e247 = phi_297_;
                                            let _e248 = (_e225 + _e192);
                                            let _e254 = global_7.member[(((_e248 / 4u) * 4u) / 4u)];
                                            if ((_e248 % 2u) == 0u) {
                                                phi_315_ = array<f32, 2>(_e254.x, _e254.z);
                                            } else {
                                                phi_315_ = array<f32, 2>(_e254.y, _e254.w);
                                            }
                                            let _e264 = phi_315_;
                                            if ((_e248 % 4u) < 2u) {
                                                phi_323_ = _e264[0];
                                            } else {
                                                phi_323_ = _e264[1];
                                            }
                                            let _e270 = phi_323_;
                                            let _e272 = (_e225 + (2u * _e192));
                                            let _e278 = global_7.member[(((_e272 / 4u) * 4u) / 4u)];
                                            if ((_e272 % 2u) == 0u) {
                                                phi_342_ = array<f32, 2>(_e278.x, _e278.z);
                                            } else {
                                                phi_342_ = array<f32, 2>(_e278.y, _e278.w);
                                            }
                                            let _e288 = phi_342_;
                                            if ((_e272 % 4u) < 2u) {
                                                phi_350_ = _e288[0];
                                            } else {
                                                phi_350_ = _e288[1];
                                            }
                                            let _e294 = phi_350_;
                                            let _e296 = (_e225 + (3u * _e192));
                                            let _e302 = global_7.member[(((_e296 / 4u) * 4u) / 4u)];
                                            if ((_e296 % 2u) == 0u) {
                                                phi_369_ = array<f32, 2>(_e302.x, _e302.z);
                                            } else {
                                                phi_369_ = array<f32, 2>(_e302.y, _e302.w);
                                            }
                                            let _e312 = phi_369_;
                                            if ((_e296 % 4u) < 2u) {
                                                phi_377_ = _e312[0];
                                            } else {
                                                phi_377_ = _e312[1];
                                            }
                                            let _e318 = phi_377_;
                                            local_48 = type_18((_e222.member + _e247), (_e222.member_1 + _e270), (_e222.member_2 + _e294), (_e222.member_3 + _e318));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_264_ = _e223;
                                            let _e2981 = local_48;
                                            phi_267_ = _e2981;
                                        }
                                    }
                                    phi_388_ = (_e216 / 4u);
                                    let _e2995 = local_50;
                                    phi_391_ = _e2995;
                                    loop {
                                        let _e330 = phi_388_;
                                        let _e332 = phi_391_;
                                        let _e333 = (4u * _e330);
                                        local_52 = _e333;
                                        local_53 = _e332;
                                        if ((_e333 + 4u) <= _e177) {
                                            let _e337 = ((_e194 / 4u) + _e330);
                                            let _e338 = (_e192 / 4u);
                                            let _e341 = global_7.member[_e337];
                                            let _e349 = global_7.member[(_e337 + _e338)];
                                            let _e358 = global_7.member[(_e337 + (2u * _e338))];
                                            let _e367 = global_7.member[(_e337 + (3u * _e338))];
                                            local_49 = (_e330 + 1u);
                                            local_51 = type_18(((((_e332.member + _e341.x) + _e341.y) + _e341.z) + _e341.w), ((((_e332.member_1 + _e349.x) + _e349.y) + _e349.z) + _e349.w), ((((_e332.member_2 + _e358.x) + _e358.y) + _e358.z) + _e358.w), ((((_e332.member_3 + _e367.x) + _e367.y) + _e367.z) + _e367.w));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e2992 = local_49;
                                            phi_388_ = _e2992;
                                            let _e2997 = local_51;
                                            phi_391_ = _e2997;
                                        }
                                    }
                                    let _e3000 = local_52;
                                    phi_451_ = _e3000;
                                    let _e3003 = local_53;
                                    phi_454_ = _e3003;
                                    loop {
                                        let _e395 = phi_451_;
                                        let _e397 = phi_454_;
                                        let _e398 = (_e395 + 1u);
                                        local_2 = _e397;
                                        local_3 = _e397;
                                        local_4 = _e397;
                                        local_5 = _e397;
                                        local_55 = _e395;
                                        if (_e398 <= _e177) {
                                            let _e400 = (_e194 + _e395);
                                            let _e406 = global_7.member[(((_e400 / 4u) * 4u) / 4u)];
                                            if ((_e400 % 2u) == 0u) {
                                                phi_476_ = array<f32, 2>(_e406.x, _e406.z);
                                            } else {
                                                phi_476_ = array<f32, 2>(_e406.y, _e406.w);
                                            }
                                            let _e416 = phi_476_;
                                            if ((_e400 % 4u) < 2u) {
                                                phi_484_ = _e416[0];
                                            } else {
                                                phi_484_ = _e416[1];
                                            }
                                            let _e422 = phi_484_;
                                            let _e423 = (_e400 + _e192);
                                            let _e429 = global_7.member[(((_e423 / 4u) * 4u) / 4u)];
                                            if ((_e423 % 2u) == 0u) {
                                                phi_502_ = array<f32, 2>(_e429.x, _e429.z);
                                            } else {
                                                phi_502_ = array<f32, 2>(_e429.y, _e429.w);
                                            }
                                            let _e439 = phi_502_;
                                            if ((_e423 % 4u) < 2u) {
                                                phi_510_ = _e439[0];
                                            } else {
                                                phi_510_ = _e439[1];
                                            }
                                            let _e445 = phi_510_;
                                            let _e447 = (_e400 + (2u * _e192));
                                            let _e453 = global_7.member[(((_e447 / 4u) * 4u) / 4u)];
                                            if ((_e447 % 2u) == 0u) {
                                                phi_529_ = array<f32, 2>(_e453.x, _e453.z);
                                            } else {
                                                phi_529_ = array<f32, 2>(_e453.y, _e453.w);
                                            }
                                            let _e463 = phi_529_;
                                            if ((_e447 % 4u) < 2u) {
                                                phi_537_ = _e463[0];
                                            } else {
                                                phi_537_ = _e463[1];
                                            }
                                            let _e469 = phi_537_;
                                            let _e471 = (_e400 + (3u * _e192));
                                            let _e477 = global_7.member[(((_e471 / 4u) * 4u) / 4u)];
                                            if ((_e471 % 2u) == 0u) {
                                                phi_556_ = array<f32, 2>(_e477.x, _e477.z);
                                            } else {
                                                phi_556_ = array<f32, 2>(_e477.y, _e477.w);
                                            }
                                            let _e487 = phi_556_;
                                            if ((_e471 % 4u) < 2u) {
                                                phi_564_ = _e487[0];
                                            } else {
                                                phi_564_ = _e487[1];
                                            }
                                            let _e493 = phi_564_;
                                            local_54 = type_18((_e397.member + _e422), (_e397.member_1 + _e445), (_e397.member_2 + _e469), (_e397.member_3 + _e493));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_451_ = _e398;
                                            let _e3005 = local_54;
                                            phi_454_ = _e3005;
                                        }
                                    }
                                    let _e504 = local_2;
                                    let _e507 = local_3;
                                    let _e510 = local_4;
                                    let _e513 = local_5;
                                    let _e3020 = local_55;
                                    phi_578_ = _e3020;
                                    phi_581_ = type_18(0f, 0f, 0f, 0f);
                                    loop {
                                        let _e516 = phi_578_;
                                        let _e518 = phi_581_;
                                        let _e519 = (_e516 + 1u);
                                        local_6 = _e518;
                                        local_7 = _e518;
                                        local_8 = _e518;
                                        local_9 = _e518;
                                        if (_e519 <= _e177) {
                                            let _e521 = (_e194 + _e516);
                                            let _e527 = global_7.member[(((_e521 / 4u) * 4u) / 4u)];
                                            if ((_e521 % 2u) == 0u) {
                                                phi_603_ = array<f32, 2>(_e527.x, _e527.z);
                                            } else {
                                                phi_603_ = array<f32, 2>(_e527.y, _e527.w);
                                            }
                                            let _e537 = phi_603_;
                                            if ((_e521 % 4u) < 2u) {
                                                phi_611_ = _e537[0];
                                            } else {
                                                phi_611_ = _e537[1];
                                            }
                                            let _e543 = phi_611_;
                                            let _e544 = (_e521 + _e192);
                                            let _e550 = global_7.member[(((_e544 / 4u) * 4u) / 4u)];
                                            if ((_e544 % 2u) == 0u) {
                                                phi_629_ = array<f32, 2>(_e550.x, _e550.z);
                                            } else {
                                                phi_629_ = array<f32, 2>(_e550.y, _e550.w);
                                            }
                                            let _e560 = phi_629_;
                                            if ((_e544 % 4u) < 2u) {
                                                phi_637_ = _e560[0];
                                            } else {
                                                phi_637_ = _e560[1];
                                            }
                                            let _e566 = phi_637_;
                                            let _e568 = (_e521 + (2u * _e192));
                                            let _e574 = global_7.member[(((_e568 / 4u) * 4u) / 4u)];
                                            if ((_e568 % 2u) == 0u) {
                                                phi_656_ = array<f32, 2>(_e574.x, _e574.z);
                                            } else {
                                                phi_656_ = array<f32, 2>(_e574.y, _e574.w);
                                            }
                                            let _e584 = phi_656_;
                                            if ((_e568 % 4u) < 2u) {
                                                phi_664_ = _e584[0];
                                            } else {
                                                phi_664_ = _e584[1];
                                            }
                                            let _e590 = phi_664_;
                                            let _e592 = (_e521 + (3u * _e192));
                                            let _e598 = global_7.member[(((_e592 / 4u) * 4u) / 4u)];
                                            if ((_e592 % 2u) == 0u) {
                                                phi_683_ = array<f32, 2>(_e598.x, _e598.z);
                                            } else {
                                                phi_683_ = array<f32, 2>(_e598.y, _e598.w);
                                            }
                                            let _e608 = phi_683_;
                                            if ((_e592 % 4u) < 2u) {
                                                phi_691_ = _e608[0];
                                            } else {
                                                phi_691_ = _e608[1];
                                            }
                                            let _e614 = phi_691_;
                                            local_56 = type_18((_e518.member + _e543), (_e518.member_1 + _e566), (_e518.member_2 + _e590), (_e518.member_3 + _e614));
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            phi_578_ = _e519;
                                            let _e3023 = local_56;
                                            phi_581_ = _e3023;
                                        }
                                    }
                                    let _e625 = local_6;
                                    let _e627 = (_e504.member + _e625.member);
                                    let _e629 = local_7;
                                    let _e631 = (_e507.member_1 + _e629.member_1);
                                    let _e633 = local_8;
                                    let _e635 = (_e510.member_2 + _e633.member_2);
                                    let _e637 = local_9;
                                    let _e639 = (_e513.member_3 + _e637.member_3);
                                    if _e187 {
                                        let _e644 = (4u * _e183);
                                        let _e645 = (4u * _e199);
                                        let _e646 = bitcast<u32>(_e627);
                                        let _e649 = ((_e646 >> bitcast<u32>(23i)) & 255u);
                                        if (_e649 == 0u) {
                                        } else {
                                            let _e652 = (_e649 % 16u);
                                            let _e654 = ((_e646 & 8388607u) | 8388608u);
                                            let _e657 = (_e654 << bitcast<u32>((_e652 & 31u)));
                                            let _e663 = ((_e654 >> bitcast<u32>(((31u - _e652) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e646 >> bitcast<u32>(31i)) == 0u) {
                                                phi_750_ = array<u32, 2>(_e657, _e663);
                                            } else {
                                                let _e669 = (~(_e657) + 1u);
                                                if (_e669 == 0u) {
                                                    phi_748_ = (~(_e663) + 1u);
                                                } else {
                                                    phi_748_ = ~(_e663);
                                                }
                                                let _e675 = phi_748_;
                                                phi_750_ = array<u32, 2>(_e669, _e675);
                                            }
                                            let _e678 = phi_750_;
                                            let _e679 = (_e649 < 255u);
                                            if _e679 {
                                                phi_756_ = _e678;
                                            } else {
                                                phi_756_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e682 = phi_756_;
                                            let _e687 = (2u * ((select(16u, (_e649 / 16u), _e679) * _e644) + _e645));
                                            let _e690 = atomicAdd((&global_8.member[_e687]), _e682[0]);
                                            let _e698 = atomicAdd((&global_8.member[(_e687 + 1u)]), (_e682[1] + select(0u, 1u, ((_e690 + _e682[0]) < _e682[0]))));
                                        }
                                        let _e700 = bitcast<u32>(_e631);
                                        let _e703 = ((_e700 >> bitcast<u32>(23i)) & 255u);
                                        if (_e703 == 0u) {
                                        } else {
                                            let _e706 = (_e703 % 16u);
                                            let _e708 = ((_e700 & 8388607u) | 8388608u);
                                            let _e711 = (_e708 << bitcast<u32>((_e706 & 31u)));
                                            let _e717 = ((_e708 >> bitcast<u32>(((31u - _e706) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e700 >> bitcast<u32>(31i)) == 0u) {
                                                phi_806_ = array<u32, 2>(_e711, _e717);
                                            } else {
                                                let _e723 = (~(_e711) + 1u);
                                                if (_e723 == 0u) {
                                                    phi_804_ = (~(_e717) + 1u);
                                                } else {
                                                    phi_804_ = ~(_e717);
                                                }
                                                let _e729 = phi_804_;
                                                phi_806_ = array<u32, 2>(_e723, _e729);
                                            }
                                            let _e732 = phi_806_;
                                            let _e733 = (_e703 < 255u);
                                            if _e733 {
                                                phi_812_ = _e732;
                                            } else {
                                                phi_812_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e736 = phi_812_;
                                            let _e741 = (2u * ((select(16u, (_e703 / 16u), _e733) * _e644) + (_e645 + 1u)));
                                            let _e744 = atomicAdd((&global_8.member[_e741]), _e736[0]);
                                            let _e752 = atomicAdd((&global_8.member[(_e741 + 1u)]), (_e736[1] + select(0u, 1u, ((_e744 + _e736[0]) < _e736[0]))));
                                        }
                                        let _e754 = bitcast<u32>(_e635);
                                        let _e757 = ((_e754 >> bitcast<u32>(23i)) & 255u);
                                        if (_e757 == 0u) {
                                        } else {
                                            let _e760 = (_e757 % 16u);
                                            let _e762 = ((_e754 & 8388607u) | 8388608u);
                                            let _e765 = (_e762 << bitcast<u32>((_e760 & 31u)));
                                            let _e771 = ((_e762 >> bitcast<u32>(((31u - _e760) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e754 >> bitcast<u32>(31i)) == 0u) {
                                                phi_862_ = array<u32, 2>(_e765, _e771);
                                            } else {
                                                let _e777 = (~(_e765) + 1u);
                                                if (_e777 == 0u) {
                                                    phi_860_ = (~(_e771) + 1u);
                                                } else {
                                                    phi_860_ = ~(_e771);
                                                }
                                                let _e783 = phi_860_;
                                                phi_862_ = array<u32, 2>(_e777, _e783);
                                            }
                                            let _e786 = phi_862_;
                                            let _e787 = (_e757 < 255u);
                                            if _e787 {
                                                phi_868_ = _e786;
                                            } else {
                                                phi_868_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e790 = phi_868_;
                                            let _e795 = (2u * ((select(16u, (_e757 / 16u), _e787) * _e644) + (_e645 + 2u)));
                                            let _e798 = atomicAdd((&global_8.member[_e795]), _e790[0]);
                                            let _e806 = atomicAdd((&global_8.member[(_e795 + 1u)]), (_e790[1] + select(0u, 1u, ((_e798 + _e790[0]) < _e790[0]))));
                                        }
                                        let _e808 = bitcast<u32>(_e639);
                                        let _e811 = ((_e808 >> bitcast<u32>(23i)) & 255u);
                                        if (_e811 == 0u) {
                                        } else {
                                            let _e814 = (_e811 % 16u);
                                            let _e816 = ((_e808 & 8388607u) | 8388608u);
                                            let _e819 = (_e816 << bitcast<u32>((_e814 & 31u)));
                                            let _e825 = ((_e816 >> bitcast<u32>(((31u - _e814) & 31u))) >> bitcast<u32>(1i));
                                            if ((_e808 >> bitcast<u32>(31i)) == 0u) {
                                                phi_918_ = array<u32, 2>(_e819, _e825);
                                            } else {
                                                let _e831 = (~(_e819) + 1u);
                                                if (_e831 == 0u) {
                                                    phi_916_ = (~(_e825) + 1u);
                                                } else {
                                                    phi_916_ = ~(_e825);
                                                }
                                                let _e837 = phi_916_;
                                                phi_918_ = array<u32, 2>(_e831, _e837);
                                            }
                                            let _e840 = phi_918_;
                                            let _e841 = (_e811 < 255u);
                                            if _e841 {
                                                phi_924_ = _e840;
                                            } else {
                                                phi_924_ = array<u32, 2>(1u, 0u);
                                            }
                                            let _e844 = phi_924_;
                                            let _e849 = (2u * ((select(16u, (_e811 / 16u), _e841) * _e644) + (_e645 + 3u)));
                                            let _e852 = atomicAdd((&global_8.member[_e849]), _e844[0]);
                                            let _e860 = atomicAdd((&global_8.member[(_e849 + 1u)]), (_e844[1] + select(0u, 1u, ((_e852 + _e844[0]) < _e844[0]))));
                                        }
                                    } else {
                                        global_6.member[(_e186 + _e199)] = vec4<f32>(_e627, _e631, _e635, _e639);
                                    }
                                }
                                phi_188_ = _e158;
                                phi_191_ = _e167;
                                phi_193_ = _e162;
                            }
                            let _e2942 = phi_188_;
                            let _e2944 = phi_191_;
                            let _e2946 = phi_193_;
                            local_44 = _e2942;
                            local_45 = _e2944;
                            local_47 = _e2946;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e2966 = local_44;
                            phi_187_ = _e2966;
                            let _e2969 = local_45;
                            phi_190_ = _e2969;
                            let _e2974 = local_47;
                            phi_192_ = _e2974;
                        }
                    }
                    let _e2948 = phi_3069_;
                    if _e2948 {
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
