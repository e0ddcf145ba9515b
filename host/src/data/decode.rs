//! Photographs from their files: PNG and JPEG, whole or refused.

use std::io::{BufReader, Cursor, Read};
use std::path::Path;

use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader};

use super::invalid;
use crate::error::{Error, Result};
use crate::input::open_regular;
use organza_device::memory;

/// Width and height in pixels of a photograph, from its header.
pub(super) fn size(path: &Path) -> Result<[u32; 2]> {
    let reader = ImageReader::new(BufReader::new(open_regular(path)?.0));
    let reader = reader.with_guessed_format().map_err(|source| Error::read(path, source))?;
    let (width, height) = reader.into_dimensions().map_err(|error| broken(path, &error))?;
    Ok([width, height])
}

/// Reads a photograph that should have `expected` pixels, width and height.
pub(super) fn decode(path: &Path, expected: [u32; 2]) -> Result<DynamicImage> {
    let bytes = read(path)?;
    let reader = ImageReader::new(Cursor::new(&bytes));
    let reader = reader.with_guessed_format().map_err(|source| Error::read(path, source))?;
    let is_jpeg = reader.format() == Some(ImageFormat::Jpeg);
    let decoder = reader.into_decoder().map_err(|error| broken(path, &error))?;
    let (width, height) = decoder.dimensions();
    if [width, height] != expected {
        return wrong_size(path, [width, height], expected);
    }
    // The decoder fills what is missing of a JPEG with gray, and says nothing.
    if is_jpeg && !has_jpeg_end(&bytes) {
        return invalid(path, "the photograph was cut short; copy it again".to_owned());
    }
    DynamicImage::from_decoder(decoder).map_err(|error| broken(path, &error))
}

fn read(path: &Path) -> Result<Vec<u8>> {
    let (file, length) = open_regular(path)?;
    memory::check(length, "a photograph's file")?;
    let mut bytes = Vec::new();
    // No more than was checked, should the file grow.
    let read = file.take(length).read_to_end(&mut bytes);
    read.map_err(|source| Error::read(path, source))?;
    Ok(bytes)
}

fn broken(path: &Path, error: &ImageError) -> Error {
    let reason = format!(
        "the photograph cannot be decoded ({error}); JPEG and PNG are read: convert it, or copy it \
         again where it is damaged"
    );
    Error::Invalid { origin: path.to_owned(), reason }
}

fn wrong_size<T>(path: &Path, found: [u32; 2], expected: [u32; 2]) -> Result<T> {
    let ([width, height], [w, h]) = (found, expected);
    let [across, down] = [(width, w), (height, h)].map(|(a, b)| f64::from(a) / f64::from(b));
    let hint = if [height, width] == expected {
        "was it rotated?"
    } else if (across - down).abs() < 0.01 * across {
        "was it resized? Take the original, or scale the camera's intrinsics; `downscale` makes \
         photographs smaller"
    } else {
        "is it the right photograph?"
    };
    let reason =
        format!("the photograph is {width} x {height} pixels, but its camera {w} x {h}; {hint}");
    invalid(path, reason)
}

/// Whether a JPEG's own end-of-image marker is there. That of a thumbnail does not count.
fn has_jpeg_end(bytes: &[u8]) -> bool {
    const END: u8 = 0xd9;
    // Markers are 0xff and another byte. Not 0xff, which pads, not 0, which escapes, and not those
    // that stand in the middle of compressed data.
    let is_marker = |pair: &[u8]| pair[0] == 0xff && !matches!(pair[1], 0 | 1 | 0xd0..=0xd7 | 0xff);
    let mut rest = bytes.get(2..).unwrap_or_default();
    while let Some(at) = rest.windows(2).position(is_marker) {
        if rest[at + 1] == END {
            return true;
        }
        let length = rest
            .get(at + 2..at + 4)
            .map_or(0, |pair| usize::from(pair[0]) << 8 | usize::from(pair[1]));
        // The length counts itself. What is compressed follows the header of a scan, and is
        // searched for the next marker.
        rest = rest.get(at + 2 + length..).unwrap_or_default();
    }
    false
}
