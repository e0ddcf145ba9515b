//! Reads and writes files of other programs.

mod clusters;
mod dot_splat;
mod gltf;
mod mesh;
mod ply;
mod sog;
mod spz;

pub use mesh::{MeshFormat, save_mesh};
pub use spz::{SYSTEMS, from_axes};

use std::cmp::Ordering;
use std::path::{Path, PathBuf};

use glam::{DMat3, DVec3};
use organza_core::error::invalid;
use serde_json::Value;

use super::harmonics::{FIRST, MIDDLE};
use super::placed::turn;
use super::{Splat, VALUES};
use organza_core::camera::median;
use organza_core::input::{has_extension, read_file};
use organza_core::scene::{Placement, logit};
use organza_core::{Error, Result, write_atomic};

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// PLY with the properties of 3D Gaussian Splatting: all values as 32-bit floats.
    Ply,
    /// Niantic's SPZ, version 4: quantized and compressed, a tenth of a PLY's size.
    Spz,
    /// SPZ of version 2, for programs that do not read version 4. It rounds rotations more.
    Spz2,
    /// PlayCanvas' SOG, version 2: images of quantized values.
    Sog,
    /// Binary glTF with the extension `KHR_gaussian_splatting`.
    Glb,
    /// 32 bytes for each Gaussian, with one color for all directions.
    Splat,
}

/// The Gaussians of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SplatFile {
    /// Path of the file.
    pub path: PathBuf,
    /// Name and version of its format.
    pub format: &'static str,
    /// The Gaussians, in a space of their own.
    pub splats: Vec<Splat>,
    /// Where this space lies in the world. An f32 has too few digits for a place on the Earth.
    pub placement: Placement,
    /// Whether the file says where it lies, as organza's do.
    pub is_placed: bool,
    /// Whether opacities are those of viewers that make up for their blur, as in Mip-Splatting.
    pub is_antialiased: bool,
    /// Warnings: what is not read as the file means it.
    pub notes: Vec<String>,
}

impl SplatFile {
    pub(super) fn new(path: &Path, format: &'static str, splats: Vec<Splat>) -> Self {
        let path = path.to_owned();
        let placement = Placement::default();
        let notes = Vec::new();
        Self { path, format, splats, placement, is_placed: false, is_antialiased: false, notes }
    }

    /// With the placement in the file, if it has one.
    fn placed(self, stored: Option<Placement>) -> Self {
        Self { placement: stored.unwrap_or_default(), is_placed: stored.is_some(), ..self }
    }

    /// With these positions. If an f32 is too short for them, they become relative to their middle.
    fn with_positions(mut self, positions: &[[f64; 3]]) -> Self {
        let is_exact = |x: &f64| f64::from(*x as f32) == *x || !x.is_finite();
        let mut offset = [0.0; 3];
        if !positions.as_flattened().iter().all(is_exact) {
            let finite = |axis: usize| {
                positions.iter().map(move |place| place[axis]).filter(|x| x.is_finite())
            };
            offset = [0, 1, 2].map(|axis| median(finite(axis)));
        }
        for (splat, place) in self.splats.iter_mut().zip(positions) {
            splat.position = [0, 1, 2].map(|axis| (place[axis] - offset[axis]) as f32);
        }
        self.placement.offset = self.placement.world(offset);
        self
    }

    /// Without a few Gaussians whose values are not finite.
    fn without_broken(mut self) -> Self {
        let is_finite = |splat: &Splat| {
            bytemuck::cast_ref::<Splat, [f32; VALUES]>(splat).iter().all(|value| value.is_finite())
        };
        let all = self.splats.len();
        let broken = self.splats.iter().filter(|splat| !is_finite(splat)).count();
        if broken <= all / BROKEN_SHARE {
            self.splats.retain(is_finite);
            self.notes.extend(omitted(broken, all, "have NaN or infinity among their values"));
        }
        self
    }

