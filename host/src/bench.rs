//! How long a batch takes, forward and back again, and which kernels take it.

mod peak;
mod synthetic;

use std::collections::BTreeMap;
use std::time::Instant;

use serde::Serialize;

use crate::camera::Camera;
use crate::error::Result;
use crate::render::{DeviceScene, RenderReport, Renderer, SceneGradient};
use crate::tile::TileBatch;
use organza_device::{Device, KernelTime, memory};
use organza_kernel::work::Work;

pub use peak::Peaks;
pub use synthetic::Synthetic;

/// What to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BenchOptions {
    /// Passes that are timed; one before them warms up and is not. At least 1.
    pub repeat: usize,
    /// Whether to go back as well.
    pub backward: bool,
}

/// What a batch has taken. Times are medians of whole batches, in seconds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Benchmark {
    /// The device, and why it was taken.
    pub device: String,
    /// Passes that were timed.
    pub repeat: usize,
    /// N
    pub gaussians: usize,
    /// K
    pub tiles: usize,
    /// S, in pixels.
    pub side: u32,
    /// Parts that the batch was rendered in.
    pub parts: usize,
    /// (Gaussian, camera) pairs whose color and transmittance were evaluated.
    pub pairs: u64,
    /// (Gaussian, tile) memberships.
    pub members: u64,
    /// Samples of the transmittance network.
    pub samples: u64,
    /// From the scene on the device to the tiles on the host.
    pub forward_s: f64,
    /// From the scene on the device to the gradients of all its tensors on the device, for dLoss/dY = 1 at every value;
    /// `None` if that was not measured.
    pub forward_backward_s: Option<f64>,
    /// The most memory that the process held until forward was measured, in bytes; `None` if the system does not say.
    pub forward_peak_memory_bytes: Option<u64>,
    /// The same until the end.
    pub peak_memory_bytes: Option<u64>,
    /// The device's measured peak: billions of floating-point operations a second.
    pub peak_gflops: f64,
    /// The device's measured peak: billions of bytes that are read from memory in a second.
    pub peak_gbs: f64,
    /// What kernels have taken of a forward pass, the slowest first.
    pub forward_kernels: Vec<KernelShare>,
    /// What kernels have taken of a pass forward and backward, the slowest first; of a forward pass where that was not
    /// measured.
    pub kernels: Vec<KernelShare>,
}

/// What the dispatches of a kernel take in a pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct KernelShare {
    /// The kernel.
    pub name: &'static str,
    /// Dispatches of a pass.
    pub dispatches: u64,
    /// Seconds of all of a pass' dispatches, the median over passes.
    pub seconds: f64,
    /// `seconds` as a part of the same of all kernels together, 0 to 1.
    pub share: f64,
    /// Billions of floating-point operations a second, as [`Work`] counts them; `None` if it does not.
    pub gflops: Option<f64>,
    /// Billions of bytes a second, as [`Work`] counts them; `None` if it does not.
    pub gbs: Option<f64>,
    /// The larger of the shares of the device's two peaks. What stays in caches may pass 1.
    pub peak_share: Option<f64>,
}

impl KernelShare {
    /// With what a device has at most beside what was found.
    fn beside(mut self, peaks: Peaks) -> Self {
        let shares = [self.gflops.map(|of| of / peaks.gflops), self.gbs.map(|of| of / peaks.gbs)];
        self.peak_share = shares.into_iter().flatten().reduce(f64::max);
        self
    }
}

/// Measures a batch. Calls `progress` after every pass, of which there are [`passes`].
///
/// # Errors
/// Like [`Renderer::render`] and [`Renderer::gradient`].
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
            // made once, as in training
            let gradient = SceneGradient::new(device, scene)?;
            let mut pass = || renderer.add_gradient(scene, cameras, batch, &ones, &gradient);
            Some(time(device, options.repeat, progress, &mut pass)?)
        }
    };
    let peak_memory_bytes = memory::peak();
    // last, for it takes memory of its own
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

/// How many passes [`measure`] makes.
#[must_use]
pub fn passes(device: &Device, options: BenchOptions) -> usize {
    let timed = if times_apart(device) { 2 * options.repeat } else { options.repeat };
    (1 + timed) * (1 + usize::from(options.backward))
}

/// Whether the kernels' times must be taken in passes of their own, for they may make a pass take longer.
fn times_apart(device: &Device) -> bool {
    device.backend() == "gpu"
}

#[derive(Debug)]
struct Timed {
    /// The median of whole passes.
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
        (*dispatches, *work) = (time.dispatches, time.work);
        seconds.push(time.seconds);
    }
    let mut shares: Vec<_> = times
        .into_iter()
        .map(|(name, (dispatches, work, seconds))| {
            let seconds = median(seconds);
            let rate = |of: u64| (of > 0 && seconds > 0.0).then(|| of as f64 / seconds / 1e9);
            let (gflops, gbs) = (rate(work.flops), rate(work.bytes));
            KernelShare { name, dispatches, seconds, share: 0.0, gflops, gbs, peak_share: None }
        })
        .collect();
    let all: f64 = shares.iter().map(|kernel| kernel.seconds).sum();
    shares.iter_mut().for_each(|kernel| kernel.share = kernel.seconds / all.max(f64::MIN_POSITIVE));
    shares.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    shares
}

/// The one in the middle, or the mean of the two.
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
            let (gflops, gbs) = (None, Some(6.0 / seconds));
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
