//! Kernels that tests run on every device, because they use what no kernel of organza does.

use crate::prelude::*;

/// Parameters of the kernels of this module.
#[params]
pub struct LanguageParams {
    /// Items.
    pub count: u32,
}

/// Values of a byte.
pub const BYTES: usize = 256;
/// Bins of both histograms.
const BINS: usize = 2 * BYTES;

/// Adds to `bins [2 * 256]` how often each value of a byte is among `bytes [count]`, and each upper half of `halves [count]`.
#[kernel(threads(BYTES as u32))]
pub fn byte_histogram(
    id: Invocation,
    params: &LanguageParams,
    bytes: Packed<u8>,
    halves: Packed<u16>,
    bins: Write<u32>,
    counts: Shared<u32, BINS>,
) {
    let own = id.local.x;
    let all = BYTES as u32;
    counts.write(own, 0);
    counts.write(all + own, 0);
    id.barrier();
    if id.index() < params.count {
        counts.atomic_add(bytes.read(id.index()), 1);
        counts.atomic_add(all + (halves.read(id.index()) >> 8), 1);
    }
    id.barrier();
    bins.atomic_add(own, counts.read(own));
    bins.atomic_add(all + own, counts.read(all + own));
}

/// Items of a workgroup of [`prefix_sums`].
pub const SUMMED: u32 = 64;

/// Sums of `values [count]` up to each item, within workgroups of 64 items: `sums [count]`. `scratch [2 count]` has those of the last step and
/// of this one (Hillis and Steele 1986).
#[kernel(threads(SUMMED), iterations = 6)]
pub fn prefix_sums(
    id: Invocation,
    params: &LanguageParams,
    values: Read<u32>,
    scratch: Write<u32>,
    sums: Write<u32>,
) {
    let own = id.index();
    let is_item = own < params.count;
    if is_item {
        scratch.write(own, values.read(own));
    }
    id.storage_barrier();
    let mut last = 0;
    let mut distance = 1;
    while distance < SUMMED {
        let next = params.count - last;
        if is_item {
            let mut sum = scratch.read(last + own);
            if id.local.x >= distance {
                sum += scratch.read(last + own - distance);
            }
            scratch.write(next + own, sum);
        }
        id.storage_barrier();
        last = next;
        distance *= 2;
    }
    if is_item {
        sums.write(own, scratch.read(last + own));
    }
}
