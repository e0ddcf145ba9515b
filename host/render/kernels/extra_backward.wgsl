struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_15;
@group(0) @binding(2) 
var<storage> global_6: type_15;

fn function_() {
    var phi_95_: u32;
    var phi_98_: f32;
    var phi_105_: u32;
    var phi_108_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: u32;
    var local_4: f32;

    let _e16 = global;
    let _e17 = global_1;
    let _e18 = global_2;
    let _e26 = (((_e17.x + (_e17.y * _e18.x)) * 64u) + _e16.x);
    let _e29 = global_3.member.member;
    if (_e26 < _e29) {
        let _e33 = global_3.member.member_1;
        let _e34 = (_e33 + _e26);
        let _e37 = global_3.member.member_3;
        let _e40 = global_3.member.member_2;
        let _e43 = global_4.member[_e34];
        let _e47 = global_4.member[(_e34 + 1u)];
        let _e50 = (_e37 + _e40);
        let _e52 = select(_e50, _e47, (_e47 < _e50));
        let _e60 = global_3.member.member_6;
        let _e64 = global_3.member.member_4;
        let _e65 = ((_e60 + _e17.z) * _e64);
        let _e68 = global_3.member.member_5;
        let _e73 = global_5.member[((_e34 * _e68) + _e17.z)];
        let _e75 = (_e65 + (select(_e37, _e52, (_e52 > _e37)) - _e37));
        phi_95_ = (_e65 + (select(_e37, _e43, (_e43 > _e37)) - _e37));
        phi_98_ = _e73;
        loop {
            let _e77 = phi_95_;
            let _e79 = phi_98_;
            let _e80 = (_e77 + 1u);
            local_3 = _e77;
            local = _e79;
            if (_e80 <= _e75) {
                let _e84 = global_6.member[_e77];
                local_2 = (_e79 + _e84);
                continue;
            } else {
                break;
            }
            continuing {
                phi_95_ = _e80;
                let _e104 = local_2;
                phi_98_ = _e104;
            }
        }
        let _e107 = local_3;
        phi_105_ = _e107;
        phi_108_ = 0f;
        loop {
            let _e87 = phi_105_;
            let _e89 = phi_108_;
            let _e90 = (_e87 + 1u);
            local_1 = _e89;
            if (_e90 <= _e75) {
                let _e94 = global_6.member[_e87];
                local_4 = (_e89 + _e94);
                continue;
            } else {
                break;
            }
            continuing {
                phi_105_ = _e90;
                let _e110 = local_4;
                phi_108_ = _e110;
            }
        }
        let _e97 = local;
        let _e99 = local_1;
        global_5.member[((_e34 * _e68) + _e17.z)] = (_e97 + _e99);
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
