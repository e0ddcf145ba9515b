//! B2. Midpoint samples of all segments as one flat list (Eq. 9), and their product (Eq. 10-11).

use glam::Vec4;

use crate::dense::{HeadParams, column};
use crate::hash_grid::{POINT_ROWS, value_at, write_point};
use crate::limits::{MAX_HIDDEN_WIDTH, MAX_SAMPLES, MAX_VECTOR};
use crate::occupancy::occupied;
use crate::segment::{midpoint, read_ray};
use muslin::lane_vec4::LaneVec4;
use muslin::math::{exp, log_sigmoid};
use muslin::prelude::*;

/// Parameters of [`transmittance_inputs`].
#[params]
pub struct TransmittanceInputsParams {
    /// Samples of the chunk.
    pub samples: u32,
    /// First sample of the chunk.
    pub first_sample: u32,
    /// Distance of two rows in `point` and `input`.
    pub stride: u32,
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Values of a Gaussian's extra vector.
    pub extra: u32,
    /// Row of the extra vector in `input`.
    pub extra_row: u32,
    /// 1 where what lies outside the scene's box is contracted.
    pub contracted: u32,
    /// Cells along a side of the occupancy grid, where `step` lists the samples; 0 without a grid.
    pub side: u32,
    /// See [`StepsParams::faint`](crate::steps::StepsParams::faint).
    pub faint: f32,
}

/// The pair that owns a sample: the last one whose samples do not begin after it. Likewise, the tile that owns an intersection.
#[inline(always)]
pub fn owner(first_sample: Read<u32>, pairs: u32, sample: u32) -> u32 {
    owner_among(first_sample, 0, pairs, sample)
}

/// As [`owner`], where it is known to be one of `low .. high`.
#[loops]
#[inline(always)]
fn owner_among(first_sample: Read<u32>, low: u32, high: u32, sample: u32) -> u32 {
    let mut low = low;
    let mut high = high;
    while low + 1 < high {
        let middle = (low + high) / 2;
        let begins_before = first_sample.read(middle) <= sample;
        low = if begins_before { middle } else { low };
        high = if begins_before { high } else { middle };
    }
    low
}

/// Writes what does not come from the hash grid: the midpoint x_k (Eq. 9), its segment's `s_factor` and u.
///
/// `first_sample [pairs + 1]`, `segment [pairs, 4]`; `point [7, stride]` is x_k and `s_factor`; `input [rows, stride]`. With an
/// [occupancy grid](crate::occupancy), [`steps`](crate::steps) have listed each sample's k, and `s_factor` is times how full x_k is.
///
/// Neighbors mostly have the same pair: the CPU looks for it once for all lanes, and goes on from where the pair ends.
#[kernel(threads(64), over(params.samples), iterations = u32::BITS + MAX_VECTOR, lanes(samples), counts(samples, pairs))]
pub fn transmittance_inputs<L: Lane>(
    id: Invocation,
    params: &TransmittanceInputsParams,
    pair: Read<u32>,
    first_sample: Read<u32>,
    segment: Read<Vec4>,
    extra: Read<f32>,
    step: Read<f32>,
    occupancy: Read<f32>,
    point: Write<f32>,
    input: Write<f32>,
) {
    let index = id.index();
    if index < params.samples {
        let sample = params.first_sample + index;
        let mut owner = owner(first_sample, params.pairs, sample);
        let begin = first_sample.read(owner);
        let mut end = first_sample.read(owner + 1);
        let mut k = L::splat((sample - begin) as f32) + L::ramp();
        let mut ray = read_ray::<L>(segment, owner);
        let index_of = <L::Index as LaneIndex>::splat;
        let mut u = index_of(first_extra(params, pair, owner));
        // the lanes of pairs that begin later
        while L::WIDTH > 1 && end - sample < L::WIDTH {
            let begin = end;
            let is_next = first_sample.read(owner + 2) > begin;
            owner = if is_next {
                owner + 1
            } else {
                owner_among(first_sample, owner + 2, params.pairs, begin)
            };
            end = first_sample.read(owner + 1);
            let before = L::splat((begin - sample) as f32);
            let is_later = before.less_equal(L::ramp());
            k = L::select(is_later, L::ramp() - before, k);
            ray = select_ray(is_later, read_ray(segment, owner), ray);
            let first = index_of(first_extra(params, pair, owner));
            u = LaneIndex::select(is_later, first, u);
        }

        if params.side != 0 {
            k = L::read(step, sample);
        }
        let place = midpoint(params.contracted, ray, k);
        let mut factor = ray[0].w;
        if params.side != 0 {
            // what has survived the roulette counts as `faint` at least
            factor = factor * occupied(params.side, occupancy, place).max(L::splat(params.faint));
        }
        let stride = params.stride;
        write_point(point, stride, index, place);
        factor.write(point, POINT_ROWS * stride + index);
        let mut row = 0;
        while row < params.extra {
            let value = L::gather(extra, value_at::<L>(u, row));
            value.write(input, (params.extra_row + row) * stride + index);
            row += 1;
        }
    }
}

