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

struct type_13 {
    member: array<f32>,
}

struct type_18 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_5;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(1) 
var<storage> global_5: type_18;
@group(0) @binding(2) 
var<storage> global_6: type_13;
@group(0) @binding(4) 
var<storage, read_write> global_7: type_13;

fn function_() {
    var phi_116_: u32;
    var phi_119_: u32;
    var phi_121_: type_10;
    var phi_123_: type_10;
    var local: type_10;
    var phi_582_: type_9;
    var local_1: type_10;
    var phi_642_: type_9;
    var local_2: type_10;
    var phi_702_: type_9;
    var local_3: type_10;
    var phi_762_: type_9;
    var local_4: type_10;
    var phi_823_: type_9;
    var local_5: type_10;
    var phi_883_: type_9;
    var local_6: type_10;
    var phi_943_: type_9;
    var local_7: type_10;
    var phi_1003_: type_9;
    var local_8: u32;
    var local_9: u32;
    var local_10: type_10;
    var local_11: type_10;

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
        phi_116_ = 0u;
        phi_119_ = _e32;
        phi_121_ = type_10(type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f));
        phi_123_ = type_10(type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f), type_9(0f, 0f, 0f, 0f));
        loop {
            let _e93 = phi_116_;
            let _e95 = phi_119_;
            let _e97 = phi_121_;
            let _e99 = phi_123_;
            local = _e99;
            local_1 = _e99;
            local_2 = _e99;
            local_3 = _e99;
            local_4 = _e97;
            local_5 = _e97;
            local_6 = _e97;
            local_7 = _e97;
            if (_e93 < _e52) {
                let _e103 = global_3.member.member_1;
                let _e106 = global_4.member[_e95];
                let _e110 = global_4.member[(_e95 + 1u)];
                let _e114 = global_4.member[(_e95 + 2u)];
                let _e118 = global_4.member[(_e95 + 3u)];
                let _e119 = (_e95 + _e103);
                let _e122 = global_4.member[_e119];
                let _e126 = global_4.member[(_e119 + 1u)];
                let _e130 = global_4.member[(_e119 + 2u)];
                let _e134 = global_4.member[(_e119 + 3u)];
                let _e136 = (_e95 + (2u * _e103));
                let _e139 = global_4.member[_e136];
                let _e143 = global_4.member[(_e136 + 1u)];
                let _e147 = global_4.member[(_e136 + 2u)];
                let _e151 = global_4.member[(_e136 + 3u)];
                let _e153 = (_e95 + (3u * _e103));
                let _e156 = global_4.member[_e153];
                let _e160 = global_4.member[(_e153 + 1u)];
                let _e164 = global_4.member[(_e153 + 2u)];
                let _e168 = global_4.member[(_e153 + 3u)];
                let _e172 = global_5.member[((_e49 + (select(_e46, _e42, (_e42 < _e46)) * _e52)) + _e93)];
                let _e176 = global_5.member[((_e49 + (select(_e46, _e57, (_e57 < _e46)) * _e52)) + _e93)];
                let _e180 = global_5.member[((_e49 + (select(_e46, _e62, (_e62 < _e46)) * _e52)) + _e93)];
                let _e184 = global_5.member[((_e49 + (select(_e46, _e67, (_e67 < _e46)) * _e52)) + _e93)];
                let _e357 = global_5.member[((_e49 + (select(_e46, _e72, (_e72 < _e46)) * _e52)) + _e93)];
                let _e361 = global_5.member[((_e49 + (select(_e46, _e77, (_e77 < _e46)) * _e52)) + _e93)];
                let _e365 = global_5.member[((_e49 + (select(_e46, _e82, (_e82 < _e46)) * _e52)) + _e93)];
                let _e369 = global_5.member[((_e49 + (select(_e46, _e87, (_e87 < _e46)) * _e52)) + _e93)];
                local_8 = (_e93 + 1u);
                local_9 = (_e95 + (4u * _e103));
                local_10 = type_10(type_9(((_e156 * _e357.w) + ((_e139 * _e357.z) + ((_e122 * _e357.y) + ((_e106 * _e357.x) + _e97.member.member)))), ((_e160 * _e357.w) + ((_e143 * _e357.z) + ((_e126 * _e357.y) + ((_e110 * _e357.x) + _e97.member.member_1)))), ((_e164 * _e357.w) + ((_e147 * _e357.z) + ((_e130 * _e357.y) + ((_e114 * _e357.x) + _e97.member.member_2)))), ((_e168 * _e357.w) + ((_e151 * _e357.z) + ((_e134 * _e357.y) + ((_e118 * _e357.x) + _e97.member.member_3))))), type_9(((_e156 * _e361.w) + ((_e139 * _e361.z) + ((_e122 * _e361.y) + ((_e106 * _e361.x) + _e97.member_1.member)))), ((_e160 * _e361.w) + ((_e143 * _e361.z) + ((_e126 * _e361.y) + ((_e110 * _e361.x) + _e97.member_1.member_1)))), ((_e164 * _e361.w) + ((_e147 * _e361.z) + ((_e130 * _e361.y) + ((_e114 * _e361.x) + _e97.member_1.member_2)))), ((_e168 * _e361.w) + ((_e151 * _e361.z) + ((_e134 * _e361.y) + ((_e118 * _e361.x) + _e97.member_1.member_3))))), type_9(((_e156 * _e365.w) + ((_e139 * _e365.z) + ((_e122 * _e365.y) + ((_e106 * _e365.x) + _e97.member_2.member)))), ((_e160 * _e365.w) + ((_e143 * _e365.z) + ((_e126 * _e365.y) + ((_e110 * _e365.x) + _e97.member_2.member_1)))), ((_e164 * _e365.w) + ((_e147 * _e365.z) + ((_e130 * _e365.y) + ((_e114 * _e365.x) + _e97.member_2.member_2)))), ((_e168 * _e365.w) + ((_e151 * _e365.z) + ((_e134 * _e365.y) + ((_e118 * _e365.x) + _e97.member_2.member_3))))), type_9(((_e156 * _e369.w) + ((_e139 * _e369.z) + ((_e122 * _e369.y) + ((_e106 * _e369.x) + _e97.member_3.member)))), ((_e160 * _e369.w) + ((_e143 * _e369.z) + ((_e126 * _e369.y) + ((_e110 * _e369.x) + _e97.member_3.member_1)))), ((_e164 * _e369.w) + ((_e147 * _e369.z) + ((_e130 * _e369.y) + ((_e114 * _e369.x) + _e97.member_3.member_2)))), ((_e168 * _e369.w) + ((_e151 * _e369.z) + ((_e134 * _e369.y) + ((_e118 * _e369.x) + _e97.member_3.member_3))))));
                local_11 = type_10(type_9(((_e156 * _e172.w) + ((_e139 * _e172.z) + ((_e122 * _e172.y) + ((_e106 * _e172.x) + _e99.member.member)))), ((_e160 * _e172.w) + ((_e143 * _e172.z) + ((_e126 * _e172.y) + ((_e110 * _e172.x) + _e99.member.member_1)))), ((_e164 * _e172.w) + ((_e147 * _e172.z) + ((_e130 * _e172.y) + ((_e114 * _e172.x) + _e99.member.member_2)))), ((_e168 * _e172.w) + ((_e151 * _e172.z) + ((_e134 * _e172.y) + ((_e118 * _e172.x) + _e99.member.member_3))))), type_9(((_e156 * _e176.w) + ((_e139 * _e176.z) + ((_e122 * _e176.y) + ((_e106 * _e176.x) + _e99.member_1.member)))), ((_e160 * _e176.w) + ((_e143 * _e176.z) + ((_e126 * _e176.y) + ((_e110 * _e176.x) + _e99.member_1.member_1)))), ((_e164 * _e176.w) + ((_e147 * _e176.z) + ((_e130 * _e176.y) + ((_e114 * _e176.x) + _e99.member_1.member_2)))), ((_e168 * _e176.w) + ((_e151 * _e176.z) + ((_e134 * _e176.y) + ((_e118 * _e176.x) + _e99.member_1.member_3))))), type_9(((_e156 * _e180.w) + ((_e139 * _e180.z) + ((_e122 * _e180.y) + ((_e106 * _e180.x) + _e99.member_2.member)))), ((_e160 * _e180.w) + ((_e143 * _e180.z) + ((_e126 * _e180.y) + ((_e110 * _e180.x) + _e99.member_2.member_1)))), ((_e164 * _e180.w) + ((_e147 * _e180.z) + ((_e130 * _e180.y) + ((_e114 * _e180.x) + _e99.member_2.member_2)))), ((_e168 * _e180.w) + ((_e151 * _e180.z) + ((_e134 * _e180.y) + ((_e118 * _e180.x) + _e99.member_2.member_3))))), type_9(((_e156 * _e184.w) + ((_e139 * _e184.z) + ((_e122 * _e184.y) + ((_e106 * _e184.x) + _e99.member_3.member)))), ((_e160 * _e184.w) + ((_e143 * _e184.z) + ((_e126 * _e184.y) + ((_e110 * _e184.x) + _e99.member_3.member_1)))), ((_e164 * _e184.w) + ((_e147 * _e184.z) + ((_e130 * _e184.y) + ((_e114 * _e184.x) + _e99.member_3.member_2)))), ((_e168 * _e184.w) + ((_e151 * _e184.z) + ((_e134 * _e184.y) + ((_e118 * _e184.x) + _e99.member_3.member_3))))));
                continue;
            } else {
                break;
            }
            continuing {
                let _e1009 = local_8;
                phi_116_ = _e1009;
                let _e1012 = local_9;
                phi_119_ = _e1012;
                let _e1015 = local_10;
                phi_121_ = _e1015;
                let _e1018 = local_11;
                phi_123_ = _e1018;
            }
        }
        let _e542 = (_e35 - _e32);
        let _e545 = global_3.member.member_1;
        let _e547 = ((_e42 * _e545) + _e32);
        let _e550 = global_3.member.member_6;
        if (_e42 < _e550) {
            let _e553 = local;
            let _e557 = global_3.member.member_7;
            if (_e557 == 0u) {
                phi_582_ = _e553.member;
            } else {
                let _e561 = global_6.member[_e547];
                let _e565 = global_6.member[(_e547 + 1u)];
                let _e569 = global_6.member[(_e547 + 2u)];
                let _e573 = global_6.member[(_e547 + 3u)];
                phi_582_ = type_9(select(0f, _e553.member.member, (0f < _e561)), select(0f, _e553.member.member_1, (0f < _e565)), select(0f, _e553.member.member_2, (0f < _e569)), select(0f, _e553.member.member_3, (0f < _e573)));
            }
            let _e588 = phi_582_;
            global_7.member[_e547] = _e588.member;
            if (_e542 > 1u) {
                global_7.member[(_e547 + 1u)] = _e588.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e547 + 2u)] = _e588.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e547 + 3u)] = _e588.member_3;
            }
        }
        let _e607 = (_e547 + _e545);
        if (_e57 < _e550) {
            let _e610 = local_1;
            let _e614 = global_3.member.member_7;
            if (_e614 == 0u) {
                phi_642_ = _e610.member_1;
            } else {
                let _e618 = global_6.member[_e607];
                let _e622 = global_6.member[(_e607 + 1u)];
                let _e626 = global_6.member[(_e607 + 2u)];
                let _e630 = global_6.member[(_e607 + 3u)];
                phi_642_ = type_9(select(0f, _e610.member_1.member, (0f < _e618)), select(0f, _e610.member_1.member_1, (0f < _e622)), select(0f, _e610.member_1.member_2, (0f < _e626)), select(0f, _e610.member_1.member_3, (0f < _e630)));
            }
            let _e645 = phi_642_;
            global_7.member[_e607] = _e645.member;
            if (_e542 > 1u) {
                global_7.member[(_e607 + 1u)] = _e645.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e607 + 2u)] = _e645.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e607 + 3u)] = _e645.member_3;
            }
        }
        let _e664 = (_e607 + _e545);
        if (_e62 < _e550) {
            let _e667 = local_2;
            let _e671 = global_3.member.member_7;
            if (_e671 == 0u) {
                phi_702_ = _e667.member_2;
            } else {
                let _e675 = global_6.member[_e664];
                let _e679 = global_6.member[(_e664 + 1u)];
                let _e683 = global_6.member[(_e664 + 2u)];
                let _e687 = global_6.member[(_e664 + 3u)];
                phi_702_ = type_9(select(0f, _e667.member_2.member, (0f < _e675)), select(0f, _e667.member_2.member_1, (0f < _e679)), select(0f, _e667.member_2.member_2, (0f < _e683)), select(0f, _e667.member_2.member_3, (0f < _e687)));
            }
            let _e702 = phi_702_;
            global_7.member[_e664] = _e702.member;
            if (_e542 > 1u) {
                global_7.member[(_e664 + 1u)] = _e702.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e664 + 2u)] = _e702.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e664 + 3u)] = _e702.member_3;
            }
        }
        let _e721 = (_e664 + _e545);
        if (_e67 < _e550) {
            let _e724 = local_3;
            let _e728 = global_3.member.member_7;
            if (_e728 == 0u) {
                phi_762_ = _e724.member_3;
            } else {
                let _e732 = global_6.member[_e721];
                let _e736 = global_6.member[(_e721 + 1u)];
                let _e740 = global_6.member[(_e721 + 2u)];
                let _e744 = global_6.member[(_e721 + 3u)];
                phi_762_ = type_9(select(0f, _e724.member_3.member, (0f < _e732)), select(0f, _e724.member_3.member_1, (0f < _e736)), select(0f, _e724.member_3.member_2, (0f < _e740)), select(0f, _e724.member_3.member_3, (0f < _e744)));
            }
            let _e759 = phi_762_;
            global_7.member[_e721] = _e759.member;
            if (_e542 > 1u) {
                global_7.member[(_e721 + 1u)] = _e759.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e721 + 2u)] = _e759.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e721 + 3u)] = _e759.member_3;
            }
        }
        let _e779 = ((_e72 * _e545) + _e32);
        if (_e72 < _e550) {
            let _e782 = local_4;
            let _e786 = global_3.member.member_7;
            if (_e786 == 0u) {
                phi_823_ = _e782.member;
            } else {
                let _e790 = global_6.member[_e779];
                let _e794 = global_6.member[(_e779 + 1u)];
                let _e798 = global_6.member[(_e779 + 2u)];
                let _e802 = global_6.member[(_e779 + 3u)];
                phi_823_ = type_9(select(0f, _e782.member.member, (0f < _e790)), select(0f, _e782.member.member_1, (0f < _e794)), select(0f, _e782.member.member_2, (0f < _e798)), select(0f, _e782.member.member_3, (0f < _e802)));
            }
            let _e817 = phi_823_;
            global_7.member[_e779] = _e817.member;
            if (_e542 > 1u) {
                global_7.member[(_e779 + 1u)] = _e817.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e779 + 2u)] = _e817.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e779 + 3u)] = _e817.member_3;
            }
        }
        let _e836 = (_e779 + _e545);
        if (_e77 < _e550) {
            let _e839 = local_5;
            let _e843 = global_3.member.member_7;
            if (_e843 == 0u) {
                phi_883_ = _e839.member_1;
            } else {
                let _e847 = global_6.member[_e836];
                let _e851 = global_6.member[(_e836 + 1u)];
                let _e855 = global_6.member[(_e836 + 2u)];
                let _e859 = global_6.member[(_e836 + 3u)];
                phi_883_ = type_9(select(0f, _e839.member_1.member, (0f < _e847)), select(0f, _e839.member_1.member_1, (0f < _e851)), select(0f, _e839.member_1.member_2, (0f < _e855)), select(0f, _e839.member_1.member_3, (0f < _e859)));
            }
            let _e874 = phi_883_;
            global_7.member[_e836] = _e874.member;
            if (_e542 > 1u) {
                global_7.member[(_e836 + 1u)] = _e874.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e836 + 2u)] = _e874.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e836 + 3u)] = _e874.member_3;
            }
        }
        let _e893 = (_e836 + _e545);
        if (_e82 < _e550) {
            let _e896 = local_6;
            let _e900 = global_3.member.member_7;
            if (_e900 == 0u) {
                phi_943_ = _e896.member_2;
            } else {
                let _e904 = global_6.member[_e893];
                let _e908 = global_6.member[(_e893 + 1u)];
                let _e912 = global_6.member[(_e893 + 2u)];
                let _e916 = global_6.member[(_e893 + 3u)];
                phi_943_ = type_9(select(0f, _e896.member_2.member, (0f < _e904)), select(0f, _e896.member_2.member_1, (0f < _e908)), select(0f, _e896.member_2.member_2, (0f < _e912)), select(0f, _e896.member_2.member_3, (0f < _e916)));
            }
            let _e931 = phi_943_;
            global_7.member[_e893] = _e931.member;
            if (_e542 > 1u) {
                global_7.member[(_e893 + 1u)] = _e931.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e893 + 2u)] = _e931.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e893 + 3u)] = _e931.member_3;
            }
        }
        let _e950 = (_e893 + _e545);
        if (_e87 < _e550) {
            let _e953 = local_7;
            let _e957 = global_3.member.member_7;
            if (_e957 == 0u) {
                phi_1003_ = _e953.member_3;
            } else {
                let _e961 = global_6.member[_e950];
                let _e965 = global_6.member[(_e950 + 1u)];
                let _e969 = global_6.member[(_e950 + 2u)];
                let _e973 = global_6.member[(_e950 + 3u)];
                phi_1003_ = type_9(select(0f, _e953.member_3.member, (0f < _e961)), select(0f, _e953.member_3.member_1, (0f < _e965)), select(0f, _e953.member_3.member_2, (0f < _e969)), select(0f, _e953.member_3.member_3, (0f < _e973)));
            }
            let _e988 = phi_1003_;
            global_7.member[_e950] = _e988.member;
            if (_e542 > 1u) {
                global_7.member[(_e950 + 1u)] = _e988.member_1;
            }
            if (_e542 > 2u) {
                global_7.member[(_e950 + 2u)] = _e988.member_2;
            }
            if (_e542 > 3u) {
                global_7.member[(_e950 + 3u)] = _e988.member_3;
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
