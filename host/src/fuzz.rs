//! Every parser of what comes from outside, on bytes: what `fuzz/` runs, and the tests replay.
//!
//! Each takes anything and returns; a panic, a hang or much memory is a bug.

use std::path::Path;

use crate::camera::parse;
use crate::data::fuzz as data;
use crate::input::parse_json;
use crate::scene::{Scene, read_tensors_from};
use crate::splats::read_from;
use crate::tile::TileBatch;
use crate::train::metrics;
use crate::train::{Checkpoint, TrainConfig};

/// A parser that may do nothing but return.
pub type Target = fn(&[u8]);

/// The targets by their names, which are those of the corpus's folders.
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

/// What errors name.
fn origin() -> &'static Path {
    Path::new("bytes")
}

/// A scene, and what is said of it.
pub fn scene(bytes: &[u8]) {
    if let Ok(scene) = Scene::from_bytes(bytes, origin()) {
        let _ = scene.warnings();
        let again = scene.to_bytes().expect("what was read can be written");
        assert!(Scene::from_bytes(&again, origin()).is_ok_and(|read| read == scene));
    }
}

/// The cameras of a `transforms.json`.
pub fn cameras(bytes: &[u8]) {
    if let Ok(file) = parse_json(bytes, origin()) {
        let _ = parse::cameras(&file, origin());
    }
}

/// A tiles file.
pub fn tiles(bytes: &[u8]) {
    if let Ok(file) = parse_json(bytes, origin()) {
        let _ = TileBatch::parse(&file, origin());
    }
}

/// A file of tensors.
pub fn tensors(mut bytes: &[u8]) {
    let length = bytes.len() as u64;
    let _ = read_tensors_from(&mut bytes, length, origin());
}

/// The frames of nerfstudio's and Blender's data sets.
pub fn transforms(bytes: &[u8]) {
    data::transforms(bytes, origin());
}

/// The files of COLMAP's models.
pub fn colmap(bytes: &[u8]) {
    data::colmap(bytes, origin());
}

/// A point cloud.
pub fn ply(bytes: &[u8]) {
    data::ply(bytes, origin());
}

/// Gaussians of another program.
pub fn splats(bytes: &[u8]) {
    let _ = read_from(bytes, bytes.len() as u64, origin());
}

/// A photograph.
pub fn photograph(bytes: &[u8]) {
    data::photograph(bytes, origin());
}

/// A run's settings, and what they take.
pub fn config(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(config) = TrainConfig::parse(text, origin()) {
        let _ = config.check_memory();
        let again = TrainConfig::parse(&config.to_toml(), origin());
        assert!(again.is_ok_and(|read| read == config), "what was read can be written");
    }
}

/// A checkpoint.
pub fn checkpoint(bytes: &[u8]) {
    let _ = Checkpoint::from_bytes(bytes, origin());
}

/// A log of training.
pub fn log(bytes: &[u8]) {
    let _ = metrics::parse(origin(), bytes);
}
