//! Exclusive prefix sums, in two ways: in passes, and in a single pass that looks back.
//!
//! The sum within a block stands in both: a CPU cuts kernels only at barriers that it sees, and not at those of a function.

use muslin::prelude::*;

/// Values of a block, which a workgroup takes.
pub const BLOCK: u32 = 256;

/// Parameters of the kernels of this file.
#[params]
pub struct PrefixParams {
    /// Values.
    pub count: u32,
}

/// The prefix sums within each block, and the sums of the blocks: `values [count]`, `prefix [count]`, `sums [count / 256]`, rounded up.
#[kernel(threads(BLOCK), over(params.count), iterations = 8)]
pub fn prefix_blocks(
    id: Invocation,
    params: &PrefixParams,
    values: Read<u32>,
    prefix: Write<u32>,
    sums: Write<u32>,
    part: Shared<u32, { BLOCK as usize }>,
) {
    let index = id.index();
    let value = if index < params.count { values.read(index) } else { 0 };
    // the sum of the block's values up to the own one, with it: each round adds what is twice as far away
    let own = id.local.x;
    let mut sum = value;
    part.write(own, sum);
    id.barrier();
    let mut stride = 1;
    while stride < BLOCK {
        if own >= stride {
            sum += part.read(own - stride);
        }
        id.barrier();
        part.write(own, sum);
        id.barrier();
        stride *= 2;
    }
    if index < params.count {
        prefix.write(index, sum - value);
    }
    if own == 0 && index < params.count {
        sums.write(id.workgroup_index(), part.read(BLOCK - 1));
    }
}

/// Adds to each value of `prefix [count]` what its block begins with: `before [count / 256]`, rounded up.
#[kernel(threads(BLOCK), over(params.count))]
pub fn prefix_add(id: Invocation, params: &PrefixParams, before: Read<u32>, prefix: Write<u32>) {
    let index = id.index();
    if index < params.count {
        prefix.write(index, prefix.read(index) + before.read(id.workgroup_index()));
    }
}

/// The largest sum of [`prefix_look_back`].
pub const LARGEST: u32 = (1 << 30) - 1;
/// In the upper bits of a state: the lower ones are the block's own sum.
const OWN: u32 = 1 << 30;
/// In the upper bits of a state: the lower ones are the sum up to the block's end.
const ALL: u32 = 2 << 30;

/// The prefix sums in a single pass, by decoupled look-back (Merrill and Garland 2016): `values [count]`, `prefix [count]`, of sums up to
/// [`LARGEST`]. `ticket [1]` and `state [count / 256]`, rounded up, are zeros.
///
/// Blocks are numbered in the order in which workgroups begin. A block asks those before it, the nearest first, for what they know. It
/// adds up the values of a block that knows nothing yet: a GPU need not run that one before this one ends.
#[kernel(threads(BLOCK), over(params.count), iterations = 60_000)]
pub fn prefix_look_back(
    id: Invocation,
    params: &PrefixParams,
    values: Read<u32>,
    ticket: Write<u32>,
    state: Write<u32>,
    prefix: Write<u32>,
    part: Shared<u32, { BLOCK as usize }>,
    block: Shared<u32, 2>,
) {
    if id.local.x == 0 {
        block.write(0, ticket.atomic_add(0, 1));
    }
    id.barrier();
    let number = block.read(0);
    let index = number * BLOCK + id.local.x;
    let value = if index < params.count { values.read(index) } else { 0 };
    // the sum of the block's values up to the own one, with it: each round adds what is twice as far away
    let own = id.local.x;
    let mut sum = value;
    part.write(own, sum);
    id.barrier();
    let mut stride = 1;
    while stride < BLOCK {
        if own >= stride {
            sum += part.read(own - stride);
        }
        id.barrier();
        part.write(own, sum);
        id.barrier();
        stride *= 2;
    }
    if own == 0 && index < params.count {
        let all = part.read(BLOCK - 1);
        state.atomic_store(number, OWN + all);
        let before = look_back(number, values, state);
        state.atomic_store(number, ALL + before + all);
        block.write(1, before);
    }
    id.barrier();
    if index < params.count {
        prefix.write(index, block.read(1) + sum - value);
    }
}

/// The sum of all blocks before this one.
#[loops]
#[inline(always)]
fn look_back(block: u32, values: Read<u32>, state: Write<u32>) -> u32 {
    let mut sum = 0;
    let mut at = block;
    while at > 0 {
        at -= 1;
        let known = state.atomic_load(at);
        if known < OWN {
            let mut index = at * BLOCK;
            while index < (at + 1) * BLOCK {
                sum += values.read(index);
                index += 1;
            }
        } else {
            sum += known % OWN;
        }
        at = if known < ALL { at } else { 0 };
    }
    sum
}
