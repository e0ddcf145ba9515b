//! All settings of a run. They are in the run folder's `config.toml`, which `--config` reads.

mod assignment;
mod builder;
mod check;
mod learn_exposure;
mod optimizer;
mod preset;
mod table;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use assignment::defaults;
pub use builder::ConfigBuilder;
pub use learn_exposure::LearnExposure;
pub(super) use optimizer::EPSILON;
pub use preset::Preset;
pub use table::{
    AblationConfig, DataConfig, ExposureConfig, GrowthConfig, LossConfig, OptimizerConfig,
    PosesConfig, Rate, RunConfig, SETTINGS, Setting, ShapeConfig, StartConfig, TrainConfig,
};

use organza_core::error::{Error, Result};
use organza_core::input::read_text;
use organza_core::scene::{Placement, SceneConfig};
use organza_core::write_atomic;
use organza_data::{Background, Dataset, DatasetOptions};

/// Largest settings file, in bytes. All settings need far less; a larger file was named by mistake.
const MAX_BYTES: u64 = 1 << 20;

impl DataConfig {
    /// Options for reading the data set.
    #[must_use]
    pub fn options(&self) -> DatasetOptions {
        DatasetOptions::default()
            .downscale(self.downscale)
            .hold_out_every(self.hold_out_every)
            .background(self.background)
            .alpha(self.alpha)
            .allow_outside(self.allow_outside)
            .keep(self.keep)
    }
}

impl RunConfig {
    /// The part of the run that is done before `step`, 0 to 1. Learning rates and growth follow it.
    ///
    /// Each entry of the plan spreads the rest of the run evenly over the remaining steps.
    #[must_use]
    pub fn fraction(&self, step: u32) -> f64 {
        let mut from = 0;
        let mut done = 0.0;
        let mut steps = self.steps;
        let part = |from: u32, to: u32, steps: u32| {
            f64::from(to - from) / f64::from(steps.saturating_sub(from).max(1))
        };
        for &[at, planned] in self.plan.iter().filter(|entry| entry[0] <= step) {
            done += (1.0 - done) * part(from, at, steps);
            from = at;
            steps = planned;
        }
        (done + (1.0 - done) * part(from, step, steps)).min(1.0)
    }

    /// Sets the total number of steps of the run, from `step` on.
    pub(super) fn replan(&mut self, step: u32, steps: u32) {
        // a run without a plan that goes on: what is done is a part of the new number
        if self.plan.is_empty() && step > 0 {
            self.plan.push([0, steps]);
        }
        self.plan.push([step, steps]);
        self.steps = steps;
    }
}

impl TrainConfig {
    /// Whether a step trains the transmittance field and the extra values, too.
    pub(crate) fn learns_transmittance(&self, step: u32) -> bool {
        self.ablation.learn_transmittance && step.is_multiple_of(self.optimizer.transmittance_every)
    }

    /// Every setting as `table.name` with its value, in the order and with the digits of the file.
    #[must_use]
    pub fn list(&self) -> Vec<(String, String)> {
        // through the text: there an `f32` of 0.2 is 0.2, and not the f64 nearest to it
        let table: toml::Table = toml::from_str(&self.to_toml()).unwrap_or_default();
        let leaves = assignment::leaves(&table, |_| false);
        leaves.into_iter().map(|(name, value)| (name, value.to_string())).collect()
    }

    /// Sets the values that depend on the data set, so that the run's file records them: the background that
    /// photographs are over, and whether exposures are learned.
    pub fn resolve(&mut self, dataset: &Dataset) {
        if self.data.path.is_some() {
            self.data.background = Background::Color(dataset.background.map(|value| value as f32));
        }
        self.exposure.learn = self.exposure.learn.decide(dataset).into();
    }

    /// The configuration of a run's scene.
    pub(super) fn scene_config(&self, background: [f64; 3], aabb: [[f64; 3]; 2]) -> SceneConfig {
        let shape = self.scene.clone();
        SceneConfig {
            sh_degree: shape.sh_degree,
            material: shape.material,
            extra: shape.extra,
            color_grid: shape.color_grid,
            transmittance_grid: shape.transmittance_grid,
            color_mlp: shape.color_mlp,
            transmittance_mlp: shape.transmittance_mlp,
            step: shape.step,
            occupancy: shape.occupancy,
            blur: shape.blur,
            antialiased: shape.antialiased,
            background,
            aabb,
            contraction: shape.contraction,
            placement: Placement::default(),
        }
    }

    /// Reads a file that [`TrainConfig::save`] wrote, or one like it.
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::Invalid`] if it is not TOML, or has an unknown field or a value out of range.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        ConfigBuilder::new(Preset::Default)?.file(path)?.build()
    }

    /// Fails if a run's own file, which has every setting, lacks one.
    pub(super) fn check_complete(&self, path: &Path) -> Result<()> {
        let text = read_text(path, MAX_BYTES, "settings")?;
        let found: toml::Table = toml::from_str(&text).unwrap_or_default();
        let has = |name: &str| {
            let mut keys = name.split('.');
            let table = keys.next().and_then(|key| found.get(key));
            keys.try_fold(table, |value, key| Some(value?.get(key))).flatten().is_some()
        };
        match Self::default().list().iter().find(|(name, _)| !has(name)) {
            None => Ok(()),
            Some((name, _)) => {
                let reason = format!(
                    "`{name}` is missing, and a run's settings are all there: the file was cut \
                     short or is another; copy it again, or begin another run with `--config`"
                );
                Err(Error::Invalid { origin: path.to_owned(), reason })
            }
        }
    }

    /// Like [`TrainConfig::load`], but from text.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`].
    pub fn parse(text: &str, origin: &Path) -> Result<Self> {
        ConfigBuilder::new(Preset::Default)?.text(text, origin)?.build()
    }

    /// The settings as the text of a file.
    #[must_use]
    pub fn to_toml(&self) -> String {
        toml::to_string_pretty(self).expect("plain tables of numbers and strings")
    }

    /// Writes the settings to a file, atomically.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        write_atomic(path, |writer| writer.write_all(self.to_toml().as_bytes()))
    }
}
