//! The settings and the data of a checkpoint's run. A run resumes only with the same settings and data.

use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::data_place::{find, way};
use crate::{CHECKPOINT, CONFIG, Progress, TrainConfig};
use organza_core::error::{Error, Result};
use organza_core::input::open_regular;
use organza_core::scene::read_metadata;
use organza_data::Fingerprint;

/// The key of a [`Binding`] in a checkpoint's metadata.
pub(super) const BINDING: &str = "run";

/// The version of this program.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// A setting that may differ freely: the place of the data.
const FREE: &str = "data.path";
/// Settings that a schedule changes, also after the run's last checkpoint.
const SCHEDULED: [&str; 2] = ["run.schedule", "run.steps"];
/// Printed for a setting that is missing.
const NOT_SET: &str = "not set";

/// Settings that may change when a run is resumed: its length, its largest number of Gaussians, and how often it
/// writes something.
pub const CHANGEABLE: [&str; 6] = [
    "run.steps",
    "run.schedule",
    "densification.max_gaussians",
    "run.evaluate_every",
    "run.checkpoint_every",
    "run.log_every",
];

/// A setting that changed when a run was resumed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Change {
    /// Steps done before the change.
    pub step: u64,
    /// The setting, one of [`CHANGEABLE`].
    pub name: String,
    /// Value before the change.
    pub from: Value,
    /// Value after the change.
    pub to: Value,
}

/// The settings and the data of a checkpoint's run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Binding {
    /// The settings, as in `config.toml`.
    settings: String,
    /// Identifies the data set.
    data: Fingerprint,
    /// The way from the run's folder to the data set.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    way: Option<String>,
    /// The version of the program.
    version: String,
    /// Earlier changes of settings, oldest first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    changes: Vec<Change>,
}

impl Binding {
    /// The binding of the run in a folder, with the history of its settings.
    #[must_use]
    pub fn new(
        config: &TrainConfig,
        data: &Fingerprint,
        changes: Vec<Change>,
        folder: &Path,
    ) -> Self {
        let way = config.data.path.as_ref().and_then(|data| way(folder, data));
        let version = VERSION.to_owned();
        Self { settings: config.to_toml(), data: data.clone(), way, version, changes }
    }

    /// Changes in earlier resumes, oldest first.
    #[must_use]
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// The data that the run was trained on.
    #[must_use]
    pub fn data(&self) -> &Fingerprint {
        &self.data
    }

    /// The settings of the run of a checkpoint, which is at `path`.
    ///
    /// # Errors
    /// The same errors as [`TrainConfig::parse`].
    pub fn settings(&self, path: &Path) -> Result<TrainConfig> {
        TrainConfig::parse(&self.settings, path)
    }

