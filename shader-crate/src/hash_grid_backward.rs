//! Gradient of the hash grids' tables: the transpose of the interpolation of [`hash_grid`](crate::hash_grid).
//!
//! Many points share an entry.  Their terms are summed in 64-bit [fixed point](crate::fixed), so that neither the
//! order nor the number of threads changes a bit; [`hash_grid_scale`](crate::hash_grid_scale) says in what unit.

use crate::atomic;
use crate::hash_grid::{Corners, GridLevel, HashGridParams, read_point};
use crate::hash_grid_scale::{INVERSE, LIMIT, SCALE, STATUS_LIMIT};
use crate::lane::MAX_WIDTH;
use crate::limits::MAX_FEATURES;
use crate::math::TINY;
use crate::prelude::*;

/// Values of a table that share a flag: one where a gradient has been added.
pub const FLAG_BLOCK: u32 = 64;

/// Adds every point's gradient to the entries of its cells' corners: `sum += weight * feature_gradient`, with
/// `dL/dtable[entry, f] = sum_points weight dL/dfeature_f`; points along x and y, levels along z.
///
/// `position [chunks, point_rows, stride]`, see [`write_point`](crate::hash_grid::write_point);
/// `feature_gradient [chunks, rows, stride]`, from the row `params.first_row` on; `scale [3]`, see [`hash_grid_scale`](crate::hash_grid_scale::hash_grid_scale());
/// `sum [2 entries features]`; `touched [ceil(entries features / 64)]` becomes 1 where something is added.  A point
/// whose gradient is zero in a level adds nothing there; one above the limit, or NaN, raises `status`.
#[kernel(threads(64), iterations = 2 * MAX_FEATURES, layers, lanes(points), counts(points))]
pub fn hash_grid_backward<L: Lane>(
    id: Invocation,
    params: &HashGridParams,
    levels: Read<GridLevel>,
    position: Read<f32>,
    feature_gradient: Read<f32>,
    scale: Read<f32>,
    sum: Write<u32>,
    touched: Write<u32>,
    status: Write<u32>,
) {
    let point = id.index();
    if point < params.points {
        let features = params.features;
        let first = params.feature_column(point, id.workgroup.z);
        let (zero, one, tiny) = (L::splat(0.0), L::splat(1.0), L::splat(TINY));
        let limit = L::splat(scale.read(LIMIT));
        let (mut largest, mut excess) = (zero, zero);
        let mut row = first;
        let mut f = 0;
        while f < features {
            let size = size(L::read(feature_gradient, row));
            largest = largest.max(size);
            // NaN is not at most anything
            excess = L::select(size.at_most(limit), excess, one);
            row += params.stride;
            f += 1;
        }
        if L::any(zero.less(excess)) {
            atomic::raise(status, 0, STATUS_LIMIT);
        }
        // what a GPU may flush counts as zero
        let active = L::both(tiny.at_most(largest), excess.less(one));
        if L::any(active) {
            let level = levels.read(id.workgroup.z);
            let x = read_point::<L>(position, params.stride, params.point_column(point));
            let corners = Corners::of(&level, level.cell(x, params.smoothstep != 0));
            expect::<L>(sum, &corners, features);
            flag::<L>(touched, active, &corners, features);
            let unit = L::splat(scale.read(SCALE));
            let mut row = first;
            let mut f = 0;
            // two at once gains with AVX-512 alone, which converts whole vectors to 64-bit integers
            while L::WIDTH == MAX_WIDTH && f + 2 <= features {
                let first = scaled(L::read(feature_gradient, row), unit);
                let second = scaled(L::read(feature_gradient, row + params.stride), unit);
                add_two::<L>(sum, active, &corners, [first, second], features, f);
                row += 2 * params.stride;
                f += 2;
            }
            while f < features {
                let gradient = scaled(L::read(feature_gradient, row), unit);
                add::<L>(sum, active, &corners, gradient, features, f);
                row += params.stride;
                f += 1;
            }
        }
    }
}

/// |x|
#[inline(always)]
fn size<L: Lane>(x: L) -> L {
    x.max(-x)
}

/// A gradient in units of the sums: 0 where a GPU may flush it.
#[inline(always)]
fn scaled<L: Lane>(gradient: L, unit: L) -> L {
    L::select(L::splat(TINY).at_most(size(gradient)), gradient * unit, L::splat(0.0))
}

