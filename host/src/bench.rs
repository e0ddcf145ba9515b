//! Measures a batch, forward and backward, and its kernels.

use serde::Serialize;

use crate::camera::Camera;
use crate::error::Result;
use crate::image::Image;
use crate::render::{DeviceScene, Renderer, SceneGradient};
use crate::tile::TileBatch;
use muslin_check::bench::{self, time};
use muslin_device::{Device, memory};
use organza_core::RenderReport;

pub use muslin_check::bench::KernelShare;

/// Options of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BenchOptions {
    /// Number of timed passes, at least 1. One untimed pass before them warms up.
    pub repeat: usize,
    /// Whether to measure the backward pass as well.
    pub backward: bool,
    /// Whether to measure an image of the first camera, with 8 bits a channel, instead of tiles.
    pub frame: bool,
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
    /// The work of rendering the batch.
    #[serde(flatten)]
    pub report: RenderReport,
    /// Seconds from the scene on the device to the tiles on the host, or to the image.
    pub forward_s: f64,
    /// Seconds from the scene on the device to the gradients of all its tensors on the device, for dL/dY = 1 at
    /// every value; `None` if it was not measured.
    pub forward_backward_s: Option<f64>,
    /// Peak memory of the process until after the forward measurement, in bytes; `None` if the system does not say.
    pub forward_peak_memory_bytes: Option<u64>,
    /// Peak memory of the process until the end, in bytes; `None` if the system does not say.
    pub peak_memory_bytes: Option<u64>,
    /// Kernels of a forward pass, the slowest first.
    pub forward_kernels: Vec<KernelShare>,
    /// Kernels of a forward and backward pass, the slowest first; of a forward pass alone if only that was measured.
    pub kernels: Vec<KernelShare>,
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
    let forward = if options.frame {
        let mut image = Image::new(cameras[0].width, cameras[0].height)?;
        let mut pass = || {
            let painted = renderer.paint(&mut image, scene, cameras, batch, &mut |_, _| {});
            painted.map(|found| report = found)
        };
        time(device, options.repeat, progress, &mut pass)?
    } else {
        let mut pass = || renderer.render(scene, cameras, batch).map(|tiles| report = tiles.report);
        time(device, options.repeat, progress, &mut pass)?
    };
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
    Ok(Benchmark {
        device: device.choice().to_owned(),
        repeat: options.repeat,
        gaussians: scene.len(),
        tiles: batch.tiles.len(),
        side: batch.side,
        report,
        forward_s: forward.seconds,
        forward_backward_s: backward.as_ref().map(|timed| timed.seconds),
        forward_peak_memory_bytes,
        peak_memory_bytes,
        kernels: backward.as_ref().unwrap_or(&forward).kernels.clone(),
        forward_kernels: forward.kernels,
    })
}

/// Number of passes that [`measure`] makes.
pub fn passes(device: &Device, options: BenchOptions) -> usize {
    bench::passes(device, options.repeat) * (1 + usize::from(options.backward))
}
