//! PlayCanvas' compressed PLY: 256 neighbors are a chunk, and each value is a fraction of the chunk's range. A Gaussian has 16
//! bytes, and one for each harmonic but the first.

use std::io::Read;
use std::path::Path;

use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use super::ply::{row, said};
use super::{Splat, SplatFile, logit_of, with_largest};
use crate::harmonics::{FIRST, HARMONICS, MIDDLE};
use organza_core::error::{Result, invalid};
use organza_data::ply::{Ply, number};

/// Gaussians of a chunk.
const CHUNK: usize = 256;
/// Lowest and highest values of a chunk. Old files have none of the colors.
const RANGES: [&str; 18] = [
    "min_x",
    "min_y",
    "min_z",
    "max_x",
    "max_y",
    "max_z",
    "min_scale_x",
    "min_scale_y",
    "min_scale_z",
    "max_scale_x",
    "max_scale_y",
    "max_scale_z",
    "min_r",
    "min_g",
    "min_b",
    "max_r",
    "max_g",
    "max_b",
];
const OLD_RANGES: usize = 12;
const WORDS: [&str; 4] = ["packed_position", "packed_rotation", "packed_scale", "packed_color"];
/// Coefficients of all harmonics but the first.
const REST: usize = 3 * (HARMONICS - 1);
/// Bits of three values in a word, the first in the upper ones.
const BITS: [u32; 3] = [11, 10, 11];
/// A harmonic is a byte over this range around 0.
const REST_RANGE: f32 = 8.0;
/// The middle and the range of a quaternion's three smaller parts, which lie between -sqrt(1/2) and sqrt(1/2).
const PART: [f32; 2] = [-std::f32::consts::FRAC_1_SQRT_2, std::f32::consts::FRAC_1_SQRT_2];

/// Lowest and highest values of a chunk, on each axis.
struct Ranges {
    position: [[f32; 2]; 3],
    log_scale: [[f32; 2]; 3],
    color: [[f32; 2]; 3],
}

impl Ranges {
    /// Of values in the order of [`RANGES`].
    fn read(values: &[f32; RANGES.len()]) -> Self {
        let kind =
            |first: usize| [0, 1, 2].map(|axis| [values[first + axis], values[first + 3 + axis]]);
        Self { position: kind(0), log_scale: kind(6), color: kind(12) }
    }

    /// A Gaussian of words in the order of [`WORDS`].
    fn splat(&self, words: [u32; WORDS.len()], rest: &[u8], others: usize) -> Splat {
        let [position, rotation, scale, color] = words;
        let three = |word: u32, ranges: &[[f32; 2]; 3]| {
            let shifts = [21, 11, 0];
            [0, 1, 2].map(|axis| {
                let max = (1 << BITS[axis]) - 1;
                value(word >> shifts[axis] & max, ranges[axis], max)
            })
        };
        let part = |shift: u32| value(rotation >> shift & 1023, PART, 1023);
        let base = [0, 1, 2]
            .map(|axis| value(color >> (24 - 8 * axis) & 255, self.color[axis as usize], 255));
        Splat {
            position: three(position, &self.position),
            rotation: with_largest((rotation >> 30) as usize, [part(20), part(10), part(0)]),
            log_scale: three(scale, &self.log_scale),
            opacity: logit_of((color & 255) as u8),
            color: std::array::from_fn(|harmonic| match harmonic {
                0 => base.map(|value| (value - MIDDLE) / FIRST),
                _ if harmonic > others => [0.0; 3],
                _ => [0, 1, 2].map(|channel| match rest[channel * others + harmonic - 1] {
                    // the ends of the range are exact, as PlayCanvas reads them
                    0 => -0.5 * REST_RANGE,
                    255 => 0.5 * REST_RANGE,
                    byte => ((f32::from(byte) + 0.5) / 256.0 - 0.5) * REST_RANGE,
                }),
            }),
        }
    }
}

/// The value of a level from 0 to `max` in a range.
fn value(level: u32, [low, high]: [f32; 2], max: u32) -> f32 {
    let part = level as f32 / max as f32;
    low * (1.0 - part) + high * part
}

row!(Chunk, f32, RANGES.len(), |key: &str| RANGES.iter().position(|name| *name == key));
row!(Words, u32, WORDS.len(), |key: &str| WORDS.iter().position(|name| *name == key));
row!(Rest, u8, REST, |key: &str| key.strip_prefix("f_rest_")?.parse().ok());

