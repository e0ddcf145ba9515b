//! What the loop of a run needs of its trainer, whether that has the whole scene or a share of it.

use std::path::Path;

use super::binding::Binding;
use super::config::TrainConfig;
use super::hooks::StepHooks;
use super::ranks::{self, Order};
use super::share::ShareTrainer;
use super::trainer::{NO_HOOKS, StepReport, Trainer};
use crate::camera::Camera;
use crate::data::Frame;
use crate::error::{Error, Result};
use crate::evaluate::{Evaluation, evaluate_share};
use crate::image::Image;
use crate::ranks::Ranks;
use crate::render::{DeviceScene, Renderer};

/// A trainer of a run.
#[derive(Debug)]
pub(super) enum EitherTrainer {
    Whole(Box<Trainer>),
    Share(Box<ShareTrainer>),
}

impl EitherTrainer {
    pub fn steps(&self) -> u32 {
        match self {
            Self::Whole(trainer) => trainer.steps(),
            Self::Share(trainer) => trainer.steps(),
        }
    }

    pub fn config(&self) -> &TrainConfig {
        match self {
            Self::Whole(trainer) => trainer.config(),
            Self::Share(trainer) => trainer.config(),
        }
    }

    /// From this step on, the run has so many steps.
    pub fn replan(&mut self, steps: u32) {
        match self {
            Self::Whole(trainer) => trainer.replan(steps),
            Self::Share(trainer) => trainer.replan(steps),
        }
    }

    /// The scene, if it is here.
    pub fn scene(&self) -> Option<&DeviceScene> {
        match self {
            Self::Whole(trainer) => Some(trainer.scene()),
            Self::Share(_) => None,
        }
    }

    /// The cameras of the frames to train on, if their poses are refined.
    pub fn refined_cameras(&self) -> Option<&[Camera]> {
        let is_refined = self.config().poses.refine;
        match self {
            Self::Whole(trainer) => is_refined.then(|| trainer.cameras()),
            Self::Share(_) => None,
        }
    }

    /// Gaussians of the whole scene.
    pub fn gaussians(&self) -> usize {
        match self {
            Self::Whole(trainer) => trainer.scene().len(),
            Self::Share(trainer) => trainer.gaussians(),
        }
    }

    pub fn step_with(&mut self, hooks: &mut StepHooks<'_>) -> Result<StepReport> {
        match self {
            Self::Whole(trainer) => trainer.step_with(hooks),
            Self::Share(_) if hooks.loss.is_some() || hooks.gradient.is_some() => {
                Err(Error::Argument { reason: NO_HOOKS.to_owned() })
            }
            Self::Share(trainer) => trainer.step(),
        }
    }

    /// How many views are measured at once.
    pub fn views_at_once(&self, ranks: Option<&dyn Ranks>) -> usize {
        match self {
            Self::Whole(_) => ranks.map_or(1, Ranks::size),
            Self::Share(_) => 1,
        }
    }

    /// Measures as many views from `first` on as can be at once, together with all ranks; rank 0 has them all.
    pub fn measure(
        &self,
        ranks: Option<&dyn Ranks>,
        renderer: &Renderer,
        frames: &[&Frame],
        first: usize,
    ) -> Result<Vec<(Evaluation, Image)>> {
        match (self, ranks) {
            (Self::Share(trainer), Some(_)) => {
                let row = trainer.grid().row();
                Ok(vec![evaluate_share(renderer, trainer.share(), frames[first], &row)?])
            }
            (Self::Whole(trainer), Some(ranks)) => {
                ranks::measure(ranks, renderer, trainer.scene(), frames, first)
            }
            (Self::Whole(trainer), None) => {
                Ok(vec![ranks::measure_one(renderer, trainer.scene(), frames[first])?])
            }
            (Self::Share(_), None) => unreachable!("shares are those of ranks"),
        }
    }

    /// Writes a checkpoint, as rank 0.
    pub fn save(&self, path: &Path, seconds: f64, binding: &Binding) -> Result<()> {
        match self {
            Self::Whole(trainer) => trainer.checkpoint(seconds)?.save(path, Some(binding)),
            Self::Share(trainer) => {
                let grid = trainer.grid();
                Order::Save.give(grid.all)?;
                trainer.checkpoint(seconds)?.save(path, Some(binding), &grid.row())
            }
        }
    }
}
