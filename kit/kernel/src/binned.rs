//! Binned sums: sums of any numbers that are exact, so they depend neither on the order nor on a unit chosen before.
//!
//! A number is an integer of 24 bits times a power of two. Numbers whose exponents lie in the same range of 16 are added as
//! 64-bit integers, in units of the range's smallest exponent: they have at most 39 bits, and 2^24 of them fit. So a sum takes
//! a row for each range, and one that counts what is not a number.
//!
//! [Fixed point](crate::fixed) takes a sixteenth of the memory, but needs a bound of what is added.

use muslin_macros::loops;

use crate::atomic::{self, SumWord};
use crate::fixed;
use crate::memory::Write;
#[cfg(target_arch = "spirv")]
use crate::memory::{ReadBuffer, WriteBuffer};

/// Exponents of a range, and bits by which the units of two ranges differ.
const RANGE: u32 = 16;
/// Ranges of exponents.
const RANGES: u32 = 256 / RANGE;
/// Rows of a sum: the ranges, and one for what is infinite or NaN.
pub const ROWS: u32 = RANGES + 1;

/// A NaN. Other bits may be set beside these.
const NAN_BITS: u32 = 0x7fc0_0000;

/// Adds a number to the sum at `index`, of `sum [17, sums, 2]`. What a GPU may flush counts as zero.
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn add(sum: Write<impl SumWord>, sums: u32, index: u32, x: f32) {
    let bits = x.to_bits();
    let exponent = bits >> 23 & 0xff;
    if exponent != 0 {
        let row = exponent / RANGE;
        let shift = exponent % RANGE;
        let mantissa = bits & 0x7f_ffff | 0x80_0000;
        let words = [mantissa << shift, mantissa >> (31 - shift) >> 1];
        let words = if bits >> 31 != 0 { fixed::negated(words) } else { words };
        let is_number = exponent < 255;
        let row = if is_number { row } else { RANGES };
        let words = if is_number { words } else { [1, 0] };
        atomic::add_wide_shared(sum, row * sums + index, words);
    }
}

/// Reads a sum of less than 2^127 and leaves zeros in its place: to two roundings, and NaN if any term was infinite or NaN.
#[loops]
#[inline(always)]
#[cfg_attr(not(target_arch = "spirv"), track_caller)]
pub fn take(sum: Write<u32>, sums: u32, index: u32) -> f32 {
    // what exceeds a row's 16 bits goes to the next one
    let mut carry = [0, 0];
    let mut row = 0;
    while row < RANGES {
        let at = 2 * (row * sums + index);
        let low = sum.read(at);
        let digits = low.wrapping_add(carry[0]);
        let overflow = if digits < low { 1 } else { 0 };
        let high = sum.read(at + 1).wrapping_add(carry[1]).wrapping_add(overflow);
        sum.write(at, digits & 0xffff);
        sum.write(at + 1, 0);
        carry = [digits >> RANGE | high << RANGE, ((high as i32) >> RANGE) as u32];
        row += 1;
    }
    // from the largest row on: until the first that is not zero, all is exact
    let mut total = fixed::number(carry) * power_of_two(106);
    while row > 0 {
        row -= 1;
        let at = 2 * (row * sums + index);
        // the unit is 2^(16 row - 150), which may be below what every device has
        let half = power_of_two(8 * row as i32 - 75);
        total += sum.read(at) as f32 * half * half;
        sum.write(at, 0);
    }
    let at = 2 * (RANGES * sums + index);
    let odd = sum.read(at) | sum.read(at + 1);
    sum.write(at, 0);
    sum.write(at + 1, 0);
    // not a constant, which WGSL has none of
    if odd != 0 { f32::from_bits(odd | NAN_BITS) } else { total }
}

/// 2^e for e of -126 to 127.
#[inline(always)]
fn power_of_two(e: i32) -> f32 {
    f32::from_bits(((e + 127) as u32) << 23)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec;
    use std::vec::Vec;

    use super::*;

    /// Sums of what `terms` has for each of its places, added in this order.
    fn sums(terms: &[Vec<f32>], order: impl Iterator<Item = usize>) -> Vec<f32> {
        let len = terms[0].len() as u32;
        let mut words = vec![0; (2 * ROWS * len) as usize];
        let sum = Write::from(words.as_mut_slice());
        for index in order {
            terms[index].iter().zip(0..).for_each(|(&x, at)| add(sum, len, at, x));
        }
        let found = (0..len).map(|at| take(sum, len, at)).collect();
        assert!(words.iter().all(|&word| word == 0), "what is taken is gone");
        found
    }

    /// Numbers of many sizes, whose sums fit into 128 bits in units of 2^-70.
    fn terms() -> Vec<Vec<f32>> {
        let number = |i: u32| {
            let bits = i.wrapping_mul(0x9e37_79b9);
            f32::from_bits(bits & 0x807f_ffff | (80 + i * 7 % 90) << 23)
        };
        (0..500).map(|term| (0..6).map(|at| number(6 * term + at)).collect()).collect()
    }

    #[test]
    fn sums_are_exact_in_any_order() {
        let mut terms = terms();
        // what is large cancels
        for index in 0..500 {
            let negated: Vec<_> = terms[index].iter().map(|x| -x).collect();
            if terms[index][0].abs() > 1.0 {
                terms.push(negated);
            }
        }
        let found = sums(&terms, 0..terms.len());
        assert_eq!(found, sums(&terms, (0..terms.len()).rev()));
        for (at, found) in found.iter().enumerate() {
            let units = |x: f32| (f64::from(x) * 2_f64.powi(70)) as i128;
            let exact: i128 = terms.iter().map(|term| units(term[at])).sum();
            let error = f64::from(*found) / (exact as f64 * 2_f64.powi(-70)) - 1.0;
            assert!(error.abs() < 2.0 * f64::from(f32::EPSILON), "{found} is off by {error:e}");
        }
    }

    #[test]
    fn the_ends_of_all_numbers() {
        let max = f32::MAX / 2.0;
        let ends = [max, -max, f32::MIN_POSITIVE, -f32::MIN_POSITIVE, 1.0, 0.0];
        let one = vec![Vec::from(ends)];
        assert_eq!(sums(&one, 0..1), ends);
        let denormal = f32::MIN_POSITIVE / 2.0;
        assert_eq!(sums(&[vec![denormal, -denormal]], 0..1), [0.0, 0.0]);
        let all = [vec![f32::NAN, 1.0], vec![1.0, f32::INFINITY], vec![1.0, f32::NEG_INFINITY]];
        assert!(sums(&all, 0..3).iter().all(|sum| sum.is_nan()));
    }
}
