//! Checks the places of results before hours are spent on them. A call removes and replaces nothing that it was not told to.

use std::fmt::Debug;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::{fs, io};

use organza::splats::Format;
use organza::train::FolderLock;
use organza::train::{self, CONFIG};
use organza::{Error, Result};
use organza_core::input::has_extension;
use sha2::{Digest, Sha256};

use super::inputs::FileKind;
use super::refuse;

/// Checks that a file can be written, and that it replaces nothing that the command reads.
pub fn check_file<'a>(path: &Path, inputs: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    refuse_replacing(path, inputs, replaced)?;
    organza_core::check_writable(path)
}

/// [`check_file`] for a scene. A name that promises another format is refused.
pub fn check_scene_file<'a>(path: &Path, inputs: impl IntoIterator<Item = &'a Path>) -> Result<()> {
    if Format::from_path(path).is_ok() {
        return refuse(format!(
            "{}: a scene is written as safetensors; choose a name that ends in .safetensors. `organza export` writes files \
             for other viewers",
            path.display()
        ));
    }
    check_file(path, inputs)
}

/// Says that a file leaves out an offset.
pub fn relative_to([x, y, z]: [f64; 3]) -> String {
    format!(
        "the scene is so far from the origin that positions of 32 bits would be rounded too much: those in the file are \
         relative to {x},{y},{z}"
    )
}

/// Fails if a folder holds a training run.
pub fn refuse_run(folder: &Path) -> Result<()> {
    match FileKind::from_path(folder) {
        Some(FileKind::Run) => {
            let folder = folder.display();
            refuse(format!("{folder} holds a training run; choose another folder"))
        }
        _ => Ok(()),
    }
}

/// Fails if writing to a path would replace what `replaced` names of an input: it gets the existing file and the input.
pub fn refuse_replacing<'a>(
    path: &Path,
    inputs: impl IntoIterator<Item = &'a Path>,
    replaced: fn(&Path, &Path) -> Option<String>,
) -> Result<()> {
    let Ok(existing) = fs::canonicalize(path) else { return Ok(()) };
    match inputs.into_iter().find_map(|input| replaced(&existing, input)) {
        Some(replaced) => {
            let path = path.display();
            refuse(format!("the output {path} would replace {replaced}; choose another"))
        }
        None => Ok(()),
    }
}

/// The input in words, if it is the existing file.
pub fn same(existing: &Path, input: &Path) -> Option<String> {
    let is_same = fs::canonicalize(input).is_ok_and(|full| full == existing);
    is_same.then(|| format!("the input {}", input.display()))
}

/// The input that an existing file is or belongs to, in words.
///
/// An input is a file, or the folder of a run or of a data set. All files of a run are inputs, and so is the data set
/// that it was trained on. In a data set's folder, every file of a kind that data sets have is one.
fn replaced(existing: &Path, input: &Path) -> Option<String> {
    if let Some(input) = same(existing, input) {
        return Some(input);
    }
    let full = fs::canonicalize(input).ok()?;
    let folder = if full.is_dir() { full.as_path() } else { full.parent()? };
    if folder.join(CONFIG).exists() {
        if existing.strip_prefix(folder).is_ok_and(train::is_run_file) {
            return Some(format!("a file of the run {}", folder.display()));
        }
        let data = train::settings_of(folder).ok()?.data.path?;
        return replaced(existing, &data);
    }
    const KINDS: [&str; 7] = ["json", "png", "jpg", "jpeg", "ply", "bin", "txt"];
    let is_of_data =
        full.is_dir() && existing.starts_with(folder) && has_extension(existing, &KINDS);
    is_of_data.then(|| format!("a file of the data set {}", input.display()))
}

/// A folder for results. Newly created folders that stay empty are removed again.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// Created folders, innermost first.
    made: Vec<PathBuf>,
    lock: Option<FolderLock>,
}

impl Folder {
    /// Creates the folder, and the folders above it, if it does not exist. Checks that it can be written to.
    pub fn make(path: &Path) -> Result<Self> {
        let missing =
            path.ancestors().take_while(|above| *above != Path::new("") && !above.exists());
        let folder =
            Self { path: path.to_owned(), made: missing.map(Path::to_owned).collect(), lock: None };
        if fs::metadata(path).is_ok_and(|found| !found.is_dir()) {
            return Err(Error::write(path, io::Error::other("it is a file, expected a folder")));
        }
        fs::create_dir_all(path).map_err(|error| {
            let file = path.ancestors().find(|above| above.is_file());
            let reason = file.map(|file| format!("{} is a file, not a folder", file.display()));
            let outermost = folder.made.last().map_or(path, PathBuf::as_path);
            Error::write(outermost, reason.map_or(error, io::Error::other))
        })?;
        organza_core::check_folder(path).map_err(|error| Error::write(path, error))?;
        Ok(folder)
    }

    /// Locks the folder until this value is dropped, so that no other call writes files into it.
    pub fn lock(&mut self) -> Result<()> {
        match FolderLock::take(&self.path)? {
            Ok(lock) => self.lock = Some(lock),
            Err(holder) => {
                let path = self.path.display();
                return refuse(format!(
                    "{path}: another command writes to this folder ({holder}); wait for it, or choose another folder"
                ));
            }
        }
        Ok(())
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

    /// Path of a file to write. Fails if a link or something else that is no file is in its place.
    pub fn file(&self, name: &str) -> Result<PathBuf> {
        let path = self.path.join(name);
        organza_core::check_inside(&path)?;
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // The lock's file is in the folder.
        self.lock = None;
        for path in &self.made {
            // Fails on purpose if the folder is not empty.
            let _ = fs::remove_dir(path);
        }
    }
}

/// Makes a folder for a step, in place of what a call that was stopped has left.
pub fn make_empty(folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|source| Error::write(folder, source))?;
    }
    fs::create_dir(folder).map_err(|source| Error::write(folder, source))
}

/// Identifies what a result is made of: the scene's file, the options, and the program.
pub fn made_of(scene: &Path, how: &dyn Debug) -> Result<String> {
    let mut hash = Sha256::new();
    File::open(scene)
        .and_then(|mut file| io::copy(&mut file, &mut hash))
        .map_err(|error| Error::read(scene, error))?;
    hash.update(format!("{how:?} {}", env!("CARGO_PKG_VERSION")));
    Ok(format!("{:x}", hash.finalize()))
}

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
