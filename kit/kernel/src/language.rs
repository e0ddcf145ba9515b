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
