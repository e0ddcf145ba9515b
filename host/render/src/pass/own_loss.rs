//! Losses that a caller computes, on the host or on the device.

use std::collections::BTreeMap;

use super::part::{Part, TileGradient};
use super::pass::{GoBack, Pass};
use crate::stages::cut::{PartTiles, values_of_tiles};
use crate::{DeviceScene, LossInputs, LossTarget, Renderer, SceneGradient};
use muslin_device::{Buffer, Device};
use organza_core::{Camera, Error, RenderedTiles, Result, TileBatch};

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
    pub grad_tiles: Vec<f32>,
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
    pub grad_tiles: Buffer<f32>,
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
    /// number of values. The gradient is then as it was before.
    pub fn add_own_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        own: &mut OwnLoss<'_>,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
    ) -> Result<(f64, f64)> {
        batch.validate(cameras)?;
        let pass = self.pass(scene, cameras);
        gradient.snapshot(self.device());
        let (loss, squared) = match own {
            OwnLoss::Host(own) => host(&pass, batch, own, target, gradient)?,
            OwnLoss::Device(own) => on_device(&pass, batch, own, target, gradient)?,
        };
        Ok((loss, squared / (3.0 * target.valid_pixels).max(1.0)))
    }
}

/// A loss on the host needs all tiles at once.
fn host(
    pass: &Pass<'_>,
    batch: &TileBatch,
    own: &mut HostLoss<'_>,
    target: &LossTarget<'_>,
    into: &SceneGradient,
) -> Result<(f64, f64)> {
    let mut parts = pass.cut(batch)?;
    let rendered = &pass.forward_tiles(&mut parts, batch, &[], true, &mut |_, _| {})?;
    let LossGradient { loss, grad_tiles } = own(&LossBatch { batch, rendered, target: *target })?;
    check_len(grad_tiles.len(), rendered.data.len())?;
    pass.backward_from(&mut parts, &grad_tiles, into)?;
    let area = (batch.side * batch.side) as usize;
    Ok((loss, squared_error(&rendered.data, target.image, target.valid, area)))
}

/// A loss on the device is evaluated part by part.
fn on_device(
    pass: &Pass<'_>,
    batch: &TileBatch,
    own: &mut DeviceLoss<'_>,
    target: &LossTarget<'_>,
    into: &SceneGradient,
) -> Result<(f64, f64)> {
    let device = pass.renderer.device();
    // by a part's first tile: where memory ends, parts are cut and begin again
    let mut found = BTreeMap::new();
    let of_tiles = |plan: &PartTiles, part: &Part, back: &mut GoBack<'_>| {
        let rendered = &part.composite.image;
        let Some((words, needed)) = part.read(device, vec![rendered.view()])? else {
            return Ok(None);
        };
        let pixels = bytemuck::cast_slice(&words[0]);
        let image = values_of_tiles(target.image, &plan.tiles, 3 * plan.area());
        let valid = values_of_tiles(target.valid, &plan.tiles, plan.area());
        let squared = squared_error(pixels, &image, &valid, plan.area());
        let inputs = LossInputs {
            image: rendered,
            target: &device.upload("photographs", &image)?,
            valid: &device.upload("masks", &valid)?,
            valid_pixels: target.valid_pixels,
            ssim_weight: target.ssim_weight,
        };
        let side = plan.side;
        let DeviceLossGradient { loss, grad_tiles } =
            own(&DeviceLossBatch { device, side, inputs })?;
        check_len(grad_tiles.len(), pixels.len())?;
        back(TileGradient { grad_tiles, distortion: None })?;
        let mut of_part = (loss, squared);
        for tile in &plan.tiles {
            found.insert(tile.place, std::mem::take(&mut of_part));
        }
        Ok(Some(needed))
    };
    let mut parts = pass.cut(batch)?;
    pass.backward(&mut parts, of_tiles, into)?;
    Ok(found.into_values().fold((0.0, 0.0), |sum, found| (sum.0 + found.0, sum.1 + found.1)))
}

fn check_len(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    let reason = format!("the loss returned {found} values of `grad_tiles`, expected {expected}");
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
