struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<i32>,
}

struct type_13 {
    member: i32,
    member_1: bool,
}

struct type_14 {
    member: u32,
    member_1: i32,
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
var<storage> global_6: type_11;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_11;

fn function_() {
    var phi_87_: type_13;
    var phi_113_: i32;
    var phi_115_: i32;
    var phi_119_: type_13;
    var phi_155_: type_14;
    var phi_173_: type_14;
    var phi_190_: type_14;
    var phi_207_: type_14;
    var phi_224_: type_14;
    var phi_242_: type_14;
    var phi_259_: type_14;
    var phi_276_: type_14;
    var phi_293_: type_14;
    var phi_321_: type_14;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global;
            let _e26 = global_1;
            let _e27 = global_2;
            let _e35 = (((_e26.x + (_e26.y * _e27.x)) * 64u) + _e25.x);
            let _e38 = global_3.member.member;
            if (_e35 < _e38) {
                let _e42 = global_4.member[_e35];
                let _e45 = global_5.member[_e35];
                let _e48 = global_6.member[_e35];
                let _e49 = (_e45 == -1i);
                let _e50 = select(false, true, _e49);
                if _e50 {
                    phi_87_ = type_13(0i, (_e42 == i32(-2147483648)));
                } else {
                    if (_e45 == 0i) {
                        break;
                    }
                    if (_e49 && (_e42 == i32(-2147483648))) {
                        break;
                    }
                    phi_87_ = type_13((_e42 - (_e45 * (_e42 / _e45))), false);
                }
                let _e61 = phi_87_;
                global_7.member[_e35] = _e61.member;
                let _e65 = (_e35 + _e38);
                if _e50 {
                    phi_119_ = type_13(0i, (_e42 == i32(-2147483648)));
                } else {
                    if (_e45 == 0i) {
                        break;
                    }
                    if (_e49 && (_e42 == i32(-2147483648))) {
                        break;
                    }
                    let _e71 = (_e42 - (_e45 * (_e42 / _e45)));
                    if (_e71 < 0i) {
                        if (_e45 < 0i) {
                            phi_113_ = (0i - _e45);
                        } else {
                            phi_113_ = _e45;
                        }
                        let _e76 = phi_113_;
                        phi_115_ = (_e71 + _e76);
                    } else {
                        phi_115_ = _e71;
                    }
                    let _e79 = phi_115_;
                    phi_119_ = type_13(_e79, false);
                }
                let _e84 = phi_119_;
                global_7.member[_e65] = _e84.member;
                let _e88 = (_e65 + _e38);
                global_7.member[_e88] = (_e42 - (3i * (_e42 / 3i)));
                let _e94 = (_e88 + _e38);
                global_7.member[_e94] = (_e42 - (-4i * (_e42 / -4i)));
                let _e100 = (_e94 + _e38);
                global_7.member[_e100] = (_e42 - (768i * (_e42 / 768i)));
                let _e106 = (_e100 + _e38);
                let _e108 = (_e42 >> bitcast<u32>(2i));
                global_7.member[_e106] = (_e108 - (5i * (_e108 / 5i)));
                let _e114 = (_e106 + _e38);
                let _e115 = (_e42 + _e48);
                let _e116 = (_e48 < 0i);
                let _e119 = (_e116 == (_e115 >= _e42));
                if select(false, true, _e119) {
                    phi_155_ = type_14(0u, type_14().member_1);
                } else {
                    phi_155_ = type_14(1u, _e115);
                }
                let _e126 = phi_155_;
                global_7.member[_e114] = select(-77i, _e126.member_1, (bitcast<i32>(_e126.member) != 0i));
                let _e134 = (_e114 + _e38);
                let _e135 = (_e42 - _e48);
                let _e138 = (_e116 == (_e135 <= _e42));
                if select(false, true, _e138) {
                    phi_173_ = type_14(0u, type_14().member_1);
                } else {
                    phi_173_ = type_14(1u, _e135);
                }
                let _e145 = phi_173_;
                global_7.member[_e134] = select(-77i, _e145.member_1, (bitcast<i32>(_e145.member) != 0i));
                let _e153 = (_e134 + _e38);
                if select(false, true, (false == (_e42 >= _e42))) {
                    phi_190_ = type_14(0u, type_14().member_1);
                } else {
                    phi_190_ = type_14(1u, _e42);
                }
                let _e163 = phi_190_;
                global_7.member[_e153] = select(-77i, _e163.member_1, (bitcast<i32>(_e163.member) != 0i));
                let _e171 = (_e153 + _e38);
                if select(false, true, (false == (_e42 <= _e42))) {
                    phi_207_ = type_14(0u, type_14().member_1);
                } else {
                    phi_207_ = type_14(1u, _e42);
                }
                let _e181 = phi_207_;
                global_7.member[_e171] = select(-77i, _e181.member_1, (bitcast<i32>(_e181.member) != 0i));
                let _e189 = (_e171 + _e38);
                if select(false, true, (_e116 == (_e48 >= 0i))) {
                    phi_224_ = type_14(0u, type_14().member_1);
                } else {
                    phi_224_ = type_14(1u, _e48);
                }
                let _e199 = phi_224_;
                global_7.member[_e189] = select(-77i, _e199.member_1, (bitcast<i32>(_e199.member) != 0i));
                let _e207 = (_e189 + _e38);
                let _e208 = (0i - _e48);
                if select(false, true, (_e116 == (_e208 <= 0i))) {
                    phi_242_ = type_14(0u, type_14().member_1);
                } else {
                    phi_242_ = type_14(1u, _e208);
                }
                let _e218 = phi_242_;
                global_7.member[_e207] = select(-77i, _e218.member_1, (bitcast<i32>(_e218.member) != 0i));
                let _e226 = (_e207 + _e38);
                let _e227 = (_e42 + 5i);
                if select(false, true, (false == (_e227 > _e42))) {
                    phi_259_ = type_14(0u, type_14().member_1);
                } else {
                    phi_259_ = type_14(1u, _e227);
                }
                let _e236 = phi_259_;
                global_7.member[_e226] = select(-77i, _e236.member_1, (bitcast<i32>(_e236.member) != 0i));
                let _e244 = (_e226 + _e38);
                let _e245 = (_e42 - i32(-2147483648));
                if select(false, true, (true == (_e245 < _e42))) {
                    phi_276_ = type_14(0u, type_14().member_1);
                } else {
                    phi_276_ = type_14(1u, _e245);
                }
                let _e254 = phi_276_;
                global_7.member[_e244] = select(-77i, _e254.member_1, (bitcast<i32>(_e254.member) != 0i));
                let _e262 = (_e244 + _e38);
                if select(false, true, (_e116 == (_e42 >= _e135))) {
                    phi_293_ = type_14(0u, type_14().member_1);
                } else {
                    phi_293_ = type_14(1u, _e42);
                }
                let _e272 = phi_293_;
                global_7.member[_e262] = select(-77i, _e272.member_1, (bitcast<i32>(_e272.member) != 0i));
                let _e280 = (_e262 + _e38);
                global_7.member[_e280] = select(0i, 1i, _e119);
                let _e284 = (_e280 + _e38);
                global_7.member[_e284] = select(0i, 1i, _e138);
                let _e290 = bitcast<i32>(bitcast<u32>(_e48));
                let _e291 = (_e42 + _e290);
                let _e292 = (_e290 < 0i);
                if select(false, true, ((_e292 == (_e291 >= _e42)) != _e292)) {
                    phi_321_ = type_14(0u, type_14().member_1);
                } else {
                    phi_321_ = type_14(1u, _e291);
                }
                let _e303 = phi_321_;
                global_7.member[(_e284 + _e38)] = select(0i, 1i, !((bitcast<i32>(_e303.member) == 1i)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn signed(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
