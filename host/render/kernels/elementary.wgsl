struct type_4 {
    member: u32,
}

struct type_5 {
    member: type_4,
}

struct type_11 {
    member: array<f32>,
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
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_537_: u32;
    var phi_538_: u32;
    var phi_539_: u32;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_584_: u32;
    var phi_585_: u32;
    var phi_586_: u32;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_631_: u32;
    var phi_634_: u32;
    var phi_652_: u32;
    var phi_655_: u32;

    let _e113 = global;
    let _e114 = global_1;
    let _e115 = global_2;
    let _e123 = (((_e114.x + (_e114.y * _e115.x)) * 64u) + _e113.x);
    let _e126 = global_3.member.member;
    if (_e123 < _e126) {
        let _e130 = global_4.member[_e123];
        let _e133 = global_5.member[_e123];
        let _e136 = global_6.member[_e123];
        let _e137 = (_e130 * 0.63661975f);
        let _e138 = trunc(_e137);
        let _e139 = (_e137 - _e138);
        let _e143 = -(0.5f);
        let _e146 = select(select(_e138, (_e138 + 1f), (0.5f <= _e139)), (_e138 - 1f), (_e139 <= _e143));
        let _e152 = (((_e130 - (_e146 * 1.5703125f)) - (_e146 * 0.0004837513f)) - (_e146 * 0.0000000754979f));
        let _e154 = (_e152 * _e152);
        let _e161 = (((((((-0.00019515296f * _e154) + 0.008332161f) * _e154) - 0.16666655f) * _e154) * _e152) + _e152);
        let _e170 = ((((((((0.000024433157f * _e154) - 0.0013887316f) * _e154) + 0.041666646f) * _e154) * _e154) - (0.5f * _e154)) + 1f);
        let _e171 = ((_e146 + 0f) * 0.5f);
        let _e172 = trunc(_e171);
        let _e178 = (_e171 * 0.5f);
        let _e179 = trunc(_e178);
        let _e185 = select(_e161, _e170, (0.25f < (_e171 - select(_e172, (_e172 - 1f), (_e171 < _e172)))));
        let _e187 = select(_e185, -(_e185), (0.5f <= (_e178 - select(_e179, (_e179 - 1f), (_e178 < _e179)))));
        global_7.member[_e123] = _e187;
        let _e192 = ((_e146 + 1f) * 0.5f);
        let _e193 = trunc(_e192);
        let _e199 = (_e192 * 0.5f);
        let _e200 = trunc(_e199);
        let _e206 = select(_e161, _e170, (0.25f < (_e192 - select(_e193, (_e193 - 1f), (_e192 < _e193)))));
        let _e208 = select(_e206, -(_e206), (0.5f <= (_e199 - select(_e200, (_e200 - 1f), (_e199 < _e200)))));
        global_7.member[(_e126 + _e123)] = _e208;
        global_7.member[((2u * _e126) + _e123)] = (_e187 / _e208);
        let _e218 = bitcast<u32>(_e136);
        let _e219 = (_e218 - 1060439283u);
        let _e223 = f32((bitcast<i32>(_e219) >> bitcast<u32>(23i)));
        let _e226 = bitcast<f32>(((_e219 & 8388607u) + 1060439283u));
        let _e229 = ((_e226 - 1f) / (_e226 + 1f));
        let _e230 = (_e229 * _e229);
        let _e242 = (2f * _e229);
        let _e243 = (_e242 * (_e230 * ((1f / 3f) + (_e230 * ((1f / 5f) + (_e230 * ((1f / 7f) + (_e230 * (1f / 9f)))))))));
        let _e248 = ((_e223 * 0.6933594f) + (_e242 + (_e243 - (_e223 * 0.00021219444f))));
        global_7.member[((3u * _e126) + _e123)] = _e248;
        global_7.member[((4u * _e126) + _e123)] = exp((_e133 * _e248));
        let _e259 = trunc(_e130);
        let _e261 = (_e259 - 1f);
        global_7.member[((5u * _e126) + _e123)] = select(_e259, _e261, (_e130 < _e259));
        let _e267 = (_e130 - _e259);
        global_7.member[((6u * _e126) + _e123)] = select(select(_e259, (_e259 + 1f), (0.5f <= _e267)), _e261, (_e267 <= _e143));
        global_7.member[((7u * _e126) + _e123)] = abs(_e130);
        let _e283 = select(0f, _e130, (_e130 > 0f));
        global_7.member[((8u * _e126) + _e123)] = select(1f, _e283, (_e283 < 1f));
        global_7.member[((9u * _e126) + _e123)] = (_e130 + (_e136 * (_e133 - _e130)));
        let _e297 = (_e133 < 0f);
        let _e300 = -(select(-(_e133), _e133, _e297));
        let _e301 = (0.5f < _e300);
        let _e305 = ((1f - select(1f, _e300, (_e300 < 1f))) * 0.5f);
        let _e307 = select((_e300 * _e300), _e305, _e301);
        let _e309 = select(_e300, sqrt(_e305), _e301);
        let _e320 = (((((((((((0.0421632f * _e307) + 0.02418131f) * _e307) + 0.045470025f) * _e307) + 0.074953005f) * _e307) + 0.16666752f) * _e307) * _e309) + _e309);
        let _e322 = select(_e320, (_e320 + _e320), _e301);
        let _e324 = select(_e322, (1.5707964f - _e322), _e301);
        global_7.member[((10u * _e126) + _e123)] = select(_e324, -(_e324), _e297);
        global_7.member[((11u * _e126) + _e123)] = select((1.5707964f - select(_e322, -(_e322), _e297)), select(_e322, (3.1415927f - _e322), _e297), _e301);
        let _e341 = (_e130 < 0f);
        let _e344 = -(select(-(_e130), _e130, _e341));
        let _e345 = (2.4142137f < _e344);
        let _e346 = (0.41421357f < _e344);
        let _e352 = select(select(_e344, ((_e344 - 1f) / (_e344 + 1f)), _e346), (-1f / _e344), _e345);
        let _e355 = (_e352 * _e352);
        let _e365 = (select(select(0f, 0.7853982f, _e346), 1.5707964f, _e345) + (((((((((0.080537446f * _e355) - 0.13877685f) * _e355) + 0.19977711f) * _e355) - 0.3333295f) * _e355) * _e352) + _e352));
        global_7.member[((12u * _e126) + _e123)] = select(_e365, -(_e365), _e341);
        let _e372 = (-10f - _e133);
        let _e373 = (_e372 < 0f);
        let _e376 = -(select(-(_e372), _e372, _e373));
        let _e377 = (_e344 < _e376);
        let _e380 = select(_e376, _e344, (_e344 > _e376));
        let _e383 = (select(_e376, _e344, _e377) / select(0.000000000000000000000000000000000000011754944f, _e380, (_e380 > 0.000000000000000000000000000000000000011754944f)));
        let _e384 = (_e383 < 0f);
        let _e387 = -(select(-(_e383), _e383, _e384));
        let _e388 = (2.4142137f < _e387);
        let _e389 = (0.41421357f < _e387);
        let _e395 = select(select(_e387, ((_e387 - 1f) / (_e387 + 1f)), _e389), (-1f / _e387), _e388);
        let _e398 = (_e395 * _e395);
        let _e408 = (select(select(0f, 0.7853982f, _e389), 1.5707964f, _e388) + (((((((((0.080537446f * _e398) - 0.13877685f) * _e398) + 0.19977711f) * _e398) - 0.3333295f) * _e398) * _e395) + _e395));
        let _e410 = select(_e408, -(_e408), _e384);
        let _e412 = select(_e410, (1.5707964f - _e410), _e377);
        let _e414 = select(_e412, (3.1415927f - _e412), _e341);
        global_7.member[((13u * _e126) + _e123)] = select(_e414, -(_e414), _e373);
        let _e422 = select(-151f, _e133, (_e133 > -151f));
        let _e424 = select(129f, _e422, (_e422 < 129f));
        let _e425 = trunc(_e424);
        let _e426 = (_e424 - _e425);
        let _e432 = select(select(_e425, (_e425 + 1f), (0.5f <= _e426)), (_e425 - 1f), (_e426 <= _e143));
        let _e433 = (_e133 - _e432);
        let _e455 = select(0i, select(select(i32(_e432), i32(-2147483648), !((_e432 >= bitcast<f32>(3472883712u)))), 2147483647i, (_e432 > bitcast<f32>(1325400063u))), ((bitcast<u32>(_e432) & 2147483647u) <= 2139095040u));
        let _e456 = (_e455 / 2i);
        if (_e133 < -151f) {
            phi_507_ = 0f;
        } else {
            if (_e133 > 129f) {
                phi_506_ = bitcast<f32>(2139095040u);
            } else {
                phi_506_ = ((((((((((((((0.00015353362f * _e433) + 0.0013398874f) * _e433) + 0.009618437f) * _e433) + 0.055503324f) * _e433) + 0.24022648f) * _e433) + 0.6931472f) * _e433) + 1f) * bitcast<f32>((bitcast<u32>((_e456 + 127i)) << bitcast<u32>(23i)))) * bitcast<f32>((bitcast<u32>(((_e455 - _e456) + 127i)) << bitcast<u32>(23i))));
            }
            let _e476 = phi_506_;
            phi_507_ = _e476;
        }
        let _e478 = phi_507_;
        global_7.member[((14u * _e126) + _e123)] = _e478;
        global_7.member[((15u * _e126) + _e123)] = (_e223 + ((_e242 + _e243) * 1.442695f));
        let _e490 = (_e133 + _e133);
        let _e494 = exp(select(-(_e490), _e490, (_e490 < 0f)));
        let _e497 = ((1f - _e494) / (1f + _e494));
        let _e500 = (_e133 * _e133);
        global_7.member[((16u * _e126) + _e123)] = select(select(_e497, -(_e497), _e297), (((((((((((-0.0057049887f * _e500) + 0.02063909f) * _e500) - 0.053739715f) * _e500) + 0.13331442f) * _e500) - 0.3333328f) * _e500) * _e133) + _e133), (_e300 < 0.625f));
        let _e519 = (_e218 & 2147483647u);
        let _e521 = (_e519 >> bitcast<u32>(23i));
        if (_e521 < 113u) {
            if (_e521 < 101u) {
                phi_537_ = 25u;
            } else {
                phi_537_ = (126u - _e521);
            }
            let _e529 = phi_537_;
            phi_538_ = ((_e519 & 8388607u) | 8388608u);
            phi_539_ = _e529;
        } else {
            phi_538_ = (_e519 - 939524096u);
            phi_539_ = 13u;
        }
        let _e531 = phi_538_;
        let _e533 = phi_539_;
        let _e534 = (_e533 & 31u);
        let _e536 = (_e531 >> bitcast<u32>(_e534));
        let _e540 = (_e531 & ((1u << bitcast<u32>(_e534)) - 1u));
        let _e544 = (1u << bitcast<u32>(((_e533 - 1u) & 31u)));
        if (_e540 > _e544) {
            phi_559_ = true;
        } else {
            if (_e540 == _e544) {
                phi_558_ = ((_e536 & 1u) == 1u);
            } else {
                phi_558_ = false;
            }
            let _e550 = phi_558_;
            phi_559_ = _e550;
        }
        let _e552 = phi_559_;
        let _e554 = (_e536 + select(0u, 1u, _e552));
        let _e560 = bitcast<u32>(_e130);
        let _e564 = (_e560 & 2147483647u);
        let _e566 = (_e564 >> bitcast<u32>(23i));
        if (_e566 < 113u) {
            if (_e566 < 101u) {
                phi_584_ = 25u;
            } else {
                phi_584_ = (126u - _e566);
            }
            let _e574 = phi_584_;
            phi_585_ = ((_e564 & 8388607u) | 8388608u);
            phi_586_ = _e574;
        } else {
            phi_585_ = (_e564 - 939524096u);
            phi_586_ = 13u;
        }
        let _e576 = phi_585_;
        let _e578 = phi_586_;
        let _e579 = (_e578 & 31u);
        let _e581 = (_e576 >> bitcast<u32>(_e579));
        let _e585 = (_e576 & ((1u << bitcast<u32>(_e579)) - 1u));
        let _e589 = (1u << bitcast<u32>(((_e578 - 1u) & 31u)));
        if (_e585 > _e589) {
            phi_606_ = true;
        } else {
            if (_e585 == _e589) {
                phi_605_ = ((_e581 & 1u) == 1u);
            } else {
                phi_605_ = false;
            }
            let _e595 = phi_605_;
            phi_606_ = _e595;
        }
        let _e597 = phi_606_;
        let _e599 = (_e581 + select(0u, 1u, _e597));
        let _e607 = ((((_e218 >> bitcast<u32>(16i)) & 32768u) | select(select(_e554, 31744u, (_e554 > 31744u)), 32256u, (_e519 > 2139095040u))) | ((((_e560 >> bitcast<u32>(16i)) & 32768u) | select(select(_e599, 31744u, (_e599 > 31744u)), 32256u, (_e564 > 2139095040u))) << bitcast<u32>(16i)));
        let _e608 = (_e607 & 65535u);
        let _e612 = (_e608 & 32767u);
        let _e614 = (_e612 << bitcast<u32>(13i));
        if (_e612 < 1024u) {
            phi_634_ = bitcast<u32>((f32(_e612) * 0.000000059604645f));
        } else {
            if (_e612 < 31744u) {
                phi_631_ = (_e614 + 939524096u);
            } else {
                phi_631_ = (_e614 | 2139095040u);
            }
            let _e620 = phi_631_;
            phi_634_ = _e620;
        }
        let _e625 = phi_634_;
        let _e629 = (_e607 >> bitcast<u32>(16i));
        let _e633 = (_e629 & 32767u);
        let _e635 = (_e633 << bitcast<u32>(13i));
        if (_e633 < 1024u) {
            phi_655_ = bitcast<u32>((f32(_e633) * 0.000000059604645f));
        } else {
            if (_e633 < 31744u) {
                phi_652_ = (_e635 + 939524096u);
            } else {
                phi_652_ = (_e635 | 2139095040u);
            }
            let _e641 = phi_652_;
            phi_655_ = _e641;
        }
        let _e646 = phi_655_;
        global_7.member[((17u * _e126) + _e123)] = bitcast<f32>((((_e608 & 32768u) << bitcast<u32>(16i)) | _e625));
        global_7.member[((18u * _e126) + _e123)] = bitcast<f32>((((_e629 & 32768u) << bitcast<u32>(16i)) | _e646));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn elementary(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
