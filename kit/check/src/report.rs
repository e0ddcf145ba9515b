//! The results of all cases on one device.

use std::fmt;

use serde::Serialize;

use crate::{Canary, Case, Measure, Rounding, Worst};
use muslin_device::{AdapterInfo, Device, DeviceOptions, Modules, Result, SpirvPath, Table};

/// The results of the cases on a device.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The adapter's name.
    pub adapter: String,
    /// The adapter's driver.
    pub driver: String,
    /// The path of kernels to the device.
    pub path: &'static str,
    /// A row for each entry point that the device can run.
    pub kernels: Vec<Row>,
}

/// The result of a kernel's case.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The entry point that ran: the kernel or its variant.
    pub kernel: &'static str,
    /// Whether all values are within their errors.
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
    pub fn run_on_gpu(
        cases: &[Case],
        modules: &'static Modules,
        cpu: &Device,
        adapter: &AdapterInfo,
        path: SpirvPath,
        mut done: impl FnMut(&'static str),
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
        let mut kernels = Vec::new();
        for case in cases {
            kernels.push(Row::new(case, &plain, case.measure(cpu, &plain, rounding)?));
            if case.entry_point(&variants) != case.entry_point(&plain) {
                kernels.push(Row::new(case, &variants, case.measure(cpu, &variants, rounding)?));
            }
            done(case.kernel);
        }
        let driver = adapter.driver.clone();
        Ok(Self { adapter: adapter.name.clone(), driver, path: path.as_str(), kernels })
    }

    /// Whether every kernel is within its tolerance.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.kernels.iter().all(|row| row.ok)
    }
}

const TITLES: [&str; 5] = ["kernel", "values", "absolute", "of allowed", "result"];

/// The table of the report, followed by its failures.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut table = Table::new(1, TITLES);
        self.kernels.iter().for_each(|row| table.row(row.cells()));
        let Self { adapter, driver, path, .. } = self;
        write!(f, "{adapter} ({driver}), {path}\n{table}")?;
        let failed = self.kernels.iter().filter(|row| !row.ok);
        failed
            .map(|row| (row.kernel, row.measure.describe("the CPU")))
            .try_for_each(|(kernel, text)| writeln!(f, "{kernel}: {text}"))
    }
}

impl Row {
    /// The row of a case on a device.
    pub(crate) fn new(case: &Case, device: &Device, measure: Measure) -> Self {
        Self { kernel: case.entry_point(device), ok: measure.is_ok(), measure }
    }

    /// The cells, in the order of [`TITLES`].
    fn cells(&self) -> [String; TITLES.len()] {
        let measure = &self.measure;
        [
            self.kernel.to_owned(),
            measure.values.to_string(),
            size(measure.absolute.value),
            format!("{:.0}%", measure.share.value * 100.0),
            if self.ok { "ok" } else { "FAILED" }.to_owned(),
        ]
    }
}

/// Formats a size. Zero is just `0`.
fn size(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

impl Measure {
    /// The values that are too far apart, and where they are farthest: without a line's end.
    #[must_use]
    pub fn describe(&self, beside: &str) -> String {
        let Worst { set, output, index, cpu, found, value } = &self.share;
        let failures = self.failures;
        let values = self.values;
        format!(
            "{failures} of {values} values are too far from {beside}, the worst is `{output}[{index}]` of \"{set}\": \
             {}, not {}, {:.1} times as far as allowed",
            number(*found),
            number(*cpu),
            value,
        )
    }
}

/// A number, or that no kernel has written it.
fn number(value: f64) -> String {
    let of_floats = [f32::CANARY, f32::OTHER_CANARY].map(f64::from);
    let of_integers = [u32::CANARY, u32::OTHER_CANARY].map(f64::from);
    let is_canary = of_floats.contains(&value) || of_integers.contains(&value);
    if is_canary { "unwritten".to_owned() } else { format!("{value:e}") }
}
