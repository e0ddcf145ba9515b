//! Cases of `color_inputs` and `color_head`.

use glam::{DVec3, Vec3};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::color::{ColorHeadKernel, ColorInputsInputs, ColorInputsParams};
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::unit_cube::SceneBox;

use super::dense::Dense;
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

/// The cameras and the box are those of the inputs.
#[derive(Clone)]
pub struct ColorInputs {
    cameras: Vec<Camera>,
    aabb: [[f64; 3]; 2],
    inputs: ColorInputsInputs,
}

impl ColorInputs {
    fn new(pairs: u32, fill: Fill, degree: u32, aabb: [[f64; 3]; 2], random: &mut Random) -> Self {
        let gaussians = 50;
        let cameras = project::cameras(random);
        let slots = gaussians * cameras.len() as u32;
        let low = aabb[0].iter().fold(f64::MAX, |a, &b| a.min(b)) as f32;
        let high = aabb[1].iter().fold(f64::MIN, |a, &b| a.max(b)) as f32;
        let stride = pairs + 3;
        let sh_rows = (degree + 1).pow(2);
        let inputs = ColorInputsInputs {
            params: ColorInputsParams {
                pairs,
                first_pair: FIRST_PAIR,
                stride,
                gaussians,
                sh_degree: degree,
                material: 3,
                // a row between them belongs to the grid
                material_row: sh_rows + 1,
                contracted: 0,
            },
            // the last pair there is, and any
            pair: (0..pairs + FIRST_PAIR)
                .map(|i| if i % 7 == 6 { slots - 1 } else { random.below(slots) })
                .collect(),
            camera: cameras.iter().flat_map(Camera::pack).collect(),
            scene_box: SceneBox::new(aabb, false).pack().to_vec(),
            position: fill.values(random, 3 * gaussians as usize, [low - 0.2, high + 0.2], 1e30),
            material: fill.values(random, 3 * gaussians as usize, [-1.0, 1.0], 3e38),
            point: unwritten((POINT_ROWS * stride) as usize),
            input: unwritten(((sh_rows + 4) * stride) as usize),
        };
        Self { cameras, aabb, inputs }
    }

    /// The same with contracted space, and Gaussians up to 1e6 boxes away.
    fn contracted(mut self) -> Self {
        self.inputs.params.contracted = 1;
        self.inputs.scene_box = SceneBox::new(self.aabb, true).pack().to_vec();
        let far = [1.0, 1.0, 1.0, 3.0, 1e2, 1e6].into_iter().cycle();
        self.inputs.position.chunks_mut(3).zip(far).for_each(|(position, far)| {
            position.iter_mut().for_each(|x| *x *= far);
        });
        self
    }

    /// Camera and Gaussian of a column: their places, and its number.
    fn ends(&self, column: usize) -> ([DVec3; 2], usize) {
        let slot = self.inputs.pair[FIRST_PAIR as usize + column];
        let gaussian = (slot % self.inputs.params.gaussians) as usize;
        let center = Vec3::from_slice(&self.inputs.position[3 * gaussian..]);
        let eye = self.cameras[(slot / self.inputs.params.gaussians) as usize].eye;
        ([eye, center].map(|place| place.as_dvec3()), gaussian)
    }

    /// Values of the harmonics.
    fn sh_rows(&self) -> usize {
        (self.inputs.params.sh_degree as usize + 1).pow(2)
    }

