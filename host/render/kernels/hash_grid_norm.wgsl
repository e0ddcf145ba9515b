struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_11 {
    member: type_10,
}

struct type_15 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_15;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_20;

fn function_() {
    var phi_71_: u32;
    var phi_74_: f32;
    var phi_86_: f32;
    var phi_92_: f32;
    var phi_98_: f32;
    var phi_104_: f32;
    var local: f32;
    var local_1: u32;
    var local_2: f32;

    let _e16 = global;
    let _e17 = global_1;
    let _e18 = global_2;
    let _e26 = (((_e17.x + (_e17.y * _e18.x)) * 64u) + _e16.x);
    let _e29 = global_3.member.member;
    if (_e26 < _e29) {
        let _e33 = global_3.member.member_2;
        let _e36 = global_3.member.member_1;
        phi_71_ = 0u;
        phi_74_ = 0f;
        loop {
            let _e40 = phi_71_;
            let _e42 = phi_74_;
            local = _e42;
            if (_e40 < _e36) {
                let _e47 = global_4.member[((_e33 + (_e26 * _e36)) + _e40)];
                if (_e47.x < 0f) {
                    phi_86_ = -(_e47.x);
                } else {
                    phi_86_ = _e47.x;
                }
                let _e52 = phi_86_;
                if (_e47.y < 0f) {
                    phi_92_ = -(_e47.y);
                } else {
                    phi_92_ = _e47.y;
                }
                let _e57 = phi_92_;
                if (_e47.z < 0f) {
                    phi_98_ = -(_e47.z);
                } else {
                    phi_98_ = _e47.z;
                }
                let _e63 = phi_98_;
                if (_e47.w < 0f) {
                    phi_104_ = -(_e47.w);
                } else {
                    phi_104_ = _e47.w;
                }
                let _e69 = phi_104_;
                local_1 = (_e40 + 1u);
                local_2 = (_e42 + (((_e52 + _e57) + _e63) + _e69));
                continue;
            } else {
                break;
            }
            continuing {
                let _e85 = local_1;
                phi_71_ = _e85;
                let _e88 = local_2;
                phi_74_ = _e88;
            }
        }
        let _e75 = global_3.member.member_3;
        let _e77 = local;
        let _e82 = atomicMax((&global_5.member[_e75]), (bitcast<u32>(_e77) & 2147483647u));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_norm(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
