//! The table of settings. A setting is one row: everything else follows from it.
//!
//! The struct of its group, its default, the check of its range, the option of `organza train`, the list of
//! `organza help train`, and the line in `docs/training.md` are made from the row.

use std::fmt::Display;
use std::ops::{RangeBounds, RangeFrom, RangeInclusive};
use std::path::PathBuf;

use organza_core::gaussian_tensors;
use serde::{Deserialize, Serialize, Serializer};

use super::LearnExposure;
use organza_core::scene::{Contraction, GridConfig, MlpConfig};
use organza_data::{Alpha, Background};

/// A learning rate that falls from the first step to the last by a constant factor per step. See also
/// [`OptimizerConfig::cooldown`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rate {
    /// Rate at the first step.
    pub first: f64,
    /// Rate at the last step, without the cooldown.
    pub last: f64,
}

/// A setting, for people to read.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Setting {
    /// Group and name, such as `run.steps`.
    pub name: &'static str,
    /// Meaning: a sentence, and perhaps more.
    doc: &'static str,
    /// The option of `organza train` that sets it, as its help shows it: `--steps <N>`. Empty without one.
    pub option: &'static str,
    /// The part of the documentation that explains it, as a link from `docs/training.md`. Empty without one.
    pub see: &'static str,
}

impl Setting {
    /// Meaning in one line, without the last period.
    #[must_use]
    pub fn text(&self) -> &'static str {
        let text = self.doc.trim();
        text.strip_suffix('.').unwrap_or(text)
    }

    /// Whether it is for experiments alone: help and tables leave it out.
    #[must_use]
    pub fn is_hidden(&self) -> bool {
        self.name.starts_with("ablation.")
    }
}

/// The optional parts of a row.
macro_rules! or_empty {
    () => {
        ""
    };
    ($text:literal) => {
        $text
    };
}

