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
    var phi_119_: u32;
    var phi_122_: u32;
    var phi_124_: type_19;
    var phi_126_: type_19;
    var local: type_19;
    var phi_591_: type_15;
    var local_1: type_19;
    var phi_651_: type_15;
    var local_2: type_19;
    var phi_711_: type_15;
    var local_3: type_19;
    var phi_771_: type_15;
    var local_4: type_19;
    var phi_832_: type_15;
    var local_5: type_19;
    var phi_892_: type_15;
    var local_6: type_19;
    var phi_952_: type_15;
    var local_7: type_19;
    var phi_1012_: type_15;

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
            let _e102 = (_e95 < _e54);
            if _e102 {
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
                phi_119_ = (_e95 + 1u);
                phi_122_ = (_e97 + (4u * _e105));
                phi_124_ = type_19(type_15(((_e158 * _e359.w) + ((_e141 * _e359.z) + ((_e124 * _e359.y) + ((_e108 * _e359.x) + _e99.member.member)))), ((_e162 * _e359.w) + ((_e145 * _e359.z) + ((_e128 * _e359.y) + ((_e112 * _e359.x) + _e99.member.member_1)))), ((_e166 * _e359.w) + ((_e149 * _e359.z) + ((_e132 * _e359.y) + ((_e116 * _e359.x) + _e99.member.member_2)))), ((_e170 * _e359.w) + ((_e153 * _e359.z) + ((_e136 * _e359.y) + ((_e120 * _e359.x) + _e99.member.member_3))))), type_15(((_e158 * _e363.w) + ((_e141 * _e363.z) + ((_e124 * _e363.y) + ((_e108 * _e363.x) + _e99.member_1.member)))), ((_e162 * _e363.w) + ((_e145 * _e363.z) + ((_e128 * _e363.y) + ((_e112 * _e363.x) + _e99.member_1.member_1)))), ((_e166 * _e363.w) + ((_e149 * _e363.z) + ((_e132 * _e363.y) + ((_e116 * _e363.x) + _e99.member_1.member_2)))), ((_e170 * _e363.w) + ((_e153 * _e363.z) + ((_e136 * _e363.y) + ((_e120 * _e363.x) + _e99.member_1.member_3))))), type_15(((_e158 * _e367.w) + ((_e141 * _e367.z) + ((_e124 * _e367.y) + ((_e108 * _e367.x) + _e99.member_2.member)))), ((_e162 * _e367.w) + ((_e145 * _e367.z) + ((_e128 * _e367.y) + ((_e112 * _e367.x) + _e99.member_2.member_1)))), ((_e166 * _e367.w) + ((_e149 * _e367.z) + ((_e132 * _e367.y) + ((_e116 * _e367.x) + _e99.member_2.member_2)))), ((_e170 * _e367.w) + ((_e153 * _e367.z) + ((_e136 * _e367.y) + ((_e120 * _e367.x) + _e99.member_2.member_3))))), type_15(((_e158 * _e371.w) + ((_e141 * _e371.z) + ((_e124 * _e371.y) + ((_e108 * _e371.x) + _e99.member_3.member)))), ((_e162 * _e371.w) + ((_e145 * _e371.z) + ((_e128 * _e371.y) + ((_e112 * _e371.x) + _e99.member_3.member_1)))), ((_e166 * _e371.w) + ((_e149 * _e371.z) + ((_e132 * _e371.y) + ((_e116 * _e371.x) + _e99.member_3.member_2)))), ((_e170 * _e371.w) + ((_e153 * _e371.z) + ((_e136 * _e371.y) + ((_e120 * _e371.x) + _e99.member_3.member_3))))));
                phi_126_ = type_19(type_15(((_e158 * _e174.w) + ((_e141 * _e174.z) + ((_e124 * _e174.y) + ((_e108 * _e174.x) + _e101.member.member)))), ((_e162 * _e174.w) + ((_e145 * _e174.z) + ((_e128 * _e174.y) + ((_e112 * _e174.x) + _e101.member.member_1)))), ((_e166 * _e174.w) + ((_e149 * _e174.z) + ((_e132 * _e174.y) + ((_e116 * _e174.x) + _e101.member.member_2)))), ((_e170 * _e174.w) + ((_e153 * _e174.z) + ((_e136 * _e174.y) + ((_e120 * _e174.x) + _e101.member.member_3))))), type_15(((_e158 * _e178.w) + ((_e141 * _e178.z) + ((_e124 * _e178.y) + ((_e108 * _e178.x) + _e101.member_1.member)))), ((_e162 * _e178.w) + ((_e145 * _e178.z) + ((_e128 * _e178.y) + ((_e112 * _e178.x) + _e101.member_1.member_1)))), ((_e166 * _e178.w) + ((_e149 * _e178.z) + ((_e132 * _e178.y) + ((_e116 * _e178.x) + _e101.member_1.member_2)))), ((_e170 * _e178.w) + ((_e153 * _e178.z) + ((_e136 * _e178.y) + ((_e120 * _e178.x) + _e101.member_1.member_3))))), type_15(((_e158 * _e182.w) + ((_e141 * _e182.z) + ((_e124 * _e182.y) + ((_e108 * _e182.x) + _e101.member_2.member)))), ((_e162 * _e182.w) + ((_e145 * _e182.z) + ((_e128 * _e182.y) + ((_e112 * _e182.x) + _e101.member_2.member_1)))), ((_e166 * _e182.w) + ((_e149 * _e182.z) + ((_e132 * _e182.y) + ((_e116 * _e182.x) + _e101.member_2.member_2)))), ((_e170 * _e182.w) + ((_e153 * _e182.z) + ((_e136 * _e182.y) + ((_e120 * _e182.x) + _e101.member_2.member_3))))), type_15(((_e158 * _e186.w) + ((_e141 * _e186.z) + ((_e124 * _e186.y) + ((_e108 * _e186.x) + _e101.member_3.member)))), ((_e162 * _e186.w) + ((_e145 * _e186.z) + ((_e128 * _e186.y) + ((_e112 * _e186.x) + _e101.member_3.member_1)))), ((_e166 * _e186.w) + ((_e149 * _e186.z) + ((_e132 * _e186.y) + ((_e116 * _e186.x) + _e101.member_3.member_2)))), ((_e170 * _e186.w) + ((_e153 * _e186.z) + ((_e136 * _e186.y) + ((_e120 * _e186.x) + _e101.member_3.member_3))))));
            } else {
                phi_119_ = u32();
                phi_122_ = u32();
                phi_124_ = type_19();
                phi_126_ = type_19();
            }
            let _e545 = phi_119_;
            let _e547 = phi_122_;
            let _e549 = phi_124_;
            let _e551 = phi_126_;
            continue;
            continuing {
                phi_118_ = _e545;
                phi_121_ = _e547;
                phi_123_ = _e549;
                phi_125_ = _e551;
                break if !(_e102);
            }
        }
        let _e553 = (_e37 - _e34);
        let _e556 = global_4.member.member_1;
        let _e558 = ((_e44 * _e556) + _e34);
        let _e561 = global_4.member.member_6;
        if (_e44 < _e561) {
            let _e564 = local;
            let _e568 = global_4.member.member_7;
            if (_e568 == 0u) {
                phi_591_ = _e564.member;
            } else {
                let _e572 = global_5.member[_e558];
                let _e576 = global_5.member[(_e558 + 1u)];
                let _e580 = global_5.member[(_e558 + 2u)];
                let _e584 = global_5.member[(_e558 + 3u)];
                phi_591_ = type_15(select(0f, _e564.member.member, (0f < _e572)), select(0f, _e564.member.member_1, (0f < _e576)), select(0f, _e564.member.member_2, (0f < _e580)), select(0f, _e564.member.member_3, (0f < _e584)));
            }
            let _e599 = phi_591_;
            global_7.member[_e558] = _e599.member;
            if (_e553 > 1u) {
                global_7.member[(_e558 + 1u)] = _e599.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e558 + 2u)] = _e599.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e558 + 3u)] = _e599.member_3;
            }
        }
        let _e618 = (_e558 + _e556);
        if (_e59 < _e561) {
            let _e621 = local_1;
            let _e625 = global_4.member.member_7;
            if (_e625 == 0u) {
                phi_651_ = _e621.member_1;
            } else {
                let _e629 = global_5.member[_e618];
                let _e633 = global_5.member[(_e618 + 1u)];
                let _e637 = global_5.member[(_e618 + 2u)];
                let _e641 = global_5.member[(_e618 + 3u)];
                phi_651_ = type_15(select(0f, _e621.member_1.member, (0f < _e629)), select(0f, _e621.member_1.member_1, (0f < _e633)), select(0f, _e621.member_1.member_2, (0f < _e637)), select(0f, _e621.member_1.member_3, (0f < _e641)));
            }
            let _e656 = phi_651_;
            global_7.member[_e618] = _e656.member;
            if (_e553 > 1u) {
                global_7.member[(_e618 + 1u)] = _e656.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e618 + 2u)] = _e656.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e618 + 3u)] = _e656.member_3;
            }
        }
        let _e675 = (_e618 + _e556);
        if (_e64 < _e561) {
            let _e678 = local_2;
            let _e682 = global_4.member.member_7;
            if (_e682 == 0u) {
                phi_711_ = _e678.member_2;
            } else {
                let _e686 = global_5.member[_e675];
                let _e690 = global_5.member[(_e675 + 1u)];
                let _e694 = global_5.member[(_e675 + 2u)];
                let _e698 = global_5.member[(_e675 + 3u)];
                phi_711_ = type_15(select(0f, _e678.member_2.member, (0f < _e686)), select(0f, _e678.member_2.member_1, (0f < _e690)), select(0f, _e678.member_2.member_2, (0f < _e694)), select(0f, _e678.member_2.member_3, (0f < _e698)));
            }
            let _e713 = phi_711_;
            global_7.member[_e675] = _e713.member;
            if (_e553 > 1u) {
                global_7.member[(_e675 + 1u)] = _e713.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e675 + 2u)] = _e713.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e675 + 3u)] = _e713.member_3;
            }
        }
        let _e732 = (_e675 + _e556);
        if (_e69 < _e561) {
            let _e735 = local_3;
            let _e739 = global_4.member.member_7;
            if (_e739 == 0u) {
                phi_771_ = _e735.member_3;
            } else {
                let _e743 = global_5.member[_e732];
                let _e747 = global_5.member[(_e732 + 1u)];
                let _e751 = global_5.member[(_e732 + 2u)];
                let _e755 = global_5.member[(_e732 + 3u)];
                phi_771_ = type_15(select(0f, _e735.member_3.member, (0f < _e743)), select(0f, _e735.member_3.member_1, (0f < _e747)), select(0f, _e735.member_3.member_2, (0f < _e751)), select(0f, _e735.member_3.member_3, (0f < _e755)));
            }
            let _e770 = phi_771_;
            global_7.member[_e732] = _e770.member;
            if (_e553 > 1u) {
                global_7.member[(_e732 + 1u)] = _e770.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e732 + 2u)] = _e770.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e732 + 3u)] = _e770.member_3;
            }
        }
        let _e790 = ((_e74 * _e556) + _e34);
        if (_e74 < _e561) {
            let _e793 = local_4;
            let _e797 = global_4.member.member_7;
            if (_e797 == 0u) {
                phi_832_ = _e793.member;
            } else {
                let _e801 = global_5.member[_e790];
                let _e805 = global_5.member[(_e790 + 1u)];
                let _e809 = global_5.member[(_e790 + 2u)];
                let _e813 = global_5.member[(_e790 + 3u)];
                phi_832_ = type_15(select(0f, _e793.member.member, (0f < _e801)), select(0f, _e793.member.member_1, (0f < _e805)), select(0f, _e793.member.member_2, (0f < _e809)), select(0f, _e793.member.member_3, (0f < _e813)));
            }
            let _e828 = phi_832_;
            global_7.member[_e790] = _e828.member;
            if (_e553 > 1u) {
                global_7.member[(_e790 + 1u)] = _e828.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e790 + 2u)] = _e828.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e790 + 3u)] = _e828.member_3;
            }
        }
        let _e847 = (_e790 + _e556);
        if (_e79 < _e561) {
            let _e850 = local_5;
            let _e854 = global_4.member.member_7;
            if (_e854 == 0u) {
                phi_892_ = _e850.member_1;
            } else {
                let _e858 = global_5.member[_e847];
                let _e862 = global_5.member[(_e847 + 1u)];
                let _e866 = global_5.member[(_e847 + 2u)];
                let _e870 = global_5.member[(_e847 + 3u)];
                phi_892_ = type_15(select(0f, _e850.member_1.member, (0f < _e858)), select(0f, _e850.member_1.member_1, (0f < _e862)), select(0f, _e850.member_1.member_2, (0f < _e866)), select(0f, _e850.member_1.member_3, (0f < _e870)));
            }
            let _e885 = phi_892_;
            global_7.member[_e847] = _e885.member;
            if (_e553 > 1u) {
                global_7.member[(_e847 + 1u)] = _e885.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e847 + 2u)] = _e885.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e847 + 3u)] = _e885.member_3;
            }
        }
        let _e904 = (_e847 + _e556);
        if (_e84 < _e561) {
            let _e907 = local_6;
            let _e911 = global_4.member.member_7;
            if (_e911 == 0u) {
                phi_952_ = _e907.member_2;
            } else {
                let _e915 = global_5.member[_e904];
                let _e919 = global_5.member[(_e904 + 1u)];
                let _e923 = global_5.member[(_e904 + 2u)];
                let _e927 = global_5.member[(_e904 + 3u)];
                phi_952_ = type_15(select(0f, _e907.member_2.member, (0f < _e915)), select(0f, _e907.member_2.member_1, (0f < _e919)), select(0f, _e907.member_2.member_2, (0f < _e923)), select(0f, _e907.member_2.member_3, (0f < _e927)));
            }
            let _e942 = phi_952_;
            global_7.member[_e904] = _e942.member;
            if (_e553 > 1u) {
                global_7.member[(_e904 + 1u)] = _e942.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e904 + 2u)] = _e942.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e904 + 3u)] = _e942.member_3;
            }
        }
        let _e961 = (_e904 + _e556);
        if (_e89 < _e561) {
            let _e964 = local_7;
            let _e968 = global_4.member.member_7;
            if (_e968 == 0u) {
                phi_1012_ = _e964.member_3;
            } else {
                let _e972 = global_5.member[_e961];
                let _e976 = global_5.member[(_e961 + 1u)];
                let _e980 = global_5.member[(_e961 + 2u)];
                let _e984 = global_5.member[(_e961 + 3u)];
                phi_1012_ = type_15(select(0f, _e964.member_3.member, (0f < _e972)), select(0f, _e964.member_3.member_1, (0f < _e976)), select(0f, _e964.member_3.member_2, (0f < _e980)), select(0f, _e964.member_3.member_3, (0f < _e984)));
            }
            let _e999 = phi_1012_;
            global_7.member[_e961] = _e999.member;
            if (_e553 > 1u) {
                global_7.member[(_e961 + 1u)] = _e999.member_1;
            }
            if (_e553 > 2u) {
                global_7.member[(_e961 + 2u)] = _e999.member_2;
            }
            if (_e553 > 3u) {
                global_7.member[(_e961 + 3u)] = _e999.member_3;
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
