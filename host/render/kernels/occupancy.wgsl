struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_10;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_15;

fn function_() {
    let _e10 = global;
    let _e11 = global_1;
    let _e12 = global_2;
    let _e20 = (((_e11.x + (_e11.y * _e12.x)) * 64u) + _e10.x);
    let _e23 = global_3.member.member;
    if (_e20 < _e23) {
        let _e27 = global_4.member[_e20];
        global_5.member[_e20] = (f32(_e27) * (1f / f32(4096u)));
        global_4.member[_e20] = 0u;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn occupancy(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
