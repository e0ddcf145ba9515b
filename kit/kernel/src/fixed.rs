//! Fixed point: sums as 64-bit integers, which do not depend on the order.
//!
//! Not every GPU has 64-bit integers. So a sum is two words in two's complement, the low one first.

use crate::memory::Write;
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};
use crate::scalar::{abs, to_u32};

/// 2^32
const WORD: f32 = 4_294_967_296.0;

/// The integer nearest to a number of less than 2^62, halves away from zero: its low word and its high one.
///
/// Every step is exact, so that all devices get the same integer, even if they fuse or regroup.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn words(x: f32) -> [u32; 2] {
    let size = abs(x);
    let high = to_u32(size * (1.0 / WORD));
    let rest = size - high as f32 * WORD;
    let low = to_u32(rest);
    // a number with a fraction is below 2^23
    let low = if rest - low as f32 >= 0.5 { low + 1 } else { low };
    if x < 0.0 { negated([low, high]) } else { [low, high] }
}

/// The number nearest to an integer, to three roundings.
#[inline(always)]
pub fn number(words: [u32; 2]) -> f32 {
    let is_negative = words[1] >= 1 << 31;
    let [low, high] = if is_negative { negated(words) } else { words };
    let size = high as f32 * WORD + low as f32;
    if is_negative { -size } else { size }
}

/// `-x` modulo 2^64
#[inline(always)]
pub(crate) fn negated([low, high]: [u32; 2]) -> [u32; 2] {
    let low = (!low).wrapping_add(1);
    let high = if low == 0 { (!high).wrapping_add(1) } else { !high };
    [low, high]
}

/// Like [`words`], for numbers below 2^63, on machines with 64-bit integers.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn integers<const N: usize>(mut x: [f32; N]) -> [i64; N] {
    /// The largest number below 2^63.
    const MAX: f32 = 9.223_371_5e18;
    /// The number before 1/2: with 1/2 itself the sum of both would be 1.
    const ALMOST_HALF: f32 = 0.499_999_97;
    if cfg!(debug_assertions) && N == 1 {
        crate::casts::check_number(x[0]);
    }
    // with sixteen lanes there is an instruction for it
    if N == 8
        && let Some(integers) = small_integers(x)
    {
        return integers;
    }
    let mut integers = [0; N];
    let mut i = 0;
    while i < N {
        x[i] = if x[i] < MAX { x[i] } else { MAX };
        x[i] = if x[i] > -MAX { x[i] } else { -MAX };
        x[i] += ALMOST_HALF.copysign(x[i]);
        // SAFETY: it is limited, and not NaN
        integers[i] = unsafe { x[i].to_int_unchecked() };
        i += 1;
    }
    integers
}

/// [`integers`] if all numbers are below 2^51: the last bits of their sums with 1.5 * 2^52. Before AVX-512, no instruction converts vectors
/// to 64-bit integers.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
fn small_integers<const N: usize>(x: [f32; N]) -> Option<[i64; N]> {
    /// 2^51
    const LIMIT: f32 = 2_251_799_813_685_248.0;
    /// 1.5 * 2^52: the unit of the last bit is 1, also for smaller sums.
    const BASE: f64 = 6_755_399_441_055_744.0;
    /// 2^-30 takes a half away from zero, and no other number to another integer.
    const NUDGE: f64 = 1.0 / 1_073_741_824.0;
    let mut are_small = true;
    let mut integers = [0; N];
    let mut i = 0;
    while i < N {
        are_small &= abs(x[i]) < LIMIT;
        let x = f64::from(x[i]);
        let sum = x + NUDGE.copysign(x) + BASE;
        integers[i] = sum.to_bits().wrapping_sub(BASE.to_bits()) as i64;
        i += 1;
    }
    if are_small { Some(integers) } else { None }
}

/// Reads an integer and leaves a zero in its place.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn take(sum: Write<u32>, index: u32) -> f32 {
    let words = [sum.read(2 * index), sum.read(2 * index + 1)];
    sum.write(2 * index, 0);
    sum.write(2 * index + 1, 0);
    number(words)
}

