//! `organza edit`: which Gaussians go and stay.

use std::collections::HashSet;

use glam::DVec3;
use organza::scene::Gaussians;
use organza::{Camera, Scene};
use organza_tests::cases;
use serde_json::Value;

use crate::sandbox::Sandbox;
use crate::train::runs::{self, TINY};

/// Runs the command. Returns its JSON, and the scene that it wrote.
fn edit(sandbox: &Sandbox, words: &str) -> (Value, Scene) {
    let words = format!("edit {words} -o edited.safetensors --backend cpu --json");
    (sandbox.run(&words).json(), Scene::load(sandbox.path("edited.safetensors")).expect("a scene"))
}

/// Adds copies of Gaussians to a scene's file, each after `change`.
fn plant(sandbox: &Sandbox, copies: usize, change: impl Fn(usize, &mut Scene)) -> Scene {
    let mut scene = Scene::load(sandbox.path("scene.safetensors")).expect("a scene");
    let before = scene.clone();
    for copy in 0..copies {
        scene.gaussians.append(&before.gaussians.select(&[copy]));
        change(before.gaussians.len() + copy, &mut scene);
    }
    scene.save(sandbox.path("planted.safetensors")).expect("it is written");
    before
}

#[test]
fn a_scene_is_cropped_by_a_box() {
    let sandbox = Sandbox::new("crowded");
    let scene = Scene::load(sandbox.path("scene.safetensors")).expect("a scene");
    let places = &scene.gaussians.position;
    let [low, high] = [[-0.5, -2.0, -0.25], [1.0, 0.5, 2.0]];
    let in_box = |p: &[f32; 3]| (0..3).all(|i| low[i] <= p[i] && p[i] <= high[i]);
    let words = "--box 1,0.5,-0.25,-0.5,-2,2";
    for (words, is_kept) in [
        (words.to_owned(), &in_box as &dyn Fn(&[f32; 3]) -> bool),
        (format!("{words} --outside"), &|p| !in_box(p)),
    ] {
        let kept: Vec<_> = (0..places.len()).filter(|&i| is_kept(&places[i])).collect();
        assert!(!kept.is_empty() && kept.len() < places.len(), "{words} shows nothing");
        let (report, edited) = edit(&sandbox, &format!("scene.safetensors {words}"));
        assert_eq!(edited.gaussians, scene.gaussians.select(&kept), "{words}");
        assert_eq!(report["gaussians"], kept.len());
        assert_eq!(report["gaussians_before"], places.len());
        // nothing else changes
        assert_eq!(
            (edited.color, edited.transmittance),
            (scene.color.clone(), scene.transmittance.clone())
        );
        assert_eq!(edited.config, scene.config);
    }
}

/// Gaussians without a contribution go, and no others: images stay the same to the bit, and would not without any of the rest.
#[test]
fn only_gaussians_in_no_view_are_removed() {
    let sandbox = Sandbox::new("crowded");
    // behind the cameras, and too transparent for f32
    plant(&sandbox, 9, |i, scene| match i % 2 {
        0 => scene.gaussians.position[i] = [0.0, 0.0, 900.0],
        _ => scene.gaussians.opacity[i] = -200.0,
    });
    let words = "planted.safetensors cameras.json --min-contribution";
    let (report, edited) = edit(&sandbox, words);
    assert_eq!(report["removed"][0]["rule"], "in no view");
    assert!(report["removed"][0]["gaussians"].as_u64() >= Some(9), "{report}");
    let tiles = |scene: &str| {
        let words = format!("tiles {scene} cameras.json all.json -o out --backend cpu");
        sandbox.run(&words).assert_ok();
        sandbox.read("out")
    };
    // all of both images
    let tile =
        |at: usize| serde_json::json!({"camera": at / 4, "origin": [at % 2 * 48, at / 2 % 2 * 40]});
    let all = serde_json::json!({"side": 48, "tiles": (0..8).map(tile).collect::<Vec<_>>()});
    sandbox.write("all.json", all.to_string());
    let exact = tiles("edited.safetensors");
    assert!(exact == tiles("planted.safetensors"), "the images have changed");
    let count = edited.gaussians.len();
    for missing in (0..count).step_by(count / 12) {
        let others: Vec<_> = (0..count).filter(|&i| i != missing).collect();
        let fewer = Scene { gaussians: edited.gaussians.select(&others), ..edited.clone() };
        fewer.save(sandbox.path("fewer.safetensors")).expect("it is written");
        assert!(exact != tiles("fewer.safetensors"), "the images do not need Gaussian {missing}");
    }
    let (more, _) = edit(&sandbox, &format!("{words}=5"));
    assert!(more["gaussians"].as_u64() < report["gaussians"].as_u64(), "{more}");
}

/// Number of floaters that [`plant_floaters`] plants.
const FLOATERS: usize = 200;

