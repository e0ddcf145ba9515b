//! Combines settings from several places.

use std::path::Path;

use serde::Deserialize;
use toml::Table;

use super::assignment::{self, merge};
use super::preset::Preset;
use super::{MAX_BYTES, TrainConfig};
use organza_core::error::{Error, Result};
use organza_core::input::read_text;

/// Combines settings. A later call overrides earlier ones. A setting that no call sets has its default.
///
/// ```
/// use organza_train::{ConfigBuilder, Preset};
///
/// # fn main() -> organza_core::Result<()> {
/// let config = ConfigBuilder::new(Preset::Fast)?.set("growth.end=0")?.build()?;
/// # assert_eq!(config.growth.end, 0.0);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct ConfigBuilder {
    /// Every setting.
    table: Table,
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
        Self { table: Table::try_from(config).expect("plain tables of numbers and strings") }
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
        merge(&mut self.table, table);
        Ok(self)
    }

    /// Lowers `start.gaussians` to `growth.max_gaussians` if it is more.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a value that is not of its type.
    pub fn limit_start(self) -> Result<Self> {
        let config = self.parse().map_err(invalid)?;
        let gaussians = config.start.gaussians.min(config.growth.max_gaussians);
        self.set(&format!("start.gaussians={gaussians}"))
    }

    /// Returns the combined settings.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a value out of range.
    pub fn build(self) -> Result<TrainConfig> {
        let config = self.parse().map_err(invalid)?;
        config.check().map_err(invalid)?;
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