/// Reads the elements of an opened file. Errors name `path`.
pub fn read<R: Read>(mut file: Ply<'_, R>, path: &Path) -> Result<SplatFile> {
    let has_colors = file.properties("chunk").any(|name| name == "min_r");
    let rest = file.properties("sh").filter(|name| name.starts_with("f_rest_")).count();
    if ![0, 9, 24, 45].contains(&rest) {
        let reason = format!(
            "`sh` elements have {rest} properties `f_rest_*`, expected 0, 9, 24 or 45: harmonics of degree 0 to 3"
        );
        return invalid(path, reason);
    }
    let needed = if has_colors { &RANGES[..] } else { &RANGES[..OLD_RANGES] };
    let mut chunks: Vec<Chunk> = file.element("chunk", needed)?;
    let words: Vec<Words> = file.element("vertex", &WORDS)?;
    let bytes: Vec<Rest> = if rest > 0 { file.element("sh", &[])? } else { Vec::new() };
    let count = words.len();
    if chunks.len() != count.div_ceil(CHUNK) || (rest > 0 && bytes.len() != count) {
        let reason = format!(
            "it has {count} Gaussians, {} chunks and {} rows of harmonics; expected a chunk for each {CHUNK}, and a row \
             for each",
            chunks.len(),
            bytes.len()
        );
        return invalid(path, reason);
    }
    if !has_colors {
        chunks.iter_mut().for_each(|chunk| chunk.0[15..].fill(1.0));
    }
    let ranges: Vec<_> = chunks.iter().map(|chunk| Ranges::read(&chunk.0)).collect();
    let splat = |(index, words): (usize, Words)| {
        let bytes = bytes.get(index).map_or(&[][..], |rest| &rest.0);
        ranges[index / CHUNK].splat(words.0, bytes, rest / 3)
    };
    let splats = words.into_iter().enumerate().map(splat).collect();
    Ok(SplatFile::new(path, "compressed PLY", splats).placed(said(&file, path)?))
}

#[cfg(test)]
mod tests {
    use muslin::math::sigmoid;

    use super::super::tests::{assert_refused, read_bytes};
    use super::*;

    /// One Gaussian with values that are exact, as text: what PlayCanvas' description says of each bit.
    fn text() -> String {
        let mut text = "ply\nformat ascii 1.0\nelement chunk 1\n".to_owned();
        RANGES.iter().for_each(|name| text += &format!("property float {name}\n"));
        text += "element vertex 1\n";
        WORDS.iter().for_each(|name| text += &format!("property uint {name}\n"));
        text += "element sh 1\n";
        (0..9).for_each(|index| text += &format!("property uchar f_rest_{index}\n"));
        text += "end_header\n-1 -2 -3 1 2 3 -4 -5 -6 -1 -1 -1 0.5 0 0 1 1 1\n";
        // x is the lowest, y the highest, z the lowest; the first part of the quaternion is the largest, and y is sqrt(1/2)
        let position = 1023 << 11;
        let rotation = 512 << 20 | 1023 << 10 | 512;
        let scale = 2047_u32 << 21;
        let color = 255_u32 << 24 | 255 << 8 | 51;
        text += &format!("{position} {rotation} {scale} {color}\n");
        text + "0 255 128 0 0 0 64 64 64\n"
    }

    #[test]
    fn packed_bits_follow_the_description() {
        let [splat] = read_bytes(text().as_bytes()).unwrap()[..] else { panic!("one Gaussian") };
        assert_eq!(splat.position, [-1.0, 2.0, -3.0]);
        assert_eq!(splat.log_scale, [-1.0, -5.0, -6.0]);
        let half = std::f32::consts::FRAC_1_SQRT_2;
        for (found, expected) in splat.rotation.iter().zip([half, 0.0, half, 0.0]) {
            assert!((found - expected).abs() < 1e-3, "{:?}", splat.rotation);
        }
        assert!((sigmoid(splat.opacity) - 0.2).abs() < 1e-6);
        assert_eq!(super::super::base_color(&splat), [1.0, 0.0, 1.0]);
        let middle = (128.5 / 256.0 - 0.5) * 8.0;
        let quarter = (64.5 / 256.0 - 0.5) * 8.0;
        let red = [-4.0, 4.0, middle];
        for (harmonic, red) in splat.color[1..4].iter().zip(red) {
            assert_eq!(*harmonic, [red, -4.0, quarter]);
        }
        assert_eq!(splat.color[4..], [[0.0; 3]; 12]);
        // old files have colors from 0 to 1
        let old = text().replace("min_r", "other");
        let [splat] = read_bytes(old.as_bytes()).unwrap()[..] else { panic!("one Gaussian") };
        assert_eq!(super::super::base_color(&splat), [1.0, 0.0, 1.0]);
    }

    #[test]
    fn bad_files_are_refused_with_a_reason() {
        let text = text();
        for length in 0..text.len() - 20 {
            assert_refused(&text.as_bytes()[..length], &[]);
        }
        let with = |from: &str, to: &str| text.replace(from, to);
        assert_refused(
            with("max_x", "other").as_bytes(),
            &["`chunk` elements", "no property `max_x`"],
        );
        assert_refused(with("packed_color", "other").as_bytes(), &["no property `packed_color`"]);
        assert_refused(with("f_rest_8", "other").as_bytes(), &["8 properties `f_rest_*`"]);
        assert_refused(with("-1 -2 -3", "nan -2 -3").as_bytes(), &[]);
        assert_refused(with("-1 -2 -3", "-1 1e39 -3").as_bytes(), &["Gaussian 0", "NaN"]);
        let rows = format!("end_header\n{}\n", ["0"; RANGES.len()].join(" "));
        let two = with("chunk 1", "chunk 2").replace("end_header\n", &rows);
        assert_refused(two.as_bytes(), &["1 Gaussians, 2 chunks"]);
    }
}
