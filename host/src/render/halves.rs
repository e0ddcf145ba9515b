//! Numbers as 16-bit floats (halves).

use half::f16;
use half::slice::HalfFloatSliceExt;

/// The half nearest to each value, or zero below 2^-14, where drivers may make zero of it.
pub fn halves(values: &[f32]) -> Vec<f16> {
    let mut halves = vec![f16::ZERO; values.len()];
    halves.convert_from_f32_slice(values);
    halves.iter_mut().filter(|half| !half.is_normal()).for_each(|half| *half = f16::ZERO);
    halves
}

#[cfg(test)]
mod tests {
    use organza_kernel::half::round_to_half;

    use super::*;

    /// Every half, what lies between two of them, and the numbers next to that.
    #[test]
    fn values_are_rounded_as_halves_are() {
        for bits in 0..f16::MAX.to_bits() {
            let [below, above] = [bits, bits + 1].map(|bits| f16::from_bits(bits).to_f32());
            let middle = (below + above) / 2.0;
            for value in [below, above, middle.next_down(), middle, middle.next_up()] {
                for value in [value, -value] {
                    let expected = f16::from_f32(value).to_f32();
                    assert_eq!(round_to_half(value), expected, "{value:e}");
                }
            }
        }
    }

    /// A product or a sum of halves in `f32`, rounded to a half, is the half nearest to the exact one.
    #[test]
    fn rounding_twice_is_rounding_once() {
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let half = f16::from_bits((state >> 16) as u16);
            if half.is_finite() { half } else { f16::ONE }
        };
        let largest = f64::from(f16::MAX.to_f32());
        for _ in 0..1_000_000 {
            let (a, b) = (random(), random());
            let (x, y) = (a.to_f64(), b.to_f64());
            // exact in f64: 22 digits, and 40 at most
            for (exact, found) in
                [(x * y, a.to_f32() * b.to_f32()), (x + y, a.to_f32() + b.to_f32())]
            {
                if exact.abs() < largest {
                    let expected = f16::from_f64(exact).to_f32();
                    assert_eq!(round_to_half(found), expected, "{x:e} and {y:e}");
                }
            }
        }
    }
}
