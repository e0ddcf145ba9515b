//! The gradient of a loss with respect to the cameras' poses, through the projection.
//!
//! A camera moves by `t' = exp([w]x) t + v` and `W' = exp([w]x) W`: the point t of the camera's space turns about the
//! camera's center by the rotation vector w, in radians, and is shifted by v, in world units. At w = v = 0:
//!
//! - `dL/dv = dL/dt`
//! - `dL/dw = t x dL/dt + W (dL/drow_x x row_x + dL/drow_y x row_y)`, with the rows of J W as EWA uses them

use glam::{Vec2, Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::project::{Footprint, read_quaternion};
use crate::project_backward::footprint_backward;
use crate::splat::VECTORS;
use muslin::binned;
use muslin::math::cross;
use muslin::prelude::*;

/// Values of a pose's gradient: of the rotation vector w, then of the shift v.
pub const VALUES: u32 = 6;

/// Pairs that one invocation of [`pose_backward`] adds up.
pub const BLOCK: u32 = 256;

/// Derivative of [`project_gaussian`](crate::project::project_gaussian) with respect to the camera's pose, from dL/dmean2d and
/// dL/dconic (xx, xy, yy): dL/dw and dL/dv.
#[inline(always)]
pub fn project_pose_backward(
    camera: &Camera,
    blur: f32,
    footprint: &Footprint,
    mean2d: Vec2,
    conic: Vec3,
) -> [Vec3; 2] {
    let found = footprint_backward(camera, blur, footprint, mean2d, conic);
    let lens = &footprint.lens;
    let turned = cross(found.row_x, lens.row_x) + cross(found.row_y, lens.row_y);
    [cross(footprint.t, found.t) + camera.turn_to_camera(turned), found.t]
}

/// Parameters of [`pose_backward`].
#[params]
pub struct PoseBackwardParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Words of a camera's mask.
    pub words: u32,
    /// Index of the camera in the part.
    pub camera: u32,
    /// Place in `sum`.
    pub place: u32,
    /// Blocks of [`BLOCK`] pairs: enough for a camera with all Gaussians.
    pub blocks: u32,
    /// Values of all poses: six for each place.
    pub values: u32,
    /// See [`ProjectParams::blur`](crate::project::ProjectParams::blur).
    pub blur: f32,
}

/// Adds dL/dpose of a camera, over its pairs, to six values of `sum [17, values, 2]`: blocks of pairs along x and y. A block is summed in f32, and blocks [exactly](binned).
///
/// `first_pair [cameras * words + 1]` is the scan of the pairs' counts, `pair [pairs]` comes from [`pair_fill`](crate::pair::pair_fill),
/// and `pair_gradient [pairs, 3]` from [`splat_backward`](crate::splat::splat_backward).
#[kernel(threads(64), over(params.blocks), iterations = BLOCK)]
pub fn pose_backward(
    id: Invocation,
    params: &PoseBackwardParams,
    camera: Read<f32>,
    position: Read<f32>,
    rotation: Read<f32>,
    log_scale: Read<f32>,
    first_pair: Read<u32>,
    pair: Read<u32>,
    pair_gradient: Read<Vec4>,
    sum: Write<u32>,
) {
    let block = id.index();
    if block < params.blocks {
        let index = params.camera;
        let view = Camera::read(camera, index);
        let last = first_pair.read((index + 1) * params.words);
        let mut next = first_pair.read(index * params.words) + block * BLOCK;
        let end = if next + BLOCK < last { next + BLOCK } else { last };
        let mut turn = Vec3::ZERO;
        let mut shift = Vec3::ZERO;
        let mut first = VECTORS * next;
        while next < end {
            let gaussian = pair.read(next) - index * params.gaussians;
            let center = read3(position, 3 * gaussian);
            let quaternion = read_quaternion(rotation, gaussian);
            let footprint =
                Footprint::new(&view, center, quaternion, read3(log_scale, 3 * gaussian));
            let geometry = pair_gradient.read(first);
            let conic = pair_gradient.read(first + 1);
            let [by_turn, by_shift] = project_pose_backward(
                &view,
                params.blur,
                &footprint,
                Vec2::new(geometry.x, geometry.y),
                Vec3::new(conic.x, conic.y, conic.z),
            );
            turn += by_turn;
            shift += by_shift;
            first += VECTORS;
            next += 1;
        }
        let values = params.values;
        let at = VALUES * params.place;
        binned::add(sum, values, at, turn.x);
        binned::add(sum, values, at + 1, turn.y);
        binned::add(sum, values, at + 2, turn.z);
        binned::add(sum, values, at + 3, shift.x);
        binned::add(sum, values, at + 4, shift.y);
        binned::add(sum, values, at + 5, shift.z);
    }
}
