struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_18 {
    member: f32,
    member_1: f32,
}

struct type_22 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_22;
@group(0) @binding(5) 
var<storage> global_7: type_22;
@group(0) @binding(1) 
var<storage> global_8: type_10;
@group(0) @binding(4) 
var<storage> global_9: type_22;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_22;

fn function_() {
    var phi_237_: u32;
    var phi_240_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_357_: array<type_18, 3>;
    var phi_500_: f32;
    var local_3: u32;
    var phi_513_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = global;
            let _e36 = global_1;
            let _e37 = global_2;
            let _e45 = (((_e36.x + (_e36.y * _e37.x)) * 64u) + _e35.x);
            let _e48 = global_3.member.member;
            if (_e45 < _e48) {
                let _e52 = global_3.member.member_1;
                let _e53 = (_e52 + _e45);
                let _e56 = global_3.member.member_3;
                phi_237_ = _e56;
                phi_240_ = 0u;
                loop {
                    let _e58 = phi_237_;
                    let _e60 = phi_240_;
                    let _e61 = (_e60 + 1u);
                    local = _e60;
                    local_1 = _e61;
                    local_2 = _e60;
                    local_3 = _e60;
                    if (_e61 < _e58) {
                        let _e64 = ((_e60 + _e58) / 2u);
                        let _e67 = global_4.member[_e64];
                        let _e68 = (_e67 <= _e53);
                        local_4 = select(_e64, _e58, _e68);
                        local_5 = select(_e60, _e64, _e68);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e538 = local_4;
                        phi_237_ = _e538;
                        let _e541 = local_5;
                        phi_240_ = _e541;
                    }
                }
                let _e73 = local;
                let _e75 = global_4.member[_e73];
                let _e78 = local_1;
                let _e80 = global_4.member[_e78];
                let _e85 = ((f32((_e53 - _e75)) + 0f) + 0.5f);
                let _e86 = f32((_e80 - _e75));
                let _e87 = (_e86 + 0f);
                let _e89 = ((_e85 + 0f) / _e87);
                let _e91 = select(0f, _e89, (_e89 > 0f));
                let _e93 = select(1f, _e91, (_e91 < 1f));
                let _e97 = (trunc((_e93 * 1024f)) * (1f / 1024f));
                let _e100 = bitcast<u32>(_e97);
                let _e112 = select(0f, (((_e85 - (_e97 * _e86)) + (0f - bitcast<f32>(select(2143289344u, (_e100 & 2147483648u), ((_e100 & 2147483647u) < 2139095040u))))) / _e87), select(false, (_e93 < 1f), (0f < _e93)));
                let _e115 = global_3.member.member_2;
                let _e118 = global_3.member.member_7;
                let _e121 = local_2;
                let _e122 = (_e121 * 4u);
                let _e125 = global_5.member[_e122];
                if (_e118 == 0u) {
                    let _e214 = global_5.member[(_e122 + 1u)];
                    let _e218 = global_5.member[(_e122 + 2u)];
                    let _e222 = global_5.member[(_e122 + 3u)];
                    let _e239 = (_e218.x + ((_e97 * _e222.x) + (_e112 * (_e214.x + _e222.x))));
                    let _e241 = (_e125.x + (_e97 * _e214.x));
                    let _e245 = (1f / 4096f);
                    let _e246 = (trunc(((_e241 + _e239) * 4096f)) * _e245);
                    let _e253 = (_e218.y + ((_e97 * _e222.y) + (_e112 * (_e214.y + _e222.y))));
                    let _e255 = (_e125.y + (_e97 * _e214.y));
                    let _e259 = (trunc(((_e255 + _e253) * 4096f)) * _e245);
                    let _e266 = (_e218.z + ((_e97 * _e222.z) + (_e112 * (_e214.z + _e222.z))));
                    let _e268 = (_e125.z + (_e97 * _e214.z));
                    let _e272 = (trunc(((_e268 + _e266) * 4096f)) * _e245);
                    phi_357_ = array<type_18, 3>(type_18(_e246, ((_e241 - _e246) + _e239)), type_18(_e259, ((_e255 - _e259) + _e253)), type_18(_e272, ((_e268 - _e272) + _e266)));
                } else {
                    let _e130 = global_5.member[(_e122 + 1u)];
                    let _e134 = global_5.member[(_e122 + 2u)];
                    let _e146 = (_e134.x + ((_e97 + _e112) * _e134.y));
                    let _e147 = (_e146 < 0f);
                    let _e149 = select(_e146, -(_e146), _e147);
                    let _e154 = (_e130.w / (2f - (select(_e130.w, _e149, (_e149 > _e130.w)) / _e130.w)));
                    let _e158 = select(select(_e154, -(_e154), _e147), _e146, (_e149 <= _e130.w));
                    let _e160 = (_e125.x + (_e158 * _e130.x));
                    let _e162 = (_e125.y + (_e158 * _e130.y));
                    let _e164 = (_e125.z + (_e158 * _e130.z));
                    let _e167 = select(_e160, -(_e160), (_e160 < 0f));
                    let _e170 = select(_e162, -(_e162), (_e162 < 0f));
                    let _e172 = select(_e170, _e167, (_e167 > _e170));
                    let _e175 = select(_e164, -(_e164), (_e164 < 0f));
                    let _e177 = select(_e175, _e172, (_e172 > _e175));
                    let _e179 = select(0.25f, _e177, (_e177 > 0.25f));
                    let _e184 = select(1f, ((0.5f - (0.0625f / _e179)) / _e179), (0.25f < _e179));
                    let _e185 = (_e160 * _e184);
                    let _e189 = (1f / 4096f);
                    let _e190 = (trunc(((0.5f + _e185) * 4096f)) * _e189);
                    let _e193 = (_e162 * _e184);
                    let _e197 = (trunc(((0.5f + _e193) * 4096f)) * _e189);
                    let _e200 = (_e164 * _e184);
                    let _e204 = (trunc(((0.5f + _e200) * 4096f)) * _e189);
                    phi_357_ = array<type_18, 3>(type_18(_e190, ((0.5f - _e190) + _e185)), type_18(_e197, ((0.5f - _e197) + _e193)), type_18(_e204, ((0.5f - _e204) + _e200)));
                }
                let _e280 = phi_357_;
                global_6.member[_e45] = _e280[0].member;
                global_6.member[(_e115 + _e45)] = _e280[1].member;
                global_6.member[((2u * _e115) + _e45)] = _e280[2].member;
                global_6.member[((3u * _e115) + _e45)] = _e280[0].member_1;
                global_6.member[((4u * _e115) + _e45)] = _e280[1].member_1;
                global_6.member[((5u * _e115) + _e45)] = _e280[2].member_1;
                let _e316 = global_3.member.member_8;
                if (_e316 == 0u) {
                    phi_500_ = _e125.w;
                } else {
                    let _e318 = (_e316 + 2u);
                    let _e319 = f32(_e316);
                    let _e320 = (_e318 * _e318);
                    let _e321 = (_e320 * _e318);
                    let _e322 = (_e280[0].member + _e280[0].member_1);
                    let _e325 = select(false, (_e322 < 1f), (0f < _e322));
                    let _e328 = select(select(0f, 1f, (1f <= _e322)), _e280[0].member, _e325);
                    let _e330 = (_e328 * _e319);
                    let _e331 = bitcast<u32>(_e328);
                    let _e337 = (_e319 + 0f);
                    let _e341 = trunc(_e330);
                    let _e343 = ((_e330 - _e341) + ((bitcast<f32>(select(2143289344u, (_e331 & 2147483648u), ((_e331 & 2147483647u) < 2139095040u))) + (select(0f, _e280[0].member_1, _e325) * _e337)) + 0.5f));
                    let _e345 = select(0f, _e343, (_e343 > 0f));
                    let _e346 = trunc(_e345);
                    let _e347 = (_e345 - _e346);
                    let _e349 = u32((_e341 + _e346));
                    let _e350 = (_e280[1].member + _e280[1].member_1);
                    let _e353 = select(false, (_e350 < 1f), (0f < _e350));
                    let _e356 = select(select(0f, 1f, (1f <= _e350)), _e280[1].member, _e353);
                    let _e358 = (_e356 * _e319);
                    let _e359 = bitcast<u32>(_e356);
                    let _e368 = trunc(_e358);
                    let _e370 = ((_e358 - _e368) + ((bitcast<f32>(select(2143289344u, (_e359 & 2147483648u), ((_e359 & 2147483647u) < 2139095040u))) + (select(0f, _e280[1].member_1, _e353) * _e337)) + 0.5f));
                    let _e372 = select(0f, _e370, (_e370 > 0f));
                    let _e373 = trunc(_e372);
                    let _e374 = (_e372 - _e373);
                    let _e377 = (_e280[2].member + _e280[2].member_1);
                    let _e380 = select(false, (_e377 < 1f), (0f < _e377));
                    let _e383 = select(select(0f, 1f, (1f <= _e377)), _e280[2].member, _e380);
                    let _e385 = (_e383 * _e319);
                    let _e386 = bitcast<u32>(_e383);
                    let _e395 = trunc(_e385);
                    let _e397 = ((_e385 - _e395) + ((bitcast<f32>(select(2143289344u, (_e386 & 2147483648u), ((_e386 & 2147483647u) < 2139095040u))) + (select(0f, _e280[2].member_1, _e380) * _e337)) + 0.5f));
                    let _e399 = select(0f, _e397, (_e397 > 0f));
                    let _e400 = trunc(_e399);
                    let _e401 = (_e399 - _e400);
                    let _e404 = (1f - _e347);
                    let _e405 = (1f - _e374);
                    let _e406 = (1f - _e401);
                    let _e407 = (_e404 * _e405);
                    let _e408 = (_e347 * _e405);
                    let _e409 = (_e404 * _e374);
                    let _e410 = (_e347 * _e374);
                    let _e419 = (u32((_e368 + _e373)) * _e318);
                    let _e420 = (u32((_e395 + _e400)) * _e320);
                    let _e421 = (_e349 + 1u);
                    let _e422 = (_e419 + _e318);
                    let _e423 = (_e420 + _e320);
                    let _e424 = (_e349 + _e419);
                    let _e425 = (_e424 + _e420);
                    let _e429 = (_e421 + _e419);
                    let _e430 = (_e429 + _e420);
                    let _e434 = (_e349 + _e422);
                    let _e435 = (_e434 + _e420);
                    let _e439 = (_e421 + _e422);
                    let _e440 = (_e439 + _e420);
                    let _e444 = (_e424 + _e423);
                    let _e448 = (_e429 + _e423);
                    let _e452 = (_e434 + _e423);
                    let _e456 = (_e439 + _e423);
                    let _e462 = global_7.member[select((_e425 - _e321), _e425, (_e425 < _e321))];
                    let _e466 = global_7.member[select((_e430 - _e321), _e430, (_e430 < _e321))];
                    let _e470 = global_7.member[select((_e435 - _e321), _e435, (_e435 < _e321))];
                    let _e474 = global_7.member[select((_e440 - _e321), _e440, (_e440 < _e321))];
                    let _e478 = global_7.member[select((_e444 - _e321), _e444, (_e444 < _e321))];
                    let _e482 = global_7.member[select((_e448 - _e321), _e448, (_e448 < _e321))];
                    let _e486 = global_7.member[select((_e452 - _e321), _e452, (_e452 < _e321))];
                    let _e490 = global_7.member[select((_e456 - _e321), _e456, (_e456 < _e321))];
                    phi_500_ = (_e125.w * ((((((((_e462 * (_e407 * _e406)) + (_e466 * (_e408 * _e406))) + (_e470 * (_e409 * _e406))) + (_e474 * (_e410 * _e406))) + (_e478 * (_e407 * _e401))) + (_e482 * (_e408 * _e401))) + (_e486 * (_e409 * _e401))) + (_e490 * (_e410 * _e401))));
                }
                let _e501 = phi_500_;
                global_6.member[((6u * _e115) + _e45)] = _e501;
                let _e508 = local_3;
                let _e510 = global_8.member[_e508];
                let _e513 = global_3.member.member_4;
                if (_e513 == 0u) {
                    break;
                }
                phi_513_ = 0u;
                loop {
                    let _e517 = phi_513_;
                    let _e520 = global_3.member.member_5;
                    if (_e517 < _e520) {
                        let _e526 = global_9.member[(((_e510 % _e513) * _e520) + _e517)];
                        let _e529 = global_3.member.member_6;
                        global_10.member[(((_e529 + _e517) * _e115) + _e45)] = _e526;
                        local_6 = (_e517 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e550 = local_6;
                        phi_513_ = _e550;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_inputs(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
