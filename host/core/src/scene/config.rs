//! The configuration of a scene: the `config` metadata of its file.

use std::path::Path;

pub use organza_shaders::limits::{MAX_HIDDEN_WIDTH, MAX_SAMPLES, MAX_SH_DEGREE, MAX_VECTOR};
pub use organza_shaders::slope::VALUES as SLOPE;
use serde::{Deserialize, Serialize};

use super::grid::GridConfig;
use super::placement::Placement;
use super::trained_on::TrainedOn;
use crate::error::{Error, Result, bad_config};

/// Largest number of hidden layers in a network.
pub const MAX_HIDDEN_LAYERS: usize = 4;
/// Outputs of the color network: red, green, blue.
pub const COLOR_OUTPUTS: usize = 3;
/// Outputs of the transmittance network: one logit.
pub const TRANSMITTANCE_OUTPUTS: usize = 1;

/// Length of the unit cube's diagonal: the longest possible segment.
const DIAGONAL: f64 = 1.732_050_807_568_877_2;

/// Most cells along a side of the occupancy grid.
pub const MAX_OCCUPANCY: u32 = 256;

/// Whether a field is left out of the file.
fn is_zero(value: &u32) -> bool {
    *value == 0
}

/// Everything in a scene but its tensors. Fields have the same names in the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SceneConfig {
    /// Degree of the spherical harmonics of the view direction, 0 to [`MAX_SH_DEGREE`].
    pub sh_degree: u32,
    /// Length of each Gaussian's material vector, 0 to [`MAX_VECTOR`].
    pub material: u32,
    /// Length of each Gaussian's extra vector, 0 to [`MAX_VECTOR`].
    pub extra: u32,
    /// Length of each Gaussian's slope: [`SLOPE`] where colors vary within a Gaussian, 0 where they do not. A file without this
    /// field has 0, and no tensor of slopes.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub slope: u32,
    /// Length of each Gaussian's shape: 1 where falloffs have shapes, 0 where all are a Gaussian's. A file without this field has 0,
    /// and no tensor of shapes.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub shape: u32,
    /// The hash grid of the color network.
    pub color_grid: GridConfig,
    /// The hash grid of the transmittance network.
    pub transmittance_grid: GridConfig,
    /// The color network.
    pub color_mlp: MlpConfig,
    /// The transmittance network.
    pub transmittance_mlp: MlpConfig,
    /// Length of a transmittance step (sigma), in units of the unit cube.
    pub step: f64,
    /// Cells along a side of the occupancy grid: a ray loses light only in cells with Gaussians. Up to [`MAX_OCCUPANCY`]; 0 is
    /// no grid, so networks alone decide T. A file without this field has 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub occupancy: u32,
    /// Added to the diagonal of each projected covariance, in square pixels.
    pub blur: f64,
    /// Whether the blur keeps a Gaussian's total weight: a Gaussian that becomes wider becomes fainter. A file without this
    /// field has `false`. `docs/pipeline.md` has the equation.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub antialiased: bool,
    /// Background color: red, green, blue.
    pub background: [f64; 3],
    /// The scene's box, `[lo, hi]`, in its own coordinates.
    pub aabb: [[f64; 3]; 2],
    /// Treatment of space outside this box. A file without this field has [`Contraction::None`].
    #[serde(default, skip_serializing_if = "Contraction::is_none")]
    pub contraction: Contraction,
    /// Where the scene lies in the world. A file without this field has the world's own coordinates.
    #[serde(default, skip_serializing_if = "Placement::is_identity")]
    pub placement: Placement,
    /// The photographs that the scene was trained on. A file without this field does not say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trained_on: Option<TrainedOn>,
}

/// Treatment of space outside the scene's box. `docs/pipeline.md` has the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Contraction {
    /// Rays end at the unit cube, and the grids extend their border values.
    #[default]
    None,
    /// All of space is contracted into the unit cube, as in Mip-NeRF 360. Rays are sampled from end to end, more
    /// coarsely farther from the box.
    Cube,
}

impl Contraction {
    /// Whether this is [`Contraction::None`].
    pub fn is_none(&self) -> bool {
        *self == Self::None
    }

    /// The value that kernels read: 0 or 1.
    pub fn for_kernels(self) -> u32 {
        u32::from(!self.is_none())
    }
}

