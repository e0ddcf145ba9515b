//! A data set before its photographs are read: the photographs' paths, and their cameras.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use rayon::prelude::*;

use super::decode::Budget;
use super::{
    Access, Background, Dataset, DatasetKind, DatasetOptions, Fingerprint, Frame, Layout, Listing,
    Point, Shot, bytes_of, folder_of, hint, invalid, list, repeated,
};
use organza_core::scene::Placement;
use organza_core::{Camera, Error, Result};

/// The cameras of a data set. Reading them opens no photograph, so it is quick, and finds most mistakes in a data
/// set. [`Poses::photographs`] reads the photographs.
pub struct Poses {
    /// Photographs of the data set that do not exist as files. Their frames are left out.
    pub missing: Vec<PathBuf>,
    /// Files outside of the data set's folder, as the data set names them.
    pub outside: Vec<PathBuf>,
    /// Warnings: clouds, masks and models that are not used, and cameras or photographs that cannot be right.
    pub notes: Vec<String>,
    /// Format of the data set.
    pub kind: DatasetKind,
    /// Path of the data set.
    pub path: PathBuf,
    /// Where the coordinates of cameras and points lie in the world, which is the files' own space.
    pub placement: Placement,
    /// The fingerprint of the files. It does not depend on the placement.
    pub(super) fingerprint: Fingerprint,
    pub(super) listing: Listing,
    pub(super) options: DatasetOptions,
    /// Whether frames were left out on purpose, so that there may be none to train on.
    pub(super) is_part: bool,
    /// Background of the photographs, once it is decided.
    background: OnceLock<[f32; 3]>,
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

impl Poses {
    /// Reads the cameras of a data set, with the same `path` as [`Dataset::load`].
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`], except for the content of photographs.
    pub fn load(path: &Path, options: &DatasetOptions) -> Result<Self> {
        options.check()?;
        fs::metadata(path).map_err(|source| Error::read(path, source))?;
        let path = &folder_of(path);
        let mut access = Access::new(path, options.allow_outside)?;
        let mut listing = list(path, options, &mut access)?;
        let missing = std::mem::take(&mut listing.missing);
        listing.notes.extend(listing.unlikely_lens());
        listing.notes.extend(listing.unused_masks(path));
        let notes = std::mem::take(&mut listing.notes);
        if let ([], [first, ..]) = (&*listing.shots, &*missing) {
            let all = missing.len();
            let hint = hint(path, Some(first)).unwrap_or_default();
            let first = first.display();
            let reason =
                format!("none of the {all} photographs exists; the first should be {first}{hint}");
            return invalid(path, reason);
        }
        let fingerprint = listing.fingerprint();
        let placement = options.placement.unwrap_or_else(|| listing.placement());
        listing.place(&placement);
        let outside = access.outside;
        let path = path.to_owned();
        let options = options.clone();
        let kind = listing.kind;
        let background = OnceLock::new();
        let is_part = false;
        Ok(Self {
            missing,
            outside,
            notes,
            kind,
            path,
            placement,
            fingerprint,
            listing,
            options,
            is_part,
            background,
        })
    }

    /// Describes how frames and points differ from a run's; `None` if they do not.
    #[must_use]
    pub fn difference(&self, trained: &Fingerprint) -> Option<&'static str> {
        self.fingerprint.difference(trained)
    }

    /// Accepts only the photographs that a run was trained on: reading a changed one is an error.
    pub fn require(&mut self, trained: &Fingerprint) {
        let shots = &mut self.listing.shots;
        let digests = trained.photographs();
        if digests.len() == shots.len() {
            shots.iter_mut().zip(digests).for_each(|(shot, digest)| shot.trained = Some(digest));
        }
    }

    /// Keeps only the held-out frames, or only those to train on. Nothing else is read. Photographs look the same as
    /// in the whole data set.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`].
    pub fn only(mut self, held_out: bool) -> Result<Self> {
        self.background()?;
        self.listing.shots.retain(|shot| shot.held_out == held_out);
        self.is_part = true;
        Ok(self)
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
        self.listing.shots.iter().map(pose).collect()
    }

