//! The kernels' [lens](organza_shaders::lens) in f64, as in `docs/conventions.md`: the reference of tests and tolerances.

use glam::{DVec2, DVec3};
use organza_shaders::camera::Camera;
use organza_shaders::lens::NEAR_PLANE;

/// A pinhole.
#[derive(Clone, Copy, Debug)]
pub struct ExactLens {
    /// Focal lengths, in pixels.
    pub focal: DVec2,
    /// Principal point, in pixels.
    pub center: DVec2,
    /// Width and height, in pixels.
    pub size: DVec2,
}

impl ExactLens {
    /// The lens of a camera.
    #[must_use]
    pub fn of(camera: &Camera) -> Self {
        Self {
            focal: camera.focal.as_dvec2(),
            center: camera.center.as_dvec2(),
            size: camera.size.as_dvec2(),
        }
    }

    /// Distance of a point in front of the near plane; zero or less if the lens does not see the point.
    #[must_use]
    pub fn above_near(t: DVec3) -> f64 {
        t.z - f64::from(NEAR_PLANE)
    }

    /// The projected point, in pixels.
    #[must_use]
    pub fn pixel(&self, t: DVec3) -> DVec2 {
        self.focal * t.truncate() / t.z + self.center
    }

    /// Rows of J at a point t.  A ratio that is clamped at `base` is a constant: for finite differences around `base`.
    /// J itself has t as its base.
    #[must_use]
    pub fn jacobian(&self, t: DVec3, base: DVec3) -> [DVec3; 2] {
        let [low, high] = self.limits();
        let (free, at_base) = (t.truncate() / t.z, base.truncate() / base.z);
        let is_free = at_base.cmpge(low) & at_base.cmple(high);
        let ratio = DVec2::select(is_free, free, at_base.clamp(low, high));
        let slope = self.focal / t.z;
        [DVec3::new(slope.x, 0.0, -slope.x * ratio.x), DVec3::new(0.0, slope.y, -slope.y * ratio.y)]
    }

    /// The smallest and the largest x/z and y/z in J.
    fn limits(&self) -> [DVec2; 2] {
        let margin = self.size / self.focal * 0.5 * 0.3;
        [-self.center / self.focal - margin, (self.size - self.center) / self.focal + margin]
    }

    /// Whether a ratio is so close to its limit that rounding decides if it is clamped.
    pub(super) fn is_near_limit(&self, t: DVec3, distance: f64) -> bool {
        let slack = 1e-5 * Self::cancellation(t, distance) * (1.0 + t.truncate().length() / t.z);
        let ratio = t.truncate() / t.z;
        self.limits().iter().any(|limit| (ratio - limit).abs().min_element() <= slack)
    }

    /// How much larger the terms of a point's depth may be than their sum, at a distance from the camera.
    pub(super) fn cancellation(t: DVec3, distance: f64) -> f64 {
        1.0 + distance / t.z
    }

    /// Largest size of the terms of the projected point.
    pub(super) fn pixel_terms(&self, t: DVec3, distance: f64) -> DVec2 {
        let ratio = 1.0 + t.x.abs().max(t.y.abs()) / t.z;
        self.focal * Self::cancellation(t, distance) * ratio + 500.0
    }

    /// Largest size of the terms of a position's gradient.  The sizes are those of the gradient with respect to the rows of
    /// `J W`, of these rows, and of the gradient with respect to the pixel.
    pub(super) fn gradient_terms(
        &self,
        t: DVec3,
        distance: f64,
        [by_row, row, by_pixel]: [f64; 3],
    ) -> f64 {
        let ratio = 1.0 + t.truncate().length() / t.z;
        let slope = self.focal.max_element() / t.z;
        let terms = by_row * (slope / t.z + row / t.z) + slope * by_pixel;
        terms * ratio * Self::cancellation(t, distance)
    }
}
