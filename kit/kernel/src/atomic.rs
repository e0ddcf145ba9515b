//! Integer atomics. Rust-GPU's panic on the CPU, so each has a CPU twin here.

#[cfg(target_arch = "spirv")]
use spirv_std::arch::IndexUnchecked;
#[cfg(target_arch = "spirv")]
use spirv_std::memory::{Scope, Semantics};

#[cfg(not(target_arch = "spirv"))]
use core::sync::atomic::{AtomicU32, AtomicU64, Ordering};

#[cfg(not(target_arch = "spirv"))]
use crate::memory::Touch;
use crate::memory::Write;

/// The whole dispatch.
#[cfg(target_arch = "spirv")]
const SCOPE: u32 = Scope::QueueFamily as u32;
/// Nothing else is ordered.
#[cfg(target_arch = "spirv")]
const NO_ORDER: u32 = Semantics::NONE.bits();

/// Adds `value` at `index`; sums of integers do not depend on the order.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add(buffer: Write<u32>, index: u32, value: u32) {
    #[cfg(target_arch = "spirv")]
    // SAFETY: the CPU run checks the index
    unsafe {
        let at = buffer.index_unchecked_mut(index as usize);
        spirv_std::arch::atomic_i_add::<_, SCOPE, NO_ORDER>(at, value);
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        // SAFETY: the address is in range and aligned, and kernels touch a counter only through atomics
        unsafe { AtomicU32::from_ptr(buffer.address(index, Touch::Atomic)) }
            .fetch_add(value, Ordering::Relaxed);
    }
}

/// Raises what is at `index` to `value`; the largest of integers does not depend on the order.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn raise(buffer: Write<u32>, index: u32, value: u32) {
    #[cfg(target_arch = "spirv")]
    // SAFETY: the CPU run checks the index
    unsafe {
        let at = buffer.index_unchecked_mut(index as usize);
        spirv_std::arch::atomic_u_max::<_, SCOPE, NO_ORDER>(at, value);
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        // SAFETY: as in `add`
        let at = unsafe { AtomicU32::from_ptr(buffer.address(index, Touch::Atomic)) };
        // mostly there is nothing to do, and threads do not wait for each other
        if at.load(Ordering::Relaxed) < value {
            at.fetch_max(value, Ordering::Relaxed);
        }
    }
}

/// Adds to the 64-bit integer at `2 index` (low word) and `2 index + 1` (high word), modulo 2^64.
///
/// On the CPU it is a plain addition. So use it only in kernels with `z_serial`, and on integers that the workgroups of a
/// single z change.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add_wide(buffer: Write<u32>, index: u32, [low, high]: [u32; 2]) {
    #[cfg(target_arch = "spirv")]
    // SAFETY: the CPU run checks the index
    unsafe {
        let at = buffer.index_unchecked_mut(2 * index as usize);
        let before = spirv_std::arch::atomic_i_add::<_, SCOPE, NO_ORDER>(at, low);
        let carry = if before.wrapping_add(low) < low { 1 } else { 0 };
        let at = buffer.index_unchecked_mut(2 * index as usize + 1);
        spirv_std::arch::atomic_i_add::<_, SCOPE, NO_ORDER>(at, high.wrapping_add(carry));
    }
    #[cfg(not(target_arch = "spirv"))]
    add_wide_lanes(buffer, [index], [(u64::from(high) << 32 | u64::from(low)) as i64]);
}

/// As [`add_wide`], for several integers one after another.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn add_wide_lanes<const N: usize>(buffer: Write<u32>, index: [u32; N], value: [i64; N]) {
    let first = buffer.wide_addresses(index, Touch::Serial);
    let mut i = 0;
    while i < N {
        // SAFETY: the address is in range and aligned, and kernels touch such sums only through atomics
        let at = unsafe { AtomicU64::from_ptr(first.add(index[i] as usize)) };
        let sum = |words: u64| words.wrapping_add(value[i] as u64);
        let before = at.load(Ordering::Relaxed);
        // the low word comes first on every machine
        #[cfg(target_endian = "little")]
        at.store(sum(before), Ordering::Relaxed);
        #[cfg(target_endian = "big")]
        at.store(sum(before.rotate_left(32)).rotate_left(32), Ordering::Relaxed);
        i += 1;
    }
}

/// As [`add_wide_lanes`] for two integers each, the second one after the first.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn add_two_wide_lanes<const N: usize>(
    buffer: Write<u32>,
    index: [u32; N],
    [first, second]: [[i64; N]; 2],
) {
    #[cfg(target_endian = "big")]
    {
        add_wide_lanes(buffer, index, first);
        add_wide_lanes(buffer, index.map(|index| index + 1), second);
    }
    #[cfg(target_endian = "little")]
    {
        let begin = buffer.two_wide_addresses(index, Touch::Serial);
        let mut i = 0;
        while i < N {
            // SAFETY: the address is in range and aligned, and only the workgroups of one z change these sums: one thread
            let sums = unsafe { &mut *begin.add(index[i] as usize).cast::<[i64; 2]>() };
            *sums = [sums[0].wrapping_add(first[i]), sums[1].wrapping_add(second[i])];
            i += 1;
        }
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
