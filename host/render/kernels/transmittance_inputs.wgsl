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
    var phi_171_: u32;
    var phi_174_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_326_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e31 = global_2;
            let _e39 = (((_e30.x + (_e30.y * _e31.x)) * 64u) + _e29.x);
            let _e42 = global_3.member.member;
            if (_e39 < _e42) {
                let _e46 = global_3.member.member_1;
                let _e47 = (_e46 + _e39);
                let _e50 = global_3.member.member_3;
                phi_171_ = _e50;
                phi_174_ = 0u;
                loop {
                    let _e52 = phi_171_;
                    let _e54 = phi_174_;
                    let _e55 = (_e54 + 1u);
                    local = _e54;
                    local_1 = _e55;
                    local_2 = _e54;
                    local_3 = _e54;
                    local_4 = _e54;
                    if (_e55 < _e52) {
                        let _e58 = ((_e54 + _e52) / 2u);
                        let _e61 = global_4.member[_e58];
                        let _e62 = (_e61 <= _e47);
                        local_5 = select(_e58, _e52, _e62);
                        local_6 = select(_e54, _e58, _e62);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e349 = local_5;
                        phi_171_ = _e349;
                        let _e352 = local_6;
                        phi_174_ = _e352;
                    }
                }
                let _e67 = local;
                let _e69 = global_4.member[_e67];
                let _e72 = local_1;
                let _e74 = global_4.member[_e72];
                let _e79 = ((f32((_e47 - _e69)) + 0f) + 0.5f);
                let _e80 = f32((_e74 - _e69));
                let _e81 = (_e80 + 0f);
                let _e83 = ((_e79 + 0f) / _e81);
                let _e85 = select(0f, _e83, (_e83 > 0f));
                let _e87 = select(1f, _e85, (_e85 < 1f));
                let _e91 = (trunc((_e87 * 1024f)) * (1f / 1024f));
                let _e101 = select(0f, (((_e79 - (_e91 * _e80)) + (0f - (_e91 * 0f))) / _e81), select(false, (_e87 < 1f), (0f < _e87)));
                let _e104 = global_3.member.member_2;
                let _e107 = global_3.member.member_7;
                if (_e107 == 0u) {
                    let _e110 = local_2;
                    let _e111 = (_e110 * 4u);
                    let _e114 = global_5.member[_e111];
                    let _e118 = global_5.member[(_e111 + 1u)];
                    let _e122 = global_5.member[(_e111 + 2u)];
                    let _e126 = global_5.member[(_e111 + 3u)];
                    let _e144 = (_e122.x + ((_e91 * _e126.x) + (_e101 * (_e118.x + _e126.x))));
                    let _e146 = (_e114.x + (_e91 * _e118.x));
                    let _e150 = (1f / 4096f);
                    let _e151 = (trunc(((_e146 + _e144) * 4096f)) * _e150);
                    let _e158 = (_e122.y + ((_e91 * _e126.y) + (_e101 * (_e118.y + _e126.y))));
                    let _e160 = (_e114.y + (_e91 * _e118.y));
                    let _e164 = (trunc(((_e160 + _e158) * 4096f)) * _e150);
                    let _e171 = (_e122.z + ((_e91 * _e126.z) + (_e101 * (_e118.z + _e126.z))));
                    let _e173 = (_e114.z + (_e91 * _e118.z));
                    let _e177 = (trunc(((_e173 + _e171) * 4096f)) * _e150);
                    global_6.member[_e39] = _e151;
                    global_6.member[(_e104 + _e39)] = _e164;
                    global_6.member[((2u * _e104) + _e39)] = _e177;
                    global_6.member[((3u * _e104) + _e39)] = ((_e146 - _e151) + _e144);
                    global_6.member[((4u * _e104) + _e39)] = ((_e160 - _e164) + _e158);
                    global_6.member[((5u * _e104) + _e39)] = ((_e173 - _e177) + _e171);
                    global_6.member[((6u * _e104) + _e39)] = _e114.w;
                } else {
                    let _e206 = local_3;
                    let _e207 = (_e206 * 4u);
                    let _e210 = global_5.member[_e207];
                    let _e214 = global_5.member[(_e207 + 1u)];
                    let _e218 = global_5.member[(_e207 + 2u)];
                    let _e230 = (_e218.x + ((_e91 + _e101) * _e218.y));
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
                    let _e273 = (1f / 4096f);
                    let _e274 = (trunc(((0.5f + _e269) * 4096f)) * _e273);
                    let _e277 = (_e246 * _e268);
                    let _e281 = (trunc(((0.5f + _e277) * 4096f)) * _e273);
                    let _e284 = (_e248 * _e268);
                    let _e288 = (trunc(((0.5f + _e284) * 4096f)) * _e273);
                    global_6.member[_e39] = _e274;
                    global_6.member[(_e104 + _e39)] = _e281;
                    global_6.member[((2u * _e104) + _e39)] = _e288;
                    global_6.member[((3u * _e104) + _e39)] = ((0.5f - _e274) + _e269);
                    global_6.member[((4u * _e104) + _e39)] = ((0.5f - _e281) + _e277);
                    global_6.member[((5u * _e104) + _e39)] = ((0.5f - _e288) + _e284);
                    global_6.member[((6u * _e104) + _e39)] = _e210.w;
                }
                let _e319 = local_4;
                let _e321 = global_7.member[_e319];
                let _e324 = global_3.member.member_4;
                if (_e324 == 0u) {
                    break;
                }
                phi_326_ = 0u;
                loop {
                    let _e328 = phi_326_;
                    let _e331 = global_3.member.member_5;
                    if (_e328 < _e331) {
                        let _e337 = global_8.member[(((_e321 % _e324) * _e331) + _e328)];
                        let _e340 = global_3.member.member_6;
                        global_9.member[(((_e340 + _e328) * _e104) + _e39)] = _e337;
                        local_7 = (_e328 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e360 = local_7;
                        phi_326_ = _e360;
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
