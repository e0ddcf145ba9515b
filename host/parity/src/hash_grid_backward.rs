//! The cases of `hash_grid_backward` and `hash_grid_gradient`.

use std::cell::OnceCell;

use muslin_check::prelude::*;
use organza_shaders::hash_grid::Corners;
use organza_shaders::hash_grid_backward::{
    HashGridBackwardKernel, HashGridGradientInputs, HashGridGradientParams, VALUES_PER_FLAG,
};
use organza_shaders::unit_cube::Split;

use super::binned::{integer, words};
use super::exact::hash_grid::levels;
use super::exact::hash_grid_scale::unit;
use super::hash_grid::{
    exact_point, features, grid, params, points_of, positions, unrounded_point,
};
use organza_core::scene::GridConfig;

/// Inputs of `hash_grid_backward`.
#[derive(Clone)]
pub struct HashGridBackward {
    grid: GridConfig,
    points: Vec<[Split; 3]>,
    /// `[rows, points]`
    gradient: Vec<f32>,
    /// The fixed point's unit, a power of two, as a multiple of which gradients are below 2^50.
    scale: f32,
    /// The largest gradient that is added.
    limit: f32,
    /// Whether every device computes the same terms, all of them multiples of the unit.
    is_unrounded: bool,
    sizes: OnceCell<Vec<f64>>,
}

/// The smallest normal f32: a GPU may flush smaller ones.
const SMALLEST: f64 = 1.175_494_350_822_287_5e-38;

impl HashGridBackward {
    fn new(grid: GridConfig, count: u32, fills: [Fill; 2], random: &mut Random) -> Self {
        let [points, gradient] = fills;
        let x = points.values(random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let points = points_of(x.into_iter().map(|x| (x, 0.0)));
        let rows = grid.width() * count as usize;
        let gradient = gradient.values(random, rows, [-1.0, 1.0], 1e30);
        let largest = gradient.iter().fold(TINY, |a, b| a.max(b.abs()));
        let scale = 2_f32.powi((50 - largest.log2().ceil() as i32).min(126));
        let (limit, sizes) = (f32::MAX, OnceCell::new());
        Self { grid, points, gradient, scale, limit, is_unrounded: false, sizes }
    }

    fn unrounded_set(grid: GridConfig, points: Vec<[Split; 3]>, gradient: Vec<f32>) -> Self {
        let (limit, scale, sizes) = (f32::MAX, 2_f32.powi(40), OnceCell::new());
        Self { grid, points, gradient, scale, limit, is_unrounded: true, sizes }
    }

    /// A grid of scale 4 in both levels, which are dense with 2^9 entries and hashed with 2^6.
    fn grid_of_whole_scale(log2_table: u32) -> GridConfig {
        let [base_resolution, growth] = [5.0, 1.0];
        GridConfig { levels: 2, log2_table, base_resolution, growth, ..grid() }
    }

    /// Positions and gradients with so few bits that no term is rounded: all devices must have the same sums.
    fn unrounded() -> Vec<(String, Self)> {
        let mut random = Random::new(19);
        let gradients = |len: usize, random: &mut Random| {
            let zeros = [0.0, -0.0, TINY / 2.0, -TINY / 2.0];
            let of = |index: usize, random: &mut Random| match index % 7 {
                zero @ 0..4 => zeros[zero],
                _ => random.below(9) as f32 / 4.0 - 1.0,
            };
            (0..len).map(|index| of(index, random)).collect::<Vec<_>>()
        };
        let mut sets: Vec<_> = [1, 63, 64, 65, 1000]
            .into_iter()
            .flat_map(|count| [9, 6].map(|log2_table| (count, log2_table)))
            .map(|(count, log2_table)| {
                let grid = Self::grid_of_whole_scale(log2_table);
                let points = (0..count).map(|_| unrounded_point(7, &mut random)).collect();
                let gradient = gradients(grid.width() * count, &mut random);
                let set = Self::unrounded_set(grid, points, gradient);
                (format!("unrounded, {count} points, 2^{log2_table}"), set)
            })
            .collect();
        let grid = Self::grid_of_whole_scale(9);
        let points = vec![unrounded_point(7, &mut random); 777];
        let gradient = (0..grid.width() * 777).map(|at| (at / 777) as f32 + 0.25).collect();
        let set = Self::unrounded_set(grid, points, gradient);
        sets.push(("777 points at one place".into(), set));
        sets.extend(Self::largest());
        sets
    }

    /// The largest sums: as many samples as the unit allows, all with the limit as gradient, all in one entry.
    fn largest() -> Vec<(String, Self)> {
        const SAMPLES: u32 = 4096;
        let of = |bound: f32, sign: f32| {
            let (exponent, limit) = unit(&[bound], SAMPLES);
            let grid = GridConfig { levels: 1, features: 1, base_resolution: 4.0, ..grid() };
            // on a grid point, as the scale is 3
            let points = vec![[Split::new(0.5, 0.0); 3]; SAMPLES as usize];
            let gradient = vec![sign * limit; SAMPLES as usize];
            let scale = 2_f32.powi(exponent);
            let set = Self { limit, scale, ..Self::unrounded_set(grid, points, gradient) };
            (format!("{SAMPLES} of {:e}", sign * limit), set)
        };
        let bounds = [1e-31, 3.7, 3e37];
        bounds.into_iter().flat_map(|bound| [of(bound, 1.0), of(bound, -1.0)]).collect()
    }

    /// Gradients that are not finite or exceed the limit: the kernel skips the point in that level.
    fn beyond() -> Vec<(String, Self)> {
        let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1.01, -1.01];
        let of = |bad: f32| {
            let mut set = Self::new(grid(), 100, [Fill::Random; 2], &mut Random::new(20));
            set.limit = 1.0;
            set.gradient[130] = bad;
            (format!("a gradient of {bad}"), set)
        };
        bad.map(of).into()
    }

