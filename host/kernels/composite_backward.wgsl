struct type_6 {
    member: array<i32>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_25 {
    member: type_24,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_16;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(4) 
var<storage> global_6: type_21;
@group(0) @binding(0) 
var<uniform> global_7: type_25;
@group(0) @binding(5) 
var<storage> global_8: type_9;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_21;

fn function_() {
    var phi_154_: u32;
    var phi_157_: u32;
    var local: u32;
    var phi_266_: u32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_278_: f32;
    var phi_280_: f32;
    var phi_293_: f32;
    var phi_295_: u32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_272_: f32;
    var phi_277_: f32;
    var phi_279_: f32;
    var phi_281_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var local_14: f32;
    var local_15: f32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: f32;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var local_29: u32;
    var local_30: f32;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;

    let _e28 = global;
    let _e29 = global_1;
    let _e30 = global_2;
    let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
    let _e41 = global_7.member.member;
    if (_e38 < _e41) {
        let _e45 = global_7.member.member_1;
        phi_154_ = _e45;
        phi_157_ = 0u;
        loop {
            let _e47 = phi_154_;
            let _e49 = phi_157_;
            local = _e49;
            if ((_e49 + 1u) < _e47) {
                let _e53 = ((_e49 + _e47) / 2u);
                let _e56 = global_4.member[_e53];
                let _e57 = (_e56 <= _e38);
                local_16 = select(_e53, _e47, _e57);
                local_17 = select(_e49, _e53, _e57);
                continue;
            } else {
                break;
            }
            continuing {
                let _e360 = local_16;
                phi_154_ = _e360;
                let _e363 = local_17;
                phi_157_ = _e363;
            }
        }
        let _e61 = local;
        let _e62 = (_e61 * 4u);
        let _e66 = global_3.member[(_e62 + 1u)];
        let _e70 = global_3.member[(_e62 + 2u)];
        let _e73 = global_5.member[_e38];
        let _e74 = (_e73 * 3u);
        let _e77 = global_6.member[_e74];
        let _e81 = global_6.member[(_e74 + 1u)];
        let _e85 = global_6.member[(_e74 + 2u)];
        let _e88 = global_7.member.member_2;
        let _e91 = f32(_e88);
        let _e93 = f32(_e66);
        let _e96 = ceil((((_e77.x - _e77.w) - _e93) - 0.5f));
        let _e98 = select(0f, _e96, (_e96 > 0f));
        let _e100 = select(_e91, _e98, (_e98 < _e91));
        let _e103 = (((_e77.x + _e77.w) - _e93) + 0.5f);
        let _e105 = select(0f, _e103, (_e103 > 0f));
        let _e107 = select(_e91, _e105, (_e105 < _e91));
        let _e112 = select(select(u32(_e100), 0u, (_e100 < 0f)), 4294967295u, (_e100 > 4294967000f));
        let _e117 = select(select(u32(_e107), 0u, (_e107 < 0f)), 4294967295u, (_e107 > 4294967000f));
        let _e120 = global_7.member.member_3;
        let _e123 = global_7.member.member_4;
        let _e127 = f32(_e120);
        let _e128 = f32((_e120 + _e123));
        let _e130 = f32(_e70);
        let _e133 = ceil((((_e77.y - _e81.w) - _e130) - 0.5f));
        let _e135 = select(_e127, _e133, (_e133 > _e127));
        let _e137 = select(_e128, _e135, (_e135 < _e128));
        let _e140 = (((_e77.y + _e81.w) - _e130) + 0.5f);
        let _e142 = select(_e127, _e140, (_e140 > _e127));
        let _e144 = select(_e128, _e142, (_e142 < _e128));
        let _e149 = select(select(u32(_e137), 0u, (_e137 < 0f)), 4294967295u, (_e137 > 4294967000f));
        let _e154 = select(select(u32(_e144), 0u, (_e144 < 0f)), 4294967295u, (_e144 > 4294967000f));
        if (_e112 < _e117) {
            if (_e149 < _e154) {
                let _e158 = (_e117 - _e112);
                let _e160 = select(_e88, _e158, (_e158 < _e88));
                let _e161 = (_e88 - _e160);
                let _e163 = select(_e161, _e112, (_e112 < _e161));
                let _e170 = (_e88 * _e88);
                phi_266_ = _e149;
                phi_269_ = 0f;
                phi_270_ = 0f;
                phi_271_ = 0f;
                phi_273_ = 0f;
                phi_274_ = 0f;
                phi_275_ = 0f;
                phi_276_ = 0f;
                phi_278_ = 0f;
                phi_280_ = 0f;
                loop {
                    let _e176 = phi_266_;
                    let _e178 = phi_269_;
                    let _e180 = phi_270_;
                    let _e182 = phi_271_;
                    let _e184 = phi_273_;
                    let _e186 = phi_274_;
                    let _e188 = phi_275_;
                    let _e190 = phi_276_;
                    let _e192 = phi_278_;
                    let _e194 = phi_280_;
                    local_5 = _e186;
                    local_6 = _e184;
                    local_7 = _e186;
                    local_8 = _e184;
                    local_9 = _e182;
                    local_10 = _e180;
                    local_11 = _e178;
                    local_12 = _e188;
                    local_13 = _e194;
                    local_14 = _e192;
                    local_15 = _e190;
                    if (_e176 < _e154) {
                        let _e200 = ((f32((_e70 + bitcast<i32>(_e176))) + 0.5f) - _e77.y);
                        let _e203 = ((_e88 * ((_e62 * _e88) + _e176)) + _e163);
                        phi_293_ = (f32((_e66 + bitcast<i32>(_e163))) + 0.5f);
                        phi_295_ = _e203;
                        phi_297_ = 0f;
                        phi_298_ = 0f;
                        phi_272_ = _e182;
                        phi_277_ = _e190;
                        phi_279_ = _e192;
                        phi_281_ = _e194;
                        loop {
                            let _e206 = phi_293_;
                            let _e208 = phi_295_;
                            let _e210 = phi_297_;
                            let _e212 = phi_298_;
                            let _e214 = phi_272_;
                            let _e216 = phi_277_;
                            let _e218 = phi_279_;
                            let _e220 = phi_281_;
                            local_21 = _e214;
                            local_25 = _e216;
                            local_26 = _e218;
                            local_27 = _e220;
                            local_1 = _e212;
                            local_2 = _e210;
                            local_3 = _e212;
                            local_4 = _e210;
                            if (_e208 < (_e203 + _e160)) {
                                let _e222 = (_e206 - _e77.x);
                                let _e231 = ((((_e81.x * _e222) * _e222) + (((2f * _e81.y) * _e222) * _e200)) + ((_e81.z * _e200) * _e200));
                                let _e236 = (_e231 <= 11.082527f);
                                let _e237 = select(0f, exp((-0.5f * select(0f, _e231, (_e231 > 0f)))), _e236);
                                let _e240 = global_8.member[_e208];
                                let _e244 = global_8.member[(_e208 + _e170)];
                                let _e249 = global_8.member[(_e208 + (2u * _e170))];
                                let _e254 = global_8.member[(_e208 + (3u * _e170))];
                                let _e262 = select(0f, (_e237 * ((((_e240 * _e85.x) + (_e244 * _e85.y)) + (_e249 * _e85.z)) + _e254)), _e236);
                                let _e263 = (_e262 * _e222);
                                local_28 = (_e206 + 1f);
                                local_29 = (_e208 + 1u);
                                local_30 = (_e210 + _e263);
                                local_31 = (_e212 + _e262);
                                local_32 = (_e214 + (_e263 * _e222));
                                local_33 = select(_e216, (_e216 + (_e237 * _e249)), _e236);
                                local_34 = select(_e218, (_e218 + (_e237 * _e244)), _e236);
                                local_35 = select(_e220, (_e220 + (_e237 * _e240)), _e236);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e397 = local_28;
                                phi_293_ = _e397;
                                let _e400 = local_29;
                                phi_295_ = _e400;
                                let _e403 = local_30;
                                phi_297_ = _e403;
                                let _e406 = local_31;
                                phi_298_ = _e406;
                                let _e409 = local_32;
                                phi_272_ = _e409;
                                let _e412 = local_33;
                                phi_277_ = _e412;
                                let _e415 = local_34;
                                phi_279_ = _e415;
                                let _e418 = local_35;
                                phi_281_ = _e418;
                            }
                        }
                        let _e280 = local_1;
                        let _e283 = local_2;
                        let _e286 = local_3;
                        let _e287 = (_e286 * _e200);
                        let _e290 = local_4;
                        local_18 = (_e176 + 1u);
                        local_19 = (_e178 + (_e287 * _e200));
                        local_20 = (_e180 + (_e290 * _e200));
                        local_22 = (_e184 + _e287);
                        local_23 = (_e186 + _e283);
                        local_24 = (_e188 + _e280);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e367 = local_18;
                        phi_266_ = _e367;
                        let _e370 = local_19;
                        phi_269_ = _e370;
                        let _e373 = local_20;
                        phi_270_ = _e373;
                        let _e376 = local_21;
                        phi_271_ = _e376;
                        let _e379 = local_22;
                        phi_273_ = _e379;
                        let _e382 = local_23;
                        phi_274_ = _e382;
                        let _e385 = local_24;
                        phi_275_ = _e385;
                        let _e388 = local_25;
                        phi_276_ = _e388;
                        let _e391 = local_26;
                        phi_278_ = _e391;
                        let _e394 = local_27;
                        phi_280_ = _e394;
                    }
                }
                let _e298 = local_5;
                let _e301 = local_6;
                let _e306 = local_7;
                let _e309 = local_8;
                let _e314 = local_9;
                let _e317 = local_10;
                let _e320 = local_11;
                let _e325 = (_e38 * 3u);
                let _e328 = global_9.member[_e325];
                let _e330 = local_12;
                global_9.member[_e325] = (_e328 + vec4<f32>((_e77.z * ((_e81.x * _e298) + (_e81.y * _e301))), (_e77.z * ((_e81.y * _e306) + (_e81.z * _e309))), _e330, 0f));
                let _e336 = global_9.member[(_e325 + 1u)];
                global_9.member[(_e325 + 1u)] = (_e336 + vec4<f32>(((-0.5f * _e314) * _e77.z), ((-1f * _e317) * _e77.z), ((-0.5f * _e320) * _e77.z), 0f));
                let _e341 = global_7.member.member_5;
                if (_e341 == 0u) {
                } else {
                    let _e346 = global_9.member[(_e325 + 2u)];
                    let _e348 = local_13;
                    let _e351 = local_14;
                    let _e354 = local_15;
                    global_9.member[(_e325 + 2u)] = (_e346 + vec4<f32>((_e348 * _e77.z), (_e351 * _e77.z), (_e354 * _e77.z), 0f));
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn composite_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
