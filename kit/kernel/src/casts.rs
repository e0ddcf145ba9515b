//! Casts of floats to integers on the CPU, and logarithms. A negative or too large number, or NaN, gives another integer on each device:
//! debug builds refuse it on a device that checks.

use core::any::type_name;

use crate::running;

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
