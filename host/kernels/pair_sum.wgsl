struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
    member: type_14,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_15;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_74_: u32;
    var phi_77_: f32;
    var phi_79_: u32;
    var phi_109_: f32;
    var phi_75_: u32;
    var phi_78_: f32;
    var phi_80_: u32;
    var local: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = global;
            let _e20 = global_1;
            let _e21 = global_2;
            let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
            let _e32 = global_3.member.member_2;
            let _e35 = global_3.member.member_3;
            if (_e29 < (_e32 * _e35)) {
                let _e38 = (_e35 == 0u);
                if _e38 {
                    break;
                }
                let _e39 = (_e29 / _e35);
                if _e38 {
                    break;
                }
                phi_74_ = 0u;
                phi_77_ = 0f;
                phi_79_ = (_e39 / 32u);
                loop {
                    let _e44 = phi_74_;
                    let _e46 = phi_77_;
                    let _e48 = phi_79_;
                    local = _e46;
                    let _e51 = global_3.member.member_1;
                    let _e52 = (_e44 < _e51);
                    if _e52 {
                        let _e55 = global_4.member[_e48];
                        let _e56 = ((_e39 % 32u) & 31u);
                        if (((_e55 >> bitcast<u32>(_e56)) & 1u) == 0u) {
                            phi_109_ = _e46;
                        } else {
                            let _e63 = global_5.member[_e48];
                            let _e74 = global_6.member[(((_e63 + countOneBits((_e55 & ((1u << bitcast<u32>(_e56)) - 1u)))) * _e35) + (_e29 % _e35))];
                            phi_109_ = (_e46 + _e74);
                        }
                        let _e77 = phi_109_;
                        let _e80 = global_3.member.member;
                        phi_75_ = (_e44 + 1u);
                        phi_78_ = _e77;
                        phi_80_ = (_e48 + _e80);
                    } else {
                        phi_75_ = u32();
                        phi_78_ = f32();
                        phi_80_ = u32();
                    }
                    let _e84 = phi_75_;
                    let _e86 = phi_78_;
                    let _e88 = phi_80_;
                    continue;
                    continuing {
                        phi_74_ = _e84;
                        phi_77_ = _e86;
                        phi_79_ = _e88;
                        break if !(_e52);
                    }
                }
                let _e92 = global_7.member[_e29];
                let _e94 = local;
                global_7.member[_e29] = (_e92 + _e94);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pair_sum(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
