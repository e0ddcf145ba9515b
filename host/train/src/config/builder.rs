//! Combines settings from several places, and the presets, which are part of the program.

use std::path::Path;

use serde::Deserialize;
use toml::Table;

use super::assignment::{self, merge};
use super::table::within;
use super::{MAX_BYTES, TrainConfig};
use organza_core::error::{Error, Result};
use organza_core::input::read_text;
use organza_core::tile::max_tiles;

/// Combines settings. A later call overrides earlier ones. A setting that no call sets has its default.
///
/// ```
/// use organza_train::{ConfigBuilder, Preset};
///
/// # fn main() -> organza_core::Result<()> {
/// let config = ConfigBuilder::new(Preset::Fast)?.set("densification.end=0")?.build()?;
/// # assert_eq!(config.densification.end, 0.0);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct ConfigBuilder {
    /// Every setting.
    table: Table,
    /// The settings that calls have set.
    given: Table,
}

impl ConfigBuilder {
    /// Starts with the settings of a preset.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`]. An error means that a file of the program is wrong.
    pub fn new(preset: Preset) -> Result<Self> {
        Self::from_config(&TrainConfig::default())
            .text(preset.toml(), Path::new(&format!("the preset {}", preset.name())))
    }

    /// Starts with given settings.
    #[must_use]
    pub fn from_config(config: &TrainConfig) -> Self {
        let table = Table::try_from(config).expect("plain tables of numbers and strings");
        Self { table, given: Table::new() }
    }

    /// Adds the settings of a file.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`].
    pub fn file(self, path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        self.text(&read_text(path, MAX_BYTES, "settings")?, path)
    }

    /// Adds the settings in a TOML text. Errors call it `origin`.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`].
    pub fn text(mut self, text: &str, origin: &Path) -> Result<Self> {
        let invalid = |reason| Error::Invalid { origin: origin.to_owned(), reason };
        // only this text has line numbers
        let at_line = |error: toml::de::Error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            format!("line {line}: {}", error.message())
        };
        let table: Table = toml::from_str(text).map_err(|error| invalid(at_line(error)))?;
        merge(&mut self.table, table.clone());
        merge(&mut self.given, table.clone());
        let config = self.parse().map_err(|reason| {
            let alone = toml::from_str::<TrainConfig>(text).err();
            // a setting that the text leaves out is not missing
            let alone = alone.filter(|error| !error.message().starts_with("missing field"));
            invalid(alone.map_or(reason, at_line))
        })?;
        config.check().map_err(invalid)?;
        assignment::check_names(&table).map_err(invalid)?;
        Ok(self)
    }

    /// Sets one value. The assignment has the form `key=value`, for example `run.steps=3000`. The key is the
    /// setting's table and name. Text needs no quotes, and a list no brackets. A learning rate is two numbers,
    /// `first,last`, or one for both.
    ///
    /// [`ConfigBuilder::build`] checks the value's range.
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is no such setting, or if the value is not of its type.
    pub fn set(mut self, assignment: &str) -> Result<Self> {
        let table = assignment::parse(assignment).map_err(invalid)?;
        merge(&mut self.table, table.clone());
        merge(&mut self.given, table);
        Ok(self)
    }

    /// Whether a preset, a file or a call has set the setting `name` of a group.
    #[must_use]
    pub fn has(&self, group: &str, name: &str) -> bool {
        self.given.get(group).is_some_and(|group| group.get(name).is_some())
    }

    /// Returns the combined settings.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a value out of range.
    pub fn build(self) -> Result<TrainConfig> {
        let config = self.parse().map_err(invalid)?;
        config.validate()?;
        Ok(config)
    }

    fn parse(&self) -> Result<TrainConfig, String> {
        TrainConfig::deserialize(self.table.clone()).map_err(|error| error.message().to_owned())
    }
}

/// An error about settings that are in no file.
fn invalid(reason: String) -> Error {
    Error::Invalid { origin: Path::new("").to_owned(), reason }
}

/// A settings file that is part of the program: `host/train/presets/NAME.toml`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preset {
    /// A first look, in a fraction of the time.
    Fast,
    /// The defaults of all settings.
    #[default]
    Default,
    /// An hour or more: more steps, more Gaussians, finer colors.
    Best,
    /// For the built-in scene.
    BuiltIn,
}

