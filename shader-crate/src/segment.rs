//! B1. The ray of a (Gaussian, camera) pair, clipped to the unit cube (Eq. 4-8), or contracted.

use glam::{Vec3, Vec4};

use crate::camera::{Camera, read3};
use crate::limits::MAX_SAMPLES;
use crate::unit_cube::{SceneBox, Split, contract, from_center};
use muslin::lane_vec4::LaneVec4;
use muslin::math::{self, TINY, abs, ceil, clamp, dot, length};
use muslin::prelude::*;

/// The part of a ray in the unit cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// Where the ray enters, in [0, 1].
    pub t0: Split,
    /// Where the ray leaves, in [0, 1].
    pub t1: Split,
    /// `max(t1 - t0, 0)`
    pub lambda: Split,
}

/// A clipped ray, cut into steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// `s = p + t0 v`
    pub start: [Split; 3],
    /// `w = lambda v`
    pub w: [Split; 3],
    /// K; 0 where the ray misses the cube.
    pub count: u32,
    /// `L / K / sigma`; 0 where the ray misses the cube.
    pub factor: f32,
}

/// A whole ray in steps whose lengths grow with the distance from the box, as the contraction's cells do.
///
/// A place on it is u, its distance from the ray's point that is nearest to the cube's center. Steps are even in r: `r = u`
/// up to the radius, and `2 radius - radius^2 / u` beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContractedRay {
    /// The point nearest to the cube's center, from there.
    pub foot: Vec3,
    /// From the Gaussian to the camera, a unit vector.
    pub direction: Vec3,
    /// The foot's distance from the center, or the radius of the ball around the box if that is larger.
    pub radius: f32,
    /// r of the Gaussian.
    pub begin: f32,
    /// r of the camera minus r of the Gaussian.
    pub span: f32,
    /// K; 0 without a ray.
    pub count: u32,
    /// `L / K / sigma`; 0 without a ray.
    pub factor: f32,
}

/// Radius of the ball around the box, which takes half of the cube's side: `sqrt(3) / 4`.
const BALL: f32 = 0.433_012_7;

/// How far a ray's end may be from the cube's center on each axis: its square is finite.
const FARTHEST: f32 = 1e15;

/// The square root of [`TINY`]: a GPU can flush the square of a shorter length.
const SHORTEST: f32 = 1.084_202_2e-19;

/// A ray's end, not too far for an f32.
#[inline(always)]
fn limited(x: Vec3) -> Vec3 {
    let limited = |x| clamp(x, -FARTHEST, FARTHEST);
    Vec3::new(limited(x.x), limited(x.y), limited(x.z))
}

/// r at a place u on a ray.
#[inline(always)]
fn squeeze(u: f32, radius: f32) -> f32 {
    let beyond = radius * (2.0 - radius / math::max(abs(u), radius));
    if abs(u) <= radius {
        u
    } else if u < 0.0 {
        -beyond
    } else {
        beyond
    }
}

/// The place u on a ray where r has a value: the inverse of [`squeeze`].
#[inline(always)]
fn stretch<L: Lane>(r: L, radius: L) -> L {
    let zero = L::splat(0.0);
    let size = L::select(r.less(zero), -r, r);
    let beyond = radius / (L::splat(2.0) - size.max(radius) / radius);
    let signed = L::select(r.less(zero), -beyond, beyond);
    L::select(size.less_equal(radius), r, signed)
}

/// The ray between a Gaussian and a camera, both from the cube's center, in steps of about `step` (sigma).
///
/// The length L is measured in r. Near the box, r is the contracted ray's own length; farther away, the contraction divides by
/// the distance.
#[inline(always)]
pub fn contracted_ray(p: Vec3, eye: Vec3, step: f32) -> ContractedRay {
    let p = limited(p);
    let eye = limited(eye);
    let v = eye - p;
    let whole = length(v);
    let direction = v * (1.0 / math::max(whole, SHORTEST));
    let end = dot(eye, direction);
    let foot = eye - direction * end;
    let radius = math::max(length(foot), BALL);
    let begin = squeeze(end - whole, radius);
    let span = squeeze(end, radius) - begin;
    let l = BALL / radius * span;
    let hit = l > 0.0;
    let count = clamp(ceil(l / step), 1.0, MAX_SAMPLES as f32);
    ContractedRay {
        foot,
        direction,
        radius,
        begin,
        span,
        count: if hit { count as u32 } else { 0 },
        factor: if hit { l / count / step } else { 0.0 },
    }
}

