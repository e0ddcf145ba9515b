struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_6 {
    member: type_5,
}

struct type_10 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_10;

fn function_() {
    let _e9 = global;
    let _e10 = global_1;
    let _e11 = global_2;
    if (((_e10.x + (_e10.y * _e11.x)) + _e9.x) == 0u) {
        let _e22 = global_3.member.member_1;
        let _e25 = global_4.member[_e22];
        let _e28 = global_3.member.member;
        global_5.member[_e28] = _e25;
        let _e33 = global_3.member.member_2;
        if (_e25 > _e33) {
            global_5.member[0u] = 1u;
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn record_total(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
