//! The source of a capture: a video, or photographs, which are known by their content.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

use organza::data::{CONVERT, equal_pairs, is_unread, is_video, masks, there_twice};
use organza::{Error, Result};
use organza_core::input::{has_extension, open_regular, read_file};
use sha2::{Digest, Sha256};

use super::{Matcher, SOME};
use crate::cli::console::Console;
use crate::cli::inputs::FileKind;
use crate::cli::output::name as name_of;
use crate::cli::summary::count;
use crate::cli::{quoted, refuse};

/// How deep photographs are looked for in a folder: a camera's are in `DCIM/100APPLE`.
const DEPTH: usize = 3;
/// Digits to which a number in a name is filled up to compare it.
const DIGITS: usize = 32;

/// The source of the images.
pub enum Source<'a> {
    Video(&'a Path),
    /// Photographs, in the natural order of their names.
    Photographs(Vec<Photograph>),
}

/// A photograph's file.
pub struct Photograph {
    pub path: PathBuf,
    /// Its name in the data set.
    pub name: String,
    /// SHA-256 of its content.
    digest: String,
}

impl<'a> Source<'a> {
    /// The video or the photographs that the user names.
    pub fn find(inputs: &'a [PathBuf], console: Console) -> Result<Self> {
        if let [path] = inputs {
            if fs::metadata(path).map_err(|source| Error::read(path, source))?.is_dir() {
                return Self::folder(path, console);
            }
            if !is_photograph(path) {
                return Ok(Self::Video(path));
            }
        }
        if let Some(other) = inputs.iter().find(|path| !is_photograph(path)) {
            let what = match other.is_dir() {
                true => format!("{} is a folder among other inputs", other.display()),
                false => format!("{} is neither JPEG nor PNG", other.display()),
            };
            return refuse(format!("{what}; expected one video, one folder, or photographs"));
        }
        let (masks, photographs) = apart(inputs.to_vec());
        warn_of_masks(console, masks.first());
        let named = photographs.iter().map(|path| (path.clone(), name_of(path)));
        Self::photographs(named.collect(), &inputs[0])
    }

    /// The photographs of a folder, or else of the folders in it.
    fn folder(path: &Path, console: Console) -> Result<Self> {
        let own = Listed::of(path)?;
        // a data set has masks and smaller photographs beside it
        let images = path.join("images");
        let is_data = Listed::of(&images).is_ok_and(|images| !images.photographs.is_empty());
        if is_data && own.photographs.is_empty() {
            let note =
                format!("taking photographs of {}, and of no folder beside it", images.display());
            console.note(&note);
            return Self::folder(&images, console);
        }
        let below = own.below(DEPTH);
        let [few, unread] = [below.photographs.len(), own.unread + below.unread]
            .map(|number| count(number as u64, "photograph"));
        if own.photographs.is_empty()
            && below.photographs.is_empty()
            && let Some(video) = &own.video
        {
            let reason = format!(
                "{} has a video, and no photographs: name {}",
                path.display(),
                quoted(video)
            );
            return refuse(reason);
        }
        let taken = match (own.photographs.is_empty(), below.photographs.first()) {
            (true, None) if own.unread + below.unread > 0 => {
                let path = path.display();
                return refuse(format!("{path} has only {unread} of other formats: {CONVERT}"));
            }
            (true, Some(first)) => {
                console
                    .note(&format!("taking {few} of folders within, such as {}", first.display()));
                below.photographs
            }
            (_, first) => {
                if let Some(first) = first {
                    let first = first.display();
                    console.note(&format!("not taking {few} of folders within, such as {first}"));
                }
                own.photographs
            }
        };
        if own.unread + below.unread > 0 {
            console.warn(&format!("not taking {unread}: {CONVERT}"));
        }
        warn_of_masks(console, own.masks.iter().chain(&below.masks).next());
        // Cameras begin each folder with the same names.
        let name = |file: &Path| {
            let inside = file.strip_prefix(path).unwrap_or(file);
            inside.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("-")
        };
        let named = taken.into_iter().map(|file| (name(&file), file));
        Self::photographs(named.map(|(name, file)| (file, name)).collect(), path)
    }

