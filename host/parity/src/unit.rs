//! The case of `unit_begin`, and slices of units for other cases.

use std::ops::Range;

use organza_check::{KernelRunner, Output, Parity, inputs::Random};
use organza_shaders::unit::{UNIT_VALUES, UnitBeginKernel, UnitBeginParams};

use super::exact::listed;
use super::pair::{Bits, mask_sets, scanned};
use organza_device::Result;

/// How samples lie in units, and how those are cut.
#[derive(Clone, Debug)]
pub struct Slices {
    /// Where units begin, and where the last one ends.
    pub first: Vec<u32>,
    /// Samples of a slice.
    pub slice: u32,
}

impl Slices {
    /// Units.
    #[must_use]
    pub fn units(&self) -> u32 {
        self.first.len() as u32 - 1
    }

    /// Every slice: its unit and its samples.
    #[must_use]
    pub fn all(&self) -> Vec<(usize, Range<u32>)> {
        let mut all = Vec::new();
        for (unit, range) in self.first.windows(2).enumerate() {
            let mut begin = range[0];
            while begin < range[1] {
                let end = range[1].min(begin + self.slice);
                all.push((unit, begin..end));
                begin = end;
            }
        }
        all
    }

    /// `[units + 1, 2]`: what `unit_begin` writes.
    #[must_use]
    pub fn table(&self) -> Vec<u32> {
        let all = self.all();
        let before = |unit: usize| all.iter().filter(|(owner, _)| *owner < unit).count() as u32;
        self.first.iter().enumerate().flat_map(|(unit, &first)| [first, before(unit)]).collect()
    }
}

/// Inputs of `unit_begin`.
#[derive(Clone, Debug)]
pub struct UnitBegin {
    /// Words of a camera's mask.
    pub words: u32,
    /// `[cameras, words]`
    pub mask: Vec<u32>,
    /// `[pairs + 1]`, for samples of rays.
    pub first_sample: Option<Vec<u32>>,
    /// Samples of a slice.
    pub slice: u32,
}

/// Cameras.
const UNITS: u32 = 5;

impl UnitBegin {
    fn slices(&self) -> Slices {
        let first_pair = scanned(&self.mask);
        let pairs = (0..=UNITS).map(|unit| first_pair[(unit * self.words) as usize]);
        let first = pairs.map(|pair| match &self.first_sample {
            Some(first_sample) => first_sample[pair as usize],
            None => pair,
        });
        Slices { first: first.collect(), slice: self.slice }
    }
}

impl Parity for UnitBegin {
    const KERNEL: &'static str = "unit_begin";

    fn sets() -> Vec<(String, Self)> {
        let set = |words: u32, bits: Bits, of_rays: bool, random: &mut Random| {
            let mut mask = bits.words(random, UNITS * words);
            // a unit without pairs
            mask[words as usize..2 * words as usize].fill(0);
            let pairs = scanned(&mask).last().copied().unwrap_or(0);
            let mut sum = 0;
            let mut first_sample = vec![0];
            first_sample.extend((0..pairs).map(|_| {
                sum += random.below(9);
                sum
            }));
            Self { words, mask, first_sample: of_rays.then_some(first_sample), slice: 7 }
        };
        let mut sets = mask_sets(|words, bits, random| set(words, bits, false, random));
        let of_rays = mask_sets(|words, bits, random| set(words, bits, true, random));
        sets.extend(of_rays.into_iter().map(|(name, set)| (format!("{name}, rays"), set)));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let first_sample = self.first_sample.as_deref().unwrap_or(&[0]);
        let kernel = UnitBeginKernel {
            params: UnitBeginParams {
                units: UNITS,
                words: self.words,
                slice: self.slice,
                of_rays: u32::from(self.first_sample.is_some()),
            },
            first_pair: &scanned(&self.mask),
            first_sample: &first_sample.to_vec(),
            unit: &runner.unwritten(((UNITS + 1) * UNIT_VALUES) as usize),
        };
        runner.run(&kernel, 1, 1)
    }

    /// The slices are counted one by one.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        listed(self.slices().table())
    }
}
