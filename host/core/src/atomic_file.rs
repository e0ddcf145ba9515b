//! Writing files so that a reader sees the old content or the new, never half of it.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// Prefix of the name of a file that is still being written.
const PREFIX: &str = ".organza-";
const SUFFIX: &str = ".tmp";

/// Writes a file through `fill`. The content goes to a temporary file beside it, is synced to disk, and is renamed
/// into place.
///
/// On any failure, the old file at `path` is untouched and nothing is left beside it. A symbolic link is followed. A
/// path that names a device or a pipe is written to directly.
///
/// # Errors
/// [`Error::WriteFile`] with the error of `fill` or of the file system.
pub fn write_atomic(
    path: impl AsRef<Path>,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<()> {
    let path = path.as_ref();
    write_inner(path, fill).map_err(|source| Error::write(path, source))
}

fn write_inner(path: &Path, fill: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    // Renaming over a link would replace the link and leave its target as it was.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&target).ok();
    match &old {
        Some(old) if old.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        // A rename would replace the device node itself, /dev/null for one.
        Some(old) if !old.is_file() => return write_direct(&target, fill),
        _ => {}
    }
    let folder = parent(&target);
    let mut beside = new_file_in(&folder)?;
    let mut writer = BufWriter::with_capacity(1 << 20, beside.as_file_mut());
    fill(&mut writer)?;
    writer.flush()?;
    drop(writer);
    if let Some(old) = old {
        beside.as_file().set_permissions(old.permissions())?;
    }
    beside.as_file().sync_all()?;
    beside.persist(&target).map_err(|error| error.error)?;
    sync_folder(&folder);
    Ok(())
}

fn write_direct(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut writer = BufWriter::new(File::options().write(true).open(path)?);
    fill(&mut writer)?;
    writer.flush()
}

/// Checks that a file in a folder of outputs can be written: that a regular file or nothing is in its place. The user
/// has named the folder, not the file, so a link in it may lead to another user's file, and a pipe may block forever.
///
/// # Errors
/// [`Error::WriteFile`] for a link, a folder, a pipe or a device.
pub fn check_inside(path: impl AsRef<Path>) -> Result<()> {
    let path = path.as_ref();
    match fs::symlink_metadata(path) {
        Ok(found) if !found.is_file() => {
            let reason = "it is a link, a folder, a pipe or a device, expected a file: remove it, or choose another folder";
            Err(Error::write(path, io::Error::other(reason)))
        }
        _ => Ok(()),
    }
}

/// Writes a file in a folder of outputs, as [`write_atomic`] does. Only a regular file is replaced: see
/// [`check_inside`].
///
/// # Errors
/// The same errors as [`write_atomic`] and [`check_inside`].
pub fn write_inside(
    path: impl AsRef<Path>,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<()> {
    check_inside(&path)?;
    write_atomic(path, fill)
}

/// Checks that [`write_atomic`] can write a file, before hours are spent on its content.
///
/// # Errors
/// [`Error::WriteFile`] if it cannot.
pub fn check_writable(path: impl AsRef<Path>) -> Result<()> {
    let path = path.as_ref();
    let check = || {
        match fs::metadata(path) {
            Ok(old) if old.is_dir() => {
                return Err(io::Error::other("it is a folder, expected a file"));
            }
            // A device or a pipe is written to as it is.
            Ok(old) if !old.is_file() => return Ok(()),
            _ => {}
        }
        let folder = parent(&fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()));
        if !fs::metadata(&folder)?.is_dir() {
            return Err(io::Error::other(format!("{} is a file, not a folder", folder.display())));
        }
        check_folder(&folder)
    };
    check().map_err(|source| Error::write(path, source))
}

/// Checks that files can be made in a folder.
///
/// # Errors
/// The system's.
pub fn check_folder(folder: &Path) -> io::Result<()> {
    new_file_in(folder).map(drop)
}

fn parent(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

fn new_file_in(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    // Temporary files are private by default; an output should be as readable as any other file.
    #[cfg(unix)]
    let permissions = std::os::unix::fs::PermissionsExt::from_mode(0o666);
    #[cfg(unix)]
    builder.permissions(permissions);
    builder.tempfile_in(folder)
}

/// Removes the leftovers of an interrupted program from a folder. No other program may be writing there.
pub fn remove_leftovers(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let name = entry.file_name();
        if name.to_str().is_some_and(|name| name.starts_with(PREFIX) && name.ends_with(SUFFIX)) {
            // a file that stays does no harm
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Syncs the folder, so that the rename survives a power cut. Not every file system can do this, so a failure is
/// ignored: the content is already safe.
fn sync_folder(folder: &Path) {
    if cfg!(unix)
        && let Ok(folder) = File::open(folder)
    {
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::chain;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn replaces_the_content() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.bin");
        for content in ["first", "second, longer", "3"] {
            write_atomic(&path, |writer| writer.write_all(content.as_bytes())).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), content);
        }
        assert_eq!(names(folder.path()), ["out.bin"]);
    }

    #[test]
    fn failure_keeps_the_old_content() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.bin");
        fs::write(&path, "old").unwrap();
        let error = write_atomic(&path, |writer| {
            writer.write_all(b"half")?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(chain(&error.unwrap_err()).contains("disk is full"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(names(folder.path()), ["out.bin"]);
    }

    #[test]
    fn missing_folder_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("absent/out.bin");
        let text = chain(&write_atomic(&path, |_| Ok(())).unwrap_err());
        assert!(text.contains("absent does not exist; create it first"), "{text}");
    }

    #[test]
    fn folder_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let error = write_atomic(folder.path(), |_| Ok(())).unwrap_err();
        assert!(matches!(error, Error::WriteFile { .. }), "{error}");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn device_is_written_to_and_stays() {
        use std::os::unix::fs::FileTypeExt;
        let error = write_atomic("/dev/full", |writer| writer.write_all(b"x")).unwrap_err();
        assert!(chain(&error).contains("disk is full"), "{error}");
        assert!(fs::metadata("/dev/full").unwrap().file_type().is_char_device());
    }

    #[cfg(unix)]
    #[test]
    fn link_is_followed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("real");
        let link = folder.path().join("link");
        fs::write(&path, "old").unwrap();
        std::os::unix::fs::symlink(&path, &link).unwrap();
        write_atomic(&link, |writer| writer.write_all(b"new")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    }

    #[cfg(unix)]
    #[test]
    fn mode_is_kept_and_else_ordinary() {
        use std::os::unix::fs::PermissionsExt;
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        let folder = tempfile::tempdir().unwrap();
        let ordinary = folder.path().join("ordinary");
        let path = folder.path().join("path");
        fs::write(&ordinary, "").unwrap();
        write_atomic(&path, |_| Ok(())).unwrap();
        assert_eq!(mode(&path), mode(&ordinary));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write_atomic(&path, |_| Ok(())).unwrap();
        assert_eq!(mode(&path), 0o640);
    }
}
