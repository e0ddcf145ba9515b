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
@group(0) @binding(2) 
var<storage> global_5: type_12;
@group(0) @binding(3) 
var<storage> global_6: type_12;
@group(0) @binding(4) 
var<storage> global_7: type_17;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_12;

fn function_() {
    var phi_80_: u32;
    var phi_83_: u32;
    var local: u32;
    var phi_118_: u32;
    var phi_127_: u32;
    var phi_129_: u32;
    var phi_132_: u32;
    var phi_164_: f32;
    var phi_179_: f32;
    var phi_182_: bool;
    var phi_183_: bool;
    var phi_184_: bool;
    var phi_133_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    let _e24 = global;
    let _e25 = global_1;
    let _e26 = global_2;
    let _e34 = (((_e25.x + (_e25.y * _e26.x)) * 64u) + _e24.x);
    let _e37 = global_4.member.member;
    if (_e34 < _e37) {
        let _e41 = global_4.member.member_1;
        phi_80_ = _e41;
        phi_83_ = 0u;
        loop {
            let _e43 = phi_80_;
            let _e45 = phi_83_;
            local = _e45;
            if ((_e45 + 1u) < _e43) {
                let _e49 = ((_e45 + _e43) / 2u);
                let _e52 = global_5.member[_e49];
                let _e53 = (_e52 <= _e34);
                local_2 = select(_e49, _e43, _e53);
                local_3 = select(_e45, _e49, _e53);
                continue;
            } else {
                break;
            }
            continuing {
                let _e163 = local_2;
                phi_80_ = _e163;
                let _e166 = local_3;
                phi_83_ = _e166;
            }
        }
        let _e57 = local;
        let _e58 = (_e57 * 4u);
        let _e62 = global_3.member[(_e58 + 1u)];
        let _e66 = global_3.member[(_e58 + 2u)];
        let _e69 = global_6.member[_e34];
        let _e70 = (_e69 * 3u);
        let _e73 = global_7.member[_e70];
        let _e77 = global_7.member[(_e70 + 1u)];
        let _e80 = global_4.member.member_2;
        let _e81 = (_e80 / 64u);
        if ((_e80 % 64u) > 0u) {
            phi_118_ = (_e81 + 1u);
        } else {
            phi_118_ = _e81;
        }
        let _e86 = phi_118_;
        let _e87 = (_e86 * 16u);
        let _e88 = (_e80 / 8u);
        if ((_e80 % 8u) > 0u) {
            phi_127_ = (_e88 + 1u);
        } else {
            phi_127_ = _e88;
        }
        let _e93 = phi_127_;
        phi_129_ = 0u;
        phi_132_ = 0u;
        loop {
            let _e95 = phi_129_;
            let _e97 = phi_132_;
            local_1 = _e97;
            if (_e95 < 32u) {
                let _e100 = ((_e95 % 4u) * _e87);
                let _e102 = ((_e95 / 4u) * _e93);
                let _e110 = (f32((_e66 + bitcast<i32>(_e102))) + 0.5f);
                let _e122 = (f32((_e66 + bitcast<i32>(((_e102 + _e93) - 1u)))) + 0.5f);
                if (_e73.y < _e110) {
                    phi_164_ = _e110;
                } else {
                    phi_164_ = select(_e73.y, _e122, (_e73.y > _e122));
                }
                let _e128 = phi_164_;
                if (((f32((_e62 + bitcast<i32>(_e100))) + 0.5f) - _e73.x) > _e73.w) {
                    phi_183_ = bool();
                    phi_184_ = true;
                } else {
                    let _e134 = ((_e73.x - (f32((_e62 + bitcast<i32>(((_e100 + _e87) - 1u)))) + 0.5f)) > _e73.w);
                    if _e134 {
                        phi_182_ = bool();
                    } else {
                        let _e135 = (_e128 - _e73.y);
                        if (_e135 < 0f) {
                            phi_179_ = -(_e135);
                        } else {
                            phi_179_ = _e135;
                        }
                        let _e139 = phi_179_;
                        phi_182_ = (_e139 > _e77.w);
                    }
                    let _e143 = phi_182_;
                    phi_183_ = _e143;
                    phi_184_ = _e134;
                }
                let _e145 = phi_183_;
                let _e147 = phi_184_;
                if !(select(_e145, true, _e147)) {
                    phi_133_ = (_e97 | (1u << bitcast<u32>((_e95 & 31u))));
                } else {
                    phi_133_ = _e97;
                }
                let _e155 = phi_133_;
                local_4 = (_e95 + 1u);
                local_5 = _e155;
                continue;
            } else {
                break;
            }
            continuing {
                let _e172 = local_4;
                phi_129_ = _e172;
                let _e175 = local_5;
                phi_132_ = _e175;
            }
        }
        let _e160 = local_1;
        global_8.member[_e34] = _e160;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_cells(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
