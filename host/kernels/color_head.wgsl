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
var<storage, read_write> global_6: type_5;

fn function_() {
    var phi_76_: u32;
    var phi_79_: u32;
    var phi_81_: type_18;
    var phi_83_: u32;
    var phi_77_: u32;
    var phi_80_: u32;
    var phi_82_: type_18;
    var phi_84_: u32;
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;

    let _e18 = global;
    let _e19 = global_1;
    let _e20 = global_2;
    let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
    let _e31 = global_3.member.member;
    if (_e28 < _e31) {
        let _e35 = global_3.member.member_2;
        let _e38 = global_3.member.member_3;
        let _e41 = global_3.member.member_4;
        let _e44 = global_3.member.member_5;
        let _e47 = global_4.member[_e44];
        phi_76_ = 0u;
        phi_79_ = _e41;
        phi_81_ = type_18(_e47.x, _e47.y, _e47.z, _e47.w);
        phi_83_ = _e28;
        loop {
            let _e54 = phi_76_;
            let _e56 = phi_79_;
            let _e58 = phi_81_;
            let _e60 = phi_83_;
            local = _e58;
            local_1 = _e58;
            local_2 = _e58;
            let _e61 = (_e54 < _e38);
            if _e61 {
                let _e64 = global_4.member[_e56];
                let _e67 = global_5.member[_e60];
                phi_77_ = (_e54 + 1u);
                phi_80_ = (_e56 + 1u);
                phi_82_ = type_18(((_e67 * _e64.x) + _e58.member), ((_e67 * _e64.y) + _e58.member_1), ((_e67 * _e64.z) + _e58.member_2), ((_e67 * _e64.w) + _e58.member_3));
                phi_84_ = (_e60 + _e35);
            } else {
                phi_77_ = u32();
                phi_80_ = u32();
                phi_82_ = type_18();
                phi_84_ = u32();
            }
            let _e89 = phi_77_;
            let _e91 = phi_80_;
            let _e93 = phi_82_;
            let _e95 = phi_84_;
            continue;
            continuing {
                phi_76_ = _e89;
                phi_79_ = _e91;
                phi_81_ = _e93;
                phi_83_ = _e95;
                break if !(_e61);
            }
        }
        let _e99 = global_3.member.member_1;
        let _e101 = ((_e99 + _e28) * 3u);
        let _e103 = local;
        let _e105 = (_e103.member < 0f);
        let _e108 = exp(select(-(_e103.member), _e103.member, _e105));
        let _e110 = (1f / (1f + _e108));
        global_6.member[_e101] = select(_e110, (_e108 * _e110), _e105);
        let _e117 = local_1;
        let _e119 = (_e117.member_1 < 0f);
        let _e122 = exp(select(-(_e117.member_1), _e117.member_1, _e119));
        let _e124 = (1f / (1f + _e122));
        global_6.member[(_e101 + 1u)] = select(_e124, (_e122 * _e124), _e119);
        let _e131 = local_2;
        let _e133 = (_e131.member_2 < 0f);
        let _e136 = exp(select(-(_e131.member_2), _e131.member_2, _e133));
        let _e138 = (1f / (1f + _e136));
        global_6.member[(_e101 + 2u)] = select(_e138, (_e136 * _e138), _e133);
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
