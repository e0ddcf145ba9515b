//! The case of `segment`.

use glam::{DVec3, Vec3};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::limits::MAX_SAMPLES;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentInputs, SegmentParams};
use organza_shaders::unit_cube::SceneBox;

use super::color::BOXES;
use super::exact::segment::{self as exact, ContractedRay};
use super::exact::unit_cube::unit;
use super::project;

/// How far from a decision of the kernel the inputs stay, relative to the ray.
const AWAY: f64 = 2e-5;

/// Rays up to this size have places and points of two parts.
const NEAR: f64 = 8.0;

/// The cameras and the box are those of the inputs.
#[derive(Clone)]
pub struct Segment {
    cameras: Vec<Camera>,
    aabb: [[f64; 3]; 2],
    inputs: SegmentInputs,
}

/// A ray in the unit cube's space, and where it lies in the cube, in f64.
#[derive(Clone, Copy, Debug)]
struct Ray {
    /// The Gaussian.
    p: DVec3,
    /// To the camera.
    v: DVec3,
    /// The last entry into a pair of planes, and the first exit.
    planes: [f64; 2],
}

impl Ray {
    fn new(p: [f64; 3], eye: [f64; 3]) -> Self {
        let v = [0, 1, 2].map(|axis| eye[axis] - p[axis]);
        Self { p: p.into(), v: v.into(), planes: exact::planes(p, v) }
    }

    /// The length within the cube, before and after the ray's own ends.
    fn length(&self) -> f64 {
        let [_, lambda] = exact::clip(self.planes);
        lambda * self.v.length()
    }

    /// Whether rounding decides if the ray meets the cube, or how many steps it has.
    fn is_undecided(&self, step: f64) -> bool {
        let size = self.p.length() + self.v.length();
        if self.v == DVec3::ZERO {
            return false;
        }
        // a coordinate on a plane that the ray runs along, or that the box's rounding may move over it
        let grazes = (0..3).any(|axis| {
            let p = self.p[axis];
            let v = self.v[axis];
            v.abs() < AWAY * size && p.abs().min((p - 1.0).abs()) < AWAY * (1.0 + p.abs())
        });
        let [enter, exit] = self.planes;
        let misses = enter > exit + AWAY || enter > 1.0 + AWAY || exit < -AWAY;
        if misses || grazes {
            return grazes;
        }
        let steps = self.length() / step;
        let slack = AWAY * size / step + AWAY * steps;
        let is_capped = steps - slack > f64::from(MAX_SAMPLES);
        let nearest = (steps - steps.round()).abs();
        // between one and none lies the corner that a ray cuts off
        let is_whole = nearest <= slack && steps.round() >= 1.0;
        self.length() <= AWAY * size || (is_whole && !is_capped)
    }
}

impl Segment {
    fn new(
        pairs: u32,
        fill: Fill,
        step: f32,
        (aabb, is_contracted): ([[f64; 3]; 2], bool),
        random: &mut Random,
    ) -> Self {
        let gaussians = 60;
        let mut cameras = project::cameras(random);
        let middle = [0, 1, 2].map(|axis| ((aabb[0][axis] + aabb[1][axis]) / 2.0) as f32);
        // one within the box
        cameras[1].eye = Vec3::from_array(middle) + Vec3::splat(0.013);
        let position = (0..3 * gaussians).map(|at| {
            let axis = at as usize % 3;
            let low = aabb[0][axis] as f32;
            let high = aabb[1][axis] as f32;
            // far behind the box, and beside it
            let far = [0.0, 0.0, 3.0, 100.0][at as usize / 3 % 4];
            let margin = if is_contracted { far } else { 0.3 } * (high - low);
            fill.values(random, 1, [low - margin, high + margin], 1e30)[0]
        });
        let inputs = SegmentInputs {
            params: SegmentParams { pairs: 0, gaussians, step, contracted: is_contracted.into() },
            pair: Vec::new(),
            camera: cameras.iter().flat_map(Camera::pack).collect(),
            scene_box: SceneBox::new(aabb, is_contracted).pack().to_vec(),
            position: position.collect(),
            segment: Vec::new(),
            count: Vec::new(),
        };
        let mut set = Self { cameras, aabb, inputs };
        let slots = 0..gaussians * set.cameras.len() as u32;
        let decided: Vec<u32> = slots.filter(|&slot| !set.is_undecided(slot)).collect();
        let pairs = if decided.is_empty() { 0 } else { pairs };
        let some = |_| decided[random.below(decided.len() as u32) as usize];
        set.inputs.params.pairs = pairs;
        set.inputs.pair = (0..pairs).map(some).collect();
        set.inputs.segment = unwritten((SEGMENT_VECTORS * pairs) as usize);
        set.inputs.count = unwritten(pairs as usize);
        set
    }

    fn is_contracted(&self) -> bool {
        self.inputs.params.contracted == 1
    }

    fn step(&self) -> f64 {
        self.inputs.params.step.into()
    }

    /// The place of a pair's Gaussian.
    fn position(&self, slot: u32) -> DVec3 {
        let gaussian = (slot % self.inputs.params.gaussians) as usize;
        Vec3::from_slice(&self.inputs.position[3 * gaussian..]).as_dvec3()
    }

    /// A pair's Gaussian and camera in the unit cube's space.
    fn ends(&self, slot: u32) -> [[f64; 3]; 2] {
        let eye = self.cameras[(slot / self.inputs.params.gaussians) as usize].eye.as_dvec3();
        [self.position(slot), eye]
            .map(|point| unit(point.to_array(), self.aabb, self.is_contracted()))
    }

