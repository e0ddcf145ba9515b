//! The cases of kernels that use what no kernel of organza does.

use muslin_check::prelude::*;
use organza_shaders::language::{
    BYTES, ByteHistogramInputs, LanguageParams, MAX_ROW, SortParams, SortRowsInputs,
};

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

case!(pub SortRows(SortRowsInputs));

impl Parity for SortRows {
    const KERNEL: &'static str = "sort_rows";

    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, columns]: [u32; 2]| {
            let mut random = Random::new(columns.into());
            let values = (0..rows * columns).map(|_| random.bits()).collect();
            let params = SortParams { rows, columns };
            (format!("{rows} rows of {columns}"), Self(SortRowsInputs { params, values }))
        };
        [[5, 1], [1, 2], [3, 64], [2, 1024], [1, MAX_ROW]].map(set).into()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), 64 * self.params.rows, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let mut sorted = self.values.clone();
        let rows = sorted.chunks_exact_mut(self.params.columns as usize);
        rows.for_each(<[u32]>::sort_unstable);
        sorted.into_iter().map(|value| Some(value.into())).collect()
    }
}
