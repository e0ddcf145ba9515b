//! Paths in a data set, as its folders name them.

use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

/// Name of the folder of photographs. `masks`, `images_2` and so on are beside it.
pub(super) const IMAGES: &str = "images";

/// The path with one of its folders replaced; `None` if it has no such folder.
pub(super) fn sibling(path: &Path, folder: &str, by: &str) -> Option<PathBuf> {
    let at = path.parent()?.components().position(|part| part.as_os_str() == folder)?;
    let replace = |(index, part): (usize, Component<'_>)| match index == at {
        true => OsStr::new(by).to_owned(),
        false => part.as_os_str().to_owned(),
    };
    Some(path.components().enumerate().map(replace).collect())
}

/// Whether there is something to read. If it is a pipe or a device, reading it reports that.
pub(super) fn is_there(path: &Path) -> bool {
    path.exists() && !path.is_dir()
}
