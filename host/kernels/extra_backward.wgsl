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
    var phi_92_: f32;
    var phi_95_: u32;
    var phi_93_: f32;
    var phi_107_: f32;
    var phi_110_: u32;
    var phi_108_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;

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
        let _e69 = (_e67 + (select(_e39, _e54, (_e54 > _e39)) - _e39));
        phi_92_ = 0f;
        phi_95_ = (_e67 + (select(_e39, _e45, (_e45 > _e39)) - _e39));
        loop {
            let _e71 = phi_92_;
            let _e73 = phi_95_;
            local_2 = _e73;
            local = _e71;
            let _e74 = (_e73 + 1u);
            let _e75 = (_e74 <= _e69);
            if _e75 {
                let _e78 = global_5.member[_e73];
                phi_93_ = (_e71 + _e78);
            } else {
                phi_93_ = f32();
            }
            let _e81 = phi_93_;
            continue;
            continuing {
                phi_92_ = _e81;
                phi_95_ = select(u32(), _e74, _e75);
                break if !(_e75);
            }
        }
        phi_107_ = 0f;
        let _e118 = local_2;
        phi_110_ = _e118;
        loop {
            let _e85 = phi_107_;
            let _e87 = phi_110_;
            local_1 = _e85;
            let _e88 = (_e87 + 1u);
            let _e89 = (_e88 <= _e69);
            if _e89 {
                let _e92 = global_5.member[_e87];
                phi_108_ = (_e85 + _e92);
            } else {
                phi_108_ = f32();
            }
            let _e95 = phi_108_;
            continue;
            continuing {
                phi_107_ = _e95;
                phi_110_ = select(u32(), _e88, _e89);
                break if !(_e89);
            }
        }
        let _e100 = global_4.member.member_5;
        let _e105 = global_6.member[((_e36 * _e100) + _e19.z)];
        let _e107 = local;
        let _e109 = local_1;
        global_6.member[((_e36 * _e100) + _e19.z)] = (_e105 + (_e107 + _e109));
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
