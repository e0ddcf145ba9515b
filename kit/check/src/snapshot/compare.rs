//! Compares tensors and pictures with the accepted ones, and describes the difference.

use image::RgbImage;

use super::picture::Montage;
use super::tensors::{Tensor, Tensors};

/// The error allowed for a value of a tensor: `absolute + relative * |expected|`.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    /// Absolute part, in the tensor's own unit.
    pub absolute: f64,
    /// Part relative to the expected value.
    pub relative: f64,
}

impl Tolerance {
    fn allows(&self, tensor: &Tensor, expected: f64, actual: f64) -> bool {
        // NaN is never right. An infinity is right only where it is expected.
        let allowed =
            if tensor.exact { 0.0 } else { self.absolute + self.relative * expected.abs() };
        actual == expected || (expected.is_finite() && (actual - expected).abs() <= allowed)
    }

    /// Compares tensors with the accepted ones, and describes the first difference. Names, their order and shapes must be the same.
    pub fn compare(&self, expected: &Tensors, actual: &Tensors) -> Result<(), String> {
        let accepted = heads(expected);
        let found = heads(actual);
        if let Some(at) =
            (0..accepted.len().max(found.len())).find(|&i| accepted.get(i) != found.get(i))
        {
            let of = |heads: &[String]| heads.get(at).cloned().unwrap_or("nothing".to_owned());
            return Err(format!("shapes differ: {} for {}", of(&found), of(&accepted)));
        }
        let pairs = expected.0.iter().zip(&actual.0);
        let differing = pairs.filter_map(|(e, a)| Some((&e.name, self.worst(e, a)?)));
        let mut differing = differing.collect::<Vec<_>>().into_iter();
        // Report the first one: tensors are in the order of the stages, and later differences follow from it.
        let Some((_, mut message)) = differing.next() else { return Ok(()) };
        let others: Vec<String> = differing.map(|(name, _)| format!("`{name}`")).collect();
        if !others.is_empty() {
            message += &format!("; differing after it: {}", others.join(", "));
        }
        Err(message)
    }

    fn worst(&self, expected: &Tensor, actual: &Tensor) -> Option<String> {
        let pairs = expected.values.iter().copied().zip(actual.values.iter().copied());
        let beyond = pairs.enumerate().filter(|(_, (e, a))| !self.allows(expected, *e, *a));
        let beyond: Vec<_> = beyond.map(|(index, (e, a))| (apart(e, a), index, e, a)).collect();
        let (_, index, e, a) = *beyond.iter().max_by(|x, y| x.0.total_cmp(&y.0))?;
        let allowed = match expected.exact {
            true => "it must be equal".to_owned(),
            false => format!("allowed is {:.1e} + {:.1e} |expected|", self.absolute, self.relative),
        };
        Some(format!(
            "`{}` {:?} is {:.3e} apart at {}: {a} for {e}; {allowed}; {} of {} values are beyond",
            expected.name,
            expected.shape,
            apart(e, a),
            place(&expected.shape, index),
            beyond.len(),
            expected.values.len(),
        ))
    }
}

/// The difference of two values; infinite if it is NaN.
fn apart(e: f64, a: f64) -> f64 {
    if (a - e).is_nan() { f64::INFINITY } else { (a - e).abs() }
}

/// Name and shape of each tensor.
fn heads(tensors: &Tensors) -> Vec<String> {
    let head = |tensor: &Tensor| format!("{} {:?}", tensor.name, tensor.shape);
    tensors.0.iter().map(head).collect()
}

/// Describes an index: tile, channel, row and column if the shape is one of tiles.
fn place(shape: &[usize], mut index: usize) -> String {
    let mut at = vec![0; shape.len()];
    for (place, &size) in at.iter_mut().zip(shape).rev() {
        *place = index % size;
        index /= size;
    }
    match (shape, at.as_slice()) {
        ([_, 3, height, width], &[tile, channel, row, column]) if height == width => {
            let channel = ["red", "green", "blue"][channel];
            format!("tile {tile}, channel {channel}, row {row}, column {column}")
        }
        _ => format!("{at:?}"),
    }
}

/// Allowed difference of every channel of a picture, in steps of 255: a value near the middle of two steps is rounded
/// to either.
pub const STEPS: u8 = 1;
/// At the edge of a Gaussian's support the falloff jumps from 1/255 to 0, and rounding decides on which side a pixel
/// lies. One pixel among this many may therefore differ by one step more.
pub const EDGE_PIXELS: usize = 500;
/// Allowed difference of such a pixel, in steps.
pub const EDGE_STEPS: u8 = STEPS + 1;

/// Compares a picture with the accepted one.
pub fn compare_pictures(
    montage: &Montage,
    expected: &RgbImage,
    actual: &RgbImage,
) -> Result<(), String> {
    if expected.dimensions() != actual.dimensions() {
        let found = actual.dimensions();
        let accepted = expected.dimensions();
        return Err(format!("sizes differ: {found:?} pixels for {accepted:?}"));
    }
    let mut beyond = 0;
    let mut largest = 0;
    let mut at = (0, 0, 0);
    for ((x, y, e), a) in expected.enumerate_pixels().zip(actual.pixels()) {
        let apart = [0, 1, 2].map(|channel| e.0[channel].abs_diff(a.0[channel]));
        beyond += usize::from(apart.iter().any(|&steps| steps > STEPS));
        for (channel, steps) in apart.into_iter().enumerate() {
            if steps > largest {
                largest = steps;
                at = (x, y, channel);
            }
        }
    }
    // Count each enlarged pixel once.
    let beyond = beyond / (montage.scale * montage.scale);
    let pixels = montage.pixels();
    if largest <= STEPS || (largest <= EDGE_STEPS && beyond * EDGE_PIXELS <= pixels) {
        return Ok(());
    }
    let (x, y, channel) = at;
    Err(format!(
        "{largest} of 255 steps apart at {}: {} for {}; allowed is {STEPS}, and {EDGE_STEPS} for one pixel in \
         {EDGE_PIXELS}; {beyond} of {pixels} pixels are beyond {STEPS}",
        montage.describe([x, y], channel),
        actual.get_pixel(x, y).0[channel],
        expected.get_pixel(x, y).0[channel],
    ))
}