/// Like [`take`], for consecutive integers, with one rounding.
#[cfg(not(target_arch = "spirv"))]
#[inline(always)]
#[track_caller]
pub fn take_lanes<const N: usize>(sum: Write<u32>, first: u32) -> [f32; N] {
    use crate::memory::Touch;
    let index = core::array::from_fn::<_, N, _>(|i| first + i as u32);
    let at = sum.wide_addresses(index, Touch::Write);
    // SAFETY: the addresses are in range and aligned, and no other invocation touches these elements meanwhile
    let words = unsafe { at.add(first as usize).cast::<[[u32; 2]; N]>().replace([[0; 2]; N]) };
    core::array::from_fn(
        #[inline(always)]
        |i| (u64::from(words[i][1]) << 32 | u64::from(words[i][0])) as i64 as f32,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest integer, by the exact value of the float.
    fn nearest(x: f32) -> i64 {
        let exact = f64::from(x);
        let whole = libm::trunc(exact);
        let up = libm::fabs(exact - whole) >= 0.5;
        whole as i64 + if up { if x < 0.0 { -1 } else { 1 } } else { 0 }
    }

    fn joined([low, high]: [u32; 2]) -> i64 {
        (u64::from(high) << 32 | u64::from(low)) as i64
    }

    fn split(value: i64) -> [u32; 2] {
        [value as u32, (value >> 32) as u32]
    }

    /// Every exponent below 62, with mantissas that round in every way.
    fn numbers() -> impl Iterator<Item = f32> {
        let mantissas = (0..512_u32).map(|i| i.wrapping_mul(0x9e37_79b9) >> 9);
        let edges = [0, 1, 2, 3, 0x40_0000, 0x3f_ffff, 0x7f_fffe, 0x7f_ffff];
        mantissas.chain(edges).flat_map(|mantissa| {
            (0..127 + 62).flat_map(move |exponent: u32| {
                let x = f32::from_bits(exponent << 23 | mantissa);
                [x, -x]
            })
        })
    }

    #[test]
    fn a_number_becomes_the_nearest_integer() {
        for x in numbers() {
            assert_eq!(joined(words(x)), nearest(x), "{x:e}");
            assert_eq!(integers([x]), [nearest(x)], "{x:e}");
            assert_eq!(integers([x; 8]), [nearest(x); 8], "{x:e}");
            assert_eq!(integers([x; 16]), [nearest(x); 16], "{x:e}");
        }
        assert_eq!(integers([f32::INFINITY]), [9_223_371_487_098_961_920]);
        for (x, integer) in [
            (0.499_999_97, 0),
            (0.5, 1),
            (-0.5, -1),
            (1.5, 2),
            (8_388_607.5, 8_388_608),
            (4_294_967_296.0, 1 << 32),
            (-4_294_967_296.0, -(1 << 32)),
            (4.611_685_7e18, 4_611_685_743_549_480_960),
        ] {
            assert_eq!(joined(words(x)), integer, "{x:e}");
        }
    }

    #[test]
    fn an_integer_becomes_the_nearest_number() {
        let mut worst = 0.0_f64;
        let integers = numbers().map(|x| i128::from(nearest(x)));
        for integer in integers.chain([1, -1, 0xffff_ffff, i128::from(i64::MAX)]) {
            for integer in [integer, integer * 3 / 2 + 1, integer - 1] {
                let Ok(value) = i64::try_from(integer) else { continue };
                let found = number(split(value));
                let error = libm::fabs(f64::from(found) - value as f64);
                if value != 0 {
                    worst = f64::max(worst, error / libm::fabs(value as f64));
                } else {
                    assert_eq!(found, 0.0);
                }
            }
        }
        assert!(worst < 1.5 * f64::from(f32::EPSILON), "{worst:e}");
    }

    #[test]
    fn taking_clears_the_sum() {
        let mut values = [0; 4];
        let [low, high] = words(-1e12);
        values[2..].copy_from_slice(&[low, high]);
        let sum = Write::from(values.as_mut_slice());
        assert_eq!((take(sum, 0), take(sum, 1), take(sum, 1)), (0.0, -1e12, 0.0));
    }
}