/// The place t on a contracted ray, 0 at the Gaussian and 1 at the camera, in the unit cube.
#[inline(always)]
pub fn contracted_place<L: Lane>(ray: [LaneVec4<L>; 4], t: L) -> [Split<L>; 3] {
    let [foot, direction, places, _] = ray;
    let u = stretch(places.x + t * places.y, direction.w);
    contract([foot.x + u * direction.x, foot.y + u * direction.y, foot.z + u * direction.z])
}

/// The place t on a clipped ray, 0 at s and 1 at s + w, in the unit cube.
#[inline(always)]
pub fn clipped_place<L: Lane>(ray: [LaneVec4<L>; 4], t: Split<L>) -> [Split<L>; 3] {
    let [start, w, start_rest, w_rest] = ray;
    let along = |coarse, fine, w_coarse, w_fine| {
        Split { coarse, fine }.along(t, Split { coarse: w_coarse, fine: w_fine })
    };
    [
        along(start.x, start_rest.x, w.x, w_rest.x),
        along(start.y, start_rest.y, w.y, w_rest.y),
        along(start.z, start_rest.z, w.z, w_rest.z),
    ]
}

/// The midpoint x_k of a ray's step k (Eq. 9) in the unit cube.
#[inline(always)]
pub fn midpoint<L: Lane>(contracted: u32, ray: [LaneVec4<L>; 4], k: L) -> [Split<L>; 3] {
    let t = Split::whole(k + L::splat(0.5)).divide(Split::whole(ray[3].w));
    if contracted != 0 { contracted_place(ray, t.value()) } else { clipped_place(ray, t) }
}

/// Vectors that a segment takes in a buffer: `(s, s_factor), (w, 0)`, the coarse parts, then the fine ones of both with 0 and K. Of a
/// contracted ray they are `(foot, s_factor), (direction, radius), (begin, span, 0, 0), (0, 0, 0, K)`.
pub const SEGMENT_VECTORS: u32 = 4;

/// The earlier of two places on a ray.
#[inline(always)]
fn min(a: Split, b: Split) -> Split {
    if a.value() < b.value() { a } else { b }
}

/// The later of two places on a ray.
#[inline(always)]
fn max(a: Split, b: Split) -> Split {
    if a.value() > b.value() { a } else { b }
}

/// Eq. 4 for one axis: where the ray lies between the planes 0 and 1, limited to [0, 1] as in Eq. 6.
///
/// An axis with v = 0 does not limit t if p is between them; otherwise the ray is empty.
#[inline(always)]
fn clip_axis(p: Split, v: Split) -> (Split, Split) {
    let zero = Split::whole(0.0);
    let one = Split::whole(1.0);
    let parallel = abs(v.value()) < TINY;
    let divisor = if parallel { one } else { v };
    let a = zero.minus(p).divide(divisor);
    let b = one.minus(p).divide(divisor);
    let inside = p.value() >= 0.0 && p.value() <= 1.0;
    let (low, high) = if inside { (zero, one) } else { (one, zero) };
    if parallel { (low, high) } else { (min(a, b), max(a, b)) }
}

/// Eq. 4-6 for the ray p + t v, t in [0, 1].
#[inline(always)]
pub fn clip_to_unit_cube(p: [Split; 3], v: [Split; 3]) -> Clip {
    let (low_x, high_x) = clip_axis(p[0], v[0]);
    let (low_y, high_y) = clip_axis(p[1], v[1]);
    let (low_z, high_z) = clip_axis(p[2], v[2]);
    let t0 = max(max(low_x, low_y), low_z);
    let t1 = min(min(high_x, high_y), high_z);
    let lambda = t1.minus(t0);
    let hit = lambda.value() > 0.0;
    Clip { t0, t1, lambda: if hit { lambda } else { Split::whole(0.0) } }
}

