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
    var phi_281_: vec4<f32>;
    var phi_284_: vec4<f32>;
    var phi_286_: vec4<f32>;
    var phi_288_: vec4<f32>;
    var phi_290_: u32;
    var phi_292_: u32;
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
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var phi_388_: vec4<f32>;
    var phi_389_: vec4<f32>;
    var phi_390_: vec4<f32>;
    var phi_391_: f32;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: u32;
    var local_21: u32;

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
            phi_281_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_284_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_286_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_288_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_290_ = (((_e40 + ((_e42 - 5u) * _e35)) + _e30) * 4u);
            phi_292_ = (_e42 - _e32);
            loop {
                let _e57 = phi_281_;
                let _e59 = phi_284_;
                let _e61 = phi_286_;
                let _e63 = phi_288_;
                let _e65 = phi_290_;
                let _e67 = phi_292_;
                local = _e63;
                local_1 = _e63;
                local_2 = _e63;
                local_3 = _e63;
                local_4 = _e61;
                local_5 = _e61;
                local_6 = _e61;
                local_7 = _e61;
                local_8 = _e59;
                local_9 = _e59;
                local_10 = _e59;
                local_11 = _e59;
                local_12 = _e57;
                local_13 = _e57;
                local_14 = _e57;
                local_15 = _e57;
                if (_e65 < (((_e40 + (select(_e44, _e35, (_e35 < _e44)) * _e35)) + _e30) * 4u)) {
                    let _e71 = global_3.member[_e67];
                    let _e74 = global_4.member[_e65];
                    let _e95 = global_4.member[(_e65 + 1u)];
                    let _e116 = global_4.member[(_e65 + 2u)];
                    let _e137 = global_4.member[(_e65 + 3u)];
                    local_16 = vec4<f32>((_e57.x + (_e137.x * _e71)), (_e57.y + (_e137.y * _e71)), (_e57.z + (_e137.z * _e71)), (_e57.w + (_e137.w * _e71)));
                    local_17 = vec4<f32>((_e59.x + (_e116.x * _e71)), (_e59.y + (_e116.y * _e71)), (_e59.z + (_e116.z * _e71)), (_e59.w + (_e116.w * _e71)));
                    local_18 = vec4<f32>((_e61.x + (_e95.x * _e71)), (_e61.y + (_e95.y * _e71)), (_e61.z + (_e95.z * _e71)), (_e61.w + (_e95.w * _e71)));
                    local_19 = vec4<f32>((_e63.x + (_e74.x * _e71)), (_e63.y + (_e74.y * _e71)), (_e63.z + (_e74.z * _e71)), (_e63.w + (_e74.w * _e71)));
                    local_20 = (_e65 + (_e35 * 4u));
                    local_21 = (_e67 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e418 = local_16;
                    phi_281_ = _e418;
                    let _e421 = local_17;
                    phi_284_ = _e421;
                    let _e424 = local_18;
                    phi_286_ = _e424;
                    let _e427 = local_19;
                    phi_288_ = _e427;
                    let _e430 = local_20;
                    phi_290_ = _e430;
                    let _e433 = local_21;
                    phi_292_ = _e433;
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
                let _e182 = (_e167.w * _e169);
                let _e184 = local_4;
                let _e186 = (_e184.x * _e169);
                let _e188 = local_5;
                let _e190 = (_e188.y * _e169);
                let _e192 = local_6;
                let _e194 = (_e192.z * _e169);
                let _e196 = local_7;
                let _e198 = (_e196.w * _e169);
                let _e200 = local_8;
                let _e204 = local_9;
                let _e208 = local_10;
                let _e212 = local_11;
                let _e215 = (_e173 * _e173);
                let _e216 = (_e177 * _e177);
                let _e217 = (_e181 * _e181);
                let _e218 = (_e182 * _e182);
                let _e219 = ((_e200.x * _e169) - _e215);
                let _e220 = ((_e204.y * _e169) - _e216);
                let _e221 = ((_e208.z * _e169) - _e217);
                let _e222 = ((_e212.w * _e169) - _e218);
                let _e224 = select(0f, _e219, (_e219 > 0f));
                let _e226 = select(0f, _e220, (_e220 > 0f));
                let _e228 = select(0f, _e221, (_e221 > 0f));
                let _e230 = select(0f, _e222, (_e222 > 0f));
                let _e232 = local_12;
                let _e236 = local_13;
                let _e240 = local_14;
                let _e244 = local_15;
                let _e251 = ((_e232.x * _e169) - (_e186 * _e186));
                let _e252 = ((_e236.y * _e169) - (_e190 * _e190));
                let _e253 = ((_e240.z * _e169) - (_e194 * _e194));
                let _e254 = ((_e244.w * _e169) - (_e198 * _e198));
                let _e263 = (_e186 + 1f);
                let _e264 = (_e190 + 1f);
                let _e265 = (_e194 + 1f);
                let _e266 = (_e198 + 1f);
                let _e279 = ((((_e263 * _e263) + _e215) * 0.5f) + 0.0001f);
                let _e280 = ((((_e264 * _e264) + _e216) * 0.5f) + 0.0001f);
                let _e281 = ((((_e265 * _e265) + _e217) * 0.5f) + 0.0001f);
                let _e282 = ((((_e266 * _e266) + _e218) * 0.5f) + 0.0001f);
                let _e291 = (((select(0f, _e251, (_e251 > 0f)) + _e224) * 0.5f) + 0.0009f);
                let _e292 = (((select(0f, _e252, (_e252 > 0f)) + _e226) * 0.5f) + 0.0009f);
                let _e293 = (((select(0f, _e253, (_e253 > 0f)) + _e228) * 0.5f) + 0.0009f);
                let _e294 = (((select(0f, _e254, (_e254 > 0f)) + _e230) * 0.5f) + 0.0009f);
                let _e295 = (_e215 / _e279);
                let _e296 = (_e216 / _e280);
                let _e297 = (_e217 / _e281);
                let _e298 = (_e218 / _e282);
                let _e299 = (_e224 / _e291);
                let _e300 = (_e226 / _e292);
                let _e301 = (_e228 / _e293);
                let _e302 = (_e230 / _e294);
                let _e335 = ((1f - _e295) / _e291);
                let _e336 = ((1f - _e296) / _e292);
                let _e337 = ((1f - _e297) / _e293);
                let _e338 = ((1f - _e298) / _e294);
                let _e343 = (_e335 * (2f - _e299));
                let _e344 = (_e336 * (2f - _e300));
                let _e345 = (_e337 * (2f - _e301));
                let _e346 = (_e338 * (2f - _e302));
                let _e351 = -((_e335 * _e299));
                let _e352 = -((_e336 * _e300));
                let _e353 = -((_e337 * _e301));
                let _e354 = -((_e338 * _e302));
                phi_388_ = vec4<f32>((_e351 * _e169), (_e352 * _e169), (_e353 * _e169), (_e354 * 0f));
                phi_389_ = vec4<f32>((_e343 * _e169), (_e344 * _e169), (_e345 * _e169), (_e346 * 0f));
                phi_390_ = vec4<f32>(((((((1f - _e299) * ((_e173 * (2f - _e295)) - (_e263 * _e295))) / _e279) - (_e343 * _e173)) - (_e351 * _e186)) * _e169), ((((((1f - _e300) * ((_e177 * (2f - _e296)) - (_e264 * _e296))) / _e280) - (_e344 * _e177)) - (_e352 * _e190)) * _e169), ((((((1f - _e301) * ((_e181 * (2f - _e297)) - (_e265 * _e297))) / _e281) - (_e345 * _e181)) - (_e353 * _e194)) * _e169), ((((((1f - _e302) * ((_e182 * (2f - _e298)) - (_e266 * _e298))) / _e282) - (_e346 * _e182)) - (_e354 * _e198)) * 0f));
                phi_391_ = ((((_e295 + _e299) - (_e295 * _e299)) + ((_e296 + _e300) - (_e296 * _e300))) + ((_e297 + _e301) - (_e297 * _e301)));
            } else {
                phi_388_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_389_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_390_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_391_ = 0f;
            }
            let _e398 = phi_388_;
            let _e400 = phi_389_;
            let _e402 = phi_390_;
            let _e404 = phi_391_;
            global_6.member[_e160] = _e404;
            let _e407 = (_e160 * 3u);
            global_7.member[_e407] = _e402;
            global_7.member[(_e407 + 1u)] = _e400;
            global_7.member[(_e407 + 2u)] = _e398;
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
