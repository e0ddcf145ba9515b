struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_5;
@group(0) @binding(3) 
var<storage> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_16;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_104_: vec4<f32>;
    var phi_105_: vec4<f32>;

    let _e16 = global;
    let _e17 = global_1;
    let _e23 = ((_e17.x * 8u) + _e16.x);
    let _e25 = ((_e17.y * 8u) + _e16.y);
    let _e28 = global_2.member.member;
    if (_e23 < _e28) {
        if (_e25 < _e28) {
            let _e31 = (_e28 * _e28);
            let _e34 = ((_e25 * _e28) + _e23);
            let _e36 = ((_e17.z * _e31) + _e34);
            let _e39 = global_3.member[_e36];
            if (_e39 > 0f) {
                let _e43 = (((_e17.z * 3u) * _e31) + _e34);
                let _e44 = (_e43 + _e31);
                let _e46 = (_e43 + (2u * _e31));
                let _e49 = global_4.member[_e43];
                let _e52 = global_4.member[_e44];
                let _e55 = global_4.member[_e46];
                let _e58 = global_5.member[_e43];
                let _e61 = global_5.member[_e44];
                let _e64 = global_5.member[_e46];
                phi_104_ = vec4<f32>(((_e49 - 0.5f) + (_e58 - 0.5f)), ((_e52 - 0.5f) + (_e61 - 0.5f)), ((_e55 - 0.5f) + (_e64 - 0.5f)), 0f);
                phi_105_ = vec4<f32>((_e49 - _e58), (_e52 - _e61), (_e55 - _e64), (1f - 0f));
            } else {
                phi_104_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_105_ = vec4<f32>(0f, 0f, 0f, 0f);
            }
            let _e81 = phi_104_;
            let _e83 = phi_105_;
            global_6.member[_e36] = _e83;
            global_7.member[_e36] = _e81;
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn loss_terms(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
