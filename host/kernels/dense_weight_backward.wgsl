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
    var local_3: u32;
    var phi_253_: u32;
    var phi_256_: type_19;
    var phi_340_: u32;
    var phi_343_: type_19;
    var local_4: type_19;
    var local_5: type_19;
    var local_6: type_19;
    var local_7: type_19;
    var phi_375_: u32;
    var phi_378_: type_19;
    var local_8: type_19;
    var local_9: type_19;
    var local_10: type_19;
    var local_11: type_19;
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
    var local_12: u32;
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
    var local_27: type_19;
    var local_28: type_19;
    var phi_970_: type_19;
    var phi_973_: type_19;
    var phi_975_: type_19;
    var phi_977_: type_19;
    var phi_979_: u32;
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
    var local_43: type_19;
    var local_44: type_19;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: u32;
    var local_49: type_19;
    var local_50: u32;
    var local_51: type_19;
    var local_52: type_19;
    var local_53: u32;
    var local_54: type_19;
    var local_55: type_19;
    var local_56: u32;
    var local_57: type_19;
    var local_58: type_19;
    var local_59: type_19;
    var local_60: type_19;
    var local_61: type_19;
    var local_62: u32;
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
    var local_77: type_19;
    var local_78: type_19;
    var local_79: u32;
    var local_80: type_19;
    var local_81: type_19;
    var local_82: type_19;
    var local_83: type_19;
    var local_84: u32;

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
                    local_45 = select(_e58, _e64, _e69);
                    local_46 = select(_e64, _e60, _e69);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1233 = local_45;
                    phi_82_ = _e1233;
                    let _e1236 = local_46;
                    phi_85_ = _e1236;
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
                    local_47 = select(_e89, _e95, _e101);
                    local_48 = select(_e95, _e91, _e101);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1240 = local_47;
                    phi_112_ = _e1240;
                    let _e1243 = local_48;
                    phi_115_ = _e1243;
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
                        let _e420 = (_e144 * 4u);
                        let _e423 = global_6.member.member_5;
                        let _e426 = ((_e155 + _e423) + (_e420 * _e41));
                        let _e427 = (_e45 - _e420);
                        let _e431 = (_e426 + (select(_e427, 1u, (1u < _e427)) * _e41));
                        let _e435 = (_e426 + (select(_e427, 2u, (2u < _e427)) * _e41));
                        let _e439 = (_e426 + (select(_e427, 3u, (3u < _e427)) * _e41));
                        if _e157 {
                            let _e442 = global_7.member[_e426];
                            phi_439_ = _e442;
                        } else {
                            phi_439_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e444 = phi_439_;
                        if _e157 {
                            let _e452 = global_7.member[_e431];
                            phi_450_ = _e452;
                        } else {
                            phi_450_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e454 = phi_450_;
                        if _e157 {
                            let _e462 = global_7.member[_e435];
                            phi_461_ = _e462;
                        } else {
                            phi_461_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e464 = phi_461_;
                        if _e157 {
                            let _e472 = global_7.member[_e439];
                            phi_472_ = _e472;
                        } else {
                            phi_472_ = vec4<f32>(0f, 0f, 0f, 0f);
                        }
                        let _e474 = phi_472_;
                        let _e480 = (_e420 * _e161);
                        let _e481 = (_e420 + 1u);
                        let _e484 = (select(_e45, _e481, (_e481 < _e45)) * _e161);
                        let _e485 = (_e420 + 2u);
                        let _e488 = (select(_e45, _e485, (_e485 < _e45)) * _e161);
                        let _e489 = (_e420 + 3u);
                        let _e492 = (select(_e45, _e489, (_e489 < _e45)) * _e161);
                        let _e493 = (_e129 % 4u);
                        if (_e493 == 0u) {
                            phi_498_ = _e129;
                        } else {
                            phi_498_ = (_e129 + (4u - _e493));
                        }
                        let _e498 = phi_498_;
                        phi_502_ = type_19(_e474.x, _e474.y, _e474.z, _e474.w);
                        phi_505_ = type_19(_e464.x, _e464.y, _e464.z, _e464.w);
                        phi_507_ = type_19(_e454.x, _e454.y, _e454.z, _e454.w);
                        phi_509_ = type_19(_e444.x, _e444.y, _e444.z, _e444.w);
                        phi_511_ = _e129;
                        loop {
                            let _e502 = phi_502_;
                            let _e504 = phi_505_;
                            let _e506 = phi_507_;
                            let _e508 = phi_509_;
                            let _e510 = phi_511_;
                            let _e511 = (_e510 + 1u);
                            local_12 = _e510;
                            local_63 = _e502;
                            local_65 = _e504;
                            local_67 = _e506;
                            local_69 = _e508;
                            if (_e511 <= select(_e138, _e498, (_e498 < _e138))) {
                                let _e513 = (_e162 + _e510);
                                let _e516 = global_4.member[_e513];
                                let _e520 = global_4.member[(_e513 + _e161)];
                                let _e525 = global_4.member[(_e513 + (2u * _e161))];
                                let _e530 = global_4.member[(_e513 + (3u * _e161))];
                                let _e534 = global_3.member[(_e480 + _e510)];
                                let _e551 = global_3.member[(_e484 + _e510)];
                                let _e568 = global_3.member[(_e488 + _e510)];
                                let _e585 = global_3.member[(_e492 + _e510)];
                                local_58 = type_19(((_e585 * _e516) + _e502.member), ((_e585 * _e520) + _e502.member_1), ((_e585 * _e525) + _e502.member_2), ((_e585 * _e530) + _e502.member_3));
                                local_59 = type_19(((_e568 * _e516) + _e504.member), ((_e568 * _e520) + _e504.member_1), ((_e568 * _e525) + _e504.member_2), ((_e568 * _e530) + _e504.member_3));
                                local_60 = type_19(((_e551 * _e516) + _e506.member), ((_e551 * _e520) + _e506.member_1), ((_e551 * _e525) + _e506.member_2), ((_e551 * _e530) + _e506.member_3));
                                local_61 = type_19(((_e534 * _e516) + _e508.member), ((_e534 * _e520) + _e508.member_1), ((_e534 * _e525) + _e508.member_2), ((_e534 * _e530) + _e508.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1292 = local_58;
                                phi_502_ = _e1292;
                                let _e1295 = local_59;
                                phi_505_ = _e1295;
                                let _e1298 = local_60;
                                phi_507_ = _e1298;
                                let _e1301 = local_61;
                                phi_509_ = _e1301;
                                phi_511_ = _e511;
                            }
                        }
                        let _e604 = (_e161 / 4u);
                        let _e606 = local_12;
                        phi_598_ = (_e606 / 4u);
                        let _e1309 = local_63;
                        phi_601_ = _e1309;
                        let _e1314 = local_65;
                        phi_603_ = _e1314;
                        let _e1319 = local_67;
                        phi_605_ = _e1319;
                        let _e1324 = local_69;
                        phi_607_ = _e1324;
                        loop {
                            let _e609 = phi_598_;
                            let _e611 = phi_601_;
                            let _e613 = phi_603_;
                            let _e615 = phi_605_;
                            let _e617 = phi_607_;
                            let _e618 = (4u * _e609);
                            local_71 = _e611;
                            local_73 = _e613;
                            local_75 = _e615;
                            local_77 = _e617;
                            local_79 = _e618;
                            if ((_e618 + 4u) <= _e138) {
                                let _e621 = ((_e162 / 4u) + _e609);
                                let _e622 = (4u * _e621);
                                let _e625 = global_4.member[_e622];
                                let _e629 = global_4.member[(_e622 + 1u)];
                                let _e633 = global_4.member[(_e622 + 2u)];
                                let _e637 = global_4.member[(_e622 + 3u)];
                                let _e639 = (4u * (_e621 + _e604));
                                let _e642 = global_4.member[_e639];
                                let _e646 = global_4.member[(_e639 + 1u)];
                                let _e650 = global_4.member[(_e639 + 2u)];
                                let _e654 = global_4.member[(_e639 + 3u)];
                                let _e657 = (4u * (_e621 + (2u * _e604)));
                                let _e660 = global_4.member[_e657];
                                let _e664 = global_4.member[(_e657 + 1u)];
                                let _e668 = global_4.member[(_e657 + 2u)];
                                let _e672 = global_4.member[(_e657 + 3u)];
                                let _e675 = (4u * (_e621 + (3u * _e604)));
                                let _e678 = global_4.member[_e675];
                                let _e682 = global_4.member[(_e675 + 1u)];
                                let _e686 = global_4.member[(_e675 + 2u)];
                                let _e690 = global_4.member[(_e675 + 3u)];
                                let _e692 = (4u * ((_e480 / 4u) + _e609));
                                let _e695 = global_3.member[_e692];
                                let _e699 = global_3.member[(_e692 + 1u)];
                                let _e703 = global_3.member[(_e692 + 2u)];
                                let _e707 = global_3.member[(_e692 + 3u)];
                                let _e709 = (4u * ((_e484 / 4u) + _e609));
                                let _e712 = global_3.member[_e709];
                                let _e716 = global_3.member[(_e709 + 1u)];
                                let _e720 = global_3.member[(_e709 + 2u)];
                                let _e724 = global_3.member[(_e709 + 3u)];
                                let _e726 = (4u * ((_e488 / 4u) + _e609));
                                let _e729 = global_3.member[_e726];
                                let _e733 = global_3.member[(_e726 + 1u)];
                                let _e737 = global_3.member[(_e726 + 2u)];
                                let _e741 = global_3.member[(_e726 + 3u)];
                                let _e743 = (4u * ((_e492 / 4u) + _e609));
                                let _e746 = global_3.member[_e743];
                                let _e750 = global_3.member[(_e743 + 1u)];
                                let _e754 = global_3.member[(_e743 + 2u)];
                                let _e758 = global_3.member[(_e743 + 3u)];
                                local_62 = (_e609 + 1u);
                                local_64 = type_19(((_e758 * _e637) + ((_e754 * _e633) + ((_e750 * _e629) + ((_e746 * _e625) + _e611.member)))), ((_e758 * _e654) + ((_e754 * _e650) + ((_e750 * _e646) + ((_e746 * _e642) + _e611.member_1)))), ((_e758 * _e672) + ((_e754 * _e668) + ((_e750 * _e664) + ((_e746 * _e660) + _e611.member_2)))), ((_e758 * _e690) + ((_e754 * _e686) + ((_e750 * _e682) + ((_e746 * _e678) + _e611.member_3)))));
                                local_66 = type_19(((_e741 * _e637) + ((_e737 * _e633) + ((_e733 * _e629) + ((_e729 * _e625) + _e613.member)))), ((_e741 * _e654) + ((_e737 * _e650) + ((_e733 * _e646) + ((_e729 * _e642) + _e613.member_1)))), ((_e741 * _e672) + ((_e737 * _e668) + ((_e733 * _e664) + ((_e729 * _e660) + _e613.member_2)))), ((_e741 * _e690) + ((_e737 * _e686) + ((_e733 * _e682) + ((_e729 * _e678) + _e613.member_3)))));
                                local_68 = type_19(((_e724 * _e637) + ((_e720 * _e633) + ((_e716 * _e629) + ((_e712 * _e625) + _e615.member)))), ((_e724 * _e654) + ((_e720 * _e650) + ((_e716 * _e646) + ((_e712 * _e642) + _e615.member_1)))), ((_e724 * _e672) + ((_e720 * _e668) + ((_e716 * _e664) + ((_e712 * _e660) + _e615.member_2)))), ((_e724 * _e690) + ((_e720 * _e686) + ((_e716 * _e682) + ((_e712 * _e678) + _e615.member_3)))));
                                local_70 = type_19(((_e707 * _e637) + ((_e703 * _e633) + ((_e699 * _e629) + ((_e695 * _e625) + _e617.member)))), ((_e707 * _e654) + ((_e703 * _e650) + ((_e699 * _e646) + ((_e695 * _e642) + _e617.member_1)))), ((_e707 * _e672) + ((_e703 * _e668) + ((_e699 * _e664) + ((_e695 * _e660) + _e617.member_2)))), ((_e707 * _e690) + ((_e703 * _e686) + ((_e699 * _e682) + ((_e695 * _e678) + _e617.member_3)))));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1306 = local_62;
                                phi_598_ = _e1306;
                                let _e1311 = local_64;
                                phi_601_ = _e1311;
                                let _e1316 = local_66;
                                phi_603_ = _e1316;
                                let _e1321 = local_68;
                                phi_605_ = _e1321;
                                let _e1326 = local_70;
                                phi_607_ = _e1326;
                            }
                        }
                        let _e1329 = local_71;
                        phi_865_ = _e1329;
                        let _e1334 = local_73;
                        phi_868_ = _e1334;
                        let _e1339 = local_75;
                        phi_870_ = _e1339;
                        let _e1344 = local_77;
                        phi_872_ = _e1344;
                        let _e1349 = local_79;
                        phi_874_ = _e1349;
                        loop {
                            let _e909 = phi_865_;
                            let _e911 = phi_868_;
                            let _e913 = phi_870_;
                            let _e915 = phi_872_;
                            let _e917 = phi_874_;
                            let _e918 = (_e917 + 1u);
                            local_13 = _e915;
                            local_14 = _e915;
                            local_15 = _e915;
                            local_16 = _e915;
                            local_17 = _e913;
                            local_18 = _e913;
                            local_19 = _e913;
                            local_20 = _e913;
                            local_21 = _e911;
                            local_22 = _e911;
                            local_23 = _e911;
                            local_24 = _e911;
                            local_25 = _e909;
                            local_26 = _e909;
                            local_27 = _e909;
                            local_28 = _e909;
                            local_84 = _e917;
                            if (_e918 <= _e138) {
                                let _e920 = (_e162 + _e917);
                                let _e923 = global_4.member[_e920];
                                let _e927 = global_4.member[(_e920 + _e161)];
                                let _e932 = global_4.member[(_e920 + (2u * _e161))];
                                let _e937 = global_4.member[(_e920 + (3u * _e161))];
                                let _e941 = global_3.member[(_e480 + _e917)];
                                let _e958 = global_3.member[(_e484 + _e917)];
                                let _e975 = global_3.member[(_e488 + _e917)];
                                let _e992 = global_3.member[(_e492 + _e917)];
                                local_72 = type_19(((_e992 * _e923) + _e909.member), ((_e992 * _e927) + _e909.member_1), ((_e992 * _e932) + _e909.member_2), ((_e992 * _e937) + _e909.member_3));
                                local_74 = type_19(((_e975 * _e923) + _e911.member), ((_e975 * _e927) + _e911.member_1), ((_e975 * _e932) + _e911.member_2), ((_e975 * _e937) + _e911.member_3));
                                local_76 = type_19(((_e958 * _e923) + _e913.member), ((_e958 * _e927) + _e913.member_1), ((_e958 * _e932) + _e913.member_2), ((_e958 * _e937) + _e913.member_3));
                                local_78 = type_19(((_e941 * _e923) + _e915.member), ((_e941 * _e927) + _e915.member_1), ((_e941 * _e932) + _e915.member_2), ((_e941 * _e937) + _e915.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1331 = local_72;
                                phi_865_ = _e1331;
                                let _e1336 = local_74;
                                phi_868_ = _e1336;
                                let _e1341 = local_76;
                                phi_870_ = _e1341;
                                let _e1346 = local_78;
                                phi_872_ = _e1346;
                                phi_874_ = _e918;
                            }
                        }
                        let _e1007 = local_13;
                        let _e1010 = local_14;
                        let _e1013 = local_15;
                        let _e1016 = local_16;
                        let _e1019 = local_17;
                        let _e1022 = local_18;
                        let _e1025 = local_19;
                        let _e1028 = local_20;
                        let _e1031 = local_21;
                        let _e1034 = local_22;
                        let _e1037 = local_23;
                        let _e1040 = local_24;
                        let _e1043 = local_25;
                        let _e1046 = local_26;
                        let _e1049 = local_27;
                        let _e1052 = local_28;
                        phi_970_ = type_19(0f, 0f, 0f, 0f);
                        phi_973_ = type_19(0f, 0f, 0f, 0f);
                        phi_975_ = type_19(0f, 0f, 0f, 0f);
                        phi_977_ = type_19(0f, 0f, 0f, 0f);
                        let _e1380 = local_84;
                        phi_979_ = _e1380;
                        loop {
                            let _e1055 = phi_970_;
                            let _e1057 = phi_973_;
                            let _e1059 = phi_975_;
                            let _e1061 = phi_977_;
                            let _e1063 = phi_979_;
                            let _e1064 = (_e1063 + 1u);
                            local_29 = _e1061;
                            local_30 = _e1061;
                            local_31 = _e1061;
                            local_32 = _e1061;
                            local_33 = _e1059;
                            local_34 = _e1059;
                            local_35 = _e1059;
                            local_36 = _e1059;
                            local_37 = _e1057;
                            local_38 = _e1057;
                            local_39 = _e1057;
                            local_40 = _e1057;
                            local_41 = _e1055;
                            local_42 = _e1055;
                            local_43 = _e1055;
                            local_44 = _e1055;
                            if (_e1064 <= _e138) {
                                let _e1066 = (_e162 + _e1063);
                                let _e1069 = global_4.member[_e1066];
                                let _e1073 = global_4.member[(_e1066 + _e161)];
                                let _e1078 = global_4.member[(_e1066 + (2u * _e161))];
                                let _e1083 = global_4.member[(_e1066 + (3u * _e161))];
                                let _e1087 = global_3.member[(_e480 + _e1063)];
                                let _e1104 = global_3.member[(_e484 + _e1063)];
                                let _e1121 = global_3.member[(_e488 + _e1063)];
                                let _e1138 = global_3.member[(_e492 + _e1063)];
                                local_80 = type_19(((_e1138 * _e1069) + _e1055.member), ((_e1138 * _e1073) + _e1055.member_1), ((_e1138 * _e1078) + _e1055.member_2), ((_e1138 * _e1083) + _e1055.member_3));
                                local_81 = type_19(((_e1121 * _e1069) + _e1057.member), ((_e1121 * _e1073) + _e1057.member_1), ((_e1121 * _e1078) + _e1057.member_2), ((_e1121 * _e1083) + _e1057.member_3));
                                local_82 = type_19(((_e1104 * _e1069) + _e1059.member), ((_e1104 * _e1073) + _e1059.member_1), ((_e1104 * _e1078) + _e1059.member_2), ((_e1104 * _e1083) + _e1059.member_3));
                                local_83 = type_19(((_e1087 * _e1069) + _e1061.member), ((_e1087 * _e1073) + _e1061.member_1), ((_e1087 * _e1078) + _e1061.member_2), ((_e1087 * _e1083) + _e1061.member_3));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1368 = local_80;
                                phi_970_ = _e1368;
                                let _e1371 = local_81;
                                phi_973_ = _e1371;
                                let _e1374 = local_82;
                                phi_975_ = _e1374;
                                let _e1377 = local_83;
                                phi_977_ = _e1377;
                                phi_979_ = _e1064;
                            }
                        }
                        let _e1153 = local_29;
                        let _e1157 = local_30;
                        let _e1161 = local_31;
                        let _e1165 = local_32;
                        global_7.member[_e426] = vec4<f32>((_e1007.member + _e1153.member), (_e1010.member_1 + _e1157.member_1), (_e1013.member_2 + _e1161.member_2), (_e1016.member_3 + _e1165.member_3));
                        if (_e481 < _e44) {
                            let _e1173 = local_33;
                            let _e1177 = local_34;
                            let _e1181 = local_35;
                            let _e1185 = local_36;
                            global_7.member[_e431] = vec4<f32>((_e1019.member + _e1173.member), (_e1022.member_1 + _e1177.member_1), (_e1025.member_2 + _e1181.member_2), (_e1028.member_3 + _e1185.member_3));
                        }
                        if (_e485 < _e44) {
                            let _e1193 = local_37;
                            let _e1197 = local_38;
                            let _e1201 = local_39;
                            let _e1205 = local_40;
                            global_7.member[_e435] = vec4<f32>((_e1031.member + _e1193.member), (_e1034.member_1 + _e1197.member_1), (_e1037.member_2 + _e1201.member_2), (_e1040.member_3 + _e1205.member_3));
                        }
                        if (_e489 < _e44) {
                            let _e1213 = local_41;
                            let _e1217 = local_42;
                            let _e1221 = local_43;
                            let _e1225 = local_44;
                            global_7.member[_e439] = vec4<f32>((_e1043.member + _e1213.member), (_e1046.member_1 + _e1217.member_1), (_e1049.member_2 + _e1221.member_2), (_e1052.member_3 + _e1225.member_3));
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
                            local_3 = _e187;
                            local_51 = _e189;
                            if (_e190 <= select(_e138, _e183, (_e183 < _e138))) {
                                let _e192 = (_e162 + _e187);
                                let _e195 = global_4.member[_e192];
                                let _e199 = global_4.member[(_e192 + _e161)];
                                let _e204 = global_4.member[(_e192 + (2u * _e161))];
                                let _e209 = global_4.member[(_e192 + (3u * _e161))];
                                local_49 = type_19((_e189.member + _e195), (_e189.member_1 + _e199), (_e189.member_2 + _e204), (_e189.member_3 + _e209));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_221_ = _e190;
                                let _e1253 = local_49;
                                phi_224_ = _e1253;
                            }
                        }
                        let _e220 = local_3;
                        phi_253_ = (_e220 / 4u);
                        let _e1260 = local_51;
                        phi_256_ = _e1260;
                        loop {
                            let _e223 = phi_253_;
                            let _e225 = phi_256_;
                            let _e226 = (4u * _e223);
                            local_53 = _e226;
                            local_54 = _e225;
                            if ((_e226 + 4u) <= _e138) {
                                let _e230 = ((_e162 / 4u) + _e223);
                                let _e231 = (_e161 / 4u);
                                let _e232 = (4u * _e230);
                                let _e235 = global_4.member[_e232];
                                let _e239 = global_4.member[(_e232 + 1u)];
                                let _e243 = global_4.member[(_e232 + 2u)];
                                let _e247 = global_4.member[(_e232 + 3u)];
                                let _e249 = (4u * (_e230 + _e231));
                                let _e252 = global_4.member[_e249];
                                let _e256 = global_4.member[(_e249 + 1u)];
                                let _e260 = global_4.member[(_e249 + 2u)];
                                let _e264 = global_4.member[(_e249 + 3u)];
                                let _e267 = (4u * (_e230 + (2u * _e231)));
                                let _e270 = global_4.member[_e267];
                                let _e274 = global_4.member[(_e267 + 1u)];
                                let _e278 = global_4.member[(_e267 + 2u)];
                                let _e282 = global_4.member[(_e267 + 3u)];
                                let _e285 = (4u * (_e230 + (3u * _e231)));
                                let _e288 = global_4.member[_e285];
                                let _e292 = global_4.member[(_e285 + 1u)];
                                let _e296 = global_4.member[(_e285 + 2u)];
                                let _e300 = global_4.member[(_e285 + 3u)];
                                local_50 = (_e223 + 1u);
                                local_52 = type_19(((((_e225.member + _e235) + _e239) + _e243) + _e247), ((((_e225.member_1 + _e252) + _e256) + _e260) + _e264), ((((_e225.member_2 + _e270) + _e274) + _e278) + _e282), ((((_e225.member_3 + _e288) + _e292) + _e296) + _e300));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1257 = local_50;
                                phi_253_ = _e1257;
                                let _e1262 = local_52;
                                phi_256_ = _e1262;
                            }
                        }
                        let _e1265 = local_53;
                        phi_340_ = _e1265;
                        let _e1268 = local_54;
                        phi_343_ = _e1268;
                        loop {
                            let _e324 = phi_340_;
                            let _e326 = phi_343_;
                            let _e327 = (_e324 + 1u);
                            local_4 = _e326;
                            local_5 = _e326;
                            local_6 = _e326;
                            local_7 = _e326;
                            local_56 = _e324;
                            if (_e327 <= _e138) {
                                let _e329 = (_e162 + _e324);
                                let _e332 = global_4.member[_e329];
                                let _e336 = global_4.member[(_e329 + _e161)];
                                let _e341 = global_4.member[(_e329 + (2u * _e161))];
                                let _e346 = global_4.member[(_e329 + (3u * _e161))];
                                local_55 = type_19((_e326.member + _e332), (_e326.member_1 + _e336), (_e326.member_2 + _e341), (_e326.member_3 + _e346));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_340_ = _e327;
                                let _e1270 = local_55;
                                phi_343_ = _e1270;
                            }
                        }
                        let _e357 = local_4;
                        let _e360 = local_5;
                        let _e363 = local_6;
                        let _e366 = local_7;
                        let _e1277 = local_56;
                        phi_375_ = _e1277;
                        phi_378_ = type_19(0f, 0f, 0f, 0f);
                        loop {
                            let _e369 = phi_375_;
                            let _e371 = phi_378_;
                            let _e372 = (_e369 + 1u);
                            local_8 = _e371;
                            local_9 = _e371;
                            local_10 = _e371;
                            local_11 = _e371;
                            if (_e372 <= _e138) {
                                let _e374 = (_e162 + _e369);
                                let _e377 = global_4.member[_e374];
                                let _e381 = global_4.member[(_e374 + _e161)];
                                let _e386 = global_4.member[(_e374 + (2u * _e161))];
                                let _e391 = global_4.member[(_e374 + (3u * _e161))];
                                local_57 = type_19((_e371.member + _e377), (_e371.member_1 + _e381), (_e371.member_2 + _e386), (_e371.member_3 + _e391));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_375_ = _e372;
                                let _e1280 = local_57;
                                phi_378_ = _e1280;
                            }
                        }
                        let _e402 = local_8;
                        let _e406 = local_9;
                        let _e410 = local_10;
                        let _e414 = local_11;
                        global_7.member[_e167] = vec4<f32>((_e357.member + _e402.member), (_e360.member_1 + _e406.member_1), (_e363.member_2 + _e410.member_2), (_e366.member_3 + _e414.member_3));
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
