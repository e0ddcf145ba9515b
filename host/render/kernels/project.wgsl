struct type_4 {
    member: u32,
    member_1: f32,
}

struct type_5 {
    member: type_4,
}

struct type_8 {
    member: array<f32>,
}

struct type_15 {
    member: array<u32>,
}

struct type_22 {
    member: array<vec4<f32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec3<f32>,
    member_3: f32,
}

struct type_28 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_8;
@group(0) @binding(1) 
var<storage> global_5: type_8;
@group(0) @binding(2) 
var<storage> global_6: type_8;
@group(0) @binding(4) 
var<storage> global_7: type_8;
@group(0) @binding(5) 
var<storage> global_8: type_8;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_22;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_28;

fn function_() {
    var phi_474_: u32;
    var phi_538_: f32;
    var phi_543_: f32;
    var phi_548_: f32;
    var phi_553_: f32;
    var phi_558_: f32;
    var phi_563_: f32;
    var phi_572_: f32;
    var phi_578_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_586_: f32;
    var phi_599_: type_25;
    var phi_601_: type_25;
    var phi_602_: bool;
    var phi_607_: type_25;
    var local: u32;

    let _e53 = global;
    let _e54 = global_1;
    let _e55 = global_2;
    let _e63 = (((_e54.x + (_e54.y * _e55.x)) * 64u) + _e53.x);
    let _e66 = global_3.member.member;
    if (_e63 < _e66) {
        let _e69 = (_e54.z * 18u);
        let _e72 = global_5.member[_e69];
        let _e76 = global_5.member[(_e69 + 1u)];
        let _e80 = global_5.member[(_e69 + 2u)];
        let _e84 = global_5.member[(_e69 + 3u)];
        let _e88 = global_5.member[(_e69 + 4u)];
        let _e92 = global_5.member[(_e69 + 5u)];
        let _e96 = global_5.member[(_e69 + 6u)];
        let _e100 = global_5.member[(_e69 + 7u)];
        let _e104 = global_5.member[(_e69 + 8u)];
        let _e108 = global_5.member[(_e69 + 9u)];
        let _e112 = global_5.member[(_e69 + 10u)];
        let _e116 = global_5.member[(_e69 + 11u)];
        let _e120 = global_5.member[(_e69 + 12u)];
        let _e124 = global_5.member[(_e69 + 13u)];
        let _e128 = global_5.member[(_e69 + 14u)];
        let _e132 = global_5.member[(_e69 + 15u)];
        let _e136 = global_5.member[(_e69 + 16u)];
        let _e140 = global_5.member[(_e69 + 17u)];
        let _e141 = (_e54.z * 4u);
        let _e144 = global_6.member[_e141];
        let _e148 = global_6.member[(_e141 + 1u)];
        let _e152 = global_6.member[(_e141 + 2u)];
        let _e156 = global_6.member[(_e141 + 3u)];
        let _e159 = global_3.member.member_1;
        let _e160 = (_e63 * 3u);
        let _e161 = (_e160 + 1u);
        let _e162 = (_e160 + 2u);
        let _e165 = global_4.member[_e160];
        let _e168 = global_4.member[_e161];
        let _e171 = global_4.member[_e162];
        let _e172 = (_e165 - _e108);
        let _e173 = (_e168 - _e112);
        let _e174 = (_e171 - _e116);
        let _e189 = (((_e96 * _e172) + (_e100 * _e173)) + (_e104 * _e174));
        let _e192 = global_8.member[_e160];
        let _e195 = global_8.member[_e161];
        let _e198 = global_8.member[_e162];
        let _e199 = (1f / _e189);
        let _e200 = ((((_e72 * _e172) + (_e76 * _e173)) + (_e80 * _e174)) * _e199);
        let _e201 = ((((_e84 * _e172) + (_e88 * _e173)) + (_e92 * _e174)) * _e199);
        let _e203 = ((_e120 * _e200) + _e128);
        let _e205 = ((_e124 * _e201) + _e132);
        let _e206 = (1f / _e120);
        let _e207 = (1f / _e124);
        let _e210 = ((_e136 * _e206) * 0.15f);
        let _e211 = ((_e140 * _e207) * 0.15f);
        let _e216 = (((_e128 * _e206) * -1f) - _e210);
        let _e217 = (((_e132 * _e207) * -1f) - _e211);
        let _e222 = (((_e136 - _e128) * _e206) + _e210);
        let _e223 = (((_e140 - _e132) * _e207) + _e211);
        let _e225 = select(_e216, _e200, (_e200 > _e216));
        let _e227 = select(_e222, _e225, (_e225 < _e222));
        let _e229 = select(_e217, _e201, (_e201 > _e217));
        let _e231 = select(_e223, _e229, (_e229 < _e223));
        let _e244 = select(_e198, _e195, (_e195 > _e198));
        let _e247 = exp(select(_e244, _e192, (_e192 > _e244)));
        let _e252 = select(_e144, _e203, (_e203 > _e144));
        let _e255 = (_e203 - select(_e152, _e252, (_e252 < _e152)));
        let _e257 = select(_e148, _e205, (_e205 > _e148));
        let _e260 = (_e205 - select(_e156, _e257, (_e257 < _e156)));
        let _e273 = select(select(0u, 1u, select(false, (-0x1.fffffep+127f <= _e189), (_e189 <= 0x1.fffffep+127f))), select(0u, 3u, (((((((((((_e120 * _e120) * (1f + (_e227 * _e227))) + ((_e124 * _e124) * (1f + (_e231 * _e231)))) * _e199) * _e199) * _e247) * _e247) + _e159) * 11.304177f) + 0.02f) < ((_e255 * _e255) + (_e260 * _e260)))), (0.01f < _e189));
        phi_474_ = 0u;
        loop {
            let _e275 = phi_474_;
            if (_e275 < 1u) {
                let _e277 = (_e63 + _e275);
                let _e280 = (2u * ((_e54.z * _e66) + _e277));
                if (_e273 == 0u) {
                    let _e282 = (_e277 * 3u);
                    let _e285 = global_4.member[_e282];
                    let _e286 = (_e282 + 1u);
                    let _e289 = global_4.member[_e286];
                    let _e290 = (_e282 + 2u);
                    let _e293 = global_4.member[_e290];
                    let _e294 = (_e277 * 4u);
                    let _e297 = global_7.member[_e294];
                    let _e301 = global_7.member[(_e294 + 1u)];
                    let _e305 = global_7.member[(_e294 + 2u)];
                    let _e309 = global_7.member[(_e294 + 3u)];
                    let _e312 = global_8.member[_e282];
                    let _e315 = global_8.member[_e286];
                    let _e318 = global_8.member[_e290];
                    let _e319 = (_e285 - _e108);
                    let _e320 = (_e289 - _e112);
                    let _e321 = (_e293 - _e116);
                    let _e326 = (((_e72 * _e319) + (_e76 * _e320)) + (_e80 * _e321));
                    let _e331 = (((_e84 * _e319) + (_e88 * _e320)) + (_e92 * _e321));
                    let _e336 = (((_e96 * _e319) + (_e100 * _e320)) + (_e104 * _e321));
                    let _e337 = (0.01f < _e336);
                    let _e338 = select(1f, _e336, _e337);
                    let _e341 = (((_e120 * _e326) / _e338) + _e128);
                    let _e344 = (((_e124 * _e331) / _e338) + _e132);
                    let _e345 = (_e326 / _e338);
                    let _e347 = select(_e216, _e345, (_e345 > _e216));
                    let _e349 = select(_e222, _e347, (_e347 < _e222));
                    let _e350 = (_e331 / _e338);
                    let _e352 = select(_e217, _e350, (_e350 > _e217));
                    let _e354 = select(_e223, _e352, (_e352 < _e223));
                    let _e355 = (_e120 / _e338);
                    let _e356 = (_e124 / _e338);
                    let _e363 = ((_e72 - (_e96 * _e349)) * _e355);
                    let _e364 = ((_e76 - (_e100 * _e349)) * _e355);
                    let _e365 = ((_e80 - (_e104 * _e349)) * _e355);
                    let _e372 = ((_e84 - (_e96 * _e354)) * _e356);
                    let _e373 = ((_e88 - (_e100 * _e354)) * _e356);
                    let _e374 = ((_e92 - (_e104 * _e354)) * _e356);
                    let _e383 = (1f / sqrt(((((_e297 * _e297) + (_e301 * _e301)) + (_e305 * _e305)) + (_e309 * _e309))));
                    let _e384 = (_e297 * _e383);
                    let _e385 = (_e301 * _e383);
                    let _e386 = (_e305 * _e383);
                    let _e387 = (_e309 * _e383);
                    let _e388 = (_e386 * _e386);
                    let _e389 = (_e387 * _e387);
                    let _e392 = (1f - (2f * (_e388 + _e389)));
                    let _e393 = (_e385 * _e386);
                    let _e394 = (_e384 * _e387);
                    let _e396 = (2f * (_e393 + _e394));
                    let _e397 = (_e385 * _e387);
                    let _e398 = (_e384 * _e386);
                    let _e400 = (2f * (_e397 - _e398));
                    let _e402 = (2f * (_e393 - _e394));
                    let _e403 = (_e385 * _e385);
                    let _e406 = (1f - (2f * (_e403 + _e389)));
                    let _e407 = (_e386 * _e387);
                    let _e408 = (_e384 * _e385);
                    let _e410 = (2f * (_e407 + _e408));
                    let _e412 = (2f * (_e397 + _e398));
                    let _e414 = (2f * (_e407 - _e408));
                    let _e417 = (1f - (2f * (_e403 + _e388)));
                    let _e418 = exp(_e312);
                    let _e419 = exp(_e315);
                    let _e420 = exp(_e318);
                    let _e436 = ((((_e363 * _e392) + (_e364 * _e396)) + (_e365 * _e400)) * _e418);
                    let _e437 = ((((_e363 * _e402) + (_e364 * _e406)) + (_e365 * _e410)) * _e419);
                    let _e438 = ((((_e363 * _e412) + (_e364 * _e414)) + (_e365 * _e417)) * _e420);
                    let _e454 = ((((_e372 * _e392) + (_e373 * _e396)) + (_e374 * _e400)) * _e418);
                    let _e455 = ((((_e372 * _e402) + (_e373 * _e406)) + (_e374 * _e410)) * _e419);
                    let _e456 = ((((_e372 * _e412) + (_e373 * _e414)) + (_e374 * _e417)) * _e420);
                    let _e461 = (((_e436 * _e436) + (_e437 * _e437)) + (_e438 * _e438));
                    let _e466 = (((_e436 * _e454) + (_e437 * _e455)) + (_e438 * _e456));
                    let _e471 = (((_e454 * _e454) + (_e455 * _e455)) + (_e456 * _e456));
                    let _e472 = (_e461 + _e159);
                    let _e473 = (_e471 + _e159);
                    let _e476 = ((_e437 * _e456) - (_e438 * _e455));
                    let _e479 = ((_e438 * _e454) - (_e436 * _e456));
                    let _e482 = ((_e436 * _e455) - (_e437 * _e454));
                    let _e492 = (((((_e476 * _e476) + (_e479 * _e479)) + (_e482 * _e482)) + (_e159 * (_e461 + _e471))) + (_e159 * _e159));
                    let _e494 = (1f / _e492);
                    let _e495 = (_e473 * _e494);
                    let _e496 = (-(_e466) * _e494);
                    let _e497 = (_e472 * _e494);
                    let _e500 = (0.5f * (_e472 - _e473));
                    let _e509 = sqrt((11.082527f * ((0.5f * (_e472 + _e473)) + sqrt(((_e500 * _e500) + (_e466 * _e466))))));
                    if (_e495 < 0f) {
                        phi_538_ = -(_e495);
                    } else {
                        phi_538_ = _e495;
                    }
                    let _e521 = phi_538_;
                    if (_e496 < 0f) {
                        phi_543_ = -(_e496);
                    } else {
                        phi_543_ = _e496;
                    }
                    let _e525 = phi_543_;
                    if (_e497 < 0f) {
                        phi_548_ = -(_e497);
                    } else {
                        phi_548_ = _e497;
                    }
                    let _e530 = phi_548_;
                    if (_e341 < 0f) {
                        phi_553_ = -(_e341);
                    } else {
                        phi_553_ = _e341;
                    }
                    let _e535 = phi_553_;
                    if (_e344 < 0f) {
                        phi_558_ = -(_e344);
                    } else {
                        phi_558_ = _e344;
                    }
                    let _e540 = phi_558_;
                    let _e542 = (((((_e521 + _e525) + _e530) + _e535) + _e540) + _e509);
                    let _e543 = (_e336 < 0f);
                    if _e543 {
                        phi_563_ = -(_e336);
                    } else {
                        phi_563_ = _e336;
                    }
                    let _e546 = phi_563_;
                    if (_e546 <= 0x1.fffffep+127f) {
                        if (_e542 < 0f) {
                            phi_572_ = -(_e542);
                        } else {
                            phi_572_ = _e542;
                        }
                        let _e551 = phi_572_;
                        let _e552 = (_e551 <= 0x1.fffffep+127f);
                        if _e552 {
                            phi_578_ = (_e492 > 0f);
                        } else {
                            phi_578_ = bool();
                        }
                        let _e555 = phi_578_;
                        phi_580_ = _e555;
                        phi_581_ = select(true, false, _e552);
                    } else {
                        phi_580_ = bool();
                        phi_581_ = true;
                    }
                    let _e558 = phi_580_;
                    let _e560 = phi_581_;
                    let _e561 = select(_e558, false, _e560);
                    if _e543 {
                        phi_586_ = -(_e336);
                    } else {
                        phi_586_ = _e336;
                    }
                    let _e564 = phi_586_;
                    if _e337 {
                        if _e561 {
                            phi_599_ = type_25(vec2<f32>(_e341, _e344), vec2<f32>(((sqrt((11.082527f * _e472)) * 1.001f) + 0.01f), ((sqrt((11.082527f * _e473)) * 1.001f) + 0.01f)), vec3<f32>(_e495, _e496, _e497), _e509);
                        } else {
                            phi_599_ = type_25();
                        }
                        let _e572 = phi_599_;
                        phi_601_ = _e572;
                        phi_602_ = select(true, false, _e561);
                    } else {
                        phi_601_ = type_25();
                        phi_602_ = true;
                    }
                    let _e575 = phi_601_;
                    let _e577 = phi_602_;
                    if _e577 {
                        phi_607_ = type_25(vec2<f32>(0f, 0f), vec2<f32>(0f, 0f), vec3<f32>(0f, 0f, 0f), select(-1f, -2f, select(true, _e337, (_e564 <= 0x1.fffffep+127f))));
                    } else {
                        phi_607_ = _e575;
                    }
                    let _e580 = phi_607_;
                    global_9.member[_e280] = vec4<f32>(_e580.member.x, _e580.member.y, _e580.member_3, _e580.member_1.x);
                    global_9.member[(_e280 + 1u)] = vec4<f32>(_e580.member_2.x, _e580.member_2.y, _e580.member_2.z, _e580.member_1.y);
                    if (_e580.member_3 == -2f) {
                        let _e604 = atomicAdd((&global_10.member[0u]), 1u);
                    }
                } else {
                    global_9.member[_e280] = vec4<f32>(0f, 0f, -(f32(_e273)), 0f);
                    global_9.member[(_e280 + 1u)] = vec4<f32>(0f, 0f, 0f, 0f);
                }
                local = (_e275 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e616 = local;
                phi_474_ = _e616;
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
