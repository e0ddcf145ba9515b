struct type_5 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_6 {
    member: type_5,
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
var<uniform> global_2: type_6;
@group(0) @binding(1) 
var<storage> global_3: type_12;
@group(0) @binding(4) 
var<storage> global_4: type_16;
@group(0) @binding(2) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage> global_6: type_16;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_12;

fn function_() {
    var phi_134_: vec4<f32>;
    var phi_137_: vec4<f32>;
    var phi_139_: vec4<f32>;
    var phi_141_: u32;
    var phi_143_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_218_: f32;
    var phi_227_: f32;
    var phi_237_: f32;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: u32;
    var local_13: u32;

    let _e20 = global;
    let _e21 = global_1;
    let _e27 = ((_e21.x * 8u) + _e20.x);
    let _e29 = ((_e21.y * 8u) + _e20.y);
    let _e32 = global_2.member.member;
    if (_e27 < _e32) {
        if (_e29 < _e32) {
            let _e35 = (_e32 * _e32);
            let _e37 = (_e21.z * _e35);
            let _e39 = select(5u, _e29, (_e29 > 5u));
            let _e41 = (_e29 + 6u);
            phi_134_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_137_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_139_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_141_ = (((_e37 + ((_e39 - 5u) * _e32)) + _e27) * 3u);
            phi_143_ = (_e39 - _e29);
            loop {
                let _e54 = phi_134_;
                let _e56 = phi_137_;
                let _e58 = phi_139_;
                let _e60 = phi_141_;
                let _e62 = phi_143_;
                local = _e56;
                local_1 = _e56;
                local_2 = _e56;
                local_3 = _e58;
                local_4 = _e58;
                local_5 = _e58;
                local_6 = _e54;
                local_7 = _e54;
                local_8 = _e54;
                if (_e60 < (((_e37 + (select(_e41, _e32, (_e32 < _e41)) * _e32)) + _e27) * 3u)) {
                    let _e66 = global_3.member[_e62];
                    let _e69 = global_4.member[_e60];
                    let _e90 = global_4.member[(_e60 + 1u)];
                    let _e111 = global_4.member[(_e60 + 2u)];
                    local_9 = vec4<f32>((_e54.x + (_e111.x * _e66)), (_e54.y + (_e111.y * _e66)), (_e54.z + (_e111.z * _e66)), (_e54.w + (_e111.w * _e66)));
                    local_10 = vec4<f32>((_e56.x + (_e90.x * _e66)), (_e56.y + (_e90.y * _e66)), (_e56.z + (_e90.z * _e66)), (_e56.w + (_e90.w * _e66)));
                    local_11 = vec4<f32>((_e58.x + (_e69.x * _e66)), (_e58.y + (_e69.y * _e66)), (_e58.z + (_e69.z * _e66)), (_e58.w + (_e69.w * _e66)));
                    local_12 = (_e60 + (_e32 * 3u));
                    local_13 = (_e62 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e236 = local_9;
                    phi_134_ = _e236;
                    let _e239 = local_10;
                    phi_137_ = _e239;
                    let _e242 = local_11;
                    phi_139_ = _e242;
                    let _e245 = local_12;
                    phi_141_ = _e245;
                    let _e248 = local_13;
                    phi_143_ = _e248;
                }
            }
            let _e133 = ((_e29 * _e32) + _e27);
            let _e134 = (_e37 + _e133);
            let _e137 = global_5.member[_e134];
            let _e140 = local;
            let _e145 = local_1;
            let _e150 = local_2;
            let _e154 = local_3;
            let _e158 = local_4;
            let _e162 = local_5;
            let _e167 = global_6.member[_e134];
            let _e170 = local_6;
            let _e175 = local_7;
            let _e180 = local_8;
            let _e188 = global_2.member.member_2;
            let _e194 = global_2.member.member_1;
            let _e196 = ((_e37 * 3u) + _e133);
            if (_e137.x >= 0.000000000000000000000000000000000000011754944f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = select(0f, -1f, (_e137.x <= -(0.000000000000000000000000000000000000011754944f)));
            }
            let _e203 = phi_218_;
            global_7.member[_e196] = (_e137.w * ((((_e154.x + (_e137.x * _e140.x)) + (_e167.x * _e170.x)) * _e188) + (_e194 * _e203)));
            if (_e137.y >= 0.000000000000000000000000000000000000011754944f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = select(0f, -1f, (_e137.y <= -(0.000000000000000000000000000000000000011754944f)));
            }
            let _e215 = phi_227_;
            global_7.member[(_e196 + _e35)] = (_e137.w * ((((_e158.y + (_e137.y * _e145.y)) + (_e167.y * _e175.y)) * _e188) + (_e194 * _e215)));
            if (_e137.z >= 0.000000000000000000000000000000000000011754944f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = select(0f, -1f, (_e137.z <= -(0.000000000000000000000000000000000000011754944f)));
            }
            let _e228 = phi_237_;
            global_7.member[(_e196 + (2u * _e35))] = (_e137.w * ((((_e162.z + (_e137.z * _e150.z)) + (_e167.z * _e180.z)) * _e188) + (_e194 * _e228)));
        }
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn loss_gradient(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
