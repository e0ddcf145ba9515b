//! All settings of a run. They are in the run folder's `config.toml`, which `--config` reads.

mod assignment;
mod builder;
mod check;
mod optimizer;
mod preset;
mod retired;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

pub use assignment::defaults;
pub use builder::ConfigBuilder;
pub(super) use optimizer::EPSILON;
pub use optimizer::{OptimizerConfig, Rate};
pub use preset::Preset;
use serde::{Deserialize, Serialize};

use crate::data::{Alpha, Background, DatasetOptions, Keep};
use crate::error::{Error, Result};
use crate::input::read_text;
use crate::scene::{Contraction, GridConfig, MlpConfig, SceneConfig};
use organza_core::write_atomic;

/// Largest settings file, in bytes. All settings need far less; a larger file was named by mistake.
const MAX_BYTES: u64 = 1 << 20;

/// All settings of a run. Names are those in the file. A setting that the file leaves out has its default.
///
/// ```
/// use organza::TrainConfig;
///
/// let mut config = TrainConfig::default();
/// config.run.steps = 500;
/// config.growth.max_gaussians = 20_000;
/// let text = config.to_toml();
/// assert_eq!(TrainConfig::parse(&text, "config.toml".as_ref())?, config);
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct TrainConfig {
    /// The photographs.
    pub data: DataConfig,
    /// The run's length, the size of a step, and how often something is written.
    pub run: RunConfig,
    /// The loss.
    pub loss: LossConfig,
    /// The exposure of each photograph.
    pub exposure: ExposureConfig,
    /// The poses of the photographs' cameras.
    pub poses: PosesConfig,
    /// The shape of the scene.
    pub scene: ShapeConfig,
    /// The scene before the first step.
    pub start: StartConfig,
    /// Adam and its rates.
    pub optimizer: OptimizerConfig,
    /// Changes of the number of Gaussians.
    pub growth: GrowthConfig,
    /// Parts that experiments switch off.
    pub ablation: AblationConfig,
}

/// The photographs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct DataConfig {
    /// The data set. Without it, the built-in scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathBuf>,
    /// Factor by which photographs are reduced.
    pub downscale: u32,
    /// Every Nth frame is held out; 0 holds none out.
    pub hold_out_every: usize,
    /// Background of the scene, and of photographs with an alpha channel.
    pub background: Background,
    /// Meaning of an alpha channel.
    pub alpha: Alpha,
    /// Storage for the photographs.
    pub keep: Keep,
    /// Number of views of the built-in scene.
    pub built_in_views: u32,
    /// Side of those images, in pixels.
    pub built_in_side: u32,
    /// Whether the data set may name files outside its own folder, by path or by link.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub allow_outside: bool,
}

/// The run's length, the size of a step, and how often something is written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct RunConfig {
    /// Number of steps. Learning rates fall until the last one.
    pub steps: u32,
    /// The history of `steps` in a planned run. `[step, steps]` says: from this step on, the run was to have `steps`
    /// steps. Empty if the number was known from the first step.
    pub plan: Vec<[u32; 2]>,
    /// Seed of every random choice.
    pub seed: u64,
    /// K, tiles per step.
    pub tiles_per_step: u32,
    /// S, side of a tile in pixels.
    pub tile_size: u32,
    /// Tiles of a step that share a view and are neighbors in its image. Gaussians that several of them show are
    /// evaluated once. With 1, every tile is drawn independently. If an image has fewer tiles, steps see whole
    /// images.
    pub tiles_per_view: u32,
    /// Initial part of the run, 0 to 1, in which photographs have half their size and steps of T are twice as long as
    /// sigma.
    pub coarse: f64,
    /// Interval of evaluations, in steps. There is one after the last step, too; with 0, only that one.
    pub evaluate_every: u32,
    /// Number of held-out views in intermediate evaluations, evenly spaced. With 0, all. The last evaluation measures
    /// all.
    pub evaluate_views: u32,
    /// Interval of checkpoints, in steps. There is one at the end, too.
    pub checkpoint_every: u32,
    /// Interval of lines in `metrics.jsonl`, in steps.
    pub log_every: u32,
    /// Whether the log is also written as TensorBoard's event file.
    pub tensorboard: bool,
}

/// The loss: `(1 - w) L1 + w (1 - SSIM)`, and further terms.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct LossConfig {
    /// w, from 0 to 1.
    pub ssim_weight: f32,
    /// Weight of the [distortion](organza_shaders::distortion), a further term.
    pub distortion_weight: f32,
}

/// The exposure of each photograph.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct ExposureConfig {
    /// Whether a gain and an offset per channel are learned.
    pub learn: bool,
}

/// The poses of the photographs' cameras.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct PosesConfig {
    /// Whether a rotation and a shift of each training camera are learned.
    pub refine: bool,
}

/// Parts that experiments switch off, to measure their effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct AblationConfig {
    /// Whether T is learned. Otherwise it is 1 everywhere.
    pub learn_transmittance: bool,
    /// Whether a sum of weights above 1 divides its pixel (Eq. 13). A scene's file does not store this: everything
    /// but the run's own measurements divides.
    pub divide: bool,
}

impl Default for AblationConfig {
    fn default() -> Self {
        Self { learn_transmittance: true, divide: true }
    }
}

