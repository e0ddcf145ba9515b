//! Describes a tiles file.

use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

use organza::TileBatch;
use organza::error::format_bytes;
use serde::Serialize;

use super::{MOST_ROWS, and_more, file_bytes};
use crate::cli::summary::count;
use crate::cli::table::Table;

#[derive(Debug, Serialize)]
pub struct TileFile {
    kind: &'static str,
    file: String,
    file_bytes: u64,
    side: u32,
    tiles: usize,
    output_shape: [usize; 4],
    output_bytes: u64,
    /// One entry per camera, by ascending index.
    cameras: Vec<CameraTiles>,
}

/// The tiles of one camera.
#[derive(Debug, Serialize)]
struct CameraTiles {
    camera: usize,
    tiles: usize,
    /// Column and row of the first pixel, and of the pixel after the last.
    low: [i32; 2],
    high: [i32; 2],
}

impl TileFile {
    pub fn new(path: &Path, batch: &TileBatch) -> Self {
        let mut cameras: BTreeMap<usize, CameraTiles> = BTreeMap::new();
        for tile in &batch.tiles {
            let low = tile.origin;
            let high = tile.origin.map(|at| at + batch.side as i32);
            let empty = CameraTiles { camera: tile.camera, tiles: 0, low, high };
            let camera = cameras.entry(tile.camera).or_insert(empty);
            camera.tiles += 1;
            for axis in 0..2 {
                camera.low[axis] = camera.low[axis].min(low[axis]);
                camera.high[axis] = camera.high[axis].max(high[axis]);
            }
        }
        let output_shape = batch.output_shape();
        Self {
            kind: "tiles",
            file: path.display().to_string(),
            file_bytes: file_bytes(path),
            side: batch.side,
            tiles: batch.tiles.len(),
            output_shape,
            output_bytes: 4 * output_shape.iter().map(|&size| size as u64).product::<u64>(),
            cameras: cameras.into_values().collect(),
        }
    }
}

impl fmt::Display for TileFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "tiles {}, {}\n", self.file, format_bytes(self.file_bytes))?;
        let side = self.side;
        let shape = self.output_shape;
        let bytes = format_bytes(self.output_bytes);
        let tiles = count(self.tiles as u64, "tile");
        writeln!(f, "{tiles} of {side} x {side}, rendered as {shape:?} ({bytes})\n")?;
        let mut table = Table::new(0, ["camera", "tiles", "columns", "rows"]);
        for camera in self.cameras.iter().take(MOST_ROWS) {
            let range = |axis: usize| format!("{} to {}", camera.low[axis], camera.high[axis] - 1);
            table.row([camera.camera.to_string(), camera.tiles.to_string(), range(0), range(1)]);
        }
        write!(f, "{table}{}", and_more(self.cameras.len()))
    }
}
