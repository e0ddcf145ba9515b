//! Reads `cameras.bin`, `images.bin` and `points3D.bin`: little endian, a count followed by as many records.

use std::io::{BufRead, BufReader, Read, Seek};
use std::path::Path;

use super::model::Lenses;
use super::{Cameras, Image, Points, Support, add};
use crate::Point;
use organza_core::error::{Error, Result, invalid};

/// Bytes of an image's observation: two coordinates and a point's id.
const OBSERVATION: u64 = 24;
/// Bytes of an entry in a point's track: an image's id and an index.
const TRACK_ENTRY: u64 = 8;

/// Reads `cameras.bin`.
pub(super) fn cameras(source: impl Read + Seek, length: u64, path: &Path) -> Result<Cameras> {
    let mut records = Records::open(source, length, path, "camera", 24)?;
    let mut cameras = Cameras::new();
    while records.next() {
        let id = records.u32()?;
        let known = Lenses::from_id(records.u32()?.cast_signed());
        let lenses = known.or_else(|reason| invalid(path, format!("camera {id}: {reason}")))?;
        let size = [records.u64()?, records.u64()?];
        let values = (0..lenses.parameters()).map(|_| records.f64()).collect::<Result<Vec<_>>>()?;
        let intrinsics = lenses.intrinsics(size, &values);
        let intrinsics =
            intrinsics.or_else(|reason| invalid(path, format!("camera {id}: {reason}")))?;
        add(&mut cameras, id, intrinsics, path)?;
    }
    records.finish()?;
    Ok(cameras)
}

/// Reads `images.bin`.
pub(super) fn images(source: impl Read + Seek, length: u64, path: &Path) -> Result<Vec<Image>> {
    let mut records = Records::open(source, length, path, "image", 73)?;
    let mut images = Vec::new();
    while records.next() {
        let _id = records.u32()?;
        let rotation = [records.f64()?, records.f64()?, records.f64()?, records.f64()?];
        let translation = [records.f64()?, records.f64()?, records.f64()?];
        let camera = records.u32()?;
        let name = records.name()?;
        let observations = records.u64()?;
        records.skip(observations, OBSERVATION)?;
        images.push(Image { rotation, translation, camera, name });
    }
    records.finish()?;
    Ok(images)
}

/// Reads `points3D.bin`.
pub(super) fn points(source: impl Read + Seek, length: u64, path: &Path) -> Result<Points> {
    let mut records = Records::open(source, length, path, "point", 51)?;
    let mut points = Points::new();
    while records.next() {
        let id = records.u64()?;
        let position = [records.f64()?, records.f64()?, records.f64()?];
        let color = Some(records.take::<3>()?);
        let support = Support { error: records.f64()?, images: records.u64()? };
        records.skip(support.images, TRACK_ENTRY)?;
        points.push((id, Point { position, color }, support));
    }
    records.finish()?;
    Ok(points)
}

/// A file of records. A count in it is never trusted beyond the file's length.
struct Records<'a, R> {
    reader: BufReader<R>,
    path: &'a Path,
    what: &'static str,
    /// Bytes not read yet.
    remaining: u64,
    count: u64,
    /// Number of the current record, from 1.
    current: u64,
}

impl<'a, R: Read + Seek> Records<'a, R> {
    /// Opens a file of `length` bytes. Each record has at least `smallest` bytes.
    fn open(
        source: R,
        length: u64,
        path: &'a Path,
        what: &'static str,
        smallest: u64,
    ) -> Result<Self> {
        let reader = BufReader::new(source);
        let mut records = Self { reader, path, what, remaining: length, count: 0, current: 0 };
        records.count = records.u64()?;
        let count = records.count;
        let remaining = records.remaining;
        if count.checked_mul(smallest).is_none_or(|bytes| bytes > remaining) {
            let reason = format!(
                "the file has room for fewer than the {count} {what}s it says it holds; it was cut \
                 short or is no COLMAP model: copy it again"
            );
            return invalid(path, reason);
        }
        Ok(records)
    }

    /// Moves to the next record, if there is one.
    fn next(&mut self) -> bool {
        self.current += 1;
        self.current <= self.count
    }

    fn cut_short<T>(&self) -> Result<T> {
        let Self { what, current, count, .. } = self;
        let place = match current {
            0 => "before its first number".to_owned(),
            _ => format!("inside {what} {current} of {count}"),
        };
        let reason = format!("the file ends {place}; it was cut short: copy it again");
        invalid(self.path, reason)
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let Some(remaining) = self.remaining.checked_sub(N as u64) else {
            return self.cut_short();
        };
        self.remaining = remaining;
        let mut bytes = [0; N];
        self.reader.read_exact(&mut bytes).map_err(|source| Error::read(self.path, source))?;
        Ok(bytes)
    }

    fn u32(&mut self) -> Result<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64> {
        self.take().map(u64::from_le_bytes)
    }

    fn f64(&mut self) -> Result<f64> {
        self.take().map(f64::from_le_bytes)
    }

    /// Reads text up to a zero byte.
    fn name(&mut self) -> Result<String> {
        let mut bytes = Vec::new();
        let mut limited = self.reader.by_ref().take(self.remaining);
        let read = limited.read_until(0, &mut bytes);
        self.remaining -= read.map_err(|source| Error::read(self.path, source))? as u64;
        if bytes.pop() != Some(0) {
            return self.cut_short();
        }
        String::from_utf8(bytes).or_else(|_| {
            let what = self.what;
            let current = self.current;
            invalid(self.path, format!("the name of {what} {current} is not UTF-8; rename it"))
        })
    }

    fn skip(&mut self, count: u64, size: u64) -> Result<()> {
        let bytes = count.checked_mul(size);
        let left = bytes.and_then(|bytes| self.remaining.checked_sub(bytes));
        let (Some(bytes), Some(left)) = (bytes, left) else { return self.cut_short() };
        self.remaining = left;
        // This cannot overflow: the skipped bytes are fewer than the remaining ones.
        let skipped = self.reader.seek_relative(bytes.cast_signed());
        skipped.map_err(|source| Error::read(self.path, source))
    }

    fn finish(self) -> Result<()> {
        let Self { path, what, count, remaining, .. } = self;
        if remaining == 0 {
            return Ok(());
        }
        let reason = format!(
            "{remaining} bytes follow the last of {count} {what}s; is it a COLMAP model that this \
             program knows?"
        );
        invalid(path, reason)
    }
}
