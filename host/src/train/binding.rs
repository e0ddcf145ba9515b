//! What a checkpoint belongs to: a run's settings and its data. It goes on with these, or not at all.

use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::checkpoint::{CHECKPOINT, Progress};
use super::config::TrainConfig;
use super::folder::CONFIG;
use crate::data::Fingerprint;
use crate::error::{Error, Result};
use crate::input::open_regular;
use crate::scene::read_metadata;

/// The key of a [`Binding`] in a checkpoint's metadata.
pub(super) const BINDING: &str = "run";

/// The settings that may differ: where the data is.
const FREE: [&str; 2] = ["data.path", "data.keep"];
/// The settings that a plan sets, which a run goes on to make after its checkpoint.
const PLANNED: [&str; 2] = ["run.plan", "run.steps"];
/// The value of a setting that is not there.
const NOT_SET: &str = "not set";

/// The settings that may change when a run is resumed: how long it is, how large it may become, and how often something
/// is written.
pub const CHANGEABLE: [&str; 7] = [
    "run.steps",
    "run.plan",
    "growth.max_gaussians",
    "run.evaluate_every",
    "run.checkpoint_every",
    "run.log_every",
    "run.tensorboard",
];

/// A setting that changed when a run was resumed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Change {
    /// The steps that were done by then.
    pub step: u64,
    /// The setting, one of [`CHANGEABLE`].
    pub name: String,
    /// Its value until then.
    pub from: Value,
    /// Its value from then on.
    pub to: Value,
}

/// The settings and the data that a checkpoint belongs to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Binding {
    /// The settings, as `config.toml` has them.
    settings: String,
    /// What the data set is known by.
    data: Fingerprint,
    /// The settings that were others before, oldest first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    changes: Vec<Change>,
}

impl Binding {
    /// That of a run, and how its settings came to be what they are.
    #[must_use]
    pub fn new(config: &TrainConfig, data: &Fingerprint, changes: Vec<Change>) -> Self {
        Self { settings: config.to_toml(), data: data.clone(), changes }
    }

    /// What changed in earlier resumes.
    #[must_use]
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// That of a checkpoint; `None` if an older program wrote it.
    ///
    /// # Errors
    /// Like [`Scene::load`](crate::Scene::load) for the header; [`Error::Invalid`] if it does not parse.
    pub fn load(path: impl AsRef<Path>) -> Result<Option<Self>> {
        let path = path.as_ref();
        let (mut file, length) = open_regular(path)?;
        let Some(text) = read_metadata(&mut file, length, path, BINDING)? else { return Ok(None) };
        serde_json::from_str(&text).map(Some).map_err(|_| Error::Invalid {
            origin: path.to_owned(),
            reason: format!("its `{BINDING}` metadata does not parse: the checkpoint is damaged"),
        })
    }

    /// Holds a run's settings to those of its checkpoint, which has done `step` steps. Returns the [changes](CHANGEABLE) that
    /// are allowed; `folder` is what errors name.
    ///
    /// # Errors
    /// [`Error::Invalid`] for the first setting that differs and must not, by name.
    pub fn check_settings(
        &self,
        config: &TrainConfig,
        step: u32,
        folder: &Path,
    ) -> Result<Vec<Change>> {
        let invalid = |reason| Err(Error::Invalid { origin: folder.join(CONFIG), reason });
        let then = TrainConfig::parse(&self.settings, &folder.join(CHECKPOINT))?;
        if config.run.steps != then.run.steps && config.run.steps <= step {
            let steps = config.run.steps;
            return invalid(format!(
                "`run.steps` is {steps}, but the run has already done {step} steps; it counts \
                 all steps of the run, so choose more than that"
            ));
        }
        let (now_plan, then_plan) = (&config.run.plan, &then.run.plan);
        // planned after the checkpoint, before the run was killed
        let goes_on = now_plan.len() > then_plan.len() && now_plan.starts_with(then_plan);
        let (now, then) = (config.list(), then.list());
        let value = |settings: &[(String, String)], name: &str| {
            let found = settings.iter().find(|(other, _)| other == name);
            found.map_or(NOT_SET.to_owned(), |(_, value)| value.clone())
        };
        let json = |text: &str| serde_json::from_str(text).unwrap_or_else(|_| text.into());
        let mut changes = Vec::new();
        for (name, _) in now.iter().chain(&then) {
            let (now, then) = (value(&now, name), value(&then, name));
            // a data set may move, but the built-in scene is another
            let is_free = FREE.contains(&name.as_str()) && now != NOT_SET && then != NOT_SET;
            let is_planned = goes_on && PLANNED.contains(&name.as_str());
            let is_known = || changes.iter().any(|change: &Change| change.name == *name);
            if now == then || is_free || is_planned || is_known() {
                continue;
            }
            if !CHANGEABLE.contains(&name.as_str()) {
                let names = CHANGEABLE.join(", ");
                return invalid(format!(
                    "`{name}` is {now}, but the checkpoint beside it was trained with {then}, and \
                     only {names} may change: put it back, or begin another run with `--config`"
                ));
            }
            let (from, to) = (json(&then), json(&now));
            changes.push(Change { step: u64::from(step), name: name.clone(), from, to });
        }
        Ok(changes)
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
/// The same errors as [`TrainConfig::load`]; [`Error::Invalid`] if the folder holds no run, where a setting is not
/// that of the checkpoint and must not [change](CHANGEABLE), or is missing and there is no checkpoint that says what it was.
pub fn settings_of(folder: &Path) -> Result<TrainConfig> {
    changed_settings_of(folder, Ok)
}

/// Like [`settings_of`], with changes for a resume.
///
/// # Errors
/// The same errors as [`settings_of`], for the changed settings too; those of `change`.
pub fn changed_settings_of(
    folder: &Path,
    change: impl FnOnce(TrainConfig) -> Result<TrainConfig>,
) -> Result<TrainConfig> {
    let (path, checkpoint) = (folder.join(CONFIG), folder.join(CHECKPOINT));
    if !path.exists() {
        let reason = format!(
            "the folder has no {CONFIG}, so it is not a training run's; name the folder that \
             `organza train -o` wrote to"
        );
        return Err(Error::Invalid { origin: folder.to_owned(), reason });
    }
    let config = TrainConfig::load(&path)?;
    let is_begun = fs::exists(&checkpoint).unwrap_or(true);
    let Some(binding) = is_begun.then(|| Binding::load(&checkpoint)).transpose()?.flatten() else {
        config.check_complete(&path)?;
        return change(config);
    };
    let step = Progress::load(&checkpoint)?.step;
    // a file that was cut short is no wish for the defaults
    if !binding.check_settings(&config, step, folder)?.is_empty() {
        config.check_complete(&path)?;
    }
    let config = change(config)?;
    binding.check_settings(&config, step, folder)?;
    Ok(config)
}
