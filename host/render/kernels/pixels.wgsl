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
    var phi_133_: u32;
    var phi_142_: f32;
    var phi_143_: f32;
    var phi_155_: u32;
    var phi_166_: f32;
    var phi_167_: f32;
    var phi_179_: u32;

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
                let _e87 = select(select(u32(_e82), 0u, (_e82 < 0f)), 4294967295u, (_e82 > 4294967000f));
                if (_e82 >= (f32(_e87) + 0.5f)) {
                    phi_133_ = (_e87 + 1u);
                } else {
                    phi_133_ = _e87;
                }
                let _e93 = phi_133_;
                if (_e54 >= 1f) {
                    phi_143_ = 255f;
                } else {
                    if (_e54 > 0f) {
                        phi_142_ = (_e54 * 255f);
                    } else {
                        phi_142_ = 0f;
                    }
                    let _e98 = phi_142_;
                    phi_143_ = _e98;
                }
                let _e100 = phi_143_;
                let _e105 = select(select(u32(_e100), 0u, (_e100 < 0f)), 4294967295u, (_e100 > 4294967000f));
                if (_e100 >= (f32(_e105) + 0.5f)) {
                    phi_155_ = (_e105 + 1u);
                } else {
                    phi_155_ = _e105;
                }
                let _e111 = phi_155_;
                if (_e59 >= 1f) {
                    phi_167_ = 255f;
                } else {
                    if (_e59 > 0f) {
                        phi_166_ = (_e59 * 255f);
                    } else {
                        phi_166_ = 0f;
                    }
                    let _e119 = phi_166_;
                    phi_167_ = _e119;
                }
                let _e121 = phi_167_;
                let _e126 = select(select(u32(_e121), 0u, (_e121 < 0f)), 4294967295u, (_e121 > 4294967000f));
                if (_e121 >= (f32(_e126) + 0.5f)) {
                    phi_179_ = (_e126 + 1u);
                } else {
                    phi_179_ = _e126;
                }
                let _e132 = phi_179_;
                global_5.member[_e34] = (((_e93 | (_e111 << bitcast<u32>(8i))) | (_e132 << bitcast<u32>(16i))) | select(4278190080u, 0u, select(_e73, true, _e71)));
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
