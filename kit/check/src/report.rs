//! The results of all cases on one device.

use serde::Serialize;

use super::case::{Case, Rounding};
use super::measure::Measure;
use organza_device::{AdapterInfo, Device, DeviceOptions, Modules, Result, SpirvPath};

/// What the cases have found on a device.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The adapter's name, or `cpu`.
    pub adapter: String,
    /// Its driver.
    pub driver: String,
    /// How the kernels reach it.
    pub path: &'static str,
    /// A row for each entry point that the device can run.
    pub kernels: Vec<Row>,
}

/// What a kernel's case has found.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The entry point that ran: the kernel's name, or that of its variant.
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
    /// Runs cases on a GPU and on the CPU; calls `done` after each kernel.
    ///
    /// # Errors
    /// What a device runs into.
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
        let (plain, variants) = (open(false)?, open(true)?);
        let rounding = match path {
            SpirvPath::Passthrough => Rounding::AsWritten,
            SpirvPath::Naga => Rounding::Regrouped,
        };
        let kernels = rows(cases, cpu, &[&plain, &variants], rounding, done)?;
        let (adapter, driver) = (adapter.name.clone(), adapter.driver.clone());
        Ok(Self { adapter, driver, path: path.as_str(), kernels })
    }

    /// Runs cases on one thread of the CPU, and on all of them.
    ///
    /// # Errors
    /// What a device runs into.
    pub fn of_cpu(cases: &[Case], cpu: &Device, done: impl FnMut(&'static str)) -> Result<Self> {
        let one = Device::open(&DeviceOptions::cpu(Some(1)), Modules::none())?;
        let kernels = rows(cases, cpu, &[&one], Rounding::AsWritten, done)?;
        let (adapter, driver) = ("cpu".into(), std::env::consts::ARCH.into());
        Ok(Self { adapter, driver, path: "one thread", kernels })
    }

    /// Whether every kernel is within its tolerance.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.kernels.iter().all(|row| row.ok)
    }
}

/// The cases on each of the devices that runs another entry point than those before it.
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
