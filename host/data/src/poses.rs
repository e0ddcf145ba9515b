//! A data set before its photographs are read: the photographs' paths, and their cameras.

use std::collections::{BTreeSet, HashSet};
use std::fs;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use parking_lot::Mutex;
use rayon::prelude::*;

use super::develop::Developed;
use super::find::PhotographFile;
use super::lens::{Lens, Projection};
use super::{
    Alpha, Background, Dataset, DatasetKind, DatasetOptions, Fingerprint, Frame, Layout, Shot,
    bytes_of, decode, develop, folder_of, hint, list, masks, own_point, panorama, photographs,
    repeated,
};
use organza_core::error::invalid;
use organza_core::memory;
use organza_core::scene::Placement;
use organza_core::{Camera, Error, Result};

/// Focal lengths of lenses, as multiples of an image's longer side: 160 degrees to half a degree.
const LIKELY_FOCALS: RangeInclusive<f64> = 0.08..=100.0;

/// The cameras of a data set. Reading them opens no photograph, so it is quick, and finds most mistakes in a data
/// set. [`Poses::photographs`] reads the photographs.
#[derive(Default)]
pub struct Poses {
    /// All that is known before the photographs are read. It has no frames yet.
    pub dataset: Dataset,
    /// The existing photographs.
    pub(super) shots: Vec<Shot>,
    pub(super) options: DatasetOptions,
    /// The data set's folder, without links.
    pub(super) folder: PathBuf,
    /// Photographs of frames that the data set calls bad, which are left out.
    pub(super) bad: Vec<PathBuf>,
    /// Whether frames were left out on purpose, so that there may be none to train on.
    pub(super) is_part: bool,
}

/// A camera of a data set.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The camera as training has it, undistorted and downscaled. Its `file_path` is the name of the frame.
    pub camera: Camera,
    /// Whether the frame is held out from training.
    pub held_out: bool,
    /// Path of the photograph; `None` if the frame has no file.
    pub photograph: Option<PathBuf>,
    /// Whether the photograph's lens is no pinhole, so that the photograph is undistorted when it is read.
    pub distorted: bool,
}

/// The camera alone, of no photograph.
impl From<Camera> for Pose {
    fn from(camera: Camera) -> Self {
        Self { camera, held_out: false, photograph: None, distorted: false }
    }
}

