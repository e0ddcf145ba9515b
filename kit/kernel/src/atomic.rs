//! Integer atomics, on storage buffers and workgroup memory of `u32` and `i32`. All return the old value.
//!
//! | method of `Write` and `Shared` | new value of the element | |
//! | --- | --- | --- |
//! | `atomic_add(index, value)` | the sum, modulo 2^32 | does not depend on the order |
//! | `atomic_min(index, value)`, `atomic_max(index, value)` | the smaller, the larger | does not depend on the order |
//! | `atomic_and(index, value)`, `atomic_or(index, value)`, `atomic_xor(index, value)` | the bitwise result | does not depend on the order |
//! | `atomic_exchange(index, value)` | `value` | |
//! | `atomic_compare_exchange(index, expected, value)` | `value`, if it was `expected` | |
//! | `atomic_load(index)` | unchanged | |
//! | `atomic_store(index, value)` | `value`; returns nothing | |
//!
//! Where the table says so, the resulting element does not depend on the order of the invocations. The *returned*
//! value always does. Use it as a ticket (for a free slot), and not as a number that is part of the result.
//!
//! `atomic_compare_exchange` has stored `value` where it returns `expected`. On Metal, and in browsers on it, there is only a weak one, which may rarely leave
//! the element as it is: where one loss is too many, a flag by `atomic_exchange` or `atomic_max` is safer.
//!
//! Atomics order nothing else. Between a write and another invocation's read there must be a barrier, or a new
//! dispatch. Until then, if one invocation changes an element atomically, no other may read or write it plainly. The
//! CPU run reports that.
//!
//! [`add`] and [`raise`] are functions for the two most common atomics. [`add_wide`] adds to 64-bit integers.
//! Rust-GPU's own atomics panic on the CPU.

#[cfg(target_arch = "spirv")]
use spirv_std::arch::IndexUnchecked;
#[cfg(target_arch = "spirv")]
use spirv_std::memory::{Scope, Semantics};

#[cfg(not(target_arch = "spirv"))]
use core::sync::atomic::{AtomicI32, AtomicU32, AtomicU64, Ordering};

#[cfg(not(target_arch = "spirv"))]
use crate::memory::Shared;
#[cfg(not(target_arch = "spirv"))]
use crate::memory::Touch;
use crate::memory::Write;

/// The whole dispatch takes part.
#[cfg(target_arch = "spirv")]
const SCOPE: u32 = Scope::QueueFamily as u32;
/// Nothing else is ordered.
#[cfg(target_arch = "spirv")]
const NO_ORDER: u32 = Semantics::NONE.bits();

/// The atomics of a buffer, or of an array in workgroup memory: see the [module](self).
#[cfg(target_arch = "spirv")]
#[allow(missing_docs)]
pub trait AtomicBuffer<T> {
    fn atomic_add(&mut self, index: u32, value: T) -> T;
    fn atomic_min(&mut self, index: u32, value: T) -> T;
    fn atomic_max(&mut self, index: u32, value: T) -> T;
    fn atomic_and(&mut self, index: u32, value: T) -> T;
    fn atomic_or(&mut self, index: u32, value: T) -> T;
    fn atomic_xor(&mut self, index: u32, value: T) -> T;
    fn atomic_exchange(&mut self, index: u32, value: T) -> T;
    fn atomic_compare_exchange(&mut self, index: u32, expected: T, value: T) -> T;
    fn atomic_load(&mut self, index: u32) -> T;
    fn atomic_store(&mut self, index: u32, value: T);
}

