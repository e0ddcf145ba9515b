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
    var phi_559_: vec3<f32>;
    var phi_562_: vec3<f32>;
    var phi_564_: u32;
    var phi_566_: u32;
    var local: vec3<f32>;
    var phi_678_: u32;
    var phi_680_: array<u32, 2>;
    var phi_686_: array<u32, 2>;
    var local_1: vec3<f32>;
    var phi_735_: u32;
    var phi_737_: array<u32, 2>;
    var phi_743_: array<u32, 2>;
    var local_2: vec3<f32>;
    var phi_792_: u32;
    var phi_794_: array<u32, 2>;
    var phi_800_: array<u32, 2>;
    var local_3: vec3<f32>;
    var phi_849_: u32;
    var phi_851_: array<u32, 2>;
    var phi_857_: array<u32, 2>;
    var local_4: vec3<f32>;
    var phi_906_: u32;
    var phi_908_: array<u32, 2>;
    var phi_914_: array<u32, 2>;
    var local_5: vec3<f32>;
    var phi_963_: u32;
    var phi_965_: array<u32, 2>;
    var phi_971_: array<u32, 2>;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: u32;
    var local_9: u32;

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
        phi_559_ = vec3<f32>(0f, 0f, 0f);
        phi_562_ = vec3<f32>(0f, 0f, 0f);
        phi_564_ = (3u * _e155);
        phi_566_ = _e155;
        loop {
            let _e161 = phi_559_;
            let _e163 = phi_562_;
            let _e165 = phi_564_;
            let _e167 = phi_566_;
            local = _e163;
            local_1 = _e163;
            local_2 = _e163;
            local_3 = _e161;
            local_4 = _e161;
            local_5 = _e161;
            if (_e167 < select(_e149, _e156, (_e156 < _e149))) {
                let _e171 = global_9.member[_e167];
                let _e174 = global_3.member.member;
                let _e176 = (_e171 - (_e69 * _e174));
                let _e177 = (3u * _e176);
                let _e180 = global_5.member[_e177];
                let _e181 = (_e177 + 1u);
                let _e184 = global_5.member[_e181];
                let _e185 = (_e177 + 2u);
                let _e188 = global_5.member[_e185];
                let _e189 = (_e176 * 4u);
                let _e192 = global_6.member[_e189];
                let _e196 = global_6.member[(_e189 + 1u)];
                let _e200 = global_6.member[(_e189 + 2u)];
                let _e204 = global_6.member[(_e189 + 3u)];
                let _e207 = global_7.member[_e177];
                let _e210 = global_7.member[_e181];
                let _e213 = global_7.member[_e185];
                let _e214 = (_e180 - _e109);
                let _e215 = (_e184 - _e113);
                let _e216 = (_e188 - _e117);
                let _e221 = (((_e73 * _e214) + (_e77 * _e215)) + (_e81 * _e216));
                let _e226 = (((_e85 * _e214) + (_e89 * _e215)) + (_e93 * _e216));
                let _e231 = (((_e97 * _e214) + (_e101 * _e215)) + (_e105 * _e216));
                let _e233 = select(1f, _e231, (0.01f < _e231));
                let _e234 = (1f / _e121);
                let _e235 = (1f / _e125);
                let _e238 = ((_e137 * _e234) * 0.15f);
                let _e239 = ((_e141 * _e235) * 0.15f);
                let _e244 = (((_e129 * _e234) * -1f) - _e238);
                let _e245 = (((_e133 * _e235) * -1f) - _e239);
                let _e250 = (((_e137 - _e129) * _e234) + _e238);
                let _e251 = (((_e141 - _e133) * _e235) + _e239);
                let _e252 = (_e221 / _e233);
                let _e254 = select(_e244, _e252, (_e252 > _e244));
                let _e256 = select(_e250, _e254, (_e254 < _e250));
                let _e257 = (_e226 / _e233);
                let _e259 = select(_e245, _e257, (_e257 > _e245));
                let _e261 = select(_e251, _e259, (_e259 < _e251));
                let _e262 = (_e121 / _e233);
                let _e263 = (_e125 / _e233);
                let _e270 = ((_e73 - (_e97 * _e256)) * _e262);
                let _e271 = ((_e77 - (_e101 * _e256)) * _e262);
                let _e272 = ((_e81 - (_e105 * _e256)) * _e262);
                let _e279 = ((_e85 - (_e97 * _e261)) * _e263);
                let _e280 = ((_e89 - (_e101 * _e261)) * _e263);
                let _e281 = ((_e93 - (_e105 * _e261)) * _e263);
                let _e290 = (1f / sqrt(((((_e192 * _e192) + (_e196 * _e196)) + (_e200 * _e200)) + (_e204 * _e204))));
                let _e291 = (_e192 * _e290);
                let _e292 = (_e196 * _e290);
                let _e293 = (_e200 * _e290);
                let _e294 = (_e204 * _e290);
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
                let _e325 = exp(_e207);
                let _e326 = exp(_e210);
                let _e327 = exp(_e213);
                let _e343 = ((((_e270 * _e299) + (_e271 * _e303)) + (_e272 * _e307)) * _e325);
                let _e344 = ((((_e270 * _e309) + (_e271 * _e313)) + (_e272 * _e317)) * _e326);
                let _e345 = ((((_e270 * _e319) + (_e271 * _e321)) + (_e272 * _e324)) * _e327);
                let _e361 = ((((_e279 * _e299) + (_e280 * _e303)) + (_e281 * _e307)) * _e325);
                let _e362 = ((((_e279 * _e309) + (_e280 * _e313)) + (_e281 * _e317)) * _e326);
                let _e363 = ((((_e279 * _e319) + (_e280 * _e321)) + (_e281 * _e324)) * _e327);
                let _e366 = global_10.member[_e165];
                let _e370 = global_10.member[(_e165 + 1u)];
                let _e378 = global_3.member.member_6;
                let _e383 = (((_e343 * _e343) + (_e344 * _e344)) + (_e345 * _e345));
                let _e393 = (((_e361 * _e361) + (_e362 * _e362)) + (_e363 * _e363));
                let _e396 = ((_e344 * _e363) - (_e345 * _e362));
                let _e399 = ((_e345 * _e361) - (_e343 * _e363));
                let _e402 = ((_e343 * _e362) - (_e344 * _e361));
                let _e413 = (1f / (((((_e396 * _e396) + (_e399 * _e399)) + (_e402 * _e402)) + (_e378 * (_e383 + _e393))) + (_e378 * _e378)));
                let _e429 = (((_e343 * _e378) + ((_e362 * _e402) - (_e363 * _e399))) * _e413);
                let _e430 = (((_e344 * _e378) + ((_e363 * _e396) - (_e361 * _e402))) * _e413);
                let _e431 = (((_e345 * _e378) + ((_e361 * _e399) - (_e362 * _e396))) * _e413);
                let _e447 = (((_e361 * _e378) + ((_e399 * _e345) - (_e402 * _e344))) * _e413);
                let _e448 = (((_e362 * _e378) + ((_e402 * _e343) - (_e396 * _e345))) * _e413);
                let _e449 = (((_e363 * _e378) + ((_e396 * _e344) - (_e399 * _e343))) * _e413);
                let _e450 = (0.5f * _e370.y);
                let _e457 = ((_e429 * _e370.x) + (_e447 * _e450));
                let _e458 = ((_e430 * _e370.x) + (_e448 * _e450));
                let _e459 = ((_e431 * _e370.x) + (_e449 * _e450));
                let _e466 = ((_e429 * _e450) + (_e447 * _e370.z));
                let _e467 = ((_e430 * _e450) + (_e448 * _e370.z));
                let _e468 = ((_e431 * _e450) + (_e449 * _e370.z));
                let _e470 = ((_e393 + _e378) * _e413);
                let _e472 = (-((((_e343 * _e361) + (_e344 * _e362)) + (_e345 * _e363))) * _e413);
                let _e474 = ((_e383 + _e378) * _e413);
                let _e499 = ((((_e457 * _e470) + (_e466 * _e472)) * -2f) * _e325);
                let _e500 = ((((_e458 * _e470) + (_e467 * _e472)) * -2f) * _e326);
                let _e501 = ((((_e459 * _e470) + (_e468 * _e472)) * -2f) * _e327);
                let _e502 = ((((_e457 * _e472) + (_e466 * _e474)) * -2f) * _e325);
                let _e503 = ((((_e458 * _e472) + (_e467 * _e474)) * -2f) * _e326);
                let _e504 = ((((_e459 * _e472) + (_e468 * _e474)) * -2f) * _e327);
                let _e517 = (((_e299 * _e499) + (_e309 * _e500)) + (_e319 * _e501));
                let _e518 = (((_e303 * _e499) + (_e313 * _e500)) + (_e321 * _e501));
                let _e519 = (((_e307 * _e499) + (_e317 * _e500)) + (_e324 * _e501));
                let _e532 = (((_e299 * _e502) + (_e309 * _e503)) + (_e319 * _e504));
                let _e533 = (((_e303 * _e502) + (_e313 * _e503)) + (_e321 * _e504));
                let _e534 = (((_e307 * _e502) + (_e317 * _e503)) + (_e324 * _e504));
                let _e535 = (1f / _e233);
                let _e536 = (_e121 * _e535);
                let _e537 = (_e125 * _e535);
                let _e558 = ((_e536 * _e366.x) + (select(0f, (-(_e536) * (((_e517 * _e97) + (_e518 * _e101)) + (_e519 * _e105))), (_e256 == _e252)) / _e233));
                let _e561 = ((_e537 * _e366.y) + (select(0f, (-(_e537) * (((_e532 * _e97) + (_e533 * _e101)) + (_e534 * _e105))), (_e261 == _e257)) / _e233));
                let _e578 = (-(((_e252 * _e558) + (_e257 * _e561))) - (((((_e517 * _e270) + (_e518 * _e271)) + (_e519 * _e272)) + (((_e532 * _e279) + (_e533 * _e280)) + (_e534 * _e281))) / _e233));
                let _e597 = (((_e518 * _e272) - (_e519 * _e271)) + ((_e533 * _e281) - (_e534 * _e280)));
                let _e598 = (((_e519 * _e270) - (_e517 * _e272)) + ((_e534 * _e279) - (_e532 * _e281)));
                let _e599 = (((_e517 * _e271) - (_e518 * _e270)) + ((_e532 * _e280) - (_e533 * _e279)));
                local_6 = vec3<f32>((_e161.x + _e558), (_e161.y + _e561), (_e161.z + _e578));
                local_7 = vec3<f32>((_e163.x + (((_e226 * _e578) - (_e231 * _e561)) + (((_e73 * _e597) + (_e77 * _e598)) + (_e81 * _e599)))), (_e163.y + (((_e231 * _e558) - (_e221 * _e578)) + (((_e85 * _e597) + (_e89 * _e598)) + (_e93 * _e599)))), (_e163.z + (((_e221 * _e561) - (_e226 * _e558)) + (((_e97 * _e597) + (_e101 * _e598)) + (_e105 * _e599)))));
                local_8 = (_e165 + 3u);
                local_9 = (_e167 + 1u);
                continue;
            } else {
                break;
            }
            continuing {
                let _e993 = local_6;
                phi_559_ = _e993;
                let _e996 = local_7;
                phi_562_ = _e996;
                let _e999 = local_8;
                phi_564_ = _e999;
                let _e1002 = local_9;
                phi_566_ = _e1002;
            }
        }
        let _e645 = global_3.member.member_5;
        let _e648 = global_3.member.member_3;
        let _e649 = (6u * _e648);
        let _e651 = local;
        let _e653 = bitcast<u32>(_e651.x);
        let _e656 = ((_e653 >> bitcast<u32>(23i)) & 255u);
        if (_e656 == 0u) {
        } else {
            let _e659 = (_e656 % 16u);
            let _e661 = ((_e653 & 8388607u) | 8388608u);
            let _e664 = (_e661 << bitcast<u32>((_e659 & 31u)));
            let _e670 = ((_e661 >> bitcast<u32>(((31u - _e659) & 31u))) >> bitcast<u32>(1i));
            if ((_e653 >> bitcast<u32>(31i)) == 0u) {
                phi_680_ = array<u32, 2>(_e664, _e670);
            } else {
                let _e676 = (~(_e664) + 1u);
                if (_e676 == 0u) {
                    phi_678_ = (~(_e670) + 1u);
                } else {
                    phi_678_ = ~(_e670);
                }
                let _e682 = phi_678_;
                phi_680_ = array<u32, 2>(_e676, _e682);
            }
            let _e685 = phi_680_;
            let _e686 = (_e656 < 255u);
            if _e686 {
                phi_686_ = _e685;
            } else {
                phi_686_ = array<u32, 2>(1u, 0u);
            }
            let _e689 = phi_686_;
            let _e694 = (2u * ((select(16u, (_e656 / 16u), _e686) * _e645) + _e649));
            let _e697 = atomicAdd((&global_11.member[_e694]), _e689[0]);
            let _e705 = atomicAdd((&global_11.member[(_e694 + 1u)]), (_e689[1] + select(0u, 1u, ((_e697 + _e689[0]) < _e689[0]))));
        }
        let _e708 = local_1;
        let _e710 = bitcast<u32>(_e708.y);
        let _e713 = ((_e710 >> bitcast<u32>(23i)) & 255u);
        if (_e713 == 0u) {
        } else {
            let _e716 = (_e713 % 16u);
            let _e718 = ((_e710 & 8388607u) | 8388608u);
            let _e721 = (_e718 << bitcast<u32>((_e716 & 31u)));
            let _e727 = ((_e718 >> bitcast<u32>(((31u - _e716) & 31u))) >> bitcast<u32>(1i));
            if ((_e710 >> bitcast<u32>(31i)) == 0u) {
                phi_737_ = array<u32, 2>(_e721, _e727);
            } else {
                let _e733 = (~(_e721) + 1u);
                if (_e733 == 0u) {
                    phi_735_ = (~(_e727) + 1u);
                } else {
                    phi_735_ = ~(_e727);
                }
                let _e739 = phi_735_;
                phi_737_ = array<u32, 2>(_e733, _e739);
            }
            let _e742 = phi_737_;
            let _e743 = (_e713 < 255u);
            if _e743 {
                phi_743_ = _e742;
            } else {
                phi_743_ = array<u32, 2>(1u, 0u);
            }
            let _e746 = phi_743_;
            let _e751 = (2u * ((select(16u, (_e713 / 16u), _e743) * _e645) + (_e649 + 1u)));
            let _e754 = atomicAdd((&global_11.member[_e751]), _e746[0]);
            let _e762 = atomicAdd((&global_11.member[(_e751 + 1u)]), (_e746[1] + select(0u, 1u, ((_e754 + _e746[0]) < _e746[0]))));
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
                phi_794_ = array<u32, 2>(_e778, _e784);
            } else {
                let _e790 = (~(_e778) + 1u);
                if (_e790 == 0u) {
                    phi_792_ = (~(_e784) + 1u);
                } else {
                    phi_792_ = ~(_e784);
                }
                let _e796 = phi_792_;
                phi_794_ = array<u32, 2>(_e790, _e796);
            }
            let _e799 = phi_794_;
            let _e800 = (_e770 < 255u);
            if _e800 {
                phi_800_ = _e799;
            } else {
                phi_800_ = array<u32, 2>(1u, 0u);
            }
            let _e803 = phi_800_;
            let _e808 = (2u * ((select(16u, (_e770 / 16u), _e800) * _e645) + (_e649 + 2u)));
            let _e811 = atomicAdd((&global_11.member[_e808]), _e803[0]);
            let _e819 = atomicAdd((&global_11.member[(_e808 + 1u)]), (_e803[1] + select(0u, 1u, ((_e811 + _e803[0]) < _e803[0]))));
        }
        let _e822 = local_3;
        let _e824 = bitcast<u32>(_e822.x);
        let _e827 = ((_e824 >> bitcast<u32>(23i)) & 255u);
        if (_e827 == 0u) {
        } else {
            let _e830 = (_e827 % 16u);
            let _e832 = ((_e824 & 8388607u) | 8388608u);
            let _e835 = (_e832 << bitcast<u32>((_e830 & 31u)));
            let _e841 = ((_e832 >> bitcast<u32>(((31u - _e830) & 31u))) >> bitcast<u32>(1i));
            if ((_e824 >> bitcast<u32>(31i)) == 0u) {
                phi_851_ = array<u32, 2>(_e835, _e841);
            } else {
                let _e847 = (~(_e835) + 1u);
                if (_e847 == 0u) {
                    phi_849_ = (~(_e841) + 1u);
                } else {
                    phi_849_ = ~(_e841);
                }
                let _e853 = phi_849_;
                phi_851_ = array<u32, 2>(_e847, _e853);
            }
            let _e856 = phi_851_;
            let _e857 = (_e827 < 255u);
            if _e857 {
                phi_857_ = _e856;
            } else {
                phi_857_ = array<u32, 2>(1u, 0u);
            }
            let _e860 = phi_857_;
            let _e865 = (2u * ((select(16u, (_e827 / 16u), _e857) * _e645) + (_e649 + 3u)));
            let _e868 = atomicAdd((&global_11.member[_e865]), _e860[0]);
            let _e876 = atomicAdd((&global_11.member[(_e865 + 1u)]), (_e860[1] + select(0u, 1u, ((_e868 + _e860[0]) < _e860[0]))));
        }
        let _e879 = local_4;
        let _e881 = bitcast<u32>(_e879.y);
        let _e884 = ((_e881 >> bitcast<u32>(23i)) & 255u);
        if (_e884 == 0u) {
        } else {
            let _e887 = (_e884 % 16u);
            let _e889 = ((_e881 & 8388607u) | 8388608u);
            let _e892 = (_e889 << bitcast<u32>((_e887 & 31u)));
            let _e898 = ((_e889 >> bitcast<u32>(((31u - _e887) & 31u))) >> bitcast<u32>(1i));
            if ((_e881 >> bitcast<u32>(31i)) == 0u) {
                phi_908_ = array<u32, 2>(_e892, _e898);
            } else {
                let _e904 = (~(_e892) + 1u);
                if (_e904 == 0u) {
                    phi_906_ = (~(_e898) + 1u);
                } else {
                    phi_906_ = ~(_e898);
                }
                let _e910 = phi_906_;
                phi_908_ = array<u32, 2>(_e904, _e910);
            }
            let _e913 = phi_908_;
            let _e914 = (_e884 < 255u);
            if _e914 {
                phi_914_ = _e913;
            } else {
                phi_914_ = array<u32, 2>(1u, 0u);
            }
            let _e917 = phi_914_;
            let _e922 = (2u * ((select(16u, (_e884 / 16u), _e914) * _e645) + (_e649 + 4u)));
            let _e925 = atomicAdd((&global_11.member[_e922]), _e917[0]);
            let _e933 = atomicAdd((&global_11.member[(_e922 + 1u)]), (_e917[1] + select(0u, 1u, ((_e925 + _e917[0]) < _e917[0]))));
        }
        let _e936 = local_5;
        let _e938 = bitcast<u32>(_e936.z);
        let _e941 = ((_e938 >> bitcast<u32>(23i)) & 255u);
        if (_e941 == 0u) {
        } else {
            let _e944 = (_e941 % 16u);
            let _e946 = ((_e938 & 8388607u) | 8388608u);
            let _e949 = (_e946 << bitcast<u32>((_e944 & 31u)));
            let _e955 = ((_e946 >> bitcast<u32>(((31u - _e944) & 31u))) >> bitcast<u32>(1i));
            if ((_e938 >> bitcast<u32>(31i)) == 0u) {
                phi_965_ = array<u32, 2>(_e949, _e955);
            } else {
                let _e961 = (~(_e949) + 1u);
                if (_e961 == 0u) {
                    phi_963_ = (~(_e955) + 1u);
                } else {
                    phi_963_ = ~(_e955);
                }
                let _e967 = phi_963_;
                phi_965_ = array<u32, 2>(_e961, _e967);
            }
            let _e970 = phi_965_;
            let _e971 = (_e941 < 255u);
            if _e971 {
                phi_971_ = _e970;
            } else {
                phi_971_ = array<u32, 2>(1u, 0u);
            }
            let _e974 = phi_971_;
            let _e979 = (2u * ((select(16u, (_e941 / 16u), _e971) * _e645) + (_e649 + 5u)));
            let _e982 = atomicAdd((&global_11.member[_e979]), _e974[0]);
            let _e990 = atomicAdd((&global_11.member[(_e979 + 1u)]), (_e974[1] + select(0u, 1u, ((_e982 + _e974[0]) < _e974[0]))));
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
