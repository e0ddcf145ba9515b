//! Scenes as safetensors files.

use std::collections::{HashMap, HashSet};
use std::io::{BufReader, Cursor, Read, Seek};
use std::path::Path;

use super::Scene;
use super::config::SceneConfig;
use super::tensor_file::{Header, tensors_to_bytes, write_tensors};
use super::tensor_spec::TensorSpec;
use super::validate::{check_sizes, no_gaussians};
use crate::error::{Error, Result};
use crate::input::open_regular;
use muslin_error::memory;

/// The `format` of a scene file's metadata.
pub(super) const FORMAT: &str = "organza.scene";
/// The `version` of a scene file's metadata.
pub(super) const VERSION: &str = "1";

impl Scene {
    /// Reads and validates a scene file. Tensors that the configuration does not ask for are ignored: see
    /// [`Self::unused_tensors`].
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::BadSafetensors`]; [`Error::WrongFormat`]; [`Error::UnknownVersion`];
    /// [`Error::BadJson`]; [`Error::BadConfig`]; [`Error::Invalid`] without Gaussians, or for a tensor. All but a value that
    /// is not finite is found before any tensor is read.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        Self::read_with(&mut BufReader::new(file), (length, path), [], None)
            .map(|(scene, ..)| scene)
    }

    /// [`Self::load`] from memory. Errors name the bytes `origin`.
    ///
    /// # Errors
    /// The same errors as [`Self::load`].
    pub fn from_bytes(bytes: &[u8], origin: impl AsRef<Path>) -> Result<Self> {
        let place = (bytes.len() as u64, origin.as_ref());
        Self::read_with(&mut Cursor::new(bytes), place, [], None).map(|(scene, ..)| scene)
    }

    /// Like [`Self::load`], from a reader of `length` bytes. Errors name `origin`. Also reads other data of the same
    /// Gaussians: for each prefix, a scene of the same shape whose tensors' names have the prefix; and the rows of one more
    /// tensor, given its name and width.
    pub fn read_with<const P: usize>(
        reader: &mut (impl Read + Seek),
        (length, origin): (u64, &Path),
        prefixes: [&str; P],
        other: Option<(&str, usize)>,
    ) -> Result<(Self, [Self; P], Vec<f32>)> {
        let header = Header::read(reader, length, origin)?;
        let config = read_config(&header, origin)?;
        let gaussians = count_gaussians(&header, &config, origin)?;
        for prefix in [""].iter().chain(&prefixes) {
            for mut spec in config.tensors(gaussians) {
                spec.name.insert_str(0, prefix);
                check_declared(&header, &spec, origin)?;
            }
        }
        if let Some((name, width)) = other {
            let shape = vec![gaussians, width];
            let why = "a row for each Gaussian";
            check_declared(&header, &TensorSpec { name: name.to_owned(), shape, why }, origin)?;
        }
        let in_file = |error: Error| error.in_file(origin);
        check_sizes(config.tensors(gaussians).iter()).map_err(in_file)?;
        // every tensor allocated here is declared in the file, so no header can request more memory than the file is long
        let mut scene = Self::zeros(config, gaussians)?;
        let mut more = prefixes.map(|_| scene.clone());
        let width = other.map_or(0, |(_, width)| width);
        let mut rows = memory::zeros(gaussians * width, "rows of a scene")?;
        let mut targets = HashMap::new();
        let scenes = [("", &mut scene)].into_iter().chain(prefixes.into_iter().zip(&mut more));
        for (prefix, scene) in scenes {
            for (spec, values) in scene.tensors_mut() {
                targets.insert(format!("{prefix}{}", spec.name), values);
            }
        }
        if let Some((name, _)) = other {
            targets.insert(name.to_owned(), &mut rows);
        }
        header.read_wanted(reader, targets, origin)?;
        scene.validate().map_err(in_file)?;
        Ok((scene, more, rows))
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
        self.with_encoding(tensors_to_bytes)
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
        write: impl FnOnce(&[(TensorSpec, &[f32])], &[(&str, &str)]) -> Result<T>,
    ) -> Result<T> {
        self.validate()?;
        write(&self.tensors(), &scene_metadata(&self.config.to_json()?))
    }
}

/// The metadata of a scene file. `config` is the text of [`SceneConfig::to_json`].
pub fn scene_metadata(config: &str) -> [(&'static str, &str); 3] {
    [("format", FORMAT), ("version", VERSION), ("config", config)]
}

/// Reads format, version and configuration, in that order: a later version may have another configuration.
fn read_config(header: &Header, origin: &Path) -> Result<SceneConfig> {
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
fn count_gaussians(header: &Header, config: &SceneConfig, origin: &Path) -> Result<usize> {
    let first = |gaussians| config.tensors(gaussians).swap_remove(0);
    match header.shape(&first(1).name) {
        Some([0, ..]) => no_gaussians().map_err(|error: Error| error.in_file(origin)),
        Some([gaussians, 3]) => Ok(*gaussians),
        // Any count would be wrong for this shape: the common check reports it.
        other => {
            let gaussians = other.and_then(|shape| shape.first()).copied().unwrap_or(1);
            check_declared(header, &first(gaussians), origin).map(|()| gaussians)
        }
    }
}

/// Checks that a tensor is in the header, with the right type and shape.
fn check_declared(header: &Header, spec: &TensorSpec, origin: &Path) -> Result<()> {
    let found = header.shape(&spec.name);
    // A tensor of vectors without elements may be absent.
    if found.is_some() || spec.values() > 0 {
        spec.check_shape(found).map_err(|error| error.in_file(origin))?;
    }
    header.require_f32(&spec.name, origin)
}
