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
var<storage, read_write> global_5: type_12;

fn function_() {
    var phi_100_: vec4<f32>;
    var phi_103_: vec4<f32>;
    var phi_105_: vec4<f32>;
    var phi_107_: u32;
    var phi_109_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: u32;
    var local_7: u32;

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
            phi_100_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_103_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_105_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_107_ = ((_e35 + (_e37 - 5u)) * 3u);
            phi_109_ = (_e37 - _e24);
            loop {
                let _e48 = phi_100_;
                let _e50 = phi_103_;
                let _e52 = phi_105_;
                let _e54 = phi_107_;
                let _e56 = phi_109_;
                local = _e52;
                local_1 = _e50;
                local_2 = _e48;
                if (_e54 < ((_e35 + select(_e39, _e29, (_e29 < _e39))) * 3u)) {
                    let _e60 = global_3.member[_e56];
                    let _e63 = global_4.member[_e54];
                    let _e84 = global_4.member[(_e54 + 1u)];
                    let _e105 = global_4.member[(_e54 + 2u)];
                    local_3 = vec4<f32>((_e48.x + (_e105.x * _e60)), (_e48.y + (_e105.y * _e60)), (_e48.z + (_e105.z * _e60)), (_e48.w + (_e105.w * _e60)));
                    local_4 = vec4<f32>((_e50.x + (_e84.x * _e60)), (_e50.y + (_e84.y * _e60)), (_e50.z + (_e84.z * _e60)), (_e50.w + (_e84.w * _e60)));
                    local_5 = vec4<f32>((_e52.x + (_e63.x * _e60)), (_e52.y + (_e63.y * _e60)), (_e52.z + (_e63.z * _e60)), (_e52.w + (_e63.w * _e60)));
                    local_6 = (_e54 + 3u);
                    local_7 = (_e56 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e143 = local_3;
                    phi_100_ = _e143;
                    let _e146 = local_4;
                    phi_103_ = _e146;
                    let _e149 = local_5;
                    phi_105_ = _e149;
                    let _e152 = local_6;
                    phi_107_ = _e152;
                    let _e155 = local_7;
                    phi_109_ = _e155;
                }
            }
            let _e126 = ((_e35 + _e24) * 3u);
            let _e130 = local;
            global_5.member[_e126] = _e130;
            let _e135 = local_1;
            global_5.member[(_e126 + 1u)] = _e135;
            let _e140 = local_2;
            global_5.member[(_e126 + 2u)] = _e140;
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn ssim_rows_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
