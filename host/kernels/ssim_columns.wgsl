struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_12;

fn function_() {
    var phi_245_: vec4<f32>;
    var phi_248_: vec4<f32>;
    var phi_250_: vec4<f32>;
    var phi_252_: vec4<f32>;
    var phi_254_: u32;
    var phi_256_: u32;
    var phi_246_: vec4<f32>;
    var phi_249_: vec4<f32>;
    var phi_251_: vec4<f32>;
    var phi_253_: vec4<f32>;
    var phi_255_: u32;
    var phi_257_: u32;
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
    var phi_354_: vec4<f32>;
    var phi_355_: vec4<f32>;
    var phi_356_: vec4<f32>;
    var phi_357_: f32;

    let _e25 = global;
    let _e26 = global_1;
    let _e32 = ((_e26.x * 8u) + _e25.x);
    let _e34 = ((_e26.y * 8u) + _e25.y);
    let _e37 = global_2.member.member;
    if (_e32 < _e37) {
        if (_e34 < _e37) {
            let _e42 = ((_e26.z * _e37) * _e37);
            let _e44 = select(5u, _e34, (_e34 > 5u));
            let _e46 = (_e34 + 6u);
            phi_245_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_248_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_250_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_252_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_254_ = (((_e42 + ((_e44 - 5u) * _e37)) + _e32) * 4u);
            phi_256_ = (_e44 - _e34);
            loop {
                let _e59 = phi_245_;
                let _e61 = phi_248_;
                let _e63 = phi_250_;
                let _e65 = phi_252_;
                let _e67 = phi_254_;
                let _e69 = phi_256_;
                local = _e65;
                local_1 = _e65;
                local_2 = _e65;
                local_3 = _e65;
                local_4 = _e63;
                local_5 = _e63;
                local_6 = _e63;
                local_7 = _e61;
                local_8 = _e61;
                local_9 = _e61;
                local_10 = _e59;
                local_11 = _e59;
                local_12 = _e59;
                let _e70 = (_e67 < (((_e42 + (select(_e46, _e37, (_e37 < _e46)) * _e37)) + _e32) * 4u));
                if _e70 {
                    let _e73 = global_3.member[_e69];
                    let _e76 = global_5.member[_e67];
                    let _e97 = global_5.member[(_e67 + 1u)];
                    let _e118 = global_5.member[(_e67 + 2u)];
                    let _e139 = global_5.member[(_e67 + 3u)];
                    phi_246_ = vec4<f32>((_e59.x + (_e139.x * _e73)), (_e59.y + (_e139.y * _e73)), (_e59.z + (_e139.z * _e73)), (_e59.w + (_e139.w * _e73)));
                    phi_249_ = vec4<f32>((_e61.x + (_e118.x * _e73)), (_e61.y + (_e118.y * _e73)), (_e61.z + (_e118.z * _e73)), (_e61.w + (_e118.w * _e73)));
                    phi_251_ = vec4<f32>((_e63.x + (_e97.x * _e73)), (_e63.y + (_e97.y * _e73)), (_e63.z + (_e97.z * _e73)), (_e63.w + (_e97.w * _e73)));
                    phi_253_ = vec4<f32>((_e65.x + (_e76.x * _e73)), (_e65.y + (_e76.y * _e73)), (_e65.z + (_e76.z * _e73)), (_e65.w + (_e76.w * _e73)));
                    phi_255_ = (_e67 + (_e37 * 4u));
                    phi_257_ = (_e69 + 1u);
                } else {
                    phi_246_ = vec4<f32>();
                    phi_249_ = vec4<f32>();
                    phi_251_ = vec4<f32>();
                    phi_253_ = vec4<f32>();
                    phi_255_ = u32();
                    phi_257_ = u32();
                }
                let _e161 = phi_246_;
                let _e163 = phi_249_;
                let _e165 = phi_251_;
                let _e167 = phi_253_;
                let _e169 = phi_255_;
                let _e171 = phi_257_;
                continue;
                continuing {
                    phi_245_ = _e161;
                    phi_248_ = _e163;
                    phi_250_ = _e165;
                    phi_252_ = _e167;
                    phi_254_ = _e169;
                    phi_256_ = _e171;
                    break if !(_e70);
                }
            }
            let _e175 = ((_e42 + (_e34 * _e37)) + _e32);
            let _e178 = global_4.member[_e175];
            if (_e178.w > 0f) {
                let _e182 = local;
                let _e184 = (1f / _e182.w);
                let _e186 = local_1;
                let _e188 = (_e186.x * _e184);
                let _e190 = local_2;
                let _e192 = (_e190.y * _e184);
                let _e194 = local_3;
                let _e196 = (_e194.z * _e184);
                let _e198 = local_4;
                let _e200 = (_e198.x * _e184);
                let _e202 = local_5;
                let _e204 = (_e202.y * _e184);
                let _e206 = local_6;
                let _e208 = (_e206.z * _e184);
                let _e210 = local_7;
                let _e214 = local_8;
                let _e218 = local_9;
                let _e221 = (_e188 * _e188);
                let _e222 = (_e192 * _e192);
                let _e223 = (_e196 * _e196);
                let _e224 = ((_e210.x * _e184) - _e221);
                let _e225 = ((_e214.y * _e184) - _e222);
                let _e226 = ((_e218.z * _e184) - _e223);
                let _e228 = select(0f, _e224, (_e224 > 0f));
                let _e230 = select(0f, _e225, (_e225 > 0f));
                let _e232 = select(0f, _e226, (_e226 > 0f));
                let _e234 = local_10;
                let _e238 = local_11;
                let _e242 = local_12;
                let _e248 = ((_e234.x * _e184) - (_e200 * _e200));
                let _e249 = ((_e238.y * _e184) - (_e204 * _e204));
                let _e250 = ((_e242.z * _e184) - (_e208 * _e208));
                let _e257 = (_e200 + 1f);
                let _e258 = (_e204 + 1f);
                let _e259 = (_e208 + 1f);
                let _e269 = ((((_e257 * _e257) + _e221) * 0.5f) + 0.0001f);
                let _e270 = ((((_e258 * _e258) + _e222) * 0.5f) + 0.0001f);
                let _e271 = ((((_e259 * _e259) + _e223) * 0.5f) + 0.0001f);
                let _e278 = (((select(0f, _e248, (_e248 > 0f)) + _e228) * 0.5f) + 0.0009f);
                let _e279 = (((select(0f, _e249, (_e249 > 0f)) + _e230) * 0.5f) + 0.0009f);
                let _e280 = (((select(0f, _e250, (_e250 > 0f)) + _e232) * 0.5f) + 0.0009f);
                let _e281 = (_e221 / _e269);
                let _e282 = (_e222 / _e270);
                let _e283 = (_e223 / _e271);
                let _e284 = (_e228 / _e278);
                let _e285 = (_e230 / _e279);
                let _e286 = (_e232 / _e280);
                let _e311 = ((1f - _e281) / _e278);
                let _e312 = ((1f - _e282) / _e279);
                let _e313 = ((1f - _e283) / _e280);
                let _e317 = (_e311 * (2f - _e284));
                let _e318 = (_e312 * (2f - _e285));
                let _e319 = (_e313 * (2f - _e286));
                let _e323 = -((_e311 * _e284));
                let _e324 = -((_e312 * _e285));
                let _e325 = -((_e313 * _e286));
                phi_354_ = vec4<f32>((_e323 * _e184), (_e324 * _e184), (_e325 * _e184), 0f);
                phi_355_ = vec4<f32>((_e317 * _e184), (_e318 * _e184), (_e319 * _e184), 0f);
                phi_356_ = vec4<f32>(((((((1f - _e284) * ((_e188 * (2f - _e281)) - (_e257 * _e281))) / _e269) - (_e317 * _e188)) - (_e323 * _e200)) * _e184), ((((((1f - _e285) * ((_e192 * (2f - _e282)) - (_e258 * _e282))) / _e270) - (_e318 * _e192)) - (_e324 * _e204)) * _e184), ((((((1f - _e286) * ((_e196 * (2f - _e283)) - (_e259 * _e283))) / _e271) - (_e319 * _e196)) - (_e325 * _e208)) * _e184), 0f);
                phi_357_ = ((((_e281 + _e284) - (_e281 * _e284)) + ((_e282 + _e285) - (_e282 * _e285))) + ((_e283 + _e286) - (_e283 * _e286)));
            } else {
                phi_354_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_355_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_356_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_357_ = 0f;
            }
            let _e362 = phi_354_;
            let _e364 = phi_355_;
            let _e366 = phi_356_;
            let _e368 = phi_357_;
            global_6.member[_e175] = _e368;
            let _e371 = (_e175 * 3u);
            global_7.member[_e371] = _e366;
            global_7.member[(_e371 + 1u)] = _e364;
            global_7.member[(_e371 + 2u)] = _e362;
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
