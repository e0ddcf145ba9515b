struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<u32>,
}

struct type_20 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_20;

fn function_() {
    var phi_68_: u32;
    var phi_71_: f32;
    var phi_83_: f32;
    var phi_89_: f32;
    var phi_95_: f32;
    var phi_101_: f32;
    var local: f32;
    var local_1: u32;
    var local_2: f32;

    let _e13 = global;
    let _e14 = global_1;
    let _e15 = global_2;
    let _e23 = (((_e14.x + (_e14.y * _e15.x)) * 64u) + _e13.x);
    let _e26 = global_3.member.member;
    if (_e23 < _e26) {
        let _e30 = global_3.member.member_2;
        let _e33 = global_3.member.member_1;
        phi_68_ = 0u;
        phi_71_ = 0f;
        loop {
            let _e37 = phi_68_;
            let _e39 = phi_71_;
            local = _e39;
            if (_e37 < _e33) {
                let _e44 = global_4.member[((_e30 + (_e23 * _e33)) + _e37)];
                if (_e44.x < 0f) {
                    phi_83_ = -(_e44.x);
                } else {
                    phi_83_ = _e44.x;
                }
                let _e49 = phi_83_;
                if (_e44.y < 0f) {
                    phi_89_ = -(_e44.y);
                } else {
                    phi_89_ = _e44.y;
                }
                let _e54 = phi_89_;
                if (_e44.z < 0f) {
                    phi_95_ = -(_e44.z);
                } else {
                    phi_95_ = _e44.z;
                }
                let _e60 = phi_95_;
                if (_e44.w < 0f) {
                    phi_101_ = -(_e44.w);
                } else {
                    phi_101_ = _e44.w;
                }
                let _e66 = phi_101_;
                local_1 = (_e37 + 1u);
                local_2 = (_e39 + (((_e49 + _e54) + _e60) + _e66));
                continue;
            } else {
                break;
            }
            continuing {
                let _e82 = local_1;
                phi_68_ = _e82;
                let _e85 = local_2;
                phi_71_ = _e85;
            }
        }
        let _e72 = global_3.member.member_3;
        let _e74 = local;
        let _e79 = atomicMax((&global_5.member[_e72]), (bitcast<u32>(_e74) & 2147483647u));
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
