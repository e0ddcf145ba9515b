struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
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
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
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
    var phi_117_: f32;
    var phi_118_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = global;
            let _e20 = global_1;
            let _e21 = global_2;
            let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
            let _e32 = global_3.member.member;
            if (_e29 < _e32) {
                let _e36 = global_4.member[_e29];
                let _e39 = global_3.member.member_1;
                if (_e39 == 0u) {
                    break;
                }
                let _e44 = global_5.member[(_e36 % _e39)];
                let _e45 = (_e44 < 0f);
                let _e48 = exp(select(-(_e44), _e44, _e45));
                let _e50 = (1f / (1f + _e48));
                let _e55 = global_6.member[_e29];
                let _e57 = (2u * _e36);
                let _e60 = global_7.member[_e57];
                let _e64 = global_7.member[(_e57 + 1u)];
                let _e70 = global_3.member.member_2;
                let _e75 = (_e70 * _e64.y);
                let _e78 = (((1f - (_e70 * _e64.x)) * (1f - (_e70 * _e64.z))) - (_e75 * _e75));
                if (_e70 > 0f) {
                    if (_e78 > (0.003921569f * 0.003921569f)) {
                        phi_117_ = sqrt(_e78);
                    } else {
                        phi_117_ = 0.003921569f;
                    }
                    let _e84 = phi_117_;
                    phi_118_ = _e84;
                } else {
                    phi_118_ = 1f;
                }
                let _e86 = phi_118_;
                let _e87 = (3u * _e29);
                global_8.member[_e87] = vec4<f32>(_e60.x, _e60.y, ((select(_e50, (_e48 * _e50), _e45) * _e55) * _e86), _e60.w);
                let _e95 = (_e87 + 1u);
                global_8.member[_e95] = _e64;
                let _e98 = (_e87 + 2u);
                let _e101 = global_9.member[_e87];
                let _e104 = global_9.member[_e95];
                let _e107 = global_9.member[_e98];
                global_8.member[_e98] = vec4<f32>(_e101, _e104, _e107, 0f);
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
