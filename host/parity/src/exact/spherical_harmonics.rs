//! Real spherical harmonics with the Condon-Shortley phase (the embedding of Eq. 1).

use std::f64::consts::{PI, SQRT_2};

/// The unit direction from a camera to a Gaussian.
pub fn direction(eye: [f64; 3], center: [f64; 3]) -> [f64; 3] {
    let v: [f64; 3] = std::array::from_fn(|axis| center[axis] - eye[axis]);
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// The harmonic of band l and order m, which is at `l*l + l + m`: from angles and Rodrigues' associated Legendre functions.
pub fn harmonic(at: usize, [x, y, z]: [f64; 3]) -> f64 {
    let l = at.isqrt() as i32;
    let m = at as i32 - l * l - l;
    let order = m.abs();
    let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
    let sine = (1.0 - z * z).max(0.0).sqrt();
    // P_m^m with the Condon-Shortley phase, then up to P_l^m
    let mut below = 0.0;
    let mut legendre: f64 = (1..=order).map(|k| -f64::from(2 * k - 1) * sine).product();
    for k in order + 1..=l {
        let next = f64::from(2 * k - 1) * z * legendre - f64::from(k + order - 1) * below;
        below = legendre;
        legendre = next / f64::from(k - order);
    }
    let ratio = factorial(l - order) / factorial(l + order);
    let norm = (f64::from(2 * l + 1) / (4.0 * PI) * ratio).sqrt();
    let angle = f64::from(order) * y.atan2(x);
    let wave = match m {
        0 => 1.0,
        1.. => SQRT_2 * angle.cos(),
        _ => SQRT_2 * angle.sin(),
    };
    norm * legendre * wave
}
