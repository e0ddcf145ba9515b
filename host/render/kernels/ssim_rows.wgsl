struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: u32,
}

struct type_16 {
    member: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_12;

fn function_() {
    var phi_106_: vec4<f32>;
    var phi_109_: vec4<f32>;
    var phi_111_: vec4<f32>;
    var phi_113_: vec4<f32>;
    var phi_115_: u32;
    var phi_117_: u32;
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

    let _e19 = global;
    let _e20 = global_1;
    let _e26 = ((_e20.x * 8u) + _e19.x);
    let _e28 = ((_e20.y * 8u) + _e19.y);
    let _e31 = global_2.member.member;
    if (_e26 < _e31) {
        if (_e28 < _e31) {
            let _e37 = (((_e20.z * _e31) + _e28) * _e31);
            let _e39 = select(5u, _e26, (_e26 > 5u));
            let _e41 = (_e26 + 6u);
            phi_106_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_109_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_111_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_113_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_115_ = (_e39 - 5u);
            phi_117_ = (_e39 - _e26);
            loop {
                let _e46 = phi_106_;
                let _e48 = phi_109_;
                let _e50 = phi_111_;
                let _e52 = phi_113_;
                let _e54 = phi_115_;
                let _e56 = phi_117_;
                local = _e52;
                local_1 = _e50;
                local_2 = _e48;
                local_3 = _e46;
                if (_e54 < select(_e41, _e31, (_e31 < _e41))) {
                    let _e60 = global_3.member[_e56];
                    let _e61 = (_e37 + _e54);
                    let _e64 = global_4.member[_e61];
                    let _e67 = global_5.member[_e61];
                    let _e69 = (_e64.x * _e60);
                    let _e71 = (_e64.y * _e60);
                    let _e73 = (_e64.z * _e60);
                    let _e75 = (_e64.w * _e60);
                    let _e77 = (_e67.x * _e60);
                    let _e79 = (_e67.y * _e60);
                    let _e81 = (_e67.z * _e60);
                    let _e83 = (_e67.w * _e60);
                    local_4 = vec4<f32>((_e46.x + (_e77 * _e67.x)), (_e46.y + (_e79 * _e67.y)), (_e46.z + (_e81 * _e67.z)), (_e46.w + (_e83 * _e67.w)));
                    local_5 = vec4<f32>((_e48.x + (_e69 * _e64.x)), (_e48.y + (_e71 * _e64.y)), (_e48.z + (_e73 * _e64.z)), (_e48.w + (_e75 * _e64.w)));
                    local_6 = vec4<f32>((_e50.x + _e77), (_e50.y + _e79), (_e50.z + _e81), (_e50.w + _e83));
                    local_7 = vec4<f32>((_e52.x + _e69), (_e52.y + _e71), (_e52.z + _e73), (_e52.w + _e75));
                    local_8 = (_e54 + 1u);
                    local_9 = (_e56 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e153 = local_4;
                    phi_106_ = _e153;
                    let _e156 = local_5;
                    phi_109_ = _e156;
                    let _e159 = local_6;
                    phi_111_ = _e159;
                    let _e162 = local_7;
                    phi_113_ = _e162;
                    let _e165 = local_8;
                    phi_115_ = _e165;
                    let _e168 = local_9;
                    phi_117_ = _e168;
                }
            }
            let _e131 = ((_e37 + _e26) * 4u);
            let _e135 = local;
            global_6.member[_e131] = _e135;
            let _e140 = local_1;
            global_6.member[(_e131 + 1u)] = _e140;
            let _e145 = local_2;
            global_6.member[(_e131 + 2u)] = _e145;
            let _e150 = local_3;
            global_6.member[(_e131 + 3u)] = _e150;
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
