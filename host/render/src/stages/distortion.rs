//! The distortion of a part's pixels, a term of its loss beside the image's. [`organza_shaders::distortion`] has the formula.

use organza_shaders::distortion::{
    DistortionBackwardKernel, DistortionParams, PairInverseDistanceKernel,
    PairInverseDistanceParams,
};

use super::composite::{Seen, weighted_sum};
use glam::Vec4;
use muslin_device::{Buffer, Result};

/// The pixels of a part whose distortion counts in the loss, and its weight.
#[derive(Debug)]
pub struct Distortion {
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: Buffer<f32>,
    /// The term's weight, divided by the number of valid pixels of the batch.
    pub scale: f32,
}

impl Distortion {
    /// The derivative: `sum_gradient [tiles, 4, S, S]`, and the splats of the [`sums`] that it belongs to.
    pub fn backward(&self, seen: Seen<'_>) -> Result<(Buffer<f32>, Buffer<Vec4>)> {
        let Seen { scene, side, bins, .. } = seen;
        let device = scene.device();
        let (sum, splat) = sums(seen)?;
        let sum_gradient = device.unwritten("gradient of the distortion's sums", sum.len())?;
        let kernel = DistortionBackwardKernel {
            params: DistortionParams { side, scale: self.scale },
            tile: &bins.tile,
            sum: &sum,
            valid: &self.valid,
            sum_gradient: &sum_gradient,
        };
        device.run_over(&kernel, [side, side, bins.tiles])?;
        Ok((sum_gradient, splat))
    }
}

/// M_1, M_2, 0 and S of each pixel, `[tiles, 4, S, S]`; and the splats `[pairs, 3]` that they are the sums of, with u, u^2 and 0
/// in the place of a color.
pub fn sums(seen: Seen<'_>) -> Result<(Buffer<f32>, Buffer<Vec4>)> {
    let Seen { scene, bins, .. } = seen;
    let device = scene.device();
    let pairs = &bins.pairs;
    let capacity = pairs.count.upper_bound();
    let power = device.unwritten("powers of inverse distances", 3 * capacity as usize)?;
    let kernel = PairInverseDistanceKernel {
        params: PairInverseDistanceParams { pairs: capacity, gaussians: scene.gaussians },
        pair: &pairs.pair,
        camera: &pairs.camera,
        position: &scene.tensors.gaussians.position,
        power: &power,
    };
    device.run(&kernel.counted(&pairs.count), capacity, 1)?;
    weighted_sum(seen, &power)
}
