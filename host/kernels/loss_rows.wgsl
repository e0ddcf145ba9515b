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
    var phi_92_: f32;
    var phi_98_: f32;
    var phi_104_: f32;
    var phi_75_: vec4<f32>;
    var phi_78_: u32;
    var local: vec4<f32>;

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
            let _e39 = (_e38 < (_e33 + _e30));
            if _e39 {
                let _e42 = global_4.member[_e38];
                if (_e42.x < 0f) {
                    phi_92_ = -(_e42.x);
                } else {
                    phi_92_ = _e42.x;
                }
                let _e47 = phi_92_;
                if (_e42.y < 0f) {
                    phi_98_ = -(_e42.y);
                } else {
                    phi_98_ = _e42.y;
                }
                let _e52 = phi_98_;
                if (_e42.z < 0f) {
                    phi_104_ = -(_e42.z);
                } else {
                    phi_104_ = _e42.z;
                }
                let _e58 = phi_104_;
                let _e62 = global_5.member[_e38];
                phi_75_ = vec4<f32>((_e36.x + ((_e47 + _e52) + _e58)), (_e36.y + _e62), (_e36.z + (((_e42.x * _e42.x) + (_e42.y * _e42.y)) + (_e42.z * _e42.z))), (_e36.w + _e42.w));
                phi_78_ = (_e38 + 1u);
            } else {
                phi_75_ = vec4<f32>();
                phi_78_ = u32();
            }
            let _e80 = phi_75_;
            let _e82 = phi_78_;
            continue;
            continuing {
                phi_74_ = _e80;
                phi_77_ = _e82;
                break if !(_e39);
            }
        }
        let _e87 = local;
        global_6.member[_e24] = _e87;
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