impl Poses {
    /// Reads the cameras of a data set, with the same `path` as [`Dataset::load`].
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`], except for the content of photographs.
    pub fn load(path: &Path, options: &DatasetOptions) -> Result<Self> {
        options.check()?;
        fs::metadata(path).map_err(|source| Error::read(path, source))?;
        let mut poses = Self::new(&folder_of(path), options)?;
        list(&mut poses)?;
        let is_white = poses.dataset.kind == DatasetKind::Blender
            && options.background == Background::Auto
            && options.alpha == Alpha::Background;
        if is_white {
            poses.options.background = Background::Color([1.0; 3]);
        }
        poses.dataset.notes.extend(poses.unlikely_lens());
        poses.dataset.notes.extend(poses.unused_masks());
        poses.dataset.notes.extend(poses.without_camera());
        if let Some(first) = poses.bad.first() {
            let bad = poses.bad.len();
            let first = first.display();
            let note = format!(
                "frames that the data set calls `is_bad` are left out: {bad}, such as {first}"
            );
            poses.dataset.notes.push(note);
        }
        let path = &poses.dataset.path;
        if let ([], [first, ..]) = (&*poses.shots, &*poses.dataset.missing) {
            let all = poses.dataset.missing.len();
            let hint = hint(path, Some(first)).unwrap_or_default();
            let first = first.display();
            let reason =
                format!("none of the {all} photographs exists; the first should be {first}{hint}");
            return invalid(path, reason);
        }
        let names = poses.shots.iter().map(|shot| &*shot.name);
        let held_out = options.trained_on.as_ref().and_then(|known| known.held_out_of(names));
        for (shot, held_out) in poses.shots.iter_mut().zip(held_out.into_iter().flatten()) {
            shot.held_out = held_out;
        }
        let shots = poses.shots.iter();
        let known = shots.map(|shot| (&*shot.name, &shot.camera, shot.lens, shot.held_out));
        poses.dataset.fingerprint = Fingerprint::new(known, &poses.dataset.points);
        let suggested = || {
            let cameras: Vec<_> = poses.shots.iter().map(|shot| shot.camera.clone()).collect();
            let points: Vec<_> = poses.dataset.points.iter().map(|point| point.position).collect();
            let placement = Placement::of(&cameras, &points);
            poses.dataset.block.as_ref().map_or(placement, |block| block.aligned(placement))
        };
        poses.place(options.placement.unwrap_or_else(suggested));
        Ok(poses)
    }

    /// A data set of which nothing has been read yet: a folder, or a file in one.
    pub(super) fn new(path: &Path, options: &DatasetOptions) -> Result<Self> {
        let folder = match path.parent() {
            _ if path.is_dir() => path,
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let folder = fs::canonicalize(folder).map_err(|source| Error::read(folder, source))?;
        let dataset = Dataset { path: path.to_owned(), ..Dataset::default() };
        Ok(Self { dataset, folder, options: options.clone(), ..Self::default() })
    }

    /// Checks a file of the data set before it is opened.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the file is outside, by its path or by a link on the way, and must not be.
    pub(super) fn check_place(&mut self, file: &Path) -> Result<()> {
        // A file that does not exist is not read either.
        let Ok(found) = fs::canonicalize(file) else { return Ok(()) };
        if found.starts_with(&self.folder) {
            return Ok(());
        }
        if !self.options.allow_outside {
            let reason = format!(
                "the data set names this file, but it is outside of {}; if you trust the data \
                 set, read it with `--allow-outside`",
                self.folder.display()
            );
            return invalid(file, reason);
        }
        self.dataset.outside.push(file.to_owned());
        Ok(())
    }

    /// Adds a photograph, or its pinhole views if its view is too wide for one plane. `camera` is the camera of the whole
    /// photograph, and has its name.
    pub(super) fn add(
        &mut self,
        PhotographFile { path, prepared, mask }: PhotographFile,
        camera: Camera,
        lens: Lens,
        held_out: bool,
    ) -> Result<()> {
        if let Some(mask) = &mask {
            self.check_place(mask)?;
        }
        let downscale = self.options.downscale;
        let (camera, factor) = match prepared {
            true => {
                let smaller = develop::prepared(&camera, downscale, decode::size(&path)?);
                (smaller.or_else(|reason| invalid(&path, reason))?, 1)
            }
            false => (camera, downscale),
        };
        self.dataset.prepared += usize::from(prepared);
        let name = camera.file_path.clone().unwrap_or_default();
        let pose = camera.camera_to_world;
        let shot = Shot { name, path, mask, camera, pose, lens, factor, held_out, trained: None };
        self.shots.extend(panorama::views_of(shot));
        Ok(())
    }

    /// A note if a camera sees much less than through any real lens, or nearly everything.
    fn unlikely_lens(&self) -> Option<String> {
        let focal = |shot: &Shot| {
            let Camera { fl_x, width, height, .. } = shot.camera;
            fl_x / f64::from(width.max(height))
        };
        let unlikely = |shot: &&Shot| {
            shot.lens.projection != Projection::Fisheye && !LIKELY_FOCALS.contains(&focal(shot))
        };
        let shot = self.shots.iter().find(unlikely)?;
        Some(format!(
            "the camera of {} has a focal length of {:.0} pixels, {} times the longer side of its image; are `fl_x` in \
             pixels and `camera_angle_x` in radians?",
            shot.path.display(),
            shot.camera.fl_x,
            significant(focal(shot))
        ))
    }

    /// A note if there are masks, but none for any photograph.
    fn unused_masks(&self) -> Option<String> {
        let path = &self.dataset.path;
        let root = if path.is_dir() { path } else { path.parent()? };
        let has_none = self.shots.iter().all(|shot| shot.mask.is_none());
        masks::unused(root, &self.shots.first().filter(|_| has_none)?.path)
    }

    /// A note of photographs that lie beside those with a camera, and have none.
    fn without_camera(&self) -> Option<String> {
        let is_whole = self.dataset.block.is_none();
        if !is_whole || !matches!(self.dataset.kind, DatasetKind::Nerfstudio | DatasetKind::Colmap)
        {
            return None;
        }
        let paths = self.shots.iter().map(|shot| &*shot.path);
        let known: HashSet<_> = paths.chain(self.bad.iter().map(PathBuf::as_path)).collect();
        let folders: BTreeSet<_> = known.iter().filter_map(|path| path.parent()).collect();
        let mut all = 0;
        let mut others = Vec::new();
        for folder in folders {
            let beside: Vec<_> = photographs(folder).collect();
            all += beside.len();
            let is_mask = |file: &Path| masks::is_mask(file, beside.iter().map(PathBuf::as_path));
            others.extend(
                beside.iter().filter(|file| !known.contains(&***file) && !is_mask(file)).cloned(),
            );
        }
        others.sort();
        let first = others.first()?.display();
        Some(format!(
            "{} of {all} photographs have no camera in the data set, such as {first}: they are not used",
            others.len()
        ))
    }

    /// Turns cameras and points into the coordinates of a scene. From here on, all of organza computes in these.
    fn place(&mut self, placement: Placement) {
        self.dataset.placement = placement;
        if placement.is_identity() {
            return;
        }
        for shot in &mut self.shots {
            shot.camera = placement.own_camera(&shot.camera);
        }
        for point in &mut self.dataset.points {
            point.position = own_point(&placement, point.position);
        }
    }

    /// Describes how frames and points differ from a run's; `None` if they do not.
    pub fn difference(&self, trained: &Fingerprint) -> Option<&'static str> {
        self.dataset.fingerprint.difference(trained)
    }

    /// Accepts only the photographs that a run was trained on: reading a changed one is an error.
    pub fn require(&mut self, trained: &Fingerprint) {
        let shots = &mut self.shots;
        let digests = trained.photographs();
        if digests.len() == shots.len() {
            shots.iter_mut().zip(digests).for_each(|(shot, digest)| shot.trained = Some(digest));
        }
    }

    /// Keeps only the frames for which `takes` is true. Its argument is whether the frame is held out. Nothing else is read.
    /// Photographs look the same as in the whole data set.
    #[must_use]
    pub fn only(mut self, takes: impl Fn(bool) -> bool) -> Self {
        self.shots.retain(|shot| takes(shot.held_out));
        self.is_part = true;
        self
    }

    /// Every camera, in the order of [`Dataset::frames`].
    ///
    /// # Errors
    /// [`Error::Invalid`] if downscaling leaves no pixel.
    pub fn cameras(&self) -> Result<Vec<Pose>> {
        let pose = |shot: &Shot| {
            let camera = shot.smaller_camera()?;
            Ok(Pose {
                camera: Camera { file_path: Some(shot.name.clone()), ..camera },
                held_out: shot.held_out,
                photograph: Some(shot.path.clone()),
                distorted: !shot.lens.is_pinhole(),
            })
        };
        self.shots.iter().map(pose).collect()
    }

    /// Moves cameras with [`Camera::moved`]. `motions` has an entry for each of [`Poses::cameras`], which is `None`
    /// for a camera that does not move.
    ///
    /// # Errors
    /// [`Error::Invalid`] if a moved camera is no longer valid.
    pub fn move_cameras(&mut self, motions: &[Option<[f64; 6]>]) -> Result<()> {
        let moved = self.shots.iter_mut().zip(motions).enumerate();
        for (index, (shot, motion)) in moved {
            let Some(motion) = motion else { continue };
            let moved = self.dataset.placement.world_camera(&shot.camera.moved(*motion));
            // as if a file had the moved camera, to the bit
            shot.camera = self.dataset.placement.own_camera(&moved);
            shot.camera.validate(index)?;
        }
        Ok(())
    }

    /// Reads one photograph, given its camera's index; `None` if there is no such camera.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`], for this photograph.
    pub fn photograph(&self, index: usize) -> Result<Option<Frame>> {
        let Some(shot) = self.shots.get(index) else { return Ok(None) };
        shot.at_once(decode::budget(0))?;
        shot.develop(&self.options).map(|developed| Some(developed.frame))
    }

    /// Reads the photographs. Calls `progress` with the number of finished photographs and of all photographs. The first
    /// call is before the first photograph.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`].
    pub fn photographs(self, progress: &mut (dyn FnMut(usize, usize) + Send)) -> Result<Dataset> {
        let Self { mut dataset, shots, options, is_part, .. } = self;
        let count = shots.len();
        let bytes = bytes_of(&shots);
        // checked before hours of reading
        memory::check(bytes, "the photographs (a larger `--downscale` makes them smaller)")?;
        let budget = decode::budget(bytes);
        let mut together = count.max(1);
        for shot in &shots {
            together = together.min(shot.at_once(budget)? as usize);
        }
        progress(0, count);
        let progress = Mutex::new((0, progress));
        let develop = |shot: &Shot| {
            let developed = shot.develop(&options)?;
            let mut progress = progress.lock();
            progress.0 += 1;
            let done = progress.0;
            (progress.1)(done, count);
            Ok(developed)
        };
        let mut digests = Vec::with_capacity(count);
        let mut off = Vec::new();
        for shots in shots.chunks(together) {
            let developed = shots.par_iter().map(develop).collect::<Result<Vec<_>>>()?;
            for Developed { frame, digest, is_masked, is_off } in developed {
                off.extend(is_off.then_some(dataset.frames.len()));
                dataset.frames.push(frame);
                digests.push(digest);
                dataset.masked += usize::from(is_masked);
            }
        }
        let seen = (0..count).filter(|&index| !dataset.frames[index].image.is_hidden());
        (dataset.held_out, dataset.train) = seen.partition(|&index| shots[index].held_out);
        if dataset.train.is_empty() && !is_part {
            let reason = match shots.iter().all(|shot| shot.held_out) {
                true => format!(
                    "every photograph that is there is held out ({count}), so none is left to train on; add \
                     photographs, or hold none out"
                ),
                false => "nothing is left to train on: masks or alpha hide each photograph whole; a mask is black, or darker than \
                          half of white, where it hides"
                    .to_owned(),
            };
            return invalid(&dataset.path, reason);
        }
        dataset.notes.extend(hidden(&shots, &dataset.frames));
        if let Some(first) = off.first() {
            dataset.notes.push(format!(
                "{} of {count} photographs are a pixel larger or smaller than their cameras' images, such as {}: what is too \
                 much is cut off at the right and lower edges, and what is missing does not count",
                off.len(),
                shots[*first].path.display()
            ));
        }
        let mask = shots.iter().find_map(|shot| shot.mask.as_ref());
        if let Some(mask) = mask.filter(|_| dataset.masked == 0) {
            dataset.notes.push(format!(
                "no mask hides anything, such as {}; a mask is darker than half of white where it hides",
                mask.display()
            ));
        }
        dataset.fingerprint = dataset.fingerprint.with_photographs(&digests);
        dataset.notes.extend(repeated(&shots, &digests));
        dataset.background = options.background.color().map(f64::from);
        dataset.poses = shots.iter().map(|shot| shot.pose).collect();
        Ok(dataset)
    }
}

/// A note if masks or alpha hide photographs whole. A view of a panorama may be hidden, such as a sky.
fn hidden(shots: &[Shot], frames: &[Frame]) -> Option<String> {
    let all = shots.iter().zip(frames);
    let hidden = all.filter(|(shot, frame)| shot.lens.cut.is_none() && frame.image.is_hidden());
    let hidden: Vec<_> = hidden.map(|(shot, _)| shot.path.display()).collect();
    let first = hidden.first()?;
    Some(format!(
        "masks or alpha hide {} of {} photographs whole, such as {first}: these are neither trained nor measured on",
        hidden.len(),
        shots.len()
    ))
}

/// A number with two digits.
fn significant(number: f64) -> String {
    if number < 10.0 { format!("{number:.2}") } else { format!("{number:.0}") }
}

/// The format of the data set in a folder, by the names of its files; `None` if there is no data set.
pub fn kind_of(folder: &Path) -> Option<DatasetKind> {
    Layout::detect(&folder_of(folder))?.kind()
}
