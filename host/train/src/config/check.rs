//! Range checks of the settings.

use super::TrainConfig;
use super::table::within;
use organza_core::error::Error;
use organza_core::tile::most_tiles;

impl TrainConfig {
    /// Checks all values. The error is a sentence about the first one out of range.
    pub(crate) fn check(&self) -> Result<(), String> {
        self.check_ranges()?;
        for (name, value) in ["red", "green", "blue"].iter().zip(self.data.background.color()) {
            within(&format!("data.background, {name},"), value, 0.0..=1.0)?;
        }
        self.check_together()?;
        self.check_scene()?;
        self.optimizer.check_rates()
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
        within("start.gaussians", gaussians, 1..=most)
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
            return Err("`run.plan` is not a plan of `--minutes`: its steps must ascend from 0, and each must be less \
                        than the number of all steps that was planned there; remove it"
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
