struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<f32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_5;
@group(0) @binding(1) 
var<storage> global_3: type_12;
@group(0) @binding(3) 
var<storage> global_4: type_16;
@group(0) @binding(2) 
var<storage> global_5: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_12;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_243_: vec4<f32>;
    var phi_246_: vec4<f32>;
    var phi_248_: vec4<f32>;
    var phi_250_: vec4<f32>;
    var phi_252_: u32;
    var phi_254_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var phi_343_: vec4<f32>;
    var phi_344_: vec4<f32>;
    var phi_345_: vec4<f32>;
    var phi_346_: f32;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: u32;
    var local_18: u32;

    let _e23 = global;
    let _e24 = global_1;
    let _e30 = ((_e24.x * 8u) + _e23.x);
    let _e32 = ((_e24.y * 8u) + _e23.y);
    let _e35 = global_2.member.member;
    if (_e30 < _e35) {
        if (_e32 < _e35) {
            let _e40 = ((_e24.z * _e35) * _e35);
            let _e42 = select(5u, _e32, (_e32 > 5u));
            let _e44 = (_e32 + 6u);
            phi_243_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_246_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_248_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_250_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_252_ = (((_e40 + ((_e42 - 5u) * _e35)) + _e30) * 4u);
            phi_254_ = (_e42 - _e32);
            loop {
                let _e57 = phi_243_;
                let _e59 = phi_246_;
                let _e61 = phi_248_;
                let _e63 = phi_250_;
                let _e65 = phi_252_;
                let _e67 = phi_254_;
                local = _e63;
                local_1 = _e63;
                local_2 = _e63;
                local_3 = _e63;
                local_4 = _e61;
                local_5 = _e61;
                local_6 = _e61;
                local_7 = _e59;
                local_8 = _e59;
                local_9 = _e59;
                local_10 = _e57;
                local_11 = _e57;
                local_12 = _e57;
                if (_e65 < (((_e40 + (select(_e44, _e35, (_e35 < _e44)) * _e35)) + _e30) * 4u)) {
                    let _e71 = global_3.member[_e67];
                    let _e74 = global_4.member[_e65];
                    let _e95 = global_4.member[(_e65 + 1u)];
                    let _e116 = global_4.member[(_e65 + 2u)];
                    let _e137 = global_4.member[(_e65 + 3u)];
                    local_13 = vec4<f32>((_e57.x + (_e137.x * _e71)), (_e57.y + (_e137.y * _e71)), (_e57.z + (_e137.z * _e71)), (_e57.w + (_e137.w * _e71)));
                    local_14 = vec4<f32>((_e59.x + (_e116.x * _e71)), (_e59.y + (_e116.y * _e71)), (_e59.z + (_e116.z * _e71)), (_e59.w + (_e116.w * _e71)));
                    local_15 = vec4<f32>((_e61.x + (_e95.x * _e71)), (_e61.y + (_e95.y * _e71)), (_e61.z + (_e95.z * _e71)), (_e61.w + (_e95.w * _e71)));
                    local_16 = vec4<f32>((_e63.x + (_e74.x * _e71)), (_e63.y + (_e74.y * _e71)), (_e63.z + (_e74.z * _e71)), (_e63.w + (_e74.w * _e71)));
                    local_17 = (_e65 + (_e35 * 4u));
                    local_18 = (_e67 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e367 = local_13;
                    phi_243_ = _e367;
                    let _e370 = local_14;
                    phi_246_ = _e370;
                    let _e373 = local_15;
                    phi_248_ = _e373;
                    let _e376 = local_16;
                    phi_250_ = _e376;
                    let _e379 = local_17;
                    phi_252_ = _e379;
                    let _e382 = local_18;
                    phi_254_ = _e382;
                }
            }
            let _e160 = ((_e40 + (_e32 * _e35)) + _e30);
            let _e163 = global_5.member[_e160];
            if (_e163.w > 0f) {
                let _e167 = local;
                let _e169 = (1f / _e167.w);
                let _e171 = local_1;
                let _e173 = (_e171.x * _e169);
                let _e175 = local_2;
                let _e177 = (_e175.y * _e169);
                let _e179 = local_3;
                let _e181 = (_e179.z * _e169);
                let _e183 = local_4;
                let _e185 = (_e183.x * _e169);
                let _e187 = local_5;
                let _e189 = (_e187.y * _e169);
                let _e191 = local_6;
                let _e193 = (_e191.z * _e169);
                let _e195 = local_7;
                let _e199 = local_8;
                let _e203 = local_9;
                let _e206 = (_e173 * _e173);
                let _e207 = (_e177 * _e177);
                let _e208 = (_e181 * _e181);
                let _e209 = ((_e195.x * _e169) - _e206);
                let _e210 = ((_e199.y * _e169) - _e207);
                let _e211 = ((_e203.z * _e169) - _e208);
                let _e213 = select(0f, _e209, (_e209 > 0f));
                let _e215 = select(0f, _e210, (_e210 > 0f));
                let _e217 = select(0f, _e211, (_e211 > 0f));
                let _e219 = local_10;
                let _e223 = local_11;
                let _e227 = local_12;
                let _e233 = ((_e219.x * _e169) - (_e185 * _e185));
                let _e234 = ((_e223.y * _e169) - (_e189 * _e189));
                let _e235 = ((_e227.z * _e169) - (_e193 * _e193));
                let _e242 = (_e185 + 1f);
                let _e243 = (_e189 + 1f);
                let _e244 = (_e193 + 1f);
                let _e254 = ((((_e242 * _e242) + _e206) * 0.5f) + 0.0001f);
                let _e255 = ((((_e243 * _e243) + _e207) * 0.5f) + 0.0001f);
                let _e256 = ((((_e244 * _e244) + _e208) * 0.5f) + 0.0001f);
                let _e263 = (((select(0f, _e233, (_e233 > 0f)) + _e213) * 0.5f) + 0.0009f);
                let _e264 = (((select(0f, _e234, (_e234 > 0f)) + _e215) * 0.5f) + 0.0009f);
                let _e265 = (((select(0f, _e235, (_e235 > 0f)) + _e217) * 0.5f) + 0.0009f);
                let _e266 = (_e206 / _e254);
                let _e267 = (_e207 / _e255);
                let _e268 = (_e208 / _e256);
                let _e269 = (_e213 / _e263);
                let _e270 = (_e215 / _e264);
                let _e271 = (_e217 / _e265);
                let _e296 = ((1f - _e266) / _e263);
                let _e297 = ((1f - _e267) / _e264);
                let _e298 = ((1f - _e268) / _e265);
                let _e302 = (_e296 * (2f - _e269));
                let _e303 = (_e297 * (2f - _e270));
                let _e304 = (_e298 * (2f - _e271));
                let _e308 = -((_e296 * _e269));
                let _e309 = -((_e297 * _e270));
                let _e310 = -((_e298 * _e271));
                phi_343_ = vec4<f32>((_e308 * _e169), (_e309 * _e169), (_e310 * _e169), 0f);
                phi_344_ = vec4<f32>((_e302 * _e169), (_e303 * _e169), (_e304 * _e169), 0f);
                phi_345_ = vec4<f32>(((((((1f - _e269) * ((_e173 * (2f - _e266)) - (_e242 * _e266))) / _e254) - (_e302 * _e173)) - (_e308 * _e185)) * _e169), ((((((1f - _e270) * ((_e177 * (2f - _e267)) - (_e243 * _e267))) / _e255) - (_e303 * _e177)) - (_e309 * _e189)) * _e169), ((((((1f - _e271) * ((_e181 * (2f - _e268)) - (_e244 * _e268))) / _e256) - (_e304 * _e181)) - (_e310 * _e193)) * _e169), 0f);
                phi_346_ = ((((_e266 + _e269) - (_e266 * _e269)) + ((_e267 + _e270) - (_e267 * _e270))) + ((_e268 + _e271) - (_e268 * _e271)));
            } else {
                phi_343_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_344_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_345_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_346_ = 0f;
            }
            let _e347 = phi_343_;
            let _e349 = phi_344_;
            let _e351 = phi_345_;
            let _e353 = phi_346_;
            global_6.member[_e160] = _e353;
            let _e356 = (_e160 * 3u);
            global_7.member[_e356] = _e351;
            global_7.member[(_e356 + 1u)] = _e349;
            global_7.member[(_e356 + 2u)] = _e347;
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn ssim_columns(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
