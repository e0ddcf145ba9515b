//! The loss of a rendered batch, `(1 - w) |x - y| + w (1 - SSIM)`: the mean over the valid pixels of all tiles and their three
//! channels, and its gradient with respect to the image (Kerbl et al. 2023, Eq. 7).
//!
//! x is `image [K, 3, S, S]`, y `target [K, 3, S, S]`, both with colors about 0 to 1. `valid [K, S, S]` is 1 where the
//! photograph has a pixel and 0 elsewhere. Values at masked pixels have no influence, even NaN.

use glam::Vec4;

use crate::limits::MAX_TILE_SIDE;
use crate::ssim::{SLOPES, Taps, WINDOW};
use muslin::atomic;
use muslin::count::OVERFLOW;
use muslin::math::{TINY, abs, is_finite};
use muslin::prelude::*;

/// Parameters of [`loss_terms`] and [`loss_rows`].
#[params]
pub struct LossParams {
    /// S, in pixels.
    pub side: u32,
    /// K
    pub tiles: u32,
}

/// Gathers what all other kernels read: pixels along x and y, tiles along z.
///
/// `difference [K, S, S]` is (d, m) and `sum [K, S, S]` is (s, 0), for the three channels of [`crate::ssim`]'s
/// `d = x - y` and `s = (x - 1/2) + (y - 1/2)`; all is 0 where the mask m is.
#[kernel(threads(8, 8), over(params.side, params.side, params.tiles))]
pub fn loss_terms(
    id: Invocation,
    params: &LossParams,
    image: Read<f32>,
    target: Read<f32>,
    valid: Read<f32>,
    difference: Write<Vec4>,
    sum: Write<Vec4>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let area = params.side * params.side;
        let tile = id.workgroup.z;
        let pixel = place.y * params.side + place.x;
        let at = tile * area + pixel;
        let mut d = Vec4::ZERO;
        let mut s = Vec4::ZERO;
        // a branch, not a product: what is masked may be infinite
        if valid.read(at) > 0.0 {
            let r = tile * 3 * area + pixel;
            let g = r + area;
            let b = r + 2 * area;
            let half = Vec4::new(0.5, 0.5, 0.5, 0.0);
            let x = Vec4::new(image.read(r), image.read(g), image.read(b), 1.0);
            let y = Vec4::new(target.read(r), target.read(g), target.read(b), 0.0);
            d = x - y;
            s = (x - half) + (y - half);
            s.w = 0.0;
        }
        difference.write(at, d);
        sum.write(at, s);
    }
}

/// Sums of rows of pixels: `row_sum [K, S]` is `(|d|, 1 - SSIM, d^2, m)`, the first three over all channels.
///
/// `difference [K, S, S]` of [`loss_terms`], `dissimilarity [K, S, S]` of
/// [`ssim_columns`](crate::ssim::ssim_columns). Rows along x and y; the host adds them up, so that the order is
/// always the same.
#[kernel(threads(64), over(params.tiles * params.side), iterations = MAX_TILE_SIDE)]
pub fn loss_rows(
    id: Invocation,
    params: &LossParams,
    difference: Read<Vec4>,
    dissimilarity: Read<f32>,
    row_sum: Write<Vec4>,
) {
    let row = id.index();
    if row < params.tiles * params.side {
        let mut total = Vec4::ZERO;
        let mut next = row * params.side;
        let end = next + params.side;
        while next < end {
            let d = difference.read(next);
            total += Vec4::new(
                abs(d.x) + abs(d.y) + abs(d.z),
                dissimilarity.read(next),
                d.x * d.x + d.y * d.y + d.z * d.z,
                d.w,
            );
            next += 1;
        }
        row_sum.write(row, total);
    }
}

/// Parameters of [`loss_check`].
#[params]
pub struct LossCheckParams {
    /// Rows of all tiles.
    pub rows: u32,
}

/// Raises [`OVERFLOW`] if a loss is not finite: the first two sums of some row of [`loss_rows`]. Rows along x.
#[kernel(threads(64), over(params.rows))]
pub fn loss_check(
    id: Invocation,
    params: &LossCheckParams,
    row_sum: Read<Vec4>,
    counts: Write<u32>,
) {
    let row = id.index();
    if row < params.rows {
        let sum = row_sum.read(row);
        if !(is_finite(sum.x) && is_finite(sum.y)) {
            atomic::raise(counts, OVERFLOW, 1);
        }
    }
}

/// Parameters of [`loss_gradient`].
#[params]
pub struct LossGradientParams {
    /// S, in pixels.
    pub side: u32,
    /// `(1 - w) / 3n`, for n valid pixels in the batch.
    pub absolute_scale: f32,
    /// `w / 3n`
    pub ssim_scale: f32,
}

/// -1, 0 or 1: the derivative of |x|. It is 0 at 0, and at numbers that a GPU can flush to 0.
#[inline(always)]
pub fn sign(x: f32) -> f32 {
    if x >= TINY {
        1.0
    } else if x <= -TINY {
        -1.0
    } else {
        0.0
    }
}

/// `grad_image [K, 3, S, S]`, the derivative of the batch's loss with respect to the image: pixels along x and y, tiles
/// along z.
///
/// Completes the adjoint of the windows along columns: `row_slopes [K, S, S, 3]` of
/// [`ssim_rows_backward`](crate::ssim::ssim_rows_backward), `difference` and `sum [K, S, S]` of [`loss_terms`].
#[kernel(threads(8, 8), over(params.side, params.side, difference.len() / (params.side * params.side)), iterations = WINDOW)]
pub fn loss_gradient(
    id: Invocation,
    params: &LossGradientParams,
    window: Read<f32>,
    difference: Read<Vec4>,
    sum: Read<Vec4>,
    row_slopes: Read<Vec4>,
    grad_image: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let area = params.side * params.side;
        let tile = id.workgroup.z * area;
        let taps = Taps::around(place.y, params.side);
        let mut constant = Vec4::ZERO;
        let mut by_difference = Vec4::ZERO;
        let mut by_sum = Vec4::ZERO;
        let mut weight = taps.weight;
        let mut next = (tile + taps.first * params.side + place.x) * SLOPES;
        let end = (tile + taps.end * params.side + place.x) * SLOPES;
        while next < end {
            let w = window.read(weight);
            constant += row_slopes.read(next) * w;
            by_difference += row_slopes.read(next + 1) * w;
            by_sum += row_slopes.read(next + 2) * w;
            weight += 1;
            next += params.side * SLOPES;
        }
        let pixel = place.y * params.side + place.x;
        let d = difference.read(tile + pixel);
        let slope =
            (constant + d * by_difference + sum.read(tile + pixel) * by_sum) * params.ssim_scale;
        let absolute = params.absolute_scale;
        let first = tile * 3 + pixel;
        // the mask; d is 0 where the mask is
        let m = d.w;
        grad_image.write(first, m * (slope.x + absolute * sign(d.x)));
        grad_image.write(first + area, m * (slope.y + absolute * sign(d.y)));
        grad_image.write(first + 2 * area, m * (slope.z + absolute * sign(d.z)));
    }
}
