//! The cases of the kit's own kernels: `peak_multiply_add`, `peak_read` and `count_fill`.

use muslin_kernel::count::{CountFillInputs, PLACEMENT_VALUES};
use muslin_kernel::peak::{
    MULTIPLY_ADDS, PeakMultiplyAddInputs, PeakMultiplyAddParams, PeakReadInputs, PeakReadParams,
    READS,
};

use crate::prelude::*;

/// Sums of an invocation of `peak_multiply_add`.
const SUMS: u32 = 12;
/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

case!(pub PeakMultiplyAdd(PeakMultiplyAddInputs));

impl Parity for PeakMultiplyAdd {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let params = PeakMultiplyAddParams {
                count,
                // after a few steps nothing of the first values is left
                steps: if fill == Fill::Random { [0, 1, 2, 29][count as usize % 4] } else { 29 },
                // the largest factor is not
                factor: fill.values(random, 1, [-0.75, 0.75], 0.75)[0],
                addend: fill.values(random, 1, [-2.0, 2.0], 1e30)[0],
            };
            Self(PeakMultiplyAddInputs { params, output: unwritten(count as usize) })
        })
    }

    /// Twelve sums, which begin with 0 to 11 and a 4,194,304th of the invocation's number.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [factor, addend] = [self.params.factor, self.params.addend].map(Rounded::from);
        let first = Rounded::from(index as f64 / 4_194_304.0);
        let begins = (0..SUMS).map(|sum| Rounded::from(sum) + first);
        let rounds = 0..self.params.steps * MULTIPLY_ADDS / SUMS;
        Some(Number::sum(begins.map(|x| rounds.clone().fold(x, |x, _| x * factor + addend))))
    }
}

case!(pub PeakRead(PeakReadInputs));

impl PeakRead {
    fn new(count: u32, steps: u32, fill: Fill, random: &mut Random) -> Self {
        let len = count.div_ceil(WORKGROUP) * steps * READS * WORKGROUP;
        Self(PeakReadInputs {
            params: PeakReadParams { count, steps },
            values: fill.values(random, len as usize, [-1.0, 1.0], 1e30),
            output: unwritten(count as usize),
        })
    }

    /// The values that an invocation reads.
    fn read_by(&self, index: u32) -> impl Iterator<Item = Rounded> {
        let rows = self.params.steps * READS;
        let local = index % WORKGROUP;
        let first = index / WORKGROUP * rows;
        (first..first + rows).map(move |row| self.values[(row * WORKGROUP + local) as usize].into())
    }
}

impl Parity for PeakRead {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let steps = random.below(5);
            Self::new(count, steps, fill, random)
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        Some(Number::sum(self.read_by(index as u32)))
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_read_once() {
        for (_, set) in PeakRead::sets() {
            let invocations = 0..set.params.count.next_multiple_of(WORKGROUP);
            let read: usize = invocations.map(|index| set.read_by(index).count()).sum();
            assert_eq!(read, set.values.len());
        }
    }
}
