//! A scene from its file, or from a training run's folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use organza::scene::Placement;
use organza::train::{self, CHECKPOINT, CONFIG, TrainConfig};
use organza::{Error, Result, Scene};

use super::kind::{Expected, told_apart};
use crate::cli::console::Console;
use crate::cli::summary::count;

/// The origin of a scene.
#[derive(Clone, Debug)]
pub struct SceneSource {
    /// The path that the user named.
    named: PathBuf,
    /// The scene's file.
    file: PathBuf,
}

impl SceneSource {
    /// Finds the scene's file: the named one, or the checkpoint in a run's folder. Reads nothing yet.
    ///
    /// # Errors
    /// If there is no such file, or the folder is not a run's.
    pub fn find(path: &Path) -> Result<Self> {
        let found = fs::metadata(path).map_err(|source| Error::read(path, source))?;
        let checkpoint = path.join(CHECKPOINT);
        if !found.is_dir() || checkpoint.exists() {
            let file = if found.is_dir() { checkpoint } else { path.to_owned() };
            return Ok(Self { named: path.to_owned(), file });
        }
        let reason = if path.join(CONFIG).exists() {
            format!(
                "the run has no {CHECKPOINT} yet: training writes it at intervals, and at its end"
            )
        } else {
            format!(
                "the folder has no {CHECKPOINT}, so it is not a training run's; name a scene file, or the \
                 folder that training wrote to. `organza capture` makes a data set of photographs"
            )
        };
        let error = Error::Invalid { origin: path.to_owned(), reason };
        Err(told_apart(error, path, Expected::Scene))
    }

    /// Path of the scene's file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// The path that the user named: the scene's file, or the run's folder.
    pub fn named(&self) -> &Path {
        &self.named
    }

    /// Reads the scene.
    pub fn load(&self, console: Console) -> Result<Scene> {
        let start = Instant::now();
        let scene = console
            .during("reading the scene", || Scene::load(&self.file))
            .map_err(|error| told_apart(error, &self.file, Expected::Scene))?;
        console.detail(&format!(
            "scene {}: {}, read in {:.2} s",
            self.file.display(),
            count(scene.gaussians.len() as u64, "Gaussian"),
            start.elapsed().as_secs_f64()
        ));
        Ok(scene)
    }

    /// Where the scene lies in the world. Other files, such as Gaussians to import, have the world's coordinates; what is no
    /// file of organza is reported when it is read.
    pub fn placement(&self) -> Placement {
        Scene::load_config(&self.file).map(|config| config.placement).unwrap_or_default()
    }

    /// The settings of the run, if the user named a run's folder.
    pub fn settings(&self) -> Result<Option<TrainConfig>> {
        if self.named.join(CONFIG).exists() {
            return train::settings_of(&self.named).map(Some);
        }
        Ok(None)
    }
}
