//! Functions of integers that core has, and compilers for GPUs lack.

use crate::math::{min, sqrt};

/// Integers of 32 bits.
pub trait Integer: Copy {
    /// See [`saturating_add`].
    #[doc(hidden)]
    fn add(self, other: Self) -> Self;
    /// See [`saturating_sub`].
    #[doc(hidden)]
    fn sub(self, other: Self) -> Self;
}

impl Integer for u32 {
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = self.wrapping_add(other);
        if sum < self { Self::MAX } else { sum }
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        if self < other { 0 } else { self.wrapping_sub(other) }
    }
}

impl Integer for i32 {
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = self.wrapping_add(other);
        // the sum of two numbers of one sign has another sign
        if (self ^ sum) & (other ^ sum) < 0 { limit(self) } else { sum }
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let rest = self.wrapping_sub(other);
        if (self ^ other) & (self ^ rest) < 0 { limit(self) } else { rest }
    }
}

/// The limit on this number's side.
#[inline(always)]
fn limit(x: i32) -> i32 {
    if x < 0 { i32::MIN } else { i32::MAX }
}

/// `a + b`, or the limit of the type if that is beyond it: `a.saturating_add(b)`.
#[inline(always)]
pub fn saturating_add<I: Integer>(a: I, b: I) -> I {
    a.add(b)
}

/// `a - b`, or the limit of the type if that is beyond it: `a.saturating_sub(b)`.
#[inline(always)]
pub fn saturating_sub<I: Integer>(a: I, b: I) -> I {
    a.sub(b)
}

/// The largest integer whose square is not above x: `x.isqrt()`.
#[inline(always)]
pub fn isqrt(x: u32) -> u32 {
    // a device's root is off by less than 1
    let root = min(sqrt(x as f32), 65_535.0) as u32;
    let root = if root * root > x { root - 1 } else { root };
    if x - root * root > 2 * root { root + 1 } else { root }
}

/// The upper 32 of the 64 bits of `a b`.
#[inline(always)]
pub fn multiply_high(a: u32, b: u32) -> u32 {
    // by halves, because not every GPU has integers of 64 bits
    let [a_high, a_low] = [a >> 16, a & 0xffff];
    let [b_high, b_low] = [b >> 16, b & 0xffff];
    let middle = a_high * b_low + ((a_low * b_low) >> 16);
    let rest = a_low * b_high + (middle & 0xffff);
    a_high * b_high + (middle >> 16) + (rest >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    const EDGES: [u32; 12] = [
        0,
        1,
        2,
        0xffff,
        0x1_0000,
        0x1_0001,
        0x7fff_ffff,
        0x8000_0000,
        0x8000_0001,
        0xfffe_0000,
        0xfffe_0001,
        u32::MAX,
    ];

    #[test]
    fn integers_match_core() {
        for a in EDGES {
            for b in EDGES {
                assert_eq!(saturating_add(a, b), a.saturating_add(b));
                assert_eq!(saturating_sub(a, b), a.saturating_sub(b));
                let [x, y] = [a as i32, b as i32];
                assert_eq!(saturating_add(x, y), x.saturating_add(y));
                assert_eq!(saturating_sub(x, y), x.saturating_sub(y));
                let product = u64::from(a) * u64::from(b);
                assert_eq!(multiply_high(a, b), (product >> 32) as u32);
            }
        }
    }

    #[test]
    fn roots_are_whole() {
        for root in (0..=65_535).step_by(17).chain([65_534, 65_535]) {
            let square: u32 = root * root;
            let next = square.saturating_add(2 * root);
            for x in [square.saturating_sub(1), square, square + 1, next, next.saturating_add(1)] {
                assert_eq!(isqrt(x), x.isqrt());
            }
        }
        assert_eq!(isqrt(u32::MAX), 65_535);
    }
}
