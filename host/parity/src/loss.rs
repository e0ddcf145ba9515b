//! Cases of `loss_terms`, `loss_rows` and `loss_gradient`.

use glam::{DVec4, Vec4};
use muslin_check::prelude::*;
use organza_shaders::loss::{
    LossGradientInputs, LossGradientParams, LossParams, LossRowsInputs, LossTermsInputs,
};
use organza_shaders::ssim::SLOPES;

use super::exact::loss::{sign, sums};
use super::exact::ssim::{tap_sum, weighted_sum, window};

/// Sides around the workgroup's, and around the window's.
pub const SIDES: [u32; 7] = [1, 7, 8, 9, 11, 12, 17];

/// Tiles of a set: one all valid, one with holes, one without a valid pixel.
pub const TILES: u32 = 3;

/// A random set of every side, and one of every filling.
pub fn sets<T>(make: impl Fn(u32, Fill, &mut Random) -> T) -> Vec<(String, T)> {
    let sized = SIDES.map(|side| (side, Fill::Random));
    let filled = Fill::ADVERSARIAL.map(|fill| (12, fill));
    let set = |(index, (side, fill)): (usize, (u32, Fill))| {
        let mut random = Random::new(index as u64);
        (format!("{}, side {side}", fill.name()), make(side, fill, &mut random))
    };
    sized.into_iter().chain(filled).enumerate().map(set).collect()
}

/// Whether each pixel of [`TILES`] tiles is valid.
fn mask(side: u32, random: &mut Random) -> Vec<bool> {
    let area = side * side;
    (0..TILES * area).map(|at| at < area || at < 2 * area && random.below(3) > 0).collect()
}

/// The outputs of `loss_terms`, `[tiles, S, S]`: d and the mask, and s.
pub struct Terms {
    pub difference: Vec<Vec4>,
    pub sum: Vec<Vec4>,
}

impl Terms {
    /// Of colors in 0 to 1; huge ones are 2.
    pub fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let valid = mask(side, random);
        let colors = fill.values(random, 6 * valid.len(), [0.0, 1.0], 2.0);
        let pixel = |(valid, colors): (&bool, &[f32])| {
            if !valid {
                return (Vec4::ZERO, Vec4::ZERO);
            }
            let [d, s] = [|x: f32, y: f32| x - y, |x: f32, y: f32| (x - 0.5) + (y - 0.5)]
                .map(|of| [0, 1, 2].map(|channel| of(colors[channel], colors[channel + 3])));
            (Vec4::new(d[0], d[1], d[2], 1.0), Vec4::new(s[0], s[1], s[2], 0.0))
        };
        let (difference, sum) = valid.iter().zip(colors.chunks_exact(6)).map(pixel).unzip();
        Self { difference, sum }
    }
}

case!(pub LossTerms(LossTermsInputs));

impl LossTerms {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let valid = mask(side, random);
        let area = (side * side) as usize;
        let mut colors = || {
            let mut colors = fill.values(random, 3 * valid.len(), [0.0, 1.0], 1e38);
            let masked = |at: usize| !valid[at / area / 3 * area + at % area];
            let all = colors.iter_mut().enumerate();
            all.filter(|(at, _)| masked(*at)).for_each(|(_, color)| *color = f32::NAN);
            colors
        };
        let image = colors();
        let target = colors();
        let valid: Vec<_> = valid.iter().map(|&valid| f32::from(u8::from(valid))).collect();
        Self(LossTermsInputs {
            params: LossParams { side, tiles: TILES },
            image,
            target,
            difference: unwritten(valid.len()),
            sum: unwritten(valid.len()),
            valid,
        })
    }

    /// The colors of a value; `None` for masked pixels, and for the mask itself.
    fn colors(&self, index: usize) -> Option<[f64; 2]> {
        let area = (self.params.side * self.params.side) as usize;
        let [pixel, channel] = [index / 4, index % 4];
        let at = (pixel / area * 3 + channel) * area + pixel % area;
        (self.valid[pixel] > 0.0 && channel < 3)
            .then(|| [&self.image, &self.target].map(|image| f64::from(image[at])))
    }
}

impl Parity for LossTerms {
    const KERNEL: &'static str = "loss_terms";
    const TOLERANCE: f64 = 2.4e-7;
    const WHY: &'static str = "three roundings of the colors' sizes; what is masked is NaN";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, TILES])
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let Some([x, y]) = self.colors(index) else { return Bound::EXACT };
        let half = if output.name == "sum" { 1.0 } else { 0.0 };
        Bound { scale: x.abs() + y.abs() + half, floor: 4.0 * f64::from(TINY) }
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let is_difference = output == "difference";
        Some(match self.colors(index) {
            Some([x, y]) if is_difference => x - y,
            Some([x, y]) => x + y - 1.0,
            None => f64::from(u8::from(self.valid[index / 4] > 0.0 && is_difference)),
        })
    }
}

case!(pub LossRows(LossRowsInputs));

