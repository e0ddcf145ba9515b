struct type_6 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
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
var<storage, read_write> global_4: type_6;
@group(0) @binding(1) 
var<storage> global_5: type_6;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_6;
var<workgroup> global_7: array<u32, 64>;

fn function_() {
    var phi_50_: u32;
    var phi_53_: u32;
    var phi_54_: u32;
    var local: u32;
    var phi_70_: u32;
    var phi_73_: u32;
    var phi_74_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_88_: u32;
    var phi_91_: u32;
    var phi_92_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e17 = global;
    let _e18 = global_1;
    let _e19 = global_2;
    let _e25 = (_e18.x + (_e18.y * _e19.x));
    let _e28 = (((_e25 * 64u) + _e17.x) * 16u);
    phi_50_ = 0u;
    phi_53_ = 0u;
    loop {
        let _e30 = phi_50_;
        let _e32 = phi_53_;
        local = _e32;
        local_7 = _e32;
        local_2 = _e32;
        if (_e30 < 16u) {
            let _e34 = (_e28 + _e30);
            let _e37 = global_3.member.member;
            if (_e34 < _e37) {
                let _e41 = global_5.member[_e34];
                phi_54_ = (_e32 + _e41);
            } else {
                phi_54_ = _e32;
            }
            let _e44 = phi_54_;
            local_4 = (_e30 + 1u);
            local_5 = _e44;
            continue;
        } else {
            break;
        }
        continuing {
            let _e99 = local_4;
            phi_50_ = _e99;
            let _e102 = local_5;
            phi_53_ = _e102;
        }
    }
    let _e48 = local;
    global_7[_e17.x] = _e48;
    workgroupBarrier();
    phi_70_ = 1u;
    let _e110 = local_7;
    phi_73_ = _e110;
    loop {
        let _e50 = phi_70_;
        let _e52 = phi_73_;
        local_1 = _e52;
        local_3 = _e52;
        if (_e50 < 64u) {
            if (_e17.x >= _e50) {
                let _e57 = global_7[(_e17.x - _e50)];
                phi_74_ = (_e52 + _e57);
            } else {
                phi_74_ = _e52;
            }
            let _e60 = phi_74_;
            workgroupBarrier();
            global_7[_e17.x] = _e60;
            workgroupBarrier();
            local_6 = (_e50 * 2u);
            local_8 = _e60;
            continue;
        } else {
            break;
        }
        continuing {
            let _e107 = local_6;
            phi_70_ = _e107;
            let _e112 = local_8;
            phi_73_ = _e112;
        }
    }
    let _e63 = local_1;
    let _e65 = local_2;
    phi_88_ = 0u;
    phi_91_ = (_e63 - _e65);
    loop {
        let _e68 = phi_88_;
        let _e70 = phi_91_;
        if (_e68 < 16u) {
            let _e72 = (_e28 + _e68);
            let _e75 = global_3.member.member;
            if (_e72 <= _e75) {
                global_4.member[_e72] = _e70;
            }
            if (_e72 < _e75) {
                let _e82 = global_5.member[_e72];
                phi_92_ = (_e70 + _e82);
            } else {
                phi_92_ = _e70;
            }
            let _e85 = phi_92_;
            local_9 = (_e68 + 1u);
            local_10 = _e85;
            continue;
        } else {
            break;
        }
        continuing {
            let _e118 = local_9;
            phi_88_ = _e118;
            let _e121 = local_10;
            phi_91_ = _e121;
        }
    }
    if (_e17.x == 63u) {
        let _e91 = global_3.member.member;
        if ((_e25 * 1024u) <= _e91) {
            let _e96 = local_3;
            global_6.member[_e25] = _e96;
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
