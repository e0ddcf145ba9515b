//! The kernels' host: what it takes to run them on a device.

use organza_device::{Device, Modules, Result};
use picture_kernels::{BINS, HistogramKernel, Picture, RipplesKernel, TintKernel};

/// The compiled kernels, for [`Device::open`].
pub static MODULES: Modules = organza_device::modules!();

/// A picture `[1, 3, side, side]`, and its histogram.
pub fn picture(device: &Device, side: u32) -> Result<(Vec<f32>, Vec<u32>)> {
    let params = Picture { side, pixels: side * side };
    let brightness = device.unwritten("brightness", params.pixels as usize)?;
    let color = device.unwritten("color", 3 * params.pixels as usize)?;
    let bins = device.zeros("bins", BINS)?;
    device.run_over(&RipplesKernel { params, brightness: &brightness }, [side, side, 1])?;
    let histogram = HistogramKernel { params, brightness: &brightness, bins: &bins };
    device.run(&histogram, params.pixels, 1)?;
    let tint = TintKernel { params, brightness: &brightness, color: &color };
    device.run(&tint, params.pixels, 1)?;
    Ok((device.read(&color)?, device.read(&bins)?))
}
