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
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_320_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

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
                    let _e58 = (_e57 + 1u);
                    local = _e57;
                    local_1 = _e58;
                    local_2 = _e57;
                    local_3 = _e57;
                    local_4 = _e57;
                    if (_e58 < _e55) {
                        let _e61 = ((_e57 + _e55) / 2u);
                        let _e64 = global_5.member[_e61];
                        let _e65 = (_e64 <= _e50);
                        local_5 = select(_e61, _e55, _e65);
                        local_6 = select(_e57, _e61, _e65);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e343 = local_5;
                        phi_165_ = _e343;
                        let _e346 = local_6;
                        phi_168_ = _e346;
                    }
                }
                let _e70 = local;
                let _e72 = global_5.member[_e70];
                let _e75 = local_1;
                let _e77 = global_5.member[_e75];
                let _e81 = (f32((_e50 - _e72)) + 0.5f);
                let _e82 = f32((_e77 - _e72));
                let _e83 = (_e81 / _e82);
                let _e85 = select(0f, _e83, (_e83 > 0f));
                let _e87 = select(1f, _e85, (_e85 < 1f));
                let _e90 = (trunc((_e87 * 1024f)) * 0.0009765625f);
                let _e97 = select(0f, ((_e81 - (_e90 * _e82)) / _e82), select(false, (_e87 < 1f), (0f < _e87)));
                let _e100 = global_4.member.member_2;
                let _e103 = global_4.member.member_7;
                if (_e103 == 0u) {
                    let _e106 = local_2;
                    let _e107 = (_e106 * 4u);
                    let _e110 = global_6.member[_e107];
                    let _e114 = global_6.member[(_e107 + 1u)];
                    let _e118 = global_6.member[(_e107 + 2u)];
                    let _e122 = global_6.member[(_e107 + 3u)];
                    let _e140 = (_e118.x + ((_e90 * _e122.x) + (_e97 * (_e114.x + _e122.x))));
                    let _e142 = (_e110.x + (_e90 * _e114.x));
                    let _e146 = (trunc(((_e142 + _e140) * 4096f)) * 0.00024414063f);
                    let _e153 = (_e118.y + ((_e90 * _e122.y) + (_e97 * (_e114.y + _e122.y))));
                    let _e155 = (_e110.y + (_e90 * _e114.y));
                    let _e159 = (trunc(((_e155 + _e153) * 4096f)) * 0.00024414063f);
                    let _e166 = (_e118.z + ((_e90 * _e122.z) + (_e97 * (_e114.z + _e122.z))));
                    let _e168 = (_e110.z + (_e90 * _e114.z));
                    let _e172 = (trunc(((_e168 + _e166) * 4096f)) * 0.00024414063f);
                    global_8.member[_e42] = _e146;
                    global_8.member[(_e100 + _e42)] = _e159;
                    global_8.member[((2u * _e100) + _e42)] = _e172;
                    global_8.member[((3u * _e100) + _e42)] = ((_e142 - _e146) + _e140);
                    global_8.member[((4u * _e100) + _e42)] = ((_e155 - _e159) + _e153);
                    global_8.member[((5u * _e100) + _e42)] = ((_e168 - _e172) + _e166);
                    global_8.member[((6u * _e100) + _e42)] = _e110.w;
                } else {
                    let _e201 = local_3;
                    let _e202 = (_e201 * 4u);
                    let _e205 = global_6.member[_e202];
                    let _e209 = global_6.member[(_e202 + 1u)];
                    let _e213 = global_6.member[(_e202 + 2u)];
                    let _e225 = (_e213.x + ((_e90 + _e97) * _e213.y));
                    let _e226 = (_e225 < 0f);
                    let _e228 = select(_e225, -(_e225), _e226);
                    let _e233 = (_e209.w / (2f - (select(_e209.w, _e228, (_e228 > _e209.w)) / _e209.w)));
                    let _e237 = select(select(_e233, -(_e233), _e226), _e225, (_e228 <= _e209.w));
                    let _e239 = (_e205.x + (_e237 * _e209.x));
                    let _e241 = (_e205.y + (_e237 * _e209.y));
                    let _e243 = (_e205.z + (_e237 * _e209.z));
                    let _e246 = select(_e239, -(_e239), (_e239 < 0f));
                    let _e249 = select(_e241, -(_e241), (_e241 < 0f));
                    let _e251 = select(_e249, _e246, (_e246 > _e249));
                    let _e254 = select(_e243, -(_e243), (_e243 < 0f));
                    let _e256 = select(_e254, _e251, (_e251 > _e254));
                    let _e258 = select(0.25f, _e256, (_e256 > 0.25f));
                    let _e263 = select(1f, ((0.5f - (0.0625f / _e258)) / _e258), (0.25f < _e258));
                    let _e264 = (_e239 * _e263);
                    let _e268 = (trunc(((0.5f + _e264) * 4096f)) * 0.00024414063f);
                    let _e271 = (_e241 * _e263);
                    let _e275 = (trunc(((0.5f + _e271) * 4096f)) * 0.00024414063f);
                    let _e278 = (_e243 * _e263);
                    let _e282 = (trunc(((0.5f + _e278) * 4096f)) * 0.00024414063f);
                    global_8.member[_e42] = _e268;
                    global_8.member[(_e100 + _e42)] = _e275;
                    global_8.member[((2u * _e100) + _e42)] = _e282;
                    global_8.member[((3u * _e100) + _e42)] = ((0.5f - _e268) + _e264);
                    global_8.member[((4u * _e100) + _e42)] = ((0.5f - _e275) + _e271);
                    global_8.member[((5u * _e100) + _e42)] = ((0.5f - _e282) + _e278);
                    global_8.member[((6u * _e100) + _e42)] = _e205.w;
                }
                let _e313 = local_4;
                let _e315 = global_3.member[_e313];
                let _e318 = global_4.member.member_4;
                if (_e318 == 0u) {
                    break;
                }
                phi_320_ = 0u;
                loop {
                    let _e322 = phi_320_;
                    let _e325 = global_4.member.member_5;
                    if (_e322 < _e325) {
                        let _e331 = global_7.member[(((_e315 % _e318) * _e325) + _e322)];
                        let _e334 = global_4.member.member_6;
                        global_9.member[(((_e334 + _e322) * _e100) + _e42)] = _e331;
                        local_7 = (_e322 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e354 = local_7;
                        phi_320_ = _e354;
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
