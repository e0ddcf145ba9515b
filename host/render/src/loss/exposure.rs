//! Photographs' exposures applied to rendered tiles, and their gradients. [`organza_shaders::exposure`] has the formula.

use muslin::math::exp;
use organza_shaders::exposure::{
    ExposeBackwardKernel, ExposeBackwardParams, ExposeKernel, ExposeParams, STRIDE,
};

use crate::gradient::BinnedGradient;
use crate::stages::counts::PartCounts;
use crate::stages::cut::PartTiles;
use muslin_device::{Buffer, Count, Device, Result};
use organza_core::Tile;

/// Rendered tiles as their photographs' cameras would have exposed them.
#[derive(Debug)]
pub(crate) struct Exposed<'a> {
    /// `[photographs, STRIDE]`
    exposure: &'a Buffer<f32>,
    /// `[tiles]`
    photograph: Buffer<u32>,
    side: u32,
    /// x' `[tiles, 3, S, S]`
    pub image: Buffer<f32>,
}

impl<'a> Exposed<'a> {
    /// `image [tiles, 3, S, S]`, with the exposures of all photographs `[photographs, STRIDE]`.
    pub fn new(
        device: &Device,
        image: &Buffer<f32>,
        part_tiles: &PartTiles,
        exposure: &'a Buffer<f32>,
    ) -> Result<Self> {
        let side = part_tiles.side;
        let photograph: Vec<_> =
            part_tiles.tiles.iter().map(|tile| tile.tile.camera as u32).collect();
        let photograph = device.upload("photographs of tiles", &photograph)?;
        let exposed = device.unwritten("exposed tiles", image.len())?;
        let kernel = ExposeKernel {
            params: ExposeParams { planes: 3 * part_tiles.tiles.len() as u32, side },
            photograph: &photograph,
            exposure,
            image,
            exposed: &exposed,
        };
        device.run_all(&kernel)?;
        Ok(Self { exposure, photograph, side, image: exposed })
    }

    /// Turns `gradient [tiles, 3, S, S]` from dL/dx' into dL/dx, and adds the exposures' gradients to sums. A part that had too
    /// little room, or whose loss is not finite, adds nothing.
    pub fn backward(
        &self,
        device: &Device,
        image: &Buffer<f32>,
        gradient: &Buffer<f32>,
        counts: Option<&PartCounts>,
        into: &BinnedGradient,
    ) -> Result<()> {
        let rows = 3 * self.photograph.len() as u32 * self.side;
        let kernel = ExposeBackwardKernel {
            params: ExposeBackwardParams {
                rows,
                side: self.side,
                values: into.values.len() as u32,
            },
            photograph: &self.photograph,
            exposure: self.exposure,
            image,
            gradient,
            sum: &into.sum,
        };
        let count = counts.map_or(Count::known(rows), |counts| counts.unless_failed(rows));
        device.run_all(&kernel.counted(&count))
    }
}

/// Exposes a tile `[3, S, S]` on the host, by the exposures of all photographs.
pub(crate) fn expose_tile(tile: &Tile, values: &mut [f32], exposure: &[f32]) {
    let area = values.len() / 3;
    let own = &exposure[tile.camera * STRIDE as usize..];
    for (plane, own) in values.chunks_exact_mut(area).zip(own.as_chunks().0) {
        let [log_gain, offset] = *own;
        plane.iter_mut().for_each(|value| *value = exp(log_gain) * *value + offset);
    }
}
