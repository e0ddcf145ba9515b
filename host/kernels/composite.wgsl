struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_17 {
    member: array<u32>,
}

struct type_23 {
    member: array<i32>,
}

struct type_26 {
    member: u32,
    member_1: u32,
}

struct type_27 {
    member: type_26,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_2: type_23;
@group(0) @binding(2) 
var<storage> global_3: type_17;
@group(0) @binding(3) 
var<storage> global_4: type_17;
@group(0) @binding(0) 
var<uniform> global_5: type_27;
@group(0) @binding(4) 
var<storage> global_6: type_17;
@group(0) @binding(5) 
var<storage> global_7: type_6;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_9;

fn function_() {
    var phi_115_: bool;
    var phi_117_: bool;
    var phi_118_: bool;
    var phi_119_: bool;
    var phi_120_: bool;
    var phi_178_: u32;
    var phi_187_: u32;
    var phi_201_: f32;
    var phi_204_: f32;
    var phi_206_: f32;
    var phi_208_: f32;
    var phi_210_: u32;
    var phi_220_: u32;
    var phi_223_: f32;
    var phi_225_: f32;
    var phi_227_: f32;
    var phi_229_: f32;
    var phi_268_: f32;
    var phi_271_: bool;
    var phi_272_: bool;
    var phi_273_: bool;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_303_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_306_: f32;
    var phi_221_: u32;
    var phi_224_: f32;
    var phi_226_: f32;
    var phi_228_: f32;
    var phi_230_: f32;
    var phi_202_: f32;
    var phi_205_: f32;
    var phi_207_: f32;
    var phi_209_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = global;
            let _e31 = global_1;
            let _e40 = ((_e31.x * 16u) + _e30.x);
            let _e42 = ((_e31.y * 4u) + _e30.y);
            let _e45 = global_5.member.member;
            if (_e40 < _e45) {
                let _e47 = (_e42 < _e45);
                if _e47 {
                    phi_115_ = select(true, false, _e47);
                } else {
                    phi_115_ = false;
                }
                let _e50 = phi_115_;
                phi_117_ = _e47;
                phi_118_ = _e47;
                phi_119_ = _e50;
                phi_120_ = select(false, _e47, _e47);
            } else {
                phi_117_ = bool();
                phi_118_ = false;
                phi_119_ = false;
                phi_120_ = false;
            }
            let _e53 = phi_117_;
            let _e55 = phi_118_;
            let _e57 = phi_119_;
            let _e59 = phi_120_;
            let _e60 = select(_e42, 0u, _e57);
            let _e61 = select(_e40, 0u, _e57);
            if select(_e59, true, _e57) {
                let _e65 = (_e31.z * 4u);
                let _e69 = global_2.member[(_e65 + 1u)];
                let _e73 = global_2.member[(_e65 + 2u)];
                let _e77 = (f32((_e69 + bitcast<i32>(_e61))) + 0.5f);
                let _e81 = (f32((_e73 + bitcast<i32>(_e60))) + 0.5f);
                let _e84 = global_3.member[_e31.z];
                let _e87 = global_5.member.member_1;
                let _e88 = (_e84 + _e87);
                let _e92 = global_3.member[(_e31.z + 1u)];
                let _e93 = (_e88 + 16384u);
                let _e95 = select(_e93, _e92, (_e92 < _e93));
                let _e96 = (_e45 * _e45);
                let _e100 = (((_e65 * _e96) + (_e60 * _e45)) + _e61);
                let _e103 = global_8.member[_e100];
                let _e107 = global_8.member[(_e100 + _e96)];
                let _e112 = global_8.member[(_e100 + (2u * _e96))];
                let _e117 = global_8.member[(_e100 + (3u * _e96))];
                let _e118 = (_e45 / 64u);
                if ((_e45 % 64u) > 0u) {
                    phi_178_ = (_e118 + 1u);
                } else {
                    phi_178_ = _e118;
                }
                let _e123 = phi_178_;
                let _e124 = (_e123 * 16u);
                let _e125 = (_e45 / 8u);
                if ((_e45 % 8u) > 0u) {
                    phi_187_ = (_e125 + 1u);
                } else {
                    phi_187_ = _e125;
                }
                let _e130 = phi_187_;
                if (_e130 == 0u) {
                    break;
                }
                if (_e124 == 0u) {
                    break;
                }
                phi_201_ = _e117;
                phi_204_ = _e112;
                phi_206_ = _e107;
                phi_208_ = _e103;
                phi_210_ = _e88;
                loop {
                    let _e141 = phi_201_;
                    let _e143 = phi_204_;
                    let _e145 = phi_206_;
                    let _e147 = phi_208_;
                    let _e149 = phi_210_;
                    local = _e147;
                    local_1 = _e145;
                    local_2 = _e143;
                    local_3 = _e141;
                    let _e150 = (_e149 < _e95);
                    if _e150 {
                        phi_220_ = 0u;
                        phi_223_ = _e141;
                        phi_225_ = _e143;
                        phi_227_ = _e145;
                        phi_229_ = _e147;
                        loop {
                            let _e153 = phi_220_;
                            let _e155 = phi_223_;
                            let _e157 = phi_225_;
                            let _e159 = phi_227_;
                            let _e161 = phi_229_;
                            local_4 = _e155;
                            local_5 = _e157;
                            local_6 = _e159;
                            local_7 = _e161;
                            let _e162 = (_e153 < (_e95 - _e149));
                            if _e162 {
                                let _e163 = (_e149 + _e153);
                                let _e165 = global_6.member[_e163];
                                if ((_e165 & (1u << bitcast<u32>(((((_e60 / _e130) * 4u) + (_e61 / _e124)) & 31u)))) == 0u) {
                                    phi_303_ = _e155;
                                    phi_304_ = _e157;
                                    phi_305_ = _e159;
                                    phi_306_ = _e161;
                                } else {
                                    let _e169 = global_4.member[_e163];
                                    let _e170 = (_e169 * 3u);
                                    let _e172 = global_7.member[_e170];
                                    let _e175 = global_7.member[(_e170 + 1u)];
                                    let _e177 = (_e77 - _e172.x);
                                    if (_e177 > _e172.w) {
                                        phi_272_ = bool();
                                        phi_273_ = true;
                                    } else {
                                        let _e181 = ((_e172.x - _e77) > _e172.w);
                                        if _e181 {
                                            phi_271_ = bool();
                                        } else {
                                            let _e183 = (_e81 - _e172.y);
                                            if (_e183 < 0f) {
                                                phi_268_ = -(_e183);
                                            } else {
                                                phi_268_ = _e183;
                                            }
                                            let _e187 = phi_268_;
                                            phi_271_ = (_e187 > _e175.w);
                                        }
                                        let _e191 = phi_271_;
                                        phi_272_ = _e191;
                                        phi_273_ = _e181;
                                    }
                                    let _e193 = phi_272_;
                                    let _e195 = phi_273_;
                                    if !(select(_e193, true, _e195)) {
                                        let _e199 = (_e81 - _e172.y);
                                        let _e211 = ((((_e175.x * _e177) * _e177) + (((2f * _e175.y) * _e177) * _e199)) + ((_e175.z * _e199) * _e199));
                                        let _e217 = (_e211 <= 11.082527f);
                                        let _e219 = (_e172.z * select(0f, exp((-0.5f * select(0f, _e211, (_e211 > 0f)))), _e217));
                                        let _e222 = global_7.member[(_e170 + 2u)];
                                        phi_299_ = (_e155 + select(0f, _e219, _e217));
                                        phi_300_ = (_e157 + select(0f, (_e219 * _e222.z), _e217));
                                        phi_301_ = (_e159 + select(0f, (_e219 * _e222.y), _e217));
                                        phi_302_ = (_e161 + select(0f, (_e219 * _e222.x), _e217));
                                    } else {
                                        phi_299_ = _e155;
                                        phi_300_ = _e157;
                                        phi_301_ = _e159;
                                        phi_302_ = _e161;
                                    }
                                    let _e238 = phi_299_;
                                    let _e240 = phi_300_;
                                    let _e242 = phi_301_;
                                    let _e244 = phi_302_;
                                    phi_303_ = _e238;
                                    phi_304_ = _e240;
                                    phi_305_ = _e242;
                                    phi_306_ = _e244;
                                }
                                let _e246 = phi_303_;
                                let _e248 = phi_304_;
                                let _e250 = phi_305_;
                                let _e252 = phi_306_;
                                phi_221_ = (_e153 + 1u);
                                phi_224_ = _e246;
                                phi_226_ = _e248;
                                phi_228_ = _e250;
                                phi_230_ = _e252;
                            } else {
                                phi_221_ = u32();
                                phi_224_ = f32();
                                phi_226_ = f32();
                                phi_228_ = f32();
                                phi_230_ = f32();
                            }
                            let _e255 = phi_221_;
                            let _e257 = phi_224_;
                            let _e259 = phi_226_;
                            let _e261 = phi_228_;
                            let _e263 = phi_230_;
                            continue;
                            continuing {
                                phi_220_ = _e255;
                                phi_223_ = _e257;
                                phi_225_ = _e259;
                                phi_227_ = _e261;
                                phi_229_ = _e263;
                                break if !(_e162);
                            }
                        }
                        let _e319 = local_4;
                        phi_202_ = _e319;
                        let _e322 = local_5;
                        phi_205_ = _e322;
                        let _e325 = local_6;
                        phi_207_ = _e325;
                        let _e328 = local_7;
                        phi_209_ = _e328;
                    } else {
                        phi_202_ = f32();
                        phi_205_ = f32();
                        phi_207_ = f32();
                        phi_209_ = f32();
                    }
                    let _e266 = phi_202_;
                    let _e268 = phi_205_;
                    let _e270 = phi_207_;
                    let _e272 = phi_209_;
                    continue;
                    continuing {
                        phi_201_ = _e266;
                        phi_204_ = _e268;
                        phi_206_ = _e270;
                        phi_208_ = _e272;
                        phi_210_ = select(u32(), _e95, _e150);
                        break if !(_e150);
                    }
                }
                if select(_e53, _e55, _e57) {
                    let _e276 = local;
                    global_8.member[_e100] = _e276;
                    let _e278 = local_1;
                    global_8.member[(_e100 + _e96)] = _e278;
                    let _e280 = local_2;
                    global_8.member[(_e100 + (2u * _e96))] = _e280;
                    let _e282 = local_3;
                    global_8.member[(_e100 + (3u * _e96))] = _e282;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn composite(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
