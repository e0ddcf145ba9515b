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
var<storage, read_write> global_5: type_16;

fn function_() {
    var phi_98_: vec4<f32>;
    var phi_101_: vec4<f32>;
    var phi_103_: vec4<f32>;
    var phi_105_: u32;
    var phi_107_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: u32;
    var local_7: u32;

    let _e15 = global;
    let _e16 = global_1;
    let _e22 = ((_e16.x * 8u) + _e15.x);
    let _e24 = ((_e16.y * 8u) + _e15.y);
    let _e27 = global_2.member.member;
    if (_e22 < _e27) {
        if (_e24 < _e27) {
            let _e33 = (((_e16.z * _e27) + _e24) * _e27);
            let _e35 = select(5u, _e22, (_e22 > 5u));
            let _e37 = (_e22 + 6u);
            phi_98_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_101_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_103_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_105_ = ((_e33 + (_e35 - 5u)) * 3u);
            phi_107_ = (_e35 - _e22);
            loop {
                let _e46 = phi_98_;
                let _e48 = phi_101_;
                let _e50 = phi_103_;
                let _e52 = phi_105_;
                let _e54 = phi_107_;
                local = _e50;
                local_1 = _e48;
                local_2 = _e46;
                if (_e52 < ((_e33 + select(_e37, _e27, (_e27 < _e37))) * 3u)) {
                    let _e58 = global_3.member[_e54];
                    let _e61 = global_4.member[_e52];
                    let _e82 = global_4.member[(_e52 + 1u)];
                    let _e103 = global_4.member[(_e52 + 2u)];
                    local_3 = vec4<f32>((_e46.x + (_e103.x * _e58)), (_e46.y + (_e103.y * _e58)), (_e46.z + (_e103.z * _e58)), (_e46.w + (_e103.w * _e58)));
                    local_4 = vec4<f32>((_e48.x + (_e82.x * _e58)), (_e48.y + (_e82.y * _e58)), (_e48.z + (_e82.z * _e58)), (_e48.w + (_e82.w * _e58)));
                    local_5 = vec4<f32>((_e50.x + (_e61.x * _e58)), (_e50.y + (_e61.y * _e58)), (_e50.z + (_e61.z * _e58)), (_e50.w + (_e61.w * _e58)));
                    local_6 = (_e52 + 3u);
                    local_7 = (_e54 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e141 = local_3;
                    phi_98_ = _e141;
                    let _e144 = local_4;
                    phi_101_ = _e144;
                    let _e147 = local_5;
                    phi_103_ = _e147;
                    let _e150 = local_6;
                    phi_105_ = _e150;
                    let _e153 = local_7;
                    phi_107_ = _e153;
                }
            }
            let _e124 = ((_e33 + _e22) * 3u);
            let _e128 = local;
            global_5.member[_e124] = _e128;
            let _e133 = local_1;
            global_5.member[(_e124 + 1u)] = _e133;
            let _e138 = local_2;
            global_5.member[(_e124 + 2u)] = _e138;
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
