//! The case of `hash_grid_half`.

use muslin::half::half_value;
use muslin_check::prelude::*;
use organza_shaders::hash_grid_half::{HashGridHalfInputs, MAX_HALF};

use super::hash_grid::{HashGrid, POSITION};
use organza_core::halves::pack_halves;

// with a table of the numbers that the halves stand for
case!(pub HashGridHalf(HashGridHalfInputs) { full: HashGrid });

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
        let inputs = HashGridHalfInputs {
            params: full.params,
            levels: full.levels.clone(),
            table,
            position: full.position.clone(),
            output: full.output.clone(),
        };
        Self { inputs, full }
    }
}

impl Parity for HashGridHalf {
    fn sets() -> Vec<(String, Self)> {
        HashGrid::sets().into_iter().map(|(name, full)| (name, Self::new(full))).collect()
    }

    fn exact(&self, _: &str, len: usize) -> Vec<Option<Rounded>> {
        self.full.known(len, POSITION[0])
    }

    fn exact_regrouped(&self, _: &str, len: usize) -> Vec<Option<Rounded>> {
        self.full.known(len, POSITION[1])
    }
}
