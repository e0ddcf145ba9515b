//! One step after the other: draw tiles, render, compare, run the backward pass, update, densify.

mod state;

use std::collections::VecDeque;
use std::sync::Arc;

use super::checkpoint::per_photograph_or_start;
use super::coarse::{Batches, Drawn};
use super::densification::{DensificationStats, densify};
use super::optimizer::Update;
use super::per_photograph::Exposures;
use super::photographs::{ResidentPhotographs, StepPhotographs};
use super::pose::PoseSet;
use super::requirements::check;
use super::sampler::valid_pixels;
use super::start::first_scene;
use crate::evaluate::{Evaluation, evaluate_view, evaluate_with};
use crate::{Checkpoint, Progress, TrainConfig};
use muslin_device::Pending;
use organza_core::ranks::Ranks;
use organza_core::{Camera, Error, Image, Result, metrics};
use organza_data::{Dataset, Frame};
use organza_render::{
    BatchLoss, DeviceScene, LossBatch, LossGradient, LossTarget, OwnLoss, QueuedLoss, Renderer,
    TileLoss,
};
use state::TrainerState;

/// Trains a scene, step by step. Everything that a step changes stays on the device.
///
/// A trainer needs no folder and writes no file. [`Session`](super::Session) is the loop of the program: it calls a
/// trainer, writes a log, checkpoints and a report, and stops when it is told to.
///
/// ```
/// use muslin_device::DeviceOptions;
/// use organza_render::Renderer;
/// use organza_train::{TrainConfig, Trainer, built_in};
///
/// let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
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
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Debug)]
pub struct Trainer {
    pub(super) renderer: Renderer,
    config: TrainConfig,
    dataset: Arc<Dataset>,
    /// The cameras of the frames to train on, with their refined poses.
    cameras: Vec<Camera>,
    /// The photographs to train on that stay on a GPU.
    photographs: Option<ResidentPhotographs>,
    batches: Batches,
    /// The exposures of the photographs to train on, if they are learned.
    exposures: Option<Exposures>,
    /// The poses of the photographs to train on, if they are refined.
    poses: Option<PoseSet>,
    state: TrainerState,
    step: u32,
    /// Steps whose losses the host has not read: see [`Trainer::advance`].
    queued: VecDeque<QueuedStep>,
    /// See [`Trainer::with_ranks`].
    pub(super) ranks: Option<Arc<dyn Ranks>>,
}

impl Trainer {
    /// Starts training: Gaussians come from `start.path`, or lie at the data set's points, or where its cameras
    /// look.
    ///
    /// # Errors
    /// [`Error::Invalid`] where a setting is out of range or no frame is left to train on; as [`Renderer::upload`].
    pub fn start(
        renderer: &Renderer,
        mut config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
    ) -> Result<Self> {
        let dataset = dataset.into();
        config.resolve_sizes(&dataset, renderer.device());
        let (scene, _) = first_scene(&config, &dataset)?;
        let checkpoint = Checkpoint::begin(scene, &config)?;
        Self::resume(renderer, config, dataset, &checkpoint)
    }

    /// Continues from a checkpoint. With [`Checkpoint::begin`], this trains a scene of your own.
    ///
    /// # Errors
    /// The same errors as [`Trainer::start`].
    pub fn resume(
        renderer: &Renderer,
        mut config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
        checkpoint: &Checkpoint,
    ) -> Result<Self> {
        let dataset = dataset.into();
        check(&config, &dataset)?;
        config.resolve_sizes(&dataset, renderer.device());
        if checkpoint.scene.config.placement != dataset.placement {
            let reason = "the scene has other coordinates than the data set: read the data set with \
                          `DatasetOptions::placement` and the scene's `config.placement`";
            return Err(Error::Argument { reason: reason.to_owned() });
        }
        let frames: Vec<_> = dataset.train_frames().collect();
        let mut cameras: Vec<_> = frames.iter().map(|frame| frame.camera.clone()).collect();
        let batches = Batches::new(&frames, &config.run)?;
        let device = renderer.device();
        let count = cameras.len();
        let mut state = TrainerState::new(renderer, &config, checkpoint)?;
        state.scene.set_trained_on(config.data.trained_on(&dataset));
        let mut poses = None;
        if config.poses.refine {
            let learned = per_photograph_or_start(checkpoint.poses.as_ref(), count, "poses")?;
            let refined = PoseSet::new(learned, cameras);
            cameras = refined.cameras();
            poses = Some(refined);
            state.gradient = state.gradient.with_poses(device, count)?;
        }
        let mut exposures = None;
        if config.exposure.learn.decide(&dataset) {
            let found = checkpoint.exposures.as_ref();
            let learned = per_photograph_or_start(found, count, "exposures")?;
            exposures = Some(Exposures::new(device, &learned)?);
            state.gradient = state.gradient.with_exposures(device, count)?;
        }
        // after the scene, which must fit
        let photographs = ResidentPhotographs::new(device, &frames)?;
        let renderer = renderer.clone();
        let step = checkpoint.progress.step;
        Ok(Self {
            renderer,
            config,
            dataset,
            cameras,
            photographs,
            batches,
            exposures,
            poses,
            state,
            step,
            queued: VecDeque::new(),
            ranks: None,
        })
    }

