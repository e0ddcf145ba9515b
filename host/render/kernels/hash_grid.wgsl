struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_15 {
    member: array<type_13>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(3) 
var<storage> global_3: type_5;
@group(0) @binding(0) 
var<uniform> global_4: type_11;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_5;
@group(0) @binding(2) 
var<storage> global_7: type_5;

fn function_() {
    var phi_302_: array<u32, 8>;
    var phi_334_: u32;
    var phi_337_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e26 = global_1;
            let _e27 = global_2;
            let _e33 = ((_e26.x + (_e26.y * _e27.x)) * 64u);
            let _e38 = global_4.member.member;
            if ((_e33 + _e25.x) < _e38) {
                let _e43 = global_5.member[_e26.z];
                let _e46 = global_4.member.member_1;
                let _e49 = global_4.member.member_5;
                let _e52 = global_4.member.member_4;
                let _e53 = (_e52 == 0u);
                if _e53 {
                    break;
                }
                let _e54 = (_e33 / _e52);
                let _e58 = (_e33 - (_e54 * _e52));
                let _e60 = (((_e54 * (_e49 * _e46)) + _e58) + _e25.x);
                let _e63 = global_3.member[_e60];
                let _e64 = (3u * _e46);
                let _e68 = global_3.member[(_e60 + _e64)];
                let _e69 = (_e46 + _e60);
                let _e72 = global_3.member[_e69];
                let _e76 = global_3.member[(_e69 + _e64)];
                let _e78 = ((2u * _e46) + _e60);
                let _e81 = global_3.member[_e78];
                let _e85 = global_3.member[(_e78 + _e64)];
                let _e88 = global_4.member.member_3;
                let _e89 = (_e63 + _e68);
                let _e92 = select(false, (_e89 < 1f), (0f < _e89));
                let _e95 = select(select(0f, 1f, (1f <= _e89)), _e63, _e92);
                let _e98 = (_e95 * _e43.member);
                let _e101 = (_e43.member + _e43.member_1);
                let _e105 = trunc(_e98);
                let _e107 = ((_e98 - _e105) + (((_e95 * _e43.member_1) + (select(0f, _e68, _e92) * _e101)) + 0.5f));
                let _e109 = select(0f, _e107, (_e107 > 0f));
                let _e110 = trunc(_e109);
                let _e111 = (_e109 - _e110);
                let _e113 = u32((_e105 + _e110));
                let _e114 = (_e72 + _e76);
                let _e117 = select(false, (_e114 < 1f), (0f < _e114));
                let _e120 = select(select(0f, 1f, (1f <= _e114)), _e72, _e117);
                let _e122 = (_e120 * _e43.member);
                let _e127 = trunc(_e122);
                let _e129 = ((_e122 - _e127) + (((_e120 * _e43.member_1) + (select(0f, _e76, _e117) * _e101)) + 0.5f));
                let _e131 = select(0f, _e129, (_e129 > 0f));
                let _e132 = trunc(_e131);
                let _e133 = (_e131 - _e132);
                let _e135 = u32((_e127 + _e132));
                let _e136 = (_e81 + _e85);
                let _e139 = select(false, (_e136 < 1f), (0f < _e136));
                let _e142 = select(select(0f, 1f, (1f <= _e136)), _e81, _e139);
                let _e144 = (_e142 * _e43.member);
                let _e149 = trunc(_e144);
                let _e151 = ((_e144 - _e149) + (((_e142 * _e43.member_1) + (select(0f, _e85, _e139) * _e101)) + 0.5f));
                let _e153 = select(0f, _e151, (_e151 > 0f));
                let _e154 = trunc(_e153);
                let _e155 = (_e153 - _e154);
                let _e157 = u32((_e149 + _e154));
                let _e158 = (1f - _e111);
                let _e159 = (1f - _e133);
                let _e160 = (1f - _e155);
                let _e161 = (_e158 * _e159);
                let _e162 = (_e111 * _e159);
                let _e163 = (_e158 * _e133);
                let _e164 = (_e111 * _e133);
                if (_e43.member_5 == 0u) {
                    let _e178 = (_e43.member_2 * _e43.member_2);
                    let _e179 = (_e135 * _e43.member_2);
                    let _e180 = (_e157 * _e178);
                    let _e181 = (_e113 + 1u);
                    let _e182 = (_e179 + _e43.member_2);
                    let _e183 = (_e180 + _e178);
                    let _e184 = (_e113 + _e179);
                    let _e185 = (_e184 + _e180);
                    let _e190 = (_e181 + _e179);
                    let _e191 = (_e190 + _e180);
                    let _e196 = (_e113 + _e182);
                    let _e197 = (_e196 + _e180);
                    let _e202 = (_e181 + _e182);
                    let _e203 = (_e202 + _e180);
                    let _e208 = (_e184 + _e183);
                    let _e213 = (_e190 + _e183);
                    let _e218 = (_e196 + _e183);
                    let _e223 = (_e202 + _e183);
                    phi_302_ = array<u32, 8>((select((_e185 - _e43.member_4), _e185, (_e185 < _e43.member_4)) + _e43.member_3), (select((_e191 - _e43.member_4), _e191, (_e191 < _e43.member_4)) + _e43.member_3), (select((_e197 - _e43.member_4), _e197, (_e197 < _e43.member_4)) + _e43.member_3), (select((_e203 - _e43.member_4), _e203, (_e203 < _e43.member_4)) + _e43.member_3), (select((_e208 - _e43.member_4), _e208, (_e208 < _e43.member_4)) + _e43.member_3), (select((_e213 - _e43.member_4), _e213, (_e213 < _e43.member_4)) + _e43.member_3), (select((_e218 - _e43.member_4), _e218, (_e218 < _e43.member_4)) + _e43.member_3), (select((_e223 - _e43.member_4), _e223, (_e223 < _e43.member_4)) + _e43.member_3));
                } else {
                    let _e230 = (_e43.member_4 - 1u);
                    let _e231 = (_e135 * 2654435761u);
                    let _e232 = (_e157 * 805459861u);
                    let _e233 = (_e113 + 1u);
                    let _e234 = (_e231 + 2654435761u);
                    let _e235 = (_e232 + 805459861u);
                    let _e236 = (_e113 ^ _e231);
                    let _e240 = (_e233 ^ _e231);
                    let _e244 = (_e113 ^ _e234);
                    let _e248 = (_e233 ^ _e234);
                    phi_302_ = array<u32, 8>((((_e236 ^ _e232) & _e230) + _e43.member_3), (((_e240 ^ _e232) & _e230) + _e43.member_3), (((_e244 ^ _e232) & _e230) + _e43.member_3), (((_e248 ^ _e232) & _e230) + _e43.member_3), (((_e236 ^ _e235) & _e230) + _e43.member_3), (((_e240 ^ _e235) & _e230) + _e43.member_3), (((_e244 ^ _e235) & _e230) + _e43.member_3), (((_e248 ^ _e235) & _e230) + _e43.member_3));
                }
                let _e266 = phi_302_;
                let _e285 = global_4.member.member_2;
                let _e290 = global_4.member.member_6;
                if _e53 {
                    break;
                }
                phi_334_ = 0u;
                phi_337_ = ((((_e54 * (_e290 * _e46)) + _e58) + _e25.x) + ((_e285 + (_e26.z * _e88)) * _e46));
                loop {
                    let _e298 = phi_334_;
                    let _e300 = phi_337_;
                    if (_e298 < _e88) {
                        let _e305 = global_7.member[((_e266[0] * _e88) + _e298)];
                        let _e310 = global_7.member[((_e266[1] * _e88) + _e298)];
                        let _e315 = global_7.member[((_e266[2] * _e88) + _e298)];
                        let _e320 = global_7.member[((_e266[3] * _e88) + _e298)];
                        let _e325 = global_7.member[((_e266[4] * _e88) + _e298)];
                        let _e330 = global_7.member[((_e266[5] * _e88) + _e298)];
                        let _e335 = global_7.member[((_e266[6] * _e88) + _e298)];
                        let _e340 = global_7.member[((_e266[7] * _e88) + _e298)];
                        global_6.member[_e300] = ((((((((_e305 * (_e161 * _e160)) + (_e310 * (_e162 * _e160))) + (_e315 * (_e163 * _e160))) + (_e320 * (_e164 * _e160))) + (_e325 * (_e161 * _e155))) + (_e330 * (_e162 * _e155))) + (_e335 * (_e163 * _e155))) + (_e340 * (_e164 * _e155)));
                        local = (_e298 + 1u);
                        local_1 = (_e300 + _e46);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e356 = local;
                        phi_334_ = _e356;
                        let _e359 = local_1;
                        phi_337_ = _e359;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
