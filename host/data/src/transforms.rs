//! Reads nerfstudio's `transforms.json`, and Blender's pair of such files.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::{DMat3, DVec3};
use serde_json::Value;

use super::find::{self, PhotographFile};
use super::lens::{Lens, Projection};
use super::panorama::is_panorama;
use super::{DatasetKind, Point, Poses, colmap, decode, ply};
use organza_core::camera::parse::{PANORAMA, PERSPECTIVE_MODELS, PINHOLE_MODELS, Source, frames};
use organza_core::camera::{Camera, camera_error};
use organza_core::error::{Result, chain, invalid};
use organza_core::input::{kind, read_json};

/// Name of the file that marks a nerfstudio data set.
pub(super) const NERFSTUDIO: &str = "transforms.json";
/// Name of the file that marks a Blender data set.
pub(super) const BLENDER_TRAIN: &str = "transforms_train.json";
const BLENDER_TEST: &str = "transforms_test.json";
/// Camera model of nerfstudio's fisheyes, for which instant-ngp writes `is_fisheye`.
const FISHEYE: &str = "OPENCV_FISHEYE";

/// Functions that find and measure a data set's photographs.
pub(super) struct Photographs {
    /// Finds a photograph: see [`find::photograph`].
    pub find: fn(&Path, &str, Option<&str>, u32) -> Result<PhotographFile, PathBuf>,
    /// Width and height of a photograph in pixels.
    pub size: fn(&Path) -> Result<[u32; 2]>,
}

const ON_DISK: Photographs = Photographs { find: find::photograph, size: decode::size };

/// Reads nerfstudio's file at `path`.
pub(super) fn nerfstudio(poses: &mut Poses, path: &Path) -> Result<()> {
    poses.dataset.kind = DatasetKind::Nerfstudio;
    let file = read_json(path)?;
    let options = poses.options.clone();
    add_frames(poses, &file, path, |position| options.holds_out(position), &ON_DISK)?;
    add_points(poses, &file, path)
}

/// Adds the points to start from, out of the file's point cloud, or else out of a COLMAP model.
fn add_points(poses: &mut Poses, file: &Value, path: &Path) -> Result<()> {
    match file.get("ply_file_path") {
        None | Some(Value::Null) => {}
        Some(Value::String(points)) => {
            let points = find::named(folder(path), points);
            if !points.exists() {
                let reason = format!(
                    "there is no such file as {}, which `ply_file_path` names; put it there, or remove the key",
                    points.display()
                );
                return invalid(path, reason);
            }
            poses.check_place(&points)?;
            poses.dataset.points = ply::read(&points)?;
            poses.dataset.points_file = Some(points);
            return Ok(());
        }
        Some(other) => {
            return invalid(path, format!("`ply_file_path` is {}, expected a path", kind(other)));
        }
    }
    match points(folder(path), poses) {
        Ok(None) => {}
        Ok(Some((points, file))) => {
            poses.dataset.points = points;
            poses.dataset.points_file = Some(file);
        }
        Err(reason) => poses.dataset.notes.push(reason),
    }
    if poses.dataset.points.is_empty() {
        let reason = format!("{} does not name it as `ply_file_path`", path.display());
        poses.dataset.notes.extend(find::unused_clouds(folder(path), &reason));
    }
    Ok(())
}

/// Reads Blender's files; `train` is the first of them.
pub(super) fn blender(poses: &mut Poses, train: &Path) -> Result<()> {
    poses.dataset.kind = DatasetKind::Blender;
    let test = train.with_file_name(BLENDER_TEST);
    let has_test = test.exists();
    let options = poses.options.clone();
    let held_out = |position| !has_test && options.holds_out(position);
    let file = read_json(train)?;
    add_frames(poses, &file, train, held_out, &ON_DISK)?;
    add_points(poses, &file, train)?;
    match has_test {
        true => add_frames(poses, &read_json(&test)?, &test, |_| true, &ON_DISK),
        false => Ok(()),
    }
}