/// The shape of a network: ReLU hidden layers and a linear output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MlpConfig {
    /// Widths of the hidden layers: 1 to [`MAX_HIDDEN_LAYERS`] of 1 to [`MAX_HIDDEN_WIDTH`].
    pub hidden: Vec<u32>,
}

impl SceneConfig {
    /// Parses and validates JSON: the `config` metadata of the file `origin`. Unknown fields are ignored.
    ///
    /// # Errors
    /// [`Error::BadJson`] if the text is not JSON of the right structure; [`Error::BadConfig`] if a value is out of
    /// range.
    pub fn from_json(text: &str, origin: impl AsRef<Path>) -> Result<Self> {
        let origin = origin.as_ref();
        let config: Self = serde_json::from_str(text).map_err(|error| {
            let what = match error.is_data() {
                true => "JSON of the `config` metadata",
                false => "the file is damaged, so copy it again: JSON of the `config` metadata",
            };
            Error::json(origin, what, text.as_bytes(), &error)
        })?;
        config.validate().map_err(|error| error.in_file(origin))?;
        Ok(config)
    }

    /// JSON that [`SceneConfig::from_json`] parses.
    pub fn to_json(&self) -> Result<String> {
        serde_json::to_string(self).map_err(|error| Error::Argument { reason: error.to_string() })
    }

    /// Number of spherical harmonics, `(sh_degree + 1)^2`.
    pub fn sh_width(&self) -> usize {
        (self.sh_degree as usize).saturating_add(1).saturating_pow(2)
    }

    /// Inputs of the color network: spherical harmonics, hash grid, material, in that order.
    pub fn color_inputs(&self) -> usize {
        self.sh_width()
            .saturating_add(self.color_grid.width())
            .saturating_add(self.material as usize)
    }

    /// Inputs of the transmittance network: hash grid, extra, in that order.
    pub fn transmittance_inputs(&self) -> usize {
        self.transmittance_grid.width().saturating_add(self.extra as usize)
    }

    /// Widths of the color network: its inputs, its hidden layers, its outputs.
    pub fn color_widths(&self) -> Vec<usize> {
        self.color_mlp.widths(self.color_inputs(), COLOR_OUTPUTS)
    }

    /// Widths of the transmittance network: its inputs, its hidden layers, its output.
    pub fn transmittance_widths(&self) -> Vec<usize> {
        self.transmittance_mlp.widths(self.transmittance_inputs(), TRANSMITTANCE_OUTPUTS)
    }

    /// Checks that every field is in range.
    ///
    /// # Errors
    /// [`Error::BadConfig`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        let at_most = |max: u32, field, value: u32| match value > max {
            true => bad_config(field, format!("is {value}, expected 0 to {max}")),
            false => Ok(()),
        };
        at_most(MAX_SH_DEGREE, "sh_degree", self.sh_degree)?;
        for (field, length) in self.vector_lengths() {
            at_most(MAX_VECTOR, field, length)?;
        }
        if self.slope != 0 && self.slope != SLOPE {
            return bad_config("slope", format!("is {}, expected 0 or {SLOPE}", self.slope));
        }
        if self.shape > 1 {
            return bad_config("shape", format!("is {}, expected 0 or 1", self.shape));
        }
        self.color_grid.check("color_grid")?;
        self.transmittance_grid.check("transmittance_grid")?;
        self.color_mlp.check("color_mlp")?;
        self.transmittance_mlp.check("transmittance_mlp")?;
        self.check_step()?;
        at_most(MAX_OCCUPANCY, "occupancy", self.occupancy)?;
        let Self { blur, background, .. } = self;
        if !(*blur >= 0.0 && fits_f32(*blur)) {
            let reason = format!("is {blur}, expected a finite number of at least 0");
            return bad_config("blur", reason);
        }
        if !background.iter().copied().all(fits_f32) {
            let reason = format!("is {background:?}, expected three finite numbers");
            return bad_config("background", reason);
        }
        self.check_aabb()?;
        self.placement.check()
    }

    fn check_step(&self) -> Result<()> {
        // The comparison must fail for NaN too.
        let allowed = self.step > 0.0
            && fits_f32(self.step)
            && (DIAGONAL / self.step).ceil() <= f64::from(MAX_SAMPLES);
        if allowed {
            return Ok(());
        }
        let smallest = DIAGONAL / f64::from(MAX_SAMPLES);
        bad_config(
            "step",
            format!(
                "is {}, expected a finite number of at least {smallest:.4e}: a ray across the unit \
             cube may take at most {MAX_SAMPLES} samples, ceil(sqrt(3) / step)",
                self.step
            ),
        )
    }

    fn check_aabb(&self) -> Result<()> {
        let [lo, hi] = self.aabb;
        for (axis, (lo, hi)) in lo.into_iter().zip(hi).enumerate() {
            // In f32, as the kernels see it: a thinner box would divide by zero there.
            let expected = match lo < hi && ((hi - lo) as f32).is_normal() {
                _ if !(fits_f32(lo) && fits_f32(hi)) => "finite numbers",
                false => "lo < hi on every axis",
                true => continue,
            };
            let axis = ["x", "y", "z"][axis];
            return bad_config(
                "aabb",
                format!("spans {lo} to {hi} in {axis}, expected {expected}"),
            );
        }
        Ok(())
    }
}

