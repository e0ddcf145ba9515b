use std::f64::consts::{PI, TAU};

use super::*;

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// A camera at `eye`, turned by an angle around z from looking along -y, with a focal length.
fn turned(eye: [f64; 3], angle: f64, focal: f64) -> Camera {
    let (sin, cos) = angle.sin_cos();
    let target = [eye[0] + sin, eye[1] - cos, eye[2]];
    let camera = Camera::look_at(eye, target, UP, 1.0, [96, 80]).unwrap();
    Camera { fl_x: focal, fl_y: focal, ..camera }
}

fn around(angle: f64) -> Camera {
    let (sin, cos) = angle.sin_cos();
    Camera::look_at([3.0 * cos, 3.0 * sin, 1.0], [0.0, 0.0, 1.0], UP, 1.0, [96, 80]).unwrap()
}

fn difference(a: &Camera, b: &Camera) -> f64 {
    let pose = |camera: &Camera| camera.camera_to_world.as_flattened().to_vec();
    let values = |camera: &Camera| [pose(camera), vec![camera.fl_x, camera.cx]].concat();
    values(a).iter().zip(values(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_path_meets_its_keys() {
    let keys = [
        turned([0.0, 0.0, 0.0], 0.0, 50.0),
        turned([1.0, 0.5, 2.0], 2.0, 80.0),
        turned([1.1, 0.5, 2.0], -2.0, 20.0),
        turned([7.0, -3.0, 1.0], 3.0, 60.0),
    ];
    for is_closed in [false, true] {
        let path = CameraPath::through(&keys, is_closed).unwrap();
        let times = path.times();
        assert_eq!((times.len(), times[0]), (4 + usize::from(is_closed), 0.0));
        assert_eq!(*times.last().unwrap(), 1.0);
        for (key, time) in keys.iter().zip(&times) {
            assert!(difference(key, &path.at(*time)) < 1e-9, "{time}");
        }
        assert!(difference(&path.at(1.0), &keys[if is_closed { 0 } else { 3 }]) < 1e-9);
    }
}

/// A linear motion stays linear, at an even pace, for any spacing of the keys: a straight way, a turn by more than a
/// full circle, a zoom by equal factors.
#[test]
fn an_even_motion_is_kept() {
    let at = |time: f64| {
        let eye = [4.0 * time, -2.0 * time, time];
        let focal = 40.0 * 3.0_f64.powf(time);
        turned(eye, 2.5 * PI * time, focal)
    };
    let times = [0.0, 0.1, 0.35, 0.4, 0.7, 1.0];
    let path = CameraPath::through(&times.map(at), false).unwrap();
    for (expected, found) in times.iter().zip(path.times()) {
        assert!((expected - found).abs() < 1e-12, "{expected} {found}");
    }
    for step in 0..=100 {
        let time = f64::from(step) / 100.0;
        let off = difference(&path.at(time), &at(time));
        assert!(off < 1e-9, "{time}: {off}");
    }
}

/// Cameras that look at one place turn around it and keep it in view, even if they are few.
#[test]
fn keys_that_look_at_one_place_make_an_orbit() {
    let angles = [0.0, 0.8, 2.0, 4.3];
    let path = CameraPath::through(&angles.map(around), true).unwrap();
    for camera in path.cameras(100) {
        let [x, y, z] = camera.eye();
        assert!((x.hypot(y) - 3.0).abs() < 0.01 && (z - 1.0).abs() < 1e-9, "{x} {y} {z}");
        let forward = camera.axes()[2];
        let missed = DVec3::new(-x, -y, 0.0).reject_from_normalized(forward).length();
        assert!(missed < 0.03, "{missed}");
    }
}

/// A camera on the circle that looks outward.
fn outward(angle: f64) -> Camera {
    let [sin, cos] = [angle.sin(), angle.cos()].map(|value| 3.0 * value);
    Camera::look_at([cos, sin, 1.0], [2.0 * cos, 2.0 * sin, 1.0], UP, 1.0, [96, 80]).unwrap()
}

/// Eight keys on a circle look at no common place. Halfway between two keys the curve's distance from the center has
/// a closed form, and the rotation is the circle's own.
#[test]
fn a_closed_path_through_a_circle_stays_near_it() {
    let angle = TAU / 8.0;
    let keys: Vec<_> = (0..8).map(|key| outward(angle * f64::from(key))).collect();
    let path = CameraPath::through(&keys, true).unwrap();
    let half = 3.0 * ((angle / 2.0).cos() + angle.sin() * (angle / 2.0).sin() / 4.0);
    for key in 0..8 {
        let camera = path.at((f64::from(key) + 0.5) / 8.0);
        let [x, y, z] = camera.eye();
        assert!((x.hypot(y) - half).abs() < 1e-9, "{} {half}", x.hypot(y));
        assert!((z - 1.0).abs() < 1e-12);
        let circle = outward(angle * (f64::from(key) + 0.5));
        for (row, expected) in camera.camera_to_world.iter().zip(circle.camera_to_world) {
            let off = row[..3].iter().zip(expected).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-9);
        }
    }
}

/// Left and right of every key the velocities agree.
#[test]
fn velocities_are_continuous() {
    let keys = [
        turned([0.0, 0.0, 0.0], 0.3, 50.0),
        around(0.5),
        turned([1.0, 0.5, 2.0], 2.0, 80.0),
        turned([7.0, -3.0, 1.0], -3.0, 60.0),
        around(4.0),
    ];
    let h = 1e-6;
    for is_closed in [false, true] {
        let path = CameraPath::through(&keys, is_closed).unwrap();
        let velocity = |from: f64| {
            let [a, b] = [from, from + h].map(|time| path.at(time.rem_euclid(1.0 + 1e-15)));
            let values = |camera: &Camera| {
                [camera.camera_to_world.as_flattened(), &[camera.fl_x, camera.cx]].concat()
            };
            let pairs = values(&b).into_iter().zip(values(&a));
            pairs.map(|(b, a)| (b - a) / h).collect::<Vec<_>>()
        };
        let times = path.times();
        let closing = is_closed.then_some(0.0);
        for time in times[1..times.len() - 1].iter().copied().chain(closing) {
            let before = if time == 0.0 { 1.0 - h } else { time - h };
            for (left, right) in velocity(before).iter().zip(velocity(time)) {
                let size = 1.0 + left.abs().max(right.abs());
                assert!((left - right).abs() < 2e-3 * size, "{time}: {left} {right}");
            }
        }
    }
}

#[test]
fn every_camera_of_a_path_is_valid() {
    // half turns, equal keys, a camera that stands still
    let still = turned([1.0, 2.0, 3.0], 0.0, 50.0);
    let keys = [still.clone(), turned([1.0, 2.0, 3.0], PI, 50.0), still.clone(), still.clone()];
    for keys in [&keys[..], &keys[2..]] {
        for is_closed in [false, true] {
            let path = CameraPath::through(keys, is_closed).unwrap();
            for (index, camera) in path.cameras(50).iter().enumerate() {
                camera.validate(index).unwrap();
            }
        }
    }
}

#[test]
fn cameras_are_at_equal_times() {
    let keys = [around(0.0), around(1.0), around(2.0)];
    let path = CameraPath::through(&keys, false).unwrap();
    let cameras = path.cameras(5);
    assert_eq!(cameras.len(), 5);
    assert!(difference(&cameras[0], &keys[0]) < 1e-9 && difference(&cameras[4], &keys[2]) < 1e-9);
    assert_eq!(cameras[1], path.at(0.25));
    let closed = CameraPath::through(&keys, true).unwrap();
    assert_eq!(closed.cameras(5)[1], closed.at(0.2));
    assert_eq!((path.cameras(1).len(), path.cameras(0).len()), (1, 0));
}

#[test]
fn invalid_keys_are_refused() {
    let refused = |keys: &[Camera]| CameraPath::through(keys, true).unwrap_err().to_string();
    assert!(refused(&[]).contains("two cameras"));
    assert!(refused(&[around(0.0)]).contains("found 1"));
    let small = Camera { width: 48, ..around(0.0) };
    assert!(refused(&[around(0.0), small]).contains("96 x 80 and 48 x 80"));
    let broken = Camera { fl_x: f64::NAN, ..around(0.0) };
    assert!(refused(&[around(0.0), broken]).contains("fl_x"));
}
