//! PlayCanvas' SOG, "spatially ordered Gaussians", version 2: lossless WebP images with a pixel for each Gaussian, and a
//! `meta.json` that says what their levels mean, in a ZIP archive.
//! <https://developer.playcanvas.com/user-manual/gaussian-splatting/formats/sog/>

use std::f32::consts::SQRT_2;
use std::io::{self, Cursor, Read, Seek, Write};
use std::path::Path;

use image_webp::{ColorType, DecodingError, WebPDecoder, WebPEncoder};
use muslin::math::sigmoid;
use organza_core::memory;
use serde_json::{Value, json};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::clusters::{Clusters, clusters};
use super::{
    PLACEMENT, Splat, SplatFile, byte, ends, level, logit_of, smallest_three, stored_placement,
    turned, with_largest,
};
use crate::harmonics::{DEGREE, HARMONICS};
use organza_core::error::{Result, invalid};
use organza_core::input::parse_json;
use organza_core::scene::{Placement, along_a_curve};

/// The file of a SOG file that describes the others.
const META: &str = "meta.json";
/// Values that a code book has.
const CODES: usize = 256;
/// Harmonics but the first, and their numbers.
const OTHERS: usize = HARMONICS - 1;
const REST: usize = 3 * OTHERS;
/// Sets of harmonics in a row of their image.
const ROW: usize = 64;
/// The image of a palette has at most this number of rows of [`ROW`], as a label has 16 bits.
const MAX_ROWS: usize = 1024;
/// Largest side of a WebP image, in pixels.
const MAX_SIDE: usize = 16_383;
/// Value of a quaternion's pixel that says that its first part is the largest.
const LARGEST: u8 = 252;

/// The archive while it is written.
struct Archive<W: Write + Seek>(ZipWriter<W>);

impl<W: Write + Seek> Archive<W> {
    fn add(&mut self, name: &str, bytes: &[u8]) -> io::Result<()> {
        // the images are compressed already
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        self.0.start_file(name, stored)?;
        self.0.write_all(bytes)
    }

    /// Writes an image of `N` bytes a pixel. Pixels that are missing at its end are zeros.
    fn image<const N: usize>(
        &mut self,
        name: &str,
        mut pixels: Vec<[u8; N]>,
        [width, height]: [usize; 2],
    ) -> io::Result<()> {
        pixels.resize(width * height, [0; N]);
        let color = if N == 4 { ColorType::Rgba8 } else { ColorType::Rgb8 };
        let mut bytes = Vec::new();
        WebPEncoder::new(&mut bytes)
            .encode(pixels.as_flattened(), width as u32, height as u32, color)
            .map_err(io::Error::other)?;
        self.add(name, &bytes)
    }
}

/// Splats along a curve: images compress neighbors together.
fn ordered(splats: &[Splat]) -> Vec<Splat> {
    let positions: Vec<_> = splats.iter().map(|splat| splat.position).collect();
    along_a_curve(&positions).into_iter().map(|index| splats[index]).collect()
}

pub fn write(splats: &[Splat], placement: &Placement, file: &mut dyn Write) -> io::Result<()> {
    // the archive's index has places of files, so it is put together first
    let mut archive = Archive(ZipWriter::new(Cursor::new(Vec::new())));
    let splats = ordered(splats);
    let side = (splats.len() as f64).sqrt().ceil() as usize;
    let width = side.next_multiple_of(4);
    let size = [width, splats.len().div_ceil(width).next_multiple_of(4)];
    if width > MAX_SIDE {
        return Err(io::Error::other("a SOG file has at most 268 million Gaussians; write a .ply"));
    }
    let means = means(&splats, size, &mut archive)?;
    let quats = splats.iter().map(|splat| {
        let (largest, parts) = smallest_three(turned(splat));
        let [a, b, c] = parts.map(|part| byte(255.0 * (part / SQRT_2 + 0.5)));
        [a, b, c, LARGEST + largest as u8]
    });
    archive.image("quats.webp", quats.collect(), size)?;
    let (scale_codes, scales) = codes(splats.iter().map(|splat| splat.log_scale));
    archive.image("scales.webp", scales, size)?;
    let (color_codes, colors) = codes(splats.iter().map(|splat| splat.color[0]));
    let colors = colors
        .iter()
        .zip(&splats)
        .map(|(&[r, g, b], splat)| [r, g, b, byte(255.0 * sigmoid(splat.opacity))]);
    archive.image("sh0.webp", colors.collect(), size)?;
    let harmonics = harmonics(&splats, size, &mut archive)?;
    let meta = json!({
        "version": 2,
        "asset": {"generator": concat!("organza ", env!("CARGO_PKG_VERSION")), PLACEMENT: placement},
        "count": splats.len(),
        "means": means,
        "scales": {"codebook": scale_codes, "files": ["scales.webp"]},
        "quats": {"files": ["quats.webp"]},
        "sh0": {"codebook": color_codes, "files": ["sh0.webp"]},
        "shN": harmonics,
    });
    archive.add(META, &serde_json::to_vec(&meta)?)?;
    file.write_all(&archive.0.finish()?.into_inner())
}

