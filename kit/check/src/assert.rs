//! Runs all cases on all devices of this machine, as one test.

use std::collections::BTreeSet;

use muslin::{KernelInfo, kernels};
use muslin_device::{Device, InstructionSet, Modules, STALE};

use super::case::Case;
use super::parity::Rounding;
use super::report::{Report, Row};
use super::{debugger, devices, measure::Measure};

/// Checks each kernel with its case on every device of this machine: the CPU with each instruction set, the CPUs that
/// [check](devices::checked) for mistakes, and the GPU, passed through and through naga, with its variants. Each result is
/// compared with the CPU's and with the equations; where the CPU only checks more, it is the same. Every kernel of the cases'
/// packages must have a case, and the equations give most of what it writes: see [`Parity::COMPARED`](super::Parity::COMPARED).
///
/// It prints a table for each device, which `cargo xtask parity` shows.
///
/// # Panics
/// If a device is out of a case's tolerance, a kernel makes a mistake, or a kernel has no case. The message has a
/// line for each, and a command that stops a debugger in the invocation that has written the worst element. Also if
/// [`devices::gpus`] panics.
#[track_caller]
pub fn assert_parity(cases: &[Case], modules: &'static Modules) {
    if debugger::answer(cases) {
        return;
    }
    let cpu = devices::cpu(None);
    let mut failures = without_case(cases);
    // they say what is wrong, where others have wrong values
    checked(cases, &cpu, &mut failures);
    let plain = devices::cpus().into_iter().chain(devices::gpus(modules));
    for (name, device) in plain.chain(variants(modules)) {
        let mut rows = Vec::new();
        for case in cases.iter().filter(|case| is_new(case, &device, name)) {
            let rounding = match name.contains("naga") {
                true => Rounding::Regrouped,
                false => Rounding::AsWritten,
            };
            let of_cpu = case.measure(&cpu, &device, rounding);
            let of_equations = case.compare_with_exact(&device, rounding);
            if let Ok(measure) = &of_equations {
                failures.extend(uncompared(case, measure, name));
            }
            for (beside, result) in [("the CPU", &of_cpu), ("the equations", &of_equations)] {
                add_failure(&mut failures, case, &device, [name, beside], result);
            }
            rows.extend(of_cpu.map(|measure| Row::new(case, &device, measure)));
        }
        let adapter = name.to_owned();
        let driver = device.arithmetic();
        println!("{}", Report { adapter, driver, path: device.backend(), kernels: rows });
    }
    let mut failures = folded(failures);
    if !failures.is_empty() && modules.manifest().is_stale {
        failures.insert(0, format!("GPUs run old kernels: {STALE}"));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// One line for what several devices say of a kernel.
fn folded(failures: Vec<String>) -> Vec<String> {
    let mut lines: Vec<[String; 3]> = Vec::new();
    for failure in failures {
        let parts = failure.split_once(" on ").and_then(|(kernel, rest)| {
            let (device, what) = rest.split_once(": ")?;
            Some([kernel, device, what].map(str::to_owned))
        });
        let [kernel, device, what] =
            parts.unwrap_or_else(|| [String::new(), String::new(), failure]);
        let same = lines.iter_mut().find(|line| line[0] == kernel && line[2] == what);
        match same {
            Some(line) if line[1] == device => {}
            Some(line) => line[1] = format!("{}, {device}", line[1]),
            None => lines.push([kernel, device, what]),
        }
    }
    let line = |[kernel, device, what]: [String; 3]| match kernel.is_empty() {
        true => what,
        false => format!("{kernel} on {device}: {what}"),
    };
    lines.into_iter().map(line).collect()
}

/// The mistakes that the checked CPUs find.
fn checked(cases: &[Case], cpu: &Device, failures: &mut Vec<String>) {
    let scalar = devices::with(InstructionSet::Scalar);
    let checked = [
        ("cpu, checked", devices::checked()),
        ("cpu, checked variants", devices::checked_variants()),
        ("cpu, thorough", devices::thorough(1)),
    ];
    for (name, device) in &checked {
        let is_variant = name.contains("variants");
        for case in cases.iter().filter(|case| is_new(case, device, name)) {
            // the exponential of a variant is not that of lanes
            let reference = if is_variant { cpu } else { &scalar };
            let result = case.measure(reference, device, Rounding::AsWritten);
            add_failure(failures, case, device, [name, "the CPU"], &result);
            if !is_variant && result.is_ok_and(|measure| measure.share.value > 0.0) {
                failures.push(format!("{} on {name}: the result changes where one workgroup more is run, or the order differs", case.kernel));
            }
        }
    }
}

/// Whether a device runs something for a case that others do not: devices of variants are for these alone.
fn is_new(case: &Case, device: &Device, name: &str) -> bool {
    !name.contains("variants") || case.entry_point(device) != case.kernel
}

/// Adds what is wrong with a result. A kernel's first failure has the command of a debugger.
fn add_failure(
    failures: &mut Vec<String>,
    case: &Case,
    device: &Device,
    [name, beside]: [&str; 2],
    result: &muslin_device::Result<Measure>,
) {
    let subject = format!("{} on {name}", case.entry_point(device));
    let measure = match result {
        Err(error) => return failures.push(format!("{subject}: {error}")),
        Ok(measure) if measure.is_ok() => return,
        Ok(measure) => measure,
    };
    let of_debugger = format!("{}='{} ", debugger::STOP, case.kernel);
    let is_first = !failures.iter().any(|failure| failure.contains(&of_debugger));
    failures.push(measure.describe(&subject, beside, case.why));
    if is_first {
        failures.extend(debugger::command(case, &measure.share));
    }
}

/// Outputs of which the equations give too few values.
fn uncompared(case: &Case, measure: &Measure, name: &str) -> Vec<String> {
    let kernel = case.kernel;
    let mut failures = Vec::new();
    if measure.values == 0 {
        failures.push(format!("{kernel} on {name}: `exact` gives no value of any output"));
    }
    for (output, [compared, written]) in &measure.compared {
        if (*compared as f64) < case.compared * *written as f64 {
            failures.push(format!(
                "{kernel} on {name}: `exact` gives {compared} of the {written} values that it writes to `{output}`, fewer than `COMPARED` asks for"
            ));
        }
    }
    failures
}

/// Kernels without a case, in packages with at least one case.
fn without_case(cases: &[Case]) -> Vec<String> {
    let has_case = |kernel: &&KernelInfo| cases.iter().any(|case| case.kernel == kernel.name);
    let packages: BTreeSet<_> = kernels().filter(has_case).map(|kernel| kernel.package).collect();
    let without = kernels().filter(|kernel| !has_case(kernel) && packages.contains(kernel.package));
    let message = |kernel: &KernelInfo| {
        format!("{}: the kernel `{}` has no parity case", kernel.source(), kernel.name)
    };
    without.map(message).collect()
}

/// The GPU with its variants, if it has any that [`devices::gpus`] does not run.
fn variants(modules: &'static Modules) -> Vec<(&'static str, Device)> {
    if kernels().all(|kernel| kernel.variant.is_none()) {
        return Vec::new();
    }
    let names =
        [("gpu passthrough", "gpu passthrough, variants"), ("gpu naga", "gpu naga, variants")];
    let name = |plain| names.into_iter().find(|(name, _)| *name == plain).map_or(plain, |of| of.1);
    let all = devices::variants(modules).into_iter();
    all.map(|(plain, [_, variants])| (name(plain), variants)).collect()
}
