//! Niantic's SPZ: an array for each attribute, quantized and compressed. Version 4 has a header of 32 bytes, and each array in
//! a Zstandard stream of its own; versions 1 to 3 have a header of 16 bytes before the arrays, all in gzip.
//! <https://github.com/nianticlabs/spz#file-format>
//!
//! Axes are right, up and back, unless an extension names others.

use std::io::{self, Read, Write};
use std::path::Path;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use glam::{DMat3, DVec3};
use half::f16;
use muslin::math::sigmoid;
use organza_core::memory;

use super::{DEGREE_4, Splat, SplatFile, byte, logit_of, smallest_three, turned, with_largest};
use crate::harmonics::{DEGREE, FILE_DEGREE, HARMONICS};
use crate::placed::turn;
use organza_core::error::{Result, invalid};
use organza_core::input::parse_json;
use organza_core::scene::Placement;
use organza_shaders::spherical_harmonics::width;

/// Cosine of the largest angle between the upward direction and the axis that is named for it: 30 degrees.
const NEAR: f64 = 0.866;
const MAGIC: u32 = 0x5053_474e;
/// Bytes of the header of version 4.
const HEADER: usize = 32;
/// Bytes of a stream's entry in version 4's table: its length, packed and unpacked.
const ENTRY: usize = 16;
/// Zstandard's level, of 1 to 22.
const LEVEL: i32 = 12;
/// Most bits in the fraction of a coordinate, which is an integer of 24 bits. Readers shift an i32 by them.
const MAX_FRACTION: u8 = 30;
/// Flag of Gaussians that were trained with antialiasing.
const ANTIALIASED: u8 = 1;
/// Flag of files with extensions.
const EXTENDED: u8 = 2;
/// Number of Adobe's extension that names the axes.
const AXES: u32 = 0xadbe_0003;
/// Number of an extension of organza's own: a [`Placement`] as JSON. Its axes are the Gaussians' as they were
/// written, whatever [`AXES`] tells other programs.
const PLACED: u32 = 0x4f52_0001;
/// Factor and offset that turn the logarithm of a scale into a byte.
const SCALE: [f32; 2] = [16.0, 160.0];
/// Factor and offset for a first harmonic.
const COLOR: [f32; 2] = [0.15 * 255.0, 127.5];
/// Factor and offset for any other harmonic.
const REST: [f32; 2] = [128.0, 128.0];
/// Most bytes of extensions that are read.
const MAX_EXTENSIONS: u64 = 1 << 20;
/// Most bytes that one byte of gzip can expand to.
const MAX_PACKED: u64 = 1032;
/// The same of Zstandard: four bytes can repeat one byte in a block of 128 KiB.
const MAX_PACKED_4: u64 = 1 << 15;
/// Largest value of a part of a quaternion, which has 9 bits and a sign.
const MAX_PART: f32 = 511.0;

/// Writes version 4. `up` is the world's upward direction.
pub fn write(
    splats: &[Splat],
    up: DVec3,
    placement: &Placement,
    file: &mut dyn Write,
) -> io::Result<()> {
    let fraction = fraction(splats);
    let arrays = arrays(splats, fraction, 4);
    let streams = arrays.iter().map(|array| zstd::bulk::compress(array, LEVEL));
    let streams = streams.collect::<io::Result<Vec<_>>>()?;
    let mut stored = serde_json::to_vec(placement)?;
    stored.resize(stored.len().next_multiple_of(4), b' ');
    let axes = axes_of(up).map_or(Vec::new(), |axes| vec![AXES, 4, axes]);
    let stored_words = stored.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word));
    let extensions: Vec<u32> =
        axes.into_iter().chain([PLACED, stored.len() as u32]).chain(stored_words).collect();
    let mut words =
        |words: &[u32]| words.iter().try_for_each(|word| file.write_all(&word.to_le_bytes()));
    words(&[MAGIC, 4, splats.len() as u32])?;
    // degree, bits of a coordinate's fraction, flags
    words(&[u32::from_le_bytes([DEGREE as u8, fraction, EXTENDED, streams.len() as u8])])?;
    words(&[(HEADER + 4 * extensions.len()) as u32, 0, 0, 0])?;
    words(&extensions)?;
    for (stream, array) in streams.iter().zip(&arrays) {
        file.write_all(&(stream.len() as u64).to_le_bytes())?;
        file.write_all(&(array.len() as u64).to_le_bytes())?;
    }
    streams.iter().try_for_each(|stream| file.write_all(stream))
}

