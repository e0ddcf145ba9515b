//! COLMAP's sparse models, binary and text.

mod binary;
mod model;
mod text;

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::lens::Lens;
use super::{DatasetKind, Point, Poses, find, ply};
use model::{Image, Intrinsics};
use organza_core::error::invalid;
use organza_core::input::{read_file, read_text};
use organza_core::{Camera, Result};

/// Folders in a data set that may hold a model, or several in numbered folders, by priority.
pub(super) const FOLDERS: [&str; 6] =
    ["sparse", "colmap/sparse", "colmap_sparse", "colmap_text", "colmap", ""];
/// Name of the points as 3D Gaussian Splatting writes them beside a model.
const POINTS_PLY: &str = "points3D.ply";

type Cameras = HashMap<u32, Intrinsics>;
/// Cameras and their lenses.
type Lensed = Vec<(Camera, Lens)>;
/// Points with their ids and their support.
type Points = Vec<(u64, Point, Support)>;

/// The evidence for a point.
#[derive(Clone, Copy)]
struct Support {
    /// Mean distance in pixels between where images see the point and where they should; negative if unknown.
    error: f64,
    /// Number of images that see it.
    images: u64,
}

/// Adds a camera. A repeated id is an error, because one of the cameras would be lost.
fn add(cameras: &mut Cameras, id: u32, camera: Intrinsics, path: &Path) -> Result<()> {
    match cameras.insert(id, camera) {
        Some(_) => invalid(path, format!("camera {id} is there twice; is the file damaged?")),
        None => Ok(()),
    }
}

fn bytes(path: &Path) -> Result<Vec<u8>> {
    read_file(path, u64::MAX, "a COLMAP model")
}

fn text(path: &Path) -> Result<String> {
    read_text(path, u64::MAX, "a COLMAP model")
}

/// A model's folder, and the form of its files.
#[derive(Clone)]
pub(super) struct Model {
    pub folder: PathBuf,
    is_binary: bool,
    /// Other models beside it, and their numbers of photographs.
    others: Vec<(PathBuf, usize)>,
}

impl Model {
    /// The model in a folder. If both forms exist, the binary one is used, as in COLMAP.
    fn within(folder: PathBuf) -> Option<Self> {
        let is_there = |name: &str| folder.join(name).is_file();
        let is_binary = is_there("cameras.bin");
        let exists = is_binary || is_there("cameras.txt");
        exists.then_some(Self { folder, is_binary, others: Vec::new() })
    }

    fn file(&self, stem: &str) -> PathBuf {
        self.folder.join(format!("{stem}.{}", if self.is_binary { "bin" } else { "txt" }))
    }

    /// The number of photographs; 0 if they cannot be read.
    fn photographs(&self) -> usize {
        self.images().map_or(0, |images| images.len())
    }

    fn images(&self) -> Result<Vec<Image>> {
        let path = &self.file("images");
        match self.is_binary {
            true => binary::images(&bytes(path)?, path),
            false => text::images(&text(path)?, path),
        }
    }

    /// The points of `points3D`. A model without them still has cameras, and training can start from other points.
    fn supported_points(&self) -> Result<Points> {
        let path = &self.file("points3D");
        if !path.exists() {
            return Ok(Points::new());
        }
        match self.is_binary {
            true => binary::points(&bytes(path)?, path),
            false => text::points(&text(path)?, path),
        }
    }

    /// The points of `points3D`, or else of a PLY file beside it.
    fn points(&self) -> Result<(Vec<Point>, PathBuf)> {
        let path = self.file("points3D");
        let mut points = self.supported_points()?;
        let beside = self.folder.join(POINTS_PLY);
        if points.is_empty() && beside.exists() {
            return Ok((ply::read(&beside)?, beside));
        }
        points.sort_by_key(|(id, ..)| *id);
        Ok((points.into_iter().map(|(_, point, _)| point).collect(), path))
    }

    /// A note if there are several models.
    pub fn note(&self) -> Option<String> {
        let others =
            self.others.iter().map(|(folder, count)| format!("{} {count}", folder.display()));
        let others = others.collect::<Vec<_>>().join(", ");
        let used = self.folder.display();
        (!others.is_empty()).then(|| {
            format!(
                "there are several models, and the one with the most photographs is used: {used} has {}, {others}",
                self.photographs()
            )
        })
    }
}

/// The model of a data set.
pub(super) fn find(folder: &Path) -> Option<Model> {
    FOLDERS.iter().find_map(|name| {
        let root = folder.join(name);
        // a number in the data set's own folder may be anything
        let mut folders = if name.is_empty() { Vec::new() } else { numbered(&root) };
        folders.push(root);
        largest(folders)
    })
}

/// The largest model of some folders. COLMAP numbers the parts of a scene that it could not join.
fn largest(folders: Vec<PathBuf>) -> Option<Model> {
    let mut models: Vec<_> = folders.into_iter().filter_map(Model::within).collect();
    if models.len() < 2 {
        return models.pop();
    }
    let mut sized: Vec<_> = models.into_iter().map(|model| (model.photographs(), model)).collect();
    // The sort is stable: among equal sizes, the first number is used.
    sized.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let mut sized = sized.into_iter();
    let (_, largest) = sized.next()?;
    Some(Model { others: sized.map(|(count, model)| (model.folder, count)).collect(), ..largest })
}

/// The folders in a folder that have numbers as names, in their order.
fn numbered(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let number = |path: &Path| path.file_name()?.to_str()?.parse::<u32>().ok();
    let mut found: Vec<_> =
        entries.filter_map(|entry| Some((number(&entry.path())?, entry.path()))).collect();
    found.sort();
    found.into_iter().map(|(_, path)| path).collect()
}

