//! A trainer of ranks: what it has of the scene, and what it does together with the others.

use std::path::Path;
use std::sync::Arc;

use super::binding::Binding;
use super::checkpoint::Checkpoint;
use super::config::TrainConfig;
use super::ranks::{self, Order};
use super::trainer::{Trainer, grid_of};
use crate::evaluate::{Evaluation, Measures, evaluate_shard};
use organza_core::camera::Camera;
use organza_core::error::{Error, Result};
use organza_core::image::Image;
use organza_core::ranks::{Grid, Ranks, ThreadRanks};
use organza_data::{Dataset, Frame};
use organza_render::Renderer;

/// Training with Gaussians that are dealt to ranks.
impl Trainer {
    /// Continues from a checkpoint, of which each of many [ranks](organza_core::ranks) has a shard of the Gaussians,
    /// and all of the fields. All ranks take the same steps. The scene's bits do not depend on the number of ranks.
    /// They are not those of [`Trainer::resume`], which adds the same terms in another order.
    ///
    /// Ranks are in groups of `shards`, which share the views. Each group holds all Gaussians: the checkpoint of rank r
    /// is shard `r % shards`.
    ///
    /// ```
    /// use std::sync::Arc;
    ///
    /// use organza_core::demo;
    /// use organza_core::ranks::{Ranks, ThreadRanks};
    /// use muslin_device::DeviceOptions;
    /// use organza_render::Renderer;
    /// use organza_train::{Checkpoint, TrainConfig, Trainer, built_in};
    ///
    /// let threads = ThreadRanks::new(2).into_iter().map(|ranks| {
    ///     std::thread::spawn(move || {
    ///         let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(Some(1)))?);
    ///         let dataset = built_in::dataset(&renderer, 2, 16, 0)?;
    ///         let mut config = TrainConfig::default();
    ///         (config.run.tiles_per_step, config.run.tile_size) = (1, 16);
    ///         let begin = Checkpoint::begin(demo::scene(), &config)?;
    ///         let shard = begin.shard(ranks.rank(), ranks.size());
    ///         let mut trainer =
    ///             Trainer::resume_shard(&renderer, config, dataset, &shard, Arc::new(ranks), 2)?;
    ///         Ok::<_, organza_core::Error>(trainer.step()?.loss)
    ///     })
    /// });
    /// let losses: Vec<_> = threads.collect::<Vec<_>>().into_iter().map(|thread| thread.join()).collect();
    /// let losses: Result<Vec<_>, _> = losses.into_iter().map(|loss| loss.expect("a rank")).collect();
    /// assert_eq!(losses.as_ref().unwrap()[0], losses.as_ref().unwrap()[1]);
    /// # Ok::<(), organza_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// The same errors as [`Trainer::resume`]; [`Error::Argument`] where ranks cannot learn what the settings ask for,
    /// or where `shards` does not divide their number.
    pub fn resume_shard(
        renderer: &Renderer,
        config: TrainConfig,
        dataset: impl Into<Arc<Dataset>>,
        checkpoint: &Checkpoint,
        ranks: Arc<dyn Ranks>,
        shards: usize,
    ) -> Result<Self> {
        check_shards(&config)?;
        let shards = Grid::new(&*ranks, shards)?.shards;
        let dataset = dataset.into();
        Self::with_ranks_of(renderer, config, dataset, checkpoint, Some((ranks, shards)))
    }

    /// The ranks that hold the whole scene together with this one, if it has a shard.
    #[must_use]
    pub fn group(&self) -> Option<impl Ranks> {
        self.grid().map(Grid::row)
    }

    /// The ranks in their groups, if they split the Gaussians.
    pub(super) fn grid(&self) -> Option<Grid<'_>> {
        grid_of(&self.ranks, self.shards)
    }

    /// The cameras of the frames to train on, if their poses are refined.
    pub(super) fn refined_cameras(&self) -> Option<&[Camera]> {
        self.config.poses.refine.then(|| self.cameras())
    }

    /// What evaluations measure. Where exposures are learned, the scene does not have those of held-out photographs.
    pub(super) fn measures(&self) -> Measures<'static> {
        Measures { fitted: self.exposures.is_some(), lpips: None }
    }

    /// How many views are measured at once.
    pub(super) fn views_at_once(&self) -> usize {
        let ranks = self.ranks.as_ref().filter(|_| self.shards.is_none());
        ranks.map_or(1, |ranks| ranks.size())
    }

    /// Measures as many views from `first` on as can be at once, together with all ranks; rank 0 has them all.
    pub(super) fn measure(
        &self,
        frames: &[&Frame],
        first: usize,
    ) -> Result<Vec<(Evaluation, Image)>> {
        match (self.grid(), &self.ranks) {
            (Some(grid), _) => {
                let frame = frames[first];
                let measures = self.measures();
                let shard = self.shard();
                Ok(vec![evaluate_shard(&self.renderer, shard, frame, measures, &grid.row())?])
            }
            (None, Some(ranks)) => {
                let mine = frames.get(first + ranks.rank());
                let mine = mine.map(|frame| self.measure_whole(frame)).transpose()?;
                ranks::gather_views(&**ranks, mine, &frames[first..])
            }
            (None, None) => self.measure_alone(frames[first]),
        }
    }

    /// Measures a view of the whole scene, as this rank alone.
    pub(super) fn measure_alone(&self, frame: &Frame) -> Result<Vec<(Evaluation, Image)>> {
        Ok(vec![self.measure_whole(frame)?])
    }

    fn measure_whole(&self, frame: &Frame) -> Result<(Evaluation, Image)> {
        let scene = &self.shard().blocks()[0];
        ranks::measure_one(&self.renderer, scene, frame, self.measures())
    }

    /// Calls `f` with the ranks that hold the whole scene together: this one alone, if it has no shard.
    pub(super) fn with_group<R>(&self, f: impl FnOnce(&dyn Ranks) -> R) -> R {
        match self.grid() {
            Some(grid) => f(&grid.row()),
            None => f(&ThreadRanks::alone()),
        }
    }

    /// Writes a checkpoint, as rank 0.
    pub(super) fn save(&self, path: &Path, seconds: f64, binding: &Binding) -> Result<()> {
        if let Some(grid) = self.grid() {
            Order::Save.give(grid.all)?;
        }
        let checkpoint = self.checkpoint(seconds)?;
        self.with_group(|ranks| checkpoint.save_shards(path, Some(binding), ranks))
    }
}

/// Ranks that share the Gaussians do not know the distortion, which is no sum over them.
///
/// # Errors
/// [`Error::Argument`] where the settings ask for it.
pub(super) fn check_shards(config: &TrainConfig) -> Result<()> {
    if config.loss.distortion_weight == 0.0 {
        return Ok(());
    }
    let reason = "ranks that share the Gaussians cannot weigh the distortion: set `loss.distortion_weight` to 0, or share \
                  the views";
    Err(Error::Argument { reason: reason.to_owned() })
}
