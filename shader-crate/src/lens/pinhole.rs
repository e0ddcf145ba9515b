//! The pinhole: `x' = f_x x / z + c_x`, and y likewise.

use glam::{Vec2, Vec3};

use super::NEAR_PLANE;
use crate::camera::Camera;
use organza_kernel::math::{clamp, dot};

/// A point through a pinhole: see [`lens`](crate::lens).
#[derive(Clone, Copy, Debug)]
pub struct Pinhole {
    /// Where it lies in the image, in pixels.
    pub pixel: Vec2,
    /// First row of `J W`.
    pub row_x: Vec3,
    /// Second row of `J W`.
    pub row_y: Vec3,
    /// Position in the camera's space.
    t: Vec3,
    /// Depth; 1 for a point that is not seen.
    z: f32,
    /// `x/z` and `y/z` as J has them: clamped to the image's border plus 0.3 of its half width.
    ratio: Vec2,
}

impl Pinhole {
    /// Whether a point of the camera's space lies in front of the near plane.
    #[inline(always)]
    pub fn sees(t: Vec3) -> bool {
        t.z > NEAR_PLANE
    }

    /// The projection of a point of the camera's space.
    #[inline(always)]
    pub fn new(camera: &Camera, t: Vec3) -> Self {
        let z = if Self::sees(t) { t.z } else { 1.0 };
        let pixel = Vec2::new(
            camera.focal.x * t.x / z + camera.center.x,
            camera.focal.y * t.y / z + camera.center.y,
        );

        // the ratios x/z and y/z are clamped in J alone
        let inverse_focal = Vec2::new(1.0 / camera.focal.x, 1.0 / camera.focal.y);
        let margin = camera.size * inverse_focal * 0.15;
        let low = camera.center * inverse_focal * -1.0 - margin;
        let high = (camera.size - camera.center) * inverse_focal + margin;
        let ratio = Vec2::new(clamp(t.x / z, low.x, high.x), clamp(t.y / z, low.y, high.y));

        let [right, down, forward] = camera.rotation;
        let (fx, fy) = (camera.focal.x / z, camera.focal.y / z);
        let row_x = (right - forward * ratio.x) * fx;
        let row_y = (down - forward * ratio.y) * fy;
        Self { pixel, row_x, row_y, t, z, ratio }
    }

    /// The gradient with respect to t.  Where x/z or y/z is clamped in J it is a constant.
    #[inline(always)]
    pub fn backward(&self, camera: &Camera, pixel: Vec2, row_x: Vec3, row_y: Vec3) -> Vec3 {
        let Self { t, z, ratio, .. } = *self;
        let forward = camera.rotation[2];
        // row_x = (right - ratio_x forward) f_x / z
        let f = camera.focal * (1.0 / z);
        let real = Vec2::new(t.x / z, t.y / z);
        let d_ratio_x = -f.x * dot(row_x, forward);
        let d_ratio_y = -f.y * dot(row_y, forward);
        let free_x = if ratio.x == real.x { d_ratio_x } else { 0.0 };
        let free_y = if ratio.y == real.y { d_ratio_y } else { 0.0 };
        let dx = f.x * pixel.x + free_x / z;
        let dy = f.y * pixel.y + free_y / z;
        let by_rows = dot(row_x, self.row_x) + dot(row_y, self.row_y);
        Vec3::new(dx, dy, -(real.x * dx + real.y * dy) - by_rows / z)
    }
}
