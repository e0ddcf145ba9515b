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
    var phi_78_: u32;
    var phi_81_: f32;
    var phi_83_: f32;
    var phi_85_: f32;
    var phi_82_: f32;
    var phi_84_: f32;
    var phi_86_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: u32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;

    let _e17 = global;
    let _e18 = global_1;
    let _e19 = global_2;
    let _e27 = (((_e18.x + (_e18.y * _e19.x)) * 64u) + _e17.x);
    let _e30 = global_3.member.member;
    if (_e27 < _e30) {
        let _e36 = (1u << bitcast<u32>(((_e27 % 32u) & 31u)));
        let _e39 = global_4.member[_e27];
        let _e45 = global_3.member.member_2;
        let _e48 = global_3.member.member_3;
        phi_78_ = _e45;
        phi_81_ = _e39.z;
        phi_83_ = _e39.y;
        phi_85_ = _e39.x;
        loop {
            let _e51 = phi_78_;
            let _e53 = phi_81_;
            let _e55 = phi_83_;
            let _e57 = phi_85_;
            local = _e55;
            local_1 = _e57;
            local_2 = _e55;
            local_3 = _e53;
            if (_e51 < (_e45 + _e48)) {
                let _e61 = global_3.member.member_1;
                let _e63 = ((_e51 * _e61) + (_e27 / 32u));
                let _e66 = global_5.member[_e63];
                if ((_e66 & _e36) == 0u) {
                    phi_82_ = _e53;
                    phi_84_ = _e55;
                    phi_86_ = _e57;
                } else {
                    let _e74 = global_6.member[_e63];
                    let _e79 = global_7.member[(3u * (_e74 + countOneBits((_e66 & (_e36 - 1u)))))];
                    let _e93 = global_8.member[(2u * ((_e51 * _e30) + _e27))];
                    phi_82_ = select(_e93.z, _e53, (_e53 > _e93.z));
                    phi_84_ = (_e55 + 1f);
                    phi_86_ = (_e57 + sqrt(((_e79.x * _e79.x) + (_e79.y * _e79.y))));
                }
                let _e98 = phi_82_;
                let _e100 = phi_84_;
                let _e102 = phi_86_;
                local_4 = (_e51 + 1u);
                local_5 = _e98;
                local_6 = _e100;
                local_7 = _e102;
                continue;
            } else {
                break;
            }
            continuing {
                let _e117 = local_4;
                phi_78_ = _e117;
                let _e120 = local_5;
                phi_81_ = _e120;
                let _e123 = local_6;
                phi_83_ = _e123;
                let _e126 = local_7;
                phi_85_ = _e126;
            }
        }
        let _e105 = local;
        if (_e105 > _e39.y) {
            let _e109 = local_1;
            let _e111 = local_2;
            let _e113 = local_3;
            global_4.member[_e27] = vec4<f32>(_e109, _e111, _e113, _e39.w);
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
