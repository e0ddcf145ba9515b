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
    member: array<i32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_10;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_10;

fn function_() {
    var phi_79_: u32;
    var phi_82_: u32;
    var local: u32;
    var phi_117_: u32;
    var phi_126_: u32;
    var phi_128_: u32;
    var phi_131_: u32;
    var phi_163_: f32;
    var phi_178_: f32;
    var phi_181_: bool;
    var phi_182_: bool;
    var phi_183_: bool;
    var phi_132_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    let _e23 = global;
    let _e24 = global_1;
    let _e25 = global_2;
    let _e33 = (((_e24.x + (_e24.y * _e25.x)) * 64u) + _e23.x);
    let _e36 = global_3.member.member;
    if (_e33 < _e36) {
        let _e40 = global_3.member.member_1;
        phi_79_ = _e40;
        phi_82_ = 0u;
        loop {
            let _e42 = phi_79_;
            let _e44 = phi_82_;
            local = _e44;
            if ((_e44 + 1u) < _e42) {
                let _e48 = ((_e44 + _e42) / 2u);
                let _e51 = global_4.member[_e48];
                let _e52 = (_e51 <= _e33);
                local_2 = select(_e48, _e42, _e52);
                local_3 = select(_e44, _e48, _e52);
                continue;
            } else {
                break;
            }
            continuing {
                let _e162 = local_2;
                phi_79_ = _e162;
                let _e165 = local_3;
                phi_82_ = _e165;
            }
        }
        let _e56 = local;
        let _e57 = (_e56 * 4u);
        let _e61 = global_5.member[(_e57 + 1u)];
        let _e65 = global_5.member[(_e57 + 2u)];
        let _e68 = global_6.member[_e33];
        let _e69 = (_e68 * 3u);
        let _e72 = global_7.member[_e69];
        let _e76 = global_7.member[(_e69 + 1u)];
        let _e79 = global_3.member.member_2;
        let _e80 = (_e79 / 64u);
        if ((_e79 % 64u) > 0u) {
            phi_117_ = (_e80 + 1u);
        } else {
            phi_117_ = _e80;
        }
        let _e85 = phi_117_;
        let _e86 = (_e85 * 16u);
        let _e87 = (_e79 / 8u);
        if ((_e79 % 8u) > 0u) {
            phi_126_ = (_e87 + 1u);
        } else {
            phi_126_ = _e87;
        }
        let _e92 = phi_126_;
        phi_128_ = 0u;
        phi_131_ = 0u;
        loop {
            let _e94 = phi_128_;
            let _e96 = phi_131_;
            local_1 = _e96;
            if (_e94 < 32u) {
                let _e99 = ((_e94 % 4u) * _e86);
                let _e101 = ((_e94 / 4u) * _e92);
                let _e109 = (f32((_e65 + bitcast<i32>(_e101))) + 0.5f);
                let _e121 = (f32((_e65 + bitcast<i32>(((_e101 + _e92) - 1u)))) + 0.5f);
                if (_e72.y < _e109) {
                    phi_163_ = _e109;
                } else {
                    phi_163_ = select(_e72.y, _e121, (_e72.y > _e121));
                }
                let _e127 = phi_163_;
                if (((f32((_e61 + bitcast<i32>(_e99))) + 0.5f) - _e72.x) > _e72.w) {
                    phi_182_ = bool();
                    phi_183_ = true;
                } else {
                    let _e133 = ((_e72.x - (f32((_e61 + bitcast<i32>(((_e99 + _e86) - 1u)))) + 0.5f)) > _e72.w);
                    if _e133 {
                        phi_181_ = bool();
                    } else {
                        let _e134 = (_e127 - _e72.y);
                        if (_e134 < 0f) {
                            phi_178_ = -(_e134);
                        } else {
                            phi_178_ = _e134;
                        }
                        let _e138 = phi_178_;
                        phi_181_ = (_e138 > _e76.w);
                    }
                    let _e142 = phi_181_;
                    phi_182_ = _e142;
                    phi_183_ = _e133;
                }
                let _e144 = phi_182_;
                let _e146 = phi_183_;
                if !(select(_e144, true, _e146)) {
                    phi_132_ = (_e96 | (1u << bitcast<u32>((_e94 & 31u))));
                } else {
                    phi_132_ = _e96;
                }
                let _e154 = phi_132_;
                local_4 = (_e94 + 1u);
                local_5 = _e154;
                continue;
            } else {
                break;
            }
            continuing {
                let _e171 = local_4;
                phi_128_ = _e171;
                let _e174 = local_5;
                phi_131_ = _e174;
            }
        }
        let _e159 = local_1;
        global_8.member[_e33] = _e159;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_cells(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