    /// The same training, shared with other [ranks](organza_core::ranks). Each rank has a trainer of its own, with the
    /// same settings, data and checkpoint, and takes the same steps. All trainers then hold the same scene, and its
    /// bits are the same as without ranks.
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

    /// Steps whose losses are known.
    pub(super) fn finished(&self) -> u32 {
        self.step - self.queued.len() as u32
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

    /// Changes the number of all steps of the run. Learning rates and densification follow from this step on.
    pub(super) fn reschedule(&mut self, steps: u32) {
        self.config.run.reschedule(self.step, steps);
    }

    /// The photographs.
    #[must_use]
    pub fn dataset(&self) -> &Arc<Dataset> {
        &self.dataset
    }

    /// The cameras of the frames to train on, in their order, with their refined poses.
    #[must_use]
    pub fn cameras(&self) -> &[Camera] {
        &self.cameras
    }

    /// The cameras of the frames to train on, if their poses are refined.
    pub(super) fn refined_cameras(&self) -> Option<&[Camera]> {
        self.config.poses.refine.then(|| self.cameras())
    }

    /// Whether evaluations also fit colors: if exposures are learned, held-out photographs have no learned exposure.
    pub(super) fn fits_colors(&self) -> bool {
        self.exposures.is_some()
    }

    /// The scene as it is now.
    #[must_use]
    pub fn scene(&self) -> &DeviceScene {
        &self.state.scene
    }

    /// Number of Gaussians that steps have shown since densification last changed them.
    pub(super) fn seen(&self) -> Result<usize> {
        let statistics = self.state.statistics(self.renderer.device())?;
        Ok(statistics.iter().filter(|[_, views, ..]| *views > 0.0).count())
    }

    /// Renders the held-out frames and compares them with their photographs.
    ///
    /// # Errors
    /// The same errors as [`evaluate`](crate::evaluate()).
    pub fn evaluate(&self) -> Result<Evaluation> {
        let frames: Vec<_> = self.dataset.held_out_frames().collect();
        evaluate_with(&self.renderer, self.scene(), &frames, self.fits_colors(), &mut |_| {})
    }

    /// Renders a frame, and compares it with its photograph.
    pub(super) fn measure_one(&self, frame: &Frame) -> Result<(Evaluation, Image)> {
        evaluate_view(frame, self.fits_colors(), &mut |cameras, batch| {
            self.renderer.render(self.scene(), cameras, batch)
        })
    }

    /// Everything that training needs to go on. `seconds` is the time of training to write down.
    ///
    /// # Errors
    /// The same errors as [`Device::read`](muslin_device::Device::read); [`Error::Diverged`] where a gradient was not
    /// finite.
    pub fn checkpoint(&self, seconds: f64) -> Result<Checkpoint> {
        assert!(self.queued.is_empty(), "steps are finished before the scene is saved");
        let device = self.renderer.device();
        let state = &self.state;
        state.gradient.check(device)?;
        Ok(Checkpoint {
            scene: state.scene.download(device)?,
            moments: state.optimizer.moments(device, &state.scene)?,
            statistics: state.statistics(device)?,
            exposures: self.exposures.as_ref().map(|values| values.read(device)).transpose()?,
            poses: self.poses.as_ref().map(|poses| poses.learned.clone()),
            progress: Progress { step: self.step, seconds },
        })
    }

    /// One step.
    ///
    /// # Errors
    /// [`Error::Diverged`] where the loss is not finite;
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory). The trainer is then as before the
    /// step.
    pub fn step(&mut self) -> Result<StepReport> {
        self.waiting_step(None)
    }

