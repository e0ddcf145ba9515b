//! B2. The steps of a ray that can lose light: those whose midpoints lie where the [occupancy grid](crate::occupancy) is not empty.
//!
//! Where the grid is empty, a step adds 0 to the logarithm of T (Eq. 11) and has no gradient. So only the others become samples.

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
}

/// K, the number of steps of a pair's ray.
#[inline(always)]
fn steps_of(segment: Read<Vec4>, pair: u32) -> u32 {
    segment.read(pair * SEGMENT_VECTORS + 3).w as u32
}

/// How full the grid is at the midpoints of the steps from `first` on; 0 behind the last step.
#[inline(always)]
fn occupied_from<L: Lane>(
    params: &StepsParams,
    occupancy: Read<f32>,
    ray: [LaneVec4<L>; 4],
    first: u32,
) -> L {
    let k = L::splat(first as f32) + L::ramp();
    let count = ray[3].w;
    let known = k.min(count - L::splat(1.0));
    let value = occupied(params.side, occupancy, midpoint(params.contracted, ray, known));
    L::select(k.less(count), value, L::splat(0.0))
}

/// How many of each pair's steps are not empty: `segment [pairs, 4]`, `occupancy [entries^3]`, `count [pairs]`.
///
/// On a CPU, the lanes are neighboring steps.
#[kernel(threads(64), over(params.pairs), iterations = MAX_SAMPLES, lanes, counts(pairs))]
pub fn step_count<L: Lane>(
    id: Invocation,
    params: &StepsParams,
    segment: Read<Vec4>,
    occupancy: Read<f32>,
    count: Write<u32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let ray = read_ray::<L>(segment, pair);
        let steps = steps_of(segment, pair);
        let mut occupied = L::splat(0.0);
        let mut first = 0;
        while first < steps {
            let is_occupied = L::splat(0.0).less(occupied_from(params, occupancy, ray, first));
            occupied = occupied + L::select(is_occupied, L::splat(1.0), L::splat(0.0));
            first += L::WIDTH;
        }
        count.write(pair, occupied.sum() as u32);
    }
}

/// Lists the steps that [`step_count`] has counted: `first_sample [pairs + 1]`; `step [samples]` is k, and `full [samples]` how full x_k is.
///
/// A driver may round a place differently here. So the number of samples decides: what is missing is step 0, and counts as empty.
#[kernel(threads(64), over(params.pairs), iterations = 3 * MAX_SAMPLES, lanes, counts(pairs))]
pub fn step_fill<L: Lane>(
    id: Invocation,
    params: &StepsParams,
    segment: Read<Vec4>,
    occupancy: Read<f32>,
    first_sample: Read<u32>,
    step: Write<f32>,
    full: Write<f32>,
) {
    let pair = id.index();
    if pair < params.pairs {
        let ray = read_ray::<L>(segment, pair);
        let steps = steps_of(segment, pair);
        let end = first_sample.read(pair + 1);
        let mut at = first_sample.read(pair);
        let mut first = 0;
        while first < steps && at < end {
            let value = occupied_from(params, occupancy, ray, first);
            let mut lane = 0;
            while lane < L::WIDTH {
                let value = value.lane(lane);
                if value > 0.0 && at < end {
                    step.write(at, (first + lane) as f32);
                    full.write(at, value);
                    at += 1;
                }
                lane += 1;
            }
            first += L::WIDTH;
        }
        while at < end {
            step.write(at, 0.0);
            full.write(at, 0.0);
            at += 1;
        }
    }
}
