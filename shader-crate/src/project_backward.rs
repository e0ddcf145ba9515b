//! The derivative of the EWA projection: from gradients of pairs' centers and conics to gradients of Gaussians.

use glam::{Vec2, Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::limits::MAX_CAMERAS;
use crate::project::{Footprint, read_quaternion};
use crate::splat::VECTORS;
use muslin::math::{cross, dot, sqrt};
use muslin::prelude::*;

/// A loss's derivatives with respect to one Gaussian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussianGradient {
    /// Of the position.
    pub position: Vec3,
    /// Of the quaternion that is not normalized: w, x, y, z.
    pub rotation: Vec4,
    /// Of the logarithms of the axes.
    pub log_scale: Vec3,
}

/// Derivative of [`rotation_columns`](crate::project::rotation_columns), from dL/d of its columns.
#[inline(always)]
pub fn rotation_columns_backward(q: Vec4, gradient: [Vec3; 3]) -> Vec4 {
    let [a, b, c] = gradient;
    let scale = 1.0 / sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    let w = q.x * scale;
    let x = q.y * scale;
    let y = q.z * scale;
    let z = q.w * scale;
    let turn = Vec3::new(b.z - c.y, c.x - a.z, a.y - b.x);
    let xy = a.y + b.x;
    let xz = a.z + c.x;
    let yz = b.z + c.y;
    let d = Vec4::new(
        x * turn.x + y * turn.y + z * turn.z,
        w * turn.x + y * xy + z * xz - 2.0 * x * (b.y + c.z),
        w * turn.y + x * xy + z * yz - 2.0 * y * (a.x + c.z),
        w * turn.z + x * xz + y * yz - 2.0 * z * (a.x + b.y),
    ) * 2.0;
    // the length has no influence
    let along = d.x * w + d.y * x + d.z * y + d.w * z;
    (d - Vec4::new(w, x, y, z) * along) * scale
}

/// A loss's derivatives with respect to the parts of a [`Footprint`].
#[derive(Clone, Copy, Debug)]
pub struct FootprintGradient {
    /// Of the position in the camera's space.
    pub t: Vec3,
    /// Of the first row of `J W`, with t held constant.
    pub row_x: Vec3,
    /// Of the second row of `J W`, likewise.
    pub row_y: Vec3,
    /// Of the columns of R.
    pub axes: [Vec3; 3],
    /// Of the logarithms of S.
    pub log_scale: Vec3,
}

/// Derivative of [`project_gaussian`](crate::project::project_gaussian) for a Gaussian that is not culled, from dL/dmean2d
/// and dL/dconic (xx, xy, yy), with respect to its footprint.
///
/// With H = J W R S and `cov2d = H H^T + blur I`: `dL/dH = -2 conic G conic H`, G the symmetric matrix of dL/dconic.
#[inline(always)]
pub fn footprint_backward(
    camera: &Camera,
    blur: f32,
    footprint: &Footprint,
    mean2d: Vec2,
    conic: Vec3,
) -> FootprintGradient {
    let Footprint { lens, axes, scale, u, v, .. } = *footprint;

    // conic H, without the cancellation of a needle: |v|^2 u - (u.v) v = v x (u x v)
    let uu = dot(u, u);
    let uv = dot(u, v);
    let vv = dot(v, v);
    let normal = cross(u, v);
    let inverse = 1.0 / (dot(normal, normal) + blur * (uu + vv) + blur * blur);
    let along_u = (u * blur + cross(v, normal)) * inverse;
    let along_v = (v * blur + cross(normal, u)) * inverse;
    let half = 0.5 * conic.y;
    let p = along_u * conic.x + along_v * half;
    let q = along_u * half + along_v * conic.z;
    let xx = (vv + blur) * inverse;
    let xy = -uv * inverse;
    let yy = (uu + blur) * inverse;
    let du = (p * xx + q * xy) * -2.0;
    let dv = (p * xy + q * yy) * -2.0;

    let log_scale =
        Vec3::new(du.x * u.x + dv.x * v.x, du.y * u.y + dv.y * v.y, du.z * u.z + dv.z * v.z);
    // u_k = s_k row_x . axis_k
    let su = du * scale;
    let sv = dv * scale;
    let row_x = lens.row_x;
    let row_y = lens.row_y;
    let columns =
        [row_x * su.x + row_y * sv.x, row_x * su.y + row_y * sv.y, row_x * su.z + row_y * sv.z];
    let [axis_x, axis_y, axis_z] = axes;
    let d_row_x = axis_x * su.x + axis_y * su.y + axis_z * su.z;
    let d_row_y = axis_x * sv.x + axis_y * sv.y + axis_z * sv.z;
    let t = lens.backward(camera, mean2d, d_row_x, d_row_y);
    FootprintGradient { t, row_x: d_row_x, row_y: d_row_y, axes: columns, log_scale }
}

/// Derivative of [`project_gaussian`](crate::project::project_gaussian) for a Gaussian that is not culled, from dL/dmean2d
/// and dL/dconic (xx, xy, yy).
#[inline(always)]
pub fn project_gaussian_backward(
    camera: &Camera,
    blur: f32,
    position: Vec3,
    rotation: Vec4,
    log_scale: Vec3,
    mean2d: Vec2,
    conic: Vec3,
) -> GaussianGradient {
    let footprint = Footprint::new(camera, position, rotation, log_scale);
    let found = footprint_backward(camera, blur, &footprint, mean2d, conic);
    GaussianGradient {
        position: camera.turn_to_world(found.t),
        rotation: rotation_columns_backward(rotation, found.axes),
        log_scale: found.log_scale,
    }
}

