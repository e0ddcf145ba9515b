struct type_6 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_20 {
    member: array<type_18>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_3: type_6;
@group(0) @binding(0) 
var<uniform> global_4: type_16;
@group(0) @binding(1) 
var<storage> global_5: type_20;
@group(0) @binding(2) 
var<storage> global_6: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_6;

fn function_() {
    var phi_282_: u32;
    var phi_302_: u32;
    var phi_321_: u32;
    var phi_340_: u32;
    var phi_359_: u32;
    var phi_378_: u32;
    var phi_397_: u32;
    var phi_416_: u32;
    var phi_427_: u32;
    var phi_444_: u32;
    var phi_447_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = global;
            let _e33 = global_1;
            let _e34 = global_2;
            let _e42 = (((_e33.x + (_e33.y * _e34.x)) * 64u) + _e32.x);
            let _e45 = global_4.member.member;
            if (_e42 < _e45) {
                let _e50 = global_5.member[_e33.z];
                let _e53 = global_4.member.member_1;
                let _e56 = global_4.member.member_5;
                let _e59 = global_4.member.member_4;
                let _e60 = (_e59 == 0u);
                if _e60 {
                    break;
                }
                let _e61 = (_e42 / _e59);
                if _e60 {
                    break;
                }
                let _e64 = (_e42 % _e59);
                let _e65 = ((_e61 * (_e56 * _e53)) + _e64);
                let _e68 = global_3.member[_e65];
                let _e69 = (3u * _e53);
                let _e73 = global_3.member[(_e65 + _e69)];
                let _e74 = (_e53 + _e65);
                let _e77 = global_3.member[_e74];
                let _e81 = global_3.member[(_e74 + _e69)];
                let _e82 = (2u * _e53);
                let _e83 = (_e82 + _e65);
                let _e86 = global_3.member[_e83];
                let _e90 = global_3.member[(_e83 + _e69)];
                let _e91 = (_e68 + _e73);
                let _e94 = select(false, (_e91 < 1f), (0f < _e91));
                let _e97 = select(select(0f, 1f, (1f <= _e91)), _e68, _e94);
                let _e100 = (_e97 * _e50.member);
                let _e103 = (_e50.member + _e50.member_1);
                let _e107 = trunc(_e100);
                let _e109 = ((_e100 - _e107) + (((_e97 * _e50.member_1) + (select(0f, _e73, _e94) * _e103)) + 0.5f));
                let _e111 = select(0f, _e109, (_e109 > 0f));
                let _e112 = trunc(_e111);
                let _e113 = (_e111 - _e112);
                let _e114 = (_e107 + _e112);
                let _e119 = select(select(u32(_e114), 0u, (_e114 < 0f)), 4294967295u, (_e114 > 4294967000f));
                let _e120 = (_e77 + _e81);
                let _e123 = select(false, (_e120 < 1f), (0f < _e120));
                let _e126 = select(select(0f, 1f, (1f <= _e120)), _e77, _e123);
                let _e128 = (_e126 * _e50.member);
                let _e133 = trunc(_e128);
                let _e135 = ((_e128 - _e133) + (((_e126 * _e50.member_1) + (select(0f, _e81, _e123) * _e103)) + 0.5f));
                let _e137 = select(0f, _e135, (_e135 > 0f));
                let _e138 = trunc(_e137);
                let _e139 = (_e137 - _e138);
                let _e140 = (_e133 + _e138);
                let _e145 = select(select(u32(_e140), 0u, (_e140 < 0f)), 4294967295u, (_e140 > 4294967000f));
                let _e146 = (_e86 + _e90);
                let _e149 = select(false, (_e146 < 1f), (0f < _e146));
                let _e152 = select(select(0f, 1f, (1f <= _e146)), _e86, _e149);
                let _e154 = (_e152 * _e50.member);
                let _e159 = trunc(_e154);
                let _e161 = ((_e154 - _e159) + (((_e152 * _e50.member_1) + (select(0f, _e90, _e149) * _e103)) + 0.5f));
                let _e163 = select(0f, _e161, (_e161 > 0f));
                let _e164 = trunc(_e163);
                let _e165 = (_e163 - _e164);
                let _e166 = (_e159 + _e164);
                let _e171 = select(select(u32(_e166), 0u, (_e166 < 0f)), 4294967295u, (_e166 > 4294967000f));
                let _e172 = (_e119 + 1u);
                let _e173 = (_e145 + 1u);
                let _e174 = (_e171 + 1u);
                let _e177 = (_e50.member_5 == 0u);
                if _e177 {
                    let _e188 = (_e119 + ((_e145 + (_e171 * _e50.member_2)) * _e50.member_2));
                    phi_282_ = select((_e188 - _e50.member_4), _e188, (_e188 < _e50.member_4));
                } else {
                    phi_282_ = (((_e119 ^ (_e145 * 2654435761u)) ^ (_e171 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e193 = phi_282_;
                if _e177 {
                    let _e206 = (_e172 + ((_e145 + (_e171 * _e50.member_2)) * _e50.member_2));
                    phi_302_ = select((_e206 - _e50.member_4), _e206, (_e206 < _e50.member_4));
                } else {
                    phi_302_ = (((_e172 ^ (_e145 * 2654435761u)) ^ (_e171 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e211 = phi_302_;
                if _e177 {
                    let _e223 = (_e119 + ((_e173 + (_e171 * _e50.member_2)) * _e50.member_2));
                    phi_321_ = select((_e223 - _e50.member_4), _e223, (_e223 < _e50.member_4));
                } else {
                    phi_321_ = (((_e119 ^ (_e173 * 2654435761u)) ^ (_e171 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e228 = phi_321_;
                if _e177 {
                    let _e240 = (_e172 + ((_e173 + (_e171 * _e50.member_2)) * _e50.member_2));
                    phi_340_ = select((_e240 - _e50.member_4), _e240, (_e240 < _e50.member_4));
                } else {
                    phi_340_ = (((_e172 ^ (_e173 * 2654435761u)) ^ (_e171 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e245 = phi_340_;
                if _e177 {
                    let _e257 = (_e119 + ((_e145 + (_e174 * _e50.member_2)) * _e50.member_2));
                    phi_359_ = select((_e257 - _e50.member_4), _e257, (_e257 < _e50.member_4));
                } else {
                    phi_359_ = (((_e119 ^ (_e145 * 2654435761u)) ^ (_e174 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e262 = phi_359_;
                if _e177 {
                    let _e274 = (_e172 + ((_e145 + (_e174 * _e50.member_2)) * _e50.member_2));
                    phi_378_ = select((_e274 - _e50.member_4), _e274, (_e274 < _e50.member_4));
                } else {
                    phi_378_ = (((_e172 ^ (_e145 * 2654435761u)) ^ (_e174 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e279 = phi_378_;
                if _e177 {
                    let _e291 = (_e119 + ((_e173 + (_e174 * _e50.member_2)) * _e50.member_2));
                    phi_397_ = select((_e291 - _e50.member_4), _e291, (_e291 < _e50.member_4));
                } else {
                    phi_397_ = (((_e119 ^ (_e173 * 2654435761u)) ^ (_e174 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e296 = phi_397_;
                if _e177 {
                    let _e308 = (_e172 + ((_e173 + (_e174 * _e50.member_2)) * _e50.member_2));
                    phi_416_ = select((_e308 - _e50.member_4), _e308, (_e308 < _e50.member_4));
                } else {
                    phi_416_ = (((_e172 ^ (_e173 * 2654435761u)) ^ (_e174 * 805459861u)) & (_e50.member_4 - 1u));
                }
                let _e313 = phi_416_;
                let _e315 = (1f - _e113);
                let _e316 = (1f - _e139);
                let _e317 = (1f - _e165);
                let _e318 = (_e315 * _e316);
                let _e319 = (_e113 * _e316);
                let _e320 = (_e315 * _e139);
                let _e321 = (_e113 * _e139);
                let _e322 = (_e318 * _e317);
                let _e323 = (_e319 * _e317);
                let _e324 = (_e320 * _e317);
                let _e325 = (_e321 * _e317);
                let _e326 = (_e318 * _e165);
                let _e327 = (_e319 * _e165);
                let _e328 = (_e320 * _e165);
                let _e329 = (_e321 * _e165);
                let _e332 = global_4.member.member_3;
                let _e333 = (_e332 / 2u);
                if ((_e332 % 2u) > 0u) {
                    phi_427_ = (_e333 + 1u);
                } else {
                    phi_427_ = _e333;
                }
                let _e338 = phi_427_;
                let _e341 = global_4.member.member_2;
                let _e346 = global_4.member.member_6;
                if _e60 {
                    break;
                }
                if _e60 {
                    break;
                }
                phi_444_ = 0u;
                phi_447_ = (((_e61 * (_e346 * _e53)) + _e64) + ((_e341 + (_e33.z * _e332)) * _e53));
                loop {
                    let _e353 = phi_444_;
                    let _e355 = phi_447_;
                    if (_e353 < _e338) {
                        let _e361 = global_6.member[(((_e193 + _e50.member_3) * _e338) + _e353)];
                        let _e362 = (_e361 & 65535u);
                        let _e373 = (_e361 >> bitcast<u32>(16i));
                        let _e389 = global_6.member[(((_e211 + _e50.member_3) * _e338) + _e353)];
                        let _e390 = (_e389 & 65535u);
                        let _e401 = (_e389 >> bitcast<u32>(16i));
                        let _e417 = global_6.member[(((_e228 + _e50.member_3) * _e338) + _e353)];
                        let _e418 = (_e417 & 65535u);
                        let _e429 = (_e417 >> bitcast<u32>(16i));
                        let _e445 = global_6.member[(((_e245 + _e50.member_3) * _e338) + _e353)];
                        let _e446 = (_e445 & 65535u);
                        let _e457 = (_e445 >> bitcast<u32>(16i));
                        let _e473 = global_6.member[(((_e262 + _e50.member_3) * _e338) + _e353)];
                        let _e474 = (_e473 & 65535u);
                        let _e485 = (_e473 >> bitcast<u32>(16i));
                        let _e501 = global_6.member[(((_e279 + _e50.member_3) * _e338) + _e353)];
                        let _e502 = (_e501 & 65535u);
                        let _e513 = (_e501 >> bitcast<u32>(16i));
                        let _e529 = global_6.member[(((_e296 + _e50.member_3) * _e338) + _e353)];
                        let _e530 = (_e529 & 65535u);
                        let _e541 = (_e529 >> bitcast<u32>(16i));
                        let _e557 = global_6.member[(((_e313 + _e50.member_3) * _e338) + _e353)];
                        let _e558 = (_e557 & 65535u);
                        let _e569 = (_e557 >> bitcast<u32>(16i));
                        global_7.member[_e355] = (((((((((bitcast<f32>((((_e362 & 32768u) << bitcast<u32>(16i)) | ((_e362 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e322) + ((bitcast<f32>((((_e390 & 32768u) << bitcast<u32>(16i)) | ((_e390 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e323)) + ((bitcast<f32>((((_e418 & 32768u) << bitcast<u32>(16i)) | ((_e418 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e324)) + ((bitcast<f32>((((_e446 & 32768u) << bitcast<u32>(16i)) | ((_e446 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e325)) + ((bitcast<f32>((((_e474 & 32768u) << bitcast<u32>(16i)) | ((_e474 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e326)) + ((bitcast<f32>((((_e502 & 32768u) << bitcast<u32>(16i)) | ((_e502 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e327)) + ((bitcast<f32>((((_e530 & 32768u) << bitcast<u32>(16i)) | ((_e530 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e328)) + ((bitcast<f32>((((_e558 & 32768u) << bitcast<u32>(16i)) | ((_e558 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e329));
                        if (((2u * _e353) + 1u) < _e332) {
                            global_7.member[(_e355 + _e53)] = (((((((((bitcast<f32>((((_e373 & 32768u) << bitcast<u32>(16i)) | ((_e373 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e322) + ((bitcast<f32>((((_e401 & 32768u) << bitcast<u32>(16i)) | ((_e401 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e323)) + ((bitcast<f32>((((_e429 & 32768u) << bitcast<u32>(16i)) | ((_e429 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e324)) + ((bitcast<f32>((((_e457 & 32768u) << bitcast<u32>(16i)) | ((_e457 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e325)) + ((bitcast<f32>((((_e485 & 32768u) << bitcast<u32>(16i)) | ((_e485 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e326)) + ((bitcast<f32>((((_e513 & 32768u) << bitcast<u32>(16i)) | ((_e513 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e327)) + ((bitcast<f32>((((_e541 & 32768u) << bitcast<u32>(16i)) | ((_e541 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e328)) + ((bitcast<f32>((((_e569 & 32768u) << bitcast<u32>(16i)) | ((_e569 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e329));
                        }
                        local = (_e353 + 1u);
                        local_1 = (_e355 + _e82);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e616 = local;
                        phi_444_ = _e616;
                        let _e619 = local_1;
                        phi_447_ = _e619;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_half(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
