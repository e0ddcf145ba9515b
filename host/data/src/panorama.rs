//! Cuts photographs with too wide a view for one plane into pinhole views: panoramas of 360 degrees, and wide fisheyes.
//!
//! The views to train on are the faces of a cube around the camera. So each direction, also a pole, is seen once, and no
//! color counts twice. In the middle of a view, a pixel is as wide as the photograph's. Elsewhere it is narrower, so no
//! detail is lost. Only near a panorama's poles are columns closer together, but there they repeat one another.
//!
//! Faces do not overlap, so a program that searches for poses could not join them. It gets other views, which do.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};
use std::path::Path;

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};
use rayon::prelude::*;

use super::decode::Budget;
use super::develop::Shot;
use super::lens::{Lens, Projection, Reprojection, Undistortion};
use super::{DatasetOptions, Frame, decode};
use organza_core::camera::{Camera, MAX_IMAGE_SIDE, median};
use organza_core::error::Result;

/// A view of a panorama: its name, and its right, down and forward axes in the photograph's camera space.
pub type PanoramaView = (&'static str, [DVec3; 3]);

/// The views to train on: the faces of a cube.
pub const FACES: [PanoramaView; 6] = [
    ("front", heading(1.0, 0.0)),
    ("right", heading(0.0, 1.0)),
    ("back", heading(-1.0, 0.0)),
    ("left", heading(0.0, -1.0)),
    ("up", [DVec3::X, DVec3::Z, DVec3::NEG_Y]),
    ("down", [DVec3::X, DVec3::NEG_Z, DVec3::Y]),
];
/// The views to find poses with: headings in degrees. Each overlaps the next one by half.
pub const HEADINGS: [PanoramaView; 8] = [
    ("000", heading(1.0, 0.0)),
    ("045", heading(FRAC_1_SQRT_2, FRAC_1_SQRT_2)),
    ("090", heading(0.0, 1.0)),
    ("135", heading(-FRAC_1_SQRT_2, FRAC_1_SQRT_2)),
    ("180", heading(-1.0, 0.0)),
    ("225", heading(-FRAC_1_SQRT_2, -FRAC_1_SQRT_2)),
    ("270", heading(0.0, -1.0)),
    ("315", heading(FRAC_1_SQRT_2, -FRAC_1_SQRT_2)),
];

/// The axes of a view to the horizon, by the cosine and the sine of its heading.
const fn heading(cos: f64, sin: f64) -> [DVec3; 3] {
    [DVec3::new(cos, 0.0, -sin), DVec3::Y, DVec3::new(sin, 0.0, cos)]
}

/// Tangent of 60 degrees. A plane that shows more than this stretches a fisheye's edge by 4.
const WIDE: f64 = 1.732_050_807_568_877_2;
/// Places on each side of a view where the photograph is tested.
const GRID: u32 = 32;
/// Ending of a view's name `PANORAMA.VIEW.png`.
const ENDING: &str = ".png";

/// Whether an image of `[width, height]` pixels has the shape of a panorama of 360 degrees.
pub fn is_panorama([width, height]: [u32; 2]) -> bool {
    (f64::from(width) - 2.0 * f64::from(height)).abs() <= 0.01 * f64::from(width)
}

/// The panorama's name in the name of one of its `views`; `None` for other images.
///
/// ```
/// use organza_data::panorama::{FACES, HEADINGS, panorama_of};
///
/// assert_eq!(panorama_of("images/7.front.png", &FACES), Some("images/7"));
/// assert_eq!(panorama_of("images/7.front.png", &HEADINGS), None);
/// assert_eq!(panorama_of("images/7.png", &FACES), None);
/// ```
pub fn panorama_of<'n>(name: &'n str, views: &[PanoramaView]) -> Option<&'n str> {
    Some(view_of(name, views)?.0)
}

/// The panorama that a view is of, and the view's axes.
fn view_of<'n>(name: &'n str, views: &[PanoramaView]) -> Option<(&'n str, DMat3)> {
    let (panorama, named) = name.strip_suffix(ENDING)?.rsplit_once('.')?;
    let (_, [right, down, forward]) = views.iter().find(|(view, _)| *view == named)?;
    Some((panorama, DMat3::from_cols(*right, *down, *forward)))
}

/// The cameras of each panorama's `views`, all at one place, sorted by name. `found` has a camera for each view of
/// [`HEADINGS`]. A panorama has the median pose of its found views, so some may be wrong or missing.
pub fn join(found: &[Camera], views: &[PanoramaView]) -> Vec<Camera> {
    let mut panoramas: BTreeMap<_, Vec<(DVec4, DVec3)>> = BTreeMap::new();
    for camera in found {
        let view = camera.file_path.as_deref().and_then(|name| view_of(name, &HEADINGS));
        let Some((panorama, axes)) = view else { continue };
        let turn = camera.to_world() * axes.transpose();
        let turn = DVec4::from(DQuat::from_mat3(&turn));
        let poses = panoramas.entry(panorama).or_default();
        // A quaternion and its negative are the same turn.
        let sign = poses.first().map_or(1.0, |(first, _)| turn.dot(*first).signum());
        poses.push((sign * turn, DVec3::from(camera.eye())));
    }
    let joined = panoramas.iter().flat_map(|(panorama, poses)| {
        let turn = [0, 1, 2, 3].map(|at| median(poses.iter().map(|(turn, _)| turn[at])));
        let turn = DMat3::from_quat(DQuat::from_array(turn).normalize());
        let eye = [0, 1, 2].map(|axis| median(poses.iter().map(|(_, eye)| eye[axis])));
        views.iter().map(move |&(view, [right, down, forward])| {
            let to_world = turn * DMat3::from_cols(right, -down, -forward);
            let row = |axis: usize| to_world.row(axis).extend(eye[axis]).to_array();
            let camera_to_world = [row(0), row(1), row(2), DVec4::W.to_array()];
            let file_path = Some(format!("{panorama}.{view}{ENDING}"));
            Camera { camera_to_world, file_path, ..found[0].clone() }
        })
    });
    let mut joined: Vec<_> = joined.collect();
    joined.sort_by(|a, b| a.file_path.cmp(&b.file_path));
    joined
}

