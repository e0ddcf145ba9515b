struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;
@group(0) @binding(1) 
var<storage> global_7: type_10;
@group(0) @binding(4) 
var<storage> global_8: type_20;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_20;

fn function_() {
    var phi_164_: u32;
    var phi_167_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_319_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = global;
            let _e32 = global_1;
            let _e33 = global_2;
            let _e41 = (((_e32.x + (_e32.y * _e33.x)) * 64u) + _e31.x);
            let _e44 = global_3.member.member;
            if (_e41 < _e44) {
                let _e48 = global_3.member.member_1;
                let _e49 = (_e48 + _e41);
                let _e52 = global_3.member.member_3;
                phi_164_ = _e52;
                phi_167_ = 0u;
                loop {
                    let _e54 = phi_164_;
                    let _e56 = phi_167_;
                    let _e57 = (_e56 + 1u);
                    local = _e56;
                    local_1 = _e57;
                    local_2 = _e56;
                    local_3 = _e56;
                    local_4 = _e56;
                    if (_e57 < _e54) {
                        let _e60 = ((_e56 + _e54) / 2u);
                        let _e63 = global_4.member[_e60];
                        let _e64 = (_e63 <= _e49);
                        local_5 = select(_e60, _e54, _e64);
                        local_6 = select(_e56, _e60, _e64);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e342 = local_5;
                        phi_164_ = _e342;
                        let _e345 = local_6;
                        phi_167_ = _e345;
                    }
                }
                let _e69 = local;
                let _e71 = global_4.member[_e69];
                let _e74 = local_1;
                let _e76 = global_4.member[_e74];
                let _e80 = (f32((_e49 - _e71)) + 0.5f);
                let _e81 = f32((_e76 - _e71));
                let _e82 = (_e80 / _e81);
                let _e84 = select(0f, _e82, (_e82 > 0f));
                let _e86 = select(1f, _e84, (_e84 < 1f));
                let _e89 = (trunc((_e86 * 1024f)) * 0.0009765625f);
                let _e96 = select(0f, ((_e80 - (_e89 * _e81)) / _e81), select(false, (_e86 < 1f), (0f < _e86)));
                let _e99 = global_3.member.member_2;
                let _e102 = global_3.member.member_7;
                if (_e102 == 0u) {
                    let _e105 = local_2;
                    let _e106 = (_e105 * 4u);
                    let _e109 = global_5.member[_e106];
                    let _e113 = global_5.member[(_e106 + 1u)];
                    let _e117 = global_5.member[(_e106 + 2u)];
                    let _e121 = global_5.member[(_e106 + 3u)];
                    let _e139 = (_e117.x + ((_e89 * _e121.x) + (_e96 * (_e113.x + _e121.x))));
                    let _e141 = (_e109.x + (_e89 * _e113.x));
                    let _e145 = (trunc(((_e141 + _e139) * 4096f)) * 0.00024414063f);
                    let _e152 = (_e117.y + ((_e89 * _e121.y) + (_e96 * (_e113.y + _e121.y))));
                    let _e154 = (_e109.y + (_e89 * _e113.y));
                    let _e158 = (trunc(((_e154 + _e152) * 4096f)) * 0.00024414063f);
                    let _e165 = (_e117.z + ((_e89 * _e121.z) + (_e96 * (_e113.z + _e121.z))));
                    let _e167 = (_e109.z + (_e89 * _e113.z));
                    let _e171 = (trunc(((_e167 + _e165) * 4096f)) * 0.00024414063f);
                    global_6.member[_e41] = _e145;
                    global_6.member[(_e99 + _e41)] = _e158;
                    global_6.member[((2u * _e99) + _e41)] = _e171;
                    global_6.member[((3u * _e99) + _e41)] = ((_e141 - _e145) + _e139);
                    global_6.member[((4u * _e99) + _e41)] = ((_e154 - _e158) + _e152);
                    global_6.member[((5u * _e99) + _e41)] = ((_e167 - _e171) + _e165);
                    global_6.member[((6u * _e99) + _e41)] = _e109.w;
                } else {
                    let _e200 = local_3;
                    let _e201 = (_e200 * 4u);
                    let _e204 = global_5.member[_e201];
                    let _e208 = global_5.member[(_e201 + 1u)];
                    let _e212 = global_5.member[(_e201 + 2u)];
                    let _e224 = (_e212.x + ((_e89 + _e96) * _e212.y));
                    let _e225 = (_e224 < 0f);
                    let _e227 = select(_e224, -(_e224), _e225);
                    let _e232 = (_e208.w / (2f - (select(_e208.w, _e227, (_e227 > _e208.w)) / _e208.w)));
                    let _e236 = select(select(_e232, -(_e232), _e225), _e224, (_e227 <= _e208.w));
                    let _e238 = (_e204.x + (_e236 * _e208.x));
                    let _e240 = (_e204.y + (_e236 * _e208.y));
                    let _e242 = (_e204.z + (_e236 * _e208.z));
                    let _e245 = select(_e238, -(_e238), (_e238 < 0f));
                    let _e248 = select(_e240, -(_e240), (_e240 < 0f));
                    let _e250 = select(_e248, _e245, (_e245 > _e248));
                    let _e253 = select(_e242, -(_e242), (_e242 < 0f));
                    let _e255 = select(_e253, _e250, (_e250 > _e253));
                    let _e257 = select(0.25f, _e255, (_e255 > 0.25f));
                    let _e262 = select(1f, ((0.5f - (0.0625f / _e257)) / _e257), (0.25f < _e257));
                    let _e263 = (_e238 * _e262);
                    let _e267 = (trunc(((0.5f + _e263) * 4096f)) * 0.00024414063f);
                    let _e270 = (_e240 * _e262);
                    let _e274 = (trunc(((0.5f + _e270) * 4096f)) * 0.00024414063f);
                    let _e277 = (_e242 * _e262);
                    let _e281 = (trunc(((0.5f + _e277) * 4096f)) * 0.00024414063f);
                    global_6.member[_e41] = _e267;
                    global_6.member[(_e99 + _e41)] = _e274;
                    global_6.member[((2u * _e99) + _e41)] = _e281;
                    global_6.member[((3u * _e99) + _e41)] = ((0.5f - _e267) + _e263);
                    global_6.member[((4u * _e99) + _e41)] = ((0.5f - _e274) + _e270);
                    global_6.member[((5u * _e99) + _e41)] = ((0.5f - _e281) + _e277);
                    global_6.member[((6u * _e99) + _e41)] = _e204.w;
                }
                let _e312 = local_4;
                let _e314 = global_7.member[_e312];
                let _e317 = global_3.member.member_4;
                if (_e317 == 0u) {
                    break;
                }
                phi_319_ = 0u;
                loop {
                    let _e321 = phi_319_;
                    let _e324 = global_3.member.member_5;
                    if (_e321 < _e324) {
                        let _e330 = global_8.member[(((_e314 % _e317) * _e324) + _e321)];
                        let _e333 = global_3.member.member_6;
                        global_9.member[(((_e333 + _e321) * _e99) + _e41)] = _e330;
                        local_7 = (_e321 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e353 = local_7;
                        phi_319_ = _e353;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_inputs(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
