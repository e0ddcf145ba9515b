//! Niantic's SPZ: a header of 16 bytes and an array for each attribute, quantized, in gzip. Writes version 2, which
//! all readers know. Reads version 3, too.

use std::io::{self, Read, Write};
use std::path::Path;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use muslin::math::sigmoid;
use muslin_device::memory;

use super::{Splat, byte, invalid, turned};
use crate::harmonics::{DEGREE, HARMONICS};
use organza_core::error::Result;
use organza_core::scene::logit;

const MAGIC: u32 = 0x5053_474e;
const VERSION: u32 = 2;
/// Most bits in the fraction of a coordinate, which is an integer of 24 bits.
const MOST_FRACTION: i32 = 20;
/// Factor and offset that turn the logarithm of a scale into a byte.
const SCALE: [f32; 2] = [16.0, 160.0];
/// Factor and offset for a first harmonic.
const COLOR: [f32; 2] = [0.15 * 255.0, 127.5];
/// Factor and offset for any other harmonic.
const REST: [f32; 2] = [128.0, 128.0];
/// Most bytes that one byte of gzip can expand to.
const MOST_PACKED: u64 = 1032;

pub fn write(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    let fraction = fraction(splats);
    let mut file = GzEncoder::new(file, Compression::best());
    for word in [MAGIC, VERSION, splats.len() as u32] {
        file.write_all(&word.to_le_bytes())?;
    }
    // degree, bits of a coordinate's fraction, flags, reserved
    file.write_all(&[DEGREE as u8, fraction as u8, 0, 0])?;
    for value in splats.iter().flat_map(|splat| splat.position) {
        let fixed = (value * 2_f32.powi(fraction)).round().clamp(-8_388_608.0, 8_388_607.0);
        file.write_all(&(fixed as i32).to_le_bytes()[..3])?;
    }
    for splat in splats {
        file.write_all(&[byte(255.0 * sigmoid(splat.opacity))])?;
    }
    for splat in splats {
        file.write_all(&splat.color[0].map(|value| byte(value * COLOR[0] + COLOR[1])))?;
    }
    for splat in splats {
        file.write_all(&splat.log_scale.map(|value| byte(value * SCALE[0] + SCALE[1])))?;
    }
    for [w, x, y, z] in splats.iter().map(turned) {
        // q and -q are the same rotation; w follows from the length of 1, and is not negative
        let sign = if w < 0.0 { -127.5 } else { 127.5 };
        file.write_all(&[x, y, z].map(|part| byte(sign * part + 127.5)))?;
    }
    for splat in splats {
        for (index, harmonic) in splat.color.iter().enumerate().skip(1) {
            // like Niantic, with fewer levels than a byte has: five bits for degree 1, four for the others
            let step = if index < 4 { 8.0 } else { 16.0 };
            let packed =
                harmonic.map(|value| byte(((value * REST[0] + REST[1]) / step).round() * step));
            file.write_all(&packed)?;
        }
    }
    file.finish().map(drop)
}

/// Most bits of the fraction with which all coordinates fit.
fn fraction(splats: &[Splat]) -> i32 {
    let largest = splats
        .iter()
        .flat_map(|splat| splat.position)
        .fold(0.0, |most: f32, value| if value.is_finite() { most.max(value.abs()) } else { most });
    (0..=MOST_FRACTION).rev().find(|&bits| largest * 2_f32.powi(bits) < 8_388_607.0).unwrap_or(0)
}

