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
            let _e14 = global;
            let _e15 = global_1;
            let _e16 = global_2;
            let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
            let _e27 = global_3.member.member_1;
            let _e28 = (_e27 * _e27);
            let _e31 = global_3.member.member;
            if (_e24 < (_e31 * _e28)) {
                if (_e28 == 0u) {
                    break;
                }
                let _e35 = (_e24 / _e28);
                let _e39 = global_4.member[(_e35 / 3u)];
                let _e43 = ((_e39 * 64u) + ((_e35 % 3u) * 2u));
                let _e46 = global_5.member[_e43];
                let _e50 = global_6.member[_e24];
                let _e55 = global_5.member[(_e43 + 1u)];
                global_7.member[_e24] = ((exp(_e46) * _e50) + _e55);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expose(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
