//! Photographs and their cameras, to train a scene on and to compare it with.
//!
//! Reads the data sets of nerfstudio, Blender (NeRF synthetic) and COLMAP: see `docs/data.md`.

pub mod block;
mod colmap;
mod decode;
mod develop;
mod find;
mod fingerprint;
pub mod fuzz;
mod gains;
mod lens;
pub mod masks;
mod options;
pub mod panorama;
mod paths;
mod photograph;
pub mod ply;
mod poses;
mod random;
mod split;
pub mod still_life;
pub mod sweep;
#[cfg(test)]
mod tests;
mod transforms;

use std::collections::HashMap;
use std::fs;
use std::hash::Hash;
use std::path::{Path, PathBuf};

pub use block::Block;
pub use colmap::SparseModel;
pub use decode::{encode_jpeg, size as photograph_size, upright};
use develop::Shot;
pub use develop::mean;
use fingerprint::Digest;
pub use fingerprint::Fingerprint;
use lens::Lens;
pub use options::{Alpha, Background, DatasetOptions};
#[cfg(doc)]
use organza_core::error::Error;
use organza_core::error::invalid;
use organza_core::input::{has_extension, read_json};
use organza_core::scene::{Placement, TrainedOn};
use organza_core::{Camera, Result};
pub use photograph::{DatasetKind, Frame, Photograph, Point};
pub use poses::{Pose, Poses, kind_of};
pub use random::random;
pub use split::Split;

/// The file of LLFF's poses, which are not read.
pub const LLFF: &str = "poses_bounds.npy";

/// Places of points in one unit of a scene, which the cameras see from four units.
const POINT_STEPS: f64 = 16384.0;

/// Photographs with poses.
///
/// ```
/// use organza_core::Camera;
/// use organza_data::{Dataset, Frame, Photograph};
///
/// // photographs of your own: here, gray ones from around the origin
/// let frames = (0..4_u8).map(|index| {
///     let angle = f64::from(index);
///     let eye = [3.0 * angle.cos(), 3.0 * angle.sin(), 1.0];
///     let camera = Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.8, [16, 16])?;
///     let image = Photograph::new([16, 16], vec![[128; 3]; 256], None)?;
///     Ok(Frame { name: format!("{index}"), camera, image })
/// });
/// let dataset = Dataset::from_frames(frames.collect::<organza_core::Result<_>>()?, 4);
/// assert_eq!((&dataset.train[..], &dataset.held_out[..]), (&[1, 2, 3][..], &[0][..]));
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Dataset {
    /// All frames, in the order of the file (nerfstudio), of the train file and then the test file (Blender), or of their
    /// names (COLMAP).
    pub frames: Vec<Frame>,
    /// Indices of the frames to train on, ascending. A frame of which no pixel is valid is neither here nor held out.
    pub train: Vec<usize>,
    /// Indices of the held-out frames, ascending.
    pub held_out: Vec<usize>,
    /// The color behind the scene: red, green and blue, 0 to 1.
    pub background: [f64; 3],
    /// Points from which training may start; empty if the data set has none.
    pub points: Vec<Point>,
    /// The file that the points were read from.
    pub points_file: Option<PathBuf>,
    /// Photographs of the data set that do not exist as files. Their frames are left out.
    pub missing: Vec<PathBuf>,
    /// Number of frames of which a mask hides something.
    pub masked: usize,
    /// Number of photographs that were smaller already, in a folder such as `images_2`.
    pub prepared: usize,
    /// Files outside of the data set's folder, as the data set names them.
    pub outside: Vec<PathBuf>,
    /// Warnings: clouds, masks and models that are not used, and cameras or photographs that cannot be right.
    pub notes: Vec<String>,
    /// Identifies the data set.
    pub fingerprint: Fingerprint,
    /// Format of the data set.
    pub kind: DatasetKind,
    /// Path of the data set; empty for frames that a caller made.
    pub path: PathBuf,
    /// Where the coordinates of cameras and points lie in the world, which is the files' own space.
    pub placement: Placement,
    /// Each frame's pose as the files give it, in the world.
    pub poses: Vec<[[f64; 4]; 4]>,
    /// The block of a split that the data set is.
    pub block: Option<Block>,
}

