struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

struct type_21 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_15;
@group(0) @binding(3) 
var<storage> global_7: type_15;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_21;

fn function_() {
    var phi_92_: u32;
    var phi_95_: f32;
    var phi_96_: f32;
    var local: f32;
    var phi_138_: u32;
    var phi_140_: array<u32, 2>;
    var phi_146_: array<u32, 2>;
    var local_1: f32;
    var phi_199_: u32;
    var phi_201_: array<u32, 2>;
    var phi_207_: array<u32, 2>;
    var local_2: u32;
    var local_3: f32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e26 = global_1;
            let _e27 = global_2;
            let _e35 = (((_e26.x + (_e26.y * _e27.x)) * 64u) + _e25.x);
            let _e38 = global_3.member.member;
            if (_e35 < _e38) {
                let _e42 = global_3.member.member_1;
                if (_e42 == 0u) {
                    break;
                }
                let _e44 = (_e35 / _e42);
                let _e48 = global_4.member[(_e44 / 3u)];
                let _e52 = ((_e48 * 64u) + ((_e44 % 3u) * 2u));
                let _e55 = global_5.member[_e52];
                let _e56 = exp(_e55);
                let _e57 = (_e35 * _e42);
                phi_92_ = _e57;
                phi_95_ = 0f;
                phi_96_ = 0f;
                loop {
                    let _e60 = phi_92_;
                    let _e62 = phi_95_;
                    let _e64 = phi_96_;
                    local = _e64;
                    local_1 = _e62;
                    if (_e60 < (_e57 + _e42)) {
                        let _e68 = global_6.member[_e60];
                        let _e71 = global_7.member[_e60];
                        global_6.member[_e60] = (_e68 * _e56);
                        local_2 = (_e60 + 1u);
                        local_3 = (_e62 + _e68);
                        local_4 = (_e64 + (_e68 * _e71));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e196 = local_2;
                        phi_92_ = _e196;
                        let _e199 = local_3;
                        phi_95_ = _e199;
                        let _e202 = local_4;
                        phi_96_ = _e202;
                    }
                }
                let _e79 = global_3.member.member_2;
                let _e81 = local;
                let _e83 = bitcast<u32>((_e81 * _e56));
                let _e86 = ((_e83 >> bitcast<u32>(23i)) & 255u);
                if (_e86 == 0u) {
                } else {
                    let _e89 = (_e86 % 16u);
                    let _e91 = ((_e83 & 8388607u) | 8388608u);
                    let _e94 = (_e91 << bitcast<u32>((_e89 & 31u)));
                    let _e100 = ((_e91 >> bitcast<u32>(((31u - _e89) & 31u))) >> bitcast<u32>(1i));
                    if ((_e83 >> bitcast<u32>(31i)) == 0u) {
                        phi_140_ = array<u32, 2>(_e94, _e100);
                    } else {
                        let _e106 = (~(_e94) + 1u);
                        if (_e106 == 0u) {
                            phi_138_ = (~(_e100) + 1u);
                        } else {
                            phi_138_ = ~(_e100);
                        }
                        let _e112 = phi_138_;
                        phi_140_ = array<u32, 2>(_e106, _e112);
                    }
                    let _e115 = phi_140_;
                    let _e116 = (_e86 < 255u);
                    if _e116 {
                        phi_146_ = _e115;
                    } else {
                        phi_146_ = array<u32, 2>(1u, 0u);
                    }
                    let _e119 = phi_146_;
                    let _e124 = (2u * ((select(16u, (_e86 / 16u), _e116) * _e79) + _e52));
                    let _e127 = atomicAdd((&global_8.member[_e124]), _e119[0]);
                    let _e131 = (_e119[1] + select(0u, 1u, ((_e127 + _e119[0]) < _e119[0])));
                    if (_e131 == 0u) {
                    } else {
                        let _e136 = atomicAdd((&global_8.member[(_e124 + 1u)]), _e131);
                    }
                }
                let _e139 = local_1;
                let _e140 = bitcast<u32>(_e139);
                let _e143 = ((_e140 >> bitcast<u32>(23i)) & 255u);
                if (_e143 == 0u) {
                } else {
                    let _e146 = (_e143 % 16u);
                    let _e148 = ((_e140 & 8388607u) | 8388608u);
                    let _e151 = (_e148 << bitcast<u32>((_e146 & 31u)));
                    let _e157 = ((_e148 >> bitcast<u32>(((31u - _e146) & 31u))) >> bitcast<u32>(1i));
                    if ((_e140 >> bitcast<u32>(31i)) == 0u) {
                        phi_201_ = array<u32, 2>(_e151, _e157);
                    } else {
                        let _e163 = (~(_e151) + 1u);
                        if (_e163 == 0u) {
                            phi_199_ = (~(_e157) + 1u);
                        } else {
                            phi_199_ = ~(_e157);
                        }
                        let _e169 = phi_199_;
                        phi_201_ = array<u32, 2>(_e163, _e169);
                    }
                    let _e172 = phi_201_;
                    let _e173 = (_e143 < 255u);
                    if _e173 {
                        phi_207_ = _e172;
                    } else {
                        phi_207_ = array<u32, 2>(1u, 0u);
                    }
                    let _e176 = phi_207_;
                    let _e181 = (2u * ((select(16u, (_e143 / 16u), _e173) * _e79) + (_e52 + 1u)));
                    let _e184 = atomicAdd((&global_8.member[_e181]), _e176[0]);
                    let _e188 = (_e176[1] + select(0u, 1u, ((_e184 + _e176[0]) < _e176[0])));
                    if (_e188 == 0u) {
                    } else {
                        let _e193 = atomicAdd((&global_8.member[(_e181 + 1u)]), _e188);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expose_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
