//! Fused and regrouped arithmetic on the CPU, for the runs that look for what depends on it.

use core::any::type_name;
use core::panic::Location;

use crate::lane::Wide;
use crate::running;

/// Most floats of a value.
const MOST: usize = 4;

/// The floats of a value, and their number; none of what has no floats, or is not known.
fn floats<T: Copy>(value: &T) -> ([f32; MOST], usize) {
    let name = type_name::<T>();
    let count = match size_of::<T>() / size_of::<f32>() {
        _ if name == type_name::<f32>() || name == type_name::<Wide<1, false>>() => 1,
        count @ 2..=MOST if name.starts_with("glam::f32::") && name.contains("::Vec") => count,
        _ => 0,
    };
    let mut floats = [0.0; MOST];
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

/// A term of a sum, or a factor of a product.
#[derive(Clone, Copy)]
pub struct Term {
    floats: [f32; MOST],
    count: usize,
    is_inverse: bool,
}

impl Term {
    /// A term that is subtracted, or a factor that divides, if it `is_inverse`.
    #[inline]
    pub fn new<T: Copy>(value: T, is_inverse: bool) -> Self {
        let (mut floats, mut count) = floats(&value);
        // a literal whose type nothing decides
        if type_name::<T>() == type_name::<f64>() {
            // SAFETY: the types are the same
            floats[0] = unsafe { core::mem::transmute_copy::<T, f64>(&value) } as f32;
            count = 1;
        }
        Self { floats, count, is_inverse }
    }

    fn at(&self, i: usize) -> f32 {
        self.floats[if self.count == 1 { 0 } else { i }]
    }
}

/// How far a regrouped number may be from what is written before its place is noted, as a part of the larger of both.
pub const FAR: f32 = 1e-3;

/// The sum or product of floats as a driver may regroup it: a sum with one rounding, as if what cancels were gone, and a product with the
/// factors behind the first one together; otherwise `plain`, which is as it is written. Notes where they are far apart.
#[track_caller]
pub fn regrouped<O: Copy>(mut plain: O, terms: &[Term], is_sum: bool) -> O {
    let (written, count) = floats(&plain);
    if count == 0 || terms.iter().any(|term| term.count != count && term.count != 1) {
        return plain;
    }
    let mut values = written;
    for (i, value) in values.iter_mut().enumerate().take(count) {
        *value = match (is_sum, terms) {
            (false, [first, rest @ ..]) => {
                let product = |is_inverse| -> f32 {
                    rest.iter().filter(|t| t.is_inverse == is_inverse).map(|t| t.at(i)).product()
                };
                first.at(i) * (product(false) / product(true))
            }
            _ => {
                let signed = |term: &Term| {
                    let x = f64::from(term.at(i));
                    if term.is_inverse { -x } else { x }
                };
                terms.iter().map(signed).sum::<f64>() as f32
            }
        };
        if is_far(*value, written[i]) {
            running::note_regrouped(Location::caller());
        }
    }
    // SAFETY: the floats of `plain`, in their place
    unsafe { core::ptr::copy_nonoverlapping(values.as_ptr(), (&raw mut plain).cast(), count) };
    plain
}

/// Whether two numbers differ by more than roundings of theirs.
pub fn is_far(a: f32, b: f32) -> bool {
    let size = a.abs().max(b.abs());
    a.to_bits() != b.to_bits() && (a.is_finite() != b.is_finite() || !((a - b).abs() <= FAR * size))
}
