struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_10;

fn function_() {
    let _e9 = global;
    let _e10 = global_1;
    let _e11 = global_2;
    let _e19 = (((_e10.x + (_e10.y * _e11.x)) * 64u) + _e9.x);
    let _e22 = global_3.member.member;
    if (_e19 <= _e22) {
        let _e27 = global_4.member[(_e19 / 1024u)];
        let _e30 = global_5.member[_e19];
        global_5.member[_e19] = (_e30 + _e27);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_add(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
