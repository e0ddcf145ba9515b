//! Image metrics in f64, as papers of the field define them: PSNR and SSIM.
//!
//! All take RGB pixels row by row, with colors from 0 to 1. A mask marks the valid pixels; without one, all are
//! valid.

#[cfg(test)]
mod tests;

use rayon::prelude::*;

/// Pixels of SSIM's window on each side of its center.
pub const WINDOW_RADIUS: usize = 5;

/// Side of SSIM's window, in pixels.
pub const WINDOW: usize = 2 * WINDOW_RADIUS + 1;

/// Standard deviation of the window's weights, in pixels.
const SIGMA: f64 = 1.5;

/// `(K1 L)^2` with K1 = 0.01 and colors in 0 to L = 1.
const C1: f64 = 1e-4;

/// `(K2 L)^2` with K2 = 0.03.
const C2: f64 = 9e-4;

/// The weights of SSIM's window along one axis: a Gaussian of sigma 1.5 pixels at 11 pixels, of sum 1.
pub fn window() -> [f64; WINDOW] {
    let weight = |at: usize| {
        let distance = at as f64 - WINDOW_RADIUS as f64;
        (-0.5 * (distance / SIGMA).powi(2)).exp()
    };
    let weights: [f64; WINDOW] = std::array::from_fn(weight);
    let sum: f64 = weights.iter().sum();
    weights.map(|weight| weight / sum)
}

/// The peak signal-to-noise ratio in decibels, `-10 log10(MSE)`. The mean squared error is over all valid pixels and
/// the three channels.
///
/// Infinite ([`f64::INFINITY`]) for equal images; `None` if no pixel is valid.
///
/// ```
/// use organza_core::metrics::{psnr, ssim};
///
/// let (image, truth) = (vec![[0.5; 3]; 16 * 16], vec![[0.6; 3]; 16 * 16]);
/// assert!((psnr(&image, &truth, None).unwrap() - 20.0).abs() < 1e-5);
/// assert_eq!(ssim([16, 16], &image, &image, None), Some(1.0));
/// ```
///
/// # Panics
/// If `image`, `truth` and `valid` have different lengths.
pub fn psnr(image: &[[f32; 3]], truth: &[[f32; 3]], valid: Option<&[bool]>) -> Option<f64> {
    check_lengths(image, truth, valid);
    let mut sum = 0.0;
    let mut pixels = 0_u64;
    for (at, (x, y)) in image.iter().zip(truth).enumerate() {
        if valid.is_none_or(|valid| valid[at]) {
            sum +=
                x.iter().zip(y).map(|(&x, &y)| (f64::from(x) - f64::from(y)).powi(2)).sum::<f64>();
            pixels += 1;
        }
    }
    (pixels > 0).then(|| psnr_of(sum / (3 * pixels) as f64))
}

/// The peak signal-to-noise ratio in decibels of a mean squared error; infinite for 0.
pub fn psnr_of(mean_squared_error: f64) -> f64 {
    // -10 log10(0) is infinite, too; -0.0 for an error of 1 is not wanted
    -10.0 * mean_squared_error.log10() + 0.0
}

/// The structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004) of two images of `[width, height]`: the mean
/// over the three channels and over all windows of 11 x 11 pixels that lie entirely in the image.
///
/// ```text
/// SSIM = (2 mean(x) mean(y) + C1) (2 cov(x, y) + C2) / ((mean(x)^2 + mean(y)^2 + C1) (var(x) + var(y) + C2))
/// ```
///
/// with Gaussian weights of sigma 1.5, C1 = 0.01^2 and C2 = 0.03^2. It equals scikit-image's
/// `structural_similarity(x, y, data_range=1, channel_axis=-1, gaussian_weights=True, sigma=1.5,
/// use_sample_covariance=False)` of f64 arrays.
///
/// Windows that touch an invalid pixel are left out. `None` if no window remains, as for images less than 11 pixels
/// wide or high.
///
/// # Panics
/// If `image`, `truth` and `valid` do not have width x height elements.
pub fn ssim(
    [width, height]: [usize; 2],
    image: &[[f32; 3]],
    truth: &[[f32; 3]],
    valid: Option<&[bool]>,
) -> Option<f64> {
    assert_eq!(image.len(), width * height, "pixels of an image of {width} x {height}");
    check_lengths(image, truth, valid);
    if width < WINDOW || height < WINDOW {
        return None;
    }
    let weights = window();
    let rows: Vec<(f64, u64)> = (0..=height - WINDOW)
        .into_par_iter()
        .map(|top| {
            let part = top * width..(top + WINDOW) * width;
            let strip = Strip {
                width,
                image: &image[part.clone()],
                truth: &truth[part.clone()],
                valid: valid.map(|valid| &valid[part]),
            };
            strip.similarity(&weights)
        })
        .collect();
    // in row order, so the sum does not depend on the number of threads
    let (sum, windows) = rows.iter().fold((0.0, 0), |(sum, n), row| (sum + row.0, n + row.1));
    (windows > 0).then(|| sum / (3 * windows) as f64)
}

