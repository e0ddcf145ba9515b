struct type_6 {
    member: array<vec4<f32>>,
}

struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_12 {
    member: type_11,
}

struct type_15 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_12;
@group(0) @binding(1) 
var<storage> global_4: type_6;
@group(0) @binding(2) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_15;
@group(0) @binding(4) 
var<storage> global_7: type_6;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_6;

fn function_() {
    var phi_73_: u32;
    var phi_76_: f32;
    var phi_78_: f32;
    var phi_80_: f32;
    var phi_121_: f32;
    var phi_122_: f32;
    var phi_123_: f32;
    var phi_74_: u32;
    var phi_77_: f32;
    var phi_79_: f32;
    var phi_81_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;

    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
    let _e33 = global_3.member.member;
    if (_e30 < _e33) {
        let _e39 = (1u << bitcast<u32>(((_e30 % 32u) & 31u)));
        phi_73_ = 0u;
        phi_76_ = 0f;
        phi_78_ = 0f;
        phi_80_ = 0f;
        loop {
            let _e41 = phi_73_;
            let _e43 = phi_76_;
            let _e45 = phi_78_;
            let _e47 = phi_80_;
            local = _e45;
            local_1 = _e47;
            local_2 = _e45;
            local_3 = _e43;
            local_4 = _e43;
            let _e50 = global_3.member.member_2;
            let _e51 = (_e41 < _e50);
            if _e51 {
                let _e54 = global_3.member.member_1;
                let _e56 = ((_e41 * _e54) + (_e30 / 32u));
                let _e59 = global_5.member[_e56];
                if ((_e59 & _e39) == 0u) {
                    phi_121_ = _e43;
                    phi_122_ = _e45;
                    phi_123_ = _e47;
                } else {
                    let _e67 = global_6.member[_e56];
                    let _e72 = global_7.member[(3u * (_e67 + countOneBits((_e59 & (_e39 - 1u)))))];
                    let _e86 = global_4.member[(2u * ((_e41 * _e33) + _e30))];
                    phi_121_ = select(_e86.z, _e43, (_e43 > _e86.z));
                    phi_122_ = (_e45 + 1f);
                    phi_123_ = (_e47 + sqrt(((_e72.x * _e72.x) + (_e72.y * _e72.y))));
                }
                let _e91 = phi_121_;
                let _e93 = phi_122_;
                let _e95 = phi_123_;
                phi_74_ = (_e41 + 1u);
                phi_77_ = _e91;
                phi_79_ = _e93;
                phi_81_ = _e95;
            } else {
                phi_74_ = u32();
                phi_77_ = f32();
                phi_79_ = f32();
                phi_81_ = f32();
            }
            let _e98 = phi_74_;
            let _e100 = phi_77_;
            let _e102 = phi_79_;
            let _e104 = phi_81_;
            continue;
            continuing {
                phi_73_ = _e98;
                phi_76_ = _e100;
                phi_78_ = _e102;
                phi_80_ = _e104;
                break if !(_e51);
            }
        }
        let _e107 = local;
        if (_e107 > 0f) {
            let _e111 = global_8.member[_e30];
            let _e114 = local_1;
            let _e118 = local_2;
            let _e122 = local_3;
            let _e125 = local_4;
            global_8.member[_e30] = vec4<f32>((_e111.x + _e114), (_e111.y + _e118), select(_e125, _e111.z, (_e111.z > _e122)), _e111.w);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn statistics(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