    /// Reads the binding of a run's checkpoint.
    ///
    /// # Errors
    /// The same errors as [`Scene::load`](organza_core::Scene::load), for the header; [`Error::Invalid`] if there is none, or
    /// if it does not parse.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (mut file, length) = open_regular(path)?;
        let text = read_metadata(&mut file, length, path, BINDING)?;
        let binding = text.and_then(|text| serde_json::from_str(&text).ok());
        binding.ok_or_else(|| Error::Invalid {
            origin: path.to_owned(),
            reason: format!(
                "it lacks `{BINDING}` metadata, or that does not parse: no run wrote this checkpoint, or it is damaged"
            ),
        })
    }

    /// Compares a run's settings with its checkpoint's, which is after `step` steps. Returns the [allowed changes](CHANGEABLE).
    /// Errors name `folder`.
    ///
    /// # Errors
    /// [`Error::Invalid`] for the first setting that must not differ. It names the setting.
    pub fn check_settings(
        &self,
        config: &TrainConfig,
        step: u32,
        folder: &Path,
    ) -> Result<Vec<Change>> {
        let invalid = |reason| Err(Error::Invalid { origin: folder.join(CONFIG), reason });
        let then = self.settings(&folder.join(CHECKPOINT))?;
        if config.run.steps != then.run.steps && config.run.steps <= step {
            let steps = config.run.steps;
            return invalid(format!(
                "`run.steps` is {steps}, but the run has already done {step} steps; it counts \
                 all steps of the run, so choose more than that"
            ));
        }
        let now_schedule = &config.run.schedule;
        let then_schedule = &then.run.schedule;
        // a schedule that was made after the checkpoint, before the run was killed
        let continues =
            now_schedule.len() > then_schedule.len() && now_schedule.starts_with(then_schedule);
        let now = config.list();
        let then = then.list();
        let mut changes = Vec::new();
        for (name, _) in now.iter().chain(&then) {
            let now = value(&now, name);
            let then = value(&then, name);
            // a data set may move, but the built-in scene is a different data set
            let is_free = name == FREE && now != NOT_SET && then != NOT_SET;
            let is_scheduled = continues && SCHEDULED.contains(&name.as_str());
            let is_known = || changes.iter().any(|change: &Change| change.name == *name);
            if now == then || is_free || is_scheduled || is_known() {
                continue;
            }
            if !CHANGEABLE.contains(&name.as_str()) {
                let names = CHANGEABLE.join(", ");
                return invalid(format!(
                    "`{name}` is {now}, but the checkpoint beside it was trained with {then}, and \
                     only {names} may change: put it back, or begin another run with `--config`"
                ));
            }
            let from = json(&then);
            let to = json(&now);
            changes.push(Change { step: u64::from(step), name: name.clone(), from, to });
        }
        Ok(changes)
    }

    /// A note if another version of the program wrote the checkpoint.
    #[must_use]
    pub fn other_version(&self) -> Option<String> {
        let then = &self.version;
        (then != VERSION).then(|| {
            format!(
                "organza {then} wrote the checkpoint, and this is {VERSION}: the run goes on, but may not end with the same bits"
            )
        })
    }

    /// Compares a run's data with its checkpoint's. Errors name `path`.
    ///
    /// # Errors
    /// [`Error::Invalid`], with the part that differs.
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

/// The value of a setting, or [`NOT_SET`].
fn value(settings: &[(String, String)], name: &str) -> String {
    let found = settings.iter().find(|(other, _)| other == name);
    found.map_or(NOT_SET.to_owned(), |(_, value)| value.clone())
}

/// A value as JSON. A text that is not JSON becomes a string.
fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|_| text.into())
}

/// The settings of the run in a folder, checked against its checkpoint. The data set may have moved with the run.
///
/// # Errors
/// The same errors as [`TrainConfig::load`]. [`Error::Invalid`] if the folder holds no run, if a setting differs from
/// the checkpoint and must not [change](CHANGEABLE), or if a setting is missing and no checkpoint has its value.
pub fn settings_of(folder: &Path) -> Result<TrainConfig> {
    changed_settings_of(folder, Ok)
}

/// Like [`settings_of`], but changes settings for a resume.
///
/// # Errors
/// The same errors as [`settings_of`], also for the changed settings; any error of `change`.
pub fn changed_settings_of(
    folder: &Path,
    change: impl FnOnce(TrainConfig) -> Result<TrainConfig>,
) -> Result<TrainConfig> {
    let path = folder.join(CONFIG);
    let checkpoint = folder.join(CHECKPOINT);
    if !path.exists() {
        if !folder.exists() {
            let reason =
                "there is no such folder; name the one that `organza train -o` wrote to".into();
            return Err(Error::Invalid { origin: folder.to_owned(), reason });
        }
        let reason = format!(
            "the folder has no {CONFIG}, so it is not a training run's; name the folder that \
             `organza train -o` wrote to"
        );
        return Err(Error::Invalid { origin: folder.to_owned(), reason });
    }
    let mut config = TrainConfig::load(&path)?;
    if !fs::exists(&checkpoint).unwrap_or(true) {
        find(&mut config.data.path, folder, None);
        config.check_complete(&path)?;
        return change(config);
    }
    let binding = Binding::load(&checkpoint)?;
    // who has changed the path means another place
    if binding.settings(&checkpoint)?.data.path == config.data.path {
        find(&mut config.data.path, folder, binding.way.as_deref());
    }
    let step = Progress::load(&checkpoint)?.step;
    // a truncated file does not mean that the user wants the defaults
    if !binding.check_settings(&config, step, folder)?.is_empty() {
        config.check_complete(&path)?;
    }
    let config = change(config)?;
    binding.check_settings(&config, step, folder)?;
    Ok(config)
}
