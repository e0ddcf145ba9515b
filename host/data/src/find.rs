//! Finds the photographs of a data set, and their masks, in its own folder unless more is allowed.
//!
//! Data sets are moved, packed and shrunk. So a photograph may be in another place than the data set says: below a
//! tail of its path, or smaller in `images_N`.

use std::ffi::OsStr;
use std::fs;
use std::path::{Component, Path, PathBuf};

use super::masks::{self, mask_of};
use super::paths::{IMAGES, is_there, sibling};
use organza_core::Result;
use organza_core::input::has_extension;

/// Most tails of a photograph's path that are tried: a path may have any length.
const DEEPEST: usize = 32;
/// Most files that are named as not used.
const MAX_NAMED: usize = 3;
/// Extensions that a name may lack.
const EXTENSIONS: [&str; 7] = ["", ".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"];

/// A photograph's file, and how to read it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PhotographFile {
    /// The photograph's file.
    pub path: PathBuf,
    /// Whether the file is in `images_N`, and so smaller already.
    pub prepared: bool,
    /// Path of its mask, in `masks` or `masks_N`.
    pub mask: Option<PathBuf>,
}

/// The photograph that a data set in `folder` calls `name`. It is `downscale` times smaller if such a file exists.
/// The error is the path where the whole one should be.
///
/// `mask` is the mask's path, according to the data set.
pub(super) fn photograph(
    folder: &Path,
    name: &str,
    mask: Option<&str>,
    downscale: u32,
) -> Result<PhotographFile, PathBuf> {
    // Files written on Windows have backslashes.
    let names = [name.to_owned(), name.replace('\\', "/")];
    let paths = || names.iter().flat_map(|name| tails(Path::new(name)));
    if downscale > 1 {
        let suffix = format!("_{downscale}");
        let images = format!("{IMAGES}{suffix}");
        let mut smaller = paths().filter_map(|path| sibling(&path, IMAGES, &images));
        if let Some(path) = smaller.find_map(|path| with_extension(folder, &path)) {
            let smaller = |mask: &str| {
                let mask = mask.replace('\\', "/");
                let by = |masks: &&str| sibling(mask.as_ref(), masks, &format!("{masks}{suffix}"));
                Some(named(folder, masks::FOLDERS.iter().find_map(by)?.to_str()?))
            };
            let found = mask.and_then(smaller).or_else(|| mask_of(folder, &path, &suffix));
            let whole = sibling(&path, &images, IMAGES);
            let whole_mask = whole.and_then(|whole| mask_of(folder, &whole, ""));
            // Without a mask, the smaller photograph would show what the mask hides.
            if found.is_some() || (mask.is_none() && whole_mask.is_none()) {
                return Ok(PhotographFile { path: folder.join(path), prepared: true, mask: found });
            }
        }
    }
    match paths().find_map(|path| with_extension(folder, &path)) {
        Some(path) => {
            let mask = match mask {
                Some(mask) => Some(named(folder, mask)),
                None => mask_of(folder, &path, ""),
            };
            Ok(PhotographFile { path: folder.join(path), prepared: false, mask })
        }
        None => Err(folder.join(name)),
    }
}

/// The file in `folder` that a data set calls `name`: at its path, or at a tail of it. If there is none, it is where the
/// path says, and reading it reports that.
pub(super) fn named(folder: &Path, name: &str) -> PathBuf {
    // Files written on Windows have backslashes.
    let names = [name.to_owned(), name.replace('\\', "/")];
    let last = names[1].rsplit('/').next().map(PathBuf::from);
    let paths = names.iter().flat_map(|name| tails(Path::new(name))).chain(last);
    let mut paths = paths.map(|path| folder.join(path));
    paths.find(|path| is_there(path)).unwrap_or_else(|| folder.join(name))
}

/// A note about PLY files in a data set's folders, if it has no points to start from.
pub(super) fn unused_clouds(folder: &Path, reason: &str) -> Vec<String> {
    let folders = ["", "sparse", "sparse/0", "colmap", "colmap/sparse/0"];
    let files =
        folders.iter().flat_map(|name| fs::read_dir(folder.join(name)).into_iter().flatten());
    let mut files: Vec<_> = files.flatten().map(|file| file.path()).collect();
    files.retain(|file| has_extension(file, &["ply"]) && is_there(file));
    files.sort();
    let say = |file: &PathBuf| {
        format!("{} is not used as points to start from: {reason}", file.display())
    };
    files.iter().take(MAX_NAMED).map(say).collect()
}

/// A path and its tails, the longest first: some programs write paths that start in a folder above the data set. A
/// tail has at least one folder, because different folders repeat the names of files.
fn tails(path: &Path) -> Vec<PathBuf> {
    let names: Vec<&OsStr> = path
        .components()
        .filter_map(|part| match part {
            Component::Normal(name) => Some(name),
            _ => None,
        })
        .collect();
    let longest = names.len().saturating_sub(DEEPEST + 1);
    let tails = longest..names.len().saturating_sub(1);
    let tails = tails.map(|first| names[first..].iter().collect());
    std::iter::once(path.to_owned()).chain(tails).collect()
}

/// The file `path` below `folder`, with an extension if it lacks one, or with another, because tools convert photographs;
/// `None` if it does not exist.
pub(super) fn with_extension(folder: &Path, path: &Path) -> Option<PathBuf> {
    let with = |extension: &&str| {
        let mut name = path.as_os_str().to_owned();
        name.push(extension);
        PathBuf::from(name)
    };
    let replaced = EXTENSIONS[1..].iter().filter_map(|extension| {
        let known =
            |old: &OsStr| EXTENSIONS.iter().any(|new| new.strip_prefix('.') == old.to_str());
        path.extension().filter(|old| known(old))?;
        Some(path.with_extension(&extension[1..]))
    });
    EXTENSIONS.iter().map(with).chain(replaced).find(|path| is_there(&folder.join(path)))
}
