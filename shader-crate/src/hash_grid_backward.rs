//! Gradient of the hash grids' tables: the transpose of the interpolation of [`hash_grid`](crate::hash_grid).
//!
//! Many points share an entry. Their terms are summed in 64-bit [fixed point](muslin::fixed), so the order and the number
//! of threads change no bit. [`hash_grid_scale`](crate::hash_grid_scale) chooses the unit.

use crate::hash_grid::{Corners, GridLevel, HashGridParams, of_corners, read_point, value_at};
use crate::hash_grid_scale::{INVERSE, LIMIT, SCALE, STATUS_LIMIT};
use crate::limits::MAX_FEATURES;
use muslin::atomic;
use muslin::math::TINY;
use muslin::prelude::*;

/// Values of a table that share a flag. The flag is 1 if a gradient has been added to any of them; [`adam`](crate::adam::adam())
/// skips the others.
pub const VALUES_PER_FLAG: u32 = 64;

/// Adds every point's gradient to the entries of its cells' corners: `sum += weight * feature_gradient`, with
/// `dL/dtable[entry, f] = sum_points weight dL/dfeature_f`; points along x and y, levels along z.
///
/// `position [chunks, point_rows, stride]`, see [`write_point`](crate::hash_grid::write_point);
/// `feature_gradient [chunks, rows, stride]`, from the row `params.first_row` on; `scale [3]`, see [`hash_grid_scale`](crate::hash_grid_scale::hash_grid_scale());
/// `sum [2 entries features]`; `touched [ceil(entries features / 64)]` becomes 1 where something is added. A point
/// whose gradient is zero in a level adds nothing there; one above the limit, or NaN, raises `status`.
#[kernel(threads(64), over(params.points, levels.len()), iterations = 2 * MAX_FEATURES, z_serial, lanes(points), counts(points))]
pub fn hash_grid_backward<L: Lane>(
    id: Invocation,
    params: &HashGridParams,
    levels: Read<GridLevel>,
    position: Read<f32>,
    feature_gradient: Read<f32>,
    scale: Read<f32>,
    sum: Write<impl SumWord>,
    touched: Write<u32>,
    status: Write<u32>,
) {
    let point = id.index();
    if point < params.points {
        let features = params.features;
        let first = params.feature_column(id, id.workgroup.z);
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let tiny = L::splat(TINY);
        let limit = L::splat(scale.read(LIMIT));
        let mut largest = zero;
        let mut excess = zero;
        let mut row = first;
        let mut f = 0;
        while f < features {
            let size = size(L::read(feature_gradient, row));
            largest = largest.max(size);
            // NaN is not at most anything
            excess = L::select(size.less_equal(limit), excess, one);
            row += params.stride;
            f += 1;
        }
        if L::any(zero.less(excess)) {
            atomic::raise(status, 0, STATUS_LIMIT);
        }
        // what a GPU may flush counts as zero
        let active = L::both(tiny.less_equal(largest), excess.less(one));
        if L::any(active) {
            let level = levels.read(id.workgroup.z);
            let x = read_point::<L>(position, params.stride, params.point_column(id));
            let corners = Corners::new(&level, level.cell(x)).places(features);
            // the CPU does not look so far ahead by itself
            of_corners!(each corners, |place, _weight| L::expect_fixed(sum, place));
            // One flag for each corner: a block holds whole entries. All points share the few flags of a coarse level, so a GPU
            // looks first: it reads an element for many invocations at once, and changes it for one after another.
            let are_set = of_corners!(corners, |place, _weight| {
                L::is_flagged(touched, place, VALUES_PER_FLAG)
            });
            if !all(are_set) {
                of_corners!(each corners, |place, _weight| {
                    L::flag(active, touched, place, VALUES_PER_FLAG)
                });
            }
            let unit = L::splat(scale.read(SCALE));
            let mut row = first;
            let mut f = 0;
            while L::ADDS_TWO && f + 2 <= features {
                let first = scaled(L::read(feature_gradient, row), unit);
                let second = scaled(L::read(feature_gradient, row + params.stride), unit);
                let values =
                    of_corners!(corners, |_place, weight| [first * weight, second * weight]);
                let at = of_corners!(corners, |place, _weight| value_at::<L>(place, f));
                L::add_fixed_two(values, active, sum, at);
                row += 2 * params.stride;
                f += 2;
            }
            while f < features {
                let gradient = scaled(L::read(feature_gradient, row), unit);
                of_corners!(each corners, |place, weight| {
                    (gradient * weight).add_fixed(active, sum, value_at::<L>(place, f))
                });
                row += params.stride;
                f += 1;
            }
        }
    }
}

/// Whether all eight are true.
#[inline(always)]
pub fn all([a, b, c, d, e, f, g, h]: [bool; 8]) -> bool {
    a & b & c & d & e & f & g & h
}

/// |x|
#[inline(always)]
fn size<L: Lane>(x: L) -> L {
    x.max(-x)
}

/// A gradient in units of the sums; 0 if a GPU can flush it.
#[inline(always)]
fn scaled<L: Lane>(gradient: L, unit: L) -> L {
    L::select(L::splat(TINY).less_equal(size(gradient)), gradient * unit, L::splat(0.0))
}

/// Parameters of [`hash_grid_gradient`].
#[params]
pub struct HashGridGradientParams {
    /// Values of the table: entries times features.
    pub values: u32,
}

/// Adds the sums to the gradient as numbers, `gradient [values] += sum / scale`, and clears them; blocks without a flag
/// are left alone.
#[kernel(threads(256), over(params.values), lanes(values))]
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
        if touched.read(first / VALUES_PER_FLAG) != 0 {
            let term = L::take_fixed(sum, first) * L::splat(scale.read(INVERSE));
            (L::read_written(gradient, first) + term).write(gradient, first);
        }
    }
}
