struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_10;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_10;
@group(0) @binding(1) 
var<storage> global_6: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_87_: u32;
    var phi_89_: array<u32, 2>;
    var phi_97_: f32;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 256u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < _e28) {
        let _e33 = global_4.member[(_e25 / 64u)];
        if (_e33 == 0u) {
        } else {
            let _e35 = (2u * _e25);
            let _e38 = global_5.member[_e35];
            let _e42 = global_5.member[(_e35 + 1u)];
            global_5.member[_e35] = 0u;
            global_5.member[(_e35 + 1u)] = 0u;
            let _e44 = (_e42 >= 2147483648u);
            if _e44 {
                let _e46 = (~(_e38) + 1u);
                if (_e46 == 0u) {
                    phi_87_ = (~(_e42) + 1u);
                } else {
                    phi_87_ = ~(_e42);
                }
                let _e52 = phi_87_;
                phi_89_ = array<u32, 2>(_e46, _e52);
            } else {
                phi_89_ = array<u32, 2>(_e38, _e42);
            }
            let _e55 = phi_89_;
            let _e61 = ((f32(_e55[1]) * 4294967300f) + f32(_e55[0]));
            if _e44 {
                phi_97_ = -(_e61);
            } else {
                phi_97_ = _e61;
            }
            let _e64 = phi_97_;
            let _e67 = global_6.member[1u];
            let _e71 = global_7.member[_e25];
            global_7.member[_e25] = (_e71 + (_e64 * _e67));
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn hash_grid_gradient(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
