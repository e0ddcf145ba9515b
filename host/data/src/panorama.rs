//! Cuts photographs with too wide a view for one plane into pinhole views: panoramas of 360 degrees, and wide fisheyes.
//!
//! The views to train on are the faces of a cube around the camera. So each direction, also a pole, is seen once, and no
//! color counts twice. In the middle of a view, a pixel is as wide as the photograph's. Elsewhere it is narrower, so no
//! detail is lost. Only near a panorama's poles are columns closer together, but there they repeat one another.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::develop::Shot;
use super::lens::{Lens, Projection, Reprojection, Undistortion};
use organza_core::camera::{Camera, MAX_IMAGE_SIDE};

/// The faces of a cube: their names, and their right, down and forward axes in the photograph's camera space.
const FACES: [(&str, [DVec3; 3]); 6] = [
    ("front", heading(1.0, 0.0)),
    ("right", heading(0.0, 1.0)),
    ("back", heading(-1.0, 0.0)),
    ("left", heading(0.0, -1.0)),
    ("up", [DVec3::X, DVec3::Z, DVec3::NEG_Y]),
    ("down", [DVec3::X, DVec3::NEG_Z, DVec3::Y]),
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

/// The views of a photograph. A photograph that fits on one plane is its only view.
pub(super) fn views_of(shot: Shot) -> Vec<Shot> {
    let Camera { fl_x, fl_y, width, .. } = shot.camera;
    if shot.lens.projection == Projection::Panorama {
        faces(&shot, f64::from(width) / PI)
    } else if is_wide(&shot) {
        faces(&shot, 2.0 * fl_x.max(fl_y))
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

/// The faces, of `side` x `side` pixels, that show some of the photograph.
fn faces(shot: &Shot, side: f64) -> Vec<Shot> {
    let mut whole = Reprojection::whole(&shot.camera);
    if shot.lens.projection == Projection::Panorama {
        let [width, height] = whole.size.map(f64::from);
        whole.focal = [width / TAU, height / PI];
        whole.center = [width / 2.0, height / 2.0];
    }
    let side = side.round().clamp(1.0, f64::from(MAX_IMAGE_SIDE));
    let stem = shot.name.strip_suffix(ENDING).unwrap_or(&shot.name);
    let view = |(view, axes): (&str, [DVec3; 3])| {
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
    FACES.into_iter().filter_map(view).collect()
}
