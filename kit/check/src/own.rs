//! The case of the kit's own kernel, `count_fill`.

use muslin_kernel::count::{CountFillInputs, PLACEMENT_VALUES};

use crate::prelude::*;

case!(pub CountFill(CountFillInputs));

impl Parity for CountFill {
    fn sets() -> Vec<(String, Self)> {
        let of = |size: u32, misfit: u32| {
            let mut random = Random::new(u64::from(size));
            let mut placement = vec![size, 0, 0, 0];
            for number in 0..size {
                let slot = 1 + random.below(3);
                // every other word
                placement.extend([2 * number, slot, random.below(3000), random.below(1000)]);
            }
            assert_eq!(placement.len() as u32, (1 + size) * PLACEMENT_VALUES);
            let set = Self(CountFillInputs {
                placement,
                counts: vec![misfit, 0, 1000, 2000],
                parameters: unwritten(2 * size as usize),
            });
            (format!("{size} numbers, misfit {misfit}"), set)
        };
        SIZES.into_iter().flat_map(|size| [0, 1].map(|misfit| of(size, misfit))).collect()
    }

    /// The rest of each total behind `first`, at most `max`; 0 after an overflow.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let number = |&[_, slot, first, max]: &[u32; 4]| match self.counts[..] {
            [0, ref counts @ ..] => counts[slot as usize - 1].saturating_sub(first).min(max),
            _ => 0,
        };
        let numbers = self.placement.as_chunks().0[1..].iter();
        numbers.flat_map(|numbers| [Some(number(numbers).into()), None]).collect()
    }
}
