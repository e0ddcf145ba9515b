//! One step after the other: draw tiles, render, compare, go back, move, grow.

use std::path::Path;
use std::sync::Arc;

use super::checkpoint::{Checkpoint, Progress};
use super::coarse::{Batches, Drawn};
use super::config::TrainConfig;
use super::exposure::Exposures;
use super::growth::{Grown, grow};
use super::hooks::{StepGradient, StepHooks};
use super::optimizer::Optimizer;
use super::pose::PoseSet;
use super::sampler::Target;
use super::start;
use crate::camera::Camera;
use crate::data::Dataset;
use crate::error::{Error, IN_MEMORY, Result};
use crate::evaluate::{Evaluation, evaluate};
use crate::metrics;
use crate::ranks::Ranks;
use crate::render::{DeviceScene, ExposureGradient, Loss, Renderer, SceneGradient, TileLoss};

/// Why ranks do not train so.
pub(super) const NO_HOOKS: &str =
    "hooks see the whole batch, which ranks share: train without ranks, or without hooks";

/// Trains a scene, step by step. Everything that a step changes stays on the device.
///
/// A trainer needs no folder and writes no file. [`Session`](super::Session) is the loop of the program: it calls a
/// trainer, writes a log, checkpoints and a report, and stops when it is told to.
///
/// ```
/// use organza::train::{TrainConfig, Trainer, built_in};
/// use organza::{DeviceOptions, Renderer};
///
/// let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
/// // four views of the built-in scene, 32 x 32 pixels each; every second one is held out
/// let dataset = built_in::dataset(&renderer, 4, 32, 2)?;
///
/// let mut config = TrainConfig::default();
/// config.run.steps = 3;
/// config.run.tiles_per_step = 2;
/// config.run.tile_size = 16;
/// config.start.gaussians = 100;
///
/// let mut trainer = Trainer::start(&renderer, config, dataset)?;
/// while !trainer.is_finished() {
///     let report = trainer.step()?;
///     println!("step {}: loss {:.4}", trainer.steps(), report.loss);
/// }
/// let evaluation = trainer.evaluate()?;
/// assert_eq!(evaluation.views.len(), 2);
/// assert!(evaluation.mean.psnr.is_some_and(|psnr| psnr > 3.0));
///
/// let scene = trainer.scene().download(renderer.device())?;
/// assert_eq!(scene.gaussians.len(), 100);
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Debug)]
pub struct Trainer {
    renderer: Renderer,
    config: TrainConfig,
    dataset: Arc<Dataset>,
    /// Of the frames to train on; where poses are refined, as they are now.
    cameras: Vec<Camera>,
    batches: Batches,
    loss: Option<Loss>,
    /// Of the photographs to train on, where they are learned.
    exposures: Option<Exposures>,
    /// Of the photographs to train on, where they are refined.
    poses: Option<PoseSet>,
    state: State,
    step: u32,
    /// See [`Trainer::with_ranks`].
    ranks: Option<Arc<dyn Ranks>>,
}

/// What a step changes.
#[derive(Debug)]
struct State {
    scene: DeviceScene,
    optimizer: Optimizer,
    gradient: SceneGradient,
}

/// What a step has measured, before it moved anything.
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
    /// Tiles of the batch.
    pub tiles: usize,
    /// How the Gaussians changed, where they did.
    pub grown: Option<Grown>,
}

impl Trainer {
    /// Starts training: Gaussians are those of `start.path`, or lie at the data set's points, or where its cameras look.
    ///
    /// # Errors
    /// [`Error::Invalid`] where a setting is out of range or no frame is left to train on; as [`Renderer::upload`].
    pub fn start(
        renderer: &Renderer,
        config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
    ) -> Result<Self> {
        let dataset = dataset.into();
        let checkpoint = Checkpoint::begin(start::first_scene(&config, &dataset)?, &config)?;
        Self::resume(renderer, config, dataset, &checkpoint)
    }

