//! Cuts photographs that no plane holds into pinhole views: panoramas of 360 degrees, and those of wide fisheyes.
//!
//! The views are the faces of a cube around the camera. So the poles are seen, and each direction is seen once: no color
//! counts twice. In the middle of a view, a pixel is as wide as the photograph's. Elsewhere it is narrower, so it misses
//! nothing: only near a panorama's poles are columns closer together, and there they repeat one another.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};
use rayon::prelude::*;

use super::decode::Budget;
use super::develop::Shot;
use super::lens::{Cut, Lens, Undistortion};
use super::{DatasetOptions, Frame, decode};
use organza_core::camera::{Camera, MAX_IMAGE_SIDE, median};
use organza_core::error::Result;

/// The views of a panorama, and their right, down and forward axes in those of the photograph's camera.
const FACES: [(&str, [DVec3; 3]); 6] = [
    ("front", [DVec3::X, DVec3::Y, DVec3::Z]),
    ("right", [DVec3::NEG_Z, DVec3::Y, DVec3::X]),
    ("back", [DVec3::NEG_X, DVec3::Y, DVec3::NEG_Z]),
    ("left", [DVec3::Z, DVec3::Y, DVec3::NEG_X]),
    ("up", [DVec3::X, DVec3::Z, DVec3::NEG_Y]),
    ("down", [DVec3::X, DVec3::NEG_Z, DVec3::Y]),
];
/// Tangent of 60 degrees. A plane that shows more than this stretches a fisheye's edge by 4.
const WIDE: f64 = 1.732_050_807_568_877_2;
/// Places on a side of a view at which the photograph is looked for.
const GRID: u32 = 32;
/// Ending of a view's name. That of its panorama comes before, and then the view's own.
const ENDING: &str = ".png";

/// Whether an image of `[width, height]` pixels has the shape of a panorama of 360 degrees.
#[must_use]
pub fn is_panorama([width, height]: [u32; 2]) -> bool {
    (f64::from(width) - 2.0 * f64::from(height)).abs() <= 0.01 * f64::from(width)
}

/// The panorama that a view is of, by the view's name; `None` for other images.
///
/// ```
/// use organza_data::panorama::panorama_of;
///
/// assert_eq!(panorama_of("images/7.front.png"), Some("images/7"));
/// assert_eq!(panorama_of("images/7.png"), None);
/// ```
#[must_use]
pub fn panorama_of(name: &str) -> Option<&str> {
    Some(face_of(name)?.0)
}

/// The panorama that a view is of, and the view's axes.
fn face_of(name: &str) -> Option<(&str, DMat3)> {
    let (panorama, view) = name.strip_suffix(ENDING)?.rsplit_once('.')?;
    let (_, [right, down, forward]) = FACES.into_iter().find(|(face, _)| *face == view)?;
    Some((panorama, DMat3::from_cols(right, down, forward)))
}

/// The six views of each panorama, around one place, sorted by name. The cameras are of views whose poses were found one
/// by one. The median of what they say of their panorama counts, so some may be wrong or missing.
#[must_use]
pub fn join(views: &[Camera]) -> Vec<Camera> {
    let mut panoramas: BTreeMap<_, Vec<(DVec4, DVec3)>> = BTreeMap::new();
    for view in views {
        let Some((panorama, axes)) = view.file_path.as_deref().and_then(face_of) else { continue };
        let [right, down, forward] = view.world_to_camera_opencv().map(DVec3::from);
        let turn = DMat3::from_cols(right, down, forward) * axes.transpose();
        let turn = DVec4::from(DQuat::from_mat3(&turn));
        let poses = panoramas.entry(panorama).or_default();
        // A quaternion and its negative are the same turn.
        let sign = poses.first().map_or(1.0, |(first, _)| turn.dot(*first).signum());
        poses.push((sign * turn, DVec3::from(view.eye())));
    }
    let joined = panoramas.iter().flat_map(|(panorama, poses)| {
        let turn = [0, 1, 2, 3].map(|at| median(poses.iter().map(|(turn, _)| turn[at])));
        let turn = DMat3::from_quat(DQuat::from_array(turn).normalize());
        let eye = [0, 1, 2].map(|axis| median(poses.iter().map(|(_, eye)| eye[axis])));
        FACES.map(|(face, [right, down, forward])| {
            let to_world = turn * DMat3::from_cols(right, -down, -forward);
            let row = |axis: usize| to_world.row(axis).extend(eye[axis]).to_array();
            let camera_to_world = [row(0), row(1), row(2), DVec4::W.to_array()];
            let file_path = Some(format!("{panorama}.{face}{ENDING}"));
            Camera { camera_to_world, file_path, ..views[0].clone() }
        })
    });
    let mut joined: Vec<_> = joined.collect();
    joined.sort_by(|a, b| a.file_path.cmp(&b.file_path));
    joined
}

