//! Cases of `color_inputs` and `color_head`.

use glam::Vec3;
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::color::{ColorHeadInputs, ColorInputsInputs, ColorInputsParams};
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::unit_cube::SceneBox;

use super::dense::{Dense, head_sets};
use super::exact::numeric::row;
use super::exact::spherical_harmonics::{direction, harmonic};
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
    let rest = output.values.split_off(POINT_ROWS as usize * stride);
    let fine = output.values.split_off(3 * stride);
    output.values.iter_mut().zip(fine).for_each(|(coarse, fine)| *coarse += fine);
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

    /// The Gaussian and the camera of the pair in a column; none of padding.
    fn slot(&self, column: usize) -> Option<(usize, &Camera)> {
        let slot = *self.pair.get(FIRST_PAIR as usize + column)?;
        let camera = &self.cameras[(slot / self.params.gaussians) as usize];
        Some(((slot % self.params.gaussians) as usize, camera))
    }

    /// A coordinate of a point, in one f32.
    fn coordinate(&self, index: usize) -> Option<Rounded> {
        let stride = self.params.stride as usize;
        let (gaussian, _) = self.slot(index % stride)?;
        let is_contracted = self.params.contracted == 1;
        let point = unit(row(&self.position, gaussian), self.aabb, is_contracted);
        Some(if is_contracted { contract(point) } else { point }[index / stride])
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

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        joined(&mut outputs[0], self.params.stride as usize);
        outputs
    }

    /// A coordinate is two f32, or one that is contracted.
    ///
    /// A Gaussian at the camera has no direction, nor has one so far away that the squared distance overflows an f32.
    /// Then only band 0 is known.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let ColorInputsParams { stride, sh_degree, material_row, contracted, .. } = self.params;
        if output == "point" {
            let x = self.coordinate(index)?.value;
            let error = match x.abs() {
                _ if contracted == 1 => 5e-7,
                x if x < 2.0 => 1e-9,
                x => 1e-6 * x,
            };
            return Some(Rounded::within(x, error + f64::from(TINY)));
        }
        let (gaussian, camera) = self.slot(index % stride as usize)?;
        let row = index / stride as usize;
        if let Some(at) = row.checked_sub(material_row as usize) {
            return Some(self.material[3 * gaussian + at].into());
        }
        let band = row.isqrt();
        let center = Vec3::from_slice(&self.position[3 * gaussian..]).as_dvec3();
        let eye = camera.eye.as_dvec3();
        let has_direction = (1e-15..1e18).contains(&center.distance(eye));
        let y = harmonic(row, direction(eye.to_array(), center.to_array()));
        Some(match band {
            0 => Rounded::within(y, 6e-8),
            _ if band > sh_degree as usize => return None,
            // a recurrence of `band` steps with square roots and divisions of 3 ulp
            _ if has_direction => Rounded::within(y, 1e-6 * (1.0 + band as f64)),
            _ => Rounded::UNKNOWN,
        })
    }

    /// A coordinate is one f32 of a place in the world.
    fn exact_regrouped(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        match output {
            "point" => (0..len).map(|index| self.coordinate(index)).collect(),
            _ => self.exact(output, len),
        }
    }
}

// the last layer has one column
case!(pub ColorHead(ColorHeadInputs) { layer: Dense });

impl Parity for ColorHead {
    fn sets() -> Vec<(String, Self)> {
        head_sets(|layer, _, _| {
            let inputs = ColorHeadInputs {
                params: layer.head_params(FIRST_PAIR),
                parameters: layer.parameters.clone(),
                input: layer.input.clone(),
                color: unwritten(3 * (FIRST_PAIR + layer.params.samples) as usize),
            };
            Self { inputs, layer }
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let at = index.checked_sub(3 * FIRST_PAIR as usize)? as u32;
        Some(self.layer.sum(at / 3, at % 3).sigmoid())
    }
}
