struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
}

struct type_15 {
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
var<storage> global_5: type_11;
@group(0) @binding(3) 
var<storage, read_write> global_6: type_15;

fn function_() {
    var phi_142_: bool;
    var phi_151_: bool;
    var phi_162_: bool;

    let _e15 = global;
    let _e16 = global_1;
    let _e17 = global_2;
    let _e25 = (((_e16.x + (_e16.y * _e17.x)) * 64u) + _e15.x);
    let _e28 = global_3.member.member;
    if (_e25 < _e28) {
        let _e32 = global_4.member[_e25];
        let _e35 = global_5.member[_e25];
        let _e41 = ((bitcast<u32>(_e32) & 2147483647u) > 2139095040u);
        let _e49 = (_e32 < _e35);
        let _e51 = (_e32 > _e35);
        let _e53 = (_e32 <= _e35);
        let _e55 = (_e32 >= _e35);
        global_6.member[_e25] = select(0u, 1u, _e49);
        let _e60 = (_e25 + _e28);
        global_6.member[_e60] = select(0u, 1u, _e51);
        let _e64 = (_e60 + _e28);
        global_6.member[_e64] = select(0u, 1u, _e53);
        let _e68 = (_e64 + _e28);
        global_6.member[_e68] = select(0u, 1u, _e55);
        let _e72 = (_e68 + _e28);
        global_6.member[_e72] = select(0u, 1u, (_e32 == _e35));
        let _e77 = (_e72 + _e28);
        global_6.member[_e77] = select(0u, 1u, !((_e32 == _e35)));
        let _e83 = (_e77 + _e28);
        global_6.member[_e83] = select(0u, 1u, !((_e32 == 1f)));
        let _e89 = (_e83 + _e28);
        global_6.member[_e89] = select(0u, 1u, !(_e49));
        let _e93 = (_e89 + _e28);
        global_6.member[_e93] = select(0u, 1u, !(_e51));
        let _e97 = (_e93 + _e28);
        global_6.member[_e97] = select(0u, 1u, !(_e53));
        let _e101 = (_e97 + _e28);
        global_6.member[_e101] = select(0u, 1u, !(_e55));
        let _e105 = (_e101 + _e28);
        global_6.member[_e105] = select(0u, 1u, ((bitcast<u32>(_e32) & 2147483647u) <= 2139095040u));
        let _e109 = (_e105 + _e28);
        let _e110 = select(0u, 1u, _e41);
        global_6.member[_e109] = _e110;
        let _e113 = (_e109 + _e28);
        global_6.member[_e113] = select(0u, 1u, ((bitcast<u32>(_e32) & 2147483647u) <= 2139095040u));
        let _e117 = (_e113 + _e28);
        global_6.member[_e117] = select(0u, 1u, !(((bitcast<u32>(_e32) & 2147483647u) <= 2139095040u)));
        let _e121 = (_e117 + _e28);
        global_6.member[_e121] = _e110;
        let _e124 = (_e121 + _e28);
        global_6.member[_e124] = select(0u, 1u, ((bitcast<u32>((_e32 * 2f)) & 2147483647u) > 2139095040u));
        let _e132 = (_e124 + _e28);
        if _e41 {
            phi_142_ = true;
        } else {
            phi_142_ = (_e35 >= _e32);
        }
        let _e135 = phi_142_;
        global_6.member[_e132] = bitcast<u32>(select(_e32, _e35, _e135));
        let _e140 = (_e132 + _e28);
        if _e41 {
            phi_151_ = true;
        } else {
            phi_151_ = (_e35 <= _e32);
        }
        let _e143 = phi_151_;
        global_6.member[_e140] = bitcast<u32>(select(_e32, _e35, _e143));
        if _e49 {
            phi_162_ = true;
        } else {
            phi_162_ = ((bitcast<u32>(_e35) & 2147483647u) > 2139095040u);
        }
        let _e153 = phi_162_;
        global_6.member[(_e140 + _e28)] = bitcast<u32>(select(_e35, _e32, _e153));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn compared(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
