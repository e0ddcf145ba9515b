//! The space of a capture: the place that its cameras look at, and the box of its scene.

use glam::DVec3;

use organza_core::camera::{Camera, Target};
use organza_data::Point;

/// Part of the points' weight that the box leaves out at each end of an axis.
const LEFT_OUT: f64 = 0.005;
/// Margin at each end of an axis, as a part of its length.
const MARGIN: f64 = 0.05;
/// Shortest side of the box, as a part of the longest. So points in a plane have a box, too.
const THINNEST: f64 = 0.1;
/// Largest number of points that determine the box.
const MAX_POINTS: usize = 10_000;
/// Largest number of cameras that determine it.
const MAX_CAMERAS: usize = 200;

/// The scene's box: the points that cameras see, without the few that are far away.
///
/// Each camera that sees a point adds to the point's weight, and less for a farther point, which looks smaller in its
/// photograph. On each axis, the box leaves out the same small part of the weight at both ends. The box
/// contains the object in which the optical axes meet.
pub(super) fn scene_box(cameras: &[Camera], target: &Target, points: &[Point]) -> [[f64; 3]; 2] {
    let points = points.iter().map(|point| DVec3::from(point.position));
    let [mut low, mut high] = seen(cameras, target, points);
    if target.is_met {
        // an object may have few points, but images show it all the same
        let [inner_low, inner_high] = target.ball(0.5);
        low = low.min(inner_low);
        high = high.max(inner_high);
    }
    let min = ((high - low).max_element() * THINNEST).max(1e-6);
    let middle = (low + high) / 2.0;
    let half = ((high - low) / 2.0).max(DVec3::splat(min / 2.0));
    [(middle - half).to_array(), (middle + half).to_array()]
}

/// The box of the points that cameras see. At least one point must be visible.
fn seen(
    cameras: &[Camera],
    target: &Target,
    points: impl ExactSizeIterator<Item = DVec3>,
) -> [DVec3; 2] {
    let stride = points.len().div_ceil(MAX_POINTS).max(1);
    let cameras: Vec<_> = cameras.iter().step_by(cameras.len().div_ceil(MAX_CAMERAS)).collect();
    let mut points: Vec<_> = points
        .step_by(stride)
        .map(|point| {
            let depths =
                cameras.iter().filter_map(|camera| camera.depth_in_image(point.to_array()));
            (point, depths.map(|depth| (target.distance + depth).powi(-2)).sum::<f64>())
        })
        .collect();
    if points.iter().all(|(_, weight)| *weight <= 0.0) {
        points.iter_mut().for_each(|(_, weight)| *weight = 1.0);
    }
    let total: f64 = points.iter().map(|(_, weight)| weight).sum();
    let [mut low, mut high] = [DVec3::ZERO; 2];
    for axis in 0..3 {
        points.sort_by(|(a, _), (b, _)| a[axis].total_cmp(&b[axis]));
        low[axis] = after(points.iter(), LEFT_OUT * total)[axis];
        high[axis] = after(points.iter().rev(), LEFT_OUT * total)[axis];
    }
    let margin = MARGIN * (high - low);
    [low - margin, high + margin]
}

/// The first of the weighted points that brings the sum of the weights above `left_out`.
fn after<'a>(mut points: impl Iterator<Item = &'a (DVec3, f64)>, left_out: f64) -> DVec3 {
    let mut sum = 0.0;
    let found = points.find(|(_, weight)| {
        sum += weight;
        sum > left_out
    });
    found.map_or(DVec3::ZERO, |(point, _)| *point)
}

#[cfg(test)]
mod tests;
