struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_12;
@group(0) @binding(2) 
var<storage> global_4: type_5;
@group(0) @binding(0) 
var<uniform> global_5: type_21;
@group(0) @binding(3) 
var<storage> global_6: type_17;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_92_: u32;
    var local: u32;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 64u) + _e15.x);
    let _e28 = global_5.member.member;
    if (_e25 < _e28) {
        let _e32 = global_5.member.member_1;
        let _e33 = (_e32 + _e25);
        let _e36 = global_5.member.member_3;
        let _e39 = global_5.member.member_2;
        let _e42 = global_3.member[_e33];
        let _e46 = global_3.member[(_e33 + 1u)];
        let _e49 = (_e36 + _e39);
        let _e51 = select(_e49, _e46, (_e46 < _e49));
        let _e59 = global_6.member[(_e33 * 3u)];
        let _e63 = global_4.member[_e33];
        let _e67 = global_5.member.member_4;
        phi_92_ = (select(_e36, _e42, (_e42 > _e36)) - _e36);
        loop {
            let _e70 = phi_92_;
            if (_e70 < (select(_e36, _e51, (_e51 > _e36)) - _e36)) {
                global_7.member[_e70] = (_e67 * (_e59.w * _e63));
                local = (_e70 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e77 = local;
                phi_92_ = _e77;
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
