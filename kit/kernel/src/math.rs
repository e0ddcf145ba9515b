//! Elementary functions, the same for every kernel.
//!
//! For [`exp`], [`sqrt`] and [`ceil`] a GPU uses the instructions of GLSL.std.450. The CPU has an instruction for [`sqrt`], and uses the crate
//! `libm` for the others, so its results do not depend on the system's C library. All other functions are sums, products and quotients that
//! every device computes: the errors that they state hold everywhere, unlike the errors of a GPU's own `sin`, `log` or `pow`. The kernel
//! `elementary` of `kit/language` tests them.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::Vec3;

#[cfg(all(not(target_arch = "spirv"), debug_assertions))]
use crate::casts::check_logarithm;
use crate::lane::Lane;
pub use crate::pack::*;
pub use crate::scalar::*;
pub use hyperbolic::{acosh, asinh, atanh, cosh, sinh, tanh};
pub use integers::*;

mod hyperbolic;
mod integers;

/// x less the largest integer that is not greater: from 0 to 1, as `fract` of WGSL. Rust's `x.fract()` has the sign of x.
#[inline(always)]
pub fn fract<L: Lane>(x: L) -> L {
    x - floor(x)
}

/// -1, 0 or 1. Rust's `x.signum()` is never 0.
#[inline(always)]
pub fn sign<L: Lane>(x: L) -> L {
    let [zero, one] = [L::splat(0.0), L::splat(1.0)];
    L::select(zero.less(x), one, L::select(x.less(zero), -one, zero))
}

/// 1 from the edge on, 0 below it.
#[inline(always)]
pub fn step<L: Lane>(edge: L, x: L) -> L {
    L::select(edge.less_equal(x), L::splat(1.0), L::splat(0.0))
}

/// From 0 at `low` to 1 at `high` along 3 t^2 - 2 t^3, to 1e-6; 0 and 1 outside.
#[inline(always)]
pub fn smoothstep<L: Lane>(low: L, high: L, x: L) -> L {
    let number = L::splat;
    let t = ((x - low) / (high - low)).max(number(0.0)).min(number(1.0));
    t * t * (number(3.0) - number(2.0) * t)
}

/// 1 / sqrt x, to 1e-6 of its size, for positive x from [`TINY`] on.
#[inline(always)]
pub fn inverse_sqrt<L: Lane>(x: L) -> L {
    L::splat(1.0) / x.sqrt()
}

/// a + t (b - a): a for t = 0, and b for t = 1, but for a rounding of both sizes.
#[inline(always)]
pub fn mix<L: Lane>(a: L, b: L, t: L) -> L {
    a + t * (b - a)
}

/// Largest integer that is not greater than x; infinity, NaN and -0 are what they were. A GPU may take a negative denormal for 0.
#[inline(always)]
pub fn floor<L: Lane>(x: L) -> L {
    let whole = x.truncate();
    L::select(x.less(whole), whole - L::splat(1.0), whole)
}

/// Nearest integer, halves away from 0; infinity, NaN and -0 are what they were.
#[inline(always)]
pub fn round<L: Lane>(x: L) -> L {
    let whole = x.truncate();
    let half = L::splat(0.5);
    let rest = x - whole;
    let up = L::select(half.less_equal(rest), whole + L::splat(1.0), whole);
    L::select(rest.less_equal(-half), whole - L::splat(1.0), up)
}

/// Nearest integer, halves to the even one; infinity, NaN and -0 are what they were.
#[inline(always)]
pub fn round_even<L: Lane>(x: L) -> L {
    let half = L::splat(0.5);
    let even = L::splat(2.0) * round(x * half);
    let distance = x - even;
    let is_nearest = L::both((-half).less_equal(distance), distance.less_equal(half));
    L::select(is_nearest, even, round(x))
}

/// The largest angle of [`sin`], [`cos`] and [`tan`].
pub const MAX_ANGLE: f32 = 8192.0;

/// Sine, to 1.2e-7, for |x| up to [`MAX_ANGLE`].
#[inline(always)]
pub fn sin<L: Lane>(x: L) -> L {
    sine_in_quarter(quarter(x), 0.0)
}

/// Cosine, to 1.2e-7, for |x| up to [`MAX_ANGLE`].
#[inline(always)]
pub fn cos<L: Lane>(x: L) -> L {
    sine_in_quarter(quarter(x), 1.0)
}

