//! Compares a batch's tiles with photographs: dL/dY part by part, and the loss of each tile.

use std::collections::BTreeMap;

use super::exposure::Exposed;
use super::image::{LossInputs, LossTarget, TileLoss, image_loss};
use crate::gradient::SceneGradient;
use crate::stages::cut::{PartTiles, values_of_tiles};
use crate::stages::tiles::TileBins;
use muslin_device::{Buffer, Device};
use organza_core::Result;
use organza_core::error::argument;
use organza_core::ranks::Ranks;

/// The loss of a batch.
#[derive(Clone, Debug)]
pub struct BatchLoss {
    /// The loss: the caller's own where there is one.
    pub loss: f64,
    /// The measurements of each tile, in the order of the batch.
    pub tiles: Vec<TileLoss>,
}

/// How dL/dY of a batch is found.
pub enum LossSource<'a> {
    /// `[K, 3, S, S]`: it is known.
    Given(&'a [f32]),
    /// By comparing tiles with photographs.
    Compared(Comparison<'a>),
}

/// A comparison of tiles with photographs.
pub struct Comparison<'a> {
    pub target: &'a LossTarget<'a>,
    /// dL/dY `[K, 3, S, S]` of a caller's loss, with respect to the exposed tiles. It replaces the gradient of the image's loss.
    own: Option<&'a [f32]>,
    /// The loss of each tile, by the tile's place in the batch.
    found: BTreeMap<usize, TileLoss>,
    /// The sums of the last part's rows.
    row_sum: Option<Buffer<u32>>,
}

/// What a rank sends to the others about a tile.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct TileNumbers {
    place: f64,
    loss: TileLoss,
}

impl LossSource<'_> {
    /// Queues dL/dY of a part's tiles, `[tiles, 3, S, S]`. With `is_queued`, the host does not wait for the loss: the device
    /// [checks](crate::stages::counts::PartCounts::check_loss) it.
    pub fn backward(
        &mut self,
        device: &Device,
        part_tiles: &PartTiles,
        bins: &TileBins,
        is_queued: bool,
        rendered: &Buffer<f32>,
        into: &SceneGradient,
    ) -> Result<Buffer<f32>> {
        match self {
            Self::Compared(comparison) => {
                comparison.backward(device, part_tiles, bins, is_queued, rendered, into)
            }
            Self::Given(d_tiles) => {
                let values = values_of_tiles(d_tiles, &part_tiles.places(), 3 * part_tiles.area());
                Ok(device.upload("gradient of the tiles", &values)?)
            }
        }
    }

    /// The buffers to read after [`Self::backward`] of a part.
    pub fn buffers(&self) -> Vec<Buffer<u32>> {
        match self {
            Self::Given(_) => Vec::new(),
            Self::Compared(comparison) => comparison.row_sum.iter().map(Buffer::view).collect(),
        }
    }

    /// Takes the words of [`Self::buffers`].
    pub fn take(&mut self, part_tiles: &PartTiles, words: &[Vec<u32>]) {
        if let (Self::Compared(comparison), [rows]) = (self, words) {
            comparison.found.extend(tile_losses(&part_tiles.places(), rows));
        }
    }
}

/// The losses of a part's tiles, by their places in the batch, from the sums of their rows.
pub fn tile_losses<'a>(
    places: &'a [usize],
    rows: &'a [u32],
) -> impl Iterator<Item = (usize, TileLoss)> + 'a {
    let rows = bytemuck::cast_slice::<u32, f32>(rows);
    let tiles = rows.chunks_exact(rows.len() / places.len()).map(TileLoss::of_rows);
    places.iter().copied().zip(tiles)
}

impl<'a> Comparison<'a> {
    pub fn new(target: &'a LossTarget<'a>, own: Option<&'a [f32]>) -> Self {
        Self { target, own, found: BTreeMap::new(), row_sum: None }
    }

    fn backward(
        &mut self,
        device: &Device,
        part_tiles: &PartTiles,
        bins: &TileBins,
        is_queued: bool,
        rendered: &Buffer<f32>,
        into: &SceneGradient,
    ) -> Result<Buffer<f32>> {
        let target = self.target;
        let places = part_tiles.places();
        let [image, valid] = target.photographs.on_device(device, &places)?;
        let expose = |exposure| Exposed::new(device, rendered, part_tiles, exposure);
        let exposed = target.exposure.map(expose).transpose()?;
        let inputs = LossInputs {
            image: exposed.as_ref().map_or(rendered, |exposed| &exposed.image),
            target: &image,
            valid: &valid,
            valid_pixels: target.valid_pixels,
            ssim_weight: target.ssim_weight,
        };
        let output = device.run_in_pool(|| image_loss(device, part_tiles.side, &inputs))?;
        let counts = bins.part_counts.as_ref();
        if let Some(counts) = counts.filter(|_| is_queued) {
            counts.check_loss(device, &output.row_sum, &bins.pair_mask)?;
        }
        let mut d_tiles = output.grad_tiles;
        if let Some(own) = self.own {
            let values = values_of_tiles(own, &places, 3 * part_tiles.area());
            d_tiles = device.upload("gradient of the tiles", &values)?;
        }
        if let Some(exposed) = exposed {
            let sums = into.exposures.as_ref().expect("a gradient with exposures");
            exposed.backward(device, rendered, &d_tiles, counts, sums)?;
        }
        self.row_sum = Some(output.row_sum.view());
        Ok(d_tiles)
    }

    /// Adds the measurements of other ranks.
    pub fn gather(&mut self, ranks: &dyn Ranks) -> Result<()> {
        let numbers =
            |(&place, &loss): (&usize, &TileLoss)| TileNumbers { place: place as f64, loss };
        let mine: Vec<_> = self.found.iter().map(numbers).collect();
        for bytes in ranks.gather(bytemuck::cast_slice(&mine).to_vec())? {
            let theirs = bytemuck::pod_collect_to_vec::<u8, TileNumbers>(&bytes);
            self.found.extend(theirs.iter().map(|tile| (tile.place as usize, tile.loss)));
        }
        Ok(())
    }

    /// The measurements of a batch, and its loss: a caller's own, or the image's.
    pub fn finish(self, own: Option<f64>) -> BatchLoss {
        let tiles: Vec<_> = self.found.into_values().collect();
        let loss = own.unwrap_or_else(|| TileLoss::total(&tiles).value(self.target.ssim_weight));
        BatchLoss { loss, tiles }
    }
}

/// Fails if a caller's loss has returned another number of values than there are pixels.
pub fn check_len(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    argument(format!("the loss returned {found} values of `grad_tiles`, expected {expected}"))
}