    /// The gradients of a point's features in a level; `None` if one is not finite or exceeds the limit.
    fn gradients(&self, level: usize, point: usize) -> Option<Vec<f64>> {
        let features = self.grid.features as usize;
        let row = |f: usize| (level * features + f) * self.points.len() + point;
        let gradients = (0..features).map(|f| f64::from(self.gradient[row(f)]));
        gradients.map(|g| (g.abs() <= f64::from(self.limit)).then_some(g)).collect()
    }

    fn values(&self) -> usize {
        self.grid.entries() * self.grid.features as usize
    }

    /// The sums in units, `sum_points weight dL/dfeature`, the transpose of
    /// [`encode`](super::exact::hash_grid::encode), and whether each block of 64 values is touched.
    fn sums(&self) -> (Vec<f64>, Vec<bool>) {
        let features = self.grid.features as usize;
        let mut sums = vec![0.0; self.values()];
        let mut touched = vec![false; sums.len().div_ceil(64)];
        for (index, level) in levels(&self.grid).iter().enumerate() {
            for (point, &place) in self.points.iter().enumerate() {
                let Some(gradients) = self.gradients(index, point) else { continue };
                // denormals count as 0: a GPU may flush them
                let active: Vec<_> =
                    gradients.iter().enumerate().filter(|(_, g)| g.abs() >= SMALLEST).collect();
                if active.is_empty() {
                    continue;
                }
                let corners = level.corners(exact_point(place));
                for (entry, weight) in corners {
                    touched[entry * features / 64] = true;
                    for (f, gradient) in &active {
                        sums[entry * features + f] += weight * *gradient * f64::from(self.scale);
                    }
                }
            }
        }
        (sums, touched)
    }

    /// For each value: the sizes of what is added to it, times the unit.
    fn sizes(&self) -> Vec<f64> {
        let features = self.grid.features as usize;
        let mut sizes = vec![0.0; self.values()];
        for (index, level) in self.grid.levels_for_kernels().iter().enumerate() {
            for (column, &point) in self.points.iter().enumerate() {
                let entries = Corners::new(level, level.cell::<f32>(point)).entry;
                if self.gradients(index, column).is_none() {
                    continue;
                }
                for (entry, f) in entries.iter().flat_map(|e| (0..features).map(move |f| (e, f))) {
                    let row = (index * features + f) * self.points.len();
                    let size = f64::from(self.gradient[row + column].abs());
                    let position = 2e-4 * f64::from(level.resolution);
                    sizes[*entry as usize * features + f] +=
                        size * f64::from(self.scale) * (1.0 + position);
                }
            }
        }
        sizes
    }
}

