//! The gradient of a training step.
//!
//! A unit is a step's tiles of one camera. Its gradients have the same bits whoever computes it, alone or in one part with
//! others, and they are added in the order of the cameras. So the sum depends neither on how a batch is cut into parts, nor on
//! how many [ranks](crate::ranks) share it. Units are dealt to ranks: unit u is computed by rank u mod R.
//!
//! - **hash grids** as 64-bit integers, whose sums are exact in any order. All units share one scale: its bound is the
//!   largest of all bounds. Only blocks that some rank has touched travel.
//! - **Gaussians** camera by camera; between ranks as [`Rows`].
//! - **networks** unit by unit, to everyone.
//! - **poses** to everyone: a camera's tiles are one rank's.

use glam::Vec4;

use super::backward::{LossTarget, of_tiles};
use super::exposure::{self, Exposed, ExposureGradient};
use super::field_sums::{finish, set_scales};
use super::gradient::SceneGradient;
use super::loss::{Loss, LossInputs, LossOutput, TileLoss};
use super::part::Part;
use super::part_counts::{Capacity, Needed};
use super::plan::Plan;
use super::renderer::Renderer;
use super::rows::Rows;
use super::scene::DeviceScene;
use crate::camera::Camera;
use crate::error::Result;
use crate::ranks::Ranks;
use crate::tile::TileBatch;
use organza_device::{Buffer, Device};

/// The most samples of parts that are kept between both passes: about 2 GiB of tables. Other parts are rendered twice.
const KEPT_SAMPLES: u64 = 1 << 24;

/// What tiles were compared with, and what came out: in the same order, by camera.
pub(super) type Compared = (Vec<TileLoss>, Vec<ExposureGradient>);

/// A part that was rendered and compared.
#[derive(Debug)]
struct Rendered {
    part: Part,
    output: LossOutput,
    /// Of the exposures, if they are learned: see [`exposure::gradients`].
    row_sum: Option<Buffer<f32>>,
}

