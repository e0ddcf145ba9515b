//! Rendered tiles as a picture.

use std::io::Cursor;

use image::{ImageFormat, Rgb, RgbImage, imageops};

/// Color between tiles.
const GAP: Rgb<u8> = Rgb([128, 128, 128]);
/// Distance of the panels of a [`difference`], in pixels.
const PANEL_GAP: u32 = 8;
/// Color of pixels that only one picture has.
const MARK: Rgb<u8> = Rgb([255, 0, 255]);

/// Tiles side by side. Each pixel is enlarged to a square, and there is an enlarged pixel of gray between tiles.
#[derive(Clone, Copy, Debug)]
pub struct Montage {
    /// Number of tiles.
    pub tiles: usize,
    /// Side of a tile, in pixels.
    pub side: usize,
    /// Number of tiles in a row.
    pub columns: usize,
    /// Side of an enlarged pixel, in pixels.
    pub scale: usize,
}

impl Montage {
    /// Number of pixels of all tiles, before enlarging.
    pub fn pixels(&self) -> usize {
        self.tiles * self.side * self.side
    }

    /// Draws `[K, 3, S, S]`.
    #[must_use]
    pub fn draw(&self, data: &[u8]) -> RgbImage {
        let pitch = self.side + 1;
        let area = self.side * self.side;
        let cells = |tiles: usize| ((tiles * pitch - 1) * self.scale) as u32;
        let columns = self.columns.min(self.tiles);
        let rows = self.tiles.div_ceil(self.columns);
        RgbImage::from_fn(cells(columns), cells(rows), |x, y| match self.locate([x, y]) {
            Some([tile, row, column]) => {
                let at = tile * 3 * area + row * self.side + column;
                Rgb([data[at], data[at + area], data[at + 2 * area]])
            }
            None => GAP,
        })
    }

    /// Tile, row and column of a pixel of the picture; `None` between tiles.
    fn locate(&self, place: [u32; 2]) -> Option<[usize; 3]> {
        let pitch = self.side + 1;
        let [x, y] = place.map(|place| place as usize / self.scale);
        let tile = y / pitch * self.columns + x / pitch;
        let row = y % pitch;
        let column = x % pitch;
        (tile < self.tiles && row < self.side && column < self.side).then_some([tile, row, column])
    }

    /// Describes a pixel of the picture in words.
    pub fn describe(&self, place: [u32; 2], channel: usize) -> String {
        let channel = ["red", "green", "blue"][channel];
        match self.locate(place) {
            Some([tile, row, column]) => {
                format!("tile {tile}, channel {channel}, row {row}, column {column}")
            }
            None => format!("{place:?} between the tiles, channel {channel}"),
        }
    }
}

/// What was expected, what was found, and the difference side by side. The difference is amplified until its largest value is
/// bright. Magenta marks pixels that only one picture has.
pub fn difference(expected: &RgbImage, found: &RgbImage) -> RgbImage {
    let width = expected.width().max(found.width());
    let height = expected.height().max(found.height());
    let apart = |x, y| {
        let e = expected.get_pixel_checked(x, y)?;
        let f = found.get_pixel_checked(x, y)?;
        Some([0, 1, 2].map(|channel| e.0[channel].abs_diff(f.0[channel])))
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let largest = places.filter_map(|(x, y)| apart(x, y)?.into_iter().max()).max();
    let factor = u8::MAX / largest.unwrap_or(0).max(1);
    let apart = RgbImage::from_fn(width, height, |x, y| {
        apart(x, y).map_or(MARK, |steps| Rgb(steps.map(|step| step * factor)))
    });
    let mut panels = RgbImage::from_pixel(3 * width + 2 * PANEL_GAP, height, Rgb([255; 3]));
    for (at, panel) in [expected, found, &apart].into_iter().enumerate() {
        imageops::replace(&mut panels, panel, at as i64 * i64::from(width + PANEL_GAP), 0);
    }
    panels
}

/// Encodes a picture as PNG.
pub fn encode(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).expect("memory can be written");
    bytes.into_inner()
}

/// Decodes a PNG.
pub fn decode(bytes: &[u8]) -> Result<RgbImage, String> {
    let picture = image::load_from_memory_with_format(bytes, ImageFormat::Png);
    picture.map(|picture| picture.to_rgb8()).map_err(|error| format!("no PNG: {error}"))
}
