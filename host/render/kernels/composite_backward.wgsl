struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<i32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_25 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage> global_8: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_21;

fn function_() {
    var phi_180_: u32;
    var phi_183_: u32;
    var local: u32;
    var phi_292_: u32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_304_: f32;
    var phi_306_: f32;
    var phi_319_: f32;
    var phi_321_: u32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_298_: f32;
    var phi_303_: f32;
    var phi_305_: f32;
    var phi_307_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var phi_363_: vec3<f32>;
    var phi_364_: f32;
    var phi_365_: vec3<f32>;
    var phi_366_: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_375_: vec3<f32>;
    var local_14: f32;
    var local_15: f32;
    var local_16: f32;
    var local_17: u32;
    var local_18: u32;
    var local_19: u32;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var local_29: f32;
    var local_30: u32;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;

    let _e30 = global;
    let _e31 = global_1;
    let _e32 = global_2;
    let _e40 = (((_e31.x + (_e31.y * _e32.x)) * 64u) + _e30.x);
    let _e43 = global_3.member.member;
    if (_e40 < _e43) {
        let _e47 = global_3.member.member_1;
        phi_180_ = _e47;
        phi_183_ = 0u;
        loop {
            let _e49 = phi_180_;
            let _e51 = phi_183_;
            local = _e51;
            if ((_e51 + 1u) < _e49) {
                let _e55 = ((_e51 + _e49) / 2u);
                let _e58 = global_4.member[_e55];
                let _e59 = (_e58 <= _e40);
                local_17 = select(_e55, _e49, _e59);
                local_18 = select(_e51, _e55, _e59);
                continue;
            } else {
                break;
            }
            continuing {
                let _e411 = local_17;
                phi_180_ = _e411;
                let _e414 = local_18;
                phi_183_ = _e414;
            }
        }
        let _e63 = local;
        let _e64 = (_e63 * 4u);
        let _e68 = global_5.member[(_e64 + 1u)];
        let _e72 = global_5.member[(_e64 + 2u)];
        let _e75 = global_6.member[_e40];
        let _e76 = (_e75 * 3u);
        let _e79 = global_7.member[_e76];
        let _e83 = global_7.member[(_e76 + 1u)];
        let _e87 = global_7.member[(_e76 + 2u)];
        let _e90 = global_3.member.member_2;
        let _e93 = f32(_e90);
        let _e95 = f32(_e68);
        let _e98 = ceil((((_e79.x - _e79.w) - _e95) - 0.5f));
        let _e100 = select(0f, _e98, (_e98 > 0f));
        let _e102 = select(_e93, _e100, (_e100 < _e93));
        let _e105 = (((_e79.x + _e79.w) - _e95) + 0.5f);
        let _e107 = select(0f, _e105, (_e105 > 0f));
        let _e109 = select(_e93, _e107, (_e107 < _e93));
        let _e114 = select(select(u32(_e102), 0u, (_e102 < 0f)), 4294967295u, (_e102 > 4294967000f));
        let _e119 = select(select(u32(_e109), 0u, (_e109 < 0f)), 4294967295u, (_e109 > 4294967000f));
        let _e122 = global_3.member.member_3;
        let _e125 = global_3.member.member_4;
        let _e129 = f32(_e122);
        let _e130 = f32((_e122 + _e125));
        let _e132 = f32(_e72);
        let _e135 = ceil((((_e79.y - _e83.w) - _e132) - 0.5f));
        let _e137 = select(_e129, _e135, (_e135 > _e129));
        let _e139 = select(_e130, _e137, (_e137 < _e130));
        let _e142 = (((_e79.y + _e83.w) - _e132) + 0.5f);
        let _e144 = select(_e129, _e142, (_e142 > _e129));
        let _e146 = select(_e130, _e144, (_e144 < _e130));
        let _e151 = select(select(u32(_e139), 0u, (_e139 < 0f)), 4294967295u, (_e139 > 4294967000f));
        let _e156 = select(select(u32(_e146), 0u, (_e146 < 0f)), 4294967295u, (_e146 > 4294967000f));
        if (_e114 < _e119) {
            if (_e151 < _e156) {
                let _e160 = (_e119 - _e114);
                let _e162 = select(_e90, _e160, (_e160 < _e90));
                let _e163 = (_e90 - _e162);
                let _e165 = select(_e163, _e114, (_e114 < _e163));
                let _e172 = (_e90 * _e90);
                phi_292_ = _e151;
                phi_295_ = 0f;
                phi_296_ = 0f;
                phi_297_ = 0f;
                phi_299_ = 0f;
                phi_300_ = 0f;
                phi_301_ = 0f;
                phi_302_ = 0f;
                phi_304_ = 0f;
                phi_306_ = 0f;
                loop {
                    let _e178 = phi_292_;
                    let _e180 = phi_295_;
                    let _e182 = phi_296_;
                    let _e184 = phi_297_;
                    let _e186 = phi_299_;
                    let _e188 = phi_300_;
                    let _e190 = phi_301_;
                    let _e192 = phi_302_;
                    let _e194 = phi_304_;
                    let _e196 = phi_306_;
                    local_5 = _e188;
                    local_6 = _e186;
                    local_7 = _e188;
                    local_8 = _e186;
                    local_9 = _e190;
                    local_10 = _e184;
                    local_11 = _e182;
                    local_12 = _e180;
                    local_13 = _e190;
                    local_14 = _e196;
                    local_15 = _e194;
                    local_16 = _e192;
                    if (_e178 < _e156) {
                        let _e202 = ((f32((_e72 + bitcast<i32>(_e178))) + 0.5f) - _e79.y);
                        let _e205 = ((_e90 * ((_e64 * _e90) + _e178)) + _e165);
                        phi_319_ = (f32((_e68 + bitcast<i32>(_e165))) + 0.5f);
                        phi_321_ = _e205;
                        phi_323_ = 0f;
                        phi_324_ = 0f;
                        phi_298_ = _e184;
                        phi_303_ = _e192;
                        phi_305_ = _e194;
                        phi_307_ = _e196;
                        loop {
                            let _e208 = phi_319_;
                            let _e210 = phi_321_;
                            let _e212 = phi_323_;
                            let _e214 = phi_324_;
                            let _e216 = phi_298_;
                            let _e218 = phi_303_;
                            let _e220 = phi_305_;
                            let _e222 = phi_307_;
                            local_22 = _e216;
                            local_26 = _e218;
                            local_27 = _e220;
                            local_28 = _e222;
                            local_1 = _e214;
                            local_2 = _e212;
                            local_3 = _e214;
                            local_4 = _e212;
                            if (_e210 < (_e205 + _e162)) {
                                let _e224 = (_e208 - _e79.x);
                                let _e226 = ((_e83.y * _e224) * _e202);
                                let _e233 = ((((_e83.x * _e224) * _e224) + (_e226 + _e226)) + ((_e83.z * _e202) * _e202));
                                let _e238 = (_e233 <= 11.082527f);
                                let _e239 = select(0f, exp((-0.5f * select(0f, _e233, (_e233 > 0f)))), _e238);
                                let _e242 = global_8.member[_e210];
                                let _e246 = global_8.member[(_e210 + _e172)];
                                let _e251 = global_8.member[(_e210 + (2u * _e172))];
                                let _e256 = global_8.member[(_e210 + (3u * _e172))];
                                let _e264 = select(0f, (_e239 * ((((_e242 * _e87.x) + (_e246 * _e87.y)) + (_e251 * _e87.z)) + _e256)), _e238);
                                let _e265 = (_e264 * _e224);
                                local_29 = (_e208 + 1f);
                                local_30 = (_e210 + 1u);
                                local_31 = (_e212 + _e265);
                                local_32 = (_e214 + _e264);
                                local_33 = (_e216 + (_e265 * _e224));
                                local_34 = select(_e218, (_e218 + (_e239 * _e251)), _e238);
                                local_35 = select(_e220, (_e220 + (_e239 * _e246)), _e238);
                                local_36 = select(_e222, (_e222 + (_e239 * _e242)), _e238);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e448 = local_29;
                                phi_319_ = _e448;
                                let _e451 = local_30;
                                phi_321_ = _e451;
                                let _e454 = local_31;
                                phi_323_ = _e454;
                                let _e457 = local_32;
                                phi_324_ = _e457;
                                let _e460 = local_33;
                                phi_298_ = _e460;
                                let _e463 = local_34;
                                phi_303_ = _e463;
                                let _e466 = local_35;
                                phi_305_ = _e466;
                                let _e469 = local_36;
                                phi_307_ = _e469;
                            }
                        }
                        let _e282 = local_1;
                        let _e285 = local_2;
                        let _e288 = local_3;
                        let _e289 = (_e288 * _e202);
                        let _e292 = local_4;
                        local_19 = (_e178 + 1u);
                        local_20 = (_e180 + (_e289 * _e202));
                        local_21 = (_e182 + (_e292 * _e202));
                        local_23 = (_e186 + _e289);
                        local_24 = (_e188 + _e285);
                        local_25 = (_e190 + _e282);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e418 = local_19;
                        phi_292_ = _e418;
                        let _e421 = local_20;
                        phi_295_ = _e421;
                        let _e424 = local_21;
                        phi_296_ = _e424;
                        let _e427 = local_22;
                        phi_297_ = _e427;
                        let _e430 = local_23;
                        phi_299_ = _e430;
                        let _e433 = local_24;
                        phi_300_ = _e433;
                        let _e436 = local_25;
                        phi_301_ = _e436;
                        let _e439 = local_26;
                        phi_302_ = _e439;
                        let _e442 = local_27;
                        phi_304_ = _e442;
                        let _e445 = local_28;
                        phi_306_ = _e445;
                    }
                }
                let _e301 = global_3.member.member_6;
                let _e303 = (1f - (_e301 * _e83.x));
                let _e305 = (1f - (_e301 * _e83.z));
                let _e306 = (_e301 * _e83.y);
                let _e309 = ((_e303 * _e305) - (_e306 * _e306));
                let _e310 = (_e301 > 0f);
                if _e310 {
                    if (_e309 > 0.000015378702f) {
                        let _e315 = ((-0.5f * _e301) / _e309);
                        phi_363_ = vec3<f32>((_e305 * _e315), ((2f * _e306) * _e315), (_e303 * _e315));
                        phi_364_ = sqrt(_e309);
                    } else {
                        phi_363_ = vec3<f32>(0f, 0f, 0f);
                        phi_364_ = 0.003921569f;
                    }
                    let _e321 = phi_363_;
                    let _e323 = phi_364_;
                    phi_365_ = _e321;
                    phi_366_ = _e323;
                } else {
                    phi_365_ = vec3<f32>(0f, 0f, 0f);
                    phi_366_ = 1f;
                }
                let _e325 = phi_365_;
                let _e327 = phi_366_;
                let _e329 = local_5;
                let _e332 = local_6;
                let _e337 = local_7;
                let _e340 = local_8;
                let _e345 = local_9;
                let _e348 = local_10;
                let _e351 = local_11;
                let _e354 = local_12;
                let _e356 = ((-0.5f * _e348) * _e79.z);
                let _e357 = ((-1f * _e351) * _e79.z);
                let _e358 = ((-0.5f * _e354) * _e79.z);
                if _e310 {
                    let _e361 = local_13;
                    let _e362 = (_e361 * _e79.z);
                    phi_375_ = vec3<f32>((_e356 + (_e325.x * _e362)), (_e357 + (_e325.y * _e362)), (_e358 + (_e325.z * _e362)));
                } else {
                    phi_375_ = vec3<f32>(_e356, _e357, _e358);
                }
                let _e374 = phi_375_;
                let _e375 = (_e40 * 3u);
                let _e378 = global_9.member[_e375];
                global_9.member[_e375] = (_e378 + vec4<f32>((_e79.z * ((_e83.x * _e329) + (_e83.y * _e332))), (_e79.z * ((_e83.y * _e337) + (_e83.z * _e340))), (_e345 * _e327), 0f));
                let _e384 = global_9.member[(_e375 + 1u)];
                global_9.member[(_e375 + 1u)] = (_e384 + vec4<f32>(_e374.x, _e374.y, _e374.z, 0f));
                let _e392 = global_3.member.member_5;
                if (_e392 == 0u) {
                } else {
                    let _e397 = global_9.member[(_e375 + 2u)];
                    let _e399 = local_14;
                    let _e402 = local_15;
                    let _e405 = local_16;
                    global_9.member[(_e375 + 2u)] = (_e397 + vec4<f32>((_e399 * _e79.z), (_e402 * _e79.z), (_e405 * _e79.z), 0f));
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn composite_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
