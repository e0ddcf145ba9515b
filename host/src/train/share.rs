//! Training with Gaussians that are dealt to ranks: scenes that one machine does not hold.

use std::sync::Arc;

use super::checkpoint::{Checkpoint, Progress};
use super::coarse::{Batches, Drawn};
use super::config::TrainConfig;
use super::optimizer::ShareOptimizer;
use super::sampler::Target;
use super::share_checkpoint::CheckpointShare;
use super::share_growth::grow;
use super::trainer::{StepReport, check, is_time_to_grow};
use crate::camera::Camera;
use crate::data::Dataset;
use crate::error::{Error, Result};
use crate::ranks::{Grid, Ranks};
use crate::render::{DeviceShare, Loss, Renderer, ShareGradient, UploadOptions};

/// A [`Trainer`](super::Trainer) for one of many [ranks](crate::ranks) that hold a share of the Gaussians each, and all of
/// the fields. All ranks take the same steps. The scene's bits do not depend on the number of ranks. They are others than
/// those of a [`Trainer`](super::Trainer), which adds the same terms in another order.
///
/// ```
/// use std::sync::Arc;
///
/// use organza::ranks::{Ranks, ThreadRanks};
/// use organza::train::{Checkpoint, CheckpointShare, ShareTrainer, TrainConfig, built_in};
/// use organza::{DeviceOptions, Renderer, demo};
///
/// let threads = ThreadRanks::new(2).into_iter().map(|ranks| {
///     std::thread::spawn(move || {
///         let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(Some(1)))?);
///         let dataset = built_in::dataset(&renderer, 2, 16, 0)?;
///         let mut config = TrainConfig::default();
///         (config.run.tiles_per_step, config.run.tile_size) = (1, 16);
///         let begin = Checkpoint::begin(demo::scene(), &config)?;
///         let share = CheckpointShare::of(&begin, ranks.rank(), ranks.size());
///         let mut trainer =
///             ShareTrainer::resume(&renderer, config, dataset, &share, Arc::new(ranks))?;
///         Ok::<_, organza::Error>(trainer.step()?.loss)
///     })
/// });
/// let losses: Vec<_> = threads.collect::<Vec<_>>().into_iter().map(|thread| thread.join()).collect();
/// let losses: Result<Vec<_>, _> = losses.into_iter().map(|loss| loss.expect("a rank")).collect();
/// assert_eq!(losses.as_ref().unwrap()[0], losses.as_ref().unwrap()[1]);
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Debug)]
pub struct ShareTrainer {
    renderer: Renderer,
    config: TrainConfig,
    dataset: Arc<Dataset>,
    /// Of the frames to train on.
    cameras: Vec<Camera>,
    batches: Batches,
    loss: Option<Loss>,
    state: State,
    step: u32,
    ranks: Arc<dyn Ranks>,
    /// See [`ShareTrainer::with_shares`].
    shares: usize,
}

/// What a step changes.
#[derive(Debug)]
struct State {
    share: DeviceShare,
    optimizer: ShareOptimizer,
    gradient: ShareGradient,
    /// Gaussians of the whole scene.
    gaussians: usize,
}

impl ShareTrainer {
    /// Continues from a checkpoint, of which each rank has its share.
    ///
    /// # Errors
    /// As [`Trainer::resume`](super::Trainer::resume); [`Error::Argument`] where ranks cannot learn what the settings ask for.
    pub fn resume(
        renderer: &Renderer,
        config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
        checkpoint: &CheckpointShare,
        ranks: Arc<dyn Ranks>,
    ) -> Result<Self> {
        let dataset = dataset.into();
        check(&config, &dataset)?;
        check_shares(&config)?;
        let cameras: Vec<_> = dataset.train_frames().map(|frame| frame.camera.clone()).collect();
        let batches = Batches::of_cameras(&cameras, &config.run)?;
        let state = State::upload(renderer, &config, checkpoint)?;
        let (renderer, step, loss) = (renderer.clone(), checkpoint.state.progress.step, None);
        let shares = ranks.size();
        Ok(Self { renderer, config, dataset, cameras, batches, loss, state, step, ranks, shares })
    }

    /// The same training by groups of so many ranks, which share the views. Each group holds all Gaussians: the checkpoint of
    /// rank r is share `r % shares` of so many.
    ///
    /// # Errors
    /// [`Error::Argument`] where this does not divide the number of ranks.
    pub fn with_shares(mut self, shares: usize) -> Result<Self> {
        self.shares = Grid::new(&*self.ranks, shares)?.shares;
        Ok(self)
    }

