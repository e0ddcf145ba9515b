struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
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

struct type_22 {
    member: f32,
    member_1: f32,
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
@group(0) @binding(1) 
var<storage> global_6: type_10;
@group(0) @binding(5) 
var<storage> global_7: type_20;
@group(0) @binding(6) 
var<storage> global_8: type_20;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_20;
@group(0) @binding(4) 
var<storage> global_10: type_20;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_20;

fn function_() {
    var phi_180_: u32;
    var phi_183_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_306_: array<type_22, 3>;
    var phi_332_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e37 = global_1;
            let _e38 = global_2;
            let _e46 = (((_e37.x + (_e37.y * _e38.x)) * 64u) + _e36.x);
            let _e49 = global_3.member.member;
            if (_e46 < _e49) {
                let _e53 = global_3.member.member_1;
                let _e54 = (_e53 + _e46);
                let _e57 = global_3.member.member_3;
                phi_180_ = _e57;
                phi_183_ = 0u;
                loop {
                    let _e59 = phi_180_;
                    let _e61 = phi_183_;
                    local = _e61;
                    local_1 = _e61;
                    local_2 = _e61;
                    if ((_e61 + 1u) < _e59) {
                        let _e65 = ((_e61 + _e59) / 2u);
                        let _e68 = global_4.member[_e65];
                        let _e69 = (_e68 <= _e54);
                        local_3 = select(_e65, _e59, _e69);
                        local_4 = select(_e61, _e65, _e69);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e344 = local_3;
                        phi_180_ = _e344;
                        let _e347 = local_4;
                        phi_183_ = _e347;
                    }
                }
                let _e74 = local;
                let _e76 = global_4.member[_e74];
                let _e81 = local_1;
                let _e82 = (_e81 * 4u);
                let _e85 = global_5.member[_e82];
                let _e93 = global_5.member[(_e82 + 1u)];
                let _e101 = global_5.member[(_e82 + 2u)];
                let _e108 = global_5.member[(_e82 + 3u)];
                let _e115 = local_2;
                let _e117 = global_6.member[_e115];
                let _e120 = global_3.member.member_4;
                if (_e120 == 0u) {
                    break;
                }
                let _e125 = global_3.member.member_5;
                let _e129 = global_3.member.member_8;
                if (_e129 == 0u) {
                    phi_246_ = (f32((_e54 - _e76)) + 0f);
                    phi_247_ = _e85.w;
                } else {
                    let _e133 = global_7.member[_e54];
                    let _e136 = global_8.member[_e54];
                    phi_246_ = _e133;
                    phi_247_ = (_e85.w * _e136);
                }
                let _e139 = phi_246_;
                let _e141 = phi_247_;
                let _e144 = global_3.member.member_2;
                let _e147 = global_3.member.member_7;
                let _e148 = (_e139 + 0.5f);
                let _e149 = (_e108.w + 0f);
                let _e151 = ((_e148 + 0f) / _e149);
                let _e153 = select(0f, _e151, (_e151 > 0f));
                let _e155 = select(1f, _e153, (_e153 < 1f));
                let _e159 = (trunc((_e155 * 1024f)) * (1f / 1024f));
                let _e162 = bitcast<u32>(_e159);
                let _e174 = select(0f, (((_e148 - (_e159 * _e108.w)) + (0f - bitcast<f32>(select(2143289344u, (_e162 & 2147483648u), ((_e162 & 2147483647u) < 2139095040u))))) / _e149), select(false, (_e155 < 1f), (0f < _e155)));
                if (_e147 == 0u) {
                    let _e180 = (_e101.x + ((_e159 * _e108.x) + (_e174 * (_e93.x + _e108.x))));
                    let _e182 = (_e85.x + (_e159 * _e93.x));
                    let _e186 = (1f / 4096f);
                    let _e187 = (trunc(((_e182 + _e180) * 4096f)) * _e186);
                    let _e194 = (_e101.y + ((_e159 * _e108.y) + (_e174 * (_e93.y + _e108.y))));
                    let _e196 = (_e85.y + (_e159 * _e93.y));
                    let _e200 = (trunc(((_e196 + _e194) * 4096f)) * _e186);
                    let _e207 = (_e101.z + ((_e159 * _e108.z) + (_e174 * (_e93.z + _e108.z))));
                    let _e209 = (_e85.z + (_e159 * _e93.z));
                    let _e213 = (trunc(((_e209 + _e207) * 4096f)) * _e186);
                    phi_306_ = array<type_22, 3>(type_22(_e187, ((_e182 - _e187) + _e180)), type_22(_e200, ((_e196 - _e200) + _e194)), type_22(_e213, ((_e209 - _e213) + _e207)));
                } else {
                    let _e222 = (_e101.x + ((_e159 + _e174) * _e101.y));
                    let _e223 = (_e222 < 0f);
                    let _e225 = select(_e222, -(_e222), _e223);
                    let _e230 = (_e93.w / (2f - (select(_e93.w, _e225, (_e225 > _e93.w)) / _e93.w)));
                    let _e234 = select(select(_e230, -(_e230), _e223), _e222, (_e225 <= _e93.w));
                    let _e236 = (_e85.x + (_e234 * _e93.x));
                    let _e238 = (_e85.y + (_e234 * _e93.y));
                    let _e240 = (_e85.z + (_e234 * _e93.z));
                    let _e243 = select(_e236, -(_e236), (_e236 < 0f));
                    let _e246 = select(_e238, -(_e238), (_e238 < 0f));
                    let _e248 = select(_e246, _e243, (_e243 > _e246));
                    let _e251 = select(_e240, -(_e240), (_e240 < 0f));
                    let _e253 = select(_e251, _e248, (_e248 > _e251));
                    let _e255 = select(0.25f, _e253, (_e253 > 0.25f));
                    let _e260 = select(1f, ((0.5f - (0.0625f / _e255)) / _e255), (0.25f < _e255));
                    let _e261 = (_e236 * _e260);
                    let _e265 = (1f / 4096f);
                    let _e266 = (trunc(((0.5f + _e261) * 4096f)) * _e265);
                    let _e269 = (_e238 * _e260);
                    let _e273 = (trunc(((0.5f + _e269) * 4096f)) * _e265);
                    let _e276 = (_e240 * _e260);
                    let _e280 = (trunc(((0.5f + _e276) * 4096f)) * _e265);
                    phi_306_ = array<type_22, 3>(type_22(_e266, ((0.5f - _e266) + _e261)), type_22(_e273, ((0.5f - _e273) + _e269)), type_22(_e280, ((0.5f - _e280) + _e276)));
                }
                let _e288 = phi_306_;
                global_9.member[_e46] = _e288[0].member;
                global_9.member[(_e144 + _e46)] = _e288[1].member;
                global_9.member[((2u * _e144) + _e46)] = _e288[2].member;
                global_9.member[((3u * _e144) + _e46)] = _e288[0].member_1;
                global_9.member[((4u * _e144) + _e46)] = _e288[1].member_1;
                global_9.member[((5u * _e144) + _e46)] = _e288[2].member_1;
                global_9.member[((6u * _e144) + _e46)] = _e141;
                phi_332_ = 0u;
                loop {
                    let _e327 = phi_332_;
                    if (_e327 < _e125) {
                        let _e332 = global_10.member[(((_e117 % _e120) * _e125) + _e327)];
                        let _e335 = global_3.member.member_6;
                        global_11.member[(((_e335 + _e327) * _e144) + _e46)] = _e332;
                        local_5 = (_e327 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e356 = local_5;
                        phi_332_ = _e356;
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
