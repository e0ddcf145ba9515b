//! Counts that stay on the device: numbers of items that an earlier dispatch has computed.
//!
//! The host sizes tables and dispatches for the number that it expects, and does not wait for the real one. The
//! buffer `counts` has the numbers. If one of them exceeds its capacity, [`OVERFLOW`] is raised and all of them count
//! as 0.

use muslin_macros::kernel;

use crate::invocation::Invocation;
use crate::memory::{Read, Write};
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};

/// Index in `counts` of a flag: not 0 if a number exceeds its capacity.
pub const OVERFLOW: u32 = 0;

/// Number of values in a row of `placement`: see [`count_fill`].
pub const PLACEMENT_VALUES: u32 = 4;

/// The number of items from `first` on among `total`, at most `max`.
#[inline(always)]
pub fn piece(total: u32, first: u32, max: u32) -> u32 {
    let rest = if total > first { total - first } else { 0 };
    if rest < max { rest } else { max }
}

/// Writes counts into the parameters of the kernels that will read them.
///
/// `placement [1 + n, 4]` starts with n and three unused values. Then, for each number: its index in `parameters`, the
/// index of its total in `counts`, and `first` and `max` of [`piece`].
#[kernel(threads(64), over(placement.len() / PLACEMENT_VALUES - 1))]
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
