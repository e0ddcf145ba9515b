//! The targets of a step's tiles, cut from photographs on the device. A pixel is a word: red in its lowest byte, then green, blue, and 255
//! where the pixel is valid.

use glam::Vec3;

use muslin::prelude::*;

/// The largest factor by which images are smaller than their photographs.
pub const MAX_FACTOR: u32 = 16;

/// Parameters of [`target_tiles`].
#[params]
pub struct TargetParams {
    /// S, in pixels.
    pub side: u32,
    /// Factor by which the images are smaller than the photographs, at most [`MAX_FACTOR`].
    pub factor: u32,
    /// `1 / factor^2`
    pub share: f32,
}

/// A tile of a photograph.
#[params]
pub struct TargetTile {
    /// Where the photograph begins in `pixels`.
    pub first: u32,
    /// Width of the photograph, in pixels.
    pub width: u32,
    /// Height of the photograph, in pixels.
    pub height: u32,
    /// Column of the tile's first pixel in the image, which is smaller than the photograph.
    pub x: i32,
    /// Row of the tile's first pixel in the image.
    pub y: i32,
    /// Index of the tile among all K.
    pub place: u32,
}

/// Cuts tiles: pixels along x and y, tiles along z. A pixel is the mean of a square of `factor` x `factor` pixels of the photograph. It is valid
/// if it lies in the image and all of the square are valid; otherwise it is 0.
///
/// `level [256]` is `v / 255`, which GPUs round differently. `image [K, 3, S, S]`, `valid [K, S, S]`: 1 or 0.
#[kernel(threads(8, 8), over(params.side, params.side, tile.len()), iterations = MAX_FACTOR * (MAX_FACTOR + 1))]
pub fn target_tiles(
    id: Invocation,
    params: &TargetParams,
    tile: Read<TargetTile>,
    level: Read<f32>,
    pixels: Read<u32>,
    image: Write<f32>,
    valid: Write<f32>,
) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let tile = tile.read(id.workgroup.z);
        let factor = params.factor;
        let x = tile.x + place.x as i32;
        let y = tile.y + place.y as i32;
        let right = (tile.width / factor) as i32;
        let bottom = (tile.height / factor) as i32;
        let mut is_valid = x >= 0 && y >= 0 && x < right && y < bottom;
        let mut sum = Vec3::ZERO;
        if is_valid {
            let first = tile.first + (y as u32 * tile.width + x as u32) * factor;
            let mut row = 0;
            while row < factor {
                let mut column = 0;
                while column < factor {
                    let word = pixels.read(first + row * tile.width + column);
                    let red = level.read(word & 255);
                    let green = level.read(word >> 8 & 255);
                    let blue = level.read(word >> 16 & 255);
                    sum += Vec3::new(red, green, blue);
                    is_valid = is_valid && word >> 24 != 0;
                    column += 1;
                }
                row += 1;
            }
        }
        let mean = if is_valid { sum * params.share } else { Vec3::ZERO };
        let area = params.side * params.side;
        let at = place.y * params.side + place.x;
        let plane = tile.place * 3 * area + at;
        image.write(plane, mean.x);
        image.write(plane + area, mean.y);
        image.write(plane + 2 * area, mean.z);
        valid.write(tile.place * area + at, if is_valid { 1.0 } else { 0.0 });
    }
}
