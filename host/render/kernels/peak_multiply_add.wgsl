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
    var phi_85_: u32;
    var phi_88_: type_10;
    var phi_90_: type_10;
    var phi_92_: type_10;
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

    let _e17 = global;
    let _e18 = global_1;
    let _e19 = global_2;
    let _e27 = (((_e18.x + (_e18.y * _e19.x)) * 64u) + _e17.x);
    let _e30 = global_3.member.member;
    if (_e27 < _e30) {
        let _e34 = ((f32(_e27) + 0f) * 0.00000023841858f);
        let _e37 = global_3.member.member_2;
        let _e40 = global_3.member.member_3;
        phi_85_ = 0u;
        phi_88_ = type_10((_e34 + (0f + 8f)), (_e34 + (1f + 8f)), (_e34 + (2f + 8f)), (_e34 + (3f + 8f)));
        phi_90_ = type_10((_e34 + (0f + 4f)), (_e34 + (1f + 4f)), (_e34 + (2f + 4f)), (_e34 + (3f + 4f)));
        phi_92_ = type_10((_e34 + 0f), (_e34 + 1f), (_e34 + 2f), (_e34 + 3f));
        loop {
            let _e65 = phi_85_;
            let _e67 = phi_88_;
            let _e69 = phi_90_;
            let _e71 = phi_92_;
            let _e74 = global_3.member.member_1;
            local = _e71;
            local_1 = _e71;
            local_2 = _e71;
            local_3 = _e71;
            local_4 = _e69;
            local_5 = _e69;
            local_6 = _e69;
            local_7 = _e69;
            local_8 = _e67;
            local_9 = _e67;
            local_10 = _e67;
            local_11 = _e67;
            if (_e65 < _e74) {
                local_12 = (_e65 + 1u);
                local_13 = type_10(((((((((_e67.member * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e67.member_1 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e67.member_2 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e67.member_3 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40));
                local_14 = type_10(((((((((_e69.member * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e69.member_1 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e69.member_2 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e69.member_3 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40));
                local_15 = type_10(((((((((_e71.member * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e71.member_1 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e71.member_2 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40), ((((((((_e71.member_3 * _e37) + _e40) * _e37) + _e40) * _e37) + _e40) * _e37) + _e40));
                continue;
            } else {
                break;
            }
            continuing {
                let _e239 = local_12;
                phi_85_ = _e239;
                let _e242 = local_13;
                phi_88_ = _e242;
                let _e245 = local_14;
                phi_90_ = _e245;
                let _e248 = local_15;
                phi_92_ = _e248;
            }
        }
        let _e189 = local;
        let _e192 = local_1;
        let _e195 = local_2;
        let _e198 = local_3;
        let _e201 = local_4;
        let _e204 = local_5;
        let _e207 = local_6;
        let _e210 = local_7;
        let _e213 = local_8;
        let _e216 = local_9;
        let _e219 = local_10;
        let _e222 = local_11;
        global_4.member[_e27] = ((((_e189.member + _e192.member_1) + (_e195.member_2 + _e198.member_3)) + ((_e201.member + _e204.member_1) + (_e207.member_2 + _e210.member_3))) + ((_e213.member + _e216.member_1) + (_e219.member_2 + _e222.member_3)));
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
