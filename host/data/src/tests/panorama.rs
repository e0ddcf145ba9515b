//! Panoramas and wide fisheyes, cut into pinhole views. Their pixels are painted with the directions that they show, by
//! formulas of their own.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use super::*;

/// A turned camera, at (5, -2, 1).
fn pose() -> ([[f64; 4]; 4], DMat3) {
    let turn = DMat3::from_euler(glam::EulerRot::ZYX, 0.7, -0.3, 2.1);
    let row = |axis: usize| {
        let [x, y, z] = turn.row(axis).to_array();
        [x, y, z, [5.0, -2.0, 1.0][axis]]
    };
    ([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]], turn)
}

/// The direction of a panorama's pixel in the camera's axes (OpenGL's), as nerfstudio has it: columns are -1 to 1 to the
/// right, rows 1/2 to -1/2 downward, both times pi.
fn shown_by_panorama([x, y]: [f64; 2], [width, height]: [u32; 2]) -> DVec3 {
    let theta = -PI * (2.0 * x / f64::from(width) - 1.0);
    let phi = PI * y / f64::from(height);
    DVec3::new(-theta.sin() * phi.sin(), phi.cos(), -theta.cos() * phi.sin())
}

/// The direction of an equidistant fisheye's pixel, with as many pixels in a radian.
fn shown_by_fisheye([x, y]: [f64; 2], [width, height]: [u32; 2], focal: f64) -> DVec3 {
    let [x, y] = [x - 0.5 * f64::from(width), y - 0.5 * f64::from(height)];
    let (sin, cos) = (x.hypot(y) / focal).sin_cos();
    DVec3::new(sin * x / x.hypot(y), -sin * y / x.hypot(y), -cos)
}

fn color_of(direction: DVec3) -> DVec3 {
    127.5 * (direction.normalize() + 1.0)
}

/// A data set of photographs. `color` gives the color at a place in pixels.
fn folder(file: &Value, size: [u32; 2], color: impl Fn([f64; 2]) -> DVec3) -> TempDir {
    let folder = nerfstudio_folder(file);
    let pixel = |x: u32, y: u32| {
        let color = color([x, y].map(|place| f64::from(place) + 0.5));
        image::Rgb(color.round().to_array().map(|value| value as u8))
    };
    let image = image::RgbImage::from_fn(size[0], size[1], pixel);
    for frame in file["frames"].as_array().unwrap() {
        image.save(folder.path().join(frame["file_path"].as_str().unwrap())).unwrap();
    }
    folder
}

fn panoramas(count: usize, [width, height]: [u32; 2]) -> Value {
    let (pose, _) = pose();
    let frame =
        |index| json!({"file_path": format!("images/{index}.png"), "transform_matrix": pose});
    json!({"camera_model": "EQUIRECTANGULAR", "w": width, "h": height,
        "frames": (0..count).map(frame).collect::<Vec<_>>()})
}

/// The differences of a frame's valid pixels from the colors that their rays should have. `None` is for a ray that the
/// photograph does not show.
fn differences(frame: &Frame, color: impl Fn(DVec3) -> Option<DVec3>) -> Vec<f64> {
    let Camera { fl_x, fl_y, cx, cy, width, height, .. } = frame.camera;
    let rows = frame.camera.camera_to_world.map(|[x, y, z, _]| DVec3::new(x, y, z));
    let mut off = Vec::new();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let [column, row] = [x, y].map(|place| f64::from(place) + 0.5);
        let ray = DVec3::new((column - cx) / fl_x, -(row - cy) / fl_y, -1.0);
        let ray = DVec3::new(rows[0].dot(ray), rows[1].dot(ray), rows[2].dot(ray));
        let expected = color(ray);
        assert_eq!(frame.image.is_valid(x, y), expected.is_some(), "{}: {x},{y}", frame.name);
        let found = DVec3::from(frame.image.color(x, y).map(|value| 255.0 * f64::from(value)));
        off.extend(expected.map(|expected| (found - expected).abs().max_element()));
    }
    off
}

