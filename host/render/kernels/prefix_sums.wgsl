struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_10;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_10;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_10;

fn function_() {
    var phi_50_: u32;
    var phi_53_: u32;
    var phi_72_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;

    let _e12 = global;
    let _e13 = global_1;
    let _e14 = global_2;
    let _e22 = (((_e13.x + (_e13.y * _e14.x)) * 64u) + _e12.x);
    let _e25 = global_3.member.member;
    let _e26 = (_e22 < _e25);
    if _e26 {
        let _e29 = global_4.member[_e22];
        global_5.member[_e22] = _e29;
    }
    storageBarrier();
    workgroupBarrier();
    phi_50_ = 1u;
    phi_53_ = 0u;
    loop {
        let _e33 = phi_50_;
        let _e35 = phi_53_;
        local = _e35;
        if (_e33 < 64u) {
            let _e37 = (_e25 - _e35);
            local_2 = _e37;
            if _e26 {
                let _e38 = (_e35 + _e22);
                let _e41 = global_5.member[_e38];
                if (_e12.x >= _e33) {
                    let _e46 = global_5.member[(_e38 - _e33)];
                    phi_72_ = (_e41 + _e46);
                } else {
                    phi_72_ = _e41;
                }
                let _e49 = phi_72_;
                global_5.member[(_e37 + _e22)] = _e49;
            }
            storageBarrier();
            workgroupBarrier();
            local_1 = (_e33 * 2u);
            continue;
        } else {
            break;
        }
        continuing {
            let _e64 = local_1;
            phi_50_ = _e64;
            let _e67 = local_2;
            phi_53_ = _e67;
        }
    }
    if _e26 {
        let _e55 = local;
        let _e59 = global_5.member[(_e55 + _e22)];
        global_6.member[_e22] = _e59;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn prefix_sums(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
