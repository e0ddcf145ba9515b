//! Cases of `pair_mask` and `pair_fill`.

use organza_kernels::pair::{PairFillKernel, PairFillParams, PairMaskKernel, PairMaskParams};

use super::bench::Bench;
use super::case::Parity;
use super::inputs::{Random, SIZES};
use super::measure::Output;
use crate::error::Result;

/// How masks are filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bits {
    /// Half of them.
    Random,
    /// No bit.
    None,
    /// Every bit.
    All,
    /// The last bit of each word.
    Last,
}

impl Bits {
    /// All ways.
    pub const ALL: [Self; 4] = [Self::Random, Self::None, Self::All, Self::Last];

    /// `len` words.
    pub fn words(self, random: &mut Random, len: u32) -> Vec<u32> {
        let word = |random: &mut Random| match self {
            Self::Random => random.bits(),
            Self::None => 0,
            Self::All => u32::MAX,
            Self::Last => 1 << 31,
        };
        (0..len).map(|_| word(random)).collect()
    }
}

/// Sets of all sizes and fillings.
pub fn mask_sets<T>(make: impl Fn(u32, Bits, &mut Random) -> T) -> Vec<(String, T)> {
    let pairs = SIZES.into_iter().flat_map(|words| Bits::ALL.map(|bits| (words, bits)));
    pairs
        .map(|(words, bits)| {
            let mut random = Random::new(u64::from(words));
            (format!("{bits:?} bits, {words} words"), make(words, bits, &mut random))
        })
        .collect()
}

/// The exclusive sums of the bits' numbers, and the total.
#[must_use]
pub fn scanned(masks: &[u32]) -> Vec<u32> {
    let mut sum = 0;
    let mut prefix = vec![0];
    prefix.extend(masks.iter().map(|mask| {
        sum += mask.count_ones();
        sum
    }));
    prefix
}

/// Inputs of `pair_mask`.
#[derive(Clone, Debug)]
pub struct PairMask {
    /// Words of a mask.
    pub words: u32,
    /// `[cameras + 1]`
    pub first_tile: Vec<u32>,
    /// `[tiles, words]`
    pub tile_mask: Vec<u32>,
}

impl Parity for PairMask {
    const KERNEL: &'static str = "pair_mask";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "integers";

    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| {
            // a camera without tiles, one with one, one with the rest
            let tile_mask = bits.words(random, 5 * words);
            Self { words, first_tile: vec![0, 0, 1, 5], tile_mask }
        })
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let cameras = self.first_tile.len() as u32 - 1;
        let [mask, count] = [(); 2].map(|()| bench.output((cameras * self.words) as usize));
        let (mask, count) = (mask?, count?);
        let kernel = PairMaskKernel {
            params: PairMaskParams { words: self.words },
            first_tile: &bench.upload(&self.first_tile)?,
            tile_mask: &bench.upload(&self.tile_mask)?,
            mask: &mask,
            count: &count,
        };
        bench.items(&kernel, self.words, cameras)?;
        Ok(vec![
            Output::exact("mask", bench.read(&mask)?),
            Output::exact("count", bench.read(&count)?),
        ])
    }
}

/// Inputs of `pair_fill`.
#[derive(Clone, Debug)]
pub struct PairFill {
    /// Words of a mask.
    pub words: u32,
    /// `[cameras, words]`
    pub mask: Vec<u32>,
}

impl Parity for PairFill {
    const KERNEL: &'static str = "pair_fill";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "integers";

    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| Self { words, mask: bits.words(random, 2 * words) })
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let first_pair = scanned(&self.mask);
        let pair = bench.output(*first_pair.last().unwrap_or(&0) as usize)?;
        let kernel = PairFillKernel {
            params: PairFillParams { words: self.words, gaussians: self.words * 32 },
            mask: &bench.upload(&self.mask)?,
            first_pair: &bench.upload(&first_pair)?,
            pair: &pair,
        };
        bench.items(&kernel, self.words, 2)?;
        Ok(vec![Output::exact("pair", bench.read(&pair)?)])
    }
}
