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
    var phi_141_: bool;
    var phi_150_: bool;
    var phi_161_: bool;

    let _e14 = global;
    let _e15 = global_1;
    let _e16 = global_2;
    let _e24 = (((_e15.x + (_e15.y * _e16.x)) * 64u) + _e14.x);
    let _e27 = global_3.member.member;
    if (_e24 < _e27) {
        let _e31 = global_4.member[_e24];
        let _e34 = global_5.member[_e24];
        let _e40 = ((bitcast<u32>(_e31) & 2147483647u) > 2139095040u);
        let _e48 = (_e31 < _e34);
        let _e50 = (_e31 > _e34);
        let _e52 = (_e31 <= _e34);
        let _e54 = (_e31 >= _e34);
        global_6.member[_e24] = select(0u, 1u, _e48);
        let _e59 = (_e24 + _e27);
        global_6.member[_e59] = select(0u, 1u, _e50);
        let _e63 = (_e59 + _e27);
        global_6.member[_e63] = select(0u, 1u, _e52);
        let _e67 = (_e63 + _e27);
        global_6.member[_e67] = select(0u, 1u, _e54);
        let _e71 = (_e67 + _e27);
        global_6.member[_e71] = select(0u, 1u, (_e31 == _e34));
        let _e76 = (_e71 + _e27);
        global_6.member[_e76] = select(0u, 1u, !((_e31 == _e34)));
        let _e82 = (_e76 + _e27);
        global_6.member[_e82] = select(0u, 1u, !((_e31 == 1f)));
        let _e88 = (_e82 + _e27);
        global_6.member[_e88] = select(0u, 1u, !(_e48));
        let _e92 = (_e88 + _e27);
        global_6.member[_e92] = select(0u, 1u, !(_e50));
        let _e96 = (_e92 + _e27);
        global_6.member[_e96] = select(0u, 1u, !(_e52));
        let _e100 = (_e96 + _e27);
        global_6.member[_e100] = select(0u, 1u, !(_e54));
        let _e104 = (_e100 + _e27);
        global_6.member[_e104] = select(0u, 1u, ((bitcast<u32>(_e31) & 2147483647u) <= 2139095040u));
        let _e108 = (_e104 + _e27);
        let _e109 = select(0u, 1u, _e40);
        global_6.member[_e108] = _e109;
        let _e112 = (_e108 + _e27);
        global_6.member[_e112] = select(0u, 1u, ((bitcast<u32>(_e31) & 2147483647u) <= 2139095040u));
        let _e116 = (_e112 + _e27);
        global_6.member[_e116] = select(0u, 1u, !(((bitcast<u32>(_e31) & 2147483647u) <= 2139095040u)));
        let _e120 = (_e116 + _e27);
        global_6.member[_e120] = _e109;
        let _e123 = (_e120 + _e27);
        global_6.member[_e123] = select(0u, 1u, ((bitcast<u32>((_e31 - _e31)) & 2147483647u) > 2139095040u));
        let _e131 = (_e123 + _e27);
        if _e40 {
            phi_141_ = true;
        } else {
            phi_141_ = (_e34 >= _e31);
        }
        let _e134 = phi_141_;
        global_6.member[_e131] = bitcast<u32>(select(_e31, _e34, _e134));
        let _e139 = (_e131 + _e27);
        if _e40 {
            phi_150_ = true;
        } else {
            phi_150_ = (_e34 <= _e31);
        }
        let _e142 = phi_150_;
        global_6.member[_e139] = bitcast<u32>(select(_e31, _e34, _e142));
        if _e48 {
            phi_161_ = true;
        } else {
            phi_161_ = ((bitcast<u32>(_e34) & 2147483647u) > 2139095040u);
        }
        let _e152 = phi_161_;
        global_6.member[(_e139 + _e27)] = bitcast<u32>(select(_e34, _e31, _e152));
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
