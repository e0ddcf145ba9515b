//! `organza bench`.

use organza_tests::devices;
use serde_json::Value;

use crate::sandbox::{Outcome, Sandbox};

const BENCH: &str = "bench scene.safetensors cameras.json tiles.json --repeat 2";

fn json(outcome: Outcome) -> Value {
    serde_json::from_str(&outcome.assert_ok().stdout).expect("JSON")
}

/// Dispatches of a kernel; none where it is not listed.
fn dispatches(kernels: &Value, name: &str) -> Option<u64> {
    let kernels = kernels.as_array().expect("a list");
    kernels.iter().find(|kernel| kernel["name"] == name)?["dispatches"].as_u64()
}

/// Kernels are listed with positive times, the slowest first, and shares that add up to 1.
#[track_caller]
fn assert_shares(kernels: &Value) {
    let values = |key: &str| -> Vec<f64> {
        kernels.as_array().unwrap().iter().map(|kernel| kernel[key].as_f64().unwrap()).collect()
    };
    let (seconds, shares) = (values("seconds"), values("share"));
    assert!(seconds.iter().all(|&seconds| seconds > 0.0), "{kernels}");
    assert!(seconds.is_sorted_by(|a, b| a >= b), "{kernels}");
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{kernels}");
    let all: f64 = seconds.iter().sum();
    assert!((shares[0] - seconds[0] / all).abs() < 1e-9, "{kernels}");
}

#[test]
fn a_batch_is_measured() {
    let sandbox = Sandbox::new("crowded");
    let found = json(sandbox.run(&format!("{BENCH} --backend cpu --json")));
    let keys: Vec<_> = found.as_object().unwrap().keys().map(String::as_str).collect();
    let expected = "device forward_backward_s forward_kernels forward_peak_memory_bytes forward_s \
        gaussians kernels members pairs parts peak_memory_bytes repeat samples side tiles";
    assert_eq!(keys, expected.split_whitespace().collect::<Vec<_>>());
    assert_eq!(found["repeat"], 2);
    for key in ["forward_s", "forward_backward_s"] {
        assert!(found[key].as_f64().is_some_and(|seconds| seconds > 0.0), "{key}: {found}");
    }
    let forward = found["forward_kernels"].clone();
    assert_shares(&forward);
    assert_shares(&found["kernels"]);
    for (name, expected) in
        [("project", Some(1)), ("composite", Some(1)), ("project_backward", None)]
    {
        assert_eq!(dispatches(&forward, name), expected, "{name}");
    }
    for (name, expected) in [("project", 1), ("composite", 1), ("project_backward", 1)] {
        assert_eq!(dispatches(&found["kernels"], name), Some(expected), "{name}");
    }
}

/// What was rendered is what `organza tiles` says that it renders.
#[test]
fn what_is_measured_is_the_batch() {
    let sandbox = Sandbox::new("crowded");
    let words = "tiles scene.safetensors cameras.json tiles.json -o out --backend cpu";
    let said = sandbox.run(words).assert_ok().stderr.replace(',', "");
    let found = json(sandbox.run(&format!("{BENCH} --forward --backend cpu --json")));
    for (key, thing) in
        [("tiles", "tiles of"), ("pairs", "pairs"), ("members", "members"), ("samples", "samples")]
    {
        let number = found[key].as_u64().unwrap();
        assert!(number > 1 && said.contains(&format!(" {number} {thing}")), "{key}: {said}");
    }
}

#[test]
fn forward_alone() {
    let sandbox = Sandbox::new("tiny");
    let found = json(sandbox.run(&format!("{BENCH} --forward --backend cpu --json")));
    assert_eq!(found["forward_backward_s"], Value::Null);
    assert_eq!(found["kernels"], found["forward_kernels"]);
    assert_eq!(dispatches(&found["kernels"], "project_backward"), None);
}

#[test]
fn tables_are_for_people() {
    let outcome = Sandbox::new("tiny").run(&format!("{BENCH} --backend cpu")).assert_ok();
    let lines: Vec<_> = outcome.stdout.lines().collect();
    assert!(lines[0].starts_with("cpu: "), "{outcome:?}");
    for start in ["forward and backward  0.", "composite_backward  ", "forward  "] {
        assert!(lines.iter().any(|line| line.starts_with(start)), "{start}: {outcome:?}");
    }
}

/// A GPU's kernels have times as well, and those of the last case: it is the same batch.
#[test]
fn kernels_of_a_gpu_have_times() {
    if devices::all().len() == 1 {
        return;
    }
    let sandbox = Sandbox::new("tiny");
    let gpu = json(sandbox.run(&format!("{BENCH} --backend gpu --json")));
    let cpu = json(sandbox.run(&format!("{BENCH} --backend cpu --json")));
    assert!(gpu["device"].as_str().unwrap().starts_with("gpu: "), "{gpu}");
    assert_shares(&gpu["forward_kernels"]);
    assert_shares(&gpu["kernels"]);
    for kernel in cpu["kernels"].as_array().unwrap() {
        let name = kernel["name"].as_str().unwrap();
        assert!(dispatches(&gpu["kernels"], name).is_some(), "{name}: {gpu}");
    }
}

#[test]
fn bad_requests() {
    let sandbox = Sandbox::new("tiny");
    let bench = "bench scene.safetensors cameras.json";
    for (words, facts) in [
        (format!("{bench} tiles.json --repeat 0"), ["--repeat", "'0'"]),
        (format!("{bench} absent"), ["absent", "no such file"]),
        (format!("{bench} tiles.json --backend cpu --adapter Arc"), ["--adapter", "cpu"]),
        (bench.to_owned(), ["required", "arguments"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
    sandbox.edit_json("tiles.json", "/tiles/0/camera", 9.into());
    sandbox.assert_refuses(&format!("{bench} tiles.json"), &["tile 0", "tiles.json"]);
}
