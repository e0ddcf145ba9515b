//! Random numbers.

use glam::UVec4;
use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::random::{
    RandomParams, RandomPcgInputs, RandomPcgKernel, RandomPhiloxInputs, RandomPhiloxKernel,
};

/// `count` numbers of 0 to 1, below 1.
///
/// # Errors
/// Any error of the device.
pub fn pcg(device: &Device, count: u32, seed: u32) -> Result<Buffer<f32>> {
    let numbers = device.unwritten("random numbers", count as usize)?;
    device.run_all(&RandomPcgKernel { params: RandomParams { count, seed }, numbers: &numbers })?;
    Ok(numbers)
}

/// `count` times four words.
///
/// # Errors
/// Any error of the device.
pub fn philox(device: &Device, count: u32, seed: u32) -> Result<Buffer<UVec4>> {
    let words = device.unwritten("random words", count as usize)?;
    device.run_all(&RandomPhiloxKernel { params: RandomParams { count, seed }, words: &words })?;
    Ok(words)
}

/// The product of two words, in 64 bits.
fn wide(a: u32, b: u32) -> [u32; 2] {
    let product = u64::from(a) * u64::from(b);
    [(product >> 32) as u32, product as u32]
}

case!(pub RandomPcg(RandomPcgInputs));

impl Parity for RandomPcg {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let params = RandomParams { count, seed: random.bits() };
            Self(RandomPcgInputs { params, numbers: unwritten(count as usize) })
        })
    }

    /// As its authors write it, in 64 bits.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let pcg = |input: u32| {
            let state = ((u64::from(input) * 747_796_405 + 2_891_336_453) & 0xffff_ffff) as u32;
            let [_, word] = wide((state >> ((state >> 28) + 4)) ^ state, 277_803_737);
            (word >> 22) ^ word
        };
        let word = pcg(index as u32 ^ pcg(self.params.seed));
        Some(Rounded::exact(f64::from(word >> 8) / f64::from(1 << 24)))
    }
}

case!(pub RandomPhilox(RandomPhiloxInputs));

impl Parity for RandomPhilox {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let params = RandomParams { count, seed: random.bits() };
            Self(RandomPhiloxInputs { params, words: unwritten(count as usize) })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let words = |index: u32| {
            let [mut a, mut b, mut c, mut d] = [index, 0, 0, 0];
            let mut key = [self.params.seed, 0];
            for _ in 0..10 {
                let [high_0, low_0] = wide(0xd251_1f53, a);
                let [high_1, low_1] = wide(0xcd9e_8d57, c);
                [a, b, c, d] = [high_1 ^ b ^ key[0], low_1, high_0 ^ d ^ key[1], low_0];
                key = [key[0].wrapping_add(0x9e37_79b9), key[1].wrapping_add(0xbb67_ae85)];
            }
            [a, b, c, d]
        };
        listed((0..self.params.count).flat_map(words))
    }
}