/// A step.
#[derive(Clone, Copy)]
struct Step<'a> {
    renderer: &'a Renderer,
    scene: &'a DeviceScene,
    cameras: &'a [Camera],
    target: &'a LossTarget<'a>,
    gradient: &'a SceneGradient,
}

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`; returns the losses of the tiles, by camera, and the gradients
    /// of the exposures, in the order of the batch, if the target has them.
    ///
    /// With `ranks`, each has the same scene and the same batch, and then the same gradient.
    ///
    /// On a GPU a batch of one part is one submission and one wait, for the losses, after a first one that has found out what
    /// such batches need. `gradient` is that of a step: but for the statistics, zero before. `loss` is kept from step to
    /// step.
    ///
    /// # Errors
    /// As [`Renderer::render`]; [`Error::Rank`](crate::Error::Rank).
    #[allow(clippy::too_many_arguments)]
    pub(crate) fn add_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
        ranks: Option<&dyn Ranks>,
    ) -> Result<Compared> {
        let ranks = ranks.filter(|ranks| ranks.size() > 1);
        let step = Step { renderer: self, scene, cameras, target, gradient };
        gradient.snapshot(self.device());
        let restart = |_: &_| gradient.rollback(self.device());
        let (losses, mut exposures) = match ranks {
            None => self.in_parts(scene, batch, |plans| {
                let added = match plans {
                    [plan] => step.at_once(plan, loss),
                    _ => step.alone(plans, loss),
                };
                added.inspect_err(restart)
            }),
            Some(ranks) => step.together(batch, loss, ranks).inspect_err(restart),
        }?;
        exposures.sort_by_key(|exposure| exposure.place);
        Ok((losses, exposures))
    }
}

impl Step<'_> {
    fn device(&self) -> &Device {
        self.renderer.device()
    }

    /// A step in one part.
    fn at_once(&self, plan: &Plan, loss: &mut Option<Loss>) -> Result<Compared> {
        let (device, scene) = (self.device(), self.scene);
        let loss = Loss::of_tiles(loss, device, plan.side, plan.tiles.len())?;
        let work = |capacity: Option<Capacity>| {
            let rendered = self.render(plan, loss, capacity)?;
            let Rendered { part, output, .. } = &rendered;
            part.backward(device, scene, plan.side, &output.grad_image, self.gradient)?;
            rendered.read(device, plan)
        };
        device.run_in_pool(|| self.renderer.with_predicted_capacity(scene, plan, work))
    }

    /// A step in several parts, last first.
    fn alone(&self, plans: &[Plan], loss: &mut Option<Loss>) -> Result<Compared> {
        let (device, gradient) = (self.device(), self.gradient);
        let parts = Parts::render(self, plans.iter().rev().collect(), loss)?;
        set_scales(device, None, self.scene, gradient, parts.samples)?;
        let found = parts.back(self, loss, &mut |part, pair_gradient| {
            let vectors = part.backward_fields(device, self.scene, pair_gradient, gradient)?;
            let all = 0..part.bins.cameras.len() as u32;
            part.add_gaussians(device, self.scene, pair_gradient, &vectors, all, gradient)
        })?;
        finish(device, None, gradient)?;
        Ok(found)
    }

    /// A step that ranks share.
    fn together(
        &self,
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        ranks: &dyn Ranks,
    ) -> Result<Compared> {
        let (device, scene, gradient) = (self.device(), self.scene, self.gradient);
        let (units, limits) = self.renderer.units(scene, batch)?;
        let mine: Vec<_> = units.iter().skip(ranks.rank()).step_by(ranks.size()).cloned().collect();
        let plans = limits.join(&mine);
        let parts = Parts::render(self, plans.iter().collect(), loss)?;
        set_scales(device, Some(ranks), scene, gradient, parts.samples)?;
        let mut rows = Rows::new(device, ranks, [gradient])?;
        let found = parts.back(self, loss, &mut |part, pair_gradient| {
            let vectors = part.backward_fields(device, scene, pair_gradient, gradient)?;
            for unit in 0..part.bins.cameras.len() as u32 {
                let cameras = unit..unit + 1;
                part.add_gaussians(device, scene, pair_gradient, &vectors, cameras, gradient)?;
                rows.take(0)?;
            }
            Ok(())
        })?;
        rows.add(units.len())?;
        finish(device, Some(ranks), gradient)?;
        self.all_found(&found, &units, ranks)
    }

    /// Renders a part, and compares it.
    fn render(&self, plan: &Plan, loss: &Loss, capacity: Option<Capacity>) -> Result<Rendered> {
        let (device, target) = (self.device(), self.target);
        let area = (plan.side * plan.side) as usize;
        let mut part = Part::evaluate(device, self.scene, self.cameras, plan, true, capacity)?;
        let image = device.upload("photographs", &of_tiles(target.image, &plan.tiles, 3 * area))?;
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
        part.composite.distortion = target.distortion(&valid);
        let back = |exposed: &Exposed| exposed.backward(device, rendered, &output.grad_image);
        let row_sum = exposed.as_ref().map(back).transpose()?;
        Ok(Rendered { part, output, row_sum })
    }

    /// What all ranks have found, by camera.
    fn all_found(&self, mine: &Compared, units: &[Plan], ranks: &dyn Ranks) -> Result<Compared> {
        let (losses, exposures) = mine;
        let mut exposures = exposures.iter();
        let mut values = Vec::new();
        for loss in losses {
            values.extend(bytemuck::cast::<_, [f64; 4]>(*loss));
            values.extend(exposures.next().iter().flat_map(|found| found.gradient.as_flattened()));
        }
        let all = ranks.gather(bytemuck::cast_slice(&values).to_vec())?;
        let all: Vec<Vec<f64>> =
            all.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect();
        let mut rest: Vec<_> = all.iter().map(|values| values.iter().copied()).collect();
        let (mut losses, mut exposures) = (Vec::new(), Vec::new());
        for (index, unit) in units.iter().enumerate() {
            let of_rank = &mut rest[index % ranks.size()];
            let mut value = || of_rank.next().expect("each rank has all of its units");
            for tile in &unit.tiles {
                losses.push(bytemuck::cast::<_, TileLoss>([(); 4].map(|()| value())));
                if self.target.exposure.is_some() {
                    let gradient = [(); 3].map(|()| [(); 2].map(|()| value()));
                    let (place, camera) = (tile.place, tile.tile.camera);
                    exposures.push(ExposureGradient { place, camera, gradient });
                }
            }
        }
        Ok((losses, exposures))
    }
}

impl Rendered {
    /// Reads what was found, and the capacity that the part needed: waits for the device.
    fn read(&self, device: &Device, plan: &Plan) -> Result<(Compared, Needed)> {
        let row_sum = self.row_sum.as_ref();
        let (losses, rows, needed) = self.output.sums_and_needed(device, &self.part, row_sum)?;
        Ok(((losses, exposure::gradients(&rows, plan.side, &plan.tiles)), needed))
    }
}

/// The parts of a step, after the first of both passes: the second one needs the bounds of all of them.
struct Parts<'a> {
    plans: Vec<&'a Plan>,
    /// `[pairs, 3]` is the gradient of the part's pairs. Parts that are not kept are rendered again.
    kept: Vec<Option<(Part, Buffer<Vec4>)>>,
    /// Of the color and of the transmittance field.
    samples: [i64; 2],
    found: Compared,
}

impl<'a> Parts<'a> {
    /// Renders and compares all parts, and raises the bounds of the hash grids' sums.
    fn render(step: &Step<'_>, plans: Vec<&'a Plan>, loss: &mut Option<Loss>) -> Result<Self> {
        let (mut kept, mut samples) = (Vec::new(), [0; 2]);
        let (mut found, mut keeps) = (Compared::default(), true);
        for &plan in &plans {
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
            found.0.extend(of_part.0);
            found.1.extend(of_part.1);
            let is_kept = keeps && samples.iter().sum::<i64>() as u64 <= KEPT_SAMPLES;
            kept.push(is_kept.then_some(part));
        }
        Ok(Self { plans, kept, samples, found })
    }

    /// Renders and compares a part, and goes back to its pairs.
    fn render_one(
        step: &Step<'_>,
        plan: &Plan,
        loss: &mut Option<Loss>,
    ) -> Result<((Part, Buffer<Vec4>), Compared, Capacity)> {
        let device = step.device();
        let loss = Loss::of_tiles(loss, device, plan.side, plan.tiles.len())?;
        let work = |capacity: Option<Capacity>| {
            let rendered = step.render(plan, loss, capacity)?;
            let Rendered { part, output, .. } = &rendered;
            let pair_gradient =
                part.pair_gradient(device, step.scene, plan.side, &output.grad_image)?;
            let (found, needed) = rendered.read(device, plan)?;
            Ok((((rendered.part, pair_gradient), found, needed), needed))
        };
        let work = || step.renderer.with_predicted_capacity(step.scene, plan, work);
        let (part, found, needed) = device.run_in_pool(work)?;
        let Needed::Capacity(capacity) = needed else { unreachable!("it was rendered again") };
        Ok((part, found, capacity))
    }

    /// Goes back through all parts, with `back`; returns what was found.
    fn back(
        self,
        step: &Step<'_>,
        loss: &mut Option<Loss>,
        back: &mut (dyn FnMut(&Part, &Buffer<Vec4>) -> Result<()> + Send),
    ) -> Result<Compared> {
        for (plan, kept) in self.plans.into_iter().zip(self.kept) {
            let (part, pair_gradient) = match kept {
                Some(kept) => kept,
                None => Self::render_one(step, plan, loss)?.0,
            };
            step.device().run_in_pool(|| back(&part, &pair_gradient))?;
        }
        Ok(self.found)
    }
}
