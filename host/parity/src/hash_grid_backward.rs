//! The cases of `hash_grid_backward` and `hash_grid_gradient`.

use muslin_check::prelude::*;
use organza_shaders::hash_grid::Corners;
use organza_shaders::hash_grid_backward::{
    HashGridBackwardInputs, HashGridGradientInputs, HashGridGradientParams, VALUES_PER_FLAG,
};
use organza_shaders::unit_cube::Split;

use super::binned::{integer, words};
use super::exact::hash_grid::levels;
use super::exact::hash_grid_scale::unit;
use super::hash_grid::{
    exact_point, features, grid, params, points_of, positions, unrounded_point,
};
use organza_core::scene::GridConfig;

case!(pub HashGridBackward(HashGridBackwardInputs) {
    grid: GridConfig,
    points: Vec<[Split; 3]>,
    /// `[rows, points]`
    gradient: Vec<f32>,
    /// Whether every device computes the same terms, all of them multiples of the unit
    is_unrounded: bool,
});

impl HashGridBackward {
    /// The unit is a power of two. Gradients are below 2^50 units; larger ones than the limit are not added.
    fn new(
        grid: GridConfig,
        points: Vec<[Split; 3]>,
        gradient: Vec<f32>,
        [scale, limit]: [f32; 2],
    ) -> Self {
        let values = grid.entries() * grid.features as usize;
        let inputs = HashGridBackwardInputs {
            params: params(&grid, points.len()),
            levels: grid.levels_for_kernels(),
            position: positions(&points),
            feature_gradient: features(&grid, points.len(), &gradient),
            scale: vec![scale, 1.0 / scale, limit],
            sum: vec![0; 2 * values],
            touched: vec![0; values.div_ceil(VALUES_PER_FLAG as usize)],
            status: vec![0],
        };
        Self { inputs, grid, points, gradient, is_unrounded: false }
    }

    fn filled(grid: GridConfig, count: u32, fills: [Fill; 2], random: &mut Random) -> Self {
        let [points, gradient] = fills;
        let x = points.values(random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let points = points_of(x.into_iter().map(|x| (x, 0.0)));
        let gradient = gradient.values(random, grid.width() * count as usize, [-1.0, 1.0], 1e30);
        let largest = gradient.iter().fold(TINY, |a, b| a.max(b.abs()));
        let scale = 2_f32.powi((50 - largest.log2().ceil() as i32).min(126));
        Self::new(grid, points, gradient, [scale, f32::MAX])
    }

    fn unrounded_set(grid: GridConfig, points: Vec<[Split; 3]>, gradient: Vec<f32>) -> Self {
        Self { is_unrounded: true, ..Self::new(grid, points, gradient, [2_f32.powi(40), f32::MAX]) }
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
        sets.push(("777 points at one place".into(), Self::unrounded_set(grid, points, gradient)));
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
            let set = Self::new(grid, points, gradient, [2_f32.powi(exponent), limit]);
            let set = Self { is_unrounded: true, ..set };
            (format!("{SAMPLES} of {:e}", sign * limit), set)
        };
        [1e-31, 3.7, 3e37].into_iter().flat_map(|bound| [of(bound, 1.0), of(bound, -1.0)]).collect()
    }