    /// The Gaussians in the space of a scene.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a Gaussian that does not fit into it.
    pub fn into_own(self, placement: &Placement) -> Result<Vec<Splat>> {
        let Self { path, mut splats, placement: from, .. } = self;
        if from != *placement {
            let axes = placement.rotation().transpose() * from.rotation();
            let place = |place| placement.own(from.world(place));
            turn(&mut splats, axes, from.scale / placement.scale, place);
        }
        check(&splats, &path, "does it lie too far from the cameras?")?;
        Ok(splats)
    }

    /// The same file in a world whose axes are turned. `axes` is orthogonal, and may mirror.
    #[must_use]
    pub fn turned(mut self, axes: DMat3) -> Self {
        let rotation = self.placement.rotation();
        let own = rotation.transpose() * axes * rotation;
        turn(&mut self.splats, own, 1.0, |place| (own * DVec3::from(place)).to_array());
        self.placement.offset = (axes * DVec3::from(self.placement.offset)).to_array();
        self
    }
}

impl Format {
    /// The format for a file's extension.
    ///
    /// # Errors
    /// [`Error::Invalid`] for any other extension.
    pub fn from_path(path: &Path) -> Result<Self> {
        let name = path.file_name().unwrap_or_default().to_ascii_lowercase();
        let name = name.to_string_lossy();
        match name.rsplit_once('.') {
            Some((name, "ply")) if name.ends_with(".compressed") => {
                invalid(path, "organza does not write .compressed.ply; a .sog is half as large")
            }
            Some((_, "ply")) => Ok(Self::Ply),
            Some((_, "spz")) => Ok(Self::Spz),
            Some((_, "sog")) => Ok(Self::Sog),
            Some((_, "glb")) => Ok(Self::Glb),
            Some((_, "splat")) => Ok(Self::Splat),
            _ => invalid(
                path,
                "the ending of the file says how it is written: .ply, .spz, .sog, .glb or .splat",
            ),
        }
    }

    /// Whether a file says where its Gaussians lie.
    pub fn stores_placement(self) -> bool {
        !matches!(self, Self::Spz2 | Self::Splat)
    }
}

/// Writes a file, atomically. `up` is the upward direction, for formats that have one, and `placement` says where the space of the
/// Gaussians lies in the world, for formats that [can store it](Format::stores_placement). Returns the Gaussians as they are in
/// the file, which most formats round and reorder.
///
/// # Errors
/// [`Error::Invalid`] for values that [`load`] would refuse; [`Error::WriteFile`](organza_core::Error::WriteFile).
pub fn save(
    splats: &[Splat],
    path: impl AsRef<Path>,
    format: Format,
    up: [f64; 3],
    placement: &Placement,
) -> Result<SplatFile> {
    let path = path.as_ref();
    check(splats, path, "no viewer can show it; do the scene's networks overflow?")?;
    let up = DVec3::from(up);
    let mut bytes = Vec::new();
    let encoded = match format {
        Format::Ply => ply::write(splats, placement, &mut bytes),
        Format::Spz => spz::write(splats, up, placement, &mut bytes),
        Format::Spz2 => spz::write_2(splats, &mut bytes),
        Format::Sog => sog::write(splats, placement, &mut bytes),
        Format::Glb => gltf::write(splats, up.as_vec3(), placement, &mut bytes),
        Format::Splat => dot_splat::write(splats, &mut bytes),
    };
    encoded.map_err(|error| Error::write(path, error))?;
    let read = match format {
        Format::Splat => dot_splat::read(&bytes, path)?,
        _ => read_from(&bytes, path)?,
    };
    write_atomic(path, |file| file.write_all(&bytes))?;
    let stored = read.is_placed.then_some(read.placement);
    Ok(SplatFile { placement: stored.unwrap_or(*placement), ..read })
}

/// Largest absolute logarithm of a scale: beyond it, the scale is not an f32.
const LARGEST_LOG_SCALE: f32 = 80.0;

