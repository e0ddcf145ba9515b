struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_5 {
    member: type_4,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_14 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
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
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_17;
@group(0) @binding(2) 
var<storage> global_6: type_17;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_17;

fn function_() {
    var phi_83_: u32;
    var phi_86_: u32;
    var phi_88_: type_14;
    var phi_90_: u32;
    var local: type_14;
    var local_1: u32;
    var local_2: u32;
    var local_3: type_14;
    var local_4: u32;

    let _e25 = global;
    let _e26 = global_1;
    let _e27 = global_2;
    let _e35 = (((_e26.x + (_e26.y * _e27.x)) * 64u) + _e25.x);
    let _e38 = global_3.member.member;
    if (_e35 < _e38) {
        let _e42 = global_3.member.member_2;
        let _e45 = global_3.member.member_3;
        let _e48 = global_3.member.member_4;
        let _e51 = global_3.member.member_5;
        let _e54 = global_4.member[_e51];
        phi_83_ = 0u;
        phi_86_ = _e48;
        phi_88_ = type_14(_e54.x, _e54.y, _e54.z, _e54.w);
        phi_90_ = _e35;
        loop {
            let _e61 = phi_83_;
            let _e63 = phi_86_;
            let _e65 = phi_88_;
            let _e67 = phi_90_;
            local = _e65;
            if (_e61 < _e45) {
                let _e71 = global_4.member[_e63];
                let _e74 = global_5.member[_e67];
                local_1 = (_e61 + 1u);
                local_2 = (_e63 + 1u);
                local_3 = type_14(((_e74 * _e71.x) + _e65.member), ((_e74 * _e71.y) + _e65.member_1), ((_e74 * _e71.z) + _e65.member_2), ((_e74 * _e71.w) + _e65.member_3));
                local_4 = (_e67 + _e42);
                continue;
            } else {
                break;
            }
            continuing {
                let _e141 = local_1;
                phi_83_ = _e141;
                let _e144 = local_2;
                phi_86_ = _e144;
                let _e147 = local_3;
                phi_88_ = _e147;
                let _e150 = local_4;
                phi_90_ = _e150;
            }
        }
        let _e96 = local;
        let _e102 = global_6.member[((6u * _e42) + _e35)];
        let _e103 = (_e96.member < 0f);
        let _e107 = exp(select(-(_e96.member), _e96.member, _e103));
        let _e109 = (_e107 / (2f + _e107));
        let _e110 = (_e109 * _e109);
        let _e135 = global_3.member.member_1;
        global_7.member[(_e135 + _e35)] = (_e102 * (select(0f, _e96.member, _e103) - ((2f * _e109) * (1f + (_e110 * ((1f / 3f) + (_e110 * ((1f / 5f) + (_e110 * ((1f / 7f) + (_e110 * ((1f / 9f) + (_e110 * ((1f / 11f) + (_e110 * (1f / 13f))))))))))))))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_head(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