/// Adds the frames of a file at `path`. `held_out` decides by the position in the file.
pub(super) fn add_frames(
    poses: &mut Poses,
    file: &Value,
    path: &Path,
    held_out: impl Fn(usize) -> bool,
    photographs: &Photographs,
) -> Result<()> {
    for (index, frame) in frames(file, path)?.iter().enumerate() {
        let name = name(frame).map_err(|reason| camera_error(path, index, reason))?;
        if frame["is_bad"] == true {
            let found = (photographs.find)(folder(path), name, None, 1);
            poses.bad.push(found.map_or_else(|expected| expected, |found| found.path));
            continue;
        }
        let mask = mask(frame).map_err(|reason| camera_error(path, index, reason))?;
        let mut source = Source { file, frame, size: None };
        let has_size = source.get("w").is_some() && source.get("h").is_some();
        // A smaller photograph has a camera only if the file gives the size of the whole one.
        let downscale = if has_size { poses.options.downscale } else { 1 };
        let found = match (photographs.find)(folder(path), name, mask, downscale) {
            Ok(found) => found,
            Err(expected) => {
                poses.dataset.missing.push(expected);
                continue;
            }
        };
        poses.check_place(&found.path)?;
        // Blender's files give no image size, so it is read from the photographs.
        if !has_size {
            source.size = Some((photographs.size)(&found.path)?);
        }
        let camera = source.valid_camera(index, path)?;
        let lens = lens(&source).map_err(|reason| camera_error(path, index, reason))?;
        let Camera { width, height, .. } = camera;
        if lens.projection == Projection::Panorama && !is_panorama([width, height]) {
            let reason = format!(
                "has {width} x {height} pixels, but a panorama of 360 degrees is twice as wide as high"
            );
            return Err(camera_error(path, index, reason));
        }
        let camera = Camera { file_path: Some(name.to_owned()), ..camera };
        poses.add(found, camera, lens, held_out(index))?;
    }
    Ok(())
}

/// The path of a frame's mask.
fn mask(frame: &Value) -> Result<Option<&str>, String> {
    match frame.get("mask_path") {
        None | Some(Value::Null) => Ok(None),
        Some(Value::String(mask)) if !mask.is_empty() => Ok(Some(mask)),
        Some(other) => Err(format!("`mask_path` is {}, expected a path", kind(other))),
    }
}

fn name(frame: &Value) -> Result<&str, String> {
    match frame.get("file_path") {
        Some(Value::String(name)) if !name.is_empty() => Ok(name),
        Some(Value::String(_)) => Err("`file_path` is empty, expected a photograph's path".into()),
        Some(other) => Err(format!("`file_path` is {}, expected a path", kind(other))),
        None => Err("`file_path` is missing; a frame names its photograph with it".into()),
    }
}

/// The lens of a frame.
fn lens(source: &Source<'_>) -> Result<Lens, String> {
    let is_fisheye = source.get("is_fisheye").and_then(Value::as_bool) == Some(true);
    let fisheye = match source.get("camera_model") {
        None => is_fisheye,
        Some(Value::String(model)) if PINHOLE_MODELS.contains(&model.as_str()) => {
            return Ok(Lens::default());
        }
        Some(Value::String(model)) if PERSPECTIVE_MODELS.contains(&model.as_str()) => is_fisheye,
        Some(Value::String(model)) if model == FISHEYE => true,
        Some(Value::String(model)) if model == PANORAMA => {
            return Ok(Lens { projection: Projection::Panorama, ..Lens::default() });
        }
        Some(Value::String(model)) => {
            return Err(format!(
                "the camera model {model} is not supported; the models that are read are {}, \
                 {FISHEYE} and {PANORAMA}: undistort the photographs first, and describe them as PINHOLE",
                PERSPECTIVE_MODELS.join(", ")
            ));
        }
        Some(other) => return Err(format!("`camera_model` is {}, expected a name", kind(other))),
    };
    let value = |key| Ok::<f64, String>(source.number(key)?.unwrap_or_default());
    let k3 = value("k3")?;
    let k4 = value("k4")?;
    let k5 = value("k5")?;
    let k6 = value("k6")?;
    // In OpenCV's model, k4 is a part of a denominator. In nerfstudio's other models, it is one more radial term.
    let is_full = source.get("camera_model").and_then(Value::as_str) == Some("FULL_OPENCV");
    let (k4, denominator) = if is_full { (0.0, [k4, k5, k6]) } else { (k4, [0.0; 3]) };
    let tangential = if fisheye { [0.0; 2] } else { [value("p1")?, value("p2")?] };
    let radial = [value("k1")?, value("k2")?, k3, k4];
    let projection = if fisheye { Projection::Fisheye } else { Projection::Plane };
    Ok(Lens { projection, radial, denominator, tangential, ..Lens::default() })
}

fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// The lens of a file, for frames without their own.
#[cfg(test)]
pub(super) fn lens_of(file: &Value) -> Result<Lens, String> {
    lens(&Source { file, frame: &Value::Null, size: None })
}

/// Least number of cameras that must agree.
const MIN_PAIRS: usize = 3;
/// Largest distance of a camera from its place, relative to the distances between cameras.
const CLOSE: f64 = 0.02;

