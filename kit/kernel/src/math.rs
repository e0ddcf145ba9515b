//! Elementary functions, the same for every kernel.
//!
//! A GPU uses the instructions of GLSL.std.450. The CPU uses the crate `libm`, so its results do not depend on the system's C
//! library.

#[cfg(target_arch = "spirv")]
use spirv_std::num_traits::Float;

use glam::Vec3;

#[cfg(all(not(target_arch = "spirv"), debug_assertions))]
use crate::casts::check_cast;
use crate::lane::Lane;

/// Largest finite `f32`: stands for infinity, which naga does not accept as a literal.
pub const HUGE: f32 = 3.402_823_5e38;

/// Smallest normal `f32`: a GPU can flush smaller numbers to zero.
pub const TINY: f32 = 1.175_494_4e-38;

macro_rules! elementary {
    ($($(#[$doc:meta])* $name:ident => $libm:ident;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(x: f32) -> f32 {
            #[cfg(target_arch = "spirv")]
            {
                Float::$name(x)
            }
            #[cfg(not(target_arch = "spirv"))]
            {
                libm::$libm(x)
            }
        }
    )*};
}

elementary! {
    /// e^x
    exp => expf;
    /// Square root.
    sqrt => sqrtf;
    /// Smallest integer that is not less than x.
    ceil => ceilf;
}

/// x without its fraction, for |x| below 2^31.
#[inline(always)]
pub fn truncate(x: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    {
        Float::trunc(x)
    }
    // one instruction each way, while `libm` computes with bits
    #[cfg(not(target_arch = "spirv"))]
    {
        x as i32 as f32
    }
}

/// x without its fraction, for x from 0 to below 2^32. Any other x gives some number, which on the CPU is the
/// nearest. A device that checks refuses it.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn to_u32(x: f32) -> u32 {
    // `as` takes four more instructions on a GPU, because it compares with both limits
    #[cfg(target_arch = "spirv")]
    {
        // SAFETY: SPIR-V's conversion has an undefined result there, but no undefined behavior
        unsafe { x.to_int_unchecked() }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        #[cfg(debug_assertions)]
        check_cast::<u32, _>(x);
        x as u32
    }
}

/// |x|
#[inline(always)]
pub fn abs(x: f32) -> f32 {
    if x < 0.0 { -x } else { x }
}

/// The smaller of two numbers.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// x, clamped to `[low, high]`.
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}

/// Whether x is neither infinite nor NaN.
#[inline(always)]
pub fn is_finite(x: f32) -> bool {
    abs(x) <= HUGE
}

/// 1 / (1 + e^-x), without overflow for any x.
#[inline(always)]
pub fn sigmoid<L: Lane>(x: L) -> L {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
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

/// v / |v|; zero for zero.
#[inline(always)]
pub fn normalize(v: Vec3) -> Vec3 {
    v * (1.0 / max(length(v), TINY))
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn finite_is_neither_infinite_nor_nan() {
        assert!(is_finite(HUGE) && is_finite(-HUGE) && is_finite(0.0));
        assert!(!is_finite(f32::INFINITY) && !is_finite(f32::NEG_INFINITY) && !is_finite(f32::NAN));
    }
}
