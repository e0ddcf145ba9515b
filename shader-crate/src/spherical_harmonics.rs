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
