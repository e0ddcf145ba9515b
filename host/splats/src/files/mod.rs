//! Reads and writes files of other programs.

mod gltf;
mod ply;
mod spz;

use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;

use glam::DVec3;
use muslin::math::sigmoid;

use super::harmonics::{FIRST, MIDDLE};
use super::{Splat, VALUES};
use organza_core::error::{Error, Result};
use organza_core::input::open_regular;
use organza_core::write_atomic;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// PLY with the properties of 3D Gaussian Splatting: all values as 32-bit floats.
    Ply,
    /// Niantic's SPZ: quantized and compressed, a tenth of a PLY's size.
    Spz,
    /// Binary glTF with the extension `KHR_gaussian_splatting`.
    Glb,
    /// 32 bytes for each Gaussian, with one color for all directions.
    Splat,
}

impl Format {
    /// The format for a file's extension.
    ///
    /// # Errors
    /// [`Error::Invalid`] for any other extension.
    pub fn of(path: &Path) -> Result<Self> {
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("ply") => Ok(Self::Ply),
            Some("spz") => Ok(Self::Spz),
            Some("glb") => Ok(Self::Glb),
            Some("splat") => Ok(Self::Splat),
            _ => invalid(
                path,
                "the ending of the file says how it is written: .ply, .spz, .glb or .splat",
            ),
        }
    }
}

/// Writes a file, atomically. `up` is the world's upward direction, for formats with a fixed one.
///
/// # Errors
/// [`Error::Invalid`] for values that [`load`] would refuse; [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn save(splats: &[Splat], path: impl AsRef<Path>, format: Format, up: [f64; 3]) -> Result<()> {
    check(splats, path.as_ref(), "no viewer can show it; do the scene's networks overflow?")?;
    write_atomic(path, |file| match format {
        Format::Ply => ply::write(splats, file),
        Format::Spz => spz::write(splats, file),
        Format::Glb => gltf::write(splats, DVec3::from(up).as_vec3(), file),
        Format::Splat => write_splat(splats, file),
    })
}

/// Largest absolute logarithm of a scale: beyond it, the scale is not an f32.
const LARGEST_LOG_SCALE: f32 = 80.0;

/// Reads the Gaussians of a PLY or an SPZ file.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] for another kind of file, a truncated one, or values that are not valid
/// for a Gaussian; [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
pub fn load(path: impl AsRef<Path>) -> Result<Vec<Splat>> {
    let path = path.as_ref();
    let (file, length) = open_regular(path)?;
    read_from(BufReader::new(file), length, path)
}

/// Checks that there are Gaussians, and that each has values of one.
fn check(splats: &[Splat], path: &Path, hint: &str) -> Result<()> {
    if splats.is_empty() {
        return invalid(path, "it has no Gaussians");
    }
    for (index, splat) in splats.iter().enumerate() {
        let values: &[f32; VALUES] = bytemuck::cast_ref(splat);
        let largest = splat.log_scale.iter().fold(0.0, |most: f32, value| most.max(value.abs()));
        if values.iter().any(|value| !value.is_finite()) || largest > LARGEST_LOG_SCALE {
            let Splat { position, log_scale, opacity, .. } = splat;
            return invalid(
                path,
                format!(
                    "Gaussian {index} has a value that is not finite, or a scale that is no logarithm: position \
                     {position:?}, scale {log_scale:?}, opacity {opacity}; {hint}"
                ),
            );
        }
    }
    Ok(())
}

/// [`load`] from a reader of `length` bytes. Errors name `path`.
pub fn read_from(mut source: impl BufRead, length: u64, path: &Path) -> Result<Vec<Splat>> {
    let begin = source.fill_buf().map_err(|error| Error::read(path, error))?;
    let splats = match begin {
        [0x1f, 0x8b, ..] => spz::read(source, length, path)?,
        [b'p', b'l', b'y', ..] => ply::read(source, length, path)?,
        _ => {
            return invalid(
                path,
                "it is neither a PLY nor an SPZ file; write the Gaussians as one of these",
            );
        }
    };
    check(&splats, path, "is the file damaged?")?;
    Ok(splats)
}

