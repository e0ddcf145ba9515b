//! Recognizes files and folders by their content.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use organza::error::invalid;
use organza::train::{CHECKPOINT, CONFIG};
use organza::{Error, Result, Scene, data};
use organza_core::input::{has_extension, open_regular};
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::cli::quoted;

/// The kinds of files and folders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    Scene,
    /// safetensors without a scene's metadata, such as a rendered batch.
    Tensors,
    Cameras,
    Tiles,
    Run,
    DataSet,
    /// Gaussians of another program.
    Splats,
}

/// Endings of files of Gaussians.
const SPLATS: [&str; 6] = ["ply", "spz", "sog", "glb", "splat", "gltf"];

impl FileKind {
    /// The kind of a path's content; `None` if it is unknown.
    pub fn from_path(path: &Path) -> Option<Self> {
        if path.is_dir() {
            let is_run = [CHECKPOINT, CONFIG].iter().any(|name| path.join(name).exists());
            return match is_run {
                true => Some(Self::Run),
                false => data::kind_of(path).map(|_| Self::DataSet),
            };
        }
        if path.is_file() && has_extension(path, &SPLATS) {
            return Some(Self::Splats);
        }
        match Self::by_content(path).ok()? {
            // Reads only the header.
            Self::Scene => match Scene::unused_tensors(path) {
                Ok(_) => Some(Self::Scene),
                Err(Error::WrongFormat { .. }) => Some(Self::Tensors),
                Err(_) => None,
            },
            other => Some(other),
        }
    }

    fn as_str(self) -> &'static str {
        match self {
            Self::Scene => "a scene",
            Self::Tensors => "a file of tensors, but not a scene",
            Self::Cameras => "a file of cameras",
            Self::Tiles => "a file of tiles",
            Self::Run => "the folder of a training run",
            Self::DataSet => "a data set",
            Self::Splats => "a file of 3D Gaussian Splatting",
        }
    }

    /// Whether an argument of this kind takes a file of another.
    fn accepts(self, found: Self) -> bool {
        match self {
            // For tensors in another format, the loader has a better message.
            Self::Scene => matches!(found, Self::Scene | Self::Run | Self::Tensors),
            // A transforms.json is both.
            Self::Cameras | Self::DataSet => matches!(found, Self::Cameras | Self::DataSet),
            _ => found == self,
        }
    }

    /// What an argument of this kind takes.
    fn expected(self) -> &'static str {
        match self {
            Self::Cameras => "cameras (transforms.json) or a data set were expected",
            Self::DataSet => "a data set was expected, a folder or a transforms.json",
            Self::Tiles => "tiles (JSON) were expected",
            _ => "a scene (safetensors) or the folder of a training run was expected",
        }
    }

    /// What is wrong with a file that another program has written, in place of one of this kind.
    fn foreign(self, path: &Path) -> Option<String> {
        if self == Self::Scene && has_extension(path, &SPLATS) {
            return Some(format!(
                "this is a file of 3D Gaussian Splatting; `organza import {} -o NEW.safetensors` makes a scene of it",
                quoted(path)
            ));
        }
        let expected = self.expected();
        if starts_with(path, b"PK") {
            return Some(format!("this is a ZIP archive: unpack it; {expected}"));
        }
        Self::by_content(path).is_err().then(|| format!("this is another kind of file; {expected}"))
    }

    /// The kind of a file by its content: a scene if it may be safetensors of any kind, cameras, or tiles.
    pub fn by_content(path: &Path) -> Result<Self> {
        let cannot_read = |source| Error::read(path, source);
        // Other files could block or never end. The loader reports them.
        if !std::fs::metadata(path).is_ok_and(|found| found.is_file()) {
            return Ok(Self::Scene);
        }
        let mut start = Vec::new();
        let file = File::open(path).map_err(cannot_read)?;
        file.take(64).read_to_end(&mut start).map_err(cannot_read)?;
        let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start);
        let is_json = text.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
        // The length before a safetensors header ends in zero bytes, which JSON never contains.
        let named = path.extension().is_some_and(|extension| extension == "safetensors");
        if named || start.iter().take(8).any(|&byte| byte == 0) {
            return Ok(Self::Scene);
        }
        let reason = if is_json {
            let mut reader = BufReader::new(File::open(path).map_err(cannot_read)?);
            let mark = (start.len() - text.len()) as u64;
            std::io::copy(&mut reader.by_ref().take(mark), &mut std::io::sink())
                .map_err(cannot_read)?;
            match serde_json::from_reader::<_, Keys>(reader) {
                Ok(keys) if keys.tiles.is_some() || keys.side.is_some() => return Ok(Self::Tiles),
                Ok(keys) if keys.frames.is_some() => return Ok(Self::Cameras),
                Ok(_) => {
                    "it is JSON, but has neither the `frames` of cameras nor `side` and `tiles`"
                }
                // The loader has a better message.
                Err(_) => return Ok(Self::Cameras),
            }
        } else {
            "it is neither safetensors nor a JSON object"
        };
        let expected = "expected a scene, cameras, tiles or a rendered batch";
        invalid(path, format!("{reason}; {expected}"))
    }
}

/// Whether a regular file has these first bytes.
fn starts_with(path: &Path, bytes: &[u8]) -> bool {
    let mut start = vec![0; bytes.len()];
    let read = open_regular(path).is_ok_and(|(mut file, _)| file.read_exact(&mut start).is_ok());
    read && start == bytes
}

/// A better error than the loader's if the path holds something of another kind: then the arguments are probably in
/// the wrong order, or it is no file of organza at all.
pub fn told_apart(error: Error, path: &Path, expected: FileKind) -> Error {
    let is_unknown = matches!(error, Error::BadJson { .. } | Error::BadSafetensors { .. });
    if is_unknown && let Some(reason) = expected.foreign(path) {
        return Error::Invalid { origin: path.to_owned(), reason };
    }
    match FileKind::from_path(path) {
        Some(found) if !expected.accepts(found) => Error::Invalid {
            origin: path.to_owned(),
            reason: format!(
                "this is {}; {} (the order is: scene, cameras or data set, tiles)",
                found.as_str(),
                expected.expected()
            ),
        },
        _ => error,
    }
}

/// The top-level keys that show the meaning of a JSON file.
#[derive(Deserialize)]
struct Keys {
    frames: Option<IgnoredAny>,
    side: Option<IgnoredAny>,
    tiles: Option<IgnoredAny>,
}
