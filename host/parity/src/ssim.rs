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

/// A place in a row of terms that a window weights.
struct Taps {
    at: usize,
    terms: Vec<f64>,
}

impl Taps {
    fn sum(self) -> Option<f64> {
        Some(weighted_sum(self.at, self.terms.into_iter()))
    }

    fn bound(&self) -> Bound {
        let floor = 2.0 * f64::from(WINDOW) * f64::from(TINY);
        let size = |tap: usize| self.terms[tap].abs();
        Bound { scale: tap_sum(self.at, self.terms.len(), size), floor }
    }
}

case!(pub SsimRows(SsimRowsInputs));

impl SsimRows {
    /// What a value is the sum of.
    fn taps(&self, index: usize) -> Taps {
        let side = self.params.side as usize;
        let [tile, row, column] = place(index / 16, side);
        let term = |tap| {
            let values: [&[Vec4]; 2] = [&self.difference, &self.sum];
            moment(values, tile + row * side + tap, index / 4 % 4, index % 4)
        };
        Taps { at: column, terms: (0..side).map(term).collect() }
    }
}

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
        self.taps(index).bound()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        self.taps(index).sum()
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

    /// The pixel of a value, its channel, and the slope that it is; no slope of 1 - SSIM itself, and none of either where all are 0.
    fn place(&self, output: &str, index: usize) -> Option<(usize, usize, Option<usize>)> {
        let is_slope = output == "slopes";
        let pixel = if is_slope { index / 4 / SLOPES as usize } else { index };
        let channel = index % 4;
        let is_valid = self.difference[pixel].w > 0.0 && !(is_slope && channel == 3);
        is_valid.then(|| (pixel, channel, is_slope.then_some(index / 4 % SLOPES as usize)))
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
        let Some((pixel, channel, slope)) = self.place(output.name, index) else {
            return Bound::EXACT;
        };
        let of = |channel| conditioned(self.window_sums(pixel, channel));
        let scale = match slope {
            None => [0, 1, 2].map(|channel| of(channel)[0]).iter().sum(),
            Some(slope) => of(channel)[1 + slope],
        };
        // 2 / Q W of a mean that is flushed
        Bound { scale, floor: 1e6 * f64::from(TINY) }
    }

    /// A pixel of a window adds w (1, d, s, d^2, s^2) to its sums, and x enters d and s alike.
    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let Some((pixel, channel, slope)) = self.place(output, index) else { return Some(0.0) };
        let sums = |channel| self.window_sums(pixel, channel)[0];
        let Some(slope) = slope else {
            return Some([0, 1, 2].map(|channel| dissimilarity(sums(channel))).iter().sum());
        };
        let [by_d, by_s, by_dd, by_ss, _] = gradient(sums(channel), dissimilarity::<Dual>);
        Some([by_d + by_s, 2.0 * by_dd, 2.0 * by_ss][slope])
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

    /// What a value is the sum of.
    fn taps(&self, index: usize) -> Taps {
        let side = self.params.side as usize;
        let parts = SLOPES as usize;
        let [tile, row, column] = place(index / 4 / parts, side);
        let vector = |tap: usize| (tile + row * side + tap) * parts + index / 4 % parts;
        let term = |tap| f64::from(self.slopes[vector(tap)][index % 4]);
        Taps { at: column, terms: (0..side).map(term).collect() }
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
        self.taps(index).bound()
    }

    /// The transpose of a symmetric window is the window itself.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        self.taps(index).sum()
    }
}