/// Tangent, to 5e-7 (1 + tan^2), for |x| up to [`MAX_ANGLE`].
#[inline(always)]
pub fn tan<L: Lane>(x: L) -> L {
    let angle = quarter(x);
    sine_in_quarter(angle, 0.0) / sine_in_quarter(angle, 1.0)
}

/// n and r of x = n pi/2 + r, |r| <= pi/4: Cody and Waite's reduction. The first two parts of pi/2 have so few bits that their products
/// with n are exact.
#[inline(always)]
fn quarter<L: Lane>(x: L) -> (L, L) {
    let number = L::splat;
    let n = round(x * number(core::f32::consts::FRAC_2_PI));
    let rest = (x - n * number(1.570_312_5)) - n * number(4.837_513e-4);
    (n, rest - n * number(7.549_79e-8))
}

/// sin((n + ahead) pi/2 + r): Cephes' polynomials.
#[inline(always)]
fn sine_in_quarter<L: Lane>((n, r): (L, L), ahead: f32) -> L {
    let number = L::splat;
    let n = n + number(ahead);
    let z = r * r;
    let sine = (number(-1.951_529_6e-4) * z + number(8.332_161e-3)) * z - number(1.666_665_5e-1);
    let sine = sine * z * r + r;
    let cosine = (number(2.443_315_7e-5) * z - number(1.388_731_6e-3)) * z + number(4.166_664_6e-2);
    let cosine = cosine * z * z - number(0.5) * z + number(1.0);
    let half = n * number(0.5);
    let is_odd = number(0.25).less(half - floor(half));
    let fourth = half * number(0.5);
    let is_negative = number(0.5).less_equal(fourth - floor(fourth));
    let value = L::select(is_odd, cosine, sine);
    L::select(is_negative, -value, value)
}

/// Arctangent, to 2e-7.
#[inline(always)]
pub fn atan<L: Lane>(x: L) -> L {
    let number = L::splat;
    let size = size(x);
    let is_large = number(2.414_213_6).less(size);
    let is_middle = number(0.414_213_57).less(size);
    // the tangent of the angle less a half, a fourth or nothing of a right angle
    let middle = (size - number(1.0)) / (size + number(1.0));
    let rest = L::select(is_middle, middle, size);
    let rest = L::select(is_large, number(-1.0) / size, rest);
    let turn = L::select(is_middle, number(FRAC_PI_4), number(0.0));
    let turn = L::select(is_large, number(FRAC_PI_2), turn);
    // Cephes' polynomial
    let z = rest * rest;
    let series = (number(8.053_744_5e-2) * z - number(1.387_768_6e-1)) * z + number(1.997_771_1e-1);
    let series = (series * z - number(3.333_295e-1)) * z;
    with_sign_of(x, turn + (series * rest + rest))
}

/// The angle of the point (x, y), from -pi to pi, to 4e-7, for finite numbers below 2^126; 0 for the point (0, 0), and pi where y
/// is 0 of any sign and x is negative. A GPU may take a denormal for 0.
#[inline(always)]
pub fn atan2<L: Lane>(y: L, x: L) -> L {
    let number = L::splat;
    let [along, up] = [size(x), size(y)];
    let is_steep = along.less(up);
    // at most 1, and 0 for the point (0, 0)
    let tangent = along.min(up) / along.max(up).max(number(TINY));
    let angle = atan(tangent);
    let angle = L::select(is_steep, number(FRAC_PI_2) - angle, angle);
    let angle = L::select(x.less(number(0.0)), number(PI) - angle, angle);
    with_sign_of(y, angle)
}

/// Arcsine, to 2e-7. What is beyond -1 or 1 counts as that.
#[inline(always)]
pub fn asin<L: Lane>(x: L) -> L {
    let (is_large, angle) = arcsine_of_size(size(x));
    let angle = L::select(is_large, L::splat(FRAC_PI_2) - angle, angle);
    with_sign_of(x, angle)
}

/// Arccosine, to 4e-7. What is beyond -1 or 1 counts as that.
#[inline(always)]
pub fn acos<L: Lane>(x: L) -> L {
    let number = L::splat;
    let (is_large, angle) = arcsine_of_size(size(x));
    let is_negative = x.less(number(0.0));
    let far = L::select(is_negative, number(PI) - angle, angle);
    L::select(is_large, far, number(FRAC_PI_2) - with_sign_of(x, angle))
}

