struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
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
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_5;
@group(0) @binding(1) 
var<storage> global_5: type_11;
@group(0) @binding(0) 
var<uniform> global_6: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_82_: u32;
    var phi_85_: u32;
    var local: u32;
    var phi_112_: u32;
    var phi_115_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_148_: u32;
    var phi_158_: u32;
    var phi_204_: vec4<f32>;
    var phi_217_: u32;
    var phi_221_: u32;
    var phi_224_: type_19;
    var phi_253_: u32;
    var phi_256_: type_19;
    var phi_340_: u32;
    var phi_343_: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var local_6: type_19;
    var phi_375_: u32;
    var phi_378_: type_19;
    var local_7: type_19;
    var local_8: type_19;
    var local_9: type_19;
    var local_10: type_19;
    var phi_439_: vec4<f32>;
    var phi_450_: vec4<f32>;
    var phi_461_: vec4<f32>;
    var phi_472_: vec4<f32>;
    var phi_498_: u32;
    var phi_502_: type_19;
    var phi_505_: type_19;
    var phi_507_: type_19;
    var phi_509_: type_19;
    var phi_511_: u32;
    var phi_598_: u32;
    var phi_601_: type_19;
    var phi_603_: type_19;
    var phi_605_: type_19;
    var phi_607_: type_19;
    var phi_865_: type_19;
    var phi_868_: type_19;
    var phi_870_: type_19;
    var phi_872_: type_19;
    var phi_874_: u32;
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
    var local_22: type_19;
    var local_23: type_19;
    var local_24: type_19;
    var local_25: type_19;
    var local_26: type_19;
    var phi_970_: type_19;
    var phi_973_: type_19;
    var phi_975_: type_19;
    var phi_977_: type_19;
    var phi_979_: u32;
    var local_27: type_19;
    var local_28: type_19;
    var local_29: type_19;
    var local_30: type_19;
    var local_31: type_19;
    var local_32: type_19;
    var local_33: type_19;
    var local_34: type_19;
    var local_35: type_19;
    var local_36: type_19;
    var local_37: type_19;
    var local_38: type_19;
    var local_39: type_19;
    var local_40: type_19;
    var local_41: type_19;
    var local_42: type_19;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: type_19;
    var local_48: u32;
    var local_49: type_19;
    var local_50: type_19;
    var local_51: u32;
    var local_52: type_19;
    var local_53: type_19;
    var local_54: u32;
    var local_55: type_19;
    var local_56: type_19;
    var local_57: type_19;
    var local_58: type_19;
    var local_59: type_19;
    var local_60: u32;
    var local_61: type_19;
    var local_62: type_19;
    var local_63: type_19;
    var local_64: type_19;
    var local_65: type_19;
    var local_66: type_19;
    var local_67: type_19;
    var local_68: type_19;
    var local_69: type_19;
    var local_70: type_19;
    var local_71: type_19;
    var local_72: type_19;
    var local_73: type_19;
    var local_74: type_19;
    var local_75: type_19;
    var local_76: type_19;
    var local_77: u32;
    var local_78: type_19;
    var local_79: type_19;
    var local_80: type_19;
    var local_81: type_19;
    var local_82: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = global;
            let _e29 = global_1;
            let _e30 = global_2;
            let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
            let _e41 = global_6.member.member_4;
            let _e44 = global_6.member.member_3;
            let _e45 = (_e44 - 1u);
            let _e46 = (_e45 / 4u);
            let _e50 = global_6.member.member_1;
            let _e53 = global_6.member.member_7;
            let _e56 = global_6.member.member_8;
            phi_82_ = 0u;
            phi_85_ = _e53;
            loop {
                let _e58 = phi_82_;
                let _e60 = phi_85_;
                local = _e58;
                if ((_e58 + 1u) < _e60) {
                    let _e64 = ((_e58 + _e60) / 2u);
                    let _e68 = global_5.member[(2u * _e64)];
                    let _e69 = (_e68 <= _e50);
                    local_43 = select(_e58, _e64, _e69);
                    local_44 = select(_e64, _e60, _e69);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1229 = local_43;
                    phi_82_ = _e1229;
                    let _e1232 = local_44;
                    phi_85_ = _e1232;
                }
            }
            let _e73 = local;
            let _e74 = (2u * _e73);
            let _e78 = global_5.member[(_e74 + 1u)];
            let _e81 = global_5.member[_e74];
            if (_e56 == 0u) {
                break;
            }
            let _e87 = ((_e78 + ((_e50 - _e81) / _e56)) + _e29.z);
            phi_112_ = 0u;
            phi_115_ = _e53;
            loop {
                let _e89 = phi_112_;
                let _e91 = phi_115_;
                let _e92 = (_e89 + 1u);
                local_1 = _e89;
                local_2 = _e92;
                if (_e92 < _e91) {
                    let _e95 = ((_e89 + _e91) / 2u);
                    let _e100 = global_5.member[((2u * _e95) + 1u)];
                    let _e101 = (_e100 <= _e87);
                    local_45 = select(_e89, _e95, _e101);
                    local_46 = select(_e95, _e91, _e101);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1236 = local_45;
                    phi_112_ = _e1236;
                    let _e1239 = local_46;
                    phi_115_ = _e1239;
                }
            }
            let _e105 = local_1;
            let _e106 = (2u * _e105);
            let _e109 = global_5.member[_e106];
            let _e113 = global_5.member[(_e106 + 1u)];
            let _e116 = (_e109 + ((_e87 - _e113) * _e56));
            let _e117 = (_e116 + _e56);
            let _e119 = local_2;
            let _e123 = global_5.member[(2u * _e119)];
            let _e125 = select(_e123, _e117, (_e117 < _e123));
            if (_e116 > _e50) {
                phi_148_ = (_e116 - _e50);
            } else {
                phi_148_ = 0u;
            }
            let _e129 = phi_148_;
            if (_e125 > _e50) {
                let _e131 = (_e125 - _e50);
                let _e134 = global_6.member.member;
                phi_158_ = select(_e134, _e131, (_e131 < _e134));
            } else {
                phi_158_ = 0u;
            }
            let _e138 = phi_158_;
            if (_e38 < ((_e46 + 2u) * _e41)) {
                if (_e129 < _e138) {
                    let _e143 = (_e41 == 0u);
                    if _e143 {
                        break;
                    }
                    let _e144 = (_e38 / _e41);
                    if _e143 {
                        break;
                    }
                    let _e145 = (_e38 % _e41);
                    let _e148 = global_6.member.member_9;
                    if (_e148 == 0u) {
                        break;
                    }
                    let _e153 = global_6.member.member_10;
                    let _e155 = (((_e87 % _e148) * _e153) + _e145);
                    let _e157 = select(false, true, (_e116 < _e50));
                    let _e161 = global_6.member.member_2;
                    let _e162 = ((4u * _e145) * _e161);
                    if (_e144 < (_e46 + 1u)) {
                        let _e418 = (_e144 * 4u);
                        let _e421 = global_6.member.member_5;
                        let _e424 = ((_e155 + _e421) + (_e418 * _e41));
                        let _e425 = (_e45 - _e418);
                        let _e429 = (_e424 + (select(_e425, 1u, (1u < _e425)) * _e41));
                        let _e433 = (_e424 + (select(_e425, 2u, (2u < _e425)) * _e41));
                        let _e437 = (_e424 + (select(_e425, 3u, (3u < _e425)) * _e41));
                        if _e157 {
                            let _e440 = global_7.member[_e424];
                            phi_439_ = _e440;
                        } else {
                            phi_439_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e442 = phi_439_;
                        if _e157 {
                            let _e450 = global_7.member[_e429];
                            phi_450_ = _e450;
                        } else {
                            phi_450_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e452 = phi_450_;
                        if _e157 {
                            let _e460 = global_7.member[_e433];
                            phi_461_ = _e460;
                        } else {
                            phi_461_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e462 = phi_461_;
                        if _e157 {
                            let _e470 = global_7.member[_e437];
                            phi_472_ = _e470;
                        } else {
                            phi_472_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e472 = phi_472_;
                        let _e478 = (_e418 * _e161);
                        let _e479 = (_e418 + 1u);
                        let _e482 = (select(_e45, _e479, (_e479 < _e45)) * _e161);
                        let _e483 = (_e418 + 2u);
                        let _e486 = (select(_e45, _e483, (_e483 < _e45)) * _e161);
                        let _e487 = (_e418 + 3u);
                        let _e490 = (select(_e45, _e487, (_e487 < _e45)) * _e161);
                        let _e491 = (_e129 % 4u);
                        if (_e491 == 0u) {
                            phi_498_ = _e129;
                        } else {
                            phi_498_ = (_e129 + (4u - _e491));
                        }
                        let _e496 = phi_498_;
                        phi_502_ = type_19(_e472.x, _e472.y, _e472.z, _e472.w);
                        phi_505_ = type_19(_e462.x, _e462.y, _e462.z, _e462.w);
                        phi_507_ = type_19(_e452.x, _e452.y, _e452.z, _e452.w);
                        phi_509_ = type_19(_e442.x, _e442.y, _e442.z, _e442.w);
                        phi_511_ = _e129;
                        loop {
                            let _e500 = phi_502_;
                            let _e502 = phi_505_;
                            let _e504 = phi_507_;
                            let _e506 = phi_509_;
                            let _e508 = phi_511_;
                            let _e509 = (_e508 + 1u);
                            local_61 = _e500;
                            local_63 = _e502;
                            local_65 = _e504;
                            local_67 = _e506;
                            if (_e509 <= select(_e138, _e496, (_e496 < _e138))) {
                                let _e511 = (_e162 + _e508);
                                let _e514 = global_4.member[_e511];
                                let _e518 = global_4.member[(_e511 + _e161)];
                                let _e523 = global_4.member[(_e511 + (2u * _e161))];
                                let _e528 = global_4.member[(_e511 + (3u * _e161))];
                                let _e532 = global_3.member[(_e478 + _e508)];
                                let _e549 = global_3.member[(_e482 + _e508)];
                                let _e566 = global_3.member[(_e486 + _e508)];
                                let _e583 = global_3.member[(_e490 + _e508)];
                                local_56 = type_19(((_e583 * _e514) + _e500.member), ((_e583 * _e518) + _e500.member_1), ((_e583 * _e523) + _e500.member_2), ((_e583 * _e528) + _e500.member_3));
                                local_57 = type_19(((_e566 * _e514) + _e502.member), ((_e566 * _e518) + _e502.member_1), ((_e566 * _e523) + _e502.member_2), ((_e566 * _e528) + _e502.member_3));
                                local_58 = type_19(((_e549 * _e514) + _e504.member), ((_e549 * _e518) + _e504.member_1), ((_e549 * _e523) + _e504.member_2), ((_e549 * _e528) + _e504.member_3));
                                local_59 = type_19(((_e532 * _e514) + _e506.member), ((_e532 * _e518) + _e506.member_1), ((_e532 * _e523) + _e506.member_2), ((_e532 * _e528) + _e506.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1287 = local_56;
                                phi_502_ = _e1287;
                                let _e1290 = local_57;
                                phi_505_ = _e1290;
                                let _e1293 = local_58;
                                phi_507_ = _e1293;
                                let _e1296 = local_59;
                                phi_509_ = _e1296;
                                phi_511_ = _e509;
                            }
                        }
                        let _e602 = (_e161 / 4u);
                        phi_598_ = (_e496 / 4u);
                        let _e1303 = local_61;
                        phi_601_ = _e1303;
                        let _e1308 = local_63;
                        phi_603_ = _e1308;
                        let _e1313 = local_65;
                        phi_605_ = _e1313;
                        let _e1318 = local_67;
                        phi_607_ = _e1318;
                        loop {
                            let _e605 = phi_598_;
                            let _e607 = phi_601_;
                            let _e609 = phi_603_;
                            let _e611 = phi_605_;
                            let _e613 = phi_607_;
                            let _e614 = (4u * _e605);
                            local_69 = _e607;
                            local_71 = _e609;
                            local_73 = _e611;
                            local_75 = _e613;
                            local_77 = _e614;
                            if ((_e614 + 4u) <= _e138) {
                                let _e617 = ((_e162 / 4u) + _e605);
                                let _e618 = (4u * _e617);
                                let _e621 = global_4.member[_e618];
                                let _e625 = global_4.member[(_e618 + 1u)];
                                let _e629 = global_4.member[(_e618 + 2u)];
                                let _e633 = global_4.member[(_e618 + 3u)];
                                let _e635 = (4u * (_e617 + _e602));
                                let _e638 = global_4.member[_e635];
                                let _e642 = global_4.member[(_e635 + 1u)];
                                let _e646 = global_4.member[(_e635 + 2u)];
                                let _e650 = global_4.member[(_e635 + 3u)];
                                let _e653 = (4u * (_e617 + (2u * _e602)));
                                let _e656 = global_4.member[_e653];
                                let _e660 = global_4.member[(_e653 + 1u)];
                                let _e664 = global_4.member[(_e653 + 2u)];
                                let _e668 = global_4.member[(_e653 + 3u)];
                                let _e671 = (4u * (_e617 + (3u * _e602)));
                                let _e674 = global_4.member[_e671];
                                let _e678 = global_4.member[(_e671 + 1u)];
                                let _e682 = global_4.member[(_e671 + 2u)];
                                let _e686 = global_4.member[(_e671 + 3u)];
                                let _e688 = (4u * ((_e478 / 4u) + _e605));
                                let _e691 = global_3.member[_e688];
                                let _e695 = global_3.member[(_e688 + 1u)];
                                let _e699 = global_3.member[(_e688 + 2u)];
                                let _e703 = global_3.member[(_e688 + 3u)];
                                let _e705 = (4u * ((_e482 / 4u) + _e605));
                                let _e708 = global_3.member[_e705];
                                let _e712 = global_3.member[(_e705 + 1u)];
                                let _e716 = global_3.member[(_e705 + 2u)];
                                let _e720 = global_3.member[(_e705 + 3u)];
                                let _e722 = (4u * ((_e486 / 4u) + _e605));
                                let _e725 = global_3.member[_e722];
                                let _e729 = global_3.member[(_e722 + 1u)];
                                let _e733 = global_3.member[(_e722 + 2u)];
                                let _e737 = global_3.member[(_e722 + 3u)];
                                let _e739 = (4u * ((_e490 / 4u) + _e605));
                                let _e742 = global_3.member[_e739];
                                let _e746 = global_3.member[(_e739 + 1u)];
                                let _e750 = global_3.member[(_e739 + 2u)];
                                let _e754 = global_3.member[(_e739 + 3u)];
                                local_60 = (_e605 + 1u);
                                local_62 = type_19(((_e754 * _e633) + ((_e750 * _e629) + ((_e746 * _e625) + ((_e742 * _e621) + _e607.member)))), ((_e754 * _e650) + ((_e750 * _e646) + ((_e746 * _e642) + ((_e742 * _e638) + _e607.member_1)))), ((_e754 * _e668) + ((_e750 * _e664) + ((_e746 * _e660) + ((_e742 * _e656) + _e607.member_2)))), ((_e754 * _e686) + ((_e750 * _e682) + ((_e746 * _e678) + ((_e742 * _e674) + _e607.member_3)))));
                                local_64 = type_19(((_e737 * _e633) + ((_e733 * _e629) + ((_e729 * _e625) + ((_e725 * _e621) + _e609.member)))), ((_e737 * _e650) + ((_e733 * _e646) + ((_e729 * _e642) + ((_e725 * _e638) + _e609.member_1)))), ((_e737 * _e668) + ((_e733 * _e664) + ((_e729 * _e660) + ((_e725 * _e656) + _e609.member_2)))), ((_e737 * _e686) + ((_e733 * _e682) + ((_e729 * _e678) + ((_e725 * _e674) + _e609.member_3)))));
                                local_66 = type_19(((_e720 * _e633) + ((_e716 * _e629) + ((_e712 * _e625) + ((_e708 * _e621) + _e611.member)))), ((_e720 * _e650) + ((_e716 * _e646) + ((_e712 * _e642) + ((_e708 * _e638) + _e611.member_1)))), ((_e720 * _e668) + ((_e716 * _e664) + ((_e712 * _e660) + ((_e708 * _e656) + _e611.member_2)))), ((_e720 * _e686) + ((_e716 * _e682) + ((_e712 * _e678) + ((_e708 * _e674) + _e611.member_3)))));
                                local_68 = type_19(((_e703 * _e633) + ((_e699 * _e629) + ((_e695 * _e625) + ((_e691 * _e621) + _e613.member)))), ((_e703 * _e650) + ((_e699 * _e646) + ((_e695 * _e642) + ((_e691 * _e638) + _e613.member_1)))), ((_e703 * _e668) + ((_e699 * _e664) + ((_e695 * _e660) + ((_e691 * _e656) + _e613.member_2)))), ((_e703 * _e686) + ((_e699 * _e682) + ((_e695 * _e678) + ((_e691 * _e674) + _e613.member_3)))));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1300 = local_60;
                                phi_598_ = _e1300;
                                let _e1305 = local_62;
                                phi_601_ = _e1305;
                                let _e1310 = local_64;
                                phi_603_ = _e1310;
                                let _e1315 = local_66;
                                phi_605_ = _e1315;
                                let _e1320 = local_68;
                                phi_607_ = _e1320;
                            }
                        }
                        let _e1323 = local_69;
                        phi_865_ = _e1323;
                        let _e1328 = local_71;
                        phi_868_ = _e1328;
                        let _e1333 = local_73;
                        phi_870_ = _e1333;
                        let _e1338 = local_75;
                        phi_872_ = _e1338;
                        let _e1343 = local_77;
                        phi_874_ = _e1343;
                        loop {
                            let _e905 = phi_865_;
                            let _e907 = phi_868_;
                            let _e909 = phi_870_;
                            let _e911 = phi_872_;
                            let _e913 = phi_874_;
                            let _e914 = (_e913 + 1u);
                            local_11 = _e911;
                            local_12 = _e911;
                            local_13 = _e911;
                            local_14 = _e911;
                            local_15 = _e909;
                            local_16 = _e909;
                            local_17 = _e909;
                            local_18 = _e909;
                            local_19 = _e907;
                            local_20 = _e907;
                            local_21 = _e907;
                            local_22 = _e907;
                            local_23 = _e905;
                            local_24 = _e905;
                            local_25 = _e905;
                            local_26 = _e905;
                            local_82 = _e913;
                            if (_e914 <= _e138) {
                                let _e916 = (_e162 + _e913);
                                let _e919 = global_4.member[_e916];
                                let _e923 = global_4.member[(_e916 + _e161)];
                                let _e928 = global_4.member[(_e916 + (2u * _e161))];
                                let _e933 = global_4.member[(_e916 + (3u * _e161))];
                                let _e937 = global_3.member[(_e478 + _e913)];
                                let _e954 = global_3.member[(_e482 + _e913)];
                                let _e971 = global_3.member[(_e486 + _e913)];
                                let _e988 = global_3.member[(_e490 + _e913)];
                                local_70 = type_19(((_e988 * _e919) + _e905.member), ((_e988 * _e923) + _e905.member_1), ((_e988 * _e928) + _e905.member_2), ((_e988 * _e933) + _e905.member_3));
                                local_72 = type_19(((_e971 * _e919) + _e907.member), ((_e971 * _e923) + _e907.member_1), ((_e971 * _e928) + _e907.member_2), ((_e971 * _e933) + _e907.member_3));
                                local_74 = type_19(((_e954 * _e919) + _e909.member), ((_e954 * _e923) + _e909.member_1), ((_e954 * _e928) + _e909.member_2), ((_e954 * _e933) + _e909.member_3));
                                local_76 = type_19(((_e937 * _e919) + _e911.member), ((_e937 * _e923) + _e911.member_1), ((_e937 * _e928) + _e911.member_2), ((_e937 * _e933) + _e911.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1325 = local_70;
                                phi_865_ = _e1325;
                                let _e1330 = local_72;
                                phi_868_ = _e1330;
                                let _e1335 = local_74;
                                phi_870_ = _e1335;
                                let _e1340 = local_76;
                                phi_872_ = _e1340;
                                phi_874_ = _e914;
                            }
                        }
                        let _e1003 = local_11;
                        let _e1006 = local_12;
                        let _e1009 = local_13;
                        let _e1012 = local_14;
                        let _e1015 = local_15;
                        let _e1018 = local_16;
                        let _e1021 = local_17;
                        let _e1024 = local_18;
                        let _e1027 = local_19;
                        let _e1030 = local_20;
                        let _e1033 = local_21;
                        let _e1036 = local_22;
                        let _e1039 = local_23;
                        let _e1042 = local_24;
                        let _e1045 = local_25;
                        let _e1048 = local_26;
                        phi_970_ = type_19(0f, 0f, 0f, 0f);
                        phi_973_ = type_19(0f, 0f, 0f, 0f);
                        phi_975_ = type_19(0f, 0f, 0f, 0f);
                        phi_977_ = type_19(0f, 0f, 0f, 0f);
                        let _e1374 = local_82;
                        phi_979_ = _e1374;
                        loop {
                            let _e1051 = phi_970_;
                            let _e1053 = phi_973_;
                            let _e1055 = phi_975_;
                            let _e1057 = phi_977_;
                            let _e1059 = phi_979_;
                            let _e1060 = (_e1059 + 1u);
                            local_27 = _e1057;
                            local_28 = _e1057;
                            local_29 = _e1057;
                            local_30 = _e1057;
                            local_31 = _e1055;
                            local_32 = _e1055;
                            local_33 = _e1055;
                            local_34 = _e1055;
                            local_35 = _e1053;
                            local_36 = _e1053;
                            local_37 = _e1053;
                            local_38 = _e1053;
                            local_39 = _e1051;
                            local_40 = _e1051;
                            local_41 = _e1051;
                            local_42 = _e1051;
                            if (_e1060 <= _e138) {
                                let _e1062 = (_e162 + _e1059);
                                let _e1065 = global_4.member[_e1062];
                                let _e1069 = global_4.member[(_e1062 + _e161)];
                                let _e1074 = global_4.member[(_e1062 + (2u * _e161))];
                                let _e1079 = global_4.member[(_e1062 + (3u * _e161))];
                                let _e1083 = global_3.member[(_e478 + _e1059)];
                                let _e1100 = global_3.member[(_e482 + _e1059)];
                                let _e1117 = global_3.member[(_e486 + _e1059)];
                                let _e1134 = global_3.member[(_e490 + _e1059)];
                                local_78 = type_19(((_e1134 * _e1065) + _e1051.member), ((_e1134 * _e1069) + _e1051.member_1), ((_e1134 * _e1074) + _e1051.member_2), ((_e1134 * _e1079) + _e1051.member_3));
                                local_79 = type_19(((_e1117 * _e1065) + _e1053.member), ((_e1117 * _e1069) + _e1053.member_1), ((_e1117 * _e1074) + _e1053.member_2), ((_e1117 * _e1079) + _e1053.member_3));
                                local_80 = type_19(((_e1100 * _e1065) + _e1055.member), ((_e1100 * _e1069) + _e1055.member_1), ((_e1100 * _e1074) + _e1055.member_2), ((_e1100 * _e1079) + _e1055.member_3));
                                local_81 = type_19(((_e1083 * _e1065) + _e1057.member), ((_e1083 * _e1069) + _e1057.member_1), ((_e1083 * _e1074) + _e1057.member_2), ((_e1083 * _e1079) + _e1057.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1362 = local_78;
                                phi_970_ = _e1362;
                                let _e1365 = local_79;
                                phi_973_ = _e1365;
                                let _e1368 = local_80;
                                phi_975_ = _e1368;
                                let _e1371 = local_81;
                                phi_977_ = _e1371;
                                phi_979_ = _e1060;
                            }
                        }
                        let _e1149 = local_27;
                        let _e1153 = local_28;
                        let _e1157 = local_29;
                        let _e1161 = local_30;
                        global_7.member[_e424] = vec4<f32>((_e1003.member + _e1149.member), (_e1006.member_1 + _e1153.member_1), (_e1009.member_2 + _e1157.member_2), (_e1012.member_3 + _e1161.member_3));
                        if (_e479 < _e44) {
                            let _e1169 = local_31;
                            let _e1173 = local_32;
                            let _e1177 = local_33;
                            let _e1181 = local_34;
                            global_7.member[_e429] = vec4<f32>((_e1015.member + _e1169.member), (_e1018.member_1 + _e1173.member_1), (_e1021.member_2 + _e1177.member_2), (_e1024.member_3 + _e1181.member_3));
                        }
                        if (_e483 < _e44) {
                            let _e1189 = local_35;
                            let _e1193 = local_36;
                            let _e1197 = local_37;
                            let _e1201 = local_38;
                            global_7.member[_e433] = vec4<f32>((_e1027.member + _e1189.member), (_e1030.member_1 + _e1193.member_1), (_e1033.member_2 + _e1197.member_2), (_e1036.member_3 + _e1201.member_3));
                        }
                        if (_e487 < _e44) {
                            let _e1209 = local_39;
                            let _e1213 = local_40;
                            let _e1217 = local_41;
                            let _e1221 = local_42;
                            global_7.member[_e437] = vec4<f32>((_e1039.member + _e1209.member), (_e1042.member_1 + _e1213.member_1), (_e1045.member_2 + _e1217.member_2), (_e1048.member_3 + _e1221.member_3));
                        }
                    } else {
                        let _e166 = global_6.member.member_6;
                        let _e167 = (_e155 + _e166);
                        if _e157 {
                            let _e170 = global_7.member[_e167];
                            phi_204_ = _e170;
                        } else {
                            phi_204_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e172 = phi_204_;
                        let _e178 = (_e129 % 4u);
                        if (_e178 == 0u) {
                            phi_217_ = _e129;
                        } else {
                            phi_217_ = (_e129 + (4u - _e178));
                        }
                        let _e183 = phi_217_;
                        phi_221_ = _e129;
                        phi_224_ = type_19(_e172.x, _e172.y, _e172.z, _e172.w);
                        loop {
                            let _e187 = phi_221_;
                            let _e189 = phi_224_;
                            let _e190 = (_e187 + 1u);
                            local_49 = _e189;
                            if (_e190 <= select(_e138, _e183, (_e183 < _e138))) {
                                let _e192 = (_e162 + _e187);
                                let _e195 = global_4.member[_e192];
                                let _e199 = global_4.member[(_e192 + _e161)];
                                let _e204 = global_4.member[(_e192 + (2u * _e161))];
                                let _e209 = global_4.member[(_e192 + (3u * _e161))];
                                local_47 = type_19((_e189.member + _e195), (_e189.member_1 + _e199), (_e189.member_2 + _e204), (_e189.member_3 + _e209));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_221_ = _e190;
                                let _e1249 = local_47;
                                phi_224_ = _e1249;
                            }
                        }
                        phi_253_ = (_e183 / 4u);
                        let _e1255 = local_49;
                        phi_256_ = _e1255;
                        loop {
                            let _e221 = phi_253_;
                            let _e223 = phi_256_;
                            let _e224 = (4u * _e221);
                            local_51 = _e224;
                            local_52 = _e223;
                            if ((_e224 + 4u) <= _e138) {
                                let _e228 = ((_e162 / 4u) + _e221);
                                let _e229 = (_e161 / 4u);
                                let _e230 = (4u * _e228);
                                let _e233 = global_4.member[_e230];
                                let _e237 = global_4.member[(_e230 + 1u)];
                                let _e241 = global_4.member[(_e230 + 2u)];
                                let _e245 = global_4.member[(_e230 + 3u)];
                                let _e247 = (4u * (_e228 + _e229));
                                let _e250 = global_4.member[_e247];
                                let _e254 = global_4.member[(_e247 + 1u)];
                                let _e258 = global_4.member[(_e247 + 2u)];
                                let _e262 = global_4.member[(_e247 + 3u)];
                                let _e265 = (4u * (_e228 + (2u * _e229)));
                                let _e268 = global_4.member[_e265];
                                let _e272 = global_4.member[(_e265 + 1u)];
                                let _e276 = global_4.member[(_e265 + 2u)];
                                let _e280 = global_4.member[(_e265 + 3u)];
                                let _e283 = (4u * (_e228 + (3u * _e229)));
                                let _e286 = global_4.member[_e283];
                                let _e290 = global_4.member[(_e283 + 1u)];
                                let _e294 = global_4.member[(_e283 + 2u)];
                                let _e298 = global_4.member[(_e283 + 3u)];
                                local_48 = (_e221 + 1u);
                                local_50 = type_19(((((_e223.member + _e233) + _e237) + _e241) + _e245), ((((_e223.member_1 + _e250) + _e254) + _e258) + _e262), ((((_e223.member_2 + _e268) + _e272) + _e276) + _e280), ((((_e223.member_3 + _e286) + _e290) + _e294) + _e298));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1252 = local_48;
                                phi_253_ = _e1252;
                                let _e1257 = local_50;
                                phi_256_ = _e1257;
                            }
                        }
                        let _e1260 = local_51;
                        phi_340_ = _e1260;
                        let _e1263 = local_52;
                        phi_343_ = _e1263;
                        loop {
                            let _e322 = phi_340_;
                            let _e324 = phi_343_;
                            let _e325 = (_e322 + 1u);
                            local_3 = _e324;
                            local_4 = _e324;
                            local_5 = _e324;
                            local_6 = _e324;
                            local_54 = _e322;
                            if (_e325 <= _e138) {
                                let _e327 = (_e162 + _e322);
                                let _e330 = global_4.member[_e327];
                                let _e334 = global_4.member[(_e327 + _e161)];
                                let _e339 = global_4.member[(_e327 + (2u * _e161))];
                                let _e344 = global_4.member[(_e327 + (3u * _e161))];
                                local_53 = type_19((_e324.member + _e330), (_e324.member_1 + _e334), (_e324.member_2 + _e339), (_e324.member_3 + _e344));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_340_ = _e325;
                                let _e1265 = local_53;
                                phi_343_ = _e1265;
                            }
                        }
                        let _e355 = local_3;
                        let _e358 = local_4;
                        let _e361 = local_5;
                        let _e364 = local_6;
                        let _e1272 = local_54;
                        phi_375_ = _e1272;
                        phi_378_ = type_19(0f, 0f, 0f, 0f);
                        loop {
                            let _e367 = phi_375_;
                            let _e369 = phi_378_;
                            let _e370 = (_e367 + 1u);
                            local_7 = _e369;
                            local_8 = _e369;
                            local_9 = _e369;
                            local_10 = _e369;
                            if (_e370 <= _e138) {
                                let _e372 = (_e162 + _e367);
                                let _e375 = global_4.member[_e372];
                                let _e379 = global_4.member[(_e372 + _e161)];
                                let _e384 = global_4.member[(_e372 + (2u * _e161))];
                                let _e389 = global_4.member[(_e372 + (3u * _e161))];
                                local_55 = type_19((_e369.member + _e375), (_e369.member_1 + _e379), (_e369.member_2 + _e384), (_e369.member_3 + _e389));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_375_ = _e370;
                                let _e1275 = local_55;
                                phi_378_ = _e1275;
                            }
                        }
                        let _e400 = local_7;
                        let _e404 = local_8;
                        let _e408 = local_9;
                        let _e412 = local_10;
                        global_7.member[_e167] = vec4<f32>((_e355.member + _e400.member), (_e358.member_1 + _e404.member_1), (_e361.member_2 + _e408.member_2), (_e364.member_3 + _e412.member_3));
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
