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

struct type_17 {
    member: array<i32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_6;
@group(0) @binding(2) 
var<storage> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_17;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_11;

fn function_() {
    let _e13 = global;
    let _e14 = global_1;
    let _e20 = ((_e14.x * 16u) + _e13.x);
    let _e22 = ((_e14.y * 4u) + _e13.y);
    let _e25 = global_2.member.member;
    if (_e20 < _e25) {
        if (_e22 < _e25) {
            let _e30 = ((_e22 * _e25) + _e20);
            let _e31 = (_e25 * _e25);
            let _e32 = (_e14.z * 4u);
            let _e34 = ((_e32 * _e31) + _e30);
            let _e37 = global_3.member[_e34];
            let _e41 = global_3.member[(_e34 + _e31)];
            let _e42 = (2u * _e31);
            let _e46 = global_3.member[(_e34 + _e42)];
            let _e51 = global_3.member[(_e34 + (3u * _e31))];
            let _e54 = global_2.member.member_1;
            let _e57 = global_2.member.member_2;
            let _e60 = global_2.member.member_3;
            let _e61 = (1f - _e51);
            let _e70 = global_2.member.member_4;
            let _e71 = (_e70 < _e51);
            let _e72 = (1f / _e51);
            let _e82 = global_4.member[(_e32 + 3u)];
            let _e86 = (((bitcast<u32>(_e82) * 3u) * _e31) + _e30);
            global_5.member[_e86] = select((_e37 + (_e54 * _e61)), (_e37 * _e72), _e71);
            global_5.member[(_e86 + _e31)] = select((_e41 + (_e57 * _e61)), (_e41 * _e72), _e71);
            global_5.member[(_e86 + _e42)] = select((_e46 + (_e60 * _e61)), (_e46 * _e72), _e71);
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn resolve(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
