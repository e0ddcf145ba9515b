//! Cases of `pair_inverse_distance` and `distortion_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::distortion::{
    DistortionBackwardInputs, DistortionParams, LEAST_DISTANCE, PairInverseDistanceInputs,
    PairInverseDistanceParams,
};

use super::composite::{SIDES, pixel, pixels, planes, tiles};
use super::exact::numeric::{Dual, Number, gradient};
use super::exact::project::View;
use super::project::Project;
use super::tile::pack;

/// The Gaussians and the cameras in f64 come from the scene.
#[derive(Clone)]
pub struct PairInverseDistance {
    scene: Project,
    inputs: PairInverseDistanceInputs,
}

impl PairInverseDistance {
    fn new(mut scene: Project) -> Self {
        // squares of distances are finite
        scene.position.iter_mut().for_each(|place| *place = place.clamp(-1e15, 1e15));
        let pair = scene.some_slots(&mut Random::new(9));
        let pairs = pair.len() as u32;
        let inputs = PairInverseDistanceInputs {
            params: PairInverseDistanceParams { pairs, gaussians: scene.gaussians },
            camera: scene.packed_cameras(),
            position: scene.position.clone(),
            power: unwritten(3 * pair.len()),
            pair,
        };
        Self { scene, inputs }
    }

    /// The distance of a pair, and the sizes of the places that it is the difference of.
    fn distance(&self, pair: usize) -> [f64; 2] {
        let (View { eye, .. }, gaussian) = self.scene.slot(self.inputs.pair[pair]);
        let center = self.scene.center(gaussian);
        let offset = [0, 1, 2].map(|i| center[i] - eye[i]);
        let sizes = (0..3).map(|i| center[i].abs() + eye[i].abs());
        let distance = offset.into_iter().fold(0.0_f64, f64::hypot);
        [distance.max(LEAST_DISTANCE.into()), sizes.sum()]
    }
}

impl Parity for PairInverseDistance {
    const KERNEL: &'static str = "pair_inverse_distance";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str =
        "roundings of two places and of their difference, a square root and a division of 3 ulp";

    fn sets() -> Vec<(String, Self)> {
        Project::everywhere().into_iter().map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.inputs.kernel(), self.inputs.params.pairs, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let of = |pair: usize| {
            let u = 1.0 / self.distance(pair)[0];
            [u, u * u, 0.0]
        };
        (0..self.inputs.pair.len()).flat_map(of).map(Some).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        if index % 3 == 2 {
            return Bound::EXACT;
        }
        let [distance, sizes] = self.distance(index / 3);
        let u = 1.0 / distance;
        let error = 1.0 + sizes / distance;
        Bound::relative_to(if index.is_multiple_of(3) { u * error } else { 2.0 * u * u * error })
    }
}

case!(pub DistortionBackward(DistortionBackwardInputs));

impl DistortionBackward {
    /// Weights and mean inverse distances from ranges; every seventh pixel has no weight.
    fn new(side: u32, weights: [f32; 2], means: [f32; 2]) -> Self {
        let mut random = Random::new(u64::from(side));
        let tiles = tiles();
        let area = (side * side) as usize;
        let pixels = tiles.len() * area;
        let [weight, mean] =
            [weights, means].map(|[least, most]| random.values(pixels, least, most));
        // S M_2 / M_1^2 is at least 1
        let spread = random.values(pixels, 1.0, 4.0);
        let sum = (0..pixels).map(|i| match i % 7 {
            0 => Vec4::ZERO,
            _ => {
                let first = weight[i] * mean[i];
                Vec4::new(first, first * mean[i] * spread[i], 0.0, weight[i])
            }
        });
        let sum: Vec<_> = sum.collect();
        Self(DistortionBackwardInputs {
            params: DistortionParams { side, scale: 0.01 },
            tile: pack(&tiles),
            sum: planes(&sum, area),
            valid: (0..pixels).map(|_| f32::from(random.below(3) > 0)).collect(),
            sum_gradient: unwritten(4 * pixels),
        })
    }

    fn area(&self) -> usize {
        (self.params.side * self.params.side) as usize
    }

    /// The factor of a pixel's distortion.
    fn factor(&self, pixel: usize) -> f64 {
        let area = self.area();
        let output = tiles()[pixel / area].output as usize;
        f64::from(self.params.scale) * f64::from(self.valid[output * area + pixel % area])
    }
}

impl Parity for DistortionBackward {
    const KERNEL: &'static str = "distortion_backward";
    const TOLERANCE: f64 = 2e-6;
    const WHY: &'static str = "two divisions of 3 ulp, which are squared, and six roundings";

    fn sets() -> Vec<(String, Self)> {
        let sized = SIDES.map(|side| (side, [0.0, 3.0], [0.1, 5.0], "random"));
        let ranges = [
            (9, [0.0, 1e-25], [0.1, 5.0], "hardly any weight"),
            (9, [0.0, 3.0], [1e-7, 1e-6], "far away"),
            (9, [0.0, 3.0], [1e5, 1e6], "at the eye"),
        ];
        let sets = sized.into_iter().chain(ranges);
        sets.map(|(side, weights, means, name)| {
            (format!("{name}, side {side}"), Self::new(side, weights, means))
        })
        .collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let DistortionParams { side, .. } = self.params;
        let outputs = runner.run_over(&self.kernel(), [side, side, tiles().len() as u32])?;
        Ok(pixels(outputs, self.area()))
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let of = |at: usize| {
            let sum = pixel(&self.sum, self.area(), at);
            if sum.w <= 0.0 {
                return [0.0; 4];
            }
            let factor = Dual::from(self.factor(at));
            let [by_m1, by_m2, by_weight] = gradient([sum.x, sum.y, sum.w], |[m1, m2, weight]| {
                let one = Dual::from(1.0);
                let share = if weight.value() > 1.0 { one } else { weight };
                factor * share * share * (weight * m2 / (m1 * m1) - one)
            });
            [by_m1, by_m2, 0.0, by_weight]
        };
        (0..self.sum.len() / 4).flat_map(of).map(Some).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let plane = index % 4;
        let sum = pixel(&self.sum, self.area(), index / 4);
        if sum.w <= 0.0 || plane == 2 {
            return Bound::EXACT;
        }
        let mean = sum.x / sum.w;
        let spread = sum.w * sum.y / (sum.x * sum.x);
        let share = if sum.w > 1.0 { 1.0 / sum.w } else { sum.w };
        let size = match plane {
            0 => 2.0 * share * spread / mean,
            1 => share / (mean * mean),
            _ => share * (3.0 * spread + 2.0),
        };
        // a product may be flushed, and what it is multiplied with is large where it is
        let floor = f64::from(TINY) * (1.0 + 1.0 / (mean * mean)) * (1.0 + spread);
        Bound { scale: self.factor(index / 4) * size, floor }
    }
}
