//! The case of `hash_grid`.

use muslin_check::prelude::*;
use organza_shaders::hash_grid::{HashGridKernel, HashGridParams, POINT_ROWS};
use organza_shaders::unit_cube::Split;

use super::exact::hash_grid::encode;
use organza_core::scene::GridConfig;

/// Rows before the features, which the kernel leaves alone.
const FIRST_ROW: usize = 3;
/// Points of a chunk.
const CHUNK: usize = 128;
/// Distance of two rows of a chunk.
const STRIDE: usize = CHUNK + 7;

/// Inputs of `hash_grid`.
#[derive(Clone)]
pub struct HashGrid {
    pub(super) grid: GridConfig,
    points: Vec<[Split; 3]>,
    pub(super) table: Vec<f32>,
    /// Whether the points' positions in all levels have so few bits that no order of operations rounds them.
    is_unrounded: bool,
}

/// A grid with dense and hashed levels.
pub(super) fn grid() -> GridConfig {
    GridConfig { levels: 5, features: 2, log2_table: 9, base_resolution: 5.0, growth: 2.1 }
}

/// A point whose coordinates are multiples of `2^-bits`.
pub(super) fn unrounded_point(bits: i32, random: &mut Random) -> [Split; 3] {
    let unit = 2_f32.powi(-bits);
    [0; 3].map(|_| Split::new(random.below((1 << bits) + 1) as f32 * unit, 0.0))
}

/// Points of coordinates and what they are rounded by.
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

/// The number of values of `[chunks, rows, STRIDE]` for a number of points.
fn len(rows: usize, points: usize) -> usize {
    points.div_ceil(CHUNK) * rows * STRIDE
}

/// Where a point's value of a row lies in `[chunks, rows, STRIDE]`.
fn at(rows: usize, row: usize, point: usize) -> usize {
    (point / CHUNK * rows + row) * STRIDE + point % CHUNK
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
    let mut position = vec![f32::NAN; len(POINT_ROWS as usize, points.len())];
    for (point, coordinates) in points.iter().enumerate() {
        for (axis, x) in coordinates.iter().enumerate() {
            position[at(POINT_ROWS as usize, axis, point)] = x.coarse;
            position[at(POINT_ROWS as usize, axis + 3, point)] = x.fine;
        }
    }
    position
}

/// Features `[width, points]` as kernels read them.
pub(super) fn features(grid: &GridConfig, points: usize, values: &[f32]) -> Vec<f32> {
    let rows = rows(grid);
    let mut features = vec![f32::NAN; len(rows, points)];
    for (index, &value) in values.iter().enumerate() {
        features[at(rows, FIRST_ROW + index / points, index % points)] = value;
    }
    features
}

