//! Numbers as 16-bit floats (halves).

use half::f16;
use half::slice::HalfFloatSliceExt;
use organza_shaders::hash_grid_half::MAX_HALF;

use crate::error::{IN_MEMORY, Result, invalid};

/// Rounds each value to the nearest half, or to zero below 2^-14, where drivers may flush to zero.
pub fn halves(values: &[f32]) -> Vec<f16> {
    let mut halves = vec![f16::ZERO; values.len()];
    halves.convert_from_f32_slice(values);
    halves.iter_mut().filter(|half| !half.is_normal()).for_each(|half| *half = f16::ZERO);
    halves
}

/// A table `[entries, features]` as [`hash_grid_half`](organza_shaders::hash_grid_half) reads it,
/// `[entries, ceil(features / 2)]`: each value rounded to the nearest half, or to zero below 2^-14.
///
/// # Errors
/// [`Error::Invalid`](crate::Error::Invalid) if a value is too large for a half.
pub fn pack_halves(table: &[f32], features: usize, name: &str) -> Result<Vec<u32>> {
    if let Some(value) = table.iter().find(|value| value.abs() > MAX_HALF) {
        return invalid(
            IN_MEMORY,
            format!(
                "`{name}` has the value {value}, but halves end at {MAX_HALF}; leave out `--half-grids`"
            ),
        );
    }
    Ok(halves(table).chunks(features).flat_map(|entry| entry.chunks(2).map(word)).collect())
}

/// One or two halves in a word, the first in the lower bits.
fn word(pair: &[f16]) -> u32 {
    let upper = pair.get(1).map_or(0, |half| half.to_bits());
    u32::from(upper) << 16 | u32::from(pair[0].to_bits())
}

#[cfg(test)]
mod tests {
    use muslin::half::half_value;

    use super::*;

    /// Tests every half exactly, the middle between it and the next, and the f32 next to that middle.
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

    #[test]
    fn entries_are_whole_words() {
        let words = pack_halves(&[1.0, 2.0, -0.5, 1e-6, 65_504.0, 0.1], 3, "a grid").unwrap();
        let value = |word: u32, upper: bool| half_value(word >> (16 * u32::from(upper)) & 0xffff);
        assert_eq!(words.len(), 4);
        assert_eq!((value(words[0], false), value(words[0], true)), (1.0, 2.0));
        assert_eq!((value(words[1], false), value(words[1], true)), (-0.5, 0.0));
        assert_eq!((value(words[2], false), value(words[2], true)), (0.0, 65_504.0));
        assert!((value(words[3], false) - 0.1).abs() < 0.1 / 2048.0);
        let error = pack_halves(&[1.0, 1e5], 2, "color_grid").unwrap_err().to_string();
        assert!(error.contains("color_grid") && error.contains("100000"), "{error}");
    }
}
