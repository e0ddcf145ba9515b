//! The case of `statistics`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::statistics::{StatisticsKernel, StatisticsParams};

use super::project_backward::ProjectBackward;

/// Inputs of `statistics`.
#[derive(Clone)]
pub struct Statistics {
    /// The pairs, those of `project_backward`.
    pub pairs: ProjectBackward,
    /// `[gaussians]`: what other parts have left.
    pub statistics: Vec<Vec4>,
}

impl Statistics {
    fn new(pairs: ProjectBackward) -> Self {
        let numbers = Random::new(10).values(4 * pairs.forward.gaussians as usize, 0.0, 5.0);
        Self { pairs, statistics: numbers.chunks(4).map(Vec4::from_slice).collect() }
    }

    /// A Gaussian's statistics: how far the centers are pulled, the cameras that have a pair, the largest radius.
    fn exact_of(&self, gaussian: usize) -> [f64; 4] {
        let mut after = self.statistics[gaussian].as_dvec4().to_array();
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
        let sets = ProjectBackward::sets().into_iter();
        sets.map(|(name, pairs)| (name, Self::new(pairs))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let set = &self.pairs.forward;
        let radii = self.pairs.radius.iter();
        let projection = radii.flat_map(|&radius| [Vec4::ONE.with_z(radius), Vec4::ONE]);
        let kernel = StatisticsKernel {
            params: StatisticsParams {
                gaussians: set.gaussians,
                words: set.gaussians.div_ceil(32),
                first_camera: 0,
                cameras: set.cameras.len() as u32,
            },
            projection: &projection.collect::<Vec<_>>(),
            pair_mask: &self.pairs.pair_mask,
            first_pair: &self.pairs.first_pair,
            pair_gradient: &self.pairs.pair_gradient.as_flattened().to_vec(),
            statistics: &self.statistics,
        };
        runner.run(&kernel, set.gaussians, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let gaussians = 0..self.statistics.len();
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
