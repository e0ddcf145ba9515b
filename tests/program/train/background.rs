//! The background of photographs with an alpha channel, and of scenes with gaps.

use std::fs;

use organza::Scene;
use organza::data::Background;
use organza::train::TrainConfig;

use super::runs::{assert_same, bits, photographs, sandbox, stopped};

#[test]
fn blenders_photographs_with_alpha_are_in_front_of_white() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let data = sandbox.path("data");
    fs::rename(data.join("transforms.json"), data.join("transforms_train.json")).unwrap();
    for file in fs::read_dir(data.join("images")).unwrap() {
        let path = file.unwrap().path();
        // the list of pictures is in the same folder
        if path.extension().is_none_or(|extension| extension != "png") {
            continue;
        }
        let mut image = image::open(&path).expect("a picture").to_rgba8();
        image.put_pixel(0, 0, image::Rgba([0; 4]));
        image.save(&path).unwrap();
    }
    let train =
        "train data --config tiny.toml --downscale 2 --hold-out-every 2 --backend cpu --steps 5";
    let background = |run: &str| {
        TrainConfig::load(sandbox.path(run).join("config.toml")).expect("settings").data.background
    };
    let outcome = sandbox.run(&format!("{train} -o white")).assert_ok();
    assert!(outcome.stderr.contains("the background is white"), "{outcome:?}");
    assert_eq!(background("white"), Background::Color([1.0; 3]));
    let outcome = sandbox.run("info white/checkpoint.safetensors --json").assert_ok();
    let info: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    assert_eq!(info["config"]["background"], serde_json::json!([1.0, 1.0, 1.0]), "{info}");
    sandbox.run("train --resume white --backend cpu").assert_ok();
    for (color, expected) in [("black", [0.0; 3]), ("0,0.5,1", [0.0, 0.5, 1.0])] {
        let outcome = sandbox.run(&format!("{train} --background {color} -o {color}")).assert_ok();
        assert!(!outcome.stderr.contains("the background is"), "{outcome:?}");
        assert_eq!(background(color), Background::Color(expected));
    }
}

/// Gaps in the finished scene have the mean color of the photographs, also where a run was stopped between.
#[test]
fn gaps_are_filled_with_the_mean_of_whole_photographs() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let train =
        "train data --config tiny.toml --downscale 2 --hold-out-every 2 --backend cpu --steps 6";
    sandbox.run(&format!("{train} -o whole")).assert_ok();
    stopped(&sandbox, "again", "whole", 3);
    sandbox.run("train --resume again --backend cpu").assert_ok();
    assert_same("resumed", &bits(&sandbox, "again"), &bits(&sandbox, "whole"));
    sandbox.run(&format!("{train} --background black -o black")).assert_ok();
    let background = |run: &str| {
        let scene = Scene::load(sandbox.path(run).join("checkpoint.safetensors"));
        scene.expect("a scene").config.background
    };
    assert_eq!(background("black"), [0.0; 3]);
    assert_eq!(background("again"), background("whole"));

    let folder = sandbox.path("data/images");
    let mut files: Vec<_> =
        fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "png"));
    files.sort();
    // the first and every second one are held out
    let train = files.iter().skip(1).step_by(2).map(|path| image::open(path).unwrap().to_rgb8());
    let pixels: Vec<_> =
        train.flat_map(|image| image.pixels().copied().collect::<Vec<_>>()).collect();
    let mean = [0, 1, 2].map(|channel| {
        let sum: f64 = pixels.iter().map(|pixel| f64::from(pixel[channel])).sum();
        sum / (255.0 * pixels.len() as f64)
    });
    for (found, expected) in background("whole").into_iter().zip(mean) {
        // downscaled photographs are rounded again
        assert!((found - expected).abs() < 2e-3, "{found}, {expected}");
    }
}
