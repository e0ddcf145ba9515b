struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_11 {
    member: type_10,
}

struct type_15 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_11;
@group(0) @binding(1) 
var<storage> global_4: type_15;
@group(0) @binding(2) 
var<storage> global_5: type_7;
@group(0) @binding(3) 
var<storage> global_6: type_7;
@group(0) @binding(4) 
var<storage> global_7: type_15;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_15;

fn function_() {
    var phi_80_: u32;
    var phi_83_: f32;
    var phi_85_: f32;
    var phi_87_: f32;
    var phi_126_: f32;
    var phi_127_: f32;
    var phi_128_: f32;
    var phi_81_: u32;
    var phi_84_: f32;
    var phi_86_: f32;
    var phi_88_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;

    let _e19 = global;
    let _e20 = global_1;
    let _e21 = global_2;
    let _e29 = (((_e20.x + (_e20.y * _e21.x)) * 64u) + _e19.x);
    let _e32 = global_3.member.member;
    if (_e29 < _e32) {
        let _e38 = (1u << bitcast<u32>(((_e29 % 32u) & 31u)));
        let _e41 = global_8.member[_e29];
        let _e47 = global_3.member.member_2;
        let _e50 = global_3.member.member_3;
        phi_80_ = _e47;
        phi_83_ = _e41.z;
        phi_85_ = _e41.y;
        phi_87_ = _e41.x;
        loop {
            let _e53 = phi_80_;
            let _e55 = phi_83_;
            let _e57 = phi_85_;
            let _e59 = phi_87_;
            local = _e57;
            local_1 = _e59;
            local_2 = _e57;
            local_3 = _e55;
            let _e60 = (_e53 < (_e47 + _e50));
            if _e60 {
                let _e63 = global_3.member.member_1;
                let _e65 = ((_e53 * _e63) + (_e29 / 32u));
                let _e68 = global_5.member[_e65];
                if ((_e68 & _e38) == 0u) {
                    phi_126_ = _e55;
                    phi_127_ = _e57;
                    phi_128_ = _e59;
                } else {
                    let _e76 = global_6.member[_e65];
                    let _e81 = global_7.member[(3u * (_e76 + countOneBits((_e68 & (_e38 - 1u)))))];
                    let _e95 = global_4.member[(2u * ((_e53 * _e32) + _e29))];
                    phi_126_ = select(_e95.z, _e55, (_e55 > _e95.z));
                    phi_127_ = (_e57 + 1f);
                    phi_128_ = (_e59 + sqrt(((_e81.x * _e81.x) + (_e81.y * _e81.y))));
                }
                let _e100 = phi_126_;
                let _e102 = phi_127_;
                let _e104 = phi_128_;
                phi_81_ = (_e53 + 1u);
                phi_84_ = _e100;
                phi_86_ = _e102;
                phi_88_ = _e104;
            } else {
                phi_81_ = u32();
                phi_84_ = f32();
                phi_86_ = f32();
                phi_88_ = f32();
            }
            let _e107 = phi_81_;
            let _e109 = phi_84_;
            let _e111 = phi_86_;
            let _e113 = phi_88_;
            continue;
            continuing {
                phi_80_ = _e107;
                phi_83_ = _e109;
                phi_85_ = _e111;
                phi_87_ = _e113;
                break if !(_e60);
            }
        }
        let _e116 = local;
        if (_e116 > _e41.y) {
            let _e120 = local_1;
            let _e122 = local_2;
            let _e124 = local_3;
            global_8.member[_e29] = vec4<f32>(_e120, _e122, _e124, _e41.w);
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
