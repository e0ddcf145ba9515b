//! Removes parts of a scene for a page.
//!
//! The scene on the device is replaced by one of the Gaussians that are left. So every image and number shows them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::message::{MAX_SIDE, check};
use super::photographs::Photographs;
use super::stage::Stage;
use organza_core::error::refuse;
use organza_core::image::{ChannelImage, TILE_SIDE};
use organza_core::scene::{Gaussians, Scene, is_in_box};
use organza_core::{Camera, Channel, Result, TileBatch, check_writable};
use organza_data::Pose;
use organza_render::{Contributions, DeviceScene, UploadOptions};

/// Most places of selected Gaussians in an answer.
const MAX_PLACES: usize = 4000;
/// Most places of a stroke.
const MAX_STROKE: usize = 1000;
/// Longest side of the image whose depth says what a brush reaches, in pixels.
const DEPTH_SIDE: u32 = 256;
/// A brush selects what is no farther than this part of the depth behind it.
const BEHIND: f64 = 0.12;

/// A change that a page asks for.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum EditRequest {
    /// Changes nothing.
    Look,
    /// Selects what is under a brush.
    Paint(Box<Stroke>),
    /// Selects nothing.
    Clear,
    /// Removes what is selected.
    Remove,
    /// Removes what is inside a box, or outside.
    Crop(Crop),
    /// Hides what most views see through, with a strength of 0 to 1, in place of what it has hidden before.
    Clean(f64),
    /// Removes what is hidden.
    Keep,
    /// Says how many meters one world unit has.
    Meters(f64),
    /// Takes back the last removal.
    Undo,
    /// Writes the scene.
    Save,
}

/// Places of a brush.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stroke {
    camera: Camera,
    /// Columns and rows in the camera's image, in pixels.
    places: Vec<[f64; 2]>,
    /// In pixels.
    radius: f64,
}

impl Stroke {
    /// Whether the stroke passes over a place.
    fn is_over(&self, at: DVec2) -> bool {
        let next = self.places.iter().skip(1).chain(self.places.last());
        self.places.iter().zip(next).any(|(&from, &to)| {
            let from = DVec2::from(from);
            let way = DVec2::from(to) - from;
            let along = (at - from).dot(way) / way.length_squared().max(1e-12);
            at.distance(from + along.clamp(0.0, 1.0) * way) <= self.radius
        })
    }
}

/// A box along the axes.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Crop {
    low: [f32; 3],
    high: [f32; 3],
    /// Whether to remove what is outside.
    outside: bool,
}

/// The answer to the page.
#[derive(Debug, Serialize)]
struct Answer {
    left: usize,
    selected: usize,
    /// Places of selected Gaussians; some of them if there are many.
    places: Vec<[f32; 3]>,
    removals: usize,
    clean: Clean,
    saved: Option<String>,
}

/// What [`EditRequest::Clean`] hides.
#[derive(Debug, Default, Serialize)]
struct Clean {
    /// Views that were looked at, of this many: those of each look.
    seen: usize,
    views: usize,
    /// Hidden Gaussians, and their share of the views' pixels.
    hidden: usize,
    weight: f64,
}

/// What Gaussians contribute to the views of the data set.
#[derive(Debug)]
struct Measured {
    /// The scene of these Gaussians was measured.
    gaussians: Vec<usize>,
    /// `None` after the last view.
    scene: Option<DeviceScene>,
    found: Contributions,
    /// Views of all looks.
    seen: usize,
}

/// The scene that is edited.
#[derive(Debug)]
pub struct Editor {
    all: Gaussians,
    /// The scene of the Gaussians that are left.
    scene: Scene,
    shown: Option<Arc<DeviceScene>>,
    options: UploadOptions,
    /// The scene's file, from which the names of further ones follow.
    file: PathBuf,
    /// Indices of the Gaussians that are left, ascending.
    left: Vec<usize>,
    /// Which of them are selected.
    selected: Vec<bool>,
    /// The Gaussians of each removal, the last one last.
    removals: Vec<Vec<usize>>,
    /// Whether the last removal only hides.
    is_hidden: bool,
    poses: Vec<Pose>,
    measured: Option<Measured>,
    /// Number of changes to what is shown.
    version: u64,
}

impl Editor {
    /// An editor of a scene, which writes to `file`. `poses` are the views that show Gaussians.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::Error::Invalid) if the file exists, and errors of writing there.
    pub fn new(
        scene: Scene,
        poses: Vec<Pose>,
        options: UploadOptions,
        file: &Path,
    ) -> Result<Self> {
        if file.symlink_metadata().is_ok() {
            let file = file.display();
            return refuse(format!("{file} exists, and an edited scene replaces nothing"));
        }
        check_writable(file)?;
        let count = scene.gaussians.len();
        Ok(Self {
            all: scene.gaussians.clone(),
            scene,
            shown: None,
            options,
            file: file.to_owned(),
            left: (0..count).collect(),
            selected: vec![false; count],
            removals: Vec::new(),
            is_hidden: false,
            poses,
            measured: None,
            version: 0,
        })
    }

