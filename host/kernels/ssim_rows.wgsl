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
    var phi_107_: vec4<f32>;
    var phi_110_: vec4<f32>;
    var phi_112_: vec4<f32>;
    var phi_114_: vec4<f32>;
    var phi_116_: u32;
    var phi_118_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;

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
                let _e57 = (_e54 < select(_e41, _e31, (_e31 < _e41)));
                if _e57 {
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
                    phi_107_ = vec4<f32>((_e46.x + (_e77 * _e67.x)), (_e46.y + (_e79 * _e67.y)), (_e46.z + (_e81 * _e67.z)), (_e46.w + (_e83 * _e67.w)));
                    phi_110_ = vec4<f32>((_e48.x + (_e69 * _e64.x)), (_e48.y + (_e71 * _e64.y)), (_e48.z + (_e73 * _e64.z)), (_e48.w + (_e75 * _e64.w)));
                    phi_112_ = vec4<f32>((_e50.x + _e77), (_e50.y + _e79), (_e50.z + _e81), (_e50.w + _e83));
                    phi_114_ = vec4<f32>((_e52.x + _e69), (_e52.y + _e71), (_e52.z + _e73), (_e52.w + _e75));
                    phi_116_ = (_e54 + 1u);
                    phi_118_ = (_e56 + 1u);
                } else {
                    phi_107_ = vec4<f32>();
                    phi_110_ = vec4<f32>();
                    phi_112_ = vec4<f32>();
                    phi_114_ = vec4<f32>();
                    phi_116_ = u32();
                    phi_118_ = u32();
                }
                let _e131 = phi_107_;
                let _e133 = phi_110_;
                let _e135 = phi_112_;
                let _e137 = phi_114_;
                let _e139 = phi_116_;
                let _e141 = phi_118_;
                continue;
                continuing {
                    phi_106_ = _e131;
                    phi_109_ = _e133;
                    phi_111_ = _e135;
                    phi_113_ = _e137;
                    phi_115_ = _e139;
                    phi_117_ = _e141;
                    break if !(_e57);
                }
            }
            let _e144 = ((_e37 + _e26) * 4u);
            let _e148 = local;
            global_6.member[_e144] = _e148;
            let _e153 = local_1;
            global_6.member[(_e144 + 1u)] = _e153;
            let _e158 = local_2;
            global_6.member[(_e144 + 2u)] = _e158;
            let _e163 = local_3;
            global_6.member[(_e144 + 3u)] = _e163;
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
