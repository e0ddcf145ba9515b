//! `organza eval`, on data sets whose photographs the program itself has rendered.

use serde_json::{Value, json};

use crate::sandbox::{Outcome, Sandbox};

/// A data set of two frames, rendered from the scene, in the folder `data`. Frame 0 is held out.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new("crowded");
    sandbox.run("render scene.safetensors cameras.json -o data/images --backend cpu").assert_ok();
    sandbox.copy_file("cameras.json", "data/transforms.json");
    sandbox
}

fn eval(sandbox: &Sandbox, more: &str) -> Outcome {
    sandbox.run(&format!("eval scene.safetensors data --backend cpu {more}"))
}

/// Asserts that `value` is in a range.
#[track_caller]
fn assert_within(value: &Value, range: std::ops::RangeInclusive<f64>) {
    assert!(value.as_f64().is_some_and(|value| range.contains(&value)), "{value} in {range:?}");
}

#[test]
fn rounding_is_all_that_a_scene_lacks_of_its_own_images() {
    let sandbox = sandbox();
    let found = eval(&sandbox, "--split all --json").json();
    let views = found["views"].as_array().unwrap();
    assert_eq!(views.len(), 2);
    for (view, name) in views.iter().zip(["images/0000.png", "images/0001.png"]) {
        assert_eq!(view["name"], name);
        // a variance of 1/12 of one of 255 levels is 58.9 dB
        assert_within(&view["psnr"], 58.0..=62.0);
        assert_within(&view["ssim"], 0.998..=1.0);
    }
    // a gain and an offset have next to nothing to mend
    let fitted = eval(&sandbox, "--split all --json --fit-colors").json();
    assert_within(&fitted["mean"]["psnr_fitted"], 58.0..=62.0);
    for value in ["psnr", "ssim"] {
        let [a, b] = [0, 1].map(|view: usize| views[view][value].as_f64().unwrap());
        assert_within(&found["mean"][value], (a + b) / 2.0 - 1e-9..=(a + b) / 2.0 + 1e-9);
    }
}

#[test]
fn the_split_selects_the_frames() {
    let sandbox = sandbox();
    let names = |more: &str| -> Vec<Value> {
        let found = eval(&sandbox, &format!("--json {more}")).json();
        found["views"].as_array().unwrap().iter().map(|view| view["name"].clone()).collect()
    };
    assert_eq!(names(""), ["images/0000.png"]);
    assert_eq!(names("--split held-out"), ["images/0000.png"]);
    assert_eq!(names("--split train"), ["images/0001.png"]);
    let outcome = eval(&sandbox, "").assert_ok();
    let lines: Vec<_> = outcome.stdout.lines().collect();
    assert_eq!(lines.len(), 3, "{outcome:?}");
    assert!(lines[0].starts_with("view") && lines[0].ends_with("PSNR    SSIM"), "{outcome:?}");
    assert!(
        lines[1].starts_with("images/0000.png  ") && lines[2].starts_with("mean "),
        "{outcome:?}"
    );
    assert!(outcome.stderr.contains("measured 1 view in"), "{outcome:?}");
    assert_eq!(eval(&sandbox, "--quiet").assert_ok().stderr, "");
}

#[test]
fn alpha_is_put_in_front_of_the_background() {
    let sandbox = sandbox();
    image::RgbaImage::new(96, 80).save(sandbox.path("data/images/0000.png")).unwrap();
    let psnr = |background: &str| {
        eval(&sandbox, &format!("--json {background}")).json()["mean"]["psnr"].as_f64().unwrap()
    };
    let scene = sandbox.run("info scene.safetensors --json").json();
    let background = scene["config"]["background"].as_array().expect("a color");
    let list: Vec<_> = background.iter().map(|value| value.to_string()).collect();
    assert_eq!(psnr(""), psnr(&format!("--background {}", list.join(","))));
    assert!(psnr("--background 1,1,1") != psnr("--background 0,0,0"));
}

#[test]
fn bad_requests() {
    let sandbox = sandbox();
    for (words, facts) in [
        ("--background 2,0,0", ["--background", "0 to 1"]),
        ("--downscale 0", ["--downscale", "'0'"]),
        ("--downscale 81", ["0000.png", "81"]),
        ("--hold-out-every 1", ["--hold-out-every", "'1'"]),
        ("--split test", ["--split", "'test'"]),
    ] {
        sandbox.assert_refuses(&format!("eval scene.safetensors data {words}"), &facts);
    }
}

#[test]
fn data_without_held_out_frames_is_refused_with_advice() {
    let sandbox = sandbox();
    // the only frame that is held out
    sandbox.remove("data/images/0000.png");
    let outcome = eval(&sandbox, "");
    outcome.assert_refused(&["no frame", "held out", "--split train", "--hold-out-every"]);
    let outcome = eval(&sandbox, "--split train --json");
    assert!(outcome.stderr.contains("warning: missing, so left out: 1 photograph"), "{outcome:?}");
    assert_eq!(outcome.json()["views"][0]["name"], json!("images/0001.png"));
}
