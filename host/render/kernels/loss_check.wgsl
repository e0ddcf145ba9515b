struct type_4 {
    member: u32,
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
    var phi_65_: bool;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    if (_e22 < _e25) {
        let _e29 = global_4.member[_e22];
        if (abs(_e29.x) <= 0x1.fffffep+127f) {
            phi_65_ = select(true, false, (abs(_e29.y) <= 0x1.fffffep+127f));
        } else {
            phi_65_ = true;
        }
        let _e38 = phi_65_;
        if _e38 {
            let _e41 = atomicMax((&global_5.member[0u]), 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn loss_check(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
