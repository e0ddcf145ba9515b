//! The folder of a run, which one process at a time writes to.

use std::fs;
use std::path::{Path, PathBuf};

use crate::FolderLock;
use organza_core::{Error, Result, remove_leftovers};
#[cfg(doc)]
use organza_data::Block;
use organza_data::block::BLOCK;

/// `checkpoint.safetensors`: the checkpoint.
pub const CHECKPOINT: &str = "checkpoint.safetensors";
/// `checkpoint.best.safetensors`: the checkpoint with the best held-out views.
pub const BEST: &str = "checkpoint.best.safetensors";
/// `config.toml`: all settings.
pub const CONFIG: &str = "config.toml";
/// `metrics.jsonl`: one record per line.
pub const METRICS: &str = "metrics.jsonl";
/// `cameras.json`: the refined cameras, if poses are refined.
pub const CAMERAS: &str = "cameras.json";
/// `report.html`: the report on one page.
pub const REPORT: &str = "report.html";
/// `pictures`: the folder of small pictures of held-out views, for the report.
pub const PICTURES: &str = "pictures";
/// `evaluations.csv`: the scores of each held-out view in each evaluation.
pub const EVALUATIONS: &str = "evaluations.csv";

/// `export.fit`: the Gaussians that the last export has fitted to the scene.
pub const FIT: &str = "export.fit";
/// `block.safetensors`: of the run of a [`Block`], the scene without the Gaussians of other blocks. `block.json` is the block itself.
pub const CROPPED: &str = "block.safetensors";

/// Files that a run, or a command about it, writes directly into its folder.
const FILES: [&str; 10] =
    [CONFIG, CHECKPOINT, BEST, METRICS, CAMERAS, REPORT, EVALUATIONS, FIT, CROPPED, BLOCK];

/// Whether the run writes the file of this path in its folder.
#[must_use]
pub fn is_run_file(path: &Path) -> bool {
    path.starts_with(PICTURES) || FILES.iter().any(|name| path == Path::new(name))
}

/// A locked run folder. While this value lives, no other training writes to the folder.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    _lock: FolderLock,
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
        let lock = match FolderLock::take(path)? {
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
            // Links are not followed: one may lead to another user's file.
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
        if fs::symlink_metadata(path.join(PICTURES)).is_ok_and(|found| !found.is_dir()) {
            return invalid(format!(
                "{PICTURES} is a file, a link, a device or a pipe, expected a folder: remove it, or \
                 name another folder"
            ));
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
        if FolderLock::clear(path) {
            remove_leftovers(path);
            remove_leftovers(&path.join(PICTURES));
        }
    }
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
    fn leftovers_of_a_killed_training_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".organza-abc.tmp"), "half").unwrap();
        fs::write(folder.path().join(".organza-lock"), "process 1, which has gone").unwrap();
        drop(RunFolder::lock(folder.path(), false).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
