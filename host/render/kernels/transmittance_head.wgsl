struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_16 {
    member: type_15,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_16;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_85_: u32;
    var phi_88_: u32;
    var phi_90_: type_18;
    var phi_92_: u32;
    var local: type_18;
    var local_1: u32;
    var local_2: u32;
    var local_3: type_18;
    var local_4: u32;

    let _e27 = global;
    let _e28 = global_1;
    let _e29 = global_2;
    let _e37 = (((_e28.x + (_e28.y * _e29.x)) * 64u) + _e27.x);
    let _e40 = global_3.member.member;
    if (_e37 < _e40) {
        let _e44 = global_3.member.member_2;
        let _e47 = global_3.member.member_3;
        let _e50 = global_3.member.member_4;
        let _e53 = global_3.member.member_5;
        let _e56 = global_4.member[_e53];
        phi_85_ = 0u;
        phi_88_ = _e50;
        phi_90_ = type_18(_e56.x, _e56.y, _e56.z, _e56.w);
        phi_92_ = _e37;
        loop {
            let _e63 = phi_85_;
            let _e65 = phi_88_;
            let _e67 = phi_90_;
            let _e69 = phi_92_;
            local = _e67;
            if (_e63 < _e47) {
                let _e73 = global_4.member[_e65];
                let _e76 = global_6.member[_e69];
                local_1 = (_e63 + 1u);
                local_2 = (_e65 + 1u);
                local_3 = type_18(((_e76 * _e73.x) + _e67.member), ((_e76 * _e73.y) + _e67.member_1), ((_e76 * _e73.z) + _e67.member_2), ((_e76 * _e73.w) + _e67.member_3));
                local_4 = (_e69 + _e44);
                continue;
            } else {
                break;
            }
            continuing {
                let _e137 = local_1;
                phi_85_ = _e137;
                let _e140 = local_2;
                phi_88_ = _e140;
                let _e143 = local_3;
                phi_90_ = _e143;
                let _e146 = local_4;
                phi_92_ = _e146;
            }
        }
        let _e98 = local;
        let _e104 = global_5.member[((6u * _e44) + _e37)];
        let _e105 = (_e98.member < 0f);
        let _e109 = exp(select(-(_e98.member), _e98.member, _e105));
        let _e111 = (_e109 / (2f + _e109));
        let _e112 = (_e111 * _e111);
        let _e131 = global_3.member.member_1;
        global_7.member[(_e131 + _e37)] = (_e104 * (select(0f, _e98.member, _e105) - ((2f * _e111) * (1f + (_e112 * (0.33333334f + (_e112 * (0.2f + (_e112 * (0.14285715f + (_e112 * (0.11111111f + (_e112 * (0.09090909f + (_e112 * 0.07692308f)))))))))))))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_head(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
