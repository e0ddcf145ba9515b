//! Cameras as kernels see them.

use glam::{Vec2, Vec3};

use muslin::math::dot;
use muslin::prelude::*;

/// A camera, with OpenCV axes: x right, y down, z forward. Its projection is in [`pinhole`](crate::pinhole).
#[derive(Clone, Copy)]
pub struct Camera {
    /// Rows of the rotation from world to camera.
    pub rotation: [Vec3; 3],
    /// Center, in world space.
    pub eye: Vec3,
    /// Focal lengths, in pixels.
    pub focal: Vec2,
    /// Principal point, in pixels.
    pub center: Vec2,
    /// Width and height, in pixels.
    pub size: Vec2,
}

impl Camera {
    /// A position in world space, in the camera's space.
    #[inline(always)]
    pub fn to_camera(&self, position: Vec3) -> Vec3 {
        self.turn_to_camera(position - self.eye)
    }

    /// As [`Camera::to_camera`], of several positions.
    #[inline(always)]
    pub fn all_to_camera<L: Lane>(&self, [x, y, z]: [L; 3]) -> [L; 3] {
        let number = L::splat;
        let x = x - number(self.eye.x);
        let y = y - number(self.eye.y);
        let z = z - number(self.eye.z);
        let [right, down, forward] = self.rotation;
        let along = |axis: Vec3| number(axis.x) * x + number(axis.y) * y + number(axis.z) * z;
        [along(right), along(down), along(forward)]
    }

    /// A direction in the camera's space, in world space.
    #[inline(always)]
    pub fn turn_to_world(&self, direction: Vec3) -> Vec3 {
        let [right, down, forward] = self.rotation;
        right * direction.x + down * direction.y + forward * direction.z
    }

    /// A direction in world space, in the camera's space.
    #[inline(always)]
    pub fn turn_to_camera(&self, direction: Vec3) -> Vec3 {
        let [right, down, forward] = self.rotation;
        Vec3::new(dot(right, direction), dot(down, direction), dot(forward, direction))
    }

    /// Floats that a camera takes in a buffer.
    pub const FLOATS: usize = 18;

    /// The camera as it lies in a buffer; [`Camera::read`] is its counterpart.
    pub fn pack(&self) -> [f32; Self::FLOATS] {
        let [x, y, z] = self.rotation;
        [
            x.x,
            x.y,
            x.z,
            y.x,
            y.y,
            y.z,
            z.x,
            z.y,
            z.z,
            self.eye.x,
            self.eye.y,
            self.eye.z,
            self.focal.x,
            self.focal.y,
            self.center.x,
            self.center.y,
            self.size.x,
            self.size.y,
        ]
    }

    /// The camera at `index` of a buffer of packed cameras.
    #[inline(always)]
    pub fn read(cameras: Read<f32>, index: u32) -> Self {
        let first = index * Self::FLOATS as u32;
        Self {
            rotation: [read3(cameras, first), read3(cameras, first + 3), read3(cameras, first + 6)],
            eye: read3(cameras, first + 9),
            focal: Vec2::new(cameras.read(first + 12), cameras.read(first + 13)),
            center: Vec2::new(cameras.read(first + 14), cameras.read(first + 15)),
            size: Vec2::new(cameras.read(first + 16), cameras.read(first + 17)),
        }
    }
}

/// Three values from `first` on.
#[inline(always)]
pub fn read3(buffer: Read<f32>, first: u32) -> Vec3 {
    Vec3::new(buffer.read(first), buffer.read(first + 1), buffer.read(first + 2))
}

/// Three values each, of `L::WIDTH` items from `first` on.
#[inline(always)]
pub fn gather3<L: Lane>(buffer: Read<f32>, first: u32) -> [L; 3] {
    let at = L::Index::splat(first).wrapping_add(L::ramp().index());
    let at = at.wrapping_mul(L::Index::splat(3));
    let next = at.wrapping_add(L::Index::splat(1));
    let last = at.wrapping_add(L::Index::splat(2));
    [L::gather(buffer, at), L::gather(buffer, next), L::gather(buffer, last)]
}
