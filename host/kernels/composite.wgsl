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
    var phi_111_: bool;
    var phi_163_: f32;
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_166_: f32;
    var phi_174_: u32;
    var phi_183_: u32;
    var phi_197_: f32;
    var phi_200_: f32;
    var phi_202_: f32;
    var phi_204_: f32;
    var phi_206_: u32;
    var phi_212_: u32;
    var phi_198_: f32;
    var phi_201_: f32;
    var phi_203_: f32;
    var phi_205_: f32;
    var phi_253_: f32;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
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
            let _e30 = global;
            let _e31 = global_1;
            let _e40 = ((_e31.x * 16u) + _e30.x);
            let _e42 = ((_e31.y * 4u) + _e30.y);
            let _e45 = global_3.member.member;
            if (_e40 < _e45) {
                phi_111_ = (_e42 < _e45);
            } else {
                phi_111_ = false;
            }
            let _e49 = phi_111_;
            if _e49 {
                let _e50 = select(0u, _e42, _e49);
                let _e51 = select(0u, _e40, _e49);
                let _e53 = (_e31.z * 4u);
                let _e57 = global_2.member[(_e53 + 1u)];
                let _e61 = global_2.member[(_e53 + 2u)];
                let _e65 = (f32((_e57 + bitcast<i32>(_e51))) + 0.5f);
                let _e69 = (f32((_e61 + bitcast<i32>(_e50))) + 0.5f);
                let _e72 = global_4.member[_e31.z];
                let _e75 = global_3.member.member_1;
                let _e76 = (_e72 + _e75);
                let _e80 = global_4.member[(_e31.z + 1u)];
                let _e81 = (_e76 + 16384u);
                let _e83 = select(_e81, _e80, (_e80 < _e81));
                let _e84 = (_e45 * _e45);
                let _e88 = (((_e53 * _e84) + (_e50 * _e45)) + _e51);
                if _e49 {
                    let _e91 = global_8.member[_e88];
                    let _e95 = global_8.member[(_e88 + _e84)];
                    let _e100 = global_8.member[(_e88 + (2u * _e84))];
                    let _e105 = global_8.member[(_e88 + (3u * _e84))];
                    phi_163_ = _e105;
                    phi_164_ = _e100;
                    phi_165_ = _e95;
                    phi_166_ = _e91;
                } else {
                    phi_163_ = 0f;
                    phi_164_ = 0f;
                    phi_165_ = 0f;
                    phi_166_ = 0f;
                }
                let _e107 = phi_163_;
                let _e109 = phi_164_;
                let _e111 = phi_165_;
                let _e113 = phi_166_;
                let _e114 = (_e45 / 64u);
                if ((_e45 % 64u) > 0u) {
                    phi_174_ = (_e114 + 1u);
                } else {
                    phi_174_ = _e114;
                }
                let _e119 = phi_174_;
                let _e120 = (_e119 * 16u);
                let _e121 = (_e45 / 8u);
                if ((_e45 % 8u) > 0u) {
                    phi_183_ = (_e121 + 1u);
                } else {
                    phi_183_ = _e121;
                }
                let _e126 = phi_183_;
                if (_e126 == 0u) {
                    break;
                }
                if (_e120 == 0u) {
                    break;
                }
                phi_197_ = _e107;
                phi_200_ = _e109;
                phi_202_ = _e111;
                phi_204_ = _e113;
                phi_206_ = _e76;
                loop {
                    let _e137 = phi_197_;
                    let _e139 = phi_200_;
                    let _e141 = phi_202_;
                    let _e143 = phi_204_;
                    let _e145 = phi_206_;
                    local = _e143;
                    local_1 = _e141;
                    local_2 = _e139;
                    local_3 = _e137;
                    if (_e145 < _e83) {
                        phi_212_ = 0u;
                        phi_198_ = _e137;
                        phi_201_ = _e139;
                        phi_203_ = _e141;
                        phi_205_ = _e143;
                        loop {
                            let _e149 = phi_212_;
                            let _e151 = phi_198_;
                            let _e153 = phi_201_;
                            let _e155 = phi_203_;
                            let _e157 = phi_205_;
                            local_4 = _e151;
                            local_5 = _e153;
                            local_6 = _e155;
                            local_7 = _e157;
                            if (_e149 < (_e83 - _e145)) {
                                let _e159 = (_e145 + _e149);
                                let _e161 = global_6.member[_e159];
                                if ((_e161 & (1u << bitcast<u32>(((((_e50 / _e126) * 4u) + (_e51 / _e120)) & 31u)))) == 0u) {
                                    phi_215_ = _e151;
                                    phi_216_ = _e153;
                                    phi_217_ = _e155;
                                    phi_218_ = _e157;
                                } else {
                                    let _e165 = global_5.member[_e159];
                                    let _e166 = (_e165 * 3u);
                                    let _e168 = global_7.member[_e166];
                                    let _e171 = global_7.member[(_e166 + 1u)];
                                    let _e173 = (_e65 - _e168.x);
                                    if (_e173 > _e168.w) {
                                        phi_257_ = bool();
                                        phi_258_ = true;
                                    } else {
                                        let _e177 = ((_e168.x - _e65) > _e168.w);
                                        if _e177 {
                                            phi_256_ = bool();
                                        } else {
                                            let _e179 = (_e69 - _e168.y);
                                            if (_e179 < 0f) {
                                                phi_253_ = -(_e179);
                                            } else {
                                                phi_253_ = _e179;
                                            }
                                            let _e183 = phi_253_;
                                            phi_256_ = (_e183 > _e171.w);
                                        }
                                        let _e187 = phi_256_;
                                        phi_257_ = _e187;
                                        phi_258_ = _e177;
                                    }
                                    let _e189 = phi_257_;
                                    let _e191 = phi_258_;
                                    if !(select(_e189, true, _e191)) {
                                        let _e195 = (_e69 - _e168.y);
                                        let _e207 = ((((_e171.x * _e173) * _e173) + (((2f * _e171.y) * _e173) * _e195)) + ((_e171.z * _e195) * _e195));
                                        let _e213 = (_e207 <= 11.082527f);
                                        let _e215 = (_e168.z * select(0f, exp((-0.5f * select(0f, _e207, (_e207 > 0f)))), _e213));
                                        let _e218 = global_7.member[(_e166 + 2u)];
                                        phi_284_ = (_e151 + select(0f, _e215, _e213));
                                        phi_285_ = (_e153 + select(0f, (_e215 * _e218.z), _e213));
                                        phi_286_ = (_e155 + select(0f, (_e215 * _e218.y), _e213));
                                        phi_287_ = (_e157 + select(0f, (_e215 * _e218.x), _e213));
                                    } else {
                                        phi_284_ = _e151;
                                        phi_285_ = _e153;
                                        phi_286_ = _e155;
                                        phi_287_ = _e157;
                                    }
                                    let _e234 = phi_284_;
                                    let _e236 = phi_285_;
                                    let _e238 = phi_286_;
                                    let _e240 = phi_287_;
                                    phi_215_ = _e234;
                                    phi_216_ = _e236;
                                    phi_217_ = _e238;
                                    phi_218_ = _e240;
                                }
                                let _e242 = phi_215_;
                                let _e244 = phi_216_;
                                let _e246 = phi_217_;
                                let _e248 = phi_218_;
                                local_8 = (_e149 + 1u);
                                local_9 = _e242;
                                local_10 = _e244;
                                local_11 = _e246;
                                local_12 = _e248;
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e293 = local_8;
                                phi_212_ = _e293;
                                let _e296 = local_9;
                                phi_198_ = _e296;
                                let _e299 = local_10;
                                phi_201_ = _e299;
                                let _e302 = local_11;
                                phi_203_ = _e302;
                                let _e305 = local_12;
                                phi_205_ = _e305;
                            }
                        }
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e280 = local_4;
                        phi_197_ = _e280;
                        let _e283 = local_5;
                        phi_200_ = _e283;
                        let _e286 = local_6;
                        phi_202_ = _e286;
                        let _e289 = local_7;
                        phi_204_ = _e289;
                        phi_206_ = _e83;
                    }
                }
                if _e49 {
                    let _e253 = local;
                    global_8.member[_e88] = _e253;
                    let _e258 = local_1;
                    global_8.member[(_e88 + _e84)] = _e258;
                    let _e264 = local_2;
                    global_8.member[(_e88 + (2u * _e84))] = _e264;
                    let _e270 = local_3;
                    global_8.member[(_e88 + (3u * _e84))] = _e270;
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
