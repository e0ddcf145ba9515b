//! A data set before its photographs are read: where they are, and the cameras that took them.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::{
    Background, Budget, Dataset, DatasetKind, DatasetOptions, Frame, Layout, Listing, Point, Reach,
    Shot, hint, invalid, list,
};
use crate::camera::Camera;
use crate::error::{Error, Result};

/// The cameras of a data set.  Reading them takes no photograph, so it is quick, and finds most of what may be
/// wrong with a data set.  [`Poses::photographs`] reads the rest.
pub struct Poses {
    /// Photographs that the data set names and that are not there; their frames are left out.
    pub missing: Vec<PathBuf>,
    /// Files that were read outside the data set's folder, as it names them.
    pub outside: Vec<PathBuf>,
    /// What kind of data set it is.
    pub kind: DatasetKind,
    /// What it was read from.
    pub path: PathBuf,
    pub(super) listing: Listing,
    pub(super) options: DatasetOptions,
    /// Whether frames were left out on purpose: there may be none to train on.
    pub(super) is_part: bool,
    /// What photographs are put in front of, once it was decided.
    background: OnceLock<[f32; 3]>,
}

/// A camera of a data set.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The camera as training has it: undistorted and downscaled. Its `file_path` is the name of
    /// the frame.
    pub camera: Camera,
    /// Whether the frame is kept from training.
    pub held_out: bool,
    /// Where the photograph is; `None` if the frame has no file.
    pub photograph: Option<PathBuf>,
}

impl Poses {
    /// Reads the cameras of a data set; `path` is as in [`Dataset::load`].
    ///
    /// # Errors
    /// Those of [`Dataset::load`] that are not about the content of a photograph.
    pub fn load(path: &Path, options: &DatasetOptions) -> Result<Self> {
        options.check()?;
        fs::metadata(path).map_err(|source| Error::read(path, source))?;
        let mut reach = Reach::of(path, options.allow_outside)?;
        let mut listing = list(path, options, &mut reach)?;
        let missing = std::mem::take(&mut listing.missing);
        if let ([], [first, ..]) = (&*listing.shots, &*missing) {
            let (all, first) = (missing.len(), first.display());
            let hint = hint(path).unwrap_or_default();
            let reason =
                format!("none of the {all} photographs exists; the first should be {first}{hint}");
            return invalid(path, reason);
        }
        let (outside, path, options) = (reach.outside, path.to_owned(), options.clone());
        let (kind, background) = (listing.kind, OnceLock::new());
        let is_part = false;
        Ok(Self { missing, outside, kind, path, listing, options, is_part, background })
    }

    /// The same without the frames that are held out, or without those to train on: nothing else is read. Photographs
    /// look as they do in the whole data set.
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
            })
        };
        self.listing.shots.iter().map(pose).collect()
    }

    /// Moves cameras, as [`Camera::moved`] does: those of the frames that have a motion here, in the order of [`Poses::cameras`].
    ///
    /// # Errors
    /// [`Error::Camera`] if a camera then is where no number reaches.
    pub fn move_cameras(&mut self, motions: &[Option<[f64; 6]>]) -> Result<()> {
        let moved = self.listing.shots.iter_mut().zip(motions).enumerate();
        for (index, (shot, motion)) in moved {
            let Some(motion) = motion else { continue };
            shot.camera = shot.camera.moved(*motion);
            shot.camera.validate(index)?;
        }
        Ok(())
    }

    /// Reads one photograph, by its camera's index; `None` if there is no such camera.
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`], for this photograph.
    pub fn photograph(&self, index: usize) -> Result<Option<Frame>> {
        let Some(shot) = self.listing.shots.get(index) else { return Ok(None) };
        let background = Background::Color(self.background()?);
        let options = DatasetOptions { background, ..self.options.clone() };
        shot.develop(&options, &Budget::beside(0)).map(|(frame, _)| Some(frame))
    }

    /// What photographs with an alpha channel are put in front of. It may take a look at every photograph, once.
    pub(super) fn background(&self) -> Result<[f32; 3]> {
        if let Some(background) = self.background.get() {
            return Ok(*background);
        }
        let background = self.options.decide_background(&self.listing)?;
        Ok(*self.background.get_or_init(|| background))
    }

    /// The points that the data set has.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.listing.points
    }

    /// Reads the photographs; `progress` is as in [`Dataset::load_with_progress`].
    ///
    /// # Errors
    /// The same errors as [`Dataset::load`].
    pub fn photographs(self, progress: &mut (dyn FnMut(usize, usize) + Send)) -> Result<Dataset> {
        Dataset::develop(self, progress)
    }
}

/// What kind of data set a folder holds, by the names of its files.  `None` if it holds no data set.
#[must_use]
pub fn kind_of(folder: &Path) -> Option<DatasetKind> {
    Layout::of(folder).map(|layout| match layout {
        Layout::Nerfstudio(_) => DatasetKind::Nerfstudio,
        Layout::Blender(_) => DatasetKind::Blender,
        Layout::Colmap(_) => DatasetKind::Colmap,
    })
}
