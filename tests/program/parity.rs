//! `organza parity`.

use organza_tests::devices;

use crate::sandbox::Sandbox;

#[test]
fn every_gpu_has_a_table() {
    if !devices::has_gpu() {
        return;
    }
    let sandbox = Sandbox::new("tiny");
    let outcome = sandbox.run("parity").assert_ok();
    let reports = sandbox.run("parity --json").json();
    crate::flags::assert_documented("parity", std::slice::from_ref(&reports));
    for name in muslin::kernels().flat_map(|kernel| kernel.entry_points()).map(|point| point.name) {
        let is_row = |line: &&str| line.split(' ').next() == Some(name);
        let rows: Vec<_> = outcome.stdout.lines().filter(is_row).collect();
        assert!(!rows.is_empty() && rows.iter().all(|row| row.ends_with("ok")), "{rows:?}");
        let listed = reports.as_array().expect("a list").iter().flat_map(|report| {
            report["kernels"].as_array().expect("rows").iter().filter(|row| row["kernel"] == name)
        });
        assert!(listed.clone().count() > 0, "{name}");
        for row in listed {
            assert_eq!(row["ok"], true, "{row}");
            assert!(row["values"].as_u64().is_some_and(|values| values > 0), "{row}");
        }
    }
}

#[test]
fn missing_gpus_are_refused() {
    Sandbox::new("tiny").assert_refuses("parity --adapter no-such-gpu", &["no usable GPU"]);
}
