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
@group(0) @binding(1) 
var<storage, read_write> global_4: type_11;

fn function_() {
    var phi_52_: u32;
    var phi_55_: f32;
    var local: f32;
    var phi_63_: u32;
    var local_1: u32;
    var local_2: f32;
    var local_3: u32;

    let _e10 = global;
    let _e11 = global_1;
    let _e12 = global_2;
    let _e20 = (((_e11.x + (_e11.y * _e12.x)) * 8u) + _e10.x);
    let _e23 = global_3.member.member_1;
    if (_e20 < _e23) {
        let _e27 = global_3.member.member;
        let _e28 = (_e27 * 64u);
        phi_52_ = _e20;
        phi_55_ = 0f;
        loop {
            let _e30 = phi_52_;
            let _e32 = phi_55_;
            local = _e32;
            if (_e30 < _e28) {
                let _e36 = global_4.member[_e30];
                local_1 = (_e30 + 64u);
                local_2 = (_e32 + _e36);
                continue;
            } else {
                break;
            }
            continuing {
                let _e53 = local_1;
                phi_52_ = _e53;
                let _e56 = local_2;
                phi_55_ = _e56;
            }
        }
        let _e41 = local;
        phi_63_ = _e20;
        loop {
            let _e44 = phi_63_;
            if (_e44 < _e28) {
                let _e48 = global_4.member[_e44];
                global_4.member[_e44] = (_e48 - (_e41 / f32(_e27)));
                local_3 = (_e44 + 64u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e60 = local_3;
                phi_63_ = _e60;
            }
        }
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn exposure_center(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
