struct type_5 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_6 {
    member: type_5,
}

struct type_10 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_13 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_13;

fn function_() {
    var phi_80_: u32;
    var phi_83_: type_10;
    var phi_85_: type_10;
    var phi_87_: type_10;
    var local: type_10;
    var local_1: type_10;
    var local_2: type_10;
    var local_3: type_10;
    var local_4: type_10;
    var local_5: type_10;
    var local_6: type_10;
    var local_7: type_10;
    var local_8: type_10;
    var local_9: type_10;
    var local_10: type_10;
    var local_11: type_10;
    var local_12: u32;
    var local_13: type_10;
    var local_14: type_10;
    var local_15: type_10;

    let _e22 = global;
    let _e23 = global_1;
    let _e24 = global_2;
    let _e32 = (((_e23.x + (_e23.y * _e24.x)) * 64u) + _e22.x);
    let _e35 = global_3.member.member;
    if (_e32 < _e35) {
        let _e38 = (f32(_e32) * 0.00000023841858f);
        let _e41 = global_3.member.member_2;
        let _e44 = global_3.member.member_3;
        phi_80_ = 0u;
        phi_83_ = type_10((_e38 + 8f), (_e38 + 9f), (_e38 + 10f), (_e38 + 11f));
        phi_85_ = type_10((_e38 + 4f), (_e38 + 5f), (_e38 + 6f), (_e38 + 7f));
        phi_87_ = type_10(_e38, (_e38 + 1f), (_e38 + 2f), (_e38 + 3f));
        loop {
            let _e60 = phi_80_;
            let _e62 = phi_83_;
            let _e64 = phi_85_;
            let _e66 = phi_87_;
            let _e69 = global_3.member.member_1;
            local = _e66;
            local_1 = _e66;
            local_2 = _e66;
            local_3 = _e66;
            local_4 = _e64;
            local_5 = _e64;
            local_6 = _e64;
            local_7 = _e64;
            local_8 = _e62;
            local_9 = _e62;
            local_10 = _e62;
            local_11 = _e62;
            if (_e60 < _e69) {
                local_12 = (_e60 + 1u);
                local_13 = type_10(((((((((_e62.member * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e62.member_1 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e62.member_2 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e62.member_3 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44));
                local_14 = type_10(((((((((_e64.member * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e64.member_1 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e64.member_2 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e64.member_3 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44));
                local_15 = type_10(((((((((_e66.member * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e66.member_1 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e66.member_2 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44), ((((((((_e66.member_3 * _e41) + _e44) * _e41) + _e44) * _e41) + _e44) * _e41) + _e44));
                continue;
            } else {
                break;
            }
            continuing {
                let _e234 = local_12;
                phi_80_ = _e234;
                let _e237 = local_13;
                phi_83_ = _e237;
                let _e240 = local_14;
                phi_85_ = _e240;
                let _e243 = local_15;
                phi_87_ = _e243;
            }
        }
        let _e184 = local;
        let _e187 = local_1;
        let _e190 = local_2;
        let _e193 = local_3;
        let _e196 = local_4;
        let _e199 = local_5;
        let _e202 = local_6;
        let _e205 = local_7;
        let _e208 = local_8;
        let _e211 = local_9;
        let _e214 = local_10;
        let _e217 = local_11;
        global_4.member[_e32] = ((((_e184.member + _e187.member_1) + (_e190.member_2 + _e193.member_3)) + ((_e196.member + _e199.member_1) + (_e202.member_2 + _e205.member_3))) + ((_e208.member + _e211.member_1) + (_e214.member_2 + _e217.member_3)));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn peak_multiply_add(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
