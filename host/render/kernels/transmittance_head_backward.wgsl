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
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_5;

fn function_() {
    var phi_79_: u32;
    var phi_82_: u32;
    var phi_84_: type_18;
    var phi_86_: u32;
    var local: type_18;
    var local_1: u32;
    var local_2: u32;
    var local_3: type_18;
    var local_4: u32;

    let _e21 = global;
    let _e22 = global_1;
    let _e23 = global_2;
    let _e31 = (((_e22.x + (_e22.y * _e23.x)) * 64u) + _e21.x);
    let _e34 = global_3.member.member;
    if (_e31 < _e34) {
        let _e38 = global_3.member.member_2;
        let _e41 = global_3.member.member_3;
        let _e44 = global_3.member.member_4;
        let _e47 = global_3.member.member_5;
        let _e50 = global_4.member[_e47];
        phi_79_ = 0u;
        phi_82_ = _e44;
        phi_84_ = type_18(_e50.x, _e50.y, _e50.z, _e50.w);
        phi_86_ = _e31;
        loop {
            let _e57 = phi_79_;
            let _e59 = phi_82_;
            let _e61 = phi_84_;
            let _e63 = phi_86_;
            local = _e61;
            if (_e57 < _e41) {
                let _e67 = global_4.member[_e59];
                let _e70 = global_6.member[_e63];
                local_1 = (_e57 + 1u);
                local_2 = (_e59 + 1u);
                local_3 = type_18(((_e70 * _e67.x) + _e61.member), ((_e70 * _e67.y) + _e61.member_1), ((_e70 * _e67.z) + _e61.member_2), ((_e70 * _e67.w) + _e61.member_3));
                local_4 = (_e63 + _e38);
                continue;
            } else {
                break;
            }
            continuing {
                let _e116 = local_1;
                phi_79_ = _e116;
                let _e119 = local_2;
                phi_82_ = _e119;
                let _e122 = local_3;
                phi_84_ = _e122;
                let _e125 = local_4;
                phi_86_ = _e125;
            }
        }
        let _e92 = local;
        let _e98 = global_5.member[((6u * _e38) + _e31)];
        let _e101 = global_7.member[_e31];
        let _e103 = -(_e92.member);
        let _e104 = (_e103 < 0f);
        let _e106 = exp(select(_e92.member, _e103, _e104));
        let _e108 = (1f / (1f + _e106));
        global_8.member[_e31] = ((_e101 * _e98) * select(_e108, (_e106 * _e108), _e104));
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
