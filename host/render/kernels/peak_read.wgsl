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
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_11;

fn function_() {
    var phi_61_: u32;
    var phi_64_: f32;
    var phi_65_: f32;
    var phi_66_: f32;
    var phi_67_: f32;
    var phi_68_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: u32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e20 = (_e14.x + (_e14.y * _e15.x));
    let _e23 = ((_e20 * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = global_3.member.member_1;
        phi_61_ = 0u;
        phi_64_ = 0f;
        phi_65_ = 0f;
        phi_66_ = 0f;
        phi_67_ = 0f;
        phi_68_ = (((_e20 * _e30) * 256u) + _e13.x);
        loop {
            let _e35 = phi_61_;
            let _e37 = phi_64_;
            let _e39 = phi_65_;
            let _e41 = phi_66_;
            let _e43 = phi_67_;
            let _e45 = phi_68_;
            local = _e41;
            local_1 = _e39;
            local_2 = _e37;
            local_3 = _e43;
            if (_e35 < _e30) {
                let _e49 = global_4.member[_e45];
                let _e54 = global_4.member[(_e45 + 64u)];
                let _e59 = global_4.member[(_e45 + 128u)];
                let _e64 = global_4.member[(_e45 + 192u)];
                local_4 = (_e35 + 1u);
                local_5 = (_e37 + _e59);
                local_6 = (_e39 + _e54);
                local_7 = (_e41 + _e49);
                local_8 = (_e43 + _e64);
                local_9 = (_e45 + 256u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e83 = local_4;
                phi_61_ = _e83;
                let _e86 = local_5;
                phi_64_ = _e86;
                let _e89 = local_6;
                phi_65_ = _e89;
                let _e92 = local_7;
                phi_66_ = _e92;
                let _e95 = local_8;
                phi_67_ = _e95;
                let _e98 = local_9;
                phi_68_ = _e98;
            }
        }
        let _e69 = local;
        let _e71 = local_1;
        let _e74 = local_2;
        let _e76 = local_3;
        global_5.member[_e23] = ((_e69 + _e71) + (_e74 + _e76));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn peak_read(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
