struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: array<i32>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_25 {
    member: type_24,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_21;
@group(0) @binding(2) 
var<storage> global_4: type_16;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(4) 
var<storage> global_6: type_6;
@group(0) @binding(0) 
var<uniform> global_7: type_25;
@group(0) @binding(5) 
var<storage> global_8: type_9;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_6;

fn function_() {
    var phi_153_: u32;
    var phi_156_: u32;
    var phi_154_: u32;
    var phi_157_: u32;
    var local: u32;
    var phi_270_: u32;
    var phi_273_: f32;
    var phi_275_: f32;
    var phi_277_: f32;
    var phi_279_: f32;
    var phi_281_: f32;
    var phi_283_: f32;
    var phi_285_: f32;
    var phi_287_: f32;
    var phi_289_: f32;
    var phi_305_: f32;
    var phi_308_: u32;
    var phi_310_: f32;
    var phi_312_: f32;
    var phi_314_: f32;
    var phi_316_: f32;
    var phi_318_: f32;
    var phi_320_: f32;
    var phi_306_: f32;
    var phi_309_: u32;
    var phi_311_: f32;
    var phi_313_: f32;
    var phi_315_: f32;
    var phi_317_: f32;
    var phi_319_: f32;
    var phi_321_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var phi_271_: u32;
    var phi_274_: f32;
    var phi_276_: f32;
    var phi_278_: f32;
    var phi_280_: f32;
    var phi_282_: f32;
    var phi_284_: f32;
    var phi_286_: f32;
    var phi_288_: f32;
    var phi_290_: f32;
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
    var local_16: f32;
    var local_17: f32;
    var local_18: f32;
    var local_19: f32;

    let _e27 = global;
    let _e28 = global_1;
    let _e29 = global_2;
    let _e37 = (((_e28.x + (_e28.y * _e29.x)) * 64u) + _e27.x);
    let _e40 = global_7.member.member;
    if (_e37 < _e40) {
        let _e44 = global_7.member.member_1;
        phi_153_ = _e44;
        phi_156_ = 0u;
        loop {
            let _e46 = phi_153_;
            let _e48 = phi_156_;
            local = _e48;
            let _e50 = ((_e48 + 1u) < _e46);
            if _e50 {
                let _e52 = ((_e48 + _e46) / 2u);
                let _e55 = global_4.member[_e52];
                let _e56 = (_e55 <= _e37);
                phi_154_ = select(_e52, _e46, _e56);
                phi_157_ = select(_e48, _e52, _e56);
            } else {
                phi_154_ = u32();
                phi_157_ = u32();
            }
            let _e60 = phi_154_;
            let _e62 = phi_157_;
            continue;
            continuing {
                phi_153_ = _e60;
                phi_156_ = _e62;
                break if !(_e50);
            }
        }
        let _e65 = local;
        let _e66 = (_e65 * 4u);
        let _e70 = global_3.member[(_e66 + 1u)];
        let _e74 = global_3.member[(_e66 + 2u)];
        let _e77 = global_5.member[_e37];
        let _e78 = (_e77 * 3u);
        let _e81 = global_6.member[_e78];
        let _e85 = global_6.member[(_e78 + 1u)];
        let _e89 = global_6.member[(_e78 + 2u)];
        let _e92 = global_7.member.member_2;
        let _e95 = f32(_e92);
        let _e97 = f32(_e70);
        let _e100 = ceil((((_e81.x - _e81.w) - _e97) - 0.5f));
        let _e102 = select(0f, _e100, (_e100 > 0f));
        let _e104 = select(_e95, _e102, (_e102 < _e95));
        let _e107 = (((_e81.x + _e81.w) - _e97) + 0.5f);
        let _e109 = select(0f, _e107, (_e107 > 0f));
        let _e111 = select(_e95, _e109, (_e109 < _e95));
        let _e116 = select(select(u32(_e104), 0u, (_e104 < 0f)), 4294967295u, (_e104 > 4294967000f));
        let _e121 = select(select(u32(_e111), 0u, (_e111 < 0f)), 4294967295u, (_e111 > 4294967000f));
        let _e124 = global_7.member.member_3;
        let _e127 = global_7.member.member_4;
        let _e131 = f32(_e124);
        let _e132 = f32((_e124 + _e127));
        let _e134 = f32(_e74);
        let _e137 = ceil((((_e81.y - _e85.w) - _e134) - 0.5f));
        let _e139 = select(_e131, _e137, (_e137 > _e131));
        let _e141 = select(_e132, _e139, (_e139 < _e132));
        let _e144 = (((_e81.y + _e85.w) - _e134) + 0.5f);
        let _e146 = select(_e131, _e144, (_e144 > _e131));
        let _e148 = select(_e132, _e146, (_e146 < _e132));
        let _e153 = select(select(u32(_e141), 0u, (_e141 < 0f)), 4294967295u, (_e141 > 4294967000f));
        let _e158 = select(select(u32(_e148), 0u, (_e148 < 0f)), 4294967295u, (_e148 > 4294967000f));
        if (_e116 < _e121) {
            if (_e153 < _e158) {
                let _e162 = (_e121 - _e116);
                let _e164 = select(_e92, _e162, (_e162 < _e92));
                let _e165 = (_e92 - _e164);
                let _e167 = select(_e165, _e116, (_e116 < _e165));
                let _e174 = (_e92 * _e92);
                phi_270_ = _e153;
                phi_273_ = 0f;
                phi_275_ = 0f;
                phi_277_ = 0f;
                phi_279_ = 0f;
                phi_281_ = 0f;
                phi_283_ = 0f;
                phi_285_ = 0f;
                phi_287_ = 0f;
                phi_289_ = 0f;
                loop {
                    let _e180 = phi_270_;
                    let _e182 = phi_273_;
                    let _e184 = phi_275_;
                    let _e186 = phi_277_;
                    let _e188 = phi_279_;
                    let _e190 = phi_281_;
                    let _e192 = phi_283_;
                    let _e194 = phi_285_;
                    let _e196 = phi_287_;
                    let _e198 = phi_289_;
                    local_5 = _e190;
                    local_6 = _e188;
                    local_7 = _e190;
                    local_8 = _e188;
                    local_9 = _e186;
                    local_10 = _e184;
                    local_11 = _e182;
                    local_12 = _e192;
                    local_13 = _e198;
                    local_14 = _e196;
                    local_15 = _e194;
                    let _e199 = (_e180 < _e158);
                    if _e199 {
                        let _e204 = ((f32((_e74 + bitcast<i32>(_e180))) + 0.5f) - _e81.y);
                        let _e207 = ((_e92 * ((_e66 * _e92) + _e180)) + _e167);
                        phi_305_ = (f32((_e70 + bitcast<i32>(_e167))) + 0.5f);
                        phi_308_ = _e207;
                        phi_310_ = 0f;
                        phi_312_ = 0f;
                        phi_314_ = _e186;
                        phi_316_ = _e194;
                        phi_318_ = _e196;
                        phi_320_ = _e198;
                        loop {
                            let _e210 = phi_305_;
                            let _e212 = phi_308_;
                            let _e214 = phi_310_;
                            let _e216 = phi_312_;
                            let _e218 = phi_314_;
                            let _e220 = phi_316_;
                            let _e222 = phi_318_;
                            let _e224 = phi_320_;
                            local_1 = _e216;
                            local_2 = _e214;
                            local_3 = _e216;
                            local_4 = _e214;
                            local_16 = _e218;
                            local_17 = _e220;
                            local_18 = _e222;
                            local_19 = _e224;
                            let _e225 = (_e212 < (_e207 + _e164));
                            if _e225 {
                                let _e226 = (_e210 - _e81.x);
                                let _e235 = ((((_e85.x * _e226) * _e226) + (((2f * _e85.y) * _e226) * _e204)) + ((_e85.z * _e204) * _e204));
                                let _e240 = (_e235 <= 11.082527f);
                                let _e241 = select(0f, exp((-0.5f * select(0f, _e235, (_e235 > 0f)))), _e240);
                                let _e244 = global_8.member[_e212];
                                let _e248 = global_8.member[(_e212 + _e174)];
                                let _e253 = global_8.member[(_e212 + (2u * _e174))];
                                let _e258 = global_8.member[(_e212 + (3u * _e174))];
                                let _e266 = select(0f, (_e241 * ((((_e244 * _e89.x) + (_e248 * _e89.y)) + (_e253 * _e89.z)) + _e258)), _e240);
                                let _e267 = (_e266 * _e226);
                                phi_306_ = (_e210 + 1f);
                                phi_309_ = (_e212 + 1u);
                                phi_311_ = (_e214 + _e267);
                                phi_313_ = (_e216 + _e266);
                                phi_315_ = (_e218 + (_e267 * _e226));
                                phi_317_ = select(_e220, (_e220 + (_e241 * _e253)), _e240);
                                phi_319_ = select(_e222, (_e222 + (_e241 * _e248)), _e240);
                                phi_321_ = select(_e224, (_e224 + (_e241 * _e244)), _e240);
                            } else {
                                phi_306_ = f32();
                                phi_309_ = u32();
                                phi_311_ = f32();
                                phi_313_ = f32();
                                phi_315_ = f32();
                                phi_317_ = f32();
                                phi_319_ = f32();
                                phi_321_ = f32();
                            }
                            let _e284 = phi_306_;
                            let _e286 = phi_309_;
                            let _e288 = phi_311_;
                            let _e290 = phi_313_;
                            let _e292 = phi_315_;
                            let _e294 = phi_317_;
                            let _e296 = phi_319_;
                            let _e298 = phi_321_;
                            continue;
                            continuing {
                                phi_305_ = _e284;
                                phi_308_ = _e286;
                                phi_310_ = _e288;
                                phi_312_ = _e290;
                                phi_314_ = _e292;
                                phi_316_ = _e294;
                                phi_318_ = _e296;
                                phi_320_ = _e298;
                                break if !(_e225);
                            }
                        }
                        let _e301 = local_1;
                        let _e304 = local_2;
                        let _e307 = local_3;
                        let _e308 = (_e307 * _e204);
                        let _e311 = local_4;
                        phi_271_ = (_e180 + 1u);
                        phi_274_ = (_e182 + (_e308 * _e204));
                        phi_276_ = (_e184 + (_e311 * _e204));
                        let _e436 = local_16;
                        phi_278_ = _e436;
                        phi_280_ = (_e188 + _e308);
                        phi_282_ = (_e190 + _e304);
                        phi_284_ = (_e192 + _e301);
                        let _e442 = local_17;
                        phi_286_ = _e442;
                        let _e445 = local_18;
                        phi_288_ = _e445;
                        let _e448 = local_19;
                        phi_290_ = _e448;
                    } else {
                        phi_271_ = u32();
                        phi_274_ = f32();
                        phi_276_ = f32();
                        phi_278_ = f32();
                        phi_280_ = f32();
                        phi_282_ = f32();
                        phi_284_ = f32();
                        phi_286_ = f32();
                        phi_288_ = f32();
                        phi_290_ = f32();
                    }
                    let _e318 = phi_271_;
                    let _e320 = phi_274_;
                    let _e322 = phi_276_;
                    let _e324 = phi_278_;
                    let _e326 = phi_280_;
                    let _e328 = phi_282_;
                    let _e330 = phi_284_;
                    let _e332 = phi_286_;
                    let _e334 = phi_288_;
                    let _e336 = phi_290_;
                    continue;
                    continuing {
                        phi_270_ = _e318;
                        phi_273_ = _e320;
                        phi_275_ = _e322;
                        phi_277_ = _e324;
                        phi_279_ = _e326;
                        phi_281_ = _e328;
                        phi_283_ = _e330;
                        phi_285_ = _e332;
                        phi_287_ = _e334;
                        phi_289_ = _e336;
                        break if !(_e199);
                    }
                }
                let _e340 = local_5;
                let _e343 = local_6;
                let _e348 = local_7;
                let _e351 = local_8;
                let _e356 = local_9;
                let _e359 = local_10;
                let _e362 = local_11;
                let _e367 = (_e37 * 3u);
                let _e370 = global_9.member[_e367];
                let _e372 = local_12;
                global_9.member[_e367] = (_e370 + vec4<f32>((_e81.z * ((_e85.x * _e340) + (_e85.y * _e343))), (_e81.z * ((_e85.y * _e348) + (_e85.z * _e351))), _e372, 0f));
                let _e378 = global_9.member[(_e367 + 1u)];
                global_9.member[(_e367 + 1u)] = (_e378 + vec4<f32>(((-0.5f * _e356) * _e81.z), ((-1f * _e359) * _e81.z), ((-0.5f * _e362) * _e81.z), 0f));
                let _e384 = global_9.member[(_e367 + 2u)];
                let _e386 = local_13;
                let _e389 = local_14;
                let _e392 = local_15;
                global_9.member[(_e367 + 2u)] = (_e384 + vec4<f32>((_e386 * _e81.z), (_e389 * _e81.z), (_e392 * _e81.z), 0f));
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
