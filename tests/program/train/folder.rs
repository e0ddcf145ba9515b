//! A run's folder belongs together: its settings, its data, its checkpoint, and a single training that writes to it.

use std::fs;
use std::process::Stdio;

use serde_json::json;

use super::runs::{TINY, photographs, sandbox};
use crate::sandbox::{Outcome, Sandbox, wait_until};

const RESUME: &str = "train --resume run --backend cpu";
const SAVED: &str = "run/checkpoint.safetensors";

/// A run on photographs that was stopped after ten of 40 steps.
fn stopped(sandbox: &Sandbox) {
    photographs(sandbox);
    let words =
        "train data --config tiny.toml --downscale 2 --hold-out-every 2 --backend cpu -o run";
    sandbox.run(words).assert_ok();
    sandbox.edit_tensors(SAVED, |metadata, _| {
        metadata.insert("train".to_owned(), r#"{"step": 10, "seconds": 1.0}"#.to_owned());
    });
}

#[test]
fn settings_that_are_not_the_checkpoints_are_refused_by_name() {
    let sandbox = sandbox();
    stopped(&sandbox);
    let config = sandbox.text("run/config.toml");
    let facts = ["run/config.toml", "but the checkpoint beside it was trained with"];
    // the number of steps may change: see `extend.rs`
    for (from, to, name) in [
        ("seed = 0", "seed = 1", "`run.seed` is 1"),
        ("tile_size = 16", "tile_size = 8", "`run.tile_size` is 8"),
        ("downscale = 2", "downscale = 1", "`data.downscale` is 1"),
        ("ssim_weight = 0.2", "ssim_weight = 0.25", "`loss.ssim_weight` is 0.25"),
    ] {
        sandbox.edit_text("run/config.toml", |config| config.replacen(from, to, 1));
        sandbox.assert_refuses(RESUME, &[facts[0], facts[1], name]);
        sandbox.assert_refuses("eval run --backend cpu", &[facts[0], facts[1], name]);
        sandbox.write("run/config.toml", &config);
    }
    // cut short anywhere, also to nothing
    for part in [0, 1, 3, 5, 7] {
        sandbox.edit_text("run/config.toml", |config| config[..config.len() * part / 8].to_owned());
        sandbox.assert_refuses(RESUME, &["run/config.toml"]);
        sandbox.write("run/config.toml", &config);
    }
    sandbox.run(RESUME).assert_ok();
}

#[test]
fn data_that_is_not_the_checkpoints_is_refused_by_name() {
    let sandbox = sandbox();
    stopped(&sandbox);
    let transforms = sandbox.read("data/transforms.json");
    let photograph = sandbox.read("data/images/0001.png");
    let other = "are not those that the run was trained on";
    sandbox.edit_json("data/transforms.json", "/fl_x", json!(50.0));
    sandbox.assert_refuses(RESUME, &["data", "frames", other]);
    sandbox.write("data/transforms.json", &transforms);
    sandbox.copy_file("data/images/0000.png", "data/images/0001.png");
    sandbox.assert_refuses(RESUME, &["data", "photographs", other]);
    sandbox.write("data/images/0001.png", &photograph);
    // the data may move
    sandbox.rename("data", "moved");
    sandbox.edit_text("run/config.toml", |config| config.replacen("/data\"", "/moved\"", 1));
    sandbox.run(RESUME).assert_ok();
}

#[test]
fn only_a_runs_own_checkpoint_goes_on() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run")).assert_ok();
    sandbox.edit_tensors(SAVED, |metadata, _| {
        assert!(metadata.remove("run").is_some(), "it is bound");
    });
    for words in [RESUME, "eval run --backend cpu"] {
        sandbox.assert_refuses(words, &["lacks `run` metadata", "no run wrote this checkpoint"]);
    }
}

