//! The loss in f64, from its definition: two-dimensional windows, one after the other.

/// Tiles and their mask, `[K, 3, S, S]` and `[K, S, S]`.
pub struct Batch {
    pub side: usize,
    pub image: Vec<f32>,
    pub target: Vec<f32>,
    pub valid: Vec<f32>,
}

/// What the device computes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    pub absolute: f64,
    pub dissimilarity: f64,
    pub squared: f64,
    pub valid: f64,
}

impl Batch {
    pub fn tiles(&self) -> usize {
        self.valid.len() / (self.side * self.side)
    }

    /// The place in the mask of a value of the image.
    pub fn pixel(&self, index: usize) -> usize {
        let area = self.side * self.side;
        index / area / 3 * area + index % area
    }

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

    /// The sums of a tile over its valid pixels and three channels.
    pub fn sums(&self, tile: usize) -> Sums {
        let mut sums = Sums::default();
        for channel in 0..3 {
            let plane = self.plane(tile, channel);
            for at in (0..self.side * self.side).filter(|&at| plane.valid[at]) {
                let d = plane.x[at] - plane.y[at];
                sums.absolute += d.abs();
                sums.squared += d * d;
                sums.dissimilarity += 1.0 - plane.similarity(at);
                sums.valid += 1.0 / 3.0;
            }
        }
        sums
    }
}

/// One channel of a tile.
pub struct Plane {
    pub side: usize,
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub valid: Vec<bool>,
}

impl Plane {
    /// SSIM of the window around a pixel, its weights normalized over the valid pixels in it.
    pub fn similarity(&self, center: usize) -> f64 {
        let pixels: Vec<_> = self.around(center).filter(|&at| self.valid[at]).collect();
        let weight = |at: usize| {
            let across = (at % self.side) as f64 - (center % self.side) as f64;
            let down = (at / self.side) as f64 - (center / self.side) as f64;
            (-(across * across + down * down) / (2.0 * 1.5 * 1.5)).exp()
        };
        let total: f64 = pixels.iter().map(|&at| weight(at)).sum();
        let mean = |value: &dyn Fn(usize) -> f64| -> f64 {
            pixels.iter().map(|&at| weight(at) / total * value(at)).sum()
        };
        let (x, y) = (mean(&|at| self.x[at]), mean(&|at| self.y[at]));
        let xx = mean(&|at| (self.x[at] - x).powi(2));
        let yy = mean(&|at| (self.y[at] - y).powi(2));
        let xy = mean(&|at| (self.x[at] - x) * (self.y[at] - y));
        let (c1, c2) = (0.01_f64.powi(2), 0.03_f64.powi(2));
        (2.0 * x * y + c1) * (2.0 * xy + c2) / ((x * x + y * y + c1) * (xx + yy + c2))
    }

    /// The pixels of the tile at most five rows and columns away.
    fn around(&self, center: usize) -> impl Iterator<Item = usize> + use<> {
        let side = self.side;
        let range = |at: usize| at.saturating_sub(5)..(at + 6).min(side);
        let columns = range(center % side);
        range(center / side)
            .flat_map(move |row| columns.clone().map(move |column| row * side + column))
    }

    /// The derivatives of the sums of `|x - y|` and `1 - SSIM` by the image's pixel, by central differences.
    pub fn slopes(&mut self, at: usize) -> [f64; 2] {
        const STEP: f64 = 1e-5;
        if !self.valid[at] {
            return [0.0; 2];
        }
        let windows: Vec<_> = self.around(at).filter(|&center| self.valid[center]).collect();
        let x = self.x[at];
        let mut evaluate = |x: f64| {
            self.x[at] = x;
            let similarity: f64 = windows.iter().map(|&center| self.similarity(center)).sum();
            [(x - self.y[at]).abs(), -similarity]
        };
        let (above, below) = (evaluate(x + STEP), evaluate(x - STEP));
        self.x[at] = x;
        [0, 1].map(|term| (above[term] - below[term]) / (2.0 * STEP))
    }
}
