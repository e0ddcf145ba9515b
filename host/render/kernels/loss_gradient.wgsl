struct type_5 {
    member: array<f32>,
}

struct type_13 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_17 {
    member: type_16,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_17;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_13;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_13;
@group(0) @binding(5) 
var<storage, read_write> global_7: type_5;

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

    let _e23 = global;
    let _e24 = global_1;
    let _e30 = ((_e24.x * 8u) + _e23.x);
    let _e32 = ((_e24.y * 8u) + _e23.y);
    let _e35 = global_2.member.member;
    if (_e30 < _e35) {
        if (_e32 < _e35) {
            let _e38 = (_e35 * _e35);
            let _e40 = (_e24.z * _e38);
            let _e42 = select(5u, _e32, (_e32 > 5u));
            let _e44 = (_e32 + 6u);
            phi_134_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_137_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_139_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_141_ = (((_e40 + ((_e42 - 5u) * _e35)) + _e30) * 3u);
            phi_143_ = (_e42 - _e32);
            loop {
                let _e57 = phi_134_;
                let _e59 = phi_137_;
                let _e61 = phi_139_;
                let _e63 = phi_141_;
                let _e65 = phi_143_;
                local = _e59;
                local_1 = _e59;
                local_2 = _e59;
                local_3 = _e61;
                local_4 = _e61;
                local_5 = _e61;
                local_6 = _e57;
                local_7 = _e57;
                local_8 = _e57;
                if (_e63 < (((_e40 + (select(_e44, _e35, (_e35 < _e44)) * _e35)) + _e30) * 3u)) {
                    let _e69 = global_3.member[_e65];
                    let _e72 = global_6.member[_e63];
                    let _e93 = global_6.member[(_e63 + 1u)];
                    let _e114 = global_6.member[(_e63 + 2u)];
                    local_9 = vec4<f32>((_e57.x + (_e114.x * _e69)), (_e57.y + (_e114.y * _e69)), (_e57.z + (_e114.z * _e69)), (_e57.w + (_e114.w * _e69)));
                    local_10 = vec4<f32>((_e59.x + (_e93.x * _e69)), (_e59.y + (_e93.y * _e69)), (_e59.z + (_e93.z * _e69)), (_e59.w + (_e93.w * _e69)));
                    local_11 = vec4<f32>((_e61.x + (_e72.x * _e69)), (_e61.y + (_e72.y * _e69)), (_e61.z + (_e72.z * _e69)), (_e61.w + (_e72.w * _e69)));
                    local_12 = (_e63 + (_e35 * 3u));
                    local_13 = (_e65 + 1u);
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
            let _e136 = ((_e32 * _e35) + _e30);
            let _e137 = (_e40 + _e136);
            let _e140 = global_4.member[_e137];
            let _e143 = local;
            let _e148 = local_1;
            let _e153 = local_2;
            let _e157 = local_3;
            let _e161 = local_4;
            let _e165 = local_5;
            let _e170 = global_5.member[_e137];
            let _e173 = local_6;
            let _e178 = local_7;
            let _e183 = local_8;
            let _e191 = global_2.member.member_2;
            let _e197 = global_2.member.member_1;
            let _e199 = ((_e40 * 3u) + _e136);
            if (_e140.x >= 0.000000000000000000000000000000000000011754944f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = select(0f, -1f, (_e140.x <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e205 = phi_218_;
            global_7.member[_e199] = (_e140.w * ((((_e157.x + (_e140.x * _e143.x)) + (_e170.x * _e173.x)) * _e191) + (_e197 * _e205)));
            if (_e140.y >= 0.000000000000000000000000000000000000011754944f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = select(0f, -1f, (_e140.y <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e216 = phi_227_;
            global_7.member[(_e199 + _e38)] = (_e140.w * ((((_e161.y + (_e140.y * _e148.y)) + (_e170.y * _e178.y)) * _e191) + (_e197 * _e216)));
            if (_e140.z >= 0.000000000000000000000000000000000000011754944f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = select(0f, -1f, (_e140.z <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e228 = phi_237_;
            global_7.member[(_e199 + (2u * _e38))] = (_e140.w * ((((_e165.z + (_e140.z * _e153.z)) + (_e170.z * _e183.z)) * _e191) + (_e197 * _e228)));
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
