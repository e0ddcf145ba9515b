//! Cases of `ssim_rows`, `ssim_columns` and `ssim_rows_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::ssim::{
    C1, C2, MOMENTS, SLOPES, SsimColumnsInputs, SsimParams, SsimRowsBackwardInputs, SsimRowsInputs,
    WINDOW,
};

use super::exact::numeric::{Dual, gradient};
use super::exact::ssim::{dissimilarity, tap_sum, weighted_sum, window};
use super::loss::{TILES, Terms, sets};

/// Tile's first pixel, row and column of a pixel.
fn place(pixel: usize, side: usize) -> [usize; 3] {
    [pixel / (side * side) * side * side, pixel / side % side, pixel % side]
}

/// The terms that a pixel adds to each sum, in f64.
fn moment([d, s]: [&[Vec4]; 2], pixel: usize, part: usize, channel: usize) -> f64 {
    let [d, s] = [d, s].map(|values| f64::from(values[pixel][channel]));
    [d, s, d * d, s * s][part]
}

case!(pub SsimRows(SsimRowsInputs));

impl Parity for SsimRows {
    const KERNEL: &'static str = "ssim_rows";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of eleven products and their sum, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Terms { difference, sum } = Terms::new(side, fill, random);
            Self(SsimRowsInputs {
                params: SsimParams { side },
                window: window().to_vec(),
                moments: unwritten(MOMENTS as usize * sum.len()),
                difference,
                sum,
            })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, TILES])
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let pixel = index / 16;
        let part = index / 4 % 4;
        let channel = index % 4;
        let side = self.params.side as usize;
        let [tile, row, column] = place(pixel, side);
        let size = |tap| {
            moment([&self.difference, &self.sum], tile + row * side + tap, part, channel).abs()
        };
        let floor = 2.0 * f64::from(WINDOW) * f64::from(TINY);
        Bound { scale: tap_sum(column, side, size), floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let side = self.params.side as usize;
        let pixel = index / 16;
        let part = index / 4 % 4;
        let channel = index % 4;
        let [tile, row, column] = place(pixel, side);
        let value =
            |tap| moment([&self.difference, &self.sum], tile + row * side + tap, part, channel);
        Some(weighted_sum(column, (0..side).map(value)))
    }
}

case!(pub SsimColumns(SsimColumnsInputs));

impl SsimColumns {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let Terms { difference, sum } = Terms::new(side, fill, random);
        let width = side as usize;
        let vector = |index: usize| {
            let pixel = index / MOMENTS as usize;
            let part = index % MOMENTS as usize;
            let [tile, row, column] = place(pixel, width);
            let sum = |channel: usize| {
                let value =
                    |tap| moment([&difference, &sum], tile + row * width + tap, part, channel);
                tap_sum(column, width, value) as f32
            };
            Vec4::from_array([0, 1, 2, 3].map(sum))
        };
        let moments = (0..MOMENTS as usize * sum.len()).map(vector).collect();
        Self(SsimColumnsInputs {
            params: SsimParams { side },
            window: window().to_vec(),
            dissimilarity: unwritten(sum.len()),
            slopes: unwritten(SLOPES as usize * sum.len()),
            difference,
            moments,
        })
    }

    /// A window's sums of d, s, d^2, s^2 and the mask in f64, and of their terms' sizes.
    fn window_sums(&self, pixel: usize, channel: usize) -> [[f64; 5]; 2] {
        let side = self.params.side as usize;
        let [tile, row, column] = place(pixel, side);
        let of = |sum: usize| {
            let (part, channel) = if sum == 4 { (0, 3) } else { (sum, channel) };
            move |tap: usize| {
                let at = (tile + tap * side + column) * MOMENTS as usize + part;
                f64::from(self.moments[at][channel])
            }
        };
        let sums = [0, 1, 2, 3, 4].map(|sum| weighted_sum(row, (0..side).map(of(sum))));
        let sizes = [0, 1, 2, 3, 4].map(|sum| tap_sum(row, side, |tap| of(sum)(tap).abs()));
        [sums, sizes]
    }
}

/// `1 - SSIM` and its three slopes in f64 from a window's sums, as [`organza_shaders::ssim`] has them, and the sizes of
/// what they are sums of.
fn similarity([d, s, dd, ss, weight]: [f64; 5]) -> [[f64; 4]; 2] {
    let mean_d = d / weight;
    let mean_s = s / weight;
    let variance_d = (dd / weight - mean_d * mean_d).max(0.0);
    let variance_s = (ss / weight - mean_s * mean_s).max(0.0);
    let center = mean_s + 1.0;
    let q = (center * center + mean_d * mean_d) / 2.0 + f64::from(C1);
    let t = (variance_s + variance_d) / 2.0 + f64::from(C2);
    let a = mean_d * mean_d / q;
    let b = variance_d / t;
    let by_difference = (1.0 - a) * (2.0 - b) / t;
    let by_sum = -(1.0 - a) * b / t;
    let of_means = (1.0 - b) * (mean_d * (2.0 - a) - center * a) / q;
    let constant = of_means - by_difference * mean_d - by_sum * mean_s;
    let sizes = [(1.0 + a) * (2.0 + b) / t, (1.0 + a) * b / t];
    let size = (1.0 + b) * (mean_d.abs() * (2.0 + a) + center.abs() * a) / q;
    let size = size + sizes[0] * mean_d.abs() + sizes[1] * mean_s.abs();
    [
        [a + b - a * b, constant / weight, by_difference / weight, by_sum / weight],
        [a + b + a * b, size / weight, sizes[0] / weight, sizes[1] / weight],
    ]
}

