//! Packed integers, sorts by storage barriers, subgroups, and arithmetic and comparisons as they are written.

use muslin::math::HUGE;
use muslin::prelude::*;
use muslin::subgroup::{SIZES, lanes, lanes_before};

use crate::{CountParams, rows};

/// Values of a byte.
pub const BYTES: usize = 256;
/// Bins of both histograms.
const BINS: usize = 2 * BYTES;

/// Adds to `bins [2 * 256]` how often each value of a byte is among `bytes [count]`, and each upper half of `halves [count]`.
#[kernel(threads(BYTES), over(params.count))]
pub fn byte_histogram(
    id: Invocation,
    params: &CountParams,
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

/// The part of each of `values [count]` in the sum of the 64 values of its workgroup, to `shares [count]`.
#[kernel(threads(64), over(params.count), lanes(count), iterations = 6)]
pub fn shares<L: Lane>(
    id: Invocation,
    params: &CountParams,
    values: Read<f32>,
    shares: Write<f32>,
    sums: Shared<f32, 64>,
) {
    let at = id.local.x;
    let own = L::read_below(values, id.index(), params.count);
    own.write_shared(sums, at);
    id.barrier();
    let mut half = 32;
    while half > 0 {
        if at < half {
            let sum = L::read_shared(sums, at) + L::read_shared(sums, at + half);
            sum.write_shared_below(sums, at, half);
        }
        id.barrier();
        half /= 2;
    }
    if id.index() < params.count {
        (own / L::splat(sums.read(0))).write(shares, id.index());
    }
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

/// Parameters of [`keep_positive`].
#[params]
pub struct RowParams {
    /// Number of rows.
    pub rows: u32,
    /// Values of a row, at most [`MAX_COLUMNS`].
    pub columns: u32,
}

/// Most values of a row of [`keep_positive`].
pub const MAX_COLUMNS: u32 = 4096;
/// Invocations of a row: subgroups of 64 and of 128 have lanes that are missing.
const ROW: u32 = 96;
/// Most subgroups of a row.
const MAX_PARTS: u32 = ROW / SIZES[0];

/// Of each row of `values [rows, columns]`: the positive ones in any order, then zeros, to `kept [rows, columns]`; and how many these are,
/// then the sum, the smallest and the largest value of the row, to `output [rows, 4]`.
#[kernel(threads(ROW), over(96 * params.rows), subgroups, iterations = 2 * MAX_COLUMNS.div_ceil(ROW) + MAX_PARTS, unordered(kept))]
pub fn keep_positive(
    id: Invocation,
    params: &RowParams,
    values: Read<f32>,
    kept: Write<f32>,
    output: Write<f32>,
    parts: Shared<Vec4, { MAX_PARTS as usize }>,
    counts: Shared<u32, 2>,
) {
    let own = id.local.x;
    let lane = id.subgroup_lane();
    let row = id.workgroup_index();
    let first = row * params.columns;
    if own < 2 {
        counts.write(own, 0);
    }
    id.barrier();
    let [mut sum, mut low, mut high] = [0.0, HUGE, -HUGE];
    let mut begin = 0;
    // all lanes take part in all rounds
    while begin < params.columns {
        let mut value = 0.0;
        if row < params.rows && begin + own < params.columns {
            value = values.read(first + begin + own);
            sum += value;
            low = low.min(value);
            high = high.max(value);
        }
        let ballot = id.subgroup_ballot(value > 0.0);
        let mut at = 0;
        if lane == 0 {
            at = counts.atomic_add(0, lanes(ballot));
        }
        at = id.subgroup_broadcast_first(at);
        if value > 0.0 {
            kept.write(first + at + lanes_before(ballot, lane), value);
        }
        begin += ROW;
    }
    sum = id.subgroup_sum(sum);
    low = id.subgroup_min(low);
    high = id.subgroup_max(high);
    if lane == 0 {
        // nothing says which invocations are a subgroup, so it takes a number
        parts.write(counts.atomic_add(1, 1), Vec4::new(sum, low, high, 0.0));
    }
    id.barrier();
    if row < params.rows {
        let count = counts.read(0);
        let mut column = count + own;
        while column < params.columns {
            kept.write(first + column, 0.0);
            column += ROW;
        }
        if own == 0 {
            let mut all = parts.read(0);
            let mut part = 1;
            while part < counts.read(1) {
                let other = parts.read(part);
                all = Vec4::new(all.x + other.x, all.y.min(other.y), all.z.max(other.z), 0.0);
                part += 1;
            }
            output.write(4 * row, count as f32);
            output.write(4 * row + 1, all.x);
            output.write(4 * row + 2, all.y);
            output.write(4 * row + 3, all.z);
        }
    }
}

/// `found [5, count]`: an exclusive scan of ones, the last lane's inclusive scan of `values`, the lane that the next lane gives, and the lane
/// that the neighbor in a pair gives. What each must be is subtracted. Then how many operations of signed numbers, of bits and of truths are wrong.
#[kernel(threads(ROW), over(params.count), subgroups)]
pub fn scan_and_shuffle(
    id: Invocation,
    params: &CountParams,
    values: Read<u32>,
    found: Write<u32>,
) {
    let lane = id.subgroup_lane();
    let mut value = 0;
    if id.index() < params.count {
        value = values.read(id.index());
    }
    let lanes = id.subgroup_sum(1);
    let next = (lane + 1) % lanes;
    // all lanes take part
    let before = id.subgroup_exclusive_sum(1);
    let up_to_last = id.subgroup_shuffle(id.subgroup_inclusive_sum(value), lanes - 1);
    let sum = id.subgroup_sum(value);
    let shuffled = id.subgroup_shuffle(lane, next);
    let paired = id.subgroup_shuffle_xor(lane, 1);
    // of lanes 0 to 31; others have the same bits
    let bit = 1 << (lane % 32);
    let all_bits = if lanes < 32 { (1 << lanes) - 1 } else { !0 };
    let place = lane as i32;
    let mut wrong = 0;
    wrong += (id.subgroup_sum(-place) != -((lanes * (lanes - 1) / 2) as i32)) as u32;
    wrong += (id.subgroup_min(5 - place) != 6 - lanes as i32) as u32;
    wrong += (id.subgroup_max(-5 - place) != -5) as u32;
    wrong += (id.subgroup_inclusive_sum(-1) != -1 - place) as u32;
    wrong += (id.subgroup_shuffle(-place, next) != -(next as i32)) as u32;
    wrong += (id.subgroup_or(bit) != all_bits) as u32;
    wrong += (id.subgroup_and(!bit) != !all_bits) as u32;
    wrong += (id.subgroup_xor(value) ^ id.subgroup_xor(value ^ 6) != lanes % 2 * 6) as u32;
    wrong += (!id.subgroup_any(lane + 1 == lanes)) as u32;
    wrong += (id.subgroup_any(lane == lanes)) as u32;
    wrong += (!id.subgroup_all(lane < lanes)) as u32;
    wrong += (id.subgroup_all(lane > 0)) as u32;
    if id.index() < params.count {
        found.write(id.index(), before.wrapping_sub(lane));
        found.write(params.count + id.index(), up_to_last.wrapping_sub(sum));
        found.write(2 * params.count + id.index(), shuffled.wrapping_sub(next));
        found.write(3 * params.count + id.index(), paired.wrapping_sub(lane ^ 1));
        found.write(4 * params.count + id.index(), wrong);
    }
}

/// Rows of [`as_written`].
pub const AS_WRITTEN_ROWS: usize = 24;

/// `bits [24, count]`: arithmetic of `x` and `y`, which gives something else if a compiler regroups or shortens it.
#[kernel(threads(64), over(params.count))]
pub fn as_written(
    id: Invocation,
    params: &CountParams,
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
    params: &CountParams,
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
