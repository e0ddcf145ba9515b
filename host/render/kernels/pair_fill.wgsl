struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_6 {
    member: type_5,
}

struct type_9 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_9;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_9;

fn function_() {
    var phi_55_: u32;
    var phi_58_: u32;
    var phi_59_: u32;
    var local: u32;
    var local_1: u32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = ((_e14.z * _e26) + _e23);
        let _e33 = global_4.member[_e30];
        let _e36 = global_5.member[_e30];
        phi_55_ = 0u;
        phi_58_ = _e36;
        loop {
            let _e38 = phi_55_;
            let _e40 = phi_58_;
            if (_e38 < 32u) {
                if (((_e33 >> bitcast<u32>((_e38 & 31u))) & 1u) == 0u) {
                    phi_59_ = _e40;
                } else {
                    let _e49 = global_3.member.member_1;
                    global_6.member[_e40] = (((_e14.z * _e49) + (_e23 * 32u)) + _e38);
                    phi_59_ = (_e40 + 1u);
                }
                let _e58 = phi_59_;
                local = (_e38 + 1u);
                local_1 = _e58;
                continue;
            } else {
                break;
            }
            continuing {
                let _e62 = local;
                phi_55_ = _e62;
                let _e65 = local_1;
                phi_58_ = _e65;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_fill(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
