//! A run that ranks share: rank 0 leads it, reads and writes its files, and sends the next action to the others.

use std::sync::Arc;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::held_out;
use crate::evaluate::{Evaluation, Score, ViewScore};
use crate::{Checkpoint, TrainConfig, Trainer};
use organza_core::Image;
use organza_core::error::{Error, IN_MEMORY, Result};
use organza_core::ranks::{self, Ranks};
use organza_data::{Dataset, Frame};
use organza_render::{OwnLoss, Renderer};

/// The next action of all ranks, which rank 0 chooses.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) enum Order {
    /// A step, and the number of steps of the run.
    Step(u32),
    /// Each rank measures one held-out view, from `first` on, of all views or of an intermediate evaluation's views.
    Evaluate { first: usize, all: bool },
    /// The end of the run.
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
        &renderer.device().arithmetic(),
        crate::COMMIT.unwrap_or_default(),
        ("photographs", &photographs),
        mixed,
    )
}

/// Fails if some ranks have a loss of their own, and others have not.
fn check_losses(ranks: &dyn Ranks, has_own_loss: bool) -> Result<()> {
    let mine = vec![u8::from(has_own_loss)];
    match ranks.gather(mine.clone())?.iter().all(|other| *other == mine) {
        true => Ok(()),
        false => Err(Error::Argument {
            reason: "some ranks have a loss of their own, and others have not".into(),
        }),
    }
}

/// Sends the other ranks the settings and the checkpoint.
pub(super) fn lead(
    ranks: &dyn Ranks,
    renderer: &Renderer,
    (config, dataset): (&TrainConfig, &Dataset),
    checkpoint: &Checkpoint,
    has_own_loss: bool,
    mixed: bool,
) -> Result<()> {
    check_photographs(ranks, renderer, dataset, mixed)?;
    check_losses(ranks, has_own_loss)?;
    tell(ranks, &config.to_toml())?;
    ranks.broadcast(checkpoint.to_bytes()?).map(drop)
}

/// Takes part in the run of rank 0's [`Session`](super::Session), to its end. The session sends its settings and its scene.
/// The photographs, `mixed` and the caller's own loss must be the same as the session's.
///
/// # Errors
/// The same errors as [`Session::run`](super::Session::run); [`Error::Rank`](organza_core::Error::Rank) where another
/// rank has failed. The caller must [report](Ranks::fail) an error to the others.
pub fn follow(
    renderer: &Renderer,
    dataset: &Arc<Dataset>,
    ranks: &Arc<dyn Ranks>,
    mixed: bool,
    mut own: Option<&mut OwnLoss<'_>>,
) -> Result<()> {
    check_photographs(&**ranks, renderer, dataset, mixed)?;
    check_losses(&**ranks, own.is_some())?;
    let text: String = hear(&**ranks)?;
    let config = TrainConfig::parse(&text, IN_MEMORY.as_ref())?;
    let bytes = ranks.broadcast(Vec::new())?;
    let checkpoint = Checkpoint::from_bytes(&bytes, IN_MEMORY)?;
    drop(bytes);
    let trainer = Trainer::resume(renderer, config, dataset.clone(), &checkpoint)?;
    let mut trainer = trainer.with_ranks(ranks.clone());
    drop(checkpoint);
    loop {
        match hear(&**ranks)? {
            Order::Step(steps) => {
                if steps != trainer.config().run.steps {
                    trainer.reschedule(steps);
                }
                trainer.waiting_step(own.as_deref_mut())?;
            }
            Order::Evaluate { first, all } => {
                let frames = held_out::frames(dataset, trainer.config().run.evaluate_views, all);
                trainer.measure(&frames, first)?;
            }
            Order::End => return Ok(()),
        }
    }
}

impl Trainer {
    /// How many views are measured at once: one by each rank.
    pub(super) fn views_at_once(&self) -> usize {
        self.ranks.as_ref().map_or(1, |ranks| ranks.size())
    }

    /// Measures one view per rank, from `first` on. Rank 0 returns all of them.
    pub(super) fn measure(
        &self,
        frames: &[&Frame],
        first: usize,
    ) -> Result<Vec<(Evaluation, Image)>> {
        let Some(ranks) = &self.ranks else { return Ok(vec![self.measure_one(frames[first])?]) };
        let mine = frames.get(first + ranks.rank());
        let mine = mine.map(|frame| self.measure_one(frame)).transpose()?;
        gather_views(&**ranks, mine, &frames[first..])
    }
}

/// Gathers the measurements of all ranks on rank 0. Rank i may have measured frame i.
fn gather_views(
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

/// Words of 64 bits before the pixels.
const WORDS: usize = 7;

/// Encodes the number of pixels that are not finite, PSNR, SSIM, the fitted PSNR, and the image. JSON would lose an infinite PSNR.
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
    let mean = Score { psnr: score(1), ssim: score(3), psnr_fitted: score(5) };
    let views = vec![ViewScore { name: frame.name.clone(), score: mean }];
    let size = [frame.camera.width, frame.camera.height];
    let image = Image::from_pixels(size, pixels.as_chunks().0);
    (Evaluation { mean, views, not_finite: words[0] }, image)
}
