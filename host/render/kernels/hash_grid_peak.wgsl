struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
}

struct type_6 {
    member: type_5,
}

struct type_13 {
    member: array<vec4<f32>>,
}

struct type_17 {
    member: array<f32>,
}

struct type_21 {
    member: array<u32>,
}

struct type_25 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_13;
@group(0) @binding(2) 
var<storage> global_5: type_17;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_25;

fn function_() {
    var phi_97_: u32;

    let _e14 = global;
    let _e15 = global_1;
    let _e16 = global_2;
    let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
    let _e27 = global_3.member.member;
    if (_e24 < _e27) {
        let _e31 = global_3.member.member_1;
        if (_e31 == 0u) {
            let _e35 = global_3.member.member_2;
            let _e39 = global_4.member[(3u * _e24)];
            let _e43 = global_5.member[_e24];
            phi_97_ = (bitcast<u32>((_e35 * (_e39.w * _e43))) & 2147483647u);
        } else {
            let _e52 = global_4.member[((3u * _e24) + 2u)];
            let _e60 = (bitcast<u32>((_e52.x * 0.25f)) & 2147483647u);
            let _e62 = (bitcast<u32>((_e52.y * 0.25f)) & 2147483647u);
            let _e64 = select(_e62, _e60, (_e60 > _e62));
            let _e66 = (bitcast<u32>((_e52.z * 0.25f)) & 2147483647u);
            phi_97_ = select(_e66, _e64, (_e64 > _e66));
        }
        let _e70 = phi_97_;
        let _e73 = atomicMax((&global_6.member[0u]), _e70);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_peak(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
