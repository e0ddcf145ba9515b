//! Runs that continue with more steps or more Gaussians.
#![cfg(target_os = "linux")]

use organza::train::metrics::Record;
use organza::train::{Binding, CHECKPOINT, Change, Progress, TrainConfig};

use super::processes::{self, start};
use super::runs::{TINY, assert_same, bits, records, sandbox, without_times};
use crate::sandbox::{Sandbox, wait_until};

const MORE: &str = "--steps 40 --max-gaussians 450 --backend cpu";

fn changes(sandbox: &Sandbox, run: &str) -> Vec<Change> {
    let of_record = |record| match record {
        Record::Change(change) => Some(change),
        _ => None,
    };
    records(&sandbox.path(run)).into_iter().filter_map(of_record).collect()
}

fn change(step: u64, name: &str, from: u64, to: u64) -> Change {
    Change { step, name: name.to_owned(), from: from.into(), to: to.into() }
}

#[test]
fn a_killed_extension_ends_with_the_same_bits() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 20")).assert_ok();
    sandbox.shell("cp -r run killed").assert_ok();
    let before = without_times(&records(&sandbox.path("run")));
    sandbox
        .run(&format!("train --resume run {MORE}"))
        .assert_ok()
        .says(&["run.steps is 40 from here on; it was 20"]);

    let expected =
        [change(20, "densification.max_gaussians", 400, 450), change(20, "run.steps", 20, 40)];
    let mut found = changes(&sandbox, "run");
    found.sort_by(|a, b| a.name.cmp(&b.name));
    assert_eq!(found, expected);
    let binding = Binding::load(sandbox.path("run").join(CHECKPOINT)).expect("bound");
    assert_eq!(binding.changes().len(), 2);
    let config = TrainConfig::load(sandbox.path("run/config.toml")).expect("settings");
    assert_eq!((config.run.steps, config.densification.max_gaussians), (40, 450));
    let told = without_times(&records(&sandbox.path("run")));
    assert_eq!(told[..before.len()], before, "what was measured stays");
    // 0.8 of 40 steps: there is still densification
    let is_late = |record: &Record| matches!(record, Record::Densification { step: 30, .. });
    assert!(records(&sandbox.path("run")).iter().any(is_late));

    // killed before its first checkpoint, and between two
    let killed = sandbox.path("killed");
    let checkpoint = killed.join(CHECKPOINT);
    let logged = || processes::steps(&killed);
    let saved = || Progress::load(&checkpoint).expect("a checkpoint").step as usize;
    let reached: [(u32, &dyn Fn() -> usize); 2] = [(1000, &logged), (1, &saved)];
    for (checkpoint_every, steps) in reached {
        let words = format!("train --resume killed {MORE} --checkpoint-every {checkpoint_every}");
        let mut child = start(&sandbox, &words);
        wait_until("24 steps", || steps() >= 24 || child.try_wait().unwrap().is_some());
        child.kill().unwrap();
        child.wait().unwrap();
    }
    // new settings are written, so that they need not be repeated
    sandbox.run("train --resume killed --backend cpu").assert_ok();
    assert_same("killed", &bits(&sandbox, "killed"), &bits(&sandbox, "run"));
    let numbers = |run: &str| {
        let told = without_times(&records(&sandbox.path(run)));
        told.into_iter().filter(|line| !line.starts_with("Change")).collect::<Vec<_>>()
    };
    assert_eq!(numbers("killed"), numbers("run"));
    let steps: Vec<_> = changes(&sandbox, "killed")
        .into_iter()
        .filter(|change| change.name == "run.steps")
        .collect();
    assert_eq!(steps, [change(20, "run.steps", 20, 40)]);
}

#[test]
fn bad_extensions_are_refused() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 13")).assert_ok();
    for (words, facts) in [
        ("--steps 10", ["`run.steps` is 10", "already done 13 steps"]),
        ("--max-gaussians 201", ["`densification.max_gaussians` is 201", "the scene already has"]),
        ("--set run.seed=3", ["`run.seed` is 3", "only run.steps"]),
        ("--set run.stesp=50", ["no setting `run.stesp`", "did you mean `run.steps`?"]),
        ("--tile-size 8", ["`run.tile_size` is 8", "only run.steps"]),
    ] {
        sandbox.assert_refuses(&format!("train --resume run {words} --backend cpu"), &facts);
    }
    sandbox
        .run("train --resume run --backend cpu")
        .assert_ok()
        .says(&["all 13 steps are done; `--steps N` extends"]);
    // an edited file has the same effect
    sandbox.edit_text("run/config.toml", |config| config.replacen("steps = 13", "steps = 15", 1));
    sandbox.run("train --resume run --backend cpu").assert_ok();
    assert_eq!(changes(&sandbox, "run"), [change(13, "run.steps", 13, 15)]);
}
