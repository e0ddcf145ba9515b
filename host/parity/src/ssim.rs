//! Cases of `ssim_rows`, `ssim_columns` and `ssim_rows_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::ssim::{
    MOMENTS, SLOPES, SsimColumnsInputs, SsimParams, SsimRowsBackwardInputs, SsimRowsInputs,
};

use super::exact::ssim::{dissimilarity, weighted_sum, window};
use super::loss::{TILES, Terms, sets};

/// Tile's first pixel, row and column of a pixel.
fn place(pixel: usize, side: usize) -> [usize; 3] {
    [pixel / (side * side) * side * side, pixel / side % side, pixel % side]
}

/// The sum in a window along a row of one of the moments d, s, d^2 and s^2.
fn moment<N: Number>(
    [difference, sum]: [&[Vec4]; 2],
    side: usize,
    pixel: usize,
    [part, channel]: [usize; 2],
) -> N {
    let [tile, row, column] = place(pixel, side);
    let values = [difference, sum][part % 2][tile + row * side..].iter().take(side);
    let terms = values.map(|value| {
        let value = N::from(value[channel].into());
        if part < 2 { value } else { value * value }
    });
    weighted_sum(column, terms)
}

case!(pub SsimRows(SsimRowsInputs));

impl Parity for SsimRows {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Terms { difference, sum } = Terms::new(side, fill, 2.0, random);
            Self(SsimRowsInputs {
                params: SsimParams { side },
                window: window(),
                moments: unwritten(MOMENTS as usize * sum.len()),
                difference,
                sum,
            })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let side = self.params.side as usize;
        let which = [index / 4 % 4, index % 4];
        Some(moment([&self.difference, &self.sum], side, index / 16, which))
    }
}

case!(pub SsimColumns(SsimColumnsInputs));

impl SsimColumns {
    /// A window's sums of d, s, d^2, s^2 and the mask.
    fn window_sums(&self, pixel: usize, channel: usize) -> [Rounded; 5] {
        let side = self.params.side as usize;
        let [tile, row, column] = place(pixel, side);
        [[0, channel], [1, channel], [2, channel], [3, channel], [0, 3]].map(|[part, channel]| {
            let at = |tap: usize| (tile + tap * side + column) * MOMENTS as usize + part;
            weighted_sum(row, (0..side).map(|tap| self.moments[at(tap)][channel].into()))
        })
    }
}

impl Parity for SsimColumns {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let Terms { difference, sum } = Terms::new(side, fill, 2.0, random);
            let vector = |index: usize| {
                let [pixel, part] = [index / MOMENTS as usize, index % MOMENTS as usize];
                let of = |channel| {
                    moment::<f64>([&difference, &sum], side as usize, pixel, [part, channel]) as f32
                };
                Vec4::from_array([0, 1, 2, 3].map(of))
            };
            let moments = (0..MOMENTS as usize * sum.len()).map(vector).collect();
            Self(SsimColumnsInputs {
                params: SsimParams { side },
                window: window(),
                dissimilarity: unwritten(sum.len()),
                slopes: unwritten(SLOPES as usize * sum.len()),
                difference,
                moments,
            })
        })
    }

    /// A pixel of a window adds w (1, d, s, d^2, s^2) to its sums, and x enters d and s alike.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let is_slope = output == "slopes";
        let pixel = if is_slope { index / 4 / SLOPES as usize } else { index };
        let channel = index % 4;
        if self.difference[pixel].w == 0.0 || is_slope && channel == 3 {
            return Some(Rounded::exact(0.0));
        }
        if !is_slope {
            let channels = [0, 1, 2].map(|channel| self.window_sums(pixel, channel));
            return Some(Number::sum(channels.map(dissimilarity)));
        }
        let sums = self.window_sums(pixel, channel);
        let [by_d, by_s, by_dd, by_ss, _] = gradient(sums, dissimilarity::<Dual<Rounded>>);
        let two = Rounded::from(2.0);
        Some([by_d + by_s, two * by_dd, two * by_ss][index / 4 % SLOPES as usize])
    }
}

case!(pub SsimRowsBackward(SsimRowsBackwardInputs));

impl Parity for SsimRowsBackward {
    fn sets() -> Vec<(String, Self)> {
        sets(|side, fill, random| {
            let vectors = (SLOPES * TILES * side * side) as usize;
            Self(SsimRowsBackwardInputs {
                params: SsimParams { side },
                window: window(),
                slopes: fill.vectors(random, vectors, [-3e3, 3e3], 1e37),
                row_slopes: unwritten(vectors),
            })
        })
    }

    /// The transpose of a symmetric window is the window itself.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let side = self.params.side as usize;
        let parts = SLOPES as usize;
        let [tile, row, column] = place(index / 4 / parts, side);
        let vectors = self.slopes[(tile + row * side) * parts..].iter();
        let row = vectors.skip(index / 4 % parts).step_by(parts).take(side);
        Some(weighted_sum(column, row.map(|vector| vector[index % 4].into())))
    }
}
