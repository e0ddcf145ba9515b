//! The gradient of a training step.
//!
//! A view batch is a step's tiles of one camera. Its gradients have the same bits whoever computes it, alone or in one
//! part with others. So the sum depends neither on how a batch is cut into parts, nor on how many
//! [ranks](organza_core::ranks) share it. View batches are dealt to ranks: the one with the number v is computed by
//! rank v mod R.
//!
//! - **hash grids** are summed as 64-bit integers, which are exact in any order. All view batches share one scale: its
//!   bound is the largest of all bounds.
//! - **networks and poses** are summed as [binned](muslin::binned) sums, which are exact, too.
//! - **Gaussians** are summed camera by camera; between ranks as [`Rows`].

use std::collections::{BTreeMap, BTreeSet};

use glam::Vec4;

use super::compare::{Compared, Comparison, Found};
use super::field_sums::{finish, set_scales};
use super::ranks::Rows;
use crate::pass::part::Part;
use crate::pass::renderer::Renderer;
use crate::scene::device_scene::DeviceScene;
use crate::scene::device_shard::DeviceShard;
use crate::stages::counts::{Capacity, Needed};
use crate::stages::cut::{PartTiles, PlannedTile};
use crate::stages::gradient::{SceneGradient, ShardGradient};
use crate::stages::loss::Loss;
use crate::stages::loss::LossTarget;
use muslin_device::{Buffer, Device};
use organza_core::RenderedTiles;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::ranks::{Grid, Ranks};
use organza_core::tile::TileBatch;

/// The most samples of parts that are kept between both passes: about 2 GiB of tables. Other parts are rendered twice.
const KEPT_SAMPLES: u64 = 1 << 24;
/// Pixels that are compared at once, where Gaussians are dealt to ranks: 200 MiB of memory.
const COMPARED_PIXELS: usize = 1 << 20;

/// A step.
#[derive(Clone, Copy)]
pub(crate) struct Step<'a> {
    pub(crate) renderer: &'a Renderer,
    pub(crate) scene: &'a DeviceScene,
    pub(crate) cameras: &'a [Camera],
    pub(crate) target: &'a LossTarget<'a>,
    pub(crate) gradient: &'a SceneGradient,
}

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`; returns the losses of the tiles and the gradients of the
    /// exposures, if the target has them, in the order of the batch.
    ///
    /// With `ranks`, each has the same scene and the same batch, and then the same gradient.
    ///
    /// On a GPU a batch of one part is one wait, for the losses, after a first one that has found
    /// out what such batches need. `gradient` is that of a step: but for the statistics, zero before. `loss` is kept
    /// from step to step.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Rank`](organza_core::Error::Rank).
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
        let step = Step { renderer: self, scene, cameras, target, gradient };
        gradient.snapshot(self.device());
        let rollback = |_: &_| gradient.rollback(self.device());
        let found = match ranks.filter(|ranks| ranks.size() > 1) {
            None => self.in_parts(scene, batch, |plans| {
                let found = match plans {
                    [plan] => step.at_once(plan, loss),
                    // they are last first
                    _ => step.in_passes(plans.iter().rev().collect(), loss, None),
                };
                found.inspect_err(rollback)
            })?,
            Some(ranks) => {
                let (views, limits) = self.view_batches(scene, batch)?;
                let mine = views.iter().skip(ranks.rank()).step_by(ranks.size()).cloned();
                let plans = limits.join(&mine.collect::<Vec<_>>());
                let shared = Some((ranks, views.len()));
                let found = step.in_passes(plans.iter().collect(), loss, shared);
                found.and_then(|found| found.gather(batch, target, ranks)).inspect_err(rollback)?
            }
        };
        Ok(found.in_order())
    }

    /// Like [`Renderer::add_loss_gradient`] together with other ranks: each has its shard of the same scene, and the
    /// same batch. Each group renders some of it.
    ///
    /// # Errors
    /// The same errors as [`Renderer::record_shard`]. The gradient is then as it was before.
    pub fn add_shard_gradient(
        &self,
        (shard, grid): (&DeviceShard, Grid<'_>),
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &ShardGradient,
    ) -> Result<Compared> {
        batch.validate(cameras)?;
        let (mine, views) = tiles_of_group(batch, grid);
        let tiles = mine.iter().map(|planned| planned.tile).collect();
        let of_group = TileBatch { side: batch.side, tiles };
        let recording = self.record_group((shard, grid), cameras, &of_group, views)?;
        let (mut found, grad_output) = self.compare(recording.tiles(), &mine, loss, target)?;
        recording.add_to(&grad_output, &gradient.fields, &gradient.blocks)?;
        if grid.groups() > 1 {
            // all ranks of a group have the same: one sends it
            let mine = if grid.shard() == 0 { found } else { Found::default() };
            let all = mine.gather(batch, target, grid.all);
            found = all.inspect_err(|_| gradient.rollback(self.device()))?;
        }
        Ok(found.in_order())
    }

    /// The losses of rendered tiles, and dLoss/dY.
    fn compare(
        &self,
        rendered: &RenderedTiles,
        tiles: &[PlannedTile],
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
    ) -> Result<(Found, Vec<f32>)> {
        let device = self.device();
        let side = rendered.side;
        let area = (side * side) as usize;
        let most = (COMPARED_PIXELS / area).max(1);
        let mut found = Found::default();
        let mut gradient = Vec::new();
        for (tiles, pixels) in tiles.chunks(most).zip(rendered.data.chunks(most * 3 * area)) {
            let loss = Loss::reuse(loss, device, side, tiles.len())?;
            let image = device.upload("rendered tiles", pixels)?;
            let of_tiles = (tiles, side);
            let compare = || Comparison::new(device, loss, target, of_tiles, &image);
            let (some, of_some) = device.run_in_pool(compare)?.read_gradient(device, of_tiles)?;
            found.extend(some);
            gradient.extend(of_some);
        }
        Ok((found, gradient))
    }
}

