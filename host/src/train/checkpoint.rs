//! `checkpoint.safetensors`: a scene file that also holds what training needs to go on.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::scene::{Scene, TensorRef, read_metadata, read_tensors};

/// The file's name in a run's folder.
pub const CHECKPOINT: &str = "checkpoint.safetensors";

/// Prefixes of the names of Adam's moments.
const MOMENTS: [&str; 2] = ["adam.first.", "adam.second."];
/// `[N, 4]`: what growth goes by, gathered since the last time.
const STATISTICS: &str = "train.statistics";
/// The key of [`Progress`] in the metadata.
const PROGRESS: &str = "train";

/// Where training stands, to the bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The scene.
    pub scene: Scene,
    /// Adam's moments, as scenes.
    pub moments: [Scene; 2],
    /// `[N]`: see [`SceneGradient::statistics`](crate::render::SceneGradient).
    pub statistics: Vec<[f32; 4]>,
    /// How far it has come.
    pub progress: Progress,
}

/// How far training has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// Steps that are done.
    pub step: u32,
    /// Seconds of training.
    pub seconds: f64,
}

impl Checkpoint {
    /// Writes the file, beside and renamed.
    ///
    /// # Errors
    /// As [`Scene::save`]: [`Error::NotFinite`] where training has left what numbers can hold.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let mut moments = Vec::new();
        for (moment, prefix) in self.moments.iter().zip(MOMENTS) {
            moments.extend(moment.tensors_with_prefix(prefix));
        }
        let mut tensors: Vec<_> = moments.iter().map(|(spec, data)| spec.of(data)).collect();
        let shape = [self.statistics.len(), 4];
        let data = self.statistics.as_flattened();
        tensors.push(TensorRef { name: STATISTICS, shape: &shape, data });
        let progress = serde_json::to_string(&self.progress)
            .map_err(|error| Error::Argument { reason: error.to_string() })?;
        self.scene.save_with(path, &tensors, &[(PROGRESS, &progress)])
    }

    /// Reads a file that [`Checkpoint::save`] wrote.
    ///
    /// # Errors
    /// As [`Scene::load`]; [`Error::Invalid`] for a scene that no training can go on from.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let lacks = |what: &str| Error::Invalid {
            origin: path.to_owned(),
            reason: format!("it lacks {what}: it is a scene, but not a checkpoint to resume from"),
        };
        let progress = read_metadata(path, PROGRESS)?.ok_or_else(|| lacks("`train` metadata"))?;
        let progress = serde_json::from_str(&progress).map_err(|_| lacks("`train` metadata"))?;
        let scene = Scene::load(path)?;
        let mut tensors = read_tensors(path)?;
        let mut moment = |prefix: &str| -> Result<Scene> {
            let mut moment = Scene::zeros(scene.config.clone(), scene.gaussians.len())?;
            for (spec, values) in moment.tensors_mut() {
                let name = format!("{prefix}{}", spec.name);
                let found = tensors.remove(&name).filter(|found| found.data.len() == values.len());
                let found = found.ok_or_else(|| lacks(&format!("tensor `{name}`")))?;
                values.copy_from_slice(&found.data);
            }
            Ok(moment)
        };
        let moments = [moment(MOMENTS[0])?, moment(MOMENTS[1])?];
        let statistics = tensors.remove(STATISTICS).ok_or_else(|| lacks(STATISTICS))?.data;
        let (statistics, rest) = statistics.as_chunks::<4>();
        if statistics.len() != scene.gaussians.len() || !rest.is_empty() {
            return Err(lacks(STATISTICS));
        }
        Ok(Self { statistics: statistics.to_vec(), scene, moments, progress })
    }
}
