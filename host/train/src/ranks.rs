//! A run that ranks share: rank 0 leads it, reads and writes its files, and sends the others what comes next.

use std::path::Path;
use std::sync::Arc;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::held_out;
use crate::evaluate::{Evaluation, Score, ViewScore, evaluate_view};
use crate::{Binding, Checkpoint, TrainConfig, Trainer};
use organza_core::error::{Error, IN_MEMORY, Result};
use organza_core::ranks::{self, Grid, Ranks, ThreadRanks};
use organza_core::{Camera, Image};
use organza_data::{Dataset, Frame};
use organza_render::Renderer;

/// The ranks that share a training.
#[derive(Clone, Debug)]
pub(super) struct Team {
    pub ranks: Arc<dyn Ranks>,
    /// The shards that each group of ranks has of the Gaussians; none where each rank has the whole scene.
    pub shards: Option<usize>,
}

impl Team {
    /// Checks that the ranks can share the Gaussians in this number of shards, if they share them.
    ///
    /// # Errors
    /// [`Error::Argument`] where the settings ask for the distortion, which is no sum over shards, or where the number
    /// of shards does not divide that of the ranks.
    pub fn new(config: &TrainConfig, ranks: Arc<dyn Ranks>, shards: Option<usize>) -> Result<Self> {
        if shards.is_some() && config.loss.distortion_weight != 0.0 {
            let reason = "ranks that share the Gaussians cannot weigh the distortion: set `loss.distortion_weight` \
                          to 0, or share the views";
            return Err(Error::Argument { reason: reason.to_owned() });
        }
        Grid::new(&*ranks, shards.unwrap_or(1))?;
        Ok(Self { ranks, shards })
    }

    /// The ranks in groups that have the whole scene together.
    pub fn grid(&self) -> Grid<'_> {
        Grid { all: &*self.ranks, shards: self.shards.unwrap_or(1) }
    }
}

/// The next action of all ranks, which rank 0 chooses.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) enum Order {
    /// A step, and the number of steps of the run.
    Step(u32),
    /// Each rank measures one held-out view, from `first` on: of all views, or of those of intermediate evaluations.
    Evaluate { first: usize, all: bool },
    /// Hand over the shard for a checkpoint.
    Save,
    /// Nothing more.
    End,
}

/// Sends a value to the other ranks, from rank 0.
pub(super) fn tell(ranks: &dyn Ranks, value: &impl Serialize) -> Result<()> {
    let bytes = serde_json::to_vec(value);
    let bytes = bytes.map_err(|error| Error::Argument { reason: error.to_string() })?;
    ranks.broadcast(bytes).map(drop)
}

/// The value that rank 0 [tells](tell).
pub(super) fn hear<T: DeserializeOwned>(ranks: &dyn Ranks) -> Result<T> {
    serde_json::from_slice(&ranks.broadcast(Vec::new())?)
        .map_err(|error| Error::Argument { reason: format!("rank 0 has sent {error}") })
}

/// [Checks](organza_core::ranks::check_agreement) that all ranks have read the same photographs.
fn check_photographs(
    ranks: &dyn Ranks,
    renderer: &Renderer,
    dataset: &Dataset,
    mixed: bool,
) -> Result<()> {
    let photographs = serde_json::to_string(&dataset.fingerprint).unwrap_or_default();
    ranks::check_agreement(
        ranks,
        renderer.device(),
        crate::COMMIT.unwrap_or_default(),
        ("photographs", &photographs),
        mixed,
    )
}

/// Sends the other ranks the settings, and each its shard, or the whole scene. `mine` is the shard of rank 0, and `shard`
/// makes or reads any.
pub(super) fn lead(
    team: &Team,
    renderer: &Renderer,
    (config, dataset): (&TrainConfig, &Dataset),
    mine: &mut Checkpoint,
    shard: impl Fn(usize) -> Result<Checkpoint>,
    mixed: bool,
) -> Result<()> {
    let ranks = &*team.ranks;
    check_photographs(ranks, renderer, dataset, mixed)?;
    tell(ranks, &(team.shards, config.to_toml()))?;
    mine.send_to_ranks(team.grid(), shard)
}

