struct type_5 {
    member: array<i32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(5) 
var<storage> global_4: type_11;
@group(0) @binding(0) 
var<uniform> global_5: type_15;
@group(0) @binding(2) 
var<storage> global_6: type_11;
@group(0) @binding(3) 
var<storage> global_7: type_11;
@group(0) @binding(4) 
var<storage> global_8: type_11;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_11;

fn function_() {
    var phi_77_: i32;
    var phi_80_: u32;
    var phi_81_: u32;
    var local: i32;
    var local_1: u32;

    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
    let _e33 = global_5.member.member;
    if (_e30 < _e33) {
        let _e37 = ((_e21.z * _e33) + _e30);
        let _e40 = global_6.member[_e37];
        let _e44 = global_3.member[(_e21.z * 4u)];
        let _e47 = ((bitcast<u32>(_e44) * _e33) + _e30);
        let _e50 = global_8.member[_e47];
        let _e53 = global_4.member[_e47];
        let _e56 = global_7.member[_e37];
        phi_77_ = 0i;
        phi_80_ = _e56;
        loop {
            let _e58 = phi_77_;
            let _e60 = phi_80_;
            if (_e58 < 32i) {
                let _e62 = (_e58 & 31i);
                if (((_e40 >> bitcast<u32>(_e62)) & 1u) == 0u) {
                    phi_81_ = _e60;
                } else {
                    global_9.member[_e60] = (_e53 + countOneBits((_e50 & ((1u << bitcast<u32>(_e62)) - 1u))));
                    phi_81_ = (_e60 + 1u);
                }
                let _e77 = phi_81_;
                local = (_e58 + 1i);
                local_1 = _e77;
                continue;
            } else {
                break;
            }
            continuing {
                let _e81 = local;
                phi_77_ = _e81;
                let _e84 = local_1;
                phi_80_ = _e84;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_fill(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
