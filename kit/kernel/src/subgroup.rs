//! Subgroups: the invocations of a workgroup that a GPU runs in step, and that exchange values without memory.
//!
//! The device chooses how many they are: 4 to 128, a power of two. So a kernel takes any size, and says `subgroups`:
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin::prelude::*;
//!
//! /// Adds up the values of each workgroup.
//! #[kernel(threads(64), subgroups)]
//! pub fn total(id: Invocation, input: Read<u32>, output: Write<u32>, sum: Shared<u32, 1>) {
//!     if id.local.x == 0 {
//!         sum.write(0, 0);
//!     }
//!     id.barrier();
//!     let of_subgroup = id.subgroup_sum(input.read(id.index()));
//!     if id.subgroup_lane() == 0 {
//!         sum.atomic_add(0, of_subgroup);
//!     }
//!     id.barrier();
//!     if id.local.x == 0 {
//!         output.write(id.workgroup_index(), sum.read(0));
//!     }
//! }
//!
//! # fn main() {
//! let ones = [1; 64];
//! let mut output = [0];
//! for size in muslin::subgroup::SIZES {
//!     let sum = SharedMemory::new();
//!     let input = Read::from(&ones[..]);
//!     let view = Write::from(&mut output[..]);
//!     Workgroup::new([64, 1, 1]).subgroups(size).run(|id| total(id, input, view, sum.view()));
//!     assert_eq!(output, [64]);
//! }
//! # }
//! ```
//!
//! All invocations of a subgroup reach each operation, on the same path. They wait for each other there, but it is no barrier: what
//! they write to memory is not ordered. In the last subgroup of a workgroup, lanes can be missing. Workgroups lie along x, because only there
//! naga knows lanes:
//!
//! ```compile_fail,E0080
//! # extern crate muslin_kernel as muslin;
//! # use muslin::prelude::*;
//! #[kernel(threads(8, 8), subgroups)]
//! pub fn total(id: Invocation, output: Write<u32>) {
//!     output.write(id.index(), id.subgroup_sum(1));
//! }
//! # fn main() {}
//! ```

use glam::UVec4;
#[cfg(target_arch = "spirv")]
use spirv_std::arch;

use crate::invocation::Invocation;
#[cfg(not(target_arch = "spirv"))]
use crate::workgroup::{meet, subgroup_size as size};
#[cfg(not(target_arch = "spirv"))]
use operation::Operation;

#[cfg(not(target_arch = "spirv"))]
pub(crate) mod operation;

/// The sizes that the subgroups of a device can have.
pub const SIZES: [u32; 6] = [4, 8, 16, 32, 64, 128];

/// A number that subgroups exchange: `u32`, `i32` or `f32`. [`Invocation`] has the methods.
#[allow(missing_docs)]
pub trait SubgroupNumber: Copy {
    #[doc(hidden)]
    fn subgroup_sum(self) -> Self;
    #[doc(hidden)]
    fn subgroup_min(self) -> Self;
    #[doc(hidden)]
    fn subgroup_max(self) -> Self;
    #[doc(hidden)]
    fn subgroup_inclusive_sum(self) -> Self;
    #[doc(hidden)]
    fn subgroup_exclusive_sum(self) -> Self;
    #[doc(hidden)]
    fn subgroup_broadcast_first(self) -> Self;
    #[doc(hidden)]
    fn subgroup_shuffle(self, lane: u32) -> Self;
    #[doc(hidden)]
    fn subgroup_shuffle_xor(self, mask: u32) -> Self;
}

macro_rules! number {
    ($number:ident: $($function:ident($($operand:ident)?) is $on_gpu:ident, $operation:ident;)*) => {
        impl SubgroupNumber for $number {
            $(
                #[inline(always)]
                #[cfg_attr(not(target_arch = "spirv"), track_caller)]
                fn $function(self $(, $operand: u32)?) -> Self {
                    #[cfg(target_arch = "spirv")]
                    let result = arch::$on_gpu(self $(, $operand)?);
                    #[cfg(not(target_arch = "spirv"))]
                    let result = {
                        let given = [bytemuck::cast(self), $($operand,)?];
                        bytemuck::cast(meet(Operation::$operation, &given).x)
                    };
                    result
                }
            )*
        }
    };
}

number! { u32:
    subgroup_sum() is subgroup_i_add, Sum;
    subgroup_min() is subgroup_u_min, Min;
    subgroup_max() is subgroup_u_max, Max;
    subgroup_inclusive_sum() is subgroup_inclusive_i_add, InclusiveSum;
    subgroup_exclusive_sum() is subgroup_exclusive_i_add, ExclusiveSum;
    subgroup_broadcast_first() is subgroup_broadcast_first, First;
    subgroup_shuffle(lane) is subgroup_shuffle, Shuffle;
    subgroup_shuffle_xor(mask) is subgroup_shuffle_xor, ShuffleXor;
}

number! { i32:
    subgroup_sum() is subgroup_i_add, Sum;
    subgroup_min() is subgroup_s_min, SignedMin;
    subgroup_max() is subgroup_s_max, SignedMax;
    subgroup_inclusive_sum() is subgroup_inclusive_i_add, InclusiveSum;
    subgroup_exclusive_sum() is subgroup_exclusive_i_add, ExclusiveSum;
    subgroup_broadcast_first() is subgroup_broadcast_first, First;
    subgroup_shuffle(lane) is subgroup_shuffle, Shuffle;
    subgroup_shuffle_xor(mask) is subgroup_shuffle_xor, ShuffleXor;
}

