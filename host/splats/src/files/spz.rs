//! Niantic's SPZ: an array for each attribute, quantized and compressed. Version 4 has a header of 32 bytes, and each array in
//! a Zstandard stream of its own; versions 2 and 3 have a header of 16 bytes before the arrays, all in gzip.
//! <https://github.com/nianticlabs/spz#file-format>

use std::io::{self, Read, Write};
use std::path::Path;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use muslin::math::sigmoid;
use muslin_device::memory;

use super::{Splat, byte, invalid, logit_of, smallest_three, turned, with_largest};
use crate::harmonics::{DEGREE, HARMONICS};
use organza_core::error::Result;

const MAGIC: u32 = 0x5053_474e;
/// Bytes of the header of version 4.
const HEADER: usize = 32;
/// Bytes of a stream in version 4's table: its length, and that of what it unpacks to.
const ENTRY: usize = 16;
/// Zstandard's level, of 1 to 22.
const LEVEL: i32 = 12;
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
/// The same of Zstandard: four bytes can repeat one byte in a block of 128 KiB.
const MOST_PACKED_4: u64 = 1 << 15;
/// Largest value of a part of a quaternion, which has 9 bits and a sign.
const MOST_PART: f32 = 511.0;

/// Writes version 4.
pub fn write(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    let fraction = fraction(splats);
    let arrays = arrays(splats, fraction, 4);
    let streams = arrays.iter().map(|array| zstd::bulk::compress(array, LEVEL));
    let streams = streams.collect::<io::Result<Vec<_>>>()?;
    for word in [MAGIC, 4, splats.len() as u32] {
        file.write_all(&word.to_le_bytes())?;
    }
    // degree, bits of a coordinate's fraction, flags
    file.write_all(&[DEGREE as u8, fraction as u8, 0, streams.len() as u8])?;
    file.write_all(&(HEADER as u32).to_le_bytes())?;
    file.write_all(&[0; 12])?;
    for (stream, array) in streams.iter().zip(&arrays) {
        file.write_all(&(stream.len() as u64).to_le_bytes())?;
        file.write_all(&(array.len() as u64).to_le_bytes())?;
    }
    streams.iter().try_for_each(|stream| file.write_all(stream))
}

/// Writes version 2.
pub fn write_2(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    let fraction = fraction(splats);
    let mut file = GzEncoder::new(file, Compression::best());
    for word in [MAGIC, 2, splats.len() as u32] {
        file.write_all(&word.to_le_bytes())?;
    }
    file.write_all(&[DEGREE as u8, fraction as u8, 0, 0])?;
    arrays(splats, fraction, 2).iter().try_for_each(|array| file.write_all(array))?;
    file.finish().map(drop)
}

/// The arrays in the order of the file: positions, opacities, colors, scales, rotations and harmonics.
fn arrays(splats: &[Splat], fraction: i32, version: u32) -> [Vec<u8>; 6] {
    let position = |splat: &Splat| {
        let fixed = splat.position.map(|value| (value * 2_f32.powi(fraction)).round());
        let fixed = fixed.map(|value| value.clamp(-8_388_608.0, 8_388_607.0) as i32);
        let [x, y, z] = fixed.map(i32::to_le_bytes);
        [x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]]
    };
    let color = |splat: &Splat| splat.color[0].map(|value| byte(value * COLOR[0] + COLOR[1]));
    let scale = |splat: &Splat| splat.log_scale.map(|value| byte(value * SCALE[0] + SCALE[1]));
    let rest = |splat: &Splat| -> [[u8; 3]; HARMONICS - 1] {
        std::array::from_fn(|index| {
            // like Niantic, with fewer levels than a byte has: five bits for degree 1, four for the others
            let step = if index < 3 { 8.0 } else { 16.0 };
            splat.color[index + 1]
                .map(|value| byte(((value * REST[0] + REST[1]) / step).round() * step))
        })
    };
    let rotations = match version {
        2 => splats.iter().flat_map(|splat| first_three(turned(splat))).collect(),
        _ => splats.iter().flat_map(|splat| packed_rotation(turned(splat))).collect(),
    };
    [
        splats.iter().flat_map(position).collect(),
        splats.iter().map(|splat| byte(255.0 * sigmoid(splat.opacity))).collect(),
        splats.iter().flat_map(color).collect(),
        splats.iter().flat_map(scale).collect(),
        rotations,
        splats.iter().flat_map(|splat| rest(splat).into_iter().flatten()).collect(),
    ]
}

