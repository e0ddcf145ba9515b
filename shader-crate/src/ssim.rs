//! The structural similarity of tiles (Wang, Bovik, Sheikh and Simoncelli 2004, Eq. 13), under a mask.
//!
//! A window of 11 x 11 Gaussian weights w around a pixel p gives means, variances and a covariance of the image x and the
//! photograph y. The weights are renormalized over the valid pixels of the tile in the window: with the mask m,
//! `mean(v)_p = sum_i w_pi m_i v_i / W_p` and `W_p = sum_i w_pi m_i`. Both sums are separable: rows, then columns.
//!
//! The sums are over `d = x - y` and `s = (x - 1/2) + (y - 1/2)`. The similarity is a function of these too:
//!
//! ```text
//! 1 - SSIM = A + B - A B
//! A = mean(d)^2 / Q,  Q = mean(x)^2 + mean(y)^2 + C1 = ((mean(s) + 1)^2 + mean(d)^2) / 2 + C1
//! B = var(d) / T,     T = var(x) + var(y) + C2       = (var(s) + var(d)) / 2 + C2
//! ```
//!
//! This is exactly 0 for equal images, keeps its digits near that, and needs four sums where x and y need five.

use glam::Vec4;

use muslin::prelude::*;

/// Pixels of the window on either side of its center.
pub const RADIUS: u32 = 5;

/// Side of the window, in pixels.
pub const WINDOW: u32 = 2 * RADIUS + 1;

/// Vectors of a pixel in `moments`: the weighted sums of d (and, in its last component, of the mask), s, d^2 and s^2.
pub const MOMENTS: u32 = 4;

/// Vectors of a pixel in `slopes`; see [`Similarity`].
pub const SLOPES: u32 = 3;

/// `(K1 L)^2` with K1 = 0.01 and colors in 0 to L = 1.
pub const C1: f32 = 1e-4;

/// `(K2 L)^2` with K2 = 0.03.
pub const C2: f32 = 9e-4;

/// Parameters of [`ssim_rows`], [`ssim_columns`] and [`ssim_rows_backward`].
#[params]
pub struct SsimParams {
    /// S, in pixels.
    pub side: u32,
}

/// Where a window meets a tile, along one axis.
#[derive(Clone, Copy)]
pub struct Taps {
    /// The first pixel.
    pub first: u32,
    /// Exclusive end.
    pub end: u32,
    /// The first pixel's weight among the [`WINDOW`].
    pub weight: u32,
}

impl Taps {
    /// The window around pixel `at` of `side`.
    #[inline(always)]
    pub fn around(at: u32, side: u32) -> Self {
        let first = if at > RADIUS { at } else { RADIUS } - RADIUS;
        let end = if side < at + RADIUS + 1 { side } else { at + RADIUS + 1 };
        Self { first, end, weight: first + RADIUS - at }
    }
}

/// The sums of [`MOMENTS`] along rows: pixels along x and y, tiles along z.
///
/// `window [11]`; `difference [K, S, S]` and `sum [K, S, S]` as [`loss_terms`](crate::loss::loss_terms) writes them;
/// `moments [K, S, S, 4]`.
#[kernel(threads(8, 8), over(params.side, params.side, difference.len() / (params.side * params.side)), iterations = WINDOW)]
pub fn ssim_rows(
    id: Invocation,
    params: &SsimParams,
    window: Read<f32>,
    difference: Read<Vec4>,
    sum: Read<Vec4>,
    moments: Write<Vec4>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let row = (id.workgroup.z * params.side + place.y) * params.side;
        let taps = Taps::around(place.x, params.side);
        let mut d = Vec4::ZERO;
        let mut s = Vec4::ZERO;
        let mut dd = Vec4::ZERO;
        let mut ss = Vec4::ZERO;
        let mut weight = taps.weight;
        let mut next = taps.first;
        while next < taps.end {
            let w = window.read(weight);
            let a = difference.read(row + next);
            let b = sum.read(row + next);
            let wa = a * w;
            let wb = b * w;
            d += wa;
            s += wb;
            // the mask is 0 or 1: (m d)^2 is m d^2
            dd += wa * a;
            ss += wb * b;
            weight += 1;
            next += 1;
        }
        let at = (row + place.x) * MOMENTS;
        moments.write(at, d);
        moments.write(at + 1, s);
        moments.write(at + 2, dd);
        moments.write(at + 3, ss);
    }
}

/// `1 - SSIM` of a window, channel by channel, and its derivative by a pixel i in it:
/// `d(1 - SSIM) / dx_i = w_i m_i (constant + d_i by_difference + s_i by_sum)`.
///
/// The last components are not used.
#[derive(Clone, Copy)]
pub struct Similarity {
    /// `1 - SSIM`, 0 to 2.
    pub dissimilarity: Vec4,
    /// The slope's part that all pixels share.
    pub constant: Vec4,
    /// The factor of d of the pixel.
    pub by_difference: Vec4,
    /// The factor of s of the pixel.
    pub by_sum: Vec4,
}