    /// The photographs of some files with their names. Errors call them `named`.
    fn photographs(files: Vec<(PathBuf, String)>, named: &Path) -> Result<Self> {
        let mut paths = HashMap::new();
        for (path, name) in &files {
            if let Some(other) = paths.insert(name, path) {
                let [path, other] = [path, other].map(|path| path.display());
                return refuse(format!(
                    "two photographs have the same name, {other} and {path}; rename one of them"
                ));
            }
        }
        if files.len() < 3 {
            let photographs = count(files.len() as u64, "photograph");
            let named = named.display();
            return refuse(format!(
                "{named}: {photographs}, expected 3 or more: JPEG or PNG files"
            ));
        }
        let read = |(path, name): (PathBuf, String)| {
            let bytes = read_file(&path, u64::MAX, "a photograph")?;
            Ok(Photograph { path, name, digest: format!("{:x}", Sha256::digest(bytes)) })
        };
        let mut photographs = files.into_iter().map(read).collect::<Result<Vec<_>>>()?;
        sort_naturally(&mut photographs, |photograph| photograph.name.clone());
        Ok(Self::Photographs(photographs))
    }

    /// Pads numbers in names with zeros, if neighbors are to be compared: COLMAP sorts names by letters, and would have other neighbors.
    pub fn number(&mut self, matcher: Option<Matcher>, console: Console) {
        let Self::Photographs(photographs) = self else { return };
        let is_sequential =
            matcher.map_or(photographs.len() > SOME, |matcher| matcher == Matcher::Sequential);
        if !is_sequential || photographs.is_sorted_by_key(|photograph| &photograph.name) {
            return;
        }
        let longest = photographs.iter().flat_map(|photograph| {
            photograph.name.split(|c: char| !c.is_ascii_digit()).map(str::len)
        });
        let digits = longest.max().unwrap_or(0);
        let padded: Vec<_> = photographs.iter().map(|photo| padded(&photo.name, digits)).collect();
        // `1` and `01` are two photographs.
        if padded.windows(2).any(|pair| pair[0] == pair[1]) {
            return;
        }
        let [old, new] = [&photographs[0].name, &padded[0]];
        console.note(&format!("filling up numbers in names with zeros, because COLMAP sorts by letters: {old} becomes {new}"));
        for (photograph, name) in photographs.iter_mut().zip(padded) {
            photograph.name = name;
        }
    }

    /// Identifies the content, wherever its files are. Names of photographs count, because images keep them.
    pub fn content(&self) -> Result<String> {
        let mut hash = Sha256::new();
        match self {
            Self::Video(path) => {
                let (mut file, _) = open_regular(path)?;
                io::copy(&mut file, &mut hash).map_err(|source| Error::read(path, source))?;
            }
            Self::Photographs(photographs) => {
                for Photograph { name, digest, .. } in photographs {
                    hash.update(format!("{name:?} {digest}\n"));
                }
            }
        }
        Ok(format!("{:x}", hash.finalize()))
    }

    /// What to say if photographs are equal.
    pub fn copies(&self) -> Option<String> {
        let Self::Photographs(photographs) = self else { return None };
        let pairs = equal_pairs(photographs.iter().map(|photo| (&photo.digest, photo)));
        let [a, b] = pairs.first()?;
        let note = there_twice([&a.path, &b.path], pairs.len());
        Some(format!(
            "{note}. A copy shows nothing new, and a held-out one makes measurements too good: leave copies out"
        ))
    }
}

/// Sorts by names as people do: numbers in them count as numbers, so 2 is before 10.
pub fn sort_naturally<T>(items: &mut [T], name: impl Fn(&T) -> String) {
    items.sort_by_cached_key(|item| {
        let name = name(item);
        (padded(&name, DIGITS), name)
    });
}

