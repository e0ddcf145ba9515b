struct type_5 {
    member: u32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<f32>,
}

struct type_16 {
    member: array<i32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_6;
@group(0) @binding(2) 
var<storage> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_16;
@group(0) @binding(3) 
var<storage> global_5: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_11;

fn function_() {
    let _e14 = global;
    let _e15 = global_1;
    let _e21 = ((_e15.x * 16u) + _e14.x);
    let _e23 = ((_e15.y * 4u) + _e14.y);
    let _e26 = global_2.member.member;
    if (_e21 < _e26) {
        if (_e23 < _e26) {
            let _e31 = ((_e23 * _e26) + _e21);
            let _e32 = (_e26 * _e26);
            let _e33 = (_e15.z * 4u);
            let _e35 = ((_e33 * _e32) + _e31);
            let _e38 = global_3.member[_e35];
            let _e39 = (_e35 + _e32);
            let _e42 = global_3.member[_e39];
            let _e43 = (2u * _e32);
            let _e44 = (_e35 + _e43);
            let _e47 = global_3.member[_e44];
            let _e49 = (_e35 + (3u * _e32));
            let _e52 = global_3.member[_e49];
            let _e56 = global_4.member[(_e33 + 3u)];
            let _e60 = (((bitcast<u32>(_e56) * 3u) * _e32) + _e31);
            let _e63 = global_5.member[_e60];
            let _e67 = global_5.member[(_e60 + _e32)];
            let _e71 = global_5.member[(_e60 + _e43)];
            let _e74 = global_2.member.member_4;
            let _e75 = (_e74 < _e52);
            let _e76 = (1f / _e52);
            let _e77 = (_e63 * _e76);
            let _e78 = (_e67 * _e76);
            let _e79 = (_e71 * _e76);
            let _e88 = global_2.member.member_1;
            let _e91 = global_2.member.member_2;
            let _e94 = global_2.member.member_3;
            global_6.member[_e35] = select(_e63, _e77, _e75);
            global_6.member[_e39] = select(_e67, _e78, _e75);
            global_6.member[_e44] = select(_e71, _e79, _e75);
            global_6.member[_e49] = -(select((((_e63 * _e88) + (_e67 * _e91)) + (_e71 * _e94)), ((((_e77 * _e38) + (_e78 * _e42)) + (_e79 * _e47)) * _e76), _e75));
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn resolve_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
