struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_15;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_15;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_15;

fn function_() {
    let _e21 = global;
    let _e22 = global_1;
    let _e23 = global_2;
    let _e31 = (((_e22.x + (_e22.y * _e23.x)) * 64u) + _e21.x);
    let _e34 = global_3.member.member;
    if (_e31 < _e34) {
        let _e39 = global_3.member.member_2;
        let _e43 = global_4.member[((_e31 / 64u) * _e39)];
        if (_e43 == 0u) {
        } else {
            let _e47 = global_3.member.member_1;
            let _e51 = global_5.member[(_e47 + _e31)];
            let _e54 = global_6.member[_e31];
            let _e57 = global_3.member.member_4;
            let _e61 = ((_e54 * _e57) + (_e51 * (1f - _e57)));
            let _e64 = global_7.member[_e31];
            let _e67 = global_3.member.member_5;
            let _e72 = ((_e64 * _e67) + ((_e51 * _e51) * (1f - _e67)));
            let _e76 = global_3.member.member_6;
            let _e80 = global_3.member.member_7;
            let _e84 = global_8.member[_e31];
            let _e87 = global_3.member.member_8;
            let _e91 = global_3.member.member_3;
            global_6.member[_e31] = _e61;
            global_7.member[_e31] = _e72;
            global_8.member[_e31] = ((_e84 * _e87) - ((_e91 * _e61) / ((sqrt(_e72) * _e76) + _e80)));
            global_5.member[(_e47 + _e31)] = 0f;
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
