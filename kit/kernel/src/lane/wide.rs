//! Lanes on the CPU: arrays, and the vector instructions for them.

use core::ops::{Add, BitAnd, BitXor, Div, Mul, Neg, Sub};

use crate::atomic::{self, SumWord};
use crate::casts::check_cast;
use crate::fixed;
use crate::half::normal_half_value;
use crate::lane::{Lane, LaneIndex, are_below};
use crate::memory::{Read, Shared, Touch, Write};
use crate::scalar::integral;

/// `N` values. With `FUSED`, the instruction set has a fused multiply-add.
///
/// Inlined into a function with the right target features, the operations are vector instructions: from `wide_vectors` for AVX2 and
/// AVX-512, and what the compiler makes of arrays otherwise.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Wide<const N: usize, const FUSED: bool>(pub [f32; N]);

macro_rules! elementwise {
    ($($trait:ident::$name:ident $op:tt;)*) => {$(
        impl<const N: usize, const FUSED: bool> $trait for Wide<N, FUSED> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(vectors!($name(self.0, other.0), lanes!(|i| self.0[i] $op other.0[i])))
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
        Self(vectors!(neg(self.0), lanes!(|i| -self.0[i])))
    }
}

impl<const N: usize, const FUSED: bool> Lane for Wide<N, FUSED> {
    const WIDTH: u32 = N as u32;
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
        let sum = vectors!(
            mul_add(self.0, a.0, b.0),
            lanes!(|i| fma::<FUSED>(self.0[i], a.0[i], b.0[i]))
        );
        Self(sum)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        let smaller = vectors!(
            min(self.0, other.0),
            lanes!(|i| if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] })
        );
        Self(smaller)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let larger = vectors!(
            max(self.0, other.0),
            lanes!(|i| if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] })
        );
        Self(larger)
    }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        WideMask(vectors!(less(self.0, other.0), mask!(|i| self.0[i] < other.0[i])))
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> Self::Mask {
        WideMask(vectors!(less_equal(self.0, other.0), mask!(|i| self.0[i] <= other.0[i])))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let chosen = vectors!(
            select(mask.0, yes.0, no.0),
            lanes!(|i| if mask.0[i] != 0 { yes.0[i] } else { no.0[i] })
        );
        Self(chosen)
    }

    #[inline(always)]
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask {
        WideMask(vectors!(both(a.0, b.0), lanes!(|i| a.0[i] & b.0[i])))
    }

    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        vectors!(any(mask.0), {
            let mut any = 0;
            let mut i = 0;
            while i < N {
                any |= mask.0[i];
                i += 1;
            }
            any != 0
        })
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(vectors!(sqrt(self.0), lanes!(|i| self.0[i].sqrt())))
    }

    #[inline(always)]
    fn exp(self) -> Self {
        // values that a GPU may flush are zero
        let zero = self.less(Self::splat(-87.336_54));
        Self::select(zero, Self::splat(0.0), exp(self))
    }

    #[inline(always)]
    fn truncate(self) -> Self {
        Self(vectors!(truncate(self.0), {
            // a cast of its own would check each lane for NaN and for what no integer holds
            let whole = self.wholes();
            lanes!(|i| integral(self.0[i], whole[i] as f32))
        }))
    }

    #[inline(always)]
    #[track_caller]
    fn index(self) -> Self::Index {
        // a device that checks has one lane
        if cfg!(debug_assertions) && N == 1 {
            check_cast::<u32, _>(self.0[0]);
        }
        let whole = self.wholes();
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
    fn lane(self, lane: u32) -> f32 {
        self.0[lane as usize]
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
    fn read_below(buffer: Read<f32>, first: u32, end: u32) -> Self {
        let is_whole = are_below(first, Self::WIDTH, end);
        if is_whole { Self::read(buffer, first) } else { Self(read_some(buffer, first, end)) }
    }

    #[inline(always)]
    #[track_caller]
    fn read_shared<const LEN: usize>(values: Shared<f32, LEN>, first: u32) -> Self {
        Self(values.0.read_lanes(first))
    }

    #[inline(always)]
    #[track_caller]
    fn gather(buffer: Read<f32>, at: Self::Index) -> Self {
        Self(buffer.gather(at.0))
    }

    #[inline(always)]
    #[track_caller]
    fn gather_shared<const LEN: usize>(values: Shared<f32, LEN>, at: Self::Index) -> Self {
        let first = values.0.addresses_of(at.0, Touch::Read);
        // SAFETY: checked above
        Self(lanes!(|i| unsafe { *first.add(at.0[i] as usize) }))
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
        let lower = lanes!(|i| normal_half_value(words[i] & 0xffff));
        let upper = lanes!(|i| normal_half_value(words[i] >> 16));
        [Self(lower), Self(upper)]
    }

    #[inline(always)]
    #[track_caller]
    fn write(self, buffer: Write<f32>, first: u32) {
        buffer.write_lanes(first, self.0);
    }

    #[inline(always)]
    #[track_caller]
    fn write_shared<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32) {
        values.0.write_lanes(first, self.0);
    }

    #[inline(always)]
    #[track_caller]
    fn write_shared_below<const LEN: usize>(self, values: Shared<f32, LEN>, first: u32, end: u32) {
        if are_below(first, Self::WIDTH, end) {
            return self.write_shared(values, first);
        }
        let mut i = 0;
        while i < N && i < end.saturating_sub(first) as usize {
            values.write(first + i as u32, self.0[i]);
            i += 1;
        }
    }

    #[inline(always)]
    #[track_caller]
    fn add_fixed(self, mask: Self::Mask, sum: Write<impl SumWord>, at: Self::Index) {
        let values = Self::select(mask, self, Self::splat(0.0));
        atomic::add_wide_lanes(SumWord::words(sum), at.0, fixed::integers(values.0));
    }

    #[inline(always)]
    #[track_caller]
    fn add_fixed_two<const M: usize>(
        values: [[Self; 2]; M],
        mask: Self::Mask,
        sum: Write<impl SumWord>,
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
        atomic::add_two_wide_lanes(SumWord::words(sum), at.map(|at| at.0), pairs);
    }

    #[inline(always)]
    fn expect_fixed(sum: Write<impl SumWord>, at: Self::Index) {
        let sum = SumWord::words(sum);
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
        let at: [u32; N] = lanes!(|i| at.0[i] / block);
        atomic::flag_lanes(flags, mask.0.map(|lane| lane != 0), at);
    }

    #[inline(always)]
    fn is_flagged(_: Write<u32>, _: Self::Index, _: u32) -> bool {
        false
    }
}

