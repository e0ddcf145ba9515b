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
    var local: f32;
    var local_1: i32;
    var phi_113_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: i32;
    var local_6: f32;

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
            let _e50 = global_3.member.member;
            local = _e47;
            local_1 = _e45;
            local_2 = _e43;
            if (_e41 <= _e50) {
                let _e54 = global_4.member[_e41];
                global_4.member[_e41] = 0u;
                local_3 = (_e41 + 1u);
                local_4 = select(_e54, _e43, (_e43 > _e54));
                local_5 = (_e45 + (bitcast<i32>((_e54 >> bitcast<u32>(23i))) - 127i));
                local_6 = (_e47 * bitcast<f32>(((_e54 & 8388607u) | 1065353216u)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e131 = local_3;
                phi_69_ = _e131;
                let _e134 = local_4;
                phi_72_ = _e134;
                let _e137 = local_5;
                phi_74_ = _e137;
                let _e140 = local_6;
                phi_76_ = _e140;
            }
        }
        let _e68 = local;
        let _e75 = local_1;
        let _e77 = ((_e75 + (bitcast<i32>((bitcast<u32>(_e68) >> bitcast<u32>(23i))) - 127i)) + 1i);
        let _e79 = select(_e77, 128i, (_e77 > 128i));
        let _e81 = select(_e79, -125i, (_e79 < -125i));
        let _e84 = global_3.member.member_1;
        if (_e84 > 1u) {
            let _e86 = (_e84 - 1u);
            phi_113_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e86)), 32u, (_e86 == 0u)));
        } else {
            phi_113_ = 0u;
        }
        let _e94 = phi_113_;
        let _e97 = ((62i - _e81) - bitcast<i32>(_e94));
        let _e99 = select(_e97, 126i, (_e97 > 126i));
        global_5.member[0u] = bitcast<f32>((bitcast<u32>((_e99 + 127i)) << bitcast<u32>(23i)));
        global_5.member[1u] = bitcast<f32>((bitcast<u32>((127i - _e99)) << bitcast<u32>(23i)));
        let _e115 = local_2;
        let _e116 = (_e115 < 2139095040u);
        global_5.member[2u] = select(0f, bitcast<f32>(((bitcast<u32>((_e81 + 127i)) << bitcast<u32>(23i)) - 1u)), _e116);
        if _e116 {
        } else {
            let _e128 = atomicMax((&global_6.member[0u]), 2u);
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