/// Most bits of the fraction with which all coordinates fit.
fn fraction(splats: &[Splat]) -> i32 {
    let largest = splats
        .iter()
        .flat_map(|splat| splat.position)
        .fold(0.0, |most: f32, value| if value.is_finite() { most.max(value.abs()) } else { most });
    (0..=MOST_FRACTION).rev().find(|&bits| largest * 2_f32.powi(bits) < 8_388_607.0).unwrap_or(0)
}

/// The header fields of all versions.
struct Header {
    version: u32,
    count: usize,
    degree: u8,
    fraction: u8,
}

impl Header {
    /// `most` is the number of bytes that the file can expand to at most.
    fn parse(bytes: &[u8], length: u64, most: u64, versions: &[u32], path: &Path) -> Result<Self> {
        let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|byte| bytes[4 * at + byte]));
        if word(0) != MAGIC {
            return invalid(path, "it is packed with gzip, but it is not an SPZ file");
        }
        let count = word(2) as usize;
        let header = Self { version: word(1), count, degree: bytes[12], fraction: bytes[13] };
        let Self { version, degree, fraction, .. } = header;
        if !versions.contains(&version) || degree > DEGREE as u8 || fraction > 23 {
            return invalid(
                path,
                format!(
                    "it is an SPZ file of version {version} with harmonics of degree {degree} and coordinates of \
                     {fraction} bits behind the point; expected version 2, 3 or 4, degree 0 to 3, and at most 23 bits"
                ),
            );
        }
        let needed = header.widths().iter().map(|width| (width * count) as u64).sum::<u64>();
        if needed > length.saturating_mul(most) {
            let reason = format!(
                "its header has {count} Gaussians, more than {length} bytes can hold; the file was cut short or is \
                 damaged"
            );
            return invalid(path, reason);
        }
        memory::check(
            needed + (count * size_of::<Splat>()) as u64,
            "the Gaussians of an SPZ file",
        )?;
        Ok(header)
    }

    /// Harmonics but the first.
    fn others(&self) -> usize {
        (usize::from(self.degree) + 1).pow(2) - 1
    }

    /// Bytes of a Gaussian in each array.
    fn widths(&self) -> [usize; 6] {
        let rotation = if self.version == 2 { 3 } else { 4 };
        [9, 1, 3, 3, rotation, 3 * self.others()]
    }

    /// The Gaussians of the arrays.
    fn splats(&self, arrays: &[Vec<u8>; 6]) -> Result<Vec<Splat>> {
        let [positions, opacities, colors, scales, rotations, rest] = arrays;
        let mut splats: Vec<Splat> = memory::zeros(self.count, "the Gaussians of an SPZ file")?;
        let unit = 2_f32.powi(-i32::from(self.fraction));
        let coordinates = values(&mut splats, |splat| &mut splat.position);
        for (value, fixed) in coordinates.zip(positions.chunks(3)) {
            // the upper bytes of an i32 keep the sign
            let fixed = i32::from_le_bytes([0, fixed[0], fixed[1], fixed[2]]) >> 8;
            *value = fixed as f32 * unit;
        }
        for (splat, byte) in splats.iter_mut().zip(opacities) {
            splat.opacity = logit_of(*byte);
        }
        let number = |byte: u8, [factor, offset]: [f32; 2]| (f32::from(byte) - offset) / factor;
        let first = values(&mut splats, |splat| &mut splat.color[0]).zip(colors);
        first.for_each(|(value, byte)| *value = number(*byte, COLOR));
        let log_scales = values(&mut splats, |splat| &mut splat.log_scale).zip(scales);
        log_scales.for_each(|(value, byte)| *value = number(*byte, SCALE));
        for (splat, bytes) in splats.iter_mut().zip(rotations.chunks(self.widths()[4])) {
            splat.rotation = match *bytes {
                [x, y, z] => rotation([x, y, z]),
                _ => unpacked_rotation(std::array::from_fn(|at| bytes[at])),
            };
        }
        for (splat, bytes) in splats.iter_mut().zip(rest.chunks((3 * self.others()).max(1))) {
            for (harmonic, bytes) in splat.color[1..HARMONICS].iter_mut().zip(bytes.chunks(3)) {
                *harmonic = std::array::from_fn(|channel| number(bytes[channel], REST));
            }
        }
        Ok(splats)
    }
}

