struct type_5 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<storage> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_5;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_5;

fn function_() {
    var phi_60_: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member[0u];
    if (_e22 < _e25) {
        let _e28 = ((1u + _e22) * 4u);
        let _e32 = global_3.member[(_e28 + 1u)];
        let _e35 = global_4.member[_e32];
        let _e39 = global_3.member[(_e28 + 2u)];
        let _e43 = global_3.member[(_e28 + 3u)];
        if (_e35 > _e39) {
            phi_60_ = (_e35 - _e39);
        } else {
            phi_60_ = 0u;
        }
        let _e47 = phi_60_;
        let _e52 = global_4.member[0u];
        let _e56 = global_3.member[_e28];
        global_5.member[_e56] = select(0u, select(_e43, _e47, (_e47 < _e43)), (_e52 == 0u));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn count_fill(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