/// Where the extra vector of a pair's Gaussian begins.
#[inline(always)]
fn first_extra(params: &TransmittanceInputsParams, pair: Read<u32>, owner: u32) -> u32 {
    pair.read(owner) % params.gaussians * params.extra
}

/// One ray in lanes where the mask holds, another in others.
#[inline(always)]
fn select_ray<L: Lane>(
    mask: L::Mask,
    [a, b, c, d]: [LaneVec4<L>; 4],
    [e, f, g, h]: [LaneVec4<L>; 4],
) -> [LaneVec4<L>; 4] {
    let select = |yes: LaneVec4<L>, no: LaneVec4<L>| LaneVec4 {
        x: L::select(mask, yes.x, no.x),
        y: L::select(mask, yes.y, no.y),
        z: L::select(mask, yes.z, no.z),
        w: L::select(mask, yes.w, no.w),
    };
    [select(a, e), select(b, f), select(c, g), select(d, h)]
}

/// a_k, the output of the scalar network's last layer, and the `s_factor` of the sample's segment.
#[inline(always)]
pub fn logit_and_factor<L: Lane>(
    params: &HeadParams,
    parameters: Read<Vec4>,
    point: Read<f32>,
    input: Read<f32>,
    sample: u32,
) -> (L, L) {
    let a = column::<L>(&params.layer(), parameters, input, sample).x;
    (a, L::read(point, POINT_ROWS * params.stride + sample))
}

/// The last layer of the scalar network and the logarithm of Eq. 11's factor:
/// `log_rho [samples] = s_factor * log_sigmoid(a_k)`.
#[kernel(threads(64), over(params.samples), iterations = MAX_HIDDEN_WIDTH, fused, lanes(samples), counts(samples))]
pub fn transmittance_head<L: Lane>(
    id: Invocation,
    params: &HeadParams,
    parameters: Read<Vec4>,
    point: Read<f32>,
    input: Read<f32>,
    log_rho: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let (a, factor) = logit_and_factor::<L>(params, parameters, point, input, sample);
        (factor * log_sigmoid(a)).write(log_rho, params.first + sample);
    }
}

/// Parameters of [`segment_product`].
#[params]
pub struct SegmentProductParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// An exponent: n if steps are n times as long as sigma (Eq. 8), because `s_factor` counts these longer steps; otherwise 1.
    pub power: f32,
    /// 1 where `transmittance` has T of another scene, which the product is multiplied by.
    pub onto: u32,
}

/// Eq. 11: `transmittance [pairs]`, the product over a segment's samples, to a power; 1 without samples.
#[kernel(threads(64), over(params.pairs), iterations = MAX_SAMPLES, counts(pairs))]
pub fn segment_product(
    id: Invocation,
    params: &SegmentProductParams,
    first_sample: Read<u32>,
    log_rho: Read<f32>,
    transmittance: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let end = first_sample.read(index + 1);
        let mut sample = first_sample.read(index);
        let mut sum = 0.0;
        while sample < end {
            sum += log_rho.read(sample);
            sample += 1;
        }
        let product = exp(params.power * sum);
        if params.onto != 0 {
            transmittance.write(index, transmittance.read(index) * product);
        } else {
            transmittance.write(index, product);
        }
    }
}
