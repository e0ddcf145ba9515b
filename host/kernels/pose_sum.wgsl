struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_15;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_5;

fn function_() {
    var phi_67_: u32;
    var phi_70_: f32;
    var local: f32;
    var local_1: u32;
    var local_2: f32;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 64u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < (_e28 * 6u)) {
        let _e31 = (_e25 / 6u);
        let _e32 = (_e25 % 6u);
        let _e35 = global_4.member[_e31];
        let _e40 = global_6.member[((6u * _e35) + _e32)];
        let _e43 = global_3.member.member_2;
        phi_67_ = _e43;
        phi_70_ = _e40;
        loop {
            let _e45 = phi_67_;
            let _e47 = phi_70_;
            let _e50 = global_3.member.member_3;
            local = _e47;
            if (_e45 < _e50) {
                let _e54 = global_3.member.member_1;
                let _e61 = global_5.member[((6u * ((_e31 * _e54) + _e45)) + _e32)];
                local_1 = (_e45 + 1u);
                local_2 = (_e47 + _e61);
                continue;
            } else {
                break;
            }
            continuing {
                let _e68 = local_1;
                phi_67_ = _e68;
                let _e71 = local_2;
                phi_70_ = _e71;
            }
        }
        let _e65 = local;
        global_6.member[((6u * _e35) + _e32)] = _e65;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pose_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
