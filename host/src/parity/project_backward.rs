//! The case of `project_backward`.

use glam::{DVec3, Vec3, Vec4};
use organza_kernels::camera::Camera;
use organza_kernels::math::TINY;
use organza_kernels::project::project_gaussian;
use organza_kernels::project_backward::{ProjectBackwardKernel, ProjectBackwardParams};

use super::bench::Bench;
use super::case::{Parity, Rounding};
use super::inputs::Random;
use super::lens::ExactLens;
use super::measure::{Bound, Output};
use super::project::{Project, axes, place, rows};
use crate::error::Result;

/// Inputs of `project_backward`.
#[derive(Clone)]
pub struct ProjectBackward {
    /// Those of `project`.
    pub forward: Project,
    /// `[cameras, words]`
    pub pair_mask: Vec<u32>,
    /// `[cameras, words]`: bits before each word.
    pub first_pair: Vec<u32>,
    /// `[pairs, 3]`
    pub pair_gradient: Vec<[Vec4; 3]>,
    /// `[cameras, gaussians]`
    pub radius: Vec<f32>,
    /// `[11 gaussians]`: what other parts have left.
    pub gradient: Vec<f32>,
    /// `[gaussians]`: likewise.
    pub statistics: Vec<Vec4>,
}

/// Sizes of what a pair adds: position, rotation, log_scale, opacity, the center's way.
type Sizes = [f64; 5];

impl ProjectBackward {
    fn new(forward: Project) -> Self {
        let mut random = Random::new(9);
        let count = forward.gaussians as usize;
        let slots = (0..forward.cameras.len()).flat_map(|c| (0..count).map(move |g| (c, g)));
        let radius = slots.map(|(camera, gaussian)| {
            let rotation = Vec4::from_slice(&forward.rotation[4 * gaussian..]);
            let [center, log_axes] = [&forward.position, &forward.log_scale]
                .map(|v| Vec3::from_slice(&v[3 * gaussian..]));
            let view = &forward.cameras[camera];
            project_gaussian(view, forward.blur, center, rotation, log_axes).radius
        });
        let radius: Vec<_> = radius.collect();
        let numbers = random.values(4 * count, 0.0, 5.0);
        let mut set = Self {
            pair_mask: Vec::new(),
            first_pair: Vec::new(),
            pair_gradient: Vec::new(),
            radius,
            gradient: random.values(11 * count, -1.0, 1.0),
            statistics: numbers.chunks(4).map(Vec4::from_slice).collect(),
            forward,
        };
        for camera in 0..set.forward.cameras.len() {
            for word in 0..count.div_ceil(32) {
                let needed = |bit: &usize| {
                    let gaussian = 32 * word + bit;
                    random.below(4) > 0 && gaussian < count && set.is_usable(camera, gaussian)
                };
                let bits: u32 = (0..32).filter(needed).map(|bit| 1 << bit).sum();
                set.first_pair.push(set.pair_gradient.len() as u32);
                set.pair_mask.push(bits);
                for _ in 0..bits.count_ones() {
                    let [a, b] = [0, 1].map(|_| Vec4::from_slice(&random.values(4, -1.0, 1.0)));
                    set.pair_gradient.push([a, b, Vec4::ONE]);
                }
            }
        }
        set
    }

    /// A Gaussian's position in a camera's space, and its distance from the camera.
    fn place(&self, camera: usize, gaussian: usize) -> (DVec3, f64) {
        place(&self.forward.cameras[camera], self.forward.center(gaussian))
    }

    /// Whether it is not culled, and rounding does not decide whether a ratio is clamped.
    fn is_usable(&self, camera: usize, gaussian: usize) -> bool {
        let (t, distance) = self.place(camera, gaussian);
        let lens = ExactLens::of(&self.forward.cameras[camera]);
        let radius = self.radius[camera * self.forward.gaussians as usize + gaussian];
        !lens.is_near_limit(t, distance) && radius >= 0.0
    }

    /// The pair of a camera and a Gaussian.
    #[must_use]
    pub fn pair(&self, camera: usize, gaussian: usize) -> Option<usize> {
        let words = (self.forward.gaussians as usize).div_ceil(32);
        let word = camera * words + gaussian / 32;
        let (bits, bit) = (self.pair_mask[word], gaussian % 32);
        let below = (bits & ((1 << bit) - 1)).count_ones();
        (bits >> bit & 1 == 1).then_some((self.first_pair[word] + below) as usize)
    }

