//! Runs that end before their last step, and then continue to the same result.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::Child;

use organza::Renderer;
use organza::train::{
    self, BEST, CHECKPOINT, CONFIG, Checkpoint, EVALUATIONS, METRICS, PICTURES, Progress, REPORT,
    RunFolder, Session, TrainConfig,
};
use organza_tests::devices;

use super::processes::{end, signal, start, steps};
use super::runs::{TINY, assert_same, assert_same_run, bits, dataset, evaluations, sandbox};
use crate::sandbox::{Sandbox, wait_until};

/// Waits until a run has done `count` steps, or has ended.
fn wait_for_steps(child: &mut Child, folder: &Path, count: usize) {
    wait_until("steps", || steps(folder) >= count || child.try_wait().unwrap().is_some());
}

/// Asserts that `run` has the same result and the same log as `whole`.
#[track_caller]
fn assert_like_whole(sandbox: &Sandbox, run: &str) {
    assert_same_run(sandbox, run, "whole");
    let [pictures, expected] =
        [run, "whole"].map(|run| sandbox.contents(&format!("{run}/{PICTURES}")));
    assert!(expected.contains_key("over-time-000000.jpg"), "{:?}", expected.keys());
    assert_eq!(pictures.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
    assert!(pictures == expected, "{run}: the pictures differ");
}

#[test]
fn a_run_that_is_told_to_stop_goes_on_to_the_same_bits() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} whole")).assert_ok();
    let folder = sandbox.path("run");
    let resume = "train --resume run --backend cpu";
    // before the first change of the Gaussians, and between the second and the third
    let stops = [(format!("{TINY} run"), "TERM", 3), (resume.to_owned(), "INT", 23)];
    // On a busy machine, a signal can come after the last step.
    let is_stopped = (0..20).any(|_| {
        let _ = fs::remove_dir_all(&folder);
        stops.iter().all(|(words, name, after)| {
            let mut child = start(&sandbox, words);
            wait_for_steps(&mut child, &folder, *after);
            signal(&child, name);
            let outcome = end(child).assert_ok();
            let step = Progress::load(folder.join(CHECKPOINT)).expect("a checkpoint").step as usize;
            assert!(step >= *after && steps(&folder) == step && folder.join(REPORT).exists());
            let is_saved = outcome.stderr.contains("saved; `organza train --resume run`");
            assert!(is_saved || step == 40, "{outcome:?}");
            step < 40
        })
    });
    assert!(is_stopped, "every run had ended before the signal");
    sandbox.run(resume).assert_ok().says(&["continuing after step"]);
    assert_like_whole(&sandbox, "run");
}

#[test]
fn a_run_ends_at_its_time_limit() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 1000000 --time-limit 1")).assert_ok();
    let stopped = Checkpoint::load(sandbox.path("run").join(CHECKPOINT)).unwrap().progress;
    assert!(stopped.seconds >= 1.0 && stopped.step < 1_000_000, "{stopped:?}");
    let last = u64::from(stopped.step);
    let mut steps = evaluations(&sandbox, "run").into_iter().map(|(step, ..)| step);
    assert!(steps.any(|step| step == last), "the end is measured");
}

#[test]
fn a_run_at_its_time_limit_goes_on_to_the_same_bits() {
    let sandbox = sandbox();
    let config = TrainConfig::load(sandbox.path("tiny.toml")).unwrap();
    let renderer = Renderer::new(devices::cpu(None));
    let dataset = dataset(&sandbox, &config);
    let train = |name: &str, resume: bool, time_limit: Option<f64>| {
        let folder = sandbox.path(name);
        fs::create_dir_all(&folder).unwrap();
        let folder = RunFolder::lock(&folder, resume).expect("it is free");
        let mut session = Session::new(&renderer, &config, &dataset, &folder);
        session.time_limit = time_limit;
        session.run(resume, &mut |_| Ok(())).expect("it trains")
    };
    assert_eq!(train("whole", false, None), train::Outcome::Finished);
    // no step takes so little time
    assert_eq!(train("run", false, Some(1e-6)), train::Outcome::TimeLimit);
    for limits in 1.. {
        let progress = Checkpoint::load(sandbox.path("run").join(CHECKPOINT)).unwrap().progress;
        assert!(progress.step >= limits, "{progress:?} after {limits} limits");
        match train("run", true, Some(progress.seconds + 1e-6)) {
            train::Outcome::TimeLimit => {}
            outcome => {
                assert_eq!((outcome, progress.step), (train::Outcome::Finished, 39));
                break;
            }
        }
    }
    assert_same("run", &bits(&sandbox, "run"), &bits(&sandbox, "whole"));
    assert_eq!(steps(&sandbox.path("run")), 40);
}

/// A schedule made after the checkpoint must not prevent a resume from it.
#[test]
fn a_killed_run_by_minutes_keeps_its_plan() {
    let sandbox = sandbox();
    let folder = sandbox.path("run");
    // On a busy machine a short run can end before it is seen to be there.
    let is_killed = ["0.015", "0.06", "0.24", "0.96"].into_iter().any(|minutes| {
        let _ = fs::remove_dir_all(&folder);
        let mut child = start(&sandbox, &format!("{TINY} run --minutes {minutes}"));
        wait_for_steps(&mut child, &folder, 30);
        let is_running = child.try_wait().unwrap().is_none();
        let _ = child.kill();
        child.wait().unwrap();
        is_running
    });
    assert!(is_killed, "every run had ended");
    let planned = TrainConfig::load(folder.join(CONFIG)).expect("settings");
    sandbox.run("train --resume run --backend cpu").assert_ok();
    assert_eq!(TrainConfig::load(folder.join(CONFIG)).expect("settings"), planned);
    assert_eq!(Checkpoint::load(folder.join(CHECKPOINT)).unwrap().progress.step, planned.run.steps);
    sandbox.run("train --config run/config.toml --backend cpu -o whole").assert_ok();
    assert_like_whole(&sandbox, "run");
}

#[test]
fn a_run_that_is_done_stays_as_it_is() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 12")).assert_ok();
    let read = |name: &str| sandbox.read(&format!("run/{name}"));
    let names = [BEST, CHECKPOINT, CONFIG, EVALUATIONS, METRICS, REPORT];
    let before = names.map(read);
    sandbox.run("train --resume run --backend cpu").assert_ok();
    for (name, before) in names.into_iter().zip(before) {
        assert!(read(name) == before, "{name} has changed");
    }
}
