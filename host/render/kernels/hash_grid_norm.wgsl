struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<u32>,
}

struct type_20 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_20;

fn function_() {
    var phi_65_: u32;
    var phi_68_: f32;
    var local: f32;
    var local_1: u32;
    var local_2: f32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = global_3.member.member_2;
        let _e33 = global_3.member.member_1;
        phi_65_ = 0u;
        phi_68_ = 0f;
        loop {
            let _e37 = phi_65_;
            let _e39 = phi_68_;
            local = _e39;
            if (_e37 < _e33) {
                let _e44 = global_4.member[((_e30 + (_e23 * _e33)) + _e37)];
                local_1 = (_e37 + 1u);
                local_2 = (_e39 + (((abs(_e44.x) + abs(_e44.y)) + abs(_e44.z)) + abs(_e44.w)));
                continue;
            } else {
                break;
            }
            continuing {
                let _e70 = local_1;
                phi_65_ = _e70;
                let _e73 = local_2;
                phi_68_ = _e73;
            }
        }
        let _e60 = global_3.member.member_3;
        let _e62 = local;
        let _e67 = atomicMax((&global_5.member[_e60]), (bitcast<u32>(_e62) & 2147483647u));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_norm(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
