//! The case of `hash_grid_half`.

use muslin::half::half_value;
use muslin_check::prelude::*;
use organza_shaders::hash_grid_half::{HashGridHalfKernel, MAX_HALF};

use super::hash_grid::HashGrid;
use organza_core::halves::pack_halves;

/// Inputs of `hash_grid_half`.
#[derive(Clone)]
pub struct HashGridHalf {
    /// The same with a table of numbers: those that the halves stand for.
    full: HashGrid,
    table: Vec<u32>,
}

impl HashGridHalf {
    fn new(mut full: HashGrid) -> Self {
        full.table.iter_mut().for_each(|value| *value = value.clamp(-MAX_HALF, MAX_HALF));
        let features = full.grid.features as usize;
        let table = pack_halves(&full.table, features, "table").expect("they are clamped");
        let words = features.div_ceil(2);
        for (entry, words) in full.table.chunks_mut(features).zip(table.chunks(words)) {
            for (feature, value) in entry.iter_mut().enumerate() {
                *value = half_value(words[feature / 2] >> (16 * (feature % 2)) & 0xffff);
            }
        }
        Self { full, table }
    }
}

impl Parity for HashGridHalf {
    const KERNEL: &'static str = "hash_grid_half";
    const TOLERANCE: f64 = HashGrid::TOLERANCE;
    const WHY: &'static str = "as hash_grid: a half is a number as well";

    fn sets() -> Vec<(String, Self)> {
        HashGrid::sets().into_iter().map(|(name, full)| (name, Self::new(full))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let levels = self.full.grid.levels_for_kernels();
        let kernel = HashGridHalfKernel {
            params: self.full.params(),
            levels: &levels,
            table: &self.table,
            position: &self.full.positions(),
            output: &unwritten(self.full.output_len()),
        };
        runner.run(&kernel, kernel.params.points, levels.len() as u32)
    }

    fn bound(&self, output: &Output, index: usize, rounding: Rounding) -> Bound {
        self.full.bound(output, index, rounding)
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        self.full.exact(output, len)
    }
}