impl LossRows {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let pixels = (TILES * side * side) as usize;
        let numbers = fill.values(random, 3 * pixels, [-1.0, 1.0], 1e18);
        let valid = mask(side, random);
        let pixel = |(d, &valid): (&[f32], &bool)| {
            if valid { Vec4::new(d[0], d[1], d[2], 1.0) } else { Vec4::ZERO }
        };
        let difference = numbers.chunks_exact(3).zip(&valid).map(pixel).collect();
        Self(LossRowsInputs {
            params: LossParams { side, tiles: TILES },
            difference,
            dissimilarity: fill.values(random, pixels, [0.0, 6.0], 6.0),
            row_sum: unwritten((TILES * side) as usize),
        })
    }

    /// The pixels of a row: d and the mask, and 1 - SSIM.
    fn row(&self, row: usize) -> impl Iterator<Item = (DVec4, f64)> {
        let side = self.params.side as usize;
        (row * side..(row + 1) * side)
            .map(|at| (self.difference[at].as_dvec4(), self.dissimilarity[at].into()))
    }
}

impl Parity for LossRows {
    const KERNEL: &'static str = "loss_rows";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each pixel of the row and its channels, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(Self::new);
        let long = Self::new(130, Fill::Random, &mut Random::new(7));
        sets.push(("random, side 130".into(), long));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), TILES * self.params.side, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let part = index % 4;
        let sizes = self.row(index / 4).map(|(d, dissimilarity)| {
            let d = d.truncate().abs();
            [d.element_sum(), dissimilarity.abs(), d.length_squared(), 0.0][part]
        });
        let roundings = f64::from(self.params.side + 3);
        // what is flushed: three values of each pixel
        let floor = if part == 3 { 0.0 } else { 3.0 * roundings * f64::from(TINY) };
        Bound { scale: roundings * sizes.sum::<f64>(), floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let of = |(d, dissimilarity): (DVec4, f64)| {
            sums(d.truncate().to_array(), dissimilarity, d.w)[index % 4]
        };
        Some(self.row(index / 4).map(of).sum::<f64>())
    }
}

case!(pub LossGradient(LossGradientInputs));

impl LossGradient {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let Terms { difference, sum } = Terms::new(side, fill, random);
        let vectors = (SLOPES * TILES * side * side) as usize;
        let numbers = fill.values(random, 4 * vectors, [-3e3, 3e3], 1e30);
        let row_slopes = numbers.chunks_exact(4).map(Vec4::from_slice).collect();
        Self(LossGradientInputs {
            params: LossGradientParams { side, absolute_scale: 2.7e-3, ssim_scale: 6.5e-4 },
            window: window().to_vec(),
            grad_image: unwritten(3 * sum.len()),
            difference,
            sum,
            row_slopes,
        })
    }

    /// d and s of a value's pixel, the three slopes of each pixel of its column, and its row; `None` for masked pixels.
    fn terms(&self, index: usize) -> Option<([f64; 2], Vec<[f64; 3]>, usize)> {
        let side = self.params.side as usize;
        let area = side * side;
        let [tile, channel, at] = [index / 3 / area, index / area % 3, index % area];
        let pixel = tile * area + at;
        let of = |row: usize| {
            let vector = (tile * area + row * side + at % side) * SLOPES as usize;
            [0, 1, 2].map(|part| f64::from(self.row_slopes[vector + part][channel]))
        };
        (self.difference[pixel].w > 0.0).then(|| {
            let values = [&self.difference, &self.sum];
            let ds = values.map(|values| f64::from(values[pixel][channel]));
            (ds, (0..side).map(of).collect(), at / side)
        })
    }

    /// The factors of both terms of the loss.
    fn scales(&self) -> [f64; 2] {
        [self.params.absolute_scale, self.params.ssim_scale].map(f64::from)
    }
}

impl Parity for LossGradient {
    const KERNEL: &'static str = "loss_gradient";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of eleven products and their sums, of the terms' sizes; a difference \
        that may be flushed has no sign";

    fn sets() -> Vec<(String, Self)> {
        sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, TILES])
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some(([d, s], slopes, row)) = self.terms(index) else { return Bound::EXACT };
        let [d, s] = [d.abs(), s.abs()];
        let slope = |part: usize| tap_sum(row, slopes.len(), |tap| slopes[tap][part].abs());
        let [absolute, ssim] = self.scales();
        let floor = (d + s + 30.0) * f64::from(TINY);
        Bound { scale: ssim * (slope(0) + d * slope(1) + s * slope(2)) + absolute, floor }
    }

    /// A pixel adds w (1, d, s) to the windows around it, and the slopes belong to those sums.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let Some(([d, s], slopes, row)) = self.terms(index) else { return Some(0.0) };
        let slope = |part: usize| weighted_sum(row, slopes.iter().map(|slopes| slopes[part]));
        let [absolute, ssim] = self.scales();
        Some(absolute * sign(d) + ssim * (slope(0) + d * slope(1) + s * slope(2)))
    }
}
