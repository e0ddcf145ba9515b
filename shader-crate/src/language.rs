//! Kernels that tests run on every device, because they use what no kernel of organza does.

use muslin::prelude::*;

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
#[kernel(threads(BYTES))]
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

/// Parameters of [`sort_rows`].
#[params]
pub struct SortParams {
    /// Number of rows.
    pub rows: u32,
    /// Values of a row: a power of two, at most [`MAX_ROW`].
    pub columns: u32,
}

/// Most values of a row that [`sort_rows`] sorts. They are twice as many as fit in workgroup memory.
pub const MAX_ROW: u32 = 1 << MAX_RUNS;
const MAX_RUNS: u32 = 13;
const MAX_STEPS: u32 = MAX_RUNS * (MAX_RUNS + 1) / 2;

/// Sorts each row of `values [rows, columns]`, the smallest first: a workgroup sorts a row in place, by bitonic sort (Batcher 1968).
#[kernel(threads(64), storage_barriers, iterations = MAX_RUNS + MAX_STEPS * (1 + MAX_ROW / 128))]
pub fn sort_rows(id: Invocation, params: &SortParams, values: Write<u32>) {
    let row = id.workgroup_index();
    let first = row * params.columns;
    // all workgroups come to each barrier: browsers want to see that only the parameters decide it
    let pairs = if row < params.rows { params.columns / 2 } else { 0 };
    let mut run = 2;
    while run <= params.columns {
        let mut step = run / 2;
        while step > 0 {
            let mut pair = id.local.x;
            while pair < pairs {
                let low = 2 * pair - (pair & (step - 1));
                let rises = low & run == 0;
                let [one, other] = [first + low, first + low + step];
                let [a, b] = [values.read(one), values.read(other)];
                if (a > b) == rises {
                    values.write(one, b);
                    values.write(other, a);
                }
                pair += 64;
            }
            id.storage_barrier();
            step /= 2;
        }
        run *= 2;
    }
}
