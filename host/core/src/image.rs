//! Whole images. They are cut into tiles for rendering, put together again, and written as PNG.
//!
//! An image does not depend on the cut.

mod channel;
#[cfg(test)]
mod tests;

use std::io::{self, Write};
use std::path::Path;

pub use channel::{ChannelImage, PNG_DEPTH_SCALE};
use png::{BitDepth, ColorType};
use rayon::prelude::*;

use crate::error::argument;
use crate::{RenderedTiles, Result, Tile, TileBatch, write_atomic};
use muslin_error::memory;

/// Side of the tiles that a whole image is cut into, in pixels. No image depends on it.
pub const TILE_SIDE: u32 = 64;
/// Pixels of one band: 100 MB of rendered values, enough to keep every device busy. An image of 4K is one band, and a
/// signal stops a larger one between two.
const BAND_PIXELS: u64 = 1 << 23;

/// An image of 8-bit red, green and blue.
///
/// A `Renderer` of the crate `organza` renders one.
///
/// ```
/// use organza_core::Image;
///
/// let image = Image::new(64, 48)?; // black
/// let folder = tempfile::tempdir().expect("a folder");
/// image.save_png(folder.path().join("black.png"))?;
/// assert_eq!(image.size(), [64, 48]);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    width: u32,
    height: u32,
    /// Pixels, row by row.
    pixels: Vec<[u8; 3]>,
    not_finite: u64,
}

impl Image {
    /// A black image.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn new(width: u32, height: u32) -> Result<Self> {
        let what = format!("an image of {width} x {height} pixels");
        let len = usize::try_from(u64::from(width) * u64::from(height)).unwrap_or(usize::MAX);
        Ok(Self { width, height, pixels: memory::zeros(len, &what)?, not_finite: 0 })
    }

    /// Fails if there is not enough memory to make and write an image. PNG's encoder may take as much as the image
    /// again.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn check_memory(width: u32, height: u32) -> Result<()> {
        let what = format!("an image of {width} x {height} pixels");
        let bytes = 3 * u64::from(width) * u64::from(height);
        memory::check(bytes, &what)?;
        Ok(memory::check(2 * bytes, &format!("{what} and writing it"))?)
    }

    /// An image with a photograph's pixels, row by row.
    ///
    /// # Panics
    /// Where there are not width times height pixels.
    pub fn from_pixels([width, height]: [u32; 2], pixels: &[[u8; 3]]) -> Self {
        assert_eq!(pixels.len(), width as usize * height as usize, "pixels of an image");
        Self { width, height, pixels: pixels.to_vec(), not_finite: 0 }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Red, green and blue of every pixel, row by row.
    pub fn pixels(&self) -> &[[u8; 3]] {
        &self.pixels
    }

    /// Number of pixels that were rendered as NaN or infinity: networks with huge weights can cause that.
    pub fn not_finite(&self) -> u64 {
        self.not_finite
    }

    /// Copies rendered tiles to their places in `batch`. Parts beyond the edge are cut off. The tiles' cameras are
    /// ignored.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) if the tiles do not belong to the batch.
    pub fn paste(&mut self, batch: &TileBatch, tiles: &RenderedTiles) -> Result<()> {
        let side = batch.side as usize;
        let values = batch.output_shape().iter().product::<usize>();
        if tiles.side != batch.side || tiles.data.len() != values {
            return argument(format!(
                "{} tiles of side {} do not belong to a batch of {} tiles of side {side}",
                tiles.count,
                tiles.side,
                batch.tiles.len()
            ));
        }
        visible_pixels(batch, self.size(), |tile, at, place| {
            let color = tiles.rgb(tile, at % side, at / side);
            self.not_finite += u64::from(!color.iter().all(|value| value.is_finite()));
            self.pixels[place] = color.map(to_8_bit);
        });
        Ok(())
    }

    /// Copies tiles in, of words `[K, S, S]` as the kernel `pixels` writes them. Parts outside the image are cut off.
    ///
    /// # Panics
    /// If there are fewer words than pixels in the tiles.
    pub fn paste_words(&mut self, side: u32, tiles: &[Tile], words: &[u32]) {
        let [width, height] = self.size();
        let side = side as usize;
        let tiles: Vec<_> = tiles.iter().zip(words.chunks(side * side)).collect();
        let paste = |(y, row): (usize, &mut [[u8; 3]])| {
            let mut not_finite = 0;
            for (tile, words) in &tiles {
                let [left, top] = tile.origin.map(i64::from);
                if !visible(top, side, height).contains(&(y as i64)) {
                    continue;
                }
                let columns = visible(left, side, width);
                let first = (y as i64 - top) as usize * side;
                let words = &words[first + (columns.start - left) as usize..];
                let pixels = &mut row[columns.start as usize..columns.end as usize];
                for (pixel, word) in pixels.iter_mut().zip(words) {
                    let [r, g, b, is_finite] = word.to_le_bytes();
                    *pixel = [r, g, b];
                    not_finite += u64::from(is_finite == 0);
                }
            }
            not_finite
        };
        let rows = self.pixels.par_chunks_mut((width as usize).max(1)).enumerate();
        self.not_finite += rows.map(paste).sum::<u64>();
    }

    /// Writes the image as PNG, atomically.
    ///
    /// # Errors
    /// [`Error::WriteFile`](crate::Error::WriteFile).
    pub fn save_png(&self, path: impl AsRef<Path>) -> Result<()> {
        write_atomic(path, |writer| writer.write_all(&self.encode_png()?))
    }

    /// The image as a PNG file.
    ///
    /// # Errors
    /// If the encoder fails. It writes to memory.
    pub fn encode_png(&self) -> io::Result<Vec<u8>> {
        png_of(self.pixels.as_flattened(), self.size(), ColorType::Rgb, BitDepth::Eight)
    }
}

