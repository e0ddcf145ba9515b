struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_19 {
    member: u32,
    member_1: f32,
}

struct type_20 {
    member: type_19,
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
var<uniform> global_3: type_20;
@group(0) @binding(3) 
var<storage> global_4: type_9;
@group(0) @binding(1) 
var<storage> global_5: type_9;
@group(0) @binding(2) 
var<storage> global_6: type_9;
@group(0) @binding(4) 
var<storage> global_7: type_9;
@group(0) @binding(5) 
var<storage> global_8: type_9;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_6;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_28;

fn function_() {
    var phi_466_: f32;
    var phi_473_: bool;
    var phi_507_: bool;
    var phi_556_: f32;
    var phi_561_: f32;
    var phi_566_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_580_: f32;
    var phi_589_: f32;
    var phi_595_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_603_: f32;
    var phi_616_: type_25;
    var phi_618_: type_25;
    var phi_619_: bool;
    var phi_624_: type_25;

    let _e52 = global;
    let _e53 = global_1;
    let _e54 = global_2;
    let _e62 = (((_e53.x + (_e53.y * _e54.x)) * 64u) + _e52.x);
    let _e65 = global_3.member.member;
    if (_e62 < _e65) {
        let _e68 = (_e53.z * 18u);
        let _e71 = global_5.member[_e68];
        let _e75 = global_5.member[(_e68 + 1u)];
        let _e79 = global_5.member[(_e68 + 2u)];
        let _e83 = global_5.member[(_e68 + 3u)];
        let _e87 = global_5.member[(_e68 + 4u)];
        let _e91 = global_5.member[(_e68 + 5u)];
        let _e95 = global_5.member[(_e68 + 6u)];
        let _e99 = global_5.member[(_e68 + 7u)];
        let _e103 = global_5.member[(_e68 + 8u)];
        let _e107 = global_5.member[(_e68 + 9u)];
        let _e111 = global_5.member[(_e68 + 10u)];
        let _e115 = global_5.member[(_e68 + 11u)];
        let _e119 = global_5.member[(_e68 + 12u)];
        let _e123 = global_5.member[(_e68 + 13u)];
        let _e127 = global_5.member[(_e68 + 14u)];
        let _e131 = global_5.member[(_e68 + 15u)];
        let _e135 = global_5.member[(_e68 + 16u)];
        let _e139 = global_5.member[(_e68 + 17u)];
        let _e140 = (_e53.z * 4u);
        let _e143 = global_6.member[_e140];
        let _e147 = global_6.member[(_e140 + 1u)];
        let _e151 = global_6.member[(_e140 + 2u)];
        let _e155 = global_6.member[(_e140 + 3u)];
        let _e156 = (_e62 * 3u);
        let _e159 = global_4.member[_e156];
        let _e160 = (_e156 + 1u);
        let _e163 = global_4.member[_e160];
        let _e164 = (_e156 + 2u);
        let _e167 = global_4.member[_e164];
        let _e170 = global_8.member[_e156];
        let _e173 = global_8.member[_e160];
        let _e176 = global_8.member[_e164];
        let _e177 = (_e159 - _e107);
        let _e178 = (_e163 - _e111);
        let _e179 = (_e167 - _e115);
        let _e184 = (((_e71 * _e177) + (_e75 * _e178)) + (_e79 * _e179));
        let _e189 = (((_e83 * _e177) + (_e87 * _e178)) + (_e91 * _e179));
        let _e194 = (((_e95 * _e177) + (_e99 * _e178)) + (_e103 * _e179));
        let _e195 = (_e194 < 0f);
        if _e195 {
            phi_466_ = -(_e194);
        } else {
            phi_466_ = _e194;
        }
        let _e198 = phi_466_;
        if (_e198 <= 0x1.fffffep+127f) {
            phi_473_ = !((_e194 > 0.01f));
        } else {
            phi_473_ = false;
        }
        let _e203 = phi_473_;
        let _e204 = (_e194 > 0.01f);
        let _e207 = (2u * ((_e53.z * _e65) + _e62));
        if _e204 {
            let _e210 = global_3.member.member_1;
            let _e211 = select(1f, _e194, _e204);
            let _e214 = (((_e119 * _e184) / _e211) + _e127);
            let _e217 = (((_e123 * _e189) / _e211) + _e131);
            let _e218 = (1f / _e119);
            let _e219 = (1f / _e123);
            let _e222 = ((_e135 * _e218) * 0.15f);
            let _e223 = ((_e139 * _e219) * 0.15f);
            let _e228 = (((_e127 * _e218) * -1f) - _e222);
            let _e229 = (((_e131 * _e219) * -1f) - _e223);
            let _e234 = (((_e135 - _e127) * _e218) + _e222);
            let _e235 = (((_e139 - _e131) * _e219) + _e223);
            let _e236 = (_e184 / _e211);
            let _e238 = select(_e228, _e236, (_e236 > _e228));
            let _e240 = select(_e234, _e238, (_e238 < _e234));
            let _e241 = (_e189 / _e211);
            let _e243 = select(_e229, _e241, (_e241 > _e229));
            let _e245 = select(_e235, _e243, (_e243 < _e235));
            let _e246 = (_e119 / _e211);
            let _e247 = (_e123 / _e211);
            let _e254 = ((_e71 - (_e95 * _e240)) * _e246);
            let _e255 = ((_e75 - (_e99 * _e240)) * _e246);
            let _e256 = ((_e79 - (_e103 * _e240)) * _e246);
            let _e263 = ((_e83 - (_e95 * _e245)) * _e247);
            let _e264 = ((_e87 - (_e99 * _e245)) * _e247);
            let _e265 = ((_e91 - (_e103 * _e245)) * _e247);
            let _e267 = select(_e176, _e173, (_e173 > _e176));
            let _e270 = exp(select(_e267, _e170, (_e170 > _e267)));
            let _e286 = select(_e143, _e214, (_e214 > _e143));
            let _e289 = (_e214 - select(_e151, _e286, (_e286 < _e151)));
            let _e291 = select(_e147, _e217, (_e217 > _e147));
            let _e294 = (_e217 - select(_e155, _e291, (_e291 < _e155)));
            phi_507_ = select((((_e289 * _e289) + (_e294 * _e294)) > (((((((((_e254 * _e254) + (_e255 * _e255)) + (_e256 * _e256)) + (((_e263 * _e263) + (_e264 * _e264)) + (_e265 * _e265))) * _e270) * _e270) + _e210) * 11.304177f) + 0.02f)), true, _e203);
        } else {
            phi_507_ = _e203;
        }
        let _e303 = phi_507_;
        if _e303 {
            global_9.member[_e207] = vec4<f32>(0f, 0f, select(-3f, -1f, _e203), 0f);
            global_9.member[(_e207 + 1u)] = vec4<f32>(0f, 0f, 0f, 0f);
        }
        if select(true, false, _e303) {
            let _e312 = (_e62 * 4u);
            let _e315 = global_7.member[_e312];
            let _e319 = global_7.member[(_e312 + 1u)];
            let _e323 = global_7.member[(_e312 + 2u)];
            let _e327 = global_7.member[(_e312 + 3u)];
            let _e330 = global_3.member.member_1;
            let _e331 = select(1f, _e194, _e204);
            let _e334 = (((_e119 * _e184) / _e331) + _e127);
            let _e337 = (((_e123 * _e189) / _e331) + _e131);
            let _e338 = (1f / _e119);
            let _e339 = (1f / _e123);
            let _e342 = ((_e135 * _e338) * 0.15f);
            let _e343 = ((_e139 * _e339) * 0.15f);
            let _e348 = (((_e127 * _e338) * -1f) - _e342);
            let _e349 = (((_e131 * _e339) * -1f) - _e343);
            let _e354 = (((_e135 - _e127) * _e338) + _e342);
            let _e355 = (((_e139 - _e131) * _e339) + _e343);
            let _e356 = (_e184 / _e331);
            let _e358 = select(_e348, _e356, (_e356 > _e348));
            let _e360 = select(_e354, _e358, (_e358 < _e354));
            let _e361 = (_e189 / _e331);
            let _e363 = select(_e349, _e361, (_e361 > _e349));
            let _e365 = select(_e355, _e363, (_e363 < _e355));
            let _e366 = (_e119 / _e331);
            let _e367 = (_e123 / _e331);
            let _e374 = ((_e71 - (_e95 * _e360)) * _e366);
            let _e375 = ((_e75 - (_e99 * _e360)) * _e366);
            let _e376 = ((_e79 - (_e103 * _e360)) * _e366);
            let _e383 = ((_e83 - (_e95 * _e365)) * _e367);
            let _e384 = ((_e87 - (_e99 * _e365)) * _e367);
            let _e385 = ((_e91 - (_e103 * _e365)) * _e367);
            let _e394 = (1f / sqrt(((((_e315 * _e315) + (_e319 * _e319)) + (_e323 * _e323)) + (_e327 * _e327))));
            let _e395 = (_e315 * _e394);
            let _e396 = (_e319 * _e394);
            let _e397 = (_e323 * _e394);
            let _e398 = (_e327 * _e394);
            let _e399 = (_e397 * _e397);
            let _e400 = (_e398 * _e398);
            let _e403 = (1f - (2f * (_e399 + _e400)));
            let _e404 = (_e396 * _e397);
            let _e405 = (_e395 * _e398);
            let _e407 = (2f * (_e404 + _e405));
            let _e408 = (_e396 * _e398);
            let _e409 = (_e395 * _e397);
            let _e411 = (2f * (_e408 - _e409));
            let _e413 = (2f * (_e404 - _e405));
            let _e414 = (_e396 * _e396);
            let _e417 = (1f - (2f * (_e414 + _e400)));
            let _e418 = (_e397 * _e398);
            let _e419 = (_e395 * _e396);
            let _e421 = (2f * (_e418 + _e419));
            let _e423 = (2f * (_e408 + _e409));
            let _e425 = (2f * (_e418 - _e419));
            let _e428 = (1f - (2f * (_e414 + _e399)));
            let _e429 = exp(_e170);
            let _e430 = exp(_e173);
            let _e431 = exp(_e176);
            let _e447 = ((((_e374 * _e403) + (_e375 * _e407)) + (_e376 * _e411)) * _e429);
            let _e448 = ((((_e374 * _e413) + (_e375 * _e417)) + (_e376 * _e421)) * _e430);
            let _e449 = ((((_e374 * _e423) + (_e375 * _e425)) + (_e376 * _e428)) * _e431);
            let _e465 = ((((_e383 * _e403) + (_e384 * _e407)) + (_e385 * _e411)) * _e429);
            let _e466 = ((((_e383 * _e413) + (_e384 * _e417)) + (_e385 * _e421)) * _e430);
            let _e467 = ((((_e383 * _e423) + (_e384 * _e425)) + (_e385 * _e428)) * _e431);
            let _e472 = (((_e447 * _e447) + (_e448 * _e448)) + (_e449 * _e449));
            let _e477 = (((_e447 * _e465) + (_e448 * _e466)) + (_e449 * _e467));
            let _e482 = (((_e465 * _e465) + (_e466 * _e466)) + (_e467 * _e467));
            let _e483 = (_e472 + _e330);
            let _e484 = (_e482 + _e330);
            let _e487 = ((_e448 * _e467) - (_e449 * _e466));
            let _e490 = ((_e449 * _e465) - (_e447 * _e467));
            let _e493 = ((_e447 * _e466) - (_e448 * _e465));
            let _e503 = (((((_e487 * _e487) + (_e490 * _e490)) + (_e493 * _e493)) + (_e330 * (_e472 + _e482))) + (_e330 * _e330));
            let _e505 = (1f / _e503);
            let _e506 = (_e484 * _e505);
            let _e507 = (-(_e477) * _e505);
            let _e508 = (_e483 * _e505);
            let _e511 = (0.5f * (_e483 - _e484));
            let _e520 = sqrt((11.082527f * ((0.5f * (_e483 + _e484)) + sqrt(((_e511 * _e511) + (_e477 * _e477))))));
            if (_e506 < 0f) {
                phi_556_ = -(_e506);
            } else {
                phi_556_ = _e506;
            }
            let _e532 = phi_556_;
            if (_e507 < 0f) {
                phi_561_ = -(_e507);
            } else {
                phi_561_ = _e507;
            }
            let _e536 = phi_561_;
            if (_e508 < 0f) {
                phi_566_ = -(_e508);
            } else {
                phi_566_ = _e508;
            }
            let _e541 = phi_566_;
            if (_e334 < 0f) {
                phi_571_ = -(_e334);
            } else {
                phi_571_ = _e334;
            }
            let _e546 = phi_571_;
            if (_e337 < 0f) {
                phi_576_ = -(_e337);
            } else {
                phi_576_ = _e337;
            }
            let _e551 = phi_576_;
            let _e553 = (((((_e532 + _e536) + _e541) + _e546) + _e551) + _e520);
            if _e195 {
                phi_580_ = -(_e194);
            } else {
                phi_580_ = _e194;
            }
            let _e556 = phi_580_;
            if (_e556 <= 0x1.fffffep+127f) {
                if (_e553 < 0f) {
                    phi_589_ = -(_e553);
                } else {
                    phi_589_ = _e553;
                }
                let _e561 = phi_589_;
                let _e562 = (_e561 <= 0x1.fffffep+127f);
                if _e562 {
                    phi_595_ = (_e503 > 0f);
                } else {
                    phi_595_ = bool();
                }
                let _e565 = phi_595_;
                phi_597_ = _e565;
                phi_598_ = select(true, false, _e562);
            } else {
                phi_597_ = bool();
                phi_598_ = true;
            }
            let _e568 = phi_597_;
            let _e570 = phi_598_;
            let _e571 = select(_e568, false, _e570);
            if _e195 {
                phi_603_ = -(_e194);
            } else {
                phi_603_ = _e194;
            }
            let _e574 = phi_603_;
            if _e204 {
                if _e571 {
                    phi_616_ = type_25(vec2<f32>(_e334, _e337), vec2<f32>(((sqrt((11.082527f * _e483)) * 1.001f) + 0.01f), ((sqrt((11.082527f * _e484)) * 1.001f) + 0.01f)), vec3<f32>(_e506, _e507, _e508), _e520);
                } else {
                    phi_616_ = type_25();
                }
                let _e582 = phi_616_;
                phi_618_ = _e582;
                phi_619_ = select(true, false, _e571);
            } else {
                phi_618_ = type_25();
                phi_619_ = true;
            }
            let _e585 = phi_618_;
            let _e587 = phi_619_;
            if _e587 {
                phi_624_ = type_25(vec2<f32>(0f, 0f), vec2<f32>(0f, 0f), vec3<f32>(0f, 0f, 0f), select(-1f, -2f, select(true, _e204, (_e574 <= 0x1.fffffep+127f))));
            } else {
                phi_624_ = _e585;
            }
            let _e590 = phi_624_;
            global_9.member[_e207] = vec4<f32>(_e590.member.x, _e590.member.y, _e590.member_3, _e590.member_1.x);
            global_9.member[(_e207 + 1u)] = vec4<f32>(_e590.member_2.x, _e590.member_2.y, _e590.member_2.z, _e590.member_1.y);
            if (_e590.member_3 == -2f) {
                let _e614 = atomicAdd((&global_10.member[0u]), 1u);
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
