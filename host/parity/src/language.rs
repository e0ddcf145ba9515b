//! The cases of kernels that use what no kernel of organza does.

use muslin::language::{BYTES, ByteHistogramInputs, LanguageParams};
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