    /// Steps that are done.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.step
    }

    /// The settings.
    #[must_use]
    pub fn config(&self) -> &TrainConfig {
        &self.config
    }

    /// As [`Trainer::replan`](super::Trainer).
    pub(super) fn replan(&mut self, steps: u32) {
        self.config.run.replan(self.step, steps);
    }

    /// This rank's share as it is now.
    #[must_use]
    pub fn share(&self) -> &DeviceShare {
        &self.state.share
    }

    /// The ranks, in their groups.
    pub(super) fn grid(&self) -> Grid<'_> {
        Grid { all: &*self.ranks, shares: self.shares }
    }

    /// The ranks of this rank's group, which hold the whole scene together.
    #[must_use]
    pub fn group(&self) -> impl Ranks {
        self.grid().row()
    }

    /// Gaussians of the whole scene.
    #[must_use]
    pub fn gaussians(&self) -> usize {
        self.state.gaussians
    }

    /// This rank's part of everything that training needs to go on. `seconds` is the time of training to write down.
    ///
    /// # Errors
    /// As [`Trainer::checkpoint`](super::Trainer::checkpoint).
    pub fn checkpoint(&self, seconds: f64) -> Result<CheckpointShare> {
        let (device, state) = (self.renderer.device(), &self.state);
        state.gradient.check(device)?;
        let mut statistics = Vec::with_capacity(state.share.len());
        for slice in &state.gradient.slices {
            statistics.extend(device.read(&slice.statistics)?.iter().map(|v| v.to_array()));
        }
        let scene = state.share.download(device)?;
        let moments = state.optimizer.moments(device, &state.share)?;
        let progress = Progress { step: self.step, seconds };
        let checkpoint = Checkpoint::of_scene(scene, moments, statistics, progress);
        let (share, shares) = (self.grid().share(), self.shares);
        Ok(CheckpointShare::of_state(checkpoint, state.gaussians, share, shares))
    }

    /// One step, with all other ranks.
    ///
    /// # Errors
    /// As [`Trainer::step`](super::Trainer::step), and [`Error::Rank`](crate::Error::Rank) where another rank has failed. The trainer is then as
    /// before the step, unless it was growing.
    pub fn step(&mut self) -> Result<StepReport> {
        let drawn = self.batches.of_step(&self.config.run, self.step);
        let Drawn { batch, factor, ray_steps } = &drawn;
        let frames: Vec<_> = self.dataset.train_frames().collect();
        let target = Target::of(batch, *factor, &frames)?;
        let target = target.of_loss(&self.config.loss, None);
        let State { share, optimizer, gradient, .. } = &self.state;
        let grid = Grid { all: &*self.ranks, shares: self.shares };
        let seen = &share.coarser(*factor, *ray_steps);
        let (shared, cameras, kept) = ((seen, grid), drawn.cameras(&self.cameras), &mut self.loss);
        let losses =
            self.renderer.add_share_gradient(shared, &cameras, batch, kept, &target, gradient)?;
        let report = StepReport::of(&losses, target.ssim_weight);
        let device = self.renderer.device();
        report.check(self.step).inspect_err(|_| gradient.restart(device))?;
        let now = (self.step, self.config.run.share(self.step));
        let settings = &self.config.optimizer;
        device.run_in_pool(|| optimizer.step(device, share, gradient, settings, now))?;
        gradient.clear_touched(device);
        self.step += 1;
        let grows = is_time_to_grow(&self.config, self.step);
        let grown = grows.then(|| self.grow()).transpose()?;
        Ok(StepReport { grown, ..report })
    }

    fn grow(&mut self) -> Result<super::Grown> {
        let mut checkpoint = self.checkpoint(0.0)?;
        let grown = grow(&self.config.growth, &mut checkpoint, &self.grid().row())?;
        self.state.replace_gaussians(&self.renderer, &checkpoint)?;
        Ok(grown)
    }
}

/// Ranks that share the Gaussians learn the scene alone.
///
/// # Errors
/// [`Error::Argument`] where the settings ask for more.
pub(super) fn check_shares(config: &TrainConfig) -> Result<()> {
    let [what, setting] = if config.exposure.learn {
        ["learn exposures", "exposure.learn` to false"]
    } else if config.poses.refine {
        ["refine poses", "poses.refine` to false"]
    } else if config.loss.distortion_weight > 0.0 {
        ["weigh the distortion", "loss.distortion_weight` to 0"]
    } else {
        return Ok(());
    };
    let reason =
        format!("ranks that share the Gaussians cannot {what}: set `{setting}, or share the views");
    Err(Error::Argument { reason })
}

impl State {
    fn upload(
        renderer: &Renderer,
        config: &TrainConfig,
        checkpoint: &CheckpointShare,
    ) -> Result<Self> {
        let device = renderer.device();
        let (state, gaussians) = (&checkpoint.state, checkpoint.gaussians);
        let options = UploadOptions::default();
        let mut share = DeviceShare::upload(renderer, &state.scene, gaussians, options)?;
        if !config.ablation.divide {
            share.never_divide();
        }
        let optimizer = ShareOptimizer::new(device, &state.moments)?;
        let gradient = ShareGradient::new(device, &share, config.ablation.learn_transmittance)?;
        let state = Self { share, optimizer, gradient, gaussians };
        state.write_statistics(renderer, &checkpoint.state.statistics)?;
        Ok(state)
    }

    /// The Gaussians are those of a checkpoint from now on; the fields stay.
    fn replace_gaussians(
        &mut self,
        renderer: &Renderer,
        checkpoint: &CheckpointShare,
    ) -> Result<()> {
        let (device, state) = (renderer.device(), &checkpoint.state);
        self.gaussians = checkpoint.gaussians;
        self.share.replace_gaussians(device, &state.scene.gaussians, self.gaussians)?;
        self.optimizer.replace_slices(device, &state.moments)?;
        self.gradient.replace_slices(device, &self.share)?;
        self.write_statistics(renderer, &state.statistics)
    }

    fn write_statistics(&self, renderer: &Renderer, statistics: &[[f32; 4]]) -> Result<()> {
        let mut rest = statistics;
        for slice in &self.gradient.slices {
            let (mine, after) = rest.split_at(slice.statistics.len());
            let mine: Vec<_> = mine.iter().map(|&v| glam::Vec4::from_array(v)).collect();
            renderer.device().write(&slice.statistics, 0, &mine)?;
            rest = after;
        }
        Ok(())
    }
}
