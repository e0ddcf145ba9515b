struct type_6 {
    member: array<i32>,
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
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_6;
@group(0) @binding(0) 
var<uniform> global_4: type_21;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_12;
@group(0) @binding(2) 
var<storage> global_7: type_17;

fn function_() {
    var phi_95_: u32;
    var phi_98_: u32;
    var phi_129_: bool;
    var phi_136_: u32;
    var phi_99_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;

    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
    let _e33 = global_4.member.member_1;
    if (_e30 < _e33) {
        let _e36 = (_e21.z * 4u);
        let _e39 = global_3.member[_e36];
        let _e44 = global_3.member[(_e36 + 1u)];
        let _e48 = global_3.member[(_e36 + 2u)];
        let _e49 = f32(_e44);
        let _e50 = f32(_e48);
        let _e53 = global_4.member.member_2;
        let _e54 = f32(_e53);
        let _e57 = global_4.member.member;
        phi_95_ = 0u;
        phi_98_ = 0u;
        loop {
            let _e60 = phi_95_;
            let _e62 = phi_98_;
            local = _e62;
            local_1 = _e62;
            if (_e60 < 32u) {
                let _e65 = ((_e30 * 32u) + _e60);
                if (_e65 < _e57) {
                    let _e71 = global_7.member[(2u * ((bitcast<u32>(_e39) * _e57) + _e65))];
                    let _e76 = ((_e71.z * 1.001f) + 0.01f);
                    if (_e71.z >= 0f) {
                        let _e78 = (_e49 + _e54);
                        let _e80 = select(_e49, _e71.x, (_e71.x > _e49));
                        let _e83 = (_e71.x - select(_e78, _e80, (_e80 < _e78)));
                        let _e84 = (_e50 + _e54);
                        let _e86 = select(_e50, _e71.y, (_e71.y > _e50));
                        let _e89 = (_e71.y - select(_e84, _e86, (_e86 < _e84)));
                        phi_129_ = (((_e83 * _e83) + (_e89 * _e89)) <= (_e76 * _e76));
                    } else {
                        phi_129_ = false;
                    }
                    let _e96 = phi_129_;
                    if _e96 {
                        phi_136_ = (_e62 | (1u << bitcast<u32>((_e60 & 31u))));
                    } else {
                        phi_136_ = _e62;
                    }
                    let _e102 = phi_136_;
                    phi_99_ = _e102;
                } else {
                    phi_99_ = _e62;
                }
                let _e104 = phi_99_;
                local_2 = (_e60 + 1u);
                local_3 = _e104;
                continue;
            } else {
                break;
            }
            continuing {
                let _e119 = local_2;
                phi_95_ = _e119;
                let _e122 = local_3;
                phi_98_ = _e122;
            }
        }
        let _e107 = ((_e21.z * _e33) + _e30);
        let _e111 = local;
        global_5.member[_e107] = _e111;
        let _e113 = local_1;
        global_6.member[_e107] = countOneBits(_e113);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_mask(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
