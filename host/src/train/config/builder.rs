//! Settings from several places, put together.

use std::path::Path;

use serde::Deserialize;
use toml::{Table, Value};

use super::assignment;
use super::preset::Preset;
use super::retired;
use super::{MAX_BYTES, TrainConfig};
use crate::error::{Error, Result};
use crate::input::read_text;

/// Puts settings together. A later call overrides earlier ones; what none of them sets has its default.
///
/// ```
/// use organza::train::{ConfigBuilder, Preset};
///
/// # fn main() -> organza::Result<()> {
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
    /// Begins with the settings of a preset.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`], which means that the program's own file is wrong.
    pub fn new(preset: Preset) -> Result<Self> {
        Self::from_config(&TrainConfig::default())
            .text(preset.toml(), Path::new(&format!("the preset {}", preset.name())))
    }

    /// Begins with settings that are put together already.
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

    /// Adds the settings of a TOML text; `origin` is the name that errors give to it.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::load`].
    pub fn text(mut self, text: &str, origin: &Path) -> Result<Self> {
        let invalid = |reason| Error::Invalid { origin: origin.to_owned(), reason };
        // only the text has lines
        let at_line = |error: toml::de::Error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            format!("line {line}: {}", error.message())
        };
        let mut table = toml::from_str(text).map_err(|error| invalid(at_line(error)))?;
        retired::replace(&mut table).map_err(invalid)?;
        merge(&mut self.table, table);
        let config = self.parse().map_err(|reason| {
            let alone = toml::from_str::<TrainConfig>(text).err();
            // what the text leaves out is not missing
            let alone = alone.filter(|error| !error.message().starts_with("missing field"));
            invalid(alone.map_or(reason, at_line))
        })?;
        config.check().map_err(invalid)?;
        Ok(self)
    }

    /// Sets one value. The assignment reads `key=value`, such as `run.steps=3000`; the key is the setting's table and
    /// name. Text needs no quotes, a list no brackets. A learning rate is two numbers, `first,last`, or one for both.
    ///
    /// The value's range is checked by [`ConfigBuilder::build`].
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is no such setting, or if the value is not of its type.
    pub fn set(mut self, assignment: &str) -> Result<Self> {
        let invalid = |reason| Error::Invalid { origin: Path::new("").to_owned(), reason };
        let table = assignment::parse(assignment).map_err(invalid)?;
        merge(&mut self.table, table);
        Ok(self)
    }

    /// The settings.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a value out of range.
    pub fn build(self) -> Result<TrainConfig> {
        let invalid = |reason| Error::Invalid { origin: Path::new("").to_owned(), reason };
        let config = self.parse().map_err(invalid)?;
        config.check().map_err(invalid)?;
        Ok(config)
    }

    fn parse(&self) -> Result<TrainConfig, String> {
        TrainConfig::deserialize(self.table.clone()).map_err(|error| error.message().to_owned())
    }
}

/// Puts the values of one table over those of another.
pub(super) fn merge(under: &mut Table, over: Table) {
    for (key, value) in over {
        match (under.get_mut(&key), value) {
            (Some(Value::Table(under)), Value::Table(over)) => merge(under, over),
            (_, value) => drop(under.insert(key, value)),
        }
    }
}
