struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
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

struct type_20 {
    member: array<vec4<f32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_6;
@group(0) @binding(2) 
var<storage> global_4: type_11;
@group(0) @binding(3) 
var<storage> global_5: type_11;
@group(0) @binding(4) 
var<storage> global_6: type_11;
@group(0) @binding(5) 
var<storage> global_7: type_15;
@group(0) @binding(6) 
var<storage> global_8: type_15;
@group(0) @binding(7) 
var<storage> global_9: type_20;
@group(0) @binding(1) 
var<storage> global_10: type_11;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_11;

fn function_() {
    var phi_580_: u32;
    var local: u32;

    let _e42 = global;
    let _e43 = global_1;
    let _e44 = global_2;
    let _e52 = (((_e43.x + (_e43.y * _e44.x)) * 64u) + _e42.x);
    let _e55 = global_3.member.member;
    if (_e52 < _e55) {
        let _e61 = (1u << bitcast<u32>(((_e52 % 32u) & 31u)));
        let _e62 = (_e52 * 3u);
        let _e65 = global_4.member[_e62];
        let _e66 = (_e62 + 1u);
        let _e69 = global_4.member[_e66];
        let _e70 = (_e62 + 2u);
        let _e73 = global_4.member[_e70];
        let _e74 = (_e52 * 4u);
        let _e77 = global_5.member[_e74];
        let _e81 = global_5.member[(_e74 + 1u)];
        let _e85 = global_5.member[(_e74 + 2u)];
        let _e89 = global_5.member[(_e74 + 3u)];
        let _e92 = global_6.member[_e62];
        let _e95 = global_6.member[_e66];
        let _e98 = global_6.member[_e70];
        let _e101 = global_3.member.member_2;
        let _e104 = global_3.member.member_3;
        phi_580_ = _e101;
        loop {
            let _e107 = phi_580_;
            if (_e107 < (_e101 + _e104)) {
                let _e111 = global_3.member.member_1;
                let _e113 = ((_e107 * _e111) + (_e52 / 32u));
                let _e116 = global_7.member[_e113];
                if ((_e116 & _e61) == 0u) {
                } else {
                    let _e124 = global_8.member[_e113];
                    let _e126 = (3u * (_e124 + countOneBits((_e116 & (_e61 - 1u)))));
                    let _e129 = global_9.member[_e126];
                    let _e133 = global_9.member[(_e126 + 1u)];
                    let _e140 = (_e107 * 18u);
                    let _e143 = global_10.member[_e140];
                    let _e147 = global_10.member[(_e140 + 1u)];
                    let _e151 = global_10.member[(_e140 + 2u)];
                    let _e155 = global_10.member[(_e140 + 3u)];
                    let _e159 = global_10.member[(_e140 + 4u)];
                    let _e163 = global_10.member[(_e140 + 5u)];
                    let _e167 = global_10.member[(_e140 + 6u)];
                    let _e171 = global_10.member[(_e140 + 7u)];
                    let _e175 = global_10.member[(_e140 + 8u)];
                    let _e179 = global_10.member[(_e140 + 9u)];
                    let _e183 = global_10.member[(_e140 + 10u)];
                    let _e187 = global_10.member[(_e140 + 11u)];
                    let _e191 = global_10.member[(_e140 + 12u)];
                    let _e195 = global_10.member[(_e140 + 13u)];
                    let _e199 = global_10.member[(_e140 + 14u)];
                    let _e203 = global_10.member[(_e140 + 15u)];
                    let _e207 = global_10.member[(_e140 + 16u)];
                    let _e211 = global_10.member[(_e140 + 17u)];
                    let _e214 = global_3.member.member_4;
                    let _e215 = (_e65 - _e179);
                    let _e216 = (_e69 - _e183);
                    let _e217 = (_e73 - _e187);
                    let _e232 = (((_e167 * _e215) + (_e171 * _e216)) + (_e175 * _e217));
                    let _e234 = select(1f, _e232, (0.01f < _e232));
                    let _e235 = (1f / _e191);
                    let _e236 = (1f / _e195);
                    let _e239 = ((_e207 * _e235) * 0.15f);
                    let _e240 = ((_e211 * _e236) * 0.15f);
                    let _e245 = (((_e199 * _e235) * -1f) - _e239);
                    let _e246 = (((_e203 * _e236) * -1f) - _e240);
                    let _e251 = (((_e207 - _e199) * _e235) + _e239);
                    let _e252 = (((_e211 - _e203) * _e236) + _e240);
                    let _e253 = ((((_e143 * _e215) + (_e147 * _e216)) + (_e151 * _e217)) / _e234);
                    let _e255 = select(_e245, _e253, (_e253 > _e245));
                    let _e257 = select(_e251, _e255, (_e255 < _e251));
                    let _e258 = ((((_e155 * _e215) + (_e159 * _e216)) + (_e163 * _e217)) / _e234);
                    let _e260 = select(_e246, _e258, (_e258 > _e246));
                    let _e262 = select(_e252, _e260, (_e260 < _e252));
                    let _e263 = (_e191 / _e234);
                    let _e264 = (_e195 / _e234);
                    let _e271 = ((_e143 - (_e167 * _e257)) * _e263);
                    let _e272 = ((_e147 - (_e171 * _e257)) * _e263);
                    let _e273 = ((_e151 - (_e175 * _e257)) * _e263);
                    let _e280 = ((_e155 - (_e167 * _e262)) * _e264);
                    let _e281 = ((_e159 - (_e171 * _e262)) * _e264);
                    let _e282 = ((_e163 - (_e175 * _e262)) * _e264);
                    let _e291 = (1f / sqrt(((((_e77 * _e77) + (_e81 * _e81)) + (_e85 * _e85)) + (_e89 * _e89))));
                    let _e292 = (_e77 * _e291);
                    let _e293 = (_e81 * _e291);
                    let _e294 = (_e85 * _e291);
                    let _e295 = (_e89 * _e291);
                    let _e296 = (_e294 * _e294);
                    let _e297 = (_e295 * _e295);
                    let _e300 = (1f - (2f * (_e296 + _e297)));
                    let _e301 = (_e293 * _e294);
                    let _e302 = (_e292 * _e295);
                    let _e304 = (2f * (_e301 + _e302));
                    let _e305 = (_e293 * _e295);
                    let _e306 = (_e292 * _e294);
                    let _e308 = (2f * (_e305 - _e306));
                    let _e310 = (2f * (_e301 - _e302));
                    let _e311 = (_e293 * _e293);
                    let _e314 = (1f - (2f * (_e311 + _e297)));
                    let _e315 = (_e294 * _e295);
                    let _e316 = (_e292 * _e293);
                    let _e318 = (2f * (_e315 + _e316));
                    let _e320 = (2f * (_e305 + _e306));
                    let _e322 = (2f * (_e315 - _e316));
                    let _e325 = (1f - (2f * (_e311 + _e296)));
                    let _e326 = exp(_e92);
                    let _e327 = exp(_e95);
                    let _e328 = exp(_e98);
                    let _e344 = ((((_e271 * _e300) + (_e272 * _e304)) + (_e273 * _e308)) * _e326);
                    let _e345 = ((((_e271 * _e310) + (_e272 * _e314)) + (_e273 * _e318)) * _e327);
                    let _e346 = ((((_e271 * _e320) + (_e272 * _e322)) + (_e273 * _e325)) * _e328);
                    let _e362 = ((((_e280 * _e300) + (_e281 * _e304)) + (_e282 * _e308)) * _e326);
                    let _e363 = ((((_e280 * _e310) + (_e281 * _e314)) + (_e282 * _e318)) * _e327);
                    let _e364 = ((((_e280 * _e320) + (_e281 * _e322)) + (_e282 * _e325)) * _e328);
                    let _e369 = (((_e344 * _e344) + (_e345 * _e345)) + (_e346 * _e346));
                    let _e379 = (((_e362 * _e362) + (_e363 * _e363)) + (_e364 * _e364));
                    let _e382 = ((_e345 * _e364) - (_e346 * _e363));
                    let _e385 = ((_e346 * _e362) - (_e344 * _e364));
                    let _e388 = ((_e344 * _e363) - (_e345 * _e362));
                    let _e399 = (1f / (((((_e382 * _e382) + (_e385 * _e385)) + (_e388 * _e388)) + (_e214 * (_e369 + _e379))) + (_e214 * _e214)));
                    let _e415 = (((_e344 * _e214) + ((_e363 * _e388) - (_e364 * _e385))) * _e399);
                    let _e416 = (((_e345 * _e214) + ((_e364 * _e382) - (_e362 * _e388))) * _e399);
                    let _e417 = (((_e346 * _e214) + ((_e362 * _e385) - (_e363 * _e382))) * _e399);
                    let _e433 = (((_e362 * _e214) + ((_e385 * _e346) - (_e388 * _e345))) * _e399);
                    let _e434 = (((_e363 * _e214) + ((_e388 * _e344) - (_e382 * _e346))) * _e399);
                    let _e435 = (((_e364 * _e214) + ((_e382 * _e345) - (_e385 * _e344))) * _e399);
                    let _e436 = (0.5f * _e133.y);
                    let _e443 = ((_e415 * _e133.x) + (_e433 * _e436));
                    let _e444 = ((_e416 * _e133.x) + (_e434 * _e436));
                    let _e445 = ((_e417 * _e133.x) + (_e435 * _e436));
                    let _e452 = ((_e415 * _e436) + (_e433 * _e133.z));
                    let _e453 = ((_e416 * _e436) + (_e434 * _e133.z));
                    let _e454 = ((_e417 * _e436) + (_e435 * _e133.z));
                    let _e456 = ((_e379 + _e214) * _e399);
                    let _e458 = (-((((_e344 * _e362) + (_e345 * _e363)) + (_e346 * _e364))) * _e399);
                    let _e460 = ((_e369 + _e214) * _e399);
                    let _e470 = (((_e443 * _e456) + (_e452 * _e458)) * -2f);
                    let _e471 = (((_e444 * _e456) + (_e453 * _e458)) * -2f);
                    let _e472 = (((_e445 * _e456) + (_e454 * _e458)) * -2f);
                    let _e482 = (((_e443 * _e458) + (_e452 * _e460)) * -2f);
                    let _e483 = (((_e444 * _e458) + (_e453 * _e460)) * -2f);
                    let _e484 = (((_e445 * _e458) + (_e454 * _e460)) * -2f);
                    let _e494 = (_e470 * _e326);
                    let _e495 = (_e471 * _e327);
                    let _e496 = (_e472 * _e328);
                    let _e497 = (_e482 * _e326);
                    let _e498 = (_e483 * _e327);
                    let _e499 = (_e484 * _e328);
                    let _e506 = ((_e271 * _e494) + (_e280 * _e497));
                    let _e507 = ((_e272 * _e494) + (_e281 * _e497));
                    let _e508 = ((_e273 * _e494) + (_e282 * _e497));
                    let _e515 = ((_e271 * _e495) + (_e280 * _e498));
                    let _e516 = ((_e272 * _e495) + (_e281 * _e498));
                    let _e517 = ((_e273 * _e495) + (_e282 * _e498));
                    let _e524 = ((_e271 * _e496) + (_e280 * _e499));
                    let _e525 = ((_e272 * _e496) + (_e281 * _e499));
                    let _e526 = ((_e273 * _e496) + (_e282 * _e499));
                    let _e539 = (((_e300 * _e494) + (_e310 * _e495)) + (_e320 * _e496));
                    let _e540 = (((_e304 * _e494) + (_e314 * _e495)) + (_e322 * _e496));
                    let _e541 = (((_e308 * _e494) + (_e318 * _e495)) + (_e325 * _e496));
                    let _e554 = (((_e300 * _e497) + (_e310 * _e498)) + (_e320 * _e499));
                    let _e555 = (((_e304 * _e497) + (_e314 * _e498)) + (_e322 * _e499));
                    let _e556 = (((_e308 * _e497) + (_e318 * _e498)) + (_e325 * _e499));
                    let _e557 = (1f / _e234);
                    let _e558 = (_e191 * _e557);
                    let _e559 = (_e195 * _e557);
                    let _e580 = ((_e558 * _e129.x) + (select(0f, (-(_e558) * (((_e539 * _e167) + (_e540 * _e171)) + (_e541 * _e175))), (_e257 == _e253)) / _e234));
                    let _e583 = ((_e559 * _e129.y) + (select(0f, (-(_e559) * (((_e554 * _e167) + (_e555 * _e171)) + (_e556 * _e175))), (_e262 == _e258)) / _e234));
                    let _e600 = (-(((_e253 * _e580) + (_e258 * _e583))) - (((((_e539 * _e271) + (_e540 * _e272)) + (_e541 * _e273)) + (((_e554 * _e280) + (_e555 * _e281)) + (_e556 * _e282))) / _e234));
                    let _e616 = (_e517 - _e525);
                    let _e617 = (_e524 - _e508);
                    let _e618 = (_e507 - _e515);
                    let _e619 = (_e507 + _e515);
                    let _e620 = (_e508 + _e524);
                    let _e621 = (_e517 + _e525);
                    let _e654 = ((((_e293 * _e616) + (_e294 * _e617)) + (_e295 * _e618)) * 2f);
                    let _e655 = (((((_e292 * _e616) + (_e294 * _e619)) + (_e295 * _e620)) - ((2f * _e293) * (_e516 + _e526))) * 2f);
                    let _e656 = (((((_e292 * _e617) + (_e293 * _e619)) + (_e295 * _e621)) - ((2f * _e294) * (_e506 + _e526))) * 2f);
                    let _e657 = (((((_e292 * _e618) + (_e293 * _e620)) + (_e294 * _e621)) - ((2f * _e295) * (_e506 + _e516))) * 2f);
                    let _e664 = ((((_e654 * _e292) + (_e655 * _e293)) + (_e656 * _e294)) + (_e657 * _e295));
                    let _e677 = (3u * _e52);
                    let _e680 = ((3u * _e55) + (4u * _e52));
                    let _e682 = ((7u * _e55) + _e677);
                    let _e685 = global_3.member.member_5;
                    let _e690 = global_11.member[_e677];
                    let _e698 = global_11.member[(_e677 + 1u)];
                    let _e706 = global_11.member[(_e677 + 2u)];
                    let _e713 = global_11.member[_e680];
                    let _e721 = global_11.member[(_e680 + 1u)];
                    let _e729 = global_11.member[(_e680 + 2u)];
                    let _e737 = global_11.member[(_e680 + 3u)];
                    let _e744 = global_11.member[_e682];
                    let _e752 = global_11.member[(_e682 + 1u)];
                    let _e760 = global_11.member[(_e682 + 2u)];
                    let _e767 = global_11.member[((10u * _e55) + _e52)];
                    global_11.member[_e677] = (_e690 + bitcast<f32>((bitcast<u32>((((_e143 * _e580) + (_e155 * _e583)) + (_e167 * _e600))) & _e685)));
                    global_11.member[(_e677 + 1u)] = (_e698 + bitcast<f32>((bitcast<u32>((((_e147 * _e580) + (_e159 * _e583)) + (_e171 * _e600))) & _e685)));
                    global_11.member[(_e677 + 2u)] = (_e706 + bitcast<f32>((bitcast<u32>((((_e151 * _e580) + (_e163 * _e583)) + (_e175 * _e600))) & _e685)));
                    global_11.member[_e680] = (_e713 + bitcast<f32>((bitcast<u32>(((_e654 - (_e292 * _e664)) * _e291)) & _e685)));
                    global_11.member[(_e680 + 1u)] = (_e721 + bitcast<f32>((bitcast<u32>(((_e655 - (_e293 * _e664)) * _e291)) & _e685)));
                    global_11.member[(_e680 + 2u)] = (_e729 + bitcast<f32>((bitcast<u32>(((_e656 - (_e294 * _e664)) * _e291)) & _e685)));
                    global_11.member[(_e680 + 3u)] = (_e737 + bitcast<f32>((bitcast<u32>(((_e657 - (_e295 * _e664)) * _e291)) & _e685)));
                    global_11.member[_e682] = (_e744 + bitcast<f32>((bitcast<u32>(((_e470 * _e344) + (_e482 * _e362))) & _e685)));
                    global_11.member[(_e682 + 1u)] = (_e752 + bitcast<f32>((bitcast<u32>(((_e471 * _e345) + (_e483 * _e363))) & _e685)));
                    global_11.member[(_e682 + 2u)] = (_e760 + bitcast<f32>((bitcast<u32>(((_e472 * _e346) + (_e484 * _e364))) & _e685)));
                    global_11.member[((10u * _e55) + _e52)] = (_e767 + bitcast<f32>((bitcast<u32>(_e129.z) & _e685)));
                }
                local = (_e107 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e775 = local;
                phi_580_ = _e775;
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
