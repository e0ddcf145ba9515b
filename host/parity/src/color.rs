//! Cases of `color_inputs` and `color_head`.

use glam::Vec3;
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::color::{
    ColorHeadKernel, ColorHeadParams, ColorInputsKernel, ColorInputsParams,
};
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::unit_cube::SceneBox;

use super::dense::Layer;
use super::exact::numeric::sigmoid;
use super::exact::spherical_harmonics::{direction, harmonics};
use super::exact::unit_cube::{contract, unit};
use super::project;

/// Boxes around the origin, far from it and small, and large.
pub const BOXES: [[[f64; 3]; 2]; 3] = [
    [[-1.5; 3], [1.5; 3]],
    [[10.0, 10.0, -10.3], [10.3, 10.3, -10.0]],
    [[-317.3, -0.5, 0.0], [511.9, 0.5, 1000.0]],
];

/// Pairs before the chunk.
const FIRST_PAIR: u32 = 2;

/// Adds the coarse and the fine parts of an output, points of `[6, stride]`. Returns the rows behind them.
pub fn joined(output: &mut Output, stride: usize) -> Vec<f64> {
    let point = output.floats();
    let parts = |axis: usize| {
        let coarse = &point[axis * stride..][..stride];
        let fine = &point[(axis + 3) * stride..][..stride];
        coarse.iter().zip(fine).map(|(coarse, fine)| coarse + fine)
    };
    let sums = Values::Float((0..3).flat_map(parts).collect());
    let rest = point[POINT_ROWS as usize * stride..].to_vec();
    output.values = sums;
    rest
}

/// Inputs of `color_inputs`.
#[derive(Clone)]
pub struct ColorInputs {
    /// Pairs of the chunk; two others lie before them.
    pub pairs: u32,
    /// `camera * gaussians + gaussian`
    pub pair: Vec<u32>,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// The cameras.
    pub cameras: Vec<Camera>,
    /// The scene's box.
    pub aabb: [[f64; 3]; 2],
    /// Whether what lies outside is contracted.
    pub is_contracted: bool,
    /// `[gaussians, 3]`
    pub position: Vec<f32>,
    /// `[gaussians, 3]`
    pub material: Vec<f32>,
    /// Degree of the harmonics.
    pub degree: u32,
    /// Distance of two rows.
    pub stride: u32,
}

impl ColorInputs {
    fn new(pairs: u32, fill: Fill, degree: u32, aabb: [[f64; 3]; 2], random: &mut Random) -> Self {
        let gaussians = 50;
        let cameras = project::cameras(random);
        let slots = gaussians * cameras.len() as u32;
        let low = aabb[0].iter().fold(f64::MAX, |a, &b| a.min(b)) as f32;
        let high = aabb[1].iter().fold(f64::MIN, |a, &b| a.max(b)) as f32;
        Self {
            pairs,
            // the last pair there is, and any
            pair: (0..pairs + FIRST_PAIR)
                .map(|i| if i % 7 == 6 { slots - 1 } else { random.below(slots) })
                .collect(),
            gaussians,
            cameras,
            aabb,
            is_contracted: false,
            position: fill.values(random, 3 * gaussians as usize, [low - 0.2, high + 0.2], 1e30),
            material: fill.values(random, 3 * gaussians as usize, [-1.0, 1.0], 3e38),
            degree,
            stride: pairs + 3,
        }
    }

    /// Camera and Gaussian of a column.
    pub fn camera_and_gaussian(&self, column: usize) -> (&Camera, Vec3, usize) {
        let slot = self.pair[FIRST_PAIR as usize + column] as usize;
        let gaussian = slot % self.gaussians as usize;
        let center = Vec3::from_slice(&self.position[3 * gaussian..]);
        (&self.cameras[slot / self.gaussians as usize], center, gaussian)
    }

    /// Values of the harmonics.
    pub fn sh_rows(&self) -> usize {
        (self.degree as usize + 1).pow(2)
    }
}

