//! How far a checkpoint has come.

use std::io::Read;
use std::path::Path;

use serde::{Deserialize, Serialize};

use organza_core::error::{Error, Result};
use organza_core::input::open_regular;
use organza_core::scene::read_metadata;

/// The key of [`Progress`] in the metadata.
pub const PROGRESS: &str = "train";

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
