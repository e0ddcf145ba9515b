struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_17;

fn function_() {
    var phi_70_: u32;
    var phi_73_: array<u32, 2>;
    var local: array<u32, 2>;
    var local_1: array<u32, 2>;
    var phi_115_: u32;
    var phi_117_: array<u32, 2>;
    var phi_125_: f32;
    var phi_128_: u32;
    var phi_131_: f32;
    var phi_162_: f32;
    var local_2: u32;
    var local_3: array<u32, 2>;
    var local_4: array<u32, 2>;
    var local_5: u32;
    var local_6: u32;
    var local_7: f32;
    var local_8: f32;

    let _e20 = global;
    let _e21 = global_1;
    let _e22 = global_2;
    let _e30 = (((_e21.x + (_e21.y * _e22.x)) * 64u) + _e20.x);
    let _e33 = global_3.member.member;
    if (_e30 < _e33) {
        phi_70_ = 0u;
        phi_73_ = array<u32, 2>(0u, 0u);
        loop {
            let _e36 = phi_70_;
            let _e38 = phi_73_;
            local = _e38;
            local_1 = _e38;
            local_4 = _e38;
            local_5 = _e36;
            if (_e36 < 16u) {
                let _e42 = (2u * ((_e36 * _e33) + _e30));
                let _e45 = global_4.member[_e42];
                let _e47 = (_e45 + _e38[0]);
                let _e53 = global_4.member[(_e42 + 1u)];
                let _e56 = ((_e53 + _e38[1]) + select(0u, 1u, (_e47 < _e45)));
                global_4.member[_e42] = (_e47 & 65535u);
                global_4.member[(_e42 + 1u)] = 0u;
                local_2 = (_e36 + 1u);
                local_3 = array<u32, 2>(((_e47 >> bitcast<u32>(16u)) | (_e56 << bitcast<u32>(16u))), bitcast<u32>((bitcast<i32>(_e56) >> bitcast<u32>(16u))));
                continue;
            } else {
                break;
            }
            continuing {
                let _e143 = local_2;
                phi_70_ = _e143;
                let _e146 = local_3;
                phi_73_ = _e146;
            }
        }
        let _e70 = local;
        let _e72 = (_e70[1] >= 2147483648u);
        if _e72 {
            let _e74 = local_1;
            let _e77 = (~(_e74[0]) + 1u);
            if (_e77 == 0u) {
                phi_115_ = (~(_e70[1]) + 1u);
            } else {
                phi_115_ = ~(_e70[1]);
            }
            let _e83 = phi_115_;
            phi_117_ = array<u32, 2>(_e77, _e83);
        } else {
            let _e152 = local_4;
            phi_117_ = _e152;
        }
        let _e86 = phi_117_;
        let _e92 = ((f32(_e86[1]) * 4294967300f) + f32(_e86[0]));
        if _e72 {
            phi_125_ = -(_e92);
        } else {
            phi_125_ = _e92;
        }
        let _e95 = phi_125_;
        let _e156 = local_5;
        phi_128_ = _e156;
        phi_131_ = (_e95 * bitcast<f32>(1954545664u));
        loop {
            let _e99 = phi_128_;
            let _e101 = phi_131_;
            local_8 = _e101;
            if (_e99 > 0u) {
                let _e103 = (_e99 - 1u);
                let _e113 = bitcast<f32>((bitcast<u32>(((8i * bitcast<i32>(_e103)) + 52i)) << bitcast<u32>(23i)));
                let _e116 = global_4.member[(2u * ((_e103 * _e33) + _e30))];
                global_4.member[(2u * ((_e103 * _e33) + _e30))] = 0u;
                local_6 = _e103;
                local_7 = (_e101 + ((f32(_e116) * _e113) * _e113));
                continue;
            } else {
                break;
            }
            continuing {
                let _e158 = local_6;
                phi_128_ = _e158;
                let _e161 = local_7;
                phi_131_ = _e161;
            }
        }
        let _e123 = (2u * ((16u * _e33) + _e30));
        let _e126 = global_4.member[_e123];
        let _e130 = global_4.member[(_e123 + 1u)];
        let _e131 = (_e126 | _e130);
        global_4.member[_e123] = 0u;
        global_4.member[(_e123 + 1u)] = 0u;
        if (_e131 == 0u) {
            let _e164 = local_8;
            phi_162_ = _e164;
        } else {
            phi_162_ = bitcast<f32>((_e131 | 2143289344u));
        }
        let _e136 = phi_162_;
        let _e139 = global_5.member[_e30];
        global_5.member[_e30] = (_e139 + _e136);
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