impl Parity for ColorInputs {
    const KERNEL: &'static str = "color_inputs";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "harmonics: a recurrence of `degree` steps with square roots and \
        divisions of 3 ulp; points: two f32 know 1e-9, one where drivers regroup or space is contracted";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 3, BOXES[0], random));
        for degree in 0..=7 {
            for (index, aabb) in BOXES.into_iter().enumerate() {
                let mut random = Random::new(u64::from(degree));
                let set = Self::new(ITEMS, Fill::Random, degree, aabb, &mut random);
                sets.push((format!("degree {degree}, box {index}"), set));
            }
        }
        for (index, aabb) in BOXES.into_iter().enumerate() {
            let mut set = Self::new(ITEMS, Fill::Random, 1, aabb, &mut Random::new(10));
            set.is_contracted = true;
            // up to 1e6 boxes away
            let far = [1.0, 1.0, 1.0, 3.0, 1e2, 1e6].into_iter().cycle();
            set.position.chunks_mut(3).zip(far).for_each(|(position, far)| {
                position.iter_mut().for_each(|x| *x *= far);
            });
            sets.push((format!("contracted, box {index}"), set));
        }
        let mut set = Self::new(ITEMS, Fill::Random, 7, BOXES[0], &mut Random::new(9));
        // the camera within a Gaussian has no direction
        set.position[..3].copy_from_slice(&set.cameras[0].eye.to_array());
        set.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let stride = self.stride as usize;
        let cameras: Vec<_> = self.cameras.iter().flat_map(Camera::pack).collect();
        let kernel = ColorInputsKernel {
            params: ColorInputsParams {
                pairs: self.pairs,
                first_pair: FIRST_PAIR,
                stride: self.stride,
                gaussians: self.gaussians,
                sh_degree: self.degree,
                material: 3,
                // a row between them belongs to the grid
                material_row: self.sh_rows() as u32 + 1,
                contracted: u32::from(self.is_contracted),
            },
            pair: &self.pair,
            camera: &cameras,
            scene_box: &SceneBox::new(self.aabb, self.is_contracted).pack().to_vec(),
            position: &self.position,
            material: &self.material,
            point: &unwritten(POINT_ROWS as usize * stride),
            input: &unwritten((self.sh_rows() + 4) * stride),
        };
        let mut outputs = runner.run(&kernel, self.pairs, 1)?;
        joined(&mut outputs[0], stride);
        Ok(outputs)
    }

    fn bound(&self, cpu: &Output, index: usize, rounding: Rounding) -> Bound {
        let row = index / self.stride as usize;
        let column = index % self.stride as usize;
        let is_of_grid = cpu.name == "input" && row == self.sh_rows();
        if column >= self.pairs as usize || is_of_grid {
            return Bound::EXACT;
        }
        if cpu.name == "input" {
            // a material is copied, but a GPU may flush it; band 0 is a constant
            let is_sh = row < self.sh_rows();
            let band = (row as f64).sqrt().floor();
            let harmonic = if row == 0 { 0.06 } else { 1.0 + band };
            return Bound::relative_to(if is_sh { harmonic } else { 0.0 });
        }
        let x = cpu.floats()[index].abs();
        let (_, center, _) = self.camera_and_gaussian(column);
        if self.is_contracted {
            // of the farthest axis, which decides how near all come
            let apart = |axis: usize| {
                let world = f64::from(center[axis].abs()) + self.aabb[0][axis].abs();
                world / (self.aabb[1][axis] - self.aabb[0][axis])
            };
            return Bound::relative_to(match rounding {
                Rounding::AsWritten => 0.5,
                Rounding::Regrouped => 0.5 + (0..3).map(apart).fold(0.0, f64::max),
            });
        }
        let extent = (self.aabb[1][row] - self.aabb[0][row]) / 0.9;
        let world = f64::from(center[row].abs()) + self.aabb[0][row].abs();
        let scale = match rounding {
            Rounding::AsWritten if x < 2.0 => 1e-3,
            Rounding::AsWritten => x,
            Rounding::Regrouped => 0.5 * (1.0 + x + world / extent),
        };
        Bound::relative_to(scale)
    }

    /// A Gaussian at the camera has no direction, nor has one so far away that the squared distance overflows an f32.
    /// Then only band 0 is known.
    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        let stride = self.stride as usize;
        let mut exact = vec![None; len];
        for column in 0..self.pairs as usize {
            let (camera, center, gaussian) = self.camera_and_gaussian(column);
            let eye = camera.eye.as_dvec3();
            let has_direction = (1e-15..1e18).contains(&center.as_dvec3().distance(eye));
            let eye = eye.to_array();
            let center = center.as_dvec3().to_array();
            let mut give = |row: usize, value| exact[row * stride + column] = Some(value);
            match output {
                "point" => {
                    let point = unit(center, self.aabb, self.is_contracted);
                    let point = if self.is_contracted { contract(point) } else { point };
                    point.into_iter().enumerate().for_each(|(row, x)| give(row, x));
                }
                "input" => {
                    let degree = if has_direction { self.degree } else { 0 };
                    let harmonics = harmonics(degree, direction(eye, center));
                    harmonics.into_iter().enumerate().for_each(|(row, y)| give(row, y));
                    for (row, &value) in self.material[3 * gaussian..][..3].iter().enumerate() {
                        give(self.sh_rows() + 1 + row, f64::from(value));
                    }
                }
                _ => {}
            }
        }
        exact
    }
}