/// Takes part in the run of a [`Session`](super::Session) of rank 0 that has these ranks, to its end. The photographs
/// must be those of the session; its settings and its scene come from there. `mixed` is that of the session.
///
/// # Errors
/// The same errors as [`Session::run`](super::Session::run); [`Error::Rank`](organza_core::Error::Rank) where another
/// rank has failed. The caller then [tells](Ranks::fail) the others.
pub fn follow(
    renderer: &Renderer,
    dataset: &Arc<Dataset>,
    ranks: &Arc<dyn Ranks>,
    mixed: bool,
) -> Result<()> {
    check_photographs(&**ranks, renderer, dataset, mixed)?;
    let (shards, text): (_, String) = hear(&**ranks)?;
    let config = TrainConfig::parse(&text, IN_MEMORY.as_ref())?;
    let team = Team::new(&config, ranks.clone(), shards)?;
    let checkpoint = Checkpoint::receive(team.grid())?;
    let dataset_of = dataset.clone();
    let mut trainer = Trainer::with_team(renderer, config, dataset_of, &checkpoint, Some(team))?;
    drop(checkpoint);
    loop {
        match hear(&**ranks)? {
            Order::Step(steps) => {
                if steps != trainer.config().run.steps {
                    trainer.replan(steps);
                }
                trainer.step()?;
            }
            Order::Evaluate { first, all } => {
                let frames = held_out::frames(dataset, trainer.config().run.evaluate_views, all);
                trainer.measure(&frames, first)?;
            }
            Order::Save => {
                let checkpoint = trainer.checkpoint(0.0)?;
                trainer.with_group(|ranks| checkpoint.hand_over(ranks))?;
            }
            Order::End => return Ok(()),
        }
    }
}

/// What a trainer does together with the others.
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
    /// let losses = ThreadRanks::run(2, |ranks| {
    ///     let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(Some(1)))?);
    ///     let dataset = built_in::dataset(&renderer, 2, 16, 0)?;
    ///     let mut config = TrainConfig::default();
    ///     (config.run.tiles_per_step, config.run.tile_size) = (1, 16);
    ///     let begin = Checkpoint::begin(demo::scene(), &config)?;
    ///     let shard = begin.shard(ranks.rank(), ranks.size());
    ///     let mut trainer =
    ///         Trainer::resume_shard(&renderer, config, dataset, &shard, Arc::new(ranks), 2)?;
    ///     Ok::<_, organza_core::Error>(trainer.step()?.loss)
    /// });
    /// let losses = losses.into_iter().collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!(losses[0], losses[1]);
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
        let team = Team::new(&config, ranks, Some(shards))?;
        Self::with_team(renderer, config, dataset.into(), checkpoint, Some(team))
    }

    /// The ranks that hold the whole scene together with this one, if it has a shard.
    #[must_use]
    pub fn group(&self) -> Option<impl Ranks> {
        self.team.as_ref().filter(|team| team.shards.is_some()).map(|team| team.grid().row())
    }

    /// Calls `f` with the ranks that hold the whole scene together: this one alone, if it has no shard.
    pub(super) fn with_group<R>(&self, f: impl FnOnce(&dyn Ranks) -> R) -> R {
        match &self.team {
            Some(team) => f(&team.grid().row()),
            None => f(&ThreadRanks::alone()),
        }
    }

    /// The cameras of the frames to train on, if their poses are refined.
    pub(super) fn refined_cameras(&self) -> Option<&[Camera]> {
        self.config.poses.refine.then(|| self.cameras())
    }

    /// What evaluations measure. Where exposures are learned, the scene does not have those of held-out photographs.
    pub(super) fn fits_colors(&self) -> bool {
        self.exposures.is_some()
    }

    /// How many views are measured at once: one by each group.
    pub(super) fn views_at_once(&self) -> usize {
        let team = self.team.as_ref().filter(|team| team.shards.is_none());
        team.map_or(1, |team| team.ranks.size())
    }

    /// Measures as many views from `first` on as can be at once, together with all ranks; rank 0 has them all.
    pub(super) fn measure(
        &self,
        frames: &[&Frame],
        first: usize,
    ) -> Result<Vec<(Evaluation, Image)>> {
        match &self.team {
            Some(Team { ranks, shards: None }) => {
                let mine = frames.get(first + ranks.rank());
                let mine = mine.map(|frame| self.measure_one(frame)).transpose()?;
                gather_views(&**ranks, mine, &frames[first..])
            }
            _ => Ok(vec![self.measure_one(frames[first])?]),
        }
    }

    /// Measures a view together with the ranks that hold the whole scene.
    pub(super) fn measure_one(&self, frame: &Frame) -> Result<(Evaluation, Image)> {
        evaluate_view(frame, self.fits_colors(), &mut |cameras, batch| match self.scene() {
            Some(scene) => self.renderer.render(scene, cameras, batch),
            None => self.with_group(|ranks| {
                self.renderer.render_shard(self.shard(), cameras, batch, ranks)
            }),
        })
    }

    /// Writes a checkpoint, as rank 0.
    pub(super) fn save(&self, path: &Path, seconds: f64, binding: &Binding) -> Result<()> {
        if let Some(Team { ranks, shards: Some(_) }) = &self.team {
            tell(&**ranks, &Order::Save)?;
        }
        let checkpoint = self.checkpoint(seconds)?;
        self.with_group(|ranks| checkpoint.save_shards(path, Some(binding), ranks))
    }
}