/// Reads the Gaussians of a file. Where a format says how the axes point, or a file does, they are turned: SPZ's point to the
/// right, up and back, and glTF has y up. A file that organza wrote says where it lies in the world.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] for another kind of file, a truncated one, or values that are not valid
/// for a Gaussian; [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
pub fn load(path: impl AsRef<Path>) -> Result<SplatFile> {
    let path = path.as_ref();
    read_from(&read_file(path, u64::MAX, "a file of Gaussians")?, path)
}

/// A file may have one Gaussian in so many that is not finite. Trainers leave a few behind.
const BROKEN_SHARE: usize = 20;
/// Some programs fill up their files with rows of zeros, which are no Gaussians.
const ZEROS: &str = "have only zeros";

/// A note if Gaussians are left out.
fn omitted(count: usize, all: usize, why: &str) -> Option<String> {
    (count > 0).then(|| format!("{count} of {all} Gaussians {why}; they are left out"))
}

/// Checks that there are Gaussians, and that each has values of one.
fn check(splats: &[Splat], path: &Path, hint: &str) -> Result<()> {
    if splats.is_empty() {
        return invalid(path, "it has no Gaussians");
    }
    for (index, splat) in splats.iter().enumerate() {
        let values: &[f32; VALUES] = bytemuck::cast_ref(splat);
        let largest =
            splat.log_scale.iter().fold(0.0, |largest: f32, value| largest.max(value.abs()));
        if values.iter().any(|value| !value.is_finite()) || largest > LARGEST_LOG_SCALE {
            let Splat { position, log_scale, opacity, rotation, .. } = splat;
            let [color, ..] = splat.color;
            return invalid(
                path,
                format!(
                    "Gaussian {index} has a value that is not finite, or a scale that is no logarithm: position \
                     {position:?}, scale {log_scale:?}, opacity {opacity}, rotation {rotation:?}, color {color:?}, \
                     or its other harmonics; {hint}"
                ),
            );
        }
    }
    Ok(())
}

/// [`load`] from a file's bytes. Errors name `path`.
pub fn read_from(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    let file = match bytes {
        [0x1f, 0x8b, ..] => spz::read_packed(bytes, path)?,
        [b'N', b'G', b'S', b'P', 1..=3, 0, ..] => spz::read_old(bytes, bytes.len(), 1, path)?,
        [b'N', b'G', b'S', b'P', ..] => spz::read(bytes, path)?,
        [b'p', b'l', b'y', ..] => ply::read(bytes, path)?,
        [b'P', b'K', 3 | 5, 4 | 6, ..] => sog::read(bytes, path)?,
        [b'g', b'l', b'T', b'F', ..] => gltf::read(bytes, path)?,
        _ if bytes.trim_ascii_start().starts_with(b"{") => {
            return invalid(
                path,
                "a .gltf, or the description of an unpacked .sog, has its values in other files: write one .glb with \
                 everything in it, for example with `npx @gltf-transform/cli copy`, or pack the .sog as a ZIP archive",
            );
        }
        // nothing in such a file says what it is
        _ if has_extension(path, &["splat"]) => dot_splat::read(bytes, path)?,
        _ => {
            return invalid(
                path,
                "it is no file of Gaussians that is known; .ply, .spz, .sog, .glb and .splat are read: write the \
                 Gaussians as one of these",
            );
        }
    };
    let file = file.without_broken();
    check(&file.splats, path, "is the file damaged?")?;
    Ok(file)
}

/// A note of a file with harmonics of degree 4, which few programs write.
const DEGREE_4: &str = "it has harmonics of degree 4, which are left out: colors differ a little";

/// Key of the [`Placement`] in a file that has room for it.
const PLACEMENT: &str = "organza";