impl Parity for HashGridBackward {
    const KERNEL: &'static str = "hash_grid_backward";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str = "weights good to a few 6e-8, as in hash_grid, a rounding of the product, and one to an \
        integer; flags are equal, as no point lies within rounding of a cell's plane";

    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self::new(grid(), n, [fill, Fill::Random], random));
        for fill in Fill::ADVERSARIAL {
            let set = Self::new(grid(), ITEMS, [Fill::Random, fill], &mut Random::new(13));
            sets.push((format!("gradients of {}", fill.name()), set));
        }
        for features in [1, 4, 8] {
            let grid = GridConfig { features, ..grid() };
            let set = Self::new(grid, ITEMS, [Fill::Random; 2], &mut Random::new(14));
            sets.push((format!("{features} features"), set));
        }
        sets.extend(Self::unrounded());
        sets.extend(Self::beyond());
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let count = self.points.len();
        let gradient = features(&self.grid, count, &self.gradient);
        let levels = self.grid.levels_for_kernels();
        let kernel = HashGridBackwardKernel {
            params: params(&self.grid, count),
            levels: &levels,
            position: &positions(&self.points),
            feature_gradient: &gradient,
            scale: &vec![self.scale, 1.0 / self.scale, self.limit],
            sum: &vec![0; 2 * self.values()],
            touched: &vec![0; self.values().div_ceil(VALUES_PER_FLAG as usize)],
            status: &vec![0],
        };
        let mut outputs = runner.run(&kernel, count as u32, levels.len() as u32)?;
        let integers = outputs[0].words().as_chunks().0.iter().copied().map(integer);
        outputs[0].values = Values::Float(integers.map(|integer| integer as f64).collect());
        Ok(outputs)
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        if self.is_unrounded {
            return Bound::EXACT;
        }
        let size = self.sizes.get_or_init(|| self.sizes())[index];
        let regrouped = match rounding {
            Rounding::AsWritten => 1.0,
            // a position is good to 6e-8 of the resolution
            Rounding::Regrouped => 300.0,
        };
        // an integer each
        Bound { scale: regrouped * size, floor: if size > 0.0 { 8.0 * ITEMS as f64 } else { 0.0 } }
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        let is_left_out =
            |level| (0..self.points.len()).any(|point| self.gradients(level, point).is_none());
        let flag = |flag: bool| Some(f64::from(u8::from(flag)));
        let mut exact: Vec<_> = match output {
            "sum" => self.sums().0.into_iter().map(Some).collect(),
            "touched" => self.sums().1.into_iter().map(flag).collect(),
            _ => vec![flag((0..self.grid.levels as usize).any(is_left_out))],
        };
        exact.resize(len, None);
        exact
    }
}

case!(pub HashGridGradient(HashGridGradientInputs));

impl HashGridGradient {
    /// The sum of a value.
    fn integer(&self, value: usize) -> i64 {
        integer([self.sum[2 * value], self.sum[2 * value + 1]])
    }
}

impl Parity for HashGridGradient {
    const KERNEL: &'static str = "hash_grid_gradient";
    const TOLERANCE: f64 = 3e-7;
    const WHY: &'static str =
        "three roundings of an integer of two words and one of the sum, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let is_large = matches!(fill, Fill::Huge | Fill::Mixed);
            let one = 2_f64.powi(if is_large { 62 } else { 40 });
            let sum = fill.values(random, count as usize, [-1.0, 1.0], 1.0);
            let gradient = fill.values(random, count as usize, [-1.0, 1.0], 1e30);
            let blocks = count.div_ceil(VALUES_PER_FLAG) as usize;
            let touched = (0..blocks).map(|_| random.below(2));
            // nothing is bound as nothing
            let touched = touched.chain([0]).collect();
            let scale = 2_f32.powi(random.below(90) as i32 - 30);
            Self(HashGridGradientInputs {
                params: HashGridGradientParams { values: count },
                scale: vec![scale, 1.0 / scale, 0.0],
                touched,
                sum: sum.into_iter().flat_map(|x| words((f64::from(x) * one) as i64)).collect(),
                gradient,
            })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.values, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let sum = self.integer(index) as f64 / f64::from(self.scale[0]);
        let before = f64::from(self.gradient[index]);
        Bound::relative_to(sum.abs() + before.abs())
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let is_touched = |index: usize| self.touched[index / 64] != 0;
        let value = if output == "gradient" { index } else { index / 2 };
        let sum = self.integer(value);
        Some(match (output, is_touched(value)) {
            ("gradient", true) => {
                f64::from(self.gradient[value]) + sum as f64 / f64::from(self.scale[0])
            }
            ("gradient", false) => f64::from(self.gradient[value]),
            // the kernel clears the sums
            (_, true) => 0.0,
            (_, false) => f64::from((sum >> (32 * (index % 2))) as u32),
        })
    }
}
