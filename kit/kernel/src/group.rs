//! Subgroups: the invocations of a workgroup that a GPU runs in step, and that see each other's values.
//!
//! A kernel with a parameter `group: impl Group` has two entry points of one body.  In the plain one, and on the CPU, the
//! group is [`Alone`]: workgroup memory and atomics.  In the one named `_subgroups` it is a subgroup, of whatever
//! size the GPU has.  Both give the same integers.

use crate::atomic;
use crate::prelude::*;

/// The most invocations of a workgroup that [`Group::inclusive_sum`] adds up.
pub const THREADS: u32 = 64;

/// Invocations that work together.
pub trait Group: Copy {
    /// Raises what is at `index` to `value`, the same index for all invocations: see [`atomic::raise`].
    fn raise(self, buffer: Write<u32>, index: u32, value: u32);

    /// The invocation's number in the workgroup, in the order of [`Group::inclusive_sum`].  All invocations of the
    /// workgroup ask for it.
    fn number(self, id: Invocation, sums: Shared<u32, 64>) -> u32;

    /// The sum of the values of all invocations up to this one, in the order of `number`.  All invocations of the workgroup
    /// ask for it.
    fn inclusive_sum(self, id: Invocation, number: u32, value: u32, sums: Shared<u32, 64>) -> u32;
}

/// Each invocation on its own.
#[derive(Clone, Copy)]
pub struct Alone;

impl Group for Alone {
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn raise(self, buffer: Write<u32>, index: u32, value: u32) {
        atomic::raise(buffer, index, value);
    }

    #[inline(always)]
    fn number(self, id: Invocation, _: Shared<u32, 64>) -> u32 {
        id.local.x
    }

    /// Hillis and Steele's.
    #[inline(always)]
    fn inclusive_sum(self, id: Invocation, number: u32, value: u32, sums: Shared<u32, 64>) -> u32 {
        let mut inclusive = value;
        sums.write(number, inclusive);
        id.barrier();
        let mut step = 1;
        while step < THREADS {
            if number >= step {
                inclusive += sums.read(number - step);
            }
            id.barrier();
            sums.write(number, inclusive);
            id.barrier();
            step *= 2;
        }
        inclusive
    }
}

/// A subgroup.
///
/// Which invocations of a workgroup are in one, and in which order, is the GPU's: nothing here takes it for granted.
#[cfg(target_arch = "spirv")]
#[derive(Clone, Copy)]
pub struct Subgroup {
    /// Its number in the workgroup.
    pub number: u32,
}

#[cfg(target_arch = "spirv")]
impl Subgroup {
    /// The sum of the values of all subgroups before this one.
    #[inline(always)]
    fn sum_before(self, id: Invocation, value: u32, sums: Shared<u32, 64>) -> u32 {
        let total = subgroup_i_add(value);
        // until nobody reads an earlier sum any more
        id.barrier();
        if is_first() {
            sums.write(self.number, total);
        }
        id.barrier();
        let mut before = 0;
        let mut other = 0;
        while other < self.number {
            before += sums.read(other);
            other += 1;
        }
        before
    }
}

#[cfg(target_arch = "spirv")]
use spirv_std::arch::{
    subgroup_exclusive_i_add, subgroup_i_add, subgroup_inclusive_i_add, subgroup_u_max,
};

/// Whether the invocation is the first one of its subgroup that is here.  Not `subgroup_elect`, which naga does not read.
#[cfg(target_arch = "spirv")]
#[inline(always)]
fn is_first() -> bool {
    subgroup_exclusive_i_add(1u32) == 0
}

#[cfg(target_arch = "spirv")]
impl Group for Subgroup {
    #[inline(always)]
    fn raise(self, buffer: Write<u32>, index: u32, value: u32) {
        let largest = subgroup_u_max(value);
        if is_first() {
            atomic::raise(buffer, index, largest);
        }
    }

    #[inline(always)]
    fn number(self, id: Invocation, sums: Shared<u32, 64>) -> u32 {
        self.sum_before(id, 1, sums) + subgroup_exclusive_i_add(1u32)
    }

    #[inline(always)]
    fn inclusive_sum(self, id: Invocation, _: u32, value: u32, sums: Shared<u32, 64>) -> u32 {
        self.sum_before(id, value, sums) + subgroup_inclusive_i_add(value)
    }
}