/// How far each of [`similarity`]'s results may be off, in units of the sums' roundings.
fn conditioned([sums, sizes]: [[f64; 5]; 2]) -> [f64; 4] {
    const STEP: f64 = 1e-5;
    let [results, mut scales] = similarity(sums);
    for sum in 0..5 {
        for step in [-STEP, STEP] {
            let mut moved = sums;
            moved[sum] += step * sizes[sum];
            let [others, _] = similarity(moved);
            for (scale, (other, result)) in scales.iter_mut().zip(others.iter().zip(results)) {
                *scale += (other - result).abs() / STEP;
            }
        }
    }
    scales
}

impl Parity for SsimColumns {
    const KERNEL: &'static str = "ssim_columns";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of eleven products and their sums, divisions of 3 ulp, scaled by how the \
        f64 similarity is conditioned: a variance is a difference; colors are at most 2";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, TILES])
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let values = if output.name == "slopes" { 4 * SLOPES as usize } else { 1 };
        let pixel = index / values;
        let channel = index % 4;
        let is_valid = self.difference[pixel].w > 0.0;
        if !is_valid || values > 1 && channel == 3 {
            return Bound::EXACT;
        }
        let of = |channel| conditioned(self.window_sums(pixel, channel));
        let scale = match values {
            1 => [0, 1, 2].map(|channel| of(channel)[0]).iter().sum(),
            _ => of(channel)[1 + index / 4 % SLOPES as usize],
        };
        // 2 / Q W of a mean that is flushed
        Bound { scale, floor: 1e6 * f64::from(TINY) }
    }

    /// A pixel of a window adds w (1, d, s, d^2, s^2) to its sums, and x enters d and s alike.
    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let values = if output == "slopes" { 4 * SLOPES as usize } else { 1 };
        let pixel = index / values;
        let channel = index % 4;
        let is_valid = self.difference[pixel].w > 0.0;
        if !is_valid || values > 1 && channel == 3 {
            return Some(0.0);
        }
        if values == 1 {
            let of = |channel| dissimilarity(self.window_sums(pixel, channel)[0]);
            return Some([0, 1, 2].map(of).iter().sum());
        }
        let [by_d, by_s, by_dd, by_ss, _] =
            gradient(self.window_sums(pixel, channel)[0], dissimilarity::<Dual>);
        Some([by_d + by_s, 2.0 * by_dd, 2.0 * by_ss][index / 4 % SLOPES as usize])
    }
}

case!(pub SsimRowsBackward(SsimRowsBackwardInputs));

impl SsimRowsBackward {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let vectors = (SLOPES * TILES * side * side) as usize;
        let numbers = fill.values(random, 4 * vectors, [-3e3, 3e3], 1e37);
        Self(SsimRowsBackwardInputs {
            params: SsimParams { side },
            window: window().to_vec(),
            slopes: numbers.chunks_exact(4).map(Vec4::from_slice).collect(),
            row_slopes: unwritten(vectors),
        })
    }
}

impl Parity for SsimRowsBackward {
    const KERNEL: &'static str = "ssim_rows_backward";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of eleven products and their sum, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, TILES])
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let vector = index / 4;
        let channel = index % 4;
        let side = self.params.side as usize;
        let pixel = vector / SLOPES as usize;
        let part = vector % SLOPES as usize;
        let [tile, row, column] = place(pixel, side);
        let size = |tap: usize| {
            let at = (tile + row * side + tap) * SLOPES as usize + part;
            f64::from(self.slopes[at][channel].abs())
        };
        let floor = 2.0 * f64::from(WINDOW) * f64::from(TINY);
        Bound { scale: tap_sum(column, side, size), floor }
    }

    /// The transpose of a symmetric window is the window itself.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let side = self.params.side as usize;
        let vector = index / 4;
        let channel = index % 4;
        let pixel = vector / SLOPES as usize;
        let part = vector % SLOPES as usize;
        let [tile, row, column] = place(pixel, side);
        let at = |tap: usize| (tile + row * side + tap) * SLOPES as usize + part;
        let value = |tap| f64::from(self.slopes[at(tap)][channel]);
        Some(weighted_sum(column, (0..side).map(value)))
    }
}