/// The arcsine of x >= 0, or the arccosine if x is more than a half, and whether it is. Cephes' polynomial takes at most a half.
#[inline(always)]
fn arcsine_of_size<L: Lane>(x: L) -> (L::Mask, L) {
    let number = L::splat;
    let half = number(0.5);
    let is_large = half.less(x);
    // arccos x = 2 arcsin sqrt((1 - x) / 2)
    let square = (number(1.0) - x.min(number(1.0))) * half;
    let z = L::select(is_large, square, x * x);
    let root = L::select(is_large, square.sqrt(), x);
    let series = (number(4.216_32e-2) * z + number(2.418_131e-2)) * z + number(4.547_002_6e-2);
    let series = ((series * z + number(7.495_300_3e-2)) * z + number(1.666_675_2e-1)) * z;
    let angle = series * root + root;
    (is_large, L::select(is_large, angle + angle, angle))
}

/// |x|
#[inline(always)]
fn size<L: Lane>(x: L) -> L {
    -minus_size(x)
}

/// `value` for x from 0 on, `-value` for a negative x.
#[inline(always)]
fn with_sign_of<L: Lane>(x: L, value: L) -> L {
    L::select(x.less(L::splat(0.0)), -value, value)
}

/// Natural logarithm, to 5e-7 of its size, for finite numbers from [`TINY`] on. Any other x gives some number. A device that checks
/// refuses it, but for those from 0 to [`TINY`], whose logarithm is about -88.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn ln(x: f32) -> f32 {
    #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
    check_logarithm(x);
    let (n, s, rest) = logarithm(x);
    // the first part of ln 2 has few bits
    n * 0.693_359_4 + (s + (rest - n * 2.121_944_4e-4))
}

/// Logarithm to the base 2, to 5e-7 of its size, for what [`ln`] takes. A power of two has the exact one.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn log2(x: f32) -> f32 {
    #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
    check_logarithm(x);
    let (n, s, rest) = logarithm(x);
    n + (s + rest) * core::f32::consts::LOG2_E
}

/// n, s and r of ln x = n ln 2 + s + r, where r is much smaller than s.
#[inline(always)]
fn logarithm(x: f32) -> (f32, f32, f32) {
    // x = 2^n m with m in [1/sqrt 2, sqrt 2]
    let bits = x.to_bits().wrapping_sub(0x3f35_04f3);
    let n = (bits as i32 >> 23) as f32;
    let m = f32::from_bits((bits & 0x7f_ffff) + 0x3f35_04f3);
    // ln m = 2 atanh(s), by its series
    let s = (m - 1.0) / (m + 1.0);
    let t = s * s;
    let series = t * (1.0 / 3.0 + t * (1.0 / 5.0 + t * (1.0 / 7.0 + t * (1.0 / 9.0))));
    (n, 2.0 * s, 2.0 * s * series)
}

/// 2^x, to 3e-7 of its size. Infinity from 128 on, exact for integers, and below -126 what a device makes of denormals.
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    let n = round(clamp(x, -151.0, 129.0));
    let f = x - n;
    // Cephes' polynomial for |f| up to a half
    let series = (1.535_336_2e-4 * f + 1.339_887_4e-3) * f + 9.618_437e-3;
    let series = ((series * f + 5.550_332_5e-2) * f + 2.402_264_8e-1) * f + 6.931_472e-1;
    // in two steps, because 2^128 is infinite
    let first = n as i32 / 2;
    let second = n as i32 - first;
    let power = |n: i32| f32::from_bits(((n + 127) as u32) << 23);
    let value = (series * f + 1.0) * power(first) * power(second);
    // elsewhere, f is no fraction
    if x < -151.0 {
        0.0
    } else if x > 129.0 {
        power(128)
    } else {
        value
    }
}

/// x 2^n, exact as long as it is from [`TINY`] to [`HUGE`]; infinite or 0 where n is beyond that.
#[inline(always)]
pub fn ldexp(x: f32, n: i32) -> f32 {
    let limited = n.max(-300).min(300);
    // in three steps, because a power of two is one of 254
    let first = limited / 3;
    let second = (limited - first) / 2;
    let power = |n: i32| f32::from_bits(((n + 127) as u32) << 23);
    x * power(first) * power(second) * power(limited - first - second)
}

