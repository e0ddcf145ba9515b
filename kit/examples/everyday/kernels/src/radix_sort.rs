//! Sorts keys with values, digit by digit, the lowest first: a radix sort.

use muslin::prelude::*;

/// Keys of a block, which a workgroup takes.
pub const BLOCK: u32 = 256;
/// Bits of a digit.
pub const BITS: u32 = 4;
/// Different digits.
pub const DIGITS: u32 = 1 << BITS;

/// Parameters of the kernels of this file.
#[params]
pub struct RadixParams {
    /// Keys.
    pub count: u32,
    /// Blocks: `count / 256`, rounded up.
    pub blocks: u32,
    /// The digit's lowest bit.
    pub shift: u32,
}

/// The digit of a key.
#[inline(always)]
fn digit(key: u32, shift: u32) -> u32 {
    (key >> shift) % DIGITS
}

/// How often each digit occurs in each block: `keys [count]`, `counts [16, blocks]`.
#[kernel(threads(BLOCK), over(params.count))]
pub fn radix_count(
    id: Invocation,
    params: &RadixParams,
    keys: Read<u32>,
    counts: Write<u32>,
    bins: Shared<u32, { DIGITS as usize }>,
) {
    let own = id.local.x;
    if own < DIGITS {
        bins.write(own, 0);
    }
    id.barrier();
    if id.index() < params.count {
        bins.atomic_add(digit(keys.read(id.index()), params.shift), 1);
    }
    id.barrier();
    let block = id.workgroup_index();
    if own < DIGITS && block < params.blocks {
        counts.write(own * params.blocks + block, bins.read(own));
    }
}

/// Moves keys and values to where their digits belong, and keeps the order of equal digits: `keys [count]`, `values [count]`, `places
/// [16, blocks]` are the prefix sums of the counts, `sorted_keys [count]`, `sorted_values [count]`.
///
/// A block first sorts itself, bit by bit.
#[kernel(threads(BLOCK), over(params.count), iterations = BITS * 9)]
pub fn radix_scatter(
    id: Invocation,
    params: &RadixParams,
    keys: Read<u32>,
    values: Read<u32>,
    places: Read<u32>,
    sorted_keys: Write<u32>,
    sorted_values: Write<u32>,
    key_tile: Shared<u32, { BLOCK as usize }>,
    value_tile: Shared<u32, { BLOCK as usize }>,
    part: Shared<u32, { BLOCK as usize }>,
    starts: Shared<u32, { DIGITS as usize }>,
) {
    let own = id.local.x;
    let index = id.index();
    // behind the last key, the largest digit: the order of equal digits keeps it behind
    let mut key = u32::MAX;
    let mut value = 0;
    if index < params.count {
        key = keys.read(index);
        value = values.read(index);
    }
    let mut bit = 0;
    while bit < BITS {
        let is_one = (key >> (params.shift + bit)) % 2;
        // how many zeros there are up to the own key
        let mut zeros = 1 - is_one;
        part.write(own, zeros);
        id.barrier();
        let mut stride = 1;
        while stride < BLOCK {
            if own >= stride {
                zeros += part.read(own - stride);
            }
            id.barrier();
            part.write(own, zeros);
            id.barrier();
            stride *= 2;
        }
        let all = part.read(BLOCK - 1);
        let to = if is_one == 0 { zeros - 1 } else { all + own - zeros };
        key_tile.write(to, key);
        value_tile.write(to, value);
        id.barrier();
        key = key_tile.read(own);
        value = value_tile.read(own);
        id.barrier();
        bit += 1;
    }
    let digit = digit(key, params.shift);
    part.write(own, digit);
    id.barrier();
    if own == 0 || part.read(own.max(1) - 1) != digit {
        starts.write(digit, own);
    }
    id.barrier();
    if index < params.count {
        let place = places.read(digit * params.blocks + id.workgroup_index());
        let to = place + own - starts.read(digit);
        sorted_keys.write(to, key);
        sorted_values.write(to, value);
    }
}
