//! The messages of a training without a terminal.

use super::runs::{TINY, sandbox};

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
    let end = position("finished: 40 steps in 00:00:");
    assert!(first < early && early < last && last < end, "{lines:#?}");
    assert!(lines[end].contains("of training, ") && lines[end].ends_with(" Gaussians"));
    // not one line per step
    assert!(lines.len() < 20, "{lines:#?}");
    let outcome = sandbox.run(&format!("{TINY} quiet --quiet")).assert_ok();
    assert_eq!(outcome.stderr, "");
    // a plan may change
    let outcome = sandbox.run(&format!("{TINY} planned --minutes 0.01")).assert_ok();
    assert!(outcome.stderr.contains("step 1 of about "), "{outcome:?}");
    assert!(outcome.stderr.ends_with("next: organza view planned\n"), "{outcome:?}");
}

/// Later lines are due after some seconds. They give the speed and the remaining time.
#[test]
fn a_longer_training_says_how_long_it_takes() {
    let sandbox = sandbox();
    let words = format!("{TINY} run --steps 1000000 --evaluate-every 0 --time-limit 3 --threads 1");
    let outcome = sandbox.run(&words).assert_ok();
    let second = outcome.stderr.lines().filter(|line| line.contains(" of 1,000,000: loss ")).nth(1);
    let second = second.unwrap_or_else(|| panic!("{outcome:?}"));
    let (_, rest) = second.split_once(" Gaussians, ").expect("a count");
    let (speed, rest) = rest.split_once(" steps/s, ").expect("a speed");
    assert!(speed.parse::<f64>().is_ok_and(|speed| speed > 0.0), "{second}");
    // up to the time limit, not for a million steps
    let left = rest.strip_suffix("s left").expect("a time");
    assert!(left.parse::<u32>().is_ok_and(|left| left <= 2), "{second}");
    assert!(outcome.stderr.contains("finished at the time limit: "), "{outcome:?}");
}
