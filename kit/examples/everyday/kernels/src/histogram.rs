//! How often each value occurs: each workgroup counts in its own memory first.

use muslin::prelude::*;

/// Different values.
pub const BINS: u32 = 256;

/// Parameters of [`histogram`].
#[params]
pub struct HistogramParams {
    /// Values.
    pub count: u32,
}

/// Adds to `bins [256]` how often each value occurs in `values [count]`.
#[kernel(threads(BINS), over(params.count))]
pub fn histogram(
    id: Invocation,
    params: &HistogramParams,
    values: Packed<u8>,
    bins: Write<u32>,
    counts: Shared<u32, { BINS as usize }>,
) {
    let own = id.local.x;
    counts.write(own, 0);
    id.barrier();
    if id.index() < params.count {
        counts.atomic_add(values.read(id.index()), 1);
    }
    id.barrier();
    let count = counts.read(own);
    if count > 0 {
        bins.atomic_add(own, count);
    }
}