impl Preset {
    /// Every preset.
    pub const ALL: [Self; 4] = [Self::Fast, Self::Default, Self::Best, Self::BuiltIn];

    /// Name of the preset and of its file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Default => "default",
            Self::Best => "best",
            Self::BuiltIn => "built-in",
        }
    }

    /// Text of the preset's file, TOML. Settings that it leaves out have their default.
    #[must_use]
    pub const fn toml(self) -> &'static str {
        match self {
            Self::Fast => include_str!("../../presets/fast.toml"),
            Self::Default => include_str!("../../presets/default.toml"),
            Self::Best => include_str!("../../presets/best.toml"),
            Self::BuiltIn => include_str!("../../presets/built-in.toml"),
        }
    }
}

impl TrainConfig {
    /// Checks all values, also if they were set in code.
    ///
    /// # Errors
    /// [`Error::Invalid`] for the first value that is out of range, or that a settings file cannot hold.
    pub fn validate(&self) -> Result<()> {
        self.check().map_err(invalid)
    }

    /// Checks all values. The error is a sentence about the first one out of range.
    pub(crate) fn check(&self) -> Result<(), String> {
        for (name, path) in [("data", &self.data.path), ("start", &self.start.path)] {
            if let Some(path) = path.as_ref().filter(|path| path.to_str().is_none()) {
                return Err(format!(
                    "`{name}.path` is {}, whose name is not UTF-8, so that the settings of a run cannot hold it: rename it, or \
                     name a link to it",
                    path.display()
                ));
            }
        }
        self.check_ranges()?;
        for (name, value) in ["red", "green", "blue"].iter().zip(self.data.background.color()) {
            within(&format!("data.background, {name},"), value, 0.0..=1.0)?;
        }
        if self.data.hold_out_every == 1 {
            let reason = "`data.hold_out_every` is 1, which leaves nothing to train on; expected 2 or more, or 0 to hold no \
                          frame out";
            return Err(reason.to_owned());
        }
        self.check_schedule()?;
        self.check_scene()?;
        self.optimizer.check_rates()
    }

    /// Checks that kernels can address the scene, and that the scene is valid.
    fn check_scene(&self) -> Result<(), String> {
        let tiles = self.run.tiles_per_step;
        let side = self.run.tile_size;
        let max = max_tiles(side);
        if u64::from(tiles) > max {
            return Err(format!(
                "`run.tiles_per_step` is {tiles}, expected at most {max} of side {side}: the \
                 kernels address fewer than 2^31 values"
            ));
        }
        let scene = self.scene_config([0.0; 3], [[0.0; 3], [1.0; 3]]);
        scene.validate().map_err(|error| match error {
            Error::BadConfig { field, reason, .. } => format!("`scene.{field}` {reason}"),
            other => other.to_string(),
        })?;
        let gaussians = self.start.gaussians;
        let widest = self.scene.material.max(self.scene.extra).max(self.scene.slope).max(4);
        let max = ((1 << 31) - 1) / widest;
        within("start.gaussians", gaussians, 1..=max)
    }

    /// Checks that a run could have made this schedule.
    fn check_schedule(&self) -> Result<(), String> {
        let schedule = &self.run.schedule;
        let ascends =
            schedule.windows(2).all(|pair| pair[0][0] < pair[1][0] && pair[1][0] < pair[0][1]);
        let first = schedule.first().is_none_or(|entry| entry[0] == 0);
        if !ascends || !first || schedule.iter().any(|[step, steps]| step >= steps) {
            return Err("`run.schedule` is not a schedule of `--minutes`: its steps must ascend from 0, and each must be less \
                        than the number of all steps that was chosen there; remove it"
                .to_owned());
        }
        match schedule.last() {
            Some([_, steps]) if *steps != self.run.steps => Err(format!(
                "`run.schedule` ends with {steps} steps, but `run.steps` is {}: remove the schedule, put the number back, or \
                 use `--steps`",
                self.run.steps
            )),
            _ => Ok(()),
        }
    }
}
