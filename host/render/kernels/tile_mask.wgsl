struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<i32>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(2) 
var<storage> global_5: type_17;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_21;

fn function_() {
    var phi_94_: u32;
    var phi_97_: u32;
    var phi_128_: bool;
    var phi_135_: u32;
    var phi_98_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;

    let _e19 = global;
    let _e20 = global_1;
    let _e21 = global_2;
    let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
    let _e32 = global_3.member.member_1;
    if (_e29 < _e32) {
        let _e35 = (_e20.z * 4u);
        let _e38 = global_4.member[_e35];
        let _e43 = global_4.member[(_e35 + 1u)];
        let _e47 = global_4.member[(_e35 + 2u)];
        let _e48 = f32(_e43);
        let _e49 = f32(_e47);
        let _e52 = global_3.member.member_2;
        let _e53 = f32(_e52);
        let _e56 = global_3.member.member;
        phi_94_ = 0u;
        phi_97_ = 0u;
        loop {
            let _e59 = phi_94_;
            let _e61 = phi_97_;
            local = _e61;
            local_1 = _e61;
            if (_e59 < 32u) {
                let _e64 = ((_e29 * 32u) + _e59);
                if (_e64 < _e56) {
                    let _e70 = global_5.member[(2u * ((bitcast<u32>(_e38) * _e56) + _e64))];
                    let _e75 = ((_e70.z * 1.001f) + 0.01f);
                    if (_e70.z >= 0f) {
                        let _e77 = (_e48 + _e53);
                        let _e79 = select(_e48, _e70.x, (_e70.x > _e48));
                        let _e82 = (_e70.x - select(_e77, _e79, (_e79 < _e77)));
                        let _e83 = (_e49 + _e53);
                        let _e85 = select(_e49, _e70.y, (_e70.y > _e49));
                        let _e88 = (_e70.y - select(_e83, _e85, (_e85 < _e83)));
                        phi_128_ = (((_e82 * _e82) + (_e88 * _e88)) <= (_e75 * _e75));
                    } else {
                        phi_128_ = false;
                    }
                    let _e95 = phi_128_;
                    if _e95 {
                        phi_135_ = (_e61 | (1u << bitcast<u32>((_e59 & 31u))));
                    } else {
                        phi_135_ = _e61;
                    }
                    let _e101 = phi_135_;
                    phi_98_ = _e101;
                } else {
                    phi_98_ = _e61;
                }
                let _e103 = phi_98_;
                local_2 = (_e59 + 1u);
                local_3 = _e103;
                continue;
            } else {
                break;
            }
            continuing {
                let _e118 = local_2;
                phi_94_ = _e118;
                let _e121 = local_3;
                phi_97_ = _e121;
            }
        }
        let _e106 = ((_e20.z * _e32) + _e29);
        let _e110 = local;
        global_6.member[_e106] = _e110;
        let _e112 = local_1;
        global_7.member[_e106] = countOneBits(_e112);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn tile_mask(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
