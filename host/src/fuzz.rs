//! Every parser of external data, on bytes. The tests run them on `tests/corpus`.
//!
//! Each takes any bytes and returns. A panic, a hang or excessive memory is a bug.

use crate::camera::parse;
use crate::data::fuzz::{colmap, origin, photograph, ply, transforms};
use crate::scene::{Scene, read_tensors_from};
use crate::tile::TileBatch;
use crate::train::{Checkpoint, TrainConfig, metrics};
use organza_core::input::parse_json;
use organza_splats::read_from;

/// A parser of bytes, which must return.
pub type Target = fn(&[u8]);

/// The targets by name. The corpus has a folder of the same name for each.
pub const TARGETS: [(&str, Target); 12] = [
    ("scene", scene),
    ("cameras", |bytes| {
        let cameras = parse_json(bytes, origin()).and_then(|file| parse::cameras(&file, origin()));
        assert!(cameras.unwrap_or_default().iter().all(|camera| camera.check().is_ok()));
    }),
    ("tiles", |bytes| {
        let _ = parse_json(bytes, origin()).map(|file| TileBatch::parse(&file, origin()));
    }),
    ("tensors", |mut bytes| {
        let length = bytes.len() as u64;
        let _ = read_tensors_from(&mut bytes, length, origin());
    }),
    ("transforms", transforms),
    ("colmap", colmap),
    ("ply", ply),
    ("splats", |bytes| {
        let _ = read_from(bytes, origin());
    }),
    ("photograph", photograph),
    ("config", config),
    ("checkpoint", |bytes| {
        let _ = Checkpoint::from_bytes(bytes, origin());
    }),
    ("metrics", |bytes| {
        let _ = metrics::parse(origin(), bytes);
    }),
];

/// Reads a scene, and describes it.
fn scene(bytes: &[u8]) {
    if let Ok(scene) = Scene::from_bytes(bytes, origin()) {
        let _ = scene.warnings();
        let again = scene.to_bytes().expect("what was read can be written");
        assert!(Scene::from_bytes(&again, origin()).is_ok_and(|read| read == scene));
    }
}

/// Reads a run's settings, and computes the memory that they need.
fn config(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(config) = TrainConfig::parse(text, origin()) {
        let _ = config.check_memory();
        let again = TrainConfig::parse(&config.to_toml(), origin());
        assert!(again.is_ok_and(|read| read == config), "what was read can be written");
    }
}
