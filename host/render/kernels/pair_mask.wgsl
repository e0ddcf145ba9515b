struct type_6 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
}

struct type_10 {
    member: type_9,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_10;
@group(0) @binding(1) 
var<storage> global_4: type_6;
@group(0) @binding(2) 
var<storage> global_5: type_6;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_6;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_6;

fn function_() {
    var phi_53_: u32;
    var phi_56_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    if (_e22 < _e25) {
        let _e31 = global_4.member[(_e13.z + 1u)];
        let _e34 = global_4.member[_e13.z];
        phi_53_ = 0u;
        phi_56_ = _e34;
        loop {
            let _e36 = phi_53_;
            let _e38 = phi_56_;
            local = _e36;
            local_1 = _e36;
            if (_e38 < _e31) {
                let _e44 = global_5.member[((_e38 * _e25) + _e22)];
                local_2 = (_e36 | _e44);
                local_3 = (_e38 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e60 = local_2;
                phi_53_ = _e60;
                let _e63 = local_3;
                phi_56_ = _e63;
            }
        }
        let _e48 = ((_e13.z * _e25) + _e22);
        let _e52 = local;
        global_6.member[_e48] = _e52;
        let _e54 = local_1;
        global_7.member[_e48] = countOneBits(_e54);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_mask(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
