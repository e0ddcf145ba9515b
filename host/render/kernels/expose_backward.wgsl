struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: type_10,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_5;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_69_: u32;
    var phi_72_: f32;
    var phi_73_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: u32;
    var local_3: f32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = global;
            let _e17 = global_1;
            let _e18 = global_2;
            let _e26 = (((_e17.x + (_e17.y * _e18.x)) * 64u) + _e16.x);
            let _e29 = global_3.member.member;
            let _e32 = global_3.member.member_1;
            if (_e26 < (_e29 * _e32)) {
                if (_e32 == 0u) {
                    break;
                }
                let _e40 = global_5.member[((_e26 / _e32) * 2u)];
                let _e41 = (_e26 * _e32);
                phi_69_ = _e41;
                phi_72_ = 0f;
                phi_73_ = 0f;
                loop {
                    let _e44 = phi_69_;
                    let _e46 = phi_72_;
                    let _e48 = phi_73_;
                    local = _e48;
                    local_1 = _e46;
                    if (_e44 < (_e41 + _e32)) {
                        let _e52 = global_6.member[_e44];
                        let _e55 = global_4.member[_e44];
                        global_6.member[_e44] = (_e52 * _e40);
                        local_2 = (_e44 + 1u);
                        local_3 = (_e46 + _e52);
                        local_4 = (_e48 + (_e52 * _e55));
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e73 = local_2;
                        phi_69_ = _e73;
                        let _e76 = local_3;
                        phi_72_ = _e76;
                        let _e79 = local_4;
                        phi_73_ = _e79;
                    }
                }
                let _e61 = (2u * _e26);
                let _e65 = local;
                global_7.member[_e61] = _e65;
                let _e70 = local_1;
                global_7.member[(_e61 + 1u)] = _e70;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn expose_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
