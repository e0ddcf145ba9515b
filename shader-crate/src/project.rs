//! EWA projection of Gaussians and the radius of their support.

use glam::{Vec2, Vec3, Vec4};

use crate::camera::{Camera, gather3, read3};
use crate::pinhole::Pinhole;
use muslin::atomic;
use muslin::math::{HUGE, abs, cross, dot, exp, is_finite, sqrt};
use muslin::prelude::*;

/// `2 ln 255`: the squared Mahalanobis radius at which the falloff has come down to 1/255, and ends.
pub const FALLOFF_CUTOFF: f32 = 11.082_527;

/// [`Projection::radius`] of a Gaussian that the camera's lens does not see: it is behind the near plane.
pub const BEHIND: f32 = -1.0;

/// [`Projection::radius`] of a Gaussian whose projection is not finite or has no inverse.
pub const DEGENERATE: f32 = -2.0;

/// [`Projection::radius`] of a Gaussian that reaches no tile of the camera, as [`is_elsewhere`] finds. It has no projection.
pub const ELSEWHERE: f32 = -3.0;

/// A Gaussian on the image plane; all zeros but the radius where it is culled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Center, in pixels.
    pub mean2d: Vec2,
    /// Inverse of the covariance: xx, xy, yy.
    pub conic: Vec3,
    /// Half the width and the height of the support, in pixels, rounded up: it lies within `mean2d +- extent`.
    pub extent: Vec2,
    /// Support radius in pixels; [`BEHIND`] or [`DEGENERATE`] where the Gaussian is culled.
    pub radius: f32,
}

/// Columns of the rotation of a quaternion (w, x, y, z) of any length but zero.
#[inline(always)]
pub fn rotation_columns(q: Vec4) -> [Vec3; 3] {
    let scale = 1.0 / sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    let w = q.x * scale;
    let x = q.y * scale;
    let y = q.z * scale;
    let z = q.w * scale;
    [
        Vec3::new(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
        Vec3::new(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
        Vec3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)),
    ]
}

/// The matrix that projects a Gaussian, `J W R S`: without the blur, cov2d is its product with its transpose.
#[derive(Clone, Copy, Debug)]
pub struct Footprint {
    /// Position in the camera's space.
    pub t: Vec3,
    /// The position's projection, and `J W`.
    pub lens: Pinhole,
    /// Columns of R.
    pub axes: [Vec3; 3],
    /// Diagonal of S: `exp(log_scale)`.
    pub scale: Vec3,
    /// First row of `J W R S`.
    pub u: Vec3,
    /// Second row of `J W R S`.
    pub v: Vec3,
}

impl Footprint {
    /// The footprint of one Gaussian.
    #[inline(always)]
    pub fn new(camera: &Camera, position: Vec3, rotation: Vec4, log_scale: Vec3) -> Self {
        let t = camera.to_camera(position);
        let lens = Pinhole::new(camera, t);
        let row_x = lens.row_x;
        let row_y = lens.row_y;
        let axes = rotation_columns(rotation);
        let [x, y, z] = axes;
        let scale = Vec3::new(exp(log_scale.x), exp(log_scale.y), exp(log_scale.z));
        let u = Vec3::new(dot(row_x, x), dot(row_x, y), dot(row_x, z)) * scale;
        let v = Vec3::new(dot(row_y, x), dot(row_y, y), dot(row_y, z)) * scale;
        Self { t, lens, axes, scale, u, v }
    }
}

/// Rotation of a Gaussian: w, x, y, z.
#[inline(always)]
pub fn read_quaternion(rotation: Read<f32>, gaussian: u32) -> Vec4 {
    let q = gaussian * 4;
    Vec4::new(rotation.read(q), rotation.read(q + 1), rotation.read(q + 2), rotation.read(q + 3))
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
    let Footprint { t, lens, u, v, .. } = Footprint::new(camera, position, rotation, log_scale);
    let uu = dot(u, u);
    let uv = dot(u, v);
    let vv = dot(v, v);
    let xx = uu + blur;
    let xy = uv;
    let yy = vv + blur;

    // |u|^2 |v|^2 - (u.v)^2 = |u x v|^2: the plain determinant of a needle would cancel
    let cross = cross(u, v);
    let determinant = dot(cross, cross) + blur * (uu + vv) + blur * blur;
    let conic = Vec3::new(yy, -xy, xx) * (1.0 / determinant);
    let half_difference = 0.5 * (xx - yy);
    let largest = 0.5 * (xx + yy) + sqrt(half_difference * half_difference + xy * xy);
    let mean2d = lens.pixel;
    let radius = sqrt(FALLOFF_CUTOFF * largest);
    // q <= cutoff is an ellipse; its bounding box, with a margin for rounding
    let extent = Vec2::new(sqrt(FALLOFF_CUTOFF * xx), sqrt(FALLOFF_CUTOFF * yy)) * 1.001 + 0.01;

    // one sum is finite where all its terms are
    let magnitude =
        abs(conic.x) + abs(conic.y) + abs(conic.z) + abs(mean2d.x) + abs(mean2d.y) + radius;
    let usable = is_finite(t.z) && is_finite(magnitude) && determinant > 0.0;
    let is_seen = Pinhole::sees(t.to_array());
    let culled = if is_finite(t.z) && !is_seen { BEHIND } else { DEGENERATE };
    if is_seen && usable {
        Projection { mean2d, conic, extent, radius }
    } else {
        Projection { mean2d: Vec2::ZERO, conic: Vec3::ZERO, extent: Vec2::ZERO, radius: culled }
    }
}

/// Floats of a camera's window: the least x and y of its tiles, then the greatest, in pixels.
pub const WINDOW: usize = 4;

