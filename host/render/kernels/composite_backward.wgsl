struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: f32,
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
    var phi_181_: u32;
    var phi_184_: u32;
    var local: u32;
    var phi_301_: u32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_306_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_313_: f32;
    var phi_315_: f32;
    var phi_328_: f32;
    var phi_330_: u32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_314_: f32;
    var phi_316_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var phi_372_: vec3<f32>;
    var phi_373_: f32;
    var phi_374_: vec3<f32>;
    var phi_375_: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_384_: vec3<f32>;
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

    let _e29 = global;
    let _e30 = global_1;
    let _e31 = global_2;
    let _e39 = (((_e30.x + (_e30.y * _e31.x)) * 64u) + _e29.x);
    let _e42 = global_3.member.member;
    if (_e39 < _e42) {
        let _e46 = global_3.member.member_1;
        phi_181_ = _e46;
        phi_184_ = 0u;
        loop {
            let _e48 = phi_181_;
            let _e50 = phi_184_;
            local = _e50;
            if ((_e50 + 1u) < _e48) {
                let _e54 = ((_e50 + _e48) / 2u);
                let _e57 = global_4.member[_e54];
                let _e58 = (_e57 <= _e39);
                local_17 = select(_e54, _e48, _e58);
                local_18 = select(_e50, _e54, _e58);
                continue;
            } else {
                break;
            }
            continuing {
                let _e420 = local_17;
                phi_181_ = _e420;
                let _e423 = local_18;
                phi_184_ = _e423;
            }
        }
        let _e62 = local;
        let _e63 = (_e62 * 4u);
        let _e67 = global_5.member[(_e63 + 1u)];
        let _e71 = global_5.member[(_e63 + 2u)];
        let _e74 = global_6.member[_e39];
        let _e75 = (_e74 * 3u);
        let _e78 = global_7.member[_e75];
        let _e82 = global_7.member[(_e75 + 1u)];
        let _e86 = global_7.member[(_e75 + 2u)];
        let _e89 = global_3.member.member_2;
        let _e92 = f32(0u);
        let _e93 = f32(_e89);
        let _e95 = f32(_e67);
        let _e98 = ceil((((_e78.x - _e78.w) - _e95) - 0.5f));
        let _e100 = select(_e92, _e98, (_e98 > _e92));
        let _e102 = select(_e93, _e100, (_e100 < _e93));
        let _e105 = (((_e78.x + _e78.w) - _e95) + 0.5f);
        let _e107 = select(_e92, _e105, (_e105 > _e92));
        let _e109 = select(_e93, _e107, (_e107 < _e93));
        let _e110 = bitcast<f32>(0u);
        let _e111 = bitcast<f32>(1333788671u);
        let _e117 = select(select(u32(_e102), 0u, !((_e102 >= _e110))), 4294967295u, (_e102 > _e111));
        let _e123 = select(select(u32(_e109), 0u, !((_e109 >= _e110))), 4294967295u, (_e109 > _e111));
        let _e126 = global_3.member.member_3;
        let _e129 = global_3.member.member_4;
        let _e133 = f32(_e126);
        let _e134 = f32((_e126 + _e129));
        let _e136 = f32(_e71);
        let _e139 = ceil((((_e78.y - _e82.w) - _e136) - 0.5f));
        let _e141 = select(_e133, _e139, (_e139 > _e133));
        let _e143 = select(_e134, _e141, (_e141 < _e134));
        let _e146 = (((_e78.y + _e82.w) - _e136) + 0.5f);
        let _e148 = select(_e133, _e146, (_e146 > _e133));
        let _e150 = select(_e134, _e148, (_e148 < _e134));
        let _e156 = select(select(u32(_e143), 0u, !((_e143 >= _e110))), 4294967295u, (_e143 > _e111));
        let _e162 = select(select(u32(_e150), 0u, !((_e150 >= _e110))), 4294967295u, (_e150 > _e111));
        if (_e117 < _e123) {
            if (_e156 < _e162) {
                let _e166 = (_e123 - _e117);
                let _e168 = select(_e89, _e166, (_e166 < _e89));
                let _e169 = (_e89 - _e168);
                let _e171 = select(_e169, _e117, (_e117 < _e169));
                let _e178 = (_e89 * _e89);
                phi_301_ = _e156;
                phi_304_ = 0f;
                phi_305_ = 0f;
                phi_306_ = 0f;
                phi_308_ = 0f;
                phi_309_ = 0f;
                phi_310_ = 0f;
                phi_311_ = 0f;
                phi_313_ = 0f;
                phi_315_ = 0f;
                loop {
                    let _e186 = phi_301_;
                    let _e188 = phi_304_;
                    let _e190 = phi_305_;
                    let _e192 = phi_306_;
                    let _e194 = phi_308_;
                    let _e196 = phi_309_;
                    let _e198 = phi_310_;
                    let _e200 = phi_311_;
                    let _e202 = phi_313_;
                    let _e204 = phi_315_;
                    local_5 = _e196;
                    local_6 = _e194;
                    local_7 = _e196;
                    local_8 = _e194;
                    local_9 = _e198;
                    local_10 = _e192;
                    local_11 = _e190;
                    local_12 = _e188;
                    local_13 = _e198;
                    local_14 = _e204;
                    local_15 = _e202;
                    local_16 = _e200;
                    if (_e186 < _e162) {
                        let _e210 = ((f32((_e71 + bitcast<i32>(_e186))) + 0.5f) - _e78.y);
                        let _e213 = ((_e89 * ((_e63 * _e89) + _e186)) + _e171);
                        phi_328_ = ((f32((_e67 + bitcast<i32>(_e171))) + 0.5f) + 0f);
                        phi_330_ = _e213;
                        phi_332_ = 0f;
                        phi_333_ = 0f;
                        phi_307_ = _e192;
                        phi_312_ = _e200;
                        phi_314_ = _e202;
                        phi_316_ = _e204;
                        loop {
                            let _e216 = phi_328_;
                            let _e218 = phi_330_;
                            let _e220 = phi_332_;
                            let _e222 = phi_333_;
                            let _e224 = phi_307_;
                            let _e226 = phi_312_;
                            let _e228 = phi_314_;
                            let _e230 = phi_316_;
                            local_22 = _e224;
                            local_26 = _e226;
                            local_27 = _e228;
                            local_28 = _e230;
                            local_1 = _e222;
                            local_2 = _e220;
                            local_3 = _e222;
                            local_4 = _e220;
                            if (_e218 < (_e213 + _e168)) {
                                let _e232 = (_e216 - _e78.x);
                                let _e234 = ((_e82.y * _e232) * _e210);
                                let _e241 = ((((_e82.x * _e232) * _e232) + (_e234 + _e234)) + ((_e82.z * _e210) * _e210));
                                let _e246 = (_e241 <= 11.082527f);
                                let _e247 = select(0f, exp((-0.5f * select(0f, _e241, (_e241 > 0f)))), _e246);
                                let _e250 = global_8.member[_e218];
                                let _e254 = global_8.member[(_e218 + _e178)];
                                let _e259 = global_8.member[(_e218 + (2u * _e178))];
                                let _e264 = global_8.member[(_e218 + (3u * _e178))];
                                let _e272 = select(0f, (_e247 * ((((_e250 * _e86.x) + (_e254 * _e86.y)) + (_e259 * _e86.z)) + _e264)), _e246);
                                let _e273 = (_e272 * _e232);
                                local_29 = (_e216 + f32(1u));
                                local_30 = (_e218 + 1u);
                                local_31 = (_e220 + _e273);
                                local_32 = (_e222 + _e272);
                                local_33 = (_e224 + (_e273 * _e232));
                                local_34 = select(_e226, (_e226 + (_e247 * _e259)), _e246);
                                local_35 = select(_e228, (_e228 + (_e247 * _e254)), _e246);
                                local_36 = select(_e230, (_e230 + (_e247 * _e250)), _e246);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e457 = local_29;
                                phi_328_ = _e457;
                                let _e460 = local_30;
                                phi_330_ = _e460;
                                let _e463 = local_31;
                                phi_332_ = _e463;
                                let _e466 = local_32;
                                phi_333_ = _e466;
                                let _e469 = local_33;
                                phi_307_ = _e469;
                                let _e472 = local_34;
                                phi_312_ = _e472;
                                let _e475 = local_35;
                                phi_314_ = _e475;
                                let _e478 = local_36;
                                phi_316_ = _e478;
                            }
                        }
                        let _e290 = local_1;
                        let _e293 = local_2;
                        let _e296 = local_3;
                        let _e297 = (_e296 * _e210);
                        let _e300 = local_4;
                        local_19 = (_e186 + 1u);
                        local_20 = (_e188 + (_e297 * _e210));
                        local_21 = (_e190 + (_e300 * _e210));
                        local_23 = (_e194 + _e297);
                        local_24 = (_e196 + _e293);
                        local_25 = (_e198 + _e290);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e427 = local_19;
                        phi_301_ = _e427;
                        let _e430 = local_20;
                        phi_304_ = _e430;
                        let _e433 = local_21;
                        phi_305_ = _e433;
                        let _e436 = local_22;
                        phi_306_ = _e436;
                        let _e439 = local_23;
                        phi_308_ = _e439;
                        let _e442 = local_24;
                        phi_309_ = _e442;
                        let _e445 = local_25;
                        phi_310_ = _e445;
                        let _e448 = local_26;
                        phi_311_ = _e448;
                        let _e451 = local_27;
                        phi_313_ = _e451;
                        let _e454 = local_28;
                        phi_315_ = _e454;
                    }
                }
                let _e309 = global_3.member.member_6;
                let _e311 = (1f - (_e309 * _e82.x));
                let _e313 = (1f - (_e309 * _e82.z));
                let _e314 = (_e309 * _e82.y);
                let _e317 = ((_e311 * _e313) - (_e314 * _e314));
                let _e318 = (_e309 > 0f);
                if _e318 {
                    if (_e317 > (0.003921569f * 0.003921569f)) {
                        let _e324 = ((-0.5f * _e309) / _e317);
                        phi_372_ = vec3<f32>((_e313 * _e324), ((2f * _e314) * _e324), (_e311 * _e324));
                        phi_373_ = sqrt(_e317);
                    } else {
                        phi_372_ = vec3<f32>(0f, 0f, 0f);
                        phi_373_ = 0.003921569f;
                    }
                    let _e330 = phi_372_;
                    let _e332 = phi_373_;
                    phi_374_ = _e330;
                    phi_375_ = _e332;
                } else {
                    phi_374_ = vec3<f32>(0f, 0f, 0f);
                    phi_375_ = 1f;
                }
                let _e334 = phi_374_;
                let _e336 = phi_375_;
                let _e338 = local_5;
                let _e341 = local_6;
                let _e346 = local_7;
                let _e349 = local_8;
                let _e354 = local_9;
                let _e357 = local_10;
                let _e360 = local_11;
                let _e363 = local_12;
                let _e365 = ((-0.5f * _e357) * _e78.z);
                let _e366 = ((-1f * _e360) * _e78.z);
                let _e367 = ((-0.5f * _e363) * _e78.z);
                if _e318 {
                    let _e370 = local_13;
                    let _e371 = (_e370 * _e78.z);
                    phi_384_ = vec3<f32>((_e365 + (_e334.x * _e371)), (_e366 + (_e334.y * _e371)), (_e367 + (_e334.z * _e371)));
                } else {
                    phi_384_ = vec3<f32>(_e365, _e366, _e367);
                }
                let _e383 = phi_384_;
                let _e384 = (_e39 * 3u);
                let _e387 = global_9.member[_e384];
                global_9.member[_e384] = (_e387 + vec4<f32>((_e78.z * ((_e82.x * _e338) + (_e82.y * _e341))), (_e78.z * ((_e82.y * _e346) + (_e82.z * _e349))), (_e354 * _e336), 0f));
                let _e393 = global_9.member[(_e384 + 1u)];
                global_9.member[(_e384 + 1u)] = (_e393 + vec4<f32>(_e383.x, _e383.y, _e383.z, 0f));
                let _e401 = global_3.member.member_5;
                if (_e401 == 0u) {
                } else {
                    let _e406 = global_9.member[(_e384 + 2u)];
                    let _e408 = local_14;
                    let _e411 = local_15;
                    let _e414 = local_16;
                    global_9.member[(_e384 + 2u)] = (_e406 + vec4<f32>((_e408 * _e78.z), (_e411 * _e78.z), (_e414 * _e78.z), 0f));
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