/// The tiles that a group of ranks renders, in the order of the batch, and how many view batches there are.
fn tiles_of_group(batch: &TileBatch, grid: Grid<'_>) -> (Vec<PlannedTile>, usize) {
    let cameras: BTreeSet<_> = batch.tiles.iter().map(|tile| tile.camera).collect();
    let views: BTreeMap<_, _> = cameras.into_iter().zip(0..).collect();
    let tiles = batch.tiles.iter().enumerate().map(|(place, &tile)| PlannedTile { tile, place });
    let mine = tiles.filter(|tile| views[&tile.tile.camera] % grid.groups() == grid.group());
    (mine.collect(), views.len())
}

impl Step<'_> {
    fn device(&self) -> &Device {
        self.renderer.device()
    }

    /// A step in one part.
    fn at_once(&self, plan: &PartTiles, loss: &mut Option<Loss>) -> Result<Found> {
        let device = self.device();
        let scene = self.scene;
        let loss = Loss::reuse(loss, device, plan.side, plan.tiles.len())?;
        let work = |capacity: Option<Capacity>| {
            let (part, compared) = self.render(plan, loss, capacity)?;
            part.backward(scene, plan.side, &compared.output.grad_image, self.gradient)?;
            compared.read(device, &part, (&plan.tiles, plan.side))
        };
        device.run_in_pool(|| self.renderer.with_predicted_capacity(scene, plan, work))
    }

    /// A step in several parts: the second pass needs the bounds of all of them. Or what this rank has of a step with
    /// so many view batches.
    fn in_passes(
        &self,
        plans: Vec<&PartTiles>,
        loss: &mut Option<Loss>,
        shared: Option<(&dyn Ranks, usize)>,
    ) -> Result<Found> {
        let device = self.device();
        let scene = self.scene;
        let gradient = self.gradient;
        let ranks = shared.map(|(ranks, _)| ranks);
        let Parts { kept, samples, found } = Parts::render(self, &plans, loss)?;
        set_scales(device, ranks, scene, gradient, samples)?;
        let mut rows = ranks.map(|ranks| Rows::new(device, ranks, [gradient])).transpose()?;
        for (plan, kept) in plans.into_iter().zip(kept) {
            let (part, pair_gradient) = match kept {
                Some(kept) => kept,
                None => Parts::render_one(self, plan, loss)?.0,
            };
            let rows = rows.as_mut().map(|rows| (rows, 0));
            let add = || part.add_pairs(scene, &pair_gradient, gradient, rows, false);
            device.run_in_pool(add)?;
        }
        if let (Some(rows), Some((_, views))) = (rows, shared) {
            rows.add(views)?;
        }
        finish(device, ranks, gradient)?;
        Ok(found)
    }

    /// Renders a part, and compares it.
    fn render(
        &self,
        plan: &PartTiles,
        loss: &Loss,
        capacity: Option<Capacity>,
    ) -> Result<(Part, Comparison)> {
        let device = self.device();
        let mut part = Part::evaluate(self.scene, self.cameras, plan, true, capacity)?;
        let tiles = (&plan.tiles[..], plan.side);
        let image = &part.composite.image;
        let mut compared = Comparison::new(device, loss, self.target, tiles, image)?;
        part.composite.distortion = compared.distortion.take();
        Ok((part, compared))
    }
}

