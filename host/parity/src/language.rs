//! The cases of kernels that use what no kernel of organza does.

use muslin_check::prelude::*;
use organza_shaders::language::{
    BYTES, ByteHistogramInputs, KeepPositiveInputs, LanguageParams, MAX_COLUMNS, MAX_ROW,
    RowParams, SortParams, SortRowsInputs,
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

case!(pub KeepPositive(KeepPositiveInputs));

impl Parity for KeepPositive {
    const KERNEL: &'static str = "keep_positive";
    const WHY: &'static str = "multiples of 1/8 up to 128, whose sums are exact in any order";

    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, columns]: [u32; 2]| {
            let mut random = Random::new(columns.into());
            let number = |bits: u32| (bits % 2049) as f32 / 8.0 - 128.0;
            let values: Vec<_> = (0..rows * columns).map(|_| number(random.bits())).collect();
            let inputs = KeepPositiveInputs {
                params: RowParams { rows, columns },
                kept: unwritten(values.len()),
                output: unwritten(4 * rows as usize),
                values,
            };
            (format!("{rows} rows of {columns}"), Self(inputs))
        };
        [[5, 1], [1, 31], [3, 96], [2, 97], [4, 1000], [1, MAX_COLUMNS]].map(set).into()
    }

    /// The kept values come in any order, so they are sorted.
    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let mut outputs = runner.run(&self.kernel(), 96 * self.params.rows, 1)?;
        if let Values::Float(kept) = &mut outputs[0].values {
            kept.chunks_exact_mut(self.params.columns as usize).for_each(sort);
        }
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |row: &[f32]| {
            let values: Vec<_> = row.iter().copied().map(f64::from).collect();
            let mut kept: Vec<_> = values.iter().map(|value| value.max(0.0)).collect();
            let count = kept.iter().filter(|value| **value > 0.0).count() as f64;
            let [low, high] =
                [values.iter().copied().reduce(f64::min), values.iter().copied().reduce(f64::max)];
            sort(&mut kept);
            match output {
                "kept" => kept.into_iter().map(Some).collect(),
                _ => vec![Some(count), Some(values.iter().sum()), low, high],
            }
        };
        self.values.chunks_exact(self.params.columns as usize).flat_map(of).collect()
    }
}

fn sort(row: &mut [f64]) {
    row.sort_unstable_by(f64::total_cmp);
}
