//! Lanes on the CPU: arrays that the compiler turns into vector instructions.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Sub};

use crate::casts::check_cast;
use crate::half::half_value;
use crate::lane::{Lane, LaneIndex};
use crate::memory::{Read, Write};
use crate::wide_math::{fma, pairwise, wholes};
use crate::{atomic, fixed};

/// An array of what an expression gives for each lane.
macro_rules! lanes {
    (|$lane:ident| $value:expr) => {
        core::array::from_fn(
            #[inline(always)]
            |$lane| $value,
        )
    };
}

/// `N` values. With `FUSED`, the instruction set has a fused multiply-add.
///
/// The arithmetic is that of plain arrays. Inlined into a function with the right target features, the compiler turns
/// it into vector instructions.
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
                Self(lanes!(|i| self.0[i] $op other.0[i]))
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
        Self(lanes!(|i| -self.0[i]))
    }
}

impl<const N: usize> BitXor for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitxor(self, other: Self) -> Self {
        Self(lanes!(|i| self.0[i] ^ other.0[i]))
    }
}

impl<const N: usize> BitAnd for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(lanes!(|i| self.0[i] & other.0[i]))
    }
}

impl<const N: usize, const FUSED: bool> Lane for Wide<N, FUSED> {
    const WIDTH: u32 = N as u32;
    // CPUs with eight lanes have 16 registers: too few for sixteen sums and their terms
    const COLUMNS: u32 = if N == 8 { 2 } else { 4 };
    const ADDS_TWO: bool = N > 1;
    const READS_FOUR: bool = false;
    const GATHERS_TWO: bool = N > 1;
    type One = Wide<1, FUSED>;
    type Mask = WideMask<N>;
    type Index = WideIndex<N>;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn ramp() -> Self {
        Self(lanes!(|i| i as f32))
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(lanes!(|i| fma::<FUSED>(self.0[i], a.0[i], b.0[i])))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(lanes!(|i| if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(lanes!(|i| if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        WideMask(lanes!(|i| self.0[i] < other.0[i]))
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> Self::Mask {
        WideMask(lanes!(|i| self.0[i] <= other.0[i]))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(lanes!(|i| if mask.0[i] { yes.0[i] } else { no.0[i] }))
    }

    #[inline(always)]
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask {
        WideMask(lanes!(|i| a.0[i] & b.0[i]))
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
        Self(lanes!(|i| self.0[i].sqrt()))
    }

    #[inline(always)]
    fn exp(self) -> Self {
        // values that a GPU may flush are zero
        let zero = self.less(Self::splat(-87.336_54));
        Self::select(zero, Self::splat(0.0), exp(self))
    }

    #[inline(always)]
    fn truncate(self) -> Self {
        let whole = wholes(self.0);
        Self(lanes!(|i| whole[i] as f32))
    }

    #[inline(always)]
    #[track_caller]
    fn index(self) -> Self::Index {
        // a device that checks has one lane
        if cfg!(debug_assertions) && N == 1 {
            check_cast::<u32, _>(self.0[0]);
        }
        let whole = wholes(self.0);
        WideIndex(lanes!(|i| whole[i] as u32))
    }

    #[inline(always)]
    fn materialize(self) -> Self {
        core::hint::black_box(self)
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
    fn gather_two(buffer: Read<f32>, at: Self::Index) -> [Self; 2] {
        buffer.gather_two(at.0).map(Self)
    }

    #[inline(always)]
    #[track_caller]
    fn gather_halves(buffer: Read<u32>, at: Self::Index) -> [Self; 2] {
        let words = buffer.gather(at.0);
        let lower = lanes!(|i| half_value(words[i] & 0xffff));
        let upper = lanes!(|i| half_value(words[i] >> 16));
        [Self(lower), Self(upper)]
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
    #[track_caller]
    fn add_fixed_two<const M: usize>(
        values: [[Self; 2]; M],
        mask: Self::Mask,
        sum: Write<u32>,
        at: [Self::Index; M],
    ) {
        let zero = Self::splat(0.0);
        let mut pairs = [[[0; 2]; N]; M];
        let mut i = 0;
        while i < M {
            let first = fixed::integers(Self::select(mask, values[i][0], zero).0);
            let second = fixed::integers(Self::select(mask, values[i][1], zero).0);
            pairs[i] = lanes!(|lane| [first[lane], second[lane]]);
            i += 1;
        }
        atomic::add_two_wide_lanes(sum, at.map(|at| at.0), pairs);
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
        let at = lanes!(|i| at.0[i] / block);
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
        Self(lanes!(|i| self.0[i].wrapping_add(other.0[i])))
    }

    #[inline(always)]
    fn wrapping_sub(self, other: Self) -> Self {
        Self(lanes!(|i| self.0[i].wrapping_sub(other.0[i])))
    }

    #[inline(always)]
    fn wrapping_mul(self, other: Self) -> Self {
        Self(lanes!(|i| self.0[i].wrapping_mul(other.0[i])))
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        WideMask(lanes!(|i| self.0[i] < other.0[i]))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(lanes!(|i| if mask.0[i] { yes.0[i] } else { no.0[i] }))
    }

    #[inline(always)]
    fn lane(self, lane: u32) -> u32 {
        self.0[lane as usize]
    }
}

/// e^x = 2^n e^r with |r| <= ln 2 / 2: Cephes' polynomial. Each step runs for all lanes: a closure of this length
/// would not be vectorized.
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
    let whole: [i32; N] = lanes!(|i| ((shifted.0[i].to_bits() as i32) << 9) >> 9);
    let half: [i32; N] = lanes!(|i| whole[i] >> 1);
    let first = Wide(lanes!(|i| f32::from_bits(((half[i] + 127) as u32) << 23)));
    let second = Wide(lanes!(|i| f32::from_bits(((whole[i] - half[i] + 127) as u32) << 23)));
    p * first * second
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::TINY;

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
}
