struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_16;

fn function_() {
    var phi_106_: bool;
    var phi_108_: bool;
    var phi_109_: bool;
    var phi_120_: f32;
    var phi_121_: f32;
    var phi_136_: u32;
    var phi_145_: f32;
    var phi_146_: f32;
    var phi_159_: u32;
    var phi_170_: f32;
    var phi_171_: f32;
    var phi_184_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e25 = global_1;
            let _e26 = global_2;
            let _e34 = (((_e25.x + (_e25.y * _e26.x)) * 64u) + _e24.x);
            let _e37 = global_3.member.member;
            if (_e34 < _e37) {
                let _e41 = global_3.member.member_1;
                let _e42 = (_e41 == 0u);
                if _e42 {
                    break;
                }
                if _e42 {
                    break;
                }
                let _e47 = (((_e34 / _e41) * (3u * _e41)) + (_e34 % _e41));
                let _e50 = global_4.member[_e47];
                let _e54 = global_4.member[(_e47 + _e41)];
                let _e59 = global_4.member[(_e47 + (2u * _e41))];
                if (abs(_e50) <= 0x1.fffffep+127f) {
                    let _e63 = (abs(_e54) <= 0x1.fffffep+127f);
                    if _e63 {
                        phi_106_ = select(true, false, (abs(_e59) <= 0x1.fffffep+127f));
                    } else {
                        phi_106_ = false;
                    }
                    let _e68 = phi_106_;
                    phi_108_ = select(true, false, _e63);
                    phi_109_ = _e68;
                } else {
                    phi_108_ = true;
                    phi_109_ = false;
                }
                let _e71 = phi_108_;
                let _e73 = phi_109_;
                if (_e50 >= 1f) {
                    phi_121_ = 255f;
                } else {
                    if (_e50 > 0f) {
                        phi_120_ = (_e50 * 255f);
                    } else {
                        phi_120_ = 0f;
                    }
                    let _e80 = phi_120_;
                    phi_121_ = _e80;
                }
                let _e82 = phi_121_;
                let _e83 = bitcast<f32>(0u);
                let _e84 = bitcast<f32>(1333788671u);
                let _e90 = select(select(u32(_e82), 0u, !((_e82 >= _e83))), 4294967295u, (_e82 > _e84));
                if (_e82 >= (f32(_e90) + 0.5f)) {
                    phi_136_ = (_e90 + 1u);
                } else {
                    phi_136_ = _e90;
                }
                let _e96 = phi_136_;
                if (_e54 >= 1f) {
                    phi_146_ = 255f;
                } else {
                    if (_e54 > 0f) {
                        phi_145_ = (_e54 * 255f);
                    } else {
                        phi_145_ = 0f;
                    }
                    let _e101 = phi_145_;
                    phi_146_ = _e101;
                }
                let _e103 = phi_146_;
                let _e109 = select(select(u32(_e103), 0u, !((_e103 >= _e83))), 4294967295u, (_e103 > _e84));
                if (_e103 >= (f32(_e109) + 0.5f)) {
                    phi_159_ = (_e109 + 1u);
                } else {
                    phi_159_ = _e109;
                }
                let _e115 = phi_159_;
                if (_e59 >= 1f) {
                    phi_171_ = 255f;
                } else {
                    if (_e59 > 0f) {
                        phi_170_ = (_e59 * 255f);
                    } else {
                        phi_170_ = 0f;
                    }
                    let _e123 = phi_170_;
                    phi_171_ = _e123;
                }
                let _e125 = phi_171_;
                let _e131 = select(select(u32(_e125), 0u, !((_e125 >= _e83))), 4294967295u, (_e125 > _e84));
                if (_e125 >= (f32(_e131) + 0.5f)) {
                    phi_184_ = (_e131 + 1u);
                } else {
                    phi_184_ = _e131;
                }
                let _e137 = phi_184_;
                global_5.member[_e34] = (((_e96 | (_e115 << bitcast<u32>(8i))) | (_e137 << bitcast<u32>(16i))) | select(4278190080u, 0u, select(_e73, true, _e71)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pixels(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
