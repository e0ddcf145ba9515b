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
    var phi_487_: u32;
    var phi_563_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_579_: type_16;
    var phi_581_: type_16;
    var phi_582_: bool;
    var phi_587_: type_16;
    var local: u32;

    let _e54 = global;
    let _e55 = global_1;
    let _e56 = global_2;
    let _e64 = (((_e55.x + (_e55.y * _e56.x)) * 64u) + _e54.x);
    let _e67 = global_3.member.member;
    if (_e64 < _e67) {
        let _e70 = (_e55.z * 18u);
        let _e73 = global_4.member[_e70];
        let _e77 = global_4.member[(_e70 + 1u)];
        let _e81 = global_4.member[(_e70 + 2u)];
        let _e85 = global_4.member[(_e70 + 3u)];
        let _e89 = global_4.member[(_e70 + 4u)];
        let _e93 = global_4.member[(_e70 + 5u)];
        let _e97 = global_4.member[(_e70 + 6u)];
        let _e101 = global_4.member[(_e70 + 7u)];
        let _e105 = global_4.member[(_e70 + 8u)];
        let _e109 = global_4.member[(_e70 + 9u)];
        let _e113 = global_4.member[(_e70 + 10u)];
        let _e117 = global_4.member[(_e70 + 11u)];
        let _e121 = global_4.member[(_e70 + 12u)];
        let _e125 = global_4.member[(_e70 + 13u)];
        let _e129 = global_4.member[(_e70 + 14u)];
        let _e133 = global_4.member[(_e70 + 15u)];
        let _e137 = global_4.member[(_e70 + 16u)];
        let _e141 = global_4.member[(_e70 + 17u)];
        let _e142 = (_e55.z * 4u);
        let _e145 = global_5.member[_e142];
        let _e149 = global_5.member[(_e142 + 1u)];
        let _e153 = global_5.member[(_e142 + 2u)];
        let _e157 = global_5.member[(_e142 + 3u)];
        let _e160 = global_3.member.member_1;
        let _e163 = ((_e64 + u32(0f)) * 3u);
        let _e164 = (_e163 + 1u);
        let _e165 = (_e163 + 2u);
        let _e168 = global_6.member[_e163];
        let _e171 = global_6.member[_e164];
        let _e174 = global_6.member[_e165];
        let _e175 = (_e168 - _e109);
        let _e176 = (_e171 - _e113);
        let _e177 = (_e174 - _e117);
        let _e192 = (((_e97 * _e175) + (_e101 * _e176)) + (_e105 * _e177));
        let _e195 = global_7.member[_e163];
        let _e198 = global_7.member[_e164];
        let _e201 = global_7.member[_e165];
        let _e202 = (1f / _e192);
        let _e203 = ((((_e73 * _e175) + (_e77 * _e176)) + (_e81 * _e177)) * _e202);
        let _e204 = ((((_e85 * _e175) + (_e89 * _e176)) + (_e93 * _e177)) * _e202);
        let _e206 = ((_e121 * _e203) + _e129);
        let _e208 = ((_e125 * _e204) + _e133);
        let _e209 = (1f / _e121);
        let _e210 = (1f / _e125);
        let _e213 = ((_e137 * _e209) * 0.15f);
        let _e214 = ((_e141 * _e210) * 0.15f);
        let _e219 = (((_e129 * _e209) * -1f) - _e213);
        let _e220 = (((_e133 * _e210) * -1f) - _e214);
        let _e225 = (((_e137 - _e129) * _e209) + _e213);
        let _e226 = (((_e141 - _e133) * _e210) + _e214);
        let _e228 = select(_e219, _e203, (_e203 > _e219));
        let _e230 = select(_e225, _e228, (_e228 < _e225));
        let _e232 = select(_e220, _e204, (_e204 > _e220));
        let _e234 = select(_e226, _e232, (_e232 < _e226));
        let _e247 = select(_e201, _e198, (_e198 > _e201));
        let _e250 = exp(select(_e247, _e195, (_e195 > _e247)));
        let _e256 = select(_e145, _e206, (_e206 > _e145));
        let _e259 = (_e206 - select(_e153, _e256, (_e256 < _e153)));
        let _e261 = select(_e149, _e208, (_e208 > _e149));
        let _e264 = (_e208 - select(_e157, _e261, (_e261 < _e157)));
        let _e271 = -(-3f);
        let _e272 = bitcast<f32>(0u);
        let _e273 = bitcast<f32>(1333788671u);
        let _e285 = -(-1f);
        let _e294 = select(select(0u, select(select(u32(_e285), 0u, !((_e285 >= _e272))), 4294967295u, (_e285 > _e273)), select(false, (-(0x1.fffffep+127f) <= _e192), (_e192 <= 0x1.fffffep+127f))), select(0u, select(select(u32(_e271), 0u, !((_e271 >= _e272))), 4294967295u, (_e271 > _e273)), (((1.02f * (11.082527f * ((((((((_e121 * _e121) * (1f + (_e230 * _e230))) + ((_e125 * _e125) * (1f + (_e234 * _e234)))) * _e202) * _e202) * _e250) * _e250) + _e160))) + 0.02f) < ((_e259 * _e259) + (_e264 * _e264)))), (0.01f < _e192));
        phi_487_ = 0u;
        loop {
            let _e296 = phi_487_;
            if (_e296 < 1u) {
                let _e298 = (_e64 + _e296);
                let _e301 = (2u * ((_e55.z * _e67) + _e298));
                if (_e294 == 0u) {
                    let _e303 = (_e298 * 3u);
                    let _e306 = global_6.member[_e303];
                    let _e307 = (_e303 + 1u);
                    let _e310 = global_6.member[_e307];
                    let _e311 = (_e303 + 2u);
                    let _e314 = global_6.member[_e311];
                    let _e315 = (_e298 * 4u);
                    let _e318 = global_8.member[_e315];
                    let _e322 = global_8.member[(_e315 + 1u)];
                    let _e326 = global_8.member[(_e315 + 2u)];
                    let _e330 = global_8.member[(_e315 + 3u)];
                    let _e333 = global_7.member[_e303];
                    let _e336 = global_7.member[_e307];
                    let _e339 = global_7.member[_e311];
                    let _e340 = (_e306 - _e109);
                    let _e341 = (_e310 - _e113);
                    let _e342 = (_e314 - _e117);
                    let _e347 = (((_e73 * _e340) + (_e77 * _e341)) + (_e81 * _e342));
                    let _e352 = (((_e85 * _e340) + (_e89 * _e341)) + (_e93 * _e342));
                    let _e357 = (((_e97 * _e340) + (_e101 * _e341)) + (_e105 * _e342));
                    let _e358 = (0.01f < _e357);
                    let _e359 = select(1f, _e357, _e358);
                    let _e362 = (((_e121 * _e347) / _e359) + _e129);
                    let _e365 = (((_e125 * _e352) / _e359) + _e133);
                    let _e366 = (_e347 / _e359);
                    let _e368 = select(_e219, _e366, (_e366 > _e219));
                    let _e370 = select(_e225, _e368, (_e368 < _e225));
                    let _e371 = (_e352 / _e359);
                    let _e373 = select(_e220, _e371, (_e371 > _e220));
                    let _e375 = select(_e226, _e373, (_e373 < _e226));
                    let _e376 = (_e121 / _e359);
                    let _e377 = (_e125 / _e359);
                    let _e384 = ((_e73 - (_e97 * _e370)) * _e376);
                    let _e385 = ((_e77 - (_e101 * _e370)) * _e376);
                    let _e386 = ((_e81 - (_e105 * _e370)) * _e376);
                    let _e393 = ((_e85 - (_e97 * _e375)) * _e377);
                    let _e394 = ((_e89 - (_e101 * _e375)) * _e377);
                    let _e395 = ((_e93 - (_e105 * _e375)) * _e377);
                    let _e404 = (1f / sqrt(((((_e318 * _e318) + (_e322 * _e322)) + (_e326 * _e326)) + (_e330 * _e330))));
                    let _e405 = (_e318 * _e404);
                    let _e406 = (_e322 * _e404);
                    let _e407 = (_e326 * _e404);
                    let _e408 = (_e330 * _e404);
                    let _e409 = (_e407 * _e407);
                    let _e410 = (_e408 * _e408);
                    let _e413 = (1f - (2f * (_e409 + _e410)));
                    let _e414 = (_e406 * _e407);
                    let _e415 = (_e405 * _e408);
                    let _e417 = (2f * (_e414 + _e415));
                    let _e418 = (_e406 * _e408);
                    let _e419 = (_e405 * _e407);
                    let _e421 = (2f * (_e418 - _e419));
                    let _e423 = (2f * (_e414 - _e415));
                    let _e424 = (_e406 * _e406);
                    let _e427 = (1f - (2f * (_e424 + _e410)));
                    let _e428 = (_e407 * _e408);
                    let _e429 = (_e405 * _e406);
                    let _e431 = (2f * (_e428 + _e429));
                    let _e433 = (2f * (_e418 + _e419));
                    let _e435 = (2f * (_e428 - _e429));
                    let _e438 = (1f - (2f * (_e424 + _e409)));
                    let _e439 = exp(_e333);
                    let _e440 = exp(_e336);
                    let _e441 = exp(_e339);
                    let _e457 = ((((_e384 * _e413) + (_e385 * _e417)) + (_e386 * _e421)) * _e439);
                    let _e458 = ((((_e384 * _e423) + (_e385 * _e427)) + (_e386 * _e431)) * _e440);
                    let _e459 = ((((_e384 * _e433) + (_e385 * _e435)) + (_e386 * _e438)) * _e441);
                    let _e475 = ((((_e393 * _e413) + (_e394 * _e417)) + (_e395 * _e421)) * _e439);
                    let _e476 = ((((_e393 * _e423) + (_e394 * _e427)) + (_e395 * _e431)) * _e440);
                    let _e477 = ((((_e393 * _e433) + (_e394 * _e435)) + (_e395 * _e438)) * _e441);
                    let _e482 = (((_e457 * _e457) + (_e458 * _e458)) + (_e459 * _e459));
                    let _e487 = (((_e457 * _e475) + (_e458 * _e476)) + (_e459 * _e477));
                    let _e492 = (((_e475 * _e475) + (_e476 * _e476)) + (_e477 * _e477));
                    let _e493 = (_e482 + _e160);
                    let _e494 = (_e492 + _e160);
                    let _e497 = ((_e458 * _e477) - (_e459 * _e476));
                    let _e500 = ((_e459 * _e475) - (_e457 * _e477));
                    let _e503 = ((_e457 * _e476) - (_e458 * _e475));
                    let _e513 = (((((_e497 * _e497) + (_e500 * _e500)) + (_e503 * _e503)) + (_e160 * (_e482 + _e492))) + (_e160 * _e160));
                    let _e515 = (1f / _e513);
                    let _e516 = (_e494 * _e515);
                    let _e517 = (-(_e487) * _e515);
                    let _e518 = (_e493 * _e515);
                    let _e521 = (0.5f * (_e493 - _e494));
                    let _e530 = sqrt((11.082527f * ((0.5f * (_e493 + _e494)) + sqrt(((_e521 * _e521) + (_e487 * _e487))))));
                    let _e550 = (abs(_e357) <= 0x1.fffffep+127f);
                    if _e550 {
                        let _e552 = (abs((((((abs(_e516) + abs(_e517)) + abs(_e518)) + abs(_e362)) + abs(_e365)) + _e530)) <= 0x1.fffffep+127f);
                        if _e552 {
                            phi_563_ = (_e513 > 0f);
                        } else {
                            phi_563_ = bool();
                        }
                        let _e555 = phi_563_;
                        phi_565_ = _e555;
                        phi_566_ = select(true, false, _e552);
                    } else {
                        phi_565_ = bool();
                        phi_566_ = true;
                    }
                    let _e558 = phi_565_;
                    let _e560 = phi_566_;
                    let _e561 = select(_e558, false, _e560);
                    if _e358 {
                        if _e561 {
                            phi_579_ = type_16(vec2<f32>(_e362, _e365), vec2<f32>(((sqrt((11.082527f * _e493)) * 1.001f) + 0.01f), ((sqrt((11.082527f * _e494)) * 1.001f) + 0.01f)), vec3<f32>(_e516, _e517, _e518), _e530);
                        } else {
                            phi_579_ = type_16();
                        }
                        let _e568 = phi_579_;
                        phi_581_ = _e568;
                        phi_582_ = select(true, false, _e561);
                    } else {
                        phi_581_ = type_16();
                        phi_582_ = true;
                    }
                    let _e571 = phi_581_;
                    let _e573 = phi_582_;
                    if _e573 {
                        phi_587_ = type_16(vec2<f32>(0f, 0f), vec2<f32>(0f, 0f), vec3<f32>(0f, 0f, 0f), select(-1f, -2f, select(true, _e358, _e550)));
                    } else {
                        phi_587_ = _e571;
                    }
                    let _e576 = phi_587_;
                    global_9.member[_e301] = vec4<f32>(_e576.member.x, _e576.member.y, _e576.member_3, _e576.member_1.x);
                    global_9.member[(_e301 + 1u)] = vec4<f32>(_e576.member_2.x, _e576.member_2.y, _e576.member_2.z, _e576.member_1.y);
                    if (_e576.member_3 == -2f) {
                        let _e600 = atomicAdd((&global_10.member[0u]), 1u);
                    }
                } else {
                    global_9.member[_e301] = vec4<f32>(0f, 0f, -(f32(_e294)), 0f);
                    global_9.member[(_e301 + 1u)] = vec4<f32>(0f, 0f, 0f, 0f);
                }
                local = (_e296 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e612 = local;
                phi_487_ = _e612;
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
