//! Eq. 4 to 8: a ray in the unit cube, and its steps. Of a ray that is contracted: all of its steps.

use super::numeric::dot;
use super::unit_cube::contract;

/// The part of a ray in the unit cube.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// Begin, s.
    pub start: [f64; 3],
    /// Way, w.
    pub way: [f64; 3],
    /// K; 0 where the ray misses the cube.
    pub count: f64,
    /// `L / K / sigma`; 0 where the ray misses the cube.
    pub factor: f64,
}

/// Steps that a ray has at most.
const MAX_STEPS: f64 = 16_384.0;

/// Eq. 4 and 5 for `p + t v`: where it enters the cube and where it leaves it.
pub fn planes(p: [f64; 3], v: [f64; 3]) -> [f64; 2] {
    let mut enter = f64::NEG_INFINITY;
    let mut exit = f64::INFINITY;
    for axis in 0..3 {
        if v[axis] == 0.0 {
            if !(0.0..=1.0).contains(&p[axis]) {
                (enter, exit) = (f64::INFINITY, f64::NEG_INFINITY);
            }
            continue;
        }
        let zero = (0.0 - p[axis]) / v[axis];
        let one = (1.0 - p[axis]) / v[axis];
        enter = enter.max(zero.min(one));
        exit = exit.min(zero.max(one));
    }
    [enter, exit]
}

/// Eq. 6: t0 and lambda.
pub fn clip([enter, exit]: [f64; 2]) -> [f64; 2] {
    let t0 = enter.clamp(0.0, 1.0);
    [t0, (exit.clamp(0.0, 1.0) - t0).max(0.0)]
}

/// The segment from a Gaussian to a camera, both in the unit cube's space, in steps of about `step` (sigma).
pub fn segment(p: [f64; 3], eye: [f64; 3], step: f64) -> Segment {
    let v = std::array::from_fn(|axis| eye[axis] - p[axis]);
    let [t0, lambda] = clip(planes(p, v));
    let way = v.map(|v| lambda * v);
    let length = dot(way, way).sqrt();
    let count = (length / step).ceil().min(MAX_STEPS);
    let factor = if count > 0.0 { length / count / step } else { 0.0 };
    Segment { start: std::array::from_fn(|axis| p[axis] + t0 * v[axis]), way, count, factor }
}

/// A ray from a Gaussian to a camera in contracted space. The cube's center is the origin.
#[derive(Clone, Copy, Debug)]
pub struct ContractedRay {
    /// The point nearest to the origin.
    pub foot: [f64; 3],
    /// Toward the camera, a unit vector.
    pub direction: [f64; 3],
    /// Up to this distance from the foot, steps are even.
    pub radius: f64,
    /// Where the Gaussian and the camera are, in the coordinate in which steps are even.
    pub ends: [f64; 2],
    /// L
    pub length: f64,
    /// K; 0 without a ray.
    pub count: f64,
    /// `L / K / sigma`; 0 without a ray.
    pub factor: f64,
}

/// The ray from a Gaussian to a camera, both in the unit cube's space, in steps of about `step` (sigma).
pub fn contracted_ray(p: [f64; 3], eye: [f64; 3], step: f64) -> ContractedRay {
    let v: [f64; 3] = std::array::from_fn(|axis| eye[axis] - p[axis]);
    let far = dot(v, v).sqrt();
    let direction = v.map(|v| if far > 0.0 { v / far } else { 0.0 });
    let eye = eye.map(|x| x - 0.5);
    let end = dot(eye, direction);
    let foot = std::array::from_fn(|axis| eye[axis] - end * direction[axis]);
    let inner = 3f64.sqrt() / 4.0;
    let radius = dot(foot, foot).sqrt().max(inner);
    let squeeze = |u: f64| {
        if u.abs() <= radius { u } else { u.signum() * (2.0 * radius - radius * radius / u.abs()) }
    };
    let ends = [squeeze(end - far), squeeze(end)];
    let length = inner / radius * (ends[1] - ends[0]);
    let count = (length / step).ceil().min(MAX_STEPS);
    let factor = if count > 0.0 { length / count / step } else { 0.0 };
    ContractedRay { foot, direction, radius, ends, length, count, factor }
}

impl ContractedRay {
    /// The midpoint x_k of Eq. 9, contracted.
    pub fn midpoint(&self, k: u32, count: u32) -> [f64; 3] {
        let [begin, end] = self.ends;
        let r = begin + (f64::from(k) + 0.5) / f64::from(count) * (end - begin);
        let radius = self.radius;
        let u = if r.abs() <= radius {
            r
        } else {
            r.signum() * radius * radius / (2.0 * radius - r.abs())
        };
        contract(std::array::from_fn(|axis| 0.5 + self.foot[axis] + u * self.direction[axis]))
    }
}
