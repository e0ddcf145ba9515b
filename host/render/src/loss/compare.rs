//! A batch's tiles beside photographs: dL/dY part by part, and what is measured of each tile.

use std::collections::BTreeMap;

use super::exposure::{self, Exposed, ExposureGradient};
use super::image::{LossInputs, LossTarget, TileLoss, image_loss};
use super::own::{DeviceLoss, DeviceLossBatch};
use crate::stages::composite::{CompositedTerm, MaskedTerm, TileGradient};
use crate::stages::cut::{PartTiles, values_of_tiles};
use crate::stages::tiles::TileBins;
use muslin_device::{Buffer, Device};
use organza_core::error::argument;
use organza_core::ranks::Ranks;
use organza_core::{Result, TileBatch};

/// The loss of a batch.
#[derive(Clone, Debug)]
pub struct BatchLoss {
    /// The loss: the caller's own where there is one.
    pub loss: f64,
    /// What is measured of each tile, in the order of the batch.
    pub tiles: Vec<TileLoss>,
    /// Gradients of the exposures of all tiles, if the target has exposures.
    pub exposures: Vec<ExposureGradient>,
}

/// How dL/dY of a batch is found.
pub enum LossSource<'a> {
    /// `[K, 3, S, S]`: it is known.
    Given(&'a [f32]),
    /// By comparing tiles with photographs.
    Compared(Comparison<'a>),
}

/// Tiles beside photographs.
pub struct Comparison<'a> {
    pub target: &'a LossTarget<'a>,
    /// Instead of the image's loss.
    pub own: Option<OwnGradient<'a>>,
    found: BTreeMap<usize, TileNumbers>,
    /// Of the last part: the sums of rows of the loss and of the exposures, and the caller's loss.
    sums: Vec<Buffer<u32>>,
    own_loss: f64,
}

/// The derivative of a caller's loss.
pub enum OwnGradient<'a> {
    /// A function that says it.
    Device(&'a mut DeviceLoss<'a>),
    /// dL/dY `[K, 3, S, S]`, of tiles as they were exposed.
    Host(&'a [f32]),
}

/// What is measured of a tile. Ranks tell each other.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct TileNumbers {
    /// The tile's place in the batch.
    place: f64,
    loss: TileLoss,
    /// The gradient of its exposure, if that is learned.
    exposure: [[f64; 2]; 3],
    /// The caller's loss of a part, at its first tile; 0 elsewhere.
    own: f64,
}

impl LossSource<'_> {
    /// Queues dL/dY of a part's tiles `[tiles, 3, S, S]`.
    pub fn backward(
        &mut self,
        device: &Device,
        part_tiles: &PartTiles,
        rendered: &Buffer<f32>,
    ) -> Result<TileGradient> {
        match self {
            Self::Compared(comparison) => comparison.backward(device, part_tiles, rendered),
            Self::Given(d_tiles) => {
                let values = values_of_tiles(d_tiles, &part_tiles.places(), 3 * part_tiles.area());
                let d_tiles = device.upload("gradient of the tiles", &values)?;
                Ok(TileGradient { d_tiles, terms: Vec::new() })
            }
        }
    }

    /// Queues a look at the loss of [`Self::backward`]: see [`PartCounts::check_loss`](crate::stages::counts::PartCounts::check_loss).
    pub fn check(&self, device: &Device, bins: &TileBins) -> Result<()> {
        let (Self::Compared(comparison), Some(counts)) = (self, &bins.part_counts) else {
            return Ok(());
        };
        Ok(counts.check_loss(device, &comparison.sums[0].view(), &bins.pair_mask)?)
    }

    /// Whether a caller's function sees the tiles, which must then be there.
    pub fn is_own(&self) -> bool {
        matches!(self, Self::Compared(Comparison { own: Some(_), .. }))
    }

    /// The buffers to read after [`Self::backward`] of a part.
    pub fn buffers(&self) -> Vec<Buffer<u32>> {
        match self {
            Self::Given(_) => Vec::new(),
            Self::Compared(comparison) => comparison.sums.iter().map(Buffer::view).collect(),
        }
    }

    /// Takes the words of [`Self::buffers`].
    pub fn take(&mut self, part_tiles: &PartTiles, words: &[Vec<u32>]) {
        if let Self::Compared(comparison) = self {
            comparison.take(part_tiles, words);
        }
    }
}

impl<'a> Comparison<'a> {
    pub fn new(target: &'a LossTarget<'a>, own: Option<OwnGradient<'a>>) -> Self {
        Self { target, own, found: BTreeMap::new(), sums: Vec::new(), own_loss: 0.0 }
    }

