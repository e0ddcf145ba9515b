//! The time of kernels.

use std::collections::BTreeMap;
use std::time::Instant;

use muslin_device::{Device, KernelTime, Modules, Result, Table, grouped};
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
    let mut times: BTreeMap<&'static str, (u64, Vec<f64>)> = BTreeMap::new();
    for time in passes.iter().flatten() {
        let (dispatches, seconds) = times.entry(time.kernel).or_default();
        *dispatches = time.dispatches;
        seconds.push(time.seconds);
    }
    let mut shares: Vec<_> = times
        .into_iter()
        .map(|(name, (dispatches, seconds))| KernelShare {
            name,
            dispatches,
            seconds: median(seconds),
            share: 0.0,
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
    let titles = ["kernel", "dispatches", "seconds", "share"];
    let mut table = Table::new(1, titles);
    for kernel in kernels {
        table.row([
            kernel.name.to_owned(),
            grouped(kernel.dispatches),
            seconds(kernel.seconds),
            format!("{:.1}%", 100.0 * kernel.share),
        ]);
    }
    table
}

/// A time, to the microsecond.
#[must_use]
pub fn seconds(seconds: f64) -> String {
    format!("{seconds:.6}")
}

/// Runs a pass on the CPU and on each GPU, and prints the time of each of its kernels. Call it in
/// an ignored test. The passes should keep the device busy.
///
/// # Panics
/// If a pass fails.
pub fn bench(modules: &'static Modules, mut pass: impl FnMut(&Device) -> Result<()>) {
    for (_, device) in devices::all(modules) {
        let result = time(&device, REPEAT, &mut || {}, &mut || pass(&device));
        let timed = result.unwrap_or_else(|error| panic!("{}: {error}", device.choice()));
        let whole = seconds(timed.seconds);
        println!("{}\n{whole} s\n\n{}", device.choice(), table(&timed.kernels));
    }
}

/// Passes of [`bench`].
const REPEAT: usize = 5;

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
        let time = |kernel, dispatches, seconds| KernelTime { kernel, dispatches, seconds };
        let passes = [
            vec![time("a", 2, 1.0), time("b", 5, 3.0)],
            vec![time("a", 2, 50.0), time("b", 5, 3.0)],
            vec![time("a", 2, 1.0), time("b", 5, 2.0)],
        ];
        let found = shares(&passes);
        let share =
            |name, dispatches, seconds, share| KernelShare { name, dispatches, seconds, share };
        assert_eq!(found, [share("b", 5, 3.0, 0.75), share("a", 2, 1.0, 0.25)]);
    }
}
