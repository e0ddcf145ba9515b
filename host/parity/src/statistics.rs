//! The case of `statistics`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::project_backward::ProjectBackwardParams;
use organza_shaders::statistics::{StatisticsInputs, StatisticsParams};

use super::project_backward::ProjectBackward;

case!(pub Statistics(StatisticsInputs) { pairs: ProjectBackward });

impl Statistics {
    fn new(pairs: ProjectBackward) -> Self {
        let ProjectBackwardParams { gaussians, words, first_camera, cameras, .. } = pairs.params;
        let random = &mut Random::new(10);
        let radii = pairs.radius.iter();
        let inputs = StatisticsInputs {
            params: StatisticsParams { gaussians, words, first_camera, cameras },
            projection: radii.flat_map(|&r| [Vec4::ONE.with_z(r), Vec4::ONE]).collect(),
            pair_mask: pairs.pair_mask.clone(),
            first_pair: pairs.first_pair.clone(),
            pair_gradient: pairs.pair_gradient.clone(),
            statistics: Fill::Random.vectors(random, gaussians as usize, [0.0, 5.0], 0.0),
        };
        Self { pairs, inputs }
    }

    /// A Gaussian's statistics: how far the centers are pulled, the cameras that have a pair, the largest radius.
    fn exact_of(&self, gaussian: usize) -> [Rounded; 4] {
        let mut after = self.statistics[gaussian].to_array().map(Rounded::from);
        for (camera, [center, ..]) in self.pairs.pairs(gaussian) {
            let radius = self.pairs.radius[camera * self.params.gaussians as usize + gaussian];
            let [x, y] = [center.x, center.y].map(Rounded::from);
            after[0] = after[0] + (x * x + y * y).sqrt();
            after[1] = after[1] + 1.0.into();
            after[2] = Rounded::exact(after[2].value.max(radius.into()));
        }
        after
    }
}

impl Parity for Statistics {
    fn sets() -> Vec<(String, Self)> {
        ProjectBackward::sets().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        listed((0..self.statistics.len()).flat_map(|gaussian| self.exact_of(gaussian)))
    }
}
