struct type_5 {
    member: u32,
}

struct type_6 {
    member: type_5,
}

struct type_10 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_10;
var<workgroup> global_5: array<u32, 64>;
@group(0) @binding(2) 
var<storage, read_write> global_6: type_10;
@group(0) @binding(3) 
var<storage, read_write> global_7: type_10;

fn function_() {
    var phi_49_: u32;
    var phi_52_: u32;
    var phi_53_: u32;
    var local: u32;
    var phi_69_: u32;
    var phi_72_: u32;
    var phi_73_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_87_: u32;
    var phi_90_: u32;
    var phi_91_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e16 = global;
    let _e17 = global_1;
    let _e18 = global_2;
    let _e24 = (_e17.x + (_e17.y * _e18.x));
    let _e27 = (((_e24 * 64u) + _e16.x) * 16u);
    phi_49_ = 0u;
    phi_52_ = 0u;
    loop {
        let _e29 = phi_49_;
        let _e31 = phi_52_;
        local = _e31;
        local_7 = _e31;
        local_2 = _e31;
        if (_e29 < 16u) {
            let _e33 = (_e27 + _e29);
            let _e36 = global_3.member.member;
            if (_e33 < _e36) {
                let _e40 = global_4.member[_e33];
                phi_53_ = (_e31 + _e40);
            } else {
                phi_53_ = _e31;
            }
            let _e43 = phi_53_;
            local_4 = (_e29 + 1u);
            local_5 = _e43;
            continue;
        } else {
            break;
        }
        continuing {
            let _e98 = local_4;
            phi_49_ = _e98;
            let _e101 = local_5;
            phi_52_ = _e101;
        }
    }
    let _e47 = local;
    global_5[_e16.x] = _e47;
    workgroupBarrier();
    phi_69_ = 1u;
    let _e109 = local_7;
    phi_72_ = _e109;
    loop {
        let _e49 = phi_69_;
        let _e51 = phi_72_;
        local_1 = _e51;
        local_3 = _e51;
        if (_e49 < 64u) {
            if (_e16.x >= _e49) {
                let _e56 = global_5[(_e16.x - _e49)];
                phi_73_ = (_e51 + _e56);
            } else {
                phi_73_ = _e51;
            }
            let _e59 = phi_73_;
            workgroupBarrier();
            global_5[_e16.x] = _e59;
            workgroupBarrier();
            local_6 = (_e49 * 2u);
            local_8 = _e59;
            continue;
        } else {
            break;
        }
        continuing {
            let _e106 = local_6;
            phi_69_ = _e106;
            let _e111 = local_8;
            phi_72_ = _e111;
        }
    }
    let _e62 = local_1;
    let _e64 = local_2;
    phi_87_ = 0u;
    phi_90_ = (_e62 - _e64);
    loop {
        let _e67 = phi_87_;
        let _e69 = phi_90_;
        if (_e67 < 16u) {
            let _e71 = (_e27 + _e67);
            let _e74 = global_3.member.member;
            if (_e71 <= _e74) {
                global_6.member[_e71] = _e69;
            }
            if (_e71 < _e74) {
                let _e81 = global_4.member[_e71];
                phi_91_ = (_e69 + _e81);
            } else {
                phi_91_ = _e69;
            }
            let _e84 = phi_91_;
            local_9 = (_e67 + 1u);
            local_10 = _e84;
            continue;
        } else {
            break;
        }
        continuing {
            let _e117 = local_9;
            phi_87_ = _e117;
            let _e120 = local_10;
            phi_90_ = _e120;
        }
    }
    if (_e16.x == 63u) {
        let _e90 = global_3.member.member;
        if ((_e24 * 1024u) <= _e90) {
            let _e95 = local_3;
            global_7.member[_e24] = _e95;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_block(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
