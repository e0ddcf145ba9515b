struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
}

struct type_6 {
    member: type_5,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: i32,
    member_5: u32,
}

struct type_13 {
    member: array<type_10>,
}

struct type_18 {
    member: array<u32>,
}

struct type_22 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_6;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_18;
@group(0) @binding(2) 
var<storage> global_5: type_22;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_22;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_22;

fn function_() {
    var phi_115_: bool;
    var phi_117_: bool;
    var phi_118_: bool;
    var phi_119_: bool;
    var phi_120_: bool;
    var phi_133_: vec3<f32>;
    var phi_136_: bool;
    var phi_138_: u32;
    var phi_134_: vec3<f32>;
    var phi_137_: bool;
    var phi_147_: u32;
    var phi_146_: bool;
    var phi_176_: vec3<f32>;
    var phi_177_: bool;
    var phi_183_: vec3<f32>;
    var local: vec3<f32>;
    var local_1: bool;
    var local_2: u32;
    var local_3: vec3<f32>;
    var local_4: bool;
    var local_5: u32;
    var local_6: vec3<f32>;
    var local_7: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e26 = global_1;
            let _e32 = ((_e26.x * 8u) + _e25.x);
            let _e34 = ((_e26.y * 8u) + _e25.y);
            let _e37 = global_2.member.member;
            if (_e32 < _e37) {
                if (_e34 < _e37) {
                    let _e43 = global_3.member[_e26.z];
                    let _e46 = global_2.member.member_1;
                    let _e49 = (_e43.member_3 + bitcast<i32>(_e32));
                    let _e52 = (_e43.member_4 + bitcast<i32>(_e34));
                    let _e54 = (_e46 == 0u);
                    if _e54 {
                        break;
                    }
                    if _e54 {
                        break;
                    }
                    if (_e49 >= 0i) {
                        if (_e52 >= 0i) {
                            let _e62 = (_e49 < bitcast<i32>((_e43.member_1 / _e46)));
                            if _e62 {
                                phi_115_ = (_e52 < bitcast<i32>((_e43.member_2 / _e46)));
                            } else {
                                phi_115_ = bool();
                            }
                            let _e65 = phi_115_;
                            phi_117_ = _e65;
                            phi_118_ = select(true, false, _e62);
                        } else {
                            phi_117_ = bool();
                            phi_118_ = true;
                        }
                        let _e68 = phi_117_;
                        let _e70 = phi_118_;
                        phi_119_ = _e68;
                        phi_120_ = _e70;
                    } else {
                        phi_119_ = bool();
                        phi_120_ = true;
                    }
                    let _e72 = phi_119_;
                    let _e74 = phi_120_;
                    let _e75 = select(_e72, false, _e74);
                    if _e75 {
                        phi_133_ = vec3<f32>(0f, 0f, 0f);
                        phi_136_ = _e75;
                        phi_138_ = 0u;
                        loop {
                            let _e84 = phi_133_;
                            let _e86 = phi_136_;
                            let _e88 = phi_138_;
                            local_6 = _e84;
                            local_7 = _e86;
                            if (_e88 < _e46) {
                                phi_134_ = _e84;
                                phi_137_ = _e86;
                                phi_147_ = 0u;
                                loop {
                                    let _e91 = phi_134_;
                                    let _e93 = phi_137_;
                                    let _e95 = phi_147_;
                                    local = _e91;
                                    local_1 = _e93;
                                    if (_e95 < _e46) {
                                        let _e102 = global_4.member[(((_e43.member + (((bitcast<u32>(_e52) * _e43.member_1) + bitcast<u32>(_e49)) * _e46)) + (_e88 * _e43.member_1)) + _e95)];
                                        let _e106 = global_5.member[(_e102 & 255u)];
                                        let _e112 = global_5.member[((_e102 >> bitcast<u32>(8i)) & 255u)];
                                        let _e118 = global_5.member[((_e102 >> bitcast<u32>(16i)) & 255u)];
                                        local_3 = vec3<f32>((_e91.x + _e106), (_e91.y + _e112), (_e91.z + _e118));
                                        if _e93 {
                                            phi_146_ = ((_e102 >> bitcast<u32>(24i)) != 0u);
                                        } else {
                                            phi_146_ = false;
                                        }
                                        let _e130 = phi_146_;
                                        local_4 = _e130;
                                        local_5 = (_e95 + 1u);
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e183 = local_3;
                                        phi_134_ = _e183;
                                        let _e186 = local_4;
                                        phi_137_ = _e186;
                                        let _e189 = local_5;
                                        phi_147_ = _e189;
                                    }
                                }
                                local_2 = (_e88 + 1u);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e174 = local;
                                phi_133_ = _e174;
                                let _e177 = local_1;
                                phi_136_ = _e177;
                                let _e180 = local_2;
                                phi_138_ = _e180;
                            }
                        }
                        let _e193 = local_6;
                        phi_176_ = _e193;
                        let _e196 = local_7;
                        phi_177_ = _e196;
                    } else {
                        phi_176_ = vec3<f32>(0f, 0f, 0f);
                        phi_177_ = _e75;
                    }
                    let _e134 = phi_176_;
                    let _e136 = phi_177_;
                    if _e136 {
                        let _e139 = global_2.member.member_2;
                        phi_183_ = (_e134 * _e139);
                    } else {
                        phi_183_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e142 = phi_183_;
                    let _e143 = (_e37 * _e37);
                    let _e145 = ((_e34 * _e37) + _e32);
                    let _e149 = (((_e43.member_5 * 3u) * _e143) + _e145);
                    global_6.member[_e149] = _e142.x;
                    global_6.member[(_e149 + _e143)] = _e142.y;
                    global_6.member[(_e149 + (2u * _e143))] = _e142.z;
                    global_7.member[((_e43.member_5 * _e143) + _e145)] = select(0f, 1f, _e136);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn target_tiles(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
