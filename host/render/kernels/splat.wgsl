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
            let _e20 = global;
            let _e21 = global_1;
            let _e22 = global_2;
            let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
            let _e33 = global_3.member.member;
            if (_e30 < _e33) {
                let _e37 = global_4.member[_e30];
                let _e40 = global_3.member.member_1;
                if (_e40 == 0u) {
                    break;
                }
                let _e45 = global_5.member[(_e37 % _e40)];
                let _e46 = (_e45 < 0f);
                let _e49 = exp(select(-(_e45), _e45, _e46));
                let _e51 = (1f / (1f + _e49));
                let _e56 = global_6.member[_e30];
                let _e58 = (2u * _e37);
                let _e61 = global_7.member[_e58];
                let _e65 = global_7.member[(_e58 + 1u)];
                let _e71 = global_3.member.member_2;
                let _e76 = (_e71 * _e65.y);
                let _e79 = (((1f - (_e71 * _e65.x)) * (1f - (_e71 * _e65.z))) - (_e76 * _e76));
                if (_e71 > 0f) {
                    if (_e79 > 0.000015378702f) {
                        phi_117_ = sqrt(_e79);
                    } else {
                        phi_117_ = 0.003921569f;
                    }
                    let _e84 = phi_117_;
                    phi_118_ = _e84;
                } else {
                    phi_118_ = 1f;
                }
                let _e86 = phi_118_;
                let _e87 = (3u * _e30);
                global_8.member[_e87] = vec4<f32>(_e61.x, _e61.y, ((select(_e51, (_e49 * _e51), _e46) * _e56) * _e86), _e61.w);
                let _e95 = (_e87 + 1u);
                global_8.member[_e95] = _e65;
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