    /// The scene to show instead of the whole one, and its version.
    pub(super) fn shown(&self) -> (Option<Arc<DeviceScene>>, u64) {
        (self.shown.clone(), self.version)
    }

    /// Does what a page asks for, and returns the new state.
    pub(super) fn answer(
        &mut self,
        stage: Stage<'_>,
        photographs: &mut Photographs,
        request: &EditRequest,
    ) -> Result<Vec<u8>> {
        let mut saved = None;
        match request {
            EditRequest::Look => {}
            EditRequest::Clear => self.selected.fill(false),
            EditRequest::Paint(stroke) => self.paint(stage, stroke)?,
            EditRequest::Remove => {
                let selected = std::mem::take(&mut self.selected);
                self.remove(stage, &selected)?;
            }
            EditRequest::Clean(strength) => self.clean(stage, photographs, *strength)?,
            EditRequest::Keep => self.is_hidden = false,
            EditRequest::Crop(Crop { low, high, outside }) => {
                let places = self.scene.gaussians.position.iter();
                let removed: Vec<_> =
                    places.map(|&place| is_in_box([*low, *high], place) != *outside).collect();
                self.remove(stage, &removed)?;
            }
            EditRequest::Meters(meters) if meters.is_normal() && *meters > 0.0 => {
                self.scene.config.placement.meters = Some(*meters);
            }
            EditRequest::Meters(_) => return refuse("expected meters above 0".to_owned()),
            EditRequest::Undo => self.undo(stage)?,
            EditRequest::Save => saved = Some(self.save()?),
        }
        let places = self.scene.gaussians.position.iter().zip(&self.selected);
        let places: Vec<_> = places.filter_map(|(place, is)| is.then_some(*place)).collect();
        let every = places.len().div_ceil(MAX_PLACES).max(1);
        let answer = Answer {
            left: self.left.len(),
            selected: places.len(),
            places: places.into_iter().step_by(every).collect(),
            removals: self.removals.len(),
            clean: self.hidden(),
            saved: saved.map(|path| path.display().to_string()),
        };
        serde_json::to_vec(&answer).or_else(|error| refuse(error.to_string()))
    }

    /// Selects what is under a brush: before the surface that the image shows, or not far behind it.
    fn paint(&mut self, stage: Stage<'_>, stroke: &Stroke) -> Result<()> {
        let camera = &stroke.camera;
        check(camera)?;
        if stroke.places.len() > MAX_STROKE {
            return refuse(format!("a stroke has {MAX_STROKE} places at most"));
        }
        if !(0.0..=f64::from(MAX_SIDE)).contains(&stroke.radius) {
            return refuse(format!("a brush has a radius of 0 to {MAX_SIDE} pixels"));
        }
        let depth = depth(stage, camera)?;
        let [width, height] = depth.size();
        let scale = f64::from(width) / f64::from(camera.width);
        let world_units = self.scene.config.placement.scale;
        let at = |x: f64, side: u32| ((x * scale) as usize).min(side as usize - 1);
        for (place, selected) in self.scene.gaussians.position.iter().zip(&mut self.selected) {
            let Some([x, y, far]) = camera.project(place.map(f64::from)) else { continue };
            if !*selected && stroke.is_over(DVec2::new(x, y)) {
                let surface = depth.values()[at(y, height) * width as usize + at(x, width)];
                *selected = far * world_units <= (1.0 + BEHIND) * f64::from(surface);
            }
        }
        Ok(())
    }

    /// Removes some of the Gaussians that are left.
    fn remove(&mut self, stage: Stage<'_>, is_removed: &[bool]) -> Result<()> {
        self.selected = vec![false; self.left.len()];
        let [removed, left] = parted(&self.left, is_removed);
        if left.is_empty() {
            return refuse("nothing would be left".to_owned());
        }
        if removed.is_empty() {
            return Ok(());
        }
        self.show(stage, left)?;
        self.removals.push(removed);
        // what was hidden is removed, too
        self.is_hidden = false;
        Ok(())
    }

    /// What is left, together with what was removed last.
    fn before(&self) -> Vec<usize> {
        let removed = self.removals.last().map(Vec::as_slice).unwrap_or_default();
        let mut left = [&self.left[..], removed].concat();
        left.sort_unstable();
        left
    }

    fn undo(&mut self, stage: Stage<'_>) -> Result<()> {
        if !self.removals.is_empty() {
            self.show(stage, self.before())?;
            self.removals.pop();
            self.is_hidden = false;
        }
        Ok(())
    }

