//! Numbers that stay on the device: how many pairs, members and samples there are.
//!
//! Tables are made for so many, by what was needed before, and nobody waits to hear how many there are.  Where more are
//! found than there is room for, there are none at all: nothing is written past a table's end, nothing adds to a
//! gradient, and the host, who reads the numbers in the end, does it again.

use crate::prelude::*;

/// Place in `counts`: not 0 where something was more than there is room for.
pub const MISFIT: u32 = 0;
/// Place in `counts`: (Gaussian, camera) pairs.
pub const PAIRS: u32 = 1;
/// Place in `counts`: (Gaussian, tile) memberships.
pub const MEMBERS: u32 = 2;
/// Place in `counts`: samples of the transmittance network.
pub const SAMPLES: u32 = 3;
/// Values of `counts`.
pub const COUNTS: u32 = 4;

/// Parameters of [`count_admit`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct CountAdmitParams {
    /// Place of the number in `counts`.
    pub place: u32,
    /// Place of the total in `first`.
    pub last: u32,
    /// How many there is room for.
    pub room: u32,
}

/// Takes a total from the end of exclusive sums, `first [last + 1]`, and raises [`MISFIT`] where it is more than there is
/// room for: a single invocation.
#[kernel(threads(1))]
pub fn count_admit(
    id: Invocation,
    params: &CountAdmitParams,
    first: Read<u32>,
    counts: Write<u32>,
) {
    if id.index() == 0 {
        let total = first.read(params.last);
        counts.write(params.place, total);
        if total > params.room {
            counts.write(MISFIT, 1);
        }
    }
}

/// Parameters of [`count_withhold`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct CountWithholdParams {
    /// Values of the table.
    pub len: u32,
}

/// Clears a table where something did not fit: a mask has no bits then, and a range begins where it ends.
#[kernel(threads(64))]
pub fn count_withhold(
    id: Invocation,
    params: &CountWithholdParams,
    counts: Read<u32>,
    table: Write<u32>,
) {
    let index = id.index();
    if index < params.len && counts.read(MISFIT) != 0 {
        table.write(index, 0);
    }
}

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
        let is_all_there = counts.read(MISFIT) == 0;
        parameters.write(placement.read(at), if is_all_there { number } else { 0 });
    }
}