/// Makes everything of the table.
///
/// A row is `name: Type = default;` or `name: Type = default, in range;`. Before it stand its meaning as a comment,
/// `#[option("--name <VALUE>")]` if `organza train` has an option for it, `#[see("page.md#part")]` if the documentation
/// says more, and attributes for serde.
macro_rules! settings {
    ($(
        $(#[doc = $group_doc:expr])+
        $group:ident: $Group:ident {
            $(
                $(#[doc = $doc:expr])+
                $(#[option($option:literal)])?
                $(#[see($see:literal)])?
                $(#[serde($($serde:tt)*)])?
                $name:ident: $type:ty = $default:expr $(, in $range:expr)?;
            )+
        }
    )+) => {
        /// All settings of a run. Names are those in the file. A setting that the file leaves out has its default.
        ///
        /// ```
        /// use organza_train::TrainConfig;
        ///
        /// let mut config = TrainConfig::default();
        /// config.run.steps = 500;
        /// config.densification.max_gaussians = 20_000;
        /// let text = config.to_toml();
        /// assert_eq!(TrainConfig::parse(&text, "config.toml".as_ref())?, config);
        /// # Ok::<(), organza_core::Error>(())
        /// ```
        #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        #[non_exhaustive]
        pub struct TrainConfig {
            $($(#[doc = $group_doc])+ pub $group: $Group,)+
        }

        $(
            $(#[doc = $group_doc])+
            #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
            #[serde(deny_unknown_fields, default)]
            #[non_exhaustive]
            pub struct $Group {
                $(
                    $(#[doc = $doc])+
                    $(#[serde($($serde)*)])?
                    pub $name: $type,
                )+
            }

            impl Default for $Group {
                fn default() -> Self {
                    Self { $($name: $default,)+ }
                }
            }
        )+

        /// Every setting, in the order of the file.
        pub const SETTINGS: &[Setting] = &[$($(Setting {
            name: concat!(stringify!($group), ".", stringify!($name)),
            doc: concat!($($doc),+),
            option: or_empty!($($option)?),
            see: or_empty!($($see)?),
        },)+)+];

        impl TrainConfig {
            /// The first value that is out of its range, as a sentence.
            pub(super) fn check_ranges(&self) -> Result<(), String> {
                $($($(
                    within(concat!(stringify!($group), ".", stringify!($name)), self.$group.$name, $range)?;
                )?)+)+
                Ok(())
            }
        }
    };
}

/// The table, with a learning rate for each tensor of the Gaussians.
macro_rules! define {
    ($($(#[doc = $doc:literal])+ $tensor:ident: $row:tt, $why:literal, [$first:literal, $last:literal];)+) => {
        settings! {
            /// The photographs.
            data: DataConfig {
                /// The data set. Without one, the built-in scene.
                #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_text")]
                path: Option<PathBuf> = None;
                /// Shrink photographs by this factor. Without it, `organza train` shrinks large ones if its steps would draw less
                /// than all of their pixels.
                #[option("--downscale <N>")]
                downscale: u32 = 1, in 1..;
                /// Hold out every Nth frame, starting with the first; 0: none.
                #[option("--hold-out-every <N>")]
                hold_out_every: usize = 8;
                /// Number of neighboring frames to hold out together: every Nth stretch of so many.
                #[see("data.md#held-out-frames")]
                hold_out_length: usize = 1, in 1..;
                /// Color behind the scene, and behind photographs with an alpha channel: a name such as white, or red,
                /// green and blue from 0 to 1 such as 1,1,1. `auto` chooses.
                #[option("--background <COLOR>")]
                #[see("data.md#background")]
                background: Background = Background::Auto;
                /// Use of an alpha channel: with `background`, the background shows through; with `mask`, pixels below one
                /// half are hidden.
                alpha: Alpha = Alpha::default();
                /// Views of the built-in scene.
                built_in_views: u32 = 48, in 2..=1000;
                /// Width and height of these views.
                built_in_side: u32 = 128, in 16..=2048;
                /// Read files that the data set names outside its own folder.
                #[option("--allow-outside")]
                #[serde(skip_serializing_if = "std::ops::Not::not")]
                allow_outside: bool = false;
            }

            /// The run's length, the size of a step, and how often something is written.
            run: RunConfig {
                /// Number of training steps; 0: chosen from the photographs and the device.
                #[option("--steps <N>")]
                #[see("#number-of-steps")]
                steps: u32 = 0;
                /// The schedule of `--minutes`: pairs of a step and the number of all steps that was chosen there.
                schedule: Vec<[u32; 2]> = Vec::new();
                /// Seed of all random choices.
                #[option("--seed <N>")]
                seed: u64 = 0;
                /// K, tiles per step.
                #[option("--tiles-per-step <K>")]
                tiles_per_step: u32 = 16, in 1..;
                /// S, side of a tile in pixels.
                #[option("--tile-size <S>")]
                tile_size: u32 = 64, in 1..=512;
                /// Draw this many neighboring tiles from each image: a Gaussian that several of them show is evaluated
                /// once.
                tiles_per_view: u32 = 1, in 1..;
                /// First part of the run, with photographs of half their size and steps of T twice as long.
                #[see("#coarse-to-fine")]
                coarse: f64 = 0.7, in 0.0..=1.0;
                /// Steps of T where the occupancy grid is less full than this are samples only by chance; 0: never.
                #[see("#roulette")]
                roulette: f64 = 0.25, in 0.0..=1.0;
                /// Rays with a smaller |dL/dlog T| than this have a gradient only by chance; in the weight of a pixel in the
                /// loss; 0: never.
                #[see("#roulette")]
                gradient_roulette: f64 = 0.1, in 0.0..=1000.0;
                /// Steps between evaluations on the held-out views; 0: only at the end.
                #[option("--evaluate-every <N>")]
                evaluate_every: u32 = 1000;
                /// Number of held-out views that these evaluations measure; 0: all, as at the end.
                evaluate_views: u32 = 0;
                /// Steps between checkpoints.
                #[option("--checkpoint-every <N>")]
                checkpoint_every: u32 = 250, in 1..;
                /// Steps between `step` records of the log.
                log_every: u32 = 10, in 1..;
            }

            /// The loss `(1 - w) L1 + w (1 - SSIM)`.
            loss: LossConfig {
                /// w, the weight of SSIM.
                ssim_weight: f32 = 0.2, in 0.0..=1.0;
            }

            /// The exposure of each photograph.
            exposure: ExposureConfig {
                /// Learn each photograph's exposure: a gain and an offset for each channel. `auto`: if they differ by
                /// more than 12%.
                #[see("#exposure")]
                learn: LearnExposure = LearnExposure::Auto;
            }

            /// The poses of the photographs' cameras.
            poses: PosesConfig {
                /// Also learn the cameras' poses: for poses that are a little off.
                #[option("--refine-poses")]
                #[see("#poses")]
                refine: bool = false;
            }

            /// The shape of the scene: see [`SceneConfig`](organza_core::scene::SceneConfig).
            scene: ShapeConfig {
                /// D, degree of the spherical harmonics: how finely colors change with the view direction.
                #[option("--sh-degree <N>")]
                sh_degree: u32 = 2;
                /// Length of a Gaussian's material vector.
                material: u32 = 8;
                /// Length of a Gaussian's extra vector.
                extra: u32 = 2;
                /// Length of a Gaussian's slope: 9 lets its color vary from one side to the other, with 0 it is the same
                /// everywhere.
                #[see("pipeline.md#colors-that-vary-within-a-gaussian")]
                slope: u32 = 9;
                /// Length of a Gaussian's shape: 1 lets its falloff become flatter, nearly a disc, or more pointed; with 0, all are
                /// Gaussians.
                #[see("pipeline.md#shapes-of-falloffs")]
                shape: u32 = 1;
                /// sigma, length of a transmittance step in the unit cube.
                step: f64 = 0.05;
                /// Cells along a side of the unit cube in which a Gaussian must be, or a ray loses no light there: 0 to 256.
                /// With 0, T is everywhere what its networks say.
                #[see("pipeline.md#occupancy")]
                occupancy: u32 = 32;
                /// Space outside the scene's box: `none` ends rays there, `cube` contracts it.
                #[see("pipeline.md#contraction")]
                contraction: Contraction = Contraction::None;
                /// Added to the diagonal of projected covariances, in square pixels.
                blur: f64 = 0.3;
                /// Let the blur widen Gaussians without making them heavier: thin things look alike in images of all
                /// sizes.
                #[see("pipeline.md#projection-and-support")]
                antialiased: bool = true;
                /// The color network: widths of its hidden layers.
                color_mlp: MlpConfig = MlpConfig { hidden: vec![32, 32] };
                /// The transmittance network: widths of its hidden layers.
                transmittance_mlp: MlpConfig = MlpConfig { hidden: vec![32, 32] };
                /// The color network's hash grid: levels, features per entry, log2 of a level's largest number of
                /// entries, cells along a side of the coarsest level, and how much finer each level is than the one
                /// before.
                color_grid: GridConfig = grid();
                /// The transmittance network's hash grid.
                transmittance_grid: GridConfig = grid();
            }

            /// Where training starts.
            start: StartConfig {
                /// Start with the Gaussians of a .ply, .spz, .sog, .glb or .splat file, instead of points.
                #[option("--start <FILE>")]
                #[see("splats.md#import")]
                #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_text")]
                path: Option<PathBuf> = None;
                /// Number of first Gaussians if the data set has no points. If it has, there is one at each, up to
                /// `densification.max_gaussians`.
                gaussians: u32 = 12_000, in 1..;
                /// Their opacity.
                opacity: f32 = 0.1, in 1e-4..=0.9999;
                /// Their scale, as a multiple of the distance to the nearest neighbors; half of that if the data set has
                /// no points.
                scale: f32 = 1.0, in 1e-4..=1e4;
                /// Half the range of the random material and extra values.
                spread: f32 = 0.1, in 0.0..=1e3;
            }

            /// Adam (Kingma and Ba) and its learning rates. The rates of `position` and of a pose's shift are parts of half
            /// the scene box's longest side.
            optimizer: OptimizerConfig {
                /// Adam's beta1.
                beta1: f64 = 0.9, in 0.0..=0.999_999;
                /// Adam's beta2.
                beta2: f64 = 0.99, in 0.0..=0.999_999_9;
                /// Last part of the run, in which all learning rates also fall linearly, to a fiftieth; 0: none.
                // Values that noise has moved settle: Hägele et al. 2024, "Scaling Laws and Compute-Optimal Training Beyond
                // Fixed Training Durations".
                cooldown: f64 = 0.3, in 0.0..=1.0;
                /// Weight decay of the transmittance network's grid: each step multiplies its values by 1 minus this
                /// times their learning rate.
                // AdamW, Loshchilov and Hutter 2019. Space stays empty unless photographs ask for more.
                transmittance_decay: f64 = 1.0, in 0.0..=1.0;
                /// Train T, that is its network, its grid and the extra values, at every Nth step only.
                transmittance_every: u32 = 2, in 1..=1_000;
                $(
                    #[doc = concat!("Learning rate of `gaussians.", stringify!($tensor), "`.")]
                    $tensor: Rate = Rate { first: $first, last: $last };
                )+
                /// Learning rate of both hash grids.
                grids: Rate = Rate { first: 1e-2, last: 1e-2 };
                /// Learning rate of both networks.
                networks: Rate = Rate { first: 5e-3, last: 5e-3 };
                /// Learning rate of exposures.
                exposure: Rate = Rate { first: 1e-2, last: 1e-3 };
                /// Learning rate of poses: radians for rotations; half the longest side of the scene's box for shifts.
                pose: Rate = Rate { first: 3e-4, last: 3e-5 };
            }

            /// How the number of Gaussians changes: Gaussians with the strongest gradient of their center are split,
            /// and transparent ones are removed.
            densification: DensificationConfig {
                /// Largest number of Gaussians, also of the first ones; 0: chosen from the photographs, the steps and the
                /// device.
                #[option("--max-gaussians <N>")]
                #[see("#number-of-gaussians")]
                max_gaussians: u32 = 0;
                /// Steps between changes.
                every: u32 = 100, in 1..;
                /// First change, as a fraction of all steps.
                begin: f64 = 0.1, in 0.0..=1.0;
                /// Last change, as a fraction of all steps; 0: none.
                end: f64 = 0.8, in 0.0..=1.0;
                /// Gaussians that a change adds, as a fraction of all.
                rate: f64 = 0.1, in 0.0..=1.0;
                /// Gaussians less opaque than this are removed.
                min_opacity: f32 = 0.005, in 0.0..=0.5;
            }

            /// Parts that experiments leave out, to measure what they are worth.
            ablation: AblationConfig {
                /// Learn T. If false, T is 1 everywhere.
                learn_transmittance: bool = true;
                /// Divide sums with a weight above 1 (Eq. 13). If false, the run never divides, not even in its
                /// evaluations. A scene file does not record it: every other command divides.
                divide: bool = true;
            }
        }
    };
}

gaussian_tensors!(define);

/// The hash grids of a new scene.
fn grid() -> GridConfig {
    GridConfig { levels: 8, features: 2, log2_table: 14, base_resolution: 16.0, growth: 1.35 }
}

/// A path as messages show it: text holds no other bytes than UTF-8. [`TrainConfig::validate`] refuses them.
fn as_text<S: Serializer>(path: &Option<PathBuf>, serializer: S) -> Result<S::Ok, S::Error> {
    path.as_ref().map(|path| path.display().to_string()).serialize(serializer)
}

/// The values that a setting can have.
pub(super) trait Range<T>: RangeBounds<T> {
    /// The range in words.
    fn expected(&self) -> String;
}

impl<T: Display> Range<T> for RangeInclusive<T> {
    fn expected(&self) -> String {
        format!("{} to {}", self.start(), self.end())
    }
}

impl<T: Display> Range<T> for RangeFrom<T> {
    fn expected(&self) -> String {
        format!("{} or more", self.start)
    }
}

/// Checks a value in its own type, so that messages show the file's digits.
pub(super) fn within<T: Copy + PartialOrd + Display>(
    name: &str,
    value: T,
    range: impl Range<T>,
) -> Result<(), String> {
    match range.contains(&value) {
        true => Ok(()),
        false => Err(format!("`{name}` is {value}, expected {}", range.expected())),
    }
}