    fn contracted_ray(&self, slot: u32) -> ContractedRay {
        let [p, eye] = self.ends(slot);
        exact::contracted_ray(p, eye, self.step())
    }

    /// Whether rounding decides on the steps of a pair.
    fn is_undecided(&self, slot: u32) -> bool {
        let step = self.step();
        if !self.is_contracted() {
            return self.ray(slot).is_undecided(step);
        }
        let steps = self.contracted_ray(slot).length / step;
        let slack = AWAY * self.contracted_size(slot) / step + AWAY * steps;
        let is_capped = steps - slack > f64::from(MAX_SAMPLES);
        !is_capped && (slack > 0.3 || (steps - steps.round()).abs() <= slack)
    }

    /// The size of the numbers of a contracted ray. The shorter the ray, the less exact is its direction.
    fn contracted_size(&self, slot: u32) -> f64 {
        let ray = self.ray(slot);
        let size = 1.0 + ray.p.length() + (ray.p + ray.v).length();
        size * (1.0 + size / ray.v.length())
    }

    /// The error of a coordinate in the box by drivers that regroup: 6e-8 of its size in world space.
    fn world(&self, slot: u32) -> f64 {
        let position = self.position(slot).abs();
        let world = (0..3).map(|axis| {
            let extent = self.aabb[1][axis] - self.aabb[0][axis];
            (position[axis] + self.aabb[0][axis].abs()) / extent
        });
        world.fold(0.0, f64::max)
    }

    /// The ray of a pair.
    fn ray(&self, slot: u32) -> Ray {
        let [p, eye] = self.ends(slot);
        Ray::new(p, eye)
    }
}

/// Coarse and fine parts of `[pairs, 4]` segments, added: s and `s_factor`, w and 0.
fn joined(segment: &[f64]) -> Vec<f64> {
    let (segments, _) = segment.as_chunks::<{ 4 * SEGMENT_VECTORS as usize }>();
    let added = segments.iter().flat_map(|segment| {
        let (coarse, fine) = segment.split_at(segment.len() / 2);
        coarse.iter().zip(fine).map(|(coarse, fine)| coarse + fine)
    });
    added.collect()
}

impl Parity for Segment {
    const KERNEL: &'static str = "segment";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str = "divisions of 3 ulp: of the ray's size, and of 1/250 of it up to a size of 8, where \
        places on it have two parts; no ray within 2e-5 of its size of a whole number of steps, or of missing the cube; \
        a contracted ray is one f32 of its ends' sizes, and known the less the shorter it is";

    fn sets() -> Vec<(String, Self)> {
        let first = (BOXES[0], false);
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 0.013, first, random));
        let new =
            |step, space, seed| Self::new(ITEMS, Fill::Random, step, space, &mut Random::new(seed));
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [1.7, 0.1, 0.004] {
                sets.push((format!("step {step}, box {index}"), new(step, (aabb, false), 31)));
            }
        }
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [0.3, 0.03] {
                let name = format!("contracted, step {step}, box {index}");
                sets.push((name, new(step, (aabb, true), 34)));
            }
        }
        // steps are capped
        sets.push(("step 1e-6".into(), new(1e-6, first, 32)));
        let mut set = new(0.1, first, 33);
        set.inputs.position[..3].copy_from_slice(&set.cameras[0].eye.to_array());
        set.inputs.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let mut outputs = runner.run(&self.inputs.kernel(), self.inputs.params.pairs, 1)?;
        if !self.is_contracted() {
            outputs[0].values = Values::Float(joined(outputs[0].floats()));
        }
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |&slot: &u32| {
            if self.is_contracted() {
                let ray = self.contracted_ray(slot);
                if output == "count" {
                    return vec![Some(ray.count)];
                }
                let [begin, end] = ray.ends;
                let values = ray.foot.into_iter().chain([ray.factor]).chain(ray.direction);
                let values = values.chain([ray.radius, begin, end - begin]).chain([0.0; 6]);
                return values.map(Some).collect();
            }
            let [p, eye] = self.ends(slot);
            let found = exact::segment(p, eye, self.step());
            if output == "count" {
                return vec![Some(found.count)];
            }
            let values = found.start.into_iter().chain([found.factor]).chain(found.way);
            values.chain([0.0]).map(Some).collect()
        };
        self.inputs.pair.iter().flat_map(of).collect()
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let values = if self.is_contracted() { 16 } else { 8 };
        let slot = self.inputs.pair[index / values];
        if self.is_contracted() {
            let scale = self.contracted_size(slot) + self.world(slot);
            let steps = self.step() * self.contracted_ray(slot).count.max(1.0);
            return Bound::relative_to(if index % 16 == 3 { scale / steps } else { scale });
        }
        let ray = self.ray(slot);
        let size = 1.0 + ray.p.length() + ray.v.length();
        let scale = size + self.world(slot);
        Bound::relative_to(match rounding {
            // s_factor is L / K / sigma
            _ if index % 8 == 3 => {
                let steps = (ray.length() / self.step()).ceil().max(1.0);
                scale / (self.step() * steps.min(f64::from(MAX_SAMPLES)))
            }
            Rounding::AsWritten if size < NEAR => 4e-3 * size,
            _ => scale,
        })
    }
}
