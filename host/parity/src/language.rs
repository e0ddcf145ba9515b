//! The cases of kernels that use what no kernel of organza does.

use muslin::language::{
    BYTES, ByteHistogramInputs, KeepEvenInputs, LanguageParams, MAX_COLUMNS, MAX_ROW, RowParams,
    RowRangesInputs, SortParams, SortRowsInputs,
};
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

/// Rows that subgroups of some size fill, and rows that none fills.
const ROWS: [RowParams; 6] = [
    RowParams { rows: 5, columns: 1 },
    RowParams { rows: 1, columns: 31 },
    RowParams { rows: 3, columns: 96 },
    RowParams { rows: 2, columns: 97 },
    RowParams { rows: 4, columns: 1000 },
    RowParams { rows: 1, columns: MAX_COLUMNS },
];

fn rows<T, P>(value: fn(u32) -> T, set: fn(RowParams, Vec<T>) -> P) -> Vec<(String, P)> {
    let of = |params: RowParams| {
        let mut random = Random::new(params.columns.into());
        let values = (0..params.rows * params.columns).map(|_| value(random.bits())).collect();
        (format!("{} rows of {}", params.rows, params.columns), set(params, values))
    };
    ROWS.map(of).into()
}

case!(pub RowRanges(RowRangesInputs));

impl Parity for RowRanges {
    const KERNEL: &'static str = "row_ranges";
    const WHY: &'static str =
        "multiples of 1/8 up to 128, whose sums have no rounding error in any order";

    fn sets() -> Vec<(String, Self)> {
        let value = |bits: u32| (bits % 2049) as f32 / 8.0 - 128.0;
        rows(value, |params, values| {
            Self(RowRangesInputs { params, values, output: unwritten(3 * params.rows as usize) })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), 96 * self.params.rows, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let rows = self.values.chunks_exact(self.params.columns as usize);
        let all = rows.flat_map(|row| {
            let row = || row.iter().copied().map(f64::from);
            [row().sum(), row().fold(f64::INFINITY, f64::min), row().fold(-f64::INFINITY, f64::max)]
        });
        all.map(Some).collect()
    }
}

case!(pub KeepEven(KeepEvenInputs));

impl Parity for KeepEven {
    const KERNEL: &'static str = "keep_even";

    fn sets() -> Vec<(String, Self)> {
        rows(
            |bits| bits,
            |params, values| {
                let kept = unwritten(values.len());
                let counts = unwritten(params.rows as usize);
                Self(KeepEvenInputs { params, values, kept, counts })
            },
        )
    }

    /// The rows of the output are sorted, because their values come in any order.
    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let mut outputs = runner.run(&self.kernel(), 96 * self.params.rows, 1)?;
        if let Values::Exact(kept) = &mut outputs[0].values {
            kept.chunks_exact_mut(self.params.columns as usize).for_each(<[u32]>::sort_unstable);
        }
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let rows = self.values.chunks_exact(self.params.columns as usize);
        let of = |row: &[u32]| match output {
            "kept" => {
                let mut kept: Vec<_> =
                    row.iter().map(|&value| if value % 2 == 0 { value } else { 1 }).collect();
                kept.sort_unstable();
                kept
            }
            _ => vec![row.iter().filter(|value| **value % 2 == 0).count() as u32],
        };
        rows.flat_map(of).map(|value| Some(value.into())).collect()
    }
}
