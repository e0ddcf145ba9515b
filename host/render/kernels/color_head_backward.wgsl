struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(1) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_16;

fn function_() {
    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = global_3.member.member_1;
        let _e32 = ((_e30 + _e23) * 3u);
        let _e33 = (_e32 + 2u);
        let _e36 = global_4.member[_e33];
        let _e39 = global_5.member[_e32];
        let _e43 = global_5.member[(_e32 + 1u)];
        let _e46 = global_5.member[_e33];
        global_6.member[_e23] = (_e36.x * (_e39 * (1f - _e39)));
        let _e55 = global_3.member.member_2;
        global_6.member[(_e55 + _e23)] = (_e36.y * (_e43 * (1f - _e43)));
        global_6.member[((2u * _e55) + _e23)] = (_e36.z * (_e46 * (1f - _e46)));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn color_head_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
