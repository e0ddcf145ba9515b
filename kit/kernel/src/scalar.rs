//! The functions of a single number that [lanes](crate::lane) and [fixed-point numbers](crate::fixed) are made of. [`math`](crate::math) has them, too.

#[cfg(target_arch = "spirv")]
use spirv_std::num_traits::Float;

#[cfg(all(not(target_arch = "spirv"), debug_assertions))]
use crate::casts::check_cast;

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
    /// Smallest integer that is not less than x.
    ceil => ceilf;
}

/// Square root.
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    {
        Float::sqrt(x)
    }
    // not `libm`'s: its assembly is SSE even among AVX instructions, where it stalls CPUs of Intel
    #[cfg(not(target_arch = "spirv"))]
    {
        x.sqrt()
    }
}

/// x without its fraction, with its sign; infinity and NaN are what they were.
#[inline(always)]
pub fn truncate(x: f32) -> f32 {
    #[cfg(target_arch = "spirv")]
    {
        Float::trunc(x)
    }
    // an integer and back, while `libm` computes with bits
    #[cfg(not(target_arch = "spirv"))]
    {
        integral(x, x as i32 as f32)
    }
}

/// `whole` with the sign of x, or x itself from 2^23 on, where no number has a fraction.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
pub(crate) fn integral(x: f32, whole: f32) -> f32 {
    if abs(x) < 8_388_608.0 { whole.copysign(x) } else { x }
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

/// |x|, without a comparison: a GPU may take a negative denormal for 0, and keep its sign.
#[inline(always)]
pub fn abs(x: f32) -> f32 {
    x.abs()
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
