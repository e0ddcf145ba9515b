//! Scenes as safetensors files.

use std::collections::HashSet;
use std::io::{BufReader, Cursor};
use std::path::Path;

use super::config::SceneConfig;
use super::tensor_file::{Header, TensorRef, encode, write_tensors};
use super::tensors::TensorSpec;
use super::{Scene, SceneShard};
use crate::error::{Error, Result};
use crate::input::open_regular;

/// The `format` of a scene file's metadata.
pub(super) const FORMAT: &str = "organza.scene";
/// The `version` of a scene file's metadata.
pub(super) const VERSION: &str = "1";

impl Scene {
    /// Reads and validates a scene file. Tensors that the configuration does not ask for are ignored: see
    /// [`Self::unused_tensors`].
    ///
    /// # Errors
    /// One for each kind of problem: [`Error::ReadFile`], [`Error::BadSafetensors`], [`Error::WrongFormat`],
    /// [`Error::UnknownVersion`], [`Error::BadJson`], [`Error::BadConfig`], [`Error::EmptyScene`],
    /// [`Error::MissingTensor`], [`Error::WrongDtype`], [`Error::WrongShape`], [`Error::TooManyValues`],
    /// [`Error::NotFinite`]. All but the last are found before any tensor is read.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        SceneShard::load(path, 0, 1).map(|shard| shard.scene)
    }

    /// [`Self::load`] from memory. Errors name the bytes `origin`.
    ///
    /// # Errors
    /// The same errors as [`Self::load`].
    pub fn from_bytes(bytes: &[u8], origin: impl AsRef<Path>) -> Result<Self> {
        let place = (bytes.len() as u64, origin.as_ref());
        let (shard, ..) = SceneShard::read_with(&mut Cursor::new(bytes), place, (0, 1), [], None)?;
        Ok(shard.scene)
    }

    /// Validates the scene and writes it atomically. The same scene gives the same bytes.
    ///
    /// # Errors
    /// The same errors as [`Self::validate`], and [`Error::WriteFile`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        self.with_encoding(|tensors, metadata| write_tensors(path, tensors, metadata))
    }

    /// [`Self::save`] to memory.
    ///
    /// # Errors
    /// The same errors as [`Self::validate`].
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        self.with_encoding(encode)
    }

    /// Names of the tensors in a scene file that [`Self::load`] ignores. Reads only the header.
    ///
    /// # Errors
    /// The same errors as [`Self::load`], for the header and the configuration.
    pub fn unused_tensors(path: impl AsRef<Path>) -> Result<Vec<String>> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        let header = Header::read(&mut BufReader::new(file), length, path)?;
        let used: HashSet<_> =
            read_config(&header, path)?.tensors(1).into_iter().map(|spec| spec.name).collect();
        let mut unused = header.names().to_vec();
        unused.retain(|name| !used.contains(name));
        unused.sort_unstable();
        Ok(unused)
    }

    /// The configuration in a scene file. Reads only the header.
    ///
    /// # Errors
    /// The same errors as [`Self::load`], for the header and the configuration.
    pub fn load_config(path: impl AsRef<Path>) -> Result<SceneConfig> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        read_config(&Header::read(&mut BufReader::new(file), length, path)?, path)
    }

    fn with_encoding<T>(
        &self,
        write: impl FnOnce(&[TensorRef<'_>], &[(&str, &str)]) -> Result<T>,
    ) -> Result<T> {
        self.validate()?;
        let tensors = self.tensors();
        let tensors: Vec<_> = tensors.iter().map(|(spec, data)| spec.with_data(data)).collect();
        let config = self.config.to_json()?;
        write(&tensors, &scene_metadata(&config))
    }
}

/// The metadata of a scene file. `config` is the text of [`SceneConfig::to_json`].
pub fn scene_metadata(config: &str) -> [(&'static str, &str); 3] {
    [("format", FORMAT), ("version", VERSION), ("config", config)]
}

/// Reads format, version and configuration, in that order: a later version may have another configuration.
pub(super) fn read_config(header: &Header, origin: &Path) -> Result<SceneConfig> {
    let quoted =
        |found: Option<&str>| found.map_or("missing".to_owned(), |text| format!("{text:?}"));
    let format = header.metadata("format");
    if format != Some(FORMAT) {
        return Err(Error::WrongFormat { origin: origin.to_owned(), found: quoted(format) });
    }
    let version = header.metadata("version");
    if version != Some(VERSION) {
        return Err(Error::UnknownVersion { origin: origin.to_owned(), found: quoted(version) });
    }
    let config = header.metadata("config").ok_or_else(|| Error::BadConfig {
        origin: origin.to_owned(),
        field: "config".to_owned(),
        reason: "is missing from the metadata; write the scene again".to_owned(),
    })?;
    SceneConfig::from_json(config, origin)
}

/// N, the only size that the configuration does not contain.
pub(super) fn count_gaussians(
    header: &Header,
    config: &SceneConfig,
    origin: &Path,
) -> Result<usize> {
    let first = |gaussians| config.tensors(gaussians).swap_remove(0);
    match header.shape(&first(1).name) {
        Some([0, ..]) => Err(Error::EmptyScene { origin: origin.to_owned() }),
        Some([gaussians, 3]) => Ok(*gaussians),
        // Any count would be wrong for this shape: the common check reports it.
        other => {
            let gaussians = other.and_then(|shape| shape.first()).copied().unwrap_or(1);
            check_declared(header, &first(gaussians), origin).map(|()| gaussians)
        }
    }
}

/// Checks that a tensor is in the header, with the right type and shape.
pub(super) fn check_declared(header: &Header, spec: &TensorSpec, origin: &Path) -> Result<()> {
    let found = header.shape(&spec.name);
    // A tensor of vectors without elements may be absent.
    if found.is_some() || spec.values() > 0 {
        spec.check_shape(found, origin)?;
    }
    header.require_f32(&spec.name, origin)
}
