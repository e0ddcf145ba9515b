//! `organza kernels`: facts about the kernels.

use organza::MODULES;
use serde_json::Value;

use crate::sandbox::Sandbox;

#[test]
fn every_kernel_is_listed() {
    let sandbox = Sandbox::new("tiny");
    let text = sandbox.run("kernels").assert_ok().stdout;
    let listed: Value =
        serde_json::from_str(&sandbox.run("kernels --json").assert_ok().stdout).unwrap();
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
    // 64 members, each with a word of cells and three vectors
    assert_eq!(composite("composite_shared")["shared_bytes"], 64 * (4 + 3 * 16));
}
