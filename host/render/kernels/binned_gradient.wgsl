struct type_6 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_16 {
    member: u32,
}

struct type_17 {
    member: type_16,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_17;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_6;
@group(0) @binding(1) 
var<storage, read_write> global_5: type_12;

fn function_() {
    var phi_73_: u32;
    var phi_76_: array<u32, 2>;
    var local: array<u32, 2>;
    var local_1: array<u32, 2>;
    var phi_118_: u32;
    var phi_120_: array<u32, 2>;
    var phi_128_: f32;
    var phi_130_: u32;
    var phi_133_: f32;
    var phi_164_: f32;
    var local_2: u32;
    var local_3: array<u32, 2>;
    var local_4: array<u32, 2>;
    var local_5: u32;
    var local_6: u32;
    var local_7: f32;
    var local_8: f32;

    let _e23 = global;
    let _e24 = global_1;
    let _e25 = global_2;
    let _e33 = (((_e24.x + (_e24.y * _e25.x)) * 64u) + _e23.x);
    let _e36 = global_3.member.member;
    if (_e33 < _e36) {
        phi_73_ = 0u;
        phi_76_ = array<u32, 2>(0u, 0u);
        loop {
            let _e39 = phi_73_;
            let _e41 = phi_76_;
            local = _e41;
            local_1 = _e41;
            local_4 = _e41;
            local_5 = _e39;
            if (_e39 < 16u) {
                let _e45 = (2u * ((_e39 * _e36) + _e33));
                let _e48 = global_5.member[_e45];
                let _e50 = (_e48 + _e41[0]);
                let _e56 = global_5.member[(_e45 + 1u)];
                let _e59 = ((_e56 + _e41[1]) + select(0u, 1u, (_e50 < _e48)));
                global_5.member[_e45] = (_e50 & 65535u);
                global_5.member[(_e45 + 1u)] = 0u;
                local_2 = (_e39 + 1u);
                local_3 = array<u32, 2>(((_e50 >> bitcast<u32>(16u)) | (_e59 << bitcast<u32>(16u))), bitcast<u32>((bitcast<i32>(_e59) >> bitcast<u32>(16u))));
                continue;
            } else {
                break;
            }
            continuing {
                let _e145 = local_2;
                phi_73_ = _e145;
                let _e148 = local_3;
                phi_76_ = _e148;
            }
        }
        let _e73 = local;
        let _e75 = (_e73[1] >= 2147483648u);
        if _e75 {
            let _e77 = local_1;
            let _e80 = (~(_e77[0]) + 1u);
            if (_e80 == 0u) {
                phi_118_ = (~(_e73[1]) + 1u);
            } else {
                phi_118_ = ~(_e73[1]);
            }
            let _e86 = phi_118_;
            phi_120_ = array<u32, 2>(_e80, _e86);
        } else {
            let _e154 = local_4;
            phi_120_ = _e154;
        }
        let _e89 = phi_120_;
        let _e95 = ((f32(_e89[1]) * 4294967300f) + f32(_e89[0]));
        if _e75 {
            phi_128_ = -(_e95);
        } else {
            phi_128_ = _e95;
        }
        let _e98 = phi_128_;
        let _e158 = local_5;
        phi_130_ = _e158;
        phi_133_ = (_e98 * 81129640000000000000000000000000f);
        loop {
            let _e101 = phi_130_;
            let _e103 = phi_133_;
            local_8 = _e103;
            if (_e101 > 0u) {
                let _e105 = (_e101 - 1u);
                let _e115 = bitcast<f32>((bitcast<u32>(((8i * bitcast<i32>(_e105)) + 52i)) << bitcast<u32>(23i)));
                let _e118 = global_5.member[(2u * ((_e105 * _e36) + _e33))];
                global_5.member[(2u * ((_e105 * _e36) + _e33))] = 0u;
                local_6 = _e105;
                local_7 = (_e103 + ((f32(_e118) * _e115) * _e115));
                continue;
            } else {
                break;
            }
            continuing {
                let _e160 = local_6;
                phi_130_ = _e160;
                let _e163 = local_7;
                phi_133_ = _e163;
            }
        }
        let _e125 = (2u * ((16u * _e36) + _e33));
        let _e128 = global_5.member[_e125];
        let _e132 = global_5.member[(_e125 + 1u)];
        let _e133 = (_e128 | _e132);
        global_5.member[_e125] = 0u;
        global_5.member[(_e125 + 1u)] = 0u;
        if (_e133 == 0u) {
            let _e166 = local_8;
            phi_164_ = _e166;
        } else {
            phi_164_ = bitcast<f32>((_e133 | 2143289344u));
        }
        let _e138 = phi_164_;
        let _e141 = global_4.member[_e33];
        global_4.member[_e33] = (_e141 + _e138);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn binned_gradient(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
