//! Cases of `loss_terms`, `loss_rows` and `loss_gradient`.

use glam::Vec4;
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

/// The outputs of `loss_terms`: inputs of the other kernels.
#[derive(Clone, Debug)]
pub struct Terms {
    /// `[tiles, S, S]`: d and the mask.
    pub difference: Vec<Vec4>,
    /// `[tiles, S, S]`: s.
    pub sum: Vec<Vec4>,
}

/// d and s of a pixel's channel; `None` for masked pixels.
fn pixel_slopes(d: &[Vec4], s: &[Vec4], pixel: usize, channel: usize) -> Option<[f64; 2]> {
    let is_valid = d[pixel].w > 0.0;
    is_valid.then(|| [d, s].map(|values| f64::from(values[pixel][channel])))
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
        let at = index / 4;
        let channel = index % 4;
        let is_valid = self.valid[at] > 0.0;
        if !is_valid || channel == 3 {
            return Bound::EXACT;
        }
        let area = (self.params.side * self.params.side) as usize;
        let place = (at / area * 3 + channel) * area + at % area;
        let size = f64::from(self.image[place].abs()) + f64::from(self.target[place].abs());
        let half = if output.name == "sum" { 1.0 } else { 0.0 };
        Bound { scale: size + half, floor: 4.0 * f64::from(TINY) }
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let area = (self.params.side * self.params.side) as usize;
        let pixel = index / 4;
        let channel = index % 4;
        let is_valid = self.valid[pixel] > 0.0;
        let is_difference = output == "difference";
        if !is_valid || channel == 3 {
            return Some(f64::from(u8::from(is_valid && is_difference)));
        }
        let at = (pixel / area * 3 + channel) * area + pixel % area;
        let [x, y] = [&self.image, &self.target].map(|image| f64::from(image[at]));
        Some(if is_difference { x - y } else { x + y - 1.0 })
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
        let row = index / 4;
        let part = index % 4;
        let side = self.params.side as usize;
        let sizes = (row * side..(row + 1) * side).map(|at| {
            let d = self.difference[at].as_dvec4().truncate().abs();
            match part {
                0 => d.element_sum(),
                1 => f64::from(self.dissimilarity[at].abs()),
                2 => d.length_squared(),
                _ => 0.0,
            }
        });
        let roundings = (side + 3) as f64;
        // what is flushed: three values of each pixel
        let floor = if part == 3 { 0.0 } else { 3.0 * roundings * f64::from(TINY) };
        Bound { scale: roundings * sizes.sum::<f64>(), floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let side = self.params.side as usize;
        let row = index / 4;
        let part = index % 4;
        let pixels = row * side..(row + 1) * side;
        let of = |at: usize| {
            let d = self.difference[at].as_dvec4();
            sums(d.truncate().to_array(), f64::from(self.dissimilarity[at]), d.w)[part]
        };
        Some(pixels.map(of).sum::<f64>())
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
        let side = self.params.side as usize;
        let area = side * side;
        let tile = index / 3 / area;
        let channel = index / area % 3;
        let at = index % area;
        let pixel = tile * area + at;
        if self.difference[pixel].w == 0.0 {
            return Bound::EXACT;
        }
        let slope = |part: usize| {
            let value = |row: usize| {
                let at = (tile * area + row * side + at % side) * SLOPES as usize + part;
                f64::from(self.row_slopes[at][channel].abs())
            };
            tap_sum(at / side, side, value)
        };
        let [d, s] =
            [&self.difference, &self.sum].map(|values| f64::from(values[pixel][channel].abs()));
        let LossGradientParams { absolute_scale, ssim_scale, .. } = self.params;
        let [absolute, ssim] = [absolute_scale, ssim_scale].map(f64::from);
        let floor = (d + s + 30.0) * f64::from(TINY);
        Bound { scale: ssim * (slope(0) + d * slope(1) + s * slope(2)) + absolute, floor }
    }

    /// A pixel adds w (1, d, s) to the windows around it, and the slopes belong to those sums.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let side = self.params.side as usize;
        let area = side * side;
        let tile = index / 3 / area;
        let channel = index / area % 3;
        let at = index % area;
        let pixel = tile * area + at;
        let Some([d, s]) = pixel_slopes(&self.difference, &self.sum, pixel, channel) else {
            return Some(0.0);
        };
        let row = at / side;
        let column = at % side;
        let slope = |part: usize| {
            let vector = |tap: usize| SLOPES as usize * (tile * area + tap * side + column);
            let value = |tap| f64::from(self.row_slopes[vector(tap) + part][channel]);
            weighted_sum(row, (0..side).map(value))
        };
        let LossGradientParams { absolute_scale, ssim_scale, .. } = self.params;
        let [absolute, ssim] = [absolute_scale, ssim_scale].map(f64::from);
        Some(absolute * sign(d) + ssim * (slope(0) + d * slope(1) + s * slope(2)))
    }
}
