struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_5;
@group(0) @binding(2) 
var<storage> global_4: type_5;
@group(0) @binding(3) 
var<storage> global_5: type_5;
@group(0) @binding(4) 
var<storage> global_6: type_5;
@group(0) @binding(7) 
var<storage> global_7: type_17;
@group(0) @binding(0) 
var<uniform> global_8: type_21;
@group(0) @binding(5) 
var<storage> global_9: type_12;
@group(0) @binding(6) 
var<storage> global_10: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_5;

fn function_() {
    var phi_581_: u32;
    var local: u32;

    let _e43 = global;
    let _e44 = global_1;
    let _e45 = global_2;
    let _e53 = (((_e44.x + (_e44.y * _e45.x)) * 64u) + _e43.x);
    let _e56 = global_8.member.member;
    if (_e53 < _e56) {
        let _e62 = (1u << bitcast<u32>(((_e53 % 32u) & 31u)));
        let _e63 = (_e53 * 3u);
        let _e66 = global_4.member[_e63];
        let _e67 = (_e63 + 1u);
        let _e70 = global_4.member[_e67];
        let _e71 = (_e63 + 2u);
        let _e74 = global_4.member[_e71];
        let _e75 = (_e53 * 4u);
        let _e78 = global_5.member[_e75];
        let _e82 = global_5.member[(_e75 + 1u)];
        let _e86 = global_5.member[(_e75 + 2u)];
        let _e90 = global_5.member[(_e75 + 3u)];
        let _e93 = global_6.member[_e63];
        let _e96 = global_6.member[_e67];
        let _e99 = global_6.member[_e71];
        let _e102 = global_8.member.member_2;
        let _e105 = global_8.member.member_3;
        phi_581_ = _e102;
        loop {
            let _e108 = phi_581_;
            if (_e108 < (_e102 + _e105)) {
                let _e112 = global_8.member.member_1;
                let _e114 = ((_e108 * _e112) + (_e53 / 32u));
                let _e117 = global_9.member[_e114];
                if ((_e117 & _e62) == 0u) {
                } else {
                    let _e125 = global_10.member[_e114];
                    let _e127 = (3u * (_e125 + countOneBits((_e117 & (_e62 - 1u)))));
                    let _e130 = global_7.member[_e127];
                    let _e134 = global_7.member[(_e127 + 1u)];
                    let _e141 = (_e108 * 18u);
                    let _e144 = global_3.member[_e141];
                    let _e148 = global_3.member[(_e141 + 1u)];
                    let _e152 = global_3.member[(_e141 + 2u)];
                    let _e156 = global_3.member[(_e141 + 3u)];
                    let _e160 = global_3.member[(_e141 + 4u)];
                    let _e164 = global_3.member[(_e141 + 5u)];
                    let _e168 = global_3.member[(_e141 + 6u)];
                    let _e172 = global_3.member[(_e141 + 7u)];
                    let _e176 = global_3.member[(_e141 + 8u)];
                    let _e180 = global_3.member[(_e141 + 9u)];
                    let _e184 = global_3.member[(_e141 + 10u)];
                    let _e188 = global_3.member[(_e141 + 11u)];
                    let _e192 = global_3.member[(_e141 + 12u)];
                    let _e196 = global_3.member[(_e141 + 13u)];
                    let _e200 = global_3.member[(_e141 + 14u)];
                    let _e204 = global_3.member[(_e141 + 15u)];
                    let _e208 = global_3.member[(_e141 + 16u)];
                    let _e212 = global_3.member[(_e141 + 17u)];
                    let _e215 = global_8.member.member_4;
                    let _e216 = (_e66 - _e180);
                    let _e217 = (_e70 - _e184);
                    let _e218 = (_e74 - _e188);
                    let _e233 = (((_e168 * _e216) + (_e172 * _e217)) + (_e176 * _e218));
                    let _e235 = select(1f, _e233, (0.01f < _e233));
                    let _e236 = (1f / _e192);
                    let _e237 = (1f / _e196);
                    let _e240 = ((_e208 * _e236) * 0.15f);
                    let _e241 = ((_e212 * _e237) * 0.15f);
                    let _e246 = (((_e200 * _e236) * -1f) - _e240);
                    let _e247 = (((_e204 * _e237) * -1f) - _e241);
                    let _e252 = (((_e208 - _e200) * _e236) + _e240);
                    let _e253 = (((_e212 - _e204) * _e237) + _e241);
                    let _e254 = ((((_e144 * _e216) + (_e148 * _e217)) + (_e152 * _e218)) / _e235);
                    let _e256 = select(_e246, _e254, (_e254 > _e246));
                    let _e258 = select(_e252, _e256, (_e256 < _e252));
                    let _e259 = ((((_e156 * _e216) + (_e160 * _e217)) + (_e164 * _e218)) / _e235);
                    let _e261 = select(_e247, _e259, (_e259 > _e247));
                    let _e263 = select(_e253, _e261, (_e261 < _e253));
                    let _e264 = (_e192 / _e235);
                    let _e265 = (_e196 / _e235);
                    let _e272 = ((_e144 - (_e168 * _e258)) * _e264);
                    let _e273 = ((_e148 - (_e172 * _e258)) * _e264);
                    let _e274 = ((_e152 - (_e176 * _e258)) * _e264);
                    let _e281 = ((_e156 - (_e168 * _e263)) * _e265);
                    let _e282 = ((_e160 - (_e172 * _e263)) * _e265);
                    let _e283 = ((_e164 - (_e176 * _e263)) * _e265);
                    let _e292 = (1f / sqrt(((((_e78 * _e78) + (_e82 * _e82)) + (_e86 * _e86)) + (_e90 * _e90))));
                    let _e293 = (_e78 * _e292);
                    let _e294 = (_e82 * _e292);
                    let _e295 = (_e86 * _e292);
                    let _e296 = (_e90 * _e292);
                    let _e297 = (_e295 * _e295);
                    let _e298 = (_e296 * _e296);
                    let _e301 = (1f - (2f * (_e297 + _e298)));
                    let _e302 = (_e294 * _e295);
                    let _e303 = (_e293 * _e296);
                    let _e305 = (2f * (_e302 + _e303));
                    let _e306 = (_e294 * _e296);
                    let _e307 = (_e293 * _e295);
                    let _e309 = (2f * (_e306 - _e307));
                    let _e311 = (2f * (_e302 - _e303));
                    let _e312 = (_e294 * _e294);
                    let _e315 = (1f - (2f * (_e312 + _e298)));
                    let _e316 = (_e295 * _e296);
                    let _e317 = (_e293 * _e294);
                    let _e319 = (2f * (_e316 + _e317));
                    let _e321 = (2f * (_e306 + _e307));
                    let _e323 = (2f * (_e316 - _e317));
                    let _e326 = (1f - (2f * (_e312 + _e297)));
                    let _e327 = exp(_e93);
                    let _e328 = exp(_e96);
                    let _e329 = exp(_e99);
                    let _e345 = ((((_e272 * _e301) + (_e273 * _e305)) + (_e274 * _e309)) * _e327);
                    let _e346 = ((((_e272 * _e311) + (_e273 * _e315)) + (_e274 * _e319)) * _e328);
                    let _e347 = ((((_e272 * _e321) + (_e273 * _e323)) + (_e274 * _e326)) * _e329);
                    let _e363 = ((((_e281 * _e301) + (_e282 * _e305)) + (_e283 * _e309)) * _e327);
                    let _e364 = ((((_e281 * _e311) + (_e282 * _e315)) + (_e283 * _e319)) * _e328);
                    let _e365 = ((((_e281 * _e321) + (_e282 * _e323)) + (_e283 * _e326)) * _e329);
                    let _e370 = (((_e345 * _e345) + (_e346 * _e346)) + (_e347 * _e347));
                    let _e380 = (((_e363 * _e363) + (_e364 * _e364)) + (_e365 * _e365));
                    let _e383 = ((_e346 * _e365) - (_e347 * _e364));
                    let _e386 = ((_e347 * _e363) - (_e345 * _e365));
                    let _e389 = ((_e345 * _e364) - (_e346 * _e363));
                    let _e400 = (1f / (((((_e383 * _e383) + (_e386 * _e386)) + (_e389 * _e389)) + (_e215 * (_e370 + _e380))) + (_e215 * _e215)));
                    let _e416 = (((_e345 * _e215) + ((_e364 * _e389) - (_e365 * _e386))) * _e400);
                    let _e417 = (((_e346 * _e215) + ((_e365 * _e383) - (_e363 * _e389))) * _e400);
                    let _e418 = (((_e347 * _e215) + ((_e363 * _e386) - (_e364 * _e383))) * _e400);
                    let _e434 = (((_e363 * _e215) + ((_e386 * _e347) - (_e389 * _e346))) * _e400);
                    let _e435 = (((_e364 * _e215) + ((_e389 * _e345) - (_e383 * _e347))) * _e400);
                    let _e436 = (((_e365 * _e215) + ((_e383 * _e346) - (_e386 * _e345))) * _e400);
                    let _e437 = (0.5f * _e134.y);
                    let _e444 = ((_e416 * _e134.x) + (_e434 * _e437));
                    let _e445 = ((_e417 * _e134.x) + (_e435 * _e437));
                    let _e446 = ((_e418 * _e134.x) + (_e436 * _e437));
                    let _e453 = ((_e416 * _e437) + (_e434 * _e134.z));
                    let _e454 = ((_e417 * _e437) + (_e435 * _e134.z));
                    let _e455 = ((_e418 * _e437) + (_e436 * _e134.z));
                    let _e457 = ((_e380 + _e215) * _e400);
                    let _e459 = (-((((_e345 * _e363) + (_e346 * _e364)) + (_e347 * _e365))) * _e400);
                    let _e461 = ((_e370 + _e215) * _e400);
                    let _e471 = (((_e444 * _e457) + (_e453 * _e459)) * -2f);
                    let _e472 = (((_e445 * _e457) + (_e454 * _e459)) * -2f);
                    let _e473 = (((_e446 * _e457) + (_e455 * _e459)) * -2f);
                    let _e483 = (((_e444 * _e459) + (_e453 * _e461)) * -2f);
                    let _e484 = (((_e445 * _e459) + (_e454 * _e461)) * -2f);
                    let _e485 = (((_e446 * _e459) + (_e455 * _e461)) * -2f);
                    let _e495 = (_e471 * _e327);
                    let _e496 = (_e472 * _e328);
                    let _e497 = (_e473 * _e329);
                    let _e498 = (_e483 * _e327);
                    let _e499 = (_e484 * _e328);
                    let _e500 = (_e485 * _e329);
                    let _e507 = ((_e272 * _e495) + (_e281 * _e498));
                    let _e508 = ((_e273 * _e495) + (_e282 * _e498));
                    let _e509 = ((_e274 * _e495) + (_e283 * _e498));
                    let _e516 = ((_e272 * _e496) + (_e281 * _e499));
                    let _e517 = ((_e273 * _e496) + (_e282 * _e499));
                    let _e518 = ((_e274 * _e496) + (_e283 * _e499));
                    let _e525 = ((_e272 * _e497) + (_e281 * _e500));
                    let _e526 = ((_e273 * _e497) + (_e282 * _e500));
                    let _e527 = ((_e274 * _e497) + (_e283 * _e500));
                    let _e540 = (((_e301 * _e495) + (_e311 * _e496)) + (_e321 * _e497));
                    let _e541 = (((_e305 * _e495) + (_e315 * _e496)) + (_e323 * _e497));
                    let _e542 = (((_e309 * _e495) + (_e319 * _e496)) + (_e326 * _e497));
                    let _e555 = (((_e301 * _e498) + (_e311 * _e499)) + (_e321 * _e500));
                    let _e556 = (((_e305 * _e498) + (_e315 * _e499)) + (_e323 * _e500));
                    let _e557 = (((_e309 * _e498) + (_e319 * _e499)) + (_e326 * _e500));
                    let _e558 = (1f / _e235);
                    let _e559 = (_e192 * _e558);
                    let _e560 = (_e196 * _e558);
                    let _e581 = ((_e559 * _e130.x) + (select(0f, (-(_e559) * (((_e540 * _e168) + (_e541 * _e172)) + (_e542 * _e176))), (_e258 == _e254)) / _e235));
                    let _e584 = ((_e560 * _e130.y) + (select(0f, (-(_e560) * (((_e555 * _e168) + (_e556 * _e172)) + (_e557 * _e176))), (_e263 == _e259)) / _e235));
                    let _e601 = (-(((_e254 * _e581) + (_e259 * _e584))) - (((((_e540 * _e272) + (_e541 * _e273)) + (_e542 * _e274)) + (((_e555 * _e281) + (_e556 * _e282)) + (_e557 * _e283))) / _e235));
                    let _e617 = (_e518 - _e526);
                    let _e618 = (_e525 - _e509);
                    let _e619 = (_e508 - _e516);
                    let _e620 = (_e508 + _e516);
                    let _e621 = (_e509 + _e525);
                    let _e622 = (_e518 + _e526);
                    let _e655 = ((((_e294 * _e617) + (_e295 * _e618)) + (_e296 * _e619)) * 2f);
                    let _e656 = (((((_e293 * _e617) + (_e295 * _e620)) + (_e296 * _e621)) - ((2f * _e294) * (_e517 + _e527))) * 2f);
                    let _e657 = (((((_e293 * _e618) + (_e294 * _e620)) + (_e296 * _e622)) - ((2f * _e295) * (_e507 + _e527))) * 2f);
                    let _e658 = (((((_e293 * _e619) + (_e294 * _e621)) + (_e295 * _e622)) - ((2f * _e296) * (_e507 + _e517))) * 2f);
                    let _e665 = ((((_e655 * _e293) + (_e656 * _e294)) + (_e657 * _e295)) + (_e658 * _e296));
                    let _e678 = (3u * _e53);
                    let _e681 = ((3u * _e56) + (4u * _e53));
                    let _e683 = ((7u * _e56) + _e678);
                    let _e686 = global_8.member.member_5;
                    let _e691 = global_11.member[_e678];
                    let _e699 = global_11.member[(_e678 + 1u)];
                    let _e707 = global_11.member[(_e678 + 2u)];
                    let _e714 = global_11.member[_e681];
                    let _e722 = global_11.member[(_e681 + 1u)];
                    let _e730 = global_11.member[(_e681 + 2u)];
                    let _e738 = global_11.member[(_e681 + 3u)];
                    let _e745 = global_11.member[_e683];
                    let _e753 = global_11.member[(_e683 + 1u)];
                    let _e761 = global_11.member[(_e683 + 2u)];
                    let _e768 = global_11.member[((10u * _e56) + _e53)];
                    global_11.member[_e678] = (_e691 + bitcast<f32>((bitcast<u32>((((_e144 * _e581) + (_e156 * _e584)) + (_e168 * _e601))) & _e686)));
                    global_11.member[(_e678 + 1u)] = (_e699 + bitcast<f32>((bitcast<u32>((((_e148 * _e581) + (_e160 * _e584)) + (_e172 * _e601))) & _e686)));
                    global_11.member[(_e678 + 2u)] = (_e707 + bitcast<f32>((bitcast<u32>((((_e152 * _e581) + (_e164 * _e584)) + (_e176 * _e601))) & _e686)));
                    global_11.member[_e681] = (_e714 + bitcast<f32>((bitcast<u32>(((_e655 - (_e293 * _e665)) * _e292)) & _e686)));
                    global_11.member[(_e681 + 1u)] = (_e722 + bitcast<f32>((bitcast<u32>(((_e656 - (_e294 * _e665)) * _e292)) & _e686)));
                    global_11.member[(_e681 + 2u)] = (_e730 + bitcast<f32>((bitcast<u32>(((_e657 - (_e295 * _e665)) * _e292)) & _e686)));
                    global_11.member[(_e681 + 3u)] = (_e738 + bitcast<f32>((bitcast<u32>(((_e658 - (_e296 * _e665)) * _e292)) & _e686)));
                    global_11.member[_e683] = (_e745 + bitcast<f32>((bitcast<u32>(((_e471 * _e345) + (_e483 * _e363))) & _e686)));
                    global_11.member[(_e683 + 1u)] = (_e753 + bitcast<f32>((bitcast<u32>(((_e472 * _e346) + (_e484 * _e364))) & _e686)));
                    global_11.member[(_e683 + 2u)] = (_e761 + bitcast<f32>((bitcast<u32>(((_e473 * _e347) + (_e485 * _e365))) & _e686)));
                    global_11.member[((10u * _e56) + _e53)] = (_e768 + bitcast<f32>((bitcast<u32>(_e130.z) & _e686)));
                }
                local = (_e108 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e776 = local;
                phi_581_ = _e776;
            }
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn project_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
