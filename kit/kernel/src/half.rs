//! 16-bit floats (halves), two in a word.

/// The value of a half, from its 16 bits. It must be 0 or at least 2^-14: drivers flush smaller ones to zero.
#[inline(always)]
pub fn half_value(bits: u32) -> f32 {
    // moves the exponent to its place in a float; only the difference of the biases is missing
    let moved = f32::from_bits((bits & 0x8000) << 16 | (bits & 0x7fff) << 13);
    moved * TWO_TO_112
}

/// 2^112, the ratio of the biases: 127 - 15 = 112.
const TWO_TO_112: f32 = f32::from_bits((127 + 112) << 23);
