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

struct type_17 {
    member: f32,
    member_1: f32,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_15;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_5;
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
    var phi_316_: array<type_17, 3>;
    var phi_344_: f32;
    var phi_347_: u32;
    var phi_349_: f32;
    var phi_351_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_370_: f32;
    var phi_373_: u32;
    var phi_375_: f32;
    var phi_390_: f32;
    var phi_371_: f32;
    var phi_374_: u32;
    var phi_376_: f32;
    var phi_345_: f32;
    var phi_348_: u32;
    var phi_350_: f32;
    var phi_352_: f32;
    var phi_408_: u32;
    var phi_409_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e46 = global;
            let _e47 = global_1;
            let _e48 = global_2;
            let _e56 = (((_e47.x + (_e47.y * _e48.x)) * 64u) + _e46.x);
            let _e59 = global_3.member.member;
            if (_e56 < _e59) {
                let _e63 = global_3.member.member_1;
                let _e67 = global_4.member[(_e63 + _e56)];
                let _e70 = global_3.member.member_3;
                let _e71 = (_e70 == 0u);
                if _e71 {
                    break;
                }
                let _e72 = (_e67 % _e70);
                if _e71 {
                    break;
                }
                let _e74 = ((_e67 / _e70) * 18u);
                let _e78 = global_5.member[(_e74 + 9u)];
                let _e82 = global_5.member[(_e74 + 10u)];
                let _e86 = global_5.member[(_e74 + 11u)];
                let _e87 = (_e72 * 3u);
                let _e90 = global_7.member[_e87];
                let _e94 = global_7.member[(_e87 + 1u)];
                let _e98 = global_7.member[(_e87 + 2u)];
                let _e101 = global_3.member.member_2;
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
                let _e212 = ((_e192 - 0.5f) + _e194);
                let _e214 = ((_e198 - 0.5f) + _e200);
                let _e216 = ((_e204 - 0.5f) + _e206);
                let _e219 = global_3.member.member_7;
                if (_e219 == 0u) {
                    phi_316_ = array<type_17, 3>(type_17(_e192, _e194), type_17(_e198, _e200), type_17(_e204, _e206));
                } else {
                    let _e223 = select(_e212, -(_e212), (_e212 < 0f));
                    let _e226 = select(_e214, -(_e214), (_e214 < 0f));
                    let _e228 = select(_e226, _e223, (_e223 > _e226));
                    let _e231 = select(_e216, -(_e216), (_e216 < 0f));
                    let _e233 = select(_e231, _e228, (_e228 > _e231));
                    let _e235 = select(0.25f, _e233, (_e233 > 0.25f));
                    let _e240 = select(1f, ((0.5f - (0.0625f / _e235)) / _e235), (0.25f < _e235));
                    let _e241 = (_e212 * _e240);
                    let _e245 = (trunc(((0.5f + _e241) * 4096f)) * 0.00024414063f);
                    let _e248 = (_e214 * _e240);
                    let _e252 = (trunc(((0.5f + _e248) * 4096f)) * 0.00024414063f);
                    let _e255 = (_e216 * _e240);
                    let _e259 = (trunc(((0.5f + _e255) * 4096f)) * 0.00024414063f);
                    phi_316_ = array<type_17, 3>(type_17(_e245, ((0.5f - _e245) + _e241)), type_17(_e252, ((0.5f - _e252) + _e248)), type_17(_e259, ((0.5f - _e259) + _e255)));
                }
                let _e267 = phi_316_;
                global_9.member[_e56] = _e267[0].member;
                global_9.member[(_e101 + _e56)] = _e267[1].member;
                global_9.member[((2u * _e101) + _e56)] = _e267[2].member;
                global_9.member[((3u * _e101) + _e56)] = _e267[0].member_1;
                global_9.member[((4u * _e101) + _e56)] = _e267[1].member_1;
                global_9.member[((5u * _e101) + _e56)] = _e267[2].member_1;
                let _e301 = (_e90 - _e78);
                let _e302 = (_e94 - _e82);
                let _e303 = (_e98 - _e86);
                let _e309 = sqrt((((_e301 * _e301) + (_e302 * _e302)) + (_e303 * _e303)));
                let _e312 = (1f / select(0.000000000000000000000000000000000000011754944f, _e309, (_e309 > 0.000000000000000000000000000000000000011754944f)));
                let _e313 = (_e301 * _e312);
                let _e314 = (_e302 * _e312);
                let _e318 = global_3.member.member_4;
                phi_344_ = 0f;
                phi_347_ = 0u;
                phi_349_ = 0.28209478f;
                phi_351_ = 1f;
                loop {
                    let _e320 = phi_344_;
                    let _e322 = phi_347_;
                    let _e324 = phi_349_;
                    let _e326 = phi_351_;
                    let _e327 = (_e322 <= _e318);
                    if _e327 {
                        let _e328 = f32(_e322);
                        let _e329 = (_e322 > 0u);
                        if _e329 {
                            let _e330 = (2f * _e328);
                            phi_365_ = ((_e313 * _e320) + (_e314 * _e326));
                            phi_366_ = (_e324 * -(sqrt(((_e330 + 1f) / _e330))));
                            phi_367_ = ((_e313 * _e326) - (_e314 * _e320));
                        } else {
                            phi_365_ = _e320;
                            phi_366_ = _e324;
                            phi_367_ = _e326;
                        }
                        let _e343 = phi_365_;
                        let _e345 = phi_366_;
                        let _e347 = phi_367_;
                        phi_370_ = _e345;
                        phi_373_ = _e322;
                        phi_375_ = 0f;
                        loop {
                            let _e350 = phi_370_;
                            let _e352 = phi_373_;
                            let _e354 = phi_375_;
                            let _e355 = (_e352 <= _e318);
                            if _e355 {
                                let _e356 = (_e352 > _e322);
                                if _e356 {
                                    let _e357 = f32(_e352);
                                    let _e358 = (_e357 - 1f);
                                    let _e363 = (_e328 * _e328);
                                    phi_390_ = (sqrt(((((4f * _e357) * _e357) - 1f) / ((_e357 * _e357) - _e363))) * (((_e303 * _e312) * _e350) - (sqrt((((_e358 * _e358) - _e363) / (((4f * _e358) * _e358) - 1f))) * _e354)));
                                } else {
                                    phi_390_ = _e350;
                                }
                                let _e379 = phi_390_;
                                let _e382 = ((_e352 * _e352) + _e352);
                                let _e386 = (select(1f, 1.4142135f, _e329) * _e379);
                                global_10.member[(_e56 + ((_e382 + _e322) * _e101))] = (_e386 * _e347);
                                if _e329 {
                                    global_10.member[(_e56 + ((_e382 - _e322) * _e101))] = (_e386 * _e343);
                                }
                                phi_371_ = _e379;
                                phi_374_ = (_e352 + 1u);
                                phi_376_ = select(_e354, _e350, _e356);
                            } else {
                                phi_371_ = f32();
                                phi_374_ = u32();
                                phi_376_ = f32();
                            }
                            let _e398 = phi_371_;
                            let _e400 = phi_374_;
                            let _e402 = phi_376_;
                            continue;
                            continuing {
                                phi_370_ = _e398;
                                phi_373_ = _e400;
                                phi_375_ = _e402;
                                break if !(_e355);
                            }
                        }
                        phi_345_ = _e343;
                        phi_348_ = (_e322 + 1u);
                        phi_350_ = _e345;
                        phi_352_ = _e347;
                    } else {
                        phi_345_ = f32();
                        phi_348_ = u32();
                        phi_350_ = f32();
                        phi_352_ = f32();
                    }
                    let _e406 = phi_345_;
                    let _e408 = phi_348_;
                    let _e410 = phi_350_;
                    let _e412 = phi_352_;
                    continue;
                    continuing {
                        phi_344_ = _e406;
                        phi_347_ = _e408;
                        phi_349_ = _e410;
                        phi_351_ = _e412;
                        break if !(_e327);
                    }
                }
                phi_408_ = 0u;
                loop {
                    let _e415 = phi_408_;
                    let _e418 = global_3.member.member_5;
                    let _e419 = (_e415 < _e418);
                    if _e419 {
                        let _e424 = global_8.member[((_e72 * _e418) + _e415)];
                        let _e427 = global_3.member.member_6;
                        global_10.member[(((_e427 + _e415) * _e101) + _e56)] = _e424;
                        phi_409_ = (_e415 + 1u);
                    } else {
                        phi_409_ = u32();
                    }
                    let _e435 = phi_409_;
                    continue;
                    continuing {
                        phi_408_ = _e435;
                        break if !(_e419);
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
