struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: type_10,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_5;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_5;

fn function_() {
    var phi_63_: u32;
    var phi_66_: f32;
    var phi_67_: f32;
    var phi_68_: f32;
    var phi_69_: f32;
    var phi_70_: u32;
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

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e22 = (_e16.x + (_e16.y * _e17.x));
    let _e25 = ((_e22 * 64u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < _e28) {
        let _e32 = global_3.member.member_1;
        phi_63_ = 0u;
        phi_66_ = 0f;
        phi_67_ = 0f;
        phi_68_ = 0f;
        phi_69_ = 0f;
        phi_70_ = (((_e22 * _e32) * 256u) + _e15.x);
        loop {
            let _e37 = phi_63_;
            let _e39 = phi_66_;
            let _e41 = phi_67_;
            let _e43 = phi_68_;
            let _e45 = phi_69_;
            let _e47 = phi_70_;
            local = _e43;
            local_1 = _e41;
            local_2 = _e39;
            local_3 = _e45;
            if (_e37 < _e32) {
                let _e51 = global_4.member[_e47];
                let _e56 = global_4.member[(_e47 + 64u)];
                let _e61 = global_4.member[(_e47 + 128u)];
                let _e66 = global_4.member[(_e47 + 192u)];
                local_4 = (_e37 + 1u);
                local_5 = (_e39 + _e61);
                local_6 = (_e41 + _e56);
                local_7 = (_e43 + _e51);
                local_8 = (_e45 + _e66);
                local_9 = (_e47 + 256u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e85 = local_4;
                phi_63_ = _e85;
                let _e88 = local_5;
                phi_66_ = _e88;
                let _e91 = local_6;
                phi_67_ = _e91;
                let _e94 = local_7;
                phi_68_ = _e94;
                let _e97 = local_8;
                phi_69_ = _e97;
                let _e100 = local_9;
                phi_70_ = _e100;
            }
        }
        let _e71 = local;
        let _e73 = local_1;
        let _e76 = local_2;
        let _e78 = local_3;
        global_5.member[_e25] = ((_e71 + _e73) + (_e76 + _e78));
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