/// The placement in the JSON of a file, under [`PLACEMENT`].
fn stored_placement(json: &Value, path: &Path) -> Result<Option<Placement>> {
    json.get(PLACEMENT).map(|stored| Placement::from_json(stored, path)).transpose()
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

/// The index of the quaternion's largest part, and the others, with the sign that makes the largest positive. `quaternion` has
/// length 1.
fn smallest_three(quaternion: [f32; 4]) -> (usize, [f32; 3]) {
    let size = |at: &usize| quaternion[*at].abs();
    let largest = (0..4).rev().max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(0);
    let sign = quaternion[largest].signum();
    (largest, std::array::from_fn(|at| sign * quaternion[if at < largest { at } else { at + 1 }]))
}

/// The quaternion of length 1 whose largest part is positive and has this index.
fn with_largest(largest: usize, others: [f32; 3]) -> [f32; 4] {
    let rest = 1.0 - others.iter().map(|part| part * part).sum::<f32>();
    std::array::from_fn(|at| match at.cmp(&largest) {
        Ordering::Less => others[at],
        Ordering::Equal => rest.max(0.0).sqrt(),
        Ordering::Greater => others[at - 1],
    })
}

/// The lowest and the highest of some values.
fn ends(values: impl Iterator<Item = f32>) -> [f32; 2] {
    let all = [f32::INFINITY, f32::NEG_INFINITY];
    values.fold(all, |[low, high], value| [low.min(value), high.max(value)])
}

/// The nearest of the levels 0 to `max` for a value in a range.
fn level(value: f32, [low, high]: [f32; 2], max: u32) -> u32 {
    // a range as wide as f32 has no width in f32
    let width = f64::from(high) - f64::from(low);
    let part = if width > 0.0 { (f64::from(value) - f64::from(low)) / width } else { 0.0 };
    (part * f64::from(max)).round().clamp(0.0, f64::from(max)) as u32
}

/// The logit of an opacity of 256 levels. Opacities of 0 and 1 have no finite one.
fn logit_of(opacity: u8) -> f32 {
    logit(f32::from(opacity).clamp(0.25, 254.75) / 255.0)
}

/// The logarithm of a scale. A scale of 0 has no finite one, so it gets one that is too small to see.
fn log_of(scale: f32) -> f32 {
    if scale == 0.0 { -69.0 } else { scale.ln() }
}

/// Rounds to the nearest byte.
fn byte(value: f32) -> u8 {
    value.round() as u8
}

#[cfg(test)]
pub mod tests {
    use super::super::harmonics::HARMONICS;
    use super::*;
    use muslin::math::sigmoid;
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

    pub fn read_bytes(bytes: &[u8]) -> Result<Vec<Splat>> {
        read_from(bytes, Path::new("a.file"))?.into_own(&Placement::default())
    }

    /// Compares with largest errors: of positions, of logarithms of scales, of the first harmonic, of the others, and of
    /// the parts of unit quaternions. Opacities have 256 levels.
    #[track_caller]
    pub fn assert_close(found: &[Splat], expected: &[Splat], max: [f32; 5]) {
        assert_eq!(found.len(), expected.len());
        let apart =
            |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        for (found, expected) in found.iter().zip(expected) {
            let opacities = [sigmoid(found.opacity), sigmoid(expected.opacity)];
            assert!((opacities[0] - opacities[1]).abs() < 0.51 / 255.0, "{opacities:?}");
            let turns = [turned(found), turned(expected)];
            let sign = turns[0].iter().zip(turns[1]).map(|(a, b)| a * b).sum::<f32>().signum();
            let errors = [
                apart(&found.position, &expected.position),
                apart(&found.log_scale, &expected.log_scale),
                apart(&found.color[0], &expected.color[0]),
                apart(found.color[1..].as_flattened(), expected.color[1..].as_flattened()),
                apart(&turns[0].map(|part| sign * part), &turns[1]),
            ];
            let is_close = errors.iter().zip(max).all(|(error, max)| *error <= 1.01 * max + 1e-6);
            assert!(is_close, "{errors:?}, at most {max:?}");
        }
    }

    #[track_caller]
    pub fn assert_refused(bytes: &[u8], facts: &[&str]) {
        let found = read_from(bytes, Path::new("a.file"));
        let Err(error @ Error::Invalid { .. }) = found else { panic!("{found:?}") };
        let text = chain(&error);
        assert!(text.contains("a.file"), "{text}");
        facts.iter().for_each(|fact| assert!(text.contains(fact), "{fact}: {text}"));
    }
}