    /// Gradients that are not finite or exceed the limit: the kernel skips the point in that level.
    fn beyond() -> Vec<(String, Self)> {
        let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1.01, -1.01];
        let of = |bad: f32| {
            let set = Self::filled(grid(), 100, [Fill::Random; 2], &mut Random::new(20));
            let mut gradient = set.gradient;
            gradient[130] = bad;
            let set = Self::new(set.grid, set.points, gradient, [set.inputs.scale[0], 1.0]);
            (format!("a gradient of {bad}"), set)
        };
        bad.map(of).into()
    }

    /// The gradients of a point's features in a level; `None` if one is not finite or exceeds the limit.
    fn gradients(&self, level: usize, point: usize) -> Option<Vec<f64>> {
        let features = self.grid.features as usize;
        let row = |f: usize| (level * features + f) * self.points.len() + point;
        let gradients = (0..features).map(|f| f64::from(self.gradient[row(f)]));
        gradients.map(|g| (g.abs() <= f64::from(self.scale[2])).then_some(g)).collect()
    }

    /// The sums in units, `sum_points weight dL/dfeature`, the transpose of
    /// [`encode`](super::exact::hash_grid::encode), and whether each block of 64 values is touched.
    ///
    /// The error of a weight has no equation, as in `hash_grid`: rounding may move a point to the next cell.
    fn sums(&self, error: f64) -> (Vec<Rounded>, Vec<bool>) {
        let features = self.grid.features as usize;
        let scale = f64::from(self.scale[0]);
        let mut sums = vec![Rounded::exact(0.0); self.sum.len() / 2];
        let mut touched = vec![false; self.touched.len()];
        for (index, (exact, level)) in levels(&self.grid).iter().zip(&self.levels).enumerate() {
            let error = scale * error * (1.0 + 2e-4 * f64::from(level.resolution));
            for (at, &point) in self.points.iter().enumerate() {
                let Some(gradients) = self.gradients(index, at) else { continue };
                for entry in Corners::new(level, level.cell::<f32>(point)).entry {
                    let sums = &mut sums[entry as usize * features..][..features];
                    let all = sums.iter_mut().zip(&gradients);
                    all.for_each(|(sum, gradient)| sum.error += error * gradient.abs());
                }
                // denormals count as 0: a GPU may flush them
                let is_active = |gradient: &f64| gradient.abs() >= f64::from(f32::MIN_POSITIVE);
                if !gradients.iter().any(is_active) {
                    continue;
                }
                for (entry, weight) in exact.corners(exact_point(point)) {
                    touched[entry * features / 64] = true;
                    let all = sums[entry * features..].iter_mut().zip(&gradients);
                    all.filter(|(_, gradient)| is_active(gradient))
                        .for_each(|(sum, gradient)| sum.value += weight * gradient * scale);
                }
            }
        }
        (sums, touched)
    }

    /// The values of an output, with the error of a weight. Each point may also add a part of an integer.
    fn known(&self, output: &str, error: f64) -> Vec<Option<Rounded>> {
        let is_left_out =
            |level| (0..self.points.len()).any(|point| self.gradients(level, point).is_none());
        let (sums, touched) = self.sums(error);
        let integers = 8.0 * f64::from(ITEMS);
        let rounded = |sum: Rounded| match sum.error {
            0.0 => sum,
            _ if self.is_unrounded => Rounded::exact(sum.value),
            error => Rounded::within(sum.value, error + integers),
        };
        match output {
            "sum" => listed(sums.into_iter().map(rounded)),
            "touched" => listed(touched.into_iter().map(u32::from)),
            _ => listed([u32::from((0..self.levels.len()).any(is_left_out))]),
        }
    }
}

impl Parity for HashGridBackward {
    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self::filled(grid(), n, [fill, Fill::Random], random));
        for fill in Fill::ADVERSARIAL {
            let set = Self::filled(grid(), ITEMS, [Fill::Random, fill], &mut Random::new(13));
            sets.push((format!("gradients of {}", fill.name()), set));
        }
        for features in [1, 4, 8] {
            let grid = GridConfig { features, ..grid() };
            let set = Self::filled(grid, ITEMS, [Fill::Random; 2], &mut Random::new(14));
            sets.push((format!("{features} features"), set));
        }
        sets.extend(Self::unrounded());
        sets.extend(Self::beyond());
        sets
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        let words = outputs[0].words();
        let integers = words.as_chunks().0.iter().map(|&words| integer(words) as f64);
        outputs[0] = Output::float("sum", integers);
        outputs
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        self.known(output, 5e-7)
    }

    /// A position is one f32.
    fn exact_regrouped(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        self.known(output, 300.0 * 5e-7)
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
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let is_large = matches!(fill, Fill::Huge | Fill::Mixed);
            let one = 2_f64.powi(if is_large { 62 } else { 40 });
            let sum = fill.values(random, count as usize, [-1.0, 1.0], 1.0);
            let gradient = fill.values(random, count as usize, [-1.0, 1.0], 1e30);
            let blocks = count.div_ceil(VALUES_PER_FLAG) as usize;
            let touched = (0..blocks).map(|_| random.below(2));
            // an empty buffer cannot be bound
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

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let value = if output == "gradient" { index } else { index / 2 };
        let is_touched = self.touched[value / 64] != 0;
        let sum = self.integer(value);
        Some(match output {
            "gradient" if is_touched => {
                // an integer of two words
                let sum = Rounded::from(sum as f64).rounded(3.0);
                Rounded::from(self.gradient[value]) + sum / self.scale[0].into()
            }
            "gradient" => self.gradient[value].into(),
            // the kernel clears the sums
            _ if is_touched => 0.into(),
            _ => ((sum >> (32 * (index % 2))) as u32).into(),
        })
    }
}
