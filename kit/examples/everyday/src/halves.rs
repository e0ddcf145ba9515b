//! Numbers of 16 bits.

use glam::Vec2;
use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::halves::{
    HalvesAddInputs, HalvesAddKernel, HalvesPackInputs, HalvesPackKernel, HalvesParams,
};

/// Rounds pairs of numbers to halves.
///
/// # Errors
/// Any error of the device.
pub fn pack(device: &Device, numbers: &Buffer<Vec2>) -> Result<Buffer<u32>> {
    let params = HalvesParams { words: numbers.len() as u32 };
    let halves = device.unwritten("halves", numbers.len())?;
    device.run_all(&HalvesPackKernel { params, numbers, halves: &halves })?;
    Ok(halves)
}

/// Adds halves to pairs of numbers.
///
/// # Errors
/// Any error of the device.
pub fn add(device: &Device, terms: &Buffer<u32>, numbers: &Buffer<Vec2>) -> Result<()> {
    let params = HalvesParams { words: numbers.len() as u32 };
    device.run_all(&HalvesAddKernel { params, terms, numbers })
}

/// Numbers of 11 bits, and a power of two: halves are exact.
pub(crate) fn exact_halves(count: u32, random: &mut Random) -> Vec<f32> {
    let number = |_| (random.below(2048) as f32 - 1024.0) / 64.0;
    (0..count).map(number).collect()
}

/// The bits of a number that is exact as a half: its sign, its exponent, and its ten upper digits.
pub(crate) fn bits(x: f32) -> u32 {
    let bits = x.to_bits();
    match x == 0.0 {
        true => bits >> 16,
        false => {
            let exponent = ((bits >> 23) & 0xff) - 112;
            ((bits >> 16) & 0x8000) + (exponent << 10) + ((bits >> 13) & 0x3ff)
        }
    }
}

case!(pub HalvesPack(HalvesPackInputs));

impl Parity for HalvesPack {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|words, _, random| {
            let numbers = exact_halves(2 * words, random);
            let pairs = numbers.chunks(2).map(Vec2::from_slice).collect();
            let params = HalvesParams { words };
            Self(HalvesPackInputs { params, numbers: pairs, halves: unwritten(words as usize) })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let pair = self.numbers[index];
        Some((bits(pair.x) | (bits(pair.y) << 16)).into())
    }
}

case!(pub HalvesAdd(HalvesAddInputs));

impl Parity for HalvesAdd {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|words, _, random| {
            let terms = exact_halves(2 * words, random);
            let mut number = || random.between(-1.0, 1.0);
            let numbers = (0..words).map(|_| Vec2::new(number(), number())).collect();
            let word = |pair: &[f32]| bits(pair[0]) | (bits(pair[1]) << 16);
            let terms = terms.chunks(2).map(word).collect();
            Self(HalvesAddInputs { params: HalvesParams { words }, terms, numbers })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let value = |half: u32| match half & 0x7fff {
            0 => 0.0,
            size => {
                let digits = 1.0 + f64::from(size & 0x3ff) / 1024.0;
                let value = digits * 2.0_f64.powi((size >> 10) as i32 - 15);
                if half & 0x8000 == 0 { value } else { -value }
            }
        };
        let of = |(number, term): (&Vec2, &u32)| {
            let [x, y] = [term & 0xffff, term >> 16].map(|half| Rounded::exact(value(half)));
            [Rounded::from(number.x) + x, Rounded::from(number.y) + y]
        };
        listed(self.numbers.iter().zip(&self.terms).flat_map(of))
    }
}
