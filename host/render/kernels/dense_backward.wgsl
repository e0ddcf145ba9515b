struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_17 {
    member: type_16,
}

struct type_19 {
    member: type_15,
    member_1: type_15,
    member_2: type_15,
    member_3: type_15,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_12;
@group(0) @binding(0) 
var<uniform> global_4: type_17;
@group(0) @binding(2) 
var<storage> global_5: type_5;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_5;

fn function_() {
    var phi_118_: u32;
    var phi_121_: u32;
    var phi_123_: type_19;
    var phi_125_: type_19;
    var local: type_19;
    var phi_584_: type_15;
    var local_1: type_19;
    var phi_644_: type_15;
    var local_2: type_19;
    var phi_704_: type_15;
    var local_3: type_19;
    var phi_764_: type_15;
    var local_4: type_19;
    var phi_825_: type_15;
    var local_5: type_19;
    var phi_885_: type_15;
    var local_6: type_19;
    var phi_945_: type_15;
    var local_7: type_19;
    var phi_1005_: type_15;
    var local_8: u32;
    var local_9: u32;
    var local_10: type_19;
    var local_11: type_19;

    let _e23 = global;
    let _e24 = global_1;
    let _e25 = global_2;
    let _e34 = ((((_e24.x + (_e24.y * _e25.x)) * 64u) + _e23.x) * 4u);
    let _e37 = global_4.member.member;
    if (_e34 < _e37) {
        let _e41 = global_4.member.member_5;
        let _e44 = (_e41 + (_e24.z * 8u));
        let _e47 = global_4.member.member_2;
        let _e48 = (_e47 - 1u);
        let _e51 = global_4.member.member_4;
        let _e54 = global_4.member.member_3;
        let _e59 = (_e44 + 1u);
        let _e64 = (_e44 + 2u);
        let _e69 = (_e44 + 3u);
        let _e74 = (_e44 + 4u);
        let _e79 = (_e44 + 5u);
        let _e84 = (_e44 + 6u);
        let _e89 = (_e44 + 7u);
        phi_118_ = 0u;
        phi_121_ = _e34;
        phi_123_ = type_19(type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f));
        phi_125_ = type_19(type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f), type_15(0f, 0f, 0f, 0f));
        loop {
            let _e95 = phi_118_;
            let _e97 = phi_121_;
            let _e99 = phi_123_;
            let _e101 = phi_125_;
            local = _e101;
            local_1 = _e101;
            local_2 = _e101;
            local_3 = _e101;
            local_4 = _e99;
            local_5 = _e99;
            local_6 = _e99;
            local_7 = _e99;
            if (_e95 < _e54) {
                let _e105 = global_4.member.member_1;
                let _e108 = global_6.member[_e97];
                let _e112 = global_6.member[(_e97 + 1u)];
                let _e116 = global_6.member[(_e97 + 2u)];
                let _e120 = global_6.member[(_e97 + 3u)];
                let _e121 = (_e97 + _e105);
                let _e124 = global_6.member[_e121];
                let _e128 = global_6.member[(_e121 + 1u)];
                let _e132 = global_6.member[(_e121 + 2u)];
                let _e136 = global_6.member[(_e121 + 3u)];
                let _e138 = (_e97 + (2u * _e105));
                let _e141 = global_6.member[_e138];
                let _e145 = global_6.member[(_e138 + 1u)];
                let _e149 = global_6.member[(_e138 + 2u)];
                let _e153 = global_6.member[(_e138 + 3u)];
                let _e155 = (_e97 + (3u * _e105));
                let _e158 = global_6.member[_e155];
                let _e162 = global_6.member[(_e155 + 1u)];
                let _e166 = global_6.member[(_e155 + 2u)];
                let _e170 = global_6.member[(_e155 + 3u)];
                let _e174 = global_3.member[((_e51 + (select(_e48, _e44, (_e44 < _e48)) * _e54)) + _e95)];
                let _e178 = global_3.member[((_e51 + (select(_e48, _e59, (_e59 < _e48)) * _e54)) + _e95)];
                let _e182 = global_3.member[((_e51 + (select(_e48, _e64, (_e64 < _e48)) * _e54)) + _e95)];
                let _e186 = global_3.member[((_e51 + (select(_e48, _e69, (_e69 < _e48)) * _e54)) + _e95)];
                let _e359 = global_3.member[((_e51 + (select(_e48, _e74, (_e74 < _e48)) * _e54)) + _e95)];
                let _e363 = global_3.member[((_e51 + (select(_e48, _e79, (_e79 < _e48)) * _e54)) + _e95)];
                let _e367 = global_3.member[((_e51 + (select(_e48, _e84, (_e84 < _e48)) * _e54)) + _e95)];
                let _e371 = global_3.member[((_e51 + (select(_e48, _e89, (_e89 < _e48)) * _e54)) + _e95)];
                local_8 = (_e95 + 1u);
                local_9 = (_e97 + (4u * _e105));
                local_10 = type_19(type_15(((_e158 * _e359.w) + ((_e141 * _e359.z) + ((_e124 * _e359.y) + ((_e108 * _e359.x) + _e99.member.member)))), ((_e162 * _e359.w) + ((_e145 * _e359.z) + ((_e128 * _e359.y) + ((_e112 * _e359.x) + _e99.member.member_1)))), ((_e166 * _e359.w) + ((_e149 * _e359.z) + ((_e132 * _e359.y) + ((_e116 * _e359.x) + _e99.member.member_2)))), ((_e170 * _e359.w) + ((_e153 * _e359.z) + ((_e136 * _e359.y) + ((_e120 * _e359.x) + _e99.member.member_3))))), type_15(((_e158 * _e363.w) + ((_e141 * _e363.z) + ((_e124 * _e363.y) + ((_e108 * _e363.x) + _e99.member_1.member)))), ((_e162 * _e363.w) + ((_e145 * _e363.z) + ((_e128 * _e363.y) + ((_e112 * _e363.x) + _e99.member_1.member_1)))), ((_e166 * _e363.w) + ((_e149 * _e363.z) + ((_e132 * _e363.y) + ((_e116 * _e363.x) + _e99.member_1.member_2)))), ((_e170 * _e363.w) + ((_e153 * _e363.z) + ((_e136 * _e363.y) + ((_e120 * _e363.x) + _e99.member_1.member_3))))), type_15(((_e158 * _e367.w) + ((_e141 * _e367.z) + ((_e124 * _e367.y) + ((_e108 * _e367.x) + _e99.member_2.member)))), ((_e162 * _e367.w) + ((_e145 * _e367.z) + ((_e128 * _e367.y) + ((_e112 * _e367.x) + _e99.member_2.member_1)))), ((_e166 * _e367.w) + ((_e149 * _e367.z) + ((_e132 * _e367.y) + ((_e116 * _e367.x) + _e99.member_2.member_2)))), ((_e170 * _e367.w) + ((_e153 * _e367.z) + ((_e136 * _e367.y) + ((_e120 * _e367.x) + _e99.member_2.member_3))))), type_15(((_e158 * _e371.w) + ((_e141 * _e371.z) + ((_e124 * _e371.y) + ((_e108 * _e371.x) + _e99.member_3.member)))), ((_e162 * _e371.w) + ((_e145 * _e371.z) + ((_e128 * _e371.y) + ((_e112 * _e371.x) + _e99.member_3.member_1)))), ((_e166 * _e371.w) + ((_e149 * _e371.z) + ((_e132 * _e371.y) + ((_e116 * _e371.x) + _e99.member_3.member_2)))), ((_e170 * _e371.w) + ((_e153 * _e371.z) + ((_e136 * _e371.y) + ((_e120 * _e371.x) + _e99.member_3.member_3))))));
                local_11 = type_19(type_15(((_e158 * _e174.w) + ((_e141 * _e174.z) + ((_e124 * _e174.y) + ((_e108 * _e174.x) + _e101.member.member)))), ((_e162 * _e174.w) + ((_e145 * _e174.z) + ((_e128 * _e174.y) + ((_e112 * _e174.x) + _e101.member.member_1)))), ((_e166 * _e174.w) + ((_e149 * _e174.z) + ((_e132 * _e174.y) + ((_e116 * _e174.x) + _e101.member.member_2)))), ((_e170 * _e174.w) + ((_e153 * _e174.z) + ((_e136 * _e174.y) + ((_e120 * _e174.x) + _e101.member.member_3))))), type_15(((_e158 * _e178.w) + ((_e141 * _e178.z) + ((_e124 * _e178.y) + ((_e108 * _e178.x) + _e101.member_1.member)))), ((_e162 * _e178.w) + ((_e145 * _e178.z) + ((_e128 * _e178.y) + ((_e112 * _e178.x) + _e101.member_1.member_1)))), ((_e166 * _e178.w) + ((_e149 * _e178.z) + ((_e132 * _e178.y) + ((_e116 * _e178.x) + _e101.member_1.member_2)))), ((_e170 * _e178.w) + ((_e153 * _e178.z) + ((_e136 * _e178.y) + ((_e120 * _e178.x) + _e101.member_1.member_3))))), type_15(((_e158 * _e182.w) + ((_e141 * _e182.z) + ((_e124 * _e182.y) + ((_e108 * _e182.x) + _e101.member_2.member)))), ((_e162 * _e182.w) + ((_e145 * _e182.z) + ((_e128 * _e182.y) + ((_e112 * _e182.x) + _e101.member_2.member_1)))), ((_e166 * _e182.w) + ((_e149 * _e182.z) + ((_e132 * _e182.y) + ((_e116 * _e182.x) + _e101.member_2.member_2)))), ((_e170 * _e182.w) + ((_e153 * _e182.z) + ((_e136 * _e182.y) + ((_e120 * _e182.x) + _e101.member_2.member_3))))), type_15(((_e158 * _e186.w) + ((_e141 * _e186.z) + ((_e124 * _e186.y) + ((_e108 * _e186.x) + _e101.member_3.member)))), ((_e162 * _e186.w) + ((_e145 * _e186.z) + ((_e128 * _e186.y) + ((_e112 * _e186.x) + _e101.member_3.member_1)))), ((_e166 * _e186.w) + ((_e149 * _e186.z) + ((_e132 * _e186.y) + ((_e116 * _e186.x) + _e101.member_3.member_2)))), ((_e170 * _e186.w) + ((_e153 * _e186.z) + ((_e136 * _e186.y) + ((_e120 * _e186.x) + _e101.member_3.member_3))))));
                continue;
            } else {
                break;
            }
            continuing {
                let _e1011 = local_8;
                phi_118_ = _e1011;
                let _e1014 = local_9;
                phi_121_ = _e1014;
                let _e1017 = local_10;
                phi_123_ = _e1017;
                let _e1020 = local_11;
                phi_125_ = _e1020;
            }
        }
        let _e544 = (_e37 - _e34);
        let _e547 = global_4.member.member_1;
        let _e549 = ((_e44 * _e547) + _e34);
        let _e552 = global_4.member.member_6;
        if (_e44 < _e552) {
            let _e555 = local;
            let _e559 = global_4.member.member_7;
            if (_e559 == 0u) {
                phi_584_ = _e555.member;
            } else {
                let _e563 = global_5.member[_e549];
                let _e567 = global_5.member[(_e549 + 1u)];
                let _e571 = global_5.member[(_e549 + 2u)];
                let _e575 = global_5.member[(_e549 + 3u)];
                phi_584_ = type_15(select(0f, _e555.member.member, (0f < _e563)), select(0f, _e555.member.member_1, (0f < _e567)), select(0f, _e555.member.member_2, (0f < _e571)), select(0f, _e555.member.member_3, (0f < _e575)));
            }
            let _e590 = phi_584_;
            global_7.member[_e549] = _e590.member;
            if (_e544 > 1u) {
                global_7.member[(_e549 + 1u)] = _e590.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e549 + 2u)] = _e590.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e549 + 3u)] = _e590.member_3;
            }
        }
        let _e609 = (_e549 + _e547);
        if (_e59 < _e552) {
            let _e612 = local_1;
            let _e616 = global_4.member.member_7;
            if (_e616 == 0u) {
                phi_644_ = _e612.member_1;
            } else {
                let _e620 = global_5.member[_e609];
                let _e624 = global_5.member[(_e609 + 1u)];
                let _e628 = global_5.member[(_e609 + 2u)];
                let _e632 = global_5.member[(_e609 + 3u)];
                phi_644_ = type_15(select(0f, _e612.member_1.member, (0f < _e620)), select(0f, _e612.member_1.member_1, (0f < _e624)), select(0f, _e612.member_1.member_2, (0f < _e628)), select(0f, _e612.member_1.member_3, (0f < _e632)));
            }
            let _e647 = phi_644_;
            global_7.member[_e609] = _e647.member;
            if (_e544 > 1u) {
                global_7.member[(_e609 + 1u)] = _e647.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e609 + 2u)] = _e647.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e609 + 3u)] = _e647.member_3;
            }
        }
        let _e666 = (_e609 + _e547);
        if (_e64 < _e552) {
            let _e669 = local_2;
            let _e673 = global_4.member.member_7;
            if (_e673 == 0u) {
                phi_704_ = _e669.member_2;
            } else {
                let _e677 = global_5.member[_e666];
                let _e681 = global_5.member[(_e666 + 1u)];
                let _e685 = global_5.member[(_e666 + 2u)];
                let _e689 = global_5.member[(_e666 + 3u)];
                phi_704_ = type_15(select(0f, _e669.member_2.member, (0f < _e677)), select(0f, _e669.member_2.member_1, (0f < _e681)), select(0f, _e669.member_2.member_2, (0f < _e685)), select(0f, _e669.member_2.member_3, (0f < _e689)));
            }
            let _e704 = phi_704_;
            global_7.member[_e666] = _e704.member;
            if (_e544 > 1u) {
                global_7.member[(_e666 + 1u)] = _e704.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e666 + 2u)] = _e704.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e666 + 3u)] = _e704.member_3;
            }
        }
        let _e723 = (_e666 + _e547);
        if (_e69 < _e552) {
            let _e726 = local_3;
            let _e730 = global_4.member.member_7;
            if (_e730 == 0u) {
                phi_764_ = _e726.member_3;
            } else {
                let _e734 = global_5.member[_e723];
                let _e738 = global_5.member[(_e723 + 1u)];
                let _e742 = global_5.member[(_e723 + 2u)];
                let _e746 = global_5.member[(_e723 + 3u)];
                phi_764_ = type_15(select(0f, _e726.member_3.member, (0f < _e734)), select(0f, _e726.member_3.member_1, (0f < _e738)), select(0f, _e726.member_3.member_2, (0f < _e742)), select(0f, _e726.member_3.member_3, (0f < _e746)));
            }
            let _e761 = phi_764_;
            global_7.member[_e723] = _e761.member;
            if (_e544 > 1u) {
                global_7.member[(_e723 + 1u)] = _e761.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e723 + 2u)] = _e761.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e723 + 3u)] = _e761.member_3;
            }
        }
        let _e781 = ((_e74 * _e547) + _e34);
        if (_e74 < _e552) {
            let _e784 = local_4;
            let _e788 = global_4.member.member_7;
            if (_e788 == 0u) {
                phi_825_ = _e784.member;
            } else {
                let _e792 = global_5.member[_e781];
                let _e796 = global_5.member[(_e781 + 1u)];
                let _e800 = global_5.member[(_e781 + 2u)];
                let _e804 = global_5.member[(_e781 + 3u)];
                phi_825_ = type_15(select(0f, _e784.member.member, (0f < _e792)), select(0f, _e784.member.member_1, (0f < _e796)), select(0f, _e784.member.member_2, (0f < _e800)), select(0f, _e784.member.member_3, (0f < _e804)));
            }
            let _e819 = phi_825_;
            global_7.member[_e781] = _e819.member;
            if (_e544 > 1u) {
                global_7.member[(_e781 + 1u)] = _e819.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e781 + 2u)] = _e819.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e781 + 3u)] = _e819.member_3;
            }
        }
        let _e838 = (_e781 + _e547);
        if (_e79 < _e552) {
            let _e841 = local_5;
            let _e845 = global_4.member.member_7;
            if (_e845 == 0u) {
                phi_885_ = _e841.member_1;
            } else {
                let _e849 = global_5.member[_e838];
                let _e853 = global_5.member[(_e838 + 1u)];
                let _e857 = global_5.member[(_e838 + 2u)];
                let _e861 = global_5.member[(_e838 + 3u)];
                phi_885_ = type_15(select(0f, _e841.member_1.member, (0f < _e849)), select(0f, _e841.member_1.member_1, (0f < _e853)), select(0f, _e841.member_1.member_2, (0f < _e857)), select(0f, _e841.member_1.member_3, (0f < _e861)));
            }
            let _e876 = phi_885_;
            global_7.member[_e838] = _e876.member;
            if (_e544 > 1u) {
                global_7.member[(_e838 + 1u)] = _e876.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e838 + 2u)] = _e876.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e838 + 3u)] = _e876.member_3;
            }
        }
        let _e895 = (_e838 + _e547);
        if (_e84 < _e552) {
            let _e898 = local_6;
            let _e902 = global_4.member.member_7;
            if (_e902 == 0u) {
                phi_945_ = _e898.member_2;
            } else {
                let _e906 = global_5.member[_e895];
                let _e910 = global_5.member[(_e895 + 1u)];
                let _e914 = global_5.member[(_e895 + 2u)];
                let _e918 = global_5.member[(_e895 + 3u)];
                phi_945_ = type_15(select(0f, _e898.member_2.member, (0f < _e906)), select(0f, _e898.member_2.member_1, (0f < _e910)), select(0f, _e898.member_2.member_2, (0f < _e914)), select(0f, _e898.member_2.member_3, (0f < _e918)));
            }
            let _e933 = phi_945_;
            global_7.member[_e895] = _e933.member;
            if (_e544 > 1u) {
                global_7.member[(_e895 + 1u)] = _e933.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e895 + 2u)] = _e933.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e895 + 3u)] = _e933.member_3;
            }
        }
        let _e952 = (_e895 + _e547);
        if (_e89 < _e552) {
            let _e955 = local_7;
            let _e959 = global_4.member.member_7;
            if (_e959 == 0u) {
                phi_1005_ = _e955.member_3;
            } else {
                let _e963 = global_5.member[_e952];
                let _e967 = global_5.member[(_e952 + 1u)];
                let _e971 = global_5.member[(_e952 + 2u)];
                let _e975 = global_5.member[(_e952 + 3u)];
                phi_1005_ = type_15(select(0f, _e955.member_3.member, (0f < _e963)), select(0f, _e955.member_3.member_1, (0f < _e967)), select(0f, _e955.member_3.member_2, (0f < _e971)), select(0f, _e955.member_3.member_3, (0f < _e975)));
            }
            let _e990 = phi_1005_;
            global_7.member[_e952] = _e990.member;
            if (_e544 > 1u) {
                global_7.member[(_e952 + 1u)] = _e990.member_1;
            }
            if (_e544 > 2u) {
                global_7.member[(_e952 + 2u)] = _e990.member_2;
            }
            if (_e544 > 3u) {
                global_7.member[(_e952 + 3u)] = _e990.member_3;
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
