//! The success of training, its messages and warnings, and the run's report and table of scores.

use std::fs;
use std::path::Path;

use organza::Scene;
use organza::train::EVALUATIONS;
use organza::train::metrics::Record;

use super::runs::{TINY, evaluations, photographs, records, sandbox};
use crate::sandbox::Outcome;

#[test]
fn held_out_views_come_closer() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 150 --evaluate-every 5")).assert_ok();
    let evaluations = evaluations(&sandbox, "run");
    assert_eq!(evaluations.len(), 30);
    let [first, .., last] = evaluations.as_slice() else { unreachable!("30 are more than 2") };
    assert_eq!([first.0, last.0], [5, 150]);
    // measured: 9.6 and 13.6 dB
    assert!(last.1 > first.1 + 2.5, "{first:?} {last:?}");
}

/// With a box around the part in focus, and all of space around it.
#[test]
fn a_contracted_scene_learns_and_info_names_the_contraction() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --set scene.contraction=cube")).assert_ok();
    let found = evaluations(&sandbox, "run");
    // measured: 11.6 and 12.4 dB
    assert!(found.len() == 2 && found[1].1 > found[0].1 + 0.5, "{found:?}");
    let info = sandbox.run("info run").assert_ok().stdout;
    assert!(info.contains("outside the box        contracted to the unit cube"), "{info}");
    let facts = ["scene.contraction", "sphere", "`none` or `cube`"];
    sandbox.assert_refuses(&format!("{TINY} other --set scene.contraction=sphere"), &facts);
}

/// The page's module has tests of its content.
#[test]
fn the_report_shows_the_run() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let page = sandbox.text("run/report.html");
    for text in [
        "<code>organza train views --config tiny.toml --backend cpu -o run --steps 5</code>",
        "<small>of 5</small>",
        "Photograph of view-000",
        "Error of view-003",
        "view-000 after 0 steps",
        "view-000 after 5 steps",
        "<td>start.gaussians</td><td>200</td>",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn runs_are_compared() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} a --steps 3")).assert_ok();
    sandbox.run(&format!("{TINY} b --steps 3 --seed 1")).assert_ok();
    let outcome = sandbox.run("compare a b").assert_ok();
    assert!(outcome.stdout.ends_with("run.seed\n  a: 0\n  b: 1\n"), "{outcome:?}");
    let json = sandbox.run("compare a b --json").json();
    crate::flags::assert_documented("compare", std::slice::from_ref(&json));
    let settings = serde_json::json!([{ "name": "run.seed", "values": ["0", "1"] }]);
    assert_eq!(json["settings"], settings);
    for (at, run) in ["a", "b"].into_iter().enumerate() {
        let logged = &evaluations(&sandbox, run)[0];
        assert_eq!(json["runs"][at]["run"], run);
        assert_eq!(json["runs"][at]["psnr"].as_f64(), Some(logged.1));
    }
    sandbox.assert_refuses("compare a", &["2 values", "RUN"]);
    sandbox.assert_refuses("compare a ./a/", &["./a/", "named twice"]);
    sandbox
        .assert_refuses("compare a a/checkpoint.safetensors", &["is a file", "by their folders"]);
    sandbox.assert_refuses("compare a nowhere", &["nowhere", "config.toml"]);
}

/// A single photograph, smaller than a tile: nothing is held out, and the tile's other pixels are empty.
#[test]
fn one_small_photograph_is_enough() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let frame = sandbox.read_json("data/transforms.json")["frames"][0].clone();
    sandbox.edit_json("data/transforms.json", "/frames", serde_json::json!([frame]));
    let words = "train data --config tiny.toml --backend cpu --steps 5 -o run";
    // 96 x 80 pixels become 48 x 40
    sandbox.run(&format!("{words} --hold-out-every 0 --downscale 2 --tile-size 64")).assert_ok();
    let losses: Vec<_> = records(&sandbox.path("run"))
        .into_iter()
        .filter_map(|record| match record {
            Record::Step { loss, psnr, .. } => Some((loss, psnr)),
            Record::Evaluation { .. } => panic!("nothing is held out"),
            _ => None,
        })
        .collect();
    assert_eq!(losses.len(), 5);
    assert!(losses.iter().all(|(loss, psnr)| loss.is_finite() && psnr.is_finite()), "{losses:?}");
    let outcome = sandbox.run("eval run --backend cpu");
    outcome.assert_refused(&["no frame", "held out", "--split train"]);
}

/// The rows of a table without quoted cells.
fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn scores_of_a_run_are_a_table() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 12 --evaluate-every 5")).assert_ok();
    let mut expected = vec![["step", "view", "psnr", "ssim"].map(str::to_owned).to_vec()];
    for (step, _, views) in evaluations(&sandbox, "run") {
        expected.extend(views.iter().map(|view| {
            let [psnr, ssim] = [view.score.psnr, view.score.ssim].map(|score| score.unwrap());
            vec![step.to_string(), view.name.clone(), psnr.to_string(), ssim.to_string()]
        }));
    }
    assert!(expected.len() >= 4, "evaluations after 5, 10 and 12 steps: {expected:?}");
    assert_eq!(rows(&sandbox.path("run").join(EVALUATIONS)), expected);
}

