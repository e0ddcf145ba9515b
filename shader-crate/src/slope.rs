//! B3. Colors that vary within a Gaussian: how much the color of a pair grows per pixel (Eq. 17), and its derivative.

use glam::{Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::limits::MAX_TILES;
use crate::project::{Footprint, read_quaternion};
use crate::splat::SplatBackwardParams;
use muslin::prelude::*;

/// Values of a Gaussian's slope: red, green and blue along each of its three axes.
pub const VALUES: u32 = 9;

/// `Vec4`s of a pair's slope: the colors' growth along x and along y, then the [`Axes`].
pub const SLOPE_VECTORS: u32 = 4;

/// `Vec4`s of its gradient: those of the growth along x and along y.
pub const SLOPE_GRADIENT_VECTORS: u32 = 2;

/// Where the Gaussian is densest along a pixel's ray, in its own axes and in standard deviations: `x dx + y dy` for a pixel
/// at (dx, dy) from its center.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    /// Per pixel to the right.
    pub x: Vec3,
    /// Per pixel down.
    pub y: Vec3,
}

impl Axes {
    /// `H^T conic` with `H = J W R S`.
    #[inline(always)]
    pub fn new(footprint: &Footprint, conic: Vec3) -> Self {
        let u = footprint.u;
        let v = footprint.v;
        Self { x: u * conic.x + v * conic.y, y: u * conic.y + v * conic.z }
    }
}

/// Parameters of [`slope`].
#[params]
pub struct SlopeParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
}

/// Writes each pair's `pair_slope [pairs, 4]`: `(growth along x, 0), (growth along y, 0), (axes x, 0), (axes y, 0)`.
///
/// `slope [gaussians, 9]` has red, green and blue along the first axis, then along the second and the third.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
pub fn slope(
    id: Invocation,
    params: &SlopeParams,
    pair: Read<u32>,
    camera: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    projection: Read<Vec4>,
    slope: Read<f32>,
    pair_slope: Write<Vec4>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let gaussian = slot % params.gaussians;
        let view = Camera::read(camera, slot / params.gaussians);
        let center = read3(position, gaussian * 3);
        let turn = read_quaternion(rotation, gaussian);
        let log_axes = read3(log_scale, gaussian * 3);
        let footprint = Footprint::new(&view, center, turn, log_axes);
        let conic = projection.read(2 * slot + 1);
        let axes = Axes::new(&footprint, Vec3::new(conic.x, conic.y, conic.z));
        let first = read3(slope, gaussian * VALUES);
        let second = read3(slope, gaussian * VALUES + 3);
        let third = read3(slope, gaussian * VALUES + 6);
        let along_x = first * axes.x.x + second * axes.x.y + third * axes.x.z;
        let along_y = first * axes.y.x + second * axes.y.y + third * axes.y.z;
        let to = SLOPE_VECTORS * index;
        pair_slope.write(to, along_x.extend(0.0));
        pair_slope.write(to + 1, along_y.extend(0.0));
        pair_slope.write(to + 2, axes.x.extend(0.0));
        pair_slope.write(to + 3, axes.y.extend(0.0));
    }
}

/// Sums `intersection_slope [intersections, 2]`, the gradient of the growth along x and y, over the tiles of a pair's camera, in
/// ascending order. `slope_gradient [pairs, 9]` is the gradient of the Gaussian's slope. The axes are constants.
#[kernel(threads(64), over(params.pairs), iterations = MAX_TILES, counts(pairs))]
pub fn slope_backward(
    id: Invocation,
    params: &SplatBackwardParams,
    pair: Read<u32>,
    first_tile: Read<u32>,
    tile_mask: Read<u32>,
    first_intersection: Read<u32>,
    pair_slope: Read<Vec4>,
    intersection_slope: Read<Vec4>,
    slope_gradient: Write<f32>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let camera = slot / params.gaussians;
        let gaussian = slot % params.gaussians;
        let word = gaussian / 32;
        let bit = 1 << (gaussian % 32);
        let mut along_x = Vec4::ZERO;
        let mut along_y = Vec4::ZERO;
        let end = first_tile.read(camera + 1);
        let mut tile = first_tile.read(camera);
        while tile < end {
            let bits = tile_mask.read(tile * params.words + word);
            if bits & bit != 0 {
                let below = (bits & (bit - 1)).count_ones();
                let intersection = first_intersection.read(tile * params.words + word) + below;
                along_x += intersection_slope.read(SLOPE_GRADIENT_VECTORS * intersection);
                along_y += intersection_slope.read(SLOPE_GRADIENT_VECTORS * intersection + 1);
            }
            tile += 1;
        }
        let x = pair_slope.read(SLOPE_VECTORS * index + 2);
        let y = pair_slope.read(SLOPE_VECTORS * index + 3);
        let to = VALUES * index;
        write3(slope_gradient, to, along_x * x.x + along_y * y.x);
        write3(slope_gradient, to + 3, along_x * x.y + along_y * y.y);
        write3(slope_gradient, to + 6, along_x * x.z + along_y * y.z);
    }
}

/// Writes the first three numbers of a vector.
#[inline(always)]
fn write3(to: Write<f32>, first: u32, value: Vec4) {
    to.write(first, value.x);
    to.write(first + 1, value.y);
    to.write(first + 2, value.z);
}
