struct type_7 {
    member: u32,
}

struct type_8 {
    member: type_7,
}

struct type_13 {
    member: array<u32>,
}

struct type_19 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
var<workgroup> global_3: array<atomic<u32>, 512>;
@group(0) @binding(0) 
var<uniform> global_4: type_8;
@group(0) @binding(1) 
var<storage> global_5: type_13;
@group(0) @binding(2) 
var<storage> global_6: type_13;
@group(0) @binding(3) 
var<storage, read_write> global_7: type_19;

fn function_() {
    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    atomicStore((&global_3[_e20.x]), 0u);
    let _e25 = (256u + _e20.x);
    atomicStore((&global_3[_e25]), 0u);
    workgroupBarrier();
    let _e33 = (((_e21.x + (_e21.y * _e22.x)) * 256u) + _e20.x);
    let _e36 = global_4.member.member;
    if (_e33 < _e36) {
        let _e44 = global_5.member[(_e33 >> bitcast<u32>(2u))];
        let _e51 = atomicAdd((&global_3[((_e44 >> bitcast<u32>((((_e33 << bitcast<u32>(3u)) & 31u) & 31u))) & 255u)]), 1u);
        let _e58 = global_6.member[(_e33 >> bitcast<u32>(1u))];
        let _e68 = atomicAdd((&global_3[(256u + (((_e58 >> bitcast<u32>((((_e33 << bitcast<u32>(4u)) & 31u) & 31u))) & 65535u) >> bitcast<u32>(8i)))]), 1u);
    }
    workgroupBarrier();
    let _e69 = atomicLoad((&global_3[_e20.x]));
    let _e72 = atomicAdd((&global_7.member[_e20.x]), _e69);
    let _e73 = atomicLoad((&global_3[_e25]));
    let _e76 = atomicAdd((&global_7.member[_e25]), _e73);
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn byte_histogram(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
