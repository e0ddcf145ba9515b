//! The distortion of a pixel, a term of the loss: how far apart the Gaussians of its weighted sum are.
//!
//! With the weights `alpha_i` of Eq. 12 and the inverse distances `u_i` of the Gaussians' centers from the eye, let
//! `M_n = sum_i alpha_i u_i^n`, so that `M_0` is S. The distortion is `min(S, 1)^2 (S M_2 / M_1^2 - 1)`: the variance of u
//! relative to its squared mean, less where the background shows. It is what Mip-NeRF 360 (Barron et al. 2022, Eq. 15) asks of
//! a ray, with squares instead of absolute differences, as in 2D Gaussian Splatting (Huang et al. 2024):
//! `S M_2 - M_1^2 = sum_ij alpha_i alpha_j (u_i - u_j)^2 / 2`.
//!
//! The sums come from [`composite`](crate::composite), which takes `(u, u^2, 0)` in the place of a color. The gradient holds
//! distances constant: what lies in the wrong place should lose its weight.

use crate::camera::{Camera, read3};
use crate::composite::SUM_PLANES;
use crate::tile::Tile;
use muslin::math::{TINY, dot, sqrt};
use muslin::prelude::*;

/// Distances from the eye, in world units, are at least this.
pub const MIN_DISTANCE: f32 = 1e-6;

/// Parameters of [`pair_inverse_distance`].
#[params]
pub struct PairInverseDistanceParams {
    /// Pairs in the batch.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
}

/// Writes, for each pair, `power [pairs, 3]`: u, u^2 and 0.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn pair_inverse_distance(
    id: Invocation,
    params: &PairInverseDistanceParams,
    pair: Read<u32>,
    camera: Read<f32>,
    position: Read<f32>,
    power: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let camera = Camera::read(camera, slot / params.gaussians);
        let offset = read3(position, slot % params.gaussians * 3) - camera.eye;
        let distance = sqrt(dot(offset, offset));
        let u = 1.0 / if distance > MIN_DISTANCE { distance } else { MIN_DISTANCE };
        power.write(3 * index, u);
        power.write(3 * index + 1, u * u);
        power.write(3 * index + 2, 0.0);
    }
}

/// Parameters of [`distortion_backward`].
#[params]
pub struct DistortionParams {
    /// S, in pixels.
    pub side: u32,
    /// Factor of a pixel's distortion in the loss: the weight of the term, divided by the number of pixels that count.
    pub scale: f32,
}

/// The derivative of the distortion: `sum_gradient [tiles, 4, S, S]`, by M_1, by M_2, 0 and by S, of `sum [tiles, 4, S, S]` and
/// `valid [K, S, S]`, which is 0 where a pixel does not count. Pixels along x and y, tiles along z.
///
/// With `s = min(S, 1)`: `dL/dM_2 = s^2 S / M_1^2`, `dL/dM_1 = -2 s^2 S M_2 / M_1^3`, and `dL/dS = M_2 / M_1^2` where S
/// passes 1, `3 S^2 M_2 / M_1^2 - 2 S` where it does not; all times the scale.
#[kernel(threads(16, 4), over(params.side, params.side, tile.len() / 4), lanes(side))]
pub fn distortion_backward<L: Lane>(
    id: Invocation,
    params: &DistortionParams,
    tile: Read<i32>,
    sum: Read<f32>,
    valid: Read<f32>,
    sum_gradient: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let t = id.workgroup.z;
        let at = place.y * params.side + place.x;
        let area = params.side * params.side;
        let first = t * SUM_PLANES * area + at;
        let m1 = L::read(sum, first);
        let m2 = L::read(sum, first + area);
        let weight = L::read(sum, first + 3 * area);
        let counts = L::read(valid, Tile::read(tile, t).output * area + at);
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        // without a weight nothing is divided
        let tiny = L::splat(TINY);
        let is_seen = L::both(tiny.less_equal(weight), tiny.less_equal(m1));
        let per_weight = one / L::select(is_seen, weight, one);
        let distance = one / L::select(is_seen, m1 * per_weight, one);
        let scale = L::select(is_seen, counts * L::splat(params.scale), zero);
        let is_covered = one.less(weight);
        // s^2 / S, and S M_2 / M_1^2
        let share = L::select(is_covered, per_weight, weight);
        let spread = m2 * per_weight * distance * distance;
        let by_m2 = scale * share * distance * distance;
        let by_m1 = L::splat(-2.0) * scale * share * spread * distance;
        let partial = weight * (L::splat(3.0) * spread - L::splat(2.0));
        let by_weight = scale * L::select(is_covered, spread * per_weight, partial);
        by_m1.write(sum_gradient, first);
        by_m2.write(sum_gradient, first + area);
        zero.write(sum_gradient, first + 2 * area);
        by_weight.write(sum_gradient, first + 3 * area);
    }
}
