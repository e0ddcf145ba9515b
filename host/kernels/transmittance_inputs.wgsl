struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_20 {
    member: type_19,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_11;
@group(0) @binding(0) 
var<uniform> global_4: type_20;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_5;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_5;

fn function_() {
    var phi_165_: u32;
    var phi_168_: u32;
    var phi_166_: u32;
    var phi_169_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_325_: u32;
    var phi_326_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = global;
            let _e33 = global_1;
            let _e34 = global_2;
            let _e42 = (((_e33.x + (_e33.y * _e34.x)) * 64u) + _e32.x);
            let _e45 = global_4.member.member;
            if (_e42 < _e45) {
                let _e49 = global_4.member.member_1;
                let _e50 = (_e49 + _e42);
                let _e53 = global_4.member.member_3;
                phi_165_ = _e53;
                phi_168_ = 0u;
                loop {
                    let _e55 = phi_165_;
                    let _e57 = phi_168_;
                    local = _e57;
                    local_2 = _e57;
                    local_3 = _e57;
                    local_4 = _e57;
                    let _e58 = (_e57 + 1u);
                    let _e59 = (_e58 < _e55);
                    local_1 = _e58;
                    if _e59 {
                        let _e61 = ((_e57 + _e55) / 2u);
                        let _e64 = global_5.member[_e61];
                        let _e65 = (_e64 <= _e50);
                        phi_166_ = select(_e61, _e55, _e65);
                        phi_169_ = select(_e57, _e61, _e65);
                    } else {
                        phi_166_ = u32();
                        phi_169_ = u32();
                    }
                    let _e69 = phi_166_;
                    let _e71 = phi_169_;
                    continue;
                    continuing {
                        phi_165_ = _e69;
                        phi_168_ = _e71;
                        break if !(_e59);
                    }
                }
                let _e75 = local;
                let _e77 = global_5.member[_e75];
                let _e80 = local_1;
                let _e82 = global_5.member[_e80];
                let _e86 = (f32((_e50 - _e77)) + 0.5f);
                let _e87 = f32((_e82 - _e77));
                let _e88 = (_e86 / _e87);
                let _e90 = select(0f, _e88, (_e88 > 0f));
                let _e92 = select(1f, _e90, (_e90 < 1f));
                let _e95 = (trunc((_e92 * 1024f)) * 0.0009765625f);
                let _e102 = select(0f, ((_e86 - (_e95 * _e87)) / _e87), select(false, (_e92 < 1f), (0f < _e92)));
                let _e105 = global_4.member.member_2;
                let _e108 = global_4.member.member_7;
                if (_e108 == 0u) {
                    let _e111 = local_2;
                    let _e112 = (_e111 * 4u);
                    let _e115 = global_6.member[_e112];
                    let _e119 = global_6.member[(_e112 + 1u)];
                    let _e123 = global_6.member[(_e112 + 2u)];
                    let _e127 = global_6.member[(_e112 + 3u)];
                    let _e145 = (_e123.x + ((_e95 * _e127.x) + (_e102 * (_e119.x + _e127.x))));
                    let _e147 = (_e115.x + (_e95 * _e119.x));
                    let _e151 = (trunc(((_e147 + _e145) * 4096f)) * 0.00024414063f);
                    let _e158 = (_e123.y + ((_e95 * _e127.y) + (_e102 * (_e119.y + _e127.y))));
                    let _e160 = (_e115.y + (_e95 * _e119.y));
                    let _e164 = (trunc(((_e160 + _e158) * 4096f)) * 0.00024414063f);
                    let _e171 = (_e123.z + ((_e95 * _e127.z) + (_e102 * (_e119.z + _e127.z))));
                    let _e173 = (_e115.z + (_e95 * _e119.z));
                    let _e177 = (trunc(((_e173 + _e171) * 4096f)) * 0.00024414063f);
                    global_8.member[_e42] = _e151;
                    global_8.member[(_e105 + _e42)] = _e164;
                    global_8.member[((2u * _e105) + _e42)] = _e177;
                    global_8.member[((3u * _e105) + _e42)] = ((_e147 - _e151) + _e145);
                    global_8.member[((4u * _e105) + _e42)] = ((_e160 - _e164) + _e158);
                    global_8.member[((5u * _e105) + _e42)] = ((_e173 - _e177) + _e171);
                    global_8.member[((6u * _e105) + _e42)] = _e115.w;
                } else {
                    let _e206 = local_3;
                    let _e207 = (_e206 * 4u);
                    let _e210 = global_6.member[_e207];
                    let _e214 = global_6.member[(_e207 + 1u)];
                    let _e218 = global_6.member[(_e207 + 2u)];
                    let _e230 = (_e218.x + ((_e95 + _e102) * _e218.y));
                    let _e231 = (_e230 < 0f);
                    let _e233 = select(_e230, -(_e230), _e231);
                    let _e238 = (_e214.w / (2f - (select(_e214.w, _e233, (_e233 > _e214.w)) / _e214.w)));
                    let _e242 = select(select(_e238, -(_e238), _e231), _e230, (_e233 <= _e214.w));
                    let _e244 = (_e210.x + (_e242 * _e214.x));
                    let _e246 = (_e210.y + (_e242 * _e214.y));
                    let _e248 = (_e210.z + (_e242 * _e214.z));
                    let _e251 = select(_e244, -(_e244), (_e244 < 0f));
                    let _e254 = select(_e246, -(_e246), (_e246 < 0f));
                    let _e256 = select(_e254, _e251, (_e251 > _e254));
                    let _e259 = select(_e248, -(_e248), (_e248 < 0f));
                    let _e261 = select(_e259, _e256, (_e256 > _e259));
                    let _e263 = select(0.25f, _e261, (_e261 > 0.25f));
                    let _e268 = select(1f, ((0.5f - (0.0625f / _e263)) / _e263), (0.25f < _e263));
                    let _e269 = (_e244 * _e268);
                    let _e273 = (trunc(((0.5f + _e269) * 4096f)) * 0.00024414063f);
                    let _e276 = (_e246 * _e268);
                    let _e280 = (trunc(((0.5f + _e276) * 4096f)) * 0.00024414063f);
                    let _e283 = (_e248 * _e268);
                    let _e287 = (trunc(((0.5f + _e283) * 4096f)) * 0.00024414063f);
                    global_8.member[_e42] = _e273;
                    global_8.member[(_e105 + _e42)] = _e280;
                    global_8.member[((2u * _e105) + _e42)] = _e287;
                    global_8.member[((3u * _e105) + _e42)] = ((0.5f - _e273) + _e269);
                    global_8.member[((4u * _e105) + _e42)] = ((0.5f - _e280) + _e276);
                    global_8.member[((5u * _e105) + _e42)] = ((0.5f - _e287) + _e283);
                    global_8.member[((6u * _e105) + _e42)] = _e210.w;
                }
                let _e318 = local_4;
                let _e320 = global_3.member[_e318];
                let _e323 = global_4.member.member_4;
                if (_e323 == 0u) {
                    break;
                }
                phi_325_ = 0u;
                loop {
                    let _e327 = phi_325_;
                    let _e330 = global_4.member.member_5;
                    let _e331 = (_e327 < _e330);
                    if _e331 {
                        let _e336 = global_7.member[(((_e320 % _e323) * _e330) + _e327)];
                        let _e339 = global_4.member.member_6;
                        global_9.member[(((_e339 + _e327) * _e105) + _e42)] = _e336;
                        phi_326_ = (_e327 + 1u);
                    } else {
                        phi_326_ = u32();
                    }
                    let _e347 = phi_326_;
                    continue;
                    continuing {
                        phi_325_ = _e347;
                        break if !(_e331);
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
