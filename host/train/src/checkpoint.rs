//! `checkpoint.safetensors`: a scene file that also holds the state of training and its progress.

use std::collections::BTreeMap;
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::Path;

use super::binding::{BINDING, Binding};
use super::per_photograph::{PerPhotograph, VALUES_PREFIX, names};
use crate::{CHECKPOINT, TrainConfig};
use organza_core::error::{Error, IN_MEMORY, Result};
use organza_core::input::open_regular;
use organza_core::scene::{
    Scene, Tensor, TensorSpec, read_metadata, read_tensor, scene_metadata, tensors_to_bytes,
    write_tensors,
};
use serde::{Deserialize, Serialize};

/// Prefixes of the names of Adam's moments.
const MOMENTS: [&str; 2] = ["adam.first.", "adam.second."];
/// `[N, 4]`: the statistics for densification, added up since it last ran.
const STATISTICS: &str = "train.statistics";
/// Names of the tensors of exposures, after their prefixes.
const EXPOSURE: &str = "exposure";
/// The same for poses.
const POSE: &str = "pose";

/// The complete state of training: a run that continues from it has the same bits.
///
/// This continues a run's training from code:
///
/// ```no_run
/// # use organza_data::Dataset;
/// # use muslin_device::DeviceOptions;
/// # use organza_render::Renderer;
/// # use organza_train::{TrainConfig, Trainer};
/// use organza_train::Checkpoint;
///
/// # let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::default())?);
/// # let dataset = Dataset::load("data/fox", &Default::default())?;
/// let config = TrainConfig::load("run/config.toml")?;
/// let checkpoint = Checkpoint::load("run/checkpoint.safetensors")?;
/// let mut trainer = Trainer::resume(&renderer, config, dataset, &checkpoint)?;
/// trainer.step()?;
/// trainer.checkpoint(0.0)?.save("continued.safetensors", None)?;
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The scene.
    pub scene: Scene,
    /// Adam's moments, as scenes.
    pub moments: [Scene; 2],
    /// `[N]`: see [`SceneGradient::statistics`](organza_render::SceneGradient).
    pub statistics: Vec<[f32; 4]>,
    /// The exposures of the photographs, if the run learns them; `None` before the first step.
    pub exposures: Option<PerPhotograph>,
    /// The motions of the photographs' cameras, if the run refines poses: rotation vectors and shifts, as for
    /// [`Camera::moved`](organza_core::Camera::moved).
    pub poses: Option<PerPhotograph>,
    /// The progress of training.
    pub progress: Progress,
}

impl Checkpoint {
    /// The state before the first step of training `scene`.
    ///
    /// # Errors
    /// The same errors as [`Scene::zeros`].
    pub fn begin(mut scene: Scene, config: &TrainConfig) -> Result<Self> {
        if !config.ablation.learn_transmittance {
            let head = scene.transmittance.network.layers.last_mut().expect("a head");
            head.weight.fill(0.0);
            // log sigmoid(100) is 0 in f32
            head.bias.fill(100.0);
        }
        let zeros = Scene::zeros(scene.config.clone(), scene.gaussians.len())?;
        Ok(Self {
            statistics: vec![[0.0; 4]; scene.gaussians.len()],
            scene,
            moments: [zeros.clone(), zeros],
            exposures: None,
            poses: None,
            progress: Progress::default(),
        })
    }

