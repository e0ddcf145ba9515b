//! The time of kernels, compared with the device's peak rates of arithmetic and memory.

use std::collections::BTreeMap;
use std::fmt;
use std::time::Instant;

use muslin_device::{Device, KernelTime, Modules, Result, Table, grouped};
use muslin_kernel::peak::{
    MAX_PEAK_STEPS, PeakMultiplyAddKernel, PeakMultiplyAddParams, PeakReadKernel, PeakReadParams,
    READS,
};
use muslin_kernel::work::Work;
use serde::Serialize;

use crate::devices;

/// The cost of a kernel's dispatches in a pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KernelShare {
    /// Name of the kernel.
    pub name: &'static str,
    /// Number of dispatches in a pass.
    pub dispatches: u64,
    /// Seconds of all dispatches in a pass, the median over passes.
    pub seconds: f64,
    /// Part of the seconds of all kernels, 0 to 1.
    pub share: f64,
    /// Billions of floating-point operations per second, as [`Work`] counts them; `None` if it does not.
    pub gflops: Option<f64>,
    /// Billions of bytes per second, as [`Work`] counts them; `None` if it does not.
    pub gbs: Option<f64>,
    /// The larger of the fractions of the device's two peaks. Data in caches may make it larger than 1.
    pub peak_share: Option<f64>,
}

impl fmt::Display for Peaks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "peaks: {} GFLOP/s, {} GB/s", rate(Some(self.gflops)), rate(Some(self.gbs)))
    }
}

impl KernelShare {
    /// Adds the fraction of the device's peaks.
    #[must_use]
    pub fn beside(mut self, peaks: Peaks) -> Self {
        let shares = [self.gflops.map(|of| of / peaks.gflops), self.gbs.map(|of| of / peaks.gbs)];
        self.peak_share = shares.into_iter().flatten().reduce(f64::max);
        self
    }
}

/// Number of passes that [`time`] makes.
#[must_use]
pub fn passes(device: &Device, repeat: usize) -> usize {
    1 + if times_apart(device) { 2 * repeat } else { repeat }
}

/// Whether kernels must be timed in separate passes, because timing may slow down a pass.
fn times_apart(device: &Device) -> bool {
    device.backend() == "gpu"
}

/// The time of a pass and of its kernels.
#[derive(Clone, Debug)]
pub struct Timed {
    /// The median time of whole passes, in seconds.
    pub seconds: f64,
    /// The kernels, the slowest first.
    pub kernels: Vec<KernelShare>,
}

/// Runs a pass once to warm up, and times it `repeat` times. Calls `progress` after each.
///
/// # Errors
/// The first error of a pass.
pub fn time<E>(
    device: &Device,
    repeat: usize,
    progress: &mut dyn FnMut(),
    pass: &mut dyn FnMut() -> Result<(), E>,
) -> Result<Timed, E> {
    let mut run = || -> Result<(f64, Vec<KernelTime>), E> {
        let _ = device.take_timings();
        let start = Instant::now();
        pass()?;
        let seconds = start.elapsed().as_secs_f64();
        progress();
        Ok((seconds, device.take_timings()))
    };
    let apart = times_apart(device);
    device.time_dispatches(!apart);
    run()?;
    let (seconds, mut kernels): (Vec<_>, Vec<_>) =
        (0..repeat).map(|_| run()).collect::<Result<Vec<_>, E>>()?.into_iter().unzip();
    if apart {
        device.time_dispatches(true);
        let passes: Result<Vec<_>, E> = (0..repeat).map(|_| run()).collect();
        kernels = passes?.into_iter().map(|(_, kernels)| kernels).collect();
    }
    device.time_dispatches(false);
    Ok(Timed { seconds: median(seconds), kernels: shares(&kernels) })
}

/// The median of each kernel over passes.
fn shares(passes: &[Vec<KernelTime>]) -> Vec<KernelShare> {
    let mut times: BTreeMap<&'static str, (u64, Work, Vec<f64>)> = BTreeMap::new();
    for time in passes.iter().flatten() {
        let (dispatches, work, seconds) = times.entry(time.kernel).or_default();
        *dispatches = time.dispatches;
        *work = time.work;
        seconds.push(time.seconds);
    }
    let mut shares: Vec<_> = times
        .into_iter()
        .map(|(name, (dispatches, work, seconds))| {
            let seconds = median(seconds);
            let rate = |of: u64| (of > 0 && seconds > 0.0).then(|| of as f64 / seconds / 1e9);
            let gflops = rate(work.flops);
            let gbs = rate(work.bytes);
            KernelShare { name, dispatches, seconds, share: 0.0, gflops, gbs, peak_share: None }
        })
        .collect();
    let all: f64 = shares.iter().map(|kernel| kernel.seconds).sum();
    shares.iter_mut().for_each(|kernel| kernel.share = kernel.seconds / all.max(f64::MIN_POSITIVE));
    shares.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    shares
}

