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
    var phi_73_: u32;
    var phi_76_: f32;
    var phi_78_: f32;
    var phi_80_: f32;
    var phi_105_: bool;
    var phi_112_: bool;
    var phi_114_: f32;
    var phi_115_: f32;
    var phi_116_: f32;
    var phi_117_: f32;
    var phi_118_: f32;
    var phi_77_: f32;
    var phi_79_: f32;
    var phi_81_: f32;
    var phi_138_: u32;
    var phi_155_: u32;
    var phi_162_: u32;
    var phi_169_: u32;
    var phi_176_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_218_: u32;
    var phi_233_: vec4<f32>;
    var phi_236_: u32;
    var phi_254_: bool;
    var phi_263_: bool;
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

    let _e25 = global;
    let _e26 = global_1;
    let _e27 = global_2;
    let _e28 = global_3;
    let _e34 = (_e26.x + (_e26.y * _e27.x));
    let _e37 = global_4.member.member_1;
    let _e38 = (_e34 * _e37);
    if (_e25.x < 2u) {
        atomicStore((&global_5[_e25.x]), 0u);
    }
    workgroupBarrier();
    phi_73_ = 0u;
    phi_76_ = -0x1.fffffep+127f;
    phi_78_ = 0x1.fffffep+127f;
    phi_80_ = 0f;
    loop {
        let _e42 = phi_73_;
        let _e44 = phi_76_;
        let _e46 = phi_78_;
        let _e48 = phi_80_;
        local = _e48;
        local_1 = _e46;
        local_2 = _e44;
        if (_e42 < _e37) {
            let _e52 = global_4.member.member;
            if (_e34 < _e52) {
                if ((_e42 + _e25.x) < _e37) {
                    let _e60 = global_6.member[((_e38 + _e42) + _e25.x)];
                    if (_e46 != _e46) {
                        phi_105_ = true;
                    } else {
                        phi_105_ = (_e60 <= _e46);
                    }
                    let _e65 = phi_105_;
                    if (_e44 != _e44) {
                        phi_112_ = true;
                    } else {
                        phi_112_ = (_e60 >= _e44);
                    }
                    let _e70 = phi_112_;
                    phi_114_ = _e60;
                    phi_115_ = select(_e44, _e60, _e70);
                    phi_116_ = select(_e46, _e60, _e65);
                    phi_117_ = (_e48 + _e60);
                } else {
                    phi_114_ = 0f;
                    phi_115_ = _e44;
                    phi_116_ = _e46;
                    phi_117_ = _e48;
                }
                let _e73 = phi_114_;
                let _e75 = phi_115_;
                let _e77 = phi_116_;
                let _e79 = phi_117_;
                phi_118_ = _e73;
                phi_77_ = _e75;
                phi_79_ = _e77;
                phi_81_ = _e79;
            } else {
                phi_118_ = 0f;
                phi_77_ = _e44;
                phi_79_ = _e46;
                phi_81_ = _e48;
            }
            let _e81 = phi_118_;
            let _e83 = phi_77_;
            let _e85 = phi_79_;
            let _e87 = phi_81_;
            let _e88 = (_e81 > 0f);
            let _e89 = subgroupBallot(_e88);
            local_7 = _e83;
            local_8 = _e85;
            local_9 = _e87;
            if (_e28 == 0u) {
                let _e103 = atomicAdd((&global_5[0u]), (((countOneBits(_e89.x) + countOneBits(_e89.y)) + countOneBits(_e89.z)) + countOneBits(_e89.w)));
                phi_138_ = _e103;
            } else {
                phi_138_ = 0u;
            }
            let _e105 = phi_138_;
            let _e106 = subgroupBroadcastFirst(_e105);
            if _e88 {
                let _e112 = ((1u << bitcast<u32>(((_e28 % 32u) & 31u))) - 1u);
                let _e113 = (_e28 / 32u);
                if (0u == _e113) {
                    phi_155_ = _e112;
                } else {
                    phi_155_ = select(0u, 4294967295u, (0u < _e113));
                }
                let _e118 = phi_155_;
                if (1u == _e113) {
                    phi_162_ = _e112;
                } else {
                    phi_162_ = select(0u, 4294967295u, (1u < _e113));
                }
                let _e123 = phi_162_;
                if (2u == _e113) {
                    phi_169_ = _e112;
                } else {
                    phi_169_ = select(0u, 4294967295u, (2u < _e113));
                }
                let _e128 = phi_169_;
                if (3u == _e113) {
                    phi_176_ = _e112;
                } else {
                    phi_176_ = select(0u, 4294967295u, (3u < _e113));
                }
                let _e133 = phi_176_;
                global_7.member[((_e38 + _e106) + (((countOneBits((_e89.x & _e118)) + countOneBits((_e89.y & _e123))) + countOneBits((_e89.z & _e128))) + countOneBits((_e89.w & _e133))))] = _e81;
            }
            local_6 = (_e42 + 96u);
            continue;
        } else {
            break;
        }
        continuing {
            let _e236 = local_6;
            phi_73_ = _e236;
            let _e239 = local_7;
            phi_76_ = _e239;
            let _e242 = local_8;
            phi_78_ = _e242;
            let _e245 = local_9;
            phi_80_ = _e245;
        }
    }
    let _e154 = local;
    let _e155 = subgroupAdd(_e154);
    let _e157 = local_1;
    let _e158 = subgroupMin(_e157);
    let _e160 = local_2;
    let _e161 = subgroupMax(_e160);
    if (_e28 == 0u) {
        let _e164 = atomicAdd((&global_5[1u]), 1u);
        global_8[_e164] = vec4<f32>(_e155, _e158, _e161, 0f);
    }
    workgroupBarrier();
    let _e169 = global_4.member.member;
    if (_e34 < _e169) {
        let _e172 = atomicLoad((&global_5[0u]));
        phi_218_ = (_e172 + _e25.x);
        loop {
            let _e175 = phi_218_;
            if (_e175 < _e37) {
                global_7.member[(_e38 + _e175)] = 0f;
                local_10 = (_e175 + 96u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e266 = local_10;
                phi_218_ = _e266;
            }
        }
        if (_e25.x == 0u) {
            let _e183 = global_8[0u];
            phi_233_ = _e183;
            phi_236_ = 1u;
            loop {
                let _e185 = phi_233_;
                let _e187 = phi_236_;
                let _e189 = atomicLoad((&global_5[1u]));
                local_3 = _e185;
                local_4 = _e185;
                local_5 = _e185;
                if (_e187 < _e189) {
                    let _e192 = global_8[_e187];
                    if (_e185.y != _e185.y) {
                        phi_254_ = true;
                    } else {
                        phi_254_ = (_e192.y <= _e185.y);
                    }
                    let _e201 = phi_254_;
                    if (_e185.z != _e185.z) {
                        phi_263_ = true;
                    } else {
                        phi_263_ = (_e192.z >= _e185.z);
                    }
                    let _e208 = phi_263_;
                    local_11 = vec4<f32>((_e185.x + _e192.x), select(_e185.y, _e192.y, _e201), select(_e185.z, _e192.z, _e208), 0f);
                    local_12 = (_e187 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e269 = local_11;
                    phi_233_ = _e269;
                    let _e272 = local_12;
                    phi_236_ = _e272;
                }
            }
            let _e212 = (4u * _e34);
            global_9.member[_e212] = f32(_e172);
            let _e218 = local_3;
            global_9.member[(_e212 + 1u)] = _e218.x;
            let _e224 = local_4;
            global_9.member[(_e212 + 2u)] = _e224.y;
            let _e230 = local_5;
            global_9.member[(_e212 + 3u)] = _e230.z;
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
