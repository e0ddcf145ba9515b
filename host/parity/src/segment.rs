//! The case of `segment`.

use glam::{DVec3, Vec3};
use muslin_check::prelude::*;
use organza_shaders::camera::Camera;
use organza_shaders::limits::MAX_SAMPLES;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentKernel, SegmentParams};
use organza_shaders::unit_cube::SceneBox;

use super::color::BOXES;
use super::exact::segment as exact;
use super::exact::unit_cube::unit;
use super::project;

/// How far from a decision of the kernel the inputs stay, relative to the ray.
const AWAY: f64 = 2e-5;

/// Rays up to this size have places and points of two parts.
const NEAR: f64 = 8.0;

/// Inputs of `segment`.
#[derive(Clone)]
pub struct Segment {
    /// `camera * gaussians + gaussian`
    pub pair: Vec<u32>,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// sigma
    pub step: f32,
    /// The cameras.
    pub cameras: Vec<Camera>,
    /// The scene's box.
    pub aabb: [[f64; 3]; 2],
    /// Whether what lies outside is contracted.
    pub is_contracted: bool,
    /// `[gaussians, 3]`
    pub position: Vec<f32>,
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
    fn new(pairs: u32, fill: Fill, step: f32, aabb: [[f64; 3]; 2], random: &mut Random) -> Self {
        Self::with(pairs, fill, step, aabb, false, random)
    }

    fn with(
        pairs: u32,
        fill: Fill,
        step: f32,
        aabb: [[f64; 3]; 2],
        is_contracted: bool,
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
        let position = position.collect();
        let mut set =
            Self { pair: Vec::new(), gaussians, step, cameras, aabb, is_contracted, position };
        let slots = gaussians * set.cameras.len() as u32;
        let decided: Vec<u32> = (0..slots).filter(|&slot| !set.is_undecided(slot)).collect();
        set.pair = match decided.len() as u32 {
            0 => Vec::new(),
            len => (0..pairs).map(|_| decided[random.below(len) as usize]).collect(),
        };
        set
    }

    /// A pair's Gaussian and camera in the unit cube's space.
    fn ends(&self, slot: u32) -> [[f64; 3]; 2] {
        let position = &self.position[3 * (slot % self.gaussians) as usize..];
        let eye = self.cameras[(slot / self.gaussians) as usize].eye;
        [Vec3::from_slice(position), eye]
            .map(|point| unit(point.as_dvec3().to_array(), self.aabb, self.is_contracted))
    }

    /// Whether rounding decides on the steps of a pair.
    fn is_undecided(&self, slot: u32) -> bool {
        let step = f64::from(self.step);
        if !self.is_contracted {
            return self.ray(slot).is_undecided(step);
        }
        let [p, eye] = self.ends(slot);
        let steps = exact::contracted_ray(p, eye, step).length / step;
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
        let position = &self.position[3 * (slot % self.gaussians) as usize..][..3];
        let world = (0..3).map(|axis| {
            let extent = self.aabb[1][axis] - self.aabb[0][axis];
            (f64::from(position[axis].abs()) + self.aabb[0][axis].abs()) / extent
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
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 0.013, BOXES[0], random));
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [1.7, 0.1, 0.004] {
                let set = Self::new(ITEMS, Fill::Random, step, aabb, &mut Random::new(31));
                sets.push((format!("step {step}, box {index}"), set));
            }
        }
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [0.3, 0.03] {
                let random = &mut Random::new(34);
                let set = Self::with(ITEMS, Fill::Random, step, aabb, true, random);
                sets.push((format!("contracted, step {step}, box {index}"), set));
            }
        }
        // steps are capped
        let set = Self::new(ITEMS, Fill::Random, 1e-6, BOXES[0], &mut Random::new(32));
        sets.push(("step 1e-6".into(), set));
        let mut set = Self::new(ITEMS, Fill::Random, 0.1, BOXES[0], &mut Random::new(33));
        set.position[..3].copy_from_slice(&set.cameras[0].eye.to_array());
        set.pair.fill(0);
        sets.push(("Gaussian at the camera".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let pairs = self.pair.len() as u32;
        let cameras: Vec<_> = self.cameras.iter().flat_map(Camera::pack).collect();
        let kernel = SegmentKernel {
            params: SegmentParams {
                pairs,
                gaussians: self.gaussians,
                step: self.step,
                contracted: u32::from(self.is_contracted),
            },
            pair: &self.pair,
            camera: &cameras,
            scene_box: &SceneBox::new(self.aabb, self.is_contracted).pack().to_vec(),
            position: &self.position,
            segment: &unwritten((SEGMENT_VECTORS * pairs) as usize),
            count: &unwritten(pairs as usize),
        };
        let mut outputs = runner.run(&kernel, pairs, 1)?;
        if !self.is_contracted {
            outputs[0].values = Values::Float(joined(outputs[0].floats()));
        }
        Ok(outputs)
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |&slot: &u32| {
            let [p, eye] = self.ends(slot);
            if self.is_contracted {
                let ray = exact::contracted_ray(p, eye, f64::from(self.step));
                if output == "count" {
                    return vec![Some(ray.count)];
                }
                let [begin, end] = ray.ends;
                let values = ray.foot.into_iter().chain([ray.factor]).chain(ray.direction);
                let values = values.chain([ray.radius, begin, end - begin]).chain([0.0; 6]);
                return values.map(Some).collect();
            }
            let found = exact::segment(p, eye, f64::from(self.step));
            if output == "count" {
                return vec![Some(found.count)];
            }
            let values = found.start.into_iter().chain([found.factor]).chain(found.way);
            values.chain([0.0]).map(Some).collect()
        };
        let exact = self.pair.iter().flat_map(of);
        exact.collect()
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let values = if self.is_contracted { 16 } else { 8 };
        let slot = self.pair[index / values];
        if self.is_contracted {
            let scale = self.contracted_size(slot) + self.world(slot);
            let [p, eye] = self.ends(slot);
            let ray = exact::contracted_ray(p, eye, f64::from(self.step));
            let steps = f64::from(self.step) * ray.count.max(1.0);
            return Bound::relative_to(if index % 16 == 3 { scale / steps } else { scale });
        }
        let ray = self.ray(slot);
        let size = 1.0 + ray.p.length() + ray.v.length();
        let scale = size + self.world(slot);
        Bound::relative_to(match rounding {
            // s_factor is L / K / sigma
            _ if index % 8 == 3 => {
                let steps = (ray.length() / f64::from(self.step)).ceil().max(1.0);
                scale / (f64::from(self.step) * steps.min(f64::from(MAX_SAMPLES)))
            }
            Rounding::AsWritten if size < NEAR => 4e-3 * size,
            _ => scale,
        })
    }
}
