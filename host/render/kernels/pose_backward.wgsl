struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: f32,
}

struct type_6 {
    member: type_5,
}

struct type_11 {
    member: array<f32>,
}

struct type_15 {
    member: array<u32>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(1) 
var<storage> global_4: type_11;
@group(0) @binding(5) 
var<storage> global_5: type_15;
@group(0) @binding(6) 
var<storage> global_6: type_15;
@group(0) @binding(2) 
var<storage> global_7: type_11;
@group(0) @binding(3) 
var<storage> global_8: type_11;
@group(0) @binding(4) 
var<storage> global_9: type_11;
@group(0) @binding(7) 
var<storage> global_10: type_21;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_28;

fn function_() {
    var phi_557_: vec3<f32>;
    var phi_560_: vec3<f32>;
    var phi_562_: u32;
    var phi_564_: u32;
    var local: vec3<f32>;
    var phi_676_: u32;
    var phi_678_: array<u32, 2>;
    var phi_684_: array<u32, 2>;
    var local_1: vec3<f32>;
    var phi_738_: u32;
    var phi_740_: array<u32, 2>;
    var phi_746_: array<u32, 2>;
    var local_2: vec3<f32>;
    var phi_800_: u32;
    var phi_802_: array<u32, 2>;
    var phi_808_: array<u32, 2>;
    var local_3: vec3<f32>;
    var phi_862_: u32;
    var phi_864_: array<u32, 2>;
    var phi_870_: array<u32, 2>;
    var local_4: vec3<f32>;
    var phi_924_: u32;
    var phi_926_: array<u32, 2>;
    var phi_932_: array<u32, 2>;
    var local_5: vec3<f32>;
    var phi_986_: u32;
    var phi_988_: array<u32, 2>;
    var phi_994_: array<u32, 2>;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: u32;
    var local_9: u32;

    let _e50 = global;
    let _e51 = global_1;
    let _e52 = global_2;
    let _e60 = (((_e51.x + (_e51.y * _e52.x)) * 64u) + _e50.x);
    let _e63 = global_3.member.member_4;
    if (_e60 < _e63) {
        let _e67 = global_3.member.member_2;
        let _e68 = (_e67 * 18u);
        let _e71 = global_4.member[_e68];
        let _e75 = global_4.member[(_e68 + 1u)];
        let _e79 = global_4.member[(_e68 + 2u)];
        let _e83 = global_4.member[(_e68 + 3u)];
        let _e87 = global_4.member[(_e68 + 4u)];
        let _e91 = global_4.member[(_e68 + 5u)];
        let _e95 = global_4.member[(_e68 + 6u)];
        let _e99 = global_4.member[(_e68 + 7u)];
        let _e103 = global_4.member[(_e68 + 8u)];
        let _e107 = global_4.member[(_e68 + 9u)];
        let _e111 = global_4.member[(_e68 + 10u)];
        let _e115 = global_4.member[(_e68 + 11u)];
        let _e119 = global_4.member[(_e68 + 12u)];
        let _e123 = global_4.member[(_e68 + 13u)];
        let _e127 = global_4.member[(_e68 + 14u)];
        let _e131 = global_4.member[(_e68 + 15u)];
        let _e135 = global_4.member[(_e68 + 16u)];
        let _e139 = global_4.member[(_e68 + 17u)];
        let _e143 = global_3.member.member_1;
        let _e147 = global_5.member[((_e67 + 1u) * _e143)];
        let _e151 = global_5.member[(_e67 * _e143)];
        let _e153 = (_e151 + (_e60 * 256u));
        let _e154 = (_e153 + 256u);
        phi_557_ = vec3<f32>(0f, 0f, 0f);
        phi_560_ = vec3<f32>(0f, 0f, 0f);
        phi_562_ = (3u * _e153);
        phi_564_ = _e153;
        loop {
            let _e159 = phi_557_;
            let _e161 = phi_560_;
            let _e163 = phi_562_;
            let _e165 = phi_564_;
            local = _e161;
            local_1 = _e161;
            local_2 = _e161;
            local_3 = _e159;
            local_4 = _e159;
            local_5 = _e159;
            if (_e165 < select(_e147, _e154, (_e154 < _e147))) {
                let _e169 = global_6.member[_e165];
                let _e172 = global_3.member.member;
                let _e174 = (_e169 - (_e67 * _e172));
                let _e175 = (3u * _e174);
                let _e178 = global_7.member[_e175];
                let _e179 = (_e175 + 1u);
                let _e182 = global_7.member[_e179];
                let _e183 = (_e175 + 2u);
                let _e186 = global_7.member[_e183];
                let _e187 = (_e174 * 4u);
                let _e190 = global_8.member[_e187];
                let _e194 = global_8.member[(_e187 + 1u)];
                let _e198 = global_8.member[(_e187 + 2u)];
                let _e202 = global_8.member[(_e187 + 3u)];
                let _e205 = global_9.member[_e175];
                let _e208 = global_9.member[_e179];
                let _e211 = global_9.member[_e183];
                let _e212 = (_e178 - _e107);
                let _e213 = (_e182 - _e111);
                let _e214 = (_e186 - _e115);
                let _e219 = (((_e71 * _e212) + (_e75 * _e213)) + (_e79 * _e214));
                let _e224 = (((_e83 * _e212) + (_e87 * _e213)) + (_e91 * _e214));
                let _e229 = (((_e95 * _e212) + (_e99 * _e213)) + (_e103 * _e214));
                let _e231 = select(1f, _e229, (0.01f < _e229));
                let _e232 = (1f / _e119);
                let _e233 = (1f / _e123);
                let _e236 = ((_e135 * _e232) * 0.15f);
                let _e237 = ((_e139 * _e233) * 0.15f);
                let _e242 = (((_e127 * _e232) * -1f) - _e236);
                let _e243 = (((_e131 * _e233) * -1f) - _e237);
                let _e248 = (((_e135 - _e127) * _e232) + _e236);
                let _e249 = (((_e139 - _e131) * _e233) + _e237);
                let _e250 = (_e219 / _e231);
                let _e252 = select(_e242, _e250, (_e250 > _e242));
                let _e254 = select(_e248, _e252, (_e252 < _e248));
                let _e255 = (_e224 / _e231);
                let _e257 = select(_e243, _e255, (_e255 > _e243));
                let _e259 = select(_e249, _e257, (_e257 < _e249));
                let _e260 = (_e119 / _e231);
                let _e261 = (_e123 / _e231);
                let _e268 = ((_e71 - (_e95 * _e254)) * _e260);
                let _e269 = ((_e75 - (_e99 * _e254)) * _e260);
                let _e270 = ((_e79 - (_e103 * _e254)) * _e260);
                let _e277 = ((_e83 - (_e95 * _e259)) * _e261);
                let _e278 = ((_e87 - (_e99 * _e259)) * _e261);
                let _e279 = ((_e91 - (_e103 * _e259)) * _e261);
                let _e288 = (1f / sqrt(((((_e190 * _e190) + (_e194 * _e194)) + (_e198 * _e198)) + (_e202 * _e202))));
                let _e289 = (_e190 * _e288);
                let _e290 = (_e194 * _e288);
                let _e291 = (_e198 * _e288);
                let _e292 = (_e202 * _e288);
                let _e293 = (_e291 * _e291);
                let _e294 = (_e292 * _e292);
                let _e297 = (1f - (2f * (_e293 + _e294)));
                let _e298 = (_e290 * _e291);
                let _e299 = (_e289 * _e292);
                let _e301 = (2f * (_e298 + _e299));
                let _e302 = (_e290 * _e292);
                let _e303 = (_e289 * _e291);
                let _e305 = (2f * (_e302 - _e303));
                let _e307 = (2f * (_e298 - _e299));
                let _e308 = (_e290 * _e290);
                let _e311 = (1f - (2f * (_e308 + _e294)));
                let _e312 = (_e291 * _e292);
                let _e313 = (_e289 * _e290);
                let _e315 = (2f * (_e312 + _e313));
                let _e317 = (2f * (_e302 + _e303));
                let _e319 = (2f * (_e312 - _e313));
                let _e322 = (1f - (2f * (_e308 + _e293)));
                let _e323 = exp(_e205);
                let _e324 = exp(_e208);
                let _e325 = exp(_e211);
                let _e341 = ((((_e268 * _e297) + (_e269 * _e301)) + (_e270 * _e305)) * _e323);
                let _e342 = ((((_e268 * _e307) + (_e269 * _e311)) + (_e270 * _e315)) * _e324);
                let _e343 = ((((_e268 * _e317) + (_e269 * _e319)) + (_e270 * _e322)) * _e325);
                let _e359 = ((((_e277 * _e297) + (_e278 * _e301)) + (_e279 * _e305)) * _e323);
                let _e360 = ((((_e277 * _e307) + (_e278 * _e311)) + (_e279 * _e315)) * _e324);
                let _e361 = ((((_e277 * _e317) + (_e278 * _e319)) + (_e279 * _e322)) * _e325);
                let _e364 = global_10.member[_e163];
                let _e368 = global_10.member[(_e163 + 1u)];
                let _e371 = global_3.member.member_6;
                let _e381 = (((_e341 * _e341) + (_e342 * _e342)) + (_e343 * _e343));
                let _e391 = (((_e359 * _e359) + (_e360 * _e360)) + (_e361 * _e361));
                let _e394 = ((_e342 * _e361) - (_e343 * _e360));
                let _e397 = ((_e343 * _e359) - (_e341 * _e361));
                let _e400 = ((_e341 * _e360) - (_e342 * _e359));
                let _e411 = (1f / (((((_e394 * _e394) + (_e397 * _e397)) + (_e400 * _e400)) + (_e371 * (_e381 + _e391))) + (_e371 * _e371)));
                let _e427 = (((_e341 * _e371) + ((_e360 * _e400) - (_e361 * _e397))) * _e411);
                let _e428 = (((_e342 * _e371) + ((_e361 * _e394) - (_e359 * _e400))) * _e411);
                let _e429 = (((_e343 * _e371) + ((_e359 * _e397) - (_e360 * _e394))) * _e411);
                let _e445 = (((_e359 * _e371) + ((_e397 * _e343) - (_e400 * _e342))) * _e411);
                let _e446 = (((_e360 * _e371) + ((_e400 * _e341) - (_e394 * _e343))) * _e411);
                let _e447 = (((_e361 * _e371) + ((_e394 * _e342) - (_e397 * _e341))) * _e411);
                let _e448 = (0.5f * _e368.y);
                let _e455 = ((_e427 * _e368.x) + (_e445 * _e448));
                let _e456 = ((_e428 * _e368.x) + (_e446 * _e448));
                let _e457 = ((_e429 * _e368.x) + (_e447 * _e448));
                let _e464 = ((_e427 * _e448) + (_e445 * _e368.z));
                let _e465 = ((_e428 * _e448) + (_e446 * _e368.z));
                let _e466 = ((_e429 * _e448) + (_e447 * _e368.z));
                let _e468 = ((_e391 + _e371) * _e411);
                let _e470 = (-((((_e341 * _e359) + (_e342 * _e360)) + (_e343 * _e361))) * _e411);
                let _e472 = ((_e381 + _e371) * _e411);
                let _e497 = ((((_e455 * _e468) + (_e464 * _e470)) * -2f) * _e323);
                let _e498 = ((((_e456 * _e468) + (_e465 * _e470)) * -2f) * _e324);
                let _e499 = ((((_e457 * _e468) + (_e466 * _e470)) * -2f) * _e325);
                let _e500 = ((((_e455 * _e470) + (_e464 * _e472)) * -2f) * _e323);
                let _e501 = ((((_e456 * _e470) + (_e465 * _e472)) * -2f) * _e324);
                let _e502 = ((((_e457 * _e470) + (_e466 * _e472)) * -2f) * _e325);
                let _e515 = (((_e297 * _e497) + (_e307 * _e498)) + (_e317 * _e499));
                let _e516 = (((_e301 * _e497) + (_e311 * _e498)) + (_e319 * _e499));
                let _e517 = (((_e305 * _e497) + (_e315 * _e498)) + (_e322 * _e499));
                let _e530 = (((_e297 * _e500) + (_e307 * _e501)) + (_e317 * _e502));
                let _e531 = (((_e301 * _e500) + (_e311 * _e501)) + (_e319 * _e502));
                let _e532 = (((_e305 * _e500) + (_e315 * _e501)) + (_e322 * _e502));
                let _e533 = (1f / _e231);
                let _e534 = (_e119 * _e533);
                let _e535 = (_e123 * _e533);
                let _e556 = ((_e534 * _e364.x) + (select(0f, (-(_e534) * (((_e515 * _e95) + (_e516 * _e99)) + (_e517 * _e103))), (_e254 == _e250)) / _e231));
                let _e559 = ((_e535 * _e364.y) + (select(0f, (-(_e535) * (((_e530 * _e95) + (_e531 * _e99)) + (_e532 * _e103))), (_e259 == _e255)) / _e231));
                let _e576 = (-(((_e250 * _e556) + (_e255 * _e559))) - (((((_e515 * _e268) + (_e516 * _e269)) + (_e517 * _e270)) + (((_e530 * _e277) + (_e531 * _e278)) + (_e532 * _e279))) / _e231));
                let _e595 = (((_e516 * _e270) - (_e517 * _e269)) + ((_e531 * _e279) - (_e532 * _e278)));
                let _e596 = (((_e517 * _e268) - (_e515 * _e270)) + ((_e532 * _e277) - (_e530 * _e279)));
                let _e597 = (((_e515 * _e269) - (_e516 * _e268)) + ((_e530 * _e278) - (_e531 * _e277)));
                local_6 = vec3<f32>((_e159.x + _e556), (_e159.y + _e559), (_e159.z + _e576));
                local_7 = vec3<f32>((_e161.x + (((_e224 * _e576) - (_e229 * _e559)) + (((_e71 * _e595) + (_e75 * _e596)) + (_e79 * _e597)))), (_e161.y + (((_e229 * _e556) - (_e219 * _e576)) + (((_e83 * _e595) + (_e87 * _e596)) + (_e91 * _e597)))), (_e161.z + (((_e219 * _e559) - (_e224 * _e556)) + (((_e95 * _e595) + (_e99 * _e596)) + (_e103 * _e597)))));
                local_8 = (_e163 + 3u);
                local_9 = (_e165 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e997 = local_6;
                phi_557_ = _e997;
                let _e1000 = local_7;
                phi_560_ = _e1000;
                let _e1003 = local_8;
                phi_562_ = _e1003;
                let _e1006 = local_9;
                phi_564_ = _e1006;
            }
        }
        let _e643 = global_3.member.member_5;
        let _e646 = global_3.member.member_3;
        let _e647 = (6u * _e646);
        let _e649 = local;
        let _e651 = bitcast<u32>(_e649.x);
        let _e654 = ((_e651 >> bitcast<u32>(23i)) & 255u);
        if (_e654 == 0u) {
        } else {
            let _e657 = (_e654 % 16u);
            let _e659 = ((_e651 & 8388607u) | 8388608u);
            let _e662 = (_e659 << bitcast<u32>((_e657 & 31u)));
            let _e668 = ((_e659 >> bitcast<u32>(((31u - _e657) & 31u))) >> bitcast<u32>(1i));
            if ((_e651 >> bitcast<u32>(31i)) == 0u) {
                phi_678_ = array<u32, 2>(_e662, _e668);
            } else {
                let _e674 = (~(_e662) + 1u);
                if (_e674 == 0u) {
                    phi_676_ = (~(_e668) + 1u);
                } else {
                    phi_676_ = ~(_e668);
                }
                let _e680 = phi_676_;
                phi_678_ = array<u32, 2>(_e674, _e680);
            }
            let _e683 = phi_678_;
            let _e684 = (_e654 < 255u);
            if _e684 {
                phi_684_ = _e683;
            } else {
                phi_684_ = array<u32, 2>(1u, 0u);
            }
            let _e687 = phi_684_;
            let _e692 = (2u * ((select(16u, (_e654 / 16u), _e684) * _e643) + _e647));
            let _e695 = atomicAdd((&global_11.member[_e692]), _e687[0]);
            let _e699 = (_e687[1] + select(0u, 1u, ((_e695 + _e687[0]) < _e687[0])));
            if (_e699 == 0u) {
            } else {
                let _e704 = atomicAdd((&global_11.member[(_e692 + 1u)]), _e699);
            }
        }
        let _e707 = local_1;
        let _e709 = bitcast<u32>(_e707.y);
        let _e712 = ((_e709 >> bitcast<u32>(23i)) & 255u);
        if (_e712 == 0u) {
        } else {
            let _e715 = (_e712 % 16u);
            let _e717 = ((_e709 & 8388607u) | 8388608u);
            let _e720 = (_e717 << bitcast<u32>((_e715 & 31u)));
            let _e726 = ((_e717 >> bitcast<u32>(((31u - _e715) & 31u))) >> bitcast<u32>(1i));
            if ((_e709 >> bitcast<u32>(31i)) == 0u) {
                phi_740_ = array<u32, 2>(_e720, _e726);
            } else {
                let _e732 = (~(_e720) + 1u);
                if (_e732 == 0u) {
                    phi_738_ = (~(_e726) + 1u);
                } else {
                    phi_738_ = ~(_e726);
                }
                let _e738 = phi_738_;
                phi_740_ = array<u32, 2>(_e732, _e738);
            }
            let _e741 = phi_740_;
            let _e742 = (_e712 < 255u);
            if _e742 {
                phi_746_ = _e741;
            } else {
                phi_746_ = array<u32, 2>(1u, 0u);
            }
            let _e745 = phi_746_;
            let _e750 = (2u * ((select(16u, (_e712 / 16u), _e742) * _e643) + (_e647 + 1u)));
            let _e753 = atomicAdd((&global_11.member[_e750]), _e745[0]);
            let _e757 = (_e745[1] + select(0u, 1u, ((_e753 + _e745[0]) < _e745[0])));
            if (_e757 == 0u) {
            } else {
                let _e762 = atomicAdd((&global_11.member[(_e750 + 1u)]), _e757);
            }
        }
        let _e765 = local_2;
        let _e767 = bitcast<u32>(_e765.z);
        let _e770 = ((_e767 >> bitcast<u32>(23i)) & 255u);
        if (_e770 == 0u) {
        } else {
            let _e773 = (_e770 % 16u);
            let _e775 = ((_e767 & 8388607u) | 8388608u);
            let _e778 = (_e775 << bitcast<u32>((_e773 & 31u)));
            let _e784 = ((_e775 >> bitcast<u32>(((31u - _e773) & 31u))) >> bitcast<u32>(1i));
            if ((_e767 >> bitcast<u32>(31i)) == 0u) {
                phi_802_ = array<u32, 2>(_e778, _e784);
            } else {
                let _e790 = (~(_e778) + 1u);
                if (_e790 == 0u) {
                    phi_800_ = (~(_e784) + 1u);
                } else {
                    phi_800_ = ~(_e784);
                }
                let _e796 = phi_800_;
                phi_802_ = array<u32, 2>(_e790, _e796);
            }
            let _e799 = phi_802_;
            let _e800 = (_e770 < 255u);
            if _e800 {
                phi_808_ = _e799;
            } else {
                phi_808_ = array<u32, 2>(1u, 0u);
            }
            let _e803 = phi_808_;
            let _e808 = (2u * ((select(16u, (_e770 / 16u), _e800) * _e643) + (_e647 + 2u)));
            let _e811 = atomicAdd((&global_11.member[_e808]), _e803[0]);
            let _e815 = (_e803[1] + select(0u, 1u, ((_e811 + _e803[0]) < _e803[0])));
            if (_e815 == 0u) {
            } else {
                let _e820 = atomicAdd((&global_11.member[(_e808 + 1u)]), _e815);
            }
        }
        let _e823 = local_3;
        let _e825 = bitcast<u32>(_e823.x);
        let _e828 = ((_e825 >> bitcast<u32>(23i)) & 255u);
        if (_e828 == 0u) {
        } else {
            let _e831 = (_e828 % 16u);
            let _e833 = ((_e825 & 8388607u) | 8388608u);
            let _e836 = (_e833 << bitcast<u32>((_e831 & 31u)));
            let _e842 = ((_e833 >> bitcast<u32>(((31u - _e831) & 31u))) >> bitcast<u32>(1i));
            if ((_e825 >> bitcast<u32>(31i)) == 0u) {
                phi_864_ = array<u32, 2>(_e836, _e842);
            } else {
                let _e848 = (~(_e836) + 1u);
                if (_e848 == 0u) {
                    phi_862_ = (~(_e842) + 1u);
                } else {
                    phi_862_ = ~(_e842);
                }
                let _e854 = phi_862_;
                phi_864_ = array<u32, 2>(_e848, _e854);
            }
            let _e857 = phi_864_;
            let _e858 = (_e828 < 255u);
            if _e858 {
                phi_870_ = _e857;
            } else {
                phi_870_ = array<u32, 2>(1u, 0u);
            }
            let _e861 = phi_870_;
            let _e866 = (2u * ((select(16u, (_e828 / 16u), _e858) * _e643) + (_e647 + 3u)));
            let _e869 = atomicAdd((&global_11.member[_e866]), _e861[0]);
            let _e873 = (_e861[1] + select(0u, 1u, ((_e869 + _e861[0]) < _e861[0])));
            if (_e873 == 0u) {
            } else {
                let _e878 = atomicAdd((&global_11.member[(_e866 + 1u)]), _e873);
            }
        }
        let _e881 = local_4;
        let _e883 = bitcast<u32>(_e881.y);
        let _e886 = ((_e883 >> bitcast<u32>(23i)) & 255u);
        if (_e886 == 0u) {
        } else {
            let _e889 = (_e886 % 16u);
            let _e891 = ((_e883 & 8388607u) | 8388608u);
            let _e894 = (_e891 << bitcast<u32>((_e889 & 31u)));
            let _e900 = ((_e891 >> bitcast<u32>(((31u - _e889) & 31u))) >> bitcast<u32>(1i));
            if ((_e883 >> bitcast<u32>(31i)) == 0u) {
                phi_926_ = array<u32, 2>(_e894, _e900);
            } else {
                let _e906 = (~(_e894) + 1u);
                if (_e906 == 0u) {
                    phi_924_ = (~(_e900) + 1u);
                } else {
                    phi_924_ = ~(_e900);
                }
                let _e912 = phi_924_;
                phi_926_ = array<u32, 2>(_e906, _e912);
            }
            let _e915 = phi_926_;
            let _e916 = (_e886 < 255u);
            if _e916 {
                phi_932_ = _e915;
            } else {
                phi_932_ = array<u32, 2>(1u, 0u);
            }
            let _e919 = phi_932_;
            let _e924 = (2u * ((select(16u, (_e886 / 16u), _e916) * _e643) + (_e647 + 4u)));
            let _e927 = atomicAdd((&global_11.member[_e924]), _e919[0]);
            let _e931 = (_e919[1] + select(0u, 1u, ((_e927 + _e919[0]) < _e919[0])));
            if (_e931 == 0u) {
            } else {
                let _e936 = atomicAdd((&global_11.member[(_e924 + 1u)]), _e931);
            }
        }
        let _e939 = local_5;
        let _e941 = bitcast<u32>(_e939.z);
        let _e944 = ((_e941 >> bitcast<u32>(23i)) & 255u);
        if (_e944 == 0u) {
        } else {
            let _e947 = (_e944 % 16u);
            let _e949 = ((_e941 & 8388607u) | 8388608u);
            let _e952 = (_e949 << bitcast<u32>((_e947 & 31u)));
            let _e958 = ((_e949 >> bitcast<u32>(((31u - _e947) & 31u))) >> bitcast<u32>(1i));
            if ((_e941 >> bitcast<u32>(31i)) == 0u) {
                phi_988_ = array<u32, 2>(_e952, _e958);
            } else {
                let _e964 = (~(_e952) + 1u);
                if (_e964 == 0u) {
                    phi_986_ = (~(_e958) + 1u);
                } else {
                    phi_986_ = ~(_e958);
                }
                let _e970 = phi_986_;
                phi_988_ = array<u32, 2>(_e964, _e970);
            }
            let _e973 = phi_988_;
            let _e974 = (_e944 < 255u);
            if _e974 {
                phi_994_ = _e973;
            } else {
                phi_994_ = array<u32, 2>(1u, 0u);
            }
            let _e977 = phi_994_;
            let _e982 = (2u * ((select(16u, (_e944 / 16u), _e974) * _e643) + (_e647 + 5u)));
            let _e985 = atomicAdd((&global_11.member[_e982]), _e977[0]);
            let _e989 = (_e977[1] + select(0u, 1u, ((_e985 + _e977[0]) < _e977[0])));
            if (_e989 == 0u) {
            } else {
                let _e994 = atomicAdd((&global_11.member[(_e982 + 1u)]), _e989);
            }
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