/// Positions: 16 bits over the range of `sign(x) ln(1 + abs(x))`.
fn means<W: Write + Seek>(
    splats: &[Splat],
    size: [usize; 2],
    archive: &mut Archive<W>,
) -> io::Result<Value> {
    let log = |value: f32| value.abs().ln_1p().copysign(value);
    let logs: Vec<_> = splats.iter().map(|splat| splat.position.map(log)).collect();
    let ranges = [0, 1, 2].map(|axis| ends(logs.iter().map(|log| log[axis])));
    let levels =
        |log: &[f32; 3]| [0, 1, 2].map(|axis| level(log[axis], ranges[axis], 65_535).to_le_bytes());
    let levels: Vec<_> = logs.iter().map(levels).collect();
    for (part, name) in ["means_l.webp", "means_u.webp"].into_iter().enumerate() {
        archive.image(
            name,
            levels.iter().map(|axes| axes.map(|bytes| bytes[part])).collect(),
            size,
        )?;
    }
    Ok(json!({"mins": ranges.map(|[low, _]| low), "maxs": ranges.map(|[_, high]| high),
        "files": ["means_l.webp", "means_u.webp"]}))
}

/// A code book for values, in ascending order, and the code of each.
fn codes<const N: usize>(values: impl Iterator<Item = [f32; N]>) -> (Vec<f32>, Vec<[u8; N]>) {
    let values: Vec<_> = values.flatten().map(|value| [value]).collect();
    let Clusters { centers, labels } = clusters(&values, CODES);
    let mut book: Vec<f32> = centers.into_iter().flatten().collect();
    book.resize(CODES, book.last().copied().unwrap_or_default());
    let labels: Vec<u8> = labels.into_iter().map(|label| label as u8).collect();
    (book, labels.as_chunks().0.to_vec())
}

/// All harmonics but the first: each Gaussian has the number of a set of a palette.
fn harmonics<W: Write + Seek>(
    splats: &[Splat],
    size: [usize; 2],
    archive: &mut Archive<W>,
) -> io::Result<Value> {
    let rest = |splat: &Splat| -> [f32; REST] {
        std::array::from_fn(|at| splat.color[1 + at / 3][at % 3])
    };
    let values: Vec<_> = splats.iter().map(rest).collect();
    let Clusters { centers, labels } = clusters(&values, ROW * rows(splats.len()));
    let (book, codes) = codes(centers.iter().copied());
    let pixels = codes.as_flattened().as_chunks::<3>().0.to_vec();
    archive.image("shN_centroids.webp", pixels, [ROW * OTHERS, centers.len().div_ceil(ROW)])?;
    let labels = labels.iter().map(|label| {
        let [low, high, ..] = label.to_le_bytes();
        [low, high, 0]
    });
    archive.image("shN_labels.webp", labels.collect(), size)?;
    Ok(json!({"count": centers.len(), "bands": DEGREE, "codebook": book,
        "files": ["shN_centroids.webp", "shN_labels.webp"]}))
}

/// Rows of the palette's image for a number of Gaussians: between a half and one set for each, as PlayCanvas has them.
fn rows(count: usize) -> usize {
    (1 << (count / ROW).max(1).ilog2()).min(MAX_ROWS)
}

/// Most pixels of an image for each byte of the whole archive: a few bytes can claim any number of equal pixels.
const MAX_PIXELS: usize = 1024;

/// A level as it is read: a pixel of an image.
type Pixel = [u8; 4];

