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
@group(0) @binding(1) 
var<storage> global_6: type_10;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_22;
@group(0) @binding(5) 
var<storage> global_8: type_22;
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
    var local_3: u32;
    var phi_352_: array<type_18, 3>;
    var phi_497_: f32;
    var phi_502_: u32;
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
                        let _e522 = local_4;
                        phi_237_ = _e522;
                        let _e525 = local_5;
                        phi_240_ = _e525;
                    }
                }
                let _e73 = local;
                let _e75 = global_4.member[_e73];
                let _e78 = local_1;
                let _e80 = global_4.member[_e78];
                let _e85 = f32((_e80 - _e75));
                let _e87 = local_2;
                let _e88 = (_e87 * 4u);
                let _e91 = global_5.member[_e88];
                let _e99 = global_5.member[(_e88 + 1u)];
                let _e107 = global_5.member[(_e88 + 2u)];
                let _e114 = global_5.member[(_e88 + 3u)];
                let _e120 = local_3;
                let _e122 = global_6.member[_e120];
                let _e125 = global_3.member.member_4;
                if (_e125 == 0u) {
                    break;
                }
                let _e130 = global_3.member.member_5;
                let _e132 = ((f32((_e53 - _e75)) + 0f) + 0.5f);
                let _e133 = (_e85 + 0f);
                let _e135 = ((_e132 + 0f) / _e133);
                let _e137 = select(0f, _e135, (_e135 > 0f));
                let _e139 = select(1f, _e137, (_e137 < 1f));
                let _e143 = (trunc((_e139 * 1024f)) * (1f / 1024f));
                let _e146 = bitcast<u32>(_e143);
                let _e158 = select(0f, (((_e132 - (_e143 * _e85)) + (0f - bitcast<f32>(select(2143289344u, (_e146 & 2147483648u), ((_e146 & 2147483647u) < 2139095040u))))) / _e133), select(false, (_e139 < 1f), (0f < _e139)));
                let _e161 = global_3.member.member_7;
                if (_e161 == 0u) {
                    let _e234 = (_e107.x + ((_e143 * _e114.x) + (_e158 * (_e99.x + _e114.x))));
                    let _e236 = (_e91.x + (_e143 * _e99.x));
                    let _e240 = (1f / 4096f);
                    let _e241 = (trunc(((_e236 + _e234) * 4096f)) * _e240);
                    let _e248 = (_e107.y + ((_e143 * _e114.y) + (_e158 * (_e99.y + _e114.y))));
                    let _e250 = (_e91.y + (_e143 * _e99.y));
                    let _e254 = (trunc(((_e250 + _e248) * 4096f)) * _e240);
                    let _e261 = (_e107.z + ((_e143 * _e114.z) + (_e158 * (_e99.z + _e114.z))));
                    let _e263 = (_e91.z + (_e143 * _e99.z));
                    let _e267 = (trunc(((_e263 + _e261) * 4096f)) * _e240);
                    phi_352_ = array<type_18, 3>(type_18(_e241, ((_e236 - _e241) + _e234)), type_18(_e254, ((_e250 - _e254) + _e248)), type_18(_e267, ((_e263 - _e267) + _e261)));
                } else {
                    let _e165 = (_e107.x + ((_e143 + _e158) * _e107.y));
                    let _e166 = (_e165 < 0f);
                    let _e168 = select(_e165, -(_e165), _e166);
                    let _e173 = (_e99.w / (2f - (select(_e99.w, _e168, (_e168 > _e99.w)) / _e99.w)));
                    let _e177 = select(select(_e173, -(_e173), _e166), _e165, (_e168 <= _e99.w));
                    let _e179 = (_e91.x + (_e177 * _e99.x));
                    let _e181 = (_e91.y + (_e177 * _e99.y));
                    let _e183 = (_e91.z + (_e177 * _e99.z));
                    let _e186 = select(_e179, -(_e179), (_e179 < 0f));
                    let _e189 = select(_e181, -(_e181), (_e181 < 0f));
                    let _e191 = select(_e189, _e186, (_e186 > _e189));
                    let _e194 = select(_e183, -(_e183), (_e183 < 0f));
                    let _e196 = select(_e194, _e191, (_e191 > _e194));
                    let _e198 = select(0.25f, _e196, (_e196 > 0.25f));
                    let _e203 = select(1f, ((0.5f - (0.0625f / _e198)) / _e198), (0.25f < _e198));
                    let _e204 = (_e179 * _e203);
                    let _e208 = (1f / 4096f);
                    let _e209 = (trunc(((0.5f + _e204) * 4096f)) * _e208);
                    let _e212 = (_e181 * _e203);
                    let _e216 = (trunc(((0.5f + _e212) * 4096f)) * _e208);
                    let _e219 = (_e183 * _e203);
                    let _e223 = (trunc(((0.5f + _e219) * 4096f)) * _e208);
                    phi_352_ = array<type_18, 3>(type_18(_e209, ((0.5f - _e209) + _e204)), type_18(_e216, ((0.5f - _e216) + _e212)), type_18(_e223, ((0.5f - _e223) + _e219)));
                }
                let _e275 = phi_352_;
                let _e278 = global_3.member.member_2;
                global_7.member[_e45] = _e275[0].member;
                global_7.member[(_e278 + _e45)] = _e275[1].member;
                global_7.member[((2u * _e278) + _e45)] = _e275[2].member;
                global_7.member[((3u * _e278) + _e45)] = _e275[0].member_1;
                global_7.member[((4u * _e278) + _e45)] = _e275[1].member_1;
                global_7.member[((5u * _e278) + _e45)] = _e275[2].member_1;
                let _e314 = global_3.member.member_8;
                if (_e314 == 0u) {
                    phi_497_ = _e91.w;
                } else {
                    let _e316 = (_e314 + 2u);
                    let _e317 = f32(_e314);
                    let _e318 = (_e316 * _e316);
                    let _e319 = (_e318 * _e316);
                    let _e320 = (_e275[0].member + _e275[0].member_1);
                    let _e323 = select(false, (_e320 < 1f), (0f < _e320));
                    let _e326 = select(select(0f, 1f, (1f <= _e320)), _e275[0].member, _e323);
                    let _e328 = (_e326 * _e317);
                    let _e329 = bitcast<u32>(_e326);
                    let _e335 = (_e317 + 0f);
                    let _e339 = trunc(_e328);
                    let _e341 = ((_e328 - _e339) + ((bitcast<f32>(select(2143289344u, (_e329 & 2147483648u), ((_e329 & 2147483647u) < 2139095040u))) + (select(0f, _e275[0].member_1, _e323) * _e335)) + 0.5f));
                    let _e343 = select(0f, _e341, (_e341 > 0f));
                    let _e344 = trunc(_e343);
                    let _e345 = (_e343 - _e344);
                    let _e347 = u32((_e339 + _e344));
                    let _e348 = (_e275[1].member + _e275[1].member_1);
                    let _e351 = select(false, (_e348 < 1f), (0f < _e348));
                    let _e354 = select(select(0f, 1f, (1f <= _e348)), _e275[1].member, _e351);
                    let _e356 = (_e354 * _e317);
                    let _e357 = bitcast<u32>(_e354);
                    let _e366 = trunc(_e356);
                    let _e368 = ((_e356 - _e366) + ((bitcast<f32>(select(2143289344u, (_e357 & 2147483648u), ((_e357 & 2147483647u) < 2139095040u))) + (select(0f, _e275[1].member_1, _e351) * _e335)) + 0.5f));
                    let _e370 = select(0f, _e368, (_e368 > 0f));
                    let _e371 = trunc(_e370);
                    let _e372 = (_e370 - _e371);
                    let _e375 = (_e275[2].member + _e275[2].member_1);
                    let _e378 = select(false, (_e375 < 1f), (0f < _e375));
                    let _e381 = select(select(0f, 1f, (1f <= _e375)), _e275[2].member, _e378);
                    let _e383 = (_e381 * _e317);
                    let _e384 = bitcast<u32>(_e381);
                    let _e393 = trunc(_e383);
                    let _e395 = ((_e383 - _e393) + ((bitcast<f32>(select(2143289344u, (_e384 & 2147483648u), ((_e384 & 2147483647u) < 2139095040u))) + (select(0f, _e275[2].member_1, _e378) * _e335)) + 0.5f));
                    let _e397 = select(0f, _e395, (_e395 > 0f));
                    let _e398 = trunc(_e397);
                    let _e399 = (_e397 - _e398);
                    let _e402 = (1f - _e345);
                    let _e403 = (1f - _e372);
                    let _e404 = (1f - _e399);
                    let _e405 = (_e402 * _e403);
                    let _e406 = (_e345 * _e403);
                    let _e407 = (_e402 * _e372);
                    let _e408 = (_e345 * _e372);
                    let _e417 = (u32((_e366 + _e371)) * _e316);
                    let _e418 = (u32((_e393 + _e398)) * _e318);
                    let _e419 = (_e347 + 1u);
                    let _e420 = (_e417 + _e316);
                    let _e421 = (_e418 + _e318);
                    let _e422 = (_e347 + _e417);
                    let _e423 = (_e422 + _e418);
                    let _e427 = (_e419 + _e417);
                    let _e428 = (_e427 + _e418);
                    let _e432 = (_e347 + _e420);
                    let _e433 = (_e432 + _e418);
                    let _e437 = (_e419 + _e420);
                    let _e438 = (_e437 + _e418);
                    let _e442 = (_e422 + _e421);
                    let _e446 = (_e427 + _e421);
                    let _e450 = (_e432 + _e421);
                    let _e454 = (_e437 + _e421);
                    let _e460 = global_8.member[select((_e423 - _e319), _e423, (_e423 < _e319))];
                    let _e464 = global_8.member[select((_e428 - _e319), _e428, (_e428 < _e319))];
                    let _e468 = global_8.member[select((_e433 - _e319), _e433, (_e433 < _e319))];
                    let _e472 = global_8.member[select((_e438 - _e319), _e438, (_e438 < _e319))];
                    let _e476 = global_8.member[select((_e442 - _e319), _e442, (_e442 < _e319))];
                    let _e480 = global_8.member[select((_e446 - _e319), _e446, (_e446 < _e319))];
                    let _e484 = global_8.member[select((_e450 - _e319), _e450, (_e450 < _e319))];
                    let _e488 = global_8.member[select((_e454 - _e319), _e454, (_e454 < _e319))];
                    phi_497_ = (_e91.w * ((((((((_e460 * (_e405 * _e404)) + (_e464 * (_e406 * _e404))) + (_e468 * (_e407 * _e404))) + (_e472 * (_e408 * _e404))) + (_e476 * (_e405 * _e399))) + (_e480 * (_e406 * _e399))) + (_e484 * (_e407 * _e399))) + (_e488 * (_e408 * _e399))));
                }
                let _e499 = phi_497_;
                global_7.member[((6u * _e278) + _e45)] = _e499;
                phi_502_ = 0u;
                loop {
                    let _e505 = phi_502_;
                    if (_e505 < _e130) {
                        let _e510 = global_9.member[(((_e122 % _e125) * _e130) + _e505)];
                        let _e513 = global_3.member.member_6;
                        global_10.member[(((_e513 + _e505) * _e278) + _e45)] = _e510;
                        local_6 = (_e505 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e534 = local_6;
                        phi_502_ = _e534;
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
