//! The gradient of a training step whose Gaussians are dealt to ranks.

use std::collections::{BTreeMap, BTreeSet};

use super::backward::{LossTarget, of_tiles};
use super::device_share::DeviceShare;
use super::exposure::{self, Exposed, ExposureGradient};
use super::loss::{Loss, LossInputs, TileLoss};
use super::plan::PlannedTile;
use super::renderer::Renderer;
use super::results::RenderedTiles;
use super::share_gradient::ShareGradient;
use super::units::Compared;
use crate::camera::Camera;
use crate::error::Result;
use crate::ranks::Grid;
use crate::tile::TileBatch;

/// Pixels that are compared at once: 200 MiB of memory.
const COMPARED_PIXELS: usize = 1 << 20;

/// A step's tiles, as groups of ranks share them.
struct Deal {
    /// Those of each group, in the order of the batch.
    tiles: Vec<Vec<PlannedTile>>,
    /// Cameras of the step.
    units: usize,
}

impl Deal {
    /// The tiles of camera u of a step are those of group u mod V.
    fn new(batch: &TileBatch, groups: usize) -> Self {
        let cameras: BTreeSet<_> = batch.tiles.iter().map(|tile| tile.camera).collect();
        let units: BTreeMap<_, _> = cameras.into_iter().zip(0..).collect();
        let mut tiles = vec![Vec::new(); groups];
        for (place, &tile) in batch.tiles.iter().enumerate() {
            tiles[units[&tile.camera] % groups].push(PlannedTile { tile, place });
        }
        Self { tiles, units: units.len() }
    }
}

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`, as [`Renderer::add_loss_gradient`] does, together with other
    /// ranks: each has its share of the same scene, and the same batch. Each group renders some of it. Returns the losses of
    /// all tiles and the gradients of their exposures, in their order.
    ///
    /// # Errors
    /// As [`Renderer::record_share`]; [`Error::Diverged`](crate::Error::Diverged) where a network's gradient is not finite.
    /// The gradient is then as it was before.
    pub(crate) fn add_share_gradient(
        &self,
        (share, grid): (&DeviceShare, Grid<'_>),
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &ShareGradient,
    ) -> Result<Compared> {
        batch.validate(cameras)?;
        let deal = Deal::new(batch, grid.groups());
        let mine = &deal.tiles[grid.group()];
        let tiles = mine.iter().map(|planned| planned.tile).collect();
        let of_group = TileBatch { side: batch.side, tiles };
        let recording = self.record_group((share, grid), cameras, &of_group, deal.units)?;
        let (found, grad_output) = self.compare(recording.tiles(), mine, loss, target)?;
        let device = self.device();
        gradient.snapshot(device);
        let added = recording.add(&grad_output, gradient).and_then(|()| deal.all(found, grid));
        added.inspect_err(|_| gradient.rollback(device))
    }

    /// The losses of rendered tiles, the gradients of their exposures, and dLoss/dY.
    fn compare(
        &self,
        rendered: &RenderedTiles,
        tiles: &[PlannedTile],
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
    ) -> Result<(Compared, Vec<f32>)> {
        let device = self.device();
        let area = (rendered.side * rendered.side) as usize;
        let most = (COMPARED_PIXELS / area).max(1);
        let ((mut losses, mut exposures), mut gradient) = (Compared::default(), Vec::new());
        for (tiles, pixels) in tiles.chunks(most).zip(rendered.data.chunks(most * 3 * area)) {
            let loss = Loss::of_tiles(loss, device, rendered.side, tiles.len())?;
            let image = device.upload("rendered tiles", pixels)?;
            let expose = |all: &[f32]| {
                let exposure = of_tiles(all, tiles, exposure::VALUES);
                device.run_in_pool(|| Exposed::new(device, &image, rendered.side, &exposure))
            };
            let exposed = target.exposure.map(expose).transpose()?;
            let inputs = LossInputs {
                image: exposed.as_ref().map_or(&image, |exposed| &exposed.image),
                target: &device.upload("photographs", &of_tiles(target.image, tiles, 3 * area))?,
                valid: &device.upload("masks", &of_tiles(target.valid, tiles, area))?,
                valid_pixels: target.valid_pixels,
                ssim_weight: target.ssim_weight,
            };
            let output = device.run_in_pool(|| loss.evaluate(device, &inputs))?;
            if let Some(exposed) = &exposed {
                let back = || exposed.backward(device, &image, &output.grad_image);
                let rows = device.read(&device.run_in_pool(back)?)?;
                exposures.extend(exposure::gradients(&rows, rendered.side, tiles));
            }
            losses.extend(output.sums(device)?);
            gradient.extend(device.read(&output.grad_image)?);
        }
        Ok(((losses, exposures), gradient))
    }
}

impl Deal {
    /// What all groups have found, in the order of the batch. All ranks of a group have the same: one sends it.
    fn all(&self, mine: Compared, grid: Grid<'_>) -> Result<Compared> {
        if grid.groups() == 1 {
            return Ok(mine);
        }
        let (losses, exposures) = if grid.share() == 0 { mine } else { Compared::default() };
        let gradients: Vec<_> = exposures.iter().map(|exposure| exposure.gradient).collect();
        let mut bytes = bytemuck::cast_slice(&losses).to_vec();
        bytes.extend_from_slice(bytemuck::cast_slice(gradients.as_flattened()));
        let all = grid.all.gather(bytes)?;
        let (mut losses, mut exposures) = (Vec::new(), Vec::new());
        for (tiles, bytes) in self.tiles.iter().zip(all.iter().step_by(grid.shares)) {
            let (of_losses, rest) = bytes.split_at(tiles.len() * size_of::<TileLoss>());
            let found: Vec<TileLoss> = bytemuck::pod_collect_to_vec(of_losses);
            losses.extend(tiles.iter().map(|tile| tile.place).zip(found));
            let gradients: Vec<[[f64; 2]; 3]> = bytemuck::pod_collect_to_vec(rest);
            exposures.extend(tiles.iter().zip(gradients).map(|(tile, gradient)| {
                let (place, camera) = (tile.place, tile.tile.camera);
                ExposureGradient { place, camera, gradient }
            }));
        }
        losses.sort_by_key(|(place, _)| *place);
        exposures.sort_by_key(|exposure| exposure.place);
        Ok((losses.into_iter().map(|(_, loss)| loss).collect(), exposures))
    }
}
