struct type_6 {
    member: array<i32>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_25 {
    member: type_24,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_16;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(4) 
var<storage> global_6: type_21;
@group(0) @binding(0) 
var<uniform> global_7: type_25;
@group(0) @binding(5) 
var<storage> global_8: type_9;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_21;

fn function_() {
    var phi_153_: u32;
    var phi_156_: u32;
    var local: u32;
    var phi_265_: u32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_277_: f32;
    var phi_279_: f32;
    var phi_292_: f32;
    var phi_294_: u32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_271_: f32;
    var phi_276_: f32;
    var phi_278_: f32;
    var phi_280_: f32;
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

    let _e27 = global;
    let _e28 = global_1;
    let _e29 = global_2;
    let _e37 = (((_e28.x + (_e28.y * _e29.x)) * 64u) + _e27.x);
    let _e40 = global_7.member.member;
    if (_e37 < _e40) {
        let _e44 = global_7.member.member_1;
        phi_153_ = _e44;
        phi_156_ = 0u;
        loop {
            let _e46 = phi_153_;
            let _e48 = phi_156_;
            local = _e48;
            if ((_e48 + 1u) < _e46) {
                let _e52 = ((_e48 + _e46) / 2u);
                let _e55 = global_4.member[_e52];
                let _e56 = (_e55 <= _e37);
                local_16 = select(_e52, _e46, _e56);
                local_17 = select(_e48, _e52, _e56);
                continue;
            } else {
                break;
            }
            continuing {
                let _e359 = local_16;
                phi_153_ = _e359;
                let _e362 = local_17;
                phi_156_ = _e362;
            }
        }
        let _e60 = local;
        let _e61 = (_e60 * 4u);
        let _e65 = global_3.member[(_e61 + 1u)];
        let _e69 = global_3.member[(_e61 + 2u)];
        let _e72 = global_5.member[_e37];
        let _e73 = (_e72 * 3u);
        let _e76 = global_6.member[_e73];
        let _e80 = global_6.member[(_e73 + 1u)];
        let _e84 = global_6.member[(_e73 + 2u)];
        let _e87 = global_7.member.member_2;
        let _e90 = f32(_e87);
        let _e92 = f32(_e65);
        let _e95 = ceil((((_e76.x - _e76.w) - _e92) - 0.5f));
        let _e97 = select(0f, _e95, (_e95 > 0f));
        let _e99 = select(_e90, _e97, (_e97 < _e90));
        let _e102 = (((_e76.x + _e76.w) - _e92) + 0.5f);
        let _e104 = select(0f, _e102, (_e102 > 0f));
        let _e106 = select(_e90, _e104, (_e104 < _e90));
        let _e111 = select(select(u32(_e99), 0u, (_e99 < 0f)), 4294967295u, (_e99 > 4294967000f));
        let _e116 = select(select(u32(_e106), 0u, (_e106 < 0f)), 4294967295u, (_e106 > 4294967000f));
        let _e119 = global_7.member.member_3;
        let _e122 = global_7.member.member_4;
        let _e126 = f32(_e119);
        let _e127 = f32((_e119 + _e122));
        let _e129 = f32(_e69);
        let _e132 = ceil((((_e76.y - _e80.w) - _e129) - 0.5f));
        let _e134 = select(_e126, _e132, (_e132 > _e126));
        let _e136 = select(_e127, _e134, (_e134 < _e127));
        let _e139 = (((_e76.y + _e80.w) - _e129) + 0.5f);
        let _e141 = select(_e126, _e139, (_e139 > _e126));
        let _e143 = select(_e127, _e141, (_e141 < _e127));
        let _e148 = select(select(u32(_e136), 0u, (_e136 < 0f)), 4294967295u, (_e136 > 4294967000f));
        let _e153 = select(select(u32(_e143), 0u, (_e143 < 0f)), 4294967295u, (_e143 > 4294967000f));
        if (_e111 < _e116) {
            if (_e148 < _e153) {
                let _e157 = (_e116 - _e111);
                let _e159 = select(_e87, _e157, (_e157 < _e87));
                let _e160 = (_e87 - _e159);
                let _e162 = select(_e160, _e111, (_e111 < _e160));
                let _e169 = (_e87 * _e87);
                phi_265_ = _e148;
                phi_268_ = 0f;
                phi_269_ = 0f;
                phi_270_ = 0f;
                phi_272_ = 0f;
                phi_273_ = 0f;
                phi_274_ = 0f;
                phi_275_ = 0f;
                phi_277_ = 0f;
                phi_279_ = 0f;
                loop {
                    let _e175 = phi_265_;
                    let _e177 = phi_268_;
                    let _e179 = phi_269_;
                    let _e181 = phi_270_;
                    let _e183 = phi_272_;
                    let _e185 = phi_273_;
                    let _e187 = phi_274_;
                    let _e189 = phi_275_;
                    let _e191 = phi_277_;
                    let _e193 = phi_279_;
                    local_5 = _e185;
                    local_6 = _e183;
                    local_7 = _e185;
                    local_8 = _e183;
                    local_9 = _e181;
                    local_10 = _e179;
                    local_11 = _e177;
                    local_12 = _e187;
                    local_13 = _e193;
                    local_14 = _e191;
                    local_15 = _e189;
                    if (_e175 < _e153) {
                        let _e199 = ((f32((_e69 + bitcast<i32>(_e175))) + 0.5f) - _e76.y);
                        let _e202 = ((_e87 * ((_e61 * _e87) + _e175)) + _e162);
                        phi_292_ = (f32((_e65 + bitcast<i32>(_e162))) + 0.5f);
                        phi_294_ = _e202;
                        phi_296_ = 0f;
                        phi_297_ = 0f;
                        phi_271_ = _e181;
                        phi_276_ = _e189;
                        phi_278_ = _e191;
                        phi_280_ = _e193;
                        loop {
                            let _e205 = phi_292_;
                            let _e207 = phi_294_;
                            let _e209 = phi_296_;
                            let _e211 = phi_297_;
                            let _e213 = phi_271_;
                            let _e215 = phi_276_;
                            let _e217 = phi_278_;
                            let _e219 = phi_280_;
                            local_21 = _e213;
                            local_25 = _e215;
                            local_26 = _e217;
                            local_27 = _e219;
                            local_1 = _e211;
                            local_2 = _e209;
                            local_3 = _e211;
                            local_4 = _e209;
                            if (_e207 < (_e202 + _e159)) {
                                let _e221 = (_e205 - _e76.x);
                                let _e223 = ((_e80.y * _e221) * _e199);
                                let _e230 = ((((_e80.x * _e221) * _e221) + (_e223 + _e223)) + ((_e80.z * _e199) * _e199));
                                let _e235 = (_e230 <= 11.082527f);
                                let _e236 = select(0f, exp((-0.5f * select(0f, _e230, (_e230 > 0f)))), _e235);
                                let _e239 = global_8.member[_e207];
                                let _e243 = global_8.member[(_e207 + _e169)];
                                let _e248 = global_8.member[(_e207 + (2u * _e169))];
                                let _e253 = global_8.member[(_e207 + (3u * _e169))];
                                let _e261 = select(0f, (_e236 * ((((_e239 * _e84.x) + (_e243 * _e84.y)) + (_e248 * _e84.z)) + _e253)), _e235);
                                let _e262 = (_e261 * _e221);
                                local_28 = (_e205 + 1f);
                                local_29 = (_e207 + 1u);
                                local_30 = (_e209 + _e262);
                                local_31 = (_e211 + _e261);
                                local_32 = (_e213 + (_e262 * _e221));
                                local_33 = select(_e215, (_e215 + (_e236 * _e248)), _e235);
                                local_34 = select(_e217, (_e217 + (_e236 * _e243)), _e235);
                                local_35 = select(_e219, (_e219 + (_e236 * _e239)), _e235);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e396 = local_28;
                                phi_292_ = _e396;
                                let _e399 = local_29;
                                phi_294_ = _e399;
                                let _e402 = local_30;
                                phi_296_ = _e402;
                                let _e405 = local_31;
                                phi_297_ = _e405;
                                let _e408 = local_32;
                                phi_271_ = _e408;
                                let _e411 = local_33;
                                phi_276_ = _e411;
                                let _e414 = local_34;
                                phi_278_ = _e414;
                                let _e417 = local_35;
                                phi_280_ = _e417;
                            }
                        }
                        let _e279 = local_1;
                        let _e282 = local_2;
                        let _e285 = local_3;
                        let _e286 = (_e285 * _e199);
                        let _e289 = local_4;
                        local_18 = (_e175 + 1u);
                        local_19 = (_e177 + (_e286 * _e199));
                        local_20 = (_e179 + (_e289 * _e199));
                        local_22 = (_e183 + _e286);
                        local_23 = (_e185 + _e282);
                        local_24 = (_e187 + _e279);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e366 = local_18;
                        phi_265_ = _e366;
                        let _e369 = local_19;
                        phi_268_ = _e369;
                        let _e372 = local_20;
                        phi_269_ = _e372;
                        let _e375 = local_21;
                        phi_270_ = _e375;
                        let _e378 = local_22;
                        phi_272_ = _e378;
                        let _e381 = local_23;
                        phi_273_ = _e381;
                        let _e384 = local_24;
                        phi_274_ = _e384;
                        let _e387 = local_25;
                        phi_275_ = _e387;
                        let _e390 = local_26;
                        phi_277_ = _e390;
                        let _e393 = local_27;
                        phi_279_ = _e393;
                    }
                }
                let _e297 = local_5;
                let _e300 = local_6;
                let _e305 = local_7;
                let _e308 = local_8;
                let _e313 = local_9;
                let _e316 = local_10;
                let _e319 = local_11;
                let _e324 = (_e37 * 3u);
                let _e327 = global_9.member[_e324];
                let _e329 = local_12;
                global_9.member[_e324] = (_e327 + vec4<f32>((_e76.z * ((_e80.x * _e297) + (_e80.y * _e300))), (_e76.z * ((_e80.y * _e305) + (_e80.z * _e308))), _e329, 0f));
                let _e335 = global_9.member[(_e324 + 1u)];
                global_9.member[(_e324 + 1u)] = (_e335 + vec4<f32>(((-0.5f * _e313) * _e76.z), ((-1f * _e316) * _e76.z), ((-0.5f * _e319) * _e76.z), 0f));
                let _e340 = global_7.member.member_5;
                if (_e340 == 0u) {
                } else {
                    let _e345 = global_9.member[(_e324 + 2u)];
                    let _e347 = local_13;
                    let _e350 = local_14;
                    let _e353 = local_15;
                    global_9.member[(_e324 + 2u)] = (_e345 + vec4<f32>((_e347 * _e76.z), (_e350 * _e76.z), (_e353 * _e76.z), 0f));
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
