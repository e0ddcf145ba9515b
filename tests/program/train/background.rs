//! The background of photographs with an alpha channel.

use std::fs;

use organza::data::Background;
use organza::train::TrainConfig;

use super::runs::{photographs, sandbox};

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
