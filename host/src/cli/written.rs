//! Knows the images that earlier calls wrote to a folder, so that no image of another scene stays beside the new ones.
//!
//! Each image that the program writes has its [`Origin`] in its file. At the end of a call, images of another origin
//! are removed. Nothing else is ever removed: no file that says nothing of an origin, none that was changed or has
//! another name since, no link and no folder.

use std::ffi::OsStr;
use std::fmt::Debug;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use organza::image::{Marked, Origin, read_origin};
use organza::{Error, Result};
use sha2::{Digest, Sha256};

use super::console::Console;
use super::output::Folder;
use super::refuse;
use super::summary::count;

/// The images of a folder, and the origin of those that this call writes.
#[derive(Debug)]
pub struct Written {
    folder: PathBuf,
    origin: Origin,
}

/// The file under the name of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    Nothing,
    /// The image itself: an earlier call wrote it for the same scene and cameras.
    Image,
    /// An earlier call wrote it for another scene or other cameras, or with other options.
    Stale,
    /// No call has written it, or somebody has changed it.
    Foreign,
}

impl Written {
    /// `scene` is the scene's file. `cameras` are all cameras of the file or data set, with everything else that images
    /// depend on. So a call that renders some views does not make the others stale. `options` is what images depend on
    /// besides. An image with other options is not [`Found::Image`], but it is not removed for this reason.
    pub fn new(
        folder: &Folder,
        scene: &Path,
        cameras: &dyn Debug,
        options: &dyn Debug,
    ) -> Result<Self> {
        let mut source = Sha256::new();
        File::open(scene)
            .and_then(|mut file| io::copy(&mut file, &mut source))
            .map_err(|error| Error::read(scene, error))?;
        source.update(format!("{cameras:?}"));
        let options = Sha256::new_with_prefix(format!("{options:?}"));
        let origin = Origin::new(source, options);
        Ok(Self { folder: folder.path().to_owned(), origin })
    }

    /// The origin of the images that this call writes.
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// Indices of those `files` that do not exist yet. A file of somebody else in their place is kept, and is an
    /// error.
    pub fn missing<'a>(
        &self,
        files: impl IntoIterator<Item = &'a [PathBuf]>,
    ) -> Result<Vec<usize>> {
        let mut missing = Vec::new();
        for (index, files) in files.into_iter().enumerate() {
            for file in files {
                match self.found(file)? {
                    Found::Image => continue,
                    Found::Nothing | Found::Stale if missing.last() == Some(&index) => {}
                    Found::Nothing | Found::Stale => missing.push(index),
                    Found::Foreign => {
                        let folder = self.folder.display();
                        let file = file.display();
                        return refuse(format!(
                            "{file} is not an image that the program wrote, or was changed since; move it away from \
                             {folder}, or choose another place to write to"
                        ));
                    }
                }
            }
        }
        Ok(missing)
    }

    /// The file in the place of an image.
    pub fn found(&self, path: &Path) -> Result<Found> {
        Ok(match marked(path)? {
            Some(Marked { origin, unchanged: true }) if origin == self.origin => Found::Image,
            Some(Marked { unchanged: true, .. }) => Found::Stale,
            Some(_) => Found::Foreign,
            None if fs::symlink_metadata(path).is_ok() => Found::Foreign,
            None => Found::Nothing,
        })
    }

    /// Removes images of other scenes and cameras, with a note. Returns their number.
    pub fn remove_stale(&self, console: Console) -> Result<usize> {
        let [removed, changed] = self.remove(|origin| origin.source != self.origin.source)?;
        let folder = self.folder.display();
        if removed > 0 {
            let images = count(removed, "image");
            console.note(&format!("removed {images} of an earlier call from {folder}"));
        }
        if changed > 0 {
            let images = count(changed, "image");
            console.warn(&format!(
                "changed or renamed since an earlier call wrote them, so kept: {images} in {folder}"
            ));
        }
        Ok(removed as usize)
    }

    /// Removes all images that the program wrote. They have served their purpose.
    pub fn remove_all(&self) -> Result<()> {
        self.remove(|_| true).map(drop)
    }

    /// Removes images by their origin. Returns the number of these, and of others that were changed.
    fn remove(&self, is_stale: impl Fn(&Origin) -> bool) -> Result<[u64; 2]> {
        let mut removed = 0;
        let mut changed = 0;
        let entries =
            fs::read_dir(&self.folder).map_err(|source| Error::read(&self.folder, source))?;
        for entry in entries.flatten() {
            let path = entry.path();
            let is_image =
                ["png", "exr"].map(OsStr::new).contains(&path.extension().unwrap_or_default());
            if !is_image {
                continue;
            }
            match marked(&path)? {
                Some(found) if !is_stale(&found.origin) => {}
                Some(found) if found.unchanged => {
                    fs::remove_file(&path).map_err(|source| Error::write(&path, source))?;
                    removed += 1;
                }
                Some(_) => changed += 1,
                None => {}
            }
        }
        Ok([removed, changed])
    }
}

/// Reads the origin of an image. Returns `None` for what is no image of the program, and for nothing.
fn marked(path: &Path) -> Result<Option<Marked>> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        // A link may lead anywhere, and reading a pipe may block.
        Ok(found) if !found.is_file() => return Ok(None),
        _ => {}
    }
    read_origin(path).map_err(|source| Error::read(path, source))
}