fn check_lengths(image: &[[f32; 3]], truth: &[[f32; 3]], valid: Option<&[bool]>) {
    assert_eq!(image.len(), truth.len(), "pixels of an image and of what it is compared with");
    if let Some(valid) = valid {
        assert_eq!(image.len(), valid.len(), "pixels of an image and of its mask");
    }
}

/// Eleven rows of both images: one row of windows.
struct Strip<'a> {
    width: usize,
    image: &'a [[f32; 3]],
    truth: &'a [[f32; 3]],
    valid: Option<&'a [bool]>,
}

/// Weighted sums of x, y, x^2, y^2 and xy.
type Moments = [f64; 5];

impl Strip<'_> {
    /// The sum of SSIM over the valid windows and the channels, and the number of valid windows.
    fn similarity(&self, weights: &[f64; WINDOW]) -> (f64, u64) {
        let valid = self.windows();
        let mut total = 0.0;
        for channel in 0..3 {
            for (window, &is_valid) in self.columns(channel, weights).windows(WINDOW).zip(&valid) {
                if is_valid {
                    let mut sums = Moments::default();
                    for (column, &weight) in window.iter().zip(weights) {
                        add(&mut sums, column, weight);
                    }
                    total += similarity(sums);
                }
            }
        }
        (total, valid.iter().map(|&is_valid| u64::from(is_valid)).sum())
    }

    /// The moments of each column of the strip.
    fn columns(&self, channel: usize, weights: &[f64; WINDOW]) -> Vec<Moments> {
        let mut columns = vec![Moments::default(); self.width];
        let rows = self.image.chunks_exact(self.width).zip(self.truth.chunks_exact(self.width));
        for ((image, truth), &weight) in rows.zip(weights) {
            for ((column, x), y) in columns.iter_mut().zip(image).zip(truth) {
                let x = f64::from(x[channel]);
                let y = f64::from(y[channel]);
                add(column, &[x, y, x * x, y * y, x * y], weight);
            }
        }
        columns
    }

    /// Whether all pixels of each window are valid.
    fn windows(&self) -> Vec<bool> {
        let Some(valid) = self.valid else { return vec![true; self.width + 1 - WINDOW] };
        let column = |x: usize| valid[x..].iter().step_by(self.width).all(|&valid| valid);
        let columns: Vec<bool> = (0..self.width).map(column).collect();
        columns.windows(WINDOW).map(|window| window.iter().all(|&valid| valid)).collect()
    }
}

fn add(sums: &mut Moments, values: &Moments, weight: f64) {
    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
}

/// SSIM of one window in one channel.
fn similarity([x, y, xx, yy, xy]: Moments) -> f64 {
    let variances = xx - x * x + (yy - y * y);
    let covariance = xy - x * y;
    let luminance = (2.0 * x * y + C1) / (x * x + y * y + C1);
    luminance * (2.0 * covariance + C2) / (variances + C2)
}

/// Factor of the difference in error pictures.
pub const ERROR_FACTOR: u32 = 5;

/// The mean absolute difference of the channels times [`ERROR_FACTOR`]; 0 where the photograph has no valid pixel.
pub fn error_levels(truth: &[[u8; 3]], rendered: &[[u8; 3]], valid: Option<&[bool]>) -> Vec<u8> {
    let level = |(at, (a, b)): (usize, (&[u8; 3], &[u8; 3]))| {
        let sum: u32 = a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
        let is_valid = valid.is_none_or(|valid| valid[at]);
        if is_valid { ((sum * ERROR_FACTOR + 1) / 3).min(255) as u8 } else { 0 }
    };
    truth.iter().zip(rendered).enumerate().map(level).collect()
}
