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
    var phi_135_: vec4<f32>;
    var phi_138_: vec4<f32>;
    var phi_140_: vec4<f32>;
    var phi_142_: u32;
    var phi_144_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_226_: f32;
    var phi_235_: f32;
    var phi_245_: f32;

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
                let _e66 = (_e63 < (((_e40 + (select(_e44, _e35, (_e35 < _e44)) * _e35)) + _e30) * 3u));
                if _e66 {
                    let _e69 = global_3.member[_e65];
                    let _e72 = global_6.member[_e63];
                    let _e93 = global_6.member[(_e63 + 1u)];
                    let _e114 = global_6.member[(_e63 + 2u)];
                    phi_135_ = vec4<f32>((_e57.x + (_e114.x * _e69)), (_e57.y + (_e114.y * _e69)), (_e57.z + (_e114.z * _e69)), (_e57.w + (_e114.w * _e69)));
                    phi_138_ = vec4<f32>((_e59.x + (_e93.x * _e69)), (_e59.y + (_e93.y * _e69)), (_e59.z + (_e93.z * _e69)), (_e59.w + (_e93.w * _e69)));
                    phi_140_ = vec4<f32>((_e61.x + (_e72.x * _e69)), (_e61.y + (_e72.y * _e69)), (_e61.z + (_e72.z * _e69)), (_e61.w + (_e72.w * _e69)));
                    phi_142_ = (_e63 + (_e35 * 3u));
                    phi_144_ = (_e65 + 1u);
                } else {
                    phi_135_ = vec4<f32>();
                    phi_138_ = vec4<f32>();
                    phi_140_ = vec4<f32>();
                    phi_142_ = u32();
                    phi_144_ = u32();
                }
                let _e136 = phi_135_;
                let _e138 = phi_138_;
                let _e140 = phi_140_;
                let _e142 = phi_142_;
                let _e144 = phi_144_;
                continue;
                continuing {
                    phi_134_ = _e136;
                    phi_137_ = _e138;
                    phi_139_ = _e140;
                    phi_141_ = _e142;
                    phi_143_ = _e144;
                    break if !(_e66);
                }
            }
            let _e147 = ((_e32 * _e35) + _e30);
            let _e148 = (_e40 + _e147);
            let _e151 = global_4.member[_e148];
            let _e154 = local;
            let _e159 = local_1;
            let _e164 = local_2;
            let _e168 = local_3;
            let _e172 = local_4;
            let _e176 = local_5;
            let _e181 = global_5.member[_e148];
            let _e184 = local_6;
            let _e189 = local_7;
            let _e194 = local_8;
            let _e202 = global_2.member.member_2;
            let _e208 = global_2.member.member_1;
            let _e210 = ((_e40 * 3u) + _e147);
            if (_e151.x >= 0.000000000000000000000000000000000000011754944f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = select(0f, -1f, (_e151.x <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e216 = phi_226_;
            global_7.member[_e210] = (_e151.w * ((((_e168.x + (_e151.x * _e154.x)) + (_e181.x * _e184.x)) * _e202) + (_e208 * _e216)));
            if (_e151.y >= 0.000000000000000000000000000000000000011754944f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = select(0f, -1f, (_e151.y <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e227 = phi_235_;
            global_7.member[(_e210 + _e38)] = (_e151.w * ((((_e172.y + (_e151.y * _e159.y)) + (_e181.y * _e189.y)) * _e202) + (_e208 * _e227)));
            if (_e151.z >= 0.000000000000000000000000000000000000011754944f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = select(0f, -1f, (_e151.z <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e239 = phi_245_;
            global_7.member[(_e210 + (2u * _e38))] = (_e151.w * ((((_e176.z + (_e151.z * _e164.z)) + (_e181.z * _e194.z)) * _e202) + (_e208 * _e239)));
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
