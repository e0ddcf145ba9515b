struct type_5 {
    member: u32,
    member_1: f32,
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
    let _e20 = global;
    let _e21 = global_1;
    let _e27 = ((_e21.x * 16u) + _e20.x);
    let _e29 = ((_e21.y * 4u) + _e20.y);
    let _e32 = global_2.member.member;
    if (_e27 < _e32) {
        if (_e29 < _e32) {
            let _e37 = ((_e29 * _e32) + _e27);
            let _e38 = (_e32 * _e32);
            let _e39 = (_e21.z * 4u);
            let _e41 = ((_e39 * _e38) + _e37);
            let _e44 = global_3.member[_e41];
            let _e45 = (_e41 + _e38);
            let _e48 = global_3.member[_e45];
            let _e50 = (_e41 + (3u * _e38));
            let _e53 = global_3.member[_e50];
            let _e57 = global_4.member[(_e39 + 3u)];
            let _e63 = global_5.member[((bitcast<u32>(_e57) * _e38) + _e37)];
            let _e66 = select(false, (0.000000000000000000000000000000000000011754944f <= _e44), (0.000000000000000000000000000000000000011754944f <= _e53));
            let _e68 = (1f / select(1f, _e53, _e66));
            let _e71 = (1f / select(1f, (_e44 * _e68), _e66));
            let _e74 = global_2.member.member_1;
            let _e76 = select(0f, (_e63 * _e74), _e66);
            let _e77 = (1f < _e53);
            let _e78 = select(_e53, _e68, _e77);
            let _e81 = (((_e48 * _e68) * _e71) * _e71);
            global_6.member[_e41] = ((((-2f * _e76) * _e78) * _e81) * _e71);
            global_6.member[_e45] = (((_e76 * _e78) * _e71) * _e71);
            global_6.member[(_e41 + (2u * _e38))] = 0f;
            global_6.member[_e50] = (_e76 * select((_e53 * ((3f * _e81) - 2f)), (_e81 * _e68), _e77));
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn distortion_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