/// The middle value, or the mean of the two middle values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.len() % 2 {
        0 => (values[middle - 1] + values[middle]) / 2.0,
        _ => values[middle],
    }
}

/// Kernels as a table.
#[must_use]
pub fn table(kernels: &[KernelShare]) -> Table {
    let titles = ["kernel", "dispatches", "seconds", "share", "GFLOP/s", "GB/s", "of peak"];
    let mut table = Table::new(1, titles);
    for kernel in kernels {
        table.row([
            kernel.name.to_owned(),
            grouped(kernel.dispatches),
            seconds(kernel.seconds),
            format!("{:.1}%", 100.0 * kernel.share),
            rate(kernel.gflops),
            rate(kernel.gbs),
            kernel.peak_share.map_or("-".to_owned(), |share| format!("{:.0}%", 100.0 * share)),
        ]);
    }
    table
}

/// A rate with three digits or more; a dash for `None`.
fn rate(rate: Option<f64>) -> String {
    match rate {
        None => "-".to_owned(),
        Some(rate) if rate < 10.0 => format!("{rate:.2}"),
        Some(rate) if rate < 100.0 => format!("{rate:.1}"),
        Some(rate) => grouped(rate.round() as u64),
    }
}

/// A time, to the microsecond.
#[must_use]
pub fn seconds(seconds: f64) -> String {
    format!("{seconds:.6}")
}

/// Runs a pass on the CPU and on each GPU, and prints the time of each of its kernels, beside the device's peaks. Call it in an
/// ignored test with the name `bench`: `cargo xtask bench` runs it. The passes should keep the device busy.
///
/// # Panics
/// If a pass fails.
pub fn bench(modules: &'static Modules, mut pass: impl FnMut(&Device) -> Result<()>) {
    for (_, device) in devices::all(modules) {
        let result = time(&device, REPEAT, &mut || {}, &mut || pass(&device));
        let timed = result.unwrap_or_else(|error| panic!("{}: {error}", device.choice()));
        let peaks = Peaks::measure(&device).unwrap_or_else(|error| panic!("{error}"));
        let kernels: Vec<_> =
            timed.kernels.into_iter().map(|kernel| kernel.beside(peaks)).collect();
        let whole = seconds(timed.seconds);
        println!("{}\n{whole} s, {peaks}\n\n{}", device.choice(), table(&kernels));
    }
}

/// Passes of [`bench`].
const REPEAT: usize = 5;

/// The peak performance of a device, using all its threads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peaks {
    /// Billions of floating-point operations per second, from multiply-adds on registers.
    pub gflops: f64,
    /// Billions of bytes per second, from reading memory that no cache holds from end to end.
    pub gbs: f64,
}

/// Number of dispatches. The fastest counts.
const RUNS: usize = 12;
/// Target time of a dispatch, in seconds: long compared with the cost of starting it.
const SECONDS: f64 = 0.01;
/// Steps of an invocation of `peak_multiply_add`.
const STEPS: u32 = 512;
/// Invocations of its first dispatch, and the largest number.
const INVOCATIONS: [u32; 2] = [1 << 14, 1 << 22];
/// Bytes to read, if a buffer may be as large: caches are smaller.
const BYTES: u64 = 1 << 28;
/// Steps of an invocation of `peak_read`: a workgroup's 16 KiB stay in the innermost cache of a CPU.
const READ_STEPS: u32 = 16;
/// Invocations of a workgroup of `peak_read`.
const WORKGROUP: u32 = 64;

const _: () = assert!(STEPS <= MAX_PEAK_STEPS && READ_STEPS <= MAX_PEAK_STEPS);

impl Peaks {
    /// Measures a device, in about half a second.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`] and [`Device::dispatch`].
    pub fn measure(device: &Device) -> Result<Self> {
        device.time_dispatches(true);
        let peaks =
            multiply_add(device).and_then(|gflops| read(device).map(|gbs| Self { gflops, gbs }));
        device.time_dispatches(false);
        peaks
    }
}

