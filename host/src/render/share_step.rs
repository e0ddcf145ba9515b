//! The gradient of a training step whose Gaussians are dealt to ranks.

use std::collections::{BTreeMap, BTreeSet};

use super::backward::{LossTarget, of_tiles};
use super::device_share::DeviceShare;
use super::loss::{Loss, LossInputs, TileLoss};
use super::plan::PlannedTile;
use super::renderer::Renderer;
use super::results::RenderedTiles;
use super::share_gradient::ShareGradient;
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
    /// all tiles, in their order.
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
    ) -> Result<Vec<TileLoss>> {
        batch.validate(cameras)?;
        let deal = Deal::new(batch, grid.groups());
        let mine = &deal.tiles[grid.group()];
        let tiles = mine.iter().map(|planned| planned.tile).collect();
        let of_group = TileBatch { side: batch.side, tiles };
        let of_step = (deal.units, batch.tiles.len());
        let recording = self.record_group((share, grid), cameras, &of_group, of_step)?;
        let (losses, grad_output) = self.compare(recording.tiles(), mine, loss, target)?;
        let device = self.device();
        gradient.begin(device);
        let added = recording.add(&grad_output, gradient).and_then(|()| deal.all(losses, grid));
        added.inspect_err(|_| gradient.restart(device))
    }

    /// The losses of rendered tiles, and dLoss/dY.
    fn compare(
        &self,
        rendered: &RenderedTiles,
        tiles: &[PlannedTile],
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
    ) -> Result<(Vec<TileLoss>, Vec<f32>)> {
        let device = self.device();
        let area = (rendered.side * rendered.side) as usize;
        let most = (COMPARED_PIXELS / area).max(1);
        let (mut losses, mut gradient) = (Vec::with_capacity(tiles.len()), Vec::new());
        for (tiles, pixels) in tiles.chunks(most).zip(rendered.data.chunks(most * 3 * area)) {
            let loss = Loss::of_tiles(loss, device, rendered.side, tiles.len())?;
            let inputs = LossInputs {
                image: &device.upload("rendered tiles", pixels)?,
                target: &device.upload("photographs", &of_tiles(target.image, tiles, 3 * area))?,
                valid: &device.upload("masks", &of_tiles(target.valid, tiles, area))?,
                valid_pixels: target.valid_pixels,
                ssim_weight: target.ssim_weight,
            };
            let output = device.run_in_pool(|| loss.evaluate(device, &inputs))?;
            losses.extend(output.sums(device)?);
            gradient.extend(device.read(&output.grad_image)?);
        }
        Ok((losses, gradient))
    }
}

impl Deal {
    /// The losses of all groups' tiles, in the order of the batch. All ranks of a group have the same: one sends them.
    fn all(&self, mine: Vec<TileLoss>, grid: Grid<'_>) -> Result<Vec<TileLoss>> {
        if grid.groups() == 1 {
            return Ok(mine);
        }
        let mine = if grid.share() == 0 { mine } else { Vec::new() };
        let all = grid.all.gather(bytemuck::cast_slice(&mine).to_vec())?;
        let mut losses = Vec::new();
        for (tiles, bytes) in self.tiles.iter().zip(all.iter().step_by(grid.shares)) {
            let found: Vec<TileLoss> = bytemuck::pod_collect_to_vec(bytes);
            losses.extend(tiles.iter().map(|tile| tile.place).zip(found));
        }
        losses.sort_by_key(|(place, _)| *place);
        Ok(losses.into_iter().map(|(_, loss)| loss).collect())
    }
}
