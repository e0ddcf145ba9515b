struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_11;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e12 = global;
            let _e13 = global_1;
            let _e14 = global_2;
            let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
            let _e25 = global_3.member.member_1;
            let _e26 = (_e25 * _e25);
            let _e29 = global_3.member.member;
            if (_e22 < (_e29 * _e26)) {
                if (_e26 == 0u) {
                    break;
                }
                let _e34 = ((_e22 / _e26) * 2u);
                let _e37 = global_4.member[_e34];
                let _e40 = global_5.member[_e22];
                let _e45 = global_4.member[(_e34 + 1u)];
                global_6.member[_e22] = ((_e37 * _e40) + _e45);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expose(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
