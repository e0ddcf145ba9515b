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
    var phi_71_: u32;
    var phi_96_: f32;
    var phi_99_: f32;
    var phi_101_: f32;
    var phi_103_: f32;
    var phi_105_: u32;
    var phi_107_: u32;
    var phi_143_: f32;
    var phi_150_: f32;
    var phi_157_: f32;
    var phi_158_: f32;
    var phi_159_: f32;
    var phi_160_: f32;
    var phi_161_: f32;
    var phi_97_: f32;
    var phi_100_: f32;
    var phi_102_: f32;
    var phi_104_: f32;
    var phi_106_: u32;
    var phi_108_: u32;
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
            let _e34 = (_e33 / 4u);
            if ((_e33 % 4u) > 0u) {
                phi_71_ = (_e34 + 1u);
            } else {
                phi_71_ = _e34;
            }
            let _e39 = phi_71_;
            let _e42 = global_3.member.member_2;
            if (_e30 < (_e42 * _e39)) {
                let _e45 = (_e39 == 0u);
                if _e45 {
                    break;
                }
                let _e46 = (_e30 / _e39);
                if _e45 {
                    break;
                }
                let _e48 = ((_e30 % _e39) * 4u);
                let _e50 = ((_e48 + 1u) < _e33);
                let _e52 = ((_e48 + 2u) < _e33);
                let _e54 = ((_e48 + 3u) < _e33);
                phi_96_ = 0f;
                phi_99_ = 0f;
                phi_101_ = 0f;
                phi_103_ = 0f;
                phi_105_ = 0u;
                phi_107_ = (_e46 / 32u);
                loop {
                    let _e58 = phi_96_;
                    let _e60 = phi_99_;
                    let _e62 = phi_101_;
                    let _e64 = phi_103_;
                    let _e66 = phi_105_;
                    let _e68 = phi_107_;
                    local = _e64;
                    local_1 = _e62;
                    local_2 = _e60;
                    local_3 = _e58;
                    let _e71 = global_3.member.member_1;
                    let _e72 = (_e66 < _e71);
                    if _e72 {
                        let _e75 = global_4.member[_e68];
                        let _e76 = ((_e46 % 32u) & 31u);
                        if (((_e75 >> bitcast<u32>(_e76)) & 1u) == 0u) {
                            phi_158_ = _e58;
                            phi_159_ = _e60;
                            phi_160_ = _e62;
                            phi_161_ = _e64;
                        } else {
                            let _e83 = global_5.member[_e68];
                            let _e91 = (((_e83 + countOneBits((_e75 & ((1u << bitcast<u32>(_e76)) - 1u)))) * _e33) + _e48);
                            let _e94 = global_6.member[_e91];
                            if _e50 {
                                let _e99 = global_6.member[(_e91 + 1u)];
                                phi_143_ = (_e62 + _e99);
                            } else {
                                phi_143_ = _e62;
                            }
                            let _e102 = phi_143_;
                            if _e52 {
                                let _e106 = global_6.member[(_e91 + 2u)];
                                phi_150_ = (_e60 + _e106);
                            } else {
                                phi_150_ = _e60;
                            }
                            let _e109 = phi_150_;
                            if _e54 {
                                let _e113 = global_6.member[(_e91 + 3u)];
                                phi_157_ = (_e58 + _e113);
                            } else {
                                phi_157_ = _e58;
                            }
                            let _e116 = phi_157_;
                            phi_158_ = _e116;
                            phi_159_ = _e109;
                            phi_160_ = _e102;
                            phi_161_ = (_e64 + _e94);
                        }
                        let _e118 = phi_158_;
                        let _e120 = phi_159_;
                        let _e122 = phi_160_;
                        let _e124 = phi_161_;
                        let _e127 = global_3.member.member;
                        phi_97_ = _e118;
                        phi_100_ = _e120;
                        phi_102_ = _e122;
                        phi_104_ = _e124;
                        phi_106_ = (_e66 + 1u);
                        phi_108_ = (_e68 + _e127);
                    } else {
                        phi_97_ = f32();
                        phi_100_ = f32();
                        phi_102_ = f32();
                        phi_104_ = f32();
                        phi_106_ = u32();
                        phi_108_ = u32();
                    }
                    let _e131 = phi_97_;
                    let _e133 = phi_100_;
                    let _e135 = phi_102_;
                    let _e137 = phi_104_;
                    let _e139 = phi_106_;
                    let _e141 = phi_108_;
                    continue;
                    continuing {
                        phi_96_ = _e131;
                        phi_99_ = _e133;
                        phi_101_ = _e135;
                        phi_103_ = _e137;
                        phi_105_ = _e139;
                        phi_107_ = _e141;
                        break if !(_e72);
                    }
                }
                let _e144 = ((_e46 * _e33) + _e48);
                let _e147 = global_7.member[_e144];
                let _e149 = local;
                global_7.member[_e144] = (_e147 + _e149);
                if _e50 {
                    let _e154 = global_7.member[(_e144 + 1u)];
                    let _e156 = local_1;
                    global_7.member[(_e144 + 1u)] = (_e154 + _e156);
                }
                if _e52 {
                    let _e161 = global_7.member[(_e144 + 2u)];
                    let _e163 = local_2;
                    global_7.member[(_e144 + 2u)] = (_e161 + _e163);
                }
                if _e54 {
                    let _e168 = global_7.member[(_e144 + 3u)];
                    let _e170 = local_3;
                    global_7.member[(_e144 + 3u)] = (_e168 + _e170);
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
