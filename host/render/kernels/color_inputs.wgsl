struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage> global_6: type_15;
@group(0) @binding(3) 
var<storage> global_7: type_15;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_15;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_15;
@group(0) @binding(5) 
var<storage> global_10: type_15;

fn function_() {
    var phi_340_: f32;
    var phi_343_: u32;
    var phi_345_: f32;
    var phi_347_: f32;
    var phi_341_: f32;
    var phi_346_: f32;
    var phi_348_: f32;
    var phi_360_: f32;
    var phi_363_: u32;
    var phi_365_: f32;
    var phi_361_: f32;
    var phi_391_: u32;
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
            let _e44 = global;
            let _e45 = global_1;
            let _e46 = global_2;
            let _e54 = (((_e45.x + (_e45.y * _e46.x)) * 64u) + _e44.x);
            let _e57 = global_3.member.member;
            if (_e54 < _e57) {
                let _e61 = global_3.member.member_1;
                let _e65 = global_4.member[(_e61 + _e54)];
                let _e68 = global_3.member.member_3;
                let _e69 = (_e68 == 0u);
                if _e69 {
                    break;
                }
                let _e70 = (_e65 % _e68);
                if _e69 {
                    break;
                }
                let _e72 = ((_e65 / _e68) * 18u);
                let _e76 = global_5.member[(_e72 + 9u)];
                let _e80 = global_5.member[(_e72 + 10u)];
                let _e84 = global_5.member[(_e72 + 11u)];
                let _e85 = (_e70 * 3u);
                let _e88 = global_6.member[_e85];
                let _e92 = global_6.member[(_e85 + 1u)];
                let _e96 = global_6.member[(_e85 + 2u)];
                let _e99 = global_3.member.member_2;
                let _e102 = global_7.member[0u];
                let _e105 = global_7.member[1u];
                let _e108 = global_7.member[2u];
                let _e111 = global_7.member[3u];
                let _e114 = global_7.member[4u];
                let _e117 = global_7.member[5u];
                let _e120 = global_7.member[6u];
                let _e123 = global_7.member[7u];
                let _e126 = global_7.member[8u];
                let _e129 = global_7.member[9u];
                let _e132 = global_7.member[10u];
                let _e135 = global_7.member[11u];
                let _e138 = global_7.member[12u];
                let _e141 = global_7.member[13u];
                let _e144 = global_7.member[14u];
                let _e147 = global_7.member[15u];
                let _e150 = global_7.member[16u];
                let _e153 = global_7.member[17u];
                let _e160 = (trunc((_e88 * _e111)) * _e102);
                let _e161 = (trunc((_e92 * _e114)) * _e105);
                let _e162 = (trunc((_e96 * _e117)) * _e108);
                let _e163 = (_e160 - _e120);
                let _e164 = (_e161 - _e123);
                let _e165 = (_e162 - _e126);
                let _e172 = (_e163 * _e138);
                let _e173 = (_e164 * _e141);
                let _e174 = (_e165 * _e144);
                let _e184 = ((_e163 * _e147) + (((_e88 - _e160) - _e129) * (_e138 + _e147)));
                let _e185 = ((_e164 * _e150) + (((_e92 - _e161) - _e132) * (_e141 + _e150)));
                let _e186 = ((_e165 * _e153) + (((_e96 - _e162) - _e135) * (_e144 + _e153)));
                let _e190 = (trunc(((_e172 + _e184) * 4096f)) * 0.00024414063f);
                let _e192 = ((_e172 - _e190) + _e184);
                let _e196 = (trunc(((_e173 + _e185) * 4096f)) * 0.00024414063f);
                let _e198 = ((_e173 - _e196) + _e185);
                let _e202 = (trunc(((_e174 + _e186) * 4096f)) * 0.00024414063f);
                let _e204 = ((_e174 - _e202) + _e186);
                let _e207 = global_3.member.member_7;
                if (_e207 == 0u) {
                    global_8.member[_e54] = _e190;
                    global_8.member[(_e99 + _e54)] = _e196;
                    global_8.member[((2u * _e99) + _e54)] = _e202;
                    global_8.member[((3u * _e99) + _e54)] = _e192;
                    global_8.member[((4u * _e99) + _e54)] = _e198;
                    global_8.member[((5u * _e99) + _e54)] = _e204;
                } else {
                    let _e231 = ((_e190 - 0.5f) + _e192);
                    let _e233 = ((_e196 - 0.5f) + _e198);
                    let _e235 = ((_e202 - 0.5f) + _e204);
                    let _e238 = select(_e231, -(_e231), (_e231 < 0f));
                    let _e241 = select(_e233, -(_e233), (_e233 < 0f));
                    let _e243 = select(_e241, _e238, (_e238 > _e241));
                    let _e246 = select(_e235, -(_e235), (_e235 < 0f));
                    let _e248 = select(_e246, _e243, (_e243 > _e246));
                    let _e250 = select(0.25f, _e248, (_e248 > 0.25f));
                    let _e255 = select(1f, ((0.5f - (0.0625f / _e250)) / _e250), (0.25f < _e250));
                    let _e256 = (_e231 * _e255);
                    let _e260 = (trunc(((0.5f + _e256) * 4096f)) * 0.00024414063f);
                    let _e263 = (_e233 * _e255);
                    let _e267 = (trunc(((0.5f + _e263) * 4096f)) * 0.00024414063f);
                    let _e270 = (_e235 * _e255);
                    let _e274 = (trunc(((0.5f + _e270) * 4096f)) * 0.00024414063f);
                    global_8.member[_e54] = _e260;
                    global_8.member[(_e99 + _e54)] = _e267;
                    global_8.member[((2u * _e99) + _e54)] = _e274;
                    global_8.member[((3u * _e99) + _e54)] = ((0.5f - _e260) + _e256);
                    global_8.member[((4u * _e99) + _e54)] = ((0.5f - _e267) + _e263);
                    global_8.member[((5u * _e99) + _e54)] = ((0.5f - _e274) + _e270);
                }
                let _e298 = (_e88 - _e76);
                let _e299 = (_e92 - _e80);
                let _e300 = (_e96 - _e84);
                let _e305 = (((_e298 * _e298) + (_e299 * _e299)) + (_e300 * _e300));
                let _e309 = (1f / sqrt(select(0.000000000000000000000000000000000000011754944f, _e305, (_e305 > 0.000000000000000000000000000000000000011754944f))));
                let _e310 = (_e298 * _e309);
                let _e311 = (_e299 * _e309);
                let _e315 = global_3.member.member_4;
                phi_340_ = 0f;
                phi_343_ = 0u;
                phi_345_ = 0.28209478f;
                phi_347_ = 1f;
                loop {
                    let _e317 = phi_340_;
                    let _e319 = phi_343_;
                    let _e321 = phi_345_;
                    let _e323 = phi_347_;
                    if (_e319 <= _e315) {
                        let _e325 = f32(_e319);
                        let _e326 = (_e319 > 0u);
                        if _e326 {
                            let _e327 = (2f * _e325);
                            phi_341_ = ((_e310 * _e317) + (_e311 * _e323));
                            phi_346_ = (_e321 * -(sqrt(((_e327 + 1f) / _e327))));
                            phi_348_ = ((_e310 * _e323) - (_e311 * _e317));
                        } else {
                            phi_341_ = _e317;
                            phi_346_ = _e321;
                            phi_348_ = _e323;
                        }
                        let _e340 = phi_341_;
                        let _e342 = phi_346_;
                        let _e344 = phi_348_;
                        local = _e340;
                        local_2 = _e342;
                        local_3 = _e344;
                        phi_360_ = _e342;
                        phi_363_ = _e319;
                        phi_365_ = 0f;
                        loop {
                            let _e347 = phi_360_;
                            let _e349 = phi_363_;
                            let _e351 = phi_365_;
                            if (_e349 <= _e315) {
                                let _e353 = (_e349 > _e319);
                                if _e353 {
                                    let _e354 = f32(_e349);
                                    let _e355 = (_e354 - 1f);
                                    let _e360 = (_e325 * _e325);
                                    phi_361_ = (sqrt(((((4f * _e354) * _e354) - 1f) / ((_e354 * _e354) - _e360))) * (((_e300 * _e309) * _e347) - (sqrt((((_e355 * _e355) - _e360) / (((4f * _e355) * _e355) - 1f))) * _e351)));
                                } else {
                                    phi_361_ = _e347;
                                }
                                let _e376 = phi_361_;
                                let _e379 = ((_e349 * _e349) + _e349);
                                let _e383 = (select(1f, 1.4142135f, _e326) * _e376);
                                global_9.member[(_e54 + ((_e379 + _e319) * _e99))] = (_e383 * _e344);
                                local_4 = _e376;
                                local_6 = select(_e351, _e347, _e353);
                                if _e326 {
                                    global_9.member[(_e54 + ((_e379 - _e319) * _e99))] = (_e383 * _e340);
                                }
                                local_5 = (_e349 + 1u);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e432 = local_4;
                                phi_360_ = _e432;
                                let _e435 = local_5;
                                phi_363_ = _e435;
                                let _e438 = local_6;
                                phi_365_ = _e438;
                            }
                        }
                        local_1 = (_e319 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e417 = local;
                        phi_340_ = _e417;
                        let _e420 = local_1;
                        phi_343_ = _e420;
                        let _e423 = local_2;
                        phi_345_ = _e423;
                        let _e426 = local_3;
                        phi_347_ = _e426;
                    }
                }
                phi_391_ = 0u;
                loop {
                    let _e396 = phi_391_;
                    let _e399 = global_3.member.member_5;
                    if (_e396 < _e399) {
                        let _e405 = global_10.member[((_e70 * _e399) + _e396)];
                        let _e408 = global_3.member.member_6;
                        global_9.member[(((_e408 + _e396) * _e99) + _e54)] = _e405;
                        local_7 = (_e396 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e442 = local_7;
                        phi_391_ = _e442;
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
