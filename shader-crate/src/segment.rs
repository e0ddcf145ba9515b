//! B1. The ray of a (Gaussian, camera) pair, clipped to the unit cube (Eq. 4-8).

use glam::{Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::limits::MAX_SAMPLES;
use crate::math::{HUGE, TINY, abs, ceil, clamp, length, max, min};
use crate::prelude::*;
use crate::unit_cube::SceneBox;

/// The part of a ray in the unit cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// Where the ray enters, in [0, 1].
    pub t0: f32,
    /// Where the ray leaves, in [0, 1].
    pub t1: f32,
    /// `max(t1 - t0, 0)`
    pub lambda: f32,
}

/// A clipped ray, cut into steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// `s = p + t0 v`
    pub start: Vec3,
    /// `w = lambda v`
    pub w: Vec3,
    /// K; 0 where the ray misses the cube.
    pub count: u32,
    /// `L / K / sigma`; 0 where the ray misses the cube.
    pub factor: f32,
}

/// Eq. 4 for one axis: where the ray lies between the planes 0 and 1.
///
/// An axis with v = 0 does not limit t where p lies between them and empties the ray where it does not.
#[inline(always)]
fn clip_axis(p: f32, v: f32) -> (f32, f32) {
    let parallel = abs(v) < TINY;
    let divisor = if parallel { 1.0 } else { v };
    let (a, b) = (-p / divisor, (1.0 - p) / divisor);
    let inside = p >= 0.0 && p <= 1.0;
    let bound = if inside { -HUGE } else { HUGE };
    if parallel { (bound, -bound) } else { (min(a, b), max(a, b)) }
}

/// Eq. 4-6 for the ray p + t v, t in [0, 1].
#[inline(always)]
pub fn clip_to_unit_cube(p: Vec3, v: Vec3) -> Clip {
    let (low_x, high_x) = clip_axis(p.x, v.x);
    let (low_y, high_y) = clip_axis(p.y, v.y);
    let (low_z, high_z) = clip_axis(p.z, v.z);
    let t0 = clamp(max(max(low_x, low_y), low_z), 0.0, 1.0);
    let t1 = clamp(min(min(high_x, high_y), high_z), 0.0, 1.0);
    Clip { t0, t1, lambda: max(t1 - t0, 0.0) }
}

/// Eq. 7-8: the segment of a ray and its steps of about `step` (sigma).
#[inline(always)]
pub fn clipped_segment(p: Vec3, v: Vec3, step: f32) -> Segment {
    let clip = clip_to_unit_cube(p, v);
    let w = v * clip.lambda;
    let l = length(w);
    let hit = l > 0.0;
    let count = clamp(ceil(l / step), 1.0, MAX_SAMPLES as f32);
    Segment {
        start: p + v * clip.t0,
        w,
        count: if hit { count as u32 } else { 0 },
        factor: if hit { l / count / step } else { 0.0 },
    }
}

/// Parameters of [`segment`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct SegmentParams {
    /// Pairs in the batch.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// sigma
    pub step: f32,
}

/// The segment of every pair: `segment [pairs, 2]` is `(s, s_factor), (w, 0)`, `count [pairs]` is K.
#[kernel(threads(64))]
pub fn segment(
    id: Invocation,
    params: &SegmentParams,
    pair: Read<u32>,
    camera: Read<f32>,
    scene_box: Read<f32>,
    position: Read<f32>,
    segment: Write<Vec4>,
    count: Write<u32>,
) {
    let index = id.index();
    if index < params.pairs {
        let slot = pair.read(index);
        let scene_box = SceneBox::read(scene_box);
        let eye = scene_box.normalize(Camera::read(camera, slot / params.gaussians).eye);
        let p = scene_box.normalize(read3(position, (slot % params.gaussians) * 3));
        let clipped = clipped_segment(p, eye - p, params.step);
        segment.write(2 * index, clipped.start.extend(clipped.factor));
        segment.write(2 * index + 1, clipped.w.extend(0.0));
        count.write(index, clipped.count);
    }
}
