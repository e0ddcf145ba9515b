//! The peak of a device in multiply-adds and reads: the bench of `muslin-check` compares each kernel with it.

use glam::Vec4;

use crate::lane_vec4::LaneVec4;
use crate::prelude::*;
#[cfg(not(target_arch = "spirv"))]
use crate::work::{NUMBER, Shape, Work, wide};

/// Steps that one invocation takes.
pub const MAX_PEAK_STEPS: u32 = 4_096;

/// Multiply-adds of an invocation of [`peak_multiply_add`] in a step: twelve sums, four times each.
pub const MULTIPLY_ADDS: u32 = 48;

/// Values that an invocation of [`peak_read`] reads in a step.
pub const READS: u32 = 4;

/// Parameters of [`peak_multiply_add`].
#[params]
pub struct PeakMultiplyAddParams {
    /// Invocations.
    pub count: u32,
    /// Steps of each.
    pub steps: u32,
    /// The factor of a sum: its size is below 1, so nothing grows.
    pub factor: f32,
    /// The summand.
    pub addend: f32,
}

/// `sum factor + addend` for four sums.
#[inline(always)]
fn next<L: Lane>(sum: LaneVec4<L>, factor: L, addend: L) -> LaneVec4<L> {
    LaneVec4 {
        x: sum.x.mul_add(factor, addend),
        y: sum.y.mul_add(factor, addend),
        z: sum.z.mul_add(factor, addend),
        w: sum.w.mul_add(factor, addend),
    }
}

/// `sum factor + addend`, four times.
#[inline(always)]
fn next_four<L: Lane>(sum: LaneVec4<L>, factor: L, addend: L) -> LaneVec4<L> {
    let sum = next(next(sum, factor, addend), factor, addend);
    next(next(sum, factor, addend), factor, addend)
}

/// Four sums to begin with: `base` and the numbers of a vector.
#[inline(always)]
fn start<L: Lane>(base: L, first: Vec4) -> LaneVec4<L> {
    let number = L::splat;
    LaneVec4 {
        x: base + number(first.x),
        y: base + number(first.y),
        z: base + number(first.z),
        w: base + number(first.w),
    }
}

/// Start values of the first of twelve sums; the others add 4 and 8.
pub const FIRST_SUMS: Vec4 = Vec4::new(0.0, 1.0, 2.0, 3.0);

/// Factor of the invocation's number in the start values of its sums.
pub const INVOCATION_SHARE: f32 = 1.0 / 4_194_304.0;

/// Operations and bytes of [`peak_multiply_add`].
#[cfg(not(target_arch = "spirv"))]
fn peak_multiply_add_work(params: &PeakMultiplyAddParams, _: Shape<'_>) -> Work {
    let [count, steps, each] = wide([params.count, params.steps, MULTIPLY_ADDS]);
    Work { flops: 2 * count * steps * each, bytes: count * NUMBER }
}

/// Multiply-adds on registers, `x = x factor + addend` again and again: `output [count]`, the sum of an invocation's
/// twelve.  They begin with 0 to 11 and a little of the invocation's number, so that no compiler finds two of them the
/// same, and no GPU two invocations.
#[kernel(threads(64), over(params.count), iterations = MAX_PEAK_STEPS, fused, lanes(count), work(peak_multiply_add_work))]
pub fn peak_multiply_add<L: Lane>(
    id: Invocation,
    params: &PeakMultiplyAddParams,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let base = (L::splat(index as f32) + L::ramp()) * L::splat(INVOCATION_SHARE);
        let factor = L::splat(params.factor);
        let addend = L::splat(params.addend);
        // twelve: a multiply-add takes several cycles, and others begin meanwhile
        let mut a = start(base, FIRST_SUMS).materialize();
        let mut b = start(base, FIRST_SUMS + 4.0).materialize();
        let mut c = start(base, FIRST_SUMS + 8.0).materialize();
        let mut step = 0;
        while step < params.steps {
            a = next_four(a, factor, addend);
            b = next_four(b, factor, addend);
            c = next_four(c, factor, addend);
            step += 1;
        }
        let a = a.materialize();
        let b = b.materialize();
        let c = c.materialize();
        let sum = (a.x + a.y) + (a.z + a.w);
        let sum = sum + ((b.x + b.y) + (b.z + b.w));
        (sum + ((c.x + c.y) + (c.z + c.w))).write(output, index);
    }
}

/// Parameters of [`peak_read`].
#[params]
pub struct PeakReadParams {
    /// Invocations.
    pub count: u32,
    /// Steps of each.
    pub steps: u32,
}

/// Operations and bytes of [`peak_read`].
#[cfg(not(target_arch = "spirv"))]
fn peak_read_work(params: &PeakReadParams, _: Shape<'_>) -> Work {
    let [count, steps, each] = wide([params.count, params.steps, READS]);
    Work { flops: count * steps * each, bytes: count * (steps * each + 1) * NUMBER }
}

/// Reads memory from one end to the other: `output [count]`, the sum of what an invocation has read.
///
/// `values [workgroups, steps, 4, 64]`: a workgroup of a GPU reads 64 neighbors at once, and on the CPU its block stays in
/// the innermost cache until all of its lines are used up.
#[kernel(threads(64), over(params.count), iterations = MAX_PEAK_STEPS, lanes(count), work(peak_read_work))]
pub fn peak_read<L: Lane>(
    id: Invocation,
    params: &PeakReadParams,
    values: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let row = id.size.x;
        let mut at = id.workgroup_index() * params.steps * READS * row + id.local.x;
        let zero = L::splat(0.0);
        // four: an addition takes several cycles
        let mut a = zero;
        let mut b = zero;
        let mut c = zero;
        let mut d = zero;
        let mut step = 0;
        while step < params.steps {
            a = a + L::read(values, at);
            b = b + L::read(values, at + row);
            c = c + L::read(values, at + 2 * row);
            d = d + L::read(values, at + 3 * row);
            at += READS * row;
            step += 1;
        }
        ((a + b) + (c + d)).write(output, index);
    }
}
