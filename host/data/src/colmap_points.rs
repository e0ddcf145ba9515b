//! The points of a COLMAP model that belongs to a `transforms.json` without points.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::{DMat3, DVec3};

use super::{Listing, Point, colmap};
use organza_core::camera::Camera;
use organza_core::error::chain;

/// Least number of cameras that must agree.
const LEAST: usize = 3;
/// Largest distance of a camera from its place, relative to the distances between cameras.
const CLOSE: f64 = 0.02;

/// The model's points, in the world of a listing's cameras, and their file. None if there is no model; the error says why one that is
/// there is not used.
///
/// Poses often come from such a model, but nerfstudio and instant-ngp rotate, move and scale them. Photographs of the
/// same name determine the transformation. They need not be where the model expects them.
pub(super) fn points(
    folder: &Path,
    listing: &Listing,
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
        by_name.entry(file_name(name(camera))).or_default().push(camera);
    }
    let pair = |camera| Some((most_alike(by_name.get(file_name(name(camera)))?, camera)?, camera));
    let pairs: Vec<(&Camera, &Camera)> =
        listing.shots.iter().filter_map(|shot| pair(&shot.camera)).collect();
    if pairs.len() < LEAST {
        return Err(unused(format!(
            "only {} of its {} photographs have the names of photographs in the data set, and {LEAST} are needed \
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

fn name(camera: &Camera) -> &str {
    camera.file_path.as_deref().unwrap_or_default()
}

/// The last part of a path, without its extension, because tools convert photographs.
fn file_name(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// Of a model's cameras whose photographs have one name, the one in the same folders. `None` if that is more than one.
fn most_alike<'a>(cameras: &[&'a Camera], camera: &Camera) -> Option<&'a Camera> {
    let most = cameras.iter().map(|other| likeness(other, camera)).max()?;
    let mut best = cameras.iter().filter(|other| likeness(other, camera) == most);
    best.next().filter(|_| best.next().is_none()).copied()
}

/// Whether a photograph's path is the end of another's, and the number of folders that they share.
fn likeness(end: &Camera, whole: &Camera) -> (bool, usize) {
    let folders = |camera| name(camera).rsplit(['/', '\\']).skip(1);
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
        let turn = to_world(pairs[0].1) * to_world(pairs[0].0).transpose();
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

/// The rotation from camera axes (OpenCV) to world axes.
fn to_world(camera: &Camera) -> DMat3 {
    let [right, down, forward] = camera.world_to_camera_opencv().map(DVec3::from);
    DMat3::from_cols(right, down, forward)
}
