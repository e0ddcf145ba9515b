//! `organza bench`.

use serde_json::Value;

use crate::sandbox::Sandbox;

const BENCH: &str = "bench scene.safetensors cameras.json tiles.json --repeat 2";

/// The number of a kernel's dispatches; `None` if it is not listed.
fn dispatches(kernels: &Value, name: &str) -> Option<u64> {
    let kernels = kernels.as_array().expect("a list");
    kernels.iter().find(|kernel| kernel["name"] == name)?["dispatches"].as_u64()
}

/// Asserts that times are positive and sorted, the slowest first, and that shares add up to 1.
#[track_caller]
fn assert_shards(kernels: &Value) {
    let values = |key: &str| -> Vec<f64> {
        kernels.as_array().unwrap().iter().map(|kernel| kernel[key].as_f64().unwrap()).collect()
    };
    let seconds = values("seconds");
    let shares = values("share");
    assert!(seconds.iter().all(|&seconds| seconds > 0.0), "{kernels}");
    assert!(seconds.is_sorted_by(|a, b| a >= b), "{kernels}");
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{kernels}");
    let all: f64 = seconds.iter().sum();
    assert!((shares[0] - seconds[0] / all).abs() < 1e-9, "{kernels}");
}

#[test]
fn a_batch_is_measured() {
    let sandbox = Sandbox::new("crowded");
    let found = sandbox.run(&format!("{BENCH} --backend cpu --json")).json();
    assert_eq!(found["repeat"], 2);
    for key in ["forward_s", "forward_backward_s"] {
        assert!(found[key].as_f64().is_some_and(|seconds| seconds > 0.0), "{key}: {found}");
    }
    let forward = found["forward_kernels"].clone();
    assert_shards(&forward);
    assert_shards(&found["kernels"]);
    for (name, expected) in
        [("project", Some(1)), ("composite", Some(1)), ("project_backward", None)]
    {
        assert_eq!(dispatches(&forward, name), expected, "{name}");
    }
    for (name, expected) in [("project", 1), ("composite", 1), ("project_backward", 1)] {
        assert_eq!(dispatches(&found["kernels"], name), Some(expected), "{name}");
    }
    // the counts equal `organza tiles`'s
    let words = "tiles scene.safetensors cameras.json tiles.json -o out --backend cpu --verbose";
    let said = sandbox.run(words).assert_ok().stderr.replace(',', "");
    for (key, thing) in [
        ("tiles", "tiles of"),
        ("pairs", "pairs"),
        ("members", "intersections"),
        ("samples", "samples"),
    ] {
        let number = found[key].as_u64().unwrap();
        assert!(number > 1 && said.contains(&format!(" {number} {thing}")), "{key}: {said}");
    }
}

#[test]
fn forward_alone() {
    let sandbox = Sandbox::new("tiny");
    let found = sandbox.run(&format!("{BENCH} --forward --backend cpu --json")).json();
    assert_eq!(found["forward_backward_s"], Value::Null);
    assert_eq!(found["kernels"], found["forward_kernels"]);
    assert_eq!(dispatches(&found["kernels"], "project_backward"), None);
    // an image has no gradients
    let frame = "bench scene.safetensors --frame --size 100x50 --half-grids --repeat 1 --backend cpu --json";
    let found = sandbox.run(frame).json();
    assert_eq!((&found["tiles"], &found["side"]), (&2.into(), &64.into()));
    assert_eq!(found["forward_backward_s"], Value::Null);
}

#[test]
fn without_files_the_workload_is_the_built_in_scene() {
    let sandbox = Sandbox::new("tiny");
    let found = sandbox.run("bench --forward --repeat 1 --backend cpu --json").json();
    let gaussians = organza::demo::scene().gaussians.len();
    for (key, expected) in [("gaussians", gaussians), ("tiles", 8), ("side", 64)] {
        assert_eq!(found[key], expected, "{key}");
    }
}

#[test]
fn every_device_is_measured() {
    let sandbox = Sandbox::new("tiny");
    let mut devices = vec!["--backend cpu".to_owned()];
    let gpus = muslin_device::adapters().into_iter();
    // a name may have spaces
    devices.extend(gpus.map(|gpu| format!("--adapter {}", gpu.name.split(' ').next().unwrap())));
    let measured = |device| sandbox.run(&format!("{BENCH} {device} --json")).json();
    let all: Vec<Value> = devices.iter().map(measured).collect();
    for (one, device) in all.iter().zip(&devices) {
        let backend = if device.contains("cpu") { "cpu: " } else { "gpu: " };
        assert!(one["device"].as_str().unwrap().starts_with(backend), "{one}");
        assert_shards(&one["forward_kernels"]);
        assert_shards(&one["kernels"]);
        for kernel in all[0]["kernels"].as_array().unwrap() {
            let name = kernel["name"].as_str().unwrap();
            assert!(dispatches(&one["kernels"], name).is_some(), "{name}: {one}");
        }
        assert_eq!(one["samples"], all[0]["samples"]);
    }
}

#[test]
fn tables_are_for_people() {
    let text = Sandbox::new("tiny").run(&format!("{BENCH} --backend cpu")).assert_ok().stdout;
    let lines: Vec<_> = text.lines().collect();
    assert!(lines[0].starts_with("cpu: "), "{text}");
    for start in ["forward and backward  ", "composite_backward  ", "forward  "] {
        let numbers: Vec<_> = lines.iter().filter_map(|line| line.strip_prefix(start)).collect();
        let [number] = numbers[..] else { panic!("{start}: {text}") };
        assert!(number.trim_start().starts_with(|first: char| first.is_ascii_digit()), "{text}");
    }
}

#[test]
fn bad_requests() {
    let sandbox = Sandbox::new("tiny");
    let bench = "bench scene.safetensors cameras.json";
    for (words, facts) in [
        (format!("{bench} tiles.json --repeat 0"), ["--repeat", "'0'"]),
        (bench.to_owned(), ["required", "arguments"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
    sandbox.edit_json("tiles.json", "/tiles/0/camera", 9.into());
    sandbox.assert_refuses(&format!("{bench} tiles.json"), &["tile 0", "tiles.json"]);
}
