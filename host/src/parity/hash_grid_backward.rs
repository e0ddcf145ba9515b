//! The cases of `hash_grid_backward` and `hash_grid_gradient`.

use organza_kernel::math::TINY;
use organza_shaders::hash_grid::Corners;
use organza_shaders::hash_grid_backward::{
    FLAG_BLOCK, HashGridBackwardKernel, HashGridGradientKernel, HashGridGradientParams,
};
use organza_shaders::unit_cube::Split;

use super::bench::Bench;
use super::case::{Parity, Rounding};
use super::hash_grid::{features, grid, params, positions};
use super::inputs::{self, Fill, ITEMS, Random};
use super::measure::{Bound, Output, Values};
use crate::scene::{GridConfig, Interpolation};
use organza_device::Result;

/// Inputs of `hash_grid_backward`.
#[derive(Clone, Debug)]
pub struct HashGridBackward {
    /// The grid.
    pub grid: GridConfig,
    /// Points.
    pub points: Vec<[Split; 3]>,
    /// `[rows, points]`
    pub gradient: Vec<f32>,
    /// The fixed point's unit, a power of two, as a multiple of which gradients are below 2^50.
    pub scale: f32,
    /// For each value: the sizes of what is added to it, times the unit.
    sizes: Vec<f64>,
}

impl HashGridBackward {
    fn new(
        grid: GridConfig,
        count: u32,
        points: Fill,
        gradient: Fill,
        random: &mut Random,
    ) -> Self {
        let x = points.values(random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let splits: Vec<_> = x.iter().map(|&x| Split::new(x, 0.0)).collect();
        let (points, _) = splits.as_chunks::<3>();
        let rows = grid.width() * count as usize;
        let gradient = gradient.values(random, rows, [-1.0, 1.0], 1e30);
        let largest = gradient.iter().fold(TINY, |a, b| a.max(b.abs()));
        let scale = 2_f32.powi((50 - largest.log2().ceil() as i32).min(126));
        let mut set = Self { grid, points: points.to_vec(), gradient, scale, sizes: Vec::new() };
        set.sizes = set.sizes();
        set
    }

    fn values(&self) -> usize {
        self.grid.entries() * self.grid.features as usize
    }

    /// See the field.
    fn sizes(&self) -> Vec<f64> {
        let features = self.grid.features as usize;
        let mut sizes = vec![0.0; self.values()];
        for (index, level) in self.grid.levels_for_kernels().iter().enumerate() {
            for (column, &point) in self.points.iter().enumerate() {
                let entries = Corners::of(level, level.cell::<f32>(point, false)).entry;
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
            inputs::sets(|n, fill, random| Self::new(grid(), n, fill, Fill::Random, random));
        for fill in Fill::ADVERSARIAL {
            let set = Self::new(grid(), ITEMS, Fill::Random, fill, &mut Random::new(13));
            sets.push((format!("gradients of {}", fill.name()), set));
        }
        for features in [1, 4, 8] {
            let mut grid = grid();
            (grid.features, grid.interpolation) = (features, Interpolation::Smoothstep);
            let mut random = Random::new(14);
            let set = Self::new(grid, ITEMS, Fill::Random, Fill::Random, &mut random);
            sets.push((format!("smoothstep, {features} features"), set));
        }
        sets
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let count = self.points.len();
        let gradient = features(&self.grid, count, &self.gradient);
        let levels = self.grid.levels_for_kernels();
        let sum = bench.output_of(&vec![0_u32; 2 * self.values()])?;
        let blocks = self.values().div_ceil(FLAG_BLOCK as usize);
        let touched = bench.output_of(&vec![0_u32; blocks])?;
        let status = bench.output_of(&[0_u32])?;
        let kernel = HashGridBackwardKernel {
            params: params(&self.grid, count),
            levels: &bench.upload(&levels)?,
            position: &bench.upload(&positions(&self.points))?,
            feature_gradient: &bench.upload(&gradient)?,
            scale: &bench.upload(&[self.scale, 1.0 / self.scale, f32::MAX])?,
            sum: &sum,
            touched: &touched,
            status: &status,
        };
        bench.items(&kernel, count as u32, levels.len() as u32)?;
        let words = bench.read(&sum)?;
        let integers = words.chunks(2).map(|w| (u64::from(w[1]) << 32 | u64::from(w[0])) as i64);
        Ok(vec![
            Output {
                name: "sum",
                values: Values::Float(integers.map(|integer| integer as f64).collect()),
            },
            Output::exact("touched", bench.read(&touched)?),
            Output::exact("status", bench.read(&status)?),
        ])
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let Some(&size) = self.sizes.get(index) else {
            return Bound { scale: 0.0, floor: 0.0 };
        };
        let regrouped = match rounding {
            Rounding::AsWritten => 1.0,
            // a position is good to 6e-8 of the resolution
            Rounding::Regrouped => 300.0,
        };
        // an integer each
        Bound { scale: regrouped * size, floor: if size > 0.0 { 8.0 * ITEMS as f64 } else { 0.0 } }
    }
}

/// Inputs of `hash_grid_gradient`.
#[derive(Clone, Debug)]
pub struct HashGridGradient {
    /// `[values]`
    pub sum: Vec<i64>,
    /// `[values]`
    pub gradient: Vec<f32>,
    /// A flag for each block.
    pub touched: Vec<u32>,
    /// The fixed point's unit.
    pub scale: f32,
}

impl Parity for HashGridGradient {
    const KERNEL: &'static str = "hash_grid_gradient";
    const TOLERANCE: f64 = 3e-7;
    const WHY: &'static str =
        "three roundings of an integer of two words and one of the sum, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let integer = |value: f32| match fill {
                Fill::Huge | Fill::Mixed => (f64::from(value) * 2_f64.powi(62)) as i64,
                _ => (f64::from(value) * 2_f64.powi(40)) as i64,
            };
            let sum = fill.values(random, count as usize, [-1.0, 1.0], 1.0);
            let blocks = count.div_ceil(FLAG_BLOCK) as usize;
            Self {
                sum: sum.into_iter().map(integer).collect(),
                gradient: fill.values(random, count as usize, [-1.0, 1.0], 1e30),
                touched: (0..blocks).map(|_| random.below(2)).collect(),
                scale: 2_f32.powi(random.below(90) as i32 - 30),
            }
        })
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let words = |&sum: &i64| [sum as u32, (sum >> 32) as u32];
        let sum = bench.output_of(&self.sum.iter().flat_map(words).collect::<Vec<_>>())?;
        let gradient = bench.output_of(&self.gradient)?;
        let values = self.sum.len() as u32;
        let kernel = HashGridGradientKernel {
            params: HashGridGradientParams { values },
            scale: &bench.upload(&[self.scale, 1.0 / self.scale, 0.0])?,
            // nothing is bound as nothing
            touched: &bench.upload(&[&self.touched[..], &[0]].concat())?,
            sum: &sum,
            gradient: &gradient,
        };
        bench.items(&kernel, values, 1)?;
        Ok(vec![
            Output::float("gradient", bench.read(&gradient)?),
            Output::exact("sum", bench.read(&sum)?),
        ])
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let sum = self.sum.get(index).map_or(0.0, |&sum| sum as f64 / f64::from(self.scale));
        let before = self.gradient.get(index).map_or(0.0, |&value| f64::from(value));
        Bound::of(sum.abs() + before.abs())
    }
}
