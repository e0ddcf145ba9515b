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
    var phi_81_: u32;
    var phi_84_: u32;
    var local: u32;
    var phi_123_: u32;
    var phi_132_: u32;
    var phi_134_: u32;
    var phi_137_: u32;
    var phi_172_: f32;
    var phi_187_: f32;
    var phi_190_: bool;
    var phi_191_: bool;
    var phi_192_: bool;
    var phi_201_: u32;
    var phi_135_: u32;
    var phi_138_: u32;
    var local_1: u32;

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
            let _e47 = ((_e45 + 1u) < _e43);
            if _e47 {
                let _e49 = ((_e45 + _e43) / 2u);
                let _e52 = global_5.member[_e49];
                let _e53 = (_e52 <= _e34);
                phi_81_ = select(_e49, _e43, _e53);
                phi_84_ = select(_e45, _e49, _e53);
            } else {
                phi_81_ = u32();
                phi_84_ = u32();
            }
            let _e57 = phi_81_;
            let _e59 = phi_84_;
            continue;
            continuing {
                phi_80_ = _e57;
                phi_83_ = _e59;
                break if !(_e47);
            }
        }
        let _e62 = local;
        let _e63 = (_e62 * 4u);
        let _e67 = global_3.member[(_e63 + 1u)];
        let _e71 = global_3.member[(_e63 + 2u)];
        let _e74 = global_6.member[_e34];
        let _e75 = (_e74 * 3u);
        let _e78 = global_7.member[_e75];
        let _e82 = global_7.member[(_e75 + 1u)];
        let _e85 = global_4.member.member_2;
        let _e86 = (_e85 / 64u);
        if ((_e85 % 64u) > 0u) {
            phi_123_ = (_e86 + 1u);
        } else {
            phi_123_ = _e86;
        }
        let _e91 = phi_123_;
        let _e92 = (_e91 * 16u);
        let _e93 = (_e85 / 8u);
        if ((_e85 % 8u) > 0u) {
            phi_132_ = (_e93 + 1u);
        } else {
            phi_132_ = _e93;
        }
        let _e98 = phi_132_;
        phi_134_ = 0u;
        phi_137_ = 0u;
        loop {
            let _e100 = phi_134_;
            let _e102 = phi_137_;
            local_1 = _e102;
            let _e103 = (_e100 < 32u);
            if _e103 {
                let _e105 = ((_e100 % 4u) * _e92);
                let _e107 = ((_e100 / 4u) * _e98);
                let _e115 = (f32((_e71 + bitcast<i32>(_e107))) + 0.5f);
                let _e127 = (f32((_e71 + bitcast<i32>(((_e107 + _e98) - 1u)))) + 0.5f);
                if (_e78.y < _e115) {
                    phi_172_ = _e115;
                } else {
                    phi_172_ = select(_e78.y, _e127, (_e78.y > _e127));
                }
                let _e133 = phi_172_;
                if (((f32((_e67 + bitcast<i32>(_e105))) + 0.5f) - _e78.x) > _e78.w) {
                    phi_191_ = bool();
                    phi_192_ = true;
                } else {
                    let _e139 = ((_e78.x - (f32((_e67 + bitcast<i32>(((_e105 + _e92) - 1u)))) + 0.5f)) > _e78.w);
                    if _e139 {
                        phi_190_ = bool();
                    } else {
                        let _e140 = (_e133 - _e78.y);
                        if (_e140 < 0f) {
                            phi_187_ = -(_e140);
                        } else {
                            phi_187_ = _e140;
                        }
                        let _e144 = phi_187_;
                        phi_190_ = (_e144 > _e82.w);
                    }
                    let _e148 = phi_190_;
                    phi_191_ = _e148;
                    phi_192_ = _e139;
                }
                let _e150 = phi_191_;
                let _e152 = phi_192_;
                if !(select(_e150, true, _e152)) {
                    phi_201_ = (_e102 | (1u << bitcast<u32>((_e100 & 31u))));
                } else {
                    phi_201_ = _e102;
                }
                let _e160 = phi_201_;
                phi_135_ = (_e100 + 1u);
                phi_138_ = _e160;
            } else {
                phi_135_ = u32();
                phi_138_ = u32();
            }
            let _e163 = phi_135_;
            let _e165 = phi_138_;
            continue;
            continuing {
                phi_134_ = _e163;
                phi_137_ = _e165;
                break if !(_e103);
            }
        }
        let _e170 = local_1;
        global_8.member[_e34] = _e170;
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
