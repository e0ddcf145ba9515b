//! Vectors of pairs, and their sums over the pairs of a Gaussian.

use std::ops::Range;

use organza_shaders::pair::{PairSumKernel, PairSumParams, SUMMED};

use super::mask::Mask;
use crate::batch::plan::words;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Result};

/// A vector for each pair.
#[derive(Debug)]
pub struct PairVectors {
    /// `[pairs, width]`
    pub values: Buffer<f32>,
    /// Values of a vector.
    pub width: u32,
}

impl PairVectors {
    /// Adds the vectors of every Gaussian's pairs in some of a part's cameras to `vector [gaussians, width]`.
    pub fn sum(
        &self,
        scene: &DeviceScene,
        mask: &Mask,
        cameras: &Range<u32>,
        vector: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = PairSumKernel {
            params: PairSumParams {
                words: words(scene.gaussians),
                first_camera: cameras.start,
                cameras: cameras.end - cameras.start,
                gaussians: scene.gaussians,
                width: self.width,
            },
            mask: &mask.bits,
            first_pair: &mask.first,
            pair_vector: &self.values,
            vector,
        };
        scene.device().run(&kernel, scene.gaussians * self.width.div_ceil(SUMMED), 1)
    }
}
