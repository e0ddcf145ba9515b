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
    var phi_84_: f32;
    var phi_86_: f32;
    var phi_88_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;

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
            if (_e53 < (_e47 + _e50)) {
                let _e63 = global_3.member.member_1;
                let _e65 = ((_e53 * _e63) + (_e29 / 32u));
                let _e68 = global_5.member[_e65];
                if ((_e68 & _e38) == 0u) {
                    phi_84_ = _e55;
                    phi_86_ = _e57;
                    phi_88_ = _e59;
                } else {
                    let _e76 = global_6.member[_e65];
                    let _e81 = global_7.member[(3u * (_e76 + countOneBits((_e68 & (_e38 - 1u)))))];
                    let _e95 = global_4.member[(2u * ((_e53 * _e32) + _e29))];
                    phi_84_ = select(_e95.z, _e55, (_e55 > _e95.z));
                    phi_86_ = (_e57 + 1f);
                    phi_88_ = (_e59 + sqrt(((_e81.x * _e81.x) + (_e81.y * _e81.y))));
                }
                let _e100 = phi_84_;
                let _e102 = phi_86_;
                let _e104 = phi_88_;
                local_4 = (_e53 + 1u);
                local_5 = _e100;
                local_6 = _e102;
                local_7 = _e104;
                continue;
            } else {
                break;
            }
            continuing {
                let _e119 = local_4;
                phi_80_ = _e119;
                let _e122 = local_5;
                phi_83_ = _e122;
                let _e125 = local_6;
                phi_85_ = _e125;
                let _e128 = local_7;
                phi_87_ = _e128;
            }
        }
        let _e107 = local;
        if (_e107 > _e41.y) {
            let _e111 = local_1;
            let _e113 = local_2;
            let _e115 = local_3;
            global_8.member[_e29] = vec4<f32>(_e111, _e113, _e115, _e41.w);
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
