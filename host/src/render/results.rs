//! The results of rendering a batch.

use std::collections::BTreeMap;

use super::channels::Channel;

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
    pub(super) fn add(&mut self, part: &Self) {
        self.parts += part.parts;
        self.pairs += part.pairs;
        self.members += part.members;
        self.samples += part.samples;
        self.degenerate += part.degenerate;
    }
}
