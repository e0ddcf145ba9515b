//! Checks the places of results before hours are spent on them.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use organza::{Error, Result};

use super::refuse;

/// Checks that a file can be written, and that it is not one of the inputs.
pub fn check_file(path: &Path, inputs: &[&Path]) -> Result<()> {
    refuse_inputs(path, inputs)?;
    organza_core::check_writable(path)
}

/// Fails if writing to a path would replace an input.
pub fn refuse_inputs(path: &Path, inputs: &[&Path]) -> Result<()> {
    match inputs.iter().find(|input| is_same(path, input)) {
        Some(input) => {
            let path = path.display();
            let input = input.display();
            refuse(format!("the output {path} would replace the input {input}; choose another"))
        }
        None => Ok(()),
    }
}

/// Whether two paths lead to the same existing file.
pub fn is_same(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// A folder for results. Newly created folders that stay empty are removed again.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// Created folders, innermost first.
    made: Vec<PathBuf>,
}

impl Folder {
    /// Creates the folder, and those above it, if it does not exist. Checks that it can be written to.
    pub fn make(path: &Path) -> Result<Self> {
        let missing =
            path.ancestors().take_while(|above| *above != Path::new("") && !above.exists());
        let folder = Self { path: path.to_owned(), made: missing.map(Path::to_owned).collect() };
        if fs::metadata(path).is_ok_and(|found| !found.is_dir()) {
            return Err(cannot_write(path, io::Error::other("it is a file, expected a folder")));
        }
        fs::create_dir_all(path).map_err(|error| {
            let file = path.ancestors().find(|above| above.is_file());
            let reason = file.map(|file| format!("{} is a file, not a folder", file.display()));
            let outermost = folder.made.last().map_or(path, PathBuf::as_path);
            cannot_write(outermost, reason.map_or(error, io::Error::other))
        })?;
        try_writing(path, path)?;
        Ok(folder)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The created folders, innermost first.
    pub fn made(&self) -> &[PathBuf] {
        &self.made
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        for path in &self.made {
            // Fails on purpose if the folder is not empty.
            let _ = fs::remove_dir(path);
        }
    }
}

/// Creates a file in a folder and removes it. Errors name `path`.
fn try_writing(folder: &Path, path: &Path) -> Result<()> {
    match tempfile::Builder::new().prefix(".organza-").suffix(".tmp").tempfile_in(folder) {
        Ok(_) => Ok(()),
        Err(error) => Err(cannot_write(path, error)),
    }
}

fn cannot_write(path: &Path, source: io::Error) -> Error {
    Error::write(path, source)
}