#[test]
fn views_of_a_panorama_show_the_directions_of_their_rays() {
    let size = [512, 256];
    let (_, turn) = pose();
    let file = panoramas(2, size);
    let folder = folder(&file, size, |place| color_of(turn * shown_by_panorama(place, size)));
    let dataset = load(folder.path()).unwrap();
    let names: Vec<_> = dataset.frames.iter().map(|frame| frame.name.as_str()).collect();
    let expected = ["0.front", "0.right", "0.back", "0.left", "0.up", "0.down", "1.front"];
    assert_eq!(names[..7], expected.map(|name| format!("images/{name}.png")));
    for frame in &dataset.frames {
        assert_eq!((frame.image.width(), frame.image.height()), (163, 163));
        assert_eq!(frame.camera.eye(), [5.0, -2.0, 1.0]);
        let off = differences(frame, |ray| Some(color_of(ray))).into_iter().fold(0.0, f64::max);
        // two roundings to 8 bits, and half a row at a pole
        println!("{}: at most {off} of 255", frame.name);
        assert!(off < 1.6, "{}: {off}", frame.name);
    }
}

#[test]
fn views_of_a_wide_fisheye_show_the_directions_of_their_rays() {
    let size = [160, 144];
    let (_, turn) = pose();
    let mut file = panoramas(2, size);
    file["camera_model"] = json!("OPENCV_FISHEYE");
    file["fl_x"] = json!(40.0);
    let paint = |place| color_of(turn * shown_by_fisheye(place, size, 40.0));
    let folder = folder(&file, size, paint);
    let dataset = load(folder.path()).unwrap();
    assert_eq!(dataset.frames.len(), 12);
    let color = |ray: DVec3| {
        let DVec3 { x, y, z } = turn.transpose() * ray;
        let pixels = 40.0 * (-z / ray.length()).acos() / x.hypot(y);
        ((pixels * x).abs() <= 80.0 && (pixels * y).abs() <= 72.0).then(|| color_of(ray))
    };
    for frame in &dataset.frames {
        assert_eq!((frame.camera.width, frame.camera.eye()), (80, [5.0, -2.0, 1.0]));
        let off = differences(frame, color).into_iter().fold(0.0, f64::max);
        println!("{}: at most {off} of 255", frame.name);
        assert!(off < 2.0, "{}: {off}", frame.name);
    }
    // 57 degrees fit on a plane
    file["fl_x"] = json!(80.0);
    write_json(&folder.path().join("transforms.json"), &file);
    let names: Vec<_> = load(folder.path()).unwrap().frames.into_iter().map(|f| f.name).collect();
    assert_eq!(names, ["images/0.png", "images/1.png"]);
}

#[test]
fn panoramas_leave_whole_and_views_may_be_hidden() {
    let size = [48, 24];
    let folder = folder(&panoramas(10, size), size, |[x, y]| DVec3::new(x, y, 9.0));
    // black where the sky is
    let mask = image::GrayImage::from_fn(48, 24, |_, y| image::Luma([255 * u8::from(y >= 12)]));
    std::fs::create_dir(folder.path().join("masks")).unwrap();
    mask.save(folder.path().join("masks/1.png")).unwrap();
    let dataset = load(folder.path()).unwrap();
    let held_out: Vec<_> = (0..6).chain(48..54).collect();
    assert_eq!((dataset.frames.len(), &dataset.held_out), (60, &held_out));
    assert_eq!(dataset.frames[10].name, "images/1.up.png");
    assert_eq!(dataset.train.iter().position(|&index| index >= 10), Some(4));
    assert_eq!((dataset.train[4], dataset.masked), (11, 6));
    let file = folder.path().join("transforms.json");
    assert_facts(Camera::load_all(file), &["transforms.json", "frame 0", "name its folder"]);
}