pub fn read(source: impl Read, length: u64, path: &Path) -> Result<Vec<Splat>> {
    let mut source = GzDecoder::new(source);
    let mut header = [0; 16];
    fill(&mut source, &mut header, path)?;
    let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|byte| header[4 * at + byte]));
    let [degree, fraction, ..] = [header[12], header[13]];
    if word(0) != MAGIC {
        return invalid(path, "it is packed with gzip, but it is not an SPZ file");
    }
    let version = word(1);
    if ![2, 3].contains(&version) || degree > DEGREE as u8 || fraction > 23 {
        return invalid(
            path,
            format!(
                "it is an SPZ file of version {version} with harmonics of degree {degree} and coordinates of \
                 {fraction} bits behind the point; expected version 2 or 3, degree 0 to 3, and at most 23 bits"
            ),
        );
    }
    let count = word(2) as usize;
    let others = (usize::from(degree) + 1).pow(2) - 1;
    let rotation_bytes = version as usize + 1;
    let needed = 16 + count as u64 * (9 + 1 + 3 + 3 + rotation_bytes as u64 + 3 * others as u64);
    if needed > length.saturating_mul(MOST_PACKED) {
        let reason = format!(
            "its header has {count} Gaussians, more than {length} bytes can hold; the file was cut short or is \
             damaged"
        );
        return invalid(path, reason);
    }
    memory::check(count as u64 * (size_of::<Splat>() + 9) as u64, "the Gaussians of an SPZ file")?;
    let mut splats: Vec<Splat> = memory::zeros(count, "the Gaussians of an SPZ file")?;
    let mut array = |width: usize| {
        let mut bytes = memory::zeros::<u8>(count * width, "the Gaussians of an SPZ file")?;
        fill(&mut source, &mut bytes, path)?;
        Ok::<_, organza_core::Error>(bytes)
    };
    let unit = 2_f32.powi(-i32::from(fraction));
    for (value, fixed) in values(&mut splats, |splat| &mut splat.position).zip(array(9)?.chunks(3))
    {
        // the upper bytes of an i32 keep the sign
        let fixed = i32::from_le_bytes([0, fixed[0], fixed[1], fixed[2]]) >> 8;
        *value = fixed as f32 * unit;
    }
    for (splat, byte) in splats.iter_mut().zip(array(1)?) {
        // opacities of 0 and 1 have no finite logit
        let opacity = f32::from(byte).clamp(0.25, 254.75) / 255.0;
        splat.opacity = logit(opacity);
    }
    let number = |byte: u8, [factor, offset]: [f32; 2]| (f32::from(byte) - offset) / factor;
    for (value, byte) in values(&mut splats, |splat| &mut splat.color[0]).zip(array(3)?) {
        *value = number(byte, COLOR);
    }
    for (value, byte) in values(&mut splats, |splat| &mut splat.log_scale).zip(array(3)?) {
        *value = number(byte, SCALE);
    }
    let rotations = array(rotation_bytes)?;
    for (splat, bytes) in splats.iter_mut().zip(rotations.chunks(rotation_bytes)) {
        splat.rotation = match *bytes {
            [x, y, z] => rotation([x, y, z]),
            _ => smallest_three(std::array::from_fn(|at| bytes[at])),
        };
    }
    let rest = array(3 * others)?;
    for (splat, bytes) in splats.iter_mut().zip(rest.chunks((3 * others).max(1))) {
        for (harmonic, bytes) in splat.color[1..HARMONICS].iter_mut().zip(bytes.chunks(3)) {
            *harmonic = std::array::from_fn(|channel| number(bytes[channel], REST));
        }
    }
    Ok(splats)
}

/// Three values of each Gaussian.
fn values(
    splats: &mut [Splat],
    of: fn(&mut Splat) -> &mut [f32; 3],
) -> impl Iterator<Item = &mut f32> {
    splats.iter_mut().flat_map(of)
}

/// Version 2: x, y and z of a unit quaternion whose w is not negative.
fn rotation(bytes: [u8; 3]) -> [f32; 4] {
    let [x, y, z] = bytes.map(|byte| f32::from(byte) / 127.5 - 1.0);
    [(1.0 - x * x - y * y - z * z).max(0.0).sqrt(), x, y, z]
}

