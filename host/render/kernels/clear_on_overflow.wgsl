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
    let _e8 = global;
    let _e9 = global_1;
    let _e10 = global_2;
    let _e18 = (((_e9.x + (_e9.y * _e10.x)) * 64u) + _e8.x);
    let _e21 = global_3.member.member;
    if (_e18 < _e21) {
        let _e25 = global_4.member[0u];
        if (_e25 == 0u) {
        } else {
            global_5.member[_e18] = 0u;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn clear_on_overflow(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