    fn backward(
        &mut self,
        device: &Device,
        part_tiles: &PartTiles,
        rendered: &Buffer<f32>,
    ) -> Result<TileGradient> {
        let target = self.target;
        let area = part_tiles.area();
        let places = part_tiles.places();
        let [image, valid] = target.photographs.on_device(device, &places)?;
        let expose = |all: &[f32]| {
            let exposure = values_of_tiles(all, &places, exposure::VALUES);
            Exposed::new(device, rendered, part_tiles.side, &exposure)
        };
        let exposed = target.exposure.map(expose).transpose()?;
        let inputs = LossInputs {
            image: exposed.as_ref().map_or(rendered, |exposed| &exposed.image),
            target: &image,
            valid: &valid,
            valid_pixels: target.valid_pixels,
            ssim_weight: target.ssim_weight,
        };
        let output = device.run_in_pool(|| image_loss(device, part_tiles.side, &inputs))?;
        let mut d_tiles = output.grad_tiles;
        match &mut self.own {
            None => {}
            Some(OwnGradient::Host(all)) => {
                let values = values_of_tiles(all, &places, 3 * area);
                d_tiles = device.upload("gradient of the tiles", &values)?;
            }
            Some(OwnGradient::Device(own)) => {
                let found = own(&DeviceLossBatch { device, side: part_tiles.side, inputs })?;
                check_len(found.grad_tiles.len(), rendered.len())?;
                self.own_loss = found.loss;
                d_tiles = found.grad_tiles;
            }
        }
        self.sums = vec![output.row_sum.view()];
        if let Some(exposed) = exposed {
            self.sums.push(exposed.backward(device, rendered, &d_tiles)?.view());
        }
        let masked = |term: &CompositedTerm| MaskedTerm {
            term: *term,
            valid: valid.view(),
            factor: (f64::from(term.weight) / target.valid_pixels.max(1.0)) as f32,
        };
        Ok(TileGradient { d_tiles, terms: target.terms.iter().map(masked).collect() })
    }

    fn take(&mut self, part_tiles: &PartTiles, words: &[Vec<u32>]) {
        let rows: Vec<_> =
            words.iter().map(|words| bytemuck::cast_slice::<u32, f32>(words)).collect();
        let of_tile = |at: usize, which: usize| {
            let len = rows[which].len() / part_tiles.tiles.len();
            &rows[which][at * len..][..len]
        };
        for (at, tile) in part_tiles.tiles.iter().enumerate() {
            let exposure = (rows.len() > 1).then(|| exposure::gradient(of_tile(at, 1)));
            let numbers = TileNumbers {
                place: tile.place as f64,
                loss: TileLoss::of_rows(of_tile(at, 0)),
                own: std::mem::take(&mut self.own_loss),
                exposure: exposure.unwrap_or_default(),
            };
            self.found.insert(tile.place, numbers);
        }
    }

    /// Adds what other ranks have measured: as many numbers of each tile as there are.
    pub fn gather(&mut self, ranks: &dyn Ranks) -> Result<()> {
        let width = match (self.target.exposure, &self.own) {
            (None, None) => 5,
            (Some(_), None) => 11,
            (_, Some(_)) => 12,
        };
        let rows = self.found.values().flat_map(|tile| {
            let numbers: [f64; 12] = bytemuck::cast(*tile);
            numbers.into_iter().take(width)
        });
        let mine: Vec<f64> = rows.collect();
        for bytes in ranks.gather(bytemuck::cast_slice(&mine).to_vec())? {
            for row in bytemuck::pod_collect_to_vec::<u8, f64>(&bytes).chunks_exact(width) {
                let mut numbers = [0.0; 12];
                numbers[..width].copy_from_slice(row);
                self.found.insert(numbers[0] as usize, bytemuck::cast(numbers));
            }
        }
        Ok(())
    }

    /// What was measured of a batch; `loss` is known of a caller's loss on the host.
    pub fn finish(self, batch: &TileBatch, loss: Option<f64>) -> BatchLoss {
        let found: Vec<_> = self.found.into_values().collect();
        let tiles: Vec<_> = found.iter().map(|tile| tile.loss).collect();
        let loss = match (loss, self.own) {
            (Some(loss), _) => loss,
            (None, Some(_)) => found.iter().map(|tile| tile.own).sum(),
            (None, None) => TileLoss::total(&tiles).value(self.target.ssim_weight),
        };
        let exposures = found.iter().zip(&batch.tiles).enumerate().map(|(place, (found, tile))| {
            ExposureGradient { place, camera: tile.camera, gradient: found.exposure }
        });
        let exposures = self.target.exposure.map(|_| exposures.collect()).unwrap_or_default();
        BatchLoss { loss, tiles, exposures }
    }
}

/// Fails if a caller's loss has returned another number of values than there are pixels.
pub fn check_len(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    argument(format!("the loss returned {found} values of `grad_tiles`, expected {expected}"))
}
