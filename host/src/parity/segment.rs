//! The case of `segment`.

use glam::{DVec3, Vec3, Vec4};
use organza_check::{
    Bound, KernelRunner, Output, Parity, Rounding, Values,
    inputs::{self, Fill, ITEMS, Random},
};
use organza_shaders::camera::Camera;
use organza_shaders::limits::MAX_SAMPLES;
use organza_shaders::segment::{SEGMENT_VECTORS, SegmentKernel, SegmentParams};
use organza_shaders::unit_cube::SceneBox;

use super::color::BOXES;
use super::exact::segment as exact;
use super::exact::unit_cube::unit;
use super::project;
use organza_device::Result;

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
            let (p, v) = (self.p[axis], self.v[axis]);
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
        let gaussians = 60;
        let mut cameras = project::cameras(random);
        let middle = [0, 1, 2].map(|axis| ((aabb[0][axis] + aabb[1][axis]) / 2.0) as f32);
        // one within the box
        cameras[1].eye = Vec3::from_array(middle) + Vec3::splat(0.013);
        let position = (0..3 * gaussians).map(|at| {
            let axis = at as usize % 3;
            let (low, high) = (aabb[0][axis] as f32, aabb[1][axis] as f32);
            let margin = 0.3 * (high - low);
            fill.values(random, 1, [low - margin, high + margin], 1e30)[0]
        });
        let position = position.collect();
        let mut set = Self { pair: Vec::new(), gaussians, step, cameras, aabb, position };
        let slots = gaussians * set.cameras.len() as u32;
        let decided: Vec<u32> =
            (0..slots).filter(|&slot| !set.ray(slot).is_undecided(f64::from(step))).collect();
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
        [Vec3::from_slice(position), eye].map(|point| unit(point.as_dvec3().to_array(), self.aabb))
    }

    /// The ray of a pair.
    fn ray(&self, slot: u32) -> Ray {
        let [p, eye] = self.ends(slot);
        Ray::new(p, eye)
    }
}

/// Coarse and fine parts of `[pairs, 4]` segments, added: s and `s_factor`, w and 0.
fn joined(segment: &[Vec4]) -> Vec<f64> {
    let (segments, _) = segment.as_chunks::<{ SEGMENT_VECTORS as usize }>();
    let added = segments.iter().flat_map(|segment| {
        let [start, w, start_fine, w_fine] = segment.map(|vector| vector.as_dvec4());
        [start + start_fine, w + w_fine]
    });
    added.flat_map(|vector| vector.to_array()).collect()
}

impl Parity for Segment {
    const KERNEL: &'static str = "segment";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str = "divisions of 3 ulp: of the ray's size, and of 1/250 of it up to a size of 8, where \
        places on it have two parts; no ray within 2e-5 of its size of a whole number of steps, or of missing the cube";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, fill, 0.013, BOXES[0], random));
        for (index, aabb) in BOXES.into_iter().enumerate() {
            for step in [1.7, 0.1, 0.004] {
                let set = Self::new(ITEMS, Fill::Random, step, aabb, &mut Random::new(31));
                sets.push((format!("step {step}, box {index}"), set));
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
        let segment = runner.output::<Vec4>((SEGMENT_VECTORS * pairs) as usize)?;
        let count = runner.output(pairs as usize)?;
        let kernel = SegmentKernel {
            params: SegmentParams { pairs, gaussians: self.gaussians, step: self.step },
            pair: &runner.upload(&self.pair)?,
            camera: &runner.upload(&cameras)?,
            scene_box: &runner.upload(&SceneBox::new(self.aabb).pack())?,
            position: &runner.upload(&self.position)?,
            segment: &segment,
            count: &count,
        };
        runner.items(&kernel, pairs, 1)?;
        let segment = runner.read(&segment)?;
        Ok(vec![
            Output { name: "segment", values: Values::Float(joined(&segment)) },
            Output::exact("count", runner.read(&count)?),
        ])
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let of = |&slot: &u32| {
            let [p, eye] = self.ends(slot);
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
        let Some(&slot) = self.pair.get(index / 8) else {
            return Bound { scale: 0.0, floor: 0.0 };
        };
        let ray = self.ray(slot);
        let size = 1.0 + ray.p.length() + ray.v.length();
        // drivers that regroup know a coordinate in the box to 6e-8 of world space alone
        let position = &self.position[3 * (slot % self.gaussians) as usize..][..3];
        let world = (0..3).map(|axis| {
            let extent = self.aabb[1][axis] - self.aabb[0][axis];
            (f64::from(position[axis].abs()) + self.aabb[0][axis].abs()) / extent
        });
        let scale = size + world.fold(0.0, f64::max);
        Bound::of(match rounding {
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
