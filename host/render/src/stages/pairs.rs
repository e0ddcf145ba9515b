//! The (Gaussian, camera) pairs that tiles need, and sums of vectors over the pairs of a Gaussian.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::pair::{
    PairFillKernel, PairFillParams, PairMaskKernel, PairMaskParams, PairSumKernel, PairSumParams,
    SUMMED,
};

use super::cut::words;
use super::scan::Mask;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Count, Device, Result};

/// The (Gaussian, camera) pairs to evaluate.
#[derive(Debug)]
pub struct Pairs {
    pub count: Count,
    /// `camera slot * gaussians + gaussian`, ascending.
    pub pair: Buffer<u32>,
    /// Packed cameras.
    pub camera: Buffer<f32>,
    /// `[cameras, gaussians, 2]`
    pub projection: Buffer<Vec4>,
    /// Where each camera's pairs end, on a CPU; nothing elsewhere.
    pub view_ends: Vec<u32>,
}

impl Pairs {
    /// The pairs that chunks have to end with, if they are kept for gradients, which are summed view batch by view batch.
    pub fn chunk_ends(&self, keep: bool) -> &[u32] {
        if keep { &self.view_ends } else { &[] }
    }
}

/// Which Gaussians any tile of a camera needs: `[cameras, words]`.
pub fn pair_mask(
    device: &Device,
    words: u32,
    cameras: u32,
    first_tile: &Buffer<u32>,
    tile_mask: &Mask,
) -> Result<Mask> {
    let len = (cameras * words) as usize;
    let mask = device.unwritten("pair masks", len)?;
    let count = device.unwritten("pair counts", len)?;
    let kernel = PairMaskKernel {
        params: PairMaskParams { words },
        first_tile,
        tile_mask: &tile_mask.bits,
        mask: &mask,
        count: &count,
    };
    device.run(&kernel, words, cameras)?;
    Mask::new(device, mask, &count)
}

/// The pairs `[pairs]`, ascending.
pub fn fill_pairs(
    scene: &DeviceScene,
    cameras: u32,
    pair_mask: &Mask,
    count: &Count,
) -> Result<Buffer<u32>> {
    let device = scene.device();
    let words = words(scene.gaussians);
    let pair = device.unwritten("pairs", count.upper_bound() as usize)?;
    let kernel = PairFillKernel {
        params: PairFillParams { words, gaussians: scene.gaussians },
        mask: &pair_mask.bits,
        first_pair: &pair_mask.first,
        pair: &pair,
    };
    device.run(&kernel, words, cameras)?;
    Ok(pair)
}

/// Where each camera's pairs end.
pub fn view_ends(device: &Device, pair_mask: &Mask, cameras: u32, words: u32) -> Result<Vec<u32>> {
    let end = |camera| device.read_range(&pair_mask.first, (camera * words) as usize, 1);
    (1..=cameras).map(|camera| Ok(end(camera)?[0])).collect()
}

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
