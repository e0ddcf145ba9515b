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
    var phi_392_: u32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_423_: type_14;
    var phi_427_: u32;
    var phi_454_: f32;
    var phi_455_: f32;
    var phi_456_: f32;
    var phi_458_: type_14;
    var phi_462_: u32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_493_: type_14;
    var phi_540_: array<type_14, 3>;
    var local: u32;
    var local_1: u32;
    var local_2: u32;

    let _e51 = global;
    let _e52 = global_1;
    let _e53 = global_2;
    let _e61 = (((_e52.x + (_e52.y * _e53.x)) * 64u) + _e51.x);
    let _e64 = global_3.member.member;
    if (_e61 < _e64) {
        let _e68 = global_4.member[0u];
        let _e71 = global_4.member[1u];
        let _e74 = global_4.member[2u];
        let _e77 = global_4.member[3u];
        let _e80 = global_4.member[4u];
        let _e83 = global_4.member[5u];
        let _e86 = global_4.member[6u];
        let _e89 = global_4.member[7u];
        let _e92 = global_4.member[8u];
        let _e95 = global_4.member[9u];
        let _e98 = global_4.member[10u];
        let _e101 = global_4.member[11u];
        let _e104 = global_4.member[12u];
        let _e107 = global_4.member[13u];
        let _e110 = global_4.member[14u];
        let _e113 = global_4.member[15u];
        let _e116 = global_4.member[16u];
        let _e119 = global_4.member[17u];
        let _e120 = (_e61 * 3u);
        let _e123 = global_5.member[_e120];
        let _e124 = (_e120 + 1u);
        let _e127 = global_5.member[_e124];
        let _e128 = (_e120 + 2u);
        let _e131 = global_5.member[_e128];
        let _e134 = global_6.member[_e120];
        let _e137 = global_6.member[_e124];
        let _e140 = global_6.member[_e128];
        let _e141 = exp(_e134);
        let _e142 = exp(_e137);
        let _e143 = exp(_e140);
        let _e144 = (_e61 * 4u);
        let _e147 = global_7.member[_e144];
        let _e151 = global_7.member[(_e144 + 1u)];
        let _e155 = global_7.member[(_e144 + 2u)];
        let _e159 = global_7.member[(_e144 + 3u)];
        let _e168 = (1f / sqrt(((((_e147 * _e147) + (_e151 * _e151)) + (_e155 * _e155)) + (_e159 * _e159))));
        let _e169 = (_e147 * _e168);
        let _e170 = (_e151 * _e168);
        let _e171 = (_e155 * _e168);
        let _e172 = (_e159 * _e168);
        let _e173 = (_e171 * _e171);
        let _e174 = (_e172 * _e172);
        let _e178 = (_e170 * _e171);
        let _e179 = (_e169 * _e172);
        let _e182 = (_e170 * _e172);
        let _e183 = (_e169 * _e171);
        let _e188 = (_e170 * _e170);
        let _e192 = (_e171 * _e172);
        let _e193 = (_e169 * _e170);
        let _e205 = global_3.member.member_2;
        let _e206 = (1f / _e205);
        let _e207 = (_e141 * _e206);
        let _e208 = (_e142 * _e206);
        let _e209 = (_e143 * _e206);
        let _e210 = (_e207 * _e208);
        let _e211 = (_e207 * _e209);
        let _e213 = select(_e211, _e210, (_e210 > _e211));
        let _e214 = (_e208 * _e209);
        let _e220 = global_8.member[_e61];
        let _e221 = (_e220 < 0f);
        let _e224 = exp(select(-(_e220), _e220, _e221));
        let _e226 = (1f / (1f + _e224));
        let _e232 = ((2f * _e207) + 0.5f);
        let _e233 = f32(3u);
        let _e235 = select(_e233, _e232, (_e232 < _e233));
        let _e236 = bitcast<f32>(0u);
        let _e237 = bitcast<f32>(1333788671u);
        let _e243 = select(select(u32(_e235), 0u, !((_e235 >= _e236))), 4294967295u, (_e235 > _e237));
        let _e245 = ((2f * _e208) + 0.5f);
        let _e247 = select(_e233, _e245, (_e245 < _e233));
        let _e253 = select(select(u32(_e247), 0u, !((_e247 >= _e236))), 4294967295u, (_e247 > _e237));
        let _e255 = ((2f * _e209) + 0.5f);
        let _e257 = select(_e233, _e255, (_e255 < _e233));
        let _e263 = select(select(u32(_e257), 0u, !((_e257 >= _e236))), 4294967295u, (_e257 > _e237));
        phi_392_ = 0u;
        loop {
            let _e265 = phi_392_;
            if (_e265 <= (2u * _e243)) {
                if (_e243 == 0u) {
                    phi_423_ = type_14(0f, 1f);
                } else {
                    let _e269 = f32(_e243);
                    let _e270 = (2f / _e269);
                    let _e273 = ((f32(_e265) - _e269) * _e270);
                    let _e275 = (_e273 * _e273);
                    if (_e275 < 0.2f) {
                        phi_421_ = 1f;
                    } else {
                        if (_e275 < 0.7f) {
                            phi_420_ = 0.8007374f;
                        } else {
                            if (_e275 < 1.4f) {
                                phi_419_ = 0.60653067f;
                            } else {
                                phi_419_ = select(0.13533528f, 0.4111123f, (_e275 < 3f));
                            }
                            let _e282 = phi_419_;
                            phi_420_ = _e282;
                        }
                        let _e284 = phi_420_;
                        phi_421_ = _e284;
                    }
                    let _e286 = phi_421_;
                    phi_423_ = type_14(_e273, ((0.3989423f * _e270) * _e286));
                }
                let _e290 = phi_423_;
                let _e293 = (_e290.member * _e141);
                phi_427_ = 0u;
                loop {
                    let _e301 = phi_427_;
                    if (_e301 <= (2u * _e253)) {
                        if (_e253 == 0u) {
                            phi_458_ = type_14(0f, 1f);
                        } else {
                            let _e305 = f32(_e253);
                            let _e306 = (2f / _e305);
                            let _e309 = ((f32(_e301) - _e305) * _e306);
                            let _e311 = (_e309 * _e309);
                            if (_e311 < 0.2f) {
                                phi_456_ = 1f;
                            } else {
                                if (_e311 < 0.7f) {
                                    phi_455_ = 0.8007374f;
                                } else {
                                    if (_e311 < 1.4f) {
                                        phi_454_ = 0.60653067f;
                                    } else {
                                        phi_454_ = select(0.13533528f, 0.4111123f, (_e311 < 3f));
                                    }
                                    let _e318 = phi_454_;
                                    phi_455_ = _e318;
                                }
                                let _e320 = phi_455_;
                                phi_456_ = _e320;
                            }
                            let _e322 = phi_456_;
                            phi_458_ = type_14(_e309, ((0.3989423f * _e306) * _e322));
                        }
                        let _e326 = phi_458_;
                        let _e329 = (_e326.member * _e142);
                        phi_462_ = 0u;
                        loop {
                            let _e337 = phi_462_;
                            if (_e337 <= (2u * _e263)) {
                                if (_e263 == 0u) {
                                    phi_493_ = type_14(0f, 1f);
                                } else {
                                    let _e341 = f32(_e263);
                                    let _e342 = (2f / _e341);
                                    let _e345 = ((f32(_e337) - _e341) * _e342);
                                    let _e347 = (_e345 * _e345);
                                    if (_e347 < 0.2f) {
                                        phi_491_ = 1f;
                                    } else {
                                        if (_e347 < 0.7f) {
                                            phi_490_ = 0.8007374f;
                                        } else {
                                            if (_e347 < 1.4f) {
                                                phi_489_ = 0.60653067f;
                                            } else {
                                                phi_489_ = select(0.13533528f, 0.4111123f, (_e347 < 3f));
                                            }
                                            let _e354 = phi_489_;
                                            phi_490_ = _e354;
                                        }
                                        let _e356 = phi_490_;
                                        phi_491_ = _e356;
                                    }
                                    let _e358 = phi_491_;
                                    phi_493_ = type_14(_e345, ((0.3989423f * _e342) * _e358));
                                }
                                let _e362 = phi_493_;
                                let _e368 = f32(4096u);
                                let _e370 = ((((((4f * 3.1415927f) * select(_e226, (_e224 * _e226), _e221)) * select(_e214, _e213, (_e213 > _e214))) * ((_e290.member_1 * _e326.member_1) * _e362.member_1)) * _e368) + 0.5f);
                                if (_e370 >= 1f) {
                                    let _e372 = (_e362.member * _e143);
                                    let _e376 = (((_e123 + ((1f - (2f * (_e173 + _e174))) * _e293)) + ((2f * (_e178 - _e179)) * _e329)) + ((2f * (_e182 + _e183)) * _e372));
                                    let _e377 = (((_e127 + ((2f * (_e178 + _e179)) * _e293)) + ((1f - (2f * (_e188 + _e174))) * _e329)) + ((2f * (_e192 - _e193)) * _e372));
                                    let _e378 = (((_e131 + ((2f * (_e182 - _e183)) * _e293)) + ((2f * (_e192 + _e193)) * _e329)) + ((1f - (2f * (_e188 + _e173))) * _e372));
                                    let _e380 = select(_e368, _e370, (_e370 < _e368));
                                    let _e387 = (trunc((_e376 * _e77)) * _e68);
                                    let _e388 = (trunc((_e377 * _e80)) * _e71);
                                    let _e389 = (trunc((_e378 * _e83)) * _e74);
                                    let _e390 = (_e387 - _e86);
                                    let _e391 = (_e388 - _e89);
                                    let _e392 = (_e389 - _e92);
                                    let _e399 = (_e390 * _e104);
                                    let _e400 = (_e391 * _e107);
                                    let _e401 = (_e392 * _e110);
                                    let _e411 = ((_e390 * _e113) + (((_e376 - _e387) - _e95) * (_e104 + _e113)));
                                    let _e412 = ((_e391 * _e116) + (((_e377 - _e388) - _e98) * (_e107 + _e116)));
                                    let _e413 = ((_e392 * _e119) + (((_e378 - _e389) - _e101) * (_e110 + _e119)));
                                    let _e417 = (1f / 4096f);
                                    let _e418 = (trunc(((_e399 + _e411) * 4096f)) * _e417);
                                    let _e420 = ((_e399 - _e418) + _e411);
                                    let _e424 = (trunc(((_e400 + _e412) * 4096f)) * _e417);
                                    let _e426 = ((_e400 - _e424) + _e412);
                                    let _e430 = (trunc(((_e401 + _e413) * 4096f)) * _e417);
                                    let _e432 = ((_e401 - _e430) + _e413);
                                    let _e439 = global_3.member.member_3;
                                    if (_e439 == 0u) {
                                        phi_540_ = array<type_14, 3>(type_14(_e418, _e420), type_14(_e424, _e426), type_14(_e430, _e432));
                                    } else {
                                        let _e443 = ((_e418 - 0.5f) + (_e420 - 0f));
                                        let _e446 = ((_e424 - 0.5f) + (_e426 - 0f));
                                        let _e449 = ((_e430 - 0.5f) + (_e432 - 0f));
                                        let _e452 = select(_e443, -(_e443), (_e443 < 0f));
                                        let _e455 = select(_e446, -(_e446), (_e446 < 0f));
                                        let _e457 = select(_e455, _e452, (_e452 > _e455));
                                        let _e460 = select(_e449, -(_e449), (_e449 < 0f));
                                        let _e462 = select(_e460, _e457, (_e457 > _e460));
                                        let _e464 = select(0.25f, _e462, (_e462 > 0.25f));
                                        let _e469 = select(1f, ((0.5f - (0.0625f / _e464)) / _e464), (0.25f < _e464));
                                        let _e470 = (_e443 * _e469);
                                        let _e474 = (trunc(((0.5f + _e470) * 4096f)) * _e417);
                                        let _e477 = (_e446 * _e469);
                                        let _e481 = (trunc(((0.5f + _e477) * 4096f)) * _e417);
                                        let _e484 = (_e449 * _e469);
                                        let _e488 = (trunc(((0.5f + _e484) * 4096f)) * _e417);
                                        phi_540_ = array<type_14, 3>(type_14(_e474, ((0.5f - _e474) + _e470)), type_14(_e481, ((0.5f - _e481) + _e477)), type_14(_e488, ((0.5f - _e488) + _e484)));
                                    }
                                    let _e496 = phi_540_;
                                    let _e499 = global_3.member.member_1;
                                    let _e500 = f32(_e499);
                                    let _e506 = ((_e496[0].member + _e496[0].member_1) * _e500);
                                    let _e512 = ((_e496[1].member + _e496[1].member_1) * _e500);
                                    let _e518 = ((_e496[2].member + _e496[2].member_1) * _e500);
                                    let _e520 = select(_e512, _e506, (_e506 < _e512));
                                    let _e524 = select(_e512, _e506, (_e506 > _e512));
                                    if (select(_e518, _e520, (_e520 < _e518)) >= 0f) {
                                        if (select(_e518, _e524, (_e524 > _e518)) < _e500) {
                                            let _e529 = (_e499 + 2u);
                                            let _e560 = select(select(u32(_e380), 0u, !((_e380 >= _e236))), 4294967295u, (_e380 > _e237));
                                            let _e563 = atomicLoad((&global_9.member[(((((((select(select(u32(_e518), 0u, !((_e518 >= _e236))), 4294967295u, (_e518 > _e237)) + 1u) * _e529) + select(select(u32(_e512), 0u, !((_e512 >= _e236))), 4294967295u, (_e512 > _e237))) + 1u) * _e529) + select(select(u32(_e506), 0u, !((_e506 >= _e236))), 4294967295u, (_e506 > _e237))) + 1u)]));
                                            if (_e563 < 4096u) {
                                                let _e565 = atomicAdd((&global_9.member[(((((((select(select(u32(_e518), 0u, !((_e518 >= _e236))), 4294967295u, (_e518 > _e237)) + 1u) * _e529) + select(select(u32(_e512), 0u, !((_e512 >= _e236))), 4294967295u, (_e512 > _e237))) + 1u) * _e529) + select(select(u32(_e506), 0u, !((_e506 >= _e236))), 4294967295u, (_e506 > _e237))) + 1u)]), _e560);
                                                if ((_e565 + _e560) > 4096u) {
                                                    let _e568 = atomicMin((&global_9.member[(((((((select(select(u32(_e518), 0u, !((_e518 >= _e236))), 4294967295u, (_e518 > _e237)) + 1u) * _e529) + select(select(u32(_e512), 0u, !((_e512 >= _e236))), 4294967295u, (_e512 > _e237))) + 1u) * _e529) + select(select(u32(_e506), 0u, !((_e506 >= _e236))), 4294967295u, (_e506 > _e237))) + 1u)]), 4096u);
                                                }
                                            }
                                        }
                                    }
                                }
                                local_2 = (_e337 + 1u);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e588 = local_2;
                                phi_462_ = _e588;
                            }
                        }
                        local_1 = (_e301 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e581 = local_1;
                        phi_427_ = _e581;
                    }
                }
                local = (_e265 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e574 = local;
                phi_392_ = _e574;
            }
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