/// The atomics of a GPU.
#[cfg(target_arch = "spirv")]
macro_rules! device_atomics {
    ([$($generics:tt)*] $buffer:ty, $element:ty, $min:ident, $max:ident) => {
        impl<$($generics)*> AtomicBuffer<$element> for $buffer {
            device_atomics!(method $element, atomic_add, atomic_i_add);
            device_atomics!(method $element, atomic_min, $min);
            device_atomics!(method $element, atomic_max, $max);
            device_atomics!(method $element, atomic_and, atomic_and);
            device_atomics!(method $element, atomic_or, atomic_or);
            device_atomics!(method $element, atomic_xor, atomic_xor);
            device_atomics!(method $element, atomic_exchange, atomic_exchange);

            #[inline(always)]
            fn atomic_compare_exchange(&mut self, index: u32, expected: $element, value: $element) -> $element {
                // SAFETY: the CPU run checks the index
                unsafe {
                    let at = self.index_unchecked_mut(index as usize);
                    spirv_std::arch::atomic_compare_exchange::<_, SCOPE, NO_ORDER, NO_ORDER>(at, value, expected)
                }
            }

            #[inline(always)]
            fn atomic_load(&mut self, index: u32) -> $element {
                // SAFETY: the CPU run checks the index
                unsafe {
                    let at = self.index_unchecked_mut(index as usize);
                    spirv_std::arch::atomic_load::<_, SCOPE, NO_ORDER>(at)
                }
            }

            #[inline(always)]
            fn atomic_store(&mut self, index: u32, value: $element) {
                // SAFETY: the CPU run checks the index
                unsafe {
                    let at = self.index_unchecked_mut(index as usize);
                    spirv_std::arch::atomic_store::<_, SCOPE, NO_ORDER>(at, value);
                }
            }
        }
    };
    (method $element:ty, $name:ident, $operation:ident) => {
        #[inline(always)]
        fn $name(&mut self, index: u32, value: $element) -> $element {
            // SAFETY: the CPU run checks the index
            unsafe {
                let at = self.index_unchecked_mut(index as usize);
                spirv_std::arch::$operation::<_, SCOPE, NO_ORDER>(at, value)
            }
        }
    };
}

#[cfg(target_arch = "spirv")]
device_atomics!([][u32], u32, atomic_u_min, atomic_u_max);
#[cfg(target_arch = "spirv")]
device_atomics!([][i32], i32, atomic_s_min, atomic_s_max);
#[cfg(target_arch = "spirv")]
device_atomics!([const N: usize] [u32; N], u32, atomic_u_min, atomic_u_max);
#[cfg(target_arch = "spirv")]
device_atomics!([const N: usize] [i32; N], i32, atomic_s_min, atomic_s_max);

