//! Range checks of the settings.

use std::fmt::Display;

use super::TrainConfig;
use crate::error::Error;
use crate::tile::most_tiles;

impl TrainConfig {
    /// Checks all values. The error is a sentence about the first one out of range.
    pub(in crate::train) fn check(&self) -> Result<(), String> {
        let positive = |name: &str, value: u32| match value {
            0 => Err(format!("`{name}` is 0, expected 1 or more")),
            _ => Ok(()),
        };
        positive("data.downscale", self.data.downscale)?;
        positive("run.steps", self.run.steps)?;
        positive("run.tiles_per_step", self.run.tiles_per_step)?;
        positive("run.tiles_per_view", self.run.tiles_per_view)?;
        positive("run.checkpoint_every", self.run.checkpoint_every)?;
        positive("run.log_every", self.run.log_every)?;
        positive("start.gaussians", self.start.gaussians)?;
        positive("growth.every", self.growth.every)?;
        positive("growth.max_gaussians", self.growth.max_gaussians)?;
        within("run.tile_size", self.run.tile_size, 1, 512)?;
        within("run.coarse", self.run.coarse, 0.0, 1.0)?;
        within("data.built_in_views", self.data.built_in_views, 2, 1000)?;
        within("data.built_in_side", self.data.built_in_side, 16, 2048)?;
        within("loss.ssim_weight", self.loss.ssim_weight, 0.0, 1.0)?;
        within("loss.distortion_weight", self.loss.distortion_weight, 0.0, 1e3)?;
        within("start.opacity", self.start.opacity, 1e-4, 0.9999)?;
        within("start.scale", self.start.scale, 1e-4, 1e4)?;
        within("start.spread", self.start.spread, 0.0, 1e3)?;
        within("growth.rate", self.growth.rate, 0.0, 1.0)?;
        within("growth.begin", self.growth.begin, 0.0, 1.0)?;
        within("growth.end", self.growth.end, 0.0, 1.0)?;
        within("growth.min_opacity", self.growth.min_opacity, 0.0, 0.5)?;
        for (name, value) in ["red", "green", "blue"].iter().zip(self.data.background.color()) {
            within(&format!("data.background, {name},"), value, 0.0, 1.0)?;
        }
        self.check_together()?;
        self.check_scene()?;
        self.optimizer.check()
    }

    /// Checks that kernels can address the scene, and that the scene is valid.
    fn check_scene(&self) -> Result<(), String> {
        let tiles = self.run.tiles_per_step;
        let side = self.run.tile_size;
        let most = most_tiles(side);
        if u64::from(tiles) > most {
            return Err(format!(
                "`run.tiles_per_step` is {tiles}, expected at most {most} of side {side}: the \
                 kernels address fewer than 2^31 values"
            ));
        }
        let scene = self.scene_config([0.0; 3], [[0.0; 3], [1.0; 3]]);
        scene.validate().map_err(|error| match error {
            Error::BadConfig { field, reason, .. } => format!("`scene.{field}` {reason}"),
            other => other.to_string(),
        })?;
        let gaussians = self.start.gaussians;
        let widest = self.scene.material.max(self.scene.extra).max(4);
        let most = ((1 << 31) - 1) / widest;
        within("start.gaussians", gaussians, 1, most)
    }

    /// Checks values that constrain each other.
    fn check_together(&self) -> Result<(), String> {
        if self.data.hold_out_every == 1 {
            return Err(
                "`data.hold_out_every` is 1, which leaves nothing to train on; expected 2 or \
                        more, or 0 to hold no frame out"
                    .to_owned(),
            );
        }
        self.check_plan()?;
        let first = self.start.gaussians;
        let most = self.growth.max_gaussians;
        if first > most {
            return Err(format!(
                "`start.gaussians` is {first}, more than the {most} of `growth.max_gaussians`"
            ));
        }
        Ok(())
    }
}

impl TrainConfig {
    /// Checks that a run could have made this plan.
    fn check_plan(&self) -> Result<(), String> {
        let plan = &self.run.plan;
        let ascends =
            plan.windows(2).all(|pair| pair[0][0] < pair[1][0] && pair[1][0] < pair[0][1]);
        let first = plan.first().is_none_or(|entry| entry[0] == 0);
        if !ascends || !first || plan.iter().any(|[step, steps]| step >= steps) {
            return Err("`run.plan` is not one that a run has written: its steps ascend from 0, and each is before \
                        the end that was planned; remove it"
                .to_owned());
        }
        match plan.last() {
            Some([_, steps]) if *steps != self.run.steps => Err(format!(
                "`run.plan` ends with {steps} steps, but `run.steps` is {}: remove the plan, put the number back, or \
                 use `--steps`",
                self.run.steps
            )),
            _ => Ok(()),
        }
    }
}

/// Checks a value in its own type, so that messages have the file's digits.
pub(super) fn within<T: Copy + PartialOrd + Display>(
    name: &str,
    value: T,
    low: T,
    high: T,
) -> Result<(), String> {
    match (low..=high).contains(&value) {
        true => Ok(()),
        false => Err(format!("`{name}` is {value}, expected {low} to {high}")),
    }
}