    fn is_contracted(&self) -> bool {
        self.inputs.params.contracted == 1
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
            let set = Self::new(ITEMS, Fill::Random, 1, aabb, &mut Random::new(10));
            sets.push((format!("contracted, box {index}"), set.contracted()));
        }
        let mut set = Self::new(ITEMS, Fill::Random, 7, BOXES[0], &mut Random::new(9));
        // the camera within a Gaussian has no direction
        set.inputs.position[..3].copy_from_slice(&set.cameras[0].eye.to_array());
        set.inputs.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let ColorInputsParams { pairs, stride, .. } = self.inputs.params;
        let mut outputs = runner.run(&self.inputs.kernel(), pairs, 1)?;
        joined(&mut outputs[0], stride as usize);
        Ok(outputs)
    }

    fn bound(&self, cpu: &Output, index: usize, rounding: Rounding) -> Bound {
        let ColorInputsParams { pairs, stride, .. } = self.inputs.params;
        let row = index / stride as usize;
        let column = index % stride as usize;
        let is_of_grid = cpu.name == "input" && row == self.sh_rows();
        if column >= pairs as usize || is_of_grid {
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
        let ([_, center], _) = self.ends(column);
        let world = |axis: usize| center[axis].abs() + self.aabb[0][axis].abs();
        let extent = |axis: usize| self.aabb[1][axis] - self.aabb[0][axis];
        if self.is_contracted() {
            // of the farthest axis, which decides how near all come
            let apart = |axis: usize| world(axis) / extent(axis);
            return Bound::relative_to(match rounding {
                Rounding::AsWritten => 0.5,
                Rounding::Regrouped => 0.5 + (0..3).map(apart).fold(0.0, f64::max),
            });
        }
        Bound::relative_to(match rounding {
            Rounding::AsWritten if x < 2.0 => 1e-3,
            Rounding::AsWritten => x,
            Rounding::Regrouped => 0.5 * (1.0 + x + world(row) / (extent(row) / 0.9)),
        })
    }

    /// A Gaussian at the camera has no direction, nor has one so far away that the squared distance overflows an f32.
    /// Then only band 0 is known.
    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        let ColorInputsParams { pairs, stride, sh_degree, .. } = self.inputs.params;
        let stride = stride as usize;
        let mut exact = vec![None; len];
        for column in 0..pairs as usize {
            let ([eye, center], gaussian) = self.ends(column);
            let has_direction = (1e-15..1e18).contains(&center.distance(eye));
            let [eye, center] = [eye, center].map(|place| place.to_array());
            let mut give = |row: usize, value| exact[row * stride + column] = Some(value);
            match output {
                "point" => {
                    let point = unit(center, self.aabb, self.is_contracted());
                    let point = if self.is_contracted() { contract(point) } else { point };
                    point.into_iter().enumerate().for_each(|(row, x)| give(row, x));
                }
                "input" => {
                    let degree = if has_direction { sh_degree } else { 0 };
                    let harmonics = harmonics(degree, direction(eye, center));
                    harmonics.into_iter().enumerate().for_each(|(row, y)| give(row, y));
                    for (row, &value) in
                        self.inputs.material[3 * gaussian..][..3].iter().enumerate()
                    {
                        give(self.sh_rows() + 1 + row, f64::from(value));
                    }
                }
                _ => {}
            }
        }
        exact
    }
}

/// The last layer has one column.
#[derive(Clone)]
pub struct ColorHead(Dense);

impl Parity for ColorHead {
    const KERNEL: &'static str = "color_head";
    const TOLERANCE: f64 = 4e-7;
    const WHY: &'static str = "a logit is off by roundings of its terms' sizes M, a sigmoid by as \
        much relatively, and by exp's 3 + 2 abs(x) ulp";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self(Dense::new(n, 16, 1, fill, random)));
        for size in [0.01, 10.0, 50.0, 1e4] {
            sets.push((format!("logits of {size}"), Self(layer_of_size(size))));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let samples = self.0.params.samples;
        let kernel = ColorHeadKernel {
            params: self.0.head_params(FIRST_PAIR),
            parameters: &self.0.parameters,
            input: &self.0.input,
            color: &unwritten(3 * (FIRST_PAIR + samples) as usize),
        };
        runner.run(&kernel, samples, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let at = (index as u32).checked_sub(3 * FIRST_PAIR);
        let Some(at) = at else { return Bound::EXACT };
        let Bound { scale: terms, floor } = self.0.sum_bound(at / 3, at % 3);
        let color = cpu.floats()[index];
        // where the logit itself is lost, so is the color
        let is_lost = terms * Self::TOLERANCE > 0.1;
        let scale = if is_lost { 1.0 / Self::TOLERANCE } else { color * (1.0 + 3.0 * terms) };
        Bound { scale, floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let at = index.checked_sub(3 * FIRST_PAIR as usize)? as u32;
        Some(sigmoid(self.0.sum(at / 3, at % 3)))
    }
}

/// A head whose logits are about as large as `size`, of both signs, and none of which cancels.
pub fn layer_of_size(size: f32) -> Dense {
    let mut layer = Dense::new(ITEMS, 16, 1, Fill::Random, &mut Random::new(5));
    layer.parameters.iter_mut().for_each(|row| *row = row.abs() * size / 8.0);
    let stride = layer.params.stride;
    for (at, value) in layer.input.iter_mut().enumerate() {
        let is_negative = (at as u32 % stride).is_multiple_of(2);
        *value = if is_negative { -value.abs() } else { value.abs() };
    }
    layer
}
