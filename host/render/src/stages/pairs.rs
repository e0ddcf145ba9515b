//! The (Gaussian, camera) pairs that tiles need, and sums of vectors over the pairs of a Gaussian.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::pair::{
    PairFillKernel, PairFillParams, PairMaskKernel, PairMaskParams, PairSumKernel, PairSumParams,
};

use super::cut::words;
use super::scan::Mask;
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Count, Device, Result};

/// The (Gaussian, camera) pairs to evaluate.
#[derive(Debug)]
pub struct Pairs {
    pub count: Count,
    /// The slot of each pair, `camera * gaussians + gaussian`, ascending.
    pub pair: Buffer<u32>,
    /// Packed cameras.
    pub camera: Buffer<f32>,
    /// `[cameras, gaussians, 2]`
    pub projection: Buffer<Vec4>,
    /// The end of each camera's pairs on a CPU; empty on a GPU.
    pub camera_ends: Vec<u32>,
}

impl Pairs {
    /// The same pairs, with packed cameras in other coordinates.
    pub fn with_cameras(&self, camera: Buffer<f32>) -> Self {
        Self {
            count: self.count.clone(),
            pair: self.pair.view(),
            camera,
            projection: self.projection.view(),
            camera_ends: self.camera_ends.clone(),
        }
    }

    /// Where chunks must end. With `keep`, at the end of each camera's pairs, because gradients are summed camera by camera.
    pub fn chunk_ends(&self, keep: bool) -> &[u32] {
        if keep { &self.camera_ends } else { &[] }
    }
}

/// For each camera, a mask of the Gaussians in any of its tiles: `[cameras, words]`.
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
    device.run_all(&kernel)?;
    Mask::new(device, mask, &count)
}

/// The slots of the pairs, `[pairs]`, ascending.
pub fn fill_pairs(scene: &DeviceScene, pair_mask: &Mask, count: &Count) -> Result<Buffer<u32>> {
    let device = scene.device();
    let words = words(scene.gaussians);
    let pair = device.unwritten("pairs", count.upper_bound() as usize)?;
    let kernel = PairFillKernel {
        params: PairFillParams { words, gaussians: scene.gaussians },
        mask: &pair_mask.bits,
        first_pair: &pair_mask.first,
        pair: &pair,
    };
    device.run_all(&kernel)?;
    Ok(pair)
}

/// The end of each camera's pairs.
pub fn camera_ends(
    device: &Device,
    pair_mask: &Mask,
    cameras: u32,
    words: u32,
) -> Result<Vec<u32>> {
    let end = |camera| device.read_range(&pair_mask.first, (camera * words) as usize, 1);
    (1..=cameras).map(|camera| Ok(end(camera)?[0])).collect()
}

/// A vector for each pair.
#[derive(Debug)]
pub struct PairVectors {
    /// `[pairs, width]`
    pub values: Buffer<f32>,
    /// Length of a vector.
    pub width: u32,
}

impl PairVectors {
    /// Adds each Gaussian's pair vectors, over a range of the part's cameras, to `vector [gaussians, width]`.
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
        scene.device().run_all(&kernel)
    }
}
