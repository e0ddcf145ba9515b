//! Numbers of 16 bits, two in a word: half of the memory, and 11 bits of precision.

use muslin::math::{pack_half_2x16, unpack_half_2x16};
use muslin::prelude::*;

/// Parameters of the kernels of this file.
#[params]
pub struct HalvesParams {
    /// Words, of two numbers each.
    pub words: u32,
}

/// Rounds numbers to halves, two in a word: `numbers [2 * words]`, `halves [words]`.
#[kernel(threads(256), over(params.words))]
pub fn halves_pack(id: Invocation, params: &HalvesParams, numbers: Read<Vec2>, halves: Write<u32>) {
    let index = id.index();
    if index < params.words {
        halves.write(index, pack_half_2x16(numbers.read(index)));
    }
}

/// `numbers += terms`, of halves: `terms [words]`, `numbers [2 * words]`.
#[kernel(threads(256), over(params.words))]
pub fn halves_add(id: Invocation, params: &HalvesParams, terms: Read<u32>, numbers: Write<Vec2>) {
    let index = id.index();
    if index < params.words {
        numbers.write(index, numbers.read(index) + unpack_half_2x16(terms.read(index)));
    }
}
