//! One step after the other: draw tiles, render, compare, go back, move, grow.

use super::checkpoint::{Checkpoint, Progress};
use super::config::{GrowthMethod, TrainConfig};
use super::growth::{Grown, grow};
use super::optimizer::Optimizer;
use super::sampler::{Sampler, Target, random};
use crate::camera::Camera;
use crate::data::Frame;
use crate::error::{Error, Result};
use crate::metrics;
use crate::render::{DeviceScene, Loss, LossTarget, Renderer, SceneGradient, TileLoss};
use crate::scene::Scene;
use crate::tile::TileBatch;
use organza_device::Device;

const GROWTH: u64 = 4;

/// Trains a scene; everything that changes lies on the device.
#[derive(Debug)]
pub struct Trainer<'a> {
    renderer: &'a Renderer,
    config: &'a TrainConfig,
    frames: Vec<&'a Frame>,
    cameras: Vec<Camera>,
    sampler: Sampler,
    loss: Option<Loss>,
    scene: DeviceScene,
    optimizer: Optimizer,
    gradient: SceneGradient,
    step: u32,
}

/// What a step has measured, before it moved anything.
#[derive(Clone, Copy, Debug)]
pub struct StepReport {
    /// The loss of the batch.
    pub loss: f64,
    /// The PSNR of the batch's pixels, in decibels.
    pub psnr: f64,
    /// Tiles of the batch.
    pub tiles: usize,
    /// How the Gaussians changed, where they did.
    pub grown: Option<Grown>,
}

/// A step's gradient before the optimizer applies it: the argument of a [`GradientHook`].
#[derive(Clone, Copy, Debug)]
pub struct StepGradient<'a> {
    /// The device of the scene and the gradient.
    pub device: &'a Device,
    /// Steps before this one.
    pub step: u32,
    /// The scene that the gradient is of.
    pub scene: &'a DeviceScene,
    /// The gradient of the batch's loss.
    pub gradient: &'a SceneGradient,
}

/// A function between a step's gradient and the optimizer: a regularizer, another optimizer, a sum over processes.
/// Adam uses the gradient that the hook leaves.
///
/// ```no_run
/// use organza::train::{Session, StepGradient};
///
/// # fn example(session: &Session<'_>) -> organza::Result<()> {
/// // keeps materials small: adds 1e-4 times each value to its gradient
/// let mut decay = |step: &StepGradient<'_>| {
///     let values = step.device.read(&step.scene.tensors().gaussians.material)?;
///     let gradient = &step.gradient.tensors().gaussians.material;
///     let mut sum = gradient.read(step.device)?;
///     sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += 1e-4 * value);
///     gradient.write(step.device, &sum)
/// };
/// session.run_with(false, &mut |_| {}, &mut decay)?;
/// # Ok(())
/// # }
/// ```
pub type GradientHook<'h> = dyn FnMut(&StepGradient<'_>) -> Result<()> + 'h;

impl<'a> Trainer<'a> {
    /// Goes on from a checkpoint; [`Trainer::begin`] makes the first.
    ///
    /// # Errors
    /// As [`Renderer::upload`].
    pub fn new(
        renderer: &'a Renderer,
        config: &'a TrainConfig,
        frames: Vec<&'a Frame>,
        checkpoint: &Checkpoint,
    ) -> Result<Self> {
        let device = renderer.device();
        let sizes = frames.iter().map(|frame| [frame.camera.width, frame.camera.height]).collect();
        let sampler = Sampler::new(sizes, &config.run);
        sampler.check_memory()?;
        let mut scene = renderer.upload(&checkpoint.scene)?;
        if !config.ablation.divide {
            scene.divide_above = f32::MAX;
        }
        let optimizer = Optimizer::new(device, &checkpoint.moments)?;
        let gradient = new_gradient(renderer, config, &scene, &checkpoint.statistics)?;
        let cameras = frames.iter().map(|frame| frame.camera.clone()).collect();
        let (step, loss) = (checkpoint.progress.step, None);
        Ok(Self {
            renderer,
            config,
            frames,
            cameras,
            sampler,
            loss,
            scene,
            optimizer,
            gradient,
            step,
        })
    }

    /// The checkpoint before the first step.
    ///
    /// # Errors
    /// As [`Scene::zeros`].
    pub fn begin(mut scene: Scene, config: &TrainConfig) -> Result<Checkpoint> {
        if !config.ablation.learn_transmittance {
            let last = scene.transmittance.network.layers.last_mut().expect("a head");
            last.weight.fill(0.0);
            // log sigmoid(100) is 0 in f32
            last.bias.fill(100.0);
        }
        let zeros = Scene::zeros(scene.config.clone(), scene.gaussians.len())?;
        let statistics = vec![[0.0; 4]; scene.gaussians.len()];
        let progress = Progress::default();
        Ok(Checkpoint { moments: [zeros.clone(), zeros], statistics, scene, progress })
    }