impl HashGrid {
    fn new(grid: GridConfig, count: u32, points: Fill, table: Fill, random: &mut Random) -> Self {
        let x = points.values(random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let rest = Fill::Random.values(random, x.len(), [0.0, 6e-8], 0.0);
        let points = points_of(x.into_iter().zip(rest));
        let entries = grid.entries() * grid.features as usize;
        let table = table.values(random, entries, [-1.0, 1.0], 1e30);
        Self { grid, points, table, is_unrounded: false }
    }

    /// Points at multiples of 1/16 of a cell, in levels whose scales have few bits.
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
            let mut set = Self::new(grid, ITEMS, Fill::Random, Fill::Random, &mut random);
            for point in &mut set.points {
                *point = unrounded_point(bits, &mut random);
            }
            set.is_unrounded = true;
            (format!("unrounded, scale {scale}"), set)
        };
        scales.map(set).into()
    }

    /// A grid of each kind.
    fn grids() -> Vec<(String, Self)> {
        let of = |name: &str, change: fn(&mut GridConfig)| {
            let mut grid = grid();
            change(&mut grid);
            let mut random = Random::new(11);
            (name.to_owned(), Self::new(grid, ITEMS, Fill::Random, Fill::Random, &mut random))
        };
        vec![
            of("one feature", |grid| grid.features = 1),
            of("four features", |grid| grid.features = 4),
            of("eight features", |grid| grid.features = 8),
            of("two entries", |grid| grid.log2_table = 1),
            of("half a cell", |grid| (grid.base_resolution, grid.growth) = (0.5, 1.0)),
            of("one cell", |grid| (grid.base_resolution, grid.growth) = (1.0, 1.5)),
            of("all dense", |grid| (grid.levels, grid.log2_table) = (2, 14)),
            of("finest", |grid| (grid.levels, grid.base_resolution) = (1, 1_048_000.0)),
            of("32 levels", |grid| (grid.levels, grid.growth) = (32, 1.3)),
        ]
    }

    /// Points on the planes between the cells, and beside them.
    fn on_planes() -> Self {
        let mut set = Self::new(grid(), ITEMS, Fill::Random, Fill::Random, &mut Random::new(12));
        let scales: Vec<_> = set.grid.levels_geometry().iter().map(|level| level.scale).collect();
        let borders = [0.0, -0.0, 1.0, 1.0_f32.next_down(), 1.0_f32.next_up()];
        for (index, point) in set.points.iter_mut().enumerate() {
            if let Some(&x) = borders.get(index) {
                *point = [Split::new(x, 0.0); 3];
                continue;
            }
            let scale = scales[index % scales.len()];
            *point = [0, 1, 2].map(|axis| {
                let cell = ((index * 7 + axis * 3) as f64 % scale.ceil()) + 0.5;
                let x = (cell / scale) as f32;
                let ulps = index as i32 % 3 - 1;
                Split::new(f32::from_bits(x.to_bits().wrapping_add_signed(ulps)), 0.0)
            });
        }
        set
    }

    /// Values of the output.
    pub(super) fn output_len(&self) -> usize {
        len(rows(&self.grid), self.points.len())
    }

    pub(super) fn params(&self) -> HashGridParams {
        params(&self.grid, self.points.len())
    }

    pub(super) fn positions(&self) -> Vec<f32> {
        positions(&self.points)
    }

    /// The place of an element of the output: level, feature and point; none where nothing is written.
    fn place(&self, index: usize) -> Option<(usize, usize, usize)> {
        let chunk_row = index / STRIDE;
        let column = index % STRIDE;
        let rows = rows(&self.grid);
        let point = chunk_row / rows * CHUNK + column;
        let row = (chunk_row % rows).checked_sub(FIRST_ROW)?;
        let is_written = column < CHUNK && point < self.points.len();
        let features = self.grid.features as usize;
        is_written.then_some((row / features, row % features, point))
    }
}

