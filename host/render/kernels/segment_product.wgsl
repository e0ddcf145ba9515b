struct type_5 {
    member: u32,
    member_1: f32,
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
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_15;

fn function_() {
    var phi_60_: f32;
    var phi_62_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;

    let _e11 = global;
    let _e12 = global_1;
    let _e13 = global_2;
    let _e21 = (((_e12.x + (_e12.y * _e13.x)) * 64u) + _e11.x);
    let _e24 = global_3.member.member;
    if (_e21 < _e24) {
        let _e29 = global_4.member[(_e21 + 1u)];
        let _e32 = global_4.member[_e21];
        phi_60_ = 0f;
        phi_62_ = _e32;
        loop {
            let _e34 = phi_60_;
            let _e36 = phi_62_;
            local = _e34;
            if (_e36 < _e29) {
                let _e40 = global_5.member[_e36];
                local_1 = (_e34 + _e40);
                local_2 = (_e36 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e54 = local_1;
                phi_60_ = _e54;
                let _e57 = local_2;
                phi_62_ = _e57;
            }
        }
        let _e45 = global_3.member.member_1;
        let _e47 = local;
        global_6.member[_e21] = exp((_e45 * _e47));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn segment_product(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
