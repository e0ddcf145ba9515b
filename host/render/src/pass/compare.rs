//! Rendered tiles beside photographs: the loss, its gradient, and what is measured of each tile.

use std::collections::BTreeMap;

use super::part::{Part, TileGradient};
use super::pass::{GoBack, Pass};
use crate::stages::cut::{PartTiles, PlannedTile, values_of_tiles};
use crate::stages::distortion::Distortion;
use crate::stages::exposure::{self, Exposed, ExposureGradient};
use crate::{
    DeviceScene, Loss, LossInputs, LossOutput, LossTarget, Renderer, SceneGradient, TileLoss,
};
use muslin_device::{Buffer, Device};
use organza_core::ranks::Ranks;
use organza_core::{Camera, Result, TileBatch};

/// Losses of tiles, and the gradients of their exposures if they are learned, in the order of the batch.
pub(crate) type Compared = (Vec<TileLoss>, Vec<ExposureGradient>);

/// Tiles that were compared.
#[derive(Debug)]
struct Comparison {
    output: LossOutput,
    /// Of the exposures, if they are learned: see [`exposure::gradients`].
    row_sum: Option<Buffer<f32>>,
    /// The term of the loss beside the image.
    distortion: Option<Distortion>,
}

impl Comparison {
    /// Compares `rendered [K, 3, S, S]`, some tiles of a batch.
    fn new(
        device: &Device,
        loss: &Loss,
        target: &LossTarget<'_>,
        (tiles, side): (&[PlannedTile], u32),
        rendered: &Buffer<f32>,
    ) -> Result<Self> {
        let area = (side * side) as usize;
        let image =
            device.upload("photographs", &values_of_tiles(target.image, tiles, 3 * area))?;
        let valid = device.upload("masks", &values_of_tiles(target.valid, tiles, area))?;
        let expose = |all: &[f32]| {
            let exposure = values_of_tiles(all, tiles, exposure::VALUES);
            Exposed::new(device, rendered, side, &exposure)
        };
        let exposed = target.exposure.map(expose).transpose()?;
        let inputs = LossInputs {
            image: exposed.as_ref().map_or(rendered, |exposed| &exposed.image),
            target: &image,
            valid: &valid,
            valid_pixels: target.valid_pixels,
            ssim_weight: target.ssim_weight,
        };
        let output = loss.evaluate(device, &inputs)?;
        let back = |exposed: &Exposed| exposed.backward(device, rendered, &output.grad_tiles);
        let row_sum = exposed.as_ref().map(back).transpose()?;
        Ok(Self { output, row_sum, distortion: target.distortion(&valid) })
    }

    /// dL/dY, and the term beside the image.
    fn of_tiles(&mut self) -> TileGradient {
        let grad_tiles = self.output.grad_tiles.view();
        TileGradient { grad_tiles, distortion: self.distortion.take() }
    }

    /// The buffers to read for [`Self::found`].
    fn buffers(&self) -> Vec<Buffer<u32>> {
        let rows = self.row_sum.as_ref().map(Buffer::view);
        [self.output.row_sum.view()].into_iter().chain(rows).collect()
    }