/// The first part of the names of a panorama's views, given the name of its file.
pub fn stem(name: &str) -> &str {
    name.strip_suffix(ENDING).unwrap_or(name)
}

/// Views of a panorama's file, each with at most `side` pixels a side.
///
/// # Errors
/// The same errors as [`Dataset::load`](super::Dataset::load) for a photograph.
pub fn cut(path: &Path, side: u32, views: &[PanoramaView]) -> Result<Vec<Frame>> {
    let size = decode::size(path)?;
    let pose = DMat4::IDENTITY.to_cols_array_2d();
    let full = f64::from(size[0]) / PI;
    let side = full.round().min(f64::from(side));
    let factor = (full / side).round().max(1.0);
    let shot = Shot {
        name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        path: path.to_owned(),
        mask: None,
        camera: Camera::pinhole(pose, [1.0; 2], [0.0; 2], size),
        pose,
        lens: Lens { projection: Projection::Panorama, ..Lens::default() },
        factor: factor as u32,
        held_out: false,
        trained: None,
    };
    let options = DatasetOptions::default();
    let budget = Budget::beside(0);
    let frame = |view: Shot| view.develop(&options, &budget).map(|(frame, _)| frame);
    seen(&shot, side * factor, views).into_par_iter().map(frame).collect()
}

/// The views of a photograph. A photograph that fits on one plane is its only view.
pub(super) fn views_of(shot: Shot) -> Vec<Shot> {
    let Camera { fl_x, fl_y, width, .. } = shot.camera;
    if shot.lens.projection == Projection::Panorama {
        seen(&shot, f64::from(width) / PI, &FACES)
    } else if is_wide(&shot) {
        seen(&shot, 2.0 * fl_x.max(fl_y), &FACES)
    } else {
        vec![shot]
    }
}

/// Whether a fisheye shows more than 60 degrees from its axis.
fn is_wide(shot: &Shot) -> bool {
    let undistortion = Undistortion::new(&shot.camera, &shot.lens);
    let Camera { fl_x, fl_y, cx, cy, .. } = shot.camera;
    let sides = [[WIDE, 0.0], [-WIDE, 0.0], [0.0, WIDE], [0.0, -WIDE]];
    let is_seen = |[x, y]: [f64; 2]| undistortion.source([cx + fl_x * x, cy + fl_y * y]).is_some();
    shot.lens.projection == Projection::Fisheye && sides.into_iter().any(is_seen)
}

/// The `views`, of `side` x `side` pixels, that show some of the photograph.
fn seen(shot: &Shot, side: f64, views: &[PanoramaView]) -> Vec<Shot> {
    let mut whole = Reprojection::whole(&shot.camera);
    if shot.lens.projection == Projection::Panorama {
        let [width, height] = whole.size.map(f64::from);
        whole.focal = [width / TAU, height / PI];
        whole.center = [width / 2.0, height / 2.0];
    }
    let side = side.round().clamp(1.0, f64::from(MAX_IMAGE_SIDE));
    let stem = stem(&shot.name);
    let view = |&(view, axes): &PanoramaView| {
        let [right, down, forward] = axes;
        let turned = |[x, y, z, place]: [f64; 4]| {
            // a file's y and z axes point up and back
            let row = DVec3::new(x, -y, -z);
            [row.dot(right), -row.dot(down), -row.dot(forward), place]
        };
        let [x, y, z, last] = shot.pose;
        let pose = [turned(x), turned(y), turned(z), last];
        let mut camera = Camera::pinhole(pose, [side / 2.0; 2], [side / 2.0; 2], [side as u32; 2]);
        let name = format!("{stem}.{view}{ENDING}");
        camera.file_path = Some(name.clone());
        let lens = Lens { cut: Some(Reprojection { axes, ..whole }), ..shot.lens };
        let undistortion = Undistortion::new(&camera, &lens);
        let place = |step: u32| (f64::from(step) + 0.5) * side / f64::from(GRID);
        let mut places = (0..GRID * GRID).map(|at| [place(at % GRID), place(at / GRID)]);
        let is_seen = places.any(|place| undistortion.source(place).is_some());
        is_seen.then(|| Shot { name, camera, pose, lens, ..shot.clone() })
    };
    views.iter().filter_map(view).collect()
}