/// f and n of x = f 2^n with |f| from 1/2 to 1, for |x| from [`TINY`] to [`HUGE`]; 0 and 0 for 0.
#[inline(always)]
pub fn frexp(x: f32) -> (f32, i32) {
    let bits = x.to_bits();
    let exponent = bits >> 23 & 0xff;
    // a device may take a denormal for 0
    if exponent == 0 {
        return (0.0, 0);
    }
    (f32::from_bits(bits & 0x807f_ffff | 126 << 23), exponent as i32 - 126)
}

/// x^y for positive x from [`TINY`] on, to 1e-6 (1 + |y ln x|) of its size, as long as it is from [`TINY`] to [`HUGE`]. A device that checks
/// refuses what [`ln`] refuses.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn pow(x: f32, y: f32) -> f32 {
    exp(y * ln(x))
}

/// Whether x is neither infinite nor NaN.
#[inline(always)]
pub fn is_finite(x: f32) -> bool {
    abs(x) <= HUGE
}

/// 1 / (1 + e^-x), without overflow for any x.
#[inline(always)]
pub fn sigmoid<L: Lane>(x: L) -> L {
    let zero = L::splat(0.0);
    let one = L::splat(1.0);
    let e = minus_size(x).exp();
    let larger = one / (one + e);
    L::select(x.less(zero), e * larger, larger)
}

/// ln(sigmoid(x)) = min(x, 0) - ln(1 + e^-|x|), without overflow and without loss for large x.
#[inline(always)]
pub fn log_sigmoid<L: Lane>(x: L) -> L {
    x.min(L::splat(0.0)) - ln_1p(minus_size(x).exp())
}

/// -|x|
#[inline(always)]
fn minus_size<L: Lane>(x: L) -> L {
    L::select(x.less(L::splat(0.0)), x, -x)
}

/// ln(1 + x) = 2 atanh(x / (2 + x)) for x in [0, 1], by its series (error below 1e-8). Computing 1 + x would lose the
/// digits of a small x.
#[inline(always)]
fn ln_1p<L: Lane>(x: L) -> L {
    let number = L::splat;
    let s = x / (number(2.0) + x);
    let t = s * s;
    let series = number(1.0 / 9.0) + t * (number(1.0 / 11.0) + t * number(1.0 / 13.0));
    let series = number(1.0 / 5.0) + t * (number(1.0 / 7.0) + t * series);
    number(2.0) * s * (number(1.0) + t * (number(1.0 / 3.0) + t * series))
}

/// Dot product.
#[inline(always)]
pub fn dot(a: Vec3, b: Vec3) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// Cross product.
#[inline(always)]
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// Euclidean length.
#[inline(always)]
pub fn length(v: Vec3) -> f32 {
    sqrt(dot(v, v))
}

