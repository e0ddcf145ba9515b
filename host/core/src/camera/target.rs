//! The place that cameras look at.

use glam::{DMat3, DVec3};

use super::Camera;

/// The place that cameras look at, and its size.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The point that they look at, in world units.
    pub center: DVec3,
    /// Typical distance of the cameras, in world units.
    pub distance: f64,
    /// Radius of the ball around the center that fills the images' longer sides, in world units.
    pub radius: f64,
    /// Whether the optical axes meet in front of the cameras. Otherwise the distance is a guess from the cameras'
    /// spread.
    pub is_met: bool,
}

impl Target {
    /// The point nearest to the cameras' optical axes. A few cameras that look elsewhere do not move it.
    pub fn from_cameras(cameras: &[Camera]) -> Self {
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
            // a camera that stands still gives no distance
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

    /// The box around the ball that the images show, its radius times `part`: lowest and highest corner.
    pub fn ball(&self, part: f64) -> [DVec3; 2] {
        [self.center - part * self.radius, self.center + part * self.radius]
    }
}

/// The direction that a camera looks in, a unit vector.
fn axis(camera: &Camera) -> DVec3 {
    camera.axes()[2].normalize_or_zero()
}

/// The point with the least sum of distances to the axes, by iteratively reweighted least squares (Weiszfeld).
fn nearest_to_axes(eyes: &[DVec3], axes: &[DVec3], middle: DVec3, spread: f64) -> DVec3 {
    let min = (1e-3 * spread).max(1e-12);
    let mut center = middle;
    let mut weights = vec![1.0; eyes.len()];
    for _ in 0..30 {
        // if all axes are parallel, no point is nearest: a small weight on the middle of the eyes decides
        let ridge = 1e-3 * weights.iter().sum::<f64>().max(1e-12);
        let mut matrix = DMat3::from_diagonal(DVec3::splat(ridge));
        let mut right = middle * ridge;
        for ((&eye, &axis), &weight) in eyes.iter().zip(axes).zip(&weights) {
            let along = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
            let across = (DMat3::IDENTITY - along) * weight;
            matrix += across;
            right += across * eye;
        }
        center = matrix.inverse() * right;
        for ((weight, &eye), &axis) in weights.iter_mut().zip(eyes).zip(axes) {
            *weight = 1.0 / (center - eye).reject_from_normalized(axis).length().max(min);
        }
    }
    center
}

/// The median; 0 without numbers.
pub fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<_> = numbers.collect();
    if numbers.is_empty() {
        return 0.0;
    }
    let middle = numbers.len() / 2;
    *numbers.select_nth_unstable_by(middle, f64::total_cmp).1
}
