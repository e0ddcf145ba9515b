//! The results of rendering a batch.

use std::collections::BTreeMap;

use super::channels::Channel;
use super::part::RenderedPart;
use super::part_counts::{Capacity, Needed};
use super::plan::Plan;
use crate::error::Result;
use crate::tile::TileBatch;
use organza_device::memory;

/// A rendered batch, the tensor Y of Eq. 16.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderedTiles {
    /// S, in pixels.
    pub side: u32,
    /// K
    pub count: usize,
    /// `[K, 3, S, S]`: tile, channel (RGB), row, column.
    pub data: Vec<f32>,
    /// `[K, planes, S, S]` of each channel that was asked for.
    pub channels: BTreeMap<Channel, Vec<f32>>,
    /// What was done to render it.
    pub report: RenderReport,
}

/// What rendering a batch took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RenderReport {
    /// Parts that the batch was rendered in.
    pub parts: usize,
    /// (Gaussian, camera) pairs whose color and transmittance were evaluated.
    pub pairs: u64,
    /// (Gaussian, tile) memberships.
    pub members: u64,
    /// Samples of the transmittance network.
    pub samples: u64,
    /// (Gaussian, camera) pairs that were culled because they cannot be projected.
    pub degenerate: u64,
}

impl RenderedTiles {
    /// Black tiles: to fill in.
    pub(super) fn zeros(batch: &TileBatch, channels: &[Channel]) -> Result<Self> {
        let area = (batch.side * batch.side) as usize;
        let len = |planes: usize| batch.tiles.len() * planes * area;
        let data = memory::zeros(len(3), "the rendered batch")?;
        let beside = channels
            .iter()
            .map(|&channel| Ok((channel, memory::zeros(len(channel.planes()), channel.name())?)));
        let channels = beside.collect::<Result<_>>()?;
        let (side, count) = (batch.side, batch.tiles.len());
        Ok(Self { side, count, data, channels, report: RenderReport::default() })
    }

    /// Puts the tiles of a part in their places; `channels` are those of the part.
    pub(super) fn place(&mut self, plan: &Plan, part: &RenderedPart, channels: &[Channel]) {
        let area = (self.side * self.side) as usize;
        let place = |values: &[f32], len: usize, batch: &mut [f32]| {
            for (values, tile) in values.chunks_exact(len).zip(&plan.tiles) {
                batch[tile.place * len..][..len].copy_from_slice(values);
            }
        };
        place(&part.pixels, 3 * area, &mut self.data);
        for (channel, values) in channels.iter().zip(&part.channels) {
            let all = self.channels.get_mut(channel).expect("made by `zeros`");
            place(values, channel.planes() * area, all);
        }
        self.report.add(&part.report);
    }

    /// Red, green and blue of a pixel: column `x` and row `y` of a tile. Values can be outside 0 to 1.
    ///
    /// # Panics
    /// Where there is no such tile, or `x` or `y` is not less than the side.
    #[must_use]
    pub fn rgb(&self, tile: usize, x: usize, y: usize) -> [f32; 3] {
        let side = self.side as usize;
        assert!(x < side && y < side, "a tile has no pixel ({x}, {y}): its side is {side}");
        let first = tile * 3 * side * side + y * side + x;
        [0, 1, 2].map(|channel| self.data[first + channel * side * side])
    }
}

impl RenderReport {
    /// How many numbers it has.
    pub(super) const NUMBERS: usize = 5;

    pub(super) fn to_numbers(self) -> [u64; Self::NUMBERS] {
        [self.parts as u64, self.pairs, self.members, self.samples, self.degenerate]
    }

    pub(super) fn of_numbers(numbers: [u64; Self::NUMBERS]) -> Self {
        let [parts, pairs, members, samples, degenerate] = numbers;
        Self { parts: parts as usize, pairs, members, samples, degenerate }
    }

    /// That of a part, of the capacity that it needed.
    pub(super) fn of_part(degenerate: u32, needed: Needed) -> Self {
        let mut report = Self { parts: 1, degenerate: u64::from(degenerate), ..Self::default() };
        if let Needed::Capacity(Capacity { pairs, members, samples }) = needed {
            [report.pairs, report.members, report.samples] =
                [pairs, members, samples].map(u64::from);
        }
        report
    }

    pub(super) fn add(&mut self, part: &Self) {
        self.parts += part.parts;
        self.pairs += part.pairs;
        self.members += part.members;
        self.samples += part.samples;
        self.degenerate += part.degenerate;
    }
}
