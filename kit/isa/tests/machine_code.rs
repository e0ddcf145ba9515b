//! The machine code that RADV makes of this repository's kernels: docs/correctness.md.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::{env, fs};

use muslin_isa::{Error, FAMILIES, Report, answer, compile};

/// With this variable, it is a failure if RADV is missing or has another version.
const REQUIRED: &str = "MUSLIN_REQUIRE_ISA";

/// With this variable, the files get what is found.
const WRITE: &str = "MUSLIN_WRITE_ISA";

fn is_set(variable: &str) -> bool {
    env::var_os(variable).is_some_and(|value| value != "0")
}

/// Compiles the kernels of a folder, or says why not.
fn report(folder: &str, family: &str) -> Option<Report> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut child = Command::new(env::current_exe().expect("a program"));
    match compile(&folder, family, &mut child) {
        Ok(report) => Some(report),
        Err(error @ Error::NoDriver { .. }) if !is_set(REQUIRED) => {
            eprintln!("skipped the kernels' machine code: {error}");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Each kernel of organza has the machine code of the file, without spills.
fn machine_code_is_as_accepted(family: &str) {
    let Some(report) = report("../../host/render/kernels", family) else { return };
    let driver = &report.driver;
    for kernel in &report.kernels {
        let memory = [kernel.spills, kernel.scratch];
        assert_eq!(
            memory,
            [0, 0],
            "{family}, {driver}: `{}` spills, or has arrays in memory",
            kernel.name
        );
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/{family}.txt"));
    let found = report.to_string();
    if is_set(WRITE) {
        fs::write(&file, &found).expect("a file");
    }
    let accepted = fs::read_to_string(&file).expect("the file of a family");
    if !accepted.contains(&format!("{driver};")) && !is_set(REQUIRED) {
        eprintln!("skipped the machine code of {family}: {} is not of {driver}", file.display());
        return;
    }
    for (accepted, found) in accepted.lines().zip(found.lines()) {
        assert_eq!(found, accepted, "{family}: `{WRITE}=1` accepts it");
    }
    assert_eq!(found.lines().count(), accepted.lines().count(), "{family}: `{WRITE}=1` accepts it");
}

/// Each kernel that tests the language is compiled.
fn every_kernel_has_machine_code(family: &str) {
    let Some(report) = report("../language/compiled", family) else { return };
    assert!(report.kernels.len() >= 10);
    for kernel in &report.kernels {
        assert!(kernel.instructions > 3 && kernel.registers > 0, "{kernel:?}");
    }
    let shared = report.kernels.iter().find(|kernel| kernel.name == "byte_histogram");
    assert!(shared.is_some_and(|kernel| kernel.shared > 0));
    assert!(report.kernels.iter().any(|kernel| !kernel.loops.is_empty()));
}

/// A test of a family.
type Test = fn(&str);

// without a harness, because the program is also the process that compiles
fn main() -> ExitCode {
    if answer() {
        return ExitCode::SUCCESS;
    }
    // what `cargo test NAME` and other programs ask
    let arguments: Vec<_> = env::args().skip(1).collect();
    let wanted: Vec<_> = arguments.iter().filter(|argument| !argument.starts_with('-')).collect();
    let tests: [(&str, Test); 2] = [
        ("machine_code_is_as_accepted", machine_code_is_as_accepted),
        ("every_kernel_has_machine_code", every_kernel_has_machine_code),
    ];
    for (name, test) in tests {
        if wanted.is_empty() || wanted.iter().any(|part| name.contains(part.as_str())) {
            FAMILIES.into_iter().for_each(test);
            println!("test {name} ... ok");
        }
    }
    ExitCode::SUCCESS
}