number! { f32:
    subgroup_sum() is subgroup_f_add, FloatSum;
    subgroup_min() is subgroup_f_min, FloatMin;
    subgroup_max() is subgroup_f_max, FloatMax;
    subgroup_inclusive_sum() is subgroup_inclusive_f_add, InclusiveFloatSum;
    subgroup_exclusive_sum() is subgroup_exclusive_f_add, ExclusiveFloatSum;
    subgroup_broadcast_first() is subgroup_broadcast_first, First;
    subgroup_shuffle(lane) is subgroup_shuffle, Shuffle;
    subgroup_shuffle_xor(mask) is subgroup_shuffle_xor, ShuffleXor;
}

impl Invocation {
    /// Number of lanes of a subgroup, a power of two. In the last subgroup of a workgroup, some can be missing.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn subgroup_size(&self) -> u32 {
        #[cfg(target_arch = "spirv")]
        let size = self.subgroup.x;
        #[cfg(not(target_arch = "spirv"))]
        let size = size();
        size
    }

    /// The invocation's lane: its position in its subgroup.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn subgroup_lane(&self) -> u32 {
        #[cfg(target_arch = "spirv")]
        let lane = self.subgroup.y;
        #[cfg(not(target_arch = "spirv"))]
        let lane = self.local_index() % size();
        lane
    }

    /// In which of the subgroup's lanes `is_set` is true: lane `i` is bit `i % 32` of component `i / 32`. [`lanes`] and [`lanes_before`]
    /// count them.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn subgroup_ballot(&self, is_set: bool) -> UVec4 {
        #[cfg(target_arch = "spirv")]
        let ballot = arch::subgroup_ballot(is_set);
        #[cfg(not(target_arch = "spirv"))]
        let ballot = meet(Operation::Ballot, &[is_set.into()]);
        ballot
    }
}

impl Invocation {
    /// Whether it is true in any of the subgroup's lanes.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn subgroup_any(&self, is: bool) -> bool {
        self.subgroup_ballot(is) != UVec4::ZERO
    }

    /// Whether it is true in all of the subgroup's lanes.
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn subgroup_all(&self, is: bool) -> bool {
        self.subgroup_ballot(!is) == UVec4::ZERO
    }
}

/// Methods that combine the bits of each lane.
macro_rules! bitwise {
    ($($(#[$doc:meta])* $function:ident is $on_gpu:ident, $operation:ident;)*) => {
        impl Invocation {$(
            $(#[$doc])*
            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            pub fn $function(&self, bits: u32) -> u32 {
                #[cfg(target_arch = "spirv")]
                let result = arch::$on_gpu(bits);
                #[cfg(not(target_arch = "spirv"))]
                let result = meet(Operation::$operation, &[bits]).x;
                result
            }
        )*}
    };
}

bitwise! {
    /// The bits that all lanes have.
    subgroup_and is subgroup_and, And;
    /// The bits that any lane has.
    subgroup_or is subgroup_or, Or;
    /// The bits that an odd number of lanes has.
    subgroup_xor is subgroup_xor, Xor;
}

/// Methods that combine a value of each lane.
macro_rules! operations {
    ($($(#[$doc:meta])* $function:ident($($operand:ident)?);)*) => {
        impl Invocation {$(
            $(#[$doc])*
            #[inline(always)]
            #[cfg_attr(not(target_arch = "spirv"), track_caller)]
            pub fn $function<T: SubgroupNumber>(&self, value: T $(, $operand: u32)?) -> T {
                value.$function($($operand)?)
            }
        )*}
    };
}

operations! {
    /// The sum of the subgroup's values: of integers modulo 2^32, of `f32` in an order that the device chooses.
    subgroup_sum();
    /// The smallest of the subgroup's values. None of them is NaN.
    subgroup_min();
    /// The largest of the subgroup's values. None of them is NaN.
    subgroup_max();
    /// The sum of the values of this lane and of those before it: an inclusive scan. Modulo 2^32 of integers, of `f32` in an order that the
    /// device chooses.
    subgroup_inclusive_sum();
    /// The sum of the values of the lanes before this one, 0 in the first: an exclusive scan. Modulo 2^32 of integers, of `f32` in an order
    /// that the device chooses.
    subgroup_exclusive_sum();
    /// The value that `lane` gives. Each lane can ask for another one, and that is in the subgroup.
    subgroup_shuffle(lane);
    /// The value that the lane `subgroup_lane() ^ mask` gives. It is in the subgroup.
    subgroup_shuffle_xor(mask);
    /// The value of the subgroup's first lane.
    subgroup_broadcast_first();
}

/// Number of lanes in a ballot.
#[inline(always)]
pub fn lanes(ballot: UVec4) -> u32 {
    ballot.x.count_ones() + ballot.y.count_ones() + ballot.z.count_ones() + ballot.w.count_ones()
}

/// Number of lanes in a ballot that come before a lane, itself not included.
#[inline(always)]
pub fn lanes_before(ballot: UVec4, lane: u32) -> u32 {
    let below = (1 << (lane % 32)) - 1;
    let word = lane / 32;
    // all bits of the words before its own
    let mask = |of: u32| {
        if of == word {
            below
        } else if of < word {
            !0
        } else {
            0
        }
    };
    lanes(ballot & UVec4::new(mask(0), mask(1), mask(2), mask(3)))
}
