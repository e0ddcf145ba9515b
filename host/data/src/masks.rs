//! Masks of photographs: the names that programs give them, and the levels at which they hide.

use std::ffi::OsStr;
use std::fs;
use std::path::{Component, Path, PathBuf};

use super::decode::Decoded;
use super::paths::{IMAGES, is_there, sibling};

/// Folders of masks beside `images`, the first of which counts. RealityScan's begins with a dot.
pub(super) const FOLDERS: [&str; 3] = ["masks", "mask", ".mask"];
/// Endings of masks, the lossless ones first.
const ENDINGS: [&str; 6] = ["png", "PNG", "jpg", "JPG", "jpeg", "JPEG"];
/// What stands before and behind a photograph's name in a mask's. In the photographs' own folder, something does.
const AROUND: [[&str; 2]; 4] = [["", ""], ["", ".mask"], ["", "_mask"], [INVERTED, ""]];
/// The masks of instant-ngp, which are white where they hide.
const INVERTED: &str = "dynamic_mask_";

/// The mask in `folder` of the photograph at `path`, which `docs/data.md` says how to name. `suffix` ends the names of the folders of
/// smaller photographs and masks, as in `images_2`.
pub(super) fn mask_of(folder: &Path, path: &Path, suffix: &str) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let stem = path.file_stem()?.to_str()?;
    let around =
        |[before, after]: [&str; 2]| [name, stem].map(|name| format!("{before}{name}{after}"));
    let stems: Vec<_> = AROUND.into_iter().flat_map(around).collect();
    let within = |folder: &Path, stems: &[String]| {
        let names = |ending| stems.iter().map(move |stem| folder.join(format!("{stem}.{ending}")));
        ENDINGS.iter().flat_map(names).find(|file| is_there(file))
    };
    let images = format!("{IMAGES}{suffix}");
    let is_within =
        path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    let in_masks = FOLDERS.iter().find_map(|masks| {
        let masks = format!("{masks}{suffix}");
        let beside = sibling(path, &images, &masks);
        let mask = beside.or_else(|| is_within.then(|| Path::new(&masks).join(path)))?;
        let place = folder.join(mask.parent()?);
        place.is_dir().then(|| within(&place, &stems)).flatten()
    });
    in_masks.or_else(|| within(folder.join(path).parent()?, &stems[2..]))
}

/// Whether a file is the mask of one of the photographs beside it, by their names.
pub fn is_mask<'a>(file: &Path, mut beside: impl Iterator<Item = &'a Path>) -> bool {
    let Some(stem) = file.file_stem().and_then(OsStr::to_str) else { return false };
    let own = |[before, after]: &[&str; 2]| stem.strip_prefix(before)?.strip_suffix(after);
    let photographs: Vec<_> = AROUND[1..].iter().filter_map(own).map(OsStr::new).collect();
    let is_one = |other: &Path| {
        let mut names = [other.file_name(), other.file_stem()].into_iter().flatten();
        names.any(|name| photographs.contains(&name))
    };
    !photographs.is_empty() && beside.any(is_one)
}

/// Whether a folder's name is one of a folder of masks.
pub fn is_folder_of_masks(folder: &Path) -> bool {
    folder.file_name().is_some_and(|name| FOLDERS.iter().any(|masks| name == *masks))
}

/// Whether each pixel of a photograph is used, row by row, by its mask at `path`.
///
/// Below half of white, a mask hides. Two kinds have another white: masks of two levels, the lower of which is 0, and those whose
/// only level is 1. If a mask is not opaque, its alpha counts, and its color does not. But black paint on nothing hides.
pub(super) fn used(mask: &Decoded, path: &Path) -> impl Iterator<Item = bool> {
    let highest = |level: fn([f32; 4]) -> f32| mask.texels().map(level).fold(0.0, f32::max);
    let level: fn([f32; 4]) -> f32 = if highest(|texel| 1.0 - texel[3]) == 0.0 {
        color
    } else if highest(color) == 0.0 {
        |texel| 1.0 - texel[3]
    } else {
        |texel| texel[3]
    };
    let mut white = 0.0;
    let mut has_zero = false;
    let mut has_more = false;
    for level in mask.texels().map(level) {
        has_zero |= level == 0.0;
        has_more |= level != 0.0 && white != 0.0 && level != white;
        white = level.max(white);
    }
    if has_more || !(has_zero || white <= 1.0 / 255.0) {
        white = 1.0;
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let hides_white = name.starts_with(INVERTED);
    let is_light = move |level| level > 0.0 && level >= 0.5 * white;
    mask.texels().map(level).map(move |level| is_light(level) != hides_white)
}

fn color([red, green, blue, _]: [f32; 4]) -> f32 {
    red.max(green).max(blue)
}

/// A note if a data set has a folder of masks, and no photograph has one. `first` is a photograph.
pub(super) fn unused(root: &Path, first: &Path) -> Option<String> {
    let folders = FOLDERS.iter().map(|name| root.join(name));
    let folder = folders
        .into_iter()
        .find(|folder| fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some()))?;
    let name = first.file_name()?.to_string_lossy();
    Some(format!(
        "no file in {} is the mask of a photograph, so none is used; the mask of {} would be {name}.png, in the same folders as in \
         `images`, or named by the data set",
        folder.display(),
        first.display()
    ))
}