/// The number of axes with x to the right, and y or z up or down, by the upward direction. `None` if that is near none of
/// these.
fn axes_of(up: DVec3) -> Option<u32> {
    let up = up.normalize_or_zero();
    // right, up, back; right, down, front; right, front, up; right, back, down
    let named = [(DVec3::Y, 4), (-DVec3::Y, 6), (DVec3::Z, 12), (-DVec3::Z, 14)];
    let near = |(axis, _): &(DVec3, u32)| axis.dot(up) > NEAR;
    named.into_iter().find(near).map(|(_, number)| number)
}

/// How many systems of axes have a number.
pub const SYSTEMS: u32 = 16;

/// The matrix from a system of axes, of which there are [`SYSTEMS`], to right, up and back. An extension counts from 1.
pub fn from_axes(system: u32) -> DMat3 {
    let sign = |bit: u32| if system >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let right = sign(0) * DVec3::X;
    let up = sign(1) * DVec3::Y;
    let front = -sign(2) * DVec3::Z;
    // from 8 on, depth is the second axis, and its sign is the opposite
    let [second, third] = if system < 8 { [up, front] } else { [-front, up] };
    DMat3::from_cols(right, second, third)
}

/// The matrix from the axes that extensions name to right, up and back, and a placement that organza has written. An
/// extension is a number, a length, and as many bytes.
fn extended(mut records: &[u8], path: &Path) -> Result<(DMat3, Option<Placement>)> {
    let mut axes = DMat3::IDENTITY;
    while let Some((&[a, b, c, d, ref length @ ..], rest)) = records.split_first_chunk::<8>() {
        let kind = u32::from_le_bytes([a, b, c, d]);
        let length = u32::from_le_bytes(*length) as usize;
        let Some((content, rest)) = rest.split_at_checked(length) else { return cut(path) };
        match (kind, content.first_chunk()) {
            // the first files of organza had only this mark
            (PLACED, None) => return Ok((DMat3::IDENTITY, Some(Placement::default()))),
            (PLACED, Some(_)) => {
                let stored = Placement::from_json(&parse_json(content, path)?, path)?;
                return Ok((DMat3::IDENTITY, Some(stored)));
            }
            (AXES, Some(number)) => match u32::from_le_bytes(*number) {
                0 => {}
                number @ 1..=SYSTEMS => axes = from_axes(number - 1),
                number => {
                    let reason =
                        format!("its axes have the number {number}, expected 0 to {SYSTEMS}");
                    return invalid(path, reason);
                }
            },
            (AXES, None) => return cut(path),
            _ => {}
        }
        records = rest;
    }
    Ok((axes, None))
}

/// Writes version 2.
pub fn write_2(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    let fraction = fraction(splats);
    let mut file = GzEncoder::new(file, Compression::best());
    for word in [MAGIC, 2, splats.len() as u32] {
        file.write_all(&word.to_le_bytes())?;
    }
    file.write_all(&[DEGREE as u8, fraction, 0, 0])?;
    arrays(splats, fraction, 2).iter().try_for_each(|array| file.write_all(array))?;
    file.finish().map(drop)
}

