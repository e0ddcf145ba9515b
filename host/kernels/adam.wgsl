struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: f32,
}

struct type_16 {
    member: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_5;

fn function_() {
    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
    let _e33 = global_3.member.member;
    if (_e30 < _e33) {
        let _e38 = global_3.member.member_2;
        let _e42 = global_4.member[((_e30 / 64u) * _e38)];
        if (_e42 == 0u) {
        } else {
            let _e46 = global_3.member.member_1;
            let _e50 = global_5.member[(_e46 + _e30)];
            let _e53 = global_6.member[_e30];
            let _e56 = global_3.member.member_4;
            let _e60 = ((_e53 * _e56) + (_e50 * (1f - _e56)));
            let _e63 = global_7.member[_e30];
            let _e66 = global_3.member.member_5;
            let _e71 = ((_e63 * _e66) + ((_e50 * _e50) * (1f - _e66)));
            let _e75 = global_3.member.member_6;
            let _e79 = global_3.member.member_7;
            let _e83 = global_8.member[_e30];
            let _e86 = global_3.member.member_3;
            global_6.member[_e30] = _e60;
            global_7.member[_e30] = _e71;
            global_8.member[_e30] = (_e83 - ((_e86 * _e60) / ((sqrt(_e71) * _e75) + _e79)));
            global_5.member[(_e46 + _e30)] = 0f;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn adam(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