    /// Moves cameras with [`Camera::moved`]. `motions` has an entry for each of [`Poses::cameras`], which is `None`
    /// for a camera that does not move.
    ///
    /// # Errors
    /// [`Error::Camera`] if a moved camera is no longer valid.
    pub fn move_cameras(&mut self, motions: &[Option<[f64; 6]>]) -> Result<()> {
        let moved = self.listing.shots.iter_mut().zip(motions).enumerate();
        for (index, (shot, motion)) in moved {
            let Some(motion) = motion else { continue };
            let moved = self.placement.world_camera(&shot.camera.moved(*motion));
            // as if a file had the moved camera, to the bit
            shot.camera = self.placement.own_camera(&moved);
            shot.camera.validate(index)?;
        }
        Ok(())
    }

    /// Reads one photograph, given its camera's index; `None` if there is no such camera.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`], for this photograph.
    pub fn photograph(&self, index: usize) -> Result<Option<Frame>> {
        let Some(shot) = self.listing.shots.get(index) else { return Ok(None) };
        let background = Background::Color(self.background()?);
        let options = DatasetOptions { background, ..self.options.clone() };
        shot.develop(&options, &Budget::beside(0)).map(|(frame, _)| Some(frame))
    }

    /// The background of the photographs. The first call may look at every photograph.
    pub(super) fn background(&self) -> Result<[f32; 3]> {
        if let Some(background) = self.background.get() {
            return Ok(*background);
        }
        let background = self.options.decide_background(&self.listing)?;
        Ok(*self.background.get_or_init(|| background))
    }

    /// The data set's points.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.listing.points
    }

    /// Reads the photographs. Calls `progress` with the number of finished photographs and of all photographs. The first
    /// call is before the first photograph.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`].
    pub fn photographs(self, progress: &mut (dyn FnMut(usize, usize) + Send)) -> Result<Dataset> {
        let background = self.background()?;
        let Self { missing, outside, kind, path, placement, .. } = self;
        let Self { fingerprint, listing, options, is_part, mut notes, .. } = self;
        let Listing { points, points_file, shots, prepared, .. } = listing;
        let options = DatasetOptions { background: Background::Color(background), ..options };
        let count = shots.len();
        let bytes = bytes_of(&shots);
        // checked before hours of reading
        let store = options.keep.store(bytes)?;
        let budget = Budget::beside(if store.is_some() { 0 } else { bytes });
        progress(0, count);
        let progress = Mutex::new((0, progress));
        let develop = |shot: &Shot| {
            let (mut frame, digest) = shot.develop(&options, &budget)?;
            if let Some(store) = &store {
                frame.image = frame.image.moved(store)?;
            }
            let mut progress = progress.lock().unwrap_or_else(PoisonError::into_inner);
            progress.0 += 1;
            let done = progress.0;
            (progress.1)(done, count);
            Ok((frame, digest))
        };
        let developed = shots.par_iter().map(develop).collect::<Result<Vec<_>>>()?;
        let (frames, digests): (Vec<_>, Vec<_>) = developed.into_iter().unzip();
        let seen = (0..count).filter(|&index| !frames[index].image.is_hidden());
        let (held_out, train): (Vec<_>, Vec<_>) = seen.partition(|&index| shots[index].held_out);
        if train.is_empty() && !is_part {
            let reason = format!(
                "all {count} photographs that are there are held out, so none is left to train on; \
                 add photographs, or hold none out"
            );
            return invalid(&path, reason);
        }
        let masked = shots.iter().filter(|shot| shot.mask.is_some()).count();
        let fingerprint = fingerprint.with_photographs(&digests);
        notes.extend(repeated(&shots, &digests));
        let background = background.map(f64::from);
        let poses = shots.iter().map(|shot| shot.pose).collect();
        Ok(Dataset {
            frames,
            train,
            held_out,
            background,
            points,
            points_file,
            missing,
            masked,
            prepared,
            outside,
            notes,
            kept_in: store.map(|store| store.folder().to_owned()),
            fingerprint,
            kind,
            path,
            placement,
            poses,
        })
    }
}

/// The format of the data set in a folder, by the names of its files; `None` if there is no data set.
#[must_use]
pub fn kind_of(folder: &Path) -> Option<DatasetKind> {
    Layout::detect(&folder_of(folder)).map(|layout| match layout {
        Layout::Nerfstudio(_) => DatasetKind::Nerfstudio,
        Layout::Blender(_) => DatasetKind::Blender,
        Layout::Colmap(_) => DatasetKind::Colmap,
    })
}
