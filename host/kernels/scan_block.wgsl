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
    var phi_71_: u32;
    var phi_51_: u32;
    var phi_54_: u32;
    var local: u32;
    var phi_75_: u32;
    var phi_78_: u32;
    var phi_94_: u32;
    var phi_76_: u32;
    var phi_79_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_98_: u32;
    var phi_101_: u32;
    var phi_124_: u32;
    var phi_99_: u32;
    var phi_102_: u32;
    var local_3: u32;
    var local_4: u32;

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
        local_4 = _e32;
        local_2 = _e32;
        let _e33 = (_e30 < 16u);
        if _e33 {
            let _e34 = (_e28 + _e30);
            let _e37 = global_3.member.member;
            if (_e34 < _e37) {
                let _e41 = global_5.member[_e34];
                phi_71_ = (_e32 + _e41);
            } else {
                phi_71_ = _e32;
            }
            let _e44 = phi_71_;
            phi_51_ = (_e30 + 1u);
            phi_54_ = _e44;
        } else {
            phi_51_ = u32();
            phi_54_ = u32();
        }
        let _e47 = phi_51_;
        let _e49 = phi_54_;
        continue;
        continuing {
            phi_50_ = _e47;
            phi_53_ = _e49;
            break if !(_e33);
        }
    }
    let _e53 = local;
    global_7[_e17.x] = _e53;
    workgroupBarrier();
    phi_75_ = 1u;
    let _e121 = local_4;
    phi_78_ = _e121;
    loop {
        let _e55 = phi_75_;
        let _e57 = phi_78_;
        local_1 = _e57;
        local_3 = _e57;
        let _e58 = (_e55 < 64u);
        if _e58 {
            if (_e17.x >= _e55) {
                let _e62 = global_7[(_e17.x - _e55)];
                phi_94_ = (_e57 + _e62);
            } else {
                phi_94_ = _e57;
            }
            let _e65 = phi_94_;
            workgroupBarrier();
            global_7[_e17.x] = _e65;
            workgroupBarrier();
            phi_76_ = (_e55 * 2u);
            phi_79_ = _e65;
        } else {
            phi_76_ = u32();
            phi_79_ = u32();
        }
        let _e68 = phi_76_;
        let _e70 = phi_79_;
        continue;
        continuing {
            phi_75_ = _e68;
            phi_78_ = _e70;
            break if !(_e58);
        }
    }
    let _e73 = local_1;
    let _e75 = local_2;
    phi_98_ = 0u;
    phi_101_ = (_e73 - _e75);
    loop {
        let _e78 = phi_98_;
        let _e80 = phi_101_;
        let _e81 = (_e78 < 16u);
        if _e81 {
            let _e82 = (_e28 + _e78);
            let _e85 = global_3.member.member;
            if (_e82 <= _e85) {
                global_4.member[_e82] = _e80;
            }
            if (_e82 < _e85) {
                let _e92 = global_5.member[_e82];
                phi_124_ = (_e80 + _e92);
            } else {
                phi_124_ = _e80;
            }
            let _e95 = phi_124_;
            phi_99_ = (_e78 + 1u);
            phi_102_ = _e95;
        } else {
            phi_99_ = u32();
            phi_102_ = u32();
        }
        let _e98 = phi_99_;
        let _e100 = phi_102_;
        continue;
        continuing {
            phi_98_ = _e98;
            phi_101_ = _e100;
            break if !(_e81);
        }
    }
    if (_e17.x == 63u) {
        let _e106 = global_3.member.member;
        if ((_e25 * 1024u) <= _e106) {
            let _e111 = local_3;
            global_6.member[_e25] = _e111;
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
