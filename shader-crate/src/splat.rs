//! What the composite reads of a pair, gathered into one place.

use glam::Vec4;

use crate::math::sigmoid;
use crate::prelude::*;

/// `Vec4`s of a splat: `(mean2d, weight, 0), (conic, 0), (color, 0)`.
pub const VECTORS: u32 = 3;

/// Parameters of [`splat`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct SplatParams {
    /// Pairs in the batch.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
}

/// Gathers `splat [pairs, 3]`; the weight is `sigmoid(opacity) T`, alpha but for the falloff (Eq. 12).
#[kernel(threads(64))]
pub fn splat(
    id: Invocation,
    params: &SplatParams,
    pair: Read<u32>,
    projection: Read<Vec4>,
    opacity: Read<f32>,
    transmittance: Read<f32>,
    color: Read<f32>,
    splat: Write<Vec4>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let weight = sigmoid(opacity.read(slot % params.gaussians)) * transmittance.read(index);
        let p = projection.read(2 * slot);
        splat.write(VECTORS * index, Vec4::new(p.x, p.y, weight, 0.0));
        splat.write(VECTORS * index + 1, projection.read(2 * slot + 1));
        let c = 3 * index;
        splat.write(
            VECTORS * index + 2,
            Vec4::new(color.read(c), color.read(c + 1), color.read(c + 2), 0.0),
        );
    }
}
