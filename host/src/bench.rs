//! Measures a batch, forward and backward, and its kernels.

mod peak;
mod synthetic;

use std::collections::BTreeMap;
use std::time::Instant;

use serde::Serialize;

use crate::camera::Camera;
use crate::error::Result;
use crate::render::{DeviceScene, Renderer, SceneGradient};
use crate::tile::TileBatch;
use muslin::work::Work;
use muslin_device::{Device, KernelTime, memory};
use organza_core::RenderReport;

pub use peak::Peaks;
pub use synthetic::Synthetic;

/// Options of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BenchOptions {
    /// Number of timed passes, at least 1. One untimed pass before them warms up.
    pub repeat: usize,
    /// Whether to measure the backward pass as well.
    pub backward: bool,
}

/// The measurements of a batch. Times are medians over whole batches, in seconds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Benchmark {
    /// Description of the device, and the reason for its choice.
    pub device: String,
    /// Number of timed passes.
    pub repeat: usize,
    /// N, the number of Gaussians.
    pub gaussians: usize,
    /// K, the number of tiles.
    pub tiles: usize,
    /// S, in pixels.
    pub side: u32,
    /// Number of parts in which the batch was rendered.
    pub parts: usize,
    /// Number of (Gaussian, camera) pairs whose color and transmittance were evaluated.
    pub pairs: u64,
    /// Number of (Gaussian, tile) memberships.
    pub members: u64,
    /// Number of samples of the transmittance network.
    pub samples: u64,
    /// Seconds from the scene on the device to the tiles on the host.
    pub forward_s: f64,
    /// Seconds from the scene on the device to the gradients of all its tensors on the device, for dLoss/dY = 1 at
    /// every value; `None` if it was not measured.
    pub forward_backward_s: Option<f64>,
    /// Peak memory of the process until after the forward measurement, in bytes; `None` if the system does not say.
    pub forward_peak_memory_bytes: Option<u64>,
    /// Peak memory of the process until the end, in bytes; `None` if the system does not say.
    pub peak_memory_bytes: Option<u64>,
    /// Measured peak of the device, in billions of floating-point operations per second.
    pub peak_gflops: f64,
    /// Measured peak of the device, in billions of bytes read from memory per second.
    pub peak_gbs: f64,
    /// Kernels of a forward pass, the slowest first.
    pub forward_kernels: Vec<KernelShare>,
    /// Kernels of a forward and backward pass, the slowest first. Those of a forward pass if only that was measured.
    pub kernels: Vec<KernelShare>,
}

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

impl KernelShare {
    /// Adds the fraction of the device's peaks.
    fn beside(mut self, peaks: Peaks) -> Self {
        let shares = [self.gflops.map(|of| of / peaks.gflops), self.gbs.map(|of| of / peaks.gbs)];
        self.peak_share = shares.into_iter().flatten().reduce(f64::max);
        self
    }
}

/// Measures a batch. Calls `progress` after every pass; [`passes`] gives their number.
///
/// # Errors
/// The same errors as [`Renderer::render`] and [`Renderer::gradient`].
pub fn measure(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[Camera],
    batch: &TileBatch,
    options: BenchOptions,
    progress: &mut dyn FnMut(),
) -> Result<Benchmark> {
    let device = renderer.device();
    let mut report = RenderReport::default();
    let forward = time(device, options.repeat, progress, &mut || {
        report = renderer.render(scene, cameras, batch)?.report;
        Ok(())
    })?;
    let forward_peak_memory_bytes = memory::peak();
    let backward = match options.backward {
        false => None,
        true => {
            let ones = vec![1.0; batch.output_shape().iter().product()];
            // created once, as in training
            let gradient = SceneGradient::new(device, scene)?;
            let mut pass = || renderer.add_gradient(scene, cameras, batch, &ones, &gradient);
            Some(time(device, options.repeat, progress, &mut pass)?)
        }
    };
    let peak_memory_bytes = memory::peak();
    // last, because it takes additional memory
    let peaks = Peaks::measure(device)?;
    let beside = |kernels: &[KernelShare]| -> Vec<_> {
        kernels.iter().map(|kernel| kernel.clone().beside(peaks)).collect()
    };
    Ok(Benchmark {
        device: device.choice().to_owned(),
        repeat: options.repeat,
        gaussians: scene.len(),
        tiles: batch.tiles.len(),
        side: batch.side,
        parts: report.parts,
        pairs: report.pairs,
        members: report.members,
        samples: report.samples,
        forward_s: forward.seconds,
        forward_backward_s: backward.as_ref().map(|timed| timed.seconds),
        forward_peak_memory_bytes,
        peak_memory_bytes,
        peak_gflops: peaks.gflops,
        peak_gbs: peaks.gbs,
        kernels: beside(&backward.as_ref().unwrap_or(&forward).kernels),
        forward_kernels: beside(&forward.kernels),
    })
}

/// Number of passes that [`measure`] makes.
#[must_use]
pub fn passes(device: &Device, options: BenchOptions) -> usize {
    let timed = if times_apart(device) { 2 * options.repeat } else { options.repeat };
    (1 + timed) * (1 + usize::from(options.backward))
}

/// Whether kernels must be timed in separate passes, because timing may slow down a pass.
fn times_apart(device: &Device) -> bool {
    device.backend() == "gpu"
}

#[derive(Debug)]
struct Timed {
    /// The median time of whole passes.
    seconds: f64,
    kernels: Vec<KernelShare>,
}

fn time(
    device: &Device,
    repeat: usize,
    progress: &mut dyn FnMut(),
    pass: &mut dyn FnMut() -> Result<()>,
) -> Result<Timed> {
    let mut run = || -> Result<(f64, Vec<KernelTime>)> {
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
        (0..repeat).map(|_| run()).collect::<Result<Vec<_>>>()?.into_iter().unzip();
    if apart {
        device.time_dispatches(true);
        let passes: Result<Vec<_>> = (0..repeat).map(|_| run()).collect();
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
    fn a_share_of_the_peaks_is_that_of_the_nearer_one() {
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
