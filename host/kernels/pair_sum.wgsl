struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_15;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_90_: f32;
    var phi_93_: f32;
    var phi_95_: f32;
    var phi_97_: f32;
    var phi_99_: u32;
    var phi_101_: u32;
    var phi_137_: f32;
    var phi_144_: f32;
    var phi_151_: f32;
    var phi_152_: f32;
    var phi_153_: f32;
    var phi_154_: f32;
    var phi_155_: f32;
    var phi_91_: f32;
    var phi_94_: f32;
    var phi_96_: f32;
    var phi_98_: f32;
    var phi_100_: u32;
    var phi_102_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global;
            let _e21 = global_1;
            let _e22 = global_2;
            let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
            let _e33 = global_3.member.member_3;
            let _e35 = ((_e33 + 3u) / 4u);
            let _e38 = global_3.member.member_2;
            if (_e30 < (_e38 * _e35)) {
                let _e41 = (_e35 == 0u);
                if _e41 {
                    break;
                }
                let _e42 = (_e30 / _e35);
                if _e41 {
                    break;
                }
                let _e44 = ((_e30 % _e35) * 4u);
                let _e46 = ((_e44 + 1u) < _e33);
                let _e48 = ((_e44 + 2u) < _e33);
                let _e50 = ((_e44 + 3u) < _e33);
                phi_90_ = 0f;
                phi_93_ = 0f;
                phi_95_ = 0f;
                phi_97_ = 0f;
                phi_99_ = 0u;
                phi_101_ = (_e42 / 32u);
                loop {
                    let _e54 = phi_90_;
                    let _e56 = phi_93_;
                    let _e58 = phi_95_;
                    let _e60 = phi_97_;
                    let _e62 = phi_99_;
                    let _e64 = phi_101_;
                    local = _e60;
                    local_1 = _e58;
                    local_2 = _e56;
                    local_3 = _e54;
                    let _e67 = global_3.member.member_1;
                    let _e68 = (_e62 < _e67);
                    if _e68 {
                        let _e71 = global_4.member[_e64];
                        let _e72 = ((_e42 % 32u) & 31u);
                        if (((_e71 >> bitcast<u32>(_e72)) & 1u) == 0u) {
                            phi_152_ = _e54;
                            phi_153_ = _e56;
                            phi_154_ = _e58;
                            phi_155_ = _e60;
                        } else {
                            let _e79 = global_5.member[_e64];
                            let _e87 = (((_e79 + countOneBits((_e71 & ((1u << bitcast<u32>(_e72)) - 1u)))) * _e33) + _e44);
                            let _e90 = global_6.member[_e87];
                            if _e46 {
                                let _e95 = global_6.member[(_e87 + 1u)];
                                phi_137_ = (_e58 + _e95);
                            } else {
                                phi_137_ = _e58;
                            }
                            let _e98 = phi_137_;
                            if _e48 {
                                let _e102 = global_6.member[(_e87 + 2u)];
                                phi_144_ = (_e56 + _e102);
                            } else {
                                phi_144_ = _e56;
                            }
                            let _e105 = phi_144_;
                            if _e50 {
                                let _e109 = global_6.member[(_e87 + 3u)];
                                phi_151_ = (_e54 + _e109);
                            } else {
                                phi_151_ = _e54;
                            }
                            let _e112 = phi_151_;
                            phi_152_ = _e112;
                            phi_153_ = _e105;
                            phi_154_ = _e98;
                            phi_155_ = (_e60 + _e90);
                        }
                        let _e114 = phi_152_;
                        let _e116 = phi_153_;
                        let _e118 = phi_154_;
                        let _e120 = phi_155_;
                        let _e123 = global_3.member.member;
                        phi_91_ = _e114;
                        phi_94_ = _e116;
                        phi_96_ = _e118;
                        phi_98_ = _e120;
                        phi_100_ = (_e62 + 1u);
                        phi_102_ = (_e64 + _e123);
                    } else {
                        phi_91_ = f32();
                        phi_94_ = f32();
                        phi_96_ = f32();
                        phi_98_ = f32();
                        phi_100_ = u32();
                        phi_102_ = u32();
                    }
                    let _e127 = phi_91_;
                    let _e129 = phi_94_;
                    let _e131 = phi_96_;
                    let _e133 = phi_98_;
                    let _e135 = phi_100_;
                    let _e137 = phi_102_;
                    continue;
                    continuing {
                        phi_90_ = _e127;
                        phi_93_ = _e129;
                        phi_95_ = _e131;
                        phi_97_ = _e133;
                        phi_99_ = _e135;
                        phi_101_ = _e137;
                        break if !(_e68);
                    }
                }
                let _e140 = ((_e42 * _e33) + _e44);
                let _e143 = global_7.member[_e140];
                let _e145 = local;
                global_7.member[_e140] = (_e143 + _e145);
                if _e46 {
                    let _e150 = global_7.member[(_e140 + 1u)];
                    let _e152 = local_1;
                    global_7.member[(_e140 + 1u)] = (_e150 + _e152);
                }
                if _e48 {
                    let _e157 = global_7.member[(_e140 + 2u)];
                    let _e159 = local_2;
                    global_7.member[(_e140 + 2u)] = (_e157 + _e159);
                }
                if _e50 {
                    let _e164 = global_7.member[(_e140 + 3u)];
                    let _e166 = local_3;
                    global_7.member[(_e140 + 3u)] = (_e164 + _e166);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
