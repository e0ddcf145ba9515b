struct type_5 {
    member: array<u32>,
}

struct type_11 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: type_14,
}

struct type_21 {
    member: array<i32>,
}

struct type_26 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_2: type_5;
@group(0) @binding(4) 
var<storage> global_3: type_5;
@group(0) @binding(5) 
var<storage> global_4: type_11;
@group(0) @binding(0) 
var<uniform> global_5: type_15;
@group(0) @binding(1) 
var<storage> global_6: type_21;
@group(0) @binding(2) 
var<storage> global_7: type_5;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_26;

fn function_() {
    var phi_110_: bool;
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
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
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
            let _e27 = global;
            let _e28 = global_1;
            let _e37 = ((_e28.x * 16u) + _e27.x);
            let _e39 = ((_e28.y * 4u) + _e27.y);
            let _e42 = global_5.member.member;
            if (_e37 < _e42) {
                phi_110_ = (_e39 < _e42);
            } else {
                phi_110_ = false;
            }
            let _e46 = phi_110_;
            if _e46 {
                let _e47 = select(0u, _e39, _e46);
                let _e48 = select(0u, _e37, _e46);
                let _e50 = (_e28.z * 4u);
                let _e54 = global_6.member[(_e50 + 1u)];
                let _e58 = global_6.member[(_e50 + 2u)];
                let _e62 = (f32((_e54 + bitcast<i32>(_e48))) + 0.5f);
                let _e66 = (f32((_e58 + bitcast<i32>(_e47))) + 0.5f);
                let _e72 = global_7.member[_e28.z];
                let _e75 = global_5.member.member_1;
                let _e76 = (_e72 + _e75);
                let _e80 = global_7.member[(_e28.z + 1u)];
                let _e81 = (_e76 + 16384u);
                let _e83 = select(_e81, _e80, (_e80 < _e81));
                let _e84 = (_e42 * _e42);
                let _e88 = (((_e50 * _e84) + (_e47 * _e42)) + _e48);
                if _e46 {
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
                let _e114 = (_e42 / 64u);
                if ((_e42 % 64u) > 0u) {
                    phi_174_ = (_e114 + 1u);
                } else {
                    phi_174_ = _e114;
                }
                let _e119 = phi_174_;
                let _e120 = (_e119 * 16u);
                let _e121 = (_e42 / 8u);
                if ((_e42 % 8u) > 0u) {
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
                                let _e161 = global_3.member[_e159];
                                if ((_e161 & (1u << bitcast<u32>(((((_e47 / _e126) * 4u) + (_e48 / _e120)) & 31u)))) == 0u) {
                                    phi_215_ = _e151;
                                    phi_216_ = _e153;
                                    phi_217_ = _e155;
                                    phi_218_ = _e157;
                                } else {
                                    let _e165 = global_2.member[_e159];
                                    let _e166 = (_e165 * 3u);
                                    let _e168 = global_4.member[_e166];
                                    let _e171 = global_4.member[(_e166 + 1u)];
                                    if ((_e62 - _e168.x) > _e168.w) {
                                        phi_253_ = bool();
                                        phi_254_ = true;
                                    } else {
                                        let _e177 = ((_e168.x - (_e62 + f32(0u))) > _e168.w);
                                        if _e177 {
                                            phi_252_ = bool();
                                        } else {
                                            phi_252_ = (abs((_e66 - _e168.y)) > _e171.w);
                                        }
                                        let _e184 = phi_252_;
                                        phi_253_ = _e184;
                                        phi_254_ = _e177;
                                    }
                                    let _e186 = phi_253_;
                                    let _e188 = phi_254_;
                                    if !(select(_e186, true, _e188)) {
                                        let _e191 = ((_e62 + 0f) - _e168.x);
                                        let _e193 = (_e66 - _e168.y);
                                        let _e198 = ((_e171.y * _e191) * _e193);
                                        let _e205 = ((((_e171.x * _e191) * _e191) + (_e198 + _e198)) + ((_e171.z * _e193) * _e193));
                                        let _e211 = (_e205 <= 11.082527f);
                                        let _e213 = (_e168.z * select(0f, exp((-0.5f * select(0f, _e205, (_e205 > 0f)))), _e211));
                                        let _e216 = global_4.member[(_e166 + 2u)];
                                        phi_280_ = (_e151 + select(0f, _e213, _e211));
                                        phi_281_ = (_e153 + select(0f, (_e213 * _e216.z), _e211));
                                        phi_282_ = (_e155 + select(0f, (_e213 * _e216.y), _e211));
                                        phi_283_ = (_e157 + select(0f, (_e213 * _e216.x), _e211));
                                    } else {
                                        phi_280_ = _e151;
                                        phi_281_ = _e153;
                                        phi_282_ = _e155;
                                        phi_283_ = _e157;
                                    }
                                    let _e232 = phi_280_;
                                    let _e234 = phi_281_;
                                    let _e236 = phi_282_;
                                    let _e238 = phi_283_;
                                    phi_215_ = _e232;
                                    phi_216_ = _e234;
                                    phi_217_ = _e236;
                                    phi_218_ = _e238;
                                }
                                let _e240 = phi_215_;
                                let _e242 = phi_216_;
                                let _e244 = phi_217_;
                                let _e246 = phi_218_;
                                local_8 = (_e149 + 1u);
                                local_9 = _e240;
                                local_10 = _e242;
                                local_11 = _e244;
                                local_12 = _e246;
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e291 = local_8;
                                phi_212_ = _e291;
                                let _e294 = local_9;
                                phi_198_ = _e294;
                                let _e297 = local_10;
                                phi_201_ = _e297;
                                let _e300 = local_11;
                                phi_203_ = _e300;
                                let _e303 = local_12;
                                phi_205_ = _e303;
                            }
                        }
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e278 = local_4;
                        phi_197_ = _e278;
                        let _e281 = local_5;
                        phi_200_ = _e281;
                        let _e284 = local_6;
                        phi_202_ = _e284;
                        let _e287 = local_7;
                        phi_204_ = _e287;
                        phi_206_ = _e83;
                    }
                }
                if _e46 {
                    let _e251 = local;
                    global_8.member[_e88] = _e251;
                    let _e256 = local_1;
                    global_8.member[(_e88 + _e84)] = _e256;
                    let _e262 = local_2;
                    global_8.member[(_e88 + (2u * _e84))] = _e262;
                    let _e268 = local_3;
                    global_8.member[(_e88 + (3u * _e84))] = _e268;
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
