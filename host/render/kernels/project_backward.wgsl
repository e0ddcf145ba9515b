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
                    let _e136 = (_e107 * 18u);
                    let _e139 = global_10.member[_e136];
                    let _e143 = global_10.member[(_e136 + 1u)];
                    let _e147 = global_10.member[(_e136 + 2u)];
                    let _e151 = global_10.member[(_e136 + 3u)];
                    let _e155 = global_10.member[(_e136 + 4u)];
                    let _e159 = global_10.member[(_e136 + 5u)];
                    let _e163 = global_10.member[(_e136 + 6u)];
                    let _e167 = global_10.member[(_e136 + 7u)];
                    let _e171 = global_10.member[(_e136 + 8u)];
                    let _e175 = global_10.member[(_e136 + 9u)];
                    let _e179 = global_10.member[(_e136 + 10u)];
                    let _e183 = global_10.member[(_e136 + 11u)];
                    let _e187 = global_10.member[(_e136 + 12u)];
                    let _e191 = global_10.member[(_e136 + 13u)];
                    let _e195 = global_10.member[(_e136 + 14u)];
                    let _e199 = global_10.member[(_e136 + 15u)];
                    let _e203 = global_10.member[(_e136 + 16u)];
                    let _e207 = global_10.member[(_e136 + 17u)];
                    let _e210 = global_3.member.member_4;
                    let _e214 = (_e65 - _e175);
                    let _e215 = (_e69 - _e179);
                    let _e216 = (_e73 - _e183);
                    let _e231 = (((_e163 * _e214) + (_e167 * _e215)) + (_e171 * _e216));
                    let _e233 = select(1f, _e231, (0.01f < _e231));
                    let _e234 = (1f / _e187);
                    let _e235 = (1f / _e191);
                    let _e238 = ((_e203 * _e234) * 0.15f);
                    let _e239 = ((_e207 * _e235) * 0.15f);
                    let _e244 = (((_e195 * _e234) * -1f) - _e238);
                    let _e245 = (((_e199 * _e235) * -1f) - _e239);
                    let _e250 = (((_e203 - _e195) * _e234) + _e238);
                    let _e251 = (((_e207 - _e199) * _e235) + _e239);
                    let _e252 = ((((_e139 * _e214) + (_e143 * _e215)) + (_e147 * _e216)) / _e233);
                    let _e254 = select(_e244, _e252, (_e252 > _e244));
                    let _e256 = select(_e250, _e254, (_e254 < _e250));
                    let _e257 = ((((_e151 * _e214) + (_e155 * _e215)) + (_e159 * _e216)) / _e233);
                    let _e259 = select(_e245, _e257, (_e257 > _e245));
                    let _e261 = select(_e251, _e259, (_e259 < _e251));
                    let _e262 = (_e187 / _e233);
                    let _e263 = (_e191 / _e233);
                    let _e270 = ((_e139 - (_e163 * _e256)) * _e262);
                    let _e271 = ((_e143 - (_e167 * _e256)) * _e262);
                    let _e272 = ((_e147 - (_e171 * _e256)) * _e262);
                    let _e279 = ((_e151 - (_e163 * _e261)) * _e263);
                    let _e280 = ((_e155 - (_e167 * _e261)) * _e263);
                    let _e281 = ((_e159 - (_e171 * _e261)) * _e263);
                    let _e290 = (1f / sqrt(((((_e77 * _e77) + (_e81 * _e81)) + (_e85 * _e85)) + (_e89 * _e89))));
                    let _e291 = (_e77 * _e290);
                    let _e292 = (_e81 * _e290);
                    let _e293 = (_e85 * _e290);
                    let _e294 = (_e89 * _e290);
                    let _e295 = (_e293 * _e293);
                    let _e296 = (_e294 * _e294);
                    let _e299 = (1f - (2f * (_e295 + _e296)));
                    let _e300 = (_e292 * _e293);
                    let _e301 = (_e291 * _e294);
                    let _e303 = (2f * (_e300 + _e301));
                    let _e304 = (_e292 * _e294);
                    let _e305 = (_e291 * _e293);
                    let _e307 = (2f * (_e304 - _e305));
                    let _e309 = (2f * (_e300 - _e301));
                    let _e310 = (_e292 * _e292);
                    let _e313 = (1f - (2f * (_e310 + _e296)));
                    let _e314 = (_e293 * _e294);
                    let _e315 = (_e291 * _e292);
                    let _e317 = (2f * (_e314 + _e315));
                    let _e319 = (2f * (_e304 + _e305));
                    let _e321 = (2f * (_e314 - _e315));
                    let _e324 = (1f - (2f * (_e310 + _e295)));
                    let _e325 = exp(_e92);
                    let _e326 = exp(_e95);
                    let _e327 = exp(_e98);
                    let _e343 = ((((_e270 * _e299) + (_e271 * _e303)) + (_e272 * _e307)) * _e325);
                    let _e344 = ((((_e270 * _e309) + (_e271 * _e313)) + (_e272 * _e317)) * _e326);
                    let _e345 = ((((_e270 * _e319) + (_e271 * _e321)) + (_e272 * _e324)) * _e327);
                    let _e361 = ((((_e279 * _e299) + (_e280 * _e303)) + (_e281 * _e307)) * _e325);
                    let _e362 = ((((_e279 * _e309) + (_e280 * _e313)) + (_e281 * _e317)) * _e326);
                    let _e363 = ((((_e279 * _e319) + (_e280 * _e321)) + (_e281 * _e324)) * _e327);
                    let _e368 = (((_e343 * _e343) + (_e344 * _e344)) + (_e345 * _e345));
                    let _e378 = (((_e361 * _e361) + (_e362 * _e362)) + (_e363 * _e363));
                    let _e381 = ((_e344 * _e363) - (_e345 * _e362));
                    let _e384 = ((_e345 * _e361) - (_e343 * _e363));
                    let _e387 = ((_e343 * _e362) - (_e344 * _e361));
                    let _e398 = (1f / (((((_e381 * _e381) + (_e384 * _e384)) + (_e387 * _e387)) + (_e210 * (_e368 + _e378))) + (_e210 * _e210)));
                    let _e414 = (((_e343 * _e210) + ((_e362 * _e387) - (_e363 * _e384))) * _e398);
                    let _e415 = (((_e344 * _e210) + ((_e363 * _e381) - (_e361 * _e387))) * _e398);
                    let _e416 = (((_e345 * _e210) + ((_e361 * _e384) - (_e362 * _e381))) * _e398);
                    let _e432 = (((_e361 * _e210) + ((_e384 * _e345) - (_e387 * _e344))) * _e398);
                    let _e433 = (((_e362 * _e210) + ((_e387 * _e343) - (_e381 * _e345))) * _e398);
                    let _e434 = (((_e363 * _e210) + ((_e381 * _e344) - (_e384 * _e343))) * _e398);
                    let _e435 = (0.5f * _e133.y);
                    let _e442 = ((_e414 * _e133.x) + (_e432 * _e435));
                    let _e443 = ((_e415 * _e133.x) + (_e433 * _e435));
                    let _e444 = ((_e416 * _e133.x) + (_e434 * _e435));
                    let _e451 = ((_e414 * _e435) + (_e432 * _e133.z));
                    let _e452 = ((_e415 * _e435) + (_e433 * _e133.z));
                    let _e453 = ((_e416 * _e435) + (_e434 * _e133.z));
                    let _e455 = ((_e378 + _e210) * _e398);
                    let _e457 = (-((((_e343 * _e361) + (_e344 * _e362)) + (_e345 * _e363))) * _e398);
                    let _e459 = ((_e368 + _e210) * _e398);
                    let _e469 = (((_e442 * _e455) + (_e451 * _e457)) * -2f);
                    let _e470 = (((_e443 * _e455) + (_e452 * _e457)) * -2f);
                    let _e471 = (((_e444 * _e455) + (_e453 * _e457)) * -2f);
                    let _e481 = (((_e442 * _e457) + (_e451 * _e459)) * -2f);
                    let _e482 = (((_e443 * _e457) + (_e452 * _e459)) * -2f);
                    let _e483 = (((_e444 * _e457) + (_e453 * _e459)) * -2f);
                    let _e493 = (_e469 * _e325);
                    let _e494 = (_e470 * _e326);
                    let _e495 = (_e471 * _e327);
                    let _e496 = (_e481 * _e325);
                    let _e497 = (_e482 * _e326);
                    let _e498 = (_e483 * _e327);
                    let _e505 = ((_e270 * _e493) + (_e279 * _e496));
                    let _e506 = ((_e271 * _e493) + (_e280 * _e496));
                    let _e507 = ((_e272 * _e493) + (_e281 * _e496));
                    let _e514 = ((_e270 * _e494) + (_e279 * _e497));
                    let _e515 = ((_e271 * _e494) + (_e280 * _e497));
                    let _e516 = ((_e272 * _e494) + (_e281 * _e497));
                    let _e523 = ((_e270 * _e495) + (_e279 * _e498));
                    let _e524 = ((_e271 * _e495) + (_e280 * _e498));
                    let _e525 = ((_e272 * _e495) + (_e281 * _e498));
                    let _e538 = (((_e299 * _e493) + (_e309 * _e494)) + (_e319 * _e495));
                    let _e539 = (((_e303 * _e493) + (_e313 * _e494)) + (_e321 * _e495));
                    let _e540 = (((_e307 * _e493) + (_e317 * _e494)) + (_e324 * _e495));
                    let _e553 = (((_e299 * _e496) + (_e309 * _e497)) + (_e319 * _e498));
                    let _e554 = (((_e303 * _e496) + (_e313 * _e497)) + (_e321 * _e498));
                    let _e555 = (((_e307 * _e496) + (_e317 * _e497)) + (_e324 * _e498));
                    let _e556 = (1f / _e233);
                    let _e557 = (_e187 * _e556);
                    let _e558 = (_e191 * _e556);
                    let _e579 = ((_e557 * _e129.x) + (select(0f, (-(_e557) * (((_e538 * _e163) + (_e539 * _e167)) + (_e540 * _e171))), (_e256 == _e252)) / _e233));
                    let _e582 = ((_e558 * _e129.y) + (select(0f, (-(_e558) * (((_e553 * _e163) + (_e554 * _e167)) + (_e555 * _e171))), (_e261 == _e257)) / _e233));
                    let _e599 = (-(((_e252 * _e579) + (_e257 * _e582))) - (((((_e538 * _e270) + (_e539 * _e271)) + (_e540 * _e272)) + (((_e553 * _e279) + (_e554 * _e280)) + (_e555 * _e281))) / _e233));
                    let _e615 = (_e516 - _e524);
                    let _e616 = (_e523 - _e507);
                    let _e617 = (_e506 - _e514);
                    let _e618 = (_e506 + _e514);
                    let _e619 = (_e507 + _e523);
                    let _e620 = (_e516 + _e524);
                    let _e653 = ((((_e292 * _e615) + (_e293 * _e616)) + (_e294 * _e617)) * 2f);
                    let _e654 = (((((_e291 * _e615) + (_e293 * _e618)) + (_e294 * _e619)) - ((2f * _e292) * (_e515 + _e525))) * 2f);
                    let _e655 = (((((_e291 * _e616) + (_e292 * _e618)) + (_e294 * _e620)) - ((2f * _e293) * (_e505 + _e525))) * 2f);
                    let _e656 = (((((_e291 * _e617) + (_e292 * _e619)) + (_e293 * _e620)) - ((2f * _e294) * (_e505 + _e515))) * 2f);
                    let _e663 = ((((_e653 * _e291) + (_e654 * _e292)) + (_e655 * _e293)) + (_e656 * _e294));
                    let _e676 = (3u * _e52);
                    let _e679 = ((3u * _e55) + (4u * _e52));
                    let _e681 = ((7u * _e55) + _e676);
                    let _e684 = global_3.member.member_5;
                    let _e690 = global_11.member[_e676];
                    let _e698 = global_11.member[(_e676 + 1u)];
                    let _e706 = global_11.member[(_e676 + 2u)];
                    let _e713 = global_11.member[_e679];
                    let _e721 = global_11.member[(_e679 + 1u)];
                    let _e729 = global_11.member[(_e679 + 2u)];
                    let _e737 = global_11.member[(_e679 + 3u)];
                    let _e744 = global_11.member[_e681];
                    let _e752 = global_11.member[(_e681 + 1u)];
                    let _e760 = global_11.member[(_e681 + 2u)];
                    let _e767 = global_11.member[((10u * _e55) + _e52)];
                    global_11.member[_e676] = (_e690 + bitcast<f32>((bitcast<u32>((((_e139 * _e579) + (_e151 * _e582)) + (_e163 * _e599))) & _e684)));
                    global_11.member[(_e676 + 1u)] = (_e698 + bitcast<f32>((bitcast<u32>((((_e143 * _e579) + (_e155 * _e582)) + (_e167 * _e599))) & _e684)));
                    global_11.member[(_e676 + 2u)] = (_e706 + bitcast<f32>((bitcast<u32>((((_e147 * _e579) + (_e159 * _e582)) + (_e171 * _e599))) & _e684)));
                    global_11.member[_e679] = (_e713 + bitcast<f32>((bitcast<u32>(((_e653 - (_e291 * _e663)) * _e290)) & _e684)));
                    global_11.member[(_e679 + 1u)] = (_e721 + bitcast<f32>((bitcast<u32>(((_e654 - (_e292 * _e663)) * _e290)) & _e684)));
                    global_11.member[(_e679 + 2u)] = (_e729 + bitcast<f32>((bitcast<u32>(((_e655 - (_e293 * _e663)) * _e290)) & _e684)));
                    global_11.member[(_e679 + 3u)] = (_e737 + bitcast<f32>((bitcast<u32>(((_e656 - (_e294 * _e663)) * _e290)) & _e684)));
                    global_11.member[_e681] = (_e744 + bitcast<f32>((bitcast<u32>(((_e469 * _e343) + (_e481 * _e361))) & _e684)));
                    global_11.member[(_e681 + 1u)] = (_e752 + bitcast<f32>((bitcast<u32>(((_e470 * _e344) + (_e482 * _e362))) & _e684)));
                    global_11.member[(_e681 + 2u)] = (_e760 + bitcast<f32>((bitcast<u32>(((_e471 * _e345) + (_e483 * _e363))) & _e684)));
                    global_11.member[((10u * _e55) + _e52)] = (_e767 + bitcast<f32>((bitcast<u32>(_e129.z) & _e684)));
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
