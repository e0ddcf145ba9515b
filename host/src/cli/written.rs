//! What earlier calls wrote to a folder of images, so that none of another scene stays beside the new ones.
//!
//! A hidden file in the folder, [`NAME`], lists each image that the program wrote: the SHA-256 of its content, and
//! that of what it was made from. At the end of a call the images that were made from something else are removed,
//! unless the call has written them anew. Nothing else is ever removed: no file that is not listed, and none whose
//! content is no longer what the program wrote.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io;
use std::path::{Component, Path, PathBuf};

use organza::{Camera, Error, Result, write_atomic};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::console::Console;
use super::output::Folder;
use super::summary::count;

/// The list's name.
const NAME: &str = ".organza-files.json";
/// Far more than any list needs; what is larger is not ours.
const MAX_BYTES: u64 = 64 << 20;

/// The list while a call writes.
#[derive(Debug)]
pub struct Written {
    folder: PathBuf,
    source: String,
    files: BTreeMap<String, Entry>,
    /// Names that this call has written.
    now: Vec<String>,
}

/// One image.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Entry {
    /// SHA-256 of the file.
    content: String,
    /// SHA-256 of the scene's file and of all cameras.
    source: String,
}

impl Written {
    /// Reads the list of a folder; a damaged one counts as empty. `scene` is the scene's file, and `cameras` are all
    /// of the file or data set: a call that renders some views does not make the others stale.
    pub fn open(folder: &Folder, scene: &Path, cameras: &[Camera]) -> Result<Self> {
        let mut hash = Sha256::new();
        copy(scene, &mut hash).map_err(|source| Error::read(scene, source))?;
        hash.update(format!("{cameras:?}"));
        let source = hex(hash);
        let files = read(&folder.join(NAME)).unwrap_or_default();
        Ok(Self { folder: folder.path().to_owned(), source, files, now: Vec::new() })
    }

    /// A file of the folder was written.
    pub fn add(&mut self, path: &Path) -> Result<()> {
        let content = digest(path).map_err(|source| Error::read(path, source))?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        self.files.insert(name.clone(), Entry { content, source: self.source.clone() });
        self.now.push(name);
        Ok(())
    }

    /// Removes what is stale, and says so; returns how many files that were.
    pub fn finish(mut self, console: Console) -> Result<usize> {
        let now = std::mem::take(&mut self.now);
        let (kept, stale): (BTreeMap<_, _>, BTreeMap<_, _>) = std::mem::take(&mut self.files)
            .into_iter()
            .partition(|(name, entry)| now.contains(name) || entry.source == self.source);
        self.files = kept;
        let (mut removed, mut changed) = (0, 0);
        for (name, entry) in stale {
            let path = self.folder.join(&name);
            if !is_name(&name) || !fs::symlink_metadata(&path).is_ok_and(|found| found.is_file()) {
                continue;
            }
            if digest(&path).is_ok_and(|content| content == entry.content) {
                fs::remove_file(&path).map_err(|source| Error::write(&path, source))?;
                removed += 1;
            } else {
                changed += 1;
            }
        }
        let folder = self.folder.display();
        if removed > 0 {
            let images = count(removed, "image");
            console.note(&format!("removed {images} of an earlier call from {folder}"));
        }
        if changed > 0 {
            let images = count(changed, "image");
            console.warn(&format!(
                "changed since an earlier call wrote them, so kept: {images} in {folder}"
            ));
        }
        self.save()?;
        Ok(removed as usize)
    }

    fn save(&mut self) -> Result<()> {
        let path = self.folder.join(NAME);
        let files = std::mem::take(&mut self.files);
        // Not through a link, nor to what somebody put there.
        if files.is_empty() || fs::symlink_metadata(&path).is_ok_and(|found| !found.is_file()) {
            return Ok(());
        }
        write_atomic(path, |writer| {
            serde_json::to_writer_pretty(&mut *writer, &files)?;
            writer.write_all(b"\n")
        })
    }
}

impl Drop for Written {
    /// A call that failed has written some files: the list knows them.
    fn drop(&mut self) {
        if !self.now.is_empty() {
            let _ = self.save();
        }
    }
}

fn read(path: &Path) -> Option<BTreeMap<String, Entry>> {
    let found = fs::symlink_metadata(path).ok()?;
    if !found.is_file() || found.len() > MAX_BYTES {
        return None;
    }
    serde_json::from_slice(&fs::read(path).ok()?).ok()
}

/// Whether it is the name of a file in the folder itself.
fn is_name(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None))
}

fn digest(path: &Path) -> io::Result<String> {
    let mut hash = Sha256::new();
    copy(path, &mut hash)?;
    Ok(hex(hash))
}

fn copy(path: &Path, hash: &mut Sha256) -> io::Result<()> {
    io::copy(&mut File::open(path)?, hash).map(|_| ())
}

fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