    /// What the words of [`Self::buffers`] say of the tiles.
    fn found(&self, (tiles, side): (&[PlannedTile], u32), words: &[Vec<u32>]) -> Found {
        let losses = self.output.sums_of(&bytemuck::pod_collect_to_vec(&words[0]));
        let rows: &[f32] = words.get(1).map_or(&[], |rows| bytemuck::cast_slice(rows));
        let exposures = exposure::gradients(rows, side, tiles);
        let mut exposures = exposures.into_iter();
        let places = tiles.iter().map(|tile| tile.place);
        Found(places.zip(losses).map(|(place, loss)| (place, (loss, exposures.next()))).collect())
    }
}

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`; returns the losses of the tiles and the gradients of the
    /// exposures, if the target has them, in the order of the batch.
    ///
    /// With `ranks`, each has the same batch and the same scene, and renders some views of the batch. All get the same
    /// gradient.
    ///
    /// On a GPU a batch of one part is one wait, for the losses, after a first one that has found
    /// out what such batches need. `gradient` is that of a step: but for the statistics, zero before. `loss` is kept
    /// from step to step.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Rank`](organza_core::Error::Rank). The gradient is then as it
    /// was before.
    #[allow(clippy::too_many_arguments)]
    pub fn add_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
        ranks: Option<&dyn Ranks>,
    ) -> Result<Compared> {
        batch.validate(cameras)?;
        let device = self.device();
        gradient.snapshot(device);
        let ranks = ranks.filter(|ranks| ranks.size() > 1);
        let mut pass = Pass { ranks, ..self.pass(scene, cameras) };
        let (tiles, views) = pass.deal(batch)?;
        pass.views = views;
        let mut found = Found::default();
        let of_tiles = |plan: &PartTiles, part: &Part, back: &mut GoBack<'_>| {
            let loss = Loss::reuse(loss, device, plan.side, plan.tiles.len())?;
            let tiles = (&plan.tiles[..], plan.side);
            let image = &part.composite.image;
            let compare = || Comparison::new(device, loss, target, tiles, image);
            let mut compared = device.run_in_pool(compare)?;
            back(compared.of_tiles())?;
            let Some((words, needed)) = part.read(device, compared.buffers())? else {
                return Ok(None);
            };
            found.0.extend(compared.found(tiles, &words).0);
            Ok(Some(needed))
        };
        pass.backward(&mut pass.cut_tiles(batch.side, &tiles)?, of_tiles, gradient)?;
        if let Some(ranks) = ranks {
            let all = found.gather(batch, target, ranks);
            found = all.inspect_err(|_| gradient.rollback(device))?;
        }
        Ok(found.in_order())
    }
}

/// Losses of tiles and gradients of their exposures, by the tiles' places in the batch.
#[derive(Debug, Default)]
struct Found(BTreeMap<usize, (TileLoss, Option<ExposureGradient>)>);

/// Values of a tile that ranks tell each other: its place, its loss, and its exposure's gradient if that is learned.
const LOSS_VALUES: usize = 5;
const EXPOSURE_VALUES: usize = 6;

impl Found {
    fn in_order(self) -> Compared {
        let (losses, exposures): (Vec<_>, Vec<_>) = self.0.into_values().unzip();
        (losses, exposures.into_iter().flatten().collect())
    }

    /// The results of all ranks for a batch.
    fn gather(
        &self,
        batch: &TileBatch,
        target: &LossTarget<'_>,
        ranks: &dyn Ranks,
    ) -> Result<Self> {
        let mut values = Vec::new();
        for (place, (loss, exposure)) in &self.0 {
            values.push(*place as f64);
            values.extend(bytemuck::cast::<_, [f64; LOSS_VALUES - 1]>(*loss));
            values.extend(exposure.iter().flat_map(|found| found.gradient.as_flattened()));
        }
        let width = LOSS_VALUES + target.exposure.map_or(0, |_| EXPOSURE_VALUES);
        let mut all = Self::default();
        for bytes in ranks.gather(bytemuck::cast_slice(&values).to_vec())? {
            let values: Vec<f64> = bytemuck::pod_collect_to_vec(&bytes);
            for row in values.chunks_exact(width) {
                let place = row[0] as usize;
                let (loss, exposure) = row[1..].split_at(LOSS_VALUES - 1);
                let loss = bytemuck::pod_read_unaligned(bytemuck::cast_slice(loss));
                let camera = batch.tiles[place].camera;
                let exposure = exposure.as_chunks::<EXPOSURE_VALUES>().0.first().map(|gradient| {
                    ExposureGradient { place, camera, gradient: bytemuck::cast(*gradient) }
                });
                all.0.insert(place, (loss, exposure));
            }
        }
        Ok(all)
    }
}
