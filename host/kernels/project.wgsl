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
@group(0) @binding(1) 
var<storage> global_4: type_9;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage> global_6: type_9;
@group(0) @binding(4) 
var<storage> global_7: type_9;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_6;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_28;

fn function_() {
    var phi_414_: f32;
    var phi_419_: f32;
    var phi_424_: f32;
    var phi_429_: f32;
    var phi_434_: f32;
    var phi_439_: f32;
    var phi_448_: f32;
    var phi_454_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_462_: f32;
    var phi_475_: type_25;
    var phi_477_: type_25;
    var phi_478_: bool;
    var phi_483_: type_25;

    let _e47 = global;
    let _e48 = global_1;
    let _e49 = global_2;
    let _e57 = (((_e48.x + (_e48.y * _e49.x)) * 64u) + _e47.x);
    let _e60 = global_3.member.member;
    if (_e57 < _e60) {
        let _e63 = (_e48.z * 18u);
        let _e66 = global_4.member[_e63];
        let _e70 = global_4.member[(_e63 + 1u)];
        let _e74 = global_4.member[(_e63 + 2u)];
        let _e78 = global_4.member[(_e63 + 3u)];
        let _e82 = global_4.member[(_e63 + 4u)];
        let _e86 = global_4.member[(_e63 + 5u)];
        let _e90 = global_4.member[(_e63 + 6u)];
        let _e94 = global_4.member[(_e63 + 7u)];
        let _e98 = global_4.member[(_e63 + 8u)];
        let _e102 = global_4.member[(_e63 + 9u)];
        let _e106 = global_4.member[(_e63 + 10u)];
        let _e110 = global_4.member[(_e63 + 11u)];
        let _e114 = global_4.member[(_e63 + 12u)];
        let _e118 = global_4.member[(_e63 + 13u)];
        let _e122 = global_4.member[(_e63 + 14u)];
        let _e126 = global_4.member[(_e63 + 15u)];
        let _e130 = global_4.member[(_e63 + 16u)];
        let _e134 = global_4.member[(_e63 + 17u)];
        let _e137 = global_3.member.member_1;
        let _e138 = (_e57 * 3u);
        let _e141 = global_5.member[_e138];
        let _e142 = (_e138 + 1u);
        let _e145 = global_5.member[_e142];
        let _e146 = (_e138 + 2u);
        let _e149 = global_5.member[_e146];
        let _e150 = (_e57 * 4u);
        let _e153 = global_6.member[_e150];
        let _e157 = global_6.member[(_e150 + 1u)];
        let _e161 = global_6.member[(_e150 + 2u)];
        let _e165 = global_6.member[(_e150 + 3u)];
        let _e168 = global_7.member[_e138];
        let _e171 = global_7.member[_e142];
        let _e174 = global_7.member[_e146];
        let _e175 = (_e141 - _e102);
        let _e176 = (_e145 - _e106);
        let _e177 = (_e149 - _e110);
        let _e182 = (((_e66 * _e175) + (_e70 * _e176)) + (_e74 * _e177));
        let _e187 = (((_e78 * _e175) + (_e82 * _e176)) + (_e86 * _e177));
        let _e192 = (((_e90 * _e175) + (_e94 * _e176)) + (_e98 * _e177));
        let _e193 = (_e192 > 0.01f);
        let _e194 = select(1f, _e192, _e193);
        let _e197 = (((_e114 * _e182) / _e194) + _e122);
        let _e200 = (((_e118 * _e187) / _e194) + _e126);
        let _e201 = (1f / _e114);
        let _e202 = (1f / _e118);
        let _e205 = ((_e130 * _e201) * 0.15f);
        let _e206 = ((_e134 * _e202) * 0.15f);
        let _e211 = (((_e122 * _e201) * -1f) - _e205);
        let _e212 = (((_e126 * _e202) * -1f) - _e206);
        let _e217 = (((_e130 - _e122) * _e201) + _e205);
        let _e218 = (((_e134 - _e126) * _e202) + _e206);
        let _e219 = (_e182 / _e194);
        let _e221 = select(_e211, _e219, (_e219 > _e211));
        let _e223 = select(_e217, _e221, (_e221 < _e217));
        let _e224 = (_e187 / _e194);
        let _e226 = select(_e212, _e224, (_e224 > _e212));
        let _e228 = select(_e218, _e226, (_e226 < _e218));
        let _e229 = (_e114 / _e194);
        let _e230 = (_e118 / _e194);
        let _e237 = ((_e66 - (_e90 * _e223)) * _e229);
        let _e238 = ((_e70 - (_e94 * _e223)) * _e229);
        let _e239 = ((_e74 - (_e98 * _e223)) * _e229);
        let _e246 = ((_e78 - (_e90 * _e228)) * _e230);
        let _e247 = ((_e82 - (_e94 * _e228)) * _e230);
        let _e248 = ((_e86 - (_e98 * _e228)) * _e230);
        let _e257 = (1f / sqrt(((((_e153 * _e153) + (_e157 * _e157)) + (_e161 * _e161)) + (_e165 * _e165))));
        let _e258 = (_e153 * _e257);
        let _e259 = (_e157 * _e257);
        let _e260 = (_e161 * _e257);
        let _e261 = (_e165 * _e257);
        let _e262 = (_e260 * _e260);
        let _e263 = (_e261 * _e261);
        let _e266 = (1f - (2f * (_e262 + _e263)));
        let _e267 = (_e259 * _e260);
        let _e268 = (_e258 * _e261);
        let _e270 = (2f * (_e267 + _e268));
        let _e271 = (_e259 * _e261);
        let _e272 = (_e258 * _e260);
        let _e274 = (2f * (_e271 - _e272));
        let _e276 = (2f * (_e267 - _e268));
        let _e277 = (_e259 * _e259);
        let _e280 = (1f - (2f * (_e277 + _e263)));
        let _e281 = (_e260 * _e261);
        let _e282 = (_e258 * _e259);
        let _e284 = (2f * (_e281 + _e282));
        let _e286 = (2f * (_e271 + _e272));
        let _e288 = (2f * (_e281 - _e282));
        let _e291 = (1f - (2f * (_e277 + _e262)));
        let _e292 = exp(_e168);
        let _e293 = exp(_e171);
        let _e294 = exp(_e174);
        let _e310 = ((((_e237 * _e266) + (_e238 * _e270)) + (_e239 * _e274)) * _e292);
        let _e311 = ((((_e237 * _e276) + (_e238 * _e280)) + (_e239 * _e284)) * _e293);
        let _e312 = ((((_e237 * _e286) + (_e238 * _e288)) + (_e239 * _e291)) * _e294);
        let _e328 = ((((_e246 * _e266) + (_e247 * _e270)) + (_e248 * _e274)) * _e292);
        let _e329 = ((((_e246 * _e276) + (_e247 * _e280)) + (_e248 * _e284)) * _e293);
        let _e330 = ((((_e246 * _e286) + (_e247 * _e288)) + (_e248 * _e291)) * _e294);
        let _e335 = (((_e310 * _e310) + (_e311 * _e311)) + (_e312 * _e312));
        let _e340 = (((_e310 * _e328) + (_e311 * _e329)) + (_e312 * _e330));
        let _e345 = (((_e328 * _e328) + (_e329 * _e329)) + (_e330 * _e330));
        let _e346 = (_e335 + _e137);
        let _e347 = (_e345 + _e137);
        let _e350 = ((_e311 * _e330) - (_e312 * _e329));
        let _e353 = ((_e312 * _e328) - (_e310 * _e330));
        let _e356 = ((_e310 * _e329) - (_e311 * _e328));
        let _e366 = (((((_e350 * _e350) + (_e353 * _e353)) + (_e356 * _e356)) + (_e137 * (_e335 + _e345))) + (_e137 * _e137));
        let _e368 = (1f / _e366);
        let _e369 = (_e347 * _e368);
        let _e370 = (-(_e340) * _e368);
        let _e371 = (_e346 * _e368);
        let _e374 = (0.5f * (_e346 - _e347));
        let _e383 = sqrt((11.082527f * ((0.5f * (_e346 + _e347)) + sqrt(((_e374 * _e374) + (_e340 * _e340))))));
        if (_e369 < 0f) {
            phi_414_ = -(_e369);
        } else {
            phi_414_ = _e369;
        }
        let _e395 = phi_414_;
        if (_e370 < 0f) {
            phi_419_ = -(_e370);
        } else {
            phi_419_ = _e370;
        }
        let _e399 = phi_419_;
        if (_e371 < 0f) {
            phi_424_ = -(_e371);
        } else {
            phi_424_ = _e371;
        }
        let _e404 = phi_424_;
        if (_e197 < 0f) {
            phi_429_ = -(_e197);
        } else {
            phi_429_ = _e197;
        }
        let _e409 = phi_429_;
        if (_e200 < 0f) {
            phi_434_ = -(_e200);
        } else {
            phi_434_ = _e200;
        }
        let _e414 = phi_434_;
        let _e416 = (((((_e395 + _e399) + _e404) + _e409) + _e414) + _e383);
        let _e417 = (_e192 < 0f);
        if _e417 {
            phi_439_ = -(_e192);
        } else {
            phi_439_ = _e192;
        }
        let _e420 = phi_439_;
        if (_e420 <= 0x1.fffffep+127f) {
            if (_e416 < 0f) {
                phi_448_ = -(_e416);
            } else {
                phi_448_ = _e416;
            }
            let _e425 = phi_448_;
            let _e426 = (_e425 <= 0x1.fffffep+127f);
            if _e426 {
                phi_454_ = (_e366 > 0f);
            } else {
                phi_454_ = bool();
            }
            let _e429 = phi_454_;
            phi_456_ = _e429;
            phi_457_ = select(true, false, _e426);
        } else {
            phi_456_ = bool();
            phi_457_ = true;
        }
        let _e432 = phi_456_;
        let _e434 = phi_457_;
        let _e435 = select(_e432, false, _e434);
        if _e417 {
            phi_462_ = -(_e192);
        } else {
            phi_462_ = _e192;
        }
        let _e438 = phi_462_;
        if _e193 {
            if _e435 {
                phi_475_ = type_25(vec2<f32>(_e197, _e200), vec2<f32>(((sqrt((11.082527f * _e346)) * 1.001f) + 0.01f), ((sqrt((11.082527f * _e347)) * 1.001f) + 0.01f)), vec3<f32>(_e369, _e370, _e371), _e383);
            } else {
                phi_475_ = type_25();
            }
            let _e446 = phi_475_;
            phi_477_ = _e446;
            phi_478_ = select(true, false, _e435);
        } else {
            phi_477_ = type_25();
            phi_478_ = true;
        }
        let _e449 = phi_477_;
        let _e451 = phi_478_;
        if _e451 {
            phi_483_ = type_25(vec2<f32>(0f, 0f), vec2<f32>(0f, 0f), vec3<f32>(0f, 0f, 0f), select(-1f, -2f, select(true, _e193, (_e438 <= 0x1.fffffep+127f))));
        } else {
            phi_483_ = _e449;
        }
        let _e454 = phi_483_;
        let _e457 = (2u * ((_e48.z * _e60) + _e57));
        global_8.member[_e457] = vec4<f32>(_e454.member.x, _e454.member.y, _e454.member_3, _e454.member_1.x);
        global_8.member[(_e457 + 1u)] = vec4<f32>(_e454.member_2.x, _e454.member_2.y, _e454.member_2.z, _e454.member_1.y);
        if (_e454.member_3 == -2f) {
            let _e481 = atomicAdd((&global_9.member[0u]), 1u);
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
