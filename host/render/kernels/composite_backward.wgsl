struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<i32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_25 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage> global_8: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_21;

fn function_() {
    var phi_180_: u32;
    var phi_183_: u32;
    var local: u32;
    var phi_300_: u32;
    var phi_303_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_312_: f32;
    var phi_314_: f32;
    var phi_327_: f32;
    var phi_329_: u32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_306_: f32;
    var phi_311_: f32;
    var phi_313_: f32;
    var phi_315_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var phi_371_: vec3<f32>;
    var phi_372_: f32;
    var phi_373_: vec3<f32>;
    var phi_374_: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_383_: vec3<f32>;
    var local_14: f32;
    var local_15: f32;
    var local_16: f32;
    var local_17: u32;
    var local_18: u32;
    var local_19: u32;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var local_29: f32;
    var local_30: u32;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;

    let _e28 = global;
    let _e29 = global_1;
    let _e30 = global_2;
    let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
    let _e41 = global_3.member.member;
    if (_e38 < _e41) {
        let _e45 = global_3.member.member_1;
        phi_180_ = _e45;
        phi_183_ = 0u;
        loop {
            let _e47 = phi_180_;
            let _e49 = phi_183_;
            local = _e49;
            if ((_e49 + 1u) < _e47) {
                let _e53 = ((_e49 + _e47) / 2u);
                let _e56 = global_4.member[_e53];
                let _e57 = (_e56 <= _e38);
                local_17 = select(_e53, _e47, _e57);
                local_18 = select(_e49, _e53, _e57);
                continue;
            } else {
                break;
            }
            continuing {
                let _e415 = local_17;
                phi_180_ = _e415;
                let _e418 = local_18;
                phi_183_ = _e418;
            }
        }
        let _e61 = local;
        let _e62 = (_e61 * 4u);
        let _e66 = global_5.member[(_e62 + 1u)];
        let _e70 = global_5.member[(_e62 + 2u)];
        let _e73 = global_6.member[_e38];
        let _e74 = (_e73 * 3u);
        let _e77 = global_7.member[_e74];
        let _e81 = global_7.member[(_e74 + 1u)];
        let _e85 = global_7.member[(_e74 + 2u)];
        let _e88 = global_3.member.member_2;
        let _e91 = f32(0u);
        let _e92 = f32(_e88);
        let _e94 = f32(_e66);
        let _e97 = ceil((((_e77.x - _e77.w) - _e94) - 0.5f));
        let _e99 = select(_e91, _e97, (_e97 > _e91));
        let _e101 = select(_e92, _e99, (_e99 < _e92));
        let _e104 = (((_e77.x + _e77.w) - _e94) + 0.5f);
        let _e106 = select(_e91, _e104, (_e104 > _e91));
        let _e108 = select(_e92, _e106, (_e106 < _e92));
        let _e109 = bitcast<f32>(0u);
        let _e110 = bitcast<f32>(1333788671u);
        let _e116 = select(select(u32(_e101), 0u, !((_e101 >= _e109))), 4294967295u, (_e101 > _e110));
        let _e122 = select(select(u32(_e108), 0u, !((_e108 >= _e109))), 4294967295u, (_e108 > _e110));
        let _e125 = global_3.member.member_3;
        let _e128 = global_3.member.member_4;
        let _e132 = f32(_e125);
        let _e133 = f32((_e125 + _e128));
        let _e135 = f32(_e70);
        let _e138 = ceil((((_e77.y - _e81.w) - _e135) - 0.5f));
        let _e140 = select(_e132, _e138, (_e138 > _e132));
        let _e142 = select(_e133, _e140, (_e140 < _e133));
        let _e145 = (((_e77.y + _e81.w) - _e135) + 0.5f);
        let _e147 = select(_e132, _e145, (_e145 > _e132));
        let _e149 = select(_e133, _e147, (_e147 < _e133));
        let _e155 = select(select(u32(_e142), 0u, !((_e142 >= _e109))), 4294967295u, (_e142 > _e110));
        let _e161 = select(select(u32(_e149), 0u, !((_e149 >= _e109))), 4294967295u, (_e149 > _e110));
        if (_e116 < _e122) {
            if (_e155 < _e161) {
                let _e165 = (_e122 - _e116);
                let _e167 = select(_e88, _e165, (_e165 < _e88));
                let _e168 = (_e88 - _e167);
                let _e170 = select(_e168, _e116, (_e116 < _e168));
                let _e177 = (_e88 * _e88);
                phi_300_ = _e155;
                phi_303_ = 0f;
                phi_304_ = 0f;
                phi_305_ = 0f;
                phi_307_ = 0f;
                phi_308_ = 0f;
                phi_309_ = 0f;
                phi_310_ = 0f;
                phi_312_ = 0f;
                phi_314_ = 0f;
                loop {
                    let _e185 = phi_300_;
                    let _e187 = phi_303_;
                    let _e189 = phi_304_;
                    let _e191 = phi_305_;
                    let _e193 = phi_307_;
                    let _e195 = phi_308_;
                    let _e197 = phi_309_;
                    let _e199 = phi_310_;
                    let _e201 = phi_312_;
                    let _e203 = phi_314_;
                    local_5 = _e195;
                    local_6 = _e193;
                    local_7 = _e195;
                    local_8 = _e193;
                    local_9 = _e197;
                    local_10 = _e191;
                    local_11 = _e189;
                    local_12 = _e187;
                    local_13 = _e197;
                    local_14 = _e203;
                    local_15 = _e201;
                    local_16 = _e199;
                    if (_e185 < _e161) {
                        let _e209 = ((f32((_e70 + bitcast<i32>(_e185))) + 0.5f) - _e77.y);
                        let _e212 = ((_e88 * ((_e62 * _e88) + _e185)) + _e170);
                        phi_327_ = ((f32((_e66 + bitcast<i32>(_e170))) + 0.5f) + 0f);
                        phi_329_ = _e212;
                        phi_331_ = 0f;
                        phi_332_ = 0f;
                        phi_306_ = _e191;
                        phi_311_ = _e199;
                        phi_313_ = _e201;
                        phi_315_ = _e203;
                        loop {
                            let _e215 = phi_327_;
                            let _e217 = phi_329_;
                            let _e219 = phi_331_;
                            let _e221 = phi_332_;
                            let _e223 = phi_306_;
                            let _e225 = phi_311_;
                            let _e227 = phi_313_;
                            let _e229 = phi_315_;
                            local_22 = _e223;
                            local_26 = _e225;
                            local_27 = _e227;
                            local_28 = _e229;
                            local_1 = _e221;
                            local_2 = _e219;
                            local_3 = _e221;
                            local_4 = _e219;
                            if (_e217 < (_e212 + _e167)) {
                                let _e231 = (_e215 - _e77.x);
                                let _e233 = ((_e81.y * _e231) * _e209);
                                let _e240 = ((((_e81.x * _e231) * _e231) + (_e233 + _e233)) + ((_e81.z * _e209) * _e209));
                                let _e245 = (_e240 <= 11.082527f);
                                let _e246 = select(0f, exp((-0.5f * select(0f, _e240, (_e240 > 0f)))), _e245);
                                let _e249 = global_8.member[_e217];
                                let _e253 = global_8.member[(_e217 + _e177)];
                                let _e258 = global_8.member[(_e217 + (2u * _e177))];
                                let _e263 = global_8.member[(_e217 + (3u * _e177))];
                                let _e271 = select(0f, (_e246 * ((((_e249 * _e85.x) + (_e253 * _e85.y)) + (_e258 * _e85.z)) + _e263)), _e245);
                                let _e272 = (_e271 * _e231);
                                local_29 = (_e215 + f32(1u));
                                local_30 = (_e217 + 1u);
                                local_31 = (_e219 + _e272);
                                local_32 = (_e221 + _e271);
                                local_33 = (_e223 + (_e272 * _e231));
                                local_34 = select(_e225, (_e225 + (_e246 * _e258)), _e245);
                                local_35 = select(_e227, (_e227 + (_e246 * _e253)), _e245);
                                local_36 = select(_e229, (_e229 + (_e246 * _e249)), _e245);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e452 = local_29;
                                phi_327_ = _e452;
                                let _e455 = local_30;
                                phi_329_ = _e455;
                                let _e458 = local_31;
                                phi_331_ = _e458;
                                let _e461 = local_32;
                                phi_332_ = _e461;
                                let _e464 = local_33;
                                phi_306_ = _e464;
                                let _e467 = local_34;
                                phi_311_ = _e467;
                                let _e470 = local_35;
                                phi_313_ = _e470;
                                let _e473 = local_36;
                                phi_315_ = _e473;
                            }
                        }
                        let _e289 = local_1;
                        let _e292 = local_2;
                        let _e295 = local_3;
                        let _e296 = (_e295 * _e209);
                        let _e299 = local_4;
                        local_19 = (_e185 + 1u);
                        local_20 = (_e187 + (_e296 * _e209));
                        local_21 = (_e189 + (_e299 * _e209));
                        local_23 = (_e193 + _e296);
                        local_24 = (_e195 + _e292);
                        local_25 = (_e197 + _e289);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e422 = local_19;
                        phi_300_ = _e422;
                        let _e425 = local_20;
                        phi_303_ = _e425;
                        let _e428 = local_21;
                        phi_304_ = _e428;
                        let _e431 = local_22;
                        phi_305_ = _e431;
                        let _e434 = local_23;
                        phi_307_ = _e434;
                        let _e437 = local_24;
                        phi_308_ = _e437;
                        let _e440 = local_25;
                        phi_309_ = _e440;
                        let _e443 = local_26;
                        phi_310_ = _e443;
                        let _e446 = local_27;
                        phi_312_ = _e446;
                        let _e449 = local_28;
                        phi_314_ = _e449;
                    }
                }
                let _e308 = global_3.member.member_5;
                let _e310 = (1f - (_e308 * _e81.x));
                let _e312 = (1f - (_e308 * _e81.z));
                let _e313 = (_e308 * _e81.y);
                let _e316 = ((_e310 * _e312) - (_e313 * _e313));
                let _e317 = (_e308 > 0f);
                if _e317 {
                    if (_e316 > (0.003921569f * 0.003921569f)) {
                        let _e323 = ((-0.5f * _e308) / _e316);
                        phi_371_ = vec3<f32>((_e312 * _e323), ((2f * _e313) * _e323), (_e310 * _e323));
                        phi_372_ = sqrt(_e316);
                    } else {
                        phi_371_ = vec3<f32>(0f, 0f, 0f);
                        phi_372_ = 0.003921569f;
                    }
                    let _e329 = phi_371_;
                    let _e331 = phi_372_;
                    phi_373_ = _e329;
                    phi_374_ = _e331;
                } else {
                    phi_373_ = vec3<f32>(0f, 0f, 0f);
                    phi_374_ = 1f;
                }
                let _e333 = phi_373_;
                let _e335 = phi_374_;
                let _e337 = local_5;
                let _e340 = local_6;
                let _e345 = local_7;
                let _e348 = local_8;
                let _e353 = local_9;
                let _e356 = local_10;
                let _e359 = local_11;
                let _e362 = local_12;
                let _e364 = ((-0.5f * _e356) * _e77.z);
                let _e365 = ((-1f * _e359) * _e77.z);
                let _e366 = ((-0.5f * _e362) * _e77.z);
                if _e317 {
                    let _e369 = local_13;
                    let _e370 = (_e369 * _e77.z);
                    phi_383_ = vec3<f32>((_e364 + (_e333.x * _e370)), (_e365 + (_e333.y * _e370)), (_e366 + (_e333.z * _e370)));
                } else {
                    phi_383_ = vec3<f32>(_e364, _e365, _e366);
                }
                let _e382 = phi_383_;
                let _e383 = (_e38 * 3u);
                let _e386 = global_9.member[_e383];
                global_9.member[_e383] = (_e386 + vec4<f32>((_e77.z * ((_e81.x * _e337) + (_e81.y * _e340))), (_e77.z * ((_e81.y * _e345) + (_e81.z * _e348))), (_e353 * _e335), 0f));
                let _e392 = global_9.member[(_e383 + 1u)];
                global_9.member[(_e383 + 1u)] = (_e392 + vec4<f32>(_e382.x, _e382.y, _e382.z, 0f));
                let _e401 = global_9.member[(_e383 + 2u)];
                let _e403 = local_14;
                let _e406 = local_15;
                let _e409 = local_16;
                global_9.member[(_e383 + 2u)] = (_e401 + vec4<f32>((_e403 * _e77.z), (_e406 * _e77.z), (_e409 * _e77.z), 0f));
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
