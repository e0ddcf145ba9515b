struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<f32>,
}

struct type_14 {
    member: f32,
    member_1: f32,
}

struct type_18 {
    member: array<u32>,
}

struct type_22 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(4) 
var<storage> global_6: type_11;
@group(0) @binding(3) 
var<storage> global_7: type_11;
@group(0) @binding(5) 
var<storage> global_8: type_11;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_22;

fn function_() {
    var phi_404_: u32;
    var phi_434_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_438_: type_14;
    var phi_468_: f32;
    var phi_469_: f32;
    var phi_470_: f32;
    var phi_472_: type_14;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_501_: f32;
    var phi_503_: type_14;
    var phi_550_: array<type_14, 3>;
    var phi_616_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = global;
            let _e55 = global_1;
            let _e56 = global_2;
            let _e64 = (((_e55.x + (_e55.y * _e56.x)) * 64u) + _e54.x);
            let _e67 = global_3.member.member;
            if (_e64 < _e67) {
                let _e71 = global_4.member[0u];
                let _e74 = global_4.member[1u];
                let _e77 = global_4.member[2u];
                let _e80 = global_4.member[3u];
                let _e83 = global_4.member[4u];
                let _e86 = global_4.member[5u];
                let _e89 = global_4.member[6u];
                let _e92 = global_4.member[7u];
                let _e95 = global_4.member[8u];
                let _e98 = global_4.member[9u];
                let _e101 = global_4.member[10u];
                let _e104 = global_4.member[11u];
                let _e107 = global_4.member[12u];
                let _e110 = global_4.member[13u];
                let _e113 = global_4.member[14u];
                let _e116 = global_4.member[15u];
                let _e119 = global_4.member[16u];
                let _e122 = global_4.member[17u];
                let _e123 = (_e64 * 3u);
                let _e126 = global_5.member[_e123];
                let _e127 = (_e123 + 1u);
                let _e130 = global_5.member[_e127];
                let _e131 = (_e123 + 2u);
                let _e134 = global_5.member[_e131];
                let _e137 = global_6.member[_e123];
                let _e140 = global_6.member[_e127];
                let _e143 = global_6.member[_e131];
                let _e144 = exp(_e137);
                let _e145 = exp(_e140);
                let _e146 = exp(_e143);
                let _e147 = (_e64 * 4u);
                let _e150 = global_7.member[_e147];
                let _e154 = global_7.member[(_e147 + 1u)];
                let _e158 = global_7.member[(_e147 + 2u)];
                let _e162 = global_7.member[(_e147 + 3u)];
                let _e171 = (1f / sqrt(((((_e150 * _e150) + (_e154 * _e154)) + (_e158 * _e158)) + (_e162 * _e162))));
                let _e172 = (_e150 * _e171);
                let _e173 = (_e154 * _e171);
                let _e174 = (_e158 * _e171);
                let _e175 = (_e162 * _e171);
                let _e176 = (_e174 * _e174);
                let _e177 = (_e175 * _e175);
                let _e181 = (_e173 * _e174);
                let _e182 = (_e172 * _e175);
                let _e185 = (_e173 * _e175);
                let _e186 = (_e172 * _e174);
                let _e191 = (_e173 * _e173);
                let _e195 = (_e174 * _e175);
                let _e196 = (_e172 * _e173);
                let _e208 = global_3.member.member_2;
                let _e209 = (1f / _e208);
                let _e210 = (_e144 * _e209);
                let _e211 = (_e145 * _e209);
                let _e212 = (_e146 * _e209);
                let _e213 = (_e210 * _e211);
                let _e214 = (_e210 * _e212);
                let _e216 = select(_e214, _e213, (_e213 > _e214));
                let _e217 = (_e211 * _e212);
                let _e223 = global_8.member[_e64];
                let _e224 = (_e223 < 0f);
                let _e227 = exp(select(-(_e223), _e223, _e224));
                let _e229 = (1f / (1f + _e227));
                let _e235 = ((2f * _e210) + 0.5f);
                let _e236 = f32(3u);
                let _e238 = select(_e236, _e235, (_e235 < _e236));
                let _e239 = bitcast<f32>(0u);
                let _e240 = bitcast<f32>(1333788671u);
                let _e246 = select(select(u32(_e238), 0u, !((_e238 >= _e239))), 4294967295u, (_e238 > _e240));
                let _e248 = ((2f * _e211) + 0.5f);
                let _e250 = select(_e236, _e248, (_e248 < _e236));
                let _e256 = select(select(u32(_e250), 0u, !((_e250 >= _e239))), 4294967295u, (_e250 > _e240));
                let _e258 = ((2f * _e212) + 0.5f);
                let _e260 = select(_e236, _e258, (_e258 < _e236));
                let _e266 = select(select(u32(_e260), 0u, !((_e260 >= _e239))), 4294967295u, (_e260 > _e240));
                let _e268 = ((2u * _e246) + 1u);
                let _e270 = ((2u * _e256) + 1u);
                let _e271 = (_e268 * _e270);
                phi_404_ = 0u;
                loop {
                    let _e276 = phi_404_;
                    phi_616_ = false;
                    if (_e276 < (_e271 * ((2u * _e266) + 1u))) {
                        let _e278 = (_e268 == 0u);
                        if _e278 {
                            phi_616_ = true;
                            break;
                        }
                        if (_e246 == 0u) {
                            phi_438_ = type_14(0f, 1f);
                        } else {
                            let _e281 = f32(_e246);
                            let _e282 = (2f / _e281);
                            let _e285 = ((f32((_e276 % _e268)) - _e281) * _e282);
                            let _e287 = (_e285 * _e285);
                            if (_e287 < 0.2f) {
                                phi_436_ = 1f;
                            } else {
                                if (_e287 < 0.7f) {
                                    phi_435_ = 0.8007374f;
                                } else {
                                    if (_e287 < 1.4f) {
                                        phi_434_ = 0.60653067f;
                                    } else {
                                        phi_434_ = select(0.13533528f, 0.4111123f, (_e287 < 3f));
                                    }
                                    let _e294 = phi_434_;
                                    phi_435_ = _e294;
                                }
                                let _e296 = phi_435_;
                                phi_436_ = _e296;
                            }
                            let _e298 = phi_436_;
                            phi_438_ = type_14(_e285, ((0.3989423f * _e282) * _e298));
                        }
                        let _e302 = phi_438_;
                        if _e278 {
                            phi_616_ = true;
                            break;
                        }
                        if (_e270 == 0u) {
                            phi_616_ = true;
                            break;
                        }
                        if (_e256 == 0u) {
                            phi_472_ = type_14(0f, 1f);
                        } else {
                            let _e309 = f32(_e256);
                            let _e310 = (2f / _e309);
                            let _e313 = ((f32(((_e276 / _e268) % _e270)) - _e309) * _e310);
                            let _e315 = (_e313 * _e313);
                            if (_e315 < 0.2f) {
                                phi_470_ = 1f;
                            } else {
                                if (_e315 < 0.7f) {
                                    phi_469_ = 0.8007374f;
                                } else {
                                    if (_e315 < 1.4f) {
                                        phi_468_ = 0.60653067f;
                                    } else {
                                        phi_468_ = select(0.13533528f, 0.4111123f, (_e315 < 3f));
                                    }
                                    let _e322 = phi_468_;
                                    phi_469_ = _e322;
                                }
                                let _e324 = phi_469_;
                                phi_470_ = _e324;
                            }
                            let _e326 = phi_470_;
                            phi_472_ = type_14(_e313, ((0.3989423f * _e310) * _e326));
                        }
                        let _e330 = phi_472_;
                        if (_e271 == 0u) {
                            phi_616_ = true;
                            break;
                        }
                        if (_e266 == 0u) {
                            phi_503_ = type_14(0f, 1f);
                        } else {
                            let _e336 = f32(_e266);
                            let _e337 = (2f / _e336);
                            let _e340 = ((f32((_e276 / _e271)) - _e336) * _e337);
                            let _e342 = (_e340 * _e340);
                            if (_e342 < 0.2f) {
                                phi_501_ = 1f;
                            } else {
                                if (_e342 < 0.7f) {
                                    phi_500_ = 0.8007374f;
                                } else {
                                    if (_e342 < 1.4f) {
                                        phi_499_ = 0.60653067f;
                                    } else {
                                        phi_499_ = select(0.13533528f, 0.4111123f, (_e342 < 3f));
                                    }
                                    let _e349 = phi_499_;
                                    phi_500_ = _e349;
                                }
                                let _e351 = phi_500_;
                                phi_501_ = _e351;
                            }
                            let _e353 = phi_501_;
                            phi_503_ = type_14(_e340, ((0.3989423f * _e337) * _e353));
                        }
                        let _e357 = phi_503_;
                        let _e363 = f32(4096u);
                        let _e365 = ((((((4f * 3.1415927f) * select(_e229, (_e227 * _e229), _e224)) * select(_e217, _e216, (_e216 > _e217))) * ((_e302.member_1 * _e330.member_1) * _e357.member_1)) * _e363) + 0.5f);
                        if (_e365 >= 1f) {
                            let _e367 = (_e302.member * _e144);
                            let _e374 = (_e330.member * _e145);
                            let _e381 = (_e357.member * _e146);
                            let _e385 = (((_e126 + ((1f - (2f * (_e176 + _e177))) * _e367)) + ((2f * (_e181 - _e182)) * _e374)) + ((2f * (_e185 + _e186)) * _e381));
                            let _e386 = (((_e130 + ((2f * (_e181 + _e182)) * _e367)) + ((1f - (2f * (_e191 + _e177))) * _e374)) + ((2f * (_e195 - _e196)) * _e381));
                            let _e387 = (((_e134 + ((2f * (_e185 - _e186)) * _e367)) + ((2f * (_e195 + _e196)) * _e374)) + ((1f - (2f * (_e191 + _e176))) * _e381));
                            let _e389 = select(_e363, _e365, (_e365 < _e363));
                            let _e396 = (trunc((_e385 * _e80)) * _e71);
                            let _e397 = (trunc((_e386 * _e83)) * _e74);
                            let _e398 = (trunc((_e387 * _e86)) * _e77);
                            let _e399 = (_e396 - _e89);
                            let _e400 = (_e397 - _e92);
                            let _e401 = (_e398 - _e95);
                            let _e408 = (_e399 * _e107);
                            let _e409 = (_e400 * _e110);
                            let _e410 = (_e401 * _e113);
                            let _e420 = ((_e399 * _e116) + (((_e385 - _e396) - _e98) * (_e107 + _e116)));
                            let _e421 = ((_e400 * _e119) + (((_e386 - _e397) - _e101) * (_e110 + _e119)));
                            let _e422 = ((_e401 * _e122) + (((_e387 - _e398) - _e104) * (_e113 + _e122)));
                            let _e426 = (1f / 4096f);
                            let _e427 = (trunc(((_e408 + _e420) * 4096f)) * _e426);
                            let _e429 = ((_e408 - _e427) + _e420);
                            let _e433 = (trunc(((_e409 + _e421) * 4096f)) * _e426);
                            let _e435 = ((_e409 - _e433) + _e421);
                            let _e439 = (trunc(((_e410 + _e422) * 4096f)) * _e426);
                            let _e441 = ((_e410 - _e439) + _e422);
                            let _e448 = global_3.member.member_3;
                            if (_e448 == 0u) {
                                phi_550_ = array<type_14, 3>(type_14(_e427, _e429), type_14(_e433, _e435), type_14(_e439, _e441));
                            } else {
                                let _e452 = ((_e427 - 0.5f) + (_e429 - 0f));
                                let _e455 = ((_e433 - 0.5f) + (_e435 - 0f));
                                let _e458 = ((_e439 - 0.5f) + (_e441 - 0f));
                                let _e461 = select(_e452, -(_e452), (_e452 < 0f));
                                let _e464 = select(_e455, -(_e455), (_e455 < 0f));
                                let _e466 = select(_e464, _e461, (_e461 > _e464));
                                let _e469 = select(_e458, -(_e458), (_e458 < 0f));
                                let _e471 = select(_e469, _e466, (_e466 > _e469));
                                let _e473 = select(0.25f, _e471, (_e471 > 0.25f));
                                let _e478 = select(1f, ((0.5f - (0.0625f / _e473)) / _e473), (0.25f < _e473));
                                let _e479 = (_e452 * _e478);
                                let _e483 = (trunc(((0.5f + _e479) * 4096f)) * _e426);
                                let _e486 = (_e455 * _e478);
                                let _e490 = (trunc(((0.5f + _e486) * 4096f)) * _e426);
                                let _e493 = (_e458 * _e478);
                                let _e497 = (trunc(((0.5f + _e493) * 4096f)) * _e426);
                                phi_550_ = array<type_14, 3>(type_14(_e483, ((0.5f - _e483) + _e479)), type_14(_e490, ((0.5f - _e490) + _e486)), type_14(_e497, ((0.5f - _e497) + _e493)));
                            }
                            let _e505 = phi_550_;
                            let _e508 = global_3.member.member_1;
                            let _e509 = f32(_e508);
                            let _e515 = ((_e505[0].member + _e505[0].member_1) * _e509);
                            let _e521 = ((_e505[1].member + _e505[1].member_1) * _e509);
                            let _e527 = ((_e505[2].member + _e505[2].member_1) * _e509);
                            let _e529 = select(_e521, _e515, (_e515 < _e521));
                            let _e533 = select(_e521, _e515, (_e515 > _e521));
                            if (select(_e527, _e529, (_e529 < _e527)) >= 0f) {
                                if (select(_e527, _e533, (_e533 > _e527)) < _e509) {
                                    let _e538 = (_e508 + 2u);
                                    let _e569 = select(select(u32(_e389), 0u, !((_e389 >= _e239))), 4294967295u, (_e389 > _e240));
                                    let _e572 = atomicAdd((&global_9.member[(((((((select(select(u32(_e527), 0u, !((_e527 >= _e239))), 4294967295u, (_e527 > _e240)) + 1u) * _e538) + select(select(u32(_e521), 0u, !((_e521 >= _e239))), 4294967295u, (_e521 > _e240))) + 1u) * _e538) + select(select(u32(_e515), 0u, !((_e515 >= _e239))), 4294967295u, (_e515 > _e240))) + 1u)]), _e569);
                                    if ((_e572 + _e569) > 4096u) {
                                        let _e575 = atomicMin((&global_9.member[(((((((select(select(u32(_e527), 0u, !((_e527 >= _e239))), 4294967295u, (_e527 > _e240)) + 1u) * _e538) + select(select(u32(_e521), 0u, !((_e521 >= _e239))), 4294967295u, (_e521 > _e240))) + 1u) * _e538) + select(select(u32(_e515), 0u, !((_e515 >= _e239))), 4294967295u, (_e515 > _e240))) + 1u)]), 4096u);
                                    }
                                }
                            }
                        }
                        local = (_e276 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e581 = local;
                        phi_404_ = _e581;
                    }
                }
                let _e578 = phi_616_;
                if _e578 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn occupancy_add(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