impl Parity for HashGrid {
    const KERNEL: &'static str = "hash_grid";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str = "weights good to a few 6e-8 of the corners' sizes; a position is good to \
        2e-11 of the resolution, and to 6e-8 where drivers regroup, unless it has few bits: some at every resolution";

    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self::new(grid(), n, fill, Fill::Random, random));
        sets.extend(Self::grids());
        sets.extend(Self::unrounded());
        sets.push(("cells' planes".into(), Self::on_planes()));
        for fill in Fill::ADVERSARIAL {
            let set = Self::new(grid(), ITEMS, Fill::Random, fill, &mut Random::new(13));
            sets.push((format!("table of {}", fill.name()), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let levels = self.grid.levels_for_kernels();
        let kernel = HashGridKernel {
            params: self.params(),
            levels: &levels,
            table: &self.table,
            position: &self.positions(),
            output: &unwritten(self.output_len()),
        };
        runner.run(&kernel, kernel.params.points, levels.len() as u32)
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let Some((level, feature, point)) = self.place(index) else { return Bound::EXACT };
        let level = self.grid.levels_for_kernels()[level];
        let entries = level.entries(level.cell::<f32>(self.points[point]).corner);
        let value = |entry: u32| {
            let at = entry * self.grid.features + feature as u32;
            f64::from(self.table[at as usize].abs())
        };
        let corners: f64 = entries.into_iter().map(value).sum();
        let position = match rounding {
            _ if self.is_unrounded => 0.0,
            Rounding::AsWritten => 2e-4 * f64::from(level.resolution),
            Rounding::Regrouped => 0.5 * f64::from(level.resolution),
        };
        Bound { scale: corners * (1.0 + position), floor: f64::from(TINY) * (8.0 + corners) }
    }

    fn exact(&self, _: &str, len: usize) -> Vec<Option<f64>> {
        let encode = |&point| encode(&self.grid, &self.table, exact_point(point));
        let encoded: Vec<_> = self.points.iter().map(encode).collect();
        let features = self.grid.features as usize;
        let exact = |index| {
            let (level, feature, point) = self.place(index)?;
            Some(encoded[point][level * features + feature])
        };
        (0..len).map(exact).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::hash_grid::{Level, levels};

    /// A mistake that a kernel could make: the entry and the weight of a corner, from the point's cell and its fractions.
    type Mistake = fn(&Level, [u64; 3], [f64; 3], usize) -> (usize, f64);

    fn is_upper(corner: usize) -> [u64; 3] {
        [0, 1, 2].map(|axis| corner as u64 >> axis & 1)
    }

    fn weight(t: [f64; 3], upper: [u64; 3]) -> f64 {
        (0..3).map(|axis| if upper[axis] == 1 { t[axis] } else { 1.0 - t[axis] }).product()
    }

    fn corner(cell: [u64; 3], upper: [u64; 3]) -> [u64; 3] {
        [0, 1, 2].map(|axis| cell[axis] + upper[axis])
    }

    const MISTAKES: [(&str, Mistake); 5] = [
        ("x and y of the entry swapped", |level, cell, t, at| {
            let [x, y, z] = corner(cell, is_upper(at));
            (level.entry([y, x, z]), weight(t, is_upper(at)))
        }),
        ("y and z of the weight swapped", |level, cell, [x, y, z], at| {
            (level.entry(corner(cell, is_upper(at))), weight([x, z, y], is_upper(at)))
        }),
        ("lower for upper weights along z", |level, cell, [x, y, z], at| {
            (level.entry(corner(cell, is_upper(at))), weight([x, y, 1.0 - z], is_upper(at)))
        }),
        ("the sixth corner for the fifth", |level, cell, t, at| {
            let other = if at == 4 { 5 } else { at };
            (level.entry(corner(cell, is_upper(other))), weight(t, is_upper(at)))
        }),
        ("no half a cell", |level, cell, t, at| {
            let cell = cell.map(|x| x.saturating_sub(1));
            (level.entry(corner(cell, is_upper(at))), weight(t, is_upper(at)))
        }),
    ];

    /// The largest error that a mistake causes in a level, as a multiple of the bound for drivers that regroup.
    fn share(set: &HashGrid, level: usize, mistake: Mistake) -> f64 {
        let geometry = levels(&set.grid)[level];
        let features = set.grid.features as usize;
        let exact = set.exact("output", set.output_len());
        let output = Output::float("output", []);
        let of = |(index, exact): (usize, &Option<f64>)| {
            let (of_level, feature, point) = set.place(index)?;
            let exact = (*exact).filter(|_| of_level == level)?;
            let place = geometry.place(exact_point(set.points[point]));
            let cell = place.map(|x| x.floor() as u64);
            let t = place.map(|x| x - x.floor());
            let term = |at| {
                let (entry, weight) = mistake(&geometry, cell, t, at);
                weight * f64::from(set.table[entry * features + feature])
            };
            let found: f64 = (0..8).map(term).sum();
            let Bound { scale, floor } = set.bound(&output, index, Rounding::Regrouped);
            Some((found - exact).abs() / (HashGrid::TOLERANCE * scale + floor))
        };
        exact.iter().enumerate().filter_map(of).fold(0.0, f64::max)
    }

    #[test]
    fn every_mistake_exceeds_the_tolerance() {
        let sets = HashGrid::unrounded().into_iter().chain(HashGrid::grids());
        // these grids have too few cells to distinguish the axes; the next test is about the finest
        let left_out = ["finest", "two entries", "half a cell", "one cell"];
        for (name, set) in sets.filter(|(name, _)| !left_out.contains(&name.as_str())) {
            for level in 0..set.grid.levels as usize {
                for (what, mistake) in MISTAKES {
                    let share = share(&set, level, mistake);
                    assert!(share > 10.0, "{name}, level {level}: {what} is {share:.2} of it");
                }
            }
        }
    }

    /// The test above checks levels as fine as any.
    #[test]
    fn points_of_few_bits_reach_the_finest_level() {
        let finest = |sets: Vec<(String, HashGrid)>| {
            sets.iter().map(|(_, set)| set.grid.finest_resolution()).max().unwrap_or(0)
        };
        let [unrounded, all] = [finest(HashGrid::unrounded()), finest(HashGrid::sets())];
        assert!(f64::from(unrounded) > 0.99 * f64::from(all), "{unrounded} of {all}");
        let has_fine = |set: &HashGrid| set.points.as_flattened().iter().any(|x| x.fine != 0.0);
        assert!(HashGrid::unrounded().iter().any(|(_, set)| has_fine(set)));
    }
}
