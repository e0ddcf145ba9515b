struct type_6 {
    member: array<f32>,
}

struct type_13 {
    member: array<u32>,
}

struct type_19 {
    member: array<vec4<f32>>,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: f32,
}

struct type_23 {
    member: type_22,
}

struct type_28 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_23;
@group(0) @binding(1) 
var<storage> global_4: type_6;
@group(0) @binding(2) 
var<storage> global_5: type_6;
@group(0) @binding(3) 
var<storage> global_6: type_6;
@group(0) @binding(4) 
var<storage> global_7: type_6;
@group(0) @binding(5) 
var<storage> global_8: type_13;
@group(0) @binding(6) 
var<storage> global_9: type_13;
@group(0) @binding(7) 
var<storage> global_10: type_19;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_28;

fn function_() {
    var phi_558_: vec3<f32>;
    var phi_561_: vec3<f32>;
    var phi_563_: u32;
    var local: vec3<f32>;
    var phi_676_: u32;
    var phi_678_: array<u32, 2>;
    var phi_684_: array<u32, 2>;
    var local_1: vec3<f32>;
    var phi_733_: u32;
    var phi_735_: array<u32, 2>;
    var phi_741_: array<u32, 2>;
    var local_2: vec3<f32>;
    var phi_790_: u32;
    var phi_792_: array<u32, 2>;
    var phi_798_: array<u32, 2>;
    var local_3: vec3<f32>;
    var phi_847_: u32;
    var phi_849_: array<u32, 2>;
    var phi_855_: array<u32, 2>;
    var local_4: vec3<f32>;
    var phi_904_: u32;
    var phi_906_: array<u32, 2>;
    var phi_912_: array<u32, 2>;
    var local_5: vec3<f32>;
    var phi_961_: u32;
    var phi_963_: array<u32, 2>;
    var phi_969_: array<u32, 2>;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: u32;

    let _e52 = global;
    let _e53 = global_1;
    let _e54 = global_2;
    let _e62 = (((_e53.x + (_e53.y * _e54.x)) * 64u) + _e52.x);
    let _e65 = global_3.member.member_4;
    if (_e62 < _e65) {
        let _e69 = global_3.member.member_2;
        let _e70 = (_e69 * 18u);
        let _e73 = global_4.member[_e70];
        let _e77 = global_4.member[(_e70 + 1u)];
        let _e81 = global_4.member[(_e70 + 2u)];
        let _e85 = global_4.member[(_e70 + 3u)];
        let _e89 = global_4.member[(_e70 + 4u)];
        let _e93 = global_4.member[(_e70 + 5u)];
        let _e97 = global_4.member[(_e70 + 6u)];
        let _e101 = global_4.member[(_e70 + 7u)];
        let _e105 = global_4.member[(_e70 + 8u)];
        let _e109 = global_4.member[(_e70 + 9u)];
        let _e113 = global_4.member[(_e70 + 10u)];
        let _e117 = global_4.member[(_e70 + 11u)];
        let _e121 = global_4.member[(_e70 + 12u)];
        let _e125 = global_4.member[(_e70 + 13u)];
        let _e129 = global_4.member[(_e70 + 14u)];
        let _e133 = global_4.member[(_e70 + 15u)];
        let _e137 = global_4.member[(_e70 + 16u)];
        let _e141 = global_4.member[(_e70 + 17u)];
        let _e145 = global_3.member.member_1;
        let _e149 = global_8.member[((_e69 + 1u) * _e145)];
        let _e153 = global_8.member[(_e69 * _e145)];
        let _e155 = (_e153 + (_e62 * 256u));
        let _e156 = (_e155 + 256u);
        phi_558_ = vec3<f32>(0f, 0f, 0f);
        phi_561_ = vec3<f32>(0f, 0f, 0f);
        phi_563_ = _e155;
        loop {
            let _e160 = phi_558_;
            let _e162 = phi_561_;
            let _e164 = phi_563_;
            local = _e162;
            local_1 = _e162;
            local_2 = _e162;
            local_3 = _e160;
            local_4 = _e160;
            local_5 = _e160;
            if (_e164 < select(_e149, _e156, (_e156 < _e149))) {
                let _e168 = global_9.member[_e164];
                let _e171 = global_3.member.member;
                let _e173 = (_e168 - (_e69 * _e171));
                let _e174 = (3u * _e173);
                let _e177 = global_5.member[_e174];
                let _e178 = (_e174 + 1u);
                let _e181 = global_5.member[_e178];
                let _e182 = (_e174 + 2u);
                let _e185 = global_5.member[_e182];
                let _e186 = (_e173 * 4u);
                let _e189 = global_6.member[_e186];
                let _e193 = global_6.member[(_e186 + 1u)];
                let _e197 = global_6.member[(_e186 + 2u)];
                let _e201 = global_6.member[(_e186 + 3u)];
                let _e204 = global_7.member[_e174];
                let _e207 = global_7.member[_e178];
                let _e210 = global_7.member[_e182];
                let _e211 = (_e177 - _e109);
                let _e212 = (_e181 - _e113);
                let _e213 = (_e185 - _e117);
                let _e218 = (((_e73 * _e211) + (_e77 * _e212)) + (_e81 * _e213));
                let _e223 = (((_e85 * _e211) + (_e89 * _e212)) + (_e93 * _e213));
                let _e228 = (((_e97 * _e211) + (_e101 * _e212)) + (_e105 * _e213));
                let _e230 = select(1f, _e228, (0.01f < _e228));
                let _e231 = (1f / _e121);
                let _e232 = (1f / _e125);
                let _e235 = ((_e137 * _e231) * 0.15f);
                let _e236 = ((_e141 * _e232) * 0.15f);
                let _e241 = (((_e129 * _e231) * -1f) - _e235);
                let _e242 = (((_e133 * _e232) * -1f) - _e236);
                let _e247 = (((_e137 - _e129) * _e231) + _e235);
                let _e248 = (((_e141 - _e133) * _e232) + _e236);
                let _e249 = (_e218 / _e230);
                let _e251 = select(_e241, _e249, (_e249 > _e241));
                let _e253 = select(_e247, _e251, (_e251 < _e247));
                let _e254 = (_e223 / _e230);
                let _e256 = select(_e242, _e254, (_e254 > _e242));
                let _e258 = select(_e248, _e256, (_e256 < _e248));
                let _e259 = (_e121 / _e230);
                let _e260 = (_e125 / _e230);
                let _e267 = ((_e73 - (_e97 * _e253)) * _e259);
                let _e268 = ((_e77 - (_e101 * _e253)) * _e259);
                let _e269 = ((_e81 - (_e105 * _e253)) * _e259);
                let _e276 = ((_e85 - (_e97 * _e258)) * _e260);
                let _e277 = ((_e89 - (_e101 * _e258)) * _e260);
                let _e278 = ((_e93 - (_e105 * _e258)) * _e260);
                let _e287 = (1f / sqrt(((((_e189 * _e189) + (_e193 * _e193)) + (_e197 * _e197)) + (_e201 * _e201))));
                let _e288 = (_e189 * _e287);
                let _e289 = (_e193 * _e287);
                let _e290 = (_e197 * _e287);
                let _e291 = (_e201 * _e287);
                let _e292 = (_e290 * _e290);
                let _e293 = (_e291 * _e291);
                let _e296 = (1f - (2f * (_e292 + _e293)));
                let _e297 = (_e289 * _e290);
                let _e298 = (_e288 * _e291);
                let _e300 = (2f * (_e297 + _e298));
                let _e301 = (_e289 * _e291);
                let _e302 = (_e288 * _e290);
                let _e304 = (2f * (_e301 - _e302));
                let _e306 = (2f * (_e297 - _e298));
                let _e307 = (_e289 * _e289);
                let _e310 = (1f - (2f * (_e307 + _e293)));
                let _e311 = (_e290 * _e291);
                let _e312 = (_e288 * _e289);
                let _e314 = (2f * (_e311 + _e312));
                let _e316 = (2f * (_e301 + _e302));
                let _e318 = (2f * (_e311 - _e312));
                let _e321 = (1f - (2f * (_e307 + _e292)));
                let _e322 = exp(_e204);
                let _e323 = exp(_e207);
                let _e324 = exp(_e210);
                let _e340 = ((((_e267 * _e296) + (_e268 * _e300)) + (_e269 * _e304)) * _e322);
                let _e341 = ((((_e267 * _e306) + (_e268 * _e310)) + (_e269 * _e314)) * _e323);
                let _e342 = ((((_e267 * _e316) + (_e268 * _e318)) + (_e269 * _e321)) * _e324);
                let _e358 = ((((_e276 * _e296) + (_e277 * _e300)) + (_e278 * _e304)) * _e322);
                let _e359 = ((((_e276 * _e306) + (_e277 * _e310)) + (_e278 * _e314)) * _e323);
                let _e360 = ((((_e276 * _e316) + (_e277 * _e318)) + (_e278 * _e321)) * _e324);
                let _e361 = (3u * _e164);
                let _e364 = global_10.member[_e361];
                let _e368 = global_10.member[(_e361 + 1u)];
                let _e376 = global_3.member.member_6;
                let _e381 = (((_e340 * _e340) + (_e341 * _e341)) + (_e342 * _e342));
                let _e391 = (((_e358 * _e358) + (_e359 * _e359)) + (_e360 * _e360));
                let _e394 = ((_e341 * _e360) - (_e342 * _e359));
                let _e397 = ((_e342 * _e358) - (_e340 * _e360));
                let _e400 = ((_e340 * _e359) - (_e341 * _e358));
                let _e411 = (1f / (((((_e394 * _e394) + (_e397 * _e397)) + (_e400 * _e400)) + (_e376 * (_e381 + _e391))) + (_e376 * _e376)));
                let _e427 = (((_e340 * _e376) + ((_e359 * _e400) - (_e360 * _e397))) * _e411);
                let _e428 = (((_e341 * _e376) + ((_e360 * _e394) - (_e358 * _e400))) * _e411);
                let _e429 = (((_e342 * _e376) + ((_e358 * _e397) - (_e359 * _e394))) * _e411);
                let _e445 = (((_e358 * _e376) + ((_e397 * _e342) - (_e400 * _e341))) * _e411);
                let _e446 = (((_e359 * _e376) + ((_e400 * _e340) - (_e394 * _e342))) * _e411);
                let _e447 = (((_e360 * _e376) + ((_e394 * _e341) - (_e397 * _e340))) * _e411);
                let _e448 = (0.5f * _e368.y);
                let _e455 = ((_e427 * _e368.x) + (_e445 * _e448));
                let _e456 = ((_e428 * _e368.x) + (_e446 * _e448));
                let _e457 = ((_e429 * _e368.x) + (_e447 * _e448));
                let _e464 = ((_e427 * _e448) + (_e445 * _e368.z));
                let _e465 = ((_e428 * _e448) + (_e446 * _e368.z));
                let _e466 = ((_e429 * _e448) + (_e447 * _e368.z));
                let _e468 = ((_e391 + _e376) * _e411);
                let _e470 = (-((((_e340 * _e358) + (_e341 * _e359)) + (_e342 * _e360))) * _e411);
                let _e472 = ((_e381 + _e376) * _e411);
                let _e497 = ((((_e455 * _e468) + (_e464 * _e470)) * -2f) * _e322);
                let _e498 = ((((_e456 * _e468) + (_e465 * _e470)) * -2f) * _e323);
                let _e499 = ((((_e457 * _e468) + (_e466 * _e470)) * -2f) * _e324);
                let _e500 = ((((_e455 * _e470) + (_e464 * _e472)) * -2f) * _e322);
                let _e501 = ((((_e456 * _e470) + (_e465 * _e472)) * -2f) * _e323);
                let _e502 = ((((_e457 * _e470) + (_e466 * _e472)) * -2f) * _e324);
                let _e515 = (((_e296 * _e497) + (_e306 * _e498)) + (_e316 * _e499));
                let _e516 = (((_e300 * _e497) + (_e310 * _e498)) + (_e318 * _e499));
                let _e517 = (((_e304 * _e497) + (_e314 * _e498)) + (_e321 * _e499));
                let _e530 = (((_e296 * _e500) + (_e306 * _e501)) + (_e316 * _e502));
                let _e531 = (((_e300 * _e500) + (_e310 * _e501)) + (_e318 * _e502));
                let _e532 = (((_e304 * _e500) + (_e314 * _e501)) + (_e321 * _e502));
                let _e533 = (1f / _e230);
                let _e534 = (_e121 * _e533);
                let _e535 = (_e125 * _e533);
                let _e556 = ((_e534 * _e364.x) + (select(0f, (-(_e534) * (((_e515 * _e97) + (_e516 * _e101)) + (_e517 * _e105))), (_e253 == _e249)) / _e230));
                let _e559 = ((_e535 * _e364.y) + (select(0f, (-(_e535) * (((_e530 * _e97) + (_e531 * _e101)) + (_e532 * _e105))), (_e258 == _e254)) / _e230));
                let _e576 = (-(((_e249 * _e556) + (_e254 * _e559))) - (((((_e515 * _e267) + (_e516 * _e268)) + (_e517 * _e269)) + (((_e530 * _e276) + (_e531 * _e277)) + (_e532 * _e278))) / _e230));
                let _e595 = (((_e516 * _e269) - (_e517 * _e268)) + ((_e531 * _e278) - (_e532 * _e277)));
                let _e596 = (((_e517 * _e267) - (_e515 * _e269)) + ((_e532 * _e276) - (_e530 * _e278)));
                let _e597 = (((_e515 * _e268) - (_e516 * _e267)) + ((_e530 * _e277) - (_e531 * _e276)));
                local_6 = vec3<f32>((_e160.x + _e556), (_e160.y + _e559), (_e160.z + _e576));
                local_7 = vec3<f32>((_e162.x + (((_e223 * _e576) - (_e228 * _e559)) + (((_e73 * _e595) + (_e77 * _e596)) + (_e81 * _e597)))), (_e162.y + (((_e228 * _e556) - (_e218 * _e576)) + (((_e85 * _e595) + (_e89 * _e596)) + (_e93 * _e597)))), (_e162.z + (((_e218 * _e559) - (_e223 * _e556)) + (((_e97 * _e595) + (_e101 * _e596)) + (_e105 * _e597)))));
                local_8 = (_e164 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e990 = local_6;
                phi_558_ = _e990;
                let _e993 = local_7;
                phi_561_ = _e993;
                let _e996 = local_8;
                phi_563_ = _e996;
            }
        }
        let _e642 = global_3.member.member_5;
        let _e645 = global_3.member.member_3;
        let _e646 = (6u * _e645);
        let _e648 = local;
        let _e650 = bitcast<u32>(_e648.x);
        let _e653 = ((_e650 >> bitcast<u32>(23i)) & 255u);
        if (_e653 == 0u) {
        } else {
            let _e656 = (_e653 % 16u);
            let _e658 = ((_e650 & 8388607u) | 8388608u);
            let _e661 = (_e658 << bitcast<u32>((_e656 & 31u)));
            let _e667 = ((_e658 >> bitcast<u32>(((31u - _e656) & 31u))) >> bitcast<u32>(1i));
            if ((_e650 >> bitcast<u32>(31i)) == 0u) {
                phi_678_ = array<u32, 2>(_e661, _e667);
            } else {
                let _e673 = (~(_e661) + 1u);
                if (_e673 == 0u) {
                    phi_676_ = (~(_e667) + 1u);
                } else {
                    phi_676_ = ~(_e667);
                }
                let _e679 = phi_676_;
                phi_678_ = array<u32, 2>(_e673, _e679);
            }
            let _e682 = phi_678_;
            let _e683 = (_e653 < 255u);
            if _e683 {
                phi_684_ = _e682;
            } else {
                phi_684_ = array<u32, 2>(1u, 0u);
            }
            let _e686 = phi_684_;
            let _e691 = (2u * ((select(16u, (_e653 / 16u), _e683) * _e642) + _e646));
            let _e694 = atomicAdd((&global_11.member[_e691]), _e686[0]);
            let _e702 = atomicAdd((&global_11.member[(_e691 + 1u)]), (_e686[1] + select(0u, 1u, ((_e694 + _e686[0]) < _e686[0]))));
        }
        let _e705 = local_1;
        let _e707 = bitcast<u32>(_e705.y);
        let _e710 = ((_e707 >> bitcast<u32>(23i)) & 255u);
        if (_e710 == 0u) {
        } else {
            let _e713 = (_e710 % 16u);
            let _e715 = ((_e707 & 8388607u) | 8388608u);
            let _e718 = (_e715 << bitcast<u32>((_e713 & 31u)));
            let _e724 = ((_e715 >> bitcast<u32>(((31u - _e713) & 31u))) >> bitcast<u32>(1i));
            if ((_e707 >> bitcast<u32>(31i)) == 0u) {
                phi_735_ = array<u32, 2>(_e718, _e724);
            } else {
                let _e730 = (~(_e718) + 1u);
                if (_e730 == 0u) {
                    phi_733_ = (~(_e724) + 1u);
                } else {
                    phi_733_ = ~(_e724);
                }
                let _e736 = phi_733_;
                phi_735_ = array<u32, 2>(_e730, _e736);
            }
            let _e739 = phi_735_;
            let _e740 = (_e710 < 255u);
            if _e740 {
                phi_741_ = _e739;
            } else {
                phi_741_ = array<u32, 2>(1u, 0u);
            }
            let _e743 = phi_741_;
            let _e748 = (2u * ((select(16u, (_e710 / 16u), _e740) * _e642) + (_e646 + 1u)));
            let _e751 = atomicAdd((&global_11.member[_e748]), _e743[0]);
            let _e759 = atomicAdd((&global_11.member[(_e748 + 1u)]), (_e743[1] + select(0u, 1u, ((_e751 + _e743[0]) < _e743[0]))));
        }
        let _e762 = local_2;
        let _e764 = bitcast<u32>(_e762.z);
        let _e767 = ((_e764 >> bitcast<u32>(23i)) & 255u);
        if (_e767 == 0u) {
        } else {
            let _e770 = (_e767 % 16u);
            let _e772 = ((_e764 & 8388607u) | 8388608u);
            let _e775 = (_e772 << bitcast<u32>((_e770 & 31u)));
            let _e781 = ((_e772 >> bitcast<u32>(((31u - _e770) & 31u))) >> bitcast<u32>(1i));
            if ((_e764 >> bitcast<u32>(31i)) == 0u) {
                phi_792_ = array<u32, 2>(_e775, _e781);
            } else {
                let _e787 = (~(_e775) + 1u);
                if (_e787 == 0u) {
                    phi_790_ = (~(_e781) + 1u);
                } else {
                    phi_790_ = ~(_e781);
                }
                let _e793 = phi_790_;
                phi_792_ = array<u32, 2>(_e787, _e793);
            }
            let _e796 = phi_792_;
            let _e797 = (_e767 < 255u);
            if _e797 {
                phi_798_ = _e796;
            } else {
                phi_798_ = array<u32, 2>(1u, 0u);
            }
            let _e800 = phi_798_;
            let _e805 = (2u * ((select(16u, (_e767 / 16u), _e797) * _e642) + (_e646 + 2u)));
            let _e808 = atomicAdd((&global_11.member[_e805]), _e800[0]);
            let _e816 = atomicAdd((&global_11.member[(_e805 + 1u)]), (_e800[1] + select(0u, 1u, ((_e808 + _e800[0]) < _e800[0]))));
        }
        let _e819 = local_3;
        let _e821 = bitcast<u32>(_e819.x);
        let _e824 = ((_e821 >> bitcast<u32>(23i)) & 255u);
        if (_e824 == 0u) {
        } else {
            let _e827 = (_e824 % 16u);
            let _e829 = ((_e821 & 8388607u) | 8388608u);
            let _e832 = (_e829 << bitcast<u32>((_e827 & 31u)));
            let _e838 = ((_e829 >> bitcast<u32>(((31u - _e827) & 31u))) >> bitcast<u32>(1i));
            if ((_e821 >> bitcast<u32>(31i)) == 0u) {
                phi_849_ = array<u32, 2>(_e832, _e838);
            } else {
                let _e844 = (~(_e832) + 1u);
                if (_e844 == 0u) {
                    phi_847_ = (~(_e838) + 1u);
                } else {
                    phi_847_ = ~(_e838);
                }
                let _e850 = phi_847_;
                phi_849_ = array<u32, 2>(_e844, _e850);
            }
            let _e853 = phi_849_;
            let _e854 = (_e824 < 255u);
            if _e854 {
                phi_855_ = _e853;
            } else {
                phi_855_ = array<u32, 2>(1u, 0u);
            }
            let _e857 = phi_855_;
            let _e862 = (2u * ((select(16u, (_e824 / 16u), _e854) * _e642) + (_e646 + 3u)));
            let _e865 = atomicAdd((&global_11.member[_e862]), _e857[0]);
            let _e873 = atomicAdd((&global_11.member[(_e862 + 1u)]), (_e857[1] + select(0u, 1u, ((_e865 + _e857[0]) < _e857[0]))));
        }
        let _e876 = local_4;
        let _e878 = bitcast<u32>(_e876.y);
        let _e881 = ((_e878 >> bitcast<u32>(23i)) & 255u);
        if (_e881 == 0u) {
        } else {
            let _e884 = (_e881 % 16u);
            let _e886 = ((_e878 & 8388607u) | 8388608u);
            let _e889 = (_e886 << bitcast<u32>((_e884 & 31u)));
            let _e895 = ((_e886 >> bitcast<u32>(((31u - _e884) & 31u))) >> bitcast<u32>(1i));
            if ((_e878 >> bitcast<u32>(31i)) == 0u) {
                phi_906_ = array<u32, 2>(_e889, _e895);
            } else {
                let _e901 = (~(_e889) + 1u);
                if (_e901 == 0u) {
                    phi_904_ = (~(_e895) + 1u);
                } else {
                    phi_904_ = ~(_e895);
                }
                let _e907 = phi_904_;
                phi_906_ = array<u32, 2>(_e901, _e907);
            }
            let _e910 = phi_906_;
            let _e911 = (_e881 < 255u);
            if _e911 {
                phi_912_ = _e910;
            } else {
                phi_912_ = array<u32, 2>(1u, 0u);
            }
            let _e914 = phi_912_;
            let _e919 = (2u * ((select(16u, (_e881 / 16u), _e911) * _e642) + (_e646 + 4u)));
            let _e922 = atomicAdd((&global_11.member[_e919]), _e914[0]);
            let _e930 = atomicAdd((&global_11.member[(_e919 + 1u)]), (_e914[1] + select(0u, 1u, ((_e922 + _e914[0]) < _e914[0]))));
        }
        let _e933 = local_5;
        let _e935 = bitcast<u32>(_e933.z);
        let _e938 = ((_e935 >> bitcast<u32>(23i)) & 255u);
        if (_e938 == 0u) {
        } else {
            let _e941 = (_e938 % 16u);
            let _e943 = ((_e935 & 8388607u) | 8388608u);
            let _e946 = (_e943 << bitcast<u32>((_e941 & 31u)));
            let _e952 = ((_e943 >> bitcast<u32>(((31u - _e941) & 31u))) >> bitcast<u32>(1i));
            if ((_e935 >> bitcast<u32>(31i)) == 0u) {
                phi_963_ = array<u32, 2>(_e946, _e952);
            } else {
                let _e958 = (~(_e946) + 1u);
                if (_e958 == 0u) {
                    phi_961_ = (~(_e952) + 1u);
                } else {
                    phi_961_ = ~(_e952);
                }
                let _e964 = phi_961_;
                phi_963_ = array<u32, 2>(_e958, _e964);
            }
            let _e967 = phi_963_;
            let _e968 = (_e938 < 255u);
            if _e968 {
                phi_969_ = _e967;
            } else {
                phi_969_ = array<u32, 2>(1u, 0u);
            }
            let _e971 = phi_969_;
            let _e976 = (2u * ((select(16u, (_e938 / 16u), _e968) * _e642) + (_e646 + 5u)));
            let _e979 = atomicAdd((&global_11.member[_e976]), _e971[0]);
            let _e987 = atomicAdd((&global_11.member[(_e976 + 1u)]), (_e971[1] + select(0u, 1u, ((_e979 + _e971[0]) < _e971[0]))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn pose_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