/// The shape of the scene: see [`SceneConfig`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct ShapeConfig {
    /// Degree of the spherical harmonics.
    pub sh_degree: u32,
    /// Values of a Gaussian's material.
    pub material: u32,
    /// Values of a Gaussian's extra vector.
    pub extra: u32,
    /// sigma, length of a transmittance step in the unit cube.
    pub step: f64,
    /// Treatment of space outside the scene's box.
    pub contraction: Contraction,
    /// Added to the diagonal of every covariance, in square pixels.
    pub blur: f64,
    /// Hidden layers of the color network.
    pub color_mlp: MlpConfig,
    /// Hidden layers of the transmittance network.
    pub transmittance_mlp: MlpConfig,
    /// The color network's grid.
    pub color_grid: GridConfig,
    /// The transmittance network's grid.
    pub transmittance_grid: GridConfig,
}

/// The scene before the first step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct StartConfig {
    /// A PLY or SPZ file of 3D Gaussian Splatting, whose Gaussians training starts with.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathBuf>,
    /// Number of Gaussians if the data set has no points. Otherwise there is one for each point, up to
    /// `growth.max_gaussians`.
    pub gaussians: u32,
    /// Opacity of each Gaussian.
    pub opacity: f32,
    /// Scale of each Gaussian, as a multiple of the distance to its nearest neighbors.
    pub scale: f32,
    /// Half the range of random material and extra values.
    pub spread: f32,
}

/// Changes of the number of Gaussians. Gaussians with the strongest gradient of their center are split, and
/// transparent ones are removed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct GrowthConfig {
    /// Largest number of Gaussians.
    pub max_gaussians: u32,
    /// Interval between changes, in steps.
    pub every: u32,
    /// First change, as a part of all steps.
    pub begin: f64,
    /// Last change, as a part of all steps. If it is before `begin`, the number never changes.
    pub end: f64,
    /// Fraction of Gaussians that each change adds.
    pub rate: f64,
    /// Gaussians with a lower opacity are removed.
    pub min_opacity: f32,
}

impl DataConfig {
    /// Options for reading the data set.
    #[must_use]
    pub fn options(&self) -> DatasetOptions {
        DatasetOptions {
            downscale: self.downscale,
            hold_out_every: self.hold_out_every,
            background: self.background,
            alpha: self.alpha,
            allow_outside: self.allow_outside,
            keep: self.keep,
        }
    }
}

impl Default for DataConfig {
    fn default() -> Self {
        Self {
            path: None,
            downscale: 1,
            hold_out_every: 8,
            background: Background::Auto,
            alpha: Alpha::default(),
            keep: Keep::default(),
            built_in_views: 48,
            built_in_side: 128,
            allow_outside: false,
        }
    }
}

impl Default for RunConfig {
    fn default() -> Self {
        Self {
            steps: 2000,
            plan: Vec::new(),
            seed: 0,
            tiles_per_step: 16,
            tile_size: 64,
            tiles_per_view: 1,
            coarse: 0.7,
            evaluate_every: 1000,
            evaluate_views: 0,
            checkpoint_every: 250,
            log_every: 10,
            tensorboard: false,
        }
    }
}

impl RunConfig {
    /// The part of the run that is done before `step`, 0 to 1. Learning rates and growth follow it.
    ///
    /// Each entry of the plan spreads the rest of the run evenly over the remaining steps.
    #[must_use]
    pub fn share(&self, step: u32) -> f64 {
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
        self.plan.push([step, steps]);
        self.steps = steps;
    }
}

impl Default for LossConfig {
    fn default() -> Self {
        Self { ssim_weight: 0.2, distortion_weight: 0.0 }
    }
}

impl Default for ShapeConfig {
    fn default() -> Self {
        let grid = GridConfig {
            levels: 8,
            features: 2,
            log2_table: 14,
            base_resolution: 16.0,
            growth: 1.35,
        };
        Self {
            sh_degree: 2,
            material: 8,
            extra: 2,
            step: 0.05,
            contraction: Contraction::None,
            blur: 0.3,
            color_mlp: MlpConfig { hidden: vec![32, 32] },
            transmittance_mlp: MlpConfig { hidden: vec![32, 32] },
            color_grid: grid.clone(),
            transmittance_grid: grid,
        }
    }
}

impl Default for StartConfig {
    fn default() -> Self {
        Self { path: None, gaussians: 12_000, opacity: 0.1, scale: 1.0, spread: 0.1 }
    }
}

impl Default for GrowthConfig {
    fn default() -> Self {
        Self {
            max_gaussians: 30_000,
            every: 100,
            begin: 0.1,
            end: 0.8,
            rate: 0.1,
            min_opacity: 0.005,
        }
    }
}

impl TrainConfig {
    /// Every setting as `table.name` with its value, in the order and with the digits of the file.
    pub(super) fn list(&self) -> Vec<(String, String)> {
        fn walk(prefix: &str, value: &toml::Value, found: &mut Vec<(String, String)>) {
            match value {
                toml::Value::Table(table) => {
                    for (key, value) in table {
                        let name =
                            if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                        walk(&name, value, found);
                    }
                }
                value => found.push((prefix.to_owned(), value.to_string())),
            }
        }
        let mut found = Vec::new();
        // through the text: there an `f32` of 0.2 is 0.2, and not the f64 nearest to it
        if let Ok(table) = toml::from_str(&self.to_toml()) {
            walk("", &toml::Value::Table(table), &mut found);
        }
        found
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
            blur: shape.blur,
            background,
            aabb,
            contraction: shape.contraction,
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
        let mut found: toml::Table = toml::from_str(&text).unwrap_or_default();
        // reading the file has already reported wrong values of retired settings
        let _ = retired::replace(&mut found);
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
