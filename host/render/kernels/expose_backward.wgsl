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
@group(0) @binding(3) 
var<storage, read_write> global_5: type_11;
@group(0) @binding(1) 
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_11;

fn function_() {
    var phi_67_: u32;
    var phi_70_: f32;
    var phi_71_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;
    var local_3: f32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e14 = global;
            let _e15 = global_1;
            let _e16 = global_2;
            let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
            let _e27 = global_3.member.member;
            let _e30 = global_3.member.member_1;
            if (_e24 < (_e27 * _e30)) {
                if (_e30 == 0u) {
                    break;
                }
                let _e38 = global_4.member[((_e24 / _e30) * 2u)];
                let _e39 = (_e24 * _e30);
                phi_67_ = _e39;
                phi_70_ = 0f;
                phi_71_ = 0f;
                loop {
                    let _e42 = phi_67_;
                    let _e44 = phi_70_;
                    let _e46 = phi_71_;
                    local = _e46;
                    local_1 = _e44;
                    if (_e42 < (_e39 + _e30)) {
                        let _e50 = global_5.member[_e42];
                        let _e53 = global_6.member[_e42];
                        global_5.member[_e42] = (_e50 * _e38);
                        local_2 = (_e42 + 1u);
                        local_3 = (_e44 + _e50);
                        local_4 = (_e46 + (_e50 * _e53));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e71 = local_2;
                        phi_67_ = _e71;
                        let _e74 = local_3;
                        phi_70_ = _e74;
                        let _e77 = local_4;
                        phi_71_ = _e77;
                    }
                }
                let _e59 = (2u * _e24);
                let _e63 = local;
                global_7.member[_e59] = _e63;
                let _e68 = local_1;
                global_7.member[(_e59 + 1u)] = _e68;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expose_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
