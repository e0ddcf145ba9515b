//! The cases of `peak_multiply_add` and `peak_read`.

use muslin::peak::{
    MULTIPLY_ADDS, PeakMultiplyAddInputs, PeakMultiplyAddParams, PeakReadInputs, PeakReadParams,
    READS,
};
use muslin_check::prelude::*;

/// Sums of an invocation of `peak_multiply_add`.
const SUMS: u32 = 12;
/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

case!(pub PeakMultiplyAdd(PeakMultiplyAddInputs));

impl PeakMultiplyAdd {
    /// Multiply-adds of each of an invocation's sums.
    fn rounds(&self) -> u32 {
        self.params.steps * MULTIPLY_ADDS / SUMS
    }
}

impl Parity for PeakMultiplyAdd {
    const KERNEL: &'static str = "peak_multiply_add";
    const TOLERANCE: f64 = 8e-7;
    const WHY: &'static str = "two roundings of both devices for each multiply-add, which those that follow shrink, \
        and four of the last sum";

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

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.count, 1)
    }

    /// Twelve sums, which begin with 0 to 11 and a 4,194,304th of the invocation's number.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let next = |x: f64| x * f64::from(self.params.factor) + f64::from(self.params.addend);
        let begins = (0..12).map(|sum| f64::from(sum) + index as f64 / 4_194_304.0);
        Some(begins.map(|first| (0..self.rounds()).fold(first, |x, _| next(x))).sum())
    }

    fn bound(&self, _: &Output, _: usize, _: Rounding) -> Bound {
        // errors are summed as the values are: 1 + f + f^2 + ..
        let grown = 1.0 / (1.0 - f64::from(self.params.factor.abs()));
        let largest = f64::from(SUMS) + f64::from(self.params.addend.abs()) * grown;
        let sums = f64::from(SUMS);
        Bound { scale: sums * largest * grown, floor: 4.0 * sums * grown * f64::from(TINY) }
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
    fn read_by(&self, index: u32) -> impl Iterator<Item = f64> {
        let rows = self.params.steps * READS;
        let local = index % WORKGROUP;
        let first = index / WORKGROUP * rows;
        (first..first + rows)
            .map(move |row| f64::from(self.values[(row * WORKGROUP + local) as usize]))
    }
}

impl Parity for PeakRead {
    const KERNEL: &'static str = "peak_read";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each value, of the values' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let steps = random.below(5);
            Self::new(count, steps, fill, random)
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.count, 1)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        Some(self.read_by(index as u32).sum())
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let terms = f64::from(self.params.steps * READS);
        let size: f64 = self.read_by(index as u32).map(f64::abs).sum();
        Bound { scale: terms * size, floor: terms * f64::from(TINY) }
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