/// Adds the gradients of a feature and of the next one to the eight corners.
#[inline(always)]
fn add_two<L: Lane>(
    sum: Write<u32>,
    active: L::Mask,
    corners: &Corners<L>,
    [a, b]: [L; 2],
    features: u32,
    f: u32,
) {
    let [e0, e1, e2, e3, e4, e5, e6, e7] = corners.entry;
    let [w0, w1, w2, w3, w4, w5, w6, w7] = corners.weight;
    L::add_fixed_two([a * w0, b * w0], active, sum, value::<L>(e0, features, f));
    L::add_fixed_two([a * w1, b * w1], active, sum, value::<L>(e1, features, f));
    L::add_fixed_two([a * w2, b * w2], active, sum, value::<L>(e2, features, f));
    L::add_fixed_two([a * w3, b * w3], active, sum, value::<L>(e3, features, f));
    L::add_fixed_two([a * w4, b * w4], active, sum, value::<L>(e4, features, f));
    L::add_fixed_two([a * w5, b * w5], active, sum, value::<L>(e5, features, f));
    L::add_fixed_two([a * w6, b * w6], active, sum, value::<L>(e6, features, f));
    L::add_fixed_two([a * w7, b * w7], active, sum, value::<L>(e7, features, f));
}

/// Adds a feature's gradient to the eight corners.
#[inline(always)]
fn add<L: Lane>(
    sum: Write<u32>,
    active: L::Mask,
    corners: &Corners<L>,
    gradient: L,
    features: u32,
    f: u32,
) {
    let [e0, e1, e2, e3, e4, e5, e6, e7] = corners.entry;
    let [w0, w1, w2, w3, w4, w5, w6, w7] = corners.weight;
    (gradient * w0).add_fixed(active, sum, value::<L>(e0, features, f));
    (gradient * w1).add_fixed(active, sum, value::<L>(e1, features, f));
    (gradient * w2).add_fixed(active, sum, value::<L>(e2, features, f));
    (gradient * w3).add_fixed(active, sum, value::<L>(e3, features, f));
    (gradient * w4).add_fixed(active, sum, value::<L>(e4, features, f));
    (gradient * w5).add_fixed(active, sum, value::<L>(e5, features, f));
    (gradient * w6).add_fixed(active, sum, value::<L>(e6, features, f));
    (gradient * w7).add_fixed(active, sum, value::<L>(e7, features, f));
}

/// Fetches the sums of the eight corners: the CPU does not look so far ahead by itself.
#[inline(always)]
fn expect<L: Lane>(sum: Write<u32>, corners: &Corners<L>, features: u32) {
    let [e0, e1, e2, e3, e4, e5, e6, e7] = corners.entry;
    L::expect_fixed(sum, value::<L>(e0, features, 0));
    L::expect_fixed(sum, value::<L>(e1, features, 0));
    L::expect_fixed(sum, value::<L>(e2, features, 0));
    L::expect_fixed(sum, value::<L>(e3, features, 0));
    L::expect_fixed(sum, value::<L>(e4, features, 0));
    L::expect_fixed(sum, value::<L>(e5, features, 0));
    L::expect_fixed(sum, value::<L>(e6, features, 0));
    L::expect_fixed(sum, value::<L>(e7, features, 0));
}

/// Where a feature of an entry lies in the table.
#[inline(always)]
fn value<L: Lane>(entry: L::Index, features: u32, f: u32) -> L::Index {
    let number = <L::Index as LaneIndex>::splat;
    entry.wrapping_mul(number(features)).wrapping_add(number(f))
}

/// Raises the flags of the blocks that the corners' features lie in: one each, as a block holds whole entries.
#[inline(always)]
fn flag<L: Lane>(touched: Write<u32>, active: L::Mask, corners: &Corners<L>, features: u32) {
    let [e0, e1, e2, e3, e4, e5, e6, e7] = corners.entry;
    L::flag(active, touched, value::<L>(e0, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e1, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e2, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e3, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e4, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e5, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e6, features, 0), FLAG_BLOCK);
    L::flag(active, touched, value::<L>(e7, features, 0), FLAG_BLOCK);
}

/// Parameters of [`hash_grid_gradient`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct HashGridGradientParams {
    /// Values of the table: entries times features.
    pub values: u32,
}

/// Adds the sums to the gradient as numbers, `gradient [values] += sum / scale`, and clears them; blocks without a flag
/// are left alone.
#[kernel(threads(256), lanes(values))]
pub fn hash_grid_gradient<L: Lane>(
    id: Invocation,
    params: &HashGridGradientParams,
    scale: Read<f32>,
    touched: Read<u32>,
    sum: Write<u32>,
    gradient: Write<f32>,
) {
    let first = id.index();
    if first < params.values {
        // a block holds a whole number of lanes
        if touched.read(first / FLAG_BLOCK) != 0 {
            let term = L::take_fixed(sum, first) * L::splat(scale.read(INVERSE));
            (L::read_written(gradient, first) + term).write(gradient, first);
        }
    }
}
