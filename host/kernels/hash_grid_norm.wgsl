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
    var phi_90_: f32;
    var phi_96_: f32;
    var phi_102_: f32;
    var phi_108_: f32;
    var phi_72_: u32;
    var phi_75_: f32;
    var local: f32;

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
            let _e43 = (_e40 < _e36);
            if _e43 {
                let _e47 = global_4.member[((_e33 + (_e26 * _e36)) + _e40)];
                if (_e47.x < 0f) {
                    phi_90_ = -(_e47.x);
                } else {
                    phi_90_ = _e47.x;
                }
                let _e52 = phi_90_;
                if (_e47.y < 0f) {
                    phi_96_ = -(_e47.y);
                } else {
                    phi_96_ = _e47.y;
                }
                let _e57 = phi_96_;
                if (_e47.z < 0f) {
                    phi_102_ = -(_e47.z);
                } else {
                    phi_102_ = _e47.z;
                }
                let _e63 = phi_102_;
                if (_e47.w < 0f) {
                    phi_108_ = -(_e47.w);
                } else {
                    phi_108_ = _e47.w;
                }
                let _e69 = phi_108_;
                phi_72_ = (_e40 + 1u);
                phi_75_ = (_e42 + (((_e52 + _e57) + _e63) + _e69));
            } else {
                phi_72_ = u32();
                phi_75_ = f32();
            }
            let _e74 = phi_72_;
            let _e76 = phi_75_;
            continue;
            continuing {
                phi_71_ = _e74;
                phi_74_ = _e76;
                break if !(_e43);
            }
        }
        let _e80 = global_3.member.member_3;
        let _e82 = local;
        let _e87 = atomicMax((&global_5.member[_e80]), (bitcast<u32>(_e82) & 2147483647u));
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
