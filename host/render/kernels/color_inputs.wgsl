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
    var phi_343_: f32;
    var phi_346_: u32;
    var phi_348_: f32;
    var phi_350_: f32;
    var phi_344_: f32;
    var phi_349_: f32;
    var phi_351_: f32;
    var phi_363_: f32;
    var phi_366_: u32;
    var phi_368_: f32;
    var phi_364_: f32;
    var phi_394_: u32;
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
            let _e43 = global;
            let _e44 = global_1;
            let _e45 = global_2;
            let _e53 = (((_e44.x + (_e44.y * _e45.x)) * 64u) + _e43.x);
            let _e56 = global_3.member.member;
            if (_e53 < _e56) {
                let _e60 = global_3.member.member_1;
                let _e64 = global_4.member[(_e60 + _e53)];
                let _e67 = global_3.member.member_3;
                let _e68 = (_e67 == 0u);
                if _e68 {
                    break;
                }
                let _e69 = (_e64 % _e67);
                if _e68 {
                    break;
                }
                let _e71 = ((_e64 / _e67) * 18u);
                let _e75 = global_5.member[(_e71 + 9u)];
                let _e79 = global_5.member[(_e71 + 10u)];
                let _e83 = global_5.member[(_e71 + 11u)];
                let _e84 = (_e69 * 3u);
                let _e87 = global_6.member[_e84];
                let _e91 = global_6.member[(_e84 + 1u)];
                let _e95 = global_6.member[(_e84 + 2u)];
                let _e98 = global_3.member.member_2;
                let _e101 = global_7.member[0u];
                let _e104 = global_7.member[1u];
                let _e107 = global_7.member[2u];
                let _e110 = global_7.member[3u];
                let _e113 = global_7.member[4u];
                let _e116 = global_7.member[5u];
                let _e119 = global_7.member[6u];
                let _e122 = global_7.member[7u];
                let _e125 = global_7.member[8u];
                let _e128 = global_7.member[9u];
                let _e131 = global_7.member[10u];
                let _e134 = global_7.member[11u];
                let _e137 = global_7.member[12u];
                let _e140 = global_7.member[13u];
                let _e143 = global_7.member[14u];
                let _e146 = global_7.member[15u];
                let _e149 = global_7.member[16u];
                let _e152 = global_7.member[17u];
                let _e155 = (trunc((_e87 * _e110)) * _e101);
                let _e156 = (_e155 - _e119);
                let _e162 = ((_e156 * _e146) + (((_e87 - _e155) - _e128) * (_e137 + _e146)));
                let _e163 = (_e156 * _e137);
                let _e167 = (1f / 4096f);
                let _e168 = (trunc(((_e163 + _e162) * 4096f)) * _e167);
                let _e170 = ((_e163 - _e168) + _e162);
                let _e173 = (trunc((_e91 * _e113)) * _e104);
                let _e174 = (_e173 - _e122);
                let _e180 = ((_e174 * _e149) + (((_e91 - _e173) - _e131) * (_e140 + _e149)));
                let _e181 = (_e174 * _e140);
                let _e185 = (trunc(((_e181 + _e180) * 4096f)) * _e167);
                let _e187 = ((_e181 - _e185) + _e180);
                let _e190 = (trunc((_e95 * _e116)) * _e107);
                let _e191 = (_e190 - _e125);
                let _e197 = ((_e191 * _e152) + (((_e95 - _e190) - _e134) * (_e143 + _e152)));
                let _e198 = (_e191 * _e143);
                let _e202 = (trunc(((_e198 + _e197) * 4096f)) * _e167);
                let _e204 = ((_e198 - _e202) + _e197);
                let _e207 = global_3.member.member_7;
                if (_e207 == 0u) {
                    global_8.member[_e53] = _e168;
                    global_8.member[(_e98 + _e53)] = _e185;
                    global_8.member[((2u * _e98) + _e53)] = _e202;
                    global_8.member[((3u * _e98) + _e53)] = _e170;
                    global_8.member[((4u * _e98) + _e53)] = _e187;
                    global_8.member[((5u * _e98) + _e53)] = _e204;
                } else {
                    let _e232 = ((_e168 - 0.5f) + (_e170 - 0f));
                    let _e235 = ((_e185 - 0.5f) + (_e187 - 0f));
                    let _e238 = ((_e202 - 0.5f) + (_e204 - 0f));
                    let _e241 = select(_e232, -(_e232), (_e232 < 0f));
                    let _e244 = select(_e235, -(_e235), (_e235 < 0f));
                    let _e246 = select(_e244, _e241, (_e241 > _e244));
                    let _e249 = select(_e238, -(_e238), (_e238 < 0f));
                    let _e251 = select(_e249, _e246, (_e246 > _e249));
                    let _e253 = select(0.25f, _e251, (_e251 > 0.25f));
                    let _e258 = select(1f, ((0.5f - (0.0625f / _e253)) / _e253), (0.25f < _e253));
                    let _e259 = (_e232 * _e258);
                    let _e263 = (trunc(((0.5f + _e259) * 4096f)) * _e167);
                    let _e266 = (_e235 * _e258);
                    let _e270 = (trunc(((0.5f + _e266) * 4096f)) * _e167);
                    let _e273 = (_e238 * _e258);
                    let _e277 = (trunc(((0.5f + _e273) * 4096f)) * _e167);
                    global_8.member[_e53] = _e263;
                    global_8.member[(_e98 + _e53)] = _e270;
                    global_8.member[((2u * _e98) + _e53)] = _e277;
                    global_8.member[((3u * _e98) + _e53)] = ((0.5f - _e263) + _e259);
                    global_8.member[((4u * _e98) + _e53)] = ((0.5f - _e270) + _e266);
                    global_8.member[((5u * _e98) + _e53)] = ((0.5f - _e277) + _e273);
                }
                let _e301 = (_e87 - _e75);
                let _e302 = (_e91 - _e79);
                let _e303 = (_e95 - _e83);
                let _e308 = (((_e301 * _e301) + (_e302 * _e302)) + (_e303 * _e303));
                let _e312 = (1f / sqrt(select(0.000000000000000000000000000000000000011754944f, _e308, (_e308 > 0.000000000000000000000000000000000000011754944f))));
                let _e313 = (_e301 * _e312);
                let _e314 = (_e302 * _e312);
                let _e318 = global_3.member.member_4;
                phi_343_ = 0f;
                phi_346_ = 0u;
                phi_348_ = 0.28209478f;
                phi_350_ = 1f;
                loop {
                    let _e320 = phi_343_;
                    let _e322 = phi_346_;
                    let _e324 = phi_348_;
                    let _e326 = phi_350_;
                    if (_e322 <= _e318) {
                        let _e328 = f32(_e322);
                        let _e329 = (_e322 > 0u);
                        if _e329 {
                            let _e330 = (2f * _e328);
                            phi_344_ = ((_e313 * _e320) + (_e314 * _e326));
                            phi_349_ = (_e324 * -(sqrt(((_e330 + 1f) / _e330))));
                            phi_351_ = ((_e313 * _e326) - (_e314 * _e320));
                        } else {
                            phi_344_ = _e320;
                            phi_349_ = _e324;
                            phi_351_ = _e326;
                        }
                        let _e343 = phi_344_;
                        let _e345 = phi_349_;
                        let _e347 = phi_351_;
                        local = _e343;
                        local_2 = _e345;
                        local_3 = _e347;
                        phi_363_ = _e345;
                        phi_366_ = _e322;
                        phi_368_ = 0f;
                        loop {
                            let _e350 = phi_363_;
                            let _e352 = phi_366_;
                            let _e354 = phi_368_;
                            if (_e352 <= _e318) {
                                let _e356 = (_e352 > _e322);
                                if _e356 {
                                    let _e357 = f32(_e352);
                                    let _e358 = (_e357 - 1f);
                                    let _e363 = (_e328 * _e328);
                                    phi_364_ = (sqrt(((((4f * _e357) * _e357) - 1f) / ((_e357 * _e357) - _e363))) * (((_e303 * _e312) * _e350) - (sqrt((((_e358 * _e358) - _e363) / (((4f * _e358) * _e358) - 1f))) * _e354)));
                                } else {
                                    phi_364_ = _e350;
                                }
                                let _e379 = phi_364_;
                                let _e382 = ((_e352 * _e352) + _e352);
                                let _e386 = (select(1f, 1.4142135f, _e329) * _e379);
                                global_9.member[(_e53 + ((_e382 + _e322) * _e98))] = (_e386 * _e347);
                                local_4 = _e379;
                                local_6 = select(_e354, _e350, _e356);
                                if _e329 {
                                    global_9.member[(_e53 + ((_e382 - _e322) * _e98))] = (_e386 * _e343);
                                }
                                local_5 = (_e352 + 1u);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e435 = local_4;
                                phi_363_ = _e435;
                                let _e438 = local_5;
                                phi_366_ = _e438;
                                let _e441 = local_6;
                                phi_368_ = _e441;
                            }
                        }
                        local_1 = (_e322 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e420 = local;
                        phi_343_ = _e420;
                        let _e423 = local_1;
                        phi_346_ = _e423;
                        let _e426 = local_2;
                        phi_348_ = _e426;
                        let _e429 = local_3;
                        phi_350_ = _e429;
                    }
                }
                phi_394_ = 0u;
                loop {
                    let _e399 = phi_394_;
                    let _e402 = global_3.member.member_5;
                    if (_e399 < _e402) {
                        let _e408 = global_10.member[((_e69 * _e402) + _e399)];
                        let _e411 = global_3.member.member_6;
                        global_9.member[(((_e411 + _e399) * _e98) + _e53)] = _e408;
                        local_7 = (_e399 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e445 = local_7;
                        phi_394_ = _e445;
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
