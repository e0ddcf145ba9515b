struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_19 {
    member: type_18,
    member_1: type_18,
    member_2: type_18,
    member_3: type_18,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_5;

fn function_() {
    var phi_119_: u32;
    var phi_122_: u32;
    var phi_124_: u32;
    var phi_126_: type_19;
    var phi_128_: type_19;
    var phi_130_: type_19;
    var phi_132_: type_19;
    var phi_120_: u32;
    var phi_123_: u32;
    var phi_125_: u32;
    var phi_127_: type_19;
    var phi_129_: type_19;
    var phi_131_: type_19;
    var phi_133_: type_19;
    var local: type_19;
    var local_1: type_19;
    var local_2: type_19;
    var local_3: type_19;
    var local_4: type_19;
    var local_5: type_19;
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

    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e31 = ((((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x) * 4u);
    let _e34 = global_3.member.member;
    if (_e31 < _e34) {
        let _e37 = (_e21.z * 4u);
        let _e40 = global_3.member.member_5;
        let _e41 = (_e40 + _e37);
        let _e44 = global_4.member[_e41];
        let _e57 = global_4.member[(_e41 + 1u)];
        let _e70 = global_4.member[(_e41 + 2u)];
        let _e83 = global_4.member[(_e41 + 3u)];
        let _e95 = global_3.member.member_4;
        phi_119_ = 0u;
        phi_122_ = _e31;
        phi_124_ = (_e95 + _e37);
        phi_126_ = type_19(type_18(_e83.x, _e83.x, _e83.x, _e83.x), type_18(_e83.y, _e83.y, _e83.y, _e83.y), type_18(_e83.z, _e83.z, _e83.z, _e83.z), type_18(_e83.w, _e83.w, _e83.w, _e83.w));
        phi_128_ = type_19(type_18(_e70.x, _e70.x, _e70.x, _e70.x), type_18(_e70.y, _e70.y, _e70.y, _e70.y), type_18(_e70.z, _e70.z, _e70.z, _e70.z), type_18(_e70.w, _e70.w, _e70.w, _e70.w));
        phi_130_ = type_19(type_18(_e57.x, _e57.x, _e57.x, _e57.x), type_18(_e57.y, _e57.y, _e57.y, _e57.y), type_18(_e57.z, _e57.z, _e57.z, _e57.z), type_18(_e57.w, _e57.w, _e57.w, _e57.w));
        phi_132_ = type_19(type_18(_e44.x, _e44.x, _e44.x, _e44.x), type_18(_e44.y, _e44.y, _e44.y, _e44.y), type_18(_e44.z, _e44.z, _e44.z, _e44.z), type_18(_e44.w, _e44.w, _e44.w, _e44.w));
        loop {
            let _e98 = phi_119_;
            let _e100 = phi_122_;
            let _e102 = phi_124_;
            let _e104 = phi_126_;
            let _e106 = phi_128_;
            let _e108 = phi_130_;
            let _e110 = phi_132_;
            local = _e110;
            local_1 = _e110;
            local_2 = _e110;
            local_3 = _e110;
            local_4 = _e108;
            local_5 = _e108;
            local_6 = _e108;
            local_7 = _e108;
            local_8 = _e106;
            local_9 = _e106;
            local_10 = _e106;
            local_11 = _e106;
            local_12 = _e104;
            local_13 = _e104;
            local_14 = _e104;
            local_15 = _e104;
            let _e113 = global_3.member.member_2;
            let _e114 = (_e98 < _e113);
            if _e114 {
                let _e117 = global_5.member[_e100];
                let _e121 = global_5.member[(_e100 + 1u)];
                let _e125 = global_5.member[(_e100 + 2u)];
                let _e129 = global_5.member[(_e100 + 3u)];
                let _e132 = global_4.member[_e102];
                let _e197 = global_4.member[(_e102 + 1u)];
                let _e262 = global_4.member[(_e102 + 2u)];
                let _e327 = global_4.member[(_e102 + 3u)];
                let _e391 = global_3.member.member_3;
                let _e395 = global_3.member.member_1;
                phi_120_ = (_e98 + 1u);
                phi_123_ = (_e100 + _e395);
                phi_125_ = (_e102 + _e391);
                phi_127_ = type_19(type_18(((_e117 * _e327.x) + _e104.member.member), ((_e121 * _e327.x) + _e104.member.member_1), ((_e125 * _e327.x) + _e104.member.member_2), ((_e129 * _e327.x) + _e104.member.member_3)), type_18(((_e117 * _e327.y) + _e104.member_1.member), ((_e121 * _e327.y) + _e104.member_1.member_1), ((_e125 * _e327.y) + _e104.member_1.member_2), ((_e129 * _e327.y) + _e104.member_1.member_3)), type_18(((_e117 * _e327.z) + _e104.member_2.member), ((_e121 * _e327.z) + _e104.member_2.member_1), ((_e125 * _e327.z) + _e104.member_2.member_2), ((_e129 * _e327.z) + _e104.member_2.member_3)), type_18(((_e117 * _e327.w) + _e104.member_3.member), ((_e121 * _e327.w) + _e104.member_3.member_1), ((_e125 * _e327.w) + _e104.member_3.member_2), ((_e129 * _e327.w) + _e104.member_3.member_3)));
                phi_129_ = type_19(type_18(((_e117 * _e262.x) + _e106.member.member), ((_e121 * _e262.x) + _e106.member.member_1), ((_e125 * _e262.x) + _e106.member.member_2), ((_e129 * _e262.x) + _e106.member.member_3)), type_18(((_e117 * _e262.y) + _e106.member_1.member), ((_e121 * _e262.y) + _e106.member_1.member_1), ((_e125 * _e262.y) + _e106.member_1.member_2), ((_e129 * _e262.y) + _e106.member_1.member_3)), type_18(((_e117 * _e262.z) + _e106.member_2.member), ((_e121 * _e262.z) + _e106.member_2.member_1), ((_e125 * _e262.z) + _e106.member_2.member_2), ((_e129 * _e262.z) + _e106.member_2.member_3)), type_18(((_e117 * _e262.w) + _e106.member_3.member), ((_e121 * _e262.w) + _e106.member_3.member_1), ((_e125 * _e262.w) + _e106.member_3.member_2), ((_e129 * _e262.w) + _e106.member_3.member_3)));
                phi_131_ = type_19(type_18(((_e117 * _e197.x) + _e108.member.member), ((_e121 * _e197.x) + _e108.member.member_1), ((_e125 * _e197.x) + _e108.member.member_2), ((_e129 * _e197.x) + _e108.member.member_3)), type_18(((_e117 * _e197.y) + _e108.member_1.member), ((_e121 * _e197.y) + _e108.member_1.member_1), ((_e125 * _e197.y) + _e108.member_1.member_2), ((_e129 * _e197.y) + _e108.member_1.member_3)), type_18(((_e117 * _e197.z) + _e108.member_2.member), ((_e121 * _e197.z) + _e108.member_2.member_1), ((_e125 * _e197.z) + _e108.member_2.member_2), ((_e129 * _e197.z) + _e108.member_2.member_3)), type_18(((_e117 * _e197.w) + _e108.member_3.member), ((_e121 * _e197.w) + _e108.member_3.member_1), ((_e125 * _e197.w) + _e108.member_3.member_2), ((_e129 * _e197.w) + _e108.member_3.member_3)));
                phi_133_ = type_19(type_18(((_e117 * _e132.x) + _e110.member.member), ((_e121 * _e132.x) + _e110.member.member_1), ((_e125 * _e132.x) + _e110.member.member_2), ((_e129 * _e132.x) + _e110.member.member_3)), type_18(((_e117 * _e132.y) + _e110.member_1.member), ((_e121 * _e132.y) + _e110.member_1.member_1), ((_e125 * _e132.y) + _e110.member_1.member_2), ((_e129 * _e132.y) + _e110.member_1.member_3)), type_18(((_e117 * _e132.z) + _e110.member_2.member), ((_e121 * _e132.z) + _e110.member_2.member_1), ((_e125 * _e132.z) + _e110.member_2.member_2), ((_e129 * _e132.z) + _e110.member_2.member_3)), type_18(((_e117 * _e132.w) + _e110.member_3.member), ((_e121 * _e132.w) + _e110.member_3.member_1), ((_e125 * _e132.w) + _e110.member_3.member_2), ((_e129 * _e132.w) + _e110.member_3.member_3)));
            } else {
                phi_120_ = u32();
                phi_123_ = u32();
                phi_125_ = u32();
                phi_127_ = type_19();
                phi_129_ = type_19();
                phi_131_ = type_19();
                phi_133_ = type_19();
            }
            let _e399 = phi_120_;
            let _e401 = phi_123_;
            let _e403 = phi_125_;
            let _e405 = phi_127_;
            let _e407 = phi_129_;
            let _e409 = phi_131_;
            let _e411 = phi_133_;
            continue;
            continuing {
                phi_119_ = _e399;
                phi_122_ = _e401;
                phi_124_ = _e403;
                phi_126_ = _e405;
                phi_128_ = _e407;
                phi_130_ = _e409;
                phi_132_ = _e411;
                break if !(_e114);
            }
        }
        let _e413 = (_e21.z * 16u);
        let _e416 = global_3.member.member_1;
        let _e417 = (_e34 - _e31);
        let _e419 = ((_e413 * _e416) + _e31);
        let _e421 = local;
        global_6.member[_e419] = select(0f, _e421.member.member, (_e421.member.member > 0f));
        let _e437 = (_e417 > 1u);
        if _e437 {
            global_6.member[(_e419 + 1u)] = select(0f, _e421.member.member_1, (_e421.member.member_1 > 0f));
        }
        let _e441 = (_e417 > 2u);
        if _e441 {
            global_6.member[(_e419 + 2u)] = select(0f, _e421.member.member_2, (_e421.member.member_2 > 0f));
        }
        let _e445 = (_e417 > 3u);
        if _e445 {
            global_6.member[(_e419 + 3u)] = select(0f, _e421.member.member_3, (_e421.member.member_3 > 0f));
        }
        let _e450 = local_1;
        let _e464 = (_e419 + _e416);
        global_6.member[_e464] = select(0f, _e450.member_1.member, (_e450.member_1.member > 0f));
        if _e437 {
            global_6.member[(_e464 + 1u)] = select(0f, _e450.member_1.member_1, (_e450.member_1.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e464 + 2u)] = select(0f, _e450.member_1.member_2, (_e450.member_1.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e464 + 3u)] = select(0f, _e450.member_1.member_3, (_e450.member_1.member_3 > 0f));
        }
        let _e477 = local_2;
        let _e491 = (2u * _e416);
        let _e492 = (_e419 + _e491);
        global_6.member[_e492] = select(0f, _e477.member_2.member, (_e477.member_2.member > 0f));
        if _e437 {
            global_6.member[(_e492 + 1u)] = select(0f, _e477.member_2.member_1, (_e477.member_2.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e492 + 2u)] = select(0f, _e477.member_2.member_2, (_e477.member_2.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e492 + 3u)] = select(0f, _e477.member_2.member_3, (_e477.member_2.member_3 > 0f));
        }
        let _e505 = local_3;
        let _e519 = (3u * _e416);
        let _e520 = (_e419 + _e519);
        global_6.member[_e520] = select(0f, _e505.member_3.member, (_e505.member_3.member > 0f));
        if _e437 {
            global_6.member[(_e520 + 1u)] = select(0f, _e505.member_3.member_1, (_e505.member_3.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e520 + 2u)] = select(0f, _e505.member_3.member_2, (_e505.member_3.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e520 + 3u)] = select(0f, _e505.member_3.member_3, (_e505.member_3.member_3 > 0f));
        }
        let _e534 = (((_e413 + 4u) * _e416) + _e31);
        let _e536 = local_4;
        global_6.member[_e534] = select(0f, _e536.member.member, (_e536.member.member > 0f));
        if _e437 {
            global_6.member[(_e534 + 1u)] = select(0f, _e536.member.member_1, (_e536.member.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e534 + 2u)] = select(0f, _e536.member.member_2, (_e536.member.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e534 + 3u)] = select(0f, _e536.member.member_3, (_e536.member.member_3 > 0f));
        }
        let _e562 = local_5;
        let _e576 = (_e534 + _e416);
        global_6.member[_e576] = select(0f, _e562.member_1.member, (_e562.member_1.member > 0f));
        if _e437 {
            global_6.member[(_e576 + 1u)] = select(0f, _e562.member_1.member_1, (_e562.member_1.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e576 + 2u)] = select(0f, _e562.member_1.member_2, (_e562.member_1.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e576 + 3u)] = select(0f, _e562.member_1.member_3, (_e562.member_1.member_3 > 0f));
        }
        let _e589 = local_6;
        let _e603 = (_e534 + _e491);
        global_6.member[_e603] = select(0f, _e589.member_2.member, (_e589.member_2.member > 0f));
        if _e437 {
            global_6.member[(_e603 + 1u)] = select(0f, _e589.member_2.member_1, (_e589.member_2.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e603 + 2u)] = select(0f, _e589.member_2.member_2, (_e589.member_2.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e603 + 3u)] = select(0f, _e589.member_2.member_3, (_e589.member_2.member_3 > 0f));
        }
        let _e616 = local_7;
        let _e630 = (_e534 + _e519);
        global_6.member[_e630] = select(0f, _e616.member_3.member, (_e616.member_3.member > 0f));
        if _e437 {
            global_6.member[(_e630 + 1u)] = select(0f, _e616.member_3.member_1, (_e616.member_3.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e630 + 2u)] = select(0f, _e616.member_3.member_2, (_e616.member_3.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e630 + 3u)] = select(0f, _e616.member_3.member_3, (_e616.member_3.member_3 > 0f));
        }
        let _e644 = (((_e413 + 8u) * _e416) + _e31);
        let _e646 = local_8;
        global_6.member[_e644] = select(0f, _e646.member.member, (_e646.member.member > 0f));
        if _e437 {
            global_6.member[(_e644 + 1u)] = select(0f, _e646.member.member_1, (_e646.member.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e644 + 2u)] = select(0f, _e646.member.member_2, (_e646.member.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e644 + 3u)] = select(0f, _e646.member.member_3, (_e646.member.member_3 > 0f));
        }
        let _e672 = local_9;
        let _e686 = (_e644 + _e416);
        global_6.member[_e686] = select(0f, _e672.member_1.member, (_e672.member_1.member > 0f));
        if _e437 {
            global_6.member[(_e686 + 1u)] = select(0f, _e672.member_1.member_1, (_e672.member_1.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e686 + 2u)] = select(0f, _e672.member_1.member_2, (_e672.member_1.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e686 + 3u)] = select(0f, _e672.member_1.member_3, (_e672.member_1.member_3 > 0f));
        }
        let _e699 = local_10;
        let _e713 = (_e644 + _e491);
        global_6.member[_e713] = select(0f, _e699.member_2.member, (_e699.member_2.member > 0f));
        if _e437 {
            global_6.member[(_e713 + 1u)] = select(0f, _e699.member_2.member_1, (_e699.member_2.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e713 + 2u)] = select(0f, _e699.member_2.member_2, (_e699.member_2.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e713 + 3u)] = select(0f, _e699.member_2.member_3, (_e699.member_2.member_3 > 0f));
        }
        let _e726 = local_11;
        let _e740 = (_e644 + _e519);
        global_6.member[_e740] = select(0f, _e726.member_3.member, (_e726.member_3.member > 0f));
        if _e437 {
            global_6.member[(_e740 + 1u)] = select(0f, _e726.member_3.member_1, (_e726.member_3.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e740 + 2u)] = select(0f, _e726.member_3.member_2, (_e726.member_3.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e740 + 3u)] = select(0f, _e726.member_3.member_3, (_e726.member_3.member_3 > 0f));
        }
        let _e754 = (((_e413 + 12u) * _e416) + _e31);
        let _e756 = local_12;
        global_6.member[_e754] = select(0f, _e756.member.member, (_e756.member.member > 0f));
        if _e437 {
            global_6.member[(_e754 + 1u)] = select(0f, _e756.member.member_1, (_e756.member.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e754 + 2u)] = select(0f, _e756.member.member_2, (_e756.member.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e754 + 3u)] = select(0f, _e756.member.member_3, (_e756.member.member_3 > 0f));
        }
        let _e782 = local_13;
        let _e796 = (_e754 + _e416);
        global_6.member[_e796] = select(0f, _e782.member_1.member, (_e782.member_1.member > 0f));
        if _e437 {
            global_6.member[(_e796 + 1u)] = select(0f, _e782.member_1.member_1, (_e782.member_1.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e796 + 2u)] = select(0f, _e782.member_1.member_2, (_e782.member_1.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e796 + 3u)] = select(0f, _e782.member_1.member_3, (_e782.member_1.member_3 > 0f));
        }
        let _e809 = local_14;
        let _e823 = (_e754 + _e491);
        global_6.member[_e823] = select(0f, _e809.member_2.member, (_e809.member_2.member > 0f));
        if _e437 {
            global_6.member[(_e823 + 1u)] = select(0f, _e809.member_2.member_1, (_e809.member_2.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e823 + 2u)] = select(0f, _e809.member_2.member_2, (_e809.member_2.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e823 + 3u)] = select(0f, _e809.member_2.member_3, (_e809.member_2.member_3 > 0f));
        }
        let _e836 = local_15;
        let _e850 = (_e754 + _e519);
        global_6.member[_e850] = select(0f, _e836.member_3.member, (_e836.member_3.member > 0f));
        if _e437 {
            global_6.member[(_e850 + 1u)] = select(0f, _e836.member_3.member_1, (_e836.member_3.member_1 > 0f));
        }
        if _e441 {
            global_6.member[(_e850 + 2u)] = select(0f, _e836.member_3.member_2, (_e836.member_3.member_2 > 0f));
        }
        if _e445 {
            global_6.member[(_e850 + 3u)] = select(0f, _e836.member_3.member_3, (_e836.member_3.member_3 > 0f));
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
