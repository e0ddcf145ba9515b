//! Statistics that densification decides by: how strongly the loss pulls a Gaussian's projections, in how many cameras, and how large they are.

use glam::{Vec3, Vec4};

use crate::limits::MAX_CAMERAS;
use crate::splat::VECTORS;
use muslin::math::{length, max};
use muslin::prelude::*;

/// Parameters of [`statistics`].
#[params]
pub struct StatisticsParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Words of a camera's mask.
    pub words: u32,
    /// The first camera.
    pub first_camera: u32,
    /// Cameras from there on.
    pub cameras: u32,
}

/// Adds the pairs of a Gaussian in some of the cameras, one after the other, to `statistics [gaussians]`: the sum of |dL/dmean2d| over cameras,
/// how many cameras have the Gaussian in a pair, its largest radius in pixels, 0.
///
/// `projection [cameras, gaussians, 2]` comes from [`project`](crate::project::project), `pair_gradient [pairs, 3]`
/// from [`splat_backward`](crate::splat::splat_backward).
#[kernel(threads(64), over(params.gaussians), iterations = MAX_CAMERAS)]
pub fn statistics(
    id: Invocation,
    params: &StatisticsParams,
    projection: Read<Vec4>,
    pair_mask: Read<u32>,
    first_pair: Read<u32>,
    pair_gradient: Read<Vec4>,
    statistics: Write<Vec4>,
) {
    let gaussian = id.index();
    if gaussian < params.gaussians {
        let word = gaussian / 32;
        let bit = 1 << (gaussian % 32);
        let before = statistics.read(gaussian);
        let mut moved = before.x;
        let mut seen = before.y;
        let mut radius = before.z;
        let end = params.first_camera + params.cameras;
        let mut camera = params.first_camera;
        while camera < end {
            let bits = pair_mask.read(camera * params.words + word);
            if bits & bit != 0 {
                let below = (bits & (bit - 1)).count_ones();
                let pair = first_pair.read(camera * params.words + word) + below;
                let geometry = pair_gradient.read(VECTORS * pair);
                moved += length(Vec3::new(geometry.x, geometry.y, 0.0));
                seen += 1.0;
                radius = max(radius, projection.read(2 * (camera * params.gaussians + gaussian)).z);
            }
            camera += 1;
        }
        if seen > before.y {
            statistics.write(gaussian, Vec4::new(moved, seen, radius, before.w));
        }
    }
}