fn invalid<T>(path: &Path, reason: impl Into<String>) -> Result<T> {
    Err(Error::Invalid { origin: path.to_owned(), reason: reason.into() })
}

/// Writes center and scales as floats, color and opacity as bytes, and the quaternion as bytes around 128.
fn write_splat(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    // the largest and most opaque first: viewers show a file while it loads
    let weight =
        |splat: &&Splat| splat.log_scale.iter().sum::<f32>().exp() * sigmoid(splat.opacity);
    let mut order: Vec<_> = splats.iter().collect();
    order.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    for splat in order {
        for value in splat.position.into_iter().chain(splat.log_scale.map(f32::exp)) {
            file.write_all(&value.to_le_bytes())?;
        }
        file.write_all(&base_color(splat).map(|value| byte(255.0 * value)))?;
        file.write_all(&[byte(255.0 * sigmoid(splat.opacity))])?;
        file.write_all(&turned(splat).map(|part| byte(part * 128.0 + 128.0)))?;
    }
    Ok(())
}

/// The color without the parts that depend on the direction.
pub fn base_color(splat: &Splat) -> [f32; 3] {
    splat.color[0].map(|value| MIDDLE + FIRST * value)
}

/// The quaternion w x y z, scaled to length 1; the identity for length 0.
fn turned(splat: &Splat) -> [f32; 4] {
    let length = splat.rotation.iter().map(|part| part * part).sum::<f32>().sqrt();
    if length > 0.0 { splat.rotation.map(|part| part / length) } else { [1.0, 0.0, 0.0, 0.0] }
}

/// Rounds to the nearest byte.
fn byte(value: f32) -> u8 {
    value.round() as u8
}

#[cfg(test)]
mod tests {
    use super::super::harmonics::HARMONICS;
    use super::*;
    use organza_core::error::chain;

    /// Gaussians of all kinds.
    pub fn splats() -> Vec<Splat> {
        let value = |i: usize, k: usize| ((i * 37 + k * 61) % 97) as f32 / 97.0 - 0.5;
        (0..9)
            .map(|i| Splat {
                position: std::array::from_fn(|k| 4.0 * value(i, k)),
                rotation: std::array::from_fn(|k| value(i, 3 + k) + 0.01),
                log_scale: std::array::from_fn(|k| 6.0 * value(i, 7 + k) - 3.0),
                opacity: 8.0 * value(i, 10),
                color: std::array::from_fn(|h: usize| {
                    std::array::from_fn(|channel| value(i, 11 + HARMONICS * channel + h))
                }),
            })
            .collect()
    }

    #[track_caller]
    pub fn assert_refused(bytes: &[u8], facts: &[&str]) {
        let found = read_from(bytes, bytes.len() as u64, Path::new("a.file"));
        let Err(error @ Error::Invalid { .. }) = found else { panic!("{found:?}") };
        let text = chain(&error);
        assert!(text.contains("a.file"), "{text}");
        facts.iter().for_each(|fact| assert!(text.contains(fact), "{fact}: {text}"));
    }

    #[test]
    fn a_splat_file_has_32_bytes_for_each_of_them() {
        let splats = splats();
        let mut bytes = Vec::new();
        write_splat(&splats, &mut bytes).unwrap();
        assert_eq!(bytes.len(), 32 * splats.len());
        let float = |at: usize| f32::from_le_bytes(std::array::from_fn(|byte| bytes[at + byte]));
        let found = splats.iter().find(|splat| splat.position[0] == float(0)).unwrap();
        for axis in 0..3 {
            assert_eq!(float(4 * axis), found.position[axis]);
            assert_eq!(float(12 + 4 * axis), found.log_scale[axis].exp());
            let color = 255.0 * (0.5 + 0.282_094_8 * found.color[0][axis]);
            assert!((f32::from(bytes[24 + axis]) - color).abs() < 0.51);
        }
        assert!((f32::from(bytes[27]) - 255.0 * sigmoid(found.opacity)).abs() < 0.51);
        let w = (f32::from(bytes[28]) - 128.0) / 128.0;
        assert!((w - turned(found)[0]).abs() < 0.01);
    }
}
