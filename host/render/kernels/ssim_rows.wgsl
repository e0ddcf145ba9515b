struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<f32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_5;
@group(0) @binding(1) 
var<storage> global_3: type_12;
@group(0) @binding(2) 
var<storage> global_4: type_16;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_16;

fn function_() {
    var phi_104_: vec4<f32>;
    var phi_107_: vec4<f32>;
    var phi_109_: vec4<f32>;
    var phi_111_: vec4<f32>;
    var phi_113_: u32;
    var phi_115_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: u32;
    var local_9: u32;

    let _e17 = global;
    let _e18 = global_1;
    let _e24 = ((_e18.x * 8u) + _e17.x);
    let _e26 = ((_e18.y * 8u) + _e17.y);
    let _e29 = global_2.member.member;
    if (_e24 < _e29) {
        if (_e26 < _e29) {
            let _e35 = (((_e18.z * _e29) + _e26) * _e29);
            let _e37 = select(5u, _e24, (_e24 > 5u));
            let _e39 = (_e24 + 6u);
            phi_104_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_107_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_109_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_111_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_113_ = (_e37 - 5u);
            phi_115_ = (_e37 - _e24);
            loop {
                let _e44 = phi_104_;
                let _e46 = phi_107_;
                let _e48 = phi_109_;
                let _e50 = phi_111_;
                let _e52 = phi_113_;
                let _e54 = phi_115_;
                local = _e50;
                local_1 = _e48;
                local_2 = _e46;
                local_3 = _e44;
                if (_e52 < select(_e39, _e29, (_e29 < _e39))) {
                    let _e58 = global_3.member[_e54];
                    let _e59 = (_e35 + _e52);
                    let _e62 = global_4.member[_e59];
                    let _e65 = global_5.member[_e59];
                    let _e67 = (_e62.x * _e58);
                    let _e69 = (_e62.y * _e58);
                    let _e71 = (_e62.z * _e58);
                    let _e73 = (_e62.w * _e58);
                    let _e75 = (_e65.x * _e58);
                    let _e77 = (_e65.y * _e58);
                    let _e79 = (_e65.z * _e58);
                    let _e81 = (_e65.w * _e58);
                    local_4 = vec4<f32>((_e44.x + (_e75 * _e65.x)), (_e44.y + (_e77 * _e65.y)), (_e44.z + (_e79 * _e65.z)), (_e44.w + (_e81 * _e65.w)));
                    local_5 = vec4<f32>((_e46.x + (_e67 * _e62.x)), (_e46.y + (_e69 * _e62.y)), (_e46.z + (_e71 * _e62.z)), (_e46.w + (_e73 * _e62.w)));
                    local_6 = vec4<f32>((_e48.x + _e75), (_e48.y + _e77), (_e48.z + _e79), (_e48.w + _e81));
                    local_7 = vec4<f32>((_e50.x + _e67), (_e50.y + _e69), (_e50.z + _e71), (_e50.w + _e73));
                    local_8 = (_e52 + 1u);
                    local_9 = (_e54 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e151 = local_4;
                    phi_104_ = _e151;
                    let _e154 = local_5;
                    phi_107_ = _e154;
                    let _e157 = local_6;
                    phi_109_ = _e157;
                    let _e160 = local_7;
                    phi_111_ = _e160;
                    let _e163 = local_8;
                    phi_113_ = _e163;
                    let _e166 = local_9;
                    phi_115_ = _e166;
                }
            }
            let _e129 = ((_e35 + _e24) * 4u);
            let _e133 = local;
            global_6.member[_e129] = _e133;
            let _e138 = local_1;
            global_6.member[(_e129 + 1u)] = _e138;
            let _e143 = local_2;
            global_6.member[(_e129 + 2u)] = _e143;
            let _e148 = local_3;
            global_6.member[(_e129 + 3u)] = _e148;
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn ssim_rows(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
