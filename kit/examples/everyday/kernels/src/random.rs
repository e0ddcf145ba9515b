//! Random numbers without a state: each is a function of its number.

use muslin::{math, prelude::*};

/// Parameters of the kernels of this file.
#[params]
pub struct RandomParams {
    /// Numbers, or blocks of four.
    pub count: u32,
    /// Which sequence.
    pub seed: u32,
}

/// A word of PCG, RXS-M-XS with 32 bits (O'Neill 2014; Jarzynski and Olano 2020).
#[inline(always)]
pub fn pcg(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// A word as a number of 0 to 1, which is below 1: its upper 24 bits.
#[inline(always)]
pub fn unit(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// Numbers of 0 to 1 by [`pcg`]: `numbers [count]`.
#[kernel(threads(256), over(params.count))]
pub fn random_pcg(id: Invocation, params: &RandomParams, numbers: Write<f32>) {
    let index = id.index();
    if index < params.count {
        numbers.write(index, unit(pcg(index ^ pcg(params.seed))));
    }
}

/// Four words by Philox 4x32-10 (Salmon et al. 2011), of a counter and a key.
#[loops]
#[inline(always)]
pub fn philox(counter: UVec4, key: UVec2) -> UVec4 {
    let mut words = counter;
    let mut key = key;
    let mut round = 0;
    while round < 10 {
        let high_0 = math::multiply_high(0xd251_1f53, words.x);
        let low_0 = words.x.wrapping_mul(0xd251_1f53);
        let high_1 = math::multiply_high(0xcd9e_8d57, words.z);
        let low_1 = words.z.wrapping_mul(0xcd9e_8d57);
        words = UVec4::new(high_1 ^ words.y ^ key.x, low_1, high_0 ^ words.w ^ key.y, low_0);
        key.x = key.x.wrapping_add(0x9e37_79b9);
        key.y = key.y.wrapping_add(0xbb67_ae85);
        round += 1;
    }
    words
}

/// Words by [`philox`]: `words [count]`, four each.
#[kernel(threads(256), over(params.count), iterations = 10)]
pub fn random_philox(id: Invocation, params: &RandomParams, words: Write<UVec4>) {
    let index = id.index();
    if index < params.count {
        words.write(index, philox(UVec4::new(index, 0, 0, 0), UVec2::new(params.seed, 0)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The vectors of the authors' own tests (Random123, `kat_vectors`).
    #[test]
    fn philox_gives_the_known_words() {
        let all = u32::MAX;
        let cases = [
            ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([all; 4], [all; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xa409_3822, 0x299f_31d0],
                [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
            ),
        ];
        for (counter, key, words) in cases {
            let found = philox(UVec4::from_array(counter), UVec2::from_array(key));
            assert_eq!(found.to_array(), words, "{counter:x?}");
        }
    }
}
