struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<i32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(1) 
var<storage> global_5: type_15;
@group(0) @binding(4) 
var<storage> global_6: type_10;
@group(0) @binding(5) 
var<storage> global_7: type_10;
@group(0) @binding(3) 
var<storage> global_8: type_10;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_10;

fn function_() {
    var phi_75_: i32;
    var phi_78_: u32;
    var phi_79_: u32;
    var local: i32;
    var local_1: u32;

    let _e18 = global;
    let _e19 = global_1;
    let _e20 = global_2;
    let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
    let _e31 = global_3.member.member;
    if (_e28 < _e31) {
        let _e35 = ((_e19.z * _e31) + _e28);
        let _e38 = global_4.member[_e35];
        let _e42 = global_5.member[(_e19.z * 4u)];
        let _e45 = ((bitcast<u32>(_e42) * _e31) + _e28);
        let _e48 = global_6.member[_e45];
        let _e51 = global_7.member[_e45];
        let _e54 = global_8.member[_e35];
        phi_75_ = 0i;
        phi_78_ = _e54;
        loop {
            let _e56 = phi_75_;
            let _e58 = phi_78_;
            if (_e56 < 32i) {
                let _e60 = (_e56 & 31i);
                if (((_e38 >> bitcast<u32>(_e60)) & 1u) == 0u) {
                    phi_79_ = _e58;
                } else {
                    global_9.member[_e58] = (_e51 + countOneBits((_e48 & ((1u << bitcast<u32>(_e60)) - 1u))));
                    phi_79_ = (_e58 + 1u);
                }
                let _e75 = phi_79_;
                local = (_e56 + 1i);
                local_1 = _e75;
                continue;
            } else {
                break;
            }
            continuing {
                let _e79 = local;
                phi_75_ = _e79;
                let _e82 = local_1;
                phi_78_ = _e82;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_fill(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
