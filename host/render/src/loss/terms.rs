//! Terms of the loss that look at weighted sums of other values of each pair than its color.

use organza_shaders::distortion::{
    DistortionBackwardKernel, DistortionParams, PairInverseDistanceKernel,
    PairInverseDistanceParams,
};

use crate::stages::composite::{CompositedTerm, TileContext};
use muslin_device::{Buffer, Result};

impl CompositedTerm {
    /// The distortion, which reduces haze. [`organza_shaders::distortion`] has the formula.
    pub fn distortion(weight: f32) -> Self {
        Self { weight, values: powers, backward: distortion_backward }
    }
}

/// u, u^2 and 0 of each pair, `[pairs, 3]`: their weighted sums are M_1 and M_2.
pub fn powers(TileContext { scene, bins, .. }: TileContext<'_>) -> Result<Buffer<f32>> {
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
    Ok(power)
}

/// The derivative of the distortion by M_1, M_2, 0 and S of each pixel: `[tiles, 4, S, S]`.
fn distortion_backward(
    TileContext { scene, bins, .. }: TileContext<'_>,
    sum: &Buffer<f32>,
    valid: &Buffer<f32>,
    scale: f32,
) -> Result<Buffer<f32>> {
    let device = scene.device();
    let side = bins.side;
    let sum_gradient = device.unwritten("gradient of the distortion's sums", sum.len())?;
    let kernel = DistortionBackwardKernel {
        params: DistortionParams { side, scale },
        tile: &bins.tile,
        sum,
        valid,
        sum_gradient: &sum_gradient,
    };
    device.run_over(&kernel, [side, side, bins.tiles])?;
    Ok(sum_gradient)
}
