struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_19 {
    member: u32,
    member_1: f32,
}

struct type_20 {
    member: type_19,
}

struct type_25 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_20;
@group(0) @binding(1) 
var<storage> global_4: type_9;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage> global_6: type_9;
@group(0) @binding(4) 
var<storage> global_7: type_9;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_6;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_25;

fn function_() {
    var phi_407_: f32;
    var phi_412_: f32;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_427_: f32;
    var phi_432_: f32;
    var phi_441_: f32;
    var phi_447_: bool;
    var phi_449_: bool;
    var phi_450_: bool;
    var phi_455_: f32;
    var phi_463_: bool;

    let _e44 = global;
    let _e45 = global_1;
    let _e46 = global_2;
    let _e54 = (((_e45.x + (_e45.y * _e46.x)) * 64u) + _e44.x);
    let _e57 = global_3.member.member;
    if (_e54 < _e57) {
        let _e60 = (_e45.z * 18u);
        let _e63 = global_4.member[_e60];
        let _e67 = global_4.member[(_e60 + 1u)];
        let _e71 = global_4.member[(_e60 + 2u)];
        let _e75 = global_4.member[(_e60 + 3u)];
        let _e79 = global_4.member[(_e60 + 4u)];
        let _e83 = global_4.member[(_e60 + 5u)];
        let _e87 = global_4.member[(_e60 + 6u)];
        let _e91 = global_4.member[(_e60 + 7u)];
        let _e95 = global_4.member[(_e60 + 8u)];
        let _e99 = global_4.member[(_e60 + 9u)];
        let _e103 = global_4.member[(_e60 + 10u)];
        let _e107 = global_4.member[(_e60 + 11u)];
        let _e111 = global_4.member[(_e60 + 12u)];
        let _e115 = global_4.member[(_e60 + 13u)];
        let _e119 = global_4.member[(_e60 + 14u)];
        let _e123 = global_4.member[(_e60 + 15u)];
        let _e127 = global_4.member[(_e60 + 16u)];
        let _e131 = global_4.member[(_e60 + 17u)];
        let _e134 = global_3.member.member_1;
        let _e135 = (_e54 * 3u);
        let _e138 = global_5.member[_e135];
        let _e139 = (_e135 + 1u);
        let _e142 = global_5.member[_e139];
        let _e143 = (_e135 + 2u);
        let _e146 = global_5.member[_e143];
        let _e147 = (_e54 * 4u);
        let _e150 = global_6.member[_e147];
        let _e154 = global_6.member[(_e147 + 1u)];
        let _e158 = global_6.member[(_e147 + 2u)];
        let _e162 = global_6.member[(_e147 + 3u)];
        let _e165 = global_7.member[_e135];
        let _e168 = global_7.member[_e139];
        let _e171 = global_7.member[_e143];
        let _e172 = (_e138 - _e99);
        let _e173 = (_e142 - _e103);
        let _e174 = (_e146 - _e107);
        let _e179 = (((_e63 * _e172) + (_e67 * _e173)) + (_e71 * _e174));
        let _e184 = (((_e75 * _e172) + (_e79 * _e173)) + (_e83 * _e174));
        let _e189 = (((_e87 * _e172) + (_e91 * _e173)) + (_e95 * _e174));
        let _e190 = (_e189 > 0.01f);
        let _e191 = select(1f, _e189, _e190);
        let _e194 = (((_e111 * _e179) / _e191) + _e119);
        let _e197 = (((_e115 * _e184) / _e191) + _e123);
        let _e198 = (1f / _e111);
        let _e199 = (1f / _e115);
        let _e202 = ((_e127 * _e198) * 0.15f);
        let _e203 = ((_e131 * _e199) * 0.15f);
        let _e208 = (((_e119 * _e198) * -1f) - _e202);
        let _e209 = (((_e123 * _e199) * -1f) - _e203);
        let _e214 = (((_e127 - _e119) * _e198) + _e202);
        let _e215 = (((_e131 - _e123) * _e199) + _e203);
        let _e216 = (_e179 / _e191);
        let _e218 = select(_e208, _e216, (_e216 > _e208));
        let _e220 = select(_e214, _e218, (_e218 < _e214));
        let _e221 = (_e184 / _e191);
        let _e223 = select(_e209, _e221, (_e221 > _e209));
        let _e225 = select(_e215, _e223, (_e223 < _e215));
        let _e226 = (_e111 / _e191);
        let _e227 = (_e115 / _e191);
        let _e234 = ((_e63 - (_e87 * _e220)) * _e226);
        let _e235 = ((_e67 - (_e91 * _e220)) * _e226);
        let _e236 = ((_e71 - (_e95 * _e220)) * _e226);
        let _e243 = ((_e75 - (_e87 * _e225)) * _e227);
        let _e244 = ((_e79 - (_e91 * _e225)) * _e227);
        let _e245 = ((_e83 - (_e95 * _e225)) * _e227);
        let _e254 = (1f / sqrt(((((_e150 * _e150) + (_e154 * _e154)) + (_e158 * _e158)) + (_e162 * _e162))));
        let _e255 = (_e150 * _e254);
        let _e256 = (_e154 * _e254);
        let _e257 = (_e158 * _e254);
        let _e258 = (_e162 * _e254);
        let _e259 = (_e257 * _e257);
        let _e260 = (_e258 * _e258);
        let _e263 = (1f - (2f * (_e259 + _e260)));
        let _e264 = (_e256 * _e257);
        let _e265 = (_e255 * _e258);
        let _e267 = (2f * (_e264 + _e265));
        let _e268 = (_e256 * _e258);
        let _e269 = (_e255 * _e257);
        let _e271 = (2f * (_e268 - _e269));
        let _e273 = (2f * (_e264 - _e265));
        let _e274 = (_e256 * _e256);
        let _e277 = (1f - (2f * (_e274 + _e260)));
        let _e278 = (_e257 * _e258);
        let _e279 = (_e255 * _e256);
        let _e281 = (2f * (_e278 + _e279));
        let _e283 = (2f * (_e268 + _e269));
        let _e285 = (2f * (_e278 - _e279));
        let _e288 = (1f - (2f * (_e274 + _e259)));
        let _e289 = exp(_e165);
        let _e290 = exp(_e168);
        let _e291 = exp(_e171);
        let _e307 = ((((_e234 * _e263) + (_e235 * _e267)) + (_e236 * _e271)) * _e289);
        let _e308 = ((((_e234 * _e273) + (_e235 * _e277)) + (_e236 * _e281)) * _e290);
        let _e309 = ((((_e234 * _e283) + (_e235 * _e285)) + (_e236 * _e288)) * _e291);
        let _e325 = ((((_e243 * _e263) + (_e244 * _e267)) + (_e245 * _e271)) * _e289);
        let _e326 = ((((_e243 * _e273) + (_e244 * _e277)) + (_e245 * _e281)) * _e290);
        let _e327 = ((((_e243 * _e283) + (_e244 * _e285)) + (_e245 * _e288)) * _e291);
        let _e332 = (((_e307 * _e307) + (_e308 * _e308)) + (_e309 * _e309));
        let _e337 = (((_e307 * _e325) + (_e308 * _e326)) + (_e309 * _e327));
        let _e342 = (((_e325 * _e325) + (_e326 * _e326)) + (_e327 * _e327));
        let _e343 = (_e332 + _e134);
        let _e344 = (_e342 + _e134);
        let _e347 = ((_e308 * _e327) - (_e309 * _e326));
        let _e350 = ((_e309 * _e325) - (_e307 * _e327));
        let _e353 = ((_e307 * _e326) - (_e308 * _e325));
        let _e363 = (((((_e347 * _e347) + (_e350 * _e350)) + (_e353 * _e353)) + (_e134 * (_e332 + _e342))) + (_e134 * _e134));
        let _e365 = (1f / _e363);
        let _e366 = (_e344 * _e365);
        let _e367 = (-(_e337) * _e365);
        let _e368 = (_e343 * _e365);
        let _e370 = (0.5f * (_e343 - _e344));
        let _e379 = sqrt((11.082527f * ((0.5f * (_e343 + _e344)) + sqrt(((_e370 * _e370) + (_e337 * _e337))))));
        if (_e366 < 0f) {
            phi_407_ = -(_e366);
        } else {
            phi_407_ = _e366;
        }
        let _e391 = phi_407_;
        if (_e367 < 0f) {
            phi_412_ = -(_e367);
        } else {
            phi_412_ = _e367;
        }
        let _e395 = phi_412_;
        if (_e368 < 0f) {
            phi_417_ = -(_e368);
        } else {
            phi_417_ = _e368;
        }
        let _e400 = phi_417_;
        if (_e194 < 0f) {
            phi_422_ = -(_e194);
        } else {
            phi_422_ = _e194;
        }
        let _e405 = phi_422_;
        if (_e197 < 0f) {
            phi_427_ = -(_e197);
        } else {
            phi_427_ = _e197;
        }
        let _e410 = phi_427_;
        let _e412 = (((((_e391 + _e395) + _e400) + _e405) + _e410) + _e379);
        let _e413 = (_e189 < 0f);
        if _e413 {
            phi_432_ = -(_e189);
        } else {
            phi_432_ = _e189;
        }
        let _e416 = phi_432_;
        if (_e416 <= 0x1.fffffep+127f) {
            if (_e412 < 0f) {
                phi_441_ = -(_e412);
            } else {
                phi_441_ = _e412;
            }
            let _e421 = phi_441_;
            let _e422 = (_e421 <= 0x1.fffffep+127f);
            if _e422 {
                phi_447_ = (_e363 > 0f);
            } else {
                phi_447_ = bool();
            }
            let _e425 = phi_447_;
            phi_449_ = _e425;
            phi_450_ = select(true, false, _e422);
        } else {
            phi_449_ = bool();
            phi_450_ = true;
        }
        let _e428 = phi_449_;
        let _e430 = phi_450_;
        if _e413 {
            phi_455_ = -(_e189);
        } else {
            phi_455_ = _e189;
        }
        let _e434 = phi_455_;
        if _e190 {
            phi_463_ = select(true, false, select(_e428, false, _e430));
        } else {
            phi_463_ = true;
        }
        let _e440 = phi_463_;
        let _e441 = select(_e379, select(-1f, -2f, select(true, _e190, (_e434 <= 0x1.fffffep+127f))), _e440);
        let _e444 = (2u * ((_e45.z * _e57) + _e54));
        global_8.member[_e444] = vec4<f32>(_e194, _e197, _e441, ((sqrt((11.082527f * _e343)) * 1.001f) + 0.01f));
        global_8.member[(_e444 + 1u)] = vec4<f32>(_e366, _e367, _e368, ((sqrt((11.082527f * _e344)) * 1.001f) + 0.01f));
        if (_e441 == -2f) {
            let _e455 = atomicAdd((&global_9.member[0u]), 1u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn project(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
