enable subgroups;

struct type_5 {
    member: u32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
var<private> global_3: u32;
@group(0) @binding(0) 
var<uniform> global_4: type_6;
@group(0) @binding(1) 
var<storage> global_5: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_6: type_11;

fn function_() {
    var phi_52_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e13 = global;
            let _e14 = global_1;
            let _e15 = global_2;
            let _e16 = global_3;
            let _e24 = (((_e14.x + (_e14.y * _e15.x)) * 96u) + _e13.x);
            let _e27 = global_4.member.member;
            let _e28 = (_e24 < _e27);
            if _e28 {
                let _e31 = global_5.member[_e24];
                phi_52_ = _e31;
            } else {
                phi_52_ = 0u;
            }
            let _e33 = phi_52_;
            let _e34 = subgroupAdd(1u);
            if (_e34 == 0u) {
                break;
            }
            let _e37 = ((_e16 + 1u) % _e34);
            let _e38 = subgroupExclusiveAdd(1u);
            let _e39 = subgroupInclusiveAdd(_e33);
            let _e41 = subgroupShuffle(_e39, (_e34 - 1u));
            let _e42 = subgroupAdd(_e33);
            let _e43 = subgroupShuffle(_e16, _e37);
            let _e44 = subgroupShuffleXor(_e16, 1u);
            if _e28 {
                global_6.member[_e24] = (_e38 - _e16);
                global_6.member[(_e27 + _e24)] = (_e41 - _e42);
                global_6.member[((2u * _e27) + _e24)] = (_e43 - _e37);
                global_6.member[((3u * _e27) + _e24)] = (_e44 - (_e16 ^ 1u));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(96, 1, 1) 
fn scan_and_shuffle(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>, @builtin(subgroup_invocation_id) param_3: u32) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    global_3 = param_3;
    function_();
}
