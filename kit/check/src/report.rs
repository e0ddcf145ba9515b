//! The results of all cases on one device.

use serde::Serialize;

use super::case::{Case, Rounding};
use super::measure::Measure;
use muslin_device::{AdapterInfo, Device, DeviceOptions, Modules, Result, SpirvPath};

/// The results of the cases on a device.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The adapter's name, or `cpu`.
    pub adapter: String,
    /// The adapter's driver.
    pub driver: String,
    /// The way in which kernels reach the device.
    pub path: &'static str,
    /// A row for each entry point that the device can run.
    pub kernels: Vec<Row>,
}

/// The result of a kernel's case.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The entry point that ran: the kernel's name, or that of its variant.
    pub kernel: &'static str,
    /// The tolerance, in units of each output's scale; 0 if all outputs are integers.
    pub tolerance: f64,
    /// The reason for the tolerance.
    pub why: &'static str,
    /// Whether all values are within the tolerance.
    pub ok: bool,
    /// The largest differences.
    #[serde(flatten)]
    pub measure: Measure,
}

impl Report {
    /// Runs cases on a GPU and on the CPU, and calls `done` after each kernel.
    ///
    /// # Errors
    /// Any error of a device.
    pub fn of_gpu(
        cases: &[Case],
        modules: &'static Modules,
        cpu: &Device,
        adapter: &AdapterInfo,
        path: SpirvPath,
        done: impl FnMut(&'static str),
    ) -> Result<Self> {
        let open = |variants| {
            let adapter = Some(adapter.name.clone());
            let variants = Some(variants);
            let options = DeviceOptions::gpu(path).adapter(adapter).variants(variants);
            Device::open(&options, modules)
        };
        let plain = open(false)?;
        let variants = open(true)?;
        let rounding = match path {
            SpirvPath::Passthrough => Rounding::AsWritten,
            SpirvPath::Naga => Rounding::Regrouped,
        };
        let kernels = rows(cases, cpu, &[&plain, &variants], rounding, done)?;
        let (adapter, driver) = (adapter.name.clone(), adapter.driver.clone());
        Ok(Self { adapter, driver, path: path.as_str(), kernels })
    }

    /// Runs cases on one thread of the CPU, and on all threads.
    ///
    /// # Errors
    /// Any error of a device.
    pub fn of_cpu(cases: &[Case], cpu: &Device, done: impl FnMut(&'static str)) -> Result<Self> {
        let one = Device::open(&DeviceOptions::cpu(Some(1)), Modules::none())?;
        let kernels = rows(cases, cpu, &[&one], Rounding::AsWritten, done)?;
        let adapter = "cpu".into();
        let driver = std::env::consts::ARCH.into();
        Ok(Self { adapter, driver, path: "one thread", kernels })
    }

    /// Whether every kernel is within its tolerance.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.kernels.iter().all(|row| row.ok)
    }
}

/// Runs the cases on each device whose entry point differs from those of the devices before it.
fn rows(
    cases: &[Case],
    cpu: &Device,
    devices: &[&Device],
    rounding: Rounding,
    mut done: impl FnMut(&'static str),
) -> Result<Vec<Row>> {
    let mut rows: Vec<Row> = Vec::new();
    for case in cases {
        let Case { tolerance, why, .. } = *case;
        let first = rows.len();
        for device in devices {
            let kernel = case.entry_point(device);
            if rows[first..].iter().all(|row| row.kernel != kernel) {
                let measure = case.measure(cpu, device, rounding)?;
                rows.push(Row { kernel, tolerance, why, ok: measure.is_ok(), measure });
            }
        }
        done(case.kernel);
    }
    Ok(rows)
}
