struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<i32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_10;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_10;

fn function_() {
    var phi_78_: u32;
    var phi_81_: u32;
    var local: u32;
    var phi_116_: u32;
    var phi_125_: u32;
    var phi_127_: u32;
    var phi_130_: u32;
    var phi_162_: f32;
    var phi_176_: bool;
    var phi_177_: bool;
    var phi_178_: bool;
    var phi_131_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    let _e22 = global;
    let _e23 = global_1;
    let _e24 = global_2;
    let _e32 = (((_e23.x + (_e23.y * _e24.x)) * 64u) + _e22.x);
    let _e35 = global_3.member.member;
    if (_e32 < _e35) {
        let _e39 = global_3.member.member_1;
        phi_78_ = _e39;
        phi_81_ = 0u;
        loop {
            let _e41 = phi_78_;
            let _e43 = phi_81_;
            local = _e43;
            if ((_e43 + 1u) < _e41) {
                let _e47 = ((_e43 + _e41) / 2u);
                let _e50 = global_4.member[_e47];
                let _e51 = (_e50 <= _e32);
                local_2 = select(_e47, _e41, _e51);
                local_3 = select(_e43, _e47, _e51);
                continue;
            } else {
                break;
            }
            continuing {
                let _e158 = local_2;
                phi_78_ = _e158;
                let _e161 = local_3;
                phi_81_ = _e161;
            }
        }
        let _e55 = local;
        let _e56 = (_e55 * 4u);
        let _e60 = global_5.member[(_e56 + 1u)];
        let _e64 = global_5.member[(_e56 + 2u)];
        let _e67 = global_6.member[_e32];
        let _e68 = (_e67 * 3u);
        let _e71 = global_7.member[_e68];
        let _e75 = global_7.member[(_e68 + 1u)];
        let _e78 = global_3.member.member_2;
        let _e79 = (_e78 / 64u);
        if ((_e78 % 64u) > 0u) {
            phi_116_ = (_e79 + 1u);
        } else {
            phi_116_ = _e79;
        }
        let _e84 = phi_116_;
        let _e85 = (_e84 * 16u);
        let _e86 = (_e78 / 8u);
        if ((_e78 % 8u) > 0u) {
            phi_125_ = (_e86 + 1u);
        } else {
            phi_125_ = _e86;
        }
        let _e91 = phi_125_;
        phi_127_ = 0u;
        phi_130_ = 0u;
        loop {
            let _e93 = phi_127_;
            let _e95 = phi_130_;
            local_1 = _e95;
            if (_e93 < 32u) {
                let _e98 = ((_e93 % 4u) * _e85);
                let _e100 = ((_e93 / 4u) * _e91);
                let _e108 = (f32((_e64 + bitcast<i32>(_e100))) + 0.5f);
                let _e120 = (f32((_e64 + bitcast<i32>(((_e100 + _e91) - 1u)))) + 0.5f);
                if (_e71.y < _e108) {
                    phi_162_ = _e108;
                } else {
                    phi_162_ = select(_e71.y, _e120, (_e71.y > _e120));
                }
                let _e126 = phi_162_;
                if (((f32((_e60 + bitcast<i32>(_e98))) + 0.5f) - _e71.x) > _e71.w) {
                    phi_177_ = bool();
                    phi_178_ = true;
                } else {
                    let _e132 = ((_e71.x - (f32((_e60 + bitcast<i32>(((_e98 + _e85) - 1u)))) + 0.5f)) > _e71.w);
                    if _e132 {
                        phi_176_ = bool();
                    } else {
                        phi_176_ = (abs((_e126 - _e71.y)) > _e75.w);
                    }
                    let _e138 = phi_176_;
                    phi_177_ = _e138;
                    phi_178_ = _e132;
                }
                let _e140 = phi_177_;
                let _e142 = phi_178_;
                if !(select(_e140, true, _e142)) {
                    phi_131_ = (_e95 | (1u << bitcast<u32>((_e93 & 31u))));
                } else {
                    phi_131_ = _e95;
                }
                let _e150 = phi_131_;
                local_4 = (_e93 + 1u);
                local_5 = _e150;
                continue;
            } else {
                break;
            }
            continuing {
                let _e167 = local_4;
                phi_127_ = _e167;
                let _e170 = local_5;
                phi_130_ = _e170;
            }
        }
        let _e155 = local_1;
        global_8.member[_e32] = _e155;
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
