struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_20 {
    member: array<type_18>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_5;
@group(0) @binding(0) 
var<uniform> global_5: type_16;
@group(0) @binding(1) 
var<storage> global_6: type_20;
@group(0) @binding(2) 
var<storage> global_7: type_12;

fn function_() {
    var phi_248_: f32;
    var phi_268_: f32;
    var phi_288_: f32;
    var phi_312_: u32;
    var phi_332_: u32;
    var phi_351_: u32;
    var phi_370_: u32;
    var phi_389_: u32;
    var phi_408_: u32;
    var phi_427_: u32;
    var phi_446_: u32;
    var phi_457_: u32;
    var phi_474_: u32;
    var phi_477_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = global;
            let _e36 = global_1;
            let _e37 = global_2;
            let _e45 = (((_e36.x + (_e36.y * _e37.x)) * 64u) + _e35.x);
            let _e48 = global_5.member.member;
            if (_e45 < _e48) {
                let _e53 = global_6.member[_e36.z];
                let _e56 = global_5.member.member_1;
                let _e59 = global_5.member.member_6;
                let _e62 = global_5.member.member_5;
                let _e63 = (_e62 == 0u);
                if _e63 {
                    break;
                }
                let _e64 = (_e45 / _e62);
                if _e63 {
                    break;
                }
                let _e67 = (_e45 % _e62);
                let _e68 = ((_e64 * (_e59 * _e56)) + _e67);
                let _e71 = global_4.member[_e68];
                let _e72 = (3u * _e56);
                let _e76 = global_4.member[(_e68 + _e72)];
                let _e77 = (_e56 + _e68);
                let _e80 = global_4.member[_e77];
                let _e84 = global_4.member[(_e77 + _e72)];
                let _e85 = (2u * _e56);
                let _e86 = (_e85 + _e68);
                let _e89 = global_4.member[_e86];
                let _e93 = global_4.member[(_e86 + _e72)];
                let _e96 = global_5.member.member_4;
                let _e97 = (_e96 != 0u);
                let _e98 = (_e71 + _e76);
                let _e101 = select(false, (_e98 < 1f), (0f < _e98));
                let _e104 = select(select(0f, 1f, (1f <= _e98)), _e71, _e101);
                let _e107 = (_e104 * _e53.member);
                let _e110 = (_e53.member + _e53.member_1);
                let _e114 = trunc(_e107);
                let _e116 = ((_e107 - _e114) + (((_e104 * _e53.member_1) + (select(0f, _e76, _e101) * _e110)) + 0.5f));
                let _e118 = select(0f, _e116, (_e116 > 0f));
                let _e119 = trunc(_e118);
                let _e120 = (_e118 - _e119);
                let _e121 = (_e114 + _e119);
                let _e126 = select(select(u32(_e121), 0u, (_e121 < 0f)), 4294967295u, (_e121 > 4294967000f));
                if _e97 {
                    phi_248_ = ((_e120 * _e120) * (3f - (2f * _e120)));
                } else {
                    phi_248_ = _e120;
                }
                let _e132 = phi_248_;
                let _e133 = (_e80 + _e84);
                let _e136 = select(false, (_e133 < 1f), (0f < _e133));
                let _e139 = select(select(0f, 1f, (1f <= _e133)), _e80, _e136);
                let _e141 = (_e139 * _e53.member);
                let _e146 = trunc(_e141);
                let _e148 = ((_e141 - _e146) + (((_e139 * _e53.member_1) + (select(0f, _e84, _e136) * _e110)) + 0.5f));
                let _e150 = select(0f, _e148, (_e148 > 0f));
                let _e151 = trunc(_e150);
                let _e152 = (_e150 - _e151);
                let _e153 = (_e146 + _e151);
                let _e158 = select(select(u32(_e153), 0u, (_e153 < 0f)), 4294967295u, (_e153 > 4294967000f));
                if _e97 {
                    phi_268_ = ((_e152 * _e152) * (3f - (2f * _e152)));
                } else {
                    phi_268_ = _e152;
                }
                let _e164 = phi_268_;
                let _e165 = (_e89 + _e93);
                let _e168 = select(false, (_e165 < 1f), (0f < _e165));
                let _e171 = select(select(0f, 1f, (1f <= _e165)), _e89, _e168);
                let _e173 = (_e171 * _e53.member);
                let _e178 = trunc(_e173);
                let _e180 = ((_e173 - _e178) + (((_e171 * _e53.member_1) + (select(0f, _e93, _e168) * _e110)) + 0.5f));
                let _e182 = select(0f, _e180, (_e180 > 0f));
                let _e183 = trunc(_e182);
                let _e184 = (_e182 - _e183);
                let _e185 = (_e178 + _e183);
                let _e190 = select(select(u32(_e185), 0u, (_e185 < 0f)), 4294967295u, (_e185 > 4294967000f));
                if _e97 {
                    phi_288_ = ((_e184 * _e184) * (3f - (2f * _e184)));
                } else {
                    phi_288_ = _e184;
                }
                let _e196 = phi_288_;
                let _e197 = (_e126 + 1u);
                let _e198 = (_e158 + 1u);
                let _e199 = (_e190 + 1u);
                let _e202 = (_e53.member_5 == 0u);
                if _e202 {
                    let _e213 = (_e126 + ((_e158 + (_e190 * _e53.member_2)) * _e53.member_2));
                    phi_312_ = select((_e213 - _e53.member_4), _e213, (_e213 < _e53.member_4));
                } else {
                    phi_312_ = (((_e126 ^ (_e158 * 2654435761u)) ^ (_e190 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e218 = phi_312_;
                if _e202 {
                    let _e231 = (_e197 + ((_e158 + (_e190 * _e53.member_2)) * _e53.member_2));
                    phi_332_ = select((_e231 - _e53.member_4), _e231, (_e231 < _e53.member_4));
                } else {
                    phi_332_ = (((_e197 ^ (_e158 * 2654435761u)) ^ (_e190 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e236 = phi_332_;
                if _e202 {
                    let _e248 = (_e126 + ((_e198 + (_e190 * _e53.member_2)) * _e53.member_2));
                    phi_351_ = select((_e248 - _e53.member_4), _e248, (_e248 < _e53.member_4));
                } else {
                    phi_351_ = (((_e126 ^ (_e198 * 2654435761u)) ^ (_e190 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e253 = phi_351_;
                if _e202 {
                    let _e265 = (_e197 + ((_e198 + (_e190 * _e53.member_2)) * _e53.member_2));
                    phi_370_ = select((_e265 - _e53.member_4), _e265, (_e265 < _e53.member_4));
                } else {
                    phi_370_ = (((_e197 ^ (_e198 * 2654435761u)) ^ (_e190 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e270 = phi_370_;
                if _e202 {
                    let _e282 = (_e126 + ((_e158 + (_e199 * _e53.member_2)) * _e53.member_2));
                    phi_389_ = select((_e282 - _e53.member_4), _e282, (_e282 < _e53.member_4));
                } else {
                    phi_389_ = (((_e126 ^ (_e158 * 2654435761u)) ^ (_e199 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e287 = phi_389_;
                if _e202 {
                    let _e299 = (_e197 + ((_e158 + (_e199 * _e53.member_2)) * _e53.member_2));
                    phi_408_ = select((_e299 - _e53.member_4), _e299, (_e299 < _e53.member_4));
                } else {
                    phi_408_ = (((_e197 ^ (_e158 * 2654435761u)) ^ (_e199 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e304 = phi_408_;
                if _e202 {
                    let _e316 = (_e126 + ((_e198 + (_e199 * _e53.member_2)) * _e53.member_2));
                    phi_427_ = select((_e316 - _e53.member_4), _e316, (_e316 < _e53.member_4));
                } else {
                    phi_427_ = (((_e126 ^ (_e198 * 2654435761u)) ^ (_e199 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e321 = phi_427_;
                if _e202 {
                    let _e333 = (_e197 + ((_e198 + (_e199 * _e53.member_2)) * _e53.member_2));
                    phi_446_ = select((_e333 - _e53.member_4), _e333, (_e333 < _e53.member_4));
                } else {
                    phi_446_ = (((_e197 ^ (_e198 * 2654435761u)) ^ (_e199 * 805459861u)) & (_e53.member_4 - 1u));
                }
                let _e338 = phi_446_;
                let _e340 = (1f - _e132);
                let _e341 = (1f - _e164);
                let _e342 = (1f - _e196);
                let _e343 = (_e340 * _e341);
                let _e344 = (_e132 * _e341);
                let _e345 = (_e340 * _e164);
                let _e346 = (_e132 * _e164);
                let _e347 = (_e343 * _e342);
                let _e348 = (_e344 * _e342);
                let _e349 = (_e345 * _e342);
                let _e350 = (_e346 * _e342);
                let _e351 = (_e343 * _e196);
                let _e352 = (_e344 * _e196);
                let _e353 = (_e345 * _e196);
                let _e354 = (_e346 * _e196);
                let _e357 = global_5.member.member_3;
                let _e358 = (_e357 / 2u);
                if ((_e357 % 2u) > 0u) {
                    phi_457_ = (_e358 + 1u);
                } else {
                    phi_457_ = _e358;
                }
                let _e363 = phi_457_;
                let _e366 = global_5.member.member_2;
                let _e371 = global_5.member.member_7;
                if _e63 {
                    break;
                }
                if _e63 {
                    break;
                }
                phi_474_ = 0u;
                phi_477_ = (((_e64 * (_e371 * _e56)) + _e67) + ((_e366 + (_e36.z * _e357)) * _e56));
                loop {
                    let _e378 = phi_474_;
                    let _e380 = phi_477_;
                    if (_e378 < _e363) {
                        let _e386 = global_7.member[(((_e218 + _e53.member_3) * _e363) + _e378)];
                        let _e387 = (_e386 & 65535u);
                        let _e398 = (_e386 >> bitcast<u32>(16i));
                        let _e414 = global_7.member[(((_e236 + _e53.member_3) * _e363) + _e378)];
                        let _e415 = (_e414 & 65535u);
                        let _e426 = (_e414 >> bitcast<u32>(16i));
                        let _e442 = global_7.member[(((_e253 + _e53.member_3) * _e363) + _e378)];
                        let _e443 = (_e442 & 65535u);
                        let _e454 = (_e442 >> bitcast<u32>(16i));
                        let _e470 = global_7.member[(((_e270 + _e53.member_3) * _e363) + _e378)];
                        let _e471 = (_e470 & 65535u);
                        let _e482 = (_e470 >> bitcast<u32>(16i));
                        let _e498 = global_7.member[(((_e287 + _e53.member_3) * _e363) + _e378)];
                        let _e499 = (_e498 & 65535u);
                        let _e510 = (_e498 >> bitcast<u32>(16i));
                        let _e526 = global_7.member[(((_e304 + _e53.member_3) * _e363) + _e378)];
                        let _e527 = (_e526 & 65535u);
                        let _e538 = (_e526 >> bitcast<u32>(16i));
                        let _e554 = global_7.member[(((_e321 + _e53.member_3) * _e363) + _e378)];
                        let _e555 = (_e554 & 65535u);
                        let _e566 = (_e554 >> bitcast<u32>(16i));
                        let _e582 = global_7.member[(((_e338 + _e53.member_3) * _e363) + _e378)];
                        let _e583 = (_e582 & 65535u);
                        let _e594 = (_e582 >> bitcast<u32>(16i));
                        global_3.member[_e380] = (((((((((bitcast<f32>((((_e387 & 32768u) << bitcast<u32>(16i)) | ((_e387 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e347) + ((bitcast<f32>((((_e415 & 32768u) << bitcast<u32>(16i)) | ((_e415 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e348)) + ((bitcast<f32>((((_e443 & 32768u) << bitcast<u32>(16i)) | ((_e443 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e349)) + ((bitcast<f32>((((_e471 & 32768u) << bitcast<u32>(16i)) | ((_e471 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e350)) + ((bitcast<f32>((((_e499 & 32768u) << bitcast<u32>(16i)) | ((_e499 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e351)) + ((bitcast<f32>((((_e527 & 32768u) << bitcast<u32>(16i)) | ((_e527 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e352)) + ((bitcast<f32>((((_e555 & 32768u) << bitcast<u32>(16i)) | ((_e555 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e353)) + ((bitcast<f32>((((_e583 & 32768u) << bitcast<u32>(16i)) | ((_e583 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e354));
                        if (((2u * _e378) + 1u) < _e357) {
                            global_3.member[(_e380 + _e56)] = (((((((((bitcast<f32>((((_e398 & 32768u) << bitcast<u32>(16i)) | ((_e398 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e347) + ((bitcast<f32>((((_e426 & 32768u) << bitcast<u32>(16i)) | ((_e426 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e348)) + ((bitcast<f32>((((_e454 & 32768u) << bitcast<u32>(16i)) | ((_e454 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e349)) + ((bitcast<f32>((((_e482 & 32768u) << bitcast<u32>(16i)) | ((_e482 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e350)) + ((bitcast<f32>((((_e510 & 32768u) << bitcast<u32>(16i)) | ((_e510 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e351)) + ((bitcast<f32>((((_e538 & 32768u) << bitcast<u32>(16i)) | ((_e538 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e352)) + ((bitcast<f32>((((_e566 & 32768u) << bitcast<u32>(16i)) | ((_e566 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e353)) + ((bitcast<f32>((((_e594 & 32768u) << bitcast<u32>(16i)) | ((_e594 & 32767u) << bitcast<u32>(13i)))) * 5192297000000000000000000000000000f) * _e354));
                        }
                        local = (_e378 + 1u);
                        local_1 = (_e380 + _e85);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e644 = local;
                        phi_474_ = _e644;
                        let _e647 = local_1;
                        phi_477_ = _e647;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_half(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