/// The window that leaves nothing out.
pub const EVERYWHERE: [f32; WINDOW] = [f32::MIN, f32::MIN, f32::MAX, f32::MAX];

/// Whether Gaussians that the camera sees end before a window of the image, for certain. It costs less than
/// [`project_gaussian`].
///
/// The longest axis of `J W Sigma W^T J^T` is at most Sigma's, times the Frobenius norm of J: W only turns. The margin is wider
/// than the one of [`reaches`](crate::tile::reaches).
#[inline(always)]
pub fn is_elsewhere<L: Lane>(
    camera: &Camera,
    t: [L; 3],
    blur: f32,
    log_scale: [L; 3],
    window: Vec4,
) -> L::Mask {
    let number = L::splat;
    let (pixel, stretch) = Pinhole::place(camera, t);
    let [x, y, z] = log_scale;
    let scale = x.max(y.max(z)).exp();
    let longest = number(FALLOFF_CUTOFF) * (stretch * scale * scale + number(blur));
    let dx = pixel[0] - pixel[0].max(number(window.x)).min(number(window.z));
    let dy = pixel[1] - pixel[1].max(number(window.y)).min(number(window.w));
    (number(1.02) * longest + number(0.02)).less(dx * dx + dy * dy)
}

/// Squared Mahalanobis distance `q = d^T cov2d^-1 d`.
#[inline(always)]
pub fn mahalanobis<L: Lane>(conic: Vec3, dx: L, dy: L) -> L {
    let number = L::splat;
    // not `2 conic.y`: a GPU would compute that in a register of its own, for each lane
    let half = number(conic.y) * dx * dy;
    number(conic.x) * dx * dx + (half + half) + number(conic.z) * dy * dy
}

/// Whether a pixel lies in a Gaussian's support: `q <= 2 ln 255`.
#[inline(always)]
pub fn in_support<L: Lane>(q: L) -> L::Mask {
    q.less_equal(L::splat(FALLOFF_CUTOFF))
}

/// `exp(-q/2)` in the support, and 0 elsewhere.
#[inline(always)]
pub fn falloff<L: Lane>(q: L) -> L {
    let zero = L::splat(0.0);
    // rounding may take q of a needle below zero
    let inside = (L::splat(-0.5) * q.max(zero)).exp();
    L::select(in_support(q), inside, zero)
}

/// Parameters of [`project`].
#[params]
pub struct ProjectParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Added to the diagonal of every covariance, in square pixels.
    pub blur: f32,
}

/// Every Gaussian in every camera: Gaussians along x and y, cameras along z.
///
/// `window [cameras, 4]` holds a camera's tiles, see [`WINDOW`]. `projection [cameras, gaussians, 2]` is `(mean2d, radius,
/// extent x), (conic, extent y)`: all zeros but the negative radius where a Gaussian is culled. `degenerate [1]` counts
/// Gaussians that may reach a window and cannot be projected.
#[kernel(threads(64), over(params.gaussians, window.len() / 4), iterations = 1, lanes(gaussians))]
pub fn project<L: Lane>(
    id: Invocation,
    params: &ProjectParams,
    camera: Read<f32>,
    window: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    projection: Write<Vec4>,
    degenerate: Write<u32>,
) {
    let first = id.index();
    if first < params.gaussians {
        let z = id.workgroup.z;
        let view = Camera::read(camera, z);
        let at = z * WINDOW as u32;
        let low = Vec2::new(window.read(at), window.read(at + 1));
        let high = Vec2::new(window.read(at + 2), window.read(at + 3));
        let window = Vec4::new(low.x, low.y, high.x, high.y);
        let culled = cull::<L>(&view, params.blur, position, log_scale, first, window);
        let mut lane = 0;
        while lane < L::WIDTH {
            let gaussian = first + lane;
            let slot = 2 * (z * params.gaussians + gaussian);
            let cause = culled.lane(lane);
            if cause == 0 {
                let center = read3(position, gaussian * 3);
                let turn = read_quaternion(rotation, gaussian);
                let log_axes = read3(log_scale, gaussian * 3);
                let projected = project_gaussian(&view, params.blur, center, turn, log_axes);
                let mean2d = projected.mean2d;
                let extent = projected.extent;
                projection.write(slot, Vec4::new(mean2d.x, mean2d.y, projected.radius, extent.x));
                projection.write(slot + 1, projected.conic.extend(extent.y));
                if projected.radius == DEGENERATE {
                    atomic::add(degenerate, 0, 1);
                }
            } else {
                projection.write(slot, Vec4::new(0.0, 0.0, -(cause as f32), 0.0));
                projection.write(slot + 1, Vec4::ZERO);
            }
            lane += 1;
        }
    }
}

/// Which of `L::WIDTH` Gaussians from `first` on are culled before they are projected: the negative [`BEHIND`] or [`ELSEWHERE`],
/// and 0 of others.
#[inline(always)]
fn cull<L: Lane>(
    camera: &Camera,
    blur: f32,
    position: Read<f32>,
    log_scale: Read<f32>,
    first: u32,
    window: Vec4,
) -> L::Index {
    let t = camera.all_to_camera(gather3::<L>(position, first));
    let zero = L::Index::splat(0);
    let elsewhere = is_elsewhere(camera, t, blur, gather3(log_scale, first), window);
    let in_front = L::Index::select(elsewhere, L::Index::splat(-ELSEWHERE as u32), zero);
    let [_, _, z] = t;
    let is_number = L::both(z.less_equal(L::splat(HUGE)), L::splat(-HUGE).less_equal(z));
    let behind = L::Index::select(is_number, L::Index::splat(-BEHIND as u32), zero);
    L::Index::select(Pinhole::sees(t), in_front, behind)
}