/// Reads a model, and finds its photographs.
pub(super) fn list(poses: &mut Poses, model: &Model) -> Result<()> {
    let folder = &*poses.dataset.path.clone();
    let downscale = poses.options.downscale;
    poses.dataset.kind = DatasetKind::Colmap;
    poses.dataset.notes.extend(model.note());
    let (cameras, points, file) = read(model)?;
    for (position, (camera, lens)) in cameras.into_iter().enumerate() {
        let name = camera.file_path.clone().unwrap_or_default();
        let photograph = |name: &str| find::photograph(folder, name, None, downscale);
        let in_images = photograph(&format!("images/{name}"));
        match in_images.or_else(|expected| photograph(&name).map_err(|_| expected)) {
            Ok(found) => {
                poses.check_place(&found.path)?;
                poses.add(found, camera, lens, poses.options.holds_out(position))?;
            }
            Err(expected) => poses.dataset.missing.push(expected),
        }
    }
    poses.dataset.points = points;
    poses.dataset.points_file = Some(file);
    if poses.dataset.points.is_empty() {
        let reason = format!("that is {POINTS_PLY} in {}", model.folder.display());
        poses.dataset.notes.extend(find::unused_clouds(folder, &reason));
    }
    Ok(())
}

/// A model's cameras by the names of their images, and its points by id, because COLMAP writes both in no particular
/// order. A camera's `file_path` is the name.
pub(super) fn read(model: &Model) -> Result<(Lensed, Vec<Point>, PathBuf)> {
    let path = &model.file("cameras");
    let cameras = match model.is_binary {
        true => binary::cameras(&bytes(path)?, path)?,
        false => text::cameras(&text(path)?, path)?,
    };
    let origin = &model.file("images");
    let mut images = model.images()?;
    if images.is_empty() {
        return invalid(origin, "the model has no images; did COLMAP finish?");
    }
    images.sort_by(|a, b| a.name.cmp(&b.name));
    if let Some(pair) = images.windows(2).find(|pair| pair[0].name == pair[1].name) {
        let reason = format!("image `{}` is there twice; is the file damaged?", pair[0].name);
        return invalid(origin, reason);
    }
    let camera = |image: Image| {
        let name = &image.name;
        let Some(intrinsics) = cameras.get(&image.camera) else {
            let id = image.camera;
            let file = path.display();
            let reason = format!("image `{name}` has camera {id}, which is not in {file}");
            return invalid(origin, reason);
        };
        let pose = model::camera(&image, intrinsics);
        match pose.and_then(|camera| camera.check().map(|()| camera)) {
            Ok(camera) => Ok((camera, intrinsics.lens)),
            Err(reason) => invalid(origin, format!("image `{name}`: {reason}")),
        }
    };
    let cameras = images.into_iter().map(camera).collect::<Result<Vec<_>>>()?;
    let (points, file) = model.points()?;
    if let Some((index, point)) = points.iter().enumerate().find(|(_, p)| !is_finite(p)) {
        let position = point.position;
        let reason = format!("point {index} is at {position:?}, expected finite coordinates");
        return invalid(&file, reason);
    }
    Ok((cameras, points, file))
}

fn is_finite(point: &Point) -> bool {
    point.position.iter().all(|&value| (value as f32).is_finite())
}

/// Reads bytes as each file of a model, for `data::fuzz`.
pub(super) fn fuzz(bytes: &[u8], path: &Path) {
    let text = String::from_utf8_lossy(bytes);
    let _ = binary::cameras(bytes, path);
    let _ = binary::points(bytes, path);
    let _ = text::cameras(&text, path);
    let _ = text::points(&text, path);
    let images = [binary::images(bytes, path), text::images(&text, path)];
    let lenses = model::Lenses::from_name("PINHOLE");
    let camera = lenses.and_then(|lenses| lenses.intrinsics([64, 48], &[90.0, 90.0, 32.0, 24.0]));
    for image in images.into_iter().flatten().flatten() {
        let _ = camera.as_ref().map(|camera| model::camera(&image, camera));
    }
}

/// The lens for a model's name and parameters.
#[cfg(test)]
pub(super) fn lens_of(name: &str, values: &[f64]) -> Result<super::lens::Lens, String> {
    model::Lenses::from_name(name)?.intrinsics([64, 48], values).map(|camera| camera.lens)
}

/// A sparse model of COLMAP, as it stands.
#[derive(Clone, Debug)]
pub struct SparseModel {
    /// The model's folder.
    pub folder: PathBuf,
    /// The images that have a pose, sorted by name. A camera's `file_path` is the name.
    pub cameras: Vec<Camera>,
    /// Number of points.
    pub points: usize,
    /// Mean number of images that see a point; 0 without points.
    pub mean_track: f64,
    /// Mean distance, in pixels, between where images see a point and where they should; 0 if unknown.
    pub mean_error: f64,
}

impl SparseModel {
    /// The model with the most images in the numbered folders that COLMAP's mapper has written; `None` if there is none.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::error::Error::Invalid) if a file of the model is damaged.
    pub fn largest(folder: &Path) -> Result<Option<Self>> {
        let Some(model) = largest(numbered(folder)) else { return Ok(None) };
        let (cameras, ..) = read(&model)?;
        let points = model.supported_points()?;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let tracks: Vec<_> = points.iter().map(|(.., support)| support.images as f64).collect();
        let errors = points.iter().map(|(.., support)| support.error);
        let errors: Vec<_> = errors.filter(|error| *error >= 0.0).collect();
        Ok(Some(Self {
            folder: model.folder,
            cameras: cameras.into_iter().map(|(camera, _)| camera).collect(),
            points: points.len(),
            mean_track: mean(&tracks),
            mean_error: mean(&errors),
        }))
    }
}