#[test]
fn a_log_file_has_steps_evaluations_and_the_end() {
    let sandbox = sandbox();
    let outcome = sandbox.run(&format!("{TINY} run")).assert_ok();
    let lines: Vec<_> = outcome.stderr.lines().collect();
    let position = |part: &str| {
        let found = lines.iter().position(|line| line.contains(part));
        found.unwrap_or_else(|| panic!("no {part:?} in {lines:#?}"))
    };
    let first = position("step 1 of 40: loss ");
    assert!(lines[first].contains("PSNR ") && lines[first].contains(" dB, 200 Gaussians"));
    let [early, last] =
        [20, 40].map(|step| position(&format!("step {step}: 2 held-out views: PSNR ")));
    let end = position("finished: 40 steps in 00:");
    assert!(first < early && early < last && last < end, "{lines:#?}");
    assert!(lines[end].contains("of training, ") && lines[end].ends_with(" Gaussians"));
    // not one line per step
    assert!(lines.len() < 40, "{lines:#?}");
    let outcome = sandbox.run(&format!("{TINY} quiet --quiet")).assert_ok();
    assert_eq!(outcome.stderr, "");
    // a schedule may change
    let outcome = sandbox
        .run(&format!("{TINY} planned --minutes 0.01"))
        .assert_ok()
        .says(&["step 1 of about "]);
    assert!(outcome.stderr.ends_with("next: organza view planned\n"), "{outcome:?}");
}

/// Later lines are due after some seconds. They give the speed and the remaining time.
#[test]
fn a_longer_training_says_how_long_it_takes() {
    let sandbox = sandbox();
    let words = format!("{TINY} run --steps 1000000 --evaluate-every 0 --time-limit 6 --threads 1");
    let outcome = sandbox.run(&words).assert_ok();
    let second = outcome.stderr.lines().filter(|line| line.contains(" of 1,000,000: loss ")).nth(1);
    let second = second.unwrap_or_else(|| panic!("{outcome:?}"));
    let (_, rest) = second.split_once(" Gaussians, ").expect("a count");
    let (speed, rest) = rest.split_once(" steps/s, ").expect("a speed");
    assert!(speed.parse::<f64>().is_ok_and(|speed| speed > 0.0), "{second}");
    // up to the time limit, not for a million steps
    let left = rest.strip_suffix("s left").expect("a time");
    assert!(left.parse::<u32>().is_ok_and(|left| left <= 5), "{second}");
    assert!(outcome.stderr.contains("finished at the time limit: "), "{outcome:?}");
}

/// The warnings of a run.
fn warnings(outcome: &Outcome) -> Vec<&str> {
    outcome.stderr.lines().filter(|line| line.contains("warning:")).collect()
}

/// Nothing of a start may be seen at first, and what was seen is forgotten.
#[test]
fn first_steps_without_a_gaussian_warn() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 2 --set densification.end=0")).assert_ok();
    sandbox.edit_tensors("run/checkpoint.safetensors", |_, tensors| {
        let (_, positions) = tensors.get_mut("gaussians.position").unwrap();
        positions.as_chunks_mut().0.iter_mut().for_each(|x| *x = 500_f32.to_le_bytes());
        tensors.get_mut("train.statistics").unwrap().1.fill(0);
    });
    let outcome = sandbox.run("train --resume run --steps 20 --backend cpu").assert_ok();
    let [warning] = warnings(&outcome)[..] else { panic!("{outcome:?}") };
    let config = Scene::load_config(sandbox.path("run/checkpoint.safetensors")).unwrap();
    let world = config.placement.world([500.0; 3])[0].floor();
    let place = format!("they lie at {world}.");
    for fact in ["first 10 steps have shown no Gaussian", "0 of 200 Gaussians", &place] {
        assert!(warning.contains(fact), "{fact}: {warning}");
    }
}

#[test]
fn a_run_whose_loss_does_not_move_says_so() {
    let sandbox = sandbox();
    let rates =
        ["position", "rotation", "log_scale", "opacity", "material", "extra", "slope", "shape"];
    let rates = rates.into_iter().chain(["grids", "networks"]);
    let still: String = rates.map(|name| format!(" --set optimizer.{name}=1e-12,1e-12")).collect();
    let long =
        format!("{TINY} run --steps 210 --set run.evaluate_every=0 --set densification.end=0");
    let outcome = sandbox.run(&format!("{long}{still}")).assert_ok();
    let [warning] = warnings(&outcome)[..] else { panic!("{outcome:?}") };
    assert!(warning.contains("the loss has not moved in 200 steps"), "{warning}");
    assert!(warning.contains("of 200 Gaussians are in the image"), "{warning}");
    let outcome = sandbox.run(&long.replace("run --steps", "moves --steps")).assert_ok();
    assert!(warnings(&outcome).is_empty(), "{outcome:?}");
}
