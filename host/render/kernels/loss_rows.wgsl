struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_12;

fn function_() {
    var phi_70_: vec4<f32>;
    var phi_73_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member_1;
    let _e28 = global_3.member.member;
    if (_e22 < (_e25 * _e28)) {
        let _e31 = (_e22 * _e28);
        phi_70_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_73_ = _e31;
        loop {
            let _e34 = phi_70_;
            let _e36 = phi_73_;
            local = _e34;
            if (_e36 < (_e31 + _e28)) {
                let _e40 = global_4.member[_e36];
                let _e51 = global_5.member[_e36];
                local_1 = vec4<f32>((_e34.x + ((abs(_e40.x) + abs(_e40.y)) + abs(_e40.z))), (_e34.y + _e51), (_e34.z + (((_e40.x * _e40.x) + (_e40.y * _e40.y)) + (_e40.z * _e40.z))), (_e34.w + _e40.w));
                local_2 = (_e36 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e74 = local_1;
                phi_70_ = _e74;
                let _e77 = local_2;
                phi_73_ = _e77;
            }
        }
        let _e71 = local;
        global_6.member[_e22] = _e71;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn loss_rows(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