    /// Steps that are done.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.step
    }

    /// The scene as it is now.
    #[must_use]
    pub fn scene(&self) -> &DeviceScene {
        &self.scene
    }

    /// Everything that training needs to go on.
    ///
    /// # Errors
    /// As [`Device::read`](crate::Device::read); [`Error::Diverged`] where a gradient was not finite.
    pub fn checkpoint(&self, seconds: f64) -> Result<Checkpoint> {
        let device = self.renderer.device();
        self.gradient.check(device)?;
        let statistics = device.read(&self.gradient.statistics)?;
        Ok(Checkpoint {
            scene: self.scene.download(device)?,
            moments: self.optimizer.moments(device, &self.scene)?,
            statistics: statistics.iter().map(|v| v.to_array()).collect(),
            progress: Progress { step: self.step, seconds },
        })
    }

    /// One step.
    ///
    /// # Errors
    /// [`Error::Diverged`] where the loss is not finite; [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn step(&mut self) -> Result<StepReport> {
        self.step_with(&mut |_| Ok(()))
    }

    /// Like [`Trainer::step`]; calls `hook` after the backward pass and before Adam.
    ///
    /// # Errors
    /// As [`Trainer::step`], and those of `hook`: the trainer is then as before the step.
    pub fn step_with(&mut self, hook: &mut GradientHook<'_>) -> Result<StepReport> {
        let config = self.config;
        let batch = self.sampler.batch(self.step);
        let losses = self.add_gradient(&batch)?;
        let total = TileLoss::total(&losses);
        let loss = total.value(config.loss.ssim_weight);
        if !loss.is_finite() {
            let reason = format!("the loss of step {} is {loss}", self.step);
            return Err(Error::Diverged { reason });
        }
        let device = self.renderer.device();
        let (optimizer, scene, gradient) = (&self.optimizer, &self.scene, &self.gradient);
        let between = StepGradient { device, step: self.step, scene, gradient };
        hook(&between).inspect_err(|_| gradient.restart(device))?;
        let (settings, steps) = (&config.optimizer, [self.step, config.run.steps]);
        device.run_in_pool(|| optimizer.step(device, scene, gradient, settings, steps))?;
        self.gradient.clear_touched(device);
        self.step += 1;
        let grown = self.is_time_to_grow().then(|| self.grow()).transpose()?;
        let psnr = metrics::psnr_of(total.squared / (3.0 * total.valid).max(1.0));
        Ok(StepReport { loss, psnr, tiles: batch.tiles.len(), grown })
    }

    fn add_gradient(&mut self, batch: &TileBatch) -> Result<Vec<TileLoss>> {
        let target = Target::of(batch, &self.frames)?;
        let target = LossTarget {
            image: &target.image,
            valid: &target.valid,
            valid_pixels: target.valid_pixels,
            ssim_weight: self.config.loss.ssim_weight,
        };
        let (scene, gradient) = (&self.scene, &self.gradient);
        let loss = &mut self.loss;
        self.renderer.add_loss_gradient(scene, &self.cameras, batch, loss, &target, gradient)
    }

    fn is_time_to_grow(&self) -> bool {
        let growth = &self.config.growth;
        let share = f64::from(self.step) / f64::from(self.config.run.steps);
        growth.method != GrowthMethod::None
            && self.step.is_multiple_of(growth.every)
            && (growth.begin..=growth.end).contains(&share)
    }

    /// On the host: once in many steps.
    fn grow(&mut self) -> Result<Grown> {
        let mut state = self.checkpoint(0.0)?;
        let mut random = random(self.config.run.seed, GROWTH, u64::from(self.step));
        let [first, second] = &mut state.moments;
        let statistics = std::mem::take(&mut state.statistics);
        let growth = &self.config.growth;
        let grown = grow(growth, &mut state.scene, [first, second], &statistics, &mut random);
        state.statistics = vec![[0.0; 4]; state.scene.gaussians.len()];
        let frames = std::mem::take(&mut self.frames);
        let next = Self::new(self.renderer, self.config, frames, &state)?;
        let (sampler, loss) =
            (std::mem::replace(&mut self.sampler, next.sampler), self.loss.take());
        (self.scene, self.optimizer, self.gradient) = (next.scene, next.optimizer, next.gradient);
        (self.frames, self.sampler, self.loss) = (next.frames, sampler, loss);
        Ok(grown)
    }
}

fn new_gradient(
    renderer: &Renderer,
    config: &TrainConfig,
    scene: &DeviceScene,
    statistics: &[[f32; 4]],
) -> Result<SceneGradient> {
    let device = renderer.device();
    let mut gradient = SceneGradient::new(device, scene)?;
    let statistics: Vec<_> = statistics.iter().map(|&v| glam::Vec4::from_array(v)).collect();
    gradient.statistics = device.upload("statistics", &statistics)?;
    gradient.has_transmittance = config.ablation.learn_transmittance;
    Ok(gradient)
}