/// The points of a COLMAP model, in the world of a data set's cameras, and their file. `None` without a model. The error says why
/// the model is not used.
///
/// Poses often come from such a model, but nerfstudio and instant-ngp rotate, move and scale them. Photographs of the
/// same name determine the transformation. They need not be where the model expects them.
pub(super) fn points(
    folder: &Path,
    poses: &Poses,
) -> Result<Option<(Vec<Point>, PathBuf)>, String> {
    let Some(model) = colmap::find(folder) else { return Ok(None) };
    let unused = |reason: String| {
        let folder = model.folder.display();
        format!("the points of {folder} are not used, because {reason}")
    };
    let (cameras, points, file) = colmap::read(&model)
        .map_err(|error| unused(format!("the model cannot be read: {}", chain(&error))))?;
    let mut by_name: HashMap<&str, Vec<&Camera>> = HashMap::new();
    for (camera, _) in &cameras {
        by_name.entry(file_name(camera_name(camera))).or_default().push(camera);
    }
    let pair =
        |camera| Some((most_alike(by_name.get(file_name(camera_name(camera)))?, camera)?, camera));
    let pairs: Vec<(&Camera, &Camera)> =
        poses.shots.iter().filter_map(|shot| pair(&shot.camera)).collect();
    if pairs.len() < MIN_PAIRS {
        return Err(unused(format!(
            "only {} of its {} photographs have the names of photographs in the data set, and {MIN_PAIRS} are needed \
             to compare their cameras",
            pairs.len(),
            cameras.len()
        )));
    }
    let Some(similarity) = Similarity::between(&pairs) else {
        return Err(unused(format!(
            "its cameras stand elsewhere: moved, turned and scaled alike, they are more than {}% of their distances \
             away from the cameras of the data set",
            100.0 * CLOSE
        )));
    };
    let moved =
        |point: Point| Point { position: similarity.apply(point.position).to_array(), ..point };
    Ok(Some((points.into_iter().map(moved).collect(), file)))
}

fn camera_name(camera: &Camera) -> &str {
    camera.file_path.as_deref().unwrap_or_default()
}

/// The last part of a path, without its extension, because tools convert photographs.
fn file_name(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// The model's camera with the same photograph: of all `cameras` whose photographs have its name, the one in the same
/// folders. `None` if several are.
fn most_alike<'a>(cameras: &[&'a Camera], camera: &Camera) -> Option<&'a Camera> {
    let largest = cameras.iter().map(|other| likeness(other, camera)).max()?;
    let mut best = cameras.iter().filter(|other| likeness(other, camera) == largest);
    best.next().filter(|_| best.next().is_none()).copied()
}

/// Whether a photograph's path is the end of another's, and the number of folders that they share.
fn likeness(end: &Camera, whole: &Camera) -> (bool, usize) {
    let folders = |camera| camera_name(camera).rsplit(['/', '\\']).skip(1);
    let shared = folders(end).zip(folders(whole)).take_while(|(a, b)| a == b).count();
    (shared == folders(end).count(), shared)
}

/// A rotation, a scale and a translation.
struct Similarity {
    turn: DMat3,
    scale: f64,
    from: DVec3,
    to: DVec3,
}

impl Similarity {
    /// The similarity that maps the first camera of each pair to the second; `None` if there is none.
    fn between(pairs: &[(&Camera, &Camera)]) -> Option<Self> {
        let count = pairs.len() as f64;
        let from = pairs.iter().map(|pair| eye(pair.0)).sum::<DVec3>() / count;
        let to = pairs.iter().map(|pair| eye(pair.1)).sum::<DVec3>() / count;
        let spread_from = pairs.iter().map(|pair| eye(pair.0).distance(from)).sum::<f64>() / count;
        let spread_to = pairs.iter().map(|pair| eye(pair.1).distance(to)).sum::<f64>() / count;
        let scale = spread_to / spread_from;
        // every pair of poses has the same rotation
        let turn = pairs[0].1.to_world() * pairs[0].0.to_world().transpose();
        let similarity = Self { turn, scale, from, to };
        let is_there = |&(a, b): &(&Camera, &Camera)| {
            similarity.apply(a.eye()).distance(eye(b)) <= CLOSE * spread_to
        };
        (scale.is_finite() && scale > 0.0 && pairs.iter().all(is_there)).then_some(similarity)
    }

    fn apply(&self, place: [f64; 3]) -> DVec3 {
        self.to + self.turn * (DVec3::from(place) - self.from) * self.scale
    }
}

fn eye(camera: &Camera) -> DVec3 {
    DVec3::from(camera.eye())
}