/// Reads version 2 or 3.
pub fn read_packed(source: impl Read, length: u64, path: &Path) -> Result<Vec<Splat>> {
    let mut source = GzDecoder::new(source);
    let mut bytes = [0; 16];
    source.read_exact(&mut bytes).or_else(|_| cut(path))?;
    let header = Header::parse(&bytes, length, MOST_PACKED, &[2, 3], path)?;
    let mut arrays = [const { Vec::new() }; 6];
    for (array, width) in arrays.iter_mut().zip(header.widths()) {
        *array = fill(&mut source, width * header.count, path)?;
    }
    header.splats(&arrays)
}

/// Reads version 4. Its extensions are skipped.
pub fn read(mut source: impl Read, length: u64, path: &Path) -> Result<Vec<Splat>> {
    let mut bytes = [0; HEADER];
    source.read_exact(&mut bytes).or_else(|_| cut(path))?;
    let header = Header::parse(&bytes, length, MOST_PACKED_4, &[4], path)?;
    let table = u64::from(u32::from_le_bytes([bytes[16], bytes[17], bytes[18], bytes[19]]));
    let streams = usize::from(bytes[15]);
    let widths = header.widths();
    let expected = widths.iter().filter(|width| **width > 0).count();
    if streams < expected || table < HEADER as u64 {
        let reason = format!(
            "its header has {streams} streams, and their table at byte {table}; expected {expected} streams, and the table \
             behind the {HEADER} bytes of the header; is the file damaged?"
        );
        return invalid(path, reason);
    }
    let skipped = table - HEADER as u64;
    if io::copy(&mut source.by_ref().take(skipped), &mut io::sink()).ok() != Some(skipped) {
        return cut(path);
    }
    let table = fill(&mut source, ENTRY * streams, path)?;
    let mut arrays = [const { Vec::new() }; 6];
    for (array, (width, entry)) in arrays.iter_mut().zip(widths.iter().zip(table.chunks(ENTRY))) {
        let packed = u64::from_le_bytes(std::array::from_fn(|at| entry[at]));
        let unpacked = u64::from_le_bytes(std::array::from_fn(|at| entry[8 + at]));
        if unpacked != (width * header.count) as u64 {
            return cut(path);
        }
        let mut stream = source.by_ref().take(packed);
        let Ok(decoder) = zstd::Decoder::new(&mut stream) else { return cut(path) };
        *array = fill(decoder, unpacked as usize, path)?;
        // what the decoder has left, so that the next stream begins where the table says
        io::copy(&mut stream, &mut io::sink()).or_else(|_| cut(path))?;
    }
    header.splats(&arrays)
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

/// The inverse of [`rotation`].
fn first_three([w, x, y, z]: [f32; 4]) -> [u8; 3] {
    // q and -q are the same rotation; w follows from the length of 1, and is not negative
    let sign = if w < 0.0 { -127.5 } else { 127.5 };
    [x, y, z].map(|part| byte(sign * part + 127.5))
}

/// From version 3: two bits have the index of the largest of x, y, z and w. The others have ten bits each: a sign, and a
/// fraction of sqrt(1/2).
fn unpacked_rotation(bytes: [u8; 4]) -> [f32; 4] {
    let bits = u32::from_le_bytes(bytes);
    let part = |shift: u32| {
        let part = bits >> shift;
        let size = std::f32::consts::FRAC_1_SQRT_2 * (part & 511) as f32 / MOST_PART;
        if part & 512 != 0 { -size } else { size }
    };
    let [x, y, z, w] = with_largest((bits >> 30) as usize, [part(20), part(10), part(0)]);
    [w, x, y, z]
}

/// The inverse of [`unpacked_rotation`].
fn packed_rotation([w, x, y, z]: [f32; 4]) -> [u8; 4] {
    let (largest, parts) = smallest_three([x, y, z, w]);
    let bits = parts.iter().fold(largest as u32, |bits, part| {
        let size = (part.abs() * std::f32::consts::SQRT_2 * MOST_PART).round().min(MOST_PART);
        bits << 10 | u32::from(*part < 0.0) << 9 | size as u32
    });
    bits.to_le_bytes()
}

/// The next bytes. Memory grows with what is there, whatever a header says.
fn fill(source: impl Read, count: usize, path: &Path) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    match source.take(count as u64).read_to_end(&mut bytes) {
        Ok(read) if read == count => Ok(bytes),
        _ => cut(path),
    }
}

