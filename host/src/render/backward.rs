//! From the gradient of a batch's pixels to that of every tensor: the stages of [`Part`] in reverse.

use std::sync::atomic::Ordering;

use glam::Vec4;

use super::exposure::{self, Exposed, ExposureGradient};
use super::gradient::SceneGradient;
use super::loss::{Loss, LossInputs, TileLoss};
use super::part::Part;
use super::part_counts::Capacity;
use super::plan::{Plan, PlannedTile};
use super::project::project_backward;
use super::renderer::Renderer;
use super::scene::DeviceScene;
use crate::camera::Camera;
use crate::error::Result;
use crate::scene::Gradient;
use crate::tile::TileBatch;
use organza_device::{Buffer, Device};

impl Part {
    /// Adds the gradients of all tensors to `gradient`, of `image_gradient [tiles, 3, S, S]`, dLoss/dY of this part's
    /// tiles.
    pub fn backward(
        &self,
        device: &Device,
        scene: &DeviceScene,
        side: u32,
        image_gradient: &Buffer<f32>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let pair_gradient = self.pair_gradient(device, scene, side, image_gradient)?;
        self.raise_bounds(device, &pair_gradient, gradient)?;
        let (pairs, samples) = (&self.bins.pairs.count, &self.transmittance.samples);
        let [color, transmittance] = [&gradient.color.table, &gradient.transmittance.table];
        let has_transmittance = gradient.has_transmittance && samples.at_most() > 0;
        if pairs.at_most() > 0 {
            color.set_scale(device, &scene.color, pairs)?;
        }
        if has_transmittance {
            transmittance.set_scale(device, &scene.transmittance, samples)?;
        }
        self.spread(device, scene, &pair_gradient, gradient)?;
        if pairs.at_most() > 0 {
            color.finish(device)?;
        }
        if has_transmittance {
            transmittance.finish(device)?;
        }
        Ok(())
    }

    /// The first stages: `[pairs, 3]`, see [`splat_backward`](organza_shaders::splat).
    pub fn pair_gradient(
        &self,
        device: &Device,
        scene: &DeviceScene,
        side: u32,
        image_gradient: &Buffer<f32>,
    ) -> Result<Buffer<Vec4>> {
        let transmittance = &self.transmittance.transmittance;
        Ok(self.composite.backward(
            device,
            scene,
            side,
            &self.bins,
            transmittance,
            image_gradient,
        )?)
    }

    /// Raises the bounds of both hash grids' sums.
    pub fn raise_bounds(
        &self,
        device: &Device,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let pairs = &self.bins.pairs.count;
        if pairs.at_most() == 0 {
            return Ok(());
        }
        gradient.color.table.raise_bound(device, pair_gradient, None, pairs)?;
        let transmittance = &self.transmittance;
        if gradient.has_transmittance && transmittance.samples.at_most() > 0 {
            let values = Some(&transmittance.transmittance);
            gradient.transmittance.table.raise_bound(device, pair_gradient, values, pairs)?;
        }
        Ok(())
    }

    /// The other stages: adds the gradients of all tensors, those of the hash grids to their sums.
    pub fn spread(
        &self,
        device: &Device,
        scene: &DeviceScene,
        pair_gradient: &Buffer<Vec4>,
        gradient: &SceneGradient,
    ) -> Result<()> {
        let bins = &self.bins;
        project_backward(device, scene, bins, pair_gradient, gradient)?;
        if let Some(poses) = &gradient.poses {
            poses.add(device, scene, bins, pair_gradient)?;
        }
        let (pairs, mask) = (&bins.pairs, &bins.pair_mask);
        self.color.backward(device, scene, pairs, mask, pair_gradient, gradient)?;
        if gradient.has_transmittance {
            self.transmittance.backward(device, scene, bins, pair_gradient, gradient)?;
        }
        Ok(())
    }
}

/// The part of a batch's values `[K, len]` that belongs to a part's tiles, in their order.
pub(super) fn of_tiles(values: &[f32], tiles: &[PlannedTile], len: usize) -> Vec<f32> {
    tiles.iter().flat_map(|tile| &values[tile.place * len..][..len]).copied().collect()
}

/// What tiles are compared with: K tiles of S x S pixels.
#[derive(Clone, Copy, Debug)]
pub struct LossTarget<'a> {
    /// `[K, 3, S, S]`: the photographs; 0 where there is no pixel.
    pub image: &'a [f32],
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: &'a [f32],
    /// How many of `valid` are 1.
    pub valid_pixels: f64,
    /// w, the weight of `1 - SSIM` in the settings.
    pub ssim_weight: f32,
    /// `[K, 3, 2]`: a gain and an offset for each channel, which the rendered tiles get before they are compared. Without
    /// them they are compared as they are. A loss of your own never has them.
    pub exposure: Option<&'a [f32]>,
}

