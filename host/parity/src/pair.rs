//! Cases of `pair_mask`, `pair_fill` and `pair_sum`.

use muslin_check::prelude::*;
use organza_shaders::pair::{
    PairFillInputs, PairFillParams, PairMaskInputs, PairMaskParams, PairSumInputs, PairSumParams,
};

use super::exact::bits;
use super::scan::prefix;

/// How a word of a mask is filled.
pub type Bits = fn(&mut Random) -> u32;

/// Half of a word's bits, none, all, and the last one.
const BITS: [(&str, Bits); 4] =
    [("Random", Random::bits), ("None", |_| 0), ("All", |_| u32::MAX), ("Last", |_| 1 << 31)];

/// Words of a mask.
pub fn mask(len: u32, bits: Bits, random: &mut Random) -> Vec<u32> {
    (0..len).map(|_| bits(random)).collect()
}

/// Sets of all sizes and fillings.
pub fn mask_sets<T>(make: impl Fn(u32, Bits, &mut Random) -> T) -> Vec<(String, T)> {
    let set = |words: u32, (name, bits): (&str, Bits)| {
        (format!("{name} bits, {words} words"), make(words, bits, &mut Random::new(words.into())))
    };
    SIZES.into_iter().flat_map(|words| BITS.map(|bits| set(words, bits))).collect()
}

/// The exclusive sums of the bits' numbers, and the total.
pub fn scanned(masks: &[u32]) -> Vec<u32> {
    prefix(masks.iter().map(|mask| mask.count_ones()))
}

case!(pub PairMask(PairMaskInputs));

impl Parity for PairMask {
    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| {
            // a camera without tiles, one with one, one with the rest
            let len = 3 * words as usize;
            Self(PairMaskInputs {
                params: PairMaskParams { words },
                first_tile: vec![0, 0, 1, 5],
                tile_mask: mask(5 * words, bits, random),
                mask: unwritten(len),
                count: unwritten(len),
            })
        })
    }

    /// The union of a camera's tiles.
    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let words = self.params.words as usize;
        let cameras = self.first_tile.windows(2);
        let union = cameras.flat_map(|tiles| {
            let tiles = tiles[0] as usize..tiles[1] as usize;
            (0..words).map(move |word| {
                tiles.clone().fold(0, |mask, tile| mask | self.tile_mask[tile * words + word])
            })
        });
        listed(union.map(|mask| if output == "mask" { mask } else { mask.count_ones() }))
    }
}

case!(pub PairFill(PairFillInputs));

impl Parity for PairFill {
    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| {
            let mask = mask(2 * words, bits, random);
            let first_pair = scanned(&mask);
            Self(PairFillInputs {
                params: PairFillParams { words, gaussians: words * 32 },
                mask,
                pair: unwritten(first_pair[first_pair.len() - 1] as usize),
                first_pair,
            })
        })
    }

    /// The words of both cameras follow each other, and so do their pairs.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        listed(bits(&self.mask).map(|pair| pair as u32))
    }
}

case!(pub PairSum(PairSumInputs));

impl Parity for PairSum {
    fn sets() -> Vec<(String, Self)> {
        let set = |words: u32, bits: Bits, width: u32, fill: Fill, random: &mut Random| {
            let mask = mask(3 * words, bits, random);
            let first_pair = scanned(&mask);
            let pairs = first_pair[mask.len()];
            // the last word is not full
            let gaussians = (words * 32).saturating_sub(5);
            let mut values =
                |len: u32| fill.values(random, (len * width) as usize, [-1.0, 1.0], 1e30);
            Self(PairSumInputs {
                params: PairSumParams { words, first_camera: 0, cameras: 3, gaussians, width },
                first_pair,
                mask,
                pair_vector: values(pairs),
                vector: values(gaussians),
            })
        };
        let mut sets =
            mask_sets(|words, bits, random| set(words.min(129), bits, 2, Fill::Random, random));
        for fill in Fill::ADVERSARIAL {
            sets.push((fill.name().into(), set(5, Random::bits, 7, fill, &mut Random::new(16))));
        }
        sets
    }

    /// The vector before, and the vectors of the pairs, which lie in the order of the masks' bits.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let mut sums: Vec<_> = self.vector.iter().copied().map(Rounded::from).collect();
        let width = self.params.width as usize;
        for (vector, slot) in self.pair_vector.chunks(width).zip(bits(&self.mask)) {
            let gaussian = slot % (32 * self.params.words as usize);
            // bits behind the last Gaussian belong to none
            let sums = sums.get_mut(gaussian * width..).unwrap_or_default();
            sums.iter_mut().zip(vector).for_each(|(sum, &value)| *sum = *sum + value.into());
        }
        listed(sums)
    }
}
