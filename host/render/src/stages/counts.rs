//! The numbers of pairs, intersections and samples of a part, which can stay on the device.
//!
//! A kernel that declares `counts(pairs)` has a parameter `pairs` that the device fills in: `kernel.counted(&count)` binds a [`Count`],
//! which is known to the host or an index into the buffer of counts. The dispatch has invocations for the count's upper bound.

use std::sync::Arc;

use glam::Vec4;
use muslin::count::OVERFLOW;
use organza_shaders::count::{
    ALL, COUNTS, ClearOnOverflowKernel, ClearOnOverflowParams, GRADIENTS, INTERSECTIONS, PAIRS,
    RecordTotalKernel, RecordTotalParams, SAMPLES,
};
use organza_shaders::loss::{LossCheckKernel, LossCheckParams};

use super::scan::Mask;
use muslin_device::{Buffer, Count, Device, Result};

/// How many items the tables of a part have room for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Capacity {
    /// (Gaussian, camera) pairs.
    pub pairs: u32,
    /// Tile intersections.
    pub intersections: u32,
    /// Samples of the transmittance network.
    pub samples: u32,
}

impl Capacity {
    /// What a part needed, from the values of `PartCounts::counts`. `None` if that was more than it had room for: then it is empty.
    pub fn needed(counts: &[u32]) -> Option<Self> {
        let [pairs, intersections, samples] =
            [PAIRS, INTERSECTIONS, SAMPLES].map(|slot| counts[slot as usize]);
        (counts[OVERFLOW as usize] == 0).then_some(Self { pairs, intersections, samples })
    }

    /// The room for each number, by its slot.
    pub fn slots(self) -> [u32; COUNTS as usize] {
        let Self { pairs, intersections, samples } = self;
        let mut slots = [0; COUNTS as usize];
        slots[PAIRS as usize] = pairs;
        slots[INTERSECTIONS as usize] = intersections;
        slots[SAMPLES as usize] = samples;
        slots[GRADIENTS as usize] = samples;
        slots
    }

    /// The larger room for each number.
    pub fn max(self, other: Self) -> Self {
        Self {
            pairs: self.pairs.max(other.pairs),
            intersections: self.intersections.max(other.intersections),
            samples: self.samples.max(other.samples),
        }
    }

    /// Room for both.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            pairs: self.pairs.saturating_add(other.pairs),
            intersections: self.intersections.saturating_add(other.intersections),
            samples: self.samples.saturating_add(other.samples),
        }
    }
}

/// Counts of parts before the first number, for [`PartCounts::with`].
pub const NO_COUNTS: [u32; COUNTS as usize] = {
    let mut counts = [0; COUNTS as usize];
    counts[ALL as usize] = u32::MAX;
    counts
};

/// Counts that stay on the device: see [`organza_shaders::count`].
#[derive(Clone, Debug)]
pub struct PartCounts {
    /// `[capacities, COUNTS]`: [`Capacity::needed`] reads the first row. All rows share its [`OVERFLOW`].
    pub counts: Arc<Buffer<u32>>,
    /// The room for the numbers.
    capacities: Vec<Capacity>,
    /// The row of these numbers.
    index: usize,
}

impl PartCounts {
    /// Zeros, with a row for each capacity: one for a scene alone. With [several](crate::DeviceScene::all) scenes, each scene's row is
    /// followed by rows for its samples in the others' fields.
    pub fn new(device: &Device, capacities: Vec<Capacity>) -> Result<Self> {
        let counts = device.zeros("counts", COUNTS as usize * capacities.len())?;
        Ok(Self { counts: Arc::new(counts), capacities, index: 0 })
    }

    /// The counts of a scene alone, in a buffer of [`NO_COUNTS`]. If an earlier part has raised [`OVERFLOW`] there, this one is empty, too.
    pub fn with(counts: Arc<Buffer<u32>>, capacity: Capacity) -> Self {
        Self { counts, capacities: vec![capacity], index: 0 }
    }

    /// The counts in a later row.
    pub fn after(&self, number: usize) -> Self {
        Self { index: self.index + number, ..self.clone() }
    }

    /// The place of a number in `counts`, and the room for it.
    fn place(&self, slot: u32) -> (u32, u32) {
        let room = self.capacities[self.index].slots();
        (self.index as u32 * COUNTS + slot, room[slot as usize])
    }

    /// Records the total at the end of exclusive sums as the number at a slot.
    pub fn record_total(&self, device: &Device, slot: u32, first: &Buffer<u32>) -> Result<()> {
        let last = first.len() as u32 - 1;
        let (slot, capacity) = self.place(slot);
        let params = RecordTotalParams { slot, last, capacity };
        device.run_all(&RecordTotalKernel { params, first, counts: &*self.counts })
    }

    /// Publishes the recorded totals to later dispatches. If one exceeds its capacity, clears masks and ranges.
    pub fn clear_on_overflow(
        &self,
        device: &Device,
        masks: &[&Mask],
        ranges: &[&Buffer<u32>],
    ) -> Result<()> {
        let of_masks = masks.iter().flat_map(|mask| [&mask.bits, &mask.first]);
        for table in of_masks.chain(ranges.iter().copied()) {
            let params = ClearOnOverflowParams { len: table.len() as u32 };
            let kernel = ClearOnOverflowKernel { params, counts: &*self.counts, table };
            device.run_all(&kernel)?;
        }
        device.publish_counts();
        Ok(())
    }

    /// Raises [`OVERFLOW`] if a sum of the loss's rows is not finite. Then the backward pass finds no pairs.
    pub fn check_loss(
        &self,
        device: &Device,
        row_sum: &Buffer<Vec4>,
        pair_mask: &Mask,
    ) -> Result<()> {
        let params = LossCheckParams { rows: row_sum.len() as u32 };
        let kernel = LossCheckKernel { params, row_sum, counts: &*self.counts };
        device.run_all(&kernel)?;
        self.clear_on_overflow(device, &[pair_mask], &[])
    }

    /// A count of `items`, or of none if a part has failed.
    pub fn unless_failed(&self, items: u32) -> Count {
        Count::on_device(&self.counts, ALL, items)
    }

    /// The number at a slot.
    pub fn count(&self, slot: u32) -> Count {
        let (slot, capacity) = self.place(slot);
        Count::on_device(&self.counts, slot, capacity)
    }
}
