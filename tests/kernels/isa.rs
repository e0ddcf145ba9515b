//! The machine code that a GPU's compiler makes of the kernels: docs/correctness.md.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use insta::{Settings, assert_snapshot};
use muslin_isa::{Error, FAMILIES, Report, answer, compile};
use organza_tests::devices::skip;

/// With this variable, it is a failure if RADV is missing or has another version.
const REQUIRED: &str = "ORGANZA_REQUIRE_ISA";

#[test]
fn machine_code_is_as_accepted() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../host/render/kernels");
    if answer(&folder) {
        return;
    }
    let required = env::var_os(REQUIRED).is_some_and(|value| value != "0");
    for family in FAMILIES {
        let mut child = Command::new(env::current_exe().unwrap());
        child.args(["--exact", "isa::machine_code_is_as_accepted"]);
        match compile(&folder, family, &mut child) {
            Ok(report) => check(&folder, &report, required),
            Err(error @ Error::NoDriver { .. }) if !required => {
                skip("the kernels' machine code", &error.to_string());
            }
            Err(error) => panic!("{error}"),
        }
    }
}

fn check(folder: &Path, report: &Report, required: bool) {
    let Report { family, driver, kernels } = report;
    for kernel in kernels {
        let name = &kernel.name;
        let memory = (kernel.spills, kernel.scratch);
        assert_eq!(memory, (0, 0), "{family}, {driver}: `{name}` spills, or has arrays in memory");
    }
    let accepted = fs::read_to_string(folder.join(format!("{family}.snap"))).unwrap_or_default();
    if !accepted.is_empty() && !accepted.contains(&format!("{driver};")) && !required {
        skip(&format!("the machine code of {family}"), &format!("the snapshot is not of {driver}"));
        return;
    }
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(folder);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| assert_snapshot!(family.as_str(), report));
}