    /// How large what a pair adds may be, whatever cancels in it.
    fn sizes(&self, camera: usize, gaussian: usize, pair: usize) -> Sizes {
        let set = &self.forward;
        let [geometry, shape, _] = self.pair_gradient[pair].map(|v| v.as_dvec4().abs());
        let sensitivity = set.sensitivity(camera, gaussian);
        let (t, distance) = self.place(camera, gaussian);
        let (view, log_axes) = (&set.cameras[camera], set.log_axes(gaussian));
        let rotation = set.quaternion(gaussian);
        let (u, v, lengths) = rows(view, t, rotation, log_axes);
        let longest = axes(log_axes).max_element();
        let row = lengths[0] + lengths[1];
        // conic G conic H
        let blur = f64::from(set.blur);
        let cross = u.cross(v).length_squared();
        let trace = u.length_squared() + v.length_squared() + 2.0 * blur;
        let conic = trace / (cross + 0.5 * blur * trace);
        let by_half =
            2.0 * conic * sensitivity.conic * shape.truncate().element_sum() * row * longest;
        let by_row = by_half * longest;
        let center = geometry.x.hypot(geometry.y);
        let sizes = [by_row, row, center];
        let position = ExactLens::of(view).gradient_terms(t, distance, sizes);
        let shape = by_row * row;
        [position, 4.0 * shape / rotation.length(), shape, geometry.z, center]
    }

    /// Of a Gaussian, in all cameras.
    fn all_sizes(&self, gaussian: usize) -> Sizes {
        let mut all = [0.0; 5];
        for camera in 0..self.forward.cameras.len() {
            if let Some(pair) = self.pair(camera, gaussian) {
                let sizes = self.sizes(camera, gaussian, pair);
                all.iter_mut().zip(sizes).for_each(|(all, size)| *all += size);
            }
        }
        all
    }
}

impl Parity for ProjectBackward {
    const KERNEL: &'static str = "project_backward";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "roundings of sums, divisions and square roots of 3 ulp, exp, of the terms' sizes, \
        scaled by how the f64 projection is conditioned; no ratio within 1e-5 of being clamped";

    fn sets() -> Vec<(String, Self)> {
        Project::sets().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let set = &self.forward;
        let packed: Vec<_> = set.cameras.iter().flat_map(Camera::pack).collect();
        let projection =
            self.radius.iter().flat_map(|&radius| [Vec4::ONE.with_z(radius), Vec4::ONE]);
        let gradient = bench.output_of(&self.gradient)?;
        let statistics = bench.output_of(&self.statistics)?;
        let kernel = ProjectBackwardKernel {
            params: ProjectBackwardParams {
                gaussians: set.gaussians,
                words: set.gaussians.div_ceil(32),
                cameras: set.cameras.len() as u32,
                blur: set.blur,
            },
            camera: &bench.upload(&packed)?,
            position: &bench.upload(&set.position)?,
            rotation: &bench.upload(&set.rotation)?,
            log_scale: &bench.upload(&set.log_scale)?,
            projection: &bench.upload(&projection.collect::<Vec<_>>())?,
            pair_mask: &bench.upload(&self.pair_mask)?,
            first_pair: &bench.upload(&self.first_pair)?,
            pair_gradient: &bench.upload(self.pair_gradient.as_flattened())?,
            gradient: &gradient,
            statistics: &statistics,
        };
        bench.items(&kernel, set.gaussians, 1)?;
        let statistics = bench.read(&statistics)?.into_iter().flat_map(|v| v.to_array());
        Ok(vec![
            Output::float("gradient", bench.read(&gradient)?),
            Output::float("statistics", statistics),
        ])
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let count = self.forward.gaussians as usize;
        let exact = Bound { scale: 0.0, floor: 0.0 };
        if cpu.name == "statistics" {
            return match self.statistics.get(index / 4) {
                Some(before) if index.is_multiple_of(4) => {
                    Bound::of(f64::from(before.x) + self.all_sizes(index / 4)[4])
                }
                _ => exact,
            };
        }
        let Some(before) = self.gradient.get(index) else { return exact };
        let (gaussian, part) = match index / count {
            0..3 => (index / 3, 0),
            3..7 => ((index - 3 * count) / 4, 1),
            7..10 => ((index - 7 * count) / 3, 2),
            _ => (index - 10 * count, 3),
        };
        let size = self.all_sizes(gaussian)[part];
        if size == 0.0 {
            return exact;
        }
        // what is flushed on the way may be multiplied by focal lengths
        Bound { scale: f64::from(before.abs()) + size, floor: f64::from(TINY) * 1e6 }
    }
}
