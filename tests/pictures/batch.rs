//! The loss of a batch in f64, from its definition: two-dimensional windows, one after the other.

use organza_parity::exact::loss::sign;
use organza_parity::exact::numeric::{Dual, Number, gradient};
use organza_parity::exact::ssim;

/// Tiles and their mask, `[K, 3, S, S]` and `[K, S, S]`.
#[derive(Clone, Debug)]
pub struct Batch {
    /// S, in pixels.
    pub side: usize,
    /// The rendered tiles.
    pub image: Vec<f32>,
    /// The photographs.
    pub target: Vec<f32>,
    /// 1 for pixels that count, 0 for others.
    pub valid: Vec<f32>,
}

impl Batch {
    /// K
    pub fn tiles(&self) -> usize {
        self.valid.len() / (self.side * self.side)
    }

    /// The place in the mask of a value of the image.
    pub fn pixel(&self, index: usize) -> usize {
        let area = self.side * self.side;
        index / area / 3 * area + index % area
    }

    /// The number of valid pixels.
    pub fn valid_pixels(&self) -> f64 {
        self.valid.iter().copied().map(f64::from).sum()
    }

    /// A channel of a tile in f64.
    pub fn plane(&self, tile: usize, channel: usize) -> Plane {
        let area = self.side * self.side;
        let part = |values: &[f32], first: usize| -> Vec<f64> {
            values[first..first + area].iter().copied().map(f64::from).collect()
        };
        let first = (tile * 3 + channel) * area;
        Plane {
            side: self.side,
            x: part(&self.image, first),
            y: part(&self.target, first),
            valid: part(&self.valid, tile * area).iter().map(|&m| m == 1.0).collect(),
        }
    }

    /// The sums of a tile over its valid pixels and three channels: |x - y|, 1 - SSIM, (x - y)^2, and the number of pixels.
    pub fn sums(&self, tile: usize) -> [f64; 4] {
        let mut sums = [0.0; 4];
        for channel in 0..3 {
            let plane = self.plane(tile, channel);
            for at in (0..self.side * self.side).filter(|&at| plane.valid[at]) {
                let d = plane.x[at] - plane.y[at];
                let terms = [d.abs(), 1.0 - plane.similarity(at), d * d, 1.0 / 3.0];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            }
        }
        sums
    }
}

/// One channel of a tile.
#[derive(Clone, Debug)]
pub struct Plane {
    /// S, in pixels.
    pub side: usize,
    /// The image.
    pub x: Vec<f64>,
    /// The photograph.
    pub y: Vec<f64>,
    /// Which pixels count.
    pub valid: Vec<bool>,
}

impl Plane {
    /// SSIM of the window around a pixel, its weights normalized over the valid pixels in it.
    pub fn similarity(&self, center: usize) -> f64 {
        self.similarity_where(center, |at| self.x[at])
    }

    /// As [`Plane::similarity`], with other values of x.
    fn similarity_where<N: Number>(&self, center: usize, x: impl Fn(usize) -> N) -> N {
        let weights = ssim::weights();
        let weight = |at: usize| {
            let across = (at % self.side).abs_diff(center % self.side);
            let down = (at / self.side).abs_diff(center / self.side);
            weights[across] * weights[down]
        };
        let pixels = self.around(center).filter(|&at| self.valid[at]);
        let pixels: Vec<_> = pixels.map(|at| (weight(at), [x(at), self.y[at].into()])).collect();
        ssim::window_ssim(&pixels)
    }

    /// The pixels of the tile at most five rows and columns away.
    fn around(&self, center: usize) -> impl Iterator<Item = usize> + use<> {
        let side = self.side;
        let range = |at: usize| at.saturating_sub(5)..(at + 6).min(side);
        let columns = range(center % side);
        range(center / side)
            .flat_map(move |row| columns.clone().map(move |column| row * side + column))
    }

    /// The derivatives of the sums of `|x - y|` and `1 - SSIM` by the image's pixel.
    pub fn slopes(&self, at: usize) -> [f64; 2] {
        if !self.valid[at] {
            return [0.0; 2];
        }
        let windows = self.around(at).filter(|&center| self.valid[center]);
        let similarity = windows.map(|center| {
            let x = |x: Dual| {
                let others = |other: usize| if other == at { x } else { self.x[other].into() };
                self.similarity_where(center, others)
            };
            gradient([self.x[at]], |[moved]| x(moved))[0]
        });
        [sign(self.x[at] - self.y[at]), -similarity.sum::<f64>()]
    }
}
