//! Several invocations at once: what a kernel computes with where the CPU runs it with SIMD.
//!
//! A kernel declared with `lanes(samples)` is generic over [`Lane`].  A GPU runs it with `f32`: an invocation is a
//! lane already.  The CPU runs it with [`Wide`], as many invocations along x at once as its registers hold, and with
//! one lane of the same arithmetic for those that are left over, so that no result depends on where a block ends.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Sub};

#[cfg(target_arch = "spirv")]
use spirv_std::num_traits::Float;

use crate::prelude::*;
use crate::{atomic, fixed};

#[cfg(not(target_arch = "spirv"))]
pub use wide::{Wide, WideIndex, WideMask};

/// The most lanes that a [`Lane`] has: workgroups are multiples of it.
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
    /// Lanes.
    const WIDTH: u32;
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
    /// `self * a + b`, with one rounding where the hardware has that: for kernels that are `fused`.
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// The smaller of two values.
    fn min(self, other: Self) -> Self;
    /// The larger of two values.
    fn max(self, other: Self) -> Self;
    /// `self < other`
    fn less(self, other: Self) -> Self::Mask;
    /// `self <= other`
    fn at_most(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Where both masks hold.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Whether a mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// Square root.
    fn sqrt(self) -> Self;
    /// e^x; on the CPU to 1.5 ulp, and 0 below the smallest normal number.
    fn exp(self) -> Self;
    /// The value without its fraction, for values below 2^31.
    fn truncate(self) -> Self;
    /// The value without its fraction as an integer, for values from 0 to 2^31.
    fn index(self) -> Self::Index;
    /// The sum of all lanes, of pairs of halves: the same order for every run.
    fn sum(self) -> f32;
    /// Consecutive values from `first` on.
    fn read(buffer: Read<f32>, first: u32) -> Self;
    /// Consecutive values from `first` on, of a buffer that is written, too.
    fn read_written(buffer: Write<f32>, first: u32) -> Self;
    /// Values at any places.
    fn gather(buffer: Read<f32>, at: Self::Index) -> Self;
    /// Stores consecutive values from `first` on.
    fn write(self, buffer: Write<f32>, first: u32);
    /// Adds the values to the [fixed-point](crate::fixed) sums at `at`, where the mask holds: see
    /// [`atomic::add_wide`].
    fn add_fixed(self, mask: Self::Mask, sum: Write<u32>, at: Self::Index);
    /// Says that the fixed-point sums at `at` are about to be added to.
    fn expect_fixed(sum: Write<u32>, at: Self::Index);
    /// Consecutive fixed-point sums from `first` on; leaves zeros.
    fn take_fixed(sum: Write<u32>, first: u32) -> Self;
    /// Raises the flags of the blocks of `block` elements that the elements `at` lie in, where the mask holds.
    fn flag(mask: Self::Mask, flags: Write<u32>, at: Self::Index, block: u32);
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
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The value of a lane.
    fn lane(self, lane: u32) -> u32;
}

impl Lane for f32 {
    const WIDTH: u32 = 1;
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
    fn at_most(self, other: Self) -> bool {
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
        crate::math::sqrt(self)
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
        crate::math::truncate(self)
    }

    #[inline(always)]
    fn index(self) -> u32 {
        self as u32
    }

