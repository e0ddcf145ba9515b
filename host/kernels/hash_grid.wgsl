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
@group(0) @binding(3) 
var<storage> global_3: type_5;
@group(0) @binding(0) 
var<uniform> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_5;
@group(0) @binding(2) 
var<storage> global_7: type_5;

fn function_() {
    var phi_240_: u32;
    var phi_260_: u32;
    var phi_279_: u32;
    var phi_298_: u32;
    var phi_317_: u32;
    var phi_336_: u32;
    var phi_355_: u32;
    var phi_374_: u32;
    var phi_394_: u32;
    var phi_397_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global;
            let _e27 = global_1;
            let _e28 = global_2;
            let _e36 = (((_e27.x + (_e27.y * _e28.x)) * 64u) + _e26.x);
            let _e39 = global_4.member.member;
            if (_e36 < _e39) {
                let _e44 = global_5.member[_e27.z];
                let _e47 = global_4.member.member_1;
                let _e50 = global_4.member.member_5;
                let _e53 = global_4.member.member_4;
                let _e54 = (_e53 == 0u);
                if _e54 {
                    break;
                }
                let _e55 = (_e36 / _e53);
                if _e54 {
                    break;
                }
                let _e58 = (_e36 % _e53);
                let _e59 = ((_e55 * (_e50 * _e47)) + _e58);
                let _e62 = global_3.member[_e59];
                let _e63 = (3u * _e47);
                let _e67 = global_3.member[(_e59 + _e63)];
                let _e68 = (_e47 + _e59);
                let _e71 = global_3.member[_e68];
                let _e75 = global_3.member[(_e68 + _e63)];
                let _e77 = ((2u * _e47) + _e59);
                let _e80 = global_3.member[_e77];
                let _e84 = global_3.member[(_e77 + _e63)];
                let _e85 = (_e62 + _e67);
                let _e88 = select(false, (_e85 < 1f), (0f < _e85));
                let _e91 = select(select(0f, 1f, (1f <= _e85)), _e62, _e88);
                let _e94 = (_e91 * _e44.member);
                let _e97 = (_e44.member + _e44.member_1);
                let _e101 = trunc(_e94);
                let _e103 = ((_e94 - _e101) + (((_e91 * _e44.member_1) + (select(0f, _e67, _e88) * _e97)) + 0.5f));
                let _e105 = select(0f, _e103, (_e103 > 0f));
                let _e106 = trunc(_e105);
                let _e107 = (_e105 - _e106);
                let _e108 = (_e101 + _e106);
                let _e113 = select(select(u32(_e108), 0u, (_e108 < 0f)), 4294967295u, (_e108 > 4294967000f));
                let _e114 = (_e71 + _e75);
                let _e117 = select(false, (_e114 < 1f), (0f < _e114));
                let _e120 = select(select(0f, 1f, (1f <= _e114)), _e71, _e117);
                let _e122 = (_e120 * _e44.member);
                let _e127 = trunc(_e122);
                let _e129 = ((_e122 - _e127) + (((_e120 * _e44.member_1) + (select(0f, _e75, _e117) * _e97)) + 0.5f));
                let _e131 = select(0f, _e129, (_e129 > 0f));
                let _e132 = trunc(_e131);
                let _e133 = (_e131 - _e132);
                let _e134 = (_e127 + _e132);
                let _e139 = select(select(u32(_e134), 0u, (_e134 < 0f)), 4294967295u, (_e134 > 4294967000f));
                let _e140 = (_e80 + _e84);
                let _e143 = select(false, (_e140 < 1f), (0f < _e140));
                let _e146 = select(select(0f, 1f, (1f <= _e140)), _e80, _e143);
                let _e148 = (_e146 * _e44.member);
                let _e153 = trunc(_e148);
                let _e155 = ((_e148 - _e153) + (((_e146 * _e44.member_1) + (select(0f, _e84, _e143) * _e97)) + 0.5f));
                let _e157 = select(0f, _e155, (_e155 > 0f));
                let _e158 = trunc(_e157);
                let _e159 = (_e157 - _e158);
                let _e160 = (_e153 + _e158);
                let _e165 = select(select(u32(_e160), 0u, (_e160 < 0f)), 4294967295u, (_e160 > 4294967000f));
                let _e166 = (_e113 + 1u);
                let _e167 = (_e139 + 1u);
                let _e168 = (_e165 + 1u);
                let _e171 = (_e44.member_5 == 0u);
                if _e171 {
                    let _e176 = (_e113 + ((_e139 + (_e165 * _e44.member_2)) * _e44.member_2));
                    phi_240_ = select((_e176 - _e44.member_4), _e176, (_e176 < _e44.member_4));
                } else {
                    phi_240_ = (((_e113 ^ (_e139 * 2654435761u)) ^ (_e165 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e187 = phi_240_;
                if _e171 {
                    let _e194 = (_e166 + ((_e139 + (_e165 * _e44.member_2)) * _e44.member_2));
                    phi_260_ = select((_e194 - _e44.member_4), _e194, (_e194 < _e44.member_4));
                } else {
                    phi_260_ = (((_e166 ^ (_e139 * 2654435761u)) ^ (_e165 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e205 = phi_260_;
                if _e171 {
                    let _e211 = (_e113 + ((_e167 + (_e165 * _e44.member_2)) * _e44.member_2));
                    phi_279_ = select((_e211 - _e44.member_4), _e211, (_e211 < _e44.member_4));
                } else {
                    phi_279_ = (((_e113 ^ (_e167 * 2654435761u)) ^ (_e165 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e222 = phi_279_;
                if _e171 {
                    let _e228 = (_e166 + ((_e167 + (_e165 * _e44.member_2)) * _e44.member_2));
                    phi_298_ = select((_e228 - _e44.member_4), _e228, (_e228 < _e44.member_4));
                } else {
                    phi_298_ = (((_e166 ^ (_e167 * 2654435761u)) ^ (_e165 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e239 = phi_298_;
                if _e171 {
                    let _e245 = (_e113 + ((_e139 + (_e168 * _e44.member_2)) * _e44.member_2));
                    phi_317_ = select((_e245 - _e44.member_4), _e245, (_e245 < _e44.member_4));
                } else {
                    phi_317_ = (((_e113 ^ (_e139 * 2654435761u)) ^ (_e168 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e256 = phi_317_;
                if _e171 {
                    let _e262 = (_e166 + ((_e139 + (_e168 * _e44.member_2)) * _e44.member_2));
                    phi_336_ = select((_e262 - _e44.member_4), _e262, (_e262 < _e44.member_4));
                } else {
                    phi_336_ = (((_e166 ^ (_e139 * 2654435761u)) ^ (_e168 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e273 = phi_336_;
                if _e171 {
                    let _e279 = (_e113 + ((_e167 + (_e168 * _e44.member_2)) * _e44.member_2));
                    phi_355_ = select((_e279 - _e44.member_4), _e279, (_e279 < _e44.member_4));
                } else {
                    phi_355_ = (((_e113 ^ (_e167 * 2654435761u)) ^ (_e168 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e290 = phi_355_;
                if _e171 {
                    let _e296 = (_e166 + ((_e167 + (_e168 * _e44.member_2)) * _e44.member_2));
                    phi_374_ = select((_e296 - _e44.member_4), _e296, (_e296 < _e44.member_4));
                } else {
                    phi_374_ = (((_e166 ^ (_e167 * 2654435761u)) ^ (_e168 * 805459861u)) & (_e44.member_4 - 1u));
                }
                let _e307 = phi_374_;
                let _e309 = (1f - _e107);
                let _e310 = (1f - _e133);
                let _e311 = (1f - _e159);
                let _e312 = (_e309 * _e310);
                let _e313 = (_e107 * _e310);
                let _e314 = (_e309 * _e133);
                let _e315 = (_e107 * _e133);
                let _e326 = global_4.member.member_3;
                let _e329 = global_4.member.member_2;
                let _e334 = global_4.member.member_6;
                if _e54 {
                    break;
                }
                if _e54 {
                    break;
                }
                phi_394_ = 0u;
                phi_397_ = (((_e55 * (_e334 * _e47)) + _e58) + ((_e329 + (_e27.z * _e326)) * _e47));
                loop {
                    let _e341 = phi_394_;
                    let _e343 = phi_397_;
                    if (_e341 < _e326) {
                        let _e349 = global_7.member[(((_e187 + _e44.member_3) * _e326) + _e341)];
                        let _e355 = global_7.member[(((_e205 + _e44.member_3) * _e326) + _e341)];
                        let _e361 = global_7.member[(((_e222 + _e44.member_3) * _e326) + _e341)];
                        let _e367 = global_7.member[(((_e239 + _e44.member_3) * _e326) + _e341)];
                        let _e373 = global_7.member[(((_e256 + _e44.member_3) * _e326) + _e341)];
                        let _e379 = global_7.member[(((_e273 + _e44.member_3) * _e326) + _e341)];
                        let _e385 = global_7.member[(((_e290 + _e44.member_3) * _e326) + _e341)];
                        let _e391 = global_7.member[(((_e307 + _e44.member_3) * _e326) + _e341)];
                        global_6.member[_e343] = ((((((((_e349 * (_e312 * _e311)) + (_e355 * (_e313 * _e311))) + (_e361 * (_e314 * _e311))) + (_e367 * (_e315 * _e311))) + (_e373 * (_e312 * _e159))) + (_e379 * (_e313 * _e159))) + (_e385 * (_e314 * _e159))) + (_e391 * (_e315 * _e159)));
                        local = (_e341 + 1u);
                        local_1 = (_e343 + _e47);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e414 = local;
                        phi_394_ = _e414;
                        let _e417 = local_1;
                        phi_397_ = _e417;
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
