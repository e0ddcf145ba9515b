struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: type_10,
}

struct type_15 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_15;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_15;

fn function_() {
    var phi_74_: vec4<f32>;
    var phi_77_: u32;
    var phi_89_: f32;
    var phi_95_: f32;
    var phi_101_: f32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: u32;

    let _e14 = global;
    let _e15 = global_1;
    let _e16 = global_2;
    let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
    let _e27 = global_3.member.member_1;
    let _e30 = global_3.member.member;
    if (_e24 < (_e27 * _e30)) {
        let _e33 = (_e24 * _e30);
        phi_74_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_77_ = _e33;
        loop {
            let _e36 = phi_74_;
            let _e38 = phi_77_;
            local = _e36;
            if (_e38 < (_e33 + _e30)) {
                let _e42 = global_4.member[_e38];
                if (_e42.x < 0f) {
                    phi_89_ = -(_e42.x);
                } else {
                    phi_89_ = _e42.x;
                }
                let _e47 = phi_89_;
                if (_e42.y < 0f) {
                    phi_95_ = -(_e42.y);
                } else {
                    phi_95_ = _e42.y;
                }
                let _e52 = phi_95_;
                if (_e42.z < 0f) {
                    phi_101_ = -(_e42.z);
                } else {
                    phi_101_ = _e42.z;
                }
                let _e58 = phi_101_;
                let _e62 = global_5.member[_e38];
                local_1 = vec4<f32>((_e36.x + ((_e47 + _e52) + _e58)), (_e36.y + _e62), (_e36.z + (((_e42.x * _e42.x) + (_e42.y * _e42.y)) + (_e42.z * _e42.z))), (_e36.w + _e42.w));
                local_2 = (_e38 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e85 = local_1;
                phi_74_ = _e85;
                let _e88 = local_2;
                phi_77_ = _e88;
            }
        }
        let _e82 = local;
        global_6.member[_e24] = _e82;
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
