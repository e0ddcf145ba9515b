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
    var phi_132_: vec4<f32>;
    var phi_135_: vec4<f32>;
    var phi_137_: vec4<f32>;
    var phi_139_: u32;
    var phi_141_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_216_: f32;
    var phi_225_: f32;
    var phi_235_: f32;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: u32;
    var local_13: u32;

    let _e21 = global;
    let _e22 = global_1;
    let _e28 = ((_e22.x * 8u) + _e21.x);
    let _e30 = ((_e22.y * 8u) + _e21.y);
    let _e33 = global_2.member.member;
    if (_e28 < _e33) {
        if (_e30 < _e33) {
            let _e36 = (_e33 * _e33);
            let _e38 = (_e22.z * _e36);
            let _e40 = select(5u, _e30, (_e30 > 5u));
            let _e42 = (_e30 + 6u);
            phi_132_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_135_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_137_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_139_ = (((_e38 + ((_e40 - 5u) * _e33)) + _e28) * 3u);
            phi_141_ = (_e40 - _e30);
            loop {
                let _e55 = phi_132_;
                let _e57 = phi_135_;
                let _e59 = phi_137_;
                let _e61 = phi_139_;
                let _e63 = phi_141_;
                local = _e57;
                local_1 = _e57;
                local_2 = _e57;
                local_3 = _e59;
                local_4 = _e59;
                local_5 = _e59;
                local_6 = _e55;
                local_7 = _e55;
                local_8 = _e55;
                if (_e61 < (((_e38 + (select(_e42, _e33, (_e33 < _e42)) * _e33)) + _e28) * 3u)) {
                    let _e67 = global_3.member[_e63];
                    let _e70 = global_4.member[_e61];
                    let _e91 = global_4.member[(_e61 + 1u)];
                    let _e112 = global_4.member[(_e61 + 2u)];
                    local_9 = vec4<f32>((_e55.x + (_e112.x * _e67)), (_e55.y + (_e112.y * _e67)), (_e55.z + (_e112.z * _e67)), (_e55.w + (_e112.w * _e67)));
                    local_10 = vec4<f32>((_e57.x + (_e91.x * _e67)), (_e57.y + (_e91.y * _e67)), (_e57.z + (_e91.z * _e67)), (_e57.w + (_e91.w * _e67)));
                    local_11 = vec4<f32>((_e59.x + (_e70.x * _e67)), (_e59.y + (_e70.y * _e67)), (_e59.z + (_e70.z * _e67)), (_e59.w + (_e70.w * _e67)));
                    local_12 = (_e61 + (_e33 * 3u));
                    local_13 = (_e63 + 1u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e234 = local_9;
                    phi_132_ = _e234;
                    let _e237 = local_10;
                    phi_135_ = _e237;
                    let _e240 = local_11;
                    phi_137_ = _e240;
                    let _e243 = local_12;
                    phi_139_ = _e243;
                    let _e246 = local_13;
                    phi_141_ = _e246;
                }
            }
            let _e134 = ((_e30 * _e33) + _e28);
            let _e135 = (_e38 + _e134);
            let _e138 = global_5.member[_e135];
            let _e141 = local;
            let _e146 = local_1;
            let _e151 = local_2;
            let _e155 = local_3;
            let _e159 = local_4;
            let _e163 = local_5;
            let _e168 = global_6.member[_e135];
            let _e171 = local_6;
            let _e176 = local_7;
            let _e181 = local_8;
            let _e189 = global_2.member.member_2;
            let _e195 = global_2.member.member_1;
            let _e197 = ((_e38 * 3u) + _e134);
            if (_e138.x >= 0.000000000000000000000000000000000000011754944f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = select(0f, -1f, (_e138.x <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e203 = phi_216_;
            global_7.member[_e197] = (_e138.w * ((((_e155.x + (_e138.x * _e141.x)) + (_e168.x * _e171.x)) * _e189) + (_e195 * _e203)));
            if (_e138.y >= 0.000000000000000000000000000000000000011754944f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = select(0f, -1f, (_e138.y <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e214 = phi_225_;
            global_7.member[(_e197 + _e36)] = (_e138.w * ((((_e159.y + (_e138.y * _e146.y)) + (_e168.y * _e176.y)) * _e189) + (_e195 * _e214)));
            if (_e138.z >= 0.000000000000000000000000000000000000011754944f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = select(0f, -1f, (_e138.z <= -0.000000000000000000000000000000000000011754944f));
            }
            let _e226 = phi_235_;
            global_7.member[(_e197 + (2u * _e36))] = (_e138.w * ((((_e163.z + (_e138.z * _e151.z)) + (_e168.z * _e181.z)) * _e189) + (_e195 * _e226)));
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
