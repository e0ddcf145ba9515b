//! 16-bit floats (halves). [`pack_half_2x16`](crate::math::pack_half_2x16) puts two into a word.

/// The value of a half, from its 16 bits.
#[inline(always)]
pub fn half_value(bits: u32) -> f32 {
    let sign = (bits & 0x8000) << 16;
    let size = bits & 0x7fff;
    // moves the exponent to its place in a float
    let moved = size << 13;
    let value = if size < 0x400 {
        // smaller than 2^-14: a multiple of 2^-24. A float of the moved bits would be a denormal, which a GPU can flush.
        (size as f32 * TWO_TO_MINUS_24).to_bits()
    } else if size < 0x7c00 {
        moved + ((127 - 15) << 23)
    } else {
        // infinity and NaN
        moved | 0x7f80_0000
    };
    f32::from_bits(sign | value)
}

/// The value of a half that is 0 or at least 2^-14, and finite: with fewer instructions than [`half_value`].
#[inline(always)]
pub fn normal_half_value(bits: u32) -> f32 {
    let moved = f32::from_bits((bits & 0x8000) << 16 | (bits & 0x7fff) << 13);
    // only the difference of the biases is missing
    moved * TWO_TO_112
}

/// The 16 bits of the nearest half, of two the even one; infinity from 65,520 on.
#[inline(always)]
pub fn half_bits(x: f32) -> u32 {
    let bits = x.to_bits();
    let sign = bits >> 16 & 0x8000;
    let size = bits & 0x7fff_ffff;
    let exponent = size >> 23;
    // digits after a half's: more for what is smaller than 2^-14, a multiple of 2^-24
    let (value, dropped) = if exponent < 113 {
        let digits = size & 0x7f_ffff | 0x80_0000;
        // 2^-26 is less than half of the smallest one
        (digits, if exponent < 101 { 25 } else { 126 - exponent })
    } else {
        (size - ((127 - 15) << 23), 13)
    };
    let kept = value >> dropped;
    let rest = value & ((1 << dropped) - 1);
    let half = 1 << (dropped - 1);
    let is_up = rest > half || rest == half && kept & 1 == 1;
    let rounded = kept + u32::from(is_up);
    let finite = if rounded > 0x7c00 { 0x7c00 } else { rounded };
    // a NaN keeps a digit
    sign | if size > 0x7f80_0000 { 0x7e00 } else { finite }
}

/// 2^112, the ratio of the biases: 127 - 15 = 112.
const TWO_TO_112: f32 = f32::from_bits((127 + 112) << 23);

/// The smallest half.
const TWO_TO_MINUS_24: f32 = f32::from_bits((127 - 24) << 23);

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest half of a number below 65,520, in f64.
    fn nearest(x: f64) -> f64 {
        let unit = libm::exp2(libm::floor(libm::log2(libm::fabs(x))).max(-14.0) - 10.0);
        libm::rint(x / unit) * unit
    }

    #[test]
    fn every_half_is_its_own_and_others_become_the_nearest() {
        for bits in 0..=0xffff {
            let value = half_value(bits);
            if value.is_nan() {
                assert!(half_value(half_bits(value)).is_nan(), "{bits:x}");
                continue;
            }
            assert_eq!(half_bits(value), bits, "{value}");
            // numbers beside it, half way to the next one, and beside that
            let next = half_value(bits + 1);
            if !next.is_finite() || bits == 0x7fff {
                continue;
            }
            let middle = (value + next) / 2.0;
            for x in [value.next_up(), middle.next_down(), middle, middle.next_up()] {
                assert_eq!(f64::from(half_value(half_bits(x))), nearest(x.into()), "{x:e}");
            }
        }
        for (x, bits) in [(65_519.996, 0x7bff), (65_520.0, 0x7c00), (f32::MAX, 0x7c00)] {
            assert_eq!(half_bits(x), bits);
            assert_eq!(half_bits(-x), bits | 0x8000);
        }
        assert_eq!([f32::INFINITY, f32::NEG_INFINITY].map(half_bits), [0x7c00, 0xfc00]);
        assert_eq!([1e-40, -1e-40, 2e-8, 4e-8].map(half_bits), [0, 0x8000, 0, 1]);
    }
}