/// A file that is read.
struct File<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    /// The folder in the archive that has all files: empty, or ending in `/`, or in `\` as some on Windows.
    folder: String,
    meta: Value,
    /// Number of Gaussians.
    count: usize,
    /// Bytes of the archive.
    length: usize,
    path: &'a Path,
}

/// Reads an archive.
pub fn read(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    let archive = ZipArchive::new(Cursor::new(bytes));
    let archive = archive.or_else(|error| damaged(path, error))?;
    // some programs pack the folder, not what is in it
    let folders = archive.file_names().filter_map(|name| name.strip_suffix(META));
    let is_folder = |name: &&str| name.is_empty() || name.ends_with(['/', '\\']);
    let folder = folders.filter(is_folder).min_by_key(|name| name.len());
    let Some(folder) = folder.map(str::to_owned) else {
        let reason = format!(
            "it is a ZIP archive without {META}, so it is no SOG file; unpack it, and name a file in it"
        );
        return invalid(path, reason);
    };
    let length = bytes.len();
    let mut file = File { archive, folder, meta: Value::Null, count: 0, length, path };
    file.meta = parse_json(&file.bytes(META)?, path)?;
    file.splats()
}

fn damaged<T>(path: &Path, reason: impl std::fmt::Display) -> Result<T> {
    invalid(path, format!("not a whole SOG file: {reason}; copy it again, or write it again"))
}

