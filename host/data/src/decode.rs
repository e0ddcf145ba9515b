//! Decodes photographs, PNG and JPEG, within the free memory. Incomplete files are refused.

use std::io::{BufRead, BufReader, Cursor, Seek};
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::error::{ImageFormatHint, UnsupportedError, UnsupportedErrorKind};
use image::metadata::Orientation;
use image::{
    ColorType, DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError,
    ImageFormat, ImageReader, ImageResult, Limits,
};

use organza_core::error::{DeviceError, Error, Result, invalid, refuse};
use organza_core::input::{open_regular, read_file};
use organza_core::memory;

/// What a file is, for messages.
pub(super) const PHOTOGRAPH: &str = "photograph";
pub(super) const MASK: &str = "mask";
/// Bytes per pixel that decoding may take: 8 for the widest pixel (RGBA of 16 bits), or else 3 and the 16-bit
/// coefficients of a progressive JPEG's four components.
const BYTES_A_PIXEL: u64 = 3 + 4 * 2;
/// Bytes of rows, tables and a color profile, besides the pixels.
const BYTES_BESIDE: u64 = 1 << 20;
/// Most copies that a decoder may hold of a file's other content, such as text.
const COPIES: u64 = 3;
/// Most bytes that one byte of a PNG's compressed data can become.
const DEFLATE_RATIO: u64 = 1032;
/// Part of the free memory that decoding may take. Threads and the allocator need some, too.
const PART: f64 = 0.75;
/// Shortest side that may be a pixel off its camera's.
const MIN_NEAR: u32 = 32;
/// Quality of JPEG photographs that are turned, out of 100.
const QUALITY: u8 = 98;

/// A decoded photograph, in the format of its file.
pub(super) struct Decoded {
    width: u32,
    height: u32,
    color: ColorType,
    pixel_bytes: usize,
    /// Pixels row by row, with interleaved channels.
    bytes: Vec<u8>,
}

/// Width and height of a photograph in pixels, from its header.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::Invalid`] if it is neither JPEG nor PNG.
pub fn size(path: &Path) -> Result<[u32; 2]> {
    let (file, length) = open_regular(path)?;
    // The JPEG decoder reads the whole file.
    memory::check(length, "a photograph's file")?;
    size_from(BufReader::new(file), length, path)
}

/// [`size`] from a photograph's file of `length` bytes.
pub(super) fn size_from(source: impl BufRead + Seek, length: u64, path: &Path) -> Result<[u32; 2]> {
    let reader = reader(source, length, path)?;
    let (width, height) = reader.into_dimensions().map_err(|error| broken(path, &error))?;
    Ok([width, height])
}

/// Bytes of the free memory that decoding may take, beside `kept` bytes of results.
pub(super) fn budget(kept: u64) -> u64 {
    let free = memory::available().map(|bytes| bytes.saturating_sub(kept));
    free.map_or(u64::MAX, |bytes| (bytes as f64 * PART) as u64)
}

/// How many photographs like this one, which should have `expected` pixels, may be decoded at once with their masks:
/// at least one.
///
/// # Errors
/// [`Error::ReadFile`]; [`DeviceError::OutOfMemory`] if one alone takes more than the budget.
pub(super) fn at_once(
    path: &Path,
    mask: Option<&Path>,
    expected: [u32; 2],
    budget: u64,
) -> Result<u64> {
    let mut needed = bytes_to_decode(open_regular(path)?.1, expected);
    if let Some(mask) = mask {
        needed = needed.saturating_add(bytes_to_decode(open_regular(mask)?.1, expected));
    }
    if needed > budget {
        let [width, height] = expected;
        let what = format!(
            "decoding {} ({width} x {height} pixels; smaller ones in `images_4` are read with `--downscale 4`)",
            path.display()
        );
        return Err(DeviceError::OutOfMemory { needed, available: Some(budget), what }.into());
    }
    Ok(budget / needed)
}

