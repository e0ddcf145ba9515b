//! The gradient of the hash grids' tables (Eq. 1 and 9).

use organza::scene::{GridConfig, GridLevelGeometry, Interpolation};
use organza::{Device, DeviceOptions};
use organza_shaders::hash_grid::{HashGridParams, POINT_ROWS};
use organza_shaders::hash_grid_backward::{
    FLAG_BLOCK, HashGridBackwardKernel, HashGridGradientKernel, HashGridGradientParams,
};
use organza_shaders::hash_grid_scale::STATUS_LIMIT;
use organza_shaders::unit_cube::Split;
use organza_tests::devices;

/// Rows before the features' gradients.
const FIRST_ROW: u32 = 2;

/// Random numbers of 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 40) as f32 / (1 << 24) as f32
    }
}

/// What the kernel is given.
pub struct Inputs {
    pub grid: GridConfig,
    pub points: Vec<[f32; 3]>,
    /// `[rows, points]`
    pub gradient: Vec<f32>,
    /// 2^exponent
    pub exponent: i32,
    pub limit: f32,
}

/// What it makes of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Outputs {
    pub sum: Vec<i64>,
    pub touched: Vec<u32>,
    pub status: u32,
    pub gradient: Vec<f32>,
}

/// Dense and hashed levels.
pub fn grid(features: u32, interpolation: Interpolation) -> GridConfig {
    GridConfig {
        levels: 4,
        features,
        log2_table: 8,
        base_resolution: 4.0,
        growth: 2.1,
        interpolation,
    }
}

impl Inputs {
    /// Points on binary fractions, where every device computes the same weights, some of them outside the cube.
    pub fn random(grid: GridConfig, points: usize) -> Self {
        let mut random = Random(points as u64);
        let place = |random: &mut Random| ((random.next() * 1.1 - 0.05) * 512.0).round() / 512.0;
        let positions = (0..points).map(|_| [0, 1, 2].map(|_| place(&mut random))).collect();
        let gradient = (0..grid.width() * points).map(|_| random.next() - 0.5).collect();
        Self { grid, points: positions, gradient, exponent: 40, limit: 1.0 }
    }

    pub fn run(&self, device: &Device) -> Outputs {
        let stride = self.points.len() + 3;
        let mut position = vec![f32::NAN; POINT_ROWS as usize * stride];
        for (column, point) in self.points.iter().enumerate() {
            for (axis, &x) in point.iter().enumerate() {
                let x = Split::new(x, 0.0);
                position[axis * stride + column] = x.coarse;
                position[(axis + 3) * stride + column] = x.fine;
            }
        }
        let mut rows = vec![f32::NAN; FIRST_ROW as usize * stride];
        for row in self.gradient.chunks(self.points.len()) {
            rows.extend(row);
            rows.extend([f32::NAN; 3]);
        }
        let levels = self.grid.levels_for_kernels();
        let values = self.grid.entries() * self.grid.features as usize;
        let scale = 2_f32.powi(self.exponent);
        let scale = device.upload("scale", &[scale, 1.0 / scale, self.limit]).unwrap();
        let sum = device.zeros("sum", 2 * values).unwrap();
        let touched = device.zeros("touched", values.div_ceil(FLAG_BLOCK as usize)).unwrap();
        let status = device.zeros("status", 1).unwrap();
        let kernel = HashGridBackwardKernel {
            params: HashGridParams {
                points: self.points.len() as u32,
                stride: stride as u32,
                first_row: FIRST_ROW,
                features: self.grid.features,
                smoothstep: u32::from(self.grid.interpolation == Interpolation::Smoothstep),
                // one chunk
                chunk: 1 << 20,
                point_rows: POINT_ROWS,
                rows: 0,
            },
            levels: &device.upload("levels", &levels).unwrap(),
            position: &device.upload("position", &position).unwrap(),
            feature_gradient: &device.upload("gradient", &rows).unwrap(),
            scale: &scale,
            sum: &sum,
            touched: &touched,
            status: &status,
        };
        device.run(&kernel, self.points.len() as u32, levels.len() as u32).unwrap();
        let words = device.read(&sum).unwrap();
        let gradient = device.upload("gradient", &vec![0.25; values]).unwrap();
        let kernel = HashGridGradientKernel {
            params: HashGridGradientParams { values: values as u32 },
            scale: &scale,
            touched: &touched,
            sum: &sum,
            gradient: &gradient,
        };
        device.run(&kernel, values as u32, 1).unwrap();
        assert!(device.read(&sum).unwrap().iter().all(|&word| word == 0), "sums are not cleared");
        Outputs {
            sum: words
                .chunks(2)
                .map(|w| (u64::from(w[1]) << 32 | u64::from(w[0])) as i64)
                .collect(),
            touched: device.read(&touched).unwrap(),
            status: device.read(&status).unwrap()[0],
            gradient: device.read(&gradient).unwrap().iter().map(|value| value - 0.25).collect(),
        }
    }

