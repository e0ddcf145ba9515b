//! Rendered tiles, and the channels of a pixel beside its color.

use std::collections::BTreeMap;

use muslin_error::memory;
use serde::Serialize;

use crate::{Result, TileBatch};

/// A value of a pixel beside its color. It is 0 where no Gaussian has a weight. `docs/pipeline.md` has the definitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Channel {
    /// The mean of the Gaussians' depths by their weights. A depth is the coordinate of a center along the camera's axis,
    /// in world units.
    Depth,
    /// S of Eq. 12, the sum of the weights. It can be above 1.
    Alpha,
    /// The mean of the Gaussians' transmittances T by their weights, 0 to 1.
    Visibility,
    /// The sum of the Gaussians' normals by their weights, scaled to length 1: x, y, z in world space. A Gaussian's normal
    /// is its shortest axis, turned toward the camera.
    Normal,
}

impl Channel {
    /// Every channel.
    pub const ALL: [Self; 4] = [Self::Depth, Self::Alpha, Self::Visibility, Self::Normal];

    /// Name: `depth`, `alpha`, `visibility` or `normal`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Alpha => "alpha",
            Self::Visibility => "visibility",
            Self::Normal => "normal",
        }
    }

    /// Values of a pixel: 3 of a normal, 1 of all others.
    pub fn planes(self) -> usize {
        if self == Self::Normal { 3 } else { 1 }
    }
}

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
    /// The work of rendering it.
    pub report: RenderReport,
}

/// The work of rendering a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RenderReport {
    /// Number of parts of the batch.
    pub parts: usize,
    /// (Gaussian, camera) pairs with an evaluated color and transmittance.
    pub pairs: u64,
    /// Tile intersections.
    #[serde(rename = "members")]
    pub intersections: u64,
    /// Samples of the transmittance network.
    pub samples: u64,
    /// (Gaussian, camera) pairs that were culled because they cannot be projected.
    pub degenerate: u64,
}

impl RenderedTiles {
    /// The tiles of a batch, without values yet.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory) if there is no room for them: before hours of rendering.
    pub fn new(batch: &TileBatch, channels: &[Channel]) -> Result<Self> {
        let planes = 3 + channels.iter().map(|channel| channel.planes()).sum::<usize>();
        let values = batch.tiles.len() as u64 * planes as u64 * u64::from(batch.side).pow(2);
        memory::check(values * size_of::<f32>() as u64, "the rendered batch")?;
        Ok(Self {
            side: batch.side,
            count: batch.tiles.len(),
            channels: channels.iter().map(|&channel| (channel, Vec::new())).collect(),
            ..Self::default()
        })
    }

    /// Red, green and blue of a pixel: column `x` and row `y` of a tile. Values can be outside 0 to 1.
    ///
    /// # Panics
    /// Where there is no such tile, or `x` or `y` is not less than the side.
    pub fn rgb(&self, tile: usize, x: usize, y: usize) -> [f32; 3] {
        let side = self.side as usize;
        assert!(x < side && y < side, "a tile has no pixel ({x}, {y}): its side is {side}");
        let first = tile * 3 * side * side + y * side + x;
        [0, 1, 2].map(|channel| self.data[first + channel * side * side])
    }
}

impl RenderReport {
    /// Adds the counts of a part.
    pub fn add(&mut self, part: &Self) {
        self.parts += part.parts;
        self.pairs += part.pairs;
        self.intersections += part.intersections;
        self.samples += part.samples;
        self.degenerate += part.degenerate;
    }
}
