//! Numbers that stay on the device: how many pairs, members and samples there are.
//!
//! Tables are made for so many, by what was needed before, and nobody waits to hear how many there are.  Where more are
//! found than there is room for, there are none at all: nothing is written past a table's end, nothing adds to a
//! gradient, and the host, who reads the numbers in the end, does it again.

use organza_kernel::count::OVERFLOW;
use organza_kernel::prelude::*;

/// Place in `counts`: (Gaussian, camera) pairs.
pub const PAIRS: u32 = 1;
/// Place in `counts`: (Gaussian, tile) memberships.
pub const MEMBERS: u32 = 2;
/// Place in `counts`: samples of the transmittance network.
pub const SAMPLES: u32 = 3;
/// Values of `counts`.
pub const COUNTS: u32 = 4;

/// Parameters of [`record_total`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct RecordTotalParams {
    /// Place of the number in `counts`.
    pub slot: u32,
    /// Place of the total in `first`.
    pub last: u32,
    /// How many there is room for.
    pub capacity: u32,
}

/// Takes a total from the end of exclusive sums, `first [last + 1]`, and raises [`OVERFLOW`] where it is more than there is
/// room for: a single invocation.
#[kernel(threads(1))]
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
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ClearOnOverflowParams {
    /// Values of the table.
    pub len: u32,
}

/// Clears a table where something did not fit: a mask has no bits then, and a range begins where it ends.
#[kernel(threads(64))]
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