/// Inputs of `color_head`.
#[derive(Clone, Debug)]
pub struct ColorHead {
    /// The last layer: one column.
    pub layer: Layer,
}

impl Parity for ColorHead {
    const KERNEL: &'static str = "color_head";
    const TOLERANCE: f64 = 4e-7;
    const WHY: &'static str = "a logit is off by roundings of its terms' sizes M, a sigmoid by as \
        much relatively, and by exp's 3 + 2 abs(x) ulp";

    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self { layer: Layer::new(n, 16, 1, fill, random) });
        for size in [0.01, 10.0, 50.0, 1e4] {
            sets.push((format!("logits of {size}"), Self { layer: layer_of_size(size) }));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let params = layer.params();
        let kernel = ColorHeadKernel {
            params: ColorHeadParams {
                samples: layer.samples,
                first_pair: FIRST_PAIR,
                stride: layer.stride,
                inputs: layer.inputs,
                weight: params.weight,
                bias: params.bias,
            },
            parameters: &layer.parameters,
            input: &layer.input,
            color: &unwritten(3 * (FIRST_PAIR + layer.samples) as usize),
        };
        runner.run(&kernel, layer.samples, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let Some(at) = index.checked_sub(3 * FIRST_PAIR as usize) else {
            return Bound::EXACT;
        };
        let sample = (at / 3) as u32;
        let channel = (at % 3) as u32;
        let Bound { scale: terms, floor } = self.layer.bound(sample, channel);
        let color = cpu.floats()[index];
        // where the logit itself is lost, so is the color
        let is_lost = terms * Self::TOLERANCE > 0.1;
        let scale = if is_lost { 1.0 / Self::TOLERANCE } else { color * (1.0 + 3.0 * terms) };
        Bound { scale, floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let at = index.checked_sub(3 * FIRST_PAIR as usize)? as u32;
        Some(sigmoid(self.layer.exact(at / 3, at % 3)))
    }
}

/// A head whose logits are about as large as `size`, of both signs, and none of which cancels.
pub fn layer_of_size(size: f32) -> Layer {
    let mut layer = Layer::new(ITEMS, 16, 1, Fill::Random, &mut Random::new(5));
    for row in &mut layer.parameters {
        *row = row.abs() * size / 8.0;
    }
    for (at, value) in layer.input.iter_mut().enumerate() {
        let is_negative = (at as u32 % layer.stride).is_multiple_of(2);
        *value = if is_negative { -value.abs() } else { value.abs() };
    }
    layer
}