impl File<'_> {
    /// A file of the archive, unpacked.
    fn bytes(&mut self, name: &str) -> Result<Vec<u8>> {
        let path = self.path;
        let file = self.archive.by_name(&format!("{}{name}", self.folder));
        let mut file = file.or_else(|error| damaged(path, format!("{name}: {error}")))?;
        let size = file.size();
        memory::check(size, "a file of a SOG archive")?;
        // memory grows with the data, not with the size that the archive gives
        let mut bytes = Vec::new();
        let read = file.by_ref().take(size).read_to_end(&mut bytes);
        read.or_else(|error| damaged(path, format!("{name}: {error}")))?;
        Ok(bytes)
    }

    fn number(&self, at: &str) -> Result<f64> {
        let number = self.meta.pointer(at).and_then(Value::as_f64);
        number.map_or_else(|| damaged(self.path, format!("{META} has no number {at}")), Ok)
    }

    /// The image that is named at a place of the description: its pixels, of which there are `min`, and its width.
    fn image(&mut self, at: &str, min: usize) -> Result<(Vec<Pixel>, usize)> {
        let path = self.path;
        let Some(name) = self.meta.pointer(at).and_then(Value::as_str).map(str::to_owned) else {
            return damaged(path, format!("{META} names no file {at}"));
        };
        let broken = |error: DecodingError| format!("{name}: {error}");
        let decoder = WebPDecoder::new(Cursor::new(self.bytes(&name)?));
        let mut decoder = decoder.or_else(|error| damaged(path, broken(error)))?;
        let [width, height] = <[u32; 2]>::from(decoder.dimensions()).map(|side| side as usize);
        let max = MAX_PIXELS * self.length.max(64);
        if !(min..=max).contains(&(width * height)) {
            let reason = format!(
                "{name} has {width} x {height} pixels, expected {min} at least, and {max} at most in an archive of its \
                 size"
            );
            return damaged(path, reason);
        }
        let has_alpha = decoder.has_alpha();
        let size = width * height * if has_alpha { 4 } else { 3 };
        let mut pixels: Vec<u8> = memory::zeros(size, "an image of a SOG file")?;
        decoder.read_image(&mut pixels).or_else(|error| damaged(path, broken(error)))?;
        let pixels = match has_alpha {
            true => pixels.as_chunks().0.to_vec(),
            false => pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect(),
        };
        Ok((pixels, width))
    }

    /// The values of a code book. Older programs of PlayCanvas wrote null for the first.
    fn book(&self, of: &str) -> Result<[f32; CODES]> {
        let mut book = self.meta[of]["codebook"].as_array().cloned().unwrap_or_default();
        if let [first @ Value::Null, Value::Number(second), .., Value::Number(last)] = &mut book[..]
        {
            let [second, last] = [second, last].map(|value| value.as_f64().unwrap_or_default());
            *first = json!(second + (second - last) / 255.0);
        }
        let book: Option<Vec<f32>> =
            book.iter().map(|value| value.as_f64().map(|value| value as f32)).collect();
        let book = book.unwrap_or_default().try_into();
        book.or_else(|_| damaged(self.path, format!("`{of}` has no code book of {CODES} numbers")))
    }

    fn splats(&mut self) -> Result<SplatFile> {
        if self.meta["version"] != 2 {
            let reason = format!(
                "it is a SOG file of version {}; expected version 2: write it again with SuperSplat or splat-transform",
                self.meta.get("version").unwrap_or(&json!(1))
            );
            return invalid(self.path, reason);
        }
        self.count = self.number("/count")? as usize;
        let count = self.count;
        let positions = self.positions()?;
        let (rotations, _) = self.image("/quats/files/0", count)?;
        let (scales, _) = self.image("/scales/files/0", count)?;
        let (colors, _) = self.image("/sh0/files/0", count)?;
        let scale_book = self.book("scales")?;
        let color_book = self.book("sh0")?;
        let mut splats: Vec<Splat> = memory::zeros(count, "the Gaussians of a SOG file")?;
        for (at, splat) in splats.iter_mut().enumerate() {
            let three = |[r, g, b, _]: Pixel, book: &[f32; CODES]| {
                [r, g, b].map(|code| book[usize::from(code)])
            };
            let [a, b, c, largest] = rotations[at];
            let parts = [a, b, c].map(|part| (f32::from(part) / 255.0 - 0.5) * SQRT_2);
            splat.position = positions[at];
            splat.rotation = match largest.checked_sub(LARGEST) {
                Some(largest) => with_largest(usize::from(largest), parts),
                None => [1.0, 0.0, 0.0, 0.0],
            };
            splat.log_scale = three(scales[at], &scale_book);
            splat.opacity = logit_of(colors[at][3]);
            splat.color[0] = three(colors[at], &color_book);
        }
        if self.meta.get("shN").is_some_and(|rest| !rest.is_null()) {
            self.add_harmonics(&mut splats)?;
        }
        let stored = stored_placement(&self.meta["asset"], self.path)?;
        let is_antialiased = self.meta["model"] == "antialiased" || self.meta["antialias"] == true;
        let file = SplatFile { is_antialiased, ..SplatFile::new(self.path, "SOG 2", splats) };
        Ok(file.placed(stored))
    }

    /// Positions: 16 bits in two images over the range of `sign(x) ln(1 + abs(x))`.
    fn positions(&mut self) -> Result<Vec<[f32; 3]>> {
        let (low, _) = self.image("/means/files/0", self.count)?;
        let (high, _) = self.image("/means/files/1", self.count)?;
        let mut ends = [[0.0; 2]; 3];
        for (axis, ends) in ends.iter_mut().enumerate() {
            let end = |name| self.number(&format!("/means/{name}/{axis}"));
            *ends = [end("mins")?, end("maxs")?];
        }
        let position = |(low, high): (&Pixel, &Pixel)| {
            [0, 1, 2].map(|axis| {
                let level = f64::from(u16::from_le_bytes([low[axis], high[axis]])) / 65_535.0;
                let log = ends[axis][0] + (ends[axis][1] - ends[axis][0]) * level;
                (log.signum() * log.abs().exp_m1()) as f32
            })
        };
        Ok(low.iter().zip(&high).take(self.count).map(position).collect())
    }

    /// All harmonics but the first. A palette has a row of [`ROW`] sets of them.
    fn add_harmonics(&mut self, splats: &mut [Splat]) -> Result<()> {
        let sets = self.number("/shN/count")? as usize;
        let book = self.book("shN")?;
        // some programs write no number of bands, or 0, so the image's width decides
        let (palette, width) = self.image("/shN/files/0", 1)?;
        let others = width / ROW;
        if ![3, 8, 15].contains(&others) || width % ROW > 0 {
            let reason = format!(
                "the palette of its harmonics is {width} pixels wide, expected {ROW} times 3, 8 or 15"
            );
            return damaged(self.path, reason);
        }
        let (labels, _) = self.image("/shN/files/1", splats.len())?;
        for (splat, label) in splats.iter_mut().zip(labels) {
            let set = usize::from(u16::from_le_bytes([label[0], label[1]]));
            let first = set / ROW * width + set % ROW * others;
            let Some(codes) = palette.get(first..first + others).filter(|_| set < sets) else {
                let reason = format!("a Gaussian has set {set} of its harmonics, of {sets}");
                return damaged(self.path, reason);
            };
            for (harmonic, code) in splat.color[1..].iter_mut().zip(codes) {
                *harmonic = [0, 1, 2].map(|channel| book[usize::from(code[channel])]);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_close, assert_refused, read_bytes, splats};
    use super::*;

    /// The files of an archive.
    fn files(bytes: Vec<u8>) -> impl FnMut(&str) -> Vec<u8> {
        let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
        move |name| {
            let mut bytes = Vec::new();
            archive.by_name(name).unwrap().read_to_end(&mut bytes).unwrap();
            bytes
        }
    }

    /// The pixels of an image, and its width.
    fn pixels(bytes: &[u8]) -> (Vec<[u8; 4]>, usize) {
        let mut decoder = WebPDecoder::new(Cursor::new(bytes)).unwrap();
        assert!(!decoder.is_lossy());
        let width = decoder.dimensions().0 as usize;
        let mut pixels = vec![0; decoder.output_buffer_size().unwrap()];
        decoder.read_image(&mut pixels).unwrap();
        let size = if decoder.has_alpha() { 4 } else { 3 };
        let pixel = |pixel: &[u8]| [pixel[0], pixel[1], pixel[2], *pixel.get(3).unwrap_or(&255)];
        (pixels.chunks(size).map(pixel).collect(), width)
    }

    /// Reads as PlayCanvas' description says.
    fn described(bytes: Vec<u8>) -> Vec<Splat> {
        let mut file = files(bytes);
        let meta: Value = serde_json::from_slice(&file("meta.json")).unwrap();
        assert_eq!(meta["version"], 2);
        let number = |value: &Value| value.as_f64().unwrap();
        let book = |value: &Value| {
            value["codebook"].as_array().unwrap().iter().map(number).collect::<Vec<_>>()
        };
        let [scales, colors, rest] = ["scales", "sh0", "shN"].map(|name| book(&meta[name]));
        assert!([&scales, &colors, &rest].iter().all(|book| book.len() == 256));
        let mut image =
            |path: &str| pixels(&file(meta.pointer(path).and_then(Value::as_str).unwrap()));
        let (low, _) = image("/means/files/0");
        let (high, _) = image("/means/files/1");
        let (quats, _) = image("/quats/files/0");
        let (scale, _) = image("/scales/files/0");
        let (color, _) = image("/sh0/files/0");
        let (sets, width) = image("/shN/files/0");
        let (labels, _) = image("/shN/files/1");
        assert_eq!(width, 64 * 15);
        let splat = |at: usize| {
            let position = [0, 1, 2].map(|axis| {
                let ends = ["mins", "maxs"].map(|end| number(&meta["means"][end][axis]));
                let level =
                    f64::from(u16::from_le_bytes([low[at][axis], high[at][axis]])) / 65_535.0;
                let log = ends[0] + (ends[1] - ends[0]) * level;
                (log.signum() * (log.abs().exp() - 1.0)) as f32
            });
            let [a, b, c, largest] = quats[at];
            let parts = [a, b, c].map(|part| (f32::from(part) / 255.0 - 0.5) * 2.0 / 2_f32.sqrt());
            let set = usize::from(u16::from_le_bytes([labels[at][0], labels[at][1]]));
            assert!(set < meta["shN"]["count"].as_u64().unwrap() as usize);
            let first = set / 64 * width + set % 64 * 15;
            let three = |pixel: [u8; 4], book: &[f64]| {
                [0, 1, 2].map(|channel| book[usize::from(pixel[channel])] as f32)
            };
            Splat {
                position,
                rotation: with_largest(usize::from(largest - 252), parts),
                log_scale: three(scale[at], &scales),
                opacity: logit_of(color[at][3]),
                color: std::array::from_fn(|harmonic| match harmonic {
                    0 => three(color[at], &colors),
                    _ => three(sets[first + harmonic - 1], &rest),
                }),
            }
        };
        (0..meta["count"].as_u64().unwrap() as usize).map(splat).collect()
    }

    /// Few values are exact in the code books, and few Gaussians have a set of harmonics each.
    #[test]
    fn written_files_follow_the_description() {
        let splats = splats();
        let mut bytes = Vec::new();
        write(&splats, &Placement::default(), &mut bytes).unwrap();
        let expected = ordered(&splats);
        // 16 bits of the logarithms between -1.1 and 1.1, and parts of quaternions in steps of sqrt(2) / 255
        let max = [3.0 * 0.5 * 2.2 / 65_535.0, 1e-6, 1e-6, 0.01, 3.0 * 0.71 / 255.0];
        assert_close(&described(bytes.clone()), &expected, max);
        assert_close(&read_bytes(&bytes).unwrap(), &expected, max);
        for length in (4..bytes.len()).step_by(97) {
            assert_refused(&bytes[..length], &["not a whole SOG file"]);
        }
    }

    /// An archive with another description, and deflated, as other programs write it.
    fn with(edit: impl FnOnce(&mut Value)) -> Vec<u8> {
        within("", edit)
    }

    /// [`with`] in a folder of the archive.
    fn within(folder: &str, edit: impl FnOnce(&mut Value)) -> Vec<u8> {
        let mut bytes = Vec::new();
        write(&splats(), &Placement::default(), &mut bytes).unwrap();
        let mut file = files(bytes.clone());
        let names = ZipArchive::new(Cursor::new(bytes)).unwrap();
        let mut meta: Value = serde_json::from_slice(&file(META)).unwrap();
        edit(&mut meta);
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        let deflated = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        for name in names.file_names() {
            archive.start_file(format!("{folder}{name}"), deflated).unwrap();
            let content =
                if name == META { serde_json::to_vec(&meta).unwrap() } else { file(name) };
            archive.write_all(&content).unwrap();
        }
        archive.finish().unwrap().into_inner()
    }

    #[test]
    fn files_of_others_are_read_or_refused_with_a_reason() {
        let all = read_bytes(&with(|_| ())).unwrap();
        let one_color = read_bytes(&with(|meta| drop(meta.as_object_mut().unwrap().remove("shN"))));
        for (all, one_color) in all.iter().zip(one_color.unwrap()) {
            assert_eq!(Splat { color: one_color.color, ..*all }, one_color);
            assert_eq!(all.color[0], one_color.color[0]);
            assert_eq!(one_color.color[1..], [[0.0; 3]; OTHERS]);
        }
        for folder in ["scene/", "scene\\"] {
            assert_eq!(read_bytes(&within(folder, |_| ())).unwrap(), all);
        }
        // the first value goes on as the others do
        let without = with(|meta| meta["scales"]["codebook"][0] = Value::Null);
        for (all, found) in all.iter().zip(read_bytes(&without).unwrap()) {
            let pairs = all.log_scale.iter().zip(found.log_scale);
            let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(apart < 0.2, "{apart}");
        }
        assert_refused(&with(|meta| meta["version"] = json!(3)), &["version 3"]);
        assert_refused(&with(|meta| drop(meta["version"].take())), &["version null"]);
        assert_refused(&with(|meta| meta["count"] = json!(1e12)), &["pixels", "at least"]);
        assert_refused(&with(|meta| meta["shN"]["count"] = json!(1)), &["set", "of 1"]);
        // the labels' image is no palette
        let labels = |meta: &mut Value| meta["shN"]["files"][0] = meta["shN"]["files"][1].clone();
        assert_refused(&with(labels), &["pixels wide", "64 times"]);
        assert_eq!(read_bytes(&with(|meta| meta["shN"]["bands"] = json!(0))).unwrap(), all);
        assert_refused(&with(|meta| meta["sh0"]["codebook"] = json!([1])), &["`sh0`", "code book"]);
        assert_refused(&with(|meta| meta["means"]["mins"] = json!(0)), &["/means/mins/0"]);
        assert_refused(&with(|meta| meta["quats"]["files"] = json!(["x.webp"])), &["x.webp"]);
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        archive.start_file("scene.ply", SimpleFileOptions::default()).unwrap();
        assert_refused(&archive.finish().unwrap().into_inner(), &["ZIP archive", "unpack"]);
        assert_refused(br#"{"version": 2, "means": {}}"#, &["unpacked .sog", "pack"]);
        assert_refused(br#"{"asset": {"version": "2.0"}, "nodes": []}"#, &[".gltf", ".glb"]);
    }
}
