struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
}

struct type_5 {
    member: type_4,
}

struct type_9 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_12 {
    member: array<type_9>,
}

struct type_16 {
    member: array<f32>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_16;
@group(0) @binding(2) 
var<storage> global_6: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_16;

fn function_() {
    var phi_301_: array<u32, 8>;
    var phi_333_: u32;
    var phi_336_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = global;
            let _e25 = global_1;
            let _e26 = global_2;
            let _e32 = ((_e25.x + (_e25.y * _e26.x)) * 64u);
            let _e37 = global_3.member.member;
            if ((_e32 + _e24.x) < _e37) {
                let _e42 = global_4.member[_e25.z];
                let _e45 = global_3.member.member_1;
                let _e48 = global_3.member.member_5;
                let _e51 = global_3.member.member_4;
                let _e52 = (_e51 == 0u);
                if _e52 {
                    break;
                }
                let _e53 = (_e32 / _e51);
                let _e57 = (_e32 - (_e53 * _e51));
                let _e59 = (((_e53 * (_e48 * _e45)) + _e57) + _e24.x);
                let _e62 = global_5.member[_e59];
                let _e63 = (3u * _e45);
                let _e67 = global_5.member[(_e59 + _e63)];
                let _e68 = (_e45 + _e59);
                let _e71 = global_5.member[_e68];
                let _e75 = global_5.member[(_e68 + _e63)];
                let _e77 = ((2u * _e45) + _e59);
                let _e80 = global_5.member[_e77];
                let _e84 = global_5.member[(_e77 + _e63)];
                let _e87 = global_3.member.member_3;
                let _e88 = (_e62 + _e67);
                let _e91 = select(false, (_e88 < 1f), (0f < _e88));
                let _e94 = select(select(0f, 1f, (1f <= _e88)), _e62, _e91);
                let _e97 = (_e94 * _e42.member);
                let _e100 = (_e42.member + _e42.member_1);
                let _e104 = trunc(_e97);
                let _e106 = ((_e97 - _e104) + (((_e94 * _e42.member_1) + (select(0f, _e67, _e91) * _e100)) + 0.5f));
                let _e108 = select(0f, _e106, (_e106 > 0f));
                let _e109 = trunc(_e108);
                let _e110 = (_e108 - _e109);
                let _e112 = u32((_e104 + _e109));
                let _e113 = (_e71 + _e75);
                let _e116 = select(false, (_e113 < 1f), (0f < _e113));
                let _e119 = select(select(0f, 1f, (1f <= _e113)), _e71, _e116);
                let _e121 = (_e119 * _e42.member);
                let _e126 = trunc(_e121);
                let _e128 = ((_e121 - _e126) + (((_e119 * _e42.member_1) + (select(0f, _e75, _e116) * _e100)) + 0.5f));
                let _e130 = select(0f, _e128, (_e128 > 0f));
                let _e131 = trunc(_e130);
                let _e132 = (_e130 - _e131);
                let _e134 = u32((_e126 + _e131));
                let _e135 = (_e80 + _e84);
                let _e138 = select(false, (_e135 < 1f), (0f < _e135));
                let _e141 = select(select(0f, 1f, (1f <= _e135)), _e80, _e138);
                let _e143 = (_e141 * _e42.member);
                let _e148 = trunc(_e143);
                let _e150 = ((_e143 - _e148) + (((_e141 * _e42.member_1) + (select(0f, _e84, _e138) * _e100)) + 0.5f));
                let _e152 = select(0f, _e150, (_e150 > 0f));
                let _e153 = trunc(_e152);
                let _e154 = (_e152 - _e153);
                let _e156 = u32((_e148 + _e153));
                let _e157 = (1f - _e110);
                let _e158 = (1f - _e132);
                let _e159 = (1f - _e154);
                let _e160 = (_e157 * _e158);
                let _e161 = (_e110 * _e158);
                let _e162 = (_e157 * _e132);
                let _e163 = (_e110 * _e132);
                if (_e42.member_5 == 0u) {
                    let _e177 = (_e42.member_2 * _e42.member_2);
                    let _e178 = (_e134 * _e42.member_2);
                    let _e179 = (_e156 * _e177);
                    let _e180 = (_e112 + 1u);
                    let _e181 = (_e178 + _e42.member_2);
                    let _e182 = (_e179 + _e177);
                    let _e183 = (_e112 + _e178);
                    let _e184 = (_e183 + _e179);
                    let _e189 = (_e180 + _e178);
                    let _e190 = (_e189 + _e179);
                    let _e195 = (_e112 + _e181);
                    let _e196 = (_e195 + _e179);
                    let _e201 = (_e180 + _e181);
                    let _e202 = (_e201 + _e179);
                    let _e207 = (_e183 + _e182);
                    let _e212 = (_e189 + _e182);
                    let _e217 = (_e195 + _e182);
                    let _e222 = (_e201 + _e182);
                    phi_301_ = array<u32, 8>((select((_e184 - _e42.member_4), _e184, (_e184 < _e42.member_4)) + _e42.member_3), (select((_e190 - _e42.member_4), _e190, (_e190 < _e42.member_4)) + _e42.member_3), (select((_e196 - _e42.member_4), _e196, (_e196 < _e42.member_4)) + _e42.member_3), (select((_e202 - _e42.member_4), _e202, (_e202 < _e42.member_4)) + _e42.member_3), (select((_e207 - _e42.member_4), _e207, (_e207 < _e42.member_4)) + _e42.member_3), (select((_e212 - _e42.member_4), _e212, (_e212 < _e42.member_4)) + _e42.member_3), (select((_e217 - _e42.member_4), _e217, (_e217 < _e42.member_4)) + _e42.member_3), (select((_e222 - _e42.member_4), _e222, (_e222 < _e42.member_4)) + _e42.member_3));
                } else {
                    let _e229 = (_e42.member_4 - 1u);
                    let _e230 = (_e134 * 2654435761u);
                    let _e231 = (_e156 * 805459861u);
                    let _e232 = (_e112 + 1u);
                    let _e233 = (_e230 + 2654435761u);
                    let _e234 = (_e231 + 805459861u);
                    let _e235 = (_e112 ^ _e230);
                    let _e239 = (_e232 ^ _e230);
                    let _e243 = (_e112 ^ _e233);
                    let _e247 = (_e232 ^ _e233);
                    phi_301_ = array<u32, 8>((((_e235 ^ _e231) & _e229) + _e42.member_3), (((_e239 ^ _e231) & _e229) + _e42.member_3), (((_e243 ^ _e231) & _e229) + _e42.member_3), (((_e247 ^ _e231) & _e229) + _e42.member_3), (((_e235 ^ _e234) & _e229) + _e42.member_3), (((_e239 ^ _e234) & _e229) + _e42.member_3), (((_e243 ^ _e234) & _e229) + _e42.member_3), (((_e247 ^ _e234) & _e229) + _e42.member_3));
                }
                let _e265 = phi_301_;
                let _e284 = global_3.member.member_2;
                let _e289 = global_3.member.member_6;
                if _e52 {
                    break;
                }
                phi_333_ = 0u;
                phi_336_ = ((((_e53 * (_e289 * _e45)) + _e57) + _e24.x) + ((_e284 + (_e25.z * _e87)) * _e45));
                loop {
                    let _e297 = phi_333_;
                    let _e299 = phi_336_;
                    if (_e297 < _e87) {
                        let _e304 = global_6.member[((_e265[0] * _e87) + _e297)];
                        let _e309 = global_6.member[((_e265[1] * _e87) + _e297)];
                        let _e314 = global_6.member[((_e265[2] * _e87) + _e297)];
                        let _e319 = global_6.member[((_e265[3] * _e87) + _e297)];
                        let _e324 = global_6.member[((_e265[4] * _e87) + _e297)];
                        let _e329 = global_6.member[((_e265[5] * _e87) + _e297)];
                        let _e334 = global_6.member[((_e265[6] * _e87) + _e297)];
                        let _e339 = global_6.member[((_e265[7] * _e87) + _e297)];
                        global_7.member[_e299] = ((((((((_e304 * (_e160 * _e159)) + (_e309 * (_e161 * _e159))) + (_e314 * (_e162 * _e159))) + (_e319 * (_e163 * _e159))) + (_e324 * (_e160 * _e154))) + (_e329 * (_e161 * _e154))) + (_e334 * (_e162 * _e154))) + (_e339 * (_e163 * _e154)));
                        local = (_e297 + 1u);
                        local_1 = (_e299 + _e45);
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e355 = local;
                        phi_333_ = _e355;
                        let _e358 = local_1;
                        phi_336_ = _e358;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
