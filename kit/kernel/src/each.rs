//! `for` loops over arrays: the iterators of core take pointers apart, which no GPU can. `#[kernel]` and `#[loops]` write such a loop
//! with an index.

use core::ops::Range;

/// What a `for` loop of a kernel takes that is neither a literal range nor an iterator: an array, a reference to one, or a variable
/// with a range.
#[diagnostic::on_unimplemented(
    message = "a `for` loop of a kernel cannot take a `{Self}`",
    label = "write a range, `0..n`, or take an array"
)]
pub trait Each {
    /// What a round gets.
    type Item;
    /// Number of rounds.
    fn rounds(&self) -> u32;
    /// What the round `index` gets, which is below `rounds`.
    fn at(&self, index: u32) -> Self::Item;
}

/// An element of an array.
#[inline(always)]
fn element<T, const N: usize>(array: &[T; N], index: u32) -> &T {
    // a check of the index would be an exit of the loop
    #[cfg(target_arch = "spirv")]
    {
        // SAFETY: it is below N
        unsafe { spirv_std::arch::IndexUnchecked::index_unchecked(array, index as usize) }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        &array[index as usize]
    }
}

impl<T: Copy, const N: usize> Each for [T; N] {
    type Item = T;

    #[inline(always)]
    fn rounds(&self) -> u32 {
        N as u32
    }

    #[inline(always)]
    fn at(&self, index: u32) -> T {
        *element(self, index)
    }
}

impl<'a, T, const N: usize> Each for &'a [T; N] {
    type Item = &'a T;

    #[inline(always)]
    fn rounds(&self) -> u32 {
        N as u32
    }

    #[inline(always)]
    fn at(&self, index: u32) -> &'a T {
        element(self, index)
    }
}

macro_rules! ranges {
    ($($integer:ident)*) => {$(
        impl Each for Range<$integer> {
            type Item = $integer;

            #[inline(always)]
            fn rounds(&self) -> u32 {
                if self.start < self.end { self.end.wrapping_sub(self.start) as u32 } else { 0 }
            }

            #[inline(always)]
            fn at(&self, index: u32) -> $integer {
                self.start.wrapping_add(index as $integer)
            }
        }
    )*};
}

ranges!(u32 i32 usize);
