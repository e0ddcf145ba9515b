struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<f32>,
}

struct type_14 {
    member: f32,
    member_1: f32,
}

struct type_18 {
    member: array<u32>,
}

struct type_22 {
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
@group(0) @binding(4) 
var<storage> global_6: type_11;
@group(0) @binding(3) 
var<storage> global_7: type_11;
@group(0) @binding(5) 
var<storage> global_8: type_11;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_22;

fn function_() {
    var phi_400_: u32;
    var phi_418_: type_14;
    var phi_436_: type_14;
    var phi_451_: type_14;
    var phi_494_: array<type_14, 3>;
    var phi_564_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e48 = global_1;
            let _e49 = global_2;
            let _e57 = (((_e48.x + (_e48.y * _e49.x)) * 64u) + _e47.x);
            let _e60 = global_3.member.member;
            if (_e57 < _e60) {
                let _e64 = global_4.member[0u];
                let _e67 = global_4.member[1u];
                let _e70 = global_4.member[2u];
                let _e73 = global_4.member[3u];
                let _e76 = global_4.member[4u];
                let _e79 = global_4.member[5u];
                let _e82 = global_4.member[6u];
                let _e85 = global_4.member[7u];
                let _e88 = global_4.member[8u];
                let _e91 = global_4.member[9u];
                let _e94 = global_4.member[10u];
                let _e97 = global_4.member[11u];
                let _e100 = global_4.member[12u];
                let _e103 = global_4.member[13u];
                let _e106 = global_4.member[14u];
                let _e109 = global_4.member[15u];
                let _e112 = global_4.member[16u];
                let _e115 = global_4.member[17u];
                let _e116 = (_e57 * 3u);
                let _e119 = global_5.member[_e116];
                let _e120 = (_e116 + 1u);
                let _e123 = global_5.member[_e120];
                let _e124 = (_e116 + 2u);
                let _e127 = global_5.member[_e124];
                let _e130 = global_6.member[_e116];
                let _e133 = global_6.member[_e120];
                let _e136 = global_6.member[_e124];
                let _e137 = exp(_e130);
                let _e138 = exp(_e133);
                let _e139 = exp(_e136);
                let _e140 = (_e57 * 4u);
                let _e143 = global_7.member[_e140];
                let _e147 = global_7.member[(_e140 + 1u)];
                let _e151 = global_7.member[(_e140 + 2u)];
                let _e155 = global_7.member[(_e140 + 3u)];
                let _e164 = (1f / sqrt(((((_e143 * _e143) + (_e147 * _e147)) + (_e151 * _e151)) + (_e155 * _e155))));
                let _e165 = (_e143 * _e164);
                let _e166 = (_e147 * _e164);
                let _e167 = (_e151 * _e164);
                let _e168 = (_e155 * _e164);
                let _e169 = (_e167 * _e167);
                let _e170 = (_e168 * _e168);
                let _e174 = (_e166 * _e167);
                let _e175 = (_e165 * _e168);
                let _e178 = (_e166 * _e168);
                let _e179 = (_e165 * _e167);
                let _e184 = (_e166 * _e166);
                let _e188 = (_e167 * _e168);
                let _e189 = (_e165 * _e166);
                let _e201 = global_3.member.member_2;
                let _e202 = (1f / _e201);
                let _e203 = (_e137 * _e202);
                let _e204 = (_e138 * _e202);
                let _e205 = (_e139 * _e202);
                let _e206 = (_e203 * _e204);
                let _e207 = (_e203 * _e205);
                let _e209 = select(_e207, _e206, (_e206 > _e207));
                let _e210 = (_e204 * _e205);
                let _e216 = global_8.member[_e57];
                let _e217 = (_e216 < 0f);
                let _e220 = exp(select(-(_e216), _e216, _e217));
                let _e222 = (1f / (1f + _e220));
                let _e228 = ((2f * _e203) + 0.5f);
                let _e229 = f32(3u);
                let _e231 = select(_e229, _e228, (_e228 < _e229));
                let _e232 = bitcast<f32>(0u);
                let _e233 = bitcast<f32>(1333788671u);
                let _e239 = select(select(u32(_e231), 0u, !((_e231 >= _e232))), 4294967295u, (_e231 > _e233));
                let _e241 = ((2f * _e204) + 0.5f);
                let _e243 = select(_e229, _e241, (_e241 < _e229));
                let _e249 = select(select(u32(_e243), 0u, !((_e243 >= _e232))), 4294967295u, (_e243 > _e233));
                let _e251 = ((2f * _e205) + 0.5f);
                let _e253 = select(_e229, _e251, (_e251 < _e229));
                let _e259 = select(select(u32(_e253), 0u, !((_e253 >= _e232))), 4294967295u, (_e253 > _e233));
                let _e261 = ((2u * _e239) + 1u);
                let _e263 = ((2u * _e249) + 1u);
                let _e264 = (_e261 * _e263);
                phi_400_ = 0u;
                loop {
                    let _e269 = phi_400_;
                    phi_564_ = false;
                    if (_e269 < (_e264 * ((2u * _e259) + 1u))) {
                        let _e271 = (_e261 == 0u);
                        if _e271 {
                            phi_564_ = true;
                            break;
                        }
                        if (_e239 == 0u) {
                            phi_418_ = type_14(0f, 1f);
                        } else {
                            let _e274 = f32(_e239);
                            let _e275 = (2f / _e274);
                            let _e278 = ((f32((_e269 % _e261)) - _e274) * _e275);
                            phi_418_ = type_14(_e278, ((0.3989423f * _e275) * exp(((-0.5f * _e278) * _e278))));
                        }
                        let _e286 = phi_418_;
                        if _e271 {
                            phi_564_ = true;
                            break;
                        }
                        if (_e263 == 0u) {
                            phi_564_ = true;
                            break;
                        }
                        if (_e249 == 0u) {
                            phi_436_ = type_14(0f, 1f);
                        } else {
                            let _e293 = f32(_e249);
                            let _e294 = (2f / _e293);
                            let _e297 = ((f32(((_e269 / _e261) % _e263)) - _e293) * _e294);
                            phi_436_ = type_14(_e297, ((0.3989423f * _e294) * exp(((-0.5f * _e297) * _e297))));
                        }
                        let _e305 = phi_436_;
                        if (_e264 == 0u) {
                            phi_564_ = true;
                            break;
                        }
                        if (_e259 == 0u) {
                            phi_451_ = type_14(0f, 1f);
                        } else {
                            let _e311 = f32(_e259);
                            let _e312 = (2f / _e311);
                            let _e315 = ((f32((_e269 / _e264)) - _e311) * _e312);
                            phi_451_ = type_14(_e315, ((0.3989423f * _e312) * exp(((-0.5f * _e315) * _e315))));
                        }
                        let _e323 = phi_451_;
                        let _e326 = (_e286.member * _e137);
                        let _e333 = (_e305.member * _e138);
                        let _e340 = (_e323.member * _e139);
                        let _e344 = (((_e119 + ((1f - (2f * (_e169 + _e170))) * _e326)) + ((2f * (_e174 - _e175)) * _e333)) + ((2f * (_e178 + _e179)) * _e340));
                        let _e345 = (((_e123 + ((2f * (_e174 + _e175)) * _e326)) + ((1f - (2f * (_e184 + _e170))) * _e333)) + ((2f * (_e188 - _e189)) * _e340));
                        let _e346 = (((_e127 + ((2f * (_e178 - _e179)) * _e326)) + ((2f * (_e188 + _e189)) * _e333)) + ((1f - (2f * (_e184 + _e169))) * _e340));
                        let _e350 = f32(4096u);
                        let _e352 = ((((((4f * 3.1415927f) * select(_e222, (_e220 * _e222), _e217)) * select(_e210, _e209, (_e209 > _e210))) * ((_e286.member_1 * _e305.member_1) * _e323.member_1)) * _e350) + 0.5f);
                        let _e354 = select(_e350, _e352, (_e352 < _e350));
                        let _e361 = (trunc((_e344 * _e73)) * _e64);
                        let _e362 = (trunc((_e345 * _e76)) * _e67);
                        let _e363 = (trunc((_e346 * _e79)) * _e70);
                        let _e364 = (_e361 - _e82);
                        let _e365 = (_e362 - _e85);
                        let _e366 = (_e363 - _e88);
                        let _e373 = (_e364 * _e100);
                        let _e374 = (_e365 * _e103);
                        let _e375 = (_e366 * _e106);
                        let _e385 = ((_e364 * _e109) + (((_e344 - _e361) - _e91) * (_e100 + _e109)));
                        let _e386 = ((_e365 * _e112) + (((_e345 - _e362) - _e94) * (_e103 + _e112)));
                        let _e387 = ((_e366 * _e115) + (((_e346 - _e363) - _e97) * (_e106 + _e115)));
                        let _e391 = (1f / 4096f);
                        let _e392 = (trunc(((_e373 + _e385) * 4096f)) * _e391);
                        let _e394 = ((_e373 - _e392) + _e385);
                        let _e398 = (trunc(((_e374 + _e386) * 4096f)) * _e391);
                        let _e400 = ((_e374 - _e398) + _e386);
                        let _e404 = (trunc(((_e375 + _e387) * 4096f)) * _e391);
                        let _e406 = ((_e375 - _e404) + _e387);
                        let _e413 = global_3.member.member_3;
                        if (_e413 == 0u) {
                            phi_494_ = array<type_14, 3>(type_14(_e392, _e394), type_14(_e398, _e400), type_14(_e404, _e406));
                        } else {
                            let _e417 = ((_e392 - 0.5f) + (_e394 - 0f));
                            let _e420 = ((_e398 - 0.5f) + (_e400 - 0f));
                            let _e423 = ((_e404 - 0.5f) + (_e406 - 0f));
                            let _e426 = select(_e417, -(_e417), (_e417 < 0f));
                            let _e429 = select(_e420, -(_e420), (_e420 < 0f));
                            let _e431 = select(_e429, _e426, (_e426 > _e429));
                            let _e434 = select(_e423, -(_e423), (_e423 < 0f));
                            let _e436 = select(_e434, _e431, (_e431 > _e434));
                            let _e438 = select(0.25f, _e436, (_e436 > 0.25f));
                            let _e443 = select(1f, ((0.5f - (0.0625f / _e438)) / _e438), (0.25f < _e438));
                            let _e444 = (_e417 * _e443);
                            let _e448 = (trunc(((0.5f + _e444) * 4096f)) * _e391);
                            let _e451 = (_e420 * _e443);
                            let _e455 = (trunc(((0.5f + _e451) * 4096f)) * _e391);
                            let _e458 = (_e423 * _e443);
                            let _e462 = (trunc(((0.5f + _e458) * 4096f)) * _e391);
                            phi_494_ = array<type_14, 3>(type_14(_e448, ((0.5f - _e448) + _e444)), type_14(_e455, ((0.5f - _e455) + _e451)), type_14(_e462, ((0.5f - _e462) + _e458)));
                        }
                        let _e470 = phi_494_;
                        let _e473 = global_3.member.member_1;
                        let _e474 = f32(_e473);
                        let _e480 = ((_e470[0].member + _e470[0].member_1) * _e474);
                        let _e486 = ((_e470[1].member + _e470[1].member_1) * _e474);
                        let _e492 = ((_e470[2].member + _e470[2].member_1) * _e474);
                        let _e494 = select(_e486, _e480, (_e480 < _e486));
                        let _e498 = select(_e486, _e480, (_e480 > _e486));
                        if (_e354 >= 1f) {
                            if (select(_e492, _e494, (_e494 < _e492)) >= 0f) {
                                if (select(_e492, _e498, (_e498 > _e492)) < _e474) {
                                    let _e504 = (_e473 + 2u);
                                    let _e535 = select(select(u32(_e354), 0u, !((_e354 >= _e232))), 4294967295u, (_e354 > _e233));
                                    let _e538 = atomicAdd((&global_9.member[(((((((select(select(u32(_e492), 0u, !((_e492 >= _e232))), 4294967295u, (_e492 > _e233)) + 1u) * _e504) + select(select(u32(_e486), 0u, !((_e486 >= _e232))), 4294967295u, (_e486 > _e233))) + 1u) * _e504) + select(select(u32(_e480), 0u, !((_e480 >= _e232))), 4294967295u, (_e480 > _e233))) + 1u)]), _e535);
                                    if ((_e538 + _e535) > 4096u) {
                                        let _e541 = atomicMin((&global_9.member[(((((((select(select(u32(_e492), 0u, !((_e492 >= _e232))), 4294967295u, (_e492 > _e233)) + 1u) * _e504) + select(select(u32(_e486), 0u, !((_e486 >= _e232))), 4294967295u, (_e486 > _e233))) + 1u) * _e504) + select(select(u32(_e480), 0u, !((_e480 >= _e232))), 4294967295u, (_e480 > _e233))) + 1u)]), 4096u);
                                    }
                                }
                            }
                        }
                        local = (_e269 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e547 = local;
                        phi_400_ = _e547;
                    }
                }
                let _e544 = phi_564_;
                if _e544 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn occupancy_add(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
