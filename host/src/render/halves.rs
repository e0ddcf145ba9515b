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
    use super::*;

    /// Every half with all its digits, what lies between it and the next, and the numbers next to that.
    #[test]
    fn values_are_rounded_to_the_nearest_half() {
        for bits in f16::MIN_POSITIVE.to_bits()..f16::MAX.to_bits() {
            let below = f16::from_bits(bits);
            let above = f16::from_bits(bits + 1);
            // both and their middle are exact in f32
            let middle = (below.to_f32() + above.to_f32()) / 2.0;
            let even = if bits % 2 == 0 { below } else { above };
            for (value, expected) in [
                (below.to_f32(), below),
                (middle.next_down(), below),
                (middle, even),
                (middle.next_up(), above),
            ] {
                assert_eq!(halves(&[value, -value]), [expected, -expected], "{value:e}");
            }
        }
        let smallest = f16::MIN_POSITIVE.to_f32();
        assert_eq!(halves(&[0.0, 0.99 * smallest, -0.99 * smallest]), [f16::ZERO; 3]);
    }
}
