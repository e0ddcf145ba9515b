//! A camera and its lens, as in `docs/conventions.md`: the reference of the kernels' [lens](organza_shaders::lens).

use glam::{DVec2, DVec3};
use organza_shaders::camera::Camera;

use super::numeric::{Number, dot};

/// A camera with a pinhole.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Its axes in the world: right, down, forward.
    pub axes: [[f64; 3]; 3],
    /// Its center in the world.
    pub eye: [f64; 3],
    /// Focal lengths, in pixels.
    pub focal: [f64; 2],
    /// The principal point, in pixels.
    pub center: [f64; 2],
    /// Width and height, in pixels.
    pub size: [f64; 2],
}

impl View {
    /// The camera of a kernel.
    #[must_use]
    pub fn of(camera: &Camera) -> Self {
        Self {
            axes: camera.rotation.map(|row| row.as_dvec3().to_array()),
            eye: camera.eye.as_dvec3().to_array(),
            focal: camera.focal.as_dvec2().to_array(),
            center: camera.center.as_dvec2().to_array(),
            size: camera.size.as_dvec2().to_array(),
        }
    }

    /// A position in the camera's space.
    pub fn place<N: Number>(&self, position: [N; 3]) -> [N; 3] {
        let offset = std::array::from_fn(|axis| position[axis] - N::from(self.eye[axis]));
        self.axes.map(|axis| dot(axis.map(N::from), offset))
    }

    /// Distance of a point of the camera's space in front of the near plane; zero or less if the lens does not see it.
    pub fn above_near<N: Number>([_, _, z]: [N; 3]) -> f64 {
        // as an f32 has it
        z.value() - f64::from(0.01_f32)
    }

    /// The projection of a point of the camera's space, in pixels.
    pub fn pixel<N: Number>(&self, [x, y, z]: [N; 3]) -> [N; 2] {
        let ratios = [x / z, y / z];
        std::array::from_fn(|i| N::from(self.focal[i]) * ratios[i] + N::from(self.center[i]))
    }

    /// Rows of J W at a point of the camera's space.
    pub fn rows<N: Number>(&self, [x, y, z]: [N; 3]) -> [[N; 3]; 2] {
        let ratios = [x / z, y / z];
        std::array::from_fn(|i| {
            let (ratio, focal) = (self.clamped(i, ratios[i]), N::from(self.focal[i]) / z);
            std::array::from_fn(|k| {
                (N::from(self.axes[i][k]) - ratio * N::from(self.axes[2][k])) * focal
            })
        })
    }

    /// A ratio in J, clamped to the image's border plus 0.3 of half its size: the slope is 0 there.
    fn clamped<N: Number>(&self, axis: usize, ratio: N) -> N {
        let [low, high] = self.limits(axis);
        if ratio.value() < low {
            N::from(low)
        } else if ratio.value() > high {
            N::from(high)
        } else {
            ratio
        }
    }

    /// The smallest and the largest ratio of an axis in J.
    fn limits(&self, axis: usize) -> [f64; 2] {
        let (focal, center) = (self.focal[axis], self.center[axis]);
        let margin = 0.3 * 0.5 * self.size[axis] / focal;
        [-center / focal - margin, (self.size[axis] - center) / focal + margin]
    }

    /// Whether a ratio is so close to its limit that rounding decides if it is clamped.
    pub(in crate::parity) fn is_near_limit(&self, t: DVec3, distance: f64) -> bool {
        let slack = 1e-5 * Self::cancellation(t, distance) * (1.0 + t.truncate().length() / t.z);
        let is_near = |axis: usize, limit: f64| (t[axis] / t.z - limit).abs() <= slack;
        (0..2).any(|axis| self.limits(axis).iter().any(|&limit| is_near(axis, limit)))
    }

    /// How much larger the terms of a point's depth may be than their sum, at a distance from the camera.
    pub(in crate::parity) fn cancellation(t: DVec3, distance: f64) -> f64 {
        1.0 + distance / t.z
    }

    /// Largest size of the terms of the projected point.
    pub(in crate::parity) fn pixel_terms(&self, t: DVec3, distance: f64) -> DVec2 {
        let ratio = 1.0 + t.x.abs().max(t.y.abs()) / t.z;
        DVec2::from_array(self.focal) * Self::cancellation(t, distance) * ratio + 500.0
    }

    /// Largest size of the terms of a position's gradient.  The sizes are those of the gradient with respect to the rows of
    /// `J W`, of these rows, and of the gradient with respect to the pixel.
    pub(in crate::parity) fn gradient_terms(
        &self,
        t: DVec3,
        distance: f64,
        [by_row, row, by_pixel]: [f64; 3],
    ) -> f64 {
        let ratio = 1.0 + t.truncate().length() / t.z;
        let slope = self.focal[0].max(self.focal[1]) / t.z;
        let terms = by_row * (slope / t.z + row / t.z) + slope * by_pixel;
        terms * ratio * Self::cancellation(t, distance)
    }
}