/// Returns seconds, operations and bytes of a dispatch.
fn time_of(device: &Device, dispatch: &dyn Fn() -> Result<()>) -> Result<[f64; 3]> {
    let _ = device.take_timings();
    dispatch()?;
    let mut sums = [0.0; 3];
    for time in device.take_timings() {
        let found = [time.seconds, time.work.flops as f64, time.work.bytes as f64];
        sums = std::array::from_fn(|index| sums[index] + found[index]);
    }
    // a GPU may count in microseconds
    sums[0] = sums[0].max(1e-6);
    Ok(sums)
}

fn multiply_add(device: &Device) -> Result<f64> {
    let [mut count, max] = INVOCATIONS;
    let output = device.zeros("peak", max as usize)?;
    let run = |count: u32| {
        let params = PeakMultiplyAddParams { count, steps: STEPS, factor: 0.5, addend: 1.0 };
        let kernel = PeakMultiplyAddKernel { params, output: &output };
        time_of(device, &|| device.run(&kernel, count, 1))
    };
    // the first one may wake the device up
    run(count)?;
    let [seconds, ..] = run(count)?;
    let wanted = f64::from(count) * (SECONDS / seconds).max(1.0);
    count = (wanted.min(f64::from(max)) as u32).next_multiple_of(WORKGROUP).min(max);
    let mut best: f64 = 0.0;
    for _ in 0..RUNS {
        let [seconds, flops, _] = run(count)?;
        best = best.max(flops / seconds);
    }
    Ok(best / 1e9)
}

fn read(device: &Device) -> Result<f64> {
    let workgroup = u64::from(READ_STEPS * READS * WORKGROUP);
    let of_workgroup = workgroup * size_of::<f32>() as u64;
    let workgroups = BYTES.min(device.max_buffer_bytes()) / of_workgroup;
    let count = workgroups as u32 * WORKGROUP;
    let values = device.zeros::<f32>("peak", (workgroups * workgroup) as usize)?;
    // the system may not provide memory before it is written
    device.clear(&values);
    let output = device.zeros("peak", count as usize)?;
    let kernel = PeakReadKernel {
        params: PeakReadParams { count, steps: READ_STEPS },
        values: &values,
        output: &output,
    };
    let mut best: f64 = 0.0;
    for _ in 0..RUNS {
        let [seconds, _, bytes] = time_of(device, &|| device.run(&kernel, count, 1))?;
        best = best.max(bytes / seconds);
    }
    Ok(best / 1e9)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_median_is_in_the_middle() {
        for (values, expected) in [
            (vec![3.0], 3.0),
            (vec![9.0, 1.0], 5.0),
            (vec![7.0, 1.0, 100.0], 7.0),
            (vec![8.0, 1.0, 100.0, 4.0], 6.0),
        ] {
            assert_eq!(median(values.clone()), expected, "{values:?}");
        }
    }

    #[test]
    fn kernels_are_ordered_by_their_median_and_share_one() {
        let work = Work { flops: 0, bytes: 6_000_000_000 };
        let time = |kernel, dispatches, seconds| KernelTime { kernel, dispatches, seconds, work };
        let passes = [
            vec![time("a", 2, 1.0), time("b", 5, 3.0)],
            vec![time("a", 2, 50.0), time("b", 5, 3.0)],
            vec![time("a", 2, 1.0), time("b", 5, 2.0)],
        ];
        let found = shares(&passes);
        let share = |name, dispatches, seconds, share| {
            let gflops = None;
            let gbs = Some(6.0 / seconds);
            KernelShare { name, dispatches, seconds, share, gflops, gbs, peak_share: None }
        };
        assert_eq!(found, [share("b", 5, 3.0, 0.75), share("a", 2, 1.0, 0.25)]);
    }

    #[test]
    fn a_share_of_the_peaks_is_the_larger_one() {
        let peaks = Peaks { gflops: 100.0, gbs: 10.0 };
        for (gflops, gbs, expected) in [
            (None, None, None),
            (Some(20.0), None, Some(0.2)),
            (Some(20.0), Some(1.0), Some(0.2)),
            (Some(20.0), Some(30.0), Some(3.0)),
        ] {
            let kernel = KernelShare {
                name: "a",
                dispatches: 1,
                seconds: 1.0,
                share: 1.0,
                gflops,
                gbs,
                peak_share: None,
            };
            assert_eq!(kernel.beside(peaks).peak_share, expected);
        }
    }
}