/// The mask of each term's bits before it is added. It changes nothing, but compilers do not know its value: so they cannot fuse the sum
/// with the product before it, and it rounds as on the CPU. naga cannot forbid the fusion.
pub const ALL_BITS: u32 = u32::MAX;

/// Parameters of [`project_backward`].
#[params]
pub struct ProjectBackwardParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Words of a camera's mask.
    pub words: u32,
    /// The first camera.
    pub first_camera: u32,
    /// Cameras from there on.
    pub cameras: u32,
    /// See [`ProjectParams::blur`](crate::project::ProjectParams::blur).
    pub blur: f32,
    /// [`ALL_BITS`]
    pub bits: u32,
    /// See [`SplatParams::shaped`](crate::splat::SplatParams::shaped).
    pub shaped: u32,
}

/// Adds the gradients of a Gaussian's pairs in some of the cameras, one after the other, to `gradient [11 gaussians]`: position `[N, 3]`, rotation
/// `[N, 4]`, log_scale `[N, 3]`, opacity `[N]`. If falloffs have shapes, it has 12, the last ones for shape `[N]`.
///
/// `pair_gradient [pairs, 3]` comes from [`splat_backward`](crate::splat::splat_backward).
#[kernel(threads(64), over(params.gaussians), iterations = MAX_CAMERAS)]
pub fn project_backward(
    id: Invocation,
    params: &ProjectBackwardParams,
    camera: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    pair_mask: Read<u32>,
    first_pair: Read<u32>,
    pair_gradient: Read<Vec4>,
    gradient: Write<f32>,
) {
    let gaussian = id.index();
    if gaussian < params.gaussians {
        let word = gaussian / 32;
        let bit = 1 << (gaussian % 32);
        let center = read3(position, gaussian * 3);
        let quaternion = read_quaternion(rotation, gaussian);
        let log_axes = read3(log_scale, gaussian * 3);
        let n = params.gaussians;
        let end = params.first_camera + params.cameras;
        let mut index = params.first_camera;
        while index < end {
            let bits = pair_mask.read(index * params.words + word);
            if bits & bit != 0 {
                let below = (bits & (bit - 1)).count_ones();
                let first = VECTORS * (first_pair.read(index * params.words + word) + below);
                let geometry = pair_gradient.read(first);
                let conic = pair_gradient.read(first + 1);
                let mean2d = Vec2::new(geometry.x, geometry.y);
                let found = project_gaussian_backward(
                    &Camera::read(camera, index),
                    params.blur,
                    center,
                    quaternion,
                    log_axes,
                    mean2d,
                    Vec3::new(conic.x, conic.y, conic.z),
                );
                // one camera after the other: the sums do not depend on which of them share a dispatch
                let rows = [3 * gaussian, 3 * n + 4 * gaussian, 7 * n + 3 * gaussian];
                add(gradient, params.bits, rows, found, 10 * n + gaussian, geometry.z);
                if params.shaped != 0 {
                    let shape = 11 * n + gaussian;
                    let by_shape = pair_gradient.read(first + 2).w;
                    gradient.write(shape, sum(gradient.read(shape), by_shape, params.bits));
                }
            }
            index += 1;
        }
    }
}

/// Adds to a Gaussian's sums. All of them are read before one is written: a GPU then waits once.
#[inline(always)]
fn add(
    sums: Write<f32>,
    bits: u32,
    [position, rotation, log_scale]: [u32; 3],
    found: GaussianGradient,
    opacity: u32,
    opacity_gradient: f32,
) {
    let px = sum(sums.read(position), found.position.x, bits);
    let py = sum(sums.read(position + 1), found.position.y, bits);
    let pz = sum(sums.read(position + 2), found.position.z, bits);
    let rx = sum(sums.read(rotation), found.rotation.x, bits);
    let ry = sum(sums.read(rotation + 1), found.rotation.y, bits);
    let rz = sum(sums.read(rotation + 2), found.rotation.z, bits);
    let rw = sum(sums.read(rotation + 3), found.rotation.w, bits);
    let sx = sum(sums.read(log_scale), found.log_scale.x, bits);
    let sy = sum(sums.read(log_scale + 1), found.log_scale.y, bits);
    let sz = sum(sums.read(log_scale + 2), found.log_scale.z, bits);
    let o = sum(sums.read(opacity), opacity_gradient, bits);
    sums.write(position, px);
    sums.write(position + 1, py);
    sums.write(position + 2, pz);
    sums.write(rotation, rx);
    sums.write(rotation + 1, ry);
    sums.write(rotation + 2, rz);
    sums.write(rotation + 3, rw);
    sums.write(log_scale, sx);
    sums.write(log_scale + 1, sy);
    sums.write(log_scale + 2, sz);
    sums.write(opacity, o);
}

/// `before + value`
#[inline(always)]
fn sum(before: f32, value: f32, bits: u32) -> f32 {
    before + f32::from_bits(value.to_bits() & bits)
}
