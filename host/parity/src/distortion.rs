//! Cases of `pair_inverse_distance` and `distortion_backward`.

use muslin_check::prelude::*;
use organza_shaders::distortion::{
    DistortionBackwardInputs, DistortionParams, MIN_DISTANCE, PairInverseDistanceInputs,
    PairInverseDistanceParams,
};

use super::composite::{SIDES, pixel, planes, tiles};
use super::exact::numeric::dot;
use super::project::Project;
use super::tile::pack;

case!(pub PairInverseDistance(PairInverseDistanceInputs) { scene: Project });

impl PairInverseDistance {
    fn new(mut scene: Project) -> Self {
        // squares of distances are finite
        scene.position.iter_mut().for_each(|place| *place = place.clamp(-1e15, 1e15));
        let pair = scene.some_slots(&mut Random::new(9));
        let pairs = pair.len() as u32;
        let inputs = PairInverseDistanceInputs {
            params: PairInverseDistanceParams { pairs, gaussians: scene.params.gaussians },
            camera: scene.camera.clone(),
            position: scene.position.clone(),
            power: unwritten(3 * pair.len()),
            pair,
        };
        Self { scene, inputs }
    }
}

impl Parity for PairInverseDistance {
    fn sets() -> Vec<(String, Self)> {
        Project::everywhere().into_iter().map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let of = |&slot: &u32| {
            let (view, gaussian) = self.scene.slot(slot);
            let center = self.scene.gaussian(gaussian).position;
            let offset = [0, 1, 2].map(|i| center[i] - view.eye[i]);
            let distance = dot(offset, offset).sqrt();
            let u = Rounded::from(1.0) / distance.max(MIN_DISTANCE.into());
            [u, u * u, 0.0.into()]
        };
        listed(self.pair.iter().flat_map(of))
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
        let [weight, mean] = [weights, means].map(|[min, max]| random.values(pixels, min, max));
        // S M_2 / M_1^2 is at least 1
        let spread = random.values(pixels, 1.0, 4.0);
        let sum = (0..pixels).map(|i| match i % 7 {
            0 => [0.0; 4],
            _ => {
                let first = weight[i] * mean[i];
                [first, first * mean[i] * spread[i], 0.0, weight[i]]
            }
        });
        Self(DistortionBackwardInputs {
            params: DistortionParams { side, scale: 0.01 },
            tile: pack(&tiles),
            sum: planes(sum, area),
            valid: (0..pixels).map(|_| f32::from(random.below(3) > 0)).collect(),
            sum_gradient: unwritten(4 * pixels),
        })
    }
}

impl Parity for DistortionBackward {
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

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let area = (self.params.side * self.params.side) as usize;
        let of = |at: usize| {
            let [m1, m2, _, weight] = pixel(&self.sum, area, at);
            if weight.value <= 0.0 {
                return [Rounded::exact(0.0); 4];
            }
            let output = tiles()[at / area].output as usize;
            let valid = Rounded::from(self.valid[output * area + at % area]);
            let factor = Dual::constant(valid * self.params.scale.into());
            let [by_m1, by_m2, by_weight] = gradient([m1, m2, weight], |[m1, m2, weight]| {
                let one = Dual::from(1.0);
                let share = weight.above(1.0, one, weight);
                factor * share * share * (weight * m2 / (m1 * m1) - one)
            });
            [by_m1, by_m2, 0.0.into(), by_weight]
        };
        listed(planes((0..self.sum.len() / 4).map(of), area))
    }
}
