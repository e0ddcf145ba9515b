//! Where a data set may have its files: its own folder, unless more is allowed.

use std::fs;
use std::path::{Path, PathBuf};

use super::invalid;
use organza_core::error::{Error, Result};

/// What a data set's files may lead to, and which of them were outside its folder.
#[derive(Debug)]
pub(super) struct Reach {
    /// The folder, without links.
    folder: PathBuf,
    allow_outside: bool,
    /// The files outside, as the data set names them.
    pub outside: Vec<PathBuf>,
}

impl Reach {
    /// That of a data set: a folder, or a file in it.
    pub fn of(data: &Path, allow_outside: bool) -> Result<Self> {
        let folder = match data.parent() {
            _ if data.is_dir() => data,
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let folder = fs::canonicalize(folder).map_err(|source| Error::read(folder, source))?;
        Ok(Self { folder, allow_outside, outside: Vec::new() })
    }

    /// Checks a file that the data set names, before it is opened.
    ///
    /// # Errors
    /// [`Error::Invalid`] for one that is outside, by its path or by a link on the way, and must
    /// not be.
    pub fn check(&mut self, file: &Path) -> Result<()> {
        // What is not there is not read either.
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