    /// Continues from a checkpoint. With [`Checkpoint::begin`], this trains a scene of your own.
    ///
    /// # Errors
    /// As [`Trainer::start`].
    pub fn resume(
        renderer: &Renderer,
        config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
        checkpoint: &Checkpoint,
    ) -> Result<Self> {
        let dataset = dataset.into();
        check(&config, &dataset)?;
        let mut cameras: Vec<_> =
            dataset.train_frames().map(|frame| frame.camera.clone()).collect();
        let batches = Batches::of_cameras(&cameras, &config.run)?;
        let exposures = match config.exposure.learn {
            false => None,
            true => Some(Exposures(checkpoint.exposures_of(cameras.len())?)),
        };
        let poses = match config.poses.refine {
            false => None,
            true => Some(PoseSet::new(checkpoint.poses_of(cameras.len())?, cameras.clone())),
        };
        if let Some(poses) = &poses {
            cameras = poses.cameras();
        }
        let state = State::upload(renderer, &config, checkpoint, cameras.len())?;
        let (renderer, step) = (renderer.clone(), checkpoint.progress.step);
        Ok(Self {
            renderer,
            config,
            dataset,
            cameras,
            batches,
            loss: None,
            exposures,
            poses,
            state,
            step,
            ranks: None,
        })
    }

    /// The same training, shared with other [ranks](crate::ranks). Each rank has a trainer of its own, with the same
    /// settings, data and checkpoint, and takes the same steps. All trainers then hold the same scene, and its bits are
    /// those of a trainer without ranks.
    #[must_use]
    pub fn with_ranks(mut self, ranks: Arc<dyn Ranks>) -> Self {
        self.ranks = Some(ranks);
        self
    }