/// Version 3: two bits have the index of the largest of x, y, z and w. The others have ten bits each: a sign, and a
/// fraction of sqrt(1/2).
fn smallest_three(bytes: [u8; 4]) -> [f32; 4] {
    let mut bits = u32::from_le_bytes(bytes);
    let largest = (bits >> 30) as usize;
    let mut xyzw = [0.0_f32; 4];
    for at in (0..4).rev().filter(|&at| at != largest) {
        let size = std::f32::consts::FRAC_1_SQRT_2 * (bits & 511) as f32 / 511.0;
        xyzw[at] = if bits & 512 != 0 { -size } else { size };
        bits >>= 10;
    }
    xyzw[largest] = (1.0 - xyzw.iter().map(|part| part * part).sum::<f32>()).max(0.0).sqrt();
    let [x, y, z, w] = xyzw;
    [w, x, y, z]
}

fn fill(source: &mut impl Read, bytes: &mut [u8], path: &Path) -> Result<()> {
    source.read_exact(bytes).or_else(|_| {
        invalid(path, "not a whole SPZ file: it was cut short or is damaged; copy it again, or write it again")
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_refused, splats};
    use super::*;

    fn packed(splats: &[Splat]) -> Vec<u8> {
        let mut bytes = Vec::new();
        write(splats, &mut bytes).unwrap();
        bytes
    }

    #[test]
    fn what_was_written_is_read_as_close_as_the_format_allows() {
        let splats = splats();
        let bytes = packed(&splats);
        let again =
            super::super::read_from(&bytes[..], bytes.len() as u64, Path::new("a.spz")).unwrap();
        assert_eq!(again.len(), splats.len());
        let largest =
            |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        for (found, expected) in again.iter().zip(&splats) {
            assert!(largest(&found.position, &expected.position) < 1e-5);
            assert!(largest(&found.log_scale, &expected.log_scale) <= 0.5 / 16.0 + 1e-5);
            let opacities = [sigmoid(found.opacity), sigmoid(expected.opacity)];
            assert!((opacities[0] - opacities[1]).abs() < 0.51 / 255.0, "{opacities:?}");
            assert!(largest(&found.color[0], &expected.color[0]) < 0.51 / (0.15 * 255.0));
            let found_rest = &found.color[1..];
            let rest = &expected.color[1..];
            assert!(largest(found_rest.as_flattened(), rest.as_flattened()) < 8.1 / 128.0);
            let dot: f32 = found.rotation.iter().zip(turned(expected)).map(|(a, b)| a * b).sum();
            assert!(dot.abs() > 0.999, "{dot}");
        }
        // gzip's checksum and end are not needed
        for length in 0..bytes.len() - 16 {
            assert_refused(&bytes[..length], &[]);
        }
    }

    #[test]
    fn quaternions_of_version_3() {
        // a half turn around x: the largest is x, with index 0
        assert_eq!(smallest_three(0_u32.to_le_bytes()), [0.0, 1.0, 0.0, 0.0]);
        // y is -sqrt(1/2), so w is sqrt(1/2): the largest has index 3; x, y and z follow
        let bits: u32 = (3 << 30) | ((512 | 511) << 10);
        let [w, x, y, z] = smallest_three(bits.to_le_bytes());
        let half = std::f32::consts::FRAC_1_SQRT_2;
        assert!((w - half).abs() < 1e-6 && (y + half).abs() < 1e-6 && x == 0.0 && z == 0.0);
    }

    #[test]
    fn errors_say_what_is_wrong() {
        let with = |at: usize, word: u32| {
            let mut bytes = Vec::new();
            GzDecoder::new(&packed(&splats())[..]).read_to_end(&mut bytes).unwrap();
            bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
            let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
            packed.write_all(&bytes).unwrap();
            packed.finish().unwrap()
        };
        assert_refused(&with(0, 7), &["not an SPZ"]);
        assert_refused(&with(4, 9), &["version 9"]);
        assert_refused(&with(12, 5), &["degree 5"]);
        assert_refused(&with(8, u32::MAX), &["4294967295 Gaussians", "cut short"]);
        assert_refused(&with(8, 0), &["no Gaussians"]);
    }
}
