struct type_6 {
    member: u32,
    member_1: u32,
}

struct type_7 {
    member: type_6,
}

struct type_11 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_7;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_11;

fn function_() {
    var phi_51_: vec4<f32>;
    var phi_53_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: u32;

    let _e11 = global;
    let _e12 = global_1;
    let _e13 = global_2;
    let _e21 = (((_e12.x + (_e12.y * _e13.x)) * 64u) + _e11.x);
    let _e24 = global_3.member.member;
    if (_e21 < _e24) {
        let _e28 = global_5.member[_e21];
        phi_51_ = _e28;
        phi_53_ = 0u;
        loop {
            let _e30 = phi_51_;
            let _e32 = phi_53_;
            let _e35 = global_3.member.member_1;
            local = _e30;
            if (_e32 < _e35) {
                let _e41 = global_4.member[((_e32 * _e24) + _e21)];
                local_1 = (_e30 + _e41);
                local_2 = (_e32 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e48 = local_1;
                phi_51_ = _e48;
                let _e51 = local_2;
                phi_53_ = _e51;
            }
        }
        let _e45 = local;
        global_5.member[_e21] = _e45;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense_unit_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
