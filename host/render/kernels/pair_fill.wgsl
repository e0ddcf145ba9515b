struct type_4 {
    member: u32,
    member_1: u32,
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

fn function_() {
    var phi_54_: u32;
    var phi_57_: u32;
    var phi_58_: u32;
    var local: u32;
    var local_1: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    if (_e22 < _e25) {
        let _e29 = ((_e13.z * _e25) + _e22);
        let _e32 = global_4.member[_e29];
        let _e35 = global_5.member[_e29];
        phi_54_ = 0u;
        phi_57_ = _e35;
        loop {
            let _e37 = phi_54_;
            let _e39 = phi_57_;
            if (_e37 < 32u) {
                if (((_e32 >> bitcast<u32>((_e37 & 31u))) & 1u) == 0u) {
                    phi_58_ = _e39;
                } else {
                    let _e48 = global_3.member.member_1;
                    global_6.member[_e39] = (((_e13.z * _e48) + (_e22 * 32u)) + _e37);
                    phi_58_ = (_e39 + 1u);
                }
                let _e57 = phi_58_;
                local = (_e37 + 1u);
                local_1 = _e57;
                continue;
            } else {
                break;
            }
            continuing {
                let _e61 = local;
                phi_54_ = _e61;
                let _e64 = local_1;
                phi_57_ = _e64;
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