    /// `sum_points sum_features dL/dfeature feature(table)`, in f64.
    fn loss(&self, table: &[f64]) -> f64 {
        let features = self.grid.features as usize;
        let levels = self.grid.levels_geometry();
        let mut loss = 0.0;
        for (index, level) in levels.iter().enumerate() {
            for (column, point) in self.points.iter().enumerate() {
                for (entry, weight) in corners(level, *point, self.grid.interpolation) {
                    for f in 0..features {
                        let row = (index * features + f) * self.points.len();
                        let gradient = f64::from(self.gradient[row + column]);
                        loss += gradient * weight * table[entry * features + f];
                    }
                }
            }
        }
        loss
    }
}

/// The entries and weights of a point's cell, as conventions.md has them.
fn corners(
    level: &GridLevelGeometry,
    point: [f32; 3],
    interpolation: Interpolation,
) -> [(usize, f64); 8] {
    let place = point.map(|x| f64::from(x).clamp(0.0, 1.0) * level.scale + 0.5);
    std::array::from_fn(|corner| {
        let (mut weight, mut at) = (1.0, [0_u32; 3]);
        for axis in 0..3 {
            let upper = corner >> axis & 1 == 1;
            let t = place[axis].fract();
            let t = match interpolation {
                Interpolation::Linear => t,
                Interpolation::Smoothstep => t * t * (3.0 - 2.0 * t),
            };
            weight *= if upper { t } else { 1.0 - t };
            at[axis] = place[axis] as u32 + u32::from(upper);
        }
        let [x, y, z] = at;
        let index = if level.hashed {
            x ^ y.wrapping_mul(2_654_435_761) ^ z.wrapping_mul(805_459_861)
        } else {
            x + level.resolution * (y + level.resolution * z)
        };
        ((level.first + index % level.count) as usize, weight)
    })
}

/// All ways to run a kernel: the CPU's instruction sets, with one thread and with several, and the GPU's paths.
pub fn all() -> Vec<(String, Device)> {
    let mut all = vec![("one thread".to_owned(), devices::cpu(Some(1)))];
    all.push(("five threads".to_owned(), devices::cpu(Some(5))));
    let checked = DeviceOptions { check_races: true, ..DeviceOptions::cpu(None) };
    all.push(("checked".to_owned(), organza::open_device(&checked).unwrap()));
    all.extend(devices::cpus().into_iter().map(|(name, device)| (name.to_owned(), device)));
    let gpus = devices::all().into_iter().filter(|(name, _)| *name != "cpu");
    all.extend(gpus.map(|(name, device)| (name.to_owned(), device)));
    all
}

#[test]
fn it_is_that_of_central_differences() {
    for (features, interpolation) in
        [(1, Interpolation::Linear), (2, Interpolation::Smoothstep), (4, Interpolation::Linear)]
    {
        let mut inputs = Inputs::random(grid(features, interpolation), 70);
        // off the binary fractions
        for x in inputs.points.as_flattened_mut() {
            *x += 0.000_317;
        }
        let values = inputs.grid.entries() * features as usize;
        let mut table = vec![0.0; values];
        let exact: Vec<_> = (0..values)
            .map(|value| {
                table[value] = 1e-3;
                let above = inputs.loss(&table);
                table[value] = -1e-3;
                let below = inputs.loss(&table);
                table[value] = 0.0;
                (above - below) / 2e-3
            })
            .collect();
        for (name, device) in all() {
            let found = inputs.run(&device);
            assert_eq!(found.status, 0);
            let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>();
            let pairs = exact.iter().zip(&found.gradient);
            let error = norm(&mut pairs.map(|(exact, &found)| exact - f64::from(found)));
            let error = (error / norm(&mut exact.iter().copied())).sqrt();
            println!("{name}, {features} features, {interpolation:?}: {error:.1e}");
            assert!(error < 1e-5, "{name}: {error:e}");
        }
    }
}

