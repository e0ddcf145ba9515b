struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: type_7,
}

struct type_12 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32>,
}

struct type_20 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_8;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_12;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_20;

fn function_() {
    var phi_65_: u32;
    var phi_68_: u32;
    var phi_70_: i32;
    var phi_72_: f32;
    var local: f32;
    var local_1: i32;
    var phi_109_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: i32;
    var local_6: f32;

    let _e25 = global;
    let _e26 = global_1;
    let _e27 = global_2;
    if (((_e26.x + (_e26.y * _e27.x)) + _e25.x) == 0u) {
        phi_65_ = 0u;
        phi_68_ = 0u;
        phi_70_ = 0i;
        phi_72_ = 1.01f;
        loop {
            let _e37 = phi_65_;
            let _e39 = phi_68_;
            let _e41 = phi_70_;
            let _e43 = phi_72_;
            let _e46 = global_3.member.member;
            local = _e43;
            local_1 = _e41;
            local_2 = _e39;
            if (_e37 <= _e46) {
                let _e50 = global_4.member[_e37];
                global_4.member[_e37] = 0u;
                local_3 = (_e37 + 1u);
                local_4 = select(_e50, _e39, (_e39 > _e50));
                local_5 = (_e41 + (bitcast<i32>((_e50 >> bitcast<u32>(23i))) - 127i));
                local_6 = (_e43 * bitcast<f32>(((_e50 & 8388607u) | 1065353216u)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e127 = local_3;
                phi_65_ = _e127;
                let _e130 = local_4;
                phi_68_ = _e130;
                let _e133 = local_5;
                phi_70_ = _e133;
                let _e136 = local_6;
                phi_72_ = _e136;
            }
        }
        let _e64 = local;
        let _e71 = local_1;
        let _e73 = ((_e71 + (bitcast<i32>((bitcast<u32>(_e64) >> bitcast<u32>(23i))) - 127i)) + 1i);
        let _e75 = select(_e73, 128i, (_e73 > 128i));
        let _e77 = select(_e75, -125i, (_e75 < -125i));
        let _e80 = global_3.member.member_1;
        if (_e80 > 1u) {
            let _e82 = (_e80 - 1u);
            phi_109_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e82)), 32u, (_e82 == 0u)));
        } else {
            phi_109_ = 0u;
        }
        let _e90 = phi_109_;
        let _e93 = ((62i - _e77) - bitcast<i32>(_e90));
        let _e95 = select(_e93, 126i, (_e93 > 126i));
        global_5.member[0u] = bitcast<f32>((bitcast<u32>((_e95 + 127i)) << bitcast<u32>(23i)));
        global_5.member[1u] = bitcast<f32>((bitcast<u32>((127i - _e95)) << bitcast<u32>(23i)));
        let _e111 = local_2;
        let _e112 = (_e111 < 2139095040u);
        global_5.member[2u] = select(0f, bitcast<f32>(((bitcast<u32>((_e77 + 127i)) << bitcast<u32>(23i)) - 1u)), _e112);
        if _e112 {
        } else {
            let _e124 = atomicMax((&global_6.member[0u]), 2u);
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
