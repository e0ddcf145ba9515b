//! Hyperbolic functions and their inverses, by the polynomials of Cephes where a difference would lose the digits of a small x.

use core::f32::consts::{LN_2, SQRT_2};

use super::{abs, ln, minus_size, size, sqrt, with_sign_of};
use crate::lane::Lane;

/// Hyperbolic sine, to 1e-6 (1 + |x|) of its size; infinite where it is beyond the largest `f32`.
#[inline(always)]
pub fn sinh<L: Lane>(x: L) -> L {
    let number = L::splat;
    let z = x * x;
    let series = (number(2.037_219_1e-4) * z + number(8.330_284e-3)) * z + number(1.666_667_2e-1);
    let [half, inverse] = halves(x);
    let large = with_sign_of(x, half - inverse);
    L::select(size(x).less(number(1.0)), series * z * x + x, large)
}

/// Hyperbolic cosine, to 1e-6 (1 + |x|) of its size; infinite where it is beyond the largest `f32`.
#[inline(always)]
pub fn cosh<L: Lane>(x: L) -> L {
    let [half, inverse] = halves(x);
    half + inverse
}

/// The halves of e^|x| and of e^-|x|. The root of e^|x| is no infinity where one of these functions is finite.
#[inline(always)]
fn halves<L: Lane>(x: L) -> [L; 2] {
    let half = L::splat(0.5);
    let root = (size(x) * half).exp();
    [half * root * root, half / root / root]
}

/// Hyperbolic tangent, to 3e-7 of its size.
#[inline(always)]
pub fn tanh<L: Lane>(x: L) -> L {
    let number = L::splat;
    let one = number(1.0);
    let e = minus_size(x + x).exp();
    let large = with_sign_of(x, (one - e) / (one + e));
    // Cephes' polynomial: the difference above would lose the digits of a small x
    let z = x * x;
    let series = (number(-5.704_988_7e-3) * z + number(2.063_909e-2)) * z - number(5.373_971_6e-2);
    let series = ((series * z + number(1.333_144_2e-1)) * z - number(3.333_328e-1)) * z;
    L::select(size(x).less(number(0.625)), series * x + x, large)
}

/// Inverse hyperbolic sine, to 1e-6 of its size, for finite numbers.
#[inline(always)]
pub fn asinh(x: f32) -> f32 {
    let size = abs(x);
    let z = x * x;
    let series = (2.012_200_3e-2 * z - 4.269_934e-2) * z + 7.484_759e-2;
    let series = (series * z - 1.666_628_8e-1) * z;
    let value = if size < 0.5 {
        series * size + size
    } else if size < LARGE {
        ln(size + sqrt(z + 1.0))
    } else {
        ln(size) + LN_2
    };
    if x < 0.0 { -value } else { value }
}

/// Inverse hyperbolic cosine, to 1e-6 of its size, for finite numbers. What is below 1 counts as that.
#[inline(always)]
pub fn acosh(x: f32) -> f32 {
    let t = super::max(x - 1.0, 0.0);
    let root = sqrt(t);
    let series = (1.759_688_1e-3 * t - 7.527_288_7e-3) * t + 2.645_49e-2;
    let series = (series * t - 1.178_474_2e-1) * t + SQRT_2;
    if t < 0.5 {
        series * root
    } else if t < LARGE {
        ln(x + root * sqrt(x + 1.0))
    } else {
        ln(x) + LN_2
    }
}

/// Inverse hyperbolic tangent, to 1e-6 of its size, for |x| below 1.
#[inline(always)]
pub fn atanh(x: f32) -> f32 {
    let z = x * x;
    let series = (1.817_407_8e-1 * z + 8.243_703e-2) * z + 1.466_914_3e-1;
    let series = ((series * z + 1.997_821_6e-1) * z + 3.333_373e-1) * z;
    if abs(x) < 0.5 { series * x + x } else { 0.5 * ln((1.0 + x) / (1.0 - x)) }
}

/// From here on, 1 is nothing beside a square.
const LARGE: f32 = 1e6;
