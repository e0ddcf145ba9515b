mod broken_colmap;
mod colmap;
mod colmap_files;
mod find;
mod gains;
mod lens;
mod load;
mod nerfstudio;
mod panorama;
mod photograph;
mod placement;
mod ply;

use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::*;
use organza_core::error::chain;

/// The pose of a camera at (0, 0, 4) that looks at the origin.
const POSE: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 4.0], [0.0, 0.0, 0.0, 1.0]];

fn lens([k1, k2, k3]: [f64; 3], tangential: [f64; 2]) -> Lens {
    Lens { radial: [k1, k2, k3, 0.0], tangential, ..Lens::default() }
}

/// Writes an image of one color, in the format of its extension.
fn write_image(path: &Path, [width, height]: [u32; 2], color: [u8; 3]) {
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    image::RgbImage::from_pixel(width, height, image::Rgb(color)).save(path).unwrap();
}

fn write_json(path: &Path, value: &Value) {
    std::fs::write(path, serde_json::to_vec(value).unwrap()).unwrap();
}

/// A nerfstudio file with `count` photographs of 6 x 4 pixels.
fn transforms(count: usize) -> Value {
    let frame =
        |index| json!({"file_path": format!("images/{index}.png"), "transform_matrix": POSE});
    json!({"camera_model": "OPENCV", "w": 6, "h": 4, "fl_x": 8.0, "fl_y": 9.0, "cx": 3.25,
        "cy": 1.75, "frames": (0..count).map(frame).collect::<Vec<_>>()})
}

/// Writes a data set of [`transforms`] whose photographs differ in red.
fn nerfstudio_folder(file: &Value) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (index, frame) in file["frames"].as_array().unwrap().iter().enumerate() {
        let path = folder.path().join(frame["file_path"].as_str().unwrap());
        write_image(&path, [6, 4], [index as u8, 20, 30]);
    }
    write_json(&folder.path().join("transforms.json"), file);
    folder
}

/// Options with which cameras and points stay where the files have them.
fn in_the_world() -> DatasetOptions {
    DatasetOptions { placement: Some(Placement::default()), ..Default::default() }
}

fn load(path: &Path) -> Result<Dataset> {
    Dataset::load(path, &in_the_world())
}

/// Asserts that a data set is refused, with all the facts in the message.
#[track_caller]
fn assert_refused(path: &Path, facts: &[&str]) {
    assert_facts(load(path).map(|_| "a data set"), facts);
}

#[track_caller]
fn assert_facts<T: std::fmt::Debug>(result: Result<T>, facts: &[&str]) {
    let text = chain(&result.unwrap_err());
    for fact in facts {
        assert!(text.contains(fact), "no {fact:?} in: {text}");
    }
}
