//! The derivatives of a segment's transmittance (Eq. 11) and of the extra vector in the network's input (Eq. 9).

use glam::Vec4;

use crate::dense::HeadParams;
use crate::limits::{MAX_HIDDEN_WIDTH, MAX_SAMPLES};
use crate::splat::VECTORS;
use crate::steps::{fraction_of, hash_of, mix};
use crate::transmittance::logit_and_factor;
use muslin::math::{abs, max, sigmoid};
use muslin::prelude::*;

/// Parameters of [`gradient_count`].
#[params]
pub struct GradientCountParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// See [`SegmentProductParams::power`](crate::transmittance::SegmentProductParams::power).
    pub power: f32,
    /// Gradients smaller than this play roulette.
    pub faint: f32,
}

/// `dL/dlog_rho_k = power dL/dT T` of Eq. 11, the same for all samples of a pair.
#[inline(always)]
pub fn log_rho_gradient_of(
    transmittance: Read<f32>,
    pair_gradient: Read<Vec4>,
    power: f32,
    pair: u32,
) -> f32 {
    power * (pair_gradient.read(pair * VECTORS).w * transmittance.read(pair))
}

/// A gradient of this size is nothing: a GPU can flush the factors of smaller ones.
pub const NOTHING: f32 = 1e-30;

/// Russian roulette: whether a gradient g survives, of a ray with this hash. With `|g| < faint`, it does with a probability of `|g| / faint`;
/// where it is nothing, never.
/// Then it [counts](survivor) as `faint`, so that sums of gradients keep their means.
#[inline(always)]
pub fn survives(faint: f32, gradient: f32, hash: u32) -> bool {
    // the ray's steps have used its hash
    max(fraction_of(mix(hash)) * faint, NOTHING) < abs(gradient)
}

/// What a gradient that [survives] counts as.
#[inline(always)]
pub fn survivor(faint: f32, gradient: f32) -> f32 {
    let least = if gradient < 0.0 { -faint } else { faint };
    if abs(gradient) < faint { least } else { gradient }
}

/// How many of each pair's samples get a gradient, all or none: `count [pairs]`.
///
/// `segment [pairs, 4]`, `first_sample [pairs + 1]`, `transmittance [pairs]`, `pair_gradient [pairs, 3]`.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn gradient_count(
    id: Invocation,
    params: &GradientCountParams,
    segment: Read<Vec4>,
    first_sample: Read<u32>,
    transmittance: Read<f32>,
    pair_gradient: Read<Vec4>,
    count: Write<u32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let gradient = log_rho_gradient_of(transmittance, pair_gradient, params.power, pair);
        let mut samples = 0;
        if survives(params.faint, gradient, hash_of(segment, pair)) {
            samples = first_sample.read(pair + 1) - first_sample.read(pair);
        }
        count.write(pair, samples);
    }
}

/// Parameters of [`segment_product_backward`].
#[params]
pub struct SegmentProductBackwardParams {
    /// Pairs that have samples in the chunk, and all between them.
    pub pairs: u32,
    /// The first of them.
    pub first_pair: u32,
    /// Samples of the chunk.
    pub samples: u32,
    /// First sample of the chunk.
    pub first_sample: u32,
    /// See [`SegmentProductParams::power`](crate::transmittance::SegmentProductParams::power).
    pub power: f32,
    /// See [`GradientCountParams::faint`].
    pub faint: f32,
}

/// A pair's samples within a chunk, counted from the chunk's first: begin and end.
#[inline(always)]
fn samples_of(first_sample: Read<u32>, pair: u32, chunk: u32, samples: u32) -> (u32, u32) {
    let begin = first_sample.read(pair);
    let end = first_sample.read(pair + 1);
    let begin = if begin > chunk { begin } else { chunk };
    let end = if end < chunk + samples { end } else { chunk + samples };
    (begin - chunk, (if end > chunk { end } else { chunk }) - chunk)
}