/// The arrays in the order of the file: positions, opacities, colors, scales, rotations and harmonics.
fn arrays(splats: &[Splat], fraction: u8, version: u32) -> [Vec<u8>; 6] {
    let position = |splat: &Splat| {
        let fixed = splat.position.map(|value| (value * 2_f32.powi(fraction.into())).round());
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
fn fraction(splats: &[Splat]) -> u8 {
    let largest =
        splats.iter().flat_map(|splat| splat.position).fold(0.0, |largest: f32, value| {
            if value.is_finite() { largest.max(value.abs()) } else { largest }
        });
    let fits = |bits: &u8| largest * 2_f32.powi((*bits).into()) < 8_388_607.0;
    (0..=MAX_FRACTION).rev().find(fits).unwrap_or(0)
}

/// The header fields of all versions.
struct Header {
    version: u32,
    count: usize,
    degree: u8,
    fraction: u8,
    flags: u8,
}

impl Header {
    /// `max` is the number of bytes that the file can expand to at most.
    fn parse(bytes: &[u8], length: usize, max: u64, versions: &[u32], path: &Path) -> Result<Self> {
        let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|byte| bytes[4 * at + byte]));
        if word(0) != MAGIC {
            return invalid(path, "it is packed with gzip, but it is not an SPZ file");
        }
        let count = word(2) as usize;
        let [degree, fraction, flags] = [bytes[12], bytes[13], bytes[14]];
        let header = Self { version: word(1), count, degree, fraction, flags };
        let version = header.version;
        if !versions.contains(&version)
            || u32::from(degree) > FILE_DEGREE
            || fraction > MAX_FRACTION
        {
            return invalid(
                path,
                format!(
                    "it is an SPZ file of version {version} with harmonics of degree {degree} and coordinates of \
                     {fraction} bits behind the point; expected version 1 to 4, degree 0 to {FILE_DEGREE}, and at most {MAX_FRACTION} bits"
                ),
            );
        }
        let needed = header.widths().iter().map(|width| (width * count) as u64).sum::<u64>();
        if needed > (length as u64).saturating_mul(max) {
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

    /// Number of harmonics but the first.
    fn others(&self) -> usize {
        width(self.degree.into()) as usize - 1
    }

    /// Bytes of a Gaussian in each array.
    fn widths(&self) -> [usize; 6] {
        let position = if self.version == 1 { 6 } else { 9 };
        let rotation = if self.version < 3 { 3 } else { 4 };
        [position, 1, 3, 3, rotation, 3 * self.others()]
    }

    /// The Gaussians of the arrays, in axes to the right, up and back.
    fn placed(&self, arrays: &[Vec<u8>; 6], extensions: &[u8], path: &Path) -> Result<SplatFile> {
        let mut splats = self.splats(arrays)?;
        let (axes, stored) = extended(extensions, path)?;
        if axes != DMat3::IDENTITY {
            turn(&mut splats, axes, 1.0, |place| (axes * DVec3::from(place)).to_array());
        }
        let format = ["SPZ 1", "SPZ 2", "SPZ 3", "SPZ 4"][self.version as usize - 1];
        let mut file = SplatFile::new(path, format, splats).placed(stored);
        file.is_antialiased = self.flags & ANTIALIASED != 0;
        if u32::from(self.degree) > DEGREE {
            file.notes.push(DEGREE_4.to_owned());
        }
        Ok(file)
    }

    /// The Gaussians of the arrays.
    fn splats(&self, arrays: &[Vec<u8>; 6]) -> Result<Vec<Splat>> {
        let [positions, opacities, colors, scales, rotations, rest] = arrays;
        let mut splats: Vec<Splat> = memory::zeros(self.count, "the Gaussians of an SPZ file")?;
        let unit = 2_f32.powi(-i32::from(self.fraction));
        let coordinates = values(&mut splats, |splat| &mut splat.position);
        for (value, bytes) in coordinates.zip(positions.chunks(self.widths()[0] / 3)) {
            *value = match *bytes {
                [low, high] => f16::from_le_bytes([low, high]).to_f32(),
                // the upper bytes of an i32 keep the sign
                _ => (i32::from_le_bytes([0, bytes[0], bytes[1], bytes[2]]) >> 8) as f32 * unit,
            };
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

/// Reads version 1, 2 or 3, which are in gzip.
pub fn read_packed(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    read_old(GzDecoder::new(bytes), bytes.len(), MAX_PACKED, path)
}

/// Reads version 1, 2 or 3. `max` is the number of bytes that each of the file's `length` bytes can expand to.
pub fn read_old(mut source: impl Read, length: usize, max: u64, path: &Path) -> Result<SplatFile> {
    let mut bytes = [0; 16];
    source.read_exact(&mut bytes).or_else(|_| cut(path))?;
    let header = Header::parse(&bytes, length, max, &[1, 2, 3], path)?;
    let mut arrays = [const { Vec::new() }; 6];
    for (array, bytes) in arrays.iter_mut().zip(header.widths()) {
        *array = fill(&mut source, bytes * header.count, path)?;
    }
    let mut extensions = Vec::new();
    if header.flags & EXTENDED != 0 {
        source.take(MAX_EXTENSIONS).read_to_end(&mut extensions).or_else(|_| cut(path))?;
    }
    header.placed(&arrays, &extensions, path)
}

/// Reads version 4.
pub fn read(mut source: &[u8], path: &Path) -> Result<SplatFile> {
    let length = source.len();
    let mut bytes = [0; HEADER];
    source.read_exact(&mut bytes).or_else(|_| cut(path))?;
    let header = Header::parse(&bytes, length, MAX_PACKED_4, &[4], path)?;
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
    let mut extensions = fill(source.by_ref(), table as usize - HEADER, path)?;
    if header.flags & EXTENDED == 0 {
        extensions.clear();
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
        // skips the rest, so that the next stream begins where the table says
        io::copy(&mut stream, &mut io::sink()).or_else(|_| cut(path))?;
    }
    header.placed(&arrays, &extensions, path)
}

/// Three values of each Gaussian.
fn values(
    splats: &mut [Splat],
    of: fn(&mut Splat) -> &mut [f32; 3],
) -> impl Iterator<Item = &mut f32> {
    splats.iter_mut().flat_map(of)
}

/// Up to version 2: x, y and z of a unit quaternion whose w is not negative.
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
        let size = std::f32::consts::FRAC_1_SQRT_2 * (part & 511) as f32 / MAX_PART;
        if part & 512 != 0 { -size } else { size }
    };
    let [x, y, z, w] = with_largest((bits >> 30) as usize, [part(20), part(10), part(0)]);
    [w, x, y, z]
}

/// The inverse of [`unpacked_rotation`].
fn packed_rotation([w, x, y, z]: [f32; 4]) -> [u8; 4] {
    let (largest, parts) = smallest_three([x, y, z, w]);
    let bits = parts.iter().fold(largest as u32, |bits, part| {
        let size = (part.abs() * std::f32::consts::SQRT_2 * MAX_PART).round().min(MAX_PART);
        bits << 10 | u32::from(*part < 0.0) << 9 | size as u32
    });
    bits.to_le_bytes()
}

/// The next bytes. Memory grows with the data, not with the size in a header.
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

    fn write(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
        super::write(splats, DVec3::Z, &Placement::default(), file)
    }

    #[test]
    fn a_round_trip_is_as_exact_as_the_format() {
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
        let stored = word(48) as usize;
        let table = 52 + stored;
        assert_eq!([word(4), word(8), word(16)], [4, 9, table as u32]);
        assert_eq!([bytes[12], bytes[14], bytes[15]], [3, 2, 6]);
        assert_eq!(bytes[20..32], [0; 12]);
        // axes: right, front, up; and organza's own placement
        assert_eq!([32, 36, 40].map(word), [0xadbe_0003, 4, 12]);
        assert_eq!(word(44), 0x4f52_0001);
        let placement: Placement = serde_json::from_slice(&bytes[52..table]).unwrap();
        assert!(placement.is_identity());
        let lengths: Vec<_> =
            (0..6).map(|at| [word(table + 16 * at), word(table + 8 + 16 * at)]).collect();
        let packed: u32 = lengths.iter().map(|[packed, _]| packed).sum();
        assert_eq!(bytes.len(), table + 6 * 16 + packed as usize);
        let unpacked: Vec<_> = lengths.iter().map(|[_, unpacked]| unpacked / 9).collect();
        assert_eq!(unpacked, [9, 1, 3, 3, 4, 45]);
    }

    #[test]
    fn bad_files_are_refused_with_a_reason() {
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
        let table = 52 + usize::from(packed(write)[48]);
        assert_refused(&with_4(table, 3), &["cut short"]);
        assert_refused(&with_4(40, 17), &["axes", "17"]);
        assert_refused(&with_4(36, 400), &["cut short"]);
    }

    /// 24 harmonics stand in a file with degree 4, 15 of them are read.
    #[test]
    fn harmonics_of_degree_4_are_left_out() {
        let words = [MAGIC, 2, 1, u32::from_le_bytes([4, 12, ANTIALIASED, 0])];
        let mut bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        bytes.resize(16 + 9 + 1 + 3 + 3 + 3, 0);
        bytes.extend(128..128 + 72);
        let file = super::super::read_from(&bytes, Path::new("a.spz")).unwrap();
        assert_eq!(file.notes, [DEGREE_4]);
        assert!(file.is_antialiased);
        assert_eq!(file.splats[0].color[15], [42.0, 43.0, 44.0].map(|level| level / 128.0));
    }

    /// Files without extensions have axes to the right, up and back.
    #[test]
    fn only_axes_of_other_programs_are_turned() {
        let declared = |axes: u32| {
            let mut bytes = packed(write);
            bytes[40..44].copy_from_slice(&axes.to_le_bytes());
            // an unknown extension in place of organza's own
            bytes[44..48].copy_from_slice(&7_u32.to_le_bytes());
            read_bytes(&bytes).unwrap()
        };
        let own = read_bytes(&packed(write)).unwrap();
        assert_eq!(declared(0), own);
        assert_eq!(declared(4), own);
        // the names of Niantic's axes, in their order
        let names = [
            "LDB", "RDB", "LUB", "RUB", "LDF", "RDF", "LUF", "RUF", "LFD", "RFD", "LFU", "RFU",
            "LBD", "RBD", "LBU", "RBU",
        ];
        for (number, name) in (1..).zip(names) {
            for (splat, found) in own.iter().zip(declared(number)) {
                let mut expected = [0.0; 3];
                for (value, letter) in splat.position.into_iter().zip(name.chars()) {
                    match letter {
                        'R' => expected[0] = value,
                        'L' => expected[0] = -value,
                        'U' => expected[1] = value,
                        'D' => expected[1] = -value,
                        'B' => expected[2] = value,
                        _ => expected[2] = -value,
                    }
                }
                assert_eq!(found.position, expected, "{name}");
            }
        }
        // upward directions that have a name, and one that has none
        let named = [DVec3::Y, -DVec3::Y, DVec3::Z, DVec3::new(0.2, -0.3, -0.9), DVec3::X];
        assert_eq!(named.map(axes_of), [Some(4), Some(6), Some(12), Some(14), None]);
    }

    #[test]
    fn positions_of_small_and_of_large_scenes_survive() {
        for scale in [1e-5, 1.0, 1e5] {
            let mut splats = splats();
            splats.iter_mut().for_each(|splat| splat.position = splat.position.map(|x| x * scale));
            for write in [write, write_2] {
                let mut bytes = Vec::new();
                write(&splats, &mut bytes).unwrap();
                for (found, splat) in read_bytes(&bytes).unwrap().iter().zip(&splats) {
                    let pairs = found.position.iter().zip(splat.position);
                    let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                    assert!(off < 1e-4 * scale, "{off} at {scale}");
                }
            }
        }
    }

    /// Version 1 has positions of 16 bits. Versions before 4 may be without gzip.
    #[test]
    fn old_versions_are_read_with_and_without_gzip() {
        let mut bytes = Vec::new();
        GzDecoder::new(&packed(write_2)[..]).read_to_end(&mut bytes).unwrap();
        let expected = read_bytes(&packed(write_2)).unwrap();
        assert_eq!(read_bytes(&bytes).unwrap(), expected);
        for length in (8..bytes.len()).step_by(17) {
            assert_refused(&bytes[..length], &["cut short"]);
        }
        let positions = expected.iter().flat_map(|splat| splat.position);
        let halves: Vec<u8> =
            positions.flat_map(|value| f16::from_f32(value).to_le_bytes()).collect();
        let mut first = bytes[..16].to_vec();
        first[4] = 1;
        first.extend(halves);
        first.extend(&bytes[16 + 9 * expected.len()..]);
        let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
        packed.write_all(&first).unwrap();
        for bytes in [packed.finish().unwrap(), first] {
            for (found, splat) in read_bytes(&bytes).unwrap().iter().zip(&expected) {
                let position = splat.position.map(|value| f16::from_f32(value).to_f32());
                assert_eq!(*found, Splat { position, ..*splat });
            }
        }
        // axes at the end: right, down, front
        bytes[14] = EXTENDED;
        for word in [AXES, 4, 6] {
            bytes.extend(word.to_le_bytes());
        }
        for (found, splat) in read_bytes(&bytes).unwrap().iter().zip(&expected) {
            let [x, y, z] = splat.position;
            assert_eq!(found.position, [x, -y, -z]);
        }
    }
}
