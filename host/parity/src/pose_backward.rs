//! Cases of `pose_backward` and `pose_sum`.

use glam::DVec3;
use organza_check::{
    Bound, KernelRunner, Output, Parity, Rounding,
    inputs::{self, Fill, Random},
};
use organza_kernel::math::TINY;
use organza_shaders::camera::Camera;
use organza_shaders::pose_backward::{
    BLOCK, PoseBackwardKernel, PoseBackwardParams, PoseSumKernel, PoseSumParams, VALUES,
};

use super::exact::numeric::{Dual, Number, gradient};
use super::exact::project::{Gaussian, View, project, unit_axes};
use super::project::Fate;
use super::project_backward::ProjectBackward;
use organza_device::Result;

/// Values of a pose.
const POSE: usize = VALUES as usize;

/// Inputs of `pose_backward`: those of `project_backward`.
#[derive(Clone)]
pub struct PoseBackward(ProjectBackward);

/// A pair's camera, Gaussian and number.
type Pair = [usize; 3];

impl PoseBackward {
    fn blocks(&self) -> usize {
        self.0.forward.gaussians.div_ceil(BLOCK) as usize
    }

    /// The pairs of each block, by camera.
    fn pairs(&self) -> Vec<Vec<Pair>> {
        let set = &self.0;
        let gaussians = 0..set.forward.gaussians as usize;
        let of_camera = |camera: usize| {
            let pair = |gaussian: usize| Some([camera, gaussian, set.pair(camera, gaussian)?]);
            let pairs: Vec<_> = gaussians.clone().filter_map(pair).collect();
            let mut blocks: Vec<_> = pairs.chunks(BLOCK as usize).map(<[Pair]>::to_vec).collect();
            blocks.resize(self.blocks(), Vec::new());
            blocks
        };
        (0..set.forward.cameras.len()).flat_map(of_camera).collect()
    }

    /// The derivatives of what a pair has in the loss; `None` where rounding decides about its projection.
    fn derivatives(&self, [camera, gaussian, pair]: Pair) -> Option<[f64; POSE]> {
        let (set, pair) = (&self.0.forward, &self.0.pair_gradient[pair]);
        if !matches!(set.fate(camera, gaussian), Some(Fate::Projected(_))) {
            return None;
        }
        let view = View::of(&set.cameras[camera]);
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

    /// How large what a pair adds may be: to the rotation, and to the shift.
    fn sizes(&self, [camera, gaussian, pair]: Pair) -> [f64; 2] {
        let set = &self.0;
        let [position, _, shape, _] = set.sizes(camera, gaussian, &set.pair_gradient[pair]);
        let view = View::of(&set.forward.cameras[camera]);
        let t = DVec3::from(view.place(set.forward.center(gaussian).to_array())).length();
        [t * position + 2.0 * shape, position]
    }
}

/// What a camera sees that has moved by a pose: the same as one that stays, of a Gaussian that has moved in its stead. Right to
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
        ProjectBackward::sets().into_iter().map(|(name, set)| (name, Self(set))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let (set, forward) = (&self.0, &self.0.forward);
        let cameras = forward.cameras.len() as u32;
        let packed: Vec<_> = forward.cameras.iter().flat_map(Camera::pack).collect();
        let mut first_pair = set.first_pair.clone();
        first_pair.push(set.pair_gradient.len() as u32);
        let gaussians = forward.gaussians as usize;
        let mut pairs: Vec<_> = self.pairs().into_iter().flatten().collect();
        pairs.sort_by_key(|&[.., pair]| pair);
        let slots =
            pairs.iter().map(|[camera, gaussian, _]| (camera * gaussians + gaussian) as u32);
        let kernel = PoseBackwardKernel {
            params: PoseBackwardParams {
                gaussians: forward.gaussians,
                words: forward.gaussians.div_ceil(32),
                blocks: self.blocks() as u32,
                blur: forward.blur,
            },
            camera: &packed,
            position: &forward.position,
            rotation: &forward.rotation,
            log_scale: &forward.log_scale,
            first_pair: &first_pair,
            pair: &slots.collect::<Vec<_>>(),
            pair_gradient: &set.pair_gradient.as_flattened().to_vec(),
            partial: &runner.unwritten(POSE * cameras as usize * self.blocks()),
        };
        runner.run(&kernel, self.blocks() as u32, cameras)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let sum = |pairs: Vec<Pair>| {
            let found: Option<Vec<_>> =
                pairs.into_iter().map(|pair| self.derivatives(pair)).collect();
            let sum = |at: usize| found.as_ref().map(|all| all.iter().map(|of| of[at]).sum());
            [0, 1, 2, 3, 4, 5].map(sum)
        };
        self.pairs().into_iter().flat_map(sum).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let blocks = self.pairs();
        let pairs = &blocks[index / POSE];
        let part = index % POSE / 3;
        let size: f64 = pairs.iter().map(|&pair| self.sizes(pair)[part]).sum();
        if size == 0.0 {
            return Bound::EXACT;
        }
        // 6e-8 for each sum
        let sums = 1.0 + pairs.len() as f64 / 16.0;
        // what is flushed on the way may be multiplied by focal lengths, and by places
        Bound { scale: size * sums, floor: f64::from(TINY) * 1e9 * sums }
    }
}

/// Inputs of `pose_sum`.
#[derive(Clone, Debug)]
pub struct PoseSum {
    /// Blocks of a camera.
    pub blocks: u32,
    /// The blocks to add.
    pub range: [u32; 2],
    /// Each camera's place.
    pub index: Vec<u32>,
    /// `[cameras, blocks, 6]`
    pub partial: Vec<f32>,
    /// `[places, 6]`: what other parts have left.
    pub gradient: Vec<f32>,
}

impl PoseSum {
    /// Three of five places.
    fn new(blocks: u32, fill: Fill, random: &mut Random) -> Self {
        let index = vec![4, 0, 2];
        let values = POSE * index.len() * blocks as usize;
        Self {
            blocks,
            range: [blocks / 3, blocks],
            index,
            partial: fill.values(random, values, [-1.0, 1.0], 1e30),
            gradient: fill.values(random, POSE * 5, [-1.0, 1.0], 1e30),
        }
    }

    /// What a value of `gradient` is the sum of.
    fn terms(&self, at: usize) -> impl Iterator<Item = f64> {
        let before = self.gradient.get(at).copied();
        let slot = self.index.iter().position(|&index| index as usize == at / POSE);
        let [first, end] = self.range.map(|block| block as usize);
        let blocks = slot.into_iter().flat_map(move |slot| {
            (first..end).map(move |block| (slot * self.blocks as usize + block) * POSE + at % POSE)
        });
        before.into_iter().chain(blocks.map(|from| self.partial[from])).map(f64::from)
    }
}

impl Parity for PoseSum {
    const KERNEL: &'static str = "pose_sum";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str =
        "a rounding for each block where drivers regroup, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let (cameras, [first, end]) = (self.index.len() as u32, self.range);
        let kernel = PoseSumKernel {
            params: PoseSumParams { cameras, blocks: self.blocks, first, end },
            index: &self.index,
            partial: &self.partial,
            gradient: &self.gradient,
        };
        runner.run(&kernel, cameras * VALUES, 1)
    }

    fn exact_at(&self, _: &str, at: usize) -> Option<f64> {
        Some(self.terms(at).sum())
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let terms: Vec<_> = self.terms(index).collect();
        if terms.len() < 2 {
            // a place without a camera
            return Bound::EXACT;
        }
        let roundings = terms.len() as f64;
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        Bound { scale: roundings * size, floor: roundings * f64::from(TINY) }
    }
}