/// Checks a photograph, as reading a data set does. If the file says that the camera was held on its side, returns a file
/// with turned pixels. The camera's other data, such as the focal length, stay.
///
/// # Errors
/// The same errors as [`Dataset::load`](super::Dataset::load) for a photograph.
pub fn upright(path: &Path) -> Result<Option<Vec<u8>>> {
    let size = size(path)?;
    at_once(path, None, size, budget(0))?;
    let bytes = read_file(path, u64::MAX, "a photograph")?;
    decode(&bytes, size, path, PHOTOGRAPH)?;
    turned(&bytes).map_err(|error| broken(path, &error))
}

/// A JPEG file of `[width, height]` pixels: red, green and blue, row by row. `quality` is out of 100.
///
/// # Errors
/// [`Error::Invalid`] if a side is 0, or too large for a JPEG.
pub fn encode_jpeg([width, height]: [u32; 2], pixels: &[u8], quality: u8) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let encoder = JpegEncoder::new_with_quality(&mut bytes, quality);
    match encoder.write_image(pixels, width, height, ExtendedColorType::Rgb8) {
        Ok(()) => Ok(bytes),
        Err(error) => refuse(format!("the image cannot be encoded: {error}")),
    }
}

/// A photograph's file with turned pixels; `None` if it is upright.
fn turned(bytes: &[u8]) -> ImageResult<Option<Vec<u8>>> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format()?;
    let is_jpeg = reader.format() == Some(ImageFormat::Jpeg);
    let mut decoder = reader.into_decoder()?;
    let orientation = decoder.orientation()?;
    if orientation == Orientation::NoTransforms {
        return Ok(None);
    }
    let mut exif = decoder.exif_metadata()?.unwrap_or_default();
    let _ = Orientation::remove_from_exif_chunk(&mut exif);
    let mut image = DynamicImage::from_decoder(decoder)?;
    image.apply_orientation(orientation);
    let mut file = Vec::new();
    if is_jpeg {
        let mut encoder = JpegEncoder::new_with_quality(&mut file, QUALITY);
        encoder.set_exif_metadata(exif).map_err(ImageError::Unsupported)?;
        image.write_with_encoder(encoder)?;
    } else {
        let mut encoder = PngEncoder::new(&mut file);
        encoder.set_exif_metadata(exif).map_err(ImageError::Unsupported)?;
        image.write_with_encoder(encoder)?;
    }
    Ok(Some(file))
}

/// Most bytes that decoding a file of `length` bytes takes.
pub(super) fn bytes_to_decode(length: u64, [width, height]: [u32; 2]) -> u64 {
    let pixels = BYTES_A_PIXEL * u64::from(width) * u64::from(height);
    length.saturating_add(bytes_beside(length)).saturating_add(pixels)
}

/// Most bytes that a decoder holds besides the file and the pixels.
fn bytes_beside(length: u64) -> u64 {
    length.saturating_mul(COPIES).saturating_add(BYTES_BESIDE)
}

/// A reader of a photograph's file of `length` bytes. It skips a color profile that exceeds its limit, which a
/// compressed one can do by a factor of 1032: nothing here needs it.
fn reader<R: BufRead + Seek>(source: R, length: u64, path: &Path) -> Result<ImageReader<R>> {
    let reader = ImageReader::new(source).with_guessed_format();
    let mut reader = reader.map_err(|source| Error::read(path, source))?;
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(bytes_beside(length));
    reader.limits(limits);
    Ok(reader)
}

