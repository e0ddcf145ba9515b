//! Arithmetic on the CPU, for the runs that look for what depends on the device: fused and regrouped operations.

use core::any::type_name;
use core::panic::Location;

use crate::lane::Wide;
use crate::running;
use crate::scalar::TINY;

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
