struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

struct type_20 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(3) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage> global_6: type_15;
@group(0) @binding(2) 
var<storage> global_7: type_20;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_20;
@group(0) @binding(5) 
var<storage> global_9: type_15;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e18 = global;
            let _e19 = global_1;
            let _e20 = global_2;
            let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
            let _e31 = global_3.member.member;
            if (_e28 < _e31) {
                let _e35 = global_4.member[_e28];
                let _e38 = global_3.member.member_1;
                if (_e38 == 0u) {
                    break;
                }
                let _e43 = global_5.member[(_e35 % _e38)];
                let _e44 = (_e43 < 0f);
                let _e47 = exp(select(-(_e43), _e43, _e44));
                let _e49 = (1f / (1f + _e47));
                let _e54 = global_6.member[_e28];
                let _e56 = (2u * _e35);
                let _e59 = global_7.member[_e56];
                let _e60 = (3u * _e28);
                global_8.member[_e60] = vec4<f32>(_e59.x, _e59.y, (select(_e49, (_e47 * _e49), _e44) * _e54), _e59.w);
                let _e67 = (_e60 + 1u);
                let _e71 = global_7.member[(_e56 + 1u)];
                global_8.member[_e67] = _e71;
                let _e74 = (_e60 + 2u);
                let _e77 = global_9.member[_e60];
                let _e80 = global_9.member[_e67];
                let _e83 = global_9.member[_e74];
                global_8.member[_e74] = vec4<f32>(_e77, _e80, _e83, 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn splat(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
