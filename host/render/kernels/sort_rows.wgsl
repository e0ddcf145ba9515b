struct type_4 {
    member: u32,
    member_1: u32,
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
var<storage, read_write> global_4: type_10;

fn function_() {
    var phi_45_: u32;
    var phi_47_: u32;
    var phi_55_: u32;
    var phi_63_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;

    let _e10 = global;
    let _e11 = global_1;
    let _e12 = global_2;
    let _e17 = (_e11.x + (_e11.y * _e12.x));
    let _e20 = global_3.member.member_1;
    let _e24 = global_3.member.member;
    if (_e17 < _e24) {
        phi_45_ = (_e20 / 2u);
    } else {
        phi_45_ = 0u;
    }
    let _e28 = phi_45_;
    phi_47_ = 2u;
    loop {
        let _e30 = phi_47_;
        if (_e30 <= _e20) {
            phi_55_ = (_e30 / 2u);
            loop {
                let _e34 = phi_55_;
                if (_e34 > 0u) {
                    phi_63_ = _e10.x;
                    loop {
                        let _e38 = phi_63_;
                        if (_e38 < _e28) {
                            let _e43 = ((2u * _e38) - (_e38 & (_e34 - 1u)));
                            let _e46 = ((_e17 * _e20) + _e43);
                            let _e50 = global_4.member[_e46];
                            let _e53 = global_4.member[(_e46 + _e34)];
                            if ((_e50 > _e53) == ((_e43 & _e30) == 0u)) {
                                global_4.member[_e46] = _e53;
                                global_4.member[(_e46 + _e34)] = _e50;
                            }
                            local_2 = (_e38 + 64u);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e68 = local_2;
                            phi_63_ = _e68;
                        }
                    }
                    storageBarrier();
                    workgroupBarrier();
                    local_1 = (_e34 / 2u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e65 = local_1;
                    phi_55_ = _e65;
                }
            }
            local = (_e30 * 2u);
            continue;
        } else {
            break;
        }
        continuing {
            let _e62 = local;
            phi_47_ = _e62;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sort_rows(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
