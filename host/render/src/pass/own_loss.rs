//! Losses that a caller computes, on the host or on the device.

use std::slice::from_ref;

use super::step::Step;
use crate::pass::part::Part;
use crate::pass::renderer::Renderer;
use crate::scene::device_scene::DeviceScene;
use crate::stages::counts::{Capacity, Needed};
use crate::stages::cut::PartTiles;
use crate::stages::cut::values_of_tiles;
use crate::stages::gradient::SceneGradient;
use crate::stages::loss::LossInputs;
use crate::stages::loss::LossTarget;
use muslin_device::{Buffer, Device};
use organza_core::RenderedTiles;
use organza_core::camera::Camera;
use organza_core::error::{Error, Result};
use organza_core::tile::TileBatch;

/// The tiles of a step, and what they should look like: the argument of a loss on the host.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct LossBatch<'a> {
    /// Where the tiles are; `camera` is an index into the frames that are trained on.
    pub batch: &'a TileBatch,
    /// Y `[K, 3, S, S]`
    pub rendered: &'a RenderedTiles,
    /// The photographs behind the tiles, `[K, 3, S, S]`, and which of their pixels count.
    pub target: LossTarget<'a>,
}

/// The result of a loss on the host.
#[derive(Clone, Debug, PartialEq)]
pub struct LossGradient {
    /// The loss of the batch.
    pub loss: f64,
    /// dL/dY `[K, 3, S, S]`
    pub grad_output: Vec<f32>,
}

/// Tiles on the device, and what they should look like: the argument of a loss on the device.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct DeviceLossBatch<'a> {
    /// The device of the buffers.
    pub device: &'a Device,
    /// S, in pixels.
    pub side: u32,
    /// Y, the photographs behind it, and which pixels count; [`Loss::evaluate`](crate::Loss::evaluate) takes them.
    pub inputs: LossInputs<'a>,
}

/// The result of a loss on the device.
#[derive(Debug)]
pub struct DeviceLossGradient {
    /// The loss of these tiles. The losses of a batch's parts are added.
    pub loss: f64,
    /// dL/dY `[K, 3, S, S]`
    pub grad_image: Buffer<f32>,
}

type HostLoss<'h> = dyn FnMut(&LossBatch<'_>) -> Result<LossGradient> + 'h;
type DeviceLoss<'h> = dyn FnMut(&DeviceLossBatch<'_>) -> Result<DeviceLossGradient> + 'h;

/// A caller's loss, as [`Renderer::add_own_loss_gradient`] takes it.
pub enum OwnLoss<'h> {
    /// A function of the tiles and the photographs on the host.
    Host(Box<HostLoss<'h>>),
    /// A function of the buffers on the device.
    Device(Box<DeviceLoss<'h>>),
}

impl Renderer {
    /// Adds the gradients of a caller's loss to `gradient`, which is that of a step; returns the loss, and the mean
    /// squared error of the valid pixels.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; those of the loss; [`Error::Argument`] where its gradient has another
    /// number of values.
    pub fn add_own_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        own: &mut OwnLoss<'_>,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
    ) -> Result<(f64, f64)> {
        let step = Step { renderer: self, scene, cameras, target, gradient };
        let (loss, squared) = match own {
            OwnLoss::Host(own) => step.host(batch, own)?,
            OwnLoss::Device(own) => {
                gradient.snapshot(self.device());
                self.in_parts(scene, batch, |plans| {
                    let add = |sum: (f64, f64), plan| {
                        let (loss, squared) = step.part(own, plan)?;
                        Ok((sum.0 + loss, sum.1 + squared))
                    };
                    let sum = plans.iter().try_fold((0.0, 0.0), add);
                    sum.inspect_err(|_| gradient.rollback(self.device()))
                })?
            }
        };
        Ok((loss, squared / (3.0 * target.valid_pixels).max(1.0)))
    }
}

impl Step<'_> {
    /// A loss on the host needs all tiles at once.
    fn host(&self, batch: &TileBatch, own: &mut HostLoss<'_>) -> Result<(f64, f64)> {
        let Self { renderer, scene, cameras, target, gradient } = *self;
        let recording = renderer.record(scene, cameras, batch)?;
        let rendered = recording.tiles();
        let LossGradient { loss, grad_output } =
            own(&LossBatch { batch, rendered, target: *target })?;
        check_len(grad_output.len(), rendered.data.len())?;
        recording.add_to(&grad_output, gradient, from_ref(gradient))?;
        let area = (batch.side * batch.side) as usize;
        Ok((loss, squared_error(&rendered.data, target.image, target.valid, area)))
    }

    /// Renders a part, has the loss evaluated, and goes back.
    fn part(&self, own: &mut DeviceLoss<'_>, plan: &PartTiles) -> Result<(f64, f64)> {
        let Self { renderer, scene, cameras, target, gradient } = *self;
        let device = renderer.device();
        let side = plan.side;
        let area = (side * side) as usize;
        let image = values_of_tiles(target.image, &plan.tiles, 3 * area);
        let valid = values_of_tiles(target.valid, &plan.tiles, area);
        let work = |capacity: Option<Capacity>| {
            let evaluate = || Part::evaluate(scene, cameras, plan, true, capacity);
            let part = device.run_in_pool(evaluate)?;
            let (values, needed) = part.read(device, vec![part.composite.image.view()])?;
            if needed == Needed::Overflow {
                return Ok(((0.0, 0.0), needed));
            }
            let pixels = bytemuck::cast_slice(&values[0]);
            let squared = squared_error(pixels, &image, &valid, area);
            let target_image = device.upload("photographs", &image)?;
            let valid = device.upload("masks", &valid)?;
            let inputs = LossInputs {
                image: &part.composite.image,
                target: &target_image,
                valid: &valid,
                valid_pixels: target.valid_pixels,
                ssim_weight: target.ssim_weight,
            };
            let DeviceLossGradient { loss, grad_image } =
                own(&DeviceLossBatch { device, side, inputs })?;
            check_len(grad_image.len(), pixels.len())?;
            device.run_in_pool(|| part.backward(scene, side, &grad_image, gradient))?;
            Ok(((loss, squared), needed))
        };
        renderer.with_predicted_capacity(scene, plan, work)
    }
}

fn check_len(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    let reason = format!("the loss returned {found} values of dL/dY, expected {expected}");
    Err(Error::Argument { reason })
}

/// The sum of squares over the valid pixels and the channels of tiles of `area` pixels.
fn squared_error(rendered: &[f32], image: &[f32], valid: &[f32], area: usize) -> f64 {
    let planes = rendered.chunks_exact(area).zip(image.chunks_exact(area)).enumerate();
    let squares = planes.flat_map(|(plane, (x, y))| {
        let valid = &valid[plane / 3 * area..][..area];
        let pixels = x.iter().zip(y).zip(valid);
        pixels.filter(|(_, valid)| **valid > 0.0).map(|((x, y), _)| f64::from(x - y).powi(2))
    });
    squares.sum()
}
