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
    var phi_345_: vec4<f32>;
    var phi_346_: vec4<f32>;
    var phi_347_: vec4<f32>;
    var phi_348_: f32;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: u32;
    var local_18: u32;

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
                if (_e67 < (((_e42 + (select(_e46, _e37, (_e37 < _e46)) * _e37)) + _e32) * 4u)) {
                    let _e73 = global_3.member[_e69];
                    let _e76 = global_5.member[_e67];
                    let _e97 = global_5.member[(_e67 + 1u)];
                    let _e118 = global_5.member[(_e67 + 2u)];
                    let _e139 = global_5.member[(_e67 + 3u)];
                    local_13 = vec4<f32>((_e59.x + (_e139.x * _e73)), (_e59.y + (_e139.y * _e73)), (_e59.z + (_e139.z * _e73)), (_e59.w + (_e139.w * _e73)));
                    local_14 = vec4<f32>((_e61.x + (_e118.x * _e73)), (_e61.y + (_e118.y * _e73)), (_e61.z + (_e118.z * _e73)), (_e61.w + (_e118.w * _e73)));
                    local_15 = vec4<f32>((_e63.x + (_e97.x * _e73)), (_e63.y + (_e97.y * _e73)), (_e63.z + (_e97.z * _e73)), (_e63.w + (_e97.w * _e73)));
                    local_16 = vec4<f32>((_e65.x + (_e76.x * _e73)), (_e65.y + (_e76.y * _e73)), (_e65.z + (_e76.z * _e73)), (_e65.w + (_e76.w * _e73)));
                    local_17 = (_e67 + (_e37 * 4u));
                    local_18 = (_e69 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e369 = local_13;
                    phi_245_ = _e369;
                    let _e372 = local_14;
                    phi_248_ = _e372;
                    let _e375 = local_15;
                    phi_250_ = _e375;
                    let _e378 = local_16;
                    phi_252_ = _e378;
                    let _e381 = local_17;
                    phi_254_ = _e381;
                    let _e384 = local_18;
                    phi_256_ = _e384;
                }
            }
            let _e162 = ((_e42 + (_e34 * _e37)) + _e32);
            let _e165 = global_4.member[_e162];
            if (_e165.w > 0f) {
                let _e169 = local;
                let _e171 = (1f / _e169.w);
                let _e173 = local_1;
                let _e175 = (_e173.x * _e171);
                let _e177 = local_2;
                let _e179 = (_e177.y * _e171);
                let _e181 = local_3;
                let _e183 = (_e181.z * _e171);
                let _e185 = local_4;
                let _e187 = (_e185.x * _e171);
                let _e189 = local_5;
                let _e191 = (_e189.y * _e171);
                let _e193 = local_6;
                let _e195 = (_e193.z * _e171);
                let _e197 = local_7;
                let _e201 = local_8;
                let _e205 = local_9;
                let _e208 = (_e175 * _e175);
                let _e209 = (_e179 * _e179);
                let _e210 = (_e183 * _e183);
                let _e211 = ((_e197.x * _e171) - _e208);
                let _e212 = ((_e201.y * _e171) - _e209);
                let _e213 = ((_e205.z * _e171) - _e210);
                let _e215 = select(0f, _e211, (_e211 > 0f));
                let _e217 = select(0f, _e212, (_e212 > 0f));
                let _e219 = select(0f, _e213, (_e213 > 0f));
                let _e221 = local_10;
                let _e225 = local_11;
                let _e229 = local_12;
                let _e235 = ((_e221.x * _e171) - (_e187 * _e187));
                let _e236 = ((_e225.y * _e171) - (_e191 * _e191));
                let _e237 = ((_e229.z * _e171) - (_e195 * _e195));
                let _e244 = (_e187 + 1f);
                let _e245 = (_e191 + 1f);
                let _e246 = (_e195 + 1f);
                let _e256 = ((((_e244 * _e244) + _e208) * 0.5f) + 0.0001f);
                let _e257 = ((((_e245 * _e245) + _e209) * 0.5f) + 0.0001f);
                let _e258 = ((((_e246 * _e246) + _e210) * 0.5f) + 0.0001f);
                let _e265 = (((select(0f, _e235, (_e235 > 0f)) + _e215) * 0.5f) + 0.0009f);
                let _e266 = (((select(0f, _e236, (_e236 > 0f)) + _e217) * 0.5f) + 0.0009f);
                let _e267 = (((select(0f, _e237, (_e237 > 0f)) + _e219) * 0.5f) + 0.0009f);
                let _e268 = (_e208 / _e256);
                let _e269 = (_e209 / _e257);
                let _e270 = (_e210 / _e258);
                let _e271 = (_e215 / _e265);
                let _e272 = (_e217 / _e266);
                let _e273 = (_e219 / _e267);
                let _e298 = ((1f - _e268) / _e265);
                let _e299 = ((1f - _e269) / _e266);
                let _e300 = ((1f - _e270) / _e267);
                let _e304 = (_e298 * (2f - _e271));
                let _e305 = (_e299 * (2f - _e272));
                let _e306 = (_e300 * (2f - _e273));
                let _e310 = -((_e298 * _e271));
                let _e311 = -((_e299 * _e272));
                let _e312 = -((_e300 * _e273));
                phi_345_ = vec4<f32>((_e310 * _e171), (_e311 * _e171), (_e312 * _e171), 0f);
                phi_346_ = vec4<f32>((_e304 * _e171), (_e305 * _e171), (_e306 * _e171), 0f);
                phi_347_ = vec4<f32>(((((((1f - _e271) * ((_e175 * (2f - _e268)) - (_e244 * _e268))) / _e256) - (_e304 * _e175)) - (_e310 * _e187)) * _e171), ((((((1f - _e272) * ((_e179 * (2f - _e269)) - (_e245 * _e269))) / _e257) - (_e305 * _e179)) - (_e311 * _e191)) * _e171), ((((((1f - _e273) * ((_e183 * (2f - _e270)) - (_e246 * _e270))) / _e258) - (_e306 * _e183)) - (_e312 * _e195)) * _e171), 0f);
                phi_348_ = ((((_e268 + _e271) - (_e268 * _e271)) + ((_e269 + _e272) - (_e269 * _e272))) + ((_e270 + _e273) - (_e270 * _e273)));
            } else {
                phi_345_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_346_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_347_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_348_ = 0f;
            }
            let _e349 = phi_345_;
            let _e351 = phi_346_;
            let _e353 = phi_347_;
            let _e355 = phi_348_;
            global_6.member[_e162] = _e355;
            let _e358 = (_e162 * 3u);
            global_7.member[_e358] = _e353;
            global_7.member[(_e358 + 1u)] = _e351;
            global_7.member[(_e358 + 2u)] = _e349;
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
