//! Runs the parsers of data sets on arbitrary bytes.

use std::io::Cursor;
use std::path::Path;

use super::find::PhotographFile;
use super::transforms::{Photographs, add_frames};
use super::{DatasetOptions, Poses, colmap, decode, ply};
use organza_core::input::parse_json;

/// The path that errors name.
pub fn origin() -> &'static Path {
    Path::new("bytes")
}

/// Memory that a photograph may take, in bytes.
const PHOTOGRAPH_BYTES: u64 = 64 << 20;

/// Parses nerfstudio's and Blender's files, as if every photograph existed.
pub fn transforms(bytes: &[u8]) {
    let Ok(file) = parse_json(bytes, origin()) else { return };
    let photographs = Photographs {
        find: |folder, name, _, _| {
            Ok(PhotographFile { path: folder.join(name), prepared: false, mask: None })
        },
        size: |_| Ok([64, 48]),
    };
    let Ok(mut poses) = Poses::new(Path::new("/"), &DatasetOptions::default()) else { return };
    let _ = add_frames(&mut poses, &file, origin(), |_| false, &photographs);
}

/// Parses each file of a sparse model, binary and text.
pub fn colmap(bytes: &[u8]) {
    colmap::fuzz(bytes, origin());
}

/// Parses a point cloud.
pub fn ply(bytes: &[u8]) {
    let _ = ply::read_from(bytes, origin());
}

/// Decodes a photograph, with a camera of its size.
pub fn photograph(bytes: &[u8]) {
    let length = bytes.len() as u64;
    let Ok(size) = decode::size_from(Cursor::new(bytes), length, origin()) else { return };
    if decode::bytes_to_decode(length, size) > PHOTOGRAPH_BYTES {
        return;
    }
    if let Ok(decoded) = decode::decode(bytes, size, origin(), decode::PHOTOGRAPH) {
        let _ = decoded.rgba(size[0] - 1, size[1] - 1);
    }
}
