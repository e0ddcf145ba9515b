//! Real spherical harmonics with the Condon-Shortley phase (the embedding of Eq. 1).

use glam::Vec3;

use crate::limits::MAX_SH_DEGREE;
use muslin::math::sqrt;
use muslin::prelude::*;

/// The most iterations of [`spherical_harmonics`]: its outer loop's and its inner one's.
pub const ITERATIONS: u32 = MAX_SH_DEGREE + 1 + (MAX_SH_DEGREE + 1) * (MAX_SH_DEGREE + 2) / 2;

/// Values of the bands 0..=degree.
pub const fn width(degree: u32) -> u32 {
    (degree + 1) * (degree + 1)
}

/// Writes the harmonics of the unit vector `direction` up to `degree`; the one of band `l` and order `m` goes to
/// `output[first + (l*l + l + m) * stride]`.
///
/// The associated Legendre functions are normalized and divided by sin^|m|, so that their recurrence needs
/// no table and no factorials:
/// `P(m,m) = -sqrt((2m+1) / 2m) P(m-1,m-1)` and
/// `P(l,m) = sqrt((4l^2-1) / (l^2-m^2)) (z P(l-1,m) - sqrt(((l-1)^2-m^2) / (4(l-1)^2-1)) P(l-2,m))`.
#[loops]
#[inline(always)]
pub fn spherical_harmonics(
    direction: Vec3,
    degree: u32,
    output: Write<f32>,
    first: u32,
    stride: u32,
) {
    let z = direction.z;
    // sin(theta)^m * (cos, sin)(m phi)
    let mut cos = 1.0;
    let mut sin = 0.0;
    let mut diagonal = 0.282_094_79; // sqrt(1 / 4 pi)
    let mut m = 0;
    while m <= degree {
        let order = m as f32;
        if m > 0 {
            diagonal *= -sqrt((2.0 * order + 1.0) / (2.0 * order));
            (cos, sin) =
                (direction.x * cos - direction.y * sin, direction.x * sin + direction.y * cos);
        }
        // the harmonics of orders m and -m are sqrt(2) times larger than the normalization
        let twofold = if m > 0 { core::f32::consts::SQRT_2 } else { 1.0 };
        let mut previous = 0.0;
        let mut current = diagonal;
        let mut l = m;
        while l <= degree {
            if l > m {
                let band = l as f32;
                let below = band - 1.0;
                let a = sqrt((4.0 * band * band - 1.0) / (band * band - order * order));
                let b = sqrt((below * below - order * order) / (4.0 * below * below - 1.0));
                (previous, current) = (current, a * (z * current - b * previous));
            }
            let center = l * l + l;
            output.write(first + (center + m) * stride, twofold * current * cos);
            if m > 0 {
                output.write(first + (center - m) * stride, twofold * current * sin);
            }
            l += 1;
        }
        m += 1;
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::vec;

    /// P_l^m(x) with the Condon-Shortley phase, by the textbook's recurrence.
    fn associated_legendre(l: i32, m: i32, x: f64) -> f64 {
        let mut previous = 0.0;
        let double_factorial: f64 = (1..=m).map(|k| f64::from(2 * k - 1)).product();
        let mut current =
            (-1f64).powi(m) * double_factorial * (1.0 - x * x).powf(f64::from(m) / 2.0);
        for k in m + 1..=l {
            let next = (f64::from(2 * k - 1) * x * current - f64::from(k + m - 1) * previous)
                / f64::from(k - m);
            (previous, current) = (current, next);
        }
        current
    }

    fn factorial(n: i32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    /// `Y_lm` from angles: nothing of it is shared with the kernel.
    fn exact(l: i32, m: i32, theta: f64, phi: f64) -> f64 {
        let a = m.abs();
        let norm = (f64::from(2 * l + 1) / (4.0 * std::f64::consts::PI) * factorial(l - a)
            / factorial(l + a))
        .sqrt();
        let p = norm * associated_legendre(l, a, theta.cos());
        let angle = f64::from(a) * phi;
        match m {
            0 => p,
            1.. => std::f64::consts::SQRT_2 * p * angle.cos(),
            _ => std::f64::consts::SQRT_2 * p * angle.sin(),
        }
    }

    #[test]
    fn harmonics_follow_the_legendre_recurrence() {
        for degree in 0..=7 {
            for step in 0..200 {
                let theta = std::f64::consts::PI * (f64::from(step) + 0.37) / 200.0;
                let phi = f64::from(step) * 2.399_963;
                let direction = Vec3::new(
                    (theta.sin() * phi.cos()) as f32,
                    (theta.sin() * phi.sin()) as f32,
                    theta.cos() as f32,
                );
                let mut values = vec![f32::NAN; 2 * width(degree) as usize];
                spherical_harmonics(direction, degree, Write::from(values.as_mut_slice()), 1, 2);
                for l in 0..=degree as i32 {
                    for m in -l..=l {
                        let found = values[1 + 2 * (l * l + l + m) as usize];
                        let exact = exact(l, m, theta, phi);
                        assert!(
                            (f64::from(found) - exact).abs() < 3e-6,
                            "Y({l},{m}) is {found}, not {exact}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn band_one_has_the_sign_of_3dgs() {
        let mut values = [0.0; 4];
        spherical_harmonics(Vec3::new(0.6, 0.0, 0.8), 1, Write::from(values.as_mut_slice()), 0, 1);
        assert!((values[1] - 0.0).abs() < 1e-7);
        assert!((values[2] - 0.488_602_5 * 0.8).abs() < 1e-6);
        assert!((values[3] + 0.488_602_5 * 0.6).abs() < 1e-6);
    }
}