#[test]
fn moments_and_statistics_that_are_no_numbers_are_refused_by_name() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 10")).assert_ok();
    let checkpoint = sandbox.read(SAVED);
    for (name, value, fact) in [
        ("adam.first.gaussians.position", f32::NAN, "holds NaN at flat index 2"),
        ("adam.second.color.grid", f32::INFINITY, "holds inf at flat index 2"),
        ("adam.second.gaussians.opacity", -1.0, "holds -1 at flat index 2, expected 0 or more"),
        ("train.statistics", f32::NAN, "holds NaN at flat index 2"),
    ] {
        sandbox.edit_tensors(SAVED, |_, tensors| {
            let (_, data) = tensors.get_mut(name).expect("a tensor");
            data[8..12].copy_from_slice(&value.to_le_bytes());
        });
        sandbox.assert_refuses(RESUME, &["checkpoint.safetensors", name, fact]);
        sandbox.write(SAVED, &checkpoint);
    }
}

#[test]
fn a_second_training_in_the_same_folder_is_refused() {
    let sandbox = sandbox();
    let mut first = sandbox.command(&format!("{TINY} run --steps 1000000"));
    let mut first = first.stderr(Stdio::null()).spawn().expect("the program starts");
    wait_until("a checkpoint", || sandbox.path(SAVED).exists());
    let holder = format!("process {}", first.id());
    let facts = ["run", "another training writes to this folder", holder.as_str()];
    sandbox.run(RESUME).assert_refused(&facts);
    sandbox.run(&format!("{TINY} run")).assert_refused(&facts);
    let mut of_two = sandbox.command(&format!("{TINY} run"));
    let of_two = of_two.env("OMPI_COMM_WORLD_SIZE", "2").output().expect("the program starts");
    let [_, writes, holder] = facts;
    let facts = [writes, holder, "With `--ranks mpi`, the processes share"];
    Outcome::from(of_two).assert_refused(&facts);
    assert!(first.try_wait().unwrap().is_none(), "the first goes on");
    first.kill().unwrap();
    first.wait().unwrap();
    // the lock of a killed run blocks no other run, and is removed
    sandbox.run(&format!("{RESUME} --time-limit 1")).assert_ok();
    assert!(!sandbox.path("run/.organza-lock").exists());
}

/// Opening a pipe for writing would wait, and writing through a link would change a file elsewhere.
#[cfg(unix)]
#[test]
fn pipes_and_links_in_the_place_of_a_runs_files_are_refused() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 2")).assert_ok();
    sandbox.make_folder("new");
    sandbox.write("precious", "precious");
    let files = [
        "metrics.jsonl",
        "report.html",
        "config.toml",
        "checkpoint.safetensors",
        "evaluations.csv",
    ];
    for name in files {
        for make in ["mkfifo", "ln -s ../precious", "mkdir"] {
            sandbox.shell(&format!("rm -r new; mkdir new; {make} new/{name}")).assert_ok();
            let outcome = sandbox.shell(&format!("timeout 60 \"$ORGANZA\" {TINY} new --steps 2"));
            outcome.assert_refused(&["new", name]);
        }
    }
    for make in ["mkfifo", "ln -s ..", "touch"] {
        sandbox.shell(&format!("rm -r new; mkdir new; {make} new/pictures")).assert_ok();
        let outcome = sandbox.shell(&format!("timeout 60 \"$ORGANZA\" {TINY} new --steps 2"));
        outcome.assert_refused(&["new", "pictures", "expected a folder"]);
    }
    for name in ["metrics.jsonl", "config.toml", "checkpoint.safetensors"] {
        sandbox.shell(&format!("cp -r run old; rm old/{name}; mkfifo old/{name}")).assert_ok();
        let resume = RESUME.replace(" run", " old");
        sandbox.shell(&format!("timeout 60 \"$ORGANZA\" {resume}")).assert_refused(&[name]);
        fs::remove_dir_all(sandbox.path("old")).unwrap();
    }
    assert_eq!(sandbox.text("precious"), "precious");
}
