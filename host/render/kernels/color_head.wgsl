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
    var local: type_18;
    var local_1: type_18;
    var local_2: type_18;
    var local_3: u32;
    var local_4: u32;
    var local_5: type_18;
    var local_6: u32;

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
            if (_e54 < _e38) {
                let _e64 = global_4.member[_e56];
                let _e67 = global_5.member[_e60];
                local_3 = (_e54 + 1u);
                local_4 = (_e56 + 1u);
                local_5 = type_18(((_e67 * _e64.x) + _e58.member), ((_e67 * _e64.y) + _e58.member_1), ((_e67 * _e64.z) + _e58.member_2), ((_e67 * _e64.w) + _e58.member_3));
                local_6 = (_e60 + _e35);
                continue;
            } else {
                break;
            }
            continuing {
                let _e136 = local_3;
                phi_76_ = _e136;
                let _e139 = local_4;
                phi_79_ = _e139;
                let _e142 = local_5;
                phi_81_ = _e142;
                let _e145 = local_6;
                phi_83_ = _e145;
            }
        }
        let _e90 = global_3.member.member_1;
        let _e92 = ((_e90 + _e28) * 3u);
        let _e94 = local;
        let _e96 = (_e94.member < 0f);
        let _e99 = exp(select(-(_e94.member), _e94.member, _e96));
        let _e101 = (1f / (1f + _e99));
        global_6.member[_e92] = select(_e101, (_e99 * _e101), _e96);
        let _e108 = local_1;
        let _e110 = (_e108.member_1 < 0f);
        let _e113 = exp(select(-(_e108.member_1), _e108.member_1, _e110));
        let _e115 = (1f / (1f + _e113));
        global_6.member[(_e92 + 1u)] = select(_e115, (_e113 * _e115), _e110);
        let _e122 = local_2;
        let _e124 = (_e122.member_2 < 0f);
        let _e127 = exp(select(-(_e122.member_2), _e122.member_2, _e124));
        let _e129 = (1f / (1f + _e127));
        global_6.member[(_e92 + 2u)] = select(_e129, (_e127 * _e129), _e124);
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
