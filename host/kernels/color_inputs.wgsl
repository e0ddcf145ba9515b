struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_15;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage> global_8: type_5;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_5;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_5;

fn function_() {
    var phi_271_: f32;
    var phi_274_: u32;
    var phi_276_: f32;
    var phi_278_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_297_: f32;
    var phi_300_: u32;
    var phi_302_: f32;
    var phi_317_: f32;
    var phi_298_: f32;
    var phi_301_: u32;
    var phi_303_: f32;
    var phi_272_: f32;
    var phi_275_: u32;
    var phi_277_: f32;
    var phi_279_: f32;
    var phi_335_: u32;
    var phi_336_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e43 = global;
            let _e44 = global_1;
            let _e45 = global_2;
            let _e53 = (((_e44.x + (_e44.y * _e45.x)) * 64u) + _e43.x);
            let _e56 = global_3.member.member;
            if (_e53 < _e56) {
                let _e60 = global_3.member.member_1;
                let _e64 = global_4.member[(_e60 + _e53)];
                let _e67 = global_3.member.member_3;
                let _e68 = (_e67 == 0u);
                if _e68 {
                    break;
                }
                let _e69 = (_e64 % _e67);
                if _e68 {
                    break;
                }
                let _e71 = ((_e64 / _e67) * 18u);
                let _e75 = global_5.member[(_e71 + 9u)];
                let _e79 = global_5.member[(_e71 + 10u)];
                let _e83 = global_5.member[(_e71 + 11u)];
                let _e84 = (_e69 * 3u);
                let _e87 = global_7.member[_e84];
                let _e91 = global_7.member[(_e84 + 1u)];
                let _e95 = global_7.member[(_e84 + 2u)];
                let _e98 = global_3.member.member_2;
                let _e101 = global_6.member[0u];
                let _e104 = global_6.member[1u];
                let _e107 = global_6.member[2u];
                let _e110 = global_6.member[3u];
                let _e113 = global_6.member[4u];
                let _e116 = global_6.member[5u];
                let _e119 = global_6.member[6u];
                let _e122 = global_6.member[7u];
                let _e125 = global_6.member[8u];
                let _e128 = global_6.member[9u];
                let _e131 = global_6.member[10u];
                let _e134 = global_6.member[11u];
                let _e137 = global_6.member[12u];
                let _e140 = global_6.member[13u];
                let _e143 = global_6.member[14u];
                let _e146 = global_6.member[15u];
                let _e149 = global_6.member[16u];
                let _e152 = global_6.member[17u];
                let _e159 = (trunc((_e87 * _e110)) * _e101);
                let _e160 = (trunc((_e91 * _e113)) * _e104);
                let _e161 = (trunc((_e95 * _e116)) * _e107);
                let _e162 = (_e159 - _e119);
                let _e163 = (_e160 - _e122);
                let _e164 = (_e161 - _e125);
                let _e171 = (_e162 * _e137);
                let _e172 = (_e163 * _e140);
                let _e173 = (_e164 * _e143);
                let _e183 = ((_e162 * _e146) + (((_e87 - _e159) - _e128) * (_e137 + _e146)));
                let _e184 = ((_e163 * _e149) + (((_e91 - _e160) - _e131) * (_e140 + _e149)));
                let _e185 = ((_e164 * _e152) + (((_e95 - _e161) - _e134) * (_e143 + _e152)));
                let _e189 = (trunc(((_e171 + _e183) * 4096f)) * 0.00024414063f);
                let _e195 = (trunc(((_e172 + _e184) * 4096f)) * 0.00024414063f);
                let _e201 = (trunc(((_e173 + _e185) * 4096f)) * 0.00024414063f);
                global_9.member[_e53] = _e189;
                global_9.member[(_e98 + _e53)] = _e195;
                global_9.member[((2u * _e98) + _e53)] = _e201;
                global_9.member[((3u * _e98) + _e53)] = ((_e171 - _e189) + _e183);
                global_9.member[((4u * _e98) + _e53)] = ((_e172 - _e195) + _e184);
                global_9.member[((5u * _e98) + _e53)] = ((_e173 - _e201) + _e185);
                let _e225 = (_e87 - _e75);
                let _e226 = (_e91 - _e79);
                let _e227 = (_e95 - _e83);
                let _e233 = sqrt((((_e225 * _e225) + (_e226 * _e226)) + (_e227 * _e227)));
                let _e236 = (1f / select(0.000000000000000000000000000000000000011754944f, _e233, (_e233 > 0.000000000000000000000000000000000000011754944f)));
                let _e237 = (_e225 * _e236);
                let _e238 = (_e226 * _e236);
                let _e242 = global_3.member.member_4;
                phi_271_ = 0f;
                phi_274_ = 0u;
                phi_276_ = 0.28209478f;
                phi_278_ = 1f;
                loop {
                    let _e244 = phi_271_;
                    let _e246 = phi_274_;
                    let _e248 = phi_276_;
                    let _e250 = phi_278_;
                    let _e251 = (_e246 <= _e242);
                    if _e251 {
                        let _e252 = f32(_e246);
                        let _e253 = (_e246 > 0u);
                        if _e253 {
                            let _e254 = (2f * _e252);
                            phi_292_ = ((_e237 * _e244) + (_e238 * _e250));
                            phi_293_ = (_e248 * -(sqrt(((_e254 + 1f) / _e254))));
                            phi_294_ = ((_e237 * _e250) - (_e238 * _e244));
                        } else {
                            phi_292_ = _e244;
                            phi_293_ = _e248;
                            phi_294_ = _e250;
                        }
                        let _e267 = phi_292_;
                        let _e269 = phi_293_;
                        let _e271 = phi_294_;
                        phi_297_ = _e269;
                        phi_300_ = _e246;
                        phi_302_ = 0f;
                        loop {
                            let _e274 = phi_297_;
                            let _e276 = phi_300_;
                            let _e278 = phi_302_;
                            let _e279 = (_e276 <= _e242);
                            if _e279 {
                                let _e280 = (_e276 > _e246);
                                if _e280 {
                                    let _e281 = f32(_e276);
                                    let _e282 = (_e281 - 1f);
                                    let _e287 = (_e252 * _e252);
                                    phi_317_ = (sqrt(((((4f * _e281) * _e281) - 1f) / ((_e281 * _e281) - _e287))) * (((_e227 * _e236) * _e274) - (sqrt((((_e282 * _e282) - _e287) / (((4f * _e282) * _e282) - 1f))) * _e278)));
                                } else {
                                    phi_317_ = _e274;
                                }
                                let _e303 = phi_317_;
                                let _e306 = ((_e276 * _e276) + _e276);
                                let _e310 = (select(1f, 1.4142135f, _e253) * _e303);
                                global_10.member[(_e53 + ((_e306 + _e246) * _e98))] = (_e310 * _e271);
                                if _e253 {
                                    global_10.member[(_e53 + ((_e306 - _e246) * _e98))] = (_e310 * _e267);
                                }
                                phi_298_ = _e303;
                                phi_301_ = (_e276 + 1u);
                                phi_303_ = select(_e278, _e274, _e280);
                            } else {
                                phi_298_ = f32();
                                phi_301_ = u32();
                                phi_303_ = f32();
                            }
                            let _e322 = phi_298_;
                            let _e324 = phi_301_;
                            let _e326 = phi_303_;
                            continue;
                            continuing {
                                phi_297_ = _e322;
                                phi_300_ = _e324;
                                phi_302_ = _e326;
                                break if !(_e279);
                            }
                        }
                        phi_272_ = _e267;
                        phi_275_ = (_e246 + 1u);
                        phi_277_ = _e269;
                        phi_279_ = _e271;
                    } else {
                        phi_272_ = f32();
                        phi_275_ = u32();
                        phi_277_ = f32();
                        phi_279_ = f32();
                    }
                    let _e330 = phi_272_;
                    let _e332 = phi_275_;
                    let _e334 = phi_277_;
                    let _e336 = phi_279_;
                    continue;
                    continuing {
                        phi_271_ = _e330;
                        phi_274_ = _e332;
                        phi_276_ = _e334;
                        phi_278_ = _e336;
                        break if !(_e251);
                    }
                }
                phi_335_ = 0u;
                loop {
                    let _e339 = phi_335_;
                    let _e342 = global_3.member.member_5;
                    let _e343 = (_e339 < _e342);
                    if _e343 {
                        let _e348 = global_8.member[((_e69 * _e342) + _e339)];
                        let _e351 = global_3.member.member_6;
                        global_10.member[(((_e351 + _e339) * _e98) + _e53)] = _e348;
                        phi_336_ = (_e339 + 1u);
                    } else {
                        phi_336_ = u32();
                    }
                    let _e359 = phi_336_;
                    continue;
                    continuing {
                        phi_335_ = _e359;
                        break if !(_e343);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn color_inputs(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
