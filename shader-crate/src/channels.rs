//! The values that a pair adds to the channels beside color: depth, visibility and normal. [`splat`](crate::splat) takes these three
//! values in the place of a color, so that Eq. 12 sums them in the same way.

use glam::{Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::project::{read_quaternion, rotation_columns};
use muslin::math::dot;
use muslin::prelude::*;

/// Parameters of [`pair_channels`].
#[params]
pub struct PairChannelsParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
}

/// A Gaussian's shortest axis, of length 1, turned toward the camera. `offset` goes from the camera to the Gaussian. Of
/// equally short axes it is the first.
#[inline(always)]
pub fn normal(rotation: Vec4, log_scale: Vec3, offset: Vec3) -> Vec3 {
    let [x, y, z] = rotation_columns(rotation);
    let mut axis = x;
    let mut shortest = log_scale.x;
    if log_scale.y < shortest {
        axis = y;
        shortest = log_scale.y;
    }
    if log_scale.z < shortest {
        axis = z;
    }
    if dot(axis, offset) > 0.0 { -axis } else { axis }
}

/// Writes, for each pair, `measure [pairs, 3]`: the depth, T and 0; and `normals [pairs, 3]`.
///
/// The depth is the center's coordinate along the camera's axis, in world units. The normal is in world space.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn pair_channels(
    id: Invocation,
    params: &PairChannelsParams,
    pair: Read<u32>,
    camera: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    transmittance: Read<f32>,
    measure: Write<f32>,
    normals: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let gaussian = slot % params.gaussians;
        let camera = Camera::read(camera, slot / params.gaussians);
        let center = read3(position, gaussian * 3);
        let first = 3 * index;
        measure.write(first, camera.to_camera(center).z);
        measure.write(first + 1, transmittance.read(index));
        measure.write(first + 2, 0.0);
        let rotation = read_quaternion(rotation, gaussian);
        let log_scale = read3(log_scale, gaussian * 3);
        let normal = normal(rotation, log_scale, center - camera.eye);
        normals.write(first, normal.x);
        normals.write(first + 1, normal.y);
        normals.write(first + 2, normal.z);
    }
}
