//! Square tiles of image planes, the unit of batched rendering.

#[cfg(test)]
mod tests;

use std::path::Path;

use serde::Serialize;
use serde_json::Value;

use crate::error::{Error, IN_MEMORY, Result, argument, format_bytes, refuse};
use crate::input::{integer, kind, read_json};
use crate::{Camera, write_atomic};

/// Largest side of a tile, in pixels.
pub const MAX_TILE_SIDE: u32 = 4096;
/// Largest distance of a tile's origin from pixel (0, 0), in pixels per axis.
pub const MAX_TILE_ORIGIN: i32 = 1_000_000;
/// Upper limit for the number of output values: kernels address them with 32 bits.
const MAX_OUTPUT_VALUES: u64 = 1 << 31;
/// Red, green, blue.
const CHANNELS: u64 = 3;

/// A square part of one camera's image plane. It may extend beyond the image's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct Tile {
    /// Index of the camera.
    pub camera: usize,
    /// Column and row of the tile's upper left pixel.
    pub origin: [i32; 2],
}

/// Tiles of one size, rendered together into `[K, 3, S, S]`.
///
/// ```
/// use organza_core::{Tile, TileBatch};
///
/// // tiles may be anywhere in the images of any cameras
/// let tiles = vec![Tile { camera: 0, origin: [96, 32] }, Tile { camera: 3, origin: [0, 0] }];
/// let batch = TileBatch { side: 64, tiles };
/// assert_eq!(batch.output_shape(), [2, 3, 64, 64]);
///
/// // or cover the whole image of a camera
/// let batch = TileBatch::cover(0, 640, 480, 64)?;
/// assert_eq!(batch.tiles.len(), 10 * 8);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TileBatch {
    /// S, in pixels.
    pub side: u32,
    /// The K tiles, in the order of the output.
    pub tiles: Vec<Tile>,
}

