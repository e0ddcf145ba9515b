//! Sums over the pairs of a Gaussian.

use std::ops::Range;

use organza_shaders::pair::{PairSumKernel, PairSumParams, SUMMED};

use super::mask::Mask;
use super::plan::words;
use super::scene::DeviceScene;
use organza_device::{Buffer, Device, Result};

/// Adds the vectors of every Gaussian's pairs in some of a part's cameras, `pair_vector [pairs, width]`, to `vector
/// [gaussians, width]`.
pub fn sum_pairs(
    device: &Device,
    scene: &DeviceScene,
    mask: &Mask,
    cameras: &Range<u32>,
    width: u32,
    pair_vector: &Buffer<f32>,
    vector: &Buffer<f32>,
) -> Result<()> {
    let kernel = PairSumKernel {
        params: PairSumParams {
            words: words(scene.gaussians),
            first_camera: cameras.start,
            cameras: cameras.end - cameras.start,
            gaussians: scene.gaussians,
            width,
        },
        mask: &mask.bits,
        first_pair: &mask.first,
        pair_vector,
        vector,
    };
    device.run(&kernel, scene.gaussians * width.div_ceil(SUMMED), 1)
}