impl Renderer {
    /// dLoss/dtensor for every tensor of a scene, given `grad_output [K, 3, S, S]`, dLoss/dY.
    ///
    /// The networks see positions and directions as constants: position, rotation and scale have the gradient of the
    /// projection alone. [`Renderer::record`] gives the tiles, too.
    ///
    /// # Errors
    /// As [`Recording::backward`](super::Recording::backward).
    pub fn gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_output: &[f32],
    ) -> Result<Gradient> {
        self.record(scene, cameras, batch)?.backward(grad_output)
    }

    /// Does `work` with the parts of a batch; where one does not fit, all over again with smaller ones: what parts have
    /// added before would count twice.
    pub(super) fn in_parts<R>(
        &self,
        scene: &DeviceScene,
        batch: &TileBatch,
        mut work: impl FnMut(&[Plan]) -> Result<R>,
    ) -> Result<R> {
        let mut plans = self.plans(scene, batch)?;
        loop {
            match work(&plans) {
                Err(error) if error.is_out_of_memory() && plans.len() < batch.tiles.len() => {
                    let before = plans.len();
                    // the next batch will not fit, either
                    while plans.len() == before {
                        let half = self.part_bytes.load(Ordering::Relaxed) / 2;
                        self.part_bytes.store(half, Ordering::Relaxed);
                        plans = self.plans(scene, batch)?;
                    }
                }
                Err(error) if error.is_out_of_memory() && self.forget() => {}
                result => return result,
            }
        }
    }

    /// Adds dLoss/dtensor of `grad_output [K, 3, S, S]` to `gradient`, and waits for it.
    ///
    /// # Errors
    /// As [`Renderer::gradient`].
    pub(crate) fn add_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let plans = self.plans(scene, batch)?;
        self.add_parts(scene, cameras, &plans, grad_output, gradient)?;
        gradient.check(self.device())
    }

    pub(super) fn add_parts(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        plans: &[Plan],
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = self.device();
        let add = |plan: &Plan, capacity: Option<Capacity>| {
            let part = Part::evaluate(device, scene, cameras, plan, true, capacity)?;
            let pixels = of_tiles(grad_output, &plan.tiles, 3 * (plan.side * plan.side) as usize);
            let pixels = device.upload("gradient of the tiles", &pixels)?;
            part.backward(device, scene, plan.side, &pixels, gradient)?;
            Ok(part.read(device, Vec::new())?)
        };
        device.run_in_pool(|| {
            plans.iter().try_for_each(|plan| {
                self.with_predicted_capacity(scene, plan, |capacity| add(plan, capacity)).map(drop)
            })
        })
    }

    /// Adds the gradients of a batch's loss to `gradient`; returns the losses of the tiles, by camera, and the gradients
    /// of the exposures, in the order of the batch, if the target has them.
    ///
    /// On a GPU a part is one submission and one wait, for the losses, after a first one that has found out what such
    /// batches need.  `gradient` is that of a step: but for the statistics, zero before.  `loss` is kept from
    /// step to step.
    ///
    /// # Errors
    /// As [`Renderer::render`].
    pub(crate) fn add_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
    ) -> Result<(Vec<TileLoss>, Vec<ExposureGradient>)> {
        let device = self.device();
        let area = (batch.side * batch.side) as usize;
        let add = |loss: &Loss, plan: &Plan, capacity: Option<Capacity>| {
            let part = Part::evaluate(device, scene, cameras, plan, true, capacity)?;
            let image =
                device.upload("photographs", &of_tiles(target.image, &plan.tiles, 3 * area))?;
            let valid = device.upload("masks", &of_tiles(target.valid, &plan.tiles, area))?;
            let rendered = &part.composite.image;
            let expose = |all: &[f32]| {
                let exposure = of_tiles(all, &plan.tiles, exposure::VALUES);
                Exposed::new(device, rendered, plan.side, &exposure)
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
            let back = |exposed: &Exposed| exposed.backward(device, rendered, &output.grad_image);
            let row_sum = exposed.as_ref().map(back).transpose()?;
            part.backward(device, scene, plan.side, &output.grad_image, gradient)?;
            let (losses, rows, needed) = output.sums_and_needed(device, &part, row_sum.as_ref())?;
            let exposures = exposure::gradients(&rows, plan.side, &plan.tiles);
            Ok(((losses, exposures), needed))
        };
        gradient.begin(device);
        self.in_parts(scene, batch, |plans| {
            let mut losses = Vec::with_capacity(batch.tiles.len());
            let mut exposures = Vec::new();
            for plan in plans {
                let found =
                    Loss::of_tiles(loss, device, batch.side, plan.tiles.len()).and_then(|loss| {
                        let add = |capacity| add(loss, plan, capacity);
                        device.run_in_pool(|| self.with_predicted_capacity(scene, plan, add))
                    });
                let found = found.inspect_err(|_| gradient.restart(device))?;
                losses.extend(found.0);
                exposures.extend(found.1);
            }
            exposures.sort_by_key(|exposure: &ExposureGradient| exposure.place);
            Ok((losses, exposures))
        })
    }
}
