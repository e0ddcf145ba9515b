struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_68_: u32;
    var phi_110_: vec4<f32>;
    var phi_118_: vec4<f32>;
    var phi_126_: vec4<f32>;
    var phi_128_: u32;
    var phi_131_: vec4<f32>;
    var phi_133_: u32;
    var phi_170_: vec4<f32>;
    var phi_179_: vec4<f32>;
    var phi_188_: vec4<f32>;
    var phi_132_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: u32;
    var local_5: vec4<f32>;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global;
            let _e21 = global_1;
            let _e22 = global_2;
            let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
            let _e33 = global_3.member.member_4;
            let _e34 = (_e33 / 4u);
            if ((_e33 % 4u) > 0u) {
                phi_68_ = (_e34 + 1u);
            } else {
                phi_68_ = _e34;
            }
            let _e39 = phi_68_;
            let _e42 = global_3.member.member_3;
            if (_e30 < (_e42 * _e39)) {
                let _e45 = (_e39 == 0u);
                if _e45 {
                    break;
                }
                let _e46 = (_e30 / _e39);
                if _e45 {
                    break;
                }
                let _e48 = ((_e30 % _e39) * 4u);
                let _e50 = ((_e48 + 1u) < _e33);
                let _e52 = ((_e48 + 2u) < _e33);
                let _e54 = ((_e48 + 3u) < _e33);
                let _e58 = global_3.member.member_1;
                let _e61 = global_3.member.member;
                let _e66 = ((_e46 * _e33) + _e48);
                let _e69 = global_7.member[_e66];
                if _e50 {
                    let _e74 = global_7.member[(_e66 + 1u)];
                    phi_110_ = vec4<f32>(_e69, _e74, 0f, 0f);
                } else {
                    phi_110_ = vec4<f32>(_e69, 0f, 0f, 0f);
                }
                let _e77 = phi_110_;
                if _e52 {
                    let _e81 = global_7.member[(_e66 + 2u)];
                    phi_118_ = vec4<f32>(_e77.x, _e77.y, _e81, _e77.w);
                } else {
                    phi_118_ = _e77;
                }
                let _e88 = phi_118_;
                if _e54 {
                    let _e92 = global_7.member[(_e66 + 3u)];
                    phi_126_ = vec4<f32>(_e88.x, _e88.y, _e88.z, _e92);
                } else {
                    phi_126_ = _e88;
                }
                let _e99 = phi_126_;
                phi_128_ = 0u;
                phi_131_ = _e99;
                phi_133_ = ((_e58 * _e61) + (_e46 / 32u));
                loop {
                    let _e101 = phi_128_;
                    let _e103 = phi_131_;
                    let _e105 = phi_133_;
                    let _e108 = global_3.member.member_2;
                    local = _e103;
                    local_1 = _e103;
                    local_2 = _e103;
                    local_3 = _e103;
                    if (_e101 < _e108) {
                        let _e112 = global_4.member[_e105];
                        let _e113 = ((_e46 % 32u) & 31u);
                        if (((_e112 >> bitcast<u32>(_e113)) & 1u) == 0u) {
                            phi_132_ = _e103;
                        } else {
                            let _e120 = global_5.member[_e105];
                            let _e128 = (((_e120 + countOneBits((_e112 & ((1u << bitcast<u32>(_e113)) - 1u)))) * _e33) + _e48);
                            let _e131 = global_6.member[_e128];
                            let _e138 = vec4<f32>((_e103.x + _e131), _e103.y, _e103.z, _e103.w);
                            if _e50 {
                                let _e142 = global_6.member[(_e128 + 1u)];
                                phi_170_ = vec4<f32>(_e138.x, (_e103.y + _e142), _e138.z, _e138.w);
                            } else {
                                phi_170_ = _e138;
                            }
                            let _e151 = phi_170_;
                            if _e52 {
                                let _e155 = global_6.member[(_e128 + 2u)];
                                phi_179_ = vec4<f32>(_e151.x, _e151.y, (_e151.z + _e155), _e151.w);
                            } else {
                                phi_179_ = _e151;
                            }
                            let _e164 = phi_179_;
                            if _e54 {
                                let _e168 = global_6.member[(_e128 + 3u)];
                                phi_188_ = vec4<f32>(_e164.x, _e164.y, _e164.z, (_e164.w + _e168));
                            } else {
                                phi_188_ = _e164;
                            }
                            let _e177 = phi_188_;
                            phi_132_ = _e177;
                        }
                        let _e179 = phi_132_;
                        local_4 = (_e101 + 1u);
                        local_5 = _e179;
                        local_6 = (_e105 + _e61);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e209 = local_4;
                        phi_128_ = _e209;
                        let _e212 = local_5;
                        phi_131_ = _e212;
                        let _e215 = local_6;
                        phi_133_ = _e215;
                    }
                }
                let _e183 = local;
                global_7.member[_e66] = _e183.x;
                if _e50 {
                    let _e187 = local_1;
                    global_7.member[(_e66 + 1u)] = _e187.y;
                }
                if _e52 {
                    let _e193 = local_2;
                    global_7.member[(_e66 + 2u)] = _e193.z;
                }
                if _e54 {
                    let _e199 = local_3;
                    global_7.member[(_e66 + 3u)] = _e199.w;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
