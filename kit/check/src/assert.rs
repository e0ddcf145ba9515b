//! Runs all cases on all devices of this machine, as one test.

use std::collections::BTreeSet;
use std::fmt;

use muslin_device::{Device, InstructionSet, Modules, STALE};
use muslin_kernel::{KernelInfo, kernels};

use super::{devices, measure::Measure};
use crate::{Case, Report, Rounding, Row};

/// Checks each kernel with its case on every device of this machine: the CPU with each instruction set and with denormals
/// [flushed](devices::flushing), the CPUs that [check](devices::checked) for mistakes, and the GPU with its variants, each with
/// SPIR-V as it is and through naga. Each result is compared with the CPU's and with the equations. Every kernel of the cases'
/// packages must have a case, and the equations must know most values that it writes: see
/// [`Parity::COMPARED`](super::Parity::COMPARED).
///
/// It prints a table for each device, which `cargo test -- --nocapture` shows.
///
/// # Panics
/// If a device is out of a case's tolerance, a kernel makes a mistake, or a kernel has no case. The message has a
/// line for each. Also if [`devices::gpus`] panics.
#[track_caller]
pub fn assert_parity(cases: &[Case], modules: &'static Modules) {
    let cpu = devices::cpu(None);
    let mut failures = Vec::new();
    // first, as they name the mistake, where other devices only have wrong values
    checked(cases, &cpu, &mut failures);
    let flushing = [("cpu, flushing", devices::flushing())];
    let plain = devices::cpus().into_iter().chain(flushing).chain(devices::gpus(modules));
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
                for what in uncompared(case, measure) {
                    add(&mut failures, case.kernel, name, what);
                }
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
    let mut lines = missing(cases);
    lines.extend(failures.iter().map(ToString::to_string));
    if !lines.is_empty() && modules.manifest().is_stale {
        lines.insert(0, format!("GPUs run old kernels: {STALE}"));
    }
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}

/// A failure of a kernel on one or several devices.
struct Failure {
    kernel: &'static str,
    devices: Vec<String>,
    what: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {}: {}", self.kernel, self.devices.join(", "), self.what)
    }
}

/// Adds a failure, or adds the device to the same failure of others.
fn add(failures: &mut Vec<Failure>, kernel: &'static str, device: &str, what: String) {
    let same = |failure: &&mut Failure| failure.kernel == kernel && failure.what == what;
    if let Some(failure) = failures.iter_mut().find(same) {
        if failure.devices.iter().all(|name| name != device) {
            failure.devices.push(device.to_owned());
        }
        return;
    }
    failures.push(Failure { kernel, devices: vec![device.to_owned()], what });
}

/// The mistakes that the checked CPUs find.
fn checked(cases: &[Case], cpu: &Device, failures: &mut Vec<Failure>) {
    let scalar = devices::with(InstructionSet::Scalar);
    let checked = [
        ("cpu, checked", devices::checked()),
        ("cpu, checked variants", devices::checked_variants()),
        ("cpu, thorough", devices::thorough(1)),
    ];
    for (name, device) in &checked {
        let is_variant = name.contains("variants");
        for case in cases.iter().filter(|case| is_new(case, device, name)) {
            // a variant and the lanes of a CPU have different exponentials
            let reference = if is_variant { cpu } else { &scalar };
            let result = case.measure(reference, device, Rounding::AsWritten);
            add_failure(failures, case, device, [name, "the CPU"], &result);
            if !is_variant && result.is_ok_and(|measure| measure.share.value > 0.0) {
                let what =
                    "the result changes where one workgroup more is run, or the order differs";
                add(failures, case.kernel, name, what.to_owned());
            }
        }
    }
}

/// Whether a device runs anything new for a case: a device with variants only runs kernels that have one.
fn is_new(case: &Case, device: &Device, name: &str) -> bool {
    !name.contains("variants") || case.entry_point(device) != case.kernel
}

/// Adds a result's failures.
fn add_failure(
    failures: &mut Vec<Failure>,
    case: &Case,
    device: &Device,
    [name, beside]: [&str; 2],
    result: &muslin_device::Result<Measure>,
) {
    let kernel = case.entry_point(device);
    let what = match result {
        Err(error) => error.to_string(),
        Ok(measure) if measure.is_ok() => return,
        Ok(measure) => measure.describe(beside),
    };
    add(failures, kernel, name, what);
}

/// Outputs with too few values from the equations.
fn uncompared(case: &Case, measure: &Measure) -> Vec<String> {
    let mut failures = Vec::new();
    if measure.values == 0 {
        failures.push("`exact` gives no value of any output".to_owned());
    }
    for (output, [compared, written]) in &measure.compared {
        if (*compared as f64) < case.compared * *written as f64 {
            failures.push(format!(
                "`exact` gives {compared} of the {written} values that it writes to `{output}`, fewer than `COMPARED` asks for"
            ));
        }
    }
    failures
}

/// A message for each kernel without a case, in packages with at least one case.
#[must_use]
pub fn missing(cases: &[Case]) -> Vec<String> {
    let has_case = |kernel: &&KernelInfo| cases.iter().any(|case| case.kernel == kernel.name);
    let packages: BTreeSet<_> = kernels().filter(has_case).map(|kernel| kernel.package).collect();
    let without = kernels().filter(|kernel| !has_case(kernel) && packages.contains(kernel.package));
    let message = |kernel: &KernelInfo| {
        format!(
            "{}: the kernel `{}` has no parity case: declare it with `case!`, and implement `Parity` for it",
            kernel.source(),
            kernel.name
        )
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
