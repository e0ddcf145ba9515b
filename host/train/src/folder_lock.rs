//! Locks of folders that the program writes into, so that two calls do not mix their files.

use std::fs::{self, File, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

use organza_core::{Error, Result};

/// The lock file. It is removed at the end.
const LOCK: &str = ".organza-lock";

/// A locked folder. While this value lives, no other call locks it.
#[derive(Debug)]
pub struct FolderLock {
    path: PathBuf,
    /// Dropped last, so the lock is released after the file is removed.
    _file: File,
}

impl FolderLock {
    /// Locks an existing folder, or returns the name of the process that has locked it.
    ///
    /// # Errors
    /// [`Error::WriteFile`] if the folder cannot be written to, or if something else is in the place of the lock file.
    pub fn take(folder: &Path) -> Result<Result<Self, String>> {
        let path = folder.join(LOCK);
        let locked = lock(&path).map_err(|source| Error::write(&path, source))?;
        Ok(locked.map(|file| Self { path, _file: file }))
    }

    /// Does the work of dropping, for a program that exits at once: removes the lock file if it names this process.
    /// Returns whether it does.
    pub fn clear(folder: &Path) -> bool {
        let path = folder.join(LOCK);
        let is_own = fs::read_to_string(&path).is_ok_and(|holder| holder == own_name());
        if is_own {
            let _ = fs::remove_file(path);
        }
        is_own
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        // A program that has opened it meanwhile finds it removed, and tries again.
        let _ = fs::remove_file(&self.path);
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

/// Opens or creates the file, and nothing else in its place. Old content is overwritten.
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