/// The atomics of the CPU. `$view` is the buffer of a `self`.
#[cfg(not(target_arch = "spirv"))]
macro_rules! host_atomics {
    ([$($generics:tt)*] $buffer:ty, $element:ty, $atomic:ty, $self:ident => $view:expr) => {
        impl<$($generics)*> $buffer {
            host_atomics!(method $element, $atomic, $self => $view, atomic_add, fetch_add, "Adds `value` at `index`, modulo 2^32.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_min, fetch_min, "Lowers what is at `index` to `value`.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_max, fetch_max, "Raises what is at `index` to `value`.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_and, fetch_and, "Keeps the bits of `value` at `index`.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_or, fetch_or, "Sets the bits of `value` at `index`.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_xor, fetch_xor, "Flips the bits of `value` at `index`.");
            host_atomics!(method $element, $atomic, $self => $view, atomic_exchange, swap, "Stores `value` at `index`.");

            /// Stores `value` at `index` if `expected` is there. Returns the old value. Panics if `index` is out of
            /// range.
            #[inline(always)]
            #[track_caller]
            pub fn atomic_compare_exchange(&$self, index: u32, expected: $element, value: $element) -> $element {
                let order = Ordering::Relaxed;
                let at = $view.address(index, Touch::Atomic);
                // SAFETY: as in the others
                let result = unsafe { <$atomic>::from_ptr(at) }.compare_exchange(expected, value, order, order);
                result.unwrap_or_else(|found| found)
            }

            /// The value at `index`. Panics if `index` is out of range.
            #[inline(always)]
            #[track_caller]
            pub fn atomic_load(&$self, index: u32) -> $element {
                // SAFETY: as in the others
                unsafe { <$atomic>::from_ptr($view.address(index, Touch::Atomic)) }.load(Ordering::Relaxed)
            }

            /// Stores `value` at `index`. Panics if `index` is out of range.
            #[inline(always)]
            #[track_caller]
            pub fn atomic_store(&$self, index: u32, value: $element) {
                // SAFETY: as in the others
                unsafe { <$atomic>::from_ptr($view.address(index, Touch::Store)) }.store(value, Ordering::Relaxed);
            }
        }
    };
    (method $element:ty, $atomic:ty, $self:ident => $view:expr, $name:ident, $operation:ident, $doc:literal) => {
        #[doc = $doc]
        /// Returns the old value. Panics if `index` is out of range.
        #[inline(always)]
        #[track_caller]
        pub fn $name(&$self, index: u32, value: $element) -> $element {
            // SAFETY: the address is in range and aligned. Kernels touch such an element only through atomics, which
            // the CPU run with `check_races` checks.
            unsafe { <$atomic>::from_ptr($view.address(index, Touch::Atomic)) }.$operation(value, Ordering::Relaxed)
        }
    };
}

#[cfg(not(target_arch = "spirv"))]
host_atomics!(['a] Write<'a, u32>, u32, AtomicU32, self => self);
#[cfg(not(target_arch = "spirv"))]
host_atomics!(['a] Write<'a, i32>, i32, AtomicI32, self => self);
#[cfg(not(target_arch = "spirv"))]
host_atomics!(['a, const N: usize] Shared<'a, u32, N>, u32, AtomicU32, self => self.0);
#[cfg(not(target_arch = "spirv"))]
host_atomics!(['a, const N: usize] Shared<'a, i32, N>, i32, AtomicI32, self => self.0);

/// Adds `value` at `index`, and returns the old value. Sums of integers do not depend on the order.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add(buffer: Write<u32>, index: u32, value: u32) -> u32 {
    buffer.atomic_add(index, value)
}

/// Raises the value at `index` to at least `value`, and returns the old value. The maximum does not depend on the
/// order.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn raise(buffer: Write<u32>, index: u32, value: u32) -> u32 {
    #[cfg(target_arch = "spirv")]
    return buffer.atomic_max(index, value);
    #[cfg(not(target_arch = "spirv"))]
    {
        // SAFETY: as in the methods
        let at = unsafe { AtomicU32::from_ptr(buffer.address(index, Touch::Atomic)) };
        // usually there is nothing to do, and then threads do not wait for each other
        let found = at.load(Ordering::Relaxed);
        if found < value { at.fetch_max(value, Ordering::Relaxed) } else { found }
    }
}

/// What a buffer of 64-bit integers is made of: words, the low one first, or whole integers in the variant for GPUs that add
/// them at once. The bytes are the same.
pub trait SumWord: Copy {
    /// Adds to the integer at `index`, atomically.
    #[cfg(target_arch = "spirv")]
    fn add(sums: Write<Self>, index: u32, words: [u32; 2]);
    /// The same buffer, of words.
    #[cfg(not(target_arch = "spirv"))]
    fn words(sums: Write<Self>) -> Write<u32>;
}

impl SumWord for u32 {
    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    fn add(sums: Write<u32>, index: u32, words: [u32; 2]) {
        add_halves(sums, index, words);
    }

    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    fn words(sums: Write<u32>) -> Write<u32> {
        sums
    }
}

#[cfg(target_arch = "spirv")]
impl SumWord for u64 {
    #[inline(always)]
    fn add(sums: Write<u64>, index: u32, [low, high]: [u32; 2]) {
        // SAFETY: the CPU run checks the index
        unsafe {
            let at = sums.index_unchecked_mut(index as usize);
            let value = (high as u64) << 32 | low as u64;
            spirv_std::arch::atomic_i_add::<_, SCOPE, NO_ORDER>(at, value);
        }
    }
}

/// Adds to the 64-bit integer at `2 index` (low word) and `2 index + 1` (high word), modulo 2^64.
///
/// On the CPU it is a plain addition. So use it only in kernels with `z_serial`, and on integers that the workgroups of a
/// single z change.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add_wide(buffer: Write<impl SumWord>, index: u32, [low, high]: [u32; 2]) {
    #[cfg(target_arch = "spirv")]
    SumWord::add(buffer, index, [low, high]);
    #[cfg(not(target_arch = "spirv"))]
    add_wide_lanes(
        SumWord::words(buffer),
        [index],
        [(u64::from(high) << 32 | u64::from(low)) as i64],
    );
}

/// Like [`add_wide`], for integers that any workgroup may change: it is atomic on the CPU, too.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add_wide_shared(buffer: Write<impl SumWord>, index: u32, [low, high]: [u32; 2]) {
    #[cfg(target_arch = "spirv")]
    SumWord::add(buffer, index, [low, high]);
    #[cfg(not(target_arch = "spirv"))]
    {
        let at = SumWord::words(buffer).wide_addresses([index], Touch::Atomic);
        // SAFETY: the address is in range and aligned, and kernels touch such sums only through atomics
        let at = unsafe { AtomicU64::from_ptr(at.add(index as usize)) };
        at.fetch_add(u64::from(high) << 32 | u64::from(low), Ordering::Relaxed);
    }
}

/// Adds the words one after the other: who takes the low one past 2^32 carries.
#[cfg(target_arch = "spirv")]
#[inline(always)]
fn add_halves(buffer: Write<u32>, index: u32, [low, high]: [u32; 2]) {
    let before = add(buffer, 2 * index, low);
    let carry = if before.wrapping_add(low) < low { 1 } else { 0 };
    let high = high.wrapping_add(carry);
    if high != 0 {
        add(buffer, 2 * index + 1, high);
    }
}

/// Like [`add_wide`], for several integers one after another.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn add_wide_lanes<const N: usize>(buffer: Write<u32>, index: [u32; N], value: [i64; N]) {
    let first = buffer.wide_addresses(index, Touch::Serial);
    let mut i = 0;
    while i < N {
        // SAFETY: the address is in range and aligned, and kernels touch such sums only through atomics
        let at = unsafe { AtomicU64::from_ptr(first.add(index[i] as usize)) };
        let before = at.load(Ordering::Relaxed);
        at.store(before.wrapping_add(value[i] as u64), Ordering::Relaxed);
        i += 1;
    }
}

