//! Cases of `loss_terms`, `loss_rows`, `loss_check` and `loss_gradient`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::loss::{
    LossCheckInputs, LossCheckParams, LossGradientInputs, LossGradientParams, LossParams,
    LossRowsInputs, LossTermsInputs,
};
use organza_shaders::ssim::SLOPES;

use super::exact::loss::{sign, sums};
use super::exact::ssim::{weighted_sum, window};

/// Sides around the workgroup's, and around the window's.
const SIDES: [u32; 7] = [1, 7, 8, 9, 11, 12, 17];

/// Tiles of a set: one all valid, one with holes, one without a valid pixel.
pub const TILES: u32 = 3;

/// A random set of every side, and one of every filling.
pub fn sets<T>(make: impl Fn(u32, Fill, &mut Random) -> T) -> Vec<(String, T)> {
    inputs::sets_of(SIDES, 12, make)
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
    /// Terms with differences of -1 to 1.
    pub fn new(side: u32, fill: Fill, huge: f32, random: &mut Random) -> Self {
        let valid = mask(side, random);
        let mut masked = |w: f32| {
            let vectors = fill.vectors(random, valid.len(), [-1.0, 1.0], huge).into_iter();
            let vectors = vectors.zip(&valid);
            vectors.map(|(v, &valid)| if valid { v.with_w(w) } else { Vec4::ZERO }).collect()
        };
        Self { difference: masked(1.0), sum: masked(0.0) }
    }
}

case!(pub LossTerms(LossTermsInputs));

impl Parity for LossTerms {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
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
        })
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let area = (self.params.side * self.params.side) as usize;
        let [pixel, channel] = [index / 4, index % 4];
        let is_difference = output == "difference";
        let is_valid = self.valid[pixel] > 0.0;
        // what is masked is NaN
        if !is_valid || channel == 3 {
            return Some(u32::from(is_valid && is_difference).into());
        }
        let at = (pixel / area * 3 + channel) * area + pixel % area;
        let [x, y] = [self.image[at], self.target[at]].map(Rounded::from);
        Some(if is_difference { x - y } else { x + y - 1.0.into() })
    }
}

case!(pub LossRows(LossRowsInputs));

impl LossRows {
    fn new(side: u32, fill: Fill, random: &mut Random) -> Self {
        let pixels = (TILES * side * side) as usize;
        Self(LossRowsInputs {
            params: LossParams { side, tiles: TILES },
            difference: Terms::new(side, fill, 1e18, random).difference,
            dissimilarity: fill.values(random, pixels, [0.0, 6.0], 6.0),
            row_sum: unwritten((TILES * side) as usize),
        })
    }
}

impl Parity for LossRows {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(Self::new);
        sets.push(("random, side 130".into(), Self::new(130, Fill::Random, &mut Random::new(7))));
        sets
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let side = self.params.side as usize;
        let row = index / 4 * side..(index / 4 + 1) * side;
        Some(Number::sum(row.map(|at| {
            let [r, g, b, valid] = self.difference[at].to_array().map(Rounded::from);
            sums([r, g, b], self.dissimilarity[at].into(), valid)[index % 4]
        })))
    }
}

case!(pub LossCheck(LossCheckInputs));

impl Parity for LossCheck {
    fn sets() -> Vec<(String, Self)> {
        let of = |rows: u32, bad: Option<Vec4>| {
            let mut random = Random::new(u64::from(rows));
            let mut row_sum = Fill::Random.vectors(&mut random, rows as usize, [0.0, 400.0], 1e38);
            if let (Some(bad), 1..) = (bad, rows) {
                row_sum[random.below(rows) as usize] = bad;
            }
            let params = LossCheckParams { rows };
            let set = Self(LossCheckInputs { params, row_sum, counts: vec![0, 7, 8, 9, u32::MAX] });
            (format!("{rows} rows, {bad:?}"), set)
        };
        let bad = [
            None,
            Some(Vec4::X * f32::NAN),
            Some(Vec4::X * f32::INFINITY),
            Some(Vec4::Y * f32::NEG_INFINITY),
            // squares are for the PSNR
            Some(Vec4::new(1.0, 1.0, f32::INFINITY, 1.0)),
        ];
        SIZES.into_iter().flat_map(|rows| bad.map(|bad| of(rows, bad))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let is_finite = |sum: &Vec4| sum.x.is_finite() && sum.y.is_finite();
        listed([u32::from(!self.row_sum.iter().all(is_finite)), 7, 8, 9, u32::MAX])
    }
}

case!(pub LossGradient(LossGradientInputs));

impl Parity for LossGradient {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Terms { difference, sum } = Terms::new(side, fill, 2.0, random);
            let vectors = (SLOPES * TILES * side * side) as usize;
            Self(LossGradientInputs {
                params: LossGradientParams { side, absolute_scale: 2.7e-3, ssim_scale: 6.5e-4 },
                window: window(),
                grad_image: unwritten(3 * sum.len()),
                difference,
                sum,
                row_slopes: fill.vectors(random, vectors, [-3e3, 3e3], 1e30),
            })
        })
    }

    /// A pixel adds w (1, d, s) to the windows around it, and the slopes belong to those sums.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let side = self.params.side as usize;
        let area = side * side;
        let [tile, channel, at] = [index / 3 / area, index / area % 3, index % area];
        let pixel = tile * area + at;
        if self.difference[pixel].w == 0.0 {
            return Some(Rounded::exact(0.0));
        }
        let slope = |part: usize| {
            let vector =
                |row: usize| (tile * area + row * side + at % side) * SLOPES as usize + part;
            let column = (0..side).map(|row| self.row_slopes[vector(row)][channel].into());
            weighted_sum(at / side, column)
        };
        let [d, s] =
            [&self.difference, &self.sum].map(|values| Rounded::from(values[pixel][channel]));
        let [absolute, ssim] =
            [self.params.absolute_scale, self.params.ssim_scale].map(Rounded::from);
        let sign = Rounded::exact(sign(d.value));
        Some(absolute * sign + ssim * (slope(0) + d * slope(1) + s * slope(2)))
    }
}
