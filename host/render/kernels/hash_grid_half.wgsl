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
    var phi_218_: u32;
    var phi_352_: array<u32, 8>;
    var phi_384_: u32;
    var phi_387_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = global;
            let _e32 = global_1;
            let _e33 = global_2;
            let _e39 = ((_e32.x + (_e32.y * _e33.x)) * 64u);
            let _e44 = global_4.member.member;
            if ((_e39 + _e31.x) < _e44) {
                let _e49 = global_5.member[_e32.z];
                let _e52 = global_4.member.member_1;
                let _e55 = global_4.member.member_5;
                let _e58 = global_4.member.member_4;
                let _e59 = (_e58 == 0u);
                if _e59 {
                    break;
                }
                let _e60 = (_e39 / _e58);
                let _e64 = (_e39 - (_e60 * _e58));
                let _e66 = (((_e60 * (_e55 * _e52)) + _e64) + _e31.x);
                let _e69 = global_3.member[_e66];
                let _e70 = (3u * _e52);
                let _e74 = global_3.member[(_e66 + _e70)];
                let _e75 = (_e52 + _e66);
                let _e78 = global_3.member[_e75];
                let _e82 = global_3.member[(_e75 + _e70)];
                let _e83 = (2u * _e52);
                let _e84 = (_e83 + _e66);
                let _e87 = global_3.member[_e84];
                let _e91 = global_3.member[(_e84 + _e70)];
                let _e94 = global_4.member.member_3;
                let _e95 = (_e94 / 2u);
                if ((_e94 % 2u) > 0u) {
                    phi_218_ = (_e95 + 1u);
                } else {
                    phi_218_ = _e95;
                }
                let _e100 = phi_218_;
                let _e101 = (_e69 + _e74);
                let _e104 = select(false, (_e101 < 1f), (0f < _e101));
                let _e107 = select(select(0f, 1f, (1f <= _e101)), _e69, _e104);
                let _e110 = (_e107 * _e49.member);
                let _e113 = (_e49.member + _e49.member_1);
                let _e117 = trunc(_e110);
                let _e119 = ((_e110 - _e117) + (((_e107 * _e49.member_1) + (select(0f, _e74, _e104) * _e113)) + 0.5f));
                let _e121 = select(0f, _e119, (_e119 > 0f));
                let _e122 = trunc(_e121);
                let _e123 = (_e121 - _e122);
                let _e125 = u32((_e117 + _e122));
                let _e126 = (_e78 + _e82);
                let _e129 = select(false, (_e126 < 1f), (0f < _e126));
                let _e132 = select(select(0f, 1f, (1f <= _e126)), _e78, _e129);
                let _e134 = (_e132 * _e49.member);
                let _e139 = trunc(_e134);
                let _e141 = ((_e134 - _e139) + (((_e132 * _e49.member_1) + (select(0f, _e82, _e129) * _e113)) + 0.5f));
                let _e143 = select(0f, _e141, (_e141 > 0f));
                let _e144 = trunc(_e143);
                let _e145 = (_e143 - _e144);
                let _e147 = u32((_e139 + _e144));
                let _e148 = (_e87 + _e91);
                let _e151 = select(false, (_e148 < 1f), (0f < _e148));
                let _e154 = select(select(0f, 1f, (1f <= _e148)), _e87, _e151);
                let _e156 = (_e154 * _e49.member);
                let _e161 = trunc(_e156);
                let _e163 = ((_e156 - _e161) + (((_e154 * _e49.member_1) + (select(0f, _e91, _e151) * _e113)) + 0.5f));
                let _e165 = select(0f, _e163, (_e163 > 0f));
                let _e166 = trunc(_e165);
                let _e167 = (_e165 - _e166);
                let _e169 = u32((_e161 + _e166));
                let _e170 = (1f - _e123);
                let _e171 = (1f - _e145);
                let _e172 = (1f - _e167);
                let _e173 = (_e170 * _e171);
                let _e174 = (_e123 * _e171);
                let _e175 = (_e170 * _e145);
                let _e176 = (_e123 * _e145);
                let _e177 = (_e173 * _e172);
                let _e178 = (_e174 * _e172);
                let _e179 = (_e175 * _e172);
                let _e180 = (_e176 * _e172);
                let _e181 = (_e173 * _e167);
                let _e182 = (_e174 * _e167);
                let _e183 = (_e175 * _e167);
                let _e184 = (_e176 * _e167);
                if (_e49.member_5 == 0u) {
                    let _e226 = (_e49.member_2 * _e49.member_2);
                    let _e227 = (_e147 * _e49.member_2);
                    let _e228 = (_e169 * _e226);
                    let _e229 = (_e125 + 1u);
                    let _e230 = (_e227 + _e49.member_2);
                    let _e231 = (_e228 + _e226);
                    let _e232 = (_e125 + _e227);
                    let _e233 = (_e232 + _e228);
                    let _e238 = (_e229 + _e227);
                    let _e239 = (_e238 + _e228);
                    let _e244 = (_e125 + _e230);
                    let _e245 = (_e244 + _e228);
                    let _e250 = (_e229 + _e230);
                    let _e251 = (_e250 + _e228);
                    let _e256 = (_e232 + _e231);
                    let _e261 = (_e238 + _e231);
                    let _e266 = (_e244 + _e231);
                    let _e271 = (_e250 + _e231);
                    phi_352_ = array<u32, 8>((select((_e233 - _e49.member_4), _e233, (_e233 < _e49.member_4)) + _e49.member_3), (select((_e239 - _e49.member_4), _e239, (_e239 < _e49.member_4)) + _e49.member_3), (select((_e245 - _e49.member_4), _e245, (_e245 < _e49.member_4)) + _e49.member_3), (select((_e251 - _e49.member_4), _e251, (_e251 < _e49.member_4)) + _e49.member_3), (select((_e256 - _e49.member_4), _e256, (_e256 < _e49.member_4)) + _e49.member_3), (select((_e261 - _e49.member_4), _e261, (_e261 < _e49.member_4)) + _e49.member_3), (select((_e266 - _e49.member_4), _e266, (_e266 < _e49.member_4)) + _e49.member_3), (select((_e271 - _e49.member_4), _e271, (_e271 < _e49.member_4)) + _e49.member_3));
                } else {
                    let _e189 = (_e49.member_4 - 1u);
                    let _e190 = (_e147 * 2654435761u);
                    let _e191 = (_e169 * 805459861u);
                    let _e192 = (_e125 + 1u);
                    let _e193 = (_e190 + 2654435761u);
                    let _e194 = (_e191 + 805459861u);
                    let _e195 = (_e125 ^ _e190);
                    let _e199 = (_e192 ^ _e190);
                    let _e203 = (_e125 ^ _e193);
                    let _e207 = (_e192 ^ _e193);
                    phi_352_ = array<u32, 8>((((_e195 ^ _e191) & _e189) + _e49.member_3), (((_e199 ^ _e191) & _e189) + _e49.member_3), (((_e203 ^ _e191) & _e189) + _e49.member_3), (((_e207 ^ _e191) & _e189) + _e49.member_3), (((_e195 ^ _e194) & _e189) + _e49.member_3), (((_e199 ^ _e194) & _e189) + _e49.member_3), (((_e203 ^ _e194) & _e189) + _e49.member_3), (((_e207 ^ _e194) & _e189) + _e49.member_3));
                }
                let _e278 = phi_352_;
                let _e297 = global_4.member.member_2;
                let _e302 = global_4.member.member_6;
                if _e59 {
                    break;
                }
                phi_384_ = 0u;
                phi_387_ = ((((_e60 * (_e302 * _e52)) + _e64) + _e31.x) + ((_e297 + (_e32.z * _e94)) * _e52));
                loop {
                    let _e310 = phi_384_;
                    let _e312 = phi_387_;
                    if (_e310 < _e100) {
                        let _e317 = global_6.member[((_e278[0] * _e100) + _e310)];
                        let _e318 = (_e317 & 65535u);
                        let _e329 = (_e317 >> bitcast<u32>(16i));
                        let _e344 = global_6.member[((_e278[1] * _e100) + _e310)];
                        let _e345 = (_e344 & 65535u);
                        let _e356 = (_e344 >> bitcast<u32>(16i));
                        let _e371 = global_6.member[((_e278[2] * _e100) + _e310)];
                        let _e372 = (_e371 & 65535u);
                        let _e383 = (_e371 >> bitcast<u32>(16i));
                        let _e398 = global_6.member[((_e278[3] * _e100) + _e310)];
                        let _e399 = (_e398 & 65535u);
                        let _e410 = (_e398 >> bitcast<u32>(16i));
                        let _e425 = global_6.member[((_e278[4] * _e100) + _e310)];
                        let _e426 = (_e425 & 65535u);
                        let _e437 = (_e425 >> bitcast<u32>(16i));
                        let _e452 = global_6.member[((_e278[5] * _e100) + _e310)];
                        let _e453 = (_e452 & 65535u);
                        let _e464 = (_e452 >> bitcast<u32>(16i));
                        let _e479 = global_6.member[((_e278[6] * _e100) + _e310)];
                        let _e480 = (_e479 & 65535u);
                        let _e491 = (_e479 >> bitcast<u32>(16i));
                        let _e506 = global_6.member[((_e278[7] * _e100) + _e310)];
                        let _e507 = (_e506 & 65535u);
                        let _e518 = (_e506 >> bitcast<u32>(16i));
                        global_7.member[_e312] = (((((((((bitcast<f32>((((_e318 & 32768u) << bitcast<u32>(16i)) | ((_e318 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e177) + ((bitcast<f32>((((_e345 & 32768u) << bitcast<u32>(16i)) | ((_e345 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e178)) + ((bitcast<f32>((((_e372 & 32768u) << bitcast<u32>(16i)) | ((_e372 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e179)) + ((bitcast<f32>((((_e399 & 32768u) << bitcast<u32>(16i)) | ((_e399 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e180)) + ((bitcast<f32>((((_e426 & 32768u) << bitcast<u32>(16i)) | ((_e426 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e181)) + ((bitcast<f32>((((_e453 & 32768u) << bitcast<u32>(16i)) | ((_e453 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e182)) + ((bitcast<f32>((((_e480 & 32768u) << bitcast<u32>(16i)) | ((_e480 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e183)) + ((bitcast<f32>((((_e507 & 32768u) << bitcast<u32>(16i)) | ((_e507 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e184));
                        if (((2u * _e310) + 1u) < _e94) {
                            global_7.member[(_e312 + _e52)] = (((((((((bitcast<f32>((((_e329 & 32768u) << bitcast<u32>(16i)) | ((_e329 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e177) + ((bitcast<f32>((((_e356 & 32768u) << bitcast<u32>(16i)) | ((_e356 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e178)) + ((bitcast<f32>((((_e383 & 32768u) << bitcast<u32>(16i)) | ((_e383 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e179)) + ((bitcast<f32>((((_e410 & 32768u) << bitcast<u32>(16i)) | ((_e410 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e180)) + ((bitcast<f32>((((_e437 & 32768u) << bitcast<u32>(16i)) | ((_e437 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e181)) + ((bitcast<f32>((((_e464 & 32768u) << bitcast<u32>(16i)) | ((_e464 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e182)) + ((bitcast<f32>((((_e491 & 32768u) << bitcast<u32>(16i)) | ((_e491 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e183)) + ((bitcast<f32>((((_e518 & 32768u) << bitcast<u32>(16i)) | ((_e518 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e184));
                        }
                        local = (_e310 + 1u);
                        local_1 = (_e312 + _e83);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e558 = local;
                        phi_384_ = _e558;
                        let _e561 = local_1;
                        phi_387_ = _e561;
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
