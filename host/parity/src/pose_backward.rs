//! The case of `pose_backward`.

use glam::{DVec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::pose_backward::{BLOCK, PoseBackwardKernel, PoseBackwardParams, VALUES};
use organza_shaders::project_backward::ProjectBackwardParams;

use super::binned::{read_sums, write_sums};
use super::exact::numeric::{Dual, Number, gradient};
use super::exact::project::{Gaussian, View, project, unit_axes};
use super::project::Fate;
use super::project_backward::ProjectBackward;

/// Values of a pose.
const POSE: usize = VALUES as usize;

/// Inputs of `pose_backward`: those of `project_backward`.
#[derive(Clone)]
pub struct PoseBackward(ProjectBackward);

/// A pair's camera, Gaussian and number.
type Pair = [usize; 3];

impl PoseBackward {
    /// The pairs of each camera.
    fn pairs(&self) -> Vec<Vec<Pair>> {
        let set = &self.0;
        let of_camera = |camera: usize| {
            let gaussians = 0..set.forward.gaussians as usize;
            let pair = |gaussian: usize| Some([camera, gaussian, set.pair(camera, gaussian)?]);
            gaussians.filter_map(pair).collect()
        };
        (0..set.forward.cameras.len()).map(of_camera).collect()
    }

    /// Each camera's place: backwards, with one between two.
    fn places(&self) -> Vec<u32> {
        (0..self.0.forward.cameras.len() as u32).rev().map(|camera| 2 * camera).collect()
    }

    /// The sums that other parts have added to the poses of all places.
    fn before(&self) -> Vec<f32> {
        let values = POSE * 2 * self.0.forward.cameras.len();
        (0..values).map(|value| value as f32 / 8.0 - 1.0).collect()
    }

    /// The derivatives of a pair's part of the loss; `None` where rounding decides about its projection.
    fn derivatives(&self, [camera, gaussian, pair]: Pair) -> Option<[f64; POSE]> {
        let set = &self.0.forward;
        let pair = self.0.pair_gradient(pair);
        if !matches!(set.fate(camera, gaussian), Some(Fate::Projected(_))) {
            return None;
        }
        let view = View::from_camera(&set.cameras[camera]);
        let still = set.gaussian(gaussian);
        let [center, shape, _] = pair.map(|v| v.as_dvec4().to_array());
        let weights: Vec<_> = center[..2].iter().chain(&shape[..3]).copied().collect();
        Some(gradient([0.0; POSE], |pose| {
            let found = project(&view, f64::from(set.blur), &moved(&view, &still, pose));
            let found = found.expect("it has a pair");
            let values = found.mean.into_iter().chain(found.conic());
            let terms = values.zip(&weights).map(|(value, &weight)| value * Dual::from(weight));
            terms.fold(Dual::from(0.0), |sum, term| sum + term)
        }))
    }

    /// With gradients of conics alone, which give all pairs terms of one size, or none. Those of means and of needles hide
    /// all others.
    fn conics(&self) -> Self {
        let mut set = self.clone();
        for pair in self.pairs().into_iter().flatten() {
            let first = 3 * pair[2];
            set.0.inputs.pair_gradient[first] = Vec4::ZERO;
            let size = set.sizes(pair)[0];
            let factor = if (1e-9..1e9).contains(&size) { 1.0 / size as f32 } else { 0.0 };
            set.0.inputs.pair_gradient[first + 1] *= factor;
        }
        set
    }

    /// The sizes of the terms that a pair adds to the rotation, and to the shift.
    fn sizes(&self, [camera, gaussian, pair]: Pair) -> [f64; 2] {
        let set = &self.0;
        let [position, _, shape, _] = set.sizes(camera, gaussian, set.pair_gradient(pair));
        let view = View::from_camera(&set.forward.cameras[camera]);
        let t = DVec3::from(view.place(set.forward.center(gaussian).to_array())).length();
        [t * position + 2.0 * shape, position]
    }
}

/// Moves a Gaussian as if a pose had moved the camera: the camera stays, and the Gaussian moves the other way. Right to
/// the first order, at a pose of 0.
fn moved<N: Number>(view: &View, still: &Gaussian<f64>, pose: [N; POSE]) -> Gaussian<N> {
    let [x, y, z, shift @ ..] = pose;
    let half = N::from(0.5);
    // the quaternion of a small rotation is 1 and half the rotation vector
    let one = N::from(1.0);
    let columns = unit_axes([one, half * x, half * y, half * z]);
    let place = view.place(still.position.map(N::from));
    let seen: [N; 3] = std::array::from_fn(|axis| {
        let turned = (0..3).map(|k| columns[k][axis] * place[k]);
        turned.fold(shift[axis], |sum, term| sum + term)
    });
    let to_world = |v: [N; 3]| -> [N; 3] {
        std::array::from_fn(|world| {
            let along = (0..3).map(|axis| N::from(view.axes[axis][world]) * v[axis]);
            along.fold(N::from(0.0), |sum, term| sum + term)
        })
    };
    let place = to_world(seen);
    let [a, b, c] = to_world([x, y, z].map(|part| half * part));
    let [w, i, j, k] = still.rotation.map(N::from);
    Gaussian {
        position: std::array::from_fn(|axis| place[axis] + N::from(view.eye[axis])),
        // (1, a, b, c) times the quaternion
        rotation: [
            w - a * i - b * j - c * k,
            i + a * w + b * k - c * j,
            j + b * w + c * i - a * k,
            k + c * w + a * j - b * i,
        ],
        log_scale: still.log_scale.map(N::from),
    }
}

impl Parity for PoseBackward {
    const KERNEL: &'static str = "pose_backward";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "as project_backward, of the size of the place times that of its gradient; a rounding of both \
        devices for each pair of the block";

    fn sets() -> Vec<(String, Self)> {
        let sets = ProjectBackward::sets().into_iter().map(|(name, set)| (name, Self(set)));
        sets.flat_map(|(name, set)| [(format!("{name}, conics"), set.conics()), (name, set)])
            .collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let set = &self.0.inputs;
        let ProjectBackwardParams { gaussians, words, blur, .. } = set.params;
        let mut first_pair = set.first_pair.clone();
        first_pair.push(set.pair_gradient.len() as u32 / 3);
        let mut pairs: Vec<_> = self.pairs().into_iter().flatten().collect();
        pairs.sort_by_key(|&[.., pair]| pair);
        let slot = |[camera, gaussian, _]: &Pair| (camera * gaussians as usize + gaussian) as u32;
        let slots: Vec<_> = pairs.iter().map(slot).collect();
        let mut sum = write_sums(&self.before());
        let values = self.before().len() as u32;
        let blocks = gaussians.div_ceil(BLOCK);
        for (camera, place) in (0..).zip(self.places()) {
            let kernel = PoseBackwardKernel {
                params: PoseBackwardParams {
                    gaussians,
                    words,
                    camera,
                    place,
                    blocks,
                    values,
                    blur,
                },
                camera: &set.camera,
                position: &set.position,
                rotation: &set.rotation,
                log_scale: &set.log_scale,
                first_pair: &first_pair,
                pair: &slots,
                pair_gradient: &set.pair_gradient,
                sum: &sum,
            };
            let outputs = runner.run(&kernel, blocks, 1)?;
            sum = outputs[0].words().to_vec();
        }
        let values = read_sums(&sum, values as usize);
        Ok(vec![Output { name: "sum", values: Values::Float(values) }])
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let mut exact: Vec<_> = self.before().into_iter().map(|v| Some(f64::from(v))).collect();
        for (pairs, place) in self.pairs().into_iter().zip(self.places()) {
            for found in pairs.into_iter().map(|pair| self.derivatives(pair)) {
                let sums = &mut exact[POSE * place as usize..][..POSE];
                for (at, sum) in sums.iter_mut().enumerate() {
                    *sum = sum.zip(found).map(|(sum, found)| sum + found[at]);
                }
            }
        }
        exact
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let slot = self.places().iter().position(|&place| place as usize == index / POSE);
        let pairs = slot.map(|slot| self.pairs().swap_remove(slot)).unwrap_or_default();
        let part = index % POSE / 3;
        let size: f64 = pairs.iter().map(|&pair| self.sizes(pair)[part]).sum();
        if size == 0.0 {
            return Bound::EXACT;
        }
        // 6e-8 for each sum
        let sums = 1.0 + pairs.len().min(BLOCK as usize) as f64 / 16.0;
        // what is flushed on the way may be multiplied by focal lengths, and by places
        Bound { scale: size * sums, floor: f64::from(TINY) * 1e9 * sums }
    }
}
