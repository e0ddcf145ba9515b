//! Values that no run can have.

use super::TrainConfig;

impl TrainConfig {
    /// The first value that is out of range, as a sentence.
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
        within("run.tile_size", f64::from(self.run.tile_size), 1.0, 512.0)?;
        within("data.built_in_views", f64::from(self.data.built_in_views), 2.0, 1000.0)?;
        within("data.built_in_side", f64::from(self.data.built_in_side), 16.0, 2048.0)?;
        within("loss.ssim_weight", f64::from(self.loss.ssim_weight), 0.0, 1.0)?;
        within("start.opacity", f64::from(self.start.opacity), 1e-4, 0.9999)?;
        within("start.scale", f64::from(self.start.scale), 1e-4, 1e4)?;
        within("start.spread", f64::from(self.start.spread), 0.0, 1e3)?;
        within("start.transmittance_bias", f64::from(self.start.transmittance_bias), -50.0, 50.0)?;
        within("growth.rate", self.growth.rate, 0.0, 1.0)?;
        within("growth.begin", self.growth.begin, 0.0, 1.0)?;
        within("growth.end", self.growth.end, 0.0, 1.0)?;
        within("growth.min_opacity", f64::from(self.growth.min_opacity), 0.0, 0.5)?;
        self.check_together()?;
        self.optimizer.check()
    }

    /// What one value says about another.
    fn check_together(&self) -> Result<(), String> {
        if self.data.hold_out_every == 1 {
            return Err(
                "`data.hold_out_every` is 1, which leaves nothing to train on; expected 2 or \
                        more, or 0 to hold no frame out"
                    .to_owned(),
            );
        }
        let (first, most) = (self.start.gaussians, self.growth.max_gaussians);
        if first > most {
            return Err(format!(
                "`start.gaussians` is {first}, more than the {most} of `growth.max_gaussians`"
            ));
        }
        Ok(())
    }
}

pub(super) fn within(name: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    match (low..=high).contains(&value) {
        true => Ok(()),
        false => Err(format!("`{name}` is {value}, expected {low} to {high}")),
    }
}
