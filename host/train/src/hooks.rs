//! Functions of the caller in a step: a loss, and a function between the gradient and the optimizer.

use std::fmt;

use muslin_device::Device;
use organza_core::error::Result;
use organza_render::{DeviceScene, LossBatch, LossGradient, OwnLoss, SceneGradient};

/// Functions that [`Trainer::step_with`](super::Trainer::step_with) calls. By default there are none: the settings
/// give the loss, and Adam uses its gradient unchanged. Ranks that share a training have the same hooks.
///
/// This trains with the mean squared error, and keeps materials small:
///
/// ```
/// # use muslin_device::DeviceOptions;
/// # use organza_render::Renderer;
/// # use organza_train::{TrainConfig, Trainer, built_in};
/// use organza_render::LossGradient;
/// use organza_train::StepHooks;
///
/// # let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
/// # let dataset = built_in::dataset(&renderer, 4, 32, 2)?;
/// # let mut config = TrainConfig::default();
/// # (config.run.tiles_per_step, config.run.tile_size, config.start.gaussians) = (2, 16, 100);
/// # let mut trainer = Trainer::start(&renderer, config, dataset)?;
/// let mut hooks = StepHooks::new()
///     .loss(|batch| {
///         // Y and the photographs, both [K, 3, S, S]
///         let (y, truth) = (&batch.rendered.data, batch.target.image);
///         let difference: Vec<f32> = y.iter().zip(truth).map(|(y, t)| y - t).collect();
///         let n = y.len() as f32;
///         Ok(LossGradient {
///             loss: difference.iter().map(|d| f64::from(d * d / n)).sum(),
///             grad_tiles: difference.iter().map(|d| 2.0 * d / n).collect(), // dL/dY
///         })
///     })
///     .gradient(|step| {
///         // adds 1e-4 times each value to its gradient
///         let values = step.device.read(&step.scene.tensors().gaussians.material)?;
///         let gradient = &step.gradient.tensors().gaussians.material;
///         let mut sum = gradient.read(step.device)?;
///         sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += 1e-4 * value);
///         gradient.write(step.device, &sum)
///     });
/// let report = trainer.step_with(&mut hooks)?;
/// assert!(report.loss > 0.0 && trainer.steps() == 1);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Default)]
pub struct StepHooks<'h> {
    pub(super) loss: Option<OwnLoss<'h>>,
    pub(super) gradient: Option<Box<GradientHook<'h>>>,
}

/// A function between a step's gradient and the optimizer: a regularizer, another optimizer, or a sum over processes.
/// Adam uses the gradient that the hook leaves.
pub type GradientHook<'h> = dyn FnMut(&StepGradient<'_>) -> Result<()> + 'h;

/// A step's gradient before the optimizer applies it: the argument of a [`GradientHook`].
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct StepGradient<'a> {
    /// The device of the scene and the gradient.
    pub device: &'a Device,
    /// Number of steps before this one.
    pub step: u32,
    /// The scene at this step.
    pub scene: &'a DeviceScene,
    /// The gradient of the batch's loss. It has no gradient of T in steps that do not train T
    /// (`optimizer.transmittance_every`).
    pub gradient: &'a SceneGradient,
}

impl<'h> StepHooks<'h> {
    /// No hooks.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets a loss: a function of the rendered tiles Y `[K, 3, S, S]` and of the photographs behind them.
    /// It returns the loss and `grad_tiles`, dL/dY.
    ///
    /// It sees all tiles of a step at once, also other ranks' tiles. If exposures are learned, tiles have the exposure of
    /// their photographs.
    #[must_use]
    pub fn loss(mut self, loss: impl FnMut(&LossBatch<'_>) -> Result<LossGradient> + 'h) -> Self {
        self.loss = Some(Box::new(loss));
        self
    }

    /// Sets a function that reads or changes the gradient, after the backward pass and before Adam.
    #[must_use]
    pub fn gradient(mut self, hook: impl FnMut(&StepGradient<'_>) -> Result<()> + 'h) -> Self {
        self.gradient = Some(Box::new(hook));
        self
    }
}

impl fmt::Debug for StepHooks<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("StepHooks")
            .field("loss", &self.loss.is_some())
            .field("gradient", &self.gradient.is_some())
            .finish()
    }
}
