//! The pinhole: `x' = f_x x / z + c_x`, and y likewise.

use glam::{Vec2, Vec3};

use crate::camera::Camera;
use muslin::math::{clamp, dot};
use muslin::prelude::*;

/// A Gaussian at this depth or nearer is culled.
pub const NEAR_PLANE: f32 = 0.01;

/// A point projected by a pinhole camera, and the rows of `J W`, as EWA uses them (Zwicker et al. 2002): the derivatives of
/// the pixel with respect to a position in world space. W is the camera's rotation.
#[derive(Clone, Copy, Debug)]
pub struct Pinhole {
    /// The projected point, in pixels.
    pub pixel: Vec2,
    /// First row of `J W`.
    pub row_x: Vec3,
    /// Second row of `J W`.
    pub row_y: Vec3,
    /// Position in the camera's space.
    t: Vec3,
    /// Depth; 1 if the lens does not see the point.
    z: f32,
    /// `x/z` and `y/z` as used in J: clamped to the image's border plus 0.3 of its half width.
    ratio: Vec2,
}

/// The smallest and the largest ratios x/z and y/z in J: the image's border, and 0.3 of its half width more.
#[inline(always)]
fn ratio_limits(camera: &Camera) -> [Vec2; 2] {
    let inverse_focal = Vec2::new(1.0 / camera.focal.x, 1.0 / camera.focal.y);
    let margin = camera.size * inverse_focal * 0.15;
    let low = camera.center * inverse_focal * -1.0 - margin;
    let high = (camera.size - camera.center) * inverse_focal + margin;
    [low, high]
}

impl Pinhole {
    /// Whether a point of the camera's space is in front of the near plane.
    #[inline(always)]
    pub fn sees<L: Lane>([_, _, z]: [L; 3]) -> L::Mask {
        L::splat(NEAR_PLANE).less(z)
    }

    /// The projected points, in pixels, and the sum of the squares of J, of points that the lens sees.
    #[inline(always)]
    pub fn place<L: Lane>(camera: &Camera, [x, y, z]: [L; 3]) -> ([L; 2], L) {
        let number = L::splat;
        let one = L::splat(1.0);
        let inverse = one / z;
        let x = x * inverse;
        let y = y * inverse;
        let fx = number(camera.focal.x);
        let fy = number(camera.focal.y);
        let pixel = [fx * x + number(camera.center.x), fy * y + number(camera.center.y)];
        let [low, high] = ratio_limits(camera);
        let x = x.max(number(low.x)).min(number(high.x));
        let y = y.max(number(low.y)).min(number(high.y));
        let stretch = fx * fx * (one + x * x) + fy * fy * (one + y * y);
        (pixel, stretch * inverse * inverse)
    }

    /// The projection of a point of the camera's space.
    #[inline(always)]
    pub fn new(camera: &Camera, t: Vec3) -> Self {
        let z = if Self::sees(t.to_array()) { t.z } else { 1.0 };
        let pixel = Vec2::new(
            camera.focal.x * t.x / z + camera.center.x,
            camera.focal.y * t.y / z + camera.center.y,
        );

        // the ratios x/z and y/z are clamped only in J
        let [low, high] = ratio_limits(camera);
        let ratio = Vec2::new(clamp(t.x / z, low.x, high.x), clamp(t.y / z, low.y, high.y));

        let [right, down, forward] = camera.rotation;
        let fx = camera.focal.x / z;
        let fy = camera.focal.y / z;
        let row_x = (right - forward * ratio.x) * fx;
        let row_y = (down - forward * ratio.y) * fy;
        Self { pixel, row_x, row_y, t, z, ratio }
    }

    /// The gradient with respect to t. A ratio x/z or y/z that is clamped in J is a constant.
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
