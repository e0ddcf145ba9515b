//! The points of a COLMAP model that belongs to a `transforms.json` without points.

use std::collections::HashMap;
use std::path::Path;

use glam::{DMat3, DVec3};

use super::access::Access;
use super::{DatasetOptions, Listing, Point, colmap};
use organza_core::camera::Camera;
use organza_core::error::Result;

/// Least number of cameras that must agree.
const LEAST: usize = 3;
/// Largest distance of a camera from its place, relative to the distances between cameras.
const CLOSE: f64 = 0.02;

/// The model's points, in the world of a listing's cameras. `None` if there is no model, or if its cameras are
/// elsewhere.
///
/// Poses often come from such a model, but nerfstudio and instant-ngp rotate, move and scale them. Photographs of the
/// same name determine the transformation.
pub(super) fn points(
    folder: &Path,
    listing: &Listing,
    options: &DatasetOptions,
    access: &mut Access,
) -> Result<Vec<Point>> {
    let Some(model) = colmap::find(folder) else { return Ok(Vec::new()) };
    let Ok(found) = colmap::list(folder, &model, options, access) else { return Ok(Vec::new()) };
    let by_name: HashMap<&str, &Camera> =
        found.shots.iter().map(|shot| (file_name(&shot.name), &shot.camera)).collect();
    let pairs: Vec<(&Camera, &Camera)> = listing
        .shots
        .iter()
        .filter_map(|shot| Some((*by_name.get(file_name(&shot.name))?, &shot.camera)))
        .collect();
    let Some(similarity) = Similarity::between(&pairs) else { return Ok(Vec::new()) };
    let moved =
        |point: Point| Point { position: similarity.apply(point.position).to_array(), ..point };
    Ok(found.points.into_iter().map(moved).collect())
}

/// The last part of a path, without its extension, because tools convert photographs.
fn file_name(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
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
        if pairs.len() < LEAST {
            return None;
        }
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
