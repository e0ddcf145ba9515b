//! The unit of the fixed-point sums of [`hash_grid_backward`](crate::hash_grid_backward): a power of two, so small that
//! no sum overflows.
//!
//! A network's gradient is at most as large as its outputs' gradient, times `max_i sum_o |W[o, i]|` of each layer; ReLU
//! makes none larger. A sum has at most as many terms of that size as there are samples: the weights of a sample's
//! corners add up to 1.

use glam::Vec4;

use crate::limits::{MAX_HIDDEN_WIDTH, MAX_LAYERS};
use crate::transmittance_backward::log_rho_gradient_of;
use muslin::atomic;
use muslin::math::abs;
use muslin::prelude::*;

/// Index in `scale`: the factor of gradients, a power of two.
pub const SCALE: u32 = 0;
/// Index in `scale`: 1 / [`SCALE`].
pub const INVERSE: u32 = 1;
/// Index in `scale`: the largest gradient that can be added.
pub const LIMIT: u32 = 2;
/// Values of `scale`.
pub const SCALE_VALUES: u32 = 3;

/// In `status`: a gradient was above the limit, or NaN, and left out.
pub const STATUS_LIMIT: u32 = 1;
/// In `status`: a gradient of a pair or a weight was infinite or NaN, and nothing was added.
pub const STATUS_NOT_FINITE: u32 = 2;

/// The bits of infinity; NaN's are above, numbers' below.
const INFINITY_BITS: u32 = 0x7f80_0000;

/// The bits of 1.
const ONE: u32 = 0x3f80_0000;

/// Room that rounding may take: of gradients, of the bound, of a segment's `s_factor` (at most 1 + 1e-4).
const MARGIN: f32 = 1.01;

/// Parameters of [`hash_grid_peak`].
#[params]
pub struct HashGridPeakParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// 1 for the color network, 0 for the transmittance network.
    pub color: u32,
    /// Of the transmittance network: see [`SegmentProductParams::power`](crate::transmittance::SegmentProductParams::power).
    pub power: f32,
    /// Of the transmittance network: see [`GradientCountParams::faint`](crate::transmittance_backward::GradientCountParams::faint).
    pub faint: f32,
}

/// The bits of |x|: in the order of the sizes, NaN last.
#[inline(always)]
fn size_bits(x: f32) -> u32 {
    x.to_bits() & 0x7fff_ffff
}

#[inline(always)]
fn larger(a: u32, b: u32) -> u32 {
    if a > b { a } else { b }
}

/// Raises `bound[0]` to the bits of a bound of every |dL/dlogit|, over all pairs.
///
/// For colors (Eq. 3) it is |dL/dc| / 4, as a sigmoid's slope is at most 1/4; for samples (Eq. 11) it is |power T dL/dT|,
/// as `dT/da_k = power T s_factor (1 - sigmoid(a_k))` and s_factor is at most 1, and `faint`, which smaller gradients may count as.
/// `pair_gradient [pairs, 3]` is `(dL/dmean2d, dL/dopacity, dL/dT), (dL/dconic, 0), (dL/dc, 0)`; `transmittance [pairs]` is
/// not read for colors.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn hash_grid_peak(
    id: Invocation,
    params: &HashGridPeakParams,
    pair_gradient: Read<Vec4>,
    transmittance: Read<f32>,
    bound: Write<u32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let bits = if params.color != 0 {
            let c = pair_gradient.read(3 * pair + 2) * 0.25;
            larger(larger(size_bits(c.x), size_bits(c.y)), size_bits(c.z))
        } else {
            let gradient = log_rho_gradient_of(transmittance, pair_gradient, params.power, pair);
            larger(size_bits(gradient), size_bits(params.faint))
        };
        atomic::raise(bound, 0, bits);
    }
}

/// Parameters of [`hash_grid_norm`].
#[params]
pub struct HashGridNormParams {
    /// Inputs of the layer.
    pub inputs: u32,
    /// Columns of four outputs, padding included.
    pub columns: u32,
    /// Where the layer's weights begin.
    pub weight: u32,
    /// Index of the layer in `bound`.
    pub slot: u32,
}

/// Raises `bound[slot]` to the bits of `max_i sum_o |W[o, i]|`: inputs along x.
#[kernel(threads(64), over(params.inputs), iterations = MAX_HIDDEN_WIDTH / 4)]
pub fn hash_grid_norm(
    id: Invocation,
    params: &HashGridNormParams,
    parameters: Read<Vec4>,
    bound: Write<u32>,
) {
    let input = id.index();
    if input < params.inputs {
        let first = params.weight + input * params.columns;
        let mut sum = 0.0;
        let mut column = 0;
        while column < params.columns {
            let w = parameters.read(first + column);
            sum += abs(w.x) + abs(w.y) + abs(w.z) + abs(w.w);
            column += 1;
        }
        atomic::raise(bound, params.slot, size_bits(sum));
    }
}

/// Parameters of [`hash_grid_scale`].
#[params]
pub struct HashGridScaleParams {
    /// Layers of the network.
    pub layers: u32,
    /// Samples in the batch, or more.
    pub samples: u32,
}

/// The scale from `bound [1 + layers]`, which is cleared for the next time: a single invocation.
///
/// With 2^e above the product of the bounds and 2^b the next power of two of the samples, the scale is `2^(62 - e - b)`,
/// and 2^126 at most: no sum reaches 2^63. Where a bound is infinite or NaN, the limit is 0, so that nothing is added,
/// and `status` is raised.
#[kernel(threads(1), over(1), iterations = MAX_LAYERS + 1, counts(samples))]
pub fn hash_grid_scale(
    id: Invocation,
    params: &HashGridScaleParams,
    bound: Write<u32>,
    scale: Write<f32>,
    status: Write<u32>,
) {
    if id.index() == 0 {
        // exponents apart from mantissas, or a partial product may leave f32's range
        let mut mantissa = MARGIN;
        let mut exponents = 0;
        let mut largest = 0;
        let mut slot = 0;
        while slot <= params.layers {
            let bits = bound.read(slot);
            largest = larger(largest, bits);
            mantissa *= f32::from_bits(bits & 0x7f_ffff | ONE);
            exponents += exponent(bits);
            bound.write(slot, 0);
            slot += 1;
        }
        let above = exponents + exponent(mantissa.to_bits()) + 1;
        // infinity and NaN are above any limit
        let above = if above > 128 { 128 } else { above };
        let above = if above < -125 { -125 } else { above };
        let sample_bits =
            if params.samples > 1 { u32::BITS - (params.samples - 1).leading_zeros() } else { 0 };
        let unit = 62 - above - sample_bits as i32;
        let unit = if unit > 126 { 126 } else { unit };
        scale.write(SCALE, power_of_two(unit));
        scale.write(INVERSE, power_of_two(-unit));
        let is_finite = largest < INFINITY_BITS;
        // the largest number below 2^e
        let limit = f32::from_bits((((above + 127) as u32) << 23) - 1);
        scale.write(LIMIT, if is_finite { limit } else { 0.0 });
        if !is_finite {
            atomic::raise(status, 0, STATUS_NOT_FINITE);
        }
    }
}

/// e of a number `m 2^e` with m in [1, 2), by its bits; a number below 2^-126 counts as larger than it is.
#[inline(always)]
fn exponent(bits: u32) -> i32 {
    (bits >> 23) as i32 - 127
}

/// 2^e for e of -126 to 127.
#[inline(always)]
fn power_of_two(e: i32) -> f32 {
    f32::from_bits(((e + 127) as u32) << 23)
}
