//! Measurements of a step.

use super::growth::Grown;
use organza_core::error::{Error, Result};
use organza_core::metrics;
use organza_render::TileLoss;

/// Measurements of a step, from before it changed anything.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct StepReport {
    /// The loss of the batch.
    pub loss: f64,
    /// The mean absolute difference of the batch's values, the first part of the loss; NaN with a loss of your own.
    pub l1: f64,
    /// The mean SSIM of the batch, the second part of the loss; NaN with a loss of your own.
    pub ssim: f64,
    /// The PSNR of the batch's pixels, in decibels.
    pub psnr: f64,
    /// Number of tiles in the batch.
    pub tiles: usize,
    /// Change of the Gaussians, if there was one.
    pub grown: Option<Grown>,
}

impl StepReport {
    /// The report on a batch's losses.
    pub(super) fn new(losses: &[TileLoss], ssim_weight: f32) -> Self {
        let total = TileLoss::total(losses);
        let pixels = (3.0 * total.valid).max(1.0);
        Self {
            loss: total.value(ssim_weight),
            // each part of the loss separately
            l1: total.value(0.0),
            ssim: 1.0 - total.value(1.0),
            psnr: metrics::psnr_of(total.squared / pixels),
            tiles: losses.len(),
            grown: None,
        }
    }

    /// Fails if the loss of the step is not finite.
    pub(super) fn check(&self, step: u32) -> Result<()> {
        if self.loss.is_finite() {
            return Ok(());
        }
        let reason = format!("the loss of step {step} is {}", self.loss);
        Err(Error::Diverged { reason })
    }
}
