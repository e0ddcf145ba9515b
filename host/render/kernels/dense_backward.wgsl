struct type_4 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_5 {
    member: type_4,
}

struct type_9 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_10 {
    member: type_9,
    member_1: type_9,
    member_2: type_9,
    member_3: type_9,
}

struct type_14 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_14;
@group(0) @binding(1) 
var<storage> global_5: type_14;
@group(0) @binding(2) 
var<storage> global_6: type_14;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_14;

fn function_() {
    var phi_113_: u32;
    var phi_116_: type_10;
    var phi_118_: type_10;
    var phi_120_: u32;
    var local: type_10;
    var phi_559_: type_9;
    var local_1: type_10;
    var phi_618_: type_9;
    var local_2: type_10;
    var phi_677_: type_9;
    var local_3: type_10;
    var phi_736_: type_9;
    var local_4: type_10;
    var phi_796_: type_9;
    var local_5: type_10;
    var phi_855_: type_9;
    var local_6: type_10;
    var phi_914_: type_9;
    var local_7: type_10;
    var phi_973_: type_9;
    var local_8: u32;
    var local_9: type_10;
    var local_10: type_10;
    var local_11: u32;

    let _e21 = global;
    let _e22 = global_1;
    let _e23 = global_2;
    let _e32 = ((((_e22.x + (_e22.y * _e23.x)) * 64u) + _e21.x) * 4u);
    let _e35 = global_3.member.member;
    if (_e32 < _e35) {
        let _e39 = global_3.member.member_5;
        let _e42 = (_e39 + (_e22.z * 8u));
        let _e45 = global_3.member.member_2;
        let _e46 = (_e45 - 1u);
        let _e49 = global_3.member.member_4;
        let _e52 = global_3.member.member_3;
        let _e57 = (_e42 + 1u);
        let _e62 = (_e42 + 2u);
        let _e67 = (_e42 + 3u);
        let _e72 = (_e42 + 4u);
        let _e77 = (_e42 + 5u);
        let _e82 = (_e42 + 6u);
        let _e87 = (_e42 + 7u);
        phi_113_ = 0u;
        phi_116_ = type_10(type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f));
        phi_118_ = type_10(type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f));
        phi_120_ = _e32;
        loop {
            let _e93 = phi_113_;
            let _e95 = phi_116_;
            let _e97 = phi_118_;
            let _e99 = phi_120_;
            local = _e97;
            local_1 = _e97;
            local_2 = _e97;
            local_3 = _e97;
            local_4 = _e95;
            local_5 = _e95;
            local_6 = _e95;
            local_7 = _e95;
            if (_e93 < _e52) {
                let _e103 = global_3.member.member_1;
                let _e107 = global_4.member[(_e99 / 4u)];
                let _e116 = global_4.member[((_e99 + _e103) / 4u)];
                let _e126 = global_4.member[((_e99 + (2u * _e103)) / 4u)];
                let _e136 = global_4.member[((_e99 + (3u * _e103)) / 4u)];
                let _e144 = global_5.member[((_e49 + (select(_e46, _e42, (_e42 < _e46)) * _e52)) + _e93)];
                let _e148 = global_5.member[((_e49 + (select(_e46, _e57, (_e57 < _e46)) * _e52)) + _e93)];
                let _e152 = global_5.member[((_e49 + (select(_e46, _e62, (_e62 < _e46)) * _e52)) + _e93)];
                let _e156 = global_5.member[((_e49 + (select(_e46, _e67, (_e67 < _e46)) * _e52)) + _e93)];
                let _e329 = global_5.member[((_e49 + (select(_e46, _e72, (_e72 < _e46)) * _e52)) + _e93)];
                let _e333 = global_5.member[((_e49 + (select(_e46, _e77, (_e77 < _e46)) * _e52)) + _e93)];
                let _e337 = global_5.member[((_e49 + (select(_e46, _e82, (_e82 < _e46)) * _e52)) + _e93)];
                let _e341 = global_5.member[((_e49 + (select(_e46, _e87, (_e87 < _e46)) * _e52)) + _e93)];
                local_8 = (_e93 + 1u);
                local_9 = type_10(type_9(((_e136.x * _e329.w) + ((_e126.x * _e329.z) + ((_e116.x * _e329.y) + ((_e107.x * _e329.x) + _e95.member.member)))), ((_e136.y * _e329.w) + ((_e126.y * _e329.z) + ((_e116.y * _e329.y) + ((_e107.y * _e329.x) + _e95.member.member_1)))), ((_e136.z * _e329.w) + ((_e126.z * _e329.z) + ((_e116.z * _e329.y) + ((_e107.z * _e329.x) + _e95.member.member_2)))), ((_e136.w * _e329.w) + ((_e126.w * _e329.z) + ((_e116.w * _e329.y) + ((_e107.w * _e329.x) + _e95.member.member_3))))), type_9(((_e136.x * _e333.w) + ((_e126.x * _e333.z) + ((_e116.x * _e333.y) + ((_e107.x * _e333.x) + _e95.member_1.member)))), ((_e136.y * _e333.w) + ((_e126.y * _e333.z) + ((_e116.y * _e333.y) + ((_e107.y * _e333.x) + _e95.member_1.member_1)))), ((_e136.z * _e333.w) + ((_e126.z * _e333.z) + ((_e116.z * _e333.y) + ((_e107.z * _e333.x) + _e95.member_1.member_2)))), ((_e136.w * _e333.w) + ((_e126.w * _e333.z) + ((_e116.w * _e333.y) + ((_e107.w * _e333.x) + _e95.member_1.member_3))))), type_9(((_e136.x * _e337.w) + ((_e126.x * _e337.z) + ((_e116.x * _e337.y) + ((_e107.x * _e337.x) + _e95.member_2.member)))), ((_e136.y * _e337.w) + ((_e126.y * _e337.z) + ((_e116.y * _e337.y) + ((_e107.y * _e337.x) + _e95.member_2.member_1)))), ((_e136.z * _e337.w) + ((_e126.z * _e337.z) + ((_e116.z * _e337.y) + ((_e107.z * _e337.x) + _e95.member_2.member_2)))), ((_e136.w * _e337.w) + ((_e126.w * _e337.z) + ((_e116.w * _e337.y) + ((_e107.w * _e337.x) + _e95.member_2.member_3))))), type_9(((_e136.x * _e341.w) + ((_e126.x * _e341.z) + ((_e116.x * _e341.y) + ((_e107.x * _e341.x) + _e95.member_3.member)))), ((_e136.y * _e341.w) + ((_e126.y * _e341.z) + ((_e116.y * _e341.y) + ((_e107.y * _e341.x) + _e95.member_3.member_1)))), ((_e136.z * _e341.w) + ((_e126.z * _e341.z) + ((_e116.z * _e341.y) + ((_e107.z * _e341.x) + _e95.member_3.member_2)))), ((_e136.w * _e341.w) + ((_e126.w * _e341.z) + ((_e116.w * _e341.y) + ((_e107.w * _e341.x) + _e95.member_3.member_3))))));
                local_10 = type_10(type_9(((_e136.x * _e144.w) + ((_e126.x * _e144.z) + ((_e116.x * _e144.y) + ((_e107.x * _e144.x) + _e97.member.member)))), ((_e136.y * _e144.w) + ((_e126.y * _e144.z) + ((_e116.y * _e144.y) + ((_e107.y * _e144.x) + _e97.member.member_1)))), ((_e136.z * _e144.w) + ((_e126.z * _e144.z) + ((_e116.z * _e144.y) + ((_e107.z * _e144.x) + _e97.member.member_2)))), ((_e136.w * _e144.w) + ((_e126.w * _e144.z) + ((_e116.w * _e144.y) + ((_e107.w * _e144.x) + _e97.member.member_3))))), type_9(((_e136.x * _e148.w) + ((_e126.x * _e148.z) + ((_e116.x * _e148.y) + ((_e107.x * _e148.x) + _e97.member_1.member)))), ((_e136.y * _e148.w) + ((_e126.y * _e148.z) + ((_e116.y * _e148.y) + ((_e107.y * _e148.x) + _e97.member_1.member_1)))), ((_e136.z * _e148.w) + ((_e126.z * _e148.z) + ((_e116.z * _e148.y) + ((_e107.z * _e148.x) + _e97.member_1.member_2)))), ((_e136.w * _e148.w) + ((_e126.w * _e148.z) + ((_e116.w * _e148.y) + ((_e107.w * _e148.x) + _e97.member_1.member_3))))), type_9(((_e136.x * _e152.w) + ((_e126.x * _e152.z) + ((_e116.x * _e152.y) + ((_e107.x * _e152.x) + _e97.member_2.member)))), ((_e136.y * _e152.w) + ((_e126.y * _e152.z) + ((_e116.y * _e152.y) + ((_e107.y * _e152.x) + _e97.member_2.member_1)))), ((_e136.z * _e152.w) + ((_e126.z * _e152.z) + ((_e116.z * _e152.y) + ((_e107.z * _e152.x) + _e97.member_2.member_2)))), ((_e136.w * _e152.w) + ((_e126.w * _e152.z) + ((_e116.w * _e152.y) + ((_e107.w * _e152.x) + _e97.member_2.member_3))))), type_9(((_e136.x * _e156.w) + ((_e126.x * _e156.z) + ((_e116.x * _e156.y) + ((_e107.x * _e156.x) + _e97.member_3.member)))), ((_e136.y * _e156.w) + ((_e126.y * _e156.z) + ((_e116.y * _e156.y) + ((_e107.y * _e156.x) + _e97.member_3.member_1)))), ((_e136.z * _e156.w) + ((_e126.z * _e156.z) + ((_e116.z * _e156.y) + ((_e107.z * _e156.x) + _e97.member_3.member_2)))), ((_e136.w * _e156.w) + ((_e126.w * _e156.z) + ((_e116.w * _e156.y) + ((_e107.w * _e156.x) + _e97.member_3.member_3))))));
                local_11 = (_e99 + (4u * _e103));
                continue;
            } else {
                break;
            }
            continuing {
                let _e973 = local_8;
                phi_113_ = _e973;
                let _e976 = local_9;
                phi_116_ = _e976;
                let _e979 = local_10;
                phi_118_ = _e979;
                let _e982 = local_11;
                phi_120_ = _e982;
            }
        }
        let _e514 = (_e35 - _e32);
        let _e517 = global_3.member.member_1;
        let _e519 = ((_e42 * _e517) + _e32);
        let _e522 = global_3.member.member_6;
        if (_e42 < _e522) {
            let _e525 = local;
            let _e529 = global_3.member.member_7;
            if (_e529 == 0u) {
                phi_559_ = _e525.member;
            } else {
                let _e534 = global_6.member[(_e519 / 4u)];
                phi_559_ = type_9(select(0f, _e525.member.member, (0f < _e534.x)), select(0f, _e525.member.member_1, (0f < _e534.y)), select(0f, _e525.member.member_2, (0f < _e534.z)), select(0f, _e525.member.member_3, (0f < _e534.w)));
            }
            let _e553 = phi_559_;
            if (_e514 > 3u) {
                global_7.member[(_e519 / 4u)] = vec4<f32>(_e553.member, _e553.member_1, _e553.member_2, _e553.member_3);
            } else {
                let _e563 = (_e519 / 4u);
                global_7.member[_e563][0u] = _e553.member;
                if (_e514 > 1u) {
                    global_7.member[_e563][1u] = _e553.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e563][2u] = _e553.member_2;
                }
            }
        }
        let _e578 = (_e519 + _e517);
        if (_e57 < _e522) {
            let _e581 = local_1;
            let _e585 = global_3.member.member_7;
            if (_e585 == 0u) {
                phi_618_ = _e581.member_1;
            } else {
                let _e590 = global_6.member[(_e578 / 4u)];
                phi_618_ = type_9(select(0f, _e581.member_1.member, (0f < _e590.x)), select(0f, _e581.member_1.member_1, (0f < _e590.y)), select(0f, _e581.member_1.member_2, (0f < _e590.z)), select(0f, _e581.member_1.member_3, (0f < _e590.w)));
            }
            let _e609 = phi_618_;
            if (_e514 > 3u) {
                global_7.member[(_e578 / 4u)] = vec4<f32>(_e609.member, _e609.member_1, _e609.member_2, _e609.member_3);
            } else {
                let _e619 = (_e578 / 4u);
                global_7.member[_e619][0u] = _e609.member;
                if (_e514 > 1u) {
                    global_7.member[_e619][1u] = _e609.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e619][2u] = _e609.member_2;
                }
            }
        }
        let _e634 = (_e578 + _e517);
        if (_e62 < _e522) {
            let _e637 = local_2;
            let _e641 = global_3.member.member_7;
            if (_e641 == 0u) {
                phi_677_ = _e637.member_2;
            } else {
                let _e646 = global_6.member[(_e634 / 4u)];
                phi_677_ = type_9(select(0f, _e637.member_2.member, (0f < _e646.x)), select(0f, _e637.member_2.member_1, (0f < _e646.y)), select(0f, _e637.member_2.member_2, (0f < _e646.z)), select(0f, _e637.member_2.member_3, (0f < _e646.w)));
            }
            let _e665 = phi_677_;
            if (_e514 > 3u) {
                global_7.member[(_e634 / 4u)] = vec4<f32>(_e665.member, _e665.member_1, _e665.member_2, _e665.member_3);
            } else {
                let _e675 = (_e634 / 4u);
                global_7.member[_e675][0u] = _e665.member;
                if (_e514 > 1u) {
                    global_7.member[_e675][1u] = _e665.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e675][2u] = _e665.member_2;
                }
            }
        }
        let _e690 = (_e634 + _e517);
        if (_e67 < _e522) {
            let _e693 = local_3;
            let _e697 = global_3.member.member_7;
            if (_e697 == 0u) {
                phi_736_ = _e693.member_3;
            } else {
                let _e702 = global_6.member[(_e690 / 4u)];
                phi_736_ = type_9(select(0f, _e693.member_3.member, (0f < _e702.x)), select(0f, _e693.member_3.member_1, (0f < _e702.y)), select(0f, _e693.member_3.member_2, (0f < _e702.z)), select(0f, _e693.member_3.member_3, (0f < _e702.w)));
            }
            let _e721 = phi_736_;
            if (_e514 > 3u) {
                global_7.member[(_e690 / 4u)] = vec4<f32>(_e721.member, _e721.member_1, _e721.member_2, _e721.member_3);
            } else {
                let _e731 = (_e690 / 4u);
                global_7.member[_e731][0u] = _e721.member;
                if (_e514 > 1u) {
                    global_7.member[_e731][1u] = _e721.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e731][2u] = _e721.member_2;
                }
            }
        }
        let _e747 = ((_e72 * _e517) + _e32);
        if (_e72 < _e522) {
            let _e750 = local_4;
            let _e754 = global_3.member.member_7;
            if (_e754 == 0u) {
                phi_796_ = _e750.member;
            } else {
                let _e759 = global_6.member[(_e747 / 4u)];
                phi_796_ = type_9(select(0f, _e750.member.member, (0f < _e759.x)), select(0f, _e750.member.member_1, (0f < _e759.y)), select(0f, _e750.member.member_2, (0f < _e759.z)), select(0f, _e750.member.member_3, (0f < _e759.w)));
            }
            let _e778 = phi_796_;
            if (_e514 > 3u) {
                global_7.member[(_e747 / 4u)] = vec4<f32>(_e778.member, _e778.member_1, _e778.member_2, _e778.member_3);
            } else {
                let _e788 = (_e747 / 4u);
                global_7.member[_e788][0u] = _e778.member;
                if (_e514 > 1u) {
                    global_7.member[_e788][1u] = _e778.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e788][2u] = _e778.member_2;
                }
            }
        }
        let _e803 = (_e747 + _e517);
        if (_e77 < _e522) {
            let _e806 = local_5;
            let _e810 = global_3.member.member_7;
            if (_e810 == 0u) {
                phi_855_ = _e806.member_1;
            } else {
                let _e815 = global_6.member[(_e803 / 4u)];
                phi_855_ = type_9(select(0f, _e806.member_1.member, (0f < _e815.x)), select(0f, _e806.member_1.member_1, (0f < _e815.y)), select(0f, _e806.member_1.member_2, (0f < _e815.z)), select(0f, _e806.member_1.member_3, (0f < _e815.w)));
            }
            let _e834 = phi_855_;
            if (_e514 > 3u) {
                global_7.member[(_e803 / 4u)] = vec4<f32>(_e834.member, _e834.member_1, _e834.member_2, _e834.member_3);
            } else {
                let _e844 = (_e803 / 4u);
                global_7.member[_e844][0u] = _e834.member;
                if (_e514 > 1u) {
                    global_7.member[_e844][1u] = _e834.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e844][2u] = _e834.member_2;
                }
            }
        }
        let _e859 = (_e803 + _e517);
        if (_e82 < _e522) {
            let _e862 = local_6;
            let _e866 = global_3.member.member_7;
            if (_e866 == 0u) {
                phi_914_ = _e862.member_2;
            } else {
                let _e871 = global_6.member[(_e859 / 4u)];
                phi_914_ = type_9(select(0f, _e862.member_2.member, (0f < _e871.x)), select(0f, _e862.member_2.member_1, (0f < _e871.y)), select(0f, _e862.member_2.member_2, (0f < _e871.z)), select(0f, _e862.member_2.member_3, (0f < _e871.w)));
            }
            let _e890 = phi_914_;
            if (_e514 > 3u) {
                global_7.member[(_e859 / 4u)] = vec4<f32>(_e890.member, _e890.member_1, _e890.member_2, _e890.member_3);
            } else {
                let _e900 = (_e859 / 4u);
                global_7.member[_e900][0u] = _e890.member;
                if (_e514 > 1u) {
                    global_7.member[_e900][1u] = _e890.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e900][2u] = _e890.member_2;
                }
            }
        }
        let _e915 = (_e859 + _e517);
        if (_e87 < _e522) {
            let _e918 = local_7;
            let _e922 = global_3.member.member_7;
            if (_e922 == 0u) {
                phi_973_ = _e918.member_3;
            } else {
                let _e927 = global_6.member[(_e915 / 4u)];
                phi_973_ = type_9(select(0f, _e918.member_3.member, (0f < _e927.x)), select(0f, _e918.member_3.member_1, (0f < _e927.y)), select(0f, _e918.member_3.member_2, (0f < _e927.z)), select(0f, _e918.member_3.member_3, (0f < _e927.w)));
            }
            let _e946 = phi_973_;
            if (_e514 > 3u) {
                global_7.member[(_e915 / 4u)] = vec4<f32>(_e946.member, _e946.member_1, _e946.member_2, _e946.member_3);
            } else {
                let _e956 = (_e915 / 4u);
                global_7.member[_e956][0u] = _e946.member;
                if (_e514 > 1u) {
                    global_7.member[_e956][1u] = _e946.member_1;
                }
                if (_e514 > 2u) {
                    global_7.member[_e956][2u] = _e946.member_2;
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn dense_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
