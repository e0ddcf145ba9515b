//! Compares the lens with OpenCV.

use std::collections::BTreeMap;

use glam::DVec3;

use super::super::lens::{Lens, Projection, Undistortion};
use super::*;

fn camera([width, height]: [u32; 2], [fl_x, fl_y, cx, cy]: [f64; 4]) -> Camera {
    let camera_to_world = POSE;
    Camera { camera_to_world, fl_x, fl_y, cx, cy, width, height, file_path: None, distorted: true }
}

const WIDE: ([u32; 2], [f64; 4]) = ([640, 480], [500.0, 510.0, 321.25, 238.5]);
const ROUND: ([u32; 2], [f64; 4]) = ([640, 480], [210.0, 212.0, 321.25, 238.5]);
const PORTRAIT: ([u32; 2], [f64; 4]) = ([270, 480], [343.88, 343.6225, 138.6395, 241.317]);

/// Positions of pixel centers according to OpenCV 5.0: `cv2.projectPoints` of `((x + 0.5 - cx) / fl_x, (y + 0.5 - cy)
/// / fl_y, 1)` with the camera matrix of `cx - 0.5` and `cy - 0.5` (OpenCV's pixels have their centers at whole
/// numbers) and the coefficients `(k1, k2, p1, p2, k3)`, plus 0.5. `cv2.initUndistortRectifyMap` gave the same, in
/// f32. `full` has the coefficients `(k1, k2, p1, p2, k3, k4, k5, k6)`, and the last two are from `cv2.fisheye.projectPoints`.
const TABLES: &str = include_str!("opencv.json");

/// Pixels, and their positions.
type Table = [([u32; 2], [f64; 2]); 5];

fn fisheye(radial: [f64; 4]) -> Lens {
    Lens { projection: Projection::Fisheye, radial, ..Lens::default() }
}

#[test]
fn places_match_opencv() {
    let denominator = [0.52, -0.07, 0.011];
    let full = Lens { denominator, ..lens([0.31, -0.12, 0.018], [0.0012, -0.0007]) };
    let tables: BTreeMap<&str, Table> = serde_json::from_str(TABLES).unwrap();
    for ((size, intrinsics), lens, table) in [
        (PORTRAIT, lens([0.0578421, -0.0805099, 0.0], [-0.000980296, 0.00015575]), "phone"),
        (WIDE, lens([-0.28, 0.09, -0.015], [0.0012, -0.0007]), "barrel"),
        (WIDE, lens([0.11, 0.0, 0.0], [0.0, 0.0]), "pincushion"),
        (WIDE, lens([0.0, 0.0, 0.0], [0.01, -0.02]), "tilted"),
        (WIDE, full, "full"),
        (ROUND, fisheye([0.03, -0.012, 0.004, -0.0011]), "fisheye"),
        (ROUND, fisheye([0.0; 4]), "equidistant"),
    ] {
        let camera = camera(size, intrinsics);
        let way = Undistortion::new(&camera, &lens);
        for (pixel, expected) in tables[table] {
            let [x, y] = pixel.map(|place| f64::from(place) + 0.5);
            let [across, down] = [(x - camera.cx) / camera.fl_x, (y - camera.cy) / camera.fl_y];
            let bent = lens.project(DVec3::new(across, down, 1.0));
            let found = [camera.fl_x * bent[0] + camera.cx, camera.fl_y * bent[1] + camera.cy];
            let off = [0, 1].map(|axis| (found[axis] - expected[axis]).abs());
            assert!(off.iter().all(|&off| off < 1e-8), "{pixel:?}: {found:?}, {expected:?}");
            let inside = [0, 1].map(|i| (0.0..=f64::from(size[i])).contains(&expected[i]));
            assert_eq!(way.source([x, y]), (inside == [true; 2]).then_some(found));
        }
    }
}

#[test]
fn a_pinhole_bends_nothing() {
    assert!(Lens::default().is_pinhole());
    assert_eq!(Lens::default().project(DVec3::new(0.3, -0.7, 1.0)), [0.3, -0.7]);
    assert!(!lens([0.0, 0.0, 1e-9], [0.0; 2]).is_pinhole());
    assert!(!lens([0.0; 3], [0.0, 1e-9]).is_pinhole());
    assert!(!Lens { denominator: [0.0, 0.0, 1e-9], ..Lens::default() }.is_pinhole());
    // A fisheye's radius is a function of the angle, even without coefficients.
    assert!(!fisheye([0.0; 4]).is_pinhole());
}

/// r (1 - r^2 / 3) turns around at r = 1, and is back at the photograph's center at 1.7.
#[test]
fn places_beyond_the_fold_are_outside() {
    let camera = camera([400, 400], [100.0, 100.0, 200.0, 200.0]);
    let lens = lens([-1.0 / 3.0, 0.0, 0.0], [0.0; 2]);
    let way = Undistortion::new(&camera, &lens);
    let at = |radius: f64| way.source([200.0 + 100.0 * radius, 200.0]);
    let found = at(0.9).unwrap();
    assert!((found[0] - 265.7).abs() < 1e-9 && found[1] == 200.0, "{found:?}");
    assert!(at(0.999).is_some());
    for radius in [1.001, 1.2, 1.7, 1.99] {
        assert_eq!(at(radius), None, "{radius}");
    }
}

/// A denominator of 1 - r^2 has a pole at r = 1. Beyond it, a place in the image shows nothing real.
#[test]
fn places_beyond_a_pole_are_outside() {
    let camera = camera([1000, 1000], [100.0, 100.0, 500.0, 500.0]);
    let lens = Lens { denominator: [-1.0, 0.0, 0.0], ..Lens::default() };
    let way = Undistortion::new(&camera, &lens);
    assert!(way.source([500.0 + 50.0, 500.0]).is_some());
    for radius in [1.01, 1.5, 3.0] {
        assert_eq!(way.source([500.0 + 100.0 * radius, 500.0]), None, "{radius}");
    }
}
