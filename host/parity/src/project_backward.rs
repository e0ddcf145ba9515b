//! The case of `project_backward`.

use glam::{Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::project::project_gaussian;
use organza_shaders::project_backward::{ALL_BITS, ProjectBackwardInputs, ProjectBackwardParams};

use super::exact::project::{Gaussian, View, project};
use super::project::Project;

case!(pub ProjectBackward(ProjectBackwardInputs) {
    /// The case of `project`.
    pub forward: Project,
    /// `[cameras, gaussians]`
    pub(super) radius: Vec<f32>,
});

impl ProjectBackward {
    fn new(forward: Project) -> Self {
        let mut random = Random::new(9);
        let gaussians = forward.params.gaussians;
        let blur = forward.params.blur;
        let count = gaussians as usize;
        let slots = (0..forward.cameras.len()).flat_map(|c| (0..count).map(move |g| (c, g)));
        let radius = slots.map(|(camera, gaussian)| {
            let rotation = Vec4::from_slice(&forward.rotation[4 * gaussian..]);
            let [center, log_axes] = [&forward.position, &forward.log_scale]
                .map(|v| Vec3::from_slice(&v[3 * gaussian..]));
            let view = &forward.cameras[camera];
            project_gaussian(view, blur, center, rotation, log_axes).radius
        });
        let radius: Vec<_> = radius.collect();
        let words = count.div_ceil(32);
        let inputs = ProjectBackwardInputs {
            params: ProjectBackwardParams {
                gaussians,
                words: words as u32,
                first_camera: 0,
                cameras: forward.cameras.len() as u32,
                blur,
                bits: ALL_BITS,
                shaped: 0,
            },
            camera: forward.camera.clone(),
            position: forward.position.clone(),
            rotation: forward.rotation.clone(),
            log_scale: forward.log_scale.clone(),
            pair_mask: Vec::new(),
            first_pair: Vec::new(),
            pair_gradient: Vec::new(),
            gradient: random.values(11 * count, -1.0, 1.0),
        };
        let mut set = Self { inputs, forward, radius };
        for at in 0..set.forward.cameras.len() * words {
            let needed = |bit: &usize| {
                let gaussian = at % words * 32 + bit;
                random.below(4) > 0 && gaussian < count && set.is_usable(at / words, gaussian)
            };
            let bits: u32 = (0..32).filter(needed).map(|bit| 1 << bit).sum();
            let first_pair = set.pair_gradient.len() as u32 / 3;
            set.first_pair.push(first_pair);
            set.pair_mask.push(bits);
            for _ in 0..bits.count_ones() {
                let [a, b] = [0, 1].map(|_| Vec4::from_slice(&random.values(4, -1.0, 1.0)));
                set.pair_gradient.extend([a, b, Vec4::ONE]);
            }
        }
        set
    }

    /// The same set with shapes.
    fn shaped(mut self) -> Self {
        self.params.shaped = 1;
        let count = self.params.gaussians as usize;
        self.gradient.resize(12 * count, 0.5);
        let colors = self.pair_gradient.iter_mut().skip(2).step_by(3);
        colors.zip(0..).for_each(|(color, pair)| color.w = (pair as f32).sin());
        self
    }

    /// Not culled, and no ratio so near its limit that rounding decides whether it is clamped.
    fn is_usable(&self, camera: usize, gaussian: usize) -> bool {
        let view = View::from_camera(&self.forward.cameras[camera]);
        let place = view.place(self.forward.gaussian(gaussian).position);
        let is_clear = (0..2).all(|axis| {
            let ratio: Rounded = place[axis] / place[2];
            view.limits(axis)
                .into_iter()
                .all(|limit| (ratio - limit.into()).is_above(0.0).is_some())
        });
        is_clear && self.radius[camera * self.params.gaussians as usize + gaussian] >= 0.0
    }

    /// The pair of a camera and a Gaussian.
    pub(super) fn pair(&self, camera: usize, gaussian: usize) -> Option<usize> {
        let word = camera * self.params.words as usize + gaussian / 32;
        let bits = self.pair_mask[word];
        let bit = gaussian % 32;
        let below = (bits & ((1 << bit) - 1)).count_ones();
        (bits >> bit & 1 == 1).then_some((self.first_pair[word] + below) as usize)
    }

    /// The gradients of a pair: of its center and opacity, its conic and its color.
    pub(super) fn pair_gradient(&self, pair: usize) -> &[Vec4; 3] {
        &self.pair_gradient.as_chunks().0[pair]
    }

    /// Where the centers of all pairs lie in their images, in pixels.
    pub fn pairs_in_image(&self) -> Vec<[f64; 2]> {
        let gaussians = 0..self.params.gaussians as usize;
        let pairs = gaussians.flat_map(|gaussian| {
            self.pairs(gaussian).map(move |(camera, _)| self.forward.fate(camera, gaussian))
        });
        pairs
            .filter_map(|fate| match fate {
                Some(Ok(found)) => Some(found.mean.map(Number::value)),
                _ => None,
            })
            .collect()
    }

    /// A pair's part of the loss.
    pub(super) fn loss<N: Number>(
        &self,
        view: &View<N>,
        pair: &[Vec4; 3],
        gaussian: &Gaussian<N>,
    ) -> N {
        let found = project(view, self.params.blur.into(), gaussian).expect("it has a pair");
        let [center, shape, _] = pair;
        let slopes = [center.x, center.y, shape.x, shape.y, shape.z];
        let values = found.mean.into_iter().chain(found.conic());
        N::sum(values.zip(slopes).map(|(x, slope)| x * N::from(slope.into())))
    }

    /// The derivatives of the loss of a Gaussian's pairs, by position, rotation, log_scale, opacity and shape; unknown where the kernel's
    /// numbers may overflow in a projection.
    fn derivatives(&self, gaussian: usize) -> [Rounded; 12] {
        let pairs: Vec<_> = self.pairs(gaussian).collect();
        let [opacity, shape] = [|pair: &[Vec4; 3]| pair[0].z, |pair: &[Vec4; 3]| pair[2].w]
            .map(|of| Number::sum(pairs.iter().map(|(_, pair)| Rounded::from(of(pair)))));
        let is_known =
            |&(camera, _): &(usize, _)| matches!(self.forward.fate(camera, gaussian), Some(Ok(_)));
        if !pairs.iter().all(is_known) {
            let mut unknown = [Rounded::UNKNOWN; 12];
            [unknown[10], unknown[11]] = [opacity, shape];
            return unknown;
        }
        let Gaussian { position: [a, b, c], rotation: [w, x, y, z], log_scale: [l, m, n] } =
            self.forward.gaussian(gaussian);
        let of = |[a, b, c, w, x, y, z, l, m, n]: [Dual<Rounded>; 10]| {
            let moved =
                Gaussian { position: [a, b, c], rotation: [w, x, y, z], log_scale: [l, m, n] };
            Number::sum(pairs.iter().map(|&(camera, pair)| {
                self.loss(&View::from_camera(&self.forward.cameras[camera]), pair, &moved)
            }))
        };
        let [a, b, c, w, x, y, z, l, m, n] = gradient([a, b, c, w, x, y, z, l, m, n], of);
        [a, b, c, w, x, y, z, l, m, n, opacity, shape]
    }

    /// The pairs of a Gaussian.
    pub(super) fn pairs(&self, gaussian: usize) -> impl Iterator<Item = (usize, &[Vec4; 3])> {
        let cameras = 0..self.forward.cameras.len();
        cameras.filter_map(move |camera| {
            Some((camera, self.pair_gradient(self.pair(camera, gaussian)?)))
        })
    }
}

impl Parity for ProjectBackward {
    fn sets() -> Vec<(String, Self)> {
        let sets = Project::everywhere().into_iter().map(|(name, set)| (name, Self::new(set)));
        let mut sets: Vec<_> = sets.collect();
        let shaped = sets.iter().step_by(3);
        let shaped = shaped.map(|(name, set)| (format!("{name}, shaped"), set.clone().shaped()));
        sets.extend(shaped.collect::<Vec<_>>());
        sets
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let count = self.params.gaussians as usize;
        let derivatives: Vec<_> = (0..count).map(|g| self.derivatives(g)).collect();
        let part = |first: usize, width: usize| {
            derivatives.iter().flat_map(move |of| of[first..first + width].to_vec())
        };
        let parts =
            part(0, 3).chain(part(3, 4)).chain(part(7, 3)).chain(part(10, 1)).chain(part(11, 1));
        listed(self.gradient.iter().zip(parts).map(|(&before, sum)| sum + before.into()))
    }
}
