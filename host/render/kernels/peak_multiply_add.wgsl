struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_13 {
    member: type_12,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_13;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_5;

fn function_() {
    var phi_82_: u32;
    var phi_85_: type_11;
    var phi_87_: type_11;
    var phi_89_: type_11;
    var local: type_11;
    var local_1: type_11;
    var local_2: type_11;
    var local_3: type_11;
    var local_4: type_11;
    var local_5: type_11;
    var local_6: type_11;
    var local_7: type_11;
    var local_8: type_11;
    var local_9: type_11;
    var local_10: type_11;
    var local_11: type_11;
    var local_12: u32;
    var local_13: type_11;
    var local_14: type_11;
    var local_15: type_11;

    let _e24 = global;
    let _e25 = global_1;
    let _e26 = global_2;
    let _e34 = (((_e25.x + (_e25.y * _e26.x)) * 64u) + _e24.x);
    let _e37 = global_3.member.member;
    if (_e34 < _e37) {
        let _e40 = (f32(_e34) * 0.00000023841858f);
        let _e43 = global_3.member.member_2;
        let _e46 = global_3.member.member_3;
        phi_82_ = 0u;
        phi_85_ = type_11((_e40 + 8f), (_e40 + 9f), (_e40 + 10f), (_e40 + 11f));
        phi_87_ = type_11((_e40 + 4f), (_e40 + 5f), (_e40 + 6f), (_e40 + 7f));
        phi_89_ = type_11(_e40, (_e40 + 1f), (_e40 + 2f), (_e40 + 3f));
        loop {
            let _e62 = phi_82_;
            let _e64 = phi_85_;
            let _e66 = phi_87_;
            let _e68 = phi_89_;
            let _e71 = global_3.member.member_1;
            local = _e68;
            local_1 = _e68;
            local_2 = _e68;
            local_3 = _e68;
            local_4 = _e66;
            local_5 = _e66;
            local_6 = _e66;
            local_7 = _e66;
            local_8 = _e64;
            local_9 = _e64;
            local_10 = _e64;
            local_11 = _e64;
            if (_e62 < _e71) {
                local_12 = (_e62 + 1u);
                local_13 = type_11(((((((((_e64.member * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e64.member_1 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e64.member_2 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e64.member_3 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46));
                local_14 = type_11(((((((((_e66.member * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e66.member_1 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e66.member_2 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e66.member_3 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46));
                local_15 = type_11(((((((((_e68.member * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e68.member_1 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e68.member_2 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46), ((((((((_e68.member_3 * _e43) + _e46) * _e43) + _e46) * _e43) + _e46) * _e43) + _e46));
                continue;
            } else {
                break;
            }
            continuing {
                let _e236 = local_12;
                phi_82_ = _e236;
                let _e239 = local_13;
                phi_85_ = _e239;
                let _e242 = local_14;
                phi_87_ = _e242;
                let _e245 = local_15;
                phi_89_ = _e245;
            }
        }
        let _e186 = local;
        let _e189 = local_1;
        let _e192 = local_2;
        let _e195 = local_3;
        let _e198 = local_4;
        let _e201 = local_5;
        let _e204 = local_6;
        let _e207 = local_7;
        let _e210 = local_8;
        let _e213 = local_9;
        let _e216 = local_10;
        let _e219 = local_11;
        global_4.member[_e34] = ((((_e186.member + _e189.member_1) + (_e192.member_2 + _e195.member_3)) + ((_e198.member + _e201.member_1) + (_e204.member_2 + _e207.member_3))) + ((_e210.member + _e213.member_1) + (_e216.member_2 + _e219.member_3)));
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