/// A part, and the gradient of its pairs, `[pairs, 3]`.
type Kept = (Part, Buffer<Vec4>);

/// The parts of a step, after the first of both passes.
struct Parts {
    /// Parts that are not kept are rendered again.
    kept: Vec<Option<Kept>>,
    /// Of the color and of the transmittance field.
    samples: [i64; 2],
    found: Found,
}

impl Parts {
    /// Renders and compares all parts, and raises the bounds of the hash grids' sums.
    fn render(step: &Step<'_>, plans: &[&PartTiles], loss: &mut Option<Loss>) -> Result<Self> {
        let mut kept = Vec::new();
        let mut samples = [0; 2];
        let mut found = Found::default();
        let mut keeps = true;
        for plan in plans {
            let (part, of_part, capacity) = match Self::render_one(step, plan, loss) {
                Err(error) if error.is_out_of_memory() && kept.iter().any(Option::is_some) => {
                    // those that were kept may be what takes the memory
                    keeps = false;
                    kept.fill_with(|| None);
                    Self::render_one(step, plan, loss)?
                }
                result => result?,
            };
            part.0.raise_bounds(step.device(), &part.1, step.gradient)?;
            samples[0] += i64::from(capacity.pairs);
            samples[1] += i64::from(capacity.samples);
            found.extend(of_part);
            let is_kept = keeps && samples.iter().sum::<i64>() as u64 <= KEPT_SAMPLES;
            kept.push(is_kept.then_some(part));
        }
        Ok(Self { kept, samples, found })
    }

    /// Renders and compares a part, and goes back to its pairs.
    fn render_one(
        step: &Step<'_>,
        plan: &PartTiles,
        loss: &mut Option<Loss>,
    ) -> Result<(Kept, Found, Capacity)> {
        let device = step.device();
        let loss = Loss::reuse(loss, device, plan.side, plan.tiles.len())?;
        let work = |capacity: Option<Capacity>| {
            let (part, compared) = step.render(plan, loss, capacity)?;
            let image_gradient = &compared.output.grad_image;
            let pair_gradient = part.pair_gradient(step.scene, plan.side, image_gradient)?;
            let (found, needed) = compared.read(device, &part, (&plan.tiles, plan.side))?;
            Ok((((part, pair_gradient), found, needed), needed))
        };
        let work = || step.renderer.with_predicted_capacity(step.scene, plan, work);
        let (kept, found, needed) = device.run_in_pool(work)?;
        let Needed::Capacity(capacity) = needed else { unreachable!("it was rendered again") };
        Ok((kept, found, capacity))
    }
}
