//! A kernel's case, without the type of its inputs.

use super::exact::compare_with_exact;
use super::measure::Measure;
use super::parity::{Parity, Rounding};
use super::runner::KernelRunner;
use muslin_device::{Device, Result};
use muslin_kernel::KernelInfo;

/// A kernel's case, without the type of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// See [`Parity::TOLERANCE`].
    pub tolerance: f64,
    /// See [`Parity::WHY`].
    pub why: &'static str,
    /// See [`Parity::COMPARED`].
    pub compared: f64,
    measure: fn(&Device, &Device, Rounding) -> Result<Measure>,
    hold: fn(&Device, Rounding) -> Result<Measure>,
    run: fn(&Device, &str) -> Result<()>,
}

impl Case {
    /// The case of a kernel that implements [`Parity`].
    #[must_use]
    pub fn new<P: Parity>() -> Self {
        Self {
            kernel: P::KERNEL,
            tolerance: P::TOLERANCE,
            why: P::WHY,
            compared: P::COMPARED,
            measure: measure::<P>,
            hold: compare_with_exact::<P>,
            run: run::<P>,
        }
    }

    /// The name of the entry point that a device runs.
    #[must_use]
    pub fn entry_point(&self, device: &Device) -> &'static str {
        let kernel = muslin_kernel::kernels().find(|kernel| kernel.name == self.kernel);
        kernel.map_or(self.kernel, |kernel| device.entry_point(kernel).name)
    }

    /// Runs all sets on both devices, and compares the results.
    ///
    /// # Errors
    /// Any error of a device.
    pub fn measure(&self, cpu: &Device, device: &Device, rounding: Rounding) -> Result<Measure> {
        (self.measure)(cpu, device, rounding)
    }

    /// Runs all sets on a device, and compares with the equations in f64, within the case's own bound.
    ///
    /// [`Measure::values`] is the number of elements for which the equations have a value.
    ///
    /// # Errors
    /// Any error of the device.
    pub fn compare_with_exact(&self, device: &Device, rounding: Rounding) -> Result<Measure> {
        (self.hold)(device, rounding)
    }

    /// Runs the set of this name.
    ///
    /// # Errors
    /// Any error of the device.
    pub fn run(&self, device: &Device, set: &str) -> Result<()> {
        (self.run)(device, set)
    }
}

fn run<P: Parity>(device: &Device, set: &str) -> Result<()> {
    let mut sets = P::sets().into_iter().filter(|(name, _)| name == set);
    sets.try_for_each(|(_, set)| set.run(&KernelRunner::new(device, P::KERNEL)).map(drop))
}

fn measure<P: Parity>(cpu: &Device, device: &Device, rounding: Rounding) -> Result<Measure> {
    let mut measure = Measure::default();
    for (name, set) in P::sets() {
        let expected = set.run(&KernelRunner::new(cpu, P::KERNEL))?;
        let found = set.run(&KernelRunner::with_other_canaries(device, P::KERNEL))?;
        assert_eq!(expected.len(), found.len(), "outputs of `{}`", P::KERNEL);
        for (expected, found) in expected.iter().zip(&found) {
            measure.add(&name, expected, found, P::TOLERANCE, |index| {
                set.bound(expected, index, rounding)
            });
        }
    }
    Ok(measure)
}

/// Lists what to do so that each of some kernels has a case, and each case a kernel. `folder` is the place for cases.
///
/// A program passes its own kernels, [`kernels_of`](muslin_kernel::kernels_of): kernels of its dependencies are
/// linked in, too.
#[must_use]
pub fn missing(
    kernels: impl Iterator<Item = &'static KernelInfo>,
    cases: &[Case],
    folder: &str,
) -> Vec<String> {
    let kernels: Vec<_> = kernels.collect();
    let without_case =
        kernels.iter().filter(|kernel| cases.iter().all(|c| c.kernel != kernel.name));
    let without_kernel = cases.iter().filter(|c| kernels.iter().all(|k| k.name != c.kernel));
    let add = without_case.map(|kernel| {
        let stage = kernel.file.rsplit(['/', '\\']).next().unwrap_or(kernel.file);
        format!(
            "the kernel `{}` has no parity case: implement `Parity` for its inputs in \
             {folder}/{stage} and add it to `cases()` in {folder}/mod.rs",
            kernel.name
        )
    });
    let remove = without_kernel.map(|case| {
        format!("the parity case `{}` has no kernel: take it out of `cases()`", case.kernel)
    });
    add.chain(remove).collect()
}
