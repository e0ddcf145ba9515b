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
@group(0) @binding(2) 
var<storage> global_5: type_17;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_17;

fn function_() {
    var phi_74_: u32;
    var phi_77_: u32;
    var phi_79_: type_14;
    var phi_81_: u32;
    var local: type_14;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: u32;
    var local_4: u32;
    var local_5: type_14;
    var local_6: u32;

    let _e16 = global;
    let _e17 = global_1;
    let _e18 = global_2;
    let _e26 = (((_e17.x + (_e17.y * _e18.x)) * 64u) + _e16.x);
    let _e29 = global_3.member.member;
    if (_e26 < _e29) {
        let _e33 = global_3.member.member_2;
        let _e36 = global_3.member.member_3;
        let _e39 = global_3.member.member_4;
        let _e42 = global_3.member.member_5;
        let _e45 = global_4.member[_e42];
        phi_74_ = 0u;
        phi_77_ = _e39;
        phi_79_ = type_14(_e45.x, _e45.y, _e45.z, _e45.w);
        phi_81_ = _e26;
        loop {
            let _e52 = phi_74_;
            let _e54 = phi_77_;
            let _e56 = phi_79_;
            let _e58 = phi_81_;
            local = _e56;
            local_1 = _e56;
            local_2 = _e56;
            if (_e52 < _e36) {
                let _e62 = global_4.member[_e54];
                let _e65 = global_5.member[_e58];
                local_3 = (_e52 + 1u);
                local_4 = (_e54 + 1u);
                local_5 = type_14(((_e65 * _e62.x) + _e56.member), ((_e65 * _e62.y) + _e56.member_1), ((_e65 * _e62.z) + _e56.member_2), ((_e65 * _e62.w) + _e56.member_3));
                local_6 = (_e58 + _e33);
                continue;
            } else {
                break;
            }
            continuing {
                let _e134 = local_3;
                phi_74_ = _e134;
                let _e137 = local_4;
                phi_77_ = _e137;
                let _e140 = local_5;
                phi_79_ = _e140;
                let _e143 = local_6;
                phi_81_ = _e143;
            }
        }
        let _e88 = global_3.member.member_1;
        let _e90 = ((_e88 + _e26) * 3u);
        let _e92 = local;
        let _e94 = (_e92.member < 0f);
        let _e97 = exp(select(-(_e92.member), _e92.member, _e94));
        let _e99 = (1f / (1f + _e97));
        global_6.member[_e90] = select(_e99, (_e97 * _e99), _e94);
        let _e106 = local_1;
        let _e108 = (_e106.member_1 < 0f);
        let _e111 = exp(select(-(_e106.member_1), _e106.member_1, _e108));
        let _e113 = (1f / (1f + _e111));
        global_6.member[(_e90 + 1u)] = select(_e113, (_e111 * _e113), _e108);
        let _e120 = local_2;
        let _e122 = (_e120.member_2 < 0f);
        let _e125 = exp(select(-(_e120.member_2), _e120.member_2, _e122));
        let _e127 = (1f / (1f + _e125));
        global_6.member[(_e90 + 2u)] = select(_e127, (_e125 * _e127), _e122);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn color_head(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
