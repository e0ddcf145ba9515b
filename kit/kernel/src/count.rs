//! Numbers that stay on the device: how many items a dispatch has, where an earlier dispatch has found that out.
//!
//! The host sizes tables and dispatches for as many as it expects and does not wait for the number.  `counts` holds
//! the numbers; where one of them is more than there is room for, [`OVERFLOW`] is raised and all of them count as 0.

use crate::prelude::*;

/// RunningInvocation in `counts`: not 0 where something was more than there is room for.
pub const OVERFLOW: u32 = 0;

/// Values of `placement` for each number, and what precedes them: [`count_fill`].
pub const PLACEMENT_VALUES: u32 = 4;

/// How many of `total` there are from `first` on, at most `most`.
#[inline(always)]
pub fn piece(total: u32, first: u32, most: u32) -> u32 {
    let rest = if total > first { total - first } else { 0 };
    if rest < most { rest } else { most }
}

/// Writes numbers to where kernels will read them as their parameters.
///
/// `placement [1 + n, 4]`: n, and three values that nobody reads; then for each number its place in `parameters`, its
/// total's place in `counts`, and `first` and `most` of [`piece`].
#[kernel(threads(64))]
pub fn count_fill(id: Invocation, placement: Read<u32>, counts: Read<u32>, parameters: Write<u32>) {
    let index = id.index();
    if index < placement.read(0) {
        let at = (1 + index) * PLACEMENT_VALUES;
        let total = counts.read(placement.read(at + 1));
        let number = piece(total, placement.read(at + 2), placement.read(at + 3));
        let is_all_there = counts.read(OVERFLOW) == 0;
        parameters.write(placement.read(at), if is_all_there { number } else { 0 });
    }
}
