//! The case of `project_backward`.

use glam::{DVec3, Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::project::project_gaussian;
use organza_shaders::project_backward::{ALL_BITS, ProjectBackwardInputs, ProjectBackwardParams};

use super::exact::numeric::{Dual, gradient};
use super::exact::project::{Gaussian, View, project};
use super::project::{Fate, Project};

/// Inputs of `project_backward`.
#[derive(Clone)]
pub struct ProjectBackward {
    /// Those of `project`.
    pub forward: Project,
    /// `[cameras, gaussians]`
    pub(super) radius: Vec<f32>,
    pub(super) inputs: ProjectBackwardInputs,
}

/// Sizes of the terms that a pair adds to position, rotation, log_scale and opacity.
pub(super) type Sizes = [f64; 4];

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
        let words = count.div_ceil(32);
        let inputs = ProjectBackwardInputs {
            params: ProjectBackwardParams {
                gaussians: forward.gaussians,
                words: words as u32,
                first_camera: 0,
                cameras: forward.cameras.len() as u32,
                blur: forward.blur,
                bits: ALL_BITS,
            },
            camera: forward.packed_cameras(),
            position: forward.position.clone(),
            rotation: forward.rotation.clone(),
            log_scale: forward.log_scale.clone(),
            pair_mask: Vec::new(),
            first_pair: Vec::new(),
            pair_gradient: Vec::new(),
            gradient: random.values(11 * count, -1.0, 1.0),
        };
        let mut set = Self { forward, radius, inputs };
        for at in 0..set.forward.cameras.len() * words {
            let needed = |bit: &usize| {
                let gaussian = at % words * 32 + bit;
                random.below(4) > 0 && gaussian < count && set.is_usable(at / words, gaussian)
            };
            let bits: u32 = (0..32).filter(needed).map(|bit| 1 << bit).sum();
            set.inputs.first_pair.push(set.inputs.pair_gradient.len() as u32 / 3);
            set.inputs.pair_mask.push(bits);
            for _ in 0..bits.count_ones() {
                let [a, b] = [0, 1].map(|_| Vec4::from_slice(&random.values(4, -1.0, 1.0)));
                set.inputs.pair_gradient.extend([a, b, Vec4::ONE]);
            }
        }
        set
    }

    /// Not culled, and no ratio so near its limit that rounding decides whether it is clamped.
    fn is_usable(&self, camera: usize, gaussian: usize) -> bool {
        let view = View::from_camera(&self.forward.cameras[camera]);
        let center = self.forward.center(gaussian);
        let t = DVec3::from(view.place(center.to_array()));
        let offset = center - DVec3::from(view.eye);
        let slack = 1e-5 * (1.0 + offset.length() / t.z) * (1.0 + t.truncate().length() / t.z);
        let is_clear = (0..2).all(|axis| {
            let limits = view.limits(axis);
            limits.iter().all(|limit| (t[axis] / t.z - limit).abs() > slack)
        });
        is_clear && self.radius[camera * self.forward.gaussians as usize + gaussian] >= 0.0
    }

    /// The pair of a camera and a Gaussian.
    pub(super) fn pair(&self, camera: usize, gaussian: usize) -> Option<usize> {
        let word = camera * self.inputs.params.words as usize + gaussian / 32;
        let bits = self.inputs.pair_mask[word];
        let bit = gaussian % 32;
        let below = (bits & ((1 << bit) - 1)).count_ones();
        (bits >> bit & 1 == 1).then_some((self.inputs.first_pair[word] + below) as usize)
    }

    /// The gradients of a pair: of its center and opacity, its conic and its color.
    pub(super) fn pair_gradient(&self, pair: usize) -> &[Vec4; 3] {
        &self.inputs.pair_gradient.as_chunks().0[pair]
    }

    /// Where the centers of all pairs lie in their images, in pixels.
    pub fn pairs_in_image(&self) -> Vec<[f64; 2]> {
        let gaussians = 0..self.forward.gaussians as usize;
        let pairs = gaussians.flat_map(|gaussian| {
            self.pairs(gaussian).map(move |(camera, _)| self.forward.fate(camera, gaussian))
        });
        pairs
            .filter_map(|fate| match fate {
                Some(Fate::Projected(found)) => Some(found.mean),
                _ => None,
            })
            .collect()
    }

    /// The sizes of the terms that a pair adds, before they cancel.
    pub(super) fn sizes(&self, camera: usize, gaussian: usize, pair: &[Vec4; 3]) -> Sizes {
        let set = &self.forward;
        let [geometry, shape, _] = pair.map(|v| v.as_dvec4().abs());
        let sensitivity = set.sensitivity(camera, gaussian);
        let view = View::from_camera(&set.cameras[camera]);
        let limited = set.limited(gaussian);
        let blur = f64::from(set.blur);
        let found = project(&view, blur, &limited).expect("it has a pair");
        let t = DVec3::from(found.place);
        let [u, v] = found.footprint.map(DVec3::from);
        let longest = DVec3::from(limited.axes()).max_element();
        let row: f64 = found.jacobian.map(|row| DVec3::from(row).length()).iter().sum();
        // conic G conic H
        let cross = u.cross(v).length_squared();
        let trace = u.length_squared() + v.length_squared() + 2.0 * blur;
        let conic = trace / (cross + 0.5 * blur * trace);
        let by_half =
            2.0 * conic * sensitivity.conic * shape.truncate().element_sum() * row * longest;
        let by_row = by_half * longest;
        let center = geometry.x.hypot(geometry.y);
        let offset = set.center(gaussian) - DVec3::from(view.eye);
        let depth = 1.0 + offset.length() / t.z;
        let ratio = 1.0 + t.truncate().length() / t.z;
        let focal = view.focal[0].max(view.focal[1]) / t.z;
        let position = (by_row * (focal / t.z + row / t.z) + focal * center) * ratio * depth;
        let shape = by_row * row;
        [position, 4.0 * shape / set.quaternion(gaussian).length(), shape, geometry.z]
    }

    /// The derivatives of the loss of a Gaussian's pairs, by position, rotation and log_scale; `None` where a projection
    /// depends on how far the kernel's numbers reach.
    fn derivatives(&self, gaussian: usize) -> Option<[f64; 10]> {
        let set = &self.forward;
        let pairs: Vec<_> = self.pairs(gaussian).collect();
        let is_told = |&(camera, _): &(usize, _)| {
            matches!(set.fate(camera, gaussian), Some(Fate::Projected(_)))
        };
        if !pairs.iter().all(is_told) {
            return None;
        }
        let of = |camera: usize, pair: &[Vec4; 3], moved: &Gaussian<Dual>| {
            let view = View::from_camera(&set.cameras[camera]);
            let [center, shape, _] = pair.map(|v| v.as_dvec4().to_array());
            let found = project(&view, f64::from(set.blur), moved).expect("it has a pair");
            let weights = center[..2].iter().chain(&shape[..3]);
            let values = found.mean.into_iter().chain(found.conic());
            values.zip(weights).fold(Dual::from(0.0), |sum, (x, &w)| sum + x * Dual::from(w))
        };
        let Gaussian { position: [a, b, c], rotation: [w, x, y, z], log_scale: [l, m, n] } =
            set.gaussian(gaussian);
        Some(gradient([a, b, c, w, x, y, z, l, m, n], |[a, b, c, w, x, y, z, l, m, n]| {
            let moved =
                Gaussian { position: [a, b, c], rotation: [w, x, y, z], log_scale: [l, m, n] };
            let losses = pairs.iter().map(|&(camera, pair)| of(camera, pair, &moved));
            losses.fold(Dual::from(0.0), |sum, loss| sum + loss)
        }))
    }

    /// The pairs of a Gaussian.
    pub(super) fn pairs(&self, gaussian: usize) -> impl Iterator<Item = (usize, &[Vec4; 3])> {
        let cameras = 0..self.forward.cameras.len();
        cameras.filter_map(move |camera| {
            Some((camera, self.pair_gradient(self.pair(camera, gaussian)?)))
        })
    }

    /// Of a Gaussian, in all cameras.
    fn all_sizes(&self, gaussian: usize) -> Sizes {
        let mut all = Sizes::default();
        for (camera, pair) in self.pairs(gaussian) {
            let sizes = self.sizes(camera, gaussian, pair);
            all.iter_mut().zip(sizes).for_each(|(all, size)| *all += size);
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
        Project::everywhere().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.inputs.kernel(), self.forward.gaussians, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let count = self.forward.gaussians as usize;
        let before = |index: usize| f64::from(self.inputs.gradient[index]);
        let derivatives: Vec<_> = (0..count).map(|g| self.derivatives(g)).collect();
        let part = |first: usize, width: usize| {
            let derivatives = &derivatives;
            (0..width * count).map(move |at| {
                let of = derivatives[at / width].as_ref()?;
                Some(before(first * count + at) + of[first + at % width])
            })
        };
        let opacity = (0..count).map(|gaussian| {
            let sum: f64 = self.pairs(gaussian).map(|(_, pair)| f64::from(pair[0].z)).sum();
            Some(before(10 * count + gaussian) + sum)
        });
        part(0, 3).chain(part(3, 4)).chain(part(7, 3)).chain(opacity).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let count = self.forward.gaussians as usize;
        let before = self.inputs.gradient[index];
        let (gaussian, part) = match index / count {
            0..3 => (index / 3, 0),
            3..7 => ((index - 3 * count) / 4, 1),
            7..10 => ((index - 7 * count) / 3, 2),
            _ => (index - 10 * count, 3),
        };
        let size = self.all_sizes(gaussian)[part];
        if size == 0.0 {
            return Bound::EXACT;
        }
        // what is flushed on the way may be multiplied by focal lengths
        Bound { scale: f64::from(before.abs()) + size, floor: f64::from(TINY) * 1e6 }
    }
}
