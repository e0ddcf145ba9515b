//! Clusters of points in the plane: each point goes to the nearest center, and each center to the mean of its points (Lloyd 1982).

use muslin::prelude::*;

/// Most clusters.
pub const MAX_CLUSTERS: u32 = 256;
/// Invocations that look for the points of a cluster.
const GROUP: u32 = 64;
/// Most points.
pub const MAX_POINTS: u32 = 1 << 21;

/// Parameters of the kernels of this file.
#[params]
pub struct ClusterParams {
    /// Points, at most [`MAX_POINTS`].
    pub points: u32,
    /// Clusters, at most [`MAX_CLUSTERS`].
    pub clusters: u32,
}

/// The nearest center of each point, the first one of equals: `point [points]`, `center [clusters]`, `nearest [points]`.
#[kernel(threads(256), over(params.points), iterations = MAX_CLUSTERS)]
pub fn k_means_assign(
    id: Invocation,
    params: &ClusterParams,
    point: Read<Vec2>,
    center: Read<Vec2>,
    nearest: Write<u32>,
) {
    let index = id.index();
    if index < params.points {
        let own = point.read(index);
        let mut least = (own - center.read(0)).length_squared();
        let mut best = 0;
        for cluster in 1..params.clusters {
            let distance = (own - center.read(cluster)).length_squared();
            if distance < least {
                least = distance;
                best = cluster;
            }
        }
        nearest.write(index, best);
    }
}

/// The mean of each cluster's points: a workgroup a cluster. A center without points stays. `point [points]`, `nearest [points]`,
/// `center [clusters]`.
#[kernel(threads(GROUP), over(GROUP * params.clusters), iterations = MAX_POINTS / GROUP + 6)]
pub fn k_means_update(
    id: Invocation,
    params: &ClusterParams,
    point: Read<Vec2>,
    nearest: Read<u32>,
    center: Write<Vec2>,
    part: Shared<Vec4, { GROUP as usize }>,
) {
    let own = id.local.x;
    let cluster = id.workgroup_index();
    let mut sum = Vec4::ZERO;
    let mut index = own;
    while index < params.points {
        if nearest.read(index) == cluster {
            sum += point.read(index).extend(1.0).extend(0.0);
        }
        index += GROUP;
    }
    part.write(own, sum);
    id.barrier();
    let mut stride = GROUP / 2;
    while stride > 0 {
        if own < stride {
            part.write(own, part.read(own) + part.read(own + stride));
        }
        id.barrier();
        stride /= 2;
    }
    let sum = part.read(0);
    if own == 0 && cluster < params.clusters && sum.z > 0.0 {
        center.write(cluster, Vec2::new(sum.x, sum.y) / sum.z);
    }
}