    /// The tensors of a file beside the scene's. `photographs` is from [`Checkpoint::photograph_tensors`].
    fn beside_scene<'a>(
        &'a self,
        photographs: &'a [(String, Tensor)],
    ) -> Vec<(TensorSpec, &'a [f32])> {
        let moments = self.moments.iter().zip(MOMENTS);
        let mut tensors: Vec<_> =
            moments.flat_map(|(moment, prefix)| moment.tensors_with_prefix(prefix)).collect();
        let name = STATISTICS.to_owned();
        let shape = vec![self.statistics.len(), 4];
        let statistics = self.statistics.as_flattened();
        tensors.push((TensorSpec { name, shape, why: "" }, statistics));
        tensors.extend(photographs.iter().map(|(name, Tensor { shape, data })| {
            (TensorSpec { name: name.clone(), shape: shape.clone(), why: "" }, &data[..])
        }));
        tensors
    }

    /// The metadata of a file beside the scene's configuration.
    fn metadata(&self, binding: Option<&Binding>) -> Result<Vec<(&'static str, String)>> {
        let no_json = |error: serde_json::Error| Error::Argument { reason: error.to_string() };
        let mut metadata =
            vec![(PROGRESS, serde_json::to_string(&self.progress).map_err(no_json)?)];
        if let Some(binding) = binding {
            metadata.push((BINDING, serde_json::to_string(binding).map_err(no_json)?));
        }
        Ok(metadata)
    }

    /// Writes the file, atomically. With a `binding`, the file records the run's settings and data.
    ///
    /// # Errors
    /// The same errors as [`Scene::save`]: [`Error::Invalid`] where training has overflowed.
    pub fn save(&self, path: impl AsRef<Path>, binding: Option<&Binding>) -> Result<()> {
        self.with_encoding(binding, |tensors, metadata| write_tensors(path, tensors, metadata))
    }

    /// [`Self::save`] to memory, without a binding.
    pub(crate) fn to_bytes(&self) -> Result<Vec<u8>> {
        self.with_encoding(None, tensors_to_bytes)
    }

    fn with_encoding<T>(
        &self,
        binding: Option<&Binding>,
        write: impl FnOnce(&[(TensorSpec, &[f32])], &[(&str, &str)]) -> Result<T>,
    ) -> Result<T> {
        self.scene.validate()?;
        self.check(Path::new(IN_MEMORY))?;
        let photographs = self.photograph_tensors();
        let mut tensors = self.scene.tensors();
        tensors.extend(self.beside_scene(&photographs));
        let config = self.scene.config.to_json()?;
        let beside = self.metadata(binding)?;
        let mut metadata = scene_metadata(&config).to_vec();
        metadata.extend(beside.iter().map(|(key, text)| (*key, &**text)));
        write(&tensors, &metadata)
    }

    /// Reads a file that [`Checkpoint::save`] wrote.
    ///
    /// # Errors
    /// The same errors as [`Scene::load`]; [`Error::Invalid`] for a scene that no training can go on from.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        Self::read(&mut BufReader::new(file), (length, path))
    }

    /// [`Self::load`] from memory; `origin` is the name errors give to the bytes.
    ///
    /// # Errors
    /// The same errors as [`Self::load`].
    pub fn from_bytes(bytes: &[u8], origin: impl AsRef<Path>) -> Result<Self> {
        Self::read(&mut Cursor::new(bytes), (bytes.len() as u64, origin.as_ref()))
    }

    fn read(reader: &mut (impl Read + Seek), (length, path): (u64, &Path)) -> Result<Self> {
        let no_file = |source| Error::read(path, source);
        let progress = Progress::read(reader, length, path)?;
        reader.rewind().map_err(no_file)?;
        let other = Some((STATISTICS, 4));
        let (scene, moments, statistics) =
            Scene::read_with(reader, (length, path), MOMENTS, other)?;
        let mut tensors = BTreeMap::new();
        for name in [EXPOSURE, POSE].into_iter().flat_map(names) {
            reader.rewind().map_err(no_file)?;
            if let Some(tensor) = read_tensor(reader, (length, path), &name)? {
                tensors.insert(name, tensor);
            }
        }
        let statistics = statistics.as_chunks().0.to_vec();
        let exposures = PerPhotograph::from_tensors(EXPOSURE, &mut tensors, path)?;
        let poses = PerPhotograph::from_tensors(POSE, &mut tensors, path)?;
        let checkpoint = Self { scene, moments, statistics, exposures, poses, progress };
        checkpoint.check(path)?;
        Ok(checkpoint)
    }

    /// The learned values of each photograph, by the names of the tensors.
    fn photograph_tensors(&self) -> Vec<(String, Tensor)> {
        let exposures = self.exposures.iter().flat_map(|found| found.tensors(EXPOSURE, &[3, 2]));
        exposures.chain(self.poses.iter().flat_map(|found| found.tensors(POSE, &[6]))).collect()
    }

    /// Reads only the motions of the cameras that a run is trained on, as for
    /// [`Camera::moved`](organza_core::Camera::moved), from a checkpoint's file. Empty if poses were not refined.
    ///
    /// # Errors
    /// The same errors as [`Checkpoint::load`], for the header and this tensor.
    pub fn load_poses(path: impl AsRef<Path>) -> Result<Vec<[f64; 6]>> {
        let path = path.as_ref();
        let name = format!("{VALUES_PREFIX}{POSE}");
        let (file, length) = open_regular(path)?;
        let found = read_tensor(&mut BufReader::new(file), (length, path), &name)?;
        let Some(Tensor { shape, data }) = found else {
            return Ok(Vec::new());
        };
        let (rows, _) = data.as_chunks::<6>();
        let is_sound = shape == [rows.len(), 6] && data.iter().all(|value| value.is_finite());
        if is_sound {
            return Ok(rows.iter().map(|row| row.map(f64::from)).collect());
        }
        let reason = format!(
            "tensor `{name}` is {shape:?}, expected six finite numbers for each photograph: the checkpoint is damaged"
        );
        Err(Error::Invalid { origin: path.to_owned(), reason })
    }

    /// Checks that the tensors beside the scene are possible results of training.
    fn check(&self, origin: &Path) -> Result<()> {
        for (spec, values) in self.beside_scene(&self.photograph_tensors()) {
            spec.check_finite(values).map_err(|error| error.in_file(origin))?;
            let tensor = spec.name;
            // means of squares: the optimizer takes their roots
            let is_square = tensor.starts_with(MOMENTS[1]);
            if let Some(index) = values.iter().position(|value| is_square && *value < 0.0) {
                let value = values[index];
                let reason = format!(
                    "tensor `{tensor}` holds {value} at flat index {index}, expected 0 or more: \
                     the checkpoint is damaged"
                );
                return Err(Error::Invalid { origin: origin.to_owned(), reason });
            }
        }
        Ok(())
    }
}

