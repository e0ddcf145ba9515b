struct type_6 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_10 {
    member: type_9,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_10;
@group(0) @binding(2) 
var<storage> global_4: type_6;
@group(0) @binding(1) 
var<storage> global_5: type_6;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_6;

fn function_() {
    var phi_48_: u32;
    var phi_51_: u32;
    var phi_53_: u32;
    var phi_54_: u32;
    var phi_88_: u32;
    var phi_93_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e15 = global;
            let _e16 = global_1;
            let _e17 = global_2;
            if (((_e16.x + (_e16.y * _e17.x)) + _e15.x) == 0u) {
                phi_48_ = 0u;
                phi_51_ = 0u;
                phi_53_ = 0u;
                loop {
                    let _e27 = phi_48_;
                    let _e29 = phi_51_;
                    let _e31 = phi_53_;
                    let _e34 = global_3.member.member;
                    phi_93_ = false;
                    if (_e27 <= _e34) {
                        let _e38 = global_3.member.member_1;
                        let _e42 = global_5.member[(_e27 * _e38)];
                        let _e45 = global_3.member.member_3;
                        if (_e45 == 0u) {
                            phi_54_ = _e42;
                        } else {
                            let _e49 = global_4.member[_e42];
                            phi_54_ = _e49;
                        }
                        let _e51 = phi_54_;
                        let _e52 = (_e51 - _e31);
                        let _e55 = global_3.member.member_2;
                        let _e56 = (_e55 == 0u);
                        local_2 = _e51;
                        if _e56 {
                            phi_93_ = true;
                            break;
                        }
                        let _e57 = (_e52 / _e55);
                        if _e56 {
                            phi_93_ = true;
                            break;
                        }
                        if ((_e52 % _e55) > 0u) {
                            phi_88_ = (_e57 + 1u);
                        } else {
                            phi_88_ = _e57;
                        }
                        let _e62 = phi_88_;
                        let _e63 = (_e29 + _e62);
                        let _e64 = (2u * _e27);
                        global_6.member[_e64] = _e51;
                        global_6.member[(_e64 + 1u)] = _e63;
                        local = (_e27 + 1u);
                        local_1 = _e63;
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e75 = local;
                        phi_48_ = _e75;
                        let _e78 = local_1;
                        phi_51_ = _e78;
                        let _e81 = local_2;
                        phi_53_ = _e81;
                    }
                }
                let _e72 = phi_93_;
                if _e72 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(1, 1, 1) 
fn unit_begin(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
