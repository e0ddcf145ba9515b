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
var<workgroup> global_6: array<f32, 4096>;
@group(0) @binding(2) 
var<storage> global_7: type_17;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_17;

fn function_() {
    var phi_113_: u32;
    var phi_155_: u32;
    var phi_158_: u32;
    var phi_160_: u32;
    var phi_162_: type_14;
    var phi_164_: type_14;
    var phi_166_: type_14;
    var phi_168_: type_14;
    var local: type_14;
    var local_1: type_14;
    var local_2: type_14;
    var local_3: type_14;
    var local_4: type_14;
    var local_5: type_14;
    var local_6: type_14;
    var local_7: type_14;
    var local_8: type_14;
    var local_9: type_14;
    var local_10: type_14;
    var local_11: type_14;
    var local_12: type_14;
    var local_13: type_14;
    var local_14: type_14;
    var local_15: type_14;
    var phi_340_: u32;
    var phi_343_: f32;
    var phi_382_: u32;
    var phi_385_: u32;
    var phi_387_: u32;
    var phi_389_: type_14;
    var phi_391_: type_14;
    var phi_393_: type_14;
    var phi_395_: type_14;
    var local_16: type_14;
    var local_17: type_14;
    var local_18: type_14;
    var local_19: type_14;
    var local_20: type_14;
    var local_21: type_14;
    var local_22: type_14;
    var local_23: type_14;
    var local_24: type_14;
    var local_25: type_14;
    var local_26: type_14;
    var local_27: type_14;
    var local_28: type_14;
    var local_29: type_14;
    var local_30: type_14;
    var local_31: type_14;
    var phi_676_: u32;
    var phi_679_: f32;
    var phi_717_: u32;
    var phi_720_: u32;
    var phi_722_: u32;
    var phi_724_: type_14;
    var phi_726_: type_14;
    var phi_728_: type_14;
    var phi_730_: type_14;
    var local_32: type_14;
    var local_33: type_14;
    var local_34: type_14;
    var local_35: type_14;
    var local_36: type_14;
    var local_37: type_14;
    var local_38: type_14;
    var local_39: type_14;
    var local_40: type_14;
    var local_41: type_14;
    var local_42: type_14;
    var local_43: type_14;
    var local_44: type_14;
    var local_45: type_14;
    var local_46: type_14;
    var local_47: type_14;
    var phi_1003_: f32;
    var local_48: u32;
    var local_49: u32;
    var local_50: u32;
    var local_51: u32;
    var local_52: type_14;
    var local_53: type_14;
    var local_54: type_14;
    var local_55: type_14;
    var local_56: u32;
    var local_57: f32;
    var local_58: u32;
    var local_59: u32;
    var local_60: u32;
    var local_61: type_14;
    var local_62: type_14;
    var local_63: type_14;
    var local_64: type_14;
    var local_65: u32;
    var local_66: f32;
    var local_67: u32;
    var local_68: u32;
    var local_69: u32;
    var local_70: type_14;
    var local_71: type_14;
    var local_72: type_14;
    var local_73: type_14;
    var local_74: f32;
    var local_75: f32;

    let _e50 = global;
    let _e51 = global_1;
    let _e52 = global_2;
    let _e60 = (((_e51.x + (_e51.y * _e52.x)) * 64u) + _e50.x);
    let _e63 = global_3.member.member;
    if (_e60 < _e63) {
        let _e67 = global_3.member.member_2;
        let _e70 = global_3.member.member_3;
        let _e73 = global_3.member.member_4;
        let _e76 = global_3.member.member_5;
        let _e79 = global_3.member.member_6;
        let _e82 = global_3.member.member_7;
        let _e83 = (_e82 - 1u);
        if (_e73 > 0u) {
            phi_113_ = 0u;
            loop {
                let _e86 = phi_113_;
                if (_e86 < _e73) {
                    let _e89 = ((_e86 * 256u) + _e50.x);
                    let _e91 = ((_e70 * _e73) + _e86);
                    let _e94 = global_4.member[_e91];
                    let _e103 = global_4.member[(_e91 + 1u)];
                    let _e112 = global_4.member[(_e91 + 2u)];
                    let _e121 = global_4.member[(_e91 + 3u)];
                    phi_155_ = 0u;
                    phi_158_ = _e60;
                    phi_160_ = _e86;
                    phi_162_ = type_14(_e121.x, _e121.y, _e121.z, _e121.w);
                    phi_164_ = type_14(_e112.x, _e112.y, _e112.z, _e112.w);
                    phi_166_ = type_14(_e103.x, _e103.y, _e103.z, _e103.w);
                    phi_168_ = type_14(_e94.x, _e94.y, _e94.z, _e94.w);
                    loop {
                        let _e128 = phi_155_;
                        let _e130 = phi_158_;
                        let _e132 = phi_160_;
                        let _e134 = phi_162_;
                        let _e136 = phi_164_;
                        let _e138 = phi_166_;
                        let _e140 = phi_168_;
                        local = _e140;
                        local_1 = _e140;
                        local_2 = _e140;
                        local_3 = _e140;
                        local_4 = _e138;
                        local_5 = _e138;
                        local_6 = _e138;
                        local_7 = _e138;
                        local_8 = _e136;
                        local_9 = _e136;
                        local_10 = _e136;
                        local_11 = _e136;
                        local_12 = _e134;
                        local_13 = _e134;
                        local_14 = _e134;
                        local_15 = _e134;
                        if (_e128 < _e70) {
                            let _e144 = global_5.member[_e130];
                            let _e147 = global_4.member[_e132];
                            let _e168 = global_4.member[(_e132 + 1u)];
                            let _e189 = global_4.member[(_e132 + 2u)];
                            let _e210 = global_4.member[(_e132 + 3u)];
                            local_49 = (_e128 + 1u);
                            local_50 = (_e130 + _e67);
                            local_51 = (_e132 + _e73);
                            local_52 = type_14(((_e144 * _e210.x) + _e134.member), ((_e144 * _e210.y) + _e134.member_1), ((_e144 * _e210.z) + _e134.member_2), ((_e144 * _e210.w) + _e134.member_3));
                            local_53 = type_14(((_e144 * _e189.x) + _e136.member), ((_e144 * _e189.y) + _e136.member_1), ((_e144 * _e189.z) + _e136.member_2), ((_e144 * _e189.w) + _e136.member_3));
                            local_54 = type_14(((_e144 * _e168.x) + _e138.member), ((_e144 * _e168.y) + _e138.member_1), ((_e144 * _e168.z) + _e138.member_2), ((_e144 * _e168.w) + _e138.member_3));
                            local_55 = type_14(((_e144 * _e147.x) + _e140.member), ((_e144 * _e147.y) + _e140.member_1), ((_e144 * _e147.z) + _e140.member_2), ((_e144 * _e147.w) + _e140.member_3));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1182 = local_49;
                            phi_155_ = _e1182;
                            let _e1185 = local_50;
                            phi_158_ = _e1185;
                            let _e1188 = local_51;
                            phi_160_ = _e1188;
                            let _e1191 = local_52;
                            phi_162_ = _e1191;
                            let _e1194 = local_53;
                            phi_164_ = _e1194;
                            let _e1197 = local_54;
                            phi_166_ = _e1197;
                            let _e1200 = local_55;
                            phi_168_ = _e1200;
                        }
                    }
                    let _e232 = local;
                    global_6[_e89] = select(0f, _e232.member, (_e232.member > 0f));
                    let _e238 = local_1;
                    global_6[(_e89 + 64u)] = select(0f, _e238.member_1, (_e238.member_1 > 0f));
                    let _e245 = local_2;
                    global_6[(_e89 + 128u)] = select(0f, _e245.member_2, (_e245.member_2 > 0f));
                    let _e252 = local_3;
                    global_6[(_e89 + 192u)] = select(0f, _e252.member_3, (_e252.member_3 > 0f));
                    let _e260 = local_4;
                    global_6[(_e89 + 256u)] = select(0f, _e260.member, (_e260.member > 0f));
                    let _e266 = local_5;
                    global_6[(_e89 + 320u)] = select(0f, _e266.member_1, (_e266.member_1 > 0f));
                    let _e273 = local_6;
                    global_6[(_e89 + 384u)] = select(0f, _e273.member_2, (_e273.member_2 > 0f));
                    let _e280 = local_7;
                    global_6[(_e89 + 448u)] = select(0f, _e280.member_3, (_e280.member_3 > 0f));
                    let _e288 = local_8;
                    global_6[(_e89 + 512u)] = select(0f, _e288.member, (_e288.member > 0f));
                    let _e294 = local_9;
                    global_6[(_e89 + 576u)] = select(0f, _e294.member_1, (_e294.member_1 > 0f));
                    let _e301 = local_10;
                    global_6[(_e89 + 640u)] = select(0f, _e301.member_2, (_e301.member_2 > 0f));
                    let _e308 = local_11;
                    global_6[(_e89 + 704u)] = select(0f, _e308.member_3, (_e308.member_3 > 0f));
                    let _e316 = local_12;
                    global_6[(_e89 + 768u)] = select(0f, _e316.member, (_e316.member > 0f));
                    let _e322 = local_13;
                    global_6[(_e89 + 832u)] = select(0f, _e322.member_1, (_e322.member_1 > 0f));
                    let _e329 = local_14;
                    global_6[(_e89 + 896u)] = select(0f, _e329.member_2, (_e329.member_2 > 0f));
                    let _e336 = local_15;
                    global_6[(_e89 + 960u)] = select(0f, _e336.member_3, (_e336.member_3 > 0f));
                    local_48 = (_e86 + 4u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1179 = local_48;
                    phi_113_ = _e1179;
                }
            }
            let _e344 = ((_e70 * _e73) + _e73);
            let _e346 = (_e344 + (_e76 * _e79));
            let _e347 = (_e346 + _e79);
            let _e352 = global_4.member[((_e347 + _e83) + 1u)];
            phi_340_ = 0u;
            phi_343_ = _e352.x;
            loop {
                let _e355 = phi_340_;
                let _e357 = phi_343_;
                local_74 = _e357;
                if (_e355 < _e79) {
                    let _e359 = (_e346 + _e355);
                    let _e362 = global_4.member[_e359];
                    let _e371 = global_4.member[(_e359 + 1u)];
                    let _e380 = global_4.member[(_e359 + 2u)];
                    let _e389 = global_4.member[(_e359 + 3u)];
                    phi_382_ = 0u;
                    phi_385_ = _e50.x;
                    phi_387_ = (_e344 + _e355);
                    phi_389_ = type_14(_e389.x, _e389.y, _e389.z, _e389.w);
                    phi_391_ = type_14(_e380.x, _e380.y, _e380.z, _e380.w);
                    phi_393_ = type_14(_e371.x, _e371.y, _e371.z, _e371.w);
                    phi_395_ = type_14(_e362.x, _e362.y, _e362.z, _e362.w);
                    loop {
                        let _e397 = phi_382_;
                        let _e399 = phi_385_;
                        let _e401 = phi_387_;
                        let _e403 = phi_389_;
                        let _e405 = phi_391_;
                        let _e407 = phi_393_;
                        let _e409 = phi_395_;
                        local_16 = _e409;
                        local_17 = _e409;
                        local_18 = _e409;
                        local_19 = _e409;
                        local_20 = _e407;
                        local_21 = _e407;
                        local_22 = _e407;
                        local_23 = _e407;
                        local_24 = _e405;
                        local_25 = _e405;
                        local_26 = _e405;
                        local_27 = _e405;
                        local_28 = _e403;
                        local_29 = _e403;
                        local_30 = _e403;
                        local_31 = _e403;
                        if (_e397 < _e76) {
                            let _e412 = global_6[_e399];
                            let _e415 = global_4.member[_e401];
                            let _e436 = global_4.member[(_e401 + 1u)];
                            let _e457 = global_4.member[(_e401 + 2u)];
                            let _e478 = global_4.member[(_e401 + 3u)];
                            local_58 = (_e397 + 1u);
                            local_59 = (_e399 + 64u);
                            local_60 = (_e401 + _e79);
                            local_61 = type_14(((_e412 * _e478.x) + _e403.member), ((_e412 * _e478.y) + _e403.member_1), ((_e412 * _e478.z) + _e403.member_2), ((_e412 * _e478.w) + _e403.member_3));
                            local_62 = type_14(((_e412 * _e457.x) + _e405.member), ((_e412 * _e457.y) + _e405.member_1), ((_e412 * _e457.z) + _e405.member_2), ((_e412 * _e457.w) + _e405.member_3));
                            local_63 = type_14(((_e412 * _e436.x) + _e407.member), ((_e412 * _e436.y) + _e407.member_1), ((_e412 * _e436.z) + _e407.member_2), ((_e412 * _e436.w) + _e407.member_3));
                            local_64 = type_14(((_e412 * _e415.x) + _e409.member), ((_e412 * _e415.y) + _e409.member_1), ((_e412 * _e415.z) + _e409.member_2), ((_e412 * _e415.w) + _e409.member_3));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1225 = local_58;
                            phi_382_ = _e1225;
                            let _e1228 = local_59;
                            phi_385_ = _e1228;
                            let _e1231 = local_60;
                            phi_387_ = _e1231;
                            let _e1234 = local_61;
                            phi_389_ = _e1234;
                            let _e1237 = local_62;
                            phi_391_ = _e1237;
                            let _e1240 = local_63;
                            phi_393_ = _e1240;
                            let _e1243 = local_64;
                            phi_395_ = _e1243;
                        }
                    }
                    let _e499 = (4u * _e355);
                    let _e501 = local_16;
                    let _e508 = global_4.member[(_e347 + select(_e83, _e499, (_e499 < _e83)))];
                    let _e514 = (_e499 + 1u);
                    let _e516 = local_17;
                    let _e523 = global_4.member[(_e347 + select(_e83, _e514, (_e514 < _e83)))];
                    let _e529 = (_e499 + 2u);
                    let _e531 = local_18;
                    let _e538 = global_4.member[(_e347 + select(_e83, _e529, (_e529 < _e83)))];
                    let _e544 = (_e499 + 3u);
                    let _e546 = local_19;
                    let _e553 = global_4.member[(_e347 + select(_e83, _e544, (_e544 < _e83)))];
                    let _e559 = (_e499 + 4u);
                    let _e561 = local_20;
                    let _e568 = global_4.member[(_e347 + select(_e83, _e559, (_e559 < _e83)))];
                    let _e574 = (_e499 + 5u);
                    let _e576 = local_21;
                    let _e583 = global_4.member[(_e347 + select(_e83, _e574, (_e574 < _e83)))];
                    let _e589 = (_e499 + 6u);
                    let _e591 = local_22;
                    let _e598 = global_4.member[(_e347 + select(_e83, _e589, (_e589 < _e83)))];
                    let _e604 = (_e499 + 7u);
                    let _e606 = local_23;
                    let _e613 = global_4.member[(_e347 + select(_e83, _e604, (_e604 < _e83)))];
                    let _e619 = (_e499 + 8u);
                    let _e621 = local_24;
                    let _e628 = global_4.member[(_e347 + select(_e83, _e619, (_e619 < _e83)))];
                    let _e634 = (_e499 + 9u);
                    let _e636 = local_25;
                    let _e643 = global_4.member[(_e347 + select(_e83, _e634, (_e634 < _e83)))];
                    let _e649 = (_e499 + 10u);
                    let _e651 = local_26;
                    let _e658 = global_4.member[(_e347 + select(_e83, _e649, (_e649 < _e83)))];
                    let _e664 = (_e499 + 11u);
                    let _e666 = local_27;
                    let _e673 = global_4.member[(_e347 + select(_e83, _e664, (_e664 < _e83)))];
                    let _e679 = (_e499 + 12u);
                    let _e681 = local_28;
                    let _e688 = global_4.member[(_e347 + select(_e83, _e679, (_e679 < _e83)))];
                    let _e694 = (_e499 + 13u);
                    let _e696 = local_29;
                    let _e703 = global_4.member[(_e347 + select(_e83, _e694, (_e694 < _e83)))];
                    let _e709 = (_e499 + 14u);
                    let _e711 = local_30;
                    let _e718 = global_4.member[(_e347 + select(_e83, _e709, (_e709 < _e83)))];
                    let _e724 = (_e499 + 15u);
                    let _e726 = local_31;
                    let _e733 = global_4.member[(_e347 + select(_e83, _e724, (_e724 < _e83)))];
                    local_56 = (_e355 + 4u);
                    local_57 = ((select(0f, _e726.member_3, (_e726.member_3 > 0f)) * _e733.x) + ((select(0f, _e711.member_2, (_e711.member_2 > 0f)) * _e718.x) + ((select(0f, _e696.member_1, (_e696.member_1 > 0f)) * _e703.x) + ((select(0f, _e681.member, (_e681.member > 0f)) * _e688.x) + ((select(0f, _e666.member_3, (_e666.member_3 > 0f)) * _e673.x) + ((select(0f, _e651.member_2, (_e651.member_2 > 0f)) * _e658.x) + ((select(0f, _e636.member_1, (_e636.member_1 > 0f)) * _e643.x) + ((select(0f, _e621.member, (_e621.member > 0f)) * _e628.x) + ((select(0f, _e606.member_3, (_e606.member_3 > 0f)) * _e613.x) + ((select(0f, _e591.member_2, (_e591.member_2 > 0f)) * _e598.x) + ((select(0f, _e576.member_1, (_e576.member_1 > 0f)) * _e583.x) + ((select(0f, _e561.member, (_e561.member > 0f)) * _e568.x) + ((select(0f, _e546.member_3, (_e546.member_3 > 0f)) * _e553.x) + ((select(0f, _e531.member_2, (_e531.member_2 > 0f)) * _e538.x) + ((select(0f, _e516.member_1, (_e516.member_1 > 0f)) * _e523.x) + ((select(0f, _e501.member, (_e501.member > 0f)) * _e508.x) + _e357))))))))))))))));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1219 = local_56;
                    phi_340_ = _e1219;
                    let _e1222 = local_57;
                    phi_343_ = _e1222;
                }
            }
            let _e1305 = local_74;
            phi_1003_ = _e1305;
        } else {
            let _e740 = (_e76 * _e79);
            let _e741 = (_e740 + _e79);
            let _e746 = global_4.member[((_e741 + _e83) + 1u)];
            phi_676_ = 0u;
            phi_679_ = _e746.x;
            loop {
                let _e749 = phi_676_;
                let _e751 = phi_679_;
                local_75 = _e751;
                if (_e749 < _e79) {
                    let _e753 = (_e740 + _e749);
                    let _e756 = global_4.member[_e753];
                    let _e765 = global_4.member[(_e753 + 1u)];
                    let _e774 = global_4.member[(_e753 + 2u)];
                    let _e783 = global_4.member[(_e753 + 3u)];
                    phi_717_ = 0u;
                    phi_720_ = _e60;
                    phi_722_ = _e749;
                    phi_724_ = type_14(_e783.x, _e783.y, _e783.z, _e783.w);
                    phi_726_ = type_14(_e774.x, _e774.y, _e774.z, _e774.w);
                    phi_728_ = type_14(_e765.x, _e765.y, _e765.z, _e765.w);
                    phi_730_ = type_14(_e756.x, _e756.y, _e756.z, _e756.w);
                    loop {
                        let _e790 = phi_717_;
                        let _e792 = phi_720_;
                        let _e794 = phi_722_;
                        let _e796 = phi_724_;
                        let _e798 = phi_726_;
                        let _e800 = phi_728_;
                        let _e802 = phi_730_;
                        local_32 = _e802;
                        local_33 = _e802;
                        local_34 = _e802;
                        local_35 = _e802;
                        local_36 = _e800;
                        local_37 = _e800;
                        local_38 = _e800;
                        local_39 = _e800;
                        local_40 = _e798;
                        local_41 = _e798;
                        local_42 = _e798;
                        local_43 = _e798;
                        local_44 = _e796;
                        local_45 = _e796;
                        local_46 = _e796;
                        local_47 = _e796;
                        if (_e790 < _e76) {
                            let _e806 = global_5.member[_e792];
                            let _e809 = global_4.member[_e794];
                            let _e830 = global_4.member[(_e794 + 1u)];
                            let _e851 = global_4.member[(_e794 + 2u)];
                            let _e872 = global_4.member[(_e794 + 3u)];
                            local_67 = (_e790 + 1u);
                            local_68 = (_e792 + _e67);
                            local_69 = (_e794 + _e79);
                            local_70 = type_14(((_e806 * _e872.x) + _e796.member), ((_e806 * _e872.y) + _e796.member_1), ((_e806 * _e872.z) + _e796.member_2), ((_e806 * _e872.w) + _e796.member_3));
                            local_71 = type_14(((_e806 * _e851.x) + _e798.member), ((_e806 * _e851.y) + _e798.member_1), ((_e806 * _e851.z) + _e798.member_2), ((_e806 * _e851.w) + _e798.member_3));
                            local_72 = type_14(((_e806 * _e830.x) + _e800.member), ((_e806 * _e830.y) + _e800.member_1), ((_e806 * _e830.z) + _e800.member_2), ((_e806 * _e830.w) + _e800.member_3));
                            local_73 = type_14(((_e806 * _e809.x) + _e802.member), ((_e806 * _e809.y) + _e802.member_1), ((_e806 * _e809.z) + _e802.member_2), ((_e806 * _e809.w) + _e802.member_3));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1268 = local_67;
                            phi_717_ = _e1268;
                            let _e1271 = local_68;
                            phi_720_ = _e1271;
                            let _e1274 = local_69;
                            phi_722_ = _e1274;
                            let _e1277 = local_70;
                            phi_724_ = _e1277;
                            let _e1280 = local_71;
                            phi_726_ = _e1280;
                            let _e1283 = local_72;
                            phi_728_ = _e1283;
                            let _e1286 = local_73;
                            phi_730_ = _e1286;
                        }
                    }
                    let _e893 = (4u * _e749);
                    let _e895 = local_32;
                    let _e902 = global_4.member[(_e741 + select(_e83, _e893, (_e893 < _e83)))];
                    let _e908 = (_e893 + 1u);
                    let _e910 = local_33;
                    let _e917 = global_4.member[(_e741 + select(_e83, _e908, (_e908 < _e83)))];
                    let _e923 = (_e893 + 2u);
                    let _e925 = local_34;
                    let _e932 = global_4.member[(_e741 + select(_e83, _e923, (_e923 < _e83)))];
                    let _e938 = (_e893 + 3u);
                    let _e940 = local_35;
                    let _e947 = global_4.member[(_e741 + select(_e83, _e938, (_e938 < _e83)))];
                    let _e953 = (_e893 + 4u);
                    let _e955 = local_36;
                    let _e962 = global_4.member[(_e741 + select(_e83, _e953, (_e953 < _e83)))];
                    let _e968 = (_e893 + 5u);
                    let _e970 = local_37;
                    let _e977 = global_4.member[(_e741 + select(_e83, _e968, (_e968 < _e83)))];
                    let _e983 = (_e893 + 6u);
                    let _e985 = local_38;
                    let _e992 = global_4.member[(_e741 + select(_e83, _e983, (_e983 < _e83)))];
                    let _e998 = (_e893 + 7u);
                    let _e1000 = local_39;
                    let _e1007 = global_4.member[(_e741 + select(_e83, _e998, (_e998 < _e83)))];
                    let _e1013 = (_e893 + 8u);
                    let _e1015 = local_40;
                    let _e1022 = global_4.member[(_e741 + select(_e83, _e1013, (_e1013 < _e83)))];
                    let _e1028 = (_e893 + 9u);
                    let _e1030 = local_41;
                    let _e1037 = global_4.member[(_e741 + select(_e83, _e1028, (_e1028 < _e83)))];
                    let _e1043 = (_e893 + 10u);
                    let _e1045 = local_42;
                    let _e1052 = global_4.member[(_e741 + select(_e83, _e1043, (_e1043 < _e83)))];
                    let _e1058 = (_e893 + 11u);
                    let _e1060 = local_43;
                    let _e1067 = global_4.member[(_e741 + select(_e83, _e1058, (_e1058 < _e83)))];
                    let _e1073 = (_e893 + 12u);
                    let _e1075 = local_44;
                    let _e1082 = global_4.member[(_e741 + select(_e83, _e1073, (_e1073 < _e83)))];
                    let _e1088 = (_e893 + 13u);
                    let _e1090 = local_45;
                    let _e1097 = global_4.member[(_e741 + select(_e83, _e1088, (_e1088 < _e83)))];
                    let _e1103 = (_e893 + 14u);
                    let _e1105 = local_46;
                    let _e1112 = global_4.member[(_e741 + select(_e83, _e1103, (_e1103 < _e83)))];
                    let _e1118 = (_e893 + 15u);
                    let _e1120 = local_47;
                    let _e1127 = global_4.member[(_e741 + select(_e83, _e1118, (_e1118 < _e83)))];
                    local_65 = (_e749 + 4u);
                    local_66 = ((select(0f, _e1120.member_3, (_e1120.member_3 > 0f)) * _e1127.x) + ((select(0f, _e1105.member_2, (_e1105.member_2 > 0f)) * _e1112.x) + ((select(0f, _e1090.member_1, (_e1090.member_1 > 0f)) * _e1097.x) + ((select(0f, _e1075.member, (_e1075.member > 0f)) * _e1082.x) + ((select(0f, _e1060.member_3, (_e1060.member_3 > 0f)) * _e1067.x) + ((select(0f, _e1045.member_2, (_e1045.member_2 > 0f)) * _e1052.x) + ((select(0f, _e1030.member_1, (_e1030.member_1 > 0f)) * _e1037.x) + ((select(0f, _e1015.member, (_e1015.member > 0f)) * _e1022.x) + ((select(0f, _e1000.member_3, (_e1000.member_3 > 0f)) * _e1007.x) + ((select(0f, _e985.member_2, (_e985.member_2 > 0f)) * _e992.x) + ((select(0f, _e970.member_1, (_e970.member_1 > 0f)) * _e977.x) + ((select(0f, _e955.member, (_e955.member > 0f)) * _e962.x) + ((select(0f, _e940.member_3, (_e940.member_3 > 0f)) * _e947.x) + ((select(0f, _e925.member_2, (_e925.member_2 > 0f)) * _e932.x) + ((select(0f, _e910.member_1, (_e910.member_1 > 0f)) * _e917.x) + ((select(0f, _e895.member, (_e895.member > 0f)) * _e902.x) + _e751))))))))))))))));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e1262 = local_65;
                    phi_676_ = _e1262;
                    let _e1265 = local_66;
                    phi_679_ = _e1265;
                }
            }
            let _e1307 = local_75;
            phi_1003_ = _e1307;
        }
        let _e1135 = phi_1003_;
        let _e1140 = global_7.member[((6u * _e67) + _e60)];
        let _e1141 = (_e1135 < 0f);
        let _e1145 = exp(select(-(_e1135), _e1135, _e1141));
        let _e1147 = (_e1145 / (2f + _e1145));
        let _e1148 = (_e1147 * _e1147);
        let _e1173 = global_3.member.member_1;
        global_8.member[(_e1173 + _e60)] = (_e1140 * (select(0f, _e1135, _e1141) - ((2f * _e1147) * (1f + (_e1148 * ((1f / 3f) + (_e1148 * ((1f / 5f) + (_e1148 * ((1f / 7f) + (_e1148 * ((1f / 9f) + (_e1148 * ((1f / 11f) + (_e1148 * (1f / 13f))))))))))))))));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn transmittance_network(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
