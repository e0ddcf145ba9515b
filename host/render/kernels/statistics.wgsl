struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: array<u32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_12;
@group(0) @binding(2) 
var<storage> global_5: type_16;
@group(0) @binding(3) 
var<storage> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_12;
@group(0) @binding(1) 
var<storage> global_8: type_12;

fn function_() {
    var phi_81_: u32;
    var phi_84_: f32;
    var phi_86_: f32;
    var phi_88_: f32;
    var phi_85_: f32;
    var phi_87_: f32;
    var phi_89_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;

    let _e18 = global;
    let _e19 = global_1;
    let _e20 = global_2;
    let _e28 = (((_e19.x + (_e19.y * _e20.x)) * 64u) + _e18.x);
    let _e31 = global_3.member.member;
    if (_e28 < _e31) {
        let _e37 = (1u << bitcast<u32>(((_e28 % 32u) & 31u)));
        let _e40 = global_4.member[_e28];
        let _e46 = global_3.member.member_2;
        let _e49 = global_3.member.member_3;
        phi_81_ = _e46;
        phi_84_ = _e40.z;
        phi_86_ = _e40.y;
        phi_88_ = _e40.x;
        loop {
            let _e52 = phi_81_;
            let _e54 = phi_84_;
            let _e56 = phi_86_;
            let _e58 = phi_88_;
            local = _e56;
            local_1 = _e58;
            local_2 = _e56;
            local_3 = _e54;
            if (_e52 < (_e46 + _e49)) {
                let _e62 = global_3.member.member_1;
                let _e64 = ((_e52 * _e62) + (_e28 / 32u));
                let _e67 = global_5.member[_e64];
                if ((_e67 & _e37) == 0u) {
                    phi_85_ = _e54;
                    phi_87_ = _e56;
                    phi_89_ = _e58;
                } else {
                    let _e75 = global_6.member[_e64];
                    let _e80 = global_7.member[(3u * (_e75 + countOneBits((_e67 & (_e37 - 1u)))))];
                    let _e96 = global_8.member[(2u * ((_e52 * _e31) + _e28))];
                    phi_85_ = select(_e96.z, _e54, (_e54 > _e96.z));
                    phi_87_ = (_e56 + 1f);
                    phi_89_ = (_e58 + sqrt((((_e80.x * _e80.x) + (_e80.y * _e80.y)) + (0f * 0f))));
                }
                let _e101 = phi_85_;
                let _e103 = phi_87_;
                let _e105 = phi_89_;
                local_4 = (_e52 + 1u);
                local_5 = _e101;
                local_6 = _e103;
                local_7 = _e105;
                continue;
            } else {
                break;
            }
            continuing {
                let _e120 = local_4;
                phi_81_ = _e120;
                let _e123 = local_5;
                phi_84_ = _e123;
                let _e126 = local_6;
                phi_86_ = _e126;
                let _e129 = local_7;
                phi_88_ = _e129;
            }
        }
        let _e108 = local;
        if (_e108 > _e40.y) {
            let _e112 = local_1;
            let _e114 = local_2;
            let _e116 = local_3;
            global_4.member[_e28] = vec4<f32>(_e112, _e114, _e116, _e40.w);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn statistics(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
