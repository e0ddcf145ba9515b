struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<vec4<f32>>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_20 {
    member: type_19,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_11;
@group(0) @binding(0) 
var<uniform> global_4: type_20;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage> global_7: type_11;
@group(0) @binding(5) 
var<storage> global_8: type_5;
@group(0) @binding(6) 
var<storage> global_9: type_5;
@group(0) @binding(7) 
var<storage> global_10: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_16;

fn function_() {
    var phi_105_: vec4<f32>;
    var phi_108_: vec4<f32>;
    var phi_110_: vec4<f32>;
    var phi_112_: u32;
    var phi_106_: vec4<f32>;
    var phi_109_: vec4<f32>;
    var phi_111_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e26 = global_1;
            let _e27 = global_2;
            let _e35 = (((_e26.x + (_e26.y * _e27.x)) * 64u) + _e25.x);
            let _e38 = global_4.member.member;
            if (_e35 < _e38) {
                let _e42 = global_3.member[_e35];
                let _e45 = global_4.member.member_1;
                let _e46 = (_e45 == 0u);
                if _e46 {
                    break;
                }
                let _e47 = (_e42 / _e45);
                if _e46 {
                    break;
                }
                let _e48 = (_e42 % _e45);
                let _e53 = (1u << bitcast<u32>(((_e48 % 32u) & 31u)));
                let _e57 = global_5.member[(_e47 + 1u)];
                let _e60 = global_5.member[_e47];
                phi_105_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_108_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_110_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_112_ = _e60;
                loop {
                    let _e62 = phi_105_;
                    let _e64 = phi_108_;
                    let _e66 = phi_110_;
                    let _e68 = phi_112_;
                    local = _e66;
                    local_1 = _e66;
                    local_2 = _e66;
                    local_3 = _e64;
                    local_4 = _e62;
                    if (_e68 < _e57) {
                        let _e72 = global_4.member.member_2;
                        let _e74 = ((_e68 * _e72) + (_e48 / 32u));
                        let _e77 = global_6.member[_e74];
                        if ((_e77 & _e53) == 0u) {
                            phi_106_ = _e62;
                            phi_109_ = _e64;
                            phi_111_ = _e66;
                        } else {
                            let _e85 = global_7.member[_e74];
                            let _e87 = (3u * (_e85 + countOneBits((_e77 & (_e53 - 1u)))));
                            let _e90 = global_10.member[_e87];
                            let _e95 = global_10.member[(_e87 + 1u)];
                            let _e100 = global_10.member[(_e87 + 2u)];
                            phi_106_ = (_e62 + _e100);
                            phi_109_ = (_e64 + _e95);
                            phi_111_ = (_e66 + _e90);
                        }
                        let _e103 = phi_106_;
                        let _e105 = phi_109_;
                        let _e107 = phi_111_;
                        local_5 = _e103;
                        local_6 = _e105;
                        local_7 = _e107;
                        local_8 = (_e68 + 1u);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e158 = local_5;
                        phi_105_ = _e158;
                        let _e161 = local_6;
                        phi_108_ = _e161;
                        let _e164 = local_7;
                        phi_110_ = _e164;
                        let _e167 = local_8;
                        phi_112_ = _e167;
                    }
                }
                let _e111 = global_8.member[_e48];
                let _e113 = local;
                let _e115 = (_e111 < 0f);
                let _e116 = -(_e111);
                let _e118 = exp(select(_e116, _e111, _e115));
                let _e120 = (1f / (1f + _e118));
                let _e123 = (_e113.z * select(_e120, (_e118 * _e120), _e115));
                let _e126 = global_9.member[_e35];
                let _e128 = (_e116 < 0f);
                let _e130 = exp(select(_e111, _e116, _e128));
                let _e132 = (1f / (1f + _e130));
                let _e136 = (3u * _e35);
                let _e138 = local_1;
                let _e141 = local_2;
                global_11.member[_e136] = vec4<f32>(_e138.x, _e141.y, ((_e123 * _e126) * select(_e132, (_e130 * _e132), _e128)), _e123);
                let _e150 = local_3;
                global_11.member[(_e136 + 1u)] = _e150;
                let _e155 = local_4;
                global_11.member[(_e136 + 2u)] = _e155;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn splat_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
