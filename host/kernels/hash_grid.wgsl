struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_15 {
    member: array<type_13>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_5;
@group(0) @binding(0) 
var<uniform> global_5: type_11;
@group(0) @binding(1) 
var<storage> global_6: type_15;
@group(0) @binding(2) 
var<storage> global_7: type_5;

fn function_() {
    var phi_206_: f32;
    var phi_226_: f32;
    var phi_246_: f32;
    var phi_270_: u32;
    var phi_290_: u32;
    var phi_309_: u32;
    var phi_328_: u32;
    var phi_347_: u32;
    var phi_366_: u32;
    var phi_385_: u32;
    var phi_404_: u32;
    var phi_424_: u32;
    var phi_427_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e31 = global_2;
            let _e39 = (((_e30.x + (_e30.y * _e31.x)) * 64u) + _e29.x);
            let _e42 = global_5.member.member;
            if (_e39 < _e42) {
                let _e47 = global_6.member[_e30.z];
                let _e50 = global_5.member.member_1;
                let _e53 = global_5.member.member_6;
                let _e56 = global_5.member.member_5;
                let _e57 = (_e56 == 0u);
                if _e57 {
                    break;
                }
                let _e58 = (_e39 / _e56);
                if _e57 {
                    break;
                }
                let _e61 = (_e39 % _e56);
                let _e62 = ((_e58 * (_e53 * _e50)) + _e61);
                let _e65 = global_4.member[_e62];
                let _e66 = (3u * _e50);
                let _e70 = global_4.member[(_e62 + _e66)];
                let _e71 = (_e50 + _e62);
                let _e74 = global_4.member[_e71];
                let _e78 = global_4.member[(_e71 + _e66)];
                let _e80 = ((2u * _e50) + _e62);
                let _e83 = global_4.member[_e80];
                let _e87 = global_4.member[(_e80 + _e66)];
                let _e90 = global_5.member.member_4;
                let _e91 = (_e90 != 0u);
                let _e92 = (_e65 + _e70);
                let _e95 = select(false, (_e92 < 1f), (0f < _e92));
                let _e98 = select(select(0f, 1f, (1f <= _e92)), _e65, _e95);
                let _e101 = (_e98 * _e47.member);
                let _e104 = (_e47.member + _e47.member_1);
                let _e108 = trunc(_e101);
                let _e110 = ((_e101 - _e108) + (((_e98 * _e47.member_1) + (select(0f, _e70, _e95) * _e104)) + 0.5f));
                let _e112 = select(0f, _e110, (_e110 > 0f));
                let _e113 = trunc(_e112);
                let _e114 = (_e112 - _e113);
                let _e115 = (_e108 + _e113);
                let _e120 = select(select(u32(_e115), 0u, (_e115 < 0f)), 4294967295u, (_e115 > 4294967000f));
                if _e91 {
                    phi_206_ = ((_e114 * _e114) * (3f - (2f * _e114)));
                } else {
                    phi_206_ = _e114;
                }
                let _e126 = phi_206_;
                let _e127 = (_e74 + _e78);
                let _e130 = select(false, (_e127 < 1f), (0f < _e127));
                let _e133 = select(select(0f, 1f, (1f <= _e127)), _e74, _e130);
                let _e135 = (_e133 * _e47.member);
                let _e140 = trunc(_e135);
                let _e142 = ((_e135 - _e140) + (((_e133 * _e47.member_1) + (select(0f, _e78, _e130) * _e104)) + 0.5f));
                let _e144 = select(0f, _e142, (_e142 > 0f));
                let _e145 = trunc(_e144);
                let _e146 = (_e144 - _e145);
                let _e147 = (_e140 + _e145);
                let _e152 = select(select(u32(_e147), 0u, (_e147 < 0f)), 4294967295u, (_e147 > 4294967000f));
                if _e91 {
                    phi_226_ = ((_e146 * _e146) * (3f - (2f * _e146)));
                } else {
                    phi_226_ = _e146;
                }
                let _e158 = phi_226_;
                let _e159 = (_e83 + _e87);
                let _e162 = select(false, (_e159 < 1f), (0f < _e159));
                let _e165 = select(select(0f, 1f, (1f <= _e159)), _e83, _e162);
                let _e167 = (_e165 * _e47.member);
                let _e172 = trunc(_e167);
                let _e174 = ((_e167 - _e172) + (((_e165 * _e47.member_1) + (select(0f, _e87, _e162) * _e104)) + 0.5f));
                let _e176 = select(0f, _e174, (_e174 > 0f));
                let _e177 = trunc(_e176);
                let _e178 = (_e176 - _e177);
                let _e179 = (_e172 + _e177);
                let _e184 = select(select(u32(_e179), 0u, (_e179 < 0f)), 4294967295u, (_e179 > 4294967000f));
                if _e91 {
                    phi_246_ = ((_e178 * _e178) * (3f - (2f * _e178)));
                } else {
                    phi_246_ = _e178;
                }
                let _e190 = phi_246_;
                let _e191 = (_e120 + 1u);
                let _e192 = (_e152 + 1u);
                let _e193 = (_e184 + 1u);
                let _e196 = (_e47.member_5 == 0u);
                if _e196 {
                    let _e201 = (_e120 + ((_e152 + (_e184 * _e47.member_2)) * _e47.member_2));
                    phi_270_ = select((_e201 - _e47.member_4), _e201, (_e201 < _e47.member_4));
                } else {
                    phi_270_ = (((_e120 ^ (_e152 * 2654435761u)) ^ (_e184 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e212 = phi_270_;
                if _e196 {
                    let _e219 = (_e191 + ((_e152 + (_e184 * _e47.member_2)) * _e47.member_2));
                    phi_290_ = select((_e219 - _e47.member_4), _e219, (_e219 < _e47.member_4));
                } else {
                    phi_290_ = (((_e191 ^ (_e152 * 2654435761u)) ^ (_e184 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e230 = phi_290_;
                if _e196 {
                    let _e236 = (_e120 + ((_e192 + (_e184 * _e47.member_2)) * _e47.member_2));
                    phi_309_ = select((_e236 - _e47.member_4), _e236, (_e236 < _e47.member_4));
                } else {
                    phi_309_ = (((_e120 ^ (_e192 * 2654435761u)) ^ (_e184 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e247 = phi_309_;
                if _e196 {
                    let _e253 = (_e191 + ((_e192 + (_e184 * _e47.member_2)) * _e47.member_2));
                    phi_328_ = select((_e253 - _e47.member_4), _e253, (_e253 < _e47.member_4));
                } else {
                    phi_328_ = (((_e191 ^ (_e192 * 2654435761u)) ^ (_e184 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e264 = phi_328_;
                if _e196 {
                    let _e270 = (_e120 + ((_e152 + (_e193 * _e47.member_2)) * _e47.member_2));
                    phi_347_ = select((_e270 - _e47.member_4), _e270, (_e270 < _e47.member_4));
                } else {
                    phi_347_ = (((_e120 ^ (_e152 * 2654435761u)) ^ (_e193 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e281 = phi_347_;
                if _e196 {
                    let _e287 = (_e191 + ((_e152 + (_e193 * _e47.member_2)) * _e47.member_2));
                    phi_366_ = select((_e287 - _e47.member_4), _e287, (_e287 < _e47.member_4));
                } else {
                    phi_366_ = (((_e191 ^ (_e152 * 2654435761u)) ^ (_e193 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e298 = phi_366_;
                if _e196 {
                    let _e304 = (_e120 + ((_e192 + (_e193 * _e47.member_2)) * _e47.member_2));
                    phi_385_ = select((_e304 - _e47.member_4), _e304, (_e304 < _e47.member_4));
                } else {
                    phi_385_ = (((_e120 ^ (_e192 * 2654435761u)) ^ (_e193 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e315 = phi_385_;
                if _e196 {
                    let _e321 = (_e191 + ((_e192 + (_e193 * _e47.member_2)) * _e47.member_2));
                    phi_404_ = select((_e321 - _e47.member_4), _e321, (_e321 < _e47.member_4));
                } else {
                    phi_404_ = (((_e191 ^ (_e192 * 2654435761u)) ^ (_e193 * 805459861u)) & (_e47.member_4 - 1u));
                }
                let _e332 = phi_404_;
                let _e334 = (1f - _e126);
                let _e335 = (1f - _e158);
                let _e336 = (1f - _e190);
                let _e337 = (_e334 * _e335);
                let _e338 = (_e126 * _e335);
                let _e339 = (_e334 * _e158);
                let _e340 = (_e126 * _e158);
                let _e351 = global_5.member.member_3;
                let _e354 = global_5.member.member_2;
                let _e359 = global_5.member.member_7;
                if _e57 {
                    break;
                }
                if _e57 {
                    break;
                }
                phi_424_ = 0u;
                phi_427_ = (((_e58 * (_e359 * _e50)) + _e61) + ((_e354 + (_e30.z * _e351)) * _e50));
                loop {
                    let _e366 = phi_424_;
                    let _e368 = phi_427_;
                    if (_e366 < _e351) {
                        let _e374 = global_7.member[(((_e212 + _e47.member_3) * _e351) + _e366)];
                        let _e380 = global_7.member[(((_e230 + _e47.member_3) * _e351) + _e366)];
                        let _e386 = global_7.member[(((_e247 + _e47.member_3) * _e351) + _e366)];
                        let _e392 = global_7.member[(((_e264 + _e47.member_3) * _e351) + _e366)];
                        let _e398 = global_7.member[(((_e281 + _e47.member_3) * _e351) + _e366)];
                        let _e404 = global_7.member[(((_e298 + _e47.member_3) * _e351) + _e366)];
                        let _e410 = global_7.member[(((_e315 + _e47.member_3) * _e351) + _e366)];
                        let _e416 = global_7.member[(((_e332 + _e47.member_3) * _e351) + _e366)];
                        global_3.member[_e368] = ((((((((_e374 * (_e337 * _e336)) + (_e380 * (_e338 * _e336))) + (_e386 * (_e339 * _e336))) + (_e392 * (_e340 * _e336))) + (_e398 * (_e337 * _e190))) + (_e404 * (_e338 * _e190))) + (_e410 * (_e339 * _e190))) + (_e416 * (_e340 * _e190)));
                        local = (_e366 + 1u);
                        local_1 = (_e368 + _e50);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e442 = local;
                        phi_424_ = _e442;
                        let _e445 = local_1;
                        phi_427_ = _e445;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
