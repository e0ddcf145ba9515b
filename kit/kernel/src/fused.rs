//! Arithmetic on the CPU, for the runs that look for what depends on the device: casts without room, fused and regrouped operations.

use core::any::type_name;
use core::panic::Location;

use crate::lane::Wide;
use crate::math::TINY;
use crate::running;

/// Most floats of a value.
const MAX_COMPONENTS: usize = 4;

/// The floats of a value, and their number; none of what has no floats, or is not known.
fn floats<T: Copy>(value: &T) -> ([f32; MAX_COMPONENTS], usize) {
    let name = type_name::<T>();
    let count = match size_of::<T>() / size_of::<f32>() {
        _ if name == type_name::<f32>() || name == type_name::<Wide<1, false>>() => 1,
        count @ 2..=MAX_COMPONENTS if name.starts_with("glam::f32::") && name.contains("::Vec") => {
            count
        }
        _ => 0,
    };
    let mut floats = [0.0; MAX_COMPONENTS];
    // SAFETY: a vector of glam has as many floats, and nothing before them
    unsafe {
        core::ptr::copy_nonoverlapping((&raw const *value).cast(), floats.as_mut_ptr(), count)
    };
    (floats, count)
}

/// `sign a b + other_sign c` with one rounding, if these are floats; otherwise `plain`, which is the same with two.
#[inline]
pub fn fused<A: Copy, B: Copy, C: Copy, O: Copy>(
    a: A,
    b: B,
    c: C,
    mut plain: O,
    [sign, other_sign]: [f32; 2],
) -> O {
    let (a, of_a) = floats(&a);
    let (b, of_b) = floats(&b);
    let (c, of_c) = floats(&c);
    let (mut sum, count) = floats(&plain);
    let fits = |of: usize| of == count || of == 1;
    if count > 0 && fits(of_a) && fits(of_b) && fits(of_c) {
        let at = |of: usize, i: usize| if of == 1 { 0 } else { i };
        for (i, sum) in sum.iter_mut().enumerate().take(count) {
            *sum = libm::fmaf(sign * a[at(of_a, i)], b[at(of_b, i)], other_sign * c[at(of_c, i)]);
        }
        // SAFETY: the floats of `plain`, in their place
        unsafe { core::ptr::copy_nonoverlapping(sum.as_ptr(), (&raw mut plain).cast(), count) };
    }
    plain
}

/// A sum or product as a driver may shorten it, if it is one of floats; otherwise `plain`, which is as it is written. Notes where they are far apart.
#[track_caller]
pub fn regrouped<O: Copy, S: Copy>(plain: O, short: impl FnOnce() -> S) -> O {
    let (written, count) = floats(&plain);
    if count == 0 || type_name::<O>() != type_name::<S>() {
        return plain;
    }
    let short = short();
    if (0..count).any(|i| is_far(written[i], floats(&short).0[i])) {
        running::note_regrouped(Location::caller());
    }
    // SAFETY: the types are the same
    unsafe { core::mem::transmute_copy(&short) }
}

/// Whether two numbers differ by more than a thousandth of the larger one: by more than some roundings.
pub fn is_far(a: f32, b: f32) -> bool {
    let size = a.abs().max(b.abs()).max(TINY);
    let difference = (a - b).abs();
    a.to_bits() != b.to_bits()
        && (a.is_finite() != b.is_finite() || difference.is_nan() || difference > 1e-3 * size)
}

// Casts of floats to integers on the CPU. A negative or too large number, or NaN, gives another integer on each device: debug builds refuse it
// on a device that checks.

/// An integer that a float can be cast to, if it is between two bounds.
pub trait Integer {
    /// Name of the type.
    const NAME: &'static str;
    /// Numbers above this one are not too small after their fraction is cut off.
    const ABOVE: f64;
    /// Numbers below this one are not too large.
    const BELOW: f64;
}

macro_rules! integers {
    ($($name:ident)*) => {$(
        impl Integer for $name {
            const NAME: &'static str = stringify!($name);
            const ABOVE: f64 = $name::MIN as f64 - 1.0;
            const BELOW: f64 = $name::MAX as f64 + 1.0;
        }
    )*};
}

integers!(u8 u16 u32 u64 usize i8 i16 i32 i64 isize);

/// Refuses an `f32` that no `I` is the integer of, and a negative number for a `usize`. Values of other types are fine.
#[inline(always)]
#[track_caller]
pub fn check_cast<I: Integer, T: Copy>(value: T) {
    if type_name::<T>() == type_name::<f32>() {
        // SAFETY: the types are the same
        let x = f64::from(unsafe { core::mem::transmute_copy::<T, f32>(&value) });
        if !(x > I::ABOVE && x < I::BELOW) {
            refuse(x, I::NAME);
        }
    } else if type_name::<T>() == type_name::<i32>() && I::NAME == "usize" {
        // SAFETY: the types are the same
        let x = unsafe { core::mem::transmute_copy::<T, i32>(&value) };
        check_usize(&(x as usize));
    }
}

/// Refuses a `usize` that a GPU has no bits for. Values of other types are fine.
#[inline(always)]
#[track_caller]
pub fn check_usize<T>(value: &T) {
    if type_name::<T>() == type_name::<usize>() {
        // SAFETY: the types are the same
        let x = unsafe { core::mem::transmute_copy::<T, usize>(value) };
        if u32::try_from(x).is_err() && is_checked() {
            panic!("makes a `usize` of {x}, which has 32 bits on a GPU: use `u32`");
        }
    }
}

/// Refuses NaN where an integer is made of a number.
#[inline(always)]
#[track_caller]
pub(crate) fn check_number(x: f32) {
    if x.is_nan() {
        refuse(x.into(), "integer");
    }
}

/// Refuses a number that has no finite real logarithm.
#[cfg(debug_assertions)]
#[inline(always)]
#[track_caller]
pub(crate) fn check_logarithm(x: f32) {
    if !(x >= 0.0 && x < f32::INFINITY) && is_checked() {
        panic!("takes the logarithm or a power of {x}, which is no finite number from 0 on");
    }
}

#[cold]
#[inline(never)]
#[track_caller]
fn refuse(x: f64, integer: &str) {
    if is_checked() {
        panic!("makes a `{integer}` of {x}: devices differ in what that is");
    }
}

/// Whether the invocation runs on a device that checks.
#[cold]
#[inline(never)]
fn is_checked() -> bool {
    running::current().is_some_and(|place| place.is_checked)
}
