//! 16-bit floats (halves).

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

/// 2^112, the ratio of the biases: 127 - 15 = 112.
const TWO_TO_112: f32 = f32::from_bits((127 + 112) << 23);

/// The smallest half.
const TWO_TO_MINUS_24: f32 = f32::from_bits((127 - 24) << 23);

#[cfg(test)]
mod tests {
    use super::*;

    /// As Rust's own numbers have it: digits of 2^-10, and an exponent.
    fn exact(bits: u32) -> f64 {
        let digits = f64::from(bits & 0x3ff) / 1024.0;
        let size = match bits >> 10 & 31 {
            0 => digits * libm::exp2(-14.0),
            31 if digits == 0.0 => f64::INFINITY,
            31 => f64::NAN,
            exponent => (1.0 + digits) * libm::exp2(f64::from(exponent) - 15.0),
        };
        if bits & 0x8000 == 0 { size } else { -size }
    }

    #[test]
    fn every_half_has_its_value() {
        for bits in 0..=0xffff {
            let [found, exact] = [f64::from(half_value(bits)), exact(bits)];
            assert!(found == exact || found.is_nan() && exact.is_nan(), "{bits:x}: {found}");
            if exact == 0.0 || exact.is_finite() && libm::fabs(exact) >= libm::exp2(-14.0) {
                assert_eq!(f64::from(normal_half_value(bits)), exact, "{bits:x}");
            }
        }
    }
}