fn cut<T>(path: &Path) -> Result<T> {
    invalid(
        path,
        "not a whole SPZ file: it was cut short or is damaged; copy it again, or write it again",
    )
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_close, assert_refused, read_bytes, splats};
    use super::*;

    fn packed(write: fn(&[Splat], &mut dyn Write) -> io::Result<()>) -> Vec<u8> {
        let mut bytes = Vec::new();
        write(&splats(), &mut bytes).unwrap();
        bytes
    }

    #[test]
    fn what_was_written_is_read_as_close_as_the_format_allows() {
        // three bytes of a quaternion, or three parts of ten bits
        for (bytes, rotation) in [(packed(write), 1.0 / 511.0), (packed(write_2), 0.03)] {
            let again = read_bytes(&bytes).unwrap();
            let color = 0.5 / (0.15 * 255.0);
            assert_close(&again, &splats(), [1e-5, 0.5 / 16.0, color, 8.0 / 128.0, rotation]);
            // checksums and gzip's end are not needed
            for length in 0..bytes.len() - 16 {
                assert_refused(&bytes[..length], &[]);
            }
        }
    }

    #[test]
    fn quaternions_from_version_3() {
        // a half turn around x: the largest is x, with index 0
        assert_eq!(unpacked_rotation(0_u32.to_le_bytes()), [0.0, 1.0, 0.0, 0.0]);
        // y is -sqrt(1/2), so w is sqrt(1/2): the largest has index 3; x, y and z follow
        let bits: u32 = (3 << 30) | ((512 | 511) << 10);
        let found @ [w, x, y, z] = unpacked_rotation(bits.to_le_bytes());
        let half = std::f32::consts::FRAC_1_SQRT_2;
        assert!((w - half).abs() < 1e-6 && (y + half).abs() < 1e-6 && x == 0.0 && z == 0.0);
        // q and -q are the same rotation
        let turn = [0.1, 0.7, -0.5, 0.5];
        assert_eq!(packed_rotation(turn), packed_rotation(turn.map(|part| -part)));
        let dot: f32 =
            unpacked_rotation(packed_rotation(found)).iter().zip(found).map(|(a, b)| a * b).sum();
        assert!(dot.abs() > 1.0 - 1e-6, "{dot}");
    }

    /// The header and the table are not compressed: they have the bytes of the description.
    #[test]
    fn version_4_has_the_header_of_its_description() {
        let bytes = packed(write);
        let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|byte| bytes[at + byte]));
        assert_eq!(&bytes[..4], b"NGSP");
        assert_eq!([word(4), word(8), word(16)], [4, 9, 32]);
        assert_eq!([bytes[12], bytes[14], bytes[15]], [3, 0, 6]);
        assert_eq!(bytes[20..32], [0; 12]);
        let lengths: Vec<_> =
            (0..6).map(|stream| [word(32 + 16 * stream), word(40 + 16 * stream)]).collect();
        let packed: u32 = lengths.iter().map(|[packed, _]| packed).sum();
        assert_eq!(bytes.len(), 32 + 6 * 16 + packed as usize);
        let unpacked: Vec<_> = lengths.iter().map(|[_, unpacked]| unpacked / 9).collect();
        assert_eq!(unpacked, [9, 1, 3, 3, 4, 45]);
    }

    #[test]
    fn errors_say_what_is_wrong() {
        let with = |at: usize, word: u32| {
            let mut bytes = Vec::new();
            GzDecoder::new(&packed(write_2)[..]).read_to_end(&mut bytes).unwrap();
            bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
            let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
            packed.write_all(&bytes).unwrap();
            packed.finish().unwrap()
        };
        assert_refused(&with(0, 7), &["not an SPZ"]);
        let with_4 = |at: usize, word: u32| {
            let mut bytes = packed(write);
            bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
            bytes
        };
        for with in [&with as &dyn Fn(usize, u32) -> Vec<u8>, &with_4] {
            assert_refused(&with(4, 9), &["version 9"]);
            assert_refused(&with(12, 5), &["degree 5"]);
            assert_refused(&with(8, u32::MAX), &["4294967295 Gaussians", "cut short"]);
            assert_refused(&with(8, 10), &["cut short"]);
        }
        assert_refused(&with(8, 0), &["no Gaussians"]);
        assert_refused(&with_4(12, 0x0500_1403), &["5 streams", "expected 6"]);
        assert_refused(&with_4(16, 31), &["byte 31"]);
        assert_refused(&with_4(16, u32::MAX), &["cut short"]);
        assert_refused(&with_4(32, 3), &["cut short"]);
    }
}
