//! Lanes: several invocations at once, as SIMD on the CPU.
//!
//! A kernel declared with `lanes(samples)` is generic over [`Lane`]. A GPU runs it with `f32`: an invocation already
//! is a lane. The CPU runs it with [`Wide`]: as many invocations along x at once as its registers hold. The rest runs
//! with one lane of the same arithmetic, so no result depends on the end of a group of lanes. A workgroup with barriers runs with one kind of
//! lanes as a whole.
//!
//! With plain `lanes`, the CPU makes one call per invocation, which uses the lanes for a loop of its own, and
//! [`Lane::One`] for the loop's rest. [`Lane::sum`] has another order for each width, so such a kernel can round
//! differently with another instruction set.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Sub};

#[cfg(target_arch = "spirv")]
use spirv_std::num_traits::Float;

#[cfg(target_arch = "spirv")]
use crate::atomic::AtomicBuffer;
use crate::atomic::{self, SumWord};
use crate::fixed;
use crate::half::normal_half_value;
use crate::memory::{Read, Shared, Write};
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};

#[cfg(not(target_arch = "spirv"))]
pub use wide::{Wide, WideIndex, WideMask};

#[cfg(not(target_arch = "spirv"))]
mod wide;

/// Largest number of lanes in a [`Lane`]: workgroups are multiples of it.
pub const MAX_WIDTH: u32 = 16;

/// One `f32` for each of several invocations.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Number of lanes.
    const WIDTH: u32;
    /// Whether adding two values to [fixed-point](crate::fixed) sums at once is faster than one after the other.
    const ADDS_TWO: bool;
    /// Whether four consecutive values are read as fast as one: on a GPU, where they begin at a multiple of four.
    const READS_FOUR: bool;
    /// Whether two consecutive values at arbitrary indices are read faster at once.
    const GATHERS_TWO: bool;
    /// One lane of the same arithmetic.
    type One: Lane;
    /// One `bool` for each lane.
    type Mask: Copy;
    /// One `u32` for each lane.
    type Index: LaneIndex<Mask = Self::Mask>;

    /// The same value in every lane.
    fn splat(value: f32) -> Self;
    /// 0, 1, 2, ...
    fn ramp() -> Self;
    /// `self * a + b`, with one rounding if the hardware has that: for kernels that are `fused`.
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// The smaller of two values.
    fn min(self, other: Self) -> Self;
    /// The larger of two values.
    fn max(self, other: Self) -> Self;
    /// `self < other`
    fn less(self, other: Self) -> Self::Mask;
    /// `self <= other`
    fn less_equal(self, other: Self) -> Self::Mask;
    /// `yes` in lanes where the mask holds, `no` in others.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The lanes in which both masks hold.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Whether a mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// Square root.
    fn sqrt(self) -> Self;
    /// e^x; on the CPU to 1.5 ulp, and 0 below the smallest normal number.
    fn exp(self) -> Self;
    /// The value without its fraction: see [`math::truncate`](crate::math::truncate).
    fn truncate(self) -> Self;
    /// The value without its fraction as an integer, for values from 0 to 2^31.
    fn index(self) -> Self::Index;
    /// The same value. On the CPU it goes through memory. So the compiler keeps a sum in one register until then, and
    /// does not split it for the sum of all lanes.
    fn materialize(self) -> Self;
    /// The sum of all lanes, as a tree of pairs: always in the same order.
    fn sum(self) -> f32;
    /// The value of a lane.
    fn lane(self, lane: u32) -> f32;
    /// Reads consecutive values, starting at `first`.
    fn read(buffer: Read<f32>, first: u32) -> Self;
    /// Reads consecutive values, starting at `first`, from a buffer that is also written.
    fn read_written(buffer: Write<f32>, first: u32) -> Self;
    /// Reads consecutive values, starting at `first`. Those at `end` and behind are not read: they are 0.
    fn read_below(buffer: Read<f32>, first: u32, end: u32) -> Self;
    /// Reads consecutive values of workgroup memory, starting at `first`.
    fn read_shared<const LEN: usize>(values: Shared<f32, LEN>, first: u32) -> Self;
    /// Reads values at arbitrary indices.
    fn gather(buffer: Read<f32>, at: Self::Index) -> Self;
    /// Reads values of workgroup memory at arbitrary indices.
    fn gather_shared<const LEN: usize>(values: Shared<f32, LEN>, at: Self::Index) -> Self;
    /// Reads two consecutive values each at arbitrary indices.
    fn gather_two(buffer: Read<f32>, at: Self::Index) -> [Self; 2];
    /// Reads words at arbitrary indices, each with two [16-bit floats](crate::half::normal_half_value), the lower one first.
    fn gather_halves(buffer: Read<u32>, at: Self::Index) -> [Self; 2];
    /// Stores consecutive values, starting at `first`.
    fn write(self, buffer: Write<f32>, first: u32);
    /// Stores consecutive values in workgroup memory, starting at `first`.
    fn write_shared<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32);
    /// Like [`Lane::write_shared`], but for what would lie at `end` or behind.
    fn write_shared_below<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32, end: u32);
    /// Adds the values to the [fixed-point](crate::fixed) sums at `at`, in lanes where the mask holds: see
    /// [`atomic::add_wide`].
    fn add_fixed(self, mask: Self::Mask, sum: Write<impl SumWord>, at: Self::Index);
    /// Like [`Lane::add_fixed`], for two consecutive values each at several places.
    fn add_fixed_two<const M: usize>(
        values: [[Self; 2]; M],
        mask: Self::Mask,
        sum: Write<impl SumWord>,
        at: [Self::Index; M],
    );
    /// Hints that the fixed-point sums at `at` are about to be changed.
    fn expect_fixed(sum: Write<impl SumWord>, at: Self::Index);
    /// Takes consecutive fixed-point sums, starting at `first`, and leaves zeros.
    fn take_fixed(sum: Write<u32>, first: u32) -> Self;
    /// In lanes where the mask holds, sets the flag of the block of `block` elements that contains the element `at`.
    fn flag(mask: Self::Mask, flags: Write<u32>, at: Self::Index, block: u32);
    /// Whether the flag of such a block is known to be set. A CPU does not look: it sets one as fast.
    fn is_flagged(flags: Write<u32>, at: Self::Index, block: u32) -> bool;
}

