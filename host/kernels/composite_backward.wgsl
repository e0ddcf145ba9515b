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
    var phi_155_: u32;
    var phi_158_: u32;
    var local: u32;
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
    var phi_306_: f32;
    var phi_309_: u32;
    var phi_311_: f32;
    var phi_313_: f32;
    var phi_315_: f32;
    var phi_317_: f32;
    var phi_319_: f32;
    var phi_321_: f32;
    var phi_307_: f32;
    var phi_310_: u32;
    var phi_312_: f32;
    var phi_314_: f32;
    var phi_316_: f32;
    var phi_318_: f32;
    var phi_320_: f32;
    var phi_322_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var phi_272_: u32;
    var phi_275_: f32;
    var phi_277_: f32;
    var phi_279_: f32;
    var phi_281_: f32;
    var phi_283_: f32;
    var phi_285_: f32;
    var phi_287_: f32;
    var phi_289_: f32;
    var phi_291_: f32;
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
            let _e51 = ((_e49 + 1u) < _e47);
            if _e51 {
                let _e53 = ((_e49 + _e47) / 2u);
                let _e56 = global_4.member[_e53];
                let _e57 = (_e56 <= _e38);
                phi_155_ = select(_e53, _e47, _e57);
                phi_158_ = select(_e49, _e53, _e57);
            } else {
                phi_155_ = u32();
                phi_158_ = u32();
            }
            let _e61 = phi_155_;
            let _e63 = phi_158_;
            continue;
            continuing {
                phi_154_ = _e61;
                phi_157_ = _e63;
                break if !(_e51);
            }
        }
        let _e66 = local;
        let _e67 = (_e66 * 4u);
        let _e71 = global_3.member[(_e67 + 1u)];
        let _e75 = global_3.member[(_e67 + 2u)];
        let _e78 = global_5.member[_e38];
        let _e79 = (_e78 * 3u);
        let _e82 = global_6.member[_e79];
        let _e86 = global_6.member[(_e79 + 1u)];
        let _e90 = global_6.member[(_e79 + 2u)];
        let _e93 = global_7.member.member_2;
        let _e96 = f32(_e93);
        let _e98 = f32(_e71);
        let _e101 = ceil((((_e82.x - _e82.w) - _e98) - 0.5f));
        let _e103 = select(0f, _e101, (_e101 > 0f));
        let _e105 = select(_e96, _e103, (_e103 < _e96));
        let _e108 = (((_e82.x + _e82.w) - _e98) + 0.5f);
        let _e110 = select(0f, _e108, (_e108 > 0f));
        let _e112 = select(_e96, _e110, (_e110 < _e96));
        let _e117 = select(select(u32(_e105), 0u, (_e105 < 0f)), 4294967295u, (_e105 > 4294967000f));
        let _e122 = select(select(u32(_e112), 0u, (_e112 < 0f)), 4294967295u, (_e112 > 4294967000f));
        let _e125 = global_7.member.member_3;
        let _e128 = global_7.member.member_4;
        let _e132 = f32(_e125);
        let _e133 = f32((_e125 + _e128));
        let _e135 = f32(_e75);
        let _e138 = ceil((((_e82.y - _e86.w) - _e135) - 0.5f));
        let _e140 = select(_e132, _e138, (_e138 > _e132));
        let _e142 = select(_e133, _e140, (_e140 < _e133));
        let _e145 = (((_e82.y + _e86.w) - _e135) + 0.5f);
        let _e147 = select(_e132, _e145, (_e145 > _e132));
        let _e149 = select(_e133, _e147, (_e147 < _e133));
        let _e154 = select(select(u32(_e142), 0u, (_e142 < 0f)), 4294967295u, (_e142 > 4294967000f));
        let _e159 = select(select(u32(_e149), 0u, (_e149 < 0f)), 4294967295u, (_e149 > 4294967000f));
        if (_e117 < _e122) {
            if (_e154 < _e159) {
                let _e163 = (_e122 - _e117);
                let _e165 = select(_e93, _e163, (_e163 < _e93));
                let _e166 = (_e93 - _e165);
                let _e168 = select(_e166, _e117, (_e117 < _e166));
                let _e175 = (_e93 * _e93);
                phi_271_ = _e154;
                phi_274_ = 0f;
                phi_276_ = 0f;
                phi_278_ = 0f;
                phi_280_ = 0f;
                phi_282_ = 0f;
                phi_284_ = 0f;
                phi_286_ = 0f;
                phi_288_ = 0f;
                phi_290_ = 0f;
                loop {
                    let _e181 = phi_271_;
                    let _e183 = phi_274_;
                    let _e185 = phi_276_;
                    let _e187 = phi_278_;
                    let _e189 = phi_280_;
                    let _e191 = phi_282_;
                    let _e193 = phi_284_;
                    let _e195 = phi_286_;
                    let _e197 = phi_288_;
                    let _e199 = phi_290_;
                    local_5 = _e191;
                    local_6 = _e189;
                    local_7 = _e191;
                    local_8 = _e189;
                    local_9 = _e187;
                    local_10 = _e185;
                    local_11 = _e183;
                    local_12 = _e193;
                    local_13 = _e199;
                    local_14 = _e197;
                    local_15 = _e195;
                    let _e200 = (_e181 < _e159);
                    if _e200 {
                        let _e205 = ((f32((_e75 + bitcast<i32>(_e181))) + 0.5f) - _e82.y);
                        let _e208 = ((_e93 * ((_e67 * _e93) + _e181)) + _e168);
                        phi_306_ = (f32((_e71 + bitcast<i32>(_e168))) + 0.5f);
                        phi_309_ = _e208;
                        phi_311_ = 0f;
                        phi_313_ = 0f;
                        phi_315_ = _e187;
                        phi_317_ = _e195;
                        phi_319_ = _e197;
                        phi_321_ = _e199;
                        loop {
                            let _e211 = phi_306_;
                            let _e213 = phi_309_;
                            let _e215 = phi_311_;
                            let _e217 = phi_313_;
                            let _e219 = phi_315_;
                            let _e221 = phi_317_;
                            let _e223 = phi_319_;
                            let _e225 = phi_321_;
                            local_1 = _e217;
                            local_2 = _e215;
                            local_3 = _e217;
                            local_4 = _e215;
                            local_16 = _e219;
                            local_17 = _e221;
                            local_18 = _e223;
                            local_19 = _e225;
                            let _e226 = (_e213 < (_e208 + _e165));
                            if _e226 {
                                let _e227 = (_e211 - _e82.x);
                                let _e236 = ((((_e86.x * _e227) * _e227) + (((2f * _e86.y) * _e227) * _e205)) + ((_e86.z * _e205) * _e205));
                                let _e241 = (_e236 <= 11.082527f);
                                let _e242 = select(0f, exp((-0.5f * select(0f, _e236, (_e236 > 0f)))), _e241);
                                let _e245 = global_8.member[_e213];
                                let _e249 = global_8.member[(_e213 + _e175)];
                                let _e254 = global_8.member[(_e213 + (2u * _e175))];
                                let _e259 = global_8.member[(_e213 + (3u * _e175))];
                                let _e267 = select(0f, (_e242 * ((((_e245 * _e90.x) + (_e249 * _e90.y)) + (_e254 * _e90.z)) + _e259)), _e241);
                                let _e268 = (_e267 * _e227);
                                phi_307_ = (_e211 + 1f);
                                phi_310_ = (_e213 + 1u);
                                phi_312_ = (_e215 + _e268);
                                phi_314_ = (_e217 + _e267);
                                phi_316_ = (_e219 + (_e268 * _e227));
                                phi_318_ = select(_e221, (_e221 + (_e242 * _e254)), _e241);
                                phi_320_ = select(_e223, (_e223 + (_e242 * _e249)), _e241);
                                phi_322_ = select(_e225, (_e225 + (_e242 * _e245)), _e241);
                            } else {
                                phi_307_ = f32();
                                phi_310_ = u32();
                                phi_312_ = f32();
                                phi_314_ = f32();
                                phi_316_ = f32();
                                phi_318_ = f32();
                                phi_320_ = f32();
                                phi_322_ = f32();
                            }
                            let _e285 = phi_307_;
                            let _e287 = phi_310_;
                            let _e289 = phi_312_;
                            let _e291 = phi_314_;
                            let _e293 = phi_316_;
                            let _e295 = phi_318_;
                            let _e297 = phi_320_;
                            let _e299 = phi_322_;
                            continue;
                            continuing {
                                phi_306_ = _e285;
                                phi_309_ = _e287;
                                phi_311_ = _e289;
                                phi_313_ = _e291;
                                phi_315_ = _e293;
                                phi_317_ = _e295;
                                phi_319_ = _e297;
                                phi_321_ = _e299;
                                break if !(_e226);
                            }
                        }
                        let _e302 = local_1;
                        let _e305 = local_2;
                        let _e308 = local_3;
                        let _e309 = (_e308 * _e205);
                        let _e312 = local_4;
                        phi_272_ = (_e181 + 1u);
                        phi_275_ = (_e183 + (_e309 * _e205));
                        phi_277_ = (_e185 + (_e312 * _e205));
                        let _e441 = local_16;
                        phi_279_ = _e441;
                        phi_281_ = (_e189 + _e309);
                        phi_283_ = (_e191 + _e305);
                        phi_285_ = (_e193 + _e302);
                        let _e447 = local_17;
                        phi_287_ = _e447;
                        let _e450 = local_18;
                        phi_289_ = _e450;
                        let _e453 = local_19;
                        phi_291_ = _e453;
                    } else {
                        phi_272_ = u32();
                        phi_275_ = f32();
                        phi_277_ = f32();
                        phi_279_ = f32();
                        phi_281_ = f32();
                        phi_283_ = f32();
                        phi_285_ = f32();
                        phi_287_ = f32();
                        phi_289_ = f32();
                        phi_291_ = f32();
                    }
                    let _e319 = phi_272_;
                    let _e321 = phi_275_;
                    let _e323 = phi_277_;
                    let _e325 = phi_279_;
                    let _e327 = phi_281_;
                    let _e329 = phi_283_;
                    let _e331 = phi_285_;
                    let _e333 = phi_287_;
                    let _e335 = phi_289_;
                    let _e337 = phi_291_;
                    continue;
                    continuing {
                        phi_271_ = _e319;
                        phi_274_ = _e321;
                        phi_276_ = _e323;
                        phi_278_ = _e325;
                        phi_280_ = _e327;
                        phi_282_ = _e329;
                        phi_284_ = _e331;
                        phi_286_ = _e333;
                        phi_288_ = _e335;
                        phi_290_ = _e337;
                        break if !(_e200);
                    }
                }
                let _e341 = local_5;
                let _e344 = local_6;
                let _e349 = local_7;
                let _e352 = local_8;
                let _e357 = local_9;
                let _e360 = local_10;
                let _e363 = local_11;
                let _e368 = (_e38 * 3u);
                let _e371 = global_9.member[_e368];
                let _e373 = local_12;
                global_9.member[_e368] = (_e371 + vec4<f32>((_e82.z * ((_e86.x * _e341) + (_e86.y * _e344))), (_e82.z * ((_e86.y * _e349) + (_e86.z * _e352))), _e373, 0f));
                let _e379 = global_9.member[(_e368 + 1u)];
                global_9.member[(_e368 + 1u)] = (_e379 + vec4<f32>(((-0.5f * _e357) * _e82.z), ((-1f * _e360) * _e82.z), ((-0.5f * _e363) * _e82.z), 0f));
                let _e384 = global_7.member.member_5;
                if (_e384 == 0u) {
                } else {
                    let _e389 = global_9.member[(_e368 + 2u)];
                    let _e391 = local_13;
                    let _e394 = local_14;
                    let _e397 = local_15;
                    global_9.member[(_e368 + 2u)] = (_e389 + vec4<f32>((_e391 * _e82.z), (_e394 * _e82.z), (_e397 * _e82.z), 0f));
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
