//! `organza eval RUN`: the run knows its own data. Intermediate evaluations with some of the held-out views.

use std::fs;

use organza::train::metrics::Record;
use organza::train::{BEST, Checkpoint};
use serde_json::Value;

use super::runs::{BUILT_IN, TINY, assert_same, bits, photographs, records, sandbox, stopped};
use crate::sandbox::Sandbox;

/// The names of the views and the mean PSNR that `organza eval` prints.
fn eval(sandbox: &Sandbox, words: &str) -> (Vec<String>, f64) {
    let outcome = sandbox.run(&format!("eval {words} --backend cpu --json")).assert_ok();
    let found: Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    let views = found["views"].as_array().expect("views").iter();
    let name = |view: &Value| view["name"].as_str().expect("a name").to_owned();
    (views.map(name).collect(), found["mean"]["psnr"].as_f64().expect("a number"))
}

/// The run's own evaluation after its last step.
fn measured(sandbox: &Sandbox, run: &str) -> (Vec<String>, f64) {
    let evaluation = |record| match record {
        Record::Evaluation { views, psnr, .. } => {
            let names = views.into_iter().map(|view| view.name).collect();
            Some((names, psnr.expect("a number")))
        }
        _ => None,
    };
    records(&sandbox.path(run))
        .into_iter()
        .filter_map(evaluation)
        .next_back()
        .expect("an evaluation")
}

#[track_caller]
fn assert_like(found: (Vec<String>, f64), expected: (Vec<String>, f64)) {
    assert_eq!(found.0, expected.0);
    assert!((found.1 - expected.1).abs() < 1e-9, "{found:?} {expected:?}");
}

#[test]
fn the_built_in_scene_is_measured_as_the_run_measured_it() {
    let sandbox = sandbox();
    sandbox.run(&format!("{BUILT_IN} run --set data.built_in_views=3")).assert_ok();
    let expected = measured(&sandbox, "run");
    assert_eq!(expected.0, ["view-000"]);
    assert_like(eval(&sandbox, "run"), expected);
    assert_eq!(eval(&sandbox, "run --split train").0.len(), 2);
    assert_eq!(eval(&sandbox, "run --split all").0.len(), 3);
    // options take precedence over the run's own settings
    assert_eq!(eval(&sandbox, "run --hold-out-every 2").0, ["view-000", "view-002"]);
}

#[test]
fn photographs_are_measured_as_the_run_measured_them() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let clear = image::RgbaImage::from_pixel(96, 80, image::Rgba([200, 10, 10, 100]));
    clear.save(sandbox.path("data/images/0000.png")).unwrap();
    let config = fs::read_to_string(sandbox.path("tiny.toml")).unwrap();
    let config = config.replace("[data]", "[data]\nbackground = [1.0, 0.5, 0.25]\ndownscale = 2");
    fs::write(sandbox.path("tiny.toml"), config).unwrap();
    let words = "train data --config tiny.toml --backend cpu --steps 5 --hold-out-every 2 -o run";
    sandbox.run(words).assert_ok();
    let expected = measured(&sandbox, "run");
    assert_eq!(expected.0, ["images/0000.png"]);
    let own = eval(&sandbox, "run");
    assert_like(own.clone(), expected.clone());
    assert_like(eval(&sandbox, "run data"), expected);
    assert!(eval(&sandbox, "run --background 0,0,0").1 != own.1);
    assert!(eval(&sandbox, "run --downscale 4").1 != own.1);
}

#[test]
fn a_scene_alone_does_not_tell() {
    let facts = ["scene.safetensors", "does not say what it was trained on", "eval SCENE DATA"];
    sandbox().assert_refuses("eval scene.safetensors --backend cpu", &facts);
}

/// Step, number of views, and the first view's PSNR, for each evaluation of a run.
fn evaluations(sandbox: &Sandbox, run: &str) -> Vec<(u64, usize, f64)> {
    let evaluation = |record| match record {
        Record::Evaluation { step, views, .. } => {
            let psnr = views[0].score.psnr.expect("a score");
            Some((step, views.len(), psnr))
        }
        _ => None,
    };
    records(&sandbox.path(run)).into_iter().filter_map(evaluation).collect()
}

/// The last evaluation measures all views. The best checkpoint is chosen by the view that every evaluation measures.
#[test]
fn some_views_are_measured_before_the_end() {
    let sandbox = sandbox();
    let settings = "--steps 14 --evaluate-every 5 --set run.evaluate_views=1";
    sandbox.run(&format!("{TINY} run {settings}")).assert_ok();
    let found = evaluations(&sandbox, "run");
    let places: Vec<_> = found.iter().map(|&(step, views, _)| (step, views)).collect();
    assert_eq!(places, [(5, 1), (10, 1), (14, 2)]);
    let best = |sandbox: &Sandbox, run: &str| {
        Checkpoint::load(sandbox.path(run).join(BEST)).expect("a checkpoint").progress.step
    };
    let expected = found.iter().max_by(|a, b| a.2.total_cmp(&b.2)).expect("three").0;
    assert_eq!(u64::from(best(&sandbox, "run")), expected);

    // stopped once
    stopped(&sandbox, "cut", "run", 11);
    sandbox.run("train --resume cut --backend cpu").assert_ok();
    assert_same("resumed", &bits(&sandbox, "cut"), &bits(&sandbox, "run"));
    assert_eq!(u64::from(best(&sandbox, "cut")), expected);
}
