struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: f32,
}

struct type_21 {
    member: type_20,
}

struct type_25 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_21;
@group(0) @binding(1) 
var<storage> global_4: type_17;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_25;

fn function_() {
    var phi_98_: u32;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 64u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < _e28) {
        let _e32 = global_3.member.member_1;
        if (_e32 == 0u) {
            let _e36 = global_3.member.member_2;
            let _e40 = global_4.member[(3u * _e25)];
            let _e44 = global_5.member[_e25];
            phi_98_ = (bitcast<u32>((_e36 * (_e40.w * _e44))) & 2147483647u);
        } else {
            let _e53 = global_4.member[((3u * _e25) + 2u)];
            let _e61 = (bitcast<u32>((_e53.x * 0.25f)) & 2147483647u);
            let _e63 = (bitcast<u32>((_e53.y * 0.25f)) & 2147483647u);
            let _e65 = select(_e63, _e61, (_e61 > _e63));
            let _e67 = (bitcast<u32>((_e53.z * 0.25f)) & 2147483647u);
            phi_98_ = select(_e67, _e65, (_e65 > _e67));
        }
        let _e71 = phi_98_;
        let _e74 = atomicMax((&global_6.member[0u]), _e71);
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
