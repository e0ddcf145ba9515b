//! The case of `statistics`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::project_backward::ProjectBackwardParams;
use organza_shaders::statistics::{StatisticsInputs, StatisticsParams};

use super::project_backward::ProjectBackward;

/// The pairs are those of `project_backward`.
#[derive(Clone)]
pub struct Statistics {
    pairs: ProjectBackward,
    inputs: StatisticsInputs,
}

impl Statistics {
    fn new(pairs: ProjectBackward) -> Self {
        let ProjectBackwardParams { gaussians, words, first_camera, cameras, .. } =
            pairs.inputs.params;
        let before = Random::new(10).values(4 * gaussians as usize, 0.0, 5.0);
        let radii = pairs.radius.iter();
        let inputs = StatisticsInputs {
            params: StatisticsParams { gaussians, words, first_camera, cameras },
            projection: radii.flat_map(|&r| [Vec4::ONE.with_z(r), Vec4::ONE]).collect(),
            pair_mask: pairs.inputs.pair_mask.clone(),
            first_pair: pairs.inputs.first_pair.clone(),
            pair_gradient: pairs.inputs.pair_gradient.clone(),
            statistics: before.chunks(4).map(Vec4::from_slice).collect(),
        };
        Self { pairs, inputs }
    }

    /// A Gaussian's statistics: how far the centers are pulled, the cameras that have a pair, the largest radius.
    fn exact_of(&self, gaussian: usize) -> [f64; 4] {
        let mut after = self.inputs.statistics[gaussian].as_dvec4().to_array();
        for (camera, [center, ..]) in self.pairs.pairs(gaussian) {
            let count = self.pairs.forward.gaussians as usize;
            let radius = self.pairs.radius[camera * count + gaussian];
            after[0] += f64::from(center.x).hypot(f64::from(center.y));
            after[1] += 1.0;
            after[2] = after[2].max(f64::from(radius));
        }
        after
    }
}

impl Parity for Statistics {
    const KERNEL: &'static str = "statistics";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str =
        "a length's roundings and a square root of 3 ulp; a rounding for each camera";

    fn sets() -> Vec<(String, Self)> {
        ProjectBackward::sets().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.inputs.kernel(), self.inputs.params.gaussians, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let gaussians = 0..self.inputs.statistics.len();
        gaussians.flat_map(|gaussian| self.exact_of(gaussian)).map(Some).collect()
    }

    /// The number of cameras is added to that of other parts: one rounding, the same on every device.
    fn exact_bound(&self, exact: &Output, index: usize, rounding: Rounding) -> Bound {
        match index % 4 {
            1 => Bound::relative_to(exact.floats()[index]),
            _ => self.bound(exact, index, rounding),
        }
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        if index.is_multiple_of(4) {
            return Bound::relative_to(self.exact_of(index / 4)[0]);
        }
        Bound::EXACT
    }
}