    #[inline(always)]
    fn sum(self) -> f32 {
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
    fn gather(buffer: Read<f32>, at: u32) -> Self {
        buffer.read(at)
    }

    #[inline(always)]
    fn write(self, buffer: Write<f32>, first: u32) {
        buffer.write(first, self);
    }

    #[inline(always)]
    fn add_fixed(self, mask: bool, sum: Write<u32>, at: u32) {
        if mask {
            atomic::add_wide(sum, at, fixed::words(self));
        }
    }

    #[inline(always)]
    fn expect_fixed(_: Write<u32>, _: u32) {}

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

#[cfg(not(target_arch = "spirv"))]
mod wide {
    extern crate std;

    use core::array::from_fn;
    use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Sub};

    use super::{Lane, LaneIndex};
    use crate::prelude::*;
    use crate::{atomic, fixed};

    /// `N` values; with `FUSED`, the instruction set it is compiled for has a fused multiply-add.
    ///
    /// The arithmetic is that of plain arrays: inlined into a function with the right target features, the compiler
    /// makes vector instructions of it.
    #[derive(Clone, Copy, Debug)]
    #[repr(C, align(64))]
    pub struct Wide<const N: usize, const FUSED: bool>(pub [f32; N]);

    /// `N` truth values.
    #[derive(Clone, Copy, Debug)]
    pub struct WideMask<const N: usize>(pub [bool; N]);

    /// `N` integers.
    #[derive(Clone, Copy, Debug)]
    #[repr(C, align(64))]
    pub struct WideIndex<const N: usize>(pub [u32; N]);

    macro_rules! elementwise {
        ($($trait:ident::$name:ident $op:tt;)*) => {$(
            impl<const N: usize, const FUSED: bool> $trait for Wide<N, FUSED> {
                type Output = Self;

                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    Self(from_fn(#[inline(always)] |i| self.0[i] $op other.0[i]))
                }
            }
        )*};
    }

    elementwise! {
        Add::add +;
        Sub::sub -;
        Mul::mul *;
        Div::div /;
    }

    impl<const N: usize, const FUSED: bool> Neg for Wide<N, FUSED> {
        type Output = Self;

        #[inline(always)]
        fn neg(self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| -self.0[i],
            ))
        }
    }

    impl<const N: usize> BitXor for WideIndex<N> {
        type Output = Self;