/// One `u32` for each of several invocations.
pub trait LaneIndex: Copy + BitXor<Output = Self> + BitAnd<Output = Self> {
    /// One `bool` for each lane.
    type Mask: Copy;
    /// The same value in every lane.
    fn splat(value: u32) -> Self;
    /// `self + other` modulo 2^32
    fn wrapping_add(self, other: Self) -> Self;
    /// `self - other` modulo 2^32
    fn wrapping_sub(self, other: Self) -> Self;
    /// `self * other` modulo 2^32
    fn wrapping_mul(self, other: Self) -> Self;
    /// `self < other`
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` in lanes where the mask holds, `no` in others.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The value of a lane.
    fn lane(self, lane: u32) -> u32;
}

/// Whether `count` neighbors are all below `end`, from `first` on.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
pub(crate) const fn are_below(first: u32, count: u32, end: u32) -> bool {
    end >= count && first <= end - count
}

impl Lane for f32 {
    const WIDTH: u32 = 1;
    const ADDS_TWO: bool = false;
    const READS_FOUR: bool = true;
    const GATHERS_TWO: bool = false;
    type One = f32;
    type Mask = bool;
    type Index = u32;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        value
    }

    #[inline(always)]
    fn ramp() -> Self {
        0.0
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn both(a: bool, b: bool) -> bool {
        a && b
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        crate::scalar::sqrt(self)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        #[cfg(target_arch = "spirv")]
        {
            Float::exp(self)
        }
        #[cfg(not(target_arch = "spirv"))]
        {
            libm::expf(self)
        }
    }

    #[inline(always)]
    fn truncate(self) -> Self {
        crate::scalar::truncate(self)
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn index(self) -> u32 {
        crate::scalar::to_u32(self)
    }

    #[inline(always)]
    fn materialize(self) -> Self {
        self
    }

    #[inline(always)]
    fn sum(self) -> f32 {
        self
    }

    #[inline(always)]
    fn lane(self, _: u32) -> f32 {
        self
    }

    #[inline(always)]
    fn read(buffer: Read<f32>, first: u32) -> Self {
        buffer.read(first)
    }

    #[inline(always)]
    fn read_written(buffer: Write<f32>, first: u32) -> Self {
        buffer.read(first)
    }

    #[inline(always)]
    fn read_below(buffer: Read<f32>, first: u32, end: u32) -> Self {
        if first < end { buffer.read(first) } else { 0.0 }
    }

    #[inline(always)]
    fn read_shared<const LEN: usize>(values: Shared<f32, LEN>, first: u32) -> Self {
        values.read(first)
    }

    #[inline(always)]
    fn gather(buffer: Read<f32>, at: u32) -> Self {
        buffer.read(at)
    }

    #[inline(always)]
    fn gather_shared<const LEN: usize>(values: Shared<f32, LEN>, at: u32) -> Self {
        values.read(at)
    }

    #[inline(always)]
    fn gather_two(buffer: Read<f32>, at: u32) -> [Self; 2] {
        [buffer.read(at), buffer.read(at + 1)]
    }

    #[inline(always)]
    fn gather_halves(buffer: Read<u32>, at: u32) -> [Self; 2] {
        let word = buffer.read(at);
        [normal_half_value(word & 0xffff), normal_half_value(word >> 16)]
    }

    #[inline(always)]
    fn write(self, buffer: Write<f32>, first: u32) {
        buffer.write(first, self);
    }

    #[inline(always)]
    fn write_shared<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32) {
        values.write(first, self);
    }

    #[inline(always)]
    fn write_shared_below<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32, end: u32) {
        if first < end {
            values.write(first, self);
        }
    }

    #[inline(always)]
    fn add_fixed(self, mask: bool, sum: Write<impl SumWord>, at: u32) {
        if mask {
            atomic::add_wide(sum, at, fixed::words(self));
        }
    }

    #[inline(always)]
    fn add_fixed_two<const M: usize>(
        values: [[Self; 2]; M],
        mask: bool,
        sum: Write<impl SumWord>,
        at: [u32; M],
    ) {
        let mut i = 0;
        while i < M && mask {
            atomic::add_wide(sum, at[i], fixed::words(values[i][0]));
            atomic::add_wide(sum, at[i] + 1, fixed::words(values[i][1]));
            i += 1;
        }
    }

    #[inline(always)]
    fn expect_fixed(_: Write<impl SumWord>, _: u32) {}

    #[inline(always)]
    fn take_fixed(sum: Write<u32>, first: u32) -> Self {
        fixed::take(sum, first)
    }

    #[inline(always)]
    fn flag(mask: bool, flags: Write<u32>, at: u32, block: u32) {
        if mask {
            atomic::raise(flags, at / block, 1);
        }
    }

    #[inline(always)]
    fn is_flagged(flags: Write<u32>, at: u32, block: u32) -> bool {
        flags.atomic_load(at / block) != 0
    }
}

impl LaneIndex for u32 {
    type Mask = bool;

    #[inline(always)]
    fn splat(value: u32) -> Self {
        value
    }

    #[inline(always)]
    fn wrapping_add(self, other: Self) -> Self {
        u32::wrapping_add(self, other)
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        u32::wrapping_sub(self, other)
    }

    #[inline(always)]
    fn wrapping_mul(self, other: Self) -> Self {
        u32::wrapping_mul(self, other)
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn lane(self, _: u32) -> u32 {
        self
    }
}
