struct type_4 {
    member: u32,
    member_1: f32,
}

struct type_5 {
    member: type_4,
}

struct type_8 {
    member: array<f32>,
}

struct type_15 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_15;
@group(0) @binding(2) 
var<storage> global_5: type_8;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_8;

fn function_() {
    var phi_62_: f32;
    var phi_64_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e31 = global_4.member[(_e23 + 1u)];
        let _e34 = global_4.member[_e23];
        phi_62_ = 0f;
        phi_64_ = _e34;
        loop {
            let _e36 = phi_62_;
            let _e38 = phi_64_;
            local = _e36;
            if (_e38 < _e31) {
                let _e42 = global_5.member[_e38];
                local_1 = (_e36 + _e42);
                local_2 = (_e38 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e56 = local_1;
                phi_62_ = _e56;
                let _e59 = local_2;
                phi_64_ = _e59;
            }
        }
        let _e47 = global_3.member.member_1;
        let _e49 = local;
        global_6.member[_e23] = exp((_e47 * _e49));
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
