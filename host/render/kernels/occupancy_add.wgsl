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
    var phi_412_: u32;
    var phi_437_: type_14;
    var phi_454_: type_14;
    var phi_471_: type_14;
    var phi_513_: array<type_14, 3>;
    var phi_555_: u32;
    var local: u32;
    var local_1: u32;

    let _e52 = global;
    let _e53 = global_1;
    let _e54 = global_2;
    let _e62 = (((_e53.x + (_e53.y * _e54.x)) * 64u) + _e52.x);
    let _e65 = global_3.member.member;
    if (_e62 < _e65) {
        let _e69 = global_4.member[0u];
        let _e72 = global_4.member[1u];
        let _e75 = global_4.member[2u];
        let _e78 = global_4.member[3u];
        let _e81 = global_4.member[4u];
        let _e84 = global_4.member[5u];
        let _e87 = global_4.member[6u];
        let _e90 = global_4.member[7u];
        let _e93 = global_4.member[8u];
        let _e96 = global_4.member[9u];
        let _e99 = global_4.member[10u];
        let _e102 = global_4.member[11u];
        let _e105 = global_4.member[12u];
        let _e108 = global_4.member[13u];
        let _e111 = global_4.member[14u];
        let _e114 = global_4.member[15u];
        let _e117 = global_4.member[16u];
        let _e120 = global_4.member[17u];
        let _e121 = (_e62 * 3u);
        let _e124 = global_5.member[_e121];
        let _e125 = (_e121 + 1u);
        let _e128 = global_5.member[_e125];
        let _e129 = (_e121 + 2u);
        let _e132 = global_5.member[_e129];
        let _e135 = global_6.member[_e121];
        let _e138 = global_6.member[_e125];
        let _e141 = global_6.member[_e129];
        let _e142 = exp(_e135);
        let _e143 = exp(_e138);
        let _e144 = exp(_e141);
        let _e145 = (_e62 * 4u);
        let _e148 = global_7.member[_e145];
        let _e152 = global_7.member[(_e145 + 1u)];
        let _e156 = global_7.member[(_e145 + 2u)];
        let _e160 = global_7.member[(_e145 + 3u)];
        let _e169 = (1f / sqrt(((((_e148 * _e148) + (_e152 * _e152)) + (_e156 * _e156)) + (_e160 * _e160))));
        let _e170 = (_e148 * _e169);
        let _e171 = (_e152 * _e169);
        let _e172 = (_e156 * _e169);
        let _e173 = (_e160 * _e169);
        let _e174 = (_e172 * _e172);
        let _e175 = (_e173 * _e173);
        let _e179 = (_e171 * _e172);
        let _e180 = (_e170 * _e173);
        let _e183 = (_e171 * _e173);
        let _e184 = (_e170 * _e172);
        let _e189 = (_e171 * _e171);
        let _e193 = (_e172 * _e173);
        let _e194 = (_e170 * _e171);
        let _e206 = global_3.member.member_2;
        let _e207 = (1f / _e206);
        let _e208 = (_e142 * _e207);
        let _e209 = (_e143 * _e207);
        let _e210 = (_e144 * _e207);
        let _e211 = (_e208 * _e209);
        let _e212 = (_e208 * _e210);
        let _e214 = select(_e212, _e211, (_e211 > _e212));
        let _e215 = (_e209 * _e210);
        let _e221 = global_8.member[_e62];
        let _e222 = (_e221 < 0f);
        let _e225 = exp(select(-(_e221), _e221, _e222));
        let _e227 = (1f / (1f + _e225));
        let _e233 = ((2f * _e208) + 0.5f);
        let _e234 = f32(3u);
        let _e236 = select(_e234, _e233, (_e233 < _e234));
        let _e237 = bitcast<f32>(0u);
        let _e238 = bitcast<f32>(1333788671u);
        let _e244 = select(select(u32(_e236), 0u, !((_e236 >= _e237))), 4294967295u, (_e236 > _e238));
        let _e246 = ((2f * _e209) + 0.5f);
        let _e248 = select(_e234, _e246, (_e246 < _e234));
        let _e254 = select(select(u32(_e248), 0u, !((_e248 >= _e237))), 4294967295u, (_e248 > _e238));
        let _e256 = ((2f * _e210) + 0.5f);
        let _e258 = select(_e234, _e256, (_e256 < _e234));
        let _e264 = select(select(u32(_e258), 0u, !((_e258 >= _e237))), 4294967295u, (_e258 > _e238));
        let _e266 = ((2u * _e254) + 1u);
        let _e268 = ((2u * _e264) + 1u);
        let _e272 = ((((2u * _e244) + 1u) * _e266) * _e268);
        phi_412_ = 0u;
        loop {
            let _e274 = phi_412_;
            if (_e274 < _e272) {
                let _e277 = (f32(_e274) + 0f);
                let _e279 = f32(_e268);
                let _e282 = trunc(((_e277 + 0.5f) * (1f / _e279)));
                let _e284 = f32(_e266);
                let _e287 = trunc(((_e282 + 0.5f) * (1f / _e284)));
                if (_e244 == 0u) {
                    phi_437_ = type_14(0f, 1f);
                } else {
                    let _e289 = f32(_e244);
                    let _e290 = (2f / _e289);
                    let _e292 = ((_e287 - _e289) * _e290);
                    let _e294 = (_e292 * _e292);
                    phi_437_ = type_14(_e292, ((0.3989423f * _e290) * select(select(select(select(0.13533528f, 0.4111123f, (_e294 < 3f)), 0.60653067f, (_e294 < 1.4f)), 0.8007374f, (_e294 < 0.7f)), 1f, (_e294 < 0.2f))));
                }
                let _e306 = phi_437_;
                if (_e254 == 0u) {
                    phi_454_ = type_14(0f, 1f);
                } else {
                    let _e312 = f32(_e254);
                    let _e313 = (2f / _e312);
                    let _e315 = (((_e282 - (_e287 * _e284)) - _e312) * _e313);
                    let _e317 = (_e315 * _e315);
                    phi_454_ = type_14(_e315, ((0.3989423f * _e313) * select(select(select(select(0.13533528f, 0.4111123f, (_e317 < 3f)), 0.60653067f, (_e317 < 1.4f)), 0.8007374f, (_e317 < 0.7f)), 1f, (_e317 < 0.2f))));
                }
                let _e329 = phi_454_;
                if (_e264 == 0u) {
                    phi_471_ = type_14(0f, 1f);
                } else {
                    let _e335 = f32(_e264);
                    let _e336 = (2f / _e335);
                    let _e338 = (((_e277 - (_e282 * _e279)) - _e335) * _e336);
                    let _e340 = (_e338 * _e338);
                    phi_471_ = type_14(_e338, ((0.3989423f * _e336) * select(select(select(select(0.13533528f, 0.4111123f, (_e340 < 3f)), 0.60653067f, (_e340 < 1.4f)), 0.8007374f, (_e340 < 0.7f)), 1f, (_e340 < 0.2f))));
                }
                let _e352 = phi_471_;
                let _e358 = f32(4096u);
                let _e360 = ((((((4f * 3.1415927f) * select(_e227, (_e225 * _e227), _e222)) * select(_e215, _e214, (_e214 > _e215))) * ((_e306.member_1 * _e329.member_1) * _e352.member_1)) * _e358) + 0.5f);
                let _e361 = (_e306.member * _e142);
                let _e362 = (_e329.member * _e143);
                let _e363 = (_e352.member * _e144);
                let _e369 = (((_e124 + ((1f - (2f * (_e174 + _e175))) * _e361)) + ((2f * (_e179 - _e180)) * _e362)) + ((2f * (_e183 + _e184)) * _e363));
                let _e375 = (((_e128 + ((2f * (_e179 + _e180)) * _e361)) + ((1f - (2f * (_e189 + _e175))) * _e362)) + ((2f * (_e193 - _e194)) * _e363));
                let _e381 = (((_e132 + ((2f * (_e183 - _e184)) * _e361)) + ((2f * (_e193 + _e194)) * _e362)) + ((1f - (2f * (_e189 + _e174))) * _e363));
                let _e385 = (trunc((_e369 * _e78)) * _e69);
                let _e386 = (_e385 - _e87);
                let _e392 = ((_e386 * _e114) + (((_e369 - _e385) - _e96) * (_e105 + _e114)));
                let _e393 = (_e386 * _e105);
                let _e397 = (1f / 4096f);
                let _e398 = (trunc(((_e393 + _e392) * 4096f)) * _e397);
                let _e400 = ((_e393 - _e398) + _e392);
                let _e403 = (trunc((_e375 * _e81)) * _e72);
                let _e404 = (_e403 - _e90);
                let _e410 = ((_e404 * _e117) + (((_e375 - _e403) - _e99) * (_e108 + _e117)));
                let _e411 = (_e404 * _e108);
                let _e415 = (trunc(((_e411 + _e410) * 4096f)) * _e397);
                let _e417 = ((_e411 - _e415) + _e410);
                let _e420 = (trunc((_e381 * _e84)) * _e75);
                let _e421 = (_e420 - _e93);
                let _e427 = ((_e421 * _e120) + (((_e381 - _e420) - _e102) * (_e111 + _e120)));
                let _e428 = (_e421 * _e111);
                let _e432 = (trunc(((_e428 + _e427) * 4096f)) * _e397);
                let _e434 = ((_e428 - _e432) + _e427);
                let _e441 = global_3.member.member_3;
                if (_e441 == 0u) {
                    phi_513_ = array<type_14, 3>(type_14(_e398, _e400), type_14(_e415, _e417), type_14(_e432, _e434));
                } else {
                    let _e445 = ((_e398 - 0.5f) + (_e400 - 0f));
                    let _e448 = ((_e415 - 0.5f) + (_e417 - 0f));
                    let _e451 = ((_e432 - 0.5f) + (_e434 - 0f));
                    let _e454 = select(_e445, -(_e445), (_e445 < 0f));
                    let _e457 = select(_e448, -(_e448), (_e448 < 0f));
                    let _e459 = select(_e457, _e454, (_e454 > _e457));
                    let _e462 = select(_e451, -(_e451), (_e451 < 0f));
                    let _e464 = select(_e462, _e459, (_e459 > _e462));
                    let _e466 = select(0.25f, _e464, (_e464 > 0.25f));
                    let _e471 = select(1f, ((0.5f - (0.0625f / _e466)) / _e466), (0.25f < _e466));
                    let _e472 = (_e445 * _e471);
                    let _e476 = (trunc(((0.5f + _e472) * 4096f)) * _e397);
                    let _e479 = (_e448 * _e471);
                    let _e483 = (trunc(((0.5f + _e479) * 4096f)) * _e397);
                    let _e486 = (_e451 * _e471);
                    let _e490 = (trunc(((0.5f + _e486) * 4096f)) * _e397);
                    phi_513_ = array<type_14, 3>(type_14(_e476, ((0.5f - _e476) + _e472)), type_14(_e483, ((0.5f - _e483) + _e479)), type_14(_e490, ((0.5f - _e490) + _e486)));
                }
                let _e498 = phi_513_;
                let _e501 = global_3.member.member_1;
                let _e502 = f32(_e501);
                let _e508 = ((_e498[0].member + _e498[0].member_1) * _e502);
                let _e514 = ((_e498[1].member + _e498[1].member_1) * _e502);
                let _e520 = ((_e498[2].member + _e498[2].member_1) * _e502);
                let _e522 = select(_e514, _e508, (_e508 < _e514));
                let _e526 = select(_e514, _e508, (_e508 > _e514));
                let _e533 = select(false, (1f <= _e360), select(false, (select(_e520, _e526, (_e526 > _e520)) < _e502), (0f <= select(_e520, _e522, (_e522 < _e520)))));
                let _e534 = (_e501 + 2u);
                let _e551 = u32(select(0f, select(_e358, _e360, (_e360 < _e358)), _e533));
                phi_555_ = 0u;
                loop {
                    let _e553 = phi_555_;
                    if (_e553 < 1u) {
                        if (_e553 < (_e272 - _e274)) {
                            if (_e551 > 0u) {
                                let _e559 = atomicLoad((&global_9.member[(((((u32(select(0f, _e520, _e533)) + 1u) * _e534) + (u32(select(0f, _e514, _e533)) + 1u)) * _e534) + (u32(select(0f, _e508, _e533)) + 1u))]));
                                if (_e559 < 4096u) {
                                    let _e561 = atomicAdd((&global_9.member[(((((u32(select(0f, _e520, _e533)) + 1u) * _e534) + (u32(select(0f, _e514, _e533)) + 1u)) * _e534) + (u32(select(0f, _e508, _e533)) + 1u))]), _e551);
                                    if ((_e561 + _e551) > 4096u) {
                                        let _e564 = atomicMin((&global_9.member[(((((u32(select(0f, _e520, _e533)) + 1u) * _e534) + (u32(select(0f, _e514, _e533)) + 1u)) * _e534) + (u32(select(0f, _e508, _e533)) + 1u))]), 4096u);
                                    }
                                }
                            }
                            local_1 = (_e553 + 1u);
                            continue;
                        } else {
                            break;
                        }
                    } else {
                        break;
                    }
                    continuing {
                        let _e576 = local_1;
                        phi_555_ = _e576;
                    }
                }
                local = (_e274 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e569 = local;
                phi_412_ = _e569;
            }
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
