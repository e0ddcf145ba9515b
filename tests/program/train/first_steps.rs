//! A run that shows nothing, or learns nothing, says so.

use organza::splats::{self, Format, Splat};

use super::runs::{TINY, sandbox};
use crate::sandbox::Outcome;

/// The warnings of a run.
fn warnings(outcome: &Outcome) -> Vec<&str> {
    outcome.stderr.lines().filter(|line| line.contains("warning:")).collect()
}

#[test]
fn first_steps_without_a_gaussian_warn() {
    let sandbox = sandbox();
    let far = |i: u8| Splat {
        position: [500.0 + f32::from(i), 0.0, 0.0],
        rotation: [1.0, 0.0, 0.0, 0.0],
        log_scale: [-3.0; 3],
        opacity: 0.0,
        color: Default::default(),
    };
    let splats: Vec<_> = (0..4).map(far).collect();
    splats::save(&splats, sandbox.path("far.ply"), Format::Ply, [0.0, 0.0, 1.0]).unwrap();
    let words = format!("{TINY} run --start far.ply --steps 20 --set growth.end=0");
    let outcome = sandbox.run(&words).assert_ok();
    let [warning] = warnings(&outcome)[..] else { panic!("{outcome:?}") };
    for fact in ["first 10 steps have shown no Gaussian", "0 of 4 Gaussians", "500.0", "503.0"] {
        assert!(warning.contains(fact), "{fact}: {warning}");
    }
}

#[test]
fn a_run_whose_loss_does_not_move_says_so() {
    let sandbox = sandbox();
    let rates = ["position", "rotation", "log_scale", "opacity", "material", "extra", "grids"];
    let rates = rates.into_iter().chain(["networks"]);
    let still: String = rates.map(|name| format!(" --set optimizer.{name}=1e-12,1e-12")).collect();
    let long = format!("{TINY} run --steps 210 --set run.evaluate_every=0 --set growth.end=0");
    let outcome = sandbox.run(&format!("{long}{still}")).assert_ok();
    let [warning] = warnings(&outcome)[..] else { panic!("{outcome:?}") };
    assert!(warning.contains("the loss has not moved in 200 steps"), "{warning}");
    assert!(warning.contains("of 200 Gaussians are in the image"), "{warning}");
    let outcome = sandbox.run(&long.replace("run --steps", "moves --steps")).assert_ok();
    assert!(warnings(&outcome).is_empty(), "{outcome:?}");
}