impl Dataset {
    /// Reads a data set: a folder, or a `transforms.json`. In a folder, the first of these is used:
    /// `transforms.json`, `transforms_train.json`, or a sparse model of COLMAP: `docs/data.md` has its places.
    ///
    /// If a photograph does not exist, it is listed in `missing` and its frame is left out. It still counts in the
    /// choice of held-out frames, so this choice does not change.
    ///
    /// # Errors
    /// [`Error::Argument`] for options out of range; [`Error::ReadFile`], [`Error::BadJson`] or
    /// [`Error::Invalid`] for files that are damaged, unknown or not supported, and if no frame is left
    /// to train on, or if a file is outside of the data set's folder and must not be;
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn load(path: impl AsRef<Path>, options: &DatasetOptions) -> Result<Self> {
        Poses::load(path.as_ref(), options)?.photographs(&mut |_, _| {})
    }

    /// The data set in the coordinates of a scene with this placement.
    #[must_use]
    pub fn placed(mut self, placement: Placement) -> Self {
        let from = std::mem::replace(&mut self.placement, placement);
        if from != placement {
            for (frame, &camera_to_world) in self.frames.iter_mut().zip(&self.poses) {
                let world = Camera { camera_to_world, ..frame.camera.clone() };
                frame.camera = placement.own_camera(&world);
            }
            for Point { position, .. } in &mut self.points {
                *position = own_point(&placement, from.world(*position));
            }
        }
        self
    }

    /// Indices of the frames to train on and of the held-out ones, as in the training of a scene. `None` if the data set has
    /// none of its photographs, or has the same ones already.
    #[must_use]
    pub fn split_as(&self, trained_on: &TrainedOn) -> Option<[Vec<usize>; 2]> {
        let held_out = trained_on.held_out_of(self.frames.iter().map(|frame| &*frame.name))?;
        let mut used = [&self.train[..], &self.held_out].concat();
        used.sort_unstable();
        let (held_out, train) = used.into_iter().partition(|&index| held_out[index]);
        (held_out != self.held_out).then_some([train, held_out])
    }

    /// The frames to train on.
    pub fn train_frames(&self) -> impl ExactSizeIterator<Item = &Frame> {
        self.train.iter().map(|&index| &self.frames[index])
    }

    /// The held-out frames.
    pub fn held_out_frames(&self) -> impl ExactSizeIterator<Item = &Frame> {
        self.held_out.iter().map(|&index| &self.frames[index])
    }

    /// A data set of frames that were not read from files, on a black background. Every `hold_out_every`-th frame is
    /// held out, starting with the first; 0 holds out none.
    pub fn from_frames(frames: Vec<Frame>, hold_out_every: usize) -> Self {
        let options = DatasetOptions { hold_out_every, ..Default::default() };
        Self::split(frames, |index| options.holds_out(index))
    }

    /// Like [`Self::from_frames`], with the frames held out for which `holds_out` is true.
    #[must_use]
    pub fn split(frames: Vec<Frame>, holds_out: impl Fn(usize) -> bool) -> Self {
        let (held_out, train) = (0..frames.len()).partition(|&index| holds_out(index));
        let known = frames
            .iter()
            .enumerate()
            .map(|(index, frame)| (&*frame.name, &frame.camera, Lens::default(), holds_out(index)));
        let fingerprint = Fingerprint::new(known, &[]);
        let poses = frames.iter().map(|frame| frame.camera.camera_to_world).collect();
        Self { frames, train, held_out, fingerprint, poses, ..Self::default() }
    }
}

/// A note if photographs are equal.
fn repeated(shots: &[Shot], digests: &[Digest]) -> Option<String> {
    let mut pairs = equal_pairs(digests.iter().zip(shots));
    // views of one panorama share its file
    pairs.retain(|[a, b]| b.lens.cut.is_none() || a.path != b.path);
    let split = pairs.iter().find(|[a, b]| a.held_out != b.held_out);
    let [a, b] = split.or(pairs.first())?;
    let mut note = there_twice([&a.path, &b.path], pairs.len());
    if split.is_some() {
        note += "; one of these is held out and the other trained on, so measurements are too good";
    }
    Some(note)
}

/// The items whose key is there already, each after the first with this key.
pub fn equal_pairs<'a, K: Eq + Hash, T>(
    items: impl Iterator<Item = (K, &'a T)>,
) -> Vec<[&'a T; 2]> {
    let mut first = HashMap::new();
    let pair = |(key, item)| [*first.entry(key).or_insert(item), item];
    items.map(pair).filter(|[a, b]| !std::ptr::eq(*a, *b)).collect()
}

/// Says that photographs are equal: one pair of all.
pub fn there_twice([a, b]: [&Path; 2], pairs: usize) -> String {
    let others = match pairs {
        1 => String::new(),
        pairs => format!(", and {} more such pairs", pairs - 1),
    };
    format!("the same photograph is there twice: {} and {}{others}", a.display(), b.display())
}

