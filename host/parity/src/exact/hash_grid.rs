//! The multiresolution hash grid (Eq. 1 and 9).

use organza_core::scene::GridConfig;

/// Where a level lies in the table, and how points of the unit cube map to its cells.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    /// `base * growth^l - 1`
    pub scale: f64,
    /// `ceil(scale) + 1`
    pub resolution: u64,
    /// First entry.
    pub first: u64,
    /// Number of entries: `min(round_up(resolution^3, 8), 2^log2_table)`.
    pub count: u64,
}

/// The levels of a grid, coarsest first.
pub fn levels(grid: &GridConfig) -> Vec<Level> {
    let mut first = 0;
    let level = |l: u32| {
        let scale = grid.base_resolution * grid.growth.powf(f64::from(l)) - 1.0;
        let resolution = scale.ceil() as u64 + 1;
        let count = resolution.pow(3).next_multiple_of(8).min(1 << grid.log2_table);
        first += count;
        Level { scale, resolution, first: first - count, count }
    };
    (0..grid.levels).map(level).collect()
}

impl Level {
    /// A point's position in cells; its coordinates are clamped to 0 to 1 first.
    pub fn place(&self, point: [f64; 3]) -> [f64; 3] {
        point.map(|x| x.clamp(0.0, 1.0) * self.scale + 0.5)
    }

    /// The entry of a grid point, counted from the start of the table.
    pub fn entry(&self, [x, y, z]: [u64; 3]) -> usize {
        let u32s = |x: u64| x & u64::from(u32::MAX);
        let index = if self.resolution.pow(3) > self.count {
            x ^ u32s(y * 2_654_435_761) ^ u32s(z * 805_459_861)
        } else {
            x + y * self.resolution + z * self.resolution * self.resolution
        };
        (self.first + index % self.count) as usize
    }

    /// The eight corners of a point's cell, x fastest: entries and trilinear weights.
    pub fn corners(&self, point: [f64; 3]) -> [(usize, f64); 8] {
        let place = self.place(point);
        let fraction = place.map(|x| x - x.floor());
        std::array::from_fn(|corner| {
            let is_upper = [0, 1, 2].map(|axis| corner >> axis & 1 == 1);
            let at = [0, 1, 2].map(|axis| place[axis].floor() as u64 + u64::from(is_upper[axis]));
            let weight = |axis| if is_upper[axis] { fraction[axis] } else { 1.0 - fraction[axis] };
            (self.entry(at), weight(0) * weight(1) * weight(2))
        })
    }
}

/// The features of a point, level by level. The table is `[entries, features]`.
pub fn encode(grid: &GridConfig, table: &[f32], point: [f64; 3]) -> Vec<f64> {
    let features = grid.features as usize;
    let mut encoded = Vec::new();
    for level in levels(grid) {
        let corners = level.corners(point);
        let feature = |f: usize| {
            let terms = corners.iter().map(|(at, w)| w * f64::from(table[at * features + f]));
            terms.sum::<f64>()
        };
        encoded.extend((0..features).map(feature));
    }
    encoded
}