/// Like [`add_wide_lanes`], for two consecutive integers each at several places of each lane.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn add_two_wide_lanes<const N: usize, const M: usize>(
    buffer: Write<u32>,
    index: [[u32; N]; M],
    values: [[[i64; 2]; N]; M],
) {
    let begin = buffer.two_wide_addresses(index, Touch::Serial);
    // Without this, the compiler would convert the values of each lane by themselves.
    let values = core::hint::black_box(&values);
    let index = core::hint::black_box(&index);
    let mut lane = 0;
    // Lanes next to each other often add to the same places: between two sums of a place, there are others.
    while lane < N {
        let mut i = 0;
        while i < M {
            let at = index[i][lane] as usize;
            // SAFETY: the address is in range and aligned, and only the workgroups of one z change these sums: one thread
            let sums = unsafe { &mut *begin.add(at).cast::<[i64; 2]>() };
            let [first, second] = values[i][lane];
            *sums = [sums[0].wrapping_add(first), sums[1].wrapping_add(second)];
            i += 1;
        }
        lane += 1;
    }
}

/// Sets the flags at several indices to 1, if the mask is set.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn flag_lanes<const N: usize>(flags: Write<u32>, mask: [bool; N], index: [u32; N]) {
    let all = mask.iter().fold(true, |all, &mask| all & mask);
    let first = flags.addresses_of(index, Touch::Atomic);
    let mut i = 0;
    while i < N {
        if all || mask[i] {
            // SAFETY: the address is in range and aligned, and kernels touch flags only through atomics
            unsafe { AtomicU32::from_ptr(first.add(index[i] as usize)) }
                .store(1, Ordering::Relaxed);
        }
        i += 1;
    }
}