    /// Like [`Trainer::step`], with a loss of your own: a function of the rendered tiles Y `[K, 3, S, S]` and of the photographs behind
    /// them. It returns the loss and `grad_tiles`, dL/dY.
    ///
    /// It sees all tiles of a step at once, also other ranks' tiles. If exposures are learned, tiles have the exposure of
    /// their photographs. This is a step with the mean squared error:
    ///
    /// ```
    /// # use muslin_device::DeviceOptions;
    /// # use organza_render::Renderer;
    /// # use organza_train::{TrainConfig, Trainer, built_in};
    /// use organza_render::LossGradient;
    ///
    /// # let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
    /// # let dataset = built_in::dataset(&renderer, 4, 32, 2)?;
    /// # let mut config = TrainConfig::default();
    /// # (config.run.tiles_per_step, config.run.tile_size, config.start.gaussians) = (2, 16, 100);
    /// # let mut trainer = Trainer::start(&renderer, config, dataset)?;
    /// let report = trainer.step_with(|batch| {
    ///     let pairs = batch.rendered.data.iter().zip(batch.target.image);
    ///     let difference: Vec<f32> = pairs.map(|(y, truth)| y - truth).collect();
    ///     let n = difference.len() as f32;
    ///     Ok(LossGradient {
    ///         loss: difference.iter().map(|d| f64::from(d * d / n)).sum(),
    ///         grad_tiles: difference.iter().map(|d| 2.0 * d / n).collect(),
    ///     })
    /// })?;
    /// assert!(report.loss > 0.0 && trainer.steps() == 1);
    /// # Ok::<(), organza_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`Trainer::step`] and of the loss.
    pub fn step_with(
        &mut self,
        loss: impl FnMut(&LossBatch<'_>) -> Result<LossGradient>,
    ) -> Result<StepReport> {
        let mut own: OwnLoss<'_> = Box::new(loss);
        self.waiting_step(Some(&mut own))
    }

    /// A step, with a caller's own loss if there is one. The host waits for its loss.
    pub(super) fn waiting_step(&mut self, own: Option<&mut OwnLoss<'_>>) -> Result<StepReport> {
        self.finish_steps()?;
        let drawn = self.draw(own.is_some());
        let report = self.finished_step(&drawn, own)?;
        self.densify_if_due(report)
    }

    /// Goes on by one step, with a caller's own loss if there is one. Returns the reports of the steps that are finished, in their order.
    ///
    /// On a GPU, steps are queued: the host prepares the next one while the GPU works, and reads the losses of a step `ahead`
    /// steps later. It waits in every step for ranks, poses and an own loss, whose numbers the next step needs, and where
    /// [`Renderer::queue_loss_gradient`] says so. On a CPU, nothing is queued. The bits of the scene are the same.
    ///
    /// # Errors
    /// The same errors as [`Trainer::step_with`].
    pub fn advance(
        &mut self,
        own: Option<&mut OwnLoss<'_>>,
        ahead: usize,
    ) -> Result<Vec<StepReport>> {
        let drawn = self.draw(own.is_some());
        let waits = !self.renderer.device().has_indirect_counts()
            || self.ranks.is_some()
            || self.poses.is_some()
            || own.is_some();
        let queued = if waits { Ok(None) } else { self.queue(&drawn) };
        let mut reports = Vec::new();
        match queued {
            Ok(Some((loss, values))) => {
                self.queued.push_back(QueuedStep { step: self.step, drawn, loss, values });
                self.step += 1;
                let left = if self.is_time_to_densify() { 0 } else { ahead };
                while self.queued.len() > left {
                    self.finish_oldest(&mut reports)?;
                }
            }
            // the waiting step has ways to make room
            Err(error) if !error.is_out_of_memory() => return Err(error),
            Ok(None) | Err(_) => {
                reports = self.finish_steps()?;
                reports.push(self.finished_step(&drawn, own)?);
            }
        }
        if let Some(last) = reports.pop() {
            reports.push(self.densify_if_due(last)?);
        }
        Ok(reports)
    }

    /// Waits for all queued steps, and returns their reports. Call it before you read the scene.
    ///
    /// # Errors
    /// The same errors as [`Trainer::step`].
    pub fn finish_steps(&mut self) -> Result<Vec<StepReport>> {
        let mut reports = Vec::new();
        while !self.queued.is_empty() {
            self.finish_oldest(&mut reports)?;
        }
        Ok(reports)
    }

    /// Waits for the oldest queued step. If it has failed, later ones have done nothing: all are taken again, one by one.
    fn finish_oldest(&mut self, reports: &mut Vec<StepReport>) -> Result<()> {
        let Some(QueuedStep { step, drawn, loss, values }) = self.queued.pop_front() else {
            return Ok(());
        };
        let device = self.renderer.device();
        if let Some(found) = loss.finish(&self.renderer, &device.finish(values)?) {
            reports.push(StepReport::new(step + 1, self.scene().len(), &found));
            return Ok(());
        }
        self.state.gradient.clear_failure(device)?;
        let later: Vec<_> = self.queued.drain(..).map(|queued| queued.drawn).collect();
        self.step = step;
        for drawn in std::iter::once(drawn).chain(later) {
            reports.push(self.finished_step(&drawn, None)?);
        }
        Ok(())
    }

    /// The tiles of the next step.
    fn draw(&mut self, has_own_loss: bool) -> Drawn {
        let frames: Vec<_> = self.dataset.train_frames().collect();
        match has_own_loss {
            // a caller compares with the photographs' own pixels: no step is coarse
            true => self.batches.whole(self.step, &frames),
            false => self.batches.draw(&self.config.run, self.step, &frames),
        }
    }

    /// Takes a step with these tiles. The host waits for its loss.
    fn finished_step(
        &mut self,
        drawn: &Drawn,
        own: Option<&mut OwnLoss<'_>>,
    ) -> Result<StepReport> {
        self.state.set_transmittance(self.config.learns_transmittance(self.step));
        let report = self.add_gradient(drawn, own)?;
        let device = self.renderer.device();
        let TrainerState { scene, gradient, .. } = &self.state;
        report.check(self.step).inspect_err(|_| gradient.rollback(device))?;
        let done = self.config.run.fraction(self.step);
        let settings = &self.config.optimizer;
        if let Some(poses) = &mut self.poses {
            let found = gradient.read_poses(device)?;
            let shown = drawn.batch.tiles.iter().map(|tile| tile.camera);
            let rate = settings.rate_at(settings.pose, done);
            let moved = poses.step(&found, shown, settings, rate, scene.extent());
            moved.inspect_err(|_| gradient.rollback(device))?;
            gradient.clear_poses(device);
            self.cameras = poses.cameras();
        }
        self.optimize(drawn)?;
        // a GPU moves the scene while the host draws the next tiles
        self.renderer.device().submit();
        self.step += 1;
        Ok(report)
    }

    /// Queues a step, whose loss the host reads later. `None`, with nothing queued, where it must wait.
    fn queue(&mut self, drawn: &Drawn) -> Result<Option<(QueuedLoss, Pending)>> {
        self.state.set_transmittance(self.config.learns_transmittance(self.step));
        let device = self.renderer.device();
        let TrainerState { scene, gradient, .. } = &self.state;
        let loss = self.with_target(drawn, &mut |target| {
            let cameras = &drawn.cameras(&self.cameras);
            let scene = &drawn.scene(scene);
            self.renderer.queue_loss_gradient(scene, cameras, &drawn.batch, target, gradient)
        })?;
        let Some(loss) = loss else { return Ok(None) };
        self.optimize(drawn)?;
        let values = device.read_later(loss.buffers())?;
        Ok(Some((loss, values)))
    }

    /// Moves the scene, and the exposures of a step's photographs, by their gradients, which are zero afterward.
    fn optimize(&self, drawn: &Drawn) -> Result<()> {
        let device = self.renderer.device();
        let TrainerState { scene, optimizer, gradient } = &self.state;
        let done = self.config.run.fraction(self.step);
        let settings = &self.config.optimizer;
        let exposures = self.exposures.as_ref();
        let step = self.step;
        let moved = device.run_in_pool(|| {
            if let Some(exposures) = exposures {
                let adam = optimizer.adam(device, settings, gradient);
                let rate = settings.rate_at(settings.exposure, done);
                exposures.step(&adam, &drawn.batch, Update::new(settings, rate, step))?;
            }
            optimizer.step(device, scene, gradient, settings, (step, done))?;
            gradient.clear_touched(device);
            scene.update_occupancy(device)
        });
        moved.inspect_err(|_| gradient.rollback(device))
    }

    /// Calls `use_target` with the ground truth of a step's tiles.
    fn with_target<T>(
        &self,
        drawn: &Drawn,
        use_target: &mut dyn FnMut(&LossTarget<'_>) -> Result<T>,
    ) -> Result<T> {
        let frames: Vec<_> = self.dataset.train_frames().collect();
        let Drawn { batch, factor, .. } = drawn;
        let factor = *factor;
        let resident = self.photographs.as_ref();
        use_target(&LossTarget {
            photographs: &StepPhotographs { resident, frames: &frames, batch, factor },
            valid_pixels: valid_pixels(batch, factor, &frames) as f64,
            ssim_weight: self.config.loss.ssim_weight,
            exposure: self.exposures.as_ref().map(|exposures| &exposures.values),
        })
    }

    /// Adds the gradient of a batch's loss. Returns the measurements.
    fn add_gradient(&self, drawn: &Drawn, mut own: Option<&mut OwnLoss<'_>>) -> Result<StepReport> {
        let TrainerState { scene, gradient, .. } = &self.state;
        let cameras = &drawn.cameras(&self.cameras);
        let scene = &drawn.scene(scene);
        let ranks = self.ranks.as_deref();
        let found = self.with_target(drawn, &mut |target| {
            let own = own.as_deref_mut();
            let batch = &drawn.batch;
            self.renderer.add_loss_gradient(scene, cameras, batch, target, own, gradient, ranks)
        })?;
        Ok(StepReport::new(self.step + 1, self.scene().len(), &found))
    }

    /// The report of the last step, with the change of the Gaussians if it is time for one.
    fn densify_if_due(&mut self, report: StepReport) -> Result<StepReport> {
        let is_due = report.step == self.step && self.is_time_to_densify();
        let densified = is_due.then(|| self.densify()).transpose()?;
        Ok(StepReport { densified, gaussians: self.scene().len(), ..report })
    }

    /// Whether the number of Gaussians changes after this step.
    fn is_time_to_densify(&self) -> bool {
        let densification = &self.config.densification;
        let done = self.config.run.fraction(self.step);
        let is_in_time = (densification.begin..=densification.end).contains(&done);
        self.step.is_multiple_of(densification.every) && is_in_time
    }

    /// Densifies on the host, which happens once in many steps.
    fn densify(&mut self) -> Result<DensificationStats> {
        let device = self.renderer.device();
        let mut population = self.state.population(device)?;
        let densified = densify(&self.config.densification, &mut population);
        self.state.replace_gaussians(device, &population)?;
        Ok(densified)
    }
}

/// Measurements of a step, from before it changed anything.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct StepReport {
    /// Steps that are done, with this one.
    pub step: u32,
    /// Number of Gaussians afterward.
    pub gaussians: usize,
    /// The loss of the batch.
    pub loss: f64,
    /// The mean absolute difference of the batch's values, the first part of the loss of the settings.
    pub l1: f64,
    /// The mean SSIM of the batch, the second part of the loss of the settings.
    pub ssim: f64,
    /// The PSNR of the batch's pixels, in decibels.
    pub psnr: f64,
    /// Number of tiles in the batch.
    pub tiles: usize,
    /// Change of the Gaussians, if there was one.
    pub densified: Option<DensificationStats>,
}

impl StepReport {
    /// The report on a batch's loss.
    fn new(step: u32, gaussians: usize, found: &BatchLoss) -> Self {
        let total = TileLoss::total(&found.tiles);
        let pixels = (3.0 * total.valid).max(1.0);
        Self {
            step,
            gaussians,
            loss: found.loss,
            // each part of the loss separately
            l1: total.value(0.0),
            ssim: 1.0 - total.value(1.0),
            psnr: metrics::psnr_of(total.squared / pixels),
            tiles: found.tiles.len(),
            densified: None,
        }
    }

    /// Fails if the loss of the step is not finite.
    fn check(&self, step: u32) -> Result<()> {
        if self.loss.is_finite() {
            return Ok(());
        }
        let reason = format!("the loss of step {step} is {}", self.loss);
        Err(Error::Diverged { reason })
    }
}

/// A step on a GPU whose loss the host has not read.
#[derive(Debug)]
struct QueuedStep {
    /// Steps before it.
    step: u32,
    /// To take it again, if it has failed.
    drawn: Drawn,
    loss: QueuedLoss,
    values: Pending,
}