/// A name whose numbers have at least this many digits.
pub fn padded(name: &str, digits: usize) -> String {
    let mut padded = String::new();
    let mut rest = name;
    while let Some(begin) = rest.find(|c: char| c.is_ascii_digit()) {
        let (text, number) = rest.split_at(begin);
        let end = number.find(|c: char| !c.is_ascii_digit()).unwrap_or(number.len());
        padded += text;
        padded += &format!("{:0>digits$}", &number[..end]);
        rest = &number[end..];
    }
    padded + rest
}

/// What a folder has, without hidden files: macOS writes `._IMG_1.JPG` beside `IMG_1.JPG`.
#[derive(Default)]
struct Listed {
    photographs: Vec<PathBuf>,
    /// Masks of these, which are no photographs.
    masks: Vec<PathBuf>,
    folders: Vec<PathBuf>,
    video: Option<PathBuf>,
    /// Number of photographs in formats that are not read.
    unread: usize,
}

impl Listed {
    fn of(folder: &Path) -> Result<Self> {
        let entries = fs::read_dir(folder).map_err(|source| Error::read(folder, source))?;
        let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        paths.retain(|path| !name_of(path).starts_with('.'));
        paths.sort();
        let unread = paths.iter().filter(|path| is_unread(path)).count();
        let (folders, files): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_dir());
        let video = files.iter().find(|file| is_video(file)).cloned();
        let (masks, photographs) = apart(files.into_iter().filter(|f| is_photograph(f)).collect());
        Ok(Self { photographs, masks, folders, video, unread })
    }

    fn has_any(&self) -> bool {
        !self.photographs.is_empty() || self.unread > 0
    }

    /// The files of its folders, and of folders within them. A folder that may not be read has none.
    fn below(&self, depth: usize) -> Self {
        let mut found = Self::default();
        let folders = self.folders.iter().filter(|folder| !masks::is_folder_of_masks(folder));
        for folder in folders.filter(|_| depth > 0) {
            let own = Self::of(folder).unwrap_or_default();
            let below = own.below(depth - 1);
            found.photographs.extend(own.photographs.into_iter().chain(below.photographs));
            found.masks.extend(own.masks.into_iter().chain(below.masks));
            found.unread += own.unread + below.unread;
        }
        found
    }
}

/// Masks of photographs, and the photographs.
fn apart(files: Vec<PathBuf>) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let is_mask = |file: &PathBuf| masks::is_mask(file, files.iter().map(PathBuf::as_path));
    files.iter().cloned().partition(is_mask)
}

fn warn_of_masks(console: Console, first: Option<&PathBuf>) {
    let Some(first) = first else { return };
    console.warn(&format!(
        "masks are not used, such as {}: COLMAP removes the lens distortion from photographs, and not from masks; put masks of \
         its images into the data set's folder `masks`",
        first.display()
    ));
}

/// Whether a folder has photographs, or folders within it, none of which is a data set.
pub fn has_photographs(folder: &Path) -> bool {
    let own = Listed::of(folder).unwrap_or_default();
    let has_data = own.folders.iter().any(|folder| FileKind::from_path(folder).is_some());
    own.has_any() || (!has_data && own.below(DEPTH).has_any())
}

/// Whether a file's name has a photograph's ending.
fn is_photograph(path: &Path) -> bool {
    has_extension(path, &["jpg", "jpeg", "png"])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_count_as_numbers() {
        let mut names =
            ["Photo (10).jpg", "Photo (2).jpg", "a", "Photo (9).jpg", "2-10", "2-9", "02-9"];
        sort_naturally(&mut names, |name| (*name).to_owned());
        let expected =
            ["02-9", "2-9", "2-10", "Photo (2).jpg", "Photo (9).jpg", "Photo (10).jpg", "a"];
        assert_eq!(names, expected);
        assert_eq!(padded("Photo (2) 345.jpg", 3), "Photo (002) 345.jpg");
    }
}