/// v / |v|. Shorter than 1 where the square of |v| is below [`TINY`], as a GPU can flush that; zero for zero.
#[inline(always)]
pub fn normalize(v: Vec3) -> Vec3 {
    v * (1.0 / sqrt(max(dot(v, v), TINY)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lane::Wide;

    #[test]
    fn a_denormal_has_a_sign_and_no_direction() {
        let denormal = TINY / 2.0;
        assert_eq!([denormal, -denormal].map(abs), [denormal; 2]);
        for size in [1e-30, 1e-20, 1e-19] {
            let found = length(normalize(Vec3::new(size, -size, 0.0)));
            assert!(found <= 1.0 + 1e-6, "{found} of {size}");
        }
        assert_eq!(normalize(Vec3::ZERO), Vec3::ZERO);
    }

    #[test]
    fn sigmoids_match_f64_from_end_to_end() {
        for step in -2000..=2000 {
            let x = step as f32 * 0.05;
            let exact = 1.0 / (1.0 + libm::exp(-f64::from(x)));
            let exact_log = if x < 0.0 { f64::from(x) } else { 0.0 }
                - libm::log1p(libm::exp(-f64::from(x).abs()));
            assert!((f64::from(sigmoid(x)) - exact).abs() <= 2e-7 * exact + 1e-44, "sigmoid({x})");
            assert!(
                (f64::from(log_sigmoid(x)) - exact_log).abs() <= 4e-7 * exact_log.abs() + 1e-44,
                "log_sigmoid({x})"
            );
        }
        assert_eq!(sigmoid(-HUGE), 0.0);
        assert_eq!(sigmoid(HUGE), 1.0);
        assert_eq!(log_sigmoid(HUGE), 0.0);
    }

    #[test]
    fn lanes_have_the_same_functions() {
        let mut worst = 0.0_f64;
        for step in -80_000..=80_000 {
            let x = step as f32 * 0.1023;
            let exact = f64::from(x);
            for (found, exact) in [(sin(x), libm::sin(exact)), (cos(x), libm::cos(exact))] {
                worst = worst.max((f64::from(found) - exact).abs());
            }
            let wide = Wide::<8, false>::splat(x);
            assert_eq!((sin(wide).0[3], tan(wide).0[7]), (sin(x), tan(x)), "{x}");
            assert_eq!((floor(wide).0[0], round(wide).0[0]), (floor(x), round(x)), "{x}");
            assert_eq!((floor(x), round(x)), (libm::floorf(x), libm::roundf(x)), "{x}");
            let half = 0.5 * (step as f32);
            assert_eq!(round_even(half), libm::rintf(half), "{half}");
            assert_eq!(round_even(Wide::<8, false>::splat(half)).0[7], round_even(half), "{half}");
        }
        assert!(worst < 1.2e-7, "{worst:e}");
    }

    // their errors are held by the kernel `elementary`
    #[test]
    fn inverse_and_hyperbolic_functions_have_ends() {
        assert_eq!([atan2(0.0, 0.0), asin(1.5), acos(1.5)], [0.0, FRAC_PI_2, 0.0]);
        assert_eq!([exp2(-3.0), exp2(127.0), exp2(-126.0)], [0.125, 2.0_f32.powi(127), TINY]);
        assert_eq!([exp2(128.0), exp2(1e9), exp2(-1e9)], [f32::INFINITY, f32::INFINITY, 0.0]);
        assert_eq!([sinh(-100.0), cosh(100.0)], [f32::NEG_INFINITY, f32::INFINITY]);
        assert_eq!([sinh(89.0), cosh(-89.0)].map(is_finite), [true; 2]);
        assert_eq!([asinh(0.0), acosh(1.0), acosh(0.5), atanh(0.0)], [0.0; 4]);
        assert!(asinh(-HUGE) < -89.0 && acosh(HUGE) > 89.0);
        let not_numbers = [exp2(f32::NAN), tanh(f32::NAN), sinh(f32::NAN), atan(f32::NAN)];
        assert!(not_numbers.iter().all(|x| x.is_nan()));
        assert_eq!([tanh(100.0), tanh(-HUGE), atan(f32::INFINITY)], [1.0, -1.0, FRAC_PI_2]);
        for n in -126..128 {
            assert_eq!(log2(exp2(n as f32)), n as f32);
        }
        let wide = Wide::<8, false>::splat(-0.7);
        assert_eq!(atan2(wide, wide).0[3], atan2(-0.7, -0.7));
        assert_eq!(
            [asin(wide).0[0], acos(wide).0[1], tanh(wide).0[2], fract(wide).0[3], sign(wide).0[4]],
            [asin(-0.7), acos(-0.7), tanh(-0.7), fract(-0.7), -1.0]
        );
        for (x, f, n) in
            [(1.0, 0.5, 1), (-3.0, -0.75, 2), (TINY, 0.5, -125), (HUGE, 0.999_999_94, 128)]
        {
            assert_eq!((frexp(x), ldexp(f, n)), ((f, n), x));
        }
        assert_eq!(
            [ldexp(1.0, 128), ldexp(-1.0, i32::MAX), ldexp(HUGE, -300)],
            [f32::INFINITY, f32::NEG_INFINITY, 0.0]
        );
        assert_eq!(ldexp(TINY, 253), HUGE.min(2.0_f32.powi(127)));
    }

    #[test]
    fn finite_is_neither_infinite_nor_nan() {
        assert!(is_finite(HUGE) && is_finite(-HUGE) && is_finite(0.0));
        assert!(!is_finite(f32::INFINITY) && !is_finite(f32::NEG_INFINITY) && !is_finite(f32::NAN));
    }
}
