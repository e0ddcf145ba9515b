//! `checkpoint.safetensors`: a scene file that also holds what training needs to go on.

use std::collections::BTreeMap;
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::binding::{BINDING, Binding};
use super::config::TrainConfig;
use super::per_photograph::{PerPhotograph, VALUES_PREFIX, names};
use organza_core::error::{Error, IN_MEMORY, Result};
use organza_core::input::open_regular;
use organza_core::scene::{
    Scene, Tensor, TensorRef, TensorSpec, read_metadata, read_scene, read_tensor, read_tensors_from,
};

/// The file's name in a run's folder.
pub const CHECKPOINT: &str = "checkpoint.safetensors";

/// The file of the checkpoint whose held-out views were rendered best.
pub const BEST: &str = "checkpoint.best.safetensors";

/// Prefixes of the names of Adam's moments.
pub(super) const MOMENTS: [&str; 2] = ["adam.first.", "adam.second."];
/// `[N, 4]`: what growth goes by, gathered since the last time.
pub(super) const STATISTICS: &str = "train.statistics";
/// What the tensors of exposures are called, after their prefixes.
const EXPOSURE: &str = "exposure";
/// Those of poses.
const POSE: &str = "pose";
/// The key of [`Progress`] in the metadata.
pub(super) const PROGRESS: &str = "train";

/// Where training stands, to the bit.
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
    /// The exposures of the photographs, where the run learns them; none is as before the first step.
    pub exposures: Option<PerPhotograph>,
    /// How the cameras of the photographs have moved, where the run refines poses: rotation vectors and shifts, as
    /// [`Camera::moved`](organza_core::Camera::moved) takes them.
    pub poses: Option<PerPhotograph>,
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

impl Progress {
    /// Reads that of a checkpoint, and nothing else of it.
    ///
    /// # Errors
    /// As [`Checkpoint::load`], for the header.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (mut file, length) = open_regular(path)?;
        Self::read(&mut file, length, path)
    }

    fn read(reader: &mut impl Read, length: u64, path: &Path) -> Result<Self> {
        let progress = read_metadata(reader, length, path, PROGRESS)?;
        let progress = progress.and_then(|text| serde_json::from_str(&text).ok());
        progress.ok_or_else(|| lacks(path, "`train` metadata"))
    }
}

/// What is a scene, but no checkpoint.
fn lacks(path: &Path, what: &str) -> Error {
    let reason = format!("it lacks {what}: it is a scene, but not a checkpoint to resume from");
    Error::Invalid { origin: path.to_owned(), reason }
}

impl Checkpoint {
    /// The state before the first step of training `scene`.
    ///
    /// # Errors
    /// As [`Scene::zeros`].
    pub fn begin(mut scene: Scene, config: &TrainConfig) -> Result<Self> {
        if !config.ablation.learn_transmittance {
            let last = scene.transmittance.network.layers.last_mut().expect("a head");
            last.weight.fill(0.0);
            // log sigmoid(100) is 0 in f32
            last.bias.fill(100.0);
        }
        let zeros = Scene::zeros(scene.config.clone(), scene.gaussians.len())?;
        let statistics = vec![[0.0; 4]; scene.gaussians.len()];
        Ok(Self::of_scene(scene, [zeros.clone(), zeros], statistics, Progress::default()))
    }

    /// Nothing is learned of the photographs.
    pub(super) fn of_scene(
        scene: Scene,
        moments: [Scene; 2],
        statistics: Vec<[f32; 4]>,
        progress: Progress,
    ) -> Self {
        Self { scene, moments, statistics, exposures: None, poses: None, progress }
    }

    /// Writes the file, beside and renamed. It is bound to a run's settings and data, if to any.
    ///
    /// # Errors
    /// As [`Scene::save`]: [`Error::NotFinite`] where training has left what numbers can hold.
    pub fn save(&self, path: impl AsRef<Path>, binding: Option<&Binding>) -> Result<()> {
        self.encoded(binding, |tensors, metadata| self.scene.save_with(path, tensors, metadata))
    }