impl MlpConfig {
    fn widths(&self, inputs: usize, outputs: usize) -> Vec<usize> {
        let hidden = self.hidden.iter().map(|&width| width as usize);
        std::iter::once(inputs).chain(hidden).chain([outputs]).collect()
    }

    fn check(&self, name: &str) -> Result<()> {
        let field = format!("{name}.hidden");
        let layers = self.hidden.len();
        let reason = if !(1..=MAX_HIDDEN_LAYERS).contains(&layers) {
            format!("has {layers} layers, expected 1 to {MAX_HIDDEN_LAYERS}")
        } else if let Some(width) =
            self.hidden.iter().find(|width| !(1..=MAX_HIDDEN_WIDTH).contains(*width))
        {
            format!("has a layer {width} wide, expected 1 to {MAX_HIDDEN_WIDTH}")
        } else {
            return Ok(());
        };
        bad_config(field, reason)
    }
}

/// Whether the kernels, which compute in f32, can represent a number.
fn fits_f32(value: f64) -> bool {
    (value as f32).is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BASIC: &str = r#"{"sh_degree": 3, "material": 8, "extra": 2,
        "color_grid": {"levels": 6, "features": 2, "log2_table": 11, "base_resolution": 8,
            "growth": 1.7},
        "transmittance_grid": {"levels": 5, "features": 2, "log2_table": 11,
            "base_resolution": 8.5, "growth": 1.7},
        "color_mlp": {"hidden": [32, 16]}, "transmittance_mlp": {"hidden": [32]},
        "step": 0.06, "blur": 0.3, "background": [0.129, 0.499, 0.601],
        "aabb": [[-1.5, -1.2, -1.0], [1.5, 1.2, 1.4]], "a later field": {"ignored": true}}"#;

    fn basic() -> SceneConfig {
        SceneConfig::from_json(BASIC, "a.safetensors").unwrap()
    }

    #[test]
    fn reads_every_field() {
        let config = basic();
        assert_eq!(config.transmittance_grid.base_resolution, 8.5);
        assert_eq!((config.sh_width(), config.color_inputs()), (16, 16 + 12 + 8));
        assert_eq!(config.transmittance_inputs(), 10 + 2);
        assert_eq!(config.color_widths(), [36, 32, 16, 3]);
        assert_eq!(config.transmittance_widths(), [12, 32, 1]);
        let text = serde_json::to_string(&config).unwrap();
        assert_eq!(SceneConfig::from_json(&text, "b").unwrap(), config);
    }

    /// Files may lack the newer fields. A default value is not written.
    #[test]
    fn newer_fields_can_be_missing() {
        let usual = basic();
        assert!(usual.contraction.is_none() && !usual.antialiased);
        assert!(usual.placement.is_identity());
        let usual = serde_json::to_string(&usual).unwrap();
        let offset = [512_345.25, 4_612_345.5, 312.0];
        let placement = Placement { offset, scale: 0.1, meters: Some(0.3), ..Placement::default() };
        for (field, value, config) in [
            ("contraction", "\"cube\"", SceneConfig { contraction: Contraction::Cube, ..basic() }),
            ("antialiased", "true", SceneConfig { antialiased: true, ..basic() }),
            ("slope", "9", SceneConfig { slope: SLOPE, ..basic() }),
            ("shape", "1", SceneConfig { shape: 1, ..basic() }),
            ("placement", "{", SceneConfig { placement, ..basic() }),
            ("trained_on", "{", SceneConfig { trained_on: Some(TrainedOn::default()), ..basic() }),
        ] {
            assert!(!usual.contains(field), "{usual}");
            let text = serde_json::to_string(&config).unwrap();
            assert!(text.contains(&format!("\"{field}\":{value}")), "{text}");
            assert_eq!(SceneConfig::from_json(&text, "b").unwrap(), config);
        }
    }

    #[test]
    fn step_is_limited_by_samples() {
        let smallest = DIAGONAL / f64::from(MAX_SAMPLES);
        assert!(SceneConfig { step: smallest, ..basic() }.validate().is_ok());
        let error = SceneConfig { step: smallest * 0.999, ..basic() }.validate().unwrap_err();
        assert!(error.to_string().contains("16384"), "{error}");
        assert!(error.to_string().contains("1.0572e-4"), "{error}");
    }

    #[test]
    fn each_field_is_held_to_its_range() {
        type Change = fn(&mut SceneConfig);
        let changes: [(&str, Change); 23] = [
            ("sh_degree", |config| config.sh_degree = 8),
            ("material", |config| config.material = 257),
            ("occupancy", |config| config.occupancy = MAX_OCCUPANCY + 1),
            ("slope", |config| config.slope = SLOPE - 1),
            ("shape", |config| config.shape = 2),
            ("extra", |config| config.extra = u32::MAX),
            ("color_grid.levels", |config| config.color_grid.levels = 0),
            ("transmittance_grid.growth", |config| config.transmittance_grid.growth = 0.5),
            ("color_mlp.hidden", |config| config.color_mlp.hidden.clear()),
            ("color_mlp.hidden", |config| config.color_mlp.hidden = vec![8; 5]),
            ("transmittance_mlp.hidden", |config| config.transmittance_mlp.hidden = vec![0]),
            ("transmittance_mlp.hidden", |config| config.transmittance_mlp.hidden = vec![129]),
            ("step", |config| config.step = 0.0),
            ("step", |config| config.step = f64::NAN),
            ("step", |config| config.step = f64::INFINITY),
            ("blur", |config| config.blur = -0.1),
            ("background", |config| config.background[1] = f64::NAN),
            ("aabb", |config| config.aabb[1][2] = config.aabb[0][2]),
            ("aabb", |config| config.aabb[0][0] = f64::NEG_INFINITY),
            ("placement", |config| config.placement.scale = 0.0),
            ("placement", |config| config.placement.meters = Some(-1.0)),
            ("placement", |config| config.placement.offset[1] = f64::INFINITY),
            ("placement", |config| config.placement.right = [1.0, 0.0, 0.1]),
        ];
        for (expected, change) in changes {
            let mut config = basic();
            change(&mut config);
            let error = config.validate().unwrap_err();
            assert!(
                matches!(&error, Error::BadConfig { field, .. } if field == expected),
                "{error}"
            );
            assert!(error.to_string().contains(expected), "{error}");
        }
    }

    #[test]
    fn json_errors_say_where() {
        let bad = [
            (BASIC.replace("\"step\": 0.06,", ""), "missing field `step`"),
            (BASIC.replace("0.06", "\"small\""), "\"step\": \"small\""),
            (BASIC.replace("\"blur\"", "\"contraction\": \"sphere\", \"blur\""), "`sphere`"),
            (BASIC.replace("\"material\": 8", "\"material\": -8"), "\"material\": -8"),
            (BASIC.replace("0.06", "NaN"), "\"step\": N"),
            (BASIC.replace("0.06", "1e999"), "out of range"),
            (BASIC[..100].to_owned(), "EOF"),
        ];
        for (text, expected) in bad {
            let error = SceneConfig::from_json(&text, "a.safetensors").unwrap_err();
            assert!(matches!(error, Error::BadJson { .. }), "{error}");
            let error = error.to_string();
            assert!(error.contains(expected) && error.contains("a.safetensors"), "{error}");
        }
    }
}