/// Plants floaters in the air before some cameras all around the built-in scene, thinned, whose photographs are in `demo`. Returns
/// all Gaussians of `planted.safetensors`; the floaters are the last ones.
pub fn plant_floaters(sandbox: &Sandbox, views: usize, side: u32) -> Gaussians {
    let mut scene = cases::thinned(8, 8_f32.ln() / 2.0);
    // most of the time would go into samples
    scene.config.step *= 8.0;
    scene.save(sandbox.path("scene.safetensors")).expect("it is written");
    let mut cameras = organza::demo::turntable(views, side);
    Camera::save_all(sandbox.path("cameras.json"), &cameras).expect("cameras");
    sandbox.run("render scene.safetensors cameras.json -o demo --backend cpu").assert_ok();
    for (index, camera) in cameras.iter_mut().enumerate() {
        camera.file_path = Some(format!("{index:04}.png"));
    }
    Camera::save_all(sandbox.path("demo/transforms.json"), &cameras).expect("cameras");
    plant(sandbox, FLOATERS, |i, scene| {
        // evenly over the images, and over a tenth to six tenths of the way
        let part = |step: f64| (i as f64 * step).fract();
        let camera = &cameras[i % cameras.len()];
        let [right, down, forward] = camera.axes();
        let eye = DVec3::from(camera.eye());
        let far = (0.1 + 0.5 * part(0.437)) * eye.length();
        let [x, y] =
            [part(0.7549), part(0.5698)].map(|at| (at - 0.5) * 0.8 * f64::from(side) / camera.fl_x);
        let place = eye + far * (forward + x * right + y * down);
        scene.gaussians.position[i] = place.to_array().map(|x| x as f32);
        scene.gaussians.log_scale[i] = [-3.2, -3.0, -2.8];
        scene.gaussians.opacity[i] = -0.8 + 4.0 * part(0.618) as f32;
    });
    Scene::load(sandbox.path("planted.safetensors")).expect("a scene").gaussians
}

/// Planted floaters go, the scene stays, and photographs that are held out look better.
#[test]
fn planted_floaters_go() {
    let sandbox = Sandbox::new("tiny");
    let all = plant_floaters(&sandbox, 24, 64);
    let old = all.len() - FLOATERS;
    let psnr = |scene: &str| {
        let words = format!("eval {scene}.safetensors demo --downscale 2 --backend cpu --json");
        sandbox.run(&words).json()["mean"]["psnr"].as_f64().expect("a number")
    };
    let before = psnr("planted");
    for strength in ["0", "0.3", "0.5"] {
        let words =
            format!("planted.safetensors demo --downscale 2 --clean {strength} --split train");
        let (report, edited) = edit(&sandbox, &words);
        if strength == "0" {
            assert_eq!(edited.gaussians, all, "{report}");
            continue;
        }
        let bits = |place: &[f32; 3]| place.map(f32::to_bits);
        let places: HashSet<_> = edited.gaussians.position.iter().map(bits).collect();
        let is_left = |i: &usize| places.contains(&bits(&all.position[*i]));
        let lost = old - (0..old).filter(is_left).count();
        let floaters = (old..all.len()).filter(is_left).count();
        assert!(floaters * 20 <= FLOATERS && lost * 100 < old, "{floaters}, {lost}: {report}");
        assert_eq!(report["removed"][0]["rule"], format!("floaters, strength {strength}"));
        assert!(psnr("edited") > before + 5.0, "{report}");
    }
}

#[test]
fn a_run_is_edited_and_every_command_takes_the_result() {
    let sandbox = runs::sandbox();
    sandbox.run(&format!("{TINY} run --hold-out-every 3")).assert_ok();
    let words = "run --min-contribution --clean 0.1";
    let (report, _) = edit(&sandbox, words);
    crate::flags::assert_documented("edit", std::slice::from_ref(&report));
    let held_out = |scene: &str| {
        sandbox.run(&format!("eval {scene} --backend cpu --json")).json()["mean"]["psnr"].clone()
    };
    assert_eq!(report["held_out"]["psnr_before"], held_out("run"));
    assert_eq!(report["held_out"]["psnr"], held_out("edited.safetensors views"));
    let faint = "edit run -o faint.safetensors --min-contribution=40 --backend cpu";
    sandbox.run(faint).assert_ok().says(&["warning: this costs"]);
    let text = sandbox.run(&format!("edit {words} -o again.safetensors --backend cpu")).assert_ok();
    for fact in ["before", "in no view", "after"] {
        assert!(text.stdout.contains(fact), "{text:?}");
    }
    for words in [
        "render edited.safetensors cameras.json -o images --backend cpu",
        "film edited.safetensors cameras.json -o film.png --frames 2 --size 16x16 --backend cpu",
        "export edited.safetensors cameras.json -o splats.ply --steps 0 --side 16 --backend cpu",
        "export-web edited.safetensors -o page --backend cpu",
        "eval edited.safetensors views --hold-out-every 3 --backend cpu",
        "edit edited.safetensors -o twice.safetensors --box -99,-99,-99,99,99,99",
    ] {
        sandbox.run(words).assert_ok();
    }
}

#[test]
fn bad_options_are_refused() {
    let sandbox = Sandbox::new("tiny");
    for (words, facts) in [
        ("", &["nothing to do", "--box"][..]),
        ("--outside --clean 0.3", &["not provided", "--box"]),
        ("--box 0,0,0", &["--box", "two corners"]),
        ("--box 0,0,0,1,,2", &["--box", "two corners"]),
        ("--box 0,0,0,1,inf,2", &["--box", "two corners"]),
        ("--clean 1.5", &["--clean", "0 to 1"]),
        ("--clean 0.5", &["scene.safetensors", "name the data set"]),
        ("--min-contribution=-1", &["--min-contribution", "0 or more"]),
        ("--min-contribution", &["scene.safetensors", "name the data set"]),
        ("--box 900,0,0,901,1,1", &["nothing would be left", "outside the box", "1 Gaussian"]),
    ] {
        let words = format!("edit scene.safetensors {words} -o new.safetensors");
        sandbox.assert_refuses(&words, facts);
        assert!(!sandbox.path("new.safetensors").exists(), "{words}");
    }
    // before a device is opened
    let outcome = sandbox.run("edit scene.safetensors --box 9,9,9,10,10,10 -o new.safetensors");
    outcome.assert_refused(&["nothing would be left"]);
    assert_eq!(outcome.stderr.lines().count(), 1, "{outcome:?}");
    let words = "edit scene.safetensors --scale 2 -o scene.safetensors";
    sandbox.assert_refuses(words, &["would replace the input"]);
}