impl<const N: usize, const FUSED: bool> Wide<N, FUSED> {
    /// Values without their fractions, clamped to the range of an integer.
    #[inline(always)]
    fn wholes(self) -> [i32; N] {
        /// The largest number below 2^31.
        const MAX: f32 = 2_147_483_520.0;
        // what is no number is MAX
        let x = self.min(Self::splat(MAX)).max(Self::splat(-MAX));
        // SAFETY: it is limited
        vectors!(whole(x.0), lanes!(|i| unsafe { x.0[i].to_int_unchecked() }))
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
    let power = |n: i32| f32::from_bits(((n + 127) as u32) << 23);
    let first = vectors!(first_power(shifted.0), lanes!(|i| power(half[i])));
    let second = vectors!(second_power(shifted.0), lanes!(|i| power(whole[i] - half[i])));
    Wide(sixteen!(scale(p.0, n.0), (p * Wide(first) * Wide(second)).0))
}

/// The sum as a tree of pairs. It is not inlined: otherwise the compiler would keep the terms in pairs of lanes.
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

/// The values from `first` to `end`, and zeros behind them.
#[cold]
#[inline(never)]
#[track_caller]
fn read_some<const N: usize>(buffer: Read<f32>, first: u32, end: u32) -> [f32; N] {
    let mut values = [0.0; N];
    let mut i = 0;
    while i < N && i < end.saturating_sub(first) as usize {
        values[i] = buffer.read(first + i as u32);
        i += 1;
    }
    values
}

/// `a b + c`, with one rounding if the instruction set has that.
#[inline(always)]
fn fma<const FUSED: bool>(a: f32, b: f32, c: f32) -> f32 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// `N` truth values: all bits of a lane are set, or none.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct WideMask<const N: usize>(pub [u32; N]);

/// `N` integers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct WideIndex<const N: usize>(pub [u32; N]);

impl<const N: usize> BitXor for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitxor(self, other: Self) -> Self {
        Self(sixteen!(bitxor(self.0, other.0), lanes!(|i| self.0[i] ^ other.0[i])))
    }
}

impl<const N: usize> BitAnd for WideIndex<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(sixteen!(bitand(self.0, other.0), lanes!(|i| self.0[i] & other.0[i])))
    }
}

macro_rules! wrapping {
    ($($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            Self(sixteen!($name(self.0, other.0), lanes!(|i| self.0[i].$name(other.0[i]))))
        }
    )*};
}

