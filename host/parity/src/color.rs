//! Cases of `color_inputs` and `color_head`.

use glam::DVec3;
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::color::{ColorHeadInputs, ColorInputsInputs, ColorInputsParams};
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::unit_cube::SceneBox;

use super::dense::Dense;
use super::exact::numeric::row;
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

// the cameras and the box that the inputs are made of
case!(pub ColorInputs(ColorInputsInputs) { cameras: Vec<Camera>, aabb: [[f64; 3]; 2] });

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
        self.params.contracted = 1;
        self.scene_box = SceneBox::new(self.aabb, true).pack().to_vec();
        let far = [1.0, 1.0, 1.0, 3.0, 1e2, 1e6].into_iter().cycle();
        self.position.chunks_mut(3).zip(far).for_each(|(position, far)| {
            position.iter_mut().for_each(|x| *x *= far);
        });
        self
    }

    /// The values of an output, and the errors of coordinates.
    ///
    /// A Gaussian at the camera has no direction, nor has one so far away that the squared distance overflows an f32.
    /// Then only band 0 is known.
    fn known(
        &self,
        output: &str,
        len: usize,
        coordinate: impl Fn(Rounded) -> Rounded,
    ) -> Vec<Option<Rounded>> {
        let ColorInputsParams {
            pairs, stride, sh_degree, material_row, gaussians, contracted, ..
        } = self.params;
        let mut exact = vec![None; len];
        for column in 0..pairs as usize {
            let slot = self.pair[FIRST_PAIR as usize + column];
            let gaussian = (slot % gaussians) as usize;
            let center = row(&self.position, gaussian);
            let mut give = |row: usize, value: Rounded| {
                exact[row * stride as usize + column] = Some(value);
            };
            if output == "point" {
                let point = unit(center, self.aabb, contracted == 1);
                let point = if contracted == 1 { contract(point) } else { point };
                point.into_iter().enumerate().for_each(|(row, x)| give(row, coordinate(x)));
                continue;
            }
            let center = DVec3::from(center.map(|x| x.value));
            let eye = self.cameras[(slot / gaussians) as usize].eye.as_dvec3();
            let has_direction = (1e-15..1e18).contains(&center.distance(eye));
            let direction = direction(eye.to_array(), center.to_array());
            for (row, y) in harmonics(sh_degree, direction).into_iter().enumerate() {
                // a recurrence of `degree` steps with square roots and divisions of 3 ulp
                let error = 1e-6 * (1.0 + (row as f64).sqrt().floor());
                let known = Rounded::within(y, if row == 0 { 6e-8 } else { error });
                give(row, if row == 0 || has_direction { known } else { Rounded::UNKNOWN });
            }
            let material = self.material[3 * gaussian..][..3].iter().enumerate();
            material.for_each(|(row, &value)| give(material_row as usize + row, value.into()));
        }
        exact
    }
}

impl Parity for ColorInputs {
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
        let eye = set.cameras[0].eye.to_array();
        set.position[..3].copy_from_slice(&eye);
        set.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let mut outputs = runner.run(&self.kernel())?;
        joined(&mut outputs[0], self.params.stride as usize);
        Ok(outputs)
    }

    /// A coordinate is two f32, or one that is contracted.
    fn exact(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        let error = |x: f64| match x.abs() {
            _ if self.params.contracted == 1 => 5e-7,
            x if x < 2.0 => 1e-9,
            x => 1e-6 * x,
        };
        let within = |x: f64| Rounded::within(x, error(x) + f64::from(TINY));
        self.known(output, len, |x| within(x.value))
    }

    /// A coordinate is one f32 of a place in the world.
    fn exact_regrouped(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        self.known(output, len, |x| x)
    }
}

// the last layer has one column
case!(pub ColorHead(ColorHeadInputs) { layer: Dense });

impl ColorHead {
    fn new(layer: Dense) -> Self {
        let inputs = ColorHeadInputs {
            params: layer.head_params(FIRST_PAIR),
            parameters: layer.parameters.clone(),
            input: layer.input.clone(),
            color: unwritten(3 * (FIRST_PAIR + layer.params.samples) as usize),
        };
        Self { inputs, layer }
    }
}

impl Parity for ColorHead {
    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self::new(Dense::new(n, 16, 1, fill, random)));
        for size in [0.01, 10.0, 50.0, 1e4] {
            sets.push((format!("logits of {size}"), Self::new(layer_of_size(size))));
        }
        sets
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let at = index.checked_sub(3 * FIRST_PAIR as usize)? as u32;
        Some(self.layer.sum(at / 3, at % 3).sigmoid())
    }
}

/// A head with logits of about `size`, of both signs. The terms of a logit do not cancel.
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