/// A PNG file of pixels, row by row. Values of 16 bits have their higher byte first. It is made in memory: the encoder's errors of a
/// disk do not say what failed.
fn png_of(
    pixels: &[u8],
    [width, height]: [u32; 2],
    color: ColorType,
    depth: BitDepth,
) -> io::Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    let mut rows = writer.stream_writer_with_size(1 << 20)?;
    rows.write_all(pixels)?;
    rows.finish()?;
    writer.finish()?;
    Ok(file)
}

/// Rounds a value from 0 to 1 to the nearest of 256 levels. Values outside are clamped, and NaN is 0.
pub fn to_8_bit(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// Cuts an image of `width` x `height` pixels into tiles of one side, in batches of whole rows of tiles. So the
/// memory for rendering does not grow with the image's height.
///
/// # Errors
/// The same errors as [`TileBatch::cover`], for each batch.
pub fn bands(
    camera: usize,
    [width, height]: [u32; 2],
    side: u32,
) -> impl Iterator<Item = Result<TileBatch>> {
    // `cover` reports a wrong side.
    let side = side.max(1);
    let row = u64::from(width.div_ceil(side)) * u64::from(side) * u64::from(side);
    let rows = (BAND_PIXELS / row.max(1)).clamp(1, u64::from(height.div_ceil(side).max(1)));
    let step = rows as u32 * side;
    (0..height.max(1)).step_by(step as usize).map(move |top| {
        let mut batch = TileBatch::cover(camera, width, step.min(height - top), side)?;
        for tile in &mut batch.tiles {
            tile.origin[1] += top as i32;
        }
        Ok(batch)
    })
}

/// Calls `visit(tile, at, place)` for each pixel of a batch's tiles that is inside an image, row by row: with the
/// tile's index, the pixel's index in the tile, and its index in the image.
fn visible_pixels(
    batch: &TileBatch,
    [width, height]: [u32; 2],
    mut visit: impl FnMut(usize, usize, usize),
) {
    let side = batch.side as usize;
    for (index, tile) in batch.tiles.iter().enumerate() {
        let [left, top] = tile.origin.map(i64::from);
        for y in visible(top, side, height) {
            for x in visible(left, side, width) {
                let at = (y - top) as usize * side + (x - left) as usize;
                visit(index, at, y as usize * width as usize + x as usize);
            }
        }
    }
}

/// The coordinates inside an image of `size` pixels that a tile covers.
fn visible(origin: i64, side: usize, size: u32) -> std::ops::Range<i64> {
    origin.clamp(0, i64::from(size))..(origin + side as i64).clamp(0, i64::from(size))
}