    /// Steps that are done.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.step
    }

    /// Whether all steps of the settings are done. [`Trainer::step`] can go on all the same.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        self.step >= self.config.run.steps
    }

    /// The settings.
    #[must_use]
    pub fn config(&self) -> &TrainConfig {
        &self.config
    }

    /// From this step on, the run has so many steps: learning rates and growth follow.
    pub(super) fn replan(&mut self, steps: u32) {
        self.config.run.replan(self.step, steps);
    }

    /// The photographs.
    #[must_use]
    pub fn dataset(&self) -> &Arc<Dataset> {
        &self.dataset
    }

    /// The cameras of the frames to train on, in their order; where poses are refined, as they are now.
    #[must_use]
    pub fn cameras(&self) -> &[Camera] {
        &self.cameras
    }

    /// The scene as it is now.
    #[must_use]
    pub fn scene(&self) -> &DeviceScene {
        &self.state.scene
    }

    /// Renders the held-out frames and compares them with their photographs.
    ///
    /// # Errors
    /// As [`evaluate`](crate::evaluate()).
    pub fn evaluate(&self) -> Result<Evaluation> {
        let frames: Vec<_> = self.dataset.held_out_frames().collect();
        evaluate(&self.renderer, &self.state.scene, &frames)
    }

    /// Everything that training needs to go on. `seconds` is the time of training to write down.
    ///
    /// # Errors
    /// As [`Device::read`](crate::Device::read); [`Error::Diverged`] where a gradient was not finite.
    pub fn checkpoint(&self, seconds: f64) -> Result<Checkpoint> {
        let (device, state) = (self.renderer.device(), &self.state);
        state.gradient.check(device)?;
        let statistics = device.read(&state.gradient.statistics)?;
        Ok(Checkpoint {
            scene: state.scene.download(device)?,
            moments: state.optimizer.moments(device, &state.scene)?,
            statistics: statistics.iter().map(|v| v.to_array()).collect(),
            exposures: self.exposures.as_ref().map(|exposures| exposures.0.clone()),
            poses: self.poses.as_ref().map(|poses| poses.learned.clone()),
            progress: Progress { step: self.step, seconds },
        })
    }

    /// One step.
    ///
    /// # Errors
    /// [`Error::Diverged`] where the loss is not finite; [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    /// The trainer is then as before the step.
    pub fn step(&mut self) -> Result<StepReport> {
        self.step_with(&mut StepHooks::new())
    }

    /// Like [`Trainer::step`], with a loss of your own, or with a function between the gradient and Adam.
    ///
    /// # Errors
    /// As [`Trainer::step`], and those of the hooks.
    pub fn step_with(&mut self, hooks: &mut StepHooks<'_>) -> Result<StepReport> {
        let drawn = match hooks.loss {
            // a caller may know photographs by their pixels, and tiles by what renders them
            Some(_) => self.batches.whole(self.step),
            None => self.batches.of_step(&self.config.run, self.step),
        };
        let restart = |trainer: &Self| trainer.state.gradient.restart(trainer.renderer.device());
        let (report, exposures) = self.add_gradient(&drawn, hooks)?;
        report.check(self.step).inspect_err(|_| restart(self))?;
        let device = self.renderer.device();
        let State { scene, optimizer, gradient } = &self.state;
        if let Some(hook) = &mut hooks.gradient {
            let between = StepGradient { device, step: self.step, scene, gradient };
            hook(&between).inspect_err(|_| restart(self))?;
        }
        let share = self.config.run.share(self.step);
        let (settings, now) = (&self.config.optimizer, (self.step, share));
        if let Some(learned) = &mut self.exposures {
            let rate = settings.rate_at(settings.exposure, share);
            let moved = learned.step(&exposures, settings, rate);
            moved.inspect_err(|_| gradient.restart(device))?;
        }
        if let Some(poses) = &mut self.poses {
            let found = gradient.read_poses(device)?;
            let shown = drawn.batch.tiles.iter().map(|tile| tile.camera);
            let rate = settings.rate_at(settings.pose, share);
            let moved = poses.step(&found, shown, settings, rate, scene.extent());
            moved.inspect_err(|_| gradient.restart(device))?;
            gradient.clear_poses(device);
            self.cameras = poses.cameras();
        }
        device.run_in_pool(|| optimizer.step(device, scene, gradient, settings, now))?;
        gradient.clear_touched(device);
        self.step += 1;
        let grows = is_time_to_grow(&self.config, self.step);
        let grown = grows.then(|| self.grow()).transpose()?;
        Ok(StepReport { grown, ..report })
    }

    /// Adds the gradient of a batch's loss; returns what it measured, and the gradients of the exposures.
    fn add_gradient(
        &mut self,
        drawn: &Drawn,
        hooks: &mut StepHooks<'_>,
    ) -> Result<(StepReport, Vec<ExposureGradient>)> {
        self.check_hooks(hooks)?;
        let frames: Vec<_> = self.dataset.train_frames().collect();
        let Drawn { batch, factor, ray_steps } = drawn;
        let target = Target::of(batch, *factor, &frames)?;
        let exposure = self.exposures.as_ref().map(|exposures| exposures.of_tiles(batch));
        let target = target.of_loss(&self.config.loss, exposure.as_deref());
        let State { scene, gradient, .. } = &self.state;
        let scene = &scene.coarser(*factor, *ray_steps);
        let (renderer, cameras) = (&self.renderer, &drawn.cameras(&self.cameras)[..]);
        if let Some(own) = &mut hooks.loss {
            let (loss, squared) =
                renderer.add_own_loss_gradient(scene, cameras, batch, own, &target, gradient)?;
            let (psnr, tiles, none) = (metrics::psnr_of(squared), batch.tiles.len(), f64::NAN);
            let report = StepReport { loss, l1: none, ssim: none, psnr, tiles, grown: None };
            return Ok((report, Vec::new()));
        }
        let (kept, ranks) = (&mut self.loss, self.ranks.as_deref());
        let (losses, exposures) =
            renderer.add_loss_gradient(scene, cameras, batch, kept, &target, gradient, ranks)?;
        Ok((StepReport::of(&losses, target.ssim_weight), exposures))
    }

    /// What hooks cannot be used with.
    fn check_hooks(&self, hooks: &StepHooks<'_>) -> Result<()> {
        let reason = if self.ranks.is_some() && (hooks.loss.is_some() || hooks.gradient.is_some()) {
            NO_HOOKS
        } else if self.exposures.is_some() && hooks.loss.is_some() {
            "a loss of your own does not know the photographs' exposures: set `exposure.learn` to false"
        } else if self.config.loss.distortion_weight > 0.0 && hooks.loss.is_some() {
            "a loss of your own has no term for the distortion: set `loss.distortion_weight` to 0"
        } else {
            return Ok(());
        };
        Err(Error::Argument { reason: reason.to_owned() })
    }

    /// On the host: once in many steps.
    fn grow(&mut self) -> Result<Grown> {
        let mut state = self.checkpoint(0.0)?;
        let [first, second] = &mut state.moments;
        let statistics = std::mem::take(&mut state.statistics);
        let growth = &self.config.growth;
        let grown = grow(growth, &mut state.scene, [first, second], &statistics);
        state.statistics = vec![[0.0; 4]; state.scene.gaussians.len()];
        self.state = State::upload(&self.renderer, &self.config, &state, self.cameras.len())?;
        Ok(grown)
    }
}

