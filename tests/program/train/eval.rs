//! `organza eval RUN`: the run knows its own data. Intermediate evaluations with some of the held-out views.

use organza::evaluate::ViewScore;
use organza::train::{BEST, Checkpoint};
use serde_json::Value;

use super::runs::{BUILT_IN, TINY, assert_same, bits, evaluations, photographs, sandbox, stopped};
use crate::sandbox::Sandbox;

/// The names of the views and the mean PSNR that `organza eval` prints.
fn eval(sandbox: &Sandbox, words: &str) -> (Vec<String>, f64) {
    let found = sandbox.run(&format!("eval {words} --backend cpu --json")).json();
    let views = found["views"].as_array().expect("views").iter();
    let name = |view: &Value| view["name"].as_str().expect("a name").to_owned();
    (views.map(name).collect(), found["mean"]["psnr"].as_f64().expect("a number"))
}

/// The run's own evaluation after its last step.
fn measured(sandbox: &Sandbox, run: &str) -> (Vec<String>, f64) {
    let (_, psnr, views) = evaluations(sandbox, run).pop().expect("an evaluation");
    (views.into_iter().map(|view| view.name).collect(), psnr)
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
    let words = "train data --config tiny.toml --backend cpu --steps 5 --hold-out-every 2 -o run";
    sandbox.run(&format!("{words} --background 1,0.5,0.25 --downscale 2")).assert_ok();
    let expected = measured(&sandbox, "run");
    assert_eq!(expected.0, ["images/0000.png"]);
    let own = eval(&sandbox, "run");
    assert_like(own.clone(), expected.clone());
    assert_like(eval(&sandbox, "run data"), expected);
    assert!(eval(&sandbox, "run --background 0,0,0").1 != own.1);
    assert!(eval(&sandbox, "run --downscale 4").1 != own.1);
}

/// The last evaluation measures all views. The best checkpoint is chosen by the view that every evaluation measures.
#[test]
fn some_views_are_measured_before_the_end() {
    let sandbox = sandbox();
    let settings = "--steps 14 --evaluate-every 5 --set run.evaluate_views=1";
    sandbox.run(&format!("{TINY} run {settings}")).assert_ok();
    let found = evaluations(&sandbox, "run");
    let places: Vec<_> = found.iter().map(|(step, _, views)| (*step, views.len())).collect();
    assert_eq!(places, [(5, 1), (10, 1), (14, 2)]);
    let best = |sandbox: &Sandbox, run: &str| {
        Checkpoint::load(sandbox.path(run).join(BEST)).expect("a checkpoint").progress.step
    };
    let first = |views: &[ViewScore]| views[0].score.psnr.expect("a score");
    let best_of_all = found.iter().max_by(|a, b| first(&a.2).total_cmp(&first(&b.2)));
    let expected = best_of_all.expect("three").0;
    assert_eq!(u64::from(best(&sandbox, "run")), expected);

    // stopped once
    stopped(&sandbox, "cut", "run", 11);
    sandbox.run("train --resume cut --backend cpu").assert_ok();
    assert_same("resumed", &bits(&sandbox, "cut"), &bits(&sandbox, "run"));
    assert_eq!(u64::from(best(&sandbox, "cut")), expected);
}
