struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: f32,
    member_1: f32,
}

struct type_18 {
    member: array<f32>,
}

struct type_22 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_18;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_22;

fn function_() {
    var phi_259_: u32;
    var phi_262_: f32;
    var phi_327_: array<type_14, 3>;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: u32;
    var local_4: f32;

    let _e28 = global;
    let _e29 = global_1;
    let _e30 = global_2;
    let _e38 = (((_e29.x + (_e29.y * _e30.x)) * 64u) + _e28.x);
    let _e41 = global_3.member.member;
    if (_e38 < _e41) {
        let _e43 = (_e38 * 4u);
        let _e46 = global_4.member[_e43];
        let _e53 = global_4.member[(_e43 + 1u)];
        let _e61 = global_4.member[(_e43 + 2u)];
        let _e68 = global_4.member[(_e43 + 3u)];
        let _e73 = bitcast<f32>(0u);
        let _e74 = bitcast<f32>(1333788671u);
        phi_259_ = 0u;
        phi_262_ = 0f;
        loop {
            let _e82 = phi_259_;
            let _e84 = phi_262_;
            local = _e84;
            local_1 = _e84;
            local_2 = _e84;
            if (_e82 < select(select(u32(_e68.w), 0u, !((_e68.w >= _e73))), 4294967295u, (_e68.w > _e74))) {
                let _e87 = (f32(_e82) + 0f);
                let _e88 = (_e68.w - 1f);
                let _e93 = global_3.member.member_1;
                let _e96 = global_3.member.member_2;
                let _e97 = (select(_e88, _e87, (_e87 < _e88)) + 0.5f);
                let _e98 = (_e68.w + 0f);
                let _e100 = ((_e97 + 0f) / _e98);
                let _e102 = select(0f, _e100, (_e100 > 0f));
                let _e104 = select(1f, _e102, (_e102 < 1f));
                let _e108 = (trunc((_e104 * 1024f)) * (1f / 1024f));
                let _e111 = bitcast<u32>(_e108);
                let _e123 = select(0f, (((_e97 - (_e108 * _e68.w)) + (0f - bitcast<f32>(select(2143289344u, (_e111 & 2147483648u), ((_e111 & 2147483647u) < 2139095040u))))) / _e98), select(false, (_e104 < 1f), (0f < _e104)));
                if (_e96 == 0u) {
                    let _e196 = (_e61.x + ((_e108 * _e68.x) + (_e123 * (_e53.x + _e68.x))));
                    let _e198 = (_e46.x + (_e108 * _e53.x));
                    let _e202 = (1f / 4096f);
                    let _e203 = (trunc(((_e198 + _e196) * 4096f)) * _e202);
                    let _e210 = (_e61.y + ((_e108 * _e68.y) + (_e123 * (_e53.y + _e68.y))));
                    let _e212 = (_e46.y + (_e108 * _e53.y));
                    let _e216 = (trunc(((_e212 + _e210) * 4096f)) * _e202);
                    let _e223 = (_e61.z + ((_e108 * _e68.z) + (_e123 * (_e53.z + _e68.z))));
                    let _e225 = (_e46.z + (_e108 * _e53.z));
                    let _e229 = (trunc(((_e225 + _e223) * 4096f)) * _e202);
                    phi_327_ = array<type_14, 3>(type_14(_e203, ((_e198 - _e203) + _e196)), type_14(_e216, ((_e212 - _e216) + _e210)), type_14(_e229, ((_e225 - _e229) + _e223)));
                } else {
                    let _e127 = (_e61.x + ((_e108 + _e123) * _e61.y));
                    let _e128 = (_e127 < 0f);
                    let _e130 = select(_e127, -(_e127), _e128);
                    let _e135 = (_e53.w / (2f - (select(_e53.w, _e130, (_e130 > _e53.w)) / _e53.w)));
                    let _e139 = select(select(_e135, -(_e135), _e128), _e127, (_e130 <= _e53.w));
                    let _e141 = (_e46.x + (_e139 * _e53.x));
                    let _e143 = (_e46.y + (_e139 * _e53.y));
                    let _e145 = (_e46.z + (_e139 * _e53.z));
                    let _e148 = select(_e141, -(_e141), (_e141 < 0f));
                    let _e151 = select(_e143, -(_e143), (_e143 < 0f));
                    let _e153 = select(_e151, _e148, (_e148 > _e151));
                    let _e156 = select(_e145, -(_e145), (_e145 < 0f));
                    let _e158 = select(_e156, _e153, (_e153 > _e156));
                    let _e160 = select(0.25f, _e158, (_e158 > 0.25f));
                    let _e165 = select(1f, ((0.5f - (0.0625f / _e160)) / _e160), (0.25f < _e160));
                    let _e166 = (_e141 * _e165);
                    let _e170 = (1f / 4096f);
                    let _e171 = (trunc(((0.5f + _e166) * 4096f)) * _e170);
                    let _e174 = (_e143 * _e165);
                    let _e178 = (trunc(((0.5f + _e174) * 4096f)) * _e170);
                    let _e181 = (_e145 * _e165);
                    let _e185 = (trunc(((0.5f + _e181) * 4096f)) * _e170);
                    phi_327_ = array<type_14, 3>(type_14(_e171, ((0.5f - _e171) + _e166)), type_14(_e178, ((0.5f - _e178) + _e174)), type_14(_e185, ((0.5f - _e185) + _e181)));
                }
                let _e237 = phi_327_;
                let _e238 = (_e93 + 2u);
                let _e239 = f32(_e93);
                let _e240 = (_e238 * _e238);
                let _e241 = (_e240 * _e238);
                let _e254 = (_e237[0].member + _e237[0].member_1);
                let _e257 = select(false, (_e254 < 1f), (0f < _e254));
                let _e260 = select(select(0f, 1f, (1f <= _e254)), _e237[0].member, _e257);
                let _e262 = (_e260 * _e239);
                let _e263 = bitcast<u32>(_e260);
                let _e269 = (_e239 + 0f);
                let _e273 = trunc(_e262);
                let _e275 = ((_e262 - _e273) + ((bitcast<f32>(select(2143289344u, (_e263 & 2147483648u), ((_e263 & 2147483647u) < 2139095040u))) + (select(0f, _e237[0].member_1, _e257) * _e269)) + 0.5f));
                let _e277 = select(0f, _e275, (_e275 > 0f));
                let _e278 = trunc(_e277);
                let _e279 = (_e277 - _e278);
                let _e281 = u32((_e273 + _e278));
                let _e282 = (_e237[1].member + _e237[1].member_1);
                let _e285 = select(false, (_e282 < 1f), (0f < _e282));
                let _e288 = select(select(0f, 1f, (1f <= _e282)), _e237[1].member, _e285);
                let _e290 = (_e288 * _e239);
                let _e291 = bitcast<u32>(_e288);
                let _e300 = trunc(_e290);
                let _e302 = ((_e290 - _e300) + ((bitcast<f32>(select(2143289344u, (_e291 & 2147483648u), ((_e291 & 2147483647u) < 2139095040u))) + (select(0f, _e237[1].member_1, _e285) * _e269)) + 0.5f));
                let _e304 = select(0f, _e302, (_e302 > 0f));
                let _e305 = trunc(_e304);
                let _e306 = (_e304 - _e305);
                let _e309 = (_e237[2].member + _e237[2].member_1);
                let _e312 = select(false, (_e309 < 1f), (0f < _e309));
                let _e315 = select(select(0f, 1f, (1f <= _e309)), _e237[2].member, _e312);
                let _e317 = (_e315 * _e239);
                let _e318 = bitcast<u32>(_e315);
                let _e327 = trunc(_e317);
                let _e329 = ((_e317 - _e327) + ((bitcast<f32>(select(2143289344u, (_e318 & 2147483648u), ((_e318 & 2147483647u) < 2139095040u))) + (select(0f, _e237[2].member_1, _e312) * _e269)) + 0.5f));
                let _e331 = select(0f, _e329, (_e329 > 0f));
                let _e332 = trunc(_e331);
                let _e333 = (_e331 - _e332);
                let _e336 = (1f - _e279);
                let _e337 = (1f - _e306);
                let _e338 = (1f - _e333);
                let _e339 = (_e336 * _e337);
                let _e340 = (_e279 * _e337);
                let _e341 = (_e336 * _e306);
                let _e342 = (_e279 * _e306);
                let _e351 = (u32((_e300 + _e305)) * _e238);
                let _e352 = (u32((_e327 + _e332)) * _e240);
                let _e353 = (_e281 + 1u);
                let _e354 = (_e351 + _e238);
                let _e355 = (_e352 + _e240);
                let _e356 = (_e281 + _e351);
                let _e357 = (_e356 + _e352);
                let _e361 = (_e353 + _e351);
                let _e362 = (_e361 + _e352);
                let _e366 = (_e281 + _e354);
                let _e367 = (_e366 + _e352);
                let _e371 = (_e353 + _e354);
                let _e372 = (_e371 + _e352);
                let _e376 = (_e356 + _e355);
                let _e380 = (_e361 + _e355);
                let _e384 = (_e366 + _e355);
                let _e388 = (_e371 + _e355);
                let _e394 = global_5.member[select((_e357 - _e241), _e357, (_e357 < _e241))];
                let _e398 = global_5.member[select((_e362 - _e241), _e362, (_e362 < _e241))];
                let _e402 = global_5.member[select((_e367 - _e241), _e367, (_e367 < _e241))];
                let _e406 = global_5.member[select((_e372 - _e241), _e372, (_e372 < _e241))];
                let _e410 = global_5.member[select((_e376 - _e241), _e376, (_e376 < _e241))];
                let _e414 = global_5.member[select((_e380 - _e241), _e380, (_e380 < _e241))];
                let _e418 = global_5.member[select((_e384 - _e241), _e384, (_e384 < _e241))];
                let _e422 = global_5.member[select((_e388 - _e241), _e388, (_e388 < _e241))];
                local_3 = (_e82 + 1u);
                local_4 = (_e84 + select(0f, 1f, (0f < select(0f, ((((((((_e394 * (_e339 * _e338)) + (_e398 * (_e340 * _e338))) + (_e402 * (_e341 * _e338))) + (_e406 * (_e342 * _e338))) + (_e410 * (_e339 * _e333))) + (_e414 * (_e340 * _e333))) + (_e418 * (_e341 * _e333))) + (_e422 * (_e342 * _e333))), (_e87 < _e68.w)))));
                continue;
            } else {
                break;
            }
            continuing {
                let _e453 = local_3;
                phi_259_ = _e453;
                let _e456 = local_4;
                phi_262_ = _e456;
            }
        }
        let _e438 = local;
        let _e441 = local_1;
        let _e445 = local_2;
        global_6.member[_e38] = select(select(u32(_e438), 0u, !((_e441 >= _e73))), 4294967295u, (_e445 > _e74));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn step_count(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