/// A point of the world in the scene's coordinates. It is rounded to a step finer than any data set's precision, so
/// that a run does not depend on the rounding in files.
fn own_point(placement: &Placement, position: [f64; 3]) -> [f64; 3] {
    if placement.is_identity() {
        return position;
    }
    placement.own(position).map(|x| (x * POINT_STEPS).round() / POINT_STEPS)
}

/// The files that make a folder a data set.
enum Layout {
    Nerfstudio(PathBuf),
    Blender(PathBuf),
    Colmap(colmap::Model),
    Block(PathBuf),
}

impl Layout {
    /// The layout of a folder.
    fn detect(folder: &Path) -> Option<Self> {
        let file = |name: &str| Some(folder.join(name)).filter(|path| path.exists());
        file(transforms::NERFSTUDIO)
            .map(Self::Nerfstudio)
            .or_else(|| file(transforms::BLENDER_TRAIN).map(Self::Blender))
            .or_else(|| colmap::find(folder).map(Self::Colmap))
            .or_else(|| file(block::BLOCK).map(|_| Self::Block(folder.to_owned())))
    }

    /// The format; a block has that of its data set.
    fn kind(&self) -> Option<DatasetKind> {
        match self {
            Self::Nerfstudio(_) => Some(DatasetKind::Nerfstudio),
            Self::Blender(_) => Some(DatasetKind::Blender),
            Self::Colmap(_) => Some(DatasetKind::Colmap),
            Self::Block(folder) => {
                let whole = Self::detect(&folder_of(&Block::load(folder).ok()?.data))?;
                if matches!(whole, Self::Block(_)) { None } else { whole.kind() }
            }
        }
    }
}

/// Recognizes the format of a data set, and lists its content.
fn list(poses: &mut Poses) -> Result<()> {
    let path = &*poses.dataset.path.clone();
    if !path.is_dir() {
        if is_video(path) {
            let reason = format!(
                "this is a video; `organza capture {} -o FOLDER` makes a data set of it",
                path.display()
            );
            return invalid(path, reason);
        }
        let is_blender = path.file_name().is_some_and(|name| name == transforms::BLENDER_TRAIN);
        return if is_blender {
            transforms::blender(poses, path)
        } else {
            transforms::nerfstudio(poses, path)
        };
    }
    match Layout::detect(path) {
        Some(Layout::Nerfstudio(file)) => transforms::nerfstudio(poses, &file),
        Some(Layout::Blender(file)) => transforms::blender(poses, &file),
        Some(Layout::Colmap(model)) => colmap::list(poses, &model),
        Some(Layout::Block(folder)) => block::list(poses, &folder),
        None => {
            let hint = hint(path, None).unwrap_or_default();
            let folders = colmap::FOLDERS.iter().filter(|folder| !folder.is_empty());
            let folders = folders.map(|folder| format!("{folder}, ")).collect::<String>();
            let reason = format!(
                "no data set was found here; looked for transforms.json (nerfstudio), \
                 transforms_train.json (Blender), and cameras.bin or cameras.txt of a sparse model (COLMAP) in \
                 {folders}numbered folders in these such as sparse/0, and the folder itself{hint}"
            );
            invalid(path, reason)
        }
    }
}

/// The photographs in a folder that can be read, by their names.
fn photographs(folder: &Path) -> impl Iterator<Item = PathBuf> {
    let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|file| file.path());
    files.filter(|path| has_extension(path, &["jpg", "jpeg", "png"]))
}

/// Whether a file's name has the ending of a photograph that is not read.
pub fn is_unread(path: &Path) -> bool {
    const UNREAD: [&str; 14] = [
        "heic", "heif", "tif", "tiff", "avif", "dng", "cr2", "cr3", "nef", "arw", "raf", "orf",
        "rw2", "webp",
    ];
    has_extension(path, &UNREAD)
}

/// What to do with files that are [not read](is_unread).
pub const CONVERT: &str = "HEIC, TIFF, AVIF, WebP, and DNG and other raw files are not read: convert them to JPEG first, or to PNG";

/// Whether a file's name has a video's ending.
pub fn is_video(path: &Path) -> bool {
    has_extension(path, &["3gp", "avi", "m2ts", "m4v", "mkv", "mov", "mp4", "mts", "webm"])
}

