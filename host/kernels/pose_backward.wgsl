struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_18 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_22 {
    member: type_21,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_22;
@group(0) @binding(1) 
var<storage> global_4: type_5;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage> global_8: type_12;
@group(0) @binding(6) 
var<storage> global_9: type_12;
@group(0) @binding(7) 
var<storage> global_10: type_18;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_5;

fn function_() {
    var phi_548_: vec3<f32>;
    var phi_551_: vec3<f32>;
    var phi_553_: u32;
    var phi_555_: u32;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var local_3: vec3<f32>;
    var local_4: vec3<f32>;
    var local_5: vec3<f32>;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: u32;
    var local_9: u32;

    let _e44 = global;
    let _e45 = global_1;
    let _e46 = global_2;
    let _e54 = (((_e45.x + (_e45.y * _e46.x)) * 64u) + _e44.x);
    let _e57 = global_3.member.member_2;
    if (_e54 < _e57) {
        let _e60 = (_e45.z * 18u);
        let _e63 = global_4.member[_e60];
        let _e67 = global_4.member[(_e60 + 1u)];
        let _e71 = global_4.member[(_e60 + 2u)];
        let _e75 = global_4.member[(_e60 + 3u)];
        let _e79 = global_4.member[(_e60 + 4u)];
        let _e83 = global_4.member[(_e60 + 5u)];
        let _e87 = global_4.member[(_e60 + 6u)];
        let _e91 = global_4.member[(_e60 + 7u)];
        let _e95 = global_4.member[(_e60 + 8u)];
        let _e99 = global_4.member[(_e60 + 9u)];
        let _e103 = global_4.member[(_e60 + 10u)];
        let _e107 = global_4.member[(_e60 + 11u)];
        let _e111 = global_4.member[(_e60 + 12u)];
        let _e115 = global_4.member[(_e60 + 13u)];
        let _e119 = global_4.member[(_e60 + 14u)];
        let _e123 = global_4.member[(_e60 + 15u)];
        let _e127 = global_4.member[(_e60 + 16u)];
        let _e131 = global_4.member[(_e60 + 17u)];
        let _e135 = global_3.member.member_1;
        let _e139 = global_8.member[((_e45.z + 1u) * _e135)];
        let _e143 = global_8.member[(_e45.z * _e135)];
        let _e145 = (_e143 + (_e54 * 256u));
        let _e146 = (_e145 + 256u);
        phi_548_ = vec3<f32>(0f, 0f, 0f);
        phi_551_ = vec3<f32>(0f, 0f, 0f);
        phi_553_ = (3u * _e145);
        phi_555_ = _e145;
        loop {
            let _e151 = phi_548_;
            let _e153 = phi_551_;
            let _e155 = phi_553_;
            let _e157 = phi_555_;
            local = _e153;
            local_1 = _e153;
            local_2 = _e153;
            local_3 = _e151;
            local_4 = _e151;
            local_5 = _e151;
            if (_e157 < select(_e139, _e146, (_e146 < _e139))) {
                let _e161 = global_9.member[_e157];
                let _e164 = global_3.member.member;
                let _e166 = (_e161 - (_e45.z * _e164));
                let _e167 = (3u * _e166);
                let _e170 = global_5.member[_e167];
                let _e171 = (_e167 + 1u);
                let _e174 = global_5.member[_e171];
                let _e175 = (_e167 + 2u);
                let _e178 = global_5.member[_e175];
                let _e179 = (_e166 * 4u);
                let _e182 = global_6.member[_e179];
                let _e186 = global_6.member[(_e179 + 1u)];
                let _e190 = global_6.member[(_e179 + 2u)];
                let _e194 = global_6.member[(_e179 + 3u)];
                let _e197 = global_7.member[_e167];
                let _e200 = global_7.member[_e171];
                let _e203 = global_7.member[_e175];
                let _e204 = (_e170 - _e99);
                let _e205 = (_e174 - _e103);
                let _e206 = (_e178 - _e107);
                let _e211 = (((_e63 * _e204) + (_e67 * _e205)) + (_e71 * _e206));
                let _e216 = (((_e75 * _e204) + (_e79 * _e205)) + (_e83 * _e206));
                let _e221 = (((_e87 * _e204) + (_e91 * _e205)) + (_e95 * _e206));
                let _e223 = select(1f, _e221, (0.01f < _e221));
                let _e224 = (1f / _e111);
                let _e225 = (1f / _e115);
                let _e228 = ((_e127 * _e224) * 0.15f);
                let _e229 = ((_e131 * _e225) * 0.15f);
                let _e234 = (((_e119 * _e224) * -1f) - _e228);
                let _e235 = (((_e123 * _e225) * -1f) - _e229);
                let _e240 = (((_e127 - _e119) * _e224) + _e228);
                let _e241 = (((_e131 - _e123) * _e225) + _e229);
                let _e242 = (_e211 / _e223);
                let _e244 = select(_e234, _e242, (_e242 > _e234));
                let _e246 = select(_e240, _e244, (_e244 < _e240));
                let _e247 = (_e216 / _e223);
                let _e249 = select(_e235, _e247, (_e247 > _e235));
                let _e251 = select(_e241, _e249, (_e249 < _e241));
                let _e252 = (_e111 / _e223);
                let _e253 = (_e115 / _e223);
                let _e260 = ((_e63 - (_e87 * _e246)) * _e252);
                let _e261 = ((_e67 - (_e91 * _e246)) * _e252);
                let _e262 = ((_e71 - (_e95 * _e246)) * _e252);
                let _e269 = ((_e75 - (_e87 * _e251)) * _e253);
                let _e270 = ((_e79 - (_e91 * _e251)) * _e253);
                let _e271 = ((_e83 - (_e95 * _e251)) * _e253);
                let _e280 = (1f / sqrt(((((_e182 * _e182) + (_e186 * _e186)) + (_e190 * _e190)) + (_e194 * _e194))));
                let _e281 = (_e182 * _e280);
                let _e282 = (_e186 * _e280);
                let _e283 = (_e190 * _e280);
                let _e284 = (_e194 * _e280);
                let _e285 = (_e283 * _e283);
                let _e286 = (_e284 * _e284);
                let _e289 = (1f - (2f * (_e285 + _e286)));
                let _e290 = (_e282 * _e283);
                let _e291 = (_e281 * _e284);
                let _e293 = (2f * (_e290 + _e291));
                let _e294 = (_e282 * _e284);
                let _e295 = (_e281 * _e283);
                let _e297 = (2f * (_e294 - _e295));
                let _e299 = (2f * (_e290 - _e291));
                let _e300 = (_e282 * _e282);
                let _e303 = (1f - (2f * (_e300 + _e286)));
                let _e304 = (_e283 * _e284);
                let _e305 = (_e281 * _e282);
                let _e307 = (2f * (_e304 + _e305));
                let _e309 = (2f * (_e294 + _e295));
                let _e311 = (2f * (_e304 - _e305));
                let _e314 = (1f - (2f * (_e300 + _e285)));
                let _e315 = exp(_e197);
                let _e316 = exp(_e200);
                let _e317 = exp(_e203);
                let _e333 = ((((_e260 * _e289) + (_e261 * _e293)) + (_e262 * _e297)) * _e315);
                let _e334 = ((((_e260 * _e299) + (_e261 * _e303)) + (_e262 * _e307)) * _e316);
                let _e335 = ((((_e260 * _e309) + (_e261 * _e311)) + (_e262 * _e314)) * _e317);
                let _e351 = ((((_e269 * _e289) + (_e270 * _e293)) + (_e271 * _e297)) * _e315);
                let _e352 = ((((_e269 * _e299) + (_e270 * _e303)) + (_e271 * _e307)) * _e316);
                let _e353 = ((((_e269 * _e309) + (_e270 * _e311)) + (_e271 * _e314)) * _e317);
                let _e356 = global_10.member[_e155];
                let _e360 = global_10.member[(_e155 + 1u)];
                let _e368 = global_3.member.member_3;
                let _e373 = (((_e333 * _e333) + (_e334 * _e334)) + (_e335 * _e335));
                let _e383 = (((_e351 * _e351) + (_e352 * _e352)) + (_e353 * _e353));
                let _e386 = ((_e334 * _e353) - (_e335 * _e352));
                let _e389 = ((_e335 * _e351) - (_e333 * _e353));
                let _e392 = ((_e333 * _e352) - (_e334 * _e351));
                let _e403 = (1f / (((((_e386 * _e386) + (_e389 * _e389)) + (_e392 * _e392)) + (_e368 * (_e373 + _e383))) + (_e368 * _e368)));
                let _e419 = (((_e333 * _e368) + ((_e352 * _e392) - (_e353 * _e389))) * _e403);
                let _e420 = (((_e334 * _e368) + ((_e353 * _e386) - (_e351 * _e392))) * _e403);
                let _e421 = (((_e335 * _e368) + ((_e351 * _e389) - (_e352 * _e386))) * _e403);
                let _e437 = (((_e351 * _e368) + ((_e389 * _e335) - (_e392 * _e334))) * _e403);
                let _e438 = (((_e352 * _e368) + ((_e392 * _e333) - (_e386 * _e335))) * _e403);
                let _e439 = (((_e353 * _e368) + ((_e386 * _e334) - (_e389 * _e333))) * _e403);
                let _e440 = (0.5f * _e360.y);
                let _e447 = ((_e419 * _e360.x) + (_e437 * _e440));
                let _e448 = ((_e420 * _e360.x) + (_e438 * _e440));
                let _e449 = ((_e421 * _e360.x) + (_e439 * _e440));
                let _e456 = ((_e419 * _e440) + (_e437 * _e360.z));
                let _e457 = ((_e420 * _e440) + (_e438 * _e360.z));
                let _e458 = ((_e421 * _e440) + (_e439 * _e360.z));
                let _e460 = ((_e383 + _e368) * _e403);
                let _e462 = (-((((_e333 * _e351) + (_e334 * _e352)) + (_e335 * _e353))) * _e403);
                let _e464 = ((_e373 + _e368) * _e403);
                let _e489 = ((((_e447 * _e460) + (_e456 * _e462)) * -2f) * _e315);
                let _e490 = ((((_e448 * _e460) + (_e457 * _e462)) * -2f) * _e316);
                let _e491 = ((((_e449 * _e460) + (_e458 * _e462)) * -2f) * _e317);
                let _e492 = ((((_e447 * _e462) + (_e456 * _e464)) * -2f) * _e315);
                let _e493 = ((((_e448 * _e462) + (_e457 * _e464)) * -2f) * _e316);
                let _e494 = ((((_e449 * _e462) + (_e458 * _e464)) * -2f) * _e317);
                let _e507 = (((_e289 * _e489) + (_e299 * _e490)) + (_e309 * _e491));
                let _e508 = (((_e293 * _e489) + (_e303 * _e490)) + (_e311 * _e491));
                let _e509 = (((_e297 * _e489) + (_e307 * _e490)) + (_e314 * _e491));
                let _e522 = (((_e289 * _e492) + (_e299 * _e493)) + (_e309 * _e494));
                let _e523 = (((_e293 * _e492) + (_e303 * _e493)) + (_e311 * _e494));
                let _e524 = (((_e297 * _e492) + (_e307 * _e493)) + (_e314 * _e494));
                let _e525 = (1f / _e223);
                let _e526 = (_e111 * _e525);
                let _e527 = (_e115 * _e525);
                let _e548 = ((_e526 * _e356.x) + (select(0f, (-(_e526) * (((_e507 * _e87) + (_e508 * _e91)) + (_e509 * _e95))), (_e246 == _e242)) / _e223));
                let _e551 = ((_e527 * _e356.y) + (select(0f, (-(_e527) * (((_e522 * _e87) + (_e523 * _e91)) + (_e524 * _e95))), (_e251 == _e247)) / _e223));
                let _e568 = (-(((_e242 * _e548) + (_e247 * _e551))) - (((((_e507 * _e260) + (_e508 * _e261)) + (_e509 * _e262)) + (((_e522 * _e269) + (_e523 * _e270)) + (_e524 * _e271))) / _e223));
                let _e587 = (((_e508 * _e262) - (_e509 * _e261)) + ((_e523 * _e271) - (_e524 * _e270)));
                let _e588 = (((_e509 * _e260) - (_e507 * _e262)) + ((_e524 * _e269) - (_e522 * _e271)));
                let _e589 = (((_e507 * _e261) - (_e508 * _e260)) + ((_e522 * _e270) - (_e523 * _e269)));
                local_6 = vec3<f32>((_e151.x + _e548), (_e151.y + _e551), (_e151.z + _e568));
                local_7 = vec3<f32>((_e153.x + (((_e216 * _e568) - (_e221 * _e551)) + (((_e63 * _e587) + (_e67 * _e588)) + (_e71 * _e589)))), (_e153.y + (((_e221 * _e548) - (_e211 * _e568)) + (((_e75 * _e587) + (_e79 * _e588)) + (_e83 * _e589)))), (_e153.z + (((_e211 * _e551) - (_e216 * _e548)) + (((_e87 * _e587) + (_e91 * _e588)) + (_e95 * _e589)))));
                local_8 = (_e155 + 3u);
                local_9 = (_e157 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e673 = local_6;
                phi_548_ = _e673;
                let _e676 = local_7;
                phi_551_ = _e676;
                let _e679 = local_8;
                phi_553_ = _e679;
                let _e682 = local_9;
                phi_555_ = _e682;
            }
        }
        let _e635 = (6u * ((_e45.z * _e57) + _e54));
        let _e637 = local;
        global_11.member[_e635] = _e637.x;
        let _e643 = local_1;
        global_11.member[(_e635 + 1u)] = _e643.y;
        let _e649 = local_2;
        global_11.member[(_e635 + 2u)] = _e649.z;
        let _e655 = local_3;
        global_11.member[(_e635 + 3u)] = _e655.x;
        let _e661 = local_4;
        global_11.member[(_e635 + 4u)] = _e661.y;
        let _e667 = local_5;
        global_11.member[(_e635 + 5u)] = _e667.z;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pose_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
