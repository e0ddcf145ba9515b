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

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_15;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e21 = global;
            let _e22 = global_1;
            let _e23 = global_2;
            let _e31 = (((_e22.x + (_e22.y * _e23.x)) * 64u) + _e21.x);
            let _e34 = global_3.member.member;
            if (_e31 < _e34) {
                let _e38 = global_4.member[_e31];
                let _e41 = global_3.member.member_1;
                let _e42 = (_e41 == 0u);
                if _e42 {
                    break;
                }
                let _e44 = ((_e38 / _e41) * 18u);
                let _e48 = global_5.member[(_e44 + 9u)];
                let _e52 = global_5.member[(_e44 + 10u)];
                let _e56 = global_5.member[(_e44 + 11u)];
                if _e42 {
                    break;
                }
                let _e58 = ((_e38 % _e41) * 3u);
                let _e61 = global_6.member[_e58];
                let _e65 = global_6.member[(_e58 + 1u)];
                let _e69 = global_6.member[(_e58 + 2u)];
                let _e70 = (_e61 - _e48);
                let _e71 = (_e65 - _e52);
                let _e72 = (_e69 - _e56);
                let _e78 = sqrt((((_e70 * _e70) + (_e71 * _e71)) + (_e72 * _e72)));
                let _e81 = (1f / select(0.000001f, _e78, (_e78 > 0.000001f)));
                let _e82 = (3u * _e31);
                global_7.member[_e82] = _e81;
                global_7.member[(_e82 + 1u)] = (_e81 * _e81);
                global_7.member[(_e82 + 2u)] = 0f;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_inverse_distance(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