/// The views of a panorama's file, each with at most `side` pixels a side.
///
/// # Errors
/// Those of [`Dataset::load`](super::Dataset::load) for a photograph.
pub fn cut(path: &Path, side: u32) -> Result<Vec<Frame>> {
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
        lens: Lens { panorama: true, ..Lens::default() },
        factor: factor as u32,
        held_out: false,
    };
    let options = DatasetOptions::default();
    let budget = Budget::beside(0);
    let frame = |view: Shot| view.develop(&options, &budget).map(|(frame, _)| frame);
    views(&shot, side * factor).into_par_iter().map(frame).collect()
}

/// The views of a photograph. One that a plane holds is its only view.
pub(super) fn views_of(shot: Shot) -> Vec<Shot> {
    let Camera { fl_x, fl_y, width, .. } = shot.camera;
    if shot.lens.panorama {
        views(&shot, f64::from(width) / PI)
    } else if is_wide(&shot) {
        views(&shot, 2.0 * fl_x.max(fl_y))
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
    shot.lens.fisheye && sides.into_iter().any(is_seen)
}

/// The views, of `side` pixels a side, that show some of the photograph.
fn views(shot: &Shot, side: f64) -> Vec<Shot> {
    let mut whole = Cut::whole(&shot.camera);
    if shot.lens.panorama {
        let [width, height] = whole.size.map(f64::from);
        whole.focal = [width / TAU, height / PI];
        whole.center = [width / 2.0, height / 2.0];
    }
    let side = side.round().clamp(1.0, f64::from(MAX_IMAGE_SIDE));
    let stem = shot.name.strip_suffix(ENDING).unwrap_or(&shot.name);
    let view = |(face, axes): (&str, [DVec3; 3])| {
        let [right, down, forward] = axes;
        let turned = |[x, y, z, place]: [f64; 4]| {
            // a file's y and z axes point up and back
            let row = DVec3::new(x, -y, -z);
            [row.dot(right), -row.dot(down), -row.dot(forward), place]
        };
        let [x, y, z, last] = shot.pose;
        let pose = [turned(x), turned(y), turned(z), last];
        let mut camera = Camera::pinhole(pose, [side / 2.0; 2], [side / 2.0; 2], [side as u32; 2]);
        let name = format!("{stem}.{face}{ENDING}");
        camera.file_path = Some(name.clone());
        let lens = Lens { cut: Some(Cut { axes, ..whole }), ..shot.lens };
        let undistortion = Undistortion::new(&camera, &lens);
        let place = |step: u32| (f64::from(step) + 0.5) * side / f64::from(GRID);
        let mut places = (0..GRID * GRID).map(|at| [place(at % GRID), place(at / GRID)]);
        let is_seen = places.any(|place| undistortion.source(place).is_some());
        is_seen.then(|| Shot { name, camera, pose, lens, ..shot.clone() })
    };
    FACES.into_iter().filter_map(view).collect()
}
