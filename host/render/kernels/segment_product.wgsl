struct type_5 {
    member: u32,
    member_1: f32,
    member_2: u32,
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
    var phi_62_: f32;
    var phi_64_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    if (_e22 < _e25) {
        let _e30 = global_4.member[(_e22 + 1u)];
        let _e33 = global_4.member[_e22];
        phi_62_ = 0f;
        phi_64_ = _e33;
        loop {
            let _e35 = phi_62_;
            let _e37 = phi_64_;
            local = _e35;
            if (_e37 < _e30) {
                let _e41 = global_5.member[_e37];
                local_1 = (_e35 + _e41);
                local_2 = (_e37 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e63 = local_1;
                phi_62_ = _e63;
                let _e66 = local_2;
                phi_64_ = _e66;
            }
        }
        let _e46 = global_3.member.member_1;
        let _e48 = local;
        let _e50 = exp((_e46 * _e48));
        let _e53 = global_3.member.member_2;
        if (_e53 == 0u) {
            global_6.member[_e22] = _e50;
        } else {
            let _e59 = global_6.member[_e22];
            global_6.member[_e22] = (_e59 * _e50);
        }
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
