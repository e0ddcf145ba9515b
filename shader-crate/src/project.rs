//! EWA projection of Gaussians and the radius of their support.

use glam::{Vec2, Vec3, Vec4};

use crate::atomic;
use crate::camera::{Camera, read3};
use crate::math::{abs, clamp, dot, exp, is_finite, max, sqrt};
use crate::prelude::*;

/// `2 ln 255`: the squared Mahalanobis radius at which the falloff has come down to 1/255, and ends.
pub const FALLOFF_CUTOFF: f32 = 11.082_527;

/// A Gaussian at this depth or nearer is culled.
pub const NEAR_PLANE: f32 = 0.01;

/// [`Projection::radius`] of a Gaussian that lies behind the near plane.
pub const BEHIND: f32 = -1.0;

/// [`Projection::radius`] of a Gaussian whose projection is not finite or has no inverse.
pub const DEGENERATE: f32 = -2.0;

/// A Gaussian on the image plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Center, in pixels.
    pub mean2d: Vec2,
    /// Inverse of the covariance: xx, xy, yy.
    pub conic: Vec3,
    /// Support radius in pixels; [`BEHIND`] or [`DEGENERATE`] where the Gaussian is culled.
    pub radius: f32,
}

/// Columns of the rotation of a quaternion (w, x, y, z) of any length but zero.
#[inline(always)]
pub fn rotation_columns(q: Vec4) -> [Vec3; 3] {
    let scale = 1.0 / sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    let (w, x, y, z) = (q.x * scale, q.y * scale, q.z * scale, q.w * scale);
    [
        Vec3::new(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
        Vec3::new(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
        Vec3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)),
    ]
}

/// Projects one Gaussian: `cov2d = J W Sigma W^T J^T + blur I`, its inverse and the radius of its support.
#[inline(always)]
pub fn project_gaussian(
    camera: &Camera,
    blur: f32,
    position: Vec3,
    rotation: Vec4,
    log_scale: Vec3,
) -> Projection {
    let [right, down, forward] = camera.rotation;
    let offset = position - camera.eye;
    let t = Vec3::new(dot(right, offset), dot(down, offset), dot(forward, offset));
    let in_front = t.z > NEAR_PLANE;
    let z = if in_front { t.z } else { 1.0 };

    // the ratios x/z and y/z are clamped to the image's border plus 0.3 of its half width, in J alone
    let inverse_focal = Vec2::new(1.0 / camera.focal.x, 1.0 / camera.focal.y);
    let margin = camera.size * inverse_focal * 0.15;
    let low = camera.center * inverse_focal * -1.0 - margin;
    let high = (camera.size - camera.center) * inverse_focal + margin;
    let ratio = Vec2::new(clamp(t.x / z, low.x, high.x), clamp(t.y / z, low.y, high.y));

    // rows of J W, then of J W R S: cov2d is their Gram matrix
    let (fx, fy) = (camera.focal.x / z, camera.focal.y / z);
    let row_x = (right - forward * ratio.x) * fx;
    let row_y = (down - forward * ratio.y) * fy;
    let [axis_x, axis_y, axis_z] = rotation_columns(rotation);
    let (sx, sy, sz) = (exp(log_scale.x), exp(log_scale.y), exp(log_scale.z));
    let u = Vec3::new(dot(row_x, axis_x) * sx, dot(row_x, axis_y) * sy, dot(row_x, axis_z) * sz);
    let v = Vec3::new(dot(row_y, axis_x) * sx, dot(row_y, axis_y) * sy, dot(row_y, axis_z) * sz);
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let (xx, xy, yy) = (uu + blur, uv, vv + blur);

    // |u|^2 |v|^2 - (u.v)^2 = |u x v|^2: the plain determinant of a needle would cancel
    let cross = Vec3::new(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    let determinant = dot(cross, cross) + blur * (uu + vv) + blur * blur;
    let conic = Vec3::new(yy, -xy, xx) * (1.0 / determinant);
    let half_difference = 0.5 * (xx - yy);
    let largest = 0.5 * (xx + yy) + sqrt(half_difference * half_difference + xy * xy);
    let mean2d = Vec2::new(
        camera.focal.x * t.x / z + camera.center.x,
        camera.focal.y * t.y / z + camera.center.y,
    );
    let radius = sqrt(FALLOFF_CUTOFF * largest);

    // one sum is finite where all its terms are
    let magnitude =
        abs(conic.x) + abs(conic.y) + abs(conic.z) + abs(mean2d.x) + abs(mean2d.y) + radius;
    let usable = is_finite(t.z) && is_finite(magnitude) && determinant > 0.0;
    let culled = if is_finite(t.z) && !in_front { BEHIND } else { DEGENERATE };
    Projection { mean2d, conic, radius: if in_front && usable { radius } else { culled } }
}

/// Squared Mahalanobis distance `q = d^T cov2d^-1 d`.
#[inline(always)]
pub fn mahalanobis(conic: Vec3, d: Vec2) -> f32 {
    conic.x * d.x * d.x + 2.0 * conic.y * d.x * d.y + conic.z * d.y * d.y
}

/// `exp(-q/2)` where `q <= 2 ln 255`, and 0 elsewhere.
#[inline(always)]
pub fn falloff(q: f32) -> f32 {
    // rounding may take q of a needle below zero
    if q <= FALLOFF_CUTOFF { exp(-0.5 * max(q, 0.0)) } else { 0.0 }
}

/// Parameters of [`project`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ProjectParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Added to the diagonal of every covariance, in square pixels.
    pub blur: f32,
}

/// Every Gaussian in every camera: Gaussians along x and y, cameras along z.
///
/// `projection [cameras, gaussians, 2]` is `(mean2d, radius, 0), (conic, 0)`; `degenerate [1]` counts the
/// Gaussians that were culled because they cannot be projected.
#[kernel(threads(64))]
pub fn project(
    id: Invocation,
    params: &ProjectParams,
    camera: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    projection: Write<Vec4>,
    degenerate: Write<u32>,
) {
    let gaussian = id.index();
    if gaussian < params.gaussians {
        let q = gaussian * 4;
        let quaternion = Vec4::new(
            rotation.read(q),
            rotation.read(q + 1),
            rotation.read(q + 2),
            rotation.read(q + 3),
        );
        let projected = project_gaussian(
            &Camera::read(camera, id.workgroup.z),
            params.blur,
            read3(position, gaussian * 3),
            quaternion,
            read3(log_scale, gaussian * 3),
        );
        let slot = 2 * (id.workgroup.z * params.gaussians + gaussian);
        let (mean2d, conic) = (projected.mean2d, projected.conic);
        projection.write(slot, Vec4::new(mean2d.x, mean2d.y, projected.radius, 0.0));
        projection.write(slot + 1, conic.extend(0.0));
        if projected.radius == DEGENERATE {
            atomic::add(degenerate, 0, 1);
        }
    }
}