/// Joins what ranks have measured, each at most one of these frames in their order; rank 0 has them all.
pub(super) fn gather_views(
    ranks: &dyn Ranks,
    mine: Option<(Evaluation, Image)>,
    frames: &[&Frame],
) -> Result<Vec<(Evaluation, Image)>> {
    let mut for_each = vec![Vec::new(); ranks.size()];
    for_each[0] = mine.map(|(found, image)| encode(&found, &image)).unwrap_or_default();
    let all = ranks.exchange(for_each)?;
    let views = all.iter().zip(frames).filter(|(bytes, _)| !bytes.is_empty());
    Ok(views.map(|(bytes, frame)| decode(bytes, frame)).collect())
}

/// Numbers of 64 bits before an encoded image.
const WORDS: usize = 7;

/// Pixels that are not finite, PSNR, SSIM and the fitted PSNR, the image. JSON would lose an infinite PSNR.
fn encode(found: &Evaluation, image: &Image) -> Vec<u8> {
    let Score { psnr, ssim, psnr_fitted, .. } = found.mean;
    let score = |score: Option<f64>| [u64::from(score.is_some()), score.unwrap_or(0.0).to_bits()];
    let scores = [psnr, ssim, psnr_fitted].map(score);
    let words = [&[found.not_finite], scores.as_flattened()].concat();
    let mut bytes = bytemuck::cast_slice(&words).to_vec();
    bytes.extend_from_slice(image.pixels().as_flattened());
    bytes
}

fn decode(bytes: &[u8], frame: &Frame) -> (Evaluation, Image) {
    let (words, pixels) = bytes.split_at(WORDS * size_of::<u64>());
    let words: Vec<u64> = bytemuck::pod_collect_to_vec(words);
    let score = |at: usize| (words[at] != 0).then(|| f64::from_bits(words[at + 1]));
    let mean = Score { psnr: score(1), ssim: score(3), psnr_fitted: score(5), ..Score::default() };
    let views = vec![ViewScore { name: frame.name.clone(), score: mean }];
    let size = [frame.camera.width, frame.camera.height];
    let image = Image::from_pixels(size, pixels.as_chunks().0);
    (Evaluation { mean, views, not_finite: words[0] }, image)
}
