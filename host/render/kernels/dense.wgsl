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

struct type_18 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_18;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_18;

fn function_() {
    var phi_117_: u32;
    var phi_120_: u32;
    var phi_122_: u32;
    var phi_124_: type_15;
    var phi_126_: type_15;
    var phi_128_: type_15;
    var phi_130_: type_15;
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
        phi_117_ = 0u;
        phi_120_ = _e29;
        phi_122_ = (_e93 + _e35);
        phi_124_ = type_15(type_14(_e81.x, _e81.x, _e81.x, _e81.x), type_14(_e81.y, _e81.y, _e81.y, _e81.y), type_14(_e81.z, _e81.z, _e81.z, _e81.z), type_14(_e81.w, _e81.w, _e81.w, _e81.w));
        phi_126_ = type_15(type_14(_e68.x, _e68.x, _e68.x, _e68.x), type_14(_e68.y, _e68.y, _e68.y, _e68.y), type_14(_e68.z, _e68.z, _e68.z, _e68.z), type_14(_e68.w, _e68.w, _e68.w, _e68.w));
        phi_128_ = type_15(type_14(_e55.x, _e55.x, _e55.x, _e55.x), type_14(_e55.y, _e55.y, _e55.y, _e55.y), type_14(_e55.z, _e55.z, _e55.z, _e55.z), type_14(_e55.w, _e55.w, _e55.w, _e55.w));
        phi_130_ = type_15(type_14(_e42.x, _e42.x, _e42.x, _e42.x), type_14(_e42.y, _e42.y, _e42.y, _e42.y), type_14(_e42.z, _e42.z, _e42.z, _e42.z), type_14(_e42.w, _e42.w, _e42.w, _e42.w));
        loop {
            let _e96 = phi_117_;
            let _e98 = phi_120_;
            let _e100 = phi_122_;
            let _e102 = phi_124_;
            let _e104 = phi_126_;
            let _e106 = phi_128_;
            let _e108 = phi_130_;
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
                let _e115 = global_5.member[_e98];
                let _e119 = global_5.member[(_e98 + 1u)];
                let _e123 = global_5.member[(_e98 + 2u)];
                let _e127 = global_5.member[(_e98 + 3u)];
                let _e130 = global_4.member[_e100];
                let _e195 = global_4.member[(_e100 + 1u)];
                let _e260 = global_4.member[(_e100 + 2u)];
                let _e325 = global_4.member[(_e100 + 3u)];
                let _e389 = global_3.member.member_3;
                let _e393 = global_3.member.member_1;
                local_16 = (_e96 + 1u);
                local_17 = (_e98 + _e393);
                local_18 = (_e100 + _e389);
                local_19 = type_15(type_14(((_e115 * _e325.x) + _e102.member.member), ((_e119 * _e325.x) + _e102.member.member_1), ((_e123 * _e325.x) + _e102.member.member_2), ((_e127 * _e325.x) + _e102.member.member_3)), type_14(((_e115 * _e325.y) + _e102.member_1.member), ((_e119 * _e325.y) + _e102.member_1.member_1), ((_e123 * _e325.y) + _e102.member_1.member_2), ((_e127 * _e325.y) + _e102.member_1.member_3)), type_14(((_e115 * _e325.z) + _e102.member_2.member), ((_e119 * _e325.z) + _e102.member_2.member_1), ((_e123 * _e325.z) + _e102.member_2.member_2), ((_e127 * _e325.z) + _e102.member_2.member_3)), type_14(((_e115 * _e325.w) + _e102.member_3.member), ((_e119 * _e325.w) + _e102.member_3.member_1), ((_e123 * _e325.w) + _e102.member_3.member_2), ((_e127 * _e325.w) + _e102.member_3.member_3)));
                local_20 = type_15(type_14(((_e115 * _e260.x) + _e104.member.member), ((_e119 * _e260.x) + _e104.member.member_1), ((_e123 * _e260.x) + _e104.member.member_2), ((_e127 * _e260.x) + _e104.member.member_3)), type_14(((_e115 * _e260.y) + _e104.member_1.member), ((_e119 * _e260.y) + _e104.member_1.member_1), ((_e123 * _e260.y) + _e104.member_1.member_2), ((_e127 * _e260.y) + _e104.member_1.member_3)), type_14(((_e115 * _e260.z) + _e104.member_2.member), ((_e119 * _e260.z) + _e104.member_2.member_1), ((_e123 * _e260.z) + _e104.member_2.member_2), ((_e127 * _e260.z) + _e104.member_2.member_3)), type_14(((_e115 * _e260.w) + _e104.member_3.member), ((_e119 * _e260.w) + _e104.member_3.member_1), ((_e123 * _e260.w) + _e104.member_3.member_2), ((_e127 * _e260.w) + _e104.member_3.member_3)));
                local_21 = type_15(type_14(((_e115 * _e195.x) + _e106.member.member), ((_e119 * _e195.x) + _e106.member.member_1), ((_e123 * _e195.x) + _e106.member.member_2), ((_e127 * _e195.x) + _e106.member.member_3)), type_14(((_e115 * _e195.y) + _e106.member_1.member), ((_e119 * _e195.y) + _e106.member_1.member_1), ((_e123 * _e195.y) + _e106.member_1.member_2), ((_e127 * _e195.y) + _e106.member_1.member_3)), type_14(((_e115 * _e195.z) + _e106.member_2.member), ((_e119 * _e195.z) + _e106.member_2.member_1), ((_e123 * _e195.z) + _e106.member_2.member_2), ((_e127 * _e195.z) + _e106.member_2.member_3)), type_14(((_e115 * _e195.w) + _e106.member_3.member), ((_e119 * _e195.w) + _e106.member_3.member_1), ((_e123 * _e195.w) + _e106.member_3.member_2), ((_e127 * _e195.w) + _e106.member_3.member_3)));
                local_22 = type_15(type_14(((_e115 * _e130.x) + _e108.member.member), ((_e119 * _e130.x) + _e108.member.member_1), ((_e123 * _e130.x) + _e108.member.member_2), ((_e127 * _e130.x) + _e108.member.member_3)), type_14(((_e115 * _e130.y) + _e108.member_1.member), ((_e119 * _e130.y) + _e108.member_1.member_1), ((_e123 * _e130.y) + _e108.member_1.member_2), ((_e127 * _e130.y) + _e108.member_1.member_3)), type_14(((_e115 * _e130.z) + _e108.member_2.member), ((_e119 * _e130.z) + _e108.member_2.member_1), ((_e123 * _e130.z) + _e108.member_2.member_2), ((_e127 * _e130.z) + _e108.member_2.member_3)), type_14(((_e115 * _e130.w) + _e108.member_3.member), ((_e119 * _e130.w) + _e108.member_3.member_1), ((_e123 * _e130.w) + _e108.member_3.member_2), ((_e127 * _e130.w) + _e108.member_3.member_3)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e847 = local_16;
                phi_117_ = _e847;
                let _e850 = local_17;
                phi_120_ = _e850;
                let _e853 = local_18;
                phi_122_ = _e853;
                let _e856 = local_19;
                phi_124_ = _e856;
                let _e859 = local_20;
                phi_126_ = _e859;
                let _e862 = local_21;
                phi_128_ = _e862;
                let _e865 = local_22;
                phi_130_ = _e865;
            }
        }
        let _e396 = (_e19.z * 16u);
        let _e399 = global_3.member.member_1;
        let _e400 = (_e32 - _e29);
        let _e402 = ((_e396 * _e399) + _e29);
        let _e404 = local;
        global_6.member[_e402] = select(0f, _e404.member.member, (_e404.member.member > 0f));
        let _e420 = (_e400 > 1u);
        if _e420 {
            global_6.member[(_e402 + 1u)] = select(0f, _e404.member.member_1, (_e404.member.member_1 > 0f));
        }
        let _e424 = (_e400 > 2u);
        if _e424 {
            global_6.member[(_e402 + 2u)] = select(0f, _e404.member.member_2, (_e404.member.member_2 > 0f));
        }
        let _e428 = (_e400 > 3u);
        if _e428 {
            global_6.member[(_e402 + 3u)] = select(0f, _e404.member.member_3, (_e404.member.member_3 > 0f));
        }
        let _e433 = local_1;
        let _e447 = (_e402 + _e399);
        global_6.member[_e447] = select(0f, _e433.member_1.member, (_e433.member_1.member > 0f));
        if _e420 {
            global_6.member[(_e447 + 1u)] = select(0f, _e433.member_1.member_1, (_e433.member_1.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e447 + 2u)] = select(0f, _e433.member_1.member_2, (_e433.member_1.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e447 + 3u)] = select(0f, _e433.member_1.member_3, (_e433.member_1.member_3 > 0f));
        }
        let _e460 = local_2;
        let _e474 = (2u * _e399);
        let _e475 = (_e402 + _e474);
        global_6.member[_e475] = select(0f, _e460.member_2.member, (_e460.member_2.member > 0f));
        if _e420 {
            global_6.member[(_e475 + 1u)] = select(0f, _e460.member_2.member_1, (_e460.member_2.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e475 + 2u)] = select(0f, _e460.member_2.member_2, (_e460.member_2.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e475 + 3u)] = select(0f, _e460.member_2.member_3, (_e460.member_2.member_3 > 0f));
        }
        let _e488 = local_3;
        let _e502 = (3u * _e399);
        let _e503 = (_e402 + _e502);
        global_6.member[_e503] = select(0f, _e488.member_3.member, (_e488.member_3.member > 0f));
        if _e420 {
            global_6.member[(_e503 + 1u)] = select(0f, _e488.member_3.member_1, (_e488.member_3.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e503 + 2u)] = select(0f, _e488.member_3.member_2, (_e488.member_3.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e503 + 3u)] = select(0f, _e488.member_3.member_3, (_e488.member_3.member_3 > 0f));
        }
        let _e517 = (((_e396 + 4u) * _e399) + _e29);
        let _e519 = local_4;
        global_6.member[_e517] = select(0f, _e519.member.member, (_e519.member.member > 0f));
        if _e420 {
            global_6.member[(_e517 + 1u)] = select(0f, _e519.member.member_1, (_e519.member.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e517 + 2u)] = select(0f, _e519.member.member_2, (_e519.member.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e517 + 3u)] = select(0f, _e519.member.member_3, (_e519.member.member_3 > 0f));
        }
        let _e545 = local_5;
        let _e559 = (_e517 + _e399);
        global_6.member[_e559] = select(0f, _e545.member_1.member, (_e545.member_1.member > 0f));
        if _e420 {
            global_6.member[(_e559 + 1u)] = select(0f, _e545.member_1.member_1, (_e545.member_1.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e559 + 2u)] = select(0f, _e545.member_1.member_2, (_e545.member_1.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e559 + 3u)] = select(0f, _e545.member_1.member_3, (_e545.member_1.member_3 > 0f));
        }
        let _e572 = local_6;
        let _e586 = (_e517 + _e474);
        global_6.member[_e586] = select(0f, _e572.member_2.member, (_e572.member_2.member > 0f));
        if _e420 {
            global_6.member[(_e586 + 1u)] = select(0f, _e572.member_2.member_1, (_e572.member_2.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e586 + 2u)] = select(0f, _e572.member_2.member_2, (_e572.member_2.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e586 + 3u)] = select(0f, _e572.member_2.member_3, (_e572.member_2.member_3 > 0f));
        }
        let _e599 = local_7;
        let _e613 = (_e517 + _e502);
        global_6.member[_e613] = select(0f, _e599.member_3.member, (_e599.member_3.member > 0f));
        if _e420 {
            global_6.member[(_e613 + 1u)] = select(0f, _e599.member_3.member_1, (_e599.member_3.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e613 + 2u)] = select(0f, _e599.member_3.member_2, (_e599.member_3.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e613 + 3u)] = select(0f, _e599.member_3.member_3, (_e599.member_3.member_3 > 0f));
        }
        let _e627 = (((_e396 + 8u) * _e399) + _e29);
        let _e629 = local_8;
        global_6.member[_e627] = select(0f, _e629.member.member, (_e629.member.member > 0f));
        if _e420 {
            global_6.member[(_e627 + 1u)] = select(0f, _e629.member.member_1, (_e629.member.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e627 + 2u)] = select(0f, _e629.member.member_2, (_e629.member.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e627 + 3u)] = select(0f, _e629.member.member_3, (_e629.member.member_3 > 0f));
        }
        let _e655 = local_9;
        let _e669 = (_e627 + _e399);
        global_6.member[_e669] = select(0f, _e655.member_1.member, (_e655.member_1.member > 0f));
        if _e420 {
            global_6.member[(_e669 + 1u)] = select(0f, _e655.member_1.member_1, (_e655.member_1.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e669 + 2u)] = select(0f, _e655.member_1.member_2, (_e655.member_1.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e669 + 3u)] = select(0f, _e655.member_1.member_3, (_e655.member_1.member_3 > 0f));
        }
        let _e682 = local_10;
        let _e696 = (_e627 + _e474);
        global_6.member[_e696] = select(0f, _e682.member_2.member, (_e682.member_2.member > 0f));
        if _e420 {
            global_6.member[(_e696 + 1u)] = select(0f, _e682.member_2.member_1, (_e682.member_2.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e696 + 2u)] = select(0f, _e682.member_2.member_2, (_e682.member_2.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e696 + 3u)] = select(0f, _e682.member_2.member_3, (_e682.member_2.member_3 > 0f));
        }
        let _e709 = local_11;
        let _e723 = (_e627 + _e502);
        global_6.member[_e723] = select(0f, _e709.member_3.member, (_e709.member_3.member > 0f));
        if _e420 {
            global_6.member[(_e723 + 1u)] = select(0f, _e709.member_3.member_1, (_e709.member_3.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e723 + 2u)] = select(0f, _e709.member_3.member_2, (_e709.member_3.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e723 + 3u)] = select(0f, _e709.member_3.member_3, (_e709.member_3.member_3 > 0f));
        }
        let _e737 = (((_e396 + 12u) * _e399) + _e29);
        let _e739 = local_12;
        global_6.member[_e737] = select(0f, _e739.member.member, (_e739.member.member > 0f));
        if _e420 {
            global_6.member[(_e737 + 1u)] = select(0f, _e739.member.member_1, (_e739.member.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e737 + 2u)] = select(0f, _e739.member.member_2, (_e739.member.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e737 + 3u)] = select(0f, _e739.member.member_3, (_e739.member.member_3 > 0f));
        }
        let _e765 = local_13;
        let _e779 = (_e737 + _e399);
        global_6.member[_e779] = select(0f, _e765.member_1.member, (_e765.member_1.member > 0f));
        if _e420 {
            global_6.member[(_e779 + 1u)] = select(0f, _e765.member_1.member_1, (_e765.member_1.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e779 + 2u)] = select(0f, _e765.member_1.member_2, (_e765.member_1.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e779 + 3u)] = select(0f, _e765.member_1.member_3, (_e765.member_1.member_3 > 0f));
        }
        let _e792 = local_14;
        let _e806 = (_e737 + _e474);
        global_6.member[_e806] = select(0f, _e792.member_2.member, (_e792.member_2.member > 0f));
        if _e420 {
            global_6.member[(_e806 + 1u)] = select(0f, _e792.member_2.member_1, (_e792.member_2.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e806 + 2u)] = select(0f, _e792.member_2.member_2, (_e792.member_2.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e806 + 3u)] = select(0f, _e792.member_2.member_3, (_e792.member_2.member_3 > 0f));
        }
        let _e819 = local_15;
        let _e833 = (_e737 + _e502);
        global_6.member[_e833] = select(0f, _e819.member_3.member, (_e819.member_3.member > 0f));
        if _e420 {
            global_6.member[(_e833 + 1u)] = select(0f, _e819.member_3.member_1, (_e819.member_3.member_1 > 0f));
        }
        if _e424 {
            global_6.member[(_e833 + 2u)] = select(0f, _e819.member_3.member_2, (_e819.member_3.member_2 > 0f));
        }
        if _e428 {
            global_6.member[(_e833 + 3u)] = select(0f, _e819.member_3.member_3, (_e819.member_3.member_3 > 0f));
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
