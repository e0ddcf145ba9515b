struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
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
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_10;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage> global_8: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_21;

fn function_() {
    var phi_151_: u32;
    var phi_154_: u32;
    var local: u32;
    var phi_263_: u32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_275_: f32;
    var phi_277_: f32;
    var phi_290_: f32;
    var phi_292_: u32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_269_: f32;
    var phi_274_: f32;
    var phi_276_: f32;
    var phi_278_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var local_14: f32;
    var local_15: f32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: f32;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var local_29: u32;
    var local_30: f32;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;

    let _e25 = global;
    let _e26 = global_1;
    let _e27 = global_2;
    let _e35 = (((_e26.x + (_e26.y * _e27.x)) * 64u) + _e25.x);
    let _e38 = global_3.member.member;
    if (_e35 < _e38) {
        let _e42 = global_3.member.member_1;
        phi_151_ = _e42;
        phi_154_ = 0u;
        loop {
            let _e44 = phi_151_;
            let _e46 = phi_154_;
            local = _e46;
            if ((_e46 + 1u) < _e44) {
                let _e50 = ((_e46 + _e44) / 2u);
                let _e53 = global_4.member[_e50];
                let _e54 = (_e53 <= _e35);
                local_16 = select(_e50, _e44, _e54);
                local_17 = select(_e46, _e50, _e54);
                continue;
            } else {
                break;
            }
            continuing {
                let _e357 = local_16;
                phi_151_ = _e357;
                let _e360 = local_17;
                phi_154_ = _e360;
            }
        }
        let _e58 = local;
        let _e59 = (_e58 * 4u);
        let _e63 = global_5.member[(_e59 + 1u)];
        let _e67 = global_5.member[(_e59 + 2u)];
        let _e70 = global_6.member[_e35];
        let _e71 = (_e70 * 3u);
        let _e74 = global_7.member[_e71];
        let _e78 = global_7.member[(_e71 + 1u)];
        let _e82 = global_7.member[(_e71 + 2u)];
        let _e85 = global_3.member.member_2;
        let _e88 = f32(_e85);
        let _e90 = f32(_e63);
        let _e93 = ceil((((_e74.x - _e74.w) - _e90) - 0.5f));
        let _e95 = select(0f, _e93, (_e93 > 0f));
        let _e97 = select(_e88, _e95, (_e95 < _e88));
        let _e100 = (((_e74.x + _e74.w) - _e90) + 0.5f);
        let _e102 = select(0f, _e100, (_e100 > 0f));
        let _e104 = select(_e88, _e102, (_e102 < _e88));
        let _e109 = select(select(u32(_e97), 0u, (_e97 < 0f)), 4294967295u, (_e97 > 4294967000f));
        let _e114 = select(select(u32(_e104), 0u, (_e104 < 0f)), 4294967295u, (_e104 > 4294967000f));
        let _e117 = global_3.member.member_3;
        let _e120 = global_3.member.member_4;
        let _e124 = f32(_e117);
        let _e125 = f32((_e117 + _e120));
        let _e127 = f32(_e67);
        let _e130 = ceil((((_e74.y - _e78.w) - _e127) - 0.5f));
        let _e132 = select(_e124, _e130, (_e130 > _e124));
        let _e134 = select(_e125, _e132, (_e132 < _e125));
        let _e137 = (((_e74.y + _e78.w) - _e127) + 0.5f);
        let _e139 = select(_e124, _e137, (_e137 > _e124));
        let _e141 = select(_e125, _e139, (_e139 < _e125));
        let _e146 = select(select(u32(_e134), 0u, (_e134 < 0f)), 4294967295u, (_e134 > 4294967000f));
        let _e151 = select(select(u32(_e141), 0u, (_e141 < 0f)), 4294967295u, (_e141 > 4294967000f));
        if (_e109 < _e114) {
            if (_e146 < _e151) {
                let _e155 = (_e114 - _e109);
                let _e157 = select(_e85, _e155, (_e155 < _e85));
                let _e158 = (_e85 - _e157);
                let _e160 = select(_e158, _e109, (_e109 < _e158));
                let _e167 = (_e85 * _e85);
                phi_263_ = _e146;
                phi_266_ = 0f;
                phi_267_ = 0f;
                phi_268_ = 0f;
                phi_270_ = 0f;
                phi_271_ = 0f;
                phi_272_ = 0f;
                phi_273_ = 0f;
                phi_275_ = 0f;
                phi_277_ = 0f;
                loop {
                    let _e173 = phi_263_;
                    let _e175 = phi_266_;
                    let _e177 = phi_267_;
                    let _e179 = phi_268_;
                    let _e181 = phi_270_;
                    let _e183 = phi_271_;
                    let _e185 = phi_272_;
                    let _e187 = phi_273_;
                    let _e189 = phi_275_;
                    let _e191 = phi_277_;
                    local_5 = _e183;
                    local_6 = _e181;
                    local_7 = _e183;
                    local_8 = _e181;
                    local_9 = _e179;
                    local_10 = _e177;
                    local_11 = _e175;
                    local_12 = _e185;
                    local_13 = _e191;
                    local_14 = _e189;
                    local_15 = _e187;
                    if (_e173 < _e151) {
                        let _e197 = ((f32((_e67 + bitcast<i32>(_e173))) + 0.5f) - _e74.y);
                        let _e200 = ((_e85 * ((_e59 * _e85) + _e173)) + _e160);
                        phi_290_ = (f32((_e63 + bitcast<i32>(_e160))) + 0.5f);
                        phi_292_ = _e200;
                        phi_294_ = 0f;
                        phi_295_ = 0f;
                        phi_269_ = _e179;
                        phi_274_ = _e187;
                        phi_276_ = _e189;
                        phi_278_ = _e191;
                        loop {
                            let _e203 = phi_290_;
                            let _e205 = phi_292_;
                            let _e207 = phi_294_;
                            let _e209 = phi_295_;
                            let _e211 = phi_269_;
                            let _e213 = phi_274_;
                            let _e215 = phi_276_;
                            let _e217 = phi_278_;
                            local_21 = _e211;
                            local_25 = _e213;
                            local_26 = _e215;
                            local_27 = _e217;
                            local_1 = _e209;
                            local_2 = _e207;
                            local_3 = _e209;
                            local_4 = _e207;
                            if (_e205 < (_e200 + _e157)) {
                                let _e219 = (_e203 - _e74.x);
                                let _e221 = ((_e78.y * _e219) * _e197);
                                let _e228 = ((((_e78.x * _e219) * _e219) + (_e221 + _e221)) + ((_e78.z * _e197) * _e197));
                                let _e233 = (_e228 <= 11.082527f);
                                let _e234 = select(0f, exp((-0.5f * select(0f, _e228, (_e228 > 0f)))), _e233);
                                let _e237 = global_8.member[_e205];
                                let _e241 = global_8.member[(_e205 + _e167)];
                                let _e246 = global_8.member[(_e205 + (2u * _e167))];
                                let _e251 = global_8.member[(_e205 + (3u * _e167))];
                                let _e259 = select(0f, (_e234 * ((((_e237 * _e82.x) + (_e241 * _e82.y)) + (_e246 * _e82.z)) + _e251)), _e233);
                                let _e260 = (_e259 * _e219);
                                local_28 = (_e203 + 1f);
                                local_29 = (_e205 + 1u);
                                local_30 = (_e207 + _e260);
                                local_31 = (_e209 + _e259);
                                local_32 = (_e211 + (_e260 * _e219));
                                local_33 = select(_e213, (_e213 + (_e234 * _e246)), _e233);
                                local_34 = select(_e215, (_e215 + (_e234 * _e241)), _e233);
                                local_35 = select(_e217, (_e217 + (_e234 * _e237)), _e233);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e394 = local_28;
                                phi_290_ = _e394;
                                let _e397 = local_29;
                                phi_292_ = _e397;
                                let _e400 = local_30;
                                phi_294_ = _e400;
                                let _e403 = local_31;
                                phi_295_ = _e403;
                                let _e406 = local_32;
                                phi_269_ = _e406;
                                let _e409 = local_33;
                                phi_274_ = _e409;
                                let _e412 = local_34;
                                phi_276_ = _e412;
                                let _e415 = local_35;
                                phi_278_ = _e415;
                            }
                        }
                        let _e277 = local_1;
                        let _e280 = local_2;
                        let _e283 = local_3;
                        let _e284 = (_e283 * _e197);
                        let _e287 = local_4;
                        local_18 = (_e173 + 1u);
                        local_19 = (_e175 + (_e284 * _e197));
                        local_20 = (_e177 + (_e287 * _e197));
                        local_22 = (_e181 + _e284);
                        local_23 = (_e183 + _e280);
                        local_24 = (_e185 + _e277);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e364 = local_18;
                        phi_263_ = _e364;
                        let _e367 = local_19;
                        phi_266_ = _e367;
                        let _e370 = local_20;
                        phi_267_ = _e370;
                        let _e373 = local_21;
                        phi_268_ = _e373;
                        let _e376 = local_22;
                        phi_270_ = _e376;
                        let _e379 = local_23;
                        phi_271_ = _e379;
                        let _e382 = local_24;
                        phi_272_ = _e382;
                        let _e385 = local_25;
                        phi_273_ = _e385;
                        let _e388 = local_26;
                        phi_275_ = _e388;
                        let _e391 = local_27;
                        phi_277_ = _e391;
                    }
                }
                let _e295 = local_5;
                let _e298 = local_6;
                let _e303 = local_7;
                let _e306 = local_8;
                let _e311 = local_9;
                let _e314 = local_10;
                let _e317 = local_11;
                let _e322 = (_e35 * 3u);
                let _e325 = global_9.member[_e322];
                let _e327 = local_12;
                global_9.member[_e322] = (_e325 + vec4<f32>((_e74.z * ((_e78.x * _e295) + (_e78.y * _e298))), (_e74.z * ((_e78.y * _e303) + (_e78.z * _e306))), _e327, 0f));
                let _e333 = global_9.member[(_e322 + 1u)];
                global_9.member[(_e322 + 1u)] = (_e333 + vec4<f32>(((-0.5f * _e311) * _e74.z), ((-1f * _e314) * _e74.z), ((-0.5f * _e317) * _e74.z), 0f));
                let _e338 = global_3.member.member_5;
                if (_e338 == 0u) {
                } else {
                    let _e343 = global_9.member[(_e322 + 2u)];
                    let _e345 = local_13;
                    let _e348 = local_14;
                    let _e351 = local_15;
                    global_9.member[(_e322 + 2u)] = (_e343 + vec4<f32>((_e345 * _e74.z), (_e348 * _e74.z), (_e351 * _e74.z), 0f));
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
