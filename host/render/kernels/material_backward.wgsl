struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_11;

fn function_() {
    var phi_60_: u32;
    var phi_63_: u32;
    var local: u32;
    var local_1: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    if (_e22 < _e25) {
        let _e29 = global_3.member.member_1;
        let _e33 = global_3.member.member_3;
        let _e37 = global_3.member.member_4;
        let _e40 = global_3.member.member_2;
        phi_60_ = 0u;
        phi_63_ = ((_e37 * _e40) + _e22);
        loop {
            let _e44 = phi_60_;
            let _e46 = phi_63_;
            if (_e44 < _e33) {
                let _e51 = global_4.member[_e46];
                global_5.member[(((_e29 + _e22) * _e33) + _e44)] = _e51;
                local = (_e44 + 1u);
                local_1 = (_e46 + _e40);
                continue;
            } else {
                break;
            }
            continuing {
                let _e58 = local;
                phi_60_ = _e58;
                let _e61 = local_1;
                phi_63_ = _e61;
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
