//! All settings of a run. They are in the run folder's `config.toml`, which `--config` reads. The learning rates at a step.

mod assignment;
mod builder;
mod table;
#[cfg(test)]
mod tests;

use std::ops::RangeInclusive;
use std::path::Path;

pub use assignment::defaults;
pub use builder::{ConfigBuilder, Preset};
pub use table::{
    AblationConfig, DataConfig, DensificationConfig, ExposureConfig, LossConfig, OptimizerConfig,
    PosesConfig, Rate, RunConfig, SETTINGS, Setting, ShapeConfig, StartConfig, TrainConfig,
};

use muslin_device::Device;
use organza_core::input::read_text;
use organza_core::scene::{
    FieldTensors, GaussianTensors, Placement, SceneConfig, Tensors, TrainedOn,
};
use organza_core::{Error, Result, gaussian_tensors, write_atomic};
use organza_data::{Alpha, Background, Dataset, DatasetOptions, Frame};
use serde::{Deserialize, Serialize};
use table::within;

/// Largest settings file, in bytes. All settings need far less; a larger file was named by mistake.
const MAX_BYTES: u64 = 1 << 20;

impl DataConfig {
    /// Options for reading the data set.
    #[must_use]
    pub fn options(&self) -> DatasetOptions {
        DatasetOptions {
            downscale: self.downscale,
            hold_out_every: self.hold_out_every,
            hold_out_length: self.hold_out_length,
            background: self.background,
            alpha: self.alpha,
            allow_outside: self.allow_outside,
            placement: None,
            trained_on: None,
        }
    }

    /// What a scene is trained on with these settings.
    pub(crate) fn trained_on(&self, dataset: &Dataset) -> TrainedOn {
        let name = |frame: &Frame| frame.name.clone();
        TrainedOn {
            seen: dataset.train_frames().map(name).collect(),
            held_out: dataset.held_out_frames().map(name).collect(),
            downscale: self.downscale,
            alpha_is_mask: self.alpha == Alpha::Mask,
        }
    }
}

/// Number of pixels of the photographs to train on.
#[must_use]
pub fn pixels(dataset: &Dataset) -> f64 {
    let pixels = |frame: &Frame| f64::from(frame.camera.width) * f64::from(frame.camera.height);
    dataset.train_frames().map(pixels).sum()
}

/// How often a run draws as many pixels as its photographs have, where its settings leave the number of steps open.
// docs/experiments.md has the measurements.
const VISITS: f64 = 20.0;
/// Smallest number of steps of such a run.
const MIN_STEPS: f64 = 8000.0;
/// Largest number of steps of such a run, on a CPU and on a GPU.
const MAX_STEPS: [f64; 2] = [10_000.0, 100_000.0];
/// Pixels of photographs for each Gaussian on a GPU, where settings leave the number of Gaussians open and steps draw each pixel
/// `VISITS` times. 3D Gaussian Splatting has about as many.
pub const PIXELS_PER_GAUSSIAN: f64 = 500.0;
/// Smallest number of Gaussians of such a run, and the number on a CPU.
const MIN_GAUSSIANS: f64 = 30_000.0;
/// Largest number of Gaussians of such a run.
const MAX_GAUSSIANS: f64 = 300_000.0;

impl RunConfig {
    /// Number of pixels that a step draws.
    #[must_use]
    pub fn pixels_per_step(&self) -> f64 {
        [self.tiles_per_step, self.tile_size, self.tile_size].map(f64::from).iter().product()
    }

    /// The number of steps to train on photographs with `pixels` pixels in all, on a device [like a CPU](Device::is_cpu_like)
    /// or on a GPU: the settings' own, or 20 times the photographs' pixels, within limits.
    #[must_use]
    pub fn steps_for(&self, pixels: f64, is_cpu_like: bool) -> u32 {
        if self.steps > 0 {
            return self.steps;
        }
        let max = MAX_STEPS[usize::from(!is_cpu_like)];
        let steps = VISITS * pixels / self.pixels_per_step();
        // a round number
        (100.0 * (steps / 100.0).ceil()).clamp(MIN_STEPS, max) as u32
    }

    /// The part of the run that is done before `step`, 0 to 1. Learning rates and densification follow it.
    ///
    /// Each entry of the schedule spreads the rest of the run evenly over the remaining steps.
    #[must_use]
    pub fn fraction(&self, step: u32) -> f64 {
        let mut from = 0;
        let mut done = 0.0;
        let mut steps = self.steps;
        let part = |from: u32, to: u32, steps: u32| {
            f64::from(to - from) / f64::from(steps.saturating_sub(from).max(1))
        };
        for &[at, scheduled] in self.schedule.iter().filter(|entry| entry[0] <= step) {
            done += (1.0 - done) * part(from, at, steps);
            from = at;
            steps = scheduled;
        }
        (done + (1.0 - done) * part(from, step, steps)).min(1.0)
    }

    /// Sets the total number of steps of the run, from `step` on.
    pub(super) fn reschedule(&mut self, step: u32, steps: u32) {
        // a run without a schedule that goes on: the steps that are done are a part of the new number
        if self.schedule.is_empty() && step > 0 {
            self.schedule.push([0, steps]);
        }
        self.schedule.push([step, steps]);
        self.steps = steps;
    }
}

