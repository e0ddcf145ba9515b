enable subgroups;

struct type_5 {
    member: u32,
    member_1: u32,
}

struct type_6 {
    member: type_5,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
var<private> global_3: u32;
@group(0) @binding(0) 
var<uniform> global_4: type_6;
var<workgroup> global_5: array<atomic<u32>, 2>;
@group(0) @binding(1) 
var<storage> global_6: type_15;
@group(0) @binding(2) 
var<storage, read_write> global_7: type_15;
var<workgroup> global_8: array<vec4<f32>, 24>;
@group(0) @binding(3) 
var<storage, read_write> global_9: type_15;

fn function_() {
    var phi_75_: u32;
    var phi_78_: f32;
    var phi_80_: f32;
    var phi_82_: f32;
    var phi_109_: bool;
    var phi_118_: bool;
    var phi_120_: f32;
    var phi_121_: f32;
    var phi_122_: f32;
    var phi_123_: f32;
    var phi_124_: f32;
    var phi_79_: f32;
    var phi_81_: f32;
    var phi_83_: f32;
    var phi_144_: u32;
    var phi_161_: u32;
    var phi_168_: u32;
    var phi_175_: u32;
    var phi_182_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_224_: u32;
    var phi_239_: vec4<f32>;
    var phi_242_: u32;
    var phi_262_: bool;
    var phi_273_: bool;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: u32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: u32;
    var local_11: vec4<f32>;
    var local_12: u32;

    let _e26 = global;
    let _e27 = global_1;
    let _e28 = global_2;
    let _e29 = global_3;
    let _e35 = (_e27.x + (_e27.y * _e28.x));
    let _e38 = global_4.member.member_1;
    let _e39 = (_e35 * _e38);
    if (_e26.x < 2u) {
        atomicStore((&global_5[_e26.x]), 0u);
    }
    workgroupBarrier();
    phi_75_ = 0u;
    phi_78_ = -(0x1.fffffep+127f);
    phi_80_ = 0x1.fffffep+127f;
    phi_82_ = 0f;
    loop {
        let _e44 = phi_75_;
        let _e46 = phi_78_;
        let _e48 = phi_80_;
        let _e50 = phi_82_;
        local = _e50;
        local_1 = _e48;
        local_2 = _e46;
        if (_e44 < _e38) {
            let _e54 = global_4.member.member;
            if (_e35 < _e54) {
                if ((_e44 + _e26.x) < _e38) {
                    let _e62 = global_6.member[((_e39 + _e44) + _e26.x)];
                    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                        phi_109_ = true;
                    } else {
                        phi_109_ = (_e62 <= _e48);
                    }
                    let _e69 = phi_109_;
                    if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
                        phi_118_ = true;
                    } else {
                        phi_118_ = (_e62 >= _e46);
                    }
                    let _e76 = phi_118_;
                    phi_120_ = _e62;
                    phi_121_ = select(_e46, _e62, _e76);
                    phi_122_ = select(_e48, _e62, _e69);
                    phi_123_ = (_e50 + _e62);
                } else {
                    phi_120_ = 0f;
                    phi_121_ = _e46;
                    phi_122_ = _e48;
                    phi_123_ = _e50;
                }
                let _e79 = phi_120_;
                let _e81 = phi_121_;
                let _e83 = phi_122_;
                let _e85 = phi_123_;
                phi_124_ = _e79;
                phi_79_ = _e81;
                phi_81_ = _e83;
                phi_83_ = _e85;
            } else {
                phi_124_ = 0f;
                phi_79_ = _e46;
                phi_81_ = _e48;
                phi_83_ = _e50;
            }
            let _e87 = phi_124_;
            let _e89 = phi_79_;
            let _e91 = phi_81_;
            let _e93 = phi_83_;
            let _e94 = (_e87 > 0f);
            let _e95 = subgroupBallot(_e94);
            local_7 = _e89;
            local_8 = _e91;
            local_9 = _e93;
            if (_e29 == 0u) {
                let _e109 = atomicAdd((&global_5[0u]), (((countOneBits(_e95.x) + countOneBits(_e95.y)) + countOneBits(_e95.z)) + countOneBits(_e95.w)));
                phi_144_ = _e109;
            } else {
                phi_144_ = 0u;
            }
            let _e111 = phi_144_;
            let _e112 = subgroupBroadcastFirst(_e111);
            if _e94 {
                let _e118 = ((1u << bitcast<u32>(((_e29 % 32u) & 31u))) - 1u);
                let _e119 = (_e29 / 32u);
                if (0u == _e119) {
                    phi_161_ = _e118;
                } else {
                    phi_161_ = select(0u, 4294967295u, (0u < _e119));
                }
                let _e124 = phi_161_;
                if (1u == _e119) {
                    phi_168_ = _e118;
                } else {
                    phi_168_ = select(0u, 4294967295u, (1u < _e119));
                }
                let _e129 = phi_168_;
                if (2u == _e119) {
                    phi_175_ = _e118;
                } else {
                    phi_175_ = select(0u, 4294967295u, (2u < _e119));
                }
                let _e134 = phi_175_;
                if (3u == _e119) {
                    phi_182_ = _e118;
                } else {
                    phi_182_ = select(0u, 4294967295u, (3u < _e119));
                }
                let _e139 = phi_182_;
                global_7.member[((_e39 + _e112) + (((countOneBits((_e95.x & _e124)) + countOneBits((_e95.y & _e129))) + countOneBits((_e95.z & _e134))) + countOneBits((_e95.w & _e139))))] = _e87;
            }
            local_6 = (_e44 + 96u);
            continue;
        } else {
            break;
        }
        continuing {
            let _e246 = local_6;
            phi_75_ = _e246;
            let _e249 = local_7;
            phi_78_ = _e249;
            let _e252 = local_8;
            phi_80_ = _e252;
            let _e255 = local_9;
            phi_82_ = _e255;
        }
    }
    let _e160 = local;
    let _e161 = subgroupAdd(_e160);
    let _e163 = local_1;
    let _e164 = subgroupMin(_e163);
    let _e166 = local_2;
    let _e167 = subgroupMax(_e166);
    if (_e29 == 0u) {
        let _e170 = atomicAdd((&global_5[1u]), 1u);
        global_8[_e170] = vec4<f32>(_e161, _e164, _e167, 0f);
    }
    workgroupBarrier();
    let _e175 = global_4.member.member;
    if (_e35 < _e175) {
        let _e178 = atomicLoad((&global_5[0u]));
        phi_224_ = (_e178 + _e26.x);
        loop {
            let _e181 = phi_224_;
            if (_e181 < _e38) {
                global_7.member[(_e39 + _e181)] = 0f;
                local_10 = (_e181 + 96u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e276 = local_10;
                phi_224_ = _e276;
            }
        }
        if (_e26.x == 0u) {
            let _e189 = global_8[0u];
            phi_239_ = _e189;
            phi_242_ = 1u;
            loop {
                let _e191 = phi_239_;
                let _e193 = phi_242_;
                let _e195 = atomicLoad((&global_5[1u]));
                local_3 = _e191;
                local_4 = _e191;
                local_5 = _e191;
                if (_e193 < _e195) {
                    let _e198 = global_8[_e193];
                    if ((bitcast<u32>(_e191.y) & 2147483647u) > 2139095040u) {
                        phi_262_ = true;
                    } else {
                        phi_262_ = (_e198.y <= _e191.y);
                    }
                    let _e209 = phi_262_;
                    if ((bitcast<u32>(_e191.z) & 2147483647u) > 2139095040u) {
                        phi_273_ = true;
                    } else {
                        phi_273_ = (_e198.z >= _e191.z);
                    }
                    let _e218 = phi_273_;
                    local_11 = vec4<f32>((_e191.x + _e198.x), select(_e191.y, _e198.y, _e209), select(_e191.z, _e198.z, _e218), 0f);
                    local_12 = (_e193 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e279 = local_11;
                    phi_239_ = _e279;
                    let _e282 = local_12;
                    phi_242_ = _e282;
                }
            }
            let _e222 = (4u * _e35);
            global_9.member[_e222] = f32(_e178);
            let _e228 = local_3;
            global_9.member[(_e222 + 1u)] = _e228.x;
            let _e234 = local_4;
            global_9.member[(_e222 + 2u)] = _e234.y;
            let _e240 = local_5;
            global_9.member[(_e222 + 3u)] = _e240.z;
        }
    }
    return;
}

@compute @workgroup_size(96, 1, 1) 
fn keep_positive(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>, @builtin(subgroup_invocation_id) param_3: u32) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    global_3 = param_3;
    function_();
}
