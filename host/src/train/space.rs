//! Where a capture takes place: what its cameras look at, and the box of its scene.

use glam::{DMat3, DVec3};

use crate::camera::Camera;
use crate::data::Point;

/// The part of the points' weight that the box leaves out at each end of an axis.
const LEFT_OUT: f64 = 0.005;
/// What is added to each end of an axis, as a part of its length.
const MARGIN: f64 = 0.05;
/// The shortest side of the box, as a part of the longest: points in a plane have a box all the same.
const THINNEST: f64 = 0.1;
/// The most points that decide on the box.
const MOST_POINTS: usize = 10_000;
/// The most cameras that decide on it.
const MOST_CAMERAS: usize = 200;

/// What the cameras look at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub center: DVec3,
    /// Typical distance of the cameras.
    pub distance: f64,
    /// Radius of the ball around it that fills the images' longer sides.
    pub radius: f64,
    /// Whether the optical axes meet in front of the cameras. Otherwise the distance is a guess, from how far the
    /// cameras are apart.
    pub is_met: bool,
}

impl Target {
    /// The point that is nearest to the cameras' optical axes. A few cameras that look elsewhere do not move it.
    pub fn of(cameras: &[Camera]) -> Self {
        let eyes: Vec<_> = cameras.iter().map(|camera| DVec3::from(camera.eye())).collect();
        let axes: Vec<_> = cameras.iter().map(axis).collect();
        let middle = DVec3::from_array(std::array::from_fn(|i| median(eyes.iter().map(|e| e[i]))));
        let spread = median(eyes.iter().map(|eye| eye.distance(middle)));
        let center = nearest_to_axes(&eyes, &axes, middle, spread);

        let away = |eye: &DVec3, axis: &DVec3| (center - *eye).reject_from_normalized(*axis);
        let pairs = || eyes.iter().zip(&axes);
        let in_front = pairs().filter(|(eye, axis)| axis.dot(center - **eye) > 0.0).count();
        let missed = median(pairs().map(|(eye, axis)| away(eye, axis).length()));
        let distance = median(eyes.iter().map(|eye| eye.distance(center)));
        let is_met = 4 * in_front >= 3 * eyes.len() && missed < 0.5 * distance;

        let (center, distance) = if is_met {
            (center, distance)
        } else {
            // a camera that stands still tells nothing about distances
            let is_still = spread <= 1e-6 * (1.0 + middle.length());
            let distance = if is_still { 1.0 } else { 2.0 * spread };
            (middle + axes.iter().sum::<DVec3>() / axes.len().max(1) as f64 * distance, distance)
        };
        let half = |camera: &Camera| {
            let sides =
                [f64::from(camera.width) / camera.fl_x, f64::from(camera.height) / camera.fl_y];
            sides[0].max(sides[1]) / 2.0
        };
        Self { center, distance, radius: distance * median(cameras.iter().map(half)), is_met }
    }

    /// The box of the ball that the images show.
    fn ball(&self, part: f64) -> [DVec3; 2] {
        [self.center - part * self.radius, self.center + part * self.radius]
    }
}

/// Where a camera looks, a unit vector.
fn axis(camera: &Camera) -> DVec3 {
    DVec3::from(camera.world_to_camera_opencv()[2]).normalize_or_zero()
}

/// The point with the least sum of distances to the axes, found by repeated weighted least squares (Weiszfeld).
fn nearest_to_axes(eyes: &[DVec3], axes: &[DVec3], middle: DVec3, spread: f64) -> DVec3 {
    let least = (1e-3 * spread).max(1e-12);
    let mut center = middle;
    let mut weights = vec![1.0; eyes.len()];
    for _ in 0..30 {
        // where all axes are parallel no point is nearest: a little weight on the middle of the eyes decides
        let ridge = 1e-3 * weights.iter().sum::<f64>().max(1e-12);
        let (mut matrix, mut right) = (DMat3::from_diagonal(DVec3::splat(ridge)), middle * ridge);
        for ((&eye, &axis), &weight) in eyes.iter().zip(axes).zip(&weights) {
            let along = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
            let across = (DMat3::IDENTITY - along) * weight;
            matrix += across;
            right += across * eye;
        }
        center = matrix.inverse() * right;
        for ((weight, &eye), &axis) in weights.iter_mut().zip(eyes).zip(axes) {
            *weight = 1.0 / (center - eye).reject_from_normalized(axis).length().max(least);
        }
    }
    center
}

/// The scene's box: what the cameras see of the points, without the few that are far off.
///
/// Each camera that sees a point adds to its weight: less if the point is farther away, because a photograph then shows less
/// of it. On each axis, the box leaves out the same small part of the weight at both ends. The object that the optical axes
/// meet in is in the box. Without points the box is that of this object. If the axes do not meet either, it is that of
/// `places`, where the first Gaussians are.
pub(super) fn scene_box(
    cameras: &[Camera],
    target: &Target,
    points: &[Point],
    places: &[DVec3],
) -> [[f64; 3]; 2] {
    let [low, high] = match (points.is_empty(), target.is_met) {
        (true, true) => target.ball(1.0),
        (true, false) => seen(cameras, target, places.iter().copied()),
        (false, is_met) => {
            let points = points.iter().map(|point| DVec3::from(point.position));
            let [low, high] = seen(cameras, target, points);
            // where the points of an object are few, images show it all the same
            let [inner_low, inner_high] = target.ball(0.5);
            if is_met { [low.min(inner_low), high.max(inner_high)] } else { [low, high] }
        }
    };
    let least = ((high - low).max_element() * THINNEST).max(1e-6);
    let (middle, half) = ((low + high) / 2.0, ((high - low) / 2.0).max(DVec3::splat(least / 2.0)));
    [(middle - half).to_array(), (middle + half).to_array()]
}

/// The box of what cameras see of points; there is one at least.
fn seen(
    cameras: &[Camera],
    target: &Target,
    points: impl ExactSizeIterator<Item = DVec3>,
) -> [DVec3; 2] {
    let stride = points.len().div_ceil(MOST_POINTS).max(1);
    let cameras: Vec<_> = cameras.iter().step_by(cameras.len().div_ceil(MOST_CAMERAS)).collect();
    let mut points: Vec<_> = points
        .step_by(stride)
        .map(|point| {
            let depths = cameras.iter().filter_map(|camera| depth(camera, point));
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

/// The first of weighted points that brings the sum of the weights above `left_out`.
fn after<'a>(mut points: impl Iterator<Item = &'a (DVec3, f64)>, left_out: f64) -> DVec3 {
    let mut sum = 0.0;
    let found = points.find(|(_, weight)| {
        sum += weight;
        sum > left_out
    });
    found.map_or(DVec3::ZERO, |(point, _)| *point)
}

/// How deep a place lies in a camera's image, if it is in it.
pub(crate) fn depth(camera: &Camera, place: DVec3) -> Option<f64> {
    let offset = place - DVec3::from(camera.eye());
    let [x, y, z] = camera.world_to_camera_opencv().map(|row| DVec3::from(row).dot(offset));
    let (column, row) = (camera.fl_x * x / z + camera.cx, camera.fl_y * y / z + camera.cy);
    let is_seen = z > 0.0
        && (0.0..f64::from(camera.width)).contains(&column)
        && (0.0..f64::from(camera.height)).contains(&row);
    is_seen.then_some(z)
}

/// The middle of numbers in their order; 0 of none.
pub(crate) fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<_> = numbers.collect();
    if numbers.is_empty() {
        return 0.0;
    }
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests;
