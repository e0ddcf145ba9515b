//! The views to render, and the names of their files.

use std::collections::HashSet;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use organza::{Camera, Result};

use super::console::Console;
use super::refuse;

/// A list such as `0,8` or `0-3,8`, not yet checked against the number of cameras.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewList(Vec<RangeInclusive<usize>>);

impl FromStr for ViewList {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.split(',').map(range).collect::<Result<_, _>>().map(Self)
    }
}

/// Parses one item of a list: a view, or a range such as `0-3`.
fn range(item: &str) -> Result<RangeInclusive<usize>, String> {
    let (first, last) = item.split_once('-').unwrap_or((item, item));
    let first = index(first)?;
    let last = index(last)?;
    if first > last {
        return Err(format!("the range {first}-{last} runs backward"));
    }
    Ok(first..=last)
}

fn index(text: &str) -> Result<usize, String> {
    let bad = |_| format!("`{text}` is not a view; expected a list such as 0,8 or 0-3");
    text.trim().parse::<usize>().map_err(bad)
}

impl ViewList {
    /// The views in the order of the list, without duplicates. Errors call the cameras' file `cameras`.
    pub fn resolve(&self, count: usize, cameras: &Path) -> Result<Vec<usize>> {
        if let Some(range) = self.0.iter().find(|range| *range.end() >= count) {
            return no_view(*range.end(), count, cameras);
        }
        let mut seen = HashSet::new();
        Ok(self.0.iter().cloned().flatten().filter(|view| seen.insert(*view)).collect())
    }
}

/// The error for a view that does not exist.
pub fn no_view<T>(view: usize, count: usize, cameras: &Path) -> Result<T> {
    let cameras = cameras.display();
    let last = count.saturating_sub(1);
    refuse(format!("there is no view {view}: {cameras} has views 0 to {last}"))
}

/// Warns if images will not look like the photographs, which have lens distortion.
pub fn warn_distorted(console: Console, cameras: &[Camera], views: &[usize]) {
    let distorted = views.iter().filter(|&&view| cameras[view].distorted).count();
    if distorted > 0 {
        console.warn(&format!(
            "{distorted} of {} views were taken through a distorting lens; they are rendered \
             undistorted, as by a pinhole camera",
            views.len()
        ));
    }
}

/// A file name for each camera, without extension: the name of its photograph if all are different, else its index.
pub fn names(cameras: &[Camera]) -> Vec<String> {
    let mut seen = HashSet::new();
    let stem = |camera: &Camera| {
        let stem = stem(camera.file_path.as_deref()?)?;
        // Some file systems ignore case in names.
        seen.insert(stem.to_lowercase()).then_some(stem)
    };
    let stems: Option<Vec<_>> = cameras.iter().map(stem).collect();
    stems.unwrap_or_else(|| {
        let digits = cameras.len().saturating_sub(1).to_string().len().max(4);
        (0..cameras.len()).map(|view| format!("{view:0digits$}")).collect()
    })
}

/// The photographs that a camera may mean. Data sets may leave out the extension.
pub fn photographs(camera: &Camera, cameras: &Path) -> Vec<PathBuf> {
    let Some(path) = &camera.file_path else { return Vec::new() };
    let path = cameras.parent().unwrap_or(Path::new("")).join(path);
    let with_extension = path.with_added_extension("png");
    vec![path, with_extension]
}

/// The name of a file without its extension, if every system allows it.
fn stem(path: &str) -> Option<String> {
    let name = path.rsplit(['/', '\\']).next()?;
    let stem = match name.rsplit_once('.') {
        // The name `frame.0001` has no extension.
        Some((stem, extension)) if extension.contains(|c: char| c.is_alphabetic()) => stem,
        _ => name,
    };
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._- ".contains(c);
    let is_safe = stem.chars().all(is_plain)
        && stem.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_')
        && stem.ends_with(|c: char| c != ' ' && c != '.')
        && stem.len() <= 128
        && !is_reserved(stem);
    is_safe.then(|| stem.to_owned())
}

/// Names that Windows reserves for devices, with any extension.
fn is_reserved(stem: &str) -> bool {
    let name = stem.split('.').next().unwrap_or_default().trim_end().to_uppercase();
    let numbered = |device| name.strip_prefix(device).is_some_and(|rest| rest.len() == 1);
    ["CON", "PRN", "AUX", "NUL"].contains(&name.as_str()) || numbered("COM") || numbered("LPT")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cameras(paths: &[Option<&str>]) -> Vec<Camera> {
        let camera = |path: &Option<&str>| {
            let up = [0.0, 0.0, 1.0];
            let camera = Camera::look_at([1.0, 0.0, 0.0], [0.0; 3], up, 1.0, [4, 4]).unwrap();
            Camera { file_path: path.map(str::to_owned), ..camera }
        };
        paths.iter().map(camera).collect()
    }

    #[test]
    fn lists_and_ranges() {
        let resolve = |text: &str| {
            text.parse::<ViewList>()?.resolve(10, Path::new("c")).map_err(|e| e.to_string())
        };
        assert_eq!(resolve("0,8"), Ok(vec![0, 8]));
        assert_eq!(resolve("0-3"), Ok(vec![0, 1, 2, 3]));
        assert_eq!(resolve("9, 2-4,3"), Ok(vec![9, 2, 3, 4]));
        for (text, reason) in [
            ("99", "no view 99: c has views 0 to 9"),
            ("0-18446744073709551615", "no view 18446744073709551615"),
            ("3-1", "backward"),
            ("", "list such as"),
            ("1,,2", "list such as"),
            ("-1", "list such as"),
            ("a", "`a` is not a view"),
        ] {
            let found = resolve(text).unwrap_err();
            assert!(found.contains(reason), "{text}: {found}");
        }
    }

    #[test]
    fn names_are_the_photographs_where_they_can_be() {
        let named = |paths: &[Option<&str>]| names(&cameras(paths));
        assert_eq!(named(&[Some("images/a.png"), Some("images\\b.JPG")]), ["a", "b"]);
        assert_eq!(named(&[Some("./train/r_0"), Some("frame.0001")]), ["r_0", "frame.0001"]);
        for bad in [None, Some("x/A.png"), Some(".."), Some("é.png"), Some("nul.png"), Some("")] {
            assert_eq!(named(&[Some("a.png"), bad]), ["0000", "0001"], "{bad:?}");
        }
        assert!(names(&vec![cameras(&[None])[0].clone(); 10_001])[7] == "00007");
    }

    #[test]
    fn photographs_are_beside_the_cameras() {
        let camera = &cameras(&[Some("train/r_0")])[0];
        let found = photographs(camera, Path::new("data/transforms.json"));
        assert_eq!(found, [PathBuf::from("data/train/r_0"), PathBuf::from("data/train/r_0.png")]);
    }
}
