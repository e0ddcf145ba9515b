struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_10;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_10;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_10;

fn function_() {
    var phi_52_: u32;
    var phi_55_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;

    let _e11 = global;
    let _e12 = global_1;
    let _e13 = global_2;
    let _e21 = (((_e12.x + (_e12.y * _e13.x)) * 64u) + _e11.x);
    let _e24 = global_3.member.member;
    if (_e21 < _e24) {
        let _e30 = global_4.member[(_e12.z + 1u)];
        let _e33 = global_4.member[_e12.z];
        phi_52_ = 0u;
        phi_55_ = _e33;
        loop {
            let _e35 = phi_52_;
            let _e37 = phi_55_;
            local = _e35;
            local_1 = _e35;
            if (_e37 < _e30) {
                let _e43 = global_5.member[((_e37 * _e24) + _e21)];
                local_2 = (_e35 | _e43);
                local_3 = (_e37 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e59 = local_2;
                phi_52_ = _e59;
                let _e62 = local_3;
                phi_55_ = _e62;
            }
        }
        let _e47 = ((_e12.z * _e24) + _e21);
        let _e51 = local;
        global_6.member[_e47] = _e51;
        let _e53 = local_1;
        global_7.member[_e47] = countOneBits(_e53);
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