/// Decodes a photograph or a mask, as `what` says, which should have `expected` pixels, width and height.
pub(super) fn decode(bytes: &[u8], expected: [u32; 2], path: &Path, what: &str) -> Result<Decoded> {
    let reader = reader(Cursor::new(bytes), bytes.len() as u64, path)?;
    let is_jpeg = reader.format() == Some(ImageFormat::Jpeg);
    let decoder = reader.into_decoder().map_err(|error| broken(path, &error))?;
    let (width, height) = decoder.dimensions();
    let size = [width, height];
    // some programs remove lens distortion, and round sides otherwise than in their cameras
    let is_near = |(side, of): (&u32, u32)| side.abs_diff(of) <= u32::from(of >= MIN_NEAR);
    if !size.iter().zip(expected).all(is_near) {
        return wrong_size(path, what, size, expected);
    }
    // The decoder silently fills missing parts of a JPEG with gray.
    let is_whole = !is_jpeg || has_jpeg_end(bytes);
    if !is_whole || (bytes.len() as u64) < fewest_bytes(is_jpeg, size) {
        return invalid(path, format!("the {what} was cut short; copy it again"));
    }
    if !is_jpeg && !has_whole_palette(bytes) {
        return invalid(path, format!("the {what}'s palette is damaged; copy it again"));
    }
    let color = decoder.color_type();
    if !is_read(color) {
        let hint = ImageFormatHint::Unknown;
        let kind = UnsupportedErrorKind::Color(color.into());
        let error = UnsupportedError::from_format_and_kind(hint, kind);
        return Err(broken(path, &ImageError::Unsupported(error)));
    }
    let length = usize::try_from(decoder.total_bytes()).unwrap_or(usize::MAX);
    let mut pixels = memory::zeros::<u8>(length, "a photograph")?;
    decoder.read_image(&mut pixels).map_err(|error| broken(path, &error))?;
    let pixel_bytes = usize::from(color.bytes_per_pixel());
    Ok(Decoded { width, height, color, pixel_bytes, bytes: pixels })
}

impl Decoded {
    /// Width and height, each of which may be a pixel off the expected one.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Whether the photograph has an alpha channel.
    pub fn has_alpha(&self) -> bool {
        self.color.has_alpha()
    }

    /// The colors of all pixels, row by row, if the file has 8 bits and no alpha, so that they need no conversion.
    pub fn colors(&self) -> Option<Vec<[u8; 3]>> {
        match self.color {
            ColorType::L8 => Some(self.bytes.iter().map(|&gray| [gray; 3]).collect()),
            ColorType::Rgb8 => Some(self.bytes.as_chunks().0.to_vec()),
            _ => None,
        }
    }

    /// Red, green, blue and alpha of all pixels, row by row.
    pub fn texels(&self) -> impl Iterator<Item = [f32; 4]> {
        (0..self.height).flat_map(move |y| (0..self.width).map(move |x| self.rgba(x, y)))
    }

    /// Red, green, blue and alpha of column `x` and row `y`, from 0 to 1.
    #[inline]
    pub fn rgba(&self, x: u32, y: u32) -> [f32; 4] {
        let first = (y as usize * self.width as usize + x as usize) * self.pixel_bytes;
        let bytes = &self.bytes[first..first + self.pixel_bytes];
        if self.color.bytes_per_pixel() == self.color.channel_count() {
            return rgba_of(bytes, |&byte| f32::from(byte) / 255.0);
        }
        let (wide, _) = bytes.as_chunks::<2>();
        rgba_of(wide, |&bytes| f32::from(u16::from_ne_bytes(bytes)) / 65535.0)
    }
}

/// The RGBA of a pixel with one to four channels: gray, gray and alpha, color, color and alpha.
#[inline]
fn rgba_of<T>(channels: &[T], value: impl Fn(&T) -> f32) -> [f32; 4] {
    match channels {
        [gray] => [value(gray), value(gray), value(gray), 1.0],
        [gray, alpha] => [value(gray), value(gray), value(gray), value(alpha)],
        [red, green, blue] => [value(red), value(green), value(blue), 1.0],
        [red, green, blue, alpha] => [value(red), value(green), value(blue), value(alpha)],
        _ => [0.0; 4],
    }
}

/// Whether this type of pixel is supported: 8 or 16 bits per channel.
fn is_read(color: ColorType) -> bool {
    use ColorType::{L8, L16, La8, La16, Rgb8, Rgb16, Rgba8, Rgba16};
    matches!(color, L8 | La8 | Rgb8 | Rgba8 | L16 | La16 | Rgb16 | Rgba16)
}

