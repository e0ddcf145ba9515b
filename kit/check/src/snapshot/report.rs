//! The output of a failure: expected, actual and difference as one PNG, in a folder that CI keeps.

use std::path::{Path, PathBuf};

use image::{Rgb, RgbImage, imageops};

use super::picture;
use super::tensors::Tensor;

/// Gap between panels, in pixels.
const GAP: u32 = 8;
/// Color of NaNs and infinities, and of values that only one side has.
const MARK: Rgb<u8> = Rgb([255, 0, 255]);
/// Width to which small panels are enlarged, approximately, in pixels.
const WIDTH: u32 = 256;

/// Three pictures: expected, actual and difference.
#[derive(Clone, Debug)]
pub struct Panels {
    /// The pictures, left to right.
    pub pictures: Box<[RgbImage; 3]>,
    /// Factor of the difference.
    pub amplification: u32,
}

/// `snapshot-failures` in cargo's target folder.
///
/// # Panics
/// If the test is not run by cargo.
#[must_use]
pub fn folder() -> PathBuf {
    let test = std::env::current_exe().expect("a test has a program");
    // target/debug/deps/test
    test.ancestors().nth(3).expect("it lies in cargo's target folder").join("snapshot-failures")
}

/// Path for the picture of a failure.
pub fn path(name: &str, backend: &str) -> PathBuf {
    let backend = backend.replace(' ', "-");
    folder().join(format!("{name}-{backend}.png"))
}

/// Writes the panels as one picture.
pub fn save(panels: &Panels, path: &Path) {
    let [expected, actual, difference] = &*panels.pictures;
    let width: u32 = panels.pictures.iter().map(RgbImage::width).sum();
    let height = panels.pictures.iter().map(RgbImage::height).max().unwrap_or(0);
    let mut all = RgbImage::from_pixel(width + 2 * GAP, height, Rgb([255; 3]));
    let mut left = 0;
    for panel in [expected, actual, difference] {
        imageops::replace(&mut all, panel, i64::from(left), 0);
        left += panel.width() + GAP;
    }
    let written = std::fs::create_dir_all(folder())
        .and_then(|()| std::fs::write(path, picture::encode(&all)));
    written.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}

/// Empty panels, for records that cannot be shown.
pub fn no_panels() -> Panels {
    let panel = RgbImage::from_pixel(16, 16, MARK);
    Panels { pictures: Box::new([panel.clone(), panel.clone(), panel]), amplification: 1 }
}

/// The panels for two pictures.
pub fn picture_panels(expected: &RgbImage, actual: &RgbImage) -> Panels {
    let size = (expected.width().max(actual.width()), expected.height().max(actual.height()));
    let apart = |x, y| {
        let e = expected.get_pixel_checked(x, y)?;
        let a = actual.get_pixel_checked(x, y)?;
        Some([0, 1, 2].map(|channel| e.0[channel].abs_diff(a.0[channel])))
    };
    let places = || (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y)));
    let largest = places().filter_map(|(x, y)| apart(x, y)?.into_iter().max()).max();
    let amplification = amplification(f64::from(largest.unwrap_or(0)) / 255.0);
    let difference = RgbImage::from_fn(size.0, size.1, |x, y| {
        apart(x, y).map_or(MARK, |steps| {
            Rgb(steps.map(|steps| (u32::from(steps) * amplification).min(255) as u8))
        })
    });
    Panels { pictures: Box::new([expected.clone(), actual.clone(), difference]), amplification }
}

/// The panels for two tensors: tiles in their colors, others in gray from the smallest to the largest value.
pub fn tensor_panels(expected: Option<&Tensor>, actual: Option<&Tensor>) -> Panels {
    let Some(shown) = expected.or(actual) else { return no_panels() };
    let finite = || {
        let all = expected.into_iter().chain(actual).flat_map(|tensor| &tensor.values);
        all.copied().filter(|value| value.is_finite())
    };
    let (low, high) = match is_tiles(&shown.shape) {
        true => (0.0, 1.0),
        false => {
            (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max))
        }
    };
    let range = if high > low { high - low } else { 1.0 };
    let value = |tensor: Option<&Tensor>, index: usize| tensor?.values.get(index).copied();
    let apart = |index| Some((value(actual, index)? - value(expected, index)?).abs() / range);
    let largest = (0..shown.values.len()).filter_map(apart).filter(|apart| apart.is_finite());
    let amplification = amplification(largest.fold(0.0, f64::max));
    let level = |tensor| move |index| Some((value(tensor, index)? - low) / range);
    let pictures = [
        draw(&expected.unwrap_or(shown).shape, level(expected)),
        draw(&actual.unwrap_or(shown).shape, level(actual)),
        draw(&shown.shape, |index| Some(apart(index)? * f64::from(amplification))),
    ];
    Panels { pictures: Box::new(pictures), amplification }
}

/// The largest power of two that keeps a difference in range.
fn amplification(largest: f64) -> u32 {
    if largest <= 0.0 {
        return 1;
    }
    (1.0 / largest).log2().floor().clamp(0.0, 20.0).exp2() as u32
}

fn is_tiles(shape: &[usize]) -> bool {
    matches!(shape, [_, 3, height, width] if height == width)
}

/// Draws a tensor: tiles one below the other, other tensors with a row of pixels for each row.
fn draw(shape: &[usize], level: impl Fn(usize) -> Option<f64>) -> RgbImage {
    let width = shape.last().copied().unwrap_or(1).max(1);
    let values: usize = shape.iter().product();
    let planes = if is_tiles(shape) { 3 } else { 1 };
    let height = (values / width / planes).max(1);
    let scale = (WIDTH / width as u32).clamp(1, 16);
    RgbImage::from_fn(width as u32 * scale, height as u32 * scale, |x, y| {
        let [column, row] = [x, y].map(|place| (place / scale) as usize);
        let channels = match planes {
            3 => {
                let tile = row / width;
                let row = row % width;
                [0, 1, 2].map(|channel| ((tile * 3 + channel) * width + row) * width + column)
            }
            _ => [row * width + column; 3],
        };
        match channels.map(&level) {
            [Some(r), Some(g), Some(b)] if (r + g + b).is_finite() => {
                Rgb([r, g, b].map(|level| (level.clamp(0.0, 1.0) * 255.0).round() as u8))
            }
            _ => MARK,
        }
    })
}
