//! Splats: everything that the composite reads about a pair, next to each other in memory.

use glam::{Vec3, Vec4};

use crate::limits::MAX_TILES;
use crate::shape::flatness;
use muslin::math::{sigmoid, sqrt};
use muslin::prelude::*;

/// `Vec4`s of a splat: `(mean2d, weight, extent x), (conic, extent y), (color, flatness)`.
pub const VECTORS: u32 = 3;

/// Parameters of [`splat`].
#[params]
pub struct SplatParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// The blur that weights make up for, in square pixels; 0 if they do not. See [`Compensation`].
    pub compensated_blur: f32,
    /// 1 where falloffs have [shapes](crate::shape).
    pub shaped: u32,
}

/// What a Gaussian's weight is multiplied with, so that a blur makes it wider but not heavier: the square root of
/// `det(cov2d) / det(cov2d + blur I)`, as in Mip-Splatting (Yu et al. 2024).
///
/// With the conic K, the inverse of the blurred covariance, the quotient is `det(I - blur K)`.
#[derive(Clone, Copy, Debug)]
pub struct Compensation {
    /// The factor.
    pub factor: f32,
    /// The derivative of the factor's logarithm with respect to the conic: xx, xy, yy.
    pub log_slope: Vec3,
}

/// The smallest [`Compensation::factor`]: for a Gaussian so thin that rounding decides on its quotient.
pub const MIN_COMPENSATION: f32 = 1.0 / 255.0;

impl Compensation {
    /// From a Gaussian's conic (xx, xy, yy) and a blur; 1 without a blur.
    #[inline(always)]
    pub fn new(conic: Vec3, blur: f32) -> Self {
        let x = 1.0 - blur * conic.x;
        let y = 1.0 - blur * conic.z;
        let xy = blur * conic.y;
        let quotient = x * y - xy * xy;
        let mut factor = 1.0;
        let mut log_slope = Vec3::ZERO;
        if blur > 0.0 {
            factor = MIN_COMPENSATION;
            if quotient > MIN_COMPENSATION * MIN_COMPENSATION {
                factor = sqrt(quotient);
                log_slope = Vec3::new(y, 2.0 * xy, x) * (-0.5 * blur / quotient);
            }
        }
        Self { factor, log_slope }
    }
}

/// Gathers `splat [pairs, 3]`; the weight is `sigmoid(opacity) T`, alpha but for the falloff (Eq. 12), times the
/// [`Compensation`] if the scene has one. `shape [gaussians]` is read only if falloffs have shapes; without, they are not flat at all: 0.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn splat(
    id: Invocation,
    params: &SplatParams,
    pair: Read<u32>,
    projection: Read<Vec4>,
    opacity: Read<f32>,
    transmittance: Read<f32>,
    color: Read<f32>,
    shape: Read<f32>,
    splat: Write<Vec4>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let weight = sigmoid(opacity.read(slot % params.gaussians)) * transmittance.read(index);
        let p = projection.read(2 * slot);
        let conic = projection.read(2 * slot + 1);
        let compensated = Vec3::new(conic.x, conic.y, conic.z);
        let compensation = Compensation::new(compensated, params.compensated_blur);
        let mut k = 0.0;
        if params.shaped != 0 {
            k = flatness(shape.read(slot % params.gaussians));
        }
        splat.write(VECTORS * index, Vec4::new(p.x, p.y, weight * compensation.factor, p.w));
        splat.write(VECTORS * index + 1, conic);
        let c = 3 * index;
        splat.write(
            VECTORS * index + 2,
            Vec4::new(color.read(c), color.read(c + 1), color.read(c + 2), k),
        );
    }
}

/// Parameters of [`splat_backward`] and [`slope_backward`](crate::slope::slope_backward()).
#[params]
pub struct SplatBackwardParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Words of a tile's mask.
    pub words: u32,
}

/// Sums `intersection_gradient [intersections, 3]` over the tiles of a pair's camera, in ascending order, and goes on through the
/// weight: `pair_gradient [pairs, 3]` is `(d mean2d x, y, d opacity logit, dL/dT), (d conic xx, xy, yy, 0), (d color, d shape)`.
///
/// Of Eq. 12's `opacity = sigmoid(logit)`: `dL/dlogit = dL/dweight T s (1 - s)` and `dL/dT = dL/dweight s`.
#[kernel(threads(64), over(params.pairs), iterations = MAX_TILES, counts(pairs))]
pub fn splat_backward(
    id: Invocation,
    params: &SplatBackwardParams,
    pair: Read<u32>,
    first_tile: Read<u32>,
    tile_mask: Read<u32>,
    first_intersection: Read<u32>,
    opacity: Read<f32>,
    transmittance: Read<f32>,
    intersection_gradient: Read<Vec4>,
    pair_gradient: Write<Vec4>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let camera = slot / params.gaussians;
        let gaussian = slot % params.gaussians;
        let word = gaussian / 32;
        let bit = 1 << (gaussian % 32);
        let mut geometry = Vec4::ZERO;
        let mut conic = Vec4::ZERO;
        let mut color = Vec4::ZERO;
        let end = first_tile.read(camera + 1);
        let mut tile = first_tile.read(camera);
        while tile < end {
            let bits = tile_mask.read(tile * params.words + word);
            if bits & bit != 0 {
                let below = (bits & (bit - 1)).count_ones();
                let first = VECTORS * (first_intersection.read(tile * params.words + word) + below);
                geometry += intersection_gradient.read(first);
                conic += intersection_gradient.read(first + 1);
                color += intersection_gradient.read(first + 2);
            }
            tile += 1;
        }
        let logit = opacity.read(gaussian);
        let by_transmittance = geometry.z * sigmoid(logit);
        // 1 - sigmoid(x) = sigmoid(-x), without its cancellation
        let by_logit = by_transmittance * transmittance.read(index) * sigmoid(-logit);
        let first = VECTORS * index;
        let geometry = Vec4::new(geometry.x, geometry.y, by_logit, by_transmittance);
        pair_gradient.write(first, geometry);
        pair_gradient.write(first + 1, conic);
        pair_gradient.write(first + 2, color);
    }
}
