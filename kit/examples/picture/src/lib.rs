//! The kernels' host: what it takes to run them on a device.

use muslin::device::{Device, Modules, Result};
use picture_kernels::{BINS, HistogramKernel, Picture, RipplesKernel, TintKernel};

/// The compiled kernels, for [`Device::open`].
pub static MODULES: Modules = muslin::device::modules!();

/// Ripples `[side, side]`.
pub fn draw_ripples(device: &Device, side: u32) -> Result<Vec<f32>> {
    let params = Picture { side, pixels: side * side };
    let gray = device.unwritten("gray", params.pixels as usize)?;
    device.run_all(&RipplesKernel { params, gray: &gray })?;
    device.read(&gray)
}

/// A picture `[1, 3, side, side]` of all three kernels, and its histogram.
pub fn picture(device: &Device, side: u32) -> Result<(Vec<f32>, Vec<u32>)> {
    let params = Picture { side, pixels: side * side };
    let gray = device.unwritten("gray", params.pixels as usize)?;
    let color = device.unwritten("color", 3 * params.pixels as usize)?;
    let bins = device.zeros("bins", BINS)?;
    device.run_all(&RipplesKernel { params, gray: &gray })?;
    device.run_all(&HistogramKernel { params, gray: &gray, bins: &bins })?;
    device.run_all(&TintKernel { params, gray: &gray, color: &color })?;
    Ok((device.read(&color)?, device.read(&bins)?))
}
