//! B2. The steps of a ray that can lose light: those whose midpoints lie where the [occupancy grid](crate::occupancy) is not empty.
//!
//! Where the grid is empty, a step adds 0 to the logarithm of T (Eq. 11) and has no gradient. So only the others become samples. In training, faint
//! steps play Russian roulette, so that fewer become samples.

use glam::Vec4;

use crate::limits::MAX_SAMPLES;
use crate::occupancy::occupied;
use crate::segment::{SEGMENT_VECTORS, midpoint, read_ray};
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;

/// Parameters of [`step_count`] and [`step_fill`].
#[params]
pub struct StepsParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Cells along a side of the occupancy grid.
    pub side: u32,
    /// 1 where what lies outside the scene's box is contracted.
    pub contracted: u32,
    /// Steps where the grid is less full than this play [roulette](roulette); 0: none.
    pub faint: f32,
    /// Words of a pair: a bit for each of its steps.
    pub words: u32,
}

/// The golden ratio's fraction: its multiples spread evenly over [0, 1) (a Kronecker sequence).
const GOLDEN: f32 = 0.618_034;

/// Russian roulette: a step with `value < faint` survives with a probability of `value / faint`, and then counts as `faint`. So each sum over a
/// ray's steps keeps its mean. Step k takes the k-th number of a golden sequence, which spreads the survivors along the ray.
#[inline(always)]
pub fn roulette<L: Lane>(faint: f32, seed: f32, k: L, value: L) -> L {
    let faint = L::splat(faint);
    let turns = L::splat(seed) + k * L::splat(GOLDEN);
    let chance = turns - turns.truncate();
    let survivor = L::select((chance * faint).less(value), faint, L::splat(0.0));
    L::select(value.less(faint), survivor, value)
}

/// A hash of a ray's bits. Gaussians move in each training step, so it changes, and it depends on no other ray.
#[inline(always)]
pub fn hash_of(segment: Read<Vec4>, pair: u32) -> u32 {
    let [a, b, c, _] = segment.read(pair * SEGMENT_VECTORS).to_array();
    let [d, e, f, _] = segment.read(pair * SEGMENT_VECTORS + 1).to_array();
    let first = mix(mix(mix(a.to_bits()) ^ b.to_bits()) ^ c.to_bits());
    mix(mix(mix(first ^ d.to_bits()) ^ e.to_bits()) ^ f.to_bits())
}

/// A hash as a number in [0, 1).
#[inline(always)]
pub fn fraction_of(hash: u32) -> f32 {
    // an f32 holds 24 bits
    (hash >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// The last step of MurmurHash3 (Appleby): each bit of the result depends on all bits.
#[inline(always)]
pub fn mix(bits: u32) -> u32 {
    let bits = (bits ^ (bits >> 16)).wrapping_mul(0x85eb_ca6b);
    let bits = (bits ^ (bits >> 13)).wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}

/// K, the number of steps of a pair's ray.
#[inline(always)]
fn steps_of(segment: Read<Vec4>, pair: u32) -> u32 {
    segment.read(pair * SEGMENT_VECTORS + 3).w as u32
}

/// How full the grid is at the midpoints of the steps from `first` on, after [`roulette`]; 0 behind the last step.
#[inline(always)]
fn occupied_from<L: Lane>(
    params: &StepsParams,
    occupancy: Read<f32>,
    ray: [LaneVec4<L>; 4],
    seed: f32,
    first: u32,
) -> L {
    let k = L::splat(first as f32) + L::ramp();
    let count = ray[3].w;
    let known = k.min(count - L::splat(1.0));
    let mut value = occupied(params.side, occupancy, midpoint(params.contracted, ray, known));
    if params.faint > 0.0 {
        value = roulette(params.faint, seed, k, value);
    }
    L::select(k.less(count), value, L::splat(0.0))
}

/// 2 to the power of the lane.
#[loops]
#[inline(always)]
fn powers<L: Lane>() -> L {
    let mut power = L::splat(1.0);
    let mut lane = 1;
    while lane < L::WIDTH {
        power = L::select(L::splat(lane as f32).less_equal(L::ramp()), power + power, power);
        lane += 1;
    }
    power
}

/// Which of each pair's steps are samples, and how many: `segment [pairs, 4]`, `occupancy [entries^3]`, `bits [pairs, words]`,
/// `count [pairs]`. Words behind a ray's last step are not written.
///
/// On a CPU, the lanes are neighboring steps.
#[kernel(threads(64), over(params.pairs), iterations = MAX_SAMPLES, lanes, counts(pairs))]
pub fn step_count<L: Lane>(
    id: Invocation,
    params: &StepsParams,
    segment: Read<Vec4>,
    occupancy: Read<f32>,
    bits: Write<u32>,
    count: Write<u32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let ray = read_ray::<L>(segment, pair);
        // where the ray's sequence begins
        let mut seed = 0.0;
        if params.faint > 0.0 {
            seed = fraction_of(hash_of(segment, pair));
        }
        let steps = steps_of(segment, pair);
        let zero = L::splat(0.0);
        let powers = powers::<L>();
        let mut samples = 0;
        let mut word = 0;
        let mut first = 0;
        while first < steps {
            let value = occupied_from(params, occupancy, ray, seed, first);
            // the sum of different powers of two, up to 2^15, is exact
            let of_lanes = L::select(zero.less(value), powers, zero).sum() as u32;
            word |= of_lanes << (first % u32::BITS);
            first += L::WIDTH;
            if first % u32::BITS == 0 || first >= steps {
                bits.write(pair * params.words + (first - 1) / u32::BITS, word);
                samples += word.count_ones();
                word = 0;
            }
        }
        count.write(pair, samples);
    }
}

/// Lists the steps whose bits [`step_count`] has set: `first_sample [pairs + 1]`; `step [samples]` is k.
#[kernel(threads(64), over(params.pairs), iterations = MAX_SAMPLES + MAX_SAMPLES / u32::BITS, counts(pairs))]
pub fn step_fill(
    id: Invocation,
    params: &StepsParams,
    bits: Read<u32>,
    first_sample: Read<u32>,
    step: Write<f32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let end = first_sample.read(pair + 1);
        let mut at = first_sample.read(pair);
        let mut next = 0;
        let mut word = 0;
        while at < end {
            if word == 0 {
                word = bits.read(pair * params.words + next);
                next += 1;
            } else {
                let k = (next - 1) * u32::BITS + word.trailing_zeros();
                step.write(at, k as f32);
                word &= word - 1;
                at += 1;
            }
        }
    }
}
