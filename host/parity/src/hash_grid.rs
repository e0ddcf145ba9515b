//! The case of `hash_grid`.

use muslin_check::prelude::*;
use organza_shaders::hash_grid::{HashGridInputs, HashGridParams, POINT_ROWS};
use organza_shaders::unit_cube::Split;

use super::exact::hash_grid::encode;
use organza_core::scene::GridConfig;

/// Rows before the features, which the kernel leaves alone.
const FIRST_ROW: usize = 3;
/// Points of a chunk.
const CHUNK: usize = 128;
/// Distance of two rows of a chunk.
const STRIDE: usize = CHUNK + 7;

case!(pub HashGrid(HashGridInputs) {
    pub(super) grid: GridConfig,
    points: Vec<[Split; 3]>,
    /// Whether the points' positions in all levels have so few bits that no order of operations rounds them
    is_unrounded: bool,
});

/// A grid with dense and hashed levels.
pub(super) fn grid() -> GridConfig {
    GridConfig { levels: 5, features: 2, log2_table: 9, base_resolution: 5.0, growth: 2.1 }
}

/// A point with coordinates that are multiples of `2^-bits`.
pub(super) fn unrounded_point(bits: i32, random: &mut Random) -> [Split; 3] {
    let unit = 2_f32.powi(-bits);
    [0; 3].map(|_| Split::new(random.below((1 << bits) + 1) as f32 * unit, 0.0))
}

/// Points from the coarse and the fine part of each coordinate.
pub(super) fn points_of(coordinates: impl Iterator<Item = (f32, f32)>) -> Vec<[Split; 3]> {
    let splits: Vec<_> = coordinates.map(|(x, rest)| Split::new(x, rest)).collect();
    splits.as_chunks().0.to_vec()
}

/// Points in f64.
pub(super) fn exact_point(point: [Split; 3]) -> [f64; 3] {
    point.map(|x| f64::from(x.coarse) + f64::from(x.fine))
}

/// Rows of a chunk of features.
fn rows(grid: &GridConfig) -> usize {
    FIRST_ROW + grid.width()
}

/// Row and point of an element of `[chunks, rows, STRIDE]`; none of padding.
fn place(rows: usize, points: usize, index: usize) -> Option<(usize, usize)> {
    let column = index % STRIDE;
    let point = index / STRIDE / rows * CHUNK + column;
    (column < CHUNK && point < points).then_some((index / STRIDE % rows, point))
}

/// The number of elements of `[chunks, rows, STRIDE]`.
fn len(rows: usize, points: usize) -> usize {
    points.div_ceil(CHUNK) * rows * STRIDE
}

/// `[chunks, rows, STRIDE]`, from the value of each row and point.
fn chunked(rows: usize, points: usize, value: impl Fn(usize, usize) -> f32) -> Vec<f32> {
    let places = (0..len(rows, points)).map(|index| place(rows, points, index));
    places.map(|place| place.map_or(f32::NAN, |(row, point)| value(row, point))).collect()
}

/// The parameters for a number of points.
pub(super) fn params(grid: &GridConfig, points: usize) -> HashGridParams {
    HashGridParams {
        points: points as u32,
        stride: STRIDE as u32,
        first_row: FIRST_ROW as u32,
        features: grid.features,
        chunk: CHUNK as u32,
        point_rows: POINT_ROWS,
        rows: rows(grid) as u32,
    }
}

/// Points as kernels read them.
pub(super) fn positions(points: &[[Split; 3]]) -> Vec<f32> {
    chunked(POINT_ROWS as usize, points.len(), |row, point| {
        let x = points[point][row % 3];
        if row < 3 { x.coarse } else { x.fine }
    })
}

/// Features `[width, points]` as kernels read them.
pub(super) fn features(grid: &GridConfig, points: usize, values: &[f32]) -> Vec<f32> {
    chunked(rows(grid), points, |row, point| {
        row.checked_sub(FIRST_ROW).map_or(f32::NAN, |row| values[row * points + point])
    })
}

impl HashGrid {
    fn new(grid: GridConfig, points: Vec<[Split; 3]>, table: Fill, random: &mut Random) -> Self {
        let inputs = HashGridInputs {
            params: params(&grid, points.len()),
            levels: grid.levels_for_kernels(),
            table: table.values(random, grid.entries() * grid.features as usize, [-1.0, 1.0], 1e30),
            position: positions(&points),
            output: unwritten(len(rows(&grid), points.len())),
        };
        Self { inputs, grid, points, is_unrounded: false }
    }

