struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_5 {
    member: type_4,
}

struct type_9 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_12 {
    member: array<type_9>,
}

struct type_16 {
    member: array<f32>,
}

struct type_21 {
    member: array<u32>,
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
var<storage> global_6: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_217_: u32;
    var phi_351_: array<u32, 8>;
    var phi_383_: u32;
    var phi_386_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = global;
            let _e31 = global_1;
            let _e32 = global_2;
            let _e38 = ((_e31.x + (_e31.y * _e32.x)) * 64u);
            let _e43 = global_3.member.member;
            if ((_e38 + _e30.x) < _e43) {
                let _e48 = global_4.member[_e31.z];
                let _e51 = global_3.member.member_1;
                let _e54 = global_3.member.member_5;
                let _e57 = global_3.member.member_4;
                let _e58 = (_e57 == 0u);
                if _e58 {
                    break;
                }
                let _e59 = (_e38 / _e57);
                let _e63 = (_e38 - (_e59 * _e57));
                let _e65 = (((_e59 * (_e54 * _e51)) + _e63) + _e30.x);
                let _e68 = global_5.member[_e65];
                let _e69 = (3u * _e51);
                let _e73 = global_5.member[(_e65 + _e69)];
                let _e74 = (_e51 + _e65);
                let _e77 = global_5.member[_e74];
                let _e81 = global_5.member[(_e74 + _e69)];
                let _e82 = (2u * _e51);
                let _e83 = (_e82 + _e65);
                let _e86 = global_5.member[_e83];
                let _e90 = global_5.member[(_e83 + _e69)];
                let _e93 = global_3.member.member_3;
                let _e94 = (_e93 / 2u);
                if ((_e93 % 2u) > 0u) {
                    phi_217_ = (_e94 + 1u);
                } else {
                    phi_217_ = _e94;
                }
                let _e99 = phi_217_;
                let _e100 = (_e68 + _e73);
                let _e103 = select(false, (_e100 < 1f), (0f < _e100));
                let _e106 = select(select(0f, 1f, (1f <= _e100)), _e68, _e103);
                let _e109 = (_e106 * _e48.member);
                let _e112 = (_e48.member + _e48.member_1);
                let _e116 = trunc(_e109);
                let _e118 = ((_e109 - _e116) + (((_e106 * _e48.member_1) + (select(0f, _e73, _e103) * _e112)) + 0.5f));
                let _e120 = select(0f, _e118, (_e118 > 0f));
                let _e121 = trunc(_e120);
                let _e122 = (_e120 - _e121);
                let _e124 = u32((_e116 + _e121));
                let _e125 = (_e77 + _e81);
                let _e128 = select(false, (_e125 < 1f), (0f < _e125));
                let _e131 = select(select(0f, 1f, (1f <= _e125)), _e77, _e128);
                let _e133 = (_e131 * _e48.member);
                let _e138 = trunc(_e133);
                let _e140 = ((_e133 - _e138) + (((_e131 * _e48.member_1) + (select(0f, _e81, _e128) * _e112)) + 0.5f));
                let _e142 = select(0f, _e140, (_e140 > 0f));
                let _e143 = trunc(_e142);
                let _e144 = (_e142 - _e143);
                let _e146 = u32((_e138 + _e143));
                let _e147 = (_e86 + _e90);
                let _e150 = select(false, (_e147 < 1f), (0f < _e147));
                let _e153 = select(select(0f, 1f, (1f <= _e147)), _e86, _e150);
                let _e155 = (_e153 * _e48.member);
                let _e160 = trunc(_e155);
                let _e162 = ((_e155 - _e160) + (((_e153 * _e48.member_1) + (select(0f, _e90, _e150) * _e112)) + 0.5f));
                let _e164 = select(0f, _e162, (_e162 > 0f));
                let _e165 = trunc(_e164);
                let _e166 = (_e164 - _e165);
                let _e168 = u32((_e160 + _e165));
                let _e169 = (1f - _e122);
                let _e170 = (1f - _e144);
                let _e171 = (1f - _e166);
                let _e172 = (_e169 * _e170);
                let _e173 = (_e122 * _e170);
                let _e174 = (_e169 * _e144);
                let _e175 = (_e122 * _e144);
                let _e176 = (_e172 * _e171);
                let _e177 = (_e173 * _e171);
                let _e178 = (_e174 * _e171);
                let _e179 = (_e175 * _e171);
                let _e180 = (_e172 * _e166);
                let _e181 = (_e173 * _e166);
                let _e182 = (_e174 * _e166);
                let _e183 = (_e175 * _e166);
                if (_e48.member_5 == 0u) {
                    let _e225 = (_e48.member_2 * _e48.member_2);
                    let _e226 = (_e146 * _e48.member_2);
                    let _e227 = (_e168 * _e225);
                    let _e228 = (_e124 + 1u);
                    let _e229 = (_e226 + _e48.member_2);
                    let _e230 = (_e227 + _e225);
                    let _e231 = (_e124 + _e226);
                    let _e232 = (_e231 + _e227);
                    let _e237 = (_e228 + _e226);
                    let _e238 = (_e237 + _e227);
                    let _e243 = (_e124 + _e229);
                    let _e244 = (_e243 + _e227);
                    let _e249 = (_e228 + _e229);
                    let _e250 = (_e249 + _e227);
                    let _e255 = (_e231 + _e230);
                    let _e260 = (_e237 + _e230);
                    let _e265 = (_e243 + _e230);
                    let _e270 = (_e249 + _e230);
                    phi_351_ = array<u32, 8>((select((_e232 - _e48.member_4), _e232, (_e232 < _e48.member_4)) + _e48.member_3), (select((_e238 - _e48.member_4), _e238, (_e238 < _e48.member_4)) + _e48.member_3), (select((_e244 - _e48.member_4), _e244, (_e244 < _e48.member_4)) + _e48.member_3), (select((_e250 - _e48.member_4), _e250, (_e250 < _e48.member_4)) + _e48.member_3), (select((_e255 - _e48.member_4), _e255, (_e255 < _e48.member_4)) + _e48.member_3), (select((_e260 - _e48.member_4), _e260, (_e260 < _e48.member_4)) + _e48.member_3), (select((_e265 - _e48.member_4), _e265, (_e265 < _e48.member_4)) + _e48.member_3), (select((_e270 - _e48.member_4), _e270, (_e270 < _e48.member_4)) + _e48.member_3));
                } else {
                    let _e188 = (_e48.member_4 - 1u);
                    let _e189 = (_e146 * 2654435761u);
                    let _e190 = (_e168 * 805459861u);
                    let _e191 = (_e124 + 1u);
                    let _e192 = (_e189 + 2654435761u);
                    let _e193 = (_e190 + 805459861u);
                    let _e194 = (_e124 ^ _e189);
                    let _e198 = (_e191 ^ _e189);
                    let _e202 = (_e124 ^ _e192);
                    let _e206 = (_e191 ^ _e192);
                    phi_351_ = array<u32, 8>((((_e194 ^ _e190) & _e188) + _e48.member_3), (((_e198 ^ _e190) & _e188) + _e48.member_3), (((_e202 ^ _e190) & _e188) + _e48.member_3), (((_e206 ^ _e190) & _e188) + _e48.member_3), (((_e194 ^ _e193) & _e188) + _e48.member_3), (((_e198 ^ _e193) & _e188) + _e48.member_3), (((_e202 ^ _e193) & _e188) + _e48.member_3), (((_e206 ^ _e193) & _e188) + _e48.member_3));
                }
                let _e277 = phi_351_;
                let _e296 = global_3.member.member_2;
                let _e301 = global_3.member.member_6;
                if _e58 {
                    break;
                }
                phi_383_ = 0u;
                phi_386_ = ((((_e59 * (_e301 * _e51)) + _e63) + _e30.x) + ((_e296 + (_e31.z * _e93)) * _e51));
                loop {
                    let _e309 = phi_383_;
                    let _e311 = phi_386_;
                    if (_e309 < _e99) {
                        let _e316 = global_6.member[((_e277[0] * _e99) + _e309)];
                        let _e317 = (_e316 & 65535u);
                        let _e328 = (_e316 >> bitcast<u32>(16i));
                        let _e343 = global_6.member[((_e277[1] * _e99) + _e309)];
                        let _e344 = (_e343 & 65535u);
                        let _e355 = (_e343 >> bitcast<u32>(16i));
                        let _e370 = global_6.member[((_e277[2] * _e99) + _e309)];
                        let _e371 = (_e370 & 65535u);
                        let _e382 = (_e370 >> bitcast<u32>(16i));
                        let _e397 = global_6.member[((_e277[3] * _e99) + _e309)];
                        let _e398 = (_e397 & 65535u);
                        let _e409 = (_e397 >> bitcast<u32>(16i));
                        let _e424 = global_6.member[((_e277[4] * _e99) + _e309)];
                        let _e425 = (_e424 & 65535u);
                        let _e436 = (_e424 >> bitcast<u32>(16i));
                        let _e451 = global_6.member[((_e277[5] * _e99) + _e309)];
                        let _e452 = (_e451 & 65535u);
                        let _e463 = (_e451 >> bitcast<u32>(16i));
                        let _e478 = global_6.member[((_e277[6] * _e99) + _e309)];
                        let _e479 = (_e478 & 65535u);
                        let _e490 = (_e478 >> bitcast<u32>(16i));
                        let _e505 = global_6.member[((_e277[7] * _e99) + _e309)];
                        let _e506 = (_e505 & 65535u);
                        let _e517 = (_e505 >> bitcast<u32>(16i));
                        global_7.member[_e311] = (((((((((bitcast<f32>((((_e317 & 32768u) << bitcast<u32>(16i)) | ((_e317 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e176) + ((bitcast<f32>((((_e344 & 32768u) << bitcast<u32>(16i)) | ((_e344 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e177)) + ((bitcast<f32>((((_e371 & 32768u) << bitcast<u32>(16i)) | ((_e371 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e178)) + ((bitcast<f32>((((_e398 & 32768u) << bitcast<u32>(16i)) | ((_e398 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e179)) + ((bitcast<f32>((((_e425 & 32768u) << bitcast<u32>(16i)) | ((_e425 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e180)) + ((bitcast<f32>((((_e452 & 32768u) << bitcast<u32>(16i)) | ((_e452 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e181)) + ((bitcast<f32>((((_e479 & 32768u) << bitcast<u32>(16i)) | ((_e479 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e182)) + ((bitcast<f32>((((_e506 & 32768u) << bitcast<u32>(16i)) | ((_e506 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e183));
                        if (((2u * _e309) + 1u) < _e93) {
                            global_7.member[(_e311 + _e51)] = (((((((((bitcast<f32>((((_e328 & 32768u) << bitcast<u32>(16i)) | ((_e328 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e176) + ((bitcast<f32>((((_e355 & 32768u) << bitcast<u32>(16i)) | ((_e355 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e177)) + ((bitcast<f32>((((_e382 & 32768u) << bitcast<u32>(16i)) | ((_e382 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e178)) + ((bitcast<f32>((((_e409 & 32768u) << bitcast<u32>(16i)) | ((_e409 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e179)) + ((bitcast<f32>((((_e436 & 32768u) << bitcast<u32>(16i)) | ((_e436 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e180)) + ((bitcast<f32>((((_e463 & 32768u) << bitcast<u32>(16i)) | ((_e463 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e181)) + ((bitcast<f32>((((_e490 & 32768u) << bitcast<u32>(16i)) | ((_e490 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e182)) + ((bitcast<f32>((((_e517 & 32768u) << bitcast<u32>(16i)) | ((_e517 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e183));
                        }
                        local = (_e309 + 1u);
                        local_1 = (_e311 + _e82);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e557 = local;
                        phi_383_ = _e557;
                        let _e560 = local_1;
                        phi_386_ = _e560;
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
