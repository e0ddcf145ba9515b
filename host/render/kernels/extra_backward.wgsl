struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_11;
@group(0) @binding(0) 
var<uniform> global_4: type_15;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_5;

fn function_() {
    var phi_97_: u32;
    var phi_100_: f32;
    var phi_107_: u32;
    var phi_110_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: u32;
    var local_4: f32;

    let _e18 = global;
    let _e19 = global_1;
    let _e20 = global_2;
    let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
    let _e31 = global_4.member.member;
    if (_e28 < _e31) {
        let _e35 = global_4.member.member_1;
        let _e36 = (_e35 + _e28);
        let _e39 = global_4.member.member_3;
        let _e42 = global_4.member.member_2;
        let _e45 = global_3.member[_e36];
        let _e49 = global_3.member[(_e36 + 1u)];
        let _e52 = (_e39 + _e42);
        let _e54 = select(_e52, _e49, (_e49 < _e52));
        let _e62 = global_4.member.member_6;
        let _e66 = global_4.member.member_4;
        let _e67 = ((_e62 + _e19.z) * _e66);
        let _e70 = global_4.member.member_5;
        let _e75 = global_6.member[((_e36 * _e70) + _e19.z)];
        let _e77 = (_e67 + (select(_e39, _e54, (_e54 > _e39)) - _e39));
        phi_97_ = (_e67 + (select(_e39, _e45, (_e45 > _e39)) - _e39));
        phi_100_ = _e75;
        loop {
            let _e79 = phi_97_;
            let _e81 = phi_100_;
            let _e82 = (_e79 + 1u);
            local_3 = _e79;
            local = _e81;
            if (_e82 <= _e77) {
                let _e86 = global_5.member[_e79];
                local_2 = (_e81 + _e86);
                continue;
            } else {
                break;
            }
            continuing {
                phi_97_ = _e82;
                let _e106 = local_2;
                phi_100_ = _e106;
            }
        }
        let _e109 = local_3;
        phi_107_ = _e109;
        phi_110_ = 0f;
        loop {
            let _e89 = phi_107_;
            let _e91 = phi_110_;
            let _e92 = (_e89 + 1u);
            local_1 = _e91;
            if (_e92 <= _e77) {
                let _e96 = global_5.member[_e89];
                local_4 = (_e91 + _e96);
                continue;
            } else {
                break;
            }
            continuing {
                phi_107_ = _e92;
                let _e112 = local_4;
                phi_110_ = _e112;
            }
        }
        let _e99 = local;
        let _e101 = local_1;
        global_6.member[((_e36 * _e70) + _e19.z)] = (_e99 + _e101);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn extra_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