    fn filled(grid: GridConfig, count: u32, [points, table]: [Fill; 2], seed: u64) -> Self {
        let mut random = Random::new(seed);
        let x = points.values(&mut random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let rest = Fill::Random.values(&mut random, x.len(), [0.0, 6e-8], 0.0);
        Self::new(grid, points_of(x.into_iter().zip(rest)), table, &mut random)
    }

    /// Points at multiples of 1/16 of a cell, in levels with scales of few bits.
    ///
    /// Even a driver that regroups operations computes their positions exactly, so wrong weights and corners show in
    /// levels of every resolution.
    fn unrounded() -> Vec<(String, Self)> {
        // the last one is 0.2% below the finest scale; its points have a fine part too
        let scales = [(1.0, 4), (8.0, 7), (64.0, 10), (2048.0, 15), (511.0 * 2048.0, 15)];
        let set = |(scale, bits): (f64, i32)| {
            let grid =
                GridConfig { levels: 1, base_resolution: scale + 1.0, growth: 1.0, ..grid() };
            let mut random = Random::new(bits as u64);
            let points = (0..ITEMS).map(|_| unrounded_point(bits, &mut random)).collect();
            let set = Self::new(grid, points, Fill::Random, &mut random);
            (format!("unrounded, scale {scale}"), Self { is_unrounded: true, ..set })
        };
        scales.map(set).into()
    }

    /// A grid of each kind.
    fn grids() -> Vec<(String, Self)> {
        let grids = [
            ("one feature", GridConfig { features: 1, ..grid() }),
            ("four features", GridConfig { features: 4, ..grid() }),
            ("eight features", GridConfig { features: 8, ..grid() }),
            ("two entries", GridConfig { log2_table: 1, ..grid() }),
            ("half a cell", GridConfig { base_resolution: 0.5, growth: 1.0, ..grid() }),
            ("one cell", GridConfig { base_resolution: 1.0, growth: 1.5, ..grid() }),
            ("all dense", GridConfig { levels: 2, log2_table: 14, ..grid() }),
            ("finest", GridConfig { levels: 1, base_resolution: 1_048_000.0, ..grid() }),
            ("32 levels", GridConfig { levels: 32, growth: 1.3, ..grid() }),
        ];
        let set = |(name, grid): (&str, _)| {
            (name.to_owned(), Self::filled(grid, ITEMS, [Fill::Random; 2], 11))
        };
        grids.map(set).into()
    }

    /// Points on the planes between the cells, and beside them.
    fn on_planes() -> Self {
        let grid = grid();
        let scales: Vec<_> = grid.levels_geometry().iter().map(|level| level.scale).collect();
        let borders = [0.0, -0.0, 1.0, 1.0_f32.next_down(), 1.0_f32.next_up()];
        let borders = borders.map(|x| [Split::new(x, 0.0); 3]).into_iter();
        let on_plane = |index: u32| {
            let scale = scales[index as usize % scales.len()];
            [0, 1, 2].map(|axis| {
                let cell = (f64::from(index * 7 + axis * 3) % scale.ceil()) + 0.5;
                let x = (cell / scale) as f32;
                let ulps = index as i32 % 3 - 1;
                Split::new(f32::from_bits(x.to_bits().wrapping_add_signed(ulps)), 0.0)
            })
        };
        let points = borders.chain((5..ITEMS).map(on_plane)).collect();
        Self::new(grid, points, Fill::Random, &mut Random::new(12))
    }

    /// The place of an element of the output: level, feature and point; none where nothing is written.
    fn place(&self, index: usize) -> Option<(usize, usize, usize)> {
        let (row, point) = place(rows(&self.grid), self.points.len(), index)?;
        let row = row.checked_sub(FIRST_ROW)?;
        let features = self.grid.features as usize;
        Some((row / features, row % features, point))
    }

    /// The features, with the error of a position in a level as a part of its resolution.
    ///
    /// Weights have an error of a few 6e-8 of the corners' sizes. This error has no equation: a position is two f32, and rounding
    /// may move it to the next cell.
    pub(super) fn known(&self, len: usize, position: f64) -> Vec<Option<Rounded>> {
        let encode = |&point| encode(&self.grid, &self.table, exact_point(point));
        let encoded: Vec<_> = self.points.iter().map(encode).collect();
        let features = self.grid.features as usize;
        let known = |index| {
            let (level, feature, point) = self.place(index)?;
            let value = encoded[point][level * features + feature];
            let level = &self.levels[level];
            let entries = level.entries(level.cell::<f32>(self.points[point]).corner);
            let corner = |entry: u32| self.table[entry as usize * features + feature].abs();
            let corners: f64 = entries.into_iter().map(|entry| f64::from(corner(entry))).sum();
            let position = if self.is_unrounded { 0.0 } else { position };
            let weights = 5e-7 * (1.0 + position * f64::from(level.resolution));
            Some(Rounded::within(value, corners * weights + f64::from(TINY) * (8.0 + corners)))
        };
        (0..len).map(known).collect()
    }
}

/// The error of a position of two f32, and of one.
pub(super) const POSITION: [f64; 2] = [2e-4, 0.5];

impl Parity for HashGrid {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            Self::filled(grid(), n, [fill, Fill::Random], random.bits().into())
        });
        sets.extend(Self::grids());
        sets.extend(Self::unrounded());
        sets.push(("cells' planes".into(), Self::on_planes()));
        for fill in Fill::ADVERSARIAL {
            let set = Self::filled(grid(), ITEMS, [Fill::Random, fill], 13);
            sets.push((format!("table of {}", fill.name()), set));
        }
        sets
    }

    fn exact(&self, _: &str, len: usize) -> Vec<Option<Rounded>> {
        self.known(len, POSITION[0])
    }

    fn exact_regrouped(&self, _: &str, len: usize) -> Vec<Option<Rounded>> {
        self.known(len, POSITION[1])
    }
}
