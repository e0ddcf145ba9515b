struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_11 {
    member: type_10,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_5;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_5;

fn function_() {
    var phi_61_: u32;
    var phi_64_: u32;
    var local: u32;
    var local_1: u32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = global_3.member.member_1;
        let _e34 = global_3.member.member_3;
        let _e38 = global_3.member.member_4;
        let _e41 = global_3.member.member_2;
        phi_61_ = 0u;
        phi_64_ = ((_e38 * _e41) + _e23);
        loop {
            let _e45 = phi_61_;
            let _e47 = phi_64_;
            if (_e45 < _e34) {
                let _e52 = global_4.member[_e47];
                global_5.member[(((_e30 + _e23) * _e34) + _e45)] = _e52;
                local = (_e45 + 1u);
                local_1 = (_e47 + _e41);
                continue;
            } else {
                break;
            }
            continuing {
                let _e59 = local;
                phi_61_ = _e59;
                let _e62 = local_1;
                phi_64_ = _e62;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn material_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
