struct type_6 {
    member: array<i32>,
}

struct type_9 {
    member: array<f32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: type_15,
}

struct type_19 {
    member: array<u32>,
}

struct type_25 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_2: type_6;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(2) 
var<storage> global_4: type_19;
@group(0) @binding(3) 
var<storage> global_5: type_19;
@group(0) @binding(4) 
var<storage> global_6: type_19;
@group(0) @binding(5) 
var<storage> global_7: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_9;

fn function_() {
    var phi_110_: bool;
    var phi_162_: f32;
    var phi_163_: f32;
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_173_: u32;
    var phi_182_: u32;
    var phi_196_: f32;
    var phi_199_: f32;
    var phi_201_: f32;
    var phi_203_: f32;
    var phi_205_: u32;
    var phi_211_: u32;
    var phi_197_: f32;
    var phi_200_: f32;
    var phi_202_: f32;
    var phi_204_: f32;
    var phi_252_: f32;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: u32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e39 = ((_e30.x * 16u) + _e29.x);
            let _e41 = ((_e30.y * 4u) + _e29.y);
            let _e44 = global_3.member.member;
            if (_e39 < _e44) {
                phi_110_ = (_e41 < _e44);
            } else {
                phi_110_ = false;
            }
            let _e48 = phi_110_;
            if _e48 {
                let _e49 = select(0u, _e41, _e48);
                let _e50 = select(0u, _e39, _e48);
                let _e52 = (_e30.z * 4u);
                let _e56 = global_2.member[(_e52 + 1u)];
                let _e60 = global_2.member[(_e52 + 2u)];
                let _e64 = (f32((_e56 + bitcast<i32>(_e50))) + 0.5f);
                let _e68 = (f32((_e60 + bitcast<i32>(_e49))) + 0.5f);
                let _e71 = global_4.member[_e30.z];
                let _e74 = global_3.member.member_1;
                let _e75 = (_e71 + _e74);
                let _e79 = global_4.member[(_e30.z + 1u)];
                let _e80 = (_e75 + 16384u);
                let _e82 = select(_e80, _e79, (_e79 < _e80));
                let _e83 = (_e44 * _e44);
                let _e87 = (((_e52 * _e83) + (_e49 * _e44)) + _e50);
                if _e48 {
                    let _e90 = global_8.member[_e87];
                    let _e94 = global_8.member[(_e87 + _e83)];
                    let _e99 = global_8.member[(_e87 + (2u * _e83))];
                    let _e104 = global_8.member[(_e87 + (3u * _e83))];
                    phi_162_ = _e104;
                    phi_163_ = _e99;
                    phi_164_ = _e94;
                    phi_165_ = _e90;
                } else {
                    phi_162_ = 0f;
                    phi_163_ = 0f;
                    phi_164_ = 0f;
                    phi_165_ = 0f;
                }
                let _e106 = phi_162_;
                let _e108 = phi_163_;
                let _e110 = phi_164_;
                let _e112 = phi_165_;
                let _e113 = (_e44 / 64u);
                if ((_e44 % 64u) > 0u) {
                    phi_173_ = (_e113 + 1u);
                } else {
                    phi_173_ = _e113;
                }
                let _e118 = phi_173_;
                let _e119 = (_e118 * 16u);
                let _e120 = (_e44 / 8u);
                if ((_e44 % 8u) > 0u) {
                    phi_182_ = (_e120 + 1u);
                } else {
                    phi_182_ = _e120;
                }
                let _e125 = phi_182_;
                if (_e125 == 0u) {
                    break;
                }
                if (_e119 == 0u) {
                    break;
                }
                phi_196_ = _e106;
                phi_199_ = _e108;
                phi_201_ = _e110;
                phi_203_ = _e112;
                phi_205_ = _e75;
                loop {
                    let _e136 = phi_196_;
                    let _e138 = phi_199_;
                    let _e140 = phi_201_;
                    let _e142 = phi_203_;
                    let _e144 = phi_205_;
                    local = _e142;
                    local_1 = _e140;
                    local_2 = _e138;
                    local_3 = _e136;
                    if (_e144 < _e82) {
                        phi_211_ = 0u;
                        phi_197_ = _e136;
                        phi_200_ = _e138;
                        phi_202_ = _e140;
                        phi_204_ = _e142;
                        loop {
                            let _e148 = phi_211_;
                            let _e150 = phi_197_;
                            let _e152 = phi_200_;
                            let _e154 = phi_202_;
                            let _e156 = phi_204_;
                            local_4 = _e150;
                            local_5 = _e152;
                            local_6 = _e154;
                            local_7 = _e156;
                            if (_e148 < (_e82 - _e144)) {
                                let _e158 = (_e144 + _e148);
                                let _e160 = global_6.member[_e158];
                                if ((_e160 & (1u << bitcast<u32>(((((_e49 / _e125) * 4u) + (_e50 / _e119)) & 31u)))) == 0u) {
                                    phi_214_ = _e150;
                                    phi_215_ = _e152;
                                    phi_216_ = _e154;
                                    phi_217_ = _e156;
                                } else {
                                    let _e164 = global_5.member[_e158];
                                    let _e165 = (_e164 * 3u);
                                    let _e167 = global_7.member[_e165];
                                    let _e170 = global_7.member[(_e165 + 1u)];
                                    let _e172 = (_e64 - _e167.x);
                                    if (_e172 > _e167.w) {
                                        phi_256_ = bool();
                                        phi_257_ = true;
                                    } else {
                                        let _e176 = ((_e167.x - _e64) > _e167.w);
                                        if _e176 {
                                            phi_255_ = bool();
                                        } else {
                                            let _e178 = (_e68 - _e167.y);
                                            if (_e178 < 0f) {
                                                phi_252_ = -(_e178);
                                            } else {
                                                phi_252_ = _e178;
                                            }
                                            let _e182 = phi_252_;
                                            phi_255_ = (_e182 > _e170.w);
                                        }
                                        let _e186 = phi_255_;
                                        phi_256_ = _e186;
                                        phi_257_ = _e176;
                                    }
                                    let _e188 = phi_256_;
                                    let _e190 = phi_257_;
                                    if !(select(_e188, true, _e190)) {
                                        let _e194 = (_e68 - _e167.y);
                                        let _e199 = ((_e170.y * _e172) * _e194);
                                        let _e206 = ((((_e170.x * _e172) * _e172) + (_e199 + _e199)) + ((_e170.z * _e194) * _e194));
                                        let _e212 = (_e206 <= 11.082527f);
                                        let _e214 = (_e167.z * select(0f, exp((-0.5f * select(0f, _e206, (_e206 > 0f)))), _e212));
                                        let _e217 = global_7.member[(_e165 + 2u)];
                                        phi_283_ = (_e150 + select(0f, _e214, _e212));
                                        phi_284_ = (_e152 + select(0f, (_e214 * _e217.z), _e212));
                                        phi_285_ = (_e154 + select(0f, (_e214 * _e217.y), _e212));
                                        phi_286_ = (_e156 + select(0f, (_e214 * _e217.x), _e212));
                                    } else {
                                        phi_283_ = _e150;
                                        phi_284_ = _e152;
                                        phi_285_ = _e154;
                                        phi_286_ = _e156;
                                    }
                                    let _e233 = phi_283_;
                                    let _e235 = phi_284_;
                                    let _e237 = phi_285_;
                                    let _e239 = phi_286_;
                                    phi_214_ = _e233;
                                    phi_215_ = _e235;
                                    phi_216_ = _e237;
                                    phi_217_ = _e239;
                                }
                                let _e241 = phi_214_;
                                let _e243 = phi_215_;
                                let _e245 = phi_216_;
                                let _e247 = phi_217_;
                                local_8 = (_e148 + 1u);
                                local_9 = _e241;
                                local_10 = _e243;
                                local_11 = _e245;
                                local_12 = _e247;
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e292 = local_8;
                                phi_211_ = _e292;
                                let _e295 = local_9;
                                phi_197_ = _e295;
                                let _e298 = local_10;
                                phi_200_ = _e298;
                                let _e301 = local_11;
                                phi_202_ = _e301;
                                let _e304 = local_12;
                                phi_204_ = _e304;
                            }
                        }
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e279 = local_4;
                        phi_196_ = _e279;
                        let _e282 = local_5;
                        phi_199_ = _e282;
                        let _e285 = local_6;
                        phi_201_ = _e285;
                        let _e288 = local_7;
                        phi_203_ = _e288;
                        phi_205_ = _e82;
                    }
                }
                if _e48 {
                    let _e252 = local;
                    global_8.member[_e87] = _e252;
                    let _e257 = local_1;
                    global_8.member[(_e87 + _e83)] = _e257;
                    let _e263 = local_2;
                    global_8.member[(_e87 + (2u * _e83))] = _e263;
                    let _e269 = local_3;
                    global_8.member[(_e87 + (3u * _e83))] = _e269;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn composite(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
