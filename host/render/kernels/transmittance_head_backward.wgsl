struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_17 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_17;
@group(0) @binding(2) 
var<storage> global_6: type_17;
@group(0) @binding(4) 
var<storage> global_7: type_17;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_17;

fn function_() {
    var phi_77_: u32;
    var phi_80_: u32;
    var phi_82_: type_14;
    var phi_84_: u32;
    var local: type_14;
    var local_1: u32;
    var local_2: u32;
    var local_3: type_14;
    var local_4: u32;

    let _e19 = global;
    let _e20 = global_1;
    let _e21 = global_2;
    let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
    let _e32 = global_3.member.member;
    if (_e29 < _e32) {
        let _e36 = global_3.member.member_2;
        let _e39 = global_3.member.member_3;
        let _e42 = global_3.member.member_4;
        let _e45 = global_3.member.member_5;
        let _e48 = global_4.member[_e45];
        phi_77_ = 0u;
        phi_80_ = _e42;
        phi_82_ = type_14(_e48.x, _e48.y, _e48.z, _e48.w);
        phi_84_ = _e29;
        loop {
            let _e55 = phi_77_;
            let _e57 = phi_80_;
            let _e59 = phi_82_;
            let _e61 = phi_84_;
            local = _e59;
            if (_e55 < _e39) {
                let _e65 = global_4.member[_e57];
                let _e68 = global_5.member[_e61];
                local_1 = (_e55 + 1u);
                local_2 = (_e57 + 1u);
                local_3 = type_14(((_e68 * _e65.x) + _e59.member), ((_e68 * _e65.y) + _e59.member_1), ((_e68 * _e65.z) + _e59.member_2), ((_e68 * _e65.w) + _e59.member_3));
                local_4 = (_e61 + _e36);
                continue;
            } else {
                break;
            }
            continuing {
                let _e115 = local_1;
                phi_77_ = _e115;
                let _e118 = local_2;
                phi_80_ = _e118;
                let _e121 = local_3;
                phi_82_ = _e121;
                let _e124 = local_4;
                phi_84_ = _e124;
            }
        }
        let _e90 = local;
        let _e96 = global_6.member[((6u * _e36) + _e29)];
        let _e99 = global_7.member[_e29];
        let _e101 = -(_e90.member);
        let _e102 = (_e101 < 0f);
        let _e105 = exp(select(-(_e101), _e101, _e102));
        let _e107 = (1f / (1f + _e105));
        global_8.member[_e29] = ((_e99 * _e96) * select(_e107, (_e105 * _e107), _e102));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_head_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
