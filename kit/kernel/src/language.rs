//! Kernels that tests run on every device, because they use what no kernel of organza does.

use crate::math::HUGE;
use crate::prelude::*;
use crate::subgroup::{SIZES, lanes, lanes_before};

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

/// Parameters of [`row_ranges`] and [`keep_even`].
#[params]
pub struct RowParams {
    /// Number of rows.
    pub rows: u32,
    /// Values of a row, at most [`MAX_COLUMNS`].
    pub columns: u32,
}

/// Most values of a row of [`row_ranges`] and [`keep_even`].
pub const MAX_COLUMNS: u32 = 4096;
/// Invocations of a row: subgroups of 64 and of 128 have lanes that are missing.
const ROW: u32 = 96;
/// Most subgroups of a row.
const MAX_PARTS: u32 = ROW / SIZES[0];

/// Of each row of `values [rows, columns]`, the sum, the smallest and the largest value: `output [rows, 3]`. A row has at least one value.
#[kernel(threads(ROW), subgroups, iterations = MAX_COLUMNS.div_ceil(ROW) + MAX_PARTS)]
pub fn row_ranges(
    id: Invocation,
    params: &RowParams,
    values: Read<f32>,
    output: Write<f32>,
    parts: Shared<f32, { 3 * MAX_PARTS as usize }>,
    part_count: Shared<u32, 1>,
) {
    let own = id.local.x;
    let row = id.workgroup_index();
    let columns = if row < params.rows { params.columns } else { 0 };
    if own == 0 {
        part_count.write(0, 0);
    }
    let [mut sum, mut low, mut high] = [0.0, HUGE, -HUGE];
    let mut column = own;
    while column < columns {
        let value = values.read(row * columns + column);
        sum += value;
        low = low.min(value);
        high = high.max(value);
        column += ROW;
    }
    id.barrier();
    sum = id.subgroup_sum(sum);
    low = id.subgroup_min(low);
    high = id.subgroup_max(high);
    if id.subgroup_lane() == 0 {
        // nothing says which invocations are a subgroup, so it takes a number
        let part = 3 * part_count.atomic_add(0, 1);
        parts.write(part, sum);
        parts.write(part + 1, low);
        parts.write(part + 2, high);
    }
    id.barrier();
    if own == 0 && row < params.rows {
        let mut part = 1;
        [sum, low, high] = [parts.read(0), parts.read(1), parts.read(2)];
        while part < part_count.read(0) {
            sum += parts.read(3 * part);
            low = low.min(parts.read(3 * part + 1));
            high = high.max(parts.read(3 * part + 2));
            part += 1;
        }
        output.write(3 * row, sum);
        output.write(3 * row + 1, low);
        output.write(3 * row + 2, high);
    }
}

/// The even ones of each row of `values [rows, columns]`, in any order, then ones: `kept [rows, columns]`. `counts [rows]` says how many are even.
#[kernel(threads(ROW), subgroups, iterations = 2 * MAX_COLUMNS.div_ceil(ROW), unordered(kept))]
pub fn keep_even(
    id: Invocation,
    params: &RowParams,
    values: Read<u32>,
    kept: Write<u32>,
    counts: Write<u32>,
    next: Shared<u32, 1>,
) {
    let own = id.local.x;
    let row = id.workgroup_index();
    let first = row * params.columns;
    if own == 0 {
        next.write(0, 0);
    }
    id.barrier();
    let mut begin = 0;
    // all lanes take part in all rounds
    while begin < params.columns {
        let column = begin + own;
        let is_inside = row < params.rows && column < params.columns;
        let value = if is_inside { values.read(first + column) } else { 1 };
        let is_even = value % 2 == 0;
        let ballot = id.subgroup_ballot(is_even);
        let mut at = 0;
        if id.subgroup_lane() == 0 {
            at = next.atomic_add(0, lanes(ballot));
        }
        at = id.subgroup_broadcast_first(at) + lanes_before(ballot, id.subgroup_lane());
        if is_even {
            kept.write(first + at, value);
        }
        begin += ROW;
    }
    id.barrier();
    if row < params.rows {
        let count = next.read(0);
        let mut column = count + own;
        while column < params.columns {
            kept.write(first + column, 1);
            column += ROW;
        }
        if own == 0 {
            counts.write(row, count);
        }
    }
}
