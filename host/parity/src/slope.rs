//! The cases of `slope` and `slope_backward`.

use muslin_check::prelude::*;
use organza_shaders::slope::{
    SLOPE_GRADIENT_VECTORS, SLOPE_VECTORS, SlopeBackwardInputs, SlopeInputs, SlopeParams, VALUES,
};

use super::exact::project::Projected;
use super::exact::slope::{axes, growth};
use super::project::Project;
use super::splat::SplatBackward;

/// A Gaussian in a camera, if it is seen there for certain.
fn projected(scene: &Project, slot: u32) -> Option<Projected<Rounded>> {
    let gaussians = scene.params.gaussians;
    scene.fate((slot / gaussians) as usize, (slot % gaussians) as usize)?.ok()
}

case!(pub Slope(SlopeInputs) { scene: Project });

impl Slope {
    fn new(scene: Project) -> Self {
        let mut random = Random::new(19);
        let gaussians = scene.params.gaussians;
        // a Gaussian that is culled has no pair
        let mut pair = scene.some_slots(&mut random);
        pair.retain(|&slot| projected(&scene, slot).is_some());
        let inputs = SlopeInputs {
            params: SlopeParams { pairs: pair.len() as u32, gaussians },
            camera: scene.camera.clone(),
            position: scene.position.clone(),
            rotation: scene.rotation.clone(),
            log_scale: scene.log_scale.clone(),
            projection: Fill::Random.vectors(&mut random, scene.projection.len(), [-1.0, 1.0], 0.0),
            slope: random.values((gaussians * VALUES) as usize, -1.0, 1.0),
            pair_slope: unwritten(pair.len() * SLOPE_VECTORS as usize),
            pair,
        };
        Self { scene, inputs }
    }
}

impl Parity for Slope {
    fn sets() -> Vec<(String, Self)> {
        Project::everywhere().into_iter().map(|(name, scene)| (name, Self::new(scene))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let gaussians = self.params.gaussians;
        let of = |&slot: &u32| {
            let gaussian = (slot % gaussians) as usize;
            let found = projected(&self.scene, slot).expect("it has a pair");
            let conic = self.projection[2 * slot as usize + 1].to_array().map(Rounded::from);
            let axes = axes(&found, [conic[0], conic[1], conic[2]]);
            let slope = std::array::from_fn(|k| {
                let first = VALUES as usize * gaussian + 3 * k;
                std::array::from_fn(|channel| self.slope[first + channel].into())
            });
            let vectors = growth(slope, axes).into_iter().chain(axes);
            vectors.flat_map(|[x, y, z]| [x, y, z, Rounded::exact(0.0)]).collect::<Vec<_>>()
        };
        listed(self.pair.iter().flat_map(of))
    }
}

case!(pub SlopeBackward(SlopeBackwardInputs) { splats: SplatBackward });

impl SlopeBackward {
    fn new(gaussians: u32, fill: Fill, random: &mut Random) -> Self {
        let splats = SplatBackward::new(gaussians, fill, random);
        let pairs = splats.pair.len();
        let intersections = splats.intersection_gradient.len() / 3;
        let gradients = intersections * SLOPE_GRADIENT_VECTORS as usize;
        let inputs = SlopeBackwardInputs {
            params: splats.params,
            pair: splats.pair.clone(),
            first_tile: splats.first_tile.clone(),
            tile_mask: splats.tile_mask.clone(),
            first_intersection: splats.first_intersection.clone(),
            pair_slope: Fill::Random.vectors(
                random,
                pairs * SLOPE_VECTORS as usize,
                [-1.0, 1.0],
                0.0,
            ),
            intersection_slope: fill.vectors(random, gradients, [-1.0, 1.0], 1e37),
            slope_gradient: unwritten(pairs * VALUES as usize),
        };
        Self { splats, inputs }
    }
}

impl Parity for SlopeBackward {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(Self::new)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let sums = self.splats.sums::<8>(&self.intersection_slope);
        let of = |(pair, slot): (usize, &u32)| {
            let [x, y] = [2, 3].map(|at| {
                self.pair_slope[SLOPE_VECTORS as usize * pair + at].to_array().map(Rounded::from)
            });
            let sum = sums[slot];
            let value = move |k: usize, c: usize| sum[c] * x[k] + sum[4 + c] * y[k];
            (0..3).flat_map(move |k| (0..3).map(move |channel| value(k, channel)))
        };
        listed(self.pair.iter().enumerate().flat_map(of))
    }
}
