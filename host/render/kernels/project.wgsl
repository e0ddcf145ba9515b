struct type_5 {
    member: u32,
    member_1: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<f32>,
}

struct type_16 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec3<f32>,
    member_3: f32,
}

struct type_20 {
    member: array<vec4<f32>>,
}

struct type_24 {
    member: array<u32>,
}

struct type_28 {
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
@group(0) @binding(3) 
var<storage> global_6: type_11;
@group(0) @binding(5) 
var<storage> global_7: type_11;
@group(0) @binding(4) 
var<storage> global_8: type_11;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_20;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_28;

fn function_() {
    var phi_465_: u32;
    var phi_541_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_557_: type_16;
    var phi_559_: type_16;
    var phi_560_: bool;
    var phi_565_: type_16;
    var local: u32;

    let _e52 = global;
    let _e53 = global_1;
    let _e54 = global_2;
    let _e62 = (((_e53.x + (_e53.y * _e54.x)) * 64u) + _e52.x);
    let _e65 = global_3.member.member;
    if (_e62 < _e65) {
        let _e68 = (_e53.z * 18u);
        let _e71 = global_4.member[_e68];
        let _e75 = global_4.member[(_e68 + 1u)];
        let _e79 = global_4.member[(_e68 + 2u)];
        let _e83 = global_4.member[(_e68 + 3u)];
        let _e87 = global_4.member[(_e68 + 4u)];
        let _e91 = global_4.member[(_e68 + 5u)];
        let _e95 = global_4.member[(_e68 + 6u)];
        let _e99 = global_4.member[(_e68 + 7u)];
        let _e103 = global_4.member[(_e68 + 8u)];
        let _e107 = global_4.member[(_e68 + 9u)];
        let _e111 = global_4.member[(_e68 + 10u)];
        let _e115 = global_4.member[(_e68 + 11u)];
        let _e119 = global_4.member[(_e68 + 12u)];
        let _e123 = global_4.member[(_e68 + 13u)];
        let _e127 = global_4.member[(_e68 + 14u)];
        let _e131 = global_4.member[(_e68 + 15u)];
        let _e135 = global_4.member[(_e68 + 16u)];
        let _e139 = global_4.member[(_e68 + 17u)];
        let _e140 = (_e53.z * 4u);
        let _e143 = global_5.member[_e140];
        let _e147 = global_5.member[(_e140 + 1u)];
        let _e151 = global_5.member[(_e140 + 2u)];
        let _e155 = global_5.member[(_e140 + 3u)];
        let _e158 = global_3.member.member_1;
        let _e159 = (_e62 * 3u);
        let _e160 = (_e159 + 1u);
        let _e161 = (_e159 + 2u);
        let _e164 = global_6.member[_e159];
        let _e167 = global_6.member[_e160];
        let _e170 = global_6.member[_e161];
        let _e171 = (_e164 - _e107);
        let _e172 = (_e167 - _e111);
        let _e173 = (_e170 - _e115);
        let _e188 = (((_e95 * _e171) + (_e99 * _e172)) + (_e103 * _e173));
        let _e191 = global_7.member[_e159];
        let _e194 = global_7.member[_e160];
        let _e197 = global_7.member[_e161];
        let _e198 = (1f / _e188);
        let _e199 = ((((_e71 * _e171) + (_e75 * _e172)) + (_e79 * _e173)) * _e198);
        let _e200 = ((((_e83 * _e171) + (_e87 * _e172)) + (_e91 * _e173)) * _e198);
        let _e202 = ((_e119 * _e199) + _e127);
        let _e204 = ((_e123 * _e200) + _e131);
        let _e205 = (1f / _e119);
        let _e206 = (1f / _e123);
        let _e209 = ((_e135 * _e205) * 0.15f);
        let _e210 = ((_e139 * _e206) * 0.15f);
        let _e215 = (((_e127 * _e205) * -1f) - _e209);
        let _e216 = (((_e131 * _e206) * -1f) - _e210);
        let _e221 = (((_e135 - _e127) * _e205) + _e209);
        let _e222 = (((_e139 - _e131) * _e206) + _e210);
        let _e224 = select(_e215, _e199, (_e199 > _e215));
        let _e226 = select(_e221, _e224, (_e224 < _e221));
        let _e228 = select(_e216, _e200, (_e200 > _e216));
        let _e230 = select(_e222, _e228, (_e228 < _e222));
        let _e243 = select(_e197, _e194, (_e194 > _e197));
        let _e246 = exp(select(_e243, _e191, (_e191 > _e243)));
        let _e251 = select(_e143, _e202, (_e202 > _e143));
        let _e254 = (_e202 - select(_e151, _e251, (_e251 < _e151)));
        let _e256 = select(_e147, _e204, (_e204 > _e147));
        let _e259 = (_e204 - select(_e155, _e256, (_e256 < _e155)));
        let _e272 = select(select(0u, 1u, select(false, (-0x1.fffffep+127f <= _e188), (_e188 <= 0x1.fffffep+127f))), select(0u, 3u, (((((((((((_e119 * _e119) * (1f + (_e226 * _e226))) + ((_e123 * _e123) * (1f + (_e230 * _e230)))) * _e198) * _e198) * _e246) * _e246) + _e158) * 11.304177f) + 0.02f) < ((_e254 * _e254) + (_e259 * _e259)))), (0.01f < _e188));
        phi_465_ = 0u;
        loop {
            let _e274 = phi_465_;
            if (_e274 < 1u) {
                let _e276 = (_e62 + _e274);
                let _e279 = (2u * ((_e53.z * _e65) + _e276));
                if (_e272 == 0u) {
                    let _e281 = (_e276 * 3u);
                    let _e284 = global_6.member[_e281];
                    let _e285 = (_e281 + 1u);
                    let _e288 = global_6.member[_e285];
                    let _e289 = (_e281 + 2u);
                    let _e292 = global_6.member[_e289];
                    let _e293 = (_e276 * 4u);
                    let _e296 = global_8.member[_e293];
                    let _e300 = global_8.member[(_e293 + 1u)];
                    let _e304 = global_8.member[(_e293 + 2u)];
                    let _e308 = global_8.member[(_e293 + 3u)];
                    let _e311 = global_7.member[_e281];
                    let _e314 = global_7.member[_e285];
                    let _e317 = global_7.member[_e289];
                    let _e318 = (_e284 - _e107);
                    let _e319 = (_e288 - _e111);
                    let _e320 = (_e292 - _e115);
                    let _e325 = (((_e71 * _e318) + (_e75 * _e319)) + (_e79 * _e320));
                    let _e330 = (((_e83 * _e318) + (_e87 * _e319)) + (_e91 * _e320));
                    let _e335 = (((_e95 * _e318) + (_e99 * _e319)) + (_e103 * _e320));
                    let _e336 = (0.01f < _e335);
                    let _e337 = select(1f, _e335, _e336);
                    let _e340 = (((_e119 * _e325) / _e337) + _e127);
                    let _e343 = (((_e123 * _e330) / _e337) + _e131);
                    let _e344 = (_e325 / _e337);
                    let _e346 = select(_e215, _e344, (_e344 > _e215));
                    let _e348 = select(_e221, _e346, (_e346 < _e221));
                    let _e349 = (_e330 / _e337);
                    let _e351 = select(_e216, _e349, (_e349 > _e216));
                    let _e353 = select(_e222, _e351, (_e351 < _e222));
                    let _e354 = (_e119 / _e337);
                    let _e355 = (_e123 / _e337);
                    let _e362 = ((_e71 - (_e95 * _e348)) * _e354);
                    let _e363 = ((_e75 - (_e99 * _e348)) * _e354);
                    let _e364 = ((_e79 - (_e103 * _e348)) * _e354);
                    let _e371 = ((_e83 - (_e95 * _e353)) * _e355);
                    let _e372 = ((_e87 - (_e99 * _e353)) * _e355);
                    let _e373 = ((_e91 - (_e103 * _e353)) * _e355);
                    let _e382 = (1f / sqrt(((((_e296 * _e296) + (_e300 * _e300)) + (_e304 * _e304)) + (_e308 * _e308))));
                    let _e383 = (_e296 * _e382);
                    let _e384 = (_e300 * _e382);
                    let _e385 = (_e304 * _e382);
                    let _e386 = (_e308 * _e382);
                    let _e387 = (_e385 * _e385);
                    let _e388 = (_e386 * _e386);
                    let _e391 = (1f - (2f * (_e387 + _e388)));
                    let _e392 = (_e384 * _e385);
                    let _e393 = (_e383 * _e386);
                    let _e395 = (2f * (_e392 + _e393));
                    let _e396 = (_e384 * _e386);
                    let _e397 = (_e383 * _e385);
                    let _e399 = (2f * (_e396 - _e397));
                    let _e401 = (2f * (_e392 - _e393));
                    let _e402 = (_e384 * _e384);
                    let _e405 = (1f - (2f * (_e402 + _e388)));
                    let _e406 = (_e385 * _e386);
                    let _e407 = (_e383 * _e384);
                    let _e409 = (2f * (_e406 + _e407));
                    let _e411 = (2f * (_e396 + _e397));
                    let _e413 = (2f * (_e406 - _e407));
                    let _e416 = (1f - (2f * (_e402 + _e387)));
                    let _e417 = exp(_e311);
                    let _e418 = exp(_e314);
                    let _e419 = exp(_e317);
                    let _e435 = ((((_e362 * _e391) + (_e363 * _e395)) + (_e364 * _e399)) * _e417);
                    let _e436 = ((((_e362 * _e401) + (_e363 * _e405)) + (_e364 * _e409)) * _e418);
                    let _e437 = ((((_e362 * _e411) + (_e363 * _e413)) + (_e364 * _e416)) * _e419);
                    let _e453 = ((((_e371 * _e391) + (_e372 * _e395)) + (_e373 * _e399)) * _e417);
                    let _e454 = ((((_e371 * _e401) + (_e372 * _e405)) + (_e373 * _e409)) * _e418);
                    let _e455 = ((((_e371 * _e411) + (_e372 * _e413)) + (_e373 * _e416)) * _e419);
                    let _e460 = (((_e435 * _e435) + (_e436 * _e436)) + (_e437 * _e437));
                    let _e465 = (((_e435 * _e453) + (_e436 * _e454)) + (_e437 * _e455));
                    let _e470 = (((_e453 * _e453) + (_e454 * _e454)) + (_e455 * _e455));
                    let _e471 = (_e460 + _e158);
                    let _e472 = (_e470 + _e158);
                    let _e475 = ((_e436 * _e455) - (_e437 * _e454));
                    let _e478 = ((_e437 * _e453) - (_e435 * _e455));
                    let _e481 = ((_e435 * _e454) - (_e436 * _e453));
                    let _e491 = (((((_e475 * _e475) + (_e478 * _e478)) + (_e481 * _e481)) + (_e158 * (_e460 + _e470))) + (_e158 * _e158));
                    let _e493 = (1f / _e491);
                    let _e494 = (_e472 * _e493);
                    let _e495 = (-(_e465) * _e493);
                    let _e496 = (_e471 * _e493);
                    let _e499 = (0.5f * (_e471 - _e472));
                    let _e508 = sqrt((11.082527f * ((0.5f * (_e471 + _e472)) + sqrt(((_e499 * _e499) + (_e465 * _e465))))));
                    let _e528 = (abs(_e335) <= 0x1.fffffep+127f);
                    if _e528 {
                        let _e530 = (abs((((((abs(_e494) + abs(_e495)) + abs(_e496)) + abs(_e340)) + abs(_e343)) + _e508)) <= 0x1.fffffep+127f);
                        if _e530 {
                            phi_541_ = (_e491 > 0f);
                        } else {
                            phi_541_ = bool();
                        }
                        let _e533 = phi_541_;
                        phi_543_ = _e533;
                        phi_544_ = select(true, false, _e530);
                    } else {
                        phi_543_ = bool();
                        phi_544_ = true;
                    }
                    let _e536 = phi_543_;
                    let _e538 = phi_544_;
                    let _e539 = select(_e536, false, _e538);
                    if _e336 {
                        if _e539 {
                            phi_557_ = type_16(vec2<f32>(_e340, _e343), vec2<f32>(((sqrt((11.082527f * _e471)) * 1.001f) + 0.01f), ((sqrt((11.082527f * _e472)) * 1.001f) + 0.01f)), vec3<f32>(_e494, _e495, _e496), _e508);
                        } else {
                            phi_557_ = type_16();
                        }
                        let _e546 = phi_557_;
                        phi_559_ = _e546;
                        phi_560_ = select(true, false, _e539);
                    } else {
                        phi_559_ = type_16();
                        phi_560_ = true;
                    }
                    let _e549 = phi_559_;
                    let _e551 = phi_560_;
                    if _e551 {
                        phi_565_ = type_16(vec2<f32>(0f, 0f), vec2<f32>(0f, 0f), vec3<f32>(0f, 0f, 0f), select(-1f, -2f, select(true, _e336, _e528)));
                    } else {
                        phi_565_ = _e549;
                    }
                    let _e554 = phi_565_;
                    global_9.member[_e279] = vec4<f32>(_e554.member.x, _e554.member.y, _e554.member_3, _e554.member_1.x);
                    global_9.member[(_e279 + 1u)] = vec4<f32>(_e554.member_2.x, _e554.member_2.y, _e554.member_2.z, _e554.member_1.y);
                    if (_e554.member_3 == -2f) {
                        let _e578 = atomicAdd((&global_10.member[0u]), 1u);
                    }
                } else {
                    global_9.member[_e279] = vec4<f32>(0f, 0f, -(f32(_e272)), 0f);
                    global_9.member[(_e279 + 1u)] = vec4<f32>(0f, 0f, 0f, 0f);
                }
                local = (_e274 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e590 = local;
                phi_465_ = _e590;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn project(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
