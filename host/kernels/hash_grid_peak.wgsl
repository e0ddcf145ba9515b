struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: type_15,
}

struct type_19 {
    member: array<u32>,
}

struct type_24 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_6;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_24;

fn function_() {
    var phi_94_: u32;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 64u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < _e28) {
        let _e32 = global_3.member.member_1;
        if (_e32 == 0u) {
            let _e37 = global_4.member[(3u * _e25)];
            let _e41 = global_5.member[_e25];
            phi_94_ = (bitcast<u32>((_e37.w * _e41)) & 2147483647u);
        } else {
            let _e49 = global_4.member[((3u * _e25) + 2u)];
            let _e57 = (bitcast<u32>((_e49.x * 0.25f)) & 2147483647u);
            let _e59 = (bitcast<u32>((_e49.y * 0.25f)) & 2147483647u);
            let _e61 = select(_e59, _e57, (_e57 > _e59));
            let _e63 = (bitcast<u32>((_e49.z * 0.25f)) & 2147483647u);
            phi_94_ = select(_e63, _e61, (_e61 > _e63));
        }
        let _e67 = phi_94_;
        let _e70 = atomicMax((&global_6.member[0u]), _e67);
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
