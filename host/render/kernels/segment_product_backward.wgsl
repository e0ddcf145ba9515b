struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(2) 
var<storage> global_6: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_20;

fn function_() {
    var phi_91_: u32;
    var local: u32;

    let _e14 = global;
    let _e15 = global_1;
    let _e16 = global_2;
    let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
    let _e27 = global_3.member.member;
    if (_e24 < _e27) {
        let _e31 = global_3.member.member_1;
        let _e32 = (_e31 + _e24);
        let _e35 = global_3.member.member_3;
        let _e38 = global_3.member.member_2;
        let _e41 = global_4.member[_e32];
        let _e45 = global_4.member[(_e32 + 1u)];
        let _e48 = (_e35 + _e38);
        let _e50 = select(_e48, _e45, (_e45 < _e48));
        let _e58 = global_5.member[(_e32 * 3u)];
        let _e62 = global_6.member[_e32];
        let _e66 = global_3.member.member_4;
        phi_91_ = (select(_e35, _e41, (_e41 > _e35)) - _e35);
        loop {
            let _e69 = phi_91_;
            if (_e69 < (select(_e35, _e50, (_e50 > _e35)) - _e35)) {
                global_7.member[_e69] = (_e66 * (_e58.w * _e62));
                local = (_e69 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e76 = local;
                phi_91_ = _e76;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn segment_product_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