/// The learned values of all photographs: the values that were found in the checkpoint, or the values before the first step.
///
/// # Errors
/// [`Error::Invalid`] if the checkpoint has another number of photographs.
pub(super) fn per_photograph_or_start(
    found: Option<&PerPhotograph>,
    photographs: usize,
    what: &str,
) -> Result<PerPhotograph> {
    let learned = found.cloned().unwrap_or_else(|| PerPhotograph::new(photographs));
    let found = learned.values.len();
    if found == photographs {
        return Ok(learned);
    }
    let reason = format!(
        "it has the {what} of {found} photographs, but the data set has {photographs} to train on: name the data set \
         as it was"
    );
    Err(Error::Invalid { origin: Path::new(CHECKPOINT).to_owned(), reason })
}

/// The key of [`Progress`] in the metadata.
pub const PROGRESS: &str = "train";

/// The progress of training.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// Steps that are done.
    pub step: u32,
    /// Seconds of training.
    pub seconds: f64,
}

impl Progress {
    /// Reads only the progress of a checkpoint.
    ///
    /// # Errors
    /// The same errors as [`Checkpoint::load`](crate::Checkpoint::load), for the header.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (mut file, length) = open_regular(path)?;
        Self::read(&mut file, length, path)
    }

    pub(super) fn read(reader: &mut impl Read, length: u64, path: &Path) -> Result<Self> {
        let progress = read_metadata(reader, length, path, PROGRESS)?;
        let progress = progress.and_then(|text| serde_json::from_str(&text).ok());
        progress.ok_or_else(|| lacks(path, "`train` metadata"))
    }
}

/// A file that is a scene, but no checkpoint.
fn lacks(path: &Path, what: &str) -> Error {
    let reason = format!("it lacks {what}: it is a scene, but not a checkpoint to resume from");
    Error::Invalid { origin: path.to_owned(), reason }
}
