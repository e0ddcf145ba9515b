struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_15 {
    member: type_14,
}

struct type_17 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_3: type_5;
@group(0) @binding(0) 
var<uniform> global_4: type_15;
@group(0) @binding(1) 
var<storage> global_5: type_19;
@group(0) @binding(3) 
var<storage> global_6: type_5;
@group(0) @binding(4) 
var<storage> global_7: type_5;
@group(0) @binding(5) 
var<storage, read_write> global_8: type_25;
@group(0) @binding(6) 
var<storage, read_write> global_9: type_25;
@group(0) @binding(7) 
var<storage, read_write> global_10: type_25;

fn function_() {
    var phi_220_: u32;
    var phi_223_: u32;
    var phi_225_: f32;
    var phi_227_: f32;
    var phi_221_: u32;
    var phi_224_: u32;
    var phi_226_: f32;
    var phi_228_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var phi_311_: f32;
    var phi_331_: f32;
    var phi_351_: f32;
    var phi_375_: u32;
    var phi_395_: u32;
    var phi_414_: u32;
    var phi_433_: u32;
    var phi_452_: u32;
    var phi_471_: u32;
    var phi_490_: u32;
    var phi_509_: u32;
    var phi_570_: u32;
    var phi_573_: u32;
    var phi_595_: f32;
    var phi_613_: u32;
    var phi_627_: u32;
    var phi_629_: array<u32, 2>;
    var phi_650_: f32;
    var phi_668_: u32;
    var phi_682_: u32;
    var phi_684_: array<u32, 2>;
    var phi_705_: f32;
    var phi_723_: u32;
    var phi_737_: u32;
    var phi_739_: array<u32, 2>;
    var phi_760_: f32;
    var phi_778_: u32;
    var phi_792_: u32;
    var phi_794_: array<u32, 2>;
    var phi_815_: f32;
    var phi_833_: u32;
    var phi_847_: u32;
    var phi_849_: array<u32, 2>;
    var phi_870_: f32;
    var phi_888_: u32;
    var phi_902_: u32;
    var phi_904_: array<u32, 2>;
    var phi_925_: f32;
    var phi_943_: u32;
    var phi_957_: u32;
    var phi_959_: array<u32, 2>;
    var phi_980_: f32;
    var phi_998_: u32;
    var phi_1012_: u32;
    var phi_1014_: array<u32, 2>;
    var phi_571_: u32;
    var phi_574_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global;
            let _e37 = global_1;
            let _e38 = global_2;
            let _e46 = (((_e37.x + (_e37.y * _e38.x)) * 64u) + _e36.x);
            let _e49 = global_4.member.member;
            if (_e46 < _e49) {
                let _e53 = global_4.member.member_3;
                let _e57 = global_4.member.member_2;
                let _e62 = global_4.member.member_7;
                let _e65 = global_4.member.member_5;
                let _e66 = (_e65 == 0u);
                if _e66 {
                    break;
                }
                let _e67 = (_e46 / _e65);
                let _e70 = global_4.member.member_1;
                if _e66 {
                    break;
                }
                let _e73 = (_e46 % _e65);
                let _e76 = (((_e67 * (_e62 * _e70)) + _e73) + ((_e57 + (_e37.z * _e53)) * _e70));
                let _e79 = global_7.member[2u];
                phi_220_ = 0u;
                phi_223_ = _e76;
                phi_225_ = 0f;
                phi_227_ = 0f;
                loop {
                    let _e81 = phi_220_;
                    let _e83 = phi_223_;
                    let _e85 = phi_225_;
                    let _e87 = phi_227_;
                    local = _e85;
                    local_1 = _e87;
                    local_2 = _e85;
                    let _e88 = (_e81 < _e53);
                    if _e88 {
                        let _e91 = global_6.member[_e83];
                        let _e92 = -(_e91);
                        let _e94 = select(_e92, _e91, (_e91 > _e92));
                        phi_221_ = (_e81 + 1u);
                        phi_224_ = (_e83 + _e70);
                        phi_226_ = select(1f, _e85, (_e94 <= _e79));
                        phi_228_ = select(_e94, _e87, (_e87 > _e94));
                    } else {
                        phi_221_ = u32();
                        phi_224_ = u32();
                        phi_226_ = f32();
                        phi_228_ = f32();
                    }
                    let _e102 = phi_221_;
                    let _e104 = phi_224_;
                    let _e106 = phi_226_;
                    let _e108 = phi_228_;
                    continue;
                    continuing {
                        phi_220_ = _e102;
                        phi_223_ = _e104;
                        phi_225_ = _e106;
                        phi_227_ = _e108;
                        break if !(_e88);
                    }
                }
                let _e111 = local;
                if (0f < _e111) {
                    let _e115 = atomicMax((&global_10.member[0u]), 1u);
                }
                let _e117 = local_1;
                let _e120 = local_2;
                let _e122 = select(false, (_e120 < 1f), (0.000000000000000000000000000000000000011754944f <= _e117));
                if _e122 {
                    let _e125 = global_5.member[_e37.z];
                    let _e128 = global_4.member.member_6;
                    if _e66 {
                        break;
                    }
                    if _e66 {
                        break;
                    }
                    let _e131 = ((_e67 * (_e128 * _e70)) + _e73);
                    let _e134 = global_3.member[_e131];
                    let _e135 = (3u * _e70);
                    let _e139 = global_3.member[(_e131 + _e135)];
                    let _e140 = (_e70 + _e131);
                    let _e143 = global_3.member[_e140];
                    let _e147 = global_3.member[(_e140 + _e135)];
                    let _e149 = ((2u * _e70) + _e131);
                    let _e152 = global_3.member[_e149];
                    let _e156 = global_3.member[(_e149 + _e135)];
                    let _e159 = global_4.member.member_4;
                    let _e160 = (_e159 != 0u);
                    let _e161 = (_e134 + _e139);
                    let _e164 = select(false, (_e161 < 1f), (0f < _e161));
                    let _e167 = select(select(0f, 1f, (1f <= _e161)), _e134, _e164);
                    let _e170 = (_e167 * _e125.member);
                    let _e173 = (_e125.member + _e125.member_1);
                    let _e177 = trunc(_e170);
                    let _e179 = ((_e170 - _e177) + (((_e167 * _e125.member_1) + (select(0f, _e139, _e164) * _e173)) + 0.5f));
                    let _e181 = select(0f, _e179, (_e179 > 0f));
                    let _e182 = trunc(_e181);
                    let _e183 = (_e181 - _e182);
                    let _e184 = (_e177 + _e182);
                    let _e189 = select(select(u32(_e184), 0u, (_e184 < 0f)), 4294967295u, (_e184 > 4294967000f));
                    if _e160 {
                        phi_311_ = ((_e183 * _e183) * (3f - (2f * _e183)));
                    } else {
                        phi_311_ = _e183;
                    }
                    let _e195 = phi_311_;
                    let _e196 = (_e143 + _e147);
                    let _e199 = select(false, (_e196 < 1f), (0f < _e196));
                    let _e202 = select(select(0f, 1f, (1f <= _e196)), _e143, _e199);
                    let _e204 = (_e202 * _e125.member);
                    let _e209 = trunc(_e204);
                    let _e211 = ((_e204 - _e209) + (((_e202 * _e125.member_1) + (select(0f, _e147, _e199) * _e173)) + 0.5f));
                    let _e213 = select(0f, _e211, (_e211 > 0f));
                    let _e214 = trunc(_e213);
                    let _e215 = (_e213 - _e214);
                    let _e216 = (_e209 + _e214);
                    let _e221 = select(select(u32(_e216), 0u, (_e216 < 0f)), 4294967295u, (_e216 > 4294967000f));
                    if _e160 {
                        phi_331_ = ((_e215 * _e215) * (3f - (2f * _e215)));
                    } else {
                        phi_331_ = _e215;
                    }
                    let _e227 = phi_331_;
                    let _e228 = (_e152 + _e156);
                    let _e231 = select(false, (_e228 < 1f), (0f < _e228));
                    let _e234 = select(select(0f, 1f, (1f <= _e228)), _e152, _e231);
                    let _e236 = (_e234 * _e125.member);
                    let _e241 = trunc(_e236);
                    let _e243 = ((_e236 - _e241) + (((_e234 * _e125.member_1) + (select(0f, _e156, _e231) * _e173)) + 0.5f));
                    let _e245 = select(0f, _e243, (_e243 > 0f));
                    let _e246 = trunc(_e245);
                    let _e247 = (_e245 - _e246);
                    let _e248 = (_e241 + _e246);
                    let _e253 = select(select(u32(_e248), 0u, (_e248 < 0f)), 4294967295u, (_e248 > 4294967000f));
                    if _e160 {
                        phi_351_ = ((_e247 * _e247) * (3f - (2f * _e247)));
                    } else {
                        phi_351_ = _e247;
                    }
                    let _e259 = phi_351_;
                    let _e260 = (_e189 + 1u);
                    let _e261 = (_e221 + 1u);
                    let _e262 = (_e253 + 1u);
                    let _e265 = (_e125.member_5 == 0u);
                    if _e265 {
                        let _e276 = (_e189 + ((_e221 + (_e253 * _e125.member_2)) * _e125.member_2));
                        phi_375_ = select((_e276 - _e125.member_4), _e276, (_e276 < _e125.member_4));
                    } else {
                        phi_375_ = (((_e189 ^ (_e221 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e281 = phi_375_;
                    if _e265 {
                        let _e294 = (_e260 + ((_e221 + (_e253 * _e125.member_2)) * _e125.member_2));
                        phi_395_ = select((_e294 - _e125.member_4), _e294, (_e294 < _e125.member_4));
                    } else {
                        phi_395_ = (((_e260 ^ (_e221 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e299 = phi_395_;
                    if _e265 {
                        let _e311 = (_e189 + ((_e261 + (_e253 * _e125.member_2)) * _e125.member_2));
                        phi_414_ = select((_e311 - _e125.member_4), _e311, (_e311 < _e125.member_4));
                    } else {
                        phi_414_ = (((_e189 ^ (_e261 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e316 = phi_414_;
                    if _e265 {
                        let _e328 = (_e260 + ((_e261 + (_e253 * _e125.member_2)) * _e125.member_2));
                        phi_433_ = select((_e328 - _e125.member_4), _e328, (_e328 < _e125.member_4));
                    } else {
                        phi_433_ = (((_e260 ^ (_e261 * 2654435761u)) ^ (_e253 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e333 = phi_433_;
                    if _e265 {
                        let _e345 = (_e189 + ((_e221 + (_e262 * _e125.member_2)) * _e125.member_2));
                        phi_452_ = select((_e345 - _e125.member_4), _e345, (_e345 < _e125.member_4));
                    } else {
                        phi_452_ = (((_e189 ^ (_e221 * 2654435761u)) ^ (_e262 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e350 = phi_452_;
                    if _e265 {
                        let _e362 = (_e260 + ((_e221 + (_e262 * _e125.member_2)) * _e125.member_2));
                        phi_471_ = select((_e362 - _e125.member_4), _e362, (_e362 < _e125.member_4));
                    } else {
                        phi_471_ = (((_e260 ^ (_e221 * 2654435761u)) ^ (_e262 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e367 = phi_471_;
                    if _e265 {
                        let _e379 = (_e189 + ((_e261 + (_e262 * _e125.member_2)) * _e125.member_2));
                        phi_490_ = select((_e379 - _e125.member_4), _e379, (_e379 < _e125.member_4));
                    } else {
                        phi_490_ = (((_e189 ^ (_e261 * 2654435761u)) ^ (_e262 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e384 = phi_490_;
                    if _e265 {
                        let _e396 = (_e260 + ((_e261 + (_e262 * _e125.member_2)) * _e125.member_2));
                        phi_509_ = select((_e396 - _e125.member_4), _e396, (_e396 < _e125.member_4));
                    } else {
                        phi_509_ = (((_e260 ^ (_e261 * 2654435761u)) ^ (_e262 * 805459861u)) & (_e125.member_4 - 1u));
                    }
                    let _e401 = phi_509_;
                    let _e403 = (1f - _e195);
                    let _e404 = (1f - _e227);
                    let _e405 = (1f - _e259);
                    let _e406 = (_e403 * _e404);
                    let _e407 = (_e195 * _e404);
                    let _e408 = (_e403 * _e227);
                    let _e409 = (_e195 * _e227);
                    let _e418 = ((_e281 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e422 = atomicMax((&global_9.member[(_e418 / 64u)]), 1u);
                    }
                    let _e423 = ((_e299 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e427 = atomicMax((&global_9.member[(_e423 / 64u)]), 1u);
                    }
                    let _e428 = ((_e316 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e432 = atomicMax((&global_9.member[(_e428 / 64u)]), 1u);
                    }
                    let _e433 = ((_e333 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e437 = atomicMax((&global_9.member[(_e433 / 64u)]), 1u);
                    }
                    let _e438 = ((_e350 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e442 = atomicMax((&global_9.member[(_e438 / 64u)]), 1u);
                    }
                    let _e443 = ((_e367 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e447 = atomicMax((&global_9.member[(_e443 / 64u)]), 1u);
                    }
                    let _e448 = ((_e384 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e452 = atomicMax((&global_9.member[(_e448 / 64u)]), 1u);
                    }
                    let _e453 = ((_e401 + _e125.member_3) * _e53);
                    if _e122 {
                        let _e457 = atomicMax((&global_9.member[(_e453 / 64u)]), 1u);
                    }
                    let _e460 = global_7.member[0u];
                    phi_570_ = 0u;
                    phi_573_ = _e76;
                    loop {
                        let _e462 = phi_570_;
                        let _e464 = phi_573_;
                        let _e465 = (_e462 < _e53);
                        if _e465 {
                            let _e468 = global_6.member[_e464];
                            let _e469 = -(_e468);
                            let _e474 = select(0f, (_e468 * _e460), (0.000000000000000000000000000000000000011754944f <= select(_e469, _e468, (_e468 > _e469))));
                            let _e475 = (_e474 * (_e406 * _e405));
                            if _e122 {
                                let _e477 = (_e475 < 0f);
                                if _e477 {
                                    phi_595_ = -(_e475);
                                } else {
                                    phi_595_ = _e475;
                                }
                                let _e480 = phi_595_;
                                let _e481 = (_e480 * 0.00000000023283064f);
                                let _e486 = select(select(u32(_e481), 0u, (_e481 < 0f)), 4294967295u, (_e481 > 4294967000f));
                                let _e489 = (_e480 - (f32(_e486) * 4294967300f));
                                let _e494 = select(select(u32(_e489), 0u, (_e489 < 0f)), 4294967295u, (_e489 > 4294967000f));
                                if ((_e489 - f32(_e494)) >= 0.5f) {
                                    phi_613_ = (_e494 + 1u);
                                } else {
                                    phi_613_ = _e494;
                                }
                                let _e500 = phi_613_;
                                if _e477 {
                                    let _e503 = (~(_e500) + 1u);
                                    if (_e503 == 0u) {
                                        phi_627_ = (~(_e486) + 1u);
                                    } else {
                                        phi_627_ = ~(_e486);
                                    }
                                    let _e509 = phi_627_;
                                    phi_629_ = array<u32, 2>(_e503, _e509);
                                } else {
                                    phi_629_ = array<u32, 2>(_e500, _e486);
                                }
                                let _e512 = phi_629_;
                                let _e515 = (2u * (_e418 + _e462));
                                let _e518 = atomicAdd((&global_8.member[_e515]), _e512[0]);
                                let _e526 = atomicAdd((&global_8.member[(_e515 + 1u)]), (_e512[1] + select(0u, 1u, ((_e518 + _e512[0]) < _e512[0]))));
                            }
                            let _e527 = (_e474 * (_e407 * _e405));
                            if _e122 {
                                let _e529 = (_e527 < 0f);
                                if _e529 {
                                    phi_650_ = -(_e527);
                                } else {
                                    phi_650_ = _e527;
                                }
                                let _e532 = phi_650_;
                                let _e533 = (_e532 * 0.00000000023283064f);
                                let _e538 = select(select(u32(_e533), 0u, (_e533 < 0f)), 4294967295u, (_e533 > 4294967000f));
                                let _e541 = (_e532 - (f32(_e538) * 4294967300f));
                                let _e546 = select(select(u32(_e541), 0u, (_e541 < 0f)), 4294967295u, (_e541 > 4294967000f));
                                if ((_e541 - f32(_e546)) >= 0.5f) {
                                    phi_668_ = (_e546 + 1u);
                                } else {
                                    phi_668_ = _e546;
                                }
                                let _e552 = phi_668_;
                                if _e529 {
                                    let _e555 = (~(_e552) + 1u);
                                    if (_e555 == 0u) {
                                        phi_682_ = (~(_e538) + 1u);
                                    } else {
                                        phi_682_ = ~(_e538);
                                    }
                                    let _e561 = phi_682_;
                                    phi_684_ = array<u32, 2>(_e555, _e561);
                                } else {
                                    phi_684_ = array<u32, 2>(_e552, _e538);
                                }
                                let _e564 = phi_684_;
                                let _e567 = (2u * (_e423 + _e462));
                                let _e570 = atomicAdd((&global_8.member[_e567]), _e564[0]);
                                let _e578 = atomicAdd((&global_8.member[(_e567 + 1u)]), (_e564[1] + select(0u, 1u, ((_e570 + _e564[0]) < _e564[0]))));
                            }
                            let _e579 = (_e474 * (_e408 * _e405));
                            if _e122 {
                                let _e581 = (_e579 < 0f);
                                if _e581 {
                                    phi_705_ = -(_e579);
                                } else {
                                    phi_705_ = _e579;
                                }
                                let _e584 = phi_705_;
                                let _e585 = (_e584 * 0.00000000023283064f);
                                let _e590 = select(select(u32(_e585), 0u, (_e585 < 0f)), 4294967295u, (_e585 > 4294967000f));
                                let _e593 = (_e584 - (f32(_e590) * 4294967300f));
                                let _e598 = select(select(u32(_e593), 0u, (_e593 < 0f)), 4294967295u, (_e593 > 4294967000f));
                                if ((_e593 - f32(_e598)) >= 0.5f) {
                                    phi_723_ = (_e598 + 1u);
                                } else {
                                    phi_723_ = _e598;
                                }
                                let _e604 = phi_723_;
                                if _e581 {
                                    let _e607 = (~(_e604) + 1u);
                                    if (_e607 == 0u) {
                                        phi_737_ = (~(_e590) + 1u);
                                    } else {
                                        phi_737_ = ~(_e590);
                                    }
                                    let _e613 = phi_737_;
                                    phi_739_ = array<u32, 2>(_e607, _e613);
                                } else {
                                    phi_739_ = array<u32, 2>(_e604, _e590);
                                }
                                let _e616 = phi_739_;
                                let _e619 = (2u * (_e428 + _e462));
                                let _e622 = atomicAdd((&global_8.member[_e619]), _e616[0]);
                                let _e630 = atomicAdd((&global_8.member[(_e619 + 1u)]), (_e616[1] + select(0u, 1u, ((_e622 + _e616[0]) < _e616[0]))));
                            }
                            let _e631 = (_e474 * (_e409 * _e405));
                            if _e122 {
                                let _e633 = (_e631 < 0f);
                                if _e633 {
                                    phi_760_ = -(_e631);
                                } else {
                                    phi_760_ = _e631;
                                }
                                let _e636 = phi_760_;
                                let _e637 = (_e636 * 0.00000000023283064f);
                                let _e642 = select(select(u32(_e637), 0u, (_e637 < 0f)), 4294967295u, (_e637 > 4294967000f));
                                let _e645 = (_e636 - (f32(_e642) * 4294967300f));
                                let _e650 = select(select(u32(_e645), 0u, (_e645 < 0f)), 4294967295u, (_e645 > 4294967000f));
                                if ((_e645 - f32(_e650)) >= 0.5f) {
                                    phi_778_ = (_e650 + 1u);
                                } else {
                                    phi_778_ = _e650;
                                }
                                let _e656 = phi_778_;
                                if _e633 {
                                    let _e659 = (~(_e656) + 1u);
                                    if (_e659 == 0u) {
                                        phi_792_ = (~(_e642) + 1u);
                                    } else {
                                        phi_792_ = ~(_e642);
                                    }
                                    let _e665 = phi_792_;
                                    phi_794_ = array<u32, 2>(_e659, _e665);
                                } else {
                                    phi_794_ = array<u32, 2>(_e656, _e642);
                                }
                                let _e668 = phi_794_;
                                let _e671 = (2u * (_e433 + _e462));
                                let _e674 = atomicAdd((&global_8.member[_e671]), _e668[0]);
                                let _e682 = atomicAdd((&global_8.member[(_e671 + 1u)]), (_e668[1] + select(0u, 1u, ((_e674 + _e668[0]) < _e668[0]))));
                            }
                            let _e683 = (_e474 * (_e406 * _e259));
                            if _e122 {
                                let _e685 = (_e683 < 0f);
                                if _e685 {
                                    phi_815_ = -(_e683);
                                } else {
                                    phi_815_ = _e683;
                                }
                                let _e688 = phi_815_;
                                let _e689 = (_e688 * 0.00000000023283064f);
                                let _e694 = select(select(u32(_e689), 0u, (_e689 < 0f)), 4294967295u, (_e689 > 4294967000f));
                                let _e697 = (_e688 - (f32(_e694) * 4294967300f));
                                let _e702 = select(select(u32(_e697), 0u, (_e697 < 0f)), 4294967295u, (_e697 > 4294967000f));
                                if ((_e697 - f32(_e702)) >= 0.5f) {
                                    phi_833_ = (_e702 + 1u);
                                } else {
                                    phi_833_ = _e702;
                                }
                                let _e708 = phi_833_;
                                if _e685 {
                                    let _e711 = (~(_e708) + 1u);
                                    if (_e711 == 0u) {
                                        phi_847_ = (~(_e694) + 1u);
                                    } else {
                                        phi_847_ = ~(_e694);
                                    }
                                    let _e717 = phi_847_;
                                    phi_849_ = array<u32, 2>(_e711, _e717);
                                } else {
                                    phi_849_ = array<u32, 2>(_e708, _e694);
                                }
                                let _e720 = phi_849_;
                                let _e723 = (2u * (_e438 + _e462));
                                let _e726 = atomicAdd((&global_8.member[_e723]), _e720[0]);
                                let _e734 = atomicAdd((&global_8.member[(_e723 + 1u)]), (_e720[1] + select(0u, 1u, ((_e726 + _e720[0]) < _e720[0]))));
                            }
                            let _e735 = (_e474 * (_e407 * _e259));
                            if _e122 {
                                let _e737 = (_e735 < 0f);
                                if _e737 {
                                    phi_870_ = -(_e735);
                                } else {
                                    phi_870_ = _e735;
                                }
                                let _e740 = phi_870_;
                                let _e741 = (_e740 * 0.00000000023283064f);
                                let _e746 = select(select(u32(_e741), 0u, (_e741 < 0f)), 4294967295u, (_e741 > 4294967000f));
                                let _e749 = (_e740 - (f32(_e746) * 4294967300f));
                                let _e754 = select(select(u32(_e749), 0u, (_e749 < 0f)), 4294967295u, (_e749 > 4294967000f));
                                if ((_e749 - f32(_e754)) >= 0.5f) {
                                    phi_888_ = (_e754 + 1u);
                                } else {
                                    phi_888_ = _e754;
                                }
                                let _e760 = phi_888_;
                                if _e737 {
                                    let _e763 = (~(_e760) + 1u);
                                    if (_e763 == 0u) {
                                        phi_902_ = (~(_e746) + 1u);
                                    } else {
                                        phi_902_ = ~(_e746);
                                    }
                                    let _e769 = phi_902_;
                                    phi_904_ = array<u32, 2>(_e763, _e769);
                                } else {
                                    phi_904_ = array<u32, 2>(_e760, _e746);
                                }
                                let _e772 = phi_904_;
                                let _e775 = (2u * (_e443 + _e462));
                                let _e778 = atomicAdd((&global_8.member[_e775]), _e772[0]);
                                let _e786 = atomicAdd((&global_8.member[(_e775 + 1u)]), (_e772[1] + select(0u, 1u, ((_e778 + _e772[0]) < _e772[0]))));
                            }
                            let _e787 = (_e474 * (_e408 * _e259));
                            if _e122 {
                                let _e789 = (_e787 < 0f);
                                if _e789 {
                                    phi_925_ = -(_e787);
                                } else {
                                    phi_925_ = _e787;
                                }
                                let _e792 = phi_925_;
                                let _e793 = (_e792 * 0.00000000023283064f);
                                let _e798 = select(select(u32(_e793), 0u, (_e793 < 0f)), 4294967295u, (_e793 > 4294967000f));
                                let _e801 = (_e792 - (f32(_e798) * 4294967300f));
                                let _e806 = select(select(u32(_e801), 0u, (_e801 < 0f)), 4294967295u, (_e801 > 4294967000f));
                                if ((_e801 - f32(_e806)) >= 0.5f) {
                                    phi_943_ = (_e806 + 1u);
                                } else {
                                    phi_943_ = _e806;
                                }
                                let _e812 = phi_943_;
                                if _e789 {
                                    let _e815 = (~(_e812) + 1u);
                                    if (_e815 == 0u) {
                                        phi_957_ = (~(_e798) + 1u);
                                    } else {
                                        phi_957_ = ~(_e798);
                                    }
                                    let _e821 = phi_957_;
                                    phi_959_ = array<u32, 2>(_e815, _e821);
                                } else {
                                    phi_959_ = array<u32, 2>(_e812, _e798);
                                }
                                let _e824 = phi_959_;
                                let _e827 = (2u * (_e448 + _e462));
                                let _e830 = atomicAdd((&global_8.member[_e827]), _e824[0]);
                                let _e838 = atomicAdd((&global_8.member[(_e827 + 1u)]), (_e824[1] + select(0u, 1u, ((_e830 + _e824[0]) < _e824[0]))));
                            }
                            let _e839 = (_e474 * (_e409 * _e259));
                            if _e122 {
                                let _e841 = (_e839 < 0f);
                                if _e841 {
                                    phi_980_ = -(_e839);
                                } else {
                                    phi_980_ = _e839;
                                }
                                let _e844 = phi_980_;
                                let _e845 = (_e844 * 0.00000000023283064f);
                                let _e850 = select(select(u32(_e845), 0u, (_e845 < 0f)), 4294967295u, (_e845 > 4294967000f));
                                let _e853 = (_e844 - (f32(_e850) * 4294967300f));
                                let _e858 = select(select(u32(_e853), 0u, (_e853 < 0f)), 4294967295u, (_e853 > 4294967000f));
                                if ((_e853 - f32(_e858)) >= 0.5f) {
                                    phi_998_ = (_e858 + 1u);
                                } else {
                                    phi_998_ = _e858;
                                }
                                let _e864 = phi_998_;
                                if _e841 {
                                    let _e867 = (~(_e864) + 1u);
                                    if (_e867 == 0u) {
                                        phi_1012_ = (~(_e850) + 1u);
                                    } else {
                                        phi_1012_ = ~(_e850);
                                    }
                                    let _e873 = phi_1012_;
                                    phi_1014_ = array<u32, 2>(_e867, _e873);
                                } else {
                                    phi_1014_ = array<u32, 2>(_e864, _e850);
                                }
                                let _e876 = phi_1014_;
                                let _e879 = (2u * (_e453 + _e462));
                                let _e882 = atomicAdd((&global_8.member[_e879]), _e876[0]);
                                let _e890 = atomicAdd((&global_8.member[(_e879 + 1u)]), (_e876[1] + select(0u, 1u, ((_e882 + _e876[0]) < _e876[0]))));
                            }
                            phi_571_ = (_e462 + 1u);
                            phi_574_ = (_e464 + _e70);
                        } else {
                            phi_571_ = u32();
                            phi_574_ = u32();
                        }
                        let _e894 = phi_571_;
                        let _e896 = phi_574_;
                        continue;
                        continuing {
                            phi_570_ = _e894;
                            phi_573_ = _e896;
                            break if !(_e465);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn hash_grid_backward(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>, @builtin(num_workgroups) param_2: vec3<u32>) {
    global = param;
    global_1 = param_1;
    global_2 = param_2;
    function_();
}
