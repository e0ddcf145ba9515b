//! Counts that stay on the device: how many pairs, intersections and samples there are.
//!
//! The host sizes tables by what earlier batches needed, and does not wait for the numbers. If one of them exceeds its
//! capacity, all count as 0: nothing is written past a table's end, and nothing is added to a gradient. The host reads the
//! numbers at the end, and then repeats the work with more room.

use muslin::count::OVERFLOW;
use muslin::prelude::*;

/// Index in `counts`: (Gaussian, camera) pairs.
pub const PAIRS: u32 = 1;
/// Index in `counts`: tile intersections.
pub const INTERSECTIONS: u32 = 2;
/// Index in `counts`: samples of the transmittance network.
pub const SAMPLES: u32 = 3;
/// Index in `counts`: samples with a gradient.
pub const GRADIENTS: u32 = 4;
/// Index in `counts` of `u32::MAX`. A kernel with this count runs over all its items, or over none after an [`OVERFLOW`].
pub const ALL: u32 = 5;
/// Values of `counts`.
pub const COUNTS: u32 = 6;

/// Parameters of [`record_total`].
#[params]
pub struct RecordTotalParams {
    /// Index of the number in `counts`.
    pub slot: u32,
    /// Index of the total in `first`.
    pub last: u32,
    /// How many the tables have room for.
    pub capacity: u32,
}

/// Copies the total at the end of exclusive sums, `first [last + 1]`, to `counts`, and raises [`OVERFLOW`] if it exceeds the
/// capacity. Runs as a single invocation.
#[kernel(threads(1), over(1))]
pub fn record_total(
    id: Invocation,
    params: &RecordTotalParams,
    first: Read<u32>,
    counts: Write<u32>,
) {
    if id.index() == 0 {
        let total = first.read(params.last);
        counts.write(params.slot, total);
        if total > params.capacity {
            counts.write(OVERFLOW, 1);
        }
    }
}

/// Parameters of [`clear_on_overflow`].
#[params]
pub struct ClearOnOverflowParams {
    /// Values of the table.
    pub len: u32,
}

/// Clears a table after an overflow: a mask then has no bits, and ranges are empty.
#[kernel(threads(64), over(params.len))]
pub fn clear_on_overflow(
    id: Invocation,
    params: &ClearOnOverflowParams,
    counts: Read<u32>,
    table: Write<u32>,
) {
    let index = id.index();
    if index < params.len && counts.read(OVERFLOW) != 0 {
        table.write(index, 0);
    }
}
