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
    var phi_68_: f32;
    var phi_70_: f32;
    var phi_72_: f32;
    var phi_74_: u32;
    var phi_64_: u32;
    var phi_67_: f32;
    var phi_69_: f32;
    var phi_71_: f32;
    var phi_73_: f32;
    var phi_75_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;

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
        phi_68_ = 0f;
        phi_70_ = 0f;
        phi_72_ = 0f;
        phi_74_ = (((_e22 * _e32) * 256u) + _e15.x);
        loop {
            let _e37 = phi_63_;
            let _e39 = phi_66_;
            let _e41 = phi_68_;
            let _e43 = phi_70_;
            let _e45 = phi_72_;
            let _e47 = phi_74_;
            local = _e43;
            local_1 = _e41;
            local_2 = _e39;
            local_3 = _e45;
            let _e48 = (_e37 < _e32);
            if _e48 {
                let _e51 = global_4.member[_e47];
                let _e56 = global_4.member[(_e47 + 64u)];
                let _e61 = global_4.member[(_e47 + 128u)];
                let _e66 = global_4.member[(_e47 + 192u)];
                phi_64_ = (_e37 + 1u);
                phi_67_ = (_e39 + _e61);
                phi_69_ = (_e41 + _e56);
                phi_71_ = (_e43 + _e51);
                phi_73_ = (_e45 + _e66);
                phi_75_ = (_e47 + 256u);
            } else {
                phi_64_ = u32();
                phi_67_ = f32();
                phi_69_ = f32();
                phi_71_ = f32();
                phi_73_ = f32();
                phi_75_ = u32();
            }
            let _e71 = phi_64_;
            let _e73 = phi_67_;
            let _e75 = phi_69_;
            let _e77 = phi_71_;
            let _e79 = phi_73_;
            let _e81 = phi_75_;
            continue;
            continuing {
                phi_63_ = _e71;
                phi_66_ = _e73;
                phi_68_ = _e75;
                phi_70_ = _e77;
                phi_72_ = _e79;
                phi_74_ = _e81;
                break if !(_e48);
            }
        }
        let _e84 = local;
        let _e86 = local_1;
        let _e89 = local_2;
        let _e91 = local_3;
        global_5.member[_e25] = ((_e84 + _e86) + (_e89 + _e91));
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
