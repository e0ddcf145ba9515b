//! The folder of a run, to which one training process writes at a time.

use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

use super::checkpoint::{BEST, CHECKPOINT};
use super::report::PICTURES;
use super::tensorboard::TENSORBOARD;
use crate::error::{Error, Result};
use organza_core::remove_leftovers;

/// `config.toml`: all settings.
pub const CONFIG: &str = "config.toml";
/// `metrics.jsonl`: one record per line.
pub const METRICS: &str = "metrics.jsonl";
/// `cameras.json`: the refined cameras, if poses are refined.
pub const CAMERAS: &str = "cameras.json";
/// `report.html`: the report on one page.
pub const REPORT: &str = "report.html";
/// `evaluations.csv`: the scores of each held-out view in each evaluation.
pub const EVALUATIONS: &str = "evaluations.csv";

/// Files that a run writes directly into its folder.
const FILES: [&str; 7] = [CONFIG, CHECKPOINT, BEST, METRICS, CAMERAS, REPORT, EVALUATIONS];

/// Whether a path in a run's folder is that of a file that the run writes.
#[must_use]
pub fn is_run_file(path: &Path) -> bool {
    path.starts_with(PICTURES)
        || path.starts_with(TENSORBOARD)
        || FILES.iter().any(|name| path == Path::new(name))
}

/// The lock file. It is removed when the training ends.
const LOCK: &str = ".organza-lock";

/// A locked run folder. While this value lives, no other training writes to the folder.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    /// Dropped last, so the lock is released after the file is removed.
    _lock: File,
}

impl RunFolder {
    /// Locks an existing folder, and removes what a killed training left there.
    ///
    /// # Errors
    /// [`Error::Invalid`] if another training, which is named, has locked it; if it holds a run and `resume` is
    /// false; or if one of the run's files is a device, a pipe or a folder. [`Error::WriteFile`] if it cannot be
    /// written to.
    pub fn lock(path: &Path, resume: bool) -> Result<Self> {
        let invalid = |reason| Err(Error::Invalid { origin: path.to_owned(), reason });
        let file = path.join(LOCK);
        let lock = match lock(&file).map_err(|source| Error::write(&file, source))? {
            Ok(lock) => lock,
            Err(holder) => {
                return invalid(format!(
                    "another training writes to this folder ({holder}): wait for it, stop it, or \
                     name another folder"
                ));
            }
        };
        let folder = Self { path: path.to_owned(), _lock: lock };
        remove_leftovers(path);
        for name in FILES {
            // Links are not followed: one may lead to somebody else's file.
            let Ok(found) = fs::symlink_metadata(path.join(name)) else { continue };
            if !found.is_file() {
                return invalid(format!(
                    "{name} is a folder, a link, a device or a pipe, expected a file: remove it, \
                     or name another folder"
                ));
            }
            if !resume && [CONFIG, CHECKPOINT, BEST].contains(&name) {
                return invalid(format!(
                    "the folder already holds a run ({name}); continue it with `--resume`, or name \
                     another folder"
                ));
            }
        }
        for name in [PICTURES, TENSORBOARD] {
            if fs::symlink_metadata(path.join(name)).is_ok_and(|found| !found.is_dir()) {
                return invalid(format!(
                    "{name} is a file, a link, a device or a pipe, expected a folder: remove it, or \
                     name another folder"
                ));
            }
        }
        Ok(folder)
    }

    /// Path of the folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Does the work of dropping, for a program that exits at once: removes the lock file if it is this process's,
    /// and files that are still being written.
    pub fn clear(path: &Path) {
        let file = path.join(LOCK);
        if fs::read_to_string(&file).is_ok_and(|holder| holder == own_name()) {
            remove_leftovers(path);
            remove_leftovers(&path.join(PICTURES));
            let _ = fs::remove_file(file);
        }
    }
}

impl Drop for RunFolder {
    fn drop(&mut self) {
        // Whoever has opened it meanwhile finds it removed, and tries again.
        let _ = fs::remove_file(self.path.join(LOCK));
    }
}

/// Content of the lock file.
fn own_name() -> String {
    format!("process {}", std::process::id())
}

/// Locks the file, or returns who has locked it.
fn lock(path: &Path) -> io::Result<Result<File, String>> {
    loop {
        let mut file = open(path)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let mut holder = String::new();
                let _ = (&mut file).take(64).read_to_string(&mut holder);
                let is_named = holder.starts_with("process ");
                return Ok(Err(if is_named { holder } else { "another process".to_owned() }));
            }
            // The file system has no locks: the user must make sure that there is one writer.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {}
            Err(TryLockError::Error(error)) => return Err(error),
        }
        if is_at(&file, path) {
            let mut name = || {
                file.set_len(0)?;
                file.rewind()?;
                file.write_all(own_name().as_bytes())
            };
            if let Err(error) = name() {
                let _ = fs::remove_file(path);
                return Err(error);
            }
            return Ok(Ok(file));
        }
    }
}

/// Opens or creates the file, and never what has taken its place. Old content is overwritten.
fn open(path: &Path) -> io::Result<File> {
    let mut options = File::options();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(
        &mut options,
        libc::O_NOFOLLOW | libc::O_NONBLOCK,
    );
    let file = options.open(path)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::other("it is no regular file; remove it")),
    }
}

/// Whether an open file is still the one at its path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |found: fs::Metadata| (found.dev(), found.ino());
    let open = file.metadata().map(place);
    let named = fs::metadata(path).map(place);
    matches!((open, named), (Ok(open), Ok(named)) if open == named)
}

/// Always true: an open file cannot be removed.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let first = RunFolder::lock(folder.path(), false).unwrap();
        let text = RunFolder::lock(folder.path(), false).unwrap_err().to_string();
        let holder = format!("process {}", std::process::id());
        assert!(text.contains(&holder) && text.contains("another training"), "{text}");
        drop(first);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        drop(RunFolder::lock(folder.path(), false).unwrap());
    }

    #[test]
    fn what_a_killed_training_left_is_removed() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".organza-abc.tmp"), "half").unwrap();
        fs::write(folder.path().join(LOCK), "process 1, which has gone").unwrap();
        drop(RunFolder::lock(folder.path(), false).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_folder_in_the_place_of_a_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(METRICS)).unwrap();
        let text = RunFolder::lock(folder.path(), true).unwrap_err().to_string();
        assert!(text.contains("metrics.jsonl is a folder"), "{text}");
    }
}
