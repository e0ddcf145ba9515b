//! Packed integers, sorts by storage barriers, and arithmetic and comparisons as they are written.

use muslin::prelude::*;

use crate::rows;

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
#[kernel(threads(BYTES), over(params.count))]
pub fn byte_histogram(
    id: Invocation,
    params: &LanguageParams,
    bytes: Packed<u8>,
    halves: Packed<u16>,
    bins: Write<u32>,
    local: Shared<u32, BINS>,
) {
    let own = id.local.x;
    let all = BYTES as u32;
    local.write(own, 0);
    local.write(all + own, 0);
    id.barrier();
    if id.index() < params.count {
        local.atomic_add(bytes.read(id.index()), 1);
        local.atomic_add(all + (halves.read(id.index()) >> 8), 1);
    }
    id.barrier();
    bins.atomic_add(own, local.read(own));
    bins.atomic_add(all + own, local.read(all + own));
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
#[kernel(threads(64), over(64 * params.rows), storage_barriers, iterations = MAX_RUNS + MAX_STEPS * (1 + MAX_ROW / 128))]
pub fn sort_rows(id: Invocation, params: &SortParams, values: Write<u32>) {
    let row = id.workgroup_index();
    let first = row * params.columns;
    // all workgroups reach each barrier: browsers must see that only the parameters decide it
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

/// Rows of [`as_written`].
pub const AS_WRITTEN_ROWS: usize = 24;

/// `bits [24, count]`: arithmetic of `x` and `y`, which gives something else if a compiler regroups or shortens it.
#[kernel(threads(64), over(params.count))]
pub fn as_written(
    id: Invocation,
    params: &LanguageParams,
    x: Read<f32>,
    y: Read<f32>,
    bits: Write<u32>,
) {
    if id.index() < params.count {
        arithmetic([x.read(id.index()), y.read(id.index())], id.index(), params.count, bits);
    }
}

/// A helper: a thorough device finds what changes where sums are regrouped, in a kernel's own body.
#[allow(clippy::eq_op, clippy::erasing_op, clippy::identity_op)]
fn arithmetic([x, y]: [f32; 2], index: u32, count: u32, bits: Write<u32>) {
    let vector = Vec4::new(x, y, y, x);
    rows! { bits [count] at index;
        ((x + 12_582_912.0) - 12_582_912.0).to_bits(),
        ((x - y) + y).to_bits(),
        ((x + y) - y).to_bits(),
        (x - (x - y)).to_bits(),
        ((x / y) * y).to_bits(),
        ((x * 1e-30) * 1e-30).to_bits(),
        ((x * 0.1) * 3.0).to_bits(),
        ((x + 0.1) + 0.2).to_bits(),
        ((0.1 - x) - 0.2).to_bits(),
        (x * 0.0).to_bits(),
        (0.0 / x).to_bits(),
        (x - x).to_bits(),
        (x / x).to_bits(),
        (x + 0.0).to_bits(),
        (0.0 - x).to_bits(),
        (-(x - y)).to_bits(),
        (x * 2.0 * 0.5).to_bits(),
        (x * y + x * 0.3).to_bits(),
        (x / 3.0 / 7.0).to_bits(),
        (3.0 / (7.0 / x)).to_bits(),
        (x + 0.0 * (y - x)).to_bits(),
        (vector * 0.1 * 3.0).z.to_bits(),
        ((vector + Vec4::splat(0.1)) - Vec4::splat(0.1)).y.to_bits(),
        ((x * 0.7).min(1.0) * (1.0 / 0.7)).to_bits(),
    }
}

/// Rows of [`compared`].
pub const COMPARED_ROWS: usize = 20;

/// `found [20, count]`: what comparisons say of `x` and `y`, which can be NaN, and the bits of what is chosen by them.
#[kernel(threads(64), over(params.count))]
pub fn compared(
    id: Invocation,
    params: &LanguageParams,
    x: Read<f32>,
    y: Read<f32>,
    found: Write<u32>,
) {
    if id.index() < params.count {
        let [x, y] = [x.read(id.index()), y.read(id.index())];
        #[allow(clippy::eq_op, clippy::neg_cmp_op_on_partial_ord, clippy::nonminimal_bool)]
        let same = [x == x, x != x, x >= x, !(x <= x)];
        #[allow(clippy::neg_cmp_op_on_partial_ord, clippy::nonminimal_bool)]
        let not = [!(x < y), !(x > y), !(x <= y), !(x >= y)];
        rows! { found [params.count] at id.index();
            u32::from(x < y),
            u32::from(x > y),
            u32::from(x <= y),
            u32::from(x >= y),
            u32::from(x == y),
            u32::from(x != y),
            u32::from(x != 1.0),
            u32::from(not[0]),
            u32::from(not[1]),
            u32::from(not[2]),
            u32::from(not[3]),
            u32::from(same[0]),
            u32::from(same[1]),
            u32::from(same[2]),
            u32::from(same[3]),
            u32::from(x.is_nan()),
            u32::from((x * 2.0).is_nan()),
            x.max(y).to_bits(),
            x.min(y).to_bits(),
            (if x < y || y.is_nan() { x } else { y }).to_bits(),
        }
    }
}
