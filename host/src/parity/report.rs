//! All cases on one device.

use serde::Serialize;

use super::case::Rounding;
use super::cases;
use super::measure::Measure;
use crate::backend::{AdapterInfo, Device, DeviceOptions, SpirvPath};
use crate::error::Result;

/// What the cases have found on a device.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The adapter's name, or `cpu`.
    pub adapter: String,
    /// Its driver.
    pub driver: String,
    /// How the kernels reach it.
    pub path: &'static str,
    /// Kernels that the device does not offer what they need.
    pub left_out: Vec<&'static str>,
    /// A row for each of the others.
    pub kernels: Vec<Row>,
}

/// What a kernel's case has found.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The entry point.
    pub kernel: &'static str,
    /// The tolerance, in units of each output's scale; 0 where all outputs are integers.
    pub tolerance: f64,
    /// Where it comes from.
    pub why: &'static str,
    /// Whether all is within it.
    pub ok: bool,
    /// The largest differences.
    #[serde(flatten)]
    pub measure: Measure,
}

impl Report {
    /// Runs all cases on a GPU, beside the CPU; `done` is told of each kernel.
    ///
    /// # Errors
    /// What a device runs into.
    pub fn of_gpu(
        cpu: &Device,
        adapter: &AdapterInfo,
        path: SpirvPath,
        done: impl FnMut(&'static str),
    ) -> Result<Self> {
        let name = Some(adapter.name.clone());
        let device = Device::open(&DeviceOptions { adapter: name, ..DeviceOptions::gpu(path) })?;
        let rounding = match path {
            SpirvPath::Passthrough => Rounding::AsWritten,
            SpirvPath::Naga => Rounding::Regrouped,
        };
        let (kernels, left_out) = rows(cpu, &device, rounding, done)?;
        let (adapter, driver) = (adapter.name.clone(), adapter.driver.clone());
        Ok(Self { adapter, driver, path: path.as_str(), left_out, kernels })
    }

    /// Runs all cases on one thread of the CPU, beside all of them.
    ///
    /// # Errors
    /// What a device runs into.
    pub fn of_cpu(cpu: &Device, done: impl FnMut(&'static str)) -> Result<Self> {
        let one = Device::open(&DeviceOptions::cpu(Some(1)))?;
        let (kernels, left_out) = rows(cpu, &one, Rounding::AsWritten, done)?;
        let (adapter, driver) = ("cpu".into(), std::env::consts::ARCH.into());
        Ok(Self { adapter, driver, path: "one thread", left_out, kernels })
    }

    /// Whether every kernel is within its tolerance.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.kernels.iter().all(|row| row.ok)
    }
}

fn rows(
    cpu: &Device,
    device: &Device,
    rounding: Rounding,
    mut done: impl FnMut(&'static str),
) -> Result<(Vec<Row>, Vec<&'static str>)> {
    let (offered, left_out): (Vec<_>, Vec<_>) =
        cases().into_iter().partition(|case| case.is_offered(device));
    let row = |case: super::Case| {
        let measure = case.measure(cpu, device, rounding)?;
        done(case.kernel);
        let (kernel, tolerance, why) = (case.kernel, case.tolerance, case.why);
        Ok(Row { kernel, tolerance, why, ok: measure.is_ok(), measure })
    };
    let rows = offered.into_iter().map(row).collect::<Result<_>>()?;
    Ok((rows, left_out.into_iter().map(|case| case.kernel).collect()))
}
