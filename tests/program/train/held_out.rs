//! Intermediate evaluations with some of the held-out views.

use organza::train::metrics::Record;
use organza::train::{BEST, Checkpoint};

use super::runs::{TINY, assert_same, bits, records, sandbox, stopped};
use crate::sandbox::Sandbox;

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
