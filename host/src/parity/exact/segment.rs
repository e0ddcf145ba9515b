//! Eq. 4 to 8: a ray in the unit cube, and its steps.

use super::numeric::dot;

/// The part of a ray in the unit cube.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// Its begin, s.
    pub start: [f64; 3],
    /// Its way, w.
    pub way: [f64; 3],
    /// K; 0 where the ray misses the cube.
    pub count: f64,
    /// `L / K / sigma`; 0 where the ray misses the cube.
    pub factor: f64,
}

/// Steps that a ray has at most.
const MAX_STEPS: f64 = 16_384.0;

/// Eq. 4 and 5 for `p + t v`: where it enters the cube and where it leaves it.
#[must_use]
pub fn planes(p: [f64; 3], v: [f64; 3]) -> [f64; 2] {
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        if v[axis] == 0.0 {
            if !(0.0..=1.0).contains(&p[axis]) {
                (enter, exit) = (f64::INFINITY, f64::NEG_INFINITY);
            }
            continue;
        }
        let (zero, one) = ((0.0 - p[axis]) / v[axis], (1.0 - p[axis]) / v[axis]);
        enter = enter.max(zero.min(one));
        exit = exit.min(zero.max(one));
    }
    [enter, exit]
}

/// Eq. 6: t0 and lambda.
#[must_use]
pub fn clip([enter, exit]: [f64; 2]) -> [f64; 2] {
    let t0 = enter.clamp(0.0, 1.0);
    [t0, (exit.clamp(0.0, 1.0) - t0).max(0.0)]
}

/// The segment from a Gaussian to a camera, both in the unit cube's space, in steps of about `step` (sigma).
#[must_use]
pub fn segment(p: [f64; 3], eye: [f64; 3], step: f64) -> Segment {
    let v = std::array::from_fn(|axis| eye[axis] - p[axis]);
    let [t0, lambda] = clip(planes(p, v));
    let way = v.map(|v| lambda * v);
    let length = dot(way, way).sqrt();
    let count = (length / step).ceil().min(MAX_STEPS);
    let factor = if count > 0.0 { length / count / step } else { 0.0 };
    Segment { start: std::array::from_fn(|axis| p[axis] + t0 * v[axis]), way, count, factor }
}
