//! Trainings that are not possible are refused with one message, and leave no files.

use serde_json::json;

use super::runs::{TINY, photographs, sandbox};

#[test]
fn bad_requests() {
    let sandbox = sandbox();
    sandbox.write("old/config.toml", "");
    for (words, facts) in [
        ("absent -o new", ["absent", "no such file"]),
        (". -o deep/new", ["no data set", "transforms.json"]),
        ("-o old", ["old", "already holds a run (config.toml)"]),
        ("--resume absent", ["absent: there is no such folder", "organza train -o"]),
        ("--resume .", ["the folder has no config.toml", "not a training run's"]),
        ("--resume old --seed 5", ["old/config.toml", "is missing"]),
        ("-o new --set data.background=whitish", ["`data.background`", "a color such as white"]),
        ("--config absent.toml -o new", ["absent.toml", "no such file"]),
        ("-o tiny.toml", ["tiny.toml", "file"]),
        ("-o new --tile-size 513", ["`run.tile_size` is 513", "1 to 512"]),
        ("-o new --time-limit 0", ["--time-limit", "0"]),
        ("-o new --preset quick", ["'quick'", "fast, default, best, built-in"]),
        ("-o new --set run.stesp=5", ["no setting `run.stesp`", "did you mean `run.steps`?"]),
    ] {
        sandbox.assert_refuses(&format!("train {words} --backend cpu"), &facts);
    }
}

/// With a smaller limit, a run begins with that many Gaussians.
#[test]
fn the_most_gaussians_are_the_most_at_the_start() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 1 --max-gaussians 50")).assert_ok();
    let info = sandbox.run("info run/checkpoint.safetensors --json").json();
    assert_eq!(info["gaussians"], json!(50), "{info}");
}

#[test]
fn data_without_training_frames_is_refused() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let train = "train data --config tiny.toml --backend cpu -o new";
    let frame = sandbox.read_json("data/transforms.json");
    sandbox.edit_json("data/transforms.json", "/frames", json!([]));
    sandbox.assert_refuses(train, &["transforms.json", "frames"]);
    // the only frame is held out
    sandbox.edit_json("data/transforms.json", "/frames", json!([frame["frames"][0]]));
    sandbox.assert_refuses(train, &["data", "held out", "none is left to train on"]);
    sandbox.write("data/images/0000.png", "no picture");
    sandbox.assert_refuses(&format!("{train} --hold-out-every 0"), &["0000.png"]);
}

/// Values that overflow end a run, and its last checkpoint stays.
#[test]
fn divergence_is_refused_and_keeps_the_checkpoint() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 30")).assert_ok();
    let name = "run/checkpoint.safetensors";
    sandbox.edit_tensors(name, |metadata, tensors| {
        // as if it had been stopped during the run
        metadata.insert("train".to_owned(), r#"{"step": 4, "seconds": 1.0}"#.to_owned());
        let is_color = |name: &str| name.starts_with("color") && name.ends_with("weight");
        for (_, (_, data)) in tensors.iter_mut().filter(|(name, _)| is_color(name)) {
            data.chunks_mut(4).enumerate().for_each(|(i, value)| {
                let large = if i % 2 == 0 { 3e38_f32 } else { -3e38 };
                value.copy_from_slice(&large.to_le_bytes());
            });
        }
    });
    let before = sandbox.read(name);
    sandbox.run("train --resume run --backend cpu").assert_refused(&["lower the learning rates"]);
    assert!(sandbox.read(name) == before, "the checkpoint has changed");
}
