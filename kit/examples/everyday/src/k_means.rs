//! Clusters of points.

use glam::Vec2;
use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::k_means::{
    ClusterParams, KMeansAssignInputs, KMeansAssignKernel, KMeansUpdateInputs, KMeansUpdateKernel,
};

/// Moves centers in some rounds, and returns them with each point's cluster.
///
/// # Errors
/// Any error of the device.
pub fn k_means(
    device: &Device,
    point: &Buffer<Vec2>,
    centers: &[Vec2],
    rounds: u32,
) -> Result<(Vec<Vec2>, Vec<u32>)> {
    let params = ClusterParams { points: point.len() as u32, clusters: centers.len() as u32 };
    let center = device.upload("centers", centers)?;
    let nearest = device.unwritten("clusters", point.len())?;
    for _ in 0..rounds {
        let kernel = KMeansAssignKernel { params, point, center: &center, nearest: &nearest };
        device.run_all(&kernel)?;
        let kernel = KMeansUpdateKernel { params, point, nearest: &nearest, center: &center };
        device.run_all(&kernel)?;
    }
    Ok((device.read(&center)?, device.read(&nearest)?))
}

/// Points of whole numbers: distances are exact, and many are equal.
fn points(count: u32, random: &mut Random) -> Vec<Vec2> {
    let mut number = || random.below(64) as f32;
    (0..count).map(|_| Vec2::new(number(), number())).collect()
}

case!(pub KMeansAssign(KMeansAssignInputs));

impl Parity for KMeansAssign {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let clusters = 1 + random.below(20);
            Self(KMeansAssignInputs {
                params: ClusterParams { points: count, clusters },
                point: points(count, random),
                center: points(clusters, random),
                nearest: unwritten(count as usize),
            })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let distance = |center: &Vec2| {
            let away = self.point[index].as_ivec2() - center.as_ivec2();
            away.x * away.x + away.y * away.y
        };
        // the first one of equals
        let nearest = (0..self.center.len()).min_by_key(|&at| distance(&self.center[at]));
        nearest.map(|at| (at as u32).into())
    }
}

case!(pub KMeansUpdate(KMeansUpdateInputs));

impl Parity for KMeansUpdate {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let clusters = 5;
            Self(KMeansUpdateInputs {
                params: ClusterParams { points: count, clusters },
                point: points(count, random),
                // the last one has no points
                nearest: (0..count).map(|_| random.below(clusters - 1)).collect(),
                center: points(clusters, random),
            })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let mean = |(cluster, center): (usize, &Vec2)| {
            let all = self.point.iter().zip(&self.nearest);
            let own = all.filter(|(_, nearest)| **nearest as usize == cluster);
            let own: Vec<_> = own.map(|(point, _)| *point).collect();
            if own.is_empty() {
                return center.to_array().map(Rounded::from);
            }
            let sum = |of: fn(&Vec2) -> f32| own.iter().map(of).sum::<f32>();
            [sum(|at| at.x), sum(|at| at.y)]
                .map(|sum| Rounded::from(sum) / Rounded::from(own.len() as u32))
        };
        listed(self.center.iter().enumerate().flat_map(mean))
    }
}
