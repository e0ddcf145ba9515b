struct type_6 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: type_11,
}

struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_12;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_15;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_6;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_20;

fn function_() {
    var phi_69_: u32;
    var phi_72_: u32;
    var phi_74_: i32;
    var phi_76_: f32;
    var phi_70_: u32;
    var phi_73_: u32;
    var phi_75_: i32;
    var phi_77_: f32;
    var local: f32;
    var local_1: i32;
    var phi_120_: u32;
    var local_2: u32;

    let _e29 = global;
    let _e30 = global_1;
    let _e31 = global_2;
    if (((_e30.x + (_e30.y * _e31.x)) + _e29.x) == 0u) {
        phi_69_ = 0u;
        phi_72_ = 0u;
        phi_74_ = 0i;
        phi_76_ = 1.01f;
        loop {
            let _e41 = phi_69_;
            let _e43 = phi_72_;
            let _e45 = phi_74_;
            let _e47 = phi_76_;
            local = _e47;
            local_1 = _e45;
            local_2 = _e43;
            let _e50 = global_3.member.member;
            let _e51 = (_e41 <= _e50);
            if _e51 {
                let _e54 = global_4.member[_e41];
                global_4.member[_e41] = 0u;
                phi_70_ = (_e41 + 1u);
                phi_73_ = select(_e54, _e43, (_e43 > _e54));
                phi_75_ = (_e45 + (bitcast<i32>((_e54 >> bitcast<u32>(23i))) - 127i));
                phi_77_ = (_e47 * bitcast<f32>(((_e54 & 8388607u) | 1065353216u)));
            } else {
                phi_70_ = u32();
                phi_73_ = u32();
                phi_75_ = i32();
                phi_77_ = f32();
            }
            let _e68 = phi_70_;
            let _e70 = phi_73_;
            let _e72 = phi_75_;
            let _e74 = phi_77_;
            continue;
            continuing {
                phi_69_ = _e68;
                phi_72_ = _e70;
                phi_74_ = _e72;
                phi_76_ = _e74;
                break if !(_e51);
            }
        }
        let _e77 = local;
        let _e84 = local_1;
        let _e86 = ((_e84 + (bitcast<i32>((bitcast<u32>(_e77) >> bitcast<u32>(23i))) - 127i)) + 1i);
        let _e88 = select(_e86, 128i, (_e86 > 128i));
        let _e90 = select(_e88, -125i, (_e88 < -125i));
        let _e93 = global_3.member.member_1;
        if (_e93 > 1u) {
            let _e95 = (_e93 - 1u);
            phi_120_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e95)), 32u, (_e95 == 0u)));
        } else {
            phi_120_ = 0u;
        }
        let _e103 = phi_120_;
        let _e106 = ((62i - _e90) - bitcast<i32>(_e103));
        let _e108 = select(_e106, 126i, (_e106 > 126i));
        global_5.member[0u] = bitcast<f32>((bitcast<u32>((_e108 + 127i)) << bitcast<u32>(23i)));
        global_5.member[1u] = bitcast<f32>((bitcast<u32>((127i - _e108)) << bitcast<u32>(23i)));
        let _e124 = local_2;
        let _e125 = (_e124 < 2139095040u);
        global_5.member[2u] = select(0f, bitcast<f32>(((bitcast<u32>((_e90 + 127i)) << bitcast<u32>(23i)) - 1u)), _e125);
        if _e125 {
        } else {
            let _e137 = atomicMax((&global_6.member[0u]), 2u);
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn hash_grid_scale(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
