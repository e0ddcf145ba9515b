//! The cases of kernels that use what no kernel of organza does.

use muslin::language::{BYTES, ByteHistogramInputs, LanguageParams, PrefixSumsInputs, SUMMED};
use muslin_check::prelude::*;

case!(pub ByteHistogram(ByteHistogramInputs));

impl Parity for ByteHistogram {
    const KERNEL: &'static str = "byte_histogram";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let bytes = (0..count).map(|_| random.bits() as u8).collect();
            let halves = (0..count).map(|_| random.bits() as u16).collect();
            let params = LanguageParams { count };
            Self(ByteHistogramInputs { params, bytes, halves, bins: vec![0; 2 * BYTES] })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.count, 1)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let count = match index.checked_sub(BYTES) {
            None => self.bytes.iter().filter(|byte| usize::from(**byte) == index).count(),
            Some(high) => {
                self.halves.iter().filter(|half| usize::from(**half) / 256 == high).count()
            }
        };
        Some(count as f64)
    }
}

case!(pub PrefixSums(PrefixSumsInputs));

impl Parity for PrefixSums {
    const KERNEL: &'static str = "prefix_sums";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let values = (0..count).map(|_| random.bits() % 1000).collect();
            let sums = vec![0; count as usize];
            let params = LanguageParams { count };
            Self(PrefixSumsInputs { params, values, scratch: sums.repeat(2), sums })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.count, 1)
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        // after six steps, both halves of `scratch` have sums: of all 64 items, and of the last 32
        let items =
            if output == "scratch" && index >= self.values.len() { SUMMED / 2 } else { SUMMED };
        let index = index % self.values.len();
        let begin = index - index % SUMMED as usize;
        let begin = begin.max((index + 1).saturating_sub(items as usize));
        Some(self.values[begin..=index].iter().map(|value| f64::from(*value)).sum())
    }
}
