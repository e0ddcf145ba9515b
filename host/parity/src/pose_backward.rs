//! The case of `pose_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::pose_backward::{BLOCK, PoseBackwardInputs, PoseBackwardParams, VALUES};
use organza_shaders::project_backward::ProjectBackwardParams;

use super::binned::{read_sums, write_sums};
use super::exact::numeric::dot;
use super::exact::project::{Gaussian, View};
use super::project_backward::ProjectBackward;

/// Values of a pose.
const POSE: usize = VALUES as usize;

/// A pair's camera, Gaussian and number.
type Pair = [usize; 3];

case!(pub PoseBackward(PoseBackwardInputs) {
    set: ProjectBackward,
    pairs: Vec<Pair>,
    /// The sums of other parts, for the poses of all places.
    before: Vec<f32>,
});

impl PoseBackward {
    fn new(set: ProjectBackward) -> Self {
        let ProjectBackwardParams { gaussians, words, cameras, blur, .. } = set.params;
        let values = VALUES * 2 * cameras;
        let before: Vec<_> = (0..values).map(|value| value as f32 / 8.0 - 1.0).collect();
        let mut first_pair = set.first_pair.clone();
        first_pair.push(set.pair_gradient.len() as u32 / 3);
        let count = gaussians as usize;
        let slots = (0..cameras as usize).flat_map(|camera| (0..count).map(move |g| (camera, g)));
        let pair = |(camera, gaussian)| Some([camera, gaussian, set.pair(camera, gaussian)?]);
        let pairs: Vec<_> = slots.filter_map(pair).collect();
        let inputs = PoseBackwardInputs {
            params: PoseBackwardParams {
                gaussians,
                words,
                camera: 0,
                place: 0,
                blocks: gaussians.div_ceil(BLOCK),
                values,
                blur,
            },
            camera: set.camera.clone(),
            position: set.position.clone(),
            rotation: set.rotation.clone(),
            log_scale: set.log_scale.clone(),
            first_pair,
            pair: pairs.iter().map(|[camera, g, _]| (camera * count + g) as u32).collect(),
            pair_gradient: set.pair_gradient.clone(),
            sum: write_sums(&before),
        };
        Self { inputs, set, pairs, before }
    }

    /// The same set with gradients of conics alone, scaled so that all pairs have terms of one size, or none. Otherwise the terms of means
    /// and of needles would hide the others.
    fn conics(&self) -> Self {
        let mut set = self.set.clone();
        for &pair in &self.pairs {
            let first = 3 * pair[2];
            set.pair_gradient[first] = Vec4::ZERO;
            let slopes = derivatives(&set, pair);
            let size = slopes.iter().map(|slope| slope.terms).fold(0.0, f64::max);
            let factor = if (1e-9..1e9).contains(&size) { 1.0 / size as f32 } else { 0.0 };
            set.pair_gradient[first + 1] *= factor;
        }
        Self::new(set)
    }

    /// A camera's row among the poses: in reverse order, with an unused row after each, so that a kernel which mixes rows up fails.
    fn place(&self, camera: usize) -> usize {
        2 * (self.set.forward.cameras.len() - 1 - camera)
    }
}

/// The derivatives of a pair's part of the loss; unknown where rounding decides its projection.
fn derivatives(set: &ProjectBackward, [camera, gaussian, pair]: Pair) -> [Rounded; POSE] {
    if !matches!(set.forward.fate(camera, gaussian), Some(Ok(_))) {
        return [Rounded::UNKNOWN; POSE];
    }
    let view = View::from_camera(&set.forward.cameras[camera]);
    let Gaussian { position, rotation, log_scale } = set.forward.gaussian(gaussian);
    let gaussian = Gaussian {
        position: position.map(Dual::constant),
        rotation: rotation.map(Dual::constant),
        log_scale: log_scale.map(Dual::constant),
    };
    let pair = set.pair_gradient(pair);
    gradient([Rounded::exact(0.0); POSE], |pose| set.loss(&posed(&view, pose), pair, &gaussian))
}

/// A camera with a pose, correct to first order at a pose of 0.
fn posed<N: Number>(view: &View<N>, [x, y, z, shift @ ..]: [N; POSE]) -> View<N> {
    let mixed = |of: [N; 3]| -> [N; 3] {
        std::array::from_fn(|world| dot(of, view.axes.map(|axis| axis[world])))
    };
    let one = N::from(1.0);
    let shift = mixed(shift);
    View {
        // the small rotation 1 + [w]x
        axes: [[one, -z, y], [z, one, -x], [-y, x, one]].map(mixed),
        eye: std::array::from_fn(|world| view.eye[world] - shift[world]),
        ..*view
    }
}

impl Parity for PoseBackward {
    fn sets() -> Vec<(String, Self)> {
        let sets = ProjectBackward::sets().into_iter().map(|(name, set)| (name, Self::new(set)));
        sets.flat_map(|(name, set)| [(format!("{name}, conics"), set.conics()), (name, set)])
            .collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let mut inputs = self.inputs.clone();
        for camera in 0..self.set.forward.cameras.len() {
            inputs.params.camera = camera as u32;
            inputs.params.place = self.place(camera) as u32;
            inputs.sum = runner.run(&inputs.kernel())?[0].words();
        }
        Ok(vec![Output::float("sum", read_sums(&inputs.sum, self.before.len()))])
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let mut exact: Vec<_> = self.before.iter().copied().map(Rounded::from).collect();
        for &pair in &self.pairs {
            let sums = &mut exact[POSE * self.place(pair[0])..][..POSE];
            let found = derivatives(&self.set, pair);
            sums.iter_mut().zip(found).for_each(|(sum, found)| *sum = *sum + found);
        }
        listed(exact)
    }
}
