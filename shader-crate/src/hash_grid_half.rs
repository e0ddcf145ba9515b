//! The hash grid with entries as 16-bit floats: half the memory, and half the reads.
//!
//! Two features are one word: an entry takes half as many words as it has features, rounded up. Features are
//! rounded once, to 11 bits, when the table is packed; all else is as in [`hash_grid`](crate::hash_grid).

use crate::hash_grid::{Corners, GridLevel, HashGridParams, of_corners, read_point, sum, value_at};
use crate::limits::MAX_FEATURES;
use muslin::prelude::*;

/// The largest number that a table may hold.
pub const MAX_HALF: f32 = 65_504.0;

/// As [`hash_grid`](crate::hash_grid::hash_grid()), with `table [entries, ceil(features / 2)]`: the feature of even
/// number in the lower half of a word.
#[kernel(threads(64), over(params.points, levels.len()), iterations = MAX_FEATURES, lanes(points), counts(points))]
pub fn hash_grid_half<L: Lane>(
    id: Invocation,
    params: &HashGridParams,
    levels: Read<GridLevel>,
    table: Read<u32>,
    position: Read<f32>,
    output: Write<f32>,
) {
    let point = id.index();
    if point < params.points {
        let level = levels.read(id.workgroup.z);
        let x = read_point::<L>(position, params.stride, params.point_column(id));
        let words = params.features.div_ceil(2);
        let corners = Corners::new(&level, level.cell(x)).places(words);
        let mut row = params.feature_column(id, id.workgroup.z);
        let mut word = 0;
        while word < words {
            let [first, second] = interpolated(table, &corners, word);
            first.write(output, row);
            if 2 * word + 1 < params.features {
                second.write(output, row + params.stride);
            }
            row += 2 * params.stride;
            word += 1;
        }
    }
}

/// Two features between the corners of a cell, summed as [`hash_grid`](crate::hash_grid) does.
#[inline(always)]
fn interpolated<L: Lane>(table: Read<u32>, corners: &Corners<L>, word: u32) -> [L; 2] {
    let [[a0, b0], [a1, b1], [a2, b2], [a3, b3], [a4, b4], [a5, b5], [a6, b6], [a7, b7]] =
        of_corners!(corners, |place, weight| {
            let [first, second] = L::gather_halves(table, value_at::<L>(place, word));
            [first * weight, second * weight]
        });
    [sum([a0, a1, a2, a3, a4, a5, a6, a7]), sum([b0, b1, b2, b3, b4, b5, b6, b7])]
}