impl TileBatch {
    /// Reads a tiles file: `{"side": S, "tiles": [{"camera": index, "origin": [x, y]}, ...]}`.
    ///
    /// [`Self::validate`] checks that the cameras exist.
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::BadJson`]; [`Error::Invalid`] if the side, the number of tiles or the size of
    /// the output is out of range, or for the first element that is no tile.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        Self::parse(&read_json(path)?, path)
    }

    /// [`Self::load`] from parsed JSON. Errors name `origin`.
    pub fn parse(file: &Value, origin: &Path) -> Result<Self> {
        Self::from_json(file).map_err(|error| error.in_file(origin))
    }

    fn from_json(file: &Value) -> Result<Self> {
        let Some(side) = file.get("side") else { return refuse("`side` is missing") };
        let Some(side) = integer(side).and_then(|side| u32::try_from(side).ok()) else {
            return refuse(side_range(&side.to_string()));
        };
        // Checked before the tiles: a wrong side affects all of them.
        check_side(side)?;
        let Some(tiles) = file.get("tiles") else { return refuse("`tiles` is missing") };
        let Some(tiles) = tiles.as_array() else {
            return refuse(format!("`tiles` is {}, expected an array", kind(tiles)));
        };
        let parse = |(index, tile): (usize, &Value)| {
            parse_tile(tile).map_err(|reason| tile_error(index, reason))
        };
        let tiles = tiles.iter().enumerate().map(parse).collect::<Result<_>>()?;
        let batch = Self { side, tiles };
        batch.check()?;
        Ok(batch)
    }

    /// Writes a file that [`Self::load`] reads, atomically.
    ///
    /// # Errors
    /// [`Error::WriteFile`]; [`Error::Invalid`] as [`Self::load`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        self.check()?;
        write_atomic(path, |writer| {
            serde_json::to_writer_pretty(&mut *writer, self)?;
            writer.write_all(b"\n")
        })
    }

    /// Checks the batch against its cameras.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the side, the number of tiles or the size of the output is out of range, or
    /// for the first tile whose origin is out of range or whose camera does not exist.
    pub fn validate(&self, cameras: &[Camera]) -> Result<()> {
        self.check()?;
        let count = cameras.len();
        match self.tiles.iter().position(|tile| tile.camera >= count) {
            Some(index) => {
                let camera = self.tiles[index].camera;
                let reason = match count {
                    0 => format!("asks for camera {camera}, but there are no cameras"),
                    _ => format!("asks for camera {camera}, but cameras are 0 to {}", count - 1),
                };
                Err(tile_error(index, reason))
            }
            None => Ok(()),
        }
    }

    /// The tiles that cover an image of `width` x `height` pixels, row by row. If `side` does not divide the image,
    /// the last column and row extend beyond its edge.
    ///
    /// # Errors
    /// [`Error::Argument`] for an image without pixels; [`Error::Invalid`] if the side or the size of the output is
    /// out of range, or if an origin is out of range.
    pub fn cover(camera: usize, width: u32, height: u32, side: u32) -> Result<Self> {
        if width == 0 || height == 0 {
            return argument(format!("an image of {width} x {height} pixels has no tiles"));
        }
        check_side(side)?;
        let columns = width.div_ceil(side);
        let rows = height.div_ceil(side);
        // Check before anything is allocated: tiles of one pixel are as many as the pixels.
        check_output(u64::from(columns) * u64::from(rows), side)?;
        let corner =
            |cell: u32| i32::try_from(u64::from(cell) * u64::from(side)).unwrap_or(i32::MAX);
        let tiles = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .map(|(row, column)| Tile { camera, origin: [corner(column), corner(row)] })
            .collect();
        let batch = Self { side, tiles };
        batch.check()?;
        Ok(batch)
    }

    /// The shape of the output, `[K, 3, S, S]`.
    pub fn output_shape(&self) -> [usize; 4] {
        let side = self.side as usize;
        [self.tiles.len(), CHANNELS as usize, side, side]
    }

    /// Checks everything but the cameras.
    fn check(&self) -> Result<()> {
        check_side(self.side)?;
        if self.tiles.is_empty() {
            return refuse("there are no tiles; there is nothing to render");
        }
        check_output(self.tiles.len() as u64, self.side)?;
        for (index, tile) in self.tiles.iter().enumerate() {
            if tile.origin.iter().any(|value| value.unsigned_abs() > MAX_TILE_ORIGIN as u32) {
                return Err(tile_error(index, origin_range(&format!("{:?}", tile.origin))));
            }
        }
        Ok(())
    }
}

fn check_side(side: u32) -> Result<()> {
    if (1..=MAX_TILE_SIDE).contains(&side) {
        return Ok(());
    }
    refuse(side_range(&side.to_string()))
}

/// Largest number of tiles in one batch, for a side that is not 0.
pub fn max_tiles(side: u32) -> u64 {
    (MAX_OUTPUT_VALUES - 1) / (CHANNELS * u64::from(side) * u64::from(side))
}

fn check_output(tiles: u64, side: u32) -> Result<()> {
    let max = max_tiles(side);
    if tiles <= max {
        return Ok(());
    }
    let per_tile = CHANNELS * u64::from(side) * u64::from(side);
    let bytes = format_bytes(tiles.saturating_mul(per_tile).saturating_mul(4));
    let limit = format_bytes(4 * MAX_OUTPUT_VALUES);
    refuse(format!(
        "{tiles} tiles of side {side} make an output of {bytes}; it must be less than {limit}: \
         render at most {max} such tiles at once"
    ))
}

fn side_range(found: &str) -> String {
    format!("`side` is {found}, expected a whole number of 1 to {MAX_TILE_SIDE} pixels")
}

fn origin_range(found: &str) -> String {
    format!(
        "`origin` is {found}, expected two whole numbers of -{MAX_TILE_ORIGIN} to \
         {MAX_TILE_ORIGIN} pixels, [x, y]"
    )
}

fn tile_error(tile: usize, reason: String) -> Error {
    Error::Invalid { origin: IN_MEMORY.into(), reason: format!("tile {tile}: {reason}") }
}

fn parse_tile(tile: &Value) -> Result<Tile, String> {
    let Some(object) = tile.as_object() else {
        return Err(format!("is {}, expected an object with camera and origin", kind(tile)));
    };
    let camera = object.get("camera").ok_or("`camera` is missing")?;
    let camera = integer(camera)
        .and_then(|camera| usize::try_from(camera).ok())
        .ok_or_else(|| format!("`camera` is {camera}, expected the index of a frame, from 0"))?;
    let origin = object.get("origin").ok_or("`origin` is missing")?;
    let coordinate = |value| integer(value).and_then(|value| i32::try_from(value).ok());
    let numbers: Option<Vec<i32>> =
        origin.as_array().and_then(|values| values.iter().map(coordinate).collect());
    let numbers = numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| origin_range(&origin.to_string()))?;
    Ok(Tile { camera, origin: numbers })
}
