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
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_21 {
    member: type_20,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_3: type_21;
@group(0) @binding(1) 
var<storage> global_4: type_9;
@group(0) @binding(2) 
var<storage> global_5: type_9;
@group(0) @binding(3) 
var<storage> global_6: type_9;
@group(0) @binding(4) 
var<storage> global_7: type_9;
@group(0) @binding(7) 
var<storage> global_8: type_6;
@group(0) @binding(5) 
var<storage> global_9: type_16;
@group(0) @binding(6) 
var<storage> global_10: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_9;

fn function_() {
    var phi_597_: vec4<f32>;
    var phi_600_: vec3<f32>;
    var phi_602_: vec3<f32>;
    var phi_604_: u32;
    var phi_606_: i32;
    var phi_608_: f32;
    var phi_735_: vec4<f32>;
    var phi_736_: vec3<f32>;
    var phi_737_: vec3<f32>;
    var phi_738_: i32;
    var phi_739_: f32;
    var phi_598_: vec4<f32>;
    var phi_601_: vec3<f32>;
    var phi_603_: vec3<f32>;
    var phi_605_: u32;
    var phi_607_: i32;
    var phi_609_: f32;
    var local: i32;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var local_3: vec3<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var local_11: f32;

    let _e51 = global;
    let _e52 = global_1;
    let _e53 = global_2;
    let _e61 = (((_e52.x + (_e52.y * _e53.x)) * 64u) + _e51.x);
    let _e64 = global_3.member.member;
    if (_e61 < _e64) {
        let _e70 = (1u << bitcast<u32>(((_e61 % 32u) & 31u)));
        let _e71 = (_e61 * 3u);
        let _e74 = global_5.member[_e71];
        let _e75 = (_e71 + 1u);
        let _e78 = global_5.member[_e75];
        let _e79 = (_e71 + 2u);
        let _e82 = global_5.member[_e79];
        let _e83 = (_e61 * 4u);
        let _e86 = global_6.member[_e83];
        let _e90 = global_6.member[(_e83 + 1u)];
        let _e94 = global_6.member[(_e83 + 2u)];
        let _e98 = global_6.member[(_e83 + 3u)];
        let _e101 = global_7.member[_e71];
        let _e104 = global_7.member[_e75];
        let _e107 = global_7.member[_e79];
        phi_597_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_600_ = vec3<f32>(0f, 0f, 0f);
        phi_602_ = vec3<f32>(0f, 0f, 0f);
        phi_604_ = 0u;
        phi_606_ = 0i;
        phi_608_ = 0f;
        loop {
            let _e109 = phi_597_;
            let _e111 = phi_600_;
            let _e113 = phi_602_;
            let _e115 = phi_604_;
            let _e117 = phi_606_;
            let _e119 = phi_608_;
            local = _e117;
            local_1 = _e113;
            local_2 = _e113;
            local_3 = _e113;
            local_4 = _e109;
            local_5 = _e109;
            local_6 = _e109;
            local_7 = _e109;
            local_8 = _e111;
            local_9 = _e111;
            local_10 = _e111;
            local_11 = _e119;
            let _e122 = global_3.member.member_2;
            let _e123 = (_e115 < _e122);
            if _e123 {
                let _e126 = global_3.member.member_1;
                let _e128 = ((_e115 * _e126) + (_e61 / 32u));
                let _e131 = global_9.member[_e128];
                if ((_e131 & _e70) == 0u) {
                    phi_735_ = _e109;
                    phi_736_ = _e111;
                    phi_737_ = _e113;
                    phi_738_ = _e117;
                    phi_739_ = _e119;
                } else {
                    let _e139 = global_10.member[_e128];
                    let _e141 = (3u * (_e139 + countOneBits((_e131 & (_e70 - 1u)))));
                    let _e144 = global_8.member[_e141];
                    let _e148 = global_8.member[(_e141 + 1u)];
                    let _e155 = (_e115 * 18u);
                    let _e158 = global_4.member[_e155];
                    let _e162 = global_4.member[(_e155 + 1u)];
                    let _e166 = global_4.member[(_e155 + 2u)];
                    let _e170 = global_4.member[(_e155 + 3u)];
                    let _e174 = global_4.member[(_e155 + 4u)];
                    let _e178 = global_4.member[(_e155 + 5u)];
                    let _e182 = global_4.member[(_e155 + 6u)];
                    let _e186 = global_4.member[(_e155 + 7u)];
                    let _e190 = global_4.member[(_e155 + 8u)];
                    let _e194 = global_4.member[(_e155 + 9u)];
                    let _e198 = global_4.member[(_e155 + 10u)];
                    let _e202 = global_4.member[(_e155 + 11u)];
                    let _e206 = global_4.member[(_e155 + 12u)];
                    let _e210 = global_4.member[(_e155 + 13u)];
                    let _e214 = global_4.member[(_e155 + 14u)];
                    let _e218 = global_4.member[(_e155 + 15u)];
                    let _e222 = global_4.member[(_e155 + 16u)];
                    let _e226 = global_4.member[(_e155 + 17u)];
                    let _e229 = global_3.member.member_3;
                    let _e230 = (_e74 - _e194);
                    let _e231 = (_e78 - _e198);
                    let _e232 = (_e82 - _e202);
                    let _e247 = (((_e182 * _e230) + (_e186 * _e231)) + (_e190 * _e232));
                    let _e249 = select(1f, _e247, (0.01f < _e247));
                    let _e250 = (1f / _e206);
                    let _e251 = (1f / _e210);
                    let _e254 = ((_e222 * _e250) * 0.15f);
                    let _e255 = ((_e226 * _e251) * 0.15f);
                    let _e260 = (((_e214 * _e250) * -1f) - _e254);
                    let _e261 = (((_e218 * _e251) * -1f) - _e255);
                    let _e266 = (((_e222 - _e214) * _e250) + _e254);
                    let _e267 = (((_e226 - _e218) * _e251) + _e255);
                    let _e268 = ((((_e158 * _e230) + (_e162 * _e231)) + (_e166 * _e232)) / _e249);
                    let _e270 = select(_e260, _e268, (_e268 > _e260));
                    let _e272 = select(_e266, _e270, (_e270 < _e266));
                    let _e273 = ((((_e170 * _e230) + (_e174 * _e231)) + (_e178 * _e232)) / _e249);
                    let _e275 = select(_e261, _e273, (_e273 > _e261));
                    let _e277 = select(_e267, _e275, (_e275 < _e267));
                    let _e278 = (_e206 / _e249);
                    let _e279 = (_e210 / _e249);
                    let _e286 = ((_e158 - (_e182 * _e272)) * _e278);
                    let _e287 = ((_e162 - (_e186 * _e272)) * _e278);
                    let _e288 = ((_e166 - (_e190 * _e272)) * _e278);
                    let _e295 = ((_e170 - (_e182 * _e277)) * _e279);
                    let _e296 = ((_e174 - (_e186 * _e277)) * _e279);
                    let _e297 = ((_e178 - (_e190 * _e277)) * _e279);
                    let _e306 = (1f / sqrt(((((_e86 * _e86) + (_e90 * _e90)) + (_e94 * _e94)) + (_e98 * _e98))));
                    let _e307 = (_e86 * _e306);
                    let _e308 = (_e90 * _e306);
                    let _e309 = (_e94 * _e306);
                    let _e310 = (_e98 * _e306);
                    let _e311 = (_e309 * _e309);
                    let _e312 = (_e310 * _e310);
                    let _e315 = (1f - (2f * (_e311 + _e312)));
                    let _e316 = (_e308 * _e309);
                    let _e317 = (_e307 * _e310);
                    let _e319 = (2f * (_e316 + _e317));
                    let _e320 = (_e308 * _e310);
                    let _e321 = (_e307 * _e309);
                    let _e323 = (2f * (_e320 - _e321));
                    let _e325 = (2f * (_e316 - _e317));
                    let _e326 = (_e308 * _e308);
                    let _e329 = (1f - (2f * (_e326 + _e312)));
                    let _e330 = (_e309 * _e310);
                    let _e331 = (_e307 * _e308);
                    let _e333 = (2f * (_e330 + _e331));
                    let _e335 = (2f * (_e320 + _e321));
                    let _e337 = (2f * (_e330 - _e331));
                    let _e340 = (1f - (2f * (_e326 + _e311)));
                    let _e341 = exp(_e101);
                    let _e342 = exp(_e104);
                    let _e343 = exp(_e107);
                    let _e359 = ((((_e286 * _e315) + (_e287 * _e319)) + (_e288 * _e323)) * _e341);
                    let _e360 = ((((_e286 * _e325) + (_e287 * _e329)) + (_e288 * _e333)) * _e342);
                    let _e361 = ((((_e286 * _e335) + (_e287 * _e337)) + (_e288 * _e340)) * _e343);
                    let _e377 = ((((_e295 * _e315) + (_e296 * _e319)) + (_e297 * _e323)) * _e341);
                    let _e378 = ((((_e295 * _e325) + (_e296 * _e329)) + (_e297 * _e333)) * _e342);
                    let _e379 = ((((_e295 * _e335) + (_e296 * _e337)) + (_e297 * _e340)) * _e343);
                    let _e384 = (((_e359 * _e359) + (_e360 * _e360)) + (_e361 * _e361));
                    let _e394 = (((_e377 * _e377) + (_e378 * _e378)) + (_e379 * _e379));
                    let _e397 = ((_e360 * _e379) - (_e361 * _e378));
                    let _e400 = ((_e361 * _e377) - (_e359 * _e379));
                    let _e403 = ((_e359 * _e378) - (_e360 * _e377));
                    let _e414 = (1f / (((((_e397 * _e397) + (_e400 * _e400)) + (_e403 * _e403)) + (_e229 * (_e384 + _e394))) + (_e229 * _e229)));
                    let _e430 = (((_e359 * _e229) + ((_e378 * _e403) - (_e379 * _e400))) * _e414);
                    let _e431 = (((_e360 * _e229) + ((_e379 * _e397) - (_e377 * _e403))) * _e414);
                    let _e432 = (((_e361 * _e229) + ((_e377 * _e400) - (_e378 * _e397))) * _e414);
                    let _e448 = (((_e377 * _e229) + ((_e400 * _e361) - (_e403 * _e360))) * _e414);
                    let _e449 = (((_e378 * _e229) + ((_e403 * _e359) - (_e397 * _e361))) * _e414);
                    let _e450 = (((_e379 * _e229) + ((_e397 * _e360) - (_e400 * _e359))) * _e414);
                    let _e451 = (0.5f * _e148.y);
                    let _e458 = ((_e430 * _e148.x) + (_e448 * _e451));
                    let _e459 = ((_e431 * _e148.x) + (_e449 * _e451));
                    let _e460 = ((_e432 * _e148.x) + (_e450 * _e451));
                    let _e467 = ((_e430 * _e451) + (_e448 * _e148.z));
                    let _e468 = ((_e431 * _e451) + (_e449 * _e148.z));
                    let _e469 = ((_e432 * _e451) + (_e450 * _e148.z));
                    let _e471 = ((_e394 + _e229) * _e414);
                    let _e473 = (-((((_e359 * _e377) + (_e360 * _e378)) + (_e361 * _e379))) * _e414);
                    let _e475 = ((_e384 + _e229) * _e414);
                    let _e485 = (((_e458 * _e471) + (_e467 * _e473)) * -2f);
                    let _e486 = (((_e459 * _e471) + (_e468 * _e473)) * -2f);
                    let _e487 = (((_e460 * _e471) + (_e469 * _e473)) * -2f);
                    let _e497 = (((_e458 * _e473) + (_e467 * _e475)) * -2f);
                    let _e498 = (((_e459 * _e473) + (_e468 * _e475)) * -2f);
                    let _e499 = (((_e460 * _e473) + (_e469 * _e475)) * -2f);
                    let _e509 = (_e485 * _e341);
                    let _e510 = (_e486 * _e342);
                    let _e511 = (_e487 * _e343);
                    let _e512 = (_e497 * _e341);
                    let _e513 = (_e498 * _e342);
                    let _e514 = (_e499 * _e343);
                    let _e521 = ((_e286 * _e509) + (_e295 * _e512));
                    let _e522 = ((_e287 * _e509) + (_e296 * _e512));
                    let _e523 = ((_e288 * _e509) + (_e297 * _e512));
                    let _e530 = ((_e286 * _e510) + (_e295 * _e513));
                    let _e531 = ((_e287 * _e510) + (_e296 * _e513));
                    let _e532 = ((_e288 * _e510) + (_e297 * _e513));
                    let _e539 = ((_e286 * _e511) + (_e295 * _e514));
                    let _e540 = ((_e287 * _e511) + (_e296 * _e514));
                    let _e541 = ((_e288 * _e511) + (_e297 * _e514));
                    let _e554 = (((_e315 * _e509) + (_e325 * _e510)) + (_e335 * _e511));
                    let _e555 = (((_e319 * _e509) + (_e329 * _e510)) + (_e337 * _e511));
                    let _e556 = (((_e323 * _e509) + (_e333 * _e510)) + (_e340 * _e511));
                    let _e569 = (((_e315 * _e512) + (_e325 * _e513)) + (_e335 * _e514));
                    let _e570 = (((_e319 * _e512) + (_e329 * _e513)) + (_e337 * _e514));
                    let _e571 = (((_e323 * _e512) + (_e333 * _e513)) + (_e340 * _e514));
                    let _e572 = (1f / _e249);
                    let _e573 = (_e206 * _e572);
                    let _e574 = (_e210 * _e572);
                    let _e595 = ((_e573 * _e144.x) + (select(0f, (-(_e573) * (((_e554 * _e182) + (_e555 * _e186)) + (_e556 * _e190))), (_e272 == _e268)) / _e249));
                    let _e598 = ((_e574 * _e144.y) + (select(0f, (-(_e574) * (((_e569 * _e182) + (_e570 * _e186)) + (_e571 * _e190))), (_e277 == _e273)) / _e249));
                    let _e615 = (-(((_e268 * _e595) + (_e273 * _e598))) - (((((_e554 * _e286) + (_e555 * _e287)) + (_e556 * _e288)) + (((_e569 * _e295) + (_e570 * _e296)) + (_e571 * _e297))) / _e249));
                    let _e631 = (_e532 - _e540);
                    let _e632 = (_e539 - _e523);
                    let _e633 = (_e522 - _e530);
                    let _e634 = (_e522 + _e530);
                    let _e635 = (_e523 + _e539);
                    let _e636 = (_e532 + _e540);
                    let _e669 = ((((_e308 * _e631) + (_e309 * _e632)) + (_e310 * _e633)) * 2f);
                    let _e670 = (((((_e307 * _e631) + (_e309 * _e634)) + (_e310 * _e635)) - ((2f * _e308) * (_e531 + _e541))) * 2f);
                    let _e671 = (((((_e307 * _e632) + (_e308 * _e634)) + (_e310 * _e636)) - ((2f * _e309) * (_e521 + _e541))) * 2f);
                    let _e672 = (((((_e307 * _e633) + (_e308 * _e635)) + (_e309 * _e636)) - ((2f * _e310) * (_e521 + _e531))) * 2f);
                    let _e679 = ((((_e669 * _e307) + (_e670 * _e308)) + (_e671 * _e309)) + (_e672 * _e310));
                    phi_735_ = vec4<f32>((_e109.x + ((_e669 - (_e307 * _e679)) * _e306)), (_e109.y + ((_e670 - (_e308 * _e679)) * _e306)), (_e109.z + ((_e671 - (_e309 * _e679)) * _e306)), (_e109.w + ((_e672 - (_e310 * _e679)) * _e306)));
                    phi_736_ = vec3<f32>((_e111.x + ((_e485 * _e359) + (_e497 * _e377))), (_e111.y + ((_e486 * _e360) + (_e498 * _e378))), (_e111.z + ((_e487 * _e361) + (_e499 * _e379))));
                    phi_737_ = vec3<f32>((_e113.x + (((_e158 * _e595) + (_e170 * _e598)) + (_e182 * _e615))), (_e113.y + (((_e162 * _e595) + (_e174 * _e598)) + (_e186 * _e615))), (_e113.z + (((_e166 * _e595) + (_e178 * _e598)) + (_e190 * _e615))));
                    phi_738_ = (_e117 + 1i);
                    phi_739_ = (_e119 + _e144.z);
                }
                let _e718 = phi_735_;
                let _e720 = phi_736_;
                let _e722 = phi_737_;
                let _e724 = phi_738_;
                let _e726 = phi_739_;
                phi_598_ = _e718;
                phi_601_ = _e720;
                phi_603_ = _e722;
                phi_605_ = (_e115 + 1u);
                phi_607_ = _e724;
                phi_609_ = _e726;
            } else {
                phi_598_ = vec4<f32>();
                phi_601_ = vec3<f32>();
                phi_603_ = vec3<f32>();
                phi_605_ = u32();
                phi_607_ = i32();
                phi_609_ = f32();
            }
            let _e729 = phi_598_;
            let _e731 = phi_601_;
            let _e733 = phi_603_;
            let _e735 = phi_605_;
            let _e737 = phi_607_;
            let _e739 = phi_609_;
            continue;
            continuing {
                phi_597_ = _e729;
                phi_600_ = _e731;
                phi_602_ = _e733;
                phi_604_ = _e735;
                phi_606_ = _e737;
                phi_608_ = _e739;
                break if !(_e123);
            }
        }
        let _e742 = local;
        if (_e742 > 0i) {
            let _e744 = (3u * _e61);
            let _e746 = local_1;
            let _e750 = global_11.member[_e744];
            global_11.member[_e744] = (_e750 + _e746.x);
            let _e754 = local_2;
            let _e758 = global_11.member[(_e744 + 1u)];
            global_11.member[(_e744 + 1u)] = (_e758 + _e754.y);
            let _e762 = local_3;
            let _e766 = global_11.member[(_e744 + 2u)];
            global_11.member[(_e744 + 2u)] = (_e766 + _e762.z);
            let _e770 = ((3u * _e64) + (4u * _e61));
            let _e772 = local_4;
            let _e776 = global_11.member[_e770];
            global_11.member[_e770] = (_e776 + _e772.x);
            let _e780 = local_5;
            let _e784 = global_11.member[(_e770 + 1u)];
            global_11.member[(_e770 + 1u)] = (_e784 + _e780.y);
            let _e788 = local_6;
            let _e792 = global_11.member[(_e770 + 2u)];
            global_11.member[(_e770 + 2u)] = (_e792 + _e788.z);
            let _e796 = local_7;
            let _e800 = global_11.member[(_e770 + 3u)];
            global_11.member[(_e770 + 3u)] = (_e800 + _e796.w);
            let _e803 = ((7u * _e64) + _e744);
            let _e805 = local_8;
            let _e809 = global_11.member[_e803];
            global_11.member[_e803] = (_e809 + _e805.x);
            let _e813 = local_9;
            let _e817 = global_11.member[(_e803 + 1u)];
            global_11.member[(_e803 + 1u)] = (_e817 + _e813.y);
            let _e821 = local_10;
            let _e825 = global_11.member[(_e803 + 2u)];
            global_11.member[(_e803 + 2u)] = (_e825 + _e821.z);
            let _e831 = global_11.member[((10u * _e64) + _e61)];
            let _e833 = local_11;
            global_11.member[((10u * _e64) + _e61)] = (_e831 + _e833);
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