impl<const N: usize> LaneIndex for WideIndex<N> {
    type Mask = WideMask<N>;

    #[inline(always)]
    fn splat(value: u32) -> Self {
        Self([value; N])
    }

    wrapping! { wrapping_add wrapping_sub wrapping_mul }

    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        WideMask(sixteen!(index_less(self.0, other.0), mask!(|i| self.0[i] < other.0[i])))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let chosen = sixteen!(
            index_select(mask.0, yes.0, no.0),
            lanes!(|i| if mask.0[i] != 0 { yes.0[i] } else { no.0[i] })
        );
        Self(chosen)
    }

    #[inline(always)]
    fn lane(self, lane: u32) -> u32 {
        self.0[lane as usize]
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::kernel::InstructionSet;
    use crate::lane::LaneIndex;
    use crate::scalar::TINY;

    #[test]
    fn a_sum_takes_every_lane_once() {
        let lanes = Wide::<16, true>::ramp();
        assert_eq!(lanes.sum(), 120.0);
        assert_eq!(Wide::<1, false>::splat(3.0).sum(), 3.0);
    }

    #[test]
    fn an_index_drops_the_fraction() {
        let values = Wide::<4, false>([0.0, 0.99, 1.5, 16_777_215.0]);
        assert_eq!(values.index().0, [0, 0, 1, 16_777_215]);
        assert_eq!(values.truncate().0, [0.0, 0.0, 1.0, 16_777_215.0]);
    }

    /// The results of all operations: numbers, masks as 0 and 1, and integers as bits.
    fn operations<const N: usize>(a: Wide<N, true>, b: Wide<N, true>) -> Vec<[f32; N]> {
        let shown = |mask| Wide::select(mask, Wide::splat(1.0), Wide::splat(0.0));
        let floats = [a + b, a - b, a * b, a / b, -a, a.mul_add(b, a), a.min(b), a.max(b)];
        let more = [a.sqrt(), a.exp(), a.truncate(), Wide::select(a.less(b), a, b)];
        let masks = [a.less(b), a.less_equal(b), Wide::<N, true>::both(a.less(b), b.less(-a))];
        let first = WideIndex(a.0.map(f32::to_bits));
        let second = WideIndex(b.0.map(f32::to_bits));
        let integers = [
            first ^ second,
            first & second,
            first.wrapping_add(second),
            first.wrapping_sub(second),
            first.wrapping_mul(second),
            LaneIndex::select(first.less(second), first, second),
            a.index(),
        ];
        let floats = floats.into_iter().chain(more).chain(masks.map(shown)).map(|lanes| lanes.0);
        floats.chain(integers.map(|lanes| lanes.0.map(f32::from_bits))).collect()
    }

    /// Compares them with one lane's, for all pairs of special values.
    fn match_one_lane<const N: usize>() {
        let values = [0.0, -0.0, 1.0, -1.5, 1e-40, f32::NAN, f32::INFINITY, -f32::INFINITY, 3e9];
        let values = [&values[..], &[-3e9, 88.9, -87.4, 0.3]].concat();
        let value = |at: usize| values[at % values.len()];
        for (shift, &limit) in values.iter().enumerate() {
            let found =
                operations::<N>(Wide(lanes!(|i| value(i))), Wide(lanes!(|i| value(i + shift))));
            for lane in 0..N {
                let [a, b] = [value(lane), value(lane + shift)];
                let expected = operations::<1>(Wide([a]), Wide([b]));
                for (operation, (found, [expected])) in found.iter().zip(expected).enumerate() {
                    let found = found[lane];
                    let is_same = found.to_bits() == expected.to_bits();
                    let is_nan = found.is_nan() && expected.is_nan();
                    assert!(
                        is_same || is_nan,
                        "{operation} of {a} and {b}: {found}, not {expected}"
                    );
                }
            }
            let mask = Wide::<N, true>(lanes!(|i| value(i))).less(Wide::splat(limit));
            assert_eq!(Wide::<N, true>::any(mask), mask.0.iter().any(|&lane| lane != 0));
        }
    }

    #[test]
    fn instructions_give_the_bits_of_one_lane() {
        for set in [InstructionSet::Avx2, InstructionSet::Avx512] {
            match set {
                _ if !set.is_available() => {}
                InstructionSet::Avx2 => match_one_lane::<8>(),
                _ => match_one_lane::<16>(),
            }
        }
    }

    #[test]
    fn the_exponential_matches_f64() {
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
