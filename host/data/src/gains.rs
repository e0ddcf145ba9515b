//! How much the exposures of photographs differ, measured at the points of their data set.

use std::ops::RangeInclusive;

use rayon::prelude::*;

use super::{Dataset, Frame, Point};
use organza_core::camera::median;

/// Levels that are neither black nor saturated.
const SEEN: RangeInclusive<u8> = 8..=247;
/// Fewer points say nothing about a photograph.
const MIN_RATIOS: usize = 50;
/// Largest distance of a pixel's logarithm from the median. Beyond it, something else is in front of the point.
const OTHER: f64 = 0.4;
/// Number of times that such pixels are left out, and the median is taken again.
const ROUNDS: usize = 3;

impl Dataset {
    /// The spread of exposures: the standard deviation of the logarithms of gains, over all photographs to train on and their
    /// channels. 0.1 is about 10%. `None` if fewer than two photographs show enough points with a color.
    ///
    /// The gain of a photograph is the median, over the points in its image, of the pixel divided by the point's color. Pixels
    /// that differ from the median by a factor of more than 1.5 do not count, as something may be in front of the point.
    pub fn exposure_spread(&self) -> Option<f64> {
        let frames: Vec<_> = self.train_frames().collect();
        let gains: Vec<_> =
            frames.par_iter().filter_map(|frame| log_gains(frame, &self.points)).collect();
        if gains.len() < 2 {
            return None;
        }
        let count = gains.len() as f64;
        let variance = |channel: usize| {
            let mean = gains.iter().map(|gain| gain[channel]).sum::<f64>() / count;
            gains.iter().map(|gain| (gain[channel] - mean).powi(2)).sum::<f64>() / count
        };
        Some(((0..3).map(variance).sum::<f64>() / 3.0).sqrt())
    }
}

/// The logarithms of a photograph's gains: red, green and blue.
fn log_gains(frame: &Frame, points: &[Point]) -> Option<[f64; 3]> {
    let image = &frame.image;
    let is_seen = |color: [u8; 3]| color.iter().all(|value| SEEN.contains(value));
    let ratio = |point: &Point| {
        let color = point.color.filter(|&color| is_seen(color))?;
        let [x, y, _] = frame.camera.project(point.position)?;
        let [x, y] = [x as u32, y as u32];
        let pixel = image.pixels()[(y * image.width() + x) as usize];
        let ratio = |channel: usize| f64::from(pixel[channel]) / f64::from(color[channel]);
        (image.is_valid(x, y) && is_seen(pixel)).then(|| [0, 1, 2].map(|at| ratio(at).ln()))
    };
    let ratios: Vec<_> = points.iter().filter_map(ratio).collect();
    let mut found = medians(&ratios)?;
    for _ in 0..ROUNDS {
        let is_near = |ratio: &[f64; 3]| (0..3).all(|at| (ratio[at] - found[at]).abs() < OTHER);
        let near: Vec<_> = ratios.iter().copied().filter(is_near).collect();
        found = medians(&near)?;
    }
    Some(found)
}

/// The median of each channel; `None` for too few values.
fn medians(ratios: &[[f64; 3]]) -> Option<[f64; 3]> {
    let of_channel = |channel: usize| median(ratios.iter().map(|ratio| ratio[channel]));
    (ratios.len() >= MIN_RATIOS).then(|| [0, 1, 2].map(of_channel))
}
