struct type_6 {
    member: array<vec4<f32>>,
}

struct type_9 {
    member: array<f32>,
}

struct type_16 {
    member: array<u32>,
}

struct type_20 {
    member: f32,
    member_1: f32,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: f32,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: type_20,
    member_1: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_3: type_16;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(3) 
var<storage> global_5: type_9;
@group(0) @binding(4) 
var<storage> global_6: type_9;
@group(0) @binding(0) 
var<uniform> global_7: type_22;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_6;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_16;

fn function_() {
    var phi_443_: f32;
    var phi_448_: type_20;
    var phi_477_: type_20;
    var phi_479_: type_20;
    var phi_480_: bool;
    var phi_484_: type_20;
    var phi_485_: type_20;
    var phi_496_: type_20;
    var phi_503_: type_20;
    var phi_505_: type_24;
    var phi_515_: f32;
    var phi_520_: type_20;
    var phi_549_: type_20;
    var phi_551_: type_20;
    var phi_552_: bool;
    var phi_556_: type_20;
    var phi_557_: type_20;
    var phi_568_: type_20;
    var phi_575_: type_20;
    var phi_577_: type_24;
    var phi_587_: f32;
    var phi_592_: type_20;
    var phi_621_: type_20;
    var phi_623_: type_20;
    var phi_624_: bool;
    var phi_628_: type_20;
    var phi_629_: type_20;
    var phi_640_: type_20;
    var phi_647_: type_20;
    var phi_649_: type_24;
    var phi_660_: type_20;
    var phi_668_: type_20;
    var phi_677_: type_20;
    var phi_685_: type_20;
    var phi_693_: type_20;
    var phi_717_: u32;
    var phi_721_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e48 = global_1;
            let _e49 = global_2;
            let _e57 = (((_e48.x + (_e48.y * _e49.x)) * 64u) + _e47.x);
            let _e60 = global_7.member.member;
            if (_e57 < _e60) {
                let _e64 = global_3.member[_e57];
                let _e67 = global_5.member[0u];
                let _e70 = global_5.member[1u];
                let _e73 = global_5.member[2u];
                let _e76 = global_5.member[3u];
                let _e79 = global_5.member[4u];
                let _e82 = global_5.member[5u];
                let _e85 = global_5.member[6u];
                let _e88 = global_5.member[7u];
                let _e91 = global_5.member[8u];
                let _e94 = global_5.member[9u];
                let _e97 = global_5.member[10u];
                let _e100 = global_5.member[11u];
                let _e103 = global_5.member[12u];
                let _e106 = global_5.member[13u];
                let _e109 = global_5.member[14u];
                let _e112 = global_5.member[15u];
                let _e115 = global_5.member[16u];
                let _e118 = global_5.member[17u];
                let _e121 = global_7.member.member_1;
                let _e122 = (_e121 == 0u);
                if _e122 {
                    break;
                }
                let _e124 = ((_e64 / _e121) * 18u);
                let _e128 = global_4.member[(_e124 + 9u)];
                let _e132 = global_4.member[(_e124 + 10u)];
                let _e136 = global_4.member[(_e124 + 11u)];
                let _e143 = (trunc((_e128 * _e76)) * _e67);
                let _e144 = (trunc((_e132 * _e79)) * _e70);
                let _e145 = (trunc((_e136 * _e82)) * _e73);
                let _e146 = (_e143 - _e85);
                let _e147 = (_e144 - _e88);
                let _e148 = (_e145 - _e91);
                let _e155 = (_e146 * _e103);
                let _e156 = (_e147 * _e106);
                let _e157 = (_e148 * _e109);
                let _e161 = (_e103 + _e112);
                let _e162 = (_e106 + _e115);
                let _e163 = (_e109 + _e118);
                let _e167 = ((_e146 * _e112) + (((_e128 - _e143) - _e94) * _e161));
                let _e168 = ((_e147 * _e115) + (((_e132 - _e144) - _e97) * _e162));
                let _e169 = ((_e148 * _e118) + (((_e136 - _e145) - _e100) * _e163));
                let _e173 = (trunc(((_e155 + _e167) * 4096f)) * 0.00024414063f);
                let _e179 = (trunc(((_e156 + _e168) * 4096f)) * 0.00024414063f);
                let _e185 = (trunc(((_e157 + _e169) * 4096f)) * 0.00024414063f);
                if _e122 {
                    break;
                }
                let _e189 = ((_e64 % _e121) * 3u);
                let _e192 = global_6.member[_e189];
                let _e196 = global_6.member[(_e189 + 1u)];
                let _e200 = global_6.member[(_e189 + 2u)];
                let _e207 = (trunc((_e192 * _e76)) * _e67);
                let _e208 = (trunc((_e196 * _e79)) * _e70);
                let _e209 = (trunc((_e200 * _e82)) * _e73);
                let _e210 = (_e207 - _e85);
                let _e211 = (_e208 - _e88);
                let _e212 = (_e209 - _e91);
                let _e219 = (_e210 * _e103);
                let _e220 = (_e211 * _e106);
                let _e221 = (_e212 * _e109);
                let _e228 = ((_e210 * _e112) + (((_e192 - _e207) - _e94) * _e161));
                let _e229 = ((_e211 * _e115) + (((_e196 - _e208) - _e97) * _e162));
                let _e230 = ((_e212 * _e118) + (((_e200 - _e209) - _e100) * _e163));
                let _e233 = trunc(((_e219 + _e228) * 4096f));
                let _e234 = (_e233 * 0.00024414063f);
                let _e236 = ((_e219 - _e234) + _e228);
                let _e239 = trunc(((_e220 + _e229) * 4096f));
                let _e240 = (_e239 * 0.00024414063f);
                let _e242 = ((_e220 - _e240) + _e229);
                let _e245 = trunc(((_e221 + _e230) * 4096f));
                let _e246 = (_e245 * 0.00024414063f);
                let _e248 = ((_e221 - _e246) + _e230);
                let _e249 = (_e173 - _e234);
                let _e250 = (((_e155 - _e173) + _e167) - _e236);
                let _e251 = (_e179 - _e240);
                let _e252 = (((_e156 - _e179) + _e168) - _e242);
                let _e253 = (_e185 - _e246);
                let _e254 = (((_e157 - _e185) + _e169) - _e248);
                let _e257 = global_7.member.member_2;
                let _e259 = (_e249 + _e250);
                if (_e259 < 0f) {
                    phi_443_ = -(_e259);
                } else {
                    phi_443_ = _e259;
                }
                let _e263 = phi_443_;
                let _e264 = (_e263 < 0.000000000000000000000000000000000000011754944f);
                if _e264 {
                    phi_448_ = type_20(1f, 0f);
                } else {
                    phi_448_ = type_20(_e249, _e250);
                }
                let _e266 = phi_448_;
                let _e267 = (_e233 * -0.00024414063f);
                let _e268 = -(_e236);
                let _e271 = (_e266.member + _e266.member_1);
                let _e273 = ((_e267 + _e268) / _e271);
                let _e275 = select(0f, _e273, (_e273 > 0f));
                let _e277 = select(1f, _e275, (_e275 < 1f));
                let _e280 = (trunc((_e277 * 1024f)) * 0.0009765625f);
                let _e290 = select(0f, (((_e267 - (_e280 * _e266.member)) + (_e268 - (_e280 * _e266.member_1))) / _e271), select(false, (_e277 < 1f), (0f < _e277)));
                let _e291 = (1f - _e234);
                let _e293 = ((_e291 + _e268) / _e271);
                let _e295 = select(0f, _e293, (_e293 > 0f));
                let _e297 = select(1f, _e295, (_e295 < 1f));
                let _e300 = (trunc((_e297 * 1024f)) * 0.0009765625f);
                let _e310 = select(0f, (((_e291 - (_e300 * _e266.member)) + (_e268 - (_e300 * _e266.member_1))) / _e271), select(false, (_e297 < 1f), (0f < _e297)));
                let _e311 = (_e234 + _e236);
                if (_e311 >= 0f) {
                    let _e313 = (_e311 <= 1f);
                    if _e313 {
                        phi_477_ = type_20(0f, 0f);
                    } else {
                        phi_477_ = type_20();
                    }
                    let _e315 = phi_477_;
                    phi_479_ = _e315;
                    phi_480_ = select(true, false, _e313);
                } else {
                    phi_479_ = type_20();
                    phi_480_ = true;
                }
                let _e318 = phi_479_;
                let _e320 = phi_480_;
                if _e320 {
                    phi_484_ = type_20(1f, 0f);
                    phi_485_ = type_20(0f, 0f);
                } else {
                    phi_484_ = _e318;
                    phi_485_ = type_20(1f, 0f);
                }
                let _e322 = phi_484_;
                let _e324 = phi_485_;
                if _e264 {
                    phi_505_ = type_24(_e322, _e324);
                } else {
                    let _e326 = (_e280 + _e290);
                    let _e327 = (_e300 + _e310);
                    if (_e326 < _e327) {
                        phi_496_ = type_20(_e280, _e290);
                    } else {
                        phi_496_ = type_20(_e300, _e310);
                    }
                    let _e332 = phi_496_;
                    if (_e326 > _e327) {
                        phi_503_ = type_20(_e280, _e290);
                    } else {
                        phi_503_ = type_20(_e300, _e310);
                    }
                    let _e337 = phi_503_;
                    phi_505_ = type_24(_e332, _e337);
                }
                let _e340 = phi_505_;
                let _e350 = (_e251 + _e252);
                if (_e350 < 0f) {
                    phi_515_ = -(_e350);
                } else {
                    phi_515_ = _e350;
                }
                let _e354 = phi_515_;
                let _e355 = (_e354 < 0.000000000000000000000000000000000000011754944f);
                if _e355 {
                    phi_520_ = type_20(1f, 0f);
                } else {
                    phi_520_ = type_20(_e251, _e252);
                }
                let _e357 = phi_520_;
                let _e358 = (_e239 * -0.00024414063f);
                let _e359 = -(_e242);
                let _e362 = (_e357.member + _e357.member_1);
                let _e364 = ((_e358 + _e359) / _e362);
                let _e366 = select(0f, _e364, (_e364 > 0f));
                let _e368 = select(1f, _e366, (_e366 < 1f));
                let _e371 = (trunc((_e368 * 1024f)) * 0.0009765625f);
                let _e381 = select(0f, (((_e358 - (_e371 * _e357.member)) + (_e359 - (_e371 * _e357.member_1))) / _e362), select(false, (_e368 < 1f), (0f < _e368)));
                let _e382 = (1f - _e240);
                let _e384 = ((_e382 + _e359) / _e362);
                let _e386 = select(0f, _e384, (_e384 > 0f));
                let _e388 = select(1f, _e386, (_e386 < 1f));
                let _e391 = (trunc((_e388 * 1024f)) * 0.0009765625f);
                let _e401 = select(0f, (((_e382 - (_e391 * _e357.member)) + (_e359 - (_e391 * _e357.member_1))) / _e362), select(false, (_e388 < 1f), (0f < _e388)));
                let _e402 = (_e240 + _e242);
                if (_e402 >= 0f) {
                    let _e404 = (_e402 <= 1f);
                    if _e404 {
                        phi_549_ = type_20(0f, 0f);
                    } else {
                        phi_549_ = type_20();
                    }
                    let _e406 = phi_549_;
                    phi_551_ = _e406;
                    phi_552_ = select(true, false, _e404);
                } else {
                    phi_551_ = type_20();
                    phi_552_ = true;
                }
                let _e409 = phi_551_;
                let _e411 = phi_552_;
                if _e411 {
                    phi_556_ = type_20(1f, 0f);
                    phi_557_ = type_20(0f, 0f);
                } else {
                    phi_556_ = _e409;
                    phi_557_ = type_20(1f, 0f);
                }
                let _e413 = phi_556_;
                let _e415 = phi_557_;
                if _e355 {
                    phi_577_ = type_24(_e413, _e415);
                } else {
                    let _e417 = (_e371 + _e381);
                    let _e418 = (_e391 + _e401);
                    if (_e417 < _e418) {
                        phi_568_ = type_20(_e371, _e381);
                    } else {
                        phi_568_ = type_20(_e391, _e401);
                    }
                    let _e423 = phi_568_;
                    if (_e417 > _e418) {
                        phi_575_ = type_20(_e371, _e381);
                    } else {
                        phi_575_ = type_20(_e391, _e401);
                    }
                    let _e428 = phi_575_;
                    phi_577_ = type_24(_e423, _e428);
                }
                let _e431 = phi_577_;
                let _e441 = (_e253 + _e254);
                if (_e441 < 0f) {
                    phi_587_ = -(_e441);
                } else {
                    phi_587_ = _e441;
                }
                let _e445 = phi_587_;
                let _e446 = (_e445 < 0.000000000000000000000000000000000000011754944f);
                if _e446 {
                    phi_592_ = type_20(1f, 0f);
                } else {
                    phi_592_ = type_20(_e253, _e254);
                }
                let _e448 = phi_592_;
                let _e449 = (_e245 * -0.00024414063f);
                let _e450 = -(_e248);
                let _e453 = (_e448.member + _e448.member_1);
                let _e455 = ((_e449 + _e450) / _e453);
                let _e457 = select(0f, _e455, (_e455 > 0f));
                let _e459 = select(1f, _e457, (_e457 < 1f));
                let _e462 = (trunc((_e459 * 1024f)) * 0.0009765625f);
                let _e472 = select(0f, (((_e449 - (_e462 * _e448.member)) + (_e450 - (_e462 * _e448.member_1))) / _e453), select(false, (_e459 < 1f), (0f < _e459)));
                let _e473 = (1f - _e246);
                let _e475 = ((_e473 + _e450) / _e453);
                let _e477 = select(0f, _e475, (_e475 > 0f));
                let _e479 = select(1f, _e477, (_e477 < 1f));
                let _e482 = (trunc((_e479 * 1024f)) * 0.0009765625f);
                let _e492 = select(0f, (((_e473 - (_e482 * _e448.member)) + (_e450 - (_e482 * _e448.member_1))) / _e453), select(false, (_e479 < 1f), (0f < _e479)));
                let _e493 = (_e246 + _e248);
                if (_e493 >= 0f) {
                    let _e495 = (_e493 <= 1f);
                    if _e495 {
                        phi_621_ = type_20(0f, 0f);
                    } else {
                        phi_621_ = type_20();
                    }
                    let _e497 = phi_621_;
                    phi_623_ = _e497;
                    phi_624_ = select(true, false, _e495);
                } else {
                    phi_623_ = type_20();
                    phi_624_ = true;
                }
                let _e500 = phi_623_;
                let _e502 = phi_624_;
                if _e502 {
                    phi_628_ = type_20(1f, 0f);
                    phi_629_ = type_20(0f, 0f);
                } else {
                    phi_628_ = _e500;
                    phi_629_ = type_20(1f, 0f);
                }
                let _e504 = phi_628_;
                let _e506 = phi_629_;
                if _e446 {
                    phi_649_ = type_24(_e504, _e506);
                } else {
                    let _e508 = (_e462 + _e472);
                    let _e509 = (_e482 + _e492);
                    if (_e508 < _e509) {
                        phi_640_ = type_20(_e462, _e472);
                    } else {
                        phi_640_ = type_20(_e482, _e492);
                    }
                    let _e514 = phi_640_;
                    if (_e508 > _e509) {
                        phi_647_ = type_20(_e462, _e472);
                    } else {
                        phi_647_ = type_20(_e482, _e492);
                    }
                    let _e519 = phi_647_;
                    phi_649_ = type_24(_e514, _e519);
                }
                let _e522 = phi_649_;
                if ((_e340.member.member + _e340.member.member_1) > (_e431.member.member + _e431.member.member_1)) {
                    phi_660_ = _e340.member;
                } else {
                    phi_660_ = _e431.member;
                }
                let _e537 = phi_660_;
                if ((_e537.member + _e537.member_1) > (_e522.member.member + _e522.member.member_1)) {
                    phi_668_ = _e537;
                } else {
                    phi_668_ = _e522.member;
                }
                let _e545 = phi_668_;
                if ((_e340.member_1.member + _e340.member_1.member_1) < (_e431.member_1.member + _e431.member_1.member_1)) {
                    phi_677_ = _e340.member_1;
                } else {
                    phi_677_ = _e431.member_1;
                }
                let _e554 = phi_677_;
                if ((_e554.member + _e554.member_1) < (_e522.member_1.member + _e522.member_1.member_1)) {
                    phi_685_ = _e554;
                } else {
                    phi_685_ = _e522.member_1;
                }
                let _e562 = phi_685_;
                let _e565 = (_e562.member - _e545.member);
                let _e566 = (_e562.member_1 - _e545.member_1);
                if ((_e565 + _e566) > 0f) {
                    phi_693_ = type_20(_e565, _e566);
                } else {
                    phi_693_ = type_20(0f, 0f);
                }
                let _e571 = phi_693_;
                let _e576 = ((_e571.member * _e250) + (_e571.member_1 * _e259));
                let _e577 = (_e571.member * _e249);
                let _e581 = (trunc(((_e577 + _e576) * 4096f)) * 0.00024414063f);
                let _e583 = ((_e577 - _e581) + _e576);
                let _e586 = ((_e571.member * _e252) + (_e571.member_1 * _e350));
                let _e587 = (_e571.member * _e251);
                let _e591 = (trunc(((_e587 + _e586) * 4096f)) * 0.00024414063f);
                let _e593 = ((_e587 - _e591) + _e586);
                let _e596 = ((_e571.member * _e254) + (_e571.member_1 * _e441));
                let _e597 = (_e571.member * _e253);
                let _e601 = (trunc(((_e597 + _e596) * 4096f)) * 0.00024414063f);
                let _e603 = ((_e597 - _e601) + _e596);
                let _e604 = (_e581 + _e583);
                let _e605 = (_e591 + _e593);
                let _e606 = (_e601 + _e603);
                let _e612 = sqrt((((_e604 * _e604) + (_e605 * _e605)) + (_e606 * _e606)));
                let _e613 = (_e612 > 0f);
                let _e615 = ceil((_e612 / _e257));
                let _e617 = select(1f, _e615, (_e615 > 1f));
                let _e619 = select(16384f, _e617, (_e617 < 16384f));
                let _e623 = (_e236 + ((_e545.member * _e250) + (_e545.member_1 * _e259)));
                let _e625 = (_e234 + (_e545.member * _e249));
                let _e629 = (trunc(((_e625 + _e623) * 4096f)) * 0.00024414063f);
                let _e635 = (_e242 + ((_e545.member * _e252) + (_e545.member_1 * _e350)));
                let _e637 = (_e240 + (_e545.member * _e251));
                let _e641 = (trunc(((_e637 + _e635) * 4096f)) * 0.00024414063f);
                let _e647 = (_e248 + ((_e545.member * _e254) + (_e545.member_1 * _e441)));
                let _e649 = (_e246 + (_e545.member * _e253));
                let _e653 = (trunc(((_e649 + _e647) * 4096f)) * 0.00024414063f);
                if _e613 {
                    phi_717_ = select(select(u32(_e619), 0u, (_e619 < 0f)), 4294967295u, (_e619 > 4294967000f));
                } else {
                    phi_717_ = 0u;
                }
                let _e662 = phi_717_;
                if _e613 {
                    phi_721_ = ((_e612 / _e619) / _e257);
                } else {
                    phi_721_ = 0f;
                }
                let _e666 = phi_721_;
                let _e667 = (_e57 * 4u);
                global_8.member[_e667] = vec4<f32>(_e629, _e641, _e653, _e666);
                global_8.member[(_e667 + 1u)] = vec4<f32>(_e581, _e591, _e601, 0f);
                global_8.member[(_e667 + 2u)] = vec4<f32>(((_e625 - _e629) + _e623), ((_e637 - _e641) + _e635), ((_e649 - _e653) + _e647), 0f);
                global_8.member[(_e667 + 3u)] = vec4<f32>(_e583, _e593, _e603, 0f);
                global_9.member[_e57] = _e662;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn segment(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