/// Suggests what to do if a folder has no data set, or if photographs are missing. `missing` is the first of them.
fn hint(path: &Path, missing: Option<&Path>) -> Option<String> {
    let path = if path.is_dir() { path } else { path.parent()? };
    let mut folders: Vec<_> =
        fs::read_dir(path).ok()?.flatten().map(|entry| entry.path()).collect();
    folders.sort();
    let (folders, files): (Vec<_>, Vec<_>) = folders.into_iter().partition(|path| path.is_dir());
    if let Some(missing) = missing {
        let name = |path: &Path| path.file_name().and_then(|name| name.to_str()).map(str::to_owned);
        let factor = |path: &PathBuf| name(path)?.strip_prefix("images_")?.parse::<u32>().ok();
        if let Some(factor) = folders.iter().find_map(factor) {
            return Some(format!("; images_{factor} is there: use it with `--downscale {factor}`"));
        }
        let beside = fs::read_dir(missing.parent()?).into_iter().flatten().flatten();
        let is_it = |file: &PathBuf| is_unread(file) && file.file_stem() == missing.file_stem();
        if let Some(unread) = beside.map(|file| file.path()).find(is_it) {
            return Some(format!("; {} is there, and {CONVERT}", unread.display()));
        }
        // files written on Windows have backslashes
        let missing = PathBuf::from(missing.to_string_lossy().replace('\\', "/"));
        let photograph = Path::new(missing.file_name()?);
        let has = |folder: &PathBuf| find::with_extension(folder, photograph).is_some();
        let others = [path.to_owned(), path.join("../images"), path.join("..")];
        if let Some(found) = folders.iter().cloned().chain(others).find(has) {
            // a tail of a photograph's path is enough
            let wanted = match missing.parent().filter(|parent| *parent != path) {
                Some(parent) => path.join(parent.file_name()?),
                None => path.to_owned(),
            };
            return Some(format!(
                "; photographs of these names are in {}: move them to {}",
                found.display(),
                wanted.display()
            ));
        }
    }
    let has_photographs = |folder: &PathBuf| photographs(folder).next().is_some();
    let named = [path.to_owned(), path.join("images")].into_iter().find(has_photographs);
    let named = named.or_else(|| folders.iter().any(has_photographs).then(|| path.to_owned()));
    let capture = named.map(|folder| {
        let folder = folder.display();
        format!("; `organza capture {folder} -o NEW` finds the poses of photographs")
    });
    if path.join(LLFF).exists() {
        let capture = capture.unwrap_or_default();
        return Some(format!("; the poses of LLFF, {LLFF}, are not read{capture}"));
    }
    if let Some(file) = files.iter().find(|file| is_record3d(file)) {
        return Some(format!(
            "; the poses of Record3D, {}, are not read: nerfstudio's `ns-process-data record3d` makes a data set of them",
            file.display()
        ));
    }
    let dense = ["dense/0", "dense"].map(|name| path.join(name));
    let mut nested = dense.into_iter().chain(folders);
    match nested.find(|folder| Layout::detect(folder).is_some()) {
        Some(nested) => Some(format!("; {} is a data set", nested.display())),
        None => capture.or_else(|| {
            if let Some(video) = files.iter().find(|file| is_video(file)) {
                let video = video.display();
                return Some(format!("; this folder has a video: `organza train {video} -o NEW`"));
            }
            files.iter().any(|file| is_unread(file)).then(|| format!("; {CONVERT}"))
        }),
    }
}

/// Whether a file has the poses of Record3D, of which an export has no cameras that are read.
fn is_record3d(file: &Path) -> bool {
    let is_named = file.file_name().is_some_and(|name| name == "metadata.json");
    is_named && read_json(file).is_ok_and(|json| json.get("poses").is_some())
}

/// The folder of the data set that a path names. The folder of its photographs names it, too.
fn folder_of(path: &Path) -> PathBuf {
    let parent = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let is_images = path.is_dir() && path.file_name().is_some_and(|name| name == "images");
    if is_images && Layout::detect(path).is_none() && Layout::detect(parent).is_some() {
        return parent.to_owned();
    }
    path.to_owned()
}

/// Most bytes that the photographs will take.
fn bytes_of(shots: &[Shot]) -> u64 {
    shots.iter().map(pixels).sum::<u64>() * size_of::<([u8; 3], bool, u8)>() as u64
}

/// Number of pixels of the reduced photograph.
fn pixels(shot: &Shot) -> u64 {
    let side = |side: u32| u64::from(side / shot.factor);
    side(shot.camera.width) * side(shot.camera.height)
}
