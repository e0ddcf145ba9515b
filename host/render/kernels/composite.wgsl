struct type_5 {
    member: array<u32>,
}

struct type_11 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: type_14,
}

struct type_21 {
    member: array<i32>,
}

struct type_26 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_2: type_5;
@group(0) @binding(4) 
var<storage> global_3: type_5;
@group(0) @binding(5) 
var<storage> global_4: type_11;
@group(0) @binding(0) 
var<uniform> global_5: type_15;
@group(0) @binding(1) 
var<storage> global_6: type_21;
@group(0) @binding(2) 
var<storage> global_7: type_5;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_26;

fn function_() {
    var phi_107_: bool;
    var phi_159_: f32;
    var phi_160_: f32;
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_170_: u32;
    var phi_179_: u32;
    var phi_193_: f32;
    var phi_196_: f32;
    var phi_198_: f32;
    var phi_200_: f32;
    var phi_202_: u32;
    var phi_208_: u32;
    var phi_194_: f32;
    var phi_197_: f32;
    var phi_199_: f32;
    var phi_201_: f32;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: u32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e27 = global;
            let _e28 = global_1;
            let _e37 = ((_e28.x * 16u) + _e27.x);
            let _e39 = ((_e28.y * 4u) + _e27.y);
            let _e42 = global_5.member.member;
            if (_e37 < _e42) {
                phi_107_ = (_e39 < _e42);
            } else {
                phi_107_ = false;
            }
            let _e46 = phi_107_;
            if _e46 {
                let _e47 = select(0u, _e39, _e46);
                let _e48 = select(0u, _e37, _e46);
                let _e50 = (_e28.z * 4u);
                let _e54 = global_6.member[(_e50 + 1u)];
                let _e58 = global_6.member[(_e50 + 2u)];
                let _e62 = (f32((_e54 + bitcast<i32>(_e48))) + 0.5f);
                let _e66 = (f32((_e58 + bitcast<i32>(_e47))) + 0.5f);
                let _e69 = global_7.member[_e28.z];
                let _e72 = global_5.member.member_1;
                let _e73 = (_e69 + _e72);
                let _e77 = global_7.member[(_e28.z + 1u)];
                let _e78 = (_e73 + 16384u);
                let _e80 = select(_e78, _e77, (_e77 < _e78));
                let _e81 = (_e42 * _e42);
                let _e85 = (((_e50 * _e81) + (_e47 * _e42)) + _e48);
                if _e46 {
                    let _e88 = global_8.member[_e85];
                    let _e92 = global_8.member[(_e85 + _e81)];
                    let _e97 = global_8.member[(_e85 + (2u * _e81))];
                    let _e102 = global_8.member[(_e85 + (3u * _e81))];
                    phi_159_ = _e102;
                    phi_160_ = _e97;
                    phi_161_ = _e92;
                    phi_162_ = _e88;
                } else {
                    phi_159_ = 0f;
                    phi_160_ = 0f;
                    phi_161_ = 0f;
                    phi_162_ = 0f;
                }
                let _e104 = phi_159_;
                let _e106 = phi_160_;
                let _e108 = phi_161_;
                let _e110 = phi_162_;
                let _e111 = (_e42 / 64u);
                if ((_e42 % 64u) > 0u) {
                    phi_170_ = (_e111 + 1u);
                } else {
                    phi_170_ = _e111;
                }
                let _e116 = phi_170_;
                let _e117 = (_e116 * 16u);
                let _e118 = (_e42 / 8u);
                if ((_e42 % 8u) > 0u) {
                    phi_179_ = (_e118 + 1u);
                } else {
                    phi_179_ = _e118;
                }
                let _e123 = phi_179_;
                if (_e123 == 0u) {
                    break;
                }
                if (_e117 == 0u) {
                    break;
                }
                phi_193_ = _e104;
                phi_196_ = _e106;
                phi_198_ = _e108;
                phi_200_ = _e110;
                phi_202_ = _e73;
                loop {
                    let _e134 = phi_193_;
                    let _e136 = phi_196_;
                    let _e138 = phi_198_;
                    let _e140 = phi_200_;
                    let _e142 = phi_202_;
                    local = _e140;
                    local_1 = _e138;
                    local_2 = _e136;
                    local_3 = _e134;
                    if (_e142 < _e80) {
                        phi_208_ = 0u;
                        phi_194_ = _e134;
                        phi_197_ = _e136;
                        phi_199_ = _e138;
                        phi_201_ = _e140;
                        loop {
                            let _e146 = phi_208_;
                            let _e148 = phi_194_;
                            let _e150 = phi_197_;
                            let _e152 = phi_199_;
                            let _e154 = phi_201_;
                            local_4 = _e148;
                            local_5 = _e150;
                            local_6 = _e152;
                            local_7 = _e154;
                            if (_e146 < (_e80 - _e142)) {
                                let _e156 = (_e142 + _e146);
                                let _e158 = global_3.member[_e156];
                                if ((_e158 & (1u << bitcast<u32>(((((_e47 / _e123) * 4u) + (_e48 / _e117)) & 31u)))) == 0u) {
                                    phi_211_ = _e148;
                                    phi_212_ = _e150;
                                    phi_213_ = _e152;
                                    phi_214_ = _e154;
                                } else {
                                    let _e162 = global_2.member[_e156];
                                    let _e163 = (_e162 * 3u);
                                    let _e165 = global_4.member[_e163];
                                    let _e168 = global_4.member[(_e163 + 1u)];
                                    let _e170 = (_e62 - _e165.x);
                                    if (_e170 > _e165.w) {
                                        phi_249_ = bool();
                                        phi_250_ = true;
                                    } else {
                                        let _e174 = ((_e165.x - _e62) > _e165.w);
                                        if _e174 {
                                            phi_248_ = bool();
                                        } else {
                                            phi_248_ = (abs((_e66 - _e165.y)) > _e168.w);
                                        }
                                        let _e181 = phi_248_;
                                        phi_249_ = _e181;
                                        phi_250_ = _e174;
                                    }
                                    let _e183 = phi_249_;
                                    let _e185 = phi_250_;
                                    if !(select(_e183, true, _e185)) {
                                        let _e189 = (_e66 - _e165.y);
                                        let _e194 = ((_e168.y * _e170) * _e189);
                                        let _e201 = ((((_e168.x * _e170) * _e170) + (_e194 + _e194)) + ((_e168.z * _e189) * _e189));
                                        let _e207 = (_e201 <= 11.082527f);
                                        let _e209 = (_e165.z * select(0f, exp((-0.5f * select(0f, _e201, (_e201 > 0f)))), _e207));
                                        let _e212 = global_4.member[(_e163 + 2u)];
                                        phi_276_ = (_e148 + select(0f, _e209, _e207));
                                        phi_277_ = (_e150 + select(0f, (_e209 * _e212.z), _e207));
                                        phi_278_ = (_e152 + select(0f, (_e209 * _e212.y), _e207));
                                        phi_279_ = (_e154 + select(0f, (_e209 * _e212.x), _e207));
                                    } else {
                                        phi_276_ = _e148;
                                        phi_277_ = _e150;
                                        phi_278_ = _e152;
                                        phi_279_ = _e154;
                                    }
                                    let _e228 = phi_276_;
                                    let _e230 = phi_277_;
                                    let _e232 = phi_278_;
                                    let _e234 = phi_279_;
                                    phi_211_ = _e228;
                                    phi_212_ = _e230;
                                    phi_213_ = _e232;
                                    phi_214_ = _e234;
                                }
                                let _e236 = phi_211_;
                                let _e238 = phi_212_;
                                let _e240 = phi_213_;
                                let _e242 = phi_214_;
                                local_8 = (_e146 + 1u);
                                local_9 = _e236;
                                local_10 = _e238;
                                local_11 = _e240;
                                local_12 = _e242;
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e287 = local_8;
                                phi_208_ = _e287;
                                let _e290 = local_9;
                                phi_194_ = _e290;
                                let _e293 = local_10;
                                phi_197_ = _e293;
                                let _e296 = local_11;
                                phi_199_ = _e296;
                                let _e299 = local_12;
                                phi_201_ = _e299;
                            }
                        }
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e274 = local_4;
                        phi_193_ = _e274;
                        let _e277 = local_5;
                        phi_196_ = _e277;
                        let _e280 = local_6;
                        phi_198_ = _e280;
                        let _e283 = local_7;
                        phi_200_ = _e283;
                        phi_202_ = _e80;
                    }
                }
                if _e46 {
                    let _e247 = local;
                    global_8.member[_e85] = _e247;
                    let _e252 = local_1;
                    global_8.member[(_e85 + _e81)] = _e252;
                    let _e258 = local_2;
                    global_8.member[(_e85 + (2u * _e81))] = _e258;
                    let _e264 = local_3;
                    global_8.member[(_e85 + (3u * _e81))] = _e264;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(16, 4, 1) 
fn composite(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
