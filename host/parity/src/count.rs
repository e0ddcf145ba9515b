//! Cases of `record_total` and `clear_on_overflow`.

use muslin::count::OVERFLOW;
use muslin_check::prelude::*;
use organza_shaders::count::{
    COUNTS, ClearOnOverflowInputs, ClearOnOverflowParams, INTERSECTIONS, RecordTotalInputs,
    RecordTotalParams,
};

case!(pub RecordTotal(RecordTotalInputs));

impl Parity for RecordTotal {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = Vec::new();
        for (total, capacity) in [(0, 0), (0, 5), (5, 5), (6, 5), (u32::MAX, u32::MAX - 1)] {
            for overflow in [0, 1] {
                let set = Self(RecordTotalInputs {
                    params: RecordTotalParams { slot: INTERSECTIONS, last: 2, capacity },
                    first: vec![0, 0, total],
                    counts: vec![overflow, 7, 8, 9],
                });
                sets.push((format!("{total} of {capacity}, overflow {overflow}"), set));
            }
        }
        sets
    }

    /// overflow, pairs, intersections, samples: the total of the intersections, and whether it fits.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let [overflow, pairs, samples] = [0, 1, 3].map(|slot| self.counts[slot]);
        let total = self.first[self.first.len() - 1];
        let overflow = if total > self.params.capacity { 1 } else { overflow };
        listed([overflow, pairs, total, samples])
    }
}

case!(pub ClearOnOverflow(ClearOnOverflowInputs));

impl Parity for ClearOnOverflow {
    fn sets() -> Vec<(String, Self)> {
        let of = |size: u32, overflow: u32| {
            let mut random = Random::new(u64::from(size));
            let mut counts = vec![3; COUNTS as usize];
            counts[OVERFLOW as usize] = overflow;
            let set = Self(ClearOnOverflowInputs {
                params: ClearOnOverflowParams { len: size },
                counts,
                table: (0..size).map(|_| random.below(1000)).collect(),
            });
            (format!("{size} values, overflow {overflow}"), set)
        };
        SIZES.into_iter().flat_map(|size| [0, 1].map(|overflow| of(size, overflow))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let keeps = u32::from(self.counts[OVERFLOW as usize] == 0);
        listed(self.table.iter().map(|value| keeps * value))
    }
}
