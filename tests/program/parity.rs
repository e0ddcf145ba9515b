//! `organza parity`.

use organza_tests::devices;

use crate::sandbox::Sandbox;

#[test]
fn the_cpu_agrees_with_itself_to_the_bit() {
    let reports = Sandbox::new("tiny").run("parity --backend cpu --json").json();
    crate::flags::assert_documented("parity", std::slice::from_ref(&reports));
    let kernels = reports[0]["kernels"].as_array().expect("rows");
    assert_eq!(kernels.len(), muslin::kernels().count());
    for kernel in kernels {
        assert_eq!(kernel["ok"], true, "{kernel}");
        assert_eq!(kernel["share"]["value"], 0.0, "{kernel}");
        assert!(kernel["values"].as_u64().is_some_and(|values| values > 0), "{kernel}");
    }
}

#[test]
fn every_gpu_has_a_table() {
    if !devices::has_gpu() {
        return;
    }
    let outcome = Sandbox::new("tiny").run("parity").assert_ok();
    for point in muslin::kernels().flat_map(|kernel| kernel.entry_points()) {
        let is_row = |line: &&str| line.split(' ').next() == Some(point.name);
        let rows: Vec<_> = outcome.stdout.lines().filter(is_row).collect();
        assert!(!rows.is_empty() && rows.iter().all(|row| row.ends_with("ok")), "{rows:?}");
    }
}

#[test]
fn missing_gpus_are_refused() {
    let sandbox = Sandbox::new("tiny");
    sandbox.assert_refuses("parity --adapter no-such-gpu", &["no usable GPU"]);
    sandbox.assert_refuses("parity --backend cpu --adapter Arc", &["`--backend` is cpu"]);
}
