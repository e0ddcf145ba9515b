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
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_11;
@group(0) @binding(2) 
var<storage> global_4: type_5;
@group(0) @binding(0) 
var<uniform> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage> global_8: type_5;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_5;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_5;

fn function_() {
    var phi_342_: f32;
    var phi_345_: u32;
    var phi_347_: f32;
    var phi_349_: f32;
    var phi_343_: f32;
    var phi_348_: f32;
    var phi_350_: f32;
    var phi_362_: f32;
    var phi_365_: u32;
    var phi_367_: f32;
    var phi_363_: f32;
    var phi_393_: u32;
    var local: f32;
    var local_1: u32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: u32;
    var local_6: f32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e46 = global;
            let _e47 = global_1;
            let _e48 = global_2;
            let _e56 = (((_e47.x + (_e47.y * _e48.x)) * 64u) + _e46.x);
            let _e59 = global_5.member.member;
            if (_e56 < _e59) {
                let _e63 = global_5.member.member_1;
                let _e67 = global_3.member[(_e63 + _e56)];
                let _e70 = global_5.member.member_3;
                let _e71 = (_e70 == 0u);
                if _e71 {
                    break;
                }
                let _e72 = (_e67 % _e70);
                if _e71 {
                    break;
                }
                let _e74 = ((_e67 / _e70) * 18u);
                let _e78 = global_4.member[(_e74 + 9u)];
                let _e82 = global_4.member[(_e74 + 10u)];
                let _e86 = global_4.member[(_e74 + 11u)];
                let _e87 = (_e72 * 3u);
                let _e90 = global_7.member[_e87];
                let _e94 = global_7.member[(_e87 + 1u)];
                let _e98 = global_7.member[(_e87 + 2u)];
                let _e101 = global_5.member.member_2;
                let _e104 = global_6.member[0u];
                let _e107 = global_6.member[1u];
                let _e110 = global_6.member[2u];
                let _e113 = global_6.member[3u];
                let _e116 = global_6.member[4u];
                let _e119 = global_6.member[5u];
                let _e122 = global_6.member[6u];
                let _e125 = global_6.member[7u];
                let _e128 = global_6.member[8u];
                let _e131 = global_6.member[9u];
                let _e134 = global_6.member[10u];
                let _e137 = global_6.member[11u];
                let _e140 = global_6.member[12u];
                let _e143 = global_6.member[13u];
                let _e146 = global_6.member[14u];
                let _e149 = global_6.member[15u];
                let _e152 = global_6.member[16u];
                let _e155 = global_6.member[17u];
                let _e162 = (trunc((_e90 * _e113)) * _e104);
                let _e163 = (trunc((_e94 * _e116)) * _e107);
                let _e164 = (trunc((_e98 * _e119)) * _e110);
                let _e165 = (_e162 - _e122);
                let _e166 = (_e163 - _e125);
                let _e167 = (_e164 - _e128);
                let _e174 = (_e165 * _e140);
                let _e175 = (_e166 * _e143);
                let _e176 = (_e167 * _e146);
                let _e186 = ((_e165 * _e149) + (((_e90 - _e162) - _e131) * (_e140 + _e149)));
                let _e187 = ((_e166 * _e152) + (((_e94 - _e163) - _e134) * (_e143 + _e152)));
                let _e188 = ((_e167 * _e155) + (((_e98 - _e164) - _e137) * (_e146 + _e155)));
                let _e192 = (trunc(((_e174 + _e186) * 4096f)) * 0.00024414063f);
                let _e194 = ((_e174 - _e192) + _e186);
                let _e198 = (trunc(((_e175 + _e187) * 4096f)) * 0.00024414063f);
                let _e200 = ((_e175 - _e198) + _e187);
                let _e204 = (trunc(((_e176 + _e188) * 4096f)) * 0.00024414063f);
                let _e206 = ((_e176 - _e204) + _e188);
                let _e209 = global_5.member.member_7;
                if (_e209 == 0u) {
                    global_9.member[_e56] = _e192;
                    global_9.member[(_e101 + _e56)] = _e198;
                    global_9.member[((2u * _e101) + _e56)] = _e204;
                    global_9.member[((3u * _e101) + _e56)] = _e194;
                    global_9.member[((4u * _e101) + _e56)] = _e200;
                    global_9.member[((5u * _e101) + _e56)] = _e206;
                } else {
                    let _e233 = ((_e192 - 0.5f) + _e194);
                    let _e235 = ((_e198 - 0.5f) + _e200);
                    let _e237 = ((_e204 - 0.5f) + _e206);
                    let _e240 = select(_e233, -(_e233), (_e233 < 0f));
                    let _e243 = select(_e235, -(_e235), (_e235 < 0f));
                    let _e245 = select(_e243, _e240, (_e240 > _e243));
                    let _e248 = select(_e237, -(_e237), (_e237 < 0f));
                    let _e250 = select(_e248, _e245, (_e245 > _e248));
                    let _e252 = select(0.25f, _e250, (_e250 > 0.25f));
                    let _e257 = select(1f, ((0.5f - (0.0625f / _e252)) / _e252), (0.25f < _e252));
                    let _e258 = (_e233 * _e257);
                    let _e262 = (trunc(((0.5f + _e258) * 4096f)) * 0.00024414063f);
                    let _e265 = (_e235 * _e257);
                    let _e269 = (trunc(((0.5f + _e265) * 4096f)) * 0.00024414063f);
                    let _e272 = (_e237 * _e257);
                    let _e276 = (trunc(((0.5f + _e272) * 4096f)) * 0.00024414063f);
                    global_9.member[_e56] = _e262;
                    global_9.member[(_e101 + _e56)] = _e269;
                    global_9.member[((2u * _e101) + _e56)] = _e276;
                    global_9.member[((3u * _e101) + _e56)] = ((0.5f - _e262) + _e258);
                    global_9.member[((4u * _e101) + _e56)] = ((0.5f - _e269) + _e265);
                    global_9.member[((5u * _e101) + _e56)] = ((0.5f - _e276) + _e272);
                }
                let _e300 = (_e90 - _e78);
                let _e301 = (_e94 - _e82);
                let _e302 = (_e98 - _e86);
                let _e308 = sqrt((((_e300 * _e300) + (_e301 * _e301)) + (_e302 * _e302)));
                let _e311 = (1f / select(0.000000000000000000000000000000000000011754944f, _e308, (_e308 > 0.000000000000000000000000000000000000011754944f)));
                let _e312 = (_e300 * _e311);
                let _e313 = (_e301 * _e311);
                let _e317 = global_5.member.member_4;
                phi_342_ = 0f;
                phi_345_ = 0u;
                phi_347_ = 0.28209478f;
                phi_349_ = 1f;
                loop {
                    let _e319 = phi_342_;
                    let _e321 = phi_345_;
                    let _e323 = phi_347_;
                    let _e325 = phi_349_;
                    if (_e321 <= _e317) {
                        let _e327 = f32(_e321);
                        let _e328 = (_e321 > 0u);
                        if _e328 {
                            let _e329 = (2f * _e327);
                            phi_343_ = ((_e312 * _e319) + (_e313 * _e325));
                            phi_348_ = (_e323 * -(sqrt(((_e329 + 1f) / _e329))));
                            phi_350_ = ((_e312 * _e325) - (_e313 * _e319));
                        } else {
                            phi_343_ = _e319;
                            phi_348_ = _e323;
                            phi_350_ = _e325;
                        }
                        let _e342 = phi_343_;
                        let _e344 = phi_348_;
                        let _e346 = phi_350_;
                        local = _e342;
                        local_2 = _e344;
                        local_3 = _e346;
                        phi_362_ = _e344;
                        phi_365_ = _e321;
                        phi_367_ = 0f;
                        loop {
                            let _e349 = phi_362_;
                            let _e351 = phi_365_;
                            let _e353 = phi_367_;
                            if (_e351 <= _e317) {
                                let _e355 = (_e351 > _e321);
                                if _e355 {
                                    let _e356 = f32(_e351);
                                    let _e357 = (_e356 - 1f);
                                    let _e362 = (_e327 * _e327);
                                    phi_363_ = (sqrt(((((4f * _e356) * _e356) - 1f) / ((_e356 * _e356) - _e362))) * (((_e302 * _e311) * _e349) - (sqrt((((_e357 * _e357) - _e362) / (((4f * _e357) * _e357) - 1f))) * _e353)));
                                } else {
                                    phi_363_ = _e349;
                                }
                                let _e378 = phi_363_;
                                let _e381 = ((_e351 * _e351) + _e351);
                                let _e385 = (select(1f, 1.4142135f, _e328) * _e378);
                                global_10.member[(_e56 + ((_e381 + _e321) * _e101))] = (_e385 * _e346);
                                local_4 = _e378;
                                local_6 = select(_e353, _e349, _e355);
                                if _e328 {
                                    global_10.member[(_e56 + ((_e381 - _e321) * _e101))] = (_e385 * _e342);
                                }
                                local_5 = (_e351 + 1u);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e434 = local_4;
                                phi_362_ = _e434;
                                let _e437 = local_5;
                                phi_365_ = _e437;
                                let _e440 = local_6;
                                phi_367_ = _e440;
                            }
                        }
                        local_1 = (_e321 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e419 = local;
                        phi_342_ = _e419;
                        let _e422 = local_1;
                        phi_345_ = _e422;
                        let _e425 = local_2;
                        phi_347_ = _e425;
                        let _e428 = local_3;
                        phi_349_ = _e428;
                    }
                }
                phi_393_ = 0u;
                loop {
                    let _e398 = phi_393_;
                    let _e401 = global_5.member.member_5;
                    if (_e398 < _e401) {
                        let _e407 = global_8.member[((_e72 * _e401) + _e398)];
                        let _e410 = global_5.member.member_6;
                        global_10.member[(((_e410 + _e398) * _e101) + _e56)] = _e407;
                        local_7 = (_e398 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e444 = local_7;
                        phi_393_ = _e444;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn color_inputs(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