impl TrainConfig {
    /// The largest number of Gaussians for photographs with `pixels` pixels in all, on a device [like a CPU](Device::is_cpu_like) or
    /// on a GPU: the settings' own, or one Gaussian for 500 pixels that the run's steps draw 20 times, within limits.
    #[must_use]
    pub fn gaussians_for(&self, pixels: f64, is_cpu_like: bool) -> u32 {
        if self.densification.max_gaussians > 0 {
            return self.densification.max_gaussians;
        }
        let steps = f64::from(self.run.steps_for(pixels, is_cpu_like));
        let filled = pixels.min(steps * self.run.pixels_per_step() / VISITS);
        let gaussians = filled / PIXELS_PER_GAUSSIAN;
        let max = if is_cpu_like { MIN_GAUSSIANS } else { MAX_GAUSSIANS };
        // a round number
        let gaussians = 1000.0 * (gaussians / 1000.0).ceil();
        (gaussians.clamp(MIN_GAUSSIANS, max) as u32).max(self.start.gaussians)
    }

    /// Number of the first Gaussians if the data set has no points.
    pub(crate) fn first_gaussians(&self) -> u32 {
        match self.densification.max_gaussians {
            0 => self.start.gaussians,
            max => self.start.gaussians.min(max),
        }
    }

    /// Of what [`resolve`](Self::resolve) sets, the numbers of steps and of Gaussians: a trainer without a file needs no more.
    pub(crate) fn resolve_sizes(&mut self, dataset: &Dataset, device: &Device) {
        let pixels = pixels(dataset);
        self.run.steps = self.run.steps_for(pixels, device.is_cpu_like());
        self.densification.max_gaussians = self.gaussians_for(pixels, device.is_cpu_like());
    }

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

    /// Sets the values that depend on the data set and the device, so that the run's file records them: the photographs'
    /// background, whether exposures are learned, and the numbers of steps and of Gaussians.
    pub fn resolve(&mut self, dataset: &Dataset, device: &Device) {
        if self.data.path.is_some() {
            self.data.background = Background::Color(dataset.background.map(|value| value as f32));
        }
        self.exposure.learn = self.exposure.learn.decide(dataset).into();
        self.resolve_sizes(dataset, device);
    }

    /// The configuration of a run's scene.
    pub(super) fn scene_config(&self, background: [f64; 3], aabb: [[f64; 3]; 2]) -> SceneConfig {
        let shape = self.scene.clone();
        SceneConfig {
            sh_degree: shape.sh_degree,
            material: shape.material,
            extra: shape.extra,
            slope: shape.slope,
            shape: shape.shape,
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
            trained_on: None,
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

/// Adam's epsilon.
pub(crate) const EPSILON: f64 = 1e-12;
/// Factor of the rates at the end of their cooldown.
const COOLED: f64 = 0.02;

/// The values that a learning rate can have.
const RATES: RangeInclusive<f64> = 1e-12..=1.0;

macro_rules! define {
    ($($(#[$doc:meta])* $name:ident: $row:tt, $why:literal, $rate:tt;)+) => {
        impl OptimizerConfig {
            /// The rate of each tensor of a scene.
            #[must_use]
            pub fn rates(&self) -> Tensors<Rate> {
                let field = FieldTensors { grid: self.grids, network: self.networks };
                let gaussians = GaussianTensors { $($name: self.$name,)+ };
                Tensors { gaussians, color: field, transmittance: field }
            }

            /// Every rate with its name in the file.
            pub(crate) fn named_rates(&self) -> impl Iterator<Item = (&'static str, Rate)> {
                let of_gaussians = [$((stringify!($name), self.$name)),+];
                let others = [
                    ("grids", self.grids),
                    ("networks", self.networks),
                    ("exposure", self.exposure),
                    ("pose", self.pose),
                ];
                of_gaussians.into_iter().chain(others)
            }
        }
    };
}

gaussian_tensors!(define);

impl OptimizerConfig {
    /// A rate after the part `fraction` of the run, 0 to 1: see [`RunConfig::fraction`](RunConfig::fraction).
    #[must_use]
    pub fn rate_at(&self, rate: Rate, fraction: f64) -> f64 {
        let fraction = fraction.min(1.0);
        let left = if self.cooldown > 0.0 { (1.0 - fraction) / self.cooldown } else { 1.0 };
        rate.first * (rate.last / rate.first).powf(fraction) * left.clamp(COOLED, 1.0)
    }

    /// Checks the rates. The error is a sentence about the first value out of range.
    pub(super) fn check_rates(&self) -> Result<(), String> {
        for (name, rate) in self.named_rates() {
            within(&format!("optimizer.{name}.first"), rate.first, RATES)?;
            within(&format!("optimizer.{name}.last"), rate.last, RATES)?;
        }
        Ok(())
    }
}

/// Exposures that differ by more than this are learned: see [`Dataset::exposure_spread`].
// docs/experiments.md has the measurements: 10% is not worth it, 13% is.
const SPREAD: f64 = 0.12;

/// Whether a run learns the photographs' exposures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LearnExposure {
    /// If they differ by more than 12%, measured at the data set's points. Without points, none are learned.
    #[default]
    Auto,
    /// Yes.
    On,
    /// No.
    Off,
}

impl LearnExposure {
    /// Whether exposures of these photographs are learned.
    #[must_use]
    pub fn decide(self, dataset: &Dataset) -> bool {
        match self {
            Self::Auto => dataset.exposure_spread().is_some_and(|spread| spread > SPREAD),
            Self::On => true,
            Self::Off => false,
        }
    }
}

impl From<bool> for LearnExposure {
    fn from(learn: bool) -> Self {
        if learn { Self::On } else { Self::Off }
    }
}
