struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage> global_5: type_15;
@group(0) @binding(3) 
var<storage> global_6: type_15;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_15;
@group(0) @binding(6) 
var<storage> global_8: type_15;
@group(0) @binding(4) 
var<storage> global_9: type_15;
@group(0) @binding(5) 
var<storage> global_10: type_15;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_15;

fn function_() {
    var phi_211_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global;
            let _e30 = global_1;
            let _e31 = global_2;
            let _e39 = (((_e30.x + (_e30.y * _e31.x)) * 64u) + _e29.x);
            let _e42 = global_3.member.member;
            if (_e39 < _e42) {
                let _e46 = global_4.member[_e39];
                let _e49 = global_3.member.member_1;
                let _e50 = (_e49 == 0u);
                if _e50 {
                    break;
                }
                let _e51 = (_e46 % _e49);
                if _e50 {
                    break;
                }
                let _e53 = ((_e46 / _e49) * 18u);
                let _e57 = global_5.member[(_e53 + 6u)];
                let _e61 = global_5.member[(_e53 + 7u)];
                let _e65 = global_5.member[(_e53 + 8u)];
                let _e69 = global_5.member[(_e53 + 9u)];
                let _e73 = global_5.member[(_e53 + 10u)];
                let _e77 = global_5.member[(_e53 + 11u)];
                let _e78 = (_e51 * 3u);
                let _e81 = global_6.member[_e78];
                let _e82 = (_e78 + 1u);
                let _e85 = global_6.member[_e82];
                let _e86 = (_e78 + 2u);
                let _e89 = global_6.member[_e86];
                let _e90 = (3u * _e39);
                let _e91 = (_e81 - _e69);
                let _e92 = (_e85 - _e73);
                let _e93 = (_e89 - _e77);
                global_7.member[_e90] = (((_e57 * _e91) + (_e61 * _e92)) + (_e65 * _e93));
                let _e101 = (_e90 + 1u);
                let _e104 = global_8.member[_e39];
                global_7.member[_e101] = _e104;
                let _e107 = (_e90 + 2u);
                global_7.member[_e107] = 0f;
                let _e110 = (_e51 * 4u);
                let _e113 = global_9.member[_e110];
                let _e117 = global_9.member[(_e110 + 1u)];
                let _e121 = global_9.member[(_e110 + 2u)];
                let _e125 = global_9.member[(_e110 + 3u)];
                let _e128 = global_10.member[_e78];
                let _e131 = global_10.member[_e82];
                let _e134 = global_10.member[_e86];
                let _e143 = (1f / sqrt(((((_e113 * _e113) + (_e117 * _e117)) + (_e121 * _e121)) + (_e125 * _e125))));
                let _e144 = (_e113 * _e143);
                let _e145 = (_e117 * _e143);
                let _e146 = (_e121 * _e143);
                let _e147 = (_e125 * _e143);
                let _e148 = (_e146 * _e146);
                let _e149 = (_e147 * _e147);
                let _e153 = (_e145 * _e146);
                let _e154 = (_e144 * _e147);
                let _e157 = (_e145 * _e147);
                let _e158 = (_e144 * _e146);
                let _e164 = (_e145 * _e145);
                let _e168 = (_e146 * _e147);
                let _e169 = (_e144 * _e145);
                let _e181 = (_e131 < _e128);
                let _e187 = select(select(vec3<f32>((1f - (2f * (_e148 + _e149))), (2f * (_e153 + _e154)), (2f * (_e157 - _e158))), vec3<f32>((2f * (_e153 - _e154)), (1f - (2f * (_e164 + _e149))), (2f * (_e168 + _e169))), vec3(_e181)), vec3<f32>((2f * (_e157 + _e158)), (2f * (_e168 - _e169)), (1f - (2f * (_e164 + _e148)))), vec3((_e134 < select(_e128, _e131, _e181))));
                if ((((_e187.x * _e91) + (_e187.y * _e92)) + (_e187.z * _e93)) > 0f) {
                    phi_211_ = -(_e187);
                } else {
                    phi_211_ = _e187;
                }
                let _e199 = phi_211_;
                global_11.member[_e90] = _e199.x;
                global_11.member[_e101] = _e199.y;
                global_11.member[_e107] = _e199.z;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_channels(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
