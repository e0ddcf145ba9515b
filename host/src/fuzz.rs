//! Every parser of external data, on bytes. `fuzz/` runs them, and the tests replay its findings.
//!
//! Each takes any bytes and returns. A panic, a hang or excessive memory is a bug.

use std::path::Path;

use crate::camera::parse;
use crate::data::fuzz as data;
use crate::input::parse_json;
use crate::scene::{Scene, read_tensors_from};
use crate::tile::TileBatch;
use crate::train::{Checkpoint, TrainConfig, metrics};
use organza_splats::read_from;

/// A parser of bytes, which must return.
pub type Target = fn(&[u8]);

/// The targets by name. The corpus has a folder of the same name for each.
pub const TARGETS: [(&str, Target); 12] = [
    ("scene", scene),
    ("cameras", cameras),
    ("tiles", tiles),
    ("tensors", tensors),
    ("transforms", transforms),
    ("colmap", colmap),
    ("ply", ply),
    ("splats", splats),
    ("photograph", photograph),
    ("config", config),
    ("checkpoint", checkpoint),
    ("metrics", log),
];

/// The path that errors name.
fn origin() -> &'static Path {
    Path::new("bytes")
}

/// Reads a scene, and describes it.
pub fn scene(bytes: &[u8]) {
    if let Ok(scene) = Scene::from_bytes(bytes, origin()) {
        let _ = scene.warnings();
        let again = scene.to_bytes().expect("what was read can be written");
        assert!(Scene::from_bytes(&again, origin()).is_ok_and(|read| read == scene));
    }
}

/// Reads the cameras of a `transforms.json`.
pub fn cameras(bytes: &[u8]) {
    if let Ok(file) = parse_json(bytes, origin()) {
        let _ = parse::cameras(&file, origin());
    }
}

/// Reads a tiles file.
pub fn tiles(bytes: &[u8]) {
    if let Ok(file) = parse_json(bytes, origin()) {
        let _ = TileBatch::parse(&file, origin());
    }
}

/// Reads a file of tensors.
pub fn tensors(mut bytes: &[u8]) {
    let length = bytes.len() as u64;
    let _ = read_tensors_from(&mut bytes, length, origin());
}

/// Reads the frames of nerfstudio's and Blender's data sets.
pub fn transforms(bytes: &[u8]) {
    data::transforms(bytes, origin());
}

/// Reads the files of COLMAP's models.
pub fn colmap(bytes: &[u8]) {
    data::colmap(bytes, origin());
}

/// Reads a point cloud.
pub fn ply(bytes: &[u8]) {
    data::ply(bytes, origin());
}

/// Reads another program's Gaussians.
pub fn splats(bytes: &[u8]) {
    let _ = read_from(bytes, bytes.len() as u64, origin());
}

/// Reads a photograph.
pub fn photograph(bytes: &[u8]) {
    data::photograph(bytes, origin());
}

/// Reads a run's settings, and computes the memory that they need.
pub fn config(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(config) = TrainConfig::parse(text, origin()) {
        let _ = config.check_memory();
        let again = TrainConfig::parse(&config.to_toml(), origin());
        assert!(again.is_ok_and(|read| read == config), "what was read can be written");
    }
}

/// Reads a checkpoint.
pub fn checkpoint(bytes: &[u8]) {
    let _ = Checkpoint::from_bytes(bytes, origin());
}

/// Reads a log of training.
pub fn log(bytes: &[u8]) {
    let _ = metrics::parse(origin(), bytes);
}
