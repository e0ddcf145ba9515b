//! Restricts the files of a data set to its own folder, unless more is allowed.

use std::fs;
use std::path::{Path, PathBuf};

use organza_core::error::{Error, Result};

/// The allowed places of a data set's files, and the files that were outside its folder.
#[derive(Debug)]
pub(super) struct Access {
    /// Path of the folder, without links.
    folder: PathBuf,
    allow_outside: bool,
    /// Files outside, as the data set names them.
    pub outside: Vec<PathBuf>,
}

impl Access {
    /// For a data set: a folder, or a file in it.
    pub fn new(data: &Path, allow_outside: bool) -> Result<Self> {
        let folder = match data.parent() {
            _ if data.is_dir() => data,
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let folder = fs::canonicalize(folder).map_err(|source| Error::read(folder, source))?;
        Ok(Self { folder, allow_outside, outside: Vec::new() })
    }

    /// Checks a file of the data set before it is opened.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the file is outside, by its path or by a link on the way, and must not be.
    pub fn check(&mut self, file: &Path) -> Result<()> {
        // A file that does not exist is not read either.
        let Ok(found) = fs::canonicalize(file) else { return Ok(()) };
        if found.starts_with(&self.folder) {
            return Ok(());
        }
        if !self.allow_outside {
            let reason = format!(
                "the data set names this file, but it is outside of {}; if you trust the data \
                 set, read it with `--allow-outside`",
                self.folder.display()
            );
            return invalid(file, reason);
        }
        self.outside.push(file.to_owned());
        Ok(())
    }
}

/// An error of a data set's file.
pub(super) fn invalid<T>(origin: &Path, reason: String) -> Result<T> {
    Err(Error::Invalid { origin: origin.to_owned(), reason })
}