/// The gradient of a chunk's logarithms of Eq. 11's factors, the same for all samples of a pair:
/// `dL/dlog_rho_k = power dL/dT T`, or what is left of it after [`gradient_count`].
///
/// `first_sample [all pairs + 1]`, `transmittance [all pairs]`; `pair_gradient [all pairs, 3]`, dL/dT in the first one's
/// last place; `log_rho_gradient [samples]`.
#[kernel(threads(64), over(params.pairs), iterations = MAX_SAMPLES, counts(pairs, samples))]
pub fn segment_product_backward(
    id: Invocation,
    params: &SegmentProductBackwardParams,
    first_sample: Read<u32>,
    transmittance: Read<f32>,
    pair_gradient: Read<Vec4>,
    log_rho_gradient: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let pair = params.first_pair + index;
        let (begin, end) = samples_of(first_sample, pair, params.first_sample, params.samples);
        let gradient = log_rho_gradient_of(transmittance, pair_gradient, params.power, pair);
        let gradient = survivor(params.faint, gradient);
        let mut sample = begin;
        while sample < end {
            log_rho_gradient.write(sample, gradient);
            sample += 1;
        }
    }
}

/// The gradient of the scalar network's output, which is computed once more: `dL/da_k = dL/dlog_rho_k s_factor
/// sigmoid(-a_k)` of Eq. 11.
///
/// `point [7, stride]`, `input [inputs, stride]`, `log_rho_gradient [samples]`, `logit_gradient [samples]`: of
/// the chunk, wherever it begins.
#[kernel(threads(64), over(params.samples), iterations = MAX_HIDDEN_WIDTH, fused, lanes(samples), counts(samples))]
pub fn transmittance_head_backward<L: Lane>(
    id: Invocation,
    params: &HeadParams,
    parameters: Read<Vec4>,
    point: Read<f32>,
    input: Read<f32>,
    log_rho_gradient: Read<f32>,
    logit_gradient: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let (a, factor) = logit_and_factor::<L>(params, parameters, point, input, sample);
        let gradient = L::read(log_rho_gradient, sample) * factor * sigmoid(-a);
        gradient.write(logit_gradient, sample);
    }
}

/// Parameters of [`extra_backward`].
#[params]
pub struct ExtraBackwardParams {
    /// Pairs that have samples in the chunk, and all between them.
    pub pairs: u32,
    /// The first of them.
    pub first_pair: u32,
    /// Samples of the chunk.
    pub samples: u32,
    /// First sample of the chunk.
    pub first_sample: u32,
    /// Distance of two rows in `input_gradient`.
    pub stride: u32,
    /// Values of a Gaussian's extra vector.
    pub extra: u32,
    /// Row of the extra vector in `input_gradient`.
    pub extra_row: u32,
}

/// Adds the gradients of the network's input (Eq. 9) of a pair's samples in the chunk to the gradient of the pair's extra
/// vector: pairs along x and y, the vector's values along z.
///
/// `first_sample [all pairs + 1]`, `input_gradient [rows, stride]`, `pair_extra [all pairs, extra]`.
#[kernel(threads(64), over(params.pairs, params.extra), iterations = MAX_SAMPLES, lanes, counts(pairs, samples))]
pub fn extra_backward<L: Lane>(
    id: Invocation,
    params: &ExtraBackwardParams,
    first_sample: Read<u32>,
    input_gradient: Read<f32>,
    pair_extra: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let pair = params.first_pair + index;
        let (begin, end) = samples_of(first_sample, pair, params.first_sample, params.samples);
        let value = id.workgroup.z;
        let row = (params.extra_row + value) * params.stride;
        let to = pair * params.extra + value;
        // one lane goes on where the chunk before has ended: the sum does not depend on where that was
        let before = pair_extra.read(to);
        let first_of_lanes = if L::WIDTH == 1 { before } else { 0.0 };
        let start = L::splat(first_of_lanes);
        let (sum, first) = sum_lanes::<L>(start, input_gradient, row + begin, row + end);
        let none = L::One::splat(0.0);
        let (rest, _) = sum_lanes::<L::One>(none, input_gradient, first, row + end);
        let sum = sum.sum() + rest.sum();
        pair_extra.write(to, if L::WIDTH == 1 { sum } else { before + sum });
    }
}

/// The sum of the values that fill all lanes, and the index after them.
#[loops]
#[inline(always)]
fn sum_lanes<L: Lane>(before: L, values: Read<f32>, begin: u32, end: u32) -> (L, u32) {
    let mut sum = before;
    let mut at = begin;
    while at + L::WIDTH <= end {
        sum = sum + L::read(values, at);
        at += L::WIDTH;
    }
    (sum, at)
}