impl State {
    /// `photographs` is the number of those to train on.
    fn upload(
        renderer: &Renderer,
        config: &TrainConfig,
        checkpoint: &Checkpoint,
        photographs: usize,
    ) -> Result<Self> {
        let device = renderer.device();
        let mut scene = renderer.upload(&checkpoint.scene)?;
        if !config.ablation.divide {
            scene.divide_above = f32::MAX;
        }
        let optimizer = Optimizer::new(device, &checkpoint.moments)?;
        let mut gradient = SceneGradient::new(device, &scene)?;
        let statistics = checkpoint.statistics.iter().map(|&v| glam::Vec4::from_array(v));
        gradient.statistics = device.upload("statistics", &statistics.collect::<Vec<_>>())?;
        gradient.has_transmittance = config.ablation.learn_transmittance;
        if config.poses.refine {
            gradient = gradient.with_poses(device, photographs)?;
        }
        Ok(Self { scene, optimizer, gradient })
    }
}

impl StepReport {
    /// That of a batch's losses.
    pub(super) fn of(losses: &[TileLoss], ssim_weight: f32) -> Self {
        let total = TileLoss::total(losses);
        let pixels = (3.0 * total.valid).max(1.0);
        Self {
            loss: total.value(ssim_weight),
            // each part of the loss alone
            l1: total.value(0.0),
            ssim: 1.0 - total.value(1.0),
            psnr: metrics::psnr_of(total.squared / pixels),
            tiles: losses.len(),
            grown: None,
        }
    }

    /// Fails where the loss of the step is not finite.
    pub(super) fn check(&self, step: u32) -> Result<()> {
        if self.loss.is_finite() {
            return Ok(());
        }
        let reason = format!("the loss of step {step} is {}", self.loss);
        Err(Error::Diverged { reason })
    }
}

/// Whether the number of Gaussians changes after so many steps.
pub(super) fn is_time_to_grow(config: &TrainConfig, step: u32) -> bool {
    let (growth, share) = (&config.growth, config.run.share(step));
    step.is_multiple_of(growth.every) && (growth.begin..=growth.end).contains(&share)
}

/// Settings that were made in code are held to what files are held to.
pub(super) fn check(config: &TrainConfig, dataset: &Dataset) -> Result<()> {
    let invalid = |reason| Error::Invalid { origin: Path::new(IN_MEMORY).to_owned(), reason };
    config.check().map_err(invalid)?;
    if dataset.train.is_empty() {
        let reason = "the data set has no frame to train on".to_owned();
        return Err(Error::Invalid { origin: dataset.path.clone(), reason });
    }
    Ok(())
}
