//! A run that ranks share: rank 0 leads it, reads and writes its files, and sends the others what comes next.

use std::sync::Arc;

use super::checkpoint::Checkpoint;
use super::config::TrainConfig;
use super::held_out;
use super::trainer::Trainer;
use crate::evaluate::{Evaluation, Event, Measures, Score, ViewScore, evaluate_measures};
use organza_core::error::{IN_MEMORY, Result};
use organza_core::image::Image;
use organza_core::ranks::{self, Grid, Ranks};
use organza_data::{Dataset, Frame};
use organza_render::{DeviceScene, Renderer};

/// The parts of a training that ranks share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Split {
    /// Each rank has the whole scene, and computes some of a step's views.
    #[default]
    Views,
    /// Each rank has some of the Gaussians, and computes their part of all of a step's views: see
    /// [`Trainer::resume_shard`].
    Gaussians,
}

/// The next action of all ranks, which rank 0 chooses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// A step, and the number of steps of the run.
    Step(u32),
    /// Measure a held-out view each, from this one on: of all, or of those of intermediate evaluations.
    Evaluate { first: usize, all: bool },
    /// Hand over the shard for a checkpoint.
    Save,
    /// Nothing more.
    End,
}

impl Order {
    fn encode(self) -> [u64; 2] {
        match self {
            Self::Step(steps) => [0, u64::from(steps)],
            Self::Evaluate { first, all } => [1 + u64::from(all), first as u64],
            Self::Save => [3, 0],
            Self::End => [4, 0],
        }
    }

    fn decode([kind, value]: [u64; 2]) -> Self {
        match kind {
            0 => Self::Step(value as u32),
            1 | 2 => Self::Evaluate { first: value as usize, all: kind == 2 },
            3 => Self::Save,
            _ => Self::End,
        }
    }

    /// Sends it to the other ranks, from rank 0.
    pub fn give(self, ranks: &dyn Ranks) -> Result<()> {
        ranks.broadcast(bytemuck::cast_slice(&self.encode()).to_vec()).map(drop)
    }

    fn receive(ranks: &dyn Ranks) -> Result<Self> {
        let words: Vec<u64> = bytemuck::pod_collect_to_vec(&ranks.broadcast(Vec::new())?);
        Ok(Self::decode([words[0], words[1]]))
    }
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
    (ranks, shards): (&dyn Ranks, Option<usize>),
    renderer: &Renderer,
    (config, dataset): (&TrainConfig, &Dataset),
    mine: &mut Checkpoint,
    shard: impl Fn(usize) -> Result<Checkpoint>,
    mixed: bool,
) -> Result<()> {
    check_photographs(ranks, renderer, dataset, mixed)?;
    let words = [shards.unwrap_or_default() as u64];
    ranks.broadcast(bytemuck::cast_slice(&words).to_vec())?;
    ranks.broadcast(config.to_toml().into_bytes())?;
    mine.send_to_ranks(Grid::new(ranks, shards.unwrap_or(1))?, shard)
}

/// The trainer of a rank that has one of `shards` shards, or the whole scene.
pub(super) fn trainer(
    (ranks, shards): (&Arc<dyn Ranks>, Option<usize>),
    renderer: &Renderer,
    config: TrainConfig,
    dataset: Arc<Dataset>,
    checkpoint: &Checkpoint,
) -> Result<Trainer> {
    let ranks = ranks.clone();
    match shards {
        Some(shards) => Trainer::resume_shard(renderer, config, dataset, checkpoint, ranks, shards),
        None => Ok(Trainer::resume(renderer, config, dataset, checkpoint)?.with_ranks(ranks)),
    }
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
    let words: Vec<u64> = bytemuck::pod_collect_to_vec(&ranks.broadcast(Vec::new())?);
    let shards = words.first().map(|&shards| shards as usize).filter(|&shards| shards > 0);
    let text = String::from_utf8_lossy(&ranks.broadcast(Vec::new())?).into_owned();
    let config = TrainConfig::parse(&text, IN_MEMORY.as_ref())?;
    let checkpoint = Checkpoint::receive(Grid::new(&**ranks, shards.unwrap_or(1))?)?;
    let mut trainer = trainer((ranks, shards), renderer, config, dataset.clone(), &checkpoint)?;
    drop(checkpoint);
    loop {
        match Order::receive(&**ranks)? {
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

/// Measures a view.
pub(super) fn measure_one(
    renderer: &Renderer,
    scene: &DeviceScene,
    frame: &Frame,
    measures: Measures<'_>,
) -> Result<(Evaluation, Image)> {
    let mut rendered = None;
    let found = evaluate_measures(renderer, scene, &[frame], measures, &mut |event| {
        if let Event::View { image, .. } = event {
            rendered = Some(image.clone());
        }
    })?;
    Ok((found, rendered.expect("the view was rendered")))
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