fn broken(path: &Path, error: &ImageError) -> Error {
    let reason = format!(
        "the photograph cannot be decoded ({error}); JPEG and PNG are read, and TIFF, AVIF and DNG are not: convert it, or copy \
         it again where it is damaged"
    );
    Error::Invalid { origin: path.to_owned(), reason }
}

fn wrong_size<T>(path: &Path, what: &str, found: [u32; 2], expected: [u32; 2]) -> Result<T> {
    let [width, height] = found;
    let [w, h] = expected;
    let [across, down] = [(width, w), (height, h)].map(|(a, b)| f64::from(a) / f64::from(b));
    // whether it is an n-th, rounded up or down
    let is_part = |n: &u32| {
        [(width, w), (height, h)].iter().all(|(a, b)| (b / n..=b.div_ceil(*n)).contains(a))
    };
    let hint = if what == MASK {
        "a mask has the size of its photograph".to_owned()
    } else if [height, width] == expected {
        "was it rotated?".to_owned()
    } else if let Some(n) = (2..=w.div_ceil(width.max(1))).find(is_part) {
        format!(
            "is it 1/{n} of the original? Move such photographs from `images` to `images_{n}`, and use `--downscale {n}`"
        )
    } else if (across - down).abs() < 0.01 * across {
        "was it resized? Take the original, or scale the camera's intrinsics; `downscale` makes \
         photographs smaller"
            .to_owned()
    } else {
        "is it the right photograph?".to_owned()
    };
    let reason =
        format!("the {what} is {width} x {height} pixels, but its camera {w} x {h}; {hint}");
    invalid(path, reason)
}

/// Least number of bytes in a file with this many pixels. In a JPEG, a block of 8 x 8 has at least one bit. In a PNG,
/// a pixel has at least one bit before compression.
fn fewest_bytes(is_jpeg: bool, [width, height]: [u32; 2]) -> u64 {
    let [width, height] = [width, height].map(u64::from);
    match is_jpeg {
        true => width.div_ceil(8) * height.div_ceil(8) / 8,
        false => width.div_ceil(8) * height / DEFLATE_RATIO,
    }
}

/// Whether a PNG's palette consists of whole colors, at most 256. On any other palette, the decoder panics.
fn has_whole_palette(bytes: &[u8]) -> bool {
    const SIGNATURE: usize = 8;
    // A chunk has a length, a name, data and a checksum.
    let mut rest = bytes.get(SIGNATURE..).unwrap_or_default();
    while let Some((&[a, b, c, d, ref name @ ..], after)) = rest.split_first_chunk::<8>() {
        let length = u32::from_be_bytes([a, b, c, d]) as usize;
        if name == b"PLTE" && (!length.is_multiple_of(3) || length > 256 * 3) {
            return false;
        }
        rest = after.get(length.saturating_add(4)..).unwrap_or_default();
    }
    true
}

/// Whether a JPEG has its own end-of-image marker. A thumbnail's marker does not count.
fn has_jpeg_end(bytes: &[u8]) -> bool {
    const END: u8 = 0xd9;
    let mut rest = bytes.get(2..).unwrap_or_default();
    while let Some(at) = rest.windows(2).position(is_marker) {
        if rest[at + 1] == END {
            return true;
        }
        let length = rest
            .get(at + 2..at + 4)
            .map_or(0, |pair| usize::from(pair[0]) << 8 | usize::from(pair[1]));
        // The length includes itself. Compressed data follows the header of a scan, and is searched for the next
        // marker.
        rest = rest.get(at + 2 + length..).unwrap_or_default();
    }
    false
}

/// Whether two bytes are a JPEG marker: 0xff and another byte. Exceptions are 0xff, which pads, 0, which escapes, and
/// bytes that occur in the middle of compressed data.
fn is_marker(pair: &[u8]) -> bool {
    pair[0] == 0xff && !matches!(pair[1], 0 | 1 | 0xd0..=0xd7 | 0xff)
}
