struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_15 {
    member: type_14,
    member_1: type_14,
    member_2: type_14,
    member_3: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_12;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_12;

fn function_() {
    var phi_114_: u32;
    var phi_117_: u32;
    var phi_119_: u32;
    var phi_121_: type_15;
    var phi_123_: type_15;
    var phi_125_: type_15;
    var phi_127_: type_15;
    var local: type_15;
    var local_1: type_15;
    var local_2: type_15;
    var local_3: type_15;
    var local_4: type_15;
    var local_5: type_15;
    var local_6: type_15;
    var local_7: type_15;
    var local_8: type_15;
    var local_9: type_15;
    var local_10: type_15;
    var local_11: type_15;
    var local_12: type_15;
    var local_13: type_15;
    var local_14: type_15;
    var local_15: type_15;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: type_15;
    var local_20: type_15;
    var local_21: type_15;
    var local_22: type_15;

    let _e18 = global;
    let _e19 = global_1;
    let _e20 = global_2;
    let _e29 = ((((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x) * 4u);
    let _e32 = global_3.member.member;
    if (_e29 < _e32) {
        let _e35 = (_e19.z * 4u);
        let _e38 = global_3.member.member_5;
        let _e39 = (_e38 + _e35);
        let _e42 = global_4.member[_e39];
        let _e55 = global_4.member[(_e39 + 1u)];
        let _e68 = global_4.member[(_e39 + 2u)];
        let _e81 = global_4.member[(_e39 + 3u)];
        let _e93 = global_3.member.member_4;
        phi_114_ = 0u;
        phi_117_ = _e29;
        phi_119_ = (_e93 + _e35);
        phi_121_ = type_15(type_14(_e81.x, _e81.x, _e81.x, _e81.x), type_14(_e81.y, _e81.y, _e81.y, _e81.y), type_14(_e81.z, _e81.z, _e81.z, _e81.z), type_14(_e81.w, _e81.w, _e81.w, _e81.w));
        phi_123_ = type_15(type_14(_e68.x, _e68.x, _e68.x, _e68.x), type_14(_e68.y, _e68.y, _e68.y, _e68.y), type_14(_e68.z, _e68.z, _e68.z, _e68.z), type_14(_e68.w, _e68.w, _e68.w, _e68.w));
        phi_125_ = type_15(type_14(_e55.x, _e55.x, _e55.x, _e55.x), type_14(_e55.y, _e55.y, _e55.y, _e55.y), type_14(_e55.z, _e55.z, _e55.z, _e55.z), type_14(_e55.w, _e55.w, _e55.w, _e55.w));
        phi_127_ = type_15(type_14(_e42.x, _e42.x, _e42.x, _e42.x), type_14(_e42.y, _e42.y, _e42.y, _e42.y), type_14(_e42.z, _e42.z, _e42.z, _e42.z), type_14(_e42.w, _e42.w, _e42.w, _e42.w));
        loop {
            let _e96 = phi_114_;
            let _e98 = phi_117_;
            let _e100 = phi_119_;
            let _e102 = phi_121_;
            let _e104 = phi_123_;
            let _e106 = phi_125_;
            let _e108 = phi_127_;
            let _e111 = global_3.member.member_2;
            local = _e108;
            local_1 = _e108;
            local_2 = _e108;
            local_3 = _e108;
            local_4 = _e106;
            local_5 = _e106;
            local_6 = _e106;
            local_7 = _e106;
            local_8 = _e104;
            local_9 = _e104;
            local_10 = _e104;
            local_11 = _e104;
            local_12 = _e102;
            local_13 = _e102;
            local_14 = _e102;
            local_15 = _e102;
            if (_e96 < _e111) {
                let _e116 = global_5.member[(_e98 / 4u)];
                let _e123 = global_4.member[_e100];
                let _e188 = global_4.member[(_e100 + 1u)];
                let _e253 = global_4.member[(_e100 + 2u)];
                let _e318 = global_4.member[(_e100 + 3u)];
                let _e382 = global_3.member.member_3;
                let _e386 = global_3.member.member_1;
                local_16 = (_e96 + 1u);
                local_17 = (_e98 + _e386);
                local_18 = (_e100 + _e382);
                local_19 = type_15(type_14(((_e116.x * _e318.x) + _e102.member.member), ((_e116.y * _e318.x) + _e102.member.member_1), ((_e116.z * _e318.x) + _e102.member.member_2), ((_e116.w * _e318.x) + _e102.member.member_3)), type_14(((_e116.x * _e318.y) + _e102.member_1.member), ((_e116.y * _e318.y) + _e102.member_1.member_1), ((_e116.z * _e318.y) + _e102.member_1.member_2), ((_e116.w * _e318.y) + _e102.member_1.member_3)), type_14(((_e116.x * _e318.z) + _e102.member_2.member), ((_e116.y * _e318.z) + _e102.member_2.member_1), ((_e116.z * _e318.z) + _e102.member_2.member_2), ((_e116.w * _e318.z) + _e102.member_2.member_3)), type_14(((_e116.x * _e318.w) + _e102.member_3.member), ((_e116.y * _e318.w) + _e102.member_3.member_1), ((_e116.z * _e318.w) + _e102.member_3.member_2), ((_e116.w * _e318.w) + _e102.member_3.member_3)));
                local_20 = type_15(type_14(((_e116.x * _e253.x) + _e104.member.member), ((_e116.y * _e253.x) + _e104.member.member_1), ((_e116.z * _e253.x) + _e104.member.member_2), ((_e116.w * _e253.x) + _e104.member.member_3)), type_14(((_e116.x * _e253.y) + _e104.member_1.member), ((_e116.y * _e253.y) + _e104.member_1.member_1), ((_e116.z * _e253.y) + _e104.member_1.member_2), ((_e116.w * _e253.y) + _e104.member_1.member_3)), type_14(((_e116.x * _e253.z) + _e104.member_2.member), ((_e116.y * _e253.z) + _e104.member_2.member_1), ((_e116.z * _e253.z) + _e104.member_2.member_2), ((_e116.w * _e253.z) + _e104.member_2.member_3)), type_14(((_e116.x * _e253.w) + _e104.member_3.member), ((_e116.y * _e253.w) + _e104.member_3.member_1), ((_e116.z * _e253.w) + _e104.member_3.member_2), ((_e116.w * _e253.w) + _e104.member_3.member_3)));
                local_21 = type_15(type_14(((_e116.x * _e188.x) + _e106.member.member), ((_e116.y * _e188.x) + _e106.member.member_1), ((_e116.z * _e188.x) + _e106.member.member_2), ((_e116.w * _e188.x) + _e106.member.member_3)), type_14(((_e116.x * _e188.y) + _e106.member_1.member), ((_e116.y * _e188.y) + _e106.member_1.member_1), ((_e116.z * _e188.y) + _e106.member_1.member_2), ((_e116.w * _e188.y) + _e106.member_1.member_3)), type_14(((_e116.x * _e188.z) + _e106.member_2.member), ((_e116.y * _e188.z) + _e106.member_2.member_1), ((_e116.z * _e188.z) + _e106.member_2.member_2), ((_e116.w * _e188.z) + _e106.member_2.member_3)), type_14(((_e116.x * _e188.w) + _e106.member_3.member), ((_e116.y * _e188.w) + _e106.member_3.member_1), ((_e116.z * _e188.w) + _e106.member_3.member_2), ((_e116.w * _e188.w) + _e106.member_3.member_3)));
                local_22 = type_15(type_14(((_e116.x * _e123.x) + _e108.member.member), ((_e116.y * _e123.x) + _e108.member.member_1), ((_e116.z * _e123.x) + _e108.member.member_2), ((_e116.w * _e123.x) + _e108.member.member_3)), type_14(((_e116.x * _e123.y) + _e108.member_1.member), ((_e116.y * _e123.y) + _e108.member_1.member_1), ((_e116.z * _e123.y) + _e108.member_1.member_2), ((_e116.w * _e123.y) + _e108.member_1.member_3)), type_14(((_e116.x * _e123.z) + _e108.member_2.member), ((_e116.y * _e123.z) + _e108.member_2.member_1), ((_e116.z * _e123.z) + _e108.member_2.member_2), ((_e116.w * _e123.z) + _e108.member_2.member_3)), type_14(((_e116.x * _e123.w) + _e108.member_3.member), ((_e116.y * _e123.w) + _e108.member_3.member_1), ((_e116.z * _e123.w) + _e108.member_3.member_2), ((_e116.w * _e123.w) + _e108.member_3.member_3)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e918 = local_16;
                phi_114_ = _e918;
                let _e921 = local_17;
                phi_117_ = _e921;
                let _e924 = local_18;
                phi_119_ = _e924;
                let _e927 = local_19;
                phi_121_ = _e927;
                let _e930 = local_20;
                phi_123_ = _e930;
                let _e933 = local_21;
                phi_125_ = _e933;
                let _e936 = local_22;
                phi_127_ = _e936;
            }
        }
        let _e389 = (_e19.z * 16u);
        let _e392 = global_3.member.member_1;
        let _e393 = (_e32 - _e29);
        let _e395 = ((_e389 * _e392) + _e29);
        let _e397 = local;
        let _e401 = select(0f, _e397.member.member, (_e397.member.member > 0f));
        let _e404 = select(0f, _e397.member.member_1, (_e397.member.member_1 > 0f));
        let _e407 = select(0f, _e397.member.member_2, (_e397.member.member_2 > 0f));
        let _e411 = (_e393 > 3u);
        if _e411 {
            global_6.member[(_e395 / 4u)] = vec4<f32>(_e401, _e404, _e407, select(0f, _e397.member.member_3, (_e397.member.member_3 > 0f)));
        } else {
            let _e416 = (_e395 / 4u);
            global_6.member[_e416][0u] = _e401;
            if (_e393 > 1u) {
                global_6.member[_e416][1u] = _e404;
            }
            if (_e393 > 2u) {
                global_6.member[_e416][2u] = _e407;
            }
        }
        let _e429 = local_1;
        let _e433 = select(0f, _e429.member_1.member, (_e429.member_1.member > 0f));
        let _e436 = select(0f, _e429.member_1.member_1, (_e429.member_1.member_1 > 0f));
        let _e439 = select(0f, _e429.member_1.member_2, (_e429.member_1.member_2 > 0f));
        let _e443 = (_e395 + _e392);
        if _e411 {
            global_6.member[(_e443 / 4u)] = vec4<f32>(_e433, _e436, _e439, select(0f, _e429.member_1.member_3, (_e429.member_1.member_3 > 0f)));
        } else {
            let _e448 = (_e443 / 4u);
            global_6.member[_e448][0u] = _e433;
            if (_e393 > 1u) {
                global_6.member[_e448][1u] = _e436;
            }
            if (_e393 > 2u) {
                global_6.member[_e448][2u] = _e439;
            }
        }
        let _e461 = local_2;
        let _e465 = select(0f, _e461.member_2.member, (_e461.member_2.member > 0f));
        let _e468 = select(0f, _e461.member_2.member_1, (_e461.member_2.member_1 > 0f));
        let _e471 = select(0f, _e461.member_2.member_2, (_e461.member_2.member_2 > 0f));
        let _e475 = (2u * _e392);
        let _e476 = (_e395 + _e475);
        if _e411 {
            global_6.member[(_e476 / 4u)] = vec4<f32>(_e465, _e468, _e471, select(0f, _e461.member_2.member_3, (_e461.member_2.member_3 > 0f)));
        } else {
            let _e481 = (_e476 / 4u);
            global_6.member[_e481][0u] = _e465;
            if (_e393 > 1u) {
                global_6.member[_e481][1u] = _e468;
            }
            if (_e393 > 2u) {
                global_6.member[_e481][2u] = _e471;
            }
        }
        let _e494 = local_3;
        let _e498 = select(0f, _e494.member_3.member, (_e494.member_3.member > 0f));
        let _e501 = select(0f, _e494.member_3.member_1, (_e494.member_3.member_1 > 0f));
        let _e504 = select(0f, _e494.member_3.member_2, (_e494.member_3.member_2 > 0f));
        let _e508 = (3u * _e392);
        let _e509 = (_e395 + _e508);
        if _e411 {
            global_6.member[(_e509 / 4u)] = vec4<f32>(_e498, _e501, _e504, select(0f, _e494.member_3.member_3, (_e494.member_3.member_3 > 0f)));
        } else {
            let _e514 = (_e509 / 4u);
            global_6.member[_e514][0u] = _e498;
            if (_e393 > 1u) {
                global_6.member[_e514][1u] = _e501;
            }
            if (_e393 > 2u) {
                global_6.member[_e514][2u] = _e504;
            }
        }
        let _e528 = (((_e389 + 4u) * _e392) + _e29);
        let _e530 = local_4;
        let _e534 = select(0f, _e530.member.member, (_e530.member.member > 0f));
        let _e537 = select(0f, _e530.member.member_1, (_e530.member.member_1 > 0f));
        let _e540 = select(0f, _e530.member.member_2, (_e530.member.member_2 > 0f));
        if _e411 {
            global_6.member[(_e528 / 4u)] = vec4<f32>(_e534, _e537, _e540, select(0f, _e530.member.member_3, (_e530.member.member_3 > 0f)));
        } else {
            let _e548 = (_e528 / 4u);
            global_6.member[_e548][0u] = _e534;
            if (_e393 > 1u) {
                global_6.member[_e548][1u] = _e537;
            }
            if (_e393 > 2u) {
                global_6.member[_e548][2u] = _e540;
            }
        }
        let _e561 = local_5;
        let _e565 = select(0f, _e561.member_1.member, (_e561.member_1.member > 0f));
        let _e568 = select(0f, _e561.member_1.member_1, (_e561.member_1.member_1 > 0f));
        let _e571 = select(0f, _e561.member_1.member_2, (_e561.member_1.member_2 > 0f));
        let _e575 = (_e528 + _e392);
        if _e411 {
            global_6.member[(_e575 / 4u)] = vec4<f32>(_e565, _e568, _e571, select(0f, _e561.member_1.member_3, (_e561.member_1.member_3 > 0f)));
        } else {
            let _e580 = (_e575 / 4u);
            global_6.member[_e580][0u] = _e565;
            if (_e393 > 1u) {
                global_6.member[_e580][1u] = _e568;
            }
            if (_e393 > 2u) {
                global_6.member[_e580][2u] = _e571;
            }
        }
        let _e593 = local_6;
        let _e597 = select(0f, _e593.member_2.member, (_e593.member_2.member > 0f));
        let _e600 = select(0f, _e593.member_2.member_1, (_e593.member_2.member_1 > 0f));
        let _e603 = select(0f, _e593.member_2.member_2, (_e593.member_2.member_2 > 0f));
        let _e607 = (_e528 + _e475);
        if _e411 {
            global_6.member[(_e607 / 4u)] = vec4<f32>(_e597, _e600, _e603, select(0f, _e593.member_2.member_3, (_e593.member_2.member_3 > 0f)));
        } else {
            let _e612 = (_e607 / 4u);
            global_6.member[_e612][0u] = _e597;
            if (_e393 > 1u) {
                global_6.member[_e612][1u] = _e600;
            }
            if (_e393 > 2u) {
                global_6.member[_e612][2u] = _e603;
            }
        }
        let _e625 = local_7;
        let _e629 = select(0f, _e625.member_3.member, (_e625.member_3.member > 0f));
        let _e632 = select(0f, _e625.member_3.member_1, (_e625.member_3.member_1 > 0f));
        let _e635 = select(0f, _e625.member_3.member_2, (_e625.member_3.member_2 > 0f));
        let _e639 = (_e528 + _e508);
        if _e411 {
            global_6.member[(_e639 / 4u)] = vec4<f32>(_e629, _e632, _e635, select(0f, _e625.member_3.member_3, (_e625.member_3.member_3 > 0f)));
        } else {
            let _e644 = (_e639 / 4u);
            global_6.member[_e644][0u] = _e629;
            if (_e393 > 1u) {
                global_6.member[_e644][1u] = _e632;
            }
            if (_e393 > 2u) {
                global_6.member[_e644][2u] = _e635;
            }
        }
        let _e658 = (((_e389 + 8u) * _e392) + _e29);
        let _e660 = local_8;
        let _e664 = select(0f, _e660.member.member, (_e660.member.member > 0f));
        let _e667 = select(0f, _e660.member.member_1, (_e660.member.member_1 > 0f));
        let _e670 = select(0f, _e660.member.member_2, (_e660.member.member_2 > 0f));
        if _e411 {
            global_6.member[(_e658 / 4u)] = vec4<f32>(_e664, _e667, _e670, select(0f, _e660.member.member_3, (_e660.member.member_3 > 0f)));
        } else {
            let _e678 = (_e658 / 4u);
            global_6.member[_e678][0u] = _e664;
            if (_e393 > 1u) {
                global_6.member[_e678][1u] = _e667;
            }
            if (_e393 > 2u) {
                global_6.member[_e678][2u] = _e670;
            }
        }
        let _e691 = local_9;
        let _e695 = select(0f, _e691.member_1.member, (_e691.member_1.member > 0f));
        let _e698 = select(0f, _e691.member_1.member_1, (_e691.member_1.member_1 > 0f));
        let _e701 = select(0f, _e691.member_1.member_2, (_e691.member_1.member_2 > 0f));
        let _e705 = (_e658 + _e392);
        if _e411 {
            global_6.member[(_e705 / 4u)] = vec4<f32>(_e695, _e698, _e701, select(0f, _e691.member_1.member_3, (_e691.member_1.member_3 > 0f)));
        } else {
            let _e710 = (_e705 / 4u);
            global_6.member[_e710][0u] = _e695;
            if (_e393 > 1u) {
                global_6.member[_e710][1u] = _e698;
            }
            if (_e393 > 2u) {
                global_6.member[_e710][2u] = _e701;
            }
        }
        let _e723 = local_10;
        let _e727 = select(0f, _e723.member_2.member, (_e723.member_2.member > 0f));
        let _e730 = select(0f, _e723.member_2.member_1, (_e723.member_2.member_1 > 0f));
        let _e733 = select(0f, _e723.member_2.member_2, (_e723.member_2.member_2 > 0f));
        let _e737 = (_e658 + _e475);
        if _e411 {
            global_6.member[(_e737 / 4u)] = vec4<f32>(_e727, _e730, _e733, select(0f, _e723.member_2.member_3, (_e723.member_2.member_3 > 0f)));
        } else {
            let _e742 = (_e737 / 4u);
            global_6.member[_e742][0u] = _e727;
            if (_e393 > 1u) {
                global_6.member[_e742][1u] = _e730;
            }
            if (_e393 > 2u) {
                global_6.member[_e742][2u] = _e733;
            }
        }
        let _e755 = local_11;
        let _e759 = select(0f, _e755.member_3.member, (_e755.member_3.member > 0f));
        let _e762 = select(0f, _e755.member_3.member_1, (_e755.member_3.member_1 > 0f));
        let _e765 = select(0f, _e755.member_3.member_2, (_e755.member_3.member_2 > 0f));
        let _e769 = (_e658 + _e508);
        if _e411 {
            global_6.member[(_e769 / 4u)] = vec4<f32>(_e759, _e762, _e765, select(0f, _e755.member_3.member_3, (_e755.member_3.member_3 > 0f)));
        } else {
            let _e774 = (_e769 / 4u);
            global_6.member[_e774][0u] = _e759;
            if (_e393 > 1u) {
                global_6.member[_e774][1u] = _e762;
            }
            if (_e393 > 2u) {
                global_6.member[_e774][2u] = _e765;
            }
        }
        let _e788 = (((_e389 + 12u) * _e392) + _e29);
        let _e790 = local_12;
        let _e794 = select(0f, _e790.member.member, (_e790.member.member > 0f));
        let _e797 = select(0f, _e790.member.member_1, (_e790.member.member_1 > 0f));
        let _e800 = select(0f, _e790.member.member_2, (_e790.member.member_2 > 0f));
        if _e411 {
            global_6.member[(_e788 / 4u)] = vec4<f32>(_e794, _e797, _e800, select(0f, _e790.member.member_3, (_e790.member.member_3 > 0f)));
        } else {
            let _e808 = (_e788 / 4u);
            global_6.member[_e808][0u] = _e794;
            if (_e393 > 1u) {
                global_6.member[_e808][1u] = _e797;
            }
            if (_e393 > 2u) {
                global_6.member[_e808][2u] = _e800;
            }
        }
        let _e821 = local_13;
        let _e825 = select(0f, _e821.member_1.member, (_e821.member_1.member > 0f));
        let _e828 = select(0f, _e821.member_1.member_1, (_e821.member_1.member_1 > 0f));
        let _e831 = select(0f, _e821.member_1.member_2, (_e821.member_1.member_2 > 0f));
        let _e835 = (_e788 + _e392);
        if _e411 {
            global_6.member[(_e835 / 4u)] = vec4<f32>(_e825, _e828, _e831, select(0f, _e821.member_1.member_3, (_e821.member_1.member_3 > 0f)));
        } else {
            let _e840 = (_e835 / 4u);
            global_6.member[_e840][0u] = _e825;
            if (_e393 > 1u) {
                global_6.member[_e840][1u] = _e828;
            }
            if (_e393 > 2u) {
                global_6.member[_e840][2u] = _e831;
            }
        }
        let _e853 = local_14;
        let _e857 = select(0f, _e853.member_2.member, (_e853.member_2.member > 0f));
        let _e860 = select(0f, _e853.member_2.member_1, (_e853.member_2.member_1 > 0f));
        let _e863 = select(0f, _e853.member_2.member_2, (_e853.member_2.member_2 > 0f));
        let _e867 = (_e788 + _e475);
        if _e411 {
            global_6.member[(_e867 / 4u)] = vec4<f32>(_e857, _e860, _e863, select(0f, _e853.member_2.member_3, (_e853.member_2.member_3 > 0f)));
        } else {
            let _e872 = (_e867 / 4u);
            global_6.member[_e872][0u] = _e857;
            if (_e393 > 1u) {
                global_6.member[_e872][1u] = _e860;
            }
            if (_e393 > 2u) {
                global_6.member[_e872][2u] = _e863;
            }
        }
        let _e885 = local_15;
        let _e889 = select(0f, _e885.member_3.member, (_e885.member_3.member > 0f));
        let _e892 = select(0f, _e885.member_3.member_1, (_e885.member_3.member_1 > 0f));
        let _e895 = select(0f, _e885.member_3.member_2, (_e885.member_3.member_2 > 0f));
        let _e899 = (_e788 + _e508);
        if _e411 {
            global_6.member[(_e899 / 4u)] = vec4<f32>(_e889, _e892, _e895, select(0f, _e885.member_3.member_3, (_e885.member_3.member_3 > 0f)));
        } else {
            let _e904 = (_e899 / 4u);
            global_6.member[_e904][0u] = _e889;
            if (_e393 > 1u) {
                global_6.member[_e904][1u] = _e892;
            }
            if (_e393 > 2u) {
                global_6.member[_e904][2u] = _e895;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
