//! Integer atomics.  Rust-GPU's own panic on the CPU, so each has its CPU twin here.

use crate::prelude::*;

/// Adds `value` at `index`; sums of integers do not depend on the order.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add(buffer: Write<u32>, index: u32, value: u32) {
    #[cfg(target_arch = "spirv")]
    {
        use spirv_std::arch::IndexUnchecked;
        use spirv_std::memory::{Scope, Semantics};
        // SAFETY: the CPU run checks the index
        unsafe {
            spirv_std::arch::atomic_i_add::<
                _,
                { Scope::QueueFamily as u32 },
                { Semantics::NONE.bits() },
            >(buffer.index_unchecked_mut(index as usize), value);
        }
    }
    #[cfg(not(target_arch = "spirv"))]
    {
        use crate::memory::Touch;
        use core::sync::atomic::{AtomicU32, Ordering};
        // SAFETY: the address is in range and aligned, and kernels touch a counter through atomics alone
        unsafe { AtomicU32::from_ptr(buffer.address(index, Touch::Atomic)) }
            .fetch_add(value, Ordering::Relaxed);
    }
}