impl Similarity {
    /// From the window's [`MOMENTS`], at least one of its pixels being valid.
    ///
    /// With `F = 1 - (1 - A)(1 - B)` and x entering d and s alike:
    ///
    /// ```text
    /// dF/dmean(d) = (1 - B) (2 - A) mean(d) / Q      dF/dvar(d) = (1 - A) (2 - B) / 2T
    /// dF/dmean(s) = (1 - B) (-A) (mean(s) + 1) / Q   dF/dvar(s) = (1 - A) (-B) / 2T
    /// dmean(v)/dv_i = w_i m_i / W                    dvar(v)/dv_i = 2 w_i m_i (v_i - mean(v)) / W
    /// ```
    #[inline(always)]
    pub fn new(d: Vec4, s: Vec4, dd: Vec4, ss: Vec4) -> Self {
        let inverse = 1.0 / d.w;
        let mean_d = d * inverse;
        let mean_s = s * inverse;
        // rounding may leave a variance below 0
        let variance_d = (dd * inverse - mean_d * mean_d).max(Vec4::ZERO);
        let variance_s = (ss * inverse - mean_s * mean_s).max(Vec4::ZERO);
        let one = Vec4::ONE;
        let two = Vec4::splat(2.0);
        let center = mean_s + one;
        let q = (center * center + mean_d * mean_d) * 0.5 + Vec4::splat(C1);
        let t = (variance_s + variance_d) * 0.5 + Vec4::splat(C2);
        let a = mean_d * mean_d / q;
        let b = variance_d / t;
        let of_means = (one - b) * (mean_d * (two - a) - center * a) / q;
        let of_variances = (one - a) / t;
        let by_difference = of_variances * (two - b);
        let by_sum = -(of_variances * b);
        let constant = of_means - by_difference * mean_d - by_sum * mean_s;
        Self {
            dissimilarity: a + b - a * b,
            constant: (constant * inverse).with_w(0.0),
            by_difference: (by_difference * inverse).with_w(0.0),
            by_sum: (by_sum * inverse).with_w(0.0),
        }
    }
}

/// Completes the windows along columns: pixels along x and y, tiles along z.
///
/// `difference [K, S, S]`: only its mask is read; `moments [K, S, S, 4]` of [`ssim_rows`]. Writes
/// `dissimilarity [K, S, S]`, the sum of `1 - SSIM` over the three channels, and `slopes [K, S, S, 3]`, the rest of
/// [`Similarity`]; both are 0 at masked pixels, whose windows do not count.
#[kernel(threads(8, 8), over(params.side, params.side, difference.len() / (params.side * params.side)), iterations = WINDOW)]
pub fn ssim_columns(
    id: Invocation,
    params: &SsimParams,
    window: Read<f32>,
    difference: Read<Vec4>,
    moments: Read<Vec4>,
    dissimilarity: Write<f32>,
    slopes: Write<Vec4>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let tile = id.workgroup.z * params.side * params.side;
        let taps = Taps::around(place.y, params.side);
        let mut d = Vec4::ZERO;
        let mut s = Vec4::ZERO;
        let mut dd = Vec4::ZERO;
        let mut ss = Vec4::ZERO;
        let mut weight = taps.weight;
        let mut next = (tile + taps.first * params.side + place.x) * MOMENTS;
        let end = (tile + taps.end * params.side + place.x) * MOMENTS;
        while next < end {
            let w = window.read(weight);
            d += moments.read(next) * w;
            s += moments.read(next + 1) * w;
            dd += moments.read(next + 2) * w;
            ss += moments.read(next + 3) * w;
            weight += 1;
            next += params.side * MOMENTS;
        }
        let at = tile + place.y * params.side + place.x;
        let mut all = 0.0;
        let mut constant = Vec4::ZERO;
        let mut by_difference = Vec4::ZERO;
        let mut by_sum = Vec4::ZERO;
        if difference.read(at).w > 0.0 {
            let found = Similarity::new(d, s, dd, ss);
            let f = found.dissimilarity;
            all = f.x + f.y + f.z;
            constant = found.constant;
            by_difference = found.by_difference;
            by_sum = found.by_sum;
        }
        dissimilarity.write(at, all);
        slopes.write(at * SLOPES, constant);
        slopes.write(at * SLOPES + 1, by_difference);
        slopes.write(at * SLOPES + 2, by_sum);
    }
}

/// The adjoint of [`ssim_rows`]: each pixel takes the slopes of the windows of its row that it lies in.
/// Pixels along x and y, tiles along z.
///
/// The window is symmetric, so that this is the same sum once more. The columns' adjoint is part of
/// [`loss_gradient`](crate::loss::loss_gradient). `slopes [K, S, S, 3]` and `row_slopes [K, S, S, 3]`.
#[kernel(threads(8, 8), over(params.side, params.side, slopes.len() / (SLOPES * params.side * params.side)), iterations = WINDOW)]
pub fn ssim_rows_backward(
    id: Invocation,
    params: &SsimParams,
    window: Read<f32>,
    slopes: Read<Vec4>,
    row_slopes: Write<Vec4>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let row = (id.workgroup.z * params.side + place.y) * params.side;
        let taps = Taps::around(place.x, params.side);
        let mut constant = Vec4::ZERO;
        let mut by_difference = Vec4::ZERO;
        let mut by_sum = Vec4::ZERO;
        let mut weight = taps.weight;
        let mut next = (row + taps.first) * SLOPES;
        let end = (row + taps.end) * SLOPES;
        while next < end {
            let w = window.read(weight);
            constant += slopes.read(next) * w;
            by_difference += slopes.read(next + 1) * w;
            by_sum += slopes.read(next + 2) * w;
            weight += 1;
            next += SLOPES;
        }
        let at = (row + place.x) * SLOPES;
        row_slopes.write(at, constant);
        row_slopes.write(at + 1, by_difference);
        row_slopes.write(at + 2, by_sum);
    }
}
