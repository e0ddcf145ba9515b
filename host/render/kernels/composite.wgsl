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
    var phi_108_: bool;
    var phi_160_: f32;
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_163_: f32;
    var phi_171_: u32;
    var phi_180_: u32;
    var phi_194_: f32;
    var phi_197_: f32;
    var phi_199_: f32;
    var phi_201_: f32;
    var phi_203_: u32;
    var phi_209_: u32;
    var phi_195_: f32;
    var phi_198_: f32;
    var phi_200_: f32;
    var phi_202_: f32;
    var phi_250_: f32;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
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
                phi_108_ = (_e39 < _e42);
            } else {
                phi_108_ = false;
            }
            let _e46 = phi_108_;
            if _e46 {
                let _e47 = select(0u, _e39, _e46);
                let _e48 = select(0u, _e37, _e46);
                let _e50 = (_e28.z * 4u);
                let _e54 = global_6.member[(_e50 + 1u)];
                let _e58 = global_6.member[(_e50 + 2u)];
                let _e62 = (f32((_e54 + bitcast<i32>(_e48))) + 0.5f);
                let _e66 = (f32((_e58 + bitcast<i32>(_e47))) + 0.5f);
                let _e69 = global_7.member[_e28.z];
                let _e72 = global_5.member.member_1;
                let _e73 = (_e69 + _e72);
                let _e77 = global_7.member[(_e28.z + 1u)];
                let _e78 = (_e73 + 16384u);
                let _e80 = select(_e78, _e77, (_e77 < _e78));
                let _e81 = (_e42 * _e42);
                let _e85 = (((_e50 * _e81) + (_e47 * _e42)) + _e48);
                if _e46 {
                    let _e88 = global_8.member[_e85];
                    let _e92 = global_8.member[(_e85 + _e81)];
                    let _e97 = global_8.member[(_e85 + (2u * _e81))];
                    let _e102 = global_8.member[(_e85 + (3u * _e81))];
                    phi_160_ = _e102;
                    phi_161_ = _e97;
                    phi_162_ = _e92;
                    phi_163_ = _e88;
                } else {
                    phi_160_ = 0f;
                    phi_161_ = 0f;
                    phi_162_ = 0f;
                    phi_163_ = 0f;
                }
                let _e104 = phi_160_;
                let _e106 = phi_161_;
                let _e108 = phi_162_;
                let _e110 = phi_163_;
                let _e111 = (_e42 / 64u);
                if ((_e42 % 64u) > 0u) {
                    phi_171_ = (_e111 + 1u);
                } else {
                    phi_171_ = _e111;
                }
                let _e116 = phi_171_;
                let _e117 = (_e116 * 16u);
                let _e118 = (_e42 / 8u);
                if ((_e42 % 8u) > 0u) {
                    phi_180_ = (_e118 + 1u);
                } else {
                    phi_180_ = _e118;
                }
                let _e123 = phi_180_;
                if (_e123 == 0u) {
                    break;
                }
                if (_e117 == 0u) {
                    break;
                }
                phi_194_ = _e104;
                phi_197_ = _e106;
                phi_199_ = _e108;
                phi_201_ = _e110;
                phi_203_ = _e73;
                loop {
                    let _e134 = phi_194_;
                    let _e136 = phi_197_;
                    let _e138 = phi_199_;
                    let _e140 = phi_201_;
                    let _e142 = phi_203_;
                    local = _e140;
                    local_1 = _e138;
                    local_2 = _e136;
                    local_3 = _e134;
                    if (_e142 < _e80) {
                        phi_209_ = 0u;
                        phi_195_ = _e134;
                        phi_198_ = _e136;
                        phi_200_ = _e138;
                        phi_202_ = _e140;
                        loop {
                            let _e146 = phi_209_;
                            let _e148 = phi_195_;
                            let _e150 = phi_198_;
                            let _e152 = phi_200_;
                            let _e154 = phi_202_;
                            local_4 = _e148;
                            local_5 = _e150;
                            local_6 = _e152;
                            local_7 = _e154;
                            if (_e146 < (_e80 - _e142)) {
                                let _e156 = (_e142 + _e146);
                                let _e158 = global_3.member[_e156];
                                if ((_e158 & (1u << bitcast<u32>(((((_e47 / _e123) * 4u) + (_e48 / _e117)) & 31u)))) == 0u) {
                                    phi_212_ = _e148;
                                    phi_213_ = _e150;
                                    phi_214_ = _e152;
                                    phi_215_ = _e154;
                                } else {
                                    let _e162 = global_2.member[_e156];
                                    let _e163 = (_e162 * 3u);
                                    let _e165 = global_4.member[_e163];
                                    let _e168 = global_4.member[(_e163 + 1u)];
                                    let _e170 = (_e62 - _e165.x);
                                    if (_e170 > _e165.w) {
                                        phi_254_ = bool();
                                        phi_255_ = true;
                                    } else {
                                        let _e174 = ((_e165.x - _e62) > _e165.w);
                                        if _e174 {
                                            phi_253_ = bool();
                                        } else {
                                            let _e176 = (_e66 - _e165.y);
                                            if (_e176 < 0f) {
                                                phi_250_ = -(_e176);
                                            } else {
                                                phi_250_ = _e176;
                                            }
                                            let _e180 = phi_250_;
                                            phi_253_ = (_e180 > _e168.w);
                                        }
                                        let _e184 = phi_253_;
                                        phi_254_ = _e184;
                                        phi_255_ = _e174;
                                    }
                                    let _e186 = phi_254_;
                                    let _e188 = phi_255_;
                                    if !(select(_e186, true, _e188)) {
                                        let _e192 = (_e66 - _e165.y);
                                        let _e197 = ((_e168.y * _e170) * _e192);
                                        let _e204 = ((((_e168.x * _e170) * _e170) + (_e197 + _e197)) + ((_e168.z * _e192) * _e192));
                                        let _e210 = (_e204 <= 11.082527f);
                                        let _e212 = (_e165.z * select(0f, exp((-0.5f * select(0f, _e204, (_e204 > 0f)))), _e210));
                                        let _e215 = global_4.member[(_e163 + 2u)];
                                        phi_281_ = (_e148 + select(0f, _e212, _e210));
                                        phi_282_ = (_e150 + select(0f, (_e212 * _e215.z), _e210));
                                        phi_283_ = (_e152 + select(0f, (_e212 * _e215.y), _e210));
                                        phi_284_ = (_e154 + select(0f, (_e212 * _e215.x), _e210));
                                    } else {
                                        phi_281_ = _e148;
                                        phi_282_ = _e150;
                                        phi_283_ = _e152;
                                        phi_284_ = _e154;
                                    }
                                    let _e231 = phi_281_;
                                    let _e233 = phi_282_;
                                    let _e235 = phi_283_;
                                    let _e237 = phi_284_;
                                    phi_212_ = _e231;
                                    phi_213_ = _e233;
                                    phi_214_ = _e235;
                                    phi_215_ = _e237;
                                }
                                let _e239 = phi_212_;
                                let _e241 = phi_213_;
                                let _e243 = phi_214_;
                                let _e245 = phi_215_;
                                local_8 = (_e146 + 1u);
                                local_9 = _e239;
                                local_10 = _e241;
                                local_11 = _e243;
                                local_12 = _e245;
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e290 = local_8;
                                phi_209_ = _e290;
                                let _e293 = local_9;
                                phi_195_ = _e293;
                                let _e296 = local_10;
                                phi_198_ = _e296;
                                let _e299 = local_11;
                                phi_200_ = _e299;
                                let _e302 = local_12;
                                phi_202_ = _e302;
                            }
                        }
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e277 = local_4;
                        phi_194_ = _e277;
                        let _e280 = local_5;
                        phi_197_ = _e280;
                        let _e283 = local_6;
                        phi_199_ = _e283;
                        let _e286 = local_7;
                        phi_201_ = _e286;
                        phi_203_ = _e80;
                    }
                }
                if _e46 {
                    let _e250 = local;
                    global_8.member[_e85] = _e250;
                    let _e255 = local_1;
                    global_8.member[(_e85 + _e81)] = _e255;
                    let _e261 = local_2;
                    global_8.member[(_e85 + (2u * _e81))] = _e261;
                    let _e267 = local_3;
                    global_8.member[(_e85 + (3u * _e81))] = _e267;
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