        #[inline(always)]
        fn bitxor(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i] ^ other.0[i],
            ))
        }
    }

    impl<const N: usize> BitAnd for WideIndex<N> {
        type Output = Self;

        #[inline(always)]
        fn bitand(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i] & other.0[i],
            ))
        }
    }

    /// e^x = 2^n e^r with |r| <= ln 2 / 2: Cephes' polynomial.  Step by step for all lanes: the compiler would leave
    /// a closure of this length as it is, one lane after the other.
    #[inline(always)]
    fn exp<const N: usize, const FUSED: bool>(x: Wide<N, FUSED>) -> Wide<N, FUSED> {
        /// 1.5 * 2^23: adding it leaves the nearest integer in the low bits.
        const MAGIC: f32 = 12_582_912.0;
        let number = Wide::<N, FUSED>::splat;
        let x = x.min(number(89.0)).max(number(-88.0));
        let shifted = x * number(core::f32::consts::LOG2_E) + number(MAGIC);
        let n = shifted - number(MAGIC);
        let r = (x - n * number(0.693_359_4)) + n * number(2.121_944_4e-4);
        let p = number(1.987_569_1e-4);
        let p = p.mul_add(r, number(1.398_199_9e-3));
        let p = p.mul_add(r, number(8.333_452e-3));
        let p = p.mul_add(r, number(4.166_579_6e-2));
        let p = p.mul_add(r, number(1.666_666_5e-1));
        let p = p.mul_add(r, number(0.5));
        let p = (p * r).mul_add(r, r) + number(1.0);
        // 2^n in two factors: n may be 128
        let whole: [i32; N] = from_fn(
            #[inline(always)]
            |i| ((shifted.0[i].to_bits() as i32) << 9) >> 9,
        );
        let half: [i32; N] = from_fn(
            #[inline(always)]
            |i| whole[i] >> 1,
        );
        let first = Wide(from_fn(
            #[inline(always)]
            |i| f32::from_bits(((half[i] + 127) as u32) << 23),
        ));
        let second = Wide(from_fn(
            #[inline(always)]
            |i| f32::from_bits(((whole[i] - half[i] + 127) as u32) << 23),
        ));
        p * first * second
    }

    /// The sum of pairs of halves.  Not inlined: it would have the compiler keep what is summed up in pairs of lanes.
    #[inline(never)]
    fn pairwise<const N: usize>(values: &[f32; N]) -> f32 {
        let mut values = *values;
        let mut width = N / 2;
        while width > 0 {
            let mut i = 0;
            while i < width {
                values[i] += values[i + width];
                i += 1;
            }
            width /= 2;
        }
        values[0]
    }

    /// Values without their fractions, limited to what an integer holds.  A plain `as` does the same, one by one.
    #[inline(always)]
    fn wholes<const N: usize>(mut x: [f32; N]) -> [i32; N] {
        /// The largest number below 2^31.
        const MOST: f32 = 2_147_483_520.0;
        let mut whole = [0; N];
        let mut i = 0;
        while i < N {
            x[i] = if x[i] < MOST { x[i] } else { MOST };
            x[i] = if x[i] > -MOST { x[i] } else { -MOST };
            // SAFETY: it is limited, and not NaN
            whole[i] = unsafe { x[i].to_int_unchecked() };
            i += 1;
        }
        whole
    }

    #[inline(always)]
    fn fma<const FUSED: bool>(a: f32, b: f32, c: f32) -> f32 {
        if FUSED { a.mul_add(b, c) } else { a * b + c }
    }

    impl<const N: usize, const FUSED: bool> Lane for Wide<N, FUSED> {
        const WIDTH: u32 = N as u32;
        type One = Wide<1, FUSED>;
        type Mask = WideMask<N>;
        type Index = WideIndex<N>;

        #[inline(always)]
        fn splat(value: f32) -> Self {
            Self([value; N])
        }

        #[inline(always)]
        fn ramp() -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| i as f32,
            ))
        }

        #[inline(always)]
        fn mul_add(self, a: Self, b: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| fma::<FUSED>(self.0[i], a.0[i], b.0[i]),
            ))
        }

        #[inline(always)]
        fn min(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] },
            ))
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] },
            ))
        }

        #[inline(always)]
        fn less(self, other: Self) -> Self::Mask {
            WideMask(from_fn(
                #[inline(always)]
                |i| self.0[i] < other.0[i],
            ))
        }

        #[inline(always)]
        fn at_most(self, other: Self) -> Self::Mask {
            WideMask(from_fn(
                #[inline(always)]
                |i| self.0[i] <= other.0[i],
            ))
        }

        #[inline(always)]
        fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| if mask.0[i] { yes.0[i] } else { no.0[i] },
            ))
        }

        #[inline(always)]
        fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask {
            WideMask(from_fn(
                #[inline(always)]
                |i| a.0[i] & b.0[i],
            ))
        }

        #[inline(always)]
        fn any(mask: Self::Mask) -> bool {
            let mut any = false;
            let mut i = 0;
            while i < N {
                any |= mask.0[i];
                i += 1;
            }
            any
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i].sqrt(),
            ))
        }

        #[inline(always)]
        fn exp(self) -> Self {
            // what a GPU may flush is zero
            let zero = self.less(Self::splat(-87.336_54));
            Self::select(zero, Self::splat(0.0), exp(self))
        }

        #[inline(always)]
        fn truncate(self) -> Self {
            let whole = wholes(self.0);
            Self(from_fn(
                #[inline(always)]
                |i| whole[i] as f32,
            ))
        }

        #[inline(always)]
        fn index(self) -> Self::Index {
            let whole = wholes(self.0);
            WideIndex(from_fn(
                #[inline(always)]
                |i| whole[i] as u32,
            ))
        }

        #[inline(always)]
        fn sum(self) -> f32 {
            pairwise(&self.0)
        }

        #[inline(always)]
        #[track_caller]
        fn read(buffer: Read<f32>, first: u32) -> Self {
            Self(buffer.read_lanes(first))
        }

        #[inline(always)]
        #[track_caller]
        fn read_written(buffer: Write<f32>, first: u32) -> Self {
            Self(buffer.read_lanes(first))
        }

        #[inline(always)]
        #[track_caller]
        fn gather(buffer: Read<f32>, at: Self::Index) -> Self {
            Self(buffer.gather(at.0))
        }

        #[inline(always)]
        #[track_caller]
        fn write(self, buffer: Write<f32>, first: u32) {
            buffer.write_lanes(first, self.0);
        }

        #[inline(always)]
        #[track_caller]
        fn add_fixed(self, mask: Self::Mask, sum: Write<u32>, at: Self::Index) {
            let values = Self::select(mask, self, Self::splat(0.0));
            atomic::add_wide_lanes(sum, at.0, fixed::integers(values.0));
        }

        #[inline(always)]
        fn expect_fixed(sum: Write<u32>, at: Self::Index) {
            let mut i = 0;
            while i < N {
                sum.prefetch(2 * at.0[i]);
                i += 1;
            }
        }

        #[inline(always)]
        #[track_caller]
        fn take_fixed(sum: Write<u32>, first: u32) -> Self {
            Self(fixed::take_lanes(sum, first))
        }

        #[inline(always)]
        #[track_caller]
        fn flag(mask: Self::Mask, flags: Write<u32>, at: Self::Index, block: u32) {
            let at = from_fn(
                #[inline(always)]
                |i| at.0[i] / block,
            );
            atomic::flag_lanes(flags, mask.0, at);
        }
    }

    impl<const N: usize> LaneIndex for WideIndex<N> {
        type Mask = WideMask<N>;

        #[inline(always)]
        fn splat(value: u32) -> Self {
            Self([value; N])
        }

        #[inline(always)]
        fn wrapping_add(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i].wrapping_add(other.0[i]),
            ))
        }

        #[inline(always)]
        fn wrapping_sub(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i].wrapping_sub(other.0[i]),
            ))
        }

        #[inline(always)]
        fn wrapping_mul(self, other: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| self.0[i].wrapping_mul(other.0[i]),
            ))
        }

        #[inline(always)]
        fn less(self, other: Self) -> Self::Mask {
            WideMask(from_fn(
                #[inline(always)]
                |i| self.0[i] < other.0[i],
            ))
        }

        #[inline(always)]
        fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
            Self(from_fn(
                #[inline(always)]
                |i| if mask.0[i] { yes.0[i] } else { no.0[i] },
            ))
        }

        #[inline(always)]
        fn lane(self, lane: u32) -> u32 {
            self.0[lane as usize]
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;
        use crate::math::TINY;

        #[test]
        fn the_exponential_is_that_of_f64() {
            let mut worst = 0.0_f64;
            for step in -90_000..90_000 {
                let x = step as f32 * 0.001;
                let exact = libm::exp(f64::from(x));
                for found in
                    [Wide::<4, true>::splat(x).exp().0[1], Wide::<4, false>::splat(x).exp().0[3]]
                {
                    if x > 88.722 {
                        assert!(found.is_infinite() || f64::from(found) > 3e38, "{x}: {found}");
                    } else if exact < f64::from(TINY) {
                        assert!(found <= TINY, "{x}: {found}");
                    } else {
                        worst = worst.max((f64::from(found) - exact).abs() / exact);
                    }
                }
            }
            assert!(worst < 1.5 * f64::from(f32::EPSILON), "{worst:e}");
            assert_eq!(Wide::<2, true>::splat(0.0).exp().0, [1.0; 2]);
        }

        #[test]
        fn a_sum_takes_every_lane_once() {
            let lanes = Wide::<16, true>::ramp();
            assert_eq!(lanes.sum(), 120.0);
            assert_eq!(Wide::<1, false>::splat(3.0).sum(), 3.0);
        }

        #[test]
        fn what_an_index_keeps_of_a_value() {
            let values = Wide::<4, false>([0.0, 0.99, 1.5, 16_777_215.0]);
            assert_eq!(values.index().0, [0, 0, 1, 16_777_215]);
            assert_eq!(values.truncate().0, [0.0, 0.0, 1.0, 16_777_215.0]);
        }
    }
}
