//! Writes sparse models like COLMAP.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use super::write_image;

/// A camera's id, its model's name and id, its image size, and its parameters.
pub type CameraRecord = (u32, (&'static str, i32), [u64; 2], Vec<f64>);

/// An image's name, rotation, translation and camera.
pub type ImageRecord = (&'static str, [f64; 4], [f64; 3], u32);

#[derive(Clone)]
pub struct Model {
    pub cameras: Vec<CameraRecord>,
    pub images: Vec<ImageRecord>,
    pub points: Vec<(u64, [f64; 3], [u8; 3])>,
}

/// Three photographs from two cameras, in no order.
pub fn sample() -> Model {
    Model {
        cameras: vec![
            (7, ("OPENCV", 4), [64, 48], vec![60.5, 61.5, 31.0, 25.0, 0.1, -0.02, 0.003, 0.004]),
            (2, ("SIMPLE_PINHOLE", 0), [64, 48], vec![100.0, 32.0, 24.0]),
        ],
        images: vec![
            ("b c.png", [0.5, 0.5, 0.5, 0.5], [-9.5, -1.25, 2.0], 2),
            ("a.png", [0.9, -0.1, 0.3, 0.2], [0.25, 1.5, -3.0], 7),
            ("sub/c.png", [-0.3, 0.4, 0.1, 0.8], [1.0, 2.0, 3.0], 2),
        ],
        points: vec![(90, [0.1, -0.2, 0.3], [255, 0, 1]), (12, [4.0, 5.0, 6.0], [7, 8, 9])],
    }
}

/// Writes a model to `sparse/0`, and its photographs to `images`.
pub fn write(root: &Path, model: &Model, binary: bool) {
    for (index, (name, _, _, camera)) in model.images.iter().enumerate() {
        let size = model.cameras.iter().find(|record| record.0 == *camera).unwrap().2;
        let size = size.map(|side| side as u32);
        write_image(&root.join("images").join(name), size, [index as u8, 50, 60]);
    }
    write_model(&root.join("sparse/0"), model, binary);
}

/// Writes a model's three files.
pub fn write_model(folder: &Path, model: &Model, binary: bool) {
    fs::create_dir_all(folder).unwrap();
    for (stem, bin, txt) in [
        ("cameras", cameras_bin(model), cameras_txt(model)),
        ("images", images_bin(model), images_txt(model)),
        ("points3D", points_bin(model), points_txt(model)),
    ] {
        let (extension, content) = if binary { ("bin", bin) } else { ("txt", txt.into_bytes()) };
        fs::write(folder.join(stem).with_extension(extension), content).unwrap();
    }
}

pub fn cameras_bin(model: &Model) -> Vec<u8> {
    let mut bytes = (model.cameras.len() as u64).to_le_bytes().to_vec();
    for (id, (_, model), size, values) in &model.cameras {
        bytes.extend(id.to_le_bytes());
        bytes.extend(model.to_le_bytes());
        bytes.extend(size.map(u64::to_le_bytes).as_flattened());
        values.iter().for_each(|value| bytes.extend(value.to_le_bytes()));
    }
    bytes
}

pub fn images_bin(model: &Model) -> Vec<u8> {
    let mut bytes = (model.images.len() as u64).to_le_bytes().to_vec();
    for (index, (name, rotation, translation, camera)) in model.images.iter().enumerate() {
        bytes.extend((index as u32 + 1).to_le_bytes());
        bytes.extend(rotation.map(f64::to_le_bytes).as_flattened());
        bytes.extend(translation.map(f64::to_le_bytes).as_flattened());
        bytes.extend(camera.to_le_bytes());
        bytes.extend(name.as_bytes());
        bytes.push(0);
        // The number of observations is the image's index.
        bytes.extend((index as u64).to_le_bytes());
        for _ in 0..index {
            bytes.extend([1.5_f64, 2.5].map(f64::to_le_bytes).as_flattened());
            bytes.extend(u64::MAX.to_le_bytes());
        }
    }
    bytes
}

pub fn points_bin(model: &Model) -> Vec<u8> {
    let mut bytes = (model.points.len() as u64).to_le_bytes().to_vec();
    for (index, (id, position, color)) in model.points.iter().enumerate() {
        bytes.extend(id.to_le_bytes());
        bytes.extend(position.map(f64::to_le_bytes).as_flattened());
        bytes.extend(color);
        bytes.extend(0.75_f64.to_le_bytes());
        bytes.extend((index as u64 + 1).to_le_bytes());
        for _ in 0..=index {
            bytes.extend([1_u32, 0].map(u32::to_le_bytes).as_flattened());
        }
    }
    bytes
}

/// Joins values with COLMAP's separator.
fn join<T: ToString>(values: &[T]) -> String {
    values.iter().map(T::to_string).collect::<Vec<_>>().join(" ")
}

pub fn cameras_txt(model: &Model) -> String {
    let mut text = "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, \
                    WIDTH, HEIGHT, PARAMS[]\n# Number of cameras: 2\n"
        .to_owned();
    for (id, (name, _), size, values) in &model.cameras {
        writeln!(text, "{id} {name} {} {}", join(size), join(values)).unwrap();
    }
    text
}

pub fn images_txt(model: &Model) -> String {
    let mut text = "# Image list with two lines of data per image:\n".to_owned();
    for (index, (name, rotation, translation, camera)) in model.images.iter().enumerate() {
        let pose = format!("{} {}", join(rotation), join(translation));
        let observations = vec!["1.5 2.5 -1"; index].join(" ");
        writeln!(text, "{} {pose} {camera} {name}\n{observations}", index + 1).unwrap();
    }
    text
}

pub fn points_txt(model: &Model) -> String {
    let mut text = "# 3D point list with one line of data per point:\n".to_owned();
    for (id, position, color) in &model.points {
        writeln!(text, "{id} {} {} 0.75 1 0 2 1", join(position), join(color)).unwrap();
    }
    text
}
