//! Runs all cases on all devices of this machine, as one test.

use std::collections::BTreeSet;

use muslin::{KernelInfo, kernels};
use muslin_device::{Device, Modules};

use super::case::{Case, Rounding};
use super::{devices, measure::Measure};

/// Checks each kernel with its case on every device of this machine: the CPU with each instruction set, the CPUs that
/// [check](devices::checked) for mistakes, and the GPU, passed through and through naga. Each result is compared
/// with the CPU's and with the equations. Every kernel of the cases' packages must have a case.
///
/// # Panics
/// If a device is out of a case's tolerance, a kernel makes a mistake, or a kernel has no case. The message has a
/// line for each. Also if [`devices::gpus`] panics.
#[track_caller]
pub fn assert_parity(cases: &[Case], modules: &'static Modules) {
    let cpu = devices::cpu(None);
    let checked = [
        ("cpu, checked", devices::checked()),
        ("cpu, checked variants", devices::checked_variants()),
        ("cpu, thorough", devices::thorough(1)),
    ];
    let gpus = devices::gpus(modules).into_iter().chain(variants(modules));
    let mut failures = without_case(cases);
    for (name, device) in devices::cpus().into_iter().chain(checked).chain(gpus) {
        let rounding = match name.contains("naga") {
            true => Rounding::Regrouped,
            false => Rounding::AsWritten,
        };
        for case in cases {
            let kernel = case.entry_point(&device);
            let results = [
                ("the CPU", case.measure(&cpu, &device, rounding)),
                ("the equations", case.hold(&device, rounding)),
            ];
            for (beside, result) in results {
                match result {
                    Err(error) => failures.push(format!("{kernel} on {name}: {error}")),
                    Ok(Measure { failures: failed, values, share, .. }) if failed > 0 => failures.push(format!(
                        "{kernel} on {name}: {failed} of {values} are too far from {beside}, most {share:?}"
                    )),
                    Ok(_) => {}
                }
            }
        }
    }
    failures.dedup();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
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
    devices::variants(modules).into_iter().map(|(name, [_, variants])| (name, variants)).collect()
}
