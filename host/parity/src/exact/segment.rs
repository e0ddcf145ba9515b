//! Eq. 4 to 8: a ray in the unit cube, and its steps; a contracted ray, and its steps.

use super::numeric::{Number, dot};
use super::unit_cube::contract;

/// The part of a ray in the unit cube.
#[derive(Clone, Copy, Debug)]
pub struct Segment<N> {
    /// s, where the segment begins.
    pub start: [N; 3],
    /// w, from its begin to its end.
    pub w: [N; 3],
    /// K; 0 where the ray misses the cube.
    pub count: N,
    /// `L / K / sigma`; 0 where the ray misses the cube.
    pub factor: N,
}

/// Eq. 4 and 5 for `p + t v`: where it enters the cube and where it leaves it.
fn planes<N: Number>(p: [N; 3], v: [N; 3]) -> [N; 2] {
    let endless = N::from(f64::INFINITY);
    let mut enter = -endless;
    let mut exit = endless;
    for (p, v) in p.into_iter().zip(v) {
        if v.value() == 0.0 {
            if !(0.0..=1.0).contains(&p.value()) {
                return [endless, -endless];
            }
            continue;
        }
        let [zero, one] = [-p / v, (N::from(1.0) - p) / v];
        enter = enter.max(zero.min(one));
        exit = exit.min(zero.max(one));
    }
    [enter, exit]
}

/// K and `L / K / sigma` of a ray of length L.
fn steps<N: Number>(length: N, step: f64) -> [N; 2] {
    const MAX_STEPS: f64 = 16_384.0;
    let steps = length / N::from(step);
    let count = steps.above(MAX_STEPS, N::from(MAX_STEPS), steps.ceil());
    [count, if count.value() > 0.0 { steps / count } else { N::from(0.0) }]
}

/// The segment from a Gaussian to a camera, both in the unit cube's space, in steps of about `step` (sigma).
pub fn segment<N: Number>(p: [N; 3], eye: [N; 3], step: f64) -> Segment<N> {
    let v = std::array::from_fn(|axis| eye[axis] - p[axis]);
    // Eq. 6
    let [zero, one] = [0.0, 1.0].map(N::from);
    let [t0, t1] = planes(p, v).map(|t| t.min(one).max(zero));
    let lambda = (t1 - t0).max(zero);
    let w = v.map(|v| lambda * v);
    let [count, factor] = steps(dot(w, w).sqrt(), step);
    Segment { start: std::array::from_fn(|axis| p[axis] + t0 * v[axis]), w, count, factor }
}

/// A ray from a Gaussian to a camera in contracted space. The cube's center is the origin.
#[derive(Clone, Copy, Debug)]
pub struct ContractedRay<N> {
    /// The point nearest to the origin.
    pub foot: [N; 3],
    /// Toward the camera, a unit vector.
    pub direction: [N; 3],
    /// Up to this distance from the foot, steps are even.
    pub radius: N,
    /// The Gaussian and the camera, in the coordinate with even steps.
    pub ends: [N; 2],
    /// K; 0 without a ray.
    pub count: N,
    /// `L / K / sigma`; 0 without a ray.
    pub factor: N,
}

/// The ray from a Gaussian to a camera, both in the unit cube's space, in steps of about `step` (sigma).
pub fn contracted_ray<N: Number>(p: [N; 3], eye: [N; 3], step: f64) -> ContractedRay<N> {
    let v: [N; 3] = std::array::from_fn(|axis| eye[axis] - p[axis]);
    let zero = N::from(0.0);
    let far = dot(v, v).sqrt();
    let direction = v.map(|v| if far.value() > 0.0 { v / far } else { zero });
    let eye = eye.map(|x| x - N::from(0.5));
    let end = dot(eye, direction);
    let foot = std::array::from_fn(|axis| eye[axis] - end * direction[axis]);
    let inner = N::from(3f64.sqrt() / 4.0);
    let radius = dot(foot, foot).sqrt().max(inner);
    let squeeze = |u: N| {
        let beyond = N::from(2.0) * radius - radius * radius / u.abs();
        (u.abs() - radius).above(0.0, u.above(0.0, beyond, -beyond), u)
    };
    let ends = [squeeze(end - far), squeeze(end)];
    let [count, factor] = steps(inner / radius * (ends[1] - ends[0]), step);
    ContractedRay { foot, direction, radius, ends, count, factor }
}

impl ContractedRay<f64> {
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
