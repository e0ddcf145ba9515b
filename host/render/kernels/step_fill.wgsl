struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<u32>,
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
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(2) 
var<storage> global_6: type_22;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_22;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_22;

fn function_() {
    var phi_265_: u32;
    var phi_268_: u32;
    var phi_336_: array<type_18, 3>;
    var phi_461_: u32;
    var phi_269_: u32;
    var phi_481_: u32;
    var phi_464_: u32;
    var phi_483_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    let _e30 = global;
    let _e31 = global_1;
    let _e32 = global_2;
    let _e40 = (((_e31.x + (_e31.y * _e32.x)) * 64u) + _e30.x);
    let _e43 = global_3.member.member;
    if (_e40 < _e43) {
        let _e45 = (_e40 * 4u);
        let _e48 = global_4.member[_e45];
        let _e55 = global_4.member[(_e45 + 1u)];
        let _e63 = global_4.member[(_e45 + 2u)];
        let _e70 = global_4.member[(_e45 + 3u)];
        let _e86 = global_5.member[(_e40 + 1u)];
        let _e89 = global_5.member[_e40];
        phi_265_ = 0u;
        phi_268_ = _e89;
        loop {
            let _e91 = phi_265_;
            let _e93 = phi_268_;
            local_4 = _e93;
            if (_e91 < select(select(u32(_e70.w), 0u, !((_e70.w >= bitcast<f32>(0u)))), 4294967295u, (_e70.w > bitcast<f32>(1333788671u)))) {
                if (_e93 < _e86) {
                    let _e97 = (f32(_e91) + 0f);
                    let _e98 = (_e70.w - 1f);
                    let _e103 = global_3.member.member_1;
                    let _e106 = global_3.member.member_2;
                    let _e107 = (select(_e98, _e97, (_e97 < _e98)) + 0.5f);
                    let _e108 = (_e70.w + 0f);
                    let _e110 = ((_e107 + 0f) / _e108);
                    let _e112 = select(0f, _e110, (_e110 > 0f));
                    let _e114 = select(1f, _e112, (_e112 < 1f));
                    let _e118 = (trunc((_e114 * 1024f)) * (1f / 1024f));
                    let _e121 = bitcast<u32>(_e118);
                    let _e133 = select(0f, (((_e107 - (_e118 * _e70.w)) + (0f - bitcast<f32>(select(2143289344u, (_e121 & 2147483648u), ((_e121 & 2147483647u) < 2139095040u))))) / _e108), select(false, (_e114 < 1f), (0f < _e114)));
                    if (_e106 == 0u) {
                        let _e206 = (_e63.x + ((_e118 * _e70.x) + (_e133 * (_e55.x + _e70.x))));
                        let _e208 = (_e48.x + (_e118 * _e55.x));
                        let _e212 = (1f / 4096f);
                        let _e213 = (trunc(((_e208 + _e206) * 4096f)) * _e212);
                        let _e220 = (_e63.y + ((_e118 * _e70.y) + (_e133 * (_e55.y + _e70.y))));
                        let _e222 = (_e48.y + (_e118 * _e55.y));
                        let _e226 = (trunc(((_e222 + _e220) * 4096f)) * _e212);
                        let _e233 = (_e63.z + ((_e118 * _e70.z) + (_e133 * (_e55.z + _e70.z))));
                        let _e235 = (_e48.z + (_e118 * _e55.z));
                        let _e239 = (trunc(((_e235 + _e233) * 4096f)) * _e212);
                        phi_336_ = array<type_18, 3>(type_18(_e213, ((_e208 - _e213) + _e206)), type_18(_e226, ((_e222 - _e226) + _e220)), type_18(_e239, ((_e235 - _e239) + _e233)));
                    } else {
                        let _e137 = (_e63.x + ((_e118 + _e133) * _e63.y));
                        let _e138 = (_e137 < 0f);
                        let _e140 = select(_e137, -(_e137), _e138);
                        let _e145 = (_e55.w / (2f - (select(_e55.w, _e140, (_e140 > _e55.w)) / _e55.w)));
                        let _e149 = select(select(_e145, -(_e145), _e138), _e137, (_e140 <= _e55.w));
                        let _e151 = (_e48.x + (_e149 * _e55.x));
                        let _e153 = (_e48.y + (_e149 * _e55.y));
                        let _e155 = (_e48.z + (_e149 * _e55.z));
                        let _e158 = select(_e151, -(_e151), (_e151 < 0f));
                        let _e161 = select(_e153, -(_e153), (_e153 < 0f));
                        let _e163 = select(_e161, _e158, (_e158 > _e161));
                        let _e166 = select(_e155, -(_e155), (_e155 < 0f));
                        let _e168 = select(_e166, _e163, (_e163 > _e166));
                        let _e170 = select(0.25f, _e168, (_e168 > 0.25f));
                        let _e175 = select(1f, ((0.5f - (0.0625f / _e170)) / _e170), (0.25f < _e170));
                        let _e176 = (_e151 * _e175);
                        let _e180 = (1f / 4096f);
                        let _e181 = (trunc(((0.5f + _e176) * 4096f)) * _e180);
                        let _e184 = (_e153 * _e175);
                        let _e188 = (trunc(((0.5f + _e184) * 4096f)) * _e180);
                        let _e191 = (_e155 * _e175);
                        let _e195 = (trunc(((0.5f + _e191) * 4096f)) * _e180);
                        phi_336_ = array<type_18, 3>(type_18(_e181, ((0.5f - _e181) + _e176)), type_18(_e188, ((0.5f - _e188) + _e184)), type_18(_e195, ((0.5f - _e195) + _e191)));
                    }
                    let _e247 = phi_336_;
                    let _e248 = (_e103 + 2u);
                    let _e249 = f32(_e103);
                    let _e250 = (_e248 * _e248);
                    let _e251 = (_e250 * _e248);
                    let _e264 = (_e247[0].member + _e247[0].member_1);
                    let _e267 = select(false, (_e264 < 1f), (0f < _e264));
                    let _e270 = select(select(0f, 1f, (1f <= _e264)), _e247[0].member, _e267);
                    let _e272 = (_e270 * _e249);
                    let _e273 = bitcast<u32>(_e270);
                    let _e279 = (_e249 + 0f);
                    let _e283 = trunc(_e272);
                    let _e285 = ((_e272 - _e283) + ((bitcast<f32>(select(2143289344u, (_e273 & 2147483648u), ((_e273 & 2147483647u) < 2139095040u))) + (select(0f, _e247[0].member_1, _e267) * _e279)) + 0.5f));
                    let _e287 = select(0f, _e285, (_e285 > 0f));
                    let _e288 = trunc(_e287);
                    let _e289 = (_e287 - _e288);
                    let _e291 = u32((_e283 + _e288));
                    let _e292 = (_e247[1].member + _e247[1].member_1);
                    let _e295 = select(false, (_e292 < 1f), (0f < _e292));
                    let _e298 = select(select(0f, 1f, (1f <= _e292)), _e247[1].member, _e295);
                    let _e300 = (_e298 * _e249);
                    let _e301 = bitcast<u32>(_e298);
                    let _e310 = trunc(_e300);
                    let _e312 = ((_e300 - _e310) + ((bitcast<f32>(select(2143289344u, (_e301 & 2147483648u), ((_e301 & 2147483647u) < 2139095040u))) + (select(0f, _e247[1].member_1, _e295) * _e279)) + 0.5f));
                    let _e314 = select(0f, _e312, (_e312 > 0f));
                    let _e315 = trunc(_e314);
                    let _e316 = (_e314 - _e315);
                    let _e319 = (_e247[2].member + _e247[2].member_1);
                    let _e322 = select(false, (_e319 < 1f), (0f < _e319));
                    let _e325 = select(select(0f, 1f, (1f <= _e319)), _e247[2].member, _e322);
                    let _e327 = (_e325 * _e249);
                    let _e328 = bitcast<u32>(_e325);
                    let _e337 = trunc(_e327);
                    let _e339 = ((_e327 - _e337) + ((bitcast<f32>(select(2143289344u, (_e328 & 2147483648u), ((_e328 & 2147483647u) < 2139095040u))) + (select(0f, _e247[2].member_1, _e322) * _e279)) + 0.5f));
                    let _e341 = select(0f, _e339, (_e339 > 0f));
                    let _e342 = trunc(_e341);
                    let _e343 = (_e341 - _e342);
                    let _e346 = (1f - _e289);
                    let _e347 = (1f - _e316);
                    let _e348 = (1f - _e343);
                    let _e349 = (_e346 * _e347);
                    let _e350 = (_e289 * _e347);
                    let _e351 = (_e346 * _e316);
                    let _e352 = (_e289 * _e316);
                    let _e361 = (u32((_e310 + _e315)) * _e248);
                    let _e362 = (u32((_e337 + _e342)) * _e250);
                    let _e363 = (_e291 + 1u);
                    let _e364 = (_e361 + _e248);
                    let _e365 = (_e362 + _e250);
                    let _e366 = (_e291 + _e361);
                    let _e367 = (_e366 + _e362);
                    let _e371 = (_e363 + _e361);
                    let _e372 = (_e371 + _e362);
                    let _e376 = (_e291 + _e364);
                    let _e377 = (_e376 + _e362);
                    let _e381 = (_e363 + _e364);
                    let _e382 = (_e381 + _e362);
                    let _e386 = (_e366 + _e365);
                    let _e390 = (_e371 + _e365);
                    let _e394 = (_e376 + _e365);
                    let _e398 = (_e381 + _e365);
                    let _e404 = global_6.member[select((_e367 - _e251), _e367, (_e367 < _e251))];
                    let _e408 = global_6.member[select((_e372 - _e251), _e372, (_e372 < _e251))];
                    let _e412 = global_6.member[select((_e377 - _e251), _e377, (_e377 < _e251))];
                    let _e416 = global_6.member[select((_e382 - _e251), _e382, (_e382 < _e251))];
                    let _e420 = global_6.member[select((_e386 - _e251), _e386, (_e386 < _e251))];
                    let _e424 = global_6.member[select((_e390 - _e251), _e390, (_e390 < _e251))];
                    let _e428 = global_6.member[select((_e394 - _e251), _e394, (_e394 < _e251))];
                    let _e432 = global_6.member[select((_e398 - _e251), _e398, (_e398 < _e251))];
                    let _e442 = select(0f, ((((((((_e404 * (_e349 * _e348)) + (_e408 * (_e350 * _e348))) + (_e412 * (_e351 * _e348))) + (_e416 * (_e352 * _e348))) + (_e420 * (_e349 * _e343))) + (_e424 * (_e350 * _e343))) + (_e428 * (_e351 * _e343))) + (_e432 * (_e352 * _e343))), (_e97 < _e70.w));
                    phi_461_ = 0u;
                    phi_269_ = _e93;
                    loop {
                        let _e444 = phi_461_;
                        let _e446 = phi_269_;
                        local_1 = _e446;
                        if (_e444 < 1u) {
                            if (_e442 > 0f) {
                                if (_e446 < _e86) {
                                    global_7.member[_e446] = f32((_e91 + _e444));
                                    global_8.member[_e446] = _e442;
                                    phi_481_ = (_e446 + 1u);
                                } else {
                                    phi_481_ = _e446;
                                }
                                let _e458 = phi_481_;
                                phi_464_ = _e458;
                            } else {
                                phi_464_ = _e446;
                            }
                            let _e460 = phi_464_;
                            local_2 = (_e444 + 1u);
                            local_3 = _e460;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e480 = local_2;
                            phi_461_ = _e480;
                            let _e483 = local_3;
                            phi_269_ = _e483;
                        }
                    }
                    local = (_e91 + 1u);
                    continue;
                } else {
                    break;
                }
            } else {
                break;
            }
            continuing {
                let _e473 = local;
                phi_265_ = _e473;
                let _e476 = local_1;
                phi_268_ = _e476;
            }
        }
        let _e488 = local_4;
        phi_483_ = _e488;
        loop {
            let _e464 = phi_483_;
            if (_e464 < _e86) {
                global_7.member[_e464] = 0f;
                global_8.member[_e464] = 0f;
                local_5 = (_e464 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e490 = local_5;
                phi_483_ = _e490;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn step_fill(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
