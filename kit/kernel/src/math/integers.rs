//! Functions of integers that the compiler for GPUs lacks, and bit fields.

use glam::{IVec4, UVec4};

use super::{min, sqrt};
use crate::pack::{unpack_signed_4x8, unpack_unsigned_4x8};

/// Integers of up to 32 bits.
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

macro_rules! small_integers {
    ($($integer:ident),*) => {$(
        impl Integer for $integer {
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                (self as i32 + other as i32).max(Self::MIN as i32).min(Self::MAX as i32) as Self
            }

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                (self as i32 - other as i32).max(Self::MIN as i32).min(Self::MAX as i32) as Self
            }
        }
    )*};
}
small_integers!(u8, i8, u16, i16);

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

/// Integers of 32 bits that are made of bit fields.
pub trait BitField: Copy {
    /// See [`extract_bits`].
    #[doc(hidden)]
    fn extract(self, offset: u32, count: u32) -> Self;
    /// See [`insert_bits`].
    #[doc(hidden)]
    fn insert(self, field: Self, offset: u32, count: u32) -> Self;
}

/// `count` bits from `offset` on, of those that a word has.
#[inline(always)]
fn mask(offset: u32, count: u32) -> u32 {
    // a shift by 32 is none on some devices
    let ones = if count < 32 { (1 << count) - 1 } else { !0 };
    if offset < 32 { ones << offset } else { 0 }
}

impl BitField for u32 {
    #[inline(always)]
    fn extract(self, offset: u32, count: u32) -> Self {
        if offset < 32 { (self >> offset) & mask(0, count) } else { 0 }
    }

    #[inline(always)]
    fn insert(self, field: Self, offset: u32, count: u32) -> Self {
        let mask = mask(offset, count);
        let moved = if offset < 32 { field << offset } else { 0 };
        self & !mask | moved & mask
    }
}

impl BitField for i32 {
    #[inline(always)]
    fn extract(self, offset: u32, count: u32) -> Self {
        let field = (self as u32).extract(offset, count);
        // as many bits as there are
        let left = if offset < 32 { 32 - offset } else { 0 };
        let bits = if count < left { count } else { left };
        if bits == 0 { 0 } else { ((field << (32 - bits)) as i32) >> (32 - bits) }
    }

    #[inline(always)]
    fn insert(self, field: Self, offset: u32, count: u32) -> Self {
        (self as u32).insert(field as u32, offset, count) as i32
    }
}

/// The field of `count` bits from `offset` on, as `extractBits` of WGSL: an `i32` keeps the field's sign. What lies beyond 32 bits is left out.
#[inline(always)]
pub fn extract_bits<I: BitField>(x: I, offset: u32, count: u32) -> I {
    x.extract(offset, count)
}

/// x with the lower `count` bits of `field` from `offset` on, as `insertBits` of WGSL. What lies beyond 32 bits is left out.
#[inline(always)]
pub fn insert_bits<I: BitField>(x: I, field: I, offset: u32, count: u32) -> I {
    x.insert(field, offset, count)
}

/// The sum of the products of four bytes each, as `dot4U8Packed` of WGSL.
#[inline(always)]
pub fn dot_unsigned_4x8(a: u32, b: u32) -> u32 {
    let UVec4 { x, y, z, w } = unpack_unsigned_4x8(a) * unpack_unsigned_4x8(b);
    x + y + z + w
}

/// The sum of the products of four signed bytes each, as `dot4I8Packed` of WGSL.
#[inline(always)]
pub fn dot_signed_4x8(a: u32, b: u32) -> i32 {
    let IVec4 { x, y, z, w } = unpack_signed_4x8(a) * unpack_signed_4x8(b);
    x + y + z + w
}

#[cfg(test)]
mod tests {
    use super::*;

    // the parity of `integer_functions` has their values at the edges
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

    #[test]
    fn fields_have_the_bits_of_a_word() {
        let word = 0xdead_beef_u32;
        for (offset, count) in (0..70).flat_map(|offset| (0..70).map(move |count| (offset, count)))
        {
            let bits = (0..32).filter(|bit| (offset..offset + count).contains(bit));
            let field = bits.clone().map(|bit| (word >> bit & 1) << (bit - offset)).sum::<u32>();
            assert_eq!(extract_bits(word, offset, count), field, "{offset} {count}");
            let len = bits.clone().count() as u32;
            let signed = if len > 0 && field >> (len - 1) & 1 == 1 {
                i64::from(field) - (1 << len)
            } else {
                field.into()
            };
            assert_eq!(
                i64::from(extract_bits(word as i32, offset, count)),
                signed,
                "{offset} {count}"
            );
            let kept: u32 = bits.map(|bit| 1 << bit).sum();
            let inserted = insert_bits(word, !field, offset, count);
            assert_eq!(inserted, word ^ kept, "{offset} {count}");
        }
    }
}
