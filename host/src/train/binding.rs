//! What a checkpoint belongs to: a run's settings and its data. It goes on with these, or not at all.

use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::checkpoint::CHECKPOINT;
use super::config::TrainConfig;
use super::folder::CONFIG;
use crate::data::Fingerprint;
use crate::error::{Error, Result};
use crate::input::open_regular;
use crate::scene::read_metadata;

/// The key of a [`Binding`] in a checkpoint's metadata.
pub(super) const BINDING: &str = "run";

/// The setting that may differ: where the data is.
const FREE: [&str; 1] = ["data.path"];
/// The value of a setting that is not there.
const NOT_SET: &str = "not set";

/// The settings and the data that a checkpoint belongs to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Binding {
    /// The settings, as `config.toml` has them.
    settings: String,
    /// What the data set is known by.
    data: Fingerprint,
}

impl Binding {
    /// That of a run.
    #[must_use]
    pub fn new(config: &TrainConfig, data: &Fingerprint) -> Self {
        Self { settings: config.to_toml(), data: data.clone() }
    }

    /// That of a checkpoint; none where an older program wrote it.
    ///
    /// # Errors
    /// As [`Scene::load`](crate::Scene::load) for the header; [`Error::Invalid`] where it does not parse.
    pub fn load(path: impl AsRef<Path>) -> Result<Option<Self>> {
        let path = path.as_ref();
        let (mut file, length) = open_regular(path)?;
        let Some(text) = read_metadata(&mut file, length, path, BINDING)? else { return Ok(None) };
        serde_json::from_str(&text).map(Some).map_err(|_| Error::Invalid {
            origin: path.to_owned(),
            reason: format!("its `{BINDING}` metadata does not parse: the checkpoint is damaged"),
        })
    }

    /// Holds a run's settings to those of its checkpoint; `folder` is what errors name.
    ///
    /// # Errors
    /// [`Error::Invalid`] for the first setting that differs, by name.
    pub fn check_settings(&self, config: &TrainConfig, folder: &Path) -> Result<()> {
        let then = TrainConfig::parse(&self.settings, &folder.join(CHECKPOINT))?;
        let (now, then) = (config.list(), then.list());
        let value = |settings: &[(String, String)], name: &str| {
            let found = settings.iter().find(|(other, _)| other == name);
            found.map_or(NOT_SET.to_owned(), |(_, value)| value.clone())
        };
        let names = now.iter().chain(&then).map(|(name, _)| name);
        let is_other = |name: &&String| {
            let (now, then) = (value(&now, name), value(&then, name));
            // a data set may move, but the built-in scene is another
            let is_free = FREE.contains(&name.as_str()) && now != NOT_SET && then != NOT_SET;
            now != then && !is_free
        };
        if let Some(name) = names.clone().find(is_other) {
            let (now, then) = (value(&now, name), value(&then, name));
            let reason = format!(
                "`{name}` is {now}, but the checkpoint beside it was trained with {then}: put it \
                 back, or begin another run with `--config`"
            );
            return Err(Error::Invalid { origin: folder.join(CONFIG), reason });
        }
        Ok(())
    }

    /// Holds a run's data to those of its checkpoint; `path` is what errors name.
    ///
    /// # Errors
    /// [`Error::Invalid`] that says which part differs.
    pub fn check_data(&self, data: &Fingerprint, path: &Path) -> Result<()> {
        match data.difference(&self.data) {
            None => Ok(()),
            Some(what) => {
                let reason = format!(
                    "its {what} are not those that the run was trained on: name the data set as \
                     it was, `data.path` of {CONFIG}, or begin another run"
                );
                Err(Error::Invalid { origin: path.to_owned(), reason })
            }
        }
    }
}

/// The settings of the run in a folder, held to those of its checkpoint.
///
/// # Errors
/// As [`TrainConfig::load`]; [`Error::Invalid`] where the folder holds no run, where a setting is not
/// that of the checkpoint, or is missing and there is no checkpoint that says what it was.
pub fn settings_of(folder: &Path) -> Result<TrainConfig> {
    let (path, checkpoint) = (folder.join(CONFIG), folder.join(CHECKPOINT));
    if !path.exists() {
        let reason = format!(
            "the folder has no {CONFIG}, so it is not a training run's; name the folder that \
             `organza train -o` wrote to"
        );
        return Err(Error::Invalid { origin: folder.to_owned(), reason });
    }
    let config = TrainConfig::load(&path)?;
    let binding =
        if fs::exists(&checkpoint).unwrap_or(true) { Binding::load(checkpoint)? } else { None };
    match binding {
        Some(binding) => binding.check_settings(&config, folder)?,
        None => config.check_complete(&path)?,
    }
    Ok(config)
}
