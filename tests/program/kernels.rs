//! `organza kernels` and `organza parity`: facts about the kernels.

use organza::MODULES;
use organza_tests::devices;

use crate::sandbox::Sandbox;

#[test]
fn every_kernel_is_listed() {
    let sandbox = Sandbox::new("tiny");
    let text = sandbox.run("kernels").assert_ok().stdout;
    let listed = sandbox.run("kernels --json").json();
    let listed = listed.as_array().unwrap();
    let points = muslin::kernels().flat_map(|kernel| kernel.entry_points());
    assert_eq!(listed.len(), points.count());
    let all = muslin::kernels();
    let all = all.flat_map(|kernel| kernel.entry_points().map(move |point| (kernel, point.name)));
    for (kernel, name) in all {
        assert!(text.lines().any(|line| line.starts_with(&format!("{name} "))), "{name}: {text}");
        let found = listed.iter().find(|listed| listed["name"] == name).unwrap();
        assert_eq!(found["workgroup_size"], serde_json::json!(kernel.workgroup_size), "{name}");
        assert_eq!(found["spirv_bytes"], MODULES.find(name).unwrap().spirv().len(), "{name}");
        assert!(found["instructions"].as_u64().unwrap() > 10, "{name}");
        let loops = found["loops"].as_u64().unwrap();
        let iterations = found["worst_case_iterations"].as_u64().unwrap();
        assert_eq!(loops == 0, iterations == 0, "{name}");
        let bindings = found["bindings"].as_array().unwrap();
        assert_eq!(bindings.len(), kernel.bindings.len(), "{name}");
        for (number, (binding, declared)) in bindings.iter().zip(kernel.bindings).enumerate() {
            assert_eq!(binding["binding"], number, "{name}");
            assert_eq!(binding["name"], declared.name, "{name}");
            assert_eq!(binding["access"], declared.access.as_str(), "{name}");
            assert_eq!(binding["element"], declared.element, "{name}");
        }
    }
    let scan = listed.iter().find(|listed| listed["name"] == "scan_block").unwrap();
    assert_eq!(scan["shared_bytes"], 256);
    let composite = |name| listed.iter().find(|listed| listed["name"] == name).unwrap();
    assert_eq!(composite("composite")["shared_bytes"], 0);
    // 64 intersections, each with a word of cells and three vectors
    assert_eq!(composite("composite_shared")["shared_bytes"], 64 * (4 + 3 * 16));
}

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
