//! What is in a folder already that images go to. A call removes and replaces nothing that it was not told to.

use std::fmt::Debug;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use organza::{Error, Result};
use organza_core::{hex, write_atomic};
use sha2::{Digest, Sha256};

use super::output::Folder;
use super::refuse;

/// The file that says which film a folder's frames are of.
const MARK: &str = ".organza-film";

/// The visible files of a folder.
fn visible(folder: &Folder) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder.path()).map_err(|error| Error::read(folder.path(), error))?;
    let paths = entries.flatten().map(|entry| entry.path());
    Ok(paths.filter(|path| !name(path).starts_with('.')).collect())
}

/// The name of a file, without its folder.
pub fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Fails if a folder has a visible file that is none of the call's own.
pub fn refuse_others(folder: &Folder, is_own: impl Fn(&str) -> bool) -> Result<()> {
    let mut files = visible(folder)?.into_iter();
    let Some(other) = files.find(|path| !is_own(&name(path))) else { return Ok(()) };
    refuse(format!(
        "{} has other files, such as {}; choose another folder, or pass --overwrite: it replaces images of the same \
         names and leaves the others",
        folder.path().display(),
        name(&other)
    ))
}

/// Prepares a folder for the frames of a film. Those that an earlier call made of the same scene and cameras stay; other
/// frames are removed with `overwrite`, and refused without it.
pub fn continue_film(
    folder: &Folder,
    scene: &Path,
    cameras: &dyn Debug,
    overwrite: bool,
) -> Result<()> {
    let mut film = Sha256::new();
    File::open(scene)
        .and_then(|mut file| io::copy(&mut file, &mut film))
        .map_err(|error| Error::read(scene, error))?;
    film.update(format!("{cameras:?}"));
    let film = hex(film);
    let mark = folder.file(MARK)?;
    if fs::read_to_string(&mark).is_ok_and(|found| found == film) {
        return Ok(());
    }
    if !overwrite {
        refuse_others(folder, |_| false)?;
    }
    let is_frame = |path: &PathBuf| {
        let name = name(path);
        let number = name.strip_suffix(".png").unwrap_or_default();
        number.len() == 5 && number.bytes().all(|digit| digit.is_ascii_digit()) && path.is_file()
    };
    for frame in visible(folder)?.into_iter().filter(is_frame) {
        fs::remove_file(&frame).map_err(|error| Error::write(&frame, error))?;
    }
    write_atomic(&mark, |writer| writer.write_all(film.as_bytes()))
}

/// Removes the frames, which are in the film now, and the folder if nothing else is in it.
pub fn remove_frames(folder: &mut Folder, frames: &[PathBuf]) -> Result<()> {
    for file in frames.iter().chain([&folder.join(MARK)]) {
        fs::remove_file(file).map_err(|error| Error::write(file, error))?;
    }
    organza_core::remove_leftovers(folder.path());
    folder.unlock();
    // It fails on purpose if there is another file in the folder.
    let _ = fs::remove_dir(folder.path());
    Ok(())
}