    /// Hides floaters. Each call looks at one more view, until all were seen: the measure is the same as in `organza edit`.
    fn clean(
        &mut self,
        stage: Stage<'_>,
        photographs: &mut Photographs,
        strength: f64,
    ) -> Result<()> {
        if !(0.0..=1.0).contains(&strength) {
            return refuse("a strength is a number from 0 to 1".to_owned());
        }
        if self.poses.is_empty() {
            return refuse("there are no views: name the data set, too".to_owned());
        }
        let whole = if self.is_hidden { self.before() } else { self.left.clone() };
        let mut measured = match self.measured.take() {
            Some(measured) if measured.gaussians == whole => measured,
            _ => Measured {
                scene: Some(self.uploaded(stage, &whole)?),
                found: Contributions::new(whole.len()),
                gaussians: whole,
                seen: 0,
            },
        };
        if let Some(scene) = &measured.scene {
            let view = measured.seen % self.poses.len();
            let pose = (view, &self.poses[view]);
            photographs.add_contributions(stage.renderer, scene, pose, &mut measured.found)?;
            measured.seen += 1;
            if view + 1 == self.poses.len() {
                let next = measured.found.next_look();
                let next =
                    next.map(|next| next.into_iter().map(|i| measured.gaussians[i]).collect());
                measured.scene =
                    next.map(|next: Vec<_>| self.uploaded(stage, &next)).transpose()?;
            }
        }
        let Measured { gaussians, scene, found, .. } = self.measured.insert(measured);
        if scene.is_some() {
            return Ok(());
        }
        let [removed, left] = parted(gaussians, &found.floaters(strength));
        if left.is_empty() {
            return refuse("nothing would be left".to_owned());
        }
        if left != self.left {
            self.show(stage, left)?;
            if self.is_hidden {
                self.removals.pop();
            }
            self.is_hidden = !removed.is_empty();
            self.removals.extend(self.is_hidden.then_some(removed));
        }
        Ok(())
    }

    /// The scene of some Gaussians.
    fn uploaded(&self, stage: Stage<'_>, gaussians: &[usize]) -> Result<DeviceScene> {
        let gaussians = self.all.select(gaussians);
        stage.renderer.upload(&Scene { gaussians, ..self.scene.clone() })
    }

    /// What is hidden, and how far that is known.
    fn hidden(&self) -> Clean {
        let views = self.poses.len();
        let Some(measured) = &self.measured else { return Clean { views, ..Clean::default() } };
        let hidden = self.removals.last().filter(|_| self.is_hidden);
        let hidden = hidden.map(Vec::as_slice).unwrap_or_default();
        let places = hidden.iter().filter_map(|i| measured.gaussians.binary_search(i).ok());
        let weight = measured.found.weight(places);
        let views = views * measured.found.looks();
        Clean { seen: measured.seen, views, hidden: hidden.len(), weight }
    }

    /// Shows these Gaussians, and selects none.
    fn show(&mut self, stage: Stage<'_>, left: Vec<usize>) -> Result<()> {
        let gaussians = self.all.select(&left);
        let before = std::mem::replace(&mut self.scene.gaussians, gaussians);
        match stage.renderer.upload_with(&self.scene, self.options) {
            Ok(shown) => self.shown = Some(Arc::new(shown)),
            Err(error) => {
                self.scene.gaussians = before;
                return Err(error);
            }
        }
        self.selected = vec![false; left.len()];
        self.left = left;
        self.version += 1;
        Ok(())
    }

    /// Writes what is left to a file that does not exist yet.
    fn save(&self) -> Result<PathBuf> {
        let stem = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let extension = self.file.extension().unwrap_or("safetensors".as_ref()).to_string_lossy();
        let further = |n: u32| self.file.with_file_name(format!("{stem}-{n}.{extension}"));
        let names = std::iter::once(self.file.clone()).chain((2..1000).map(further));
        let mut free = names.filter(|path| path.symlink_metadata().is_err());
        let Some(path) = free.next() else {
            return refuse("there are 999 scenes already: remove some".to_owned());
        };
        self.scene.save(&path)?;
        Ok(path)
    }
}

/// The Gaussians that are removed, and the others.
fn parted(gaussians: &[usize], is_removed: &[bool]) -> [Vec<usize>; 2] {
    let both = || gaussians.iter().zip(is_removed);
    [true, false].map(|wanted| both().filter_map(|(&i, &is)| (is == wanted).then_some(i)).collect())
}

/// The depth of a view, in a small image.
fn depth(Stage { renderer, scene, .. }: Stage<'_>, camera: &Camera) -> Result<ChannelImage> {
    let camera = camera.within(DEPTH_SIDE);
    let size = [camera.width, camera.height];
    let batch = TileBatch::cover(0, size[0], size[1], TILE_SIDE)?;
    let cameras = std::slice::from_ref(&camera);
    let channels = [Channel::Depth];
    let tiles = renderer.render_channels(scene, cameras, &batch, &channels, &mut |_, _| {})?;
    let mut image = ChannelImage::new(Channel::Depth, size[0], size[1])?;
    image.paste(&batch, &tiles)?;
    Ok(image)
}
