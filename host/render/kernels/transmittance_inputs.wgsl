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
    var phi_174_: u32;
    var phi_177_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_335_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global;
            let _e34 = global_1;
            let _e35 = global_2;
            let _e43 = (((_e34.x + (_e34.y * _e35.x)) * 64u) + _e33.x);
            let _e46 = global_3.member.member;
            if (_e43 < _e46) {
                let _e50 = global_3.member.member_1;
                let _e51 = (_e50 + _e43);
                let _e54 = global_3.member.member_3;
                phi_174_ = _e54;
                phi_177_ = 0u;
                loop {
                    let _e56 = phi_174_;
                    let _e58 = phi_177_;
                    let _e59 = (_e58 + 1u);
                    local = _e58;
                    local_1 = _e59;
                    local_2 = _e58;
                    local_3 = _e58;
                    local_4 = _e58;
                    if (_e59 < _e56) {
                        let _e62 = ((_e58 + _e56) / 2u);
                        let _e65 = global_4.member[_e62];
                        let _e66 = (_e65 <= _e51);
                        local_5 = select(_e62, _e56, _e66);
                        local_6 = select(_e58, _e62, _e66);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e358 = local_5;
                        phi_174_ = _e358;
                        let _e361 = local_6;
                        phi_177_ = _e361;
                    }
                }
                let _e71 = local;
                let _e73 = global_4.member[_e71];
                let _e76 = local_1;
                let _e78 = global_4.member[_e76];
                let _e83 = ((f32((_e51 - _e73)) + 0f) + 0.5f);
                let _e84 = f32((_e78 - _e73));
                let _e85 = (_e84 + 0f);
                let _e87 = ((_e83 + 0f) / _e85);
                let _e89 = select(0f, _e87, (_e87 > 0f));
                let _e91 = select(1f, _e89, (_e89 < 1f));
                let _e95 = (trunc((_e91 * 1024f)) * (1f / 1024f));
                let _e98 = bitcast<u32>(_e95);
                let _e110 = select(0f, (((_e83 - (_e95 * _e84)) + (0f - bitcast<f32>(select(2143289344u, (_e98 & 2147483648u), ((_e98 & 2147483647u) < 2139095040u))))) / _e85), select(false, (_e91 < 1f), (0f < _e91)));
                let _e113 = global_3.member.member_2;
                let _e116 = global_3.member.member_7;
                if (_e116 == 0u) {
                    let _e119 = local_2;
                    let _e120 = (_e119 * 4u);
                    let _e123 = global_5.member[_e120];
                    let _e127 = global_5.member[(_e120 + 1u)];
                    let _e131 = global_5.member[(_e120 + 2u)];
                    let _e135 = global_5.member[(_e120 + 3u)];
                    let _e153 = (_e131.x + ((_e95 * _e135.x) + (_e110 * (_e127.x + _e135.x))));
                    let _e155 = (_e123.x + (_e95 * _e127.x));
                    let _e159 = (1f / 4096f);
                    let _e160 = (trunc(((_e155 + _e153) * 4096f)) * _e159);
                    let _e167 = (_e131.y + ((_e95 * _e135.y) + (_e110 * (_e127.y + _e135.y))));
                    let _e169 = (_e123.y + (_e95 * _e127.y));
                    let _e173 = (trunc(((_e169 + _e167) * 4096f)) * _e159);
                    let _e180 = (_e131.z + ((_e95 * _e135.z) + (_e110 * (_e127.z + _e135.z))));
                    let _e182 = (_e123.z + (_e95 * _e127.z));
                    let _e186 = (trunc(((_e182 + _e180) * 4096f)) * _e159);
                    global_6.member[_e43] = _e160;
                    global_6.member[(_e113 + _e43)] = _e173;
                    global_6.member[((2u * _e113) + _e43)] = _e186;
                    global_6.member[((3u * _e113) + _e43)] = ((_e155 - _e160) + _e153);
                    global_6.member[((4u * _e113) + _e43)] = ((_e169 - _e173) + _e167);
                    global_6.member[((5u * _e113) + _e43)] = ((_e182 - _e186) + _e180);
                    global_6.member[((6u * _e113) + _e43)] = _e123.w;
                } else {
                    let _e215 = local_3;
                    let _e216 = (_e215 * 4u);
                    let _e219 = global_5.member[_e216];
                    let _e223 = global_5.member[(_e216 + 1u)];
                    let _e227 = global_5.member[(_e216 + 2u)];
                    let _e239 = (_e227.x + ((_e95 + _e110) * _e227.y));
                    let _e240 = (_e239 < 0f);
                    let _e242 = select(_e239, -(_e239), _e240);
                    let _e247 = (_e223.w / (2f - (select(_e223.w, _e242, (_e242 > _e223.w)) / _e223.w)));
                    let _e251 = select(select(_e247, -(_e247), _e240), _e239, (_e242 <= _e223.w));
                    let _e253 = (_e219.x + (_e251 * _e223.x));
                    let _e255 = (_e219.y + (_e251 * _e223.y));
                    let _e257 = (_e219.z + (_e251 * _e223.z));
                    let _e260 = select(_e253, -(_e253), (_e253 < 0f));
                    let _e263 = select(_e255, -(_e255), (_e255 < 0f));
                    let _e265 = select(_e263, _e260, (_e260 > _e263));
                    let _e268 = select(_e257, -(_e257), (_e257 < 0f));
                    let _e270 = select(_e268, _e265, (_e265 > _e268));
                    let _e272 = select(0.25f, _e270, (_e270 > 0.25f));
                    let _e277 = select(1f, ((0.5f - (0.0625f / _e272)) / _e272), (0.25f < _e272));
                    let _e278 = (_e253 * _e277);
                    let _e282 = (1f / 4096f);
                    let _e283 = (trunc(((0.5f + _e278) * 4096f)) * _e282);
                    let _e286 = (_e255 * _e277);
                    let _e290 = (trunc(((0.5f + _e286) * 4096f)) * _e282);
                    let _e293 = (_e257 * _e277);
                    let _e297 = (trunc(((0.5f + _e293) * 4096f)) * _e282);
                    global_6.member[_e43] = _e283;
                    global_6.member[(_e113 + _e43)] = _e290;
                    global_6.member[((2u * _e113) + _e43)] = _e297;
                    global_6.member[((3u * _e113) + _e43)] = ((0.5f - _e283) + _e278);
                    global_6.member[((4u * _e113) + _e43)] = ((0.5f - _e290) + _e286);
                    global_6.member[((5u * _e113) + _e43)] = ((0.5f - _e297) + _e293);
                    global_6.member[((6u * _e113) + _e43)] = _e219.w;
                }
                let _e328 = local_4;
                let _e330 = global_7.member[_e328];
                let _e333 = global_3.member.member_4;
                if (_e333 == 0u) {
                    break;
                }
                phi_335_ = 0u;
                loop {
                    let _e337 = phi_335_;
                    let _e340 = global_3.member.member_5;
                    if (_e337 < _e340) {
                        let _e346 = global_8.member[(((_e330 % _e333) * _e340) + _e337)];
                        let _e349 = global_3.member.member_6;
                        global_9.member[(((_e349 + _e337) * _e113) + _e43)] = _e346;
                        local_7 = (_e337 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e369 = local_7;
                        phi_335_ = _e369;
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