    /// [`Self::save`] to memory, bound to nothing.
    ///
    /// # Errors
    /// As [`Self::save`].
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        self.encoded(None, |tensors, metadata| self.scene.to_bytes_with(tensors, metadata))
    }

    /// Calls `write` with what a checkpoint has beside the scene.
    fn encoded<R>(
        &self,
        binding: Option<&Binding>,
        write: impl FnOnce(&[TensorRef<'_>], &[(&str, &str)]) -> Result<R>,
    ) -> Result<R> {
        self.check(Path::new(IN_MEMORY))?;
        let photographs = self.of_photographs();
        let tensors = self.beside_scene(&photographs);
        let tensors: Vec<_> = tensors.iter().map(|(spec, data)| spec.of(data)).collect();
        let metadata = self.metadata(binding)?;
        let metadata: Vec<_> = metadata.iter().map(|(key, text)| (*key, &**text)).collect();
        write(&tensors, &metadata)
    }

    /// The tensors of a file beside those of the scene; `photographs` are those of [`Checkpoint::of_photographs`].
    pub(super) fn beside_scene<'a>(
        &'a self,
        photographs: &'a [(String, Tensor)],
    ) -> Vec<(TensorSpec, &'a [f32])> {
        let moments = self.moments.iter().zip(MOMENTS);
        let mut tensors: Vec<_> =
            moments.flat_map(|(moment, prefix)| moment.tensors_with_prefix(prefix)).collect();
        let (name, shape) = (STATISTICS.to_owned(), vec![self.statistics.len(), 4]);
        let statistics = self.statistics.as_flattened();
        tensors.push((TensorSpec { name, shape, why: "" }, statistics));
        tensors.extend(photographs.iter().map(|(name, Tensor { shape, data })| {
            (TensorSpec { name: name.clone(), shape: shape.clone(), why: "" }, &data[..])
        }));
        tensors
    }

    /// What a file tells beside the scene's configuration.
    pub(super) fn metadata(
        &self,
        binding: Option<&Binding>,
    ) -> Result<Vec<(&'static str, String)>> {
        let no_json = |error: serde_json::Error| Error::Argument { reason: error.to_string() };
        let mut metadata =
            vec![(PROGRESS, serde_json::to_string(&self.progress).map_err(no_json)?)];
        if let Some(binding) = binding {
            metadata.push((BINDING, serde_json::to_string(binding).map_err(no_json)?));
        }
        Ok(metadata)
    }

    /// Reads a file that [`Checkpoint::save`] wrote.
    ///
    /// # Errors
    /// As [`Scene::load`]; [`Error::Invalid`] for a scene that no training can go on from.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        Self::read(&mut BufReader::new(file), length, path)
    }

    /// [`Self::load`] from memory; `origin` is the name errors give to the bytes.
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn from_bytes(bytes: &[u8], origin: impl AsRef<Path>) -> Result<Self> {
        Self::read(&mut Cursor::new(bytes), bytes.len() as u64, origin.as_ref())
    }

    fn read(reader: &mut (impl Read + Seek), length: u64, path: &Path) -> Result<Self> {
        let lacks = |what: &str| lacks(path, what);
        let no_file = |source| Error::read(path, source);
        let progress = Progress::read(reader, length, path)?;
        reader.rewind().map_err(no_file)?;
        let scene = read_scene(reader, length, path)?;
        reader.rewind().map_err(no_file)?;
        let mut tensors: BTreeMap<String, Tensor> = read_tensors_from(reader, length, path)?;
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
        let statistics = statistics.to_vec();
        let mut checkpoint = Self::of_scene(scene, moments, statistics, progress);
        checkpoint.set_photographs(&mut tensors, path)?;
        checkpoint.check(path)?;
        Ok(checkpoint)
    }

    /// Reads what is learned of each photograph, and nothing else of a file.
    pub(super) fn read_photographs(&mut self, path: &Path) -> Result<()> {
        let mut tensors = BTreeMap::new();
        for name in [EXPOSURE, POSE].into_iter().flat_map(names) {
            if let Some(tensor) = read_tensor(path, &name)? {
                tensors.insert(name, tensor);
            }
        }
        self.set_photographs(&mut tensors, path)
    }

    fn set_photographs(
        &mut self,
        tensors: &mut BTreeMap<String, Tensor>,
        path: &Path,
    ) -> Result<()> {
        self.exposures = PerPhotograph::of_tensors(EXPOSURE, tensors, path)?;
        self.poses = PerPhotograph::of_tensors(POSE, tensors, path)?;
        Ok(())
    }

    /// What is learned of each photograph, by the names of the tensors.
    pub(super) fn of_photographs(&self) -> Vec<(String, Tensor)> {
        let exposures = self.exposures.iter().flat_map(|found| found.tensors(EXPOSURE, &[3, 2]));
        exposures.chain(self.poses.iter().flat_map(|found| found.tensors(POSE, &[6]))).collect()
    }

    /// How the cameras of the frames that a run is trained on have moved, as [`Camera::moved`](organza_core::Camera::moved) takes it:
    /// reads nothing else of a checkpoint's file. Empty where poses were not refined.
    ///
    /// # Errors
    /// As [`Checkpoint::load`], for the header and this tensor.
    pub fn load_poses(path: impl AsRef<Path>) -> Result<Vec<[f64; 6]>> {
        let path = path.as_ref();
        let name = format!("{VALUES_PREFIX}{POSE}");
        let Some(Tensor { shape, data }) = read_tensor(path, &name)? else {
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

    /// The exposures of so many photographs: those that are here, or those before the first step.
    ///
    /// # Errors
    /// [`Error::Invalid`] where they are those of another number.
    pub(super) fn exposures_of(&self, photographs: usize) -> Result<PerPhotograph> {
        of_number(self.exposures.as_ref(), photographs, "exposures")
    }

    /// The same of poses.
    ///
    /// # Errors
    /// As [`Self::exposures_of`].
    pub(super) fn poses_of(&self, photographs: usize) -> Result<PerPhotograph> {
        of_number(self.poses.as_ref(), photographs, "poses")
    }

    /// Everything beside the scene is what training can have come to.
    pub(super) fn check(&self, origin: &Path) -> Result<()> {
        for (spec, values) in self.beside_scene(&self.of_photographs()) {
            let tensor = spec.name;
            if let Some(index) = values.iter().position(|value| !value.is_finite()) {
                let (origin, value) = (origin.to_owned(), values[index]);
                return Err(Error::NotFinite { origin, tensor, index, value });
            }
            // means of squares, of which roots are taken
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

/// What was learned of so many photographs: what is there, or what is there before the first step.
fn of_number(
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