#[test]
fn every_device_has_the_same_sums() {
    for interpolation in [Interpolation::Linear, Interpolation::Smoothstep] {
        for points in [1, 63, 64, 65, 1000] {
            // a scale of whole numbers keeps positions on binary fractions
            let mut config = grid(2, interpolation);
            (config.base_resolution, config.growth) = (5.0, 1.0);
            let mut inputs = Inputs::random(config, points);
            for (index, gradient) in inputs.gradient.iter_mut().enumerate() {
                let zeros = [0.0, -0.0, 1e-39, -1e-39];
                *gradient = if index % 7 < 4 { zeros[index % 7] } else { *gradient };
            }
            let expected = inputs.run(&devices::cpu(Some(1)));
            for (name, device) in all() {
                let found = inputs.run(&device);
                assert!(found.sum == expected.sum, "{name}, {points} points");
                assert!(found.touched == expected.touched, "{name}, {points} points");
            }
        }
    }
}

#[test]
fn threads_and_instruction_sets_change_no_bit() {
    let mut inputs = Inputs::random(grid(2, Interpolation::Smoothstep), 5000);
    for x in inputs.points.as_flattened_mut() {
        *x += 0.000_317;
    }
    let expected = inputs.run(&devices::cpu(Some(1)));
    for (name, device) in devices::cpus() {
        assert!(inputs.run(&device) == expected, "{name}");
    }
}

#[test]
fn zero_gradients_touch_nothing() {
    let mut inputs = Inputs::random(grid(2, Interpolation::Linear), 100);
    for (index, gradient) in inputs.gradient.iter_mut().enumerate() {
        *gradient = [0.0, -0.0, 1e-39, -1e-39][index % 4];
    }
    for (name, device) in all() {
        let found = inputs.run(&device);
        assert!(found.touched.iter().all(|&flag| flag == 0), "{name}");
        assert!(found.sum.iter().all(|&sum| sum == 0), "{name}");
        assert_eq!(found.status, 0, "{name}");
    }
    // a single point: its eight corners alone
    inputs.gradient[17] = 0.5;
    for (name, device) in all() {
        let found = inputs.run(&device);
        let places = found.sum.iter().enumerate().filter(|(_, sum)| **sum != 0);
        let places: Vec<_> = places.map(|(place, _)| place).collect();
        assert!((1..=8).contains(&places.len()), "{name}: {places:?}");
        for (block, &flag) in found.touched.iter().enumerate() {
            let is_touched = places.iter().any(|place| place / FLAG_BLOCK as usize == block);
            // a corner of weight zero is touched, too
            assert!(flag == 1 || !is_touched, "{name}");
        }
    }
}

#[test]
fn points_that_collide_add_up() {
    let mut one = Inputs::random(grid(2, Interpolation::Linear), 1);
    one.points[0] = [0.3, 0.6, 0.45];
    one.gradient.iter_mut().enumerate().for_each(|(row, value)| *value = 0.1 + row as f32);
    one.limit = 100.0;
    let mut many = Inputs::random(one.grid.clone(), 777);
    many.limit = 100.0;
    many.points.fill(one.points[0]);
    many.gradient = one.gradient.iter().flat_map(|&value| [value; 777]).collect();
    for (name, device) in all() {
        let (one, many) = (one.run(&device), many.run(&device));
        assert!(one.sum.iter().any(|&sum| sum != 0));
        let sums = one.sum.iter().zip(&many.sum);
        sums.for_each(|(one, many)| assert_eq!(777 * one, *many, "{name}"));
    }
}

#[test]
fn what_is_no_number_is_left_out_and_told() {
    let clean = Inputs::random(grid(2, Interpolation::Linear), 100);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1.01, -1.01] {
        let mut inputs = Inputs::random(clean.grid.clone(), 100);
        let mut without = Inputs::random(clean.grid.clone(), 100);
        inputs.gradient[130] = bad;
        // both features of the point's level
        (without.gradient[30], without.gradient[130]) = (0.0, 0.0);
        for (name, device) in all() {
            let (found, expected) = (inputs.run(&device), without.run(&device));
            assert_eq!(found.status, STATUS_LIMIT, "{name}: {bad}");
            assert!(found.sum == expected.sum, "{name}: {bad}");
        }
    }
}
