//! The gradient of a training step whose Gaussians are dealt to ranks.

use super::backward::LossTarget;
use super::device_share::DeviceShare;
use super::loss::{Loss, LossInputs, TileLoss};
use super::renderer::Renderer;
use super::results::RenderedTiles;
use super::share_gradient::ShareGradient;
use crate::camera::Camera;
use crate::error::Result;
use crate::ranks::Ranks;
use crate::tile::TileBatch;

/// Pixels that are compared at once: 200 MiB of memory.
const COMPARED_PIXELS: usize = 1 << 20;

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`, as [`Renderer::add_loss_gradient`] does, together with other
    /// ranks: each has its share of the same scene, and the same batch. Returns the losses of all tiles, in their order,
    /// which every rank computes: all have all pixels.
    ///
    /// # Errors
    /// As [`Renderer::record_share`]; [`Error::Diverged`](crate::Error::Diverged) where a network's gradient is not finite.
    /// The gradient is then as it was before.
    pub(crate) fn add_share_gradient(
        &self,
        (share, ranks): (&DeviceShare, &dyn Ranks),
        cameras: &[Camera],
        batch: &TileBatch,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
        gradient: &ShareGradient,
    ) -> Result<Vec<TileLoss>> {
        let recording = self.record_share(share, cameras, batch, ranks)?;
        let (losses, grad_output) = self.compare(recording.tiles(), loss, target)?;
        let device = self.device();
        gradient.begin(device);
        let added = recording.add(&grad_output, gradient);
        added.inspect_err(|_| gradient.restart(device))?;
        Ok(losses)
    }

    /// The losses of rendered tiles, and dLoss/dY.
    fn compare(
        &self,
        tiles: &RenderedTiles,
        loss: &mut Option<Loss>,
        target: &LossTarget<'_>,
    ) -> Result<(Vec<TileLoss>, Vec<f32>)> {
        let device = self.device();
        let area = (tiles.side * tiles.side) as usize;
        let most = (COMPARED_PIXELS / area).max(1);
        let (mut losses, mut gradient) = (Vec::with_capacity(tiles.count), Vec::new());
        for first in (0..tiles.count).step_by(most) {
            let part = first..tiles.count.min(first + most);
            let loss = Loss::of_tiles(loss, device, tiles.side, part.len())?;
            let values = |of: &[f32], len: usize| of[part.start * len..part.end * len].to_vec();
            let inputs = LossInputs {
                image: &device.upload("rendered tiles", &values(&tiles.data, 3 * area))?,
                target: &device.upload("photographs", &values(target.image, 3 * area))?,
                valid: &device.upload("masks", &values(target.valid, area))?,
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