/// `p + t v` for every axis.
#[inline(always)]
pub fn point_along(p: [Split; 3], t: Split, v: [Split; 3]) -> [Split; 3] {
    [p[0].along(t, v[0]), p[1].along(t, v[1]), p[2].along(t, v[2])]
}

/// Eq. 7-8: the segment of a ray and its steps of about `step` (sigma).
#[inline(always)]
pub fn clipped_segment(p: [Split; 3], v: [Split; 3], step: f32) -> Segment {
    let clip = clip_to_unit_cube(p, v);
    let origin = Split::whole(0.0);
    let w = point_along([origin, origin, origin], clip.lambda, v);
    let l = length(Vec3::new(w[0].value(), w[1].value(), w[2].value()));
    let hit = l > 0.0;
    let count = clamp(ceil(l / step), 1.0, MAX_SAMPLES as f32);
    Segment {
        start: point_along(p, clip.t0, v),
        w,
        count: if hit { count as u32 } else { 0 },
        factor: if hit { l / count / step } else { 0.0 },
    }
}

/// The coarse parts of a vector.
#[inline(always)]
fn coarse([x, y, z]: [Split; 3]) -> Vec3 {
    Vec3::new(x.coarse, y.coarse, z.coarse)
}

/// The fine parts of a vector.
#[inline(always)]
fn fine([x, y, z]: [Split; 3]) -> Vec3 {
    Vec3::new(x.fine, y.fine, z.fine)
}

/// The ray of a pair in all lanes, as [`segment`] has written it.
#[inline(always)]
pub fn read_ray<L: Lane>(segment: Read<Vec4>, pair: u32) -> [LaneVec4<L>; 4] {
    let first = pair * SEGMENT_VECTORS;
    [
        LaneVec4::splat(segment.read(first)),
        LaneVec4::splat(segment.read(first + 1)),
        LaneVec4::splat(segment.read(first + 2)),
        LaneVec4::splat(segment.read(first + 3)),
    ]
}

/// Parameters of [`segment`].
#[params]
pub struct SegmentParams {
    /// Pairs of the part.
    pub pairs: u32,
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// sigma
    pub step: f32,
    /// 1 where what lies outside the scene's box is contracted.
    pub contracted: u32,
}

/// The segment of every pair: `segment [pairs, 4]`, see [`SEGMENT_VECTORS`]; `count [pairs]` is K.
#[kernel(threads(64), over(params.pairs), counts(pairs))]
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
        let eye = scene_box.split(Camera::read(camera, slot / params.gaussians).eye.to_array());
        let p = scene_box.split(read3(position, (slot % params.gaussians) * 3).to_array());
        let first = index * SEGMENT_VECTORS;
        if params.contracted != 0 {
            let from = Vec3::from_array(from_center(p));
            let to = Vec3::from_array(from_center(eye));
            let ray = contracted_ray(from, to, params.step);
            segment.write(first, ray.foot.extend(ray.factor));
            segment.write(first + 1, ray.direction.extend(ray.radius));
            segment.write(first + 2, Vec4::new(ray.begin, ray.span, 0.0, 0.0));
            segment.write(first + 3, Vec4::new(0.0, 0.0, 0.0, ray.count as f32));
            count.write(index, ray.count);
        } else {
            let v = [eye[0].minus(p[0]), eye[1].minus(p[1]), eye[2].minus(p[2])];
            let clipped = clipped_segment(p, v, params.step);
            segment.write(first, coarse(clipped.start).extend(clipped.factor));
            segment.write(first + 1, coarse(clipped.w).extend(0.0));
            segment.write(first + 2, fine(clipped.start).extend(0.0));
            segment.write(first + 3, fine(clipped.w).extend(clipped.count as f32));
            count.write(index, clipped.count);
        }
    }
}
