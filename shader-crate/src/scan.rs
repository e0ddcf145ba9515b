//! Exclusive prefix sums.

use muslin::prelude::*;

/// Invocations of a workgroup.
const THREADS: u32 = 64;

/// Values that one invocation sums on its own.
const VALUES: u32 = 16;

/// Values that a workgroup scans.
pub const BLOCK: u32 = THREADS * VALUES;

/// Parameters of [`scan_block`] and [`scan_add`].
#[params]
pub struct ScanParams {
    /// Values to scan.
    pub count: u32,
}

/// Scans blocks of [`BLOCK`] values: `prefix [count + 1]` is exclusive and starts at 0 in each block, `block_sum` has
/// the sum of each block. The value at `count` is taken as 0, so that the last prefix becomes the total.
#[kernel(threads(64), over(block_sum.len() * 64), iterations = 2 * VALUES + THREADS.ilog2())]
pub fn scan_block(
    id: Invocation,
    params: &ScanParams,
    value: Read<u32>,
    prefix: Write<u32>,
    block_sum: Write<u32>,
    sums: Shared<u32, 64>,
) {
    let thread = id.local.x;
    let block = id.workgroup_index();
    let first = (block * THREADS + thread) * VALUES;
    let mut sum = 0;
    let mut i = 0;
    while i < VALUES {
        if first + i < params.count {
            sum += value.read(first + i);
        }
        i += 1;
    }
    // Hillis and Steele's
    let mut inclusive = sum;
    sums.write(thread, inclusive);
    id.barrier();
    let mut step = 1;
    while step < THREADS {
        if thread >= step {
            inclusive += sums.read(thread - step);
        }
        id.barrier();
        sums.write(thread, inclusive);
        id.barrier();
        step *= 2;
    }
    let mut next = inclusive - sum;
    let mut i = 0;
    while i < VALUES {
        if first + i <= params.count {
            prefix.write(first + i, next);
        }
        if first + i < params.count {
            next += value.read(first + i);
        }
        i += 1;
    }
    // a dispatch along two axes may end with workgroups that have no block
    if thread == THREADS - 1 && block * BLOCK <= params.count {
        block_sum.write(block, inclusive);
    }
}

/// Adds to every prefix the sum of the blocks before it: `block_prefix` is the scan of the blocks' sums.
#[kernel(threads(64), over(params.count + 1))]
pub fn scan_add(id: Invocation, params: &ScanParams, block_prefix: Read<u32>, prefix: Write<u32>) {
    let index = id.index();
    if index <= params.count {
        let before = block_prefix.read(index / BLOCK);
        prefix.write(index, prefix.read(index) + before);
    }
}
