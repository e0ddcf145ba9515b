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
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: type_19;
    var local_20: type_19;
    var local_21: type_19;
    var local_22: type_19;

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
            let _e113 = global_3.member.member_2;
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
            if (_e98 < _e113) {
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
                local_16 = (_e98 + 1u);
                local_17 = (_e100 + _e395);
                local_18 = (_e102 + _e391);
                local_19 = type_19(type_18(((_e117 * _e327.x) + _e104.member.member), ((_e121 * _e327.x) + _e104.member.member_1), ((_e125 * _e327.x) + _e104.member.member_2), ((_e129 * _e327.x) + _e104.member.member_3)), type_18(((_e117 * _e327.y) + _e104.member_1.member), ((_e121 * _e327.y) + _e104.member_1.member_1), ((_e125 * _e327.y) + _e104.member_1.member_2), ((_e129 * _e327.y) + _e104.member_1.member_3)), type_18(((_e117 * _e327.z) + _e104.member_2.member), ((_e121 * _e327.z) + _e104.member_2.member_1), ((_e125 * _e327.z) + _e104.member_2.member_2), ((_e129 * _e327.z) + _e104.member_2.member_3)), type_18(((_e117 * _e327.w) + _e104.member_3.member), ((_e121 * _e327.w) + _e104.member_3.member_1), ((_e125 * _e327.w) + _e104.member_3.member_2), ((_e129 * _e327.w) + _e104.member_3.member_3)));
                local_20 = type_19(type_18(((_e117 * _e262.x) + _e106.member.member), ((_e121 * _e262.x) + _e106.member.member_1), ((_e125 * _e262.x) + _e106.member.member_2), ((_e129 * _e262.x) + _e106.member.member_3)), type_18(((_e117 * _e262.y) + _e106.member_1.member), ((_e121 * _e262.y) + _e106.member_1.member_1), ((_e125 * _e262.y) + _e106.member_1.member_2), ((_e129 * _e262.y) + _e106.member_1.member_3)), type_18(((_e117 * _e262.z) + _e106.member_2.member), ((_e121 * _e262.z) + _e106.member_2.member_1), ((_e125 * _e262.z) + _e106.member_2.member_2), ((_e129 * _e262.z) + _e106.member_2.member_3)), type_18(((_e117 * _e262.w) + _e106.member_3.member), ((_e121 * _e262.w) + _e106.member_3.member_1), ((_e125 * _e262.w) + _e106.member_3.member_2), ((_e129 * _e262.w) + _e106.member_3.member_3)));
                local_21 = type_19(type_18(((_e117 * _e197.x) + _e108.member.member), ((_e121 * _e197.x) + _e108.member.member_1), ((_e125 * _e197.x) + _e108.member.member_2), ((_e129 * _e197.x) + _e108.member.member_3)), type_18(((_e117 * _e197.y) + _e108.member_1.member), ((_e121 * _e197.y) + _e108.member_1.member_1), ((_e125 * _e197.y) + _e108.member_1.member_2), ((_e129 * _e197.y) + _e108.member_1.member_3)), type_18(((_e117 * _e197.z) + _e108.member_2.member), ((_e121 * _e197.z) + _e108.member_2.member_1), ((_e125 * _e197.z) + _e108.member_2.member_2), ((_e129 * _e197.z) + _e108.member_2.member_3)), type_18(((_e117 * _e197.w) + _e108.member_3.member), ((_e121 * _e197.w) + _e108.member_3.member_1), ((_e125 * _e197.w) + _e108.member_3.member_2), ((_e129 * _e197.w) + _e108.member_3.member_3)));
                local_22 = type_19(type_18(((_e117 * _e132.x) + _e110.member.member), ((_e121 * _e132.x) + _e110.member.member_1), ((_e125 * _e132.x) + _e110.member.member_2), ((_e129 * _e132.x) + _e110.member.member_3)), type_18(((_e117 * _e132.y) + _e110.member_1.member), ((_e121 * _e132.y) + _e110.member_1.member_1), ((_e125 * _e132.y) + _e110.member_1.member_2), ((_e129 * _e132.y) + _e110.member_1.member_3)), type_18(((_e117 * _e132.z) + _e110.member_2.member), ((_e121 * _e132.z) + _e110.member_2.member_1), ((_e125 * _e132.z) + _e110.member_2.member_2), ((_e129 * _e132.z) + _e110.member_2.member_3)), type_18(((_e117 * _e132.w) + _e110.member_3.member), ((_e121 * _e132.w) + _e110.member_3.member_1), ((_e125 * _e132.w) + _e110.member_3.member_2), ((_e129 * _e132.w) + _e110.member_3.member_3)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e849 = local_16;
                phi_119_ = _e849;
                let _e852 = local_17;
                phi_122_ = _e852;
                let _e855 = local_18;
                phi_124_ = _e855;
                let _e858 = local_19;
                phi_126_ = _e858;
                let _e861 = local_20;
                phi_128_ = _e861;
                let _e864 = local_21;
                phi_130_ = _e864;
                let _e867 = local_22;
                phi_132_ = _e867;
            }
        }
        let _e398 = (_e21.z * 16u);
        let _e401 = global_3.member.member_1;
        let _e402 = (_e34 - _e31);
        let _e404 = ((_e398 * _e401) + _e31);
        let _e406 = local;
        global_6.member[_e404] = select(0f, _e406.member.member, (_e406.member.member > 0f));
        let _e422 = (_e402 > 1u);
        if _e422 {
            global_6.member[(_e404 + 1u)] = select(0f, _e406.member.member_1, (_e406.member.member_1 > 0f));
        }
        let _e426 = (_e402 > 2u);
        if _e426 {
            global_6.member[(_e404 + 2u)] = select(0f, _e406.member.member_2, (_e406.member.member_2 > 0f));
        }
        let _e430 = (_e402 > 3u);
        if _e430 {
            global_6.member[(_e404 + 3u)] = select(0f, _e406.member.member_3, (_e406.member.member_3 > 0f));
        }
        let _e435 = local_1;
        let _e449 = (_e404 + _e401);
        global_6.member[_e449] = select(0f, _e435.member_1.member, (_e435.member_1.member > 0f));
        if _e422 {
            global_6.member[(_e449 + 1u)] = select(0f, _e435.member_1.member_1, (_e435.member_1.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e449 + 2u)] = select(0f, _e435.member_1.member_2, (_e435.member_1.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e449 + 3u)] = select(0f, _e435.member_1.member_3, (_e435.member_1.member_3 > 0f));
        }
        let _e462 = local_2;
        let _e476 = (2u * _e401);
        let _e477 = (_e404 + _e476);
        global_6.member[_e477] = select(0f, _e462.member_2.member, (_e462.member_2.member > 0f));
        if _e422 {
            global_6.member[(_e477 + 1u)] = select(0f, _e462.member_2.member_1, (_e462.member_2.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e477 + 2u)] = select(0f, _e462.member_2.member_2, (_e462.member_2.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e477 + 3u)] = select(0f, _e462.member_2.member_3, (_e462.member_2.member_3 > 0f));
        }
        let _e490 = local_3;
        let _e504 = (3u * _e401);
        let _e505 = (_e404 + _e504);
        global_6.member[_e505] = select(0f, _e490.member_3.member, (_e490.member_3.member > 0f));
        if _e422 {
            global_6.member[(_e505 + 1u)] = select(0f, _e490.member_3.member_1, (_e490.member_3.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e505 + 2u)] = select(0f, _e490.member_3.member_2, (_e490.member_3.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e505 + 3u)] = select(0f, _e490.member_3.member_3, (_e490.member_3.member_3 > 0f));
        }
        let _e519 = (((_e398 + 4u) * _e401) + _e31);
        let _e521 = local_4;
        global_6.member[_e519] = select(0f, _e521.member.member, (_e521.member.member > 0f));
        if _e422 {
            global_6.member[(_e519 + 1u)] = select(0f, _e521.member.member_1, (_e521.member.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e519 + 2u)] = select(0f, _e521.member.member_2, (_e521.member.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e519 + 3u)] = select(0f, _e521.member.member_3, (_e521.member.member_3 > 0f));
        }
        let _e547 = local_5;
        let _e561 = (_e519 + _e401);
        global_6.member[_e561] = select(0f, _e547.member_1.member, (_e547.member_1.member > 0f));
        if _e422 {
            global_6.member[(_e561 + 1u)] = select(0f, _e547.member_1.member_1, (_e547.member_1.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e561 + 2u)] = select(0f, _e547.member_1.member_2, (_e547.member_1.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e561 + 3u)] = select(0f, _e547.member_1.member_3, (_e547.member_1.member_3 > 0f));
        }
        let _e574 = local_6;
        let _e588 = (_e519 + _e476);
        global_6.member[_e588] = select(0f, _e574.member_2.member, (_e574.member_2.member > 0f));
        if _e422 {
            global_6.member[(_e588 + 1u)] = select(0f, _e574.member_2.member_1, (_e574.member_2.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e588 + 2u)] = select(0f, _e574.member_2.member_2, (_e574.member_2.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e588 + 3u)] = select(0f, _e574.member_2.member_3, (_e574.member_2.member_3 > 0f));
        }
        let _e601 = local_7;
        let _e615 = (_e519 + _e504);
        global_6.member[_e615] = select(0f, _e601.member_3.member, (_e601.member_3.member > 0f));
        if _e422 {
            global_6.member[(_e615 + 1u)] = select(0f, _e601.member_3.member_1, (_e601.member_3.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e615 + 2u)] = select(0f, _e601.member_3.member_2, (_e601.member_3.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e615 + 3u)] = select(0f, _e601.member_3.member_3, (_e601.member_3.member_3 > 0f));
        }
        let _e629 = (((_e398 + 8u) * _e401) + _e31);
        let _e631 = local_8;
        global_6.member[_e629] = select(0f, _e631.member.member, (_e631.member.member > 0f));
        if _e422 {
            global_6.member[(_e629 + 1u)] = select(0f, _e631.member.member_1, (_e631.member.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e629 + 2u)] = select(0f, _e631.member.member_2, (_e631.member.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e629 + 3u)] = select(0f, _e631.member.member_3, (_e631.member.member_3 > 0f));
        }
        let _e657 = local_9;
        let _e671 = (_e629 + _e401);
        global_6.member[_e671] = select(0f, _e657.member_1.member, (_e657.member_1.member > 0f));
        if _e422 {
            global_6.member[(_e671 + 1u)] = select(0f, _e657.member_1.member_1, (_e657.member_1.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e671 + 2u)] = select(0f, _e657.member_1.member_2, (_e657.member_1.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e671 + 3u)] = select(0f, _e657.member_1.member_3, (_e657.member_1.member_3 > 0f));
        }
        let _e684 = local_10;
        let _e698 = (_e629 + _e476);
        global_6.member[_e698] = select(0f, _e684.member_2.member, (_e684.member_2.member > 0f));
        if _e422 {
            global_6.member[(_e698 + 1u)] = select(0f, _e684.member_2.member_1, (_e684.member_2.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e698 + 2u)] = select(0f, _e684.member_2.member_2, (_e684.member_2.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e698 + 3u)] = select(0f, _e684.member_2.member_3, (_e684.member_2.member_3 > 0f));
        }
        let _e711 = local_11;
        let _e725 = (_e629 + _e504);
        global_6.member[_e725] = select(0f, _e711.member_3.member, (_e711.member_3.member > 0f));
        if _e422 {
            global_6.member[(_e725 + 1u)] = select(0f, _e711.member_3.member_1, (_e711.member_3.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e725 + 2u)] = select(0f, _e711.member_3.member_2, (_e711.member_3.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e725 + 3u)] = select(0f, _e711.member_3.member_3, (_e711.member_3.member_3 > 0f));
        }
        let _e739 = (((_e398 + 12u) * _e401) + _e31);
        let _e741 = local_12;
        global_6.member[_e739] = select(0f, _e741.member.member, (_e741.member.member > 0f));
        if _e422 {
            global_6.member[(_e739 + 1u)] = select(0f, _e741.member.member_1, (_e741.member.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e739 + 2u)] = select(0f, _e741.member.member_2, (_e741.member.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e739 + 3u)] = select(0f, _e741.member.member_3, (_e741.member.member_3 > 0f));
        }
        let _e767 = local_13;
        let _e781 = (_e739 + _e401);
        global_6.member[_e781] = select(0f, _e767.member_1.member, (_e767.member_1.member > 0f));
        if _e422 {
            global_6.member[(_e781 + 1u)] = select(0f, _e767.member_1.member_1, (_e767.member_1.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e781 + 2u)] = select(0f, _e767.member_1.member_2, (_e767.member_1.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e781 + 3u)] = select(0f, _e767.member_1.member_3, (_e767.member_1.member_3 > 0f));
        }
        let _e794 = local_14;
        let _e808 = (_e739 + _e476);
        global_6.member[_e808] = select(0f, _e794.member_2.member, (_e794.member_2.member > 0f));
        if _e422 {
            global_6.member[(_e808 + 1u)] = select(0f, _e794.member_2.member_1, (_e794.member_2.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e808 + 2u)] = select(0f, _e794.member_2.member_2, (_e794.member_2.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e808 + 3u)] = select(0f, _e794.member_2.member_3, (_e794.member_2.member_3 > 0f));
        }
        let _e821 = local_15;
        let _e835 = (_e739 + _e504);
        global_6.member[_e835] = select(0f, _e821.member_3.member, (_e821.member_3.member > 0f));
        if _e422 {
            global_6.member[(_e835 + 1u)] = select(0f, _e821.member_3.member_1, (_e821.member_3.member_1 > 0f));
        }
        if _e426 {
            global_6.member[(_e835 + 2u)] = select(0f, _e821.member_3.member_2, (_e821.member_3.member_2 > 0f));
        }
        if _e430 {
            global_6.member[(_e835 + 3u)] = select(0f, _e821.member_3.member_3, (_e821.member_3.member_3 > 0f));
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
