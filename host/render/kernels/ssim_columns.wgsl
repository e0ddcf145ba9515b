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
    var phi_282_: vec4<f32>;
    var phi_285_: vec4<f32>;
    var phi_287_: vec4<f32>;
    var phi_289_: vec4<f32>;
    var phi_291_: u32;
    var phi_293_: u32;
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
    var phi_407_: vec4<f32>;
    var phi_408_: vec4<f32>;
    var phi_409_: vec4<f32>;
    var phi_410_: f32;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: u32;
    var local_21: u32;

    let _e27 = global;
    let _e28 = global_1;
    let _e34 = ((_e28.x * 8u) + _e27.x);
    let _e36 = ((_e28.y * 8u) + _e27.y);
    let _e39 = global_2.member.member;
    if (_e34 < _e39) {
        if (_e36 < _e39) {
            let _e44 = ((_e28.z * _e39) * _e39);
            let _e46 = select(5u, _e36, (_e36 > 5u));
            let _e48 = (_e36 + 6u);
            phi_282_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_285_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_287_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_289_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_291_ = (((_e44 + ((_e46 - 5u) * _e39)) + _e34) * 4u);
            phi_293_ = (_e46 - _e36);
            loop {
                let _e61 = phi_282_;
                let _e63 = phi_285_;
                let _e65 = phi_287_;
                let _e67 = phi_289_;
                let _e69 = phi_291_;
                let _e71 = phi_293_;
                local = _e67;
                local_1 = _e67;
                local_2 = _e67;
                local_3 = _e67;
                local_4 = _e65;
                local_5 = _e65;
                local_6 = _e65;
                local_7 = _e65;
                local_8 = _e63;
                local_9 = _e63;
                local_10 = _e63;
                local_11 = _e63;
                local_12 = _e61;
                local_13 = _e61;
                local_14 = _e61;
                local_15 = _e61;
                if (_e69 < (((_e44 + (select(_e48, _e39, (_e39 < _e48)) * _e39)) + _e34) * 4u)) {
                    let _e75 = global_3.member[_e71];
                    let _e78 = global_4.member[_e69];
                    let _e99 = global_4.member[(_e69 + 1u)];
                    let _e120 = global_4.member[(_e69 + 2u)];
                    let _e141 = global_4.member[(_e69 + 3u)];
                    local_16 = vec4<f32>((_e61.x + (_e141.x * _e75)), (_e61.y + (_e141.y * _e75)), (_e61.z + (_e141.z * _e75)), (_e61.w + (_e141.w * _e75)));
                    local_17 = vec4<f32>((_e63.x + (_e120.x * _e75)), (_e63.y + (_e120.y * _e75)), (_e63.z + (_e120.z * _e75)), (_e63.w + (_e120.w * _e75)));
                    local_18 = vec4<f32>((_e65.x + (_e99.x * _e75)), (_e65.y + (_e99.y * _e75)), (_e65.z + (_e99.z * _e75)), (_e65.w + (_e99.w * _e75)));
                    local_19 = vec4<f32>((_e67.x + (_e78.x * _e75)), (_e67.y + (_e78.y * _e75)), (_e67.z + (_e78.z * _e75)), (_e67.w + (_e78.w * _e75)));
                    local_20 = (_e69 + (_e39 * 4u));
                    local_21 = (_e71 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e437 = local_16;
                    phi_282_ = _e437;
                    let _e440 = local_17;
                    phi_285_ = _e440;
                    let _e443 = local_18;
                    phi_287_ = _e443;
                    let _e446 = local_19;
                    phi_289_ = _e446;
                    let _e449 = local_20;
                    phi_291_ = _e449;
                    let _e452 = local_21;
                    phi_293_ = _e452;
                }
            }
            let _e164 = ((_e44 + (_e36 * _e39)) + _e34);
            let _e167 = global_5.member[_e164];
            if (_e167.w > 0f) {
                let _e171 = local;
                let _e173 = (1f / _e171.w);
                let _e175 = local_1;
                let _e177 = (_e175.x * _e173);
                let _e179 = local_2;
                let _e181 = (_e179.y * _e173);
                let _e183 = local_3;
                let _e185 = (_e183.z * _e173);
                let _e186 = (_e171.w * _e173);
                let _e188 = local_4;
                let _e190 = (_e188.x * _e173);
                let _e192 = local_5;
                let _e194 = (_e192.y * _e173);
                let _e196 = local_6;
                let _e198 = (_e196.z * _e173);
                let _e200 = local_7;
                let _e202 = (_e200.w * _e173);
                let _e204 = local_8;
                let _e208 = local_9;
                let _e212 = local_10;
                let _e216 = local_11;
                let _e219 = (_e177 * _e177);
                let _e220 = (_e181 * _e181);
                let _e221 = (_e185 * _e185);
                let _e222 = (_e186 * _e186);
                let _e223 = ((_e204.x * _e173) - _e219);
                let _e224 = ((_e208.y * _e173) - _e220);
                let _e225 = ((_e212.z * _e173) - _e221);
                let _e226 = ((_e216.w * _e173) - _e222);
                let _e228 = select(0f, _e223, (_e223 > 0f));
                let _e230 = select(0f, _e224, (_e224 > 0f));
                let _e232 = select(0f, _e225, (_e225 > 0f));
                let _e234 = select(0f, _e226, (_e226 > 0f));
                let _e236 = local_12;
                let _e240 = local_13;
                let _e244 = local_14;
                let _e248 = local_15;
                let _e255 = ((_e236.x * _e173) - (_e190 * _e190));
                let _e256 = ((_e240.y * _e173) - (_e194 * _e194));
                let _e257 = ((_e244.z * _e173) - (_e198 * _e198));
                let _e258 = ((_e248.w * _e173) - (_e202 * _e202));
                let _e267 = (_e190 + 1f);
                let _e268 = (_e194 + 1f);
                let _e269 = (_e198 + 1f);
                let _e270 = (_e202 + 1f);
                let _e283 = ((((_e267 * _e267) + _e219) * 0.5f) + 0.0001f);
                let _e284 = ((((_e268 * _e268) + _e220) * 0.5f) + 0.0001f);
                let _e285 = ((((_e269 * _e269) + _e221) * 0.5f) + 0.0001f);
                let _e286 = ((((_e270 * _e270) + _e222) * 0.5f) + 0.0001f);
                let _e295 = (((select(0f, _e255, (_e255 > 0f)) + _e228) * 0.5f) + 0.0009f);
                let _e296 = (((select(0f, _e256, (_e256 > 0f)) + _e230) * 0.5f) + 0.0009f);
                let _e297 = (((select(0f, _e257, (_e257 > 0f)) + _e232) * 0.5f) + 0.0009f);
                let _e298 = (((select(0f, _e258, (_e258 > 0f)) + _e234) * 0.5f) + 0.0009f);
                let _e299 = (_e219 / _e283);
                let _e300 = (_e220 / _e284);
                let _e301 = (_e221 / _e285);
                let _e302 = (_e222 / _e286);
                let _e303 = (_e228 / _e295);
                let _e304 = (_e230 / _e296);
                let _e305 = (_e232 / _e297);
                let _e306 = (_e234 / _e298);
                let _e339 = ((1f - _e299) / _e295);
                let _e340 = ((1f - _e300) / _e296);
                let _e341 = ((1f - _e301) / _e297);
                let _e342 = ((1f - _e302) / _e298);
                let _e347 = (_e339 * (2f - _e303));
                let _e348 = (_e340 * (2f - _e304));
                let _e349 = (_e341 * (2f - _e305));
                let _e350 = (_e342 * (2f - _e306));
                let _e355 = -((_e339 * _e303));
                let _e356 = -((_e340 * _e304));
                let _e357 = -((_e341 * _e305));
                let _e358 = -((_e342 * _e306));
                let _e387 = bitcast<u32>((((((1f - _e306) * ((_e186 * (2f - _e302)) - (_e270 * _e302))) / _e286) - (_e350 * _e186)) - (_e358 * _e202)));
                let _e397 = bitcast<u32>(_e350);
                let _e407 = bitcast<u32>(_e358);
                phi_407_ = vec4<f32>((_e355 * _e173), (_e356 * _e173), (_e357 * _e173), bitcast<f32>(select(2143289344u, (_e407 & 2147483648u), ((_e407 & 2147483647u) < 2139095040u))));
                phi_408_ = vec4<f32>((_e347 * _e173), (_e348 * _e173), (_e349 * _e173), bitcast<f32>(select(2143289344u, (_e397 & 2147483648u), ((_e397 & 2147483647u) < 2139095040u))));
                phi_409_ = vec4<f32>(((((((1f - _e303) * ((_e177 * (2f - _e299)) - (_e267 * _e299))) / _e283) - (_e347 * _e177)) - (_e355 * _e190)) * _e173), ((((((1f - _e304) * ((_e181 * (2f - _e300)) - (_e268 * _e300))) / _e284) - (_e348 * _e181)) - (_e356 * _e194)) * _e173), ((((((1f - _e305) * ((_e185 * (2f - _e301)) - (_e269 * _e301))) / _e285) - (_e349 * _e185)) - (_e357 * _e198)) * _e173), bitcast<f32>(select(2143289344u, (_e387 & 2147483648u), ((_e387 & 2147483647u) < 2139095040u))));
                phi_410_ = ((((_e299 + _e303) - (_e299 * _e303)) + ((_e300 + _e304) - (_e300 * _e304))) + ((_e301 + _e305) - (_e301 * _e305)));
            } else {
                phi_407_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_408_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_409_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_410_ = 0f;
            }
            let _e417 = phi_407_;
            let _e419 = phi_408_;
            let _e421 = phi_409_;
            let _e423 = phi_410_;
            global_6.member[_e164] = _e423;
            let _e426 = (_e164 * 3u);
            global_7.member[_e426] = _e421;
            global_7.member[(_e426 + 1u)] = _e419;
            global_7.member[(_e426 + 2u)] = _e417;
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
