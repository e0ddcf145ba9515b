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
    var phi_547_: vec3<f32>;
    var phi_550_: vec3<f32>;
    var phi_552_: u32;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var local_3: vec3<f32>;
    var local_4: vec3<f32>;
    var local_5: vec3<f32>;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: u32;

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
        phi_547_ = vec3<f32>(0f, 0f, 0f);
        phi_550_ = vec3<f32>(0f, 0f, 0f);
        phi_552_ = _e145;
        loop {
            let _e150 = phi_547_;
            let _e152 = phi_550_;
            let _e154 = phi_552_;
            local = _e152;
            local_1 = _e152;
            local_2 = _e152;
            local_3 = _e150;
            local_4 = _e150;
            local_5 = _e150;
            if (_e154 < select(_e139, _e146, (_e146 < _e139))) {
                let _e158 = global_9.member[_e154];
                let _e161 = global_3.member.member;
                let _e163 = (_e158 - (_e45.z * _e161));
                let _e164 = (3u * _e163);
                let _e167 = global_5.member[_e164];
                let _e168 = (_e164 + 1u);
                let _e171 = global_5.member[_e168];
                let _e172 = (_e164 + 2u);
                let _e175 = global_5.member[_e172];
                let _e176 = (_e163 * 4u);
                let _e179 = global_6.member[_e176];
                let _e183 = global_6.member[(_e176 + 1u)];
                let _e187 = global_6.member[(_e176 + 2u)];
                let _e191 = global_6.member[(_e176 + 3u)];
                let _e194 = global_7.member[_e164];
                let _e197 = global_7.member[_e168];
                let _e200 = global_7.member[_e172];
                let _e201 = (_e167 - _e99);
                let _e202 = (_e171 - _e103);
                let _e203 = (_e175 - _e107);
                let _e208 = (((_e63 * _e201) + (_e67 * _e202)) + (_e71 * _e203));
                let _e213 = (((_e75 * _e201) + (_e79 * _e202)) + (_e83 * _e203));
                let _e218 = (((_e87 * _e201) + (_e91 * _e202)) + (_e95 * _e203));
                let _e220 = select(1f, _e218, (0.01f < _e218));
                let _e221 = (1f / _e111);
                let _e222 = (1f / _e115);
                let _e225 = ((_e127 * _e221) * 0.15f);
                let _e226 = ((_e131 * _e222) * 0.15f);
                let _e231 = (((_e119 * _e221) * -1f) - _e225);
                let _e232 = (((_e123 * _e222) * -1f) - _e226);
                let _e237 = (((_e127 - _e119) * _e221) + _e225);
                let _e238 = (((_e131 - _e123) * _e222) + _e226);
                let _e239 = (_e208 / _e220);
                let _e241 = select(_e231, _e239, (_e239 > _e231));
                let _e243 = select(_e237, _e241, (_e241 < _e237));
                let _e244 = (_e213 / _e220);
                let _e246 = select(_e232, _e244, (_e244 > _e232));
                let _e248 = select(_e238, _e246, (_e246 < _e238));
                let _e249 = (_e111 / _e220);
                let _e250 = (_e115 / _e220);
                let _e257 = ((_e63 - (_e87 * _e243)) * _e249);
                let _e258 = ((_e67 - (_e91 * _e243)) * _e249);
                let _e259 = ((_e71 - (_e95 * _e243)) * _e249);
                let _e266 = ((_e75 - (_e87 * _e248)) * _e250);
                let _e267 = ((_e79 - (_e91 * _e248)) * _e250);
                let _e268 = ((_e83 - (_e95 * _e248)) * _e250);
                let _e277 = (1f / sqrt(((((_e179 * _e179) + (_e183 * _e183)) + (_e187 * _e187)) + (_e191 * _e191))));
                let _e278 = (_e179 * _e277);
                let _e279 = (_e183 * _e277);
                let _e280 = (_e187 * _e277);
                let _e281 = (_e191 * _e277);
                let _e282 = (_e280 * _e280);
                let _e283 = (_e281 * _e281);
                let _e286 = (1f - (2f * (_e282 + _e283)));
                let _e287 = (_e279 * _e280);
                let _e288 = (_e278 * _e281);
                let _e290 = (2f * (_e287 + _e288));
                let _e291 = (_e279 * _e281);
                let _e292 = (_e278 * _e280);
                let _e294 = (2f * (_e291 - _e292));
                let _e296 = (2f * (_e287 - _e288));
                let _e297 = (_e279 * _e279);
                let _e300 = (1f - (2f * (_e297 + _e283)));
                let _e301 = (_e280 * _e281);
                let _e302 = (_e278 * _e279);
                let _e304 = (2f * (_e301 + _e302));
                let _e306 = (2f * (_e291 + _e292));
                let _e308 = (2f * (_e301 - _e302));
                let _e311 = (1f - (2f * (_e297 + _e282)));
                let _e312 = exp(_e194);
                let _e313 = exp(_e197);
                let _e314 = exp(_e200);
                let _e330 = ((((_e257 * _e286) + (_e258 * _e290)) + (_e259 * _e294)) * _e312);
                let _e331 = ((((_e257 * _e296) + (_e258 * _e300)) + (_e259 * _e304)) * _e313);
                let _e332 = ((((_e257 * _e306) + (_e258 * _e308)) + (_e259 * _e311)) * _e314);
                let _e348 = ((((_e266 * _e286) + (_e267 * _e290)) + (_e268 * _e294)) * _e312);
                let _e349 = ((((_e266 * _e296) + (_e267 * _e300)) + (_e268 * _e304)) * _e313);
                let _e350 = ((((_e266 * _e306) + (_e267 * _e308)) + (_e268 * _e311)) * _e314);
                let _e351 = (3u * _e154);
                let _e354 = global_10.member[_e351];
                let _e358 = global_10.member[(_e351 + 1u)];
                let _e366 = global_3.member.member_3;
                let _e371 = (((_e330 * _e330) + (_e331 * _e331)) + (_e332 * _e332));
                let _e381 = (((_e348 * _e348) + (_e349 * _e349)) + (_e350 * _e350));
                let _e384 = ((_e331 * _e350) - (_e332 * _e349));
                let _e387 = ((_e332 * _e348) - (_e330 * _e350));
                let _e390 = ((_e330 * _e349) - (_e331 * _e348));
                let _e401 = (1f / (((((_e384 * _e384) + (_e387 * _e387)) + (_e390 * _e390)) + (_e366 * (_e371 + _e381))) + (_e366 * _e366)));
                let _e417 = (((_e330 * _e366) + ((_e349 * _e390) - (_e350 * _e387))) * _e401);
                let _e418 = (((_e331 * _e366) + ((_e350 * _e384) - (_e348 * _e390))) * _e401);
                let _e419 = (((_e332 * _e366) + ((_e348 * _e387) - (_e349 * _e384))) * _e401);
                let _e435 = (((_e348 * _e366) + ((_e387 * _e332) - (_e390 * _e331))) * _e401);
                let _e436 = (((_e349 * _e366) + ((_e390 * _e330) - (_e384 * _e332))) * _e401);
                let _e437 = (((_e350 * _e366) + ((_e384 * _e331) - (_e387 * _e330))) * _e401);
                let _e438 = (0.5f * _e358.y);
                let _e445 = ((_e417 * _e358.x) + (_e435 * _e438));
                let _e446 = ((_e418 * _e358.x) + (_e436 * _e438));
                let _e447 = ((_e419 * _e358.x) + (_e437 * _e438));
                let _e454 = ((_e417 * _e438) + (_e435 * _e358.z));
                let _e455 = ((_e418 * _e438) + (_e436 * _e358.z));
                let _e456 = ((_e419 * _e438) + (_e437 * _e358.z));
                let _e458 = ((_e381 + _e366) * _e401);
                let _e460 = (-((((_e330 * _e348) + (_e331 * _e349)) + (_e332 * _e350))) * _e401);
                let _e462 = ((_e371 + _e366) * _e401);
                let _e487 = ((((_e445 * _e458) + (_e454 * _e460)) * -2f) * _e312);
                let _e488 = ((((_e446 * _e458) + (_e455 * _e460)) * -2f) * _e313);
                let _e489 = ((((_e447 * _e458) + (_e456 * _e460)) * -2f) * _e314);
                let _e490 = ((((_e445 * _e460) + (_e454 * _e462)) * -2f) * _e312);
                let _e491 = ((((_e446 * _e460) + (_e455 * _e462)) * -2f) * _e313);
                let _e492 = ((((_e447 * _e460) + (_e456 * _e462)) * -2f) * _e314);
                let _e505 = (((_e286 * _e487) + (_e296 * _e488)) + (_e306 * _e489));
                let _e506 = (((_e290 * _e487) + (_e300 * _e488)) + (_e308 * _e489));
                let _e507 = (((_e294 * _e487) + (_e304 * _e488)) + (_e311 * _e489));
                let _e520 = (((_e286 * _e490) + (_e296 * _e491)) + (_e306 * _e492));
                let _e521 = (((_e290 * _e490) + (_e300 * _e491)) + (_e308 * _e492));
                let _e522 = (((_e294 * _e490) + (_e304 * _e491)) + (_e311 * _e492));
                let _e523 = (1f / _e220);
                let _e524 = (_e111 * _e523);
                let _e525 = (_e115 * _e523);
                let _e546 = ((_e524 * _e354.x) + (select(0f, (-(_e524) * (((_e505 * _e87) + (_e506 * _e91)) + (_e507 * _e95))), (_e243 == _e239)) / _e220));
                let _e549 = ((_e525 * _e354.y) + (select(0f, (-(_e525) * (((_e520 * _e87) + (_e521 * _e91)) + (_e522 * _e95))), (_e248 == _e244)) / _e220));
                let _e566 = (-(((_e239 * _e546) + (_e244 * _e549))) - (((((_e505 * _e257) + (_e506 * _e258)) + (_e507 * _e259)) + (((_e520 * _e266) + (_e521 * _e267)) + (_e522 * _e268))) / _e220));
                let _e585 = (((_e506 * _e259) - (_e507 * _e258)) + ((_e521 * _e268) - (_e522 * _e267)));
                let _e586 = (((_e507 * _e257) - (_e505 * _e259)) + ((_e522 * _e266) - (_e520 * _e268)));
                let _e587 = (((_e505 * _e258) - (_e506 * _e257)) + ((_e520 * _e267) - (_e521 * _e266)));
                local_6 = vec3<f32>((_e150.x + _e546), (_e150.y + _e549), (_e150.z + _e566));
                local_7 = vec3<f32>((_e152.x + (((_e213 * _e566) - (_e218 * _e549)) + (((_e63 * _e585) + (_e67 * _e586)) + (_e71 * _e587)))), (_e152.y + (((_e218 * _e546) - (_e208 * _e566)) + (((_e75 * _e585) + (_e79 * _e586)) + (_e83 * _e587)))), (_e152.z + (((_e208 * _e549) - (_e213 * _e546)) + (((_e87 * _e585) + (_e91 * _e586)) + (_e95 * _e587)))));
                local_8 = (_e154 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e670 = local_6;
                phi_547_ = _e670;
                let _e673 = local_7;
                phi_550_ = _e673;
                let _e676 = local_8;
                phi_552_ = _e676;
            }
        }
        let _e632 = (6u * ((_e45.z * _e57) + _e54));
        let _e634 = local;
        global_11.member[_e632] = _e634.x;
        let _e640 = local_1;
        global_11.member[(_e632 + 1u)] = _e640.y;
        let _e646 = local_2;
        global_11.member[(_e632 + 2u)] = _e646.z;
        let _e652 = local_3;
        global_11.member[(_e632 + 3u)] = _e652.x;
        let _e658 = local_4;
        global_11.member[(_e632 + 4u)] = _e658.y;
        let _e664 = local_5;
        global_11.member[(_e632 + 5u)] = _e664.z;
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
